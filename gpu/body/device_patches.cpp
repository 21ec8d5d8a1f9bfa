#include <ringwatch/gpu/body/device_patches.h>

#include <algorithm>
#include <array>
#include <numeric>

#include <ringwatch/base/error.h>
#include <ringwatch/base/parallel.h>

namespace ringwatch {
namespace {

constexpr int group = 32;

struct Centroid {
  std::array<float, 3> c;
  std::int32_t element;
};

/// Orders [first, last) so that every `size` in a row are a compact patch.
void bisect(Centroid* first, Centroid* last, std::ptrdiff_t size) {
  const std::ptrdiff_t count = last - first;
  if (count <= size) {
    std::sort(first, last, [](const Centroid& a, const Centroid& b) { return a.element < b.element; });
    return;
  }
  std::array<float, 3> low = first->c, high = first->c;
  for (const Centroid* p = first; p != last; ++p)
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p->c[k]);
      high[k] = std::max(high[k], p->c[k]);
    }
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (high[k] - low[k] > high[axis] - low[axis]) axis = k;
  // Left: half of the full patches. Ties are settled by the other coordinates: a cut through a layer of a regular mesh
  // stays compact.
  Centroid* middle = first + (count + size - 1) / size / 2 * size;
  std::nth_element(first, middle, last, [axis](const Centroid& a, const Centroid& b) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (axis + k) % 3;
      if (a.c[i] != b.c[i]) return a.c[i] < b.c[i];
    }
    return a.element < b.element;
  });
#pragma omp task if (count > 50000)
  bisect(first, middle, size);
  bisect(middle, last, size);
#pragma omp taskwait
}

std::vector<Centroid> orderedCentroids(const Mesh& mesh, const MeshBlock& block, int size) {
  const int n = block.nodesPerElement();
  std::vector<Centroid> centroids(block.elementCount());
  parallelFor(0, centroids.size(), 0, [&](std::int64_t e) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int a = 0; a < n; ++a) sum += mesh.X.col(block.element(e)[a]);
    Centroid& to = centroids[e];
    for (int k = 0; k < 3; ++k) to.c[k] = static_cast<float>(sum[k] / n);
    to.element = static_cast<std::int32_t>(e);
  });
  if (!centroids.empty()) {
#pragma omp parallel
#pragma omp single
    bisect(centroids.data(), centroids.data() + centroids.size(), size);
  }
  return centroids;
}

/// Nodes of a patch with the number of its elements at each.
struct LocalNode {
  std::int32_t node;
  std::int16_t valence;
  std::int16_t first;  // number in the patch in the order in which its elements name them
};

/// Cuts the ordered elements into patches of at most `threads` elements and patchNodeLimit nodes: fills plan.elements
/// and plan.corners, and lists the nodes of each patch, in the order in which its elements name them.
void cut(const Mesh& mesh, const MeshBlock& block, DeviceBlockPlan& plan, std::vector<std::int32_t>& local,
         std::vector<LocalNode>& nodes, std::vector<std::size_t>& nodeBegin) {
  const int n = block.nodesPerElement();
  const std::vector<Centroid> order = orderedCentroids(mesh, block, plan.threads);
  std::size_t next = 0;
  while (next < order.size()) {
    const std::size_t begin = nodes.size();
    int taken = 0;
    // Patches stay on the bisection's borders, so that one that hits the node limit does not shift all that follow.
    const std::size_t border = std::min(
        order.size(), (next / static_cast<std::size_t>(plan.threads) + 1) * static_cast<std::size_t>(plan.threads));
    for (; next < border && static_cast<int>(nodes.size() - begin) + n <= patchNodeLimit; ++next, ++taken) {
      const std::int32_t e = order[next].element;
      plan.elements.push_back(e);
      for (int a = 0; a < n; ++a) {
        const std::int32_t node = block.element(e)[a];
        std::int32_t& at = local[node];
        if (at < 0) {
          at = static_cast<std::int32_t>(nodes.size() - begin);
          nodes.push_back({node, 0, static_cast<std::int16_t>(at)});
        }
        ++nodes[begin + static_cast<std::size_t>(at)].valence;
        plan.corners.push_back(static_cast<std::uint16_t>(at));
      }
    }
    plan.elements.resize(plan.elements.size() + static_cast<std::size_t>(plan.threads - taken), -1);
    plan.corners.resize(plan.elements.size() * static_cast<std::size_t>(n), 0);
    plan.patches.push_back({taken, 0});
    for (std::size_t i = begin; i < nodes.size(); ++i) local[nodes[i].node] = -1;
    nodeBegin.push_back(nodes.size());
  }
}

/// What is made of a patch by itself, so that patches can be made side by side.
struct PatchLists {
  std::vector<std::uint16_t> rows;
  std::vector<std::int32_t> groupEnd;  // rows up to the end of each group
};

/// Numbers a patch's corners by its nodes as they are sorted, and lists those of each node in rows of 32 nodes.
PatchLists listCorners(const LocalNode* nodes, std::size_t p, int n, DeviceBlockPlan& plan) {
  const int threads = plan.threads;
  const std::size_t nodeCount = plan.patches[p].nodeCount;
  std::array<std::uint16_t, patchNodeLimit> number{};  // by first
  for (std::size_t i = 0; i < nodeCount; ++i) number[nodes[i].first] = static_cast<std::uint16_t>(i);
  std::vector<std::vector<std::uint16_t>> cornersOf(nodeCount);
  for (int a = 0; a < n; ++a)
    for (int t = 0; t < plan.patches[p].elementCount; ++t) {
      const std::size_t at = p * static_cast<std::size_t>(threads) + static_cast<std::size_t>(t);
      std::uint16_t& corner = plan.corners[at * static_cast<std::size_t>(n) + static_cast<std::size_t>(a)];
      corner = number[corner];
      cornersOf[corner].push_back(static_cast<std::uint16_t>(a * threads + t));
    }
  PatchLists lists;
  for (std::size_t first = 0; first < static_cast<std::size_t>(plan.nodeCapacity); first += group) {
    fillRows(cornersOf, std::min(first, nodeCount), std::min(nodeCount, first + group),
             static_cast<std::uint16_t>(n * threads), lists.rows);
    lists.groupEnd.push_back(static_cast<std::int32_t>(lists.rows.size() / group));
  }
  return lists;
}

}  // namespace

void fillRows(std::vector<std::vector<std::uint16_t>>& entriesOf, std::size_t first, std::size_t last,
              std::uint16_t none, std::vector<std::uint16_t>& rows) {
  constexpr std::size_t banks = 16;
  std::size_t depth = 0;
  for (std::size_t i = first; i < last; ++i) depth = std::max(depth, entriesOf[i].size());
  for (std::size_t row = 0; row < depth; ++row)
    for (std::size_t half = 0; half < group; half += banks) {
      std::array<int, banks> taken{};
      for (std::size_t i = first + half; i < first + half + banks; ++i) {
        if (i >= last || entriesOf[i].empty()) {
          rows.push_back(none);
          continue;
        }
        std::vector<std::uint16_t>& own = entriesOf[i];
        const auto best = std::min_element(own.begin(), own.end(), [&](std::uint16_t a, std::uint16_t b) {
          return taken[a % banks] < taken[b % banks];
        });
        ++taken[*best % banks];
        rows.push_back(*best);
        own.erase(best);
      }
    }
}

DevicePlan planPatches(const Mesh& mesh) {
  DevicePlan plan;
  plan.blocks.resize(mesh.blocks.size());
  std::vector<std::int32_t> local(mesh.nodeCount(), -1), patchesAt(mesh.nodeCount(), 0);
  std::vector<LocalNode> nodes;
  std::vector<std::size_t> nodeBegin{0};
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    const ElementInfo& element = elementInfo(mesh.blocks[b].type);
    if (element.order != 1 || !isOfLibrary(element.type)) {
      std::vector<std::string_view> names;
      for (const ElementInfo& info : allElements())
        if (info.order == 1 && isOfLibrary(info.type)) names.push_back(info.name);
      std::string known;
      for (std::size_t i = 0; i < names.size(); ++i)
        known += joinText(i == 0 ? "" : i + 1 < names.size() ? ", " : " and ", names[i]);
      throw InputError(joinText("block ", b, ": elements of type ", element.name, " are not on the device; it has ",
                                known, ": use device = \"cpu\""));
    }
    plan.blocks[b].block = b;
    plan.blocks[b].threads = patchThreads(element.nodes);
    cut(mesh, mesh.blocks[b], plan.blocks[b], local, nodes, nodeBegin);
    plan.patchCount += static_cast<std::int32_t>(plan.blocks[b].patches.size());
  }
  for (const LocalNode& node : nodes) ++patchesAt[node.node];

  // Device numbers: interior nodes by patch, those with many elements first, so that the threads of a warp have about
  // the same number to sum; shared nodes in the order of the patches that see them first.
  plan.deviceNode.assign(mesh.nodeCount(), -1);
  const auto deviceOf = [&](std::int32_t node) -> std::int32_t& { return plan.deviceNode[node]; };
  const auto shared = [&](const LocalNode& node) { return patchesAt[node.node] > 1; };
  std::int32_t sharedCount = 0;
  for (const LocalNode& node : nodes)
    if (shared(node) && deviceOf(node.node) < 0) deviceOf(node.node) = sharedCount++;
  parallelFor(0, plan.patchCount, 0, [&](std::int64_t p) {
    std::stable_sort(nodes.begin() + static_cast<std::ptrdiff_t>(nodeBegin[p]),
                     nodes.begin() + static_cast<std::ptrdiff_t>(nodeBegin[p + 1]),
                     [](const LocalNode& a, const LocalNode& b) { return a.valence > b.valence; });
  });
  for (const LocalNode& node : nodes)
    if (!shared(node)) deviceOf(node.node) = plan.interiorCount++;
  for (std::size_t i = 0; i < patchesAt.size(); ++i) {
    if (patchesAt[i] == 0) plan.deviceNode[i] = sharedCount++;  // of no element: shared by none
    if (patchesAt[i] != 1) plan.deviceNode[i] += plan.interiorCount;
  }

  std::size_t p = 0;
  plan.slotBegin.assign(static_cast<std::size_t>(sharedCount) + 1, 0);
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    DeviceBlockPlan& block = plan.blocks[b];
    const int n = mesh.blocks[b].nodesPerElement();
    block.groupRow.push_back(0);
    block.firstSlot = plan.slotCount;
    std::size_t most = 0;
    for (std::size_t own = 0; own < block.patches.size(); ++own)
      most = std::max(most, nodeBegin[p + own + 1] - nodeBegin[p + own]);
    block.nodeCapacity = static_cast<int>((most + group - 1) / group * group);
    block.nodes.assign(block.patches.size() * static_cast<std::size_t>(block.nodeCapacity), -1);
    std::vector<PatchLists> lists(block.patches.size());
    parallelFor(0, static_cast<std::int64_t>(block.patches.size()), 0, [&](std::int64_t own) {
      const LocalNode* from = nodes.data() + nodeBegin[p + static_cast<std::size_t>(own)];
      const std::size_t count =
          nodeBegin[p + static_cast<std::size_t>(own) + 1] - nodeBegin[p + static_cast<std::size_t>(own)];
      block.patches[own].nodeCount = static_cast<std::int32_t>(count);
      for (std::size_t i = 0; i < count; ++i)
        block.nodes[static_cast<std::size_t>(own) * static_cast<std::size_t>(block.nodeCapacity) + i] =
            deviceOf(from[i].node);
      lists[own] = listCorners(from, static_cast<std::size_t>(own), n, block);
    });
    for (PatchLists& own : lists) {
      const std::int32_t before = block.groupRow.back();
      for (const std::int32_t end : own.groupEnd) block.groupRow.push_back(before + end);
      block.rows.insert(block.rows.end(), own.rows.begin(), own.rows.end());
      block.rowCapacity = std::max(block.rowCapacity, block.groupRow.back() - before);
      own = {};
    }
    for (std::size_t i = nodeBegin[p]; i < nodeBegin[p + block.patches.size()]; ++i)
      if (shared(nodes[i]))
        ++plan.slotBegin[static_cast<std::size_t>(deviceOf(nodes[i].node) - plan.interiorCount) + 1];
    p += block.patches.size();
    plan.slotCount += static_cast<std::int32_t>(block.nodes.size());
  }
  std::partial_sum(plan.slotBegin.begin(), plan.slotBegin.end(), plan.slotBegin.begin());
  plan.slot.resize(plan.slotBegin.back());
  std::vector<std::int32_t> next(plan.slotBegin.begin(), plan.slotBegin.end() - 1);
  std::int32_t slot = 0;
  for (const DeviceBlockPlan& block : plan.blocks)
    for (const std::int32_t node : block.nodes) {
      if (node >= plan.interiorCount) plan.slot[next[node - plan.interiorCount]++] = slot;
      ++slot;
    }
  return plan;
}

}  // namespace ringwatch

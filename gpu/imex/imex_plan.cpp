#include <ringwatch/gpu/imex/imex_plan.h>

#include <algorithm>
#include <limits>

#include <Eigen/LU>

#include <ringwatch/base/error.h>
#include <ringwatch/base/sort_unique.h>

namespace ringwatch {
namespace {

std::int32_t firstLane(std::int32_t place) { return place / sliceNodes * 32 + place % sliceNodes * 3; }

/// One block of one element: `row` and `column` are places in ImexPlan::node.
struct Entry {
  std::int32_t row, column;
  ImexContribution from;
};

/// The gradients that fit F = Σ x_a shape_aᵀ to an element's nodes, as ImplicitCluster's.
Eigen::MatrixXd fittedGradients(const Mesh& mesh, const MeshBlock& block, std::int32_t element) {
  const int n = block.nodesPerElement();
  Eigen::MatrixXd shape(n, 3);
  for (int a = 0; a < n; ++a) shape.row(a) = mesh.X.col(block.element(element)[a]).transpose();
  shape.rowwise() -= shape.colwise().mean().eval();
  return shape * (shape.transpose() * shape).inverse();
}

/// Adds the rows of one cluster's matrix, whose slices begin at firstSlice; entries: its pairs.
void addMatrix(std::vector<Entry>& entries, std::int32_t firstSlice, ImexPlan& plan) {
  // Rows by ascending column after the diagonal: that has the most contributions, and warps that sum it should not wait
  // in every row. Stable: an element's place in the sum is that in the list of elements.
  std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    if (a.row != b.row) return a.row < b.row;
    if ((a.column == a.row) != (b.column == b.row)) return a.column == a.row;
    return a.column < b.column;
  });
  const std::int32_t base = firstSlice * sliceNodes;
  // Where the entries of each row's blocks begin.
  std::vector<std::vector<std::size_t>> blocks(plan.node.size() - static_cast<std::size_t>(base));
  for (std::size_t k = 0; k < entries.size(); ++k)
    if (k == 0 || entries[k].row != entries[k - 1].row || entries[k].column != entries[k - 1].column)
      blocks[entries[k].row - base].push_back(k);
  const auto endOf = [&](std::size_t k) {
    const std::size_t begin = k;
    while (k < entries.size() && entries[k].row == entries[begin].row && entries[k].column == entries[begin].column)
      ++k;
    return k;
  };
  for (std::int32_t slice = firstSlice; slice < plan.sliceCount(); ++slice) {
    const auto rowAt = [&](int k) -> const std::vector<std::size_t>& { return blocks[slice * sliceNodes + k - base]; };
    std::size_t longest = 0;
    for (int k = 0; k < sliceNodes; ++k) longest = std::max(longest, rowAt(k).size());
    for (std::size_t j = 0; j < longest; ++j) {
      plan.slice.push_back(slice);
      for (int k = 0; k < sliceNodes; ++k) {
        const bool is = j < rowAt(k).size();
        plan.column.push_back(is ? firstLane(entries[rowAt(k)[j]].column) : slice * 32);  // times zero
        if (is)
          for (std::size_t at = rowAt(k)[j], end = endOf(at); at < end; ++at)
            plan.contributions.push_back(entries[at].from);
        plan.first.push_back(plan.contributions.size());
      }
    }
    plan.rowBegin.push_back(plan.slice.size());
  }
}

}  // namespace

ImexPlan planImex(const Mesh& mesh, const std::vector<std::vector<ElementRef>>& clusters,
                  const std::vector<bool>& held) {
  ImexPlan plan;
  plan.blocks.resize(mesh.blocks.size());
  plan.rowBegin.push_back(0);
  plan.first.push_back(0);
  std::vector<std::int32_t> counts(plan.blocks.size(), 0);
  for (const auto& elements : clusters)
    for (const ElementRef ref : elements) {
      if (ref.block < 0 || static_cast<std::size_t>(ref.block) >= mesh.blocks.size() || ref.element < 0 ||
          static_cast<std::size_t>(ref.element) >= mesh.blocks[ref.block].elementCount())
        throw InputError(joinText("element ", ref.block, ":", ref.element, " is not in the mesh"));
      ++counts[ref.block];
    }
  std::int64_t rotated = 0;
  for (std::size_t b = 0; b < plan.blocks.size(); ++b) {
    plan.blocks[b].firstBlock = static_cast<std::int32_t>(rotated);
    const std::int64_t n = mesh.blocks[b].nodesPerElement();
    rotated += n * (n + 1) / 2 * counts[b];
    if (rotated > std::numeric_limits<std::int32_t>::max() / 2)
      throw InputError("too many implicit elements for the device");
  }
  plan.blockCount = static_cast<std::int32_t>(rotated);
  std::vector<std::int32_t> placeOfNode(mesh.nodeCount(), -1);
  for (const auto& elements : clusters) {
    const std::int32_t number = plan.clusters.size();
    const std::int32_t firstSlice = plan.sliceCount();
    bool anyHeld = false;
    std::vector<std::int32_t> nodes;
    for (const ElementRef ref : elements) {
      const MeshBlock& block = mesh.blocks[ref.block];
      for (int a = 0; a < block.nodesPerElement(); ++a) nodes.push_back(block.element(ref.element)[a]);
    }
    sortUnique(nodes);
    for (const std::int32_t node : nodes) {
      std::int32_t& place = placeOfNode[node];
      if (place >= 0) throw InputError(joinText("node ", node, " is in two clusters"));
      place = static_cast<std::int32_t>(plan.node.size());
      plan.node.push_back(node);
      anyHeld = anyHeld || held[node];
    }
    plan.node.resize((plan.node.size() + sliceNodes - 1) / sliceNodes * sliceNodes, -1);
    if (plan.node.size() / sliceNodes * 32 > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()) / 2)
      throw InputError("too many implicit nodes for the device");

    std::vector<Entry> entries;
    for (const ElementRef ref : elements) {
      const MeshBlock& block = mesh.blocks[ref.block];
      ImexPlan::Elements& own = plan.blocks[ref.block];
      const int n = block.nodesPerElement();
      const std::int32_t position = own.element.size();
      const auto placeAt = [&](int a) { return placeOfNode[block.element(ref.element)[a]]; };
      const auto pairAt = [&](int a, int b) {  // a >= b
        return own.firstBlock + (a * (a + 1) / 2 + b) * counts[ref.block] + position;
      };
      for (int a = 0; a < n; ++a)
        for (int b = 0; b < n; ++b) entries.push_back({placeAt(a), placeAt(b), a >= b ? pairAt(a, b) : ~pairAt(b, a)});
      own.element.push_back(ref.element);
      own.cluster.push_back(number);
      const Eigen::MatrixXd shape = fittedGradients(mesh, block, ref.element);
      for (int a = 0; a < n; ++a) {
        own.node.push_back(firstLane(placeAt(a)));
        for (int j = 0; j < 3; ++j) own.shape.push_back(shape(a, j));
      }
    }
    addMatrix(entries, firstSlice, plan);
    plan.clusters.push_back({firstSlice, plan.sliceCount() - firstSlice, anyHeld});
  }
  return plan;
}

ImexTeams planTeams(const std::vector<ImexCluster>& clusters, std::int32_t resident) {
  constexpr std::int32_t ofWarp = 3, ofBlock = 64, warps = imexThreads / 32;  // slices
  ImexTeams plan;
  std::int64_t total = 0;
  for (const ImexCluster& cluster : clusters) total += cluster.sliceCount;
  const auto large = [&](const ImexCluster& cluster) {
    return cluster.sliceCount > std::max<std::int64_t>(ofBlock, 2 * total / resident);
  };
  std::int64_t warpSlices = 0;
  for (std::size_t k = 0; k < clusters.size(); ++k) {
    if (large(clusters[k])) continue;
    (clusters[k].sliceCount <= ofWarp ? plan.ofWarps : plan.ofBlocks).push_back(k);
    if (clusters[k].sliceCount <= ofWarp) ++warpSlices;
  }
  const bool others = !plan.ofWarps.empty() || !plan.ofBlocks.empty();
  for (std::size_t k = 0; k < clusters.size(); ++k) {
    if (!large(clusters[k])) continue;
    const std::int64_t slices = clusters[k].sliceCount, share = (resident - (others ? 1 : 0)) * slices / total;
    const auto count =
        static_cast<std::int32_t>(std::max<std::int64_t>(1, std::min((slices + warps - 1) / warps, share)));
    plan.teams.push_back({static_cast<std::int32_t>(k), plan.teamBlocks, count});
    plan.teamOfBlock.insert(plan.teamOfBlock.end(), count, static_cast<std::int32_t>(plan.teams.size()) - 1);
    plan.teamBlocks += count;
  }
  const auto wanted = static_cast<std::int64_t>(plan.ofBlocks.size()) + (warpSlices + warps - 1) / warps;
  plan.blockCount =
      plan.teamBlocks + static_cast<std::int32_t>(std::min<std::int64_t>(resident - plan.teamBlocks, wanted));
  return plan;
}

}  // namespace ringwatch

#include <ringwatch/distributed/element_order.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include <ringwatch/base/sort_unique.h>
#include <ringwatch/distributed/exchange.h>

namespace ringwatch {
namespace {

/// A place on the curve that stands for elements of a weight.
struct Sample {
  std::uint64_t key;
  double weight;
};

/// The first key of every rank but the first: by samples, so that pieces differ by a few per cent.
std::vector<std::uint64_t> firstKeys(Ranks& ranks, const std::vector<std::vector<std::uint64_t>>& keys,
                                     const std::vector<MeshBlock>& blocks) {
  constexpr std::size_t samplesOfRank = 256;
  std::vector<Sample> all;
  double total = 0;
  for (std::size_t b = 0; b < keys.size(); ++b)
    for (const std::uint64_t key : keys[b]) {
      all.push_back({key, static_cast<double>(blocks[b].nodesPerElement())});
      total += all.back().weight;
    }
  const auto byKey = [](const Sample& p, const Sample& q) { return p.key < q.key; };
  std::sort(all.begin(), all.end(), byKey);
  std::vector<Sample> own;
  double before = 0;
  for (const Sample& element : all) {
    const double share = total / static_cast<double>(std::min(samplesOfRank, all.size()));
    if (before >= share * static_cast<double>(own.size())) own.push_back({element.key, share});
    before += element.weight;
  }
  std::vector<Sample> samples = gatherAll(ranks, own);
  std::sort(samples.begin(), samples.end(), byKey);
  double sum = 0;
  for (const Sample& sample : samples) sum += sample.weight;
  std::vector<std::uint64_t> first;
  double passed = 0;
  for (const Sample& sample : samples) {
    while (static_cast<int>(first.size()) + 1 < ranks.size() &&
           passed >= sum * static_cast<double>(first.size() + 1) / ranks.size())
      first.push_back(sample.key);
    passed += sample.weight;
  }
  first.resize(static_cast<std::size_t>(ranks.size()) - 1, std::numeric_limits<std::uint64_t>::max());
  return first;
}

/// Sends the elements of a block to the ranks that their keys belong to, and sorts them there.
NumberedElements sendAlongCurve(Ranks& ranks, MeshBlock block, std::int32_t firstNumber,
                                const std::vector<std::int32_t>& sliceNodes, std::vector<std::uint64_t> keys,
                                const std::vector<std::uint64_t>& firstKeyOf) {
  const auto n = static_cast<std::size_t>(block.nodesPerElement()), size = static_cast<std::size_t>(ranks.size());
  std::vector<std::vector<SentElement>> heads(size);
  std::vector<std::vector<std::int32_t>> nodes(size);
  for (std::size_t e = 0; e < keys.size(); ++e) {
    const auto to =
        static_cast<std::size_t>(std::upper_bound(firstKeyOf.begin(), firstKeyOf.end(), keys[e]) - firstKeyOf.begin());
    heads[to].push_back({keys[e], block.id(e), firstNumber + static_cast<std::int32_t>(e), {}});
    for (std::size_t a = 0; a < n; ++a) nodes[to].push_back(sliceNodes[block.element(e)[a]]);
  }
  block = MeshBlock{block.type, {}, {}};
  keys = {};
  return exchangeElements(ranks, block.type, heads, nodes);
}

/// Where the patches of a block begin is known when all before it is: the ranks go through their pieces one after the
/// other, each with the patch that the one before has left open. What takes time is done before, by all at once.
void placeInPatches(Ranks& ranks, NumberedElements& block) {
  const std::size_t n = block.width();
  std::vector<std::int32_t> known = block.nodes;  // ascending
  sortUnique(known);
  std::vector<std::int32_t> local;
  local.reserve(block.nodes.size());
  const auto positionOf = [&](std::int32_t node) {
    return std::lower_bound(known.begin(), known.end(), node) - known.begin();
  };
  for (const std::int32_t node : block.nodes) local.push_back(static_cast<std::int32_t>(positionOf(node)));
  const auto first = static_cast<std::int32_t>(sumBefore(ranks, static_cast<std::int64_t>(block.count())));

  enum { headTag = 1, nodesTag = 2 };
  struct Head {
    std::int32_t patch, nodes;  // where the open patch begins, and how many nodes it has
  } head{0, 0};
  std::vector<std::int32_t> open;  // nodes of the open patch, numbers in the whole
  if (ranks.rank() > 0) {
    MPI_Recv(&head, 2, MPI_INT32_T, ranks.rank() - 1, headTag, ranks.communicator(), MPI_STATUS_IGNORE);
    open.resize(static_cast<std::size_t>(head.nodes));
    MPI_Recv(open.data(), head.nodes, MPI_INT32_T, ranks.rank() - 1, nodesTag, ranks.communicator(), MPI_STATUS_IGNORE);
  }
  std::vector<std::int32_t> patchOf(known.size(), -1);  // the last patch that a node was added to
  for (const std::int32_t node : open)
    if (const auto at = positionOf(node); at < static_cast<std::ptrdiff_t>(known.size()) && known[at] == node)
      patchOf[at] = head.patch;
  for (std::size_t i = 0; i < block.count(); ++i) {
    const std::int32_t place = first + static_cast<std::int32_t>(i);
    if (place % lanes == 0 && !takesAnotherBatch(static_cast<std::int32_t>(open.size()), static_cast<int>(n))) {
      head.patch = place;
      open.clear();
    }
    for (std::size_t a = 0; a < n; ++a) {
      const std::int32_t at = local[i * n + a];
      if (patchOf[at] == head.patch) continue;
      patchOf[at] = head.patch;
      open.push_back(known[at]);
    }
    block.places[i] = {head.patch, place};
  }
  if (ranks.rank() + 1 == ranks.size()) return;
  head.nodes = static_cast<std::int32_t>(open.size());
  MPI_Send(&head, 2, MPI_INT32_T, ranks.rank() + 1, headTag, ranks.communicator());
  MPI_Send(open.data(), head.nodes, MPI_INT32_T, ranks.rank() + 1, nodesTag, ranks.communicator());
}

}  // namespace

NumberedElements exchangeElements(Ranks& ranks, ElementType type, std::vector<std::vector<SentElement>>& heads,
                                  std::vector<std::vector<std::int32_t>>& nodes) {
  NumberedElements result{type, {}, {}, {}, {}};
  const std::vector<SentElement> came = std::move(exchange(ranks, heads).values);
  const std::vector<std::int32_t> theirs = std::move(exchange(ranks, nodes).values);
  std::vector<std::int32_t> order(came.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::int32_t p, std::int32_t q) {
    return came[p].key != came[q].key ? came[p].key < came[q].key : came[p].number < came[q].number;
  });
  const auto n = static_cast<std::ptrdiff_t>(result.width());
  result.nodes.reserve(theirs.size());
  for (const std::int32_t i : order) {
    result.numbers.push_back(came[i].number);
    result.ids.push_back(came[i].id);
    result.places.push_back(came[i].place);
    result.nodes.insert(result.nodes.end(), theirs.begin() + n * i, theirs.begin() + n * (i + 1));
  }
  return result;
}

std::vector<NumberedElements> orderElements(Ranks& ranks, SharedMesh& mesh, const Eigen::Vector3d& low,
                                            const Eigen::Vector3d& high) {
  const double extent = curveExtent(low, high);
  std::vector<std::vector<std::uint64_t>> keys;
  for (const MeshBlock& block : mesh.slice.blocks) {
    std::vector<std::uint64_t>& own = keys.emplace_back();
    own.reserve(block.elementCount());
    for (std::size_t e = 0; e < block.elementCount(); ++e)
      own.push_back(curveKey(mesh.slice.X, block.element(e), block.nodesPerElement(), low, extent));
  }
  const std::vector<std::uint64_t> firstKeyOf = firstKeys(ranks, keys, mesh.slice.blocks);
  mesh.slice.X.resize(3, 0);
  std::vector<NumberedElements> blocks;
  for (std::size_t b = 0; b < keys.size(); ++b) {
    blocks.push_back(sendAlongCurve(ranks, std::exchange(mesh.slice.blocks[b], {mesh.slice.blocks[b].type, {}, {}}),
                                    mesh.firstElement[b], mesh.sliceNodes, std::move(keys[b]), firstKeyOf));
    placeInPatches(ranks, blocks.back());
  }
  mesh.sliceNodes = {};
  return blocks;
}

}  // namespace ringwatch

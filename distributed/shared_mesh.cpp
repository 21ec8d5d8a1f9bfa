#include <ringwatch/distributed/shared_mesh.h>

#include <optional>
#include <span>

#include <ringwatch/base/sort_unique.h>
#include <ringwatch/distributed/exchange.h>

namespace ringwatch {
namespace {

constexpr std::int64_t none = -1;

/// Where in the file the node with a number is, counted from 0: by arithmetic where the numbers are consecutive, else
/// by a directory that the ranks have together.
class NodeDirectory {
 public:
  /// Throws InputError for a number that is there twice.
  NodeDirectory(Ranks& ranks, const ReadShare& share) : ranks_(ranks), allNodes_(share.allNodes) {
    // Any number may stand in a file: unsigned and by complements, so that none overflows.
    std::int64_t least = noFault, complementOfMost = noFault;
    for (std::size_t i = 0; i < share.nodeIds.size(); ++i) {
      const auto offset = static_cast<std::int64_t>(static_cast<std::uint64_t>(share.nodeIds[i]) -
                                                    static_cast<std::uint64_t>(share.firstNode) - i);
      least = std::min(least, offset);
      complementOfMost = std::min(complementOfMost, ~offset);
    }
    least = ranks.least(least);
    if (least == ~ranks.least(complementOfMost)) {
      offset_ = least;
      return;
    }
    std::vector<std::vector<Entry>> to(static_cast<std::size_t>(ranks.size()));
    for (std::size_t i = 0; i < share.nodeIds.size(); ++i)
      to[static_cast<std::size_t>(homeOf(share.nodeIds[i]))].push_back(
          {share.nodeIds[i], share.firstNode + static_cast<std::int64_t>(i)});
    entries_ = std::move(exchange(ranks, to).values);
    std::sort(entries_.begin(), entries_.end());
    std::int64_t repeated = noFault;
    for (std::size_t i = 1; i < entries_.size(); ++i)
      if (entries_[i].id == entries_[i - 1].id) repeated = std::min(repeated, entries_[i].place);
    repeated = ranks.least(repeated);
    const std::int64_t here = repeated - share.firstNode;
    const bool mine = repeated != noFault && here >= 0 && here < static_cast<std::int64_t>(share.nodeIds.size());
    throwFirst(ranks, mine ? repeated : noFault, [&] {
      return share.repeatedNode(static_cast<std::size_t>(here), share.nodeIds[static_cast<std::size_t>(here)]);
    });
  }

  /// none for a number that the file does not have. Collective.
  std::vector<std::int64_t> find(std::span<const std::int64_t> ids) {
    if (!offset_)
      return ask<std::int64_t>(
          ranks_, ids, [this](std::int64_t id) { return homeOf(id); },
          [this](std::int64_t id) {
            const auto found = std::lower_bound(entries_.begin(), entries_.end(), Entry{id, 0});
            return found != entries_.end() && found->id == id ? found->place : none;
          });
    std::vector<std::int64_t> places;
    places.reserve(ids.size());
    for (const std::int64_t id : ids) {
      const std::uint64_t place = static_cast<std::uint64_t>(id) - static_cast<std::uint64_t>(*offset_);
      places.push_back(place < static_cast<std::uint64_t>(allNodes_) ? static_cast<std::int64_t>(place) : none);
    }
    return places;
  }

 private:
  struct Entry {
    std::int64_t id, place;
    auto operator<=>(const Entry&) const = default;
  };
  /// Numbers that follow each other go round the ranks.
  int homeOf(std::int64_t id) const {
    return static_cast<int>(static_cast<std::uint64_t>(id) % static_cast<std::uint64_t>(ranks_.size()));
  }

  Ranks& ranks_;
  std::int64_t allNodes_;
  std::optional<std::int64_t> offset_;
  std::vector<Entry> entries_;
};

/// Position in an ascending list that has the value.
template <class T>
std::size_t positionIn(const std::vector<T>& ascending, T value) {
  return static_cast<std::size_t>(std::lower_bound(ascending.begin(), ascending.end(), value) - ascending.begin());
}

struct PlacedSetNode {
  std::int64_t place;
  std::int32_t set;
};

struct NumberedNode {
  std::int32_t number;
  double X[3];  // m
};

}  // namespace

SharedMesh shareMesh(Ranks& ranks, ReadShare share) {
  NodeDirectory directory(ranks, share);
  std::vector<std::int64_t> ids;
  for (const ReadShare::Block& block : share.blocks) ids.insert(ids.end(), block.nodes.begin(), block.nodes.end());
  sortUnique(ids);
  ids.shrink_to_fit();
  std::vector<std::int64_t> setIds;
  for (const ReadShare::SetNode& entry : share.setNodes) setIds.push_back(entry.node);
  const std::vector<std::int64_t> places = directory.find(ids), setPlaces = directory.find(setIds);

  // The first element, by block and number, and behind them all the first entry of a set.
  constexpr int blockBits = 40;
  constexpr std::int64_t afterBlocks = std::int64_t{1} << 62;
  std::int64_t fault = noFault;
  std::function<std::string()> text;
  if (std::find(places.begin(), places.end(), none) != places.end()) {
    for (std::size_t b = 0; b < share.blocks.size() && fault == noFault; ++b) {
      const ReadShare::Block& block = share.blocks[b];
      const std::size_t n = block.ids.empty() ? 1 : block.nodes.size() / block.ids.size();
      for (std::size_t i = 0; i < block.nodes.size() && fault == noFault; ++i)
        if (places[positionIn(ids, block.nodes[i])] == none) {
          fault = (static_cast<std::int64_t>(b) << blockBits) + block.first + static_cast<std::int64_t>(i / n);
          text = [&share, b, i, n] {
            const ReadShare::Block& from = share.blocks[b];
            return share.missingNode(b, i / n, from.ids[i / n], from.nodes[i]);
          };
        }
    }
  }
  const std::int64_t firstEntry = sumBefore(ranks, static_cast<std::int64_t>(setIds.size()));
  for (std::size_t i = 0; i < setPlaces.size() && fault == noFault; ++i)
    if (setPlaces[i] == none) {
      fault = afterBlocks + firstEntry + static_cast<std::int64_t>(i);
      text = [&share, i] { return share.missingSetNode(share.setNodes[i].position, share.setNodes[i].node); };
    }
  throwFirst(ranks, fault, text);

  SharedMesh mesh;
  std::vector<std::int64_t> firstPlace = gatherAll(ranks, std::vector<std::int64_t>{share.firstNode});
  const auto homeOf = [&](std::int64_t place) {
    // Of ranks that have no nodes only the last one before another place can be meant, which has some.
    return static_cast<int>(std::upper_bound(firstPlace.begin(), firstPlace.end(), place) - firstPlace.begin()) - 1;
  };
  const auto size = static_cast<std::size_t>(ranks.size());
  std::vector<bool> used(share.nodeIds.size());
  {
    std::vector<std::vector<std::int64_t>> to(size);
    for (const std::int64_t place : places) to[static_cast<std::size_t>(homeOf(place))].push_back(place);
    for (const std::int64_t place : exchange(ranks, to).values)
      used[static_cast<std::size_t>(place - share.firstNode)] = true;
  }
  const auto here = static_cast<std::int64_t>(std::count(used.begin(), used.end(), true));
  const auto first = static_cast<std::int32_t>(sumBefore(ranks, here));
  mesh.firstNode = gatherAll(ranks, std::vector<std::int32_t>{first});
  mesh.firstNode.push_back(static_cast<std::int32_t>(sumOver(ranks, here)));

  mesh.droppedNodes = share.allNodes - mesh.nodeCount();
  if (mesh.droppedNodes > 0) {
    const auto unused = std::find(used.begin(), used.end(), false) - used.begin();
    const bool some = unused < static_cast<std::ptrdiff_t>(used.size());
    const auto from = ranks.firstWhere(some);
    if (from == ranks.rank()) mesh.firstDroppedNode = share.nodeIds[static_cast<std::size_t>(unused)];
    ranks.share(&mesh.firstDroppedNode, sizeof mesh.firstDroppedNode, from);
  }

  std::vector<std::int32_t> numbers(used.size(), -1);
  mesh.X.resize(3, here);
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i]) continue;
    const auto at = static_cast<std::int32_t>(mesh.nodeIds.size());
    numbers[i] = first + at;
    mesh.X.col(at) = share.X.col(static_cast<Eigen::Index>(i));
    mesh.nodeIds.push_back(share.nodeIds[i]);
  }
  share.X.resize(3, 0);
  share.nodeIds = {};
  const auto nodes = ask<NumberedNode>(ranks, std::span<const std::int64_t>(places), homeOf, [&](std::int64_t place) {
    const std::int32_t number = numbers[static_cast<std::size_t>(place - share.firstNode)];
    const Eigen::Vector3d X = mesh.X.col(number - first);
    return NumberedNode{number, {X[0], X[1], X[2]}};
  });
  {
    std::vector<std::vector<PlacedSetNode>> to(size);
    for (std::size_t i = 0; i < setPlaces.size(); ++i)
      to[static_cast<std::size_t>(homeOf(setPlaces[i]))].push_back({setPlaces[i], share.setNodes[i].set});
    for (const PlacedSetNode& entry : exchange(ranks, to).values)
      if (const std::int32_t number = numbers[static_cast<std::size_t>(entry.place - share.firstNode)]; number >= 0)
        mesh.setNodes.push_back({number, entry.set});
    sortUnique(mesh.setNodes);
  }

  // The slice's nodes ascend by number; those of `ids` ascend by the number in the file.
  std::vector<std::int32_t> order(nodes.size()), local(nodes.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::int32_t>(i);
  std::sort(order.begin(), order.end(),
            [&](std::int32_t a, std::int32_t b) { return nodes[a].number < nodes[b].number; });
  mesh.slice.X.resize(3, static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t i = 0; i < order.size(); ++i) {
    const NumberedNode& node = nodes[order[i]];
    local[order[i]] = static_cast<std::int32_t>(i);
    mesh.sliceNodes.push_back(node.number);
    mesh.slice.X.col(static_cast<Eigen::Index>(i)) = Eigen::Map<const Eigen::Vector3d>(node.X);
  }
  for (ReadShare::Block& from : share.blocks) {
    MeshBlock& block = mesh.slice.blocks.emplace_back(MeshBlock{from.type, {}, std::move(from.ids)});
    block.connectivity.reserve(from.nodes.size());
    for (const std::int64_t id : from.nodes) block.connectivity.push_back(local[positionIn(ids, id)]);
    from.nodes = {};
    mesh.firstElement.push_back(from.first);
  }
  mesh.sets = std::move(share.sets);
  return mesh;
}

}  // namespace ringwatch

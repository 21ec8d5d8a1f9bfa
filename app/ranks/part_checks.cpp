#include <ringwatch/app/ranks/part_checks.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include <ringwatch/base/error.h>
#include <ringwatch/base/exact_sum.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/sort_unique.h>
#include <ringwatch/distributed/element_cut.h>
#include <ringwatch/distributed/exchange.h>
#include <ringwatch/meshes/adjacency.h>
#include <ringwatch/meshes/check.h>
#include <ringwatch/meshes/check_texts.h>

namespace ringwatch {
namespace {

struct CountOfPart {
  std::int64_t label, elements;
  auto operator<=>(const CountOfPart&) const = default;
};

/// Pieces of the mesh that share no node: their number, and the sizes of the largest.
std::pair<std::int64_t, std::vector<std::int64_t>> connectedPieces(Ranks& ranks, const RankPart& part) {
  // A piece is called by the least number of its nodes. Pieces of a rank learn by their ghosts what they are parts of.
  const MeshParts here = connectedParts(part.mesh);
  std::vector<double> ofPiece(static_cast<std::size_t>(here.count), infinity);
  std::vector<double> ofNode(part.globalNodes.size());
  for (std::size_t i = 0; i < ofNode.size(); ++i) {
    double& label = ofPiece[here.partOfNode[i]];
    label = std::min(label, static_cast<double>(part.globalNodes[i]));
  }
  for (bool changed = true; changed;) {
    for (std::size_t i = 0; i < ofNode.size(); ++i) ofNode[i] = ofPiece[here.partOfNode[i]];
    copyToGhosts(ranks, part, ofNode.data(), 1);
    changed = false;
    for (std::size_t i = static_cast<std::size_t>(part.ownedNodes); i < ofNode.size(); ++i) {
      double& label = ofPiece[here.partOfNode[i]];
      if (ofNode[i] >= label) continue;
      label = ofNode[i];
      changed = true;
    }
    changed = ranks.least(changed ? 0 : 1) == 0;
  }
  std::int64_t firsts = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(part.ownedNodes); ++i)
    firsts += ofNode[i] == part.globalNodes[i] ? 1 : 0;
  const std::int64_t count = sumOver(ranks, firsts);
  if (count <= 1) return {count, {}};
  std::map<std::int64_t, std::int64_t> elements;
  std::size_t through = 0;
  for (std::size_t b = 0; b < part.mesh.blocks.size(); ++b)
    for (std::size_t e = 0; e < part.mesh.blocks[b].elementCount(); ++e, ++through)
      if (part.counts({b, e})) ++elements[static_cast<std::int64_t>(ofPiece[here.partOfElement[through]])];
  std::vector<std::vector<CountOfPart>> to(static_cast<std::size_t>(ranks.size()));
  for (const auto& [label, own] : elements) to[static_cast<std::size_t>(label % ranks.size())].push_back({label, own});
  elements.clear();
  for (const CountOfPart& one : exchange(ranks, to).values) elements[one.label] += one.elements;
  std::vector<std::int64_t> sizes;
  for (const auto& [label, own] : elements) sizes.push_back(own);
  const auto keepLargest = [&] {
    std::sort(sizes.begin(), sizes.end(), std::greater<>());
    sizes.resize(std::min(sizes.size(), detail::shownParts));
  };
  keepLargest();
  sizes = gatherAll(ranks, sizes);
  keepLargest();
  return {count, std::move(sizes)};
}

/// A node in a cell of space.
struct NodeInCell {
  std::uint64_t cell;
  std::int32_t node;    // its number in the whole
  std::int32_t inside;  // 0: near the cell
  double X[3];          // m
  double distance;      // m, up to which another lies at its place
  std::int64_t id;
};
/// A node, and the nearest before it that lies so close.
struct Coincidence {
  std::int32_t node;
  double apart;  // m
  std::int32_t other;
  std::int64_t id, otherId;
  auto operator<=>(const Coincidence&) const = default;
};

/// Nodes that lie so close to one before them: those that this rank tells, by their numbers.
std::vector<Coincidence> coincidences(Ranks& ranks, const RankPart& part, detail::Closeness closeness) {
  detail::CoincidenceGrid grid(0);
  // Of own nodes, all of whose elements are here.
  std::vector<double> distances = detail::distancesOfDoubles(part.mesh, closeness);
  distances.resize(static_cast<std::size_t>(part.ownedNodes));
  std::vector<int> levels;
  for (std::size_t i = 0; i < distances.size(); ++i) {
    distances[i] = grid.distance(part.mesh.X.col(static_cast<Eigen::Index>(i)), distances[i]);
    if (distances[i] > 0) levels.push_back(detail::CoincidenceGrid::levelOf(distances[i]));
  }
  sortUnique(levels);
  levels = gatherAll(ranks, levels);
  sortUnique(levels);
  grid.setLevels(std::move(levels));
  const auto size = static_cast<std::uint64_t>(ranks.size());
  std::vector<std::vector<NodeInCell>> to(size);
  for (std::int32_t i = 0; i < part.ownedNodes; ++i) {
    const double distance = distances[static_cast<std::size_t>(i)];
    if (distance == 0) continue;
    const Eigen::Vector3d X = part.mesh.X.col(i);
    const std::uint64_t own = grid.cellOf(X, distance);
    grid.forEachCellNear(X, distance, [&](std::uint64_t cell) {
      // Cells that follow each other go to ranks that have nothing to do with their places.
      constexpr std::uint64_t spread = 0x9e3779b97f4a7c15ULL;
      to[((cell * spread) >> 32) % size].push_back(
          {cell, part.globalNodes[i], cell == own ? 1 : 0, {X[0], X[1], X[2]}, distance, part.mesh.nodeId(i)});
      return false;
    });
  }
  std::vector<NodeInCell> came = std::move(exchange(ranks, to).values);
  std::sort(came.begin(), came.end(), [](const NodeInCell& a, const NodeInCell& b) {
    return std::tie(a.cell, a.node) < std::tie(b.cell, b.node);
  });
  std::vector<std::vector<Coincidence>> found(size);
  for (std::size_t begin = 0, end; begin < came.size(); begin = end) {
    for (end = begin + 1; end < came.size() && came[end].cell == came[begin].cell;) ++end;
    for (std::size_t i = begin + 1; i < end; ++i)
      for (std::size_t j = begin; j < i; ++j) {
        const Eigen::Map<const Eigen::Vector3d> a(came[i].X), b(came[j].X);
        const double apart = (b - a).norm();
        if (came[j].inside == 0 || came[j].node == came[i].node || apart > std::min(came[i].distance, came[j].distance))
          continue;
        found[static_cast<std::uint64_t>(came[i].node) % size].push_back(
            {came[i].node, apart, came[j].node, came[i].id, came[j].id});
      }
  }
  std::vector<Coincidence> own = std::move(exchange(ranks, found).values);
  std::sort(own.begin(), own.end());
  own.erase(
      std::unique(own.begin(), own.end(), [](const Coincidence& a, const Coincidence& b) { return a.node == b.node; }),
      own.end());
  return own;
}

/// Their number on all ranks, and the first.
std::pair<std::int64_t, Coincidence> firstOfAll(Ranks& ranks, std::vector<Coincidence> own) {
  const std::int64_t count = sumOver(ranks, static_cast<std::int64_t>(own.size()));
  if (count == 0) return {0, {}};
  own.resize(std::min<std::size_t>(own.size(), 1));
  std::vector<Coincidence> firsts = gatherAll(ranks, own);
  return {count, *std::min_element(firsts.begin(), firsts.end())};
}

}  // namespace

MeshBox boxOf(Ranks& ranks, const NodeVectors& X) {
  std::array<double, 6> corners;  // -low, high
  corners.fill(-infinity);
  for (Eigen::Index i = 0; i < X.cols(); ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      const double x = X(static_cast<Eigen::Index>(c), i);
      corners[c] = std::max(corners[c], -x);
      corners[3 + c] = std::max(corners[3 + c], x);
    }
  ranks.largest(corners);
  return {{-corners[0], -corners[1], -corners[2]}, {corners[3], corners[4], corners[5]}};
}

std::vector<std::string> mendShared(Ranks& ranks, SharedMesh& mesh, const std::vector<std::int64_t>& counts,
                                    const std::string& source, bool& partlyTurned) {
  std::vector<std::string> notes;
  if (mesh.droppedNodes > 0)
    notes.push_back(detail::droppedNodesNote(source, mesh.droppedNodes, mesh.firstDroppedNode));
  std::vector<std::int64_t> turned = detail::turnMirrored(mesh.slice);
  for (std::int64_t& count : turned) count = sumOver(ranks, count);
  for (std::string& note : detail::turnedNotes(mesh.slice, turned, counts, source)) notes.push_back(std::move(note));
  partlyTurned = detail::isPartlyTurned(turned, counts);
  return notes;
}

void requireSoundPart(Ranks& ranks, const RankPart& part, const std::string& source, bool partlyTurned) {
  struct Found {
    std::int64_t order;
    std::string text;
  };
  std::vector<Found> own;
  const auto add = [&](std::int64_t place, MeshProblem& problem) {
    own.push_back({(place << 32) | part.globalElements[problem.block][problem.index], std::move(problem.text)});
  };
  for (MeshProblem& problem : checkMesh(part.mesh)) {
    if (problem.block < 0 || !part.counts({problem.block, problem.index})) continue;
    // Of a block first what an element is by itself.
    const std::int64_t twice = problem.kind == MeshProblem::Kind::duplicateElement ? 1 : 0;
    add(std::int64_t{problem.block} * 2 + twice, problem);
  }
  if (partlyTurned) {
    // Of the owner of a face's first node, who has both of its elements.
    const auto isOwn = [&](std::span<const std::int32_t> face) {
      return *std::ranges::min_element(face, {}, [&](std::int32_t n) { return part.globalNodes[n]; }) < part.ownedNodes;
    };
    const auto behind = 2 * static_cast<std::int64_t>(part.mesh.blocks.size());
    for (MeshProblem& problem : detail::overlaps(part.mesh, isOwn))
      add(behind + (std::int64_t{problem.block} << 8) + static_cast<std::int64_t>(problem.value), problem);
  }
  std::sort(own.begin(), own.end(), [](const Found& a, const Found& b) { return a.order < b.order; });
  const std::int64_t count = sumOver(ranks, static_cast<std::int64_t>(own.size()));
  if (count == 0) return;
  std::vector<std::string> texts;
  std::size_t told = 0;  // of own
  while (texts.size() < detail::shownProblems && static_cast<std::int64_t>(texts.size()) < count) {
    const std::int64_t next = told < own.size() ? own[told].order : noFault;
    const bool mine = ranks.least(next) == next && next != noFault;
    const auto from = ranks.firstWhere(mine);
    texts.push_back(ranks.shareText(mine ? own[told].text : "", from));
    if (mine) ++told;
  }
  throw InputError(detail::problemsText(source, count, texts));
}

std::vector<std::string> partNotes(Ranks& ranks, const RankPart& part, const std::string& source) {
  std::vector<std::string> notes;
  if (const auto [count, sizes] = connectedPieces(ranks, part); count > 1)
    notes.push_back(detail::partsNote(source, count, sizes));
  const detail::HangingNodes own = detail::hangingNodes(part.mesh, static_cast<std::size_t>(part.ownedNodes));
  if (const std::int64_t count = sumOver(ranks, own.count); count > 0) {
    const std::int64_t here = own.count > 0 ? part.globalNodes[own.first] : noFault;
    const std::int64_t first = ranks.least(here);
    const std::int64_t id = ranks.least(here == first && own.count > 0 ? part.mesh.nodeId(own.first) : noFault);
    notes.push_back(detail::hangingNote(source, count, id));
  }
  const std::vector<Coincidence> same = coincidences(ranks, part, detail::Closeness::atOnePlace);
  if (const auto [count, first] = firstOfAll(ranks, same); count > 0)
    notes.push_back(detail::coincidenceNote(source, count, first.otherId, first.id));
  // A rank tells the same nodes, however close they are.
  std::vector<Coincidence> gaps = coincidences(ranks, part, detail::Closeness::gap);
  std::erase_if(
      gaps, [&](const Coincidence& gap) { return std::ranges::binary_search(same, gap.node, {}, &Coincidence::node); });
  if (const auto [count, first] = firstOfAll(ranks, std::move(gaps)); count > 0)
    notes.push_back(detail::gapNote(source, count, first.otherId, first.id, first.apart));
  return notes;
}

std::vector<QualitySummary> qualityOfParts(Ranks& ranks, const RankPart& part) {
  struct Extreme {
    double value = -infinity;
    std::optional<ElementRef> element = std::nullopt;  // of the whole
    void see(double other, ElementRef e) {
      if (other > value) *this = {other, e};
    }
  };
  const std::span<const QualityMeasure> measures = qualityMeasures();
  std::vector<std::int64_t> counts(measures.size(), 0);
  std::vector<Extreme> least(measures.size()), most(measures.size());  // least: of the negated values
  std::vector<ExactSum> sums(measures.size());
  const std::vector<std::vector<ElementQuality>> quality = meshQuality(part.mesh);
  for (std::size_t b = 0; b < quality.size(); ++b)
    for (std::size_t e = 0; e < quality[b].size(); ++e) {
      if (!part.counts({b, e})) continue;
      for (std::size_t m = 0; m < measures.size(); ++m) {
        const double value = quality[b][e].*measures[m].member;
        if (std::isnan(value)) continue;
        ++counts[m];
        sums[m].add(value);
        const ElementRef ofWhole{b, part.globalElements[b][e]};
        least[m].see(-value, ofWhole);
        most[m].see(value, ofWhole);
      }
    }
  ranks.sum(sums);
  const auto agree = [&](const Extreme& own) {
    Extreme all{own.value};
    ranks.largest({&all.value, 1});
    all.element = ranks.first(own.value == all.value ? own.element : std::nullopt);
    return all;
  };
  std::vector<QualitySummary> summaries;
  for (std::size_t m = 0; m < measures.size(); ++m) {
    const std::int64_t count = sumOver(ranks, counts[m]);
    if (count == 0) continue;
    const Extreme low = agree(least[m]), high = agree(most[m]);
    summaries.push_back({measures[m].name, measures[m].unit, static_cast<std::size_t>(count), -low.value, high.value,
                         sums[m].value() / static_cast<double>(count), low.element.value(), high.element.value()});
  }
  return summaries;
}

}  // namespace ringwatch

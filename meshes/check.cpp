#include <ringwatch/meshes/check.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <unordered_map>
#include <utility>

#include <ringwatch/base/error.h>
#include <ringwatch/base/fnv.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/sort_unique.h>
#include <ringwatch/meshes/adjacency.h>
#include <ringwatch/meshes/check_texts.h>
#include <ringwatch/meshes/part_of_mesh.h>
#include <ringwatch/meshes/quality.h>

namespace ringwatch {
namespace {

constexpr double degenerateLimit = 1e-12;  // of the longest edge cubed; slivers of real meshes stay above 1e-8

constexpr double noLength = 1e-9;  // of the longest edge; less is rounding of nodes that lie at one place

enum class Handedness { right, left, neither };

/// The permutation of an element's nodes that mirrors it: exchanges two natural coordinates, or reverses one, whichever
/// maps the reference nodes onto themselves.
std::vector<int> mirrorPermutation(const ElementInfo& info) {
  const auto matching = [&](auto mirror) {
    std::vector<int> permutation;
    for (const auto& node : info.referenceNodes) {
      const std::array<double, 3> image = mirror(node);
      for (int b = 0; b < info.nodes; ++b) {
        const auto& other = info.referenceNodes[b];
        double distance = 0;
        for (std::size_t k = 0; k < 3; ++k) distance = std::max(distance, std::abs(other[k] - image[k]));
        if (distance < 1e-9) {
          permutation.push_back(b);
          break;
        }
      }
    }
    if (permutation.size() != info.referenceNodes.size()) permutation.clear();
    return permutation;
  };
  for (const auto& [i, j] : {std::pair<std::size_t, std::size_t>{0, 1}, {1, 2}, {0, 2}}) {
    const auto p = matching([&, a = i, b = j](std::array<double, 3> x) {
      std::swap(x[a], x[b]);
      return x;
    });
    if (!p.empty()) return p;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const auto p = matching([&](std::array<double, 3> x) {
      x[k] = -x[k];
      return x;
    });
    if (!p.empty()) return p;
  }
  throw NumericalError(joinText(info.name, " has no mirror symmetry"));
}

double longestEdge(const ElementInfo& info, const NodeVectors& x, const std::int32_t* nodes) {
  double squared = 0;
  for (const auto& edge : info.edges)
    squared = std::max(squared, (x.col(nodes[edge[1]]) - x.col(nodes[edge[0]])).squaredNorm());
  return std::sqrt(squared);
}

/// The least Jacobian determinant of a sound element, m³: compared as a volume, det J times the reference volume.
double leastOf(const ElementInfo& info, double length) {
  return degenerateLimit * length * length * length / info.referenceVolume;
}

bool nodesInRange(const Mesh& mesh, const std::int32_t* nodes, int count) {
  return std::all_of(nodes, nodes + count,
                     [&](std::int32_t n) { return n >= 0 && static_cast<std::size_t>(n) < mesh.nodeCount(); });
}

std::int64_t nodeId(const Mesh& mesh, std::int32_t n) { return n >= 0 ? mesh.nodeId(n) : n; }

/// A problem of an element whose text names it and its nodes; what is wrong is to be added.
MeshProblem problemOf(const Mesh& mesh, ElementRef e, MeshProblem::Kind kind, double value) {
  const MeshBlock& block = mesh.blocks[e.block];
  const auto at = static_cast<std::size_t>(e.element);
  MeshProblem problem{kind, e.block, e.element, block.id(at), {}, value, {}};
  problem.text = joinText("element ", problem.id, " (", elementInfo(block.type).name, ", nodes");
  for (int a = 0; a < block.nodesPerElement(); ++a) {
    problem.nodes.push_back(nodeId(mesh, block.element(at)[a]));
    problem.text += joinText(" ", problem.nodes.back());
  }
  problem.text += ") ";
  return problem;
}

/// Why an element may be wrong that is in another program's order; "" for one that is not.
std::string otherOrder(const Mesh& mesh, const ElementInfo& info, const JacobianProbe& probe,
                       const std::int32_t* nodes) {
  if (info.order == 1)
    return detail::nodesOutOfRows(mesh, info, probe, nodes).empty()
               ? ""
               : "; its nodes go in rows, as those of VTK's voxels, which `ringwatch mesh repair` puts right";
  const std::vector<int> edges = detail::otherOrderOfMiddles(mesh, info, nodes);
  if (edges.empty()) return {};
  int misplaced = 0, first = -1;
  for (int i = 0; i < static_cast<int>(edges.size()); ++i)
    if (edges[i] != i && misplaced++ == 0) first = i;
  const int corners = cornerCount(info);
  return joinText("; ", misplaced, " of its nodes lie in the middle of another's edge, node ",
                  nodeId(mesh, nodes[corners + first]), " where node ", nodeId(mesh, nodes[corners + edges[first]]),
                  " should be: they are in ", detail::programOfOrder(info, edges),
                  " order, which `ringwatch mesh repair` puts right");
}

/// That a linear element may be wrong because two of its nodes, which have numbers of their own, lie at one place.
std::string nodesAtOnePlace(const Mesh& mesh, const ElementInfo& info, const std::int32_t* nodes, double longest) {
  for (const auto& edge : info.edges)
    if ((mesh.X.col(nodes[edge[1]]) - mesh.X.col(nodes[edge[0]])).norm() <= noLength * longest)
      return joinText("; its nodes ", nodeId(mesh, nodes[edge[0]]), " and ", nodeId(mesh, nodes[edge[1]]),
                      " lie at one place: `ringwatch mesh repair --join 0` joins such nodes");
  return {};
}

}  // namespace

std::vector<MeshProblem> checkMesh(const Mesh& mesh) {
  std::vector<MeshProblem> problems;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    const MeshBlock& block = mesh.blocks[b];
    const ElementInfo& info = elementInfo(block.type);
    const JacobianProbe probe(info);
    std::optional<JacobianProbe> fine;
    const std::size_t count = block.elementCount(), width = static_cast<std::size_t>(info.nodes);
    const auto report = [&](std::size_t e, MeshProblem::Kind kind, double value, const std::string& what) {
      MeshProblem problem = problemOf(mesh, {b, e}, kind, value);
      problem.text += what;
      problems.push_back(std::move(problem));
    };
    std::vector<std::int32_t> sorted(block.connectivity);
    for (std::size_t e = 0; e < count; ++e) {
      const std::int32_t* nodes = block.element(e);
      std::int32_t* own = sorted.data() + e * width;
      std::sort(own, own + width);
      if (!nodesInRange(mesh, nodes, info.nodes)) {
        const std::int32_t missing = own[0] < 0 ? own[0] : own[width - 1];
        report(
            e, MeshProblem::Kind::missingNode, missing,
            joinText("refers to a node that the mesh does not have (index ", missing, " of ", mesh.nodeCount(), ")"));
        continue;
      }
      if (const std::int32_t* twice = std::adjacent_find(own, own + width); twice != own + width) {
        report(e, MeshProblem::Kind::repeatedNode, static_cast<double>(nodeId(mesh, *twice)),
               joinText("holds node ", nodeId(mesh, *twice), " more than once; its nodes must differ"));
        continue;
      }
      JacobianRange range = probe.range(mesh.X, nodes);
      // Between the points of the probe an element may be folded whose determinant varies so much at them.
      constexpr double even = 0.3;
      if (range.min > 0 && range.min < even * range.max) {
        if (!fine) fine.emplace(info, JacobianPoints::fine);
        range.min = std::min(range.min, fine->range(mesh.X, nodes).min);
      }
      const double length = longestEdge(info, mesh.X, nodes);
      const double least = leastOf(info, length);  // a NaN belongs to its node, reported below
      const std::string order = range.min <= least || info.order > 1 ? otherOrder(mesh, info, probe, nodes) : "";
      if (range.min < -least)
        report(e, MeshProblem::Kind::inverted, range.min,
               joinText("is inverted: its Jacobian determinant is ", range.min, " m³; it must be above 0", order));
      else if (range.min <= least)
        report(e, MeshProblem::Kind::degenerate, range.min,
               joinText("is degenerate: its Jacobian determinant is ", range.min, " m³ with a longest edge of ", length,
                        " m; it must be above ", least, order, nodesAtOnePlace(mesh, info, nodes, length)));
      else if (!order.empty())  // of a tetrahedron, whose Jacobian determinant may stay above 0
        report(e, MeshProblem::Kind::inverted, range.min,
               joinText("is not what it should be: its Jacobian determinant is ", range.min, " m³", order));
    }
    std::vector<std::int32_t> order(count);
    std::iota(order.begin(), order.end(), 0);
    const auto key = [&](std::int32_t e) { return sorted.data() + static_cast<std::size_t>(e) * width; };
    std::sort(order.begin(), order.end(), [&](std::int32_t p, std::int32_t q) {
      const int c = [&] {
        for (std::size_t a = 0; a < width; ++a)
          if (key(p)[a] != key(q)[a]) return key(p)[a] < key(q)[a] ? -1 : 1;
        return 0;
      }();
      return c != 0 ? c < 0 : p < q;
    });
    for (std::size_t i = 1; i < count; ++i)
      if (std::equal(key(order[i]), key(order[i]) + width, key(order[i - 1])) &&
          nodesInRange(mesh, key(order[i]), info.nodes)) {
        const std::size_t other = order[i - 1];
        const std::int64_t otherId = block.id(other);
        report(order[i], MeshProblem::Kind::duplicateElement, static_cast<double>(otherId),
               joinText("has the same nodes as element ", otherId, ", and `ringwatch mesh repair` leaves it out"));
      }
  }
  const std::vector<bool> used = usedNodes(mesh);
  for (std::size_t n = 0; n < mesh.nodeCount(); ++n) {
    const std::int64_t id = nodeId(mesh, n);
    const std::int64_t index = n;
    for (int k = 0; k < 3; ++k)
      if (const double x = mesh.X(k, index); !std::isfinite(x)) {
        problems.push_back({MeshProblem::Kind::nonFinite,
                            -1,
                            index,
                            id,
                            {id},
                            x,
                            joinText("node ", id, " has the coordinate ", "xyz"[k], " = ", x, "; it must be finite")});
        break;
      }
    if (!used[n])
      problems.push_back({MeshProblem::Kind::unusedNode,
                          -1,
                          index,
                          id,
                          {id},
                          static_cast<double>(id),
                          joinText("node ", id, " belongs to no element")});
  }
  return problems;
}

std::vector<std::string> meshNotes(const Mesh& mesh, const std::string& source) {
  std::vector<std::string> notes;
  const MeshParts parts = connectedParts(mesh);
  if (parts.count > 1) {
    std::vector<std::int64_t> sizes(static_cast<std::size_t>(parts.count));
    for (const std::int32_t part : parts.partOfElement) ++sizes[part];
    std::sort(sizes.rbegin(), sizes.rend());
    sizes.resize(std::min(detail::shownParts, sizes.size()));
    notes.push_back(detail::partsNote(source, parts.count, sizes));
  }
  if (const detail::HangingNodes hanging = detail::hangingNodes(mesh, mesh.nodeCount()); hanging.count > 0)
    notes.push_back(detail::hangingNote(source, hanging.count, nodeId(mesh, hanging.first)));
  const std::vector<std::int32_t> at = detail::firstNodesAtPlaces(mesh, 0, true);
  std::int64_t same = 0;
  std::int32_t first = -1;
  for (std::int32_t n = 0; n < static_cast<std::int32_t>(at.size()); ++n)
    if (at[n] != n && same++ == 0) first = n;
  if (same > 0) notes.push_back(detail::coincidenceNote(source, same, nodeId(mesh, at[first]), nodeId(mesh, first)));
  const std::vector<std::int32_t> near = detail::firstNodesAtPlaces(mesh, 0, true, detail::Closeness::gap);
  std::int64_t gaps = 0;
  for (std::int32_t n = 0; n < static_cast<std::int32_t>(near.size()); ++n)
    if (near[n] != n && at[n] == n && gaps++ == 0) first = n;
  if (gaps > 0)
    notes.push_back(detail::gapNote(source, gaps, nodeId(mesh, near[first]), nodeId(mesh, first),
                                    (mesh.X.col(near[first]) - mesh.X.col(first)).norm()));
  return notes;
}

void requireSound(Mesh& mesh, const std::string& source, std::vector<std::string>* notes) {
  if (mesh.elementCount() == 0) throw InputError(source + ": there are no elements; a mesh of at least one is needed");
  detail::dropUnusedNodes(mesh, source, notes);
  const std::vector<MeshProblem> problems = detail::turnAndCheck(mesh, source, notes);
  if (problems.empty()) return;
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < std::min(detail::shownProblems, problems.size()); ++i) texts.push_back(problems[i].text);
  throw InputError(detail::problemsText(source, static_cast<std::int64_t>(problems.size()), texts));
}

namespace detail {

std::vector<double> distancesOfDoubles(const Mesh& mesh, Closeness closeness) {
  constexpr double shareOfGap = 1e-3, share = 1e-6, rounding = std::numeric_limits<float>::epsilon();
  std::vector<double> shortest(mesh.nodeCount(), infinity);
  for (const MeshBlock& block : mesh.blocks) {
    const ElementInfo& info = elementInfo(block.type);
    const int corners = cornerCount(info);
    for (std::size_t e = 0; e < block.elementCount(); ++e) {
      const std::int32_t* nodes = block.element(e);
      const double least = noLength * longestEdge(info, mesh.X, nodes);
      for (std::size_t i = 0; i < info.edges.size(); ++i) {
        const auto& edge = info.edges[i];
        const double length = (mesh.X.col(nodes[edge[1]]) - mesh.X.col(nodes[edge[0]])).norm();
        if (!(length > least)) continue;
        const auto see = [&](int node) { shortest[nodes[node]] = std::min(shortest[nodes[node]], length); };
        for (const int end : edge) see(end);
        if (const int middle = corners + static_cast<int>(i); middle < info.nodes) see(middle);
      }
    }
  }
  for (std::size_t n = 0; n < shortest.size(); ++n) {
    double& length = shortest[n];
    if (!(length < infinity))
      length = 0;
    else if (closeness == Closeness::gap)
      length *= shareOfGap;
    else
      length =
          std::min(shareOfGap * length,
                   std::max(share * length, rounding * mesh.X.col(static_cast<Eigen::Index>(n)).cwiseAbs().maxCoeff()));
  }
  return shortest;
}

std::uint64_t CoincidenceGrid::key(int level, std::int64_t i, std::int64_t j, std::int64_t k) {
  Fnv hash;
  hash.addNumbers(level, i, j, k);
  return hash.value();
}

double leastJacobian(const ElementInfo& info, const NodeVectors& X, const std::int32_t* nodes) {
  return leastOf(info, longestEdge(info, X, nodes));
}

void dropUnusedNodes(Mesh& mesh, const std::string& source, std::vector<std::string>* notes) {
  const std::vector<bool> used = usedNodes(mesh);
  const auto first = std::find(used.begin(), used.end(), false) - used.begin();
  const auto dropped = std::count(used.begin(), used.end(), false);
  if (dropped == 0) return;
  if (notes != nullptr)
    notes->push_back(droppedNodesNote(source, dropped, nodeId(mesh, static_cast<std::int32_t>(first))));
  keepUsedNodes(mesh);
}

std::vector<int> otherOrderOfMiddles(const Mesh& mesh, const ElementInfo& info, const std::int32_t* nodes) {
  const int corners = cornerCount(info);
  const auto count = static_cast<int>(info.edges.size());
  const auto distance = [&](int middle, int edge) {
    const auto& ends = info.edges[edge];
    return (mesh.X.col(nodes[corners + middle]) - (mesh.X.col(nodes[ends[0]]) + mesh.X.col(nodes[ends[1]])) / 2).norm();
  };
  constexpr double nearer = 0.25;  // a bent edge does not bring its middle so near to another's
  std::vector<int> edges;
  for (int i = 0; i < count; ++i) {
    int best = i;
    double least = nearer * distance(i, i);
    for (int edge = 0; edge < count; ++edge)
      if (const double other = distance(i, edge); other < least) best = edge, least = other;
    edges.push_back(best);
  }
  std::vector<int> sorted = edges;
  std::ranges::sort(sorted);
  // A middle that two nodes lie in is no order.
  const bool isOrder = std::ranges::adjacent_find(sorted) == sorted.end();
  return isOrder && edges != sorted ? edges : std::vector<int>();
}

std::string_view programOfOrder(const ElementInfo& info, const std::vector<int>& edges) {
  const int corners = cornerCount(info);
  std::vector<int> ofGmsh(edges.size(), -1);
  for (std::size_t i = 0; i < edges.size() && !info.gmshOrder.empty(); ++i)
    ofGmsh[info.gmshOrder[corners + i] - corners] = static_cast<int>(i);
  if (edges == ofGmsh) return "gmsh's";
  // Upright edges before those of the top.
  if (edges == std::vector<int>{0, 1, 2, 3, 8, 9, 10, 11, 4, 5, 6, 7}) return "Exodus' and Nastran's";
  return "another program's";
}

std::vector<std::int32_t> nodesOutOfRows(const Mesh& mesh, const ElementInfo& info, const JacobianProbe& probe,
                                         const std::int32_t* nodes) {
  constexpr int pyramid = 5, hexahedron = 8;  // nodes
  if (info.order != 1 || (info.nodes != hexahedron && info.nodes != pyramid)) return {};
  const auto isFolded = [&](const std::int32_t* own) {
    const JacobianRange range = probe.range(mesh.X, own);
    return !(range.min > 0) && !(range.max < 0);
  };
  if (!isFolded(nodes)) return {};
  std::vector<std::int32_t> round(nodes, nodes + info.nodes);
  std::swap(round[2], round[3]);
  if (info.nodes == hexahedron) std::swap(round[6], round[7]);
  if (isFolded(round.data())) return {};
  return round;
}

std::vector<std::int32_t> firstNodesAtPlaces(const Mesh& mesh, double near, bool ofElements, Closeness closeness) {
  std::vector<std::int32_t> at(mesh.nodeCount());
  std::iota(at.begin(), at.end(), 0);
  if (mesh.nodeCount() == 0) return at;
  const std::vector<bool> used = usedNodes(mesh);
  if (!mesh.X.allFinite()) return at;
  CoincidenceGrid grid(near);
  std::vector<double> distances = distancesOfDoubles(mesh, closeness);
  std::vector<int> levels;
  for (std::size_t n = 0; n < distances.size(); ++n) {
    distances[n] = grid.distance(mesh.X.col(static_cast<Eigen::Index>(n)), distances[n]);
    if (distances[n] > 0) levels.push_back(CoincidenceGrid::levelOf(distances[n]));
  }
  sortUnique(levels);
  grid.setLevels(std::move(levels));
  std::unordered_map<std::uint64_t, std::int32_t> lastOfCell;
  lastOfCell.reserve(mesh.nodeCount());
  std::vector<std::int32_t> before(mesh.nodeCount(), -1);  // the node of the same cell that was entered before
  for (std::size_t n = 0; n < mesh.nodeCount(); ++n) {
    if ((ofElements && !used[n]) || distances[n] == 0) continue;
    const std::int32_t index = n;
    const Eigen::Vector3d X = mesh.X.col(index);
    // A node is entered in its own cell and sought in all cells that its neighbourhood touches.
    double nearest = infinity;
    grid.forEachCellNear(X, distances[n], [&](std::uint64_t cell) {
      const auto last = lastOfCell.find(cell);
      for (std::int32_t other = last == lastOfCell.end() ? -1 : last->second; other >= 0; other = before[other]) {
        const double apart = (mesh.X.col(other) - X).norm();
        if (apart > std::min(distances[other], distances[n])) continue;
        if (apart < nearest || (apart == nearest && other < at[n])) at[n] = other;
        nearest = std::min(nearest, apart);
      }
      return false;
    });
    if (at[n] != index) continue;
    const auto [entry, isNew] = lastOfCell.try_emplace(grid.cellOf(X, distances[n]), index);
    if (!isNew) before[n] = std::exchange(entry->second, index);
  }
  return at;
}

std::vector<std::int64_t> turnMirrored(Mesh& mesh) {
  std::vector<std::int64_t> turned;
  for (MeshBlock& block : mesh.blocks) {
    const ElementInfo& info = elementInfo(block.type);
    const JacobianProbe probe(info);
    std::vector<int> mirror;
    turned.push_back(0);
    for (std::size_t e = 0; e < block.elementCount(); ++e) {
      std::int32_t* nodes = block.connectivity.data() + e * static_cast<std::size_t>(info.nodes);
      if (!nodesInRange(mesh, nodes, info.nodes) || !(probe.range(mesh.X, nodes).max < 0)) continue;
      if (mirror.empty()) mirror = mirrorPermutation(info);
      const std::vector<std::int32_t> before(nodes, nodes + info.nodes);
      for (std::size_t a = 0; a < mirror.size(); ++a) nodes[a] = before[mirror[a]];
      ++turned.back();
    }
  }
  return turned;
}

std::vector<std::string> turnedNotes(const Mesh& mesh, const std::vector<std::int64_t>& turned,
                                     const std::vector<std::int64_t>& counts, const std::string& source) {
  constexpr std::string_view what = " are of the other handedness and were turned round";
  const std::int64_t all = std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
  if (all > 0 && turned == counts) return {joinText(source, ": all ", all, " elements", what)};
  std::vector<std::string> notes;
  for (std::size_t b = 0; b < counts.size(); ++b) {
    if (turned[b] == 0) continue;
    notes.push_back(joinText(source, ": ", turned[b] == counts[b] ? "all " : joinText(turned[b], " of "), counts[b],
                             " ", elementInfo(mesh.blocks[b].type).name, what));
  }
  return notes;
}

std::vector<MeshProblem> overlaps(const Mesh& mesh, const std::function<bool(std::span<const std::int32_t>)>& told) {
  std::vector<MeshProblem> problems;
  for (const MeshBlock& block : mesh.blocks)
    for (std::size_t e = 0; e < block.elementCount(); ++e)
      if (!nodesInRange(mesh, block.element(e), block.nodesPerElement())) return problems;  // checkMesh names it
  const auto cornersOf = [&](const ElementFace& at) {
    const MeshBlock& block = mesh.blocks[at.block];
    std::vector<std::int32_t> corners;
    for (const int corner : elementInfo(block.type).faces[at.face])
      if (corner >= 0) corners.push_back(block.element(at.element)[corner]);
    return corners;
  };
  const FaceNeighbours neighbours = faceNeighbours(mesh);
  const std::vector<std::size_t> first = blockOffsets(mesh);
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
    for (std::size_t f = 0; f < elementInfo(mesh.blocks[b].type).faces.size(); ++f)
      for (std::size_t e = 0; e < mesh.blocks[b].elementCount(); ++e) {
        const ElementFace other = neighbours.rows.row(first[b] + e)[f];
        const ElementRef own(b, e);
        if (other.element < 0 || ElementRef(other.block, other.element) > own) continue;  // told of the later one
        const std::vector<std::int32_t> corners = cornersOf({own.block, own.element, static_cast<std::int32_t>(f)});
        std::vector<std::int32_t> theirs = cornersOf(other);
        std::rotate(theirs.begin(), std::find(theirs.begin(), theirs.end(), corners[0]), theirs.end());
        if (theirs[1] != corners[1] || (told && !told(corners))) continue;  // neighbours go round a face either way
        MeshProblem problem = problemOf(mesh, own, MeshProblem::Kind::inverted, static_cast<double>(f));
        problem.text += joinText("is inverted: it lies on the same side of a face as element ",
                                 mesh.blocks[other.block].id(static_cast<std::size_t>(other.element)));
        problems.push_back(std::move(problem));
      }
  return problems;
}

std::vector<MeshProblem> turnAndCheck(Mesh& mesh, const std::string& source, std::vector<std::string>* notes) {
  std::vector<std::int64_t> counts;
  for (const MeshBlock& block : mesh.blocks) counts.push_back(static_cast<std::int64_t>(block.elementCount()));
  const std::vector<std::int64_t> turned = turnMirrored(mesh);
  std::vector<MeshProblem> problems = checkMesh(mesh);
  if (isPartlyTurned(turned, counts)) {
    std::vector<MeshProblem> folded = overlaps(mesh, nullptr);
    problems.insert(problems.end(), folded.begin(), folded.end());
  }
  if (notes != nullptr)
    for (std::string& note : turnedNotes(mesh, turned, counts, source)) notes->push_back(std::move(note));
  return problems;
}

std::string droppedNodesNote(const std::string& source, std::int64_t dropped, std::int64_t firstId) {
  return joinText(source, ": ", dropped, " nodes that no element uses are dropped, the first is node ", firstId);
}

std::string problemsText(const std::string& source, std::int64_t count, const std::vector<std::string>& texts) {
  std::string text = joinText(source, ": ", count, count == 1 ? " problem: " : " problems: ");
  for (std::size_t i = 0; i < texts.size(); ++i) text += (i > 0 ? "; " : "") + texts[i];
  if (count > static_cast<std::int64_t>(texts.size()))
    text += joinText("; … run `ringwatch mesh check --all ", source, "` for all of them");
  return text;
}

std::string partsNote(const std::string& source, std::int64_t count, const std::vector<std::int64_t>& sizes) {
  std::string list;
  for (std::size_t i = 0; i < sizes.size(); ++i) list += joinText(i > 0 ? ", " : "", sizes[i]);
  return joinText(source, ": the mesh falls into ", count, " parts that share no node, of ", list,
                  count > static_cast<std::int64_t>(sizes.size()) ? ", … elements" : " elements",
                  "; they move independently");
}

HangingNodes hangingNodes(const Mesh& mesh, std::size_t nodes) {
  HangingNodes hanging;
  const CompressedRows<ElementNode> incidence = nodeElements(mesh);
  const auto cornersOf = [&](const ElementNode& at) {
    const MeshBlock& block = mesh.blocks[at.block];
    return std::span(block.element(at.element), static_cast<std::size_t>(cornerCount(elementInfo(block.type))));
  };
  std::vector<std::size_t> markedBy(mesh.nodeCount(), 0);  // the last element whose corners were marked, from 1
  std::size_t mark = 0;
  std::vector<ElementNode> reached, apart;
  for (std::size_t n = 0; n < nodes; ++n) {
    const auto around = incidence.row(n);
    // The middle of an edge is where its ends are, if anywhere.
    const auto isCorner = [&](const ElementNode& at) {
      return static_cast<std::size_t>(at.localNode) < cornersOf(at).size();
    };
    if (around.size() < 2 || !std::ranges::all_of(around, isCorner)) continue;
    reached.assign(around.begin(), around.begin() + 1);
    apart.assign(around.begin() + 1, around.end());
    for (std::size_t i = 0; i < reached.size() && !apart.empty(); ++i) {
      ++mark;
      for (const std::int32_t corner : cornersOf(reached[i])) markedBy[corner] = mark;
      // Three common corners are a face, or the part of one that a smaller face meets.
      std::erase_if(apart, [&](const ElementNode& other) {
        const auto common =
            std::ranges::count_if(cornersOf(other), [&](std::int32_t c) { return markedBy[c] == mark; });
        if (common >= 3) reached.push_back(other);
        return common >= 3;
      });
    }
    if (!apart.empty() && hanging.count++ == 0) hanging.first = static_cast<std::int32_t>(n);
  }
  return hanging;
}

std::string hangingNote(const std::string& source, std::int64_t count, std::int64_t firstId) {
  return joinText(source, ": at ", count, count == 1 ? " node" : " nodes", ", the first is node ", firstId,
                  ", elements meet that share no face there: parts hang together by an edge or a node alone, and turn "
                  "against each other there");
}

std::string coincidenceNote(const std::string& source, std::int64_t count, std::int64_t firstId,
                            std::int64_t secondId) {
  return joinText(source, ": ", count, count == 1 ? " node lies" : " nodes lie",
                  " where another node lies, e.g. nodes ", firstId, " and ", secondId,
                  "; elements are not joined there, and `ringwatch mesh repair --join 0` joins them");
}

std::string gapNote(const std::string& source, std::int64_t count, std::int64_t firstId, std::int64_t secondId,
                    double apart) {
  return joinText(source, ": ", count, count == 1 ? " node lies" : " nodes lie",
                  " closer than a thousandth of an edge to another, e.g. nodes ", firstId, " and ", secondId, ", ",
                  apart,
                  " m apart; elements are not joined there, as at a crack or a contact, and `ringwatch mesh repair "
                  "--join DISTANCE` joins nodes that are closer");
}

}  // namespace detail

}  // namespace ringwatch

#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <ringwatch/meshes/check.h>
#include <ringwatch/meshes/quality.h>

namespace ringwatch::detail {

// What requireSound and meshNotes are made of, for a mesh that several processes have parts of.

/// Turns round each element whose Jacobian determinant is negative everywhere. Returns their number in each block.
std::vector<std::int64_t> turnMirrored(Mesh& mesh);
/// counts: elements of each block.
inline bool isPartlyTurned(const std::vector<std::int64_t>& turned, const std::vector<std::int64_t>& counts) {
  return turned != counts && std::ranges::any_of(turned, [](std::int64_t n) { return n > 0; });
}
std::vector<std::string> turnedNotes(const Mesh& mesh, const std::vector<std::int64_t>& turned,
                                     const std::vector<std::int64_t>& counts, const std::string& source);
/// Elements that lie on the same side of a face as their neighbour there: what turnMirrored makes of an element that is
/// folded over and not only numbered the other way, by block, face (their value) and element. told: which are wanted,
/// by the corners of the face; empty for all.
std::vector<MeshProblem> overlaps(const Mesh& mesh, const std::function<bool(std::span<const std::int32_t>)>& told);
/// turnMirrored, then all that checkMesh finds, and overlaps where some elements alone were turned.
std::vector<MeshProblem> turnAndCheck(Mesh& mesh, const std::string& source, std::vector<std::string>* notes);
/// For each node in the middle of an edge of a quadratic element the edge in whose middle it lies: its own, unless
/// another's middle is four times nearer. Empty where each lies in its own, and where two lie in one: only another
/// program's order is told.
std::vector<int> otherOrderOfMiddles(const Mesh& mesh, const ElementInfo& info, const std::int32_t* nodes);
/// Whose order of the nodes on edges this is: "gmsh's", "Exodus' and Nastran's", "another program's". edges: as of
/// otherOrderOfMiddles.
std::string_view programOfOrder(const ElementInfo& info, const std::vector<int>& edges);
/// The nodes of a linear hexahedron or pyramid that is folded because its quadrilaterals go in rows where they should
/// go round, as VTK's voxels do, in our order; empty for another element. probe: of its type.
std::vector<std::int32_t> nodesOutOfRows(const Mesh& mesh, const ElementInfo& info, const JacobianProbe& probe,
                                         const std::int32_t* nodes);
/// How close nodes are. atOnePlace: as far apart as rounding brings a node of two parts. gap: up to a thousandth of an
/// edge, as a crack or a contact may have, and a file of six digits.
enum class Closeness { atOnePlace, gap };
/// For each node the nearest one before it that lies closer to it than `near` (m) or so close that
/// distancesOfDoubles() tells both, itself where none does. ofElements: only nodes of elements count.
std::vector<std::int32_t> firstNodesAtPlaces(const Mesh& mesh, double near, bool ofElements,
                                             Closeness closeness = Closeness::atOnePlace);
/// The least Jacobian determinant of a sound element, m³.
double leastJacobian(const ElementInfo& info, const NodeVectors& X, const std::int32_t* nodes);
/// Drops the nodes that no element uses, with a note.
void dropUnusedNodes(Mesh& mesh, const std::string& source, std::vector<std::string>* notes);
std::string droppedNodesNote(const std::string& source, std::int64_t dropped, std::int64_t firstId);
/// Problems whose texts are told, of several.
constexpr std::size_t shownProblems = 3;
/// count: of all problems; texts: the first of them, at most shownProblems.
std::string problemsText(const std::string& source, std::int64_t count, const std::vector<std::string>& texts);
/// Sizes that are told, of several parts.
constexpr std::size_t shownParts = 5;
/// sizes: elements of the largest parts, descending, at most shownParts.
std::string partsNote(const std::string& source, std::int64_t count, const std::vector<std::int64_t>& sizes);
/// Nodes around which elements fall into several groups that share no face there.
struct HangingNodes {
  std::int64_t count = 0;
  std::int32_t first = -1;
};
/// Among so many nodes, the first ones of the mesh, which has all of their elements.
HangingNodes hangingNodes(const Mesh& mesh, std::size_t nodes);
std::string hangingNote(const std::string& source, std::int64_t count, std::int64_t firstId);
std::string coincidenceNote(const std::string& source, std::int64_t count, std::int64_t firstId, std::int64_t secondId);
/// Of nodes that have a gap between them. apart: of the two, m.
std::string gapNote(const std::string& source, std::int64_t count, std::int64_t firstId, std::int64_t secondId,
                    double apart);

/// The distance, m, up to which another node is so close to each: of a gap a thousandth of the shortest edge there that
/// has a length, more than a billionth of its element's longest; at one place a millionth of it, or the rounding of its
/// coordinates in single precision where that is more, within a gap; 0 where no edge has a length. Two nodes are so
/// close where both say so; no sound element has two of its own.
std::vector<double> distancesOfDoubles(const Mesh& mesh, Closeness closeness);
/// Cells of space in which nodes are sought that lie at one place: cells of several sizes, since elements are.
class CoincidenceGrid {
 public:
  /// near: m, up to which nodes lie at one place in any case. Without levels.
  explicit CoincidenceGrid(double near) : near_(near) {}
  /// Up to which distance, m, others lie at the place of a node, of which distancesOfDoubles() gives the last argument:
  /// no less than rounding of its coordinates.
  double distance(const Eigen::Vector3d& X, double ofDoubles) const {
    constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
    return std::max({near_, rounding * X.cwiseAbs().maxCoeff(), ofDoubles});
  }
  /// The size of the cells that a node of this distance is entered in; none for distance 0.
  static int levelOf(double distance) { return static_cast<int>(std::floor(std::logb(distance) / doublings)); }
  /// The levels of all nodes that are entered.
  void setLevels(std::vector<int> levels) { levels_ = std::move(levels); }

  /// A number for the cell that a node is entered in. Cells that lie apart may have the same one.
  std::uint64_t cellOf(const Eigen::Vector3d& X, double distance) const {
    const int level = levelOf(distance);
    return key(level, at(level, X, 0, 0), at(level, X, 1, 0), at(level, X, 2, 0));
  }
  /// Calls visit(cell) for all cells in which nodes at the place of one may have been entered, until it returns true.
  template <class Visit>
  void forEachCellNear(const Eigen::Vector3d& X, double distance, const Visit& visit) const {
    for (const int level : levels_) {
      const double reach = std::min(distance, mostOf(level));
      for (std::int64_t i = at(level, X, 0, -reach); i <= at(level, X, 0, reach); ++i)
        for (std::int64_t j = at(level, X, 1, -reach); j <= at(level, X, 1, reach); ++j)
          for (std::int64_t k = at(level, X, 2, -reach); k <= at(level, X, 2, reach); ++k)
            if (visit(key(level, i, j, k))) return;
    }
  }

 private:
  /// From level to level distances are 2^6 times as large: a thousandth of an edge stays well below an edge.
  static constexpr int doublings = 6;
  static double mostOf(int level) { return std::ldexp(1, doublings * (level + 1)); }
  /// Cells are twice as large as the largest distance of their level, so that few nodes lie near their faces.
  std::int64_t at(int level, const Eigen::Vector3d& X, int axis, double offset) const {
    return static_cast<std::int64_t>(std::floor((X[axis] + offset) / (2 * mostOf(level))));
  }
  static std::uint64_t key(int level, std::int64_t i, std::int64_t j, std::int64_t k);

  double near_;
  std::vector<int> levels_;
};

}  // namespace ringwatch::detail

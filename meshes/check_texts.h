#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
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
/// For each node the first one that lies closer to it than `near` (m) or distanceOfDoubles(), itself where none does.
/// ofElements: only nodes of elements count.
std::vector<std::int32_t> firstNodesAtPlaces(const Mesh& mesh, double near, bool ofElements);
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

/// The distance, m, up to which nodes lie at one place: a thousandth of the shortest edge that has a length, infinite
/// where none has. Files of six digits or in single precision have twice the same node so far apart, and no sound
/// element two of its own.
double distanceOfDoubles(const Mesh& mesh);
/// Cells of space in which nodes are sought that lie closer to each other than `near` or 1e-9 of the diagonal of the
/// bounding box.
class CoincidenceGrid {
 public:
  /// low, high: corners of the box, m.
  CoincidenceGrid(const Eigen::Vector3d& low, const Eigen::Vector3d& high, double near)
      : low_(low),
        diagonal_((high - low).norm()),
        near_(std::max(1e-9 * diagonal_, near)),
        cell_(std::max(1e-6 * diagonal_, 2 * near_)) {}
  /// False for a box without a size, and without edges.
  bool exists() const { return near_ > 0 && std::isfinite(diagonal_ + near_); }
  /// m
  double near() const { return near_; }
  std::uint64_t cellOf(const Eigen::Vector3d& X) const { return key(at(X, 0, 0), at(X, 1, 0), at(X, 2, 0)); }
  /// Calls visit(cell) for all cells that the neighbourhood of a place touches, until it returns true.
  template <class Visit>
  void forEachCellNear(const Eigen::Vector3d& X, const Visit& visit) const {
    for (std::uint64_t i = at(X, 0, -near_); i <= at(X, 0, near_); ++i)
      for (std::uint64_t j = at(X, 1, -near_); j <= at(X, 1, near_); ++j)
        for (std::uint64_t k = at(X, 2, -near_); k <= at(X, 2, near_); ++k)
          if (visit(key(i, j, k))) return;
  }

 private:
  /// Cells are numbered from 1 to 1e6 + 1 along each axis, 21 bits.
  std::uint64_t at(const Eigen::Vector3d& X, int axis, double offset) const {
    return static_cast<std::uint64_t>(std::floor((X[axis] - low_[axis] + offset) / cell_) + 1);
  }
  static std::uint64_t key(std::uint64_t i, std::uint64_t j, std::uint64_t k) { return i << 42 | j << 21 | k; }

  Eigen::Vector3d low_;
  double diagonal_, near_;
  double cell_;  // larger than near_, so that few nodes lie near its faces, and smaller than elements
};

}  // namespace ringwatch::detail

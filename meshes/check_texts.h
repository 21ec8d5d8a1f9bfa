#pragma once
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <ringwatch/meshes/check.h>

namespace ringwatch::detail {

// What requireSound and meshNotes are made of, for a mesh that several processes have parts of.

/// True when every element of the block is of the other handedness; also of a block without elements.
bool isMirrored(const Mesh& mesh, const MeshBlock& block);
/// Turns round blocks of the other handedness, or of an element type that may be of either. mirrored: isMirrored of
/// each block of the whole mesh; counts: elements of each in the whole. Returns notes.
std::vector<std::string> turnRound(Mesh& mesh, const std::vector<bool>& mirrored,
                                   const std::vector<std::int64_t>& counts, const std::string& source);
std::string droppedNodesNote(const std::string& source, std::int64_t dropped, std::int64_t firstId);
/// Problems whose texts are told, of several.
constexpr std::size_t shownProblems = 3;
/// count: of all problems; texts: the first of them, at most shownProblems.
std::string problemsText(const std::string& source, std::int64_t count, const std::vector<std::string>& texts);
/// Sizes that are told, of several parts.
constexpr std::size_t shownParts = 5;
/// sizes: elements of the largest parts, descending, at most shownParts.
std::string partsNote(const std::string& source, std::int64_t count, const std::vector<std::int64_t>& sizes);
std::string coincidenceNote(const std::string& source, std::int64_t count, std::int64_t firstId, std::int64_t secondId);

/// Cells of space in which nodes are sought that lie closer to each other than 1e-9 of the diagonal of the bounding
/// box.
class CoincidenceGrid {
 public:
  /// low, high: corners of the box, m.
  CoincidenceGrid(const Eigen::Vector3d& low, const Eigen::Vector3d& high)
      : low_(low), diagonal_((high - low).norm()), near_(1e-9 * diagonal_), cell_(1e-6 * diagonal_) {}
  /// False for a box without a size.
  bool exists() const { return near_ > 0 && std::isfinite(diagonal_); }
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
  double cell_;  // much larger than near_, so that few nodes lie near its faces, and much smaller than elements
};

}  // namespace ringwatch::detail

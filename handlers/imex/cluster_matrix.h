#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include <ringwatch/base/aligned.h>
#include <ringwatch/base/matrix3.h>
#include <ringwatch/base/pack.h>
#include <ringwatch/body/body.h>

namespace ringwatch {

/// A symmetric matrix of 3×3 blocks by node pair i <= j in compressed rows, the diagonal first in each: eight entries
/// of a block, column by column, and the ninth, as `addBlocks` wants them. One block more takes what belongs nowhere.
struct UpperBlocks {
  std::vector<std::int32_t> rowBegin, column;
  AlignedVector<double> eight, ninth;

  std::int32_t rows() const { return static_cast<std::int32_t>(rowBegin.size()) - 1; }
  Eigen::Matrix3d block(std::int32_t k) const;
  void set(std::size_t k, const Eigen::Matrix3d& B) {
    std::copy_n(B.data(), 8, eight.data() + 8 * k);
    ninth[k] = B(2, 2);
  }
};

/// Tolerances of the rotation of an element against the one that its matrix was made with. docs/handlers.md and
/// docs/gpu.md tell them too; tests/handlers/implicit_cluster_test.cpp holds both to these values.
///
/// In directions that K̂ takes for soft, the true stiffness shows with θ² of itself, and the scheme is stable as long as
/// h² λ θ² < 4 there. A sixth of that is allowed, since the elements at a node add up.
inline constexpr double rotationShare = 2.0 / 3;
/// Rad. K̂ is then off by θ², a quarter of a percent, which is not worth a new factor.
inline constexpr double leastRotation = 0.05;
/// Rad. K̂ is then off by 4 %, and beyond, angles are no longer small, which the estimate above takes them to be.
inline constexpr double mostRotation = 0.2;

/// M + w K̂ of a cluster of elements (see ImplicitCluster) in a rotating frame, kept current batch by batch: a batch of
/// elements is turned again when one of them has turned or stretched beyond its tolerance, the difference of its
/// tangents added. Sums are in double precision: after 10⁵ such changes they are off by some 10⁻¹³ of themselves.
///
/// An element may be off by the angle θ with h² λ θ² <= `rotationShare`, λ >= K_e/M_e at rest, but by `leastRotation`
/// at least and `mostRotation` at most. Shape enters through the rotation alone, but for laws that stiffen. Diagonal
/// blocks are minus the sums of their rows', so that K̂ leaves translations at rest to rounding.
class ClusterMatrix {
 public:
  /// nodes: of the elements, ascending; rows are in their order. w: s². The body must outlive it.
  ClusterMatrix(const Body& body, const std::vector<ElementRef>& elements, const std::vector<std::int32_t>& nodes,
                double w);

  /// Whether all laws are objective. Elements of others are never turned and must not be given another frame than the
  /// identity.
  bool objective() const;
  const UpperBlocks& blocks() const { return upper_; }
  /// Rows that have changed; the one that copies them clears them.
  std::vector<std::uint8_t>& changed() { return changed_; }

  /// Turns all elements to positions x (3×N, m) seen from the frame. False when the matrix would not be finite; it is
  /// then as before.
  bool make(const NodeVectors& x, const Eigen::Matrix3d& frame);
  enum class Change { none, some, notFinite };
  /// Turns the elements that need it, and all as soon as one does if `whole`. Not finite: the matrix is as before. A
  /// part of the elements that moves slowly is examined only every fourth call at least.
  Change follow(const NodeVectors& x, const Eigen::Matrix3d& frame, bool whole);

 private:
  using P = NativePack;
  /// Elements that are examined together, with the nodes that they read.
  struct Chunk {
    std::int32_t batchBegin, batchEnd;
    std::int32_t nodeBegin, nodeEnd;
    int wait = 1, waited = 1;  // calls until the next observation, and between the last two
  };
  /// The elements of a mesh block, in packs.
  struct Group {
    const ElementBlock* block = nullptr;
    std::int32_t blockNumber = 0;  // in the body
    int n = 0, pairs = 0;          // nodes, and pairs a <= b, of an element
    bool objective = true, stiffens = false;
    std::vector<Chunk> chunks;
    std::vector<std::int32_t> nodes;        // of the chunks: rows
    std::vector<std::int32_t> elements;     // [batch][lane]; -1: none
    std::vector<std::uint16_t> localNodes;  // [batch][a][lane] position in the chunk's nodes
    std::vector<std::int32_t> places;       // [batch][a <= b][lane] as `addBlocks` wants them
    AlignedVector<P> fittedGradient;        // [batch][a][3]: F = Σ x_a gradient_a, fitted to the nodes; 1/m
    AlignedVector<P> rest;                  // [batch][a < b][9] of K_e(X), N/m
    AlignedVector<P> restHighest;           // [batch] highest eigenvalue of K_e(X), N/m
    AlignedVector<P> slack;                 // [batch] tolerance of the rotation, squared
    AlignedVector<P> gone;                  // [batch] share of the tolerance used up at the last observation
    AlignedVector<Matrix3<P>> rotation;     // [batch] R in the matrix
    AlignedVector<P> stretch;               // [batch] |F|² then
    AlignedVector<P> scale;                 // [batch] w s_e in the matrix
  };
  struct Rotation {
    Matrix3<P> R;
    P stretch, scale;
    Group* group;
    std::int32_t batch;
  };
  void addGroup(std::int32_t block, std::vector<std::int32_t> elements);
  void fillGroup(Group& g);
  void addChunk(Group& g, std::int32_t batchBegin, std::int32_t batchEnd);
  void gather(const Group& g, const Chunk& c, const NodeVectors& x, const Eigen::Matrix3d& frame);
  Matrix3<P> gradientOf(const Group& g, std::int32_t batch) const;
  bool follow(Group& g, Chunk& c, const NodeVectors& x, const Eigen::Matrix3d& frame, double stretch);
  bool stiffen(Rotation& rotation, const NodeVectors& x);
  void add(const Rotation& rotation, bool fromScratch);

  const Body& body_;
  double w_;
  std::vector<std::int32_t> nodes_;
  UpperBlocks upper_;
  std::vector<std::uint8_t> changed_;
  std::vector<Group> groups_;
  // Scratch.
  AlignedVector<double> table_;
  AlignedVector<Rotation> rotations_;
  AlignedVector<P> K_, sums_;
};

}  // namespace ringwatch

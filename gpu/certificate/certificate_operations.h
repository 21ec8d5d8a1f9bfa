#pragma once
#include <cstdint>

#include <ringwatch/gpu/body/patch_operations.h>

namespace ringwatch {

/// What is said about the steps checked so far.
struct CertificateFlags {
  std::int64_t checked;          // steps
  std::int64_t lostAt;           // the first of them that is not certified; -1: none
  unsigned long long evaluated;  // elements evaluated again
  unsigned nearlyLost;           // an element has come close to its allowance
};

/// The certificate of a block: frozen weights, allowances and balls of its elements; see NodalBound and
/// IncrementalNodalBound. Elements are [patch][thread] = place.
struct CertificateView {
  double* weights = nullptr;     // [patch][6 node + entry][thread], Symmetric3
  double* value = nullptr;       // [place] l_e when last evaluated
  double* allowance = nullptr;   // [place]
  double* strainNorm = nullptr;  // [place] lambda_max(D⁻¹ Σ w BᵀB)
  /// F0 of every point and the radius in half precision, 20 bytes a point; what rounding takes is taken off the radius.
  /// Pairs of numbers, [patch][point][5][thread]: F0 row by row, then, with the first point, the radius; < 0: always
  /// left.
  std::uint32_t* balls = nullptr;
  /// A matrix C of each element and a radius s within which its gradients at all points may lie from it while they are
  /// in their ball (Theorem 19, docs/theory/incremental_certificate.md), [patch][5][thread]: what a step reads. Of
  /// elements of one point the ball itself.
  std::uint32_t* centres = nullptr;
  // Elements that left their balls in a step.
  std::int32_t* outsidePlace = nullptr;  // [capacity]
  double* outsideF = nullptr;            // [capacity][point][9]
  unsigned* outsideCount = nullptr;      // may exceed the capacity: then some are not listed
  /// Their new balls, [capacity][ball][5], a ball a point and behind them the centre, or one ball alone, to be put in
  /// place when no step reads; nullptr where none reads while they are made.
  std::uint32_t* newBalls = nullptr;
  unsigned* done = nullptr;  // thread blocks that have finished
  std::int32_t capacity = 0;
  CertificateFlags* flags = nullptr;
  bool countsSteps = false;  // of all blocks one does
};

/// Nodal sums of the certificate, by device node.
struct NodalSums {
  double* slots = nullptr;              // [slot][6]
  double* sums = nullptr;               // [node][6] S_i, Symmetric3
  double* factors = nullptr;            // [node][6] R_i
  double* nodal = nullptr;              // [node] lambda_max(S_i)
  unsigned long long* bound = nullptr;  // the largest of them, as the bits of a double
};

/// What a launch of the certificate works on.
struct CertificateArguments {
  const BlockView<double>& block;
  const NodeView<double>& nodes;
  const LawParameters& law;
  const CertificateView& view;
  const NodalSums& sums;
  double sigma;  // rad²/s²
  cudaStream_t stream;
};

/// The launches of the certificate, by element type and law, in double precision.
struct CertificateOperations {
  using Launch = void (*)(const CertificateArguments&);
  Launch start = nullptr;       // weights, from the diagonal blocks
  Launch evaluate = nullptr;    // values, with the weights
  Launch sweep = nullptr;       // weights ← R D R
  Launch distribute = nullptr;  // allowances for sigma, balls around here
  Launch step = nullptr;        // force, step and ball test in one pass
  Launch refresh = nullptr;     // the elements that have left: values, and balls to come
};
/// Balls that are stored of an element of so many points.
constexpr int ballsOfPoints(int points) { return points > 1 ? points + 1 : 1; }
CertificateOperations certificateOperations(ElementType type, std::size_t law);

/// The list of a block's elements that had left their balls, and where the new ones belong.
struct BallPlacement {
  CertificateView view;
  std::int32_t threads = 0, points = 0;  // of a patch, and at which geometry is stored
};
/// Of all blocks, in device memory.
struct BallPlacements {
  const BallPlacement* first = nullptr;
  int count = 0;
  unsigned* done = nullptr;  // thread blocks that have finished
};
/// Ends a step as launchFinishStep() does; beside that, puts the new balls of listed elements in place, and clears
/// their lists.
void launchFinishStepAndPlace(const NodeView<double>& nodes, const BallPlacements& placements, cudaStream_t stream);
/// Puts the balls in place alone.
void launchPlaceBalls(const BallPlacements& placements, cudaStream_t stream);

/// Σ_e values D_(e,a) at the patches' nodes, into slots and sums.
void launchGatherWeights(const BlockView<double>& block, const NodeView<double>& nodes, const CertificateView& view,
                         const NodalSums& sums, int elementNodes, const double* values, cudaStream_t stream);
/// S_i of all nodes, their largest eigenvalues and the largest of those; then, with `factors`, R_i for a sweep at the
/// bound found by an earlier call.
void launchBoundNodes(const NodeView<double>& nodes, const NodalSums& sums, cudaStream_t stream);
void launchSweepFactors(const NodeView<double>& nodes, const NodalSums& sums, double bound, cudaStream_t stream);

}  // namespace ringwatch

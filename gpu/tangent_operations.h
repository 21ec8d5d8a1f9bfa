#pragma once
#include <cstdint>

#include <ringwatch/gpu/body/patch_operations.h>
#include <ringwatch/gpu/imex/imex_operations.h>
#include <ringwatch/gpu/rings/ring_plan.h>

namespace ringwatch {

/// Node pairs of a block of four-node tetrahedra; see RingBlockPlan.
struct RingBlockView {
  std::int32_t pairCapacity = 0, rowCapacity = 0;
  const RingPatch* patches = nullptr;
  const std::uint8_t* order = nullptr;
  const std::uint16_t* pairs = nullptr;
  const std::int32_t* groupRow = nullptr;
  const std::uint16_t* rows = nullptr;
};

/// M^-½ K M^-½ by node pair, 3×3 row by row, without constrained rows and columns: rad²/s².
struct RingView {
  std::int32_t pairCount = 0, ownCount = 0, slotCount = 0;
  double* pair = nullptr;   // [9][pairCount]
  double* slots = nullptr;  // [9][slotCount] a patch's part of shared pairs
  const std::int32_t* slotPair = nullptr;
  const std::int32_t* sharedBegin = nullptr;
  const std::int32_t* sharedSlot = nullptr;
};

/// A thread block's highest ring, lowered by rounding; NaN above all.
struct HighestRing {
  double value;
  std::int32_t place;  // [patch][thread]
};

/// The launches that need an element's tangent, by element type and law, in double precision.
struct TangentOperations {
  /// The pairs of the patches' tangents: own ones into pair, others into slots. nullptr: not for this element type.
  void (*assembleRings)(const BlockView<double>&, const NodeView<double>&, const LawParameters&, const RingBlockView&,
                        const RingView&, cudaStream_t) = nullptr;
  /// K_e(X) and its highest eigenvalue for the implicit elements of a block.
  void (*restTangents)(const BlockView<double>&, const LawParameters&, const ImexElementsView&, const ImexView&,
                       cudaStream_t) = nullptr;
  /// R_e and w s_e at the displacements that launchKeepNodes kept.
  void (*rotateTangents)(const BlockView<double>&, const LawParameters&, const ImexElementsView&, const ImexView&,
                         cudaStream_t) = nullptr;
};
TangentOperations tangentOperations(ElementType type, std::size_t law);

/// Sums the slots of shared pairs.
void launchSumPairs(const RingView& view, cudaStream_t stream);
/// Largest eigenvalue of every ring, rad²/s², [patch][thread], and the highest of each of ringBlocks() thread blocks.
void launchRingEigenvalues(const BlockView<double>& block, const RingBlockView& ring, const RingView& view,
                           double* largest, HighestRing* highest, cudaStream_t stream);
inline constexpr int ringThreads = 128;
constexpr std::int32_t ringBlocks(std::int32_t patches) { return patches * (patchThreads(4) / ringThreads); }

}  // namespace ringwatch

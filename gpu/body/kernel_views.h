#pragma once
#include <cstdint>

namespace ringwatch {

/// A patch of elements for one thread block, an element a thread. Its nodes have local numbers, those at many elements
/// first, and a slot each for the patch's share of their forces. Nodes of no other patch are called interior, all
/// others shared.
struct DevicePatch {
  std::int32_t elementCount;
  std::int32_t nodeCount;
};

/// Elements of a full patch, and threads of its block, for an element of n nodes.
constexpr int patchThreads(int n) { return n == 4 ? 256 : 128; }
/// Most nodes of a patch: what its shared memory holds beside the corner forces.
inline constexpr int patchNodeLimit = 512;

/// Four numbers that the device loads at once.
template <class R>
struct alignas(16) Row4 {
  R x, y, z, w;
};

/// The patches of a block as kernels see them; see DeviceBlockPlan. R: double or float.
template <class R>
struct BlockView {
  std::int32_t patchCount = 0;
  std::int32_t firstPatch = 0;  // counted over all blocks
  std::int32_t firstSlot = 0;
  std::int32_t nodeCapacity = 0;  // nodes of the largest patch: the stride of `nodes` and of the slots
  std::int32_t rowCapacity = 0;   // rows of the largest patch
  std::int32_t pointCount = 0;    // of the quadrature rule
  const DevicePatch* patches = nullptr;
  const std::uint16_t* corners = nullptr;
  const std::int32_t* nodes = nullptr;
  const std::int32_t* groupRow = nullptr;
  const std::uint16_t* rows = nullptr;
  /// J⁻¹, row by row, of every quadrature point, and its weight times det J: [patch][point][10][thread]. Elements of
  /// constant gradient have no weight there, [patch][9][thread]: it follows from det J⁻¹.
  const R* geometry = nullptr;
};

/// Counts and switches that live on the device, so that a captured graph reads them again at each replay.
struct DeviceClock {
  double h;           // s, the step
  std::int64_t step;  // taken so far
};

/// Nodal data by device node; see DevicePlan.
template <class R>
struct NodeView {
  std::int32_t count = 0, interiorCount = 0;
  Row4<R>* u = nullptr;                       // displacements x - X, m; w: 1/mass, 1/kg
  R* v = nullptr;                             // [component][node], m/s
  const R* external = nullptr;                // [component][node], N; nullptr: none
  const std::uint8_t* constrained = nullptr;  // a bit a component; nullptr: none
  Row4<R>* slots = nullptr;
  const std::int32_t* slotBegin = nullptr;
  const std::int32_t* slot = nullptr;
  DeviceClock* clock = nullptr;
};

}  // namespace ringwatch

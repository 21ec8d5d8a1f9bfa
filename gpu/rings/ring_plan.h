#pragma once
#include <cstdint>
#include <vector>

#include <ringwatch/gpu/body/device_patches.h>

namespace ringwatch {

/// Node pairs of a tetrahedron, i >= j, in the order of a lower triangle: ten of them, the diagonal among them.
inline constexpr int tetrahedronPairs = 10;

/// A patch's node pairs have local numbers, those that no other patch has (own) first.
struct RingPatch {
  std::int32_t pairCount, ownCount;
  std::int32_t firstPair;  // of the own ones among all pairs
  std::int32_t firstSlot;  // of the others
};

/// Node pairs of the patches of one block of four-node tetrahedra.
struct RingBlockPlan {
  int pairCapacity = 0;  // pairs of the largest patch, a multiple of 32
  int rowCapacity = 0;   // rows of the largest patch
  std::vector<RingPatch> patches;
  /// [patch][thread] the element's corners in ascending order of their device nodes, two bits each: so that a pair has
  /// the same rows and columns in all of its elements.
  std::vector<std::uint8_t> order;
  std::vector<std::uint16_t> pairs;  // [patch][10][thread] local pair
  /// Blocks of each local pair, as DeviceBlockPlan has the corners of each node: a block is pair * threads + thread.
  std::vector<std::int32_t> groupRow;
  std::vector<std::uint16_t> rows;
  int groups() const { return pairCapacity / 32; }
};

/// The pattern of the assembled tangent of tetrahedra, patch by patch.
struct RingPlan {
  std::vector<RingBlockPlan> blocks;
  std::int32_t pairCount = 0;                         // of all: own ones patch by patch, then the shared ones
  std::vector<std::int32_t> slotPair;                 // [slot] the pair that it is a part of
  std::vector<std::int32_t> sharedBegin, sharedSlot;  // slots of each shared pair, ascending
  std::int32_t sharedCount() const { return static_cast<std::int32_t>(sharedBegin.size()) - 1; }
};

/// The patches of a block as they are made for the device.
struct RingPatchesInput {
  const std::vector<DevicePatch>* patches;
  const std::vector<std::uint16_t>* corners;  // [patch][thread][4]
  const std::vector<std::int32_t>* nodes;     // [patch][nodeCapacity]
  int nodeCapacity;
};
/// Depends on the patches alone, not on the number of threads. interiorCount: device nodes of one patch only. Throws
/// InputError for more pairs than the device can count.
RingPlan planRings(const std::vector<RingPatchesInput>& blocks, std::int32_t interiorCount);

}  // namespace ringwatch

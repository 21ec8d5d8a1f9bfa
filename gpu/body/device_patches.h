#pragma once
#include <cstdint>
#include <vector>

#include <ringwatch/gpu/body/kernel_views.h>
#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// The patches of one mesh block, or some of them.
struct DeviceBlockPlan {
  std::size_t block = 0;  // of the mesh
  int threads = 0;        // of a thread block: elements of a full patch
  int nodeCapacity = 0;   // nodes of the largest patch, a multiple of 32
  int rowCapacity = 0;    // rows of the largest patch
  std::vector<DevicePatch> patches;
  std::vector<std::int32_t> elements;  // [patch][thread] position in the mesh block, -1: none
  std::vector<std::uint16_t> corners;  // [patch][thread][node] local node
  std::vector<std::int32_t> nodes;     // [patch][nodeCapacity] device nodes by local number, -1 beyond the last
  std::int32_t firstSlot = 0;          // of the block; a slot for each entry of `nodes`
  /// Which corners each local node is: for group g of 32 nodes of a patch the rows from groupRow[patch * groups() + g]
  /// to the next entry, one corner of each of them a row. A corner is node * threads + thread; node count * threads
  /// stands for none. The order of a node's corners keeps the banks of shared memory apart.
  std::vector<std::int32_t> groupRow;
  std::vector<std::uint16_t> rows;  // [row][32]
  int groups() const { return nodeCapacity / 32; }
};

/// What a part of a mesh exchanges with another one: slots of nodes at which both have patches.
struct SlotLists {
  std::size_t with = 0;            // number of the other part
  std::vector<std::int32_t> send;  // own slots, in the order in which the other one has places for them
  std::int32_t firstReceived = 0;  // slots that the other one fills
  std::int32_t received = 0;       // how many
};

/// A mesh, or a part of it, cut into patches for a device, and the device's numbering of nodes: interior nodes patch by
/// patch, then the shared ones.
struct DevicePlan {
  std::vector<DeviceBlockPlan> blocks;   // of a whole mesh: one a mesh block
  std::vector<std::int32_t> deviceNode;  // by mesh node; -1: not in this part
  std::int32_t interiorCount = 0;
  std::int32_t patchCount = 0;          // of all blocks
  std::int32_t slotCount = 0;           // slots of interior nodes are never used
  std::vector<std::int32_t> slotBegin;  // by shared node, one more at the end
  std::vector<std::int32_t> slot;       // slots of each shared node, in the order of the whole mesh's patches
  // Of a part (see cutPlan): patches at nodes of other parts are in the first blocks.
  std::size_t borderBlocks = 0;
  std::vector<std::int32_t> wholePatch;  // number of each patch in the whole plan; empty: the same
  std::vector<SlotLists> exchanges;
  std::int32_t sharedCount() const { return static_cast<std::int32_t>(slotBegin.size()) - 1; }
  std::int32_t nodeCount() const { return interiorCount + sharedCount(); }
};

/// Cuts every block into patches by recursive coordinate bisection of the centroids along the longest side (Berger &
/// Bokhari 1987). Depends on the mesh alone, not on the number of threads. Throws InputError for quadratic elements,
/// which the device does not have.
DevicePlan planPatches(const Mesh& mesh);

/// Adds rows with what belongs to the numbers first to last, 32 at most: one entry of each a row, `none` where nothing
/// is left. Which entry of a number comes in which row is free: each half of a warp reads sixteen banks of 8 bytes at
/// once, so that entries of the same bank are kept apart. Empties the lists.
void fillRows(std::vector<std::vector<std::uint16_t>>& entriesOf, std::size_t first, std::size_t last,
              std::uint16_t none, std::vector<std::uint16_t>& rows);

}  // namespace ringwatch

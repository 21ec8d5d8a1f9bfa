#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <ringwatch/base/pack.h>
#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// Elements of a batch, which are computed side by side.
inline constexpr int lanes = nativeWidth;

/// A group of elements that lie close together, handled by one thread at a time. Element kernels add nodal values into
/// the patch's own slots (one row of 4 numbers for each node of the patch); the body then sums the slots of each node
/// in a fixed order. That needs no atomics and gives the same bits for any number of threads.
struct Patch {
  std::int32_t batchBegin, batchEnd;  // batches of `lanes` elements
  std::int32_t nodeBegin, nodeEnd;    // into PatchLayout::nodes; also the patch's slots, counted within the block
};

/// The elements of a block in an order of their own, cut into patches and, within them, into batches.
struct PatchLayout {
  std::vector<Patch> patches;
  std::vector<std::int32_t> nodes;           // mesh nodes of each patch
  std::vector<std::int32_t> elements;        // [batch][lane] position in the mesh block; -1 for a lane without element
  std::vector<std::uint16_t> localNodes;     // [batch][node][lane] position in the patch's node list
  std::vector<std::int32_t> batchOfElement;  // by position in the mesh block: batch * lanes + lane

  /// A patch has no more nodes: its rows fit on the stack.
  static constexpr int maxPatchNodes = 1024;

  std::int32_t batchCount() const { return static_cast<std::int32_t>(elements.size() / lanes); }
};

/// The elements in the order given, each named once; connectivity: nodesPerElement node numbers below nodeCount each.
PatchLayout layOutPatches(std::size_t nodeCount, int nodesPerElement, std::span<const std::int32_t> connectivity,
                          const std::vector<std::int32_t>& order);
/// A part of the elements of a block, laid out as the block is: patches and batches are those of the block without the
/// elements that are not in the part, so that the sums at a node all of whose elements are in it have the terms and the
/// order that they have in the whole (Theorem 78, docs/theory/distribution.md). whole: the layout of the block;
/// elements: those of the part by their positions in the block, each once; connectivity: of the part, nodesPerElement
/// node numbers below nodeCount each.
PatchLayout layOutPart(std::size_t nodeCount, int nodesPerElement, std::span<const std::int32_t> connectivity,
                       const PatchLayout& whole, std::span<const std::int32_t> elements);
/// The elements of a mesh block along a space-filling curve.
PatchLayout layOutPatches(const Mesh& mesh, const MeshBlock& block);

}  // namespace ringwatch

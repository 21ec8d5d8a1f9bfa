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
/// Where an element is in the layout of a block.
struct PatchPlace {
  std::int32_t patch;  // any number that ascends with the patches of the block
  std::int32_t place;  // batch * lanes + lane
};
/// A part of the elements of a block, laid out as the block is: patches and batches are those of the block without the
/// elements that are not in the part, so that the sums at a node all of whose elements are in it have the terms and the
/// order that they have in the whole (Theorem 78, docs/theory/distribution.md). places: of the elements of the part in
/// the block, each once; connectivity: of the part, nodesPerElement node numbers below nodeCount each.
PatchLayout layOutPart(std::size_t nodeCount, int nodesPerElement, std::span<const std::int32_t> connectivity,
                       std::span<const PatchPlace> places);
/// The places of some elements of a block, by their positions in it.
std::vector<PatchPlace> placesOf(const PatchLayout& whole, std::span<const std::int32_t> elements);
/// The elements of a mesh block along a space-filling curve: ascending by curveKey, equal ones by number.
PatchLayout layOutPatches(const Mesh& mesh, const MeshBlock& block);
/// The place of an element of n nodes (positions in X, 3×N, m) along the curve. low: the lowest corner of the mesh, m;
/// extent: the largest of its three sizes, m, > 0.
std::uint64_t curveKey(const NodeVectors& X, const std::int32_t* nodes, int n, const Eigen::Vector3d& low,
                       double extent);
/// The extent of a mesh between two corners, m, as curveKey takes it.
double curveExtent(const Eigen::Vector3d& low, const Eigen::Vector3d& high);
/// Whether a patch that has so many nodes takes another batch of elements; a patch without elements takes one.
bool takesAnotherBatch(std::int32_t nodesInPatch, int nodesPerElement);

}  // namespace ringwatch

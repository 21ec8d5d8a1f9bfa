#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <ringwatch/distributed/ranks.h>
#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// Which rank an element or a node belongs to. Elements are counted through, block after block.
struct Partition {
  int parts = 1;
  std::vector<std::int32_t> ofElement, ofNode;
};

/// The partition with these parts of elements, 0 to parts - 1 each; parts may be empty. A node belongs to the part that
/// has most of its elements, of several such parts to the first. Throws InputError where numbers do not fit.
Partition partitionOf(const Mesh& mesh, std::vector<std::int32_t> partOfElement, int parts);

/// Cuts a mesh so that few faces lie between parts and each has about the same work: Scotch's recursive bipartition of
/// the elements, joined through faces, each weighted by its nodes. Scotch works with threads, and two calls may cut
/// differently; what is computed on the parts does not depend on it (Theorem 78, docs/theory/distribution.md). Throws
/// InputError for parts < 1 and where Scotch refuses.
Partition partitionMesh(const Mesh& mesh, int parts);
/// Gives all nodes of a group to the part that owns most of them, of several such parts to the first. Groups share no
/// node.
void keepTogether(Partition& partition, std::span<const std::int32_t> group);
/// A part for each rank: rank 0 cuts the mesh, which all have, and tells the others. Collective.
Partition partitionMesh(Ranks& ranks, const Mesh& mesh);

}  // namespace ringwatch

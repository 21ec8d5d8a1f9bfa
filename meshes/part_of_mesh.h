#pragma once
#include <cstddef>
#include <vector>

#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// Blocks and element sets of some elements of a mesh, those with the flag [block][element], empty ones too; nodes keep
/// their numbers and are not copied.
Mesh meshOfElements(const Mesh& all, const std::vector<std::vector<bool>>& chosen);

/// Whether a node is of an element, for each.
std::vector<bool> usedNodes(const Mesh& mesh);
/// Removes the nodes that are of no element, from the sets too. Returns the numbers that the others had, ascending.
std::vector<std::size_t> keepUsedNodes(Mesh& mesh);

}  // namespace ringwatch

#pragma once
#include <cstdint>

#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// Place along a Morton curve through the unit cube, 21 bits an axis; coordinates outside it count as its nearest
/// point. What is close along the curve is close in space.
std::uint64_t mortonKey(const Eigen::Vector3d& unit);

/// Numbers the nodes along a Morton curve, so that an element's nodes and those of its neighbours lie together in
/// memory. Elements keep their order; `nodeIds` keep the numbers of the file; node sets end up ascending. Nodes at
/// one place keep their order.
void renumberNodes(Mesh& mesh);

}  // namespace ringwatch

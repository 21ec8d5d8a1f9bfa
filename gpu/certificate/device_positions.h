#pragma once
#include <cstdint>

#include <cuda_runtime_api.h>

#include <ringwatch/gpu/body/kernel_views.h>

namespace ringwatch {

/// Displacements of the nodes from positions x, 3 numbers a mesh node, m; velocities become zero. meshNode, reference:
/// mesh node and reference position, 3 numbers, of each device node.
void launchTakePositions(const NodeView<double>& nodes, const std::int32_t* meshNode, const double* reference,
                         const double* x, cudaStream_t stream);

}  // namespace ringwatch

#pragma once
#include <cstdint>

#include <Eigen/Core>

#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// ∂x/∂ξ = Σ_a x_a ∂N_a/∂ξ of an element at a point of its reference element, m. x: 3×N positions, m; nodes: of the
/// element, n of them; dN: ∂N_a/∂ξ at the point, three numbers a node. Positions count from the first node: far from
/// the origin, products of large coordinates would lose the element's size.
inline Eigen::Matrix3d jacobianOf(NodeVectorsView x, const std::int32_t* nodes, int n, const double* dN) {
  Eigen::Matrix3d J = Eigen::Matrix3d::Zero();
  for (int a = 1; a < n; ++a) J += (x.col(nodes[a]) - x.col(nodes[0])) * Eigen::RowVector3d::Map(dN + 3 * a);
  return J;
}

}  // namespace ringwatch

#pragma once
#include <array>
#include <functional>
#include <vector>

#include <ringwatch/app/scene/scene.h>

namespace ringwatch {

/// Corners of a face, seen from outside counter-clockwise; the last one is -1 for a triangle.
using FaceNodes = std::array<std::int32_t, 4>;

/// The faces of the surface all of whose corners a pressure selects. Throws InputError where there is none, and for
/// faces of quadratic elements.
std::vector<FaceNodes> pressedFaces(const Scene::Pressure& pressure, const Mesh& mesh);

/// Adds the nodal forces of a pressure (Pa) on a face at positions x, N: -p ∫ N_a n dA, n the outward normal as it is.
/// Exact for triangles and for quadrilaterals with bilinear sides.
void addPressure(const FaceNodes& face, double pressure, NodeVectorsView x,
                 const std::function<void(std::int32_t node, const Eigen::Vector3d& force)>& add);

}  // namespace ringwatch

#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include <ringwatch/app/scene/scene.h>

namespace ringwatch {

/// Quadrature on a face of a reference element: at each point the shape functions of the face's nodes and their
/// derivatives along two directions in the face, whose cross product points outwards.
struct FaceQuadrature {
  struct Point {
    double weight;
    std::vector<double> N, dr, ds;  // of each of `nodes`
  };
  std::vector<int> nodes;  // of the element, those of the face
  std::vector<Point> points;
};

/// A face that a pressure acts on.
struct PressedFace {
  std::vector<std::int32_t> nodes;  // of the mesh, in the order of the quadrature's
  std::shared_ptr<const FaceQuadrature> quadrature;
};

/// The faces of the surface all of whose corners a pressure selects. Throws InputError where there is none.
std::vector<PressedFace> pressedFaces(const Scene::Pressure& pressure, const Mesh& mesh);

/// Adds the nodal forces of a pressure (Pa) on a face at positions x, N: -p ∫ N_a n dA, n the outward normal as it is.
/// Exact for the faces of all isoparametric elements of first and second order.
void addPressure(const PressedFace& face, double pressure, NodeVectorsView x,
                 const std::function<void(std::int32_t node, const Eigen::Vector3d& force)>& add);

}  // namespace ringwatch

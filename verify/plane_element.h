#pragma once
#include <Eigen/Core>

namespace ringwatch {

/// A triangle or quadrilateral in plane strain, of thickness 1 m.
struct PlaneShape {
  int nodes;
  Eigen::Matrix<double, 2, 4> X;  // corners, counter-clockwise, m; of a triangle the first three
};

/// Tangent, N/m, and masses, kg, of a plane shape of a linear elastic solid: 2n×2n, 2×2 points on a quadrilateral.
struct PlaneElement {
  Eigen::MatrixXd tangent;
  Eigen::VectorXd mass;  // of the nodes: row sums
};
PlaneElement planeElement(const PlaneShape& shape, double young, double poisson, double density);

}  // namespace ringwatch

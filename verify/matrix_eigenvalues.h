#pragma once
#include <Eigen/Core>

namespace ringwatch {

/// The eigenvalues of a general square matrix, in no order. Eigen's iteration may give up where they come in defective
/// pairs, as those of two-step methods at critical damping do; it is tried again after reflections, which keep them.
/// Throws NumericalError where they are not found.
Eigen::VectorXcd eigenvaluesOf(const Eigen::MatrixXd& A);

/// The highest eigenvalue of M^-½ K M^-½, rad²/s²; K: symmetric, N/m; mass: of the nodes, kg, whose components come
/// together in K.
double denseEigenvalue(const Eigen::MatrixXd& K, const Eigen::VectorXd& mass);

}  // namespace ringwatch

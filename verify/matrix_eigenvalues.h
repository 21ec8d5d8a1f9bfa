#pragma once
#include <Eigen/Core>

namespace ringwatch {

/// The eigenvalues of a general square matrix, in no order. Eigen's iteration may give up where they come in defective
/// pairs, as those of two-step methods at critical damping do; it is tried again after reflections, which keep them.
/// Throws NumericalError where they are not found.
Eigen::VectorXcd eigenvaluesOf(const Eigen::MatrixXd& A);

}  // namespace ringwatch

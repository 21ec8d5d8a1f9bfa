#pragma once
#include <vector>

#include <ringwatch/body/body.h>

namespace ringwatch {

/// The lowest eigenvalues omega² (rad²/s²) of M⁻¹K(x) that are not rigid motions, ascending, at most `count`, over the
/// free degrees of freedom; mass: lumped, kg, N numbers, all > 0. A rigid motion has an eigenvalue within 1e-9 of zero,
/// relative to the highest. By shift and invert (sparse LDLᵀ) with Lanczos' iteration. Empty when that does not
/// converge, or where K is indefinite.
std::vector<double> lowestEigenvalues(const Body& body, const NodeVectors& x, const Eigen::VectorXd& mass, int count);

}  // namespace ringwatch

#pragma once
#include <functional>

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace ringwatch {

/// Some eigenvalues of a real symmetric matrix.
struct SymmetricEigenpairs {
  bool converged = false;
  Eigen::VectorXd values;   // ascending; those that converged
  Eigen::MatrixXd vectors;  // a column each
  /// Eigenvalues below the shift, of all that the matrix has (Sylvester's law of inertia).
  Eigen::Index below = 0;
};

struct EigenpairOptions {
  Eigen::Index wanted = 1;        // eigenvalues
  Eigen::Index basis = 40;        // vectors that are kept; more than `wanted`, at most the size of the matrix
  const double* start = nullptr;  // the first vector; null: Spectra's random one, the same at every call
  double tolerance = 1e-10;       // of the residuals, relative to the eigenvalues
  Eigen::Index restarts = 1000;   // at most
};

/// The highest eigenvalues of a matrix of `size` rows that is given by its product: `product(in, out)` writes the
/// product of the matrix and `in` to `out`, `size` numbers each. Spectra's implicitly restarted Lanczos iteration,
/// which compares residuals with absolute numbers too: eigenvalues should be near 1.
SymmetricEigenpairs highestEigenpairs(Eigen::Index size,
                                      const std::function<void(const double* in, double* out)>& product,
                                      const EigenpairOptions& options);

/// The eigenvalues of A nearest to a shift that is none: the same iteration on (A - shift I)⁻¹ by sparse LDLᵀ.
SymmetricEigenpairs nearestEigenpairs(const Eigen::SparseMatrix<double>& A, double shift,
                                      const EigenpairOptions& options);

}  // namespace ringwatch

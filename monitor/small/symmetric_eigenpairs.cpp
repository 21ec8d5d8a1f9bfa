#include <ringwatch/monitor/small/symmetric_eigenpairs.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <vector>

#include <Spectra/SymEigsSolver.h>

#include <ringwatch/base/eigen_instances.h>

namespace ringwatch {
namespace {

/// The shape of an operator as Spectra wants it. The only one, so that Spectra is compiled once.
class Operator {
 public:
  using Scalar = double;
  Operator(Eigen::Index size, const std::function<void(const double*, double*)>& product)
      : size_(size), product_(product) {}
  Eigen::Index rows() const { return size_; }
  Eigen::Index cols() const { return size_; }
  void perform_op(const double* in, double* out) const { product_(in, out); }

 private:
  Eigen::Index size_;
  const std::function<void(const double*, double*)>& product_;
};

SymmetricEigenpairs solve(Eigen::Index size, const std::function<void(const double*, double*)>& product,
                          const EigenpairOptions& options, Spectra::SortRule rule) {
  SymmetricEigenpairs result;
  try {
    Operator op(size, product);
    Spectra::SymEigsSolver<Operator> solver(op, options.wanted, options.basis);
    if (options.start)
      solver.init(options.start);
    else
      solver.init();
    const Eigen::Index found = solver.compute(rule, options.restarts, options.tolerance);
    result.converged = found > 0 && solver.info() == Spectra::CompInfo::Successful;
    result.values = solver.eigenvalues();
    result.vectors = solver.eigenvectors();
  } catch (const std::runtime_error&) {
    // Spectra's word for a decomposition that failed, as it does when the matrix is not finite.
    return {};
  }
  return result;
}

void sortAscending(SymmetricEigenpairs& pairs) {
  std::vector<Eigen::Index> order(pairs.values.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](auto i, auto j) { return pairs.values[i] < pairs.values[j]; });
  const Eigen::VectorXd values = pairs.values;
  const Eigen::MatrixXd vectors = pairs.vectors;
  for (std::size_t k = 0; k < order.size(); ++k) {
    pairs.values[k] = values[order[k]];
    pairs.vectors.col(k) = vectors.col(order[k]);
  }
}

}  // namespace

SymmetricEigenpairs highestEigenpairs(Eigen::Index size, const std::function<void(const double*, double*)>& product,
                                      const EigenpairOptions& options) {
  SymmetricEigenpairs result = solve(size, product, options, Spectra::SortRule::LargestAlge);
  sortAscending(result);
  return result;
}

SymmetricEigenpairs nearestEigenpairs(const Eigen::SparseMatrix<double>& A, double shift,
                                      const EigenpairOptions& options) {
  Eigen::SparseMatrix<double> identity(A.rows(), A.cols());
  identity.setIdentity();
  const Eigen::SparseMatrix<double> shifted = A - shift * identity;
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(shifted);
  if (factor.info() != Eigen::Success) return {};
  const auto inverse = [&](const double* in, double* out) {
    Eigen::VectorXd::Map(out, A.rows()) = factor.solve(Eigen::VectorXd::Map(in, A.rows()));
  };
  SymmetricEigenpairs result = solve(A.rows(), inverse, options, Spectra::SortRule::LargestMagn);
  result.values = result.values.cwiseInverse().array() + shift;
  result.below = (factor.vectorD().array() < 0).count();
  sortAscending(result);
  return result;
}

}  // namespace ringwatch

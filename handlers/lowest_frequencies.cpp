#include <ringwatch/handlers/lowest_frequencies.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Spectra/SymEigsShiftSolver.h>

#include <ringwatch/base/eigen_instances.h>

namespace ringwatch {
namespace {

/// (A - shift I)⁻¹ for Spectra.
class ShiftedInverse {
 public:
  using Scalar = double;
  explicit ShiftedInverse(const Eigen::SparseMatrix<double>& A) : A_(A) {}
  Eigen::Index rows() const { return A_.rows(); }
  Eigen::Index cols() const { return A_.cols(); }
  void set_shift(double shift) {
    Eigen::SparseMatrix<double> shifted = A_;
    for (Eigen::Index i = 0; i < A_.rows(); ++i) shifted.coeffRef(i, i) -= shift;
    factor_.compute(shifted);
    if (factor_.info() != Eigen::Success) throw std::runtime_error("not factored");
  }
  void perform_op(const double* in, double* out) const {
    Eigen::VectorXd::Map(out, rows()) = factor_.solve(Eigen::VectorXd::Map(in, rows()));
  }

 private:
  const Eigen::SparseMatrix<double>& A_;
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> factor_;
};

}  // namespace

std::vector<double> lowestEigenvalues(const Body& body, const NodeVectors& x, const Eigen::VectorXd& mass, int count) {
  std::vector<int> number(static_cast<std::size_t>(3 * body.nodeCount()), -1);
  int free = 0;
  for (std::int32_t i = 0; i < body.nodeCount(); ++i)
    for (int c = 0; c < 3; ++c)
      if (!body.constraints().isConstrained(i, c)) number[static_cast<std::size_t>(3 * i + c)] = free++;
  constexpr int rigid = 6;
  if (free <= rigid + count) return {};
  const Eigen::SparseMatrix<double> K = body.assembleTangent(x);
  std::vector<Eigen::Triplet<double>> entries;
  double largest = 0;
  for (int column = 0; column < K.outerSize(); ++column)
    for (Eigen::SparseMatrix<double>::InnerIterator entry(K, column); entry; ++entry) {
      const int i = number[static_cast<std::size_t>(entry.row())], j = number[static_cast<std::size_t>(column)];
      if (i < 0 || j < 0) continue;
      const double value = entry.value() / std::sqrt(mass[entry.row() / 3] * mass[column / 3]);
      entries.emplace_back(i, j, value);
      if (i == j) largest = std::max(largest, value);
    }
  Eigen::SparseMatrix<double> A(free, free);
  A.setFromTriplets(entries.begin(), entries.end());
  ShiftedInverse inverse(A);
  const int wanted = count + rigid;
  try {
    // A shift below zero keeps rigid motions from making the matrix singular.
    Spectra::SymEigsShiftSolver<ShiftedInverse> solver(inverse, wanted, std::min(free, 4 * wanted), -1e-7 * largest);
    solver.init();
    solver.compute(Spectra::SortRule::LargestMagn, 1000, 1e-10, Spectra::SortRule::SmallestAlge);
    if (solver.info() != Spectra::CompInfo::Successful) return {};
    std::vector<double> result;
    for (const double value : solver.eigenvalues()) {
      if (value < -1e-9 * largest) return {};
      if (value > 1e-9 * largest && static_cast<int>(result.size()) < count) result.push_back(value);
    }
    return result;
  } catch (const std::runtime_error&) {
    return {};  // Spectra's word for a decomposition that failed
  }
}

}  // namespace ringwatch

#include <ringwatch/handlers/mass_scaling/lowest_frequencies.h>

#include <algorithm>

#include <ringwatch/body/free_dofs.h>
#include <ringwatch/monitor/small/symmetric_eigenpairs.h>

namespace ringwatch {

std::vector<double> lowestEigenvalues(const Body& body, const NodeVectors& x, const Eigen::VectorXd& mass, int count) {
  const FreeDofs dofs(body);
  constexpr int rigid = 6;
  if (dofs.count() <= rigid + count) return {};
  const Eigen::VectorXd inverseRoot = dofs.gather(mass.transpose().replicate(3, 1)).cwiseSqrt().cwiseInverse();
  Eigen::SparseMatrix<double> A = dofs.reduce(body.assembleTangent(x));
  A = inverseRoot.asDiagonal() * A * inverseRoot.asDiagonal();
  const double largest = Eigen::VectorXd(A.diagonal()).maxCoeff();
  const int wanted = count + rigid;
  // A shift below zero keeps rigid motions from making the matrix singular.
  const SymmetricEigenpairs found =
      nearestEigenpairs(A, -1e-7 * largest, {.wanted = wanted, .basis = std::min(dofs.count(), 4 * wanted)});
  if (!found.converged || found.below > 0) return {};
  std::vector<double> result;
  for (const double value : found.values) {
    if (value < -1e-9 * largest) return {};
    if (value > 1e-9 * largest && static_cast<int>(result.size()) < count) result.push_back(value);
  }
  return result;
}

}  // namespace ringwatch

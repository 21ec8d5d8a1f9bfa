#include <ringwatch/monitor/global_frequency.h>

#include <random>
#include <stdexcept>

#include <Spectra/SymEigsSolver.h>

#include <ringwatch/monitor/mass_scaled_operator.h>

namespace ringwatch {

GlobalFrequency globalFrequency(const Body& body, const NodeVectors& x, double tolerance, int maxRestarts) {
  GlobalFrequency result;
  MassScaledOperator op(body, x);
  const Eigen::Index n = op.rows();
  Spectra::SymEigsSolver<MassScaledOperator> solver(op, 1, std::min<Eigen::Index>(n, 40));
  // A start of our own: the same on every run, free components only, no symmetry that a mesh could share.
  std::mt19937_64 generator(20130517);
  std::uniform_real_distribution<double> uniform(-1, 1);
  NodeVectors start(3, body.nodeCount());
  for (Eigen::Index i = 0; i < start.size(); ++i) start.data()[i] = uniform(generator);
  body.constraints().clearConstrained(start);
  if (!(start.norm() > 0)) {  // nothing is free: no frequency, and that is exact
    result.converged = true;
    result.mode = start;
    return result;
  }
  Eigen::Index found = 0;
  try {
    solver.init(start.data());
    found = solver.compute(Spectra::SortRule::LargestAlge, maxRestarts, tolerance);
  } catch (const std::runtime_error&) {
    // Spectra's word for a decomposition that failed, as it does when the tangent is not finite.
  }
  result.products = op.products();
  if (found < 1 || solver.info() != Spectra::CompInfo::Successful) return result;
  result.converged = true;
  result.lambda = solver.eigenvalues()[0];
  const Eigen::VectorXd vector = solver.eigenvectors(1).col(0);
  result.mode = Eigen::Map<const NodeVectors>(vector.data(), 3, body.nodeCount()) * op.inverseRootMass().asDiagonal();
  return result;
}

}  // namespace ringwatch

#include <ringwatch/monitor/global_frequency.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include <Spectra/SymEigsSolver.h>

#include <ringwatch/base/random.h>
#include <ringwatch/monitor/mass_scaled_operator.h>

namespace ringwatch {
namespace {

/// What rounding leaves of the residual at most, relative to the eigenvalue.
constexpr double residualRounding = 1e-8;

/// A times a factor. Spectra compares residuals with absolute numbers: it needs eigenvalues near 1.
class ScaledOperator {
 public:
  using Scalar = double;
  ScaledOperator(const MassScaledOperator& op, double factor) : op_(op), factor_(factor) {}
  Eigen::Index rows() const { return op_.rows(); }
  Eigen::Index cols() const { return op_.cols(); }
  void perform_op(const double* in, double* out) const {
    op_.perform_op(in, out);
    Eigen::VectorXd::Map(out, rows()) *= factor_;
  }

 private:
  const MassScaledOperator& op_;
  double factor_;
};

}  // namespace

GlobalFrequency globalFrequency(const Body& body, const NodeVectors& x, double tolerance, int maxRestarts) {
  body.checkNodal("x", x);
  GlobalFrequency result;
  const MassScaledOperator op(body, x);
  const Eigen::Index n = op.rows();
  // The same start on every run and every machine, free components only, without a symmetry that a mesh could share.
  NodeVectors start(3, body.nodeCount());
  for (Eigen::Index i = 0; i < n; ++i) start.data()[i] = randomEntry(20130517, static_cast<std::uint64_t>(i));
  body.constraints().clearConstrained(start);
  if (!(start.norm() > 0)) {  // nothing is free: no frequency, and that is exact
    result.converged = true;
    result.mode = start;
    return result;
  }
  // The start holds about 1/√n of every mode, so that the highest eigenvalue lies between about 1 and √n of this size.
  // A power of two changes no digit.
  NodeVectors product(3, body.nodeCount());
  op.perform_op(start.data(), product.data());
  result.products = op.products();
  const double size = product.stableNorm() / start.norm();
  if (!std::isfinite(size)) return result;
  if (!(size > 0)) {  // K times a random vector is zero: there is no stiffness
    result.converged = true;
    result.mode = NodeVectors::Zero(3, body.nodeCount());
    return result;
  }
  const double factor = std::ldexp(1.0, -std::ilogb(size));
  if (!std::isfinite(factor) || !std::isfinite(1 / factor)) return result;
  ScaledOperator scaled(op, factor);
  Spectra::SymEigsSolver<ScaledOperator> solver(scaled, 1, std::min<Eigen::Index>(n, 40));
  Eigen::Index found = 0;
  try {
    solver.init(start.data());
    found = solver.compute(Spectra::SortRule::LargestAlge, maxRestarts, tolerance);
  } catch (const std::runtime_error&) {
    // Spectra's word for a decomposition that failed, as it does when the tangent is not finite.
  }
  result.products = op.products();
  if (found < 1 || solver.info() != Spectra::CompInfo::Successful) return result;
  const double lambda = solver.eigenvalues()[0];
  const Eigen::VectorXd vector = solver.eigenvectors(1).col(0);
  // Spectra only estimates the residual.
  scaled.perform_op(vector.data(), product.data());
  result.products = op.products();
  const double residual = (Eigen::VectorXd::Map(product.data(), n) - lambda * vector).norm();
  if (!(residual <= std::max(10 * tolerance, residualRounding) * std::abs(lambda))) return result;
  result.converged = true;
  result.lambda = lambda / factor;
  result.mode = Eigen::Map<const NodeVectors>(vector.data(), 3, body.nodeCount()) * op.inverseRootMass().asDiagonal();
  return result;
}

}  // namespace ringwatch

#include <ringwatch/monitor/bounds/global_frequency.h>

#include <cmath>
#include <limits>

#include <ringwatch/base/random.h>
#include <ringwatch/monitor/small/symmetric_eigenpairs.h>

namespace ringwatch {
namespace {

/// What rounding leaves of the residual at most, relative to the eigenvalue.
constexpr double residualRounding = 1e-8;

}  // namespace

GlobalFrequency globalFrequency(const TangentSource& source, NodeVectorsView x, double tolerance, int maxRestarts,
                                const TangentProduct& product) {
  source.checkNodal("x", x);
  GlobalFrequency result;
  const MassScaledOperator op(source, x, product);
  const Eigen::Index n = op.rows();
  // The same start on every run and every machine, free components only, without a symmetry that a mesh could share.
  NodeVectors start(3, source.nodeCount());
  for (Eigen::Index i = 0; i < n; ++i) start.data()[i] = randomEntry(20130517, static_cast<std::uint64_t>(i));
  op.restrict(start);
  if (!(start.norm() > 0)) {  // nothing is free: no frequency, and that is exact
    result.converged = true;
    result.mode = start;
    return result;
  }
  // The start holds about 1/√n of every mode, so that the highest eigenvalue lies between about 1 and √n of this size.
  // A power of two changes no digit.
  NodeVectors image(3, source.nodeCount());
  op.apply(start.data(), image.data());
  result.products = op.products();
  // Of a vector: for matrices of fixed rows Eigen 3.4's stableNorm fails an assertion of its own.
  const double size = Eigen::VectorXd::Map(image.data(), n).stableNorm() / start.norm();
  if (!std::isfinite(size)) return result;
  if (!(size > 0)) {  // K times a random vector is zero: there is no stiffness
    result.converged = true;
    result.mode = NodeVectors::Zero(3, source.nodeCount());
    return result;
  }
  const double factor = std::ldexp(1.0, -std::ilogb(size));
  if (!std::isfinite(factor) || !std::isfinite(1 / factor)) return result;
  // Residuals are compared with absolute numbers: eigenvalues are to be near 1.
  const auto scaled = [&](const double* in, double* out) {
    op.apply(in, out);
    Eigen::VectorXd::Map(out, n) *= factor;
  };
  const SymmetricEigenpairs found = highestEigenpairs(
      n, scaled,
      {.basis = std::min<Eigen::Index>(n, 40), .start = start.data(), .tolerance = tolerance, .restarts = maxRestarts});
  result.products = op.products();
  if (!found.converged) return result;
  const double lambda = found.values[0];
  const Eigen::VectorXd vector = found.vectors.col(0);
  // Spectra only estimates the residual.
  scaled(vector.data(), image.data());
  result.products = op.products();
  const double residual = (Eigen::VectorXd::Map(image.data(), n) - lambda * vector).norm();
  if (!(residual <= std::max(10 * tolerance, residualRounding) * std::abs(lambda))) return result;
  result.converged = true;
  result.lambda = lambda / factor;
  result.mode = Eigen::Map<const NodeVectors>(vector.data(), 3, source.nodeCount()) * op.inverseRootMass().asDiagonal();
  return result;
}

}  // namespace ringwatch

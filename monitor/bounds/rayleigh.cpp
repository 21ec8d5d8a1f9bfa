#include <ringwatch/monitor/bounds/rayleigh.h>

#include <algorithm>
#include <cmath>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/rounding.h>
#include <ringwatch/monitor/bounds/mass_scaled_operator.h>
#include <ringwatch/monitor/small/lanczos.h>

namespace ringwatch {

LowerBound rayleighLowerBound(const TangentSource& source, NodeVectorsView x, NodeVectors& start, int products,
                              double* seen) {
  const MassScaledOperator op(source, x);
  op.restrict(start);
  const double norm = start.norm();
  if (!(norm > 0) || !std::isfinite(norm)) {
    start.setZero();
    return {0};
  }
  start /= norm;
  const int steps = products - 1;  // none: the quotient of `start` as it is
  NodeVectors w(3, start.cols());
  Lanczos<NodeVectors> lanczos;
  const LanczosMatrix& T = lanczos.matrix();
  lanczos.begin(start);
  while (T.size() < steps) {
    op.apply(lanczos.current().data(), w.data());
    lanczos.advance(w);
    if (!(T.beta.back() > 1e-12 * std::abs(T.alpha.front())) || T.size() == steps) break;
    lanczos.extend(w);
  }
  if (T.size() > 0) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(T.dense());
    if (solver.info() == Eigen::Success) start = lanczos.combine(solver.eigenvectors().col(T.size() - 1));
  }
  // The quotient itself, from one more product: whatever went before, this is a proven lower bound to rounding.
  start /= start.norm();
  op.apply(start.data(), w.data());
  const double quotient = w.cwiseProduct(start).sum();
  // The rounding of a product is relative to the norm of the matrix, of which a large negative eigenvalue can make far
  // more than the quotient. Gershgorin's discs hold the eigenvalues of T, and |T q_1|, |T q_2| … are |A q_1|, |A q_2| …
  double largest = std::max(w.norm(), T.radius);
  if (seen) *seen = largest = std::max(largest, *seen);
  const double ofSums = quotientRounding + unitRoundoff * static_cast<double>(start.size());
  const double ofForm = op.formRounding(start) + op.rigidRounding();
  DiscreteForces::DampingForm damping = op.dampingForm(start);
  if (source.dampedElements()) damping.rounding += ofForm + ofSums * largest;
  return {quotient - ofSums * largest - ofForm, std::max(0.0, damping.value - damping.rounding),
          damping.value + damping.rounding};
}

}  // namespace ringwatch

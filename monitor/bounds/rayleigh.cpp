#include <ringwatch/monitor/bounds/rayleigh.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/rounding.h>
#include <ringwatch/monitor/bounds/mass_scaled_operator.h>

namespace ringwatch {

LowerBound rayleighLowerBound(const TangentSource& source, NodeVectorsView x, NodeVectors& start, int products,
                              double* seen) {
  source.constraints().clearConstrained(start);
  const double norm = start.norm();
  if (!(norm > 0) || !std::isfinite(norm)) {
    start.setZero();
    return {0};
  }
  MassScaledOperator op(source, x);
  start /= norm;
  const int steps = products - 1;  // none: the quotient of `start` as it is
  std::vector<NodeVectors> basis{start};
  Eigen::VectorXd diagonal(steps), subdiagonal(steps);
  NodeVectors w(3, start.cols());
  int size = 0;
  for (; size < steps; ++size) {
    const std::size_t k = size;
    op.apply(basis[k].data(), w.data());
    diagonal[size] = w.cwiseProduct(basis[k]).sum();
    // Full orthogonalisation: a handful of vectors, and the Ritz vector stays what it claims to be.
    for (const NodeVectors& q : basis) w -= w.cwiseProduct(q).sum() * q;
    subdiagonal[size] = w.norm();
    if (!(subdiagonal[size] > 1e-12 * std::abs(diagonal[0])) || size + 1 == steps) {
      ++size;
      break;
    }
    basis.push_back(w / subdiagonal[size]);
  }
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  Eigen::MatrixXd T = Eigen::MatrixXd::Zero(size, size);
  for (int i = 0; i < size; ++i) {
    T(i, i) = diagonal[i];
    if (i + 1 < size) T(i, i + 1) = T(i + 1, i) = subdiagonal[i];
  }
  if (size > 0) solver.compute(T);
  if (size > 0 && solver.info() == Eigen::Success) {
    start.setZero();
    for (int i = 0; i < size; ++i) start += solver.eigenvectors()(i, size - 1) * basis[i];
  }
  // The quotient itself, from one more product: whatever went before, this is a proven lower bound to rounding.
  start /= start.norm();
  op.apply(start.data(), w.data());
  const double quotient = w.cwiseProduct(start).sum();
  // The rounding of a product is relative to the norm of the matrix, of which a large negative eigenvalue can make far
  // more than the quotient. Gershgorin's discs hold the eigenvalues of T, and |T q_1|, |T q_2| … are |A q_1|, |A q_2| …
  double largest = w.norm();
  for (int i = 0; i < size; ++i)
    largest = std::max(largest, std::abs(diagonal[i]) + subdiagonal[i] + (i > 0 ? subdiagonal[i - 1] : 0.0));
  if (seen) *seen = largest = std::max(largest, *seen);
  const double ofSums = quotientRounding + unitRoundoff * static_cast<double>(start.size());
  return {quotient - ofSums * largest - op.formRounding(start)};
}

}  // namespace ringwatch

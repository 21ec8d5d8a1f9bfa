#include <ringwatch/monitor/bounds/rayleigh.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/monitor/bounds/mass_scaled_operator.h>

namespace ringwatch {

LowerBound rayleighLowerBound(const TangentSource& source, const NodeVectors& x, NodeVectors& start, int products) {
  source.constraints().clearConstrained(start);
  const double norm = start.norm();
  if (!(norm > 0) || !std::isfinite(norm)) {
    start.setZero();
    return {0};
  }
  MassScaledOperator op(source, x);
  start /= norm;
  const int steps = std::max(1, products - 1);
  std::vector<NodeVectors> basis{start};
  Eigen::VectorXd diagonal(steps), subdiagonal(steps);
  NodeVectors w(3, start.cols());
  int size = 0;
  for (; size < steps; ++size) {
    const auto k = static_cast<std::size_t>(size);
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
  solver.compute(T);
  if (solver.info() == Eigen::Success) {
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
  return {quotient - 1e-12 * largest};
}

void LocalSubmatrix::choose(const NodeVectors& mode) {
  constexpr std::ptrdiff_t most = 24;
  const Eigen::VectorXd size = mode.colwise().squaredNorm().transpose();
  std::vector<std::int32_t> order;
  for (std::int32_t i = 0; i < mode.cols(); ++i)
    if (size[i] > 0) order.push_back(i);
  const auto count = std::min<std::ptrdiff_t>(most, static_cast<std::ptrdiff_t>(order.size()));
  std::partial_sort(order.begin(), order.begin() + count, order.end(),
                    [&](std::int32_t a, std::int32_t b) { return size[a] != size[b] ? size[a] > size[b] : a < b; });
  order.resize(static_cast<std::size_t>(count));
  submatrix_.choose(std::move(order));
  vector_.resize(3 * count);
  for (std::ptrdiff_t i = 0; i < count; ++i) vector_.segment<3>(3 * i) = mode.col(submatrix_.nodes()[i]);
}

LowerBound LocalSubmatrix::evaluate(const NodeVectors& x) {
  if (submatrix_.nodes().empty()) return {0};
  const Eigen::MatrixXd& A = submatrix_.evaluate(x, &vector_);
  // Power iteration on A shifted by half its norm, so that a large negative eigenvalue cannot win; the quotient is A's
  // own.
  const double size = A.cwiseAbs().rowwise().sum().maxCoeff(), shift = 0.5 * size;
  double best = 0;
  for (int iteration = 0; iteration < 4; ++iteration) {
    const double norm = vector_.norm();
    if (!(norm > 0)) return {0};
    vector_ /= norm;
    const Eigen::VectorXd product = A * vector_;
    best = std::max(best, product.dot(vector_) - 1e-12 * size);
    vector_ = product + shift * vector_;
  }
  return {best};
}

}  // namespace ringwatch

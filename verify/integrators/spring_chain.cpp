#include <ringwatch/verify/integrators/spring_chain.h>

#include <cmath>
#include <numbers>

namespace ringwatch {

SpringChain::SpringChain(int masses, double mass, double stiffness, const RayleighDamping& damping)
    : mass_(Eigen::VectorXd::Constant(masses, mass)), stiffness_(stiffness), damping_(damping) {}

void SpringChain::stiffnessProduct(const NodeVectors&, const NodeVectors& u, NodeVectors& Ku) {
  const Eigen::Index n = u.cols();
  Ku.setZero(3, n);
  for (Eigen::Index i = 0; i < n; ++i)
    Ku(0, i) = stiffness_ * (2 * u(0, i) - (i > 0 ? u(0, i - 1) : 0.0) - (i + 1 < n ? u(0, i + 1) : 0.0));
}

void SpringChain::acceleration(double, const NodeVectors& x, const NodeVectors& v, NodeVectors& a) {
  stiffnessProduct(x, x, a);
  if (damping_.beta != 0) {
    stiffnessProduct(x, v, product_);
    a += damping_.beta * product_;
  }
  a *= -1 / mass_[0];
  if (damping_.alpha != 0) a.row(0) -= damping_.alpha * v.row(0);
}

Eigen::SparseMatrix<double> SpringChain::stiffness(const NodeVectors& x) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto n = static_cast<int>(x.cols());
  for (int i = 0; i < n; ++i) {
    entries.emplace_back(3 * i, 3 * i, 2 * stiffness_);
    if (i > 0) entries.emplace_back(3 * i, 3 * i - 3, -stiffness_);
    if (i + 1 < n) entries.emplace_back(3 * i, 3 * i + 3, -stiffness_);
  }
  Eigen::SparseMatrix<double> K(3 * n, 3 * n);
  K.setFromTriplets(entries.begin(), entries.end());
  return K;
}

double SpringChain::frequency(int j) const {
  return 2 * std::sqrt(stiffness_ / mass_[0]) * std::sin(j * std::numbers::pi / (2.0 * (count() + 1)));
}

NodeVectors SpringChain::mode(int j) const {
  NodeVectors u = NodeVectors::Zero(3, count());
  for (int i = 0; i < count(); ++i) u(0, i) = std::sin((i + 1) * j * std::numbers::pi / (count() + 1));
  return u;
}

double SpringChain::energy(const NodeVectors& x, const NodeVectors& v) {
  stiffnessProduct(x, x, product_);
  return 0.5 * x.cwiseProduct(product_).sum() + 0.5 * mass_[0] * v.squaredNorm();
}

}  // namespace ringwatch

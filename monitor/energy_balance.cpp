#include <ringwatch/monitor/energy_balance.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include <ringwatch/body/domain.h>
#include <ringwatch/body/element_energy.h>
#include <ringwatch/monitor/mean_rate.h>

namespace ringwatch {

namespace {

/// The components of a range of nodes in a row, which the compiler puts in packs as it does not columns of three.
Eigen::Map<const Eigen::VectorXd> nodes(const NodeVectors& all, Eigen::Index begin, Eigen::Index end) {
  return {all.data() + 3 * begin, 3 * (end - begin)};
}

/// Σ a·b over all nodes.
double dot(const NodeVectors& a, const NodeVectors& b, int threads) {
  return parallelSum(a.cols(), threads, [&](Eigen::Index begin, Eigen::Index end) {
    return nodes(a, begin, end).cwiseProduct(nodes(b, begin, end)).sum();
  });
}

}  // namespace

double roundingEnergy(const Body& body) {
  constexpr double strain = 1e-12;
  // So often the rounding of one element is told from energy: the usual tolerance of a balance is a tenth of its
  // measure.
  constexpr double roundings = 20;
  double density = 0;  // J/m³
  for (const auto& block : body.blocks()) {
    const Material& material = block->material();
    density = std::max(density, strain * strain * material.restModulus());
    // Laws of invariants that are not zero at rest lose there what they have of a small strain.
    for (int i = 0; i < 3; ++i)
      for (const double part : {-1.0, -0.7, -0.3, 0.3, 0.7, 1.0}) {
        Matrix3<double> F = Matrix3<double>::identity();
        F(i, i) += part * strain;
        density = std::max(density, roundings * std::abs(material.energy(F)));
      }
  }
  body.domain().largest({&density, 1});
  return density * sizeOfWhole(body).volume;
}

EnergyBalance::EnergyBalance(const Body& body)
    : body_(body), owned_(static_cast<std::int32_t>(body.domain().owned(body.nodeCount()))) {
  work_ = dissipated_ = Eigen::VectorXd::Zero(body.domain().whole() ? 1 : std::max(owned_, 2));
}

void EnergyBalance::record(const NodeVectors& x, const NodeVectors& resistingForce) {
  const Constraints& constraints = body_.constraints();
  if (!started_) {
    firstX_ = x;
    started_ = true;
  } else if (constraints.moving()) {
    // A component that has been constrained since then counts from now on.
    for (std::size_t k = 0; k < supported_.size(); ++k) {
      const std::int64_t i = constraints.components()[k];
      if (constraints.velocity().data()[i] == 0 || i / 3 >= owned_) continue;
      double& work = work_[place(i / 3)];
      work = std::fma(meanRate(supported_[k].force, resistingForce.data()[i]), x.data()[i] - supported_[k].x, work);
    }
  }
  if (!constraints.moving()) return;
  recordGuided(x, resistingForce);
  supported_.clear();
  for (const std::int64_t i : constraints.components()) supported_.push_back({x.data()[i], resistingForce.data()[i]});
}

void EnergyBalance::recordGuided(const NodeVectors& x, const NodeVectors& resistingForce) {
  using Eigen::Vector3d, Eigen::Matrix3d;
  std::vector<Guided> before = std::move(guided_);
  guided_.clear();
  for (const RigidBody& body : body_.constraints().rigidBodies()) {
    const RigidGuide& guide = body.guide();
    const std::size_t r = guided_.size();
    Guided& own = guided_.emplace_back(Guided{});
    if (!guide.any()) continue;
    const Vector3d point = body.point(x);
    const Matrix3d rotation = body.rotation(x);
    const RigidBody::Load inside = body.loadAbout(point, x, resistingForce),
                          outside = body.loadAbout(point, x, body_.externalForce());
    Vector3d::Map(own.point.data()) = point;
    Matrix3d::Map(own.rotation.data()) = rotation;
    Vector3d::Map(own.force.data()) = inside.force - outside.force;
    Vector3d::Map(own.torque.data()) = inside.torque - outside.torque;
    if (r >= before.size()) continue;
    const Guided& last = before[r];
    for (std::size_t c = 0; c < 3; ++c)
      if (guide.components[c]) work_[0] += meanRate(last.force[c], own.force[c]) * (own.point[c] - last.point[c]);
    if (guide.turning != RigidGuide::Turning::prescribed) continue;
    const Eigen::AngleAxisd turned(Matrix3d(rotation * Matrix3d::Map(last.rotation.data()).transpose()));
    work_[0] += turned.angle() * meanRate(turned.axis().dot(Vector3d::Map(last.torque.data())),
                                          turned.axis().dot(Vector3d::Map(own.torque.data())));
  }
}

Eigen::VectorXd EnergyBalance::products(const NodeVectors& a, const NodeVectors& b) const {
  if (body_.domain().whole()) return Eigen::VectorXd::Constant(1, dot(a, b, body_.threads()));
  Eigen::VectorXd ofNode = Eigen::VectorXd::Zero(work_.size());
  for (std::int32_t i = 0; i < owned_; ++i) ofNode[i] = dotAt(a, b, i);
  return ofNode;
}

void EnergyBalance::recordDamping(const NodeVectors& x, const NodeVectors& dampingForce) {
  if (dampedX_.cols() == x.cols()) {
    const NodeVectors moved = x - dampedX_;
    const Eigen::VectorXd before = products(dampingForce_, moved), now = products(dampingForce, moved);
    for (Eigen::Index i = 0; i < dissipated_.size(); ++i) dissipated_[i] += meanRate(before[i], now[i]);
  }
  dampedX_ = x;
  dampingForce_ = dampingForce;
}

void EnergyBalance::recordObstacles(double time, const DiscreteForces::ObstaclePower& power) {
  if (obstacles_) {
    const double passed = time - obstacles_->time,
                 damping = passed * meanRate(obstacles_->power.damping, power.damping);
    dissipated_[0] += damping;
    work_[0] += damping + passed * meanRate(obstacles_->power.elastic, power.elastic);
  }
  obstacles_ = {time, power};
}

Energies EnergyBalance::sums(const NodeVectors& x, const NodeVectors& v, double strainEnergy) const {
  Energies e;
  e.kinetic = 0.5 * parallelSum(v.cols(), body_.threads(), [&](Eigen::Index begin, Eigen::Index end) {
                const Eigen::VectorXd squares = v.middleCols(begin, end - begin).colwise().squaredNorm();
                return squares.dot(body_.lumpedMass().segment(begin, end - begin));
              });
  e.strain = strainEnergy;  // may be no number, as long as elements are inverted
  const NodeVectors& load = body_.externalForce();
  e.externalWork = work_[0] + parallelSum(x.cols(), body_.threads(), [&](Eigen::Index begin, Eigen::Index end) {
                     const auto part = nodes(load, begin, end);
                     if (part.cwiseAbs().sum() == 0) return 0.0;  // most bodies have few loaded nodes or none
                     return part.cwiseProduct(nodes(x, begin, end) - nodes(firstX_, begin, end)).sum();
                   });
  // Dead forces at moved components do no work on the body that their support does not take back.
  for (const std::int64_t i : body_.constraints().components())
    if (load.data()[i] != 0) e.externalWork -= load.data()[i] * (x.data()[i] - firstX_.data()[i]);
  e.dissipated = dissipated_[0];
  return e;
}

Energies EnergyBalance::sumsOfParts(const NodeVectors& x, const NodeVectors& v) const {
  Domain& domain = body_.domain();
  enum : std::size_t { kinetic, strain, external, dissipated };
  std::array<ExactSum, 4> sums;
  for (std::int32_t i = 0; i < owned_; ++i) {
    sums[kinetic].add(0.5 * body_.lumpedMass()[i] * dotAt(v, v, i));
    double work = work_[i];
    for (int c = 0; c < 3; ++c)
      if (!body_.constraints().isConstrained(i, c))
        work = std::fma(body_.externalForce()(c, i), x(c, i) - firstX_(c, i), work);
    sums[external].add(work);
    sums[dissipated].add(dissipated_[i]);
  }
  const std::vector<std::vector<double>> ofElements = strainEnergyOfElements(body_, x);
  for (std::size_t b = 0; b < ofElements.size(); ++b)
    for (std::size_t e = 0; e < ofElements[b].size(); ++e)
      if (domain.counts({b, e})) sums[strain].add(ofElements[b][e]);
  domain.sum(sums);
  return {.kinetic = sums[kinetic].value(),
          .strain = sums[strain].value(),
          .externalWork = sums[external].value(),
          .dissipated = sums[dissipated].value()};
}

Energies EnergyBalance::energies(const NodeVectors& x, const NodeVectors& v, double strainEnergy) {
  Energies e = body_.domain().whole() ? sums(x, v, strainEnergy) : sumsOfParts(x, v);
  const double total = e.kinetic + e.strain + e.dissipated - e.externalWork;
  if (!hasReference_ && std::isfinite(total)) {
    referenceEnergy_ = total;
    hasReference_ = true;
  }
  e.balanceError = total - referenceEnergy_;
  return e;
}

Energies EnergyBalance::evaluate(const NodeVectors& x, const NodeVectors& v) {
  own_.wantsForce = body_.constraints().moving();
  own_.wantsEnergy = true;
  body_.evaluate(x, own_, workspace_);
  if (own_.wantsForce && dampedX_.cols() == x.cols() && dampedX_ == x) own_.internalForce += dampingForce_;
  record(x, own_.internalForce);
  return energies(x, v, own_.strainEnergy);
}

}  // namespace ringwatch

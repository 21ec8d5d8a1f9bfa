#include <ringwatch/monitor/energy_balance.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

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

double roundingEnergy(double modulus, double volume) {
  constexpr double strain = 1e-12;
  return strain * strain * modulus * volume;
}

double roundingEnergy(const Body& body) {
  double modulus = 0;
  for (const auto& block : body.blocks()) modulus = std::max(modulus, block->material().restModulus());
  return roundingEnergy(modulus, body.volume());
}

void EnergyBalance::record(const NodeVectors& x, const NodeVectors& internalForce) {
  const Constraints& constraints = body_.constraints();
  if (!started_) {
    firstX_ = x;
    started_ = true;
  } else if (constraints.moving()) {
    // A component that has been constrained since then counts from now on.
    for (std::size_t k = 0; k < supported_.size(); ++k) {
      const std::int64_t i = constraints.components()[k];
      if (constraints.velocity().data()[i] != 0)
        prescribedWork_ += meanRate(supported_[k].force, internalForce.data()[i]) * (x.data()[i] - supported_[k].x);
    }
  }
  if (!constraints.moving()) return;
  recordGuided(x, internalForce);
  supported_.clear();
  for (const std::int64_t i : constraints.components()) supported_.push_back({x.data()[i], internalForce.data()[i]});
}

void EnergyBalance::recordGuided(const NodeVectors& x, const NodeVectors& internalForce) {
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
    const RigidBody::Load inside = body.loadAbout(point, x, internalForce),
                          outside = body.loadAbout(point, x, body_.externalForce());
    Vector3d::Map(own.point.data()) = point;
    Matrix3d::Map(own.rotation.data()) = rotation;
    Vector3d::Map(own.force.data()) = inside.force - outside.force;
    Vector3d::Map(own.torque.data()) = inside.torque - outside.torque;
    if (r >= before.size()) continue;
    const Guided& last = before[r];
    for (std::size_t c = 0; c < 3; ++c)
      if (guide.components[c])
        prescribedWork_ += meanRate(last.force[c], own.force[c]) * (own.point[c] - last.point[c]);
    if (guide.turning != RigidGuide::Turning::prescribed) continue;
    const Eigen::AngleAxisd turned(Matrix3d(rotation * Matrix3d::Map(last.rotation.data()).transpose()));
    prescribedWork_ += turned.angle() * meanRate(turned.axis().dot(Vector3d::Map(last.torque.data())),
                                                 turned.axis().dot(Vector3d::Map(own.torque.data())));
  }
}

void EnergyBalance::recordDamping(double time, const NodeVectors& x, const NodeVectors& v,
                                  const NodeVectors& dampingForce, double inForce) {
  const Constraints& constraints = body_.constraints();
  DampingPower now{time, dot(dampingForce, v, body_.threads()) + inForce, 0};
  if (constraints.moving()) {
    now.atSupports = dot(dampingForce, constraints.velocity(), body_.threads());
    for (const RigidBody& body : constraints.rigidBodies()) {
      if (!body.guide().moves()) continue;
      const RigidBody::Load load = body.loadAbout(body.point(x), x, dampingForce);
      now.atSupports += load.force.dot(body.guide().velocity) + load.torque.dot(body.guide().angularVelocity);
    }
  }
  if (damping_) {
    const double passed = time - damping_->time;
    dissipated_ += passed * meanRate(damping_->all, now.all);
    prescribedWork_ += passed * meanRate(damping_->atSupports, now.atSupports);
  }
  damping_ = now;
}

void EnergyBalance::recordObstacles(double time, const DiscreteForces::ObstaclePower& power) {
  if (obstacles_) {
    const double passed = time - obstacles_->time,
                 damping = passed * meanRate(obstacles_->power.damping, power.damping);
    dissipated_ += damping;
    prescribedWork_ += damping + passed * meanRate(obstacles_->power.elastic, power.elastic);
  }
  obstacles_ = {time, power};
}

Energies EnergyBalance::energies(const NodeVectors& x, const NodeVectors& v, double strainEnergy) {
  Energies e;
  e.kinetic = 0.5 * parallelSum(v.cols(), body_.threads(), [&](Eigen::Index begin, Eigen::Index end) {
                const Eigen::VectorXd squares = v.middleCols(begin, end - begin).colwise().squaredNorm();
                return squares.dot(body_.lumpedMass().segment(begin, end - begin));
              });
  e.strain = strainEnergy;  // may be no number, as long as elements are inverted
  const NodeVectors& load = body_.externalForce();
  e.externalWork = prescribedWork_ + parallelSum(x.cols(), body_.threads(), [&](Eigen::Index begin, Eigen::Index end) {
                     const auto part = nodes(load, begin, end);
                     if (part.cwiseAbs().sum() == 0) return 0.0;  // most bodies have few loaded nodes or none
                     return part.cwiseProduct(nodes(x, begin, end) - nodes(firstX_, begin, end)).sum();
                   });
  // Dead forces at moved components do no work on the body that their support does not take back.
  for (const std::int64_t i : body_.constraints().components())
    if (load.data()[i] != 0) e.externalWork -= load.data()[i] * (x.data()[i] - firstX_.data()[i]);
  e.dissipated = dissipated_;
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
  record(x, own_.internalForce);
  return energies(x, v, own_.strainEnergy);
}

}  // namespace ringwatch

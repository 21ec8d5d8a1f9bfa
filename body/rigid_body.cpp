#include <ringwatch/body/rigid_body.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <ringwatch/base/error.h>
#include <ringwatch/base/rounding.h>

namespace ringwatch {
namespace {

/// Least moment of inertia over the sum of the three: below, nodes lie on a line as far as rounding leaves the turning
/// about it (projectionRounding grows with its root).
constexpr double leastInertia = 1e-8;

Eigen::Matrix3d crossMatrix(const Eigen::Vector3d& a) {
  return (Eigen::Matrix3d() << 0, -a[2], a[1], a[2], 0, -a[0], -a[1], a[0], 0).finished();
}
Eigen::Matrix3d inertiaOf(const Eigen::Matrix3d& secondMoment) {
  return secondMoment.trace() * Eigen::Matrix3d::Identity() - secondMoment;
}

/// The rotation F with Σ m s × F s = hL, by Newton's iteration for the vector q of its unit quaternion: q₀ J q + q × J
/// q = hL/2. False where there is none that turns by less than a right angle.
bool turn(const Eigen::Matrix3d& inertia, const Eigen::Vector3d& angularImpulse, Eigen::Matrix3d& rotation) {
  constexpr int iterations = 50;
  constexpr double sineOfHalf = 0.7;  // of a right angle
  const Eigen::Vector3d target = 0.5 * angularImpulse;
  const Eigen::LLT<Eigen::Matrix3d> factor(inertia);
  Eigen::Vector3d q = factor.solve(target);
  double before = std::numeric_limits<double>::infinity();
  for (int i = 0;; ++i) {
    const double sine2 = q.squaredNorm();
    if (!(sine2 < sineOfHalf * sineOfHalf) || i == iterations) return false;
    const double q0 = std::sqrt(1 - sine2);
    const Eigen::Vector3d Jq = inertia * q;
    const Eigen::Vector3d fault = q0 * Jq + q.cross(Jq) - target;
    const Eigen::Matrix3d slope = q0 * inertia - Jq * q.transpose() / q0 + crossMatrix(q) * inertia - crossMatrix(Jq);
    const Eigen::Vector3d change = slope.partialPivLu().solve(fault);
    // Quadratic convergence ends in rounding, where corrections no longer shrink.
    if (!(change.norm() < before) || change.isZero(0)) break;
    before = change.norm();
    q -= change;
  }
  const double sine2 = q.squaredNorm();
  if (!(sine2 < sineOfHalf * sineOfHalf)) return false;
  const double q0 = std::sqrt(1 - sine2);
  rotation = Eigen::Quaterniond(q0, q[0], q[1], q[2]).toRotationMatrix();
  return true;
}

/// By the length of a vector, in radians, about it.
Eigen::Matrix3d rotationBy(const Eigen::Vector3d& angle) {
  const double size = angle.norm();
  if (size == 0) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(size, angle / size).toRotationMatrix();
}

}  // namespace

RigidBody::RigidBody(std::string name, std::vector<std::int32_t> nodes, NodeVectorsView X,
                     const Eigen::VectorXd& lumpedMass, RigidGuide guide)
    : name_(std::move(name)), nodes_(std::move(nodes)), guide_(std::move(guide)) {
  if (nodes_.size() < 3)
    throw InputError(joinText("rigid body ", name_, ": has ", nodes_.size(), " node", nodes_.size() == 1 ? "" : "s",
                              "; must be three that lie on no line, or more"));
  for (const std::int32_t node : nodes_) {
    masses_.push_back(lumpedMass[node]);
    mass_ += lumpedMass[node];
  }
  const Eigen::Vector3d centre = centreOf(X);
  arms_.resize(3, static_cast<Eigen::Index>(nodes_.size()));
  for (std::size_t k = 0; k < nodes_.size(); ++k) arms_.col(k) = X.col(nodes_[k]) - centre;
  inertia_ = inertiaOf(secondMoment(X, centre));
  const Eigen::Vector3d moments = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(inertia_).eigenvalues();
  if (!(moments[0] > leastInertia * moments.sum()))
    throw InputError(joinText("rigid body ", name_, ": its ", nodes_.size(),
                              " nodes lie on a line, about which they have no inertia; add a node beside it"));
  if (guide_.point && !guide_.holdsPoint())
    throw InputError(
        joinText("rigid body ", name_, ": a point beside its centre of mass goes with all three components"));
  if (guide_.point && !guide_.all() && !guide_.velocity.isZero(0))
    throw InputError(
        joinText("rigid body ", name_, ": a point about which it turns freely must stay, or be its centre of mass"));
  if (guide_.turning == RigidGuide::Turning::aboutAxis && guide_.axis.isZero(0))
    throw InputError(joinText("rigid body ", name_, ": its axis has no direction"));
  pointArm_ = guide_.point ? Eigen::Vector3d(*guide_.point - centre) : Eigen::Vector3d::Zero();
  const Eigen::Matrix3d aboutPoint = inertiaOf(secondMoment(X, centre + pointArm_));
  // The least moment of inertia about a direction in which it may turn.
  double least = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(aboutPoint).eigenvalues()[0];
  if (guide_.turning == RigidGuide::Turning::aboutAxis)
    least = guide_.axis.dot(aboutPoint * guide_.axis) / guide_.axis.squaredNorm();
  // Of v_c + ω × s: five roundings of each component, of |v_c| + |ω| |s|; in the norm of the masses, |ω| |s| comes to
  // at most the root of Σ m s² / least moment of the part of ω. Two more for what is made of it.
  constexpr double roundings = 8;
  projectionRounding_ = roundings * unitRoundoff * (1 + std::sqrt(0.5 * aboutPoint.trace() / least));
}

void RigidBody::guideAt(const Eigen::Vector3d& velocity, const Eigen::Vector3d& angularVelocity) {
  const bool stays = guide_.point && !guide_.all();
  for (int c = 0; c < 3; ++c)
    guide_.velocity[c] = guide_.components[static_cast<std::size_t>(c)] && !stays ? velocity[c] : 0;
  if (guide_.turning == RigidGuide::Turning::prescribed) guide_.angularVelocity = angularVelocity;
}

Eigen::Vector3d RigidBody::centreOf(NodeVectorsView x) const {
  // From the first node on, as the body may be far from the origin.
  const Eigen::Vector3d first = x.col(nodes_.front());
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < nodes_.size(); ++k) sum += masses_[k] * (x.col(nodes_[k]) - first);
  return first + sum / mass_;
}

Eigen::Vector3d RigidBody::pointOf(NodeVectorsView x, const Eigen::Vector3d& centre) const {
  return guide_.point ? Eigen::Vector3d(centre + rotationOf(x, centre) * pointArm_) : centre;
}

Eigen::Matrix3d RigidBody::secondMoment(NodeVectorsView x, const Eigen::Vector3d& from) const {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const Eigen::Vector3d s = x.col(nodes_[k]) - from;
    sum += masses_[k] * s * s.transpose();
  }
  return sum;
}

template <class Velocity>
void RigidBody::momenta(NodeVectorsView x, const Eigen::Vector3d& about, const Velocity& v, Eigen::Vector3d& linear,
                        Eigen::Vector3d& angular) const {
  linear.setZero();
  angular.setZero();
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const Eigen::Vector3d s = x.col(nodes_[k]) - about, momentum = masses_[k] * v(k);
    linear += momentum;
    angular += s.cross(momentum);
  }
}

Eigen::Vector3d RigidBody::freeVelocity(const Eigen::Vector3d& momentum) const {
  Eigen::Vector3d velocity = momentum / mass_;
  for (int c = 0; c < 3; ++c)
    if (guide_.components[static_cast<std::size_t>(c)]) velocity[c] = 0;
  return velocity;
}

Eigen::Vector3d RigidBody::freeTurning(const Eigen::Vector3d& angularMomentum, const Eigen::Matrix3d& inertia) const {
  const Eigen::Vector3d& axis = guide_.axis;
  if (guide_.turning == RigidGuide::Turning::prescribed) return Eigen::Vector3d::Zero();
  if (guide_.turning == RigidGuide::Turning::aboutAxis)
    return (axis.dot(angularMomentum) / axis.dot(inertia * axis)) * axis;
  return inertia.llt().solve(angularMomentum);
}

Eigen::Matrix3d RigidBody::rotationOf(NodeVectorsView x, const Eigen::Vector3d& centre) const {
  Eigen::Matrix3d product = Eigen::Matrix3d::Zero();
  for (std::size_t k = 0; k < nodes_.size(); ++k)
    product += masses_[k] * (x.col(nodes_[k]) - centre) * arms_.col(k).transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(product, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Matrix3d &U = svd.matrixU(), &V = svd.matrixV();
  // Of nodes in a plane the third direction is known but for its sign.
  const double sign = (U * V.transpose()).determinant() < 0 ? -1 : 1;
  return U * Eigen::Vector3d(1, 1, sign).asDiagonal() * V.transpose();
}

RigidBody::Motion RigidBody::motion(NodeVectorsView x, NodeVectorsView v) const {
  Motion motion;
  motion.centre = centreOf(x);
  motion.rotation = rotationOf(x, motion.centre);
  momenta(
      x, motion.centre, [&](std::size_t k) { return v.col(nodes_[k]); }, motion.velocity, motion.angularMomentum);
  motion.velocity /= mass_;
  motion.angularVelocity = inertiaOf(secondMoment(x, motion.centre)).llt().solve(motion.angularMomentum);
  return motion;
}

RigidBody::Load RigidBody::load(NodeVectorsView x, NodeVectorsView forces) const {
  return loadAbout(centreOf(x), x, forces);
}

RigidBody::Load RigidBody::loadAbout(const Eigen::Vector3d& about, NodeVectorsView x, NodeVectorsView forces) const {
  Load load{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  for (const std::int32_t node : nodes_) {
    const Eigen::Vector3d s = x.col(node) - about, force = forces.col(node);
    load.force += force;
    load.torque += s.cross(force);
  }
  return load;
}

Eigen::Vector3d RigidBody::point(NodeVectorsView x) const { return pointOf(x, centreOf(x)); }
Eigen::Matrix3d RigidBody::rotation(NodeVectorsView x) const { return rotationOf(x, centreOf(x)); }

RigidBody::Load RigidBody::support(NodeVectorsView x, NodeVectorsView v, NodeVectorsView forces,
                                   const Eigen::Vector3d& acceleration,
                                   const Eigen::Vector3d& angularAcceleration) const {
  const Eigen::Vector3d centre = centreOf(x), about = pointOf(x, centre), arm = centre - about;
  const Eigen::Matrix3d inertia = inertiaOf(secondMoment(x, about));
  const Load applied = loadAbout(about, x, forces);
  const Eigen::Vector3d rate = motion(x, v).angularVelocity;
  Eigen::Vector3d ofPoint = freeVelocity(applied.force);
  for (int c = 0; c < 3; ++c)
    if (guide_.components[static_cast<std::size_t>(c)]) ofPoint[c] = acceleration[c];
  const Eigen::Vector3d taken = rate.cross(inertia * rate) + mass_ * arm.cross(ofPoint);
  const Eigen::Vector3d turning = guide_.turning == RigidGuide::Turning::prescribed
                                      ? angularAcceleration
                                      : freeTurning(applied.torque - taken, inertia);
  Load support{mass_ * (ofPoint + turning.cross(arm) + rate.cross(rate.cross(arm))) - applied.force,
               inertia * turning + taken - applied.torque};
  for (int c = 0; c < 3; ++c)
    if (!guide_.components[static_cast<std::size_t>(c)]) support.force[c] = 0;
  if (guide_.turning == RigidGuide::Turning::free) support.torque.setZero();
  if (guide_.turning == RigidGuide::Turning::aboutAxis)
    support.torque -= (guide_.axis.dot(support.torque) / guide_.axis.squaredNorm()) * guide_.axis;
  return support;
}

void RigidBody::project(NodeVectorsView x, NodeVectors& v) const {
  const Eigen::Vector3d centre = centreOf(x), about = pointOf(x, centre);
  Eigen::Vector3d momentum, angular;
  momenta(
      x, about, [&](std::size_t k) { return v.col(nodes_[k]); }, momentum, angular);
  const Eigen::Vector3d velocity = freeVelocity(momentum),
                        rate = freeTurning(angular, inertiaOf(secondMoment(x, about)));
  for (const std::int32_t node : nodes_) {
    const Eigen::Vector3d s = x.col(node) - about;
    v.col(node) = velocity + rate.cross(s);
  }
}

void RigidBody::impose(NodeVectorsView x, NodeVectors& v) const {
  if (!guide_.moves()) return project(x, v);
  const Eigen::Vector3d about = point(x);
  const auto add = [&](double sign) {
    for (const std::int32_t node : nodes_) {
      const Eigen::Vector3d s = x.col(node) - about;
      v.col(node) += sign * (guide_.velocity + guide_.angularVelocity.cross(s));
    }
  };
  add(-1);
  project(x, v);
  add(1);
}

bool RigidBody::drift(NodeVectorsView x, NodeVectorsView v, double kick, NodeVectorsView a, double h,
                      NodeVectors& positions, NodeVectors& velocities) const {
  const Eigen::Vector3d centre = centreOf(x);
  const Eigen::Matrix3d orientation = rotationOf(x, centre);
  const Eigen::Vector3d about = guide_.point ? Eigen::Vector3d(centre + orientation * pointArm_) : centre;
  Eigen::Vector3d momentum, angular;
  momenta(
      x, about,
      [&](std::size_t k) {
        Eigen::Vector3d own = v.col(nodes_[k]);
        if (kick != 0) own += kick * a.col(nodes_[k]);
        return own;
      },
      momentum, angular);
  const Eigen::Vector3d velocity = freeVelocity(momentum) + guide_.velocity;
  const Eigen::Matrix3d inertia = inertiaOf(secondMoment(x, about));
  Eigen::Matrix3d step;
  if (guide_.turning == RigidGuide::Turning::free) {
    if (!turn(inertia, h * angular, step)) return false;
  } else {
    step = rotationBy(h * (freeTurning(angular, inertia) + guide_.angularVelocity));
  }
  // The shape is that at rest, so that rounding does not add up in it.
  const Eigen::Matrix3d rotation = step * orientation;
  const Eigen::Vector3d rate = freeTurning(angular, step * inertia * step.transpose()) + guide_.angularVelocity,
                        way = h * velocity;
  positions.resize(3, arms_.cols());
  velocities.resize(3, arms_.cols());
  for (Eigen::Index k = 0; k < arms_.cols(); ++k) {
    const Eigen::Vector3d s = rotation * (arms_.col(k) - pointArm_);
    positions.col(k) = about + way + s;
    velocities.col(k) = velocity + rate.cross(s);
  }
  return true;
}

}  // namespace ringwatch

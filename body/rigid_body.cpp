#include <ringwatch/body/rigid_body.h>

#include <algorithm>
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

}  // namespace

RigidBody::RigidBody(std::string name, std::vector<std::int32_t> nodes, NodeVectorsView X,
                     const Eigen::VectorXd& lumpedMass)
    : name_(std::move(name)), nodes_(std::move(nodes)) {
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
  // Of v_c + ω × s: five roundings of each component, of |v_c| + |ω| |s|; in the norm of the masses, |ω| |s| comes to
  // at most the root of Σ m s² / least moment of the part of ω. Two more for what is made of it.
  constexpr double roundings = 8;
  projectionRounding_ = roundings * unitRoundoff * (1 + std::sqrt(0.5 * moments.sum() / moments[0]));
}

Eigen::Vector3d RigidBody::centreOf(NodeVectorsView x) const {
  // From the first node on, as the body may be far from the origin.
  const Eigen::Vector3d first = x.col(nodes_.front());
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < nodes_.size(); ++k) sum += masses_[k] * (x.col(nodes_[k]) - first);
  return first + sum / mass_;
}

Eigen::Matrix3d RigidBody::secondMoment(NodeVectorsView x, const Eigen::Vector3d& centre) const {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const Eigen::Vector3d s = x.col(nodes_[k]) - centre;
    sum += masses_[k] * s * s.transpose();
  }
  return sum;
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
  motion.velocity.setZero();
  motion.angularMomentum.setZero();
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const std::int32_t node = nodes_[k];
    const Eigen::Vector3d s = x.col(node) - motion.centre, momentum = masses_[k] * v.col(node);
    motion.velocity += momentum;
    motion.angularMomentum += s.cross(momentum);
  }
  motion.velocity /= mass_;
  motion.angularVelocity = inertiaOf(secondMoment(x, motion.centre)).llt().solve(motion.angularMomentum);
  return motion;
}

RigidBody::Load RigidBody::load(NodeVectorsView x, NodeVectorsView forces) const {
  const Eigen::Vector3d centre = centreOf(x);
  Load load{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  for (const std::int32_t node : nodes_) {
    const Eigen::Vector3d s = x.col(node) - centre, force = forces.col(node);
    load.force += force;
    load.torque += s.cross(force);
  }
  return load;
}

void RigidBody::project(NodeVectorsView x, NodeVectors& v) const {
  const Eigen::Vector3d centre = centreOf(x);
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero(), angular = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const Eigen::Vector3d s = x.col(nodes_[k]) - centre, momentum = masses_[k] * v.col(nodes_[k]);
    velocity += momentum;
    angular += s.cross(momentum);
  }
  velocity /= mass_;
  const Eigen::Vector3d rate = inertiaOf(secondMoment(x, centre)).llt().solve(angular);
  for (const std::int32_t node : nodes_) {
    const Eigen::Vector3d s = x.col(node) - centre;
    v.col(node) = velocity + rate.cross(s);
  }
}

bool RigidBody::drift(NodeVectorsView x, NodeVectorsView v, double kick, NodeVectorsView a, double h,
                      NodeVectors& positions, NodeVectors& velocities) const {
  const Eigen::Vector3d centre = centreOf(x);
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero(), angular = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    Eigen::Vector3d own = v.col(nodes_[k]);
    if (kick != 0) own += kick * a.col(nodes_[k]);
    const Eigen::Vector3d s = x.col(nodes_[k]) - centre, momentum = masses_[k] * own;
    velocity += momentum;
    angular += s.cross(momentum);
  }
  velocity /= mass_;
  Eigen::Matrix3d step;
  const Eigen::Matrix3d inertia = inertiaOf(secondMoment(x, centre));
  if (!turn(inertia, h * angular, step)) return false;
  // The shape is that at rest, so that rounding does not add up in it.
  const Eigen::Matrix3d rotation = step * rotationOf(x, centre);
  const Eigen::Vector3d rate = (step * inertia * step.transpose()).llt().solve(angular), way = h * velocity;
  positions.resize(3, arms_.cols());
  velocities.resize(3, arms_.cols());
  for (Eigen::Index k = 0; k < arms_.cols(); ++k) {
    const Eigen::Vector3d s = rotation * arms_.col(k);
    positions.col(k) = centre + way + s;
    velocities.col(k) = velocity + rate.cross(s);
  }
  return true;
}

}  // namespace ringwatch

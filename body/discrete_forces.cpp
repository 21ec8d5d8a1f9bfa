#include <ringwatch/body/discrete_forces.h>

#include <algorithm>
#include <cmath>

#include <ringwatch/base/error.h>
#include <ringwatch/base/rounding.h>
#include <ringwatch/base/sort_unique.h>

namespace ringwatch {
namespace {

// Of majorants with room: the sine of the angle by which a direction may turn, and the share by which the depth that
// friction grows with may grow.
constexpr double turning = 0.02, deepening = 0.5;

void requireConstant(const char* name, double value) {
  if (!(value >= 0) || !std::isfinite(value)) throw InputError(joinText(name, " = ", value, ": must be >= 0"));
}

/// The line from a spring's node to its other end.
struct Line {
  Eigen::Vector3d direction;  // zero where the nodes are at one place
  double length;
};
Line lineOf(const Spring& spring, NodeVectorsView x) {
  const Eigen::Vector3d line = x.col(spring.other) - x.col(spring.node);
  const double length = line.norm();
  return {length > 0 ? Eigen::Vector3d(line / length) : Eigen::Vector3d::Zero(), length};
}

/// Velocity of a node against an obstacle, cut into its parts.
struct Slide {
  double normal;          // m/s, outward
  Eigen::Vector3d along;  // m/s
};
Slide slideOf(const Eigen::Vector3d& velocity, const Eigen::Vector3d& normal) {
  const double out = normal.dot(velocity);
  return {out, velocity - out * normal};
}

/// What damping and friction resist with, N.
Eigen::Vector3d resistance(const PenaltyContact& contact, std::size_t k, const Obstacle::Surface& at,
                           const Eigen::Vector3d& velocity) {
  const Slide slide = slideOf(velocity, at.normal);
  Eigen::Vector3d force = contact.damping[k] * slide.normal * at.normal;
  if (contact.friction > 0)
    force += contact.friction * contact.penalty[k] * -at.gap / std::max(slide.along.norm(), contact.slip) * slide.along;
  return force;
}

}  // namespace

void DiscreteForces::note(const std::vector<std::int32_t>& nodes) {
  place_.resize(nodeCount_, -1);
  for (const std::int32_t node : nodes) {
    if (node < 0 || node >= nodeCount_) throw InputError(joinText("node ", node, ": must be one of ", nodeCount_));
    nodes_.push_back(node);
  }
  sortUnique(nodes_);
  for (std::size_t k = 0; k < nodes_.size(); ++k) place_[nodes_[k]] = static_cast<std::int32_t>(k);
}

void DiscreteForces::add(const std::vector<Spring>& springs) {
  std::vector<std::int32_t> nodes;
  for (const Spring& spring : springs) {
    requireConstant("stiffness", spring.stiffness);
    requireConstant("damping", spring.damping);
    requireConstant("length", spring.length);
    if (spring.other == spring.node) throw InputError(joinText("node ", spring.node, ": a spring to the node itself"));
    nodes.push_back(spring.node);
    if (spring.other >= 0) nodes.push_back(spring.other);
  }
  note(nodes);
  damped_ = damped_ || std::any_of(springs.begin(), springs.end(), [](const Spring& one) { return one.damping > 0; });
  springs_.insert(springs_.end(), springs.begin(), springs.end());
}

std::size_t DiscreteForces::add(std::unique_ptr<Obstacle> obstacle) {
  shared_->obstacles.push_back({std::move(obstacle)});
  return shared_->obstacles.size() - 1;
}

void DiscreteForces::add(PenaltyContact contact) {
  if (contact.obstacle >= shared_->obstacles.size())
    throw InputError(joinText("obstacle ", contact.obstacle, ": there are ", shared_->obstacles.size()));
  if (contact.penalty.size() != contact.nodes.size() || contact.damping.size() != contact.nodes.size())
    throw InputError("contact: a penalty and a damping are needed for each node");
  for (const double penalty : contact.penalty) requireConstant("penalty", penalty);
  for (const double damping : contact.damping) requireConstant("damping", damping);
  requireConstant("friction", contact.friction);
  if (contact.friction > 0 && !(contact.slip > 0))
    throw InputError(joinText("slip = ", contact.slip, " m/s: must be > 0 where there is friction"));
  note(contact.nodes);
  friction_ = friction_ || contact.friction > 0;
  damped_ = damped_ || friction_ ||
            std::any_of(contact.damping.begin(), contact.damping.end(), [](double c) { return c > 0; });
  contacts_.push_back(std::move(contact));
}

void DiscreteForces::place(std::size_t obstacle, const Eigen::Vector3d& displacement, const Eigen::Vector3d& velocity) {
  MovingObstacle& moved = shared_->obstacles.at(obstacle);
  moved.displacement = displacement;
  moved.velocity = velocity;
}

Obstacle::Surface DiscreteForces::surface(std::size_t obstacle, const Eigen::Vector3d& x) const {
  const MovingObstacle& own = shared_->obstacles[obstacle];
  return own.shape->at(x - own.displacement);
}

DiscreteForces DiscreteForces::restrictedTo(std::span<const std::int32_t> nodes) const {
  DiscreteForces part(static_cast<std::int32_t>(nodes.size()));
  part.shared_ = shared_;
  std::vector<std::int32_t> numberOf(nodeCount_, -1);
  for (std::size_t i = 0; i < nodes.size(); ++i) numberOf[nodes[i]] = static_cast<std::int32_t>(i);
  std::vector<Spring> springs;
  for (Spring spring : springs_) {
    const bool ground = spring.other < 0;
    spring.node = numberOf[spring.node];
    spring.other = ground ? -1 : numberOf[spring.other];
    if (spring.node >= 0 && (ground || spring.other >= 0)) springs.push_back(spring);
  }
  part.add(springs);
  for (const PenaltyContact& contact : contacts_) {
    PenaltyContact own{contact.obstacle, {}, {}, {}, contact.friction, contact.slip};
    for (std::size_t k = 0; k < contact.nodes.size(); ++k)
      if (const std::int32_t node = numberOf[contact.nodes[k]]; node >= 0) {
        own.nodes.push_back(node);
        own.penalty.push_back(contact.penalty[k]);
        own.damping.push_back(contact.damping[k]);
      }
    if (!own.nodes.empty()) part.add(std::move(own));
  }
  return part;
}

std::vector<std::int32_t> DiscreteForces::partners(std::span<const std::int32_t> nodes) const {
  std::vector<std::int32_t> others;
  for (const Spring& spring : springs_) {
    if (spring.other < 0) continue;
    if (std::binary_search(nodes.begin(), nodes.end(), spring.node)) others.push_back(spring.other);
    if (std::binary_search(nodes.begin(), nodes.end(), spring.other)) others.push_back(spring.node);
  }
  sortUnique(others);
  return others;
}

Eigen::Matrix3d DiscreteForces::toGround(const Spring& spring, double k) {
  if (!spring.direction) return k * Eigen::Matrix3d::Identity();
  return k * *spring.direction * spring.direction->transpose();
}

Eigen::Matrix3d DiscreteForces::axial(const Spring& spring, NodeVectorsView x, double f, bool positivePart) {
  const double k = spring.stiffness, c = f * spring.damping;
  if (spring.length == 0) return (k + c) * Eigen::Matrix3d::Identity();
  const Line line = lineOf(spring, x);
  // Of two nodes at one place no direction is known, and any has the stiffness k at most.
  if (!(line.length > 0)) return (positivePart ? k + c : 0.0) * Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d along = line.direction * line.direction.transpose();
  double across = k * (1 - spring.length / line.length);
  if (positivePart) across = std::max(0.0, across);
  return (k + c) * along + across * (Eigen::Matrix3d::Identity() - along);
}

void DiscreteForces::addInternalForce(NodeVectorsView x, NodeVectors& f) const {
  for (const Spring& spring : springs_) {
    if (spring.other < 0) {
      const Eigen::Vector3d moved = x.col(spring.node) - spring.anchor;
      f.col(spring.node) += spring.direction
                                ? Eigen::Vector3d(spring.stiffness * spring.direction->dot(moved) * *spring.direction)
                                : Eigen::Vector3d(spring.stiffness * moved);
      continue;
    }
    const Line line = lineOf(spring, x);
    const Eigen::Vector3d pull = spring.stiffness * (line.length - spring.length) * line.direction;
    f.col(spring.node) -= pull;
    f.col(spring.other) += pull;
  }
  for (const PenaltyContact& contact : contacts_)
    for (std::size_t k = 0; k < contact.nodes.size(); ++k) {
      const std::int32_t node = contact.nodes[k];
      const Obstacle::Surface at = surface(contact.obstacle, x.col(node));
      if (at.gap < 0) f.col(node) += contact.penalty[k] * at.gap * at.normal;
    }
}

double DiscreteForces::energy(NodeVectorsView x) const {
  double sum = 0;
  for (const Spring& spring : springs_) {
    double stretch = 0;
    if (spring.other >= 0)
      stretch = lineOf(spring, x).length - spring.length;
    else if (const Eigen::Vector3d moved = x.col(spring.node) - spring.anchor; spring.direction)
      stretch = spring.direction->dot(moved);
    else
      stretch = moved.norm();
    sum += 0.5 * spring.stiffness * stretch * stretch;
  }
  for (const PenaltyContact& contact : contacts_)
    for (std::size_t k = 0; k < contact.nodes.size(); ++k)
      if (const double gap = surface(contact.obstacle, x.col(contact.nodes[k])).gap; gap < 0)
        sum += 0.5 * contact.penalty[k] * gap * gap;
  return sum;
}

void DiscreteForces::addDampingForce(NodeVectorsView x, NodeVectorsView v, NodeVectors& f) const {
  for (const Spring& spring : springs_) {
    if (spring.damping == 0) continue;
    if (spring.other < 0) {
      f.col(spring.node) += toGround(spring, spring.damping) * v.col(spring.node);
      continue;
    }
    Eigen::Vector3d resisted = spring.damping * (v.col(spring.node) - v.col(spring.other));
    if (spring.length > 0) {
      const Eigen::Vector3d direction = lineOf(spring, x).direction;
      resisted = direction * direction.dot(resisted);
    }
    f.col(spring.node) += resisted;
    f.col(spring.other) -= resisted;
  }
  for (const PenaltyContact& contact : contacts_) {
    const Eigen::Vector3d& velocity = shared_->obstacles[contact.obstacle].velocity;
    for (std::size_t k = 0; k < contact.nodes.size(); ++k) {
      const std::int32_t node = contact.nodes[k];
      const Obstacle::Surface at = surface(contact.obstacle, x.col(node));
      if (at.gap < 0) f.col(node) += resistance(contact, k, at, v.col(node) - velocity);
    }
  }
}

DiscreteForces::ObstaclePower DiscreteForces::obstaclePower(NodeVectorsView x, NodeVectorsView v) const {
  ObstaclePower power;
  for (const PenaltyContact& contact : contacts_) {
    const Eigen::Vector3d& velocity = shared_->obstacles[contact.obstacle].velocity;
    if (velocity.isZero(0)) continue;
    for (std::size_t k = 0; k < contact.nodes.size(); ++k) {
      const std::int32_t node = contact.nodes[k];
      const Obstacle::Surface at = surface(contact.obstacle, x.col(node));
      if (!(at.gap < 0)) continue;
      power.elastic -= contact.penalty[k] * at.gap * at.normal.dot(velocity);
      power.damping -= resistance(contact, k, at, v.col(node) - velocity).dot(velocity);
    }
  }
  return power;
}

void DiscreteForces::addTangentProduct(NodeVectorsView x, NodeVectorsView u, NodeVectors& Ku,
                                       std::optional<double> factor) const {
  const double f = factor.value_or(dampingFactor());
  for (const Spring& spring : springs_) {
    if (spring.other < 0) {
      Ku.col(spring.node) += toGround(spring, spring.stiffness + f * spring.damping) * u.col(spring.node);
      continue;
    }
    const Eigen::Vector3d pull = axial(spring, x, f, false) * (u.col(spring.node) - u.col(spring.other));
    Ku.col(spring.node) += pull;
    Ku.col(spring.other) -= pull;
  }
  for (const PenaltyContact& contact : contacts_)
    for (std::size_t k = 0; k < contact.nodes.size(); ++k) {
      const std::int32_t node = contact.nodes[k];
      const Obstacle::Surface at = surface(contact.obstacle, x.col(node));
      if (!(at.gap < 0)) continue;
      const Eigen::Vector3d own = u.col(node);
      Ku.col(node) += (contact.penalty[k] + f * contact.damping[k]) * at.normal.dot(own) * at.normal +
                      contact.penalty[k] * at.gap * (at.curvature * own);
    }
}

double DiscreteForces::form(NodeVectorsView x, NodeVectorsView v) const {
  double sum = 0;
  forEachBlock(
      x, [&](std::int32_t i, std::int32_t j, const Eigen::Matrix3d& block) { sum += v.col(i).dot(block * v.col(j)); });
  return sum;
}

DiscreteForces::DampingForm DiscreteForces::dampingForm(NodeVectorsView x, NodeVectorsView v) const {
  DampingForm form;
  const double f = dampingFactor();
  const auto add = [&](double damping, const Eigen::Vector3d& velocity, const std::optional<Eigen::Vector3d>& along) {
    const double most = f * damping * velocity.squaredNorm(), part = along ? along->dot(velocity) : 0;
    form.value += along ? f * damping * part * part : most;
    form.rounding += directionRounding * most;
  };
  for (const Spring& spring : springs_) {
    if (spring.other < 0)
      add(spring.damping, v.col(spring.node), spring.direction);
    else
      add(spring.damping, v.col(spring.node) - v.col(spring.other),
          spring.length == 0 ? std::nullopt : std::optional(lineOf(spring, x).direction));
  }
  for (const PenaltyContact& contact : contacts_)
    for (std::size_t k = 0; k < contact.nodes.size(); ++k) {
      const Obstacle::Surface at = surface(contact.obstacle, x.col(contact.nodes[k]));
      if (at.gap < 0) add(contact.damping[k], v.col(contact.nodes[k]), at.normal);
    }
  return form;
}

void DiscreteForces::majorants(NodeVectorsView x, bool room, std::vector<Eigen::Matrix3d>& matrices) const {
  const double f = dampingFactor(), reach = shared_->reach;
  const Eigen::Matrix3d I = Eigen::Matrix3d::Identity();
  matrices.assign(nodes_.size(), Eigen::Matrix3d::Zero());
  for (const Spring& spring : springs_) {
    if (spring.other < 0) {
      matrices[placeOf(spring.node)] += toGround(spring, spring.stiffness + f * spring.damping);
      continue;
    }
    // [1 -1; -1 1] <= 2.
    Eigen::Matrix3d own = 2 * axial(spring, x, f, true);
    if (room && spring.length > 0) own += 2 * turning * (spring.stiffness + f * spring.damping) * I;
    matrices[placeOf(spring.node)] += own;
    matrices[placeOf(spring.other)] += own;
  }
  for (const PenaltyContact& contact : contacts_)
    for (std::size_t k = 0; k < contact.nodes.size(); ++k) {
      const std::int32_t node = contact.nodes[k];
      const Obstacle::Surface at = surface(contact.obstacle, x.col(node));
      if (!(at.gap <= reach)) continue;
      const double along = contact.penalty[k] + f * contact.damping[k], depth = std::max(0.0, -at.gap);
      const Eigen::Matrix3d outward = at.normal * at.normal.transpose();
      Eigen::Matrix3d own = along * outward;
      // Convex obstacles' curvature counts from below only: g H <= 0 where g < 0.
      const bool curved = !at.curvature.isZero(0);
      if (at.curvature.trace() < 0) own -= contact.penalty[k] * depth * (room ? 1 + deepening : 1) * at.curvature;
      if (contact.friction > 0)
        own += (f * contact.friction * contact.penalty[k] * depth * (room ? 1 + deepening : 1) / contact.slip) *
               (I - outward);
      if (room && curved) own += turning * along * I;
      matrices[placeOf(node)] += own;
    }
  for (Eigen::Matrix3d& matrix : matrices) matrix += directionRounding * matrix.trace() * I;
}

double DiscreteForces::largestSpeed(NodeVectorsView v) const {
  double most = 0;
  for (const PenaltyContact& contact : contacts_)
    for (const std::int32_t node : contact.nodes)
      most = std::max(most, (v.col(node) - shared_->obstacles[contact.obstacle].velocity).squaredNorm());
  return std::sqrt(most);
}

DiscreteForces::ContactState DiscreteForces::contactState(NodeVectorsView x) const {
  ContactState state;
  for (const PenaltyContact& contact : contacts_)
    for (const std::int32_t node : contact.nodes) {
      const double gap = surface(contact.obstacle, x.col(node)).gap;
      if (!(gap < 0)) continue;
      ++state.touching;
      if (-gap > state.deepest) {
        state.deepest = -gap;
        state.deepestNode = node;
        state.deepestObstacle = contact.obstacle;
      }
    }
  return state;
}

}  // namespace ringwatch

#include <ringwatch/body/discrete_forces.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include <ringwatch/base/error.h>
#include <ringwatch/base/rounding.h>
#include <ringwatch/base/sort_unique.h>

namespace ringwatch {
namespace {

// Of majorants with room: the sine of the angle by which a direction may turn, and the share by which the depth that
// friction grows with may grow.
constexpr double turning = 0.02, deepening = 0.5;
/// And what the weight of a corner may grow by as the closest point moves in the triangle.
constexpr double sliding = 0.1;

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

/// What damping and friction of a contact resist with, N, at a depth, m.
template <class Contact>
Eigen::Vector3d resistance(const Contact& contact, double penalty, double damping, const Eigen::Vector3d& normal,
                           double depth, const Eigen::Vector3d& velocity) {
  const Slide slide = slideOf(velocity, normal);
  Eigen::Vector3d force = damping * slide.normal * normal;
  if (contact.friction > 0)
    force += contact.friction * penalty * depth / std::max(slide.along.norm(), contact.slip.at(depth)) * slide.along;
  return force;
}

/// Σ b_c u_c over the nodes of a touch that a part has.
Eigen::Vector3d between(const SurfaceSearch::Touch& touch, const std::array<std::int32_t, 4>& nodes,
                        NodeVectorsView u) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int c = 0; c < 4; ++c)
    if (nodes[c] >= 0) sum += touch.b[c] * u.col(nodes[c]);
  return sum;
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
  requireSlip(contact.friction, contact.slip);
  note(contact.nodes);
  friction_ = friction_ || contact.friction > 0;
  damped_ = damped_ || friction_ ||
            std::any_of(contact.damping.begin(), contact.damping.end(), [](double c) { return c > 0; });
  contacts_.push_back(std::move(contact));
}

void DiscreteForces::add(SurfaceContact contact) {
  const bool rubs = contact.friction > 0;
  const bool damps = std::any_of(contact.damping.begin(), contact.damping.end(), [](double c) { return c > 0; }) ||
                     std::ranges::any_of(contact.edges, [](const auto& edge) { return edge.damping > 0; });
  const SurfaceSearch& search = shared_->surfaces.emplace_back(std::move(contact), nodeCount_);
  note(search.nodes());
  friction_ = friction_ || rubs;
  damped_ = damped_ || rubs || damps;
}

void DiscreteForces::locate(NodeVectorsView x) const {
  for (SurfaceSearch& surface : shared_->surfaces) surface.locate(x, shared_->reach, threads_);
}

void DiscreteForces::requireLocated(NodeVectorsView x) const {
  for (std::size_t s = 0; s < surfaceNodes_.size(); ++s)
    for (const auto& [node, place] : surfaceNodes_[s])
      if (!shared_->surfaces[s].located() || shared_->surfaces[s].positionOf(place) != x.col(node))
        throw NumericalError(
            joinText("contact of surfaces: node ", node, " of a part is not where the whole was last"));
}

void DiscreteForces::place(std::size_t obstacle, const Eigen::Vector3d& displacement, const Eigen::Vector3d& velocity) {
  MovingObstacle& moved = shared_->obstacles.at(obstacle);
  moved.displacement = displacement;
  moved.velocity = velocity;
  looked_ = nullptr;
}

Obstacle::Surface DiscreteForces::surface(std::size_t obstacle, const Eigen::Vector3d& x) const {
  const MovingObstacle& own = shared_->obstacles[obstacle];
  return own.shape->at(x - own.displacement);
}

void DiscreteForces::remember(NodeVectorsView x) const {
  looked_ = nullptr;
  near_.resize(contacts_.size());
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    near_[c].clear();
    forEachNear(c, shared_->reach, x, [&](std::size_t k) { near_[c].push_back(static_cast<std::int32_t>(k)); });
  }
  looked_ = x.data();
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
  part.isPart_ = true;
  if (shared_->surfaces.empty()) return part;
  part.damped_ = damped_;
  part.friction_ = friction_;
  // By way of this part's own numbers, where it is one.
  if (isPart_) {
    part.numberOf_ = numberOf_;
    for (std::int32_t& number : part.numberOf_)
      if (number >= 0) number = numberOf[number];
  } else {
    part.numberOf_ = std::move(numberOf);
  }
  for (const SurfaceSearch& surface : shared_->surfaces) {
    auto& own = part.surfaceNodes_.emplace_back();
    std::vector<std::int32_t> noted;
    for (std::size_t i = 0; i < surface.nodes().size(); ++i)
      if (const std::int32_t number = part.numberOf_[surface.nodes()[i]]; number >= 0) {
        own.push_back({number, static_cast<std::int32_t>(i)});
        noted.push_back(number);
      }
    part.note(noted);
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

std::vector<std::array<std::int32_t, 2>> DiscreteForces::coupledNodes(NodeVectorsView x) const {
  std::vector<std::array<std::int32_t, 2>> pairs;
  for (const Spring& spring : springs_)
    if (spring.other >= 0) pairs.push_back({std::min(spring.node, spring.other), std::max(spring.node, spring.other)});
  forEachTouch(x, [&](const SurfaceContact&, const SurfaceSearch::Touch&, const auto& nodes) {
    for (int a = 0; a < 4; ++a)
      for (int c = 0; c < 4; ++c)
        if (nodes[a] >= 0 && nodes[a] < nodes[c]) pairs.push_back({nodes[a], nodes[c]});
  });
  sortUnique(pairs);
  return pairs;
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
  forEachPushed(x, [&](const PenaltyContact& contact, std::size_t k, std::int32_t node, const Obstacle::Surface& at) {
    f.col(node) += contact.penalty[k] * at.gap * at.normal;
  });
  forEachTouch(x, [&](const SurfaceContact&, const SurfaceSearch::Touch& touch, const auto& nodes) {
    const Eigen::Vector3d force = touch.penalty * touch.r;
    for (int c = 0; c < 4; ++c)
      if (nodes[c] >= 0) f.col(nodes[c]) += touch.b[c] * force;
  });
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
  forEachPushed(x, [&](const PenaltyContact& contact, std::size_t k, std::int32_t, const Obstacle::Surface& at) {
    sum += 0.5 * contact.penalty[k] * at.gap * at.gap;
  });
  forEachTouch(x, [&](const SurfaceContact&, const SurfaceSearch::Touch& touch, const auto&) {
    sum += 0.5 * touch.penalty * touch.depth * touch.depth;
  });
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
  forEachPushed(x, [&](const PenaltyContact& contact, std::size_t k, std::int32_t node, const Obstacle::Surface& at) {
    f.col(node) += resistance(contact, contact.penalty[k], contact.damping[k], at.normal, -at.gap,
                              v.col(node) - shared_->obstacles[contact.obstacle].velocity);
  });
  forEachTouch(x, [&](const SurfaceContact& contact, const SurfaceSearch::Touch& touch, const auto& nodes) {
    const Eigen::Vector3d force =
        resistance(contact, touch.penalty, touch.damping, touch.normal, touch.depth, between(touch, nodes, v));
    for (int c = 0; c < 4; ++c)
      if (nodes[c] >= 0) f.col(nodes[c]) += touch.b[c] * force;
  });
}

DiscreteForces::ObstaclePower DiscreteForces::obstaclePower(NodeVectorsView x, NodeVectorsView v) const {
  ObstaclePower power;
  const auto moves = [&](const PenaltyContact& contact) {
    return !shared_->obstacles[contact.obstacle].velocity.isZero(0);
  };
  if (std::none_of(contacts_.begin(), contacts_.end(), moves)) return power;
  forEachPushed(x, [&](const PenaltyContact& contact, std::size_t k, std::int32_t node, const Obstacle::Surface& at) {
    const Eigen::Vector3d& velocity = shared_->obstacles[contact.obstacle].velocity;
    power.elastic -= contact.penalty[k] * at.gap * at.normal.dot(velocity);
    power.damping -=
        resistance(contact, contact.penalty[k], contact.damping[k], at.normal, -at.gap, v.col(node) - velocity)
            .dot(velocity);
  });
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
  forEachPushed(x, [&](const PenaltyContact& contact, std::size_t k, std::int32_t node, const Obstacle::Surface& at) {
    const Eigen::Vector3d own = u.col(node);
    Ku.col(node) += (contact.penalty[k] + f * contact.damping[k]) * at.normal.dot(own) * at.normal +
                    contact.penalty[k] * at.gap * (at.curvature * own);
  });
  forEachTouch(x, [&](const SurfaceContact&, const SurfaceSearch::Touch& touch, const auto& nodes) {
    const double k = touch.penalty, fc = f * touch.damping;
    const Eigen::Vector3d moved = between(touch, nodes, u);
    const Eigen::Vector3d along = k * moved + fc * touch.normal.dot(moved) * touch.normal;
    Eigen::Vector2d given = Eigen::Vector2d::Zero();
    for (int i = 0; i < touch.free; ++i)
      for (int c = 0; c < 4; ++c)
        if (nodes[c] >= 0) given[i] += touch.column(c, i).dot(u.col(nodes[c]));
    given = k * (touch.inverse * given);
    for (int c = 0; c < 4; ++c) {
      if (nodes[c] < 0) continue;
      Ku.col(nodes[c]) += touch.b[c] * along;
      for (int i = 0; i < touch.free; ++i) Ku.col(nodes[c]) -= given[i] * touch.column(c, i);
    }
  });
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
  forEachPushed(x, [&](const PenaltyContact& contact, std::size_t k, std::int32_t node, const Obstacle::Surface& at) {
    add(contact.damping[k], v.col(node), at.normal);
  });
  forEachTouch(x, [&](const SurfaceContact&, const SurfaceSearch::Touch& touch, const auto& nodes) {
    add(touch.damping, between(touch, nodes, v), touch.normal);
  });
  return form;
}

void DiscreteForces::majorants(NodeVectorsView x, bool room, std::vector<Eigen::Matrix3d>& matrices) const {
  matrices.assign(nodes_.size(), Eigen::Matrix3d::Zero());
  std::vector<std::int32_t> places;
  majorants(x, room, matrices, places);
}

void DiscreteForces::majorants(NodeVectorsView x, bool room, std::vector<Eigen::Matrix3d>& matrices,
                               std::vector<std::int32_t>& places) const {
  if (matrices.size() != nodes_.size()) {
    matrices.assign(nodes_.size(), Eigen::Matrix3d::Zero());
    places.clear();
  }
  for (const std::int32_t place : places) matrices[place].setZero();
  places.clear();
  fillMajorants(x, room, {}, matrices, places);
}

void DiscreteForces::majorantsToCome(NodeVectorsView x, std::span<const double> further,
                                     std::vector<Eigen::Matrix3d>& matrices) const {
  matrices.assign(nodes_.size(), Eigen::Matrix3d::Zero());
  std::vector<std::int32_t> places;
  fillMajorants(x, true, further, matrices, places);
}

void DiscreteForces::fillMajorants(NodeVectorsView x, bool room, std::span<const double> further,
                                   std::vector<Eigen::Matrix3d>& matrices, std::vector<std::int32_t>& places) const {
  forMajorants(x, room, further, [&]<class Part>(std::int32_t node, const Part& part) {
    const std::int32_t place = placeOf(node);
    Eigen::Matrix3d& matrix = matrices[place];
    const bool first = matrix.trace() == 0;  // semidefinite: zero where the trace is
    if constexpr (std::is_same_v<Part, double>)
      matrix.diagonal().array() += part;
    else
      matrix += part;
    if (first && matrix.trace() != 0) places.push_back(place);
  });
  for (const std::int32_t place : places)
    matrices[place].diagonal().array() += directionRounding * matrices[place].trace();
}

template <class Add>
void DiscreteForces::forMajorants(NodeVectorsView x, bool room, std::span<const double> further, const Add& add) const {
  const double f = dampingFactor(), reach = shared_->reach;
  const Eigen::Matrix3d I = Eigen::Matrix3d::Identity();
  for (const Spring& spring : springs_) {
    if (spring.other < 0) {
      add(spring.node, toGround(spring, spring.stiffness + f * spring.damping));
      continue;
    }
    // [1 -1; -1 1] <= 2.
    Eigen::Matrix3d own = 2 * axial(spring, x, f, true);
    if (room && spring.length > 0) own += 2 * turning * (spring.stiffness + f * spring.damping) * I;
    add(spring.node, own);
    add(spring.other, own);
  }
  const double most = reach + (further.empty() ? 0 : *std::max_element(further.begin(), further.end()));
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    const PenaltyContact& contact = contacts_[c];
    forEachNear(c, most, x, [&](std::size_t k) {
      const std::int32_t node = contact.nodes[k];
      const Obstacle::Surface at = surface(contact.obstacle, x.col(node));
      if (!(at.gap <= reach + (further.empty() ? 0 : further[placeOf(node)]))) return;
      const double along = contact.penalty[k] + f * contact.damping[k], depth = std::max(0.0, -at.gap);
      const Eigen::Matrix3d outward = at.normal * at.normal.transpose();
      Eigen::Matrix3d own = along * outward;
      // Convex obstacles' curvature counts from below only: g H <= 0 where g < 0.
      const bool curved = !at.curvature.isZero(0);
      if (at.curvature.trace() < 0) own -= contact.penalty[k] * depth * (room ? 1 + deepening : 1) * at.curvature;
      if (contact.friction > 0)
        own += (f * contact.friction * contact.slip.dashpot(contact.penalty[k], depth * (room ? 1 + deepening : 1))) *
               (I - outward);
      if (room && curved) own += turning * along * I;
      add(node, own);
    });
  }
  forSurfaceMajorants(x, room, add);
}

// A node touches one triangle at a time: of a corner the largest weight counts that it can have in any of them. An edge
// can touch several.
template <class Add>
void DiscreteForces::forSurfaceMajorants(NodeVectorsView x, bool room, const Add& add) const {
  if (shared_->surfaces.empty()) return;
  if (isPart_)
    requireLocated(x);
  else
    locate(x);
  const double f = dampingFactor();
  for (const SurfaceSearch& surface : shared_->surfaces) {
    const SurfaceContact& contact = surface.contact();
    const std::vector<SurfaceSearch::Near>& near = surface.near();
    const auto addIsotropic = [&](std::int32_t node, double value) {
      if (node = numberOf(node); node >= 0) add(node, value);
    };
    const auto stiffness = [&](double penalty, double damping, double depth) {
      double k = penalty + f * damping;
      if (contact.friction > 0)
        k += f * contact.friction * contact.slip.dashpot(penalty, depth * (room ? 1 + deepening : 1));
      return k;
    };
    std::vector<std::pair<std::int32_t, double>> corners;
    for (std::size_t i = 0; i < near.size();) {
      const std::int32_t entry = near[i].entry;
      double depth = 0;
      corners.clear();
      for (; i < near.size() && near[i].entry == entry; ++i) {
        depth = std::max(depth, near[i].depth);
        for (int c = 0; c < 3; ++c) {
          const std::int32_t corner = contact.triangles[near[i].triangle][c];
          const double weight = std::min(1.0, near[i].weight[c] + (room ? sliding : 0));
          const auto known =
              std::find_if(corners.begin(), corners.end(), [&](const auto& one) { return one.first == corner; });
          if (known == corners.end())
            corners.emplace_back(corner, weight);
          else
            known->second = std::max(known->second, weight);
        }
      }
      const double k = stiffness(contact.penalty[entry], contact.damping[entry], depth);
      addIsotropic(contact.nodes[entry], (1 + contact.split[entry]) * k);
      for (const auto& [corner, weight] : corners) addIsotropic(corner, (1 + 1 / contact.split[entry]) * weight * k);
    }
    for (const SurfaceSearch::NearEdges& one : surface.nearEdges()) {
      const double k = stiffness(one.penalty, one.damping, one.depth);
      for (int c = 0; c < 4; ++c)
        addIsotropic(
            contact.edges[one.edges[c / 2]].nodes[c % 2],
            (1 + (c < 2 ? one.split : 1 / one.split)) * std::min(1.0, one.weight[c] + (room ? sliding : 0)) * k);
    }
  }
}

double DiscreteForces::largestSpeed(NodeVectorsView v) const {
  double most = 0;
  for (const PenaltyContact& contact : contacts_) {
    const Eigen::Vector3d& velocity = shared_->obstacles[contact.obstacle].velocity;
    // Several at a time: each maximum waits for the one before.
    constexpr std::size_t chains = 4;
    double mostOf[chains] = {};
    const std::vector<std::int32_t>& nodes = contact.nodes;
    const auto follow = [&](std::size_t chain, std::size_t k) {
      mostOf[chain] = std::max(mostOf[chain], (v.col(nodes[k]) - velocity).squaredNorm());
    };
    std::size_t k = 0;
    for (; k + chains <= nodes.size(); k += chains)
      for (std::size_t chain = 0; chain < chains; ++chain) follow(chain, k + chain);
    for (; k < nodes.size(); ++k) follow(0, k);
    most = std::max(most, *std::max_element(mostOf, mostOf + chains));
  }
  double relative = 0;
  for (const SurfaceSearch& surface : shared_->surfaces) {
    const std::vector<std::int32_t>& nodes = surface.nodes();
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const std::int32_t node : nodes) mean += v.col(node) / static_cast<double>(nodes.size());
    for (const std::int32_t node : nodes) relative = std::max(relative, (v.col(node) - mean).squaredNorm());
  }
  return std::max(std::sqrt(most), 2 * std::sqrt(relative));
}

DiscreteForces::ContactState DiscreteForces::contactState(NodeVectorsView x) const {
  ContactState state;
  forEachPushed(x, [&](const PenaltyContact& contact, std::size_t, std::int32_t node, const Obstacle::Surface& at) {
    ++state.touching;
    if (!(-at.gap > state.deepest)) return;
    state.deepest = -at.gap;
    state.deepestNode = node;
    state.deepestObstacle = contact.obstacle;
  });
  forEachTouch(x, [&](const SurfaceContact&, const SurfaceSearch::Touch& touch, const auto& nodes) {
    ++state.touching;
    if (!(touch.depth > state.deepest)) return;
    state.deepest = touch.depth;
    state.deepestNode = nodes[0];
    state.deepestObstacle = ofSurface;
  });
  return state;
}

}  // namespace ringwatch

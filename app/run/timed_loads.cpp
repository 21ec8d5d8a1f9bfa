#include <ringwatch/app/run/timed_loads.h>

#include <algorithm>
#include <unordered_map>

#include <ringwatch/app/scene/scene_discrete.h>
#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/body/domain.h>

namespace ringwatch {

TimedLoads::TimedLoads(const Scene& scene, Body& body) : scene_(scene), body_(body) {
  std::vector<std::vector<std::int32_t>> nodesOf;
  for (const Scene::Force& force : scene.forces) {
    if (!force.table) continue;
    nodesOf.push_back(force.nodes.nodesOf(body.mesh()));
    nodes_.insert(nodes_.end(), nodesOf.back().begin(), nodesOf.back().end());
  }
  for (const Scene::Pressure& pressure : scene.pressures) {
    pressures_.push_back({pressedFaces(pressure, body.mesh()), &pressure});
    for (const PressedFace& face : pressures_.back().faces)
      nodes_.insert(nodes_.end(), face.nodes.begin(), face.nodes.end());
  }
  std::sort(nodes_.begin(), nodes_.end());
  nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
  for (const std::int32_t node : nodes_) constant_.emplace_back(body.externalForce().col(node));
  std::size_t next = 0;
  for (const Scene::Force& force : scene.forces) {
    if (!force.table) continue;
    const std::vector<std::int32_t>& loaded = nodesOf[next++];
    Force& made = forces_.emplace_back(
        Force{std::vector<Eigen::Vector3d>(nodes_.size(), Eigen::Vector3d::Zero()), &*force.table});
    const std::vector<Eigen::Vector3d> values = nodalForces(force, loaded, body);
    for (std::size_t i = 0; i < loaded.size(); ++i)
      made.values[std::lower_bound(nodes_.begin(), nodes_.end(), loaded[i]) - nodes_.begin()] += values[i];
  }
  if (!pressures_.empty()) {
    placeOf_.resize(body.nodeCount(), -1);
    for (std::size_t i = 0; i < nodes_.size(); ++i) placeOf_[nodes_[i]] = static_cast<std::int32_t>(i);
  }
  for (const Scene::Move& move : scene.moves)
    if (move.changes()) motions_.push_back({move.nodes.nodesOf(body.mesh()), &move, Scene::guides(move)});
}

TimedLoads::TimedLoads(const TimedLoads& whole, Body& part, std::span<const std::int32_t> globalNodes)
    : scene_(whole.scene_), body_(part) {
  std::unordered_map<std::int32_t, std::int32_t> localOf;
  for (std::size_t i = 0; i < globalNodes.size(); ++i) localOf.emplace(globalNodes[i], static_cast<std::int32_t>(i));
  for (const Force& force : whole.forces_) forces_.push_back({{}, force.table});
  for (std::size_t i = 0; i < whole.nodes_.size(); ++i) {
    const auto found = localOf.find(whole.nodes_[i]);
    if (found == localOf.end()) continue;
    nodes_.push_back(found->second);
    constant_.push_back(whole.constant_[i]);
    for (std::size_t f = 0; f < forces_.size(); ++f) forces_[f].values.push_back(whole.forces_[f].values[i]);
  }
  for (const Motion& motion : whole.motions_) {
    Motion& own = motions_.emplace_back(Motion{{}, motion.move, motion.guided});
    for (const std::int32_t node : motion.nodes)
      if (const auto found = localOf.find(node); found != localOf.end()) own.nodes.push_back(found->second);
  }
}

double TimedLoads::energyScale(double h) const {
  const Eigen::Index owned = body_.domain().owned(body_.nodeCount());
  ExactSum sum;
  const auto add = [&](std::int32_t node, double energy) {
    if (node < owned) sum.add(energy);
  };
  std::vector<double> pressing(pressures_.empty() ? 0 : nodes_.size(), 0.0);  // N, at rest
  for (const Pressure& pressure : pressures_) {
    const double most = pressure.load->pressure * (pressure.load->table ? pressure.load->table->largest() : 1);
    for (const PressedFace& face : pressure.faces)
      addPressure(face, most, body_.mesh().X,
                  [&](std::int32_t node, const Eigen::Vector3d& force) { pressing[placeOf_[node]] += force.norm(); });
  }
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    double force = constant_[i].norm();
    for (const Force& timed : forces_) force += timed.table->largest() * timed.values[i].norm();
    if (!pressing.empty()) force += pressing[i];
    add(nodes_[i], 0.5 * h * h * force * force / body_.lumpedMass()[nodes_[i]]);
  }
  for (const Motion& motion : motions_) {
    // A rigid body turns about its own point, a motion of nodes about the one that it names.
    Eigen::Vector3d shift = Eigen::Vector3d::Zero();
    if (motion.guided)
      shift = motion.move->point - body_.constraints().rigidBody(motion.move->guide->body).point(body_.mesh().X);
    for (const std::int32_t node : motion.nodes) {
      const double speed = motion.move->largestSpeed(body_.mesh().X.col(node) + shift);
      add(node, 0.5 * body_.lumpedMass()[node] * speed * speed);
    }
  }
  if (const DiscreteForces* discrete = body_.discreteForces(); discrete && scene_.movesObstacles())
    for (const PenaltyContact& contact : discrete->contacts()) {
      const Scene::MovingObstacle& obstacle = scene_.obstacles[contact.obstacle];
      const double speed = (obstacle.table ? obstacle.table->largest() : 1) * obstacle.velocity.norm();
      for (const std::int32_t node : contact.nodes) add(node, 0.5 * body_.lumpedMass()[node] * speed * speed);
    }
  body_.domain().sum({&sum, 1});
  return sum.value();
}

void TimedLoads::begin(const NodeVectors& x) {
  first_.clear();
  for (const std::int32_t node : nodes_) first_.emplace_back(x.col(node));
  last_ = first_;
}

void TimedLoads::setForces(double time, const NodeVectors& x, EnergyBalance& balance) {
  if (scene_.movesObstacles()) placeObstacles(scene_, time, *body_.discreteForces());
  // Of the pressures, which follow the faces.
  std::vector<Eigen::Vector3d> pressing(pressures_.empty() ? 0 : nodes_.size(), Eigen::Vector3d::Zero());
  for (const Pressure& pressure : pressures_) {
    const double now = pressure.load->pressure * (pressure.load->table ? pressure.load->table->at(time) : 1);
    for (const PressedFace& face : pressure.faces)
      addPressure(face, now, x,
                  [&](std::int32_t node, const Eigen::Vector3d& force) { pressing[placeOf_[node]] += force; });
  }
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    Eigen::Vector3d force = constant_[i];
    if (!pressing.empty()) force += pressing[i];
    for (const Force& timed : forces_) force += timed.table->at(time) * timed.values[i];
    const std::int32_t node = nodes_[i];
    auto now = body_.externalForce().col(node);
    const Eigen::Vector3d place = x.col(node);
    const Eigen::Vector3d change = force - now, middle = 0.5 * (last_[i] + place) - first_[i];
    for (int c = 0; c < 3; ++c)
      if (!body_.constraints().isConstrained(node, c)) balance.addWork(node, -(change[c] * middle[c]));
    now = force;
    last_[i] = place;
  }
}

void TimedLoads::setVelocities(State& state, double h, EnergyBalance& balance) {
  for (const Motion& motion : motions_) {
    if (motion.guided) {
      guide(motion, state, h, balance);
      continue;
    }
    for (const std::int32_t node : motion.nodes) {
      const Eigen::Vector3d velocity = motion.move->meanVelocity(body_.mesh().X.col(node), state.time, h);
      for (int c = 0; c < 3; ++c) {
        if (!motion.move->components[c]) continue;
        double& v = state.v(c, node);
        balance.addWork(node, 0.5 * body_.lumpedMass()[node] * (velocity[c] - v) * (velocity[c] + v));
        v = velocity[c];
        body_.constraints().move(node, c, velocity[c]);
      }
    }
  }
}

void TimedLoads::guide(const Motion& motion, State& state, double h, EnergyBalance& balance) {
  const Scene::Move& move = *motion.move;
  const RigidBody& rigid = body_.constraints().rigidBody(move.guide->body);
  body_.constraints().guide(move.guide->body, move.meanVelocity(move.point, state.time, h),
                            (move.turned(state.time + h) - move.turned(state.time)) / h);
  std::vector<Eigen::Vector3d> before;
  for (const std::int32_t node : rigid.nodes()) before.emplace_back(state.v.col(node));
  rigid.impose(state.x, state.v);
  for (std::size_t k = 0; k < before.size(); ++k) {
    const std::int32_t node = rigid.nodes()[k];
    const Eigen::Vector3d now = state.v.col(node);
    balance.addWork(node, 0.5 * body_.lumpedMass()[node] * (now - before[k]).dot(now + before[k]));
  }
}

}  // namespace ringwatch

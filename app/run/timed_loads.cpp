#include <ringwatch/app/run/timed_loads.h>

#include <algorithm>

namespace ringwatch {

TimedLoads::TimedLoads(const Scene& scene, Body& body) : body_(body) {
  std::vector<std::vector<std::int32_t>> nodesOf;
  for (const Scene::Force& force : scene.forces) {
    if (!force.table) continue;
    nodesOf.push_back(force.nodes.nodesOf(body.mesh()));
    nodes_.insert(nodes_.end(), nodesOf.back().begin(), nodesOf.back().end());
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
  for (const Scene::Move& move : scene.moves)
    if (move.table) motions_.push_back({move.nodes.nodesOf(body.mesh()), &move});
}

double TimedLoads::energyScale(double h) const {
  double energy = 0;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    double force = constant_[i].norm();
    for (const Force& timed : forces_) force += timed.table->largest() * timed.values[i].norm();
    energy += 0.5 * h * h * force * force / body_.lumpedMass()[nodes_[i]];
  }
  for (const Motion& motion : motions_) {
    const double speed = motion.move->table->largest() * motion.move->velocity.norm();
    for (const std::int32_t node : motion.nodes) energy += 0.5 * body_.lumpedMass()[node] * speed * speed;
  }
  return energy;
}

void TimedLoads::begin(const NodeVectors& x) {
  first_.clear();
  for (const std::int32_t node : nodes_) first_.emplace_back(x.col(node));
  last_ = first_;
}

double TimedLoads::setForces(double time, const NodeVectors& x) {
  double gain = 0;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    Eigen::Vector3d force = constant_[i];
    for (const Force& timed : forces_) force += timed.table->at(time) * timed.values[i];
    const std::int32_t node = nodes_[i];
    auto now = body_.externalForce().col(node);
    const Eigen::Vector3d place = x.col(node);
    const Eigen::Vector3d change = force - now, middle = 0.5 * (last_[i] + place) - first_[i];
    for (int c = 0; c < 3; ++c)
      if (!body_.constraints().isConstrained(node, c)) gain -= change[c] * middle[c];
    now = force;
    last_[i] = place;
  }
  return gain;
}

double TimedLoads::setVelocities(State& state, double h) {
  double given = 0;
  for (const Motion& motion : motions_) {
    const Eigen::Vector3d velocity = motion.move->table->mean(state.time, h) * motion.move->velocity;
    for (const std::int32_t node : motion.nodes)
      for (int c = 0; c < 3; ++c) {
        if (!motion.move->components[c]) continue;
        double& v = state.v(c, node);
        given += 0.5 * body_.lumpedMass()[node] * (velocity[c] - v) * (velocity[c] + v);
        v = velocity[c];
        body_.constraints().move(node, c, velocity[c]);
      }
  }
  return given;
}

}  // namespace ringwatch

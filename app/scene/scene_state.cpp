#include <ringwatch/app/scene/scene_state.h>

#include <Eigen/Geometry>

namespace ringwatch {

namespace {

/// The integral of the factor from time zero, s.
double integral(const std::optional<TimeTable>& table, double time) {
  if (!(time > 0)) return 0;
  return table ? table->mean(0, time) * time : time;
}

}  // namespace

Eigen::Vector3d Scene::Move::displacement(const Eigen::Vector3d& X, double time) const {
  if (way) return time > 0 ? Eigen::Vector3d(table->at(time) * *way) : Eigen::Vector3d::Zero();
  const double factor = integral(table, time);
  Eigen::Vector3d u = factor * velocity;
  if (!rotates()) return u;
  const double speed = angularVelocity.norm();
  const Eigen::AngleAxisd turn(factor * speed, angularVelocity / speed);
  return u + turn * (X - point) - (X - point);
}

Eigen::Vector3d Scene::Move::turned(double time) const { return integral(table, time) * angularVelocity; }

Eigen::Vector3d Scene::Move::meanVelocity(const Eigen::Vector3d& X, double time, double h) const {
  // Exact without a rotation, where positions would cancel.
  if (!way && !rotates()) return (table ? table->mean(time, h) : 1) * velocity;
  return (displacement(X, time + h) - displacement(X, time)) / h;
}

double Scene::Move::largestSpeed(const Eigen::Vector3d& X) const {
  if (way) return table->steepest() * way->norm();
  return (table ? table->largest() : 1) * (velocity.norm() + angularVelocity.cross(X - point).norm());
}

Eigen::Vector3d Scene::Move::velocityAtStart(const Eigen::Vector3d& X) const {
  if (way) return table->slope(0) * *way;
  return (table ? table->at(0) : 1) * (velocity + angularVelocity.cross(X - point));
}

State sceneInitialState(const Scene& scene, const BodySystem& system) {
  State state = system.initialState();
  for (const Scene::Initial& initial : scene.initials)
    for (const std::int32_t node : initial.nodes.nodesOf(system.body().mesh())) {
      const Eigen::Vector3d arm = state.x.col(node) - initial.point;
      state.v.col(node) += initial.velocity + initial.angularVelocity.cross(arm);
    }
  system.body().constraints().imposeVelocity(state.v);
  system.body().constraints().imposeTied(state.x, state.v);
  return state;
}

}  // namespace ringwatch

#include <ringwatch/handlers/angular_momentum.h>

#include <algorithm>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace ringwatch {

bool isFreeOfTorque(const Body& body, std::span<const ElementRef> elements, std::span<const std::int32_t> nodes) {
  return std::all_of(nodes.begin(), nodes.end(),
                     [&](std::int32_t node) { return body.constraints().freeComponents(node) == 3; }) &&
         std::all_of(elements.begin(), elements.end(),
                     [&](ElementRef e) { return body.blocks()[e.block]->material().info().objective; });
}

void keepAngularMomentum(const Body& body, std::span<const std::int32_t> nodes, NodeVectorsView x, const NodeVectors& v,
                         double h, const NodeVectors& before, NodeVectors& a) {
  const Eigen::VectorXd& mass = body.lumpedMass();
  const auto endOf = [&](std::int32_t node) -> Eigen::Vector3d {
    return x.col(node) + h * (v.col(node) + h * a.col(node));
  };
  double whole = 0;
  Eigen::Vector3d start = Eigen::Vector3d::Zero(), end = start;
  for (const std::int32_t node : nodes) {
    whole += mass[node];
    start += mass[node] * x.col(node);
    end += mass[node] * endOf(node);
  }
  start /= whole;
  end /= whole;
  // Σ m r × (w × s) = Σ m ((r·s) 1 - s rᵀ) w, r and s from the centres of mass.
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const std::int32_t node = nodes[i];
    const Eigen::Vector3d r = x.col(node) - start, s = endOf(node) - end;
    torque += mass[node] * r.cross(Eigen::Vector3d(a.col(node) - before.col(i)));
    inertia += mass[node] * (r.dot(s) * Eigen::Matrix3d::Identity() - s * r.transpose());
  }
  const Eigen::Vector3d turn = inertia.inverse() * torque;
  if (!turn.allFinite()) return;  // positions that are not finite, of which the step fails
  for (const std::int32_t node : nodes) a.col(node) -= turn.cross(Eigen::Vector3d(endOf(node) - end));
}

void keepMomenta(const Body& body, const Eigen::VectorXd& massBefore, NodeVectorsView x, NodeVectors& v) {
  const Eigen::VectorXd& mass = body.lumpedMass();
  const Eigen::Vector3d centre = x * mass / mass.sum(), drift = v * (mass - massBefore) / mass.sum();
  Eigen::Vector3d angular = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  for (Eigen::Index i = 0; i < v.cols(); ++i) {
    const Eigen::Vector3d arm = x.col(i) - centre;
    angular += (mass[i] - massBefore[i]) * arm.cross(Eigen::Vector3d(v.col(i)));
    inertia += mass[i] * (arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose());
  }
  const Eigen::Vector3d spin = inertia.inverse() * angular;
  for (Eigen::Index i = 0; i < v.cols(); ++i) {
    const Eigen::Vector3d arm = x.col(i) - centre;
    v.col(i) -= drift + spin.cross(arm);
  }
}

}  // namespace ringwatch

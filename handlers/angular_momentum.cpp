#include <ringwatch/handlers/angular_momentum.h>

#include <algorithm>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <ringwatch/base/parallel.h>
#include <ringwatch/integrators/integrator.h>

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
  const auto count = static_cast<std::int64_t>(nodes.size());
  const auto sum = [&](auto zero, const auto& term) {
    return parallelSum(count, body.threads(), zero, [&](std::int64_t begin, std::int64_t end) {
      auto part = zero;
      for (std::int64_t i = begin; i < end; ++i) part += term(nodes[static_cast<std::size_t>(i)], i);
      return part;
    });
  };
  typedef Eigen::Matrix<double, 7, 1> Vector7;
  const Vector7 centres = sum(Vector7(Vector7::Zero()), [&](std::int32_t node, std::int64_t) -> Vector7 {
    Vector7 own;
    own << mass[node], mass[node] * x.col(node), mass[node] * endOf(node);
    return own;
  });
  const Eigen::Vector3d start = centres.segment<3>(1) / centres[0], end = centres.tail<3>() / centres[0];
  // Σ m r × (w × s) = Σ m ((r·s) 1 - s rᵀ) w, r and s from the centres of mass.
  typedef Eigen::Matrix<double, 3, 4> Matrix34;
  const Matrix34 moments = sum(Matrix34(Matrix34::Zero()), [&](std::int32_t node, std::int64_t i) -> Matrix34 {
    const Eigen::Vector3d r = x.col(node) - start, s = endOf(node) - end;
    Matrix34 own;
    own << mass[node] * r.cross(Eigen::Vector3d(a.col(node) - before.col(i))),
        mass[node] * (r.dot(s) * Eigen::Matrix3d::Identity() - s * r.transpose());
    return own;
  });
  const Eigen::Vector3d turn = moments.rightCols<3>().inverse() * moments.col(0);
  if (!turn.allFinite()) return;  // positions that are not finite, of which the step fails
  const auto turnNode = [&](std::int64_t i) {
    const std::int32_t node = nodes[static_cast<std::size_t>(i)];
    a.col(node) -= turn.cross(Eigen::Vector3d(endOf(node) - end));
  };
  parallelFor(0, count, body.threads(), turnNode, nodesOfAThread);
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

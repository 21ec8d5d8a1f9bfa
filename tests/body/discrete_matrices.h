#pragma once
#include <vector>

#include <Eigen/Eigenvalues>

#include <ringwatch/body/discrete_forces.h>

/// Discrete forces as dense matrices, 3N×3N, in N/m.
namespace ringwatch::test {

/// K + f C.
inline Eigen::MatrixXd denseOf(const DiscreteForces& forces, const NodeVectors& x) {
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(x.size(), x.size());
  forces.forEachBlock(
      x, [&](std::int32_t i, std::int32_t j, const Eigen::Matrix3d& block) { K.block<3, 3>(3 * i, 3 * j) += block; });
  return K;
}

/// The block diagonal of the nodes' majorants; room: with what DiscreteForces::majorants() adds for later states.
inline Eigen::MatrixXd majorantOf(const DiscreteForces& forces, const NodeVectors& x, bool room = false) {
  std::vector<Eigen::Matrix3d> majorants;
  forces.majorants(x, room, majorants);
  Eigen::MatrixXd bound = Eigen::MatrixXd::Zero(x.size(), x.size());
  for (std::size_t i = 0; i < majorants.size(); ++i)
    bound.block<3, 3>(3 * forces.nodes()[i], 3 * forces.nodes()[i]) = majorants[i];
  return bound;
}

inline double leastEigenvalue(const Eigen::MatrixXd& matrix) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues()[0];
}

/// A majorant is at least the tangent, but for its rounding.
inline void expectAbove(const Eigen::MatrixXd& bound, const Eigen::MatrixXd& tangent, std::int64_t which) {
  ASSERT_GE(leastEigenvalue(bound - tangent), -1e-12 * bound.norm()) << which;
}

}  // namespace ringwatch::test

#pragma once
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include <ringwatch/body/discrete_forces.h>
#include <tests/monitor/monitor_cases.h>

namespace ringwatch::test {

/// What the stiffest spring has to be to count as much as the elements: of the order of a cell's own stiffness, and ten
/// times that, where it governs.
inline constexpr double cellStiffness = young * cellSize;

/// Springs of all kinds between nodes and to the ground, and all nodes against a floor, a wall that leans, and a ball.
/// stiffness: N/m, of the stiffest; the others are up to a thousand times softer.
inline void addForces(Body& body, double stiffness, std::uint64_t seed) {
  Random random(seed);
  const auto constant = [&] { return stiffness * std::pow(10.0, -random.uniform(0, 3)); };
  DiscreteForces forces(body.nodeCount());
  std::vector<Spring> springs;
  for (int i = 0; i < 6; ++i) {
    Spring spring;
    spring.node = static_cast<std::int32_t>(random.index(body.nodeCount()));
    spring.stiffness = constant();
    spring.damping = 1e-4 * constant();
    spring.anchor = body.mesh().X.col(spring.node);
    if (i == 1) spring.direction = random.vector(1).normalized();
    if (i >= 2) spring.other = (spring.node + 1 + random.index(body.nodeCount() - 1)) % body.nodeCount();
    if (i >= 3) spring.length = random.uniform(0.5, 1.5) * cellSize;
    springs.push_back(spring);
  }
  forces.add(springs);
  const Eigen::Vector3d low = body.mesh().X.rowwise().minCoeff(), high = body.mesh().X.rowwise().maxCoeff();
  const double depth = 0.1 * cellSize;
  const auto touch = [&](std::unique_ptr<Obstacle> obstacle) {
    PenaltyContact contact;
    contact.obstacle = forces.add(std::move(obstacle));
    contact.nodes.resize(body.nodeCount());
    std::iota(contact.nodes.begin(), contact.nodes.end(), 0);
    const double penalty = constant(), damping = 1e-4 * constant();
    contact.penalty.assign(body.nodeCount(), penalty);
    contact.damping.assign(body.nodeCount(), damping);
    forces.add(std::move(contact));
  };
  touch(planeObstacle(low + Eigen::Vector3d(0, 0, depth), {0, 0, 1}));
  touch(planeObstacle(high - Eigen::Vector3d(depth, 0, 0), {-1, -0.3, 0.2}));
  touch(sphereObstacle(0.5 * (low + high) + Eigen::Vector3d(0, 2, 0) * cellSize, cellSize, false));
  if (random.index(2) == 0) forces.setDampingFactor(random.uniform(0, 3e4));
  body.setDiscreteForces(std::move(forces));
}

}  // namespace ringwatch::test

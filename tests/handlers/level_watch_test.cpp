// Finer levels of local-time-stepping along a run: who is called proven is, by dense eigenvalues, and stiffening is
// seen.
#include <gtest/gtest.h>

#include <ringwatch/handlers/local_time_stepping/level_watch.h>
#include <ringwatch/handlers/local_time_stepping/local_time_stepping.h>
#include <ringwatch/integrators/integrator.h>
#include <tests/handlers/handler_cases.h>

namespace ringwatch {
namespace {

/// The highest eigenvalue of a level's elements on the mass that is theirs, over that which its filter takes.
double loadOf(const Body& body, const LocalTimeStepping& handler, std::size_t k, double margin, const NodeVectors& x) {
  const auto& levels = handler.levels();
  Eigen::VectorXd mass = body.lumpedMass();
  std::vector<bool> finer = touchedNodes(body, handler.implicitElements());
  for (std::size_t deeper = k + 1; deeper < levels.size(); ++deeper)
    for (const std::int32_t node : nodesOf(body, levels[deeper].elements)) finer[node] = true;
  for (std::int32_t i = 0; i < body.nodeCount(); ++i)
    if (finer[i]) mass[i] *= levels[k].massShare;
  const double highest = test::denseHighest(body, test::stiffnessOf(body, x, levels[k].elements, true), mass);
  return highest * (1 - margin) * (1 - margin) / levels[k].lambda;
}

TEST(LevelWatch, CallsALevelProvenOnlyWhereItIs) {
  Body body = test::sliverBody("stvk", 0.98);
  constexpr double margin = 0.1;
  LocalTimeStepping handler(body, makeIntegrator("verlet"), {.margin = margin});
  const NodeVectors& X = body.mesh().X;
  handler.prepare(X, 4 * test::criticalStepOf(body));
  ASSERT_GT(handler.levels().size(), 1u);
  int proven = 0;
  for (const double stretch : {1.0, 1.01, 1.03, 1.1, 1.3, 1.6}) {
    const NodeVectors x = Eigen::Vector3d(stretch, 1, 1).asDiagonal() * X;
    double load = 0;
    for (std::size_t k = 1; k < handler.levels().size(); ++k)
      load = std::max(load, loadOf(body, handler, k, margin, x));
    const std::string part = handler.uncertifiedPart(x);
    EXPECT_TRUE(load <= 1 || part.find("no longer proven stable") != std::string::npos) << stretch << ", " << load;
    proven += part.empty();
  }
  EXPECT_GE(proven, 2);
  EXPECT_LE(proven, 5);
  // A new choice proves all levels again.
  const NodeVectors x = Eigen::Vector3d(1.6, 1, 1).asDiagonal() * X;
  EXPECT_NE(handler.uncertifiedPart(x), "");
  handler.prepare(x, 4 * test::criticalStepOf(body));
  EXPECT_EQ(handler.uncertifiedPart(x), "");
}

TEST(LevelWatch, HasACertificateThatVerifies) {
  const Body body = test::sliverBody("stvk", 0.98);
  const NodeVectors& X = body.mesh().X;
  const double lambda = 2 * test::denseHighest(body, X);
  LevelWatch watch(body, complement(noElements(body.mesh())), body.lumpedMass(), lambda, 2);
  int proven = 0;
  for (const double stretch : {1.0, 1.001, 1.01, 1.05}) {
    const NodeVectors x = Eigen::Vector3d(stretch, 1, 1).asDiagonal() * X;
    if (!watch.certifies(x)) continue;
    ++proven;
    EXPECT_LE(watch.verify(x), 1e-9) << stretch;
  }
  EXPECT_GE(proven, 3);
}

}  // namespace
}  // namespace ringwatch

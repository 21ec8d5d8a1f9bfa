// The study that the command line runs, quick.
#include <gtest/gtest.h>

#include <ringwatch/handlers/handler.h>
#include <ringwatch/verify/fierz2013.h>
#include <ringwatch/verify/handlers.h>

namespace ringwatch {
namespace {

TEST(HandlersStudy, FindsAllHandlersAsGoodAsTheyClaim) {
  const StudyReport report = verifyHandlers(StudyEffort::quick);
  EXPECT_EQ(report.study, "handlers");
  ASSERT_EQ(report.tables.size(), 5u);
  EXPECT_GT(report.checks.size(), 20u);
  for (const StudyCheck& check : report.checks) EXPECT_TRUE(check.passed) << check.name << ": " << check.measured;
}

TEST(Fierz2013Study, EveryHandlerFollowsTheReference) {
  const StudyReport report = verifyFierz2013(StudyEffort::quick, coreIntegrators());
  ASSERT_EQ(report.tables.size(), 2u);
  EXPECT_GE(report.checks.size(), 4 * allHandlers().size());
  EXPECT_EQ(report.surfaces.size(), 4u);
  for (const StudyCheck& check : report.checks) EXPECT_TRUE(check.passed) << check.name << ": " << check.measured;
}

TEST(Fierz2013Study, LedFacesArriveWhereTheyBelong) {
  for (const Deformation& d : allDeformations(0.3)) {
    if (d.byForce) continue;
    Body body = d.body();
    NodeVectors x = body.mesh().X;
    constexpr double dt = 4e-4;
    for (double t = 0; t < d.end() - dt / 2; t += dt) {
      d.lead(body, t, dt);
      x += dt * body.constraints().velocity();
    }
    const std::vector<std::int32_t>& driven = body.mesh().nodeSets.at(d.mesh == "bar" ? "x-max" : "z-max");
    // Stretched by 40 %, compressed by 20 %, turned by 45° and the long bar by 90°: the face keeps its shape.
    const auto size = [&](const NodeVectors& y) {
      Eigen::Matrix3Xd face(3, static_cast<Eigen::Index>(driven.size()));
      for (std::size_t i = 0; i < driven.size(); ++i) face.col(static_cast<Eigen::Index>(i)) = y.col(driven[i]);
      const Eigen::Vector3d centre = face.rowwise().mean();
      return std::pair((face.colwise() - centre).norm(), centre);
    };
    const auto [before, from] = size(body.mesh().X);
    const auto [after, to] = size(x);
    EXPECT_NEAR(after, before, 1e-9) << d.mesh << " " << d.mode;
    const double length = d.mesh == "bar" ? 0.1 : 0.05;
    const double moved = (to - from).norm();
    if (d.mode == "bend") {
      EXPECT_GT(moved, 0.3 * length);
      continue;
    }
    if (d.mode == "twist") {
      const int along = d.mesh == "bar" ? 0 : 2;
      Eigen::Vector3d axis = Eigen::Vector3d::Constant(0.025);
      for (const std::int32_t n : driven) {
        axis[along] = body.mesh().X(along, n);
        EXPECT_NEAR((x.col(n) - axis).norm(), (body.mesh().X.col(n) - axis).norm(), 1e-9);
      }
      continue;
    }
    EXPECT_NEAR(moved, (d.mode == "stretch" ? 0.4 : 0.2) * length, 1e-9) << d.mesh << " " << d.mode;
  }
}

}  // namespace
}  // namespace ringwatch

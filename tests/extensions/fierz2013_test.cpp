// The replica of Fierz's comparison of handlers (2013), quick, and how its faces move.
#include <gtest/gtest.h>

#include <ringwatch/extensions/fierz2013/fierz2013.h>
#include <ringwatch/handlers/handler.h>

#include <tests/verify/report_tools.h>

namespace ringwatch {
namespace {

TEST(Fierz2013Study, EveryHandlerFollowsTheReference) {
  const StudyReport report = verifyFierz2013(StudyEffort::quick, coreIntegrators());
  test::expectHolds(report);
  EXPECT_EQ(test::tableNames(report), (std::set<std::string>{"deformations", "fierz2013"}));
  for (const HandlerEntry& entry : allHandlers())
    EXPECT_EQ(test::textsOf(test::tableOf(report, "deformations"), 4).count(std::string(entry.info->name)), 1u);
  std::set<std::string> pictures;
  for (const StudySurfaces& surfaces : report.surfaces) pictures.insert(surfaces.name);
  EXPECT_EQ(pictures, (std::set<std::string>{"deformation_cube_stretch", "deformation_cube_compress",
                                             "deformation_cube_bend", "deformation_cube_twist"}));
}

TEST(Fierz2013Study, MovingFacesArriveWhereTheyBelong) {
  std::set<std::pair<std::string_view, std::string_view>> seen;
  for (const Deformation& d : allDeformations(0.3)) {
    if (d.byForce) continue;
    seen.insert({d.mesh, d.mode});
    Body body = d.body();
    NodeVectors x = body.mesh().X;
    constexpr double dt = 4e-4;
    for (double t = 0; t < d.end() - dt / 2; t += dt) {
      d.prescribeMotion(body, t, dt);
      x += dt * body.constraints().velocity();
    }
    const std::vector<std::int32_t>& moving = body.mesh().nodeSets.at(d.mesh == "bar" ? "x-max" : "z-max");
    // Stretched by 40 %, compressed by 20 %, turned by 45° and the long bar by 90°: the face keeps its shape.
    const auto size = [&](const NodeVectors& y) {
      Eigen::Matrix3Xd face(3, moving.size());
      for (std::size_t i = 0; i < moving.size(); ++i) face.col(i) = y.col(moving[i]);
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
      for (const std::int32_t n : moving) {
        axis[along] = body.mesh().X(along, n);
        EXPECT_NEAR((x.col(n) - axis).norm(), (body.mesh().X.col(n) - axis).norm(), 1e-9);
      }
      continue;
    }
    EXPECT_NEAR(moved, (d.mode == "stretch" ? 0.4 : 0.2) * length, 1e-9) << d.mesh << " " << d.mode;
  }
  EXPECT_EQ(seen.size(), 8u);  // two meshes, stretched, compressed, bent and twisted
}

}  // namespace
}  // namespace ringwatch

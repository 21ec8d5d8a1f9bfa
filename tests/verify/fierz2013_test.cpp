// The replica of Fierz's comparison of handlers (2013), quick, and how its faces move.
#include <gtest/gtest.h>

#include <ringwatch/handlers/handler.h>
#include <ringwatch/verify/fierz2013/fierz2013.h>

#include "criteria.h"
#include "report_tools.h"

namespace ringwatch {
namespace {

TEST(Fierz2013Study, EveryHandlerFollowsTheReference) {
  using test::Basis;
  const StudyReport report = verifyFierz2013(StudyEffort::quick, coreIntegrators());
  // Mean errors of a step of 0.4 ms (modal-filter: 0.2 ms), % of the largest displacement.
  const std::string ofError = ": mean error (% of the largest displacement)";
  test::expectCriteria(report,
                       {{"cube, stretch by force, nu = 0.3, imex, as in Fierz 2013" + ofError, 2.5, Basis::measured},
                        {"cube, stretch by force, nu = 0.3, imex*" + ofError, 0.7, Basis::measured},
                        {"cube, stretch by force, nu = 0.3, local-time-stepping" + ofError, 0.7, Basis::measured},
                        {"cube, stretch by force, nu = 0.3, fe-pbd" + ofError, 2.9, Basis::measured},
                        {"cube, stretch by force, nu = 0.3, modal-filter" + ofError, 0.36, Basis::measured},
                        {"cube, compress by force, nu = 0.3, imex, as in Fierz 2013" + ofError, 3.2, Basis::measured},
                        {"cube, compress by force, nu = 0.3, imex*" + ofError, 0.78, Basis::measured},
                        {"cube, compress by force, nu = 0.3, local-time-stepping" + ofError, 0.78, Basis::measured},
                        {"cube, compress by force, nu = 0.3, fe-pbd" + ofError, 3.5, Basis::measured},
                        {"cube, compress by force, nu = 0.3, modal-filter" + ofError, 0.36, Basis::measured},
                        {"cube, bend by force, nu = 0.3, imex, as in Fierz 2013" + ofError, 0.78, Basis::measured},
                        {"cube, bend by force, nu = 0.3, imex*" + ofError, 0.18, Basis::measured},
                        {"cube, bend by force, nu = 0.3, local-time-stepping" + ofError, 0.18, Basis::measured},
                        {"cube, bend by force, nu = 0.3, fe-pbd" + ofError, 0.75, Basis::measured},
                        {"cube, bend by force, nu = 0.3, modal-filter" + ofError, 0.09, Basis::measured},
                        {"cube, twist by force, nu = 0.3, imex, as in Fierz 2013" + ofError, 1.15, Basis::measured},
                        {"cube, twist by force, nu = 0.3, imex*" + ofError, 0.27, Basis::measured},
                        {"cube, twist by force, nu = 0.3, local-time-stepping" + ofError, 0.27, Basis::measured},
                        {"cube, twist by force, nu = 0.3, fe-pbd" + ofError, 1.4, Basis::measured},
                        {"cube, twist by force, nu = 0.3, modal-filter" + ofError, 0.12, Basis::measured},
                        {"cube, *, nu = 0.3, mass-scaling: lost", 0, Basis::theory}});
  test::expectWellFormed(report);
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

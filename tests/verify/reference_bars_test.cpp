// Clamped bars against GetFEM 5.4.2 and CalculiX 2.20, to the digits that they printed: bending under an end load,
// natural frequencies, falling under gravity, critical steps. E = 30 kPa, nu = 0.3, rho = 1000 kg/m3, St.
// Venant–Kirchhoff, 0.2 × 0.04 × 0.04 m, x = 0 clamped.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/body/free_dofs.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/integrators/stormer_verlet.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <ringwatch/verify/static_solver.h>
#include <tests/support/body_cases.h>

namespace ringwatch {
namespace {

Body clampedBar(std::string_view element, int cells, bool clamped = true) {
  Body body(test::referenceBar(element, cells), makeMaterial("stvk", 30e3, 0.3, 1000));
  if (clamped)
    for (const std::int32_t node : body.mesh().nodeSets.at("x-min")) body.constraints().fix(node);
  return body;
}
std::int32_t tipOf(const Body& body) { return test::nodeNearest(body.mesh(), {0.2, 0.02, 0.02}); }

struct Cantilever {
  std::string_view element;
  int cells;
  double smallZ, largeX, largeZ;  // tip displacement under 1e-3 N and 0.3 N, m
};
class ReferenceCantileverTest : public ::testing::TestWithParam<Cantilever> {};
INSTANTIATE_TEST_SUITE_P(
    Bars, ReferenceCantileverTest,
    ::testing::Values(Cantilever{"hex8", 2, -3.678957725e-4, -2.545046848e-2, -8.910916125e-2},
                      Cantilever{"hex8", 4, -4.069694493e-4, -2.941105599e-2, -9.527032992e-2},
                      Cantilever{"tet4", 2, -2.176941877e-4, -1.115010843e-2, -5.931776088e-2},
                      Cantilever{"tet4", 4, -3.359517245e-4, -2.235984802e-2, -8.367191181e-2},
                      Cantilever{"wedge6", 2, -3.672122187e-4, -2.536326319e-2, -8.892545802e-2},
                      Cantilever{"wedge6", 4, -4.061092236e-4, -2.931616485e-2, -9.510617339e-2},
                      Cantilever{"pyramid5", 2, -3.394148599e-4, -2.267257056e-2, -8.453181137e-2},
                      Cantilever{"pyramid5", 4, -3.971877444e-4, -2.846686192e-2, -9.388526275e-2}),
    [](const auto& test) { return std::string(test.param.element) + "_" + std::to_string(test.param.cells); });

TEST_P(ReferenceCantileverTest, BendsAsInTheReferencePrograms) {
  const Cantilever& expected = GetParam();
  Body body = clampedBar(expected.element, expected.cells);
  const std::int32_t tip = tipOf(body);
  const auto bend = [&](double newton, int steps) {
    body.externalForce() = consistentTraction(
        body.mesh(), [](const Eigen::Vector3d& X) { return X[0] > 0.2 - 1e-9; },
        [&](const Eigen::Vector3d&) { return Eigen::Vector3d(0, 0, -newton / 0.0016); });
    const StaticSolution solution = solveStatic(body, body.mesh().X, {steps, 30, 1e-13});
    EXPECT_TRUE(solution.converged);
    return Eigen::Vector3d(solution.x.col(tip) - body.mesh().X.col(tip));
  };
  EXPECT_NEAR(bend(1e-3, 1)[2], expected.smallZ, 2e-9 * std::abs(expected.smallZ));
  const Eigen::Vector3d large = bend(0.3, 6);
  EXPECT_NEAR(large[0], expected.largeX, 2e-9 * std::abs(expected.largeX));
  EXPECT_NEAR(large[2], expected.largeZ, 2e-9 * std::abs(expected.largeZ));
}

struct Frequencies {
  std::string_view element;
  std::array<double, 10> hertz;
};
class ReferenceFrequencyTest : public ::testing::TestWithParam<Frequencies> {};
INSTANTIATE_TEST_SUITE_P(Bars, ReferenceFrequencyTest,
                         ::testing::Values(Frequencies{"hex8",
                                                       {0.92412032, 0.92412032, 3.4633131, 4.9039446, 4.9039446,
                                                        6.9122981, 10.304661, 11.543396, 11.543396, 16.892274}},
                                           Frequencies{"tet4",
                                                       {1.1107912, 1.2997931, 4.8610199, 5.6729047, 6.2395716,
                                                        6.9701448, 12.989270, 13.878184, 14.462138, 20.472363}},
                                           Frequencies{"wedge6",
                                                       {0.92574416, 1.2010296, 4.2284852, 4.9086386, 5.9605447,
                                                        6.9362148, 11.544778, 12.544461, 13.451765, 18.858983}},
                                           Frequencies{"pyramid5",
                                                       {0.96342263, 0.96342263, 4.1639514, 5.1258367, 5.1258367,
                                                        6.9109172, 12.112658, 12.112658, 12.426392, 19.953869}}),
                         [](const auto& test) { return std::string(test.param.element); });

TEST_P(ReferenceFrequencyTest, RingsAsInTheReferencePrograms) {
  const Body body = clampedBar(GetParam().element, 2);
  const FreeDofs dofs(body);
  const Eigen::VectorXd scale = dofs.gather(body.lumpedMass().cwiseSqrt().cwiseInverse().transpose().replicate(3, 1));
  const Eigen::MatrixXd K =
      scale.asDiagonal() * Eigen::MatrixXd(dofs.reduce(body.assembleTangent(body.mesh().X))) * scale.asDiagonal();
  const Eigen::VectorXd lambda =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K, Eigen::EigenvaluesOnly).eigenvalues();
  for (std::size_t i = 0; i < GetParam().hertz.size(); ++i) {
    const double hertz = std::sqrt(lambda[i]) / (2 * std::numbers::pi);
    EXPECT_NEAR(hertz, GetParam().hertz[i], 6e-8 * GetParam().hertz[i]) << i;
  }
}

struct Fall {
  std::string_view element;
  std::array<double, 5> z;  // tip displacement at 0.1, 0.2, … 0.5 s under 1 m/s², m
  double relative;          // digits that the table gives
};
class ReferenceFallTest : public ::testing::TestWithParam<Fall> {};
INSTANTIATE_TEST_SUITE_P(
    Bars, ReferenceFallTest,
    ::testing::Values(Fall{"hex8", {-5.811532e-3, -2.709412e-2, -5.039456e-2, -7.255987e-2, -8.233314e-2}, 5e-7},
                      Fall{"tet4", {-6.321336e-3, -2.457919e-2, -4.244283e-2, -5.061278e-2, -4.604612e-2}, 5e-7},
                      Fall{"wedge6", {-5.81223e-3, -2.70948e-2, -5.03654e-2, -7.24631e-2, -8.21162e-2}, 3e-6},
                      Fall{"pyramid5", {-5.95549e-3, -2.699158e-2, -4.959463e-2, -6.997363e-2, -7.740339e-2}, 2e-6}),
    [](const auto& test) { return std::string(test.param.element); });

TEST_P(ReferenceFallTest, FallsAsInTheReferencePrograms) {
  Body body = clampedBar(GetParam().element, 2);
  body.addBodyForce({0, 0, -1});
  const std::int32_t tip = tipOf(body);
  // Richardson's extrapolation of two steps takes the h² of the error out.
  const auto fall = [&](int stepsPerTenth) {
    BodySystem system(body);
    State state = system.initialState();
    StormerVerlet verlet;
    std::array<double, 5> z;
    for (double& value : z) {
      for (int i = 0; i < stepsPerTenth; ++i) verlet.step(system, state, 0.1 / stepsPerTenth);
      value = state.x(2, tip) - body.mesh().X(2, tip);
    }
    return z;
  };
  const auto coarse = fall(400), fine = fall(800);
  for (std::size_t i = 0; i < fine.size(); ++i) {
    const double z = fine[i] + (fine[i] - coarse[i]) / 3;
    EXPECT_NEAR(z, GetParam().z[i], GetParam().relative * std::abs(GetParam().z[i])) << "t = 0." << i + 1 << " s";
  }
}

struct Critical {
  std::string_view element;
  int cells;
  double freeStep, clampedStep;  // 2/omega at rest, s
};
class ReferenceCriticalStepTest : public ::testing::TestWithParam<Critical> {};
INSTANTIATE_TEST_SUITE_P(Bars, ReferenceCriticalStepTest,
                         ::testing::Values(Critical{"wedge6", 2, 2.161576234e-03, 2.161877097e-03},
                                           Critical{"wedge6", 4, 1.086226950e-03, 1.086227484e-03},
                                           Critical{"pyramid5", 2, 1.837232643e-03, 1.837233754e-03},
                                           Critical{"pyramid5", 4, 9.246170413e-04, 9.246170415e-04}),
                         [](const auto& test) {
                           return std::string(test.param.element) + "_" + std::to_string(test.param.cells);
                         });

TEST_P(ReferenceCriticalStepTest, IsThatOfTheReferenceProgram) {
  for (const bool clamped : {false, true}) {
    const Body body = clampedBar(GetParam().element, GetParam().cells, clamped);
    const GlobalFrequency top = globalFrequency(body, body.mesh().X);
    ASSERT_TRUE(top.converged);
    const double expected = clamped ? GetParam().clampedStep : GetParam().freeStep;
    EXPECT_NEAR(2 / std::sqrt(top.lambda), expected, 2e-9 * expected);
  }
}

}  // namespace
}  // namespace ringwatch

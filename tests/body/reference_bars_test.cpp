// Clamped bars against GetFEM 5.4.2 and CalculiX 2.20: bending under an end load, natural frequencies, falling under
// gravity. E = 30 kPa, nu = 0.3, rho = 1000 kg/m3, St. Venant–Kirchhoff, 0.2 × 0.04 × 0.04 m, x = 0 clamped.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/integrators/stormer_verlet.h>
#include <tests/support/body_cases.h>

namespace ringwatch {
namespace {

Body clampedBar(std::string_view element, int cells) {
  Body body(test::referenceBar(element, cells), makeMaterial("stvk", 30e3, 0.3, 1000), {{}, Lumping::rowSum, 1});
  for (std::int32_t node : test::nodesWhere(body.mesh(), [](const Eigen::Vector3d& p) { return p[0] < 1e-9; }))
    body.constraints().fix(node);
  return body;
}
std::int32_t tipOf(const Body& body) { return test::nodeNearest(body.mesh(), {0.2, 0.02, 0.02}); }

/// Free degrees of freedom, numbered 0, 1, …; -1 for the others.
std::vector<int> freeNumbers(const Body& body, int& count) {
  std::vector<int> number(3 * body.nodeCount(), -1);
  count = 0;
  for (std::int32_t i = 0; i < body.nodeCount(); ++i)
    for (int c = 0; c < 3; ++c)
      if (!body.constraints().isConstrained(i, c)) number[3 * i + c] = count++;
  return number;
}
Eigen::SparseMatrix<double> freeTangent(const Body& body, const NodeVectors& x, const std::vector<int>& number,
                                        int count) {
  const Eigen::SparseMatrix<double> K = body.assembleTangent(x);
  std::vector<Eigen::Triplet<double>> entries;
  for (int column = 0; column < K.outerSize(); ++column)
    for (Eigen::SparseMatrix<double>::InnerIterator it(K, column); it; ++it) {
      const int i = number[it.row()], j = number[column];
      if (i >= 0 && j >= 0) entries.emplace_back(i, j, it.value());
    }
  Eigen::SparseMatrix<double> result(count, count);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

/// Nodal forces of a uniform traction on x = 0.2 that sums to `total`: each face's force goes evenly to its corners, as
/// its shape functions integrate on rectangles and triangles.
NodeVectors endLoad(const Mesh& mesh, const Eigen::Vector3d& total) {
  NodeVectors f = NodeVectors::Zero(3, mesh.X.cols());
  double area = 0;
  const MeshBlock& block = mesh.blocks[0];
  for (std::size_t e = 0; e < block.elementCount(); ++e)
    for (const auto& face : elementInfo(block.type).faces) {
      std::vector<std::int32_t> nodes;
      for (int a : face)
        if (a >= 0) nodes.push_back(block.element(e)[a]);
      if (std::any_of(nodes.begin(), nodes.end(), [&](std::int32_t i) { return mesh.X(0, i) < 0.2 - 1e-9; })) continue;
      double faceArea = 0;
      for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
        const Eigen::Vector3d p = mesh.X.col(nodes[0]), q = mesh.X.col(nodes[i]), r = mesh.X.col(nodes[i + 1]);
        faceArea += 0.5 * (q - p).cross(r - p).norm();
      }
      area += faceArea;
      for (std::int32_t i : nodes) f.col(i) += faceArea / static_cast<double>(nodes.size()) * total;
    }
  EXPECT_NEAR(area, 0.04 * 0.04, 1e-15);
  return f / area;
}

/// Static equilibrium under the body's external force times 1/steps, 2/steps, … 1, by Newton's method.
NodeVectors equilibrium(const Body& body, int steps) {
  int count = 0;
  const std::vector<int> number = freeNumbers(body, count);
  NodeVectors x = body.mesh().X, f;
  Body::Workspace workspace;
  for (int step = 1; step <= steps; ++step) {
    bool converged = false;
    for (int iteration = 0; iteration < 30 && !converged; ++iteration) {
      body.internalForce(x, f, workspace);
      const NodeVectors residual = body.externalForce() * (static_cast<double>(step) / steps) - f;
      Eigen::VectorXd r(count);
      for (std::size_t i = 0; i < number.size(); ++i)
        if (number[i] >= 0) r[number[i]] = residual.data()[i];
      const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(freeTangent(body, x, number, count));
      EXPECT_EQ(solver.info(), Eigen::Success);
      const Eigen::VectorXd u = solver.solve(r);
      for (std::size_t i = 0; i < number.size(); ++i)
        if (number[i] >= 0) x.data()[i] += u[number[i]];
      converged = u.norm() < 1e-13;
    }
    EXPECT_TRUE(converged) << "step " << step;
  }
  return x;
}

struct Cantilever {
  std::string_view element;
  int cells;
  double smallZ, largeX, largeZ;  // tip displacement under 1e-3 N and 0.3 N, m
};
class CantileverTest : public ::testing::TestWithParam<Cantilever> {};
INSTANTIATE_TEST_SUITE_P(Bars, CantileverTest,
                         ::testing::Values(Cantilever{"hex8", 2, -3.678957725e-4, -2.545046848e-2, -8.910916125e-2},
                                           Cantilever{"hex8", 4, -4.069694493e-4, -2.941105599e-2, -9.527032992e-2},
                                           Cantilever{"tet4", 2, -2.176941877e-4, -1.115010843e-2, -5.931776088e-2},
                                           Cantilever{"tet4", 4, -3.359517245e-4, -2.235984802e-2, -8.367191181e-2}),
                         [](const auto& test) {
                           return std::string(test.param.element) + "_" + std::to_string(test.param.cells);
                         });

TEST_P(CantileverTest, BendsAsInTheReferencePrograms) {
  const Cantilever& expected = GetParam();
  Body body = clampedBar(expected.element, expected.cells);
  const std::int32_t tip = tipOf(body);
  body.externalForce() = endLoad(body.mesh(), {0, 0, -1e-3});
  const Eigen::Vector3d small = equilibrium(body, 1).col(tip) - body.mesh().X.col(tip);
  EXPECT_NEAR(small[2], expected.smallZ, 2e-9 * std::abs(expected.smallZ));
  body.externalForce() = endLoad(body.mesh(), {0, 0, -0.3});
  const Eigen::Vector3d large = equilibrium(body, 6).col(tip) - body.mesh().X.col(tip);
  EXPECT_NEAR(large[0], expected.largeX, 2e-9 * std::abs(expected.largeX));
  EXPECT_NEAR(large[2], expected.largeZ, 2e-9 * std::abs(expected.largeZ));
}

struct Frequencies {
  std::string_view element;
  std::array<double, 10> hertz;
};
class FrequencyTest : public ::testing::TestWithParam<Frequencies> {};
INSTANTIATE_TEST_SUITE_P(Bars, FrequencyTest,
                         ::testing::Values(Frequencies{"hex8",
                                                       {0.92412032, 0.92412032, 3.4633131, 4.9039446, 4.9039446,
                                                        6.9122981, 10.304661, 11.543396, 11.543396, 16.892274}},
                                           Frequencies{"tet4",
                                                       {1.1107912, 1.2997931, 4.8610199, 5.6729047, 6.2395716,
                                                        6.9701448, 12.989270, 13.878184, 14.462138, 20.472363}}),
                         [](const auto& test) { return std::string(test.param.element); });

TEST_P(FrequencyTest, RingsAsInTheReferencePrograms) {
  const Body body = clampedBar(GetParam().element, 2);
  int count = 0;
  const std::vector<int> number = freeNumbers(body, count);
  Eigen::VectorXd scale(count);
  for (std::size_t i = 0; i < number.size(); ++i)
    if (number[i] >= 0) scale[number[i]] = 1 / std::sqrt(body.lumpedMass()[i / 3]);
  const Eigen::MatrixXd K =
      scale.asDiagonal() * Eigen::MatrixXd(freeTangent(body, body.mesh().X, number, count)) * scale.asDiagonal();
  const Eigen::VectorXd lambda =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K, Eigen::EigenvaluesOnly).eigenvalues();
  for (std::size_t i = 0; i < GetParam().hertz.size(); ++i) {
    const double hertz = std::sqrt(lambda[i]) / (2 * std::numbers::pi);
    EXPECT_NEAR(hertz, GetParam().hertz[i], 6e-8 * GetParam().hertz[i]) << i;
  }
}

struct Fall {
  std::string_view element;
  std::array<double, 5> z;  // tip displacement at 0.1, 0.2, … 0.5 s, m
};
class FallTest : public ::testing::TestWithParam<Fall> {};
INSTANTIATE_TEST_SUITE_P(
    Bars, FallTest,
    ::testing::Values(Fall{"hex8", {-5.811532e-3, -2.709412e-2, -5.039456e-2, -7.255987e-2, -8.233314e-2}},
                      Fall{"tet4", {-6.321336e-3, -2.457919e-2, -4.244283e-2, -5.061278e-2, -4.604612e-2}}),
    [](const auto& test) { return std::string(test.param.element); });

TEST_P(FallTest, FallsAsInTheReferencePrograms) {
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
    EXPECT_NEAR(z, GetParam().z[i], 5e-7 * std::abs(GetParam().z[i])) << "t = 0." << i + 1 << " s";
  }
}

}  // namespace
}  // namespace ringwatch

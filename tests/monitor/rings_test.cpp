// Ring metrics against Fierz 2013's definition taken literally: the elements of each ring collected as sets, assembled
// one by one into a dense matrix, and solved by Eigen. Then the order that theory gives them, and the cheap bounds
// against their formulas.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/meshes/quality.h>
#include <ringwatch/monitor/metrics/metrics.h>
#include <tests/monitor/monitor_cases.h>
#include <tests/support/dense.h>

namespace ringwatch {
namespace {

using test::DenseTangent;
using test::Hold;
using test::Subdivision;

std::vector<Subdivision> subdivisionsAndQuadratics() {
  std::vector<Subdivision> subdivisions = test::allSubdivisions();
  subdivisions.push_back({"tet10", "tet10", 5, "", 0});
  subdivisions.push_back({"hex20", "hex20", 0, "", 0});
  return subdivisions;
}

std::vector<ElementRef> allElementsOf(const Body& body) {
  std::vector<ElementRef> all;
  for (std::size_t b = 0; b < body.blocks().size(); ++b)
    for (std::int32_t e = 0; e < body.blocks()[b]->elementCount(); ++e) all.push_back({b, e});
  return all;
}
std::span<const std::int32_t> nodesOf(const Body& body, ElementRef e) {
  return body.blocks()[e.block]->nodesOf(e.element);
}

/// The elements that hold any of the nodes, by looking at all of them.
std::set<ElementRef> elementsAt(const Body& body, const std::set<std::int32_t>& nodes) {
  std::set<ElementRef> found;
  for (const ElementRef e : allElementsOf(body))
    for (const std::int32_t node : nodesOf(body, e))
      if (nodes.count(node)) found.insert(e);
  return found;
}
std::set<std::int32_t> nodesOf(const Body& body, const std::set<ElementRef>& elements) {
  std::set<std::int32_t> nodes;
  for (const ElementRef e : elements) nodes.insert(nodesOf(body, e).begin(), nodesOf(body, e).end());
  return nodes;
}

struct Tangents {
  std::map<ElementRef, Eigen::MatrixXd> K;
  Tangents(const Body& body, const NodeVectors& x) {
    for (const ElementRef e : allElementsOf(body)) K[e] = body.elementTangent(e, x);
  }
};

/// lambda_max of the problem assembled from `elements`, over the free components of `kept` nodes.
double literalLargest(const Body& body, const Tangents& tangents, const std::set<ElementRef>& elements,
                      const std::set<std::int32_t>& kept) {
  std::map<std::pair<std::int32_t, int>, Eigen::Index> row;
  for (const std::int32_t node : kept)
    for (int c = 0; c < 3; ++c)
      if (!body.constraints().isConstrained(node, c)) row.emplace(std::pair(node, c), row.size());
  if (row.empty()) return 0;
  const Eigen::Index size = row.size();
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(size, size), M = Eigen::MatrixXd::Zero(size, size);
  for (const ElementRef e : elements) {
    const auto nodes = nodesOf(body, e);
    const Eigen::MatrixXd& Ke = tangents.K.at(e);
    std::vector<double> mass(nodes.size());
    body.elementLumpedMass(e, mass.data());
    for (Eigen::Index i = 0; i < Ke.rows(); ++i) {
      const auto r = row.find({nodes[i / 3], static_cast<int>(i % 3)});
      if (r == row.end()) continue;
      M(r->second, r->second) += mass[i / 3];
      for (Eigen::Index j = 0; j < Ke.cols(); ++j) {
        const auto s = row.find({nodes[j / 3], static_cast<int>(j % 3)});
        if (s != row.end()) K(r->second, s->second) += Ke(i, j);
      }
    }
  }
  return test::generalizedEigen((K + K.transpose()) / 2, M).values[size - 1];
}

/// A ring metric's value of an element, by the words of Fierz 2013.
double literalRing(std::string_view name, const Body& body, const Tangents& tangents, ElementRef e) {
  const std::set<std::int32_t> own(nodesOf(body, e).begin(), nodesOf(body, e).end());
  if (name.starts_with("vertex")) {
    double most = -infinity;
    for (const std::int32_t node : own) {
      std::set<ElementRef> ring = elementsAt(body, {node});
      if (name == "vertex-2-ring") ring = elementsAt(body, nodesOf(body, ring));
      most = std::max(most, literalLargest(body, tangents, ring, nodesOf(body, ring)));
    }
    return most;
  }
  const std::set<ElementRef> first = elementsAt(body, own), second = elementsAt(body, nodesOf(body, first));
  if (name == "element-1-ring") return literalLargest(body, tangents, first, nodesOf(body, first));
  if (name == "element-2-ring") return literalLargest(body, tangents, second, nodesOf(body, second));
  if (name == "reduced-1-ring") return literalLargest(body, tangents, first, own);
  return literalLargest(body, tangents, second, nodesOf(body, first));
}

class RingsTest : public ::testing::TestWithParam<Subdivision> {};
INSTANTIATE_TEST_SUITE_P(Subdivisions, RingsTest, ::testing::ValuesIn(subdivisionsAndQuadratics()),
                         [](const auto& test) { return test::testName(test.param.name); });

TEST_P(RingsTest, AreWhatFierz2013Defines) {
  test::Random random(21);
  const bool quadratic = findElementByName(GetParam().element)->order > 1;
  for (const LawInfo& law : allLaws())
    for (const Hold hold : {Hold::nothing, Hold::components}) {
      // Long and thin: rings of two layers do not reach the other end.
      Body body = test::boxBody(GetParam(), law.name, {quadratic ? 3 : 5, 1, 1});
      test::holdBody(body, hold);
      const NodeVectors x = Eigen::Vector3d(1.2, 0.95, 0.9).asDiagonal() * body.mesh().X +
                            random.nodeVectors(body.nodeCount(), 0.03 * test::cellSize);
      const Tangents tangents(body, x);
      const std::vector<ElementRef> elements = allElementsOf(body);
      for (const std::string_view name :
           {"vertex-1-ring", "vertex-2-ring", "element-1-ring", "element-2-ring", "reduced-1-ring", "reduced-2-ring"}) {
        const MetricResult result = evaluateMetric(name, body, x);
        for (std::size_t k = 0; k < elements.size(); k += 3) {
          const ElementRef e = elements[k];
          const double literal = literalRing(name, body, tangents, e);
          EXPECT_NEAR(result.elementLambda[e.block][e.element], literal, 1e-8 * result.lambda)
              << name << ", " << law.name << ", " << test::holdName(hold) << ", " << e.block << ":" << e.element;
        }
      }
    }
}

TEST_P(RingsTest, KeepTheOrderOfTheirSubmatrices) {
  for (const test::NamedState& state : test::deformedStates(test::boxBody(GetParam(), "stvk", {2, 2, 1}).mesh().X, 5)) {
    const Body body = test::boxBody(GetParam(), "stvk", {2, 2, 1});
    const double whole = DenseTangent(body, state.x).largest();
    const MetricResult one = evaluateMetric("reduced-1-ring", body, state.x),
                       two = evaluateMetric("reduced-2-ring", body, state.x),
                       vertex = evaluateMetric("vertex-1-ring", body, state.x);
    for (std::size_t b = 0; b < one.elementLambda.size(); ++b)
      for (std::size_t e = 0; e < one.elementLambda[b].size(); ++e)
        EXPECT_LE(one.elementLambda[b][e], two.elementLambda[b][e] + 1e-8 * whole) << state.name;
    EXPECT_LE(two.lambda, whole * (1 + 1e-12)) << state.name;
    EXPECT_EQ(two.direction, Direction::lowerBound);
    EXPECT_EQ(vertex.direction, body.blocks().size() == 1 ? Direction::upperBound : Direction::estimate);
    if (vertex.direction == Direction::upperBound) {
      EXPECT_GE(vertex.lambda, whole * (1 - 1e-12)) << state.name;
    }
  }
}

TEST_P(RingsTest, CheapBoundsAreTheirFormulas) {
  const Body body = test::boxBody(GetParam(), "stvk", {2, 1, 1});
  const NodeVectors& X = body.mesh().X;
  std::vector<int> valence(body.nodeCount());
  double stiffness = 0, scaled = 0;
  for (const ElementRef e : allElementsOf(body)) {
    Eigen::MatrixXd K = body.elementTangent(e, X);
    const auto largest = [](const Eigen::MatrixXd& A) {
      return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A, Eigen::EigenvaluesOnly).eigenvalues()[A.rows() - 1];
    };
    stiffness = std::max(stiffness, largest(K));
    const auto nodes = nodesOf(body, e);
    for (const std::int32_t node : nodes) ++valence[node];
    for (Eigen::Index i = 0; i < K.rows(); ++i)
      for (Eigen::Index j = 0; j < K.cols(); ++j)
        K(i, j) /= std::sqrt(body.lumpedMass()[nodes[i / 3]] * body.lumpedMass()[nodes[j / 3]]);
    scaled = std::max(scaled, largest(K));
  }
  const int n = *std::max_element(valence.begin(), valence.end());
  const auto expect = [&](std::string_view name, double expected) {
    EXPECT_NEAR(evaluateMetric(name, body, X).lambda, expected, 1e-9 * expected) << name;
  };
  // At rest every tangent is positive semidefinite, and the lower sides have nothing to take off.
  expect("fried", n * stiffness / body.lumpedMass().minCoeff());
  expect("fried-lower", stiffness / body.lumpedMass().maxCoeff());
  expect("shewchuk", n * scaled);
  expect("shewchuk-lower", scaled);
}

TEST(Rings, ReportProgressUpToTheEnd) {
  const Body body = test::boxBody(test::allSubdivisions()[0], "stvk", {4, 4, 4});
  std::vector<double> shares;
  evaluateMetric("element-1-ring", body, body.mesh().X, [&](double share) { shares.push_back(share); });
  ASSERT_GT(shares.size(), 1u);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_EQ(shares.back(), 1);
}

/// The length L that a pressure-wave metric used: omega = 2 s / L.
double lengthBy(std::string_view name, const Mesh& mesh) {
  const Material material = makeMaterial("stvk", test::young, test::poisson, test::density);
  const Body body(mesh, material, test::onThreads(1));
  return 2 * material.waveSpeed() / std::sqrt(evaluateMetric(name, body, mesh.X).lambda);
}

/// 0.8 · 0.98 · √(2/0.5225625)/2, which tests/foreign holds to what CalculiX prints.
constexpr double calculixShare = 0.766888004118;

TEST(PressureWave, LengthsOfABrick) {
  BarOptions options;
  options.size = {0.05, 0.03, 0.02};
  options.cells = {1, 1, 1};
  for (const char* element : {"hex8", "hex20"}) {
    options.element = element;
    const Mesh mesh = generateBar(options);
    EXPECT_NEAR(lengthBy("pressure-wave", mesh), 0.02, 1e-14) << element;
    EXPECT_NEAR(lengthBy("pressure-wave:min-height", mesh), 0.02, 1e-14) << element;
    EXPECT_NEAR(lengthBy("pressure-wave:volume-over-area", mesh), 0.02, 1e-14) << element;
    EXPECT_NEAR(lengthBy("pressure-wave:in-radius", mesh), 3 * 0.3 / (2 * (15 + 10 + 6)), 1e-14) << element;
    // Middle nodes halve the distance between neighbours.
    EXPECT_NEAR(lengthBy("pressure-wave:shortest-edge", mesh), element == std::string("hex8") ? 0.02 : 0.01, 1e-14);
    EXPECT_NEAR(lengthBy("pressure-wave:cell-diameter", mesh), std::sqrt(0.0025 + 0.0009 + 0.0004), 1e-14) << element;
    EXPECT_NEAR(lengthBy("pressure-wave:nodal", mesh), 0.02, 1e-14) << element;
    const bool linear = element == std::string("hex8");
    EXPECT_NEAR(lengthBy("pressure-wave:calculix", mesh), (linear ? 1 : 0.3) * calculixShare * 0.02, 1e-14) << element;
    if (!linear) continue;
    // |∇N| of the mean gradient has components 1/(4 a): omega² = 4 c² Σ 1/a².
    const double inverse = 1 / 0.0025 + 1 / 0.0009 + 1 / 0.0004;
    EXPECT_NEAR(lengthBy("dilatational-mode", mesh), 1 / std::sqrt(inverse), 1e-14);
  }
}

TEST(PressureWave, NodesTakeTheMeanOfTheirElements) {
  BarOptions options;
  options.size = {0.03, 0.04, 0.04};
  options.cells = {2, 1, 1};
  options.element = "hex8";
  options.grading = 2;  // cells of 1 and 2 cm
  const Body body(generateBar(options), makeMaterial("stvk", test::young, test::poisson, test::density),
                  test::onThreads(1));
  const auto waves = evaluateMetric("pressure-wave", body, body.mesh().X).elementLambda[0];
  const auto nodal = evaluateMetric("pressure-wave:nodal", body, body.mesh().X).elementLambda[0];
  EXPECT_NEAR(waves[0], 4 * waves[1], 1e-12 * waves[0]);
  EXPECT_NEAR(nodal[0], waves[0], 1e-12 * waves[0]);  // at its free end
  EXPECT_NEAR(nodal[1], (waves[0] + 2 * waves[1]) / 3, 1e-12 * waves[0]);
}

Mesh regularTetrahedron(double edge) {
  Mesh mesh;
  mesh.X.resize(3, 4);
  mesh.X << 1, -1, -1, 1, 1, 1, -1, -1, 1, -1, 1, -1;
  mesh.X *= edge / std::sqrt(8.0);
  mesh.nodeIds = {0, 1, 2, 3};
  mesh.blocks = {{elementTypeOf<Tet4>, {0, 1, 2, 3}, {0}}};
  if (meshVolume(mesh) < 0) std::swap(mesh.blocks[0].connectivity[2], mesh.blocks[0].connectivity[3]);
  return mesh;
}

TEST(PressureWave, LengthsOfARegularTetrahedron) {
  const Mesh mesh = regularTetrahedron(2);
  const double height = 2 * std::sqrt(2.0 / 3);
  EXPECT_NEAR(lengthBy("pressure-wave", mesh), height, 1e-13);
  EXPECT_NEAR(lengthBy("pressure-wave:min-height", mesh), height, 1e-13);
  EXPECT_NEAR(lengthBy("pressure-wave:volume-over-area", mesh), height / 3, 1e-13);
  EXPECT_NEAR(lengthBy("pressure-wave:in-radius", mesh), height / 4, 1e-13);
  EXPECT_NEAR(lengthBy("pressure-wave:shortest-edge", mesh), 2, 1e-13);
  EXPECT_NEAR(lengthBy("pressure-wave:cell-diameter", mesh), 2, 1e-13);
  EXPECT_NEAR(lengthBy("pressure-wave:calculix", mesh), calculixShare * height / 9, 1e-13);
  EXPECT_NEAR(lengthBy("pressure-wave:nodal", mesh), height, 1e-13);
  EXPECT_NEAR(lengthBy("dilatational-mode", mesh), height / 2, 1e-13);
}

TEST(PressureWave, NamesItsKnownOptions) {
  const Body body = test::boxBody(test::allSubdivisions()[0], "stvk");
  try {
    evaluateMetric("pressure-wave:height", body, body.mesh().X);
    FAIL() << "an unknown option was accepted";
  } catch (const InputError& error) {
    const std::string text = error.what();
    for (const char* option :
         {"min-height", "volume-over-area", "in-radius", "shortest-edge", "cell-diameter", "calculix", "nodal"})
      EXPECT_NE(text.find(option), std::string::npos) << text;
    EXPECT_EQ(text.find("nodal-bound"), std::string::npos) << text;
  }
}

TEST(RegularTetrahedron, HasTheFrequencyOfItsDilation) {
  // The top mode is u = s x: with four nodes at the circumradius r, r² = 3/8 edge², its strain energy 9/2 K s² V and
  // its mass rho V give omega² = 9 K / (rho r²), K the bulk modulus. Section 3.5 of Fierz 2013 has 1.8 rad/s at nu =
  // 0.2 and edge 2 m; its 9.8 rad/s at nu = 0.49 is 10 by this formula.
  const auto omega = [](double poisson, double edge) {
    const Body body(regularTetrahedron(edge), makeMaterial("linear", 1, poisson, 1), test::onThreads(1));
    return std::sqrt(evaluateMetric("single-element", body, body.mesh().X).lambda);
  };
  EXPECT_NEAR(omega(0.2, 2), 1.8, 0.05);
  EXPECT_NEAR(omega(0.49, 2), 10, 1e-11);
  for (const double poisson : {0.2, 0.3, 0.45, 0.49})
    for (const double edge : {2.0, 1.0, 0.01}) {
      const double expected = std::sqrt(9 / (3 * (1 - 2 * poisson)) / (3.0 / 8 * edge * edge));
      EXPECT_NEAR(omega(poisson, edge), expected, 1e-11 * expected);
    }
}

}  // namespace
}  // namespace ringwatch

// A certified selection kept through changes of state and mesh: every claim against dense or global eigenvalues, and
// how little of the mesh it evaluates.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <ringwatch/base/error.h>
#include <ringwatch/handlers/handler.h>
#include <ringwatch/handlers/selection/incremental_selection.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <ringwatch/monitor/bounds/nodal_bound.h>
#include <tests/handlers/handler_cases.h>

namespace ringwatch {
namespace {

using test::denseHighest;

/// The claim: explicit elements below the nodal sums, these below lambda M.
void expectProof(const Body& body, const NodeVectors& x, double lambda, const CertifiedSelection& selection) {
  EXPECT_LE(selection.explicitPart.value, lambda);
  const Eigen::MatrixXd K = test::stiffnessOf(body, x, selection.chosen, false);
  EXPECT_LE(denseHighest(body, K, body.lumpedMass()), selection.explicitPart.value * (1 + 1e-9));
  Eigen::MatrixXd excess = K;
  for (std::int32_t i = 0; i < body.nodeCount(); ++i) excess.block<3, 3>(3 * i, 3 * i) -= selection.nodalSums[i];
  EXPECT_LE(denseHighest(body, excess, Eigen::VectorXd::Ones(body.nodeCount())), 1e-9 * K.norm());
}

NodeVectors turned(const NodeVectors& x, double angle) {
  return Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix() * x;
}

/// What rounding leaves of a statement that holds: 2.2e-16.
constexpr double followRounding = 6e-16;

/// Some share of the way to positions strained by some ten per cent.
NodeVectors strained(const NodeVectors& X, double share) { return X + share * (test::strained(X, 5, 0.002) - X); }

class IncrementalSelectionTest : public ::testing::TestWithParam<std::tuple<const char*, bool>> {};
INSTANTIATE_TEST_SUITE_P(All, IncrementalSelectionTest,
                         ::testing::Combine(::testing::Values("stvk", "corotational", "linear", "neo-hookean"),
                                            ::testing::Bool()),
                         [](const auto& test) {
                           return test::testName(std::get<0>(test.param)) +
                                  (std::get<1>(test.param) ? "_clamped" : "_free");
                         });

TEST_P(IncrementalSelectionTest, ProvesTheExplicitPartAtEveryState) {
  const auto [law, clamped] = GetParam();
  const Body body = test::sliverBody(law, 0.95, clamped);
  const NodeVectors& X = body.mesh().X;
  const double lambda = 0.1 * denseHighest(body, X);
  IncrementalSelection kept;
  ElementFlags chosen = kept.choose(body, X, lambda, noElements(body.mesh())).chosen;
  EXPECT_EQ(kept.evaluatedElements(), 240);
  std::int64_t evaluations = 0;
  for (const double amount : {0.0, 1e-3, 0.1, 1.0}) {
    const NodeVectors x = strained(X, amount);
    const CertifiedSelection& selection = kept.choose(body, x, lambda, chosen);
    expectProof(body, x, lambda, selection);
    EXPECT_LE(kept.verify(body, x), followRounding);
    for (const ElementRef e : chosenElements(chosen)) EXPECT_TRUE(selection.chosen[e.block][e.element]);
    chosen = selection.chosen;
    EXPECT_LE(amount == 0 ? kept.evaluatedElements() : 0, 120);
    evaluations += selection.evaluations;
  }
  EXPECT_EQ(evaluations == 0, lawNamed(law).tangentIsConstant);  // whose tangent never changes
}

TEST(IncrementalSelection, RotatesWithTheBody) {
  const Body body = test::sliverBody("corotational", 0.98, false);
  const NodeVectors& X = body.mesh().X;
  // Room at every node: nothing but the turn can make it evaluate again.
  const Mesh regular = test::gridMesh("tet4", {10, 2, 2}, {0.2, 0.04, 0.04});
  const Body good(regular, makeMaterial("corotational", test::young, test::poisson, test::density));
  const double lambda = 4 * denseHighest(good, regular.X);
  IncrementalSelection kept;
  const ElementFlags chosen = kept.choose(body, X, lambda, noElements(body.mesh())).chosen;
  const std::int64_t scratch = kept.last().evaluations;
  const NodeVectors x = turned(X, 1.3);
  const CertifiedSelection& again = kept.choose(body, x, lambda, chosen);
  EXPECT_EQ(again.chosen, chosen);
  EXPECT_LT(again.evaluations, scratch / 20);
  expectProof(body, x, lambda, again);
  EXPECT_LE(kept.verify(body, x), followRounding);
}

TEST(IncrementalSelection, EvaluatesLittleOfALargeMeshAfterASmallCut) {
  BarOptions options;
  options.size = {0.4, 0.06, 0.06};
  options.cells = {32, 5, 5};
  options.jitter = 0.2;
  const Mesh mesh = generateBar(options);
  const CutMesh cut =
      cutMesh(mesh, CutSurface::swept({{0.2, -0.01, 0.04}, {0.2, 0.07, 0.04}}, {0, 0, 0.03}), mesh.X, 0.01);
  ASSERT_GT(cut.facesOpened, 0u);
  for (const char* law : {"corotational", "stvk"}) {
    const Material material = makeMaterial(law, 30e3, 0.3, 1000);
    const Body before(mesh, material, {{}, Lumping::rowSum, 1}), after(cut.mesh, material, {{}, Lumping::rowSum, 1});
    const double lambda = 1.05 * NodalBound(before).evaluate(mesh.X, 8).value;
    IncrementalSelection kept;
    // Bent and turned since the first choice.
    const NodeVectors x = turned(strained(mesh.X, 0.02), 0.4);
    kept.choose(before, mesh.X, lambda, noElements(mesh));
    const auto carried = kept.choose(before, x, lambda, kept.last().chosen).chosen;
    kept.carryOver(cut);
    const NodeVectors xCut = carriedOver(cut, x);
    const CertifiedSelection& selection = kept.choose(after, xCut, lambda, carriedOver(cut, carried));
    const std::int64_t elements = cut.mesh.elementCount();
    EXPECT_GT(chosenElements(selection.chosen).size(), 0u);
    EXPECT_LT(kept.evaluatedElements(), elements / 5) << law;
    EXPECT_LE(selection.explicitPart.value, lambda);
    EXPECT_LE(kept.verify(after, xCut), followRounding);
    if (std::string_view(law) == "corotational") {
      const Body rest(after, complement(selection.chosen));
      EXPECT_LE(globalFrequency(rest, xCut).lambda, selection.explicitPart.value * (1 + 1e-6));
    }
    // About as good as the choice from scratch, at a small share of its evaluations.
    const CertifiedSelection fromScratch = selectCertified(after, xCut, lambda);
    EXPECT_LE(static_cast<double>(chosenElements(selection.chosen).size()),
              1.2 * static_cast<double>(chosenElements(fromScratch.chosen).size()) + 10);
    EXPECT_LT(selection.evaluations, fromScratch.evaluations / 4) << law;
  }
}

TEST(IncrementalSelection, GivesBackBesideACutAlone) {
  const Mesh mesh = test::gridMesh("tet4", {20, 2, 2}, {0.4, 0.04, 0.04});
  const CutMesh cut = cutMesh(mesh, CutSurface::plane({0.21, 0, 0}, {1, 0, 0}), mesh.X, 0.2);
  const Material material = makeMaterial("corotational", test::young, test::poisson, test::density);
  const Body before(mesh, material), after(cut.mesh, material);
  // A bound that needs no element to be handled: some are by order.
  const double lambda = 3 * denseHighest(after, cut.mesh.X);
  ElementFlags ordered = noElements(mesh);
  for (std::size_t e = 0; e < ordered[0].size(); e += 3) ordered[0][e] = true;
  IncrementalSelection kept;
  EXPECT_EQ(kept.choose(before, mesh.X, lambda, ordered).chosen, ordered);
  kept.carryOver(cut);
  const CertifiedSelection& selection = kept.choose(after, cut.mesh.X, lambda, noElements(cut.mesh));
  const std::vector<bool> beside = touchedNodes(after, cut.changed);
  std::size_t freed = 0, still = 0;
  for (std::size_t e = 0; e < selection.chosen[0].size(); ++e) {
    if (cut.changed[0][e] || !ordered[0][cut.parent[0][e]]) continue;
    const auto nodes = after.blocks()[0]->nodesOf(e);
    const bool near = std::any_of(nodes.begin(), nodes.end(), [&](std::int32_t n) { return beside[n]; });
    EXPECT_EQ(selection.chosen[0][e], !near) << e;
    (near ? freed : still) += 1;
  }
  EXPECT_GT(freed, 0u);
  EXPECT_GT(still, 0u);
  EXPECT_LE(kept.evaluatedElements(), static_cast<std::int64_t>(cut.mesh.elementCount()) / 2);
}

TEST(IncrementalSelection, SaysWhenTheTangentIsNotFinite) {
  const Body body = test::sliverBody();
  IncrementalSelection kept;
  kept.choose(body, body.mesh().X, 1e6, noElements(body.mesh()));
  NodeVectors x = body.mesh().X;
  x(0, 3) = std::nan("");
  EXPECT_THROW(kept.choose(body, x, 1e6, noElements(body.mesh())), NumericalError);
}

}  // namespace
}  // namespace ringwatch

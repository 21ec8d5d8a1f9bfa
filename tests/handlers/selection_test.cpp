// Which elements a handler takes: the certified rest against dense eigenvalues of assembled matrices.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include <ringwatch/base/error.h>
#include <ringwatch/base/median.h>
#include <ringwatch/handlers/handler.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/meshes/modify/cut.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <ringwatch/monitor/bounds/reduced_ring.h>
#include <ringwatch/monitor/stability_monitor.h>
#include <tests/handlers/handler_cases.h>

namespace ringwatch {
namespace {

using test::denseHighest;

class CertifiedSelectionTest : public ::testing::TestWithParam<std::tuple<const char*, bool, bool>> {};
INSTANTIATE_TEST_SUITE_P(All, CertifiedSelectionTest,
                         ::testing::Combine(::testing::Values("stvk", "corotational", "linear", "neo-hookean"),
                                            ::testing::Bool(), ::testing::Bool()),
                         [](const auto& test) {
                           return test::testName(std::get<0>(test.param)) +
                                  (std::get<1>(test.param) ? "_clamped" : "_free") +
                                  (std::get<2>(test.param) ? "_strained" : "_rest");
                         });

TEST_P(CertifiedSelectionTest, LeavesARestBelowTheWantedFrequency) {
  const auto [law, clamped, strained] = GetParam();
  const Body body = test::sliverBody(law, 0.95, clamped);
  const NodeVectors x = strained ? test::strained(body.mesh().X, 5, 0.002) : body.mesh().X;
  const double highest = denseHighest(body, x);
  std::size_t before = 0;
  for (const double share : {0.9, 0.3, 0.1, 0.03}) {
    const double lambda = share * highest;
    const CertifiedSelection selection = selectCertified(body, x, lambda);
    const double rest = denseHighest(body, test::stiffnessOf(body, x, selection.chosen, false), body.lumpedMass());
    EXPECT_LE(selection.explicitPart.value, lambda) << share;
    EXPECT_LE(rest, selection.explicitPart.value * (1 + 1e-9)) << share;  // the claim
    const std::size_t count = chosenElements(selection.chosen).size();
    EXPECT_GT(count, 0u) << share;
    EXPECT_GE(count, before);
    before = count;
  }
}

TEST(CertifiedSelection, TakesNothingWhereTheStepIsFine) {
  const Body body = test::sliverBody();
  const double highest = denseHighest(body, body.mesh().X);
  EXPECT_TRUE(chosenElements(selectCertified(body, body.mesh().X, 1.2 * highest).chosen).empty());
}

TEST(CertifiedSelection, TakesTheSliversAndLittleElse) {
  const Body body = test::sliverBody("stvk", 0.98);
  const Mesh regular = test::gridMesh("tet4", {10, 2, 2}, {0.2, 0.04, 0.04});
  const Body good(regular, makeMaterial("stvk", test::young, test::poisson, test::density));
  // Twice the square of the good mesh's frequency: on regular grids the nodal bound itself is some 20 % off.
  const double lambda = 2 * denseHighest(good, regular.X);
  const auto chosen = chosenElements(selectCertified(body, body.mesh().X, lambda).chosen);
  const auto rings = chosenElements(selectByReducedRing(body, body.mesh().X, lambda));
  EXPECT_GE(chosen.size(), 1u);
  EXPECT_LE(chosen.size(), 24u);  // those at the node that was moved
  EXPECT_LT(chosen.size(), rings.size());
}

TEST(CertifiedSelection, KeepsWhatItIsToldTo) {
  const Body body = test::sliverBody();
  ElementFlags keep = noElements(body.mesh());
  keep[0][7] = true;
  const auto chosen = chosenElements(selectCertified(body, body.mesh().X, 1e12, keep).chosen);
  EXPECT_EQ(chosen, (std::vector<ElementRef>{{0, 7}}));
}

TEST(CertifiedSelection, TakesEverythingForAnAbsurdStep) {
  const Body body = test::sliverBody("stvk", 0.95, false);
  const CertifiedSelection selection = selectCertified(body, body.mesh().X, 1e-3);
  EXPECT_EQ(chosenElements(selection.chosen).size(), body.mesh().elementCount());
  EXPECT_LE(selection.explicitPart.value, 1e-3);
}

TEST(CertifiedSelection, LeavesASliverAloneWhoseNodesAreAllFixed) {
  Body body = test::sliverBody("stvk", 0.98, false);
  const double lambda = denseHighest(body, body.mesh().X) / 2;
  ASSERT_FALSE(chosenElements(selectCertified(body, body.mesh().X, lambda).chosen).empty());
  for (std::int32_t i = 0; i < body.nodeCount(); ++i) body.constraints().fix(i);
  EXPECT_TRUE(chosenElements(selectCertified(body, body.mesh().X, lambda).chosen).empty());
}

TEST(CertifiedSelection, RefusesWhatHasNoMeaning) {
  const Body body = test::sliverBody();
  EXPECT_THROW(selectCertified(body, body.mesh().X, 0), InputError);
  EXPECT_THROW(selectByReducedRing(body, body.mesh().X, 0), InputError);
  NodeVectors x = body.mesh().X;
  x(0, 3) = std::nan("");
  EXPECT_THROW(selectCertified(body, x, 1e6), NumericalError);
}

TEST(CertifiedSelection, WorksOnMixedElements) {
  BarOptions options;
  options.size = {0.2, 0.04, 0.04};
  options.cells = {6, 2, 2};
  options.jitter = 0.2;
  const Body body(generateMixedBar(options), makeMaterial("stvk", test::young, test::poisson, test::density));
  const double lambda = 0.4 * denseHighest(body, body.mesh().X);
  const CertifiedSelection selection = selectCertified(body, body.mesh().X, lambda);
  EXPECT_LE(denseHighest(body, test::stiffnessOf(body, body.mesh().X, selection.chosen, false), body.lumpedMass()),
            lambda);
}

// A part of a body is what a monitor watches.
TEST(PartOfABody, HasItsElementsForcesAndTheWholeMass) {
  const Body body = test::sliverBody();
  ElementFlags flags = noElements(body.mesh());
  for (std::size_t e = 0; e < flags[0].size(); e += 3) flags[0][e] = true;
  ElementFlags others = flags;
  others[0].flip();
  const Body part(body, flags), rest(body, others);
  EXPECT_EQ(part.lumpedMass(), body.lumpedMass());
  EXPECT_EQ(part.mesh().elementCount(), chosenElements(flags).size());
  EXPECT_NEAR(part.volume() + rest.volume(), body.volume(), 1e-12 * body.volume());
  const NodeVectors x = test::strained(body.mesh().X);
  NodeVectors f, g, whole;
  Body::Workspace workspace, workspaceOfPart, workspaceOfRest;
  part.internalForce(x, f, workspaceOfPart);
  rest.internalForce(x, g, workspaceOfRest);
  body.internalForce(x, whole, workspace);
  EXPECT_LE((f + g - whole).norm(), 1e-12 * whole.norm());
  EXPECT_LE((Eigen::MatrixXd(part.assembleTangent(x)) - test::stiffnessOf(body, x, flags, true)).norm(),
            1e-12 * part.assembleTangent(x).norm());
  ElementFlags wrong = flags;
  wrong[0].pop_back();
  EXPECT_THROW(Body(body, wrong), InputError);
}

TEST(PartOfABody, OfAMeshWithoutNumbersHasThoseOfTheWhole) {
  const Body numbered = test::sliverBody("stvk", 0.95, false);
  Mesh mesh = numbered.mesh();
  mesh.nodeIds.clear();
  for (MeshBlock& block : mesh.blocks) block.ids.clear();
  const Body whole(mesh, numbered.blocks()[0]->material());
  ElementFlags flags = noElements(mesh);
  flags[0][3] = flags[0][5] = true;
  const std::vector<std::int32_t> nodes = nodesOf(whole, flags);
  const Body part = bodyOf(whole, flags, nodes, whole.lumpedMass()(nodes)), other(whole, flags);
  for (std::int32_t i = 0; i < part.nodeCount(); ++i) EXPECT_EQ(part.mesh().nodeId(i), nodes[i]);
  for (const Body* body : {&part, &other}) {
    EXPECT_EQ(body->mesh().blocks[0].id(0), 3);
    EXPECT_EQ(body->mesh().blocks[0].id(1), 5);
  }
}

TEST(Selection, RingsOfAPartAreThoseOfTheWhole) {
  BarOptions options;
  options.cells = {6, 3, 3};
  options.jitter = 0.3;
  const Body body(generateBar(options), makeMaterial("stvk", 30e3, 0.3, 1000));
  const NodeVectors x = 1.1 * body.mesh().X;
  ElementFlags some = noElements(body.mesh());
  for (std::size_t e = 0; e < some[0].size(); e += 7) some[0][e] = true;
  // A threshold in the midst of the rings.
  const double lambda = median(ReducedRing(body).evaluate(x).largest[0]);
  const ElementFlags all = selectByReducedRing(body, x, lambda), part = selectByReducedRing(body, x, lambda, some);
  std::size_t flagged = 0;
  for (std::size_t e = 0; e < all[0].size(); ++e) {
    EXPECT_EQ(part[0][e], all[0][e] && some[0][e]);
    flagged += part[0][e];
  }
  EXPECT_GT(flagged, 5u);
  EXPECT_LT(flagged, chosenElements(some).size() - 5);
  EXPECT_TRUE(chosenElements(selectByReducedRing(body, x, lambda, noElements(body.mesh()))).empty());
}

TEST(Selection, AfterACutOnlyTheChangedElementsAreChosenAgain) {
  BarOptions options;
  options.size = {0.2, 0.05, 0.05};
  options.cells = {12, 3, 3};
  options.jitter = 0.2;
  const Mesh mesh = generateBar(options);
  const Material material = makeMaterial("corotational", 30e3, 0.3, 1000);
  const CutMesh cut = cutMesh(mesh, CutSurface::plane({0.1, 0, 0}, {1, 0.1, 0}), mesh.X, 0.01);
  for (const Selection selection : {Selection::certified, Selection::fierzRing}) {
    HandlerOptions handlerOptions;
    handlerOptions.selection = selection;
    Body before(mesh, material);
    const auto first = makeHandler("imex", before, makeIntegrator("verlet"), handlerOptions);
    const double h = 0.9 * criticalStep(before, mesh.X, 2).safe;
    first->prepare(mesh.X, h);
    Body after(cut.mesh, material), fresh(cut.mesh, material);
    const auto second = makeHandler("imex", after, makeIntegrator("verlet"), handlerOptions),
               fromScratch = makeHandler("imex", fresh, makeIntegrator("verlet"), handlerOptions);
    second->prepare(cut.mesh.X, h, cut, *first);
    fromScratch->prepare(cut.mesh.X, h);
    EXPECT_GT(second->elements().size(), first->elements().size());
    if (second->certified()) {
      EXPECT_LE(globalFrequency(second->explicitBody(), cut.mesh.X).lambda, 4 / (h * h));
    } else {
      EXPECT_EQ(second->chosen(), fromScratch->chosen());  // rings elsewhere are what they were
    }
  }
}

}  // namespace
}  // namespace ringwatch

// Local time stepping by elements: its filters, its levels against dense eigenvalues, a step against one by hand,
// stability, order, conservation, and hard bodies.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include <Eigen/Geometry>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/error.h>
#include <ringwatch/handlers/local_time_stepping/local_time_stepping.h>
#include <tests/handlers/handler_cases.h>

namespace ringwatch {
namespace {

using test::criticalStepOf;
using test::denseHighest;
using test::flat;
using ::testing::HasSubstr;

/// Without a limit on the energy that it adds: what is tested is local time stepping itself.
HandlerOptions localOptions(double dissipation, int levels = 6, bool stabilised = true) {
  return {.margin = defaultMargin,  // for every law
          .own = {{"dissipation", dissipation},
                  {"levels", levels},
                  {"variant", stabilised ? "stabilised" : "plain"},
                  {"energy_limit", 0}}};
}
std::unique_ptr<LocalTimeStepping> localTimeStepping(Body& body, double h, const HandlerOptions& options = {},
                                                     std::string_view base = "symplectic-euler") {
  auto handler = std::make_unique<LocalTimeStepping>(body, makeIntegrator(base), options);
  handler->prepare(body.mesh().X, h);
  return handler;
}
TEST(ChebyshevFilter, IsOneAtZeroAndBelowItsCeilingInItsRange) {
  for (const int p : {2, 3, 4, 8, 64})
    for (const double ceiling : {4.0, 2.5})
      for (const double share : {0.0, 0.2, 0.5, 0.8})
        for (const double weight : {1.0, 1.2, 3.0}) {
          const double c = share * ceiling;
          const ChebyshevFilter Q = chebyshevFilter(p, ceiling, c, weight, 0.05);
          EXPECT_NEAR(Q(0), 1, 1e-10) << p << " " << share;
          EXPECT_GT(Q.range, 0);
          for (int i = 0; i <= 4000; ++i) {
            const double b = Q.range * i / 4000;
            ASSERT_LE(Q(b) * (c + weight * b), ceiling * (1 + 1e-9)) << p << " " << share << " " << b;
            ASSERT_GT(Q(b), 0) << p << " " << share << " " << b;
            ASSERT_LE(Q(b), 1 + 1e-10) << p << " " << share << " " << b;
          }
          const double beyond = 1.02 * Q.range + 0.1;
          const double there = Q(beyond) * (c + weight * beyond);
          EXPECT_TRUE(there > ceiling || there < 0.05 * ceiling * 0.99) << p << " " << share;  // it could not be larger
        }
}

// p leapfrog steps from rest under z'' = -b z with the force b at the start taken as g = 1: 2 z(1)/g is Q.
TEST(ChebyshevFilter, IsLeapfrogWithoutDamping) {
  for (const int p : {2, 4, 16}) {
    const ChebyshevFilter Q = chebyshevFilter(p, 4, 0, 1, 0);
    EXPECT_NEAR(Q.range, 4.0 * p * p, 1e-9 * p * p);
    for (const double b : {0.1, 1.0, 3.0 * p}) {
      const double square = 1.0 / (p * p);
      double before = 0, z = 0.5 * square;
      for (int m = 1; m < p; ++m) {
        const double next = 2 * z - before + square * (1 - b * z);
        before = z;
        z = next;
      }
      EXPECT_NEAR(Q(b), 2 * z, 1e-12);
    }
  }
}

class AdaptiveLevels : public ::testing::TestWithParam<std::tuple<double, const char*>> {};
INSTANTIATE_TEST_SUITE_P(All, AdaptiveLevels,
                         ::testing::Combine(::testing::Values(1.5, 3.0, 10.0, 60.0),
                                            ::testing::Values("stvk", "corotational")),
                         [](const auto& test) {
                           return test::testName(std::get<0>(test.param)) + "_steps_" + std::get<1>(test.param);
                         });

TEST_P(AdaptiveLevels, AreProvenEachForItsOwnStep) {
  const auto [steps, law] = GetParam();
  for (const int deepest : {1, 6}) {
    Body body = test::sliverBody(law, 0.99);
    const double h = steps * criticalStepOf(body);
    const auto handler = localTimeStepping(body, h, localOptions(0.1, deepest));
    ASSERT_FALSE(handler->levels().empty());
    EXPECT_TRUE(handler->certified());
    ElementFlags seen = handler->implicitElements();
    double ceiling = 4;
    for (std::size_t k = 0; k < handler->levels().size(); ++k) {
      const LocalTimeStepping::Level& level = handler->levels()[k];
      const double step = h / level.substeps;
      EXPECT_LE(level.substeps, 1 << deepest);
      // What the proof of stability asks for: below G_(k+1) M, at nodes of finer elements below c_(k+1) M.
      const bool last = k + 1 == handler->levels().size();
      const double share = last ? 1 : handler->levels()[k + 1].filter.coarse / ceiling;
      EXPECT_NEAR(level.massShare, share, 1e-12);
      Eigen::VectorXd mass = body.lumpedMass();
      ElementFlags finer = handler->implicitElements();
      for (std::size_t j = k + 1; j < handler->levels().size(); ++j)
        for (const ElementRef e : chosenElements(handler->levels()[j].elements)) finer[0][e.element] = true;
      for (const ElementRef e : chosenElements(finer))
        for (const std::int32_t node : body.blocks()[0]->nodesOf(e.element))
          mass[node] = share * body.lumpedMass()[node];
      const double highest = denseHighest(body, test::stiffnessOf(body, body.mesh().X, level.elements, true), mass);
      EXPECT_LE(highest, level.lambda * (1 + 1e-9)) << k;
      EXPECT_LE(highest * step * step, ceiling * 0.81 * (1 + 1e-9)) << k;  // 0.81: the margin
      if (!last) {
        const ChebyshevFilter& filter = handler->levels()[k + 1].filter;
        EXPECT_EQ(filter.steps * level.substeps, handler->levels()[k + 1].substeps);
        EXPECT_NEAR(filter.ceiling, ceiling, 1e-12);
        ceiling = filter.range / (filter.steps * filter.steps);
      }
      for (std::size_t e = 0; e < seen[0].size(); ++e)
        if (level.elements[0][e]) {
          EXPECT_FALSE(seen[0][e]) << e;
          seen[0][e] = true;
        }
    }
    EXPECT_EQ(chosenElements(seen).size(), body.mesh().elementCount());
  }
}

// The plain variant with one level of half steps, written out with dense matrices.
TEST(LocalTimeStepping, IsLeapfrogLocalTimeSteppingWhenPlain) {
  Body body = test::sliverBody("linear", 0.9, false);
  const std::int32_t moved = test::nodeNearest(body.mesh(), {0.118, 0.02, 0.02});
  body.constraints().move(moved, 1, 0.3);
  body.addBodyForce({0, 0.5, -1});
  double h = 1.2 * criticalStepOf(body);
  const auto handler = localTimeStepping(body, h, localOptions(0, 1, false));
  ASSERT_EQ(handler->levels().size(), 2u);
  ASSERT_TRUE(chosenElements(handler->implicitElements()).empty());
  BodySystem system(body);
  test::Random random(3);
  State state = system.initialState();
  state.x += random.nodeVectors(state.x.cols(), 1e-4);
  state.v = random.nodeVectors(state.x.cols(), 0.1);
  body.constraints().imposeVelocity(state.v);
  const NodeVectors x = state.x, v = state.v;

  const Eigen::MatrixXd fine = test::stiffnessOf(body, x, handler->levels()[1].elements, true);
  const auto overMass = [&](Eigen::VectorXd f) {
    for (Eigen::Index d = 0; d < f.size(); ++d) f[d] = d == 3 * moved + 1 ? 0 : f[d] / body.lumpedMass()[d / 3];
    return f;
  };
  NodeVectors a;
  system.acceleration(0, x, v, a);
  const double square = 0.25 * h * h;
  const Eigen::VectorXd half = 0.5 * square * flat(a);
  const Eigen::VectorXd whole = 2 * half + square * (flat(a) - overMass(fine * half));
  const Eigen::VectorXd expected = 2 / (h * h) * whole;
  ASSERT_TRUE(handler->step(system, state, h).done);
  EXPECT_LE((flat(state.v - v) / h - expected).norm(), 1e-9 * expected.norm());
  EXPECT_GT((expected - flat(a)).norm(), 1e-3 * expected.norm());
}

Body smallSliverBody(std::string_view law) {
  Mesh mesh = test::gridMesh("tet4", {4, 2, 2}, {0.08, 0.04, 0.04});
  const auto node = [](int i, int j, int k) { return i + 5 * (j + 3 * k); };
  mesh.X(0, node(2, 1, 1)) += 0.98 * (mesh.X(0, node(3, 1, 1)) - mesh.X(0, node(2, 1, 1)));
  Body body(mesh, makeMaterial(law, test::young, test::poisson, test::density), {{}, Lumping::rowSum, 1});
  for (const std::int32_t n : body.mesh().nodeSets.at("x-min")) body.constraints().fix(n);
  return body;
}

TEST(LocalTimeStepping, LetsNoModeGrowAtManyTimesTheCriticalStep) {
  for (const double steps : {2.0, 3.0, 7.0})
    for (const double dissipation : {0.0, 0.1, 0.5})
      for (const int levels : {1, 6}) {  // one level: the worst elements are implicit
        Body body = smallSliverBody("linear");
        const double h = steps * criticalStepOf(body);
        const auto handler = localTimeStepping(body, h, localOptions(dissipation, levels));
        EXPECT_LE(test::spectralRadius(body, *handler, h, 1), 1 + 1e-9) << steps << " " << dissipation << " " << levels;
      }
}

double errorOf(std::string_view law, double h, const HandlerOptions& options, double nu = test::poisson) {
  return test::swingError({.law = std::string(law), .nu = nu}, 0.08, h,
                          [&](Body& body, double step) { return localTimeStepping(body, step, options, "verlet"); });
}

TEST(LocalTimeStepping, ConvergesWithSecondOrderWithoutDissipation) {
  for (const char* law : {"linear", "corotational", "stvk"}) {
    const double h = 0.08 / std::round(0.08 / (4.5 * criticalStepOf(test::sliverBody(law))));
    const double coarse = errorOf(law, h, localOptions(0)), fine = errorOf(law, h / 2, localOptions(0));
    EXPECT_GT(coarse / fine, 3) << law << " " << coarse << " " << fine;
    // Above 4: twice the step has more of its elements in finer levels, thus another error constant.
    EXPECT_LT(coarse / fine, 8) << law << " " << coarse << " " << fine;
  }
}

TEST(LocalTimeStepping, FollowsTheMotionAtFourTimesTheCriticalStep) {
  for (const char* law : {"linear", "corotational", "stvk", "neo-hookean"}) {
    Body body = test::sliverBody(law, 0.95);
    for (const int levels : {1, 6})
      for (const Selection selection : {Selection::certified, Selection::fierzRing}) {
        HandlerOptions options = localOptions(0.1, levels);
        options.selection = selection;
        EXPECT_LT(errorOf(law, 4 * criticalStepOf(body), options), 5e-3)
            << law << " " << levels << " " << selectionNames.nameOf(selection);
      }
  }
}

TEST(LocalTimeStepping, FollowsTheMotionOfANearlyIncompressibleBody) {
  Body body(test::sliverBar(0.95), makeMaterial("corotational", test::young, 0.499, test::density));
  const double h = 3 * criticalStepOf(body);
  EXPECT_LT(errorOf("corotational", h, localOptions(0.1), 0.499), 5e-3);
}

TEST(LocalTimeStepping, KeepsEnergyBoundedAndMomentumOverManySteps) {
  for (const char* law : {"corotational", "stvk"})
    for (const int levels : {1, 6}) {
      Body body = test::sliverBody(law, 0.98, false);
      const double h = 4 * criticalStepOf(body);
      const auto handler = localTimeStepping(body, h, localOptions(0.1, levels), "verlet");
      EXPECT_EQ(chosenElements(handler->implicitElements()).empty(), levels == 6);
      const test::LongRun run = test::longRun(*handler, body, h, 4000);
      ASSERT_EQ(run.steps, 4000) << law;
      EXPECT_LT(run.highestEnergy, 1.02) << law << " " << levels;
      EXPECT_GT(run.energy, 0.95) << law << " " << levels;
      EXPECT_LE(run.momentumDrift, 1e-10) << law;
      EXPECT_LE(run.angularDrift, 0.002) << law;
    }
}

TEST(LocalTimeStepping, SurvivesAStepThatIsTooLargeForEveryElement) {
  for (const int levels : {2, 6}) {  // implicit beyond the second level, and levels for all
    Body body = test::sliverBody("corotational", 0.95);
    body.addBodyForce({0, 0, -1});
    const double h = 12 * criticalStepOf(body);
    const auto handler = localTimeStepping(body, h, localOptions(0.1, levels));
    EXPECT_GT(handler->elements().size(), body.mesh().elementCount() / 2);
    EXPECT_EQ(chosenElements(handler->implicitElements()).empty(), levels == 6);
    BodySystem system(body);
    State state = system.initialState();
    for (int i = 0; i < 200; ++i) ASSERT_TRUE(handler->step(system, state, h).done);
    EXPECT_LT((state.x - body.mesh().X).cwiseAbs().maxCoeff(), 0.2);
  }
}

TEST(LocalTimeStepping, LeavesMoreRoomForALawThatStiffens) {
  for (const char* law : {"stvk", "corotational"}) {
    const Body body = test::sliverBody(law);
    const double margin = marginFor(LocalTimeStepping::description, body);
    EXPECT_EQ(margin > defaultMargin, std::string_view(law) == "stvk");
    // The default is that margin: it leaves the same elements to the explicit part.
    Body own = test::sliverBody(law, 0.98), same = test::sliverBody(law, 0.98);
    const double h = 4 * criticalStepOf(own);
    EXPECT_EQ(localTimeStepping(own, h)->elements(), localTimeStepping(same, h, {.margin = margin})->elements());
  }
}

TEST(LocalTimeStepping, CostsAnIsolatedSliverNoMoreThanItsOwnSteps) {
  Body body = test::sliverBody("stvk", 0.999);
  const double h = 30 * criticalStepOf(body);
  const auto handler = localTimeStepping(body, h, localOptions(0.1));
  const auto figures = handler->figures();
  const auto figure = [&](const std::string& name) {
    for (const HandlerFigure& f : figures)
      if (f.name == name) return f.value;
    return -1.0;
  };
  EXPECT_GT(figure("speed_up_in_evaluations"), 2);
  EXPECT_GE(figure("ideal_speed_up"), 1);
  EXPECT_EQ(figure("implicit_elements"), static_cast<double>(chosenElements(handler->implicitElements()).size()));
  double elements = figure("implicit_elements");
  for (const LocalTimeStepping::Level& level : handler->levels())
    elements += figure(joinText("elements_at_step_over_", level.substeps));
  EXPECT_EQ(elements, static_cast<double>(body.mesh().elementCount()));
}

TEST(LocalTimeStepping, LeavesASliverAloneWhoseNodesAreAllFixed) {
  Body body = test::sliverBody("stvk", 0.999);
  const double h = 0.5 * criticalStepOf(test::sliverBody("stvk", 0));
  ASSERT_FALSE(localTimeStepping(body, h)->elements().empty());
  const std::vector<ElementRef> handled = localTimeStepping(body, h)->elements();
  for (const ElementRef e : handled)
    for (const std::int32_t node : body.blocks()[0]->nodesOf(e.element)) body.constraints().fix(node);
  EXPECT_TRUE(localTimeStepping(body, h)->elements().empty());
  // Some nodes fixed: what is handled includes them.
  Body half = test::sliverBody("stvk", 0.999);
  const std::int32_t centre = half.blocks()[0]->nodesOf(localTimeStepping(half, h)->elements().front().element)[0];
  half.constraints().fix(centre);
  half.addBodyForce({0, 0, -1});
  const double step = 3 * criticalStepOf(half);
  const auto handler = localTimeStepping(half, step);
  ASSERT_FALSE(handler->elements().empty());
  BodySystem system(half);
  State state = system.initialState();
  for (int i = 0; i < 200; ++i) ASSERT_TRUE(handler->step(system, state, step).done);
  EXPECT_EQ(state.x.col(centre), half.mesh().X.col(centre));
  EXPECT_TRUE(state.x.allFinite());
}

TEST(LocalTimeStepping, SaysSoWhenAStepIsLost) {
  for (const char* law : {"stvk", "corotational", "neo-hookean"}) {
    Body body = test::sliverBody(law, 0.98);
    const double h = 4 * criticalStepOf(body);
    const auto handler = localTimeStepping(body, h, {.own = {{"energy_limit", 0}}}, "verlet");
    BodySystem system(body);
    State state = system.initialState();
    // Far beyond the certified state: a handled element is driven through itself.
    const std::int32_t node = body.blocks()[0]->nodesOf(handler->elements().front().element)[0];
    state.v.col(node) = Eigen::Vector3d(-200, 0, 0);
    bool lost = false;
    for (int i = 0; i < 300 && !lost; ++i) {
      const State before = state;
      const StepStatus status = handler->step(system, state, h);
      lost = !status.done;
      if (lost) {
        EXPECT_THAT(status.reason, HasSubstr("averaged force")) << law;
        EXPECT_EQ(state.x, before.x);
        EXPECT_EQ(state.v, before.v);
      } else {
        ASSERT_TRUE(state.x.allFinite()) << law << " " << i;
      }
    }
    state = system.initialState();
    handler->reset();
    state.x(0, node) = std::nan("");
    EXPECT_FALSE(handler->step(system, state, h).done) << law;
  }
}

// The watched body's critical step is h where the tangent of level 0 is at what its filter leaves room for.
TEST(LocalTimeStepping, WatchesTheCoarseElementsAgainstTheirOwnBound) {
  Body body = test::sliverBody("stvk", 0.98);
  const double h = 4 * criticalStepOf(body);
  const auto handler = localTimeStepping(body, h);
  const Body& watched = handler->explicitBody();
  EXPECT_EQ(watched.mesh().elementCount() + handler->elements().size(), body.mesh().elementCount());
  const double share = handler->levels()[1].filter.coarse / 4;
  EXPECT_LT(share, 1);
  std::vector<bool> beside(body.nodeCount(), false);
  for (const ElementRef e : handler->elements())
    for (const std::int32_t node : body.blocks()[0]->nodesOf(e.element)) beside[node] = true;
  for (std::int32_t i = 0; i < body.nodeCount(); ++i)
    EXPECT_NEAR(watched.lumpedMass()[i], (beside[i] ? share : 1) * body.lumpedMass()[i], 1e-12 * body.totalMass());
  EXPECT_LE(denseHighest(watched, body.mesh().X) * h * h, 4 * 0.81 * (1 + 1e-9));
  for (std::int32_t i = 0; i < body.nodeCount(); ++i)
    EXPECT_EQ(watched.constraints().freeComponents(i), body.constraints().freeComponents(i));
}

TEST(LocalTimeStepping, WorksOnMixedElements) {
  BarOptions options;
  options.size = {0.2, 0.04, 0.04};
  options.cells = {6, 2, 2};
  options.jitter = 0.2;
  Body body(generateMixedBar(options), makeMaterial("stvk", test::young, test::poisson, test::density),
            {{}, Lumping::rowSum, 1});
  body.addBodyForce({0, 0, -1});
  const double h = 2 * criticalStepOf(body);
  const auto handler = localTimeStepping(body, h);
  ASSERT_FALSE(handler->elements().empty());
  BodySystem system(body);
  State state = system.initialState();
  for (int i = 0; i < 200; ++i) ASSERT_TRUE(handler->step(system, state, h).done);
  const Eigen::Vector3d fallen =
      (state.x - body.mesh().X) * body.lumpedMass() / body.totalMass();  // free: its centre falls as a point does
  EXPECT_NEAR(fallen.z(), -0.5 * 200 * 201 * h * h, 1e-9 * std::abs(fallen.z()) + 1e-12);
}

TEST(LocalTimeStepping, RefusesDamping) {
  Body body = test::sliverBody();
  const double h = 4 * criticalStepOf(body);
  const auto handler = localTimeStepping(body, h);
  BodySystem damped(body, {0.1, 0});
  State state = damped.initialState();
  EXPECT_THROW(handler->step(damped, state, h), InputError);
}

}  // namespace
}  // namespace ringwatch

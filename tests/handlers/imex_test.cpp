// Implicit-explicit by elements: the step against dense solves, its stability, order, and long runs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include <Eigen/Geometry>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/error.h>
#include <ringwatch/handlers/imex/imex.h>
#include <tests/handlers/handler_cases.h>

namespace ringwatch {
namespace {

using test::criticalStepOf;
using test::denseHighest;
using test::flat;
using ::testing::HasSubstr;

std::unique_ptr<Handler> imex(Body& body, double h, const HandlerOptions& options = {},
                              std::string_view base = "symplectic-euler") {
  auto handler = makeHandler("imex", body, makeIntegrator(base), options);
  handler->prepare(body.mesh().X, h);
  return handler;
}
/// Linear equations.
HandlerOptions withDissipation(double alpha, ClusterSolver solver = ClusterSolver::automatic) {
  const std::string_view name = solver == ClusterSolver::automatic ? Imex::linear : clusterSolverNames.nameOf(solver);
  return {.own = {{"dissipation", alpha}, {"solver", name}}};
}

struct StepCase {
  double alpha;
  ClusterSolver solver;
  double steps;  // of the critical one: small clusters, and one larger than a dense inverse is made for
  int held;      // 0: nothing, 1: some nodes of handled elements fixed, 2: also moved
};
class ImexStep : public ::testing::TestWithParam<StepCase> {};
INSTANTIATE_TEST_SUITE_P(
    All, ImexStep, ::testing::ValuesIn([] {
      std::vector<StepCase> cases;
      for (const double alpha : {0.0, 0.3, 1.0})
        for (const ClusterSolver solver : {ClusterSolver::cholesky, ClusterSolver::conjugateGradients})
          for (const double steps : {2.0, 30.0})
            for (const int held : {0, 1, 2}) cases.push_back({alpha, solver, steps, held});
      return cases;
    }()),
    [](const auto& test) {
      const StepCase& c = test.param;
      return "alpha_" + test::testName(c.alpha) + (c.solver == ClusterSolver::cholesky ? "_cholesky_" : "_cg_") +
             test::testName(c.steps) + "_steps" +
             (c.held == 0   ? "_free"
              : c.held == 1 ? "_fixed"
                            : "_moved");
    });

// For the linear law K̂ is the very stiffness of the handled elements.
TEST_P(ImexStep, IsThatOfADenseSolve) {
  const StepCase c = GetParam();
  Body body = test::sliverBody("linear", 0.98, false);
  const std::int32_t moved = test::nodeNearest(body.mesh(), {0.118, 0.02, 0.02});
  if (c.held >= 1) body.constraints().fix(test::nodeNearest(body.mesh(), {0.1, 0.02, 0.0}));
  if (c.held >= 2) body.constraints().move(moved, 1, 0.3);
  body.addBodyForce({0, 0.5, -1});
  const double h = c.steps * criticalStepOf(body);
  HandlerOptions options = withDissipation(c.alpha, c.solver);
  if (c.solver != ClusterSolver::cholesky) options.own.set("tolerance", 1e-13).set("iterations", 2000);
  const auto handler = imex(body, h, options);
  ASSERT_FALSE(handler->elements().empty());

  BodySystem system(body);
  State state = system.initialState();
  test::Random random(3);
  state.x += random.nodeVectors(state.x.cols(), 1e-4);
  NodeVectors v = random.nodeVectors(state.x.cols(), 0.1);
  state.v = v;
  body.constraints().imposeVelocity(state.v);
  v = state.v;
  const NodeVectors x = state.x;

  ElementFlags flags = noElements(body.mesh());
  for (const ElementRef e : handler->elements()) flags[e.block][e.element] = true;
  const Eigen::MatrixXd K = test::stiffnessOf(body, body.mesh().X, flags, true);
  const double beta = 0.25 * (1 + c.alpha) * (1 + c.alpha);
  Eigen::MatrixXd A = beta * h * h * K;
  for (Eigen::Index d = 0; d < A.rows(); ++d) A(d, d) += body.lumpedMass()[d / 3];
  Body::Workspace workspace;
  NodeVectors f;
  body.internalForce(x, f, workspace);
  Eigen::VectorXd right = flat(body.externalForce() - f) - c.alpha * h * K * flat(v);
  for (Eigen::Index d = 0; d < A.rows(); ++d)
    if (body.constraints().isConstrained(d / 3, static_cast<int>(d % 3))) {
      A.row(d).setZero();
      A.col(d).setZero();
      A(d, d) = 1;
      right[d] = 0;
    }
  const Eigen::VectorXd a = test::solve(A, right);

  ASSERT_TRUE(handler->step(system, state, h).done);
  EXPECT_LE((flat(state.v - v) / h - a).norm(), 1e-8 * a.norm());
  EXPECT_LE((state.x - x - h * state.v).norm(), 1e-14 * x.norm());
}

class ImexStability : public ::testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(All, ImexStability, ::testing::Values(0.0, 0.3, 1.0),
                         [](const auto& test) { return "alpha_" + test::testName(test.param); });

// The amplification matrix of the whole linear body, column by column from the program's own steps.
TEST_P(ImexStability, NoModeGrowsAtManyTimesTheCriticalStep) {
  Body body = test::sliverBody("linear", 0.98);
  const double h = 4 * criticalStepOf(body);
  const auto handler = imex(body, h, withDissipation(GetParam()));
  EXPECT_LE(test::spectralRadius(body, *handler, h, 1e-3), 1 + 1e-6);
  const auto plain = makeIntegrator("symplectic-euler");
  EXPECT_GT(test::spectralRadius(body, *plain, h, 1e-3), 2);  // so the test can fail
}

double errorOf(std::string_view law, double alpha, double h, std::string_view base, bool keepAll = true) {
  return test::swingError({.law = std::string(law)}, 0.08, h, [&](Body& body, double step) {
    auto handler = makeHandler("imex", body, makeIntegrator(base), withDissipation(alpha));
    // The elements of the largest step stay handled at all others, so that one scheme is compared with itself.
    if (keepAll) handler->prepare(body.mesh().X, 4 * criticalStepOf(body));
    handler->prepare(body.mesh().X, step);
    return handler;
  });
}

TEST(Imex, ConvergesWithSecondOrderWithoutDissipation) {
  for (const char* law : {"linear", "corotational", "stvk"}) {
    const double h = 0.08 / 250;
    const double coarse = errorOf(law, 0, h, "verlet"), fine = errorOf(law, 0, h / 2, "verlet");
    EXPECT_GT(coarse / fine, 3) << law << " " << coarse << " " << fine;
  }
}

TEST(Imex, ConvergesWithFirstOrderAsImplicitEuler) {
  const double h = 0.08 / 400;
  const double coarse = errorOf("linear", 1, h, "verlet"), fine = errorOf("linear", 1, h / 2, "verlet");
  EXPECT_GT(coarse / fine, 1.6);
  EXPECT_LT(errorOf("linear", 0, h, "verlet"), coarse);
}

TEST(Imex, FollowsTheMotionAtFourTimesTheCriticalStep) {
  for (const char* law : {"linear", "corotational", "stvk", "neo-hookean"}) {
    Body body = test::sliverBody(law, 0.95);
    EXPECT_LT(errorOf(law, 0.3, 4 * criticalStepOf(body), "verlet", false), 0.01) << law;
  }
}

TEST(Imex, KeepsEnergyBoundedAndMomentumOverManySteps) {
  for (const char* law : {"corotational", "stvk"})
    for (const double alpha : {0.0, 0.3}) {
      Body body = test::sliverBody(law, 0.98, false);
      const double h = 4 * criticalStepOf(body);
      const auto handler = imex(body, h, withDissipation(alpha), "verlet");
      const test::LongRun run = test::longRun(*handler, body, h, 4000);
      ASSERT_EQ(run.steps, 4000) << law;
      EXPECT_LT(run.highestEnergy, 1.02) << law << " " << alpha;
      EXPECT_GT(run.energy, 0.9) << law << " " << alpha;
      EXPECT_LE(run.momentumDrift, 1e-10) << law;  // exact: K̂ has translations as null space
      EXPECT_LE(run.angularDrift, 0.01) << law;    // not exact: K̂ knows rotations at rest only
    }
}

TEST(Imex, SaysSoWhenConjugateGradientsDoNotConverge) {
  Body body = test::sliverBody("stvk", 0.98);
  body.addBodyForce({0, 0, -1});
  const double h = 8 * criticalStepOf(body);
  HandlerOptions options = withDissipation(0, ClusterSolver::conjugateGradients);
  options.own.set("iterations", 1).set("energy_limit", 0);
  for (const char* base : {"symplectic-euler", "verlet"}) {
    const auto handler = imex(body, h, options, base);
    BodySystem system(body);
    State state = system.initialState();
    const State before = state;
    const StepStatus status = handler->step(system, state, h);
    EXPECT_FALSE(status.done);
    EXPECT_THAT(status.reason, HasSubstr("conjugate gradients did not converge"));
    EXPECT_EQ(state.x, before.x);
    EXPECT_EQ(state.v, before.v);
    EXPECT_EQ(state.time, before.time);
  }
}

TEST(Imex, SurvivesAStepThatMakesEverythingImplicit) {
  Body body = test::sliverBody("corotational", 0.98);
  body.addBodyForce({0, 0, -1});
  const double h = 200 * criticalStepOf(body);
  const auto handler = imex(body, h, withDissipation(1));
  EXPECT_EQ(handler->elements().size(), body.mesh().elementCount());
  BodySystem system(body);
  State state = system.initialState();
  for (int i = 0; i < 200; ++i) ASSERT_TRUE(handler->step(system, state, h).done);
  EXPECT_TRUE(state.x.allFinite());
  EXPECT_LT((state.x - body.mesh().X).cwiseAbs().maxCoeff(), 0.2);
}

TEST(Imex, DoesNotPassNotANumberOn) {
  Body body = test::sliverBody("stvk", 0.98);
  const double h = 4 * criticalStepOf(body);
  const auto handler = imex(body, h);
  BodySystem system(body);
  State state = system.initialState();
  const std::int32_t node = body.blocks()[0]->nodesOf(handler->elements().front().element)[0];
  state.x(0, node) = std::nan("");
  EXPECT_FALSE(handler->step(system, state, h).done);
}

TEST(Imex, WatchesTheExplicitElementsUnderTheirOwnNumbers) {
  Body body = test::sliverBody("stvk", 0.98);
  const auto handler = imex(body, 4 * criticalStepOf(body));
  const Body& rest = handler->explicitBody();
  EXPECT_EQ(rest.mesh().elementCount() + handler->elements().size(), body.mesh().elementCount());
  EXPECT_LE(denseHighest(rest, body.mesh().X), denseHighest(body, body.mesh().X) / 16);
  for (std::int32_t e = 0; e < rest.blocks()[0]->elementCount(); ++e) {
    const auto own = rest.blocks()[0]->nodesOf(e),
               whole = body.blocks()[0]->nodesOf(handler->toParentElement({0, e}).element);
    ASSERT_TRUE(std::equal(own.begin(), own.end(), whole.begin()));
  }
}

TEST(Clusters, ArePartsThatShareNoNode) {
  const Body body = test::sliverBody();
  test::Random random(9);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<ElementRef> elements;
    for (std::int32_t e = 0; e < body.blocks()[0]->elementCount(); ++e)
      if (random.uniform(0, 1) < 0.01 * trial) elements.push_back({0, e});
    const auto clusters = clustersOf(body, elements);
    std::vector<ElementRef> all;
    std::vector<int> owner(body.nodeCount(), -1);
    for (std::size_t k = 0; k < clusters.size(); ++k) {
      // Connected: grows from its first element to all of it.
      std::set<std::int32_t> reached;
      std::size_t taken = 0;
      std::vector<bool> in(clusters[k].size(), false);
      for (bool grown = true; grown;) {
        grown = false;
        for (std::size_t i = 0; i < clusters[k].size(); ++i) {
          if (in[i]) continue;
          const auto nodes = body.blocks()[0]->nodesOf(clusters[k][i].element);
          const bool touches =
              std::any_of(nodes.begin(), nodes.end(), [&](std::int32_t n) { return reached.count(n) != 0; });
          if (!reached.empty() && !touches) continue;
          reached.insert(nodes.begin(), nodes.end());
          in[i] = grown = true;
          ++taken;
        }
      }
      EXPECT_EQ(taken, clusters[k].size());
      for (const std::int32_t node : reached) {
        EXPECT_EQ(owner[node], -1);
        owner[node] = static_cast<int>(k);
      }
      all.insert(all.end(), clusters[k].begin(), clusters[k].end());
    }
    std::sort(all.begin(), all.end());
    EXPECT_EQ(all, elements);
  }
}

}  // namespace
}  // namespace ringwatch

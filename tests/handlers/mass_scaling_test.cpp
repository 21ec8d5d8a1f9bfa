// Mass scaling: the proof of the step, the mass it costs, and what that does to slow motion.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <ringwatch/base/error.h>
#include <ringwatch/handlers/mass_scaling/lowest_frequencies.h>
#include <ringwatch/handlers/mass_scaling/mass_scaling.h>
#include <tests/handlers/handler_cases.h>

namespace ringwatch {
namespace {

using test::denseHighest;
using ::testing::HasSubstr;

double figure(const Handler& handler, const std::string& name) {
  for (const HandlerFigure& f : handler.figures())
    if (f.name == name) return f.value;
  ADD_FAILURE() << "no figure " << name;
  return 0;
}

TEST(MassScaling, BringsTheHighestFrequencyDownToTheStep) {
  Body body = test::sliverBody("stvk", 0.98);
  const NodeVectors& X = body.mesh().X;
  const double before = denseHighest(body, X), h = 2.7 * 2 / std::sqrt(before), mass = body.totalMass();
  const Eigen::VectorXd own = body.lumpedMass();
  const auto handler = makeHandler("mass-scaling", body, makeIntegrator("symplectic-euler"));
  handler->prepare(X, h);
  EXPECT_TRUE(handler->certified());
  EXPECT_LE(denseHighest(body, X), 4 / (h * h));
  // Little of it: only where slivers are.
  const double added = body.totalMass() - mass;
  EXPECT_GT(added, 0);
  EXPECT_NEAR(figure(*handler, "added_mass_kg"), added, 1e-12 * mass);
  EXPECT_NEAR(figure(*handler, "added_mass_percent"), 100 * added / mass, 1e-9);
  EXPECT_TRUE(((body.lumpedMass() - own).array() >= 0).all());
  EXPECT_LT((body.lumpedMass().array() > own.array()).count(), body.nodeCount() / 2);
}

TEST(MassScaling, ReportsTheShiftOfTheLowestFrequencies) {
  Body body = test::sliverBody("linear", 0.98);
  const NodeVectors& X = body.mesh().X;
  const Eigen::VectorXd own = body.lumpedMass();
  const double h = 6 * 2 / std::sqrt(denseHighest(body, X));
  const auto handler = makeHandler("mass-scaling", body, makeIntegrator("verlet"));
  handler->prepare(X, h);
  // Against a dense generalised eigenvalue problem.
  std::vector<Eigen::Index> free;
  for (Eigen::Index d = 0; d < 3 * body.nodeCount(); ++d)
    if (!body.constraints().isConstrained(d / 3, static_cast<int>(d % 3))) free.push_back(d);
  const Eigen::MatrixXd K = Eigen::MatrixXd(body.assembleTangent(X))(free, free);
  const auto lowest = [&](const Eigen::VectorXd& mass) {
    Eigen::VectorXd m(free.size());
    for (std::size_t i = 0; i < free.size(); ++i) m[i] = mass[free[i] / 3];
    const Eigen::MatrixXd M = m.asDiagonal();
    return std::sqrt(test::generalizedEigen(K, M).values[0]) / (2 * std::numbers::pi);
  };
  const double without = lowest(own), with = lowest(body.lumpedMass());
  EXPECT_LT(with, without);
  EXPECT_NEAR(figure(*handler, "frequency_1_Hz"), without, 1e-7 * without);
  EXPECT_NEAR(figure(*handler, "frequency_1_with_added_mass_Hz"), with, 1e-7 * with);
  EXPECT_NEAR(figure(*handler, "frequency_1_shift_percent"), 100 * (with / without - 1), 1e-5);
}

TEST(MassScaling, RunsStableAtAStepThatPlainExplicitCannotTake) {
  const auto run = [](bool scaled) {
    Body body = test::sliverBody("corotational", 0.98);
    body.addBodyForce({0, 0, -1});
    const double h = 4 * 2 / std::sqrt(denseHighest(body, body.mesh().X));
    std::unique_ptr<Integrator> integrator = makeIntegrator("symplectic-euler");
    if (scaled) {
      auto handler = makeHandler("mass-scaling", body, std::move(integrator));
      handler->prepare(body.mesh().X, h);
      integrator = std::move(handler);
    }
    BodySystem system(body);
    State state = system.initialState();
    for (int i = 0; i < 2000; ++i)
      if (!integrator->step(system, state, h).done || !(state.x.array().abs().maxCoeff() < 1)) return false;
    return true;
  };
  EXPECT_FALSE(run(false));
  EXPECT_TRUE(run(true));
}

// Mass in flight brings energy: along a run steps are divided instead.
TEST(MassScaling, DividesStepsWhereElementsHaveStiffened) {
  Body body = test::sliverBody("stvk", 0.98);
  const NodeVectors& X = body.mesh().X;
  const double h = 3 * 2 / std::sqrt(denseHighest(body, X));
  MassScaling handler(body, makeIntegrator("symplectic-euler"), {});
  handler.prepare(X, h);
  EXPECT_EQ(handler.parts(), 1);
  EXPECT_EQ(&handler.explicitBody(), &body);
  const Eigen::VectorXd mass = body.lumpedMass();
  NodeVectors stretched = X;
  stretched.row(0) *= 1.8;
  ASSERT_GT(denseHighest(body, stretched), 4 / (h * h));
  handler.prepare(stretched, h);
  EXPECT_EQ(body.lumpedMass(), mass);
  const int parts = handler.parts();
  ASSERT_GT(parts, 1);
  EXPECT_TRUE(handler.certified());
  // Half of the step that is proven, which by a twelfth or so is less than the critical one.
  const double part = h / parts;
  EXPECT_LE(denseHighest(body, stretched), 1 / (part * part));
  EXPECT_GE(denseHighest(body, stretched), 0.25 / (part * part));
  // The proof for the masses that a monitor gets is one for the parts: Theorem 86.
  EXPECT_NEAR(denseHighest(handler.explicitBody(), stretched) * parts * parts, denseHighest(body, stretched),
              1e-9 * denseHighest(body, stretched));
  BodySystem system(body);
  State divided = system.initialState(), alone = divided;
  divided.x = alone.x = stretched;
  const auto euler = makeIntegrator("symplectic-euler");
  ASSERT_TRUE(handler.step(system, divided, h).done);
  // Velocities of the run before were half a step h behind.
  NodeVectors a;
  system.acceleration(0, alone.x, alone.v, a);
  alone.v += 0.5 * (h - part) * a;
  for (int k = 0; k < parts; ++k) euler->step(system, alone, part);
  EXPECT_LE((divided.x - alone.x).norm(), 1e-14 * alone.x.norm());
  EXPECT_LE((divided.v - alone.v).norm(), 1e-12 * alone.v.norm());
  // After a while it asks whether fewer do, and at rest two do: one, of all that is proven, is not tried again.
  int steps = 1;
  while (!handler.asksForChoice()) {
    ASSERT_TRUE(handler.step(system, divided, h).done);
    ASSERT_LT(++steps, 1000);
  }
  EXPECT_GE(steps * parts, 500);
  handler.prepare(X, h);
  EXPECT_EQ(handler.parts(), 2);
}

// Velocities of symplectic Euler are those half a step ago. With a step that changes, a body that falls stays on its
// parabola only where they are moved to half of the new step.
TEST(MassScaling, FallsFreelyThroughChangesOfItsParts) {
  Body body = test::sliverBody("corotational", 0.98, false);
  const Eigen::Vector3d g(0, 0, -9.81);
  body.addBodyForce(g);
  const NodeVectors X = body.mesh().X;
  const double h = 3 * 2 / std::sqrt(denseHighest(body, X));
  MassScaling handler(body, makeIntegrator("symplectic-euler"), {});
  handler.prepare(X, h);
  // Loads stay what they are: those of the masses before.
  const Eigen::Vector3d fall = body.externalForce().rowwise().sum() / body.totalMass();
  BodySystem system(body);
  State state = system.initialState();
  const Eigen::VectorXd share = body.lumpedMass() / body.totalMass();
  const Eigen::Vector3d start = state.x * share;
  int changes = 0, before = 1;
  double now = h, t = 0;
  for (int step = 0; step < 40; ++step) {
    if (step % 10 == 5) handler.prepare(state.x, now);           // a second choice for a step has a reason to divide it
    if (step % 10 == 9) handler.prepare(state.x, now *= 0.999);  // the first for another step has none
    changes += handler.parts() != before ? 1 : 0;
    before = handler.parts();
    ASSERT_TRUE(handler.step(system, state, now).done);
    t += now;
    // The first kick is a whole one.
    const Eigen::Vector3d there = start + 0.5 * t * (t + h) * fall;
    EXPECT_LE((state.x * share - there).norm(), 1e-12 * there.norm()) << step;
  }
  EXPECT_GE(changes, 7);
}

TEST(MassScaling, DividesAStepThatWouldInvertALawThatHasNoEnergyThere) {
  const auto least = [](const char* law, std::int64_t* divided) {
    Body body = test::sliverBody(law, 0.98, false);
    const NodeVectors& X = body.mesh().X;
    const double h = 4 * 2 / std::sqrt(denseHighest(body, X));
    const auto handler = makeHandler("mass-scaling", body, makeIntegrator("symplectic-euler"));
    handler->prepare(X, h);
    BodySystem system(body);
    State state = system.initialState();
    // The halves fly against each other, faster than a sliver is thick in a step.
    for (std::int32_t i = 0; i < body.nodeCount(); ++i) state.v(0, i) = X(0, i) < 0.1198 ? 1 : -1;
    double result = 1;
    for (int step = 0; step < 5; ++step) {
      EXPECT_TRUE(handler->step(system, state, h).done);
      for (const ElementRef e : handler->elements()) {
        const auto nodes = body.blocks()[e.block]->nodesOf(e.element);
        const auto volume = [&](const NodeVectors& x) {
          Eigen::Matrix3d edges;
          for (int k = 0; k < 3; ++k) edges.col(k) = x.col(nodes[k + 1]) - x.col(nodes[0]);
          return edges.determinant();
        };
        result = std::min(result, volume(state.x) / volume(X));
      }
    }
    *divided = static_cast<std::int64_t>(figure(*handler, "divided_steps"));
    return result;
  };
  std::int64_t divided = 0;
  EXPECT_LT(least("stable-neo-hookean", &divided), 0);  // it has an energy there
  EXPECT_EQ(divided, 0);
  EXPECT_GT(least("neo-hookean", &divided), 0);
  EXPECT_GT(divided, 0);
}

TEST(MassScaling, TakesNothingAndChangesNothingWhereTheStepIsFine) {
  Body body = test::sliverBody(), plain = test::sliverBody();
  body.addBodyForce({0, 0, -1});
  plain.addBodyForce({0, 0, -1});
  const double h = 0.75 * 2 / std::sqrt(denseHighest(body, body.mesh().X));
  const auto handler = makeHandler("mass-scaling", body, makeIntegrator("verlet"));
  handler->prepare(body.mesh().X, h);
  EXPECT_TRUE(handler->elements().empty());
  EXPECT_EQ(body.lumpedMass(), plain.lumpedMass());
  const auto verlet = makeIntegrator("verlet");
  BodySystem a(body), b(plain);
  State with = a.initialState(), without = b.initialState();
  for (int i = 0; i < 50; ++i) {
    handler->step(a, with, h);
    verlet->step(b, without, h);
  }
  EXPECT_EQ(with.x, without.x);
  EXPECT_EQ(with.v, without.v);
}

TEST(Handlers, RefuseWhatTheyCannotDo) {
  Body body = test::sliverBody();
  const auto refusal = [&](const auto& act) -> std::string {
    try {
      act();
    } catch (const InputError& fault) {
      return fault.what();
    }
    return "";
  };
  EXPECT_THAT(refusal([&] { makeHandler("magic", body, makeIntegrator("verlet")); }), HasSubstr("mass-scaling"));
  EXPECT_THAT(refusal([&] { makeHandler("mass-scaling", body, makeIntegrator("rk4")); }), HasSubstr("rk4"));
  EXPECT_THAT(refusal([&] {
                makeHandler("mass-scaling", body, makeIntegrator("verlet"), {.selection = Selection::fierzRing});
              }),
              HasSubstr("certified"));
  EXPECT_THAT(refusal([&] { makeHandler("mass-scaling", body, makeIntegrator("verlet"))->prepare(body.mesh().X, 0); }),
              HasSubstr("must be > 0"));
  EXPECT_THAT(refusal([&] { body.addNodalMass(-1, 1); }), HasSubstr("node -1"));
  EXPECT_THAT(refusal([&] { body.addNodalMass(0, -1); }), HasSubstr("-1 kg"));
}

}  // namespace
}  // namespace ringwatch

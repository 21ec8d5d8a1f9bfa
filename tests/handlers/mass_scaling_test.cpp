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

TEST(MassScaling, TakesNothingAndChangesNothingWhereTheStepIsFine) {
  Body body = test::sliverBody(), plain = test::sliverBody();
  body.addBodyForce({0, 0, -1});
  plain.addBodyForce({0, 0, -1});
  const double h = 0.8 * 2 / std::sqrt(denseHighest(body, body.mesh().X));
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

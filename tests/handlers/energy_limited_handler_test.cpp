// Handled elements that add energy, or would invert a law that has no energy there: imex takes them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <ringwatch/base/infinity.h>
#include <ringwatch/handlers/imex/imex.h>
#include <ringwatch/meshes/modify/cut.h>
#include <tests/handlers/handler_cases.h>

namespace ringwatch {
namespace {

using test::criticalStepOf;
using ::testing::HasSubstr;

struct Scheme {
  const char* handler;
  const char* steps;  // the figure that counts those that imex has taken
  double rate;        // 1/s, at which it adds energy to a bar that is drawn out
  Options own = {};
  Scheme with(const Options& more) const {
    Scheme result = *this;
    for (const auto& [name, value] : more) result.own.set(name, value);
    return result;
  }
};

class EnergyLimitedHandlers : public ::testing::TestWithParam<Scheme> {
 protected:
  /// A free bar of which every element is handled in steps of 20 times the critical one, as it begins to be drawn out
  /// or pushed together at `rate`, 1/s.
  struct Drawn {
    Drawn(const Scheme& scheme, const char* law, double rate) : body(test::sliverBody(law, 0.95, false)), system(body) {
      h = 20 * criticalStepOf(body);
      handler = makeHandler(scheme.handler, body, makeIntegrator("symplectic-euler"), {.own = scheme.own});
      handler->prepare(body.mesh().X, h);
      EXPECT_EQ(handler->elements().size(), body.mesh().elementCount());
      state = system.initialState();
      state.v.row(0) = rate * (state.x.row(0).array() - 0.1).matrix();
    }
    /// Half way between two steps, J.
    double energy() {
      return 0.5 * (state.v * body.lumpedMass().asDiagonal()).cwiseProduct(state.v).sum() +
             body.energy(state.x - 0.5 * h * state.v, workspace);
    }
    /// Until a figure is no longer 0.
    void stepUntil(const std::string& name) {
      for (int step = 0; figure(name) == 0; ++step) {
        ASSERT_LT(step, 500);
        ASSERT_TRUE(handler->step(system, state, h).done);
      }
    }
    double figure(const std::string& name) const {
      for (const HandlerFigure& f : handler->figures())
        if (f.name == name) return f.value;
      return NAN;
    }
    Body body;
    BodySystem system;
    Body::Workspace workspace;
    std::unique_ptr<Handler> handler;
    double h;
    State state;
  };
};
INSTANTIATE_TEST_SUITE_P(All, EnergyLimitedHandlers,
                         ::testing::Values(Scheme{"fe-pbd", "implicit_steps", 2},
                                           Scheme{"modal-filter", "implicit_steps", 2},
                                           Scheme{"local-time-stepping", "implicit_steps", 20},
                                           Scheme{"imex", "nonlinear_steps", 20, {{"solver", Imex::linear}}}),
                         [](const auto& test) { return test::testName(std::string_view(test.param.handler)); });

TEST_P(EnergyLimitedHandlers, AddLittleEnergyBeforeTheyAreImplicit) {
  const auto rise = [](Drawn& bar) {
    const double first = bar.energy();
    double most = first;
    for (int step = 0; step < 60; ++step) {
      if (!bar.handler->step(bar.system, bar.state, bar.h).done) return infinity;
      most = std::max(most, bar.energy());
    }
    return most / first - 1;
  };
  Drawn unlimited(GetParam().with({{"energy_limit", 0}}), "stvk", GetParam().rate),
      limited(GetParam(), "stvk", GetParam().rate);
  const double without = rise(unlimited), with = rise(limited);
  EXPECT_GT(without, 0.03);  // or it is lost
  EXPECT_LT(with, 0.01);
  EXPECT_EQ(unlimited.figure(GetParam().steps), 0);
  EXPECT_GT(limited.figure(GetParam().steps), 30);
  EXPECT_THAT(limited.handler->news(), HasSubstr("imex takes them from here on"));
  EXPECT_EQ(limited.handler->news(), "");
  EXPECT_TRUE(limited.handler->provesHandledPart());
}

TEST_P(EnergyLimitedHandlers, AreImexFromThereOn) {
  Drawn bar(GetParam(), "corotational", GetParam().rate);
  bar.stepUntil(GetParam().steps);
  // Without the solutions of the last two steps, which a search begins with.
  bar.handler->prepare(bar.state.x, bar.h);
  Imex imex(bar.body, makeIntegrator("symplectic-euler"), {});
  imex.prepareAs(*bar.handler, bar.state.x);
  State other = bar.state;
  for (int step = 0; step < 5; ++step) {
    ASSERT_TRUE(bar.handler->step(bar.system, bar.state, bar.h).done);
    ASSERT_TRUE(imex.step(bar.system, other, bar.h).done);
    EXPECT_EQ(bar.state.x, other.x);
    EXPECT_EQ(bar.state.v, other.v);
  }
}

TEST_P(EnergyLimitedHandlers, StayImplicitAfterACut) {
  Drawn bar(GetParam(), "corotational", GetParam().rate);
  bar.stepUntil(GetParam().steps);
  const Mesh& mesh = bar.body.mesh();
  const CutMesh cut = cutMesh(mesh, CutSurface::plane({0.11, 0, 0}, {1, 0.2, 0.1}), mesh.X, 0.02);
  Body after(cut.mesh, makeMaterial("corotational", test::young, test::poisson, test::density));
  const auto handler =
      makeHandler(GetParam().handler, after, makeIntegrator("symplectic-euler"), {.own = GetParam().own});
  handler->prepare(cut.mesh.X, bar.h, cut, *bar.handler);
  EXPECT_TRUE(handler->provesHandledPart());
  BodySystem system(after);
  State state = system.initialState();
  state.v.row(0) = 2 * state.x.row(0);
  ASSERT_TRUE(handler->step(system, state, bar.h).done);
  const std::vector<HandlerFigure> figures = handler->figures();
  const auto steps = std::ranges::find(figures, std::string(GetParam().steps), &HandlerFigure::name);
  ASSERT_NE(steps, figures.end());
  EXPECT_EQ(steps->value, bar.figure(GetParam().steps) + 1);
}

// Neo-Hookean elements have no energy beyond inversion: Theorem 69 takes over from the step that would end there.
TEST_P(EnergyLimitedHandlers, DoNotInvertALawThatHasNoEnergyThere) {
  const auto least = [](Drawn& bar) {
    double result = 1;
    for (int step = 0; step < 30; ++step) {
      if (!bar.handler->step(bar.system, bar.state, bar.h).done) return -1.0;
      result = std::min(result, bar.handler->leastHandledDeterminant(bar.state.x)->value);
    }
    return result;
  };
  Drawn unlimited(GetParam().with({{"energy_limit", 0}}), "neo-hookean", -40), limited(GetParam(), "neo-hookean", -40);
  EXPECT_LE(least(unlimited), 0);
  EXPECT_GT(least(limited), 0);
}

}  // namespace
}  // namespace ringwatch

// The stability monitor: verdicts, events, options, and what it says along a nonlinear run.
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <memory>

#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/integrators/symplectic_euler.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <ringwatch/monitor/energy_balance.h>
#include <ringwatch/monitor/stability_monitor.h>
#include <tests/monitor/monitor_cases.h>

namespace ringwatch {
namespace {

using test::DenseTangent;
using test::Subdivision;

NodeVectors noVelocity(const Body& body) { return NodeVectors::Zero(3, body.nodeCount()); }

/// The only event of that kind so far.
const MonitorEvent& onlyEvent(const StabilityMonitor& monitor, EventKind kind) {
  const MonitorEvent* found = nullptr;
  for (const MonitorEvent& event : monitor.events()) {
    if (event.kind != kind) continue;
    EXPECT_EQ(found, nullptr) << "reported twice: " << eventName(kind);
    found = &event;
  }
  if (!found) throw std::runtime_error(joinText("no event ", eventName(kind)));
  return *found;
}
int countEvents(const StabilityMonitor& monitor, EventKind kind) {
  int count = 0;
  for (const MonitorEvent& event : monitor.events()) count += event.kind == kind;
  return count;
}
void expectText(const Body& body, const MonitorEvent& event, const std::vector<std::string>& parts) {
  const std::string text = eventText(event, body.mesh());
  for (const std::string& part : parts)
    EXPECT_NE(text.find(part), std::string::npos) << '"' << text << "\" lacks \"" << part << '"';
  EXPECT_EQ(text.find('\n'), std::string::npos);
}

const MonitorOptions unlimited{.budget = infinity};

TEST(StabilityMonitor, ChecksAStepByTheBracket) {
  for (const Subdivision& subdivision : test::allSubdivisions()) {
    const Body body = test::boxBody(subdivision, "stvk");
    const NodeVectors& X = body.mesh().X;
    MonitorOptions options;
    options.firstObservationElements = 0;  // a step between the sides would get a better proof
    StabilityMonitor first(body, options);
    const CriticalStep step = *first.observe(0, 0, X, noVelocity(body), std::nullopt).bracket;
    const double exact = 2 / std::sqrt(globalFrequency(body, X).lambda);
    EXPECT_LE(step.safe, exact) << subdivision.name;
    EXPECT_GE(step.optimistic, exact * (1 - 1e-9)) << subdivision.name;
    const struct {
      double h;
      Verdict verdict;
    } cases[] = {{0.99 * step.safe, Verdict::certified},
                 {step.safe, Verdict::certified},
                 {0.5 * (step.safe + exact), Verdict::notCertified},
                 {1.01 * step.optimistic, Verdict::violated}};
    for (const auto& c : cases) {
      StabilityMonitor monitor(body, options);
      const MonitorReport& report = monitor.observe(7, 0.25, X, noVelocity(body), c.h);
      EXPECT_EQ(report.step, 7);
      EXPECT_EQ(report.time, 0.25);
      EXPECT_EQ(report.h, c.h);
      EXPECT_TRUE(report.fresh);
      ASSERT_TRUE(report.bracket);
      EXPECT_GE(report.bracket->safe, std::min(c.h, step.safe));
      EXPECT_LE(report.bracket->safe, step.safe);
      EXPECT_LE(report.bracket->optimistic, step.optimistic);  // examined closer when h comes near it
      EXPECT_EQ(report.verdict, c.verdict) << subdivision.name << ", h = " << c.h;
      EXPECT_EQ(countEvents(monitor, EventKind::violated), c.verdict == Verdict::violated);
      EXPECT_EQ(report.newEvents.size(), monitor.events().size());
    }
  }
}

TEST(StabilityMonitor, TakesTheBestProofWhereItDecides) {
  BarOptions options;
  options.element = "hex8";
  const Body body(generateCube(0.05, 5, options), makeMaterial("stvk", 30e3, 0.3, 1000), test::onThreads(1));
  const NodeVectors& X = body.mesh().X;
  const auto observed = [&](std::int64_t elements, std::optional<double> h) {
    MonitorOptions wanted;
    wanted.budget = infinity;
    wanted.firstObservationElements = elements;
    return StabilityMonitor(body, wanted).observe(0, 0, X, noVelocity(body), h);
  };
  const CriticalStep best = criticalStep(body, X, 2);
  const double kept = observed(0, std::nullopt).bracket->safe, between = 0.5 * (kept + best.safe);
  ASSERT_GT(best.safe, 1.01 * kept) << "a mesh on which the bound that is kept along a run is as good";
  // Certified without it.
  const MonitorReport cheap = observed(10000, 0.9 * kept);
  EXPECT_EQ(cheap.verdict, Verdict::certified);
  EXPECT_LE(cheap.bracket->safe, kept);
  // It certifies.
  EXPECT_EQ(observed(0, between).verdict, Verdict::notCertified);
  const MonitorReport decided = observed(10000, between);
  EXPECT_EQ(decided.verdict, Verdict::certified);
  EXPECT_EQ(decided.bracket->safe, best.safe);
  EXPECT_GT(decided.elementsRefreshed, cheap.elementsRefreshed);
  // There is nothing to decide: a step that is proven unstable, and none that is chosen, in a narrow bracket.
  EXPECT_LT(observed(10000, 1.01 * best.optimistic).bracket->safe, best.safe);
  const CriticalStep narrow = *observed(10000, std::nullopt).bracket;
  EXPECT_EQ(narrow.safe, kept);
  EXPECT_LE(narrow.optimistic, 1.05 * narrow.safe);
}

TEST(StabilityMonitor, BeginsWithAFirstProofAndNarrowsInTheRun) {
  for (const Subdivision& subdivision : test::allSubdivisions()) {
    const Body body = test::boxBody(subdivision, "stvk", {6, 3, 3});
    const NodeVectors& X = body.mesh().X;
    const double exact = 2 / std::sqrt(DenseTangent(body, X).largest());
    StabilityMonitor chosen(body, unlimited), open(body, unlimited);
    const MonitorReport first = chosen.observe(0, 0, X, noVelocity(body), 0.5 * exact);
    const MonitorReport best = open.observe(0, 0, X, noVelocity(body), std::nullopt);
    EXPECT_EQ(first.verdict, Verdict::certified) << subdivision.name;
    EXPECT_LE(first.bracket->safe, exact) << subdivision.name;
    EXPECT_GE(first.bracket->optimistic, exact * (1 - 1e-9)) << subdivision.name;
    EXPECT_GE(first.bracket->safe, 0.78 * exact) << subdivision.name;
    EXPECT_LE(3 * first.elementsRefreshed, 2 * best.elementsRefreshed) << subdivision.name;
    MonitorReport later;
    for (int i = 1; i <= 50; ++i) later = chosen.observe(i, 0, X, noVelocity(body), 0.5 * exact);
    EXPECT_LE(later.bracket->safe, exact) << subdivision.name;
    EXPECT_GE(later.bracket->safe, 0.93 * later.bracket->optimistic) << subdivision.name;
    // A step that this does not prove gets all there is at once.
    const MonitorReport close =
        StabilityMonitor(body, unlimited).observe(0, 0, X, noVelocity(body), 0.99 * best.bracket->safe);
    EXPECT_EQ(close.verdict, Verdict::certified) << subdivision.name;
  }
}

// What a budget leaves for the first observation depends on how long the run is.
TEST(StabilityMonitor, BeginsWithAFirstProofWhereTheRunIsShort) {
  for (const Subdivision& subdivision : test::allSubdivisions())
    for (const MonitorMode mode : {MonitorMode::bracket, MonitorMode::threshold}) {
      const Body body = test::boxBody(subdivision, "stvk", {6, 3, 3});
      const NodeVectors& X = body.mesh().X;
      const double exact = 2 / std::sqrt(DenseTangent(body, X).largest());
      const auto evaluated = [&](double budget, std::int64_t steps) {
        StabilityMonitor monitor(body, {.mode = mode, .budget = budget, .steps = steps, .workInAdvance = 0});
        const MonitorReport& first = monitor.observe(0, 0, X, noVelocity(body), 0.5 * exact);
        EXPECT_EQ(first.verdict, Verdict::certified) << subdivision.name;
        return first.elementsRefreshed;
      };
      const std::int64_t inAShortRun = evaluated(0.1, 100), inALongOne = evaluated(0.1, 1000000);
      EXPECT_LE(inAShortRun, evaluated(infinity, 0)) << subdivision.name;
      EXPECT_EQ(inAShortRun, evaluated(0.1, 0)) << subdivision.name;
      if (mode == MonitorMode::bracket) {
        EXPECT_LE(3 * inAShortRun, 2 * inALongOne) << subdivision.name;
      }
    }
}

/// The safe side at so many observations of a box at rest, over its exact step.
std::vector<double> safeSidesAtRest(const Subdivision& subdivision, int observations) {
  const Body body = test::boxBody(subdivision, "stvk", {6, 3, 3});
  const NodeVectors& X = body.mesh().X;
  const double exact = 2 / std::sqrt(DenseTangent(body, X).largest());
  StabilityMonitor monitor(body, {.budget = 10, .workInAdvance = 0});
  std::vector<double> safe;
  for (int i = 0; i < observations; ++i)
    safe.push_back(monitor.observe(i, 0, X, noVelocity(body), 0.5 * exact).bracket->safe / exact);
  return safe;
}

// What is found of the lower side makes no room above it that the weights do not need. Measured: 0 to 0.033.
TEST(StabilityMonitor, KeepsItsSafeSideWhereTheLowerOneIsFoundHigher) {
  for (const Subdivision& subdivision : test::allSubdivisions()) {
    double best = 0, lost = 0;
    for (const double safe : safeSidesAtRest(subdivision, 601)) {
      best = std::max(best, safe);
      lost = std::max(lost, best - safe);
    }
    RecordProperty(subdivision.name, joinText(lost));
    EXPECT_LE(lost, 0.05) << subdivision.name;
  }
}

// A budget is a share of all steps, watched or not, and so is what may be taken in advance. Measured: 0.08 to 0.21.
TEST(StabilityMonitor, KeepsItsBudgetWhereItWatchesFewSteps) {
  for (const Subdivision& subdivision : test::allSubdivisions()) {
    const Body body = test::boxBody(subdivision, "stvk", {10, 5, 5});
    const NodeVectors& X = body.mesh().X;
    const double h = 1 / std::sqrt(globalFrequency(body, X).lambda);
    constexpr int steps = 600;
    const auto spent = [&](int every) {
      StabilityMonitor monitor(body, {.every = every, .budget = 0.1, .steps = steps, .workInAdvance = 0});
      NodeVectors x = X;
      double sum = 0;
      for (int step = 0; step <= steps; ++step) {
        const double pulled = 0.3 * step / steps;
        x.row(0) = (1 + pulled) * X.row(0);
        x.row(1) = (1 - 0.3 * pulled) * X.row(1);
        const MonitorReport& report = monitor.observe(step, 0, x, noVelocity(body), h);
        if (step > 0) sum += report.spent.total();
      }
      return sum / steps;
    };
    for (const int every : {10, 60}) {
      const double share = spent(every);
      RecordProperty(joinText(subdivision.name, "-", every), joinText(share));
      EXPECT_LE(share, 0.3) << subdivision.name << ", every " << every;
    }
  }
}

// Weights that ended early do not tell how narrow the bracket can be.
TEST(StabilityMonitor, NarrowsInTheRunOnceThereAreMeansForIt) {
  for (const Subdivision& subdivision : test::allSubdivisions()) {
    const std::vector<double> safe = safeSidesAtRest(subdivision, 201);
    const double first = safe.front(), later = safe.back();
    EXPECT_LE(later, 1) << subdivision.name;
    // Narrower by a twentieth, or as narrow as is wanted.
    EXPECT_GE(later, 0.9) << subdivision.name;
    EXPECT_GE(later, std::min(1.05 * first, 0.93)) << subdivision.name;
  }
}

TEST(CriticalStep, TellsWhatIsProvenSoFar) {
  for (const Subdivision& subdivision : test::allSubdivisions()) {
    const Body body = test::boxBody(subdivision, "neo-hookean");
    for (const test::NamedState& state : test::deformedStates(body.mesh().X, 4)) {
      const double exact = 2 / std::sqrt(DenseTangent(body, state.x).largest());
      double safe = 0, optimistic = infinity;
      int told = 0;
      const auto listen = [&](double nowSafe, double nowOptimistic) {
        EXPECT_LE(nowSafe, exact * (1 + 1e-9)) << subdivision.name << ", " << state.name;
        EXPECT_GE(nowOptimistic, exact * (1 - 1e-9)) << subdivision.name << ", " << state.name;
        EXPECT_GE(nowSafe, safe) << subdivision.name << ", " << state.name;
        EXPECT_LE(nowOptimistic, optimistic) << subdivision.name << ", " << state.name;
        safe = nowSafe;
        optimistic = nowOptimistic;
        ++told;
      };
      const CriticalStep step = criticalStep(body, state.x, 2, {.listener = listen});
      EXPECT_GE(told, 2) << subdivision.name;
      EXPECT_GE(step.safe, safe) << subdivision.name << ", " << state.name;
      EXPECT_EQ(step.optimistic, optimistic) << subdivision.name << ", " << state.name;
      const CriticalStep same = criticalStep(body, state.x, 2);
      EXPECT_EQ(step.safe, same.safe);
    }
  }
}

TEST(StabilityMonitor, ReportsAViolationOnceWhenItBegins) {
  const Body body = test::boxBody(test::allSubdivisions()[0], "stvk");
  const NodeVectors& X = body.mesh().X;
  const CriticalStep step = criticalStep(body, X, 2);
  MonitorOptions options = unlimited;
  options.clearObservations = 3;
  StabilityMonitor monitor(body, options);
  std::vector<std::int64_t> reported;
  for (int i = 0; i < 14; ++i) {
    // It pauses at step 5, ends at 7 and begins again at 10.
    const bool tooLarge = i == 3 || i == 4 || i == 6 || i >= 10;
    const MonitorReport& report =
        monitor.observe(i, 0.5 * i, X, noVelocity(body), (tooLarge ? 1.1 * step.optimistic : 0.5 * step.safe));
    for (const MonitorEvent& event : report.newEvents) {
      EXPECT_EQ(event.kind, EventKind::violated);
      reported.push_back(event.step);
    }
  }
  EXPECT_EQ(reported, (std::vector<std::int64_t>{3, 10}));
  ASSERT_EQ(monitor.events().size(), 2u);
  EXPECT_EQ(monitor.events()[0].end, 7);
  EXPECT_FALSE(monitor.events()[1].end);
  const MonitorEvent& event = monitor.events()[0];
  EXPECT_EQ(event.time, 1.5);
  EXPECT_NEAR(event.value, 1.1, 0.01);
  ASSERT_TRUE(event.element);
  expectText(body, event,
             {"step 3", "1.5 s", "violated", "tet4", joinText(event.element->block, ":", event.element->element)});
  for (const std::int32_t node : body.blocks()[0]->nodesOf(event.element->element))
    expectText(body, event, {joinText(" ", node)});
}

TEST(StabilityMonitor, ReportsANonFiniteState) {
  const Body body = test::boxBody(test::allSubdivisions()[0], "stvk");
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity})
    for (const bool inVelocity : {false, true}) {
      StabilityMonitor monitor(body, {});
      NodeVectors x = body.mesh().X, v = noVelocity(body);
      monitor.observe(0, 0, x, v, 1e-9);
      (inVelocity ? v : x)(1, 4) = bad;
      for (int step = 1; step < 4; ++step) {
        const MonitorReport& report = monitor.observe(step, 0.1 * step, x, v, 1e-9);
        EXPECT_EQ(report.verdict, Verdict::violated);
        EXPECT_FALSE(report.fresh);
        EXPECT_EQ(report.newEvents.size(), step == 1 ? 1u : 0u);
      }
      const MonitorEvent& event = onlyEvent(monitor, EventKind::nonFinite);
      EXPECT_EQ(event.step, 1);
      EXPECT_EQ(event.time, 0.1);
      expectText(body, event, {"step 1", "0.1 s", "not finite"});
    }
}

void expectNoNan(const Body& body, const StabilityMonitor& monitor) {
  for (const MonitorEvent& event : monitor.events()) {
    const std::string text = eventText(event, body.mesh());
    EXPECT_EQ(text.find("nan"), std::string::npos) << text;
  }
}

TEST(StabilityMonitor, HasNoBracketOfAnEarlierStateWhereTheStateIsNotFinite) {
  const Body body = test::boxBody(test::allSubdivisions()[0], "stvk");
  const NodeVectors& X = body.mesh().X;
  NodeVectors bad = X;
  bad(1, 4) = std::numeric_limits<double>::quiet_NaN();
  for (const MonitorMode mode : {MonitorMode::bracket, MonitorMode::threshold})
    for (const int every : {1, 5})
      for (const bool first : {true, false}) {
        MonitorOptions options;
        options.mode = mode;
        options.every = every;
        options.metric = "reduced-1-ring";
        StabilityMonitor monitor(body, options);
        if (!first) monitor.observe(0, 0, X, noVelocity(body), 10);  // far too large: there is a bracket
        for (int step = 1; step < 4; ++step) {
          const MonitorReport& report = monitor.observe(step, 0, bad, noVelocity(body), 1e-9);
          EXPECT_EQ(report.verdict, Verdict::violated);
          EXPECT_FALSE(report.bracket);
          EXPECT_FALSE(report.metricStep);
          EXPECT_EQ(report.certified, 0);
        }
        // The first finite state is evaluated, due or not.
        const MonitorReport& report = monitor.observe(4, 0, X, noVelocity(body), 1e-9);
        EXPECT_TRUE(report.fresh);
        EXPECT_EQ(report.evaluatedAt, 4);
        EXPECT_EQ(report.verdict, Verdict::certified);
        EXPECT_TRUE(report.bracket.has_value() || mode == MonitorMode::threshold);
        expectNoNan(body, monitor);
      }
}

TEST(StabilityMonitor, HasNoBracketWhereTheTangentIsNotFinite) {
  for (const Subdivision& subdivision : test::allSubdivisions()) {
    // The logarithm of det F does not exist in a mirrored body.
    const Body body = test::boxBody(subdivision, "neo-hookean");
    const NodeVectors &X = body.mesh().X, mirrored = Eigen::Vector3d(-1, 1, 1).asDiagonal() * X;
    const double exact = stepFor(DenseTangent(body, X).largest(), 2);
    for (const MonitorMode mode : {MonitorMode::bracket, MonitorMode::threshold})
      for (const bool first : {true, false}) {
        MonitorOptions options;
        options.mode = mode;
        options.every = 2;
        StabilityMonitor monitor(body, options);
        if (!first) monitor.observe(0, 0, X, noVelocity(body), 10);
        for (int step = 2; step < 6; ++step) {
          const MonitorReport& report = monitor.observe(step, 0, mirrored, noVelocity(body), 1e-9);
          if (!first && step == 2) continue;  // not its turn yet
          EXPECT_EQ(report.verdict, Verdict::violated) << subdivision.name;
          EXPECT_FALSE(report.bracket) << subdivision.name;
          EXPECT_EQ(report.certified, 0) << subdivision.name;
        }
        expectText(body, onlyEvent(monitor, EventKind::nonFinite), {"tangent is not finite"});
        onlyEvent(monitor, EventKind::inverted);
        expectNoNan(body, monitor);
        // Nothing of it is left over.
        const MonitorReport& report = monitor.observe(6, 0, X, noVelocity(body), std::nullopt);
        ASSERT_TRUE(report.bracket) << subdivision.name;
        EXPECT_LE(report.bracket->safe, exact * (1 + 1e-9)) << subdivision.name;
        EXPECT_GE(report.bracket->optimistic, exact * (1 - 1e-9)) << subdivision.name;
        EXPECT_LE(report.bracket->optimistic, 1.1 * exact) << subdivision.name;
      }
    EXPECT_THROW(criticalStep(body, mirrored, 2), NumericalError);
  }
}

TEST(StabilityMonitor, RefusesWhatIsNoStateOrNoStep) {
  const Body body = test::boxBody(test::allSubdivisions()[0], "stvk");
  const NodeVectors X = body.mesh().X, v = noVelocity(body), few = X.leftCols(3), many = NodeVectors::Zero(3, 1000);
  StabilityMonitor monitor(body, {});
  const auto refusal = [&](const std::function<void()>& call) -> std::string {
    try {
      call();
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  for (const NodeVectors* wrong : {&few, &many}) {
    const std::string size = joinText("3 x ", wrong->cols(), ": must be 3 x 27");
    const std::string inX = refusal([&] { monitor.observe(0, 0, *wrong, v, 1e-9); }),
                      inV = refusal([&] { monitor.observe(0, 0, X, *wrong, 1e-9); }),
                      inCritical = refusal([&] { criticalStep(body, *wrong, 2); }),
                      inGlobal = refusal([&] { globalFrequency(body, *wrong); });
    for (const std::string& text : {inX, inCritical, inGlobal}) EXPECT_EQ(text.find("x is " + size), 0u) << text;
    EXPECT_EQ(inV.find("v is " + size), 0u) << inV;
  }
  for (const double h : {0.0, -1e-9, std::numeric_limits<double>::quiet_NaN(), infinity})
    EXPECT_EQ(refusal([&] { monitor.observe(0, 0, X, v, h); }).find(joinText("h = ", h, " s: must be > 0 and finite")),
              0u);
  EXPECT_EQ(monitor.observe(0, 0, X, v, 1e-9).verdict, Verdict::certified) << "a refused call changes nothing";
}

TEST(StabilityMonitor, GivesABracketWhileNoStepIsChosen) {
  const Body body = test::boxBody(test::allSubdivisions()[0], "stvk");
  for (const MonitorMode mode : {MonitorMode::bracket, MonitorMode::threshold}) {
    MonitorOptions options;
    options.mode = mode;
    StabilityMonitor monitor(body, options);
    const MonitorReport& report = monitor.observe(0, 0, body.mesh().X, noVelocity(body), std::nullopt);
    EXPECT_EQ(report.verdict, Verdict::notCertified);
    EXPECT_EQ(report.h, 0);
    ASSERT_TRUE(report.bracket);
    EXPECT_EQ(report.certified, report.bracket->safe);
    EXPECT_TRUE(monitor.events().empty());
    EXPECT_EQ(monitor.observe(1, 0, body.mesh().X, noVelocity(body), 0.99 * report.bracket->safe).verdict,
              Verdict::certified);
  }
}

TEST(StabilityMonitor, FollowsMassesAndConstraintsOfTheBody) {
  using Change = std::function<void(Body&)>;
  const std::pair<std::string, Change> changes[] = {
      {"mass",
       [](Body& body) {
         for (std::int32_t i = 0; i < body.nodeCount(); ++i) body.addNodalMass(i, 2 * body.lumpedMass()[i]);
       }},
      {"held",
       [](Body& body) {
         for (std::int32_t i = 0; i < body.nodeCount(); ++i)
           if (i != 13) body.constraints().fix(i);
       }},
      {"released", [](Body& body) { body.constraints() = Constraints(body.mesh().nodeCount()); }},
      {"held otherwise", [](Body& body) {
         body.constraints() = Constraints(body.mesh().nodeCount());
         for (std::int32_t i = 0; i < body.nodeCount(); ++i) body.constraints().fix(i, 1);
       }}};
  for (const Subdivision& subdivision : test::allSubdivisions())
    for (const auto& [name, change] : changes)
      for (const MonitorMode mode : {MonitorMode::bracket, MonitorMode::threshold})
        for (const int every : {1, 10}) {
          Body body = test::boxBody(subdivision, "stvk");
          for (std::int32_t i = 0; i < 18; ++i) body.constraints().fix(i);
          const NodeVectors& X = body.mesh().X;
          const std::string what =
              joinText(subdivision.name, ", ", name, ", ", monitorModeName(mode), ", every ", every);
          MonitorOptions options;
          options.mode = mode;
          options.every = every;
          StabilityMonitor monitor(body, options);
          const double before = stepFor(DenseTangent(body, X).largest(), 2), h = 0.9 * before;
          for (int step = 0; step < 3; ++step) monitor.observe(step, 0, X, noVelocity(body), h);
          change(body);
          const double exact = stepFor(DenseTangent(body, X).largest(), 2);
          const MonitorReport& report = monitor.observe(3, 0, X, noVelocity(body), h);
          EXPECT_TRUE(report.fresh) << what;
          if (report.bracket) {
            EXPECT_LE(report.bracket->safe, exact * (1 + 1e-9)) << what;
            EXPECT_GE(report.bracket->optimistic, exact * (1 - 1e-9)) << what;
          }
          EXPECT_LE(report.certified, exact * (1 + 1e-9)) << what;
          if (h < 0.8 * exact) {
            EXPECT_EQ(report.verdict, Verdict::certified) << what;
          }
          if (h > 1.2 * exact) {
            EXPECT_EQ(report.verdict, Verdict::violated) << what;
          }
        }
}

TEST(StabilityMonitor, NamesElementsOfAMeshWithoutNumbers) {
  for (const Subdivision& subdivision : test::allSubdivisions()) {
    Mesh mesh = test::box(subdivision, {2, 2, 2});
    mesh.nodeIds.clear();
    for (MeshBlock& block : mesh.blocks) block.ids.clear();
    const Body body(std::move(mesh), makeMaterial("stvk", test::young, 0.3, test::density), test::onThreads(1));
    StabilityMonitor monitor(body, {});
    monitor.observe(0, 0, body.mesh().X, noVelocity(body), 1);
    const MonitorEvent& event = onlyEvent(monitor, EventKind::violated);
    ASSERT_TRUE(event.element);
    std::string nodes = "nodes";
    for (const std::int32_t node : body.blocks()[event.element->block]->nodesOf(event.element->element))
      nodes += joinText(" ", node);
    expectText(body, event, {nodes + ": "});
  }
}

TEST(StabilityMonitor, ReportsAnInvertedElement) {
  for (const Subdivision& subdivision : test::allSubdivisions())
    for (const LawInfo& law : allLaws()) {
      Body body = test::boxBody(subdivision, law.name);
      const NodeVectors& X = body.mesh().X;
      StabilityMonitor monitor(body, {});
      NodeVectors x = X;
      const std::int32_t corner = 0;
      const Eigen::Vector3d across = (X.rowwise().mean() - X.col(corner)) * 1.7;
      for (int step = 0; step <= 10; ++step) {
        x.col(corner) = X.col(corner) + 0.1 * step * across;
        const double least = body.leastDeterminant(x).value;
        const MonitorReport& report = monitor.observe(step, step, x, noVelocity(body), 1e-9);
        const int expected = !(least > 0) && !law.allowsInversion;
        EXPECT_EQ(countEvents(monitor, EventKind::inverted), expected)
            << subdivision.name << ", " << law.name << ", det F = " << least;
        // Where the law has no tangent any more, nothing is certified.
        if (law.name == NeoHookean::name && expected) {
          EXPECT_NE(report.verdict, Verdict::certified) << subdivision.name;
        }
      }
      if (law.allowsInversion) continue;
      const MonitorEvent& event = onlyEvent(monitor, EventKind::inverted);
      x.col(corner) = X.col(corner) + 0.1 * static_cast<double>(event.step) * across;
      EXPECT_NEAR(event.value, body.leastDeterminant(x).value, 1e-12);
      EXPECT_LE(event.value, 0);
      ASSERT_TRUE(event.element);
      EXPECT_EQ(*event.element, body.leastDeterminant(x).element);
      expectText(body, event,
                 {joinText("step ", event.step), "inverted", "det F",
                  joinText(event.element->block, ":", event.element->element)});
    }
}

TEST(StabilityMonitor, ReportsTheCollapseOfStVenantKirchhoff) {
  // A column that can only be compressed along x: P11 = s (λ+2μ)(s²-1)/2 falls below s = 1/√3. With ν = 0.2 shear
  // across the column, S22 + μ s² = λ (s²-1)/2 + μ s², holds out until s = 1/2.
  const Subdivision hexes{"", "hex8", 1, "", 0};
  Body body(test::box(hexes, {1, 1, 1}, 0), makeMaterial("stvk", test::young, 0.2, test::density), test::onThreads(1));
  for (std::int32_t i = 0; i < body.nodeCount(); ++i) {
    body.constraints().fix(i, 1);
    body.constraints().fix(i, 2);
    if (body.mesh().X(0, i) < 1e-9) body.constraints().fix(i, 0);
  }
  StabilityMonitor monitor(body, {});
  const double collapse = 1 / std::sqrt(3.0);
  std::int64_t step = 0;
  for (const double s : {1.0, 0.8, collapse + 1e-6}) {
    monitor.observe(step++, 0, Eigen::Vector3d(s, 1, 1).asDiagonal() * body.mesh().X, noVelocity(body), 1e-9);
    EXPECT_EQ(countEvents(monitor, EventKind::indefinite), 0) << s;
  }
  const std::int64_t begin = step;
  for (int i = 0; i < 30; ++i)
    monitor.observe(step++, 0.5, Eigen::Vector3d(collapse - 1e-6, 1, 1).asDiagonal() * body.mesh().X, noVelocity(body),
                    1e-9);
  const MonitorEvent& event = onlyEvent(monitor, EventKind::indefinite);
  EXPECT_GE(event.step, begin);
  EXPECT_LE(event.step, begin + 10);  // rings under compression are examined every tenth time
  EXPECT_LT(event.value, 0);
  ASSERT_TRUE(event.element);
  EXPECT_EQ(*event.element, (ElementRef{0, 0}));
  expectText(body, event, {joinText("step ", event.step), "0.5 s", "indefinite", "hex8 element 0:0"});
}

TEST(StabilityMonitor, ReportsAnIndefiniteTangentOnlyWhenItIs) {
  // Compressed more and more, free sideways: rotating under compression has negative stiffness.
  for (const Subdivision& subdivision : test::allSubdivisions()) {
    Body body = test::boxBody(subdivision, "stvk");
    test::holdBody(body, test::Hold::face);
    StabilityMonitor monitor(body, {});
    bool told = false;
    for (int i = 0; i <= 140; ++i) {
      const NodeVectors x = Eigen::Vector3d(1.1 - 0.005 * i, 1, 1).asDiagonal() * body.mesh().X;
      monitor.observe(i, 0, x, noVelocity(body), 1e-9);
      const bool now = countEvents(monitor, EventKind::indefinite) > 0;
      if (now && !told) {
        EXPECT_LT(test::DenseTangent(body, x).eigenvalues()[0], 0) << subdivision.name << ", " << i;
      }
      told = now;
    }
    EXPECT_TRUE(told) << subdivision.name;
  }
}

TEST(StabilityMonitor, ReportsAnIndefiniteTangentAtTheFirstObservation) {
  int indefinite = 0;
  for (const Subdivision& subdivision : test::allSubdivisions())
    for (const LawInfo& law : allLaws())
      for (const double squash : {0.9, 0.7, 0.5}) {
        Body body = test::boxBody(subdivision, law.name, {6, 2, 2});
        test::holdBody(body, test::Hold::face);
        const NodeVectors x = Eigen::Vector3d(squash, 1, 1).asDiagonal() * body.mesh().X;
        const Eigen::VectorXd lambda = test::DenseTangent(body, x).eigenvalues();
        const std::string what = joinText(subdivision.name, ", ", law.name, ", squashed to ", squash);
        StabilityMonitor monitor(body, {});
        monitor.observe(0, 0, x, noVelocity(body), 1e-9);
        const bool told = countEvents(monitor, EventKind::indefinite) > 0;
        if (told) {
          const MonitorEvent& event = onlyEvent(monitor, EventKind::indefinite);
          EXPECT_GE(event.value, lambda[0] * (1 + 1e-9)) << what;
          EXPECT_LT(event.value, 0) << what;
          EXPECT_LT(lambda[0], 0) << what;
        }
        // What is finer than a thousandth of the highest eigenvalue may be missed.
        if (lambda[0] < -1e-3 * lambda[lambda.size() - 1]) {
          ++indefinite;
          EXPECT_TRUE(told) << what << ", least eigenvalue " << lambda[0];
          EXPECT_LT(criticalStep(body, x, 2).lowestRing, 0) << what;
        }
      }
  EXPECT_GE(indefinite, 40);
}

TEST(StabilityMonitor, ReportsABodyThatIsSquashedInTheMiddleOfARun) {
  // Told by the tenth observation after compression has grown by half.
  for (const Subdivision& subdivision : test::allSubdivisions()) {
    Body body = test::boxBody(subdivision, "neo-hookean", {6, 2, 2});
    test::holdBody(body, test::Hold::face);
    StabilityMonitor monitor(body, {});
    std::int64_t step = 0;
    for (; step < 25; ++step) monitor.observe(step, 0, body.mesh().X, noVelocity(body), 1e-9);
    EXPECT_EQ(countEvents(monitor, EventKind::indefinite), 0);
    const NodeVectors x = Eigen::Vector3d(0.6, 1, 1).asDiagonal() * body.mesh().X;
    for (; step < 36; ++step) monitor.observe(step, 0, x, noVelocity(body), 1e-9);
    EXPECT_EQ(countEvents(monitor, EventKind::indefinite), 1) << subdivision.name;
  }
}

TEST(StabilityMonitor, ReportsAnEnergyImbalance) {
  const Body body = test::boxBody(test::allSubdivisions()[0], "stvk");
  MonitorOptions options;
  options.energyTolerance = 0.1;
  options.clearObservations = 1;
  StabilityMonitor monitor(body, options);
  const auto observe = [&](std::int64_t step, double error) {
    const Energies energies{1, 3, 0, error};
    monitor.observe(step, 0.1 * static_cast<double>(step), body.mesh().X, noVelocity(body), 1e-9);
    return monitor.observeEnergies(energies).newEvents.size();
  };
  // Schemes with lagging velocities are off at the start of a run under load.
  for (int step = 0; step < 20; ++step) EXPECT_EQ(observe(step, step == 0 ? 0.0 : 4.0 / step), 0u) << step;
  EXPECT_EQ(observe(20, 0.0), 0u);
  EXPECT_EQ(observe(21, 0.39), 0u);
  EXPECT_EQ(observe(22, -0.41), 1u);
  EXPECT_EQ(observe(23, 0.5), 0u);  // goes on
  EXPECT_EQ(observe(24, 0.1), 0u);  // ends
  EXPECT_EQ(observe(25, 0.5), 1u);  // begins again
  ASSERT_EQ(countEvents(monitor, EventKind::energyBalance), 2);
  const MonitorEvent& event = monitor.events()[0];
  EXPECT_EQ(event.step, 22);
  EXPECT_NEAR(event.value, 0.1025, 1e-12);
  expectText(body, event, {"step 22", "2.2 s", "energy", "10.25 %"});
}

// Steps settle a run, not rows: of a run whose energies are asked for every tenth step the third row counts.
TEST(StabilityMonitor, ReportsAnEnergyImbalanceOfARunWithFewRows) {
  const Body body = test::boxBody(test::allSubdivisions()[0], "stvk");
  StabilityMonitor monitor(body, {});
  std::int64_t seen = -1;
  for (std::int64_t step = 0; step <= 40; ++step) {
    monitor.observe(step, 0, body.mesh().X, noVelocity(body), 1e-9);
    if (step % 10 == 0 && !monitor.observeEnergies({1, 3, 0, 2}).newEvents.empty() && seen < 0) seen = step;
  }
  EXPECT_EQ(seen, 20);
}

TEST(StabilityMonitor, SeesTheEnergyOfARunBeyondItsStep) {
  const Body body = test::boxBody(test::allSubdivisions()[0], "linear");
  const double h = 1.05 * criticalStep(body, body.mesh().X, 2).optimistic;
  StabilityMonitor monitor(body, {});
  BodySystem system(body);
  SymplecticEuler integrator;
  EnergyBalance balance(body);
  State state{0, body.mesh().X, test::randomVelocities(body, 0.01, 2)};
  for (int step = 0; step < 200; ++step) {
    monitor.observe(step, state.time, state.x, state.v, h);
    monitor.observeEnergies(balance.evaluate(state.x, state.v));
    integrator.step(system, state, h);
  }
  EXPECT_EQ(onlyEvent(monitor, EventKind::violated).step, 0);
  EXPECT_GT(monitor.events().size(), 1u);
  EXPECT_GE(countEvents(monitor, EventKind::energyBalance), 1);
}

TEST(StabilityMonitor, EvaluatesEveryNthStep) {
  const Body body = test::boxBody(test::allSubdivisions()[0], "stvk");
  for (const int every : {1, 2, 5}) {
    MonitorOptions options;
    options.every = every;
    options.metric = "reduced-1-ring";
    StabilityMonitor monitor(body, options);
    double safe = 0, metricStep = 0;
    for (int step = 0; step < 11; ++step) {
      const NodeVectors x = Eigen::Vector3d(1 + 0.02 * step, 1, 1).asDiagonal() * body.mesh().X;
      const MonitorReport& report = monitor.observe(step, step, x, noVelocity(body), 1e-9);
      EXPECT_EQ(report.fresh, step % every == 0) << step << ", every " << every;
      ASSERT_TRUE(report.bracket);
      ASSERT_TRUE(report.metricStep);
      if (report.fresh) {
        EXPECT_NE(*report.metricStep, metricStep);
        safe = report.bracket->safe;
        metricStep = *report.metricStep;
      }
      EXPECT_EQ(report.bracket->safe, safe);
      EXPECT_EQ(*report.metricStep, metricStep);
    }
  }
}

// Whether the monitor evaluates in the pass of the force or not, what it says and what the pass gives are the same.
TEST(StabilityMonitor, FillsInTheEvaluationOfEveryState) {
  const Body body = test::boxBody(test::allSubdivisions()[0], "stvk", {4, 3, 3});
  const NodeVectors& X = body.mesh().X;
  test::Random random(17);
  const NodeVectors shake = random.nodeVectors(X.cols(), 0.05 * test::cellSize);
  NodeVectors notFinite = X;
  notFinite(1, 4) = std::numeric_limits<double>::quiet_NaN();
  const double h = 0.9 * criticalStep(body, X, 2).safe;
  for (const MonitorMode mode : {MonitorMode::bracket, MonitorMode::threshold, MonitorMode::metric})
    for (const int every : {1, 3}) {
      MonitorOptions options;
      options.mode = mode;
      options.every = every;
      if (mode == MonitorMode::metric) options.metric = "reduced-1-ring";
      StabilityMonitor with(body, options), apart(body, options);
      StepEvaluation evaluation;
      evaluation.wantsEnergy = true;
      constexpr int steps = 12, bad = 7;
      for (int step = 0; step < steps; ++step) {
        const std::string what = joinText(monitorModeName(mode), ", every ", every, ", step ", step);
        const NodeVectors x = step == bad ? notFinite : NodeVectors(X + 0.1 * step * shake);
        evaluation.internalForce.resize(3, 0);
        evaluation.strainEnergy = -1;
        const MonitorReport& seen = with.observe(step, 0, x, noVelocity(body), h, &evaluation);
        const MonitorReport& expected = apart.observe(step, 0, x, noVelocity(body), h);
        EXPECT_EQ(seen.verdict, expected.verdict) << what;
        EXPECT_EQ(seen.fresh, expected.fresh) << what;
        EXPECT_EQ(seen.newEvents.size(), expected.newEvents.size()) << what;
        ASSERT_EQ(seen.bracket.has_value(), expected.bracket.has_value()) << what;
        // The gradients of the two passes may be rounded otherwise.
        EXPECT_NEAR(seen.certified, expected.certified, 1e-9 * expected.certified) << what;
        if (seen.bracket) {
          EXPECT_NEAR(seen.bracket->safe, expected.bracket->safe, 1e-9 * expected.bracket->safe) << what;
          EXPECT_NEAR(seen.bracket->optimistic, expected.bracket->optimistic, 1e-9 * expected.bracket->optimistic)
              << what;
        }
        ASSERT_EQ(evaluation.internalForce.cols(), X.cols()) << what;
        if (step == bad) {
          EXPECT_FALSE(evaluation.internalForce.allFinite()) << what;
          continue;
        }
        StepEvaluation alone;
        alone.wantsEnergy = true;
        Body::Workspace workspace;
        body.evaluate(x, alone, workspace);
        EXPECT_TRUE(evaluation.internalForce == alone.internalForce) << what;
        EXPECT_NEAR(evaluation.strainEnergy, alone.strainEnergy, 1e-13 * alone.strainEnergy + roundingEnergy(body))
            << what;
      }
    }
}

TEST(StabilityMonitor, ChecksTheStepAgainstTheBracketItKeeps) {
  const Body body = test::boxBody(test::allSubdivisions()[0], "stvk");
  MonitorOptions options;
  options.every = 10;
  StabilityMonitor monitor(body, options);
  const NodeVectors& X = body.mesh().X;
  const double safe = monitor.observe(0, 0, X, noVelocity(body), 1e-9).bracket->safe;
  EXPECT_EQ(monitor.observe(1, 0, X, noVelocity(body), 0.9 * safe).verdict, Verdict::certified);
  EXPECT_EQ(monitor.observe(2, 0, X, noVelocity(body), 2 * safe).verdict, Verdict::violated);
  EXPECT_EQ(onlyEvent(monitor, EventKind::violated).step, 2);
}

TEST(StabilityMonitor, AppliesTheMarginOfAnyMetric) {
  const Body body = test::boxBody(test::allSubdivisions()[0], "stvk");
  const NodeVectors x = Eigen::Vector3d(1.2, 1, 1).asDiagonal() * body.mesh().X;
  for (const MonitorMode mode : {MonitorMode::bracket, MonitorMode::threshold, MonitorMode::metric})
    for (const MetricInfo& metric : allMetrics())
      for (const double margin : {0.0, 0.1, 0.5}) {
        MonitorOptions options;
        options.mode = mode;
        options.metric = std::string(metric.name);
        options.margin = margin;
        StabilityMonitor monitor(body, options);
        EXPECT_EQ(monitor.options().metric, metric.name);
        const MonitorReport& report = monitor.observe(0, 0, x, noVelocity(body), 1e-12);
        const double expected = (1 - margin) * options.limit(evaluateMetric(metric.name, body, x).lambda);
        ASSERT_TRUE(report.metricStep) << metric.name;
        EXPECT_NEAR(*report.metricStep, expected, 1e-10 * expected) << metric.name;
        EXPECT_EQ(report.bracket.has_value(), mode == MonitorMode::bracket);
        // A metric alone certifies nothing, however small the step.
        const bool proves = mode != MonitorMode::metric;
        EXPECT_EQ(report.verdict, proves ? Verdict::certified : Verdict::notCertified) << metric.name;
        EXPECT_EQ(report.certified >= 1e-12, proves);
      }
}

TEST(StabilityMonitor, ComputesOnlyWhatIsAskedFor) {
  const Body body = test::boxBody(test::allSubdivisions()[0], "stvk");
  MonitorOptions options;
  options.metric = "";
  StabilityMonitor monitor(body, options);
  const MonitorReport& report = monitor.observe(0, 0, body.mesh().X, noVelocity(body), 1e-12);
  EXPECT_FALSE(report.metricStep);
  EXPECT_TRUE(report.bracket);
}

TEST(StabilityMonitor, UsesTheIntegratorsLimit) {
  const Body body = test::boxBody(test::allSubdivisions()[0], "stvk");
  MonitorOptions two, three;
  three.limit = 3;
  StabilityMonitor a(body, two), b(body, three);
  const double ofTwo = a.observe(0, 0, body.mesh().X, noVelocity(body), 1e-9).bracket->safe;
  EXPECT_NEAR(b.observe(0, 0, body.mesh().X, noVelocity(body), 1e-9).bracket->safe, 1.5 * ofTwo, 1e-13 * ofTwo);
}

TEST(StabilityMonitor, RefusesBadOptions) {
  const Body body = test::boxBody(test::allSubdivisions()[0], "stvk");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  using Change = std::function<void(MonitorOptions&)>;
  const struct {
    std::string key, value, range;
    Change change;
  } cases[] = {
      {"margin", "-0.1", ">= 0 and < 1", [](MonitorOptions& o) { o.margin = -0.1; }},
      {"margin", "1", ">= 0 and < 1", [](MonitorOptions& o) { o.margin = 1; }},
      {"margin", "nan", ">= 0 and < 1", [nan](MonitorOptions& o) { o.margin = nan; }},
      {"every", "0", ">= 1", [](MonitorOptions& o) { o.every = 0; }},
      {"every", "-3", ">= 1", [](MonitorOptions& o) { o.every = -3; }},
      {"clearObservations", "0", ">= 1", [](MonitorOptions& o) { o.clearObservations = 0; }},
      {"mode", "metric", "name one", [](MonitorOptions& o) { o.mode = MonitorMode::metric; }},
      {"width", "0", "> 0 and < 1", [](MonitorOptions& o) { o.width = 0; }},
      {"width", "1", "> 0 and < 1", [](MonitorOptions& o) { o.width = 1; }},
      {"width", "nan", "> 0 and < 1", [nan](MonitorOptions& o) { o.width = nan; }},
      {"limit", "0", "", [](MonitorOptions& o) { o.limit = 0; }},
      {"limit", "-2", "", [](MonitorOptions& o) { o.limit = -2; }},
      {"limit", "nan", "", [nan](MonitorOptions& o) { o.limit = nan; }},
      {"budget", "nan", ">= 0", [nan](MonitorOptions& o) { o.budget = nan; }},
      {"budget", "-1", ">= 0", [](MonitorOptions& o) { o.budget = -1; }},
      {"workInAdvance", "nan", ">= 0", [nan](MonitorOptions& o) { o.workInAdvance = nan; }},
      {"steps", "-1", ">= 0", [](MonitorOptions& o) { o.steps = -1; }},
      {"energyTolerance", "nan", "> 0", [nan](MonitorOptions& o) { o.energyTolerance = nan; }},
      {"energyTolerance", "-1", "> 0", [](MonitorOptions& o) { o.energyTolerance = -1; }},
      {"metric", "reduced-ring", "reduced-1-ring", [](MonitorOptions& o) { o.metric = "reduced-ring"; }},
  };
  for (const auto& c : cases) {
    MonitorOptions options;
    c.change(options);
    try {
      StabilityMonitor monitor(body, options);
      ADD_FAILURE() << c.key << " = " << c.value << " was accepted";
    } catch (const InputError& error) {
      const std::string text = error.what();
      for (const std::string& part : {c.key, c.value, c.range}) EXPECT_NE(text.find(part), std::string::npos) << text;
      EXPECT_EQ(text.find('\n'), std::string::npos);
    }
  }
}

TEST(StabilityMonitor, NamesItsVerdictsAndEvents) {
  EXPECT_EQ(verdictName(Verdict::certified), "certified");
  EXPECT_EQ(verdictName(Verdict::notCertified), "not-certified");
  EXPECT_EQ(verdictName(Verdict::violated), "violated");
  for (const EventKind kind : {EventKind::violated, EventKind::energyBalance, EventKind::inverted, EventKind::nonFinite,
                               EventKind::indefinite})
    EXPECT_FALSE(eventName(kind).empty());
}

class MonitoredRun : public ::testing::TestWithParam<Subdivision> {
 protected:
  static constexpr double length = 6 * test::cellSize, speed = 0.1;
  static Body pulledBar() {
    Body body = test::boxBody(GetParam(), "stvk", {6, 2, 2}, 0.15);
    for (std::int32_t i = 0; i < body.nodeCount(); ++i) {
      if (body.mesh().X(0, i) < 1e-9) body.constraints().fix(i);
      if (body.mesh().X(0, i) > length - 1e-9) {
        body.constraints().fix(i);
        body.constraints().move(i, 0, speed);
      }
    }
    return body;
  }
};
INSTANTIATE_TEST_SUITE_P(Subdivisions, MonitoredRun, ::testing::ValuesIn(test::allSubdivisions()),
                         [](const auto& test) { return test::testName(test.param.name); });

TEST_P(MonitoredRun, SaysViolatedOnTimeAndNeverTooEarly) {
  // A bar pulled to twice its length stiffens: the critical step falls by half. The run itself takes small steps, so
  // that it stays sound; each monitor is asked about a fixed step, and the critical step passes one after the other.
  const Body body = pulledBar();
  BodySystem system(body);
  SymplecticEuler integrator;
  State state = system.initialState();
  const double rest = 2 / std::sqrt(globalFrequency(body, state.x).lambda);
  const double h = 0.3 * rest;
  const int steps = static_cast<int>(length / speed / h);
  struct Question {
    double h;
    std::unique_ptr<StabilityMonitor> monitor, threshold;
    std::int64_t violatedAt = -1, certified = 0, certifiedByThreshold = 0;
  };
  constexpr double late = 1.005;
  std::vector<Question> questions;
  MonitorOptions cheap = unlimited;
  cheap.mode = MonitorMode::threshold;
  for (const double share : {0.3, 0.5, 0.6, 0.7, 0.8, 0.9, 0.97, 1.01})
    questions.push_back({share * rest, std::make_unique<StabilityMonitor>(body, unlimited),
                         std::make_unique<StabilityMonitor>(body, cheap)});
  double exact = 0;
  for (int step = 0; step <= steps; ++step) {
    const GlobalFrequency global = globalFrequency(body, state.x);
    ASSERT_TRUE(global.converged);
    exact = 2 / std::sqrt(global.lambda);
    for (Question& question : questions) {
      const MonitorReport& report = question.monitor->observe(step, state.time, state.x, state.v, question.h);
      const std::string what = joinText("step ", step, ", h = ", question.h, ", critical ", exact);
      ASSERT_LE(report.bracket->safe, exact * (1 + 1e-9)) << what;
      ASSERT_GE(report.bracket->optimistic, exact * (1 - 1e-9)) << what;
      if (question.h <= exact * (1 - 1e-9)) {
        EXPECT_NE(report.verdict, Verdict::violated) << what;
      }
      if (question.h > late * exact) {
        EXPECT_EQ(report.verdict, Verdict::violated) << what;
      }
      if (question.h > exact * (1 + 1e-9)) {
        EXPECT_NE(report.verdict, Verdict::certified) << what;
      }
      if (report.verdict == Verdict::violated && question.violatedAt < 0) question.violatedAt = step;
      question.certified += report.verdict == Verdict::certified;

      const MonitorReport& other = question.threshold->observe(step, state.time, state.x, state.v, question.h);
      if (other.verdict == Verdict::certified) {
        EXPECT_LE(question.h, exact * (1 + 1e-9)) << what;
      } else {
        ASSERT_TRUE(other.bracket) << what;
        EXPECT_LE(other.bracket->safe, exact * (1 + 1e-9)) << what;
      }
      EXPECT_LE(other.certified, exact * (1 + 1e-9)) << what;
      if (question.h <= exact * (1 - 1e-9)) {
        EXPECT_NE(other.verdict, Verdict::violated) << what;
      }
      if (question.h > late * exact) {
        EXPECT_EQ(other.verdict, Verdict::violated) << what;
      }
      question.certifiedByThreshold += other.verdict == Verdict::certified;
    }
    integrator.step(system, state, h);
  }
  EXPECT_LT(exact, 0.8 * rest);
  EXPECT_EQ(questions.front().violatedAt, -1);
  EXPECT_EQ(questions.back().violatedAt, 0);
  EXPECT_EQ(questions.front().certified, steps + 1);
  EXPECT_EQ(questions.front().certifiedByThreshold, steps + 1);
  // Asked about one step only, it proves hardly less than with the bracket at hand.
  for (const Question& question : questions)
    EXPECT_GE(static_cast<double>(question.certifiedByThreshold), 0.8 * static_cast<double>(question.certified) - 40)
        << question.h;
  int met = 0;
  for (const Question& question : questions) met += question.violatedAt > 0;
  EXPECT_GE(met, 2);
}

// Without a limit at the step at which it shows in the third digit, with the usual one at most 20 steps after it has
// become too large. Measured: 1 to 12.
TEST_P(MonitoredRun, WithAStepThatBecomesTooLargeIsToldInTime) {
  const Body body = pulledBar();
  for (const MonitorOptions& options : {unlimited, MonitorOptions{.workInAdvance = 0}}) {
    BodySystem system(body);
    SymplecticEuler integrator;
    State state = system.initialState();
    const double h = 0.9 * 2 / std::sqrt(globalFrequency(body, state.x).lambda);
    StabilityMonitor monitor(body, options);
    EnergyBalance balance(body);
    bool told = false;
    int tooLarge = 0;  // steps
    for (int step = 0; step < 5000 && !told; ++step) {
      const double exact = 2 / std::sqrt(globalFrequency(body, state.x).lambda);
      monitor.observe(step, state.time, state.x, state.v, h);
      const MonitorReport& report = monitor.observeEnergies(balance.evaluate(state.x, state.v));
      told = report.verdict == Verdict::violated;
      tooLarge += h > exact;
      if (told) {
        EXPECT_GT(h, exact * (1 - 1e-9)) << "too early, step " << step;
      } else if (options.budget == infinity) {
        EXPECT_LE(h, 1.005 * exact) << "too late, step " << step;
      }
      if (report.verdict == Verdict::certified) {
        EXPECT_LE(h, exact * (1 + 1e-9)) << "certified above the critical step, step " << step;
      }
      integrator.step(system, state, h);
    }
    EXPECT_TRUE(told);
    EXPECT_LE(tooLarge, 20);
    RecordProperty(joinText("late-", options.budget), tooLarge);
  }
}

}  // namespace
}  // namespace ringwatch

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <optional>

#include <Eigen/Dense>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/median.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/integrators/symplectic_euler.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <ringwatch/monitor/bounds/reduced_ring.h>
#include <ringwatch/monitor/stability_monitor.h>
#include <ringwatch/monitor/step_limit.h>
#include <ringwatch/verify/monitor/monitor_histories.h>
#include <ringwatch/verify/monitor/monitor_studies.h>
#include <ringwatch/verify/study_bodies.h>

namespace ringwatch::detail {
namespace {

/// Steps until the energy is examined: velocities of symplectic Euler are half a step behind, which at step n of a run
/// under load is 1/n of the energy.
constexpr int settling = 20;

Mesh bar(std::string_view element, int cells) {
  BarOptions options;
  options.size = {0.2, 0.04, 0.04};
  options.cells = {5 * cells, cells, cells};
  options.element = element;
  options.split = findElementByName(element)->cellSplits.back().elementsPerCell;  // tetrahedra: five, not six
  options.jitter = 0.2;
  return generateBar(options);
}

void runHistory(StudyReport& report, StudyTable& table, const History& history) {
  const Body& body = history.body;
  ReducedRing ring(body);

  StudyFigure figure = figureOf("monitor-history-" + history.name, history.title, "time (s)", "step (s)", false,
                                {"exact", "safe, proven", "optimistic, proven", "reduced 1-ring", "step of the run",
                                 "first violated", "energy off by 10 %"});
  const int sampleEvery = std::max(1, history.steps / 200);
  std::vector<double> width;  // of the safe side against the exact step, %
  double worstOptimistic = -infinity;
  std::int64_t compared = 0, outside = 0, falseAlarms = 0, evaluated = 0, observations = 0;
  std::int64_t violatedAt = -1, energyAt = -1, exactAt = -1, indefiniteAt = -1;
  followHistory(history, [&](const HistoryState& now) {
    const MonitorReport& seen = now.seen;
    const auto mark = [&](std::size_t curve, double value) {
      figure.curves[curve].x.push_back(now.state.time);
      figure.curves[curve].y.push_back(value);
    };
    if (now.energyOff) {
      energyAt = now.step;
      mark(6, history.h);
    }
    evaluated += seen.elementsRefreshed;
    ++observations;
    for (const MonitorEvent& event : seen.newEvents)
      if (event.kind == EventKind::indefinite && indefiniteAt < 0) indefiniteAt = now.step;
    const bool alarm = seen.verdict == Verdict::violated && violatedAt < 0;
    if (energyAt < 0 && (now.step % sampleEvery == 0 || alarm)) {
      const GlobalFrequency top = globalFrequency(body, now.state.x, 1e-9);
      if (top.converged) {
        const double exact = stepFor(top.lambda, limit);
        outside += !(seen.bracket->safe <= exact * (1 + ofTheReference)) ||
                   !(seen.bracket->optimistic >= exact * (1 - ofTheReference));
        falseAlarms += alarm && exact >= history.h * (1 + ofTheReference);
        ++compared;
        if (exactAt < 0 && exact < history.h) exactAt = now.step;
        // How tight it is counts until the collapse.
        if (indefiniteAt < 0) {
          width.push_back(percentBelow(seen.bracket->safe, exact));
          worstOptimistic = std::max(worstOptimistic, percentBelow(seen.bracket->optimistic, exact));
        }
        mark(0, exact);
        mark(1, seen.bracket->safe);
        mark(2, seen.bracket->optimistic);
        mark(3, stepFor(ring.evaluate(now.state.x).highest, limit));
        mark(4, history.h);
      }
    }
    if (alarm) {
      violatedAt = now.step;
      mark(5, history.h);
    }
  });
  const auto elements = static_cast<double>(body.mesh().elementCount());
  table.rows.push_back({history.name, static_cast<std::int64_t>(elements), history.h,
                        *std::min_element(width.begin(), width.end()), median(width),
                        *std::max_element(width.begin(), width.end()), worstOptimistic,
                        static_cast<double>(evaluated) / elements / static_cast<double>(observations), exactAt,
                        violatedAt, energyAt, indefiniteAt});
  const auto at = [](std::int64_t step) { return step < 0 ? std::nan("") : static_cast<double>(step); };
  checkNear(report, history.name + ": exact values outside of the bracket",
            compared > 0 ? static_cast<double>(outside) : std::nan(""), 0, 0);
  checkNear(report, history.name + ": alarms while the exact step allows h", static_cast<double>(falseAlarms), 0, 0);
  if (history.indefinite)
    checkAtMost(report, history.name + ": step at which it is said indefinite, before the energy is off",
                at(indefiniteAt), static_cast<double>(energyAt < 0 ? history.steps : energyAt), 0);
  else
    checkAtLeast(report, history.name + ": steps from the first violated to an energy off by 10 %",
                 at(energyAt) - at(violatedAt), 20, 0);
  report.figures.push_back(std::move(figure));
}

}  // namespace

Body movedBar(std::string_view element, int cells, const Eigen::Vector3d& velocity, double rate, std::string_view law) {
  Body body(bar(element, cells), makeMaterial(law, young, poisson, density));
  for (const std::int32_t node : body.mesh().nodeSets.at("x-min")) body.constraints().fix(node);
  for (const std::int32_t node : body.mesh().nodeSets.at("x-max")) {
    const Eigen::Vector3d arm = body.mesh().X.col(node) - Eigen::Vector3d(0.2, 0.02, 0.02);
    const Eigen::Vector3d v = velocity + rate * Eigen::Vector3d(0, -arm[2], arm[1]);
    for (int c = 0; c < 3; ++c) body.constraints().move(node, c, v[c]);
  }
  return body;
}

Body hangingBall(std::string_view element, int cells, std::string_view law) {
  BallOptions options;
  options.radius = 0.05;
  options.cells = cells;
  options.element = element;
  Body body(generateBall(options), makeMaterial(law, young, poisson, density));
  for (std::int32_t node = 0; node < body.nodeCount(); ++node)
    if (body.mesh().X(2, node) > 0.8 * options.radius) body.constraints().fix(node);
  for (std::int32_t node = 0; node < body.nodeCount(); ++node)
    body.externalForce()(2, node) = -body.lumpedMass()[node] * 250 * (1 - body.mesh().X(2, node) / options.radius);
  return body;
}

void followHistory(const History& history, const std::function<void(const HistoryState&)>& visit) {
  const Body& body = history.body;
  BodySystem system(body);
  State state = gentleStart(system);
  SymplecticEuler integrator;
  MonitorOptions options;
  options.limit = limit;
  options.budget = infinity;
  StabilityMonitor monitor(body, options);
  EnergyBalance balance(body);
  StepEvaluation evaluation;
  evaluation.wantsEnergy = true;
  double largest = 0;
  for (std::int64_t step = 0; step <= history.steps; ++step) {
    monitor.observe(step, state.time, state.x, state.v, history.h, &evaluation);
    system.complete(state, evaluation);
    if (!evaluation.internalForce.allFinite() || !state.v.allFinite()) break;
    balance.record(state.x, evaluation.internalForce);
    const Energies energies = balance.energies(state.x, state.v, evaluation.strainEnergy);
    const MonitorReport& seen = monitor.observeEnergies(energies);
    largest = std::max({largest, energies.kinetic + std::abs(energies.strain), std::abs(energies.externalWork)});
    const bool off = step >= settling && std::abs(energies.balanceError) > 0.1 * largest;
    visit({step, state, seen, energies, off});
    if (off) break;
    integrator.advance(system, state, history.h);
  }
}

State gentleStart(const BodySystem& system) {
  State state = system.initialState();
  const NodeVectors& X = system.body().mesh().X;
  const double length = X.row(0).maxCoeff();
  const auto& end = system.body().mesh().nodeSets.find("x-max");
  if (end == system.body().mesh().nodeSets.end()) return state;
  // Velocities of the moved end depend on y and z linearly: a plane through three of its nodes gives them everywhere.
  Eigen::MatrixX3d A(end->second.size(), 3);
  Eigen::MatrixX3d b(A.rows(), 3);
  for (Eigen::Index i = 0; i < A.rows(); ++i) {
    const std::int32_t node = end->second[i];
    A.row(i) << 1, X(1, node), X(2, node);
    b.row(i) = state.v.col(node).transpose();
  }
  const Eigen::Matrix3d plane = (A.transpose() * A).inverse() * (A.transpose() * b);
  for (Eigen::Index node = 0; node < X.cols(); ++node)
    state.v.col(node) = X(0, node) / length * (Eigen::RowVector3d(1, X(1, node), X(2, node)) * plane).transpose();
  return state;
}

std::vector<History> monitorHistories(StudyEffort effort) {
  std::vector<History> histories;
  const bool full = effort == StudyEffort::full;
  const int cells = full ? 4 : 2;
  const auto step = [](const Body& body, double share) {
    return share * criticalStep(body, body.mesh().X, limit).optimistic;
  };
  const auto add = [&](std::string name, std::string title, Body body, double share, int steps, bool indefinite) {
    const double h = step(body, share);
    histories.push_back({std::move(name), std::move(title), std::move(body), h, steps, indefinite});
  };
  // The same stretch a step on coarse and fine meshes.
  const double speed = 0.1 * cells;
  const Eigen::Vector3d pull(speed, 0, 0), slow(speed / 8, 0, 0), push(-0.75 * speed, 0, 0);
  add("pulled-tet4", "Bar of tetrahedra, pulled at its end", movedBar("tet4", cells, pull, 0), 0.85, 4000, false);
  add("pulled-hex8", "Bar of hexahedra, pulled at its end", movedBar("hex8", cells, pull, 0), 0.85, 4000, false);
  add("twisted-tet4", "Bar of tetrahedra, its end turned", movedBar("tet4", cells, Eigen::Vector3d::Zero(), 3 * cells),
      0.9, 4000, false);
  add("compressed-tet4", "Bar of tetrahedra, compressed", movedBar("tet4", cells, push, 0), 0.5, 4000, true);
  add("hanging-ball", "Ball held at its top, in a field of force", hangingBall("tet4", full ? 8 : 5), 0.9, 4000, false);
  if (full) {
    add("slowly-pulled-tet4", "Bar of tetrahedra, pulled slowly", movedBar("tet4", cells, slow, 0), 0.85, 12000, false);
    add("pulled-wedge6", "Bar of wedges, pulled at its end", movedBar("wedge6", cells, pull, 0), 0.85, 4000, false);
    add("pulled-pyramid5", "Bar of pyramids, pulled at its end", movedBar("pyramid5", cells, pull, 0), 0.85, 4000,
        false);
    add("pulled-tet4-fine", "Fine bar of tetrahedra, pulled at its end", movedBar("tet4", 10, pull, 0), 0.85, 4000,
        false);
  }
  return histories;
}

void studyHistories(StudyReport& report, StudyEffort effort) {
  StudyTable table{
      "histories",
      "Nonlinear runs, symplectic Euler, St. Venant-Kirchhoff: bracket against the exact step, and the onset",
      {"run", "elements", "h (s)", "safe side, worst (%)", "median (%)", "best (%)", "optimistic side, worst (%)",
       "evaluations an element and step", "exact step below h at step", "first violated at step",
       "energy off by 10 % at step", "indefinite at step"},
      {}};
  for (const History& history : monitorHistories(effort)) runHistory(report, table, history);
  report.tables.push_back(std::move(table));
}

void studyCost(StudyReport& report) {
  StudyTable table{"cost",
                   "Monitor over a plain step of symplectic Euler, one thread (bench/ has the same with more care)",
                   {"run", "mode", "elements", "step (ns an element)", "monitor over step (%)", "goal (%)"},
                   {}};
  using Clock = std::chrono::steady_clock;
  const auto seconds = [](Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
  };
  constexpr int cells = 16;  // 102 400 tetrahedra
  struct Mode {
    MonitorMode mode;
    std::string metric;
    std::optional<double> wanted;  // %, of a slow pull
  };
  const Mode modes[] = {{MonitorMode::threshold, "", 8.0},
                        {MonitorMode::bracket, "", 15.0},
                        {MonitorMode::metric, "reduced-1-ring", std::nullopt}};
  for (const auto& [runName, speed] : {std::pair{"slow pull", 0.05}, {"fast pull", 0.4}})
    for (const Mode& mode : modes) {
      Body body(bar("tet4", cells), makeMaterial("stvk", young, poisson, density), [] {
        BodyOptions one;
        one.threads = 1;
        return one;
      }());
      for (const std::int32_t node : body.mesh().nodeSets.at("x-min")) body.constraints().fix(node);
      for (const std::int32_t node : body.mesh().nodeSets.at("x-max")) {
        body.constraints().fix(node);
        body.constraints().move(node, 0, speed);
      }
      const double h = 0.8 * criticalStep(body, body.mesh().X, limit).safe;
      BodySystem system(body);
      State state = gentleStart(system);
      SymplecticEuler integrator;
      MonitorOptions options;
      options.limit = limit;
      options.mode = mode.mode;
      options.metric = mode.metric;
      // Fresh observations of the bracket are rare and dear: a run long enough to hold its share of them.
      const int steps = mode.metric.empty() ? 600 : 10;
      StabilityMonitor monitor(body, options);
      std::vector<double> plain, watched;
      // The first observations start from nothing.
      monitor.observe(0, 0, state.x, state.v, h);
      State unwatched = state;
      StepEvaluation evaluation;
      for (int i = 1; i <= steps; ++i) {
        const auto begin = Clock::now();
        integrator.step(system, unwatched, h);
        const auto observed = Clock::now();
        monitor.observe(i, state.time, state.x, state.v, h, &evaluation);
        system.complete(state, evaluation);
        integrator.advance(system, state, h);
        plain.push_back(std::chrono::duration<double>(observed - begin).count());
        watched.push_back(seconds(observed) - plain.back());
      }
      double plainSum = 0, watchedSum = 0;
      for (double s : plain) plainSum += s;
      for (double s : watched) watchedSum += s;
      const auto elements = static_cast<double>(body.mesh().elementCount());
      std::string name(monitorModeName(mode.mode));
      if (!mode.metric.empty()) name += joinText(" ", mode.metric);
      const bool fast = speed > 0.1;
      const std::optional<double> wanted = mode.mode == MonitorMode::bracket && fast ? 40.0 : mode.wanted;
      table.rows.push_back({std::string(runName), std::move(name), static_cast<std::int64_t>(elements),
                            median(plain) / elements * 1e9, 100 * watchedSum / plainSum,
                            wanted ? StudyTable::Cell(*wanted) : StudyTable::Cell(std::string("-"))});
    }
  report.tables.push_back(std::move(table));
}

}  // namespace ringwatch::detail

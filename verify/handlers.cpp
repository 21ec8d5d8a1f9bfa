#include <ringwatch/verify/handlers.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <limits>
#include <memory>

#include <Eigen/Geometry>

#include <ringwatch/base/error.h>
#include <ringwatch/handlers/handler.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/meshes/generators.h>
#include <ringwatch/monitor/global_frequency.h>
#include <ringwatch/monitor/stability_monitor.h>
#include <ringwatch/verify/cutting.h>
#include <ringwatch/verify/resonance.h>

namespace ringwatch {
namespace {

using Cell = StudyTable::Cell;

constexpr double limit = 2;  // of the base schemes

double highestEigenvalue(const Body& body) {
  if (body.mesh().elementCount() == 0) return 0;
  const GlobalFrequency top = globalFrequency(body, body.mesh().X, 1e-8);
  if (!top.converged) throw NumericalError("verify handlers: a highest frequency did not converge");
  return top.lambda;
}

/// A bar of tetrahedra in which a few inner nodes are pulled most of the way to their neighbours along x.
Mesh barWithSlivers(int refine, double flatness) {
  const std::array<int, 3> cells{10 * refine, 2 * refine, 2 * refine};
  BarOptions options;
  options.size = {0.2, 0.04, 0.04};
  options.cells = cells;
  Mesh mesh = generateBar(options);
  const auto node = [&](int i, int j, int k) { return i + (cells[0] + 1) * (j + (cells[1] + 1) * k); };
  for (int i = 2; i + 2 < cells[0]; i += 3 * refine)
    mesh.X(0, node(i, refine, refine)) +=
        flatness * (mesh.X(0, node(i + 1, refine, refine)) - mesh.X(0, node(i, refine, refine)));
  return mesh;
}

/// The source's cube of 5 cm with small elements at one face: cells grow along x.
Mesh gradedCube(int cells) {
  BarOptions options;
  options.size = {0.05, 0.05, 0.05};
  options.cells = {cells, cells, cells};
  options.grading = 6;
  return generateBar(options);
}

struct Motion {
  std::string name, law;
  std::function<Mesh()> mesh;
  std::function<double(double safe)> step;  // s, from the certified one
  double acceleration;                      // m/s², across the bar
  double end;                               // s

  Body body() const {
    Body b(mesh(), makeMaterial(law, 30e3, 0.3, 1000), {{}, Lumping::rowSum, 1});
    for (const std::int32_t n : b.mesh().nodeSets.at("x-min")) b.constraints().fix(n);
    b.addBodyForce({0, 0, -acceleration});
    return b;
  }
};

struct Variant {
  std::string name, handler;
  HandlerOptions options = {};
  double dissipation = 0.1;
  bool rigid = false;
};
Variant dissipative(std::string name, std::string handler, double dissipation,
                    Selection selection = Selection::certified) {
  return {std::move(name), std::move(handler), {selection, 0.1, {{"dissipation", dissipation}}}, dissipation};
}
std::vector<Variant> allVariants() {
  return {dissipative("imex", "imex", 0.1),
          dissipative("imex, no dissipation", "imex", 0),
          dissipative("imex, dissipation 0.3", "imex", 0.3),
          dissipative("imex, implicit Euler", "imex", 1),
          {"imex, cg", "imex", {.own = {{"solver", "cg"}}}},
          dissipative("imex, fierz-ring", "imex", 0.1, Selection::fierzRing),
          dissipative("local-time-stepping", "local-time-stepping", 0.1),
          dissipative("local-time-stepping, no dissipation", "local-time-stepping", 0),
          dissipative("local-time-stepping, fierz-ring", "local-time-stepping", 0.1, Selection::fierzRing),
          {"fe-pbd", "fe-pbd"},
          {"fe-pbd, three passes", "fe-pbd", {.own = {{"passes", 3}}}},
          {"fe-pbd, rigid", "fe-pbd", {.own = {{"variant", "rigid"}}}, 0.1, true},
          {"modal-filter", "modal-filter"},
          {"mass-scaling", "mass-scaling", {}, 0}};
}

struct Advanced {
  NodeVectors x;
  double seconds;      // of computing
  std::string reason;  // why it was lost; "" when it was not
};
Advanced advance(const Body& body, Integrator& integrator, double end, double h) {
  BodySystem system(body);
  State state = system.initialState();
  const auto steps = static_cast<std::int64_t>(std::llround(end / h));
  Advanced result;
  const std::clock_t start = std::clock();  // what other programs take meanwhile does not count
  for (std::int64_t i = 0; i < steps && result.reason.empty(); ++i)
    result.reason = integrator.step(system, state, end / static_cast<double>(steps)).reason;
  result.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  if (!state.x.allFinite()) result.reason = "positions are not finite";
  result.x = state.x;
  return result;
}

/// The step that divides the end evenly and is at most h.
double evenStep(double end, double h) { return end / std::ceil(end / h - 1e-9); }

void addMotion(const Motion& motion, StudyReport& report, StudyTable& selection, StudyTable& table) {
  const Body plain = motion.body();
  const NodeVectors& X = plain.mesh().X;
  const double safe = criticalStep(plain, X, limit).safe, h = evenStep(motion.end, motion.step(safe));
  const auto verlet = makeIntegrator("verlet"), reference = makeIntegrator("verlet");
  const Advanced exact = advance(plain, *reference, motion.end, evenStep(motion.end, safe / 8));
  const double ownStep = evenStep(motion.end, 0.95 * safe);
  Advanced best = advance(plain, *verlet, motion.end, ownStep);
  const double largest = (exact.x - X).colwise().norm().maxCoeff();
  const auto addRow = [&](const std::string& name, double step, std::int64_t handled, const Advanced& run) {
    const Eigen::VectorXd distance = (run.x - exact.x).colwise().norm();
    const bool lost = !run.reason.empty();
    table.rows.push_back(
        {motion.name, motion.law, name, step / safe, handled, lost ? Cell(run.reason) : Cell(1e3 * distance.mean()),
         lost ? Cell("") : Cell(1e3 * distance.maxCoeff()), lost ? Cell("") : Cell(100 * distance.mean() / largest),
         run.seconds / motion.end, run.seconds / best.seconds});
    return lost ? std::numeric_limits<double>::infinity() : distance.mean() / largest;
  };
  addRow("explicit at its own step", ownStep, 0, best);
  for (const Variant& variant : allVariants()) {
    Body body = motion.body();
    const auto handler = makeHandler(variant.handler, body, makeIntegrator("verlet"), variant.options);
    handler->prepare(X, h);
    const auto handled = static_cast<std::int64_t>(handler->elements().size());
    if (variant.name == "imex" || variant.options.selection == Selection::fierzRing) {
      const double left = highestEigenvalue(handler->explicitBody()) * h * h / (limit * limit);
      selection.rows.push_back({motion.name, motion.law, std::string(selectionNames.nameOf(variant.options.selection)),
                                static_cast<std::int64_t>(body.mesh().elementCount()), handled, std::sqrt(left)});
      if (handler->certified())
        report.checks.push_back({joinText(motion.name, ", ", motion.law, ": h times the rest's highest frequency / 2"),
                                 std::sqrt(left), 0, 1 - variant.options.margin,
                                 std::sqrt(left) <= 1 - variant.options.margin});
    }
    const double error = addRow(variant.name, h, handled, advance(body, *handler, motion.end, h));
    const double allowed = variant.dissipation == 1 ? 0.08 : 0.03;
    // Where most elements are handled passes that carry stress over one element leave the body far too soft: reported.
    const bool passes = variant.handler == "fe-pbd" || variant.handler == "modal-filter";
    if (variant.handler == "imex" || variant.handler == "local-time-stepping" ||
        (passes && 2 * handled < static_cast<std::int64_t>(plain.mesh().elementCount())))
      report.checks.push_back({joinText(motion.name, ", ", motion.law, ", ", variant.name, ": mean error"), error, 0,
                               allowed, error <= allowed});
  }
}

void addEnergies(std::int64_t steps, double h, StudyReport& report) {
  StudyTable table{"energies",
                   joinText("Free bars with slivers, spinning and vibrating, ", steps,
                            " steps at three quarters of the step without slivers"),
                   {"law", "handler", "handled", "least energy", "largest energy", "momentum error",
                    "angular momentum error", "lost"},
                   {}};
  for (const char* law : {"corotational", "stvk"})
    for (const Variant& variant : allVariants()) {
      Body body(barWithSlivers(1, 0.98), makeMaterial(law, 30e3, 0.3, 1000), {{}, Lumping::rowSum, 1});
      const NodeVectors& X = body.mesh().X;
      const auto handler = makeHandler(variant.handler, body, makeIntegrator("verlet"), variant.options);
      handler->prepare(X, h);
      BodySystem system(body);
      State state = system.initialState();
      const Eigen::Vector3d centre = X * body.lumpedMass() / body.totalMass(), spin(0, 6, 0), drift(0.1, 0, 0);
      for (std::int32_t i = 0; i < body.nodeCount(); ++i)
        state.v.col(i) = drift + spin.cross(X.col(i) - centre) + Eigen::Vector3d(0, 0, 0.05 * std::sin(40 * X(0, i)));
      Body::Workspace workspace;
      const auto momentum = [&] { return Eigen::Vector3d(state.v * body.lumpedMass()); };
      const auto angular = [&] {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (std::int32_t i = 0; i < body.nodeCount(); ++i)
          sum += body.lumpedMass()[i] * (state.x.col(i) - centre).cross(state.v.col(i));
        return sum;
      };
      const auto energy = [&] {
        return body.energy(state.x, workspace) + 0.5 * (state.v.colwise().squaredNorm() * body.lumpedMass()).value();
      };
      const double start = energy();
      const Eigen::Vector3d p = momentum(), L = angular();
      double least = start, most = start;
      std::string lost;
      for (std::int64_t i = 0; i < steps && lost.empty(); ++i) {
        lost = handler->step(system, state, h).reason;
        if (i % 50 != 0) continue;
        const double now = energy();
        if (!(now <= 2 * start)) lost = joinText("energy doubled by step ", i);
        least = std::min(least, now);
        most = std::max(most, now);
      }
      const double momentumError = (momentum() - p).norm() / p.norm(), angularError = (angular() - L).norm() / L.norm();
      table.rows.push_back({std::string(law), variant.name, static_cast<std::int64_t>(handler->elements().size()),
                            least / start, most / start, momentumError, angularError, lost});
      // Without dissipation nothing bounds the energy of a tangent that changes in time; how long it lasts is reported.
      // Rigid goals change the stiffness of what they hold, and so the energy that is kept.
      if (variant.dissipation == 0 || variant.rigid) continue;
      const std::string what = joinText(law, ", ", variant.name, ", ", steps, " steps: ");
      report.checks.push_back({what + "largest energy", lost.empty() ? most / start : INFINITY, 1, 0.02,
                               lost.empty() && most <= 1.02 * start});
      constexpr double allowed = 1e-9;
      report.checks.push_back({what + "momentum error", momentumError, 0, allowed, momentumError <= allowed});
      const double turned = variant.handler == "imex" ? 0.05 : (variant.handler == "local-time-stepping" ? 1e-3 : 1e-7);
      report.checks.push_back({what + "angular momentum error", angularError, 0, turned, angularError <= turned});
    }
  report.tables.push_back(std::move(table));
}

}  // namespace

StudyReport verifyHandlers(StudyEffort effort) {
  const bool full = effort == StudyEffort::full;
  StudyReport report;
  report.study = "handlers";
  StudyTable selection{"selection",
                       "What is handled, and h omega / 2 of the rest (stable to 1; certified is chosen to 0.9)",
                       {"case", "law", "selection", "elements", "handled", "h omega/2 of the rest"},
                       {}};
  StudyTable motions{"motions",
                     "Swinging under its weight: error against plain explicit at an eighth of its certified step",
                     {"case", "law", "handler", "step/certified", "handled", "mean error (mm)", "largest error (mm)",
                      "mean error (% of displacement)", "seconds a simulated second", "time/explicit"},
                     {}};
  const int refine = full ? 2 : 1, cells = full ? 10 : 5;
  const double end = full ? 0.1 : 0.05;
  // Three quarters of what the same bar without slivers can take.
  const auto withoutSlivers = [](int fineness) {
    const Body regular(barWithSlivers(fineness, 0), makeMaterial("stvk", 30e3, 0.3, 1000), {{}, Lumping::rowSum, 1});
    return 0.75 * criticalStep(regular, regular.mesh().X, limit).safe;
  };
  const auto sliverStep = [own = withoutSlivers(refine)](double) { return own; };
  for (const char* law : {"corotational", "stvk"}) {
    addMotion({"bar with slivers", law, [&] { return barWithSlivers(refine, 0.98); }, sliverStep, 2, end}, report,
              selection, motions);
    addMotion(
        {"graded cube", law, [&] { return gradedCube(cells); }, [](double safe) { return 0.4 / 0.15 * safe; }, 5, end},
        report, selection, motions);
  }
  report.tables.push_back(std::move(selection));
  report.tables.push_back(std::move(motions));
  addEnergies(full ? 100'000 : 4000, withoutSlivers(1), report);
  addCutting(effort, report);
  addResonance(effort, report);
  return report;
}

}  // namespace ringwatch

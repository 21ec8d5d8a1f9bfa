#include <ringwatch/verify/handlers/handlers.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>

#include <Eigen/Geometry>

#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/parallel.h>
#include <ringwatch/handlers/handler.h>
#include <ringwatch/handlers/imex/imex.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <ringwatch/monitor/stability_monitor.h>
#include <ringwatch/verify/handlers/cutting.h>
#include <ringwatch/verify/handlers/resonance.h>
#include <ringwatch/verify/processor_time.h>
#include <ringwatch/verify/study_bodies.h>

namespace ringwatch {
namespace {

using Cell = StudyTable::Cell;

using namespace detail;

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

/// Fierz 2013's cube of 5 cm with small elements at one face: cells grow along x.
Mesh gradedCube(int cells) {
  BarOptions options;
  options.size = {0.05, 0.05, 0.05};
  options.cells = {cells, cells, cells};
  options.grading = 6;
  return generateBar(options);
}

/// A limit in the quick and in the full form.
struct Allowed {
  constexpr Allowed(double both) : quick(both), full(both) {}
  constexpr Allowed(double inQuick, double inFull) : quick(inQuick), full(inFull) {}
  double quick, full;
  double in(StudyEffort effort) const { return effort == StudyEffort::full ? full : quick; }
};

/// What long runs of free bars may lose or gain; each within three times what was measured.
struct AllowedDrift {
  Allowed energyGrowth;     // of the start
  Allowed momentum;         // relative: rounding, of a sparse factor or of conjugate gradients for imex
  Allowed angularMomentum;  // the same
};

struct Variant {
  std::string name, handler;
  HandlerOptions options;
  bool showsSelection = false;  // in the table of what selections leave to the explicit part
  /// Allowed mean errors over the largest displacement, in both forms. Not held to any: mass scaling, whose own affair
  /// the motion is, and passes that carry stress over one element where most are handled, which leaves the body far too
  /// soft.
  std::optional<double> barError, cubeError;
  /// Empty: without dissipation nothing bounds the energy of a tangent that changes in time, and rigid goals change the
  /// stiffness of what they hold; how long these last is reported.
  std::optional<AllowedDrift> drift;
  /// Long runs of the full form: of these, one with the step itself and each other with a step that is longer by one
  /// more `perturbation`. Several where rounding decides what one does.
  int flights = 1;
};
constexpr double perturbation = 1e-12;  // of the step; the least that changes its bits and those of every run after it
HandlerOptions withDissipation(double dissipation, Selection selection = Selection::certified) {
  return {.selection = selection, .own = {{"dissipation", dissipation}}};
}
/// The same of `imex` with linear equations.
HandlerOptions linearWithDissipation(double dissipation, Selection selection = Selection::certified) {
  HandlerOptions options = withDissipation(dissipation, selection);
  options.own.set("solver", Imex::linear);
  return options;
}
// The energy swings by a share of the step with explicit elements close to their limit: 2.8e-5 to 3.3e-5 of it.
constexpr Allowed swing{9e-5};
// Conjugate gradients to 2e-3, the default, err at random: over 48 flights of 100 000 steps the energy grew by 1e-5 to
// 2.4e-3.
constexpr Allowed loosely{9e-5, 7e-3};
constexpr Allowed solved{4e-12, 2e-11};       // momentum after solves: 2.6e-13 to 1.9e-12 by build
constexpr Allowed exchanged{2e-14, 1.5e-13};  // momentum that nodes exchange
constexpr Allowed turned{2e-14, 5e-12};       // the same of angular momentum
// `imex` with linear equations, those of the tables of docs/handlers.md.
std::vector<Variant> allVariants() {
  std::vector<Variant> all{
      {.name = "imex",
       .handler = "imex",
       .options = linearWithDissipation(0.1),
       .showsSelection = true,
       .barError = 3e-4,
       .cubeError = 0.011,
       .drift = AllowedDrift{5e-5, solved, solved}},
      {.name = "imex, no dissipation",
       .handler = "imex",
       .options = linearWithDissipation(0),
       .barError = 2.5e-4,
       .cubeError = 4.5e-3,
       .drift = {}},
      {.name = "imex, dissipation 0.3",
       .handler = "imex",
       .options = linearWithDissipation(0.3),
       .barError = 4e-4,
       .cubeError = 0.03,
       .drift = AllowedDrift{swing, solved, solved}},
      {.name = "imex, implicit Euler",
       .handler = "imex",
       .options = linearWithDissipation(1),
       .barError = 9e-4,
       .cubeError = 0.08,
       .drift = AllowedDrift{swing, solved, solved}},
      {.name = "imex, cg",
       .handler = "imex",
       .options = {.own = {{"solver", "cg"}}},
       .barError = 3.6e-4,
       .cubeError = 0.011,
       .drift = AllowedDrift{loosely, solved, solved},
       .flights = 24},
      {.name = "imex, cg to 1e-6",
       .handler = "imex",
       .options = {.own = {{"solver", "cg"}, {"tolerance", 1e-6}}},
       .barError = 3e-4,
       .cubeError = 0.011,
       .drift = AllowedDrift{5e-5, solved, solved}},
      {.name = "imex, fierz-ring",
       .handler = "imex",
       .options = linearWithDissipation(0.1, Selection::fierzRing),
       .showsSelection = true,
       .barError = 9e-4,
       .cubeError = 0.012,
       .drift = AllowedDrift{5e-5, solved, solved}},
      {.name = "local-time-stepping",
       .handler = "local-time-stepping",
       .options = withDissipation(0.1),
       .barError = 8e-4,
       .cubeError = 0.012,
       .drift = AllowedDrift{3.5e-5, exchanged, turned}},
      {.name = "local-time-stepping, no dissipation",
       .handler = "local-time-stepping",
       .options = withDissipation(0),
       .barError = 2.8e-4,
       .cubeError = 3.2e-3,
       .drift = {}},
      {.name = "local-time-stepping, fierz-ring",
       .handler = "local-time-stepping",
       .options = withDissipation(0.1, Selection::fierzRing),
       .showsSelection = true,
       .barError = 8.5e-4,
       .cubeError = 0.013,
       .drift = AllowedDrift{4e-5, exchanged, turned}},
      {.name = "fe-pbd",
       .handler = "fe-pbd",
       .options = {},
       .barError = 9e-4,
       .cubeError = {},
       .drift = AllowedDrift{swing, exchanged, turned}},
      {.name = "fe-pbd, three passes",
       .handler = "fe-pbd",
       .options = {.own = {{"passes", 3}}},
       .barError = 8e-4,
       .cubeError = {},
       .drift = AllowedDrift{swing, exchanged, turned}},
      {.name = "fe-pbd, rigid",
       .handler = "fe-pbd",
       .options = {.own = {{"variant", "rigid"}}},
       .barError = 0.03,
       .cubeError = {},
       .drift = {}},
      {.name = "modal-filter",
       .handler = "modal-filter",
       .options = {},
       .barError = 7e-4,
       .cubeError = {},
       .drift = AllowedDrift{swing, exchanged, turned}},
      {.name = "mass-scaling", .handler = "mass-scaling", .options = {}, .barError = {}, .cubeError = {}, .drift = {}}};
  // fe-pbd and modal-filter are there where a program has registered them.
  std::erase_if(all, [](const Variant& variant) { return findHandler(variant.handler) == nullptr; });
  return all;
}

struct HandledMotion {
  std::string name, law;
  std::function<Mesh()> mesh;
  std::function<double(double safe)> step;  // s, from the certified one
  double acceleration;                      // m/s², across the bar
  double end;                               // s
  std::optional<double> Variant::*allowed;  // mean error

  Body body() const {
    Body b(mesh(), makeMaterial(law, young, poisson, density), {{}, Lumping::rowSum, 1});
    for (const std::int32_t n : b.mesh().nodeSets.at("x-min")) b.constraints().fix(n);
    b.addBodyForce({0, 0, -acceleration});
    return b;
  }
};

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
  const double start = processorSeconds();
  for (std::int64_t i = 0; i < steps && result.reason.empty(); ++i)
    result.reason = integrator.step(system, state, end / static_cast<double>(steps)).reason;
  result.seconds = processorSeconds() - start;
  if (!state.x.allFinite()) result.reason = "positions are not finite";
  result.x = state.x;
  return result;
}

/// The step that divides the end evenly and is at most h.
double evenStep(double end, double h) { return end / std::ceil(end / h - 1e-9); }

/// One way through a motion.
struct MotionRun {
  std::string name;
  double step, safe;               // s
  std::int64_t handled;            // elements
  double meanError, largestError;  // m
  double displacement;             // m, the largest of the exact motion
  double seconds, own;             // of computing; of plain explicit at its own step
  std::string lost;

  double relativeError() const { return lost.empty() ? meanError / displacement : infinity; }
};
std::vector<Cell> rowOf(const HandledMotion& motion, const MotionRun& run) {
  const bool lost = !run.lost.empty();
  return {motion.name,
          motion.law,
          run.name,
          run.step / run.safe,
          run.handled,
          lost ? Cell(run.lost) : Cell(1e3 * run.meanError),
          lost ? Cell("") : Cell(1e3 * run.largestError),
          lost ? Cell("") : Cell(100 * run.meanError / run.displacement),
          run.seconds / motion.end,
          run.seconds / run.own};
}

void addMotion(const HandledMotion& motion, StudyReport& report, StudyTable& selection, StudyTable& table) {
  const Body plain = motion.body();
  const NodeVectors& X = plain.mesh().X;
  const double safe = criticalStep(plain, X, verletLimit).safe, h = evenStep(motion.end, motion.step(safe));
  const auto verlet = makeIntegrator("verlet"), reference = makeIntegrator("verlet");
  const Advanced exact = advance(plain, *reference, motion.end, evenStep(motion.end, safe / 8));
  const double ownStep = evenStep(motion.end, 0.95 * safe);
  const Advanced own = advance(plain, *verlet, motion.end, ownStep);
  const auto compared = [&](const std::string& name, double step, std::int64_t handled, const Advanced& run) {
    const Eigen::VectorXd distance = (run.x - exact.x).colwise().norm();
    return MotionRun{.name = name,
                     .step = step,
                     .safe = safe,
                     .handled = handled,
                     .meanError = distance.mean(),
                     .largestError = distance.maxCoeff(),
                     .displacement = (exact.x - X).colwise().norm().maxCoeff(),
                     .seconds = run.seconds,
                     .own = own.seconds,
                     .lost = run.reason};
  };
  table.rows.push_back(rowOf(motion, compared("explicit at its own step", ownStep, 0, own)));
  for (const Variant& variant : allVariants()) {
    Body body = motion.body();
    const auto handler = makeHandler(variant.handler, body, makeIntegrator("verlet"), variant.options);
    handler->prepare(X, h);
    const std::int64_t handled = handler->elements().size();
    if (variant.showsSelection) {
      const double left = highestEigenvalue(handler->explicitBody(), 1e-8) * h * h / (verletLimit * verletLimit);
      selection.rows.push_back({motion.name, motion.law, std::string(selectionNames.nameOf(variant.options.selection)),
                                static_cast<std::int64_t>(body.mesh().elementCount()), handled, std::sqrt(left)});
      if (handler->certified())
        checkBelow(report,
                   joinText(motion.name, ", ", motion.law, ": h times the explicit part's highest frequency / 2"),
                   std::sqrt(left), 1 - variant.options.margin.value_or(marginFor(handler->handlerInfo(), body)));
    }
    const MotionRun run = compared(variant.name, h, handled, advance(body, *handler, motion.end, h));
    table.rows.push_back(rowOf(motion, run));
    if (const std::optional<double> allowed = variant.*motion.allowed)
      checkBelow(report, joinText(motion.name, ", ", motion.law, ", ", variant.name, ": mean error"),
                 run.relativeError(), *allowed);
  }
}

/// A free bar with slivers that spins and vibrates, and what becomes of what it should keep.
struct FreeFlight {
  std::int64_t handled = 0;                    // elements
  double leastEnergy = 1, largestEnergy = 1;   // over that at the start
  double momentumError = 0, angularError = 0;  // relative
  std::string lost;
};
FreeFlight fly(const char* law, const Variant& variant, std::int64_t steps, double h) {
  Body body(barWithSlivers(1, 0.98), makeMaterial(law, young, poisson, density), {{}, Lumping::rowSum, 1});
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
  FreeFlight flight;
  flight.handled = static_cast<std::int64_t>(handler->elements().size());
  for (std::int64_t i = 0; i < steps && flight.lost.empty(); ++i) {
    flight.lost = handler->step(system, state, h).reason;
    if (i % 50 != 0) continue;
    const double now = energy() / start;
    if (!(now <= 2)) flight.lost = joinText("energy doubled by step ", i);
    flight.leastEnergy = std::min(flight.leastEnergy, now);
    flight.largestEnergy = std::max(flight.largestEnergy, now);
  }
  flight.momentumError = (momentum() - p).norm() / p.norm();
  flight.angularError = (angular() - L).norm() / L.norm();
  return flight;
}

void addEnergies(StudyEffort effort, double h, StudyReport& report) {
  const std::int64_t steps = effort == StudyEffort::full ? 100'000 : 4000;
  StudyTable table{"energies",
                   joinText("Free bars with slivers, spinning and vibrating, ", steps,
                            " steps at three quarters of the step without slivers"),
                   {"law", "handler", "handled", "least energy", "largest energy", "momentum error",
                    "angular momentum error", "lost"},
                   {}};
  StudyTable perturbed{"perturbed",
                       joinText("The same where rounding decides: each flight's step is longer than the one before by ",
                                perturbation, " of itself"),
                       {"law", "handler", "flight", "largest energy", "angular momentum error"},
                       {}};
  for (const char* law : {"corotational", "stvk"})
    for (const Variant& variant : allVariants()) {
      std::vector<FreeFlight> flights(effort == StudyEffort::full ? static_cast<std::size_t>(variant.flights) : 1);
      parallelFor(0, flights.size(), 0, [&](std::int64_t k) {
        flights[k] = fly(law, variant, steps, h * (1 + static_cast<double>(k) * perturbation));
      });
      FreeFlight worst = flights.front();
      for (std::size_t k = 0; k < flights.size(); ++k) {
        const FreeFlight& flight = flights[k];
        if (flights.size() > 1)
          perturbed.rows.push_back({std::string(law), variant.name, static_cast<std::int64_t>(k), flight.largestEnergy,
                                    flight.angularError});
        worst.leastEnergy = std::min(worst.leastEnergy, flight.leastEnergy);
        worst.largestEnergy = std::max(worst.largestEnergy, flight.largestEnergy);
        worst.momentumError = std::max(worst.momentumError, flight.momentumError);
        worst.angularError = std::max(worst.angularError, flight.angularError);
        if (worst.lost.empty()) worst.lost = flight.lost;
      }
      table.rows.push_back({std::string(law), variant.name, worst.handled, worst.leastEnergy, worst.largestEnergy,
                            worst.momentumError, worst.angularError, worst.lost});
      if (!variant.drift) continue;
      const std::string what = joinText(law, ", ", variant.name, ", ", steps, " steps: ");
      checkAtMost(report, what + "largest energy", worst.lost.empty() ? worst.largestEnergy : infinity, 1,
                  variant.drift->energyGrowth.in(effort));
      checkBelow(report, what + "momentum error", worst.momentumError, variant.drift->momentum.in(effort));
      checkBelow(report, what + "angular momentum error", worst.angularError,
                 variant.drift->angularMomentum.in(effort));
    }
  report.tables.push_back(std::move(table));
  if (!perturbed.rows.empty()) report.tables.push_back(std::move(perturbed));
}

}  // namespace

StudyReport verifyHandlers(StudyEffort effort) {
  const bool full = effort == StudyEffort::full;
  StudyReport report;
  report.study = "handlers";
  StudyTable selection{
      "selection",
      "What is handled, and h omega / 2 of the explicit part (stable to 1; certified is chosen to 0.9)",
      {"case", "law", "selection", "elements", "handled", "h omega/2 of the explicit part"},
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
    const Body regular(barWithSlivers(fineness, 0), makeMaterial("stvk", young, poisson, density),
                       {{}, Lumping::rowSum, 1});
    return 0.75 * criticalStep(regular, regular.mesh().X, verletLimit).safe;
  };
  const auto sliverStep = [own = withoutSlivers(refine)](double) { return own; };
  for (const char* law : {"corotational", "stvk"}) {
    addMotion({.name = "bar with slivers",
               .law = law,
               .mesh = [&] { return barWithSlivers(refine, 0.98); },
               .step = sliverStep,
               .acceleration = 2,
               .end = end,
               .allowed = &Variant::barError},
              report, selection, motions);
    addMotion({.name = "graded cube",
               .law = law,
               .mesh = [&] { return gradedCube(cells); },
               .step = [](double safe) { return 0.4 / 0.15 * safe; },
               .acceleration = 5,
               .end = end,
               .allowed = &Variant::cubeError},
              report, selection, motions);
  }
  report.tables.push_back(std::move(selection));
  report.tables.push_back(std::move(motions));
  addEnergies(effort, withoutSlivers(1), report);
  addCutting(effort, report);
  addResonance(effort, report);
  return report;
}

}  // namespace ringwatch

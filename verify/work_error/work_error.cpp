#include <ringwatch/verify/work_error/work_error.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <ringwatch/base/error.h>
#include <ringwatch/handlers/handler.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/monitor/critical_step.h>
#include <ringwatch/monitor/metrics/metrics.h>
#include <ringwatch/verify/static_solver.h>
#include <ringwatch/verify/study_bodies.h>
#include <ringwatch/verify/work_precision/work_precision.h>

namespace ringwatch {
namespace {

using detail::highestEigenvalue, detail::nan, detail::verletLimit;

constexpr double barLength = 0.2, barWidth = 0.04;  // m
constexpr double gravity = 0.3;                     // m/s²: strains of some per cent
constexpr double heldShare = 0.08;                  // of the extent along x
constexpr double periods = 0.65;                    // of the first vibration: past its first turning point
constexpr double ofTheReference = 1e-6;             // change of the reference's end when its step is halved, relative
constexpr double goodError = 0.01;

BarOptions barOptions(std::array<int, 3> cells, double jitter = 0, std::string_view element = "tet4") {
  BarOptions options;
  options.size = {barLength, barWidth, barWidth};
  options.cells = cells;
  options.jitter = jitter;
  options.element = element;
  return options;
}

/// A regular bar whose inner nodes, every so many along x, are pulled toward their next ones by a share of a cell.
Mesh barWithSlivers(double flatness, int every) {
  constexpr std::array<int, 3> cells{10, 2, 2};
  Mesh mesh = generateBar(barOptions(cells));
  const auto node = [&](int i) { return i + (cells[0] + 1) * (1 + (cells[1] + 1)); };
  for (int i = 2; i + 2 < cells[0]; i += every)
    mesh.X(0, node(i)) += flatness * (mesh.X(0, node(i + 1)) - mesh.X(0, node(i)));
  return mesh;
}

struct BodyInfo {
  std::string_view name, file;
  std::function<Mesh()> mesh;
  bool quick = false;
};
std::vector<BodyInfo> allBodies() {
  const auto graded = [](std::string_view element, double grading) {
    BarOptions options = barOptions({10, 2, 2}, 0, element);
    options.grading = grading;
    return generateBar(options);
  };
  return {{"bar, jitter", "bar-jitter",
           [] {
             return generateBar(barOptions({10, 2, 2}, 0.3));
           },
           true},
          {"bar, more jitter", "bar-more-jitter",
           [] {
             return generateBar(barOptions({12, 3, 3}, 0.35));
           }},
          {"bar, graded", "bar-graded", [=] { return graded("tet4", 5); }, true},
          {"bar, one sliver", "bar-one-sliver",
           [] {
             Mesh mesh = generateBar(barOptions({10, 2, 2}));
             detail::flattenOneElement(mesh, 0.05);
             return mesh;
           }},
          {"bar, slivers", "bar-slivers", [] { return barWithSlivers(0.9, 3); }},
          {"bar, flat slivers", "bar-flat-slivers", [] { return barWithSlivers(0.97, 2); }},
          {"bar, refined", "bar-refined",
           [] {
             RefinedBarOptions options;
             options.coarse = barOptions({10, 2, 2}, 0.15);
             options.finest = 0.01;
             options.growth = 0.5;
             options.plane = barLength / 2;
             return generateRefinedBar(options);
           }},
          {"bar of hexahedra", "bar-hex8",
           [] {
             return generateBar(barOptions({10, 2, 2}, 0.25, "hex8"));
           }},
          {"bar of hexahedra, graded", "bar-hex8-graded", [=] { return graded("hex8", 8); }},
          {"bar of quadratic tetrahedra", "bar-tet10",
           [] {
             return generateBar(barOptions({8, 2, 2}, 0.15, "tet10"));
           }},
          {"ball", "ball",
           [] {
             BallOptions options;
             options.radius = barLength / 2;
             options.cells = 6;
             return generateBall(options);
           }},
          {"ring", "ring", [] {
             RingOptions options;
             options.radius = barLength / 2;
             options.inner = 0.7 * options.radius;
             options.width = barWidth;
             options.cells = {24, 2, 2};
             return generateRing(options);
           }}};
}

Body bodyOf(const BodyInfo& info) {
  Body body(info.mesh(), makeMaterial("stvk", detail::young, detail::poisson, detail::density),
            {{}, Lumping::rowSum, 1});
  const double low = body.mesh().X.row(0).minCoeff(), extent = body.mesh().X.row(0).maxCoeff() - low;
  for (std::int32_t node = 0; node < body.nodeCount(); ++node)
    if (body.mesh().X(0, node) < low + heldShare * extent) body.constraints().fix(node);
  body.addBodyForce({0, 0, -gravity});
  return body;
}

/// What a run answers.
struct Answer {
  NodeVectors x;         // m
  double energy = nan;   // strain energy at the end, J
  double turning = nan;  // when the far end first turns, s
};

/// An integrator that notes when the mean of the far end's nodes first turns upwards, by the parabola through three
/// heights.
class Observed final : public Integrator {
 public:
  Observed(std::unique_ptr<Integrator> inner, const Mesh& mesh, double& turning)
      : inner_(std::move(inner)), turning_(turning) {
    const double high = mesh.X.row(0).maxCoeff(), extent = high - mesh.X.row(0).minCoeff();
    for (Eigen::Index i = 0; i < mesh.X.cols(); ++i)
      if (mesh.X(0, i) > high - heldShare * extent) nodes_.push_back(i);
    turning_ = nan;
  }
  const IntegratorInfo& info() const override { return inner_->info(); }
  StepStatus step(SecondOrderSystem& system, State& state, double h) override {
    const StepStatus status = inner_->step(system, state, h);
    double height = 0;
    for (const Eigen::Index i : nodes_) height += state.x(2, i);
    if (++steps_ > 2 && std::isnan(turning_) && height > before_ && before_ <= last_) {
      const double down = last_ - before_, up = height - before_;
      turning_ = state.time - h + 0.5 * h * (down - up) / (down + up);
    }
    last_ = before_;
    before_ = height;
    return status;
  }

 private:
  std::unique_ptr<Integrator> inner_;
  double& turning_;
  std::vector<Eigen::Index> nodes_;
  double last_ = 0, before_ = 0;  // sums of heights, m
  std::int64_t steps_ = 0;
};

struct Run {
  std::string rule, method;
  double share;  // of the rule's step
  WorkPrecisionRun cost;
  double energyError, frequencyError;
};

/// A body that swings, and its converged answer.
class Swing {
 public:
  explicit Swing(const BodyInfo& info)
      : info_(info), body_(bodyOf(info)), system_(body_), start_(system_.initialState()) {
    const NodeVectors& X = body_.mesh().X;
    lambda_ = highestEigenvalue(body_, 1e-9);
    NodeVectors guess = NodeVectors::Zero(3, X.cols());
    guess.row(2) = (X.row(0).array() - X.row(0).minCoeff()).square().matrix();
    const NearestMode first = nearestMode(body_, X, guess);
    if (!first.converged) throw NumericalError("work-error: " + std::string(info.name) + ": no first vibration");
    linearFrequency_ = std::sqrt(first.lambda) / (2 * std::numbers::pi);
    end_ = periods / linearFrequency_;
    const ConvergedMotion motion = convergedMotion(system_, start_, end_, lambda_, ofTheReference);
    change_ = motion.change;
    reference_.x = motion.x;
    run("reference", "pefrl", 1, motion.h, [] { return makeIntegrator("pefrl"); });
    reference_ = answer_;
    reference_.x = motion.x;
  }
  const Body& body() const { return body_; }
  double lambda() const { return lambda_; }
  double linearFrequency() const { return linearFrequency_; }
  double frequency() const { return 0.5 / reference_.turning; }  // Hz, half a period until it turns
  double change() const { return change_; }

  Run run(std::string rule, const std::string& method, double share, double h,
          const std::function<std::unique_ptr<Integrator>()>& make) {
    return runBy(std::move(rule), method, share, h, [&](double) {
      return PreparedRun{std::make_unique<Observed>(make(), body_.mesh(), answer_.turning),
                         std::make_unique<BodySystem>(body_)};
    });
  }
  /// By a handler, on a body of its own, whose masses it may change.
  Run runHandled(const std::string& name, double share, double h) {
    return runBy("handler", name, share, h, [&](double step) {
      auto own = std::make_shared<Body>(bodyOf(info_));
      auto handler = makeHandler(name, *own, makeIntegrator("verlet"));
      handler->prepare(own->mesh().X, step);
      return PreparedRun{std::make_unique<Observed>(std::move(handler), own->mesh(), answer_.turning),
                         std::make_unique<BodySystem>(*own), own};
    });
  }

 private:
  Run runBy(std::string rule, const std::string& method, double share, double h,
            const std::function<PreparedRun(double)>& prepare) {
    const WorkPrecisionCase c{std::string(info_.name),
                              std::string(info_.name),
                              system_,
                              start_,
                              end_,
                              lambda_,
                              reference_.x,
                              change_,
                              {},
                              [&](const State& end) {
                                Body::Workspace workspace;
                                answer_.energy = body_.energy(end.x, workspace);
                                return (end.x - reference_.x).norm() / (reference_.x - start_.x).norm();
                              }};
    answer_.energy = nan;
    WorkPrecisionRun cost = runPrepared(c, method, h, prepare);
    if (!(cost.error < 1)) {  // further off than not to move at all
      cost.error = nan;
      if (cost.reason.empty()) cost.reason = "the error is above 100 %";
    }
    const bool lost = !cost.reason.empty();
    return {std::move(rule),
            method,
            share,
            std::move(cost),
            lost ? nan : std::abs(answer_.energy / reference_.energy - 1),
            lost ? nan : std::abs(reference_.turning / answer_.turning - 1)};
  }

  const BodyInfo& info_;
  Body body_;
  BodySystem system_;
  State start_;
  double lambda_ = 0, linearFrequency_ = 0, end_ = 0, change_ = 0;
  Answer reference_, answer_;
};

constexpr std::array<double, 3> shares{0.9, 0.45, 0.225};  // 0.9: the factor of safety of most codes
constexpr std::array<double, 3> multiples{2, 4, 8};        // of the proven step, for handlers

std::vector<Run> runsOf(Swing& swing, double usual) {
  std::vector<Run> runs;
  for (const char* const name : {"symplectic-euler", "verlet", "pefrl"}) {
    const double limit = makeIntegrator(name)->info().imaginaryLimit;
    const double safe = criticalStep(swing.body(), swing.body().mesh().X, limit).safe;
    for (const double share : shares)
      runs.push_back(swing.run("proven", name, share, share * safe, [&] { return makeIntegrator(name); }));
    if (limit != verletLimit) continue;
    for (const double share : shares)
      runs.push_back(swing.run("pressure-wave", name, share, share * usual, [&] { return makeIntegrator(name); }));
  }
  const double safe = criticalStep(swing.body(), swing.body().mesh().X, verletLimit).safe;
  for (const HandlerEntry& entry : allHandlers())
    for (const double multiple : multiples) try {
        runs.push_back(swing.runHandled(std::string(entry.info->name), multiple, multiple * safe));
      } catch (const InputError&) {
        // The handler does not take this body at this step.
      }
  return runs;
}

void addRun(const BodyInfo& info, const Run& run, StudyTable& table, StudyFigure& figure,
            std::map<std::string, std::size_t>& curveOf) {
  const WorkPrecisionRun& cost = run.cost;
  table.rows.push_back({std::string(info.name), run.rule, run.method, run.share, cost.h, cost.error, run.energyError,
                        run.frequencyError, cost.seconds, cost.reason});
  if (!cost.reason.empty()) return;
  const std::string label = joinText(run.method, ", ", run.rule);
  const auto [at, isNew] = curveOf.try_emplace(label, figure.curves.size());
  if (isNew) figure.curves.push_back({label, {}, {}});
  figure.curves[at->second].x.push_back(cost.seconds);
  figure.curves[at->second].y.push_back(cost.error);
}

/// The quickest run of a rule with a good displacement; nullptr for none.
const Run* cheapest(const std::vector<Run>& runs, std::string_view rule) {
  const Run* best = nullptr;
  for (const Run& run : runs)
    if (run.rule == rule && run.cost.error <= goodError && (best == nullptr || run.cost.seconds < best->cost.seconds))
      best = &run;
  return best;
}

/// Errors fall by the order of the scheme; half of that is asked for, since two steps are far from the limit.
void checkOrder(const BodyInfo& info, const std::vector<Run>& runs, double referenceError, StudyReport& report) {
  const auto error = [&](double share) {
    const auto run = std::ranges::find_if(
        runs, [&](const Run& r) { return r.rule == "proven" && r.method == "verlet" && r.share == share; });
    return run == runs.end() ? nan : run->cost.error;
  };
  constexpr double rounding = 10;  // times the reference's error
  const double ratio = shares.front() / shares.back();
  checkAtMost(
      report, std::string(info.name) + ": verlet, displacement error at a fourth of the step over that at the whole",
      error(shares.back()) / error(shares.front()), 1 / ratio, rounding * referenceError / error(shares.front()));
}

}  // namespace

StudyReport verifyWorkError(StudyEffort effort) {
  constexpr std::array<std::string_view, 3> rules{"proven", "pressure-wave", "handler"};
  StudyReport report{"work-error", {}, {}, {}};
  StudyTable bodies{"bodies",
                    "Bodies of St. Venant-Kirchhoff, held at one side, under gravity",
                    {"body", "elements", "nodes", "proven step (s)", "pressure-wave step (s)", "exact step (s)",
                     "first frequency, linear (Hz)", "first frequency (Hz)"},
                    {},
                    {"name", "number of elements", "number of nodes", "safe side of the bracket at rest, of verlet",
                     "least height over the speed of pressure waves", "2/omega of the highest frequency at rest",
                     "of the tangent at rest", "a half over the time until the far end turns, converged"}};
  StudyTable all{
      "runs",
      "Runs over 0.65 periods of the first vibration: errors at the end, and their cost",
      {"body", "rule", "method", "share", "h (s)", "displacement error", "energy error", "frequency error", "time (s)",
       "lost"},
      {},
      {"name", "what the step is a share of: proven, pressure-wave, or the proven one for handlers",
       "integrator, or handler on verlet", "of the rule's step", "step of the run",
       "of positions against the reference's, over its displacement", "of the strain energy, relative",
       "of the time until the far end turns, relative", "of the processor, one thread, the best of up to three",
       "why the run was lost; empty when it was not"}};
  StudyTable best{"cheapest",
                  "Quickest run with a displacement error of at most 1 %",
                  {"body", "rule", "method", "h (s)", "displacement error", "time (s)", "time over that of proven"},
                  {},
                  {"name", "see runs", "see runs", "see runs", "see runs", "see runs",
                   "over that of the quickest run in a share of the proven step"}};
  StudyTable lost{"lost",
                  "Runs that were lost",
                  {"rule", "runs", "lost", "bodies with a lost run"},
                  {},
                  {"see runs", "number of runs", "number that were lost", "number of bodies"}};
  struct Count {
    std::int64_t runs = 0, lost = 0, bodies = 0;
  };
  std::map<std::string_view, Count> counts;
  for (const BodyInfo& info : allBodies()) {
    if (effort == StudyEffort::quick && !info.quick) continue;
    Swing swing(info);
    const NodeVectors& X = swing.body().mesh().X;
    const double usual = stepFor(evaluateMetric("pressure-wave", swing.body(), X).lambda, verletLimit);
    bodies.rows.push_back({std::string(info.name), static_cast<std::int64_t>(swing.body().mesh().elementCount()),
                           std::int64_t{swing.body().nodeCount()}, criticalStep(swing.body(), X, verletLimit).safe,
                           usual, stepFor(swing.lambda(), verletLimit), swing.linearFrequency(), swing.frequency()});
    StudyFigure figure{joinText("work-error-", info.file),
                       joinText("Error against time: ", info.name),
                       "time of the processor, one thread (s)",
                       "relative error of the displacement",
                       true,
                       true,
                       {}};
    std::map<std::string, std::size_t> curveOf;
    const std::vector<Run> runs = runsOf(swing, usual);
    for (const Run& run : runs) addRun(info, run, all, figure, curveOf);
    report.figures.push_back(std::move(figure));
    const Run* const proven = cheapest(runs, rules[0]);
    for (const std::string_view rule : rules) {
      const auto ofRule = [&](const Run& run) { return run.rule == rule; };
      const auto isLost = [&](const Run& run) { return ofRule(run) && !run.cost.reason.empty(); };
      Count& count = counts[rule];
      count.runs += std::ranges::count_if(runs, ofRule);
      count.lost += std::ranges::count_if(runs, isLost);
      count.bodies += std::ranges::any_of(runs, isLost) ? 1 : 0;
      if (const Run* const run = cheapest(runs, rule))
        best.rows.push_back({std::string(info.name), std::string(rule), run->method, run->cost.h, run->cost.error,
                             run->cost.seconds, proven ? run->cost.seconds / proven->cost.seconds : nan});
    }
    checkBelow(report, std::string(info.name) + ": change of the reference when its step is halved", swing.change(),
               1e-5);  // convergedMotion's own limit
    checkOrder(info, runs, swing.change(), report);
  }
  for (const std::string_view rule : rules)
    lost.rows.push_back({std::string(rule), counts[rule].runs, counts[rule].lost, counts[rule].bodies});
  checkNear(report, "runs in shares of the proven step that were lost", static_cast<double>(counts["proven"].lost), 0,
            0);
  for (StudyTable* table : {&bodies, &all, &best, &lost}) report.tables.push_back(std::move(*table));
  return report;
}

}  // namespace ringwatch

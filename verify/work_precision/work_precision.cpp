#include <ringwatch/verify/work_precision/work_precision.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/integrators/partitioned_body_system.h>
#include <ringwatch/integrators/stability_limit.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <ringwatch/monitor/metrics/stiff_elements.h>
#include <ringwatch/verify/processor_time.h>
#include <ringwatch/verify/study_bodies.h>

namespace ringwatch {
namespace {

using detail::highestEigenvalue, detail::nan;

struct Counts {
  double forces = 0, products = 0, matrices = 0;
};

/// Counts the forces of another system, each as `weight`.
template <class System>
class CountedForces : public System {
 public:
  CountedForces(System& inner, Counts& counts, double weight) : inner_(inner), counts_(counts), weight_(weight) {}
  void acceleration(double t, const NodeVectors& x, const NodeVectors& v, NodeVectors& a) override {
    counts_.forces += weight_;
    inner_.acceleration(t, x, v, a);
  }
  int threads() const override { return inner_.threads(); }
  bool velocityDependent() const override { return inner_.velocityDependent(); }

 protected:
  System& inner_;
  Counts& counts_;
  double weight_;
};

/// Counts tangent products and matrices as well.
class Counted final : public CountedForces<DifferentiableSystem> {
 public:
  Counted(DifferentiableSystem& inner, Counts& counts, double weight = 1) : CountedForces(inner, counts, weight) {}
  const Eigen::VectorXd& mass() const override { return inner_.mass(); }
  RayleighDamping damping() const override { return inner_.damping(); }
  void stiffnessProduct(const NodeVectors& x, const NodeVectors& u, NodeVectors& Ku) override {
    counts_.products += weight_;
    inner_.stiffnessProduct(x, u, Ku);
  }
  Eigen::SparseMatrix<double> stiffness(const NodeVectors& x) override {
    counts_.matrices += weight_;
    return inner_.stiffness(x);
  }
  void stiffnessDiagonal(const NodeVectors& x, std::vector<Eigen::Matrix3d>& blocks) override {
    counts_.matrices += weight_;
    inner_.stiffnessDiagonal(x, blocks);
  }
  bool isConstrained(std::int32_t node, int component) const override { return inner_.isConstrained(node, component); }
};

class CountedParts final : public AdditiveSystem {
 public:
  CountedParts(WorkPrecisionCase::Parts parts, Counts& counts)
      : system_(std::move(parts.system)),
        nonstiff_(system_->nonstiff(), counts, 1 - parts.stiffShare),
        stiff_(system_->stiff(), counts, parts.stiffShare) {}
  SecondOrderSystem& nonstiff() override { return nonstiff_; }
  DifferentiableSystem& stiff() override { return stiff_; }
  bool velocityDependent() const override { return system_->velocityDependent(); }

 private:
  std::unique_ptr<AdditiveSystem> system_;
  CountedForces<SecondOrderSystem> nonstiff_;
  Counted stiff_;
};

double secondsOf(const std::function<void()>& work) {
  const double begin = threadSeconds();
  work();
  return threadSeconds() - begin;
}

/// "" or why a run to `end` in equal steps was lost.
std::string advance(Integrator& integrator, SecondOrderSystem& system, State& state, double end, std::int64_t steps) {
  for (std::int64_t k = 0; k < steps; ++k) {
    const StepStatus status = integrator.step(system, state, end / static_cast<double>(steps));
    if (!status.done) return status.reason;
    // Examined now and then: what is lost need not be computed to its end.
    if (k % 64 == 63 && !state.x.allFinite()) return joinText("positions are not finite after step ", k + 1);
  }
  return state.x.allFinite() ? std::string() : std::string("positions are not finite at the end");
}

WorkPrecisionRun runOne(const WorkPrecisionCase& c, const IntegratorEntry& entry, double h) {
  Counts counts;
  WorkPrecisionRun run = runPrepared(c, entry.info->name, h, [&](double step) {
    counts = {};
    PreparedRun prepared{entry.make(), nullptr};
    if (entry.info->partitioned)
      prepared.system = std::make_unique<CountedParts>(c.split(*entry.info, step), counts);
    else
      prepared.system = std::make_unique<Counted>(c.system, counts);
    return prepared;
  });
  run.forces = counts.forces;
  run.products = counts.products;
  run.matrices = counts.matrices;
  return run;
}

std::vector<double> stepsFor(const WorkPrecisionCase& c, const IntegratorInfo& info,
                             const WorkPrecisionOptions& options) {
  if (!options.steps.empty()) return options.steps;
  // Implicit ones start where they resolve the slow motion alone, partitioned ones in between.
  constexpr double implicitStart = 40, partitionedStart = 8, share = 0.9;
  const double omega = std::sqrt(c.lambda);
  double largest = 0;
  if (std::isinf(info.imaginaryLimit))
    largest = implicitStart / omega;
  else if (info.partitioned)
    largest = partitionedStart / omega;
  else if (const auto critical = dampedStep(c.lambda, c.system.damping(), info); critical && info.imaginaryLimit > 0)
    largest = share * *critical;
  std::vector<double> steps;
  for (int level = 0; level < options.levels && largest > 0; ++level)
    steps.push_back(std::ldexp(std::min(largest, c.end), -level));
  return steps;
}

Body standardBar(bool slivers) {
  constexpr std::array<int, 3> cells{10, 2, 2};
  BarOptions options;
  options.size = {0.2, 0.04, 0.04};
  options.cells = cells;
  Mesh mesh = generateBar(options);
  if (slivers) {
    // Pull a few inner nodes nine tenths of the way to their neighbours along x: flat tetrahedra all around, none
    // inverted.
    const auto node = [&](int i, int j, int k) { return i + (cells[0] + 1) * (j + (cells[1] + 1) * k); };
    for (int i = 2; i + 2 < cells[0]; i += 3)
      mesh.X(0, node(i, 1, 1)) += 0.9 * (mesh.X(0, node(i + 1, 1, 1)) - mesh.X(0, node(i, 1, 1)));
  }
  Body body(std::move(mesh), makeMaterial("stvk", detail::young, detail::poisson, detail::density),
            {{}, Lumping::rowSum, 1});
  for (const std::int32_t n : body.mesh().nodeSets.at("x-min")) body.constraints().fix(n);
  body.addBodyForce({0, 0, -1});
  return body;
}

StudyTable::Cell textOrNone(const WorkPrecisionRun* run) { return run ? run->integrator : std::string("none"); }

}  // namespace

WorkPrecisionRun runPrepared(const WorkPrecisionCase& c, std::string_view name, double h,
                             const std::function<PreparedRun(double h)>& prepare) {
  const auto steps = static_cast<std::int64_t>(std::ceil(c.end / h - 1e-9));
  WorkPrecisionRun run{std::string(name), c.end / static_cast<double>(steps), nan, 0, 0, 0, 0, {}};
  double least = infinity;
  State state;
  // The best of three, when that is quick: others share the machine.
  for (int repeat = 0; repeat < 3 && (repeat == 0 || least < 0.2); ++repeat) {
    const PreparedRun prepared = prepare(run.h);
    state = c.start;
    least = std::min(
        least, secondsOf([&] { run.reason = advance(*prepared.integrator, *prepared.system, state, c.end, steps); }));
  }
  run.seconds = least;
  if (run.reason.empty())
    run.error = c.errorOf ? c.errorOf(state) : (state.x - c.reference).norm() / (c.reference - c.start.x).norm();
  return run;
}

ConvergedMotion convergedMotion(SecondOrderSystem& system, const State& start, double end, double lambda,
                                double tolerance) {
  // Fourth order with damping too is what the classical method has.
  const char* const name = system.velocityDependent() ? "rk4" : "pefrl";
  constexpr double firstStep = 0.4;  // times omega
  constexpr int halvings = 7;
  constexpr double rounding = 1e-12;  // of displacements, over the positions
  ConvergedMotion motion{{}, nan, 0, true};
  NodeVectors before;
  auto steps = std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(end * std::sqrt(lambda) / firstStep)));
  for (int k = 0; k <= halvings; ++k, steps *= 2) {
    State state = start;
    const auto integrator = makeIntegrator(name);
    const std::string lost = advance(*integrator, system, state, end, steps);
    if (!lost.empty()) {
      before.resize(3, 0);  // stiffer on the way than at the start: smaller steps
      continue;
    }
    motion.h = end / static_cast<double>(steps);
    const double displacement = (state.x - start.x).norm();
    motion.moves = displacement > rounding * start.x.norm();
    if (before.size() > 0) motion.change = motion.moves ? (state.x - before).norm() / displacement : 0;
    before = motion.x = state.x;
    if (motion.change <= tolerance) return motion;
  }
  // Four digits are worth comparing with; less is not.
  if (motion.change <= 1e-5) return motion;
  throw NumericalError(joinText("no converged reference: halving the step of ", name, " to ", motion.h,
                                " s still changes the end by ", motion.change,
                                " of the displacement; the motion may be chaotic or unstable, a shorter one may work"));
}

std::vector<WorkPrecisionRun> runWorkPrecision(const WorkPrecisionCase& c, std::span<const IntegratorEntry> integrators,
                                               const WorkPrecisionOptions& options) {
  struct Planned {
    const IntegratorEntry* entry;
    double h;
  };
  std::vector<Planned> plan;
  for (const IntegratorEntry& entry : integrators) {
    if (entry.info->partitioned && !c.split) continue;
    for (const double h : stepsFor(c, *entry.info, options)) plan.push_back({&entry, h});
  }
  std::vector<WorkPrecisionRun> runs;
  for (const Planned& next : plan) {
    if (options.progress)
      options.progress(joinText(next.entry->info->name, ", h = ", next.h, " s"),
                       static_cast<double>(runs.size()) / static_cast<double>(plan.size()));
    runs.push_back(runOne(c, *next.entry, next.h));
  }
  return runs;
}

std::vector<CheapestRuns> cheapestRuns(const std::vector<WorkPrecisionRun>& runs) {
  std::vector<CheapestRuns> result{{"1 %", 1e-2}, {"0.1 %", 1e-3}, {"1e-6", 1e-6}};
  const auto work = [](const WorkPrecisionRun& run) { return run.forces + run.products; };
  for (CheapestRuns& cheapest : result)
    for (const WorkPrecisionRun& run : runs) {
      if (!(run.error <= cheapest.error)) continue;
      if (!cheapest.byTime || run.seconds < cheapest.byTime->seconds) cheapest.byTime = &run;
      if (!cheapest.byForces || work(run) < work(*cheapest.byForces)) cheapest.byForces = &run;
    }
  return result;
}

void addWorkPrecision(const WorkPrecisionCase& c, const std::vector<WorkPrecisionRun>& runs, StudyReport& report) {
  StudyTable all{c.name + "_runs",
                 c.title + ": error of the positions at the end, and its cost",
                 {"integrator", "h (s)", "error", "time (s)", "forces", "tangent products", "matrices"},
                 {}};
  StudyTable best{c.name + "_cheapest",
                  c.title + ": cheapest for an error",
                  {"error", "by time", "time (s)", "h (s)", "by forces and products", "forces and products"},
                  {}};
  std::map<std::string, StudyFigure::Curve> byTime, byForces;
  for (const WorkPrecisionRun& run : runs) {
    all.rows.push_back({run.integrator, run.h, run.error, run.seconds, run.forces, run.products, run.matrices});
    if (!(run.error > 0 && run.error < 10)) continue;
    const auto point = [&](StudyFigure::Curve& curve, double x) {
      curve.label = run.integrator;
      curve.x.push_back(x);
      curve.y.push_back(run.error);
    };
    point(byTime[run.integrator], run.seconds);
    point(byForces[run.integrator], run.forces + run.products);
  }
  for (const CheapestRuns& cheapest : cheapestRuns(runs))
    best.rows.push_back({cheapest.label, textOrNone(cheapest.byTime), cheapest.byTime ? cheapest.byTime->seconds : nan,
                         cheapest.byTime ? cheapest.byTime->h : nan, textOrNone(cheapest.byForces),
                         cheapest.byForces ? cheapest.byForces->forces + cheapest.byForces->products : nan});
  report.tables.push_back(std::move(all));
  report.tables.push_back(std::move(best));
  const auto figure = [&](const char* what, const char* label, std::map<std::string, StudyFigure::Curve>& curves) {
    StudyFigure result;
    result.name = joinText("work_precision_", c.name, "_", what);
    result.title = c.title;
    result.xLabel = label;
    result.yLabel = "relative error";
    result.logX = result.logY = true;
    for (auto& [name, curve] : curves) result.curves.push_back(std::move(curve));
    report.figures.push_back(std::move(result));
  };
  figure("time", "run time (s)", byTime);
  figure("forces", "force evaluations and tangent products", byForces);
}

WorkPrecisionCase::Parts partitionForStep(const Body& body, const RayleighDamping& damping, const IntegratorInfo& info,
                                          double h) {
  const std::vector<ElementRef> stiff =
      stiffElements(body, body.mesh().X, h, nonstiffShareOfLimit * info.imaginaryLimit);
  return {std::make_unique<PartitionedBodySystem>(body, stiff, damping),
          static_cast<double>(stiff.size()) / static_cast<double>(body.mesh().elementCount())};
}

void addStandardCases(std::span<const IntegratorEntry> integrators, int levels, double end, StudyReport& report,
                      const std::function<void(const WorkPrecisionCase&, const std::vector<WorkPrecisionRun>&)>& seen) {
  const auto take = [&](const WorkPrecisionCase& c, int count) {
    WorkPrecisionOptions options;
    options.levels = count;
    const std::vector<WorkPrecisionRun> runs = runWorkPrecision(c, integrators, options);
    addWorkPrecision(c, runs, report);
    if (seen) seen(c, runs);
  };
  {
    Oscillator oscillator;
    const double time = 10 * 2 * std::numbers::pi + 1;
    const State start{0, NodeVectors::Constant(3, 1, 1), NodeVectors::Zero(3, 1)};
    take({"oscillator", "Oscillator, ten periods", oscillator, start, time, 1,
          NodeVectors::Constant(3, 1, oscillator.exact(time, 1, 0)[0]), 0,
          [](const IntegratorInfo&, double) {
            return WorkPrecisionCase::Parts{std::make_unique<AdditiveOscillator>(1, 0, 0.5), 0.5};
          }},
         levels + 5);
  }
  for (const bool slivers : {false, true}) {
    const Body body = standardBar(slivers);
    BodySystem system(body);
    const double lambda = highestEigenvalue(body, 1e-9);
    const State start = system.initialState();
    const ConvergedMotion reference = convergedMotion(system, start, end, lambda);
    take({slivers ? "slivers" : "bar", slivers ? "Swinging StVK bar with slivers" : "Swinging StVK bar", system, start,
          end, lambda, reference.x, reference.change,
          [&](const IntegratorInfo& info, double h) { return partitionForStep(body, {}, info, h); }},
         levels);
  }
}

void addRefinedBar(const IntegratorFactory& implicit, int finest, StudyReport& report) {
  StudyTable table{"refinement",
                   "One millisecond of a 10 x 1 x 1 cm bar as it is refined",
                   {"tetrahedra", "explicit steps", "explicit (s)", "implicit (s)", "implicit/explicit",
                    "implicit: tangent products", "matrices"},
                   {}};
  StudyFigure::Curve explicitCurve{"explicit", {}, {}}, implicitCurve{"implicit", {}, {}};
  for (int n = 1; n <= finest; ++n) {
    BarOptions options;
    options.size = {0.1, 0.01, 0.01};
    options.cells = {10 * n, n, n};
    Body body(generateBar(options), makeMaterial("corotational", 1e6, 0.3, 1000), {{}, Lumping::rowSum, 1});
    for (const std::int32_t node : body.mesh().nodeSets.at("x-min")) body.constraints().fix(node);
    body.addBodyForce({0, 0, -9.81});
    const double h = 1e-3, omega = std::sqrt(highestEigenvalue(body, 1e-6));
    const auto substeps = static_cast<std::int64_t>(std::ceil(h / (0.9 * 2 / omega)));
    constexpr int repeats = 5;
    BodySystem bodySystem(body);
    Counts counts;
    Counted system(bodySystem, counts);
    const auto timeOf = [&](const std::unique_ptr<Integrator>& integrator, std::int64_t steps) {
      State state = bodySystem.initialState();
      counts = {};
      std::string lost;
      const double seconds =
          secondsOf([&] { lost = advance(*integrator, system, state, repeats * h, repeats * steps); });
      if (!lost.empty()) throw NumericalError("refined bar: " + lost);
      return seconds / repeats;
    };
    const double explicitTime = timeOf(makeIntegrator("symplectic-euler"), substeps),
                 implicitTime = timeOf(implicit(), 1);
    const std::int64_t elements = body.mesh().elementCount();
    table.rows.push_back({elements, substeps, explicitTime, implicitTime, implicitTime / explicitTime,
                          counts.products / repeats, counts.matrices / repeats});
    explicitCurve.x.push_back(static_cast<double>(elements));
    implicitCurve.x.push_back(static_cast<double>(elements));
    explicitCurve.y.push_back(explicitTime);
    implicitCurve.y.push_back(implicitTime);
  }
  StudyFigure figure;
  figure.name = "work_precision_refinement";
  figure.title = table.title;
  figure.xLabel = "tetrahedra";
  figure.yLabel = "computing time (s)";
  figure.logX = figure.logY = true;
  figure.curves = {explicitCurve, implicitCurve};
  report.tables.push_back(std::move(table));
  report.figures.push_back(std::move(figure));
}

}  // namespace ringwatch

#include <ringwatch/verify/integrators/integrators.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <sstream>

#include <Eigen/LU>

#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/random.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/integrators/stability_limit.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <ringwatch/verify/integrators/oscillator_field.h>
#include <ringwatch/verify/integrators/spring_chain.h>
#include <ringwatch/verify/study_bodies.h>

namespace ringwatch {
namespace {

using detail::nan;
constexpr double rounding = 1e-14;  // of steps at numbers of order one: 45 units in the last place
// Limits are bisected to 1e-10 of themselves, and none is above 3.
constexpr double bisected = 3e-10;
constexpr double dampingRatios[] = {0.01, 0.05, 0.1, 0.2, 0.5, 1, 2, 5};

/// Small displacements and velocities of every free component, the same on every machine.
void perturb(State& state, double displacement, double velocity, const DifferentiableSystem& system) {
  Random random(1);
  for (Eigen::Index i = 0; i < state.x.cols(); ++i)
    for (int c = 0; c < 3; ++c) {
      const double dx = random.uniform(-1, 1), dv = random.uniform(-1, 1);
      if (system.isConstrained(i, c)) continue;
      state.x(c, i) += displacement * dx;
      state.v(c, i) += velocity * dv;
    }
}

class IntegratorStudy {
 public:
  IntegratorStudy(StudyReport& report, StudyEffort effort) : report_(report), full_(effort == StudyEffort::full) {
    table(limits, "limits",
          "Largest stable h·omega of an undamped oscillator, and of a critically damped one (the negative real axis)",
          {"integrator", "measured", "theory", "difference", "measured, real axis", "theory, real axis"});
    table(damped, "damped_limits", "Largest stable h·omega for a damping ratio",
          {"integrator", "damping ratio", "measured", "theory", "difference"});
    table(orders, "orders", "Order of the error at a fixed time, forces a step, and geometry of the undamped step",
          {"integrator", "order", "declared", "order, damped", "declared, damped", "forces a step", "|det - 1|",
           "reversal error"});
    table(periods, "periods",
          "Phase and amplitude error a period at a given cost: h·omega = 0.2 for each force of a step",
          {"integrator", "h·omega", "phase error", "amplitude error"});
    table(drift, "drift", "Relative energy change of an undamped oscillator at a quarter of the limit",
          {"integrator", "h·omega", "periods", "by", "drift", "oscillation"});
    table(observed, "observed", "Critical step of real runs against prediction",
          {"integrator", "system", "predicted (s)", "observed (s)", "observed/predicted - 1"});
    table(partitioned, "partitioned",
          "Largest stable h·omega of an oscillator with a share of its stiffness in the stiff part",
          {"integrator", "stiff share of omega²", "h·omega of the whole", "h·omega of the non-stiff part"});
    table(stiff, "stiff", "A swinging St. Venant-Kirchhoff bar at 50 times the explicit step, from rest under gravity",
          {"integrator", "steps", "h (s)", "energy/work of gravity"});
    table(adaptive, "adaptive", "Integrators that choose steps of their own: error at t = 1/omega",
          {"integrator", "calls", "error, undamped", "error, damping ratio 0.2", "error, forces of time", "forces"});
    figure("spectral_radius", "Spectral radius of an undamped step", "h·omega", "spectral radius");
    figure("limit_over_damping", "Largest stable step with damping", "damping ratio", "h·omega");
    figure("stability_regions", "Stability regions: h times the eigenvalue of a damped oscillator", "real part",
           "imaginary part");
    figure("phase_error", "Phase error a period against cost", "h·omega for each force of a step", "|phase error|");
    report_.figures[3].logX = report_.figures[3].logY = true;
  }

  void study(const IntegratorFactory& make) {
    described_ = make();
    info_ = &described_->info();
    name_ = std::string(info_->name);
    make_ = make;
    studyTime();
    if (info_->imaginaryLimit == infinity) studyStiffBar();
    if (info_->adaptive) {
      studyAdaptive();
      return;
    }
    bool linear = transitionMatrix(make_, 0.1, 0).found;
    if (linear) {
      studyField();
      try {
        studyLinear();
      } catch (const NumericalError&) {  // at another step
        linear = false;
      }
    }
    // Not a number to compare, but a failed claim all the same.
    if (!linear) check("steps a linear oscillator by a linear recursion", 0, 1, 0);
  }

  void finish() {
    std::erase_if(report_.tables, [](const StudyTable& t) { return t.rows.empty(); });
  }

 private:
  void studyLinear() {
    studyLimits();
    studyOrders();
    studyDrift();
    if (info_->partitioned) {
      studyShares();
      return;
    }
    studyFigures();
    if (info_->imaginaryLimit > 0 && info_->imaginaryLimit < infinity) studyRuns();
  }

  enum Table { limits, damped, orders, periods, drift, observed, partitioned, stiff, adaptive };

  void table(Table which, std::string name, std::string title, std::vector<std::string> columns) {
    report_.tables.resize(std::max<std::size_t>(report_.tables.size(), which + 1u));
    report_.tables[which] = {std::move(name), std::move(title), std::move(columns), {}};
  }
  void figure(std::string name, std::string title, std::string x, std::string y) {
    StudyFigure result;
    result.name = "integrators_" + std::move(name);
    result.title = std::move(title);
    result.xLabel = std::move(x);
    result.yLabel = std::move(y);
    report_.figures.push_back(std::move(result));
  }
  void row(Table which, std::vector<StudyTable::Cell> cells) {
    cells.insert(cells.begin(), name_);
    report_.tables[which].rows.push_back(std::move(cells));
  }
  void check(const std::string& claim, double measured, double expected, double tolerance) {
    checkNear(report_, name_ + ": " + claim, measured, expected, tolerance);
  }

  /// The system is told a time with every force, so a step that leaves the time behind is wrong wherever forces depend
  /// on it.
  void studyTime() {
    Oscillator whole;
    AdditiveOscillator parts(1, 0, 0.5);
    SecondOrderSystem& oscillator = info_->partitioned ? static_cast<SecondOrderSystem&>(parts) : whole;
    const std::unique_ptr<Integrator> integrator = make_();
    constexpr double start = 3, h = 0.1;
    constexpr int steps = 100;
    State state;
    state.time = start;
    state.x = NodeVectors::Ones(3, 1);
    state.v = NodeVectors::Zero(3, 1);
    double worst = 0;
    for (int k = 0; k < steps && !std::isnan(worst); ++k) {
      const double before = state.time;
      integrator->step(oscillator, state, h);
      const double error = std::abs(state.time - before - h) / h;
      worst = std::isnan(error) ? nan : std::max(worst, error);
    }
    // A unit in the last place of the time, up to 13, over h.
    constexpr double lastPlace = 2e-14;
    check("time advances by h in every step: relative error", worst, 0, lastPlace);
    check(joinText("time advances by ", steps, " h in ", steps, " steps: relative error"),
          std::abs(state.time - start - steps * h) / (steps * h), 0, lastPlace);
  }

  void studyLimits() {
    const double limit = info_->imaginaryLimit;
    const double measured = measureStabilityLimit(make_);
    if (info_->partitioned) {
      row(limits, {measured, limit, difference(measured, limit), nan, nan});
      check("limit on the imaginary axis, of the non-stiff part alone", measured, limit, bisected);
      return;
    }
    const double real = measureStabilityLimit(make_, 1);
    const std::optional<double> realTheory = declaredLimit(*info_, 1);
    row(limits, {measured, limit, difference(measured, limit), real, realTheory.value_or(nan)});
    check("limit on the imaginary axis", measured, limit, bisected);
    for (const double xi : dampingRatios) {
      if (!full_ && limit == infinity && xi != 1 && xi != 0.2) continue;  // long scans
      const double found = xi == 1 ? real : measureStabilityLimit(make_, xi);
      const std::optional<double> theory = declaredLimit(*info_, xi);
      row(damped, {xi, found, theory.value_or(nan), theory ? difference(found, *theory) : nan});
      if (theory) check(joinText("limit at damping ratio ", xi), found, *theory, bisected);
    }
    if (!info_->amplification) return;
    double worst = 0;
    for (const double xi : {0.0, 0.1, 1.0})
      for (double z = 0.05; z < 3; z += 0.05) {
        const TransitionMatrix T = transitionMatrix(make_, z, xi);
        if (!T.found || T.memory != 1) continue;
        const Eigen::Matrix2d declared = info_->amplification(z, xi);
        const double size = 1 + declared.squaredNorm();
        worst = std::max({worst, std::abs(T.matrix.trace() - declared.trace()) / size,
                          std::abs(T.matrix.determinant() - declared.determinant()) / size});
      }
    check("trace and determinant of a step, against the declared amplification", worst, 0, rounding);
  }
  static double difference(double a, double b) { return a == b ? 0.0 : a - b; }

  void studyOrders() {
    const double order = measureOrder(make_, 0), dampedOrder = measureOrder(make_, 0.2);
    // Steady cost: forces of eight steps after the start; of the non-stiff part where there are two.
    Oscillator whole;
    AdditiveOscillator parts(1, 0, 0.5);
    const Oscillator& counted = info_->partitioned ? parts.nonstiff() : whole;
    SecondOrderSystem& oscillator = info_->partitioned ? static_cast<SecondOrderSystem&>(parts) : whole;
    const std::unique_ptr<Integrator> integrator = make_();
    State state;
    state.x = NodeVectors::Ones(3, 1);
    state.v = NodeVectors::Zero(3, 1);
    integrator->step(oscillator, state, 0.1);
    const std::int64_t before = counted.evaluations();
    for (int k = 0; k < 8; ++k) integrator->step(oscillator, state, 0.1);
    const double forces = static_cast<double>(counted.evaluations() - before) / 8;
    const double defect = symplecticityDefect(make_, 0.5), reversal = reversalError(make_, 0.5);
    row(orders,
        {order, std::int64_t{info_->order}, dampedOrder, std::int64_t{info_->dampedOrder}, forces, defect, reversal});
    // What is left of the next order on the finest steps that rounding allows: 0.0058, and 0.0016 with damping; of
    // partitioned schemes 0.015 and 0.032.
    checkOrder("order", order, info_->order, info_->partitioned ? 0.04 : 0.017);
    checkOrder("order with damping", dampedOrder, info_->dampedOrder, info_->partitioned ? 0.09 : 0.0045);
    // The same: 0.0035, and 0.011 of schemes that iterate.
    checkOrder("order with forces of time that are not linear", measureDrivenOrder(make_), info_->order,
               iterates() ? 0.03 : 0.01);
    if (info_->forceEvaluations > 0) check("forces a step", forces, info_->forceEvaluations, 0);
    if (info_->symplectic) check("symplectic: |det - 1|", defect, 0, rounding);
    if (info_->reversible) check("reversible: 100 steps and back", reversal, 0, rounding);
    if (info_->forceEvaluations == 0) return;  // cost is not a matter of the step alone
    const double z = 0.2 * info_->forceEvaluations;
    const PeriodErrors errors = periodErrors(make_, z);
    row(periods, {z, errors.phase, errors.amplitude});
  }

  /// A scheme may be better than it declares.
  void checkOrder(const std::string& claim, double measured, int declared, double tolerance) {
    if (measured > declared + 0.5)
      checkAtLeast(report_, name_ + ": " + claim + ", which is better than declared", measured, declared, tolerance);
    else
      check(claim, measured, declared, tolerance);
  }
  /// Solves equations, or treats parts apart, by steps whose number varies.
  bool iterates() const { return info_->forceEvaluations == 0; }

  void studyField() {
    const int nodes = iterates() ? 4 : 1100;  // in two threads
    const FieldErrors undamped = fieldErrors(make_, nodes, 0), damped = fieldErrors(make_, nodes, 0.2);
    // Of iterations: 2.7e-9, of rounding 2.9e-15.
    const double tolerance = iterates() ? 7e-9 : rounding;
    const auto checkBoth = [&](const std::string& claim, double FieldErrors::*error) {
      const double a = undamped.*error, b = damped.*error;
      check(claim, std::isnan(a) ? a : std::isnan(b) ? b : std::max(a, b), 0, tolerance);
    };
    checkBoth(joinText("components of ", nodes, " nodes, each against one alone"), &FieldErrors::components);
    checkBoth("forces at the times of their positions: difference in a frame that moves", &FieldErrors::frame);
    checkBoth("what a step leaves: the acceleration, and advance with complete against step", &FieldErrors::left);
  }

  void studyDrift() {
    const double limit = info_->imaginaryLimit, z = limit > 0 && limit < infinity ? 0.25 * limit : 0.25;
    const EnergyDrift powers = energyDriftByPowers(make_, z, 1e6);
    row(drift, {z, 1e6, std::string("powers"), powers.drift, powers.oscillation});
    const double periodCount = full_ && info_->forceEvaluations > 0 ? 1e6 : 1e3;  // Newton's method takes its time
    const EnergyDrift steps = energyDriftBySteps(make_, z, periodCount);
    row(drift, {z, periodCount, std::string("steps"), steps.drift, steps.oscillation});
    // Rounding. By powers it adds up over the 1e7 steps of the 1e6 periods, to 1.2e-9; by steps it is a random walk,
    // over 1e3 periods to 1.7e-14, over 1e6 to 1.4e-12.
    constexpr double byPowers = 3.5e-9;
    const double bySteps = periodCount > 1e3 ? 4e-12 : 5e-14;
    if (info_->symplectic) {
      check("energy drift over 1e6 periods, by powers", powers.drift, 0, byPowers);
      check(joinText("energy drift over ", periodCount, " periods, by steps"), steps.drift, 0, bySteps);
    } else if (limit > 0) {
      const bool known = !std::isnan(powers.drift) && !std::isnan(steps.drift);
      checkAtMost(report_, name_ + ": largest energy drift of a scheme that loses energy",
                  known ? std::max(powers.drift, steps.drift) : nan, 0, byPowers);
    }
  }

  void studyFigures() {
    StudyFigure::Curve radius{name_, {}, {}}, limitOverDamping{name_, {}, {}}, region{name_, {}, {}},
        phase{name_, {}, {}};
    for (int k = 1; k <= 175; ++k) {
      const double z = 0.02 * k, rho = transitionMatrix(make_, z, 0).spectralRadius();
      if (!(rho < 2)) break;
      radius.x.push_back(z);
      radius.y.push_back(rho);
    }
    const int count = full_ ? 40 : 8;
    for (int k = 0; k <= count; ++k) {
      const double angle = 0.5 * std::numbers::pi * k / count, xi = std::sin(angle);
      const double limit = measureStabilityLimit(make_, xi, 20);
      if (!(limit < infinity)) break;
      limitOverDamping.x.push_back(xi);
      limitOverDamping.y.push_back(limit);
      region.x.push_back(-limit * xi);
      region.y.push_back(limit * std::cos(angle));
    }
    const int forces = info_->forceEvaluations;
    for (int k = 0; k <= 20 && forces > 0; ++k) {
      const double z = std::pow(10.0, -2 + 0.1 * k);
      if (forces * z > info_->imaginaryLimit) break;
      const double error = std::abs(periodErrors(make_, forces * z).phase);
      if (!(error > 1e-13)) continue;
      phase.x.push_back(z);
      phase.y.push_back(error);
    }
    const StudyFigure::Curve* const curves[] = {&radius, &limitOverDamping, &region, &phase};
    for (std::size_t i = 0; i < 4; ++i)
      if (!curves[i]->x.empty()) report_.figures[i].curves.push_back(*curves[i]);
  }

  void studyRuns() {
    for (const RayleighDamping damping : {RayleighDamping{}, RayleighDamping{0.5, 0.1}}) {
      SpringChain chain(20, 1, 1, damping);
      State start;
      start.x = NodeVectors::Zero(3, chain.count());
      start.v = NodeVectors::Zero(3, chain.count());
      perturb(start, 1, 1, chain);
      const double omega = chain.highestFrequency();
      compare(chain, start, damping.any() ? "chain of 20, damped" : "chain of 20", omega * omega, 1e-3);
    }
    for (const auto& [model, element] : {std::pair{"linear", "tet4"}, std::pair{"stvk", "hex8"}}) {
      const Body body = smallBar(model, element);
      const double lambda = highest(body);
      BodySystem system(body);
      State start = system.initialState();
      // So small that the strain energy stays quadratic until the growth shows.
      perturb(start, 1e-9, 1e-7, system);
      compare(system, start, joinText(model, " ", element, " bar"), lambda, 1e-3);
    }
  }
  void compare(DifferentiableSystem& system, const State& start, const std::string& what, double lambda,
               double tolerance) {
    const std::optional<double> predicted = dampedStep(lambda, system.damping(), *info_);
    if (!predicted) return;
    ObservedStepOptions options;
    options.steps = full_ ? 8000 : 3000;
    options.tolerance = 1e-4;
    const double found = observedCriticalStep(make_, system, start, 0.9 * *predicted, 1.1 * *predicted, options);
    row(observed, {what, *predicted, found, found / *predicted - 1});
    check("critical step of real runs, " + what, found / *predicted, 1, tolerance);
  }

  void studyShares() {
    for (const double share : {0.0, 0.1, 0.5, 0.9, 0.99}) {
      double limit = nan;
      try {
        limit = measureStabilityLimit(make_, 0, 100, share);
      } catch (const NumericalError&) {
        // Small steps by error control depend on the state: no linear map, nothing to measure.
      }
      row(partitioned, {share, limit, limit * std::sqrt(1 - share)});
    }
  }

  /// No scheme that is stable at every step adds energy: kinetic plus strain energy stay below the work of gravity.
  void studyStiffBar() {
    Body body = smallBar("stvk", "tet4");
    body.addBodyForce({0, 0, -1});
    const double h = 50 * 2 / std::sqrt(highest(body));
    constexpr int steps = 20;
    BodySystem system(body);
    State state = system.initialState();
    const std::unique_ptr<Integrator> integrator = make_();
    double share = 0;
    Body::Workspace workspace;
    for (int k = 0; k < steps && !std::isnan(share); ++k) {
      if (!integrator->step(system, state, h).done || !state.x.allFinite()) share = nan;
      if (std::isnan(share)) break;
      const double work = (state.x - body.mesh().X).cwiseProduct(body.externalForce()).sum(),
                   kinetic = 0.5 * (state.v * body.lumpedMass().asDiagonal()).cwiseProduct(state.v).sum();
      share = std::max(share, (kinetic + body.energy(state.x, workspace)) / work);
    }
    row(stiff, {std::int64_t{steps}, h, share});
    // Schemes that go by an error of their own may gain what that allows.
    checkAtMost(report_, name_ + ": stiff bar at 50 times the explicit step: largest energy over the work of gravity",
                share, 1, 1e-6);
  }

  static Body smallBar(const char* model, const char* element) {
    BarOptions options;
    options.size = {0.2, 0.04, 0.04};
    options.cells = {5, 1, 1};
    options.element = element;
    options.jitter = 0.2;
    BodyOptions bodyOptions;
    bodyOptions.threads = 1;  // a few elements: waking others costs more
    Body body(generateBar(options), makeMaterial(model, detail::young, detail::poisson, detail::density), bodyOptions);
    for (const std::int32_t node : body.mesh().nodeSets.at("x-min")) body.constraints().fix(node);
    return body;
  }
  static double highest(const Body& body) {
    const GlobalFrequency top = globalFrequency(body, body.mesh().X);
    if (!top.converged) throw NumericalError("the highest frequency of a small bar did not converge");
    return top.lambda;
  }

  void studyAdaptive() {
    for (const int calls : {1, 10, 100}) {
      const double undamped = oscillatorError(make_, calls, 0), withDamping = oscillatorError(make_, calls, 0.2),
                   driven = drivenError(make_, calls);
      Oscillator oscillator;
      const std::unique_ptr<Integrator> integrator = make_();
      State state;
      state.x = NodeVectors::Ones(3, 1);
      state.v = NodeVectors::Zero(3, 1);
      for (int k = 0; k < calls; ++k) integrator->step(oscillator, state, 1.0 / calls);
      row(adaptive, {std::int64_t{calls}, undamped, withDamping, driven, oscillator.evaluations()});
      // Of its own control of the error: 3.5e-6.
      check(joinText("error at t = 1/omega in ", calls, calls == 1 ? " call" : " calls"),
            std::isnan(driven) ? driven : std::max({undamped, withDamping, driven}), 0, 8e-6);
    }
  }

  StudyReport& report_;
  bool full_;
  IntegratorFactory make_;
  std::unique_ptr<Integrator> described_;  // owns what info_ points to
  const IntegratorInfo* info_ = nullptr;
  std::string name_;
};

}  // namespace

StudyReport verifyIntegrators(StudyEffort effort, std::span<const IntegratorEntry> integrators) {
  StudyReport report;
  report.study = "integrators";
  IntegratorStudy study(report, effort);
  for (const IntegratorEntry& entry : integrators) study.study(entry.make);
  study.finish();
  // Fierz 2013 gives 2.78 for RK4, which is this limit and not the one of the imaginary axis.
  for (const IntegratorEntry& entry : integrators)
    if (entry.info->realLimit > 0)
      checkNear(report, joinText(entry.info->name, ": limit on the negative real axis"),
                measureStabilityLimit(entry.make, 1), entry.info->realLimit, bisected);
  return report;
}

StudyReport verifyIntegrator(const IntegratorFactory& make, StudyEffort effort) {
  StudyReport report;
  report.study = "integrators";
  IntegratorStudy study(report, effort);
  study.study(make);
  study.finish();
  return report;
}

std::string integratorTable(std::span<const IntegratorEntry> integrators) {
  std::string text =
      "| name | what | order | with damping | forces a step | limit | limit at ξ = 0.1 | symplectic | reversible |\n"
      "|---|---|---|---|---|---|---|---|---|\n";
  const auto number = [](double value, int digits) {
    if (value == infinity) return std::string("none");
    std::ostringstream out;
    out.precision(digits);
    out << value;
    return out.str();
  };
  const auto yes = [](bool value) { return value ? "yes" : ""; };
  for (const IntegratorEntry& entry : integrators) {
    const IntegratorInfo& info = *entry.info;
    const std::optional<double> damped = info.adaptive ? std::nullopt : declaredLimit(info, 0.1);
    text +=
        joinText("| `", info.name, "` | ", info.help, " | ", info.order, " | ", info.dampedOrder, " | ",
                 info.forceEvaluations > 0 ? std::to_string(info.forceEvaluations) : "varies", " | ",
                 info.adaptive ? "by error control" : number(info.imaginaryLimit, 9), " | ",
                 damped ? number(*damped, 5) : "", " | ", yes(info.symplectic), " | ", yes(info.reversible), " |\n");
  }
  return text;
}

}  // namespace ringwatch

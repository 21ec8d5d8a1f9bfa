#include <ringwatch/verify/work_precision.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <limits>
#include <map>
#include <numbers>

#include <ringwatch/base/error.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/integrators/split_body_system.h>
#include <ringwatch/integrators/stability_limit.h>
#include <ringwatch/meshes/generators.h>
#include <ringwatch/monitor/global_frequency.h>
#include <ringwatch/monitor/stiff_elements.h>

namespace ringwatch {
namespace {

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
  Body body(std::move(mesh), makeMaterial("stvk", 30e3, 0.3, 1000), {{}, Lumping::rowSum, 1});
  for (const std::int32_t n : body.mesh().nodeSets.at("x-min")) body.constraints().fix(n);
  body.addBodyForce({0, 0, -1});
  return body;
}

double highestEigenvalue(const Body& body, double tolerance = 1e-9) {
  const GlobalFrequency top = globalFrequency(body, body.mesh().X, tolerance);
  if (!top.converged) throw NumericalError("the highest frequency of the bar did not converge");
  return top.lambda;
}

}  // namespace

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
    const double lambda = highestEigenvalue(body);
    const State start = system.initialState();
    const ConvergedMotion reference = convergedMotion(system, start, end, lambda);
    take({slivers ? "slivers" : "bar", slivers ? "Swinging StVK bar with slivers" : "Swinging StVK bar", system, start,
          end, lambda, reference.x, reference.change,
          [&](const IntegratorInfo& info, double h) { return splitForStep(body, {}, info, h); }},
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
    const auto elements = static_cast<std::int64_t>(body.mesh().elementCount());
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

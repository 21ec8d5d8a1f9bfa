// Work against precision: every integrator over a range of steps on (a) an oscillator, (b) a swinging StVK bar, (c) the
// same bar with slivers, against a converged reference; and, as the source's fig. 1.2, the cost of a millisecond of a
// bar as it is refined, explicit against implicit.
//
//   ringwatch_work_precision [FOLDER] [--quick]
//
// One thread throughout. Writes FOLDER/work_precision.json, a gnuplot script with its data for each picture, and the
// pictures when gnuplot is there. Prints which integrator is cheapest for 1 %, 0.1 % and 1e-6.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <ringwatch/integrators/body_system.h>
#ifdef RINGWATCH_HAS_SUNDIALS
#include <ringwatch/integrators/sundials/implicit.h>
#include <ringwatch/integrators/sundials/registry.h>
#endif
#include <ringwatch/meshes/generators.h>
#include <ringwatch/monitor/global_frequency.h>
#include <ringwatch/verify/oscillator.h>

namespace {

using namespace ringwatch;
namespace fs = std::filesystem;

/// Counts the forces of another system.
class Counted final : public DifferentiableSystem {
 public:
  explicit Counted(DifferentiableSystem& inner) : inner_(inner) {}
  void acceleration(double t, const NodeVectors& x, const NodeVectors& v, NodeVectors& a) override {
    ++forces;
    inner_.acceleration(t, x, v, a);
  }
  bool velocityDependent() const override { return inner_.velocityDependent(); }
  const Eigen::VectorXd& mass() const override { return inner_.mass(); }
  RayleighDamping damping() const override { return inner_.damping(); }
  void stiffnessProduct(const NodeVectors& x, const NodeVectors& u, NodeVectors& Ku) override {
    inner_.stiffnessProduct(x, u, Ku);
  }
  Eigen::SparseMatrix<double> stiffness(const NodeVectors& x) override { return inner_.stiffness(x); }
  bool isConstrained(std::int32_t node, int component) const override { return inner_.isConstrained(node, component); }
  std::int64_t forces = 0;

 private:
  DifferentiableSystem& inner_;
};

struct Run {
  std::string integrator;
  double h, error, seconds;
  std::int64_t forces;
};

struct Case {
  std::string name, title;
  DifferentiableSystem& system;
  State start;
  double end;    // s
  double omega;  // highest frequency at the start, rad/s
};

double secondsOf(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// False when a step fails or the state is lost.
bool advance(Integrator& integrator, SecondOrderSystem& system, State& state, double end, std::int64_t steps) {
  for (std::int64_t k = 0; k < steps; ++k)
    if (!integrator.step(system, state, end / static_cast<double>(steps)).done) return false;
  return state.x.allFinite();
}

std::vector<Run> runCase(const Case& c, const IntegratorCatalog& catalog, const State& reference, int levels) {
  std::vector<Run> runs;
  const double size = (reference.x - c.start.x).norm();
  for (const IntegratorEntry& entry : catalog.entries()) {
    const IntegratorInfo& info = *entry.info;
    if (info.imaginaryLimit == 0) continue;
    const bool implicit = std::isinf(info.imaginaryLimit);
    double h = (implicit ? 40.0 : 0.9 * info.imaginaryLimit) / c.omega;
    for (int level = 0; level < levels; ++level, h /= 2) {
      const auto steps = static_cast<std::int64_t>(std::ceil(c.end / h));
      Counted system(c.system);
      State state;
      bool done = false;
      double seconds = HUGE_VAL;
      // The best of three, when that is quick: others share the machine.
      for (int repeat = 0; repeat < 3 && (repeat == 0 || seconds < 0.2); ++repeat) {
        const auto integrator = entry.make();
        state = c.start;
        system.forces = 0;
        seconds = std::min(seconds, secondsOf([&] { done = advance(*integrator, system, state, c.end, steps); }));
      }
      if (!done) continue;
      runs.push_back({std::string(info.name), c.end / static_cast<double>(steps), (state.x - reference.x).norm() / size,
                      seconds, system.forces});
    }
  }
  return runs;
}

/// A picture: curves of (x, y) by name, drawn by gnuplot from files that stay beside it.
void draw(const fs::path& folder, const std::string& name, const std::string& title, const std::string& xLabel,
          const std::string& yLabel, const std::map<std::string, std::vector<std::pair<double, double>>>& curves) {
  std::ofstream data(folder / (name + ".dat"));
  std::ofstream script(folder / (name + ".gp"));
  script << "set terminal svg size 760,520 background 'white'\nset output '" << name << ".svg'\nset title '" << title
         << "'\nset xlabel '" << xLabel << "'\nset ylabel '" << yLabel
         << "'\nset logscale xy\nset format '10^{%L}'\nset grid\nset key outside\nplot ";
  int index = 0;
  for (const auto& [label, points] : curves) {
    data << "# " << label << "\n";
    for (const auto& [x, y] : points) data << x << " " << y << "\n";
    data << "\n\n";
    script << (index ? ", " : "") << "'" << name << ".dat' index " << index << " with linespoints title '" << label
           << "'";
    ++index;
  }
  script << "\n";
  data.close();
  script.close();
  if (std::system(("cd '" + folder.string() + "' && gnuplot " + name + ".gp").c_str()) != 0)
    std::cerr << name << ": gnuplot did not draw\n";
}

void drawRuns(const fs::path& folder, const Case& c, const std::vector<Run>& runs) {
  std::map<std::string, std::vector<std::pair<double, double>>> byTime, byForces;
  for (const Run& run : runs) {
    if (!(run.error < 10)) continue;
    byTime[run.integrator].emplace_back(run.seconds, run.error);
    byForces[run.integrator].emplace_back(static_cast<double>(run.forces), run.error);
  }
  draw(folder, "work_precision_" + c.name + "_time", c.title, "run time (s)", "relative error", byTime);
  draw(folder, "work_precision_" + c.name + "_forces", c.title, "force evaluations", "relative error", byForces);
}

Body bar(bool slivers, std::array<int, 3> cells) {
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

nlohmann::json cheapest(const std::vector<Run>& runs) {
  nlohmann::json result;
  for (const auto& [label, level] : {std::pair{"1 %", 1e-2}, std::pair{"0.1 %", 1e-3}, std::pair{"1e-6", 1e-6}}) {
    const Run *fastest = nullptr, *fewest = nullptr;
    for (const Run& run : runs) {
      if (!(run.error <= level)) continue;
      if (!fastest || run.seconds < fastest->seconds) fastest = &run;
      if (run.forces > 0 && (!fewest || run.forces < fewest->forces)) fewest = &run;
    }
    if (!fastest) continue;
    result[label] = {{"by_time", fastest->integrator},
                     {"seconds", fastest->seconds},
                     {"h", fastest->h},
                     {"by_forces", fewest->integrator},
                     {"forces", fewest->forces}};
    std::cout << "  " << label << ": " << fastest->integrator << ", " << fastest->seconds << " s (h = " << fastest->h
              << " s); fewest forces " << fewest->integrator << ", " << fewest->forces << "\n";
  }
  return result;
}

#ifdef RINGWATCH_HAS_SUNDIALS
/// Seconds of computing for 1 ms of a 10 x 1 x 1 cm corotational bar under gravity, fixed at one end: symplectic Euler
/// in as many substeps as 0.9 of its limit asks for, and one step of implicit Euler with conjugate gradients.
nlohmann::json refine(const fs::path& folder, int finest) {
  nlohmann::json rows = nlohmann::json::array();
  std::map<std::string, std::vector<std::pair<double, double>>> curves;
  for (int n = 1; n <= finest; ++n) {
    BarOptions options;
    options.size = {0.1, 0.01, 0.01};
    options.cells = {10 * n, n, n};
    Body body(generateBar(options), makeMaterial("corotational", 1e6, 0.3, 1000), {{}, Lumping::rowSum, 1});
    for (const std::int32_t node : body.mesh().nodeSets.at("x-min")) body.constraints().fix(node);
    body.addBodyForce({0, 0, -9.81});
    const double omega = std::sqrt(globalFrequency(body, body.mesh().X, 1e-6).lambda);
    const auto substeps = static_cast<std::int64_t>(std::ceil(1e-3 / (0.9 * 2 / omega)));
    constexpr int repeats = 5;
    BodySystem system(body);
    State a = system.initialState(), b = a;
    const auto explicitEuler = makeIntegrator("symplectic-euler");
    const double explicitTime =
        secondsOf([&] { advance(*explicitEuler, system, a, repeats * 1e-3, repeats * substeps); }) / repeats;
    ImplicitOptions implicit;
    implicit.linearSolve = LinearSolve::conjugateGradients;
    implicit.relativeTolerance = 1e-4;
    implicit.linearTolerance = 1e-4;
    ImplicitEuler implicitEuler(implicit);
    const double implicitTime =
        secondsOf([&] { advance(implicitEuler, system, b, repeats * 1e-3, repeats); }) / repeats;
    const auto elements = static_cast<double>(body.mesh().elementCount());
    rows.push_back({{"elements", elements},
                    {"substeps", substeps},
                    {"explicit_seconds", explicitTime},
                    {"implicit_seconds", implicitTime}});
    curves["explicit"].emplace_back(elements, explicitTime);
    curves["implicit"].emplace_back(elements, implicitTime);
    std::cout << "  " << elements << " tetrahedra: explicit " << explicitTime << " s in " << substeps
              << " steps, implicit " << implicitTime << " s\n";
  }
  draw(folder, "work_precision_refinement", "One millisecond of a 10 x 1 x 1 cm bar", "tetrahedra",
       "computing time (s)", curves);
  return rows;
}
#endif

}  // namespace

int main(int argc, char** argv) {
  fs::path folder = "work_precision";
  bool quick = false;
  for (int i = 1; i < argc; ++i) (std::string(argv[i]) == "--quick" ? (void)(quick = true) : (void)(folder = argv[i]));
  fs::create_directories(folder);
#ifdef RINGWATCH_HAS_SUNDIALS
  const IntegratorCatalog catalog{coreIntegrators(), sundialsIntegrators()};
#else
  const IntegratorCatalog catalog{coreIntegrators()};
#endif
  nlohmann::json results;
  const auto report = [&](const Case& c, const State& reference, int levels) {
    std::cout << c.title << "\n";
    const std::vector<Run> runs = runCase(c, catalog, reference, levels);
    drawRuns(folder, c, runs);
    nlohmann::json rows = nlohmann::json::array();
    for (const Run& run : runs)
      rows.push_back({{"integrator", run.integrator},
                      {"h", run.h},
                      {"error", run.error},
                      {"seconds", run.seconds},
                      {"forces", run.forces}});
    results[c.name] = {
        {"title", c.title}, {"end", c.end}, {"omega", c.omega}, {"runs", rows}, {"cheapest", cheapest(runs)}};
  };

  {
    Oscillator oscillator;
    const double end = 10 * 2 * std::numbers::pi + 1;
    State start{0, NodeVectors::Constant(3, 1, 1), NodeVectors::Zero(3, 1)}, reference = start;
    reference.x.setConstant(oscillator.exact(end, 1, 0)[0]);
    report({"oscillator", "Oscillator, ten periods", oscillator, start, end, 1}, reference, quick ? 6 : 12);
  }
  for (const bool slivers : {false, true}) {
    const Body body = bar(slivers, {10, 2, 2});
    BodySystem system(body);
    const double omega = std::sqrt(globalFrequency(body, body.mesh().X).lambda), end = quick ? 0.1 : 0.5;
    const State start = system.initialState();
    State reference = start;
    const auto best = makeIntegrator("pefrl");
    advance(*best, system, reference, end, static_cast<std::int64_t>(std::ceil(end * omega / 0.05)));
    report({slivers ? "slivers" : "bar", slivers ? "Swinging StVK bar with slivers" : "Swinging StVK bar", system,
            start, end, omega},
           reference, quick ? 4 : 7);
  }
#ifdef RINGWATCH_HAS_SUNDIALS
  std::cout << "One millisecond of a bar as it is refined\n";
  results["refinement"] = refine(folder, quick ? 3 : 6);
#endif
  std::ofstream(folder / "work_precision.json") << results.dump(1) << "\n";
  return 0;
}

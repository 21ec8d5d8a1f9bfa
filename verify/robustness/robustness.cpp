#include <ringwatch/verify/robustness/robustness.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include <ringwatch/base/error.h>
#include <ringwatch/base/random.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <ringwatch/verify/study_bodies.h>

namespace ringwatch {
namespace {

Body makeBody(Mesh mesh, const std::vector<Material>& materials) {
  BodyOptions options;
  options.threads = 1;  // a few elements
  return Body(std::move(mesh), materials, options);
}
Mesh cube(int cells, double jitter = 0) {
  BarOptions options;
  options.cells = {cells, cells, cells};
  options.jitter = jitter;
  return generateBar(options);
}
/// The same elements in two blocks, so that they can have two materials.
Mesh halved(Mesh mesh) {
  MeshBlock& first = mesh.blocks[0];
  MeshBlock second{first.type, {}, {}};
  const auto half = static_cast<std::ptrdiff_t>(first.elementCount() / 2),
             nodes = static_cast<std::ptrdiff_t>(first.nodesPerElement());
  second.connectivity.assign(first.connectivity.begin() + half * nodes, first.connectivity.end());
  second.ids.assign(first.ids.begin() + half, first.ids.end());
  first.connectivity.resize(half * nodes);
  first.ids.resize(half);
  mesh.blocks.push_back(std::move(second));
  mesh.elementSets.clear();
  return mesh;
}

struct Outcome {
  bool bounded = false;
  double energyChange = 0;  // largest, relative to the start
  double spinChange = 0;    // of angular momentum, relative
};

class LongRun {
 public:
  explicit LongRun(const Body& body) : body_(body), system_(body) {}

  Outcome run(Integrator& integrator, State state, double h, std::int64_t steps) {
    const double energy0 = energy(state);
    const Eigen::Vector3d spin0 = spin(state);
    Outcome outcome;
    const std::int64_t every = std::max<std::int64_t>(1, steps / 200);
    for (std::int64_t k = 1; k <= steps; ++k) {
      if (!integrator.step(system_, state, h).done) return outcome;
      if (k % every != 0) continue;
      if (!state.x.allFinite() || !state.v.allFinite()) return outcome;
      outcome.energyChange = std::max(outcome.energyChange, std::abs(energy(state) / energy0 - 1));
      // Near the limit the energy proper of a bounded motion oscillates by 1/(1 - fraction²).
      if (!(outcome.energyChange < 1e4)) return outcome;
    }
    outcome.bounded = true;
    outcome.spinChange = (spin(state) - spin0).norm() / std::max(spin0.norm(), 1e-300);
    return outcome;
  }
  State start() const { return system_.initialState(); }

 private:
  double energy(const State& state) {
    return 0.5 * (state.v * body_.lumpedMass().asDiagonal()).cwiseProduct(state.v).sum() +
           body_.energy(state.x, workspace_);
  }
  Eigen::Vector3d spin(const State& state) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (Eigen::Index i = 0; i < state.x.cols(); ++i)
      sum += body_.lumpedMass()[i] * Eigen::Vector3d(state.x.col(i)).cross(Eigen::Vector3d(state.v.col(i)));
    return sum;
  }

  const Body& body_;
  BodySystem system_;
  Body::Workspace workspace_;
};

void setRandomVelocities(State& state, double scale) {
  Random random(7);
  for (double& v : state.v.reshaped()) v = random.uniform(-scale, scale);
}

}  // namespace

StudyReport verifyRobustness(StudyEffort effort, std::span<const IntegratorEntry> integrators) {
  const bool full = effort == StudyEffort::full;
  const Material soft = makeMaterial("stvk", detail::young, detail::poisson, detail::density);
  StudyReport report;
  report.study = "robustness";
  report.tables.push_back(
      {"robustness",
       "Who survives: small bodies over many steps",
       {"integrator", "case", "h / limit", "steps", "bounded", "energy change", "angular momentum change"},
       {}});
  const auto record = [&](const IntegratorInfo& info, const std::string& what, double fraction, std::int64_t steps,
                          const Outcome& outcome) {
    report.tables[0].rows.push_back({std::string(info.name), what, fraction, steps,
                                     std::string(outcome.bounded ? "yes" : "no"), outcome.energyChange,
                                     outcome.spinChange});
  };

  struct Case {
    std::string name;
    Body body;
    std::vector<double> fractions;
    std::int64_t steps;
  };
  std::vector<Case> cases;
  const std::int64_t mostSteps = full ? 1000000 : 3000, run = full ? 100000 : 2000;
  cases.push_back({"cube", makeBody(cube(1), {soft}), {0.5, 0.9, 0.99, 1.01}, mostSteps});
  cases.push_back({"stiffness contrast 1e8",
                   makeBody(halved(cube(2)), {soft, makeMaterial("stvk", 30e11, 0.3, 1000)}),
                   {0.9},
                   run});
  cases.push_back({"Poisson ratio 0.4999", makeBody(cube(2), {makeMaterial("stvk", 30e3, 0.4999, 1000)}), {0.9}, run});
  {
    Mesh mesh = cube(2);
    mesh.X(0, 13) += (1 - 1e-6) * 0.5;  // the middle node, nearly onto the middle of a face
    cases.push_back({"sliver of 1e-6", makeBody(std::move(mesh), {soft}), {0.9}, run});
  }
  cases.push_back({"jittered cube", makeBody(cube(2, 0.3), {soft}), {0.9}, run});

  for (const Case& c : cases) {
    const GlobalFrequency top = globalFrequency(c.body, c.body.mesh().X);
    if (!top.converged) throw NumericalError("robustness, " + c.name + ": the highest frequency did not converge");
    LongRun longRun(c.body);
    State start = longRun.start();
    // So slow that the tangent, and the limit with it, stays that at rest.
    setRandomVelocities(start, 1e-7);
    for (const IntegratorEntry& entry : integrators) {
      const double limit = entry.info->imaginaryLimit;
      if (!(limit > 0) || std::isinf(limit)) continue;
      for (const double fraction : c.fractions) {
        const Outcome outcome = longRun.run(*entry.make(), start, fraction * limit / std::sqrt(top.lambda), c.steps);
        record(*entry.info, c.name, fraction, c.steps, outcome);
        checkNear(report,
                  joinText(entry.info->name, ": ", c.name, " at ", fraction, " of the limit is ",
                           fraction < 1 ? "bounded" : "not bounded"),
                  outcome.bounded ? 1 : 0, fraction < 1 ? 1 : 0, 0);
      }
    }
  }

  // A free cube that spins, its rim at a fiftieth of the wave speed.
  const Body body = makeBody(cube(1), {soft});
  const double lambda = globalFrequency(body, body.mesh().X).lambda, turns = full ? 100 : 3,
               rate = 0.02 * soft.waveSpeed();
  LongRun longRun(body);
  State start = longRun.start();
  start.x.colwise() -= Eigen::Vector3d::Constant(0.5);
  const Eigen::Vector3d axis = Eigen::Vector3d(1, 2, 3).normalized();
  for (Eigen::Index i = 0; i < start.x.cols(); ++i) start.v.col(i) = rate * axis.cross(Eigen::Vector3d(start.x.col(i)));
  for (const IntegratorEntry& entry : integrators) {
    const double limit = entry.info->imaginaryLimit;
    if (!(limit > 0) || std::isinf(limit)) continue;
    const double h = 0.5 * limit / std::sqrt(lambda);
    const auto steps = static_cast<std::int64_t>(turns * 2 * std::numbers::pi / (rate * h));
    const Outcome outcome = longRun.run(*entry.make(), start, h, steps);
    record(*entry.info, joinText(turns, " turns"), 0.5, steps, outcome);
    const std::string name = joinText(entry.info->name, ": ", turns, " turns, ");
    checkNear(report, name + "bounded", outcome.bounded ? 1 : 0, 1, 0);
    // Rounding, a random walk: 6.5e-15 in the quick form's 3 turns, 3.3e-14 in 100.
    if (entry.info->symplectic)
      checkBelow(report, name + "angular momentum", outcome.bounded ? outcome.spinChange : std::nan(""),
                 full ? 9e-14 : 1.9e-14);
  }
  return report;
}

}  // namespace ringwatch

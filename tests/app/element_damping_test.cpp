// Damping of elements in scenes: limits in closed form and by running the recursion, a shock that rings less, the
// energy balance, and what is refused.
#include <cmath>
#include <csignal>
#include <map>
#include <string>
#include <vector>

#include <ringwatch/app/scene/integrator_catalog.h>
#include <ringwatch/app/scene/scene.h>
#include <ringwatch/app/scene/scene_discrete.h>
#include <ringwatch/app/scene/scene_keys.h>
#include <ringwatch/app/scene/scene_state.h>
#include <ringwatch/base/error.h>
#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/integrators/symplectic_euler.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <ringwatch/monitor/critical_step.h>
#include <tests/support/body_cases.h>
#include <tests/support/dense.h>
#include <tests/support/meshes.h>
#include <tests/support/random.h>

#include "program.h"

namespace ringwatch {
namespace {

using Eigen::MatrixXd;
using test::Outcome;
using test::Program;
using ::testing::HasSubstr;

/// The largest step of an oscillator of these constants with lagged damping.
double limitOf(double k, double c, double m) { return (std::sqrt(c * c + 4 * k * m) - c) / k; }

// One free component of a cube, whose constants are known: C is beta K of Kelvin-Voigt, alpha m, and of bulk viscosity
// b1 rho c L/V times the square of a quarter of a face.
TEST(ElementDampingInClosedForm, OscillatorsHaveTheirLimitInTheBracket) {
  constexpr double edge = 0.1, E = 1e4, nu = 0.3, density = 1000, shear = E / (2 * (1 + nu)),
                   bulk = E / (3 * (1 - 2 * nu));
  int compared = 0;
  for (const double share : {0.01, 0.3, 1.0, 3.0, 30.0})
    for (const char* kind : {"viscous", "mass", "bulk", "quadratic"}) {
      Body body(test::gridMesh("hex8", {1, 1, 1}, {edge, edge, edge}), makeMaterial("linear", E, nu, density));
      for (std::int32_t i = 0; i < body.nodeCount(); ++i)
        for (int c = 0; c < 3; ++c)
          if (i != 0 || c != 0) body.constraints().fix(i, c);
      const double k = MatrixXd(body.assembleTangent(body.mesh().X))(0, 0), m = body.lumpedMass()[0],
                   c = share * 2 * std::sqrt(k * m), speed = body.blocks()[0]->material().waveSpeed();
      const double face = edge * edge / 4, ofBulk = density * speed * edge / std::pow(edge, 3) * face * face;
      DampingConstants constants;
      NodeVectors v = NodeVectors::Zero(3, body.nodeCount());
      double counted = c;
      if (kind == std::string("viscous")) {
        constants.shearViscosity = c / k * shear;
        constants.volumeViscosity = c / k * bulk;
      } else if (kind == std::string("mass")) {
        constants.massProportional = c / m;
      } else if (kind == std::string("bulk")) {
        constants.linearBulk = c / ofBulk;
      } else {
        // A quarter of it linear, the rest by the rate under compression, which moves the node inwards.
        constants.linearBulk = 0.25 * c / ofBulk;
        constants.quadraticBulk = 1.2;
        const double rate = 0.75 * c / ofBulk / (2 * 1.44 * edge / speed);
        v(0, 0) = rate * std::pow(edge, 3) / face;
      }
      body.setElementDamping({constants});
      body.followDampingRates(body.mesh().X, v);
      if (kind == std::string("quadratic")) counted = 1.025 * c;
      const double h = limitOf(k, c, m), ofCounted = limitOf(k, counted, m);
      const ElementDamping& damping = *body.elementDamping();
      for (const double reference : {1.0, 0.1, 10.0}) {
        body.elementDamping()->setFactor(dampingFactor({}, reference * ofCounted));
        const StepRule rule =
            stepRuleWithDashpots(*integratorCatalog().find("verlet"), {}, reference * ofCounted, damping.overcount());
        const CriticalStep step = criticalStep(body, body.mesh().X, rule);
        if (reference == 1) {
          EXPECT_NEAR(step.safe, ofCounted, 1e-8 * h) << kind << share;
        }
        EXPECT_LE(step.safe, h) << kind << share << " " << reference;
        EXPECT_GE(step.optimistic, h * (1 - 1e-12)) << kind << share << " " << reference;
        // Where a little more counts than there is, the optimistic side gives all of that back.
        EXPECT_NEAR(step.optimistic, limitOf(k, counted / (1 + damping.overcount()), m), 5e-8 * h)
            << kind << share << " " << reference;
        ++compared;
      }
    }
  EXPECT_EQ(compared, 60);
}

// A bar of cubes, held but along it: (√(1 + b1²) - b1) L/c, as Abaqus has it for the damping ratio b1 (Analysis User's
// Manual, "Explicit dynamic analysis").
TEST(ElementDampingInClosedForm, BarsOfCubesHaveTheirStep) {
  constexpr double edge = 0.01, E = 1e5, density = 1000;
  const double speed = std::sqrt(E / density);
  for (const double b1 : {0.06, 0.5, 2.0}) {
    Body body(test::gridMesh("hex8", {20, 1, 1}, {20 * edge, edge, edge}), makeMaterial("linear", E, 0, density));
    for (std::int32_t i = 0; i < body.nodeCount(); ++i) {
      body.constraints().fix(i, 1);
      body.constraints().fix(i, 2);
    }
    body.setElementDamping({{b1, 0, 0, 0, 0}});
    const double h = (std::sqrt(1 + b1 * b1) - b1) * edge / speed;
    body.elementDamping()->setFactor(dampingFactor({}, h));
    const StepRule rule = stepRuleWithDashpots(*integratorCatalog().find("symplectic-euler"), {}, h);
    const GlobalFrequency top = globalFrequency(body, body.mesh().X);
    ASSERT_TRUE(top.converged);
    EXPECT_NEAR(rule(top.lambda), h, 1e-8 * h) << b1;
    const CriticalStep step = criticalStep(body, body.mesh().X, rule);
    EXPECT_LE(step.safe, h * (1 + 1e-9)) << b1;
    EXPECT_GE(step.optimistic, h * (1 - 1e-9)) << b1;
    EXPECT_GE(step.safe, 0.94 * h) << b1;
  }
}

/// The largest root of M (x⁺ - 2x + x⁻)/h² + C (x - x⁻)/h + K x = 0 by size.
double largestRootOf(const MatrixXd& M, const MatrixXd& C, const MatrixXd& K, double h) {
  const Eigen::Index n = M.rows();
  const MatrixXd inverse = M.diagonal().cwiseInverse().asDiagonal();
  MatrixXd T = MatrixXd::Zero(2 * n, 2 * n);
  T.topLeftCorner(n, n) = 2 * MatrixXd::Identity(n, n) - inverse * (h * C + h * h * K);
  T.topRightCorner(n, n) = -MatrixXd::Identity(n, n) + h * inverse * C;
  T.bottomLeftCorner(n, n).setIdentity();
  return test::spectralRadius(T);
}

// The limit is where the recursion itself begins to grow: the safe side is below, the optimistic one above.
TEST(ElementDampingByRecursion, SafeIsBelowAndOptimisticAboveTheLimit) {
  int trials = 0, tight = 0, shortened = 0;
  const IntegratorInfo& info = *integratorCatalog().find("symplectic-euler");
  for (int seed = 0; trials < 10000; ++seed) {
    test::Random random(seed);
    const char* elements[] = {"tet4", "hex8", "wedge6", "pyramid5"};
    Body body(
        test::gridMesh(elements[random.index(4)], {1, 1, 1}, Eigen::Vector3d::Constant(test::cellSize), 0.25, seed),
        makeMaterial(random.index(2) ? "stvk" : "neo-hookean", test::young, 0.3, test::density),
        {{}, Lumping::rowSum, 1});
    std::vector<Eigen::Index> free;
    for (std::int32_t i = 0; i < body.nodeCount(); ++i)
      for (int c = 0; c < 3; ++c)
        if (random.index(3) == 0 && free.size() < 9)
          free.push_back(3 * i + c);
        else
          body.constraints().fix(i, c);
    if (free.empty()) continue;
    const double time =
                     test::cellSize / body.blocks()[0]->material().waveSpeed() * std::pow(10, random.uniform(-2, 0.5)),
                 modulus = body.blocks()[0]->material().restModulus();
    DampingConstants constants;
    if (random.index(2)) constants.linearBulk = std::pow(10, random.uniform(-2, 0.5));
    if (random.index(2)) constants.shearViscosity = time * modulus * random.uniform(0, 1);
    if (random.index(2)) constants.volumeViscosity = time * modulus * random.uniform(0, 1);
    if (random.index(2)) constants.massProportional = random.uniform(0, 1) / time;
    if (!constants.any()) continue;
    body.setElementDamping(std::vector<DampingConstants>(body.blocks().size(), constants));
    if (random.index(2)) {
      DiscreteForces forces(body.nodeCount());
      forces.add(std::vector<Spring>{{.node = static_cast<std::int32_t>(free[0] / 3),
                                      .stiffness = 0,
                                      .damping = random.uniform(0, 1) * modulus * test::cellSize * time}});
      body.setDiscreteForces(std::move(forces));
    }
    const RayleighDamping rayleigh{random.index(2) ? random.uniform(0, 0.3) / time : 0,
                                   random.index(2) ? random.uniform(0, 0.3) * time : 0};
    const NodeVectors x = body.mesh().X + random.nodeVectors(body.nodeCount(), 0.05 * test::cellSize);
    const auto setFactor = [&](double f) {
      body.elementDamping()->setFactor(f);
      if (body.discreteForces()) body.discreteForces()->setDampingFactor(f);
    };
    setFactor(0);
    const MatrixXd whole = body.assembleTangent(x);
    const double f = modulus * test::cellSize / (modulus * test::cellSize * time);
    setFactor(f);
    const MatrixXd damped = body.assembleTangent(x);
    const MatrixXd K = whole(free, free), Cx = (damped - whole)(free, free) / f;
    MatrixXd M = MatrixXd::Zero(K.rows(), K.cols());
    for (Eigen::Index i = 0; i < M.rows(); ++i) M(i, i) = body.lumpedMass()[free[i] / 3];
    const Eigen::VectorXd lambda = test::generalizedEigen(K, M).values;
    if (!(lambda[0] > 1e-9 * lambda[lambda.size() - 1])) continue;
    const MatrixXd C = rayleigh.alpha * M + rayleigh.beta * K + Cx;
    const double undamped = 2 / std::sqrt(lambda[lambda.size() - 1]);
    // At the step that the rule gives back, as "auto" has it, and at others.
    double reference = undamped * std::pow(10, random.uniform(-1, 0.3));
    for (int pass = 0; pass < 4; ++pass) {
      setFactor(dampingFactor(rayleigh, reference));
      const StepRule rule = stepRuleWithDashpots(info, rayleigh, reference);
      const CriticalStep step = criticalStep(body, x, rule);
      ASSERT_LE(largestRootOf(M, C, K, step.safe * (1 - 1e-7)), 1 + 1e-9) << seed << " " << pass;
      ASSERT_GT(largestRootOf(M, C, K, step.optimistic * (1 + 1e-6)), 1) << seed << " " << pass;
      ++trials;
      tight += step.optimistic < 1.02 * step.safe;
      shortened += step.optimistic < 0.9 * undamped;
      reference = step.safe;
    }
  }
  EXPECT_GE(trials, 10000);
  EXPECT_GT(tight, trials / 4);
  EXPECT_GT(shortened, trials / 4);
}

/// A bar of hex8, held but along it, whose left end is driven in; 200 cells of 5 mm.
struct DrivenBar {
  Body body;
  explicit DrivenBar(const DampingConstants& constants)
      : body(test::gridMesh("hex8", {200, 1, 1}, {1, 0.02, 0.02}), makeMaterial("neo-hookean", 1e6, 0, 1000),
             {{}, Lumping::rowSum, 1}) {
    if (constants.any()) body.setElementDamping({constants});
    for (std::int32_t i = 0; i < body.nodeCount(); ++i) {
      body.constraints().fix(i, 1);
      body.constraints().fix(i, 2);
      if (body.mesh().X(0, i) < 1e-9) body.constraints().move(i, 0, 3);
    }
  }
  /// The largest and the mean distance of velocities from the end's between it and the front, at a time, over its own.
  std::pair<double, double> ringing() {
    BodySystem system(body);
    State state = system.initialState();
    SymplecticEuler scheme;
    for (int n = 0; n < 3000; ++n) EXPECT_TRUE(scheme.step(system, state, 5e-6).done);
    double largest = 0, sum = 0;
    int count = 0;
    for (std::int32_t i = 0; i < body.nodeCount(); ++i) {
      if (body.mesh().X(0, i) > 0.45) continue;
      const double off = std::abs(state.v(0, i) / 3 - 1);
      largest = std::max(largest, off);
      sum += off;
      ++count;
    }
    return {largest, sum / count};
  }
};

TEST(ElementDampingInAShock, BulkViscosityDampsTheRinging) {
  const auto [bareLargest, bare] = DrivenBar({}).ringing();
  const auto [largest, mean] = DrivenBar({0.06, 1.2, 0, 0, 0}).ringing();
  // Behind the front all of the bar moves with its end: without viscosity cells ring about that speed.
  EXPECT_GT(bareLargest, 0.3);
  EXPECT_LT(largest, 0.2 * bareLargest);
  EXPECT_LT(mean, 0.2 * bare);
}

constexpr const char* bar =
    R"(mesh = {generate = "bar", size = [0.2, 0.04, 0.04], cells = [10, 2, 2], element = "tet4", jitter = 0.2}
[material]
model = "stvk"
young = 30e3
poisson = 0.3
density = 1000
%s
[integrator]
method = "%s"
step = 5e-4
end = 0.05
[[fix]]
where = "x < 1e-6"
[[initial]]
where = "x > 0.1"
velocity = [-0.5, 0.2, 0]
[damping]
%s
[output]
picture = false
)";

class DampedScene : public Program {
 protected:
  static std::string sceneOf(const std::string& material, const std::string& damping,
                             const std::string& method = "symplectic-euler") {
    std::string text = bar;
    for (const std::string& part : {material, method, damping}) text.replace(text.find("%s"), 2, part);
    return text;
  }
  void refuse(const std::string& text, const std::string& what, const std::string& options = "") {
    refuseScene(text, what, options);
  }
};

TEST_F(DampedScene, EveryKindTakesEnergyAndTheBalanceCloses) {
  int runs = 0;
  for (const auto& [material, damping] : std::vector<std::pair<std::string, std::string>>{
           {"", "bulk_viscosity = true"},
           {"", "bulk_viscosity = true\nquadratic_bulk_viscosity = 0"},
           {"mass_damping = 20", ""},
           {"stiffness_damping = 5e-4", ""},
           {"shear_viscosity = 5\nvolume_viscosity = 10", ""},
           {"mass_damping = 5\nshear_viscosity = 2", "mass = 2\nstiffness = 1e-4\nbulk_viscosity = true"}})
    for (const std::string method : {"symplectic-euler", "verlet"}) {
      runScene(sceneOf(material, damping, method), "--set integrator.step=1e-4");
      const Table history = table("r/history.csv");
      double dissipated = 0, error = 0, kinetic = 0;
      for (std::size_t i = 0; i < history.rows.size(); ++i) {
        kinetic = std::max(kinetic, history.number(i, "kinetic_J"));
        error = std::max(error, std::abs(history.number(i, "balance_error_J")));
        const double now = history.number(i, "dissipated_J");
        EXPECT_GE(now, dissipated * (1 - 1e-12));
        dissipated = now;
      }
      EXPECT_GT(dissipated, 0.003 * kinetic) << material << damping;
      EXPECT_LT(error, (method == "verlet" ? 1e-4 : 0.005) * kinetic) << material << damping;
      EXPECT_EQ(summary_["verdict"], "certified") << material << damping;
      ++runs;
    }
  EXPECT_EQ(runs, 12);
}

/// What the kicks of central differences take by damping before a step of a scene: h d (v₋ + v₊)/2, of the first and
/// the last one half. By the recursion of velocities half a step behind, which both schemes have.
double takenByKicks(const Scene& scene, std::int64_t steps) {
  std::vector<std::string> notes;
  Body body = sceneBody(scene, sceneMesh(scene, notes), 1);
  BodySystem system(body, scene.damping);
  State state = sceneInitialState(scene, system);
  const double h = *scene.step;
  double taken = 0;
  NodeVectors a, d;
  for (std::int64_t k = 0; k <= steps; ++k) {
    system.acceleration(state.time, state.x, state.v, a);
    system.dampingForce(state.x, state.v, d);
    // Verlet begins with the velocity of the state itself.
    const double kick = k == 0 && scene.method == "verlet" ? 0.5 * h : h;
    const NodeVectors after = state.v + kick * a;
    if (k > 0) taken += 0.5 * h * d.cwiseProduct(state.v).sum();
    if (k < steps) taken += 0.5 * h * d.cwiseProduct(after).sum();
    state.v = after;
    state.x += h * after;
    state.time += h;
  }
  return taken;
}

TEST_F(DampedScene, TakesTheEnergyThatTheKicksTake) {
  int runs = 0;
  for (const std::string method : {"symplectic-euler", "verlet"})
    for (const auto& [material, damping] : std::vector<std::pair<std::string, std::string>>{
             {"", "bulk_viscosity = true"},
             {"", "linear_bulk_viscosity = 1.5\nbulk_viscosity = true"},
             {"mass_damping = 200", ""},
             {"stiffness_damping = 5e-3", ""},
             {"mass_damping = 5\nshear_viscosity = 2", "mass = 2\nstiffness = 1e-4\nbulk_viscosity = true"},
             {"", "mass = 50\nstiffness = 1e-3"}}) {
      runScene(sceneOf(material, damping, method), "--set integrator.step=auto --set integrator.end=0.03");
      const double h = summary_["smallest_step"];
      EXPECT_EQ(summary_["verdict"], "certified") << method << material << damping;
      EXPECT_EQ(summary_["events"].size(), 0u) << method << material << damping;
      for (const double step : {0.9 * h, 0.45 * h}) {
        const std::string end = test::digits(64 * step), given = test::digits(step);
        runScene(sceneOf(material, damping, method), "--set integrator.step=" + given + " --set integrator.end=" + end);
        const Scene scene =
            readScene(folder_.path() / "scene.toml", {"integrator.step=" + given, "integrator.end=" + end});
        const double expected = takenByKicks(scene, std::llround(history_.last("step")));
        EXPECT_NEAR(history_.last("dissipated_J"), expected, 1e-9 * expected) << method << material << damping;
        ++runs;
      }
    }
  EXPECT_EQ(runs, 24);
}

// The balance of a damped body closes at the order of the scheme, as without damping.
TEST_F(DampedScene, BalanceClosesAtOrderTwo) {
  for (const auto& [material, damping] : std::vector<std::pair<std::string, std::string>>{
           {"", "bulk_viscosity = true"},
           {"shear_viscosity = 5\nvolume_viscosity = 10", "mass = 5\nstiffness = 1e-4"}}) {
    double errors[2];
    for (const int finer : {0, 1}) {
      runScene(sceneOf(material, damping, "verlet"),
               finer ? "--set integrator.step=2e-5" : "--set integrator.step=4e-5");
      errors[finer] = history_.largest("balance_error_J");
    }
    EXPECT_NEAR(errors[0] / errors[1], 4, 0.4) << material << damping;
  }
}

// Supports that move bring up the damping force of the elements at them.
TEST_F(DampedScene, WorkOfSupportsHasTheDampingOfElementsInIt) {
  for (const std::string method : {"symplectic-euler", "verlet"}) {
    runScene(sceneOf("shear_viscosity = 5\nvolume_viscosity = 10", "bulk_viscosity = true", method) +
                 "[[move]]\nwhere = \"x > 0.1999\"\nvelocity = [-0.2, 0, 0]\n",
             "--set integrator.step=1e-4");
    const double work = history_.largest("external_work_J");
    EXPECT_GT(work, 0);
    EXPECT_GT(history_.largest("dissipated_J"), 0.3 * work) << method;
    EXPECT_LT(history_.largest("balance_error_J"),
              (method == "verlet" ? 0.002 : 0.008) * std::max(work, history_.largest("kinetic_J")))
        << method;
  }
}

// Forces of Kelvin-Voigt and of Rayleigh's stiffness are the same to first order in the strain.
TEST_F(DampedScene, StiffnessDampingIsRayleighsAtSmallStrain) {
  const std::string slow = " --set initial.0.velocity='[-1e-4,2e-5,0]'";
  runScene(sceneOf("stiffness_damping = 2e-4", ""), slow, 0, "own");
  runScene(sceneOf("", "stiffness = 2e-4"), slow, 0, "rayleigh");
  const double own = table("own/history.csv").largest("dissipated_J"),
               rayleigh = table("rayleigh/history.csv").largest("dissipated_J");
  EXPECT_GT(own, 0);
  EXPECT_NEAR(own, rayleigh, 1e-3 * rayleigh);
  runScene(sceneOf("mass_damping = 15", ""), slow, 0, "own");
  runScene(sceneOf("", "mass = 15"), slow, 0, "rayleigh");
  EXPECT_NEAR(table("own/history.csv").largest("dissipated_J"), table("rayleigh/history.csv").largest("dissipated_J"),
              1e-12);
}

TEST_F(DampedScene, AutoTakesTheStepThatDampingLeaves) {
  runScene(sceneOf("", ""), "--set integrator.step=auto", 0, "bare");
  const double bare = table("bare/history.csv").number(0, "h_s");
  for (const auto& [material, damping] : std::vector<std::pair<std::string, std::string>>{
           {"", "bulk_viscosity = true"}, {"stiffness_damping = 1e-3", ""}}) {
    runScene(sceneOf(material, damping), "--set integrator.step=auto", 0, "damped");
    const Table history = table("damped/history.csv");
    const double h = history.number(0, "h_s"), safe = history.number(0, "safe_s"),
                 optimistic = history.number(0, "optimistic_s");
    EXPECT_LT(h, 0.99 * bare) << damping;
    EXPECT_NEAR(h, 0.95 * safe, 1e-6 * safe) << damping;
    EXPECT_GT(safe, 0.95 * optimistic) << damping;  // tight at the reference, which is the step
  }
}

TEST_F(DampedScene, MaterialsDampApart) {
  const std::string two = R"(mesh = {generate = "bar", size = [0.2, 0.04, 0.04], cells = [10, 2, 2], element = "hex8"}
[[material]]
where = "x < 0.1"
model = "stvk"
young = 30e3
poisson = 0.3
density = 1000
mass_damping = 40
[[material]]
where = "x >= 0.1"
model = "yeoh"
c10 = 5e3
c20 = 0
c30 = 0
bulk = 2e5
density = 1000
shear_viscosity = 1
[integrator]
step = 1e-4
end = 1e-3
[[initial]]
where = "x %s 0.1"
velocity = [0, 0, 0.01]
[output]
picture = false
)";
  // A half that moves alone: mass damping is of the first one's mass.
  std::string left = two, right = two;
  left.replace(left.find("%s"), 2, "<");
  right.replace(right.find("%s"), 2, ">");
  runScene(left, "", 0, "left");
  runScene(right, "", 0, "right");
  EXPECT_GT(table("left/history.csv").largest("dissipated_J"), 5 * table("right/history.csv").largest("dissipated_J"));
  EXPECT_GT(table("right/history.csv").largest("dissipated_J"), 0);
}

TEST_F(DampedScene, ResumesBitByBit) {
  const std::string text = sceneOf("shear_viscosity = 1", "bulk_viscosity = true") + "checkpoint_every = 0.02\n";
  runScene(text, "--set integrator.end=0.4");
  ASSERT_EQ(stopRun("--set integrator.end=0.4", hasCheckpoint, "KILL").status, 128 + SIGKILL);
  const Outcome resumed = call("run --resume part");
  EXPECT_EQ(resumed.status, 0) << resumed.err;
  EXPECT_EQ(folder_.read("part/history.csv"), folder_.read("r/history.csv"));
}

// The coefficients of quadratic bulk viscosity that count depend on all velocities since the monitor began.
TEST_F(DampedScene, ResumesBitByBitFromASignal) {
  for (const std::string method : {"symplectic-euler", "verlet"}) {
    runScene(sceneOf("shear_viscosity = 1", "bulk_viscosity = true", method), "--set integrator.end=1.5");
    const Outcome stopped = stopRun("--set integrator.end=1.5", hasTenRows, "TERM");
    ASSERT_EQ(stopped.status, 4) << method << stopped.err;
    const Outcome resumed = call("run --resume part");
    EXPECT_EQ(resumed.status, 0) << resumed.err;
    EXPECT_EQ(folder_.read("part/history.csv"), folder_.read("r/history.csv")) << method;
  }
}

TEST_F(DampedScene, InspectKnowsTheDampingOfARun) {
  const std::string text =
      sceneOf("stiffness_damping = 1e-3", "bulk_viscosity = true\nquadratic_bulk_viscosity = 0") + "every = 0.05\n";
  runScene(text, "--set integrator.step=2e-4");
  const Outcome inspected = call("inspect r --frame 1 --json -");
  ASSERT_EQ(inspected.status, 0) << inspected.err;
  const auto bracket = parse(inspected.out)["critical_step"];
  const Table history = table("r/history.csv");
  const auto safe = bracket["safe"].get<double>(), optimistic = bracket["optimistic"].get<double>();
  EXPECT_GE(safe, history.number(0, "safe_s") * (1 - 1e-6));
  EXPECT_NEAR(optimistic, history.number(0, "optimistic_s"), 0.02 * optimistic);
  // Undamped it would be longer.
  runScene(sceneOf("", "") + "every = 0.05\n", "--set integrator.step=2e-4", 0, "bare");
  EXPECT_LT(optimistic, 0.95 * table("bare/history.csv").number(0, "optimistic_s"));
}

/// The least h at which M - (h/2) C - (h²/4) K is singular, by bisection with dense matrices.
double denseLimit(const Scene& scene, const NodeVectors& x) {
  std::vector<std::string> notes;
  Body body = sceneBody(scene, sceneMesh(scene, notes), 1);
  std::vector<Eigen::Index> free;
  for (std::int32_t i = 0; i < body.nodeCount(); ++i)
    for (int c = 0; c < 3; ++c)
      if (!body.constraints().isConstrained(i, c)) free.push_back(3 * i + c);
  const auto tangentOf = [&](double factor) -> MatrixXd {
    if (body.elementDamping()) body.elementDamping()->setFactor(factor);
    if (body.discreteForces()) body.discreteForces()->setDampingFactor(factor);
    return MatrixXd(body.assembleTangent(x))(free, free);
  };
  const MatrixXd K = tangentOf(0);
  MatrixXd C = tangentOf(1) - K;
  Eigen::VectorXd m(free.size());
  for (std::size_t k = 0; k < free.size(); ++k) m[static_cast<Eigen::Index>(k)] = body.lumpedMass()[free[k] / 3];
  C += scene.damping.beta * K;
  C.diagonal() += scene.damping.alpha * m;
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double h = 0.5 * (low + high);
    const MatrixXd P = MatrixXd(m.asDiagonal()) - 0.5 * h * C - 0.25 * h * h * K;
    (Eigen::LLT<MatrixXd>(P).info() == Eigen::Success ? low : high) = h;
  }
  return low;
}

// The critical step of a damped body is one number, whatever step its scene has.
TEST_F(DampedScene, InspectAndSuggestFindTheOneCriticalStep) {
  int tried = 0;
  for (const auto& [material, damping, more] : std::vector<std::array<std::string, 3>>{
           {"shear_viscosity = 16", "", ""},
           {"mass_damping = 5", "mass = 20\nstiffness = 2e-4\nbulk_viscosity = true", ""},
           {"", "", "[[spring]]\nwhere = \"x > 0.2 - 1e-6\"\nstiffness = 5\ndamping = 3\n"}}) {
    std::string text = sceneOf(material, damping);
    text.replace(text.find("[10, 2, 2]"), 10, "[4, 1, 1]");
    text.replace(text.find("velocity = [-0.5, 0.2, 0]"), 25, "velocity = [1e-9, 0, 0]");
    text += "every = 0.01\n" + more;
    double critical = 0;
    for (const std::string step : {"5e-5", "2e-3", "\\\"auto\\\""}) {
      folder_.write("scene.toml", text);
      call("run scene.toml --out r --set integrator.step=" + step +
           " --set integrator.end=1e-2 --set "
           "monitor.on_violation=warn");
      const Scene scene = readScene(folder_.path() / "scene.toml", {});
      std::vector<std::string> notes;
      if (critical == 0) critical = denseLimit(scene, sceneMesh(scene, notes).X);
      const Outcome outcome = call("inspect r --frame 1 --global --exact --prove " + test::digits(0.9999 * critical) +
                                   " --metric reduced-1-ring --json -");
      ASSERT_EQ(outcome.status, 0) << outcome.err;
      const auto report = parse(outcome.out);
      const auto& found = report["critical_step"];
      const std::string what = joinText(material, damping, more, step);
      EXPECT_NEAR(found["global"].get<double>() / critical, 1, 1e-7) << what;
      EXPECT_LE(found["exact"]["safe"], critical * (1 + 1e-7)) << what;
      EXPECT_GE(found["exact"]["optimistic"], critical * (1 - 1e-7)) << what;
      EXPECT_LT(found["exact"]["optimistic"].get<double>() / found["exact"]["safe"].get<double>(), 1 + 1.1e-6) << what;
      EXPECT_LE(found["safe"], critical * (1 + 1e-7)) << what;
      EXPECT_GE(found["safe"].get<double>(), 0.8 * critical) << what;
      EXPECT_GE(found["optimistic"], critical * (1 - 1e-7)) << what;
      EXPECT_LT(found["optimistic"].get<double>(), 1.001 * critical) << what;
      EXPECT_GE(found["metrics"]["reduced-1-ring"], critical * (1 - 1e-7)) << what;
      EXPECT_EQ(report["prove"]["verdict"], "certified") << what;
      EXPECT_EQ(call("inspect r --frame 1 --prove " + test::digits(1.0001 * critical)).status, 1) << what;
      const auto suggested =
          parse(call("suggest scene.toml --frame 0.02 --json - --set integrator.step=" + step).out)["start"];
      EXPECT_LE(suggested["safe"], critical * (1 + 1e-7)) << what;
      EXPECT_GE(suggested["optimistic"], critical * (1 - 1e-7)) << what;
      EXPECT_GE(suggested["safe"].get<double>(), 0.8 * critical) << what;
      ++tried;
    }
  }
  EXPECT_EQ(tried, 9);
}

// The first row of a run whose step is far below the critical one has the step of the damped body, and not what its
// damping would leave of longer steps if it counted as much there.
TEST_F(DampedScene, AShortStepIsToldTheStepOfTheDampedBody) {
  std::string text = sceneOf("stiffness_damping = 0.1", "");
  text.replace(text.find("[10, 2, 2]"), 10, "[4, 1, 1]");
  text.replace(text.find("velocity = [-0.5, 0.2, 0]"), 25, "velocity = [1e-9, 0, 0]");
  folder_.write("scene.toml", text);
  const Scene scene = readScene(folder_.path() / "scene.toml", {});
  std::vector<std::string> notes;
  const double critical = denseLimit(scene, sceneMesh(scene, notes).X);
  const std::string step = test::digits(1e-3 * critical);
  runScene(text, "--set integrator.step=" + step + " --set integrator.end=" + test::digits(0.02 * critical));
  const Table history = table("r/history.csv");
  for (std::size_t row = 0; row < 20; ++row) {
    EXPECT_LE(history.number(row, "safe_s"), critical * (1 + 1e-9));
    EXPECT_GT(history.number(row, "safe_s"), 0.6 * critical);
    EXPECT_GE(history.number(row, "optimistic_s"), critical * (1 - 1e-9));
  }
  EXPECT_EQ(json("r/summary.json")["certified_steps"], 20);
}

// A body that stiffens until the rule of the longer step does not prove the run's: its own does.
TEST_F(DampedScene, AStepThatIsNoLongerFarBelowTheCriticalOneIsProvenByItsOwnRule) {
  const std::string text = sceneOf("stiffness_damping = 2e-3", "");
  const std::string pulled = text.substr(0, text.find("[[initial]]")) +
                             "[[move]]\nwhere = \"x > 0.2 - 1e-6\"\nvelocity = [1, 0, 0]\n" +
                             text.substr(text.find("[damping]"));
  runScene(pulled, "--set integrator.step=1e-4 --set integrator.end=0.5");
  EXPECT_EQ(json("r/summary.json")["certified_steps"], 5000);
}

TEST_F(DampedScene, RefusesWhatDoesNotGoTogether) {
  refuse(sceneOf("", "quadratic_bulk_viscosity = 1"),
         "damping.quadratic_bulk_viscosity: goes with bulk_viscosity = true");
  std::string rubber = sceneOf("stiffness_damping = 1\nc10 = 1\nc20 = 0\nc30 = 0\nbulk = 10", "");
  for (const std::string line : {"young = 30e3\n", "poisson = 0.3\n"}) rubber.erase(rubber.find(line), line.size());
  rubber.replace(rubber.find("stvk"), 4, "yeoh");
  refuse(rubber,
         "material.stiffness_damping: is a time by which Young's modulus and Poisson's ratio are multiplied, which the "
         "law \"yeoh\" does not have; give shear_viscosity and volume_viscosity");
}

/// The bar of hexahedra of uniform strain.
std::string uniformStrain(std::string text) {
  text.replace(text.find("tet4"), 4, "hex8");
  return text.replace(text.find("density"), 0, "rules = [\"hex8=uniform-strain\"]\n");
}

TEST_F(DampedScene, HourglassControlKeepsTheBalance) {
  for (const std::string material : {"", "hourglass_stiffness = 0.2", "hourglass_viscosity = 0.15",
                                     "hourglass_stiffness = 0.0\nhourglass_viscosity = 0.15", "mass_damping = 5"}) {
    runScene(uniformStrain(sceneOf(material, "", "verlet")), "--set integrator.step=1e-4");
    EXPECT_EQ(summary_["verdict"], "certified") << material;
    EXPECT_LT(history_.largest("balance_error_J"), 0.01 * history_.largest("kinetic_J")) << material;
    if (material.find("visc") == std::string::npos) continue;
    EXPECT_GT(history_.largest("dissipated_J"), 1e-4 * history_.largest("kinetic_J")) << material;
  }
}

// As explicit codes have them: one-point hexahedra with hourglass control and bulk viscosity.
TEST_F(DampedScene, OnePointHexahedraDampAsOthers) {
  for (const char* method : {"verlet", "symplectic-euler"})
    for (const auto& [material, damping] : std::vector<std::pair<std::string, std::string>>{
             {"hourglass_viscosity = 0.1", "bulk_viscosity = true"},
             {"shear_viscosity = 2\nvolume_viscosity = 5", ""},
             {"stiffness_damping = 1e-4", "bulk_viscosity = true\nquadratic_bulk_viscosity = 0"}}) {
      runScene(uniformStrain(sceneOf(material, damping, method)), "--set integrator.step=1e-4");
      EXPECT_EQ(summary_["verdict"], "certified") << material;
      EXPECT_LT(history_.largest("balance_error_J"), 0.01 * history_.largest("kinetic_J")) << material;
      EXPECT_GT(history_.largest("dissipated_J"), 1e-3 * history_.largest("kinetic_J")) << material;
    }
}

TEST_F(DampedScene, HourglassControlIsRefusedWhereItDoesNotFit) {
  for (const char* key : {"hourglass_stiffness", "hourglass_viscosity"})
    refuse(
        sceneOf(std::string(key) + " = 0.1", ""),
        std::string("material.") + key + ": goes with a rule of uniform strain; set rules = [\"hex8=uniform-strain\"]");
}

TEST_F(DampedScene, RefusesEveryKeyByTypeRangeAndName) {
  int tried = 0;
  const auto refuseKey = [&](const std::string& section, const std::string& name, const std::string& value,
                             const std::string& what) {
    const std::string line = name + " = " + value;
    refuse(section == "material" ? sceneOf(line, "") : sceneOf("", line), what);
    ++tried;
  };
  for (const char* key : {"mass_damping", "stiffness_damping", "shear_viscosity", "volume_viscosity",
                          "hourglass_viscosity", "hourglass_stiffness"}) {
    const std::string named = std::string("material.") + key + ": ";
    refuseKey("material", key, "-1", named + "-1 is out of range; must be >= 0");
    refuseKey("material", key, "nan", named + "nan is not a finite number");
    refuseKey("material", key, "\"soft\"", named);
    refuseKey("material", std::string(key) + "s", "1", std::string("did you mean \"") + key + "\"?");
  }
  for (const char* key : {"linear_bulk_viscosity", "quadratic_bulk_viscosity"}) {
    const std::string named = std::string("damping.") + key + ": ";
    refuseKey("damping", key, "-1", named + "-1 is out of range; must be >= 0");
    refuseKey("damping", key, "inf", named + "inf is not a finite number");
    refuseKey("damping", key, "[1]", named);
    refuseKey("damping", std::string(key) + "s", "1", std::string("did you mean \"") + key + "\"?");
  }
  refuseKey("damping", "bulk_viscosity", "1", "damping.bulk_viscosity: ");
  refuseKey("damping", "bulk_viscosit", "true", "did you mean \"bulk_viscosity\"?");
  EXPECT_EQ(tried, 34);
}

}  // namespace
}  // namespace ringwatch

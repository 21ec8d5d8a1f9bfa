#include <ringwatch/verify/monitor/monitor.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Dense>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/median.h>
#include <ringwatch/base/random.h>
#include <ringwatch/body/free_dofs.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/integrators/symplectic_euler.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <ringwatch/monitor/incremental/incremental_nodal_bound.h>
#include <ringwatch/monitor/stability_monitor.h>
#include <ringwatch/verify/monitor/monitor_studies.h>
#include <ringwatch/verify/static_solver.h>
#include <ringwatch/verify/study_bodies.h>

namespace ringwatch::detail {
namespace {

class RandomMatrices : public Random {
 public:
  using Random::Random;
  Eigen::Matrix3d matrix(double scale) {
    return Eigen::Matrix3d::NullaryExpr([&] { return uniform(-scale, scale); });
  }
  Eigen::Matrix3d rotation() {
    return Eigen::AngleAxisd(uniform(0, 2 * std::numbers::pi), Eigen::Vector3d(matrix(1).col(0)).normalized())
        .toRotationMatrix();
  }
};

/// Largest eigenvalue of M⁻¹K over the free degrees of freedom by a dense solver; 0 where nothing is free.
double denseLargest(const Body& body, const NodeVectors& x) {
  const FreeDofs dofs(body);
  if (dofs.count() == 0) return 0;
  const Eigen::VectorXd scale = dofs.gather(body.lumpedMass().transpose().replicate(3, 1)).cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd A =
      scale.asDiagonal() * Eigen::MatrixXd(dofs.reduce(body.assembleTangent(x))) * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(A, Eigen::EigenvaluesOnly);
  return solver.info() == Eigen::Success ? std::max(0.0, solver.eigenvalues()[dofs.count() - 1]) : std::nan("");
}

Mesh randomBox(RandomMatrices& random, std::string_view element) {
  BarOptions options;
  for (std::size_t k = 0; k < 3; ++k) {
    options.cells[k] = 1 + random.index(2);
    options.size[k] = options.cells[k] * random.uniform(0.005, 0.02);
  }
  options.jitter = random.uniform(0, 0.3);
  options.seed = static_cast<std::uint64_t>(random.index(1 << 20));
  options.element = element;
  return generateBar(options);
}

/// What states a trial may be in.
enum class Strain { none, moderate, large, inverted };
constexpr std::array strains{Strain::none, Strain::moderate, Strain::large, Strain::inverted};

NodeVectors deformed(RandomMatrices& random, const NodeVectors& X, Strain strain) {
  if (strain == Strain::none) return X;
  // Rotation, a stretch of every direction between half and double, and noise on the nodes.
  const double largest = strain == Strain::moderate ? 0.1 : 0.7;
  Eigen::Vector3d stretch;
  for (int k = 0; k < 3; ++k) stretch[k] = std::exp(random.uniform(-largest, largest));
  if (strain == Strain::inverted) stretch[random.index(3)] *= -1;
  const double size = (X.rowwise().maxCoeff() - X.rowwise().minCoeff()).minCoeff() / 4;
  NodeVectors x = random.rotation() * stretch.asDiagonal() * random.rotation() * X;
  for (Eigen::Index i = 0; i < x.size(); ++i) x.data()[i] += largest * 0.3 * size * random.uniform(-1, 1);
  return x;
}

}  // namespace

StudyFigure figureOf(std::string name, std::string title, std::string xLabel, std::string yLabel, bool logarithmic,
                     std::initializer_list<const char*> curves) {
  StudyFigure figure;
  figure.name = std::move(name);
  figure.title = std::move(title);
  figure.xLabel = std::move(xLabel);
  figure.yLabel = std::move(yLabel);
  figure.logX = figure.logY = logarithmic;
  for (const char* label : curves) figure.curves.emplace_back().label = label;
  return figure;
}

void studyBracket(StudyReport& report, StudyEffort effort) {
  StudyTable table{
      "bracket",
      "Bracket from scratch against dense eigenvalues, random small meshes, laws, holds and states",
      {"element", "trials", "safe side, worst (%)", "median (%)", "optimistic side, worst (%)", "violations"},
      {}};
  const int rounds = effort == StudyEffort::full ? 25 : 2;
  for (const ElementInfo& info : allElements()) {
    RandomMatrices random(1000 + static_cast<std::uint64_t>(info.nodes));
    std::vector<double> safe, optimistic;
    std::int64_t violations = 0, trials = 0;
    for (int round = 0; round < rounds; ++round)
      for (const LawInfo& law : allLaws())
        for (const Strain strain : strains) {
          if (strain == Strain::inverted && !law.definedInverted) continue;
          BodyOptions options;
          options.threads = 1;
          Body body(randomBox(random, info.name), makeMaterial(law.name, 30e3, random.uniform(0, 0.49), 1000), options);
          const int holds = random.index(3);
          for (std::int32_t node = 0; node < body.nodeCount(); ++node)
            for (int c = 0; c < 3; ++c)
              if ((holds == 1 && body.mesh().X(0, node) < 1e-9) || (holds == 2 && random.index(4) == 0))
                body.constraints().fix(node, c);
          const NodeVectors x = deformed(random, body.mesh().X, strain);
          const double lambda = denseLargest(body, x);
          if (!std::isfinite(lambda) || !(lambda > 0)) continue;
          const double exact = stepFor(lambda, limit);
          const CriticalStep step = criticalStep(body, x, limit);
          ++trials;
          violations +=
              !(step.safe <= exact * (1 + ofTheReference)) || !(step.optimistic >= exact * (1 - ofTheReference));
          safe.push_back(percentBelow(step.safe, exact));
          optimistic.push_back(percentBelow(step.optimistic, exact));
        }
    table.rows.push_back({std::string(info.name), trials, *std::min_element(safe.begin(), safe.end()), median(safe),
                          *std::max_element(optimistic.begin(), optimistic.end()), violations});
    checkBelow(report, joinText(info.name, ": violations of the bracket in ", trials, " trials"),
               static_cast<double>(violations), 0);
  }
  report.tables.push_back(std::move(table));
}

void studyDrift(StudyReport& report, StudyEffort effort) {
  StudyTable table{
      "drift",
      "The incremental nodal bound along random paths, every element checked against an exact evaluation at every "
      "observation",
      {"element", "law", "element and state trials", "evaluated (%)", "violations", "least margin, relative"},
      {}};
  const std::int64_t wanted = effort == StudyEffort::full ? 10'400'000 : 80'000;
  std::vector<const ElementInfo*> elements;
  for (const ElementInfo& info : allElements())
    if (info.order == 1) elements.push_back(&info);
  const std::int64_t share = wanted / static_cast<std::int64_t>(elements.size() * allLaws().size());
  std::int64_t total = 0, violated = 0;
  for (const ElementInfo* info : elements)
    for (const LawInfo& law : allLaws()) {
      RandomMatrices random(77 + static_cast<std::uint64_t>(info->nodes));
      BarOptions bar;
      bar.cells = effort == StudyEffort::full ? std::array{8, 4, 4} : std::array{3, 2, 2};
      for (std::size_t k = 0; k < 3; ++k) bar.size[k] = 0.01 * bar.cells[k];
      bar.jitter = 0.2;
      bar.element = info->name;
      Body body(generateBar(bar), makeMaterial(law.name, young, poisson, density));
      const std::int64_t count = body.mesh().elementCount();
      const NodeVectors& X = body.mesh().X;
      std::int64_t trials = 0, violations = 0, evaluated = 0;
      double margin = infinity;
      while (trials < share) {
        IncrementalNodalBound bound(body);
        // A path: a slow turn and stretch, with noise that grows; now and then a jump.
        const Eigen::Matrix3d rate = random.uniform(0, 4e-3) * random.matrix(1);
        Eigen::Matrix3d F = Eigen::Matrix3d::Identity();
        NodeVectors noise = NodeVectors::Zero(3, X.cols());
        for (int state = 0; state < 40 && trials < share; ++state) {
          F = (Eigen::Matrix3d::Identity() + (state % 13 == 12 ? 20 : 1) * rate) * F;
          for (Eigen::Index i = 0; i < noise.size(); ++i) noise.data()[i] += 4e-6 * random.uniform(-1, 1);
          const NodeVectors x = F * X + noise;
          if (!(bound.update(x).value < infinity)) break;
          if (state > 0) evaluated += bound.statistics().evaluated;
          const double excess = bound.verify(x);
          margin = std::min(margin, -excess);
          // Of the proof's statements, one an element and one a node; that one fails is seen, not how many do.
          violations += !(excess <= 1e-9);
          trials += count;
        }
      }
      total += trials;
      violated += violations;
      table.rows.push_back({std::string(info->name), std::string(law.name), trials,
                            100.0 * static_cast<double>(evaluated) / static_cast<double>(trials), violations, margin});
    }
  checkBelow(report, joinText("violations of the incremental nodal bound in ", total, " element and state trials"),
             static_cast<double>(violated), 0);
  report.tables.push_back(std::move(table));
}

void studyTetrahedron(StudyReport& report) {
  constexpr double edge = 2, unitModulus = 1, unitDensity = 1;
  // Lumped mass over four nodes: omega² = lambda_max(lambda q qᵀ + 2 mu diag(w)), w the eigenvalues of (4/ρ) Σ g gᵀ,
  // q = √w, g the shape gradients.
  const auto corners = [](double scale, double height) {
    Mesh mesh;
    mesh.X.resize(3, 4);
    mesh.X.col(0) = Eigen::Vector3d(0, 0, 0);
    mesh.X.col(1) = Eigen::Vector3d(1, 0, 0);
    mesh.X.col(2) = Eigen::Vector3d(0.5, std::sqrt(0.75), 0);
    mesh.X.col(3) = Eigen::Vector3d(0.5, std::sqrt(0.75) / 3, height * std::sqrt(2.0 / 3));
    mesh.X *= scale;
    mesh.nodeIds = {0, 1, 2, 3};
    mesh.blocks.push_back({ringwatch::elementTypeOf<Tet4>, {0, 1, 2, 3}, {0}});
    return mesh;
  };
  const auto closedForm = [&](const Mesh& mesh, double nu) {
    Eigen::Matrix3d edges;
    for (int a = 0; a < 3; ++a) edges.col(a) = mesh.X.col(a + 1) - mesh.X.col(0);
    const Eigen::Matrix3d g = edges.inverse();  // rows: gradients of nodes 1, 2, 3
    const Eigen::Vector3d g0 = -g.colwise().sum().transpose();
    const Eigen::Matrix3d W = 4 / unitDensity * (g.transpose() * g + g0 * g0.transpose());
    const Eigen::Vector3d w = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(W).eigenvalues();
    const Lame lame = lameConstants(unitModulus, nu);
    const Eigen::Vector3d q = w.cwiseSqrt();
    const Eigen::Matrix3d A = lame.lambda * q * q.transpose() + 2 * lame.mu * Eigen::Matrix3d(w.asDiagonal());
    return std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(A).eigenvalues()[2]);
  };
  const auto computed = [&](const Mesh& mesh, double nu) {
    const Body body(mesh, makeMaterial("stvk", unitModulus, nu, unitDensity));
    return std::sqrt(evaluateMetric("single-element", body, body.mesh().X).lambda);
  };
  StudyTable table{
      "tetrahedron",
      "Regular tetrahedron, edge 2 m, E = 1 Pa, 1 kg/m3: highest frequency",
      {"edge over 2 m", "height over regular", "nu", "computed (rad/s)", "closed form (rad/s)", "relative difference"},
      {}};
  StudyFigure byPoisson = figureOf("monitor-tetrahedron-poisson", "Regular tetrahedron, edge 2 m, E = 1 Pa, 1 kg/m3",
                                   "Poisson's ratio", "highest frequency (rad/s)", false, {"computed", "closed form"});
  StudyFigure byShape =
      figureOf("monitor-tetrahedron-shape", "Regular tetrahedron, nu = 0.3: one height, or all edges, made smaller",
               "share of the regular one", "highest frequency over the regular one's", true, {"height", "size"});
  double worst = 0;
  const auto row = [&](double size, double height, double nu) {
    const Mesh mesh = corners(size * edge, height);
    const double found = computed(mesh, nu), exact = closedForm(mesh, nu), difference = std::abs(found / exact - 1);
    worst = std::max(worst, difference);
    auto& cells = table.rows.emplace_back();
    for (const double value : {size, height, nu, found, exact, difference}) cells.emplace_back(value);
    return std::pair(found, exact);
  };
  for (const double nu : {0.0, 0.1, 0.2, 0.3, 0.4, 0.45, 0.49, 0.499}) {
    const auto [found, exact] = row(1, 1, nu);
    byPoisson.curves[0].x.push_back(nu);
    byPoisson.curves[0].y.push_back(found);
    byPoisson.curves[1].x.push_back(nu);
    byPoisson.curves[1].y.push_back(exact);
  }
  const double regular = row(1, 1, 0.3).first;
  for (const double share : {1.0, 0.5, 0.25, 0.1, 0.01, 1e-3, 1e-6}) {
    byShape.curves[0].x.push_back(share);
    byShape.curves[0].y.push_back(row(1, share, 0.3).first / regular);
    byShape.curves[1].x.push_back(share);
    byShape.curves[1].y.push_back(row(share, 1, 0.3).first / regular);
  }
  // Rounding of the flattest, of height 1e-6: 5e-14.
  checkBelow(report, "tetrahedron: relative difference to the closed form", worst, 1.5e-13);
  report.tables.push_back(std::move(table));
  report.figures.push_back(std::move(byPoisson));
  report.figures.push_back(std::move(byShape));
}

namespace {

struct NamedMesh {
  std::string name;
  Mesh mesh;
};
/// Meshes that differ in what makes a step small: none, jitter, grading, one sliver, element types that share faces.
std::vector<NamedMesh> studyMeshes(StudyEffort effort) {
  const int fine = effort == StudyEffort::full ? 2 : 1;
  std::vector<NamedMesh> meshes;
  BarOptions cube;
  cube.split = 5;
  meshes.push_back({"regular cube, tet4", generateCube(0.05, 5, cube)});
  BarOptions bar;
  bar.cells = {10 * fine, 2 * fine, 2 * fine};
  for (const char* element : {"tet4", "hex8", "wedge6", "pyramid5"}) {
    bar.element = element;
    bar.jitter = 0;
    meshes.push_back({joinText("bar, ", element), generateBar(bar)});
    bar.jitter = 0.25;
    meshes.push_back({joinText("jittered bar, ", element), generateBar(bar)});
  }
  bar.element = "tet4";
  bar.grading = 10;
  meshes.push_back({"graded bar, tet4", generateBar(bar)});
  bar.grading = 1;
  bar.jitter = 0;
  Mesh sliver = generateBar(bar);
  flattenOneElement(sliver, 1e-2);
  meshes.push_back({"bar with a sliver, tet4", std::move(sliver)});
  BarOptions mixed;
  mixed.cells = {10, 2, 2};
  mixed.jitter = 0.1;
  meshes.push_back({"mixed bar", generateMixedBar(mixed)});
  return meshes;
}

}  // namespace

void studyMetrics(StudyReport& report, StudyEffort effort) {
  StudyTable table{"metrics",
                   "Step by each metric against the exact one, at rest, nu = 0.3 (%: negative is pessimistic)",
                   {"mesh", "metric", "direction", "difference (%)"},
                   {}};
  StudyTable rest{"rest",
                  "Bracket at rest from scratch against the exact step",
                  {"mesh", "elements", "safe side (%)", "optimistic side (%)"},
                  {}};
  for (const auto& [name, mesh] : studyMeshes(effort)) {
    const Body body(mesh, makeMaterial("stvk", young, poisson, density));
    const NodeVectors& X = body.mesh().X;
    const GlobalFrequency top = globalFrequency(body, X);
    checkNear(report, name + ": the exact value converged", top.converged ? 1 : 0, 1, 0);
    const double exact = stepFor(top.lambda, limit);
    for (const MetricInfo& info : allMetrics()) {
      const double step = stepFor(evaluateMetric(info.name, body, X).lambda, limit);
      table.rows.push_back(
          {name, std::string(info.name), std::string(directionName(info.direction)), percentBelow(step, exact)});
      if (info.direction == Direction::upperBound)
        checkAtMost(report, joinText(name, ", ", info.name, " is pessimistic: its step over the exact one"),
                    step / exact, 1, ofTheReference);
      if (info.direction == Direction::lowerBound)
        checkAtMost(report, joinText(name, ", ", info.name, " is optimistic: the exact step over its own"),
                    exact / step, 1, ofTheReference);
    }
    const CriticalStep bracket = criticalStep(body, X, limit);
    rest.rows.push_back({name, static_cast<std::int64_t>(mesh.elementCount()), percentBelow(bracket.safe, exact),
                         percentBelow(bracket.optimistic, exact)});
    checkAtMost(report, name + ": safe over exact", bracket.safe / exact, 1, ofTheReference);
    checkAtMost(report, name + ": exact over optimistic", exact / bracket.optimistic, 1, ofTheReference);
    // How far the products of the optimistic side stop short of the exact value: 4.8e-4. The proof stops at 1 %.
    checkAtMost(report, name + ": optimistic over exact", bracket.optimistic / exact, 1, 1.4e-3);
    checkAtLeast(report, name + ": safe over exact, at least", bracket.safe / exact, 1, 0.01);
  }
  report.tables.push_back(std::move(table));
  report.tables.push_back(std::move(rest));
}

void studyObserved(StudyReport& report, StudyEffort effort) {
  StudyTable table{
      "observed",
      "Critical step of real runs (linear law, symplectic Euler, random start), by bisection, in the bracket",
      {"mesh", "safe (s)", "observed (s)", "optimistic (s)", "observed over exact"},
      {}};
  const int steps = effort == StudyEffort::full ? 20000 : 4000;
  for (const auto& [name, mesh] : studyMeshes(StudyEffort::quick)) {
    BodyOptions options;
    options.threads = 1;
    const Body body(mesh, makeMaterial("linear", young, poisson, density), options);
    const NodeVectors& X = body.mesh().X;
    const CriticalStep bracket = criticalStep(body, X, limit);
    BodySystem system(body);
    RandomMatrices random(5);
    NodeVectors kick(3, X.cols());
    for (Eigen::Index i = 0; i < kick.size(); ++i) kick.data()[i] = 1e-6 * random.uniform(-1, 1);
    const auto survives = [&](double h) {
      State state = system.initialState();
      state.v = kick;
      SymplecticEuler integrator;
      for (int i = 0; i < steps; ++i) {
        integrator.step(system, state, h);
        // A stable run stays near kick / omega; growth past a million times that has no way back.
        if (!(state.v.cwiseAbs().maxCoeff() < 1e3)) return false;
      }
      return true;
    };
    double low = 0.9 * bracket.safe, high = 1.1 * bracket.optimistic;
    if (!survives(low) || survives(high)) low = high = std::nan("");
    for (int i = 0; i < 14 && high > low; ++i) {
      const double middle = 0.5 * (low + high);
      (survives(middle) ? low : high) = middle;
    }
    const double observed = 0.5 * (low + high), exact = stepFor(globalFrequency(body, X).lambda, limit);
    table.rows.push_back({name, bracket.safe, observed, bracket.optimistic, observed / exact});
    // Just above the limit growth is slower than the run is long, and the bisection ends at 1.2e-5: together 8e-6.
    constexpr double late = 2.4e-5;
    checkAtMost(report, name + ": safe over observed", bracket.safe / observed, 1, late);
    checkAtMost(report, name + ": observed over optimistic", observed / bracket.optimistic, 1, late);
    checkNear(report, name + ": observed over exact", observed / exact, 1, late);
  }
  report.tables.push_back(std::move(table));
}

}  // namespace ringwatch::detail

namespace ringwatch {

StudyReport verifyMonitor(StudyEffort effort) {
  StudyReport report{"monitor", {}, {}, {}};
  detail::studyBracket(report, effort);
  detail::studyDrift(report, effort);
  detail::studyTetrahedron(report);
  detail::studyMetrics(report, effort);
  detail::studyObserved(report, effort);
  detail::studyHistories(report, effort);
  if (effort == StudyEffort::full) detail::studyCost(report);
  return report;
}

}  // namespace ringwatch

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <numbers>

#include <Eigen/Dense>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <ringwatch/verify/bisection.h>
#include <ringwatch/verify/elements/elements_studies.h>
#include <ringwatch/verify/static_solver.h>
#include <ringwatch/verify/study_bodies.h>

namespace ringwatch::detail {
namespace {

constexpr double length = 0.2, width = 0.04, radius = 0.05;  // m

Mesh bar(std::string_view element, int cells) {
  BarOptions options;
  options.size = {length, width, width};
  options.cells = {5 * cells, cells, cells};
  options.element = element;
  return generateBar(options);
}

/// ω², rad²/s², of the first bending vibration of a cantilever of square section by Timoshenko's beam, nu = 0, shear
/// coefficient 5/6: the root of Huang's frequency equation (J. Appl. Mech. 28, 1961) for clamped and free ends.
double timoshenkoFrequency() {
  const double area = width * width, inertia = area * area / 12, shear = 5.0 / 6 * 0.5 * young;
  const double r2 = inertia / (area * length * length), s2 = young * inertia / (shear * area * length * length);
  const double b = bisect(1.0, 4.5, [&](double z) {
    const double root = std::sqrt((r2 - s2) * (r2 - s2) + 4 / (z * z));
    const double alpha = z * std::sqrt((root - (r2 + s2)) / 2), beta = z * std::sqrt((root + (r2 + s2)) / 2);
    return 2 + (z * z * (r2 - s2) * (r2 - s2) + 2) * std::cosh(alpha) * std::cos(beta) -
           z * (r2 + s2) / std::sqrt(1 - z * z * r2 * s2) * std::sinh(alpha) * std::sin(beta);
  });
  return b * b * young * inertia / (density * area * std::pow(length, 4));
}

/// A vibration with a known answer.
enum class Shape { bar, cantilever, ball };
struct KnownMode {
  std::string name;
  double poisson;
  double lambda;  // ω², rad²/s²
  Shape shape;
  double linearError, quadraticError;  // relative, allowed on the finest mesh of the quick form; 0: not tried
  std::function<NodeVectors(const NodeVectors& X)> guess;
};
std::vector<KnownMode> knownModes() {
  const double rod = std::numbers::pi / length;
  const Lame lame = lameConstants(young, 0.3);
  const double cl2 = (lame.lambda + 2 * lame.mu) / density, ct2 = lame.mu / density;
  // Breathing mode: x cot x = 1 - (c_l/2c_t)² x², x = ω a / c_l (Lamb 1882).
  const double breathing = bisect(1.0, 3.1, [&](double x) { return x / std::tan(x) - 1 + cl2 / (4 * ct2) * x * x; });
  // Torsional mode of degree 2: (l - 1) j_l(x) = x j_(l+1)(x), x = ω a / c_t; the same for every Poisson ratio.
  const double torsional = bisect(1.0, 4.0, [](double x) { return std::sph_bessel(2, x) - x * std::sph_bessel(3, x); });
  return {{.name = "rod, longitudinal, nu = 0",
           .poisson = 0.0,
           .lambda = rod * rod * young / density,
           .shape = Shape::bar,
           .linearError = 0.003,
           .quadraticError = 0.01,
           .guess =
               [](const NodeVectors& X) {
                 NodeVectors u = NodeVectors::Zero(3, X.cols());
                 u.row(0) = (X.row(0) * (std::numbers::pi / length)).array().cos().matrix();
                 return u;
               }},
          {.name = "ball, breathing, nu = 0.3",
           .poisson = 0.3,
           .lambda = std::pow(breathing / radius, 2) * cl2,
           .shape = Shape::ball,
           .linearError = 0.03,
           .quadraticError = 0,
           .guess =
               [breathing](const NodeVectors& X) {
                 // u = j1(k r) in the direction of r, finite at the centre: j1(s)/s = (sin s - s cos s)/s³.
                 NodeVectors u = X;
                 for (Eigen::Index node = 0; node < X.cols(); ++node) {
                   const double t = breathing * X.col(node).norm() / radius;
                   u.col(node) *= t < 1e-3 ? 1.0 / 3 : (std::sin(t) - t * std::cos(t)) / (t * t * t);
                 }
                 return u;
               }},
          {.name = "ball, torsional, nu = 0.3",
           .poisson = 0.3,
           .lambda = std::pow(torsional / radius, 2) * ct2,
           .shape = Shape::ball,
           .linearError = 0.05,
           .quadraticError = 0,
           .guess =
               [torsional](const NodeVectors& X) {
                 // Two halves twisting against each other: u = j2(k r) (a.X / r²) a × X. About a diagonal, since meshes
                 // of tetrahedra are symmetric about that and pick from the five modes of this frequency accordingly.
                 const Eigen::Vector3d axis = Eigen::Vector3d::Ones().normalized();
                 NodeVectors u = NodeVectors::Zero(3, X.cols());
                 for (Eigen::Index node = 0; node < X.cols(); ++node) {
                   const double s = torsional * X.col(node).norm() / radius;
                   // j2(s)/s², finite at the centre.
                   const double profile =
                       s < 1e-2 ? 1.0 / 15
                                : ((3 / (s * s) - 1) * std::sin(s) / s - 3 * std::cos(s) / (s * s)) / (s * s);
                   const Eigen::Vector3d at = X.col(node);
                   u.col(node) = profile * axis.dot(at) * axis.cross(at);
                 }
                 return u;
               }},
          {.name = "cantilever, bending, nu = 0",
           .poisson = 0.0,
           .lambda = timoshenkoFrequency(),
           .shape = Shape::cantilever,
           .linearError = 0.06,
           .quadraticError = 0.01,
           .guess = [](const NodeVectors& X) {
             // Euler and Bernoulli's first mode, sections turned with the axis. Along a diagonal of the section: of the
             // two directions of equal frequency that is the one that meshes of tetrahedra are symmetric about.
             constexpr double k = 1.8751040687119611 / length, c = 0.7340955137589128;
             NodeVectors u = NodeVectors::Zero(3, X.cols());
             const double middle = 0.25 * (X.row(1) + X.row(2)).minCoeff() + 0.25 * (X.row(1) + X.row(2)).maxCoeff();
             for (Eigen::Index node = 0; node < X.cols(); ++node) {
               const double s = k * X(0, node), across = X(1, node) + X(2, node) - 2 * middle;
               u(1, node) = u(2, node) = std::cosh(s) - std::cos(s) - c * (std::sinh(s) - std::sin(s));
               u(0, node) = -across * k * (std::sinh(s) + std::sin(s) - c * (std::cosh(s) - std::cos(s)));
             }
             return u;
           }}};
}

}  // namespace

void studyFrequencies(StudyReport& report, StudyEffort effort) {
  StudyTable table{
      "frequencies",
      "Vibrations, lumped mass, against exact answers (rod: cosine; ball: Lamb 1882) and Timoshenko's beam",
      {"mode", "element", "cells", "frequency (Hz)", "exact (Hz)", "relative error", "rate"},
      {}};
  for (const KnownMode& mode : knownModes()) {
    for (const ElementInfo& info : allElements()) {
      const bool ball = mode.shape == Shape::ball, cantilever = mode.shape == Shape::cantilever;
      if (ball && info.order > 1) continue;  // their straight sides do not follow the sphere
      std::vector<int> meshes = ball             ? std::vector<int>{6, 10}
                                : info.order > 1 ? std::vector<int>{1, 2}
                                : cantilever     ? std::vector<int>{4, 8}
                                                 : std::vector<int>{2, 4};
      if (effort == StudyEffort::full) meshes.push_back(ball ? 16 : std::min(2 * meshes.back(), 12));
      std::vector<double> errors;
      const auto rate = [&](std::size_t from, std::size_t to) {
        return std::log(errors[from] / errors[to]) / std::log(static_cast<double>(meshes[to]) / meshes[from]);
      };
      for (std::size_t m = 0; m < meshes.size(); ++m) {
        BallOptions options;
        options.radius = radius;
        options.cells = meshes[m];
        options.element = info.name;
        Body body(ball ? generateBall(options) : bar(info.name, meshes[m]),
                  makeMaterial("linear", young, mode.poisson, density));
        if (cantilever)
          for (const std::int32_t node : body.mesh().nodeSets.at("x-min")) body.constraints().fix(node);
        double exact = std::sqrt(mode.lambda) / (2 * std::numbers::pi);
        // Flat facets cut off some of the ball: the mesh stands for the ball of its own volume.
        if (ball)
          exact *= std::cbrt(4.0 / 3 * std::numbers::pi * std::pow(radius, 3) * density / body.lumpedMass().sum());
        const NearestMode found = nearestMode(body, body.mesh().X, mode.guess(body.mesh().X));
        const double hertz =
            found.converged && found.overlap > 0.9 ? std::sqrt(found.lambda) / (2 * std::numbers::pi) : std::nan("");
        errors.push_back(std::abs(hertz / exact - 1));
        table.rows.push_back({mode.name, std::string(info.name), std::int64_t{meshes[m]}, hertz, exact, errors[m],
                              m == 0 ? std::nan("") : rate(m - 1, m)});
      }
      const std::string name = std::string(info.name) + ": " + mode.name;
      checkBelow(report, name + ", relative error", errors.back(),
                 info.order == 1 ? mode.linearError : mode.quadraticError);
      // Over all meshes: stiffness errs upward and lumping downward, so that errors fall unevenly, and not at all where
      // the two cancel on every mesh. A beam is itself a model, some 1e-3 off: quadratic elements come down to that.
      const bool cancels = *std::max_element(errors.begin(), errors.end()) < 0.015;
      if ((!cantilever || info.order == 1) && !cancels) {
        checkAtLeast(report, name + ", rate of the frequency", rate(0, meshes.size() - 1), 2, 0.25);
      }
    }
  }
  report.tables.push_back(std::move(table));
}

namespace {

constexpr double tipForce = 1e-4;  // N, small strain

/// Mean deflection under an even traction, work of the load over its force, m.
double deflection(const ElementRule& c, int cells, double ratio) {
  Body body(bar(c.element->name, cells), makeMaterial("linear", young, ratio, density), c.options());
  for (const std::int32_t node : body.mesh().nodeSets.at("x-min")) body.constraints().fix(node);
  body.externalForce() = consistentTraction(
      body.mesh(), [](const Eigen::Vector3d& X) { return X[0] > length * (1 - 1e-9); },
      [](const Eigen::Vector3d&) { return Eigen::Vector3d(0, 0, -tipForce / (width * width)); });
  const StaticSolution solution = solveStatic(body, body.mesh().X);
  if (!solution.converged) return std::nan("");
  return body.externalForce().cwiseProduct(solution.x - body.mesh().X).sum() / tipForce;
}
/// Timoshenko's cantilever with Cowper's shear coefficient (1966) of a rectangle.
double timoshenko(double ratio) {
  const double inertia = std::pow(width, 4) / 12, shear = young / (2 * (1 + ratio)),
               kappa = 10 * (1 + ratio) / (12 + 11 * ratio);
  return tipForce * (std::pow(length, 3) / (3 * young * inertia) + length / (kappa * shear * width * width));
}
/// Seconds of one call, the best of a few.
template <class Call>
double secondsOf(const Call& call) {
  using Clock = std::chrono::steady_clock;
  double best = infinity;
  for (int round = 0; round < 5; ++round) {
    const auto begin = Clock::now();
    int calls = 0;
    double elapsed = 0;
    for (; elapsed < 2e-3; elapsed = std::chrono::duration<double>(Clock::now() - begin).count(), ++calls) call();
    best = std::min(best, elapsed / calls);
  }
  return best;
}

}  // namespace

void studyCantilever(StudyReport& report, StudyEffort effort) {
  const std::vector<double> ratios{0.3, 0.45, 0.49, 0.499};
  StudyTable locking{"locking",
                     "Cantilever 0.2 x 0.04 x 0.04 m: tip deflection over Timoshenko's beam",
                     {"element", "rule", "cells", "nu = 0.3", "nu = 0.45", "nu = 0.49", "nu = 0.499"},
                     {}};
  const int cells = effort == StudyEffort::full ? 4 : 2;
  for (const ElementRule& c : allElementRules()) {
    if (c.element->order == 1 && c.rule->spuriousModes > 0) continue;
    std::vector<StudyTable::Cell> row{std::string(c.element->name), std::string(c.rule->name), std::int64_t{cells}};
    std::vector<double> values;
    for (const double nu : ratios) {
      values.push_back(deflection(c, cells, nu) / timoshenko(nu));
      row.emplace_back(values.back());
    }
    locking.rows.push_back(std::move(row));
    if (c.rule->shares.mean())
      checkAtLeast(report, c.name() + ": deflection at nu = 0.499 over that at 0.3", values[3] / values[0], 1, 0.2);
  }
  report.tables.push_back(std::move(locking));

  const ElementRule best{findElementByName("hex20"), &findElementByName("hex20")->rules[0]};
  const double reference = deflection(best, 4, 0.3);
  // Without Poisson's effect the clamped face is the beam's; with it, it also holds back the contraction across.
  checkNear(report, "hex20 gauss-3x3x3: cantilever over Timoshenko's beam, nu = 0",
            deflection(best, 4, 0) / timoshenko(0), 1, 9e-5);
  checkNear(report, "hex20 gauss-3x3x3: cantilever over Timoshenko's beam, nu = 0.3", reference / timoshenko(0.3), 1,
            0.02);
  StudyTable cost{
      "cost",
      "Cantilever, nu = 0.3: tip error against the time that a simulated second takes at the critical step, one thread",
      {"element", "rule", "cells", "elements", "tip error", "critical step (s)", "force (ns an element)",
       "tangent product (ns an element)", "time per second (s)"},
      {}};
  StudyTable onePercent{"one-percent",
                        "Time for a simulated second at 1 % tip error, interpolated between meshes",
                        {"element", "rule", "time per second (s)"},
                        {}};
  StudyFigure bySize{"elements-tip-error-size",
                     "Cantilever: tip error against element size",
                     "cell size (m)",
                     "relative tip error",
                     true,
                     true,
                     {}};
  StudyFigure byTime{"elements-tip-error-time",
                     "Cantilever: tip error against run time",
                     "time for a simulated second (s)",
                     "relative tip error",
                     true,
                     true,
                     {}};
  for (const ElementRule& c : allElementRules()) {
    if (!c.isDefault() && !c.rule->shares.mean()) continue;
    std::vector<int> meshes = c.element->order == 1 ? std::vector<int>{1, 2, 4} : std::vector<int>{1, 2};
    if (effort == StudyEffort::full) meshes.push_back(c.element->order == 1 ? 8 : 3);
    StudyFigure::Curve size{c.name(), {}, {}}, time{c.name(), {}, {}};
    double crossing = std::nan("");
    for (const int n : meshes) {
      BodyOptions options = c.options();
      options.threads = 1;
      const Body body(bar(c.element->name, n), makeMaterial("stvk", young, 0.3, density), options);
      const double error = std::abs(deflection(c, n, 0.3) / reference - 1);
      const GlobalFrequency top = globalFrequency(body, body.mesh().X, 1e-6);
      const double step = top.converged ? 2 / std::sqrt(top.lambda) : std::nan("");
      Body::Workspace workspace;
      NodeVectors result;
      const NodeVectors& X = body.mesh().X;
      const double seconds = secondsOf([&] { body.internalForce(X, result, workspace); }),
                   product = secondsOf([&] { body.tangentProduct(X, X, result, workspace); });
      const auto count = static_cast<double>(body.mesh().elementCount());
      const double perSecond = seconds / step;
      cost.rows.push_back({std::string(c.element->name), std::string(c.rule->name), std::int64_t{n},
                           static_cast<std::int64_t>(count), error, step, seconds / count * 1e9, product / count * 1e9,
                           perSecond});
      if (error <= 0.01 && std::isnan(crossing)) {
        crossing = perSecond;
        if (!time.x.empty()) {
          const double t = std::log(0.01 / time.y.back()) / std::log(error / time.y.back());
          crossing = time.x.back() * std::pow(perSecond / time.x.back(), t);
        }
      }
      size.x.push_back(width / n);
      size.y.push_back(error);
      time.x.push_back(perSecond);
      time.y.push_back(error);
    }
    onePercent.rows.push_back(
        {std::string(c.element->name), std::string(c.rule->name),
         std::isnan(crossing) ? StudyTable::Cell(std::string("not reached")) : StudyTable::Cell(crossing)});
    bySize.curves.push_back(std::move(size));
    byTime.curves.push_back(std::move(time));
  }
  report.tables.push_back(std::move(cost));
  report.tables.push_back(std::move(onePercent));
  report.figures.push_back(std::move(bySize));
  report.figures.push_back(std::move(byTime));
}

}  // namespace ringwatch::detail

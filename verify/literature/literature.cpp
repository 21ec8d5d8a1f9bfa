#include <ringwatch/verify/literature/literature.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/SparseCore>

#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/body/free_dofs.h>
#include <ringwatch/elements/tet4.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/integrators/stormer_verlet.h>
#include <ringwatch/materials/lame.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/monitor/critical_step.h>
#include <ringwatch/monitor/metrics/metrics.h>
#include <ringwatch/monitor/small/symmetric_eigenpairs.h>
#include <ringwatch/monitor/tangent_bracket.h>
#include <ringwatch/verify/bisection.h>
#include <ringwatch/verify/matrix_eigenvalues.h>
#include <ringwatch/verify/plane_element.h>
#include <ringwatch/verify/static_solver.h>
#include <ringwatch/verify/study_bodies.h>

namespace ringwatch {
namespace {

using detail::highestEigenvalue, detail::verletLimit, std::numbers::pi;

/// Of the highest eigenvalue against a closed form, relative; Lanczos is asked for residuals of 1e-12.
constexpr double ofRounding = 1e-9, lanczosTolerance = 1e-12;

/// The source of what the study's page derives.
constexpr const char* closedForm = "closed form, docs/studies";

struct Solid {
  double young, poisson, density;  // Pa, 1, kg/m³
  Lame lame() const { return lameConstants(young, poisson); }
  double rodSpeed() const { return std::sqrt(young / density); }                                 // m/s
  double pressureSpeed() const { return std::sqrt((lame().lambda + 2 * lame().mu) / density); }  // m/s
  double shearSpeed() const { return std::sqrt(lame().mu / density); }                           // m/s
  Material material() const { return makeMaterial("linear", young, poisson, density); }
};
constexpr Solid steel{210e9, 0.3, 7850}, steelWithoutPoisson{210e9, 0, 7850};

struct Frequency {
  std::string name, source, printed;
  double published, ours;  // Hz
  double allowed;          // relative; NaN: not held to the published one
  std::int64_t elements;
};
struct Step {
  std::string name, source, printed;
  double published, exact;  // s
  CriticalStep bracket;
};
struct Ratio {
  std::string name, source, printed;
  double least, most, ours;
};

double hertz(double lambda) { return std::sqrt(lambda) / (2 * pi); }

/// The frequency, Hz, of the vibration that a guess at its shape means.
double frequencyOf(const Body& body, const std::string& name, const NodeVectors& guess) {
  const NearestMode mode = nearestMode(body, body.mesh().X, guess);
  if (!mode.converged) throw NumericalError("literature: " + name + ": no vibration is like the guess");
  return hertz(mode.lambda);
}

/// Relative error of the frequency of a wave with the wave number k, rad/m, that lumped linear elements of the size h,
/// m, make at most: sin(x)/x >= 1 - x²/6, x = k h / 2.
double dispersion(double k, double h) { return k * h * k * h / 24; }

Mesh box(std::string_view element, const std::array<double, 3>& size, const std::array<int, 3>& cells) {
  BarOptions options;
  options.element = element;
  options.size = size;
  options.cells = cells;
  return generateBar(options);
}

void hold(Body& body, const std::string& set, std::initializer_list<int> components) {
  for (const std::int32_t node : body.mesh().nodeSets.at(set))
    for (const int c : components) body.constraints().move(node, c, 0);
}

/// How the ends of a bar are held, and the numbers q of its frequencies q c / (2 length), c the speed of waves.
struct Ends {
  std::string_view name;
  bool first, last;
  double number(int k) const { return first != last ? k - 0.5 : k; }
};
constexpr std::array<Ends, 3> allEnds{
    {{"free-free", false, false}, {"fixed-free", true, false}, {"fixed-fixed", true, true}}};
constexpr double barLength = 1;  // m

/// A bar of n cubes that move along x alone.
Body barOf(const Solid& solid, int n, const Ends& ends) {
  const double h = barLength / n;
  Body body(box("hex8", {barLength, h, h}, {n, 1, 1}), solid.material());
  for (std::int32_t node = 0; node < body.nodeCount(); ++node)
    for (const int across : {1, 2}) body.constraints().move(node, across, 0);
  if (ends.first) hold(body, "x-min", {0});
  if (ends.last) hold(body, "x-max", {0});
  return body;
}

void studyBars(StudyEffort effort, std::vector<Frequency>& frequencies, std::vector<Step>& steps, StudyReport& report) {
  StudyFigure figure{"literature-bars",
                     "Bars of lumped elements: frequency against that of the continuous bar",
                     "elements",
                     "relative deviation of the frequency",
                     true,
                     true,
                     {}};
  const Solid& solid = steelWithoutPoisson;
  const double c = solid.rodSpeed();
  const std::vector<int> sizes = effort == StudyEffort::full ? std::vector{4, 8, 16, 32, 64, 128} : std::vector{4, 16};
  constexpr int modes = 3;
  for (const Ends& ends : allEnds) {
    std::vector<StudyFigure::Curve> curves(modes);
    for (const int n : sizes) {
      const Body body = barOf(solid, n, ends);
      const double h = barLength / n;
      for (int k = 1; k <= modes; ++k) {
        const double wave = ends.number(k) * pi / barLength;
        NodeVectors guess = NodeVectors::Zero(3, body.nodeCount());
        const double phase = ends.first ? pi / 2 : 0;
        guess.row(0) = (body.mesh().X.row(0).array() * wave - phase).cos().matrix();
        const std::string name = joinText("bar, ", ends.name, ", ", n, " elements, mode ", k);
        const double ours = frequencyOf(body, name, guess), published = wave * c / (2 * pi);
        const double lumped = 2 * c / h * std::sin(wave * h / 2) / (2 * pi);
        checkNear(report, name + ": frequency over that of the lumped chain", ours / lumped, 1, ofRounding);
        frequencies.push_back({name, "Rayleigh 1877", "f = q c / (2 L)", published, ours, dispersion(wave, h), n});
        curves[k - 1].label = joinText(ends.name, ", mode ", k);
        curves[k - 1].x.push_back(n);
        curves[k - 1].y.push_back(1 - ours / published);
      }
      // The highest mode of a chain: as many half waves as the ends leave.
      const int most = ends.first && ends.last ? n - 1 : n;
      const double step = h / c / std::sin(ends.number(most) * pi / (2 * n));
      steps.push_back({joinText("bar, ", ends.name, ", ", n, " elements"),
                       ends.first ? "closed form of the lumped chain" : "Hughes 2000, ch. 9",
                       ends.first ? "h/c / sin(q pi/2n)" : "h/c", step,
                       stepFor(highestEigenvalue(body, lanczosTolerance), verletLimit),
                       criticalStep(body, body.mesh().X, verletLimit)});
    }
    for (StudyFigure::Curve& curve : curves) figure.curves.push_back(std::move(curve));
  }
  report.figures.push_back(std::move(figure));
  // Strain along one axis alone: waves run at the speed of pressure.
  const Body held = barOf(steel, 8, allEnds[0]);
  steps.push_back({"strain along one axis, 8 elements", "Courant, Friedrichs and Lewy 1928", "h/c",
                   barLength / 8 / steel.pressureSpeed(),
                   stepFor(highestEigenvalue(held, lanczosTolerance), verletLimit),
                   criticalStep(held, held.mesh().X, verletLimit)});
}

/// Elements of one size by their matrices.
struct Matrices {
  Matrices(int nodeCount, int ofNode, int ofElement)
      : components(ofNode), nodesOfElement(ofElement), mass(Eigen::VectorXd::Zero(nodeCount)) {}
  int components, nodesOfElement;
  Eigen::VectorXd mass;  // of the nodes, kg
  std::vector<std::int32_t> nodes;
  std::vector<double> tangents;    // N/m
  std::vector<std::uint8_t> held;  // of all components; empty: none is

  /// share: what the element gives the masses of its nodes, kg.
  void add(const std::vector<std::int32_t>& own, const Eigen::MatrixXd& tangent, const Eigen::VectorXd& share) {
    nodes.insert(nodes.end(), own.begin(), own.end());
    tangents.insert(tangents.end(), tangent.data(), tangent.data() + tangent.size());
    mass(own) += share;
  }

  /// The critical step of Verlet, s, by a dense eigenvalue of what is free.
  double exactStep() const {
    const Eigen::Index all = components * mass.size(), size = components * nodesOfElement;
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(all, all);
    std::vector<Eigen::Index> at(static_cast<std::size_t>(size)), free;
    for (std::size_t e = 0; e < nodes.size() / static_cast<std::size_t>(nodesOfElement); ++e) {
      for (Eigen::Index i = 0; i < size; ++i)
        at[static_cast<std::size_t>(i)] =
            components *
                nodes[e * static_cast<std::size_t>(nodesOfElement) + static_cast<std::size_t>(i / components)] +
            i % components;
      K(at, at) +=
          Eigen::Map<const Eigen::MatrixXd>(tangents.data() + e * static_cast<std::size_t>(size * size), size, size);
    }
    Eigen::VectorXd masses(all);
    for (Eigen::Index i = 0; i < all; ++i) {
      masses[i] = mass[i / components];
      if (held.empty() || held[static_cast<std::size_t>(i)] == 0) free.push_back(i);
    }
    return stepFor(denseEigenvalue(K(free, free), masses(free)), verletLimit);
  }

  CriticalStep bracket() const {
    TangentBracket bracket(
        {.values = {mass.data(), static_cast<std::size_t>(mass.size())}, .degreesOfFreedom = components},
        {{nodesOfElement, nodes}}, held);
    return bracket.evaluate({tangents}, verletLimit);
  }

  Step step(std::string name, std::string source, std::string printed, double published) const {
    return {std::move(name), std::move(source), std::move(printed), published, exactStep(), bracket()};
  }
};

/// A bar of n elements with one degree of freedom a node, 1 N/m, 1 kg and 1 m long each.
Matrices matricesOfBar(const Eigen::MatrixXd& K, const Eigen::VectorXd& share, int n) {
  const auto nodes = static_cast<int>(K.rows()), stride = nodes - 1;
  Matrices bar(n * stride + 1, 1, nodes);
  for (int e = 0; e < n; ++e) {
    std::vector<std::int32_t> own;
    for (int a = 0; a < nodes; ++a) own.push_back(e * stride + a);
    bar.add(own, K, share);
  }
  return bar;
}

void studyMatrices(std::vector<Step>& steps) {
  Eigen::MatrixXd linear(2, 2), quadratic(3, 3);
  linear << 1, -1, -1, 1;
  quadratic << 7, -8, 1, -8, 16, -8, 1, -8, 7;
  quadratic /= 3;
  constexpr int elements = 10;
  const Eigen::Vector2d half(0.5, 0.5);
  const char* const source = "Hughes 2000, ch. 9";
  steps.push_back(matricesOfBar(linear, half, elements).step("matrices, linear bar", source, "h/c", 1));
  steps.push_back(
      matricesOfBar(quadratic, Eigen::Vector3d(1, 4, 1) / 6, elements)
          .step("matrices, quadratic bar, lumped by Simpson's rule", source, "h/(6^(1/2) c)", 1 / std::sqrt(6.0)));
  // A penalty of stiffness and mass at the first node: k/m is that of the highest mode, omega² = 4 c²/h², or more.
  for (const double stiffness : {1.0, 1000.0}) {
    Matrices bar = matricesOfBar(linear, half, elements);
    bar.tangents[0] += stiffness;
    bar.mass[0] += stiffness / 4;
    steps.push_back(bar.step(joinText("bar, penalties of stiffness and mass, alpha = ", stiffness),
                             "Askes, Carames-Saddler and Rodriguez-Ferran 2010", "a neutral ratio k/m; 4 c^2/h^2", 1));
  }
}

// Plane strain, of the solid `steel`, in elements of the size 1 m.

struct SpeedSquares {
  double pressure, shear;  // c_p², c_s², m²/s²
};
SpeedSquares speedSquares() { return {std::pow(steel.pressureSpeed(), 2), std::pow(steel.shearSpeed(), 2)}; }

void addPlane(Matrices& matrices, const std::vector<std::int32_t>& own, const PlaneShape& shape) {
  const PlaneElement element = planeElement(shape, steel.young, steel.poisson, steel.density);
  matrices.add(own, element.tangent, element.mass);
}

/// The highest ω², rad²/s², of the modes of constant strain of a plane element with n nodes of the same mass whose
/// gradients in the middle have the Gram matrix S = Σ g gᵀ = diag(a, b): n/ρ times an eigenvalue of C diag(a, b), C the
/// moduli of the two normal strains, or of shear, μ (a + b). That of the fourth mode of the parallelograms here is
/// less.
double ofConstantStrain(int n, double a, double b) {
  const auto [p, s] = speedSquares();
  const double coupling = 4 * (p - 2 * s) * (p - 2 * s) * a * b;
  return n * std::max(0.5 * (p * (a + b) + std::sqrt(p * p * (a - b) * (a - b) + coupling)), s * (a + b));
}

/// Squares and triangles, regular and distorted, alone and free.
void studyDistorted(std::vector<Step>& steps) {
  const auto [p, s] = speedSquares();
  const char* const source = closedForm;
  const auto add = [&](std::string name, std::string printed, double lambda, const PlaneShape& shape) {
    Matrices one(shape.nodes, 2, shape.nodes);
    addPlane(one, shape.nodes == 3 ? std::vector{0, 1, 2} : std::vector{0, 1, 2, 3}, shape);
    steps.push_back(one.step(std::move(name), source, std::move(printed), stepFor(lambda, verletLimit)));
  };
  using Corners = Eigen::Matrix<double, 2, 4>;
  add("square", "h / (2 (c_p^2 - c_s^2))^(1/2)", 8 * (p - s), {4, (Corners() << 0, 1, 1, 0, 0, 0, 1, 1).finished()});
  add("right-angled isosceles triangle", "omega^2 h^2 = 6 (c_p^2 + (c_p^4 - 3 c_s^2 (c_p^2 - c_s^2))^(1/2))",
      6 * (p + std::sqrt(p * p - 3 * s * (p - s))), {3, (Corners() << 0, 1, 0, 0, 0, 0, 1, 0).finished()});
  const auto isosceles = [](double height) {
    return PlaneShape{3, (Corners() << -0.5, 0.5, 0, 0, 0, 0, height, 0).finished()};
  };
  add("equilateral triangle", "h / (3 (c_p^2 - c_s^2))^(1/2)", 12 * (p - s), isosceles(std::sqrt(0.75)));
  const char* const printed = "omega^2 of C S n/rho";
  for (const double height : {0.5, 0.1, 10.0})
    add(joinText("isosceles triangle, height over base ", height), printed,
        ofConstantStrain(3, 2, 1.5 / (height * height)), isosceles(height));
  for (const double ratio : {0.5, 0.1}) {
    add(joinText("rectangle, 1 x ", ratio), printed, ofConstantStrain(4, 1, 1 / (ratio * ratio)),
        {4, (Corners() << 0, 1, 1, 0, 0, 0, ratio, ratio).finished()});
    add(joinText("rhombus, diagonals 1 and ", ratio), printed, ofConstantStrain(4, 2, 2 / (ratio * ratio)),
        {4, (Corners() << 0.5, 0, -0.5, 0, 0, ratio / 2, 0, -ratio / 2).finished()});
  }
}

/// A rectangle of columns × rows squares.
Matrices squares(int columns, int rows) {
  Matrices all((columns + 1) * (rows + 1), 2, 4);
  const PlaneShape square{4, (Eigen::Matrix<double, 2, 4>() << 0, 1, 1, 0, 0, 0, 1, 1).finished()};
  const PlaneElement element = planeElement(square, steel.young, steel.poisson, steel.density);
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const int first = i + (columns + 1) * j, above = first + columns + 1;
      all.add({first, first + 1, above + 1, above}, element.tangent, element.mass);
    }
  return all;
}

/// Rows and squares of square elements by their number and supports: the critical step as a Courant number, over the
/// time in which a pressure wave crosses an element.
///
/// Free meshes: an alternating motion has ω² = 4 c_p²/h², so the number is at most 1; and a mesh that is put together
/// of copies of another has no higher frequency, so it grows as the mesh is doubled. Held at all edges, a mesh is part
/// of the twice larger one: the number falls, and is at least that of the infinite mesh, 1. One held edge: between.
void studySquares(StudyEffort effort, std::vector<Ratio>& ratios, StudyReport& report) {
  const double crossing = 1 / steel.pressureSpeed();
  const char* const source = "Plesek, Kolman and Gabriel 2012";
  const auto add = [&](const std::string& name, const char* printed, double least, double most, const Matrices& mesh) {
    const double exact = mesh.exactStep();
    const CriticalStep bracket = mesh.bracket();
    checkAtMost(report, name + ": safe over the exact step", bracket.safe / exact, 1, ofRounding);
    checkAtMost(report, name + ": exact over the optimistic step", exact / bracket.optimistic, 1, ofRounding);
    ratios.push_back({name, source, printed, least, most, exact / crossing});
    return exact / crossing;
  };
  const auto [p, s] = speedSquares();
  const double single = std::sqrt(p / (2 * (p - s)));
  const int largest = effort == StudyEffort::full ? 16 : 4;
  double row = single, free = single, held = infinity;
  for (int n = 2; n <= largest; n *= 2) {
    row = add(joinText("row of ", n, " squares, free, Courant number"), "grows with the number of elements", row, 1,
              squares(n, 1));
    Matrices mesh = squares(n, n);
    free = add(joinText("square of ", n, " x ", n, ", free, Courant number"), "grows, below 1", free, 1, mesh);
    const auto hold = [&](const auto& holds) {
      mesh.held.clear();
      for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) mesh.held.insert(mesh.held.end(), 2, holds(i, j) ? 1 : 0);
    };
    hold([n](int i, int j) { return i == 0 || j == 0 || i == n || j == n; });
    // With one free node ω² is 4/3 (c_p² + c_s²)/h², what four elements have there over the mass of one.
    const double most = std::isinf(held) ? 2 / std::sqrt(4.0 / 3 * (p + s)) / crossing : held;
    held = add(joinText("square of ", n, " x ", n, ", all edges held, Courant number"), "falls to 1", 1, most, mesh);
    hold([](int i, int) { return i == 0; });
    add(joinText("square of ", n, " x ", n, ", one edge held, Courant number"), "between free and held", free, held,
        mesh);
  }
}

/// The mode of a prism a × a × b with free faces that changes neither volume nor anything along z: exact for every b
/// and every Poisson ratio. u = (-cos kx sin ky, sin kx cos ky), k = pi / a, omega = 2^(1/2) k c_s.
void studyLameMode(StudyEffort effort, std::vector<Frequency>& frequencies) {
  constexpr double edge = 1, height = 0.25;
  constexpr double k = pi / edge;
  for (const int cells : effort == StudyEffort::full ? std::vector{4, 8, 12} : std::vector{4}) {
    const int layers = cells / 4;  // cubes: lumped masses of hex20 err by the size along z too
    const Body body(box("hex20", {edge, edge, height}, {cells, cells, layers}), steel.material());
    const NodeVectors& X = body.mesh().X;
    NodeVectors guess = NodeVectors::Zero(3, X.cols());
    for (Eigen::Index i = 0; i < X.cols(); ++i) {
      guess(0, i) = -std::cos(k * X(0, i)) * std::sin(k * X(1, i));
      guess(1, i) = std::sin(k * X(0, i)) * std::cos(k * X(1, i));
    }
    const std::string name = joinText("square prism, mode of Lame, ", cells, " x ", cells, " x ", layers, " hex20");
    frequencies.push_back({name, "Lame 1852; Mindlin 1956", "f = c_s / (2^(1/2) a)",
                           steel.shearSpeed() / (std::numbers::sqrt2 * edge), frequencyOf(body, name, guess),
                           dispersion(std::numbers::sqrt2 * k, edge / cells), cells * cells * layers});
  }
}

// The plate of NAFEMS FV52; a tenth as thick as long, as that of Srinivas et al.
constexpr Solid plateSolid{200e9, 0.3, 8000};
constexpr double plateEdge = 10, plateHeight = 1;  // m

NodeVectors bendingGuess(const NodeVectors& X, int m, int n) {
  const double a = m * pi / plateEdge, b = n * pi / plateEdge;
  NodeVectors u(3, X.cols());
  for (Eigen::Index i = 0; i < X.cols(); ++i) {
    const double x = X(0, i), y = X(1, i), z = X(2, i) - plateHeight / 2;
    u.col(i) << -z * a * std::cos(a * x) * std::sin(b * y), -z * b * std::sin(a * x) * std::cos(b * y),
        std::sin(a * x) * std::sin(b * y);
  }
  return u;
}

/// ω, rad/s, of the bending vibration with the wave number k, rad/m, of a plate of `plateSolid` with free faces: the
/// lowest root of the Rayleigh-Lamb equation of antisymmetric motions, 4 k² p q tan(q h/2) = -(q² - k²)² tan(p h/2),
/// p² = ω²/c_p² - k², q² = ω²/c_s² - k². Both are imaginary below c_s k: p = i P, q = i Q.
double lambFrequency(double k) {
  return detail::bisect(1e-3 * plateSolid.shearSpeed() * k, (1 - 1e-9) * plateSolid.shearSpeed() * k,
                        [&](double omega) {
                          const auto root = [&](double speed) { return std::sqrt(k * k - std::pow(omega / speed, 2)); };
                          const double P = root(plateSolid.pressureSpeed()), Q = root(plateSolid.shearSpeed());
                          return 4 * k * k * P * Q * std::tanh(Q * plateHeight / 2) -
                                 std::pow(Q * Q + k * k, 2) * std::tanh(P * plateHeight / 2);
                        });
}

/// Edges that stay where they are in z and along themselves, all through the thickness: the motion of an infinite
/// plate, with the wave numbers m pi/a and n pi/a.
void studyElasticPlate(StudyEffort effort, std::vector<Frequency>& frequencies, StudyReport& report) {
  struct Printed {
    int m, n;
    const char* text;
    double value;
  };
  constexpr std::array<Printed, 5> printed{{{1, 1, "0.0932", 0.0932},
                                            {1, 2, "0.2226", 0.2226},
                                            {2, 2, "0.3421", 0.3421},
                                            {1, 3, "0.4171", 0.4171},
                                            {2, 3, "0.5239", 0.5239}}};
  constexpr double lastDigit = 1e-4;
  const double unit = plateSolid.shearSpeed() / plateHeight;  // rad/s
  for (const Printed& p : printed)
    checkNear(report, joinText("elastic plate, mode ", p.m, ", ", p.n, ": omega h/c_s by Lamb, over what is printed"),
              lambFrequency(std::hypot(p.m, p.n) * pi / plateEdge) / unit / p.value, 1, lastDigit / p.value);
  StudyFigure figure{"literature-plate",
                     "Simply supported plate, a tenth as thick as long: hex20 against elasticity",
                     "elements along an edge",
                     "relative deviation of the frequency",
                     true,
                     true,
                     {}};
  for (const Printed& p : printed) figure.curves.push_back({joinText("mode ", p.m, ", ", p.n), {}, {}});
  for (const int cells : effort == StudyEffort::full ? std::vector{8, 16} : std::vector{8}) {
    const int layers = cells / 4;
    Body body(box("hex20", {plateEdge, plateEdge, plateHeight}, {cells, cells, layers}), plateSolid.material());
    for (const char* const side : {"x-min", "x-max"}) hold(body, side, {1, 2});
    for (const char* const side : {"y-min", "y-max"}) hold(body, side, {0, 2});
    for (std::size_t i = 0; i < printed.size(); ++i) {
      const Printed& p = printed[i];
      const std::string name =
          joinText("elastic plate, mode ", p.m, ", ", p.n, ", ", cells, " x ", cells, " x ", layers, " hex20");
      const double wave = std::hypot(p.m, p.n) * pi / plateEdge, published = lambFrequency(wave) / (2 * pi),
                   ours = frequencyOf(body, name, bendingGuess(body.mesh().X, p.m, p.n));
      frequencies.push_back({name, "Lamb 1917; Srinivas, Joga Rao and Rao 1970",
                             joinText("omega h (rho/G)^(1/2) = ", p.text), published, ours,
                             dispersion(wave, plateEdge / cells), layers * cells * cells});
      figure.curves[i].x.push_back(cells);
      figure.curves[i].y.push_back(std::abs(ours / published - 1));
    }
  }
  report.figures.push_back(std::move(figure));
}

/// The lowest frequencies, Hz, ascending; those of rigid motions are 0 to rounding.
Eigen::VectorXd lowestFrequencies(const Body& body, Eigen::Index count, double shift) {
  const FreeDofs dofs(body);
  const Eigen::VectorXd scale = dofs.gather(body.lumpedMass().transpose().replicate(3, 1)).cwiseSqrt().cwiseInverse();
  Eigen::SparseMatrix<double> A = dofs.reduce(body.assembleTangent(body.mesh().X));
  A = scale.asDiagonal() * A * scale.asDiagonal();
  const SymmetricEigenpairs found = nearestEigenpairs(A, shift, {.wanted = count, .basis = 4 * count});
  if (!found.converged) throw NumericalError("literature: the lowest frequencies of a plate did not converge");
  return (found.values.cwiseMax(0).cwiseSqrt() / (2 * pi)).eval();
}

/// Held in z along the lower edges of its sides. The target is that of a thick plate, which is held in its middle.
void studyNafems(StudyEffort effort, std::vector<Frequency>& frequencies) {
  struct Target {
    double hertz;
    double waves;  // wave number over pi / edge, of bending; 0: the plate stretches in its plane
  };
  const std::array<Target, 7> targets{{{45.897, std::hypot(1, 1)},
                                       {109.44, std::hypot(1, 2)},
                                       {109.44, std::hypot(1, 2)},
                                       {167.89, std::hypot(2, 2)},
                                       {193.59, 0},
                                       {206.19, std::hypot(1, 3)},
                                       {206.19, std::hypot(1, 3)}}};  // modes 4 to 10
  constexpr int firstMode = 4;
  constexpr double ofTheSupport = plateHeight / 2 / plateEdge;  // which lies half a height below the plate's middle
  struct Choice {
    const char *element, *rule;
    int cells, layers;
    bool held = true;  // to the targets; finer meshes leave them, since a line cannot support a solid
  };
  std::vector<Choice> choices{{"hex20", "gauss-3x3x3", 8, 1}};
  if (effort == StudyEffort::full) {
    choices.push_back({"hex8", "selective", 16, 3});
    choices.push_back({"hex20", "gauss-3x3x3", 16, 2, false});
  }
  for (const Choice& choice : choices) {
    BodyOptions options;
    options.rules[choice.element] = choice.rule;
    Body body(box(choice.element, {plateEdge, plateEdge, plateHeight}, {choice.cells, choice.cells, choice.layers}),
              plateSolid.material(), options);
    for (const char* const side : {"x-min", "x-max", "y-min", "y-max"})
      for (const std::int32_t node : body.mesh().nodeSets.at(side))
        if (body.mesh().X(2, node) < 1e-9 * plateHeight) body.constraints().move(node, 2, 0);
    const double between = std::pow(2 * pi * targets[0].hertz / 2, 2);  // of the rigid motions and the first vibration
    const Eigen::VectorXd found = lowestFrequencies(body, firstMode - 1 + targets.size(), between);
    for (std::size_t i = 0; i < targets.size(); ++i) {
      const Target& target = targets[i];
      frequencies.push_back({joinText("FV52, mode ", firstMode + i, ", ", choice.cells, " x ", choice.cells, " x ",
                                      choice.layers, " ", choice.element, " ", choice.rule),
                             "NAFEMS FV52 (Abbassian, Dawswell and Knowles 1987)", joinText(target.hertz, " Hz"),
                             target.hertz, found[static_cast<Eigen::Index>(firstMode - 1 + i)],
                             choice.held
                                 ? ofTheSupport + dispersion(target.waves * pi / plateEdge, plateEdge / choice.cells)
                                 : detail::nan,
                             choice.cells * choice.cells * choice.layers});
    }
  }
}

/// One affine hexahedron of mean strain without hourglass control: x = F X of the unit cube.
void studyUniformStrain(std::vector<Ratio>& ratios) {
  struct Shape {
    const char* name;
    Eigen::Matrix3d F;
  };
  Eigen::Matrix3d sheared = Eigen::Matrix3d::Identity();
  sheared(0, 1) = 0.7;
  sheared(1, 2) = -0.4;
  for (const Shape& shape : {Shape{"cube", Eigen::Matrix3d::Identity()},
                             Shape{"1 x 2 x 4", Eigen::Vector3d(1, 2, 4).asDiagonal()}, Shape{"sheared", sheared}}) {
    Mesh mesh = box("hex8", {1, 1, 1}, {1, 1, 1});
    const NodeVectors cube = mesh.X;
    mesh.X = shape.F * cube;
    // Gradients of the shape functions in the middle: ±1/4 along each edge of the cube.
    const NodeVectors gradients = shape.F.inverse().transpose() * ((cube.array() - 0.5) / 2).matrix();
    BodyOptions options;
    options.rules["hex8"] = "uniform-strain";
    options.hourglassControl.stiffness = 0;
    const Body body(mesh, steel.material(), options);
    const double square = std::pow(steel.pressureSpeed(), 2) * 8 * gradients.squaredNorm();
    ratios.push_back({joinText("uniform-strain hexahedron, ", shape.name, ", omega^2 over the bound"),
                      "Flanagan and Belytschko 1984", "1/3 to 1", 1.0 / 3, 1,
                      highestEigenvalue(body, lanczosTolerance) / square});
  }
}

/// A spring of k = alpha E A / h at one end of a bar of n elements: its step over that of the bar.
void studyPenalty(std::vector<Ratio>& ratios) {
  constexpr int n = 16;  // the mode at the spring has decayed to rounding at the other end
  for (const auto& [alpha, text] :
       {std::pair{1.0, "alpha = 1"}, {std::sqrt(48.0), "alpha = 48^(1/2): half the step"}, {1000.0, "alpha = 1000"}}) {
    Body body = barOf(steelWithoutPoisson, n, allEnds[0]);
    const double h = barLength / n;
    std::vector<Spring> springs;
    for (const std::int32_t node : body.mesh().nodeSets.at("x-min")) {
      Spring spring;
      spring.node = node;
      spring.anchor = body.mesh().X.col(node);
      spring.direction = Eigen::Vector3d::UnitX();
      spring.stiffness = alpha * steelWithoutPoisson.young * h / 4;  // E A / h of the section h², at four nodes
      springs.push_back(spring);
    }
    DiscreteForces forces(body.nodeCount());
    forces.add(springs);
    body.setDiscreteForces(std::move(forces));
    const double step = stepFor(highestEigenvalue(body, lanczosTolerance), verletLimit);
    const double expected = std::sqrt(2 / (1 + std::sqrt(1 + alpha * alpha)));
    ratios.push_back({joinText("penalty at the end of a bar, ", text), closedForm,
                      "(2/(1 + (1 + alpha^2)^(1/2)))^(1/2)", expected * (1 - ofRounding), expected * (1 + ofRounding),
                      step / (h / steelWithoutPoisson.rodSpeed())});
  }
}

/// A free bar at the critical step h/c: central differences move waves without error, so that after the period 2 L/c
/// every node is where it began.
void studyWave(std::vector<Ratio>& ratios) {
  constexpr int n = 16;
  const Body body = barOf(steelWithoutPoisson, n, allEnds[0]);
  BodySystem system(body);
  State state = system.initialState();
  constexpr double height = 1e-3, place = 0.3, spread = 0.05;  // m, of a bump that the mesh does not resolve
  const NodeVectors& X = body.mesh().X;
  const auto bump = (height * (-((X.row(0).array() - place) / spread).square()).exp()).matrix();
  state.x.row(0) += bump;
  const NodeVectors start = state.x;
  StormerVerlet verlet;
  double farthest = 0;
  for (int i = 0; i < 2 * n; ++i) {
    verlet.step(system, state, barLength / n / steelWithoutPoisson.rodSpeed());
    farthest = std::max(farthest, (state.x - start).cwiseAbs().maxCoeff());
  }
  const char* const source = "Courant, Friedrichs and Lewy 1928";
  ratios.push_back({"bar, 16 elements, at the critical step: motion left after a period", source, "0 at h/c", 0, 0,
                    (state.x - start).cwiseAbs().maxCoeff() / farthest});
}

void studyFierz(std::vector<Ratio>& ratios) {
  Mesh mesh;
  mesh.X.resize(3, 4);
  mesh.X << 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1, 1;
  mesh.nodeIds = {0, 1, 2, 3};
  mesh.blocks.push_back({elementTypeOf<Tet4>, {0, 2, 1, 3}, {0}});
  // The edge is not printed, and cancels. Each of the two numbers has half a unit of its last digit.
  const auto square = [&](double nu) {
    return highestEigenvalue(Body(mesh, makeMaterial("linear", 1, nu, 1)), lanczosTolerance);
  };
  ratios.push_back({"regular tetrahedron, frequency at nu = 0.49 over that at 0.2", "Fierz 2013, section 3.5",
                    "9.8 rad/s, 1.8 rad/s", 9.75 / 1.85, 9.85 / 1.75, std::sqrt(square(0.49) / square(0.2))});
  BarOptions options;
  options.element = "tet4";
  options.split = 5;
  const Body cube(generateCube(0.05, 5, options), makeMaterial("linear", 1, 0.45, 1));
  const double lambda = highestEigenvalue(cube, lanczosTolerance);
  constexpr double halfPercent = 0.005;
  for (const auto& [metric, printed, ratio] :
       {std::tuple{"single-element", "-29 %", 1.29}, std::tuple{"pressure-wave", "4 %", 0.96}})
    ratios.push_back({joinText("regular cube, ", metric, " over exact frequency"), "Fierz 2013, table 3.2", printed,
                      ratio - halfPercent, ratio + halfPercent,
                      std::sqrt(evaluateMetric(metric, cube, cube.mesh().X).lambda / lambda)});
}

void addTables(const std::vector<Frequency>& frequencies, const std::vector<Step>& steps,
               const std::vector<Ratio>& ratios, StudyReport& report) {
  StudyTable ofFrequencies{
      "frequencies",
      "Published frequencies against those of ringwatch's matrices",
      {"case", "source", "as printed", "published (Hz)", "ours (Hz)", "deviation (%)", "allowed (%)", "elements"},
      {},
      {"body, mesh and mode", "author and year, see the bibliography", "the value or formula there",
       "the same as a frequency", "of K u = omega^2 M u", "ours over published, less 1",
       "largest deviation of either sign that the sources of error explain; NaN: not held to it", "of the mesh"}};
  for (const Frequency& f : frequencies) {
    const double deviation = f.ours / f.published - 1;
    ofFrequencies.rows.push_back(
        {f.name, f.source, f.printed, f.published, f.ours, 100 * deviation, 100 * f.allowed, f.elements});
    if (std::isnan(f.allowed)) continue;
    checkNear(report, f.name + ": frequency over the published one", f.ours / f.published, 1, f.allowed + ofRounding);
  }
  StudyTable ofSteps{
      "steps",
      "Published critical steps against the exact one and the proven bracket",
      {"case", "source", "as printed", "published (s)", "exact (s)", "deviation (%)", "safe (s)", "optimistic (s)"},
      {},
      {"body and mesh", "author and year, see the bibliography", "the formula there", "the formula's value",
       "2/omega of the highest frequency", "exact over published, less 1", "the bracket's proven lower side",
       "the bracket's proven upper side"}};
  for (const Step& s : steps) {
    ofSteps.rows.push_back({s.name, s.source, s.printed, s.published, s.exact, 100 * (s.exact / s.published - 1),
                            s.bracket.safe, s.bracket.optimistic});
    checkNear(report, s.name + ": exact step over the published one", s.exact / s.published, 1, ofRounding);
    checkAtMost(report, s.name + ": safe over the published step", s.bracket.safe / s.published, 1, ofRounding);
    checkAtMost(report, s.name + ": published over the optimistic step", s.published / s.bracket.optimistic, 1,
                ofRounding);
  }
  StudyTable ofRatios{"ratios",
                      "Published ratios and bounds",
                      {"case", "source", "as printed", "least", "most", "ours"},
                      {},
                      {"what over what", "author and year, see the bibliography", "the value or formula there",
                       "the smallest ratio that agrees with it", "the largest", "that of ringwatch's matrices"}};
  for (const Ratio& r : ratios) {
    ofRatios.rows.push_back({r.name, r.source, r.printed, r.least, r.most, r.ours});
    checkNear(report, r.name, r.ours, (r.least + r.most) / 2, (r.most - r.least) / 2 + ofRounding);
  }
  for (StudyTable* table : {&ofFrequencies, &ofSteps, &ofRatios}) report.tables.push_back(std::move(*table));
}

}  // namespace

StudyReport verifyLiterature(StudyEffort effort) {
  StudyReport report{"literature", {}, {}, {}};
  std::vector<Frequency> frequencies;
  std::vector<Step> steps;
  std::vector<Ratio> ratios;
  studyBars(effort, frequencies, steps, report);
  studyMatrices(steps);
  studyDistorted(steps);
  studySquares(effort, ratios, report);
  studyLameMode(effort, frequencies);
  studyElasticPlate(effort, frequencies, report);
  studyNafems(effort, frequencies);
  studyFierz(ratios);
  studyUniformStrain(ratios);
  studyPenalty(ratios);
  studyWave(ratios);
  addTables(frequencies, steps, ratios, report);
  return report;
}

}  // namespace ringwatch

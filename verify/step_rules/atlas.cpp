#include <ringwatch/verify/step_rules/atlas.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/parallel.h>
#include <ringwatch/monitor/critical_step.h>
#include <ringwatch/monitor/metrics/element_metrics.h>
#include <ringwatch/monitor/tangent_bracket.h>
#include <ringwatch/verify/matrix_eigenvalues.h>
#include <ringwatch/verify/step_rules/foreign_rules.h>
#include <ringwatch/verify/step_rules/shapes.h>
#include <ringwatch/verify/study_bodies.h>

namespace ringwatch {
namespace {

using detail::ForeignRule;
using detail::verletLimit;

constexpr std::array<double, 8> ratios{0, 0.1, 0.2, 0.3, 0.4, 0.45, 0.49, 0.499};  // Poisson's
constexpr double youngOfShapes = 1e6, densityOfShapes = 1000;                      // Pa, kg/m³
/// A step this much above the exact one, relative, is unsafe: rounding of the eigenvalues of bad shapes is less.
constexpr double rounding = 1e-9;
/// Shapes that are evaluated together, and those of each family and ratio: 1e7 in all.
constexpr int shapesOfBatch = 256;
int batchesOf(StudyEffort effort) { return effort == StudyEffort::quick ? 1 : 256; }

/// What a rule does on some shapes.
struct Tally {
  std::int64_t shapes = 0, unsafe = 0;
  double waste = 0, error = 0;  // sums
  double largest = 0;           // step over the exact one
  std::string where;            // the corners of that shape
  void add(double ratio, const std::function<std::string()>& corners) {
    ++shapes;
    error += std::abs(ratio - 1);
    if (ratio > 1 + rounding)
      ++unsafe;
    else
      waste += 1 - ratio;
    if (ratio > largest) {
      largest = ratio;
      where = corners();
    }
  }
  Tally& operator+=(const Tally& other) {
    shapes += other.shapes;
    unsafe += other.unsafe;
    waste += other.waste;
    error += other.error;
    if (other.largest > largest) {
      largest = other.largest;
      where = other.where;
    }
    return *this;
  }
};
using Tallies = std::vector<Tally>;  // [rule]

std::vector<ForeignRule> rulesOfShapes() {
  std::vector<ForeignRule> rules;
  for (const ForeignRule& rule : detail::foreignRules())
    if (!rule.ofMeshes) rules.push_back(rule);
  return rules;
}

template <class Points>
std::string cornersText(const Points& X) {
  std::string text;
  for (Eigen::Index a = 0; a < X.cols(); ++a)
    for (Eigen::Index c = 0; c < X.rows(); ++c) text += joinText(c > 0 ? " " : a > 0 ? "; " : "", X(c, a));
  return text;
}

BodyOptions onOneThread() {
  BodyOptions options;
  options.threads = 1;
  return options;
}

/// Some shapes of a family as a body, and where they are.
struct DrawnShapes {
  Body body;
  NodeVectors x;
};
DrawnShapes shapesOf(const ShapeFamily& family, double poisson, int count, std::uint64_t seed) {
  BodyOptions options = onOneThread();
  if (!family.rule.empty()) options.rules.emplace(family.element, family.rule);
  Mesh mesh = meshOfShapes(family, count, seed);
  NodeVectors x = family.stretched ? stretchedShapes(mesh, seed) : mesh.X;
  const char* const law = family.stretched ? "neo-hookean" : "linear";
  return {Body(std::move(mesh), makeMaterial(law, youngOfShapes, poisson, densityOfShapes), options), std::move(x)};
}

std::vector<double> factorsOf(const std::vector<ForeignRule>& rules, double poisson) {
  std::vector<double> factors;
  for (const ForeignRule& rule : rules) factors.push_back(detail::factorOf(rule, poisson));
  return factors;
}

/// factors: of the rules, by factorsOf().
Tallies tallyBatch(const ShapeFamily& family, const std::vector<ForeignRule>& rules, const std::vector<double>& factors,
                   double poisson, std::uint64_t seed) {
  const DrawnShapes shapes = shapesOf(family, poisson, shapesOfBatch, seed);
  const std::vector<double> exact = singleElement(shapes.body, shapes.x)[0];
  const int n = shapes.body.blocks()[0]->element().nodes;
  Tallies tallies(rules.size());
  for (std::size_t r = 0; r < rules.size(); ++r) {
    const MetricValues found = evaluateMetric(rules[r].metric, shapes.body, shapes.x).elementLambda;
    for (std::size_t e = 0; e < exact.size(); ++e)
      if (exact[e] > 0)
        tallies[r].add(factors[r] * std::sqrt(exact[e] / found[0][e]),
                       [&] { return cornersText(shapes.x.middleCols(static_cast<Eigen::Index>(e) * n, n)); });
  }
  return tallies;
}

/// Holds the exact steps of some shapes of a family to dense eigenvalues, and the proven bracket of each to its own.
void checkFamily(StudyReport& report, const ShapeFamily& family) {
  constexpr std::uint64_t checked = 20;
  constexpr double poisson = 0.3, ofEigenvalue = 1e-8;
  double apart = 0, unsafe = 0, unproven = 0;
  for (std::uint64_t seed = 0; seed < checked; ++seed) {
    const DrawnShapes one = shapesOf(family, poisson, 1, seed);
    const double dense = denseEigenvalue(one.body.assembleTangent(one.x), one.body.lumpedMass()),
                 step = stepFor(dense, verletLimit);
    apart = std::max(apart, std::abs(singleElement(one.body, one.x)[0][0] / dense - 1));
    const CriticalStep bracket = criticalStep(one.body, one.x, verletLimit);
    unsafe = std::max(unsafe, bracket.safe / step - 1);
    unproven = std::max(unproven, 1 - bracket.optimistic / step);
  }
  const std::string name(family.name);
  checkBelow(report, name + ": exact eigenvalue against a dense one, relative", apart, ofEigenvalue);
  checkBelow(report, name + ": safe step above the exact one, relative", unsafe, ofEigenvalue);
  checkBelow(report, name + ": optimistic step below the exact one, relative", unproven, ofEigenvalue);
}

// Triangles and quadrilaterals.

/// What a pressure wave has to cross in a plane shape, m, in the order of `planeRules`.
constexpr std::array<std::string_view, 4> planeRules{"shortest edge", "diameter", "A / longest side",
                                                     "A / longest side or diagonal"};
std::array<double, 4> planeLengths(const PlaneShape& shape) {
  double shortest = infinity, longest = 0, diameter = 0, area = 0;
  for (int a = 0; a < shape.nodes; ++a) {
    const Eigen::Vector2d p = shape.X.col(a), q = shape.X.col((a + 1) % shape.nodes);
    shortest = std::min(shortest, (p - q).norm());
    longest = std::max(longest, (p - q).norm());
    area += 0.5 * (p[0] * q[1] - p[1] * q[0]);
    for (int b = 0; b < a; ++b) diameter = std::max(diameter, (p - shape.X.col(b)).norm());
  }
  // LS-DYNA's lengths of shells, ISDO = 0 and 1: twice the area for triangles.
  const double twice = shape.nodes == 3 ? 2 : 1;
  return {shortest, diameter, twice * area / longest, twice * area / diameter};
}

Tallies tallyPlane(int nodes, double poisson, std::uint64_t seed, double* worstOfBracket) {
  const double speed = makeMaterial("linear", youngOfShapes, poisson, densityOfShapes).waveSpeed();
  Random random(seed);
  Tallies tallies(planeRules.size());
  constexpr std::int32_t numbers[] = {0, 1, 2, 3};
  for (int i = 0; i < shapesOfBatch; ++i) {
    const PlaneShape shape = randomPlaneShape(nodes, random);
    const PlaneElement element = planeElement(shape, youngOfShapes, poisson, densityOfShapes);
    const double exact = stepFor(denseEigenvalue(element.tangent, element.mass), verletLimit);
    const std::array<double, 4> lengths = planeLengths(shape);
    for (std::size_t r = 0; r < planeRules.size(); ++r)
      tallies[r].add(lengths[r] / speed / exact, [&] { return cornersText(shape.X.leftCols(nodes)); });
    if (!worstOfBracket) continue;
    const auto count = static_cast<std::size_t>(nodes);
    TangentBracket bracket(NodalMass{{element.mass.data(), count}, 2}, {{nodes, {numbers, count}}});
    const CriticalStep step =
        bracket.evaluate({{element.tangent.data(), static_cast<std::size_t>(element.tangent.size())}}, verletLimit);
    *worstOfBracket = std::max({*worstOfBracket, step.safe / exact - 1, 1 - step.optimistic / exact});
  }
  return tallies;
}

// Tables.

struct Row {
  std::string name;
  std::vector<std::string> rules;
  std::vector<Tallies> byRatio;  // [ratio][rule]
  Tallies all() const {
    Tallies sum = byRatio.front();
    for (std::size_t k = 1; k < byRatio.size(); ++k)
      for (std::size_t r = 0; r < sum.size(); ++r) sum[r] += byRatio[k][r];
    return sum;
  }
};

double digits(double value, double parts) { return std::round(value * parts) / parts + 0.0; }  // no -0

/// A table with a row a family and a column a rule.
void addTable(StudyReport& report, const std::string& name, const std::string& title, const std::vector<Row>& rows,
              double (*value)(const Tally&), double parts, const char* unit = "") {
  StudyTable table{name, title, {"family", "shapes"}, {}};
  for (const std::string& rule : rows.front().rules) table.columns.push_back(rule + unit);
  for (const Row& row : rows) {
    const Tallies all = row.all();
    auto& cells = table.rows.emplace_back();
    cells.emplace_back(row.name);
    cells.emplace_back(all.front().shapes);
    for (const Tally& tally : all) cells.emplace_back(digits(value(tally), parts));
  }
  report.tables.push_back(std::move(table));
}

constexpr const char* percent = " (%)";

void addTables(StudyReport& report, const std::string& suffix, const std::string& what, const std::vector<Row>& rows) {
  addTable(
      report, "unsafe" + suffix, what + ": shapes on which the rule is above the exact step", rows,
      [](const Tally& t) { return 100 * static_cast<double>(t.unsafe) / static_cast<double>(t.shapes); }, 100, percent);
  addTable(
      report, "largest" + suffix, what + ": largest step of the rule over the exact one", rows,
      [](const Tally& t) { return t.largest; }, 1000);
  addTable(
      report, "waste" + suffix, what + ": what a safe step of the rule gives away, mean", rows,
      [](const Tally& t) {
        return 100 * t.waste / static_cast<double>(std::max<std::int64_t>(t.shapes - t.unsafe, 1));
      },
      10, percent);
  addTable(
      report, "error" + suffix, what + ": distance of the rule from the exact step, mean", rows,
      [](const Tally& t) { return 100 * t.error / static_cast<double>(t.shapes); }, 10, percent);
  StudyTable byRatio{"largest-by-poisson" + suffix,
                     what + ": largest step of the rule over the exact one",
                     {"family", "Poisson's ratio"},
                     {}};
  for (const std::string& rule : rows.front().rules) byRatio.columns.push_back(rule);
  StudyTable worst{"worst-shapes" + suffix,
                   what + ": the shape on which a rule is farthest above the exact step",
                   {"family", "rule", "step over exact", "corners (m)"},
                   {}};
  for (const Row& row : rows) {
    for (std::size_t k = 0; k < row.byRatio.size(); ++k) {
      auto& cells = byRatio.rows.emplace_back();
      cells.emplace_back(row.name);
      cells.emplace_back(ratios[k]);
      for (const Tally& tally : row.byRatio[k]) cells.emplace_back(digits(tally.largest, 1000));
    }
    const Tallies all = row.all();
    for (std::size_t r = 0; r < all.size(); ++r)
      worst.rows.push_back({row.name, row.rules[r], digits(all[r].largest, 1000), all[r].where});
  }
  report.tables.push_back(std::move(byRatio));
  report.tables.push_back(std::move(worst));
}

/// Calls add(i) with the tallies of `count` batches, in their order, of which several are made at a time.
template <class Batch>
Tallies sumOfBatches(std::size_t rules, std::int64_t count, const Batch& batch) {
  std::vector<Tallies> parts(static_cast<std::size_t>(count));
  parallelFor(0, count, 0, [&](std::int64_t i) { parts[static_cast<std::size_t>(i)] = batch(i); });
  Tallies sum(rules);
  for (const Tallies& part : parts)
    for (std::size_t r = 0; r < rules; ++r) sum[r] += part[r];
  return sum;
}

// Maps.

/// A map over the places of a corner: rule over exact, on squares whose middles are at the places that are inside.
template <class Values>
void addMap(StudyReport& report, std::string name, std::string title, const std::vector<std::string>& rules,
            double high, const Values& valuesAt) {
  constexpr int squares = 60;  // along each side
  StudySurfaces map{std::move(name), std::move(title), "step of the rule over the exact one", {}};
  for (const std::string& rule : rules) map.panels.push_back({rule, {}, {}});
  const double side = 1.0 / squares;
  for (int i = 0; i < squares; ++i)
    for (int j = 0; j < squares; ++j) {
      const double x = (i + 0.5) * side, y = (j + 0.5) * side * high;
      const std::vector<double> values = valuesAt(x, y);
      for (std::size_t r = 0; r < values.size(); ++r)
        for (const auto& [di, dj] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}}) {
          map.panels[r].points.push_back({(i + di) * side, (j + dj) * side * high, 0});
          map.panels[r].values.push_back(values[r]);
        }
    }
  report.surfaces.push_back(std::move(map));
}

void addMaps(StudyReport& report, const std::vector<ForeignRule>& rules) {
  constexpr double poisson = 0.3;
  const Material material = makeMaterial("linear", youngOfShapes, poisson, densityOfShapes);
  addMap(report, "atlas-triangles",
         "Triangles on the side from (0, 0) to (1, 0), by the place of the third corner, nu = 0.3",
         {planeRules.begin(), planeRules.end()}, 1, [&](double x, double y) {
           const PlaneShape shape{3, (Eigen::Matrix<double, 2, 4>() << 0, 1, x, 0, 0, 0, y, 0).finished()};
           const PlaneElement element = planeElement(shape, youngOfShapes, poisson, densityOfShapes);
           const double exact = stepFor(denseEigenvalue(element.tangent, element.mass), verletLimit);
           std::vector<double> values;
           for (const double length : planeLengths(shape)) values.push_back(length / material.waveSpeed() / exact);
           return values;
         });
  const std::vector<double> factors = factorsOf(rules, poisson);
  std::vector<std::string> names;
  for (const ForeignRule& rule : rules) names.emplace_back(rule.column);
  addMap(report, "atlas-tetrahedra",
         "Tetrahedra on an equilateral triangle of side 1 by the place of the fourth corner: to the right along the "
         "height of the triangle, upwards above it, nu = 0.3",
         names, 1, [&](double x, double z) {
           Mesh mesh;
           mesh.X.resize(3, 4);
           const double height = std::sqrt(0.75);
           mesh.X << 0, 0, height, x, -0.5, 0.5, 0, 0, 0, 0, 0, z;
           mesh.blocks = {{findElementByName("tet4")->type, {1, 0, 2, 3}, {}}};
           const Body body(mesh, material, onOneThread());
           const double exact = singleElement(body, mesh.X)[0][0];
           std::vector<double> values;
           for (std::size_t r = 0; r < rules.size(); ++r)
             values.push_back(factors[r] * std::sqrt(exact / evaluateMetric(rules[r].metric, body, mesh.X).lambda));
           return values;
         });
}

}  // namespace

StudyReport verifyAtlas(StudyEffort effort) {
  StudyReport report{"atlas", {}, {}, {}};
  const std::vector<ForeignRule> rules = rulesOfShapes();
  const int batches = batchesOf(effort);
  std::vector<std::vector<double>> factors;  // [ratio][rule]
  for (const double poisson : ratios) factors.push_back(factorsOf(rules, poisson));
  std::vector<Row> solids, plane;
  for (const ShapeFamily& family : shapeFamilies()) {
    Row& row = solids.emplace_back(Row{std::string(family.name), {}, {}});
    for (const ForeignRule& rule : rules) row.rules.emplace_back(rule.column);
    for (std::size_t k = 0; k < ratios.size(); ++k)
      row.byRatio.push_back(sumOfBatches(rules.size(), batches, [&](std::int64_t i) {
        return tallyBatch(family, rules, factors[k], ratios[k], static_cast<std::uint64_t>(i) * ratios.size() + k + 1);
      }));
    checkFamily(report, family);
  }
  addTables(report, "", "Solid elements alone, free", solids);
  for (const int nodes : {3, 4}) {
    const std::string name = nodes == 3 ? "triangles" : "quadrilaterals";
    Row& row = plane.emplace_back(Row{name, {planeRules.begin(), planeRules.end()}, {}});
    for (std::size_t k = 0; k < ratios.size(); ++k)
      row.byRatio.push_back(sumOfBatches(planeRules.size(), batches, [&](std::int64_t i) {
        return tallyPlane(nodes, ratios[k], static_cast<std::uint64_t>(i) * ratios.size() + k + 1, nullptr);
      }));
    double worst = 0;
    constexpr double poisson = 0.3, ofEigenvalue = 1e-8;
    tallyPlane(nodes, poisson, 0, &worst);
    checkBelow(report, name + ": bracket from tangents beside the exact step, relative", worst, ofEigenvalue);
  }
  addTables(report, "-plane", "Plane strain, alone, free", plane);
  detail::addRulesOnMeshes(report);
  addMaps(report, rules);
  return report;
}

}  // namespace ringwatch

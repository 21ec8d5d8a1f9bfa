#include <cmath>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <ringwatch/base/error.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <ringwatch/monitor/critical_step.h>
#include <ringwatch/monitor/step_limit.h>
#include <ringwatch/verify/step_rules/atlas.h>
#include <ringwatch/verify/step_rules/foreign_rules.h>
#include <ringwatch/verify/study_bodies.h>

namespace ringwatch::detail {
namespace {

struct RuleCase {
  std::string name;
  Mesh mesh;
  double poisson = 0.3;
};

std::vector<RuleCase> ruleCases() {
  BarOptions regular;
  regular.size = {0.16, 0.04, 0.04};
  regular.cells = {8, 2, 2};
  std::vector<RuleCase> cases;
  const auto add = [&](std::string name, const BarOptions& options, double poisson = 0.3) {
    cases.push_back({std::move(name), generateBar(options), poisson});
  };
  BarOptions bar = regular;
  for (const auto& [element, split, name] : {std::tuple{"tet4", 6, "tet4, six a cell"},
                                             {"tet4", 5, "tet4, five a cell"},
                                             {"hex8", 0, "hex8"},
                                             {"wedge6", 0, "wedge6"},
                                             {"pyramid5", 0, "pyramid5"},
                                             {"tet10", 0, "tet10"},
                                             {"hex20", 0, "hex20"}}) {
    bar.element = element;
    bar.split = split;
    for (const double jitter : {0.0, 0.25}) {
      bar.jitter = jitter;
      add(joinText(name, jitter > 0 ? ", jittered" : ""), bar);
    }
  }
  for (const char* element : {"tet4", "hex8", "wedge6"}) {
    bar = regular;
    bar.element = element;
    bar.size = {0.16, 0.04, 0.004};
    add(joinText(element, ", flat, 10:10:1"), bar);
    bar.size = {0.016, 0.004, 0.04};
    add(joinText(element, ", slender, 1:1:10"), bar);
  }
  for (const double height : {0.1, 0.01}) {
    bar = regular;
    Mesh mesh = generateBar(bar);
    flattenOneElement(mesh, height);
    cases.push_back({joinText("tet4, one sliver of ", height, " of its height"), std::move(mesh)});
  }
  for (const char* element : {"tet4", "hex8"}) {
    bar = regular;
    bar.element = element;
    add(joinText(element, ", nu = 0.49"), bar, 0.49);
  }
  bar = regular;
  bar.grading = 10;
  add("tet4, graded 1:10", bar);
  bar.cells = {10, 2, 2};
  cases.push_back({"every linear element", generateMixedBar(bar)});
  for (const char* element : {"tet4", "hex8", "wedge6", "pyramid5"}) {
    cases.push_back({joinText(element, ", ball"), generateBall({.radius = 0.08, .cells = 4, .element = element})});
    cases.push_back({joinText(element, ", ring"),
                     generateRing({.radius = 0.08, .inner = 0.05, .width = 0.04, .element = element})});
  }
  cases.push_back(
      {"tet4, gear",
       generateRing(
           {.radius = 0.08, .inner = 0.03, .width = 0.02, .cells = {64, 2, 1}, .teeth = 8, .toothDepth = 0.015})});
  RefinedBarOptions refined{.coarse = regular, .finest = 0.004, .plane = 0.05, .growth = 0.3};
  refined.coarse.element = "tet4";
  refined.coarse.split = 0;
  cases.push_back({"tet4, refined at a plane", generateRefinedBar(refined)});
  return cases;
}

/// Three digits after the point, as a reader compares them.
double rounded(double value) { return std::round(1000 * value) / 1000; }

}  // namespace

void addRulesOnMeshes(StudyReport& report) {
  StudyTable table{"step-rules",
                   "Step of each rule over the exact one (above 1: unsafe): meshes of 0.16 m, E = 1 MPa, nu = 0.3, "
                   "1000 kg/m3, free",
                   {"mesh", "exact (us)"},
                   {}};
  const std::span<const ForeignRule> rules = foreignRules();
  for (const ForeignRule& rule : rules) table.columns.emplace_back(rule.column);
  table.columns.emplace_back("proven safe");
  struct Worst {
    std::int64_t unsafe = 0;
    double most = 0;
    std::string mesh;
  };
  std::vector<Worst> worst(rules.size());
  constexpr double young = 1e6, density = 1000, ofTheReference = 1e-9;
  const std::vector<RuleCase> cases = ruleCases();
  for (const RuleCase& one : cases) {
    const Body body(one.mesh, makeMaterial("linear", young, one.poisson, density));
    const NodeVectors& X = body.mesh().X;
    const double exact = stepFor(highestEigenvalue(body, 1e-10), verletLimit);
    auto& row = table.rows.emplace_back();
    row.emplace_back(one.name);
    row.emplace_back(rounded(1e6 * exact));
    for (std::size_t r = 0; r < rules.size(); ++r) {
      const double share = factorOf(rules[r], one.poisson) *
                           stepFor(evaluateMetric(rules[r].metric, body, X).lambda, verletLimit) / exact;
      row.emplace_back(rounded(share));
      worst[r].unsafe += share > 1 + ofTheReference ? 1 : 0;
      if (share > worst[r].most) {
        worst[r].most = share;
        worst[r].mesh = one.name;
      }
    }
    const CriticalStep bracket = criticalStep(body, X, verletLimit);
    row.emplace_back(rounded(bracket.safe / exact));
    checkAtMost(report, one.name + ": safe over exact", bracket.safe / exact, 1, ofTheReference);
    checkAtLeast(report, one.name + ": safe over exact, at least", bracket.safe / exact, 1, 0.01);
    checkAtMost(report, one.name + ": exact over optimistic", exact / bracket.optimistic, 1, ofTheReference);
  }
  StudyTable unsafe{"unsafe-meshes",
                    joinText("Rules that are unsafe, of ", cases.size(), " meshes"),
                    {"rule", "unsafe on", "largest step over exact", "on"},
                    {}};
  for (std::size_t r = 0; r < rules.size(); ++r)
    unsafe.rows.push_back({std::string(rules[r].column), worst[r].unsafe, rounded(worst[r].most), worst[r].mesh});
  report.tables.push_back(std::move(table));
  report.tables.push_back(std::move(unsafe));
}

}  // namespace ringwatch::detail

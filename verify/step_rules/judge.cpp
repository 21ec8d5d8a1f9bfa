#include <ringwatch/verify/step_rules/judge.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/integrators/symplectic_euler.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <ringwatch/monitor/step_limit.h>
#include <ringwatch/verify/monitor/monitor_histories.h>
#include <ringwatch/verify/step_rules/shapes.h>
#include <ringwatch/verify/study_bodies.h>

namespace ringwatch {
namespace {

/// Relative tolerance of the exact eigenvalues, and what a step may be above the exact one for it.
constexpr double ofEigenvalue = 1e-9, ofStep = 1e-8;

/// Judges case after case, and counts.
class Judge {
 public:
  Judge(const StepRuleOfOthers& rule, Judgement& found) : rule_(rule), found_(found) {}

  /// The body's exact step at x against the rule's. Throws InputError where there is none.
  void judge(const std::string& name, std::string_view law, const Body& body, NodeVectorsView x, double young,
             double poisson, double density) {
    const GlobalFrequency top = globalFrequency(body, x, ofEigenvalue);
    if (!top.converged || !(top.lambda > 0)) throw InputError(joinText(name, ": has no highest frequency"));
    const double exact = stepFor(top.lambda, detail::verletLimit);
    Mesh mesh = body.mesh();
    mesh.X = x;
    const double given = rule_(mesh, young, poisson, density);
    if (!(given > 0) || given == infinity)
      throw InputError(joinText(name, ": the rule gives ", given, " s; must be above 0 and finite"));
    const double ratio = given / exact;
    ++cases_;
    if (ratio > 1 + ofStep)
      ++unsafe_;
    else
      waste_ += 1 - ratio;
    largest_ = std::max(largest_, ratio);
    if (!(ratio > 1 + ofStep) || (found_.worst && ratio <= found_.worst->given / found_.worst->exact)) return;
    std::vector<std::int32_t> held;
    for (std::int32_t node = 0; node < body.nodeCount(); ++node)
      if (body.constraints().freeComponents(node) == 0) held.push_back(node);
    found_.worst = {name,  std::move(mesh), body.mesh().X, std::string(law), std::move(held),
                    given, exact,           young,         poisson,          density};
  }

  /// Ends the cases of a row of the table.
  void endRow(const std::string& name) {
    if (cases_ == 0) return;
    const std::int64_t safe = cases_ - unsafe_;
    StudyTable& table = found_.report.tables.front();
    table.rows.push_back({name, cases_, unsafe_, largest_,
                          safe > 0 ? StudyTable::Cell(100 * waste_ / static_cast<double>(safe)) : std::string("-")});
    checkAtMost(found_.report, name + ": largest step over the exact one", largest_, 1, ofStep);
    cases_ = unsafe_ = 0;
    waste_ = largest_ = 0;
  }

 private:
  const StepRuleOfOthers& rule_;
  Judgement& found_;
  std::int64_t cases_ = 0, unsafe_ = 0;
  double waste_ = 0, largest_ = 0;
};

void judgeShapes(Judge& judge, const JudgeOptions& options) {
  for (const std::string& element : options.elements) {
    std::string known;
    bool found = false;
    for (const ShapeFamily& family : shapeFamilies()) {
      found = found || family.element == element;
      if (known.find(family.element) == std::string::npos) known += joinText(known.empty() ? "" : ", ", family.element);
    }
    if (!found) throw InputError(joinText("element \"", element, "\": has no shapes to judge by; these have: ", known));
  }
  for (const ShapeFamily& family : shapeFamilies()) {
    // The rule of others is for full integration, at rest.
    if (family.stretched || !family.rule.empty()) continue;
    if (!options.elements.empty() && std::ranges::find(options.elements, family.element) == options.elements.end())
      continue;
    for (int k = 0; k < options.shapesOfFamily; ++k) {
      const Body body(meshOfShapes(family, 1, static_cast<std::uint64_t>(k)),
                      makeMaterial("linear", options.young, options.poisson, options.density));
      judge.judge(joinText(family.name, ", shape ", k + 1), "linear", body, body.mesh().X, options.young,
                  options.poisson, options.density);
    }
    judge.endRow(std::string(family.name));
  }
}

void judgeHistories(Judge& judge) {
  // States of each history up to its middle, which it reaches by a fraction of its own, unstable step.
  constexpr int states = 5, parts = 3;
  for (const detail::History& history : detail::monitorHistories(StudyEffort::quick)) {
    BodySystem system(history.body);
    State state = detail::gentleStart(system);
    SymplecticEuler integrator;
    const int every = std::max(1, parts * history.steps / (2 * states));
    for (int step = 0; step <= states * every; ++step) {
      if (step % every == 0) {
        if (!(history.body.leastDeterminant(state.x).value > 0)) break;  // it has collapsed
        judge.judge(joinText(history.name, ", time ", state.time, " s"), "stvk", history.body, state.x, detail::young,
                    detail::poisson, detail::density);
      }
      integrator.step(system, state, history.h / parts);
    }
    judge.endRow(history.title);
  }
}

}  // namespace

Judgement judgeRule(const StepRuleOfOthers& rule, const JudgeOptions& options) {
  Judgement found{{"judge", {}, {}, {}}, std::nullopt};
  found.report.tables.push_back({"judge",
                                 "Step of the rule against the exact one of central differences",
                                 {"on", "cases", "unsafe", "largest step over exact", "given away where safe (%)"},
                                 {}});
  Judge judge(rule, found);
  judgeShapes(judge, options);
  for (const auto& [name, mesh] : options.meshes) {
    const Body body(mesh, makeMaterial("linear", options.young, options.poisson, options.density));
    judge.judge(name, "linear", body, body.mesh().X, options.young, options.poisson, options.density);
    judge.endRow(name);
  }
  if (options.histories) judgeHistories(judge);
  if (found.report.checks.empty())
    throw InputError("nothing to judge the rule on: give a mesh, histories or more than 0 shapes");
  return found;
}

}  // namespace ringwatch

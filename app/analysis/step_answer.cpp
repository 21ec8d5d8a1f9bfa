#include <ringwatch/app/analysis/step_answer.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include <ringwatch/app/scene/scene_discrete.h>
#include <ringwatch/monitor/critical_step.h>
#include <ringwatch/monitor/event.h>
#include <ringwatch/monitor/stability_monitor.h>

namespace ringwatch {

using Json = nlohmann::ordered_json;

double stepsIn(double time, double h) {
  if (!(h > 0)) return 0;
  const double count = std::max(1.0, std::ceil(time / h));
  return time / count <= h ? count : count + 1;  // a quotient that was rounded down
}

std::string indefiniteText(const CriticalStep& bracket) {
  return bracket.indefinite() ? fmt::format("the tangent is indefinite, eigenvalue {:.6g} rad2/s2: no step cures that",
                                            bracket.lowestRing)
                              : "";
}

std::string_view stableUpTo(const CriticalStep& bracket) {
  return bracket.indefinite() ? "safe for the highest frequency alone" : "stable";
}

std::string verdictText(Verdict verdict, const CriticalStep& bracket, const std::string& mayBeStable) {
  return verdict == Verdict::certified  ? "proven stable"
         : verdict == Verdict::violated ? "proven unstable"
         : bracket.indefinite()         ? fmt::format("not proven stable ({})", indefiniteText(bracket))
         : mayBeStable.empty()          ? "neither proven stable nor unstable"
                                        : fmt::format("not proven stable ({})", mayBeStable);
}

Verdict verdictOf(double step, const CriticalStep& bracket, const std::string& mayBeStable) {
  const Verdict verdict = verdictOfState(step, bracket);
  return verdict == Verdict::violated && !mayBeStable.empty() ? Verdict::notCertified : verdict;
}

namespace {

/// At rest, without bulk viscosity. mesh: of the scene's body.
CriticalStep bracketWithoutBulkViscosity(Scene scene, const Mesh& mesh, int threads) {
  scene.linearBulkViscosity = scene.quadraticBulkViscosity = 0;
  Body body = sceneBody(scene, mesh, threads);
  const NodeVectors& x = body.mesh().X;
  return criticalStep(body, x,
                      ruleAtOwnStep(scene, body, DampingRates::atRest, ownStepTolerance, stepOfTopMode(body, x)).rule);
}

}  // namespace

StepAnswer answerStep(const Scene& scene, const Body& body, CriticalStep bracket) {
  const double step = scene.step ? *scene.step : scene.ownStep.value();
  const bool without = !scene.step && (scene.linearBulkViscosity > 0 || scene.quadraticBulkViscosity > 0);
  if (without) bracket = bracketWithoutBulkViscosity(scene, body.mesh(), body.threads());
  const Verdict verdict = verdictOf(step, bracket, scene.mayBeStable);
  StepAnswer answer{Json{{"asked", step}, {"verdict", std::string(verdictName(verdict))}, {"steps", nullptr}}, ""};
  std::string& text = answer.text;
  text = fmt::format("{} {:.6g} s is {}", scene.step ? "your timestep" : "its own program's step at rest", step,
                     verdictText(verdict, bracket, scene.mayBeStable));
  if (verdict == Verdict::violated)
    text += fmt::format(", as is every one above {:.6g} s, {:.3g} times less", bracket.optimistic,
                        step / bracket.optimistic);
  if (bracket.indefinite()) {
    if (verdict == Verdict::violated) text += "; " + indefiniteText(bracket);
  } else if (const double count = stepsIn(step, bracket.safe); count == 0 || !(count <= mostSteps)) {
    text += "; no step is proven stable";
  } else {
    answer.json["steps"] = static_cast<std::int64_t>(count);
    answer.json["step"] = step / count;
    text += fmt::format("; largest proven stable: {:.6g} s", bracket.safe);
    if (count > 1) text += fmt::format(", so {} substeps of {:.6g} s", static_cast<std::int64_t>(count), step / count);
  }
  text += without ? "; all without bulk viscosity, which that step has under compression alone\n" : "\n";
  return answer;
}

}  // namespace ringwatch

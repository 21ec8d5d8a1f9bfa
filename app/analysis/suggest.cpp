#include <ringwatch/app/analysis/suggest.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <ringwatch/app/analysis/scene_start.h>
#include <ringwatch/app/analysis/step_answer.h>
#include <ringwatch/app/output/report.h>
#include <ringwatch/app/output/step_reasons.h>
#include <ringwatch/app/scene/capabilities.h>
#include <ringwatch/base/error.h>
#include <ringwatch/monitor/critical_step.h>
#include <ringwatch/monitor/stability_monitor.h>

namespace ringwatch {
namespace {

using Json = nlohmann::ordered_json;

/// Adds to json the steps that a safe step h asks for, and returns them as text.
std::string tellSteps(double frame, double h, Json& json) {
  json["safe"] = h;
  const double count = stepsIn(frame, h);
  if (count == 0 || !(count <= mostSteps)) {
    json["steps"] = nullptr;
    return "no number of steps is known to be stable";
  }
  json["steps"] = static_cast<std::int64_t>(count);
  json["step"] = frame / count;
  return fmt::format("{} step{} of {:.6g} s, proven stable up to {:.6g} s", static_cast<std::int64_t>(count),
                     count == 1 ? "" : "s", frame / count, h);
}

}  // namespace

SuggestResult suggestSteps(const SuggestOptions& options) {
  const SceneStart start = startOf(options.scene, options.overrides, options.threads, SceneUse::suggest);
  const Scene& scene = start.scene;
  const Body& body = start.body;
  const StepRule& rule = start.rule;
  std::vector<std::string> notes = start.notes;
  if (options.stretch) requireTaken(scene, SceneUse::stretch);
  const std::optional<double> asked = scene.step ? scene.step : scene.ownStep;
  if (!options.frame && !asked)
    throw InputError(
        fmt::format("{}: integrator.step = \"auto\": the time in which steps are counted is needed; give --frame, e.g. "
                    "--frame 1/60",
                    scene.file.string()));
  const double frame = options.frame.value_or(asked.value_or(0));
  const CriticalStep bracket = criticalStep(body, start.state.x, rule);

  SuggestResult result;
  Json& json = result.json;
  json = Json{{"scene", scene.file.string()},
              {"integrator", std::string(start.integrator->name)},
              {"damped", scene.damps()},
              {"frame", frame}};
  result.text =
      fmt::format("{}: {}, {}, {}{}\nin {:.6g} s:\n", scene.file.string(), elementCounts(body.mesh()),
                  modelsText(scene.materials), start.integrator->name, scene.damps() ? ", damped" : "", frame);
  const std::string atStart = tellSteps(frame, bracket.indefinite() ? 0 : bracket.safe, json["start"]);
  json["start"]["optimistic"] = bracket.optimistic;
  std::string fewer;
  if (const double least = stepsIn(frame, bracket.optimistic); least > 1 && scene.mayBeStable.empty()) {
    json["start"]["unstable_steps"] = static_cast<std::int64_t>(least) - 1;
    fewer = fmt::format("; {} or fewer are proven unstable", static_cast<std::int64_t>(least) - 1);
  }
  result.text += fmt::format("  as the scene starts       {}{}\n", atStart, fewer);
  if (bracket.indefinite()) result.text += fmt::format("  {}\n", indefiniteText(bracket));
  if (options.stretch) {
    const RangeStep range = rangeStep(body, *options.stretch, rule);
    Json& own = json["range"];
    own = Json{{"low", options.stretch->low}, {"high", options.stretch->high}, {"modulus", Json::array()}};
    for (const ModulusRange& modulus : range.modulus) own["modulus"].push_back(modulus.bound);
    result.text += fmt::format("  {:<25} {}\n",
                               fmt::format("stretches {:.4g} to {:.4g}", options.stretch->low, options.stretch->high),
                               tellSteps(frame, range.safe, own) + " where the tangent is not indefinite");
  }
  if (scene.step) json["scene_step"] = *scene.step;
  if (asked && !options.frame) {
    const StepAnswer answer = answerStep(scene, body, bracket);
    json["timestep"] = answer.json;
    result.text += "  " + answer.text;
    if (scene.ofModel && verdictOfState(*asked, bracket) == Verdict::notCertified && !bracket.indefinite())
      notes.push_back(
          fmt::format("ringwatch inspect {} --exact tells the critical step to a millionth", scene.file.string()));
  }
  if (scene.step && options.frame) {
    const Verdict verdict = verdictOf(*scene.step, bracket, scene.mayBeStable);
    result.text += fmt::format("  the step of the scene     {:.6g} s, {:.0f} steps: {} at its start\n", *scene.step,
                               stepsIn(frame, *scene.step), verdictText(verdict, bracket, scene.mayBeStable));
  }
  if (!scene.contacts.empty())
    notes.emplace_back(
        "contact counts at every node that it can have, touching or not; what friction and hollow obstacles add "
        "grows with the depth to which nodes come");
  Json& why = json["why"] = stepReasons(body, start.state.x, rule, *start.integrator, bracket);
  addRemedies(why, body, start.state.x, rule, *start.integrator, StepWithout::proven);
  result.text += reasonsText(why, "  ", "\n");
  json["conclusion"] = fmt::format("in {:.6g} s: {}", frame, atStart) + (why.is_null() ? "" : "; " + limitText(why));
  json["notes"] = notes;
  for (const std::string& note : notes) result.text += fmt::format("  note: {}\n", note);
  return result;
}

}  // namespace ringwatch

#include <ringwatch/app/report/verdict_text.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include <ringwatch/app/report/json_read.h>
#include <ringwatch/meshes/quality.h>

namespace ringwatch {
namespace {

using Json = nlohmann::ordered_json;
using json_read::numberOf;
using json_read::textOf;

const Json* firstEvent(const Json& summary, std::string_view kind) {
  const auto events = summary.find("events");
  if (events == summary.end() || !events->is_array()) return nullptr;
  for (const Json& event : *events)
    if (event.is_object() && textOf(event, "kind") == kind) return &event;
  return nullptr;
}

std::string when(const Json& event) {
  return fmt::format("step {:.0f}, t = {:.6g} s", numberOf(event, "step").value_or(0),
                     numberOf(event, "time").value_or(0));
}

/// What an event says of its element: name and cause.
std::string elementAndCause(const Json& event) {
  const auto element = event.find("element");
  std::string text = element == event.end() ? std::string() : elementName(*element);
  if (text.empty()) return text;
  if (const std::string cause = textOf(event, "cause"); !cause.empty()) text += ": " + cause;
  return text;
}

/// The words for shapes that alone make a step small; see ElementCause::badlyShaped().
bool isBadShape(const std::string& cause) {
  return std::any_of(shapeNames.begin(), shapeNames.end(), [&](const auto& entry) {
    return entry.value != ShapeClass::round && entry.value != ShapeClass::other &&
           cause.find(entry.name) != std::string::npos;
  });
}

std::string stepsText(const Json& summary) {
  const double least = numberOf(summary, "smallest_step").value_or(0),
               largest = numberOf(summary, "largest_step").value_or(0);
  if (!(largest > 0)) return "no step was taken";
  return least == largest ? fmt::format("h = {:.6g} s", least)
                          : fmt::format("steps between {:.6g} and {:.6g} s", least, largest);
}

bool hasHandler(const Json& summary) {
  const auto handler = summary.find("handler");
  return handler != summary.end() && handler->is_object();
}

/// The elements in the way, the least safe step, the room that is left.
std::string roomText(const Json& summary, const std::optional<RunHistory>& history) {
  if (!history) return {};
  const auto least = smallestSafe(*history);
  if (!least) return {};
  std::string text = fmt::format(" The smallest safe step on record{} is {:.4g} s, at step {:.0f}, t = {:.6g} s",
                                 hasHandler(summary) ? ", of the elements that stay explicit," : "", least->safe,
                                 least->step, least->time);
  if (!least->element.empty()) text += fmt::format(", where element {} controls it", least->element);
  const double largest = numberOf(summary, "largest_step").value_or(0);
  if (largest > 0 && largest <= least->safe)
    text += fmt::format("; the run took {:.0f} % of it", 100 * largest / least->safe);
  return text + ".";
}

std::string handlerText(const Json& summary) {
  if (!hasHandler(summary)) return {};
  const Json& handler = summary["handler"];
  return fmt::format(" The handler {} holds {:.0f} elements at the end; the bracket is that of the others.",
                     textOf(handler, "method"), numberOf(handler, "handled_elements").value_or(0));
}

void adviseSmallerStep(PageVerdict& verdict, const Json& summary, const std::optional<RunHistory>& history,
                       std::optional<double> before) {
  const auto least = history ? smallestSafe(*history, before) : std::nullopt;
  const double taken = numberOf(summary, "largest_step").value_or(0);
  if (least && least->safe < taken)
    verdict.remedies.push_back(
        fmt::format("A smaller step: {} s was proven safe in every state with a bracket on record{}. integrator.step = "
                    "\"auto\" keeps below the "
                    "critical step by itself; monitor.on_violation = \"reduce-step\" shortens the step when it must.",
                    stepRoundedDown(least->safe), before ? " before that" : ""));
  else
    verdict.remedies.emplace_back(
        "A smaller step: integrator.step = \"auto\" keeps below the critical step by itself; monitor.on_violation = "
        "\"reduce-step\" shortens the step when it must.");
}

void advise(PageVerdict& verdict, const std::vector<std::string>& remedies) {
  verdict.remedies.insert(verdict.remedies.end(), remedies.begin(), remedies.end());
}

void adviseHandler(PageVerdict& verdict, const Json& summary, const RunAnalysis* analysis) {
  const WhatIf* row = analysis ? analysis->inTheWay() : nullptr;
  if (row && !row->way.all.empty()) return advise(verdict, remediesFor(*row, *analysis));
  if (hasHandler(summary)) return;
  verdict.remedies.emplace_back(
      "Keep the step and let a handler take the elements that come into the way: [handler] method = \"imex\" with "
      "monitor.on_violation = \"handle\".");
}

PageVerdict withoutSummary(const std::optional<RunHistory>& history) {
  PageVerdict verdict;
  verdict.title = "No end on record";
  verdict.sentence =
      "This folder has no summary.json that can be read: the run was killed, or it still goes on. What follows is what "
      "it wrote until then.";
  if (history && history->rowCount() > 0) {
    const std::size_t last = history->rowCount() - 1;
    verdict.sentence += fmt::format(" Its history ends at step {:.0f}, t = {:.6g} s", (*history->column("step"))[last],
                                    (*history->column("time_s"))[last]);
    if (!history->verdicts[last].empty())
      verdict.sentence += fmt::format(", where the step was {}", history->verdicts[last]);
    verdict.sentence += ".";
    const auto violated = std::find(history->verdicts.begin(), history->verdicts.end(), "violated");
    if (violated != history->verdicts.end()) {
      const std::size_t row = violated - history->verdicts.begin();
      verdict.tone = PageVerdict::Tone::bad;
      verdict.sentence += fmt::format(" The step is proven too large at step {:.0f}, t = {:.6g} s",
                                      (*history->column("step"))[row], (*history->column("time_s"))[row]);
      if (const std::int32_t element = history->controlling[row]; element >= 0)
        verdict.sentence += fmt::format("; element {} controls it there", history->elements[element]);
      verdict.sentence += ".";
    }
  }
  verdict.remedies.emplace_back(
      "Run the scene again to its end for a verdict, or wait until it ends and write the page again.");
  return verdict;
}

/// The verdict so far of a run that goes on.
PageVerdict whileRunning(const Json& summary, const Json& live, const std::optional<RunHistory>& history) {
  Json soFar = summary;
  soFar.erase("live");
  PageVerdict verdict = verdictOf(soFar, history);
  verdict.title[0] = static_cast<char>(std::tolower(verdict.title[0]));
  verdict.title = "Running: " + verdict.title + " so far";
  const double time = numberOf(live, "time").value_or(0), end = numberOf(live, "end").value_or(0);
  verdict.sentence = fmt::format("The run goes on: t = {:.6g} of {:.6g} s, step {:.0f}. ", time, end,
                                 numberOf(summary, "steps").value_or(0)) +
                     verdict.sentence;
  return verdict;
}

}  // namespace

std::string stepRoundedDown(double step) {
  if (!(step > 0) || !std::isfinite(step)) return fmt::format("{:.4g}", step);
  const double unit = std::pow(10, std::floor(std::log10(step)) - 3);
  return fmt::format("{:.4g}", std::floor(step / unit) * unit);
}

std::vector<std::string> remediesFor(const WhatIf& row, const RunAnalysis& analysis) {
  std::vector<std::string> remedies;
  const std::string inTheWay = fmt::format("the {} of {} elements that are in the way of {:.4g} s {}",
                                           row.way.all.size(), analysis.elements, row.h, analysis.where);
  std::string gains, best;
  double most = 0;
  for (const HandlerTrial& trial : row.trials) {
    if (!trial.whyNot.empty() || trial.addedMass) continue;
    gains += fmt::format("{}{} {:.2g} times", gains.empty() ? "" : ", ", trial.handler, trial.gain);
    if (trial.gain > most) most = trial.gain, best = trial.handler;
  }
  if (most > 1)
    remedies.push_back(
        fmt::format("Let a handler take {}: [handler] method = \"{}\". Measured when this page was "
                    "written, it takes the run {} as far in the same wall time as the integrator alone at the safe "
                    "step ({}).",
                    inTheWay, best, fmt::format("{:.2g} times", most), gains));
  else if (most > 0)
    remedies.push_back(
        fmt::format("A handler could take {}, but a smaller step is cheaper: measured when this page was written, "
                    "handlers take the run less far in the same wall time than the integrator alone at the safe step "
                    "({}).",
                    inTheWay, gains));
  else
    remedies.push_back(fmt::format("Let a handler take {}: [handler] method = \"imex\".", inTheWay));
  for (const HandlerTrial& trial : row.trials)
    if (trial.whyNot.empty() && trial.addedMass)
      remedies.push_back(
          fmt::format("Add {:.3g} kg at their nodes, {:.3g} % of the body's mass, which changes the motion: "
                      "[handler] method = \"{}\".",
                      *trial.addedMass, 100 * trial.addedShare, trial.handler));
  if (const std::size_t bad = row.way.badlyShaped.size(); bad > 0) {
    remedies.push_back(fmt::format("Remesh: {} of them {} badly shaped at rest ({}), {} in the mesh.", bad,
                                   bad == 1 ? "is" : "are", row.way.shapesText(), row.badNumbers));
  } else if (!row.way.all.empty()) {
    remedies.emplace_back(
        "None of them is badly shaped at rest: remeshing helps only if larger elements will do there.");
  }
  return remedies;
}

std::vector<std::string> largerSteps(const RunAnalysis& analysis) {
  // The largest step that few elements forbid.
  constexpr double few = 0.1;  // of all
  const WhatIf* found = nullptr;
  for (const WhatIf& row : analysis.whatIf)
    if (!row.proven && !row.trials.empty() && analysis.safe && row.h >= 1.5 * *analysis.safe &&
        static_cast<double>(row.way.all.size()) <= few * static_cast<double>(analysis.elements))
      found = &row;
  if (!found) return {};
  std::vector<std::string> remedies{
      fmt::format("To go faster: {:.3g} times the safe step is forbidden by few elements.", found->h / *analysis.safe)};
  for (std::string& remedy : remediesFor(*found, analysis)) remedies.push_back(std::move(remedy));
  return remedies;
}

std::string elementName(const Json& element) {
  if (!element.is_object()) return {};
  return fmt::format("element {:.0f} of the mesh ({}, {:.0f}:{:.0f})", numberOf(element, "id").value_or(0),
                     textOf(element, "type"), numberOf(element, "block").value_or(0),
                     numberOf(element, "index").value_or(0));
}

std::optional<SmallestSafe> smallestSafe(const RunHistory& history, std::optional<double> before) {
  const std::vector<double>*safe = history.column("safe_s"), *time = history.column("time_s"),
        *step = history.column("step");
  if (!safe || !time || !step) return std::nullopt;
  std::optional<SmallestSafe> least;
  for (std::size_t i = 0; i < safe->size(); ++i) {
    if (before && (*time)[i] >= *before) break;
    const double value = (*safe)[i];
    if (!(value > 0) || !std::isfinite(value) || (least && value >= least->safe)) continue;
    const std::int32_t element = history.controlling[i];
    least = {value, (*time)[i], (*step)[i], element >= 0 ? history.elements[element] : std::string()};
  }
  return least;
}

PageVerdict verdictOf(const Json& summary, const std::optional<RunHistory>& history, const RunAnalysis* analysis) {
  if (!summary.is_object()) return withoutSummary(history);
  if (const auto live = summary.find("live"); live != summary.end() && live->is_object())
    return whileRunning(summary, *live, history);
  using Tone = PageVerdict::Tone;
  PageVerdict verdict;
  const std::string word = textOf(summary, "verdict"), reason = textOf(summary, "exit_reason");
  const double steps = numberOf(summary, "steps").value_or(0), time = numberOf(summary, "end_time").value_or(0),
               certified = numberOf(summary, "certified_steps").value_or(0),
               watched = numberOf(summary, "watched_steps").value_or(0);
  const Json *violated = firstEvent(summary, "violated"), *inverted = firstEvent(summary, "inverted"),
             *energy = firstEvent(summary, "energy-balance"), *indefinite = firstEvent(summary, "indefinite"),
             *nonFinite = firstEvent(summary, "non-finite");
  std::string& text = verdict.sentence;

  if (word == "certified") {
    verdict.tone = Tone::good;
    verdict.title = "Stable";
    text = fmt::format(
        "Each of the {:.0f} steps to t = {:.6g} s was proven to be below the critical step of {}, with {}.", watched,
        time, hasHandler(summary) ? "what the handler left explicit" : "its state", stepsText(summary));
  } else if (word == "not-certified") {
    verdict.title = "Not proven";
    text = fmt::format(
        "No step to t = {:.6g} s was seen to be unstable, but only {:.0f} of {:.0f} steps were proven stable, with {}.",
        time, certified, watched, stepsText(summary));
  } else if (word == "violated") {
    verdict.tone = Tone::bad;
    verdict.title = "Step too large";
  } else if (word == "unstable") {
    verdict.tone = Tone::bad;
    verdict.title = "Unstable";
  } else {
    verdict.title = "Not watched";
    text = fmt::format("Nothing in this run proves its steps: {:.0f} steps to t = {:.6g} s, with {}.", steps, time,
                       stepsText(summary));
  }
  if (reason == "interrupted" || reason == "step-collapsed" || reason == "step-failed")
    text += fmt::format(" It did not reach its end: {}.", textOf(summary, "exit_text"));
  if (verdict.tone == Tone::good && reason != "end") verdict.tone = Tone::unsure;

  const auto say = [&text](const std::string& sentence) { text += (text.empty() ? "" : " ") + sentence; };
  if (violated) {
    const std::string who = elementAndCause(*violated);
    say(fmt::format("From {} on, {} is above the critical step{}.", when(*violated), stepsText(summary),
                    who.empty() ? "" : "; in the way is " + who));
    if (reason == "violated") say("The run was stopped before it took that step.");
  }
  if (inverted) say(fmt::format("At {}, {}.", when(*inverted), elementAndCause(*inverted)));
  if (energy)
    say(fmt::format("At {} the energy balance is off by {:.0f} % of the largest energy so far.", when(*energy),
                    100 * numberOf(*energy, "value").value_or(0)));
  if (nonFinite || reason == "non-finite")
    say(nonFinite ? fmt::format("At {} the state is no longer finite.", when(*nonFinite))
                  : fmt::format("After step {:.0f} positions or velocities are not finite.", steps));
  if (indefinite) {
    text += fmt::format(" The tangent has a negative eigenvalue at {}", when(*indefinite));
    const std::string who = elementAndCause(*indefinite);
    text += who.empty() ? "." : fmt::format(", most at {}.", who);
  }
  if (verdict.tone != Tone::bad) text += roomText(summary, history);
  text += handlerText(summary);

  const std::optional<double> before = violated ? numberOf(*violated, "time") : std::nullopt;
  if (verdict.tone == Tone::bad) {
    adviseSmallerStep(verdict, summary, history, before);
    adviseHandler(verdict, summary, analysis);
    // What is to be remeshed is named with what is in the way, where that is known.
    if (violated && isBadShape(textOf(*violated, "cause")) && !(analysis && analysis->inTheWay()))
      verdict.remedies.push_back(fmt::format("Mend the mesh there: {}.", elementAndCause(*violated)));
    if (inverted)
      verdict.remedies.emplace_back(
          "An inverted element is a state that no smaller step mends from there on: look at what happened before it.");
  } else if (word == "certified") {
    const auto least = history ? smallestSafe(*history) : std::nullopt;
    const double taken = numberOf(summary, "largest_step").value_or(0);
    if (least && least->safe > taken && taken > 0 && !hasHandler(summary))
      verdict.remedies.push_back(
          fmt::format("Nothing has to be done about the step. A step of {} s was proven in every state on record.",
                      stepRoundedDown(least->safe)));
    else
      verdict.remedies.emplace_back("Nothing has to be done about the step.");
    if (analysis && !hasHandler(summary)) advise(verdict, largerSteps(*analysis));
  } else if (word == "not-certified") {
    adviseSmallerStep(verdict, summary, history, {});
    adviseHandler(verdict, summary, analysis);
  } else {
    verdict.remedies.emplace_back("Let the monitor prove the steps: [monitor] mode = \"bracket\" or \"threshold\".");
  }
  if (indefinite)
    verdict.remedies.emplace_back(
        "No step cures a negative eigenvalue: it is the state that is unstable there, as when something buckles.");
  return verdict;
}

}  // namespace ringwatch

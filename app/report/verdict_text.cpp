#include <ringwatch/app/report/verdict_text.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/format.h>

#include <ringwatch/app/output/step_reasons.h>
#include <ringwatch/app/report/json_read.h>
#include <ringwatch/app/scene/capabilities.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/number_format.h>

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

/// Whether the element that an event names is badly shaped.
bool badShapeOf(const Json* event) {
  const auto diagnosis = event ? event->find("diagnosis") : Json::const_iterator();
  return event && diagnosis != event->end() && diagnosis->is_object() && diagnosis->value("badly_shaped", false);
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

/// Springs and contact of a run, of summary.json; null for a run without any.
const Json& discreteForces(const Json& summary) {
  static const Json none = nullptr;
  const auto found = summary.find("discrete_forces");
  return found != summary.end() && found->is_object() ? *found : none;
}

const Json* objectIn(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_object() ? &*found : nullptr;
}

/// "contact", "springs" or "springs or contact": what a run has of them.
std::string discreteName(const Json& discrete) {
  const bool springs = numberOf(discrete, "springs").value_or(0) > 0,
             contact = numberOf(discrete, "contact_nodes").value_or(0) > 0;
  return springs && contact ? "springs or contact" : springs ? "springs" : "contact";
}

/// "; contact governs the step, not the elements: it holds 93 % of the energy of the unstable mode, …".
std::string discreteCause(const Json& event, const Json& discrete) {
  const std::string name = discreteName(discrete);
  std::string text =
      fmt::format("; {} {} the step, not the elements: {:.0f} % of the energy of the unstable mode {}", name,
                  name == "springs" ? "govern" : "governs", 100 * numberOf(event, "discrete_share").value_or(0),
                  name == "contact" ? "is in the penalty at the nodes that touch" : "is in them");
  const auto element = event.find("element");
  if (const std::string who = element == event.end() ? std::string() : elementName(*element); !who.empty())
    text += ", most of it at " + who;
  return text;
}

std::string penaltyText(const Json& penalty) {
  const double least = numberOf(penalty, "least").value_or(0), largest = numberOf(penalty, "largest").value_or(0);
  return least == largest ? fmt::format("{:.4g} N/m", least) : fmt::format("{:.4g} to {:.4g} N/m", least, largest);
}

/// Which obstacle, and how deep. until: s, when the run was beyond doubt no longer what it should be.
std::string contactText(const Json& discrete, double until) {
  const Json* deepest = objectIn(discrete, "deepest");
  if (!deepest) return {};
  const double time = numberOf(*deepest, "time").value_or(0);
  // Depths of a run that has blown up say nothing of contact.
  if (time > until) return {};
  return fmt::format(" Node {:.0f} came deepest, {:.3g} m into {}, at t = {:.6g} s.",
                     numberOf(*deepest, "node_id").value_or(0), numberOf(*deepest, "depth").value_or(0),
                     textOf(*deepest, "obstacle"), time);
}

/// How often springs or contact set the step of a run whose steps are not proven too large.
std::string governedText(const Json& discrete) {
  const auto least = numberOf(discrete, "least_safe");
  if (!least) return {};
  return fmt::format(" At {:.0f} observations {} set the step, not the elements; the least safe step there is {} s.",
                     numberOf(discrete, "governed_observations").value_or(0), discreteName(discrete),
                     stepRoundedDown(*least));
}

/// The penalty, or the stiffness of springs, that leaves the step to the elements. taken: the run's step, s.
std::vector<std::string> softerContact(const Json& discrete, double taken) {
  std::vector<std::string> remedies;
  const Json *room = objectIn(discrete, "room"), *penalty = objectIn(discrete, "penalty");
  const std::string name = discreteName(discrete);
  if (room && penalty) {
    const double share = numberOf(*room, "share").value_or(0), alone = numberOf(*room, "elements_alone").value_or(0),
                 limit = numberOf(*room, "penalty").value_or(0);
    const auto atStep = numberOf(*room, "penalty_at_step");
    std::string text = "A softer contact: ";
    if (atStep)
      text += fmt::format(
          "with a penalty of at most {} N/m at each node the step of this run, {:.4g} s, is proven on the body at "
          "rest; "
          "this run has {}, and a body that deforms leaves a little less. Contact ",
          stepRoundedDown(*atStep), taken, penaltyText(*penalty));
    else
      text += fmt::format(
          "this run has a penalty of {}. Its step, {:.4g} s, is more than the elements at rest prove alone, {:.4g} s, "
          "so that a smaller step is needed besides. Contact ",
          penaltyText(*penalty), taken, alone);
    text += fmt::format(
        "does not govern with at most {} N/m, which leaves {:.0f} % of the {} s that the elements prove. "
        "contact.penalty = \"auto\" makes one for the step; nodes come deeper then.",
        stepRoundedDown(limit), 100 * share, stepRoundedDown(alone));
    remedies.push_back(std::move(text));
  }
  if (name != "contact")
    remedies.emplace_back(
        "Softer springs and dashpots, or more mass at their nodes ([[mass]]): stiffness over mass sets the step.");
  return remedies;
}

/// The elements in the way, the least safe step, the room that is left.
std::string roomText(const Json& summary, const std::optional<RunHistory>& history) {
  if (!history) return {};
  const auto least = smallestSafe(*history);
  if (!least) return {};
  std::string text = fmt::format(" The smallest safe step on record{} is {} s, at step {:.0f}, t = {:.6g} s",
                                 hasHandler(summary) ? ", of the elements that stay explicit," : "",
                                 stepRoundedDown(least->safe), least->step, least->time);
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
                       std::optional<double> before, const RunAnalysis* analysis) {
  const auto least = history ? smallestSafe(*history, before) : std::nullopt;
  const double taken = numberOf(summary, "largest_step").value_or(0);
  if (least && least->safe < taken)
    verdict.remedies.push_back(
        fmt::format("A smaller step: {} s was proven safe in every state with a bracket on record{}. integrator.step = "
                    "\"auto\" keeps below the "
                    "critical step by itself; monitor.on_violation = \"reduce-step\" shortens the step when it must.",
                    stepRoundedDown(least->safe), before ? " before that" : ""));
  else if (analysis && analysis->safe && *analysis->safe > 0 && *analysis->safe < taken)
    verdict.remedies.push_back(
        fmt::format("A smaller step: {} s is proven {}. integrator.step = \"auto\" keeps below the critical step by "
                    "itself; monitor.on_violation = \"reduce-step\" shortens the step when it must.",
                    stepRoundedDown(*analysis->safe), analysis->where));
  else
    verdict.remedies.emplace_back(
        "A smaller step: integrator.step = \"auto\" keeps below the critical step by itself; monitor.on_violation = "
        "\"reduce-step\" shortens the step when it must.");
}

void advise(PageVerdict& verdict, const std::vector<std::string>& remedies) {
  verdict.remedies.insert(verdict.remedies.end(), remedies.begin(), remedies.end());
}

/// Whether scenes like this one take a handler.
bool couldTakeHandler(const Json& summary) {
  const Json* echo = objectIn(summary, "scene");
  try {
    return echo && whyNoHandlers(sceneOfEcho("scene", *echo)).empty();
  } catch (const std::exception&) {  // an echo that others have written may hold anything
    return false;
  }
}

void adviseHandler(PageVerdict& verdict, const Json& summary, const RunAnalysis* analysis) {
  const WhatIf* row = analysis ? analysis->inTheWay() : nullptr;
  if (row && !row->way.all.empty()) return advise(verdict, remediesFor(*row, *analysis));
  if (const std::vector<std::string> known = remediesOf(summary.value("why", Json())); !known.empty())
    return advise(verdict, known);
  if (hasHandler(summary) || !couldTakeHandler(summary)) return;
  verdict.remedies.emplace_back(
      "Keep the step and let a handler take the elements that come into the way: [handler] method = \"imex\" with "
      "monitor.on_violation = \"handle\".");
}

/// Four digits of a step; the next ones below or above where these are on the other side of it.
std::string rounded(double step, int side) {
  std::string text = fmt::format("{:.4g}", step);
  if (!(step > 0) || !std::isfinite(step) || side * (*readNumber(text) - step) >= 0) return text;
  return fmt::format("{:.4g}", step + side * 0.5 * std::pow(10, std::floor(std::log10(step)) - 3));
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
        verdict.sentence += fmt::format("; element {} controls it there", history->nameOf(element));
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
  verdict.lead = 0;
  verdict.sentence = fmt::format("The run goes on: t = {:.6g} of {:.6g} s, step {:.0f}. ", time, end,
                                 numberOf(summary, "steps").value_or(0)) +
                     verdict.sentence;
  return verdict;
}

}  // namespace

bool discreteGoverns(const Json& summary) {
  const Json* violated = summary.is_object() ? firstEvent(summary, "violated") : nullptr;
  return violated && numberOf(*violated, "discrete_share").value_or(0) > 0.5;
}

std::string stepRoundedDown(double step) { return rounded(step, -1); }
std::string stepRoundedUp(double step) { return rounded(step, 1); }

/// Of the body's mass; more is another body.
constexpr double mostMassToAdd = 0.05;
/// Gain of time from which a handler is advised: one call measures that much more than another.
constexpr double worthGaining = 1.05;

std::vector<std::string> remediesFor(const WhatIf& row, const RunAnalysis& analysis) {
  std::vector<std::string> remedies;
  const std::string inTheWay = fmt::format("the {} of {} elements that are in the way of {:.4g} s {}",
                                           row.way.all.size(), analysis.elements, row.h, analysis.where);
  std::string gains, best;
  const std::string watched =
      analysis.monitorSeconds > 0
          ? fmt::format(", with the {:.2g} s that the monitor takes a step", analysis.monitorSeconds)
          : ", without a monitor";
  double most = 0;
  for (const HandlerTrial& trial : row.trials) {
    if (!trial.whyNot.empty() || trial.addedMass) continue;
    gains += fmt::format("{}{} {:.2g} times", gains.empty() ? "" : ", ", trial.handler, trial.gain);
    if (trial.gain > most) most = trial.gain, best = trial.handler;
  }
  if (most > worthGaining)
    remedies.push_back(
        fmt::format("Let a handler take {}: [handler] method = \"{}\". Measured when this page was "
                    "written{}, it takes the run {:.2g} times as far in the same wall time as the integrator alone at "
                    "the safe step ({}).",
                    inTheWay, best, watched, most, gains));
  else if (most > 0)
    remedies.push_back(
        fmt::format("A handler could take {}, but a smaller step costs no more: measured when this page was written{}, "
                    "handlers take the run no farther in the same wall time than the integrator alone at the safe step "
                    "({}).",
                    inTheWay, watched, gains));
  else if (analysis.countedBy.empty())
    remedies.push_back(fmt::format("Let a handler take {}: [handler] method = \"imex\".", inTheWay));
  else if (analysis.couldTakeHandler)
    remedies.push_back(
        fmt::format("Let a handler take {}, and some around them: [handler] method = \"imex\". These are the elements "
                    "whose own step is too small; ringwatch inspect with --step {:.4g} tells which a handler takes.",
                    inTheWay, row.h));
  for (const HandlerTrial& trial : row.trials)
    if (trial.whyNot.empty() && trial.addedMass && trial.addedShare <= mostMassToAdd)
      remedies.push_back(
          fmt::format("Add {:.3g} kg at their nodes, {:.3g} % of the body's mass, which changes the motion: "
                      "[handler] method = \"{}\".",
                      *trial.addedMass, 100 * trial.addedShare, trial.handler));
  if (const std::size_t bad = row.way.badlyShaped.size(); bad > 0) {
    remedies.push_back(fmt::format("Remesh: {} of {} {} badly shaped {} ({}), {} in the mesh.", bad,
                                   remedies.empty() ? inTheWay : "them", bad == 1 ? "is" : "are", analysis.shapesAt,
                                   row.way.shapesText(), row.badNumbers));
  } else if (!row.way.all.empty() && row.shapesKnown) {
    remedies.push_back(
        fmt::format("None of {} is badly shaped {}: remeshing helps only if larger elements will do there.",
                    remedies.empty() ? inTheWay : "them", analysis.shapesAt));
  }
  return remedies;
}

std::vector<std::string> largerSteps(const RunAnalysis& analysis) {
  // The largest step that few elements forbid.
  const WhatIf* found = nullptr;
  for (const WhatIf& row : analysis.whatIf)
    if (!row.proven && (!row.trials.empty() || (!analysis.countedBy.empty() && analysis.couldTakeHandler)) &&
        analysis.safe && row.h >= 1.5 * *analysis.safe &&
        static_cast<double>(row.way.all.size()) <= fewInTheWay * static_cast<double>(analysis.elements))
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
    least = {value, (*time)[i], (*step)[i], element >= 0 ? history.nameOf(element) : std::string()};
  }
  return least;
}

namespace {

/// What the results of a run say of it, as data; the texts below are made of it.
struct Diagnosis {
  const Json& summary;
  const std::optional<RunHistory>& history;
  const RunAnalysis* analysis;  // nullptr without one
  const Json& discrete;         // springs and contact; null without any
  std::string verdict = textOf(summary, "verdict"), reason = textOf(summary, "exit_reason");
  double steps = number("steps"), time = number("end_time"), certified = number("certified_steps"),
         watched = number("watched_steps"), taken = number("largest_step");
  /// The first of each kind; nullptr where there is none.
  const Json *violated = firstEvent(summary, "violated"), *inverted = firstEvent(summary, "inverted"),
             *energy = firstEvent(summary, "energy-balance"), *indefinite = firstEvent(summary, "indefinite"),
             *nonFinite = firstEvent(summary, "non-finite");
  bool handled = hasHandler(summary), governs = discrete.is_object() && discreteGoverns(summary),
       discreteSetsStep = discrete.is_object() && numberOf(discrete, "governed_observations").value_or(0) > 0,
       touches = discrete.is_object() && numberOf(discrete, "contact_nodes").value_or(0) > 0;

  double number(const char* key) const { return numberOf(summary, key).value_or(0); }
  std::optional<double> before() const { return violated ? numberOf(*violated, "time") : std::nullopt; }
};

using Tone = PageVerdict::Tone;

/// What is said first, by the verdict of a run. opening: {steps} taken, {proven} and {watched} ones, until {time} s,
/// {what} was proven, and the sizes of the steps, {h}.
struct Opening {
  std::string_view verdict;
  Tone tone;
  std::string_view title, opening;
};
constexpr std::string_view ofHighestAlone = "certified, for the highest frequency alone";
constexpr Opening openings[] = {
    {"certified", Tone::good, "Stable",
     "Each of the {watched:.0f} steps to t = {time:.6g} s was proven to be below the critical step of {what}, with "
     "{h}."},
    {"not-certified", Tone::unsure, "Not proven",
     "No step to t = {time:.6g} s was seen to be unstable, but only {proven:.0f} of {watched:.0f} steps were proven "
     "stable, with {h}."},
    {ofHighestAlone, Tone::unsure, "Stable",
     "Each of the {watched:.0f} steps to t = {time:.6g} s was proven to be below the limit that the highest frequency "
     "of {what} sets, with {h}, but the tangent was indefinite, which no step cures."},
    {"violated", Tone::bad, "Step too large", ""},
    {"unstable", Tone::bad, "Unstable", ""},
    {"", Tone::unsure, "Not watched",
     "Nothing in this run proves its steps: {steps:.0f} steps to t = {time:.6g} s, with {h}."},
};

const Opening& openingOf(const Diagnosis& run) {
  const bool ofHighest = run.verdict == "certified" && run.indefinite;
  const auto found =
      std::ranges::find(openings, ofHighest ? ofHighestAlone : std::string_view(run.verdict), &Opening::verdict);
  const bool unwatched = found == std::end(openings) || (run.verdict == "not-certified" && !(run.watched > 0));
  return unwatched ? *std::rbegin(openings) : *found;
}

/// What happened, in the order of time after the step that is too large: text of an event, and its element's cause.
struct Happening {
  const Json* Diagnosis::*event;
  std::string (*text)(const Json& event, const std::string& who);
};
constexpr Happening happenings[] = {
    {&Diagnosis::energy,
     [](const Json& event, const std::string&) {
       return fmt::format("At {} the energy balance is off by {:.0f} % of the largest energy so far.", when(event),
                          100 * numberOf(event, "value").value_or(0));
     }},
    {&Diagnosis::indefinite,
     [](const Json& event, const std::string& who) {
       return fmt::format("The tangent has a negative eigenvalue at {}{}.", when(event),
                          who.empty() ? "" : ", most at " + who);
     }},
    {&Diagnosis::inverted,
     [](const Json& event, const std::string& who) { return fmt::format("At {}, {}.", when(event), who); }},
    {&Diagnosis::nonFinite,
     [](const Json& event, const std::string&) {
       return fmt::format("At {} the state is no longer finite.", when(event));
     }},
};

/// What to do, in this order, each where it applies.
struct Remedy {
  bool (*applies)(const Diagnosis& run, Tone tone);
  void (*add)(PageVerdict& verdict, const Diagnosis& run);
};
bool isStable(const Diagnosis& run, Tone) { return run.verdict == "certified"; }
bool isOpen(const Diagnosis& run) { return run.verdict == "not-certified" && run.watched > 0; }
constexpr Remedy remedies[] = {
    {[](const Diagnosis& run, Tone tone) {
       return (tone == Tone::bad && run.governs) || (isOpen(run) && run.discreteSetsStep);
     },
     [](PageVerdict& verdict, const Diagnosis& run) { advise(verdict, softerContact(run.discrete, run.taken)); }},
    {[](const Diagnosis& run, Tone tone) { return tone == Tone::bad || isOpen(run); },
     [](PageVerdict& verdict, const Diagnosis& run) {
       adviseSmallerStep(verdict, run.summary, run.history, run.before(), run.analysis);
       if (!run.governs) adviseHandler(verdict, run.summary, run.analysis);
     }},
    {[](const Diagnosis& run, Tone tone) { return tone == Tone::bad && !run.analysis && badShapeOf(run.violated); },
     [](PageVerdict& verdict, const Diagnosis& run) {
       verdict.remedies.push_back(fmt::format("Remesh there: the element in the way is a {} at rest.",
                                              textOf(*objectIn(*run.violated, "diagnosis"), "shape")));
     }},
    {[](const Diagnosis& run, Tone tone) { return tone == Tone::bad && run.inverted; },
     [](PageVerdict& verdict, const Diagnosis&) {
       verdict.remedies.emplace_back(
           "An inverted element is a state that no smaller step mends from there on: look at what happened before it.");
     }},
    {isStable,
     [](PageVerdict& verdict, const Diagnosis& run) {
       const auto least = run.history && !run.handled ? smallestSafe(*run.history) : std::nullopt;
       const bool room = least && least->safe > run.taken && run.taken > 0;
       verdict.remedies.push_back(
           "Nothing has to be done about the step." +
           (room ? fmt::format(" A step of {} s was proven in every state on record.", stepRoundedDown(least->safe))
                 : std::string()));
       if (run.handled) return;
       const std::vector<std::string> measured = run.analysis ? largerSteps(*run.analysis) : std::vector<std::string>();
       advise(verdict, measured.empty() ? remediesOf(run.summary.value("why", Json())) : measured);
     }},
    {[](const Diagnosis& run, Tone tone) { return isStable(run, tone) && run.discreteSetsStep; },
     [](PageVerdict& verdict, const Diagnosis& run) {
       verdict.remedies.push_back(
           fmt::format("To go faster: {} set the step at times, not the elements.", discreteName(run.discrete)));
       advise(verdict, softerContact(run.discrete, run.taken));
     }},
    {[](const Diagnosis& run, Tone) { return openingOf(run).verdict.empty(); },
     [](PageVerdict& verdict, const Diagnosis&) {
       verdict.remedies.emplace_back("Let the monitor prove the steps: [monitor] mode = \"bracket\" or \"threshold\".");
     }},
    {[](const Diagnosis& run, Tone) { return run.energy && !run.violated && run.touches; },
     [](PageVerdict& verdict, const Diagnosis&) {
       verdict.remedies.emplace_back(
           "Where every step is proven and the energy is off all the same, contact that begins within a step may be "
           "what feeds it: a softer penalty or a smaller step lets it last more steps.");
     }},
    {[](const Diagnosis& run, Tone) { return run.indefinite != nullptr; },
     [](PageVerdict& verdict, const Diagnosis&) {
       verdict.remedies.emplace_back(
           "The negative eigenvalue is not about the step, and no step cures it: the state itself is unstable there, "
           "as when something buckles.");
     }},
};

}  // namespace

PageVerdict verdictOf(const Json& summary, const std::optional<RunHistory>& history, const RunAnalysis* analysis) {
  if (!summary.is_object()) return withoutSummary(history);
  if (const Json* live = objectIn(summary, "live")) return whileRunning(summary, *live, history);
  const Diagnosis run{summary, history, analysis, discreteForces(summary)};
  const Opening& opening = openingOf(run);
  PageVerdict verdict;
  verdict.tone = opening.tone;
  verdict.title = opening.title;
  std::string& text = verdict.sentence;
  text = fmt::format(fmt::runtime(opening.opening), fmt::arg("steps", run.steps), fmt::arg("proven", run.certified),
                     fmt::arg("watched", run.watched), fmt::arg("time", run.time),
                     fmt::arg("what", run.handled ? "what the handler left explicit" : "its state"),
                     fmt::arg("h", stepsText(summary)));
  if (run.reason == "interrupted" || run.reason == "step-collapsed" || run.reason == "step-failed")
    text += fmt::format(" It did not reach its end: {}.", textOf(summary, "exit_text"));
  if (verdict.tone == Tone::good && run.reason != "end") verdict.tone = Tone::unsure;

  const auto say = [&text](const std::string& sentence) { text += (text.empty() ? "" : " ") + sentence; };
  if (const Json* violated = run.violated) {
    const std::string who = elementAndCause(*violated);
    say(fmt::format("From {} on, {} is above the critical step{}.", when(*violated), stepsText(summary),
                    run.governs   ? discreteCause(*violated, run.discrete)
                    : who.empty() ? ""
                                  : "; in the way is " + who));
    if (run.reason == "violated") say("The run was stopped before it took that step.");
    if (run.governs)
      text += contactText(run.discrete, run.energy ? numberOf(*run.energy, "time").value_or(infinity) : infinity);
    verdict.lead = text.size();
  }
  std::vector<std::pair<double, std::string>> followed;
  for (const Happening& one : happenings)
    if (const Json* event = run.*one.event)
      followed.emplace_back(numberOf(*event, "step").value_or(0), one.text(*event, elementAndCause(*event)));
  std::ranges::stable_sort(followed, {}, &std::pair<double, std::string>::first);
  for (const auto& [step, sentence] : followed) say(sentence);
  if (!run.nonFinite && run.reason == "non-finite")
    say(fmt::format("After step {:.0f} positions or velocities are not finite.", run.steps));
  if (verdict.tone != Tone::bad) text += roomText(summary, history);
  if (run.discrete.is_object() && !run.governs) text += governedText(run.discrete);
  text += handlerText(summary);
  if (const Json* why = objectIn(summary, "why")) text += reasonsText(*why, " ", "", Reasons::alone);
  for (const Remedy& remedy : remedies)
    if (remedy.applies(run, verdict.tone)) remedy.add(verdict, run);
  return verdict;
}

}  // namespace ringwatch

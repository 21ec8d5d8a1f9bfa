#include <ringwatch/app/report/audit_report.h>

#include <algorithm>
#include <cctype>
#include <limits>

#include <fmt/format.h>

#include <ringwatch/app/analysis/audit.h>
#include <ringwatch/app/output/frames.h>
#include <ringwatch/app/report/frame_choice.h>
#include <ringwatch/app/report/report_page.h>
#include <ringwatch/app/report/state_frame.h>
#include <ringwatch/body/element_stress.h>
#include <ringwatch/monitor/event.h>

namespace ringwatch {
namespace {

using Json = nlohmann::ordered_json;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double orNaN(const std::optional<double>& value) { return value.value_or(nan); }

/// Where the results have no times, states are counted.
double timeOf(const AuditedState& state) { return state.time ? *state.time : static_cast<double>(state.index + 1); }

RunHistory historyOf(const std::vector<AuditedState>& states) {
  RunHistory history;
  RunHistory::Column step{"step", {}}, time{"time_s", {}}, h{"h_s", {}}, safe{"safe_s", {}},
      optimistic{"optimistic_s", {}}, strain{"strain_J", {}};
  for (const AuditedState& state : states) {
    step.values.push_back(static_cast<double>(state.index + 1));
    time.values.push_back(timeOf(state));
    h.values.push_back(orNaN(state.step));
    safe.values.push_back(state.bracket ? state.bracket->safe : nan);
    optimistic.values.push_back(state.bracket ? state.bracket->optimistic : nan);
    strain.values.push_back(state.notFinite == 0 ? state.strainEnergy : nan);
    history.verdicts.emplace_back(state.verdict() ? verdictName(*state.verdict()) : "");
    std::int32_t controlling = -1;
    if (state.bracket) {
      const ElementRef element = state.bracket->controlling;
      const std::string name = fmt::format("{}:{}", element.block, element.element);
      const auto found = std::find(history.elements.begin(), history.elements.end(), name);
      controlling = static_cast<std::int32_t>(found - history.elements.begin());
      if (found == history.elements.end()) history.elements.push_back(name);
    }
    history.controlling.push_back(controlling);
  }
  history.columns = {std::move(step), std::move(time),       std::move(h),
                     std::move(safe), std::move(optimistic), std::move(strain)};
  return history;
}

/// The first state that is proven too large for its step, else the first inverted one, else that of the least safe
/// step; the number of states for none.
std::size_t keyStateOf(const std::vector<AuditedState>& states) {
  const auto first = [&](const auto& holds) {
    return static_cast<std::size_t>(std::ranges::find_if(states, holds) - states.begin());
  };
  if (const std::size_t i = first([](const AuditedState& s) { return s.violated(); }); i < states.size()) return i;
  if (const std::size_t i = first([](const AuditedState& s) { return s.inverted() && s.bracket; }); i < states.size())
    return i;
  std::size_t key = states.size();
  for (std::size_t i = 0; i < states.size(); ++i)
    if (states[i].bracket && (key == states.size() || states[i].bracket->safe < states[key].bracket->safe)) key = i;
  return key;
}

/// The state with the steps of its elements.
VtuFrame frameOf(const Audit& audit, const AuditedState& state) {
  const NodeVectors x = audit.positions(state);
  VtuFrame frame = stateFrame(audit.body, x, state.bracket ? &*state.bracket : nullptr, state.step);
  frame.cells.push_back(stepField(evaluateMetric("reduced-1-ring", audit.body, x), audit.rule));
  const StressMeasure* const measures[] = {findStressMeasure("von_mises"), findStressMeasure("max_stretch")};
  auto stresses = stressOfElements(audit.body, x, measures);
  for (std::size_t m = 0; m < std::size(measures); ++m)
    frame.cells.push_back({std::string(measures[m]->title), false, std::move(stresses[m])});
  return frame;
}

void addFrames(PageContent& page, const Audit& audit, std::size_t key) {
  std::vector<std::size_t> shown;  // states that can be drawn
  std::size_t keyPlace = 0;
  for (std::size_t i = 0; i < audit.states.size(); ++i) {
    if (!audit.states[i].bracket) continue;
    if (i == key) keyPlace = shown.size();
    shown.push_back(i);
  }
  page.frames = audit.states.size();
  if (shown.empty()) return;
  MeshPack pack(page.data);
  constexpr std::size_t fields = 3;  // of frameOf
  const std::size_t fit = framesThatFit(audit.body.mesh().elementCount(), fields);
  for (const std::size_t place : chosenFrames(shown.size(), keyPlace, fit)) {
    const AuditedState& state = audit.states[shown[place]];
    pack.add({static_cast<std::int64_t>(state.index) + 1, timeOf(state), frameOf(audit, state)}, shown[place] == key);
    ++page.framesShown;
  }
  page.takeMesh(pack);
}

void analyse(PageContent& page, const Audit& audit, const AuditedState& state) {
  if (!audit.integrator) {
    page.whyNoAnalysis =
        "Left out: only the limit of the integrator is known; --integrator with one of the same limit adds it.";
  } else if (audit.body.mesh().elementCount() > analysedElements) {
    const VtuFrame frame = frameOf(audit, state);
    page.analysis = analyseFrame({frame, waveSpeedsOf(audit.body), blockOfElements(audit.body), audit.rule,
                                  state.bracket->safe, state.bracket->optimistic, state.step});
    page.analysis->where = page.where;
  } else {
    page.analysis = analyseState({audit.body, audit.positions(state), *audit.integrator, audit.rule, audit.damping,
                                  state.bracket->safe, state.bracket->optimistic, state.step});
    page.analysis->where = page.where;
  }
}

std::string sentence(std::string text) {
  if (!text.empty()) text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text + ".";
}

PageVerdict verdictOf(const Audit& audit, const RunHistory& history, const std::optional<RunAnalysis>& analysis) {
  using Tone = PageVerdict::Tone;
  PageVerdict verdict;
  const auto count = [&](const auto& holds) { return std::ranges::count_if(audit.states, holds); };
  const auto compared = count([](const AuditedState&s) { return s.verdict().has_value(); }),
             certified = count([](const AuditedState&s) { return s.verdict() == Verdict::certified; }),
             lost = count([](const AuditedState&s) { return s.lost(); });
  const auto event = [&](std::string_view key) {
    const auto found = std::ranges::find(audit.events, key, &AuditEvent::key);
    return found == audit.events.end() ? nullptr : &*found;
  };
  const AuditEvent *violated = event("violated"), *inverted = event("inverted");
  verdict.tone = Tone::bad;
  if (violated)
    verdict.title = "Step too large";
  else if (inverted)
    verdict.title = "Elements inverted";
  else if (lost > 0)
    verdict.title = "State lost";
  else if (compared == 0)
    verdict.title = "Brackets only", verdict.tone = Tone::unsure;
  else if (certified < compared)
    verdict.title = "Not proven", verdict.tone = Tone::unsure;
  else
    verdict.title = "Stable in every state", verdict.tone = Tone::good;
  verdict.sentence =
      compared == 0 ? "The results do not tell which step was taken; --step h holds one against the brackets."
                    : fmt::format("Of {} states whose step is known {} are proven stable at it.", compared, certified);
  for (const AuditEvent& found : audit.events) verdict.sentence += " " + sentence(found.text);

  const AuditEvent* first = violated ? violated : event("not_certified");
  if (first) {
    const auto before = violated ? std::optional(timeOf(audit.states[violated->state])) : std::nullopt;
    const auto least = smallestSafe(history, before);
    if (least && least->safe < orNaN(audit.states[first->state].step))
      verdict.remedies.push_back(fmt::format("Take a smaller step: {} s is proven in every audited state{}.",
                                             stepRoundedDown(least->safe), before ? " before that" : ""));
    if (const WhatIf* row = analysis ? analysis->inTheWay() : nullptr; row && !row->way.all.empty())
      for (const std::string& remedy : remediesFor(*row, *analysis)) verdict.remedies.push_back(remedy);
  } else if (compared > 0 && verdict.tone == Tone::good) {
    verdict.remedies.emplace_back("Nothing has to be done about the step in these states.");
  }
  if (event("indefinite"))
    verdict.remedies.emplace_back(
        "No step cures a negative eigenvalue: it is the state that is unstable there, as when something buckles.");
  if (inverted)
    verdict.remedies.emplace_back(
        "An inverted element is a state that no smaller step mends from there on: look at what happened before it.");
  return verdict;
}

}  // namespace

ReportResult writeAuditReport(const Audit& audit, const std::filesystem::path& file) {
  PageContent page;
  page.name = "Audit of " + std::filesystem::path(audit.name).filename().string();
  page.words = {"audited by",
                "the file of --json",
                "No state of the results can be drawn.",
                "are in the results",
                "No state has a bracket.",
                "history in the file of --json",
                "the results that were audited",
                "the file of --json"};
  page.summary = audit.json;
  page.elements = audit.body.mesh().elementCount();
  page.notes = audit.notes;
  if (std::ranges::any_of(audit.states, [](const AuditedState& state) { return !state.time; }))
    page.notes.emplace_back("The results do not tell the time of every state: times count states there.");
  Json events = Json::array();
  for (const AuditEvent& event : audit.events) {
    const double time = timeOf(audit.states[event.state]);
    page.marks.push_back({time, event.name});
    events.push_back({{"kind", event.key}, {"time", time}, {"text", sentence(event.text)}});
  }
  std::ranges::stable_sort(page.marks, {}, &ChartMark::time);
  page.summary["events"] = std::move(events);
  page.summary["notes"] = Json::array({page.summary["note"]});
  page.history = historyOf(audit.states);
  numberElements(*page.history, audit.body.mesh());
  const std::size_t key = keyStateOf(audit.states);
  if (key < audit.states.size()) {
    const AuditedState& state = audit.states[key];
    page.keyFrame = static_cast<std::int64_t>(state.index) + 1;
    page.keyStep = state.step;
    page.where = fmt::format("in state {}{}", page.keyFrame,
                             state.time ? fmt::format(", t = {:.6g} s", *state.time) : std::string());
    addFrames(page, audit, key);
    analyse(page, audit, state);
  } else {
    page.frames = audit.states.size();
    page.whyNoAnalysis = "Left out: no state has a bracket.";
  }
  page.verdict = verdictOf(audit, *page.history, page.analysis);
  ReportResult result = writtenPage(reportPage(page), page.verdict, page.notes, file);
  result.frames = page.framesShown;
  result.framesOfRun = page.frames;
  return result;
}

}  // namespace ringwatch

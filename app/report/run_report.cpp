#include <ringwatch/app/report/run_report.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include <fmt/format.h>

#include <ringwatch/app/output/frames.h>
#include <ringwatch/app/report/frame_choice.h>
#include <ringwatch/app/report/json_read.h>
#include <ringwatch/app/report/report_page.h>
#include <ringwatch/app/scene/saved_json.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/input_file.h>

namespace ringwatch {
namespace {

using Json = nlohmann::ordered_json;
using json_read::numberOf;
using json_read::textOf;

/// Null, with a note, when there is none or it is no object.
Json readSummary(const std::filesystem::path& folder, std::vector<std::string>& notes) {
  const std::filesystem::path file = folder / "summary.json";
  std::error_code error;
  if (!std::filesystem::exists(file, error) && !error) {
    notes.emplace_back("There is no summary.json: the run was killed, or still goes on.");
    return nullptr;
  }
  Json summary;
  try {
    summary = savedJson(readBytes(file));
  } catch (const InputError& fault) {
    notes.push_back(fmt::format("{}.", fault.what()));
    return nullptr;
  }
  if (summary.is_object()) return summary;
  notes.emplace_back("summary.json is damaged and was left out.");
  return nullptr;
}

/// What the pictures call an event of this kind.
std::string labelOf(const std::string& kind) {
  static const std::map<std::string, std::string, std::less<>> labels{
      {"violated", "the step is above the critical step"},
      {"energy-balance", "the energy balance is off"},
      {"inverted", "an element is inverted"},
      {"non-finite", "the state is no longer finite"},
      {"indefinite", "the tangent has a negative eigenvalue"},
      {"eroded", "elements left the run"},
      {"repeated", "the run went back"}};
  const auto found = labels.find(kind);
  return found == labels.end() ? kind : found->second;
}

/// The moments that the pictures mark.
std::vector<ChartMark> marksOf(const Json& summary) {
  std::vector<ChartMark> marks;
  // More than this cover each other.
  constexpr std::size_t most = 40;
  const auto add = [&](const Json& entry, std::string label) {
    const auto time = entry.is_object() ? numberOf(entry, "time") : std::nullopt;
    if (time && marks.size() < most) marks.push_back({*time, std::move(label)});
  };
  if (!summary.is_object()) return marks;
  if (const auto events = summary.find("events"); events != summary.end() && events->is_array())
    for (const Json& event : *events)
      if (event.is_object()) add(event, labelOf(textOf(event, "kind")));
  if (const auto cuts = summary.find("cuts"); cuts != summary.end() && cuts->is_array())
    for (const Json& cut : *cuts) add(cut, "cut");
  if (const auto runaway = summary.find("energy_runaway"); runaway != summary.end()) add(*runaway, "energy runs away");
  std::stable_sort(marks.begin(), marks.end(), [](const ChartMark& a, const ChartMark& b) { return a.time < b.time; });
  return marks;
}

/// The time of the state with the largest strain energy of those whose safe step is the smallest one or hardly larger,
/// s.
std::optional<double> mostStrainedTime(const RunHistory& history, const SmallestSafe& least) {
  constexpr double hardly = 1.05;  // by which a bracket moves without a cause
  const std::vector<double>*time = history.column("time_s"), *safe = history.column("safe_s"),
        *strain = history.column("strain_J");
  if (!strain) return least.time;
  double found = least.time, most = 0;
  for (std::size_t i = 0; i < history.rowCount(); ++i)
    if ((*safe)[i] <= hardly * least.safe && (*strain)[i] > most) most = (*strain)[i], found = (*time)[i];
  return found;
}

/// Whether elements keep their places through a run.
bool keepsItsElements(const Json& summary) {
  if (!summary.is_object()) return false;
  const auto cuts = summary.find("cuts"), erosion = summary.find("erosion");
  return (cuts == summary.end() || cuts->empty()) && (erosion == summary.end() || erosion->is_null());
}

/// The elements that control the bracket: that of the first violation, then those that do so in most rows.
std::vector<ElementRef> controllingOf(const Json& summary, const std::optional<RunHistory>& history) {
  constexpr std::size_t most = 3;
  std::vector<ElementRef> found;
  const auto add = [&found](ElementRef ref) {
    if (found.size() < most && std::ranges::find(found, ref) == found.end()) found.push_back(ref);
  };
  if (summary.is_object())
    if (const auto events = summary.find("events"); events != summary.end() && events->is_array())
      for (const Json& event : *events)
        if (event.is_object() && textOf(event, "kind") == "violated")
          if (const auto element = event.find("element"); element != event.end() && element->is_object())
            add({static_cast<std::int32_t>(numberOf(*element, "block").value_or(-1)),
                 static_cast<std::int32_t>(numberOf(*element, "index").value_or(-1))});
  if (!history) return found;
  std::vector<std::pair<std::size_t, std::size_t>> rows(history->elements.size());  // how many, of which element
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = {0, i};
  for (const std::int32_t element : history->controlling)
    if (element >= 0) ++rows[element].first;
  std::ranges::stable_sort(rows, std::greater{}, &std::pair<std::size_t, std::size_t>::first);
  for (const auto& [count, element] : rows)
    if (const auto ref = elementAt(history->elements[element])) add(*ref);
  return found;
}

/// The time of the frame that picture, cards and analysis are of, s: that of the first violation, else that of the
/// smallest safe step, and of states that hardly differ in it that of the most strained one; empty for neither.
std::optional<double> keyTimeOf(const Json& summary, const std::optional<RunHistory>& history) {
  if (summary.is_object())
    if (const auto moment = summary.find("first_violated"); moment != summary.end() && moment->is_object())
      if (const auto time = numberOf(*moment, "time")) return time;
  if (history)
    if (const auto least = smallestSafe(*history)) return mostStrainedTime(*history, *least);
  return std::nullopt;
}

/// The first frame from that time on: the elements in the way are in the way there. Where that state has long left what
/// the run's step is about, the frame before it, unless contact leaves the elements where they were; without a time the
/// last one.
std::size_t keyFrameOf(const std::vector<PvdEntry>& frames, std::optional<double> time, bool ofContact,
                       const std::function<const VtuFrame*(std::size_t)>& read) {
  std::size_t key = frames.size() - 1;
  for (std::size_t i = 0; time && i < frames.size(); ++i)
    if (frames[i].time >= *time) {
      key = i;
      break;
    }
  constexpr double useful = 0.5;  // of the step
  if (!time || key == 0 || ofContact) return key;
  const VtuFrame* frame = read(key);
  if (!frame) return key - 1;
  const auto safe = frame->values.find(labelled("safe step (s)")), h = frame->values.find(labelled("step (s)"));
  const bool left = h != frame->values.end() && safe != frame->values.end() && !std::isnan(safe->second) &&
                    !(safe->second > useful * h->second);
  return left ? key - 1 : key;
}

/// Returns the key frame of a mesh that is too large to be read again for its analysis; empty for none.
std::optional<VtuFrame> addFrames(PageContent& page, const ReportOptions& options,
                                  const std::vector<PvdEntry>& frames) {
  page.frames = frames.size();
  std::optional<VtuFrame> large;
  if (frames.empty()) return large;
  MeshPack pack(page.data);
  std::vector<std::size_t> chosen;
  std::size_t failed = 0;
  std::string firstFault;
  const auto read = [&](std::size_t i) -> std::optional<VtuFrame> {
    try {
      return readVtuFrame(options.folder / frames[i].file);
    } catch (const InputError& fault) {
      if (failed++ == 0) firstFault = fault.what();
      return std::nullopt;
    }
  };
  std::map<std::size_t, std::optional<VtuFrame>> known;
  const auto cached = [&](std::size_t i) -> const VtuFrame* {
    const auto [found, added] = known.try_emplace(i);
    if (added) found->second = read(i);
    return found->second ? &*found->second : nullptr;
  };
  const std::size_t key =
      keyFrameOf(frames, keyTimeOf(page.summary, page.history), discreteGoverns(page.summary), cached);
  const VtuFrame* keyState = cached(key);
  const std::size_t fit = options.frames > 0 ? options.frames
                          : keyState         ? framesThatFit(keyState->mesh.elementCount(), keyState->cells.size())
                                             : 3;
  for (const std::size_t i : chosenFrames(frames.size(), key, fit)) {
    std::optional<VtuFrame> state = known.contains(i) ? std::exchange(known.at(i), std::nullopt) : read(i);
    if (!state) continue;
    if (i == key) {
      page.keyFrame = static_cast<std::int64_t>(i) + 1;
      page.where = fmt::format("in frame {}, t = {:.6g} s", page.keyFrame, frames[i].time);
      if (const auto h = state->values.find(labelled("step (s)")); h != state->values.end()) page.keyStep = h->second;
    }
    PageFrame shown{static_cast<std::int64_t>(i) + 1, frames[i].time, std::move(*state)};
    const bool same = i == key && keepsItsElements(page.summary);
    pack.add(shown, i == key, same ? controllingOf(page.summary, page.history) : std::vector<ElementRef>());
    if (same && page.history) numberElements(*page.history, shown.state.mesh);
    if (i == key && shown.state.mesh.elementCount() > analysedElements) large = std::move(shown.state);
    ++page.framesShown;
  }
  if (failed > 0) page.notes.push_back(fmt::format("{} frames cannot be read: {}", failed, firstFault));
  if (page.framesShown > 0) page.takeMesh(pack);
  return large;
}

/// Wall time that the monitor took a step of the run, s; 0 where that is not known.
double monitorSecondsOf(const Json& summary) {
  const auto times = summary.find("wall_time");
  const double steps = numberOf(summary, "steps").value_or(0);
  if (times == summary.end() || !times->is_object() || !(steps > 0)) return 0;
  return std::max(0.0, numberOf(*times, "monitor").value_or(0)) / steps;
}

/// Of the key frame; large: that of a mesh that is too large to be read again.
void analyse(PageContent& page, const std::filesystem::path& folder, const std::vector<PvdEntry>& frames,
             const std::optional<VtuFrame>& large) {
  if (page.keyFrame == 0 || !page.summary.is_object()) {
    page.whyNoAnalysis = page.keyFrame == 0 ? "Left out: it is computed from a frame, and there is none to be read."
                                            : "Left out: it needs the scene, which is in summary.json.";
    return;
  }
  try {
    if (large) {
      page.analysis = analyseLargeRun(folder, *large);
      page.analysis->where = page.where;
      return;
    }
    const PvdEntry& frame = frames[page.keyFrame - 1];
    const VtuFrame state = readVtuFrame(folder / frame.file);
    const auto value = [&](const std::string& name) -> std::optional<double> {
      const auto found = state.values.find(name);
      return found == state.values.end() || !std::isfinite(found->second) ? std::nullopt : std::optional(found->second);
    };
    page.analysis =
        analyseRun(folder, frame.file, value(labelled("safe step (s)")), value(labelled("optimistic step (s)")),
                   value(labelled("step (s)")), monitorSecondsOf(page.summary));
    page.analysis->where = page.where;
  } catch (const std::runtime_error& fault) {
    page.whyNoAnalysis = fmt::format("Left out: {}", fault.what());
  }
}

}  // namespace

ReportResult writeRunReport(const ReportOptions& options) {
  const std::filesystem::path& folder = options.folder;
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error))
    throw InputError(fmt::format("{}: is no folder; give the folder of a run, e.g. out/stretch_bar", folder.string()));
  const auto has = [&](const char* name) { return std::filesystem::is_regular_file(folder / name, error); };
  if (!has("history.csv") && !has("summary.json") && !has("run.pvd"))
    throw InputError(fmt::format(
        "{}: is not the folder of a run: it has neither history.csv nor summary.json nor run.pvd", folder.string()));

  PageContent page;
  if (options.live) {
    page.summary = options.live->summary;
    page.reloadAfter = options.live->reloadAfter;
  } else {
    page.summary = readSummary(folder, page.notes);
  }
  page.history = readRunHistory(folder);
  if (page.history) useUnits(page.history->units);
  if (page.history)
    page.notes.insert(page.notes.end(), page.history->notes.begin(), page.history->notes.end());
  else
    page.notes.emplace_back("There is no history.csv.");
  const std::string scene = page.summary.is_object() ? textOf(page.summary, "scene_file") : std::string();
  page.name = "Run of " + (scene.empty() ? std::filesystem::absolute(folder).lexically_normal().filename().string()
                                         : std::filesystem::path(scene).filename().string());
  page.marks = marksOf(page.summary);
  std::vector<PvdEntry> frames;
  if (has("run.pvd")) frames = framesOfRun(folder);
  const std::optional<VtuFrame> large = addFrames(page, options, frames);
  if (options.live)
    page.whyNoAnalysis = "Left out while the run goes on: it is computed when the run has ended.";
  else
    analyse(page, folder, frames, large);
  page.verdict = verdictOf(page.summary, page.history, page.analysis ? &*page.analysis : nullptr);

  const std::string html = reportPage(page);
  ReportResult result =
      writtenPage(html, page.verdict, page.notes, options.output.empty() ? folder / "report.html" : options.output);
  result.frames = page.framesShown;
  result.framesOfRun = page.frames;
  return result;
}

}  // namespace ringwatch

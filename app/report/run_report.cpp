#include <ringwatch/app/report/run_report.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <utility>

#include <fmt/format.h>

#include <ringwatch/app/output/frames.h>
#include <ringwatch/app/report/json_read.h>
#include <ringwatch/app/report/report_page.h>
#include <ringwatch/base/atomic_file.h>
#include <ringwatch/base/error.h>

namespace ringwatch {
namespace {

using Json = nlohmann::ordered_json;
using json_read::numberOf;
using json_read::textOf;

/// Null, with a note, when there is none or it is no object.
Json readSummary(const std::filesystem::path& folder, std::vector<std::string>& notes) {
  std::ifstream stream(folder / "summary.json", std::ios::binary);
  if (!stream) {
    notes.emplace_back("There is no summary.json: the run was killed, or still goes on.");
    return nullptr;
  }
  Json summary = Json::parse(stream, nullptr, false);
  if (summary.is_object()) return summary;
  notes.emplace_back("summary.json is damaged and was left out.");
  return nullptr;
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
      if (event.is_object()) add(event, textOf(event, "kind"));
  if (const auto cuts = summary.find("cuts"); cuts != summary.end() && cuts->is_array())
    for (const Json& cut : *cuts) add(cut, "cut");
  if (const auto runaway = summary.find("energy_runaway"); runaway != summary.end()) add(*runaway, "energy runs away");
  std::stable_sort(marks.begin(), marks.end(), [](const ChartMark& a, const ChartMark& b) { return a.time < b.time; });
  return marks;
}

/// The frame that the picture and the cards are of: the last one before the step is violated for the first time, where
/// the elements still have their part in it, else the last one.
std::size_t keyFrameOf(const std::vector<PvdEntry>& frames, const Json& summary) {
  if (summary.is_object())
    if (const auto moment = summary.find("first_violated"); moment != summary.end() && moment->is_object())
      if (const auto time = numberOf(*moment, "time"))
        for (std::size_t i = 0; i < frames.size(); ++i)
          if (frames[i].time >= *time) return i;
  return frames.size() - 1;
}

/// At most `count` of the frames, ascending: first, key and last one, and evenly many between.
std::vector<std::size_t> chosenFrames(std::size_t frames, std::size_t key, std::size_t count) {
  count = std::min(count, frames);
  std::vector<std::size_t> wanted{key, 0, frames - 1};
  for (std::size_t k = 1; k + 1 < count; ++k) wanted.push_back(k * (frames - 1) / (count - 1));
  std::vector<std::size_t> chosen;
  for (const std::size_t i : wanted)
    if (chosen.size() < count && std::find(chosen.begin(), chosen.end(), i) == chosen.end()) chosen.push_back(i);
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

/// How many frames keep page and time within bounds: for meshes of n elements and their nodes.
std::size_t framesThatFit(const VtuFrame& frame) {
  // Two numbers of 16 bits a node and element go into the page where all elements do.
  constexpr std::size_t bytesOfPage = 6'000'000, most = 60;
  const std::size_t elements = frame.mesh.elementCount(), fields = std::max<std::size_t>(1, frame.cells.size());
  // Of larger meshes those with the least steps, and the surface, which grows more slowly than the body.
  const double surface = 12 * std::pow(static_cast<double>(elements), 2.0 / 3.0);
  const double shown = elements <= MeshPack::allElements
                           ? static_cast<double>(elements)
                           : std::min(static_cast<double>(elements), surface + 2 * MeshPack::leastElements);
  const double bytes = shown * (6 + 2 * static_cast<double>(fields));
  // Reading and packing take about 0.4 µs an element and frame.
  constexpr double elementsRead = 2e6;
  const double fit = std::min(static_cast<double>(bytesOfPage) / bytes, elementsRead / static_cast<double>(elements));
  return std::clamp<std::size_t>(static_cast<std::size_t>(fit), 2, most);
}

void addFrames(PageContent& page, const ReportOptions& options, const std::vector<PvdEntry>& frames) {
  page.frames = frames.size();
  if (frames.empty()) return;
  MeshPack pack(page.data);
  const std::size_t key = keyFrameOf(frames, page.summary);
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
  std::optional<VtuFrame> keyState = read(key);
  const std::size_t fit = options.frames > 0 ? options.frames : keyState ? framesThatFit(*keyState) : 3;
  for (const std::size_t i : chosenFrames(frames.size(), key, fit)) {
    std::optional<VtuFrame> state = i == key ? std::exchange(keyState, std::nullopt) : read(i);
    if (!state) continue;
    if (i == key) {
      page.keyFrame = static_cast<std::int64_t>(i) + 1;
      page.keyTime = frames[i].time;
      if (const auto h = state->values.find("step (s)"); h != state->values.end()) page.keyStep = h->second;
    }
    pack.add({static_cast<std::int64_t>(i) + 1, frames[i].time, std::move(*state)}, i == key);
    ++page.framesShown;
  }
  if (failed > 0) page.notes.push_back(fmt::format("{} frames cannot be read: {}", failed, firstFault));
  if (page.framesShown == 0) return;
  page.mesh = pack.finish();
  page.worst = pack.worst();
  page.picture = pack.picture();
  page.pictureScale = pack.pictureScale();
  page.stepField = pack.stepField();
  page.elements = pack.elementCount();
}

void analyse(PageContent& page, const std::filesystem::path& folder, const std::vector<PvdEntry>& frames) {
  if (frames.empty() || !page.summary.is_object()) {
    page.whyNoAnalysis = frames.empty() ? "Left out: it is computed from the first frame, and there are no frames."
                                        : "Left out: it needs the scene, which is in summary.json.";
    return;
  }
  if (page.elements > analysedElements) {
    page.whyNoAnalysis = fmt::format(
        "Left out for a mesh of more than {} elements. ringwatch inspect DIR --frame 1 computes it: with "
        "--distribution "
        "how the steps spread, with --step h what a handler would take.",
        analysedElements);
    return;
  }
  try {
    std::optional<double> safe, optimistic, taken;
    const VtuFrame first = readVtuFrame(folder / frames.front().file);
    const auto value = [&](const char* name) -> std::optional<double> {
      const auto found = first.values.find(name);
      return found == first.values.end() || !std::isfinite(found->second) ? std::nullopt : std::optional(found->second);
    };
    page.analysis = analyseRun(folder, frames.front().file, value("safe step (s)"), value("optimistic step (s)"),
                               value("step (s)"));
    page.analysis->time = frames.front().time;
  } catch (const std::runtime_error& fault) {
    page.whyNoAnalysis = fmt::format("Left out: {}", fault.what());
  }
}

}  // namespace

ReportWriter reportWriter() { return writeRunReport; }

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
  page.summary = readSummary(folder, page.notes);
  page.history = readRunHistory(folder);
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
  addFrames(page, options, frames);
  analyse(page, folder, frames);

  std::optional<std::size_t> inTheWay;
  if (page.analysis && page.analysis->taken)
    for (const WhatIf& what : page.analysis->whatIf)
      if (what.h == *page.analysis->taken) inTheWay = what.elements;
  page.verdict = verdictOf(page.summary, page.history, inTheWay);

  ReportResult result;
  result.file = options.output.empty() ? folder / "report.html" : options.output;
  result.frames = page.framesShown;
  result.framesOfRun = page.frames;
  result.title = page.verdict.title;
  result.sentence = page.verdict.sentence;
  result.notes = page.notes;
  const std::string html = reportPage(std::move(page));
  result.bytes = html.size();
  writeFileAtomically(result.file, html);
  return result;
}

}  // namespace ringwatch

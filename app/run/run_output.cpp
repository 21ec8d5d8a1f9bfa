#include <ringwatch/app/run/run_output.h>

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <ringwatch/app/output/report.h>

namespace ringwatch {
namespace {

/// Removes what an earlier run left in the folder under the names of this one, and what one that was killed left half
/// written.
void removeOldResults(const std::filesystem::path& folder) {
  std::error_code error;
  for (const char* name :
       {"history.csv", "summary.json", "run.pvd", "critical_step.png", "critical_step.gp", "critical_step.dat"})
    std::filesystem::remove(folder / name, error);
  std::vector<std::filesystem::path> halfWritten;
  for (const std::filesystem::path& place : {folder, folder / "frames"})
    for (const auto& entry : std::filesystem::directory_iterator(place, error))
      if (entry.path().extension().string().starts_with(".part")) halfWritten.push_back(entry.path());
  for (const std::filesystem::path& file : halfWritten) std::filesystem::remove(file, error);
}

}  // namespace

RunOutput::RunOutput(const Scene& scene, const Body& body, StepRule rule, std::filesystem::path folder)
    : scene_(scene), body_(body), rule_(std::move(rule)), folder_(std::move(folder)), lock_(folder_) {}

void RunOutput::open() {
  if (history_) return;
  removeOldResults(folder_);
  history_.emplace(folder_);
  if (scene_.frameInterval) frames_.emplace(folder_, scene_, body_, rule_);
}

void RunOutput::writeRow(const HistoryRow& row) {
  history_->write(row);
  if (!scene_.picture || !row.verdict) return;
  picture_.add(row);
  pictured_ = true;
}

void RunOutput::writeFrame(std::int64_t step, const State& state, const FrameState& frame) {
  frames_->write(state.x, state.v, frame);
  lastFrame_ = step;
  // The first multiple of the interval that is still to come, however many lie within a step.
  const double interval = *scene_.frameInterval, reached = frame.time + 1e-3 * frame.h;
  framesDue_ = std::max(framesDue_, static_cast<std::int64_t>(reached / interval) - 1);
  while (nextFrame_ <= reached) nextFrame_ = static_cast<double>(++framesDue_) * interval;
}

void RunOutput::finish(RunResult& result, const State& state, const FrameState& last) {
  open();
  history_->finish();
  result.files.emplace_back("history.csv");
  if (frames_) {
    if (result.reason != ExitReason::nonFinite && lastFrame_ != result.steps) writeFrame(result.steps, state, last);
    frames_->removeStale();
    result.frames = frames_->count();
    result.files.push_back(fmt::format("run.pvd ({} frames)", frames_->count()));
  }
  if (pictured_) drawPicture(result);
}

void RunOutput::drawPicture(RunResult& result) {
  if (result.firstViolated) picture_.markViolation(result.firstViolated->time);
  if (result.runaway) picture_.markRunaway(result.runaway->time);
  for (const CutRecord& cut : result.cuts) picture_.markCut(cut.time);
  const std::string note =
      picture_.draw(folder_, fmt::format("{}: {}, {}, {}", scene_.file.stem().string(), elementCounts(body_.mesh()),
                                         modelsText(scene_.materials), scene_.method));
  if (note.empty())
    result.files.emplace_back("critical_step.png");
  else
    result.notes.push_back(note);
  result.files.emplace_back("critical_step.gp");
  result.files.emplace_back("critical_step.dat");
}

}  // namespace ringwatch

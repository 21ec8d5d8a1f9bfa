#include <ringwatch/app/run/run_output.h>

#include <algorithm>
#include <initializer_list>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <ringwatch/app/output/report.h>
#include <ringwatch/app/run/checkpoint.h>
#include <ringwatch/app/run/runner.h>
#include <ringwatch/body/domain.h>
#include <ringwatch/monitor/certificate_file.h>

namespace ringwatch {
namespace {

/// Removes files of an earlier run, and what one that was killed left half written.
void removeOldResults(const std::filesystem::path& folder, std::initializer_list<const char*> names) {
  std::error_code error;
  for (const char* name : names) std::filesystem::remove(folder / name, error);
  std::vector<std::filesystem::path> halfWritten;
  for (const std::filesystem::path& place : {folder, folder / "frames", folder / "certificates"})
    for (const auto& entry : std::filesystem::directory_iterator(place, error))
      if (entry.path().extension().string().starts_with(".part")) halfWritten.push_back(entry.path());
  for (const std::filesystem::path& file : halfWritten) std::filesystem::remove(file, error);
}

}  // namespace

RunOutput::RunOutput(const Scene& scene, const Body& body, StepRule rule, std::filesystem::path folder,
                     const RunOfPart* part)
    : scene_(scene),
      body_(body),
      part_(part),
      writes_(body.domain().first()),
      rule_(std::move(rule)),
      folder_(std::move(folder)),
      certificates_(scene, body, folder_ / "certificates") {
  if (writes_) lock_.emplace(folder_);
}

void RunOutput::beginFrames() {
  if (scene_.frameInterval) frames_.emplace(folder_, scene_, body_, rule_, part_ ? part_->pieces : nullptr);
}

void RunOutput::open() {
  if (open_) return;
  // What may be refused comes first: former results stay as they are then.
  beginFrames();
  open_ = true;
  if (writes_) beginFiles();
}

void RunOutput::beginFiles() {
  removeOldResults(folder_, {"history.csv", "probes.csv", "summary.json", "run.pvd", "critical_step.png",
                             "critical_step.gp", "critical_step.dat", checkpointFile});
  certificates_.begin(0);
  history_.emplace(folder_);
  if (scene_.probed()) probes_.emplace(folder_ / "probes.csv", probesHeading_);
}

void RunOutput::resume(const nlohmann::ordered_json& saved, std::int64_t step) {
  // What may be refused comes first: the folder stays as it was then, and nothing has begun.
  if (scene_.frameInterval) {
    beginFrames();
    frames_->goOnBehind(saved.at("frames").get<std::vector<double>>());
    nextFrame_ = saved.at("next_frame").get<double>();
    framesDue_ = saved.at("frames_due").get<std::int64_t>();
    lastFrame_ = saved.at("last_frame").get<std::int64_t>();
  }
  const auto bytesOf = [&](const char* file) { return saved.at(file).get<std::size_t>(); };
  if (writes_) {
    RowFile::requireBytes(folder_ / "history.csv", bytesOf("history"));
    if (scene_.probed()) RowFile::requireBytes(folder_ / "probes.csv", bytesOf("probes"));
  }
  open_ = true;
  if (!writes_) return;
  history_.emplace(folder_, bytesOf("history"));
  if (scene_.probed()) probes_.emplace(folder_ / "probes.csv", bytesOf("probes"));
  if (scene_.picture)
    for (const HistoryRow& row : readHistory(folder_)) keepForPicture(row);
  removeOldResults(folder_, {"summary.json", "critical_step.png", "critical_step.gp", "critical_step.dat"});
  certificates_.begin(step);
}

void RunOutput::goBack(const nlohmann::ordered_json& saved, std::int64_t step) {
  picture_ = {};
  pictured_ = false;
  if (!saved.is_null()) return resume(saved, step);
  history_.reset();
  probes_.reset();
  frames_.reset();
  nextFrame_ = 0;
  framesDue_ = 0;
  lastFrame_ = -1;
  open_ = false;
}

void RunOutput::sync() {
  if (history_) history_->sync();
  if (probes_) probes_->sync();
}

nlohmann::ordered_json RunOutput::save() {
  if (!open_) return nullptr;
  return {{"history", history_ ? history_->bytes() : 0},
          {"probes", probes_ ? probes_->bytes() : 0},
          {"frames", frames_ ? frames_->times() : std::vector<double>()},
          {"next_frame", nextFrame_},
          {"frames_due", framesDue_},
          {"last_frame", lastFrame_}};
}

void RunOutput::keepForPicture(const HistoryRow& row) {
  if (!scene_.picture || !row.verdict) return;
  picture_.add(row);
  pictured_ = true;
}

void RunOutput::writeRow(const HistoryRow& row) {
  if (!history_) return;
  history_->write(row);
  keepForPicture(row);
}

void RunOutput::writeFrame(std::int64_t step, const State& state, const FrameState& frame) {
  lastFrame_ = step;
  writeFrameBetween(state.x, state.v, frame);
}

void RunOutput::writeFrameBetween(const NodeVectors& x, const NodeVectors& v, const FrameState& frame) {
  frames_->write(x, v, frame);
  // The first multiple of the interval that is still to come, however many lie within a step.
  const double interval = *scene_.frameInterval, reached = frame.time + 1e-3 * frame.h;
  framesDue_ = std::max(framesDue_, static_cast<std::int64_t>(reached / interval) - 1);
  while (nextFrame_ <= reached) nextFrame_ = static_cast<double>(++framesDue_) * interval;
}

void RunOutput::finish(RunResult& result, const State& state, const FrameState* last) {
  open();
  if (history_) history_->finish();
  result.files.emplace_back("history.csv");
  if (probes_) {
    probes_->finish();
    result.files.emplace_back("probes.csv");
  }
  if (frames_) {
    if (last && lastFrame_ != result.steps) writeFrame(result.steps, state, *last);
    frames_->removeStale();
    result.frames = frames_->count();
    result.files.push_back(fmt::format("run.pvd ({} frames)", frames_->count()));
  }
  if (!writes_) return;
  if (const std::int64_t count = certificates_.count(); count > 0)
    result.files.push_back(
        fmt::format("certificates ({} files, of the body {:016x})", count, certifiedBodyHash(body_)));
  if (pictured_) drawPicture(result);
}

void RunOutput::drawPicture(RunResult& result) {
  if (result.firstViolated) picture_.markViolation(result.firstViolated->time);
  if (result.runaway) picture_.markRunaway(result.runaway->time);
  for (const CutRecord& cut : result.cuts) picture_.markCut(cut.time);
  const std::string note = picture_.draw(folder_, fmt::format("{}: {}, {}, {}", scene_.file.stem().string(),
                                                              elementCounts((part_ ? *part_->whole : body_).mesh()),
                                                              modelsText(scene_.materials), scene_.method));
  if (note.empty())
    result.files.emplace_back("critical_step.png");
  else
    result.notes.push_back(note);
  result.files.emplace_back("critical_step.gp");
  result.files.emplace_back("critical_step.dat");
}

}  // namespace ringwatch

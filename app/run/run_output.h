#pragma once
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include <ringwatch/app/output/frames.h>
#include <ringwatch/app/output/history.h>
#include <ringwatch/app/output/picture.h>
#include <ringwatch/app/output/row_file.h>
#include <ringwatch/app/run/folder_lock.h>
#include <ringwatch/app/run/run_certificates.h>
#include <ringwatch/app/run/run_result.h>
#include <ringwatch/app/scene/scene.h>
#include <ringwatch/integrators/integrator.h>

namespace ringwatch {

struct RunOfPart;

/// The files of a run in progress: history.csv, probes.csv, frames and picture, in a folder that no other run may write
/// into.
class RunOutput {
 public:
  /// Takes the folder, which is made when it does not exist. Throws InputError when it cannot be written or another run
  /// writes into it. Scene and body must outlive the output; a cut may replace the body's contents. part: where the
  /// body is one; the first process writes all but the pieces of frames, and the others take no folder.
  RunOutput(const Scene& scene, const Body& body, StepRule rule, std::filesystem::path folder,
            const RunOfPart* part = nullptr);

  /// Removes what an earlier run left and begins history and frames, once: until it is known that there is a first
  /// step, old results stay.
  void open();
  /// There are results of this run.
  bool isOpen() const { return open_; }
  /// The first row of probes.csv, where one is wanted; call it before open() or resume().
  void probesBegin(std::string heading) { probesHeading_ = std::move(heading); }
  /// Goes on behind what was there at a checkpoint before that step; call it in place of open().
  void resume(const nlohmann::ordered_json& saved, std::int64_t step);
  /// What resume() needs; call it at a state where all rows and frames before it are written. Null before open().
  nlohmann::ordered_json save();
  /// Puts what is written onto the disk, where a machine that fails leaves it.
  void sync();
  /// Drops what was written behind a save() before that step, and goes on from there.
  void goBack(const nlohmann::ordered_json& saved, std::int64_t step);
  void writeRow(const HistoryRow& row);
  /// A row of probes.csv.
  void writeProbes(const std::string& row) { probes_->write(row); }
  /// Writes the rows that are still held back.
  void flush() {
    if (history_) history_->bytes();
    if (probes_) probes_->bytes();
  }
  /// The step from this row of the history was shortened to end with the run: the picture leaves it out.
  void leaveOut(std::int64_t step) { picture_.leaveOut(step); }
  /// A frame is due at that time (s), with steps of h (s).
  bool frameDue(double time, double h) const { return frames_ && time >= nextFrame_ - 1e-3 * h; }
  /// s; infinite where no frames are wanted.
  double nextFrame() const { return frames_ ? nextFrame_ : std::numeric_limits<double>::infinity(); }
  /// The frame of the state before a step; frame.time and frame.h are those of the state.
  void writeFrame(std::int64_t step, const State& state, const FrameState& frame);
  /// A frame at positions and velocities between steps.
  void writeFrameBetween(const NodeVectors& x, const NodeVectors& v, const FrameState& frame);
  RunCertificates& certificates() { return certificates_; }
  /// Ends history and frames, the last frame of which is `last` unless it is there (nullptr: none), draws the picture
  /// and lists the files in the result.
  void finish(RunResult& result, const State& state, const FrameState* last);

 private:
  void beginFiles();
  void beginFrames();
  void drawPicture(RunResult& result);
  void keepForPicture(const HistoryRow& row);

  const Scene& scene_;
  const Body& body_;
  const RunOfPart* part_;
  bool writes_;  // what there is once
  StepRule rule_;
  std::filesystem::path folder_;
  std::optional<FolderLock> lock_;
  RunCertificates certificates_;
  bool open_ = false;
  std::optional<HistoryWriter> history_;
  std::string probesHeading_;
  std::optional<RowFile> probes_;
  std::optional<FrameWriter> frames_;
  Picture picture_;
  bool pictured_ = false;  // the picture has a row
  double nextFrame_ = 0;   // s
  std::int64_t framesDue_ = 0, lastFrame_ = -1;
};

}  // namespace ringwatch

#include <ringwatch/app/analysis/advised_runs.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include <ringwatch/app/run/run_listener.h>
#include <ringwatch/app/run/runner.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/scratch_folder.h>
#include <ringwatch/handlers/selection/selection.h>
#include <ringwatch/monitor/stability_monitor.h>
#include <ringwatch/verify/processor_time.h>

namespace ringwatch {
namespace {

constexpr std::int64_t mostSamples = 16, stepsPerSample = 8;

MonitorMode watchedBy(const Scene& scene) { return scene.proves() ? scene.mode : MonitorMode::threshold; }

/// Keeps the positions at equal distances of time, and the time that the run takes, with the choice of elements and the
/// first observation, without what a run tells of itself at its end. A state that comes a little later or earlier is
/// moved there along its velocity.
class Sampler final : public RunListener {
 public:
  Sampler(std::vector<NodeVectors>& moments, double interval, std::size_t count)
      : moments_(moments), interval_(interval), count_(count) {}

  void observe(const RunMoment& moment) override {
    lastStep_ = threadSeconds();
    if (steps_++ == 0) firstStep_ = lastStep_;
    const double wanted = interval_ * static_cast<double>(moments_.size() + 1);
    if (moments_.size() + 1 < count_ && moment.time > wanted - 0.5 * moment.h)
      moments_.emplace_back(moment.state.x + (wanted - moment.time) * moment.state.v);
    if (moment.time > moment.end - 1.5 * moment.h) last_ = moment.state.v;
  }
  /// Call it when the run has ended.
  void complete(const RunResult& result) {
    const double wanted = interval_ * static_cast<double>(count_);
    if (moments_.size() + 1 == count_ && last_.size() > 0)
      moments_.emplace_back(result.x + (wanted - result.time) * last_);
  }
  /// The step after the last moment takes as long as the others do in the mean.
  double seconds() const {
    return lastStep_ - begin_ + (steps_ > 1 ? (lastStep_ - firstStep_) / static_cast<double>(steps_ - 1) : 0);
  }

 private:
  std::vector<NodeVectors>& moments_;
  double interval_;
  std::size_t count_;
  NodeVectors last_;  // velocities before the last step
  std::int64_t steps_ = 0;
  double begin_ = threadSeconds(), firstStep_ = 0, lastStep_ = 0;
};

}  // namespace

AdvisedRuns::AdvisedRuns(const SceneStart& start, double h, double own, std::int64_t steps, bool progress)
    : start_(start),
      h_(h),
      progress_(progress),
      samples_(static_cast<std::size_t>(std::clamp<std::int64_t>(steps / stepsPerSample, 1, mostSamples))) {
  const auto moments = static_cast<std::int64_t>(samples_);
  steps_ = std::max<std::int64_t>(1, steps / moments) * moments;
  const auto equal = [&](double step) {
    return moments * static_cast<std::int64_t>(std::ceil(time() / step / static_cast<double>(moments) - 1e-9));
  };
  const std::int64_t ownSteps = equal(own);
  const std::string& method = start.scene.method;
  const Run finer = run({method, "", 2 * ownSteps, OnViolation::reduceStep, true, false}, reference_);
  Moments moved;
  explicit_ = run({method, "", ownSteps, OnViolation::reduceStep, true, true}, moved);
  if (!finer.lost.empty()) {
    noReference_ = fmt::format("{} at half its step: {}", method, finer.lost);
    reference_.clear();
  } else if (explicit_.lost.empty()) {
    // Richardson's extrapolation, where both took the steps that they were to take.
    if (explicit_.steps == ownSteps && finer.steps == 2 * ownSteps)
      for (std::size_t k = 0; k < samples_; ++k)
        reference_[k] += (reference_[k] - moved[k]) / (std::exp2(start.integrator->order) - 1);
    explicit_.error = errorOf(moved);
  }
}

std::string_view AdvisedRuns::mode() const { return monitorModeName(watchedBy(start_.scene)); }

AdvisedRuns::Run AdvisedRuns::handled(const std::string& handler) const {
  Moments moments;
  Run result = run({start_.scene.method, handler, steps_, OnViolation::handle, true, true}, moments);
  if (result.lost.empty()) result.error = errorOf(moments);
  return result;
}

AdvisedRuns::Run AdvisedRuns::implicit(const std::string& method) const {
  Moments moments;
  Run result = run({method, "", steps_, OnViolation::warn, false, true}, moments);
  if (result.lost.empty()) result.error = errorOf(moments);
  return result;
}

AdvisedRuns::Run AdvisedRuns::run(const Settings& settings, Moments& moments) const {
  constexpr double quick = 0.5;  // s; what takes less is repeated, since others share the machine and its caches
  Scene scene = start_.scene;
  scene.method = settings.method;
  scene.handler = settings.handler;
  if (const HandlerInfo* info = findHandler(settings.handler))
    scene.handlerOptions = optionsFor(*info, scene.handlerOptions);
  scene.end = time();
  scene.step = time() / static_cast<double>(settings.steps);
  scene.device = RunDevice::cpu;
  scene.mode = settings.watched ? watchedBy(scene) : MonitorMode::metric;
  scene.metric.clear();
  scene.onViolation = settings.onViolation;
  scene.requireCertified = false;
  scene.certificates.reset();
  scene.checkpointInterval.reset();
  scene.frameInterval.reset();
  scene.exactTimes = false;
  scene.probes.clear();
  scene.reactions = false;
  scene.cuts.clear();
  scene.picture = false;
  scene.energy = true;
  constexpr std::int64_t rows = 100;  // of energies
  scene.historyEvery = std::max<std::int64_t>(1, settings.steps / rows);

  Run result;
  double least = infinity;
  for (int repeat = 0; repeat < (settings.timed ? 3 : 1) && (repeat == 0 || least < quick); ++repeat) {
    const ScratchFolder folder;
    moments.clear();
    Sampler sampler(moments, scene.end / static_cast<double>(samples_), samples_);
    Body body = copyOf(start_.body);
    RunOptions options;
    options.folder = folder.path();
    options.progress = progress_;
    options.listener = &sampler;
    const RunResult done = runScene(scene, body, options);
    sampler.complete(done);
    result.steps = done.steps;
    least = std::min(least, sampler.seconds());
    if (done.reason != ExitReason::end)
      result.lost = done.reasonText;
    else if (done.energyOff())
      result.lost = fmt::format("the energy balance was off by more than {:.3g} %", 100 * scene.energyTolerance);
    else if (moments.size() != samples_)
      result.lost = "it skipped moments to compare at";
    if (!result.lost.empty()) break;
  }
  result.seconds = least;
  return result;
}

double AdvisedRuns::errorOf(const Moments& moments) const {
  if (reference_.empty()) return std::numeric_limits<double>::quiet_NaN();
  double largest = 0, error = 0;
  for (std::size_t k = 0; k < samples_; ++k) {
    largest = std::max(largest, (reference_[k] - start_.state.x).norm());
    error = std::max(error, (moments[k] - reference_[k]).norm());
  }
  return largest > 0 ? error / largest : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace ringwatch

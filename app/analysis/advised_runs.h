#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <ringwatch/app/analysis/scene_start.h>

namespace ringwatch {

/// Runs of a scene that `ringwatch advise` decides by, made as `ringwatch run` makes them, watched in mode(),
/// without files that stay. Handlers choose again where the explicit part is no longer certified; the explicit run
/// reduces its step.
class AdvisedRuns {
 public:
  struct Run {
    std::string lost;        // why, "" when it reached its end with its energy in balance
    std::int64_t steps = 0;  // taken
    double seconds = 0;      // of computing by the calling thread, steps and monitor: the least of up to three runs
    double error = 0;        // of displacements, the largest of up to 16 moments, over the largest displacement there;
                             // against explicit runs at the own step and at half of it, extrapolated
  };

  /// Over `steps` steps of h (s), or fewer that divide into the moments. own: the step of the explicit run, s. The
  /// start must outlive this. progress: a line on a terminal during each run.
  AdvisedRuns(const SceneStart& start, double h, double own, std::int64_t steps, bool progress);

  std::int64_t steps() const { return steps_; }
  double time() const { return static_cast<double>(steps_) * h_; }  // s
  /// Of the monitor: the scene's, or threshold where that proves nothing.
  std::string_view mode() const;
  /// The scene's integrator, in equal steps of at most the own one.
  const Run& explicitRun() const { return explicit_; }
  /// The scene's integrator with a handler, in steps of h.
  Run handled(const std::string& handler) const;
  /// Another integrator, which nothing watches, in steps of h.
  Run implicit(const std::string& method) const;
  /// Why errors over this time say nothing, "" when they do: the explicit runs do not agree with each other.
  const std::string& noReference() const { return noReference_; }

 private:
  using Moments = std::vector<NodeVectors>;
  struct Settings {
    std::string method, handler;
    std::int64_t steps;
    OnViolation onViolation;
    bool watched;
    bool timed;  // repeated while that is quick
  };
  Run run(const Settings& settings, Moments& moments) const;
  double errorOf(const Moments& moments) const;

  const SceneStart& start_;
  double h_;
  bool progress_;
  std::size_t samples_;
  std::int64_t steps_;
  Moments reference_;
  Run explicit_;
  std::string noReference_;
};

}  // namespace ringwatch

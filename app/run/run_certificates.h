#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>

#include <ringwatch/app/run/run_result.h>
#include <ringwatch/app/scene/scene.h>
#include <ringwatch/integrators/integrator.h>
#include <ringwatch/monitor/stability_monitor.h>

namespace ringwatch {

/// The files of monitor.certificates: folder/certificates/step_00000120.certificate is the proof at the state before
/// step 120 (docs/certificate_file.md).
class RunCertificates {
 public:
  /// Scene and body must outlive it. Throws InputError for a body that no certificate knows, where the scene wants
  /// some.
  RunCertificates(const Scene& scene, const Body& body, std::filesystem::path folder);

  /// Removes those of an earlier run from that step on.
  void begin(std::int64_t step);
  /// Writes what is due at an observation of a state. violatedBefore: a step that was taken was proven unstable. A
  /// state whose tangent is not finite has no certificate.
  void record(const MonitorReport& report, const State& state, bool violatedBefore);
  /// The state of the last observation is not that before the next one, or not of the same body.
  void forget() { before_.reset(); }
  /// Of the run, those before it was resumed included.
  std::int64_t count() const;

  template <class Archive>
  void archive(Archive& a) {
    a(before_, last_);
  }

 private:
  void write(std::int64_t step, const NodeVectors& x);

  struct Observed {
    std::int64_t step = 0;
    NodeVectors x;

    template <class Archive>
    void archive(Archive& a) {
      a(step, x);
    }
  };
  const Scene& scene_;
  const Body& body_;
  std::filesystem::path folder_;
  std::optional<Observed> before_;
  std::int64_t last_ = -1;  // step of the file that was written last
};

}  // namespace ringwatch

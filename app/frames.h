#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <ringwatch/app/scene.h>
#include <ringwatch/meshes/vtu_writer.h>
#include <ringwatch/monitor/stability_monitor.h>

namespace ringwatch {

/// What [output] fields may name: cell data of the frames.
std::vector<std::string> frameFieldNames();

/// Writes frames/frame_000001.vtu … and run.pvd, which lists them, into a folder. Every frame carries displacement (m)
/// and velocity (m/s) at nodes, and at elements what the scene asks for: critical_step, s, by the element's reduced
/// 1-ring (an upper bound of the critical step: lower ones decide); metric, s, the element's step by the scene's
/// metric, margin applied; verdict, 0 where the whole body is certified, 2 where the element's own reduced 1-ring
/// forbids the step, 1 else; handler, 1 where a handler holds the element.
class FrameWriter {
 public:
  /// rule: makes a step of an eigenvalue for the integrator and the damping of the scene.
  FrameWriter(std::filesystem::path folder, const Scene& scene, const Body& body, StepRule rule);

  /// A frame of the state, which must be finite, before a step of size h. Throws InputError when it cannot be written.
  void write(double time, const NodeVectors& x, const NodeVectors& v, double h, Verdict verdict,
             std::span<const ElementRef> handled = {});
  std::size_t count() const { return entries_.size(); }
  /// Removes frames of an earlier, longer run from the folder.
  void removeStale() const;

 private:
  bool asksFor(const char* field) const;
  std::vector<double> elementSteps(const std::string& metric, const NodeVectors& x, double factor) const;

  std::filesystem::path folder_;
  const Scene& scene_;
  const Body& body_;
  StepRule rule_;
  std::vector<PvdEntry> entries_;
};

}  // namespace ringwatch

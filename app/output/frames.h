#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <ringwatch/app/scene/scene.h>
#include <ringwatch/meshes/formats/vtu_frame.h>
#include <ringwatch/meshes/formats/vtu_writer.h>
#include <ringwatch/monitor/metrics/metrics.h>
#include <ringwatch/monitor/stability_monitor.h>
#include <ringwatch/monitor/step_limit.h>

namespace ringwatch {

/// Name of a field with the step of each element by a metric: "optimistic step by reduced-1-ring (s)". An element's
/// step is a statement about the whole body: safe, the body's critical step is at least the least of these; optimistic,
/// it is at most the least of these; an estimate may lie on either side.
std::string stepFieldName(const MetricInfo& metric, Direction direction);
/// The step of a metric's eigenvalue, s, on the side on which the metric errs.
double stepBy(Direction direction, double lambda, const StepRule& rule);
/// The step of each element by a metric, s, in the order of blocks and elements, under that name.
FrameField stepField(const MetricResult& metric, const StepRule& rule);
/// "safe", "optimistic" or "estimate": the side of the critical step on which a metric's step lies, the opposite of
/// that of its frequency.
std::string_view stepSide(Direction direction);

/// The frames that run.pvd lists in the folder of a run. Throws InputError when the file cannot be read.
std::vector<PvdEntry> framesOfRun(const std::filesystem::path& folder);

/// A body in a state.
struct BodyState {
  Body body;
  NodeVectors x;  // 3×N, m
};
/// The body of a run at one of its frames, obstacles where they are then. Elements that erosion has taken out by then
/// are left out; their mass stays at the nodes. notes: what the reader has to tell. Throws InputError as loadVtuState,
/// sceneMesh and sceneBody do, and for a frame of another mesh.
BodyState bodyOfFrame(const Scene& scene, const std::filesystem::path& folder, const PvdEntry& frame, int threads,
                      std::vector<std::string>* notes = nullptr);

/// What is known of the body at the state of a frame.
struct FrameState {
  double time = 0;                   // s
  double h = 0;                      // s, the step taken from here
  std::optional<double> safe;        // s, the largest step that the monitor has proven at its last observation
  std::optional<double> optimistic;  // s
  std::optional<Verdict> verdict;    // empty without a monitor
  std::span<const ElementRef> handled;
};

/// Where a frame goes whose nodes and elements are on several ranks.
class FramePieces {
 public:
  virtual ~FramePieces() = default;
  /// Writes the piece of this rank, and the .pvtu at `path` that lists all; as writeVtu, of the nodes and elements of
  /// the rank's body.
  virtual void write(const std::filesystem::path& path, const NodeVectors& x, std::span<const VtuField> pointFields,
                     std::span<const VtuField> cellFields, double time, std::span<const VtuField> frameFields) = 0;
  /// Whether this rank writes what there is once: run.pvd, and removes what is old.
  virtual bool writesList() const = 0;
};

/// Writes frames/frame_000001.vtu … and run.pvd, which lists them, into a folder. Every frame carries displacement (m)
/// and velocity (m/s) at nodes, the sets of the mesh, and as field data safe step (s), optimistic step (s), step (s)
/// and verdict (0 certified, 1 not certified, 2 violated, -1 unmonitored); what is not known is NaN. At elements it has
/// what the scene asks for: the step by a metric, named as stepFieldName says; metric, the same by the scene's metric
/// with its margin; verdict, 0 where the whole body is certified, 2 where the element's own reduced 1-ring forbids the
/// step, 1 else; handler, 1 where a handler holds the element; stresses and stretch, named as allStressMeasures() says;
/// and where there are several materials their number, counted from 0, as material. Points are deformed positions. On
/// ranks a frame is a frames/frame_000001.pvtu and a .vtu of each rank in frames/frame_000001.
class FrameWriter {
 public:
  /// rule: makes a step of an eigenvalue for the integrator and the damping of the scene. pieces: on ranks, of which
  /// `body` is a part; must outlive the writer.
  FrameWriter(std::filesystem::path folder, const Scene& scene, const Body& body, StepRule rule,
              FramePieces* pieces = nullptr);

  /// A frame of the positions x and velocities v (3×N), which must be finite, before a step. Throws InputError when it
  /// cannot be written.
  void write(const NodeVectors& x, const NodeVectors& v, const FrameState& state);
  std::size_t count() const { return entries_.size(); }
  /// Times of the frames so far, s.
  std::vector<double> times() const;
  /// Goes on behind frames of these times, which are there. Throws InputError where one is not.
  void goOnBehind(const std::vector<double>& times);
  /// Removes frames of an earlier, longer run from the folder.
  void removeStale() const;

 private:
  std::filesystem::path fileOf(std::size_t number) const;
  bool writesList() const { return !pieces_ || pieces_->writesList(); }
  bool asksFor(const char* field) const;
  struct Steps {
    std::string name;
    std::vector<double> values;  // s, one an element
  };
  Steps elementSteps(const std::string& metric, const NodeVectors& x, double factor);

  std::filesystem::path folder_;
  const Scene& scene_;
  const Body& body_;
  StepRule rule_;
  FramePieces* pieces_;
  std::vector<PvdEntry> entries_;
  std::map<std::string, std::unique_ptr<MetricEvaluator>> metrics_;  // asked for so far, of that version of the body
  std::int64_t bodyVersion_ = 0;
};

}  // namespace ringwatch

#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <ringwatch/app/output/exit_status.h>
#include <ringwatch/app/output/report.h>
#include <ringwatch/app/scene/body_notes.h>
#include <ringwatch/app/scene/scene.h>
#include <ringwatch/body/body.h>
#include <ringwatch/meshes/quality.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <ringwatch/monitor/bounds/range_bound.h>
#include <ringwatch/monitor/critical_step.h>
#include <ringwatch/monitor/metrics/metrics.h>

namespace ringwatch {

struct IntegratorInfo;

/// What an inspection found, for a page about it; references hold while it is made.
struct Inspection {
  std::string name;   // of the mesh file or the run
  std::string state;  // "at rest"
  const Body& body;
  const NodeVectors& x;
  const IntegratorInfo& integrator;
  StepRule rule;
  RayleighDamping damping;
  const CriticalStep& step;
  const std::vector<MetricResult>& metrics;  // that were asked for
  std::optional<double> asked;               // s, the step that was asked about
  nlohmann::ordered_json json;               // the numbers of the inspection
  std::vector<std::string> notes;
};

/// What `ringwatch inspect` is asked. What is not given comes from the scene of a run, or is a default.
struct InspectOptions {
  static constexpr std::string_view usualModel = "stvk", usualIntegrator = "symplectic-euler";
  static constexpr Lumping usualLumping = Lumping::rowSum;
  std::filesystem::path mesh;     // a mesh file, or with `frame` the folder of a run
  Options parameters;             // of the law; must be given with a mesh file
  std::optional<double> density;  // kg/m³; must be given with a mesh file
  std::optional<std::string> model;
  std::optional<std::string> integrator;
  std::optional<Lumping> lumping;
  std::optional<Units> units;
  bool repair = false;                      // the mesh is mended first
  std::optional<std::string> displacement;  // a field of a .vtu file, m: inspect that state
  std::optional<std::int64_t> frame;        // of the run, counted from 1
  std::vector<std::string> rules;           // ELEMENT=RULE: quadrature rules
  std::optional<double> step;           // s: list the elements that need a smaller one, and what a handler would take
  std::vector<std::string> metrics;     // names; "all" for every one; empty for the usual ones
  std::vector<std::string> fix;         // nodes that are held, and behind a colon which components: "x < 1e-6:xy"
  bool global = false;                  // also the exact critical step, by a global eigenvalue
  std::optional<double> width;          // of the bracket: CriticalStepOptions::width
  std::optional<double> lanczos;        // also a step that is safe but for this probability
  bool exact = false;                   // also both sides proven to within 1e-6, by a sparse factorisation
  std::optional<double> prove;          // s: whether this step is proven stable or unstable, by a sparse factorisation
  std::optional<StretchRange> stretch;  // also a step that is safe for all stretches in a range
  bool distribution = false;  // histogram and cumulative share by metric, the worst elements with their shapes
  std::optional<std::filesystem::path> picture;  // of the distribution, .svg or .png
  std::optional<std::filesystem::path> vtu;
  std::optional<std::filesystem::path> certificate;  // a proof that ringwatch-check can check
  /// The bracket in place of criticalStep(), at first, and the eigenvalue in place of globalFrequency(); metrics are
  /// reported where they are asked for then.
  std::function<CriticalStep(const Body& body, const NodeVectors& x, const StepRule& rule)> bracket;
  std::function<GlobalFrequency(const Body& body, const NodeVectors& x)> globalFrequency;
  std::function<void(const Inspection&)> page;  // told of all that was found, to make a page of it
  int threads = 0;
};

/// What came of it.
struct InspectResult {
  nlohmann::ordered_json json;  // the contract of `inspect --json`
  std::string text;             // the same, human-readable
  std::string failure;          // one line when a result could not be had, which then has no value; "" else
  ExitStatus status = ExitStatus::done;
};

/// Reads a mesh and reports on the steps it can take at rest or in a deformed state: bracket, metrics, controlling
/// element, quality at rest, named sets. Throws InputError for bad input, an integrator without a stable step included.
InspectResult inspectMesh(const InspectOptions& options);

/// What an inspection says of a mesh.
struct MeshFigures {
  std::int64_t nodes = 0;
  ElementCounts elements;
  std::map<std::string, std::int64_t> nodeSets, elementSets;  // members
  double volume = 0, mass = 0;                                // m³, kg
  BodyFigures body;
  std::vector<QualitySummary> quality;
  std::vector<std::string> notes;
};
/// What it says of an element.
struct ElementFigures {
  nlohmann::ordered_json json;  // as elementJson
  std::string text;             // as elementText
  ElementQuality quality;
};

/// A mesh at rest that no process has as a whole, with one material.
class InspectedParts {
 public:
  /// Reads it; scene: material, lumping, quadrature rules and supports.
  virtual MeshFigures read(const Scene& scene) = 0;
  /// The bracket of the critical step; after read(), as the next one.
  virtual CriticalStep bracket(const StepRule& rule) = 0;
  virtual ElementFigures element(ElementRef element) = 0;

 protected:
  ~InspectedParts() = default;
};
/// inspectMesh() of a mesh in parts: mesh figures, bracket and controlling element.
InspectResult inspectParts(const InspectOptions& options, InspectedParts& parts);

}  // namespace ringwatch

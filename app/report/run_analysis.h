#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include <ringwatch/app/analysis/distribution.h>
#include <ringwatch/app/output/elements_in_the_way.h>
#include <ringwatch/integrators/integrator.h>
#include <ringwatch/meshes/formats/vtu_frame.h>

namespace ringwatch {

struct IntegratorInfo;

/// The mesh's step by a metric, beside the bracket of the same state.
struct RuleStep {
  std::string name, help, side;  // side: safe, optimistic or estimate
  double step = 0;               // s
};

/// A handler, tried from the analysed state at a step.
struct HandlerTrial {
  std::string handler;
  std::string whyNot;  // it does not go with this body; then nothing else counts
  /// Simulated time per wall time over that of the integrator alone at the safe step, measured in a few steps; both
  /// with the monitor's time of a step, as far as that is known.
  double gain = 0;
  std::optional<double> addedMass;  // kg, of a handler that adds mass
  double addedShare = 0;            // of the body's mass
};

/// What is in the way of a step, and what it would take.
struct WhatIf {
  double h = 0;         // s
  bool proven = false;  // the step needs no handler, and no element is in its way
  ElementsInTheWay way;
  bool shapesKnown = true;           // else there were too many elements to look at their shapes
  std::string badNumbers;            // numbersText of way.badlyShaped
  std::vector<HandlerTrial> trials;  // empty: none was tried at this step
};

/// What is computed of a state when the page is written.
struct RunAnalysis {
  std::string where;                       // the state: "in frame 3, t = 0.1 s", "at rest"
  std::size_t elements = 0;                // of the mesh
  std::optional<double> safe, optimistic;  // s, of the whole body, whatever a handler did in the run
  std::optional<double> taken;             // s, the run's step from there, or the one that is asked about
  std::vector<Distribution> distributions;
  std::vector<RuleStep> rules;
  std::vector<WhatIf> whatIf;
  std::string whyNoRules, whyNoWhatIf;  // why they are empty; ""
  /// The field of steps that the elements in the way are counted by, where no handler's selection was made; "" for one.
  std::string countedBy;
  std::string whyNoHandlers;  // then: why none was made
  bool couldTakeHandler = true;
  std::string shapesAt = "at rest";  // the state whose shapes are called bad
  double monitorSeconds = 0;         // of wall time a step, that gains count; 0: they are of steps that nothing watches

  /// The row of the step taken, where that is not proven as it is; nullptr for none.
  const WhatIf* inTheWay() const;
};

/// A body in a state, and what is known of it.
struct AnalysedState {
  const Body& body;  // made of a mesh and materials
  const NodeVectors& x;
  const IntegratorInfo& integrator;
  StepRule rule;
  RayleighDamping damping;
  std::optional<double> safe, optimistic, taken;  // s
  std::string whyNoHandlers = {};                 // what the scene of the state says of that; "" for nothing
  double monitorSeconds = 0;                      // as in RunAnalysis
};

/// Elements of the largest mesh whose metrics are evaluated. They take about 30 µs an element of one thread.
inline constexpr std::size_t analysedElements = 200000;
/// Of the largest mesh whose bracket analyseRun computes from scratch, at 0.1 to 0.4 ms an element.
inline constexpr std::size_t bracketedElements = 5000;

/// The usual metrics, and for a few steps the elements in the way and what handlers would take, the latter for at most
/// 20 000 elements of a body that takes handlers; else elements are counted by the reduced 1-ring. Throws
/// NumericalError where the state has no finite tangent.
RunAnalysis analyseState(const AnalysedState& state);

/// A frame of a mesh that is too large for that.
struct AnalysedFrame {
  const VtuFrame& frame;
  std::vector<double> waveSpeeds;      // m/s, of the materials
  std::vector<int> materialOfElement;  // in the order of blocks and elements; empty: all have the first
  StepRule rule;
  std::optional<double> safe, optimistic, taken;  // s
};
/// What lengths of elements and the frame's own fields of steps tell, at about 1 µs an element.
RunAnalysis analyseFrame(const AnalysedFrame& state);

/// analyseState() of a frame of a run (its file). safe, optimistic, taken: as the frame has them; a bracket of a part
/// of the body, as with a handler, is replaced by one of the whole body. monitorSeconds: as in RunAnalysis. Throws
/// InputError and NumericalError as sceneOfRun, loadVtuState and sceneBody do.
RunAnalysis analyseRun(const std::filesystem::path& folder, const std::filesystem::path& frame,
                       std::optional<double> safe, std::optional<double> optimistic, std::optional<double> taken,
                       double monitorSeconds);
/// analyseFrame() of a frame of a run that has been read. Throws InputError as sceneOfRun does.
RunAnalysis analyseLargeRun(const std::filesystem::path& folder, const VtuFrame& frame);

}  // namespace ringwatch

#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <ringwatch/app/command/distribution.h>

namespace ringwatch {

/// The mesh's step by a metric, beside the bracket of the same state.
struct RuleStep {
  std::string name, help, side;  // side: safe, optimistic or estimate
  double step = 0;               // s
};

/// What a handler would take at a step.
struct WhatIf {
  double h = 0;              // s
  std::size_t elements = 0;  // that a certified selection chooses
  bool proven = false;       // the step needs no handler
};

/// What is computed of the first frame of a run when the page is written.
struct RunAnalysis {
  double time = 0;                         // s, of the state
  std::size_t elements = 0;                // of the mesh
  std::optional<double> safe, optimistic;  // s, of the whole body, whatever a handler did in the run
  std::optional<double> taken;             // s, the run's step from there
  std::vector<Distribution> distributions;
  std::vector<RuleStep> rules;
  std::vector<WhatIf> whatIf;
  std::string whyNoRules, whyNoWhatIf;  // why they are empty; ""
};

/// Elements of the largest mesh that analyseRun takes. Its metrics take about 30 µs an element of one thread.
inline constexpr std::size_t analysedElements = 200000;
/// Of the largest mesh whose bracket it computes from scratch, at 0.1 to 0.4 ms an element.
inline constexpr std::size_t bracketedElements = 5000;

/// Reads the first frame of a run (its file) and evaluates the usual metrics, and for a few steps the elements that a
/// handler would take, the latter for at most 20 000 elements. safe, optimistic, taken: as the frame has them; a
/// bracket of a part of the body, as with a handler, is replaced by one of the whole body. Throws InputError and
/// NumericalError as sceneOfRun, loadVtuState and sceneBody do.
RunAnalysis analyseRun(const std::filesystem::path& folder, const std::filesystem::path& frame,
                       std::optional<double> safe, std::optional<double> optimistic, std::optional<double> taken);

}  // namespace ringwatch

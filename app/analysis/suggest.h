#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <ringwatch/monitor/bounds/range_bound.h>

namespace ringwatch {

/// What `ringwatch suggest` is asked.
struct SuggestOptions {
  std::filesystem::path scene;
  std::vector<std::string> overrides;   // section.key=value
  std::optional<double> frame;          // s between two pictures; empty: the step of the scene
  std::optional<StretchRange> stretch;  // also for all states whose stretches lie there
  int threads = 0;
};
struct SuggestResult {
  nlohmann::ordered_json json;  // the contract of `suggest --json`
  std::string text;             // the same, human-readable
};

/// The numbers of equal steps that a scene needs in a time: for the tangent at its start, by the bracket, and for all
/// stretches in a range, by Theorem 48, docs/theory/tangent_drift.md. Throws InputError for bad input, and for an
/// integrator without a stable step.
SuggestResult suggestSteps(const SuggestOptions& options);

}  // namespace ringwatch

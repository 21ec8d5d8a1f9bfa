#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace ringwatch {

/// What `ringwatch scale-mass` is asked.
struct ScaleMassOptions {
  std::filesystem::path scene;
  std::vector<std::string> overrides;  // section.key=value
  double step = 0;                     // s, wanted
  int threads = 0;
};
struct ScaleMassResult {
  nlohmann::ordered_json json;  // the contract of `scale-mass --json`
  std::string text;             // the same, human-readable
};

/// How little added mass a scene needs for a step to be proven stable as it starts, by part and in all, and what that
/// does to its lowest frequencies; beside what the usual formula by element adds. Throws InputError for bad input, and
/// for an integrator without a stable step.
ScaleMassResult planMass(const ScaleMassOptions& options);

}  // namespace ringwatch

#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace ringwatch {

/// What `ringwatch advise` is asked.
struct AdviseOptions {
  std::filesystem::path scene;
  std::vector<std::string> overrides;  // section.key=value
  std::optional<double> step;          // s; empty: the scene's
  std::optional<double> time;          // s of each trial; empty: adviseSteps steps
  std::int64_t runSteps = 2000;        // of the runs of those that a trial leaves, at most; 0: no runs
  double error = 0.01;                 // allowed of trials and runs, of the displacement
  int threads = 0;
  bool progress = true;  // a progress line on a terminal
};
/// Steps of a trial unless its time is given.
inline constexpr int adviseSteps = 40;

struct AdviseResult {
  nlohmann::ordered_json json;  // the contract of `advise --json`
  std::string text;             // the same, human-readable
};

/// What a scene can do to take a step that is larger than its safe one: the elements in the way, what each handler and
/// implicit integrator costs and errs by in a short trial against a converged motion, the mass that would be added,
/// what becomes of those that are worth it in a run of the scene, and the step that the mesh would allow without its
/// badly shaped elements. It says no more than what was tried and run says. Throws InputError for bad input and for
/// scenes that it does not take (requireTaken).
AdviseResult adviseScene(const AdviseOptions& options);

}  // namespace ringwatch

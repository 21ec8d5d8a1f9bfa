#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <ringwatch/verify/work_precision/work_precision.h>

namespace ringwatch {

/// What `ringwatch compare` is asked.
struct CompareOptions {
  std::filesystem::path scene;
  std::vector<std::string> overrides;           // section.key=value
  std::vector<std::string> integrators{"all"};  // names, or "all"
  std::vector<std::string> handlers;            // names, or "all"; with the options of the scene's [handler]
  std::vector<double> steps;                    // s; empty: a range for each integrator
  int threads = 1;                              // 0: as many as the mesh keeps busy
  bool progress = true;
};

struct CompareResult {
  nlohmann::ordered_json json;
  StudyReport report;              // tables and figures
  std::string text;                // human-readable: which is cheapest
  std::vector<std::string> found;  // the same, one sentence each
};

/// Runs a scene's motion with several integrators, and several handlers on verlet, over several steps against a
/// converged reference. The monitor of the scene takes no part. Throws InputError for bad input, NumericalError when
/// there is no converged reference.
CompareResult compareScene(const CompareOptions& options);

/// { title, end, reference_error, runs: [ … ], cheapest: { "1 %": { by_time, seconds, h, by_forces, forces }, … } };
/// null where nothing reaches the error.
nlohmann::ordered_json workPrecisionJson(const WorkPrecisionCase& c, const std::vector<WorkPrecisionRun>& runs);

}  // namespace ringwatch

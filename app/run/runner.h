#pragma once
#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <ringwatch/app/run/run_result.h>
#include <ringwatch/app/scene/scene.h>

namespace ringwatch {

struct Checkpoint;
class RunListener;

struct RunOptions {
  std::filesystem::path folder;                  // made when it does not exist
  bool progress = true;                          // a progress line on a terminal
  const std::atomic<bool>* interrupt = nullptr;  // the run ends after the step in which it becomes true
  std::atomic<bool>* checkpoint = nullptr;       // the run writes one after the step in which it becomes true
  std::vector<std::string> notes;                // of the mesh reader, for the summary
  const Checkpoint* resume = nullptr;            // the run goes on from there, in the folder of the checkpoint
  nlohmann::ordered_json provenance = nullptr;   // for the summary: where the run comes from
  RunListener* listener = nullptr;               // told of the run before each of its steps
};

/// Runs a scene on its body, to which a handler may add mass and which cuts replace: before each step the monitor
/// observes at the state, then the integrator takes the step. Writes history.csv, summary.json, what [output] asks for
/// and the picture into options.folder, however the run ends; only then does it give up the folder. Throws InputError
/// when the folder cannot be written or another run is writing into it, before anything is computed, and RunFailed when
/// not even the summary can be written.
RunResult runScene(const Scene& scene, Body& body, const RunOptions& options);

}  // namespace ringwatch

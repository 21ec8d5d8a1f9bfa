#pragma once
#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <ringwatch/app/run/run_result.h>
#include <ringwatch/app/run/timed_loads.h>
#include <ringwatch/app/scene/scene.h>

namespace ringwatch {

struct Checkpoint;
class FramePieces;
class RunListener;

/// What a run takes from elsewhere whose body is a part of a larger one (body/domain.h).
struct RunOfPart {
  std::string process;                 // its name, for a fault of its own
  Body* whole = nullptr;               // on the first process, which names elements by it
  nlohmann::ordered_json ofWhole;      // summaryJson() of it before the run
  State begin;                         // the state in which a run begins that is not resumed
  std::optional<TimedLoads> loads;     // of the part
  std::unique_ptr<Handler> handler;    // of the whole, which has chosen; nullptr without one
  const Body* explicitPart = nullptr;  // the part of its explicit elements, as of Handler::prepareAsPart()
  FramePieces* pieces = nullptr;       // of the frames
  std::function<RunResult::Traffic(std::int64_t steps)> sent;  // by a run of so many steps; collective
};

struct RunOptions {
  std::filesystem::path folder;                  // made when it does not exist
  bool progress = true;                          // a progress line on a terminal
  const std::atomic<bool>* interrupt = nullptr;  // the run ends after the step in which it becomes true
  std::atomic<bool>* checkpoint = nullptr;       // the run writes one after the step in which it becomes true
  std::vector<std::string> notes;                // of the mesh reader, for the summary
  const Checkpoint* resume = nullptr;            // the run goes on from there, in the folder of the checkpoint
  nlohmann::ordered_json provenance = nullptr;   // for the summary: where the run comes from
  RunListener* listener = nullptr;               // told of the run before each of its steps
  RunOfPart* part = nullptr;                     // where the body is one
};

/// Runs a scene on its body, to which a handler may add mass and which cuts replace: before each step the monitor
/// observes at the state, then the integrator takes the step. Writes history.csv, summary.json, what [output] asks for
/// and the picture into options.folder, however the run ends; only then does it give up the folder. Throws InputError
/// when the folder cannot be written or another run is writing into it, before anything is computed, and RunFailed when
/// not even the summary can be written.
RunResult runScene(const Scene& scene, Body& body, const RunOptions& options);

}  // namespace ringwatch

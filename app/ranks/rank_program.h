#pragma once
#include <atomic>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <ringwatch/app/output/exit_status.h>

namespace ringwatch {

/// What `ringwatch run` asks of a program of several processes.
struct RankRunRequest {
  std::filesystem::path scene;         // may be empty with `resumed`
  std::vector<std::string> overrides;  // as of readScene
  std::filesystem::path folder;        // for the results
  std::filesystem::path resumed;       // folder of a run to go on with; empty for none
  std::string command;                 // for the provenance
  int threads = 0;                     // of each process; 0: as many as there is room for
  bool quiet = false;
  const std::atomic<bool>* interrupt;  // the run ends after the step in which it becomes true, on any process
  std::atomic<bool>* checkpoint;       // the run writes one after the step in which it becomes true
};

struct InspectOptions;
struct InspectResult;

/// The processes of a program that share a run.
class RankProgram {
 public:
  virtual ~RankProgram() = default;
  /// Whether this process says what all have to say.
  virtual bool speaks() const = 0;
  /// Runs a scene, and prints what came of it; every process returns the same. print: to standard output, called by one
  /// process. Throws InputError or NumericalError on the process that speaks where the run cannot begin, and the others
  /// return its status. A fault of one process later ends all of them.
  virtual ExitStatus run(const RankRunRequest& request, const std::function<void(const std::string&)>& print) const = 0;
  /// inspectMesh() with a bracket that the processes find together; every process gets the same. Throws as run() does,
  /// and InputError for an option that one process alone can do.
  virtual InspectResult inspect(const InspectOptions& options) const = 0;
};

}  // namespace ringwatch

#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <ringwatch/app/command/exit_status.h>
#include <ringwatch/base/options.h>

namespace ringwatch {

/// What `ringwatch audit` is asked.
struct AuditOptions {
  std::vector<std::filesystem::path> results;  // .frd, .pvd, or .vtu and .vtk files in their order
  std::filesystem::path scene;                 // a scene or a deck with the materials and supports; "" for none
  std::string model;                           // the law, instead of the scene's; "" for it, else "stvk"
  Options parameters;                          // of the law; must be given without a scene
  std::optional<double> density;               // kg/m³; likewise
  std::string displacement;                    // name of the field; "" for the usual ones
  std::optional<double> step;                  // s, that they took; empty: by the increments of the results
  std::optional<double> limit;                 // h omega of their integrator
  std::string integrator;                      // one of ours with that limit; "" for symplectic-euler
  std::vector<std::string> fix;                // nodes that are held, as inspect's
  int every = 1;                               // every so many states
  bool all = false;                            // a line of the table for every state
  int threads = 0;
};

struct AuditResult {
  nlohmann::ordered_json json;
  std::string text;
  ExitStatus status = ExitStatus::done;
};

/// The bracket of every state that another program has left, against the step that it took: where its run left proven
/// ground. Throws InputError for bad input.
AuditResult auditResults(const AuditOptions& options);

}  // namespace ringwatch

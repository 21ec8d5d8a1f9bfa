#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <ringwatch/body/body.h>

namespace ringwatch {

/// What `ringwatch inspect` is asked.
struct InspectOptions {
  std::filesystem::path mesh;
  double young = 0, poisson = 0, density = 0;  // Pa, -, kg/m³
  std::string model = "stvk";
  std::string integrator = "symplectic-euler";
  Lumping lumping = Lumping::rowSum;
  std::optional<double> step;        // s: list the elements that need a smaller one
  std::vector<std::string> metrics;  // names; "all" for every one; empty for the usual ones
  std::vector<std::string> fix;      // conditions on nodes that are held
  bool global = false;               // also the exact critical step, by a global eigenvalue
  std::optional<double> lanczos;     // also a step that is safe but for this probability
  bool distribution = false;         // histogram and cumulative share by metric, the worst elements with their shapes
  std::optional<std::filesystem::path> picture;  // of the distribution, .svg or .png
  std::optional<std::filesystem::path> vtu;
  int threads = 0;
};

/// What came of it.
struct InspectResult {
  nlohmann::ordered_json json;  // the contract of `inspect --json`
  std::string text;             // the same for people
  std::string failure;          // one line when a result could not be had, which then has no value; "" else
};

/// Reads a mesh and reports on the steps it can take at rest: bracket, metrics, controlling element, quality. Throws
/// InputError for bad input, an integrator without a stable step included.
InspectResult inspectMesh(const InspectOptions& options);

}  // namespace ringwatch

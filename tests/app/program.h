#pragma once
#include <iosfwd>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <ringwatch/meshes/mesh_io.h>
#include <tests/support/temporary_folder.h>

namespace nlohmann {
/// How GoogleTest prints what it compares: compiled once.
void PrintTo(const json& value, std::ostream* out);
}  // namespace nlohmann

/// The program called from outside, as its users call it.
namespace ringwatch::test {

using Json = nlohmann::json;

struct Outcome {
  int status;
  std::string out, err;
};

/// A number with all its digits, for an argument.
std::string digits(double value);

/// As a shell has it: 128 and the signal where there was one.
int statusOf(int waited);

class Program : public ::testing::Test {
 protected:
  /// A line for the shell, in the test's folder.
  Outcome shell(const std::string& line);
  /// Calls the program in the test's folder; arguments as a shell reads them. Expects that what it writes as JSON and
  /// the scene that it runs are valid against its schemas, that a scene which it refuses for a key is not, and that its
  /// text ends with the conclusion of its JSON.
  Outcome call(const std::string& arguments, const std::string& environment = "");
  /// The executable that is called.
  virtual std::string executable() const;
  static constexpr const char *hasCheckpoint = "[ -e part/checkpoint.bin ]",
                              *hasTenRows = "[ $(wc -l < part/history.csv) -gt 10 ]";
  /// A run of scene.toml into the folder part that the signal (TERM, KILL) reached once `ready`, a condition of the
  /// shell, held. One that ended before, as on a loaded machine, is run again. Rows are in the file four times a
  /// second.
  Outcome stopRun(const std::string& options, const std::string& ready, const std::string& signal);
  void expectRefused(const Outcome& outcome, const std::string& what);
  void expectRefused(const std::string& arguments, const std::string& what) {
    SCOPED_TRACE(arguments);
    expectRefused(call(arguments), what);
  }
  /// Runs a scene into a folder, expects the status, and keeps the run's history and summary.
  Outcome runScene(const std::string& scene, const std::string& options = "", int status = 0,
                   const std::string& folder = "r");
  /// Expects that a scene is refused, and that nothing was written.
  void refuseScene(const std::string& scene, const std::string& what, const std::string& options = "");
  /// Expects the same history of a scene for one thread and for three.
  void expectSameForAnyThreads(const std::string& scene, const std::string& options = "");
  /// Kills the run of a scene and resumes it, each time later, until it ends; expects the history and the summary of
  /// the run that was not killed, which are kept.
  void expectSameWhenKilled(const std::string& scene, const std::string& options);
  /// The mesh at rest and the positions (m) in the last frame of the run that is kept.
  MeshState lastFrame() const;
  bool exists(const std::string& name) const;
  Json json(const std::string& name) const { return parse(folder_.read(name)); }
  static Json parse(const std::string& text);

  struct Table {
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;
    std::string at(std::size_t row, const std::string& column) const;
    double number(std::size_t row, const std::string& column) const { return std::stod(at(row, column)); }
    double last(const std::string& column) const { return number(rows.size() - 1, column); }
    /// The largest absolute value of a column.
    double largest(const std::string& column) const;
  };
  Table table(const std::string& name) const;
  /// No file that was left half written, nor a temporary one.
  void expectNothingHalfWritten(const std::string& name) const;

  TemporaryFolder folder_;
  Table history_;
  Json summary_;

 private:
  void expectValid(const std::string& arguments, const Outcome& outcome) const;
  std::string schemaFault(const std::string& schema, const Json& document) const;
};

inline constexpr const char* tiny = R"([mesh]
generate = "bar"
size = [0.1, 0.02, 0.02]
cells = [5, 1, 1]
[material]
model = "stvk"
young = 30e3
poisson = 0.3
density = 1000
[integrator]
step = 1e-3
end = 0.05
[[fix]]
where = "x < 1e-6"
[[move]]
where = "x > 0.1 - 1e-6"
velocity = [0.05, 0, 0]
[output]
every = 1e-2
fields = ["critical_step", "verdict", "handler"]
)";
inline constexpr const char* material = " --young 30e3 --poisson 0.3 --density 1000 ";

}  // namespace ringwatch::test

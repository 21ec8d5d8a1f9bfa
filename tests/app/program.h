#pragma once
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "temporary_folder.h"

/// The program called from outside, as its users call it.
namespace ringwatch::test {

using Json = nlohmann::json;

struct Outcome {
  int status;
  std::string out, err;
};

/// As a shell has it: 128 and the signal where there was one.
inline int statusOf(int waited) { return WIFEXITED(waited) ? WEXITSTATUS(waited) : 128 + WTERMSIG(waited); }

class Program : public ::testing::Test {
 protected:
  /// A line for the shell, in the test's folder.
  Outcome shell(const std::string& line) {
    const std::string command = "cd '" + folder_.path().string() + "' && { " + line + "; } > out.txt 2> err.txt";
    const int status = std::system(command.c_str());
    return {statusOf(status), folder_.read("out.txt"), folder_.read("err.txt")};
  }
  /// Calls the program in the test's folder; arguments as a shell reads them.
  Outcome call(const std::string& arguments, const std::string& environment = "") {
    return shell(environment + " '" RINGWATCH_PROGRAM "' " + arguments);
  }
  void expectRefused(const Outcome& outcome, const std::string& what) {
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(outcome.err, ::testing::AllOf(::testing::StartsWith("ringwatch: "), ::testing::HasSubstr(what),
                                              ::testing::EndsWith("\n")));
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
  void expectRefused(const std::string& arguments, const std::string& what) {
    SCOPED_TRACE(arguments);
    expectRefused(call(arguments), what);
  }
  bool exists(const std::string& name) const { return std::filesystem::exists(folder_.path() / name); }
  Json json(const std::string& name) const { return Json::parse(folder_.read(name)); }

  struct Table {
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;
    std::string at(std::size_t row, const std::string& column) const {
      return rows.at(row).at(
          static_cast<std::size_t>(std::find(columns.begin(), columns.end(), column) - columns.begin()));
    }
    double number(std::size_t row, const std::string& column) const { return std::stod(at(row, column)); }
  };
  Table table(const std::string& name) const {
    std::istringstream lines(folder_.read(name));
    Table result;
    for (std::string line; std::getline(lines, line);) {
      std::vector<std::string> cells;
      std::istringstream text(line + ",");
      for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
      if (result.columns.empty())
        result.columns = cells;
      else
        result.rows.push_back(cells);
    }
    return result;
  }
  /// No file that was left half written, nor a temporary one.
  void expectNothingHalfWritten(const std::string& name) const {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_.path() / name))
      EXPECT_EQ(entry.path().filename().string().find(".part"), std::string::npos) << entry.path();
  }

  TemporaryFolder folder_;
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

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include <unistd.h>

#include <ringwatch/app/command/command_line.h>
#include <ringwatch/app/command/launch.h>
#include <ringwatch/app/command/process.h>
#include <ringwatch/app/command/verify.h>
#include <ringwatch/app/output/exit_status.h>
#include <ringwatch/app/report/run_report.h>
#include <ringwatch/extensions/extensions.h>

namespace ringwatch {

// Most users never build the studies, which take the compiler long: they are a program of their own,
// `ringwatch-verify`. So is what writes pages, `ringwatch-report`, and what shares a run among processes,
// `ringwatch-ranks`: this program knows nothing of MPI.
std::span<const StudyInfo> allStudies() { return {}; }
JudgeFunction judgeOfStudies() { return nullptr; }
const ReportWriters* reportWriters() { return nullptr; }

namespace {

/// The program that does what the arguments ask for, "" for this one.
std::string_view programFor(int argc, char** argv) {
  if (runsOnRanks(argc, argv)) return "ringwatch-ranks";
  const auto word = [&](int i) { return i < argc ? std::string_view(argv[i]) : std::string_view(); };
  if (word(1) == "verify" || word(1) == "judge" || word(1) == "reference" ||
      (word(1) == "help" && (word(2) == "verify" || word(2) == "studies")))
    return "ringwatch-verify";
  // Options that ask for a page, as --report FILE or --report=FILE.
  const bool reports = std::any_of(argv + std::min(argc, 2), argv + argc, [](std::string_view argument) {
    return argument == "--report" || argument.starts_with("--report=") || argument == "--live";
  });
  return word(1) == "report" || (reports && word(1) != "help") ? "ringwatch-report" : "";
}

/// Becomes a program that lies beside this one; returns only when there is none.
int become(std::string_view name, char** argv) {
  std::error_code fault;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", fault);
  const std::filesystem::path program = self.parent_path() / name;
  execv(program.c_str(), argv);
  const int reason = errno;
  if (name == "ringwatch-ranks") {
    const std::optional<Launch> launch = launchOf([](const char* variable) { return std::getenv(variable); });
    if (!launch || launch->rank == 0)
      std::fprintf(
          stderr,
          "ringwatch: run: started as %d processes, which share a run where ringwatch is built with "
          "-DRINGWATCH_WITH_MPI=ON; cannot start %s: %s; start one process, or give --ranks no where each is to "
          "run alone\n",
          launch ? launch->size : 1, program.c_str(), std::strerror(reason));
    return static_cast<int>(ExitStatus::badInput);
  }
  const char* what = name == "ringwatch-verify" ? "the studies are" : "the report is";
  const char* target = name == "ringwatch-verify" ? "ringwatch_verify_app" : "ringwatch_report_app";
  std::fprintf(stderr, "ringwatch: cannot start %s: %s; %s a program of its own, the build target %s\n",
               program.c_str(), std::strerror(reason), what, target);
  return static_cast<int>(ExitStatus::badInput);
}

}  // namespace
}  // namespace ringwatch

int main(int argc, char** argv) {
  ringwatch::keepMemoryInReserve();
  if (const std::string_view program = ringwatch::programFor(argc, argv); !program.empty())
    return ringwatch::become(program, argv);
  ringwatch::registerExtensions();
  return ringwatch::runCommandLine(argc, argv);
}

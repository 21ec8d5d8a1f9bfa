#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <string_view>
#include <system_error>

#include <unistd.h>

#include <ringwatch/app/command/command_line.h>
#include <ringwatch/app/command/exit_status.h>
#include <ringwatch/app/command/verify.h>

namespace ringwatch {

// Most users never build the studies, which take the compiler long: they are a program of their own,
// `ringwatch-verify`.
std::span<const StudyInfo> allStudies() { return {}; }

namespace {

bool isAboutStudies(int argc, char** argv) {
  const auto word = [&](int i) { return i < argc ? std::string_view(argv[i]) : std::string_view(); };
  return word(1) == "verify" || (word(1) == "help" && (word(2) == "verify" || word(2) == "studies"));
}

/// Becomes the program with the studies; returns only when there is none.
int runStudyProgram(char** argv) {
  std::error_code fault;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", fault);
  const std::filesystem::path program = self.parent_path() / "ringwatch-verify";
  execv(program.c_str(), argv);
  std::fprintf(stderr,
               "ringwatch: cannot start %s: %s; the studies are a program of its own, the build target "
               "ringwatch_verify_app\n",
               program.c_str(), std::strerror(errno));
  return static_cast<int>(ExitStatus::badInput);
}

}  // namespace
}  // namespace ringwatch

int main(int argc, char** argv) {
  if (ringwatch::isAboutStudies(argc, argv)) return ringwatch::runStudyProgram(argv);
  return ringwatch::runCommandLine(argc, argv);
}

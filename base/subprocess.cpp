#include <ringwatch/base/subprocess.h>

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <optional>

#include <ringwatch/base/leftovers.h>

extern char** environ;

namespace ringwatch {

ProgramResult runProgram(const std::vector<std::string>& command, const std::filesystem::path& folder,
                         const std::filesystem::path& standardOutput) {
  constexpr std::size_t kept = 4000;
  ProgramResult result;
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) return {false, 0, {}, 0};

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  constexpr int newFile = O_WRONLY | O_CREAT | O_TRUNC, ownersAlone = 0600;
  if (standardOutput.empty())
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  else
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, standardOutput.c_str(), newFile, ownersAlone);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  std::vector<char*> arguments;
  for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  pid_t child = 0;
  const int error = ::posix_spawnp(&child, arguments.front(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);

  if (error == 0) {
    std::optional<LeftoverProgram> running(child);
    char buffer[1024];
    for (;;) {
      const ssize_t count = ::read(ends[0], buffer, sizeof buffer);
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) break;
      if (result.output.size() < kept) result.output.append(buffer, count);
    }
    int status = 0;
    rusage used{};
    // Once it is waited for another program may have its process.
    siginfo_t ended{};
    while (::waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOWAIT) < 0 && errno == EINTR) {
    }
    running.reset();
    while (::wait4(child, &status, 0, &used) < 0 && errno == EINTR) {
    }
    const auto seconds = [](const timeval& t) {
      return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    result.seconds = seconds(used.ru_utime) + seconds(used.ru_stime);
    result.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  } else {
    result.found = false;
  }
  ::close(ends[0]);
  return result;
}

}  // namespace ringwatch

#include <unistd.h>

#include <cstdio>
#include <cstdlib>

#include <mpi.h>

#include <ringwatch/app/command/command_line.h>
#include <ringwatch/app/command/launch.h>
#include <ringwatch/app/command/verify.h>
#include <ringwatch/app/ranks/rank_inspect.h>
#include <ringwatch/app/ranks/rank_program.h>
#include <ringwatch/app/ranks/rank_run.h>
#include <ringwatch/app/report/run_report.h>
#include <ringwatch/extensions/extensions.h>

namespace ringwatch {

std::span<const StudyInfo> allStudies() { return {}; }
JudgeFunction judgeOfStudies() { return nullptr; }
const ReportWriters* reportWriters() { return nullptr; }

namespace {

class MpiProgram final : public RankProgram {
 public:
  explicit MpiProgram(Ranks& ranks) : ranks_(ranks) {}
  bool speaks() const override { return ranks_.rank() == 0; }
  ExitStatus run(const RankRunRequest& request, const std::function<void(const std::string&)>& print) const override {
    return runSceneOnRanks(ranks_, request, print);
  }
  InspectResult inspect(const InspectOptions& options) const override { return inspectOnRanks(ranks_, options); }

 private:
  Ranks& ranks_;
};

/// What only the processes of one MPI can do: where the launcher is of another MPI, each process is alone.
bool isOneProgram(int size) {
  const std::optional<Launch> launch = launchOf([](const char* variable) { return std::getenv(variable); });
  if (!launch || launch->size == size) return true;
  if (launch->rank == 0)
    std::fprintf(
        stderr,
        "ringwatch: run: the launcher has started %d processes, but MPI knows of %d; use the launcher of the MPI "
        "that ringwatch was built with, or --ranks no\n",
        launch->size, size);
  return false;
}

/// A process that is not to speak: what it would say another one does.
void beSilent() {
  if (!std::freopen("/dev/null", "w", stdout) || ::dup2(::fileno(stdout), STDOUT_FILENO) < 0) std::abort();
}

int runProgram(int argc, char** argv) {
  Ranks ranks(MPI_COMM_WORLD);
  if (!isOneProgram(ranks.size())) return static_cast<int>(ExitStatus::badInput);
  if (ranks.rank() != 0) beSilent();
  registerExtensions();
  const MpiProgram program(ranks);
  return runCommandLine(argc, argv, &program);
}

}  // namespace
}  // namespace ringwatch

/// `ringwatch run` on the processes of an MPI launcher: takes the same arguments.
int main(int argc, char** argv) {
  // The command may run on a thread of its own, with a larger stack; one at a time calls MPI.
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_SERIALIZED, &provided);
  const int status = ringwatch::runProgram(argc, argv);
  MPI_Finalize();
  return status;
}

#pragma once
#include <functional>
#include <optional>
#include <string>

namespace ringwatch {

/// What a launcher of MPI programs says to each process that it starts.
struct Launch {
  int rank = 0, size = 1;
};

/// Read from the environment (variable: its value, nullptr without it): that of Open MPI's mpirun, of Hydra (MPICH,
/// Intel MPI) and of Slurm's srun with PMI2 or PMIx. Empty where none of them started this process.
std::optional<Launch> launchOf(const std::function<const char*(const char* variable)>& environment);

/// Values of --ranks.
enum class RanksWanted {
  automatic,  ///< where a launcher has started several processes
  yes,
  no
};
/// What the arguments of a command say; automatic where they say nothing, or nothing that is known.
RanksWanted ranksWantedBy(int argc, char** argv);
/// Whether `ringwatch run` or `ringwatch inspect` with these arguments is shared among processes.
bool runsOnRanks(int argc, char** argv);

}  // namespace ringwatch

#pragma once
#include <functional>
#include <string>

#include <ringwatch/app/ranks/rank_program.h>
#include <ringwatch/distributed/ranks.h>

namespace ringwatch {

/// Runs a scene on ranks, as runScene does on one process: positions are the same to the last bit where the steps are,
/// and all that is written is the same for any number of ranks and threads (Theorems 78 to 81 and 84,
/// docs/theory/distribution.md). Every rank returns the same. As RankProgram::run. Collective.
ExitStatus runSceneOnRanks(Ranks& ranks, const RankRunRequest& request,
                           const std::function<void(const std::string&)>& print);

}  // namespace ringwatch

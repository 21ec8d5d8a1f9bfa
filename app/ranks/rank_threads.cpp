#include <ringwatch/app/ranks/rank_threads.h>

#include <omp.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

#include <ringwatch/app/scene/scene_state.h>

namespace ringwatch {

int threadsOfRank(const Ranks& ranks, int requested, const Mesh& mesh) {
  int most = omp_get_max_threads();
  const bool told = std::getenv("OMP_NUM_THREADS") != nullptr || omp_get_num_procs() < ::sysconf(_SC_NPROCESSORS_ONLN);
  if (!told) most = std::max(1, most / ranks.onThisMachine());
  return requested > 0 ? requested : std::min(most, threadsThatPay(0, mesh));
}

}  // namespace ringwatch

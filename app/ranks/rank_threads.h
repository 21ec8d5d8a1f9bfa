#pragma once
#include <ringwatch/distributed/ranks.h>
#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// Threads of a rank, of a mesh that the ranks share: those that are free where ranks share a machine. A launcher that
/// binds its processes, and OMP_NUM_THREADS, have said it already. requested: 0 for as many as pay.
int threadsOfRank(const Ranks& ranks, int requested, const Mesh& mesh);

}  // namespace ringwatch

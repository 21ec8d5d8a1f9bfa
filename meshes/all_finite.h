#pragma once
#include <ringwatch/base/parallel.h>
#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// Whether every component of the node vectors (3×N) is finite. threads: 0 for all that OpenMP offers.
inline bool allFinite(NodeVectorsView vectors, int threads) {
  return parallelSum(vectors.cols(), threads, [&](Eigen::Index begin, Eigen::Index end) {
           // In a row, which the compiler puts in packs as it does not columns of three.
           const Eigen::Map<const Eigen::VectorXd> part(vectors.data() + 3 * begin, 3 * (end - begin));
           return (part - part).sum();  // else not a number, in fewer instructions than tests one by one
         }) == 0;
}

}  // namespace ringwatch

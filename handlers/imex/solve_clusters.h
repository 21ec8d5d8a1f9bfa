#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <ringwatch/base/error.h>
#include <ringwatch/base/parallel.h>
#include <ringwatch/handlers/angular_momentum.h>
#include <ringwatch/handlers/imex/implicit_cluster.h>
#include <ringwatch/handlers/imex/newton_cluster.h>

namespace ringwatch {

/// Whether a cluster is solved by all threads, or beside others by one.
inline bool takesAllThreads(const NewtonCluster& cluster) { return cluster.threads() != 1; }
inline bool takesAllThreads(const ImplicitCluster&) { return false; }

/// A cluster of a list whose equations could not be solved.
struct ClusterFault {
  std::size_t cluster;
  std::string_view reason;

  /// first: the first element of the cluster, which has so many.
  std::string text(std::size_t elements, ElementRef first) const {
    return joinText(reason, " in the cluster of ", elements, " elements at element ", first.block, ":", first.element);
  }
};

/// Solves the equations of all clusters of handled elements of a body, large ones by all threads, the others side by
/// side: solve(k) puts the accelerations of cluster k at positions x and velocities v (3×N, m and m/s) into a (m/s²),
/// where those by all other forces stand, and tells what went wrong, "" for nothing. freeOfTorque: by cluster, whether
/// angular momentum is kept in steps of h (s). reasons: scratch. Returns the first cluster that failed.
template <class Cluster, class Solve>
std::optional<ClusterFault> solveClusters(const Body& body, const std::vector<Cluster>& clusters,
                                          const std::vector<bool>& freeOfTorque, const NodeVectors& x,
                                          const NodeVectors& v, double h, NodeVectors& a,
                                          std::vector<std::string_view>& reasons, const Solve& solve) {
  reasons.assign(clusters.size(), {});
  const auto visit = [&](std::size_t k) {
    if (!freeOfTorque[k]) {
      reasons[k] = solve(k);
      return;
    }
    const auto& nodes = clusters[k].nodes();
    const NodeVectors before = a(Eigen::all, nodes);
    reasons[k] = solve(k);
    if (reasons[k].empty()) keepAngularMomentum(body, nodes, x, v, h, before, a);
  };
  for (std::size_t k = 0; k < clusters.size(); ++k)
    if (takesAllThreads(clusters[k])) visit(k);
  parallelFor(0, clusters.size(), body.threads(), [&](std::int64_t k) {
    if (!takesAllThreads(clusters[static_cast<std::size_t>(k)])) visit(static_cast<std::size_t>(k));
  });
  for (std::size_t k = 0; k < clusters.size(); ++k)
    if (!reasons[k].empty()) return ClusterFault{k, reasons[k]};
  return std::nullopt;
}

}  // namespace ringwatch

#pragma once
#include <ringwatch/distributed/rank_body.h>
#include <ringwatch/distributed/ranks.h>
#include <ringwatch/monitor/energy_balance.h>

namespace ringwatch {

/// Energies of a whole body, J. Sums over nodes and elements are exact (ExactSum), so that they have the same bits for
/// any number of ranks and any partition; Body::energy and EnergyBalance round theirs differently.
struct RankEnergies {
  double kinetic = 0, strain = 0;
};

/// At positions x and velocities v of the rank's nodes (3×N, m and m/s), x with ghosts as their owners have them.
/// Collective: all ranks get the same.
RankEnergies energiesOf(Ranks& ranks, const RankBody& part, NodeVectorsView x, NodeVectorsView v);

/// EnergyBalance for the ranks: works are summed along the run at each owned node by itself, and over nodes exactly
/// (Theorem 84, docs/theory/distribution.md).
class RankEnergyBalance {
 public:
  /// moving: motion is prescribed at some time of the run. Both must outlive the balance.
  RankEnergyBalance(Ranks& ranks, const RankBody& part, bool moving);

  /// As EnergyBalance::record, of the rank's nodes. Not collective.
  void record(const NodeVectors& x, const NodeVectors& internalForce);
  /// As EnergyBalance::recordDamping. Not collective.
  void recordDamping(double time, const NodeVectors& v, const NodeVectors& dampingForce);
  /// Work, J, at an owned node, that record() does not know of.
  void addWork(std::int32_t node, double work) { work_[node] += work; }
  /// As EnergyBalance::energies, of the whole body. Collective: all ranks get the same.
  Energies energies(const NodeVectors& x, const NodeVectors& v);

 private:
  Ranks& ranks_;
  const RankBody& part_;
  bool moving_, started_ = false;
  Eigen::VectorXd work_, dissipated_;            // of owned nodes, J
  NodeVectors firstX_, lastX_, lastForce_;       // of owned nodes
  std::optional<double> dampedAt_;               // s, of the last recordDamping
  Eigen::VectorXd dampingPower_, supportPower_;  // W, there
  std::optional<double> reference_;              // J
};

/// The vectors of all nodes (3×N, numbered as in the whole) on rank 0, from their owners; 3×0 on the others.
/// Collective.
NodeVectors gathered(Ranks& ranks, const RankBody& part, NodeVectorsView vectors);

}  // namespace ringwatch

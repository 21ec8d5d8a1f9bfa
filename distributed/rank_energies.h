#pragma once
#include <ringwatch/distributed/rank_body.h>
#include <ringwatch/distributed/ranks.h>

namespace ringwatch {

/// Energies of a whole body, J. Sums over nodes and elements are exact (ExactSum), so that they have the same bits for
/// any number of ranks and any partition; Body::energy and EnergyBalance round theirs differently.
struct RankEnergies {
  double kinetic = 0, strain = 0;
};

/// At positions x and velocities v of the rank's nodes (3×N, m and m/s), x with ghosts as their owners have them.
/// Collective: all ranks get the same.
RankEnergies energiesOf(Ranks& ranks, const RankBody& part, NodeVectorsView x, NodeVectorsView v);

/// The vectors of all nodes (3×N, numbered as in the whole) on rank 0, from their owners; 3×0 on the others.
/// Collective.
NodeVectors gathered(Ranks& ranks, const RankBody& part, NodeVectorsView vectors);

}  // namespace ringwatch

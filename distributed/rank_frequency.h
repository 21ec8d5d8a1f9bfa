#pragma once
#include <ringwatch/distributed/rank_body.h>
#include <ringwatch/distributed/ranks.h>
#include <ringwatch/monitor/bounds/global_frequency.h>

namespace ringwatch {

/// globalFrequency() with tangent products that the ranks compute on their parts; the first rank keeps the vectors.
/// The same bits as on one process, for any number of ranks and any partition: sums at owned nodes have the terms and
/// the order of the whole (Theorem 78, docs/theory/distribution.md). whole, x (3×N, m): the same on all ranks. Other
/// ranks than the first have no mode. Throws what globalFrequency() does, on the first rank; for the others nothing has
/// converged then. Collective.
GlobalFrequency globalFrequency(Ranks& ranks, const RankBody& part, const Body& whole, NodeVectorsView x);

}  // namespace ringwatch

#include <ringwatch/distributed/rank_energies.h>

#include <array>
#include <cmath>
#include <vector>

#include <ringwatch/body/element_energy.h>

namespace ringwatch {

RankEnergies energiesOf(Ranks& ranks, const RankBody& part, NodeVectorsView x, NodeVectorsView v) {
  const Body& body = part.body();
  std::array<ExactSum, 2> sums;
  for (std::int32_t i = 0; i < part.ownedNodes(); ++i) {
    const double speed2 = std::fma(v(0, i), v(0, i), std::fma(v(1, i), v(1, i), v(2, i) * v(2, i)));
    sums[0].add(0.5 * body.lumpedMass()[i] * speed2);
  }
  const std::vector<std::vector<double>> strain = strainEnergyOfElements(body, x);
  for (std::size_t b = 0; b < strain.size(); ++b)
    for (std::size_t e = 0; e < strain[b].size(); ++e)
      if (part.counts({b, e})) sums[1].add(strain[b][e]);
  ranks.sum(sums);
  return {sums[0].value(), sums[1].value()};
}

NodeVectors gathered(Ranks& ranks, const RankBody& part, NodeVectorsView vectors) {
  const int size = ranks.size(), own = part.ownedNodes();
  const bool root = ranks.rank() == 0;
  std::vector<int> counts(size), begins(size + 1, 0);
  MPI_Gather(&own, 1, MPI_INT, counts.data(), 1, MPI_INT, 0, ranks.communicator());
  for (int r = 0; r < size; ++r) begins[r + 1] = begins[r] + counts[r];
  const int all = root ? begins[size] : 0;
  std::vector<std::int32_t> nodes(all);
  MPI_Gatherv(part.globalNodes().data(), own, MPI_INT32_T, nodes.data(), counts.data(), begins.data(), MPI_INT32_T, 0,
              ranks.communicator());
  // Of vectors, so that counts are those of nodes.
  MPI_Datatype vector = MPI_DATATYPE_NULL;
  MPI_Type_contiguous(3, MPI_DOUBLE, &vector);
  MPI_Type_commit(&vector);
  NodeVectors inOrderOfRanks(3, all), result(3, all);
  MPI_Gatherv(vectors.data(), own, vector, inOrderOfRanks.data(), counts.data(), begins.data(), vector, 0,
              ranks.communicator());
  MPI_Type_free(&vector);
  for (int i = 0; i < all; ++i) result.col(nodes[i]) = inOrderOfRanks.col(i);
  return result;
}

}  // namespace ringwatch

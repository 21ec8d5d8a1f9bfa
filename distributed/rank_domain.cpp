#include <ringwatch/distributed/rank_domain.h>

#include <utility>
#include <vector>

namespace ringwatch {

std::optional<ElementRef> RankDomain::firstFound(std::optional<ElementRef> found, std::string& text) {
  if (found) found = inWhole(*found);
  const std::optional<ElementRef> first = ranks_.first(found);
  if (first) text = ranks_.shareText(std::move(text), ranks_.firstWhere(found == first));
  return first;
}

void RankDomain::share(void* data, std::size_t bytes, bool has) {
  if (const int from = ranks_.firstWhere(has); from < ranks_.size()) ranks_.share(data, bytes, from);
}

const NodeVectors& RankDomain::withGhosts(const NodeVectors& x) {
  halo_.finish();
  withGhosts_ = x;
  halo_.exchange(withGhosts_);
  return withGhosts_;
}

NodeVectors RankDomain::gathered(const NodeVectors& ofPart) { return ringwatch::gathered(ranks_, part_, ofPart); }

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

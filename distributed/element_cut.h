#pragma once
#include <cstdint>
#include <vector>

#include <ringwatch/distributed/element_order.h>
#include <ringwatch/distributed/rank_part.h>
#include <ringwatch/distributed/ranks.h>
#include <ringwatch/distributed/shared_mesh.h>

namespace ringwatch {

/// A part for each rank, 0 to ranks - 1, of the elements that the ranks have pieces of: [block][element]. PT-Scotch
/// cuts the elements, joined through faces, each weighted by its nodes; it keeps a graph of the size of a piece on each
/// rank. Two calls may cut differently; what is computed on the parts does not depend on it. Throws InputError, on all
/// ranks alike, where PT-Scotch refuses. Collective.
std::vector<std::vector<std::int32_t>> cutElements(Ranks& ranks, const SharedMesh& mesh,
                                                   const std::vector<NumberedElements>& pieces);

/// The part of this rank by such a cut, a node being of the part that has most of its elements, of several such parts
/// of the first: with positions, ids and sets. Takes the pieces and the mesh. Collective.
RankPart gatherPart(Ranks& ranks, SharedMesh mesh, std::vector<NumberedElements> pieces,
                    const std::vector<std::vector<std::int32_t>>& parts);

/// Gives ghosts the values of their owners, so many numbers a node. Collective.
void copyToGhosts(Ranks& ranks, const RankPart& part, double* values, int numbers);

}  // namespace ringwatch

#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <ringwatch/distributed/rank_part.h>
#include <ringwatch/distributed/ranks.h>
#include <ringwatch/distributed/shared_mesh.h>
#include <ringwatch/meshes/quality.h>

namespace ringwatch {

// What loadMesh, meshNotes and summarizeQuality say of a mesh, of one that the ranks have parts of. All are collective,
// and all ranks get the same.

/// Corners of the bounding box of all nodes, m.
struct MeshBox {
  Eigen::Vector3d low, high;
};
MeshBox boxOf(Ranks& ranks, const NodeVectors& X);

/// The first steps of requireSound: elements of the other handedness are turned round, and nodes that no element has
/// are gone. counts: elements of each block in the whole; partlyTurned: whether some elements alone were. Returns
/// notes.
std::vector<std::string> mendShared(Ranks& ranks, SharedMesh& mesh, const std::vector<std::int64_t>& counts,
                                    const std::string& source, bool& partlyTurned);
/// The last one. Throws InputError where an element is not sound.
void requireSoundPart(Ranks& ranks, const RankPart& part, const std::string& source, bool partlyTurned);

/// meshNotes.
std::vector<std::string> partNotes(Ranks& ranks, const RankPart& part, const std::string& source);

/// summarizeQuality, with elements by their numbers in the whole. Means are exact sums over elements, rounded.
std::vector<QualitySummary> qualityOfParts(Ranks& ranks, const RankPart& part);

}  // namespace ringwatch

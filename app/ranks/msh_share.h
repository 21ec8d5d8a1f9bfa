#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include <ringwatch/distributed/ranks.h>
#include <ringwatch/distributed/shared_mesh.h>

namespace ringwatch {

/// An MSH 4.1 binary file of which each rank has read a share.
struct MshShare {
  ReadShare share;
  std::vector<std::int64_t> elementCounts;  // [block], of the whole
  std::vector<std::string> notes;           // as of readMesh
};

/// Reads a share of the nodes and of the elements on each rank: nodes, elements and blocks are those that readMesh has,
/// in its order. Throws InputError as readMesh does, on all ranks. Collective.
MshShare readMshShare(Ranks& ranks, const std::filesystem::path& path);

}  // namespace ringwatch

#pragma once
#include <cstdint>
#include <vector>

#include <ringwatch/body/element_block.h>
#include <ringwatch/gpu/imex/imex_operations.h>
#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// Implicit clusters as the device has them; see ImexView.
struct ImexPlan {
  struct Elements {  // of one mesh block
    std::vector<std::int32_t> element, node, cluster;
    std::vector<double> shape;
    std::int32_t firstBlock = 0;  // in ImexMatrixView::rotated
    std::size_t count() const { return element.size(); }
  };
  std::vector<Elements> blocks;
  std::vector<std::int32_t> node;  // [slice][10] mesh node, -1: none
  std::vector<ImexCluster> clusters;
  std::vector<std::int32_t> column, rowBegin, slice, first;
  std::vector<ImexContribution> contributions;
  std::int32_t blockCount = 0;  // of `rotated`
  std::int32_t sliceCount() const { return static_cast<std::int32_t>(node.size()) / sliceNodes; }
};

/// held: by mesh node, whether it has constrained components. Throws InputError for an element that the mesh does not
/// have, and for clusters that share a node.
ImexPlan planImex(const Mesh& mesh, const std::vector<std::vector<ElementRef>>& clusters,
                  const std::vector<bool>& held);

/// Who solves which cluster.
struct ImexTeams {
  std::int32_t blockCount = 0, teamBlocks = 0;
  std::vector<ImexTeam> teams;
  std::vector<std::int32_t> teamOfBlock, ofBlocks, ofWarps;
};
/// For a device that holds `resident` thread blocks at once: small clusters a warp, middling ones a thread block, and
/// those that would keep one thread block longer than all others, thread blocks by their share.
ImexTeams planTeams(const std::vector<ImexCluster>& clusters, std::int32_t resident);

}  // namespace ringwatch

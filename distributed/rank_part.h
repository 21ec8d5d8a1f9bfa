#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include <ringwatch/body/patch_layout.h>
#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// What a rank has of a mesh, numbered as in its RankBody: owned nodes by their numbers in the whole, then ghosts by
/// owner and number; elements of each block by their numbers.
struct RankPart {
  /// Nodes of which another rank has one as owner and the other as ghost.
  struct Neighbour {
    int rank;
    std::vector<std::int32_t> sent;             // owned here, ghosts there, by their numbers in the whole
    std::int32_t receivedBegin, receivedCount;  // ghosts here, owned there
  };

  RankPart() = default;
  /// Numbers the nodes of the elements that a rank holds. blocks: all of the mesh, connectivities with the nodes'
  /// numbers in the whole; elements: their numbers in the whole, ascending; owned: the rank's nodes, ascending;
  /// ownerOf: of any node of the elements. Node positions, ids and sets are not filled in.
  RankPart(int rank, std::vector<MeshBlock> blocks, std::vector<std::vector<std::int32_t>> elements,
           std::vector<std::int32_t> owned, const std::function<int(std::int32_t node)>& ownerOf);

  std::int32_t ghostNodes() const { return static_cast<std::int32_t>(globalNodes.size()) - ownedNodes; }
  /// The node with a number in the whole; -1 for none here.
  std::int32_t localNode(std::int32_t globalNode) const;
  /// Whether this rank counts the element where each is to count once: the one that owns its first node.
  bool counts(ElementRef e) const { return *mesh.blocks[e.block].element(e.element) < ownedNodes; }

  Mesh mesh;
  std::int32_t ownedNodes = 0;
  std::vector<std::int32_t> globalNodes;                  // numbers in the whole
  std::vector<std::vector<std::int32_t>> globalElements;  // [block], ascending
  std::vector<Neighbour> neighbours;                      // by rank
  std::vector<std::vector<PatchPlace>> places;            // [block][element], in the layout of the whole
  std::vector<std::int32_t> byNumber;                     // nodes here, ascending by their numbers in the whole
};

}  // namespace ringwatch

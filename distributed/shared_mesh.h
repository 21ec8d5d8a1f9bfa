#pragma once
#include <algorithm>
#include <compare>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <ringwatch/distributed/ranks.h>
#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// The named sets of a mesh, as large as its file has groups and blocks: all ranks have them alike.
struct SetNames {
  std::vector<std::string> ofNodes;
  /// Elements [first, first + count) of a block, and the sets that all of them are in.
  struct Run {
    std::int32_t block, first, count;
    std::vector<std::string> sets;
  };
  std::vector<Run> ofElements;  // by block and first
};

/// What a rank has read of a mesh. The ranks have all of it together, in the order of the file: each has nodes from
/// firstNode on, and elements of each block from Block::first on.
struct ReadShare {
  struct Block {
    ElementType type;
    std::int32_t first = 0;
    std::vector<std::int64_t> ids, nodes;  // numbers in the file: of the elements, and of the nodes of each, VTK order
  };
  struct SetNode {
    std::int64_t node;
    std::size_t position;  // in the file, of what names it
    std::int32_t set;      // of SetNames::ofNodes
  };
  std::int64_t allNodes = 0;  // of the file
  std::int64_t firstNode = 0;
  std::vector<std::int64_t> nodeIds;
  NodeVectors X;              // 3×N, m
  std::vector<Block> blocks;  // all of the mesh, also those of which this rank has nothing
  std::vector<SetNode> setNodes;
  SetNames sets;
  /// What is wrong, one line each: node i of this share has a number that was there before; element i of a block's
  /// share, or what is at a position, names a node that the file does not have.
  std::function<std::string(std::size_t i, std::int64_t id)> repeatedNode;
  std::function<std::string(std::size_t block, std::size_t i, std::int64_t id, std::int64_t node)> missingNode;
  std::function<std::string(std::size_t position, std::int64_t node)> missingSetNode;
};

/// A mesh whose nodes and elements are shared out among the ranks. Nodes are numbered in the order of the file without
/// those that no element has, elements of each block in its order.
struct SharedMesh {
  std::vector<std::int32_t> firstNode;  // [rank]: number of the first node at home there; at the end, that of all nodes
  std::vector<std::int64_t> nodeIds;    // of the nodes at home here
  NodeVectors X;                        // of these, 3×N, m
  /// A node and a set that it is in, of SetNames::ofNodes.
  struct SetNode {
    std::int32_t node, set;
    auto operator<=>(const SetNode&) const = default;
  };
  std::vector<SetNode> setNodes;  // of these nodes, ascending, each once

  Mesh slice;                              // this rank's elements with their nodes; no sets
  std::vector<std::int32_t> sliceNodes;    // numbers of the slice's nodes, ascending
  std::vector<std::int32_t> firstElement;  // [block]: number of the slice's first

  SetNames sets;
  std::int64_t droppedNodes = 0;      // of the file, that no element has
  std::int64_t firstDroppedNode = 0;  // its number in the file

  std::int32_t nodeCount() const { return firstNode.back(); }
  /// The rank that a node is at home on.
  int homeOf(std::int32_t node) const {
    return static_cast<int>(std::upper_bound(firstNode.begin(), firstNode.end(), node) - firstNode.begin()) - 1;
  }
};

/// Numbers what the ranks have read. No rank holds more than its share, and what other ranks ask it of that. Throws
/// InputError, on all ranks alike, for a number that two nodes have and for a node that there is not. Collective.
SharedMesh shareMesh(Ranks& ranks, ReadShare share);

}  // namespace ringwatch

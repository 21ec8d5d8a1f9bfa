#pragma once
#include <concepts>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <ringwatch/elements/registry.h>

namespace ringwatch {

/// Node vectors, 3×N: a column per node.
using NodeVectors = Eigen::Matrix3Xd;

/// Node vectors that are only read, wherever they lie: a NodeVectors, or 3×N numbers that others hold, node after
/// node. Valid as long as those are. An expression is evaluated for the call that it is an argument of.
class NodeVectorsView : public Eigen::Map<const NodeVectors> {
 public:
  using Map = Eigen::Map<const NodeVectors>;
  NodeVectorsView(const double* data, Eigen::Index nodes) : Map(data, 3, nodes) {}
  NodeVectorsView(const NodeVectors& vectors) : Map(vectors.data(), 3, vectors.cols()) {}
  NodeVectorsView(const Map& vectors) : Map(vectors) {}
  NodeVectorsView(const Eigen::Map<NodeVectors>& vectors) : Map(vectors.data(), 3, vectors.cols()) {}
  /// A default argument lives until the end of the call.
  template <class Expression>
  NodeVectorsView(const Eigen::MatrixBase<Expression>& expression, NodeVectors&& evaluated = NodeVectors())
      : NodeVectorsView(static_cast<const NodeVectors&>(evaluated = expression)) {}
};

/// Elements of one type.
struct MeshBlock {
  ElementType type;
  std::vector<std::int32_t> connectivity;  // element after element, VTK node order, indices into Mesh::X
  std::vector<std::int64_t> ids;           // the elements' numbers in the file; empty, or one each

  int nodesPerElement() const { return elementInfo(type).nodes; }
  std::size_t elementCount() const { return connectivity.size() / static_cast<std::size_t>(nodesPerElement()); }
  const std::int32_t* element(std::size_t e) const {
    return connectivity.data() + e * static_cast<std::size_t>(nodesPerElement());
  }
  /// The number of an element for messages and files:
  /// that of `ids`, or its position e in the block without them.
  std::int64_t id(std::size_t e) const { return e < ids.size() ? ids[e] : static_cast<std::int64_t>(e); }
};

/// An element, by block and by position in the block.
struct ElementRef {
  std::int32_t block = 0;
  std::int32_t element = 0;
  constexpr ElementRef() = default;
  /// Of integers of any type that 32 bits hold: no reader and no generator makes more elements.
  template <std::integral Block, std::integral Element>
  constexpr ElementRef(Block block, Element element)
      : block(static_cast<std::int32_t>(block)), element(static_cast<std::int32_t>(element)) {}
  friend auto operator<=>(const ElementRef&, const ElementRef&) = default;
};

/// Nodes, blocks of one element type each, and named sets. No physics. Its parts must fit together as requireValid()
/// says; a Body tests that when it is made.
struct Mesh {
  NodeVectors X;                      // reference positions, 3×N, m
  std::vector<std::int64_t> nodeIds;  // the nodes' numbers in the file; empty, or one each
  std::vector<MeshBlock> blocks;
  std::map<std::string, std::vector<std::int32_t>> nodeSets;
  std::map<std::string, std::vector<ElementRef>> elementSets;

  std::size_t nodeCount() const { return static_cast<std::size_t>(X.cols()); }
  /// The number of node i for messages and files: that of `nodeIds`, or i itself without them.
  std::int64_t nodeId(std::int32_t i) const {
    const std::size_t at = i;
    return at < nodeIds.size() ? nodeIds[at] : i;
  }
  std::size_t elementCount() const {
    std::size_t n = 0;
    for (const MeshBlock& block : blocks) n += block.elementCount();
    return n;
  }
};

/// Throws InputError where the parts of a mesh do not fit together: a connectivity that is no whole number of elements,
/// a node or an element that does not exist, ids for some only. Shapes are checkMesh's business (meshes/check.h).
void requireValid(const Mesh& mesh);

}  // namespace ringwatch

#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// Rows of different length in one array: row r is values[offsets[r]] … values[offsets[r + 1] - 1].
template <class T>
struct CompressedRows {
  std::vector<std::size_t> offsets{0};  // one more than there are rows
  std::vector<T> values;
  std::size_t rowCount() const { return offsets.size() - 1; }
  std::span<const T> row(std::size_t r) const { return {values.data() + offsets[r], offsets[r + 1] - offsets[r]}; }
};

/// A node of an element.
struct ElementNode {
  std::int32_t block, element, localNode;
  friend auto operator<=>(const ElementNode&, const ElementNode&) = default;
};
/// A face of an element, a row of `ElementInfo::faces`. element < 0: none.
struct ElementFace {
  std::int32_t block = -1, element = -1, face = -1;
  friend auto operator<=>(const ElementFace&, const ElementFace&) = default;
};

// All of these need indices in range (see `checkMesh`).

/// A row a node: the elements that hold it, by block, element.
CompressedRows<ElementNode> nodeElements(const Mesh& mesh);

/// A row a node: the other nodes that share an element with it, ascending, each once.
CompressedRows<std::int32_t> nodeNeighbours(const Mesh& mesh);

/// Position of each block's first element when all elements are counted through, and at the end their number.
std::vector<std::size_t> blockOffsets(const Mesh& mesh);

/// A row an element (counted through, `blockOffsets`), an entry a face: the face on the other side, or none on the
/// boundary. Faces are matched by their corner nodes. overfull: faces that three or more elements share; they get no
/// neighbour.
struct FaceNeighbours {
  CompressedRows<ElementFace> rows;
  std::vector<ElementFace> overfull;
};
FaceNeighbours faceNeighbours(const Mesh& mesh);

/// Faces that belong to one element only, in element order.
std::vector<ElementFace> boundaryFaces(const Mesh& mesh);

/// The pieces of a mesh, joined through shared nodes.
struct MeshParts {
  int count = 0;
  std::vector<std::int32_t> partOfNode;     // -1: no element uses it
  std::vector<std::int32_t> partOfElement;  // elements counted through
};
/// Parts are numbered by their first node.
MeshParts connectedParts(const Mesh& mesh);

}  // namespace ringwatch

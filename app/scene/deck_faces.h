#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <ringwatch/meshes/adjacency.h>

namespace ringwatch {

/// Faces of the surface of a mesh, by the numbers that decks give them.
class DeckFaces {
 public:
  /// mesh: by reference.
  explicit DeckFaces(const Mesh& mesh);

  /// The face with CalculiX's number, from 1 (user's manual, "C3D8", "C3D4", "C3D6"), of an element with the mesh's
  /// position; -1 when it lies inside the mesh. Empty where the element has no such face.
  std::optional<std::int32_t> find(ElementRef element, int number) const;

  /// The faces of elements.
  std::vector<std::int32_t> ofElements(const std::vector<ElementRef>& elements) const;

  /// The face with these corners, by the mesh's positions and in any order, and whether that order goes round it as
  /// seen from outside. Empty where the surface has no such face.
  std::optional<std::pair<std::int32_t, bool>> findByCorners(const std::vector<std::int32_t>& corners) const;

  /// Sets of node numbers of the mesh file, "#3,7,…", one or more, so that each face is one all of whose corners are
  /// in a set exactly once, and no other face of the surface is in any. faces: as find() gives them, each once.
  std::vector<std::string> nodeSetsOf(const std::vector<std::int32_t>& faces) const;

 private:
  const Mesh& mesh_;
  std::vector<ElementFace> faces_;                  // of the surface
  std::vector<std::vector<std::int32_t>> corners_;  // of each
  std::vector<std::vector<std::int32_t>> atNode_;   // faces at each node
};

}  // namespace ringwatch

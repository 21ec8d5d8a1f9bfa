#include <ringwatch/app/scene/deck_faces.h>

#include <algorithm>
#include <array>
#include <set>
#include <span>

#include <ringwatch/meshes/quality.h>

namespace ringwatch {
namespace {

using Corners = std::array<int, 4>;  // from 1; 0: none
constexpr Corners ofTetrahedra[] = {{1, 2, 3, 0}, {1, 4, 2, 0}, {2, 4, 3, 0}, {3, 4, 1, 0}};
constexpr Corners ofWedges[] = {{1, 2, 3, 0}, {4, 5, 6, 0}, {1, 2, 5, 4}, {2, 3, 6, 5}, {3, 1, 4, 6}};
constexpr Corners ofHexahedra[] = {{1, 2, 3, 4}, {5, 8, 7, 6}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 8, 4}, {4, 8, 5, 1}};

std::span<const Corners> facesOf(const ElementInfo& element) {
  switch (cornerCount(element)) {
    case 4:
      return ofTetrahedra;
    case 6:
      return ofWedges;
    case 8:
      return ofHexahedra;
    default:
      return {};
  }
}

}  // namespace

DeckFaces::DeckFaces(const Mesh& mesh) : mesh_(mesh), faces_(boundaryFaces(mesh)), atNode_(mesh.nodeCount()) {
  for (const ElementFace& face : faces_) {
    const MeshBlock& block = mesh.blocks[static_cast<std::size_t>(face.block)];
    auto& corners = corners_.emplace_back();
    for (const int corner : elementInfo(block.type).faces[static_cast<std::size_t>(face.face)])
      if (corner >= 0) corners.push_back(block.element(static_cast<std::size_t>(face.element))[corner]);
    for (const std::int32_t node : corners)
      atNode_[static_cast<std::size_t>(node)].push_back(static_cast<std::int32_t>(corners_.size()) - 1);
  }
}

std::optional<std::int32_t> DeckFaces::find(ElementRef element, int number) const {
  const MeshBlock& block = mesh_.blocks[static_cast<std::size_t>(element.block)];
  const std::span<const Corners> own = facesOf(elementInfo(block.type));
  if (number < 1 || static_cast<std::size_t>(number) > own.size()) return std::nullopt;
  std::vector<std::int32_t> wanted;
  for (const int corner : own[static_cast<std::size_t>(number) - 1])
    if (corner > 0) wanted.push_back(block.element(static_cast<std::size_t>(element.element))[corner - 1]);
  const auto& near = atNode_[static_cast<std::size_t>(wanted.front())];
  const auto found = std::ranges::find_if(near, [&](std::int32_t face) {
    const ElementFace& one = faces_[static_cast<std::size_t>(face)];
    return one.block == element.block && one.element == element.element &&
           std::ranges::is_permutation(corners_[static_cast<std::size_t>(face)], wanted);
  });
  return found == near.end() ? -1 : *found;
}

std::vector<std::int32_t> DeckFaces::ofElements(const std::vector<ElementRef>& elements) const {
  std::set<std::pair<std::int32_t, std::int32_t>> wanted;
  for (const ElementRef element : elements) wanted.emplace(element.block, element.element);
  std::vector<std::int32_t> found;
  for (std::size_t i = 0; i < faces_.size(); ++i)
    if (wanted.contains({faces_[i].block, faces_[i].element})) found.push_back(static_cast<std::int32_t>(i));
  return found;
}

std::optional<std::pair<std::int32_t, bool>> DeckFaces::findByCorners(const std::vector<std::int32_t>& corners) const {
  const auto& near = atNode_[static_cast<std::size_t>(corners.front())];
  const auto found = std::ranges::find_if(near, [&](std::int32_t face) {
    return std::ranges::is_permutation(corners_[static_cast<std::size_t>(face)], corners);
  });
  if (found == near.end()) return std::nullopt;
  const ElementFace& face = faces_[static_cast<std::size_t>(*found)];
  std::vector<std::int32_t> own = corners_[static_cast<std::size_t>(*found)];
  std::rotate(own.begin(), std::ranges::find(own, corners.front()), own.end());
  const bool alike = own[1] == corners[1];
  // The corners of a face go round it as seen from outside, of an element of the other handedness the other way.
  const double volume = elementQuality(mesh_.blocks[static_cast<std::size_t>(face.block)],
                                       static_cast<std::size_t>(face.element), mesh_.X)
                            .volume;
  return std::pair{*found, alike == (volume > 0)};
}

std::vector<std::string> DeckFaces::nodeSetsOf(const std::vector<std::int32_t>& faces) const {
  std::set<std::int32_t> pending(faces.begin(), faces.end());
  std::vector<std::string> sets;
  // A set takes every face whose nodes complete no other face, or only ones that are wanted and in no set yet.
  while (!pending.empty()) {
    std::vector<bool> in(mesh_.nodeCount(), false);
    std::set<std::int32_t> taken;
    const std::vector<std::int32_t> tried(pending.begin(), pending.end());
    for (const std::int32_t face : tried) {
      if (pending.count(face) == 0) continue;
      std::vector<std::int32_t> added;
      for (const std::int32_t node : corners_[static_cast<std::size_t>(face)])
        if (!in[static_cast<std::size_t>(node)]) {
          in[static_cast<std::size_t>(node)] = true;
          added.push_back(node);
        }
      std::set<std::int32_t> completed{face};
      bool good = true;
      for (const std::int32_t node : added)
        for (const std::int32_t near : atNode_[static_cast<std::size_t>(node)])
          if (std::ranges::all_of(corners_[static_cast<std::size_t>(near)],
                                  [&](std::int32_t n) { return in[static_cast<std::size_t>(n)]; })) {
            completed.insert(near);
            good = good && pending.count(near) != 0;
          }
      if (good) {
        for (const std::int32_t one : completed) pending.erase(one);
        taken.merge(completed);
      } else {
        for (const std::int32_t node : added) in[static_cast<std::size_t>(node)] = false;
      }
    }
    std::string set;
    for (std::size_t node = 0; node < in.size(); ++node)
      if (in[node]) set += (set.empty() ? "#" : ",") + std::to_string(mesh_.nodeId(static_cast<std::int32_t>(node)));
    sets.push_back(std::move(set));
  }
  return sets;
}

}  // namespace ringwatch

#pragma once
#include <cstdint>
#include <vector>

#include <ringwatch/body/patch_layout.h>
#include <ringwatch/distributed/ranks.h>
#include <ringwatch/distributed/shared_mesh.h>

namespace ringwatch {

/// Elements of a block that a rank has, with their numbers in the whole.
struct NumberedElements {
  ElementType type;
  std::vector<std::int32_t> numbers;
  std::vector<std::int64_t> ids;    // in the file
  std::vector<std::int32_t> nodes;  // numbers in the whole, those of an element one after the other, VTK order
  std::vector<PatchPlace> places;   // in the layout of the whole
  std::size_t count() const { return numbers.size(); }
  const std::int32_t* element(std::size_t i) const { return nodes.data() + i * width(); }
  std::size_t width() const { return static_cast<std::size_t>(elementInfo(type).nodes); }
};

/// An element on its way to another rank, where elements are in the order of key and number.
struct SentElement {
  std::uint64_t key;
  std::int64_t id;
  std::int32_t number;
  PatchPlace place;
};
/// Sends elements of a type to the ranks, [rank] of heads and of their nodes one after the other; returns those that
/// came here. Takes what it sends. Collective.
NumberedElements exchangeElements(Ranks& ranks, ElementType type, std::vector<std::vector<SentElement>>& heads,
                                  std::vector<std::vector<std::int32_t>>& nodes);

/// The elements of a mesh along the curve of layOutPatches, a piece of it for each rank, of about the same work; where
/// each element is in the layout that this gives the whole mesh. low, high: corners of the mesh, m. Takes the slice's
/// elements. Collective.
std::vector<NumberedElements> orderElements(Ranks& ranks, SharedMesh& mesh, const Eigen::Vector3d& low,
                                            const Eigen::Vector3d& high);

}  // namespace ringwatch

#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <string_view>
#include <vector>

#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/meshes/mesh.h>
#include <tests/support/random.h>

namespace ringwatch::test {

using Cells = std::array<int, 3>;

/// The usual split of a cell into this element.
inline const CellSubdivision& cellSplit(std::string_view element) {
  return findElementByName(element)->cellSplits.front();
}

/// A box of nx×ny×nz cells, corner at the origin, nodes moved at random by up to jitter × cell size.
inline Mesh gridMesh(std::string_view element, Cells cells, const Eigen::Vector3d& size, double jitter = 0,
                     std::uint64_t seed = 1) {
  BarOptions options;
  options.size = {size[0], size[1], size[2]};
  options.cells = cells;
  options.element = element;
  options.jitter = jitter;
  options.seed = seed;
  return generateBar(options);
}

/// The bar of the reference programs: 0.2 × 0.04 × 0.04 m, n cells over 0.04 m.
inline Mesh referenceBar(std::string_view element, int n) {
  return gridMesh(element, {5 * n, n, n}, {0.2, 0.04, 0.04});
}

/// The first `count` elements of a mesh of one block, with the nodes that they use.
inline Mesh firstElements(const Mesh& mesh, std::size_t count) {
  const MeshBlock& from = mesh.blocks[0];
  Mesh result;
  result.blocks.push_back({from.type, {}, {}});
  MeshBlock& block = result.blocks[0];
  std::map<std::int32_t, std::int32_t> renumbered;
  std::vector<std::int32_t> used;
  for (std::size_t i = 0; i < count * static_cast<std::size_t>(from.nodesPerElement()); ++i) {
    const auto [entry, isNew] = renumbered.try_emplace(from.connectivity[i], used.size());
    if (isNew) used.push_back(from.connectivity[i]);
    block.connectivity.push_back(entry->second);
  }
  for (std::size_t e = 0; e < count; ++e) block.ids.push_back(e);
  result.X.resize(3, used.size());
  for (std::size_t i = 0; i < used.size(); ++i) {
    result.X.col(i) = mesh.X.col(used[i]);
    result.nodeIds.push_back(i);
  }
  return result;
}

/// Nodes whose position satisfies the predicate.
template <class Predicate>
std::vector<std::int32_t> nodesWhere(const Mesh& mesh, const Predicate& predicate) {
  std::vector<std::int32_t> nodes;
  for (Eigen::Index i = 0; i < mesh.X.cols(); ++i)
    if (predicate(Eigen::Vector3d(mesh.X.col(i)))) nodes.push_back(i);
  return nodes;
}

inline std::int32_t nodeNearest(const Mesh& mesh, const Eigen::Vector3d& point) {
  Eigen::Index nearest = 0;
  (mesh.X.colwise() - point).colwise().squaredNorm().minCoeff(&nearest);
  return static_cast<std::int32_t>(nearest);
}

}  // namespace ringwatch::test

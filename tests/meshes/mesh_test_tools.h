#pragma once
#include <gtest/gtest.h>

#include <functional>
#include <string>

#include <Eigen/Geometry>

#include <ringwatch/base/error.h>
#include <ringwatch/meshes/adjacency.h>
#include <ringwatch/meshes/mesh.h>
#include <tests/support/temporary_folder.h>

namespace ringwatch::test {

/// Text of the InputError that the call throws; it must be one line. "" with a failure when nothing is thrown.
inline std::string errorOf(const std::function<void()>& call) {
  try {
    call();
  } catch (const InputError& error) {
    std::string text = error.what();
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    return text;
  }
  ADD_FAILURE() << "no InputError";
  return "";
}

/// Everything that a file is expected to keep.
inline void expectSame(const Mesh& a, const Mesh& b, bool sameIds = true) {
  ASSERT_EQ(a.nodeCount(), b.nodeCount());
  EXPECT_TRUE(a.X == b.X) << "positions differ";
  if (sameIds) {
    EXPECT_EQ(a.nodeIds, b.nodeIds);
  }
  ASSERT_EQ(a.blocks.size(), b.blocks.size());
  for (std::size_t i = 0; i < a.blocks.size(); ++i) {
    EXPECT_EQ(a.blocks[i].type, b.blocks[i].type);
    EXPECT_EQ(a.blocks[i].connectivity, b.blocks[i].connectivity);
    if (sameIds) {
      EXPECT_EQ(a.blocks[i].ids, b.blocks[i].ids);
    }
  }
  EXPECT_EQ(a.nodeSets, b.nodeSets);
  EXPECT_EQ(a.elementSets, b.elementSets);
}

/// Two hexahedra side by side and a pair of tetrahedra on the end: two blocks, several sets, numbers of its own.
inline Mesh mixedMesh() {
  Mesh mesh;
  mesh.X.resize(3, 14);
  for (int i = 0; i < 12; ++i) {
    const int row = i / 3;
    mesh.X.col(i) << i % 3, row % 2, row < 2 ? 0 : 1;
  }
  mesh.X.col(12) << 3.25, 0.125, 0.1;
  mesh.X.col(13) << 3.5, 1.0 / 3.0, 0.7;
  for (int i = 0; i < 14; ++i) mesh.nodeIds.push_back(7 + 3 * i);
  const auto hex = [](int o) { return std::vector<std::int32_t>{o, o + 1, o + 4, o + 3, o + 6, o + 7, o + 10, o + 9}; };
  MeshBlock hexes{elementTypeOf<Hex8>, hex(0), {11, 5}};
  for (const std::int32_t n : hex(1)) hexes.connectivity.push_back(n);
  // Both on the diagonal 5–8 … of the end face x = 2: nodes 2, 5, 8, 11.
  MeshBlock tets{elementTypeOf<Tet4>, {2, 5, 8, 12, 5, 11, 8, 13}, {101, 99}};
  mesh.blocks = {hexes, tets};
  mesh.nodeSets["left"] = {0, 3, 6, 9};
  mesh.nodeSets["low left"] = {0, 3};
  mesh.elementSets["all"] = {{0, 0}, {0, 1}, {1, 0}, {1, 1}};
  mesh.elementSets["box"] = {{0, 0}, {0, 1}};
  mesh.elementSets["tip"] = {{0, 1}, {1, 1}};
  return mesh;
}

/// Area of the boundary: a mesh whose inner faces do not match would have more of it.
inline double boundaryArea(const Mesh& mesh) {
  double area = 0;
  for (const ElementFace& f : boundaryFaces(mesh)) {
    const MeshBlock& block = mesh.blocks[f.block];
    const auto& face = elementInfo(block.type).faces[f.face];
    const auto at = [&](int k) -> Eigen::Vector3d { return mesh.X.col(block.element(f.element)[face[k]]); };
    const Eigen::Vector3d p = at(2) - at(0),
                          q = face[3] < 0 ? Eigen::Vector3d(at(1) - at(0)) : Eigen::Vector3d(at(3) - at(1));
    area += p.cross(q).norm() / 2;
  }
  return area;
}

}  // namespace ringwatch::test

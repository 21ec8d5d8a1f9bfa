#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include <ringwatch/meshes/mesh.h>

namespace ringwatch::detail {

/// A closed surface of triangles, their normals outwards.
struct TriangleSurface {
  NodeVectors X;                                       // 3×N, m
  std::vector<std::array<std::int32_t, 3>> triangles;  // nodes
};

/// By the divergence theorem, m³.
double enclosedVolume(const TriangleSurface& surface);
/// Of all triangles, degrees.
double leastAngle(const TriangleSurface& surface);
double meanEdge(const TriangleSurface& surface);  // m

/// The faces of a mesh of tet4 that no other element shares. nodes: of the mesh, by node of the surface. Throws
/// InputError for other elements.
TriangleSurface boundarySurface(const Mesh& mesh, std::vector<std::int32_t>* nodes = nullptr);

/// Surfaces like decimated scans: an icosahedron is divided `level` times, its nodes are shifted along the sphere, and
/// edges collapse at random until `nodes` are left; each direction is then taken to a point of the body on its ray. The
/// triangles of the directions cover the sphere once, so that the surface does not cut itself. By the seed alone, not
/// by machine. A ball of 10 cm across with bumps of a seventh of its radius.
TriangleSurface bumpyBall(int level, std::size_t nodes, std::uint64_t seed);
/// Six arms along the axes, 14 cm across; 2 cm from the centre between them.
TriangleSurface jack(int level, std::size_t nodes, std::uint64_t seed);

}  // namespace ringwatch::detail

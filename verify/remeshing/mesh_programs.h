#pragma once
#include <optional>
#include <string>
#include <vector>

#include <ringwatch/meshes/mesh.h>
#include <ringwatch/verify/remeshing/surfaces.h>

namespace ringwatch::detail {

/// What a mesh generator made: another program, called as a user would.
struct ProgramMesh {
  std::optional<Mesh> mesh;  // of tet4; empty: see note
  double seconds = 0;        // of processor time, reading and writing of files included
  std::string note;          // why there is none: the program is missing, or what it said
};

/// TetGen (Si 2015) with its switches, e.g. "-pq"; with a volume bound (m³) also -a. Nodes of the surface are the first
/// of the mesh, in their order.
ProgramMesh meshByTetgen(const TriangleSurface& surface, const std::string& switches,
                         std::optional<double> largestVolume = {});

/// How gmsh (Geuzaine & Remacle 2009) improves a mesh.
enum class GmshOptimizer { none, own, netgen };
/// gmsh with an optimiser: none, -optimize or -optimize_netgen. The surface stays as it is; its nodes are those of the
/// mesh at the same places.
ProgramMesh meshByGmsh(const TriangleSurface& surface, GmshOptimizer optimizer);

}  // namespace ringwatch::detail

#pragma once
#include <optional>
#include <string>
#include <vector>

#include <ringwatch/meshes/check.h>
#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// A mesh that was mended.
struct RepairedMesh {
  Mesh mesh;
  std::vector<std::string> done;      // what was mended, with its number, one line each; empty where nothing was to do
  std::vector<MeshProblem> problems;  // what is left
};

/// Mends what is wrong with the numbers of a mesh, and not with its shape: puts nodes that are in another program's
/// order into ours, joins nodes at one place, makes of an element that holds a node several times the wedge,
/// pyramid or tetrahedron that it is, leaves out an element that has no inside then and one that stands a second time,
/// turns elements of the other handedness round, and drops nodes that no element uses. Sets keep what is left of their
/// elements and nodes; an element that stood twice is in the sets of both. join: m; the nodes that lie closer to
/// another are joined with it, and so are those of `meshNotes`; none are without it. source: for the lines. Throws
/// InputError where nothing is left, and for elements that no mesh format has.
RepairedMesh repairMesh(Mesh mesh, const std::string& source, std::optional<double> join = {});

}  // namespace ringwatch

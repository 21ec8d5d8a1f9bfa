#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <ringwatch/base/name_table.h>
#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// One thing that is wrong with a mesh.
struct MeshProblem {
  enum class Kind { inverted, degenerate, missingNode, repeatedNode, nonFinite, unusedNode, duplicateElement };
  Kind kind;
  std::int32_t block;               // -1: a problem of a node
  std::int64_t index;               // element in its block, or node
  std::int64_t id;                  // the element's or node's number in the file
  std::vector<std::int64_t> nodes;  // numbers of the nodes concerned
  double value;      // Jacobian determinant (m³), coordinate (m), node number, or the other element's number
  std::string text;  // one line
};

inline constexpr auto problemNames = nameTable<MeshProblem::Kind>({
    {MeshProblem::Kind::inverted, "inverted"},
    {MeshProblem::Kind::degenerate, "degenerate"},
    {MeshProblem::Kind::missingNode, "missing-node"},
    {MeshProblem::Kind::repeatedNode, "repeated-node"},
    {MeshProblem::Kind::nonFinite, "non-finite"},
    {MeshProblem::Kind::unusedNode, "unused-node"},
    {MeshProblem::Kind::duplicateElement, "duplicate-element"},
});
constexpr std::string_view problemName(MeshProblem::Kind kind) { return problemNames.nameOf(kind); }

/// Every problem of the mesh, elements first, block after block, then nodes. An element is inverted when its Jacobian
/// determinant is negative at a quadrature point or corner, degenerate when it is below 1e-12 of its longest edge
/// cubed.
std::vector<MeshProblem> checkMesh(const Mesh& mesh);

/// What a user may want to know of a mesh that may be sound all the same, one line each: that it falls into parts, that
/// parts hang together by an edge or a node alone, and that nodes lie at the same place, closer than a thousandth
/// of the shortest edge at either. All nodes of its elements must exist.
std::vector<std::string> meshNotes(const Mesh& mesh, const std::string& source);

/// Makes a mesh fit for computing, or throws. Elements of the other handedness are turned round, and nodes that no
/// element uses are dropped, each with a note. Anything else that `checkMesh` finds: InputError
/// "SOURCE: n problems: …" with the first few.
void requireSound(Mesh& mesh, const std::string& source, std::vector<std::string>* notes = nullptr);

}  // namespace ringwatch

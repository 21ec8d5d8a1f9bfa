#include <ringwatch/meshes/mesh.h>

#include <ringwatch/base/error.h>
#include <ringwatch/meshes/index_limits.h>

namespace ringwatch {
namespace {

bool hasNode(const Mesh& mesh, std::int32_t node) {
  return node >= 0 && static_cast<std::size_t>(node) < mesh.nodeCount();
}

[[noreturn]] void refuseNode(const Mesh& mesh, std::int32_t node, const std::string& owner) {
  throw InputError(
      joinText(owner, ": has node ", node, "; nodes are 0 to ", static_cast<std::int64_t>(mesh.nodeCount()) - 1));
}

void requireNodesOfBlock(const Mesh& mesh, std::size_t b) {
  const MeshBlock& block = mesh.blocks[b];
  const std::size_t n = block.nodesPerElement();
  const std::string_view name = elementInfo(block.type).name;
  if (block.connectivity.size() % n != 0)
    throw InputError(joinText("block ", b, ": its connectivity has ", block.connectivity.size(),
                              " entries, not a multiple of the ", n, " nodes of a ", name));
  if (!block.ids.empty() && block.ids.size() != block.elementCount())
    throw InputError(joinText("block ", b, ": ", block.ids.size(), " ids for ", block.elementCount(),
                              " elements: give none, or one an element"));
  for (std::size_t i = 0; i < block.connectivity.size(); ++i)
    if (const std::int32_t node = block.connectivity[i]; !hasNode(mesh, node))
      refuseNode(mesh, node, joinText("block ", b, ", ", name, " element ", i / n));
}

}  // namespace

void requireValid(const Mesh& mesh) {
  if (mesh.nodeCount() > std::size_t{nodeCountLimit})
    throw InputError(joinText(mesh.nodeCount(), " nodes; at most ", nodeCountLimit, " are possible"));
  if (!mesh.nodeIds.empty() && mesh.nodeIds.size() != mesh.nodeCount())
    throw InputError(
        joinText(mesh.nodeIds.size(), " nodeIds for ", mesh.nodeCount(), " nodes: give none, or one a node"));
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) requireNodesOfBlock(mesh, b);
  for (const auto& [name, nodes] : mesh.nodeSets)
    for (const std::int32_t node : nodes)
      if (!hasNode(mesh, node)) refuseNode(mesh, node, joinText("node set \"", name, "\""));
  for (const auto& [name, elements] : mesh.elementSets)
    for (const ElementRef e : elements)
      if (e.block < 0 || static_cast<std::size_t>(e.block) >= mesh.blocks.size() || e.element < 0 ||
          static_cast<std::size_t>(e.element) >= mesh.blocks[e.block].elementCount())
        throw InputError(joinText("element set \"", name, "\": has element ", e.element, " of block ", e.block,
                                  ", which is not there"));
}

}  // namespace ringwatch

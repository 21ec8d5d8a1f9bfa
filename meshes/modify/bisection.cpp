#include <ringwatch/meshes/modify/bisection.h>

#include <algorithm>
#include <array>
#include <unordered_map>

#include <ringwatch/base/error.h>

namespace ringwatch {
namespace {

using Tetrahedron = std::array<std::int32_t, 4>;
constexpr std::array<std::array<std::size_t, 2>, 6> edgesOfTetrahedron{
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

std::uint64_t edgeKey(std::int32_t a, std::int32_t b) {
  return static_cast<std::uint64_t>(static_cast<std::uint32_t>(std::min(a, b))) << 32 |
         static_cast<std::uint32_t>(std::max(a, b));
}

/// Of the edges of a tetrahedron for which a test holds the longest one, first and second corner; of equal ones that of
/// the larger key. {0, 0}: none.
template <class Test>
std::array<std::size_t, 2> longestEdge(const Tetrahedron& nodes, const NodeVectors& X, const Test& test) {
  std::array<std::size_t, 2> best{0, 0};
  double length = -1;
  std::uint64_t bestKey = 0;
  for (const auto& edge : edgesOfTetrahedron) {
    const std::int32_t a = nodes[edge[0]], b = nodes[edge[1]];
    const std::uint64_t key = edgeKey(a, b);
    if (!test(key)) continue;
    // From the smaller number to the larger, so that every tetrahedron around the edge rounds alike.
    const double own = (X.col(std::max(a, b)) - X.col(std::min(a, b))).squaredNorm();
    if (own < length || (own == length && key < bestKey)) continue;
    best = edge;
    length = own;
    bestKey = key;
  }
  return best;
}

void requireTetrahedra(const Mesh& mesh) {
  for (const MeshBlock& block : mesh.blocks)
    if (block.type != elementTypeOf<Tet4>)
      throw InputError(
          joinText("only tetrahedra of four nodes can be cut; the mesh has ", elementInfo(block.type).name));
}

using NodeOfEdge = std::unordered_map<std::uint64_t, std::int32_t>;

/// The parts of a tetrahedron, depth first.
void addParts(const Tetrahedron& nodes, const NodeVectors& X, const NodeOfEdge& nodeOfEdge,
              std::vector<std::int32_t>& parts) {
  const auto [i, j] = longestEdge(nodes, X, [&](std::uint64_t key) { return nodeOfEdge.contains(key); });
  if (i == j) {
    parts.insert(parts.end(), nodes.begin(), nodes.end());
    return;
  }
  const std::int32_t middle = nodeOfEdge.at(edgeKey(nodes[i], nodes[j]));
  Tetrahedron first = nodes, second = nodes;
  first[j] = second[i] = middle;
  addParts(first, X, nodeOfEdge, parts);
  addParts(second, X, nodeOfEdge, parts);
}

Tetrahedron nodesOf(const MeshBlock& block, std::size_t e) {
  const std::int32_t* n = block.element(e);
  return {n[0], n[1], n[2], n[3]};
}

}  // namespace

BisectedMesh bisectEdges(const Mesh& mesh, const std::vector<EdgePoint>& points) {
  requireTetrahedra(mesh);
  BisectedMesh result;
  result.newNodes = points;
  Mesh& out = result.mesh;
  const std::int32_t before = mesh.nodeCount();
  out.X.resize(3, before + static_cast<Eigen::Index>(points.size()));
  out.X.leftCols(before) = mesh.X;
  std::int64_t nodeId = 0;  // of the next new node
  for (std::int32_t i = 0; i < before; ++i) {
    out.nodeIds.push_back(mesh.nodeId(i));
    nodeId = std::max(nodeId, out.nodeIds.back() + 1);
  }
  NodeOfEdge nodeOfEdge;
  nodeOfEdge.reserve(points.size());
  for (const EdgePoint& p : points) {
    if (!(p.t > 0 && p.t < 1) || p.a == p.b || std::min(p.a, p.b) < 0 || std::max(p.a, p.b) >= before)
      throw InputError(joinText("edge ", p.a, " to ", p.b, " cannot be cut at ", p.t, ": it must lie between 0 and 1"));
    const std::int32_t node = out.nodeIds.size();
    if (!nodeOfEdge.emplace(edgeKey(p.a, p.b), node).second)
      throw InputError(joinText("edge ", p.a, " to ", p.b, " is given twice"));
    out.X.col(node) = (1 - p.t) * mesh.X.col(p.a) + p.t * mesh.X.col(p.b);
    out.nodeIds.push_back(nodeId++);
  }

  std::vector<std::vector<std::size_t>> firstPart(mesh.blocks.size());  // of each element before, and the end
  std::int64_t elementId = 0;
  for (const MeshBlock& block : mesh.blocks)
    for (std::size_t e = 0; e < block.elementCount(); ++e) elementId = std::max(elementId, block.id(e) + 1);
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    const MeshBlock& block = mesh.blocks[b];
    MeshBlock parts{block.type, {}, {}};
    parts.connectivity.reserve(block.connectivity.size());
    result.parent.emplace_back();
    for (std::size_t e = 0; e < block.elementCount(); ++e) {
      firstPart[b].push_back(parts.elementCount());
      addParts(nodesOf(block, e), mesh.X, nodeOfEdge, parts.connectivity);
      parts.ids.push_back(block.id(e));
      while (parts.ids.size() < parts.elementCount()) parts.ids.push_back(elementId++);
      result.parent.back().resize(parts.elementCount(), e);
    }
    firstPart[b].push_back(parts.elementCount());
    out.blocks.push_back(std::move(parts));
  }

  for (const auto& [name, nodes] : mesh.nodeSets) {
    std::vector<bool> in(mesh.nodeCount(), false);
    for (const std::int32_t n : nodes) in[n] = true;
    std::vector<std::int32_t>& set = out.nodeSets[name] = nodes;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (in[points[i].a] && in[points[i].b]) set.push_back(before + static_cast<std::int32_t>(i));
  }
  for (const auto& [name, elements] : mesh.elementSets) {
    std::vector<ElementRef>& set = out.elementSets[name];
    for (const ElementRef& e : elements) {
      const std::vector<std::size_t>& first = firstPart[e.block];
      const std::size_t i = e.element;
      for (std::size_t part = first[i]; part < first[i + 1]; ++part)
        set.push_back({e.block, static_cast<std::int32_t>(part)});
    }
  }
  return result;
}

Mesh refineTetrahedra(Mesh mesh, const std::function<double(const Eigen::Vector3d& middle)>& longest,
                      std::size_t most) {
  requireTetrahedra(mesh);
  const auto any = [](std::uint64_t) { return true; };
  for (;;) {
    NodeOfEdge marked;  // the node numbers are not used
    std::vector<EdgePoint> points;
    const auto mark = [&](const Tetrahedron& nodes, const std::array<std::size_t, 2>& edge) {
      const std::int32_t a = std::min(nodes[edge[0]], nodes[edge[1]]), b = std::max(nodes[edge[0]], nodes[edge[1]]);
      if (marked.emplace(edgeKey(a, b), 0).second) points.push_back({a, b, 0.5});
    };
    for (const MeshBlock& block : mesh.blocks)
      for (std::size_t e = 0; e < block.elementCount(); ++e) {
        const Tetrahedron nodes = nodesOf(block, e);
        const auto edge = longestEdge(nodes, mesh.X, any);
        Eigen::Vector3d middle = Eigen::Vector3d::Zero();
        for (const std::int32_t n : nodes) middle += mesh.X.col(n) / 4;
        const double wanted = longest(middle);
        if (!(wanted > 0)) throw InputError(joinText("longest edge asked for: ", wanted, " m; it must be above 0"));
        if ((mesh.X.col(nodes[edge[0]]) - mesh.X.col(nodes[edge[1]])).norm() > wanted) mark(nodes, edge);
      }
    if (points.empty()) return mesh;
    // Who has an edge cut has its longest one cut too: angles stay above half of the first mesh's smallest in the plane
    // and, as experience has it, above a bound in space.
    for (std::size_t before = 0; before != points.size();) {
      before = points.size();
      for (const MeshBlock& block : mesh.blocks)
        for (std::size_t e = 0; e < block.elementCount(); ++e) {
          const Tetrahedron nodes = nodesOf(block, e);
          const bool touched = std::any_of(edgesOfTetrahedron.begin(), edgesOfTetrahedron.end(), [&](const auto& edge) {
            return marked.contains(edgeKey(nodes[edge[0]], nodes[edge[1]]));
          });
          if (touched) mark(nodes, longestEdge(nodes, mesh.X, any));
        }
    }
    mesh = bisectEdges(mesh, points).mesh;
    if (mesh.elementCount() > most)
      throw InputError(joinText("there are ", mesh.elementCount(), " tetrahedra and some are still too long; at most ",
                                most, " are possible"));
  }
}

}  // namespace ringwatch

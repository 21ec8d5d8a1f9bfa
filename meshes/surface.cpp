#include <ringwatch/meshes/surface.h>

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include <ringwatch/base/sort_unique.h>

namespace ringwatch {
namespace {

/// Corners of a face in order around it, and behind them, in quadratic elements, the middles of the edges that begin at
/// them.
struct Polygon {
  std::vector<std::int32_t> corners, middles;
};

Polygon polygonOf(const Mesh& mesh, const ElementFace& face) {
  const MeshBlock& block = mesh.blocks[face.block];
  const ElementInfo& info = elementInfo(block.type);
  const std::int32_t* own = block.element(face.element);
  std::vector<int> local;
  for (const int corner : info.faces[face.face])
    if (corner >= 0) local.push_back(corner);
  Polygon polygon;
  for (const int corner : local) polygon.corners.push_back(own[corner]);
  if (info.order < 2) return polygon;
  const int firstMiddle = info.nodes - static_cast<int>(info.edges.size());
  for (std::size_t i = 0; i < local.size(); ++i) {
    const int a = local[i], b = local[(i + 1) % local.size()];
    for (std::size_t e = 0; e < info.edges.size(); ++e)
      if ((info.edges[e][0] == a && info.edges[e][1] == b) || (info.edges[e][0] == b && info.edges[e][1] == a))
        polygon.middles.push_back(own[firstMiddle + static_cast<int>(e)]);
  }
  return polygon;
}

/// A quadrilateral or triangle, as triangles.
template <class Visit>
void cut(const Mesh& mesh, const std::vector<std::int32_t>& p, const Visit& visit) {
  if (p.size() == 3) {
    visit(p[0], p[1], p[2]);
    return;
  }
  const auto diagonal = [&](int a, int b) { return (mesh.X.col(p[a]) - mesh.X.col(p[b])).squaredNorm(); };
  // Equal ones are equal to rounding only.
  if (diagonal(0, 2) <= (1 + 1e-9) * diagonal(1, 3)) {
    visit(p[0], p[1], p[2]);
    visit(p[0], p[2], p[3]);
  } else {
    visit(p[0], p[1], p[3]);
    visit(p[1], p[2], p[3]);
  }
}

/// Whether a face's corners go round clockwise as seen from outside: from the rest of the element.
bool facesInwards(const Mesh& mesh, const ElementFace& face, const std::vector<std::int32_t>& corners) {
  const MeshBlock& block = mesh.blocks[face.block];
  const std::int32_t* own = block.element(face.element);
  Eigen::Vector3d middle = Eigen::Vector3d::Zero(), normal = Eigen::Vector3d::Zero(), centre = middle;
  for (int a = 0; a < block.nodesPerElement(); ++a) middle += mesh.X.col(own[a]) / block.nodesPerElement();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector3d a = mesh.X.col(corners[i]), b = mesh.X.col(corners[(i + 1) % corners.size()]);
    normal += a.cross(b);
    centre += a / static_cast<double>(corners.size());
  }
  return normal.dot(centre - middle) < 0;
}

}  // namespace

std::vector<SurfaceTriangle> surfaceTriangles(const Mesh& mesh) {
  std::vector<SurfaceTriangle> triangles;
  for (const ElementFace& face : boundaryFaces(mesh)) {
    Polygon polygon = polygonOf(mesh, face);
    auto& [corners, middles] = polygon;
    const bool inwards = facesInwards(mesh, face, corners);
    const auto add = [&](std::int32_t a, std::int32_t b, std::int32_t c) {
      if (inwards) std::swap(b, c);
      triangles.push_back({{a, b, c}, face});
    };
    if (middles.size() != corners.size()) {
      cut(mesh, corners, add);
      continue;
    }
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i) add(corners[i], middles[i], middles[(i + n - 1) % n]);
    cut(mesh, middles, add);
  }
  return triangles;
}

std::vector<std::int32_t> surfaceNodes(const Mesh& mesh) {
  std::vector<std::int32_t> nodes;
  for (const ElementFace& face : boundaryFaces(mesh)) {
    const Polygon polygon = polygonOf(mesh, face);
    nodes.insert(nodes.end(), polygon.corners.begin(), polygon.corners.end());
    nodes.insert(nodes.end(), polygon.middles.begin(), polygon.middles.end());
  }
  sortUnique(nodes);
  return nodes;
}

}  // namespace ringwatch

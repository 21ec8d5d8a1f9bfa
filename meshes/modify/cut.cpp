#include <ringwatch/meshes/modify/cut.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>

#include <Eigen/Geometry>

#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/meshes/adjacency.h>

namespace ringwatch {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

void requireFinite(const Vector3d& v, const char* what) {
  if (!v.allFinite()) throw InputError(joinText(what, " of a cut: must be finite"));
}

std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }

/// Which nodes are on the surface, and the edges that cross it elsewhere.
struct Crossings {
  std::vector<double> distance;  // of each node
  std::vector<bool> on;
  std::vector<EdgePoint> points;
};

Crossings findCrossings(const Mesh& mesh, const CutSurface& surface, const NodeVectors& x, double snap) {
  Crossings found;
  const std::size_t nodes = mesh.nodeCount();
  found.distance.resize(nodes);
  found.on.assign(nodes, false);
  for (std::size_t n = 0; n < nodes; ++n) {
    const Vector3d at = x.col(n);
    found.distance[n] = surface.distance(at);
    found.on[n] = found.distance[n] == 0 && surface.reaches(at);
  }
  std::vector<EdgePoint> crossing;
  const CompressedRows<std::int32_t> neighbours = nodeNeighbours(mesh);
  for (std::size_t n = 0; n < nodes; ++n)
    for (const std::int32_t m : neighbours.row(n)) {
      const double here = found.distance[n], there = found.distance[index(m)];
      if (static_cast<std::int32_t>(n) > m || !(here * there < 0)) continue;
      const double t = here / (here - there);
      const Eigen::Index a = n;
      if (!surface.reaches((1 - t) * x.col(a) + t * x.col(m))) continue;
      if (t < snap) found.on[n] = true;
      if (1 - t < snap) found.on[index(m)] = true;
      crossing.push_back({static_cast<std::int32_t>(n), m, t});
    }
  for (const EdgePoint& p : crossing)
    if (!found.on[index(p.a)] && !found.on[index(p.b)]) found.points.push_back(p);
  return found;
}

/// Groups of a few elements, joined pair by pair.
class Groups {
 public:
  explicit Groups(std::size_t count) : parent_(count) {
    for (std::size_t i = 0; i < count; ++i) parent_[i] = i;
  }
  std::size_t find(std::size_t i) const {
    while (parent_[i] != i) i = parent_[i];
    return i;
  }
  void join(std::size_t i, std::size_t j) {
    i = find(i);
    j = find(j);
    parent_[std::max(i, j)] = std::min(i, j);
  }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace

CutSurface CutSurface::plane(const Vector3d& point, const Vector3d& normal) {
  requireFinite(point, "point");
  requireFinite(normal, "normal");
  if (!(normal.norm() > 0)) throw InputError("normal of a cut: must not be zero");
  CutSurface surface;
  surface.point_ = point;
  surface.normal_ = normal.normalized();
  return surface;
}

CutSurface CutSurface::swept(std::vector<Vector3d> line, const Vector3d& sweep) {
  requireFinite(sweep, "sweep");
  if (!(sweep.norm() > 0)) throw InputError("sweep of a cut: must not be zero");
  if (line.size() < 2) throw InputError(joinText("line of a cut: ", line.size(), " points; it needs two or more"));
  CutSurface surface;
  surface.start_ = line.front();
  surface.along_ = sweep / sweep.squaredNorm();
  const Vector3d first = sweep.unitOrthogonal();
  surface.across_.row(0) = first.transpose();
  surface.across_.row(1) = sweep.normalized().cross(first).transpose();
  for (const Vector3d& p : line) {
    requireFinite(p, "line");
    surface.line_.push_back(surface.across_ * p);
  }
  for (std::size_t i = 1; i < line.size(); ++i)
    if (!((surface.line_[i] - surface.line_[i - 1]).norm() > 1e-12 * (line[i].norm() + line[i - 1].norm())))
      throw InputError(joinText("line of a cut: points ", i - 1, " and ", i, " coincide seen along the sweep"));
  return surface;
}

CutSurface::Nearest CutSurface::nearest(const Vector3d& x) const {
  const Vector2d p = across_ * x;
  const std::size_t pieces = line_.size() - 1;
  double best = infinity;
  Nearest result{};
  for (std::size_t i = 0; i < pieces; ++i) {
    const Vector2d a = line_[i], d = line_[i + 1] - a;
    double t = d.dot(p - a) / d.squaredNorm();
    const bool before = i == 0 && t < 0, after = i + 1 == pieces && t > 1;
    if (!before && !after) t = std::clamp(t, 0.0, 1.0);
    const Vector2d to = p - (a + t * d);
    const double distance = to.norm();
    if (distance > best) continue;
    double side = cross(d, p - a);
    // At a corner both pieces are as near; the side is that of the two together.
    if (!before && t == 0 && i > 0) side = cross(Vector2d(d.normalized() + (a - line_[i - 1]).normalized()), p - a);
    if (!after && t == 1 && i + 1 < pieces)
      side = cross(Vector2d(d.normalized() + (line_[i + 2] - line_[i + 1]).normalized()), Vector2d(p - line_[i + 1]));
    best = distance;
    result = {side < 0 ? -distance : distance, before || after};
  }
  return result;
}

double CutSurface::distance(const Vector3d& x) const {
  return line_.empty() ? normal_.dot(x - point_) : nearest(x).distance;
}

bool CutSurface::reaches(const Vector3d& x) const {
  if (line_.empty()) return true;
  const double u = along_.dot(x - start_);
  return u >= 0 && u <= 1 && !nearest(x).beyondEnds;
}

namespace {

/// A bisected mesh of tetrahedra, with the side of the surface that each element is on.
class Sides {
 public:
  /// at: the positions (3×N) in which the surface lies.
  Sides(const Mesh& mesh, const Crossings& crossings, const CutSurface& surface, const NodeVectors& at);
  std::size_t number(std::size_t block, std::size_t element) const { return offsets_[block] + element; }
  std::size_t number(const ElementNode& place) const { return number(index(place.block), index(place.element)); }
  bool below(std::size_t number) const { return below_[number]; }
  std::span<const ElementFace> others(std::size_t block, std::size_t element) const {
    return neighbours_.rows.row(number(block, element));
  }
  /// The nodes of a face of the element.
  std::array<std::int32_t, 3> nodesOf(std::size_t block, std::size_t element, std::size_t face) const;
  /// Faces in the surface with an element on either side are opened.
  bool opened(std::size_t block, std::size_t element, std::size_t face) const;
  /// Whether no face joins the elements around a node that are below with those above.
  bool parts(std::span<const ElementNode> star) const;

 private:
  const Mesh& mesh_;
  const Crossings& crossings_;
  std::vector<std::size_t> offsets_;
  std::vector<bool> below_;
  FaceNeighbours neighbours_;
};

Sides::Sides(const Mesh& mesh, const Crossings& crossings, const CutSurface& surface, const NodeVectors& at)
    : mesh_(mesh),
      crossings_(crossings),
      offsets_(blockOffsets(mesh)),
      below_(offsets_.back()),
      neighbours_(faceNeighbours(mesh)) {
  // That of its nodes off the surface, or where there are none of its middle.
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
    for (std::size_t e = 0; e < mesh.blocks[b].elementCount(); ++e) {
      const std::int32_t* nodes = mesh.blocks[b].element(e);
      double side = 0;
      Vector3d middle = Vector3d::Zero();
      for (int a = 0; a < 4; ++a) {
        if (!crossings.on[index(nodes[a])]) side += crossings.distance[index(nodes[a])];
        middle += at.col(nodes[a]) / 4;
      }
      below_[number(b, e)] = (side != 0 ? side : surface.distance(middle)) < 0;
    }
}

std::array<std::int32_t, 3> Sides::nodesOf(std::size_t block, std::size_t element, std::size_t face) const {
  const std::int32_t* nodes = mesh_.blocks[block].element(element);
  const std::array<int, 4>& corners = elementInfo(mesh_.blocks[block].type).faces[face];
  return {nodes[corners[0]], nodes[corners[1]], nodes[corners[2]]};
}

bool Sides::opened(std::size_t block, std::size_t element, std::size_t face) const {
  const ElementFace& other = others(block, element)[face];
  if (other.element < 0) return false;
  for (const std::int32_t n : nodesOf(block, element, face))
    if (!crossings_.on[index(n)]) return false;
  return below_[number(block, element)] != below_[number(index(other.block), index(other.element))];
}

bool Sides::parts(std::span<const ElementNode> star) const {
  Groups groups(star.size());
  std::map<std::size_t, std::size_t> inStar;
  std::array<std::size_t, 2> firstOfSide{star.size(), star.size()};
  for (std::size_t i = 0; i < star.size(); ++i) {
    inStar[number(star[i])] = i;
    std::size_t& first = firstOfSide[below_[number(star[i])] ? 1 : 0];
    if (first == star.size()) first = i;
    groups.join(first, i);
  }
  for (std::size_t i = 0; i < star.size(); ++i) {
    const auto b = index(star[i].block), e = index(star[i].element);
    const auto neighbours = others(b, e);
    for (std::size_t face = 0; face < neighbours.size(); ++face) {
      if (neighbours[face].element < 0 || opened(b, e, face)) continue;
      const auto other = inStar.find(number(index(neighbours[face].block), index(neighbours[face].element)));
      if (other != inStar.end()) groups.join(i, other->second);
    }
  }
  return firstOfSide[0] != star.size() && firstOfSide[1] != star.size() &&
         groups.find(firstOfSide[0]) != groups.find(firstOfSide[1]);
}

/// Counts the faces that open, and marks their nodes.
std::vector<bool> openFaces(const Sides& sides, CutMesh& result) {
  const Mesh& cut = result.mesh;
  std::vector<bool> atOpenFace(cut.nodeCount(), false);
  for (std::size_t b = 0; b < cut.blocks.size(); ++b)
    for (std::size_t e = 0; e < cut.blocks[b].elementCount(); ++e)
      for (std::size_t face = 0; face < sides.others(b, e).size(); ++face) {
        if (!sides.opened(b, e, face)) continue;
        const std::array<std::int32_t, 3> nodes = sides.nodesOf(b, e, face);
        for (const std::int32_t n : nodes) atOpenFace[index(n)] = true;
        if (!sides.below(sides.number(b, e))) continue;  // once for the two sides
        ++result.facesOpened;
        const Vector3d p = cut.X.col(nodes[0]);
        result.area += (cut.X.col(nodes[1]) - p).cross(Vector3d(cut.X.col(nodes[2]) - p)).norm() / 2;
      }
  return atOpenFace;
}

CutMesh uncut(const Mesh& mesh) {
  CutMesh same;
  same.mesh = mesh;
  for (std::int32_t n = 0; index(n) < mesh.nodeCount(); ++n) same.origin.push_back({n, n, 0});
  for (const MeshBlock& block : mesh.blocks) {
    auto& parents = same.parent.emplace_back(block.elementCount());
    for (std::size_t e = 0; e < parents.size(); ++e) parents[e] = static_cast<std::int32_t>(e);
    same.changed.emplace_back(block.elementCount(), false);
  }
  return same;
}

/// Counts the elements of the mesh that became several, and marks the nodes of what became of them.
void countElementsCut(const Mesh& mesh, CutMesh& result, std::vector<bool>& touched) {
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    const std::vector<std::int32_t>& parents = result.parent[b];
    result.elementsCut += mesh.blocks[b].elementCount();
    for (std::size_t e = 0; e < parents.size(); ++e) {
      const bool alone =
          (e == 0 || parents[e - 1] != parents[e]) && (e + 1 == parents.size() || parents[e + 1] != parents[e]);
      result.elementsCut -= alone;
      if (alone) continue;
      const std::int32_t* nodes = result.mesh.blocks[b].element(e);
      for (int a = 0; a < 4; ++a) touched[index(nodes[a])] = true;
    }
  }
}

/// Doubles the nodes of opened faces at which the two sides part: the elements below get the copy.
void doubleNodes(const Sides& sides, const std::vector<bool>& atOpenFace, CutMesh& result, std::vector<bool>& touched) {
  Mesh& cut = result.mesh;
  const CompressedRows<ElementNode> around = nodeElements(cut);
  std::map<std::int32_t, std::int32_t> copyOf;
  std::vector<ElementNode> turned;  // the places that the copies take
  std::int64_t nodeId = *std::max_element(cut.nodeIds.begin(), cut.nodeIds.end()) + 1;
  for (std::size_t n = 0; n < atOpenFace.size(); ++n) {
    if (!atOpenFace[n] || !sides.parts(around.row(n))) continue;
    copyOf[n] = static_cast<std::int32_t>(result.origin.size());
    touched[n] = true;
    result.origin.push_back(result.origin[n]);
    cut.nodeIds.push_back(nodeId++);
    for (const ElementNode& place : around.row(n))
      if (sides.below(sides.number(place))) turned.push_back(place);
  }
  for (const ElementNode& place : turned) {
    MeshBlock& block = cut.blocks[index(place.block)];
    std::int32_t& node = block.connectivity[index(place.element) * 4 + index(place.localNode)];
    node = copyOf.at(node);
  }
  cut.X.conservativeResize(Eigen::NoChange, result.origin.size());
  touched.resize(result.origin.size(), true);
  for (const auto& [node, copy] : copyOf) cut.X.col(copy) = cut.X.col(node);
  for (auto& [name, nodes] : cut.nodeSets) {
    std::vector<std::int32_t> copies;
    for (const std::int32_t n : nodes)
      if (const auto copy = copyOf.find(n); copy != copyOf.end()) copies.push_back(copy->second);
    nodes.insert(nodes.end(), copies.begin(), copies.end());
  }
}

}  // namespace

CutMesh cutMesh(const Mesh& mesh, const CutSurface& surface, const NodeVectors& x, double snap) {
  constexpr double leastSnap = 1e-6;  // a part of less volume than this to the third has none in floating point
  if (!(snap >= 0 && snap <= 0.5)) throw InputError(joinText("snap of a cut: ", snap, ": must be >= 0 and <= 0.5"));
  Crossings crossings = findCrossings(mesh, surface, x, std::max(snap, leastSnap));
  BisectedMesh bisected = bisectEdges(mesh, crossings.points);

  CutMesh result;
  result.mesh = std::move(bisected.mesh);
  result.parent = std::move(bisected.parent);
  for (std::int32_t n = 0; index(n) < mesh.nodeCount(); ++n) result.origin.push_back({n, n, 0});
  result.origin.insert(result.origin.end(), bisected.newNodes.begin(), bisected.newNodes.end());
  crossings.distance.resize(result.mesh.nodeCount(), 0);
  crossings.on.resize(result.mesh.nodeCount(), true);

  std::vector<bool> touched(result.mesh.nodeCount(), false);
  {
    const Sides sides(result.mesh, crossings, surface, carriedOver(result, x));
    const std::vector<bool> atOpenFace = openFaces(sides, result);
    if (result.facesOpened == 0) return uncut(mesh);
    countElementsCut(mesh, result, touched);
    doubleNodes(sides, atOpenFace, result, touched);
  }
  result.nodesAdded = result.origin.size() - mesh.nodeCount();
  for (const MeshBlock& block : result.mesh.blocks) {
    auto& changed = result.changed.emplace_back(block.elementCount());
    for (std::size_t e = 0; e < changed.size(); ++e) {
      const std::int32_t* nodes = block.element(e);
      changed[e] = std::any_of(nodes, nodes + 4, [&](std::int32_t n) { return touched[index(n)]; });
    }
  }
  return result;
}

NodeVectors carriedOver(const CutMesh& cut, const NodeVectors& field) {
  NodeVectors result(3, cut.origin.size());
  for (std::size_t n = 0; n < cut.origin.size(); ++n) {
    const EdgePoint& p = cut.origin[n];
    const Eigen::Index to = n;
    if (p.t == 0)
      result.col(to) = field.col(p.a);
    else
      result.col(to) = (1 - p.t) * field.col(p.a) + p.t * field.col(p.b);
  }
  return result;
}

}  // namespace ringwatch

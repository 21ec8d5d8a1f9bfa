#include <ringwatch/body/surface_contact.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include <Eigen/Geometry>
#include <unsupported/Eigen/BVH>

#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/parallel.h>
#include <ringwatch/base/sort_unique.h>
#include <ringwatch/meshes/surface.h>

namespace ringwatch {
namespace {

using Eigen::Vector3d;

/// Barycentric coordinates by which a point counts as one of a triangle that it is beside by rounding alone.
constexpr double besideByRounding = 1e-10;
/// Distances that differ by no more are one, relative.
constexpr double sameDistance = 1e-12;
/// Cosine by which normals are against one another, at least, for one face to see another: rims that are flush do not,
/// bent by up to 17 degrees.
constexpr double against = 0.3;
/// Cosine of these 17 degrees, √(1 - against²).
constexpr double flush = 0.953939;
/// Of a node at such a rim: how far it may be outside over how far it is below, the tangent of these 17 degrees.
constexpr double beside = 0.314485;
/// Cosine of the angle by which the surface turns at an edge up to which both sides of it are one face.
constexpr double oneFace = 0.5;
/// Of the mean edge: what nodes may move against one another until the lists are made again.
constexpr double skinOfEdge = 0.4;
/// Sine of the angle of a triangle below which it counts as its edges.
constexpr double needle = 1e-8;
/// What closest points are off by where angles are no smaller, and sums of paths, at most, over the edge of the cells.
constexpr double roundingOfEdge = 1e-6;
/// Paths over the edge of the cells up to which that holds.
constexpr double longestPath = 1e6;

double heightBehind(const Mesh& mesh, const SurfaceTriangle& triangle) {
  const Vector3d a = mesh.X.col(triangle.nodes[0]), b = mesh.X.col(triangle.nodes[1]),
                 c = mesh.X.col(triangle.nodes[2]);
  const Vector3d normal = (b - a).cross(c - a).normalized();
  const MeshBlock& block = mesh.blocks[triangle.face.block];
  const std::int32_t* own = block.element(triangle.face.element);
  double height = 0;
  for (int i = 0; i < block.nodesPerElement(); ++i) height = std::max(height, normal.dot(a - mesh.X.col(own[i])));
  return height;
}

template <class T>
CompressedRows<T> rowsOf(const std::vector<std::vector<T>>& lists) {
  CompressedRows<T> rows;
  for (const std::vector<T>& list : lists) {
    rows.values.insert(rows.values.end(), list.begin(), list.end());
    rows.offsets.push_back(rows.values.size());
  }
  return rows;
}

using TriangleBox = Eigen::AlignedBox3d;
using TriangleTree = Eigen::KdBVH<double, 3, int>;

/// Collects the boxes that a ball meets.
struct BallQuery {
  Vector3d centre;
  double radius2;
  const std::vector<TriangleBox>& boxes;
  std::vector<std::int32_t>& found;
  bool intersectVolume(const TriangleBox& box) const { return box.squaredExteriorDistance(centre) <= radius2; }
  bool intersectObject(int triangle) const {
    if (boxes[triangle].squaredExteriorDistance(centre) <= radius2) found.push_back(triangle);
    return false;
  }
};

}  // namespace

void requireSlip(double friction, const SlipSpeed& slip) {
  if (friction > 0 && !((slip.speed > 0) != (slip.ofDepth > 0)))
    throw InputError(joinText("slip = ", slip.speed, " m/s or ", slip.ofDepth,
                              " of the depth a second: one of them must be > 0 where there is friction"));
}

SurfaceContact surfaceContact(const Mesh& mesh, std::vector<std::int32_t> nodes,
                              const std::vector<std::int32_t>& surface, std::optional<double> edgeAngle) {
  SurfaceContact contact;
  const std::vector<SurfaceTriangle> all = surfaceTriangles(mesh);
  const auto isTouched = [&](const std::array<std::int32_t, 3>& at) {
    return std::all_of(at.begin(), at.end(),
                       [&](std::int32_t node) { return std::binary_search(surface.begin(), surface.end(), node); });
  };
  std::vector<std::vector<std::array<std::int32_t, 2>>> fan(mesh.nodeCount());
  std::vector<double> nodeDepth(mesh.nodeCount(), infinity);
  std::vector<char> corner(mesh.nodeCount(), 0);
  for (const SurfaceTriangle& triangle : all) {
    const auto& at = triangle.nodes;
    const double depth = 0.5 * heightBehind(mesh, triangle);
    for (int i = 0; i < 3; ++i) {
      fan[at[i]].push_back({at[(i + 1) % 3], at[(i + 2) % 3]});
      const Vector3d b = mesh.X.col(at[(i + 1) % 3]), c = mesh.X.col(at[(i + 2) % 3]);
      const double height = (b - mesh.X.col(at[i])).cross(c - b).norm() / (c - b).norm();
      nodeDepth[at[i]] = std::min({nodeDepth[at[i]], depth, 0.5 * height});
    }
    if (!isTouched(at)) continue;
    contact.triangles.push_back(at);
    contact.depth.push_back(depth);
    for (const std::int32_t node : at) corner[node] = 1;
  }
  if (contact.triangles.empty()) throw InputError("no face of the surface has all of its corners among the nodes");
  for (const SurfaceTriangle& triangle : all) {
    const auto& at = triangle.nodes;
    if ((corner[at[0]] || corner[at[1]] || corner[at[2]]) && !isTouched(at)) contact.around.push_back(at);
  }
  const CompressedRows<std::int32_t> neighbours = nodeNeighbours(mesh);
  contact.nodes = std::move(nodes);
  contact.split.assign(contact.nodes.size(), 1);
  for (const std::int32_t node : contact.nodes) {
    if (fan[node].empty()) throw InputError(joinText("node ", mesh.nodeId(node), " is not on the surface"));
    const auto& own = fan[node];
    contact.fan.values.insert(contact.fan.values.end(), own.begin(), own.end());
    contact.fan.offsets.push_back(contact.fan.values.size());
    contact.nodeDepth.push_back(nodeDepth[node]);
    const auto near = neighbours.row(node);
    contact.neighbours.values.insert(contact.neighbours.values.end(), near.begin(), near.end());
    contact.neighbours.offsets.push_back(contact.neighbours.values.size());
  }
  if (!edgeAngle) return contact;
  // Directed edges, and the triangles that have them.
  std::map<std::array<std::int32_t, 2>, std::size_t> edges;
  for (std::size_t t = 0; t < all.size(); ++t)
    for (int i = 0; i < 3; ++i) edges[{all[t].nodes[i], all[t].nodes[(i + 1) % 3]}] = t;
  const auto isNode = [&](std::int32_t node) {
    return std::binary_search(contact.nodes.begin(), contact.nodes.end(), node);
  };
  for (const auto& [ends, t] : edges) {
    const auto other = edges.find({ends[1], ends[0]});
    if (ends[0] > ends[1] || other == edges.end()) continue;
    const std::array<const SurfaceTriangle*, 2> sides{&all[t], &all[other->second]};
    SurfaceContact::Edge edge{ends, {}, isNode(ends[0]) && isNode(ends[1]), false, infinity};
    std::array<Vector3d, 2> normals;
    for (int side = 0; side < 2; ++side) {
      const auto& at = sides[side]->nodes;
      for (const std::int32_t node : at)
        if (node != ends[0] && node != ends[1]) edge.third[side] = node;
      const Vector3d a = mesh.X.col(at[0]);
      normals[side] = (mesh.X.col(at[1]) - a).cross(mesh.X.col(at[2]) - a).normalized();
      edge.touched = edge.touched || isTouched(at);
      edge.depth = std::min(edge.depth, 0.5 * heightBehind(mesh, *sides[side]));
    }
    const Vector3d along = (mesh.X.col(ends[1]) - mesh.X.col(ends[0])).normalized();
    const double turns = std::atan2(normals[0].cross(normals[1]).dot(along), normals[0].dot(normals[1]));
    if (turns > *edgeAngle && (edge.touches || edge.touched)) contact.edges.push_back(edge);
  }
  return contact;
}

SurfaceSearch::SurfaceSearch(SurfaceContact contact, std::int32_t nodeCount) : contact_(std::move(contact)) {
  const std::size_t count = contact_.nodes.size();
  if (contact_.penalty.size() != count || contact_.damping.size() != count || contact_.split.size() != count ||
      contact_.fan.rowCount() != count || contact_.neighbours.rowCount() != count)
    throw InputError("surface contact: a penalty, a damping, a split and its rows are needed for each node");
  if (contact_.depth.size() != contact_.triangles.size() || contact_.nodeDepth.size() != count)
    throw InputError("surface contact: a depth is needed for each triangle and each node");
  const auto require = [](const char* name, const std::vector<double>& values, bool positive) {
    for (const double value : values)
      if (!(positive ? value > 0 : value >= 0) || !std::isfinite(value))
        throw InputError(joinText(name, " = ", value, ": must be ", positive ? "> 0" : ">= 0"));
  };
  require("penalty", contact_.penalty, false);
  require("damping", contact_.damping, false);
  require("split", contact_.split, true);
  require("friction", {contact_.friction}, false);
  requireSlip(contact_.friction, contact_.slip);
  nodes_ = contact_.nodes;
  const auto triangleCount = static_cast<std::int32_t>(contact_.triangles.size() + contact_.around.size());
  for (std::int32_t t = 0; t < triangleCount; ++t) {
    const auto& corners = cornersOf(t);
    nodes_.insert(nodes_.end(), corners.begin(), corners.end());
  }
  for (const SurfaceContact::Edge& edge : contact_.edges) {
    require("penalty", {edge.penalty}, false);
    require("damping", {edge.damping}, false);
    require("mass", {edge.mass}, true);
    nodes_.insert(nodes_.end(), edge.nodes.begin(), edge.nodes.end());
    nodes_.insert(nodes_.end(), edge.third.begin(), edge.third.end());
    deepestEdge_ = std::max(deepestEdge_, edge.depth);
    if (!edge.touches) continue;
    for (const std::int32_t node : edge.nodes)
      if (!std::binary_search(contact_.nodes.begin(), contact_.nodes.end(), node))
        throw InputError(joinText("node ", node, " of an edge that touches is none of the nodes"));
  }
  sortUnique(nodes_);
  if (!nodes_.empty() && (nodes_.front() < 0 || nodes_.back() >= nodeCount))
    throw InputError(
        joinText("node ", nodes_.front() < 0 ? nodes_.front() : nodes_.back(), ": must be one of ", nodeCount));
  const auto most = [](const std::vector<double>& values) {
    return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
  };
  deepest_ = std::min(most(contact_.depth), most(contact_.nodeDepth));
  cornerPlace_.assign(nodeCount, -1);
  std::vector<std::vector<std::int32_t>> at;
  for (std::int32_t t = 0; t < triangleCount; ++t)
    for (const std::int32_t corner : cornersOf(t)) {
      if (cornerPlace_[corner] < 0) {
        cornerPlace_[corner] = static_cast<std::int32_t>(at.size());
        at.emplace_back();
      }
      at[cornerPlace_[corner]].push_back(t);
    }
  trianglesAt_ = rowsOf(at);
}

SurfaceSearch::Closest SurfaceSearch::closestPoint(const Vector3d& s, const Vector3d& a, const Vector3d& b,
                                                   const Vector3d& c) {
  Closest result{infinity, {}, Vector3d::Zero(), 0, 0, Vector3d::Zero()};
  const Vector3d e1 = b - a, e2 = c - a, p = s - a;
  const Vector3d normal = e1.cross(e2);
  const double n2 = normal.squaredNorm();
  result.normal = normal;
  if (n2 > needle * needle * e1.squaredNorm() * e2.squaredNorm()) {
    const double w1 = p.cross(e2).dot(normal) / n2, w2 = e1.cross(p).dot(normal) / n2, w0 = 1 - w1 - w2;
    if (std::min({w0, w1, w2}) >= -besideByRounding) {
      result.w = {w0, w1, w2};
      result.r = (p.dot(normal) / n2) * normal;
      result.distance2 = result.r.squaredNorm();
      result.free = 2;
      return result;
    }
  }
  const std::array<const Vector3d*, 3> x{&a, &b, &c};
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const Vector3d edge = *x[j] - *x[i], q = s - *x[i];
    const double length2 = edge.squaredNorm(), t = length2 > 0 ? q.dot(edge) / length2 : 0;
    const bool inside = length2 > 0 && t >= -besideByRounding && t <= 1 + besideByRounding;
    const double at = inside ? t : std::clamp(t, 0.0, 1.0);
    const Vector3d r = q - at * edge;
    const double distance2 = r.squaredNorm();
    if (!(distance2 < result.distance2 * (inside && result.free == 0 ? 1 + sameDistance : 1))) continue;
    result.distance2 = distance2;
    result.r = r;
    result.w = {};
    result.w[i] = 1 - at;
    result.w[j] = at;
    result.free = inside ? 1 : 0;
    result.corner = inside || at == 0 ? i : j;
  }
  return result;
}

Eigen::Matrix3d SurfaceSearch::Touch::block(int a, int c, double k, double fc) const {
  Eigen::Matrix3d own =
      (k * b[a] * b[c]) * Eigen::Matrix3d::Identity() + (fc * b[a] * b[c]) * normal * normal.transpose();
  for (int i = 0; i < free; ++i)
    for (int j = 0; j < free; ++j) own -= (k * inverse(i, j)) * column(a, i) * column(c, j).transpose();
  return own;
}

void SurfaceSearch::Touch::setDirections(NodeVectorsView x, int directions) {
  free = directions;
  inverse.setZero();
  for (int i = 0; i < free; ++i) T[i] = x.col(nodes[to[i]]) - x.col(nodes[base[i]]);
  if (free == 1) inverse(0, 0) = 1 / T[0].squaredNorm();
  if (free < 2) return;
  Eigen::Matrix2d G;
  G << T[0].squaredNorm(), T[0].dot(T[1]), T[0].dot(T[1]), T[1].squaredNorm();
  inverse = G.inverse();
}

bool SurfaceSearch::listsServe(double reach, int threads) {
  if (!motion_.started() || !(motion_.longestPath() <= longestPath * motion_.edge())) return false;
  return motion_.keepsApart(listed_, extent_, deepest_ + 2 * reach + rounding_, at_, threads) &&
         (edgeRows_.empty() ||
          motion_.keepsApart(edgeListed_, 2 * edgeExtent_, deepestEdge_ + reach + rounding_, at_, threads));
}

void SurfaceSearch::makeLists(NodeVectorsView x, double reach, int threads) {
  ++statistics_.lists;
  if (skin_ == 0) {
    double sum = 0;
    for (const auto& t : contact_.triangles)
      sum += (x.col(t[1]) - x.col(t[0])).norm() + (x.col(t[2]) - x.col(t[1])).norm();
    skin_ = skinOfEdge * sum / (2 * static_cast<double>(contact_.triangles.size()));
  }
  listed_ = deepest_ + 2 * reach + skin_;
  const std::size_t count = contact_.triangles.size() + contact_.around.size();
  std::vector<TriangleBox> boxes(count);
  std::vector<int> numbers(count);
  extent_ = 0;
  for (std::size_t t = 0; t < count; ++t) {
    for (const std::int32_t node : cornersOf(static_cast<std::int32_t>(t))) boxes[t].extend(Vector3d(x.col(node)));
    extent_ = std::max(extent_, boxes[t].sizes().maxCoeff());
    numbers[t] = static_cast<int>(t);
  }
  edgeListed_ = deepestEdge_ + reach + skin_;
  edgeExtent_ = 0;
  for (const SurfaceContact::Edge& edge : contact_.edges)
    edgeExtent_ = std::max(edgeExtent_, (x.col(edge.nodes[1]) - x.col(edge.nodes[0])).cwiseAbs().maxCoeff());
  // All of a triangle in a list is in the neighbourhood of its node, and of an edge in that of the other's first end.
  const double farthest =
      contact_.edges.empty() ? listed_ + extent_ : std::max(listed_ + extent_, edgeListed_ + 2 * edgeExtent_);
  motion_.start(at_, (1 + roundingOfEdge) * farthest);
  rounding_ = roundingOfEdge * motion_.edge();
  const TriangleTree tree(numbers.begin(), numbers.end(), boxes.begin(), boxes.end());
  const std::size_t entries = contact_.nodes.size();
  std::vector<std::vector<std::int32_t>> found(entries);
  parallelFor(
      0, static_cast<std::int64_t>(entries), threads,
      [&](std::int64_t k) {
        const std::int32_t node = contact_.nodes[k];
        BallQuery query{x.col(node), listed_ * listed_, boxes, found[k]};
        Eigen::BVIntersect(tree, query);
        if (found[k].empty()) return;
        // By node, whether it shares an element with this one: a triangle's corners are then three look-ups.
        thread_local std::vector<char> own;
        if (own.size() < cornerPlace_.size()) own.resize(cornerPlace_.size(), 0);
        const auto mark = [&](char value) {
          own[node] = value;
          for (const std::int32_t other : contact_.neighbours.row(k)) own[other] = value;
        };
        mark(1);
        std::erase_if(found[k], [&](std::int32_t t) {
          const auto& corners = cornersOf(t);
          return own[corners[0]] || own[corners[1]] || own[corners[2]];
        });
        mark(0);
        std::sort(found[k].begin(), found[k].end());
      },
      64);
  rows_.clear();
  rowCell_.clear();
  candidates_ = {};
  for (std::size_t k = 0; k < entries; ++k) {
    if (found[k].empty()) continue;
    rows_.push_back(static_cast<std::int32_t>(k));
    const auto place = std::lower_bound(nodes_.begin(), nodes_.end(), contact_.nodes[k]) - nodes_.begin();
    rowCell_.push_back(motion_.cellOf(static_cast<std::size_t>(place)));
    candidates_.values.insert(candidates_.values.end(), found[k].begin(), found[k].end());
    candidates_.offsets.push_back(candidates_.values.size());
  }
  until_.assign(candidates_.values.size(), 0);
  rowUntil_.assign(rows_.size(), 0);
  rowNearest_.assign(rows_.size(), -1);
  makeEdgeLists(x, threads);
}

void SurfaceSearch::normalsAt(NodeVectorsView x, std::int32_t entry, std::vector<Vector3d>& normals) const {
  const Vector3d s = x.col(contact_.nodes[entry]);
  normals.assign(1, Vector3d::Zero());
  for (const auto& [b, c] : contact_.fan.row(entry)) {
    normals.push_back((x.col(b) - s).cross(x.col(c) - s));
    normals[0] += normals.back();
  }
  for (Vector3d& normal : normals) normal.normalize();
}

/// Whether the node is on the solid's side of the surface at the closest point: by the sum of the normals there, each
/// with its triangle's angle (Bærentzen and Aanæs, IEEE Transactions on Visualization and Computer Graphics 11, 2005).
/// No where that point is nearest among some of the triangles of one face alone.
bool SurfaceSearch::behind(NodeVectorsView x, const Vector3d& s, std::int32_t triangle, const Closest& closest) const {
  if (closest.free == 2) return closest.r.dot(closest.normal) < 0;
  const auto& own = cornersOf(triangle);
  const std::int32_t corner = own[closest.corner], end = own[(closest.corner + 1) % 3];
  Vector3d outward = Vector3d::Zero();
  for (const std::int32_t t : trianglesAt_.row(cornerPlace_[corner])) {
    const auto& at = cornersOf(t);
    const auto i = std::find(at.begin(), at.end(), corner) - at.begin();
    const std::int32_t next = at[(i + 1) % 3], last = at[(i + 2) % 3];
    if (closest.free == 1 && next != end && last != end) continue;
    const Vector3d origin = x.col(corner), e1 = x.col(next) - origin, e2 = x.col(last) - origin;
    const Vector3d normal = e1.cross(e2);
    const double area = normal.norm();
    if (!(area > 0)) continue;
    outward += (closest.free == 1 ? 1 : std::atan2(area, e1.dot(e2))) / area * normal;
    if (normal.dot(closest.normal) > oneFace * area * closest.normal.norm() &&
        closestPoint(s, origin, x.col(next), x.col(last)).distance2 < (1 - sameDistance) * closest.distance2)
      return false;
  }
  return closest.r.dot(outward) < 0;
}

void SurfaceSearch::addTouch(NodeVectorsView x, std::int32_t entry, std::int32_t triangle, const Closest& closest,
                             std::vector<Touch>& touching) const {
  Touch touch;
  touch.entry = entry;
  touch.triangle = triangle;
  touch.otherEdge = -1;
  touch.penalty = contact_.penalty[entry];
  touch.damping = contact_.damping[entry];
  const auto& at = contact_.triangles[triangle];
  touch.nodes = {contact_.nodes[entry], at[0], at[1], at[2]};
  touch.b = {1, -closest.w[0], -closest.w[1], -closest.w[2]};
  touch.r = closest.r;
  touch.depth = std::sqrt(closest.distance2);
  touch.normal = closest.free == 2 ? Vector3d(closest.normal.normalized()) : Vector3d(-closest.r / touch.depth);
  touch.base.fill(closest.free == 2 ? 1 : closest.corner + 1);
  touch.to = {0, 0};
  if (closest.free == 2) touch.to = {2, 3};
  if (closest.free == 1) touch.to = {(closest.corner + 1) % 3 + 1, 0};
  touch.setDirections(x, closest.free);
  touching.push_back(touch);
}

void SurfaceSearch::look(NodeVectorsView x, std::size_t row, double reach, Found& result) {
  const double path = motion_.pathTo(rowCell_[row]), from = motion_.pathFrom(rowCell_[row]),
               cutoff = deepest_ + 2 * reach;
  const std::int32_t entry = rows_[row];
  const std::int32_t node = contact_.nodes[entry];
  const Vector3d s = x.col(node);
  const std::size_t first = candidates_.offsets[row];
  const auto candidates = candidates_.row(row);
  thread_local std::vector<Vector3d> own;
  own.clear();
  const auto closestTo = [&](std::int32_t i) {
    const auto& at = cornersOf(candidates[i]);
    const Closest closest = closestPoint(s, x.col(at[0]), x.col(at[1]), x.col(at[2]));
    until_[first + i] = std::sqrt(closest.distance2) + from;
    ++result.pairs;
    return closest;
  };
  const auto counts = [&](const Closest& closest) {
    if (!(closest.distance2 <= cutoff * cutoff)) return false;
    if (own.empty()) normalsAt(x, entry, own);
    const double most = -against * closest.normal.norm();
    return std::ranges::any_of(own, [&](const Vector3d& normal) { return normal.dot(closest.normal) < most; });
  };
  // The one that was nearest last tells which of the others can be nearest, or as near to within twice the reach.
  double limit = cutoff;
  std::optional<Closest> last;
  if (const std::int32_t i = rowNearest_[row]; i >= 0) {
    last = closestTo(i);
    if (counts(*last)) limit = std::min(limit, std::sqrt(last->distance2) + 2 * reach);
  }
  struct Candidate {
    std::int32_t i;
    Closest closest;
  };
  thread_local std::vector<Candidate> found;
  found.clear();
  int best = -1;
  Candidate nearestOfAll{-1, {}};
  // Of the same distance, a face before an edge before a corner, whose tangents are those of kinks.
  const auto isNearer = [](const Closest& one, const Closest& known) {
    return one.distance2 < (1 - sameDistance) * known.distance2 ||
           (one.distance2 <= (1 + sameDistance) * known.distance2 && one.free > known.free);
  };
  // Without a branch: most wait.
  thread_local std::vector<std::int32_t> chosen;
  chosen.resize(candidates.size());
  std::size_t chosenCount = 0;
  double until = infinity;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const double lasts = until_[first + i];
    const bool waits = lasts - path > limit + rounding_;
    until = std::min(until, waits ? lasts : infinity);
    chosen[chosenCount] = static_cast<std::int32_t>(i);
    chosenCount += !waits;
  }
  for (std::size_t n = 0; n < chosenCount; ++n) {
    const std::int32_t i = chosen[n];
    const Closest closest = last && i == rowNearest_[row] ? *last : closestTo(i);
    until = std::min(until, until_[first + i]);
    if (nearestOfAll.i < 0 || isNearer(closest, nearestOfAll.closest)) nearestOfAll = {i, closest};
    if (!counts(closest)) continue;
    found.push_back({i, closest});
    if (best < 0 || isNearer(closest, found[best].closest)) best = static_cast<int>(found.size()) - 1;
  }
  rowUntil_[row] = until;
  rowNearest_[row] = best < 0 ? -1 : found[best].i;
  if (best < 0) return;
  const Closest &inFront = nearestOfAll.closest, &seen = found[best].closest;
  const double least = std::sqrt(seen.distance2);
  const std::int32_t nearest = candidates[found[best].i];
  const auto touched = static_cast<std::int32_t>(contact_.triangles.size());
  const auto depthOf = [&](std::int32_t t) { return std::min(contact_.depth[t], contact_.nodeDepth[entry]); };
  // In front of a face that it does not see it is outside, or at a rim that is flush with that face.
  const auto isBeside = [&] {
    const double cosine = flush * inFront.normal.norm();
    return inFront.distance2 < beside * beside * seen.distance2 &&
           std::ranges::any_of(own, [&](const Vector3d& normal) { return normal.dot(inFront.normal) > cosine; });
  };
  const bool touches = nearest < touched && least > 0 && least <= depthOf(nearest) && behind(x, s, nearest, seen) &&
                       (!(inFront.distance2 < (1 - sameDistance) * seen.distance2) || isBeside() ||
                        behind(x, s, candidates[nearestOfAll.i], inFront));
  if (touches) addTouch(x, entry, nearest, seen, result.touching);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Closest& closest = found[i].closest;
    const std::int32_t t = candidates[found[i].i];
    if (t >= touched) continue;
    const double distance = std::sqrt(closest.distance2);
    const bool isBehind = closest.r.dot(closest.normal) < 0, touchesThis = touches && static_cast<int>(i) == best;
    if (!touchesThis && (!(distance <= least + 2 * reach) || !(distance <= (isBehind ? depthOf(t) + reach : reach))))
      continue;
    Near one{entry, t, isBehind ? distance : 0, {}};
    const double wander = std::sqrt((distance + 2 * reach) * (distance + 2 * reach) - closest.distance2);
    const auto& at = contact_.triangles[t];
    const double area = closest.normal.norm();
    for (int c = 0; c < 3; ++c) {
      const double opposite = (x.col(at[(c + 1) % 3]) - x.col(at[(c + 2) % 3])).norm();
      const double more = wander > 0 ? wander * opposite / area : 0;
      one.weight[c] = std::min(1.0, std::max(0.0, closest.w[c]) + more);
    }
    result.near.push_back(one);
  }
}

void SurfaceSearch::locate(NodeVectorsView x, double reach, int threads) {
  const std::size_t count = nodes_.size();
  const auto isAt = [&](std::size_t i) {
    const double *one = x.data() + 3 * static_cast<std::ptrdiff_t>(nodes_[i]), *known = at_.data() + 4 * i;
    return one[0] == known[0] && one[1] == known[1] && one[2] == known[2];
  };
  std::size_t same = 0;
  if (located_ && reach == reach_)
    while (same < count && isAt(same)) ++same;
  if (located_ && reach == reach_ && same == count) return;
  at_.resize(4, static_cast<Eigen::Index>(count));
  std::array<double, 3> sum{};  // not finite where a coordinate is not
  for (std::size_t i = 0; i < count; ++i) {
    // Number by number: a column that is put together first and read whole waits for its parts.
    const double* one = x.data() + 3 * static_cast<std::ptrdiff_t>(nodes_[i]);
    double* at = at_.data() + 4 * i;
    for (int c = 0; c < 3; ++c) {
      at[c] = one[c];
      sum[c] += 0 * one[c];
    }
    at[3] = 0;
  }
  reach_ = reach;
  located_ = true;
  touching_.clear();
  near_.clear();
  nearEdges_.clear();
  ++statistics_.looks;
  if (!std::isfinite(sum[0] + sum[1] + sum[2])) {
    motion_.forget();
    return;
  }
  if (motion_.started()) motion_.move(at_, threads);
  if (!listsServe(reach, threads)) makeLists(x, reach, threads);
  constexpr std::int64_t length = 64;
  const std::int64_t rows = static_cast<std::int64_t>(rows_.size()), parts = (rows + length - 1) / length;
  std::vector<Found> found(parts);
  const double waits = deepest_ + 2 * reach + rounding_;
  parallelFor(
      0, parts, threads,
      [&](std::int64_t p) {
        for (std::int64_t row = p * length; row < std::min(rows, (p + 1) * length); ++row)
          if (!(rowUntil_[row] - motion_.pathTo(rowCell_[row]) > waits))
            look(x, static_cast<std::size_t>(row), reach, found[p]);
      },
      2);
  for (const Found& part : found) {
    touching_.insert(touching_.end(), part.touching.begin(), part.touching.end());
    near_.insert(near_.end(), part.near.begin(), part.near.end());
    statistics_.pairs += part.pairs;
  }
  Found ofEdges;
  for (std::size_t row = 0; row < edgeRows_.size(); ++row) lookAtEdges(x, row, reach, ofEdges);
  touching_.insert(touching_.end(), ofEdges.touching.begin(), ofEdges.touching.end());
  nearEdges_ = std::move(ofEdges.nearEdges);
  statistics_.edgePairs += ofEdges.pairs;
}

}  // namespace ringwatch

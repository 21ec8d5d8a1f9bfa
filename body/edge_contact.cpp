// Edges against edges: the part of SurfaceSearch that finds them.
#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <unsupported/Eigen/BVH>

#include <ringwatch/base/infinity.h>
#include <ringwatch/base/parallel.h>
#include <ringwatch/body/surface_contact.h>

namespace ringwatch {
namespace {

using Eigen::Vector3d;

/// Sine of the angle of two edges below which they do not touch: their common normal turns fast.
constexpr double parallel = 0.05;
/// And below which their closest points are those of their ends: others are off by more than rounding.
constexpr double parallelByRounding = 1e-7;
/// Shares by which a closest point is beyond an end by rounding alone.
constexpr double beyondByRounding = 1e-10;

using EdgeBox = Eigen::AlignedBox3d;
using EdgeTree = Eigen::KdBVH<double, 3, int>;

/// Collects the boxes that are as near to one.
struct BoxQuery {
  EdgeBox own;
  double distance2;
  const std::vector<EdgeBox>& boxes;
  const std::vector<int>& numbers;
  std::vector<std::int32_t>& found;
  bool intersectVolume(const EdgeBox& box) const { return box.squaredExteriorDistance(own) <= distance2; }
  bool intersectObject(int edge) const {
    if (intersectVolume(boxes[edge])) found.push_back(numbers[edge]);
    return false;
  }
};

/// Whether a direction across an edge is between the normals of its triangles, at an edge that points outwards, and the
/// opposite one is into the solid.
bool pointsOut(const std::array<Vector3d, 2>& normals, const Vector3d& edge, const Vector3d& direction) {
  return normals[0].cross(normals[1]).dot(edge) > 0 && normals[0].cross(direction).dot(edge) >= 0 &&
         direction.cross(normals[1]).dot(edge) >= 0 && normals[0].dot(direction) >= 0 && normals[1].dot(direction) >= 0;
}

}  // namespace

SurfaceSearch::ClosestOfEdges SurfaceSearch::closestPoints(const Vector3d& a, const Vector3d& b, const Vector3d& c,
                                                           const Vector3d& d) {
  const Vector3d first = b - a, second = d - c, between = a - c;
  ClosestOfEdges result{infinity, 0, 0, Vector3d::Zero(), first.cross(second), false};
  const double length2 = first.squaredNorm(), other2 = second.squaredNorm(), cross2 = result.cross.squaredNorm();
  if (cross2 > parallelByRounding * parallelByRounding * length2 * other2) {
    // |between + s first - t second| is least where that is across both.
    const double s = second.cross(between).dot(result.cross) / cross2, t = (between + s * first).dot(second) / other2;
    const auto isInside = [](double share) { return share >= -beyondByRounding && share <= 1 + beyondByRounding; };
    if (isInside(s) && isInside(t)) {
      result.s = s;
      result.t = t;
      result.r = between + s * first - t * second;
      result.distance2 = result.r.squaredNorm();
      result.inside = true;
      return result;
    }
  }
  // Else an end of one of them is closest.
  const auto take = [&](double s, double t) {
    const Vector3d r = between + s * first - t * second;
    if (!(r.squaredNorm() < result.distance2)) return;
    result.distance2 = r.squaredNorm();
    result.s = s;
    result.t = t;
    result.r = r;
  };
  const auto share = [](double along, double length) {
    return length > 0 ? std::clamp(along / length, 0.0, 1.0) : 0.0;
  };
  for (const double s : {0.0, 1.0}) take(s, share((between + s * first).dot(second), other2));
  for (const double t : {0.0, 1.0}) take(share((t * second - between).dot(first), length2), t);
  return result;
}

std::array<Vector3d, 2> SurfaceSearch::normalsAt(NodeVectorsView x, const SurfaceContact::Edge& edge) const {
  const Vector3d a = x.col(edge.nodes[0]), along = x.col(edge.nodes[1]) - a;
  return {along.cross(x.col(edge.third[0]) - a), (x.col(edge.third[1]) - a).cross(along)};
}

void SurfaceSearch::makeEdgeLists(NodeVectorsView x, int threads) {
  edgeRows_.clear();
  edgeRowCell_.clear();
  edgeCandidates_ = {};
  edgeUntil_.clear();
  edgeRowUntil_.clear();
  std::vector<EdgeBox> boxes;
  std::vector<int> numbers, places;
  for (std::size_t e = 0; e < contact_.edges.size(); ++e) {
    if (!contact_.edges[e].touched) continue;
    EdgeBox box;
    for (const std::int32_t node : contact_.edges[e].nodes) box.extend(Vector3d(x.col(node)));
    places.push_back(static_cast<int>(boxes.size()));
    boxes.push_back(box);
    numbers.push_back(static_cast<int>(e));
  }
  if (boxes.empty()) return;
  const EdgeTree tree(places.begin(), places.end(), boxes.begin(), boxes.end());
  const auto entryOf = [&](std::int32_t node) {
    return std::lower_bound(contact_.nodes.begin(), contact_.nodes.end(), node) - contact_.nodes.begin();
  };
  std::vector<std::vector<std::int32_t>> found(contact_.edges.size());
  parallelFor(
      0, static_cast<std::int64_t>(contact_.edges.size()), threads,
      [&](std::int64_t e) {
        const SurfaceContact::Edge& own = contact_.edges[e];
        if (!own.touches) return;
        EdgeBox box;
        for (const std::int32_t node : own.nodes) box.extend(Vector3d(x.col(node)));
        BoxQuery query{box, edgeListed_ * edgeListed_, boxes, numbers, found[e]};
        Eigen::BVIntersect(tree, query);
        std::erase_if(found[e], [&](std::int32_t o) {
          const SurfaceContact::Edge& other = contact_.edges[o];
          // Of two that both touch and are touched the first one has the pair.
          if (o == e || (o < e && own.touched && other.touches)) return true;
          for (const std::int32_t node : own.nodes) {
            const auto near = contact_.neighbours.row(entryOf(node));
            for (const std::int32_t end : other.nodes)
              if (end == node || std::binary_search(near.begin(), near.end(), end)) return true;
          }
          return false;
        });
        std::sort(found[e].begin(), found[e].end());
      },
      64);
  for (std::size_t e = 0; e < found.size(); ++e) {
    if (found[e].empty()) continue;
    edgeRows_.push_back(static_cast<std::int32_t>(e));
    const auto place = std::lower_bound(nodes_.begin(), nodes_.end(), contact_.edges[e].nodes[0]) - nodes_.begin();
    edgeRowCell_.push_back(motion_.cellOf(static_cast<std::size_t>(place)));
    edgeCandidates_.values.insert(edgeCandidates_.values.end(), found[e].begin(), found[e].end());
    edgeCandidates_.offsets.push_back(edgeCandidates_.values.size());
  }
  edgeUntil_.assign(edgeCandidates_.values.size(), 0);
  edgeRowUntil_.assign(edgeRows_.size(), 0);
}

void SurfaceSearch::lookAtEdges(NodeVectorsView x, std::size_t row, double reach, Found& found) {
  const double path = motion_.pathTo(edgeRowCell_[row]), from = motion_.pathFrom(edgeRowCell_[row]),
               waits = deepestEdge_ + reach + rounding_;
  if (edgeRowUntil_[row] - path > waits) return;
  const SurfaceContact::Edge& own = contact_.edges[edgeRows_[row]];
  const auto candidates = edgeCandidates_.row(row);
  const std::size_t first = edgeCandidates_.offsets[row];
  double until = infinity;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    double& lasts = edgeUntil_[first + i];
    if (!(lasts - path > waits)) {
      const SurfaceContact::Edge& other = contact_.edges[candidates[i]];
      const ClosestOfEdges closest =
          closestPoints(x.col(own.nodes[0]), x.col(own.nodes[1]), x.col(other.nodes[0]), x.col(other.nodes[1]));
      ++found.pairs;
      lasts = std::sqrt(closest.distance2) + from;
      addEdges(x, edgeRows_[row], candidates[i], closest, reach, found);
    }
    until = std::min(until, lasts);
  }
  edgeRowUntil_[row] = until;
}

/// Two edges touch where the vector between them is against both surfaces: from the second to the first within the
/// directions that point out of the first, and back within those that point out of the second.
void SurfaceSearch::addEdges(NodeVectorsView x, std::int32_t edge, std::int32_t otherEdge,
                             const ClosestOfEdges& closest, double reach, Found& found) const {
  const SurfaceContact::Edge &own = contact_.edges[edge], &other = contact_.edges[otherEdge];
  const double depth = std::min(own.depth, other.depth), distance = std::sqrt(closest.distance2);
  if (!(distance <= depth + reach)) return;
  const std::array<Vector3d, 2> normals = normalsAt(x, own), others = normalsAt(x, other);
  const Vector3d along = x.col(own.nodes[1]) - x.col(own.nodes[0]),
                 across = x.col(other.nodes[1]) - x.col(other.nodes[0]);
  const double area = closest.cross.norm(), length = along.norm(), otherLength = across.norm();
  const bool touches = closest.inside && area > parallel * length * otherLength && distance > 0 && distance <= depth &&
                       pointsOut(normals, along, closest.r) && pointsOut(others, across, -closest.r);
  // Directions of the cone of an edge have with the sum of its unit normals at least half of that one's square; half of
  // it leaves room to turn.
  const auto isNearCone = [&](const std::array<Vector3d, 2>& of, const Vector3d& direction) {
    const Vector3d sum = of[0].normalized() + of[1].normalized();
    return direction.dot(sum) > 0.25 * sum.squaredNorm() * distance;
  };
  // Their lines pass each other between the ends, or by twice the reach beyond them.
  const Vector3d between = x.col(own.nodes[0]) - x.col(other.nodes[0]);
  const double ofLines = area > 0 ? std::abs(between.dot(closest.cross)) / area : 0;
  const bool pass = closest.inside || closest.distance2 <= ofLines * ofLines + 4 * reach * reach;
  const bool behind = touches || (pass && isNearCone(normals, closest.r) && isNearCone(others, -closest.r));
  if (!behind && !(distance <= reach)) return;
  const double penalty = std::min(own.penalty, other.penalty), damping = std::min(own.damping, other.damping);
  NearEdges near{{edge, otherEdge},
                 penalty,
                 damping,
                 std::clamp(own.mass / other.mass, SurfaceContact::leastSplit, SurfaceContact::largestSplit),
                 behind ? distance : 0,
                 {1 - closest.s, closest.s, 1 - closest.t, closest.t}};
  // How far the closest points can wander along the edges.
  const double wander = std::sqrt((distance + 2 * reach) * (distance + 2 * reach) - closest.distance2);
  for (int c = 0; c < 4; ++c) {
    const double more = wander > 0 ? wander * (c < 2 ? otherLength : length) / area : 0;
    near.weight[c] = std::min(1.0, std::max(0.0, near.weight[c]) + more);
  }
  found.nearEdges.push_back(near);
  if (!touches) return;
  Touch touch;
  touch.entry = edge;
  touch.triangle = -1;
  touch.otherEdge = otherEdge;
  touch.penalty = penalty;
  touch.damping = damping;
  touch.nodes = {own.nodes[0], own.nodes[1], other.nodes[0], other.nodes[1]};
  touch.b = {1 - closest.s, closest.s, closest.t - 1, -closest.t};
  touch.r = closest.r;
  touch.depth = distance;
  touch.normal = (closest.cross.dot(closest.r) > 0 ? -1 : 1) * closest.cross / area;
  // Against the first one, and along the second one, as the closest points have these signs in r.
  touch.base = {1, 2};
  touch.to = {0, 3};
  touch.setDirections(x, 2);
  found.touching.push_back(touch);
}

}  // namespace ringwatch

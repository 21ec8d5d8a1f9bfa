#include <ringwatch/meshes/quality.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include <Eigen/Dense>

#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/number_format.h>
#include <ringwatch/meshes/jacobian.h>

namespace ringwatch {

JacobianProbe::JacobianProbe(const ElementInfo& info, JacobianPoints where) : nodes_(info.nodes) {
  const auto add = [&](const double xi[3], double weight) {
    Point point{std::vector<double>(static_cast<std::size_t>(3 * nodes_)), weight};
    info.shapeGradient(xi, reinterpret_cast<double(*)[3]>(point.gradient.data()));
    Eigen::Matrix3d J = Eigen::Matrix3d::Zero();
    for (int a = 0; a < nodes_; ++a)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) J(i, j) += info.referenceNodes[a][i] * point.gradient[3 * a + j];
    // An isoparametric element maps its own reference to itself; where it does not, the map is singular.
    if (weight != 0 || std::abs(J.determinant() - 1) < 1e-6) points_.push_back(std::move(point));
  };
  for (const QuadraturePoint& q : info.rules[0].points) add(q.xi, q.weight);
  if (info.constantGradient) return;
  std::set<int> corners;
  for (const auto& face : info.faces)
    for (const int corner : face)
      if (corner >= 0) corners.insert(corner);
  using Places = std::set<std::array<double, 3>>;
  Places places;
  std::array<double, 3> middle{};
  for (const int corner : corners) {
    const auto& node = info.referenceNodes[corner];
    places.insert({node[0], node[1], node[2]});
    for (std::size_t k = 0; k < 3; ++k) middle[k] += node[k] / static_cast<double>(corners.size());
  }
  if (where == JacobianPoints::fine) {
    for (const auto& node : info.referenceNodes) places.insert({node[0], node[1], node[2]});
    for (int round = 0; round < 2; ++round) {
      const Places before = places;
      for (const auto& a : before)
        for (const auto& b : before) places.insert({(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2});
    }
  }
  places.insert(middle);
  for (const auto& place : places) add(place.data(), 0);
}

Eigen::Matrix3d JacobianProbe::jacobian(const Point& point, const NodeVectors& x, const std::int32_t* nodes) const {
  return jacobianOf(x, nodes, nodes_, point.gradient.data());
}

JacobianRange JacobianProbe::range(const NodeVectors& x, const std::int32_t* nodes) const {
  JacobianRange range{infinity, -infinity};
  for (const Point& point : points_) {
    const double det = jacobian(point, x, nodes).determinant();
    if (std::isnan(det)) return {det, det};
    range.min = std::min(range.min, det);
    range.max = std::max(range.max, det);
  }
  return range;
}

double JacobianProbe::volume(const NodeVectors& x, const std::int32_t* nodes) const {
  double sum = 0;
  for (const Point& point : points_)
    if (point.weight != 0) sum += point.weight * jacobian(point, x, nodes).determinant();
  return sum;
}

double JacobianProbe::minScaledJacobian(const NodeVectors& x, const std::int32_t* nodes) const {
  double least = infinity;
  for (const Point& point : points_) {
    const Eigen::Matrix3d J = jacobian(point, x, nodes);
    const double lengths = J.col(0).norm() * J.col(1).norm() * J.col(2).norm();
    least = std::min(least, lengths > 0 ? J.determinant() / lengths : 0.0);
  }
  return least;
}

namespace {

ElementQuality measure(const ElementInfo& info, const JacobianProbe& probe, const std::int32_t* nodes,
                       const NodeVectors& x) {
  ElementQuality q;
  const auto at = [&](int a) -> Eigen::Vector3d { return x.col(nodes[a]); };
  q.volume = probe.volume(x, nodes);
  q.minEdge = infinity;
  for (const auto& edge : info.edges) {
    const double length = (at(edge[1]) - at(edge[0])).norm();
    q.minEdge = std::min(q.minEdge, length);
    q.maxEdge = std::max(q.maxEdge, length);
  }
  double maxArea = 0, areaSum = 0;
  std::vector<Eigen::Vector3d> areas;  // outward, by half the cross product of the diagonals
  for (const auto& face : info.faces) {
    const Eigen::Vector3d a =
        face[3] < 0 ? Eigen::Vector3d(at(face[1]) - at(face[0])) : Eigen::Vector3d(at(face[2]) - at(face[0]));
    const Eigen::Vector3d b =
        face[3] < 0 ? Eigen::Vector3d(at(face[2]) - at(face[0])) : Eigen::Vector3d(at(face[3]) - at(face[1]));
    areas.push_back(a.cross(b) / 2);
    maxArea = std::max(maxArea, areas.back().norm());
    areaSum += areas.back().norm();
  }
  const bool tetrahedron = info.faces.size() == 4 && info.edges.size() == 6;
  q.minHeight = maxArea > 0 ? (tetrahedron ? 3 : 1) * std::abs(q.volume) / maxArea : 0;
  if (!tetrahedron) {
    q.minScaledJacobian = probe.minScaledJacobian(x, nodes);
    return q;
  }
  double corner[4] = {1, 1, 1, 1};
  for (const auto& edge : info.edges) {
    const double length = (at(edge[1]) - at(edge[0])).norm();
    corner[edge[0]] *= length;
    corner[edge[1]] *= length;
  }
  const double largest = *std::max_element(corner, corner + 4);
  q.minScaledJacobian = largest > 0 ? std::numbers::sqrt2 * 6 * q.volume / largest : 0;
  q.minDihedral = 180;
  q.maxDihedral = 0;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      // The angle inside is π minus the angle between the outward normals; atan2 keeps slivers exact.
      const double angle =
          180 - std::atan2(areas[i].cross(areas[j]).norm(), areas[i].dot(areas[j])) * 180 / std::numbers::pi;
      q.minDihedral = std::min(q.minDihedral, angle);
      q.maxDihedral = std::max(q.maxDihedral, angle);
    }
  // Circumradius from the products of opposite edges: with s half their sum, R = √(s(s−a)(s−b)(s−c)) / 6V.
  const auto length = [&](int a, int b) { return (at(a) - at(b)).norm(); };
  const double a = length(0, 1) * length(2, 3), b = length(0, 2) * length(1, 3), c = length(0, 3) * length(1, 2);
  const double s = (a + b + c) / 2, product = s * (s - a) * (s - b) * (s - c);
  const double volume = std::abs(q.volume);
  // 3 r / R = 3·(3V/ΣA)·(6V/√product)
  q.radiusRatio = product > 0 && areaSum > 0 ? 54 * volume * volume / (areaSum * std::sqrt(product)) : 0;
  return q;
}

/// Width of a tetrahedron and what lies closest in it.
struct TetrahedronWidth {
  double width;    // least of all heights and distances of opposite edges
  double flat;     // least of those whose foot or crossing lies inside; infinite without one
  bool edges;      // whether `flat` is a distance of edges
  double balance;  // and their shorter length over the longer
};
TetrahedronWidth tetrahedronWidth(const Eigen::Vector3d (&p)[4]) {
  TetrahedronWidth w{infinity, infinity, false, 1};
  for (int a = 0; a < 4; ++a) {
    const Eigen::Vector3d &o = p[(a + 1) % 4], u = p[(a + 2) % 4] - o, v = p[(a + 3) % 4] - o;
    const Eigen::Vector3d normal = u.cross(v), to = p[a] - o;
    const double area2 = normal.squaredNorm();
    if (!(area2 > 0)) continue;
    const double height = std::abs(to.dot(normal)) / std::sqrt(area2);
    w.width = std::min(w.width, height);
    // Barycentric coordinates of the foot
    const double s = to.cross(v).dot(normal) / area2, t = u.cross(to).dot(normal) / area2;
    if (s >= 0 && t >= 0 && s + t <= 1 && height < w.flat) w.flat = height, w.edges = false;
  }
  constexpr int pairs[3][4] = {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}};
  for (const auto& k : pairs) {
    const Eigen::Vector3d u = p[k[1]] - p[k[0]], v = p[k[3]] - p[k[2]], r = p[k[2]] - p[k[0]], n = u.cross(v);
    const double n2 = n.squaredNorm();
    if (!(n2 > 0)) continue;
    const double distance = std::abs(r.dot(n)) / std::sqrt(n2);
    w.width = std::min(w.width, distance);
    const double s = r.cross(v).dot(n) / n2, t = r.cross(u).dot(n) / n2;
    if (s < 0 || s > 1 || t < 0 || t > 1 || !(distance < w.flat)) continue;
    w.flat = distance;
    w.edges = true;
    w.balance = std::min(u.norm(), v.norm()) / std::max(u.norm(), v.norm());
  }
  return w;
}

ShapeClass tetrahedronClass(const Eigen::Vector3d (&p)[4], double shortest, double longest, bool isSmall) {
  constexpr double roundWidth = 0.2;
  const TetrahedronWidth w = tetrahedronWidth(p);
  if (w.width >= roundWidth * longest) return isSmall ? ShapeClass::small : ShapeClass::round;
  // A short edge also brings its neighbours' feet close: a flat shape must be clearly thinner than that.
  if (shortest > 2 * w.flat)
    return !w.edges ? ShapeClass::cap : w.balance < 0.5 ? ShapeClass::spindle : ShapeClass::sliver;
  int few = 0;
  for (int a = 0; a < 4; ++a)
    for (int b = a + 1; b < 4; ++b) few += (p[b] - p[a]).norm() <= std::sqrt(shortest * longest) ? 1 : 0;
  return few > 1 ? ShapeClass::needle : ShapeClass::wedge;
}

constexpr QualityMeasure measures[] = {{"volume", "m³", &ElementQuality::volume},
                                       {"min-height", "m", &ElementQuality::minHeight},
                                       {"min-edge", "m", &ElementQuality::minEdge},
                                       {"max-edge", "m", &ElementQuality::maxEdge},
                                       {"scaled-jacobian", "", &ElementQuality::minScaledJacobian},
                                       {"min-dihedral", "°", &ElementQuality::minDihedral},
                                       {"max-dihedral", "°", &ElementQuality::maxDihedral},
                                       {"radius-ratio", "", &ElementQuality::radiusRatio}};

}  // namespace

ElementQuality elementQuality(const MeshBlock& block, std::size_t e, const NodeVectors& x) {
  const ElementInfo& info = elementInfo(block.type);
  return measure(info, JacobianProbe(info), block.element(e), x);
}

std::string ElementShape::text() const {
  if (shape == ShapeClass::other)
    return joinText("dihedral angles ", std::round(minDihedral), "° to ", std::round(maxDihedral), "°, aspect ",
                    digitsOf(aspect, 2));
  if (shape == ShapeClass::round || shape == ShapeClass::small) return std::string(shapeName(shape));
  constexpr double sharp = 20;  // degrees; needles and wedges may have no sharp angle
  return minDihedral < sharp ? joinText(shapeName(shape), ", ", digitsOf(minDihedral, 2), "° dihedral")
                             : joinText(shapeName(shape), ", aspect ", digitsOf(aspect, 2));
}

ElementShape elementShape(const MeshBlock& block, std::size_t e, const NodeVectors& x, double meanVolume) {
  const ElementInfo& info = elementInfo(block.type);
  const std::int32_t* nodes = block.element(e);
  const auto at = [&](int a) -> Eigen::Vector3d { return x.col(nodes[a]); };
  ElementShape shape;
  shape.minDihedral = 180;
  double shortest = infinity, longest = 0;
  for (const auto& edge : info.edges) {
    const double length = (at(edge[1]) - at(edge[0])).norm();
    shortest = std::min(shortest, length);
    longest = std::max(longest, length);
    std::vector<Eigen::Vector3d> normals;  // of the two faces at this edge
    for (const auto& face : info.faces)
      if (std::count(face.begin(), face.end(), edge[0]) + std::count(face.begin(), face.end(), edge[1]) == 2)
        normals.push_back(face[3] < 0 ? (at(face[1]) - at(face[0])).cross(at(face[2]) - at(face[0])).eval()
                                      : (at(face[2]) - at(face[0])).cross(at(face[3]) - at(face[1])).eval());
    const double angle =
        180 - std::atan2(normals[0].cross(normals[1]).norm(), normals[0].dot(normals[1])) * 180 / std::numbers::pi;
    shape.minDihedral = std::min(shape.minDihedral, angle);
    shape.maxDihedral = std::max(shape.maxDihedral, angle);
  }
  shape.aspect = longest / shortest;
  if (info.faces.size() == 4) {
    const Eigen::Vector3d corners[4] = {at(0), at(1), at(2), at(3)};
    const double volume =
        std::abs((corners[1] - corners[0]).cross(corners[2] - corners[0]).dot(corners[3] - corners[0])) / 6;
    shape.shape = tetrahedronClass(corners, shortest, longest, volume < meanVolume / 8);
  }
  return shape;
}

std::vector<std::vector<ElementQuality>> meshQuality(const Mesh& mesh) { return meshQuality(mesh, mesh.X); }

std::vector<std::vector<ElementQuality>> meshQuality(const Mesh& mesh, const NodeVectors& x) {
  std::vector<std::vector<ElementQuality>> all;
  for (const MeshBlock& block : mesh.blocks) {
    const ElementInfo& info = elementInfo(block.type);
    const JacobianProbe probe(info);
    std::vector<ElementQuality>& rows = all.emplace_back();
    rows.reserve(block.elementCount());
    for (std::size_t e = 0; e < block.elementCount(); ++e) rows.push_back(measure(info, probe, block.element(e), x));
  }
  return all;
}

std::span<const QualityMeasure> qualityMeasures() { return measures; }

std::vector<QualitySummary> summarizeQuality(const std::vector<std::vector<ElementQuality>>& quality) {
  std::vector<QualitySummary> summaries;
  for (const QualityMeasure& m : measures) {
    QualitySummary s{m.name, m.unit, 0, 0, 0, 0, {}, {}};
    for (std::size_t b = 0; b < quality.size(); ++b)
      for (std::size_t e = 0; e < quality[b].size(); ++e) {
        const double value = quality[b][e].*m.member;
        if (std::isnan(value)) continue;
        const ElementRef ref{b, e};
        if (s.count == 0 || value < s.min) s.min = value, s.minElement = ref;
        if (s.count == 0 || value > s.max) s.max = value, s.maxElement = ref;
        s.mean += value;
        ++s.count;
      }
    if (s.count == 0) continue;
    s.mean /= static_cast<double>(s.count);
    summaries.push_back(std::move(s));
  }
  return summaries;
}

double meshVolume(const Mesh& mesh) {
  double sum = 0;
  for (const MeshBlock& block : mesh.blocks) {
    const JacobianProbe probe(elementInfo(block.type));
    for (std::size_t e = 0; e < block.elementCount(); ++e) sum += probe.volume(mesh.X, block.element(e));
  }
  return sum;
}

}  // namespace ringwatch

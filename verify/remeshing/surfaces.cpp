#include <ringwatch/verify/remeshing/surfaces.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include <Eigen/Geometry>

#include <ringwatch/base/error.h>
#include <ringwatch/base/random.h>
#include <ringwatch/meshes/adjacency.h>

namespace ringwatch::detail {
namespace {

using Eigen::Vector3d;
using Triangle = std::array<std::int32_t, 3>;

double angleAt(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const Vector3d u = b - a, v = c - a;
  return std::atan2(u.cross(v).norm(), u.dot(v));
}
double leastAngleOf(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  return std::min({angleAt(a, b, c), angleAt(b, c, a), angleAt(c, a, b)});
}

/// Triangles of directions that cover the sphere once: each is seen from the centre with its corners in the positive
/// sense.
class SphereTriangles {
 public:
  explicit SphereTriangles(int level) {
    const double g = std::numbers::phi;
    for (const auto& [a, b] : {std::pair{-1.0, g}, {1.0, g}, {-1.0, -g}, {1.0, -g}}) points_.emplace_back(a, b, 0);
    for (const auto& [a, b] : {std::pair{-1.0, g}, {1.0, g}, {-1.0, -g}, {1.0, -g}}) points_.emplace_back(0, a, b);
    for (const auto& [a, b] : {std::pair{g, -1.0}, {g, 1.0}, {-g, -1.0}, {-g, 1.0}}) points_.emplace_back(a, 0, b);
    for (Vector3d& p : points_) p.normalize();
    triangles_ = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                  {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                  {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    for (int k = 0; k < level; ++k) divide();
  }

  /// Moves every node by up to a share of its shortest edge, where its triangles stay as they should be.
  void shift(double share, Random& random) {
    const auto around = trianglesOfNodes();
    for (std::size_t n = 0; n < points_.size(); ++n) {
      double edge = 10;
      for (const std::size_t t : around[n])
        for (const std::int32_t m : triangles_[t])
          if (m != static_cast<std::int32_t>(n)) edge = std::min(edge, (points_[m] - points_[n]).norm());
      const Vector3d before = points_[n];
      for (double& c : points_[n]) c += share * edge * random.uniform(-1, 1);
      points_[n].normalize();
      if (!std::all_of(around[n].begin(), around[n].end(), [&](std::size_t t) { return sound(triangles_[t]); }))
        points_[n] = before;
    }
  }

  /// Collapses edges at random until `wanted` nodes are left.
  void decimate(std::size_t wanted, Random& random) {
    auto around = trianglesOfNodes();
    std::size_t left = points_.size();
    for (std::size_t tries = 0; left > wanted && tries < 200 * points_.size(); ++tries) {
      const auto gone = static_cast<std::int32_t>(random.index(static_cast<int>(points_.size())));
      if (around[gone].empty()) continue;
      const std::vector<std::size_t> own(around[gone].begin(), around[gone].end());
      const Triangle& first = triangles_[own[random.index(static_cast<int>(own.size()))]];
      const std::int32_t kept = first[0] == gone ? first[1] : first[0];
      if (commonNeighbours(around, gone, kept) != 2) continue;  // else two sheets would touch
      std::vector<std::size_t> vanish, move;
      for (const std::size_t t : own)
        (std::ranges::find(triangles_[t], kept) != triangles_[t].end() ? vanish : move).push_back(t);
      const bool stays = std::all_of(move.begin(), move.end(), [&](std::size_t t) {
        Triangle moved = triangles_[t];
        std::ranges::replace(moved, gone, kept);
        return sound(moved);
      });
      if (!stays) continue;
      for (const std::size_t t : vanish)
        for (const std::int32_t n : triangles_[t]) around[n].erase(t);
      for (const std::size_t t : move) {
        std::ranges::replace(triangles_[t], gone, kept);
        around[kept].insert(t);
      }
      around[gone].clear();
      for (const std::size_t t : vanish) triangles_[t] = {-1, -1, -1};
      --left;
    }
    std::erase_if(triangles_, [](const Triangle& t) { return t[0] < 0; });
  }

  template <class Map>
  TriangleSurface mapped(const Map& place) const {
    std::vector<std::int32_t> number(points_.size(), -1);
    std::vector<Vector3d> used;
    TriangleSurface surface;
    for (const Triangle& t : triangles_) {
      Triangle renumbered;
      for (int k = 0; k < 3; ++k) {
        if (number[t[k]] < 0) {
          number[t[k]] = static_cast<std::int32_t>(used.size());
          used.push_back(place(points_[t[k]]));
        }
        renumbered[k] = number[t[k]];
      }
      surface.triangles.push_back(renumbered);
    }
    surface.X.resize(3, static_cast<Eigen::Index>(used.size()));
    for (std::size_t n = 0; n < used.size(); ++n) surface.X.col(static_cast<Eigen::Index>(n)) = used[n];
    return surface;
  }

 private:
  using Around = std::vector<std::set<std::size_t>>;

  void divide() {
    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> middles;
    const auto middle = [&](std::int32_t a, std::int32_t b) {
      const auto [found, isNew] = middles.try_emplace(std::minmax(a, b), static_cast<std::int32_t>(points_.size()));
      if (isNew) points_.push_back((points_[a] + points_[b]).normalized());
      return found->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : triangles_) {
      const std::int32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    triangles_ = std::move(finer);
  }
  Around trianglesOfNodes() const {
    Around around(points_.size());
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (const std::int32_t n : triangles_[t]) around[n].insert(t);
    return around;
  }
  std::size_t commonNeighbours(const Around& around, std::int32_t a, std::int32_t b) const {
    const auto neighbours = [&](std::int32_t n) {
      std::set<std::int32_t> found;
      for (const std::size_t t : around[n])
        for (const std::int32_t m : triangles_[t])
          if (m != a && m != b) found.insert(m);
      return found;
    };
    const std::set<std::int32_t> ofA = neighbours(a), ofB = neighbours(b);
    return static_cast<std::size_t>(
        std::count_if(ofA.begin(), ofA.end(), [&](std::int32_t n) { return ofB.contains(n); }));
  }
  /// Badly shaped, but not flat: no angle below 5 degrees.
  bool sound(const Triangle& t) const {
    const Vector3d &a = points_[t[0]], &b = points_[t[1]], &c = points_[t[2]];
    return a.dot(b.cross(c)) > 0 && leastAngleOf(a, b, c) > 5 * std::numbers::pi / 180;
  }

  std::vector<Vector3d> points_;
  std::vector<Triangle> triangles_;
};

SphereTriangles scanned(int level, std::size_t nodes, std::uint64_t seed) {
  SphereTriangles sphere(level);
  Random random(seed);
  sphere.shift(0.4, random);
  sphere.decimate(nodes, random);
  return sphere;
}

}  // namespace

double enclosedVolume(const TriangleSurface& surface) {
  double volume = 0;
  for (const auto& [a, b, c] : surface.triangles)
    volume += surface.X.col(a).dot(Vector3d(surface.X.col(b)).cross(Vector3d(surface.X.col(c)))) / 6;
  return volume;
}

double leastAngle(const TriangleSurface& surface) {
  double least = std::numbers::pi;
  for (const auto& [a, b, c] : surface.triangles)
    least = std::min(least, leastAngleOf(surface.X.col(a), surface.X.col(b), surface.X.col(c)));
  return least * 180 / std::numbers::pi;
}

double meanEdge(const TriangleSurface& surface) {
  double sum = 0;
  for (const Triangle& t : surface.triangles)
    for (int k = 0; k < 3; ++k) sum += (surface.X.col(t[k]) - surface.X.col(t[(k + 1) % 3])).norm();
  return sum / static_cast<double>(3 * surface.triangles.size());
}

TriangleSurface boundarySurface(const Mesh& mesh, std::vector<std::int32_t>* nodes) {
  TriangleSurface surface;
  std::vector<std::int32_t> number(mesh.nodeCount(), -1), used;
  for (const ElementFace& face : boundaryFaces(mesh)) {
    const MeshBlock& block = mesh.blocks[face.block];
    const auto& corners = elementInfo(block.type).faces[face.face];
    if (block.type != ringwatch::elementTypeOf<Tet4>) throw InputError("a surface of triangles is made of tet4 alone");
    Triangle triangle{};
    for (int k = 0; k < 3; ++k) {
      const std::int32_t node = block.element(face.element)[corners[k]];
      if (number[node] < 0) {
        number[node] = static_cast<std::int32_t>(used.size());
        used.push_back(node);
      }
      triangle[k] = number[node];
    }
    surface.triangles.push_back(triangle);
  }
  surface.X.resize(3, static_cast<Eigen::Index>(used.size()));
  for (std::size_t n = 0; n < used.size(); ++n) surface.X.col(static_cast<Eigen::Index>(n)) = mesh.X.col(used[n]);
  if (nodes) *nodes = std::move(used);
  return surface;
}

TriangleSurface bumpyBall(int level, std::size_t nodes, std::uint64_t seed) {
  return scanned(level, nodes, seed).mapped([](const Vector3d& d) {
    return Vector3d(0.05 * (1 + std::sin(5 * d.x()) * std::sin(5 * d.y() + 1) * std::sin(5 * d.z() + 2) / 7) * d);
  });
}

TriangleSurface jack(int level, std::size_t nodes, std::uint64_t seed) {
  return scanned(level, nodes, seed).mapped([](const Vector3d& d) {
    const double along = d.array().pow(4).sum();  // an axis 1, a diagonal 1/3
    return Vector3d((0.02 + 0.075 * (along - 1 / 3.0)) * d);
  });
}

}  // namespace ringwatch::detail

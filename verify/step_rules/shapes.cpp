#include <ringwatch/verify/step_rules/shapes.h>

#include <array>
#include <cmath>

#include <Eigen/Dense>

#include <ringwatch/meshes/jacobian.h>

namespace ringwatch {
namespace {

/// Normal coordinates of n points: of the directions of 3n coordinates, which are the shapes with their places, all are
/// equally likely (Kendall 1984).
NodeVectors normalPoints(Random& random, int n) {
  NodeVectors points(3, n);
  for (Eigen::Index i = 0; i < points.size(); ++i) points.data()[i] = random.normal();
  return points;
}

NodeVectors anyTetrahedron(Random& random) { return normalPoints(random, 4); }

/// Flat and thin tetrahedra: four points of a plane or a line, from which the corners lie off by a normal distance of
/// at most a third and at least a thousandth of the size. After the kinds of Cheng, Dey, Edelsbrunner, Facello & Teng
/// 2000.
enum class Kind { sliver, cap, spade, wedge, spire, spear, spindle, spike, splinter };
constexpr std::array<std::array<std::array<double, 2>, 4>, 9> basesOfKinds{
    {{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}},                // around a circle
     {{{1, 0}, {-0.5, 0.87}, {-0.5, -0.87}, {0, 0}}},     // one inside a triangle
     {{{1, 0}, {-0.5, 0.87}, {-0.5, -0.87}, {-0.5, 0}}},  // one at the middle of a side
     {{{1, 0}, {-0.5, 0.87}, {-0.5, -0.87}, {1, 0}}},     // two at one corner
     {{{1, 0}, {1, 0}, {1, 0}, {-1, 0}}},                 // along a line: three and one
     {{{1, 0}, {0, 0}, {0, 0}, {-1, 0}}},                 // one, two, one
     {{{1, 0}, {1, 0}, {-1, 0}, {-1, 0}}},                // two and two
     {{{1, 0}, {1, 0}, {0, 0}, {-1, 0}}},                 // two, one, one
     {{{1, 0}, {0.33, 0}, {-0.33, 0}, {-1, 0}}}}};        // one by one

template <Kind kind>
NodeVectors badTetrahedron(Random& random) {
  const double off = std::pow(10, random.uniform(-3, -0.5));
  NodeVectors points = off * normalPoints(random, 4);
  for (int a = 0; a < 4; ++a)
    for (int c = 0; c < 2; ++c) points(c, a) += basesOfKinds[static_cast<std::size_t>(kind)][a][c];
  return points;
}

NodeVectors referenceNodesOf(std::string_view element) {
  const ElementInfo& info = *findElementByName(element);
  NodeVectors points(3, info.nodes);
  for (int a = 0; a < info.nodes; ++a)
    for (int c = 0; c < 3; ++c) points(c, a) = info.referenceNodes[static_cast<std::size_t>(a)][c];
  return points;
}

/// The reference element with its nodes moved and then mapped, both at random.
NodeVectors distorted(Random& random, std::string_view element) {
  const NodeVectors reference = referenceNodesOf(element);
  const double off = random.uniform(0, 0.4);
  const NodeVectors moved = reference + off * normalPoints(random, static_cast<int>(reference.cols()));
  Eigen::Matrix3d map;
  for (Eigen::Index i = 0; i < map.size(); ++i) map.data()[i] = random.normal();
  return map * moved;
}
NodeVectors anyHexahedron(Random& random) { return distorted(random, "hex8"); }
NodeVectors anyWedge(Random& random) { return distorted(random, "wedge6"); }
NodeVectors anyPyramid(Random& random) { return distorted(random, "pyramid5"); }

/// Edges of 1 to 1/100.
NodeVectors anyBox(Random& random) {
  Eigen::Vector3d edges;
  for (double& edge : edges) edge = std::pow(10, random.uniform(-2, 0));
  return edges.asDiagonal() * referenceNodesOf("hex8");
}

constexpr ShapeFamily families[] = {
    {"tetrahedra", "tet4", "", false, anyTetrahedron},
    {"slivers", "tet4", "", false, badTetrahedron<Kind::sliver>},
    {"caps", "tet4", "", false, badTetrahedron<Kind::cap>},
    {"spades", "tet4", "", false, badTetrahedron<Kind::spade>},
    {"flat wedges", "tet4", "", false, badTetrahedron<Kind::wedge>},
    {"spires", "tet4", "", false, badTetrahedron<Kind::spire>},
    {"spears", "tet4", "", false, badTetrahedron<Kind::spear>},
    {"spindles", "tet4", "", false, badTetrahedron<Kind::spindle>},
    {"spikes", "tet4", "", false, badTetrahedron<Kind::spike>},
    {"splinters", "tet4", "", false, badTetrahedron<Kind::splinter>},
    {"hexahedra", "hex8", "", false, anyHexahedron},
    {"hexahedra, one point", "hex8", "uniform-strain", false, anyHexahedron},
    {"boxes", "hex8", "", false, anyBox},
    {"wedges", "wedge6", "", false, anyWedge},
    {"pyramids", "pyramid5", "", false, anyPyramid},
    {"tetrahedra, stretched", "tet4", "", true, anyTetrahedron},
    {"hexahedra, stretched", "hex8", "", true, anyHexahedron},
    {"wedges, stretched", "wedge6", "", true, anyWedge},
    {"pyramids, stretched", "pyramid5", "", true, anyPyramid},
};

/// Whether the map from the reference element keeps its orientation at the corners and where the mass is integrated;
/// -1 where it turns it round at all of them.
int orientationOf(const ElementInfo& element, const NodeVectors& points) {
  constexpr std::array<std::int32_t, 8> order{0, 1, 2, 3, 4, 5, 6, 7};
  int positive = 0, negative = 0;
  const auto look = [&](const double* xi) {
    double dN[maxElementNodes][3];
    element.shapeGradient(xi, dN);
    const double det = jacobianOf(points, order.data(), element.nodes, dN[0]).determinant();
    positive += det > 0 ? 1 : 0;
    negative += det < 0 ? 1 : 0;
  };
  for (const QuadraturePoint& point : element.massRule.points) look(point.xi);
  // The map of a pyramid has no gradient at its tip.
  for (std::size_t a = 0; a < element.referenceNodes.size(); ++a)
    if (element.name != "pyramid5" || a < 4) look(element.referenceNodes[a].data());
  return negative == 0 ? 1 : positive == 0 ? -1 : 0;
}

/// A number of the seed's own sequence for each of its shapes.
Random randomOf(std::uint64_t seed) { return Random(0x9e3779b97f4a7c15ULL * (seed + 1)); }

}  // namespace

std::span<const ShapeFamily> shapeFamilies() { return families; }

Mesh meshOfShapes(const ShapeFamily& family, int count, std::uint64_t seed) {
  const ElementInfo& element = *findElementByName(family.element);
  Random random = randomOf(seed);
  Mesh mesh;
  mesh.X.resize(3, static_cast<Eigen::Index>(count) * element.nodes);
  mesh.blocks = {{element.type, {}, {}}};
  for (int e = 0; e < count;) {
    NodeVectors points = family.draw(random);
    const int orientation = orientationOf(element, points);
    if (orientation == 0) continue;
    if (orientation < 0) points.row(0) *= -1;
    mesh.X.middleCols(static_cast<Eigen::Index>(e) * element.nodes, element.nodes) = points;
    for (int a = 0; a < element.nodes; ++a) mesh.blocks[0].connectivity.push_back(e * element.nodes + a);
    ++e;
  }
  return mesh;
}

NodeVectors stretchedShapes(const Mesh& mesh, std::uint64_t seed) {
  Random random = randomOf(~seed);
  const int n = mesh.blocks[0].nodesPerElement();
  NodeVectors x = mesh.X;
  for (Eigen::Index e = 0; e < x.cols() / n; ++e) {
    Eigen::Matrix3d axes;
    for (Eigen::Index i = 0; i < axes.size(); ++i) axes.data()[i] = random.normal();
    const Eigen::Matrix3d Q = Eigen::HouseholderQR<Eigen::Matrix3d>(axes).householderQ();
    Eigen::Vector3d stretches;
    for (double& stretch : stretches) stretch = random.uniform(0.7, 1.4);
    x.middleCols(e * n, n) = Q * stretches.asDiagonal() * Q.transpose() * mesh.X.middleCols(e * n, n);
  }
  return x;
}

PlaneShape randomPlaneShape(int nodes, Random& random) {
  const auto corner = [&](const PlaneShape& shape, int a) {
    const Eigen::Vector2d here = shape.X.col(a), next = shape.X.col((a + 1) % shape.nodes) - here,
                          last = shape.X.col((a + shape.nodes - 1) % shape.nodes) - here;
    return next[0] * last[1] - next[1] * last[0];
  };
  while (true) {
    PlaneShape shape{nodes, {}};
    for (int a = 0; a < 4; ++a) shape.X.col(a) = Eigen::Vector2d(random.normal(), random.normal());
    int positive = 0;
    for (int a = 0; a < nodes; ++a) positive += corner(shape, a) > 0 ? 1 : 0;
    if (positive == 0) shape.X.row(0) *= -1;
    if (positive == 0 || positive == nodes) return shape;
  }
}

}  // namespace ringwatch

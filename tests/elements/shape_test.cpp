// Shape functions, faces and edges of every reference element in elements/registry.h, and of one that is added.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <ringwatch/base/dual.h>
#include <ringwatch/elements/registry.h>
#include <tests/added/wedge15.h>
#include <tests/support/random.h>
#include <tests/support/registry_types.h>

namespace ringwatch {
namespace {

template <class E>
class ElementTest : public ::testing::Test {
 public:
  using Point = Eigen::Vector3d;
  static Point node(int a) { return Point::Map(E::referenceNodes[a].data()); }
  static Point centre() {
    Point c = Point::Zero();
    for (int a = 0; a < E::nodes; ++a) c += node(a) / E::nodes;
    return c;
  }
  /// Points inside the element: convex combinations of its nodes.
  static std::vector<Point> insidePoints() {
    test::Random random(1);
    std::vector<Point> points{centre()};
    for (int i = 0; i < 50; ++i) {
      Eigen::VectorXd w = Eigen::VectorXd::NullaryExpr(E::nodes, [&] { return random.uniform(0.01, 1); });
      w /= w.sum();
      Point p = Point::Zero();
      for (int a = 0; a < E::nodes; ++a) p += w[a] * node(a);
      points.push_back(p);
    }
    return points;
  }
  static Eigen::VectorXd shape(const Point& p) {
    Eigen::VectorXd N(E::nodes);
    E::shape(p.data(), N.data());
    return N;
  }
  static Eigen::MatrixXd gradient(const Point& p) {
    double dN[E::nodes][3];
    E::shapeGradient(p.data(), dN);
    return Eigen::Map<Eigen::Matrix<double, E::nodes, 3, Eigen::RowMajor>>(&dN[0][0]);
  }
  static std::vector<int> faceNodes(std::size_t face) {
    std::vector<int> nodes;
    for (int a : E::faces[face])
      if (a >= 0) nodes.push_back(a);
    return nodes;
  }
};
/// Those of the library, and one that is added.
template <class... Es>
TypeList<Es..., test::Wedge15> withAdded(TypeList<Es...>);
using TestedElements = decltype(withAdded(Elements{}));
TYPED_TEST_SUITE(ElementTest, test::TestTypesOf<TestedElements>, test::RegistryNames);

TYPED_TEST(ElementTest, ShapeIsOneAtItsNodeAndZeroAtTheOthers) {
  for (int b = 0; b < TypeParam::nodes; ++b) {
    const Eigen::VectorXd N = this->shape(this->node(b));
    for (int a = 0; a < TypeParam::nodes; ++a) EXPECT_NEAR(N[a], a == b ? 1 : 0, 1e-15) << a << " at " << b;
  }
}

TYPED_TEST(ElementTest, ShapesSumToOneAndTheirGradientsToZero) {
  for (const auto& p : this->insidePoints()) {
    EXPECT_NEAR(this->shape(p).sum(), 1, 1e-14);
    EXPECT_LE(this->gradient(p).colwise().sum().norm(), 1e-14);
  }
}

TYPED_TEST(ElementTest, ShapesReproduceLinearFields) {
  for (const auto& p : this->insidePoints()) {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    Eigen::Matrix3d jacobian = Eigen::Matrix3d::Zero();
    const Eigen::VectorXd N = this->shape(p);
    const Eigen::MatrixXd dN = this->gradient(p);
    for (int a = 0; a < TypeParam::nodes; ++a) {
      position += N[a] * this->node(a);
      jacobian += this->node(a) * dN.row(a);
    }
    EXPECT_LE((position - p).norm(), 1e-14);
    EXPECT_LE((jacobian - Eigen::Matrix3d::Identity()).norm(), 1e-14);
  }
}

TYPED_TEST(ElementTest, GradientIsTheDerivativeOfTheShape) {
  for (const auto& p : this->insidePoints()) {
    const Eigen::MatrixXd dN = this->gradient(p);
    for (int j = 0; j < 3; ++j) {
      const Dual xi[3] = {{p[0], j == 0 ? 1.0 : 0.0}, {p[1], j == 1 ? 1.0 : 0.0}, {p[2], j == 2 ? 1.0 : 0.0}};
      Dual N[TypeParam::nodes];
      TypeParam::shape(xi, N);
      for (int a = 0; a < TypeParam::nodes; ++a) EXPECT_NEAR(dN(a, j), N[a].derivative, 1e-14) << a << " " << j;
    }
  }
}

TYPED_TEST(ElementTest, ConstantGradientIsClaimedRightly) {
  bool constant = true;
  for (const auto& p : this->insidePoints())
    constant = constant && (this->gradient(p) - this->gradient(this->centre())).norm() < 1e-14;
  EXPECT_EQ(constant, TypeParam::constantGradient);
}

TYPED_TEST(ElementTest, FacesCloseTheElementAndPointOutward) {
  std::map<std::pair<int, int>, int> directedEdges;
  double sixVolumes = 0;
  for (std::size_t f = 0; f < TypeParam::faces.size(); ++f) {
    const std::vector<int> nodes = this->faceNodes(f);
    ASSERT_GE(nodes.size(), 3u);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      ASSERT_LT(nodes[i], TypeParam::nodes);
      ++directedEdges[{nodes[i], nodes[(i + 1) % nodes.size()]}];
    }
    for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
      const Eigen::Vector3d a = this->node(nodes[0]), b = this->node(nodes[i]), c = this->node(nodes[i + 1]);
      const Eigen::Vector3d normal = (b - a).cross(c - a);
      EXPECT_GT(normal.dot(a - this->centre()), 0) << "face " << f;
      sixVolumes += a.dot(normal);
    }
  }
  // Closed: each edge once in either direction, so that neighbouring faces agree.
  for (const auto& [edge, count] : directedEdges) {
    EXPECT_EQ(count, 1) << edge.first << "-" << edge.second;
    EXPECT_EQ(directedEdges.count({edge.second, edge.first}), 1u) << edge.first << "-" << edge.second;
  }
  EXPECT_NEAR(sixVolumes / 6, TypeParam::referenceVolume, 1e-14);  // divergence theorem
}

TYPED_TEST(ElementTest, TrianglesAreFilledWithMinusOneAtTheEnd) {
  for (const auto& face : TypeParam::faces)
    for (std::size_t i = 0; i < 3; ++i) EXPECT_GE(face[i], 0);
}

TYPED_TEST(ElementTest, EdgesAreDistinctAndThoseOfTheFaces) {
  std::set<std::pair<int, int>> edges, ofFaces;
  for (const auto& [a, b] : TypeParam::edges) {
    EXPECT_NE(a, b);
    EXPECT_TRUE(edges.insert(std::minmax(a, b)).second) << a << "-" << b << " twice";
  }
  for (std::size_t f = 0; f < TypeParam::faces.size(); ++f) {
    const std::vector<int> nodes = this->faceNodes(f);
    for (std::size_t i = 0; i < nodes.size(); ++i) ofFaces.insert(std::minmax(nodes[i], nodes[(i + 1) % nodes.size()]));
  }
  EXPECT_EQ(edges, ofFaces);
  // Euler: corners - edges + faces = 2.
  const ElementInfo info = elementInfoOf<TypeParam>(ElementType{});
  EXPECT_EQ(cornerCount(info) - static_cast<int>(edges.size()) + static_cast<int>(TypeParam::faces.size()), 2);
}

TYPED_TEST(ElementTest, NodesBeyondTheCornersAreTheMiddlesOfTheEdgesInOrder) {
  const int corners = cornerCount(elementInfoOf<TypeParam>(ElementType{}));
  for (int a = corners; a < TypeParam::nodes; ++a) {
    const auto& ends = TypeParam::edges[a - corners];
    EXPECT_EQ((this->node(ends[0]) + this->node(ends[1])) / 2, this->node(a)) << a;
  }
  for (const auto& face : TypeParam::faces)
    for (const int a : face) EXPECT_LT(a, corners);
}

TYPED_TEST(ElementTest, QuadraticShapesReproduceQuadraticFields) {
  if (TypeParam::order < 2) GTEST_SKIP() << "linear";
  for (const auto& p : this->insidePoints()) {
    const Eigen::VectorXd N = this->shape(p);
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j) {
        double value = 0;
        for (int a = 0; a < TypeParam::nodes; ++a) value += N[a] * this->node(a)[i] * this->node(a)[j];
        EXPECT_NEAR(value, p[i] * p[j], 1e-14) << i << " " << j;
      }
  }
}

TYPED_TEST(ElementTest, JacobianOfTheReferenceElementIsPositive) {
  for (const auto& p : this->insidePoints()) {
    Eigen::Matrix3d jacobian = Eigen::Matrix3d::Zero();
    const Eigen::MatrixXd dN = this->gradient(p);
    for (int a = 0; a < TypeParam::nodes; ++a) jacobian += this->node(a) * dN.row(a);
    EXPECT_GT(jacobian.determinant(), 0);
  }
}

}  // namespace
}  // namespace ringwatch

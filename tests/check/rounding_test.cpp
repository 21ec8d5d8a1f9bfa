// The rounding budget of docs/theory/floating_point.md against ball arithmetic of 128 bits and more, for every element,
// rule and law: flat and thin elements in any orientation, near the origin and far from it, in units far apart, nearly
// incompressible, near inversion. RINGWATCH_ROUNDING_TRIALS=N tries N cases of each, and prints the table of that page.
#include <cstdlib>
#include <iostream>

#include <gtest/gtest.h>

#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/monitor/bounds/nodal_bound.h>
#include <tests/check/exact_element.h>
#include <tests/support/body_cases.h>

namespace ringwatch {
namespace {

using check::Ball;

/// An element of its reference shape, disturbed, made flat or thin, turned, moved away, in some unit.
struct Shape {
  double flatness;  // of one or two directions
  bool needle;
  bool line;        // tetrahedra: the last three nodes on a line instead, so that the first one's gradient cancels
  double distance;  // from the origin, in sizes of the element
  double unit;      // m
};

Mesh oneElement(const ElementInfo& element, const Shape& shape, test::Random& random) {
  Mesh mesh;
  mesh.blocks.push_back({element.type, {}, {0}});
  mesh.X.resize(3, element.nodes);
  const bool line = shape.line && element.nodes == 4;
  Eigen::Vector3d stretch(1, shape.needle ? shape.flatness : random.uniform(0.3, 1), shape.flatness);
  if (line) stretch.setOnes();
  const Eigen::Matrix3d turn = random.rotation(), before = random.rotation();
  const Eigen::Vector3d away = shape.distance * Eigen::Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), 1);
  for (int a = 0; a < element.nodes; ++a) {
    mesh.blocks[0].connectivity.push_back(a);
    Eigen::Vector3d at(element.referenceNodes[a][0], element.referenceNodes[a][1], element.referenceNodes[a][2]);
    at += 0.04 * Eigen::Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    if (line && a > 0) at = Eigen::Vector3d(-0.3 * a, 0.2, 1) + shape.flatness * at;
    mesh.X.col(a) = shape.unit * (turn * (stretch.asDiagonal() * (before * at)) + away);
  }
  return mesh;
}

/// The root of the largest entry of a Ball matrix's 3×3 block less that of a computed one, squared and summed.
double differenceOf(const check::Square& exact, const NativePack* K, int size, int a, int b) {
  Ball sum;
  for (int i = 0; i < 9; ++i) {
    const int r = 3 * a + i / 3, s = 3 * b + i % 3;
    const Ball off = exact(r, s) - Ball(K[r * size + s][0]);
    sum.addProduct(off, off);
  }
  return std::sqrt(sum.size().rounded());
}

struct Measured {
  double block = infinity;  // bound of a block's error over the error, least
  double value = infinity;  // the same of an element's value; 10 where it is at least that
  double relative = 0;      // largest error of a block over the largest block
  int tried = 0, compared = 0, unbounded = 0, skipped = 0;
};

void tryElement(const test::BodyCase& c, test::Random& random, Measured& measured) {
  const double poissons[] = {0.3, 0.0, 0.49, 0.4999999, -0.5};
  const double units[] = {1, 1e-3, 1e3, 1e-6};
  const Shape shape{std::pow(10, -random.uniform(0, 9)), random.index(4) == 0, random.index(4) == 0,
                    random.index(2) == 0 ? 0 : std::pow(10, random.uniform(0, 5)), units[random.index(4)]};
  const double nu = poissons[random.index(5)];
  std::unique_ptr<Body> made;
  try {
    made =
        std::make_unique<Body>(oneElement(*c.element, shape, random),
                               makeMaterial(c.law, std::pow(10, random.uniform(-6, 6)), nu, 1000), test::optionsOf(c));
  } catch (const NumericalError&) {  // inside out
    ++measured.skipped;
    return;
  }
  const Body& body = *made;
  // At rest; strained and turned; nearly inverted.
  NodeVectors x = body.mesh().X;
  if (const int state = random.index(3); state > 0) {
    Eigen::Matrix3d F = random.rotation() * (Eigen::Matrix3d::Identity() + random.matrix(0.3));
    if (state == 2)
      F = random.rotation() * Eigen::Vector3d(1, 0.8, std::pow(10, -random.uniform(0, 4))).asDiagonal() *
          random.rotation();
    const Eigen::Vector3d centre = x.col(0);
    x = (F * (x.colwise() - centre)).colwise() + (random.index(2) == 0 ? Eigen::Vector3d::Zero().eval() : centre);
  }
  const ElementBlock& block = *body.blocks()[0];
  const int n = block.nodesPerElement(), size = 3 * n;
  check::Square exact(0);
  Ball::precision = 256;
  const bool enclosed = test::exactTangent(body, x, exact);
  AlignedVector<NativePack> K(size * size), T(n);
  block.tangentBatch(0, x.data(), reinterpret_cast<double*>(K.data()), reinterpret_cast<double*>(T.data()));
  bool bounded = true;
  for (int a = 0; a < n; ++a) bounded = bounded && std::isfinite(T[a][0]);
  if (!bounded) {
    ++measured.unbounded;
    return;
  }
  ASSERT_TRUE(enclosed);
  ++measured.tried;
  double largest = 0;
  for (int i = 0; i < size * size; ++i) largest = std::max(largest, std::abs(K[i][0]));
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < n; ++b) {
      const double error = differenceOf(exact, K.data(), size, a, b), bound = std::sqrt(T[a][0] * T[b][0]);
      measured.relative = std::max(measured.relative, error / largest);
      if (error > 0) measured.block = std::min(measured.block, bound / error);
    }
  // The value l of the element: with nine tenths of its margin taken away, l D - K must still be definite.
  NodalBound weights(body);
  if (!std::isfinite(weights.evaluate(x, random.index(3)).value)) return;
  double margin = 0;
  check::Square rest(size);
  const double value = weights.value({0, 0});
  std::vector<check::Square> D(n, check::Square(3));
  for (int a = 0; a < n; ++a) {
    const NodalBound::Factor stored = weights.factor(weights.incidenceOf({0, 0}, a));
    CholeskyFactor<double> L;
    double w[6];
    std::copy(stored.begin(), stored.end(), L.m);
    invertFactor(L, w);
    const double free[3] = {1, 1, 1};
    margin += scaledRounding(L, w, T[a][0], free);
    const double lower[3][3] = {{L.m[0], 0, 0}, {L.m[5], L.m[1], 0}, {L.m[4], L.m[3], L.m[2]}};
    for (int i = 0; i < 9; ++i)
      for (int k = 0; k < 3; ++k) D[a](i / 3, i % 3).addProduct(Ball(lower[i / 3][k]), Ball(lower[i % 3][k]));
  }
  margin += eigenvalueRounding * value;  // of its Gershgorin radius, which is no smaller
  if (!(value > margin)) return;         // nothing but rounding
  ++measured.compared;
  const auto provenAt = [&](double share) {
    for (int i = 0; i < size; ++i)
      for (int j = 0; j < size; ++j)
        rest(i, j) = (i / 3 == j / 3 ? Ball(value - share * margin) * D[i / 3](i % 3, j % 3) : Ball(0.0)) - exact(i, j);
    return test::definite(rest);
  };
  for (const double ratio : {10.0, 5.0, 2.0, 1.0, 0.0})
    if (ratio == 0 || provenAt(1 - 1 / ratio)) {
      measured.value = std::min(measured.value, ratio);
      break;
    }
}

class RoundingTest : public ::testing::TestWithParam<test::BodyCase> {};
INSTANTIATE_TEST_SUITE_P(All, RoundingTest, ::testing::ValuesIn(test::certifiableBodyCases()),
                         [](const auto& test) { return test::bodyCaseName(test.param); });

TEST_P(RoundingTest, StaysATenthOfItsBound) {
  const char* asked = std::getenv("RINGWATCH_ROUNDING_TRIALS");
  const int trials = asked ? std::atoi(asked) : GetParam().element->nodes > 8 ? 4 : 16;
  test::Random random(7);
  Measured measured;
  for (int i = 0; i < trials; ++i) tryElement(GetParam(), random, measured);
  EXPECT_GT(measured.tried, trials / 4);
  EXPECT_GT(measured.compared, trials / 4);
  EXPECT_GE(measured.block, 10);
  EXPECT_GE(measured.value, 10);
  if (asked)
    std::cout << "| " << GetParam().element->name << ", " << GetParam().rule->name << " | " << GetParam().law << " | "
              << measured.tried << " | " << measured.relative << " | " << measured.block << " | " << measured.value
              << " | " << measured.unbounded << " |\n";
}

}  // namespace
}  // namespace ringwatch

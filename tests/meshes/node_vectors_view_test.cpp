#include <vector>

#include <gtest/gtest.h>

#include <ringwatch/meshes/mesh.h>

namespace ringwatch {
namespace {

const double* placeOf(NodeVectorsView x) { return x.data(); }
NodeVectors copyOf(NodeVectorsView x, NodeVectorsView v) {
  NodeVectors both(3, x.cols() + v.cols());
  both << x, v;
  return both;
}

TEST(NodeVectorsView, ReadsWhereTheNumbersLie) {
  NodeVectors x = NodeVectors::Random(3, 5);
  EXPECT_EQ(placeOf(x), x.data());
  EXPECT_EQ(placeOf(NodeVectorsView(x)), x.data());
  std::vector<double> numbers(16, 2.0);  // from the second on, which no vector instruction is aligned for
  EXPECT_EQ(placeOf({numbers.data() + 1, 5}), numbers.data() + 1);
  EXPECT_EQ(placeOf(Eigen::Map<NodeVectors>(numbers.data() + 1, 3, 5)), numbers.data() + 1);
  EXPECT_EQ(placeOf(Eigen::Map<const NodeVectors>(numbers.data() + 1, 3, 5)), numbers.data() + 1);
  const NodeVectorsView view(numbers.data() + 1, 5);
  EXPECT_EQ(view.rows(), 3);
  EXPECT_EQ(view.cols(), 5);
  EXPECT_EQ((x + view).eval(), x + NodeVectors::Constant(3, 5, 2.0));
}

TEST(NodeVectorsView, OfAnExpressionLastsForTheCall) {
  const NodeVectors x = NodeVectors::Random(3, 50), u = NodeVectors::Random(3, 50);
  const Eigen::Matrix3d F = Eigen::Matrix3d::Random();
  const std::vector<int> chosen{7, 3};
  NodeVectors expected(3, 52);
  expected << F * x, x(Eigen::all, chosen);
  EXPECT_EQ(copyOf(F * x, x(Eigen::all, chosen)), expected);
  expected = NodeVectors(3, 100);
  expected << x + 0.5 * u, NodeVectors::Zero(3, 50);
  EXPECT_EQ(copyOf(x + 0.5 * u, NodeVectors::Zero(3, 50)), expected);
}

}  // namespace
}  // namespace ringwatch

// Fixed and moved components.
#include <gtest/gtest.h>

#include <ringwatch/body/constraints.h>

namespace ringwatch {
namespace {

TEST(Constraints, AreNoneAtFirst) {
  const Constraints constraints(4);
  EXPECT_FALSE(constraints.any());
  EXPECT_FALSE(constraints.moving());
  NodeVectors values = NodeVectors::Ones(3, 4);
  constraints.clearConstrained(values);
  constraints.imposeVelocity(values);
  EXPECT_EQ(values, NodeVectors::Ones(3, 4));
  EXPECT_EQ(constraints.velocity(), NodeVectors::Zero(3, 4));
  for (std::int32_t i = 0; i < 4; ++i) EXPECT_EQ(constraints.freeComponents(i), 3);
}

TEST(Constraints, FixWholeNodesOrComponents) {
  Constraints constraints(4);
  constraints.fix(1);
  constraints.fix(2, 0);
  EXPECT_TRUE(constraints.any());
  EXPECT_FALSE(constraints.moving());
  EXPECT_EQ(constraints.freeComponents(0), 3);
  EXPECT_EQ(constraints.freeComponents(1), 0);
  EXPECT_EQ(constraints.freeComponents(2), 2);
  EXPECT_TRUE(constraints.isConstrained(2, 0));
  EXPECT_FALSE(constraints.isConstrained(2, 1));
  NodeVectors values = NodeVectors::Ones(3, 4), expected = values;
  expected.col(1).setZero();
  expected(0, 2) = 0;
  constraints.clearConstrained(values);
  EXPECT_EQ(values, expected);
}

TEST(Constraints, CountTheirChanges) {
  Constraints constraints(4);
  std::int64_t before = constraints.version();
  const auto hasGrown = [&] {
    const bool grown = constraints.version() > before;
    before = constraints.version();
    return grown;
  };
  constraints.fix(1, 0);
  EXPECT_TRUE(hasGrown());
  constraints.fix(1, 0);
  constraints.move(1, 0, 0.5);
  EXPECT_FALSE(hasGrown()) << "the same components are free";
  constraints.fix(2);
  EXPECT_TRUE(hasGrown());
  constraints = Constraints(4);
  EXPECT_TRUE(hasGrown()) << "assignment never returns to an earlier number";
}

TEST(Constraints, MoveComponentsAtTheirVelocity) {
  Constraints constraints(3);
  constraints.fix(2);
  constraints.move(2, 0, 0.5);  // the later one counts
  EXPECT_TRUE(constraints.moving());
  EXPECT_EQ(constraints.freeComponents(2), 0);
  NodeVectors v = NodeVectors::Ones(3, 3), expected = v;
  expected.col(2) = Eigen::Vector3d(0.5, 0, 0);
  constraints.imposeVelocity(v);
  EXPECT_EQ(v, expected);
  EXPECT_EQ(constraints.velocity()(0, 2), 0.5);
}

}  // namespace
}  // namespace ringwatch

// Matrix3 against Eigen and against identities.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include <ringwatch/base/dual.h>
#include <ringwatch/base/matrix3.h>
#include <tests/support/random.h>

namespace ringwatch {
namespace {

Eigen::Matrix3d anyMatrix() {
  return Eigen::Matrix3d::NullaryExpr([] { return *rc::gen::inRange(-512, 513) / 128.0; });
}
bool near(const Matrix3<double>& a, const Eigen::Matrix3d& b, double tolerance = 1e-13) {
  return (test::toEigen(a) - b).cwiseAbs().maxCoeff() <= tolerance * (1 + b.cwiseAbs().maxCoeff());
}

RC_GTEST_PROP(Matrix3, AlgebraAgreesWithEigen, ()) {
  const Eigen::Matrix3d A = anyMatrix(), B = anyMatrix();
  const Matrix3<double> a = test::toMatrix3(A), b = test::toMatrix3(B);
  RC_ASSERT(near(a + b, A + B));
  RC_ASSERT(near(a - b, A - B));
  RC_ASSERT(near(2.5 * a, 2.5 * A));
  RC_ASSERT(near(a * b, A * B));
  RC_ASSERT(near(transpose(a), A.transpose()));
  RC_ASSERT(near(transposeTimes(a, b), A.transpose() * B));
  RC_ASSERT(near(timesTranspose(a, b), A * B.transpose()));
  RC_ASSERT(std::abs(trace(a) - A.trace()) <= 1e-13);
  RC_ASSERT(std::abs(innerProduct(a, b) - A.cwiseProduct(B).sum()) <= 1e-11);
  RC_ASSERT(std::abs(determinant(a) - A.determinant()) <= 1e-11);
}

RC_GTEST_PROP(Matrix3, CofactorTimesTransposeIsTheDeterminant, ()) {
  const Matrix3<double> a = test::toMatrix3(anyMatrix());
  RC_ASSERT(near(timesTranspose(cofactor(a), a), determinant(a) * Eigen::Matrix3d::Identity(), 1e-11));
}

RC_GTEST_PROP(Matrix3, CofactorIsTheDerivativeOfTheDeterminant, ()) {
  const Eigen::Matrix3d A = anyMatrix();
  const Matrix3<double> cof = cofactor(test::toMatrix3(A));
  for (int i = 0; i < 9; ++i) {
    Matrix3<Dual> d = test::toMatrix3<Dual>(A);
    d.m[i].derivative = 1;
    RC_ASSERT(std::abs(determinant(d).derivative - cof.m[i]) <= 1e-12 * (1 + std::abs(cof.m[i])));
  }
}

RC_GTEST_PROP(Matrix3, InverseUndoesARegularMatrix, ()) {
  const Eigen::Matrix3d A = anyMatrix() + 15 * Eigen::Matrix3d::Identity();  // diagonally dominant
  const Matrix3<double> a = test::toMatrix3(A);
  RC_ASSERT(near(inverse(a) * a, Eigen::Matrix3d::Identity(), 1e-14));
  RC_ASSERT(near(a * inverse(a), Eigen::Matrix3d::Identity(), 1e-14));
}

TEST(Matrix3, SingularInverseIsNotFinite) { EXPECT_FALSE(std::isfinite(inverse(Matrix3<double>::zero()).m[0])); }

TEST(Matrix3, IdentityZeroAndDiagonalHoldWhatTheySay) {
  EXPECT_EQ(test::toEigen(Matrix3<double>::identity()), Eigen::Matrix3d::Identity());
  EXPECT_EQ(test::toEigen(Matrix3<double>::zero()), Eigen::Matrix3d::Zero());
  EXPECT_EQ(test::toEigen(Matrix3<double>::diagonal(3)), 3 * Eigen::Matrix3d::Identity());
}

}  // namespace
}  // namespace ringwatch

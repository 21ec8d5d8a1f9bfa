// Every law's bound on how fast its tangent grows, against the tangent itself at random pairs of states.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/error.h>
#include <ringwatch/body/law_of_packs.h>
#include <ringwatch/materials/registry.h>
#include <tests/support/laws.h>
#include <tests/support/random.h>
#include <tests/support/registry_types.h>

namespace ringwatch {
namespace {

using Matrix9 = Eigen::Matrix<double, 9, 9>;
using Vector9 = Eigen::Matrix<double, 9, 1>;

template <class LawType>
Matrix9 modulus(const LawType& law, const Eigen::Matrix3d& F) {
  const auto linearization = law.linearize(test::toMatrix3(F));
  Matrix9 A;
  for (int c = 0; c < 9; ++c) {
    Matrix3<double> unit = Matrix3<double>::zero();
    unit.m[c] = 1;
    const Matrix3<double> column = linearization(unit);
    for (int r = 0; r < 9; ++r) A(r, c) = column.m[r];
  }
  return 0.5 * (A + A.transpose());
}

/// Stretches from near collapse to threefold, every third equal to another; turned on both sides.
Eigen::Matrix3d randomState(test::Random& random) {
  Eigen::Vector3d stretch;
  const double range = random.uniform(0, 1);
  for (double& s : stretch) s = std::exp(range * random.uniform(-1.6, 1.1));
  if (random.index(3) == 0) stretch[1] = stretch[0];
  if (random.index(3) == 0) stretch[2] = stretch[1];
  return random.rotation() * stretch.asDiagonal() * random.rotation();
}

/// A direction of norm 1: any, of rank one, or what brings the least stretches down fastest.
Eigen::Matrix3d randomDirection(test::Random& random, const Eigen::Matrix3d& F) {
  Eigen::Matrix3d direction = random.matrix(1);
  const int kind = random.index(4);
  if (kind == 1) direction = random.vector(1) * random.vector(1).transpose();
  if (kind >= 2) {
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(F, Eigen::ComputeFullU | Eigen::ComputeFullV);
    direction = -svd.matrixU().col(2) * svd.matrixV().col(2).transpose();
    if (kind == 3) direction -= svd.matrixU().col(1) * svd.matrixV().col(1).transpose();
  }
  return direction / direction.norm();
}

template <class LawType>
class DriftTest : public ::testing::Test {};
TYPED_TEST_SUITE(DriftTest, test::TestTypesOf<Laws>, test::RegistryNames);

TYPED_TEST(DriftTest, BoundsTheTangentOfEveryStateInItsBall) {
  constexpr int trials = 20000;
  test::Random random(17);
  int tried = 0;
  double tightest = 0;
  for (int trial = 0; trial < trials; ++trial) {
    // Shares of rules that treat pressure and shear apart included.
    const TypeParam whole = test::lawOf<TypeParam>(1, random.uniform(-0.3, 0.49));
    const int share = random.index(4);
    const TypeParam law = withShares(whole, share == 1 ? 0 : 1, share == 2 ? 0 : 1).value();
    const Eigen::Matrix3d F0 = randomState(random);
    const TangentDriftCoefficients<double> drift = law.drift(test::toMatrix3(F0));
    // Balls end before anything can invert.
    const double range = std::min({drift.radius, 2 * F0.determinant() / F0.squaredNorm(), 1.0});
    if (!(range > 0)) continue;
    const double delta = range * std::pow(10.0, random.uniform(-4, 0));
    const Eigen::Matrix3d F = F0 + delta * randomDirection(random, F0);
    const Matrix9 A0 = modulus(law, F0), A = modulus(law, F);
    const double size = A0.norm() + A.norm() + 1;
    const double least =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(Eigen::MatrixXd(A0), Eigen::EigenvaluesOnly).eigenvalues()[0];
    ASSERT_GE(least, -drift.negative - 1e-12 * size) << "F0 = " << F0;
    ++tried;
    const double rest = (drift.linear + drift.quadratic * delta) * delta;
    const auto check = [&](const Vector9& dF) {
      const double before = std::max(0.0, dF.dot(A0 * dF) + drift.negative), after = dF.dot(A * dF);
      const double root = std::sqrt(before) + std::sqrt(drift.kappa) * delta,
                   most = root * root - drift.negative + rest;
      ASSERT_LE(after, most + 1e-10 * size) << "F0 = " << F0 << "\nF = " << F << "\ndelta = " << delta;
      const double grown = after - dF.dot(A0 * dF);
      if (delta < 0.01 * range && grown > 1e-6 * size)
        tightest = std::max(tightest, grown / (most - before + drift.negative));
    };
    check(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(Eigen::MatrixXd(A - A0)).eigenvectors().col(8));
    check(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(Eigen::MatrixXd(A)).eigenvectors().col(8));
    check(Vector9::NullaryExpr([&] { return random.uniform(-1, 1); }).normalized());
    if (this->HasFatalFailure()) return;
  }
  EXPECT_GE(tried, trials / 2);
  // A bound that is never approached would make balls needlessly small.
  if (std::string(TypeParam::name) != LinearElastic::name) {
    EXPECT_GE(tightest, 0.2);
  }
  this->RecordProperty("tightest", joinText(tightest));
}

TYPED_TEST(DriftTest, HasNoBallWhereTheLawHasNoTangent) {
  if (TypeParam::definedInverted && std::string(TypeParam::name) != Corotational::name)
    GTEST_SKIP() << "the law has a tangent everywhere";
  const TypeParam law = test::lawOf<TypeParam>(1, 0.3);
  // Inverted for one law; two stretches that sum to zero for the other.
  const Eigen::Matrix3d F = Eigen::Vector3d(1.2, 0.5, -0.5).asDiagonal();
  EXPECT_LT(law.drift(test::toMatrix3(F)).radius, 0);
}

}  // namespace
}  // namespace ringwatch

// Symmetric 3×3 matrices: indexing, products, square root, for plain numbers and for packs.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/pack.h>
#include <ringwatch/monitor/small/symmetric3.h>
#include <tests/support/random.h>

namespace ringwatch {
namespace {

Eigen::Matrix3d toMatrix(const Symmetric3<double>& a) {
  return Eigen::Matrix3d::NullaryExpr(
      [&](Eigen::Index i, Eigen::Index j) { return a(static_cast<int>(i), static_cast<int>(j)); });
}
Symmetric3<double> toSymmetric(const Eigen::Matrix3d& a) {
  return {{a(0, 0), a(1, 1), a(2, 2), a(1, 2), a(0, 2), a(0, 1)}};
}
Eigen::Matrix3d randomSymmetric(test::Random& random) {
  const Eigen::Matrix3d a = random.matrix(1);
  return a + a.transpose();
}
Eigen::Matrix3d withEigenvalues(test::Random& random, const Eigen::Vector3d& lambda) {
  const Eigen::Matrix3d Q = random.rotation(), A = Q * lambda.asDiagonal() * Q.transpose();
  return 0.5 * (A + A.transpose());
}

TEST(Symmetric3, KeepsItsEntriesWhereItSays) {
  test::Random random(1);
  const Eigen::Matrix3d A = randomSymmetric(random);
  const Symmetric3<double> a = toSymmetric(A);
  EXPECT_EQ(toMatrix(a), A);
  Symmetric3<double> b = Symmetric3<double>::diagonal(0);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) b(i, j) = A(i, j);
  EXPECT_EQ(toMatrix(b), A);
  EXPECT_EQ(toMatrix(Symmetric3<double>::diagonal(2.5)), 2.5 * Eigen::Matrix3d::Identity());
}

RC_GTEST_PROP(Symmetric3, ComputesAsFullMatricesDo, ()) {
  test::Random random(*rc::gen::arbitrary<std::uint64_t>());
  const Eigen::Matrix3d A = randomSymmetric(random), B = randomSymmetric(random);
  const Symmetric3<double> a = toSymmetric(A), b = toSymmetric(B);
  RC_ASSERT(std::abs(a.trace() - A.trace()) <= 1e-14);
  RC_ASSERT(std::abs(a.determinant() - A.determinant()) <= 1e-13);
  RC_ASSERT((toMatrix(a + b) - (A + B)).norm() <= 1e-14);
  RC_ASSERT((toMatrix(3.0 * a) - 3 * A).norm() <= 1e-14);
  RC_ASSERT((toMatrix(square(a)) - A * A).norm() <= 1e-14 * (1 + A.squaredNorm()));
  RC_ASSERT((toMatrix(congruence(b, a)) - B * A * B).norm() <= 1e-13);
}

/// Eigenvalues that a square root meets: random, repeated, nearly singular.
struct Spectrum {
  std::string name;
  Eigen::Vector3d (*make)(test::Random&);
};
const Spectrum spectra[] = {
    {"random",
     [](test::Random& r) { return Eigen::Vector3d(r.uniform(0.1, 1), r.uniform(0.1, 1), r.uniform(0.1, 1)); }},
    {"all equal", [](test::Random& r) { return Eigen::Vector3d(Eigen::Vector3d::Constant(r.uniform(0.1, 1))); }},
    {"two equal",
     [](test::Random& r) {
       const double a = r.uniform(0.1, 1);
       return Eigen::Vector3d(a, a, r.uniform(0.1, 1));
     }},
    {"nearly equal",
     [](test::Random& r) { return Eigen::Vector3d(1, 1 + r.uniform(0, 1e-7), 1 + r.uniform(0, 1e-12)); }},
    {"graded",
     [](test::Random& r) {
       return Eigen::Vector3d(1, std::pow(10, r.uniform(-5, 0)), std::pow(10, r.uniform(-5, 0)));
     }},
    {"nearly of rank 1", [](test::Random&) { return Eigen::Vector3d(1, 1e-5, 1e-5); }},
    {"nearly of rank 2", [](test::Random& r) { return Eigen::Vector3d(1, r.uniform(0.1, 1), 1e-5); }},
};

TEST(Symmetric3, SquareRootSquaredIsTheMatrix) {
  test::Random random(2);
  for (const Spectrum& spectrum : spectra)
    for (const double scale : {1e-60, 1e-9, 1.0, 1e9, 1e60})
      for (int repeat = 0; repeat < 200; ++repeat) {
        const Eigen::Matrix3d C = scale * withEigenvalues(random, spectrum.make(random));
        const Eigen::Matrix3d U = toMatrix(squareRoot(toSymmetric(C)));
        EXPECT_LE((U * U - C).norm(), 1e-10 * C.norm()) << spectrum.name << ", scale " << scale;
        const Eigen::Vector3d lambda = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(U).eigenvalues();
        EXPECT_GT(lambda[0], 0) << spectrum.name << ", scale " << scale;
      }
}

TEST(Symmetric3, SquareRootOfPacksIsThatOfEveryLane) {
  test::Random random(3);
  for (int repeat = 0; repeat < 500; ++repeat) {
    Symmetric3<NativePack> packed;
    Eigen::Matrix3d C[nativeWidth];
    for (int lane = 0; lane < nativeWidth; ++lane) {
      C[lane] = std::pow(10, random.uniform(-3, 3)) *
                withEigenvalues(random, spectra[random.index(std::size(spectra))].make(random));
      for (int k = 0; k < 6; ++k) packed.m[k].set(lane, toSymmetric(C[lane]).m[k]);
    }
    const Symmetric3<NativePack> root = squareRoot(packed);
    for (int lane = 0; lane < nativeWidth; ++lane) {
      Symmetric3<double> u;
      for (int k = 0; k < 6; ++k) u.m[k] = root.m[k][lane];
      EXPECT_LE((toMatrix(square(u)) - C[lane]).norm(), 1e-10 * C[lane].norm());
    }
  }
}

}  // namespace
}  // namespace ringwatch

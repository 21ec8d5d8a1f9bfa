// Extreme eigenvalues of small symmetric matrices against a full solver, for plain numbers and for packs.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/pack.h>
#include <ringwatch/monitor/small/extreme_eigenvalues.h>
#include <tests/support/dense.h>
#include <tests/support/random.h>

namespace ringwatch {
namespace {

using Matrices = std::vector<Eigen::MatrixXd>;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

template <class P>
struct Lanes;
template <>
struct Lanes<double> {
  static constexpr int count = 1;
  static void set(double& p, int, double value) { p = value; }
  static double get(const double& p, int) { return p; }
};
template <>
struct Lanes<NativePack> {
  static constexpr int count = nativeWidth;
  static void set(NativePack& p, int lane, double value) { p.set(lane, value); }
  static double get(const NativePack& p, int lane) { return p[lane]; }
};

template <class P>
class ExtremeEigenvaluesTest : public ::testing::Test {
 protected:
  static constexpr int lanes = Lanes<P>::count;
  using Values = std::vector<ExtremeEigenvalues<double>>;

  /// One matrix a lane. The upper triangle is filled with NaN: it must not be read.
  static Values compute(const Matrices& matrices, bool wantLeast = true) {
    const auto n = static_cast<int>(matrices[0].rows());
    std::vector<P> A(n * n), work(4 * n);
    for (int lane = 0; lane < lanes; ++lane)
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) Lanes<P>::set(A[i * n + j], lane, j <= i ? matrices[lane](i, j) : nan);
    const ExtremeEigenvalues<P> extremes = extremeEigenvalues(A.data(), n, work.data(), wantLeast);
    Values values;
    for (int lane = 0; lane < lanes; ++lane)
      values.push_back({Lanes<P>::get(extremes.largest, lane), Lanes<P>::get(extremes.least, lane),
                        Lanes<P>::get(extremes.scale, lane)});
    return values;
  }
  static void expectExact(const Eigen::MatrixXd& A, const ExtremeEigenvalues<double>& found, const std::string& what) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(A, Eigen::EigenvaluesOnly);
    ASSERT_EQ(solver.info(), Eigen::Success);
    const Eigen::VectorXd& lambda = solver.eigenvalues();
    const double radius = lambda.cwiseAbs().maxCoeff();
    EXPECT_GE(found.scale, radius * (1 - 1e-13)) << what;
    EXPECT_LE(found.scale, 3 * radius + 1e-290) << what;  // a Gershgorin bound of a tridiagonal matrix
    EXPECT_NEAR(found.largest, lambda[lambda.size() - 1], 1e-12 * found.scale + 1e-290) << what;
    EXPECT_NEAR(found.least, lambda[0], 1e-12 * found.scale + 1e-290) << what;
  }
};
using Scalars = ::testing::Types<double, NativePack>;
struct ScalarNames {
  template <class P>
  static std::string GetName(int) {
    return std::is_same_v<P, double> ? "Double" : "Pack";
  }
};
TYPED_TEST_SUITE(ExtremeEigenvaluesTest, Scalars, ScalarNames);

Eigen::MatrixXd symmetric(test::Random& random, int n, double scale) {
  const Eigen::MatrixXd a = Eigen::MatrixXd::NullaryExpr(n, n, [&] { return random.uniform(-scale, scale); });
  return 0.5 * (a + a.transpose());
}
Eigen::MatrixXd withEigenvalues(test::Random& random, const Eigen::VectorXd& lambda) {
  const Eigen::MatrixXd Q = test::orthogonalFactor(symmetric(random, static_cast<int>(lambda.size()), 1));
  const Eigen::MatrixXd A = Q * lambda.asDiagonal() * Q.transpose();
  return 0.5 * (A + A.transpose());
}

/// Matrices with a word on each.
struct Kind {
  std::string name;
  Eigen::MatrixXd (*make)(test::Random&, int n);
};
const Kind kinds[] = {
    {"random", [](test::Random& r, int n) { return symmetric(r, n, 1); }},
    {"random, large numbers", [](test::Random& r, int n) { return symmetric(r, n, 1e100); }},
    {"random, small numbers", [](test::Random& r, int n) { return symmetric(r, n, 1e-100); }},
    {"positive definite",
     [](test::Random& r, int n) {
       const Eigen::MatrixXd a = symmetric(r, n, 1);
       return Eigen::MatrixXd(a * a);
     }},
    {"rows graded from 1e-8 to 1e8",
     [](test::Random& r, int n) {
       const Eigen::VectorXd s = Eigen::VectorXd::NullaryExpr(
           n, [&](Eigen::Index i) { return std::pow(10.0, n > 1 ? -8 + 16.0 * double(i) / (n - 1) : 0.0); });
       return Eigen::MatrixXd(s.asDiagonal() * symmetric(r, n, 1) * s.asDiagonal());
     }},
    {"rows graded from 1e8 to 1e-8",
     [](test::Random& r, int n) {
       const Eigen::VectorXd s = Eigen::VectorXd::NullaryExpr(
           n, [&](Eigen::Index i) { return std::pow(10.0, n > 1 ? 8 - 16.0 * double(i) / (n - 1) : 0.0); });
       return Eigen::MatrixXd(s.asDiagonal() * symmetric(r, n, 1) * s.asDiagonal());
     }},
    {"eigenvalues graded",
     [](test::Random& r, int n) {
       return withEigenvalues(r, Eigen::VectorXd::NullaryExpr(n, [&] { return std::pow(10.0, r.uniform(-8, 8)); }));
     }},
    {"rank 1",
     [](test::Random& r, int n) {
       const Eigen::VectorXd v = Eigen::VectorXd::NullaryExpr(n, [&] { return r.uniform(-1, 1); });
       return Eigen::MatrixXd(v * v.transpose());
     }},
    {"rank 1, negative",
     [](test::Random& r, int n) {
       const Eigen::VectorXd v = Eigen::VectorXd::NullaryExpr(n, [&] { return r.uniform(-1, 1); });
       return Eigen::MatrixXd(-v * v.transpose());
     }},
    {"one entry",
     [](test::Random& r, int n) {
       Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, n);
       const int i = r.index(n), j = r.index(n);
       a(i, j) = a(j, i) = r.uniform(-1, 1);
       return a;
     }},
    {"off-diagonal entries whose squares underflow",
     [](test::Random& r, int n) {
       Eigen::MatrixXd a = 1e6 * Eigen::MatrixXd::Identity(n, n);
       for (int i = 0; i < n; ++i)
         for (int j = 0; j < i; ++j) a(i, j) = a(j, i) = r.uniform(-1, 1) * std::pow(10, r.uniform(-170, -100));
       return a;
     }},
    {"zero", [](test::Random&, int n) { return Eigen::MatrixXd(Eigen::MatrixXd::Zero(n, n)); }},
    {"identity", [](test::Random&, int n) { return Eigen::MatrixXd(Eigen::MatrixXd::Identity(n, n)); }},
    {"diagonal",
     [](test::Random& r, int n) {
       return Eigen::MatrixXd(
           Eigen::VectorXd(Eigen::VectorXd::NullaryExpr(n, [&] { return r.uniform(-1, 1); })).asDiagonal());
     }},
    {"tridiagonal",
     [](test::Random& r, int n) {
       Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, n);
       for (int i = 0; i < n; ++i) {
         a(i, i) = r.uniform(-1, 1);
         if (i > 0) a(i, i - 1) = a(i - 1, i) = r.uniform(-1, 1);
       }
       return a;
     }},
    {"repeated eigenvalues",
     [](test::Random& r, int n) {
       return withEigenvalues(r, Eigen::VectorXd::NullaryExpr(n, [&] { return double(r.index(3)) - 1; }));
     }},
    {"largest repeated, nearly",
     [](test::Random& r, int n) {
       return withEigenvalues(r, Eigen::VectorXd::NullaryExpr(n, [&] { return 1 + r.uniform(0, 1e-9); }));
     }},
    {"negative definite",
     [](test::Random& r, int n) {
       return withEigenvalues(r, Eigen::VectorXd::NullaryExpr(n, [&] { return r.uniform(-2, -1); }));
     }},
    {"six zero eigenvalues",
     [](test::Random& r, int n) {
       return withEigenvalues(
           r, Eigen::VectorXd::NullaryExpr(n, [&](Eigen::Index i) { return i < 6 ? 0.0 : r.uniform(0, 1e6); }));
     }},
    {"rows and columns left out",
     [](test::Random& r, int n) {
       Eigen::MatrixXd a = symmetric(r, n, 1);
       for (int i = 0; i < n; ++i)
         if (r.index(3) == 0) {
           a.row(i).setZero();
           a.col(i).setZero();
         }
       return a;
     }},
};

std::vector<int> sizes() {
  std::vector<int> n;
  for (int i = 1; i <= 24; ++i) n.push_back(i);
  n.push_back(60);
  return n;
}

TYPED_TEST(ExtremeEigenvaluesTest, AgreesWithAFullSolver) {
  test::Random random(1);
  for (const int n : sizes())
    for (const Kind& kind : kinds)
      for (int repeat = 0; repeat < 3; ++repeat) {
        Matrices matrices;
        for (int lane = 0; lane < TestFixture::lanes; ++lane) matrices.push_back(kind.make(random, n));
        const auto found = TestFixture::compute(matrices);
        for (std::size_t lane = 0; lane < matrices.size(); ++lane)
          TestFixture::expectExact(matrices[lane], found[lane], joinText(kind.name, ", n = ", n, ", lane ", lane));
      }
}

TYPED_TEST(ExtremeEigenvaluesTest, LanesOfAllKindsDoNotDisturbEachOther) {
  test::Random random(2);
  for (const int n : {1, 2, 3, 12, 24, 60})
    for (int repeat = 0; repeat < 30; ++repeat) {
      Matrices matrices;
      for (int lane = 0; lane < TestFixture::lanes; ++lane)
        matrices.push_back(kinds[random.index(std::size(kinds))].make(random, n));
      const auto found = TestFixture::compute(matrices);
      for (std::size_t lane = 0; lane < matrices.size(); ++lane)
        TestFixture::expectExact(matrices[lane], found[lane], joinText("mixed, n = ", n, ", lane ", lane));
    }
}

TYPED_TEST(ExtremeEigenvaluesTest, LeavesTheLeastOutWhenNotWanted) {
  test::Random random(3);
  Matrices matrices;
  for (int lane = 0; lane < TestFixture::lanes; ++lane) matrices.push_back(symmetric(random, 12, 1));
  const auto with = TestFixture::compute(matrices, true), without = TestFixture::compute(matrices, false);
  for (std::size_t lane = 0; lane < matrices.size(); ++lane) {
    EXPECT_EQ(with[lane].largest, without[lane].largest);
    EXPECT_EQ(without[lane].least, 0);
  }
}

TYPED_TEST(ExtremeEigenvaluesTest, GivesNoPlausibleValueForNanOrInfinity) {
  test::Random random(4);
  for (const int n : {1, 2, 3, 5, 12, 24})
    for (const double notFinite : {nan, infinity, -infinity})
      for (int i = 0; i < n; ++i)
        for (int j = 0; j <= i; ++j) {
          Matrices matrices;
          for (int lane = 0; lane < TestFixture::lanes; ++lane) matrices.push_back(symmetric(random, n, 1));
          const std::size_t bad = random.index(TestFixture::lanes);
          matrices[bad](i, j) = matrices[bad](j, i) = notFinite;
          const auto found = TestFixture::compute(matrices);
          EXPECT_FALSE(std::isfinite(found[bad].largest)) << notFinite << " at " << i << ", " << j << " of " << n;
          EXPECT_FALSE(std::isfinite(found[bad].least)) << notFinite << " at " << i << ", " << j << " of " << n;
          for (std::size_t lane = 0; lane < matrices.size(); ++lane)
            if (lane != bad) TestFixture::expectExact(matrices[lane], found[lane], "beside a bad lane");
        }
}

RC_GTEST_PROP(ExtremeEigenvaluesProperty, ShiftAndSignMoveTheSpectrum, ()) {
  test::Random random(*rc::gen::arbitrary<std::uint64_t>());
  const int n = *rc::gen::inRange(1, 25);
  const double shift = random.uniform(-10, 10);
  const Eigen::MatrixXd A = symmetric(random, n, 1);
  const auto extremes = [n](Eigen::MatrixXd a) {
    std::vector<double> work(4 * n);
    return extremeEigenvalues(a.data(), n, work.data(), true);
  };
  const auto plain = extremes(A), negative = extremes(-A),
             moved = extremes(A + shift * Eigen::MatrixXd::Identity(n, n));
  const double tolerance = 1e-12 * (plain.scale + moved.scale);
  RC_ASSERT(std::abs(plain.largest + negative.least) <= tolerance);
  RC_ASSERT(std::abs(plain.least + negative.largest) <= tolerance);
  RC_ASSERT(std::abs(plain.largest + shift - moved.largest) <= tolerance);
  RC_ASSERT(std::abs(plain.least + shift - moved.least) <= tolerance);
  RC_ASSERT(plain.least <= plain.largest + tolerance);
}

}  // namespace
}  // namespace ringwatch

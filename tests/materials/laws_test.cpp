// What every constitutive law must satisfy. A law enrols by its line in materials/registry.h.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include <ringwatch/base/dual.h>
#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/pack.h>
#include <ringwatch/materials/registry.h>
#include <tests/added/log_mooney_rivlin.h>
#include <tests/support/deformations.h>
#include <tests/support/laws.h>
#include <tests/support/registry_types.h>

namespace ringwatch {
namespace {

constexpr double young = 30e3, poisson = 0.3;

/// Size of the terms that a stress is summed from: what rounding is measured against, Pa.
double stressScale(const Eigen::Matrix3d& F) { return young * std::max(1.0, std::pow(F.norm(), 3)); }

template <class LawType>
class LawTest : public ::testing::Test {
 public:
  const LawType law = test::lawOf<LawType>(young, poisson);

  /// The largest difference of stress(F) and the dual-number derivative of energy, over stressScale.
  Eigen::Matrix3d stressByDual(const Eigen::Matrix3d& F) const {
    Eigen::Matrix3d P;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        Matrix3<Dual> d = test::toMatrix3<Dual>(F);
        d(i, j).derivative = 1;
        P(i, j) = law.energy(d).derivative;
      }
    return P;
  }
  Eigen::Matrix3d stress(const Eigen::Matrix3d& F) const { return test::toEigen(law.stress(test::toMatrix3(F))); }
  Eigen::Matrix3d linearized(const Eigen::Matrix3d& F, const Eigen::Matrix3d& dF) const {
    return test::toEigen(law.linearize(test::toMatrix3(F))(test::toMatrix3(dF)));
  }
  double energy(const Eigen::Matrix3d& F) const { return law.energy(test::toMatrix3(F)); }
  /// ∂P/∂F, rows and columns 3i + j.
  Eigen::Matrix<double, 9, 9> modulus(const Eigen::Matrix3d& F) const {
    Eigen::Matrix<double, 9, 9> A;
    const auto linearization = law.linearize(test::toMatrix3(F));
    for (int c = 0; c < 9; ++c) {
      Matrix3<double> unit = Matrix3<double>::zero();
      unit.m[c] = 1;
      const Matrix3<double> dP = linearization(unit);
      for (int r = 0; r < 9; ++r) A(r, c) = dP.m[r];
    }
    return A;
  }
  /// Deformations on which the law is defined.
  std::vector<test::Deformation> domain() const { return test::deformations(7, 40, LawType::definedInverted); }
};
/// Those of the library, and one of three constants.
template <class... Ls>
TypeList<Ls..., test::LogMooneyRivlin> withAdded(TypeList<Ls...>);
using TestedLaws = decltype(withAdded(Laws{}));
TYPED_TEST_SUITE(LawTest, test::TestTypesOf<TestedLaws>, test::RegistryNames);

TYPED_TEST(LawTest, HasNoEnergyAndNoStressAtRest) {
  EXPECT_NEAR(this->energy(Eigen::Matrix3d::Identity()), 0, 1e-25 * young);
  EXPECT_NEAR(this->stress(Eigen::Matrix3d::Identity()).norm(), 0, 1e-15 * young);
  if (!TypeParam::objective) return;
  test::Random random(3);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Matrix3d Q = random.rotation();
    EXPECT_NEAR(this->energy(Q), 0, 3e-15 * young);
    EXPECT_NEAR(this->stress(Q).norm(), 0, 5e-15 * young);
  }
}

// ModulusRounding: blocks g_a C g_b at a gradient within an error, for errors far above rounding.
TYPED_TEST(LawTest, KnowsWhatAnErrorOfItsGradientDoes) {
  const auto linearizationAt = [&](const Eigen::Matrix3d& F) { return this->law.linearize(test::toMatrix3(F)); };
  if constexpr (requires { linearizationAt(Eigen::Matrix3d()).rounding(Matrix3<double>(), 0.0); }) {
    test::Random random(8);
    int tried = 0;
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [kind, F] : this->domain())
      for (const double error : {1e-4, 1e-7}) {
        const auto here = linearizationAt(F);
        const double bound = here.rounding(test::toMatrix3(F), error).error;
        if (!std::isfinite(bound)) continue;
        ++tried;
        for (int direction = 0; direction < 20; ++direction) {
          const Eigen::Matrix3d off = random.matrix(1);
          const auto there = linearizationAt(F + error / off.norm() * off);
          const Eigen::Vector3d a = random.vector(1).normalized(), b = random.vector(1).normalized();
          Eigen::Matrix3d change;
          for (int j = 0; j < 3; ++j) {
            const Matrix3<double> unit = test::toMatrix3(Eigen::Matrix3d(Eigen::Vector3d::Unit(j) * b.transpose()));
            change.col(j) = (test::toEigen(there(unit)) - test::toEigen(here(unit))) * a;
          }
          EXPECT_LE(change.norm(), bound) << kind << ", error " << error << "\n" << F;
          least = std::min(least, bound / change.norm());
        }
      }
    EXPECT_GT(tried, 20);
    // A bound that is far from what happens would hide one that is wrong.
    if (!TypeParam::tangentIsConstant) {
      EXPECT_LT(least, 30);
    }
  }
}

TYPED_TEST(LawTest, StressIsTheDerivativeOfEnergy) {
  for (const auto& [kind, F] : this->domain())
    EXPECT_LE((this->stress(F) - this->stressByDual(F)).norm(), 1e-12 * stressScale(F)) << kind << "\n" << F;
}

TYPED_TEST(LawTest, LinearizationIsTheDerivativeOfStress) {
  test::Random random(4);
  for (const auto& [kind, F] : this->domain()) {
    const Eigen::Matrix3d dF = random.matrix(1);
    Matrix3<Dual> d = test::toMatrix3<Dual>(F);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) d(i, j).derivative = dF(i, j);
    const Matrix3<Dual> P = this->law.stress(d);
    Eigen::Matrix3d expected;
    for (int i = 0; i < 9; ++i) expected(i / 3, i % 3) = P.m[i].derivative;
    const Eigen::Matrix3d dP = this->linearized(F, dF);
    const double scale = std::max(stressScale(F), expected.norm());
    EXPECT_LE((dP - expected).norm(), 1e-12 * scale) << kind << "\n" << F;
  }
}

TYPED_TEST(LawTest, ModulusIsSymmetric) {
  for (const auto& [kind, F] : this->domain()) {
    const auto A = this->modulus(F);
    EXPECT_LE((A - A.transpose()).norm(), 1e-12 * A.norm()) << kind << "\n" << F;
  }
}

TYPED_TEST(LawTest, NodeBlocksAreTheModulusBetweenTwoGradients) {
  test::Random random(12);
  for (const auto& [kind, deformation] : this->domain()) {
    const Eigen::Matrix3d& F = deformation;  // a name that a requires-expression may use
    const auto A = this->modulus(F);
    const Eigen::Vector3d first = random.vector(1), second = random.vector(1);
    Eigen::Matrix3d expected = Eigen::Matrix3d::Zero();
    for (int i = 0; i < 9; ++i)
      for (int j = 0; j < 9; ++j) expected(i / 3, j / 3) += 2.5 * first[i % 3] * A(i, j) * second[j % 3];
    if constexpr (requires { this->law.linearize(test::toMatrix3(F)).nodeBlocks(2.5); }) {
      const auto blocks = this->law.linearize(test::toMatrix3(F)).nodeBlocks(2.5);
      const double a[3] = {first[0], first[1], first[2]}, b[3] = {second[0], second[1], second[2]};
      const Eigen::Matrix3d block = test::toEigen(blocks(blocks.node(a), blocks.node(b)));
      EXPECT_LE((block - expected).norm(), 1e-12 * A.norm()) << kind << "\n" << F;
    } else {
      GTEST_SKIP() << "the law has no blocks of its own";
    }
  }
}

TYPED_TEST(LawTest, HasNoEigenvalueBelowWhatItDeclares) {
  int tried = 0;
  for (const auto& [kind, F] : this->domain()) {
    if (!(F.determinant() > 1e-3)) continue;
    ++tried;
    const Eigen::MatrixXd A = this->modulus(F);
    const double least = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A, Eigen::EigenvaluesOnly).eigenvalues()[0];
    EXPECT_GE(least, -this->law.drift(test::toMatrix3(F)).negative - 1e-12 * A.norm()) << kind << "\n" << F;
  }
  EXPECT_GT(tried, 0);
}

TYPED_TEST(LawTest, IsMadeOfItsParameters) {
  using Law = TypeParam;
  for (const OptionInfo& parameter : Law::parameters) {
    EXPECT_FALSE(parameter.help.empty());
    EXPECT_EQ(parameter.type, OptionType::number);
  }
  const Options parameters = Law::parametersFor(young, poisson);
  EXPECT_NO_THROW(completed(Law::name, Law::parameters, parameters));
  const Lame expected = lameConstants(young, poisson), rest = Law::of(parameters).restModuli();
  EXPECT_NEAR(rest.lambda, expected.lambda, 1e-12 * young);
  EXPECT_NEAR(rest.mu, expected.mu, 1e-12 * young);
}

TYPED_TEST(LawTest, DeclaresWhetherItsTangentIsConstant) {
  const auto rest = this->modulus(Eigen::Matrix3d::Identity());
  bool constant = true;
  for (const auto& [kind, F] : this->domain())
    constant = constant && (this->modulus(F) - rest).norm() <= 1e-9 * rest.norm();
  EXPECT_EQ(constant, TypeParam::tangentIsConstant);
}

TYPED_TEST(LawTest, DeclaresWhetherItIsDefinedInverted) {
  for (const double s : {-0.5, -1.5}) {
    const Eigen::Matrix3d inverted = Eigen::Vector3d(1.5, 1, s).asDiagonal();
    EXPECT_EQ(std::isfinite(this->energy(inverted)), TypeParam::definedInverted) << s;
    EXPECT_EQ(this->stress(inverted).allFinite(), TypeParam::definedInverted) << s;
  }
}

TYPED_TEST(LawTest, LinearizationIsLinear) {
  test::Random random(5);
  for (const auto& [kind, F] : this->domain()) {
    const Eigen::Matrix3d a = random.matrix(1), b = random.matrix(1);
    const Eigen::Matrix3d together = this->linearized(F, 2 * a - b);
    const Eigen::Matrix3d apart = 2 * this->linearized(F, a) - this->linearized(F, b);
    EXPECT_LE((together - apart).norm(), 1e-12 * this->modulus(F).norm()) << kind;
  }
}

TYPED_TEST(LawTest, DoesNotSeeRotationsOfTheFrame) {
  if (!TypeParam::objective) GTEST_SKIP() << "the law does not claim it";
  test::Random random(6);
  for (const auto& [kind, F] : this->domain()) {
    const Eigen::Matrix3d Q = random.rotation();
    EXPECT_NEAR(this->energy(Q * F), this->energy(F), 1e-13 * stressScale(F) * F.norm()) << kind;
    EXPECT_LE((this->stress(Q * F) - Q * this->stress(F)).norm(), 1e-12 * stressScale(F)) << kind;
    const Eigen::Matrix3d dF = random.matrix(1);
    EXPECT_LE((this->linearized(Q * F, Q * dF) - Q * this->linearized(F, dF)).norm(), 1e-11 * this->modulus(F).norm())
        << kind;
  }
}

TYPED_TEST(LawTest, DoesNotPreferADirectionIfItSaysSo) {
  double most = 0;
  test::Random random(7);
  for (const auto& [kind, F] : this->domain()) {
    const Eigen::Matrix3d Q = random.rotation();
    // A law that sees rotations is isotropic when both sides turn.
    const Eigen::Matrix3d turned =
        TypeParam::objective ? Eigen::Matrix3d(F * Q) : Eigen::Matrix3d(Q.transpose() * F * Q);
    most = std::max(most, std::abs(this->energy(turned) - this->energy(F)) / (stressScale(F) * F.norm()));
  }
  EXPECT_EQ(most <= 1e-13, TypeParam::isotropic) << most;
}

TYPED_TEST(LawTest, BalancesMoments) {
  // P Fᵀ is symmetric for objective laws, P itself for those of small strain.
  for (const auto& [kind, F] : this->domain()) {
    const Eigen::Matrix3d P = this->stress(F),
                          kirchhoff = TypeParam::objective ? Eigen::Matrix3d(P * F.transpose()) : P;
    EXPECT_LE((kirchhoff - kirchhoff.transpose()).norm(), 1e-12 * stressScale(F) * F.norm()) << kind;
  }
}

TYPED_TEST(LawTest, IsLinearElasticToFirstOrderAtRest) {
  const Lame c = lameConstants(young, poisson);
  const auto law = TypeParam::of(TypeParam::parametersFor(young, poisson));
  const auto stress = [&](const Eigen::Matrix3d& F) { return test::toEigen(law.stress(test::toMatrix3(F))); };
  test::Random random(8);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Matrix3d H = random.matrix(1), e = 0.5 * (H + H.transpose());
    const Eigen::Matrix3d hooke = 2 * c.mu * e + c.lambda * e.trace() * Eigen::Matrix3d::Identity();
    const auto atRest = law.linearize(Matrix3<double>::identity());
    EXPECT_LE((test::toEigen(atRest(test::toMatrix3(H))) - hooke).norm(), 1e-13 * young);
    // And by values: the difference falls with the square of the strain.
    const double h = 1e-4;
    EXPECT_LE((stress(Eigen::Matrix3d::Identity() + h * H) - h * hooke).norm(), 50 * h * h * young);
  }
}

TYPED_TEST(LawTest, PacksGiveWhatPlainNumbersGive) {
  const auto cases = this->domain();
  test::Random random(9);
  for (std::size_t first = 0; first + NativePack::width <= cases.size(); first += NativePack::width) {
    // A different deformation in each lane.
    Matrix3<NativePack> F, dF;
    const Eigen::Matrix3d direction = random.matrix(1);
    for (int i = 0; i < 9; ++i) {
      dF.m[i] = NativePack(direction(i / 3, i % 3));
      for (int lane = 0; lane < NativePack::width; ++lane)
        F.m[i].set(lane, cases[first + static_cast<std::size_t>(lane)].F(i / 3, i % 3));
    }
    const NativePack W = this->law.energy(F);
    const Matrix3<NativePack> P = this->law.stress(F), dP = this->law.linearize(F)(dF);
    for (int lane = 0; lane < NativePack::width; ++lane) {
      const auto& [kind, Fs] = cases[first + static_cast<std::size_t>(lane)];
      const Eigen::Matrix3d Ps = this->stress(Fs), dPs = this->linearized(Fs, direction);
      EXPECT_NEAR(W[lane], this->energy(Fs), 1e-14 * stressScale(Fs) * Fs.norm()) << kind;
      for (int i = 0; i < 9; ++i) {
        EXPECT_NEAR(P.m[i][lane], Ps(i / 3, i % 3), 1e-13 * stressScale(Fs)) << kind;
        EXPECT_NEAR(dP.m[i][lane], dPs(i / 3, i % 3), 1e-12 * std::max(stressScale(Fs), dPs.norm())) << kind;
      }
    }
  }
}

TYPED_TEST(LawTest, OneLaneDoesNotDisturbAnother) {
  // A deformation that is far off, or not a number, in lane 0 leaves the other lanes as they are.
  const auto good = test::deformations(10, 1, false)[2].F;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {0.0, -2.0, 1e30, nan}) {
    Matrix3<NativePack> F = test::toMatrix3<NativePack>(good);
    for (int i = 0; i < 9; ++i) F.m[i].set(0, i % 4 == 0 ? bad : 0.0);
    const Matrix3<NativePack> P = this->law.stress(F);
    for (int lane = 1; lane < NativePack::width; ++lane)
      for (int i = 0; i < 9; ++i)
        EXPECT_NEAR(P.m[i][lane], this->stress(good)(i / 3, i % 3), 1e-13 * stressScale(good)) << bad;
  }
}

TYPED_TEST(LawTest, PropagatesNotANumber) {
  Eigen::Matrix3d F = Eigen::Matrix3d::Identity();
  F(1, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(this->stress(F).allFinite());
  EXPECT_FALSE(std::isfinite(this->energy(F)));
}

TEST(NeoHookean, IsNotANumberForInvertedElements) {
  const NeoHookean law{lameConstants(young, poisson)};
  Matrix3<double> F = Matrix3<double>::identity();
  F.m[8] = -0.5;
  EXPECT_TRUE(std::isnan(law.energy(F)));
  EXPECT_TRUE(std::isnan(law.stress(F).m[0]));
}

TEST(StVenantKirchhoff, PullsAsInTheClosedForm) {
  // Uniaxial strain: P = (λ + 2μ) s (s² - 1)/2.
  const Lame c = lameConstants(young, poisson);
  const StVenantKirchhoff law{c};
  for (const double s : {0.4, 0.58, 1.0, 1.7, 2.5}) {
    Matrix3<double> F = Matrix3<double>::identity();
    F.m[0] = s;
    EXPECT_NEAR(law.stress(F).m[0], (c.lambda + 2 * c.mu) * s * (s * s - 1) / 2, 1e-15 * young * 20);
  }
}

TEST(NeoHookean, PullsAsInTheClosedForm) {
  // Uniaxial strain: P = μ (s - 1/s) + λ ln(s)/s.
  const Lame c = lameConstants(young, poisson);
  const NeoHookean law{c};
  for (const double s : {0.1, 0.5, 1.0, 1.7, 2.5}) {
    Matrix3<double> F = Matrix3<double>::identity();
    F.m[0] = s;
    EXPECT_NEAR(law.stress(F).m[0], c.mu * (s - 1 / s) + c.lambda * std::log(s) / s, 1e-14 * young * 20);
  }
}

TEST(Corotational, IsLinearElasticInATurningFrame) {
  const Lame c = lameConstants(young, poisson);
  const Corotational law{c};
  const LinearElastic linear{c};
  test::Random random(11);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Matrix3d Q = random.rotation(), H = random.matrix(0.1);
    const Eigen::Matrix3d U = Eigen::Matrix3d::Identity() + 0.5 * (H + H.transpose());
    const Eigen::Matrix3d expected = Q * test::toEigen(linear.stress(test::toMatrix3(U)));
    EXPECT_LE((test::toEigen(law.stress(test::toMatrix3(Q * U))) - expected).norm(), 1e-13 * young);
  }
}

TEST(StableNeoHookean, PullsAsInTheClosedForm) {
  // Uniaxial strain, inverted too: P = 4/3 μ I/(I + 1) s + (λ + 5/6 μ) (s - 1) - μ, I = s² + 2.
  const Lame c = lameConstants(young, poisson);
  const StableNeoHookean law{c};
  for (const double s : {-1.5, -0.3, 0.0, 0.5, 1.0, 2.5}) {
    Matrix3<double> F = Matrix3<double>::identity();
    F.m[0] = s;
    const double I = s * s + 2;
    const double expected = 4.0 / 3.0 * c.mu * I / (I + 1) * s + (c.lambda + 5.0 / 6.0 * c.mu) * (s - 1) - c.mu;
    EXPECT_NEAR(law.stress(F).m[0], expected, 1e-15 * young * 3);
  }
}

/// σ₁ - σ₂, Pa, of a pull by s that keeps the volume; and σ₁ of pure change of volume by the factor J.
template <class L>
std::pair<double, double> cauchyStresses(const L& law, double s, double J) {
  Matrix3<double> F = Matrix3<double>::zero();
  F.m[0] = s;
  F.m[4] = F.m[8] = 1 / std::sqrt(s);
  const Matrix3<double> P = law.stress(F);
  const double side = std::cbrt(J);
  return {P.m[0] * F.m[0] - P.m[4] * F.m[4], law.stress(Matrix3<double>::diagonal(side)).m[0] / (side * side)};
}

TEST(MooneyRivlin, PullsAsRubberInTheClosedForm) {
  // σ₁ - σ₂ = 2 (s² - 1/s) (c10 + c01/s), and K (J - 1) of volume.
  const auto law = MooneyRivlin::of({{"c10", 4e3}, {"c01", 1e3}, {"bulk", 2e5}});
  for (const double s : {0.4, 0.9, 1.0, 1.7, 2.5}) {
    const auto [pull, pressure] = cauchyStresses(law, s, s);
    EXPECT_NEAR(pull, 2 * (s * s - 1 / s) * (4e3 + 1e3 / s), 1e-10);
    EXPECT_NEAR(pressure, 2e5 * (s - 1), 4e-10);
  }
}

TEST(Yeoh, PullsAsRubberInTheClosedForm) {
  // σ₁ - σ₂ = 2 (s² - 1/s) (c10 + 2 c20 (I1 - 3) + 3 c30 (I1 - 3)²), I1 = s² + 2/s.
  const auto law = Yeoh::of({{"c10", 5e3}, {"c20", -60.0}, {"c30", 7.0}, {"bulk", 2e5}});
  for (const double s : {0.4, 0.9, 1.0, 1.7, 2.5, 4.0}) {
    const double x = s * s + 2 / s - 3;
    const auto [pull, pressure] = cauchyStresses(law, s, s);
    EXPECT_NEAR(pull, 2 * (s * s - 1 / s) * (5e3 - 120 * x + 21 * x * x), 1e-9);
    EXPECT_NEAR(pressure, 2e5 * (s - 1), 4e-10);
  }
}

TEST(IsochoricLaws, DeclareTheirLeastEigenvalueWithCoefficientsBelowZeroToo) {
  const auto expectBound = [](const auto& law, const Eigen::Matrix3d& F) {
    const auto tangent = law.linearize(test::toMatrix3(F));
    Eigen::MatrixXd A(9, 9);
    for (int c = 0; c < 9; ++c) {
      Matrix3<double> unit = Matrix3<double>::zero();
      unit.m[c] = 1;
      const Matrix3<double> column = tangent(unit);
      for (int r = 0; r < 9; ++r) A(r, c) = column.m[r];
    }
    const double least = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A, Eigen::EigenvaluesOnly).eigenvalues()[0];
    EXPECT_GE(least, -law.drift(test::toMatrix3(F)).negative - 1e-12 * A.norm()) << F;
    return least;
  };
  double lowest = 0;
  for (const auto& [kind, F] : test::deformations(21, 40, false)) {
    if (!(F.determinant() > 1e-3)) continue;
    lowest = std::min(lowest, expectBound(MooneyRivlin::of({{"c10", -1e3}, {"c01", 3e3}, {"bulk", 2e4}}), F));
    lowest = std::min(lowest, expectBound(MooneyRivlin::of({{"c10", 3e3}, {"c01", -1e3}, {"bulk", 2e4}}), F));
    lowest = std::min(lowest, expectBound(Yeoh::of({{"c10", 1e3}, {"c20", -4e3}, {"c30", 10.0}, {"bulk", 2e4}}), F));
  }
  EXPECT_LT(lowest, -1e3);
}

TEST(MooneyRivlin, NeedsAShearModulus) {
  EXPECT_THROW(MooneyRivlin::of({{"c10", 1e3}, {"c01", -1e3}, {"bulk", 2e5}}), InputError);
}

TEST(TransverselyIsotropic, HasItsEngineeringConstants) {
  constexpr double Ea = 40e9, Et = 9e9, na = 0.28, nt = 0.4, G = 4e9;
  const auto law = TransverselyIsotropic::of({{"young_axial", Ea},
                                              {"young_transverse", Et},
                                              {"poisson_axial", na},
                                              {"poisson_transverse", nt},
                                              {"shear_axial", G},
                                              {"axis_x", 1.0},
                                              {"axis_y", 2.0},
                                              {"axis_z", 2.0}});
  const auto rest = law.linearize(Matrix3<double>::identity());
  const Eigen::Vector3d a(1.0 / 3, 2.0 / 3, 2.0 / 3), n(2.0 / 3, 1.0 / 3, -2.0 / 3), m = a.cross(n);
  const auto expectStress = [&](const Eigen::Matrix3d& strain, const Eigen::Matrix3d& stress) {
    EXPECT_LE((test::toEigen(rest(test::toMatrix3(strain))) - stress).norm(), 3e-15);
  };
  const Eigen::Matrix3d aa = a * a.transpose(), nn = n * n.transpose(), mm = m * m.transpose(),
                        an = a * n.transpose() + n * a.transpose();
  expectStress(aa / Ea - na / Ea * (nn + mm), aa);
  expectStress(nn / Et - nt / Et * mm - na / Ea * aa, nn);
  expectStress(an / (2 * G), an);
  // The fastest wave runs along the axis: C11 by the plane strain of that pull.
  const double across = (1 - nt) / Et, C11 = across / (across / Ea - 2 * na * na / (Ea * Ea));
  EXPECT_NEAR(law.stiffestModulus(), C11, 1e-14 * C11);
}

TEST(TransverselyIsotropic, RefusesConstantsWithoutAStiffnessAndAnAxisWithoutADirection) {
  Options parameters = TransverselyIsotropic::parametersFor(young, poisson);
  EXPECT_THROW(TransverselyIsotropic::of(Options(parameters).set("poisson_axial", 0.7)), InputError);
  EXPECT_THROW(TransverselyIsotropic::of(Options(parameters).set("axis_x", 0.0)), InputError);
}

}  // namespace
}  // namespace ringwatch

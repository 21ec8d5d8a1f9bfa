// Stress and stretch of elements against states that are known in closed form and against the forces at their nodes,
// for every registered element, law and quadrature rule.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>

#include <ringwatch/body/element_stress.h>
#include <ringwatch/meshes/jacobian.h>
#include <tests/support/body_cases.h>

namespace ringwatch {
namespace {

using test::BodyCase;

constexpr double lambda = test::young * test::poisson / ((1 + test::poisson) * (1 - 2 * test::poisson)),
                 mu = test::young / (2 * (1 + test::poisson));

/// A bar that is stretched to s times its length and free at its sides.
struct Uniaxial {
  double lateral;  // stretch
  double stress;   // Pa, Cauchy
};
/// The state whose lateral Cauchy stress is zero, by bisection. stresses(t): lateral and axial, Pa, of the stretch t.
Uniaxial freeAtItsSides(const std::function<Uniaxial(double)>& stresses) {
  double low = 0.6, high = 1.4;
  for (int i = 0; i < 60; ++i) {
    const double t = 0.5 * (low + high);
    (stresses(t).lateral < 0 ? low : high) = t;
  }
  return {low, stresses(low).stress};
}
static_assert(Laws::size == 8, "a new law needs its uniaxial state here");
Uniaxial uniaxial(const std::string& law, double s) {
  constexpr double E = test::young, nu = test::poisson;
  if (law == "linear") return {1 - nu * (s - 1), E * (s - 1)};
  if (law == "corotational") {
    const double t = 1 - nu * (s - 1);
    return {t, E * (s - 1) / (t * t)};
  }
  if (law == "stvk" || law == "transversely-isotropic") {
    const double t = std::sqrt(1 - nu * (s * s - 1));
    return {t, s * E * (s * s - 1) / 2 / (t * t)};
  }
  if (law == "stable-neo-hookean") {
    const double m = 4.0 / 3.0 * mu, l = lambda + 5.0 / 6.0 * mu;
    return freeAtItsSides([&](double t) {
      const double I = s * s + 2 * t * t, shear = m * I / (I + 1), c = l * (s * t * t - 1) - 0.75 * m;
      return Uniaxial{(shear * t + c * s * t) / (s * t), (shear * s + c * t * t) / (t * t)};
    });
  }
  if (law == "mooney-rivlin" || law == "yeoh") {
    const bool yeoh = law == "yeoh";
    return freeAtItsSides([&](double t) {
      const double J = s * t * t, scale = std::pow(J, -2.0 / 3.0), axial = scale * s * s, lateral = scale * t * t;
      const double I1 = axial + 2 * lateral, x = I1 - 3;
      const double slope = yeoh ? mu * (0.5 - 0.01 * x + 0.0015 * x * x) : mu * (0.4 + 0.1 * I1);
      const double second = yeoh ? 0 : 0.1 * mu;
      const auto part = [&](double b) { return 2 / J * (slope * b - second * b * b); };
      const double mean = (part(axial) + 2 * part(lateral)) / 3, volume = (lambda + 2.0 / 3.0 * mu) * (J - 1);
      return Uniaxial{part(lateral) - mean + volume, part(axial) - mean + volume};
    });
  }
  // Neo-Hookean: μ (t² - 1) + λ ln(s t²) = 0, by Newton's method for t².
  double t2 = 1;
  for (int i = 0; i < 50; ++i) t2 -= (mu * (t2 - 1) + lambda * std::log(s * t2)) / (mu + lambda / t2);
  return {std::sqrt(t2), mu * (s * s - t2) / (s * t2)};
}

class ElementStressTest : public ::testing::TestWithParam<BodyCase> {
 public:
  static const BodyCase& param() { return GetParam(); }
  static Body makeBody(const Mesh& mesh, int threads = 1) {
    return Body(mesh, test::materialOf(param()), test::optionsOf(param(), threads));
  }
  static std::map<std::string, std::vector<double>> measured(const Body& body, const NodeVectors& x) {
    std::vector<const StressMeasure*> all;
    for (const StressMeasure& measure : allStressMeasures()) all.push_back(&measure);
    const auto values = stressOfElements(body, x, all);
    std::map<std::string, std::vector<double>> named;
    for (std::size_t m = 0; m < all.size(); ++m) named[std::string(all[m]->name)] = values[m];
    return named;
  }
};
INSTANTIATE_TEST_SUITE_P(All, ElementStressTest, ::testing::ValuesIn(test::allBodyCases()),
                         [](const auto& test) { return test::bodyCaseName(test.param); });

TEST_P(ElementStressTest, IsThatOfABarStretchedOrPressedInOneDirection) {
  const Body body = makeBody(test::distortedBox(param().element->name, {3, 2, 2}));
  test::Random random(11);
  for (const double s : {1.4, 1.02, 0.8}) {
    const Uniaxial state = uniaxial(param().law, s);
    const Eigen::Matrix3d Q = param().objective ? random.rotation() : Eigen::Matrix3d::Identity();
    const Eigen::Matrix3d F = Q * Eigen::Vector3d(state.lateral, s, state.lateral).asDiagonal();
    const auto found = measured(body, (F * body.mesh().X).colwise() + random.vector(0.01));
    const double tolerance = 1e-12 * test::young;
    for (std::size_t e = 0; e < body.mesh().elementCount(); ++e) {
      EXPECT_NEAR(found.at("von_mises")[e], std::abs(state.stress), tolerance);
      EXPECT_NEAR(found.at("pressure")[e], -state.stress / 3, tolerance);
      EXPECT_NEAR(found.at("max_principal_stress")[e], std::max(0.0, state.stress), tolerance);
      EXPECT_NEAR(found.at("max_stretch")[e], std::max(s, state.lateral), 1e-12);
      const double stresses[] = {std::max(0.0, state.stress), 0, std::min(0.0, state.stress)};
      for (int i = 0; i < 3; ++i) EXPECT_NEAR(found.at("principal_stresses")[3 * e + i], stresses[i], tolerance) << i;
      const Eigen::Matrix3d E = 0.5 * (F.transpose() * F - Eigen::Matrix3d::Identity());
      const Eigen::Vector3d axis = Q.col(1);  // of the stress, in space
      const Eigen::Matrix3d sigma = state.stress * axis * axis.transpose();
      constexpr int order[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}};
      for (int i = 0; i < 6; ++i) {
        EXPECT_NEAR(found.at("cauchy_stress")[6 * e + i], sigma(order[i][0], order[i][1]), tolerance) << i;
        EXPECT_NEAR(found.at("green_strain")[6 * e + i], E(order[i][0], order[i][1]), 1e-12) << i;
      }
      const double along = 0.5 * (s * s - 1), across = 0.5 * (state.lateral * state.lateral - 1);
      const double strains[] = {std::max(along, across), across, std::min(along, across)};
      for (int i = 0; i < 3; ++i) EXPECT_NEAR(found.at("principal_strains")[3 * e + i], strains[i], 1e-12) << i;
    }
  }
}

TEST_P(ElementStressTest, TimesTheVolumeIsTheMomentOfTheForcesAtTheNodes) {
  // ∫ σ dv = Σ_a f_a ⊗ x_a; of a law of small strain ∫ P dV = Σ_a f_a ⊗ X_a. Hourglass forces are no part of the
  // stress.
  for (int number = 0; number < 3; ++number) {
    const Mesh mesh = test::firstElements(test::distortedBox(param().element->name, {3, 2, 2}, 0.1 * (number + 1)), 1);
    BodyOptions options = test::optionsOf(param());
    options.hourglassControl.stiffness = 0;
    const Body body(mesh, test::materialOf(param()), options);
    const NodeVectors x = test::strained(mesh.X, 20 + number), &place = param().objective ? x : mesh.X;
    Body::Workspace workspace;
    NodeVectors f;
    body.internalForce(x, f, workspace);
    const ElementBlock& block = *body.blocks()[0];
    double volume = 0, dN[maxElementNodes][3];
    for (const QuadraturePoint& point : param().rule->points) {
      param().element->shapeGradient(point.xi, dN);
      volume += point.weight * jacobianOf(place, block.nodesOf(0).data(), param().element->nodes, dN[0]).determinant();
    }
    std::vector<double> stress(6 * lanes), F(9 * lanes * param().rule->points.size());
    block.stressBatch(0, x.data(), stress.data(), F.data());
    if (param().rule->uniformStrain) {  // the element's volume at its mean deformation gradient
      double ratio[lanes];
      block.minimumDeterminantBatch(0, x.data(), ratio);
      volume = body.volume() * (param().objective ? ratio[0] : 1);
    }
    const Eigen::Matrix3d moment = f * place.transpose() / volume;
    const std::pair<int, int> entries[] = {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
    for (int i = 0; i < 6; ++i)
      EXPECT_NEAR(stress[i * lanes], moment(entries[i].first, entries[i].second), 1e-11 * test::young) << i;
  }
}

TEST_P(ElementStressTest, IsNotANumberWhereAnElementIsTurnedInsideOut) {
  if (!param().objective) GTEST_SKIP() << "its stress is that of the shape at rest";
  const Body body = makeBody(test::distortedBox(param().element->name, {2, 2, 2}));
  const auto found = measured(body, Eigen::Vector3d(1, 1, -0.5).asDiagonal() * body.mesh().X);
  for (const double value : found.at("von_mises")) EXPECT_TRUE(std::isnan(value));
  for (const char* tensor : {"cauchy_stress", "principal_stresses"})
    for (const double value : found.at(tensor)) EXPECT_TRUE(std::isnan(value)) << tensor;
  for (const double value : found.at("max_stretch")) EXPECT_NEAR(value, 1, 1e-12);
}

TEST_P(ElementStressTest, HasTheSameBitsForAnyNumberOfThreads) {
  const Mesh mesh = test::distortedBox(param().element->name, {7, 6, 5});
  const NodeVectors x = test::strained(mesh.X);
  const auto one = measured(makeBody(mesh, 1), x);
  for (const int threads : {2, 3}) EXPECT_EQ(measured(makeBody(mesh, threads), x), one) << threads;
}

TEST(StressMeasures, AreFoundByName) {
  for (const StressMeasure& measure : allStressMeasures()) EXPECT_EQ(findStressMeasure(measure.name), &measure);
  EXPECT_EQ(findStressMeasure("tresca"), nullptr);
}

}  // namespace
}  // namespace ringwatch

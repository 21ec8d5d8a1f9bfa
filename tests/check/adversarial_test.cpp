// Brackets of bodies that are made to be hard, against the whole body's tangent in ball arithmetic: far from the
// origin, nearly incompressible, stiffnesses twelve decades apart, in units from µm to km, nearly inverted; every
// element and law.
#include <optional>

#include <gtest/gtest.h>

#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/monitor/critical_step.h>
#include <ringwatch/monitor/incremental/run_bracket.h>
#include <tests/check/exact_element.h>
#include <tests/support/body_cases.h>

namespace ringwatch {
namespace {

using Status = check::Verdict::Status;
constexpr double verletLimit = 2;

/// What makes a body hard.
struct Hardship {
  const char* name;
  double poisson = 0.3, contrast = 1;              // of Young's modulus, between the halves of the body
  double distance = 0;                             // from the origin, in cells
  double length = 1, modulus = 1, density = 1000;  // units: m, Pa, kg/m³ in those of the body
};
constexpr Hardship hardships[] = {
    {"plain"},
    {.name = "nearly incompressible", .poisson = 0.4999999},
    {.name = "stiffnesses twelve decades apart", .contrast = 1e12},
    {.name = "far from the origin", .distance = 1e6},
    {.name = "mm, t, s", .length = 1e3, .modulus = 1e-6, .density = 1e-9},
    {.name = "um", .length = 1e6, .modulus = 1e-6, .density = 1e-15},
    {.name = "km", .length = 1e-3, .modulus = 1e6, .density = 1e12},
};

/// Two cells, each of a material of its own.
Body bodyOf(const test::BodyCase& c, const Hardship& hard) {
  Mesh mesh = test::distortedBox(c.element->name, {2, 1, 1}, 0.15);
  const double middle = 0.5 * mesh.X.row(0).maxCoeff();
  Mesh parts = mesh;
  parts.blocks.clear();
  parts.elementSets.clear();
  for (const bool right : {false, true}) {
    MeshBlock part = mesh.blocks[0];
    part.connectivity.clear();
    part.ids.clear();
    for (std::size_t e = 0; e < mesh.blocks[0].elementCount(); ++e) {
      const std::int32_t *first = mesh.blocks[0].element(e), *last = first + c.element->nodes;
      double centre = 0;
      for (const std::int32_t* node = first; node != last; ++node) centre += mesh.X(0, *node) / c.element->nodes;
      if ((centre > middle) == right) part.connectivity.insert(part.connectivity.end(), first, last);
    }
    parts.blocks.push_back(part);
  }
  const Eigen::Vector3d away = hard.distance * test::cellSize * Eigen::Vector3d(1, -0.7, 0.4);
  parts.X = hard.length * (parts.X.colwise() + away);
  const auto material = [&](double young) {
    return makeMaterial(c.law, hard.modulus * young, hard.poisson, hard.density);
  };
  return Body(std::move(parts), {material(test::young), material(hard.contrast * test::young)}, test::optionsOf(c));
}

/// At rest, strained and turned, and flattened to a thousandth.
std::vector<NodeVectors> statesOf(const NodeVectors& X, test::Random& random) {
  std::vector<NodeVectors> states{X};
  const Eigen::Vector3d centre = X.col(0);
  for (const Eigen::Matrix3d& F :
       {Eigen::Matrix3d(random.rotation() * (Eigen::Matrix3d::Identity() + random.matrix(0.15))),
        Eigen::Matrix3d(random.rotation() * Eigen::Vector3d(1, 0.8, 1e-3).asDiagonal() * random.rotation())})
    states.push_back((F * (X.colwise() - centre)).colwise() + centre);
  return states;
}

class Adversarial : public ::testing::TestWithParam<test::BodyCase> {};
INSTANTIATE_TEST_SUITE_P(All, Adversarial, ::testing::ValuesIn(test::certifiableBodyCases()),
                         [](const auto& test) { return test::bodyCaseName(test.param); });

/// The sides of a bracket as eigenvalues, rounded to the side that makes the test harder: the upper one is proven, the
/// lower one cannot be.
void expectExactBracket(const CriticalStep& step, const Body& body, const NodeVectors& x, const std::string& which) {
  constexpr double ofSquare = 1e-15;
  const double upper = verletLimit / step.safe * (verletLimit / step.safe) * (1 - ofSquare),
               lower = verletLimit / step.optimistic * (verletLimit / step.optimistic) * (1 - ofSquare);
  const check::Verdict above = test::exactlyBelow(body, x, upper);
  EXPECT_EQ(above.status, Status::proven) << which << ": the safe side, " << step.safe << ": " << above.reason;
  EXPECT_EQ(test::exactlyBelow(body, x, lower).status, Status::notProven)
      << which << ": the optimistic side, " << step.optimistic;
}

TEST_P(Adversarial, HasBracketsAndCertificatesThatHoldExactly) {
  const test::BodyCase& c = GetParam();
  // Balls take their time: all states of small elements, else one state of each hardship, of the largest of every
  // third.
  const std::size_t work = static_cast<std::size_t>(c.element->nodes) * c.rule->points.size();
  const std::size_t every = work > 100 ? 3 : 1;
  int tried = 0;
  for (std::size_t k = work % every; k < std::size(hardships); k += every) {
    const Hardship& hard = hardships[k];
    test::Random random(3);
    const Body body = bodyOf(c, hard);
    const std::vector<NodeVectors> states = statesOf(body.mesh().X, random);
    for (std::size_t state = 0; state < states.size(); ++state) {
      if (work > 4 && state != k % states.size()) continue;
      const NodeVectors& x = states[state];
      const std::string which = std::string(hard.name) + ", state " + std::to_string(state);
      std::optional<CriticalStep> step;
      try {
        step = criticalStep(body, x, verletLimit);
      } catch (const NumericalError&) {
        continue;  // where rounding leaves nothing to say, that is said
      }
      expectExactBracket(*step, body, x, which);
      const check::Verdict written = check::verify(makeCertificate(body, x).bytes);
      EXPECT_EQ(written.status, Status::proven) << which << ": " << written.reason;
      ++tried;
    }
  }
  EXPECT_GE(tried, work > 100 ? 2 : work > 4 ? 6 : 18);
}

TEST_P(Adversarial, HasBracketsAlongARunThatHoldExactly) {
  const test::BodyCase& c = GetParam();
  if (c.element->nodes > 8 || c.rule != c.element->rules.data()) GTEST_SKIP() << "one rule of each small element";
  int tried = 0;
  for (const Hardship& hard : hardships) {
    test::Random random(4);
    const Body body = bodyOf(c, hard);
    RunBracket run(body, 0.05, infinity);
    const NodeVectors& X = body.mesh().X;
    const Eigen::Vector3d centre = X.col(0);
    const Eigen::Matrix3d strain = random.matrix(0.02);
    double h = 0;
    for (int look = 0; look < 3; ++look) {
      const NodeVectors x = ((Eigen::Matrix3d::Identity() + look * strain) * (X.colwise() - centre)).colwise() + centre;
      const std::string which = std::string(hard.name) + ", observation " + std::to_string(look);
      if (look == 2) {  // by the threshold: the step alone
        if (!run.certify(x, verletLimit, h, nullptr)) continue;
        EXPECT_EQ(test::exactlyBelow(body, x, verletLimit / h * (verletLimit / h)).status, Status::proven) << which;
        ++tried;
        continue;
      }
      const std::optional<CriticalStep>& bracket = run.evaluate(x, verletLimit, std::nullopt, nullptr);
      if (!bracket) continue;
      expectExactBracket(*bracket, body, x, which);
      h = 0.9 * bracket->safe;
      ++tried;
    }
  }
  EXPECT_GE(tried, 14);
}

}  // namespace
}  // namespace ringwatch

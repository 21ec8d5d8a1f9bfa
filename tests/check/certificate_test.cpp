// Certificates of every element, rule and law are proven by the checker.
#include <gtest/gtest.h>

#include <check/proof.h>
#include <ringwatch/base/error.h>
#include <ringwatch/monitor/certificate_file.h>
#include <ringwatch/monitor/critical_step.h>
#include <ringwatch/monitor/exact_step.h>
#include <tests/check/exact_element.h>
#include <tests/support/body_cases.h>
#include <tests/support/comma_locale.h>

namespace ringwatch {
namespace {

using check::Verdict;
using Status = check::Verdict::Status;

constexpr double limit = 2;

class CertificateTest : public ::testing::TestWithParam<test::BodyCase> {};
INSTANTIATE_TEST_SUITE_P(All, CertificateTest, ::testing::ValuesIn(test::certifiableBodyCases()),
                         [](const auto& test) { return test::bodyCaseName(test.param); });

TEST_P(CertificateTest, IsProvenByTheChecker) {
  const test::BodyCase& c = GetParam();
  Body body(test::distortedBox(c.element->name, {1, 1, 1}), test::materialOf(c), test::optionsOf(c));
  body.constraints().fix(0);
  body.constraints().fix(1, 2);
  for (const NodeVectors& x : {body.mesh().X, test::strained(body.mesh().X)}) {
    const Certificate certificate = makeCertificate(body, x);
    const Verdict verdict = check::verify(certificate.bytes);
    ASSERT_EQ(verdict.status, Status::proven) << verdict.reason;
    EXPECT_EQ(verdict.elements, body.mesh().elementCount());
    EXPECT_EQ(verdict.sigma, certificate.upper.value);
    EXPECT_EQ(verdict.lower, certificate.lower.value);
    EXPECT_NEAR(verdict.mass, body.totalMass(), 1e-14 * body.totalMass());
    EXPECT_NEAR(verdict.volume, body.volume(), 1e-14 * body.volume());
    // It says what the bracket says.
    const CriticalStep step = criticalStep(body, x, limit);
    EXPECT_LE(limit / std::sqrt(certificate.upper.value), step.optimistic);
    EXPECT_NEAR(limit / std::sqrt(certificate.lower.value), step.optimistic, 1e-8 * step.optimistic);
  }
}

TEST(Certificate, HasTheSameBytesInAProgramWithADecimalComma) {
  const Body body(test::distortedBox("tet4", {1, 1, 1}), makeMaterial("stvk", 30e3, 0.3, 1000));
  const std::string expected = makeCertificate(body, body.mesh().X).bytes;
  const test::CommaLocale comma;
  EXPECT_EQ(makeCertificate(body, body.mesh().X).bytes, expected);
}

TEST_P(CertificateTest, OfAFactorisationIsProvenByTheChecker) {
  const test::BodyCase& c = GetParam();
  Body body(test::distortedBox(c.element->name, {2, 1, 1}), test::materialOf(c), test::optionsOf(c));
  body.constraints().fix(0);
  body.constraints().fix(1, 2);
  const NodeVectors x = test::strained(body.mesh().X);
  const std::optional<ExactStep> exact = exactCriticalStep(body, x, limit);
  ASSERT_TRUE(exact);
  const Certificate certificate = makeFactoredCertificate(body, x, exact->sides);
  const Verdict verdict = check::verify(certificate.bytes);
  ASSERT_EQ(verdict.status, Status::proven) << verdict.reason;
  EXPECT_EQ(limit / std::sqrt(verdict.sigma), exact->safe);
  EXPECT_EQ(limit / std::sqrt(verdict.lower), exact->optimistic);
  EXPECT_NEAR(verdict.volume, body.volume(), 1e-14 * body.volume());
  // A step a hundred thousandth too large is not stable, and one as much too small not unstable.
  ProvenSides wrong = exact->sides;
  wrong.upper.value *= 1 - 2e-5;
  EXPECT_EQ(check::verify(makeFactoredCertificate(body, x, wrong).bytes).reason,
            "upper side: sigma M - K is not positive definite");
  wrong = exact->sides;
  wrong.lower.value *= 1 + 2e-5;
  EXPECT_EQ(check::verify(makeFactoredCertificate(body, x, wrong).bytes).reason,
            "lower side: the vector does not reach it");
}

TEST(Certificate, SaysNothingOfASideThatIsNotProven) {
  const Body body(test::distortedBox("tet4", {2, 1, 1}),
                  makeMaterial("stvk", test::young, test::poisson, test::density));
  const NodeVectors& X = body.mesh().X;
  const double critical = exactCriticalStep(body, X, limit)->safe;
  for (const double share : {0.9, 1.1}) {
    ProvenSides sides;
    const ringwatch::Verdict told = proveStep(body, X, limit, share * critical, {}, &sides);
    ASSERT_EQ(told, share < 1 ? ringwatch::Verdict::certified : ringwatch::Verdict::violated);
    const Verdict verdict = check::verify(makeFactoredCertificate(body, X, sides).bytes);
    ASSERT_EQ(verdict.status, Status::proven) << verdict.reason;
    EXPECT_EQ(verdict.sigma > 0, share < 1);
    EXPECT_EQ(verdict.lower > 0, share > 1);
    if (share < 1) {
      EXPECT_NEAR(limit / std::sqrt(verdict.sigma), share * critical, 1e-12 * critical);
    }
  }
}

TEST(Certificate, RefusesWhatItCannotSay) {
  Body body(test::distortedBox("tet4", {2, 1, 1}), makeMaterial("stvk", test::young, test::poisson, test::density));
  EXPECT_THROW(makeCertificate(body, NodeVectors::Zero(3, 2)), InputError);
  for (std::int32_t i = 0; i < body.nodeCount(); ++i) body.constraints().fix(i);
  EXPECT_THROW(makeCertificate(body, body.mesh().X), NumericalError);
}

}  // namespace
}  // namespace ringwatch

// Certificates of every element, rule and law are proven by the checker.
#include <gtest/gtest.h>

#include <check/proof.h>
#include <ringwatch/base/error.h>
#include <ringwatch/monitor/certificate_file.h>
#include <ringwatch/monitor/critical_step.h>
#include <tests/support/body_cases.h>

namespace ringwatch {
namespace {

using check::Verdict;
using Status = Verdict::Status;

constexpr double limit = 2;

class CertificateTest : public ::testing::TestWithParam<test::BodyCase> {};
INSTANTIATE_TEST_SUITE_P(All, CertificateTest, ::testing::ValuesIn(test::allBodyCases()),
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
    EXPECT_LE(limit / std::sqrt(certificate.upper.value), step.safe * (1 + 1e-6));
    EXPECT_NEAR(limit / std::sqrt(certificate.lower.value), step.optimistic, 1e-8 * step.optimistic);
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

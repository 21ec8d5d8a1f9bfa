// Certificates by the exchange bound say what the bracket says, are proven by the checker, and no longer when they were
// tampered with.
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include <check/proof.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <ringwatch/monitor/certificate_file.h>
#include <ringwatch/monitor/critical_step.h>
#include <tests/check/exact_element.h>
#include <tests/check/seal.h>
#include <tests/monitor/monitor_cases.h>
#include <tests/support/body_cases.h>

namespace ringwatch {
namespace {

using Status = check::Verdict::Status;

constexpr double leapfrogLimit = 2;

TEST(ExchangeCertificate, ProvesTheBracketOfRegularGrids) {
  int exchanged = 0;
  for (const test::Subdivision& subdivision : test::allSubdivisions())
    for (const double jitter : {0.0, 0.2}) {
      Body body = test::boxBody(subdivision, "stvk", {3, 3, 3}, jitter);
      body.constraints().fix(0);
      body.constraints().fix(1, 2);
      for (const NodeVectors& x : {body.mesh().X, test::strained(body.mesh().X)}) {
        const std::string name = std::string(subdivision.name) + ", jitter " + std::to_string(jitter);
        const Certificate certificate = makeCertificate(body, x, UpperSideBy::tighterOfBoth);
        const check::Verdict verdict = check::verify(certificate.bytes);
        ASSERT_EQ(verdict.status, Status::proven) << name << ": " << verdict.reason;
        EXPECT_EQ(verdict.sigma, certificate.upper.value);
        EXPECT_EQ(verdict.lower, certificate.lower.value);
        const CriticalStep step = criticalStep(body, x, leapfrogLimit);
        // Whole numbers cost what their rounding takes, and the last iterate is not the best one.
        EXPECT_NEAR(leapfrogLimit / std::sqrt(certificate.upper.value), step.safe, 0.01 * step.safe) << name;
        const double lambda = globalFrequency(body, x, 1e-10).lambda;
        EXPECT_GE(verdict.sigma, lambda * (1 - 1e-9)) << name;
        if (certificate.proof != "exchange-bound") continue;
        ++exchanged;
        EXPECT_LT(certificate.upper.value, makeCertificate(body, x).upper.value) << name;
      }
    }
  EXPECT_GE(exchanged, 12);
}

TEST(ExchangeCertificate, IsProvenForEveryElementRuleAndLaw) {
  int exchanged = 0;
  for (const test::BodyCase& c : test::certifiableBodyCases()) {
    Body body(test::distortedBox(c.element->name, {2, 1, 1}), test::materialOf(c), test::optionsOf(c));
    body.constraints().fix(0);
    body.constraints().fix(1, 2);
    const Certificate certificate = makeCertificate(body, test::strained(body.mesh().X), UpperSideBy::tighterOfBoth);
    const check::Verdict verdict = check::verify(certificate.bytes);
    ASSERT_EQ(verdict.status, Status::proven) << test::bodyCaseName(c) << ": " << verdict.reason;
    exchanged += certificate.proof == "exchange-bound" ? 1 : 0;
  }
  EXPECT_GE(exchanged, 10);
}

TEST(ExchangeCertificate, IsRejectedByItsMathematicsWhereTheChecksumIsMadeToFit) {
  const Body body(test::distortedBox("hex8", {2, 2, 2}),
                  makeMaterial("stvk", test::young, test::poisson, test::density));
  const NodeVectors& x = body.mesh().X;
  const Certificate certificate = makeCertificate(body, x, UpperSideBy::tighterOfBoth);
  ASSERT_EQ(certificate.proof, "exchange-bound");
  const std::string& bytes = certificate.bytes;
  ASSERT_EQ(check::verify(test::sealed(bytes)).status, Status::proven);
  constexpr std::size_t size = 24, numbers = size * (size + 1) / 2, elementBytes = 4 * 8 + 4 * numbers;
  const std::size_t elements = bytes.find("\nend\n") + 5 + 81 * static_cast<std::size_t>(body.nodeCount());
  const auto changed = [&](std::size_t element, std::size_t number, std::int32_t by) {
    std::string other = bytes;
    char* at = other.data() + elements + element * elementBytes + 4 * 8 + 4 * number;
    std::int32_t value;
    std::memcpy(&value, at, sizeof value);
    value += by;
    std::memcpy(at, &value, sizeof value);
    return check::verify(test::sealed(std::move(other)));
  };
  const auto place = [](std::size_t row, std::size_t column) { return row * (row + 1) / 2 + column; };
  for (const std::size_t e : {std::size_t{0}, std::size_t{5}}) {
    // By a single unit, between different nodes: the sum is no longer nothing.
    for (std::size_t row = 3; row < size; ++row) {
      const check::Verdict verdict = changed(e, place(row, row % 3), 1);
      EXPECT_EQ(verdict.status, Status::notProven) << e << ", " << row;
      EXPECT_NE(verdict.reason.find("does not add up to nothing"), std::string::npos) << verdict.reason;
    }
    // Less of a node's own block: the tangent is not bounded. More of it: the sum exceeds sigma, where it is reached.
    for (std::size_t row = 0; row < size; ++row) {
      const check::Verdict verdict = changed(e, place(row, row), -(1 << 28));
      EXPECT_EQ(verdict.status, Status::notProven) << e << ", " << row;
      EXPECT_NE(verdict.reason.find("does not bound its tangent"), std::string::npos) << verdict.reason;
    }
    EXPECT_EQ(changed(e, place(0, 0), 1 << 29).status, Status::notProven) << e;
  }
  const std::string lowered = test::withHeader(bytes, "sigma", certificate.upper.value * (1 - 1e-8));
  EXPECT_EQ(check::verify(test::sealed(lowered)).status, Status::notProven);
}

}  // namespace
}  // namespace ringwatch

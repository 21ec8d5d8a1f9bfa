// Elements of random bodies in random states are proven in ball arithmetic, by the certificates of the nodal bound.
//   RINGWATCH_ELEMENT_CHECKS=N   goes on until N elements have been proven (by default some thousands)
//   RINGWATCH_SEED=S             other bodies and states, so that processes side by side try different ones
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <iostream>

#include <gtest/gtest.h>

#include <check/proof.h>
#include <ringwatch/base/error.h>
#include <ringwatch/monitor/certificate_file.h>
#include <tests/check/exact_element.h>
#include <tests/support/body_cases.h>

namespace ringwatch {
namespace {

using Status = check::Verdict::Status;

struct Tally {
  std::int64_t elements = 0, certificates = 0, exchanged = 0, rejected = 0, withoutTangent = 0;
  double seconds = 0;  // of the checker
};

/// A box of elements of any kind, law and rule, jittered, held somewhere, in a state between rest and collapse.
void checkOne(const test::BodyCase& c, test::Random& random, Tally& tally) {
  const double poissons[] = {0.3, 0, 0.45, 0.4999, -0.3};
  // As many elements as take about the same time: a tangent costs the square of its nodes at every point.
  const std::size_t points = c.rule->points.size(), nodes = c.element->nodes;
  const int most = std::clamp(static_cast<int>(std::cbrt(12000.0 / static_cast<double>(points * nodes * nodes))), 1, 8);
  const test::Cells cells{1 + random.index(most), 1 + random.index(most), 1 + random.index(most)};
  Body body(test::distortedBox(c.element->name, cells, random.uniform(0, 0.2)),
            makeMaterial(c.law, std::pow(10, random.uniform(3, 11)), poissons[random.index(5)], 1000),
            test::optionsOf(c));
  for (int held = random.index(4); held > 0; --held)
    body.constraints().fix(random.index(body.nodeCount()), random.index(3));
  NodeVectors x = body.mesh().X;
  switch (random.index(4)) {
    case 0:
      break;
    case 1:
      x = test::strained(x, random.index(1 << 20));
      break;
    case 2:  // strained a lot and turned
      x = random.rotation() * (Eigen::Matrix3d::Identity() + random.matrix(0.3)) * x;
      break;
    default:  // pressed flat
      x = random.rotation() *
          Eigen::Vector3d(1, random.uniform(0.7, 1.3), std::pow(10, -random.uniform(0, 3))).asDiagonal() * x.eval();
  }
  std::string bytes;
  try {
    const Certificate certificate =
        makeCertificate(body, x, tally.certificates % 3 == 0 ? UpperSideBy::tighterOfBoth : UpperSideBy::nodalBound);
    tally.exchanged += certificate.proof == "exchange-bound" ? 1 : 0;
    bytes = certificate.bytes;
  } catch (const NumericalError&) {  // an inverted element of a law that has no tangent there
    ++tally.withoutTangent;
    return;
  }
  const std::clock_t begin = std::clock();
  const check::Verdict verdict = check::verify(bytes);
  tally.seconds += static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  EXPECT_EQ(verdict.status, Status::proven) << test::bodyCaseName(c) << ": " << verdict.reason;
  tally.rejected += verdict.status == Status::proven ? 0 : 1;
  tally.elements += body.mesh().elementCount();
  ++tally.certificates;
}

TEST(ManyChecks, ProveEveryElement) {
  const char *asked = std::getenv("RINGWATCH_ELEMENT_CHECKS"), *seed = std::getenv("RINGWATCH_SEED");
  const std::int64_t wanted = asked ? std::atoll(asked) : 2000;
  test::Random random(seed ? std::strtoull(seed, nullptr, 10) : 1);
  std::vector<test::BodyCase> cases = test::certifiableBodyCases();
  Tally tally;
  while (tally.elements < wanted && tally.rejected == 0) {
    checkOne(cases[random.index(static_cast<int>(cases.size()))], random, tally);
    ASSERT_LT(tally.withoutTangent, 100 + tally.certificates);
  }
  EXPECT_EQ(tally.rejected, 0);
  EXPECT_GE(tally.elements, wanted);
  EXPECT_GE(tally.exchanged, 1);
  if (asked)
    std::cout << tally.elements << " elements of " << tally.certificates << " certificates, " << tally.exchanged
              << " by the exchange bound, " << tally.rejected << " rejected; " << tally.withoutTangent
              << " states without a tangent; checker " << static_cast<double>(tally.elements) / tally.seconds
              << " elements a second\n";
}

}  // namespace
}  // namespace ringwatch

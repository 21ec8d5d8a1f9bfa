// No certificate that was tampered with is proven.
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <optional>

#include <gtest/gtest.h>

#include <check/proof.h>
#include <ringwatch/monitor/certificate_file.h>
#include <ringwatch/monitor/exact_step.h>
#include <tests/check/exact_element.h>
#include <tests/check/seal.h>
#include <tests/support/body_cases.h>

namespace ringwatch {
namespace {

using Status = check::Verdict::Status;

using test::sealed;

Body smallBody() {
  return Body(test::distortedBox("tet4", {2, 1, 1}), makeMaterial("stvk", test::young, test::poisson, test::density));
}

TEST(TamperedCertificate, IsRejectedWhateverBitIsChanged) {
  const char* asked = std::getenv("RINGWATCH_TAMPERED_CERTIFICATES");
  const int trials = asked ? std::atoi(asked) : 2000;
  const Body body = smallBody();
  const std::string bytes = makeCertificate(body, test::strained(body.mesh().X)).bytes;
  ASSERT_EQ(check::verify(bytes).status, Status::proven);
  test::Random random(5);
  int rejected = 0;
  for (int i = 0; i < trials; ++i) {
    std::string other = bytes;
    char& byte = other[random.index(static_cast<int>(bytes.size()))];
    byte = static_cast<char>(byte ^ 1 << random.index(8));
    rejected += check::verify(other).status == Status::proven ? 0 : 1;
  }
  EXPECT_EQ(rejected, trials);
  if (asked) std::cout << rejected << " of " << trials << " rejected\n";
}

/// Places in the file of smallBody's certificate: the first node, the first element.
struct Places {
  std::size_t nodes, elements, elementSize = 4 * 4 + 8 + 4 * 12;
  explicit Places(const std::string& bytes, std::int32_t nodeCount)
      : nodes(bytes.find("\nend\n") + 5), elements(nodes + 81 * static_cast<std::size_t>(nodeCount)) {}
};
/// Replaces the number at a place, which need not be aligned: scale · number + shift.
template <class T = double>
void changeNumber(std::string& bytes, std::size_t place, double scale, double shift) {
  T number;
  std::memcpy(&number, bytes.data() + place, sizeof number);
  number = static_cast<T>(scale * number + shift);
  std::memcpy(bytes.data() + place, &number, sizeof number);
}

TEST(TamperedCertificate, IsRejectedByItsMathematicsWhereTheChecksumIsMadeToFit) {
  const Body body = smallBody();
  const NodeVectors x = test::strained(body.mesh().X);
  const Certificate certificate = makeCertificate(body, x);
  const std::string& bytes = certificate.bytes;
  ASSERT_EQ(check::verify(sealed(bytes)).status, Status::proven) << check::verify(bytes).reason;
  const Places at(bytes, body.nodeCount());
  const std::size_t elements = body.mesh().elementCount();
  int tried = 0;
  const auto expectRejected = [&](const std::string& other, const std::string& what) {
    ++tried;
    EXPECT_NE(check::verify(sealed(other)).status, Status::proven) << what;
  };
  const auto header = [&](const std::string& key, double value) { return test::withHeader(bytes, key, value); };
  expectRejected(header("sigma", certificate.upper.value * (1 - 1e-8)), "sigma");
  expectRejected(header("lower", certificate.lower.value * (1 + 1e-8)), "lower side");
  expectRejected(header("lower", certificate.upper.value), "lower side at sigma");
  for (std::size_t e = 0; e < elements; ++e) {
    const std::size_t element = at.elements + e * at.elementSize;
    const std::string which = " of element " + std::to_string(e);
    std::string other = bytes;
    changeNumber(other, element + 16, 1 - 1e-9, 0);
    expectRejected(other, "allowance" + which);
    changeNumber(other, element + 16, 0, -1);
    expectRejected(other, "negative allowance" + which);
    const auto scaleWeight = [&](std::size_t w, double scale) {
      changeNumber<std::int16_t>(other, element + 24 + 2 * w, scale, 0);
    };
    for (std::size_t w = 0; w < 24; ++w) {
      if (w % 6 >= 3) continue;
      other = bytes;  // zero on the diagonal of a factor: its block has no weight in some direction
      scaleWeight(w, 0);
      expectRejected(other, "weight " + std::to_string(w) + which);
    }
    other = bytes;
    for (std::size_t w = 0; w < 24; ++w) scaleWeight(w, 0.99);
    expectRejected(other, "all weights" + which);
    other = bytes;  // two of its nodes swapped: the Jacobian turns round
    for (std::size_t i = 0; i < 4; ++i) std::swap(other[element + i], other[element + 4 + i]);
    expectRejected(other, "swapped nodes" + which);
    other = bytes;
    std::memcpy(other.data() + element, other.data() + element + 4, 4);
    expectRejected(other, "a node twice" + which);
    other = bytes;  // missing, and the count says so or not
    other.erase(element, at.elementSize);
    expectRejected(other, "missing" + which);
  }
  for (std::int32_t i = 0; i < body.nodeCount(); ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      std::string other = bytes;
      changeNumber(other, at.nodes + 81 * static_cast<std::size_t>(i) + 8 * c, 1, 3 * test::cellSize);
      expectRejected(other, "reference position of node " + std::to_string(i));
      other = bytes;
      changeNumber(other, at.nodes + 81 * static_cast<std::size_t>(i) + 24 + 8 * c, 1, 3 * test::cellSize);
      expectRejected(other, "position of node " + std::to_string(i));
    }
  EXPECT_GT(tried, 200);
}

/// A proven certificate of a small body, of any element, law and rule, in a strained state; some by a factorisation.
struct Genuine {
  std::string bytes;
  bool factored;
  int nodesOfElement;
  std::int32_t nodes;
  std::size_t elements;
};
std::vector<Genuine> genuineCertificates(int count, test::Random& random) {
  const std::vector<test::BodyCase> cases = test::certifiableBodyCases();
  std::vector<Genuine> made;
  while (static_cast<int>(made.size()) < count) {
    const test::BodyCase& c = cases[random.index(static_cast<int>(cases.size()))];
    if (c.element->nodes > 10) continue;  // they take long
    const Body body(test::distortedBox(c.element->name, {1, 1, 1}), test::materialOf(c), test::optionsOf(c));
    const NodeVectors x = test::strained(body.mesh().X, random.index(1000));
    Genuine next{{}, random.index(4) == 0, c.element->nodes, body.nodeCount(), body.mesh().elementCount()};
    if (next.factored) {
      const std::optional<ExactStep> exact = exactCriticalStep(body, x, 2);
      if (!exact) continue;
      next.bytes = makeFactoredCertificate(body, x, exact->sides).bytes;
    } else {
      next.bytes = makeCertificate(body, x).bytes;
    }
    made.push_back(std::move(next));
  }
  return made;
}

/// Changes one thing that the claim rests on; says what.
std::string tamper(std::string& bytes, const Genuine& of, test::Random& random) {
  const std::size_t nodes = bytes.find("\nend\n") + 5, elements = nodes + 81 * static_cast<std::size_t>(of.nodes),
                    n = of.nodesOfElement, elementSize = of.factored ? 4 * n : 16 * n + 8,
                    element =
                        elements + elementSize * static_cast<std::size_t>(random.index(static_cast<int>(of.elements)));
  // A factorisation leaves a millionth between its sides.
  const double part = (of.factored ? 1e-5 : 1e-8) * std::pow(10, random.uniform(0, 3));
  const auto header = [&](const std::string& key, double scale) {
    bytes = test::withHeader(bytes, key, scale * test::headerNumber(bytes, key));
    return key;
  };
  switch (random.index(of.factored ? 6 : 9)) {
    case 0:
      return header("sigma", 1 - part);
    case 1:
      return header("lower", 1 + part);
    case 2: {  // a corner goes to the other side of its element
      std::int32_t own[20];
      std::memcpy(own, bytes.data() + element, 4 * n);
      Eigen::Matrix3Xd X(3, of.nodesOfElement);
      for (std::size_t a = 0; a < n; ++a)
        std::memcpy(X.col(static_cast<Eigen::Index>(a)).data(),
                    bytes.data() + nodes + 81 * static_cast<std::size_t>(own[a]), 24);
      const Eigen::Vector3d moved = 4 * X.rowwise().mean() - 3 * X.col(0);
      std::memcpy(bytes.data() + nodes + 81 * static_cast<std::size_t>(own[0]), moved.data(), 24);
      return "a reference position";
    }
    case 3:
      bytes.erase(element, elementSize);
      return "a missing element";
    case 4:
      std::memcpy(bytes.data() + element, bytes.data() + element + 4, 4);
      return "a node twice";
    case 5:
      // Of a stiffness half as large again, where the file has it, behind the name of the law and the count.
      for (std::size_t kind = bytes.find("\nkind "); kind < nodes; kind = bytes.find("\nkind ", kind + 1)) {
        std::size_t word = kind + 1;
        for (int skipped = 0; skipped < 5; ++skipped) word = bytes.find(' ', word) + 1;
        char text[40];
        std::snprintf(text, sizeof text, "%a", 1.5 * std::strtod(bytes.c_str() + word, nullptr));
        bytes.replace(word, bytes.find(' ', word) - word, text);
      }
      return "mu";
    case 6:
      changeNumber(bytes, element + 4 * n, 1 - 1e-9 * std::pow(10, random.uniform(0, 6)), 0);
      return "an allowance";
    case 7:
      for (std::size_t w = 0; w < 6 * n; ++w) changeNumber<std::int16_t>(bytes, element + 4 * n + 8 + 2 * w, 0.98, 0);
      return "the weights of an element";
    default:
      changeNumber<std::int16_t>(
          bytes, element + 4 * n + 8 + 12 * static_cast<std::size_t>(random.index(static_cast<int>(n))), 0, 0);
      return "a weight";
  }
}

TEST(TamperedCertificate, IsRejectedByItsMathematicsWhateverIsChanged) {
  const char *asked = std::getenv("RINGWATCH_TAMPERED_CERTIFICATES"), *seed = std::getenv("RINGWATCH_SEED");
  const int trials = asked ? std::atoi(asked) : 300;
  test::Random random(seed ? std::strtoull(seed, nullptr, 10) : 5);
  const std::vector<Genuine> genuine = genuineCertificates(asked ? 200 : 24, random);
  for (const Genuine& one : genuine) ASSERT_EQ(check::verify(one.bytes).status, Status::proven);
  int rejected = 0, factored = 0;
  for (int i = 0; i < trials; ++i) {
    const Genuine& of = genuine[random.index(static_cast<int>(genuine.size()))];
    std::string other = of.bytes;
    const std::string what = tamper(other, of, random);
    const bool accepted = check::verify(sealed(other)).status == Status::proven;
    EXPECT_FALSE(accepted) << what << ", elements of " << of.nodesOfElement << " nodes, "
                           << (of.factored ? "factorisation" : "nodal bound");
    rejected += accepted ? 0 : 1;
    factored += of.factored ? 1 : 0;
  }
  EXPECT_EQ(rejected, trials);
  EXPECT_GT(factored, trials / 20);
  if (asked) std::cout << rejected << " of " << trials << " rejected whose checksum fits\n";
}

/// Where a change leaves a true statement, of another body.
TEST(TamperedCertificate, IsOfAnotherBodyWhereItsMathematicsHolds) {
  const Body body = smallBody();
  const std::string bytes = makeCertificate(body, test::strained(body.mesh().X)).bytes;
  EXPECT_EQ(check::verify(bytes).hash, certifiedBodyHash(body));
  const Places at(bytes, body.nodeCount());
  std::string heavier = bytes, held = bytes;
  changeNumber(heavier, at.nodes + 48, 1 + 1e-15, 0);
  held[at.nodes + 80] = 7;
  for (std::size_t c = 0; c < 3; ++c) changeNumber(held, at.nodes + 56 + 8 * c, 0, 0);
  for (const std::string& other : {heavier, test::withHeader(held, "lower", 0)}) {
    const check::Verdict verdict = check::verify(sealed(other));
    EXPECT_EQ(verdict.status, Status::proven) << verdict.reason;
    EXPECT_NE(verdict.hash, certifiedBodyHash(body));
  }
}

TEST(TamperedCertificate, IsNotProvenWhereItClaimsNothing) {
  Body body = smallBody();
  for (std::int32_t i = 0; i < body.nodeCount(); ++i) body.constraints().fix(i);
  const std::string bytes =
      makeFactoredCertificate(body, body.mesh().X, ProvenSides{{1.0}, {0}, NodeVectors(3, 0)}).bytes;
  EXPECT_EQ(check::verify(bytes).status, Status::proven);
  for (const double sigma : {-1.0, 0.0})
    EXPECT_EQ(check::verify(sealed(test::withHeader(bytes, "sigma", sigma))).status, Status::notProven) << sigma;
}

TEST(TamperedCertificate, IsUnreadableWhereItIsCut) {
  const Body body = smallBody();
  const std::string bytes = makeCertificate(body, body.mesh().X).bytes;
  for (std::size_t size = 0; size < bytes.size(); size += 7) {
    EXPECT_EQ(check::verify(bytes.substr(0, size)).status, Status::unreadable) << size;
    if (size < 8) continue;
    EXPECT_NE(check::verify(sealed(bytes.substr(0, size))).status, Status::proven) << size;
  }
  EXPECT_EQ(check::verify(sealed(bytes + std::string(9, ' '))).status, Status::unreadable);
}

}  // namespace
}  // namespace ringwatch

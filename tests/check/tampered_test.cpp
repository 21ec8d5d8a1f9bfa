// No certificate that was tampered with is proven.
#include <cstdlib>
#include <cstring>
#include <iostream>

#include <gtest/gtest.h>

#include <check/proof.h>
#include <ringwatch/monitor/certificate_file.h>
#include <tests/support/body_cases.h>

namespace ringwatch {
namespace {

using Status = check::Verdict::Status;

/// The last eight bytes made right again.
std::string sealed(std::string bytes) {
  std::uint64_t sum = 0xcbf29ce484222325ULL;
  for (std::size_t i = 0; i + 8 < bytes.size(); ++i)
    sum = (sum ^ static_cast<unsigned char>(bytes[i])) * 0x100000001b3ULL;
  std::memcpy(bytes.data() + bytes.size() - 8, &sum, 8);
  return bytes;
}

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
  const auto header = [&](const std::string& key, double value) {
    std::string other = bytes;
    const std::size_t from = other.find("\n" + key + " ") + key.size() + 2, end = other.find('\n', from);
    char text[40];
    std::snprintf(text, sizeof text, "%a", value);
    return other.replace(from, end - from, text);
  };
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

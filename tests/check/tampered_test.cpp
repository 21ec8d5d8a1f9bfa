// A certificate that was tampered with is proven only where it is true all the same.
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <iterator>
#include <optional>
#include <sstream>

#include <gtest/gtest.h>

#include <check/proof.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/monitor/certificate_file.h>
#include <ringwatch/monitor/exact_step.h>
#include <tests/check/exact_element.h>
#include <tests/check/seal.h>
#include <tests/support/body_cases.h>
#include <tests/support/dense.h>

namespace ringwatch {
namespace {

using Status = check::Verdict::Status;

using test::sealed;

Body smallBody() {
  return Body(test::distortedBox("tet4", {2, 1, 1}), makeMaterial("stvk", test::young, test::poisson, test::density));
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

/// A certificate by the grammar of its format: lines of words, records of nodes and of elements.
struct Parts {
  std::vector<std::string> lines, nodes, elements;
  std::size_t corners = 0;  // of an element

  explicit Parts(const std::string& bytes) {
    const std::size_t end = bytes.find("\nend\n") + 5, count = static_cast<std::size_t>(number(bytes, "nodes"));
    std::istringstream header(bytes.substr(0, end));
    for (std::string line; std::getline(header, line);) lines.push_back(line);
    for (std::size_t i = 0; i < count; ++i) nodes.push_back(bytes.substr(end + 81 * i, 81));
    const std::vector<std::string> kind = words(lines[6]);
    corners = static_cast<std::size_t>(findElementByName(kind[1])->nodes);
    const std::size_t begin = end + 81 * count, many = std::stoul(kind[3]), size = (bytes.size() - 8 - begin) / many;
    for (std::size_t e = 0; e < many; ++e) elements.push_back(bytes.substr(begin + size * e, size));
  }
  static double number(const std::string& bytes, const std::string& key) { return test::headerNumber(bytes, key); }
  static std::vector<std::string> words(const std::string& line) {
    std::istringstream text(line);
    return {std::istream_iterator<std::string>(text), {}};
  }
  std::string bytes() const {
    std::string all;
    for (const std::string& line : lines) all += line + '\n';
    for (const auto* records : {&nodes, &elements})
      for (const std::string& record : *records) all += record;
    return sealed(all + std::string(8, 0));
  }
};
template <class T>
T numberAt(const std::string& bytes, std::size_t place) {
  T number;
  std::memcpy(&number, bytes.data() + place, sizeof number);
  return number;
}
template <class T>
void setNumber(std::string& bytes, std::size_t place, T number) {
  std::memcpy(bytes.data() + place, &number, sizeof number);
}

/// What a certificate is about, by a dense eigenvalue of the library's own elements and laws: whether
/// lower <= lambda_max(M^-1 K) <= sigma, to rounding. Nothing where a number is beyond doubles.
std::optional<bool> isTrue(const std::string& bytes) {
  const Parts parts(bytes);
  const std::vector<std::string> kind = Parts::words(parts.lines[6]);
  const ElementInfo& element = *findElementByName(kind[1]);
  const int n = element.nodes;
  double constants[6];
  for (std::size_t k = 0; k < 6; ++k) constants[k] = std::strtod(kind[4 + k].c_str(), nullptr);
  const auto materialOf = [&](double lambda, double mu) {
    Material material = makeMaterial(kind[2], test::young, test::poisson, test::density);
    std::visit(
        [&](auto& law) {
          if constexpr (requires { law.constants.lambda; }) law.constants = {lambda, mu};
        },
        material.law);
    return material;
  };
  const Material atPoints = materialOf(constants[0] * constants[2], constants[1] * constants[3]),
                 atMean = materialOf(constants[0] * constants[4], constants[1] * constants[5]);
  const auto size = static_cast<Eigen::Index>(3 * parts.nodes.size());
  test::LongMatrix K = test::LongMatrix::Zero(size, size);
  for (const std::string& record : parts.elements) {
    Eigen::MatrixXd X(3, n), x(3, n), mean = Eigen::MatrixXd::Zero(n, 3);
    std::vector<std::int32_t> own;
    for (int a = 0; a < n; ++a) {
      own.push_back(numberAt<std::int32_t>(record, 4 * static_cast<std::size_t>(a)));
      std::memcpy(X.col(a).data(), parts.nodes[own.back()].data(), 24);
      std::memcpy(x.col(a).data(), parts.nodes[own.back()].data() + 24, 24);
    }
    const auto add = [&](const Material& material, double weight, const Eigen::MatrixXd& g) {
      const Matrix3<double> F = test::toMatrix3(x * g);
      for (int b = 0; b < n; ++b)
        for (int k = 0; k < 3; ++k) {
          Eigen::Matrix3d dF = Eigen::Matrix3d::Zero();
          dF.row(k) = g.row(b);
          const Eigen::MatrixXd column =
              weight * test::toEigen(material.stressDifferential(F, test::toMatrix3(dF))) * g.transpose();
          for (int a = 0; a < n; ++a)
            for (int i = 0; i < 3; ++i) K(3 * own[a] + i, 3 * own[b] + k) += column(i, a);
        }
    };
    double volume = 0;
    for (std::size_t line = 7; line + 1 < parts.lines.size(); ++line) {
      const std::vector<std::string> words = Parts::words(parts.lines[line]);
      double point[4];
      for (std::size_t k = 0; k < 4; ++k) point[k] = std::strtod(words[1 + k].c_str(), nullptr);
      Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor> dN(n, 3);
      element.shapeGradient(point, reinterpret_cast<double(*)[3]>(dN.data()));
      const Eigen::Matrix3d J = X * dN;
      const Eigen::MatrixXd g = dN * J.inverse();
      const double weight = point[3] * J.determinant();
      add(atPoints, weight, g);
      volume += weight;
      mean += weight * g;
    }
    if (constants[4] != 0 || constants[5] != 0) add(atMean, volume, mean / volume);
  }
  std::vector<Eigen::Index> free;
  for (Eigen::Index i = 0; i < size; ++i) {
    const std::string& node = parts.nodes[static_cast<std::size_t>(i / 3)];
    const long double scale = 1 / std::sqrt(static_cast<long double>(numberAt<double>(node, 48)));
    K.row(i) *= scale;
    K.col(i) *= scale;
    if ((node[80] >> i % 3 & 1) == 0) free.push_back(i);
  }
  const test::LongMatrix A = K(free, free);
  if (!A.allFinite()) return {};
  const double largest = free.empty() ? -infinity : test::highestEigenvalue(A),
               rounding = 1e-9 * static_cast<double>(free.empty() ? 0 : A.cwiseAbs().maxCoeff()),
               sigma = Parts::number(bytes, "sigma"), lower = Parts::number(bytes, "lower");
  return (sigma == 0 || largest <= sigma + rounding) && (lower == 0 || lower <= largest + rounding);
}

/// Proven certificates of small bodies of many elements, laws and rules, some held, by every proof.
std::vector<std::string> genuineCertificates() {
  std::vector<std::string> made;
  int number = 0;
  for (const test::BodyCase& c : test::certifiableBodyCases()) {
    const bool takesLong = c.element->nodes > 8 || c.element->nodes == 5 || c.rule != c.element->rules.data();
    if (takesLong) continue;
    Body body(test::distortedBox(c.element->name, {1, 1, 1}), test::materialOf(c), test::optionsOf(c));
    body.constraints().fix(0);
    body.constraints().fix(1, 2);
    const NodeVectors x = test::strained(body.mesh().X, static_cast<std::uint64_t>(number));
    const std::optional<ExactStep> exact = exactCriticalStep(body, x, 2);
    if (++number % 3 == 0 && exact)
      made.push_back(makeFactoredCertificate(body, x, exact->sides).bytes);
    else
      made.push_back(
          makeCertificate(body, x, number % 3 == 1 ? UpperSideBy::tighterOfBoth : UpperSideBy::nodalBound).bytes);
  }
  return made;
}

/// A number beside another one, or a special one.
double numberNear(double value, test::Random& random) {
  constexpr double special[] = {0, -0.0, -1, 1e308, 5e-324, infinity, -infinity, NAN};
  if (random.index(4) == 0) return special[random.index(static_cast<int>(std::size(special)))];
  return value * (1 + (random.index(2) == 0 ? -1 : 1) * std::pow(10, random.uniform(-14, 1)));
}
std::string wordNear(const std::string& word, test::Random& random) {
  constexpr const char* special[] = {"nan", "inf", "0",    "-0", "1e308", "1e999", "0x1p+99999", "4294967297",
                                     "1e3", "",    "tet4", "x",  "hex8",  "stvk",  "linear",     "corotational"};
  const double value = std::strtod(word.c_str(), nullptr);
  if (random.index(3) == 0) return special[random.index(static_cast<int>(std::size(special)))];
  char text[40];
  if (word.find('x') == std::string::npos && value == std::floor(value))
    return std::to_string(static_cast<std::int64_t>(value) + random.index(3) - 1);
  std::snprintf(text, sizeof text, "%a", numberNear(value, random));
  return text;
}
/// Swaps, doubles, removes or replaces an entry of a list, also by one of another certificate.
void rearrange(std::vector<std::string>& list, const std::vector<std::string>& other, test::Random& random) {
  const auto any = [&](const auto& of) { return static_cast<std::size_t>(random.index(static_cast<int>(of.size()))); };
  const std::size_t i = any(list), j = any(list);
  switch (random.index(5)) {
    case 0:
      return std::swap(list[i], list[j]);
    case 1:
      return void(list.insert(list.begin() + static_cast<std::ptrdiff_t>(i), std::string(list[j])));
    case 2:
      return void(list.erase(list.begin() + static_cast<std::ptrdiff_t>(i)));
    case 3:
      return void(list[i] = std::string(list[j]));
    default:
      list[i] = other[any(other)];
  }
}

std::string tampered(const Parts& genuine, const Parts& other, test::Random& random) {
  Parts parts = genuine;
  const auto any = [&](auto& list) -> auto& { return list[random.index(static_cast<int>(list.size()))]; };
  std::string& node = any(parts.nodes);
  std::string& element = any(parts.elements);
  const std::size_t nodeField = 8 * static_cast<std::size_t>(random.index(10)), ids = 4 * parts.corners,
                    corner = 4 * static_cast<std::size_t>(random.index(static_cast<int>(parts.corners)));
  const bool nodal = parts.lines[1] == "proof nodal-bound";
  switch (random.index(9)) {
    case 0: {
      std::string& line = any(parts.lines);
      std::vector<std::string> words = Parts::words(line);
      std::string& word = any(words);
      word = wordNear(word, random);
      line.clear();
      for (const std::string& each : words) line += (line.empty() ? "" : " ") + each;
      break;
    }
    case 1:
      rearrange(parts.lines, other.lines, random);
      break;
    case 2:
      rearrange(parts.nodes, other.nodes, random);
      break;
    case 3:
      rearrange(parts.elements, other.elements, random);
      break;
    case 4:
      setNumber(node, nodeField, numberNear(numberAt<double>(node, nodeField), random));
      break;
    case 5:
      node[80] = static_cast<char>(random.index(256));
      break;
    case 6: {
      const std::int32_t count = static_cast<std::int32_t>(parts.nodes.size()), index[] = {-1, count, INT32_MAX};
      setNumber(element, corner, random.index(4) == 0 ? index[random.index(3)] : random.index(count));
      break;
    }
    case 7:
      if (nodal) setNumber(element, ids, numberNear(numberAt<double>(element, ids), random));
      break;
    default:  // of the proof: a number, 16 or 32 bits
      if (element.size() <= ids + 8) break;
      const auto numbers = static_cast<int>(element.size() - ids - (nodal ? 8 : 0)) / (nodal ? 2 : 4);
      const std::size_t place = ids + (nodal ? 8 + 2 * random.index(numbers) : 4 * random.index(numbers));
      if (nodal)
        changeNumber<std::int16_t>(element, place, random.index(3) - 1, random.index(201) - 100);
      else
        changeNumber<std::int32_t>(element, place, random.index(3) - 1, random.index(201) - 100);
  }
  std::string bytes = parts.bytes();
  const auto place = static_cast<std::size_t>(random.index(static_cast<int>(bytes.size() - 8)));
  switch (random.index(20)) {
    case 0:
      return sealed(bytes.substr(0, place + 8));
    case 1:
      return sealed(bytes + std::string(1 + place % 9, random.index(2) == 0 ? ' ' : '\0'));
    case 2:
    case 3:
      bytes[place] = static_cast<char>(bytes[place] ^ 1 << random.index(8));
      return sealed(bytes);
    default:
      return bytes;
  }
}

/// RINGWATCH_TAMPERED_CERTIFICATES=N tries N; RINGWATCH_TAMPERED_FOLDER is where they are written, for another checker.
TEST(TamperedCertificate, IsProvenOnlyWhereItIsTrue) {
  const auto asked = [](const char* name, long usual) {
    const char* text = std::getenv(name);
    return text ? std::atol(text) : usual;
  };
  const long trials = asked("RINGWATCH_TAMPERED_CERTIFICATES", 10000);
  const char* folder = std::getenv("RINGWATCH_TAMPERED_FOLDER");
  test::Random random(static_cast<std::uint64_t>(asked("RINGWATCH_SEED", 5)));
  std::vector<Parts> genuine;
  for (const std::string& bytes : genuineCertificates()) {
    ASSERT_EQ(check::verify(bytes).status, Status::proven) << check::verify(bytes).reason;
    ASSERT_TRUE(isTrue(bytes).value());
    genuine.emplace_back(bytes);
  }
  const auto any = [&]() -> const Parts& { return genuine[random.index(static_cast<int>(genuine.size()))]; };
  long proven = 0, undecided = 0;
  for (long i = 0; i < trials; ++i) {
    std::string bytes = tampered(any(), any(), random);
    if (folder)
      std::ofstream(std::string(folder) + "/" + std::to_string(i) + ".certificate", std::ios::binary) << bytes;
    const bool accepted = check::verify(bytes).status == Status::proven;
    if (accepted) {
      ++proven;
      const std::optional<bool> holds = isTrue(bytes);
      undecided += holds ? 0 : 1;
      if (!holds.value_or(true)) {
        const std::string kept = ::testing::TempDir() + "tampered_" + std::to_string(i) + ".certificate";
        std::ofstream(kept, std::ios::binary) << bytes;
        ADD_FAILURE() << kept << " is proven, and not true";
      }
    }
    // And whatever bit is changed, the checksum finds it.
    const auto place = static_cast<std::size_t>(random.index(static_cast<int>(bytes.size())));
    bytes[place] = static_cast<char>(bytes[place] ^ 1 << random.index(8));
    EXPECT_EQ(check::verify(bytes).status, Status::unreadable);
  }
  EXPECT_GT(proven, trials / 20);
  EXPECT_LT(proven, trials / 2);
  EXPECT_LE(undecided, trials / 200);
  std::cout << trials << " tampered with: " << proven << " are proven and true, " << undecided
            << " of them undecided\n";
}

/// Whatever changes nothing of what is said is refused.
TEST(TamperedCertificate, HasOneWayToBeWritten) {
  const std::vector<std::string> genuine = genuineCertificates();
  int tried = 0;
  const auto expectRefused = [&](const Parts& parts, const std::string& what) {
    ++tried;
    EXPECT_NE(check::verify(parts.bytes()).status, Status::proven) << what;
  };
  for (const std::string& bytes : genuine) {
    const Parts parts(bytes);
    for (std::size_t line = 0; line < parts.lines.size(); ++line)
      for (const auto& [from, to] : {std::pair{" ", "\n"},
                                     {" ", "  "},
                                     {" ", " +"},
                                     {" ", " \t"},
                                     {" 0x", " 0X"},
                                     {"p+", "p+0"},
                                     {"p+", "p"},
                                     {"0x0p+0", "-0x0p+0"},
                                     {"0x0p+0", "0"}}) {
        Parts other = parts;
        const std::size_t place = other.lines[line].find(from);
        if (place == std::string::npos) continue;
        other.lines[line].replace(place, std::strlen(from), to);
        expectRefused(other, "line " + std::to_string(line) + ": " + from + " is " + to);
      }
    for (const std::string& end : {std::string(" "), std::string("\r"), std::string("\0x", 2), std::string("e0")}) {
      Parts other = parts;
      other.lines[2] += end;
      expectRefused(other, "nodes, with an end");
    }
    for (std::size_t i : {std::size_t{0}, std::size_t{1}, std::size_t{2}}) {
      for (int bit = 3; bit < 8; ++bit) {
        Parts other = parts;
        other.nodes[i][80] = static_cast<char>(other.nodes[i][80] | 1 << bit);
        expectRefused(other, "held bit " + std::to_string(bit));
      }
      Parts other = parts;
      other.lines[4] = "lower 0x0p+0";
      if (i == 2) expectRefused(other, "a vector that proves nothing");
      if (i == 2) continue;  // it is not held
      other = parts;
      setNumber(other.nodes[i], 72, 1.0);
      expectRefused(other, "the vector where it is held");
      std::string& element = other.elements[0];
      const auto own = [&](std::size_t a) { return numberAt<std::int32_t>(element, 4 * a); };
      for (std::size_t a = 0; a < parts.corners; ++a) {
        other = parts;
        if (own(a) != static_cast<std::int32_t>(i)) continue;
        if (parts.lines[1] == "proof nodal-bound")
          changeNumber<std::int16_t>(element, 4 * parts.corners + 8 + 12 * a + 4, 0, 1);
        else if (parts.lines[1] != "proof factorisation")
          changeNumber<std::int32_t>(element, 4 * (parts.corners + (3 * a + 2) * (3 * a + 5) / 2), 0, 1);
        else
          continue;
        expectRefused(other, "a number of the proof where it is held");
      }
    }
    if (parts.lines[1] != "proof nodal-bound") continue;
    Parts other = parts;  // L and -L have the same product
    for (std::size_t k : {0, 5, 4})
      changeNumber<std::int16_t>(other.elements[0], 4 * parts.corners + 8 + 24 + 2 * k, -1, 0);
    expectRefused(other, "a factor of the other sign");
  }
  EXPECT_GT(tried, 1000);
}

/// Where a change leaves a true statement, of another body.
TEST(TamperedCertificate, IsOfAnotherBodyWhereItsMathematicsHolds) {
  const Body body = smallBody();
  const std::string bytes = makeCertificate(body, test::strained(body.mesh().X)).bytes;
  EXPECT_EQ(check::verify(bytes).hash, certifiedBodyHash(body));
  const Places at(bytes, body.nodeCount());
  std::string heavier = bytes;
  changeNumber(heavier, at.nodes + 48, 1 + 1e-15, 0);
  const check::Verdict verdict = check::verify(sealed(heavier));
  EXPECT_EQ(verdict.status, Status::proven) << verdict.reason;
  EXPECT_NE(verdict.hash, certifiedBodyHash(body));
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

#include "proof.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <stdexcept>
#include <utility>

#include "tangent.h"

namespace check {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are read as they lie in the file");

/// Whole numbers of exchanged matrices are of this part of their unit.
constexpr double numbersOfUnit = 1 << 30;
/// Of a factorisation of the whole body, which takes some ten minutes.
constexpr double mostProducts = 2e10;

struct Unreadable : std::runtime_error {
  using std::runtime_error::runtime_error;
};
struct Unproven : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Takes words and numbers from the file, one after the other. There is one way to write each of them.
class Reader {
 public:
  explicit Reader(const std::string& bytes) : bytes_(bytes) {}

  /// The next word of the header: all up to a blank, or up to the end of the line.
  std::string word(char until = ' ') {
    const std::size_t end = bytes_.find(until, at_);
    if (end == std::string::npos || end - at_ > 60) throw Unreadable("its header is damaged");
    const std::string next = bytes_.substr(at_, end - at_);
    at_ = end + 1;
    return next;
  }
  Reader& expect(const std::string& name, char until = ' ') {
    if (const std::string next = word(until); next != name)
      throw Unreadable("\"" + next + "\" in place of \"" + name + "\"");
    return *this;
  }
  double number(char until = ' ') { return numberOf(word(until)); }
  static double numberOf(const std::string& word) {
    const double value = std::strtod(word.c_str(), nullptr);
    char text[40];
    std::snprintf(text, sizeof text, "%a", value);
    if (word != text || !std::isfinite(value) || word == "-0x0p+0")
      throw Unreadable("\"" + word + "\" is not a number as %a prints it");
    return value;
  }
  /// A positive number of things that take at least `size` bytes each of what is left.
  std::size_t count(std::size_t size, char until = ' ') {
    const std::string next = word(until);
    const std::size_t value = std::strtoull(next.c_str(), nullptr, 10);
    if (value == 0 || next != std::to_string(value)) throw Unreadable("\"" + next + "\" is not a number of things");
    if (value > left() / size) throw Unreadable("it ends too early");
    return value;
  }
  template <class T>
  void take(T* to, std::size_t many) {
    if (many * sizeof(T) > left()) throw Unreadable("it ends too early");
    std::memcpy(to, bytes_.data() + at_, many * sizeof(T));
    at_ += many * sizeof(T);
  }
  std::size_t left() const { return bytes_.size() - at_; }

 private:
  const std::string& bytes_;
  std::size_t at_ = 0;
};

/// FNV-1a, 64 bits.
class Fnv {
 public:
  void add(const void* data, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) value_ = (value_ ^ static_cast<const unsigned char*>(data)[i]) * prime;
  }
  std::uint64_t value() const { return value_; }

 private:
  static constexpr std::uint64_t prime = 0x100000001b3ULL;
  std::uint64_t value_ = 0xcbf29ce484222325ULL;
};

struct Node {
  double numbers[10];  // X, x, mass, u
  std::uint8_t held;   // a bit for each component
  Matrix sum;          // Σ allowance D; of exchanged matrices Σ G
  int row[3];          // of its free components in sigma M - K
  double mass() const { return numbers[6]; }
  bool free(int c) const { return (held >> c & 1) == 0; }
  double u(int c) const { return numbers[7 + c]; }
};

/// The matrix sigma M - K of a body.
struct Whole {
  Rows rows;
  double products = 0;  // of its factorisation

  /// Entry (i, j), j <= i. Its row begins there at the latest from now on.
  Ball& entry(int i, int j) {
    std::vector<Ball>& row = rows[i];
    const std::size_t length = i - j + 1, before = row.size();
    if (before < length) {
      products += 0.5 * static_cast<double>(length * length - before * before);
      if (products > mostProducts) throw Unproven("it is too large: a factorisation takes more than 2e10 products");
      row.insert(row.begin(), length - before, Ball());
    }
    return row[row.size() - length];
  }
};

/// The matrices G_e of elements that exchange stiffness: numbers of unit / 2^30 sqrt(m_a m_b).
struct Exchange {
  double unit;  // rad²/s²
  /// What elements have in common of the nine numbers of two different nodes; it must be nothing.
  std::map<std::pair<std::int32_t, std::int32_t>, std::array<std::int64_t, 9>> between;
};

/// What proves the upper side, beside the file's own numbers of elements; neither: weights and allowances.
struct UpperSide {
  Whole* whole = nullptr;
  Exchange* exchange = nullptr;
};

/// Takes an element's G_e, and adds it to what its nodes and pairs of nodes have. Returns G_e - K over free components.
Rows takeExchanged(Reader& file, std::vector<Node>& nodes, const std::int32_t* own, const std::vector<int>& free,
                   const Square& K, Exchange& exchange) {
  std::vector<std::int32_t> numbers(static_cast<std::size_t>(K.size) * (static_cast<std::size_t>(K.size) + 1) / 2);
  file.take(numbers.data(), numbers.size());
  for (int r = 0, k = 0; r < K.size; ++r)
    for (int s = 0; s <= r; ++s, ++k)
      if (numbers[k] != 0 && !(nodes[own[r / 3]].free(r % 3) && nodes[own[s / 3]].free(s % 3)))
        throw Unproven("its exchanged matrix is not zero where a component is held");
  const Ball unit = Ball(exchange.unit) / Ball(numbersOfUnit);
  Rows rest;
  for (const int r : free) {
    rest.emplace_back();
    for (const int s : free) {
      if (s > r) continue;
      const std::int32_t number = numbers[r * (r + 1) / 2 + s], i = own[r / 3], j = own[s / 3];
      Node &at = nodes[i], &other = nodes[j];
      if (i == j) {
        at.sum[r % 3][s % 3] += unit * Ball(number) * Ball(at.mass());
      } else {
        // By the node of the smaller number first.
        const int place = i < j ? 3 * (r % 3) + s % 3 : 3 * (s % 3) + r % 3;
        exchange.between[std::minmax(i, j)][place] += number;
      }
      rest.back().push_back(unit * Ball(number) * root(Ball(at.mass()) * Ball(other.mass())) - K(r, s));
    }
  }
  return rest;
}

/// An element's part of the hash: its kind, and of each node the reference position, the mass and what is held.
std::uint64_t hashOf(const Kind& kind, const std::vector<Node>& nodes, const std::int32_t* own, std::size_t n) {
  Fnv hash;
  const std::string names = kind.element + " " + kind.law;
  hash.add(names.data(), names.size());
  for (const double constant : {kind.lambda, kind.mu, kind.pointLambda, kind.pointMu, kind.meanLambda, kind.meanMu})
    hash.add(&constant, sizeof constant);
  for (const auto& point : kind.points) hash.add(point.data(), sizeof point);
  for (std::size_t a = 0; a < n; ++a) {
    const Node& node = nodes[own[a]];
    hash.add(node.numbers, 3 * sizeof(double));
    hash.add(node.numbers + 6, sizeof(double));
    hash.add(&node.held, 1);
  }
  return hash.value();
}

/// One element: adds it to uᵀKu, and subtracts it from the whole matrix or, without one, proves that its allowance or
/// its exchanged matrix bounds its tangent, and adds that to the sums at its nodes.
void proveElement(const Kind& kind, Reader& file, std::vector<Node>& nodes, const UpperSide& upper, Ball& form,
                  Verdict& verdict) {
  const std::size_t n = nodesOf(kind.element);
  std::int32_t own[20];
  double X[60], x[60], volume = 0;
  file.take(own, n);
  std::vector<int> free;
  for (std::size_t a = 0; a < n; ++a) {
    if (own[a] < 0 || own[a] >= static_cast<std::int64_t>(nodes.size())) throw Unreadable("a node is not there");
    for (std::size_t b = 0; b < a; ++b)
      if (own[a] == own[b]) throw Unproven("it has a node twice");
    std::memcpy(X + 3 * a, nodes[own[a]].numbers, 3 * sizeof(double));
    std::memcpy(x + 3 * a, nodes[own[a]].numbers + 3, 3 * sizeof(double));
    for (int c = 0; c < 3; ++c)
      if (nodes[own[a]].free(c)) free.push_back(static_cast<int>(3 * a) + c);
  }
  Square K(0);
  if (!elementTangent(kind, X, x, K, volume)) throw Unproven("its tangent cannot be enclosed");
  verdict.volume += volume;
  verdict.hash += hashOf(kind, nodes, own, n);
  for (const int r : free)
    for (const int s : free) {
      const Node &at = nodes[own[r / 3]], &other = nodes[own[s / 3]];
      form += Ball(at.u(r % 3)) * K(r, s) * Ball(other.u(s % 3));
      const int i = at.row[r % 3], j = other.row[s % 3];
      if (upper.whole && j <= i) upper.whole->entry(i, j) += Ball(0.0) - K(r, s);
    }
  if (upper.whole) return;
  if (upper.exchange) {
    Rows rest = takeExchanged(file, nodes, own, free, K, *upper.exchange);
    if (!positiveDefinite(rest)) throw Unproven("its exchanged matrix does not bound its tangent");
    return;
  }
  double allowance = 0;
  std::int16_t weights[6 * 20];
  file.take(&allowance, 1);
  file.take(weights, 6 * n);
  if (!(allowance > 0) || !std::isfinite(allowance)) throw Unproven("its allowance is not positive");
  const int corner[6] = {0, 4, 8, 7, 6, 3};  // where the factor's six numbers stand in a 3×3 matrix
  std::vector<Matrix> D(n);
  for (std::size_t a = 0; a < n; ++a) {
    Matrix L;
    for (std::size_t k = 0; k < 6; ++k) {
      const double w = weights[6 * a + k];
      const int row = corner[k] / 3;
      if (k < 3 && w < 0) throw Unproven("a diagonal number of its weights is negative");
      if (w != 0 && !nodes[own[a]].free(row)) throw Unproven("its weights are not zero where a component is held");
      L[row][corner[k] % 3] = Ball(w * std::abs(w)) / Ball(32767.0 * 32767.0);
    }
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        for (int k = 0; k < 3; ++k) D[a][i][j].addProduct(L[i][k], L[j][k]);
        nodes[own[a]].sum[i][j] += D[a][i][j] = Ball(allowance) * D[a][i][j];
      }
  }
  Rows rest;
  for (const int r : free) {
    rest.emplace_back();
    for (const int s : free)
      if (s <= r) rest.back().push_back((r / 3 == s / 3 ? D[r / 3][r % 3][s % 3] : Ball(0.0)) - K(r, s));
  }
  if (!positiveDefinite(rest)) throw Unproven("its allowance does not bound its tangent");
}

/// One node: that the allowances of its elements add up to sigma times its mass at most.
void proveNode(const Node& node, double sigma) {
  Rows rest;
  for (int r = 0; r < 3; ++r) {
    if (!node.free(r)) continue;
    rest.emplace_back();
    for (int s = 0; s <= r; ++s)
      if (node.free(s)) rest.back().push_back((r == s ? Ball(sigma) * Ball(node.mass()) : Ball(0.0)) - node.sum[r][s]);
  }
  if (!positiveDefinite(rest)) throw Unproven("the allowances of its elements exceed sigma");
}

/// That what elements have of two different nodes adds up to nothing.
void proveExchange(const Exchange& exchange) {
  for (const auto& [pair, sums] : exchange.between)
    for (const std::int64_t sum : sums)
      if (sum != 0)
        throw Unproven("nodes " + std::to_string(pair.first) + " and " + std::to_string(pair.second) +
                       ": what their elements exchange does not add up to nothing");
}

/// The last eight bytes are FNV-1a of all others, which finds every change of a single byte.
void testChecksum(const std::string& bytes) {
  std::uint64_t stored = 0;
  const std::size_t end = bytes.size() - std::min(bytes.size(), sizeof stored);
  Fnv sum;
  sum.add(bytes.data(), end);
  std::memcpy(&stored, bytes.data() + end, bytes.size() - end);
  if (stored != sum.value()) throw Unreadable("its checksum does not fit: it was damaged or changed");
}

/// `place`: what is at hand, for the message.
void prove(const std::string& bytes, Verdict& verdict, std::string& place) {
  testChecksum(bytes);
  Reader file(bytes);
  if (file.expect("ringwatch-certificate").word('\n') != "2") throw Unreadable("its version is not 2");
  const std::string proof = file.expect("proof").word('\n'), withUnit = "exchange-bound ";
  const bool factored = proof == "factorisation", exchanged = proof.starts_with(withUnit);
  if (!factored && !exchanged && proof != "nodal-bound") throw Unreadable("proof \"" + proof + "\" is not known");
  Exchange exchange{exchanged ? Reader::numberOf(proof.substr(withUnit.size())) : 0, {}};
  if (exchange.unit < 0) throw Unreadable("its unit is negative");
  std::vector<Node> nodes(file.expect("nodes").count(81, '\n'));
  verdict.nodes = static_cast<std::int64_t>(nodes.size());
  verdict.sigma = file.expect("sigma").number('\n');
  verdict.lower = file.expect("lower").number('\n');
  if (verdict.sigma < 0 || verdict.lower < 0) throw Unproven("sigma or lower is negative");
  if (verdict.sigma == 0 && verdict.lower == 0) throw Unproven("it claims nothing");
  std::vector<Kind>& kinds = verdict.kinds;
  kinds.resize(file.expect("kinds").count(20, '\n'));
  std::vector<std::size_t>& elements = verdict.elementsOf;
  for (Kind& kind : kinds) {
    kind.element = file.expect("kind").word();
    kind.law = file.word();
    if (nodesOf(kind.element) == 0) throw Unreadable("element \"" + kind.element + "\" is not known");
    if (!knowsLaw(kind.law)) throw Unreadable("law \"" + kind.law + "\" is not known");
    elements.push_back(file.count(16));
    for (double* constant : {&kind.lambda, &kind.mu, &kind.pointLambda, &kind.pointMu, &kind.meanLambda, &kind.meanMu})
      *constant = file.number();
    kind.points.resize(file.count(10, '\n'));
    for (auto& point : kind.points) {
      file.expect("point");
      for (double& number : point) number = file.number(&number == &point.back() ? '\n' : ' ');
    }
  }
  file.expect("end", '\n');
  Ball form, mass;
  Whole whole;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    place = "node " + std::to_string(i) + ": ";
    file.take(nodes[i].numbers, 10);
    file.take(&nodes[i].held, 1);
    for (const double number : nodes[i].numbers)
      if (!std::isfinite(number)) throw Unproven("a number is not finite");
    if (!(nodes[i].mass() > 0)) throw Unproven("its mass is not positive");
    if (nodes[i].held >> 3 != 0) throw Unproven("its held components are others than x, y and z");
    verdict.mass += nodes[i].mass();
    for (int c = 0; c < 3; ++c) {
      const double X = nodes[i].numbers[c];
      verdict.least[c] = i == 0 ? X : std::min(verdict.least[c], X);
      verdict.largest[c] = i == 0 ? X : std::max(verdict.largest[c], X);
      verdict.displaced = std::max(verdict.displaced, std::abs(nodes[i].numbers[3 + c] - X));
      verdict.held[c] += nodes[i].free(c) ? 0 : 1;
      if (std::bit_cast<std::uint64_t>(nodes[i].u(c)) != 0 && (verdict.lower == 0 || !nodes[i].free(c)))
        throw Unproven("its vector is not zero where it proves nothing");
      mass += Ball(nodes[i].mass()) * Ball(nodes[i].u(c)) * Ball(nodes[i].u(c));
      nodes[i].row[c] = static_cast<int>(whole.rows.size());
      if (factored && nodes[i].free(c)) whole.rows.push_back({Ball(verdict.sigma) * Ball(nodes[i].mass())});
    }
  }
  for (std::size_t k = 0; k < kinds.size(); ++k)
    for (std::size_t e = 0; e < elements[k]; ++e, ++verdict.elements) {
      place = "element " + std::to_string(e) + " of kind " + std::to_string(k) + " (" + kinds[k].element + "): ";
      proveElement(kinds[k], file, nodes, {factored ? &whole : nullptr, exchanged ? &exchange : nullptr}, form,
                   verdict);
    }
  if (file.left() != 8) throw Unreadable("it goes on after its end");
  for (std::size_t i = 0; i < nodes.size() && !factored; ++i) {
    place = "node " + std::to_string(i) + ": ";
    proveNode(nodes[i], verdict.sigma);
  }
  place = "upper side: ";
  proveExchange(exchange);
  if (factored && verdict.sigma != 0 && !positiveDefinite(whole.rows))
    throw Unproven("sigma M - K is not positive definite");
  place = "lower side: ";
  if (verdict.lower > 0 && !(form - Ball(verdict.lower) * mass).positive())
    throw Unproven("the vector does not reach it");
}

}  // namespace

Verdict verify(const std::string& bytes) {
  Verdict verdict{Verdict::Status::proven, ""};
  std::string place;
  try {
    prove(bytes, verdict, place);
  } catch (const Unproven& fault) {
    verdict.status = Verdict::Status::notProven;
    verdict.reason = place + fault.what();
  } catch (const Unreadable& fault) {
    verdict.status = Verdict::Status::unreadable;
    verdict.reason = fault.what();
  }
  return verdict;
}

}  // namespace check

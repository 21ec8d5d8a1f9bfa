#include <ringwatch/monitor/certificate_file.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <numeric>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include <ringwatch/base/error.h>
#include <ringwatch/base/fnv.h>
#include <ringwatch/base/number_format.h>
#include <ringwatch/base/rounding.h>
#include <ringwatch/elements/registry.h>
#include <ringwatch/meshes/adjacency.h>
#include <ringwatch/monitor/bounds/exchange_bound.h>
#include <ringwatch/monitor/bounds/nodal_bound.h>
#include <ringwatch/monitor/bounds/reduced_ring.h>
#include <ringwatch/monitor/bounds/top_mode.h>

namespace ringwatch {
namespace {

constexpr int formatVersion = 2;
// As in criticalStep: tangent products for the top mode, sweeps of the nodal bound.
constexpr int modeProducts = 20, boundSweeps = 12;
/// The least allowance, over the bound times the least mass: elements whose tangent has no positive eigenvalue.
constexpr double leastAllowance = 1e-13;

static_assert(std::endian::native == std::endian::little, "the file holds numbers as they lie in memory");

class Bytes {
 public:
  template <class T>
  void add(const T* numbers, std::size_t count) {
    bytes_.append(reinterpret_cast<const char*>(numbers), count * sizeof(T));
  }
  void add(std::string_view text) { bytes_ += text; }
  /// Exactly, in hexadecimal digits, after a blank.
  void addNumber(double number) { bytes_ += ' ' + hexadecimalOf(number); }
  void reserve(std::size_t size) { bytes_.reserve(size); }
  /// With FNV-1a of all that went before, which changes with every change of a single byte.
  std::string sealed() && {
    Fnv hash;
    hash.add(bytes_);
    const std::uint64_t sum = hash.value();
    add(&sum, 1);
    return std::move(bytes_);
  }

 private:
  std::string bytes_;
};

/// Those of a law that is made of them; nothing for others, of which there are no certificates.
std::optional<Lame> constantsOf(const Material& material) {
  return std::visit(
      [](const auto& law) -> std::optional<Lame> {
        if constexpr (requires { law.constants.lambda; })
          return law.constants;
        else
          return std::nullopt;
      },
      material.law);
}

/// Lamé's constants, and their shares at the points and at the mean.
std::array<double, 6> numbersOf(const ElementBlock& block) {
  const Lame constants = constantsOf(block.material()).value();
  const auto& shares = block.rule().shares;
  return {constants.lambda, constants.mu, shares.pointLambda, shares.pointMu, shares.meanLambda, shares.meanMu};
}

/// Bits 0, 1, 2: the component x, y, z is held.
std::uint8_t heldComponents(const Body& body, std::int32_t node) {
  std::uint8_t held = 0;
  for (int c = 0; c < 3; ++c)
    if (body.constraints().isConstrained(node, c)) held = static_cast<std::uint8_t>(held | 1 << c);
  return held;
}

void addKind(Bytes& bytes, const ElementBlock& block) {
  const QuadratureRule& rule = block.rule();
  bytes.add(joinText("kind ", block.element().name, " ", block.material().lawName(), " ", block.elementCount()));
  for (const double number : numbersOf(block)) bytes.addNumber(number);
  bytes.add(joinText(" ", rule.points.size(), "\n"));
  for (const QuadraturePoint& point : rule.points) {
    bytes.add("point");
    for (const double number : {point.xi[0], point.xi[1], point.xi[2], point.weight}) bytes.addNumber(number);
    bytes.add("\n");
  }
}

/// A mode, M^½ times a displacement, as a displacement whose largest component is 1; zero for none.
NodeVectors displacementOf(const Body& body, NodeVectors mode) {
  if (mode.cols() != body.nodeCount()) return NodeVectors::Zero(3, body.nodeCount());
  mode = mode * body.lumpedMass().cwiseSqrt().cwiseInverse().asDiagonal();
  body.constraints().clearConstrained(mode);
  const double size = mode.cwiseAbs().maxCoeff();
  return size > 0 && std::isfinite(size) ? NodeVectors(mode / size) : NodeVectors::Zero(3, body.nodeCount());
}

/// Reverse Cuthill-McKee (George & Liu 1981): from a node far out through the mesh, neighbours of few neighbours first.
/// order[new number] = node.
std::vector<std::int32_t> bandedOrder(const Mesh& mesh) {
  const CompressedRows<std::int32_t> neighbours = nodeNeighbours(mesh);
  const auto fewer = [&](std::int32_t a, std::int32_t b) {
    const std::size_t own = neighbours.row(a).size(), other = neighbours.row(b).size();
    return own != other ? own < other : a < b;
  };
  std::vector<std::int32_t> order;
  std::vector<bool> taken(mesh.nodeCount());
  const auto walk = [&](std::int32_t start) {
    const std::size_t begin = order.size();
    order.push_back(start);
    taken[start] = true;
    for (std::size_t at = begin; at < order.size(); ++at) {
      std::vector<std::int32_t> next;
      for (const std::int32_t node : neighbours.row(order[at]))
        if (!taken[node]) next.push_back(node);
      std::sort(next.begin(), next.end(), fewer);
      for (const std::int32_t node : next) taken[node] = true;
      order.insert(order.end(), next.begin(), next.end());
    }
    return begin;
  };
  for (std::size_t first = 0; first < mesh.nodeCount(); ++first) {
    if (taken[first]) continue;
    const std::size_t begin = walk(static_cast<std::int32_t>(first));
    // Where a walk ends is far out: the one that counts starts there.
    const std::int32_t end = order.back();
    for (std::size_t i = begin; i < order.size(); ++i) taken[order[i]] = false;
    order.resize(begin);
    walk(end);
  }
  std::reverse(order.begin(), order.end());
  return order;
}

/// Everything but what belongs to elements. order[i]: the node that is node i of the file; unit: ExchangeShares' own.
Bytes beginFile(const Body& body, const NodeVectors& x, const Certificate& certificate, const NodeVectors& u,
                const std::vector<std::int32_t>& order, std::optional<double> unit = {}) {
  Bytes bytes;
  std::size_t size = 81 * static_cast<std::size_t>(body.nodeCount()) + 10000;
  for (const auto& block : body.blocks())
    size += static_cast<std::size_t>(block->elementCount()) * static_cast<std::size_t>(16 * block->element().nodes + 8);
  bytes.reserve(size);
  bytes.add(joinText("ringwatch-certificate ", formatVersion, "\nproof ", certificate.proof));
  if (unit) bytes.addNumber(*unit);
  bytes.add(joinText("\nnodes ", body.nodeCount(), "\nsigma"));
  bytes.addNumber(certificate.upper.value);
  bytes.add("\nlower");
  bytes.addNumber(certificate.lower.value);
  bytes.add(joinText("\nkinds ", body.blocks().size(), "\n"));
  for (const auto& block : body.blocks()) addKind(bytes, *block);
  bytes.add("end\n");
  for (const std::int32_t i : order) {
    bytes.add(body.mesh().X.col(i).data(), 3);
    bytes.add(x.col(i).data(), 3);
    bytes.add(&body.lumpedMass()[i], 1);
    // Of a vector that proves nothing there is nothing in the file.
    const Eigen::Vector3d own = certificate.lower.value > 0 ? Eigen::Vector3d(u.col(i)) : Eigen::Vector3d::Zero();
    bytes.add(own.data(), 3);
    const std::uint8_t held = heldComponents(body, i);
    bytes.add(&held, 1);
  }
  return bytes;
}

/// Of each element its nodes, allowance and weights.
void addWeights(Bytes& bytes, const Body& body, const NodalBound& weights) {
  const double least = leastAllowance * weights.last() * body.lumpedMass().minCoeff();
  for (std::size_t b = 0; b < body.blocks().size(); ++b)
    for (std::int32_t e = 0; e < body.blocks()[b]->elementCount(); ++e) {
      const ElementRef element{b, e};
      const auto nodes = body.blocks()[b]->nodesOf(e);
      const double allowance = std::max(weights.value(element), least);
      bytes.add(nodes.data(), nodes.size());
      bytes.add(&allowance, 1);
      for (std::size_t a = 0; a < nodes.size(); ++a) {
        NodalBound::Factor L = weights.factor(weights.incidenceOf(element, static_cast<int>(a)));
        constexpr int rowOf[] = {0, 1, 2, 2, 2, 1};  // of 00, 11, 22, 21, 20, 10
        for (std::size_t k = 0; k < L.size(); ++k)
          if (body.constraints().isConstrained(nodes[a], rowOf[k])) L[k] = {};
        static_assert(sizeof L == 6 * sizeof(std::int16_t));
        bytes.add(L.data(), L.size());
      }
    }
}

/// Of each element its nodes and its matrix.
void addExchanged(Bytes& bytes, const Body& body, const ExchangeShares& shares) {
  const std::int32_t* entries = shares.entries.data();
  for (const auto& block : body.blocks()) {
    const std::size_t size = 3 * static_cast<std::size_t>(block->element().nodes);
    for (std::int32_t e = 0; e < block->elementCount(); ++e, entries += size * (size + 1) / 2) {
      bytes.add(block->nodesOf(e).data(), block->nodesOf(e).size());
      bytes.add(entries, size * (size + 1) / 2);
    }
  }
}

}  // namespace

bool lawHasCertificates(const Material& material) { return !material.outside && constantsOf(material); }

void requireCertifiable(const Body& body) {
  if (body.elementDamping()) throw InputError("a body whose elements damp: certificates in files know no damping");
  if (body.discreteForces())
    throw InputError("certificate: springs and contact have none; certificates are of elements alone");
  if (!body.constraints().rigidBodies().empty())
    throw InputError("certificate: of a body with rigid parts there is none");
  for (std::size_t b = 0; b < body.blocks().size(); ++b)
    if (const ElementBlock& block = *body.blocks()[b];
        block.material().outside || !isOfLibrary(body.mesh().blocks[b].type))
      throw InputError(joinText("certificate: element ", block.element().name, " of law ", block.material().lawName(),
                                " was registered by a program; certificates are of the library's own"));
    else if (!lawHasCertificates(block.material()))
      throw InputError(joinText("certificate: of the law ", block.material().lawName(),
                                " there is none; certificates are of laws of Young's modulus and Poisson's ratio"));
    else if (block.rule().uniformStrain)
      throw InputError(joinText("certificate: of the rule ", block.rule().name,
                                " there is none; choose another rule of ", block.element().name));
}

std::uint64_t certifiedBodyHash(const Body& body) {
  requireCertifiable(body);
  std::uint64_t sum = 0;
  for (const auto& block : body.blocks()) {
    Fnv kind;
    kind.add(joinText(block->element().name, " ", block->material().lawName()));
    for (const double number : numbersOf(*block)) kind.addNumbers(number);
    for (const QuadraturePoint& point : block->rule().points)
      kind.addNumbers(point.xi[0], point.xi[1], point.xi[2], point.weight);
    for (std::int32_t e = 0; e < block->elementCount(); ++e) {
      Fnv element = kind;
      for (const std::int32_t node : block->nodesOf(e)) {
        const auto X = body.mesh().X.col(node);
        element.addNumbers(X[0], X[1], X[2], body.lumpedMass()[node], heldComponents(body, node));
      }
      sum += element.value();
    }
  }
  return sum;
}

Certificate makeCertificate(const Body& body, const NodeVectors& x, UpperSideBy by) {
  body.checkNodal("x", x);
  requireCertifiable(body);
  ReducedRing ring(body);
  NodeVectors mode;
  const TopMode top = findTopMode(ring, body, x, mode, modeProducts, modeProducts, by == UpperSideBy::tighterOfBoth);
  NodalBound weights(body);
  weights.evaluate(x, boundSweeps);
  const double bound = weights.last();
  if (!std::isfinite(bound) || !(bound > 0))
    throw NumericalError("certificate: the tangent is not finite here, or nothing in the body is stiff and free");
  Certificate certificate{
      {bound * (1 + statedRounding)}, {std::max(0.0, top.lower().value * (1 - statedRounding))}, {}, "nodal-bound"};
  const NodeVectors u = displacementOf(body, top.byRing() ? ring.topVector(ring.last().highestElement) : mode);
  std::vector<std::int32_t> order(body.nodeCount());
  std::iota(order.begin(), order.end(), 0);
  if (by == UpperSideBy::tighterOfBoth && ExchangePolicy::worth(body, certificate.upper, certificate.lower)) {
    const ExchangeShares shares = exchangeShares(body, x, weights, certificate.lower);
    if (shares.upper.value < certificate.upper.value) {
      certificate.upper = shares.upper;
      certificate.proof = "exchange-bound";
      Bytes bytes = beginFile(body, x, certificate, u, order, shares.unit);
      addExchanged(bytes, body, shares);
      certificate.bytes = std::move(bytes).sealed();
      return certificate;
    }
  }
  Bytes bytes = beginFile(body, x, certificate, u, order);
  addWeights(bytes, body, weights);
  certificate.bytes = std::move(bytes).sealed();
  return certificate;
}

Certificate makeFactoredCertificate(const Body& body, const NodeVectors& x, const ProvenSides& sides) {
  body.checkNodal("x", x);
  if (sides.mode.size() > 0) body.checkNodal("mode", sides.mode);
  requireCertifiable(body);
  Certificate certificate{sides.upper, {std::max(0.0, sides.lower.value)}, {}, "factorisation"};
  const std::vector<std::int32_t> order = bandedOrder(body.mesh());
  std::vector<std::int32_t> numberOf(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) numberOf[order[i]] = static_cast<std::int32_t>(i);
  Bytes bytes = beginFile(body, x, certificate, displacementOf(body, sides.mode), order);
  for (const auto& block : body.blocks())
    for (std::int32_t e = 0; e < block->elementCount(); ++e)
      for (const std::int32_t node : block->nodesOf(e)) bytes.add(&numberOf[node], 1);
  certificate.bytes = std::move(bytes).sealed();
  return certificate;
}

}  // namespace ringwatch

#include <ringwatch/monitor/certificate_file.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <string_view>
#include <variant>

#include <ringwatch/base/error.h>
#include <ringwatch/elements/registry.h>
#include <ringwatch/monitor/bounds/nodal_bound.h>
#include <ringwatch/monitor/bounds/reduced_ring.h>
#include <ringwatch/monitor/bounds/top_mode.h>

namespace ringwatch {
namespace {

constexpr int formatVersion = 1;
// As in criticalStep: tangent products for the top mode, sweeps of the nodal bound.
constexpr int modeProducts = 20, boundSweeps = 12;
/// Left between what is computed and what is stated, relative: sums at nodes, and allowances that stand for zero, must
/// be proven with strict inequalities. It is 5e-10 of the step.
constexpr double room = 1e-9;
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
  void addNumber(double number) {
    char text[40];
    std::snprintf(text, sizeof text, " %a", number);
    bytes_ += text;
  }
  void reserve(std::size_t size) { bytes_.reserve(size); }
  /// With FNV-1a of all that went before, which changes with every change of a single byte.
  std::string sealed() && {
    std::uint64_t sum = 0xcbf29ce484222325ULL;
    for (const char byte : bytes_) sum = (sum ^ static_cast<unsigned char>(byte)) * 0x100000001b3ULL;
    add(&sum, 1);
    return std::move(bytes_);
  }

 private:
  std::string bytes_;
};

Lame constantsOf(const Material& material) {
  return std::visit([](const auto& law) { return law.constants; }, material.law);
}

void addKind(Bytes& bytes, const ElementBlock& block) {
  const QuadratureRule& rule = block.rule();
  const Lame constants = constantsOf(block.material());
  bytes.add(joinText("kind ", block.element().name, " ", block.material().lawName(), " ", block.elementCount()));
  for (const double number : {constants.lambda, constants.mu, rule.shares.pointLambda, rule.shares.pointMu,
                              rule.shares.meanLambda, rule.shares.meanMu})
    bytes.addNumber(number);
  bytes.add(joinText(" ", rule.points.size(), "\n"));
  for (const QuadraturePoint& point : rule.points) {
    bytes.add("point");
    for (const double number : {point.xi[0], point.xi[1], point.xi[2], point.weight}) bytes.addNumber(number);
    bytes.add("\n");
  }
}

/// The vector of the lower side in displacements, its largest component 1.
NodeVectors vectorOf(const Body& body, const ReducedRing& ring, const TopMode& top, const NodeVectors& mode) {
  NodeVectors u = top.method == "reduced-1-ring" ? ring.topVector(ring.last().highestElement) : mode;
  u = u * body.lumpedMass().cwiseSqrt().cwiseInverse().asDiagonal();
  body.constraints().clearConstrained(u);
  const double size = u.cwiseAbs().maxCoeff();
  return size > 0 && std::isfinite(size) ? NodeVectors(u / size) : NodeVectors::Zero(3, body.nodeCount());
}

}  // namespace

void requireCertifiable(const Body& body) {
  if (body.discreteForces())
    throw InputError("certificate: springs and contact have none; certificates are of elements alone");
  for (std::size_t b = 0; b < body.blocks().size(); ++b)
    if (const ElementBlock& block = *body.blocks()[b];
        block.material().outside || !isOfLibrary(body.mesh().blocks[b].type))
      throw InputError(joinText("certificate: element ", block.element().name, " of law ", block.material().lawName(),
                                " was registered by a program; certificates are of the library's own"));
}

Certificate makeCertificate(const Body& body, const NodeVectors& x) {
  body.checkNodal("x", x);
  requireCertifiable(body);
  ReducedRing ring(body);
  NodeVectors mode;
  const TopMode top = findTopMode(ring, body, x, mode, modeProducts, modeProducts, false);
  NodalBound weights(body);
  weights.evaluate(x, boundSweeps);
  const double bound = weights.last();
  if (!std::isfinite(bound) || !(bound > 0))
    throw NumericalError("certificate: the tangent is not finite here, or nothing in the body is stiff and free");
  const NodeVectors u = vectorOf(body, ring, top, mode);
  Certificate certificate{{bound * (1 + room)}, {std::max(0.0, top.lower.value * (1 - room))}, {}};

  Bytes bytes;
  std::size_t size = 81 * static_cast<std::size_t>(body.nodeCount()) + 10000;
  for (const auto& block : body.blocks())
    size += static_cast<std::size_t>(block->elementCount()) * static_cast<std::size_t>(16 * block->element().nodes + 8);
  bytes.reserve(size);
  bytes.add(joinText("ringwatch-certificate ", formatVersion, "\nnodes ", body.nodeCount(), "\nsigma"));
  bytes.addNumber(certificate.upper.value);
  bytes.add("\nlower");
  bytes.addNumber(certificate.lower.value);
  bytes.add(joinText("\nkinds ", body.blocks().size(), "\n"));
  for (const auto& block : body.blocks()) addKind(bytes, *block);
  bytes.add("end\n");
  for (std::int32_t i = 0; i < body.nodeCount(); ++i) {
    bytes.add(body.mesh().X.col(i).data(), 3);
    bytes.add(x.col(i).data(), 3);
    bytes.add(&body.lumpedMass()[i], 1);
    bytes.add(u.col(i).data(), 3);
    std::uint8_t held = 0;
    for (int c = 0; c < 3; ++c)
      if (body.constraints().isConstrained(i, c)) held = static_cast<std::uint8_t>(held | 1 << c);
    bytes.add(&held, 1);
  }
  const double least = leastAllowance * bound * body.lumpedMass().minCoeff();
  for (std::size_t b = 0; b < body.blocks().size(); ++b)
    for (std::int32_t e = 0; e < body.blocks()[b]->elementCount(); ++e) {
      const ElementRef element{b, e};
      const auto nodes = body.blocks()[b]->nodesOf(e);
      const double allowance = std::max(weights.value(element), least);
      bytes.add(nodes.data(), nodes.size());
      bytes.add(&allowance, 1);
      for (std::size_t a = 0; a < nodes.size(); ++a) {
        const NodalBound::Factor L = weights.factor(weights.incidenceOf(element, static_cast<int>(a)));
        static_assert(sizeof L == 6 * sizeof(std::int16_t));
        bytes.add(L.data(), L.size());
      }
    }
  certificate.bytes = std::move(bytes).sealed();
  return certificate;
}

}  // namespace ringwatch

#include <ringwatch/monitor/tangent_bracket.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include <ringwatch/base/backoff.h>
#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/rounding.h>
#include <ringwatch/body/tangent_source.h>
#include <ringwatch/monitor/bounds/exchange_bound.h>
#include <ringwatch/monitor/bounds/lowest_mode.h>
#include <ringwatch/monitor/bounds/nodal_bound.h>
#include <ringwatch/monitor/bounds/top_mode.h>

namespace ringwatch {
namespace {

/// Degrees of freedom are bounded in blocks of three: a node with more of them is several triples.
constexpr int inTriple = 3, mostDegreesOfFreedom = 6;
int triplesOf(int degreesOfFreedom) { return (degreesOfFreedom + inTriple - 1) / inTriple; }

/// Throws InputError unless elements of n nodes, each of that many triples, are within what packed matrices hold.
void checkNodeCount(int n, int triples) {
  if (n < 2 || n * triples > maxElementNodes)
    throw InputError(joinText(n, " nodes an element: must be 2 to ", maxElementNodes / triples));
}

/// 0, 1, …: elements are handed over in the order that suits their owner's memory.
std::vector<std::int32_t> ascending(std::size_t count) {
  std::vector<std::int32_t> order(count);
  std::iota(order.begin(), order.end(), 0);
  return order;
}

/// Elements whose tangents are given as numbers.
class GivenTangents final : public ElementTangents {
 public:
  /// connectivity: by reference.
  GivenTangents(std::size_t nodeCount, int nodesPerElement, std::span<const std::int32_t> connectivity)
      : ElementTangents(nodesPerElement,
                        layOutPatches(nodeCount, nodesPerElement, connectivity,
                                      ascending(connectivity.size() / static_cast<std::size_t>(nodesPerElement))),
                        connectivity) {}

  /// The tangents from now on, 3n×3n numbers an element, symmetric, rows and columns 3·node + component; by reference.
  void setTangents(const double* tangents) { tangents_ = tangents; }

  void tangentBatch(std::int32_t batch, const double* x, double* K, double* rounding) const override {
    tangentOf(layout().elements.data() + static_cast<std::ptrdiff_t>(batch) * lanes, x, K, rounding);
  }
  void tangentOf(const std::int32_t* elements, const double* /*x*/, double* K, double* rounding) const override {
    const std::ptrdiff_t count = entries();
    if (rounding)
      for (int lane = 0; lane < lanes; ++lane)
        for (int a = 0; a < nodesPerElement(); ++a)
          rounding[a * lanes + lane] = elements[lane] < 0 ? 0.0 : roundingOf(elements[lane], a);
    for (int lane = 0; lane < lanes; ++lane) {
      const double* own = tangents_ + (elements[lane] < 0 ? 0 : elements[lane]) * count;
      for (std::ptrdiff_t i = 0; i < count; ++i) K[i * lanes + lane] = elements[lane] < 0 ? 0.0 : own[i];
    }
  }
  void addTangentRounding(const Patch& patch, const double* /*x*/, double* slots) const override {
    const int n = nodesPerElement();
    for (std::int32_t i = patch.batchBegin * lanes; i < patch.batchEnd * lanes; ++i)
      for (int a = 0; a < n && layout().elements[i] >= 0; ++a) {
        const std::size_t local = (i / lanes * n + a) * lanes + i % lanes;
        slots[4 * static_cast<std::ptrdiff_t>(layout().localNodes[local])] += roundingOf(layout().elements[i], a);
      }
  }
  void addTangentProduct(const Patch& patch, const double* /*x*/, const double* v, double* slots) const override {
    const int n = nodesPerElement(), size = 3 * n;
    for (std::int32_t i = patch.batchBegin * lanes; i < patch.batchEnd * lanes; ++i) {
      const std::int32_t e = layout().elements[i];
      if (e < 0) continue;
      const double* K = tangents_ + e * entries();
      const auto nodes = nodesOf(e);
      double own[3 * maxElementNodes];
      for (int k = 0; k < size; ++k) own[k] = v[3 * static_cast<std::ptrdiff_t>(nodes[k / 3]) + k % 3];
      for (int k = 0; k < size; ++k) {
        const std::size_t local = (i / lanes * n + k / 3) * lanes + i % lanes;
        double sum = 0;
        for (int j = 0; j < size; ++j) sum += K[k * size + j] * own[j];
        slots[4 * static_cast<std::ptrdiff_t>(layout().localNodes[local]) + k % 3] += sum;
      }
    }
  }

 private:
  /// The numbers are exact; what is computed with them is not: T_a = productRounding u max_b |K_ab|.
  double roundingOf(std::int32_t e, int a) const {
    const int n = nodesPerElement(), size = 3 * n;
    const double* K = tangents_ + e * entries();
    double most = 0;
    for (int b = 0; b < n; ++b) {
      double sum = 0;
      for (int i = 0; i < 9; ++i) {
        const double entry = K[(3 * a + i / 3) * size + 3 * b + i % 3];
        sum += entry * entry;
      }
      most = std::max(most, sum);
    }
    return productRounding * unitRoundoff * std::sqrt(most);
  }
  std::ptrdiff_t entries() const { return 9 * static_cast<std::ptrdiff_t>(nodesPerElement()) * nodesPerElement(); }

  const double* tangents_ = nullptr;
};

/// W with W M W = 1 on the free degrees of freedom and 0 elsewhere, d×d numbers, of a node's mass M. Widens `residual`
/// to what rounding leaves of W M W - 1.
void inverseRoot(std::size_t node, const Eigen::MatrixXd& M, const std::vector<int>& free, double* W,
                 double& residual) {
  const auto d = static_cast<int>(M.rows());
  std::fill(W, W + d * d, 0.0);
  if (free.empty()) return;
  const Eigen::MatrixXd own = M(free, free);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(own);
  const Eigen::VectorXd& lambda = solver.eigenvalues();
  // Singular to rounding counts as indefinite.
  constexpr double definite = 1e-12;
  if (!own.allFinite() || (own - own.transpose()).norm() > 1e-12 * own.norm() ||
      !(lambda[0] > definite * lambda[lambda.size() - 1]))
    throw InputError(joinText("node ", node,
                              ": its mass block must be symmetric and positive definite; its eigenvalues are ",
                              lambda[0], " to ", lambda[lambda.size() - 1]));
  const Eigen::MatrixXd root =
      solver.eigenvectors() * lambda.cwiseSqrt().cwiseInverse().asDiagonal() * solver.eigenvectors().transpose();
  for (std::size_t i = 0; i < free.size(); ++i)
    for (std::size_t j = 0; j < free.size(); ++j)
      W[free[i] * d + free[j]] =
          0.5 * (root(static_cast<int>(i), static_cast<int>(j)) + root(static_cast<int>(j), static_cast<int>(i)));
  residual = std::max(residual, (root * own * root - Eigen::MatrixXd::Identity(own.rows(), own.rows())).norm());
}

void checkElement(std::size_t group, std::size_t e, std::span<const std::int32_t> nodes, std::size_t nodeCount) {
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    if (nodes[a] < 0 || static_cast<std::size_t>(nodes[a]) >= nodeCount)
      throw InputError(joinText("group ", group, ", element ", e, ": node ", nodes[a], " must be 0 to ", nodeCount - 1,
                                ", as many as there are masses"));
    if (std::find(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(a), nodes[a]) !=
        nodes.begin() + static_cast<std::ptrdiff_t>(a))
      throw InputError(joinText("group ", group, ", element ", e, ": node ", nodes[a], " is there twice"));
  }
}

/// Largest entry of a tangent by size, and whether it is symmetric to the last bit.
struct TangentCheck {
  double largest;
  bool symmetric;
};
TangentCheck checkTangent(std::size_t group, std::size_t e, const double* K, int size) {
  double largest = 0;
  for (int i = 0; i < size * size; ++i) {
    if (!std::isfinite(K[i]))
      throw InputError(joinText("group ", group, ", element ", e, ": tangent entry (", i / size, ", ", i % size,
                                ") is ", K[i], ": must be finite"));
    largest = std::max(largest, std::abs(K[i]));
  }
  bool symmetric = true;
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < i; ++j) {
      const double low = K[i * size + j], high = K[j * size + i];
      symmetric = symmetric && low == high;
      if (!(std::abs(low - high) <= 1e-8 * largest))
        throw InputError(joinText("group ", group, ", element ", e, ": tangent is not symmetric: entry (", i, ", ", j,
                                  ") is ", low, ", (", j, ", ", i, ") is ", high));
    }
  return {largest, symmetric};
}

/// Sixth powers, as in determinants of squares, stay inside the range of a double.
constexpr double leastSize = 1e-40, mostSize = 1e40;
void checkSize(const char* what, double size) {
  if (size != 0 && !(size >= leastSize && size <= mostSize))
    throw InputError(joinText(what, size, ": must be ", leastSize, " to ", mostSize, "; choose other units"));
}

}  // namespace

struct TangentBracket::Impl {
  struct Group {
    int nodes, degreesOfFreedom;
    int scaledDegreesOfFreedom;  // blocks of mass couple all of a node's
    std::size_t count;
    std::span<const std::int32_t> nodesOf(std::size_t e) const {
      return {connectivity.data() + e * static_cast<std::size_t>(nodes), static_cast<std::size_t>(nodes)};
    }
    std::vector<std::int32_t> connectivity;
    std::vector<std::int32_t> triples = {};  // of each element, nodesPerElement of its tangents
    std::vector<double> copy = {};           // tangents, symmetric, by triples; empty while they serve as given
    std::unique_ptr<GivenTangents> given = nullptr;
  };
  std::vector<Group> groups;
  int degreesOfFreedom = 3;
  /// W of every node, for masses that are not a number a node of three degrees of freedom; else empty.
  std::vector<double> inverseRoots;
  double massResidual = 0;              // of all W M W - 1
  std::optional<TangentSource> source;  // its nodes are triples
  std::unique_ptr<NodalBound> bound;
  std::unique_ptr<KeptExchangeBound> exchange;  // while it is the tighter one
  std::unique_ptr<ReducedRing> ring;
  NodeVectors mode;
  const NodeVectors noPositions;            // given tangents read none
  Eigen::VectorXd inverseRootMass, rowSum;  // by degree of freedom; the former zero where constrained
  std::vector<double> halfScaled;           // of the element at hand
  bool called = false;
  Backoff freshStart{{.first = 4, .last = 256, .factor = 2}};  // in calls

  static constexpr int warmSweeps = 2, freshSweeps = 20, warmIterations = 2, products = 6, coldProducts = 20;
  static constexpr double wide = 1.1;  // in lambda: 5 % of the step

  /// Takes the tangents of a group and adds the sizes of their mass-scaled entries to rowSum. Returns the largest
  /// entry.
  double take(std::size_t g, std::span<const double> tangents) {
    Group& group = groups[g];
    const int size = group.degreesOfFreedom * group.nodes;
    const std::size_t entries = size * size;
    if (tangents.size() != group.count * entries)
      throw InputError(joinText("group ", g, ": ", tangents.size(), " numbers in its tangents: must be ", group.count,
                                " x ", size, " x ", size));
    const bool scaled = !inverseRoots.empty();
    bool asGiven = !scaled;
    double largest = 0;
    for (std::size_t e = 0; e < group.count; ++e) {
      const double* K = tangents.data() + e * entries;
      const TangentCheck check = checkTangent(g, e, K, size);
      asGiven = asGiven && check.symmetric;
      largest = std::max(largest, check.largest);
      if (!scaled) addRowSums(group.nodesOf(e), K, size);
    }
    if (asGiven) {
      group.copy.clear();
      group.given->setTangents(tangents.data());
      return largest;
    }
    const int stride = inTriple * group.given->nodesPerElement();
    group.copy.assign(group.count * static_cast<std::size_t>(stride * stride), 0.0);
    for (std::size_t e = 0; e < group.count; ++e) {
      const double* K = tangents.data() + e * entries;
      double* copy = group.copy.data() + e * static_cast<std::size_t>(stride * stride);
      if (scaled) {
        scaleInto(group, group.nodesOf(e), K, copy, stride);
        continue;
      }
      for (int i = 0; i < size; ++i)
        for (int j = 0; j < size; ++j) copy[i * stride + j] = 0.5 * (K[i * size + j] + K[j * size + i]);
    }
    group.given->setTangents(group.copy.data());
    return largest;
  }

  void addRowSums(std::span<const std::int32_t> nodes, const double* K, int size) {
    double scale[inTriple * maxElementNodes];
    for (int i = 0; i < size; ++i) scale[i] = inverseRootMass[3 * nodes[i / 3] + i % 3];
    for (int i = 0; i < size; ++i) {
      double sum = 0;
      for (int j = 0; j < size; ++j) sum += std::abs(K[i * size + j]) * scale[j];
      rowSum[3 * nodes[i / 3] + i % 3] += scale[i] * sum;
    }
  }

  /// W K W of the symmetric part of a tangent, in the rows and columns of its triples.
  void scaleInto(const Group& group, std::span<const std::int32_t> nodes, const double* K, double* copy, int stride) {
    const int d = degreesOfFreedom, in = group.degreesOfFreedom, out = group.scaledDegreesOfFreedom;
    const int size = in * group.nodes, scaledSize = out * group.nodes, triples = triplesOf(out);
    const auto rootOf = [&](int a) { return inverseRoots.data() + static_cast<std::ptrdiff_t>(nodes[a]) * d * d; };
    // W K, and the same with all signs positive.
    halfScaled.assign(2 * scaledSize * size, 0.0);
    double *const half = halfScaled.data(), *const halfSizes = half + scaledSize * size;
    for (int i = 0; i < scaledSize; ++i)
      for (int j = 0; j < size; ++j)
        for (int l = 0; l < in; ++l) {
          const int row = i / out * in + l;
          const double term = rootOf(i / out)[i % out * d + l] * 0.5 * (K[row * size + j] + K[j * size + row]);
          half[i * size + j] += term;
          halfSizes[i * size + j] += std::abs(term);
        }
    const auto rowOf = [&](int i) { return (i / out * triples + i % out / inTriple) * inTriple + i % out % inTriple; };
    for (int i = 0; i < scaledSize; ++i) {
      double sizes = 0;
      for (int j = 0; j < scaledSize; ++j)
        for (int l = 0; l < in; ++l) {
          const double w = rootOf(j / out)[l * d + j % out];
          copy[rowOf(i) * stride + rowOf(j)] += half[i * size + j / out * in + l] * w;
          sizes += halfSizes[i * size + j / out * in + l] * std::abs(w);
        }
      rowSum[inTriple * (nodes[i / out] * triplesOf(d) + i % out / inTriple) + i % out % inTriple] += sizes;
    }
    for (int i = 0; i < stride; ++i)
      for (int j = 0; j < i; ++j)
        copy[i * stride + j] = copy[j * stride + i] = 0.5 * (copy[i * stride + j] + copy[j * stride + i]);
  }

  struct Upper {
    UpperBound value;
    std::string_view method;
  };
  Upper upperBound(LowerBound lower) {
    const bool first = !std::exchange(called, true);
    freshStart.tick();
    Upper upper{{infinity}, "nodal-bound"};
    if (exchange) upper = {exchangeBound(lower, warmIterations), "exchange-bound"};
    if (upper.value.value <= wide * lower.value) return upper;
    if (const UpperBound value = bound->evaluate(noPositions, first ? freshSweeps : warmSweeps);
        value.value < upper.value.value)
      upper = {value, "nodal-bound"};
    if (!freshStart.due() || (!first && upper.value.value <= wide * lower.value)) return upper;
    const double before = upper.value.value;
    fromScratch(lower, upper);
    constexpr double helpful = 0.98;
    freshStart.tried(upper.value.value < helpful * before);
    return upper;
  }
  /// Where weights have been swept along for long, or have started badly: from scratch, both ways; and where single
  /// elements' weights are not tight, by exchange between elements.
  void fromScratch(LowerBound lower, Upper& upper) {
    if (upper.value.value > wide * lower.value)
      for (const NodalBound::Start start : {NodalBound::Start::rows, NodalBound::Start::diagonal}) {
        auto other = std::make_unique<NodalBound>(*source);
        const UpperBound value = other->evaluate(noPositions, freshSweeps, start);
        if (value.value < upper.value.value) {
          upper = {value, "nodal-bound"};
          bound = std::move(other);
        }
      }
    exchange.reset();
    if (!(lower.value > 0) || !ExchangePolicy::worth(*source, upper.value, lower)) return;
    exchange = std::make_unique<KeptExchangeBound>(*source);
    if (const UpperBound value = exchangeBound(lower, ExchangePolicy::iterations); value.value < upper.value.value)
      upper = {value, "exchange-bound"};
    else
      exchange.reset();
  }
  UpperBound exchangeBound(LowerBound lower, int iterations) {
    using Policy = ExchangePolicy;
    return exchange
        ->evaluate(noPositions, *bound, Policy::aim(Policy::width) * lower.value,
                   Policy::narrow(Policy::width) * lower.value, iterations)
        .upper;
  }
};

TangentBracket::TangentBracket(const NodalMass& mass, const std::vector<Elements>& elements,
                               std::span<const std::uint8_t> constrained, int threads)
    : impl_(std::make_unique<Impl>()) {
  const int d = mass.degreesOfFreedom;
  if (d < 1 || d > mostDegreesOfFreedom)
    throw InputError(joinText(d, " degrees of freedom a node: must be 1 to ", mostDegreesOfFreedom));
  const std::size_t dofs = d;
  const std::size_t perNode = mass.form == NodalMass::Form::scalar     ? 1
                              : mass.form == NodalMass::Form::diagonal ? dofs
                                                                       : dofs * dofs;
  const std::size_t nodeCount = mass.values.size() / perNode;
  if (mass.values.size() % perNode != 0)
    throw InputError(joinText(mass.values.size(), " numbers of mass: must be a multiple of ", perNode));
  if (elements.empty()) throw InputError("no elements: at least one group is needed");
  if (!constrained.empty() && constrained.size() != dofs * nodeCount)
    throw InputError(joinText(constrained.size(), " flags of constrained components: must be none or ",
                              dofs * nodeCount, ", ", d, " a node"));
  if (mass.form != NodalMass::Form::block)
    for (std::size_t i = 0; i < mass.values.size(); ++i)
      if (!(mass.values[i] > 0) || !std::isfinite(mass.values[i]))
        throw InputError(joinText("node ", i / perNode, ": mass ", mass.values[i],
                                  perNode == 1 && d == inTriple ? " kg" : "", ": must be > 0"));

  Impl& m = *impl_;
  m.degreesOfFreedom = d;
  // Tangents of three degrees of freedom and one mass a node serve as given.
  const bool scaled = d != inTriple || mass.form != NodalMass::Form::scalar ||
                      std::any_of(elements.begin(), elements.end(),
                                  [d](const Elements& group) { return group.degreesOfFreedom % d != 0; });
  const int triples = triplesOf(d);
  const std::size_t tripleCount = nodeCount * static_cast<std::size_t>(triples);
  std::vector<const ElementTangents*> given;
  for (std::size_t g = 0; g < elements.size(); ++g) {
    const int own = elements[g].degreesOfFreedom == 0 ? d : elements[g].degreesOfFreedom;
    if (own < 1 || own > d)
      throw InputError(joinText("group ", g, ": ", own, " degrees of freedom at its nodes: must be 1 to ", d));
    const std::size_t n = elements[g].nodesPerElement;
    const int scaledDofs = mass.form == NodalMass::Form::block ? d : own;
    const int ownTriples = triplesOf(scaledDofs);
    checkNodeCount(elements[g].nodesPerElement, ownTriples);
    if (elements[g].nodes.empty() || elements[g].nodes.size() % n != 0)
      throw InputError(
          joinText("group ", g, ": ", elements[g].nodes.size(), " node numbers: must be a multiple of ", n));
    std::vector<std::int32_t> connectivity;
    for (std::size_t e = 0; e < elements[g].nodes.size() / n; ++e) {
      const auto nodes = elements[g].nodes.subspan(e * n, n);
      checkElement(g, e, nodes, nodeCount);
      for (const std::int32_t node : nodes)
        for (int t = 0; t < ownTriples; ++t) connectivity.push_back(node * triples + t);
    }
    Impl::Group& group =
        m.groups.emplace_back(Impl::Group{.nodes = static_cast<int>(n),
                                          .degreesOfFreedom = own,
                                          .scaledDegreesOfFreedom = scaledDofs,
                                          .count = elements[g].nodes.size() / n,
                                          .connectivity = {elements[g].nodes.begin(), elements[g].nodes.end()},
                                          .triples = std::move(connectivity)});
    group.given = std::make_unique<GivenTangents>(tripleCount, static_cast<int>(n) * ownTriples, group.triples);
    given.push_back(group.given.get());
  }
  Eigen::VectorXd lumped = Eigen::VectorXd::Ones(tripleCount);
  if (!scaled) std::copy(mass.values.begin(), mass.values.end(), lumped.data());
  m.source.emplace(std::move(given), std::move(lumped), threads);
  Constraints& constraints = m.source->constraints();
  if (scaled) m.inverseRoots.resize(nodeCount * dofs * dofs);
  for (std::size_t i = 0; i < nodeCount; ++i) {
    std::vector<int> free;
    for (int j = 0; j < triples * inTriple; ++j) {
      if (j < d && (constrained.empty() || !constrained[i * dofs + static_cast<std::size_t>(j)]))
        free.push_back(j);
      else
        constraints.fix(static_cast<std::int32_t>(i) * triples + j / inTriple, j % inTriple);
    }
    if (!scaled) continue;
    Eigen::MatrixXd M = Eigen::MatrixXd::Zero(d, d);
    for (int r = 0; r < d; ++r)
      for (int c = 0; c < d; ++c)
        if (mass.form == NodalMass::Form::block)
          M(r, c) = mass.values[i * dofs * dofs + static_cast<std::size_t>(r * d + c)];
        else if (r == c)
          M(r, r) = mass.values[i * perNode + (perNode == 1 ? 0 : static_cast<std::size_t>(r))];
    inverseRoot(i, M, free, m.inverseRoots.data() + i * dofs * dofs, m.massResidual);
  }
  m.inverseRootMass.resize(3 * m.source->nodeCount());
  for (std::int32_t i = 0; i < m.source->nodeCount(); ++i)
    for (int c = 0; c < 3; ++c)
      m.inverseRootMass[3 * i + c] = constraints.isConstrained(i, c) ? 0 : 1 / std::sqrt(m.source->lumpedMass()[i]);
  m.bound = std::make_unique<NodalBound>(*m.source);
  m.ring = std::make_unique<ReducedRing>(*m.source);
}
TangentBracket::~TangentBracket() = default;

CriticalStep TangentBracket::evaluate(const std::vector<std::span<const double>>& tangents, double limit,
                                      bool searchNegative) {
  Impl& m = *impl_;
  if (tangents.size() != m.groups.size())
    throw InputError(
        joinText(tangents.size(), " groups of tangents: must be ", m.groups.size(), ", as many as groups of elements"));
  if (!(limit > 0) || !std::isfinite(limit))
    throw InputError(joinText("limit = ", limit, ": must be > 0 and finite, the integrator's largest stable h omega"));
  m.rowSum.setZero(m.inverseRootMass.size());
  double largest = 0;
  for (std::size_t g = 0; g < tangents.size(); ++g) largest = std::max(largest, m.take(g, tangents[g]));
  checkSize("largest entry of the tangents, N/m, ", largest);
  // Sums and products of entries are rounded relative to what is summed, of which an element that is stiff and negative
  // in some direction, or two elements that cancel, can make far more than the highest eigenvalue.
  const double size = m.rowSum.maxCoeff();
  checkSize("largest row sum of the mass-scaled tangents, rad2/s2, ", size);

  const TopMode top = findTopMode(*m.ring, *m.source, m.noPositions, m.mode, Impl::coldProducts, Impl::products, true);
  // The scaled problem W K W y = lambda y is that of a mass within massResidual of the given one.
  const double massRounding = m.inverseRoots.empty() ? 0 : m.massResidual + givenScalingRounding;
  const LowerBound lower{std::max(0.0, top.lower().value - givenSumRounding * size) / (1 + massRounding)};
  const ReducedRing::Result& rings = m.ring->last();
  auto [upper, safeBy] = m.upperBound(lower);
  if (!m.inverseRoots.empty()) upper.value = (upper.value + givenScalingRounding * size) / (1 - massRounding);
  // Of blocks of mass the scaled tangents are searched, whose rounding is of the same size.
  const double clearlyNegative = -(givenSumRounding + (m.inverseRoots.empty() ? 0 : givenScalingRounding)) * size;
  CriticalStep step{safeStep(upper, limit), optimisticStep(lower, limit),
                    rings.highestElement,   safeBy,
                    top.method(),           rings.lowest < clearlyNegative ? rings.lowest : 0,
                    rings.lowestElement};
  if (searchNegative && !step.indefinite())
    if (const LowestMode lowest = LowestModeSearch(*m.source).find(m.noPositions, LowestModeSearch::usualProducts);
        lowest.value < clearlyNegative) {
      step.lowestRing = lowest.value;
      step.lowestRingElement = lowest.element;
    }
  if (!step.isBracket())
    throw NumericalError(joinText("the sides of the bracket cross: safe ", step.safe, " s, optimistic ",
                                  step.optimistic, " s; the tangents are too badly scaled for their rounding"));
  return step;
}

}  // namespace ringwatch

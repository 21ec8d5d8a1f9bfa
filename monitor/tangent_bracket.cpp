#include <ringwatch/monitor/tangent_bracket.h>

#include <algorithm>
#include <cmath>

#include <ringwatch/base/error.h>
#include <ringwatch/body/body.h>
#include <ringwatch/body/tangent_block.h>
#include <ringwatch/monitor/nodal_bound.h>
#include <ringwatch/monitor/top_mode.h>

namespace ringwatch {
namespace {

/// The element type that lends its number of nodes to elements of n nodes: the smallest with as many or more.
ElementType carrierOf(int n) {
  const ElementInfo* best = nullptr;
  for (const ElementInfo& info : allElements())
    if (info.nodes >= n && (!best || info.nodes < best->nodes)) best = &info;
  if (n < 2 || !best) throw InputError(joinText(n, " nodes an element: must be 2 to ", maxElementNodes));
  return best->type;
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

/// Of quotients and assembled entries, relative to the sums of the sizes of what they are summed from.
constexpr double roundingOfProducts = 1e-12;
/// Sixth powers, as in determinants of squares, stay inside the range of a double.
constexpr double leastSize = 1e-40, mostSize = 1e40;
void checkSize(const char* what, double size) {
  if (size != 0 && !(size >= leastSize && size <= mostSize))
    throw InputError(joinText(what, size, ": must be ", leastSize, " to ", mostSize, "; choose other units"));
}

}  // namespace

struct TangentBracket::Impl {
  struct Group {
    int nodes, carrierNodes;
    std::size_t count;
    std::vector<double> copy;  // tangents, symmetric and of the carrier's size; empty while they serve as given
    TangentBlock* block;
  };
  std::vector<Group> groups;
  std::unique_ptr<Body> body;
  std::unique_ptr<NodalBound> bound;
  std::unique_ptr<ReducedRing> ring;
  NodeVectors mode;
  Eigen::VectorXd inverseRootMass, rowSum;  // by degree of freedom; the former zero where constrained
  int calls = 0, lastFresh = 0, freshGap = leastGap;

  static constexpr int leastGap = 4;  // calls between two fresh starts; doubles while they do not help
  static constexpr int warmSweeps = 2, freshSweeps = 20, products = 6, coldProducts = 20;
  static constexpr double wide = 1.1;  // in lambda: 5 % of the step

  /// Takes the tangents of a group and adds the sizes of their mass-scaled entries to rowSum. Returns the largest
  /// entry.
  double take(std::size_t g, std::span<const double> tangents) {
    Group& group = groups[g];
    const int size = 3 * group.nodes, stride = 3 * group.carrierNodes;
    const auto entries = static_cast<std::size_t>(size * size),
               carrierEntries = static_cast<std::size_t>(stride * stride);
    if (tangents.size() != group.count * entries)
      throw InputError(joinText("group ", g, ": ", tangents.size(), " numbers in its tangents: must be ", group.count,
                                " x ", size, " x ", size));
    bool asGiven = group.carrierNodes == group.nodes;
    double largest = 0;
    for (std::size_t e = 0; e < group.count; ++e) {
      const double* K = tangents.data() + e * entries;
      const TangentCheck check = checkTangent(g, e, K, size);
      asGiven = asGiven && check.symmetric;
      largest = std::max(largest, check.largest);
      const auto nodes = group.block->nodesOf(static_cast<std::int32_t>(e));
      double scale[3 * maxElementNodes];
      for (int i = 0; i < size; ++i) scale[i] = inverseRootMass[3 * nodes[static_cast<std::size_t>(i / 3)] + i % 3];
      for (int i = 0; i < size; ++i) {
        double sum = 0;
        for (int j = 0; j < size; ++j) sum += std::abs(K[i * size + j]) * scale[j];
        rowSum[3 * nodes[static_cast<std::size_t>(i / 3)] + i % 3] += scale[i] * sum;
      }
    }
    if (asGiven) {
      group.copy.clear();
      group.block->setTangents(tangents.data());
      return largest;
    }
    group.copy.resize(group.count * carrierEntries);
    for (std::size_t e = 0; e < group.count; ++e) {
      const double* K = tangents.data() + e * entries;
      double* copy = group.copy.data() + e * carrierEntries;
      for (int i = 0; i < size; ++i)
        for (int j = 0; j < size; ++j) copy[i * stride + j] = 0.5 * (K[i * size + j] + K[j * size + i]);
    }
    group.block->setTangents(group.copy.data());
    return largest;
  }

  UpperBound upperBound(const NodeVectors& x, LowerBound lower) {
    const bool first = calls++ == 0;
    UpperBound upper = bound->evaluate(x, first ? freshSweeps : warmSweeps);
    if (upper.value <= wide * lower.value || (!first && calls - lastFresh < freshGap)) return upper;
    // Shapes that were swept along for long, or that started badly: from scratch, both ways.
    lastFresh = calls;
    const double before = upper.value;
    for (const NodalBound::Start start : {NodalBound::Start::rootOfStiffness, NodalBound::Start::stiffness}) {
      auto other = std::make_unique<NodalBound>(*body);
      const UpperBound value = other->evaluate(x, freshSweeps, start);
      if (value.value < upper.value) {
        upper = value;
        bound = std::move(other);
      }
    }
    freshGap = upper.value < 0.98 * before ? leastGap : std::min(2 * freshGap, 256);
    return upper;
  }
};

TangentBracket::TangentBracket(std::span<const double> lumpedMass, const std::vector<Elements>& elements,
                               std::span<const std::uint8_t> constrained, int threads)
    : impl_(std::make_unique<Impl>()) {
  const std::size_t nodeCount = lumpedMass.size();
  if (elements.empty()) throw InputError("no elements: at least one group is needed");
  if (!constrained.empty() && constrained.size() != 3 * nodeCount)
    throw InputError(joinText(constrained.size(), " flags of constrained components: must be none or ", 3 * nodeCount,
                              ", three a node"));
  for (std::size_t i = 0; i < nodeCount; ++i)
    if (!(lumpedMass[i] > 0) || !std::isfinite(lumpedMass[i]))
      throw InputError(joinText("node ", i, ": mass ", lumpedMass[i], " kg: must be > 0"));

  Mesh mesh;
  std::size_t spare = 0;  // fixed nodes that fill up elements whose number of nodes no type has
  for (std::size_t g = 0; g < elements.size(); ++g) {
    const auto n = static_cast<std::size_t>(elements[g].nodesPerElement);
    MeshBlock block{carrierOf(elements[g].nodesPerElement), {}, {}};
    if (elements[g].nodes.empty() || elements[g].nodes.size() % n != 0)
      throw InputError(
          joinText("group ", g, ": ", elements[g].nodes.size(), " node numbers: must be a multiple of ", n));
    const auto width = static_cast<std::size_t>(block.nodesPerElement());
    const std::size_t count = elements[g].nodes.size() / n;
    for (std::size_t e = 0; e < count; ++e) {
      const auto nodes = elements[g].nodes.subspan(e * n, n);
      checkElement(g, e, nodes, nodeCount);
      block.connectivity.insert(block.connectivity.end(), nodes.begin(), nodes.end());
      for (std::size_t a = n; a < width; ++a)
        block.connectivity.push_back(static_cast<std::int32_t>(nodeCount + a - n));
      block.ids.push_back(static_cast<std::int64_t>(e));
    }
    spare = std::max(spare, width - n);
    impl_->groups.push_back({static_cast<int>(n), static_cast<int>(width), count, {}, nullptr});
    mesh.blocks.push_back(std::move(block));
  }
  mesh.X.setZero(3, static_cast<Eigen::Index>(nodeCount + spare));
  for (std::size_t i = 0; i < nodeCount + spare; ++i) mesh.nodeIds.push_back(static_cast<std::int64_t>(i));
  std::vector<std::unique_ptr<ElementBlock>> blocks;
  for (std::size_t g = 0; g < elements.size(); ++g) {
    auto block = std::make_unique<TangentBlock>(mesh, mesh.blocks[g]);
    impl_->groups[g].block = block.get();
    blocks.push_back(std::move(block));
  }
  Eigen::VectorXd mass = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(nodeCount + spare));
  std::copy(lumpedMass.begin(), lumpedMass.end(), mass.data());
  impl_->body = std::make_unique<Body>(std::move(mesh), std::move(blocks), std::move(mass), threads);
  for (std::size_t i = 0; i < constrained.size(); ++i)
    if (constrained[i]) impl_->body->constraints().fix(static_cast<std::int32_t>(i / 3), static_cast<int>(i % 3));
  for (std::size_t i = 0; i < spare; ++i) impl_->body->constraints().fix(static_cast<std::int32_t>(nodeCount + i));
  impl_->inverseRootMass.resize(3 * impl_->body->nodeCount());
  for (std::int32_t i = 0; i < impl_->body->nodeCount(); ++i)
    for (int c = 0; c < 3; ++c)
      impl_->inverseRootMass[3 * i + c] =
          impl_->body->constraints().isConstrained(i, c) ? 0 : 1 / std::sqrt(impl_->body->lumpedMass()[i]);
  impl_->bound = std::make_unique<NodalBound>(*impl_->body);
  impl_->ring = std::make_unique<ReducedRing>(*impl_->body);
}
TangentBracket::~TangentBracket() = default;

CriticalStep TangentBracket::evaluate(const std::vector<std::span<const double>>& tangents, double limit) {
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

  const NodeVectors& x = m.body->mesh().X;
  const TopMode top = findTopMode(*m.ring, *m.body, x, m.mode, Impl::coldProducts, Impl::products, true);
  const LowerBound lower{std::max(0.0, top.lower.value - roundingOfProducts * size)};
  const ReducedRing::Result& rings = m.ring->last();
  const UpperBound upper = m.upperBound(x, lower);
  const CriticalStep step{safeStep(upper, limit),
                          optimisticStep(lower, limit),
                          rings.highestElement,
                          "nodal-bound",
                          top.method,
                          rings.lowest < -roundingOfProducts * size ? rings.lowest : 0,
                          rings.lowestElement};
  if (!step.isBracket())
    throw NumericalError(joinText("the sides of the bracket cross: safe ", step.safe, " s, optimistic ",
                                  step.optimistic, " s; the tangents are too badly scaled for their rounding"));
  return step;
}

}  // namespace ringwatch

#include <ringwatch/monitor/incremental/moved_bound.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

#include <Eigen/Eigenvalues>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/parallel.h>
#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/body/element_damping.h>
#include <ringwatch/monitor/bounds/scaled_tangent.h>
#include <ringwatch/monitor/incremental/laplacian_majorants.h>

namespace ringwatch {
namespace {

/// What an element may add where it adds nothing to any node, Pa.
constexpr float unbounded = 1e30F;
/// Rounding of an element's majorant and of a sum that it is added to, relative to the sizes of what is summed: some
/// fifty products and sums.
constexpr double majorantError = 64 * unitRoundoff;
/// Of F - T A and of sums of a few squares, relative.
constexpr double motionRounding = 1e-12;
/// Kept free of an eigenvalue that is wanted, for bounds of nodes in single precision, relative.
constexpr double levelRounding = 1e-6;
/// A value below which an element has no stiffness, N/m.
constexpr double smallestValue = 1e-200;
/// Batches whose sums are held in memory at once.
constexpr std::size_t batchesAtOnce = 1024;

/// The largest of numbers that are not negative; NaN where one is.
double largestOf(const std::vector<float>& numbers) {
  return Eigen::Map<const Eigen::ArrayXf>(numbers.data(), static_cast<Eigen::Index>(numbers.size()))
      .maxCoeff<Eigen::PropagateNaN>();
}
bool isHeld(const Body& body, std::int32_t node) {
  return body.constraints().any() && body.constraints().freeComponents(node) == 0;
}

}  // namespace

struct MovedBound::Pack {
  BatchRef at{};
  const std::int32_t* elements = nullptr;  // -1: none
  int nodes = 0, points = 0;
  Matrix3<P> T;
  P value, eta, geometric, uneven, negative, kappa, linear, quadratic, radius, inversionDistance;
  Symmetric3<P> D[maxElementNodes];
  P c[maxElementNodes];
  AlignedVector<double> F = {};
  TangentDrift drift[lanes];

  Matrix3<P> gradient(int q) const {
    Matrix3<P> result;
    for (int i = 0; i < 9; ++i) result.m[i] = P::load(F.data() + (9 * q + i) * lanes);
    return result;
  }
  /// τ at the visit, Pa: what L is multiplied by.
  P tau() const {
    return geometric + eta * negative + uneven * (linear + uneven * (quadratic + (P(1.0) + P(1.0) / eta) * kappa));
  }
};

struct MovedBound::Found {
  P rounding, determinant, negative;
  bool finite, lost;
};

MovedBound::MovedBound(const Body& body, const MovedBoundPolicy& policy)
    : body_(body), policy_(policy), weights_(body), bodyVersion_(body.version()), rebuilds_(policy.rebuilds) {
  prepare();
}

void MovedBound::prepare() {
  const Body& body = body_;
  elements_.clear();
  for (std::size_t b = 0; b < body.blocks().size(); ++b) {
    const ElementBlock& block = *body.blocks()[b];
    const std::size_t places = block.layout().elements.size(), points = block.rule().points.size();
    const DampedBlock* damped = body.elementDamping() ? body.elementDamping()->blocks()[b] : nullptr;
    const LawInfo law = block.material().info();
    const Motion ofBlock = damped || !law.objective ? Motion::none
                           : stretchesFreely(block) ? Motion::stretch
                                                    : Motion::rotation;
    Elements own{ValidityBalls(block), ofBlock};
    own.rests.assign(places, ofBlock == Motion::none);
    for (std::size_t place = 0; place < own.rests.size(); ++place) {
      if (block.layout().elements[place] < 0) continue;
      for (const std::int32_t node : block.nodesOf(block.layout().elements[place]))
        if (isPartlyHeld(body_, node)) own.rests[place] = 1;
    }
    own.anchor.resize(9 * points * places);
    own.motion.resize(9 * places);
    own.value.resize(places);
    own.geometric.resize(places);
    for (auto* numbers : {&own.eta, &own.uneven, &own.negative, &own.kappa, &own.linear, &own.quadratic})
      numbers->resize(places);
    own.radius.assign(places, -1);
    own.inversionDistance.assign(places, -1);
    own.laplacian.resize(places * static_cast<std::size_t>(block.nodesPerElement()));
    if (damped && damped->dependsOnRates()) {
      own.rates = damped;
      own.counted.assign(places, 0);
    }
    elements_.push_back(std::move(own));
  }
}

MovedBound::Pack MovedBound::load(BatchRef at) const {
  const ElementBlock& block = *body_.blocks()[at.block];
  const Elements& own = elements_[at.block];
  const std::size_t first = static_cast<std::size_t>(at.batch) * lanes;
  Pack pack;
  pack.at = at;
  pack.elements = block.layout().elements.data() + first;
  pack.nodes = block.nodesPerElement();
  pack.points = static_cast<int>(block.rule().points.size());
  weights_.weightsOf(at.block, at.batch, pack.D);
  for (int i = 0; i < 9; ++i) {
    detail::NativeFloats entries;
    std::memcpy(&entries, own.motion.data() + 9 * first + i * lanes, sizeof entries);
    pack.T.m[i] = detail::packOf(entries);
  }
  if (own.motionOfBlock != Motion::stretch) pack.T = polishedRotation(pack.T);
  pack.value = RoundedUp<float>::load(own.value.data() + first);
  pack.eta = RoundedUp<Bfloat16>::load(own.eta.data() + first);
  pack.geometric = RoundedUp<float>::load(own.geometric.data() + first);
  pack.uneven = RoundedUp<Bfloat16>::load(own.uneven.data() + first);
  pack.negative = RoundedUp<Bfloat16>::load(own.negative.data() + first);
  pack.kappa = RoundedUp<Bfloat16>::load(own.kappa.data() + first);
  pack.linear = RoundedUp<Bfloat16>::load(own.linear.data() + first);
  pack.quadratic = RoundedUp<Bfloat16>::load(own.quadratic.data() + first);
  pack.radius = RoundedDown<Bfloat16>::load(own.radius.data() + first);
  pack.inversionDistance = RoundedDown<Bfloat16>::load(own.inversionDistance.data() + first);
  for (int a = 0; a < pack.nodes; ++a)
    pack.c[a] =
        RoundedUp<Bfloat16>::load(own.laplacian.data() + first * static_cast<std::size_t>(pack.nodes) + a * lanes);
  return pack;
}

void MovedBound::store(const Pack& pack) {
  Elements& own = elements_[pack.at.block];
  const std::size_t first = static_cast<std::size_t>(pack.at.batch) * lanes;
  for (int i = 0; i < 9; ++i) {
    const detail::NativeFloats entries = detail::singlesOf(pack.T.m[i]);
    std::memcpy(own.motion.data() + 9 * first + i * lanes, &entries, sizeof entries);
  }
  RoundedUp<float>::store(pack.value, own.value.data() + first);
  RoundedUp<Bfloat16>::store(pack.eta, own.eta.data() + first);
  RoundedUp<float>::store(pack.geometric, own.geometric.data() + first);
  RoundedUp<Bfloat16>::store(pack.uneven, own.uneven.data() + first);
  RoundedUp<Bfloat16>::store(pack.negative, own.negative.data() + first);
  RoundedUp<Bfloat16>::store(pack.kappa, own.kappa.data() + first);
  RoundedUp<Bfloat16>::store(pack.linear, own.linear.data() + first);
  RoundedUp<Bfloat16>::store(pack.quadratic, own.quadratic.data() + first);
  for (int lane = 0; lane < lanes; ++lane) {
    own.radius[first + lane] = pack.radius[lane];
    own.inversionDistance[first + lane] = pack.inversionDistance[lane];
  }
}

void MovedBound::majorantsOf(const Pack& pack, Symmetric3<P>* majorants) const {
  const P value = (P(1.0) + pack.eta) * pack.value, tau = pack.tau();
  for (int a = 0; a < pack.nodes; ++a) {
    majorants[a] = value * movedWeight(pack.T, pack.D[a]);
    for (int c = 0; c < 3; ++c) majorants[a].m[c] += tau * pack.c[a];
  }
}

void MovedBound::move(NodeVectorsView x, Pack& pack, bool anchoring) {
  const ElementBlock& block = *body_.blocks()[pack.at.block];
  const Elements& own = elements_[pack.at.block];
  const std::size_t first = static_cast<std::size_t>(pack.at.batch) * lanes;
  pack.F.resize(static_cast<std::size_t>(9 * pack.points) * lanes);
  block.deformationOf(pack.elements, x.data(), pack.F.data(), pack.drift);
  const bool stretches = own.motionOfBlock == Motion::stretch, inverts = block.material().info().allowsInversion;
  for (int lane = 0; lane < lanes; ++lane) {
    const TangentDrift& drift = pack.drift[lane];
    pack.uneven.set(lane, drift.gradientRounding);
    pack.inversionDistance.set(lane, inverts ? infinity : drift.inversionDistance);
    if (!anchoring && !stretches) continue;
    pack.negative.set(lane, drift.law.negative);
    pack.kappa.set(lane, drift.law.kappa);
    pack.linear.set(lane, drift.law.linear);
    pack.quadratic.set(lane, drift.law.quadratic);
    pack.radius.set(lane, drift.law.radius);
  }
  if (anchoring) {
    pack.T = Matrix3<P>::identity();
    pack.geometric = P(0.0);
    pack.eta = P(eta_);
    return;
  }
  // The anchor's gradients, and the rotation or stretch from there.
  AlignedVector<Matrix3<P>> A(static_cast<std::size_t>(pack.points));
  Matrix3<P> sum = Matrix3<P>::zero(), before = Matrix3<P>::zero();
  const std::int16_t* stored = own.anchor.data() + 9 * first * static_cast<std::size_t>(pack.points);
  for (int q = 0; q < pack.points; ++q) {
    for (int i = 0; i < 9; ++i, stored += lanes)
      A[q].m[i] = P(ValidityBalls::entryUnit) * detail::packOf(detail::loadShorts(stored));
    sum = sum + (stretches ? pack.gradient(q) : timesTranspose(pack.gradient(q), A[q]));
    before = before + A[q];
  }
  Matrix3<P> T = stretches ? sum * inverse(before) : closestRotation(sum);
  P rests(0.0);
  for (int lane = 0; lane < lanes; ++lane) rests.set(lane, own.rests[first + lane]);
  for (int i = 0; i < 9; ++i)
    T.m[i] = select(rests > P(0.0), P(i % 4 == 0 ? 1.0 : 0.0), detail::packOf(detail::singlesOf(T.m[i])));
  pack.T = stretches ? T : polishedRotation(T);
  P farthest2(0.0), geometric(0.0), laplacian(0.0);
  for (int q = 0; q < pack.points; ++q) {
    const Matrix3<P> off = pack.gradient(q) - pack.T * A[q];
    farthest2 = math::max(farthest2, innerProduct(off, off));
  }
  pack.uneven += math::sqrt(farthest2) * P(1 + motionRounding) +
                 math::sqrt(innerProduct(pack.T, pack.T)) * P(ValidityBalls::storageError + motionRounding);
  // The η that makes (1+η) l D + (1+1/η) κ δ² L least, on average over the nodes: D has trace 1. As it is stored.
  for (int a = 0; a < pack.nodes; ++a) laplacian += pack.c[a];
  const P best = pack.uneven * math::sqrt(P(3.0) * pack.kappa * laplacian / math::max(pack.value, P(smallestValue)));
  pack.eta = math::min(math::max(best, P(eta_)), P(1.0));
  RoundedUp<Bfloat16>::store(pack.eta, elements_[pack.at.block].eta.data() + first);
  pack.eta = RoundedUp<Bfloat16>::load(own.eta.data() + first);
  for (int q = 0; stretches && q < pack.points; ++q)
    geometric = math::max(geometric, geometricGrowth(block.material().restModuli(), pack.gradient(q), A[q], pack.T,
                                                     pack.eta, ValidityBalls::storageError));
  if (!stretches) return;
  pack.negative = P(0.0);
  pack.geometric = geometric;
}

void MovedBound::visit(NodeVectorsView x, BatchRef at, bool anchoring, Found& found, Symmetric3<P>* change) {
  Elements& own = elements_[at.block];
  Pack pack = load(at);
  Symmetric3<P> before[maxElementNodes];
  majorantsOf(pack, before);
  const auto sizeOf = [&](const Pack& of) {
    P size = of.value * innerProduct(of.T, of.T);
    for (int a = 0; a < of.nodes; ++a) size += of.tau() * of.c[a];
    return size;
  };
  found.rounding = sizeOf(pack);
  if (anchoring) {
    weights_.setWeightsOf(at.block, at.batch, before);
    double value[lanes];
    weights_.elementValues(at.block, pack.elements, x, value);
    pack.value = P::load(value);
  }
  move(x, pack, anchoring);
  if (anchoring) anchor(pack);
  // Nothing is known beyond the law's radius.
  P lost = select(pack.uneven <= pack.radius, P(0.0), P(1.0));
  const P off = own.balls.setReferenceGradients(at.batch, pack.F.data());
  pack.radius = select(off < P(infinity), pack.radius, P(-1.0));
  store(pack);
  P entries(0.0);  // not finite where one is not
  for (int i = 0; i < 9 * pack.points; ++i) entries += math::abs(P::load(pack.F.data() + i * lanes));
  found.finite = true;
  found.lost = false;
  for (int lane = 0; lane < lanes; ++lane) {
    found.determinant.set(lane, pack.drift[lane].determinant);
    found.negative.set(lane, pack.drift[lane].law.negative);
    if (pack.elements[lane] < 0) continue;
    found.lost |= !anchoring && lost[lane] != 0;
    found.finite &= std::isfinite(pack.value[lane]) && std::isfinite(entries[lane]);
  }
  const Pack now = load(at);
  majorantsOf(now, change);
  found.rounding = P(majorantError) * (found.rounding + sizeOf(now));
  for (int a = 0; a < pack.nodes; ++a)
    for (int c = 0; c < 6; ++c) change[a].m[c] -= before[a].m[c];
}

void MovedBound::anchor(Pack& pack) {
  Elements& own = elements_[pack.at.block];
  const std::size_t first = static_cast<std::size_t>(pack.at.batch) * lanes;
  const P off = ValidityBalls::storeGradients(pack.F.data(), pack.points,
                                              own.anchor.data() + 9 * first * static_cast<std::size_t>(pack.points));
  pack.radius = select(off < P(infinity), pack.radius, P(-1.0));
  if (own.rates)
    for (std::size_t place = first; place < first + lanes; ++place) own.counted[place] = own.rates->coefficient(place);
}

bool MovedBound::visit(NodeVectorsView x, std::span<const BatchRef> batches, bool anchoring) {
  if (batches.empty()) return true;
  const std::size_t together = std::min(batches.size(), batchesAtOnce);
  std::vector<Found> found(together);
  changes_.resize(together * static_cast<std::size_t>(body_.mostNodesOfAnElement()));
  const auto changeOf = [&](std::size_t k) {
    return changes_.data() + k * static_cast<std::size_t>(body_.mostNodesOfAnElement());
  };
  std::vector<BatchRef> lost;
  std::vector<std::int32_t> nodes;
  // In parallel into places of their own, then one after the other: sums do not depend on threads.
  for (std::size_t begin = 0; begin < batches.size(); begin += batchesAtOnce) {
    const std::size_t end = std::min(batches.size(), begin + batchesAtOnce);
    parallelFor(
        begin, end, body_.threads(),
        [&](std::int64_t k) { visit(x, batches[k], anchoring, found[k - begin], changeOf(k - begin)); }, 8);
    for (std::size_t k = begin; k < end; ++k) {
      const Found& one = found[k - begin];
      const ElementBlock& block = *body_.blocks()[batches[k].block];
      const Symmetric3<P>* const change = changeOf(k - begin);
      if (!one.finite) {
        started_ = false;
        bound_ = std::numeric_limits<double>::quiet_NaN();
        return false;
      }
      const std::int32_t* elements =
          block.layout().elements.data() + static_cast<std::ptrdiff_t>(batches[k].batch) * lanes;
      for (int lane = 0; lane < lanes; ++lane) {
        if (elements[lane] < 0) continue;
        seen_.push_back({{batches[k].block, elements[lane]}, one.determinant[lane], one.negative[lane]});
        const auto own = block.nodesOf(elements[lane]);
        for (std::size_t a = 0; a < own.size(); ++a) {
          Node& node = nodes_[own[a]];
          for (int c = 0; c < 6; ++c) node.sum.m[c] += change[a].m[c][lane];
          node.rounding += one.rounding[lane] + majorantError * node.sum.trace();
          if (std::exchange(marked_[own[a]], 1) == 0) nodes.push_back(own[a]);
        }
      }
      if (one.lost) lost.push_back(batches[k]);
      (anchoring ? statistics_.evaluated : statistics_.visited) += lanes;
    }
  }
  for (const std::int32_t node : nodes) marked_[node] = 0;
  if (!visit(x, lost, true)) return false;
  settle(nodes);
  parallelFor(
      0, batches.size(), body_.threads(), [&](std::int64_t k) { fit(batches[k]); }, 64);
  return true;
}

void MovedBound::fit(BatchRef at) {
  Elements& own = elements_[at.block];
  const ElementBlock& block = *body_.blocks()[at.block];
  const std::size_t first = static_cast<std::size_t>(at.batch) * lanes;
  P allowed(unbounded);
  for (int lane = 0; lane < lanes; ++lane) {
    const std::int32_t e = block.layout().elements[first + lane];
    if (e < 0) continue;
    double least = unbounded;
    for (const std::int32_t node : block.nodesOf(e)) least = std::min(least, static_cast<double>(nodes_[node].ball));
    allowed.set(lane, least);
    if (least >= unbounded && own.value[first + lane] == 0) own.balls.setNeverOutside(first + lane);
  }
  const P uneven = RoundedUp<Bfloat16>::load(own.uneven.data() + first),
          eta = RoundedUp<Bfloat16>::load(own.eta.data() + first);
  const TangentGrowthOf<P> growth{P(0.0), RoundedUp<Bfloat16>::load(own.linear.data() + first),
                                  RoundedUp<Bfloat16>::load(own.quadratic.data() + first) +
                                      (P(1.0) + P(1.0) / eta) * RoundedUp<Bfloat16>::load(own.kappa.data() + first),
                                  RoundedDown<Bfloat16>::load(own.radius.data() + first)};
  const P inversion = RoundedDown<Bfloat16>::load(own.inversionDistance.data() + first) * P(1 - radiusRounding);
  const P radius = validityRadius(growth, P(infinity), allowed + growth.at(uneven)) - uneven;
  own.balls.fitRadii(at.batch, math::min(radius, inversion) - P(ValidityBalls::storageError));
}

std::vector<MovedBound::BatchRef> MovedBound::batchesAt(std::span<const std::int32_t> nodes) const {
  std::vector<BatchRef> batches;
  for (const std::int32_t node : nodes)
    for (const NodalBound::Incidence at : weights_.incidences(node))
      batches.push_back({at.block, at.place / lanes / body_.blocks()[at.block]->nodesPerElement()});
  sortUnique(batches);
  return batches;
}

double MovedBound::allowedAt(std::int32_t node) const {
  const Node& own = nodes_[node];
  if (!(own.gamma > 0)) return unbounded;
  // What the highest node has, which all may take, or half of what is left, so that the node's own bound can rise.
  const double room = std::min(level_ - own_[node], std::max(room_, 0.5 * (level_ - own_[node])));
  return std::clamp(room * body_.lumpedMass()[node] / own.gamma, 0.0, static_cast<double>(unbounded));
}

void MovedBound::setBall(std::int32_t node, double most) {
  Node& own = nodes_[node];
  own.ball = detail::singleAtOrBelow(most);
  const double whole = own_[node] + static_cast<double>(own.gamma) * own.ball / body_.lumpedMass()[node];
  whole_[node] = -detail::singleAtOrBelow(-whole);
}

void MovedBound::settle(std::span<const std::int32_t> nodes) {
  const DiscreteForces* discrete = body_.discreteForces();
  parallelFor(
      0, (nodes.size() + lanes - 1) / lanes, body_.threads(),
      [&](std::int64_t pack) {
        Symmetric3<P> S = Symmetric3<P>::diagonal(P(0.0));
        const auto nodeOf = [&](int lane) {
          return nodes[std::min(static_cast<std::size_t>(pack) * lanes + static_cast<std::size_t>(lane),
                                nodes.size() - 1)];
        };
        for (int lane = 0; lane < lanes; ++lane) {
          const std::int32_t node = nodeOf(lane);
          const Node& own = nodes_[node];
          const std::int32_t place = discrete && !needed_.empty() ? discrete->placeOf(node) : -1;
          const double inverseMass = 1 / body_.lumpedMass()[node];
          for (int i = 0; i < 3; ++i)
            for (int j = i; j < 3; ++j) {
              const bool free = freeFactor(body_, node, i) != 0 && freeFactor(body_, node, j) != 0;
              const double sum = own.sum(i, j) + (place < 0 ? 0.0 : needed_[place](i, j)) + (i == j ? own.rounding : 0);
              S(i, j).set(lane, free ? inverseMass * sum : 0.0);
            }
        }
        P A[9], work[12];
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j <= i; ++j) A[3 * i + j] = S(i, j);
        const auto extremes = extremeEigenvalues(A, 3, work, false);
        const P largest = extremes.largest + P(eigenvalueRounding) * extremes.scale;
        for (int lane = 0; lane < lanes; ++lane) {
          // A NaN stays.
          const double bound = largest[lane] < 0 ? 0.0 : largest[lane];
          own_[nodeOf(lane)] = -detail::singleAtOrBelow(-bound);
        }
      },
      16);
  double highest = 0;
  for (const std::int32_t node : nodes) highest = std::max(highest, static_cast<double>(own_[node]));
  level_ = std::max(level_, highest * (1 + policy_.slack) / (1 + eta_));
  room_ = std::min(room_, level_ - highest);
  for (const std::int32_t node : nodes)
    setBall(node, std::max(static_cast<double>(nodes_[node].ball), allowedAt(node)));
}

void MovedBound::findLaplacian() {
  const std::vector<std::vector<double>> majorants = laplacianMajorants(body_);
  std::vector<double> gamma(nodes_.size(), 0.0);
  for (std::size_t b = 0; b < majorants.size(); ++b) {
    const ElementBlock& block = *body_.blocks()[b];
    const auto n = static_cast<std::size_t>(block.nodesPerElement());
    for (std::size_t place = 0; place < block.layout().elements.size(); ++place) {
      if (block.layout().elements[place] < 0) continue;
      const auto nodes = block.nodesOf(block.layout().elements[place]);
      for (std::size_t a = 0; a < n; ++a) {
        const std::size_t at = (place / lanes * n + a) * lanes + place % lanes;
        RoundedUp<Bfloat16>& c = elements_[b].laplacian[at];
        c = majorants[b][at];
        gamma[nodes[a]] += c;
      }
    }
  }
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    nodes_[i].gamma = -detail::singleAtOrBelow(-gamma[i] * (1 + motionRounding));
}

void MovedBound::build(NodeVectorsView x, double wanted) {
  weights_.reset();  // weights that are swept along get stuck at a front that moves through the mesh
  weights_.evaluate(x, policy_.sweeps, NodalBound::Start::rows, policy_.leastGain,
                    {.ample = policy_.enoughOfWanted * wanted});
  statistics_.evaluated += weights_.evaluations();
  rebuilds_.restart();
  const double tight = weights_.last();
  if (nodes_.empty()) {
    nodes_.resize(body_.nodeCount());
    own_.resize(body_.nodeCount());
    whole_.resize(body_.nodeCount());
    marked_.assign(body_.nodeCount(), 0);
    findLaplacian();
  }
  started_ = std::isfinite(tight);
  bound_ = tight;
  if (!started_) return;
  const double room = std::max(policy_.slack, wanted > tight ? wanted / tight - 1 : 0);
  eta_ = std::clamp(policy_.partOfGrowth * room, policy_.leastGrowth, policy_.mostGrowth);
  if (wanted > 0 && (1 + eta_) * tight > wanted) eta_ = std::max(policy_.partOfGrowth * (wanted / tight - 1), 1e-3);
  if (const DiscreteForces* discrete = body_.discreteForces()) {
    neededAt_.clear();
    needed_.clear();
    discrete->majorants(x, false, needed_, neededAt_);
  }
  for (std::size_t b = 0; b < elements_.size(); ++b) {
    const ElementBlock& block = *body_.blocks()[b];
    Elements& own = elements_[b];
    const std::size_t firstSeen = seen_.size();
    seen_.resize(firstSeen + static_cast<std::size_t>(block.elementCount()));
    parallelFor(
        0, block.layout().batchCount(), body_.threads(),
        [&](std::int64_t batch) {
          Pack pack;
          pack.at = {static_cast<std::int32_t>(b), static_cast<std::int32_t>(batch)};
          pack.elements = block.layout().elements.data() + batch * lanes;
          if (pack.elements[0] < 0) return;
          pack.points = static_cast<int>(block.rule().points.size());
          pack.value = P(0.0);
          move(x, pack, true);
          anchor(pack);
          own.balls.setReferenceGradients(pack.at.batch, pack.F.data());
          for (int lane = 0; lane < lanes; ++lane) {
            if (pack.elements[lane] < 0) continue;
            const ElementRef e{pack.at.block, pack.elements[lane]};
            pack.value.set(lane, weights_.value(e));
            seen_[firstSeen + static_cast<std::size_t>(e.element)] = {e, pack.drift[lane].determinant,
                                                                      pack.drift[lane].law.negative};
          }
          store(pack);
        },
        8);
  }
  parallelFor(
      0, body_.nodeCount(), body_.threads(),
      [&](std::int64_t i) {
        Node& node = nodes_[i];
        node.sum = Symmetric3<double>::diagonal(0);
        double size = 0;
        for (const NodalBound::Incidence at : weights_.incidences(static_cast<std::int32_t>(i))) {
          const ElementRef e = weights_.elementAt(at);
          const Elements& own = elements_[e.block];
          const std::size_t place = placeOf(e);
          const double eta = own.eta[place], uneven = own.uneven[place], value = (1 + eta) * own.value[place],
                       tau = own.geometric[place] + eta * own.negative[place] +
                             uneven * (own.linear[place] +
                                       uneven * (own.quadratic[place] + (1 + 1 / eta) * own.kappa[place]));
          const Eigen::Matrix3d D = weights_.weight(at);
          const double c = own.laplacian[at.place];
          for (int r = 0; r < 3; ++r)
            for (int s = r; s < 3; ++s) node.sum(r, s) += value * D(r, s) + (r == s ? tau * c : 0.0);
          size += value + 3 * tau * c;
        }
        node.rounding = majorantError * size;
        node.ball = 0;
      },
      64);
  weights_.releaseSums();
  std::vector<std::int32_t> all(body_.nodeCount());
  std::iota(all.begin(), all.end(), 0);
  level_ = wanted * (1 - levelRounding);
  room_ = infinity;
  std::fill(marked_.begin(), marked_.end(), 0);
  settle(all);
  for (std::int32_t i = 0; i < body_.nodeCount(); ++i) nodes_[i].anchored = own_[i];
  for (std::size_t b = 0; b < elements_.size(); ++b)
    parallelFor(
        0, body_.blocks()[b]->layout().batchCount(), body_.threads(),
        [&](std::int64_t batch) {
          fit({static_cast<std::int32_t>(b), static_cast<std::int32_t>(batch)});
        },
        64);
}

void MovedBound::followDiscreteForces(NodeVectorsView x) {
  const DiscreteForces* discrete = body_.discreteForces();
  if (!discrete) return;
  std::vector<std::int32_t> nodes;
  for (const std::int32_t k : neededAt_) nodes.push_back(discrete->nodes()[k]);
  discrete->majorants(x, false, needed_, neededAt_);
  for (const std::int32_t k : neededAt_) nodes.push_back(discrete->nodes()[k]);
  sortUnique(nodes);
  settle(nodes);
}

UpperBound MovedBound::update(NodeVectorsView x, StepEvaluation* evaluation, double wanted) {
  statistics_ = {};
  seen_.clear();
  rebuilds_.tick();
  if (bodyVersion_ != body_.version()) {
    bodyVersion_ = body_.version();
    started_ = false;
    nodes_.clear();
    prepare();
    rebuilds_.reset();
  }
  if (!started_) {
    if (evaluation) body_.evaluate(x, *evaluation, outside_.workspace());
    build(x, wanted);
    return {bound_};
  }
  followLevel(wanted);
  const std::vector<ElementRef> outside = outside_.find(body_, elements_, x, evaluation);
  followDiscreteForces(x);
  // The elements of a batch have moved alike: all are visited once one has left.
  std::vector<BatchRef> moved, anchored;
  for (const ElementRef e : outside) {
    const BatchRef at{e.block, static_cast<std::int32_t>(placeOf(e) / lanes)};
    std::vector<BatchRef>& of = elements_[e.block].rateHasRisen(placeOf(e)) ? anchored : moved;
    if (of.empty() || of.back() != at) of.push_back(at);
  }
  // By number the elements of a batch need not stand together.
  sortUnique(moved);
  sortUnique(anchored);
  if (!visit(x, moved, false) || !visit(x, anchored, true)) return {bound_};
  findBound();
  return {bound_};
}

std::int32_t MovedBound::highestNode() const {
  return static_cast<std::int32_t>(std::max_element(whole_.begin(), whole_.end()) - whole_.begin());
}

void MovedBound::findBound() { bound_ = (1 + motionRounding) * largestOf(whole_); }

void MovedBound::followLevel(double wanted) {
  const double highest = largestOf(own_);
  const double target = std::max(wanted * (1 - levelRounding), highest * (1 + policy_.slack) / (1 + eta_)),
               tolerated = 1 + policy_.tolerance * policy_.slack;
  if (target * tolerated < level_) {
    level_ = target;
    room_ = target - highest;
  }
  std::vector<std::int32_t> nodes;
  for (std::int32_t i = 0; i < body_.nodeCount(); ++i) {
    if (!(whole_[i] > level_ * tolerated)) continue;
    setBall(i, allowedAt(i));
    nodes.push_back(i);
  }
  const std::vector<BatchRef> batches = batchesAt(nodes);
  statistics_.fitted += static_cast<std::int64_t>(lanes * batches.size());
  parallelFor(
      0, batches.size(), body_.threads(), [&](std::int64_t k) { fit(batches[k]); }, 64);
}

UpperBound MovedBound::improve(NodeVectorsView x, double aim, std::int64_t most) {
  if (!started_ || !(bound_ > aim)) return {bound_};
  // The highest of those that have risen since they were anchored.
  std::vector<std::pair<float, std::int32_t>> nodes;
  const double least = aim / (1 + policy_.slack);
  for (std::int32_t i = 0; i < body_.nodeCount(); ++i)
    if (own_[i] > least && own_[i] > (1 + policy_.risen) * nodes_[i].anchored) nodes.emplace_back(own_[i], -i);
  std::make_heap(nodes.begin(), nodes.end());
  std::vector<std::int32_t> chosen;
  std::set<BatchRef> batches;
  for (; !nodes.empty(); nodes.pop_back()) {
    std::pop_heap(nodes.begin(), nodes.end());
    const std::int32_t node = -nodes.back().second;
    const std::vector<BatchRef> more = batchesAt({&node, 1});
    if (!chosen.empty() && static_cast<std::int64_t>(lanes * (batches.size() + more.size())) > most) break;
    chosen.push_back(node);
    batches.insert(more.begin(), more.end());
  }
  if (chosen.empty() || !visit(x, std::vector(batches.begin(), batches.end()), true)) return {bound_};
  for (const std::int32_t node : chosen) nodes_[node].anchored = own_[node];
  findBound();
  return {bound_};
}

bool MovedBound::certify(NodeVectorsView x, double sigma, StepEvaluation* evaluation) {
  update(x, evaluation, sigma);
  if (bound_ <= sigma) return true;
  if (!started_) return false;
  // Elements that are visited need no ball: nodes that are too high by their balls alone.
  std::vector<std::int32_t> nodes;
  for (std::int32_t i = 0; i < body_.nodeCount(); ++i)
    if (own_[i] <= sigma && whole_[i] > sigma) nodes.push_back(i);
  if (!nodes.empty()) {
    for (const std::int32_t node : nodes) setBall(node, 0);
    if (!visit(x, batchesAt(nodes), false)) return false;
    findBound();
  }
  if (bound_ <= sigma || improve(x, sigma, body_.mesh().elementCount()).value <= sigma) return true;
  // From scratch, but not at every step while it keeps failing.
  if (!rebuilds_.due()) return false;
  build(x, sigma);
  rebuilds_.tried(bound_ <= sigma);
  return bound_ <= sigma;
}

double MovedBound::verify(NodeVectorsView x) const {
  double excess = -1;
  std::vector<Eigen::Matrix3d> sums(static_cast<std::size_t>(body_.nodeCount()), Eigen::Matrix3d::Zero());
  for (std::size_t b = 0; b < elements_.size(); ++b) {
    const ElementBlock& block = *body_.blocks()[b];
    const int n = block.nodesPerElement(), size = 3 * n;
    AlignedVector<NativePack> K(size * size), rounding(n);
    for (std::int32_t e = 0; e < block.elementCount(); ++e) {
      std::int32_t elements[lanes];
      std::fill(elements, elements + lanes, -1);
      elements[0] = e;
      const std::size_t place = placeOf({static_cast<std::int32_t>(b), e}), lane = place % lanes;
      const Pack pack = load({static_cast<std::int32_t>(b), static_cast<std::int32_t>(place / lanes)});
      Symmetric3<P> majorants[maxElementNodes];
      majorantsOf(pack, majorants);
      const auto nodes = block.nodesOf(e);
      double ball = infinity;
      for (const std::int32_t node : nodes)
        if (!isHeld(body_, node) && nodes_[node].ball < unbounded)
          ball = std::min(ball, static_cast<double>(nodes_[node].ball));
      // Inside its ball the element adds no more than its nodes allow.
      if (const double radius = elements_[b].balls.radius(place); ball < infinity && radius >= 0 && radius < infinity) {
        const double eta = pack.eta[lane], uneven = pack.uneven[lane];
        const TangentGrowth growth{0, pack.linear[lane], pack.quadratic[lane] + (1 + 1 / eta) * pack.kappa[lane],
                                   infinity};
        excess = std::max(excess, (growth.at(uneven + radius) - growth.at(uneven) - ball) / ball);
      }
      block.tangentOf(elements, x.data(), reinterpret_cast<double*>(K.data()),
                      reinterpret_cast<double*>(rounding.data()));
      Eigen::MatrixXd own = Eigen::MatrixXd::Zero(size, size), majorant = own;
      for (int a = 0; a < n; ++a) {
        Eigen::Matrix3d M;
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j) M(i, j) = majorants[a](i, j)[lane];
        sums[nodes[a]] += M;
        if (ball < infinity) M.diagonal().array() += ball * pack.c[a][lane];
        majorant.block<3, 3>(3 * a, 3 * a) = M;
      }
      std::vector<int> free;
      for (int i = 0; i < size; ++i) {
        if (freeFactor(body_, nodes[i / 3], i % 3) != 0) free.push_back(i);
        for (int j = 0; j < size; ++j) own(i, j) = K[i * size + j][0];
      }
      if (free.empty()) continue;
      own = own(free, free).eval();
      majorant = majorant(free, free).eval();
      if (!own.allFinite()) return infinity;
      const double scale = std::max(own.cwiseAbs().maxCoeff(), majorant.cwiseAbs().maxCoeff());
      if (!(scale > 0)) continue;
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(own - majorant, Eigen::EigenvaluesOnly);
      excess = std::max(excess, solver.eigenvalues().maxCoeff() / scale);
    }
  }
  for (std::int32_t i = 0; i < body_.nodeCount(); ++i) {
    Eigen::Matrix3d S = sums[i];
    if (nodes_[i].gamma > 0) S.diagonal().array() += static_cast<double>(nodes_[i].gamma) * nodes_[i].ball;
    if (const DiscreteForces* discrete = body_.discreteForces())
      if (const std::int32_t place = discrete->placeOf(i); place >= 0) {
        std::vector<Eigen::Matrix3d> needed;
        discrete->majorants(x, false, needed);
        S += needed[place];
      }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(freePart(body_, i, S), Eigen::EigenvaluesOnly);
    if (solver.eigenvalues()[2] > 0)
      excess = std::max(excess, solver.eigenvalues()[2] / body_.lumpedMass()[i] / whole_[i] - 1);
  }
  return excess;
}

}  // namespace ringwatch

#include <ringwatch/monitor/bounds/nodal_bound.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <mutex>

#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/sort_unique.h>
#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/body/domain.h>
#include <ringwatch/monitor/bounds/nodal_weights.h>
#include <ringwatch/monitor/bounds/scaled_tangent.h>

namespace ringwatch {
namespace {

using P = NativePack;
/// A sweep touches the elements at nodes with more than this share of the bound, and all their nodes: others do not
/// stand in its way yet.
constexpr double highShare = 0.6;

Symmetric3<double> symmetricOf(const NodalBound::Factor& factor) {
  CholeskyFactor<double> L;
  std::copy(factor.begin(), factor.end(), L.m);
  return productOf(L);
}
Symmetric3<double> symmetricOf(const Eigen::Matrix3d& D) {
  Symmetric3<double> result;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) result(i, j) = 0.5 * (D(i, j) + D(j, i));
  return result;
}
Eigen::Matrix3d matrixOf(const Symmetric3<double>& D) {
  Eigen::Matrix3d result;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) result(i, j) = D(i, j);
  return result;
}

/// To empty is not enough: `vector = {}` keeps the memory.
template <class Vector>
void giveBack(Vector& numbers) {
  Vector().swap(numbers);
}

/// Which components of the elements' nodes are free: 1, or 0. Returns whether any is not.
bool findFree(const TangentSource& source, const ElementTangents& block, const std::int32_t* elements,
              P (&factor)[3 * maxElementNodes]) {
  const int n = block.nodesPerElement();
  std::fill(factor, factor + 3 * n, P(1.0));
  if (!source.constraints().any()) return false;
  bool some = false;
  for (int lane = 0; lane < lanes; ++lane)
    for (const std::int32_t node : block.nodesOf(elements[lane] < 0 ? elements[0] : elements[lane]))
      some |= source.constraints().freeComponents(node) < 3;
  if (!some) return false;
  for (int lane = 0; lane < lanes; ++lane) {
    const auto nodes = block.nodesOf(elements[lane] < 0 ? elements[0] : elements[lane]);
    for (int a = 0; a < n; ++a)
      for (int c = 0; c < 3; ++c) factor[3 * a + c].set(lane, freeFactor(source, nodes[a], c));
  }
  return true;
}

}  // namespace

NodalBound::NodalBound(const TangentSource& source) : source_(&source) {
  std::vector<std::int64_t> count(static_cast<std::size_t>(source.nodeCount()) + 1, 0);
  auto forEachIncidence = [&](auto&& visit) {
    for (std::size_t b = 0; b < source.tangents().size(); ++b) {
      const ElementTangents& block = *source.tangents()[b];
      const int n = block.nodesPerElement();
      for (std::int32_t e = 0; e < block.elementCount(); ++e) {
        const auto nodes = block.nodesOf(e);
        for (int a = 0; a < n; ++a) visit(nodes[a], incidenceOf({b, e}, a));
      }
    }
  };
  forEachIncidence([&](std::int32_t node, Incidence) { ++count[static_cast<std::size_t>(node) + 1]; });
  for (std::size_t i = 1; i < count.size(); ++i) count[i] += count[i - 1];
  incidenceBegin_ = count;
  std::int64_t places = 0;
  for (const ElementTangents* block : source.tangents()) {
    const auto weights =
        static_cast<std::size_t>(block->layout().batchCount()) * static_cast<std::size_t>(block->nodesPerElement());
    firstOfBlock_.push_back(places);
    places += static_cast<std::int64_t>(weights * lanes);
    if (places > std::numeric_limits<std::int32_t>::max())
      throw InputError("the nodal bound: more than 2^31 nodes of elements; use a metric for a body of this size");
    weights_.emplace_back(weights);
  }
  firstOfBlock_.push_back(places);
  incidence_.resize(count.back());
  forEachIncidence(
      [&](std::int32_t node, Incidence i) { incidence_[count[node]++] = firstOfBlock_[i.block] + i.place; });
}

CholeskyFactor<P> NodalBound::load(const StoredFactor& stored) {
  CholeskyFactor<P> L;
  for (int c = 0; c < 6; ++c) L.m[c] = ShortRoot::load(stored.m[c]);
  return L;
}

void NodalBound::store(const Symmetric3<P>& weight, StoredFactor& stored) {
  const CholeskyFactor<P> L = ringwatch::factorOf(weight);
  for (int c = 0; c < 6; ++c) ShortRoot::store(L.m[c], stored.m[c]);
}

NodalBound::Factor NodalBound::factorOf(const Eigen::Matrix3d& D) {
  const CholeskyFactor<double> L = ringwatch::factorOf(symmetricOf(D));
  Factor rounded;
  for (std::size_t c = 0; c < 6; ++c) rounded[c] = ShortRoot(L.m[c]);
  return rounded;
}

Eigen::Matrix3d NodalBound::weightOf(const Factor& factor) { return matrixOf(symmetricOf(factor)); }

void NodalBound::prepareSums() {
  const std::size_t packs = (static_cast<std::size_t>(source_->nodeCount()) + lanes - 1) / lanes;
  if (sums_.size() == packs && values_.size() == weights_.size()) return;
  for (const ElementTangents* block : source_->tangents())
    values_.emplace_back(static_cast<std::size_t>(block->layout().batchCount()));
  sums_.resize(packs);
  factors_.resize(packs);
  nodal_.resize(packs * lanes);
  changed_.resize(packs * lanes);
}

void NodalBound::releaseSums() {
  giveBack(values_);
  giveBack(sums_);
  giveBack(factors_);
  giveBack(nodal_);
  giveBack(changed_);
}

void NodalBound::evaluateAll(NodeVectorsView x, const Start* start) {
  poorlyConditioned_.clear();
  std::mutex noting;
  source_->forEachTangentBatch(x, [&](std::size_t b, std::int32_t batch, P* K, const P* T) {
    const ElementTangents& block = *source_->tangents()[b];
    const int n = block.nodesPerElement(), size = 3 * n;
    P free[3 * maxElementNodes];
    if (findFree(*source_, block, block.layout().elements.data() + static_cast<std::ptrdiff_t>(batch) * lanes, free))
      scaleSymmetric(K, size, free);
    StoredFactor* stored = weights_[b].data() + static_cast<std::ptrdiff_t>(batch) * n;
    if (start) {
      Symmetric3<P> weights[maxElementNodes];
      for (int a = 0; a < n; ++a) {
        if (*start == Start::rows) {
          weights[a] = sizeOfRows(K, size, a);
          continue;
        }
        Symmetric3<P> k;
        for (int r = 0; r < 3; ++r)
          for (int c = r; c < 3; ++c) k(r, c) = K[(3 * a + r) * size + 3 * a + c];
        weights[a] = sizeOf(k);
      }
      normaliseWeights(weights, n);
      for (int a = 0; a < n; ++a) store(weights[a], stored[a]);
    }
    P work[12 * maxElementNodes], w[maxElementNodes][6], rounding(0.0);
    for (int a = 0; a < n; ++a) {
      const CholeskyFactor<P> L = load(stored[a]);
      invertFactor(L, w[a]);
      rounding += scaledRounding(L, w[a], T[a], free + 3 * a);
    }
    scaleByFactors(w, n, K);
    const P value = values_[b][batch] = largestRoundedUp(K, size, work, rounding);
    const auto large = rounding > P(largeRounding) * value;
    if (!anyOf(large)) return;
    const P share = select(large, rounding / value, P(0.0));
    const std::lock_guard lock(noting);
    for (int lane = 0; lane < lanes; ++lane)
      if (const std::int32_t e = block.layout().elements[static_cast<std::ptrdiff_t>(batch) * lanes + lane];
          e >= 0 && share[lane] > 0)
        poorlyConditioned_.push_back({share[lane], {b, e}});
  });
  std::sort(poorlyConditioned_.begin(), poorlyConditioned_.end(), [](const RoundingShare& a, const RoundingShare& b) {
    return a.share != b.share ? a.share > b.share : a.element < b.element;
  });
  for (std::size_t b = 0; b < source_->tangents().size(); ++b) {
    const std::int32_t count = source_->tangents()[b]->elementCount();
    if (!domain_) evaluations_ += count;
    for (std::int32_t e = 0; domain_ && e < count; ++e) evaluations_ += domain_->counts({b, e}) ? 1 : 0;
  }
  std::fill(changed_.begin(), changed_.end(), true);
}

void NodalBound::setDomain(Domain& domain) { domain_ = domain.whole() ? nullptr : &domain; }

void NodalBound::completeSums() {
  const std::int32_t nodes = source_->nodeCount();
  Eigen::Matrix<double, 6, Eigen::Dynamic> sums(6, nodes);
  for (std::int32_t i = 0; i < nodes; ++i)
    for (int c = 0; c < 6; ++c) sums(c, i) = sums_[i / lanes].m[c][i % lanes];
  domain_->exchange(sums);
  for (std::int32_t i = 0; i < nodes; ++i)
    for (int c = 0; c < 6; ++c) sums_[i / lanes].m[c].set(i % lanes, sums(c, i));
}

Symmetric3<P> NodalBound::sumOfElements(std::int64_t pack) const {
  Symmetric3<P> sum = Symmetric3<P>::diagonal(P(0.0));
  const std::int32_t *next[lanes], *end[lanes];
  std::ptrdiff_t most = 0;
  for (int lane = 0; lane < lanes; ++lane) {
    const auto node = static_cast<std::size_t>(std::min<std::int64_t>(pack * lanes + lane, source_->nodeCount()));
    next[lane] = incidence_.data() + incidenceBegin_[node];
    end[lane] = incidence_.data() + incidenceBegin_[std::min<std::size_t>(node + 1, incidenceBegin_.size() - 1)];
    most = std::max(most, end[lane] - next[lane]);
  }
  StoredFactor stored{};
  for (; most > 0; --most) {
    P value(0.0);
    for (int lane = 0; lane < lanes; ++lane) {
      if (next[lane] == end[lane]) continue;
      std::int32_t block = 0;
      while (*next[lane] >= firstOfBlock_[block + 1]) ++block;
      const std::int32_t place = *next[lane]++ - firstOfBlock_[block];
      const StoredFactor& from = weights_[block][place / lanes];
      for (int c = 0; c < 6; ++c) stored.m[c][lane] = from.m[c][place % lanes];
      value.set(lane, values_[block][place / lanes / source_->tangents()[block]->nodesPerElement()][place % lanes]);
    }
    sum = sum + value * productOf(load(stored));
  }
  return sum;
}

double NodalBound::sumAtNodes() {
  const std::int32_t nodes = source_->nodeCount();
  const auto hasChanged = [&](std::int64_t pack) {
    const auto* changed = changed_.data() + pack * lanes;
    return std::find(changed, changed + lanes, true) != changed + lanes;
  };
  parallelFor(
      0, sums_.size(), source_->threads(),
      [&](std::int64_t pack) {
        if (!hasChanged(pack)) return;
        Symmetric3<P> S = sumOfElements(pack);
        for (int lane = 0; lane < lanes; ++lane) {
          const auto node = static_cast<std::int32_t>(pack) * lanes + lane;
          if (node >= nodes) continue;
          const auto add = [&](const Eigen::Matrix3d& other) {
            for (int r = 0; r < 3; ++r)
              for (int c = r; c < 3; ++c) S(r, c).set(lane, S(r, c)[lane] + other(r, c));
          };
          if (!outside_.empty()) add(outside_[node]);
          if (!majorants_.empty()) add(majorantAt(node));
          const double inverseMass = 1 / source_->lumpedMass()[node];
          // Constrained components leave the problem: their rows and columns count nothing.
          const double free[3] = {freeFactor(*source_, node, 0), freeFactor(*source_, node, 1),
                                  freeFactor(*source_, node, 2)};
          const double keep[6] = {free[0], free[1], free[2], free[1] * free[2], free[0] * free[2], free[0] * free[1]};
          for (int c = 0; c < 6; ++c) S.m[c].set(lane, keep[c] == 0 ? 0.0 : inverseMass * S.m[c][lane]);
        }
        sums_[pack] = S;
      },
      64);
  if (domain_) completeSums();
  parallelFor(
      0, sums_.size(), source_->threads(),
      [&](std::int64_t pack) {
        // Of what has changed elsewhere nothing is known.
        if (!domain_ && !hasChanged(pack)) return;
        const Symmetric3<P>& S = sums_[pack];
        P A[9], work[12];
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j <= i; ++j) A[3 * i + j] = S(i, j);
        const auto extremes = extremeEigenvalues(A, 3, work, false);
        (extremes.largest + P(eigenvalueRounding) * extremes.scale).store(nodal_.data() + pack * lanes);
      },
      64);
  double bound = 0;
  for (std::int32_t i = 0; i < nodes; ++i) {
    // A NaN stays: it must not pass for zero.
    if (!(nodal_[i] <= bound)) bound = nodal_[i];
    if (std::isnan(bound)) break;
  }
  if (domain_) domain_->largest({&bound, 1});
  return bound;
}

void NodalBound::findFactors(double bound) {
  const std::int32_t nodes = source_->nodeCount();
  parallelFor(
      0, sums_.size(), source_->threads(),
      [&](std::int64_t pack) {
        Symmetric3<P> S = P(1 / bound) * sums_[pack];
        for (int lane = 0; lane < lanes; ++lane) {
          const auto node = static_cast<std::int32_t>(pack) * lanes + lane;
          if (node >= nodes)
            for (int c = 0; c < 3; ++c) S.m[c].set(lane, 1.0);
          else
            for (int c = 0; c < 3; ++c)
              if (freeFactor(*source_, node, c) == 0) S.m[c].set(lane, 1.0);
        }
        factors_[pack] = sweepFactor(S);
      },
      64);
}

void NodalBound::sweep(NodeVectorsView x, double bound) {
  findFactors(bound);
  std::fill(changed_.begin(), changed_.end(), false);
  for (std::size_t b = 0; b < source_->tangents().size(); ++b) {
    const ElementTangents& block = *source_->tangents()[b];
    const int n = block.nodesPerElement();
    std::vector<std::int32_t> high;
    for (const std::int32_t e : block.layout().elements) {
      if (e < 0) continue;
      const auto nodes = block.nodesOf(e);
      if (std::none_of(nodes.begin(), nodes.end(), [&](std::int32_t node) { return nodal_[node] > highShare * bound; }))
        continue;
      high.push_back(e);
      for (const std::int32_t node : nodes) changed_[node] = true;
    }
    evaluations_ += domain_ ? std::count_if(high.begin(), high.end(),
                                            [&](std::int32_t e) {
                                              return domain_->counts({b, e});
                                            })
                            : static_cast<std::ptrdiff_t>(high.size());
    high.resize((high.size() + lanes - 1) / lanes * lanes, -1);
    parallelFor(
        0, high.size() / lanes, source_->threads(),
        [&](std::int64_t pack) {
          const std::int32_t* elements = high.data() + pack * lanes;
          StoredFactor stored[maxElementNodes];
          gather(b, elements, stored);
          Symmetric3<P> weights[maxElementNodes];
          for (int a = 0; a < n; ++a) {
            Symmetric3<P> R;
            for (int lane = 0; lane < lanes; ++lane) {
              const std::int32_t node = block.nodesOf(elements[lane] < 0 ? elements[0] : elements[lane])[a];
              const Symmetric3<P>& from = factors_[node / lanes];
              for (int c = 0; c < 6; ++c) R.m[c].set(lane, from.m[c][node % lanes]);
            }
            weights[a] = congruence(R, productOf(load(stored[a])));
          }
          normaliseWeights(weights, n);
          for (int a = 0; a < n; ++a) store(weights[a], stored[a]);
          double value[lanes];
          for (int lane = 0; lane < lanes; ++lane) {
            if (elements[lane] < 0) continue;
            const std::int32_t place = block.layout().batchOfElement[elements[lane]];
            for (int a = 0; a < n; ++a)
              for (int c = 0; c < 6; ++c) weights_[b][place / lanes * n + a].m[c][place % lanes] = stored[a].m[c][lane];
          }
          elementValues(b, elements, x, value);
          for (int lane = 0; lane < lanes; ++lane)
            if (elements[lane] >= 0) setValue({b, elements[lane]}, value[lane]);
        },
        8);
  }
}

Eigen::Matrix3d NodalBound::majorantAt(std::int32_t node) const {
  const std::int32_t place = majorants_.empty() ? -1 : source_->discreteForces()->placeOf(node);
  return place < 0 ? Eigen::Matrix3d(Eigen::Matrix3d::Zero()) : majorants_[place];
}

UpperBound NodalBound::evaluate(NodeVectorsView x, int sweeps, Start start, double leastGain,
                                const SweepTarget& enough) {
  evaluations_ = 0;
  prepareSums();
  if (source_->discreteForces() && !keepsMajorants_) source_->discreteForces()->majorants(x, false, majorants_);
  evaluateAll(x, started_ ? nullptr : &start);
  started_ = true;
  double best = infinity, before[2] = {best, best};
  for (int done = 0;; ++done) {
    const double bound = sumAtNodes();
    last_ = bound;
    if (std::isnan(bound)) {
      started_ = false;
      return {bound};
    }
    best = std::min(best, bound);
    const auto gainsNoMoreThan = [&](double gain) { return bound >= (1 - gain) * before[0]; };
    const bool isEnough =
        bound <= enough.ample || (bound <= enough.value && (static_cast<double>(evaluations_) >= enough.evaluations ||
                                                            gainsNoMoreThan(enough.leastGain)));
    const bool isHopeless = enough.leastOfRest > 0 && before[0] - bound < enough.leastOfRest * (bound - enough.ample);
    if (done == sweeps || isEnough || isHopeless || (leastGain > 0 && gainsNoMoreThan(leastGain))) break;
    before[0] = before[1];
    before[1] = bound;
    sweep(x, bound);
  }
  return {best};
}

ElementRef NodalBound::elementAt(Incidence at) const {
  const ElementTangents& block = *source_->tangents()[at.block];
  const std::int32_t batch = at.place / lanes / block.nodesPerElement();
  return {at.block, block.layout().elements[batch * lanes + at.place % lanes]};
}

std::vector<ElementRef> NodalBound::elementsAt(std::span<const std::int32_t> nodes) const {
  std::vector<ElementRef> elements;
  for (const std::int32_t node : nodes)
    for (const Incidence at : incidences(node)) elements.push_back(elementAt(at));
  sortUnique(elements);
  return elements;
}

NodalBound::Incidence NodalBound::incidenceOf(ElementRef e, int a) const {
  const ElementTangents& block = *source_->tangents()[e.block];
  const std::int32_t place = block.layout().batchOfElement[e.element];
  return {e.block, (place / lanes * block.nodesPerElement() + a) * lanes + place % lanes};
}

NodalBound::Factor NodalBound::factor(Incidence at) const {
  const StoredFactor& stored = weights_[at.block][at.place / lanes];
  Factor L;
  for (std::size_t c = 0; c < 6; ++c) L[c] = stored.m[c][at.place % lanes];
  return L;
}

void NodalBound::setFactor(Incidence at, const Factor& L) {
  StoredFactor& stored = weights_[at.block][at.place / lanes];
  for (std::size_t c = 0; c < 6; ++c) stored.m[c][at.place % lanes] = L[c];
}

void NodalBound::setWeights(ElementRef e, std::span<const Eigen::Matrix3d> weights) {
  const auto n = static_cast<int>(weights.size());
  Symmetric3<double> own[maxElementNodes];
  for (int a = 0; a < n; ++a) own[a] = symmetricOf(weights[a]);
  normaliseWeights(own, n);
  for (int a = 0; a < n; ++a) setWeight(incidenceOf(e, a), matrixOf(own[a]));
}

void NodalBound::gather(std::size_t b, const std::int32_t* elements, StoredFactor* factors) const {
  const ElementTangents& block = *source_->tangents()[b];
  const int n = block.nodesPerElement();
  for (int lane = 0; lane < lanes; ++lane) {
    const std::int32_t place = block.layout().batchOfElement[elements[lane] < 0 ? elements[0] : elements[lane]];
    const StoredFactor* from = weights_[b].data() + static_cast<std::ptrdiff_t>(place / lanes) * n;
    for (int a = 0; a < n; ++a)
      for (int c = 0; c < 6; ++c) factors[a].m[c][lane] = from[a].m[c][place % lanes];
  }
}

void NodalBound::weightsOf(std::int32_t b, std::int32_t batch, Symmetric3<P>* D) const {
  const int n = source_->tangents()[b]->nodesPerElement();
  for (int a = 0; a < n; ++a) D[a] = productOf(load(weights_[b][static_cast<std::ptrdiff_t>(batch) * n + a]));
}

void NodalBound::setWeightsOf(std::int32_t b, std::int32_t batch, const Symmetric3<P>* D) {
  const int n = source_->tangents()[b]->nodesPerElement();
  Symmetric3<P> weights[maxElementNodes];
  std::copy(D, D + n, weights);
  normaliseWeights(weights, n);
  for (int a = 0; a < n; ++a) store(weights[a], weights_[b][static_cast<std::ptrdiff_t>(batch) * n + a]);
}

void NodalBound::elementValues(std::int32_t b, const std::int32_t* elements, NodeVectorsView x, double* values) const {
  P K[9 * maxElementNodes * maxElementNodes], T[maxElementNodes];
  source_->tangents()[b]->tangentOf(elements, x.data(), reinterpret_cast<double*>(K), reinterpret_cast<double*>(T));
  const ElementMatrices tangents{K, T, values};
  weightedLargest(b, elements, {&tangents, 1});
}

void NodalBound::weightedLargest(std::int32_t b, const std::int32_t* elements,
                                 std::span<const ElementMatrices> sets) const {
  const ElementTangents& block = *source_->tangents()[b];
  const int n = block.nodesPerElement();
  StoredFactor gathered[maxElementNodes];
  gather(b, elements, gathered);
  P w[maxElementNodes][6], work[12 * maxElementNodes];
  CholeskyFactor<P> L[maxElementNodes];
  for (int a = 0; a < n; ++a) {
    L[a] = load(gathered[a]);
    invertFactor(L[a], w[a]);
  }
  P free[3 * maxElementNodes];
  const bool constrained = findFree(*source_, block, elements, free);
  for (const auto& [matrices, T, largest] : sets) {
    P rounding(0.0);
    for (int a = 0; a < n; ++a) rounding += scaledRounding(L[a], w[a], T[a], free + 3 * a);
    if (constrained) scaleSymmetric(matrices, 3 * n, free);
    scaleByFactors(w, n, matrices);
    largestRoundedUp(matrices, 3 * n, work, rounding).store(largest);
  }
}

const std::vector<double>& NodalBound::sumsOf(const std::vector<std::span<const RoundedUp<float>>>& values) {
  prepareSums();
  for (std::size_t b = 0; b < values_.size(); ++b)
    for (std::size_t place = 0; place < values[b].size(); ++place)
      values_[b][place / lanes].set(static_cast<int>(place % lanes), static_cast<double>(values[b][place]));
  std::fill(changed_.begin(), changed_.end(), true);
  sumAtNodes();
  return nodal_;
}

void NodalBound::setValue(ElementRef e, double value) {
  const std::int32_t place = source_->tangents()[e.block]->layout().batchOfElement[e.element];
  // Other lanes belong to other threads.
  std::memcpy(reinterpret_cast<std::byte*>(values_[e.block].data()) + static_cast<std::size_t>(place) * sizeof value,
              &value, sizeof value);
}

double NodalBound::value(ElementRef e) const {
  const ElementTangents& block = *source_->tangents()[e.block];
  const std::int32_t place = block.layout().batchOfElement[e.element];
  return values_[e.block][place / lanes][place % lanes];
}

}  // namespace ringwatch

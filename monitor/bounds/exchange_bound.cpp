#include <ringwatch/monitor/bounds/exchange_bound.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/rounding.h>
#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/monitor/bounds/scaled_tangent.h>
#include <ringwatch/monitor/small/packed_lowest.h>

namespace ringwatch {
namespace {

using Pack = NativePack;

LowestPart<Pack> removeLowestPart(Pack* A, Pack* P, int n, const Pack& enough, const Pack& step) {
  switch (n) {
    case 12:
      return removeLowestPart<12>(A, P, n, enough, step);
    case 15:
      return removeLowestPart<15>(A, P, n, enough, step);
    case 18:
      return removeLowestPart<18>(A, P, n, enough, step);
    case 24:
      return removeLowestPart<24>(A, P, n, enough, step);
    default:
      return removeLowestPart<0>(A, P, n, enough, step);
  }
}

/// A matrix is shifted by this of the certified eigenvalue, times powers of two, until it is definite; then by halving.
constexpr double leastShift = 0x1p-14;
constexpr int mostDoublings = 20, halvings = 2;

class Composition final : public detail::ExchangeSplit {
 public:
  /// shares: goes on from these, of another state; nullptr: from the weights' own split.
  Composition(const TangentSource& source, NodeVectorsView x, const NodalBound& weights, double sigma,
              const ExchangeRoom& room = {}, const ExchangeShares* shares = nullptr,
              const std::vector<Eigen::Matrix3d>* majorants = nullptr)
      : source_(source), room_(room), majorants_(majorants), sigma_(sigma) {
    source.assembleBlocks(x, pattern_);
    std::int64_t total = 0;
    for (std::size_t b = 0; b < source.tangents().size(); ++b) {
      const int n = source.tangents()[b]->nodesPerElement();
      firstOfGroup_.push_back(elements_.size());
      for (std::int32_t e = 0; e < source.tangents()[b]->elementCount(); ++e) {
        elements_.push_back({{b, e}, n, total});
        total += 9 * n * n;
      }
    }
    P_.resize(total);
    fillTangents(x, P_);
    norms_.resize(elements_.size());
    for (std::size_t e = 0; e < elements_.size(); ++e) norms_[e] = normOf(P_, e);
    indexBlocks();
    setTarget(P_, weights);
    if (shares)
      startFrom(*shares);
    else
      startFrom(weights);
    moved_.assign(elements_.size(), 0.0);
    reserve_.resize(elements_.size());
    for (std::size_t e = 0; e < elements_.size(); ++e) reserve_[e] = -normOf(P_, e);
    excess_.assign(elements_.size(), 0.0);
    negative_.assign(elements_.size(), 0.0);
    spread(0);
    before_ = P_;
  }

  /// Goes on with the present P_e at another state and sigma: what is then missing from the sum is spread.
  void moveTo(NodeVectorsView x, const NodalBound& weights, double sigma) {
    sigma_ = sigma;
    before_.resize(P_.size());
    fillTangents(x, before_);
    // The sum is made right anew, so rounding of former states is none of this one's.
    for (std::size_t e = 0; e < elements_.size(); ++e) norms_[e] = std::max(normOf(P_, e), normOf(before_, e));
    setTarget(before_, weights);
    spread(0);
    before_ = P_;
    momentum_ = 1;
    lastSum_ = infinity;
    decompositions_ = 0;
  }

  /// One iteration; returns the bound of the iterate that it began with.
  double iterate() {
    const std::vector<Group> groups = groupsOf([&](std::size_t e) {
      excess_[e] = exchangeRounding * norms_[e] + tangentRounding_[e];
      negative_[e] = 0;
      const bool maybeNegative = !(reserve_[e] > 0);
      decompositions_ += maybeNegative;
      return maybeNegative;
    });
    parallelFor(
        0, groups.size(), source_.threads(),
        [&](std::int64_t g) { removeNegativeParts(groups[g].element, groups[g].count); }, 4);
    std::vector<double> nodal(source_.nodeCount(), 0.0);
    double sum = 0;
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      for (std::int32_t node : nodesOf(e)) nodal[node] += excess_[e];
      sum += negative_[e];
    }
    // Nesterov's sequence, from the start again when the last step was uphill.
    if (sum > lastSum_) momentum_ = 1;
    lastSum_ = sum;
    const double next = 0.5 * (1 + std::sqrt(1 + 4 * momentum_ * momentum_)), beta = (momentum_ - 1) / next;
    momentum_ = next;
    spread(beta);
    double most = 0;
    for (const double value : nodal) {
      if (!std::isfinite(value)) return infinity;
      most = std::max(most, value);
    }
    return std::isfinite(sum) ? std::max(sigma_ + most, alone_) : infinity;
  }

  /// Until the bound is at or below `accept`.
  ExchangeBound lowerUntil(double accept, int maxIterations) {
    ExchangeBound result{{infinity}, 0, 0};
    while (result.iterations < maxIterations && !(result.upper.value <= accept)) {
      const double value = iterate();
      result.upper.value = std::min(result.upper.value, value);
      ++result.iterations;
      if (!std::isfinite(value)) break;
    }
    result.decompositions = decompositions_;
    return result;
  }

  /// The present iterate in whole numbers; no iteration can follow.
  ExchangeShares shares(NodeVectorsView x, int bits) {
    fillTangents(x, before_);
    ExchangeShares result{bits, {infinity}, 0, {}};
    const double largest = makePositive();
    if (!std::isfinite(largest) || !(largest > 0)) return result;
    // Room for what a number takes of others, and for its row's margin, so that none overflows.
    result.unit = bits == ExchangeShares::wide ? std::exp2(1 + std::ceil(std::log2(largest))) : 1.02 * largest;
    makeWhole(result.unitOfEntries());
    // What a node's elements have of its own block.
    double highest = 0;
    for (std::int32_t i = 0; i < source_.nodeCount(); ++i)
      for (std::int64_t k = pattern_.rowBegin[i]; k < pattern_.rowBegin[static_cast<std::size_t>(i) + 1]; ++k)
        if (pattern_.column[k] == i) highest = std::max(highest, highestEigenvalue(sumOf(k)));
    result.upper.value = highest * result.unitOfEntries() * (1 + statedRounding);
    for (std::size_t e = 0; e < elements_.size(); ++e)
      for (int i = 0; i < 3 * elements_[e].nodes; ++i)
        for (int j = 0; j <= i; ++j)
          result.entries.push_back(static_cast<std::int32_t>(P_[elements_[e].begin + i * 3 * elements_[e].nodes + j]));
    return result;
  }

 private:
  struct Element {
    ElementRef ref;
    int nodes;
    std::int64_t begin;  // of its matrix in P_
  };
  /// A 3×3 block of an element's matrix: first entry, and entries from one column to the next.
  struct Place {
    std::int64_t first;
    std::int32_t stride;
  };
  struct Group {
    std::size_t element[lanes];
    int count;
  };
  /// The elements that are chosen, in packs of one size.
  template <class Choose>
  std::vector<Group> groupsOf(const Choose& choose) const {
    std::vector<Group> groups;
    int open = -1;
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      if (!choose(e)) continue;
      if (open < 0 || groups.back().count == lanes || open != elements_[e].nodes) {
        groups.push_back({{}, 0});
        open = elements_[e].nodes;
      }
      groups.back().element[groups.back().count++] = e;
    }
    return groups;
  }
  void removeNegativeParts(const std::size_t* elements, int count) {
    const int size = 3 * elements_[elements[0]].nodes;
    const std::size_t entries = size * size;
    thread_local AlignedVector<Pack> work;
    work.resize(2 * entries);
    Pack *P = work.data(), *A = P + entries, enough, step;
    for (int lane = 0; lane < lanes; ++lane) {  // empty lanes repeat the first element
      const std::size_t e = elements[lane < count ? lane : 0];
      const double* from = P_.data() + elements_[e].begin;
      for (std::size_t i = 0; i < entries; ++i) P[i].set(lane, from[i]);
      enough.set(lane, -reserve_[e] + excess_[e]);
      step.set(lane, moved_[e] + excess_[e]);
    }
    const LowestPart<Pack> part = removeLowestPart(A, P, size, enough, step);
    for (int lane = 0; lane < count; ++lane) {
      const std::size_t e = elements[lane];
      // A NaN must not pass for zero.
      excess_[e] += part.least[lane] >= 0 ? 0.0 : -part.least[lane];
      negative_[e] = part.square[lane];
      reserve_[e] = std::isfinite(part.least[lane]) ? part.least[lane] : -norms_[e];
      if (!(part.square[lane] > 0)) continue;
      double* to = P_.data() + elements_[e].begin;
      for (std::size_t i = 0; i < entries; ++i) to[i] = P[i][lane];
    }
  }
  std::span<const std::int32_t> nodesOf(std::size_t e) const {
    return source_.tangents()[elements_[e].ref.block]->nodesOf(elements_[e].ref.element);
  }
  Eigen::Map<Eigen::Matrix3d, 0, Eigen::OuterStride<>> at(AlignedVector<double>& values, const Place& place) const {
    return Eigen::Map<Eigen::Matrix3d, 0, Eigen::OuterStride<>>(values.data() + place.first,
                                                                Eigen::OuterStride<>(place.stride));
  }
  static Place placeOf(const Element& element, int a, int b) {
    const int size = 3 * element.nodes;
    return {element.begin + static_cast<std::int64_t>(3 * b) * size + 3 * a, size};
  }

  /// -A_e, with their room, constrained components zero.
  void fillTangents(NodeVectorsView x, AlignedVector<double>& to) {
    tangentRounding_.resize(elements_.size());
    source_.forEachTangentBatch(x, [&](std::size_t b, std::int32_t batch, NativePack* K, const NativePack* ofTangent) {
      const ElementTangents& block = *source_.tangents()[b];
      const int n = block.nodesPerElement(), size = 3 * n;
      NativePack T[maxElementNodes];
      std::copy_n(ofTangent, n, T);
      if (room_) room_(b, block.layout().elements.data() + static_cast<std::ptrdiff_t>(batch) * lanes, K, T);
      for (int lane = 0; lane < lanes; ++lane) {
        const std::int32_t e =
            block.layout().elements[static_cast<std::size_t>(batch) * lanes + static_cast<std::size_t>(lane)];
        if (e < 0) continue;
        const auto nodes = block.nodesOf(e);
        double scale[3 * maxElementNodes];
        for (int i = 0; i < size; ++i) {
          const std::int32_t node = nodes[i / 3];
          scale[i] = freeFactor(source_, node, i % 3) / std::sqrt(source_.lumpedMass()[node]);
        }
        const std::size_t element = firstOfGroup_[b] + static_cast<std::size_t>(e);
        // |Σ_ab ΔA_ab v_a v_b| <= Σ_a T_a/m_a for a unit vector.
        tangentRounding_[element] = 0;
        for (int a = 0; a < n; ++a) tangentRounding_[element] += T[a][lane] / source_.lumpedMass()[nodes[a]];
        double* P = to.data() + elements_[element].begin;
        for (int i = 0; i < size; ++i)
          for (int j = 0; j <= i; ++j) P[i * size + j] = P[j * size + i] = -K[i * size + j][lane] * scale[i] * scale[j];
      }
    });
  }
  /// P_e := A_e + P_e + eps_e I, of free components, which is at least A_e and at least 0. before_: -A_e. Returns the
  /// size of its largest number.
  double makePositive() {
    std::vector<double> most(elements_.size());
    const std::vector<Group> groups = groupsOf([](std::size_t) { return true; });
    parallelFor(
        0, groups.size(), source_.threads(),
        [&](std::int64_t g) { makePositive(groups[g].element, groups[g].count, most); }, 4);
    return most.empty() ? 0.0 : *std::max_element(most.begin(), most.end());
  }
  void makePositive(const std::size_t* elements, int count, std::vector<double>& most) {
    const int size = 3 * elements_[elements[0]].nodes;
    const std::size_t entries = size * size;
    thread_local AlignedVector<Pack> work;
    work.resize(2 * entries);
    const auto load = [&](bool withTangent, const Pack& shift) {
      for (int lane = 0; lane < lanes; ++lane) {  // empty lanes repeat the first element
        const std::int64_t begin = elements_[elements[lane < count ? lane : 0]].begin;
        const double *P = P_.data() + begin, *minusA = before_.data() + begin;
        for (int i = 0; i < size; ++i)
          for (int j = 0; j <= i; ++j) {
            const double own = 0.5 * (P[i * size + j] + P[j * size + i]);
            work[i * size + j].set(lane, withTangent ? own - minusA[i * size + j] : own);
          }
      }
      for (int i = 0; i < size; ++i) work[i * size + i] += shift;
    };
    Pack rounding;
    for (int lane = 0; lane < lanes; ++lane) {
      const std::size_t e = elements[lane < count ? lane : 0];
      rounding.set(lane, exchangeRounding * std::max(normOf(P_, e), normOf(before_, e)) + tangentRounding_[e]);
    }
    const auto definite = [&](const Pack& shift) {
      load(false, shift - rounding);
      const Pack own = pivotsArePositive(work.data(), size);
      load(true, shift - rounding);
      return own * pivotsArePositive(work.data(), size) > Pack(0.0);
    };
    Pack low(0.0), high(0.0);
    Pack::Mask done = definite(high);
    for (int k = 0; k < mostDoublings && !allOf(done); ++k) {
      const Pack next(std::ldexp(leastShift * sigma_, k));
      low = select(done, low, high);
      high = select(done, high, next);
      done = definite(high);
    }
    for (int k = 0; k < halvings; ++k) {
      const Pack middle = Pack(0.5) * (low + high);
      const auto enough = definite(middle);
      high = select(enough, middle, high);
      low = select(enough, low, middle);
    }
    for (int lane = 0; lane < count; ++lane) {
      const std::size_t e = elements[lane];
      Eigen::Map<Eigen::MatrixXd> P(P_.data() + elements_[e].begin, size, size);
      P = (0.5 * (P + P.transpose())).eval();
      P -= Eigen::Map<const Eigen::MatrixXd>(before_.data() + elements_[e].begin, size, size);
      P.diagonal().array() += high[lane];
      for (int i = 0; i < size; ++i)
        if (freeFactor(source_, nodesOf(e)[i / 3], i % 3) == 0) {
          P.row(i).setZero();
          P.col(i).setZero();
        }
      // A NaN must not be lost, nor one that no shift made definite.
      most[e] = std::isfinite(P.sum()) && done[lane] ? P.cwiseAbs().maxCoeff() : infinity;
    }
  }
  /// Rounds to whole multiples of a unit. What the numbers of one pair of nodes lose goes to the next one, so that they
  /// still add up to zero; the sizes of what a row has moved by, added to its diagonal, make up for it.
  void makeWhole(double unit) {
    for (double& value : P_) value /= unit;
    before_ = P_;
    for (std::int32_t i = 0; i < source_.nodeCount(); ++i)
      for (std::int64_t k = pattern_.rowBegin[i]; k < pattern_.rowBegin[static_cast<std::size_t>(i) + 1]; ++k) {
        const bool pair = pattern_.column[k] != i;
        Eigen::Matrix3d left = Eigen::Matrix3d::Zero();
        for (const Place& place : placesOf(k)) {
          auto block = at(P_, place);
          if (pair) left += block;
          block = (pair ? left : Eigen::Matrix3d(block)).unaryExpr([](double value) { return std::nearbyint(value); });
          if (pair) left -= block;
        }
        if (pair && !placesOf(k).empty()) at(P_, placesOf(k).back()) -= sumOf(k);
      }
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      const int size = 3 * elements_[e].nodes;
      double* P = P_.data() + elements_[e].begin;
      const double* exact = before_.data() + elements_[e].begin;
      for (int i = 0; i < size; ++i) {
        double moved = 0;
        for (int j = 0; j < size; ++j) moved += std::abs(P[i * size + j] - exact[i * size + j]);
        P[i * size + i] += std::ceil(moved);
      }
    }
  }
  static double highestEigenvalue(const Eigen::Matrix3d& S) {
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(S, Eigen::EigenvaluesOnly).eigenvalues()[2];
  }
  double normOf(const AlignedVector<double>& values, std::size_t e) const {
    const Eigen::Index size = 9 * elements_[e].nodes * elements_[e].nodes;
    return Eigen::Map<const Eigen::VectorXd>(values.data() + elements_[e].begin, size).norm();
  }

  /// What all P_e must sum up to: sigma I - A, with A from the very numbers of the elements, minusA, less what discrete
  /// forces take of it.
  void setTarget(AlignedVector<double>& minusA, const NodalBound& weights) {
    const std::int64_t blocks = pattern_.column.size();
    target_.resize(blocks);
    alone_ = 0;
    for (std::int32_t i = 0; i < source_.nodeCount(); ++i)
      for (std::int64_t k = pattern_.rowBegin[i]; k < pattern_.rowBegin[static_cast<std::size_t>(i) + 1]; ++k) {
        const bool diagonal = pattern_.column[k] == i;
        target_[k] = (diagonal ? sigma_ : 0.0) * Eigen::Matrix3d::Identity() + sumOf(minusA, k);
        if (!diagonal) continue;
        const Eigen::Matrix3d discrete = freePart(source_, i, majorantAt(i, weights) / source_.lumpedMass()[i]);
        target_[k] -= discrete;
        // No P_e takes what discrete forces have at a node without elements.
        if (placesOf(k).empty()) alone_ = std::max(alone_, highestEigenvalue(discrete) * (1 + statedRounding));
      }
  }
  Eigen::Matrix3d majorantAt(std::int32_t node, const NodalBound& weights) const {
    if (!majorants_) return weights.majorantAt(node);
    const std::int32_t place = source_.discreteForces()->placeOf(node);
    return place < 0 ? Eigen::Matrix3d(Eigen::Matrix3d::Zero()) : (*majorants_)[place];
  }

  /// Which elements hold a part of each block of the assembled matrix.
  void indexBlocks() {
    placeBegin_.assign(pattern_.column.size() + 1, 0);
    const auto forEachPlace = [&](const auto& visit) {
      for (const Element& element : elements_) {
        const auto& positions = pattern_.elementBlocks[element.ref.block];
        const int n = element.nodes;
        for (int a = 0; a < n; ++a)
          for (int b = 0; b < n; ++b)
            visit(positions[(static_cast<std::size_t>(element.ref.element) * static_cast<std::size_t>(n) +
                             static_cast<std::size_t>(a)) *
                                static_cast<std::size_t>(n) +
                            static_cast<std::size_t>(b)],
                  placeOf(element, a, b));
      }
    };
    forEachPlace([&](std::size_t k, const Place&) { ++placeBegin_[k + 1]; });
    for (std::size_t k = 1; k < placeBegin_.size(); ++k) placeBegin_[k] += placeBegin_[k - 1];
    places_.resize(placeBegin_.back());
    std::vector<std::int64_t> next(placeBegin_.begin(), placeBegin_.end() - 1);
    forEachPlace([&](std::size_t k, const Place& place) { places_[next[k]++] = place; });
  }
  std::span<const Place> placesOf(std::int64_t k) const {
    const std::int64_t begin = placeBegin_[k];
    return {places_.data() + begin, static_cast<std::size_t>(placeBegin_[static_cast<std::size_t>(k) + 1] - begin)};
  }
  Eigen::Matrix3d sumOf(AlignedVector<double>& values, std::int64_t k) const {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const Place& place : placesOf(k)) sum += at(values, place);
    return sum;
  }
  Eigen::Matrix3d sumOf(std::int64_t k) { return sumOf(P_, k); }

  /// P_e += l_e D_e, the nodal bound's own split.
  void startFrom(const NodalBound& weights) {
    for (std::int32_t node = 0; node < source_.nodeCount(); ++node)
      for (const NodalBound::Incidence incidence : weights.incidences(node)) {
        const ElementRef ref = weights.elementAt(incidence);
        const Element& element = elements_[firstOfGroup_[ref.block] + static_cast<std::size_t>(ref.element)];
        const int a = incidence.place / lanes % element.nodes;
        at(P_, placeOf(element, a, a)) += weights.value(ref) / source_.lumpedMass()[node] * weights.weight(incidence);
      }
  }

  /// P_e += G_e.
  void startFrom(const ExchangeShares& shares) {
    const std::int32_t* entry = shares.entries.data();
    const double unit = shares.unitOfEntries();
    for (const Element& element : elements_) {
      const int size = 3 * element.nodes;
      double* P = P_.data() + element.begin;
      for (int i = 0; i < size; ++i)
        for (int j = 0; j <= i; ++j) {
          const double value = unit * *entry++;
          P[i * size + j] += value;
          if (j < i) P[j * size + i] += value;
        }
    }
  }

  /// Spreads what is missing from the sum evenly, then goes on in the direction of the last step by beta.
  void spread(double beta) {
    const std::int64_t blocks = pattern_.column.size();
    missing_.resize(blocks);
    parallelFor(
        0, blocks, source_.threads(),
        [&](std::int64_t k) { missing_[k] = (target_[k] - sumOf(k)) / static_cast<double>(placesOf(k).size()); }, 256);
    parallelFor(
        0, elements_.size(), source_.threads(),
        [&](std::int64_t index) {
          const std::size_t e = index;
          const Element& element = elements_[e];
          const int n = element.nodes, size = 3 * n;
          const std::int32_t* positions = pattern_.elementBlocks[element.ref.block].data() +
                                          static_cast<std::ptrdiff_t>(element.ref.element) * n * n;
          double moved = 0, norm = 0;
          for (int a = 0; a < n; ++a)
            for (int b = 0; b < n; ++b) {
              const Eigen::Matrix3d& add = missing_[positions[a * n + b]];
              for (int j = 0; j < 3; ++j)
                for (int i = 0; i < 3; ++i) {
                  const std::size_t entry = element.begin + (3 * b + j) * size + 3 * a + i;
                  const double was = P_[entry], now = was + add(i, j);
                  double value = now;
                  if (beta > 0) value += beta * (now - before_[entry]);
                  if (!before_.empty()) before_[entry] = now;
                  P_[entry] = value;
                  moved += (value - was) * (value - was);
                  norm += value * value;
                }
            }
          moved_[e] = std::sqrt(moved);
          reserve_[e] -= moved_[e];
          norms_[e] = std::max(norms_[e], std::sqrt(norm));
        },
        64);
  }

  const TangentSource& source_;
  ExchangeRoom room_;
  const std::vector<Eigen::Matrix3d>* majorants_;  // of discrete forces, by place; nullptr: the weights'
  double sigma_;
  double alone_ = 0;  // the bound of the nodes without elements, rad²/s²
  BlockMatrix pattern_;
  std::vector<Element> elements_;
  std::vector<std::size_t> firstOfGroup_;  // into elements_
  AlignedVector<double> P_, before_;       // of all elements, column by column
  std::vector<Eigen::Matrix3d> target_, missing_;
  std::vector<std::int64_t> placeBegin_;
  std::vector<Place> places_;
  std::vector<double> reserve_;  // a lower bound of lambda_min(P_e)
  std::vector<double> moved_;    // by the last spread, in P_e's norm
  std::vector<double> excess_, negative_;
  std::vector<double> norms_;            // the largest so far
  std::vector<double> tangentRounding_;  // of A_e, in its norm
  std::int64_t decompositions_ = 0;
  double momentum_ = 1, lastSum_ = infinity;
};

}  // namespace

KeptExchangeBound::KeptExchangeBound(const TangentSource& source) : source_(source) {}
KeptExchangeBound::~KeptExchangeBound() = default;

ExchangeBound KeptExchangeBound::evaluate(NodeVectorsView x, const NodalBound& weights, double sigma, double accept,
                                          int maxIterations) {
  auto* kept = static_cast<Composition*>(split_.get());
  if (kept == nullptr || version_ != source_.version()) {
    version_ = source_.version();
    split_ = std::make_unique<Composition>(source_, x, weights, sigma);
    kept = static_cast<Composition*>(split_.get());
  } else {
    kept->moveTo(x, weights, sigma);
  }
  const ExchangeBound result = kept->lowerUntil(accept, maxIterations);
  if (!std::isfinite(result.upper.value)) split_.reset();
  return result;
}

ExchangeBound exchangeUpperBound(const TangentSource& source, NodeVectorsView x, const NodalBound& weights,
                                 double sigma, double accept, int maxIterations) {
  Composition splitting(source, x, weights, sigma);
  return splitting.lowerUntil(accept, maxIterations);
}

ExchangeBound exchangeUpperBound(const TangentSource& source, NodeVectorsView x, const NodalBound& weights,
                                 LowerBound lower) {
  using Policy = ExchangePolicy;
  return exchangeUpperBound(source, x, weights, Policy::aim * lower.value, Policy::narrow * lower.value,
                            Policy::iterations);
}

ExchangeShares exchangeShares(const TangentSource& source, NodeVectorsView x, const NodalBound& weights,
                              LowerBound lower) {
  using Policy = ExchangePolicy;
  Composition splitting(source, x, weights, Policy::aim * lower.value);
  if (!std::isfinite(splitting.lowerUntil(Policy::narrow * lower.value, Policy::iterations).upper.value))
    return {ExchangeShares::wide, {infinity}, 0, {}};
  return splitting.shares(x, ExchangeShares::wide);
}

ExchangeShares roomyExchangeShares(const TangentSource& source, NodeVectorsView x, const NodalBound& weights,
                                   const ExchangeShares* from, const ExchangeRoom& room,
                                   const std::vector<Eigen::Matrix3d>* majorants, double sigma, double accept,
                                   int mostIterations, ExchangeWork& work) {
  Composition splitting(source, x, weights, sigma, room, from, majorants);
  const ExchangeBound bound = splitting.lowerUntil(accept, mostIterations);
  work = {bound.iterations, bound.decompositions};
  if (!std::isfinite(bound.upper.value)) return {ExchangeShares::narrow, {infinity}, 0, {}};
  return splitting.shares(x, ExchangeShares::narrow);
}

std::int64_t exchangeBoundBytes(const TangentSource& source) {
  std::int64_t bytes = 0;
  for (const ElementTangents* block : source.tangents()) {
    const std::int64_t n = block->nodesPerElement();
    bytes += block->elementCount() * n * n * (18 * 8 + 16 + 4);  // two matrices, places, positions
  }
  return bytes;
}

}  // namespace ringwatch

#include <ringwatch/monitor/bounds/exchange_bound.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/rounding.h>
#include <ringwatch/monitor/bounds/scaled_tangent.h>
#include <ringwatch/monitor/small/packed_jacobi.h>

namespace ringwatch {
namespace {

using Pack = NativePack;

// Steps need no more digits than that; the bound counts the error in full.
constexpr double decompositionTolerance = 1e-6;
constexpr int decompositionSweeps = 12;

NegativePart<Pack> removeNegativePart(Pack* A, Pack* VT, Pack* P, int n) {
  switch (n) {
    case 12:
      return removeNegativePart<12>(A, VT, P, n, decompositionTolerance, decompositionSweeps);
    case 24:
      return removeNegativePart<24>(A, VT, P, n, decompositionTolerance, decompositionSweeps);
    default:
      return removeNegativePart<0>(A, VT, P, n, decompositionTolerance, decompositionSweeps);
  }
}

class Composition final : public detail::ExchangeSplit {
 public:
  Composition(const TangentSource& source, NodeVectorsView x, const NodalBound& weights, double sigma)
      : source_(source), sigma_(sigma) {
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
    startFrom(weights);
    reserve_.assign(elements_.size(), -1.0);
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
    // Elements whose least eigenvalue may be below zero, in packs of one size.
    struct Group {
      std::size_t element[lanes];
      int count;
    };
    std::vector<Group> groups;
    int open = -1;
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      excess_[e] = exchangeRounding * norms_[e] + tangentRounding_[e];
      negative_[e] = 0;
      if (reserve_[e] > 0) continue;
      if (open < 0 || groups.back().count == lanes || open != elements_[e].nodes) {
        groups.push_back({{}, 0});
        open = elements_[e].nodes;
      }
      groups.back().element[groups.back().count++] = e;
      ++decompositions_;
    }
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
    return std::isfinite(sum) ? sigma_ + most : infinity;
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
  ExchangeShares shares(NodeVectorsView x) {
    fillTangents(x, before_);
    ExchangeShares result{{infinity}, 0, {}};
    const double largest = makePositive();
    if (!std::isfinite(largest) || !(largest > 0)) return result;
    // Twice what the largest number needs, so that none overflows when it takes what others have.
    result.unit = std::exp2(1 + std::ceil(std::log2(largest)));
    makeWhole(result.unit);
    // What a node's elements have of its own block.
    double highest = 0;
    for (std::int32_t i = 0; i < source_.nodeCount(); ++i)
      for (std::int64_t k = pattern_.rowBegin[i]; k < pattern_.rowBegin[static_cast<std::size_t>(i) + 1]; ++k)
        if (pattern_.column[k] == i) highest = std::max(highest, highestEigenvalue(sumOf(k)));
    result.upper.value = std::ldexp(highest, -ExchangeShares::shareBits) * result.unit * (1 + statedRounding);
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
  void removeNegativeParts(const std::size_t* elements, int count) {
    const int size = 3 * elements_[elements[0]].nodes;
    const std::size_t entries = size * size;
    thread_local AlignedVector<Pack> work;
    work.resize(3 * entries);
    Pack *P = work.data(), *A = P + entries, *VT = A + entries;
    for (int lane = 0; lane < lanes; ++lane) {  // empty lanes repeat the first element
      const double* from = P_.data() + elements_[elements[lane < count ? lane : 0]].begin;
      for (std::size_t i = 0; i < entries; ++i) P[i].set(lane, from[i]);
    }
    std::copy_n(P, entries, A);
    const NegativePart<Pack> part = removeNegativePart(A, VT, P, size);
    for (int lane = 0; lane < count; ++lane) {
      const std::size_t e = elements[lane];
      // A NaN must not pass for zero.
      excess_[e] += part.least[lane] >= 0 ? 0.0 : -part.least[lane];
      negative_[e] = part.square[lane];
      reserve_[e] = std::max(-part.error[lane], part.least[lane]);
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

  /// -A_e, constrained components zero.
  void fillTangents(NodeVectorsView x, AlignedVector<double>& to) {
    tangentRounding_.resize(elements_.size());
    source_.forEachTangentBatch(x, [&](std::size_t b, std::int32_t batch, NativePack* K, const NativePack* T) {
      const ElementTangents& block = *source_.tangents()[b];
      const int n = block.nodesPerElement(), size = 3 * n;
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
  /// P_e := A_e + P_e + eps_e I, which is at least A_e, of free components. before_: -A_e. Returns the size of its
  /// largest number.
  double makePositive() {
    std::vector<double> most(elements_.size());
    parallelFor(
        0, elements_.size(), source_.threads(),
        [&](std::int64_t index) {
          const std::size_t e = index;
          const int size = 3 * elements_[e].nodes;
          Eigen::Map<Eigen::MatrixXd> P(P_.data() + elements_[e].begin, size, size);
          const Eigen::Map<const Eigen::MatrixXd> minusA(before_.data() + elements_[e].begin, size, size);
          P = (0.5 * (P + P.transpose())).eval();
          const double norm = std::max(P.norm(), minusA.norm());
          const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(P, Eigen::EigenvaluesOnly);
          P -= minusA;
          P.diagonal().array() +=
              std::max(0.0, -solver.eigenvalues()[0]) + exchangeRounding * norm + tangentRounding_[e];
          for (int i = 0; i < size; ++i)
            if (freeFactor(source_, nodesOf(e)[i / 3], i % 3) == 0) {
              P.row(i).setZero();
              P.col(i).setZero();
            }
          // A NaN must not be lost.
          most[e] = std::isfinite(P.sum()) ? P.cwiseAbs().maxCoeff() : infinity;
        },
        16);
    return most.empty() ? 0.0 : *std::max_element(most.begin(), most.end());
  }
  /// Rounds to whole numbers of unit / 2^shareBits. A number moves by a half, and one of a pair of nodes takes what all
  /// others of that pair have moved by: a shift makes up for it.
  void makeWhole(double unit) {
    const double scale = std::ldexp(1 / unit, ExchangeShares::shareBits);
    std::int64_t mostPlaces = 1;
    for (std::size_t k = 0; k + 1 < placeBegin_.size(); ++k)
      mostPlaces = std::max(mostPlaces, placeBegin_[k + 1] - placeBegin_[k]);
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      const int size = 3 * elements_[e].nodes;
      for (int i = 0; i < size; ++i)
        for (int j = 0; j < size; ++j) {
          double& value = P_[elements_[e].begin + i * size + j];
          const bool shifts = i == j && freeFactor(source_, nodesOf(e)[i / 3], i % 3) != 0;
          value = std::nearbyint(value * scale + (shifts ? 0.5 * size * static_cast<double>(mostPlaces) : 0));
        }
    }
    for (std::int32_t i = 0; i < source_.nodeCount(); ++i)
      for (std::int64_t k = pattern_.rowBegin[i]; k < pattern_.rowBegin[static_cast<std::size_t>(i) + 1]; ++k)
        if (pattern_.column[k] != i && !placesOf(k).empty()) at(P_, placesOf(k).back()) -= sumOf(k);
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
    for (std::int32_t i = 0; i < source_.nodeCount(); ++i)
      for (std::int64_t k = pattern_.rowBegin[i]; k < pattern_.rowBegin[static_cast<std::size_t>(i) + 1]; ++k) {
        const bool diagonal = pattern_.column[k] == i;
        target_[k] = (diagonal ? sigma_ : 0.0) * Eigen::Matrix3d::Identity() + sumOf(minusA, k);
        if (diagonal) target_[k] -= freePart(source_, i, weights.majorantAt(i) / source_.lumpedMass()[i]);
      }
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
          reserve_[e] -= std::sqrt(moved);
          norms_[e] = std::max(norms_[e], std::sqrt(norm));
        },
        64);
  }

  const TangentSource& source_;
  double sigma_;
  BlockMatrix pattern_;
  std::vector<Element> elements_;
  std::vector<std::size_t> firstOfGroup_;  // into elements_
  AlignedVector<double> P_, before_;       // of all elements, column by column
  std::vector<Eigen::Matrix3d> target_, missing_;
  std::vector<std::int64_t> placeBegin_;
  std::vector<Place> places_;
  std::vector<double> reserve_;  // a lower bound of lambda_min(P_e)
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
    return {{infinity}, 0, {}};
  return splitting.shares(x);
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

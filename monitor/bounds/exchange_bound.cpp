#include <ringwatch/monitor/bounds/exchange_bound.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <utility>
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
/// What iterations work with: nothing is proven with it.
using SinglePack = ringwatch::Pack<float, 2 * lanes>;

template <class P>
LowestPart<P> removeLowestPart(P* A, P* matrix, int n, const P& enough, const P& step) {
  switch (n) {
    case 12:
      return removeLowestPart<12>(A, matrix, n, enough, step);
    case 15:
      return removeLowestPart<15>(A, matrix, n, enough, step);
    case 18:
      return removeLowestPart<18>(A, matrix, n, enough, step);
    case 24:
      return removeLowestPart<24>(A, matrix, n, enough, step);
    default:
      return removeLowestPart<0>(A, matrix, n, enough, step);
  }
}

/// A matrix is shifted by this of the certified eigenvalue, times powers of two, until it is definite; then by halving.
constexpr double leastShift = 0x1p-14;
constexpr int mostDoublings = 20, halvings = 3;
/// Of matrices in single precision, relative to their norm.
constexpr double singleRounding = 1e-6;

/// The matrix of an element of n nodes is kept as the blocks of its pairs of nodes a <= b, nine numbers each, row by
/// row: which one.
constexpr int pairOf(int n, int a, int b) { return a * n - a * (a - 1) / 2 + b - a; }
constexpr int pairsOf(int n) { return pairOf(n, n, n); }

class Composition final : public detail::ExchangeSplit {
 public:
  /// shares: goes on from these, of another state; nullptr: from the weights' own split.
  Composition(const TangentSource& source, NodeVectorsView x, const NodalBound& weights, double sigma,
              const ExchangeRoom& room = {}, const ExchangeShares* shares = nullptr,
              const std::vector<Eigen::Matrix3d>* majorants = nullptr)
      : source_(source), room_(room), majorants_(majorants) {
    std::int64_t total = 0;
    for (std::size_t b = 0; b < source.tangents().size(); ++b) {
      const int n = source.tangents()[b]->nodesPerElement();
      firstOfGroup_.push_back(elements_.size());
      for (std::int32_t e = 0; e < source.tangents()[b]->elementCount(); ++e) {
        elements_.push_back({{b, e}, n, total});
        total += 9 * pairsOf(n);
      }
    }
    indexPairs(x);
    {
      AlignedVector<double> P(static_cast<std::size_t>(total));
      fillTangents(x, P);
      setTarget(P, weights, sigma);
      if (shares)
        addShares(*shares, P);
      else
        addWeights(weights, P);
      P_.assign(P.begin(), P.end());
    }
    moved_.assign(elements_.size(), 0.0F);
    excess_.assign(elements_.size(), 0.0F);
    negative_.assign(elements_.size(), 0.0F);
    reserve_.resize(elements_.size());
    spread(0);
    before_ = P_;
    for (std::size_t e = 0; e < elements_.size(); ++e) reserve_[e] = -norms_[e];
  }

  /// Goes on with the present P_e at another state and sigma: what is then missing from the sum is spread.
  void moveTo(NodeVectorsView x, const NodalBound& weights, double sigma) {
    {
      AlignedVector<double> minusA(P_.size());
      const double unit = unit_;
      fillTangents(x, minusA);
      for (float& value : P_) value *= static_cast<float>(unit / unit_);
      for (float& value : reserve_) value *= static_cast<float>(unit / unit_);
      setTarget(minusA, weights, sigma);
    }
    spread(0);
    before_ = P_;
    momentum_ = 1;
    lastSum_ = infinity;
    decompositions_ = 0;
  }

  /// Until the bound is at or below `accept`. It is proven where that can be, and at the end.
  ExchangeBound lowerUntil(double accept, int maxIterations) {
    ExchangeBound result{{infinity}, 0, 0};
    while (result.iterations < maxIterations && !(result.upper.value <= accept)) {
      const double estimate = iterate();
      ++result.iterations;
      if (!std::isfinite(estimate)) {
        result.upper.value = infinity;
        break;
      }
      if (estimate <= accept || result.iterations == maxIterations)
        result.upper.value = std::min(result.upper.value, provenBound());
    }
    result.decompositions = decompositions_;
    return result;
  }

  /// The present iterate in whole numbers; no iteration can follow.
  ExchangeShares shares(NodeVectorsView x, int bits) {
    AlignedVector<double> P(P_.size()), minusA(P_.size());
    fillTangents(x, minusA);
    const AlignedVector<double> missing = findMissing();
    for (std::size_t e = 0; e < elements_.size(); ++e) complete(e, missing, P.data() + elements_[e].begin);
    ExchangeShares result{bits, {infinity}, 0, {}};
    const double largest = makePositive(P, minusA);
    if (!std::isfinite(largest) || !(largest > 0)) return result;
    // Room for what a number takes of others, and for its row's margin, so that none overflows.
    result.unit =
        unit_ * (bits == ExchangeShares::wide ? std::exp2(1 + std::ceil(std::log2(largest))) : 1.02 * largest);
    makeWhole(P, result.unitOfEntries() / unit_);
    // What a node's elements have of its own block.
    double highest = 0;
    for (const std::int32_t k : diagonalOf_)
      if (k >= 0) highest = std::max(highest, highestEigenvalue(sumOf(P, k)));
    result.upper.value = highest * result.unitOfEntries() * (1 + statedRounding);
    for (const Element& element : elements_)
      forEachLower(element, [&](std::int64_t at) { result.entries.push_back(static_cast<std::int32_t>(P[at])); });
    return result;
  }

 private:
  struct Element {
    ElementRef ref;
    int nodes;
    std::int64_t begin;  // of its matrix in P_
  };
  /// The block of a pair of nodes in an element's matrix: first entry, and whether the pair is the other way round.
  struct Place {
    std::int64_t first : 63;
    std::uint64_t turned : 1;
  };
  /// Elements of one size, as many as a pack has lanes or fewer: which of `chosen_`.
  struct Group {
    std::size_t begin;
    int count;
    int nodes;
  };
  /// Puts the elements that are chosen into groups of at most `most`.
  template <class Choose>
  void group(int most, const Choose& choose) {
    chosen_.clear();
    groups_.clear();
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      if (!choose(e)) continue;
      if (groups_.empty() || groups_.back().count == most || groups_.back().nodes != elements_[e].nodes)
        groups_.push_back({chosen_.size(), 0, elements_[e].nodes});
      chosen_.push_back(e);
      ++groups_.back().count;
    }
  }
  /// The element of a lane; empty lanes repeat the first one.
  std::size_t elementOf(const Group& group, int lane) const {
    return chosen_[group.begin + static_cast<std::size_t>(lane < group.count ? lane : 0)];
  }
  template <class Visit>
  void forEachGroup(const Visit& visit) const {
    parallelFor(
        0, groups_.size(), source_.threads(), [&](std::int64_t g) { visit(groups_[static_cast<std::size_t>(g)]); }, 4);
  }

  /// Returns the bound of the iterate that it begins with, rad²/s², as far as single precision tells.
  double iterate() {
    group(SinglePack::width, [&](std::size_t e) {
      excess_[e] = negative_[e] = 0;
      return !(reserve_[e] > 0);
    });
    decompositions_ += static_cast<std::int64_t>(chosen_.size());
    forEachGroup([&](const Group& group) { removeNegativeParts(group); });
    double sum = 0;
    for (const float negative : negative_) sum += negative;
    // Nesterov's sequence, from the start again when the last step was uphill.
    if (sum > lastSum_) momentum_ = 1;
    lastSum_ = sum;
    const double next = 0.5 * (1 + std::sqrt(1 + 4 * momentum_ * momentum_)), beta = (momentum_ - 1) / next;
    momentum_ = next;
    const double bound = boundOf(excess_);
    spread(static_cast<float>(beta));
    return std::isfinite(sum) ? bound : infinity;
  }
  /// sigma and what the elements of a node exceed it by, at most; infinite where that is not finite.
  template <class Number>
  double boundOf(const std::vector<Number>& excess) const {
    std::vector<double> nodal(source_.nodeCount(), 0.0);
    for (std::size_t e = 0; e < elements_.size(); ++e)
      for (const std::int32_t node : nodesOf(e)) nodal[node] += excess[e];
    double most = 0;
    for (const double value : nodal) {
      if (!std::isfinite(value)) return infinity;
      most = std::max(most, value);
    }
    return std::max(unit_ * (sigma_ + most), alone_);
  }
  void removeNegativeParts(const Group& group) {
    const int n = group.nodes, size = 3 * n;
    const std::size_t entries = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
    thread_local AlignedVector<SinglePack> work;
    work.resize(2 * entries);
    SinglePack *P = work.data(), *A = P + entries, enough, step;
    for (int lane = 0; lane < SinglePack::width; ++lane) {
      const std::size_t e = elementOf(group, lane);
      loadLane(P_.data() + elements_[e].begin, n, lane, P);
      const auto margin = static_cast<float>(singleRounding) * norms_[e];
      enough.set(lane, -reserve_[e] + margin);
      step.set(lane, moved_[e] + margin);
    }
    for (int i = 0; i < size; ++i)
      for (int j = 0; j < i; ++j) P[j * size + i] = P[i * size + j];
    const LowestPart<SinglePack> part = removeLowestPart(A, P, size, enough, step);
    for (int lane = 0; lane < group.count; ++lane) {
      const std::size_t e = elementOf(group, lane);
      // Of what is not a number the norm is none.
      const float least = part.least[lane] > -std::numeric_limits<float>::infinity() ? part.least[lane] : -norms_[e];
      excess_[e] = least >= 0 ? 0.0F : -least;
      negative_[e] = part.square[lane];
      reserve_[e] = least;
      if (!(part.square[lane] > 0)) continue;
      float* to = P_.data() + elements_[e].begin;
      forEachEntry(n, [&](int i, int j) { *to++ = P[j * size + i][lane]; });
    }
  }

  /// The bound of the present iterate, rad²/s²: Theorem 12, with a factorisation of every matrix in double precision.
  double provenBound() {
    const AlignedVector<double> missing = findMissing();
    std::vector<double> excess(elements_.size());
    group(lanes, [](std::size_t) { return true; });
    forEachGroup([&](const Group& group) {
      const int n = group.nodes, size = 3 * n;
      thread_local AlignedVector<Pack> P, A;
      thread_local AlignedVector<double> own;
      for (auto* matrices : {&P, &A}) matrices->resize(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
      own.resize(9 * static_cast<std::size_t>(pairsOf(n)));
      Pack rounding, from;
      for (int lane = 0; lane < lanes; ++lane) {
        const std::size_t e = elementOf(group, lane);
        complete(e, missing, own.data());
        loadLane(own.data(), n, lane, P.data());
        rounding.set(lane, roundingOf(e, normOf(own.data(), n)));
        from.set(lane, std::max(static_cast<double>(excess_[e]), leastShift * sigma_));
      }
      const Pack shift = definiteShift(from, [&](const Pack& by) { return isDefinite(P, by - rounding, size, A); });
      for (int lane = 0; lane < group.count; ++lane) excess[elementOf(group, lane)] = shift[lane];
    });
    return boundOf(excess);
  }
  /// Whether matrices, of which the lower triangles are given, are definite with a shift: 1 where they are, else 0. A:
  /// of their size, used up.
  static Pack isDefinite(const AlignedVector<Pack>& P, const Pack& shift, int size, AlignedVector<Pack>& A) {
    for (int i = 0; i < size; ++i) {
      for (int j = 0; j < i; ++j) A[i * size + j] = P[i * size + j];
      A[i * size + i] = P[i * size + i] + shift;
    }
    return pivotsArePositive(A.data(), size);
  }
  /// What makes symmetric matrices definite, one a lane, when it is added to their diagonals: nothing, or what is found
  /// by doubling and halving from `from`; infinite where that is not found. definite: 1 in lanes where a shift is
  /// enough, else 0.
  template <class Definite>
  static Pack definiteShift(const Pack& from, const Definite& definite) {
    Pack low(0.0), high(0.0);
    Pack::Mask done = definite(high) > Pack(0.0);
    for (int k = 0; k < mostDoublings && !allOf(done); ++k) {
      const Pack next = Pack(std::ldexp(1.0, k)) * from;
      low = select(done, low, high);
      high = select(done, high, next);
      done = definite(high) > Pack(0.0);
    }
    for (int k = 0; k < halvings; ++k) {
      const Pack middle = Pack(0.5) * (low + high);
      const Pack::Mask enough = definite(middle) > Pack(0.0);
      high = select(enough, middle, high);
      low = select(enough, low, middle);
    }
    return select(done, high, Pack(infinity));
  }
  double roundingOf(std::size_t e, double norm) const {
    return exchangeRounding * std::max({norm, static_cast<double>(norms_[e]), tangentNorms_[e]}) + tangentRounding_[e];
  }

  std::span<const std::int32_t> nodesOf(std::size_t e) const {
    return source_.tangents()[elements_[e].ref.block]->nodesOf(elements_[e].ref.element);
  }
  /// Frobenius' norm of the matrix of an element of n nodes.
  template <class Number>
  static double normOf(const Number* entry, int n) {
    double square = 0;
    for (int a = 0; a < n; ++a)
      for (int b = a; b < n; ++b)
        for (int i = 0; i < 9; ++i, ++entry)
          square += (a == b ? 1.0 : 2.0) * static_cast<double>(*entry) * static_cast<double>(*entry);
    return std::sqrt(square);
  }
  /// Calls visit(row, column) for every entry in the order in which they are kept.
  template <class Visit>
  static void forEachEntry(int n, Visit&& visit) {
    for (int a = 0; a < n; ++a)
      for (int b = a; b < n; ++b)
        for (int r = 0; r < 3; ++r)
          for (int c = 0; c < 3; ++c) visit(3 * a + r, 3 * b + c);
  }
  /// The lower triangle of a matrix as a lane of packs, row by row.
  template <class Number, class Packs>
  static void loadLane(const Number* entry, int n, int lane, Packs* to) {
    forEachEntry(n, [&](int i, int j) { to[j * 3 * n + i].set(lane, *entry++); });
  }

  /// -A_e over the unit, which follows from them, with their room, constrained components zero.
  void fillTangents(NodeVectorsView x, AlignedVector<double>& to) {
    tangentRounding_.assign(elements_.size(), 0.0);
    tangentNorms_.resize(elements_.size());
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
        for (int i = 0; i < size; ++i)
          scale[i] = freeFactor(source_, nodes[i / 3], i % 3) / std::sqrt(source_.lumpedMass()[nodes[i / 3]]);
        const std::size_t element = firstOfGroup_[b] + static_cast<std::size_t>(e);
        // |Σ_ab ΔA_ab v_a v_b| <= Σ_a T_a/m_a for a unit vector.
        for (int a = 0; a < n; ++a) tangentRounding_[element] += T[a][lane] / source_.lumpedMass()[nodes[a]];
        double* P = to.data() + elements_[element].begin;
        forEachEntry(n, [&, entry = P](int i, int j) mutable {
          *entry++ = -K[std::max(i, j) * size + std::min(i, j)][lane] * scale[i] * scale[j];
        });
        tangentNorms_[element] = normOf(P, n);
      }
    });
    double highest = 0;
    for (const double norm : tangentNorms_) highest = std::max(highest, norm < infinity ? norm : 0.0);
    // A power of two, so that numbers in single precision neither end nor err by it.
    unit_ = highest > 0 ? std::exp2(std::floor(std::log2(highest))) : 1.0;
    for (auto* numbers : {&tangentRounding_, &tangentNorms_})
      for (double& number : *numbers) number /= unit_;
    for (double& entry : to) entry /= unit_;
  }
  /// P_e := A_e + P_e + eps_e I, of free components, which is at least A_e and at least 0. Returns the size of its
  /// largest number.
  double makePositive(AlignedVector<double>& P, const AlignedVector<double>& minusA) {
    std::vector<double> most(elements_.size());
    group(lanes, [](std::size_t) { return true; });
    forEachGroup([&](const Group& group) {
      const int n = group.nodes, size = 3 * n;
      thread_local AlignedVector<Pack> own, with, A;
      for (auto* matrices : {&own, &with, &A})
        matrices->resize(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
      Pack rounding;
      for (int lane = 0; lane < lanes; ++lane) {
        const std::size_t e = elementOf(group, lane);
        loadLane(P.data() + elements_[e].begin, n, lane, own.data());
        loadLane(minusA.data() + elements_[e].begin, n, lane, with.data());
        rounding.set(lane, roundingOf(e, normOf(P.data() + elements_[e].begin, n)));
      }
      for (std::size_t i = 0; i < own.size(); ++i) with[i] = own[i] - with[i];
      const Pack shift = definiteShift(Pack(leastShift * sigma_), [&](const Pack& by) {
        const Pack first = isDefinite(own, by - rounding, size, A);
        return first * isDefinite(with, by - rounding, size, A);
      });
      for (int lane = 0; lane < group.count; ++lane) {
        const std::size_t e = elementOf(group, lane);
        const auto nodes = nodesOf(e);
        most[e] = 0;
        forEachEntry(n, [&, entry = P.data() + elements_[e].begin](int i, int j) mutable {
          const bool free = freeFactor(source_, nodes[i / 3], i % 3) * freeFactor(source_, nodes[j / 3], j % 3) != 0;
          const double value = with[std::max(i, j) * size + std::min(i, j)][lane] + (i == j ? shift[lane] : 0.0);
          *entry = free ? value : 0.0;
          // A NaN must not be lost, nor one that no shift made definite.
          most[e] = std::isfinite(value) && std::isfinite(shift[lane]) ? std::max(most[e], std::abs(*entry)) : infinity;
          ++entry;
        });
      }
    });
    return most.empty() ? 0.0 : *std::max_element(most.begin(), most.end());
  }
  /// Rounds to whole multiples of a unit. What the numbers of one pair of nodes lose goes to the next one, so that they
  /// still add up to zero; the sizes of what a row has moved by, added to its diagonal, make up for it.
  void makeWhole(AlignedVector<double>& P, double unit) const {
    for (double& value : P) value /= unit;
    const AlignedVector<double> exact = P;
    for (std::int64_t k = 0; k < pairCount(); ++k) {
      const bool pair = target_[k].pair;
      Eigen::Matrix3d left = Eigen::Matrix3d::Zero();
      for (const Place& place : placesOf(k)) {
        const Eigen::Matrix3d block = blockAt(P, place);
        if (pair) left += block;
        const Eigen::Matrix3d whole =
            (pair ? left : block).unaryExpr([](double value) { return std::nearbyint(value); });
        if (pair) left -= whole;
        setBlock(P, place, whole);
      }
      if (!pair) continue;
      const Eigen::Matrix3d last = blockAt(P, placesOf(k).back()) - sumOf(P, k);
      setBlock(P, placesOf(k).back(), last);
    }
    for (const Element& element : elements_) {
      const int n = element.nodes;
      double moved[3 * maxElementNodes] = {};
      std::int64_t at = element.begin;
      forEachEntry(n, [&](int i, int j) {
        const double off = std::abs(P[at] - exact[at]);
        moved[i] += off;
        if (i / 3 != j / 3) moved[j] += off;
        ++at;
      });
      at = element.begin;
      forEachEntry(n, [&](int i, int j) { P[at++] += i == j ? std::ceil(moved[i]) : 0.0; });
    }
  }
  static double highestEigenvalue(const Eigen::Matrix3d& S) {
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(S, Eigen::EigenvaluesOnly).eigenvalues()[2];
  }

  /// What all P_e must sum up to: sigma I - A, with A from the very numbers of the elements, minusA, less what discrete
  /// forces take of it.
  void setTarget(const AlignedVector<double>& minusA, const NodalBound& weights, double sigma) {
    sigma_ = sigma / unit_;
    for (std::int64_t k = 0; k < pairCount(); ++k) target_[k].sum = sumOf(minusA, k);
    alone_ = 0;
    for (std::int32_t i = 0; i < source_.nodeCount(); ++i) {
      const Eigen::Matrix3d discrete = freePart(source_, i, majorantAt(i, weights) / source_.lumpedMass()[i]);
      if (diagonalOf_[i] >= 0)
        target_[diagonalOf_[i]].sum += sigma_ * Eigen::Matrix3d::Identity() - discrete / unit_;
      else  // no P_e takes what discrete forces have at a node without elements
        alone_ = std::max(alone_, highestEigenvalue(discrete) * (1 + statedRounding));
    }
  }
  Eigen::Matrix3d majorantAt(std::int32_t node, const NodalBound& weights) const {
    if (!majorants_) return weights.majorantAt(node);
    const std::int32_t place = source_.discreteForces()->placeOf(node);
    return place < 0 ? Eigen::Matrix3d(Eigen::Matrix3d::Zero()) : (*majorants_)[place];
  }

  /// Which elements hold a part of each pair of nodes, in the order in which elements come to them.
  void indexPairs(NodeVectorsView x) {
    BlockMatrix pattern;
    source_.assembleBlocks(x, pattern);
    std::vector<std::int32_t> numbers(pattern.column.size(), -1);
    diagonalOf_.assign(source_.nodeCount(), -1);
    std::vector<std::int64_t> counts;
    for (const Element& element : elements_) {
      const int n = element.nodes;
      const auto nodes = source_.tangents()[element.ref.block]->nodesOf(element.ref.element);
      const std::int32_t* positions =
          pattern.elementBlocks[element.ref.block].data() + static_cast<std::ptrdiff_t>(element.ref.element) * n * n;
      for (int a = 0; a < n; ++a)
        for (int b = a; b < n; ++b) {
          const bool turned = nodes[a] > nodes[b];
          std::int32_t& number = numbers[turned ? positions[b * n + a] : positions[a * n + b]];
          if (number < 0) {
            number = static_cast<std::int32_t>(counts.size());
            counts.push_back(0);
            target_.push_back({{}, a != b});
            if (a == b) diagonalOf_[nodes[a]] = number;
          }
          ++counts[number];
          pairs_.push_back({number, turned});
        }
    }
    placeBegin_.assign(counts.size() + 1, 0);
    std::partial_sum(counts.begin(), counts.end(), placeBegin_.begin() + 1);
    places_.resize(pairs_.size());
    std::vector<std::int64_t> next(placeBegin_.begin(), placeBegin_.end() - 1);
    for (std::size_t p = 0; p < pairs_.size(); ++p)
      places_[next[pairs_[p].number]++] = {static_cast<std::int64_t>(9 * p), pairs_[p].turned};
  }
  std::int64_t pairCount() const { return static_cast<std::int64_t>(target_.size()); }
  std::span<const Place> placesOf(std::int64_t k) const {
    const std::int64_t begin = placeBegin_[k];
    return {places_.data() + begin, static_cast<std::size_t>(placeBegin_[k + 1] - begin)};
  }
  template <class Number>
  static Eigen::Matrix3d blockAt(const AlignedVector<Number>& values, const Place& place) {
    const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> block =
        Eigen::Map<const Eigen::Matrix<Number, 3, 3, Eigen::RowMajor>>(values.data() + place.first)
            .template cast<double>();
    return place.turned ? Eigen::Matrix3d(block.transpose()) : Eigen::Matrix3d(block);
  }
  static void setBlock(AlignedVector<double>& values, const Place& place, const Eigen::Matrix3d& block) {
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> to(values.data() + place.first);
    to = place.turned ? Eigen::Matrix3d(block.transpose()) : block;
  }
  template <class Number>
  Eigen::Matrix3d sumOf(const AlignedVector<Number>& values, std::int64_t k) const {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const Place& place : placesOf(k)) sum += blockAt(values, place);
    return sum;
  }

  /// P_e += l_e D_e, the nodal bound's own split.
  void addWeights(const NodalBound& weights, AlignedVector<double>& P) const {
    for (std::int32_t node = 0; node < source_.nodeCount(); ++node)
      for (const NodalBound::Incidence incidence : weights.incidences(node)) {
        const ElementRef ref = weights.elementAt(incidence);
        const Element& element = elements_[firstOfGroup_[ref.block] + static_cast<std::size_t>(ref.element)];
        const int a = incidence.place / lanes % element.nodes;
        const Place place{element.begin + 9 * pairOf(element.nodes, a, a), false};
        setBlock(
            P, place,
            blockAt(P, place) + weights.value(ref) / source_.lumpedMass()[node] / unit_ * weights.weight(incidence));
      }
  }

  /// P_e += G_e.
  void addShares(const ExchangeShares& shares, AlignedVector<double>& P) const {
    const std::int32_t* entry = shares.entries.data();
    const double unit = shares.unitOfEntries() / unit_;
    for (const Element& element : elements_) forEachLower(element, [&](std::int64_t at) { P[at] += unit * *entry++; });
    // Both entries of a node's own block.
    for (const Element& element : elements_)
      for (int a = 0; a < element.nodes; ++a)
        for (const auto& [lower, upper] : {std::pair{3, 1}, {6, 2}, {7, 5}}) {
          double* block = P.data() + element.begin + 9 * pairOf(element.nodes, a, a);
          block[lower] = block[upper];
        }
  }
  /// Calls visit(place) for the lower triangle of an element's matrix, row by row.
  template <class Visit>
  static void forEachLower(const Element& element, const Visit& visit) {
    for (int i = 0; i < 3 * element.nodes; ++i)
      for (int j = 0; j <= i; ++j) visit(element.begin + 9 * pairOf(element.nodes, j / 3, i / 3) + 3 * (j % 3) + i % 3);
  }

  /// What is missing from the sums, evenly for each element that has a part: nine numbers a pair, row by row.
  AlignedVector<double> findMissing() const {
    AlignedVector<double> missing(9 * target_.size());
    parallelFor(
        0, pairCount(), source_.threads(),
        [&](std::int64_t k) {
          Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(missing.data() + 9 * k) =
              (target_[k].sum - sumOf(P_, k)) / static_cast<double>(placesOf(k).size());
        },
        256);
    return missing;
  }
  /// P_e with what is missing.
  void complete(std::size_t e, const AlignedVector<double>& missing, double* to) const {
    const std::int64_t first = elements_[e].begin;
    for (std::int64_t p = 0; p < pairsOf(elements_[e].nodes); ++p) {
      const Pair& pair = pairs_[first / 9 + p];
      const double* add = missing.data() + 9 * static_cast<std::int64_t>(pair.number);
      for (int i = 0; i < 9; ++i) *to++ = P_[first + 9 * p + i] + add[pair.turned ? 3 * (i % 3) + i / 3 : i];
    }
  }

  /// Spreads what is missing from the sum evenly, then goes on in the direction of the last step by beta.
  void spread(float beta) {
    const AlignedVector<double> missing = findMissing();
    norms_.resize(elements_.size());
    parallelFor(
        0, elements_.size(), source_.threads(),
        [&](std::int64_t index) {
          const std::size_t e = index;
          const int n = elements_[e].nodes;
          const std::int64_t first = elements_[e].begin;
          float *P = P_.data() + first, *before = before_.empty() ? P : before_.data() + first;
          const Pair* pair = pairs_.data() + first / 9;
          float moved = 0, norm = 0;
          for (int a = 0; a < n; ++a)
            for (int b = a; b < n; ++b, ++pair, P += 9, before += 9) {
              const double* from = missing.data() + 9 * static_cast<std::int64_t>(pair->number);
              float add[9], movedHere = 0, normHere = 0;
              for (int i = 0; i < 9; ++i) add[i] = static_cast<float>(from[i]);
              if (pair->turned)
                for (const auto& [i, j] : {std::pair{1, 3}, {2, 6}, {5, 7}}) std::swap(add[i], add[j]);
              for (int i = 0; i < 9; ++i) {
                const float was = P[i], now = was + add[i], value = now + beta * (now - before[i]);
                before[i] = now;
                P[i] = value;
                movedHere += (value - was) * (value - was);
                normHere += value * value;
              }
              const float times = a == b ? 1.0F : 2.0F;
              moved += times * movedHere;
              norm += times * normHere;
            }
          moved_[e] = std::sqrt(moved);
          reserve_[e] -= moved_[e];
          norms_[e] = std::sqrt(norm);
        },
        64);
  }

  struct Pair {
    std::int32_t number : 31;
    std::uint32_t turned : 1;
  };
  struct Target {
    Eigen::Matrix3d sum;
    bool pair;  // of two nodes
  };
  const TangentSource& source_;
  ExchangeRoom room_;
  const std::vector<Eigen::Matrix3d>* majorants_;  // of discrete forces, by place; nullptr: the weights'
  double unit_ = 1;                                // of all matrices and sigma_, rad²/s²
  double sigma_ = 0;
  double alone_ = 0;  // the bound of the nodes without elements, rad²/s²
  std::vector<Element> elements_;
  std::vector<std::size_t> firstOfGroup_;  // into elements_
  AlignedVector<float> P_, before_;        // of all elements
  std::vector<Pair> pairs_;                // of all elements' pairs
  std::vector<Target> target_;             // by number of a pair
  std::vector<std::int32_t> diagonalOf_;   // the pair of a node with itself; -1: no element has it
  std::vector<std::int64_t> placeBegin_;
  std::vector<Place> places_;
  std::vector<std::size_t> chosen_;
  std::vector<Group> groups_;
  std::vector<float> reserve_;  // about a lower bound of lambda_min(P_e)
  std::vector<float> moved_;    // by the last spread, in P_e's norm
  std::vector<float> excess_, negative_, norms_;
  std::vector<double> tangentRounding_, tangentNorms_;  // of A_e
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
                                 LowerBound lower, double width) {
  using Policy = ExchangePolicy;
  return exchangeUpperBound(source, x, weights, Policy::aim(width) * lower.value, Policy::narrow(width) * lower.value,
                            Policy::iterations);
}

ExchangeShares exchangeShares(const TangentSource& source, NodeVectorsView x, const NodalBound& weights,
                              LowerBound lower) {
  using Policy = ExchangePolicy;
  Composition splitting(source, x, weights, Policy::aim(Policy::width) * lower.value);
  if (!std::isfinite(splitting.lowerUntil(Policy::narrow(Policy::width) * lower.value, Policy::iterations).upper.value))
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
  for (const ElementTangents* block : source.tangents())
    bytes += static_cast<std::int64_t>(block->elementCount()) * pairsOf(block->nodesPerElement()) *
             (9 * static_cast<std::int64_t>(sizeof(double) + sizeof(float)) + 12);  // tangents, matrices, places, pairs
  return bytes;
}

}  // namespace ringwatch

#include <ringwatch/monitor/incremental/validity_balls.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include <Eigen/Dense>

#include <ringwatch/base/infinity.h>
#include <ringwatch/base/rounding.h>
#include <ringwatch/base/sort_unique.h>

namespace ringwatch {
namespace {

using P = NativePack;
/// Batches whose motion is bounded together where that of their patch is too large: few enough that a front that runs
/// through the patch meets few of them, enough that they share most of their nodes.
constexpr std::int32_t clusterBatches = 8;
/// A radius that is not limited is stored as this one: infinity means that an element is never outside.
constexpr double largestRadius = 1e30;
/// Lever arms grow with the motion since they were found; beyond this factor all elements are tested.
constexpr double mostLeverArm = 1.1;
/// Of what is left of balls, at every motion that is taken from it, relative.
constexpr double leftRounding = 1e-15;
/// Beyond all roundings of numbers too small for single precision, m.
constexpr double smallestMotion = 1e-43;
/// A motion that is fitted has helped when C is at most this part of what it was; else fits become more seldom.
constexpr double helpfulFit = 0.8;
constexpr std::int32_t longestGapOfFits = 64;  // checks
/// Motions are from the positions at hand where they have used up this share of what is left on average. Each test at
/// other positions loses the motion to there twice; but there motions that go to and fro do not add up.
constexpr double mostMotion = 0.3;
/// Work of a check, in WorkAccount's units: of a node in any case, of going through it, of fitting a motion, of a
/// cluster's node, of keeping a node's position, and of testing an element at a quadrature point, directly or for what
/// is left of its ball.
constexpr double workOfPass = 0.15, workOfNode = 0.6, workOfFit = 300, workOfClusterNode = 0.3, workOfKeeping = 0.5,
                 workOfDirect = 0.5, workOfTest = 0.8;
/// Checks that the mean work of looking is over, and direct ones in a row: the fewest and the most. They double when
/// looking again does not pay for as long as they lasted.
constexpr double looksOfMean = 16;
constexpr std::int32_t fewestDirect = 16, mostDirect = 256;

typedef double Row4 __attribute__((vector_size(32)));
typedef float Floats16 __attribute__((vector_size(64)));
typedef float Floats8 __attribute__((vector_size(32)));
typedef float Floats4 __attribute__((vector_size(16)));

/// The nodes of a patch and where they were, from a centre of their own.
struct TrackedNodes {
  const float* before;  // m, four numbers a node
  std::size_t count;    // at least 4
  Eigen::Vector3d centre;
  const double* rows;  // m

  Eigen::Vector3d from(std::size_t i) const { return Eigen::Map<const Eigen::Vector3f>(before + 4 * i).cast<double>(); }
  Eigen::Vector3d moved(std::size_t i) const {
    return Eigen::Map<const Eigen::Vector3d>(rows + 4 * i) - centre - from(i);
  }
};

/// A of the motion x = y + t + A (y - c), by least squares over some of the nodes. Any A serves a bound; this leaves
/// little.
Eigen::Matrix3d fittedMotion(const TrackedNodes& tracked) {
  const std::size_t sample = std::min<std::size_t>(tracked.count, 24);
  const auto at = [&](std::size_t k) { return k * tracked.count / sample; };
  Eigen::Vector3d middle = Eigen::Vector3d::Zero(), mean = middle;
  for (std::size_t k = 0; k < sample; ++k) {
    middle += tracked.from(at(k));
    mean += tracked.moved(at(k));
  }
  middle /= static_cast<double>(sample);
  mean /= static_cast<double>(sample);
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero(), mixed = second;
  for (std::size_t k = 0; k < sample; ++k) {
    const Eigen::Vector3d from = tracked.from(at(k)) - middle;
    second += from * from.transpose();
    mixed += (tracked.moved(at(k)) - mean) * from.transpose();
  }
  // Nodes in a plane or on a line determine nothing across it; a little weight on A = 0 does.
  second += 1e-6 * second.trace() * Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d A = second.ldlt().solve(mixed.transpose()).transpose();
  return A.allFinite() ? A : Eigen::Matrix3d::Zero();
}

/// |F - F0|² of the elements of a batch at a point.
RINGWATCH_INLINE P squaredDistance(const double* F, const std::int16_t* reference) {
  P sums[3] = {P(0.0), P(0.0), P(0.0)};
  for (int i = 0; i < 9; ++i) {
    const P d = P::load(F + i * lanes) -
                P(ValidityBalls::entryUnit) * detail::packOf(detail::loadShorts(reference + i * lanes));
    sums[i % 3] += d * d;
  }
  return sums[0] + sums[1] + sums[2];
}

/// Whether elements are inside their balls, and not at the edge; false where a number is not one.
RINGWATCH_INLINE P::Mask isInside(const P& distance2, const P& radius) {
  const P allowed = P(1 - ValidityBalls::edgeFraction) * radius;
  return (radius >= P(0.0)) & (distance2 <= allowed * allowed);
}

/// Has the cache lines of some bytes fetched.
RINGWATCH_INLINE void prefetchBytes(const void* from, std::size_t bytes) {
  constexpr std::size_t line = 64;  // bytes
  for (std::size_t at = 0; at < bytes; at += line) __builtin_prefetch(static_cast<const char*>(from) + at);
}

/// Half the diagonal of a box.
template <class V>
double halfDiagonal(const V& most, const V& least) {
  double size2 = 0;
  for (int k = 0; k < 3; ++k) {
    const double size = static_cast<double>(most[k]) - static_cast<double>(least[k]);
    size2 += size * size;
  }
  return 0.5 * std::sqrt(size2);
}

}  // namespace

/// How far the moves of the nodes of a patch lie from A y, from that of its first node, m.
struct ValidityBalls::Residuals {
  alignas(64) float of[4 * PatchLayout::maxPatchNodes];  // four numbers a node
  double shared;                                         // |A| max |F|/γ and the rounding of positions
  double radius;                                         // half the diagonal of a box of all of them

  /// In single precision; the radius is infinite when a number is not finite.
  void compute(const TrackedNodes& tracked, const Eigen::Matrix3d& A) {
    // Four nodes at a time: their rows side by side.
    Floats16 column[3];
    Row4 origin;
    const Eigen::Vector3d first = tracked.moved(0) - A * tracked.from(0);
    for (int k = 0; k < 16; ++k)
      for (int j = 0; j < 3; ++j) column[j][k] = k % 4 == 3 ? 0 : static_cast<float>(A(k % 4, j));
    for (int k = 0; k < 4; ++k) origin[k] = k == 3 ? 0 : tracked.centre[k] + first[k];
    constexpr auto unlimited = std::numeric_limits<float>::infinity();
    Floats16 most = Floats16{} - unlimited, least = Floats16{} + unlimited, sum{};
    for (std::size_t next = 0; next < tracked.count; next += 4) {
      const std::size_t i = std::min(next, tracked.count - 4);
      const auto from = [&](std::size_t node) {
        Row4 row;
        std::memcpy(&row, tracked.rows + 4 * node, sizeof row);
        return __builtin_convertvector(row - origin, Floats4);
      };
      const Floats8 low = __builtin_shufflevector(from(i), from(i + 1), 0, 1, 2, 3, 4, 5, 6, 7),
                    high = __builtin_shufflevector(from(i + 2), from(i + 3), 0, 1, 2, 3, 4, 5, 6, 7);
      const Floats16 x = __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
      Floats16 y;
      std::memcpy(&y, tracked.before + 4 * i, sizeof y);
      const Floats16 y0 = __builtin_shufflevector(y, y, 0, 0, 0, 0, 4, 4, 4, 4, 8, 8, 8, 8, 12, 12, 12, 12),
                     y1 = __builtin_shufflevector(y, y, 1, 1, 1, 1, 5, 5, 5, 5, 9, 9, 9, 9, 13, 13, 13, 13),
                     y2 = __builtin_shufflevector(y, y, 2, 2, 2, 2, 6, 6, 6, 6, 10, 10, 10, 10, 14, 14, 14, 14);
      const Floats16 r = x - y - column[0] * y0 - column[1] * y1 - column[2] * y2;
      most = r > most ? r : most;
      least = r < least ? r : least;
      sum += r;  // a NaN would pass comparisons unseen
      std::memcpy(of + 4 * i, &r, sizeof r);
    }
    double top[3], bottom[3], nanGuard = 0;
    for (int k = 0; k < 3; ++k) {
      top[k] = std::max({most[k], most[k + 4], most[k + 8], most[k + 12]});
      bottom[k] = std::min({least[k], least[k + 4], least[k + 8], least[k + 12]});
      for (int node = 0; node < 4; ++node) nanGuard += static_cast<double>(sum[k + 4 * node]);
    }
    radius = std::isfinite(nanGuard) ? halfDiagonal(top, bottom) : infinity;
  }
  /// Half the diagonal of a box of some of them.
  double radiusOf(const std::uint16_t* nodes, std::size_t count) const {
    Floats4 most, least;
    std::memcpy(&most, of + 4 * nodes[0], sizeof most);
    least = most;
    for (std::size_t i = 1; i < count; ++i) {
      Floats4 r;
      std::memcpy(&r, of + 4 * nodes[i], sizeof r);
      most = r > most ? r : most;
      least = r < least ? r : least;
    }
    return halfDiagonal(most, least);
  }
};

/// Compares the deformation gradients of batches with their balls, a batch after another.
class ValidityBalls::BallCheck final : public GradientVisitor {
 public:
  BallCheck(ValidityBalls& balls, bool wantsLeverArm, std::vector<std::int32_t>& outside)
      : balls_(balls), wantsLeverArm_(wantsLeverArm), outside_(outside) {}

  void visit(std::int32_t batch, const double* F) override {
    const std::int16_t* reference =
        balls_.referenceGradient_.data() + static_cast<std::ptrdiff_t>(batch) * balls_.points_ * 9 * lanes;
    P distance2(0.0), size2(0.0);
    for (int q = 0; q < balls_.points_; ++q) {
      const P d2 = squaredDistance(F, reference);
      // A NaN fails the comparison inside max and would pass unseen: keep it.
      distance2 = select(d2 <= distance2, distance2, d2);
      if (wantsLeverArm_) {
        P f2(0.0);
        for (int i = 0; i < 9; ++i) f2 += P::load(F + i * lanes) * P::load(F + i * lanes);
        size2 = math::max(size2, f2);
      }
      reference += 9 * lanes;
      F += 9 * lanes;
    }
    // Roots in single precision, rounded up, cost a third.
    const P up(1 + singleRootRounding);
    const P distance = up * singlePrecisionRoot(distance2);
    const std::ptrdiff_t place = static_cast<std::ptrdiff_t>(batch) * lanes;
    const P inverseNorm = RoundedDown<Bfloat16>::load(balls_.inverseGradientNorm_.data() + place);
    const P radius = RoundedDown<Bfloat16>::load(balls_.radius_.data() + place);
    const auto inside = isInside(distance2, radius);
    const P left = select(inside, (radius - distance) * inverseNorm, P(infinity));
    balls_.left_[static_cast<std::size_t>(batch)] = least(left) * (1 - groupMarginRounding) - moved_;
    // 1/γ is rounded down by at most 1/64.
    if (wantsLeverArm_)
      leverArm_ = math::max(leverArm_, P(1 + 1.0 / 64) * up * singlePrecisionRoot(size2) * inverseNorm);
    if (!allOf(inside)) balls_.addOutside(batch, inside, outside_);
  }
  /// What has to be taken from what is left, m.
  void setMoved(double moved) { moved_ = moved; }
  /// Largest |F|/γ of the batches that were tested, m.
  double leverArm() const {
    double most = leverArm_[0];
    for (int lane = 1; lane < lanes; ++lane) most = std::max(most, leverArm_[lane]);
    return most;
  }

 private:
  static P singlePrecisionRoot(P a) {  // to 1e-7
    auto values = detail::singlesOf(a);
    for (int lane = 0; lane < lanes; ++lane) values[lane] = std::sqrt(values[lane]);
    return detail::packOf(values);
  }
  static double least(P a) {
    double least = infinity;  // which passes by a NaN
    for (int lane = 0; lane < lanes; ++lane) least = std::min(least, a[lane]);
    return least;
  }

  ValidityBalls& balls_;
  const bool wantsLeverArm_;
  std::vector<std::int32_t>& outside_;
  P leverArm_ = P(0.0);
  double moved_ = 0;
};

/// Whether batches are in their balls, and nothing else: no root, and no margin. For batches that are run in turn: what
/// the next one is compared with is fetched meanwhile.
class ValidityBalls::DirectCheck final : public GradientVisitor {
 public:
  DirectCheck(const ValidityBalls& balls, std::vector<std::int32_t>& outside) : balls_(balls), outside_(outside) {}

  void visit(std::int32_t batch, const double* F) override {
    const std::ptrdiff_t entries = static_cast<std::ptrdiff_t>(balls_.points_) * 9 * lanes;
    const std::ptrdiff_t toNext = static_cast<std::size_t>(batch) + 1 < balls_.batchCount() ? entries : 0;
    const std::int16_t* reference = balls_.referenceGradient_.data() + batch * entries;
    P distance2(0.0);
    for (int q = 0; q < balls_.points_; ++q) {
      prefetchBytes(reference + toNext, 9 * lanes * sizeof *reference);
      const P d2 = squaredDistance(F, reference);
      distance2 = select(d2 <= distance2, distance2, d2);  // a NaN stays
      reference += 9 * lanes;
      F += 9 * lanes;
    }
    const std::ptrdiff_t place = static_cast<std::ptrdiff_t>(batch) * lanes;
    const auto inside = isInside(distance2, RoundedDown<Bfloat16>::load(balls_.radius_.data() + place));
    if (!allOf(inside)) balls_.addOutside(batch, inside, outside_);
  }

 private:
  const ValidityBalls& balls_;
  std::vector<std::int32_t>& outside_;
};

ValidityBalls::ValidityBalls(const ElementBlock& block)
    : block_(&block), points_(static_cast<int>(block.rule().points.size())) {
  const PatchLayout& layout = block.layout();
  const std::size_t n = block.element().nodes;
  const std::size_t batches = layout.batchCount();
  referenceGradient_.assign(batches * static_cast<std::size_t>(points_) * 9 * lanes, 0);
  radius_.assign(batches * lanes, -1);
  inverseGradientNorm_.resize(batches * lanes);
  left_.assign(batches, -1);
  double norms[lanes];
  for (std::int32_t batch = 0; batch < layout.batchCount(); ++batch) {
    block.gradientNormBatch(batch, norms);
    for (int lane = 0; lane < lanes; ++lane) {
      const std::size_t place = batch * lanes + lane;
      inverseGradientNorm_[place] = 1 / norms[lane];
      if (layout.elements[place] < 0) radius_[place] = infinity;
    }
  }
  motions_.resize(layout.patches.size());
  patchClusters_.push_back(0);
  std::vector<std::uint16_t> touched;
  for (const Patch& patch : layout.patches) {
    for (std::int32_t first = patch.batchBegin; first < patch.batchEnd; first += clusterBatches) {
      Cluster cluster;
      cluster.batchBegin = first;
      cluster.batchEnd = std::min(patch.batchEnd, first + clusterBatches);
      const auto begin = layout.localNodes.begin();
      touched.assign(begin + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(first) * n * lanes),
                     begin + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(cluster.batchEnd) * n * lanes));
      sortUnique(touched);
      cluster.nodeBegin = nodes_.size();
      nodes_.insert(nodes_.end(), touched.begin(), touched.end());
      cluster.nodeEnd = nodes_.size();
      clusters_.push_back(cluster);
    }
    patchClusters_.push_back(static_cast<std::int32_t>(clusters_.size()));
  }
  nodes_.shrink_to_fit();
  clusters_.shrink_to_fit();
  before_.assign(4 * layout.nodes.size(), 0);
}

double ValidityBalls::setReferenceGradient(std::size_t place, const double* F0, int points, int lane) {
  double farthest2 = 0;
  for (int q = 0; q < points; ++q) {
    std::int16_t* target =
        referenceGradient_.data() +
        (place / lanes * static_cast<std::size_t>(points) + static_cast<std::size_t>(q)) * 9 * lanes + place % lanes;
    double distance2 = 0;
    for (int i = 0; i < 9; ++i) {
      const double entry = F0[(9 * q + i) * lanes + lane];
      if (!(std::abs(entry) <= largestEntry)) return infinity;
      const double units = std::nearbyint(entry * (1 / entryUnit)), off = units * entryUnit - entry;
      target[i * lanes] = static_cast<std::int16_t>(units);
      distance2 += off * off;
    }
    farthest2 = std::max(farthest2, distance2);
  }
  return std::sqrt(farthest2) * (1 + distanceRounding);
}

void ValidityBalls::addReferenceGradient(std::size_t place, double (&sum)[9]) const {
  const std::size_t points = points_;
  const std::int16_t* stored = referenceGradient_.data() + place / lanes * points * 9 * lanes + place % lanes;
  for (std::size_t i = 0; i < 9 * points; ++i) sum[i % 9] += entryUnit * stored[i * lanes];
}

void ValidityBalls::setRadius(std::size_t place, double aroundF0, double fromStored) {
  const double own = std::min(aroundF0, largestRadius) - fromStored;
  radius_[place] = own >= 0 ? own : -1.0;
}

void ValidityBalls::setRadii(std::int32_t batch, NativePack aroundF0) {
  RoundedDown<Bfloat16>* const at = radius_.data() + static_cast<std::ptrdiff_t>(batch) * lanes;
  const P before = RoundedDown<Bfloat16>::load(at), own = math::min(aroundF0, P(largestRadius)) - P(storageError);
  const auto moves = (before >= P(0.0)) & (before < P(infinity)), has = own >= P(0.0);
  RoundedDown<Bfloat16> rounded[lanes];
  RoundedDown<Bfloat16>::store(select(has, own, P(0.0)), rounded);
  const P now = select(moves, select(has, RoundedDown<Bfloat16>::load(rounded), P(-1.0)), before);
  for (int lane = 0; lane < lanes; ++lane) at[lane] = now[lane];
}

void ValidityBalls::setNeverOutside(std::size_t place) { radius_[place] = infinity; }

double ValidityBalls::distance(std::size_t place, const double* F, int lane) const {
  const std::size_t points = points_;
  const std::int16_t* stored = referenceGradient_.data() + place / lanes * points * 9 * lanes + place % lanes;
  double farthest2 = 0;
  for (std::size_t q = 0; q < points; ++q) {
    double distance2 = 0;
    for (std::size_t i = 0; i < 9; ++i) {
      const double off =
          F[(9 * q + i) * lanes + static_cast<std::size_t>(lane)] - entryUnit * stored[(9 * q + i) * lanes];
      distance2 += off * off;
    }
    if (!(distance2 <= farthest2)) farthest2 = distance2;  // a NaN stays
  }
  return std::sqrt(farthest2) * (1 + distanceRounding) + storageError;
}

void ValidityBalls::ballChanged(std::size_t place, double distance) {
  const std::size_t batch = place / lanes;
  const auto& patches = block_->layout().patches;
  const auto patch =
      static_cast<std::size_t>(std::upper_bound(patches.begin(), patches.end(), static_cast<std::int32_t>(batch),
                                                [](std::int32_t at, const Patch& p) { return at < p.batchEnd; }) -
                               patches.begin());
  Motion& motion = motions_[patch];
  // What is left at the positions of the last check is less by the motion from `before_` to there, on the way back.
  const double moved = motion.kept ? 0
                       : motion.clustered
                           ? clusters_[static_cast<std::size_t>(patchClusters_[patch]) +
                                       (batch - static_cast<std::size_t>(patches[patch].batchBegin)) / clusterBatches]
                                 .moved
                           : motion.moved;
  const double margin = (radius_[place] - distance) * static_cast<double>(inverseGradientNorm_[place]);
  left_[batch] = std::min(left_[batch], margin * (1 - groupMarginRounding) - moved);
  motion.leastLeft = std::min(motion.leastLeft, left_[batch]);
}

void ValidityBalls::addOutside(std::int32_t batch, const P::Mask& inside, std::vector<std::int32_t>& outside) const {
  const P flags = select(inside, P(1.0), P(0.0));
  for (int lane = 0; lane < lanes; ++lane) {
    // Lanes without an element never leave, but for positions whose squares overflow.
    const std::int32_t element = block_->layout().elements[static_cast<std::ptrdiff_t>(batch) * lanes + lane];
    if (flags[lane] == 0 && element >= 0) outside.push_back(element);
  }
}

void ValidityBalls::checkPatch(const PatchPass& pass, std::vector<std::int32_t>& outside) {
  const std::int32_t p = pass.index();
  const Patch& patch = pass.patch();
  Motion& motion = motions_[static_cast<std::size_t>(p)];
  const auto left = left_.begin() + patch.batchBegin, end = left_.begin() + patch.batchEnd;
  motion.tested = motion.asked = 0;
  motion.fitted = motion.clustered = motion.kept = false;
  motion.wasDirect = motion.direct > 0;
  if (motion.wasDirect) {
    --motion.direct;
    motion.testAll = true;  // once it is looked at again
    motion.tested = patch.batchEnd - patch.batchBegin;
    DirectCheck check(*this, outside);
    pass.run(patch.batchBegin, patch.batchEnd, &check);
    return;
  }
  if (!motion.testAll) {
    Residuals residuals;
    motion.moved = move(motion, patch, pass.rows(), residuals);
    if (motion.moved < motion.leastLeft) {  // not where both are infinite
      pass.run(patch.batchBegin, patch.batchEnd);
      chooseCheck(motion, static_cast<std::size_t>(p));
      return;
    }
    motion.testAll = !(motion.leverArm + motion.moved <= mostLeverArm * motion.testedLeverArm);  // a NaN among them
    if (!motion.testAll) moveClusters(motion, p, residuals);
  }
  if (motion.testAll) {
    std::fill(left, end, -1.0);
    motion.kept = true;
  }
  motion.tested = static_cast<std::int32_t>(std::count(left, end, -1.0));
  BallCheck check(*this, motion.testAll, outside);
  testMarked(motion, pass, check);
  // Times no motion at all it must be nothing.
  if (motion.testAll) motion.leverArm = motion.testedLeverArm = std::min(check.leverArm(), 1e100);
  motion.testAll = false;
  motion.leastLeft = *std::min_element(left, end);
  if (motion.kept) keepPositions(motion, patch, pass.rows());
  chooseCheck(motion, static_cast<std::size_t>(p));
}

double ValidityBalls::move(Motion& motion, const Patch& patch, const double* rows, Residuals& residuals) const {
  const TrackedNodes tracked{before_.data() + 4 * static_cast<std::ptrdiff_t>(patch.nodeBegin),
                             static_cast<std::size_t>(patch.nodeEnd - patch.nodeBegin), motion.centre, rows};
  const double moved = tracked.moved(0).lpNorm<1>();
  const auto by = [&](const Eigen::Matrix3d& A) {
    ++motion.asked;
    const double size = A.norm();
    residuals.compute(tracked, A);
    // Rounding of positions and of their differences.
    const double rounding = 4 * (motion.rounding * (1 + 4 * size) + 3 * storedPositionRounding * residuals.radius) +
                            positionRounding * (motion.centre.lpNorm<1>() + moved) + smallestMotion;
    residuals.shared = size * motion.leverArm + rounding;
    return (residuals.shared + residuals.radius) * (1 + groupMarginRounding);
  };
  ++motion.checks;
  ++motion.checksSinceFit;
  const Eigen::Matrix3d expected = motion.checks * motion.rate;
  const double C = by(expected);
  if (C < motion.leastLeft || motion.checksSinceFit < motion.gapOfFits) return C;
  const Eigen::Matrix3d A = fittedMotion(tracked);
  const double fitted = by(A);
  motion.fitted = true;
  motion.checksSinceFit = 0;
  motion.gapOfFits =
      fitted <= helpfulFit * C ? std::max(motion.gapOfFits / 2, 1) : std::min(2 * motion.gapOfFits, longestGapOfFits);
  if (!(fitted < C)) return by(expected);
  motion.rate = A / motion.checks;
  return fitted;
}

void ValidityBalls::moveClusters(Motion& motion, std::int32_t patch, const Residuals& residuals) {
  const auto begin = clusters_.begin() + patchClusters_[patch], end = clusters_.begin() + patchClusters_[patch + 1];
  const auto first = left_.begin() + begin->batchBegin, last = left_.begin() + (end - 1)->batchEnd;
  // A few tests too many cost less than asking clusters.
  const auto due = std::count_if(first, last, [&](double own) { return !(motion.moved < own); });
  motion.clustered = workOfTest * static_cast<double>(due * lanes * points_) >
                     workOfClusterNode * static_cast<double>((end - 1)->nodeEnd - begin->nodeBegin);
  double moved = 0, left = 0;
  for (auto cluster = begin; cluster != end; ++cluster) {
    cluster->moved = motion.clustered ? (residuals.shared + residuals.radiusOf(nodes_.data() + cluster->nodeBegin,
                                                                               cluster->nodeEnd - cluster->nodeBegin)) *
                                            (1 + groupMarginRounding)
                                      : motion.moved;
    moved += (cluster->batchEnd - cluster->batchBegin) * cluster->moved;
    for (std::int32_t batch = cluster->batchBegin; batch < cluster->batchEnd; ++batch)
      left += std::clamp(left_[static_cast<std::size_t>(batch)], 0.0, motion.leverArm);  // it may be infinite
  }
  motion.kept = moved > mostMotion * left;
  if (motion.kept) motion.leverArm += motion.moved;
  for (auto cluster = begin; cluster != end; ++cluster)
    for (std::int32_t batch = cluster->batchBegin; batch < cluster->batchEnd; ++batch) {
      double& own = left_[static_cast<std::size_t>(batch)];
      if (!(cluster->moved < own)) {
        own = -1;
        prefetch(batch);
      } else if (motion.kept)
        own = (own - cluster->moved) * (1 - leftRounding);
    }
}

void ValidityBalls::prefetch(std::int32_t batch) const {
  const std::ptrdiff_t entries = static_cast<std::ptrdiff_t>(points_) * 9 * lanes;
  prefetchBytes(referenceGradient_.data() + batch * entries, static_cast<std::size_t>(entries) * sizeof(std::int16_t));
  __builtin_prefetch(radius_.data() + static_cast<std::ptrdiff_t>(batch) * lanes);
  __builtin_prefetch(inverseGradientNorm_.data() + static_cast<std::ptrdiff_t>(batch) * lanes);
}

void ValidityBalls::testMarked(const Motion& motion, const PatchPass& pass, BallCheck& check) const {
  const Patch& patch = pass.patch();
  const Cluster* const clusters = clusters_.data() + patchClusters_[pass.index()];
  // Whether a batch is marked is told before it is tested.
  const auto isMarked = [&](std::int32_t batch) { return left_[static_cast<std::size_t>(batch)] == -1; };
  for (std::int32_t first = patch.batchBegin; first < patch.batchEnd;) {
    const bool marked = isMarked(first);
    std::int32_t last = first + 1;
    while (last < patch.batchEnd && isMarked(last) == marked) ++last;
    if (!marked)
      pass.run(first, last);
    else if (motion.kept)
      pass.run(first, last, &check);
    // What is left counts from other positions: the motion to there is lost.
    else
      for (std::int32_t next = first; first < last; first = next) {
        const Cluster& cluster = clusters[(first - patch.batchBegin) / clusterBatches];
        next = std::min(last, cluster.batchEnd);
        check.setMoved(cluster.moved);
        pass.run(first, next, &check);
      }
    first = last;
  }
}

double ValidityBalls::workOf(const Motion& motion, std::size_t p) const {
  const Patch& patch = block_->layout().patches[p];
  const double nodes = patch.nodeEnd - patch.nodeBegin;
  double work = workOfPass * nodes;
  if (motion.wasDirect) return work + workOfDirectCheck(patch);
  work += workOfNode * nodes * motion.asked + workOfTest * (motion.tested * lanes * points_);
  if (motion.fitted) work += workOfFit;
  if (motion.kept) work += workOfKeeping * nodes;
  if (motion.clustered)
    work += workOfClusterNode *
            static_cast<double>(clusters_[patchClusters_[p + 1] - 1].nodeEnd - clusters_[patchClusters_[p]].nodeBegin);
  return work;
}

double ValidityBalls::workOfDirectCheck(const Patch& patch) const {
  return workOfDirect * ((patch.batchEnd - patch.batchBegin) * lanes * points_);
}

double ValidityBalls::workOfCheck() const {
  double work = 0;
  for (std::size_t p = 0; p < motions_.size(); ++p) work += workOf(motions_[p], p);
  return work;
}

void ValidityBalls::chooseCheck(Motion& motion, std::size_t p) const {
  const Patch& patch = block_->layout().patches[p];
  const double nodes = patch.nodeEnd - patch.nodeBegin, direct = workOfPass * nodes + workOfDirectCheck(patch);
  motion.meanWork += (workOf(motion, p) - motion.meanWork) / looksOfMean;
  ++motion.looks;
  // Beginning to look costs a test of all elements, which counts as well.
  if (!(motion.meanWork > direct)) return;
  const bool soon = motion.looks < motion.gapOfDirect;
  motion.direct = motion.gapOfDirect =
      std::clamp(soon ? 2 * motion.gapOfDirect : motion.gapOfDirect / 2, fewestDirect, mostDirect);
  motion.looks = 0;
  motion.meanWork = 0;
  motion.testAll = true;
}

std::size_t ValidityBalls::testedBatches() const {
  std::size_t tested = 0;
  for (const Motion& motion : motions_) tested += static_cast<std::size_t>(motion.tested);
  return tested;
}

void ValidityBalls::keepPositions(Motion& motion, const Patch& patch, const double* rows) {
  motion.moved = 0;
  motion.checks = 0;
  motion.centre = Eigen::Map<const Eigen::Vector3d>(rows);
  const auto count = static_cast<std::size_t>(patch.nodeEnd - patch.nodeBegin);
  float* const before = before_.data() + 4 * static_cast<std::ptrdiff_t>(patch.nodeBegin);
  Row4 centre{};
  for (int k = 0; k < 3; ++k) centre[k] = motion.centre[k];
  Floats4 most{};
  for (std::size_t i = 0; i < count; ++i) {
    Row4 x;
    std::memcpy(&x, rows + 4 * i, sizeof x);
    const Floats4 from = __builtin_convertvector(x - centre, Floats4);
    std::memcpy(before + 4 * i, &from, sizeof from);
    const Floats4 size = from < 0 ? -from : from;
    most = size > most ? size : most;
  }
  motion.rounding = storedPositionRounding * static_cast<double>(std::max({most[0], most[1], most[2]}));
}

}  // namespace ringwatch

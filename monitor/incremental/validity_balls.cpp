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
/// Batches that skip checks together: enough that the test of their nodes costs little, few enough that they move
/// alike.
constexpr int groupBatches = 64;
/// A radius that is not limited is stored as this one: infinity means that an element is never outside.
constexpr double largestRadius = 1e30;
/// A group whose elements leave their balls at every check waits for up to this many before it tries to skip again:
/// trying costs as much as a visit.
constexpr int longestPause = 15;
/// Work of a check, in WorkAccount's units: of a node that is asked, of fitting a motion, and of a visit, an element's
/// quadrature point.
constexpr double workOfNode = 0.5, workOfFit = 300, workOfVisit = 2;

/// Nodes by their rows in a patch, and where they were, from a centre of their own.
struct TrackedNodes {
  const std::uint16_t* nodes;
  const float* before;  // m, three numbers a node
  std::size_t count;    // a multiple of 4
  Eigen::Vector3d centre;
  const double* rows;  // m

  Eigen::Vector3d from(std::size_t i) const { return Eigen::Map<const Eigen::Vector3f>(before + 3 * i).cast<double>(); }
  Eigen::Vector3d moved(std::size_t i) const {
    return Eigen::Map<const Eigen::Vector3d>(rows + 4 * nodes[i]) - centre - from(i);
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

/// How far the moves of the nodes lie from A y about the middle of their box, m; infinitely far when a number is not
/// finite.
double residual(const TrackedNodes& tracked, const Eigen::Matrix3d& A) {
  // Two nodes at a time: their rows side by side.
  typedef double Row8 __attribute__((vector_size(64)));
  typedef double Row4 __attribute__((vector_size(32)));
  typedef float Floats4 __attribute__((vector_size(16)));
  Row8 column[3], centre;
  for (int k = 0; k < 8; ++k) {
    const bool none = k % 4 == 3;
    for (int j = 0; j < 3; ++j) column[j][k] = none ? 0 : A(k % 4, j);
    centre[k] = none ? 0 : tracked.centre[k % 4];
  }
  // Two chains of comparisons, which would wait for one another.
  Row8 most[2], least[2], sum[2]{};
  for (int half = 0; half < 2; ++half) {
    most[half] = Row8{} - infinity;
    least[half] = Row8{} + infinity;
  }
  for (std::size_t i = 0; i < tracked.count; i += 4)
    for (std::size_t half = 0; half < 2; ++half) {
      // The fourth number of a float row is the next node's; the result for it is not used.
      Row4 now[2];
      Floats4 from[2];
      for (std::size_t k = 0; k < 2; ++k) {
        std::memcpy(&now[k], tracked.rows + 4 * tracked.nodes[i + 2 * half + k], sizeof now[k]);
        std::memcpy(&from[k], tracked.before + 3 * (i + 2 * half + k), sizeof from[k]);
      }
      const Row8 x = __builtin_shufflevector(now[0], now[1], 0, 1, 2, 3, 4, 5, 6, 7);
      const Row8 y = __builtin_convertvector(__builtin_shufflevector(from[0], from[1], 0, 1, 2, 3, 4, 5, 6, 7), Row8);
      const Row8 r = x - centre - y - column[0] * __builtin_shufflevector(y, y, 0, 0, 0, 0, 4, 4, 4, 4) -
                     column[1] * __builtin_shufflevector(y, y, 1, 1, 1, 1, 5, 5, 5, 5) -
                     column[2] * __builtin_shufflevector(y, y, 2, 2, 2, 2, 6, 6, 6, 6);
      most[half] = r > most[half] ? r : most[half];
      least[half] = r < least[half] ? r : least[half];
      sum[half] += r;  // a NaN would pass comparisons unseen
    }
  double size2 = 0, nanGuard = 0;
  for (int k = 0; k < 3; ++k) {
    const double size = std::max({most[0][k], most[0][k + 4], most[1][k], most[1][k + 4]}) -
                        std::min({least[0][k], least[0][k + 4], least[1][k], least[1][k + 4]});
    size2 += size * size;
    nanGuard += sum[0][k] + sum[0][k + 4] + sum[1][k] + sum[1][k + 4];
  }
  return std::isfinite(nanGuard) ? 0.5 * std::sqrt(size2) : infinity;
}

}  // namespace

/// Compares the deformation gradients of batches with their balls, a batch after another.
class ValidityBalls::BallCheck final : public GradientVisitor {
 public:
  BallCheck(const ValidityBalls& balls, std::vector<std::int32_t>& outside) : balls_(balls), outside_(outside) {}

  void visit(std::int32_t batch, const double* F) override {
    const std::int16_t* reference =
        balls_.referenceGradient_.data() + static_cast<std::ptrdiff_t>(batch) * balls_.points_ * 9 * lanes;
    P distance2(0.0), size2(0.0);
    for (int q = 0; q < balls_.points_; ++q) {
      P d2(0.0), f2(0.0);
      for (int i = 0; i < 9; ++i, reference += lanes, F += lanes) {
        const P f = P::load(F);
        const P d = f - P(entryUnit) * P(__builtin_convertvector(detail::loadShorts(reference), P::Values));
        d2 += d * d;
        f2 += f * f;
      }
      size2 = math::max(size2, f2);
      // A NaN fails the comparison inside max and would pass unseen: keep it.
      distance2 = select(d2 <= distance2, distance2, d2);
    }
    // Roots in single precision, rounded up, cost a third.
    const P up(1 + singleRootRounding);
    const P distance = up * singlePrecisionRoot(distance2), size = up * singlePrecisionRoot(size2);
    const std::ptrdiff_t place = static_cast<std::ptrdiff_t>(batch) * lanes;
    const P inverseNorm = RoundedDown<Bfloat16>::load(balls_.inverseGradientNorm_.data() + place);
    const P radius = RoundedDown<Bfloat16>::load(balls_.radius_.data() + place), margin = radius - distance;
    const auto inside = margin >= P(edgeFraction) * radius;
    leastMargin_ = math::min(leastMargin_, select(inside, margin * inverseNorm, leastMargin_));
    // 1/γ is rounded down by at most 1/64.
    leverArm_ = math::max(leverArm_, P(1 + 1.0 / 64) * size * inverseNorm);
    if (allOf(inside)) return;
    const P flags = select(inside, P(1.0), P(0.0));
    for (int lane = 0; lane < lanes; ++lane) {
      // Lanes without an element never leave, but for positions whose squares overflow.
      const std::int32_t element = balls_.block_->layout().elements[place + lane];
      if (flags[lane] == 0 && element >= 0) outside_.push_back(element);
    }
  }
  /// Of the elements inside their balls, m.
  double leastMargin() const {
    double least = leastMargin_[0];
    for (int lane = 1; lane < lanes; ++lane) least = std::min(least, leastMargin_[lane]);
    return least;
  }
  /// Largest |F|/γ, m.
  double leverArm() const {
    double most = leverArm_[0];
    for (int lane = 1; lane < lanes; ++lane) most = std::max(most, leverArm_[lane]);
    return most;
  }

 private:
  static P singlePrecisionRoot(P a) {  // to 1e-7
    auto values = __builtin_convertvector(a.v, detail::NativeFloats);
    for (int lane = 0; lane < lanes; ++lane) values[lane] = std::sqrt(values[lane]);
    return detail::packOf(values);
  }

  const ValidityBalls& balls_;
  std::vector<std::int32_t>& outside_;
  P leastMargin_ = P(infinity), leverArm_ = P(0.0);
};

ValidityBalls::ValidityBalls(const ElementBlock& block)
    : block_(&block), points_(static_cast<int>(block.rule().points.size())) {
  const PatchLayout& layout = block.layout();
  const std::size_t n = block.element().nodes;
  const std::size_t batches = layout.batchCount();
  referenceGradient_.assign(batches * static_cast<std::size_t>(points_) * 9 * lanes, 0);
  radius_.assign(batches * lanes, -1);
  inverseGradientNorm_.resize(batches * lanes);
  double norms[lanes];
  for (std::int32_t batch = 0; batch < layout.batchCount(); ++batch) {
    block.gradientNormBatch(batch, norms);
    for (int lane = 0; lane < lanes; ++lane) {
      const std::size_t place = batch * lanes + lane;
      inverseGradientNorm_[place] = 1 / norms[lane];
      if (layout.elements[place] < 0) radius_[place] = infinity;
    }
  }
  patchGroups_.push_back(0);
  std::vector<std::uint16_t> touched;
  for (const Patch& patch : layout.patches) {
    for (std::int32_t first = patch.batchBegin; first < patch.batchEnd; first += groupBatches) {
      Group group;
      group.batchBegin = first;
      group.batchEnd = std::min(patch.batchEnd, first + groupBatches);
      const auto begin = layout.localNodes.begin();
      touched.assign(begin + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(first) * n * lanes),
                     begin + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(group.batchEnd) * n * lanes));
      sortUnique(touched);
      group.nodeBegin = nodes_.size();
      nodes_.insert(nodes_.end(), touched.begin(), touched.end());
      while (nodes_.size() % 4 != 0) nodes_.push_back(touched.back());
      group.nodeEnd = nodes_.size();
      groups_.push_back(group);
    }
    patchGroups_.push_back(groups_.size());
  }
  nodes_.shrink_to_fit();
  before_.resize(3 * nodes_.size() + 1);
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
  const auto group = std::upper_bound(groups_.begin(), groups_.end(), place / lanes,
                                      [](std::int32_t batch, const Group& g) { return batch < g.batchEnd; });
  // The margin counts from the positions of the last visit: only when that was now does the ball fit in.
  const double margin =
      group->visitedAt == checks_ ? (radius_[place] - distance) * static_cast<double>(inverseGradientNorm_[place]) : -1;
  group->marginAtCheck = std::min(group->marginAtCheck, margin);
}

void ValidityBalls::checkPatch(const PatchPass& pass, std::vector<std::int32_t>& outside) {
  const std::size_t patch = pass.index();
  for (std::int32_t g = patchGroups_[patch]; g < patchGroups_[patch + 1]; ++g) {
    Group& group = groups_[g];
    if (canSkip(group, pass.rows())) {
      pass.run(group.batchBegin, group.batchEnd);
      continue;
    }
    BallCheck check(*this, outside);
    pass.run(group.batchBegin, group.batchEnd, &check);
    beginSkipping(group, check.leastMargin(), check.leverArm(), pass.rows());
  }
}

double ValidityBalls::workOfCheck() const {
  double work = 0;
  for (const Group& group : groups_) {
    if (group.tried) work += workOfNode * static_cast<double>(group.nodeEnd - group.nodeBegin);
    if (group.fitted) work += workOfFit;
    if (group.visitedAt == checks_)
      work += workOfVisit * static_cast<double>((group.batchEnd - group.batchBegin) * lanes * points_);
  }
  return work;
}

std::size_t ValidityBalls::visitedGroups() const {
  return static_cast<std::size_t>(
      std::count_if(groups_.begin(), groups_.end(), [&](const Group& group) { return group.visitedAt == checks_; }));
}

bool ValidityBalls::canSkip(Group& group, const double* rows) {
  group.tried = !(group.marginAtCheck < 0);
  group.fitted = false;
  if (group.marginAtCheck < 0 || !(remainingMargin(group, rows) >= 0)) return false;  // NaN among them
  group.skipped = true;
  group.pause = 0;
  return true;
}

double ValidityBalls::remainingMargin(Group& group, const double* rows) {
  const TrackedNodes tracked{nodes_.data() + group.nodeBegin, before_.data() + 3 * group.nodeBegin,
                             group.nodeEnd - group.nodeBegin, group.centre, rows};
  const double moved = tracked.moved(0).lpNorm<1>();
  const auto leftBy = [&](const Eigen::Matrix3d& A) {
    const double size = A.norm();
    // Rounding of positions and of their differences.
    const double rounding = group.rounding * (1 + size) + positionRounding * (group.centre.lpNorm<1>() + moved);
    return group.marginAtCheck * (1 - groupMarginRounding) - size * group.leverArm - residual(tracked, A) - rounding;
  };
  // Any motion will do, and the last one fitted is mostly good enough.
  const double left = leftBy(group.motion);
  if (left >= 0) return left;
  group.motion = fittedMotion(tracked);
  group.fitted = true;
  return leftBy(group.motion);
}

void ValidityBalls::beginSkipping(Group& group, double margin, double leverArm, const double* rows) {
  if (!group.skipped) {
    group.skipped = true;
    group.pause = static_cast<std::int16_t>(std::min(2 * group.pause + 1, longestPause));
    group.waits = group.pause;
  }
  group.visitedAt = checks_;
  if (group.waits > 0) {
    --group.waits;
    group.marginAtCheck = -1;
    return;
  }
  group.skipped = false;
  group.marginAtCheck = margin;
  group.motion.setZero();
  group.leverArm = std::min(leverArm, 1e100);  // times no motion at all it must be nothing
  group.centre = Eigen::Map<const Eigen::Vector3d>(rows + 4 * nodes_[group.nodeBegin]);
  float most = 0;
  for (std::size_t i = group.nodeBegin; i < group.nodeEnd; ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      const auto from = static_cast<float>(rows[4 * nodes_[i] + c] - group.centre[c]);
      before_[3 * i + c] = from;
      most = std::max(most, std::abs(from));
    }
  group.rounding = storedPositionRounding * static_cast<double>(most);
}

}  // namespace ringwatch

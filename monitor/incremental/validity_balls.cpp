#include <ringwatch/monitor/incremental/validity_balls.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include <ringwatch/base/infinity.h>
#include <ringwatch/base/rounding.h>

namespace ringwatch {
namespace {

using P = NativePack;
std::ptrdiff_t firstOf(std::int32_t batch) { return static_cast<std::ptrdiff_t>(batch) * lanes; }
/// A radius that is not limited is stored as this one, whose square single precision has too: infinity means that an
/// element is never outside.
constexpr double largestRadius = 1e15;
/// Smaller ones count no more than this where a centre is chosen.
constexpr double smallestRadius = 1e-6;
/// No ball about the centre of a batch that is smaller than this part of the element's own is worth its test.
constexpr double leastAroundCentre = 0.01;
/// Checks for which the elements of a batch are compared with their own gradients where no centre serves.
constexpr std::uint8_t checksByOwn = 16;
/// A centre is diagonal where what it loses beside its diagonal is no more than this part of the least radius.
constexpr double mostBesideDiagonal = 0.1;
/// Work of a check, in WorkAccount's units: of comparing an element at a quadrature point with its batch's centre, with
/// one that is diagonal, more with its own gradient, and of looking at it again, a new centre included, with what a
/// batch takes for that beside.
constexpr double workOfCommonTest = 0.15, workOfDiagonalTest = 0.1, workOfOwnTest = 0.3, workOfVisit = 2,
                 workOfVisitedBatch = 30;

/// An entry of the stored reference gradients of a batch.
RINGWATCH_INLINE P storedEntry(const std::int16_t* units) {
  return P(ValidityBalls::entryUnit) * detail::packOf(detail::loadShorts(units));
}

/// The bytes of so many batches, to see at once that all are zero.
constexpr std::int32_t batchesOfWord = sizeof(std::uint64_t);
std::uint64_t wordOf(const std::vector<std::uint8_t>& bytes, std::int32_t batch) {
  std::uint64_t word = 0;
  std::memcpy(&word, bytes.data() + batch, sizeof word);
  return word;
}

/// How many bytes of a word are not zero: each of them gets its highest bit.
int bytesSet(std::uint64_t word) {
  constexpr std::uint64_t high = 0x8080808080808080, low = ~high;
  return std::popcount((((word & low) + low) | word) & high);
}

double sumOverLanes(const P& values) {
  double sum = 0;
  for (int lane = 0; lane < lanes; ++lane) sum += values[lane];
  return sum;
}

/// Radii, those below zero as -1.
RINGWATCH_INLINE void storeRadii(const P& radii, RoundedDown<Bfloat16>* to) {
  RoundedDown<Bfloat16>::store(math::max(radii, P(0.0)), to);
  for (int lane = 0; lane < lanes; ++lane)
    if (!(radii[lane] >= 0)) to[lane] = -1.0;
}

/// The squared radius about a centre C that a batch is compared with: less what rounding can add to |F|² - 2C:F + |C|²,
/// of which |F|² may be 2 tr E + 3, where that is no more than it.
template <class S>
RINGWATCH_INLINE S comparedSquare(const S& radius, double squareOfCentre) {
  const S kept = radius * S(1 - commonBallRounding);
  return kept * kept * S(1 - commonSquareRounding) -
         S(commonSquareRounding * (squareOfCentre + BatchBalls::dimensions));
}

/// The same of an element whose reference gradients lie so far from C; < 0 where little is left.
template <class S>
RINGWATCH_INLINE S aroundCentre(const S& radius, const S& farthest2, double squareOfCentre) {
  const S around = radius - math::sqrt(farthest2);
  const auto has = (radius >= S(0.0)) & (around >= S(leastAroundCentre) * radius);
  return select(has, comparedSquare(around, squareOfCentre), S(-1.0));
}

/// The squared radius about the centre of a batch where the element's own has changed and its reference gradient has
/// not.
template <class S>
RINGWATCH_INLINE S movedSquare(const S& square, const S& before, const S& now, double squareOfCentre) {
  const S moved = math::sqrt(math::max(square, S(0.0))) + (now - before);
  const auto has = (square >= S(0.0)) & (before < S(infinity)) & (moved >= S(leastAroundCentre) * now);
  return select(has, comparedSquare(moved, squareOfCentre), S(-1.0));
}

}  // namespace

/// Compares batches with the balls of their elements.
class ValidityBalls::BallCheck final : public GradientVisitor {
 public:
  BallCheck(ValidityBalls& balls, std::vector<std::int32_t>& outside) : balls_(balls), outside_(outside) {}

  void visit(std::int32_t batch, const double* F) override {
    BatchBalls::OfBatch own;
    own.start(balls_.balls(), batch, balls_.points_, true);
    for (int q = 0; q < balls_.points_; ++q) {
      Matrix3<P> at;
      for (int i = 0; i < 9; ++i) at.m[i] = P::load(F + (9 * q + i) * lanes);
      own.add(at);
    }
    const auto inside = own.inside();
    const P flags = select(inside, P(1.0), P(0.0));
    const std::int32_t* const elements = balls_.block_->layout().elements.data() + firstOf(batch);
    // Lanes without an element never leave, but for positions whose squares overflow.
    for (int lane = 0; lane < lanes; ++lane)
      if (flags[lane] == 0 && elements[lane] >= 0) outside_.push_back(elements[lane]);
    std::uint8_t& byOwn = balls_.byOwn_[static_cast<std::size_t>(batch)];
    if (byOwn == 0 && !balls_.moveCentre(batch, F, inside)) byOwn = checksByOwn;
  }

 private:
  ValidityBalls& balls_;
  std::vector<std::int32_t>& outside_;
};

ValidityBalls::ValidityBalls(const ElementBlock& block)
    : block_(&block),
      points_(static_cast<int>(block.rule().points.size())),
      byOwn_(static_cast<std::size_t>(block.layout().batchCount())),
      left_(byOwn_.size()) {
  const PatchLayout& layout = block.layout();
  const std::size_t batches = layout.batchCount();
  referenceGradient_.assign(batches * static_cast<std::size_t>(points_) * 9 * lanes, 0);
  radius_.assign(batches * lanes, -1);
  for (std::size_t place = 0; place < radius_.size(); ++place)
    if (layout.elements[place] < 0) radius_[place] = infinity;
  centre_.assign(BatchBalls::centreSize * batches, 0);
  diagonal_.assign(batches, 0);
  squareAroundCentre_.assign(batches * lanes, -1);
}

P ValidityBalls::storeGradients(const double* F, int points, std::int16_t* to) {
  P farthest2(0.0);
  auto fits = farthest2 == farthest2;
  for (int q = 0; q < points; ++q) {
    P distance2(0.0);
    for (int i = 0; i < 9; ++i, F += lanes, to += lanes) {
      const P entry = P::load(F);
      const auto within = math::abs(entry) <= P(largestEntry);
      fits = fits & within;
      const P units = select(within, entry, P(0.0)) * P(1 / entryUnit);
      const auto rounded =
          __builtin_convertvector((units + select(units < P(0.0), P(-0.5), P(0.5))).v, detail::NativeIntegers);
      const auto shorts = __builtin_convertvector(rounded, detail::NativeShorts);
      std::memcpy(to, &shorts, sizeof shorts);
      const P off = P(entryUnit) * detail::packOf(rounded) - entry;
      distance2 += off * off;
    }
    farthest2 = math::max(farthest2, distance2);
  }
  return select(fits, math::sqrt(farthest2) * P(1 + distanceRounding), P(infinity));
}

P ValidityBalls::setReferenceGradients(std::int32_t batch, const double* F0) {
  std::fill_n(squareAroundCentre_.data() + firstOf(batch), lanes, RoundedDown<Bfloat16>(-1.0));
  return storeGradients(F0, points_,
                        referenceGradient_.data() + static_cast<std::ptrdiff_t>(batch) * points_ * 9 * lanes);
}

void ValidityBalls::fitRadii(std::int32_t batch, P radii) {
  const std::ptrdiff_t first = firstOf(batch);
  RoundedDown<Bfloat16>* const at = radius_.data() + first;
  RoundedDown<Bfloat16>* const squares = squareAroundCentre_.data() + first;
  const P before = RoundedDown<Bfloat16>::load(at);
  const P now = select(before < P(infinity), math::min(radii, P(largestRadius)), before);
  storeRadii(now, at);
  const P square = RoundedDown<Bfloat16>::load(squares);
  storeRadii(movedSquare(square, before, RoundedDown<Bfloat16>::load(at), squareOfCentre(batch)), squares);
}

double ValidityBalls::setReferenceGradient(std::size_t place, const double* F0, int points, int lane) {
  squareAroundCentre_[place] = -1;
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
  const double before = radius_[place], own = std::min(aroundF0, largestRadius) - fromStored;
  radius_[place] = own >= 0 ? own : -1.0;
  const double square = squareAroundCentre_[place], now = radius_[place];
  squareAroundCentre_[place] =
      square >= 0 ? movedSquare(square, before, now, squareOfCentre(place / lanes)) : squareAround(place, now);
}

template <class Entry>
double ValidityBalls::squareOfDistance(std::size_t place, const Entry& entry) const {
  const std::size_t points = points_;
  const std::int16_t* stored = referenceGradient_.data() + place / lanes * points * 9 * lanes + place % lanes;
  double farthest2 = 0;
  for (std::size_t q = 0; q < points; ++q) {
    double distance2 = 0;
    for (std::size_t i = 0; i < 9; ++i) {
      const double off = entry(q, i) - entryUnit * stored[(9 * q + i) * lanes];
      distance2 += off * off;
    }
    if (!(distance2 <= farthest2)) farthest2 = distance2;  // a NaN stays
  }
  return farthest2;
}

double ValidityBalls::squareAround(std::size_t place, double radius) const {
  const std::size_t batch = place / lanes;
  const double* const centre = centre_.data() + BatchBalls::centreSize * batch;
  const double farthest2 = squareOfDistance(place, [centre](std::size_t, std::size_t i) { return centre[i]; });
  return aroundCentre(radius, farthest2, squareOfCentre(batch));
}

void ValidityBalls::setRadii(std::int32_t batch, NativePack aroundF0) {
  const std::ptrdiff_t first = firstOf(batch);
  RoundedDown<Bfloat16>* const at = radius_.data() + first;
  RoundedDown<Bfloat16>* const squares = squareAroundCentre_.data() + first;
  const P before = RoundedDown<Bfloat16>::load(at), own = math::min(aroundF0, P(largestRadius)) - P(storageError);
  const auto moves = (before >= P(0.0)) & (before < P(infinity));
  storeRadii(select(moves, own, before), at);
  const P square = RoundedDown<Bfloat16>::load(squares);
  const P moved = movedSquare(square, before, RoundedDown<Bfloat16>::load(at), squareOfCentre(batch));
  storeRadii(select(moves, moved, square), squares);
}

void ValidityBalls::setNeverOutside(std::size_t place) { radius_[place] = infinity; }

double ValidityBalls::distance(std::size_t place, const double* F, int lane) const {
  const double farthest2 = squareOfDistance(place, [F, lane](std::size_t q, std::size_t i) {
    return F[(9 * q + i) * lanes + static_cast<std::size_t>(lane)];
  });
  return std::sqrt(farthest2) * (1 + distanceRounding) + storageError;
}

bool ValidityBalls::moveCentre(std::int32_t batch, const double* F, const P::Mask& of) {
  const P radius = RoundedDown<Bfloat16>::load(radius_.data() + firstOf(batch));
  // Elements that are never outside may have no reference gradient.
  const auto counts = of & (radius < P(infinity));
  const P least(smallestRadius), size = math::max(radius, least);
  const P weight = select(counts, least * least / (size * size), P(0.0));
  const double sumOfWeights = points_ * sumOverLanes(weight);
  double mean[9], diagonal[9] = {}, besideDiagonal2 = 0;
  for (int i = 0; i < 9; ++i) {
    P sum(0.0);
    for (int q = 0; q < points_; ++q) sum += select(counts, P::load(F + (9 * q + i) * lanes), P(0.0));
    mean[i] = sumOfWeights > 0 ? sumOverLanes(sum * weight) / sumOfWeights : 0;
    if (i % 4 == 0)
      diagonal[i] = mean[i];
    else
      besideDiagonal2 += mean[i] * mean[i];
  }
  double leastRadius = infinity;
  for (int lane = 0; lane < lanes; ++lane)
    if (radius[lane] >= 0) leastRadius = std::min(leastRadius, radius[lane]);
  return (besideDiagonal2 <= mostBesideDiagonal * mostBesideDiagonal * leastRadius * leastRadius &&
          setCentre(batch, diagonal, true, F, of)) ||
         setCentre(batch, mean, false, F, of);
}

bool ValidityBalls::setCentre(std::int32_t batch, const double (&given)[9], bool isDiagonal, const double* F,
                              const P::Mask& of) {
  const P radius = RoundedDown<Bfloat16>::load(radius_.data() + firstOf(batch));
  double* const centre = centre_.data() + BatchBalls::centreSize * batch;
  double squareOfCentre = 0;
  for (int i = 0; i < 9; ++i) {
    centre[i] = given[i];
    squareOfCentre += centre[i] * centre[i];
  }
  centre[BatchBalls::placeOfSquare] = squareOfCentre;
  diagonal_[static_cast<std::size_t>(batch)] = isDiagonal;
  const std::int16_t* reference = referenceOf(batch);
  P farthest2(0.0);
  for (int q = 0; q < points_; ++q) {
    P distance2(0.0);
    for (int i = 0; i < 9; ++i, reference += lanes) {
      const P d = storedEntry(reference) - P(centre[i]);
      distance2 += d * d;
    }
    farthest2 = math::max(farthest2, distance2);
  }
  RoundedDown<Bfloat16>* const squares = squareAroundCentre_.data() + firstOf(batch);
  storeRadii(aroundCentre(radius, farthest2, squareOfCentre), squares);
  const P square = RoundedDown<Bfloat16>::load(squares);
  auto inside = square >= P(0.0);
  for (int q = 0; q < points_; ++q) {
    P distance2(0.0);
    for (int i = 0; i < 9; ++i, F += lanes) {
      const P d = P::load(F) - P(centre[i]);
      distance2 += d * d;
    }
    inside = inside & (distance2 <= square);
  }
  return !anyOf(of & (inside == 0));
}

void ValidityBalls::checkPatch(const PatchPass& pass, std::vector<std::int32_t>& outside) {
  const BatchBalls own = balls();
  pass.run(&own);
  BallCheck check(*this, outside);
  const std::int32_t end = pass.patch().batchEnd;
  for (std::int32_t first = pass.patch().batchBegin; first < end; first += batchesOfWord) {
    const std::int32_t last = std::min(first + batchesOfWord, end);
    if (last == first + batchesOfWord && wordOf(byOwn_, first) == 0 && wordOf(left_, first) == 0) continue;
    for (std::int32_t batch = first; batch < last; ++batch) {
      const auto at = static_cast<std::size_t>(batch);
      if (byOwn_[at] > 0 && --byOwn_[at] == 0) left_[at] = 1;
      if (left_[at] != 0) pass.visit(batch, check);
    }
  }
}

double ValidityBalls::workOfCheck() const {
  const auto count = [](const std::vector<std::uint8_t>& of) {
    const auto whole = static_cast<std::int32_t>(of.size()) / batchesOfWord * batchesOfWord;
    std::ptrdiff_t sum = std::count_if(of.begin() + whole, of.end(), [](std::uint8_t one) { return one != 0; });
    for (std::int32_t first = 0; first < whole; first += batchesOfWord) sum += bytesSet(wordOf(of, first));
    return static_cast<double>(sum);
  };
  const double batches = static_cast<double>(batchCount()), diagonal = count(diagonal_), visited = count(left_);
  const double ofPoint = workOfCommonTest * (batches - diagonal) + workOfDiagonalTest * diagonal +
                         workOfOwnTest * count(byOwn_) + workOfVisit * visited;
  return ofPoint * lanes * points_ + workOfVisitedBatch * visited;
}

std::size_t ValidityBalls::testedBatches() const {
  std::size_t tested = 0;
  for (std::size_t batch = 0; batch < left_.size(); ++batch) tested += left_[batch] != 0 || byOwn_[batch] != 0;
  return tested;
}

}  // namespace ringwatch

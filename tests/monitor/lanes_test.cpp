#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include <ringwatch/base/pack.h>
#include <ringwatch/base/random.h>
#include <ringwatch/materials/rotation.h>
#include <ringwatch/monitor/small/extreme_eigenvalues.h>
#include <ringwatch/monitor/small/symmetric3.h>

namespace ringwatch {
namespace {

using P = NativePack;

/// Entries of `size` numbers, of different sizes and clusters from lane to lane, so that iterations end at different
/// times.
void fillLane(Random& random, P* entries, int size, int lane) {
  const double scale = std::pow(10.0, random.uniform(-6, 6));
  const bool cluster = random.index(3) == 0;
  for (int i = 0; i < size; ++i) entries[i].set(lane, scale * random.uniform(-1, 1) * (cluster ? 1e-9 : 1));
}

bool sameBits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

/// kernel(entries, results): the results of a lane are the same whatever lies beside it.
template <class Kernel>
void expectLanesAlone(int size, int results, const Kernel& kernel) {
  Random random(7);
  std::array<P, 24 * 24> entries, alone, work;
  std::array<P, 9> together, own;
  int differ = 0;
  for (int trial = 0; trial < 400; ++trial) {
    for (int lane = 0; lane < nativeWidth; ++lane) fillLane(random, entries.data(), size, lane);
    work = entries;
    kernel(work.data(), together.data());
    for (int lane = 0; lane < nativeWidth; ++lane) {
      for (int i = 0; i < size; ++i) alone[i] = P(entries[i][lane]);
      work = alone;
      kernel(work.data(), own.data());
      for (int r = 0; r < results; ++r) differ += sameBits(together[r][lane], own[r][0]) ? 0 : 1;
    }
  }
  EXPECT_EQ(differ, 0);
}

TEST(Lanes, OfExtremeEigenvaluesStandAlone) {
  for (const int n : {3, 12, 24})
    expectLanesAlone(n * n, 3, [n](P* A, P* results) {
      for (int i = 0; i < n; ++i) A[i * n + i] += P(1.5) * math::abs(A[i * n + i]);
      P work[4 * 24];
      const auto extremes = extremeEigenvalues(A, n, work, true);
      results[0] = extremes.largest;
      results[1] = extremes.least;
      results[2] = extremes.scale;
    });
}

TEST(Lanes, OfRotationsStandAlone) {
  expectLanesAlone(9, 9, [](P* entries, P* results) {
    Matrix3<P> F;
    for (int i = 0; i < 9; ++i) F.m[i] = entries[i];
    const Matrix3<P> R = closestRotation(F);
    for (int i = 0; i < 9; ++i) results[i] = R.m[i];
  });
}

TEST(Lanes, OfSquareRootsStandAlone) {
  expectLanesAlone(6, 6, [](P* entries, P* results) {
    Symmetric3<P> S;
    for (int i = 0; i < 6; ++i) S.m[i] = entries[i];
    Symmetric3<P> C = square(S);  // positive semidefinite
    for (int i = 0; i < 3; ++i) C.m[i] += P(1e-3) * C.trace();
    const Symmetric3<P> root = squareRoot(C);
    for (int i = 0; i < 6; ++i) results[i] = root.m[i];
  });
}

}  // namespace
}  // namespace ringwatch

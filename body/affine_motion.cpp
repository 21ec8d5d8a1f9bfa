#include <ringwatch/body/affine_motion.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include <Eigen/Dense>

namespace ringwatch {
namespace {

constexpr std::size_t chunk = 128;  // nodes gathered at a time
constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

AffineMotion fitAffineMotion(const TrackedNodes& tracked, const NodeVectors& x, std::size_t sample) {
  sample = std::min(tracked.count, sample);
  AffineMotion motion;
  const auto at = [&](std::size_t k) { return k * tracked.count / sample; };
  const auto y = [&](std::size_t i) { return Eigen::Map<const Eigen::Vector3d>(tracked.before + 3 * i); };
  for (std::size_t k = 0; k < sample; ++k) {
    motion.centre += y(at(k));
    motion.translation += x.col(tracked.nodes[at(k)]) - y(at(k));
  }
  motion.centre /= static_cast<double>(sample);
  motion.translation /= static_cast<double>(sample);
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero(), mixed = Eigen::Matrix3d::Zero();
  for (std::size_t k = 0; k < sample; ++k) {
    const Eigen::Vector3d from = y(at(k)) - motion.centre;
    second += from * from.transpose();
    mixed += (x.col(tracked.nodes[at(k)]) - y(at(k)) - motion.translation) * from.transpose();
  }
  // Nodes in a plane or on a line determine nothing across it; a little weight on A = 0 does.
  second += 1e-6 * second.trace() * Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d A = second.ldlt().solve(mixed.transpose()).transpose();
  if (A.allFinite()) motion.A = A;
  return motion;
}

ResidualsOf::ResidualsOf(const AffineMotion& motion) {
  for (int row = 0; row < 3; ++row)
    for (int k = 0; k < 8; ++k) {
      const int component = (8 * row + k) % 3;
      translation_[row][k] = motion.translation[component];
      for (int j = 0; j < 3; ++j) A_[row][j][k] = motion.A(component, j);
    }
  for (int j = 0; j < 3; ++j) centre_[j] = Row8{} + motion.centre[j];
}

Residuals ResidualsOf::operator()(const TrackedNodes& tracked, const NodeVectors& x, bool store) const {
  Row8 most[3], least[3], poison{};  // a NaN would pass comparisons unseen
  for (int row = 0; row < 3; ++row) {
    most[row] = Row8{} - infinite;
    least[row] = Row8{} + infinite;
  }
  for (std::size_t first = 0; first < tracked.count; first += chunk) {
    // Many nodes before any arithmetic: a load of what smaller stores have just written would wait for them.
    alignas(64) double gathered[3 * chunk];
    const std::size_t count = std::min(chunk, tracked.count - first);
    for (std::size_t i = 0; i < count; ++i)
      std::memcpy(gathered + 3 * i, x.data() + 3 * static_cast<std::ptrdiff_t>(tracked.nodes[first + i]),
                  3 * sizeof(double));
    for (std::size_t i = 0; i < count; i += 8) {
      const double* now = gathered + 3 * i;
      double* before = tracked.before + 3 * (first + i);
      Row8 y[3];
      std::memcpy(y, before, sizeof y);
      // y[row] belongs to nodes 0 0 0 1 1 1 2 2 | 2 3 3 3 4 4 4 5 | 5 5 6 6 6 7 7 7; component j of those nodes:
      const Row8 of[3][3] = {
          {__builtin_shufflevector(y[0], y[1], 0, 0, 0, 3, 3, 3, 6, 6),
           __builtin_shufflevector(y[0], y[1], 1, 1, 1, 4, 4, 4, 7, 7),
           __builtin_shufflevector(y[0], y[1], 2, 2, 2, 5, 5, 5, 8, 8)},
          {__builtin_shufflevector(y[0], y[1], 6, 9, 9, 9, 12, 12, 12, 15),
           __builtin_shufflevector(__builtin_shufflevector(y[0], y[1], 7, 10, 10, 10, 13, 13, 13, 13), y[2], 0, 1, 2, 3,
                                   4, 5, 6, 8),
           __builtin_shufflevector(y[1], y[2], 0, 3, 3, 3, 6, 6, 6, 9)},
          {__builtin_shufflevector(y[1], y[2], 7, 7, 10, 10, 10, 13, 13, 13),
           __builtin_shufflevector(y[2], y[2], 0, 0, 3, 3, 3, 6, 6, 6),
           __builtin_shufflevector(y[2], y[2], 1, 1, 4, 4, 4, 7, 7, 7)}};
      for (int row = 0; row < 3; ++row) {
        Row8 x8;
        std::memcpy(&x8, now + 8 * row, sizeof x8);
        const Row8 r = x8 - y[row] - translation_[row] - A_[row][0] * (of[row][0] - centre_[0]) -
                       A_[row][1] * (of[row][1] - centre_[1]) - A_[row][2] * (of[row][2] - centre_[2]);
        most[row] = r > most[row] ? r : most[row];
        least[row] = r < least[row] ? r : least[row];
        poison += r;
      }
      if (store) std::memcpy(before, now, 24 * sizeof(double));
    }
  }
  Eigen::Vector3d high = Eigen::Vector3d::Constant(-infinite), low = -high;
  double sum = 0;
  for (int k = 0; k < 24; ++k) {
    high[k % 3] = std::max(high[k % 3], most[k / 8][k % 8]);
    low[k % 3] = std::min(low[k % 3], least[k / 8][k % 8]);
    sum += poison[k % 8];
  }
  return {0.5 * (high + low), std::isfinite(sum) ? 0.5 * (high - low).norm() : infinite};
}

}  // namespace ringwatch

#include <ringwatch/body/motion_odometer.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include <Eigen/Dense>

#include <ringwatch/base/parallel.h>

namespace ringwatch {
namespace {

typedef double Row8 __attribute__((vector_size(64)));

constexpr std::size_t runNodes = 128;
constexpr double infinite = std::numeric_limits<double>::infinity();

/// Long runs add many small numbers.
void addRoundedUp(double& sum, double part) {
  if (part > 0) sum = std::nextafter(sum + part, infinite);
}

struct AffineMotion {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero(), translation = Eigen::Vector3d::Zero();
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
};

/// Least squares over some of the nodes. Any motion will do: this one leaves little.
AffineMotion fit(const std::vector<std::int32_t>& nodes, const AlignedVector<double>& before, const NodeVectors& x) {
  constexpr std::size_t leastNodes = 16, share = 128;
  const std::size_t sample = std::min(nodes.size(), std::max(leastNodes, nodes.size() / share));
  AffineMotion motion;
  const auto at = [&](std::size_t k) { return k * nodes.size() / sample; };
  const auto y = [&](std::size_t i) { return Eigen::Map<const Eigen::Vector3d>(before.data() + 3 * i); };
  for (std::size_t k = 0; k < sample; ++k) {
    motion.centre += y(at(k));
    motion.translation += x.col(nodes[at(k)]) - y(at(k));
  }
  motion.centre /= static_cast<double>(sample);
  motion.translation /= static_cast<double>(sample);
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero(), mixed = Eigen::Matrix3d::Zero();
  for (std::size_t k = 0; k < sample; ++k) {
    const Eigen::Vector3d from = y(at(k)) - motion.centre;
    second += from * from.transpose();
    mixed += (x.col(nodes[at(k)]) - y(at(k)) - motion.translation) * from.transpose();
  }
  // Nodes in a plane or on a line determine nothing across it; a little weight on A = 0 does.
  second += 1e-6 * second.trace() * Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d A = second.ldlt().solve(mixed.transpose()).transpose();
  if (A.allFinite()) motion.A = A;
  return motion;
}

}  // namespace

MotionOdometer::MotionOdometer(const std::vector<std::int32_t>& order, int threads) : threads_(threads) {
  runOf_.resize(order.size());
  runBegin_.push_back(0);
  for (std::size_t first = 0; first < order.size(); first += runNodes) {
    const std::size_t end = std::min(order.size(), first + runNodes);
    for (std::size_t i = first; i < end; ++i) {
      runOf_[static_cast<std::size_t>(order[i])] = static_cast<std::int32_t>(courses_.size());
      nodes_.push_back(order[i]);
    }
    while (nodes_.size() % 8 != 0) nodes_.push_back(order[end - 1]);
    runBegin_.push_back(nodes_.size());
    courses_.emplace_back();
  }
  before_.resize(3 * nodes_.size());
}

void MotionOdometer::advance(const NodeVectors& x) {
  if (!started_) {
    started_ = true;
    for (std::size_t i = 0; i < nodes_.size(); ++i) std::copy_n(x.col(nodes_[i]).data(), 3, before_.data() + 3 * i);
    if (!x.allFinite())
      for (Course& course : courses_) course.about = infinite;
    return;
  }
  const AffineMotion motion = fit(nodes_, before_, x);
  // Eight nodes are three rows of eight numbers. What component each number belongs to:
  Row8 A[3][3], t[3], c[3];
  for (int row = 0; row < 3; ++row)
    for (int k = 0; k < 8; ++k) {
      const int component = (8 * row + k) % 3;
      t[row][k] = motion.translation[component];
      for (int j = 0; j < 3; ++j) A[row][j][k] = motion.A(component, j);
    }
  for (int j = 0; j < 3; ++j) c[j] = Row8{} + motion.centre[j];
  parallelFor(
      0, static_cast<std::int64_t>(courses_.size()), threads_,
      [&](std::int64_t index) {
        const auto run = static_cast<std::size_t>(index);
        Row8 most[3], least[3], poison{};  // a NaN would pass comparisons unseen
        for (int row = 0; row < 3; ++row) {
          most[row] = Row8{} - infinite;
          least[row] = Row8{} + infinite;
        }
        // All of the run first: a load of what smaller stores have just written would wait for them.
        alignas(64) double gathered[3 * runNodes];
        const std::size_t begin = runBegin_[run], count = runBegin_[run + 1] - begin;
        for (std::size_t i = 0; i < count; ++i)
          std::memcpy(gathered + 3 * i, x.data() + 3 * static_cast<std::ptrdiff_t>(nodes_[begin + i]),
                      3 * sizeof(double));
        for (std::size_t i = 0; i < count; i += 8) {
          const double* now = gathered + 3 * i;
          double* before = before_.data() + 3 * (begin + i);
          Row8 y[3];
          std::memcpy(y, before, sizeof y);
          // y[row] belongs to nodes 0 0 0 1 1 1 2 2 | 2 3 3 3 4 4 4 5 | 5 5 6 6 6 7 7 7; component j of those nodes:
          const Row8 of[3][3] = {
              {__builtin_shufflevector(y[0], y[1], 0, 0, 0, 3, 3, 3, 6, 6),
               __builtin_shufflevector(y[0], y[1], 1, 1, 1, 4, 4, 4, 7, 7),
               __builtin_shufflevector(y[0], y[1], 2, 2, 2, 5, 5, 5, 8, 8)},
              {__builtin_shufflevector(y[0], y[1], 6, 9, 9, 9, 12, 12, 12, 15),
               __builtin_shufflevector(__builtin_shufflevector(y[0], y[1], 7, 10, 10, 10, 13, 13, 13, 13), y[2], 0, 1,
                                       2, 3, 4, 5, 6, 8),
               __builtin_shufflevector(y[1], y[2], 0, 3, 3, 3, 6, 6, 6, 9)},
              {__builtin_shufflevector(y[1], y[2], 7, 7, 10, 10, 10, 13, 13, 13),
               __builtin_shufflevector(y[2], y[2], 0, 0, 3, 3, 3, 6, 6, 6),
               __builtin_shufflevector(y[2], y[2], 1, 1, 4, 4, 4, 7, 7, 7)}};
          for (int row = 0; row < 3; ++row) {
            Row8 x8;
            std::memcpy(&x8, now + 8 * row, sizeof x8);
            const Row8 r = x8 - y[row] - t[row] - A[row][0] * (of[row][0] - c[0]) - A[row][1] * (of[row][1] - c[1]) -
                           A[row][2] * (of[row][2] - c[2]);
            most[row] = r > most[row] ? r : most[row];
            least[row] = r < least[row] ? r : least[row];
            poison += r;
          }
          std::memcpy(before, now, 24 * sizeof(double));
        }
        Eigen::Vector3d high = Eigen::Vector3d::Constant(-infinite), low = -high;
        double sum = 0;
        for (int k = 0; k < 24; ++k) {
          high[k % 3] = std::max(high[k % 3], most[k / 8][k % 8]);
          low[k % 3] = std::min(low[k % 3], least[k / 8][k % 8]);
          sum += poison[k % 8];
        }
        Course& course = courses_[run];
        const Eigen::Vector3d middle = 0.5 * (high + low);
        course.middle += middle;
        // Rounding of the sum belongs to it.
        addRoundedUp(course.about,
                     std::isfinite(sum) ? 0.5 * (high - low).norm() + 2e-16 * course.middle.lpNorm<1>() : infinite);
      },
      16);
  addRoundedUp(turned_, motion.A.norm());
}

}  // namespace ringwatch

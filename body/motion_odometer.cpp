#include <ringwatch/body/motion_odometer.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <ringwatch/base/parallel.h>
#include <ringwatch/body/affine_motion.h>

namespace ringwatch {
namespace {

constexpr std::size_t runNodes = 128;
constexpr double infinite = std::numeric_limits<double>::infinity();

/// Long runs add many small numbers.
void addRoundedUp(double& sum, double part) {
  if (part > 0) sum = std::nextafter(sum + part, infinite);
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
  if (advances_++ == 0) {
    for (std::size_t i = 0; i < nodes_.size(); ++i) std::copy_n(x.col(nodes_[i]).data(), 3, before_.data() + 3 * i);
    if (!x.allFinite())
      for (Course& course : courses_) course.about = infinite;
    return;
  }
  constexpr std::size_t leastNodes = 16, share = 128;
  const AffineMotion motion =
      fitAffineMotion({nodes_.data(), before_.data(), nodes_.size()}, x, std::max(leastNodes, nodes_.size() / share));
  const ResidualsOf residualsOf(motion);
  parallelFor(
      0, static_cast<std::int64_t>(courses_.size()), threads_,
      [&](std::int64_t index) {
        const auto run = static_cast<std::size_t>(index);
        const std::size_t begin = runBegin_[run];
        const Residuals residuals =
            residualsOf({nodes_.data() + begin, before_.data() + 3 * begin, runBegin_[run + 1] - begin}, x, true);
        Course& course = courses_[run];
        course.middle += residuals.middle;
        // Rounding of the sum belongs to it.
        addRoundedUp(course.about, residuals.about + 2e-16 * course.middle.lpNorm<1>());
      },
      16);
  addRoundedUp(turned_, motion.A.norm());
}

}  // namespace ringwatch

#include <ringwatch/body/deformation_watch.h>

#include <algorithm>
#include <limits>

#include <ringwatch/body/affine_motion.h>

namespace ringwatch {
namespace {

void takeOnce(std::vector<std::int32_t>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

}  // namespace

DeformationWatch::DeformationWatch(const ElementBlock& block, const MotionOdometer& odometer) {
  constexpr int lanes = PatchLayout::lanes;
  const PatchLayout& layout = block.layout();
  const auto n = static_cast<std::size_t>(block.element().nodes);
  const auto batches = static_cast<std::size_t>(layout.batchCount());
  anchor.assign(batches * block.rule().points.size() * 9 * lanes, 0.0F);
  radius.assign(batches * lanes, -1.0F);
  inverseGradientNorm.resize(batches * lanes);
  double norms[lanes];
  for (std::int32_t batch = 0; batch < layout.batchCount(); ++batch) {
    block.gradientNormBatch(batch, norms);
    for (int lane = 0; lane < lanes; ++lane) {
      const auto place = static_cast<std::size_t>(batch * lanes + lane);
      inverseGradientNorm[place] = static_cast<float>((1 - 1e-6) / norms[lane]);  // rounded down
      if (layout.elements[place] < 0) radius[place] = std::numeric_limits<float>::infinity();
    }
  }
  patchGroups.push_back(0);
  std::vector<std::int32_t> touched;
  for (const Patch& patch : layout.patches) {
    for (std::int32_t first = patch.batchBegin; first < patch.batchEnd; first += groupBatches) {
      Group group;
      group.batchBegin = first;
      group.batchEnd = std::min(patch.batchEnd, first + groupBatches);
      touched.clear();
      for (std::size_t i = static_cast<std::size_t>(first) * n * lanes;
           i < static_cast<std::size_t>(group.batchEnd) * n * lanes; ++i)
        touched.push_back(layout.nodes[static_cast<std::size_t>(patch.nodeBegin) + layout.localNodes[i]]);
      takeOnce(touched);
      group.nodeBegin = nodes.size();
      nodes.insert(nodes.end(), touched.begin(), touched.end());
      while (nodes.size() % 8 != 0) nodes.push_back(touched.back());
      group.nodeEnd = nodes.size();
      for (std::int32_t& node : touched) node = odometer.runOf(node);
      takeOnce(touched);
      group.runBegin = runs.size();
      runs.insert(runs.end(), touched.begin(), touched.end());
      group.runEnd = runs.size();
      groups.push_back(group);
    }
    patchGroups.push_back(static_cast<std::int32_t>(groups.size()));
  }
  since.resize(runs.size());
  before.resize(3 * nodes.size());
}

void DeformationWatch::noteBall(std::size_t place, const MotionOdometer& odometer) {
  const auto group =
      std::upper_bound(groups.begin(), groups.end(), static_cast<std::int32_t>(place / PatchLayout::lanes),
                       [](std::int32_t batch, const Group& g) { return batch < g.batchEnd; });
  // The room counts from the positions of the last look: only when that was now does the ball fit in.
  const double room = group->lookedAt == odometer.advances()
                          ? static_cast<double>(radius[place]) * static_cast<double>(inverseGradientNorm[place])
                          : -1;
  group->roomAtLook = std::min(group->roomAtLook, room);
  group->room = std::min(group->room, room);
}

bool DeformationWatch::rests(Group& group, const MotionOdometer& odometer, const NodeVectors& x) {
  if (group.roomAtLook < 0) return false;
  if (restsByOdometer(group, odometer)) {
    noteRest(group);
    return true;
  }
  const double left = roomLeft(group, x);
  if (!(left >= 0)) return false;  // NaN among them
  setRoom(group, left, odometer);
  noteRest(group);
  return true;
}

double DeformationWatch::roomLeft(Group& group, const NodeVectors& x) {
  constexpr std::size_t sample = 24;  // nodes
  const TrackedNodes tracked{nodes.data() + group.nodeBegin, before.data() + 3 * group.nodeBegin,
                             group.nodeEnd - group.nodeBegin};
  const auto leftBy = [&](const AffineMotion& motion) {
    const Residuals residuals = ResidualsOf(motion)(tracked, x, false);
    // Rounding of positions and of their differences.
    const double rounding = 1e-15 * (motion.centre.lpNorm<1>() + motion.translation.lpNorm<1>());
    return group.roomAtLook * (1 - 1e-9) - motion.A.norm() * group.reach - residuals.about - rounding;
  };
  // Any motion will do, and the last one fitted is mostly good enough. The residuals' middle takes up a translation.
  AffineMotion motion;
  motion.centre = Eigen::Map<const Eigen::Vector3d>(tracked.before);
  motion.translation = x.col(tracked.nodes[0]) - motion.centre;
  motion.A = group.turn;
  const double left = leftBy(motion);
  if (left >= 0) return left;
  motion = fitAffineMotion(tracked, x, sample);
  group.turn = motion.A;
  return leftBy(motion);
}

bool DeformationWatch::restsByOdometer(const Group& group, const MotionOdometer& odometer) const {
  const double room = group.room * (1 - 1e-9) - (odometer.turned() - group.turnedSince) * group.reach;
  Eigen::Vector3d common = Eigen::Vector3d::Zero();
  for (std::size_t k = group.runBegin; k < group.runEnd; ++k)
    common += odometer.courses()[static_cast<std::size_t>(runs[k])].middle - since[k].middle;
  common /= static_cast<double>(group.runEnd - group.runBegin);
  for (std::size_t k = group.runBegin; k < group.runEnd; ++k) {
    const MotionOdometer::Course& now = odometer.courses()[static_cast<std::size_t>(runs[k])];
    const double left = room - (now.about - since[k].about);
    // A NaN fails both comparisons.
    if (!(left >= 0) || !((now.middle - since[k].middle - common).squaredNorm() <= left * left)) return false;
  }
  return true;
}

void DeformationWatch::startRest(Group& group, double room, double reach, const MotionOdometer& odometer,
                                 const NodeVectors& x) {
  // Where elements leave their balls at every step, trying to rest costs as much as looking.
  constexpr int longestPause = 15;
  if (!group.rested) {
    group.rested = true;
    group.pause = static_cast<std::int16_t>(std::min(2 * group.pause + 1, longestPause));
    group.waits = group.pause;
  }
  if (group.waits > 0) {
    --group.waits;
    group.roomAtLook = -1;
    return;
  }
  group.rested = false;
  group.roomAtLook = room;
  group.lookedAt = odometer.advances();
  group.turn.setZero();
  group.reach = std::min(reach + room, 1e100);  // times no turn at all it must be nothing
  for (std::size_t i = group.nodeBegin; i < group.nodeEnd; ++i)
    std::copy_n(x.col(nodes[i]).data(), 3, before.data() + 3 * i);
  setRoom(group, room, odometer);
}

void DeformationWatch::setRoom(Group& group, double room, const MotionOdometer& odometer) {
  group.room = room;
  group.turnedSince = odometer.turned();
  for (std::size_t k = group.runBegin; k < group.runEnd; ++k)
    since[k] = odometer.courses()[static_cast<std::size_t>(runs[k])];
}

}  // namespace ringwatch

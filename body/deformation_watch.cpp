#include <ringwatch/body/deformation_watch.h>

#include <algorithm>
#include <limits>

namespace ringwatch {

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
        touched.push_back(
            odometer.runOf(layout.nodes[static_cast<std::size_t>(patch.nodeBegin) + layout.localNodes[i]]));
      std::sort(touched.begin(), touched.end());
      group.runBegin = runs.size();
      runs.insert(runs.end(), touched.begin(), std::unique(touched.begin(), touched.end()));
      group.runEnd = runs.size();
      groups.push_back(group);
    }
    patchGroups.push_back(static_cast<std::int32_t>(groups.size()));
  }
  since.resize(runs.size());
}

void DeformationWatch::lookAtBatch(std::int32_t batch) {
  const auto group = std::upper_bound(groups.begin(), groups.end(), batch,
                                      [](std::int32_t at, const Group& g) { return at < g.batchEnd; });
  group->room = -1;
}

bool DeformationWatch::rests(const Group& group, const MotionOdometer& odometer) const {
  if (group.room < 0) return false;
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

void DeformationWatch::startRest(Group& group, double room, double reach, const MotionOdometer& odometer) {
  group.room = room;
  group.reach = std::min(reach + room, 1e100);  // times no turn at all it must be nothing
  group.turnedSince = odometer.turned();
  for (std::size_t k = group.runBegin; k < group.runEnd; ++k)
    since[k] = odometer.courses()[static_cast<std::size_t>(runs[k])];
}

}  // namespace ringwatch

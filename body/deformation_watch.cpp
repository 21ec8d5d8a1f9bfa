#include <ringwatch/body/deformation_watch.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include <Eigen/Dense>

namespace ringwatch {
namespace {

constexpr int lanes = PatchLayout::lanes;
constexpr double infinite = std::numeric_limits<double>::infinity();

void takeOnce(std::vector<std::uint16_t>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

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
Eigen::Matrix3d fittedTurn(const TrackedNodes& tracked) {
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
    most[half] = Row8{} - infinite;
    least[half] = Row8{} + infinite;
  }
  for (std::size_t i = 0; i < tracked.count; i += 4)
    for (std::size_t half = 0; half < 2; ++half) {
      // The fourth number of a float row is the next node's; nobody looks at what becomes of it.
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
  double size2 = 0, poison = 0;
  for (int k = 0; k < 3; ++k) {
    const double size = std::max({most[0][k], most[0][k + 4], most[1][k], most[1][k + 4]}) -
                        std::min({least[0][k], least[0][k + 4], least[1][k], least[1][k + 4]});
    size2 += size * size;
    poison += sum[0][k] + sum[0][k + 4] + sum[1][k] + sum[1][k + 4];
  }
  return std::isfinite(poison) ? 0.5 * std::sqrt(size2) : infinite;
}

}  // namespace

DeformationWatch::DeformationWatch(const ElementBlock& block) {
  const PatchLayout& layout = block.layout();
  const auto n = static_cast<std::size_t>(block.element().nodes);
  const auto batches = static_cast<std::size_t>(layout.batchCount());
  anchor.assign(batches * block.rule().points.size() * 9 * lanes, 0);
  radius.assign(batches * lanes, Bfloat16::down(-1));
  inverseGradientNorm.resize(batches * lanes);
  double norms[lanes];
  for (std::int32_t batch = 0; batch < layout.batchCount(); ++batch) {
    block.gradientNormBatch(batch, norms);
    for (int lane = 0; lane < lanes; ++lane) {
      const auto place = static_cast<std::size_t>(batch * lanes + lane);
      inverseGradientNorm[place] = Bfloat16::down(1 / norms[lane]);
      if (layout.elements[place] < 0) radius[place] = Bfloat16::down(infinite);
    }
  }
  patchGroups.push_back(0);
  std::vector<std::uint16_t> touched;
  for (const Patch& patch : layout.patches) {
    for (std::int32_t first = patch.batchBegin; first < patch.batchEnd; first += groupBatches) {
      Group group;
      group.batchBegin = first;
      group.batchEnd = std::min(patch.batchEnd, first + groupBatches);
      const auto begin = layout.localNodes.begin();
      touched.assign(begin + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(first) * n * lanes),
                     begin + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(group.batchEnd) * n * lanes));
      takeOnce(touched);
      group.nodeBegin = nodes.size();
      nodes.insert(nodes.end(), touched.begin(), touched.end());
      while (nodes.size() % 4 != 0) nodes.push_back(touched.back());
      group.nodeEnd = nodes.size();
      groups.push_back(group);
    }
    patchGroups.push_back(static_cast<std::int32_t>(groups.size()));
  }
  nodes.shrink_to_fit();
  before.resize(3 * nodes.size() + 1);
}

double DeformationWatch::setAnchor(std::size_t place, const double* F0, int points, int lane) {
  double farthest2 = 0;
  for (int q = 0; q < points; ++q) {
    std::int16_t* target =
        anchor.data() + (place / lanes * static_cast<std::size_t>(points) + static_cast<std::size_t>(q)) * 9 * lanes +
        place % lanes;
    double distance2 = 0;
    for (int i = 0; i < 9; ++i) {
      const double entry = F0[(9 * q + i) * lanes + lane];
      if (!(std::abs(entry) <= mostAnchored)) return infinite;
      const double units = std::nearbyint(entry * (1 / anchorUnit)), off = units * anchorUnit - entry;
      target[i * lanes] = static_cast<std::int16_t>(units);
      distance2 += off * off;
    }
    farthest2 = std::max(farthest2, distance2);
  }
  return std::sqrt(farthest2) * (1 + 1e-15);
}

void DeformationWatch::setRadius(std::size_t place, double aroundF0, double fromAnchor) {
  const double own = std::min(aroundF0, 1e30) - fromAnchor;
  radius[place] = Bfloat16::down(own >= 0 ? own : -1);
}

void DeformationWatch::noteBall(std::size_t place) {
  const auto group =
      std::upper_bound(groups.begin(), groups.end(), static_cast<std::int32_t>(place / PatchLayout::lanes),
                       [](std::int32_t batch, const Group& g) { return batch < g.batchEnd; });
  // The room counts from the positions of the last look: only when that was now does the ball fit in. What is left of
  // it at the anchor is less by how far the anchor lies from F0.
  const double room =
      group->lookedAt == looks ? (radius[place] - anchorError) * static_cast<double>(inverseGradientNorm[place]) : -1;
  group->roomAtLook = std::min(group->roomAtLook, room);
}

bool DeformationWatch::rests(Group& group, const double* rows) const {
  if (group.roomAtLook < 0 || !(roomLeft(group, rows) >= 0)) return false;  // NaN among them
  group.rested = true;
  group.pause = 0;
  return true;
}

double DeformationWatch::roomLeft(Group& group, const double* rows) const {
  const TrackedNodes tracked{nodes.data() + group.nodeBegin, before.data() + 3 * group.nodeBegin,
                             group.nodeEnd - group.nodeBegin, group.centre, rows};
  const double moved = tracked.moved(0).lpNorm<1>();
  const auto leftBy = [&](const Eigen::Matrix3d& A) {
    const double turned = A.norm();
    // Rounding of positions and of their differences.
    const double rounding = group.rounding * (1 + turned) + 1e-15 * (group.centre.lpNorm<1>() + moved);
    return group.roomAtLook * (1 - 1e-9) - turned * group.reach - residual(tracked, A) - rounding;
  };
  // Any motion will do, and the last one fitted is mostly good enough.
  const double left = leftBy(group.turn);
  if (left >= 0) return left;
  group.turn = fittedTurn(tracked);
  return leftBy(group.turn);
}

void DeformationWatch::startRest(Group& group, double room, double reach, const double* rows) {
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
  group.lookedAt = looks;
  group.turn.setZero();
  group.reach = std::min(reach, 1e100);  // times no turn at all it must be nothing
  group.centre = Eigen::Map<const Eigen::Vector3d>(rows + 4 * nodes[group.nodeBegin]);
  float most = 0;
  for (std::size_t i = group.nodeBegin; i < group.nodeEnd; ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      const auto from = static_cast<float>(rows[4 * nodes[i] + c] - group.centre[static_cast<Eigen::Index>(c)]);
      before[3 * i + c] = from;
      most = std::max(most, std::abs(from));
    }
  group.rounding = 1.1e-7 * static_cast<double>(most);
}

}  // namespace ringwatch

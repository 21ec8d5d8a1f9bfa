#include <ringwatch/gpu/certificate/device_certificate.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include <ringwatch/base/infinity.h>
#include <ringwatch/gpu/certificate/device_certificate_impl.h>
#include <ringwatch/gpu/device_status.h>
#include <ringwatch/monitor/incremental/rebuild_policy.h>

namespace ringwatch {
namespace {
constexpr RebuildPolicy policy;
constexpr CertificateFlags noFlags{0, -1, 0, 0};
/// In bodies of so many patches the time that a few evaluations take is small beside a step, and where many elements
/// leave at a time they take work, which would be done twice.
constexpr std::int32_t patchesOfLargeBodies = 4000;
constexpr std::size_t wordsOfBall = 5, bytesOfBall = wordsOfBall * sizeof(std::uint32_t);
}  // namespace

DeviceCertificate::Impl::Part::Part(DevicePart<double>& of, bool besideNext) : body(of) {
  const std::size_t lists = besideNext ? 2 : 1;
  const std::size_t count = body.nodeCount;
  std::size_t need = (body.slots.size() * 6 + count * 13) * sizeof(double) +
                     SlotExchange::bytesOnDevice(body.exchanges, 6 * sizeof(double));
  const auto capacityOf = [](const auto& from) {
    // When more elements leave at once than this, evaluating them one by one is no longer worth it.
    return static_cast<std::size_t>(std::max(4096, from.view.patchCount * from.threads / 16));
  };
  const auto ballsOf = [](const auto& from) { return static_cast<std::size_t>(ballsOfPoints(from.points)); };
  for (const auto& from : body.blocks) {
    const std::size_t places = static_cast<std::size_t>(from.view.patchCount) * static_cast<std::size_t>(from.threads),
                      points = static_cast<std::size_t>(from.points);
    need +=
        places * (static_cast<std::size_t>(6 * from.elementNodes + 3) * sizeof(double) + ballsOf(from) * bytesOfBall) +
        capacityOf(from) * lists * (9 * points * sizeof(double) + sizeof(std::int32_t) + ballsOf(from) * bytesOfBall);
  }
  requireDeviceMemory(need);
  flags = DeviceVector<CertificateFlags>(std::vector<CertificateFlags>{noFlags});
  for (const auto& from : body.blocks) {
    Block& block = blocks.emplace_back();
    const std::size_t places = static_cast<std::size_t>(from.view.patchCount) * static_cast<std::size_t>(from.threads),
                      points = static_cast<std::size_t>(from.points), capacity = capacityOf(from);
    block.operations = certificateOperations(from.type, from.lawIndex);
    block.elementNodes = from.elementNodes;
    block.weights = DeviceVector<double>(places * static_cast<std::size_t>(6 * from.elementNodes));
    block.value = DeviceVector<double>(places);
    block.allowance = DeviceVector<double>(places);
    block.strainNorm = DeviceVector<double>(places);
    block.balls = DeviceVector<std::uint32_t>(places * points * wordsOfBall);
    if (points > 1) block.centres = DeviceVector<std::uint32_t>(places * wordsOfBall);
    block.outsidePlace = DeviceVector<std::int32_t>(lists * capacity);
    block.outsideF = DeviceVector<double>(lists * capacity * points * 9);
    if (besideNext) block.newBalls = DeviceVector<std::uint32_t>(lists * capacity * ballsOf(from) * wordsOfBall);
    enum : std::size_t { done, ofLists };
    block.counters = DeviceVector<unsigned>(std::vector<unsigned>(ofLists + lists, 0));
    for (std::size_t list = 0; list < lists; ++list)
      block.views[list] = {
          .weights = block.weights.data(),
          .value = block.value.data(),
          .allowance = block.allowance.data(),
          .strainNorm = block.strainNorm.data(),
          .balls = block.balls.data(),
          .centres = points > 1 ? block.centres.data() : block.balls.data(),
          .outsidePlace = block.outsidePlace.data() + list * capacity,
          .outsideF = block.outsideF.data() + list * capacity * points * 9,
          .outsideCount = block.counters.data() + ofLists + list,
          .newBalls = besideNext ? block.newBalls.data() + list * capacity * ballsOf(from) * wordsOfBall : nullptr,
          .done = block.counters.data() + done,
          .capacity = static_cast<std::int32_t>(capacity),
          .flags = flags.data()};
  }
  // Blocks are refreshed one after the other: the last one closes the step.
  for (std::size_t b = blocks.size(); b-- > 0;)
    if (body.blocks[b].view.patchCount > 0) {
      for (CertificateView& view : blocks[b].views) view.countsSteps = true;
      break;
    }
  placed = DeviceVector<unsigned>(std::vector<unsigned>{0});
  for (std::size_t list = 0; besideNext && list < lists; ++list) {
    std::vector<BallPlacement> ofBlocks;
    for (std::size_t b = 0; b < blocks.size(); ++b)
      if (body.blocks[b].view.patchCount > 0)
        ofBlocks.push_back({blocks[b].views[list], body.blocks[b].threads, body.blocks[b].points});
    placementOfBlock[list] = DeviceVector<BallPlacement>(ofBlocks);
    placements[list] = {placementOfBlock[list].data(), static_cast<int>(ofBlocks.size()), placed.data()};
  }
  slots = DeviceVector<double>(body.slots.size() * 6);
  nodeSums = DeviceVector<double>(count * 6);
  factors = DeviceVector<double>(count * 6);
  nodal = DeviceVector<double>(count);
  boundBits = DeviceVector<unsigned long long>(1);
  nodeSums.fill(0);
  sums = {slots.data(), nodeSums.data(), factors.data(), nodal.data(), boundBits.data()};
}

DeviceCertificate::Impl::Impl(DeviceBody<double>& deviceBody, std::optional<bool> wanted)
    : body(deviceBody.impl()), besideNext(wanted.value_or(body.patchCount < patchesOfLargeBodies)) {
  std::vector<SlotExchange::Part> ends;
  body.forEachPart([&](DevicePart<double>& part) {
    parts.push_back(std::make_unique<Part>(part, besideNext));
    ends.push_back({part.device, part.stream, parts.back()->slots.data(), &part.exchanges});
  });
  exchange = std::make_unique<SlotExchange>(ends, 6 * sizeof(double));
}

void DeviceCertificate::Impl::launch(CertificateOperations::Launch CertificateOperations::*which, double forSigma) {
  for (const auto& part : parts) {
    const OnDevice here(part->body.device);
    for (std::size_t b = 0; b < part->blocks.size(); ++b)
      if (part->body.blocks[b].view.patchCount > 0)
        (part->blocks[b].operations.*which)(part->arguments(b, forSigma, part->body.stream));
  }
}

double DeviceCertificate::Impl::boundOf(DeviceVector<double> Block::*values) {
  const auto gather = [&](std::size_t p, std::size_t b) {
    Part& part = *parts[p];
    launchGatherWeights(part.body.blocks[b].view, part.body.nodes, part.blocks[b].views[0], part.sums,
                        part.blocks[b].elementNodes, (part.blocks[b].*values).data(), part.body.stream);
  };
  const auto bound = [&](std::size_t p) {
    launchBoundNodes(parts[p]->body.nodes, parts[p]->sums, parts[p]->body.stream);
  };
  body.enqueue(
      *exchange, gather, [](std::size_t) {}, bound);
  // As bits these numbers, none of which is negative, order as they do themselves, and NaN lies above all.
  unsigned long long largest = 0;
  for (const auto& part : parts) {
    const OnDevice here(part->body.device);
    part->body.stream.synchronize();
    largest = std::max(largest, part->boundBits.download().front());
  }
  return std::bit_cast<double>(largest);
}

double DeviceCertificate::Impl::evaluate() {
  launch(&CertificateOperations::evaluate, 0);
  tight = boundOf(&Block::value);
  return tight;
}

void DeviceCertificate::Impl::distribute(double forSigma) {
  sigma = forSigma;
  launch(&CertificateOperations::distribute, sigma);
  for (const auto& part : parts) {
    const OnDevice here(part->body.device);
    part->body.stream.synchronize();
    part->flags.upload(std::vector<CertificateFlags>{noFlags});
    for (Block& block : part->blocks) block.counters.fill(0);
  }
  certified = true;
}

double DeviceCertificate::Impl::verify() {
  evaluate();
  double excess = -1;
  for (const auto& part : parts)
    for (const Block& block : part->blocks) {
      const std::vector<double> value = block.value.download(), allowance = block.allowance.download();
      for (std::size_t place = 0; place < value.size(); ++place) {  // without an element: zero
        if (std::isnan(value[place])) return infinity;
        if (value[place] > 0) excess = std::max(excess, value[place] / allowance[place] - 1);
      }
    }
  return std::max(excess, boundOf(&Block::allowance) / sigma - 1);
}

void DeviceCertificate::Impl::enqueueSteps(std::int64_t count) {
  for (std::int64_t k = 0; k < count; ++k) {
    const std::size_t list = besideNext ? k % 2 : 0, before = 1 - list;
    const auto step = [&](std::size_t p, std::size_t b) {
      if (parts[p]->body.blocks[b].view.patchCount > 0)
        parts[p]->blocks[b].operations.step(parts[p]->arguments(b, sigma, parts[p]->body.stream, list));
    };
    const auto refresh = [&](std::size_t p) {
      Part& part = *parts[p];
      part.forked.record(part.body.stream);
      part.forked.holdUp(part.side);
      for (std::size_t b = 0; b < part.blocks.size(); ++b)
        if (part.body.blocks[b].view.patchCount > 0)
          part.blocks[b].operations.refresh(part.arguments(b, sigma, part.side, list));
      part.joined[list].record(part.side);
    };
    const auto finish = [&](std::size_t p) {
      Part& part = *parts[p];
      if (besideNext && k > 0) {
        part.joined[before].holdUp(part.body.stream);
        launchFinishStepAndPlace(part.body.nodes, part.placements[before], part.body.stream);
      } else {
        launchFinishStep<double>(part.body.nodes, part.body.stream);
        if (!besideNext) part.joined[list].holdUp(part.body.stream);
      }
    };
    body.enqueue(*body.exchange, step, refresh, finish);
  }
  if (!besideNext) return;
  const std::size_t last = (count - 1) % 2;
  for (const auto& part : parts) {
    const OnDevice here(part->body.device);
    part->joined[last].holdUp(part->body.stream);
    launchPlaceBalls(part->placements[last], part->body.stream);
  }
}

CertificateFlags DeviceCertificate::Impl::flags() const {
  CertificateFlags all = noFlags;
  for (const auto& part : parts) {
    const OnDevice here(part->body.device);
    part->body.stream.synchronize();
    const CertificateFlags own = part->flags.download().front();
    all.checked = std::max(all.checked, own.checked);
    if (own.lostAt >= 0) all.lostAt = all.lostAt < 0 ? own.lostAt : std::min(all.lostAt, own.lostAt);
    all.evaluated += own.evaluated;
    all.nearlyLost |= own.nearlyLost;
  }
  return all;
}

DeviceCertificate::DeviceCertificate(DeviceBody<double>& body, std::optional<bool> besideNext)
    : impl_(std::make_unique<Impl>(body, besideNext)) {}
DeviceCertificate::~DeviceCertificate() {
  for (const auto& part : impl_->parts) cudaStreamSynchronize(part->body.stream);
}

UpperBound DeviceCertificate::bound(int sweeps) {
  impl_->certified = false;
  impl_->launch(&CertificateOperations::start, 0);
  double best = infinity, bound = 0;
  for (int sweep = 0;; ++sweep) {
    bound = impl_->evaluate();
    impl_->started = std::isfinite(bound);
    if (!impl_->started) return {std::numeric_limits<double>::quiet_NaN()};
    best = std::min(best, bound);
    if (sweep == sweeps || !(bound > 0)) break;
    for (const auto& part : impl_->parts) {
      const OnDevice here(part->body.device);
      launchSweepFactors(part->body.nodes, part->sums, bound, part->body.stream);
    }
    impl_->launch(&CertificateOperations::sweep, 0);
  }
  return {best};
}

bool DeviceCertificate::certify(double sigma) {
  if (!(sigma > 0)) throw InputError(joinText("sigma ", sigma, " rad2/s2 must be > 0"));
  impl_->certified = false;
  double tight = impl_->started ? impl_->evaluate() : infinity;
  if (!(tight <= sigma * (1 - policy.proofMargin))) {
    bound(policy.sweeps);
    tight = impl_->tight;  // allowances need the values and sums of the last weights, which the last evaluation left
  }
  if (!impl_->started || !(tight <= sigma * (1 - policy.proofMargin))) return false;
  impl_->distribute(sigma);
  return true;
}
bool DeviceCertificate::renew() { return certify(impl_->sigma); }

void DeviceCertificate::step(double h, std::int64_t count) {
  impl_->body.setStep(h);
  impl_->body.repeat(count, impl_->graphs, [&](std::int64_t steps) { impl_->enqueueSteps(steps); });
}

DeviceCertificate::Status DeviceCertificate::status() const {
  const CertificateFlags flags = impl_->flags();
  return {impl_->certified && flags.lostAt < 0, flags.lostAt, flags.checked, static_cast<std::int64_t>(flags.evaluated),
          flags.nearlyLost != 0};
}

}  // namespace ringwatch

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
}  // namespace

DeviceCertificate::Impl::Impl(DeviceBody<double>& deviceBody) : body(deviceBody.impl()) {
  const std::size_t count = body.nodeCount;
  std::size_t need = (body.slots.size() * 6 + count * 13) * sizeof(double);
  const auto capacityOf = [](const auto& from) {
    // When more elements leave at once than this, evaluating them one by one is no longer worth it.
    return static_cast<std::size_t>(std::max(4096, from.view.patchCount * from.threads / 16));
  };
  for (const auto& from : body.blocks) {
    const std::size_t places = static_cast<std::size_t>(from.view.patchCount) * static_cast<std::size_t>(from.threads),
                      points = static_cast<std::size_t>(from.points);
    need += places * (static_cast<std::size_t>(6 * from.elementNodes + 3) * sizeof(double) + points * 20) +
            capacityOf(from) * (9 * points * sizeof(double) + 4);
  }
  requireDeviceMemory(need);
  flags = DeviceVector<CertificateFlags>(std::vector<CertificateFlags>{{0, -1, 0, 0}});
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
    block.balls = DeviceVector<std::uint32_t>(places * points * 5);
    block.outsidePlace = DeviceVector<std::int32_t>(capacity);
    block.outsideF = DeviceVector<double>(capacity * points * 9);
    block.counters = DeviceVector<unsigned>(std::vector<unsigned>{0, 0});
    block.view = {block.weights.data(),
                  block.value.data(),
                  block.allowance.data(),
                  block.strainNorm.data(),
                  block.balls.data(),
                  block.outsidePlace.data(),
                  block.outsideF.data(),
                  block.counters.data(),
                  block.counters.data() + 1,
                  static_cast<std::int32_t>(capacity),
                  flags.data(),
                  false};
  }
  // Blocks are refreshed one after the other: the last one closes the step.
  for (std::size_t b = blocks.size(); b-- > 0;)
    if (body.blocks[b].view.patchCount > 0) {
      blocks[b].view.countsSteps = true;
      break;
    }
  slots = DeviceVector<double>(body.slots.size() * 6);
  nodeSums = DeviceVector<double>(count * 6);
  factors = DeviceVector<double>(count * 6);
  nodal = DeviceVector<double>(count);
  boundBits = DeviceVector<unsigned long long>(1);
  nodeSums.fill(0);
  sums = {slots.data(), nodeSums.data(), factors.data(), nodal.data(), boundBits.data()};
  checkCuda(cudaStreamCreateWithFlags(&side, cudaStreamNonBlocking), "cudaStreamCreate");
  checkCuda(cudaEventCreateWithFlags(&forked, cudaEventDisableTiming), "cudaEventCreate");
  checkCuda(cudaEventCreateWithFlags(&joined, cudaEventDisableTiming), "cudaEventCreate");
}

void DeviceCertificate::Impl::launch(CertificateOperations::Launch CertificateOperations::*which, double forSigma) {
  for (std::size_t b = 0; b < blocks.size(); ++b)
    if (body.blocks[b].view.patchCount > 0)
      (blocks[b].operations.*
       which)({body.blocks[b].view, body.nodes, body.blocks[b].law, blocks[b].view, sums, forSigma, body.stream});
}

double DeviceCertificate::Impl::evaluate() {
  launch(&CertificateOperations::evaluate, 0);
  for (std::size_t b = 0; b < blocks.size(); ++b)
    launchGatherWeights(body.blocks[b].view, body.nodes, blocks[b].view, sums, blocks[b].elementNodes,
                        blocks[b].value.data(), body.stream);
  launchBoundNodes(body.nodes, sums, body.stream);
  body.stream.synchronize();
  return std::bit_cast<double>(boundBits.download().front());
}

void DeviceCertificate::Impl::distribute(double forSigma) {
  sigma = forSigma;
  launch(&CertificateOperations::distribute, sigma);
  body.stream.synchronize();
  flags.upload(std::vector<CertificateFlags>{{0, -1, 0, 0}});
  for (Block& block : blocks) block.counters.fill(0);
  certified = true;
}

double DeviceCertificate::Impl::verify() {
  evaluate();
  double excess = -1;
  for (Block& block : blocks) {
    const std::vector<double> value = block.value.download(), allowance = block.allowance.download();
    for (std::size_t place = 0; place < value.size(); ++place) {  // without an element: zero
      if (std::isnan(value[place])) return infinity;
      if (value[place] > 0) excess = std::max(excess, value[place] / allowance[place] - 1);
    }
  }
  for (std::size_t b = 0; b < blocks.size(); ++b)
    launchGatherWeights(body.blocks[b].view, body.nodes, blocks[b].view, sums, blocks[b].elementNodes,
                        blocks[b].allowance.data(), body.stream);
  launchBoundNodes(body.nodes, sums, body.stream);
  body.stream.synchronize();
  return std::max(excess, std::bit_cast<double>(boundBits.download().front()) / sigma - 1);
}

void DeviceCertificate::Impl::enqueueStep() {
  launch(&CertificateOperations::step, sigma);
  // What has left is evaluated beside the step of the shared nodes: it needs no positions, only what was noted.
  checkCuda(cudaEventRecord(forked, body.stream), "cudaEventRecord");
  checkCuda(cudaStreamWaitEvent(side, forked, 0), "cudaStreamWaitEvent");
  for (std::size_t b = 0; b < blocks.size(); ++b)
    if (body.blocks[b].view.patchCount > 0)
      blocks[b].operations.refresh(
          {body.blocks[b].view, body.nodes, body.blocks[b].law, blocks[b].view, sums, sigma, side});
  checkCuda(cudaEventRecord(joined, side), "cudaEventRecord");
  launchFinishStep<double>(body.nodes, body.stream);
  checkCuda(cudaStreamWaitEvent(body.stream, joined, 0), "cudaStreamWaitEvent");
}

DeviceCertificate::DeviceCertificate(DeviceBody<double>& body) : impl_(std::make_unique<Impl>(body)) {}
DeviceCertificate::~DeviceCertificate() {
  cudaStreamSynchronize(impl_->body.stream);
  cudaStreamDestroy(impl_->side);
  cudaEventDestroy(impl_->forked);
  cudaEventDestroy(impl_->joined);
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
    launchSweepFactors(impl_->body.nodes, impl_->sums, bound, impl_->body.stream);
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
    // Allowances need the values and sums of the last weights, which the last evaluation left.
    tight = std::bit_cast<double>(impl_->boundBits.download().front());
  }
  if (!impl_->started || !(tight <= sigma * (1 - policy.proofMargin))) return false;
  impl_->distribute(sigma);
  return true;
}
bool DeviceCertificate::renew() { return certify(impl_->sigma); }

void DeviceCertificate::step(double h, std::int64_t count) {
  impl_->body.setStep(h);
  impl_->body.repeat(count, impl_->graphs, [&] { impl_->enqueueStep(); });
}

DeviceCertificate::Status DeviceCertificate::status() const {
  impl_->body.stream.synchronize();
  const CertificateFlags flags = impl_->flags.download().front();
  return {impl_->certified && flags.lostAt < 0, flags.lostAt, flags.checked, static_cast<std::int64_t>(flags.evaluated),
          flags.nearlyLost != 0};
}

}  // namespace ringwatch

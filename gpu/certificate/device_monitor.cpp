#include <ringwatch/gpu/certificate/device_monitor.h>

#include <algorithm>
#include <cmath>
#include <span>

#include <ringwatch/base/error.h>
#include <ringwatch/gpu/body/device_body_impl.h>
#include <ringwatch/gpu/certificate/device_certificate.h>
#include <ringwatch/gpu/certificate/device_positions.h>
#include <ringwatch/monitor/step_limit.h>

namespace ringwatch {

struct DeviceMonitor::Impl {
  Impl(const Body& body, double limitOfScheme)
      : limit(limitOfScheme),
        device(body),
        part(device.impl().only("a monitor of positions on a device")),
        certificate(device),
        meshNode(part.meshNode),
        reference(std::span<const double>(part.X.data(), static_cast<std::size_t>(part.X.size()))) {}

  void take(const double* x) { launchTakePositions(part.nodes, meshNode.data(), reference.data(), x, part.stream); }

  double limit;
  DeviceBody<double> device;
  DevicePart<double>& part;  // all of it
  DeviceCertificate certificate;
  DeviceVector<std::int32_t> meshNode;
  DeviceVector<double> reference;
  DeviceEvent reached;
  double sigma = 0;  // rad²/s², for which the certificate is; 0: there is none
  double step = 0;   // s, that it stands for
  std::int64_t evaluated = 0;
};

DeviceMonitor::DeviceMonitor(const Body& body, double limit) {
  if (!(limit > 0) || !std::isfinite(limit))
    throw InputError(joinText("limit = ", limit, ": must be > 0 and finite, an integrator's largest stable h omega"));
  impl_ = std::make_unique<Impl>(body, limit);
}
DeviceMonitor::~DeviceMonitor() = default;

std::int32_t DeviceMonitor::nodeCount() const { return impl_->device.nodeCount(); }
std::uintptr_t DeviceMonitor::stream() const {
  return reinterpret_cast<std::uintptr_t>(static_cast<cudaStream_t>(impl_->part.stream));
}
void DeviceMonitor::waitFor(std::uintptr_t other) {
  impl_->reached.record(reinterpret_cast<cudaStream_t>(other));
  impl_->reached.holdUp(impl_->part.stream);
}

DeviceMonitor::Report DeviceMonitor::observe(const double* x, std::optional<double> h) {
  if (h && (!(*h > 0) || !std::isfinite(*h))) throw InputError(joinText("h = ", *h, " s: must be > 0 and finite"));
  int device = -1;
  checkCuda(cudaGetDevice(&device), "cudaGetDevice");
  cudaPointerAttributes memory{};
  if (cudaPointerGetAttributes(&memory, x) != cudaSuccess) {
    cudaGetLastError();  // clears it
    memory.type = cudaMemoryTypeUnregistered;
  }
  if ((memory.type != cudaMemoryTypeDevice && memory.type != cudaMemoryTypeManaged) || memory.device != device)
    throw InputError(joinText("x: its numbers are not in the memory of GPU ", device, ", on which the body is"));

  Impl& impl = *impl_;
  Report report;
  impl.take(x);
  const double wanted = h ? StepRule(impl.limit).lambdaFor(*h) : 0;
  if (h && impl.sigma > 0 && impl.sigma <= wanted) {
    // A step of no length: the pass that computes forces tests the balls, and positions stay.
    impl.certificate.step(0, 1);
    const DeviceCertificate::Status status = impl.certificate.status();
    report.evaluated = status.evaluated - impl.evaluated;
    impl.evaluated = status.evaluated;
    report.certified = status.certified;
    report.safe = status.certified ? impl.step : 0;
    if (status.certified && !status.nearlyLost) return report;
    impl.take(x);  // the step may have left what is not finite
  }
  report.renewed = true;
  impl.evaluated = 0;
  if (h && impl.certificate.certify(wanted)) {
    impl.sigma = wanted;
    impl.step = *h;
    report.certified = true;
    report.safe = std::max(report.safe, *h);
    return report;
  }
  impl.sigma = 0;
  if (report.certified) return report;  // at this state, though no longer at the next one
  const double bound = impl.certificate.bound().value;
  report.safe = bound > 0 ? stepFor(bound, impl.limit) : 0;
  if (h) report.certified = *h <= report.safe;
  return report;
}

}  // namespace ringwatch

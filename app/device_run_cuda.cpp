#include <ringwatch/app/device_run.h>

#include <fmt/format.h>

#include <ringwatch/gpu/device_certificate.h>
#include <ringwatch/gpu/device_status.h>

namespace ringwatch {
namespace {

class CudaRun final : public DeviceRun {
 public:
  CudaRun(const Body& body, const State& state) : device_(body), certificate_(device_) {
    device_.setPositions(state.x);
    device_.setVelocities(state.v);
  }

  void step(State& state, double h, std::int64_t count, double sigma) override {
    if (sigma > 0) {
      // After a failure, which costs a bound from scratch, the next attempt waits.
      if (!(held_ && sigma == sigma_) && waited_++ % 16 == 0) {
        held_ = certificate_.certify(sigma);
        sigma_ = sigma;
        if (held_) waited_ = 0;
      }
      watched_ += count;
    }
    if (held_ && sigma == sigma_) {
      const DeviceCertificate::Look before = certificate_.look();
      certificate_.step(h, count);
      const DeviceCertificate::Look look = certificate_.look();
      certified_ += look.certified ? count : look.lostAt - before.checked;
      evaluated_ += look.evaluated - before.evaluated;
      if (!look.certified || look.nearlyLost) held_ = certificate_.renew();
    } else {
      device_.step(h, count);
    }
    state.x = device_.positions();
    state.v = device_.velocities();
    state.time += static_cast<double>(count) * h;
  }
  std::string device() const override { return deviceStatus().text; }
  std::string summary() const override {
    std::string text = fmt::format("the steps were taken on {}", device());
    if (watched_ > 0)
      text += fmt::format("; its certificate proved {} of {} steps, {} elements were evaluated for it", certified_,
                          watched_, evaluated_);
    return text;
  }

 private:
  DeviceBody<double> device_;
  DeviceCertificate certificate_;
  double sigma_ = 0;
  bool held_ = false;
  std::int64_t waited_ = 0, watched_ = 0, certified_ = 0, evaluated_ = 0;
};

}  // namespace

std::string whyNoDevice() {
  const DeviceStatus status = deviceStatus();
  return status.available ? "" : status.text;
}
std::unique_ptr<DeviceRun> makeDeviceRun(const Body& body, const State& state) {
  return std::make_unique<CudaRun>(body, state);
}

}  // namespace ringwatch

#include <ringwatch/app/run/device_stepper.h>

#include <numeric>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <ringwatch/gpu/certificate/device_certificate.h>
#include <ringwatch/gpu/device_status.h>
#include <ringwatch/gpu/device_stream.h>
#include <ringwatch/gpu/imex/device_imex.h>
#include <ringwatch/handlers/imex/imex.h>

namespace ringwatch {
namespace {

class DeviceStepper final : public Stepper {
 public:
  DeviceStepper(const Body& body, const State& state, const HandlerOptions& options, const std::vector<int>& devices)
      : current_(devices.front()), body_(body), options_(options), device_(body, devices), certificate_(device_) {
    device_.setPositions(state.x);
    device_.setVelocities(state.v);
  }

  void handle(const std::vector<ElementRef>& elements, double h) override {
    iterations_ = iterations();
    imex_.reset();
    held_ = false;
    if (elements.empty()) return;
    const Options own = completed(Imex::description.name, Imex::table, options_.own);
    const ClusterOptions cluster = clusterOptionsOf(own);
    DeviceImexOptions wanted;
    wanted.dissipation = own.number("dissipation");
    wanted.tolerance = cluster.tolerance;
    wanted.iterations = cluster.iterations;
    imex_ = std::make_unique<DeviceImex>(device_, body_.mesh(), clustersOf(body_, elements), h, wanted);
  }

  Taken step(State& state, double h, std::int64_t count, double lambda) override {
    Taken taken{count, ""};
    if (imex_) {
      imex_->step(count);
      DeviceImex::Status status = imex_->status();
      taken = {status.steps, std::move(status.fault)};
    } else {
      explicitSteps(h, count, lambda);
    }
    state.x = device_.positions();
    state.v = device_.velocities();
    state.time += static_cast<double>(taken.steps) * h;
    return taken;
  }
  /// An interrupt need not wait longer, nor the certificate to be renewed.
  std::int64_t mostSteps() const override { return 256; }
  /// The GPU solves the clusters in its own way.
  std::vector<HandlerFigure> figures(std::vector<HandlerFigure> ofHandler) const override {
    std::erase_if(ofHandler, [](const HandlerFigure& figure) { return figure.ofHost; });
    ofHandler.push_back({"iterations", static_cast<double>(iterations())});
    return ofHandler;
  }
  std::string note() const override {
    std::vector<std::string> names;
    for (const int device : device_.devices()) names.push_back(deviceStatus(device).text);
    std::string text = fmt::format("the steps were taken on {}", fmt::join(names, " and "));
    if (watched_ > 0)
      text += fmt::format("; its certificate proved {} of {} steps, {} elements were evaluated for it", certified_,
                          watched_, evaluated_);
    return text;
  }

 private:
  /// Of conjugate gradients so far.
  std::int64_t iterations() const { return iterations_ + (imex_ ? imex_->iterations() : 0); }
  void explicitSteps(double h, std::int64_t count, double lambda) {
    if (lambda > 0) {
      // After a failure, which costs a bound from scratch, the next attempt waits.
      if (!(held_ && lambda == lambda_) && waited_++ % callsBetweenAttempts == 0) {
        held_ = certificate_.certify(lambda);
        lambda_ = lambda;
        if (held_) waited_ = 0;
      }
      watched_ += count;
    }
    if (held_ && lambda == lambda_) {
      const DeviceCertificate::Status before = certificate_.status();
      certificate_.step(h, count);
      const DeviceCertificate::Status status = certificate_.status();
      certified_ += status.certified ? count : status.lostAt - before.checked;
      evaluated_ += status.evaluated - before.evaluated;
      if (!status.certified || status.nearlyLost) held_ = certificate_.renew();
    } else {
      device_.step(h, count);
    }
  }

  /// Calls of explicitSteps() from an attempt in vain to the next: a bound from scratch is spent on one of so many.
  static constexpr std::int64_t callsBetweenAttempts = 16;

  OnDevice current_;  // while there are steps to take
  const Body& body_;
  const HandlerOptions& options_;
  DeviceBody<double> device_;
  DeviceCertificate certificate_;
  std::unique_ptr<DeviceImex> imex_;
  double lambda_ = 0;
  bool held_ = false;
  std::int64_t waited_ = 0, watched_ = 0, certified_ = 0, evaluated_ = 0, iterations_ = 0;
};

}  // namespace

std::string whyNoDevice() {
  const DeviceStatus status = deviceStatus();
  return status.available ? "" : status.text;
}
std::unique_ptr<Stepper> makeDeviceStepper(const Body& body, const State& state, const HandlerOptions& options,
                                           const std::vector<int>& asked) {
  std::vector<int> devices = asked;
  if (devices.empty()) {
    devices.resize(static_cast<std::size_t>(deviceCount()));
    std::iota(devices.begin(), devices.end(), 0);
  }
  requireDevices(devices);
  return std::make_unique<DeviceStepper>(body, state, options, devices);
}

}  // namespace ringwatch

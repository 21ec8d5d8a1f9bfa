#include <ringwatch/app/device_run.h>

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include <ringwatch/gpu/device_certificate.h>
#include <ringwatch/gpu/device_imex.h>
#include <ringwatch/gpu/device_rings.h>
#include <ringwatch/gpu/device_status.h>
#include <ringwatch/handlers/imex.h>

namespace ringwatch {
namespace {

class CudaRun final : public DeviceRun {
 public:
  CudaRun(const Body& body, const State& state, bool rings) : body_(body), device_(body), certificate_(device_) {
    device_.setPositions(state.x);
    device_.setVelocities(state.v);
    const auto& blocks = body.mesh().blocks;
    if (rings && std::all_of(blocks.begin(), blocks.end(),
                             [](const MeshBlock& block) { return block.type == elementTypeOf<Tet4>; }))
      rings_.emplace(device_);
  }

  void handle(const std::vector<ElementRef>& elements, double h, const HandlerOptions& options) override {
    iterations_ = iterations();
    imex_.reset();
    held_ = false;
    if (elements.empty()) return;
    const Options own = completed(ImplicitExplicit::description.name, ImplicitExplicit::table, options.own);
    const ClusterOptions cluster = clusterOptionsOf(own);
    DeviceImexOptions wanted;
    wanted.dissipation = own.number("dissipation");
    wanted.tolerance = cluster.tolerance;
    wanted.iterations = cluster.iterations;
    imex_ = std::make_unique<DeviceImex>(device_, body_.mesh(), clustersOf(body_, elements), h, wanted);
  }

  Taken step(State& state, double h, std::int64_t count, double sigma) override {
    Taken taken{count, ""};
    if (imex_) {
      imex_->step(count);
      DeviceImex::Look look = imex_->look();
      taken = {look.steps, std::move(look.fault)};
    } else {
      explicitSteps(h, count, sigma);
    }
    state.x = device_.positions();
    state.v = device_.velocities();
    state.time += static_cast<double>(taken.steps) * h;
    return taken;
  }
  bool hasRings() const override { return rings_.has_value(); }
  double highestRing() override { return rings_->highest().value; }
  std::vector<HandlerFigure> figures() const override { return {{"iterations", static_cast<double>(iterations())}}; }
  std::string device() const override { return deviceStatus().text; }
  std::string summary() const override {
    std::string text = fmt::format("the steps were taken on {}", device());
    if (watched_ > 0)
      text += fmt::format("; its certificate proved {} of {} steps, {} elements were evaluated for it", certified_,
                          watched_, evaluated_);
    return text;
  }

 private:
  /// Of conjugate gradients so far.
  std::int64_t iterations() const { return iterations_ + (imex_ ? imex_->iterations() : 0); }
  void explicitSteps(double h, std::int64_t count, double sigma) {
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
  }

  const Body& body_;
  DeviceBody<double> device_;
  DeviceCertificate certificate_;
  std::unique_ptr<DeviceImex> imex_;
  std::optional<DeviceRings> rings_;
  double sigma_ = 0;
  bool held_ = false;
  std::int64_t waited_ = 0, watched_ = 0, certified_ = 0, evaluated_ = 0, iterations_ = 0;
};

}  // namespace

std::string whyNoDevice() {
  const DeviceStatus status = deviceStatus();
  return status.available ? "" : status.text;
}
std::unique_ptr<DeviceRun> makeDeviceRun(const Body& body, const State& state, bool rings) {
  return std::make_unique<CudaRun>(body, state, rings);
}

}  // namespace ringwatch

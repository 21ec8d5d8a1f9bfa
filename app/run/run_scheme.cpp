#include <ringwatch/app/run/run_scheme.h>

#include <fmt/format.h>

#include <ringwatch/app/run/device_stepper.h>
#include <ringwatch/app/run/runner.h>
#include <ringwatch/app/scene/capabilities.h>
#include <ringwatch/app/scene/integrator_catalog.h>
#include <ringwatch/app/scene/scene_state.h>
#include <ringwatch/base/error.h>
#include <ringwatch/body/domain.h>
#include <ringwatch/integrators/additive_system.h>
#include <ringwatch/monitor/metrics/stiff_elements.h>

namespace ringwatch {

RunScheme::RunScheme(const Scene& scene, Body& body, RunResult& result, double h, RunOfPart* part)
    : scene_(scene), body_(body), result_(result) {
  makeIntegrator();
  if (handler_) {
    if (part) {
      handler_->prepareAsPart(*part->handler, part->explicitPart);
      if (!part->whole) part->handler.reset();  // some of the whole, which only the first process keeps
    } else {
      handler_->prepare(body_.mesh().X, h);
    }
    noteChoice();
  }
  makeStepper(h);
}

RunScheme::RunScheme(const Scene& scene, Body& body, RunResult& result, const NodeVectors& x, double h,
                     const CutMesh& cut, const RunScheme& before)
    : scene_(scene), body_(body), result_(result) {
  makeIntegrator();
  if (handler_) {
    handler_->prepare(x, h, cut, *before.handler_);
    noteChoice();
  }
  makeStepper(h);
}

void RunScheme::makeIntegrator() {
  integrator_ = integratorCatalog().make(scene_.method);
  if (scene_.handler.empty()) return;
  auto handler = makeHandler(scene_.handler, body_, std::move(integrator_), scene_.handlerOptions);
  handler_ = handler.get();
  integrator_ = std::move(handler);
}

/// After the handler's choice, which may change masses.
void RunScheme::makeStepper(double h) {
  system_.emplace(body_, scene_.damping);
  stepper_ = onDevice(h);
  if (!stepper_ && integrator_->info().partitioned) {
    // The stiff part is the elements whose own critical step is too small.
    const std::vector<ElementRef> stiff =
        stiffElements(body_, body_.mesh().X, *scene_.step, nonstiffShareOfLimit * integrator_->info().imaginaryLimit);
    stepper_ = makePartitionedStepper(*integrator_, body_, stiff, scene_.damping);
    stiffElements_ = static_cast<std::int64_t>(stiff.size());
    result_.notes.push_back(
        fmt::format("{}: {} of {} elements are in the stiff part, by their own critical step at rest", scene_.method,
                    stiff.size(), body_.mesh().elementCount()));
  }
  if (!stepper_) stepper_ = makeIntegratorStepper(*integrator_, *system_);
}

/// nullptr where the scene wants no GPU, or may do without one.
std::unique_ptr<Stepper> RunScheme::onDevice(double h) {
  if (scene_.device == RunDevice::cpu || !body_.domain().whole()) return nullptr;
  const auto refusal = refusalOf(scene_, SceneUse::gpu);
  std::string reason = refusal ? refusal->what : whyNoDevice();
  if (reason.empty()) {
    try {
      std::unique_ptr<Stepper> stepper =
          makeDeviceStepper(body_, sceneInitialState(scene_, *system_), scene_.handlerOptions, scene_.devices);
      if (handler_) stepper->handle(handler_->elements(), h);
      return stepper;
    } catch (const InputError& fault) {
      reason = fault.what();
    }
  }
  if (scene_.device == RunDevice::cuda)
    throw InputError(
        fmt::format("{}: \"cuda\": {}; set it to \"cpu\" or \"auto\"", scene_.where("integrator.device"), reason));
  result_.notes.push_back(fmt::format("device = \"auto\": the steps are taken on the CPU, since {}", reason));
  return nullptr;
}

void RunScheme::prepare(const NodeVectors& x, double h) {
  handler_->prepare(x, h);
  noteChoice();
  system_->followMasses();
  stepper_->handle(handler_->elements(), h);
}

void RunScheme::noteChoice() {
  if (!result_.handler) result_.handler.emplace();
  result_.handler->elements = handler_->handledElements();
  result_.handler->certified = handler_->certified();
  ++result_.handler->selections;
  result_.handler->evaluations += handler_->selectionCost().evaluations;
}

std::int64_t RunScheme::treatedElements() const { return handler_ ? handler_->handledElements() : stiffElements_; }

}  // namespace ringwatch

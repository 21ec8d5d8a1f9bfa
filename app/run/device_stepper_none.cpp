#include <ringwatch/app/run/device_stepper.h>

#include <ringwatch/base/error.h>

namespace ringwatch {

std::string whyNoDevice() { return "this build has no CUDA (RINGWATCH_WITH_CUDA, preset \"cuda\")"; }
std::unique_ptr<Stepper> makeDeviceStepper(const Body&, const State&, const HandlerOptions&, const std::vector<int>&) {
  throw InputError(whyNoDevice());
}

}  // namespace ringwatch

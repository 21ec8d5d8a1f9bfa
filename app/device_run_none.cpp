#include <ringwatch/app/device_run.h>

#include <ringwatch/base/error.h>

namespace ringwatch {

std::string whyNoDevice() { return "this build has no CUDA (RINGWATCH_WITH_CUDA, preset \"cuda\")"; }
std::unique_ptr<DeviceRun> makeDeviceRun(const Body& /*body*/, const State& /*state*/, bool /*rings*/) {
  throw InputError(whyNoDevice());
}

}  // namespace ringwatch

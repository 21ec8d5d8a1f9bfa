#pragma once
#include <cstdint>
#include <memory>
#include <string>

#include <ringwatch/body/body.h>
#include <ringwatch/integrators/integrator.h>

namespace ringwatch {

/// The steps of a run on a GPU: symplectic Euler without damping. The state stays there between the steps at which the
/// run looks at it.
class DeviceRun {
 public:
  virtual ~DeviceRun() = default;
  /// Takes `count` steps of h seconds and brings the state, which must be what the last call left, to where they lead.
  /// sigma > 0, rad²/s²: also proves, on the GPU and before each of them, that lambda_max(M⁻¹K) <= sigma.
  virtual void step(State& state, double h, std::int64_t count, double sigma) = 0;
  /// Name of the GPU.
  virtual std::string device() const = 0;
  /// What it did, one line.
  virtual std::string summary() const = 0;
};

/// Why a run cannot be on a GPU here: no CUDA in this build, or no GPU that works. "" when it can.
std::string whyNoDevice();
/// A run from `state` on. The body, with its loads and constraints, must not change afterwards. Throws InputError for
/// what the GPU does not have, or with need and free memory when it has too little of it.
std::unique_ptr<DeviceRun> makeDeviceRun(const Body& body, const State& state);

}  // namespace ringwatch

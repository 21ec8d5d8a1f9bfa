#pragma once
#include <cstdint>
#include <memory>
#include <string>

#include <ringwatch/body/body.h>
#include <ringwatch/handlers/handler.h>
#include <ringwatch/integrators/integrator.h>

namespace ringwatch {

/// The steps of a run on a GPU: symplectic Euler without damping, alone or with a handler that runs there on top. The
/// state stays there between the steps at which the run looks at it.
class DeviceRun {
 public:
  virtual ~DeviceRun() = default;
  /// From here on these elements are integrated implicitly, in steps of h seconds, as ImplicitExplicit does; none: all
  /// are explicit. Throws InputError, with need and free memory, when the GPU has too little.
  virtual void handle(const std::vector<ElementRef>& elements, double h, const HandlerOptions& options) = 0;
  /// Takes `count` steps of h seconds and brings the state, which must be what the last call left, to where they lead.
  /// sigma > 0, rad²/s²: also proves, on the GPU and before each of them, that lambda_max(M⁻¹K) <= sigma; not while
  /// elements are handled.
  struct Taken {
    std::int64_t steps = 0;  // fewer than `count` when an implicit solve failed in the next one
    std::string fault;       // why; "" when none did
  };
  virtual Taken step(State& state, double h, std::int64_t count, double sigma) = 0;
  /// Whether it was made to evaluate reduced 1-rings, and their highest eigenvalue at its state, rad²/s².
  virtual bool hasRings() const = 0;
  virtual double highestRing() = 0;
  /// In place of the handler's figures that count work of the CPU.
  virtual std::vector<HandlerFigure> figures() const = 0;
  /// Name of the GPU.
  virtual std::string device() const = 0;
  /// What it did, one line.
  virtual std::string summary() const = 0;
};

/// Why a run cannot be on a GPU here: no CUDA in this build, or no GPU that works. "" when it can.
std::string whyNoDevice();
/// A run from `state` on. The body, with its loads and constraints, must not change afterwards. rings: wants reduced
/// 1-rings, which it then evaluates if all elements are four-node tetrahedra. Throws InputError for what the GPU does
/// not have, or with need and free memory when it has too little of it.
std::unique_ptr<DeviceRun> makeDeviceRun(const Body& body, const State& state, bool rings);

}  // namespace ringwatch

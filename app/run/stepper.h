#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <ringwatch/handlers/handler.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/integrators/integrator.h>

namespace ringwatch {

/// Takes the steps of a run: an integrator, with or without a handler on top, one that treats two parts of the body
/// apart, or a GPU.
class Stepper {
 public:
  virtual ~Stepper() = default;
  /// Whether takeForce wants the internal force of this state, for the step that begins there or one that ended there.
  virtual bool needsForce(const State&) const { return false; }
  /// Whether a state tells all that the next step depends on: nothing is kept here from step to step.
  virtual bool keepsNothing() const { return false; }
  /// Gives the state what follows from its internal force, where needsForce() says so: an acceleration, and a velocity
  /// that does not lag.
  virtual void takeForce(State&, const StepEvaluation&) {}
  /// Ends the lag of the state's velocity, with an evaluation of its own where that takes one.
  virtual void complete(State&) {}
  /// The handler handles these elements from here on, in steps of h seconds.
  virtual void handle(const std::vector<ElementRef>& /*elements*/, double /*h*/) {}
  /// Steps that one call may take.
  virtual std::int64_t mostSteps() const { return 1; }
  /// What a call has done.
  struct Taken {
    std::int64_t steps = 0;  // fewer than asked for when the next one failed
    std::string fault;       // why; "" when none did
  };
  /// Takes up to `count` steps of h seconds, count <= mostSteps(). lambda > 0, rad²/s²: may prove before each of them
  /// that lambda_max(M⁻¹K) <= lambda, for its own record.
  virtual Taken step(State& state, double h, std::int64_t count, double lambda) = 0;
  /// The handler's figures, with what the stepper did in its place.
  virtual std::vector<HandlerFigure> figures(std::vector<HandlerFigure> ofHandler) const { return ofHandler; }
  /// A note on where the steps were taken; "" for none.
  virtual std::string note() const { return {}; }
};

/// Steps of an integrator, or of a handler, on the whole body. Both must outlive the stepper.
std::unique_ptr<Stepper> makeIntegratorStepper(Integrator& integrator, BodySystem& system);
/// Steps of a partitioned integrator: the stiff elements are one part of the body, all others the other. Integrator and
/// body must outlive the stepper.
std::unique_ptr<Stepper> makePartitionedStepper(Integrator& integrator, const Body& body,
                                                const std::vector<ElementRef>& stiff, const RayleighDamping& damping);

}  // namespace ringwatch

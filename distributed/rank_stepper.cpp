#include <ringwatch/distributed/rank_stepper.h>

#include <ringwatch/base/error.h>

namespace ringwatch {

RankStepper::RankStepper(Halo& halo, RankSystem& system, Integrator& integrator)
    : halo_(halo), system_(system), integrator_(integrator) {
  const IntegratorInfo& info = integrator.info();
  if (!integrator.beginsWithAcceleration() || info.forceEvaluations != 1 || info.partitioned)
    throw InputError(joinText("integrator \"", info.name,
                              "\": is not distributed over ranks, which take schemes of one force a step: "
                              "symplectic-euler or verlet"));
  if (system.ofBody().damping().beta != 0)
    throw InputError("stiffness-proportional damping is not distributed over ranks");
}

void RankStepper::takeForce(State& state, const NodeVectors& internalForce) {
  system_.accelerationOfForce(internalForce, state.x, state.v, state.a);
  ringwatch::complete(system_, state);
}

StepStatus RankStepper::beginStep(State& state, double h) {
  StepStatus status = integrator_.advance(system_, state, h);
  if (system_.velocityDependent())
    halo_.begin(state.x, state.v);
  else
    halo_.begin(state.x);
  return status;
}

StepStatus RankStepper::step(State& state, double h) {
  StepStatus status = beginStep(state, h);
  halo_.finish();
  return status;
}

void RankStepper::complete(State& state) {
  halo_.finish();
  ringwatch::complete(system_, state);
}

}  // namespace ringwatch

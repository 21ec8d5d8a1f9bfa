#include <ringwatch/app/run/stepper.h>

#include <ringwatch/body/domain.h>
#include <ringwatch/integrators/partitioned_body_system.h>

namespace ringwatch {
namespace {

Stepper::Taken takenOf(const StepStatus& status) { return {status.done ? 1 : 0, status.reason}; }

class IntegratorStepper final : public Stepper {
 public:
  IntegratorStepper(Integrator& integrator, BodySystem& system) : integrator_(integrator), system_(system) {}

  bool needsForce(const State& state) const override {
    return state.lag != 0 || (integrator_.beginsWithAcceleration() && state.a.cols() == 0);
  }
  bool keepsNothing() const override { return true; }
  void takeForce(State& state, const StepEvaluation& evaluation) override { system_.complete(state, evaluation); }
  void complete(State& state) override {
    system_.body().domain().finish();
    ringwatch::complete(system_, state);
  }
  Taken step(State& state, double h, std::int64_t /*count*/, double /*lambda*/) override {
    const StepStatus status = integrator_.advance(system_, state, h);
    system_.body().domain().begin(state.x);
    return takenOf(status);
  }

 private:
  Integrator& integrator_;
  BodySystem& system_;
};

class PartitionedStepper final : public Stepper {
 public:
  PartitionedStepper(Integrator& integrator, const Body& body, const std::vector<ElementRef>& stiff,
                     const RayleighDamping& damping)
      : integrator_(integrator), system_(body, stiff, damping) {}

  Taken step(State& state, double h, std::int64_t /*count*/, double /*lambda*/) override {
    return takenOf(integrator_.step(system_, state, h));
  }

 private:
  Integrator& integrator_;
  PartitionedBodySystem system_;
};

}  // namespace

std::unique_ptr<Stepper> makeIntegratorStepper(Integrator& integrator, BodySystem& system) {
  return std::make_unique<IntegratorStepper>(integrator, system);
}

std::unique_ptr<Stepper> makePartitionedStepper(Integrator& integrator, const Body& body,
                                                const std::vector<ElementRef>& stiff, const RayleighDamping& damping) {
  return std::make_unique<PartitionedStepper>(integrator, body, stiff, damping);
}

}  // namespace ringwatch

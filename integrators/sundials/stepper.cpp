#include <ringwatch/integrators/sundials/stepper.h>

#include <utility>

#include <ringwatch/base/error.h>

namespace ringwatch {
namespace detail {

std::string Stepper::attach(SecondOrderSystem& system) {
  auto* differentiable = dynamic_cast<DifferentiableSystem*>(&system);
  if (!differentiable) return "an implicit integrator needs a DifferentiableSystem, which knows its tangent";
  newton_.attach(*differentiable);
  return {};
}

StepStatus Stepper::step(SecondOrderSystem& system, State& state, double h) {
  if (std::string refusal = attach(system); !refusal.empty()) return {false, std::move(refusal)};
  newton_.clearComplaint();
  message_.clear();
  // What is remembered of steps of their own has a size and a direction.
  if (state.x.cols() != result_.x.cols() || (h < 0) != backwards_) release();
  backwards_ = h < 0;
  result_.x.resize(3, state.x.cols());
  result_.v.resize(3, state.x.cols());
  N_Vector start = wrapState(state.x, state.v, newton_.context());
  N_Vector end = wrapState(result_.x, result_.v, newton_.context());
  int flag = begin(start, state, h);
  if (flag == 0) flag = evolve(state.time, state.time + h, end);
  N_VDestroy(start);
  N_VDestroy(end);
  if (flag < 0) {
    release();  // what it remembers belongs to the failed step
    return {false, joinText(library_, " at t = ", state.time, " s, h = ", h,
                            " s: ", newton_.complaint().empty() ? message_ : newton_.complaint(),
                            "; last Newton residual ", newton_.lastResidual())};
  }
  std::swap(state.x, result_.x);
  std::swap(state.v, result_.v);
  state.time += h;
  return {};
}

void Stepper::release() {
  for (; !cleanup_.empty(); cleanup_.pop_back()) cleanup_.back()();
  memory_ = nullptr;
}

SUNLinearSolver Stepper::makeLinearSolver() {
  SUNLinearSolver solver = newton_.makeLinearSolver(
      [](void* self, N_Vector y, N_Vector b) {
        auto* stepper = static_cast<Stepper*>(self);
        return stepper->newton_.solve(stepper->gamma(), y, b);
      },
      this);
  onRelease([solver] { SUNLinSolFree(solver); });
  return solver;
}

N_Vector Stepper::makeTolerances(N_Vector like) {
  N_Vector tolerances = N_VClone(like);
  onRelease([tolerances] { N_VDestroy(tolerances); });
  return tolerances;
}

}  // namespace detail

SundialsIntegrator::SundialsIntegrator(const IntegratorInfo& info, std::unique_ptr<detail::Stepper> stepper)
    : info_(info), stepper_(std::move(stepper)) {}
SundialsIntegrator::~SundialsIntegrator() = default;
StepStatus SundialsIntegrator::step(SecondOrderSystem& system, State& state, double h) {
  return stepper_->step(system, state, h);
}
void SundialsIntegrator::reset() { stepper_->release(); }

}  // namespace ringwatch

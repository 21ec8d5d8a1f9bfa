#include <arkode/arkode_arkstep.h>

#include <cmath>
#include <utility>

#include <ringwatch/base/error.h>
#include <ringwatch/integrators/sundials/implicit.h>
#include <ringwatch/integrators/sundials/newton_system.h>

namespace ringwatch {
namespace detail {

/// ARKODE's ARKStep with one implicit table.
class ArkodeSolver {
 public:
  /// order 1: implicit Euler; 2 to 4: a table of ARKODE's.
  ArkodeSolver(int order, bool adaptive, const ImplicitOptions& options)
      : order_(order), adaptive_(adaptive), newton_(options) {
    if (order < 1 || order > 4) throw InputError(joinText("order = ", order, ": arkode-dirk has orders 2, 3 and 4"));
    SUNContext_Create(nullptr, &context_);
  }
  ~ArkodeSolver() {
    release();
    SUNContext_Free(&context_);
  }
  ArkodeSolver(const ArkodeSolver&) = delete;
  ArkodeSolver& operator=(const ArkodeSolver&) = delete;

  StepStatus step(SecondOrderSystem& system, State& state, double h) {
    auto* differentiable = dynamic_cast<DifferentiableSystem*>(&system);
    if (!differentiable) return {false, "an implicit integrator needs a DifferentiableSystem, which knows its tangent"};
    newton_.attach(*differentiable);
    newton_.clearComplaint();
    message_.clear();
    if (state.x.cols() != result_.x.cols()) {
      release();
      result_ = state;
    }
    N_Vector start = wrapState(state.x, state.v, context_), end = wrapState(result_.x, result_.v, context_);
    int flag = memory_ ? ARKStepReset(memory_, state.time, start) : create(start, state.time);
    if (flag == ARK_SUCCESS) {
      setTolerances(newton_.options(), state, h, tolerances_);
      flag = ARKStepSVtolerances(memory_, newton_.options().relativeTolerance, tolerances_);
    }
    if (flag == ARK_SUCCESS) {
      double reached = state.time;
      if (adaptive_) {
        ARKStepSetStopTime(memory_, state.time + h);
        flag = ARKStepEvolve(memory_, state.time + h, end, &reached, ARK_NORMAL);
      } else {
        ARKStepSetFixedStep(memory_, h);
        flag = ARKStepEvolve(memory_, state.time + h, end, &reached, ARK_ONE_STEP);
      }
    }
    N_VDestroy(start);
    N_VDestroy(end);
    if (flag < 0) {
      release();  // what it remembers belongs to the failed step
      return {false, joinText("ARKODE at t = ", state.time, " s, h = ", h,
                              " s: ", newton_.complaint().empty() ? message_ : newton_.complaint(),
                              "; last Newton residual ", newton_.lastResidual())};
    }
    std::swap(state.x, result_.x);
    std::swap(state.v, result_.v);
    state.time += h;
    return {};
  }

 private:
  int create(N_Vector start, double time) {
    memory_ = ARKStepCreate(
        nullptr,
        [](double t, N_Vector y, N_Vector dy, void* self) {
          return static_cast<ArkodeSolver*>(self)->newton_.rightHandSide(t, y, dy);
        },
        time, start, context_);
    if (!memory_) return ARK_MEM_FAIL;
    tolerances_ = N_VClone(start);
    ARKStepSetUserData(memory_, this);
    ARKStepSetErrHandlerFn(
        memory_,
        [](int, const char*, const char*, char* text, void* self) {
          static_cast<ArkodeSolver*>(self)->message_ = text;
        },
        this);
    if (order_ == 1) {
      double one = 1;
      ARKodeButcherTable table = ARKodeButcherTable_Create(1, 1, 0, &one, &one, &one, nullptr);
      ARKStepSetTables(memory_, 1, 0, table, nullptr);
      ARKodeButcherTable_Free(table);
    } else {
      constexpr ARKODE_DIRKTableID tables[] = {ARKODE_SDIRK_2_1_2, ARKODE_ESDIRK324L2SA_4_2_3, ARKODE_SDIRK_5_3_4};
      ARKStepSetTableNum(memory_, tables[order_ - 2], ARKODE_ERK_NONE);
    }
    solver_ = newton_.makeLinearSolver(
        [](void* self, N_Vector y, N_Vector b) {
          auto* solver = static_cast<ArkodeSolver*>(self);
          double gamma = 0;
          ARKStepGetCurrentGamma(solver->memory_, &gamma);
          return solver->newton_.solve(gamma, y, b);
        },
        this, context_);
    if (const int flag = ARKStepSetLinearSolver(memory_, solver_, nullptr); flag != ARK_SUCCESS) return flag;
    // The Newton iteration ends at a small part of the tolerance, so that it does not show in the order of the method.
    ARKStepSetNonlinConvCoef(memory_, 1e-2);
    ARKStepSetMaxNumSteps(memory_, 100000);
    return ARKStepSetMaxNonlinIters(memory_, newton_.options().newtonIterations);
  }
  void release() {
    if (memory_) ARKStepFree(&memory_);
    if (solver_) SUNLinSolFree(solver_);
    if (tolerances_) N_VDestroy(tolerances_);
    memory_ = nullptr;
    solver_ = nullptr;
    tolerances_ = nullptr;
  }

  int order_;
  bool adaptive_;
  NewtonSystem newton_;
  SUNContext context_ = nullptr;
  void* memory_ = nullptr;
  SUNLinearSolver solver_ = nullptr;
  N_Vector tolerances_ = nullptr;
  State result_;
  std::string message_;
};

}  // namespace detail

ImplicitEuler::ImplicitEuler(const ImplicitOptions& options)
    : solver_(std::make_unique<detail::ArkodeSolver>(1, false, options)) {}
ImplicitEuler::~ImplicitEuler() = default;
StepStatus ImplicitEuler::step(SecondOrderSystem& system, State& state, double h) {
  return solver_->step(system, state, h);
}

ArkodeDirk::ArkodeDirk(int order, bool adaptive, const ImplicitOptions& options) : info_(description) {
  if (order < 2) throw InputError(joinText("order = ", order, ": arkode-dirk has orders 2, 3 and 4"));
  solver_ = std::make_unique<detail::ArkodeSolver>(order, adaptive, options);
  info_.order = info_.dampedOrder = order;
  info_.adaptive = adaptive;
}
ArkodeDirk::~ArkodeDirk() = default;
StepStatus ArkodeDirk::step(SecondOrderSystem& system, State& state, double h) {
  return solver_->step(system, state, h);
}

}  // namespace ringwatch

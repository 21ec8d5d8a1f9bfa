#include <arkode/arkode_arkstep.h>

#include <ringwatch/base/error.h>
#include <ringwatch/integrators/sundials/additive.h>
#include <ringwatch/integrators/sundials/implicit.h>
#include <ringwatch/integrators/sundials/stepper.h>

namespace ringwatch {
namespace {

/// ARKODE's ARKStep. Starts from scratch at every step; only its memory is kept.
class ArkodeStepper : public detail::Stepper {
 public:
  ArkodeStepper(bool adaptive, const ImplicitOptions& options) : Stepper("ARKODE", options), adaptive_(adaptive) {}

 protected:
  /// The explicit right-hand side, or nullptr.
  virtual ARKRhsFn explicitPart() const { return nullptr; }
  /// Chooses the method of fresh memory. A SUNDIALS flag.
  virtual int setTables(void* memory) const = 0;

 private:
  int begin(N_Vector start, const State& state, double h) override {
    const int flag = memory_ ? ARKStepReset(memory_, state.time, start) : create(start, state.time);
    if (flag != ARK_SUCCESS) return flag;
    detail::setTolerances(options(), state, h, tolerances_);
    return ARKStepSVtolerances(memory_, options().relativeTolerance, tolerances_);
  }
  int evolve(double from, double to, N_Vector end) override {
    double reached = from;
    if (adaptive_) {
      ARKStepSetStopTime(memory_, to);
      return ARKStepEvolve(memory_, to, end, &reached, ARK_NORMAL);
    }
    ARKStepSetFixedStep(memory_, to - from);
    return ARKStepEvolve(memory_, to, end, &reached, ARK_ONE_STEP);
  }
  double gamma() const override {
    double gamma = 0;
    ARKStepGetCurrentGamma(memory_, &gamma);
    return gamma;
  }

  int create(N_Vector start, double time) {
    memory_ = ARKStepCreate(explicitPart(), rightHandSide, time, start, newton_.context());
    if (!memory_) return ARK_MEM_FAIL;
    onRelease([memory = memory_]() mutable { ARKStepFree(&memory); });
    tolerances_ = makeTolerances(start);
    ARKStepSetUserData(memory_, static_cast<Stepper*>(this));
    ARKStepSetErrHandlerFn(memory_, keepMessage, this);
    if (const int flag = setTables(memory_); flag != ARK_SUCCESS) return flag;
    if (const int flag = ARKStepSetLinearSolver(memory_, makeLinearSolver(), nullptr); flag != ARK_SUCCESS) return flag;
    // The Newton iteration ends at a small part of the tolerance, so that it does not show in the order of the method.
    ARKStepSetNonlinConvCoef(memory_, 1e-2);
    ARKStepSetMaxNumSteps(memory_, 100000);
    return ARKStepSetMaxNonlinIters(memory_, options().newtonIterations);
  }

  bool adaptive_;
  N_Vector tolerances_ = nullptr;
};

class DirkStepper final : public ArkodeStepper {
 public:
  /// order 1: implicit Euler; 2 to 4: a table of ARKODE's.
  DirkStepper(int order, bool adaptive, const ImplicitOptions& options)
      : ArkodeStepper(adaptive, options), order_(order) {}

 private:
  int setTables(void* memory) const override {
    if (order_ == 1) {
      double one = 1;
      ARKodeButcherTable table = ARKodeButcherTable_Create(1, 1, 0, &one, &one, &one, nullptr);
      const int flag = ARKStepSetTables(memory, 1, 0, table, nullptr);
      ARKodeButcherTable_Free(table);
      return flag;
    }
    constexpr ARKODE_DIRKTableID tables[] = {ARKODE_SDIRK_2_1_2, ARKODE_ESDIRK324L2SA_4_2_3, ARKODE_SDIRK_5_3_4};
    return ARKStepSetTableNum(memory, tables[order_ - 2], ARKODE_ERK_NONE);
  }

  int order_;
};

class ArkStepper final : public ArkodeStepper {
 public:
  using ArkodeStepper::ArkodeStepper;

 private:
  std::string attach(SecondOrderSystem& system) override {
    auto* additive = dynamic_cast<AdditiveSystem*>(&system);
    if (!additive) return "arkode-ark needs an AdditiveSystem, which tells its stiff part from the rest";
    newton_.attach(additive->stiff());
    nonstiff_.system = &additive->nonstiff();
    return {};
  }
  ARKRhsFn explicitPart() const override {
    return [](double time, N_Vector y, N_Vector dy, void* self) {
      return static_cast<ArkStepper*>(static_cast<Stepper*>(self))->nonstiff_.rightHandSide(time, y, dy);
    };
  }
  int setTables(void* memory) const override {
    return ARKStepSetTableNum(memory, ARKODE_ARK437L2SA_DIRK_7_3_4, ARKODE_ARK437L2SA_ERK_7_3_4);
  }

  detail::NonstiffPart nonstiff_;
};

std::unique_ptr<detail::Stepper> makeDirk(int order, bool adaptive, const ImplicitOptions& options) {
  if (order < 2 || order > 4) throw InputError(joinText("order = ", order, ": arkode-dirk has orders 2, 3 and 4"));
  return std::make_unique<DirkStepper>(order, adaptive, options);
}
IntegratorInfo withOrder(IntegratorInfo info, int order, bool adaptive) {
  info.order = info.dampedOrder = order;
  info.adaptive = adaptive;
  return info;
}

}  // namespace

ImplicitEuler::ImplicitEuler(const ImplicitOptions& options)
    : SundialsIntegrator(description, std::make_unique<DirkStepper>(1, false, options)) {}

ArkodeDirk::ArkodeDirk(int order, bool adaptive, const ImplicitOptions& options)
    : SundialsIntegrator(withOrder(description, order, adaptive), makeDirk(order, adaptive, options)) {}

ArkodeArk::ArkodeArk(bool adaptive, const ImplicitOptions& options)
    : SundialsIntegrator(withOrder(description, 4, adaptive), std::make_unique<ArkStepper>(adaptive, options)) {}

}  // namespace ringwatch

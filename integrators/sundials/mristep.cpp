#include <arkode/arkode_arkstep.h>
#include <arkode/arkode_mristep.h>

#include <cmath>

#include <ringwatch/base/error.h>
#include <ringwatch/integrators/sundials/additive.h>
#include <ringwatch/integrators/sundials/stepper.h>

namespace ringwatch {
namespace {

/// MRIStep over the non-stiff part, ARKStep within it over the stiff one.
class MriStepper final : public detail::Stepper {
 public:
  MriStepper(int substeps, const ImplicitOptions& options) : Stepper("MRIStep", options), substeps_(substeps) {}

 private:
  std::string attach(SecondOrderSystem& system) override {
    auto* additive = dynamic_cast<AdditiveSystem*>(&system);
    if (!additive) return "arkode-mri needs an AdditiveSystem, which tells its stiff part from the rest";
    newton_.attach(additive->stiff());
    nonstiff_.system = &additive->nonstiff();
    return {};
  }
  int begin(N_Vector start, const State& state, double h) override {
    int flag = ARK_SUCCESS;
    if (!memory_)
      flag = create(start, state.time);
    else if ((flag = ARKStepReset(inner_, state.time, start)) == ARK_SUCCESS)
      flag = MRIStepReset(memory_, state.time, start);
    if (flag != ARK_SUCCESS) return flag;
    detail::setTolerances(options(), state, h, tolerances_);
    flag = ARKStepSVtolerances(inner_, options().relativeTolerance, tolerances_);
    if (flag == ARK_SUCCESS) flag = MRIStepSVtolerances(memory_, options().relativeTolerance, tolerances_);
    if (flag == ARK_SUCCESS && substeps_ > 0) flag = ARKStepSetFixedStep(inner_, h / substeps_);
    return flag;
  }
  int evolve(double from, double to, N_Vector end) override {
    double reached = from;
    MRIStepSetFixedStep(memory_, to - from);
    return MRIStepEvolve(memory_, to, end, &reached, ARK_ONE_STEP);
  }
  double gamma() const override { return 0; }  // nothing is implicit

  int create(N_Vector start, double time) {
    inner_ = ARKStepCreate(rightHandSide, nullptr, time, start, newton_.context());
    if (!inner_) return ARK_MEM_FAIL;
    onRelease([inner = inner_]() mutable { ARKStepFree(&inner); });
    tolerances_ = makeTolerances(start);
    ARKStepSetUserData(inner_, static_cast<Stepper*>(this));
    ARKStepSetErrHandlerFn(inner_, keepMessage, this);
    ARKStepSetMaxNumSteps(inner_, 100000);
    int flag = ARKStepSetTableNum(inner_, ARKODE_DIRK_NONE, ARKODE_ZONNEVELD_5_3_4);
    MRIStepInnerStepper inner = nullptr;
    if (flag == ARK_SUCCESS) flag = ARKStepCreateMRIStepInnerStepper(inner_, &inner);
    if (flag != ARK_SUCCESS) return flag;
    onRelease([inner]() mutable { MRIStepInnerStepper_Free(&inner); });
    memory_ = MRIStepCreate(
        [](double t, N_Vector y, N_Vector dy, void* self) {
          return static_cast<MriStepper*>(static_cast<Stepper*>(self))->nonstiff_.rightHandSide(t, y, dy);
        },
        nullptr, time, start, inner, newton_.context());
    if (!memory_) return ARK_MEM_FAIL;
    onRelease([memory = memory_]() mutable { MRIStepFree(&memory); });
    MRIStepSetUserData(memory_, static_cast<Stepper*>(this));
    MRIStepSetErrHandlerFn(memory_, keepMessage, this);
    MRIStepCoupling coupling = MRIStepCoupling_LoadTable(ARKODE_MRI_GARK_ERK33a);
    flag = MRIStepSetCoupling(memory_, coupling);
    MRIStepCoupling_Free(coupling);
    return flag;
  }

  int substeps_;
  void* inner_ = nullptr;
  N_Vector tolerances_ = nullptr;
  detail::NonstiffPart nonstiff_;
};

std::unique_ptr<detail::Stepper> makeMri(int substeps, const ImplicitOptions& options) {
  if (substeps < 0) throw InputError(joinText("substeps = ", substeps, ": must be >= 0; 0 is by error control"));
  return std::make_unique<MriStepper>(substeps, options);
}

}  // namespace

ArkodeMri::ArkodeMri(int substeps, const ImplicitOptions& options)
    : SundialsIntegrator(description, makeMri(substeps, options)) {}

}  // namespace ringwatch

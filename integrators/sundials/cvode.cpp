#include <cvode/cvode.h>

#include <ringwatch/integrators/sundials/implicit.h>
#include <ringwatch/integrators/sundials/stepper.h>

namespace ringwatch {
namespace {

/// CVODE goes on from where its last step ended: its memory is made at the first step.
class CvodeStepper final : public detail::Stepper {
 public:
  explicit CvodeStepper(const ImplicitOptions& options) : Stepper("CVODE", options) {}

 private:
  int begin(N_Vector start, const State& state, double h) override {
    if (memory_) return CV_SUCCESS;
    memory_ = CVodeCreate(CV_BDF, newton_.context());
    if (!memory_) return CV_MEM_FAIL;
    onRelease([memory = memory_]() mutable { CVodeFree(&memory); });
    CVodeSetErrHandlerFn(memory_, keepMessage, this);
    int flag = CVodeInit(memory_, rightHandSide, state.time, start);
    if (flag != CV_SUCCESS) return flag;
    CVodeSetUserData(memory_, static_cast<Stepper*>(this));
    N_Vector tolerances = makeTolerances(start);
    detail::setTolerances(options(), state, h, tolerances);
    flag = CVodeSVtolerances(memory_, options().relativeTolerance, tolerances);
    if (flag != CV_SUCCESS) return flag;
    CVodeSetMaxOrd(memory_, 2);
    CVodeSetMaxNumSteps(memory_, 100000);
    return CVodeSetLinearSolver(memory_, makeLinearSolver(), nullptr);
  }
  int evolve(double from, double to, N_Vector end) override {
    double reached = from;
    CVodeSetStopTime(memory_, to);
    return CVode(memory_, to, end, &reached, CV_NORMAL);
  }
  double gamma() const override {
    double gamma = 0;
    CVodeGetCurrentGamma(memory_, &gamma);
    return gamma;
  }
};

}  // namespace

CvodeBdf::CvodeBdf(const ImplicitOptions& options)
    : SundialsIntegrator(description, std::make_unique<CvodeStepper>(options)) {}

}  // namespace ringwatch

#include <cvode/cvode.h>

#include <cmath>
#include <utility>

#include <ringwatch/base/error.h>
#include <ringwatch/integrators/sundials/implicit.h>
#include <ringwatch/integrators/sundials/newton_system.h>

namespace ringwatch {
namespace detail {

class CvodeSolver {
 public:
  explicit CvodeSolver(const ImplicitOptions& options) : newton_(options) { SUNContext_Create(nullptr, &context_); }
  ~CvodeSolver() {
    reset();
    SUNContext_Free(&context_);
  }
  CvodeSolver(const CvodeSolver&) = delete;
  CvodeSolver& operator=(const CvodeSolver&) = delete;

  StepStatus step(SecondOrderSystem& system, State& state, double h) {
    auto* differentiable = dynamic_cast<DifferentiableSystem*>(&system);
    if (!differentiable) return {false, "an implicit integrator needs a DifferentiableSystem, which knows its tangent"};
    newton_.attach(*differentiable);
    newton_.clearComplaint();
    message_.clear();
    if (state.x.cols() != result_.x.cols() || (h < 0) != backwards_) reset();
    backwards_ = h < 0;
    result_.x.resize(3, state.x.cols());
    result_.v.resize(3, state.x.cols());
    int flag = CV_SUCCESS;
    if (!memory_) {
      N_Vector start = wrapState(state.x, state.v, context_);
      flag = create(start, state, h);
      N_VDestroy(start);
    }
    if (flag == CV_SUCCESS) {
      N_Vector end = wrapState(result_.x, result_.v, context_);
      double reached = state.time;
      CVodeSetStopTime(memory_, state.time + h);
      flag = CVode(memory_, state.time + h, end, &reached, CV_NORMAL);
      N_VDestroy(end);
    }
    if (flag < 0) {
      reset();
      return {false, joinText("CVODE at t = ", state.time, " s, h = ", h,
                              " s: ", newton_.complaint().empty() ? message_ : newton_.complaint(),
                              "; last Newton residual ", newton_.lastResidual())};
    }
    std::swap(state.x, result_.x);
    std::swap(state.v, result_.v);
    state.time += h;
    return {};
  }

  void reset() {
    if (memory_) CVodeFree(&memory_);
    if (solver_) SUNLinSolFree(solver_);
    memory_ = nullptr;
    solver_ = nullptr;
  }

 private:
  int create(N_Vector start, const State& state, double h) {
    memory_ = CVodeCreate(CV_BDF, context_);
    if (!memory_) return CV_MEM_FAIL;
    CVodeSetErrHandlerFn(
        memory_,
        [](int, const char*, const char*, char* text, void* self) { static_cast<CvodeSolver*>(self)->message_ = text; },
        this);
    int flag = CVodeInit(
        memory_,
        [](double t, N_Vector y, N_Vector dy, void* self) {
          return static_cast<CvodeSolver*>(self)->newton_.rightHandSide(t, y, dy);
        },
        state.time, start);
    if (flag != CV_SUCCESS) return flag;
    CVodeSetUserData(memory_, this);
    N_Vector tolerances = N_VClone(start);
    setTolerances(newton_.options(), state, h, tolerances);
    flag = CVodeSVtolerances(memory_, newton_.options().relativeTolerance, tolerances);
    N_VDestroy(tolerances);
    if (flag != CV_SUCCESS) return flag;
    CVodeSetMaxOrd(memory_, 2);
    CVodeSetMaxNumSteps(memory_, 100000);
    solver_ = newton_.makeLinearSolver(
        [](void* self, N_Vector y, N_Vector b) {
          auto* solver = static_cast<CvodeSolver*>(self);
          double gamma = 0;
          CVodeGetCurrentGamma(solver->memory_, &gamma);
          return solver->newton_.solve(gamma, y, b);
        },
        this, context_);
    return CVodeSetLinearSolver(memory_, solver_, nullptr);
  }

  NewtonSystem newton_;
  SUNContext context_ = nullptr;
  void* memory_ = nullptr;
  SUNLinearSolver solver_ = nullptr;
  State result_;
  bool backwards_ = false;
  std::string message_;
};

}  // namespace detail

CvodeBdf::CvodeBdf(const ImplicitOptions& options) : solver_(std::make_unique<detail::CvodeSolver>(options)) {}
CvodeBdf::~CvodeBdf() = default;
StepStatus CvodeBdf::step(SecondOrderSystem& system, State& state, double h) { return solver_->step(system, state, h); }
void CvodeBdf::reset() { solver_->reset(); }

}  // namespace ringwatch

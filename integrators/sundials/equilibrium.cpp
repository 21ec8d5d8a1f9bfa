#include <kinsol/kinsol.h>

#include <utility>

#include <ringwatch/base/error.h>
#include <ringwatch/integrators/sundials/implicit.h>
#include <ringwatch/integrators/sundials/newton_system.h>

namespace ringwatch {
namespace {

struct Problem {
  Problem(const ImplicitOptions& options, double t) : newton(options), time(t) {}
  detail::NewtonSystem newton;
  double time;
  std::string message;
};

}  // namespace

EquilibriumStatus solveEquilibrium(DifferentiableSystem& system, double time, NodeVectors& x, double tolerance,
                                   const ImplicitOptions& options) {
  Problem problem(options, time);
  problem.newton.attach(system);
  SUNContext context = problem.newton.context();
  NodeVectors solution = x, none(3, 0);
  N_Vector u = detail::wrapState(solution, none, context), scale = N_VClone(u), residual = N_VClone(u);
  N_VConst(1, scale);
  problem.newton.staticResidual(time, u, residual);
  EquilibriumStatus status;
  status.residual = N_VMaxNorm(residual);
  if (status.residual > 0) {
    void* memory = KINCreate(context);
    KINSetErrHandlerFn(
        memory,
        [](int, const char*, const char*, char* text, void* self) { static_cast<Problem*>(self)->message = text; },
        &problem);
    int flag = KINInit(
        memory,
        [](N_Vector y, N_Vector r, void* self) {
          auto* p = static_cast<Problem*>(self);
          return p->newton.staticResidual(p->time, y, r);
        },
        u);
    KINSetUserData(memory, &problem);
    SUNLinearSolver solver = problem.newton.makeLinearSolver(
        [](void* self, N_Vector y, N_Vector b) { return static_cast<Problem*>(self)->newton.solveStatic(y, b); },
        &problem, true);
    if (flag == KIN_SUCCESS) flag = KINSetLinearSolver(memory, solver, nullptr);
    if (flag == KIN_SUCCESS)
      flag = KINSetJacTimesVecFn(memory, [](N_Vector y, N_Vector Jy, N_Vector, booleantype*, void* self) {
        static_cast<Problem*>(self)->newton.staticTangentProduct(y, Jy);
        return 0;
      });
    KINSetFuncNormTol(memory, tolerance * status.residual);
    KINSetScaledStepTol(memory, 1e-300);  // only the forces decide
    KINSetMaxNewtonStep(memory, 1e3 * (1 + x.norm()));
    KINSetNumMaxIters(memory, 500);
    if (flag == KIN_SUCCESS) flag = KINSol(memory, u, KIN_LINESEARCH, scale, scale);
    long iterations = 0;
    KINGetNumNonlinSolvIters(memory, &iterations);
    status.iterations = static_cast<int>(iterations);
    problem.newton.staticResidual(time, u, residual);
    const double before = status.residual;
    status.residual = N_VMaxNorm(residual);
    status.done = flag >= 0 && status.residual <= tolerance * before;
    if (!status.done)
      status.reason =
          joinText("KINSOL after ", iterations,
                   " iterations: ", problem.newton.complaint().empty() ? problem.message : problem.newton.complaint(),
                   "; largest unbalanced force ", status.residual, " N");
    KINFree(&memory);
    SUNLinSolFree(solver);
  } else {
    status.done = true;
  }
  if (status.done) std::swap(x, solution);
  N_VDestroy(residual);
  N_VDestroy(scale);
  N_VDestroy(u);
  return status;
}

}  // namespace ringwatch

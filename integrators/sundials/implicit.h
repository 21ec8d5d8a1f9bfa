#pragma once
#include <limits>
#include <memory>

#include <ringwatch/integrators/integrator.h>

namespace ringwatch {

/// How the linear systems of Newton's method, (M + γ C + γ² K) dv = r, are solved. C = alpha M + beta K; γ is the step
/// times the method's coefficient.
enum class LinearSolve {
  direct,              ///< Eigen's sparse LDLᵀ of the assembled matrix
  conjugateGradients,  ///< matrix-free on stiffnessProduct, preconditioned by the 3×3 diagonal blocks; fails on an
                       ///< indefinite matrix
  gmres                ///< SUNDIALS' GMRES on the same product and preconditioner; takes an indefinite matrix too
};

/// What the implicit integrators take. They need a DifferentiableSystem.
struct ImplicitOptions {
  LinearSolve linearSolve = LinearSolve::direct;
  double relativeTolerance = 1e-8;  ///< of Newton's method, and of the error where steps adapt
  double positionTolerance = 0;     ///< m, absolute; 0: relativeTolerance times the size of the system
  double velocityTolerance = 0;     ///< m/s, absolute; 0: positionTolerance over the step
  double linearTolerance = 1e-10;   ///< relative residual of the matrix-free solvers
  int newtonIterations = 20;        ///< at most, a stage
};

namespace detail {
class Stepper;
}

/// An integrator of SUNDIALS. A step that does not work reports why, with step and residual, and leaves the state
/// alone.
class SundialsIntegrator : public Integrator {
 public:
  ~SundialsIntegrator() override;
  const IntegratorInfo& info() const override { return info_; }
  StepStatus step(SecondOrderSystem& system, State& state, double h) override;
  void reset() override;

 protected:
  SundialsIntegrator(const IntegratorInfo& info, std::unique_ptr<detail::Stepper> stepper);

 private:
  IntegratorInfo info_;
  std::unique_ptr<detail::Stepper> stepper_;
};

/// Implicit Euler, x' = x + h v', v' = v + h a(x', v'), by ARKODE with that one-stage table. L-stable: |R(iz)|² = 1/(1
/// + z²).
class ImplicitEuler final : public SundialsIntegrator {
 public:
  static constexpr IntegratorInfo description{.name = "implicit-euler",
                                              .help = "first order, implicit, stable for every step, strong damping",
                                              .order = 1,
                                              .forceEvaluations = 0,
                                              .imaginaryLimit = std::numeric_limits<double>::infinity(),
                                              .symplectic = false};
  explicit ImplicitEuler(const ImplicitOptions& options = {});
};

/// Diagonally implicit Runge–Kutta methods by ARKODE: order 2 SDIRK-2-1-2 (A-stable), 3 ESDIRK3(2)4L[2]SA (Kennedy &
/// Carpenter 2016), 4 SDIRK-5-3-4 (Hairer & Wanner), the last two L-stable. Steps of the size asked for, or adaptive
/// ones within it.
class ArkodeDirk final : public SundialsIntegrator {
 public:
  static constexpr IntegratorInfo description{
      .name = "arkode-dirk",
      .help = "diagonally implicit Runge-Kutta, fourth order, stable for every step",
      .order = 4,
      .forceEvaluations = 0,
      .imaginaryLimit = std::numeric_limits<double>::infinity(),
      .symplectic = false,
      .dampedOrder = 4};
  /// order: 2, 3 or 4, else InputError.
  explicit ArkodeDirk(int order = 4, bool adaptive = false, const ImplicitOptions& options = {});
};

/// Backward differentiation formulas by CVODE, orders one and two (higher ones are not stable for undamped vibrations),
/// steps chosen by CVODE within the step asked for. It goes on from where its last step ended: reset() when the state
/// changed.
class CvodeBdf final : public SundialsIntegrator {
 public:
  static constexpr IntegratorInfo description{
      .name = "cvode-bdf",
      .help = "backward differences, second order, steps of its own by error control",
      .order = 2,
      .forceEvaluations = 0,
      .imaginaryLimit = std::numeric_limits<double>::infinity(),
      .symplectic = false,
      .dampedOrder = 2,
      .adaptive = true};
  explicit CvodeBdf(const ImplicitOptions& options = {});
};

}  // namespace ringwatch

#pragma once
#include <string>

#include <sundials/sundials_linearsolver.h>
#include <Eigen/SparseCholesky>

#include <ringwatch/integrators/sundials/implicit.h>
#include <ringwatch/integrators/sundials/state_vector.h>

namespace ringwatch::detail {

/// The right-hand side of (ẋ, v̇) = (v, a(t, x, v)) and the linear systems of Newton's method for it, as SUNDIALS wants
/// them: a linear solver that holds its own matrix.
///
/// (I - γ J)(dx, dv) = (p, q) with J = [0 I; -M⁻¹K -M⁻¹C]: dx = p + γ dv and (M + γ C + γ² K) dv = M q - γ K p, a
/// symmetric system of half the size. The derivative of K along v, which Rayleigh damping would add, is left out:
/// Newton's method converges linearly then, to the same solution. Where motion is prescribed a = 0, hence dv = q there.
class NewtonSystem {
 public:
  explicit NewtonSystem(const ImplicitOptions& options) : options_(options) {}
  NewtonSystem(const NewtonSystem&) = delete;
  NewtonSystem& operator=(const NewtonSystem&) = delete;

  void attach(DifferentiableSystem& system) { system_ = &system; }
  DifferentiableSystem& system() { return *system_; }
  const ImplicitOptions& options() const { return options_; }

  /// Right-hand side at y; remembers where, since Newton's matrix is taken at the last point evaluated. 0, or 1
  /// (recoverable) when it is not finite.
  int rightHandSide(double time, N_Vector y, N_Vector dy);
  /// Residual of statics, M a(t, x, 0) with opposite sign, in the positions of r.
  int staticResidual(double time, N_Vector y, N_Vector r);
  /// Solves (I - γ J) y = b. 0, or 1 when it does not work.
  int solve(double gamma, N_Vector y, N_Vector b);
  /// Solves K(x) y = b in positions alone.
  int solveStatic(N_Vector y, N_Vector b);

  /// A linear solver for SUNDIALS that calls `callback` of `owner`: int (void* owner, N_Vector y, N_Vector b).
  using Callback = int (*)(void* owner, N_Vector y, N_Vector b);
  /// iterative: dressed as a matrix-free iteration that converges at once, for KINSOL, which takes no solver that holds
  /// its own matrix.
  SUNLinearSolver makeLinearSolver(Callback callback, void* owner, SUNContext context, bool iterative = false);
  /// K(x) u where the residual was evaluated last, zero where motion is prescribed.
  void staticTangentProduct(N_Vector u, N_Vector Ku);

  /// Largest component of the last right-hand side of a linear solve.
  double lastResidual() const { return lastResidual_; }
  /// What a linear solve complained about last, else empty.
  const std::string& complaint() const { return complaint_; }
  void clearComplaint() { complaint_.clear(); }

 private:
  struct Adapter {
    Callback callback;
    void* owner;
  };
  /// Solves (mFactor M + kFactor K) u = r over the free degrees of freedom; u = 0 at the others.
  bool solveFree(double mFactor, double kFactor, const NodeVectors& r, NodeVectors& u);
  bool factorise(double mFactor, double kFactor);
  bool conjugateGradients(double mFactor, double kFactor, const NodeVectors& r, NodeVectors& u);
  void clearConstrained(NodeVectors& u) const;

  ImplicitOptions options_;
  DifferentiableSystem* system_ = nullptr;
  NodeVectors x_;  // where the right-hand side was evaluated last
  NodeVectors zero_, product_, load_, held_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;
  Eigen::Index analysed_ = -1;  // nonzeros of the pattern that factor_ knows
  Adapter adapter_{};
  double lastResidual_ = 0;
  std::string complaint_;
};

/// Absolute tolerances for positions and velocities from the options, the size of the system and the step.
void setTolerances(const ImplicitOptions& options, const State& state, double h, N_Vector tolerances);

}  // namespace ringwatch::detail

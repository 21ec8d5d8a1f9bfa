#pragma once
#include <optional>
#include <string>
#include <vector>

#include <sundials/sundials_linearsolver.h>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/integrators/sundials/implicit.h>
#include <ringwatch/integrators/sundials/state_vector.h>

namespace ringwatch::detail {

/// The right-hand side of (ẋ, v̇) = (v, a(t, x, v)) and the linear systems of Newton's method for it, as SUNDIALS wants
/// them: a linear solver that holds its own matrix.
///
/// (I - γ J)(dx, dv) = (p, q) with J = [0 I; -M⁻¹K -M⁻¹C]: dx = p + γ dv and (M + γ C + γ² K) dv = M q - γ K p, a
/// symmetric system of half the size. The derivative of K along v, which Rayleigh damping would add, is left out:
/// Newton's method converges linearly then, to the same solution. Where motion is prescribed a = 0, so that dv = q
/// there.
class NewtonSystem {
 public:
  explicit NewtonSystem(const ImplicitOptions& options) : options_(options) { SUNContext_Create(nullptr, &context_); }
  ~NewtonSystem() { SUNContext_Free(&context_); }
  NewtonSystem(const NewtonSystem&) = delete;
  NewtonSystem& operator=(const NewtonSystem&) = delete;

  void attach(DifferentiableSystem& system) {
    if (system_ != &system) diagonal_.clear();
    system_ = &system;
  }
  DifferentiableSystem& system() { return *system_; }
  const ImplicitOptions& options() const { return options_; }
  SUNContext context() const { return context_; }

  /// Right-hand side at y; remembers where, since Newton's matrix is taken at the last point evaluated. 0, or 1
  /// (recoverable) when it is not finite.
  int rightHandSide(double time, N_Vector y, N_Vector dy);
  /// Solves (I - γ J) y = b. 0, or 1 when it does not work.
  int solve(double gamma, N_Vector y, N_Vector b);

  /// A linear solver for SUNDIALS that calls `callback` of `owner`: int (void* owner, N_Vector y, N_Vector b).
  using Callback = int (*)(void* owner, N_Vector y, N_Vector b);
  SUNLinearSolver makeLinearSolver(Callback callback, void* owner);

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
  /// The matrix-free solvers: iterations, or nothing with a complaint.
  std::optional<int> conjugateGradients(const NodeVectors& r, NodeVectors& u);
  std::optional<int> gmres(const NodeVectors& r, NodeVectors& u);
  /// The matrix-free matrix at x_, and its block-Jacobi preconditioner.
  void multiply(const NodeVectors& u, NodeVectors& Au);
  void precondition(const NodeVectors& r, NodeVectors& z) const;
  void updatePreconditioner();
  void clearConstrained(NodeVectors& u) const;

  ImplicitOptions options_;
  DifferentiableSystem* system_ = nullptr;
  NodeVectors x_;  // where the right-hand side was evaluated last
  NodeVectors zero_, product_, load_, held_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;
  Eigen::Index analysed_ = -1;             // nonzeros of the pattern that factor_ knows
  double mFactor_ = 0, kFactor_ = 0;       // of the matrix-free matrix
  std::vector<Eigen::Matrix3d> diagonal_;  // 3×3 diagonal blocks of K, perhaps of an earlier x; empty: none yet
  std::vector<Eigen::Matrix3d> inverse_;   // of mFactor M + kFactor diagonal
  int iterationsWhenFresh_ = 0;            // of the solve that followed the making of diagonal_; 0: not solved yet
  Adapter adapter_{};
  SUNContext context_ = nullptr;
  double lastResidual_ = 0;
  std::string complaint_;
};

/// Absolute tolerances for positions and velocities from the options, the size of the system and the step.
void setTolerances(const ImplicitOptions& options, const State& state, double h, N_Vector tolerances);

}  // namespace ringwatch::detail

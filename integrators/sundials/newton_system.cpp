#include <ringwatch/integrators/sundials/newton_system.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <sunlinsol/sunlinsol_spgmr.h>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/error.h>

namespace ringwatch::detail {

int NewtonSystem::rightHandSide(double time, N_Vector y, N_Vector dy) {
  x_ = positions(y);
  positions(dy) = velocities(y);
  system_->acceleration(time, x_, velocities(y), velocities(dy));
  return velocities(dy).allFinite() ? 0 : 1;
}

void NewtonSystem::clearConstrained(NodeVectors& u) const {
  for (Eigen::Index i = 0; i < u.cols(); ++i)
    for (int c = 0; c < 3; ++c)
      if (system_->isConstrained(i, c)) u(c, i) = 0;
}

int NewtonSystem::solve(double gamma, N_Vector y, N_Vector b) {
  const NodeVectors &p = positions(b), &q = velocities(b);
  lastResidual_ = std::max(p.cwiseAbs().maxCoeff(), q.cwiseAbs().maxCoeff());
  const RayleighDamping damping = system_->damping();
  const double mFactor = 1 + gamma * damping.alpha, kFactor = gamma * (damping.beta + gamma);
  // held_: dv where motion is prescribed, zero elsewhere.
  held_ = q;
  clearConstrained(held_);
  held_ = q - held_;
  zero_ = gamma * p + kFactor * held_;
  system_->stiffnessProduct(x_, zero_, product_);
  load_ = q * system_->mass().asDiagonal();
  load_ -= product_;
  clearConstrained(load_);
  NodeVectors& dv = velocities(y);
  // b may be y: everything that is needed of b is read before.
  zero_ = p;
  if (!solveFree(mFactor, kFactor, load_, dv)) return 1;
  dv += held_;
  positions(y) = zero_ + gamma * dv;
  return 0;
}

bool NewtonSystem::solveFree(double mFactor, double kFactor, const NodeVectors& r, NodeVectors& u) {
  if (options_.linearSolve == LinearSolve::direct) {
    if (!factorise(mFactor, kFactor)) return false;
    const Eigen::VectorXd solution = factor_.solve(r.reshaped());
    u = solution.reshaped(3, r.cols());
    if (!u.allFinite()) complaint_ = "the linear system has no finite solution";
    return u.allFinite();
  }
  u = NodeVectors::Zero(3, r.cols());
  if (r.norm() == 0) return true;
  mFactor_ = mFactor;
  kFactor_ = kFactor;
  // Assembling the diagonal blocks costs as much as many products, and those of an earlier state serve nearly as well:
  // they are made again only when the iterations have grown, or when there was no solution.
  constexpr double grown = 1.5;
  constexpr int spare = 5;
  for (;;) {
    const bool fresh = diagonal_.empty();
    if (fresh) {
      system_->stiffnessDiagonal(x_, diagonal_);
      iterationsWhenFresh_ = 0;
    }
    updatePreconditioner();
    const std::optional<int> iterations =
        options_.linearSolve == LinearSolve::gmres ? gmres(r, u) : conjugateGradients(r, u);
    if (iterations && iterationsWhenFresh_ == 0) iterationsWhenFresh_ = *iterations;
    if (!iterations || *iterations > grown * iterationsWhenFresh_ + spare) diagonal_.clear();
    if (iterations) return true;
    if (fresh) return false;
    complaint_.clear();
  }
}

bool NewtonSystem::factorise(double mFactor, double kFactor) {
  Eigen::SparseMatrix<double> A = system_->stiffness(x_);
  const auto held = [&](Eigen::Index dof) { return system_->isConstrained(dof / 3, static_cast<int>(dof % 3)); };
  double largest = 0;
  for (Eigen::Index column = 0; column < A.outerSize(); ++column)
    for (Eigen::SparseMatrix<double>::InnerIterator entry(A, column); entry; ++entry) {
      entry.valueRef() = held(column) || held(entry.row()) ? 0.0 : kFactor * entry.value();
      largest = std::max(largest, std::abs(entry.value()));
    }
  // A held degree of freedom keeps its row with any positive diagonal; its load is zero.
  for (Eigen::Index dof = 0; dof < A.rows(); ++dof)
    A.coeffRef(dof, dof) += held(dof) ? std::max(largest, 1.0) : mFactor * system_->mass()[dof / 3];
  A.makeCompressed();
  if (analysed_ != A.nonZeros()) {
    factor_.analyzePattern(A);
    analysed_ = A.nonZeros();
  }
  factor_.factorize(A);
  if (factor_.info() != Eigen::Success) complaint_ = "the matrix of Newton's method is singular";
  return factor_.info() == Eigen::Success;
}

void NewtonSystem::multiply(const NodeVectors& u, NodeVectors& Au) {
  system_->stiffnessProduct(x_, u, product_);
  Au = mFactor_ * u * system_->mass().asDiagonal() + kFactor_ * product_;
  clearConstrained(Au);
}

void NewtonSystem::updatePreconditioner() {
  const Eigen::VectorXd& mass = system_->mass();
  inverse_.resize(diagonal_.size());
  for (std::size_t i = 0; i < diagonal_.size(); ++i) {
    const double inertia = mFactor_ * mass[i];
    Eigen::Matrix3d D = kFactor_ * diagonal_[i] + inertia * Eigen::Matrix3d::Identity();
    for (int c = 0; c < 3; ++c)
      if (system_->isConstrained(i, c)) {
        D.row(c).setZero();
        D.col(c).setZero();
        D(c, c) = 1;
      }
    const Eigen::LLT<Eigen::Matrix3d> factor(D);
    // A block that is not positive definite would make the iteration meaningless: only its size is used.
    inverse_[i] = factor.info() == Eigen::Success
                      ? factor.solve(Eigen::Matrix3d::Identity()).eval()
                      : Eigen::Matrix3d::Identity() / std::max(D.norm(), std::numeric_limits<double>::min());
  }
}

void NewtonSystem::precondition(const NodeVectors& r, NodeVectors& z) const {
  z.resize(3, r.cols());
  for (Eigen::Index i = 0; i < r.cols(); ++i) z.col(i) = inverse_[i] * r.col(i);
}

std::optional<int> NewtonSystem::conjugateGradients(const NodeVectors& r, NodeVectors& u) {
  NodeVectors s = r, z, d, Ad;
  u.setZero();
  const double goal = options_.linearTolerance * r.norm();
  precondition(s, z);
  d = z;
  double sz = s.cwiseProduct(z).sum();
  for (int iteration = 1; iteration <= 30 * r.cols() + 100; ++iteration) {
    multiply(d, Ad);
    const double curvature = d.cwiseProduct(Ad).sum();
    if (!(curvature > 0)) {
      complaint_ = "conjugate gradients met an indefinite matrix; use the direct solver, gmres or a smaller step";
      return std::nullopt;
    }
    const double step = sz / curvature;
    u += step * d;
    s -= step * Ad;
    if (s.norm() <= goal) return iteration;
    precondition(s, z);
    const double before = sz;
    sz = s.cwiseProduct(z).sum();
    d = z + (sz / before) * d;
  }
  complaint_ = joinText("conjugate gradients left a relative residual of ", s.norm() / r.norm());
  return std::nullopt;
}

std::optional<int> NewtonSystem::gmres(const NodeVectors& r, NodeVectors& u) {
  constexpr int basis = 40, restarts = 50;
  load_ = r;  // what GMRES is given is not const
  NodeVectors none(3, 0);
  N_Vector solution = wrapState(u, none, context_), rightSide = wrapState(load_, none, context_);
  // Preconditioned from the right, so that the residual that it looks at is the true one.
  SUNLinearSolver solver = SUNLinSol_SPGMR(solution, SUN_PREC_RIGHT, basis, context_);
  SUNLinSol_SPGMRSetMaxRestarts(solver, restarts);
  SUNLinSolSetATimes(solver, this, [](void* self, N_Vector v, N_Vector z) {
    static_cast<NewtonSystem*>(self)->multiply(positions(v), positions(z));
    return 0;
  });
  SUNLinSolSetPreconditioner(solver, this, nullptr, [](void* self, N_Vector v, N_Vector z, realtype, int) {
    static_cast<NewtonSystem*>(self)->precondition(positions(v), positions(z));
    return 0;
  });
  SUNLinSolInitialize(solver);
  SUNLinSolSetup(solver, nullptr);
  u.setZero();
  SUNLinSolSetZeroGuess(solver, SUNTRUE);
  const int flag = SUNLinSolSolve(solver, nullptr, solution, rightSide, options_.linearTolerance * r.norm());
  const int iterations = SUNLinSolNumIters(solver);
  if (flag != 0 || !u.allFinite())
    complaint_ = joinText("GMRES left a relative residual of ", SUNLinSolResNorm(solver) / r.norm(), " after ",
                          iterations, " iterations");
  SUNLinSolFree(solver);
  N_VDestroy(rightSide);
  N_VDestroy(solution);
  if (!complaint_.empty()) return std::nullopt;
  return iterations;
}

SUNLinearSolver NewtonSystem::makeLinearSolver(Callback callback, void* owner) {
  adapter_ = {callback, owner};
  SUNLinearSolver solver = SUNLinSolNewEmpty(context_);
  solver->content = &adapter_;
  solver->ops->gettype = [](SUNLinearSolver) { return SUNLINEARSOLVER_MATRIX_EMBEDDED; };
  solver->ops->solve = [](SUNLinearSolver self, SUNMatrix, N_Vector y, N_Vector b, realtype) {
    const auto* adapter = static_cast<const Adapter*>(self->content);
    return adapter->callback(adapter->owner, y, b);
  };
  solver->ops->free = [](SUNLinearSolver self) {
    self->content = nullptr;
    SUNLinSolFreeEmpty(self);
    return 0;
  };
  return solver;
}

void setTolerances(const ImplicitOptions& options, const State& state, double h, N_Vector tolerances) {
  const double extent = (state.x.rowwise().maxCoeff() - state.x.rowwise().minCoeff()).maxCoeff();
  double size =
      extent > 0 ? extent : std::max(state.x.cwiseAbs().maxCoeff(), std::abs(h) * state.v.cwiseAbs().maxCoeff());
  // A state that has died away still needs weights that are numbers.
  size = std::max(size, 1e-100);
  const double position = options.positionTolerance > 0 ? options.positionTolerance : options.relativeTolerance * size;
  positions(tolerances).setConstant(position);
  velocities(tolerances)
      .setConstant(options.velocityTolerance > 0 ? options.velocityTolerance : position / std::abs(h));
}

}  // namespace ringwatch::detail

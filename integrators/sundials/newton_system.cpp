#include <ringwatch/integrators/sundials/newton_system.h>

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include <ringwatch/base/error.h>

namespace ringwatch::detail {

int NewtonSystem::rightHandSide(double time, N_Vector y, N_Vector dy) {
  x_ = positions(y);
  positions(dy) = velocities(y);
  system_->acceleration(time, x_, velocities(y), velocities(dy));
  return velocities(dy).allFinite() ? 0 : 1;
}

int NewtonSystem::staticResidual(double time, N_Vector y, N_Vector r) {
  x_ = positions(y);
  zero_ = NodeVectors::Zero(3, x_.cols());
  system_->acceleration(time, x_, zero_, positions(r));
  positions(r) = -(positions(r) * system_->mass().asDiagonal());
  return positions(r).allFinite() ? 0 : 1;
}

void NewtonSystem::clearConstrained(NodeVectors& u) const {
  for (Eigen::Index i = 0; i < u.cols(); ++i)
    for (int c = 0; c < 3; ++c)
      if (system_->isConstrained(static_cast<std::int32_t>(i), c)) u(c, i) = 0;
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

int NewtonSystem::solveStatic(N_Vector y, N_Vector b) {
  load_ = positions(b);
  clearConstrained(load_);
  lastResidual_ = load_.cwiseAbs().maxCoeff();
  return solveFree(0, 1, load_, positions(y)) ? 0 : 1;
}

bool NewtonSystem::solveFree(double mFactor, double kFactor, const NodeVectors& r, NodeVectors& u) {
  if (options_.linearSolve == LinearSolve::conjugateGradients) return conjugateGradients(mFactor, kFactor, r, u);
  if (!factorise(mFactor, kFactor)) return false;
  const Eigen::VectorXd solution = factor_.solve(r.reshaped());
  u = solution.reshaped(3, r.cols());
  if (!u.allFinite()) complaint_ = "the linear system has no finite solution";
  return u.allFinite();
}

bool NewtonSystem::factorise(double mFactor, double kFactor) {
  Eigen::SparseMatrix<double> A = system_->stiffness(x_);
  const auto held = [&](Eigen::Index dof) {
    return system_->isConstrained(static_cast<std::int32_t>(dof / 3), static_cast<int>(dof % 3));
  };
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

bool NewtonSystem::conjugateGradients(double mFactor, double kFactor, const NodeVectors& r, NodeVectors& u) {
  const Eigen::Index n = r.cols();
  const Eigen::VectorXd& mass = system_->mass();
  // Block-Jacobi.
  std::vector<Eigen::Matrix3d> inverse(static_cast<std::size_t>(n), Eigen::Matrix3d::Zero());
  const Eigen::SparseMatrix<double> K = system_->stiffness(x_);
  for (Eigen::Index i = 0; i < n; ++i) {
    Eigen::Matrix3d& D = inverse[static_cast<std::size_t>(i)];
    for (int c = 0; c < 3; ++c)
      for (Eigen::SparseMatrix<double>::InnerIterator entry(K, 3 * i + c); entry; ++entry)
        if (entry.row() / 3 == i) D(entry.row() % 3, c) = kFactor * entry.value();
    D.diagonal().array() += mFactor * mass[i];
    for (int c = 0; c < 3; ++c)
      if (system_->isConstrained(static_cast<std::int32_t>(i), c)) {
        D.row(c).setZero();
        D.col(c).setZero();
        D(c, c) = 1;
      }
    D = D.inverse().eval();
  }
  const auto precondition = [&](const NodeVectors& s, NodeVectors& z) {
    z.resize(3, n);
    for (Eigen::Index i = 0; i < n; ++i) z.col(i) = inverse[static_cast<std::size_t>(i)] * s.col(i);
  };
  NodeVectors s = r, z, d;
  u = NodeVectors::Zero(3, n);
  const double goal = options_.linearTolerance * r.norm();
  if (r.norm() == 0) return true;
  precondition(s, z);
  d = z;
  double sz = s.cwiseProduct(z).sum();
  for (Eigen::Index iteration = 0; iteration < 30 * n + 100; ++iteration) {
    system_->stiffnessProduct(x_, d, product_);
    product_ = mFactor * d * mass.asDiagonal() + kFactor * product_;
    clearConstrained(product_);
    const double curvature = d.cwiseProduct(product_).sum();
    if (!(curvature > 0)) {
      complaint_ = "conjugate gradients met an indefinite matrix; use the direct solver or a smaller step";
      return false;
    }
    const double step = sz / curvature;
    u += step * d;
    s -= step * product_;
    if (s.norm() <= goal) return true;
    precondition(s, z);
    const double before = sz;
    sz = s.cwiseProduct(z).sum();
    d = z + (sz / before) * d;
  }
  complaint_ = joinText("conjugate gradients left a relative residual of ", s.norm() / r.norm());
  return false;
}

void NewtonSystem::staticTangentProduct(N_Vector u, N_Vector Ku) {
  load_ = positions(u);
  clearConstrained(load_);
  system_->stiffnessProduct(x_, load_, positions(Ku));
  clearConstrained(positions(Ku));
}

SUNLinearSolver NewtonSystem::makeLinearSolver(Callback callback, void* owner, SUNContext context, bool iterative) {
  adapter_ = {callback, owner};
  SUNLinearSolver solver = SUNLinSolNewEmpty(context);
  solver->content = &adapter_;
  solver->ops->gettype = [](SUNLinearSolver) { return SUNLINEARSOLVER_MATRIX_EMBEDDED; };
  solver->ops->solve = [](SUNLinearSolver self, SUNMatrix, N_Vector y, N_Vector b, realtype) {
    const auto* adapter = static_cast<const Adapter*>(self->content);
    return adapter->callback(adapter->owner, y, b);
  };
  if (iterative) {
    solver->ops->gettype = [](SUNLinearSolver) { return SUNLINEARSOLVER_ITERATIVE; };
    solver->ops->setatimes = [](SUNLinearSolver, void*, SUNATimesFn) { return 0; };
    solver->ops->numiters = [](SUNLinearSolver) { return 1; };
    solver->ops->resnorm = [](SUNLinearSolver) -> realtype { return 0; };
  }
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

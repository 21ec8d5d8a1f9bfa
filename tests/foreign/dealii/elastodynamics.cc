// Explicit dynamics of a St. Venant-Kirchhoff bar of trilinear hexahedra in the style of deal.II's tutorials: cells are
// assembled with FEValues, and the mass is lumped by the vertex rule. Its cell matrices are in our bracket at every step,
// held to the eigenvalues of its assembled matrix. Exit status 1 where the bracket does not hold or is too wide.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <Eigen/Eigenvalues>

#include <ringwatch/monitor/tangent_bracket.h>

#include "element_tangents.h"

using namespace dealii;

class Elastodynamics {
 public:
  explicit Elastodynamics(double jitter) : jitter(jitter), fe(FE_Q<3>(1), 3), dof_handler(triangulation) {}
  bool run();

 private:
  void setup();
  void assemble_tangent(ElementTangents& tangents);
  void assemble_force();
  double exact_step() const;

  static constexpr double young = 1e6, poisson = 0.3, density = 1000;  // Pa, 1, kg/m3
  static constexpr double mu = young / (2 * (1 + poisson)),
                          lambda = young * poisson / ((1 + poisson) * (1 - 2 * poisson));
  static SymmetricTensor<2, 3> stress(const SymmetricTensor<2, 3>& E) {
    return lambda * trace(E) * unit_symmetric_tensor<3>() + 2 * mu * E;
  }

  double jitter;
  Triangulation<3> triangulation;
  FESystem<3> fe;
  DoFHandler<3> dof_handler;
  SparsityPattern sparsity_pattern;
  SparseMatrix<double> system_matrix;
  Vector<double> u, force, mass;
  std::vector<double> velocity, nodal_mass;
  std::vector<std::uint8_t> held;  // three a vertex
  std::vector<types::global_dof_index> dof_of;  // 3 vertex + component
};

void Elastodynamics::setup() {
  GridGenerator::subdivided_hyper_rectangle(triangulation, {8, 2, 2}, Point<3>(0, 0, 0), Point<3>(0.16, 0.04, 0.04));
  if (jitter > 0) GridTools::distort_random(jitter, triangulation, true, 1);
  dof_handler.distribute_dofs(fe);
  DynamicSparsityPattern dsp(dof_handler.n_dofs());
  DoFTools::make_sparsity_pattern(dof_handler, dsp);
  sparsity_pattern.copy_from(dsp);
  system_matrix.reinit(sparsity_pattern);
  u.reinit(dof_handler.n_dofs());
  force.reinit(dof_handler.n_dofs());
  mass.reinit(dof_handler.n_dofs());
  // The vertex rule makes the mass matrix diagonal.
  FEValues<3> fe_values(fe, QGaussLobatto<3>(2), update_values | update_JxW_values);
  const FEValuesExtractors::Vector displacement(0);
  std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
  held.assign(3 * triangulation.n_vertices(), 0);
  dof_of.resize(held.size());
  velocity.assign(dof_handler.n_dofs(), 0.0);
  for (const auto& cell : dof_handler.active_cell_iterators()) {
    fe_values.reinit(cell);
    cell->get_dof_indices(dofs);
    for (const unsigned int i : fe_values.dof_indices())
      for (const unsigned int q : fe_values.quadrature_point_indices())
        mass(dofs[i]) += density * fe_values[displacement].value(i, q).norm_square() * fe_values.JxW(q);
    for (const unsigned int v : cell->vertex_indices())
      for (unsigned int c = 0; c < 3; ++c) {
        const unsigned int place = 3 * cell->vertex_index(v) + c;
        dof_of[place] = cell->vertex_dof_index(v, c);
        const double x = cell->vertex(v)[0];
        if (x < 1e-9 || x > 0.16 - 1e-9) held[place] = 1;
        if (x > 0.16 - 1e-9 && c == 0) velocity[dof_of[place]] = 1;  // m/s
      }
  }
  for (unsigned int v = 0; v < triangulation.n_vertices(); ++v) nodal_mass.push_back(mass(dof_of[3 * v]));
}

void Elastodynamics::assemble_tangent(ElementTangents& tangents) {
  tangents = {};
  system_matrix = 0;
  const QGauss<3> quadrature(2);
  FEValues<3> fe_values(fe, quadrature, update_gradients | update_JxW_values);
  const FEValuesExtractors::Vector displacement(0);
  const unsigned int n = fe.n_dofs_per_cell();
  FullMatrix<double> cell_matrix(n, n);
  std::vector<types::global_dof_index> dofs(n);
  std::vector<Tensor<2, 3>> gradient(quadrature.size()), shape(n);
  std::vector<SymmetricTensor<2, 3>> strain(n), stress_of(n);
  for (const auto& cell : dof_handler.active_cell_iterators()) {
    fe_values.reinit(cell);
    fe_values[displacement].get_function_gradients(u, gradient);
    cell_matrix = 0;
    for (const unsigned int q : fe_values.quadrature_point_indices()) {
      const Tensor<2, 3> F = unit_symmetric_tensor<3>() + gradient[q];
      const SymmetricTensor<2, 3> S = stress(0.5 * symmetrize(transpose(F) * F - Tensor<2, 3>(unit_symmetric_tensor<3>())));
      for (unsigned int i = 0; i < n; ++i) {
        shape[i] = fe_values[displacement].gradient(i, q);
        strain[i] = symmetrize(transpose(F) * shape[i]);
        stress_of[i] = stress(strain[i]);
      }
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j <= i; ++j)
          cell_matrix(i, j) +=
              (strain[i] * stress_of[j] + S * symmetrize(transpose(shape[i]) * shape[j])) * fe_values.JxW(q);
    }
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < i; ++j) cell_matrix(j, i) = cell_matrix(i, j);
    cell->get_dof_indices(dofs);
    system_matrix.add(dofs, cell_matrix);
    tangents.push(cell, cell_matrix);
  }
}

void Elastodynamics::assemble_force() {
  force = 0;
  const QGauss<3> quadrature(2);
  FEValues<3> fe_values(fe, quadrature, update_gradients | update_JxW_values);
  const FEValuesExtractors::Vector displacement(0);
  std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
  std::vector<Tensor<2, 3>> gradient(quadrature.size());
  for (const auto& cell : dof_handler.active_cell_iterators()) {
    fe_values.reinit(cell);
    fe_values[displacement].get_function_gradients(u, gradient);
    cell->get_dof_indices(dofs);
    for (const unsigned int q : fe_values.quadrature_point_indices()) {
      const Tensor<2, 3> F = unit_symmetric_tensor<3>() + gradient[q];
      const SymmetricTensor<2, 3> S = stress(0.5 * symmetrize(transpose(F) * F - Tensor<2, 3>(unit_symmetric_tensor<3>())));
      for (const unsigned int i : fe_values.dof_indices())
        force(dofs[i]) += S * symmetrize(transpose(F) * fe_values[displacement].gradient(i, q)) * fe_values.JxW(q);
    }
  }
}

/// 2/omega of the assembled matrix, on free degrees of freedom.
double Elastodynamics::exact_step() const {
  const auto size = static_cast<Eigen::Index>(held.size());
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(size, size);
  for (Eigen::Index i = 0; i < size; ++i)
    for (Eigen::Index j = 0; j < size; ++j)
      if (!held[i] && !held[j])
        K(i, j) = system_matrix.el(dof_of[i], dof_of[j]) / std::sqrt(mass(dof_of[i]) * mass(dof_of[j]));
  return 2 / std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K, Eigen::EigenvaluesOnly).eigenvalues()[size - 1]);
}

bool Elastodynamics::run() {
  setup();
  ElementTangents tangents;
  assemble_tangent(tangents);
  ringwatch::TangentBracket bracket(nodal_mass, {{8, tangents.nodes}}, held);
  ringwatch::CriticalStep step = bracket.evaluate({tangents.values}, 2.0);
  double exact = exact_step(), widest = 0;
  std::printf("deal.II, jitter %g: at rest safe %.6e s, exact %.6e s, optimistic %.6e s\n", jitter, step.safe, exact,
              step.optimistic);
  const auto holds = [&] { return step.safe <= exact * (1 + 1e-9) && exact * (1 - 1e-9) <= step.optimistic; };
  bool good = holds() && step.safe >= 0.99 * exact && step.optimistic <= 1.001 * exact;
  const double h = 0.98 * step.safe;
  for (int n = 0; n < 1000 && good; ++n) {
    assemble_tangent(tangents);
    step = bracket.evaluate({tangents.values}, 2.0);
    const bool left = h > step.optimistic;
    if (n % 10 == 0 || left) {
      exact = exact_step();
      widest = std::max(widest, step.optimistic / step.safe - 1);
      good = holds() && widest <= 0.05;
    }
    if (left) {
      std::printf("deal.II, jitter %g: left the bracket at step %d: h = %.6e s, optimistic %.6e s\n", jitter, n, h,
                  step.optimistic);
      std::printf("deal.II, jitter %g: bracket at most %.3f %% wide until then\n", jitter, 100 * widest);
      return good && h > exact;
    }
    assemble_force();
    for (unsigned int place = 0; place < held.size(); ++place) {
      const auto dof = dof_of[place];
      if (!held[place]) velocity[dof] -= h * force(dof) / mass(dof);
      u(dof) += h * velocity[dof];
    }
  }
  std::printf("deal.II, jitter %g: the bracket does not hold or was never left: safe %.6e s, exact %.6e s, optimistic %.6e s\n",
              jitter, step.safe, exact, step.optimistic);
  return false;
}

int main() {
  bool good = true;
  for (const double jitter : {0.0, 0.2}) good = Elastodynamics(jitter).run() && good;
  return good ? 0 : 1;
}

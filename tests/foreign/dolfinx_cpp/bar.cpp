// A bar of St. Venant-Kirchhoff tetrahedra in dolfinx's C++: its tangents in our bracket at every step of an explicit
// run, held to the eigenvalues of its own assembled matrix. Exit status 1 where the bracket does not hold or is too
// wide.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <dolfinx/fem/Function.h>
#include <dolfinx/fem/FunctionSpace.h>
#include <dolfinx/fem/utils.h>
#include <dolfinx/mesh/Mesh.h>
#include <dolfinx/mesh/generation.h>
#include <ringwatch/monitor/tangent_bracket.h>
#include <Eigen/Eigenvalues>
#include <dolfinx/common/loguru.hpp>

#include "bar_forms.h"
#include "element_tangents.h"

namespace {

using dolfinx::fem::Form;

std::vector<double> assembled(const Form<double>& form, std::size_t size) {
  std::vector<double> values(size, 0.0);
  dolfinx::fem::assemble_vector(std::span<double>(values), form);
  return values;
}

/// 2/omega of the matrix that dolfinx assembles, on free degrees of freedom.
double exactStep(const Form<double>& tangent, const std::vector<double>& mass, const std::vector<std::uint8_t>& held) {
  const auto size = static_cast<Eigen::Index>(mass.size());
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(size, size);
  const auto add = [&](std::span<const std::int32_t> rows, std::span<const std::int32_t> columns,
                       std::span<const double> values) {
    const std::size_t width = 3 * columns.size();
    for (std::size_t i = 0; i < 3 * rows.size(); ++i)
      for (std::size_t j = 0; j < width; ++j)
        K(3 * rows[i / 3] + static_cast<int>(i % 3), 3 * columns[j / 3] + static_cast<int>(j % 3)) +=
            values[i * width + j];
    return 0;
  };
  dolfinx::fem::assemble_matrix(add, tangent, {});
  for (Eigen::Index i = 0; i < size; ++i) {
    const double scale = held[static_cast<std::size_t>(i)] ? 0 : 1 / std::sqrt(mass[static_cast<std::size_t>(i)]);
    K.row(i) *= scale;
    K.col(i) *= scale;
  }
  return 2 /
         std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K, Eigen::EigenvaluesOnly).eigenvalues()[size - 1]);
}

int run() {
  namespace mesh = dolfinx::mesh;
  namespace fem = dolfinx::fem;
  constexpr double length = 0.16;
  auto box =
      std::make_shared<mesh::Mesh>(mesh::create_box(MPI_COMM_SELF, {{{0, 0, 0}, {length, 0.02, 0.02}}}, {8, 1, 1},
                                                    mesh::CellType::tetrahedron, mesh::GhostMode::none));
  auto V =
      std::make_shared<fem::FunctionSpace>(fem::create_functionspace(functionspace_form_bar_forms_tangent, "u", box));
  auto u = std::make_shared<fem::Function<double>>(V);
  const auto force = fem::create_form<double>(*form_bar_forms_force, {V}, {{"u", u}}, {}, {});
  const auto tangent = fem::create_form<double>(*form_bar_forms_tangent, {V, V}, {{"u", u}}, {}, {});
  const auto inertia = fem::create_form<double>(
      *form_bar_forms_mass, {V}, std::map<std::string, std::shared_ptr<const fem::Function<double>>>(), {}, {});
  const std::span<double> x = u->x()->mutable_array();
  const std::vector<double> mass = assembled(inertia, x.size()), points = V->tabulate_dof_coordinates(false);
  std::vector<double> nodal;
  for (std::size_t i = 0; i < mass.size(); i += 3) nodal.push_back(mass[i]);
  std::vector<std::uint8_t> held(mass.size(), 0);
  std::vector<double> v(mass.size(), 0.0);
  constexpr double speed = 1;  // m/s, of the right end
  for (std::size_t i = 0; i < nodal.size(); ++i) {
    const double at = points[3 * i];
    if (at > 1e-9 && at < length - 1e-9) continue;
    for (std::size_t c = 0; c < 3; ++c) held[3 * i + c] = 1;
    if (at > 1e-9) v[3 * i] = speed;
  }

  ElementTangents tangents;
  tangents.assemble(tangent);
  ringwatch::TangentBracket bracket(nodal, {{4, tangents.nodes}}, held);
  ringwatch::CriticalStep step = bracket.evaluate({tangents.values}, 2.0);
  double exact = exactStep(tangent, mass, held);
  std::printf("dolfinx C++: at rest safe %.6e s, exact %.6e s, optimistic %.6e s\n", step.safe, exact, step.optimistic);
  bool good = step.safe <= exact * (1 + 1e-9) && step.safe >= 0.99 * exact && step.optimistic >= exact * (1 - 1e-9) &&
              step.optimistic <= 1.0005 * exact;
  const double h = 0.98 * step.safe;
  double widest = 0;
  for (int n = 0; n < 400 && good; ++n) {
    tangents.assemble(tangent);
    step = bracket.evaluate({tangents.values}, 2.0);
    if (n % 10 == 0 || h > step.optimistic) {
      exact = exactStep(tangent, mass, held);
      widest = std::max(widest, step.optimistic / step.safe - 1);
      good = step.safe <= exact * (1 + 1e-9) && exact * (1 - 1e-9) <= step.optimistic && widest <= 0.04;
    }
    if (h > step.optimistic) {
      std::printf("dolfinx C++: left the bracket at step %d: h = %.6e s, optimistic %.6e s\n", n, h, step.optimistic);
      std::printf("dolfinx C++: bracket at most %.3f %% wide until then\n", 100 * widest);
      return good && h > exact ? 0 : 1;
    }
    const std::vector<double> f = assembled(force, x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (!held[i]) v[i] -= h * f[i] / mass[i];
      x[i] += h * v[i];
    }
  }
  std::printf(
      "dolfinx C++: the bracket does not hold or was never left: safe %.6e s, exact %.6e s, optimistic %.6e s\n",
      step.safe, exact, step.optimistic);
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  loguru::g_stderr_verbosity = loguru::Verbosity_WARNING;
  MPI_Init(&argc, &argv);
  const int status = run();
  MPI_Finalize();
  return status;
}

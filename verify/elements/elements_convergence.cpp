#include <cmath>
#include <map>

#include <Eigen/Dense>

#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/meshes/jacobian.h>
#include <ringwatch/verify/elements/elements_studies.h>
#include <ringwatch/verify/static_solver.h>
#include <ringwatch/verify/study_bodies.h>

namespace ringwatch::detail {
namespace {

/// u_i = A sin(k_i·X + φ_i), X in m on the unit cube.
struct Manufactured {
  double amplitude;                                                         // m
  Eigen::Matrix3d k{{1.3, 0.7, -0.9}, {-0.8, 1.2, 0.6}, {0.5, -1.1, 1.4}};  // rows k_i, 1/m
  Eigen::Vector3d phase{0.3, 1.1, -0.4};

  Eigen::Vector3d displacement(const Eigen::Vector3d& X) const {
    return amplitude * (k * X + phase).array().sin().matrix();
  }
  /// ∂u/∂X
  Eigen::Matrix3d gradient(const Eigen::Vector3d& X) const {
    return amplitude * ((k * X + phase).array().cos().matrix().asDiagonal() * k);
  }
  /// ∂²u/∂X∂X_J
  Eigen::Matrix3d secondGradient(const Eigen::Vector3d& X, int J) const {
    const Eigen::Vector3d s = -(k * X + phase).array().sin().matrix().cwiseProduct(k.col(J));
    return amplitude * (s.asDiagonal() * k);
  }
  /// The body force that holds it, b = -Div P, with (Div P)_i = Σ_J (∂P/∂F : ∂F/∂X_J)_iJ, N/m³.
  Eigen::Vector3d bodyForce(const Material& material, const Eigen::Vector3d& X) const {
    const auto toMatrix3 = [](const Eigen::Matrix3d& m) {
      Matrix3<double> r;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) r(i, j) = m(i, j);
      return r;
    };
    const Matrix3<double> F = toMatrix3(Eigen::Matrix3d::Identity() + gradient(X));
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    for (int J = 0; J < 3; ++J) {
      const Matrix3<double> dP = material.stressDifferential(F, toMatrix3(secondGradient(X, J)));
      for (int i = 0; i < 3; ++i) b[i] -= dP(i, J);
    }
    return b;
  }
};

struct Errors {
  double l2, h1;  // relative to the norm of the displacement and of its gradient; NaN when the solver failed
};
Errors solve(const ElementRule& c, std::string_view law, const Manufactured& exact, int cells) {
  BarOptions options;
  options.element = c.element->name;
  const Mesh mesh = generateCube(1.0, cells, options);
  const Material material = makeMaterial(law, young, poisson, density);
  Body body(mesh, material, c.options());
  for (const auto& [name, nodes] : mesh.nodeSets)
    for (const std::int32_t node : nodes) body.constraints().fix(node);
  body.externalForce() =
      consistentBodyForce(mesh, [&](const Eigen::Vector3d& X) { return exact.bodyForce(material, X); });
  NodeVectors start = mesh.X;
  for (Eigen::Index node = 0; node < start.cols(); ++node) start.col(node) += exact.displacement(mesh.X.col(node));
  const StaticSolution solution = solveStatic(body, start, {1, 30, 1e-10});
  if (!solution.converged) return {std::nan(""), std::nan("")};
  double l2 = 0, h1 = 0, size = 0, slope = 0;
  std::vector<double> N(c.element->nodes), dN(N.size() * 3);
  const MeshBlock& block = mesh.blocks[0];
  for (std::size_t e = 0; e < block.elementCount(); ++e) {
    const std::int32_t* nodes = block.element(e);
    for (const QuadraturePoint& q : finestRule(*c.element).points) {
      c.element->shape(q.xi, N.data());
      c.element->shapeGradient(q.xi, reinterpret_cast<double(*)[3]>(dN.data()));
      Eigen::Vector3d X = Eigen::Vector3d::Zero(), x = X;
      for (std::size_t a = 0; a < N.size(); ++a) {
        X += N[a] * mesh.X.col(nodes[a]);
        x += N[a] * solution.x.col(nodes[a]);
      }
      const Eigen::Matrix3d J = jacobianOf(mesh.X, nodes, c.element->nodes, dN.data()),
                            D = jacobianOf(solution.x, nodes, c.element->nodes, dN.data());
      const double w = q.weight * J.determinant();
      const Eigen::Matrix3d gradient = exact.gradient(X);
      l2 += w * (x - X - exact.displacement(X)).squaredNorm();
      h1 += w * (D * J.inverse() - Eigen::Matrix3d::Identity() - gradient).squaredNorm();
      size += w * exact.displacement(X).squaredNorm();
      slope += w * gradient.squaredNorm();
    }
  }
  return {std::sqrt(l2 / size), std::sqrt(h1 / slope)};
}

}  // namespace

void studyConvergence(StudyReport& report, StudyEffort effort) {
  StudyTable table{"convergence",
                   "A manufactured solution on the unit cube: relative errors and observed rates",
                   {"element", "rule", "law", "cells", "L2", "rate", "H1", "rate", "theory L2", "theory H1"},
                   {}};
  StudyFigure figure{"elements-error-size",
                     "Manufactured solution, StVK at large strain: error against element size",
                     "cell size (m)",
                     "relative L2 error",
                     true,
                     true,
                     {}};
  for (const ElementRule& c : allElementRules()) {
    if (c.rule->spuriousModes > 0) continue;  // shown by the rank study
    std::vector<int> meshes = c.element->order == 1 ? std::vector<int>{4, 8} : std::vector<int>{3, 6};
    if (effort == StudyEffort::full) meshes.push_back(c.element->order == 1 ? 12 : 8);
    for (const std::string_view law : {LinearElastic::name, StVenantKirchhoff::name}) {
      // Rules besides the default are held to theory with one law, to keep the study short.
      if (effort == StudyEffort::quick && !c.isDefault() && law == StVenantKirchhoff::name) continue;
      const Manufactured exact{law == LinearElastic::name ? 0.01 : 0.15};
      Errors before{};
      double l2Rate = 0, h1Rate = 0;
      StudyFigure::Curve curve{std::string(c.element->name), {}, {}};
      for (std::size_t m = 0; m < meshes.size(); ++m) {
        const Errors now = solve(c, law, exact, meshes[m]);
        const double ratio = m == 0 ? 1 : static_cast<double>(meshes[m]) / meshes[m - 1];
        l2Rate = m == 0 ? std::nan("") : std::log(before.l2 / now.l2) / std::log(ratio);
        h1Rate = m == 0 ? std::nan("") : std::log(before.h1 / now.h1) / std::log(ratio);
        table.rows.push_back({std::string(c.element->name), std::string(c.rule->name), std::string(law),
                              std::int64_t{meshes[m]}, now.l2, l2Rate, now.h1, h1Rate,
                              std::int64_t{c.element->order + 1}, std::int64_t{c.element->order}});
        curve.x.push_back(1.0 / meshes[m]);
        curve.y.push_back(now.l2);
        before = now;
      }
      if (c.isDefault() && law == StVenantKirchhoff::name) figure.curves.push_back(std::move(curve));
      const std::string name = c.name() + " " + std::string(law);
      // Measured: within 0.049 and 0.020 on the coarse meshes of the quick form.
      checkNear(report, name + ": rate in L2", l2Rate, c.element->order + 1, 0.1);
      checkNear(report, name + ": rate in H1", h1Rate, c.element->order, 0.05);
    }
  }
  report.tables.push_back(std::move(table));
  report.figures.push_back(std::move(figure));
}

}  // namespace ringwatch::detail

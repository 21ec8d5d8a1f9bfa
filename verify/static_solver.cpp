#include <ringwatch/verify/static_solver.h>

#include <algorithm>
#include <cmath>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/body/free_dofs.h>
#include <ringwatch/meshes/jacobian.h>
#include <ringwatch/monitor/small/symmetric_eigenpairs.h>

namespace ringwatch {

StaticSolution solveStatic(const Body& body, const NodeVectors& start, const StaticOptions& options) {
  const FreeDofs dofs(body);
  const double size = (body.mesh().X.rowwise().maxCoeff() - body.mesh().X.rowwise().minCoeff()).norm();
  Body::Workspace workspace;
  NodeVectors x = start, f;
  StaticSolution solution;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver;
  for (int step = 1; step <= options.loadSteps; ++step) {
    bool done = false;
    for (int i = 0; i < options.maxIterations && !done; ++i, ++solution.iterations) {
      body.internalForce(x, f, workspace);
      const Eigen::VectorXd residual =
          dofs.gather(body.externalForce() * (static_cast<double>(step) / options.loadSteps) - f);
      const Eigen::SparseMatrix<double> K = dofs.reduce(body.assembleTangent(x));
      if (solution.iterations == 0) solver.analyzePattern(K);
      solver.factorize(K);
      if (solver.info() != Eigen::Success) return solution;
      const Eigen::VectorXd change = solver.solve(residual);
      if (!change.allFinite()) return solution;
      dofs.addTo(x, change);
      done = change.lpNorm<Eigen::Infinity>() <= options.tolerance * size;
    }
    if (!done) return solution;
  }
  solution.converged = true;
  solution.x = std::move(x);
  return solution;
}

const QuadratureRule& finestRule(const ElementInfo& element) {
  const QuadratureRule* finest = &element.massRule;
  for (const QuadratureRule& rule : element.rules)
    if (rule.points.size() > finest->points.size()) finest = &rule;
  return *finest;
}

NodeVectors consistentBodyForce(const Mesh& mesh,
                                const std::function<Eigen::Vector3d(const Eigen::Vector3d& X)>& force) {
  NodeVectors f = NodeVectors::Zero(3, mesh.X.cols());
  double N[maxElementNodes], dN[maxElementNodes][3];
  for (const MeshBlock& block : mesh.blocks) {
    const ElementInfo& info = elementInfo(block.type);
    for (std::size_t e = 0; e < block.elementCount(); ++e) {
      const std::int32_t* nodes = block.element(e);
      for (const QuadraturePoint& q : finestRule(info).points) {
        info.shape(q.xi, N);
        info.shapeGradient(q.xi, dN);
        const Eigen::Matrix3d J = jacobianOf(mesh.X, nodes, info.nodes, dN[0]);
        Eigen::Vector3d X = Eigen::Vector3d::Zero();
        for (int a = 0; a < info.nodes; ++a) X += N[a] * mesh.X.col(nodes[a]);
        const Eigen::Vector3d b = force(X) * (q.weight * J.determinant());
        for (int a = 0; a < info.nodes; ++a) f.col(nodes[a]) += N[a] * b;
      }
    }
  }
  return f;
}

NodeVectors consistentTraction(const Mesh& mesh, const std::function<bool(const Eigen::Vector3d& X)>& onFace,
                               const std::function<Eigen::Vector3d(const Eigen::Vector3d& X)>& traction) {
  NodeVectors f = NodeVectors::Zero(3, mesh.X.cols());
  double N[maxElementNodes], dN[maxElementNodes][3];
  for (const MeshBlock& block : mesh.blocks) {
    const ElementInfo& info = elementInfo(block.type);
    for (std::size_t e = 0; e < block.elementCount(); ++e) {
      const std::int32_t* nodes = block.element(e);
      for (const auto& face : info.faces) {
        const int corners = face[3] < 0 ? 3 : 4;
        if (!std::all_of(face.begin(), face.begin() + corners,
                         [&](int a) { return onFace(Eigen::Vector3d(mesh.X.col(nodes[a]))); }))
          continue;
        const auto corner = [&](int i) {
          return Eigen::Vector3d(Eigen::Vector3d::Map(info.referenceNodes[face[i]].data()));
        };
        // Points (u, v) on [0, 1]² by three Gauss points each way; a triangle is the square with one side collapsed.
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t j = 0; j < 3; ++j) {
            const double u = 0.5 * (1 + gauss::x3[i]), v = 0.5 * (1 + gauss::x3[j]),
                         w = 0.25 * gauss::w3[i] * gauss::w3[j];
            Eigen::Vector3d xi, du, dv;
            double factor = w;
            if (corners == 4) {
              xi =
                  (1 - u) * (1 - v) * corner(0) + u * (1 - v) * corner(1) + u * v * corner(2) + (1 - u) * v * corner(3);
              du = (1 - v) * (corner(1) - corner(0)) + v * (corner(2) - corner(3));
              dv = (1 - u) * (corner(3) - corner(0)) + u * (corner(2) - corner(1));
            } else {
              du = corner(1) - corner(0);
              dv = corner(2) - corner(0);
              xi = corner(0) + u * du + v * (1 - u) * dv;
              factor *= 1 - u;
            }
            info.shape(xi.data(), N);
            info.shapeGradient(xi.data(), dN);
            const Eigen::Matrix3d J = jacobianOf(mesh.X, nodes, info.nodes, dN[0]);
            Eigen::Vector3d X = Eigen::Vector3d::Zero();
            for (int a = 0; a < info.nodes; ++a) X += N[a] * mesh.X.col(nodes[a]);
            const Eigen::Vector3d t = traction(X) * (factor * (J * du).cross(J * dv).norm());
            for (int a = 0; a < info.nodes; ++a) f.col(nodes[a]) += N[a] * t;
          }
      }
    }
  }
  return f;
}

NearestMode nearestMode(const Body& body, const NodeVectors& x, const NodeVectors& guess) {
  const FreeDofs dofs(body);
  const Eigen::VectorXd rootMass = dofs.gather(body.lumpedMass().transpose().replicate(3, 1)).cwiseSqrt();
  Eigen::SparseMatrix<double> A = dofs.reduce(body.assembleTangent(x));
  A = rootMass.cwiseInverse().asDiagonal() * A * rootMass.cwiseInverse().asDiagonal();
  const Eigen::VectorXd u = rootMass.cwiseProduct(dofs.gather(guess)).normalized();

  constexpr Eigen::Index wanted = 12;
  constexpr double leastShare = 0.1;
  constexpr double besides = 0.97;  // a guess may be exact, and its quotient then a pole
  NearestMode result;
  // A guess that is exact would end Lanczos before the wanted modes are there.
  const Eigen::VectorXd start = u + 0.1 * Eigen::VectorXd::NullaryExpr(u.size(), [](Eigen::Index i) {
                                            return std::sin(static_cast<double>(i * i));
                                          }).normalized();
  const SymmetricEigenpairs modes = nearestEigenpairs(A, besides * u.dot(A * u),
                                                      {.wanted = std::min<Eigen::Index>(wanted, A.rows() - 1),
                                                       .basis = std::min<Eigen::Index>(4 * wanted, A.rows()),
                                                       .start = start.data()});
  if (!modes.converged) return result;
  const Eigen::ArrayXd share = (modes.vectors.transpose() * u).array().square();
  const Eigen::ArrayXd counted = (share >= leastShare).select(share, 0.0);
  if (!(counted.sum() > 0)) return result;
  result.converged = true;
  result.lambda = (counted * modes.values.array()).sum() / counted.sum();
  result.overlap = std::sqrt(counted.sum());
  return result;
}

}  // namespace ringwatch

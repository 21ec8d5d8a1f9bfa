#pragma once
#include <functional>

#include <ringwatch/body/body.h>

namespace ringwatch {

struct StaticOptions {
  int loadSteps = 1;         // external force grows in that many equal steps
  int maxIterations = 30;    // Newton iterations a step
  double tolerance = 1e-12;  // of the last Newton correction, relative to the size of the body
};
struct StaticSolution {
  bool converged = false;
  NodeVectors x;       // equilibrium positions, 3×N, m; only when converged
  int iterations = 0;  // Newton iterations, all steps together
};
/// Static equilibrium of internal and external force by Newton's method with the exact tangent. Constrained components
/// stay where `start` (3×N, m) has them; the others begin there.
StaticSolution solveStatic(const Body& body, const NodeVectors& start, const StaticOptions& options = {});

/// The quadrature rule of an element with the most points, for loads and error norms.
const QuadratureRule& finestRule(const ElementInfo& element);

/// Consistent nodal forces, 3×N, N, of a body force b(X) in N/m³.
NodeVectors consistentBodyForce(const Mesh& mesh,
                                const std::function<Eigen::Vector3d(const Eigen::Vector3d& X)>& force);
/// Consistent nodal forces, 3×N, N, of a dead traction t(X) in Pa on the element faces whose corners all satisfy
/// `onFace`.
NodeVectors consistentTraction(const Mesh& mesh, const std::function<bool(const Eigen::Vector3d& X)>& onFace,
                               const std::function<Eigen::Vector3d(const Eigen::Vector3d& X)>& traction);

/// The vibration that a guess at a mode means, among those whose ω² lies nearest to the guess's Rayleigh quotient, of
/// K u = ω² M u at positions x. Modes of equal frequency are mixed by any mesh: all that hold a tenth of the guess or
/// more count as one, with the mean of their ω² by their shares in the guess.
struct NearestMode {
  bool converged = false;
  double lambda = 0;   // ω², rad²/s²; only when converged
  double overlap = 0;  // length of the guess's part in these modes over that of the guess, in the mass inner product
};
NearestMode nearestMode(const Body& body, const NodeVectors& x, const NodeVectors& guess);

}  // namespace ringwatch

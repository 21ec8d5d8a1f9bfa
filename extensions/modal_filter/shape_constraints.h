#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/body/body.h>

namespace ringwatch {

/// What a constraint keeps as it is at rest: C = value/rest - 1.
enum class ConstraintKind { edge, height, volume };

/// Keeps the length of an edge (nodes 0, 1), the signed height of node 3 over the face 0 1 2, or the volume of a
/// tetrahedron.
struct ShapeConstraint {
  ConstraintKind kind;
  std::array<std::int32_t, 4> nodes;  // -1 where there is none
  double rest;                        // m or m³

  int nodeCount() const { return kind == ConstraintKind::edge ? 2 : 4; }
};
/// C at positions x (3×N, m), and ∂C/∂x_a in column a of gradient, 1/m.
double constraintValue(const ShapeConstraint& constraint, const NodeVectors& x, Eigen::Matrix<double, 3, 4>& gradient);

/// Fierz 2013's constraints by the shape of each tetrahedron (section 4.1.2): the short edge of a wedge, the three
/// shortest edges of a needle, the shortest height of a cap, the volume of all others. An edge that elements share has
/// one.
std::vector<ShapeConstraint> shapeConstraints(const Mesh& mesh, const std::vector<ElementRef>& elements);

/// Fast projection (Goldenthal et al. 2007): Newton's method for C(x) = 0 along M⁻¹∂Cᵀ, with sparse Cholesky.
class ConstraintProjection {
 public:
  /// tolerance: of the largest |C|. iterations: at most. The body must outlive it.
  ConstraintProjection(const Body& body, std::vector<ShapeConstraint> constraints, double tolerance, int iterations);
  /// Moves the free nodes in x (3×N, m). "" or why the constraints could not be met; x is undefined then.
  std::string project(NodeVectors& x);

  const std::vector<ShapeConstraint>& constraints() const { return constraints_; }
  std::int64_t iterations() const { return total_; }

 private:
  const Body& body_;
  std::vector<ShapeConstraint> constraints_;
  double tolerance_;
  int iterations_;
  std::int64_t total_ = 0;
  Eigen::VectorXd inverseMass_;  // by degree of freedom; 0 where constrained, 1/kg
  Eigen::SparseMatrix<double> gradient_, matrix_;
  std::unique_ptr<Eigen::SimplicialLLT<Eigen::SparseMatrix<double>>> factor_;
};

}  // namespace ringwatch

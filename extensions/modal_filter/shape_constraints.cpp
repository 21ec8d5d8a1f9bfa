#include <ringwatch/extensions/modal_filter/shape_constraints.h>

#include <algorithm>
#include <cmath>
#include <set>

#include <Eigen/Geometry>

#include <ringwatch/base/error.h>
#include <ringwatch/meshes/quality.h>

namespace ringwatch {

double constraintValue(const ShapeConstraint& c, const NodeVectors& x, Eigen::Matrix<double, 3, 4>& gradient) {
  gradient.setZero();
  const Eigen::Vector3d p = x.col(c.nodes[0]), e1 = x.col(c.nodes[1]) - p;
  if (c.kind == ConstraintKind::edge) {
    const double length = e1.norm();
    gradient.col(1) = e1 / (length * c.rest);
    gradient.col(0) = -gradient.col(1);
    return length / c.rest - 1;
  }
  const Eigen::Vector3d e2 = x.col(c.nodes[2]) - p, e3 = x.col(c.nodes[3]) - p, normal = e1.cross(e2);
  gradient.col(1) = e2.cross(e3);
  gradient.col(2) = e3.cross(e1);
  gradient.col(3) = normal;
  double value = normal.dot(e3);  // six times the volume
  if (c.kind == ConstraintKind::volume) {
    gradient /= 6 * c.rest;
    value /= 6 * c.rest;
  } else {
    const double area2 = normal.norm();
    const Eigen::Vector3d n = normal / area2;
    value /= area2;  // the height
    gradient.col(1) -= value * e2.cross(n);
    gradient.col(2) -= value * n.cross(e1);
    gradient /= area2 * c.rest;
    value /= c.rest;
  }
  gradient.col(0) = -gradient.rightCols<3>().rowwise().sum();
  return value - 1;
}

std::vector<ShapeConstraint> shapeConstraints(const Mesh& mesh, const std::vector<ElementRef>& elements) {
  const double meanVolume = meshVolume(mesh) / static_cast<double>(mesh.elementCount());
  std::vector<ShapeConstraint> result;
  std::set<std::pair<std::int32_t, std::int32_t>> edges;
  for (const ElementRef ref : elements) {
    const MeshBlock& block = mesh.blocks[ref.block];
    const std::size_t e = ref.element;
    const std::int32_t* n = block.element(e);
    const ShapeClass shape = elementShape(block, e, mesh.X, meanVolume).shape;
    Eigen::Matrix<double, 3, 4> gradient;
    const auto add = [&](ConstraintKind kind, std::array<std::int32_t, 4> nodes) {
      ShapeConstraint constraint{kind, nodes, 1};
      constraint.rest = constraintValue(constraint, mesh.X, gradient) + 1;
      result.push_back(constraint);
    };
    if (shape == ShapeClass::wedge || shape == ShapeClass::needle) {
      std::vector<std::pair<double, std::pair<std::int32_t, std::int32_t>>> byLength;
      for (int a = 0; a < 4; ++a)
        for (int b = a + 1; b < 4; ++b)
          byLength.push_back({(mesh.X.col(n[b]) - mesh.X.col(n[a])).norm(), std::minmax(n[a], n[b])});
      std::sort(byLength.begin(), byLength.end());
      for (std::size_t k = 0; k < (shape == ShapeClass::wedge ? 1u : 3u); ++k)
        if (const auto [i, j] = byLength[k].second; edges.insert({i, j}).second)
          add(ConstraintKind::edge, {i, j, -1, -1});
    } else if (shape == ShapeClass::cap) {
      // Faces that see their opposite node on the side that makes its height positive.
      constexpr int faces[4][4] = {{1, 3, 2, 0}, {0, 2, 3, 1}, {0, 3, 1, 2}, {0, 1, 2, 3}};
      std::array<std::int32_t, 4> best{};
      double least = -1;
      for (const auto& f : faces) {
        const ShapeConstraint height{ConstraintKind::height, {n[f[0]], n[f[1]], n[f[2]], n[f[3]]}, 1};
        const double h = constraintValue(height, mesh.X, gradient) + 1;
        if (least >= 0 && h >= least) continue;
        least = h;
        best = height.nodes;
      }
      add(ConstraintKind::height, best);
    } else {
      add(ConstraintKind::volume, {n[0], n[1], n[2], n[3]});
    }
  }
  return result;
}

ConstraintProjection::ConstraintProjection(const Body& body, std::vector<ShapeConstraint> constraints, double tolerance,
                                           int iterations)
    : body_(body), constraints_(std::move(constraints)), tolerance_(tolerance), iterations_(iterations) {
  inverseMass_.resize(3 * body.nodeCount());
  for (std::int32_t i = 0; i < body.nodeCount(); ++i)
    for (int c = 0; c < 3; ++c)
      inverseMass_[3 * i + c] = body.constraints().isConstrained(i, c) ? 0 : 1 / body.lumpedMass()[i];
  // What hangs on constrained nodes alone cannot be moved.
  std::erase_if(constraints_, [&](const ShapeConstraint& c) {
    return std::all_of(c.nodes.begin(), c.nodes.begin() + c.nodeCount(),
                       [&](std::int32_t n) { return body.constraints().freeComponents(n) == 0; });
  });
}

std::string ConstraintProjection::project(NodeVectors& x) {
  const Eigen::Index count = constraints_.size();
  Eigen::VectorXd value(count);
  std::vector<Eigen::Triplet<double>> entries;
  for (int iteration = 0;; ++iteration) {
    entries.clear();
    for (Eigen::Index k = 0; k < count; ++k) {
      const ShapeConstraint& c = constraints_[k];
      Eigen::Matrix<double, 3, 4> gradient;
      value[k] = constraintValue(c, x, gradient);
      for (int a = 0; a < c.nodeCount(); ++a)
        for (int i = 0; i < 3; ++i)
          entries.emplace_back(static_cast<int>(3 * c.nodes[a] + i), static_cast<int>(k), gradient(i, a));
    }
    if (!value.allFinite()) return "the constraints are not finite";
    if (count == 0 || value.cwiseAbs().maxCoeff() <= tolerance_) return {};
    if (iteration == iterations_)
      return joinText("the projection did not meet its ", count, " constraints in ", iterations_,
                      " iterations: the worst is off by ", value.cwiseAbs().maxCoeff());
    gradient_.resize(inverseMass_.size(), count);
    gradient_.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SparseMatrix<double> weighted = inverseMass_.asDiagonal() * gradient_;
    matrix_ = Eigen::SparseMatrix<double>(gradient_.transpose()) * weighted;
    if (!factor_) {
      factor_ = std::make_unique<Eigen::SimplicialLLT<Eigen::SparseMatrix<double>>>();
      factor_->analyzePattern(matrix_);
    }
    factor_->factorize(matrix_);
    if (factor_->info() != Eigen::Success)
      return joinText("the ", count, " constraints of the filtered elements contradict or repeat each other");
    const Eigen::VectorXd move = weighted * factor_->solve(value);
    for (Eigen::Index d = 0; d < move.size(); ++d) x.data()[d] -= move[d];
    ++total_;
  }
}

}  // namespace ringwatch

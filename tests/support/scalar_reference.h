#pragma once
#include <variant>
#include <vector>

#include <ringwatch/materials/registry.h>
#include <ringwatch/meshes/mesh.h>
#include <tests/support/random.h>

namespace ringwatch::test {

/// Force, tangent and energy of a mesh of one material, element by element in plain numbers: the same laws and shape
/// functions as the body, nothing of its patches, batches or packs. Element is a registered element.
template <class Element, class LawType>
class ScalarReference {
 public:
  static constexpr int n = Element::nodes;
  ScalarReference(const Mesh& mesh, const LawType& law, const QuadratureRule& rule) : block_(mesh.blocks[0]), law_(law) {
    for (std::size_t e = 0; e < block_.elementCount(); ++e)
      for (const QuadraturePoint& q : rule.points) {
        double dN[n][3];
        Element::shapeGradient(q.xi, dN);
        const Gradients natural = Eigen::Map<Eigen::Matrix<double, n, 3, Eigen::RowMajor>>(&dN[0][0]);
        Eigen::Matrix3d J = Eigen::Matrix3d::Zero();
        for (int a = 0; a < n; ++a) J += mesh.X.col(block_.element(e)[a]) * natural.row(a);
        points_.push_back({natural * J.inverse(), J.determinant() * q.weight});
      }
    pointsPerElement_ = rule.points.size();
  }

  void force(const NodeVectors& x, NodeVectors& f) const {
    f.setZero(3, x.cols());
    for (std::size_t e = 0; e < block_.elementCount(); ++e)
      for (std::size_t q = 0; q < pointsPerElement_; ++q) {
        const Point& point = points_[e * pointsPerElement_ + q];
        const Matrix3<double> P = law_.stress(gradient(x, e, point));
        for (int a = 0; a < n; ++a)
          for (int i = 0; i < 3; ++i)
            f(i, block_.element(e)[a]) +=
                point.weight * (P(i, 0) * point.g(a, 0) + P(i, 1) * point.g(a, 1) + P(i, 2) * point.g(a, 2));
      }
  }
  void tangentProduct(const NodeVectors& x, const NodeVectors& v, NodeVectors& Kv) const {
    Kv.setZero(3, x.cols());
    for (std::size_t e = 0; e < block_.elementCount(); ++e)
      for (std::size_t q = 0; q < pointsPerElement_; ++q) {
        const Point& point = points_[e * pointsPerElement_ + q];
        const Matrix3<double> dP = law_.linearize(gradient(x, e, point))(gradient(v, e, point));
        for (int a = 0; a < n; ++a)
          for (int i = 0; i < 3; ++i)
            Kv(i, block_.element(e)[a]) +=
                point.weight * (dP(i, 0) * point.g(a, 0) + dP(i, 1) * point.g(a, 1) + dP(i, 2) * point.g(a, 2));
      }
  }
  double energy(const NodeVectors& x) const {
    double sum = 0;
    for (std::size_t e = 0; e < block_.elementCount(); ++e)
      for (std::size_t q = 0; q < pointsPerElement_; ++q) {
        const Point& point = points_[e * pointsPerElement_ + q];
        sum += point.weight * law_.energy(gradient(x, e, point));
      }
    return sum;
  }

 private:
  using Gradients = Eigen::Matrix<double, n, 3>;
  struct Point {
    Gradients g;    // ∂N_a/∂X
    double weight;  // w det J
  };
  /// Σ_a x_a ⊗ g_a
  Matrix3<double> gradient(const NodeVectors& x, std::size_t e, const Point& point) const {
    Matrix3<double> F = Matrix3<double>::zero();
    for (int a = 0; a < n; ++a)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) F(i, j) += x(i, block_.element(e)[a]) * point.g(a, j);
    return F;
  }

  const MeshBlock block_;
  const LawType law_;
  std::size_t pointsPerElement_ = 0;
  std::vector<Point> points_;
};

/// Calls visit(reference) with the ScalarReference for the mesh's element type, the material's law and the rule.
template <class Visit>
void withScalarReference(const Mesh& mesh, const Material& material, const QuadratureRule& rule, const Visit& visit) {
  visitElement(mesh.blocks[0].type, [&](auto tag) {
    std::visit(
        [&](const auto& law) {
          visit(ScalarReference<typename decltype(tag)::type, std::decay_t<decltype(law)>>(mesh, law, rule));
        },
        material.law);
  });
}

}  // namespace ringwatch::test

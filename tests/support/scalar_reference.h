#pragma once
#include <variant>
#include <vector>

#include <ringwatch/body/law_of_packs.h>
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
  /// hourglass: of a rule of uniform strain, half its coefficient times the modulus of pressure waves, Pa.
  ScalarReference(const Mesh& mesh, const LawType& law, const QuadratureRule& rule, double hourglass = 0)
      : block_(mesh.blocks[0]),
        law_(share(law, rule.shares.pointLambda, rule.shares.pointMu)),
        meanLaw_(share(law, rule.shares.meanLambda, rule.shares.meanMu)) {
    for (std::size_t e = 0; e < block_.elementCount(); ++e) {
      Point mean{};
      // The means of a rule of uniform strain are those of a rule that is exact for them.
      for (const QuadraturePoint& q : rule.uniformStrain ? Element::massRule.points : rule.points) {
        double dN[n][3];
        Element::shapeGradient(q.xi, dN);
        Eigen::Matrix3d J = Eigen::Matrix3d::Zero();
        for (int a = 0; a < n; ++a) J += mesh.X.col(block_.element(e)[a]) * Eigen::RowVector3d::Map(dN[a]);
        Point& point = points_.emplace_back();
        for (int a = 0; a < n; ++a) Eigen::RowVector3d::Map(point.g[a]) = Eigen::RowVector3d::Map(dN[a]) * J.inverse();
        point.weight = J.determinant() * q.weight;
        for (int i = 0; i < 3 * n; ++i) mean.g[i / 3][i % 3] += point.weight * point.g[i / 3][i % 3];
        mean.weight += point.weight;
      }
      if (!rule.shares.mean() && !rule.uniformStrain) continue;
      for (auto& g : mean.g)
        for (double& value : g) value /= mean.weight;
      if (rule.uniformStrain) {
        points_.resize(e);
        hourglass_.push_back(hourglassOf(mesh, e, mean, hourglass));
      } else {
        mean.isMean = true;
      }
      points_.push_back(mean);
    }
    pointsPerElement_ = rule.points.size() + (rule.shares.mean() ? 1 : 0);
  }

  void force(const NodeVectors& x, NodeVectors& f) const {
    sumOverElements(x, x, f,
                    [&](std::size_t, const Matrix3<double>& F, const Point& point) { return lawAt(point).stress(F); });
  }
  void tangentProduct(const NodeVectors& x, const NodeVectors& v, NodeVectors& Kv) const {
    sumOverElements(x, v, Kv, [&](std::size_t e, const Matrix3<double>& F, const Point& point) {
      double ve[n][3];
      gather(v, e, ve);
      return lawAt(point).linearize(F)(gradient(ve, point));
    });
  }
  double energy(const NodeVectors& x) const {
    double sum = 0;
    for (std::size_t e = 0; e < block_.elementCount(); ++e)
      for (std::size_t q = 0; q < pointsPerElement_; ++q) {
        const Point& point = points_[e * pointsPerElement_ + q];
        double xe[n][3];
        gather(x, e, xe);
        sum += point.weight * lawAt(point).energy(gradient(xe, point));
        if (hourglass_.empty()) continue;
        double fe[n][3] = {};
        addHourglass(e, xe, fe);
        for (int i = 0; i < 3 * n; ++i) sum += 0.5 * xe[i / 3][i % 3] * fe[i / 3][i % 3];
      }
    return sum;
  }

 private:
  struct Point {
    double g[n][3];  // ∂N_a/∂X
    double weight;   // w det J
    bool isMean = false;
  };
  static LawType share(const LawType& law, double lambdaShare, double muShare) {
    return withShares(law, lambdaShare, muShare).value_or(law);
  }
  const LawType& lawAt(const Point& point) const { return point.isMean ? meanLaw_ : law_; }
  void gather(const NodeVectors& x, std::size_t e, double (&xe)[n][3]) const {
    for (int a = 0; a < n; ++a) {
      const double* from = x.data() + 3 * static_cast<std::ptrdiff_t>(block_.element(e)[a]);
      for (int i = 0; i < 3; ++i) xe[a][i] = from[i];
    }
  }
  /// Σ_a x_a ⊗ g_a
  static Matrix3<double> gradient(const double (&xe)[n][3], const Point& point) {
    Matrix3<double> F = Matrix3<double>::zero();
    for (int a = 0; a < n; ++a)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) F(i, j) += xe[a][i] * point.g[a][j];
    return F;
  }
  /// k Σ_α γ_α γ_αᵀ with γ_α = Γ_α - Σ_j (Γ_α·X_j) g_j, Γ the signs of ηζ, ξζ, ξη and ξηζ, and k = hourglass V |g|²/8.
  static Eigen::Matrix<double, n, n> hourglassOf(const Mesh& mesh, std::size_t e, const Point& mean, double hourglass) {
    using Signs = Eigen::Matrix<double, n, 1>;
    const std::int32_t* nodes = mesh.blocks[0].element(e);
    Eigen::Matrix<double, n, n> H = Eigen::Matrix<double, n, n>::Zero();
    double square = 0;
    for (const auto& g : mean.g)
      for (const double value : g) square += value * value;
    for (const int signs : {0b110, 0b101, 0b011, 0b111}) {
      Signs base = Signs::Ones();
      for (int a = 0; a < n; ++a)
        for (int j = 0; j < 3; ++j)
          if ((signs >> j & 1) != 0) base[a] *= Element::referenceNodes[a][j];
      Signs gamma = base;
      for (int j = 0; j < 3; ++j) {
        double moment = 0;
        for (int a = 0; a < n; ++a) moment += base[a] * (mesh.X(j, nodes[a]) - mesh.X(j, nodes[0]));
        for (int a = 0; a < n; ++a) gamma[a] -= moment * mean.g[a][j];
      }
      H += hourglass * mean.weight * square / 8 * gamma * gamma.transpose();
    }
    return H;
  }
  void addHourglass(std::size_t e, const double (&ue)[n][3], double (&fe)[n][3]) const {
    if (hourglass_.empty()) return;
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b)
        for (int i = 0; i < 3; ++i) fe[a][i] += hourglass_[e](a, b) * (ue[b][i] - ue[0][i]);
  }
  /// f_a += Σ_q w_q P_q g_qa, and hourglass forces of u
  template <class StressAt>
  void sumOverElements(const NodeVectors& x, const NodeVectors& u, NodeVectors& f, const StressAt& stressAt) const {
    f.setZero(3, x.cols());
    for (std::size_t e = 0; e < block_.elementCount(); ++e) {
      double xe[n][3], fe[n][3] = {};
      gather(x, e, xe);
      for (std::size_t q = 0; q < pointsPerElement_; ++q) {
        const Point& point = points_[e * pointsPerElement_ + q];
        const Matrix3<double> P = point.weight * stressAt(e, gradient(xe, point), point);
        for (int a = 0; a < n; ++a)
          for (int i = 0; i < 3; ++i)
            fe[a][i] += P(i, 0) * point.g[a][0] + P(i, 1) * point.g[a][1] + P(i, 2) * point.g[a][2];
      }
      double ue[n][3];
      gather(u, e, ue);
      addHourglass(e, ue, fe);
      for (int a = 0; a < n; ++a) {
        double* to = f.data() + 3 * static_cast<std::ptrdiff_t>(block_.element(e)[a]);
        for (int i = 0; i < 3; ++i) to[i] += fe[a][i];
      }
    }
  }

  const MeshBlock block_;
  const LawType law_, meanLaw_;
  std::size_t pointsPerElement_ = 0;
  std::vector<Point> points_;
  std::vector<Eigen::Matrix<double, n, n>> hourglass_;  // of elements of uniform strain
};

/// Calls visit(reference) with the ScalarReference for the mesh's element type, the material's law and the rule, with
/// the usual hourglass control.
template <class Visit>
void withScalarReference(const Mesh& mesh, const Material& material, const QuadratureRule& rule, const Visit& visit) {
  visitElement(mesh.blocks[0].type, [&](auto tag) {
    std::visit(
        [&](const auto& law) {
          visit(ScalarReference<typename decltype(tag)::type, std::decay_t<decltype(law)>>(
              mesh, law, rule, 0.5 * HourglassControl().stiffness * material.restModulus()));
        },
        material.law);
  });
}

}  // namespace ringwatch::test

#pragma once
#include <array>

#include <ringwatch/base/error.h>
#include <ringwatch/base/matrix3.h>
#include <ringwatch/body/element_block.h>

namespace ringwatch {

/// The hot loops: all elements of one type and law, structure-of-arrays, one lane an element. `Element` and `LawType` are
/// entries of the registries; the quadrature rule is data.
///
/// With D = Σ_a x_a ⊗ ∂N_a/∂ξ and the Jacobian J = ∂X/∂ξ: F = D J⁻¹. A force is f_a = Σ_q w_q det(J) P J⁻ᵀ ∂N_a/∂ξ.
/// J⁻¹ and w det(J) are stored for each quadrature point, 10 numbers. Rules with a share at the mean deformation gradient
/// (LameShares) add one more evaluation with the mean gradients ∂N_a/∂X, stored by element.
template <class Element, class LawType>
class ElementBatch final : public ElementBlock {
 public:
  using P = NativePack;
  static constexpr int n = Element::nodes;
  static constexpr int lanes = PatchLayout::lanes;

  ElementBatch(const Mesh& mesh, const MeshBlock& block, const Material& material, const QuadratureRule& rule)
      : ElementBlock(mesh, block, material, rule),
        law_(shareOf(material, rule.shares.pointLambda, rule.shares.pointMu)),
        meanLaw_(shareOf(material, rule.shares.meanLambda, rule.shares.meanMu)),
        mean_(rule.shares.mean()) {
    tabulate(mesh, block);
  }

  void forcePatch(const Patch& patch, const double* x, double* slots) const override {
    const LawType law = law_;
    overPatch(patch, x, [&](const double* rows, std::int32_t batch) {
      P position[n][3], force[n][3];
      load(rows, batch, position);
      clear(force);
      const P* geometry = geometryOf(batch);
      for (int q = 0; q < points_; ++q, geometry += 10) {
        const Matrix3<P> J1 = inverseJacobian(geometry);
        const Matrix3<P> F = gradient(position, q) * J1;
        scatter(timesTranspose(geometry[9] * law.stress(F), J1), q, force);
      }
      if constexpr (offersMean)
        if (mean_) {
          const P* g = meanGradientsOf(batch);
          scatterMean(g[3 * n] * meanLaw_.stress(meanGradient(position, g)), g, force);
        }
      add(slots, batch, force);
    });
  }

  void tangentProductPatch(const Patch& patch, const double* x, const double* v, double* slots) const override {
    const LawType law = law_;
    alignas(64) double vRows[4 * maxPatchNodes];
    gatherRows(patch, v, vRows);
    overPatch(patch, x, [&](const double* rows, std::int32_t batch) {
      P position[n][3], direction[n][3], force[n][3];
      load(rows, batch, position);
      load(vRows, batch, direction);
      clear(force);
      const P* geometry = geometryOf(batch);
      for (int q = 0; q < points_; ++q, geometry += 10) {
        const Matrix3<P> J1 = inverseJacobian(geometry);
        const Matrix3<P> F = gradient(position, q) * J1, dF = gradient(direction, q) * J1;
        scatter(timesTranspose(geometry[9] * law.linearize(F)(dF), J1), q, force);
      }
      if constexpr (offersMean)
        if (mean_) {
          const P* g = meanGradientsOf(batch);
          const Matrix3<P> F = meanGradient(position, g), dF = meanGradient(direction, g);
          scatterMean(g[3 * n] * meanLaw_.linearize(F)(dF), g, force);
        }
      add(slots, batch, force);
    });
  }

  double energyPatch(const Patch& patch, const double* x) const override {
    const LawType law = law_;
    P sum(0.0);
    overPatch(patch, x, [&](const double* rows, std::int32_t batch) {
      P position[n][3];
      load(rows, batch, position);
      const P* geometry = geometryOf(batch);
      for (int q = 0; q < points_; ++q, geometry += 10)
        sum += geometry[9] * law.energy(gradient(position, q) * inverseJacobian(geometry));
      if constexpr (offersMean)
        if (mean_) {
          const P* g = meanGradientsOf(batch);
          sum += g[3 * n] * meanLaw_.energy(meanGradient(position, g));
        }
    });
    double total = 0;
    for (int lane = 0; lane < lanes; ++lane) total += sum[lane];
    return total;
  }

  void tangentBatch(std::int32_t batch, const double* x, double* K) const override {
    const LawType law = law_;
    P position[n][3];
    loadFromMesh(x, batch, position);
    P* k = reinterpret_cast<P*>(K);
    for (int i = 0; i < 9 * n * n; ++i) k[i] = P(0.0);
    const P* geometry = geometryOf(batch);
    for (int q = 0; q < points_; ++q, geometry += 10) {
      const Matrix3<P> J1 = inverseJacobian(geometry);
      // g_a = J⁻ᵀ ∂N_a/∂ξ, the gradient in reference coordinates.
      P g[n][3];
      for (int a = 0; a < n; ++a)
        for (int j = 0; j < 3; ++j)
          g[a][j] = P(dN(q, a, 0)) * J1(0, j) + P(dN(q, a, 1)) * J1(1, j) + P(dN(q, a, 2)) * J1(2, j);
      addTangent(law.linearize(gradient(position, q) * J1), geometry[9], g, k);
    }
    if constexpr (offersMean)
      if (mean_) {
        const P* stored = meanGradientsOf(batch);
        P g[n][3];
        for (int i = 0; i < 3 * n; ++i) g[i / 3][i % 3] = stored[i];
        addTangent(meanLaw_.linearize(meanGradient(position, stored)), stored[3 * n], g, k);
      }
  }

  void minimumDeterminantBatch(std::int32_t batch, const double* x, double* determinants) const override {
    P position[n][3];
    loadFromMesh(x, batch, position);
    const P* geometry = geometryOf(batch);
    P least(0.0);
    for (int q = 0; q < points_; ++q, geometry += 10) {
      const P d = determinant(gradient(position, q) * inverseJacobian(geometry));
      least = q == 0 ? d : math::min(least, d);
    }
    if constexpr (offersMean)
      if (mean_) least = math::min(least, determinant(meanGradient(position, meanGradientsOf(batch))));
    least.store(determinants);
  }

  void volumeBatch(std::int32_t batch, double* volumes) const override {
    P sum(0.0);
    for (int q = 0; q < points_; ++q) sum += geometryOf(batch)[10 * q + 9];
    sum.store(volumes);
  }

  static constexpr int maxPatchNodes = 1024;

 private:
  static constexpr bool offersMean = [] {
    for (const QuadratureRule& rule : Element::rules)
      if (rule.shares.mean()) return true;
    return false;
  }();
  /// The material's law with a share of each of Lamé's constants.
  static LawType shareOf(const Material& material, double lambdaShare, double muShare) {
    LawType law = std::get<LawType>(material.law);
    if constexpr (requires { law.constants.lambda* law.constants.mu; }) {
      law.constants.lambda *= lambdaShare;
      law.constants.mu *= muShare;
    } else if (lambdaShare != muShare) {
      throw InputError(joinText(Element::name, ": rules that treat pressure and shear apart need a law linear in Lamé's constants; ",
                                LawType::name, " is none"));
    }
    return law;
  }
  /// k += w g ⊗ (∂P/∂F) g
  template <class Linearization>
  static void addTangent(const Linearization& linearization, const P& weight, const P (&g)[n][3], P* k) {
    // modulus[(k,K)] = ∂P/∂F_kK · w
    Matrix3<P> modulus[9];
    for (int c = 0; c < 9; ++c) {
      Matrix3<P> unit = Matrix3<P>::zero();
      unit.m[c] = P(1.0);
      modulus[c] = weight * linearization(unit);
    }
    for (int b = 0; b < n; ++b)
      for (int column = 0; column < 3; ++column) {
        Matrix3<P> t;  // Σ_K modulus_(column,K) g_bK
        for (int i = 0; i < 9; ++i)
          t.m[i] = modulus[3 * column].m[i] * g[b][0] + modulus[3 * column + 1].m[i] * g[b][1] +
                   modulus[3 * column + 2].m[i] * g[b][2];
        for (int a = 0; a < n; ++a)
          for (int row = 0; row < 3; ++row)
            k[(3 * a + row) * 3 * n + 3 * b + column] += t(row, 0) * g[a][0] + t(row, 1) * g[a][1] + t(row, 2) * g[a][2];
      }
  }
  /// Mean gradients ∂N_a/∂X of a batch, row by row, then the volume.
  const P* meanGradientsOf(std::int32_t batch) const {
    return meanGradients_.data() + static_cast<std::ptrdiff_t>(batch) * (3 * n + 1);
  }
  RINGWATCH_INLINE static Matrix3<P> meanGradient(const P (&x)[n][3], const P* g) {
    Matrix3<P> r = Matrix3<P>::zero();
    for (int a = 0; a < n; ++a)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) r(i, j) += x[a][i] * g[3 * a + j];
    return r;
  }
  RINGWATCH_INLINE static void scatterMean(const Matrix3<P>& T, const P* g, P (&force)[n][3]) {
    for (int a = 0; a < n; ++a)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) force[a][i] += T(i, j) * g[3 * a + j];
  }
  /// Copies the patch's nodes into rows of four, once, and calls kernel(rows, batch) for its batches.
  template <class Kernel>
  void overPatch(const Patch& patch, const double* x, const Kernel& kernel) const {
    alignas(64) double rows[4 * maxPatchNodes];
    gatherRows(patch, x, rows);
    for (std::int32_t batch = patch.batchBegin; batch < patch.batchEnd; ++batch) kernel(rows, batch);
  }
  void gatherRows(const Patch& patch, const double* x, double* rows) const {
    const std::int32_t* nodes = layout().nodes.data() + patch.nodeBegin;
    const int count = patch.nodeEnd - patch.nodeBegin;
    for (int i = 0; i < count; ++i) {
      const double* from = x + 3 * static_cast<std::ptrdiff_t>(nodes[i]);
      for (int c = 0; c < 3; ++c) rows[4 * i + c] = from[c];
      rows[4 * i + 3] = 0;
    }
  }
  const std::uint16_t* localNodes(std::int32_t batch) const {
    return layout().localNodes.data() + static_cast<std::ptrdiff_t>(batch) * n * lanes;
  }
  RINGWATCH_INLINE void load(const double* rows, std::int32_t batch, P (&out)[n][3]) const {
    const std::uint16_t* local = localNodes(batch);
    for (int a = 0; a < n; ++a) loadRows(rows, local + a * lanes, out[a]);
  }
  RINGWATCH_INLINE void add(double* slots, std::int32_t batch, const P (&values)[n][3]) const {
    const std::uint16_t* local = localNodes(batch);
    for (int a = 0; a < n; ++a) addRows(slots, local + a * lanes, values[a]);
  }
  RINGWATCH_INLINE static void clear(P (&values)[n][3]) {
    for (auto& row : values)
      for (P& value : row) value = P(0.0);
  }
  /// For single batches: straight from the mesh's node vector. Lanes without an element repeat the batch's first.
  void loadFromMesh(const double* x, std::int32_t batch, P (&out)[n][3]) const {
    const std::int32_t* elements = layout().elements.data() + static_cast<std::ptrdiff_t>(batch) * lanes;
    for (int lane = 0; lane < lanes; ++lane) {
      const auto nodes = nodesOf(elements[lane] < 0 ? elements[0] : elements[lane]);
      for (int a = 0; a < n; ++a)
        for (int c = 0; c < 3; ++c)
          out[a][c].set(lane, x[3 * static_cast<std::ptrdiff_t>(nodes[static_cast<std::size_t>(a)]) + c]);
    }
  }

  double dN(int q, int a, int j) const { return shapeGradients_[static_cast<std::size_t>((q * n + a) * 3 + j)]; }
  const P* geometryOf(std::int32_t batch) const { return geometry_.data() + static_cast<std::ptrdiff_t>(batch) * points_ * 10; }
  RINGWATCH_INLINE static Matrix3<P> inverseJacobian(const P* geometry) {
    Matrix3<P> r;
    for (int i = 0; i < 9; ++i) r.m[i] = geometry[i];
    return r;
  }
  /// Σ_a x_a ⊗ ∂N_a/∂ξ
  RINGWATCH_INLINE Matrix3<P> gradient(const P (&x)[n][3], int q) const {
    Matrix3<P> r;
    if constexpr (n == 4) {  // linear tetrahedron: differences
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) r(i, j) = x[j + 1][i] - x[0][i];
    } else {
      const double* d = shapeGradients_.data() + static_cast<std::ptrdiff_t>(q) * n * 3;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) r(i, j) = x[0][i] * P(d[j]);
      for (int a = 1; a < n; ++a)
        for (int j = 0; j < 3; ++j) {
          const P dNaj(d[3 * a + j]);
          for (int i = 0; i < 3; ++i) r(i, j) += x[a][i] * dNaj;
        }
    }
    return r;
  }
  /// f_a += T ∂N_a/∂ξ
  RINGWATCH_INLINE void scatter(const Matrix3<P>& T, int q, P (&force)[n][3]) const {
    if constexpr (n == 4) {
      for (int i = 0; i < 3; ++i) {
        force[0][i] -= T(i, 0) + T(i, 1) + T(i, 2);
        for (int j = 0; j < 3; ++j) force[j + 1][i] += T(i, j);
      }
    } else {
      const double* d = shapeGradients_.data() + static_cast<std::ptrdiff_t>(q) * n * 3;
      for (int a = 0; a < n; ++a)
        for (int j = 0; j < 3; ++j) {
          const P dNaj(d[3 * a + j]);
          for (int i = 0; i < 3; ++i) force[a][i] += T(i, j) * dNaj;
        }
    }
  }

  void tabulate(const Mesh& mesh, const MeshBlock& block);
  void tabulateMean();

  LawType law_, meanLaw_;
  bool mean_;
  int points_ = 0;
  std::vector<double> shapeGradients_;  // [q][a][j] = ∂N_a/∂ξ_j
  AlignedVector<P> meanGradients_;      // [batch][3n + 1], see meanGradientsOf; empty without a mean share
  AlignedVector<P> geometry_;           // [batch][q][10]: J⁻¹ row by row, w det(J); zero weight in lanes without element
};

template <class Element, class LawType>
void ElementBatch<Element, LawType>::tabulate(const Mesh& mesh, const MeshBlock& block) {
  points_ = static_cast<int>(rule().points.size());
  shapeGradients_.resize(static_cast<std::size_t>(points_ * n * 3));
  for (int q = 0; q < points_; ++q)
    Element::shapeGradient(rule().points[static_cast<std::size_t>(q)].xi,
                           reinterpret_cast<double(*)[3]>(shapeGradients_.data() + static_cast<std::ptrdiff_t>(q) * n * 3));
  const std::int32_t batches = layout().batchCount();
  geometry_.resize(static_cast<std::size_t>(batches) * static_cast<std::size_t>(points_) * 10);
  for (std::int32_t batch = 0; batch < batches; ++batch) {
    P X[n][3];
    loadFromMesh(mesh.X.data(), batch, X);
    P* geometry = geometry_.data() + static_cast<std::ptrdiff_t>(batch) * points_ * 10;
    for (int q = 0; q < points_; ++q, geometry += 10) {
      const Matrix3<P> J = gradient(X, q);
      const P det = determinant(J);
      const Matrix3<P> J1 = inverse(J);
      for (int i = 0; i < 9; ++i) geometry[i] = J1.m[i];
      for (int lane = 0; lane < lanes; ++lane) {
        const std::int32_t e = layout().elements[static_cast<std::size_t>(batch) * lanes + static_cast<std::size_t>(lane)];
        if (e >= 0 && !(det[lane] > 0))
          throw NumericalError(joinText(Element::name, " element ", block.ids.empty() ? e : block.ids[static_cast<std::size_t>(e)],
                                        ": Jacobian determinant ", det[lane], " at quadrature point ", q, " must be > 0"));
        geometry[9].set(lane, e < 0 ? 0.0 : det[lane] * rule().points[static_cast<std::size_t>(q)].weight);
      }
    }
  }
  if (mean_) tabulateMean();
}

template <class Element, class LawType>
void ElementBatch<Element, LawType>::tabulateMean() {
  constexpr auto size = static_cast<std::size_t>(3 * n + 1);
  meanGradients_.assign(static_cast<std::size_t>(layout().batchCount()) * size, P(0.0));
  for (std::int32_t batch = 0; batch < layout().batchCount(); ++batch) {
    P* g = meanGradients_.data() + static_cast<std::size_t>(batch) * size;
    const P* geometry = geometryOf(batch);
    for (int q = 0; q < points_; ++q, geometry += 10) {
      const Matrix3<P> J1 = inverseJacobian(geometry);
      for (int a = 0; a < n; ++a)
        for (int j = 0; j < 3; ++j)
          g[3 * a + j] +=
              geometry[9] * (P(dN(q, a, 0)) * J1(0, j) + P(dN(q, a, 1)) * J1(1, j) + P(dN(q, a, 2)) * J1(2, j));
      g[3 * n] += geometry[9];
    }
    // Lanes without an element have no volume; their gradients stay zero.
    const auto present = g[3 * n] > P(0.0);
    const P inverse = select(present, P(1.0) / select(present, g[3 * n], P(1.0)), P(0.0));
    for (int i = 0; i < 3 * n; ++i) g[i] *= inverse;
  }
}

}  // namespace ringwatch

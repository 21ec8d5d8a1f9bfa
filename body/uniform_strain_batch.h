#pragma once
#include <ringwatch/body/law_of_packs.h>
#include <ringwatch/body/uniform_strain_geometry.h>

namespace ringwatch {

/// The elements of a block whose rule is of uniform strain (elements/hourglass.h): one evaluation of the law at the
/// mean gradients, and hourglass control. As ElementBatch: structure-of-arrays, one lane an element.
template <class Element, class LawType>
class UniformStrainBatch final : public ElementBlock {
 public:
  using P = NativePack;
  using Geometry = UniformStrainGeometry<Element>;
  using Stored = typename Geometry::Stored;
  using Vectors = typename Geometry::Vectors;
  using Operators = ElementOperators<Element, P>;
  static constexpr int n = Element::nodes, size = 3 * n, vectors = Geometry::vectors;

  UniformStrainBatch(const Mesh& mesh, const MeshBlock& block, const Material& material, const QuadratureRule& rule,
                     const HourglassControl& control, PatchLayout layout)
      : ElementBlock(block, material, rule, std::move(layout), control),
        law_(lawOf<LawType>(material)),
        geometry_(*this, mesh, block, 0.5 * control.stiffness * material.restModulus()) {}

  void evaluateBatches(std::int32_t first, std::int32_t last, const double* rows,
                       const BatchEvaluation& evaluation) const override {
    if (evaluation.slots)
      evaluate<true>(first, last, rows, evaluation);
    else
      evaluate<false>(first, last, rows, evaluation);
  }

  void tangentProductBatches(std::int32_t first, std::int32_t last, const double* rows, const double* vRows,
                             double* slots) const override {
    const LawType law = law_;
    for (std::int32_t batch = first; batch < last; ++batch) {
      const Stored& at = geometry_.of(batch);
      geometry_.prefetchAhead(batch);
      P position[n][3], direction[n][3], q[vectors][3], force[n][3];
      geometry_.loadEdges(rows, batch, position);
      geometry_.loadEdges(vRows, batch, direction);
      const Matrix3<P> F = Geometry::deformation(at, position, q), dF = Geometry::deformation(at, direction, q);
      Geometry::forces(at, law.linearize(F)(dF), q, force);
      geometry_.addToSlots(slots, batch, force);
    }
  }

  void tangentBatch(std::int32_t batch, const double* x, double* K, double* rounding) const override {
    tangent(geometry_.elementsOf(batch), geometry_.of(batch), x, K, rounding);
  }
  void tangentOf(const std::int32_t* elements, const double* x, double* K, double* rounding) const override {
    Stored at;
    geometry_.gather(elements, at);
    tangent(elements, at, x, K, rounding);
  }
  void addTangentRounding(const Patch& patch, const double* x, double* slots) const override {
    for (std::int32_t batch = patch.batchBegin; batch < patch.batchEnd; ++batch) {
      const Stored& at = geometry_.of(batch);
      const Vectors own = Geometry::vectorsOf(at);
      P position[n][3], T[n][3];
      const Matrix3<P> F = deformationAt(geometry_.elementsOf(batch), at, x, position);
      const P all = Geometry::tangentError(at, own, roundingOf(law_.linearize(F), F, own, position));
      for (auto& row : T) {
        row[0] = all;
        row[1] = row[2] = P(0.0);
      }
      geometry_.addToSlots(slots, batch, T);
    }
  }

  void deformationOf(const std::int32_t* elements, const double* x, double* F, TangentDrift* drift) const override {
    Stored at;
    geometry_.gather(elements, at);
    P position[n][3];
    const Matrix3<P> own = deformationAt(elements, at, x, position);
    for (int i = 0; i < 9; ++i) own.m[i].store(F + i * lanes);
    // The hourglass stiffness is constant and positive semidefinite, so that the law's coefficients hold: Theorem 71.
    TangentDriftOf<P> all;
    all.addPoint(law_, own);
    // As of ElementBatch: of F here, of F there, and once more of a radius that is scaled.
    all.gradientRounding = P(4.0) * Geometry::gradientError(Geometry::vectorsOf(at), norm(position));
    for (int lane = 0; lane < lanes; ++lane) drift[lane] = laneOf(all, lane);
  }

  bool principalTangentAt(const P (&stretches)[3], PrincipalTangent<P>& tangent) const override {
    return principalTangent(law_, stretches, tangent);
  }
  void laplacianOf(const std::int32_t* elements, double* L, double* rounding) const override {
    Stored at;
    geometry_.gather(elements, at);
    const Vectors own = Geometry::vectorsOf(at);
    P* l = reinterpret_cast<P*>(L);
    Operators::addLaplacian(at.volume, own.g,
                            [&](int a, int b, const P& value) { l[a * n + b] = l[b * n + a] = value; });
    for (int a = 0; a < n; ++a) Geometry::laplacianError(at, own).store(rounding + a * lanes);
  }
  bool hourglassOf(const std::int32_t* elements, HourglassVectors& out) const override {
    static_assert(HourglassVectors::count == vectors && HourglassVectors::nodes == n);
    Stored at;
    geometry_.gather(elements, at);
    const Vectors own = Geometry::vectorsOf(at);
    for (int h = 0; h < vectors; ++h)
      for (int a = 0; a < n; ++a) out.gamma[h][a] = own.gamma[h][a];
    out.stiffness = at.stiffness;
    out.volume = at.volume;
    out.rounding = Geometry::hourglassError(at, own);
    return true;
  }
  void minimumDeterminantBatch(std::int32_t batch, const double* x, double* determinants) const override {
    P position[n][3];
    determinant(deformationAt(geometry_.elementsOf(batch), geometry_.of(batch), x, position)).store(determinants);
  }
  void volumeBatch(std::int32_t batch, double* volumes) const override { geometry_.of(batch).volume.store(volumes); }
  bool goesByDirections() const override { return false; }
  bool addsBulkViscosity() const override { return true; }

  void stressBatch(std::int32_t batch, const double* x, double* stress, double* F) const override {
    const Stored& at = geometry_.of(batch);
    P position[n][3];
    const Matrix3<P> own = deformationAt(geometry_.elementsOf(batch), at, x, position);
    for (int i = 0; i < 9; ++i) own.m[i].store(F + i * lanes);
    const Matrix3<P> first = at.volume * law_.stress(own);
    if (material().info().objective)
      storeStress(timesTranspose(first, own), at.volume * determinant(own), stress);
    else
      storeStress(first, at.volume, stress);
  }

 private:
  template <bool wantsForce>
  void evaluate(std::int32_t first, std::int32_t last, const double* rows, const BatchEvaluation& evaluation) const {
    const LawType law = law_;
    for (std::int32_t batch = first; batch < last; ++batch) {
      const Stored& at = geometry_.of(batch);
      geometry_.prefetchAhead(batch);
      P position[n][3], q[vectors][3];
      geometry_.loadEdges(rows, batch, position);
      const Matrix3<P> F = Geometry::deformation(at, position, q);
      if constexpr (wantsForce) {
        P force[n][3];
        Matrix3<P> stress = law.stress(F);
        if (evaluation.bulk) addBulkViscosity(*evaluation.bulk, batch, at, F, stress);
        Geometry::forces(at, stress, q, force);
        geometry_.addToSlots(evaluation.slots, batch, force);
      }
      if (evaluation.energy) addEnergy(at, F, q, evaluation.energy);
      if (evaluation.balls) {
        BatchBalls::OfBatch ball;
        ball.start(*evaluation.balls, batch, 1);
        ball.add(F);
        evaluation.balls->left[batch] = ball.left();
      }
      if (evaluation.motion) {
        BatchMotion::OfBatch moved;
        moved.start(*evaluation.motion, batch);
        moved.add(F);
        moved.finish();
      }
      if (evaluation.visitor) {
        alignas(64) double gradient[9 * lanes];
        for (int i = 0; i < 9; ++i) F.m[i].store(gradient + i * lanes);
        evaluation.visitor->visit(batch, gradient);
      }
    }
  }
  /// Its forces are s ∂V/∂x_a = s V₀ cof F̄ g_a: those of the stress s cof F̄.
  [[gnu::noinline]] void addBulkViscosity(const BulkViscosity& bulk, std::int32_t batch, const Stored& at,
                                          const Matrix3<P>& F, Matrix3<P>& stress) const {
    P v[n][3], q[vectors][3];
    geometry_.loadEdges(bulk.velocities, batch, v);
    const Matrix3<P> C = cofactor(F), dF = Geometry::deformation(at, v, q);
    const P volume = at.volume * (C(0, 0) * F(0, 0) + C(0, 1) * F(0, 1) + C(0, 2) * F(0, 2));
    stress = stress + bulk.factor(batch, volume, at.volume * innerProduct(C, dF)) * C;
  }
  [[gnu::noinline]] void addEnergy(const Stored& at, const Matrix3<P>& F, const P (&q)[vectors][3],
                                   double* energy) const {
    (P::load(energy) + at.volume * law_.energy(F) + Geometry::hourglassEnergy(at, q)).store(energy);
  }

  /// k Σ_α γ_αa γ_αb
  RINGWATCH_INLINE static P hourglassEntry(const Stored& at, const Vectors& own, int a, int b) {
    P sum = own.gamma[0][a] * own.gamma[0][b];
    for (int h = 1; h < vectors; ++h) sum += own.gamma[h][a] * own.gamma[h][b];
    return at.stiffness * sum;
  }
  Matrix3<P> deformationAt(const std::int32_t* elements, const Stored& at, const double* x, P (&position)[n][3]) const {
    geometry_.loadEdgesFromMesh(x, elements, position);
    P q[vectors][3];
    return Geometry::deformation(at, position, q);
  }
  RINGWATCH_INLINE static P norm(const P (&edges)[n][3]) {
    P sum(0.0);
    for (const auto& edge : edges) sum += edge[0] * edge[0] + edge[1] * edge[1] + edge[2] * edge[2];
    return math::sqrt(sum);
  }
  template <class Linearization>
  RINGWATCH_INLINE static ModulusRounding<P> roundingOf(const Linearization& linearization, const Matrix3<P>& F,
                                                        const Vectors& own, const P (&position)[n][3]) {
    return linearization.rounding(F, Geometry::gradientError(own, norm(position)));
  }

  void tangent(const std::int32_t* elements, const Stored& at, const double* x, double* K, double* rounding) const {
    const LawType law = law_;
    P position[n][3];
    const Matrix3<P> F = deformationAt(elements, at, x, position);
    const Vectors own = Geometry::vectorsOf(at);
    const auto linearization = law.linearize(F);
    P* k = reinterpret_cast<P*>(K);
    Operators::addTangent(linearization, at.volume, own.g,
                          [k](int row, int column, const P& value) { k[row * size + column] = value; });
    for (int a = 0; a < n; ++a)
      for (int b = a; b < n; ++b) {
        const P entry = hourglassEntry(at, own, a, b);
        for (int i = 0; i < 3; ++i) k[(3 * a + i) * size + 3 * b + i] += entry;
      }
    for (int i = 1; i < size; ++i)
      for (int j = 0; j < i; ++j) k[i * size + j] = k[j * size + i];
    if (!rounding) return;
    const P all = Geometry::tangentError(at, own, roundingOf(linearization, F, own, position));
    for (int a = 0; a < n; ++a) all.store(rounding + a * lanes);
  }

  LawType law_;
  Geometry geometry_;
};

}  // namespace ringwatch

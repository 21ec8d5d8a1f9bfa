#pragma once
#include <ringwatch/base/error.h>
#include <ringwatch/body/element_geometry.h>
#include <ringwatch/body/law_of_packs.h>
#include <ringwatch/body/tangent_rounding.h>

namespace ringwatch {

/// The hot loops: all elements of one type and law, structure-of-arrays, one lane an element. `Element` and `LawType`
/// are entries of the registries; the quadrature rule is data.
///
/// With D = Σ_a x_a ⊗ ∂N_a/∂ξ and the Jacobian J = ∂X/∂ξ: F = D J⁻¹. A force is f_a = Σ_q w_q det(J) P J⁻ᵀ ∂N_a/∂ξ.
/// Rules with a share at the mean deformation gradient (LameShares) add one more evaluation with the mean gradients
/// ∂N_a/∂X.
template <class Element, class LawType>
class ElementBatch final : public ElementBlock {
 public:
  using P = NativePack;
  using Geometry = ElementGeometry<Element>;
  using Operators = ElementOperators<Element, P>;
  static constexpr int n = Element::nodes, size = 3 * n;

  ElementBatch(const Mesh& mesh, const MeshBlock& block, const Material& material, const QuadratureRule& rule,
               PatchLayout layout)
      : ElementBlock(block, material, rule, std::move(layout)),
        law_(shareOf(material, rule.shares.pointLambda, rule.shares.pointMu)),
        meanLaw_(shareOf(material, rule.shares.meanLambda, rule.shares.meanMu)),
        geometry_(*this, mesh, block) {}

  void evaluateBatches(std::int32_t first, std::int32_t last, const double* rows,
                       const BatchEvaluation& evaluation) const override {
    withOperators([&](auto operators) {
      if constexpr (hasVolumeGradient<Element>)
        if (evaluation.slots && evaluation.bulk)
          return evaluate<Force::damped, decltype(operators)>(first, last, rows, evaluation);
      if constexpr (hasEnergyAlongStress)
        if (evaluation.slots && evaluation.energy)
          return evaluate<Force::elasticWithEnergy, decltype(operators)>(first, last, rows, evaluation);
      if (evaluation.slots)
        evaluate<Force::elastic, decltype(operators)>(first, last, rows, evaluation);
      else
        evaluate<Force::none, decltype(operators)>(first, last, rows, evaluation);
    });
  }
  bool addsBulkViscosity() const override { return hasVolumeGradient<Element>; }

  void tangentProductBatches(std::int32_t first, std::int32_t last, const double* rows, const double* vRows,
                             double* slots) const override {
    withOperators([&](auto operators) { product<decltype(operators)>(first, last, rows, vRows, slots); });
  }

  void tangentBatch(std::int32_t batch, const double* x, double* K, double* rounding) const override {
    tangent(layout().elements.data() + static_cast<std::ptrdiff_t>(batch) * lanes, geometry_.pointsOf(batch),
            geometry_.extentOf(batch), x, K, rounding);
  }

  void tangentOf(const std::int32_t* elements, const double* x, double* K, double* rounding) const override {
    P points[Geometry::stride * Geometry::maxPoints];
    geometry_.gatherPoints(elements, points);
    tangent(elements, points, geometry_.gatherExtents(elements), x, K, rounding);
  }

  void addTangentRounding(const Patch& patch, const double* x, double* slots) const override {
    for (std::int32_t batch = patch.batchBegin; batch < patch.batchEnd; ++batch) {
      P position[n][3], T[n][3], own[n];
      geometry_.loadEdgesFromMesh(x, layout().elements.data() + static_cast<std::ptrdiff_t>(batch) * lanes, position);
      Budget budget(position, geometry_.extentOf(batch));
      const P* const first = geometry_.pointsOf(batch);
      const P* point = first;
      for (int q = 0; q < geometry_.pointCount(); ++q, point += Geometry::stride) {
        const Matrix3<P> J1 = Geometry::inverseJacobian(point), F = geometry_.gradient(position, q, J1);
        P g[n][3];
        Operators::shapeGradients(J1, geometry_.shapeTable(q), g);
        budget.addPoint(law_.linearize(F), F, J1, geometry_.tableNorm(q), Geometry::weight(point), g);
      }
      if constexpr (Geometry::offersMean)
        if (geometry_.hasMean()) {
          const Matrix3<P> F = Geometry::meanGradient(position, geometry_.meanGradientsOf(batch));
          budget.addMean(meanLaw_.linearize(F), F);
        }
      budget.store(own);
      clear(T);
      for (int a = 0; a < n; ++a) T[a][0] = own[a];
      geometry_.addToSlots(slots, batch, T);
    }
  }

  void deformationOf(const std::int32_t* elements, const double* x, double* F, TangentDrift* drift) const override {
    P gathered[Geometry::stride * Geometry::maxPoints];
    geometry_.gatherPoints(elements, gathered);
    P position[n][3];
    geometry_.loadEdgesFromMesh(x, elements, position);
    const P* point = gathered;
    TangentDriftOf<P> all;
    const TangentRounding<Element, P> budget(norm(position), geometry_.gatherExtents(elements));
    for (int q = 0; q < geometry_.pointCount(); ++q, point += Geometry::stride) {
      const Matrix3<P> J1 = Geometry::inverseJacobian(point), own = geometry_.gradient(position, q, J1);
      // Of F here, of F there, where it is at most this much larger, and once more of a radius that is scaled.
      all.gradientRounding =
          math::max(all.gradientRounding, P(4.0) * budget.gradientError(norm(J1), geometry_.tableNorm(q), own));
      for (int i = 0; i < 9; ++i) own.m[i].store(F + (9 * q + i) * lanes);
      all.addPoint(law_, own);
    }
    if constexpr (Geometry::offersMean)
      if (geometry_.hasMean()) {
        P stored[3 * n + 1];
        geometry_.meanGradients(gathered, stored);
        all.addMean(meanLaw_, Geometry::meanGradient(position, stored));
      }
    for (int lane = 0; lane < lanes; ++lane) drift[lane] = laneOf(all, lane);
  }

  bool principalTangentAt(const P (&stretches)[3], PrincipalTangent<P>& tangent) const override {
    if constexpr (Geometry::offersMean)
      if (geometry_.hasMean()) return false;
    return principalTangent(law_, stretches, tangent);
  }
  void laplacianOf(const std::int32_t* elements, double* L, double* rounding) const override {
    geometry_.laplacianOf(elements, L, rounding);
  }
  void minimumDeterminantBatch(std::int32_t batch, const double* x, double* determinants) const override {
    geometry_.minimumDeterminantBatch(batch, x, determinants);
  }
  void volumeBatch(std::int32_t batch, double* volumes) const override { geometry_.volumeBatch(batch, volumes); }
  bool goesByDirections() const override { return geometry_.hasDirections(); }

  void stressBatch(std::int32_t batch, const double* x, double* stress, double* F) const override {
    const bool smallStrain = !material().info().objective;
    P position[n][3];
    geometry_.loadEdgesFromMesh(x, layout().elements.data() + static_cast<std::ptrdiff_t>(batch) * lanes, position);
    Matrix3<P> sum = Matrix3<P>::zero();
    P volume(0.0);
    const auto addStress = [&](const LawType& law, const P& weight, const Matrix3<P>& own) {
      const Matrix3<P> stressHere = law.stress(own);
      sum = sum + weight * (smallStrain ? stressHere : timesTranspose(stressHere, own));
    };
    const P* point = geometry_.pointsOf(batch);
    for (int q = 0; q < geometry_.pointCount(); ++q, point += Geometry::stride) {
      const Matrix3<P> own = geometry_.gradient(position, q, Geometry::inverseJacobian(point));
      const P weight = Geometry::weight(point);
      for (int i = 0; i < 9; ++i) own.m[i].store(F + (9 * q + i) * lanes);
      volume += smallStrain ? weight : weight * determinant(own);
      addStress(law_, weight, own);
    }
    if constexpr (Geometry::offersMean)
      if (geometry_.hasMean()) {
        const P* g = geometry_.meanGradientsOf(batch);
        addStress(meanLaw_, g[3 * n], Geometry::meanGradient(position, g));
      }
    storeStress(sum, volume, stress);
  }

 private:
  /// The material's law with a share of each of Lamé's constants; the law itself where it has none (hasShares).
  static LawType shareOf(const Material& material, double lambdaShare, double muShare) {
    const LawType law = lawOf<LawType>(material);
    return withShares(law, lambdaShare, muShare).value_or(law);
  }

  /// A nodal field's natural gradients at the points, and forces from stresses there: by the tables of ∂N/∂ξ.
  struct ByTables {
    using Field = typename Geometry::Field;
    class Forces {
     public:
      RINGWATCH_INLINE Forces(const Geometry& geometry, P (&force)[n][3]) : geometry_(geometry), force_(force) {
        clear(force_);
      }
      RINGWATCH_INLINE void add(int q, const Matrix3<P>& T) {
        Operators::addForces(T, geometry_.shapeTable(q), force_);
      }
      RINGWATCH_INLINE void finish() {}

     private:
      const Geometry& geometry_;
      P (&force_)[n][3];
    };
  };
  /// The same, one direction after the other.
  template <class Directions>
  struct ByDirections {
    class Field : public Directions::template Field<P> {
     public:
      RINGWATCH_INLINE Field(const Geometry&, const P (&edges)[n][3]) : Directions::template Field<P>(edges) {}
    };
    class Forces : public Directions::template Forces<P> {
     public:
      RINGWATCH_INLINE Forces(const Geometry&, P (&force)[n][3]) : force_(force) {}
      RINGWATCH_INLINE void finish() { this->store(force_); }

     private:
      P (&force_)[n][3];
    };
  };
  /// Calls visit(operators) with the quicker of the two that the rule has.
  template <class Visit>
  void withOperators(const Visit& visit) const {
    if constexpr (Geometry::offersDirections)
      if (geometry_.hasDirections()) return visit(ByDirections<typename Element::Directions>());
    visit(ByTables());
  }

  template <class By>
  void product(std::int32_t first, std::int32_t last, const double* rows, const double* vRows, double* slots) const {
    const LawType law = law_;
    for (std::int32_t batch = first; batch < last; ++batch) {
      P position[n][3], direction[n][3], force[n][3];
      geometry_.loadEdges(rows, batch, position);
      geometry_.loadEdges(vRows, batch, direction);
      const typename By::Field x(geometry_, position), v(geometry_, direction);
      typename By::Forces forces(geometry_, force);
      const P* point = geometry_.pointsOf(batch);
      const P* ahead = geometry_.pointsOf(geometry_.ahead(batch));
      for (int q = 0; q < geometry_.pointCount(); ++q, point += Geometry::stride, ahead += Geometry::stride) {
        Geometry::template prefetch<Geometry::stride>(ahead);
        const Matrix3<P> J1 = Geometry::inverseJacobian(point), F = x(q) * J1, dF = v(q) * J1;
        forces.add(q, timesTranspose(Geometry::weight(point) * law.linearize(F)(dF), J1));
      }
      forces.finish();
      if constexpr (Geometry::offersMean)
        if (geometry_.hasMean()) {
          const P* g = geometry_.meanGradientsOf(batch);
          const Matrix3<P> F = Geometry::meanGradient(position, g), dF = Geometry::meanGradient(direction, g);
          Geometry::addMeanForces(g[3 * n] * meanLaw_.linearize(F)(dF), g, force);
        }
      geometry_.addToSlots(slots, batch, force);
    }
  }

  /// Forces are the same to the last bit whatever else is asked for. Energies read the deformation gradients from
  /// memory, so that the force's loop has no products but its own, but of laws that declare `energyAlongStress`: a loop
  /// of their own has both, without more rounding. The comparison with balls takes nothing but F from it, and the trace
  /// of the strain, a sum. That holds as GCC compiles it; Clang 14 rounds the stress of three laws otherwise beside the
  /// energy. Bulk viscosity has a loop of its own too.
#ifdef __clang__
  static constexpr bool hasEnergyAlongStress = false;
#else
  static constexpr bool hasEnergyAlongStress = requires { requires LawType::energyAlongStress; };
#endif
  /// Of laws whose stress has the trace of the Green strain: it serves the comparison with balls.
  static constexpr bool sharesStrain = requires(const LawType law, const Matrix3<P> F, P traceOfStrain) {
    law.stress(F, traceOfStrain);
  };
  enum class Force { none, elastic, elasticWithEnergy, damped };
  template <Force wanted, class By>
  void evaluate(std::int32_t first, std::int32_t last, const double* rows, const BatchEvaluation& evaluation) const {
    constexpr bool wantsForce = wanted != Force::none, damped = wanted == Force::damped;
    constexpr bool alongForce = wanted == Force::elasticWithEnergy;
    const LawType law = law_;
    [[maybe_unused]] BulkViscosity bulk{};
    if constexpr (damped) bulk = *evaluation.bulk;
    const bool stores = wantsForce ? !alongForce && evaluation.energy : evaluation.visitor != nullptr;
    const BatchBalls* const balls = evaluation.balls;
    const BatchMotion* const motion = evaluation.motion;
    alignas(64) double gradients[9 * Geometry::maxPoints * lanes];
    for (std::int32_t batch = first; batch < last; ++batch) {
      P position[n][3], force[n][3];
      geometry_.loadEdges(rows, batch, position);
      const typename By::Field x(geometry_, position);
      [[maybe_unused]] typename By::Forces forces(geometry_, force);
      const P* point = geometry_.pointsOf(batch);
      const P* ahead = geometry_.pointsOf(geometry_.ahead(batch));
      [[maybe_unused]] P energy(0.0);
      BatchBalls::OfBatch ball;
      if (balls) ball.start(*balls, batch, geometry_.pointCount());
      BatchMotion::OfBatch moved;
      if (motion) moved.start(*motion, batch);
      for (int q = 0; q < geometry_.pointCount(); ++q, point += Geometry::stride, ahead += Geometry::stride) {
        Geometry::template prefetch<Geometry::stride>(ahead);
        const Matrix3<P> J1 = Geometry::inverseJacobian(point), D = x(q), F = D * J1;
        if (stores)
          for (int i = 0; i < 9; ++i) F.m[i].store(gradients + (9 * q + i) * lanes);
        if constexpr (!sharesStrain || !wantsForce) {
          if (balls) ball.add(F);
          if (motion) moved.add(F);
        }
        if constexpr (!wantsForce)
          if (evaluation.energy) energy += Geometry::weight(point) * law.energy(F);
        if constexpr (alongForce) energy += Geometry::weight(point) * law.energy(F);
        if constexpr (wantsForce) {
          Matrix3<P> stress;
          if constexpr (sharesStrain) {
            P traceOfStrain;
            stress = law.stress(F, traceOfStrain);
            if (balls) ball.add(F, traceOfStrain);
            if (motion) moved.add(F);
          } else {
            stress = law.stress(F);
          }
          Matrix3<P> T = timesTranspose(Geometry::weight(point) * stress, J1);
          if constexpr (damped && Element::constantGradient) bulk.addTo(batch, geometry_.localNodes(batch), D, T);
          forces.add(q, T);
        }
      }
      if constexpr (wantsForce) forces.finish();
      if constexpr (damped && !Element::constantGradient)
        bulk.addTo(batch, geometry_.localNodes(batch), position, force);
      if constexpr (Geometry::offersMean && wantsForce)
        if (geometry_.hasMean()) {
          const P* g = geometry_.meanGradientsOf(batch);
          Geometry::addMeanForces(g[3 * n] * meanLaw_.stress(Geometry::meanGradient(position, g)), g, force);
        }
      if constexpr (wantsForce) geometry_.addToSlots(evaluation.slots, batch, force);
      if (evaluation.energy) {
        if constexpr (wantsForce && !alongForce) energy = energyOf(batch, gradients);
        addEnergy(batch, energy, position, evaluation.energy);
      }
      if (balls) balls->left[batch] = ball.left();
      if (motion) moved.finish();
      if constexpr (!wantsForce)
        if (evaluation.visitor) evaluation.visitor->visit(batch, gradients);
    }
  }

  /// Energy at the points of a batch, from deformation gradients in memory.
  [[gnu::noinline]] P energyOf(std::int32_t batch, const double* gradients) const {
    const P* point = geometry_.pointsOf(batch);
    P sum(0.0);
    for (int q = 0; q < geometry_.pointCount(); ++q, point += Geometry::stride) {
      Matrix3<P> F;
      for (int i = 0; i < 9; ++i) F.m[i] = P::load(gradients + (9 * q + i) * lanes);
      sum += Geometry::weight(point) * law_.energy(F);
    }
    return sum;
  }
  void addEnergy(std::int32_t batch, P points, const P (&position)[n][3], double* energy) const {
    P sum = P::load(energy) + points;
    if constexpr (Geometry::offersMean)
      if (geometry_.hasMean()) {
        const P* g = geometry_.meanGradientsOf(batch);
        sum += g[3 * n] * meanLaw_.energy(Geometry::meanGradient(position, g));
      }
    sum.store(energy);
  }

  RINGWATCH_INLINE static P norm(const P (&edges)[n][3]) {
    P sum(0.0);
    for (int a = 1; a < n; ++a)
      sum += edges[a][0] * edges[a][0] + edges[a][1] * edges[a][1] + edges[a][2] * edges[a][2];
    return math::sqrt(sum);
  }
  RINGWATCH_INLINE static P norm(const Matrix3<P>& A) { return math::sqrt(innerProduct(A, A)); }

  /// The rounding of the tangents of a pack of elements, gathered over their points.
  class Budget {
   public:
    RINGWATCH_INLINE Budget(const P (&position)[n][3], const P& extent) : rounding_(norm(position), extent) {
      for (int a = 0; a < n; ++a) T_[a] = P(0.0);
      if constexpr (Geometry::offersMean)
        for (int a = 0; a < n; ++a) gradients_[a] = P(0.0);
    }
    template <class Linearization>
    RINGWATCH_INLINE void addPoint(const Linearization& linearization, const Matrix3<P>& F, const Matrix3<P>& J1,
                                   double table, const P& weight, const P (&g)[n][3]) {
      const P inverse = norm(J1), error = rounding_.gradientError(inverse, table, F);
      rounding_.addPoint(linearization.rounding(F, error), inverse, table, weight, g, T_);
      if constexpr (Geometry::offersMean) {
        error_ = math::max(error_, error);
        condition_ = math::max(condition_, rounding_.condition(inverse, table));
        for (int a = 0; a < n; ++a) gradients_[a] += weight * rounding_.squareOf(g[a]);
      }
    }
    /// The share at the mean gradient: by Jensen's inequality V |ḡ_a|² <= Σ w |g_a|², and the mean of the F errs by no
    /// more than the worst of them, twice that with its own sum.
    template <class Linearization>
    RINGWATCH_INLINE void addMean(const Linearization& linearization, const Matrix3<P>& F) {
      const P factor =
          P(2.0) * TangentRounding<Element, P>::factorOf(linearization.rounding(F, P(2.0) * error_), condition_);
      for (int a = 0; a < n; ++a) T_[a] += select(gradients_[a] > P(0.0), factor * gradients_[a], P(0.0));
    }
    RINGWATCH_INLINE void store(P* T) const {
      for (int a = 0; a < n; ++a) T[a] = T_[a];
    }

   private:
    TangentRounding<Element, P> rounding_;
    P T_[n], gradients_[n], error_ = P(0.0), condition_ = P(0.0);
  };

  void tangent(const std::int32_t* elements, const P* point, const P& extent, const double* x, double* K,
               double* rounding) const {
    const LawType law = law_;
    [[maybe_unused]] const P* const firstPoint = point;
    P position[n][3];
    geometry_.loadEdgesFromMesh(x, elements, position);
    Budget budget(position, extent);
    P* k = reinterpret_cast<P*>(K);
    const auto set = [k](int row, int column, const P& value) { k[row * size + column] = value; };
    const auto add = [k](int row, int column, const P& value) { k[row * size + column] += value; };
    for (int q = 0; q < geometry_.pointCount(); ++q, point += Geometry::stride) {
      const Matrix3<P> J1 = Geometry::inverseJacobian(point);
      const Matrix3<P> F = geometry_.gradient(position, q, J1);
      const auto linearization = law.linearize(F);
      P g[n][3];
      Operators::shapeGradients(J1, geometry_.shapeTable(q), g);
      if (rounding) budget.addPoint(linearization, F, J1, geometry_.tableNorm(q), Geometry::weight(point), g);
      if (q == 0)
        Operators::addTangent(linearization, Geometry::weight(point), g, set);
      else
        Operators::addTangent(linearization, Geometry::weight(point), g, add);
    }
    if constexpr (Geometry::offersMean)
      if (geometry_.hasMean()) {
        P stored[3 * n + 1], g[n][3];
        geometry_.meanGradients(firstPoint, stored);
        for (int i = 0; i < 3 * n; ++i) g[i / 3][i % 3] = stored[i];
        const Matrix3<P> F = Geometry::meanGradient(position, stored);
        const auto linearization = meanLaw_.linearize(F);
        Operators::addTangent(linearization, stored[3 * n], g, add);
        if (rounding) budget.addMean(linearization, F);
      }
    if (rounding) budget.store(reinterpret_cast<P*>(rounding));
    // Symmetric to the last bit.
    for (int i = 1; i < size; ++i)
      for (int j = 0; j < i; ++j) k[i * size + j] = k[j * size + i];
  }

  RINGWATCH_INLINE static void clear(P (&values)[n][3]) {
    for (auto& row : values)
      for (P& value : row) value = P(0.0);
  }

  LawType law_, meanLaw_;
  Geometry geometry_;
};

}  // namespace ringwatch

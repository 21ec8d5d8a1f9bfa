#pragma once
#include <ringwatch/base/double_double.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/rounding.h>
#include <ringwatch/body/element_nodes.h>
#include <ringwatch/body/element_operators.h>

namespace ringwatch {

/// Elements that are evaluated once, at their mean gradients, before any law: HourglassModes::Geometry of each, in
/// packs.
template <class Element>
class UniformStrainGeometry : public ElementNodes<Element::nodes> {
 public:
  using P = NativePack;
  using Modes = typename Element::Hourglass;
  using Stored = typename Modes::template Geometry<P>;
  using Operators = ElementOperators<Element, P>;
  static constexpr int n = Element::nodes, vectors = Modes::count;

  /// Of one pack of elements: g_a and γ_α of the nodes, and (Σ_a |g_a|²)^½, 1/m.
  struct Vectors {
    P g[n][3], gamma[vectors][n], norm;
  };

  /// stiffness: κ M / 2, Pa. Throws NumericalError for an element whose volume is not positive. Keeps the block by
  /// reference.
  UniformStrainGeometry(const ElementBlock& block, const Mesh& mesh, const MeshBlock& meshBlock, double stiffness)
      : ElementNodes<n>(block) {
    fill(mesh, meshBlock, stiffness);
  }

  const Stored& of(std::int32_t batch) const { return stored_[static_cast<std::size_t>(batch)]; }
  RINGWATCH_INLINE void prefetchAhead(std::int32_t batch) const {
    this->template prefetch<sizeof(Stored) / sizeof(P)>(reinterpret_cast<const P*>(&of(this->ahead(batch))));
  }
  /// The same of any elements, one a lane; lanes without an element (-1) repeat the first, without volume and
  /// stiffness.
  [[gnu::noinline]] void gather(const std::int32_t* elements, Stored& out) const {
    constexpr int count = sizeof(Stored) / sizeof(P);
    P* const to = reinterpret_cast<P*>(&out);
    for (int lane = 0; lane < lanes; ++lane) {
      const std::int32_t place =
          this->block().layout().batchOfElement[elements[lane] < 0 ? elements[0] : elements[lane]];
      const P* from = reinterpret_cast<const P*>(&of(place / lanes));
      for (int i = 0; i < count; ++i) to[i].set(lane, from[i][place % lanes]);
      if (elements[lane] < 0) {
        out.volume.set(lane, 0.0);
        out.stiffness.set(lane, 0.0);
      }
    }
  }
  [[gnu::noinline]] static Vectors vectorsOf(const Stored& at) {
    Vectors r;
    Modes::vectors(at, r.g, r.gamma);
    P sum(0.0);
    for (const auto& own : at.G)
      for (const P& entry : own) sum += entry * entry;
    r.norm = math::sqrt(P(8.0) * sum);
    return r;
  }

  /// F̄ and q_α of edges: q[α][component].
  RINGWATCH_INLINE static Matrix3<P> deformation(const Stored& at, const P (&edges)[n][3], P (&q)[vectors][3]) {
    Matrix3<P> F;
    RINGWATCH_UNROLL
    for (int i = 0; i < 3; ++i) {
      P mode[8], row[3], own[vectors];
      Modes::toModes(edges, i, mode);
      Modes::deformation(at, mode, row, own);
      for (int j = 0; j < 3; ++j) F(i, j) = row[j];
      for (int h = 0; h < vectors; ++h) q[h][i] = own[h];
    }
    return F;
  }
  /// Forces of V P and k q_α.
  RINGWATCH_INLINE static void forces(const Stored& at, const Matrix3<P>& stress, const P (&q)[vectors][3],
                                      P (&force)[n][3]) {
    RINGWATCH_UNROLL
    for (int i = 0; i < 3; ++i) {
      P mode[8], row[3], kq[vectors];
      for (int j = 0; j < 3; ++j) row[j] = at.volume * stress(i, j);
      for (int h = 0; h < vectors; ++h) kq[h] = at.stiffness * q[h][i];
      Modes::forces(at, row, kq, mode);
      Modes::toNodes(mode, i, force);
    }
  }
  /// ½ k Σ_α |q_α|²
  RINGWATCH_INLINE static P hourglassEnergy(const Stored& at, const P (&q)[vectors][3]) {
    P sum(0.0);
    for (const auto& own : q) sum += own[0] * own[0] + own[1] * own[1] + own[2] * own[2];
    return P(0.5) * at.stiffness * sum;
  }

  // Rounding: Theorem 72, docs/theory/hourglass.md.
  /// What F̄ errs by. edges: |x_a - x_0|, the root of the sum of squares over the nodes.
  RINGWATCH_INLINE static P gradientError(const Vectors& own, const P& edges) {
    return P(gradientFactor * unitRoundoff) * own.norm * edges;
  }
  /// T_a of the nodes, the same for all: of V g_a C g_b for a law's rounding, and of the hourglass stiffness.
  RINGWATCH_INLINE static P tangentError(const Stored& at, const Vectors& own, const ModulusRounding<P>& law) {
    const P uniform = uniformError(at, own, law);
    return select(at.volume > P(0.0), uniform, P(0.0)) + at.stiffness * hourglassError(at, own);
  }
  /// That of Σ_α γ_α γ_αᵀ ⊗ I₃.
  RINGWATCH_INLINE static P hourglassError(const Stored& at, const Vectors& own) {
    P sum(0.0);
    for (const auto& s : at.s) {
      const P m = P(1.0) + math::sqrt(s[0] * s[0] + s[1] * s[1] + s[2] * s[2]) * own.norm;
      sum += m * m;
    }
    return P(hourglassFactor * unitRoundoff) * sum;
  }
  /// T_a of V g_a · g_b.
  RINGWATCH_INLINE static P laplacianError(const Stored& at, const Vectors& own) {
    return uniformError(at, own, {P(1.0), P(0.0)});
  }

 private:
  static constexpr double gradientFactor = 24, shapeFactor = 20, hourglassFactor = 96;
  /// Least volume of the cube of the extent: below it, twice the precision is not enough for a volume's rounding.
  static constexpr double leastVolume = 1e-12;

  RINGWATCH_INLINE static P uniformError(const Stored& at, const Vectors& own, const ModulusRounding<P>& law) {
    return P(2.0) * at.volume * own.norm * own.norm *
           (law.error + P((productRounding + shapeFactor) * unitRoundoff) * law.size);
  }
  [[gnu::noinline]] void fill(const Mesh& mesh, const MeshBlock& meshBlock, double stiffness) {
    using Wide = DoubleDouble<P>;
    const std::int32_t batches = this->block().layout().batchCount();
    stored_.resize(static_cast<std::size_t>(batches));
    for (std::int32_t batch = 0; batch < batches; ++batch) {
      Wide X[n][3];
      this->loadWideEdges(mesh.X, batch, X);
      P extent2(0.0);
      for (const auto& edge : X)
        for (const Wide& entry : edge) extent2 += entry.high * entry.high;
      typename Modes::template Geometry<Wide> wide;
      Modes::atRest(X, Wide(P(stiffness), P(0.0)), wide);
      Stored& own = stored_[static_cast<std::size_t>(batch)];
      for (int m = 0; m < 6; ++m)
        for (int i = 0; i < 3; ++i) own.G[m][i] = wide.G[m][i].rounded();
      for (int h = 0; h < vectors; ++h)
        for (int i = 0; i < 3; ++i) own.s[h][i] = wide.s[h][i].rounded();
      own.volume = wide.volume.rounded();
      own.stiffness = wide.stiffness.rounded();
      for (int lane = 0; lane < lanes; ++lane) {
        const std::int32_t e = this->elementsOf(batch)[lane];
        const double least = leastVolume * extent2[lane] * std::sqrt(extent2[lane]);
        if (e >= 0 && !(own.volume[lane] > least))
          throw NumericalError(
              joinText(Element::name, " element ", meshBlock.id(e), ": volume ", own.volume[lane], " m³ must be > 0"));
        if (e >= 0) continue;
        own.volume.set(lane, 0.0);
        own.stiffness.set(lane, 0.0);
      }
    }
  }

  AlignedVector<Stored> stored_;  // [batch]
};

}  // namespace ringwatch

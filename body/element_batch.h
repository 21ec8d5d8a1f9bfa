#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include <ringwatch/base/error.h>
#include <ringwatch/base/matrix3.h>
#include <ringwatch/body/deformation_watch.h>
#include <ringwatch/body/element_block.h>

namespace ringwatch {

/// The hot loops: all elements of one type and law, structure-of-arrays, one lane an element. `Element` and `LawType`
/// are entries of the registries; the quadrature rule is data.
///
/// With D = Σ_a x_a ⊗ ∂N_a/∂ξ and the Jacobian J = ∂X/∂ξ: F = D J⁻¹. A force is f_a = Σ_q w_q det(J) P J⁻ᵀ ∂N_a/∂ξ.
/// J⁻¹ and w det(J) are stored for each quadrature point, 10 numbers. Rules with a share at the mean deformation
/// gradient (LameShares) add one more evaluation with the mean gradients ∂N_a/∂X, stored by element.
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
    alignas(64) double rows[4 * maxPatchNodes];
    gatherRows(patch, x, rows);
    NoTest none;
    addForces(patch.batchBegin, patch.batchEnd, rows, slots, none);
  }

  void tangentProductPatch(const Patch& patch, const double* x, const double* v, double* slots) const override {
    const LawType law = law_;
    alignas(64) double vRows[4 * maxPatchNodes];
    gatherRows(patch, v, vRows);
    overPatch(patch, x, [&](const double* rows, std::int32_t batch) {
      P position[n][3], direction[n][3], force[n][3];
      loadEdges(rows, batch, position);
      loadEdges(vRows, batch, direction);
      clear(force);
      const P* geometry = geometryOf(batch);
      for (int q = 0; q < pointCount(); ++q, geometry += 10) {
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
      loadEdges(rows, batch, position);
      const P* geometry = geometryOf(batch);
      for (int q = 0; q < pointCount(); ++q, geometry += 10)
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
    tangent(layout().elements.data() + static_cast<std::ptrdiff_t>(batch) * lanes, geometryOf(batch), x, K);
  }

  void tangentOf(const std::int32_t* elements, const double* x, double* K) const override {
    P geometry[10 * maxPoints];
    gatherGeometry(elements, geometry);
    tangent(elements, geometry, x, K);
  }

  void laplacianOf(const std::int32_t* elements, double* L) const override {
    P gathered[10 * maxPoints];
    gatherGeometry(elements, gathered);
    P* l = reinterpret_cast<P*>(L);
    for (int i = 0; i < n * n; ++i) l[i] = P(0.0);
    const P* geometry = gathered;
    for (int q = 0; q < pointCount(); ++q, geometry += 10) {
      P g[n][3];
      referenceGradients(geometry, q, g);
      for (int a = 0; a < n; ++a)
        for (int c = 0; c < n; ++c)
          l[a * n + c] += geometry[9] * (g[a][0] * g[c][0] + g[a][1] * g[c][1] + g[a][2] * g[c][2]);
    }
  }

  void deformationOf(const std::int32_t* elements, const double* x, double* F, TangentDrift* drift) const override {
    P gathered[10 * maxPoints];
    gatherGeometry(elements, gathered);
    P position[n][3];
    loadEdgesFromMesh(x, elements, position);
    const P* geometry = gathered;
    PackedDrift all;
    for (int q = 0; q < pointCount(); ++q, geometry += 10) {
      const Matrix3<P> own = gradient(position, q) * inverseJacobian(geometry);
      for (int i = 0; i < 9; ++i) own.m[i].store(F + (9 * q + i) * lanes);
      all.noteDeterminant(own);
      const TangentDriftCoefficients<P> here = law_.drift(own);
      all.law.kappa = math::max(all.law.kappa, here.kappa);
      all.law.linear = math::max(all.law.linear, here.linear);
      all.law.quadratic = math::max(all.law.quadratic, here.quadratic);
      all.law.negative = math::max(all.law.negative, here.negative);
      all.law.radius = math::min(all.law.radius, here.radius);
    }
    if constexpr (offersMean)
      if (mean_) {
        // The mean of F moves by no more than the farthest F_q, and V B̄ᵀB̄ ≼ Σ w BᵀB: the shares' bounds add up.
        P stored[3 * n + 1];
        meanGradients(gathered, stored);
        const Matrix3<P> own = meanGradient(position, stored);
        all.noteDeterminant(own);
        const TangentDriftCoefficients<P> mean = meanLaw_.drift(own);
        all.law.kappa += mean.kappa;
        all.law.linear += mean.linear;
        all.law.quadratic += mean.quadratic;
        all.law.negative += mean.negative;
        all.law.radius = math::min(all.law.radius, mean.radius);
      }
    for (int lane = 0; lane < lanes; ++lane)
      drift[lane] = {{all.law.kappa[lane], all.law.linear[lane], all.law.quadratic[lane], all.law.negative[lane],
                      all.law.radius[lane]},
                     all.determinant[lane],
                     all.inversionDistance[lane]};
  }

  void lookAtPatch(std::int32_t patchIndex, const double* x, DeformationWatch& watch,
                   std::vector<std::int32_t>& left) const override {
    const Patch& patch = layout().patches[static_cast<std::size_t>(patchIndex)];
    alignas(64) double rows[4 * maxPatchNodes];
    gatherRows(patch, x, rows);
    forEachGroup(
        patchIndex, rows, watch, left, [](const DeformationWatch::Group&) {},
        [&](const DeformationWatch::Group& group, BallTest& test) {
          for (std::int32_t batch = group.batchBegin; batch < group.batchEnd; ++batch) {
            P position[n][3];
            loadEdges(rows, batch, position);
            const P* geometry = geometryOf(batch);
            test.begin(batch);
            for (int q = 0; q < pointCount(); ++q, geometry += 10)
              test.at(gradient(position, q) * inverseJacobian(geometry));
            test.end();
          }
        });
  }

  void forceAndLookPatch(std::int32_t patchIndex, const double* x, DeformationWatch& watch, double* slots,
                         std::vector<std::int32_t>& left) const override {
    const Patch& patch = layout().patches[static_cast<std::size_t>(patchIndex)];
    alignas(64) double rows[4 * maxPatchNodes];
    gatherRows(patch, x, rows);
    NoTest none;
    forEachGroup(
        patchIndex, rows, watch, left,
        [&](const DeformationWatch::Group& group) { addForces(group.batchBegin, group.batchEnd, rows, slots, none); },
        [&](const DeformationWatch::Group& group, BallTest& test) {
          addForces(group.batchBegin, group.batchEnd, rows, slots, test);
        });
  }

  void gradientNormBatch(std::int32_t batch, double* norms) const override {
    const P* geometry = geometryOf(batch);
    P largest(0.0);
    for (int q = 0; q < pointCount(); ++q, geometry += 10) {
      P g[n][3], sum(0.0);
      referenceGradients(geometry, q, g);
      for (int a = 0; a < n; ++a) sum += math::sqrt(g[a][0] * g[a][0] + g[a][1] * g[a][1] + g[a][2] * g[a][2]);
      largest = math::max(largest, sum);
    }
    largest.store(norms);
  }

  void minimumDeterminantBatch(std::int32_t batch, const double* x, double* determinants) const override {
    P position[n][3];
    loadEdgesFromMesh(x, batch, position);
    const P* geometry = geometryOf(batch);
    P least(0.0);
    for (int q = 0; q < pointCount(); ++q, geometry += 10) {
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
    LawType law = material.as<LawType>();
    if constexpr (requires { law.constants.lambda* law.constants.mu; }) {
      law.constants.lambda *= lambdaShare;
      law.constants.mu *= muShare;
    } else if (lambdaShare != muShare) {
      throw InputError(joinText(Element::name,
                                ": rules that treat pressure and shear apart need a law linear in Lamé's constants; ",
                                LawType::name, " is none"));
    }
    return law;
  }
  /// A TangentDrift in every lane.
  struct PackedDrift {
    TangentDriftCoefficients<P> law{P(0.0), P(0.0), P(0.0), P(0.0)};
    P determinant = P(std::numeric_limits<double>::infinity()), inversionDistance = determinant;

    RINGWATCH_INLINE void noteDeterminant(const Matrix3<P>& F) {
      // s3 = det F / (s1 s2) >= 2 det F / |F|², and no matrix closer than s3 is singular.
      const P det = ringwatch::determinant(F);
      inversionDistance = math::min(inversionDistance, select(det > P(0.0), P(2.0) * det / innerProduct(F, F), P(0.0)));
      determinant = math::min(determinant, det);
    }
  };
  /// k += w g ⊗ (∂P/∂F) g, for the blocks of nodes a <= b; `first` overwrites.
  template <class Linearization>
  RINGWATCH_INLINE static void addTangent(const Linearization& linearization, const P& weight, const P (&g)[n][3],
                                          bool first, P* k) {
    if constexpr (requires { linearization.nodeBlocks(weight); }) {
      const auto blocks = linearization.nodeBlocks(weight);
      typename std::remove_const_t<decltype(blocks)>::Node node[n];
      for (int a = 0; a < n; ++a) node[a] = blocks.node(g[a]);
      for (int a = 0; a < n; ++a)
        for (int b = a; b < n; ++b) {
          const Matrix3<P> block = blocks(node[a], node[b]);
          P* target = k + 3 * a * 3 * n + 3 * b;
          for (int i = 0; i < 9; ++i) {
            P& entry = target[i / 3 * 3 * n + i % 3];
            entry = first ? block.m[i] : entry + block.m[i];
          }
        }
    } else {
      addTangentByColumns(linearization, weight, g, first, k);
    }
  }
  /// For laws that do not offer `nodeBlocks`.
  template <class Linearization>
  static void addTangentByColumns(const Linearization& linearization, const P& weight, const P (&g)[n][3], bool first,
                                  P* k) {
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
        for (int a = 0; a <= b; ++a)
          for (int row = 0; row < 3; ++row) {
            P& entry = k[(3 * a + row) * 3 * n + 3 * b + column];
            const P added = t(row, 0) * g[a][0] + t(row, 1) * g[a][1] + t(row, 2) * g[a][2];
            entry = first ? added : entry + added;
          }
      }
  }
  /// Mean gradients ∂N_a/∂X of a batch, row by row, then the volume.
  const P* meanGradientsOf(std::int32_t batch) const {
    return meanGradients_.data() + static_cast<std::ptrdiff_t>(batch) * (3 * n + 1);
  }
  RINGWATCH_INLINE static Matrix3<P> meanGradient(const P (&x)[n][3], const P* g) {
    Matrix3<P> r = Matrix3<P>::zero();
    for (int a = 1; a < n; ++a)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) r(i, j) += x[a][i] * g[3 * a + j];
    return r;
  }
  RINGWATCH_INLINE static void scatterMean(const Matrix3<P>& T, const P* g, P (&force)[n][3]) {
    for (int a = 0; a < n; ++a)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) force[a][i] += T(i, j) * g[3 * a + j];
  }
  void tangent(const std::int32_t* elements, const P* geometry, const double* x, double* K) const {
    const LawType law = law_;
    [[maybe_unused]] const P* first = geometry;
    P position[n][3];
    loadEdgesFromMesh(x, elements, position);
    P* k = reinterpret_cast<P*>(K);
    for (int q = 0; q < pointCount(); ++q, geometry += 10) {
      const Matrix3<P> J1 = inverseJacobian(geometry);
      const auto linearization = law.linearize(gradient(position, q) * J1);
      P g[n][3];
      referenceGradients(geometry, q, g);
      addTangent(linearization, geometry[9], g, q == 0, k);
    }
    if constexpr (offersMean)
      if (mean_) {
        P stored[3 * n + 1], g[n][3];
        meanGradients(first, stored);
        for (int i = 0; i < 3 * n; ++i) g[i / 3][i % 3] = stored[i];
        addTangent(meanLaw_.linearize(meanGradient(position, stored)), stored[3 * n], g, false, k);
      }
    // Symmetric to the last bit.
    for (int i = 1; i < 3 * n; ++i)
      for (int j = 0; j < i; ++j) k[i * 3 * n + j] = k[j * 3 * n + i];
  }

  /// g_a = J⁻ᵀ ∂N_a/∂ξ, the gradients in reference coordinates.
  void referenceGradients(const P* geometry, int q, P (&g)[n][3]) const {
    const Matrix3<P> J1 = inverseJacobian(geometry);
    for (int a = 0; a < n; ++a)
      for (int j = 0; j < 3; ++j)
        g[a][j] = P(dN(q, a, 0)) * J1(0, j) + P(dN(q, a, 1)) * J1(1, j) + P(dN(q, a, 2)) * J1(2, j);
  }
  /// Geometry of scattered elements; lanes without one repeat the first and weigh nothing.
  void gatherGeometry(const std::int32_t* elements, P* geometry) const {
    const int count = pointCount() * 10;
    for (int lane = 0; lane < lanes; ++lane) {
      const std::int32_t e = elements[lane] < 0 ? elements[0] : elements[lane];
      const std::int32_t place = layout().batchOfElement[static_cast<std::size_t>(e)];
      const P* from = geometryOf(place / lanes);
      for (int i = 0; i < count; ++i) geometry[i].set(lane, from[i][place % lanes]);
      if (elements[lane] < 0)
        for (int q = 0; q < pointCount(); ++q) geometry[10 * q + 9].set(lane, 0.0);
    }
  }

  /// Adds the forces of some batches of a patch; `test` sees every deformation gradient.
  template <class Test>
  void addForces(std::int32_t first, std::int32_t last, const double* rows, double* slots, Test& test) const {
    const LawType law = law_;
    for (std::int32_t batch = first; batch < last; ++batch) {
      P position[n][3], force[n][3];
      loadEdges(rows, batch, position);
      clear(force);
      const P* geometry = geometryOf(batch);
      test.begin(batch);
      for (int q = 0; q < pointCount(); ++q, geometry += 10) {
        const Matrix3<P> J1 = inverseJacobian(geometry);
        const Matrix3<P> F = gradient(position, q) * J1;
        test.at(F);
        scatter(timesTranspose(geometry[9] * law.stress(F), J1), q, force);
      }
      if constexpr (offersMean)
        if (mean_) {
          const P* g = meanGradientsOf(batch);
          scatterMean(g[3 * n] * meanLaw_.stress(meanGradient(position, g)), g, force);
        }
      add(slots, batch, force);
      test.end();
    }
  }
  struct NoTest {
    void begin(std::int32_t) {}
    void at(const Matrix3<P>&) {}
    void end() {}
  };
  /// Compares elements with their balls, a batch after another: who has left, the least room of those that stay, and
  /// the largest reach, m.
  class BallTest {
   public:
    BallTest(const ElementBatch& block, const DeformationWatch& watch, std::vector<std::int32_t>& left)
        : block_(block), watch_(watch), left_(left) {}
    RINGWATCH_INLINE void begin(std::int32_t batch) {
      batch_ = batch;
      anchor_ = watch_.anchor.data() + static_cast<std::ptrdiff_t>(batch) * block_.points_ * 9 * lanes;
      distance2_ = here2_ = P(0.0);
    }
    RINGWATCH_INLINE void at(const Matrix3<P>& F) {
      P d2(0.0);
      here2_ = math::max(here2_, innerProduct(F, F));
      for (int i = 0; i < 9; ++i, anchor_ += lanes) {
        const P d = F.m[i] - P(DeformationWatch::anchorUnit) * loadUnits(anchor_);
        d2 += d * d;
      }
      // A NaN fails the comparison inside max and would pass unseen: keep it.
      distance2_ = select(d2 <= distance2_, distance2_, d2);
    }
    RINGWATCH_INLINE void end() {
      // Roots in single precision, rounded up, cost a third.
      const P distance = P(1 + 1e-6) * roughRoot(distance2_), here = P(1 + 1e-6) * roughRoot(here2_);
      const std::ptrdiff_t place = static_cast<std::ptrdiff_t>(batch_) * lanes;
      const P inverseNorm = Bfloat16::load(watch_.inverseGradientNorm.data() + place);
      const P radius = Bfloat16::load(watch_.radius.data() + place), room = radius - distance;
      const auto stays = room >= P(DeformationWatch::restingShare) * radius;
      leastRoom_ = math::min(leastRoom_, select(stays, room * inverseNorm, leastRoom_));
      // 1/γ is rounded down.
      reach_ = math::max(reach_, P(1 + 1.0 / 64) * here * inverseNorm);
      if (allOf(stays)) return;
      const P inside = select(stays, P(1.0), P(0.0));
      for (int lane = 0; lane < lanes; ++lane) {
        // Lanes without an element never leave, but for positions whose squares overflow.
        const std::int32_t element = block_.layout().elements[static_cast<std::size_t>(place + lane)];
        if (inside[lane] == 0 && element >= 0) left_.push_back(element);
      }
    }
    double leastRoom() const {
      double least = leastRoom_[0];
      for (int lane = 1; lane < lanes; ++lane) least = std::min(least, leastRoom_[lane]);
      return least;
    }
    double reach() const {
      double most = reach_[0];
      for (int lane = 1; lane < lanes; ++lane) most = std::max(most, reach_[lane]);
      return most;
    }

   private:
    RINGWATCH_INLINE static P loadUnits(const std::int16_t* from) {
      return P(__builtin_convertvector(detail::loadShorts(from), typename P::Values));
    }
    RINGWATCH_INLINE static P roughRoot(P a) {  // to 1e-7
      auto values = __builtin_convertvector(a.v, detail::NativeFloats);
      for (int lane = 0; lane < lanes; ++lane) values[lane] = std::sqrt(values[lane]);
      return detail::packOf(values);
    }

    const ElementBatch& block_;
    const DeformationWatch& watch_;
    std::vector<std::int32_t>& left_;
    std::int32_t batch_ = 0;
    const std::int16_t* anchor_ = nullptr;
    P distance2_, here2_;
    P leastRoom_ = P(std::numeric_limits<double>::infinity()), reach_ = P(0.0);
  };

  /// Calls resting(group) or looking(group, test) for the groups of a patch.
  template <class Resting, class Looking>
  void forEachGroup(std::int32_t patch, const double* rows, DeformationWatch& watch, std::vector<std::int32_t>& left,
                    const Resting& resting, const Looking& looking) const {
    const auto at = static_cast<std::size_t>(patch);
    for (std::int32_t g = watch.patchGroups[at]; g < watch.patchGroups[at + 1]; ++g) {
      DeformationWatch::Group& group = watch.groups[static_cast<std::size_t>(g)];
      if (watch.rests(group, rows)) {
        resting(group);
        continue;
      }
      BallTest test(*this, watch, left);
      looking(group, test);
      watch.startRest(group, test.leastRoom(), test.reach(), rows);
    }
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
  /// Nodal vectors of a batch less that of each element's first node: gradients need differences only, and far from the
  /// origin sums of large coordinates would lose the element's size.
  RINGWATCH_INLINE void loadEdges(const double* rows, std::int32_t batch, P (&out)[n][3]) const {
    const std::uint16_t* local = localNodes(batch);
    for (int a = 0; a < n; ++a) loadRows(rows, local + a * lanes, out[a]);
    subtractFirst(out);
  }
  RINGWATCH_INLINE static void subtractFirst(P (&x)[n][3]) {
    for (int a = 1; a < n; ++a)
      for (int i = 0; i < 3; ++i) x[a][i] -= x[0][i];
    for (int i = 0; i < 3; ++i) x[0][i] = P(0.0);
  }
  RINGWATCH_INLINE void add(double* slots, std::int32_t batch, const P (&values)[n][3]) const {
    const std::uint16_t* local = localNodes(batch);
    for (int a = 0; a < n; ++a) addRows(slots, local + a * lanes, values[a]);
  }
  RINGWATCH_INLINE static void clear(P (&values)[n][3]) {
    for (auto& row : values)
      for (P& value : row) value = P(0.0);
  }
  /// The same for single batches, straight from the mesh's node vector. Lanes without an element repeat the batch's
  /// first.
  void loadEdgesFromMesh(const double* x, std::int32_t batch, P (&out)[n][3]) const {
    loadEdgesFromMesh(x, layout().elements.data() + static_cast<std::ptrdiff_t>(batch) * lanes, out);
  }
  void loadEdgesFromMesh(const double* x, const std::int32_t* elements, P (&out)[n][3]) const {
    alignas(64) double rows[4 * n * lanes];
    std::uint16_t local[n * lanes];
    for (int lane = 0; lane < lanes; ++lane) {
      const auto nodes = nodesOf(elements[lane] < 0 ? elements[0] : elements[lane]);
      for (int a = 0; a < n; ++a) {
        const int row = a * lanes + lane;
        const double* from = x + 3 * static_cast<std::ptrdiff_t>(nodes[static_cast<std::size_t>(a)]);
        const detail::Row4 padded{from[0], from[1], from[2], 0.0};
        std::memcpy(rows + 4 * row, &padded, sizeof padded);
        local[row] = static_cast<std::uint16_t>(row);
      }
    }
    for (int a = 0; a < n; ++a) loadRows(rows, local + a * lanes, out[a]);
    subtractFirst(out);
  }

  double dN(int q, int a, int j) const { return shapeGradients_[static_cast<std::size_t>((q * n + a) * 3 + j)]; }
  const P* geometryOf(std::int32_t batch) const {
    return geometry_.data() + static_cast<std::ptrdiff_t>(batch) * points_ * 10;
  }
  RINGWATCH_INLINE static Matrix3<P> inverseJacobian(const P* geometry) {
    Matrix3<P> r;
    for (int i = 0; i < 9; ++i) r.m[i] = geometry[i];
    return r;
  }
  /// Σ_a x_a ⊗ ∂N_a/∂ξ; x as loadEdges gives it.
  RINGWATCH_INLINE Matrix3<P> gradient(const P (&x)[n][3], int q) const {
    Matrix3<P> r;
    if constexpr (n == 4) {  // linear tetrahedron
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) r(i, j) = x[j + 1][i];
    } else {
      const double* d = shapeGradients_.data() + static_cast<std::ptrdiff_t>(q) * n * 3;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) r(i, j) = x[1][i] * P(d[3 + j]);
      for (int a = 2; a < n; ++a)
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
  /// Mean gradients of the elements whose geometry is given, as `meanGradientsOf` has them.
  void meanGradients(const P* geometry, P* g) const;

  /// Known at compile time for elements of constant gradient: the loop over points goes, and the sums stay in
  /// registers.
  RINGWATCH_INLINE int pointCount() const { return Element::constantGradient ? 1 : points_; }
  static_assert(!Element::constantGradient || std::ranges::all_of(Element::rules, [](const QuadratureRule& rule) {
    return rule.points.size() == 1;
  }));

  static constexpr std::size_t maxPoints = [] {
    std::size_t most = 1;
    for (const QuadratureRule& rule : Element::rules) most = std::max(most, rule.points.size());
    return most;
  }();

  LawType law_, meanLaw_;
  bool mean_;
  int points_ = 0;
  std::vector<double> shapeGradients_;  // [q][a][j] = ∂N_a/∂ξ_j
  AlignedVector<P> meanGradients_;      // [batch][3n + 1], see meanGradientsOf; empty without a mean share
  AlignedVector<P> geometry_;  // [batch][q][10]: J⁻¹ row by row, w det(J); zero weight in lanes without element
};

template <class Element, class LawType>
void ElementBatch<Element, LawType>::tabulate(const Mesh& mesh, const MeshBlock& block) {
  points_ = static_cast<int>(rule().points.size());
  shapeGradients_.resize(static_cast<std::size_t>(points_ * n * 3));
  for (int q = 0; q < points_; ++q)
    Element::shapeGradient(
        rule().points[static_cast<std::size_t>(q)].xi,
        reinterpret_cast<double(*)[3]>(shapeGradients_.data() + static_cast<std::ptrdiff_t>(q) * n * 3));
  const std::int32_t batches = layout().batchCount();
  geometry_.resize(static_cast<std::size_t>(batches) * static_cast<std::size_t>(points_) * 10);
  for (std::int32_t batch = 0; batch < batches; ++batch) {
    P X[n][3];
    loadEdgesFromMesh(mesh.X.data(), batch, X);
    P* geometry = geometry_.data() + static_cast<std::ptrdiff_t>(batch) * points_ * 10;
    for (int q = 0; q < pointCount(); ++q, geometry += 10) {
      const Matrix3<P> J = gradient(X, q);
      const P det = determinant(J);
      const Matrix3<P> J1 = inverse(J);
      for (int i = 0; i < 9; ++i) geometry[i] = J1.m[i];
      for (int lane = 0; lane < lanes; ++lane) {
        const std::int32_t e =
            layout().elements[static_cast<std::size_t>(batch) * lanes + static_cast<std::size_t>(lane)];
        if (e >= 0 && !(det[lane] > 0))
          throw NumericalError(joinText(Element::name, " element ", block.id(static_cast<std::size_t>(e)),
                                        ": Jacobian determinant ", det[lane], " at quadrature point ", q,
                                        " must be > 0"));
        geometry[9].set(lane, e < 0 ? 0.0 : det[lane] * rule().points[static_cast<std::size_t>(q)].weight);
      }
    }
  }
  if (!mean_) return;
  meanGradients_.resize(static_cast<std::size_t>(batches) * (3 * n + 1));
  for (std::int32_t batch = 0; batch < batches; ++batch)
    meanGradients(geometryOf(batch), meanGradients_.data() + static_cast<std::size_t>(batch) * (3 * n + 1));
}

template <class Element, class LawType>
void ElementBatch<Element, LawType>::meanGradients(const P* geometry, P* g) const {
  for (int i = 0; i <= 3 * n; ++i) g[i] = P(0.0);
  for (int q = 0; q < points_; ++q, geometry += 10) {
    P own[n][3];
    referenceGradients(geometry, q, own);
    for (int i = 0; i < 3 * n; ++i) g[i] += geometry[9] * own[i / 3][i % 3];
    g[3 * n] += geometry[9];
  }
  // Lanes without an element have no volume; they repeat the first lane's gradients, as positions do.
  const auto present = g[3 * n] > P(0.0);
  const P inverse = P(1.0) / select(present, g[3 * n], P(1.0));
  for (int i = 0; i < 3 * n; ++i) {
    const P own = g[i] * inverse;
    g[i] = select(present, own, P(own[0]));
  }
}

}  // namespace ringwatch

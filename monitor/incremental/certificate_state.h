#pragma once
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include <ringwatch/body/body.h>
#include <ringwatch/monitor/bounds/nodal_bound.h>
#include <ringwatch/monitor/incremental/tangent_growth.h>

namespace ringwatch {

/// An element evaluated at some positions.
struct ElementValue {
  double value = 0;       ///< l_e = lambda_max(D_e⁻¹K_e), rounded up
  double strainNorm = 0;  ///< b_e = lambda_max(D_e⁻¹ Σ_q w_q BᵀB), rounded up; 0 unless asked for
  TangentDrift drift;
};

/// Elements of a block evaluated together, one a lane.
struct EvaluatedPack {
  std::int32_t block;
  const std::int32_t* elements;  ///< [lanes], -1: none
  const ElementValue* values;    ///< [lanes]
  const double* gradients;       ///< F[(q * 9 + i) * lanes + lane]
  int points;
};

/// What an incremental certificate is (Theorem 14, docs/theory/incremental_certificate.md): a weight block D_(e,a) for
/// each node of each element, an allowance β_e for each element, N/m, and a certified eigenvalue σ, rad²/s²; and, of a
/// body with discrete forces, a majorant B_i of theirs for each of their nodes (NodalBound::majorants). The two
/// statements
///   l_e <= β_e for all e   and   B_i + Σ_(e∋i) β_e R_e D_(e,a(i)) R_eᵀ ≼ σ m_i I for all nodes i,
/// l_e the highest eigenvalue of (R_e D_e R_eᵀ)⁻¹ K_e, prove lambda_max(M⁻¹K) <= σ (nodal_bound.h): K_e ≼ β_e R_e D_e
/// R_eᵀ, summed up. They say nothing of how β_e was found, so that K_e need not be computed while something else bounds
/// l_e: a validity ball, or TangentGrowth. R_e is a rotation, 1 unless setRotation gave another; excluded elements are
/// no part of the sums, of K or of the proof.
///
/// Users differ in how elements are followed and in what allowances are stored as: a double, or a type whose
/// constructor rounds down. Elements are stored by place = batch * lanes + lane of their block's layout.
template <class Allowance>
class CertificateState {
 public:
  /// Begins with unknown weights and allowances of zero.
  explicit CertificateState(const Body& body);

  const Body& body() const { return body_; }
  NodalBound& weights() { return weights_; }
  const NodalBound& weights() const { return weights_; }
  double certifiedEigenvalue() const { return certifiedEigenvalue_; }
  void setCertifiedEigenvalue(double sigma) { certifiedEigenvalue_ = sigma; }

  std::size_t placeOf(ElementRef e) const {
    return static_cast<std::size_t>(body_.blocks()[e.block]->layout().batchOfElement[e.element]);
  }
  double allowance(ElementRef e) const { return static_cast<double>(allowances_[e.block][placeOf(e)]); }
  void setAllowance(ElementRef e, double allowance) { allowances_[e.block][placeOf(e)] = Allowance(allowance); }
  /// The allowances of a block, by place.
  const std::vector<Allowance>& allowances(std::size_t block) const { return allowances_[block]; }
  std::vector<Allowance>& allowances(std::size_t block) { return allowances_[block]; }

  bool excluded(ElementRef e) const { return !excluded_.empty() && excluded_[e.block][e.element]; }
  /// [block][element]; empty for none.
  void setExcluded(std::vector<std::vector<bool>> excluded) { excluded_ = std::move(excluded); }
  void setExcluded(ElementRef e, bool excluded) { excluded_[e.block][e.element] = excluded; }
  /// Gives elements rotations from now on. Only for elements whose nodes have all components free or none.
  void allowRotations();
  const Eigen::Matrix3d& rotation(ElementRef e) const { return rotations_[e.block][placeOf(e)]; }
  void setRotation(ElementRef e, const Eigen::Matrix3d& R) { rotations_[e.block][placeOf(e)] = R; }

  /// Evaluates elements of a block at x, one a lane, and their deformation gradients, and calls take(EvaluatedPack).
  /// known: l_e of the lanes where they are known already; nullptr: they are computed.
  template <class Take>
  void evaluatePack(NodeVectorsView x, std::int32_t block, const std::int32_t* elements, const double* known,
                    bool withStrainNorm, const Take& take) const;
  /// Evaluates any elements so, in packs and in parallel: take(EvaluatedPack, index[lanes]), `index` into `elements`;
  /// take writes to places of the elements.
  template <class Take>
  void evaluateEach(NodeVectorsView x, const std::vector<ElementRef>& elements, bool withStrainNorm,
                    const Take& take) const;

  /// Any elements in packs of one block, one a lane (-1: none), in parallel: visit(block, elements[lanes],
  /// index[lanes]), `index` into `elements`.
  template <class Visit>
  void forEachPack(const std::vector<ElementRef>& elements, const Visit& visit) const;

  /// B_i + Σ β_e R_e D_e R_eᵀ at a node, N/m, without the rows and columns of constrained components.
  Eigen::Matrix3d sumOfAllowances(std::int32_t node) const;
  /// Σ β_e R_e D_e R_eᵀ alone, with constrained components.
  Eigen::Matrix3d sumOfElements(std::int32_t node) const;
  /// Checks the two statements at positions x from nothing but weights, rotations, allowances and exact tangents; for
  /// tests. Returns the largest relative excess: <= 0 when both hold, but for rounding. Collective (body/domain.h).
  double verify(NodeVectorsView x) const;

  template <class Archive>
  void archive(Archive& a) {
    a(certifiedEigenvalue_, weights_, allowances_, excluded_, rotations_);
  }

 private:
  const Body& body_;
  NodalBound weights_;
  double certifiedEigenvalue_ = 0;
  std::vector<std::vector<Allowance>> allowances_;
  std::vector<std::vector<bool>> excluded_;
  std::vector<std::vector<Eigen::Matrix3d>> rotations_;  // empty: all 1
};

/// Largest eigenvalue, rounded up; NaN where S is not finite.
double largestEigenvalue(const Eigen::Matrix3d& S);
/// Largest t with base + t part ≼ sigma I; 0 when base alone is too large, infinity where part is zero.
double largestScaling(const Eigen::Matrix3d& base, const Eigen::Matrix3d& part, double sigma);
/// l_e at x and b_e of elements of a block, one a lane (-1: none), with weights of the body: values[lane], norms[lane].
/// Either may be nullptr.
void evaluateElements(const Body& body, const NodalBound& weights, NodeVectorsView x, std::int32_t block,
                      const std::int32_t* elements, double* values, double* norms);

// Templates.

template <class Allowance>
template <class Take>
void CertificateState<Allowance>::evaluatePack(NodeVectorsView x, std::int32_t b, const std::int32_t* elements,
                                               const double* known, bool withStrainNorm, const Take& take) const {
  const ElementBlock& block = *body_.blocks()[b];
  const auto points = static_cast<int>(block.rule().points.size());
  double value[lanes], norm[lanes] = {};
  TangentDrift drift[lanes];
  std::vector<double> F(9 * points * lanes);
  evaluateElements(body_, weights_, x, b, elements, known ? nullptr : value, withStrainNorm ? norm : nullptr);
  block.deformationOf(elements, x.data(), F.data(), drift);
  ElementValue values[lanes];
  for (int lane = 0; lane < lanes; ++lane) values[lane] = {known ? known[lane] : value[lane], norm[lane], drift[lane]};
  take(EvaluatedPack{b, elements, values, F.data(), points});
}

template <class Allowance>
template <class Take>
void CertificateState<Allowance>::evaluateEach(NodeVectorsView x, const std::vector<ElementRef>& elements,
                                               bool withStrainNorm, const Take& take) const {
  forEachPack(elements, [&](std::int32_t block, const std::int32_t* pack, const std::size_t* index) {
    evaluatePack(x, block, pack, nullptr, withStrainNorm,
                 [&](const EvaluatedPack& evaluated) { take(evaluated, index); });
  });
}

template <class Allowance>
template <class Visit>
void CertificateState<Allowance>::forEachPack(const std::vector<ElementRef>& elements, const Visit& visit) const {
  struct Pack {
    std::int32_t block;
    std::int32_t element[lanes];
    std::size_t at[lanes];
    int count = 0;
  };
  std::vector<Pack> packs;
  std::vector<std::ptrdiff_t> open(body_.blocks().size(), -1);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    std::ptrdiff_t& p = open[elements[i].block];
    if (p < 0) {
      p = static_cast<std::ptrdiff_t>(packs.size());
      packs.push_back({elements[i].block, {}, {}, 0});
      std::fill(std::begin(packs.back().element), std::end(packs.back().element), -1);
    }
    Pack& pack = packs[p];
    pack.element[pack.count] = elements[i].element;
    pack.at[pack.count] = i;
    if (++pack.count == lanes) p = -1;
  }
  parallelFor(
      0, packs.size(), body_.threads(),
      [&](std::int64_t k) {
        const Pack& pack = packs[k];
        visit(pack.block, pack.element, pack.at);
      },
      8);
}

}  // namespace ringwatch

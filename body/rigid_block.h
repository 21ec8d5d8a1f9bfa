#pragma once
#include <algorithm>
#include <memory>
#include <utility>

#include <ringwatch/body/element_block.h>

namespace ringwatch {

/// A block all of whose elements lie within rigid bodies. They turn without being deformed: they have neither forces
/// nor energies nor tangents, whatever rounding makes of their gradients, and their stiffness sets no step.
class RigidBlock final : public ElementBlock {
 public:
  /// inner: of the same mesh block.
  RigidBlock(const MeshBlock& block, std::unique_ptr<ElementBlock> inner)
      : ElementBlock(block, inner->material(), inner->rule(), inner->layout()), inner_(std::move(inner)) {}

  void evaluateBatches(std::int32_t first, std::int32_t last, const double* rows,
                       const BatchEvaluation& evaluation) const override {
    if (evaluation.visitor) inner_->evaluateBatches(first, last, rows, {nullptr, nullptr, evaluation.visitor});
  }
  void tangentProductBatches(std::int32_t, std::int32_t, const double*, const double*, double*) const override {}
  void tangentBatch(std::int32_t, const double*, double* K, double* rounding) const override { clear(K, rounding); }
  void tangentOf(const std::int32_t*, const double*, double* K, double* rounding) const override { clear(K, rounding); }
  void addTangentRounding(const Patch&, const double*, double*) const override {}
  void laplacianOf(const std::int32_t*, double* L, double* rounding) const override {
    std::fill_n(L, nodesPerElement() * nodesPerElement() * lanes, 0.0);
    if (rounding) std::fill_n(rounding, nodesPerElement() * lanes, 0.0);
  }
  /// What does not deform does not grow stiffer and does not invert.
  void deformationOf(const std::int32_t* elements, const double* x, double* F, TangentDrift* drift) const override {
    inner_->deformationOf(elements, x, F, drift);
    for (int lane = 0; lane < lanes; ++lane) drift[lane] = TangentDrift();
  }
  void gradientNormBatch(std::int32_t batch, double* norms) const override { inner_->gradientNormBatch(batch, norms); }
  void minimumDeterminantBatch(std::int32_t batch, const double* x, double* determinants) const override {
    inner_->minimumDeterminantBatch(batch, x, determinants);
  }
  void stressBatch(std::int32_t batch, const double* x, double* stress, double* F) const override {
    inner_->stressBatch(batch, x, stress, F);
  }
  void volumeBatch(std::int32_t batch, double* volumes) const override { inner_->volumeBatch(batch, volumes); }
  bool goesByDirections() const override { return inner_->goesByDirections(); }

 private:
  void clear(double* K, double* rounding) const {
    const int n = nodesPerElement();
    std::fill_n(K, 9 * n * n * lanes, 0.0);
    if (rounding) std::fill_n(rounding, n * lanes, 0.0);
  }

  std::unique_ptr<ElementBlock> inner_;
};

}  // namespace ringwatch

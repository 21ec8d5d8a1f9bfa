#pragma once
#include <algorithm>
#include <memory>
#include <utility>

#include <ringwatch/body/wrapped_block.h>

namespace ringwatch {

/// A block all of whose elements lie within rigid bodies. They turn without being deformed: they have neither forces
/// nor energies nor tangents, whatever rounding makes of their gradients, and their stiffness sets no step.
class RigidBlock final : public WrappedBlock {
 public:
  /// inner: of the same mesh block.
  RigidBlock(const MeshBlock& block, std::unique_ptr<ElementBlock> inner) : WrappedBlock(block, std::move(inner)) {}

  void evaluateBatches(std::int32_t first, std::int32_t last, const double* rows,
                       const BatchEvaluation& evaluation) const override {
    if (evaluation.visitor || evaluation.balls)
      inner().evaluateBatches(first, last, rows, {.visitor = evaluation.visitor, .balls = evaluation.balls});
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
    inner().deformationOf(elements, x, F, drift);
    for (int lane = 0; lane < lanes; ++lane) drift[lane] = TangentDrift();
  }

 private:
  void clear(double* K, double* rounding) const {
    const int n = nodesPerElement();
    std::fill_n(K, 9 * n * n * lanes, 0.0);
    if (rounding) std::fill_n(rounding, n * lanes, 0.0);
  }
};

}  // namespace ringwatch

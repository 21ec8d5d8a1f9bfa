#pragma once
#include <ringwatch/body/element_block.h>

namespace ringwatch {

/// Elements of which only the tangents are known: another code computes them. They answer for their tangents and throw
/// NumericalError when asked for a force, an energy or anything of a deformation.
class TangentBlock final : public ElementBlock {
 public:
  TangentBlock(const Mesh& mesh, const MeshBlock& block);

  /// The tangents from now on, 3n×3n numbers an element, N/m, symmetric, n the nodes of the block's element type;
  /// rows and columns 3·node + component. Kept by reference.
  void setTangents(const double* tangents) { tangents_ = tangents; }

  void tangentBatch(std::int32_t batch, const double* x, double* K) const override;
  void tangentOf(const std::int32_t* elements, const double* x, double* K) const override;
  void tangentProductBatches(std::int32_t first, std::int32_t last, const double* rows, const double* vRows,
                             double* slots) const override;

  void evaluateBatches(std::int32_t, std::int32_t, const double*, const BatchEvaluation&) const override {
    unknown("force");
  }
  void laplacianOf(const std::int32_t*, double*) const override { unknown("shape gradients"); }
  void deformationOf(const std::int32_t*, const double*, double*, TangentDrift*) const override {
    unknown("deformation gradient");
  }
  void gradientNormBatch(std::int32_t, double*) const override { unknown("shape gradients"); }
  void minimumDeterminantBatch(std::int32_t, const double*, double*) const override { unknown("deformation gradient"); }
  void volumeBatch(std::int32_t, double*) const override { unknown("volume"); }

 private:
  [[noreturn]] static void unknown(const char* what);

  const double* tangents_ = nullptr;
};

}  // namespace ringwatch

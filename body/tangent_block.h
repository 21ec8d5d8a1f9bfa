#pragma once
#include <ringwatch/body/element_block.h>

namespace ringwatch {

/// Elements of which only the tangents are known: somebody else computes them. They answer for their tangents and throw
/// NumericalError when asked for a force, an energy or anything of a deformation.
class TangentBlock final : public ElementBlock {
 public:
  TangentBlock(const Mesh& mesh, const MeshBlock& block);

  /// The tangents from now on, 3n×3n numbers an element, N/m, symmetric, n the nodes of the block's element type;
  /// rows and columns 3·node + component. Kept by reference.
  void setTangents(const double* tangents) { tangents_ = tangents; }

  void tangentBatch(std::int32_t batch, const double* x, double* K) const override;
  void tangentOf(const std::int32_t* elements, const double* x, double* K) const override;
  void tangentProductPatch(const Patch& patch, const double* x, const double* v, double* slots) const override;

  void forcePatch(const Patch&, const double*, double*) const override { unknown("force"); }
  double energyPatch(const Patch&, const double*) const override { unknown("energy"); }
  void laplacianOf(const std::int32_t*, double*) const override { unknown("shape gradients"); }
  void deformationOf(const std::int32_t*, const double*, double*, TangentDrift*) const override {
    unknown("deformation gradient");
  }
  void lookAtPatch(std::int32_t, const double*, DeformationWatch&, std::vector<std::int32_t>&) const override {
    unknown("deformation gradient");
  }
  void forceAndLookPatch(std::int32_t, const double*, DeformationWatch&, double*,
                         std::vector<std::int32_t>&) const override {
    unknown("force");
  }
  void gradientNormBatch(std::int32_t, double*) const override { unknown("shape gradients"); }
  void minimumDeterminantBatch(std::int32_t, const double*, double*) const override { unknown("deformation gradient"); }
  void volumeBatch(std::int32_t, double*) const override { unknown("volume"); }

 private:
  [[noreturn]] static void unknown(const char* what);

  const double* tangents_ = nullptr;
};

}  // namespace ringwatch

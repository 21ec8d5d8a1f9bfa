#pragma once
#include <cstdint>

#include <ringwatch/gpu/body/patch_operations.h>
#include <ringwatch/gpu/imex/imex_operations.h>

namespace ringwatch {

/// The launches that need an element's tangent, by element type and law, in double precision.
struct TangentOperations {
  /// K_e(X) and its highest eigenvalue for the implicit elements of a block.
  void (*restTangents)(const BlockView<double>&, const LawParameters&, const ImexElementsView&, const ImexView&,
                       cudaStream_t) = nullptr;
  /// R_e and w s_e at the displacements that launchKeepNodes kept.
  void (*rotateTangents)(const BlockView<double>&, const LawParameters&, const ImexElementsView&, const ImexView&,
                         cudaStream_t) = nullptr;
};
TangentOperations tangentOperations(ElementType type, std::size_t law);

}  // namespace ringwatch

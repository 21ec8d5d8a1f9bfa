#pragma once
#include <cstddef>

#include <ringwatch/body/patch_layout.h>

namespace ringwatch {

/// Elements that damp, as a TangentSource knows them. Its tangents are K + f C then, C the symmetric positive
/// semidefinite matrix ∂(damping force)/∂v, and f the factor of Theorem 47 (docs/theory/discrete_forces.md).
class DampedElements {
 public:
  virtual ~DampedElements() = default;
  /// f, 1/s.
  virtual double factor() const = 0;
  /// Adds factor · C(x) v of the elements of a patch into its slots; x, v: 3×N.
  virtual void addDampingProduct(std::size_t block, const Patch& patch, const double* x, const double* v, double factor,
                                 double* slots) const = 0;
};

}  // namespace ringwatch

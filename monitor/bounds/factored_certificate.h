#pragma once
#include <memory>

#include <ringwatch/body/tangent_source.h>

namespace ringwatch {

/// What a sparse factorisation takes, known from the pattern of the matrix.
struct FactorisationCost {
  double numbers;     // of the factor, below its diagonal
  double bytes;       // of factor, matrix and its ordering
  double operations;  // multiplications and additions, about
};

/// Whether sigma M - K(x) is positive definite over the free degrees of freedom, so that lambda_max(M⁻¹K) < sigma: a
/// proof without probability, by the pivots of a sparse LDLᵀ factorisation. Theorem 5,
/// docs/theory/eigenvalue_bounds.md.
///
/// With A = sigma I - M^-½ K M^-½, positive computed pivots prove A + E ≻ 0 with
/// |E| <= γ_(m+2)/(1 - γ_(m+2)) trace(A), γ_k = k u/(1 - k u), m the most entries in a row of the factor (Rump 2006,
/// for Cholesky; a third factor in each product here; Theorem 41, docs/theory/floating_point.md). So A less four times
/// that, less what the element tangents err by (Theorem 42) and less 1e-12 of the norm of the scaled tangent, is what
/// gets factored: a sigma closer to the truth than that is not certified.
///
/// Holds the assembled tangent of one state. Not for several threads at once.
class FactoredCertificate {
 public:
  /// Assembles the tangent and orders it. x: 3×N, m. Throws InputError when x is not 3×N.
  FactoredCertificate(const TangentSource& source, NodeVectorsView x);
  FactoredCertificate(FactoredCertificate&&) noexcept;
  FactoredCertificate& operator=(FactoredCertificate&&) noexcept;
  ~FactoredCertificate();

  FactorisationCost cost() const;
  /// Factors once. sigma: rad²/s². True where nothing is free and sigma > 0; false when the tangent or sigma is not
  /// finite. `false` proves nothing.
  bool certifies(double sigma);
  /// What is subtracted from sigma, rad²/s², at most: no sigma closer to the truth can be certified.
  double margin(double sigma) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace ringwatch

#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include <ringwatch/body/body.h>
#include <ringwatch/monitor/bounds.h>
#include <ringwatch/monitor/exact_step.h>

namespace ringwatch {

/// A proof of the bracket at one state, as bytes that another program can check: positions, masses, constants and rules
/// as the doubles that they are, a vector for the lower side (Theorem 8), and for the upper one the weights and
/// allowances of the block nodal bound (Theorem 1, docs/theory/eigenvalue_bounds.md), or the elements' matrices of the
/// exchange bound (Theorem 12), or sigma alone, which a factorisation proves (Theorem 5). The format is
/// docs/certificate_file.md; `ringwatch-check`, which shares no source with this library, recomputes every tangent in
/// ball arithmetic.
struct Certificate {
  UpperBound upper;  ///< lambda_max(M⁻¹K) <= upper, rad²/s²; 0: nothing is said
  LowerBound lower;  ///< and >= lower: what the vector shows; 0: nothing is said
  std::string bytes;
  std::string_view proof;  ///< of the upper side: nodal-bound, exchange-bound or factorisation
};

/// A number for what a body's certificates are about, whatever their state and order of nodes: elements, laws, rules,
/// reference positions, masses and held components. `ringwatch-check` finds the same in a file. It finds a body that
/// was taken for another one, and resists no forgery. Throws InputError as requireCertifiable.
std::uint64_t certifiedBodyHash(const Body& body);

/// Which bounds may prove the upper side: the exchange bound takes ten times as long and four times as many bytes, and
/// is tried where the nodal bound is off by more than 1 % of the step (ExchangePolicy).
enum class UpperSideBy { nodalBound, tighterOfBoth };

/// Throws InputError for elements or laws that are not the library's own and for rules of uniform strain, which no
/// certificate knows.
void requireCertifiable(const Body& body);
/// Whether the checker knows the law of a material: one of the library that is made of Lamé's constants.
bool lawHasCertificates(const Material& material);

/// That of a body at positions x (3×N, m). Throws InputError when x is not 3×N and as requireCertifiable;
/// NumericalError where the tangent is not finite, or nothing in the body is stiff and free.
Certificate makeCertificate(const Body& body, const NodeVectors& x, UpperSideBy by = UpperSideBy::nodalBound);
/// That of sides that a factorisation proved at x. Nodes are numbered anew, by reverse Cuthill-McKee, so that the
/// factor stays near the diagonal. Throws InputError when x or the mode is not 3×N and as requireCertifiable.
Certificate makeFactoredCertificate(const Body& body, const NodeVectors& x, const ProvenSides& sides);

}  // namespace ringwatch

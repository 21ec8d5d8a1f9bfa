#pragma once
#include <cstdint>
#include <filesystem>
#include <string>

#include <ringwatch/body/body.h>
#include <ringwatch/monitor/bounds.h>

namespace ringwatch {

/// A proof of both sides of the bracket at one state, as bytes that another program can check: positions, masses,
/// constants and rules as the doubles that they are, the weights and allowances of the block nodal bound (Theorem 1,
/// docs/theory/eigenvalue_bounds.md), and a vector for the other side (Theorem 8). The format is
/// docs/certificate_file.md; `ringwatch-check`, which shares no source with this library, recomputes every tangent in
/// ball arithmetic.
struct Certificate {
  UpperBound upper;  ///< lambda_max(M⁻¹K) <= upper, rad²/s²: what the weights prove
  LowerBound lower;  ///< and >= lower: what the vector shows
  std::string bytes;
};

/// Throws InputError for elements or laws that are not the library's own, which no certificate knows.
void requireCertifiable(const Body& body);

/// That of a body at positions x (3×N, m). Throws InputError when x is not 3×N and as requireCertifiable;
/// NumericalError where the tangent is not finite, or nothing in the body is stiff and free.
Certificate makeCertificate(const Body& body, const NodeVectors& x);

}  // namespace ringwatch

#pragma once
#include <memory>

#include <Eigen/Core>

#include <ringwatch/body/body.h>
#include <ringwatch/handlers/handler.h>

namespace ringwatch {

/// Added nodal masses, kg, N numbers >= 0, with which the highest eigenvalue of (M + added)⁻¹K(x) is proven to be at
/// most some lambda.
struct MassPlan {
  Eigen::VectorXd added;
  double total() const { return added.sum(); }
};

/// All of a body with such masses on its nodes.
Body withAddedMass(const Body& body, const Eigen::VectorXd& added);

/// Little added mass for a limit of lambda (rad²/s², > 0) at positions x (3×N, m), the lesser of two plans.
///
/// By nodes: from what the handler mass-scaling adds, the weights of the block nodal bound are swept again and again on
/// the masses so far, and each node gets no more than m_i + added_i >= lambda_max(Σ l_e D_e,i)/lambda asks for. Any
/// weights prove it: Theorem 40, docs/theory/handlers.md.
///
/// By modes: as long as the highest modes of the heavier body lie above lambda, each node gets m_i (μ/lambda - 1) s_i⁴
/// of that mode μ which asks most of it, s_i the node's |u_i|² over the largest one: sharply, so that little mass does.
/// A sparse factorisation proves what comes out (FactoredCertificate; Theorem 5, docs/theory/eigenvalue_bounds.md), to
/// within a millionth or less of the masses. Left out where factorisations take long or too many modes lie above.
///
/// It is not the least that there is. The body stays as it is. Throws NumericalError where the tangent is not finite.
MassPlan planAddedMass(const Body& body, const NodeVectors& x, double lambda);

/// What the usual formula of commercial codes adds for the same limit, by each element's own highest frequency ω_e on
/// its own lumped mass: m_e (ω_e²/lambda - 1) where that is positive, shared as the element's mass is. Proven by
/// Theorem 32, docs/theory/handlers.md.
MassPlan addedMassByElement(const Body& body, const NodeVectors& x, double lambda);

/// What the handler mass-scaling on `base` adds as it is prepared for steps of h (s) at x: more, since its margin
/// leaves room for elements that stiffen along the run. The body stays as it is. Throws what Handler::prepare throws.
MassPlan addedMassByHandler(const Body& body, const NodeVectors& x, std::unique_ptr<Integrator> base,
                            HandlerOptions options, double h);

}  // namespace ringwatch

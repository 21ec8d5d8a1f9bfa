#pragma once
#include <span>
#include <vector>

#include <ringwatch/body/body.h>
#include <ringwatch/meshes/cut.h>
#include <ringwatch/monitor/bounds.h>

namespace ringwatch {

/// Which elements a handler takes: flags [block][element].
using ElementFlags = std::vector<std::vector<bool>>;

/// No element chosen.
ElementFlags noElements(const Mesh& mesh);
/// The flags as a list, ascending.
std::vector<ElementRef> chosenElements(const ElementFlags& flags);

/// The elements that are not flagged.
ElementFlags complement(ElementFlags flags);
/// The flagged elements of each block, ascending: in a body made of them alone, element i of a block is the i-th.
std::vector<std::vector<std::int32_t>> elementNumbers(const ElementFlags& flags);

/// The flagged elements as a body of their own on some nodes of another one (all that they have), with a lumped mass
/// for each, kg; without loads and constraints. Blocks keep their numbers.
Body bodyOf(const Body& body, const ElementFlags& flags, std::span<const std::int32_t> nodes,
            const Eigen::VectorXd& mass);

/// The source's choice (section 3.4): the elements whose reduced 1-ring at positions x (3×N, m) has a highest
/// eigenvalue above lambda, rad²/s², (limit/h)² for a step h. Proves nothing about the rest: the ring is a lower bound.
/// lookAt: the elements to judge; others are not flagged and cost nothing. Empty: all.
/// Throws InputError unless lambda > 0.
ElementFlags selectByReducedRing(const Body& body, const NodeVectors& x, double lambda,
                                 const ElementFlags& lookAt = {});

/// A choice in a mesh before a cut, carried over to the elements that the cut left as they were; changed ones are not
/// flagged.
ElementFlags carriedOver(const CutMesh& cut, const ElementFlags& before);

/// All elements with a highest eigenvalue of M_e⁻¹K_e at positions x above lambda, rad²/s², M_e the lumped mass of the
/// element alone: the source's section 3.3.1. Proves the rest, Σ K_e ≼ lambda Σ M_e ≼ lambda M, constraints or not,
/// with more elements than it takes. Throws InputError unless lambda > 0.
ElementFlags selectBySingleElement(const Body& body, const NodeVectors& x, double lambda);

/// A set of elements without which the rest is proven stable.
struct CertifiedSelection {
  ElementFlags chosen;
  UpperBound rest;  // of the highest eigenvalue of M⁻¹ Σ K_e over the elements not chosen, rad²/s²; <= lambda
  /// Σ l_e D_e at each node over the elements not chosen, N/m: the rest's stiffness is below this block-diagonal
  /// matrix, and it below lambda M.
  std::vector<Eigen::Matrix3d> nodalSums;
};

/// The smallest set found whose removal brings the block nodal bound of the rest, on the whole lumped mass, to lambda
/// or below: with K_e ≼ l_e D_e for each remaining element and lambda_max(Σ l_e D_e) <= lambda m_i at every node i, the
/// rest is proven stable at the step limit/√lambda, for the tangent at x. Greedy: the hottest node hands over the
/// element with the largest share of it, until no node is too hot, with shapes D_e swept anew as the worst ones leave;
/// then elements that fit into the slack T_i = lambda m_i - Σ l_e D_e of their nodes, K_e ≼ diag(T_i), come back.
/// keep: elements that stay chosen whatever the bound says, e.g. those chosen so far; may be empty.
/// Throws InputError unless lambda > 0, NumericalError when the tangent is not finite.
CertifiedSelection selectCertified(const Body& body, const NodeVectors& x, double lambda,
                                   const ElementFlags& keep = {});

}  // namespace ringwatch

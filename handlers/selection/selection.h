#pragma once
#include <span>
#include <vector>

#include <ringwatch/body/body.h>
#include <ringwatch/meshes/modify/cut.h>
#include <ringwatch/monitor/bounds.h>

namespace ringwatch {

/// Which elements a handler takes: flags [block][element].
using ElementFlags = std::vector<std::vector<bool>>;

/// How the elements are selected that a handler takes.
enum class Selection {
  certified,        ///< the smallest set found such that the explicit part is proven stable
  fierzRing,        ///< those whose reduced 1-ring has too high a frequency (Fierz 2013, section 3.4); proves nothing
  elementFrequency  ///< all whose own frequency is too high (section 3.3.1): a larger set that proves the explicit part
                    ///< as well
};
inline constexpr auto selectionNames = nameTable<Selection>({
    {Selection::certified, "certified", "the fewest found without which the explicit part is proven stable"},
    {Selection::fierzRing, "fierz-ring", "those whose reduced 1-ring has too high a frequency", "reduced-1-ring"},
    {Selection::elementFrequency, "element-frequency", "those whose own frequency is too high", "single-element"},
});

/// No element chosen.
ElementFlags noElements(const Mesh& mesh);
/// The flags as a list, ascending.
std::vector<ElementRef> chosenElements(const ElementFlags& flags);

/// The elements that are not flagged.
ElementFlags complement(ElementFlags flags);
/// All of a body, as one that may be changed. For bodies made of a mesh and materials, without discrete forces.
Body copyOf(const Body& body);
/// The flagged elements of each block, ascending: in a body made of them alone, element i of a block is the i-th.
std::vector<std::vector<std::int32_t>> elementNumbers(const ElementFlags& flags);

/// The nodes that flagged elements have, as flags by node and ascending.
std::vector<bool> touchedNodes(const Body& body, const ElementFlags& elements);
std::vector<std::int32_t> nodesOf(const Body& body, const ElementFlags& elements);
/// The flagged elements as a body of their own on some nodes of another one (all that they have), with a lumped mass
/// for each, kg, and the constraints of the other; without loads. Blocks keep their numbers.
Body bodyOf(const Body& body, const ElementFlags& flags, std::span<const std::int32_t> nodes,
            const Eigen::VectorXd& mass);

/// Selection::fierzRing: the elements whose reduced 1-ring at positions x (3×N, m) has a highest
/// eigenvalue above lambda, rad²/s², (limit/h)² for a step h. Proves nothing about the explicit part: the ring is a
/// lower bound (Theorem 9, docs/theory/rings_and_rayleigh.md). candidates: the elements to evaluate; others are not
/// flagged and cost nothing. Empty: all. Throws InputError unless lambda > 0.
ElementFlags selectByReducedRing(const Body& body, const NodeVectors& x, double lambda,
                                 const ElementFlags& candidates = {});

/// The highest eigenvalue of M⁻¹K that the reduced 1-rings of some elements show, rad²/s², a lower bound of the body's;
/// NaN where the tangent is not finite. candidates: as for selectByReducedRing.
LowerBound highestReducedRing(const Body& body, const NodeVectors& x, const ElementFlags& candidates);

/// A choice in a mesh before a cut, carried over to the elements that the cut left as they were; changed ones are not
/// flagged.
ElementFlags carriedOver(const CutMesh& cut, const ElementFlags& before);

/// All elements with a highest eigenvalue of M_e⁻¹K_e at positions x above lambda, rad²/s², M_e the lumped mass of the
/// element alone: Fierz 2013, section 3.3.1. Proves the explicit part, Σ K_e ≼ lambda Σ M_e ≼ lambda M, constraints or
/// not, with more elements than it takes: Theorem 32, docs/theory/handlers.md. Throws InputError unless lambda > 0.
ElementFlags selectBySingleElement(const Body& body, const NodeVectors& x, double lambda);

}  // namespace ringwatch

#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <ringwatch/body/body.h>

namespace ringwatch {

struct IntegratorInfo;
struct RayleighDamping;

/// The elements that keep a step from being stable, as a certified selection chooses them, and those of them that only
/// their shape puts there.
struct ElementsInTheWay {
  std::vector<ElementRef> all, badlyShaped;
  std::vector<std::pair<std::string, std::size_t>> badShapes;  // of badlyShaped, by shape; most frequent first

  /// Fills badlyShaped and badShapes from `all`, by the shapes of the mesh as it is.
  void addShapes(const Mesh& mesh);
  /// "3 slivers, 1 cap"; "" where none is badly shaped.
  std::string shapesText() const;
  /// Numbers in the mesh of the first badly shaped ones: "number 7", "numbers 7, 12 and more".
  std::string badNumbersText(const Mesh& mesh) const;
};

/// Returns those of a step h (s) at positions x (3×N, m), with the room that handlers leave by default; all elements
/// where mass-proportional damping alone forbids the step. For integrators that take a handler. Throws NumericalError
/// where the state has no finite tangent.
ElementsInTheWay elementsInTheWay(const Body& body, const NodeVectors& x, const IntegratorInfo& integrator,
                                  const RayleighDamping& damping, double h);

/// Says why no handler steps a body with an integrator, "" where one does.
std::string whyNoHandlers(const Body& body, const IntegratorInfo& integrator);

/// The share of all elements up to which those in the way are few: handlers are made for these.
inline constexpr double fewInTheWay = 0.1;
/// Says what a share of all elements in the way means for handlers: "" where they are few.
std::string_view shareText(double share);

}  // namespace ringwatch

#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <ringwatch/body/body.h>
#include <ringwatch/monitor/step_limit.h>

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
};

/// The numbers that the first few elements have in the mesh: "number 7", "numbers 7, 12 and more".
std::string numbersText(const std::vector<ElementRef>& elements, const Mesh& mesh);

/// Returns those of a step h (s) at positions x (3×N, m), with the room that handlers leave by default; all elements
/// where mass-proportional damping alone forbids the step. For integrators that take a handler. Throws NumericalError
/// where the state has no finite tangent.
ElementsInTheWay elementsInTheWay(const Body& body, const NodeVectors& x, const IntegratorInfo& integrator,
                                  const RayleighDamping& damping, double h);

/// The step that a body at positions x (3×N, m) is proven for without some elements, on the whole mass: what a mesh
/// without them would allow at least. For bodies that take a handler.
double safeWithout(const Body& body, NodeVectorsView x, const StepRule& rule, const std::vector<ElementRef>& left);

/// The share of all elements up to which those in the way are few: handlers are made for these.
inline constexpr double fewInTheWay = 0.1;
/// Says what a share of all elements in the way means for handlers: "" where they are few.
std::string_view shareText(double share);

}  // namespace ringwatch

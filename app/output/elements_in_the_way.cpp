#include <ringwatch/app/output/elements_in_the_way.h>

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include <ringwatch/handlers/handler.h>
#include <ringwatch/handlers/selection/certified_selection.h>
#include <ringwatch/meshes/quality.h>
#include <ringwatch/monitor/critical_step.h>

namespace ringwatch {

std::string ElementsInTheWay::shapesText() const {
  std::string text;
  for (const auto& [shape, count] : badShapes)
    text += fmt::format("{}{} {}{}", text.empty() ? "" : ", ", count, shape, count == 1 ? "" : "s");
  return text;
}

std::string numbersText(const std::vector<ElementRef>& elements, const Mesh& mesh) {
  constexpr std::size_t most = 12;  // fills a line
  std::vector<std::int64_t> ids;
  for (const ElementRef e : elements)
    if (ids.size() < most) ids.push_back(mesh.blocks[e.block].id(e.element));
  return fmt::format("number{} {}{}", elements.size() == 1 ? "" : "s", fmt::join(ids, ", "),
                     elements.size() > most ? " and more" : "");
}

void ElementsInTheWay::addShapes(const Mesh& mesh) {
  std::map<ShapeClass, std::size_t> counts;
  for (const ElementRef e : all) {
    // Without a mean volume none is called small, which is no bad shape.
    const ShapeClass shape = elementShape(mesh.blocks[e.block], e.element, mesh.X, 0).shape;
    if (shape == ShapeClass::round || shape == ShapeClass::small || shape == ShapeClass::other) continue;
    ++counts[shape];
    badlyShaped.push_back(e);
  }
  for (const auto& [shape, count] : counts) badShapes.emplace_back(shapeName(shape), count);
  std::stable_sort(badShapes.begin(), badShapes.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
}

ElementsInTheWay elementsInTheWay(const Body& body, const NodeVectors& x, const IntegratorInfo& integrator,
                                  const RayleighDamping& damping, double h) {
  ElementsInTheWay found;
  found.all =
      0.5 * h * damping.alpha < 1
          ? chosenElements(
                selectCertified(body, x, largestEigenvalueFor(h, defaultMargin, integrator.imaginaryLimit, damping))
                    .chosen)
          : chosenElements(complement(noElements(body.mesh())));
  found.addShapes(body.mesh());
  return found;
}

double safeWithout(const Body& body, NodeVectorsView x, const StepRule& rule, const std::vector<ElementRef>& left) {
  ElementFlags flags = noElements(body.mesh());
  for (const ElementRef e : left) flags[e.block][e.element] = true;
  return criticalStep(Body(body, complement(std::move(flags))), x, rule).safe;
}

std::string_view shareText(double share) {
  constexpr double most = 0.5;  // the larger part of the body: what stays explicit saves less than it
  return share <= fewInTheWay ? ""
         : share <= most      ? "; these are not few: ringwatch advise measures whether a handler pays"
                              : "; this is most of the body, where a handler does not pay: take a smaller step, or an "
                                "implicit integrator for the whole";
}

}  // namespace ringwatch

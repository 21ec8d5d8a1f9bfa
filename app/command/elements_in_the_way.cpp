#include <ringwatch/app/command/elements_in_the_way.h>

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include <ringwatch/handlers/handler.h>
#include <ringwatch/handlers/selection/certified_selection.h>
#include <ringwatch/meshes/quality.h>

namespace ringwatch {

std::string ElementsInTheWay::shapesText() const {
  std::string text;
  for (const auto& [shape, count] : badShapes)
    text += fmt::format("{}{} {}{}", text.empty() ? "" : ", ", count, shape, count == 1 ? "" : "s");
  return text;
}

std::string ElementsInTheWay::badNumbersText(const Mesh& mesh) const {
  constexpr std::size_t most = 12;  // fills a line
  std::vector<std::int64_t> ids;
  for (const ElementRef e : badlyShaped)
    if (ids.size() < most) ids.push_back(mesh.blocks[e.block].id(e.element));
  return fmt::format("number{} {}{}", badlyShaped.size() == 1 ? "" : "s", fmt::join(ids, ", "),
                     badlyShaped.size() > most ? " and more" : "");
}

ElementsInTheWay elementsInTheWay(const Body& body, const NodeVectors& x, const IntegratorInfo& integrator, double h) {
  const double omega = (1 - HandlerOptions{}.margin) * integrator.imaginaryLimit / h;
  const Mesh& mesh = body.mesh();
  const double meanVolume = std::abs(meshVolume(mesh)) / static_cast<double>(mesh.elementCount());
  ElementsInTheWay found;
  found.all = chosenElements(selectCertified(body, x, omega * omega).chosen);
  std::map<ShapeClass, std::size_t> counts;
  for (const ElementRef e : found.all) {
    const ShapeClass shape = elementShape(mesh.blocks[e.block], e.element, mesh.X, meanVolume).shape;
    if (shape == ShapeClass::round || shape == ShapeClass::small || shape == ShapeClass::other) continue;
    ++counts[shape];
    found.badlyShaped.push_back(e);
  }
  for (const auto& [shape, count] : counts) found.badShapes.emplace_back(shapeName(shape), count);
  std::stable_sort(found.badShapes.begin(), found.badShapes.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  return found;
}

}  // namespace ringwatch

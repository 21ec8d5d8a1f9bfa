#include <ringwatch/elements/registry.h>

#include <array>

namespace ringwatch {
namespace {

template <class E>
ElementInfo describe() {
  return {elementTypeOf<E>,
          E::name,
          E::nodes,
          E::order,
          E::vtkCellType,
          E::gmshType,
          E::referenceVolume,
          E::constantGradient,
          E::positiveRowSums,
          E::referenceNodes,
          E::faces,
          E::edges,
          E::rules,
          E::massRule,
          [](const double xi[3], double* N) { E::shape(xi, N); },
          [](const double xi[3], double(*dN)[3]) { E::shapeGradient(xi, dN); }};
}

template <class... Es>
std::array<ElementInfo, sizeof...(Es)> describeAll(TypeList<Es...>) {
  return {describe<Es>()...};
}

template <class Predicate>
const ElementInfo* findElement(Predicate matches) {
  for (const ElementInfo& element : allElements())
    if (matches(element)) return &element;
  return nullptr;
}

}  // namespace

std::span<const ElementInfo> allElements() {
  static const auto table = describeAll(Elements{});
  return table;
}
const ElementInfo& elementInfo(ElementType type) { return allElements()[static_cast<std::size_t>(type)]; }
const ElementInfo* findElementByName(std::string_view name) {
  return findElement([&](const ElementInfo& e) { return e.name == name; });
}
const ElementInfo* findElementByVtkType(int vtkCellType) {
  return findElement([&](const ElementInfo& e) { return e.vtkCellType == vtkCellType; });
}
const ElementInfo* findElementByGmshType(int gmshType) {
  return findElement([&](const ElementInfo& e) { return e.gmshType == gmshType; });
}
const QuadratureRule* findRule(const ElementInfo& element, std::string_view name) {
  for (const QuadratureRule& rule : element.rules)
    if (name.empty() || rule.name == name) return &rule;
  return nullptr;
}

}  // namespace ringwatch

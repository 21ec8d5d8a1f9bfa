#include <ringwatch/elements/registry.h>

#include <limits>
#include <set>
#include <vector>

#include <ringwatch/base/registry.h>

namespace ringwatch {
namespace {

template <class... Es>
std::vector<ElementInfo> describeAll(TypeList<Es...>) {
  return {elementInfoOf<Es>(elementTypeOf<Es>)...};
}

Registry<ElementInfo>& registry() {
  static Registry<ElementInfo> elements("element", describeAll(Elements{}));
  return elements;
}

template <class Predicate>
const ElementInfo* findElement(Predicate matches) {
  for (const ElementInfo& element : allElements())
    if (matches(element)) return &element;
  return nullptr;
}

std::size_t cornersOf(const ElementInfo& info) {
  std::set<int> corners;
  for (const auto& face : info.faces)
    for (const int corner : face)
      if (corner >= 0) corners.insert(corner);
  return corners.size();
}

/// Why an element cannot be registered; "" when it can.
std::string faultOf(const ElementInfo& info) {
  constexpr std::size_t mostElements = std::numeric_limits<std::uint8_t>::max();  // ElementType's
  if (info.nodes > maxElementNodes)
    return joinText("has ", info.nodes, " nodes; at most ", maxElementNodes, " are possible");
  if (info.order != 1 && info.order != 2) return joinText("has the order ", info.order, "; it must be 1 or 2");
  const std::size_t corners = cornersOf(info), expected = corners + (info.order == 2 ? info.edges.size() : 0);
  if (static_cast<std::size_t>(info.nodes) != expected)
    return joinText("has ", info.nodes, " nodes; an element of order ", info.order, " with ", corners, " corners and ",
                    info.edges.size(), " edges must have ", expected);
  if (info.referenceNodes.size() != expected || (!info.gmshOrder.empty() && info.gmshOrder.size() != expected))
    return joinText("has ", info.referenceNodes.size(), " reference nodes and ", info.gmshOrder.size(),
                    " nodes in gmsh's order; there must be ", expected);
  if (info.rules.empty()) return "has no quadrature rule";
  if (info.cellSplits.empty()) return "has no way to fill a cell (cellSplits)";
  if (const ElementInfo* same = findElementByVtkType(info.vtkCellType))
    return joinText("has the VTK cell type ", info.vtkCellType, " of ", same->name);
  if (const ElementInfo* same = findElementByGmshType(info.gmshType))
    return joinText("has the gmsh type ", info.gmshType, " of ", same->name);
  if (allElements().size() >= mostElements) return joinText("is one more than ", mostElements);
  return {};
}

}  // namespace

std::span<const ElementInfo> allElements() { return registry().all(); }
const ElementInfo& elementInfo(ElementType type) { return allElements()[static_cast<std::size_t>(type)]; }
const ElementInfo* findElementByName(std::string_view name) { return registry().find(name); }
const ElementInfo* findElementByVtkType(int vtkCellType) {
  return findElement([&](const ElementInfo& e) { return vtkCellType > 0 && e.vtkCellType == vtkCellType; });
}
const ElementInfo* findElementByGmshType(int gmshType) {
  return findElement([&](const ElementInfo& e) { return gmshType > 0 && e.gmshType == gmshType; });
}
const QuadratureRule* findRule(const ElementInfo& element, std::string_view name) {
  for (const QuadratureRule& rule : element.rules)
    if (name.empty() || rule.name == name || rule.alias == name) return &rule;
  return nullptr;
}

ElementType detail::registerElement(ElementInfo info) {
  if (const std::string fault = faultOf(info); !fault.empty())
    throw InputError(joinText("element \"", info.name, "\": it ", fault));
  info.type = static_cast<ElementType>(allElements().size());
  registry().add(info);
  return info.type;
}

}  // namespace ringwatch

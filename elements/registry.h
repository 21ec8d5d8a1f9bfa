#pragma once
#include <cstdint>
#include <span>
#include <string_view>

#include <ringwatch/base/type_list.h>
#include <ringwatch/elements/hex20.h>
#include <ringwatch/elements/hex8.h>
#include <ringwatch/elements/pyramid5.h>
#include <ringwatch/elements/tet10.h>
#include <ringwatch/elements/tet4.h>
#include <ringwatch/elements/wedge6.h>

namespace ringwatch {

/// Every element of the library, one line each. Blocks, readers, writers, studies and generic tests iterate this list.
using Elements = TypeList<Tet4, Hex8, Wedge6, Pyramid5, Tet10, Hex20>;

/// Position of an element in `Elements`.
enum class ElementType : std::uint8_t {};

namespace detail {
template <class E, class... Es>
constexpr ElementType elementTypeOf(TypeList<Es...>) {
  std::uint8_t i = 0, found = 255;
  ((std::is_same_v<E, Es> ? void(found = i) : void(), ++i), ...);
  return ElementType{found};
}
}  // namespace detail
template <class E>
inline constexpr ElementType elementTypeOf = detail::elementTypeOf<E>(Elements{});

namespace detail {
template <class... Es>
constexpr int mostNodes(TypeList<Es...>) {
  int most = 0;
  ((most = Es::nodes > most ? Es::nodes : most), ...);
  return most;
}
}  // namespace detail
/// Nodes of the largest element, for arrays on the stack.
inline constexpr int maxElementNodes = detail::mostNodes(Elements{});

/// What code that does not know an element at compile time needs of it.
struct ElementInfo {
  ElementType type;
  std::string_view name;
  int nodes;
  int order;
  int vtkCellType;
  int gmshType;
  double referenceVolume;
  bool constantGradient;
  bool positiveRowSums;
  std::span<const std::array<double, 3>> referenceNodes;
  std::span<const std::array<int, 4>> faces;  // corner nodes
  std::span<const std::array<int, 2>>
      edges;  // corner nodes; in a quadratic element the middle of edges[i] is node corners + i
  std::span<const QuadratureRule> rules;  // the first is the default
  QuadratureRule massRule;
  void (*shape)(const double xi[3], double* N);                // N[nodes]
  void (*shapeGradient)(const double xi[3], double (*dN)[3]);  // dN[nodes][3]
};

/// Corners of an element; the nodes beyond them are the middles of its edges.
inline int cornerCount(const ElementInfo& element) {
  return element.order == 1 ? element.nodes : element.nodes - static_cast<int>(element.edges.size());
}

/// All elements, in the order of `ElementType`.
std::span<const ElementInfo> allElements();
const ElementInfo& elementInfo(ElementType type);
/// nullptr when there is no such element.
const ElementInfo* findElementByName(std::string_view name);
const ElementInfo* findElementByVtkType(int vtkCellType);
const ElementInfo* findElementByGmshType(int gmshType);
/// The rule of that name; "" is the default. nullptr when the element has none of that name.
const QuadratureRule* findRule(const ElementInfo& element, std::string_view name);

/// Calls visit(TypeTag<Element>{}) for the element of that type.
template <class Visit>
void visitElement(ElementType type, Visit&& visit) {
  forEachType(Elements{}, [&](auto tag) {
    if (elementTypeOf<typename decltype(tag)::type> == type) visit(tag);
  });
}

}  // namespace ringwatch

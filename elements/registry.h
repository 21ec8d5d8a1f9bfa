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

/// Every element of the library, one line each. What is compiled for all of them iterates this list; readers, writers,
/// generators and studies iterate allElements(), which also has those that a program registers.
using Elements = TypeList<Tet4, Hex8, Wedge6, Pyramid5, Tet10, Hex20>;

/// Position of an element in allElements().
enum class ElementType : std::uint8_t {};

namespace detail {
template <class E, class... Es>
constexpr ElementType elementTypeOf(TypeList<Es...>) {
  static_assert((std::is_same_v<E, Es> || ...), "a registered element is found by its name");
  std::uint8_t i = 0, found = 0;
  ((std::is_same_v<E, Es> ? void(found = i) : void(), ++i), ...);
  return ElementType{found};
}
}  // namespace detail
/// The number of an element of the library.
template <class E>
inline constexpr ElementType elementTypeOf = detail::elementTypeOf<E>(Elements{});
/// Whether the element is one of `Elements`, which GPUs need, and not one that was registered.
constexpr bool isOfLibrary(ElementType type) { return static_cast<std::size_t>(type) < Elements::size; }

namespace detail {
template <class... Es>
constexpr int mostNodes(TypeList<Es...>) {
  int most = 0;
  ((most = Es::nodes > most ? Es::nodes : most), ...);
  return most;
}
}  // namespace detail
/// Nodes of the largest element, for arrays on the stack. A registered element has no more.
inline constexpr int maxElementNodes = detail::mostNodes(Elements{});

/// What code that does not know an element at compile time needs of it.
struct ElementInfo {
  ElementType type;
  std::string_view name;
  int nodes;
  int order;
  int vtkCellType;  // 0: VTK has none
  int gmshType;     // 0: gmsh has none
  double referenceVolume;
  bool constantGradient;
  bool positiveRowSums;
  std::span<const std::array<double, 3>> referenceNodes;
  std::span<const std::array<int, 4>> faces;  // corner nodes
  std::span<const std::array<int, 2>>
      edges;  // corner nodes; in a quadratic element the middle of edges[i] is node corners + i
  std::span<const std::uint8_t> gmshOrder;  // node i is node gmshOrder[i] of gmsh's element; empty: the orders agree
  std::span<const CellSubdivision> cellSplits;  // ways to fill a box-shaped cell, the usual one first
  std::span<const QuadratureRule> rules;        // the first is the default
  QuadratureRule massRule;
  void (*shape)(const double xi[3], double* N);                // N[nodes]
  void (*shapeGradient)(const double xi[3], double (*dN)[3]);  // dN[nodes][3]
};

/// What an element as in this folder declares; what it does not (gmshOrder) has the usual value.
template <class E>
ElementInfo elementInfoOf(ElementType type) {
  ElementInfo info{.type = type,
                   .name = E::name,
                   .nodes = E::nodes,
                   .order = E::order,
                   .vtkCellType = E::vtkCellType,
                   .gmshType = E::gmshType,
                   .referenceVolume = E::referenceVolume,
                   .constantGradient = E::constantGradient,
                   .positiveRowSums = E::positiveRowSums,
                   .referenceNodes = E::referenceNodes,
                   .faces = E::faces,
                   .edges = E::edges,
                   .gmshOrder = {},
                   .cellSplits = E::cellSplits,
                   .rules = E::rules,
                   .massRule = E::massRule,
                   .shape = [](const double xi[3], double* N) { E::shape(xi, N); },
                   .shapeGradient = [](const double xi[3], double(*dN)[3]) { E::shapeGradient(xi, dN); }};
  if constexpr (requires { E::gmshOrder; }) info.gmshOrder = E::gmshOrder;
  return info;
}

/// Corners of an element; the nodes beyond them are the middles of its edges.
inline int cornerCount(const ElementInfo& element) {
  return element.order == 1 ? element.nodes : element.nodes - static_cast<int>(element.edges.size());
}

/// All elements, in the order of `ElementType`: those of the library, then those that a program has registered.
std::span<const ElementInfo> allElements();
const ElementInfo& elementInfo(ElementType type);
/// nullptr when there is no such element.
const ElementInfo* findElementByName(std::string_view name);
const ElementInfo* findElementByVtkType(int vtkCellType);
const ElementInfo* findElementByGmshType(int gmshType);
/// The rule of that name; "" is the default. nullptr when the element has none of that name.
const QuadratureRule* findRule(const ElementInfo& element, std::string_view name);
namespace detail {
/// Makes an element known, at the end of the list; body/register_element.h makes its blocks known too. Sets the type.
/// Throws InputError when the name or a number of a file format is taken, for more than maxElementNodes nodes, for
/// nodes that are neither corners nor middles of edges, and for an element that fills no cell.
ElementType registerElement(ElementInfo info);
}  // namespace detail

/// Calls visit(TypeTag<Element>{}) for the element of that type, when it is of the library.
template <class Visit>
void visitElement(ElementType type, Visit&& visit) {
  forEachType(Elements{}, [&](auto tag) {
    if (elementTypeOf<typename decltype(tag)::type> == type) visit(tag);
  });
}

}  // namespace ringwatch

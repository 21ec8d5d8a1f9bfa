#pragma once
#include <cstddef>

namespace ringwatch {

/// An explicit list of types; the registries of elements and laws are such lists.
template <class... Types>
struct TypeList {
  static constexpr std::size_t size = sizeof...(Types);
};

template <class T>
struct TypeTag {
  using type = T;
};

/// Calls visit(TypeTag<T>{}) for every T of the list, in order.
template <class... Types, class Visit>
constexpr void forEachType(TypeList<Types...>, Visit&& visit) {
  (visit(TypeTag<Types>{}), ...);
}

}  // namespace ringwatch

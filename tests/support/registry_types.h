#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>

#include <ringwatch/base/type_list.h>

namespace ringwatch::test {

/// A registry's list of types as the parameter of a typed test suite: what is registered is tested.
template <class List>
struct TestTypes;
template <class... Types>
struct TestTypes<TypeList<Types...>> {
  using type = ::testing::Types<Types...>;
};
template <class List>
using TestTypesOf = typename TestTypes<List>::type;

/// A name that GoogleTest accepts: letters and digits stay, the rest becomes '_'.
inline std::string testName(std::string_view name) {
  std::string result(name);
  std::replace_if(
      result.begin(), result.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
  return result;
}
struct RegistryNames {
  template <class T>
  static std::string GetName(int) {
    return testName(T::name);
  }
};

}  // namespace ringwatch::test

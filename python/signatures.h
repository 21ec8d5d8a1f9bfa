#pragma once
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include <pybind11/pybind11.h>

namespace ringwatch::python {

namespace py = pybind11;

inline std::string parameterText(const py::arg& argument) { return argument.name; }
inline std::string parameterText(const py::arg_v& argument) {
  return std::string(argument.name) + "=" + py::repr(argument.value).cast<std::string>();
}
inline std::string parameterText(const py::kw_only&) { return "*"; }
inline std::string parameterText(const py::pos_only&) { return "/"; }

/// A docstring that begins with a signature in the form from which Python's `help` and `inspect` read one.
/// first: what stands before the arguments, "$self" of a method; rest: what stands behind them, "**parameters".
template <class... Arguments>
std::string signedText(std::string_view name, std::string_view first, std::string_view text, std::string_view rest,
                       const Arguments&... arguments) {
  std::string list(first);
  const auto add = [&](std::string_view parameter) {
    if (!list.empty() && !parameter.empty()) list += ", ";
    list += parameter;
  };
  (add(parameterText(arguments)), ...);
  add(rest);
  return std::string(name) + "(" + list + ")\n--\n\n" + std::string(text);
}

/// Binds a function of the module; rest as in signedText.
template <class Function, class... Arguments>
void bindFunction(py::module_& module, const char* name, const Function& function, std::string_view text,
                  std::string_view rest, const Arguments&... arguments) {
  module.def(name, function, signedText(name, "", text, rest, arguments...).c_str(), arguments...);
}

/// Binds a class with its constructor.
template <class Class, class Init, class... Arguments>
Class bindClass(py::module_& module, const char* name, Init&& constructor, std::string_view text, std::string_view rest,
                const Arguments&... arguments) {
  Class bound(module, name, signedText(name, "", text, rest, arguments...).c_str());
  bound.def(std::forward<Init>(constructor), signedText("__init__", "self", text, rest, arguments...).c_str(),
            arguments...);
  return bound;
}

/// Binds a method.
template <class Class, class Function, class... Arguments>
void bindMethod(Class& bound, const char* name, const Function& function, std::string_view text,
                const Arguments&... arguments) {
  bound.def(name, function, signedText(name, "$self", text, "", arguments...).c_str(), arguments...);
}

}  // namespace ringwatch::python

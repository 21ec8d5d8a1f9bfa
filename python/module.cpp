// The extension _ringwatch, over which the package ringwatch is a thin layer.
#include <ringwatch/base/error.h>
#include <ringwatch/python/held.h>

namespace {

namespace py = pybind11;

/// Throws the package's exception of that name with the same line.
void raise(const char* name, const char* line) {
  const py::object type = py::module_::import("ringwatch._errors").attr(name);
  PyErr_SetString(type.ptr(), line);
}

}  // namespace

PYBIND11_MODULE(_ringwatch, module) {
  py::options options;
  options.disable_function_signatures();  // they stand in _ringwatch.pyi
  // NOLINTNEXTLINE(performance-unnecessary-value-param): pybind11 takes a function of this type.
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const ringwatch::InputError& error) {
      raise("InputError", error.what());
    } catch (const ringwatch::NumericalError& error) {
      raise("NumericalError", error.what());
    }
  });
  module.attr("__version__") = RINGWATCH_VERSION;
  ringwatch::python::bindMesh(module);
  ringwatch::python::bindBody(module);
  ringwatch::python::bindInspect(module);
  ringwatch::python::bindMonitor(module);
  ringwatch::python::bindTangentBracket(module);
}

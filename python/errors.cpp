#include <ringwatch/python/errors.h>

#include <pybind11/pybind11.h>

#include <ringwatch/base/error.h>
#include <ringwatch/base/units.h>

namespace ringwatch::python {
namespace {

namespace py = pybind11;

/// Throws the package's exception of that name with the same line.
void raise(const char* name, const char* line) {
  const py::object type = py::module_::import("ringwatch._errors").attr(name);
  PyErr_SetString(type.ptr(), labelled(line).c_str());
}

}  // namespace

void translateErrors() {
  // NOLINTNEXTLINE(performance-unnecessary-value-param): pybind11 takes a function of this type.
  py::register_local_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const InputError& error) {
      raise("InputError", error.what());
    } catch (const NumericalError& error) {
      raise("NumericalError", error.what());
    }
  });
}

}  // namespace ringwatch::python

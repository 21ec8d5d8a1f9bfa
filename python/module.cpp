// The extension _ringwatch, over which the package ringwatch is a thin layer.
#include <ringwatch/base/units.h>
#include <ringwatch/python/errors.h>
#include <ringwatch/python/held.h>
#include <ringwatch/python/signatures.h>

PYBIND11_MODULE(_ringwatch, module) {
  pybind11::options options;
  options.disable_function_signatures();  // docstrings begin with those that Python reads, see signatures.h
  ringwatch::python::translateErrors();
  module.attr("__version__") = RINGWATCH_VERSION;
  ringwatch::python::bindMesh(module);
  ringwatch::python::bindBody(module);
  ringwatch::python::bindInspect(module);
  ringwatch::python::bindMonitor(module);
  ringwatch::python::bindTangentBracket(module);
  ringwatch::python::bindFunction(
      module, "use_units",
      [](const std::string& system) { ringwatch::useUnits(ringwatch::unitSystems.valueOf("system", system)); },
      "Chooses the units that texts and pictures name: SI (as at first), mm-t-s, mm-kg-ms, cm-g-us or none. No number "
      "is "
      "converted. Raises InputError.",
      "", pybind11::arg("system"));
  module.def("_used_units", [] { return std::string(ringwatch::unitSystems.nameOf(ringwatch::usedUnits())); });
  module.def("_labelled", [](const std::string& text) { return ringwatch::labelled(text); });
}

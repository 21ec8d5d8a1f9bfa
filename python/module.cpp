// The extension _ringwatch, over which the package ringwatch is a thin layer.
#include <ringwatch/python/errors.h>
#include <ringwatch/python/held.h>

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
}

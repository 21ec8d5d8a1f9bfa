#include <ringwatch/python/arrays.h>

#include <algorithm>

#include <ringwatch/base/error.h>

namespace ringwatch::python {

std::string shapeText(const std::vector<py::ssize_t>& shape) {
  std::string text = "(";
  for (const py::ssize_t size : shape) {
    if (text.size() > 1) text += ", ";
    text += size < 0 ? std::string("any") : std::to_string(size);
  }
  return text + (shape.size() == 1 ? ",)" : ")");
}

std::string describe(py::handle given) {
  if (!py::isinstance<py::array>(given))
    return joinText("an object of type ", std::string(py::str(py::type::handle_of(given).attr("__name__"))));
  const auto array = py::reinterpret_borrow<py::array>(given);
  const std::vector<py::ssize_t> shape(array.shape(), array.shape() + array.ndim());
  return joinText("an array of ", std::string(py::str(array.dtype())), " of shape ", shapeText(shape),
                  array.flags() & py::array::c_style ? " in C order" : " not in C order");
}

std::span<const double> realsOf(const char* name, py::handle given, const std::vector<py::ssize_t>& shape) {
  using Reals = py::array_t<double, py::array::c_style>;
  if (py::isinstance<Reals>(given)) {
    const auto array = py::reinterpret_borrow<py::array>(given);
    const bool aligned = array.flags() & py::detail::npy_api::NPY_ARRAY_ALIGNED_;
    const bool fits = array.ndim() == static_cast<py::ssize_t>(shape.size()) &&
                      std::equal(shape.begin(), shape.end(), array.shape(),
                                 [](py::ssize_t wanted, py::ssize_t is) { return wanted < 0 || wanted == is; });
    if (fits && aligned) return {static_cast<const double*>(array.data()), static_cast<std::size_t>(array.size())};
    if (fits)
      throw InputError(joinText(name, ": float64 numbers that are not aligned in memory; pass ", name, ".copy()"));
  }
  throw InputError(joinText(name, ": ", describe(given), "; must be an array of float64 of shape ", shapeText(shape),
                            " in C order, as numpy.ascontiguousarray(", name, ", dtype=numpy.float64) makes one"));
}

NodeVectorsView nodalOf(const char* name, py::handle given, Eigen::Index nodes) {
  // What realsOf asks for, without making a list of the shape: this is on the way of every step.
  if (py::isinstance<py::array_t<double, py::array::c_style>>(given)) {
    const auto array = py::reinterpret_borrow<py::array>(given);
    if (array.ndim() == 2 && array.shape(0) == nodes && array.shape(1) == 3 &&
        (array.flags() & py::detail::npy_api::NPY_ARRAY_ALIGNED_))
      return {static_cast<const double*>(array.data()), nodes};
  }
  return {realsOf(name, given, {nodes, 3}).data(), nodes};
}

py::object listAsArray(py::handle given) {
  if (py::isinstance<py::sequence>(given) && !py::isinstance<py::array>(given) && !py::isinstance<py::str>(given)) {
    if (const auto array = py::array::ensure(given)) return array;
    PyErr_Clear();  // of rows of different lengths: the caller says what is right
  }
  return py::reinterpret_borrow<py::object>(given);
}

std::vector<std::int64_t> integersOf(const char* name, py::handle listed, py::ssize_t dimensions) {
  const py::object given = listAsArray(listed);
  const auto refuse = [&](const std::string& what) {
    throw InputError(joinText(name, ": ", what, "; must be an array or a list of whole numbers, of ", dimensions,
                              " dimension", dimensions == 1 ? "" : "s"));
  };
  if (!py::isinstance<py::array>(given)) refuse(describe(given));
  const auto array = py::reinterpret_borrow<py::array>(given);
  const char kind = array.dtype().kind();
  if (array.size() == 0 && array.ndim() == dimensions) return {};  // numpy makes floats of an empty list
  if ((kind != 'i' && kind != 'u') || array.ndim() != dimensions) refuse(describe(given));
  const auto wide = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>::ensure(array);
  if (!wide) throw py::error_already_set();
  return {wide.data(), wide.data() + wide.size()};
}

std::vector<std::int32_t> indicesOf(const char* name, py::handle given, py::ssize_t dimensions, std::int64_t end) {
  const std::vector<std::int64_t> values = integersOf(name, given, dimensions);
  std::vector<std::int32_t> indices;
  indices.reserve(values.size());
  for (const std::int64_t value : values) {
    if (value < 0 || value >= end)
      throw InputError(joinText(name, ": ", value, " is out of range; must be 0 to ", end - 1));
    indices.push_back(static_cast<std::int32_t>(value));
  }
  return indices;
}

py::array ownedArray(NodeVectors&& vectors) {
  auto held = std::make_unique<NodeVectors>(std::move(vectors));
  const double* data = held->data();
  const py::ssize_t nodes = held->cols();
  py::capsule owner(held.get(), [](void* p) { delete static_cast<NodeVectors*>(p); });
  static_cast<void>(held.release());  // the capsule deletes it
  return py::array_t<double>({nodes, py::ssize_t{3}}, data, owner);
}

}  // namespace ringwatch::python

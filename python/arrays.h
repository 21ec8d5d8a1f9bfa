#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>

#include <ringwatch/meshes/mesh.h>

namespace ringwatch::python {

namespace py = pybind11;

/// "a float32 array of shape (8, 3) in C order", "a list": what was given in place of what is wanted.
std::string describe(py::handle given);
/// "(8, 3)"; -1 stands for any number.
std::string shapeText(const std::vector<py::ssize_t>& shape);

/// The numbers of a float64 array in C order of a shape, where -1 stands for any number, as they lie. Throws InputError
/// that names the argument, what was given and what would be right.
std::span<const double> realsOf(const char* name, py::handle given, const std::vector<py::ssize_t>& shape);

/// Node vectors of an (N, 3) array of float64 in C order, which is 3×N as they are here: nothing is copied. Throws as
/// realsOf.
NodeVectorsView nodalOf(const char* name, py::handle given, Eigen::Index nodes);

/// Makes an array of a list, a tuple or another sequence; returns anything else as it is.
py::object listAsArray(py::handle given);

/// The numbers of an array or list of whole numbers of any type and of `dimensions` dimensions. Throws InputError for
/// another type or dimension.
std::vector<std::int64_t> integersOf(const char* name, py::handle given, py::ssize_t dimensions);

/// Indices of an array or list of whole numbers of any type and of `dimensions` dimensions, copied. Throws InputError
/// for another type or dimension and for a number outside [0, end).
std::vector<std::int32_t> indicesOf(const char* name, py::handle given, py::ssize_t dimensions, std::int64_t end);

/// An (N, 3) array that owns the vectors: they are moved, not copied.
py::array ownedArray(NodeVectors&& vectors);

/// An array that owns its numbers, which are moved into it.
template <class T>
py::array_t<T> ownedArray(std::vector<T>&& values, std::vector<py::ssize_t> shape) {
  auto held = std::make_unique<std::vector<T>>(std::move(values));
  const T* data = held->data();
  py::capsule owner(held.get(), [](void* p) { delete static_cast<std::vector<T>*>(p); });
  static_cast<void>(held.release());  // the capsule deletes it
  return py::array_t<T>(std::move(shape), data, owner);
}
template <class T>
py::array_t<T> ownedArray(std::vector<T>&& values) {
  const auto size = static_cast<py::ssize_t>(values.size());
  return ownedArray(std::move(values), {size});
}

/// An array of numbers that `owner` holds; read-only.
template <class T>
py::array_t<T> viewOf(const T* data, std::vector<py::ssize_t> shape, py::handle owner) {
  py::array_t<T> view(std::move(shape), data, owner);
  py::detail::array_proxy(view.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return view;
}

}  // namespace ringwatch::python

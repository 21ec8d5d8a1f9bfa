#include <ringwatch/python/results.h>

#include <stdexcept>

#include <ringwatch/base/error.h>
#include <ringwatch/base/units.h>

namespace ringwatch::python {

ResultType::ResultType(const char* name, std::size_t fields)
    : type_(py::module_::import("ringwatch._results").attr(name)) {
  for (const auto& field : py::reinterpret_borrow<py::dict>(type_.attr("__dataclass_fields__"))) {
    PyObject* interned = PyUnicode_InternFromString(py::str(field.first).cast<std::string>().c_str());
    if (!interned) throw py::error_already_set();
    names_.push_back(py::reinterpret_steal<py::object>(interned));
  }
  if (names_.size() != fields)
    throw std::logic_error(joinText("ringwatch._results.", name, " has ", names_.size(), " fields, not ", fields));
}

py::object ResultType::fill(std::span<py::object> values) const {
  static PyObject* const nothing = PyTuple_New(0);
  auto made = py::reinterpret_steal<py::object>(
      PyBaseObject_Type.tp_new(reinterpret_cast<PyTypeObject*>(type_.ptr()), nothing, nullptr));
  if (!made) throw py::error_already_set();
  for (std::size_t i = 0; i < values.size(); ++i)
    if (PyObject_GenericSetAttr(made.ptr(), names_[i].ptr(), values[i].ptr()) != 0) throw py::error_already_set();
  return made;
}

namespace {

template <class Number>
py::object tupleOf(std::span<const Number> numbers) {
  py::tuple tuple(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) tuple[i] = integer(numbers[i]);
  return tuple;
}

}  // namespace

// The types live as long as the interpreter: Python objects cannot be destroyed after it.
py::object elementResult(const Mesh& mesh, ElementRef ref) {
  static const ResultType& type = *new ResultType("Element", 7);
  const MeshBlock& block = mesh.blocks[ref.block];
  const std::span<const std::int32_t> nodes(block.element(ref.element), block.nodesPerElement());
  std::vector<std::int64_t> ids;
  for (const std::int32_t node : nodes) ids.push_back(mesh.nodeId(node));
  return type(integer(ref.block), integer(ref.element), text(elementInfo(block.type).name), tupleOf(nodes),
              integer(block.id(ref.element)), tupleOf(std::span<const std::int64_t>(ids)),
              text(elementText(mesh, ref)));
}

py::object causeResult(const ElementCause& cause) {
  static const ResultType& type = *new ResultType("ElementCause", 10);
  return type(text(causeText(cause)), flag(cause.finite), real(cause.leastDeterminant), real(cause.largestStretch),
              real(cause.leastStretch), text(shapeNames.nameOf(cause.shape.shape)), real(cause.shape.minDihedral),
              real(cause.shape.maxDihedral), real(cause.shape.aspect), flag(cause.badlyShaped()));
}

py::object negativeOrNone(const CriticalStep& step) {
  return step.lowestRing < 0 ? real(step.lowestRing) : py::object(py::none());
}

py::object criticalStepResult(const CriticalStep& step) {
  static const ResultType& type = *new ResultType("CriticalStep", 6);
  return type(real(step.safe), real(step.optimistic), pairOf(step.controlling), text(step.safeBy),
              text(step.optimisticBy), negativeOrNone(step));
}

py::object eventResult(const MonitorEvent& event, const Mesh& mesh) {
  static const ResultType& type = *new ResultType("MonitorEvent", 8);
  return type(text(eventName(event.kind)), integer(event.step), real(event.time), real(event.value),
              orNone(event.element, [&](ElementRef element) { return elementResult(mesh, element); }),
              orNone(event.cause, [](const ElementCause& cause) { return causeResult(cause); }),
              orNone(event.end, integer), text(labelled(eventText(event, mesh))));
}

}  // namespace ringwatch::python

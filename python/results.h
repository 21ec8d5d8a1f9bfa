#pragma once
#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <pybind11/pybind11.h>

#include <ringwatch/monitor/event.h>
#include <ringwatch/monitor/step_limit.h>

namespace ringwatch::python {

namespace py = pybind11;

/// A frozen dataclass of ringwatch._results, whose instances are filled here: its own __init__ takes three times as
/// long, which counts in an observation.
class ResultType {
 public:
  /// fields: how many it has, which is checked.
  ResultType(const char* name, std::size_t fields);
  /// One value for each field, in order.
  template <class... Values>
  py::object operator()(Values&&... values) const {
    std::array<py::object, sizeof...(Values)> all{std::forward<Values>(values)...};
    return fill(all);
  }

 private:
  py::object fill(std::span<py::object> values) const;
  py::object type_;
  std::vector<py::object> names_;
};

inline py::object real(double value) { return py::float_(value); }
inline py::object integer(std::int64_t value) { return py::int_(value); }
inline py::object text(std::string_view value) { return py::str(value.data(), value.size()); }
inline py::object flag(bool value) { return py::bool_(value); }
/// (block, index)
inline py::object pairOf(ElementRef element) { return py::make_tuple(element.block, element.element); }
template <class T, class Make>
py::object orNone(const std::optional<T>& value, const Make& make) {
  return value ? make(*value) : py::object(py::none());
}

py::object elementResult(const Mesh& mesh, ElementRef element);
py::object causeResult(const ElementCause& cause);
/// The eigenvalue that proves the tangent indefinite; None where none was found.
py::object negativeOrNone(const CriticalStep& step);
py::object criticalStepResult(const CriticalStep& step);
py::object eventResult(const MonitorEvent& event, const Mesh& mesh);

}  // namespace ringwatch::python

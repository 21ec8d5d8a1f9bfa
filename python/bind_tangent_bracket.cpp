#include <cmath>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <ringwatch/base/error.h>
#include <ringwatch/monitor/tangent_bracket.h>
#include <ringwatch/python/arrays.h>
#include <ringwatch/python/held.h>
#include <ringwatch/python/results.h>
#include <ringwatch/python/signatures.h>

namespace ringwatch::python {
namespace {

struct HeldBracket {
  /// Of a group, as evaluate() wants them.
  struct Group {
    py::ssize_t elements, size;  // size: rows of a tangent
  };
  HeldBracket(const NodalMass& mass, const std::vector<TangentBracket::Elements>& elements,
              std::span<const std::uint8_t> constrained, int threads)
      : bracket(mass, elements, constrained, threads) {}

  TangentBracket bracket;
  std::vector<Group> groups;
  std::mutex turn;
};

/// One array, or a list of them, as a list.
std::vector<py::object> groupsOf(const char* name, const py::object& given) {
  if (py::isinstance<py::array>(given)) return {given};
  try {
    return given.cast<std::vector<py::object>>();
  } catch (const py::cast_error&) {
    throw InputError(joinText(name, ": ", describe(given), "; must be an array, or a list of one for each group"));
  }
}

std::string memberName(const char* name, const py::object& given, std::size_t group) {
  return py::isinstance<py::array>(given) ? std::string(name) : joinText(name, "[", group, "]");
}

std::unique_ptr<HeldBracket> bracketOf(py::handle mass, const py::object& elements, const py::object& constrained,
                                       int degreesOfFreedom, const std::vector<int>& degreesOfGroups, int threads) {
  if (!py::isinstance<py::array>(mass))
    throw InputError(
        joinText("mass: ", describe(mass), "; must be an array of float64 of shape (N,), (N, d) or (N, d, d)"));
  const auto given = py::reinterpret_borrow<py::array>(mass);
  NodalMass nodal;
  nodal.degreesOfFreedom = given.ndim() > 1 ? static_cast<int>(given.shape(1)) : degreesOfFreedom;
  const py::ssize_t d = nodal.degreesOfFreedom;
  if (given.ndim() > 2) {
    nodal.form = NodalMass::Form::block;
    nodal.values = realsOf("mass", mass, {-1, d, d});
  } else if (given.ndim() == 2) {
    nodal.form = NodalMass::Form::diagonal;
    nodal.values = realsOf("mass", mass, {-1, d});
  } else {
    nodal.values = realsOf("mass", mass, {-1});
  }
  const py::ssize_t nodes = given.shape(0);

  const std::vector<py::object> arrays = groupsOf("elements", elements);
  if (!degreesOfGroups.empty() && degreesOfGroups.size() != arrays.size())
    throw InputError(joinText("group_dofs: ", degreesOfGroups.size(), " numbers for ", arrays.size(),
                              " groups of elements; must be one for each"));
  std::vector<std::vector<std::int32_t>> indices;
  std::vector<TangentBracket::Elements> groups;
  std::vector<HeldBracket::Group> shapes;
  for (std::size_t g = 0; g < arrays.size(); ++g) {
    indices.push_back(indicesOf(memberName("elements", elements, g).c_str(), arrays[g], 2, nodes));
    const auto array = py::reinterpret_borrow<py::array>(arrays[g]);
    const int own = degreesOfGroups.empty() ? 0 : degreesOfGroups[g];
    shapes.push_back({array.shape(0), array.shape(1) * (own > 0 ? own : d)});
  }
  for (std::size_t g = 0; g < arrays.size(); ++g)
    groups.push_back({static_cast<int>(py::reinterpret_borrow<py::array>(arrays[g]).shape(1)), indices[g],
                      degreesOfGroups.empty() ? 0 : degreesOfGroups[g]});

  std::vector<std::uint8_t> held;
  if (!constrained.is_none()) {
    using Flags = py::array_t<bool, py::array::c_style>;
    if (!py::isinstance<Flags>(constrained) || constrained.cast<Flags>().ndim() != 2 ||
        constrained.cast<Flags>().shape(0) != nodes || constrained.cast<Flags>().shape(1) != d)
      throw InputError(joinText("constrained: ", describe(constrained), "; must be an array of bool of shape ",
                                shapeText({nodes, d}), " in C order, a flag for each degree of freedom"));
    const auto flags = constrained.cast<Flags>();
    held.assign(flags.data(), flags.data() + flags.size());
  }
  std::unique_ptr<HeldBracket> made;
  {
    const py::gil_scoped_release release;
    made = std::make_unique<HeldBracket>(nodal, groups, held, threads);
  }
  made->groups = std::move(shapes);
  return made;
}

py::object evaluate(HeldBracket& self, const py::object& tangents, double limit, bool searchNegative) {
  const std::vector<py::object> arrays = groupsOf("tangents", tangents);
  if (arrays.size() != self.groups.size())
    throw InputError(joinText("tangents: ", arrays.size(), " arrays for ", self.groups.size(),
                              " groups of elements; must be one for each"));
  std::vector<std::span<const double>> spans;
  for (std::size_t g = 0; g < arrays.size(); ++g) {
    const HeldBracket::Group& group = self.groups[g];
    spans.push_back(
        realsOf(memberName("tangents", tangents, g).c_str(), arrays[g], {group.elements, group.size, group.size}));
  }
  const CriticalStep step = unlocked<std::unique_lock<std::mutex>>(
      self.turn, [&] { return self.bracket.evaluate(spans, limit, searchNegative); });
  return criticalStepResult(step);
}

}  // namespace

void bindTangentBracket(py::module_& module) {
  auto bracket = bindClass<py::class_<HeldBracket>>(
      module, "TangentBracket", py::init(&bracketOf),
      "The bracket for a code that hands over element tangents and lumped masses, of any physics whose tangents are\n"
      "symmetric.\n\n"
      "mass: float64 of shape (N,), (N, d) or (N, d, d), of nodes with d degrees of freedom. elements: the nodes of "
      "the\n"
      "elements, (n, k); or a list of such groups. constrained: (N, d) bool, True where a degree of freedom does not\n"
      "move. degrees_of_freedom: d, for masses of shape (N,). group_dofs: degrees of freedom that each group has at a\n"
      "node. Raises InputError.",
      "", py::arg("mass"), py::arg("elements"), py::arg("constrained") = py::none(), py::kw_only(),
      py::arg("degrees_of_freedom") = 3, py::arg("group_dofs") = std::vector<int>(), py::arg("threads") = 0);
  bindMethod(
      bracket, "evaluate", &evaluate,
      "The CriticalStep of tangents (n, k d, k d), float64 in C order, read where they lie; or a list of one "
      "array for\neach group. limit: the integrator's largest stable h omega. search_negative: whether a direction "
      "of negative stiffness\nis searched for in the whole body, beyond the rings of the elements at hand. "
      "Raises InputError; NumericalError\nwhere rounding makes the sides cross.",
      py::arg("tangents"), py::arg("limit") = 2.0, py::kw_only(), py::arg("search_negative") = false);
  bracket.def("__repr__", [](const HeldBracket& self) {
    py::ssize_t elements = 0;
    for (const HeldBracket::Group& group : self.groups) elements += group.elements;
    return joinText("<TangentBracket: ", elements, " elements in ", self.groups.size(),
                    self.groups.size() == 1 ? " group>" : " groups>");
  });
}

}  // namespace ringwatch::python

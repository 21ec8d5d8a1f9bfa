// The extension _verify: the study of integrators, of one that is written in Python. It is an extension of its own,
// since the studies are compiled for a short build, not for speed, and what both have of the same templates must not
// get into the numbers of _ringwatch.
#include <string>
#include <variant>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <ringwatch/base/error.h>
#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/python/arrays.h>
#include <ringwatch/python/errors.h>
#include <ringwatch/python/results.h>
#include <ringwatch/verify/integrators/integrators.h>
#include <ringwatch/verify/step_rules/judge.h>

namespace ringwatch::python {
namespace {

/// A system as an integrator of Python sees it during a step: acceleration(time, x, v).
class AccelerationCallback {
 public:
  AccelerationCallback(SecondOrderSystem& system, Eigen::Index nodes) : system_(&system), nodes_(nodes) {}
  py::array operator()(double time, py::handle x, py::handle v) {
    if (!system_) throw InputError("acceleration: called after the step that it was given for");
    const NodeVectors positions = nodalOf("acceleration: x", x, nodes_),
                      velocities = nodalOf("acceleration: v", v, nodes_);
    NodeVectors a;
    system_->acceleration(time, positions, velocities, a);
    return ownedArray(std::move(a));
  }
  void end() { system_ = nullptr; }

 private:
  SecondOrderSystem* system_;
  Eigen::Index nodes_;
};

/// An integrator written in Python: step(acceleration, time, x, v, h) -> (time, x, v).
class PythonIntegrator final : public Integrator {
 public:
  PythonIntegrator(const IntegratorInfo& declared, py::object step) : info_(declared), step_(std::move(step)) {}
  const IntegratorInfo& info() const override { return info_; }
  StepStatus step(SecondOrderSystem& system, State& state, double h) override {
    const Eigen::Index nodes = state.x.cols();
    const py::object acceleration = py::cast(AccelerationCallback(system, nodes));
    // Copies: the integrator may write into them, and keep them.
    const py::object made =
        step_(acceleration, state.time, ownedArray(NodeVectors(state.x)), ownedArray(NodeVectors(state.v)), h);
    acceleration.cast<AccelerationCallback&>().end();
    if (!py::isinstance<py::tuple>(made) || py::len(made) != 3)
      throw InputError(joinText("integrator: returned ", describe(made), "; must return a tuple (time, x, v)"));
    const auto next = py::reinterpret_borrow<py::tuple>(made);
    const double time = PyFloat_AsDouble(next[0].ptr());
    if (PyErr_Occurred()) {
      PyErr_Clear();
      throw InputError(joinText("integrator: returned ", describe(next[0]), " as the time; must be a number, s"));
    }
    state.x = nodalOf("integrator: x", next[1], nodes);
    state.v = nodalOf("integrator: v", next[2], nodes);
    state.a.resize(3, 0);
    state.time = time;
    return {};
  }

 private:
  IntegratorInfo info_;
  py::object step_;
};

py::object checkResult(const StudyCheck& check) {
  static const ResultType& type = *new ResultType("Check", 6);
  static constexpr std::string_view senses[] = {"near", "at-most", "at-least"};
  return type(text(check.name), real(check.measured), real(check.expected), real(check.tolerance),
              text(senses[static_cast<std::size_t>(check.sense)]), flag(check.passed()));
}

py::object tableResult(const StudyTable& table) {
  py::list rows;
  for (const auto& cells : table.rows) {
    py::dict row;
    for (std::size_t i = 0; i < cells.size(); ++i)
      row[text(table.columns[i])] = std::visit(
          [](const auto& cell) -> py::object {
            using Cell = std::decay_t<decltype(cell)>;
            if constexpr (std::is_same_v<Cell, std::string>)
              return text(cell);
            else if constexpr (std::is_same_v<Cell, double>)
              return real(cell);
            else
              return integer(cell);
          },
          cells[i]);
    rows.append(std::move(row));
  }
  return py::tuple(rows);
}

/// What a report holds, by name.
py::object verification(const std::string& name, const StudyReport& report) {
  static const ResultType& type = *new ResultType("Verification", 4);
  py::list checks;
  for (const StudyCheck& check : report.checks) checks.append(checkResult(check));
  py::dict tables;
  for (const StudyTable& table : report.tables) tables[text(table.name)] = tableResult(table);
  return type(text(name), flag(report.passed()), py::tuple(checks), std::move(tables));
}

py::object verify(const py::object& make, const std::string& name, double limit, int order, int dampedOrder, int forces,
                  bool symplectic, bool reversible, bool full) {
  const IntegratorInfo declared{.name = name,
                                .help = "an integrator written in Python",
                                .order = order,
                                .forceEvaluations = forces,
                                .imaginaryLimit = limit,
                                .symplectic = symplectic,
                                .reversible = reversible,
                                .dampedOrder = dampedOrder};
  // Python's lock stays: most of the time goes into the integrator itself.
  const StudyReport report = verifyIntegrator([&] { return std::make_unique<PythonIntegrator>(declared, make()); },
                                              full ? StudyEffort::full : StudyEffort::quick);
  return verification(name, report);
}

/// A rule written in Python: rule(points, cells, young, poisson, density) -> s.
py::object judge(const py::object& rule, const std::string& name, const std::vector<std::string>& meshes,
                 const std::vector<std::string>& elements, int shapes, bool histories, double young, double poisson,
                 double density) {
  JudgeOptions options{shapes, elements, {}, histories, young, poisson, density};
  for (const std::string& file : meshes) options.meshes.emplace_back(file, loadMesh(file));
  const auto step = [&](const Mesh& mesh, double E, double nu, double rho) {
    py::list cells;
    for (const MeshBlock& block : mesh.blocks) {
      const int n = block.nodesPerElement();
      py::array_t<std::int32_t> nodes({static_cast<py::ssize_t>(block.elementCount()), static_cast<py::ssize_t>(n)},
                                      block.connectivity.data());
      cells.append(py::make_tuple(text(elementInfo(block.type).name), std::move(nodes)));
    }
    const py::object given = rule(ownedArray(NodeVectors(mesh.X)), std::move(cells), E, nu, rho);
    const double value = PyFloat_AsDouble(given.ptr());
    if (PyErr_Occurred()) {
      PyErr_Clear();
      throw InputError(joinText("rule: returned ", describe(given), "; must return a step, s"));
    }
    return value;
  };
  return verification(name, judgeRule(step, options).report);
}

}  // namespace
}  // namespace ringwatch::python

PYBIND11_MODULE(_verify, module) {
  using namespace ringwatch::python;
  py::options options;
  options.disable_function_signatures();  // they stand in _verify.pyi
  translateErrors();
  py::class_<AccelerationCallback>(module, "Acceleration", py::module_local())
      .def("__call__", &AccelerationCallback::operator());
  module.def("verify", &verify);
  module.def("judge", &judge);
}

#include <array>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <ringwatch/base/error.h>
#include <ringwatch/monitor/stability_monitor.h>
#include <ringwatch/python/arrays.h>
#include <ringwatch/python/held.h>
#include <ringwatch/python/results.h>
#include <ringwatch/python/signatures.h>

namespace ringwatch::python {
namespace {

/// A monitor with the body that it watches, for one thread at a time.
struct HeldMonitor {
  HeldMonitor(std::shared_ptr<HeldBody> watched, const MonitorOptions& options)
      : held(std::move(watched)), monitor(held->body, options) {}

  std::shared_ptr<HeldBody> held;
  StabilityMonitor monitor;
  std::mutex turn;
};

std::unique_ptr<HeldMonitor> monitorOf(std::shared_ptr<HeldBody> body, double limit, const std::string& mode,
                                       const std::string& metric, double margin, int every, double width,
                                       std::optional<double> budget, std::int64_t steps,
                                       std::int64_t firstObservationElements) {
  MonitorOptions options;
  options.limit = limit;
  options.mode = monitorModeNames.valueOf("mode", mode);
  options.metric = metric;
  options.margin = margin;
  options.every = every;
  options.width = width;
  if (budget) {
    options.budget = *budget;
    options.workInAdvance = 0;
  }
  options.steps = steps;
  options.firstObservationElements = firstObservationElements;
  HeldBody& held = *body;
  return reading(held, [&] { return std::make_unique<HeldMonitor>(std::move(body), options); });
}

/// What an observation has spent, by what it went to.
py::object spentOf(const Work& work) {
  static const auto& names = *[] {
    auto* made = new std::array<py::object, worksOn>;
    for (std::size_t i = 0; i < worksOn; ++i) (*made)[i] = text(workNames[i]);
    return made;
  }();
  py::dict spent;
  for (std::size_t i = 0; i < worksOn; ++i)
    if (PyDict_SetItem(spent.ptr(), names[i].ptr(), real(work.of[i]).ptr()) != 0) throw py::error_already_set();
  return spent;
}

py::object reportOf(const MonitorReport& report, const Mesh& mesh, py::object force, py::object energy) {
  static const ResultType& type = *new ResultType("MonitorReport", 14);
  static PyObject* const noEvents = PyTuple_New(0);
  static const py::handle verdicts[] = {text(verdictName(Verdict::certified)).release(),
                                        text(verdictName(Verdict::notCertified)).release(),
                                        text(verdictName(Verdict::violated)).release()};
  auto events = py::reinterpret_borrow<py::object>(noEvents);
  if (!report.newEvents.empty()) {
    py::list list;
    for (const MonitorEvent& event : report.newEvents) list.append(eventResult(event, mesh));
    events = py::tuple(list);
  }
  return type(integer(report.step), real(report.time), report.h > 0 ? real(report.h) : py::object(py::none()),
              py::reinterpret_borrow<py::object>(verdicts[static_cast<std::size_t>(report.verdict)]),
              orNone(report.bracket, criticalStepResult), real(report.certified), orNone(report.metricStep, real),
              flag(report.fresh), integer(report.evaluatedAt), integer(report.elementsRefreshed), spentOf(report.spent),
              std::move(events), std::move(force), std::move(energy));
}

py::object observe(HeldMonitor& self, std::int64_t step, double time, py::handle positions, py::handle velocities,
                   std::optional<double> h, bool wantsForce, bool wantsEnergy) {
  const Body& body = self.held->body;
  const NodeVectorsView x = nodalOf("x", positions, body.nodeCount()), v = nodalOf("v", velocities, body.nodeCount());
  StepEvaluation evaluation;
  evaluation.wantsForce = wantsForce;
  evaluation.wantsEnergy = wantsEnergy;
  const MonitorReport report = reading(*self.held, [&] {
    const std::lock_guard turn(self.turn);
    return self.monitor.observe(step, time, x, v, h, wantsForce || wantsEnergy ? &evaluation : nullptr);
  });
  return reportOf(report, body.mesh(),
                  wantsForce ? py::object(ownedArray(std::move(evaluation.internalForce))) : py::object(py::none()),
                  wantsEnergy ? real(evaluation.strainEnergy) : py::object(py::none()));
}

py::tuple eventsOf(HeldMonitor& self) {
  const auto events = unlocked<std::unique_lock<std::mutex>>(self.turn, [&] { return self.monitor.events(); });
  py::list list;
  for (const MonitorEvent& event : events) list.append(eventResult(event, self.held->body.mesh()));
  return py::tuple(list);
}

}  // namespace

void bindMonitor(py::module_& module) {
  const MonitorOptions usual;
  auto monitor = bindClass<py::class_<HeldMonitor>>(
      module, "Monitor", py::init(&monitorOf),
      "Keeps the bracket of the critical step current along a run.\n\n"
      "limit: the integrator's largest stable h omega. mode: \"bracket\", \"threshold\" (only whether the step is\n"
      "certified, cheapest) or \"metric\". metric: one to evaluate too, or \"\". margin: of its step. every: steps\n"
      "between evaluations. width: of the bracket, relative, that is aimed at. budget: what the bracket may take "
      "after\n"
      "the first observation, as a share of a step's own work, counted; when it is used up the proof stays and the\n"
      "bracket becomes wider; from 100 on there is no limit; None: 0.1, and in small bodies no limit before it has "
      "taken\n"
      "0.2 to 0.5 s in all. steps: of the run, as far as known: the first observation goes beyond the proof of h where "
      "all\n"
      "of it takes no more than three tenths of the budget of so many. first_observation_elements: bodies of up to "
      "this\n"
      "many elements get the best proof there is at the first observation, where h is None or not certified without "
      "it.\n"
      "Raises InputError.",
      "", py::arg("body"), py::arg("limit") = 2.0, py::kw_only(), py::arg("mode") = "bracket", py::arg("metric") = "",
      py::arg("margin") = usual.margin, py::arg("every") = usual.every, py::arg("width") = usual.width,
      py::arg("budget") = py::none(), py::arg("steps") = usual.steps,
      py::arg("first_observation_elements") = usual.firstObservationElements);
  bindMethod(monitor, "observe", &observe,
             "Observes positions x and velocities v ((N, 3), m and m/s, read where they lie) before step number `step` "
             "of\nsize h (s; None while none is chosen). force, energy: also compute internal_force and strain_energy, "
             "in the same\npass. Returns a MonitorReport. Raises InputError.",
             py::arg("step"), py::arg("time"), py::arg("x"), py::arg("v"), py::arg("h") = py::none(), py::kw_only(),
             py::arg("force") = false, py::arg("energy") = false);
  monitor
      .def("__repr__",
           [](const HeldMonitor& self) {
             return joinText("<Monitor: mode ", monitorModeNames.nameOf(self.monitor.options().mode), ", ",
                             meshText(self.held->body.mesh()), ">");
           })
      .def_property_readonly("events", &eventsOf, "All events so far, in the order of their beginnings.");
}

}  // namespace ringwatch::python

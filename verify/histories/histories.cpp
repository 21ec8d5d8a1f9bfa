#include <ringwatch/verify/histories/histories.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <ringwatch/monitor/certificate_file.h>
#include <ringwatch/monitor/critical_step.h>
#include <ringwatch/verify/monitor/monitor_histories.h>
#include <ringwatch/verify/study_bodies.h>

namespace ringwatch {
namespace {

using Cell = StudyTable::Cell;
using detail::History, detail::HistoryState, detail::verletLimit;

/// Both sides of the bracket are proven but for the error of what they are compared with.
constexpr double ofTheReference = 1e-9;

/// How a body is moved. share: of the run's step in the proven one at rest, so that the critical step falls below it
/// where the load stiffens the body.
struct Load {
  std::string_view name, title;
  double share;
};
constexpr Load pulled{"pulled", "Bars that are pulled", 0.85}, twisted{"twisted", "Bars whose end turns", 0.9},
    compressed{"compressed", "Bars that are compressed", 0.5}, hanging{"hanging", "Balls in a field of force", 0.9};

struct RunInfo {
  const Load* load;
  std::string_view element, law;
  bool quick = false;
  std::string name() const { return joinText(load->name, "-", element, "-", law); }
};
constexpr std::array<RunInfo, 20> allRuns{{{&pulled, "tet4", "stvk", true},
                                           {&pulled, "hex8", "stvk"},
                                           {&pulled, "wedge6", "stvk"},
                                           {&pulled, "pyramid5", "stvk"},
                                           {&pulled, "tet10", "stvk"},
                                           {&pulled, "hex20", "stvk"},
                                           {&pulled, "tet4", "corotational"},
                                           {&pulled, "tet4", "neo-hookean"},
                                           {&pulled, "hex8", "stable-neo-hookean"},
                                           {&twisted, "tet4", "stvk"},
                                           {&twisted, "hex8", "stvk"},
                                           {&twisted, "hex8", "neo-hookean", true},
                                           {&twisted, "tet4", "corotational"},
                                           {&compressed, "tet4", "stvk"},
                                           {&compressed, "hex8", "stvk"},
                                           {&compressed, "hex8", "corotational", true},
                                           {&compressed, "tet4", "neo-hookean"},
                                           {&compressed, "wedge6", "stable-neo-hookean"},
                                           {&hanging, "tet4", "stvk"},
                                           {&hanging, "hex8", "stvk"}}};

struct Size {
  int cells, cellsOfBall, steps,
      every;  // across the bar, across the ball; most steps of a run, steps from point to point
};
constexpr Size fullSize{3, 8, 2000, 25}, quickSize{2, 5, 240, 40};

History historyOf(const RunInfo& info, const Size& size) {
  // The same stretch a step on coarse and fine meshes.
  const double speed = 0.1 * size.cells;  // m/s
  constexpr double ofCompression = -0.75, ofTurning = 30;
  const Load* const load = info.load;
  Body body =
      load == &hanging ? detail::hangingBall(info.element, size.cellsOfBall, info.law)
      : load == &twisted
          ? detail::movedBar(info.element, size.cells, Eigen::Vector3d::Zero(), ofTurning * speed, info.law)
          : detail::movedBar(info.element, size.cells,
                             Eigen::Vector3d(load == &pulled ? speed : ofCompression * speed, 0, 0), 0, info.law);
  const double h = load->share * criticalStep(body, body.mesh().X, verletLimit).safe;
  return {info.name(), std::string(load->title), std::move(body), h, size.steps, load == &compressed};
}

struct Tables {
  StudyTable runs{
      "runs",
      "The runs: symplectic Euler at a fixed step, E = 30 kPa, nu = 0.3, 1000 kg/m3",
      {"run", "load", "element", "law", "elements", "nodes", "h (s)", "steps", "points", "exact step below h at step",
       "first violated at step", "energy off by 10 % at step", "safe over exact, least", "optimistic over exact, most",
       "body"},
      {},
      {"name of the run", "what moves the body", "element of the library", "law of the library", "number of elements",
       "number of nodes", "step of the run", "number of steps that were taken", "number of states with an exact step",
       "first point whose exact step lies below h; -1: none",
       "first state at which the monitor proved h unstable; -1: none",
       "state at which the energy balance is off by a tenth of the largest energy, the end; -1: none",
       "over the points", "over the points", "hash of the body in the certificates, for ringwatch-check --expect"}};
  StudyTable points{"points",
                    "States of the runs: exact critical step, proven bracket, certificate",
                    {"run", "step", "time (s)", "h (s)", "exact (s)", "safe (s)", "optimistic (s)", "verdict",
                     "certified (s)", "certificate", "kinetic (J)", "strain (J)", "external work (J)"},
                    {},
                    {"name of the run", "steps taken before this state", "time of the state", "step of the run",
                     "2/omega of the highest frequency at this state, by Lanczos to a residual of 1e-9",
                     "the monitor's proven lower side", "the monitor's proven upper side",
                     "of h: certified, not-certified or violated", "step that the certificate proves stable",
                     "path of the certificate of this state", "kinetic energy, velocities half a step behind",
                     "strain energy", "work of loads and moved nodes since the start"}};
  StudyTable events{
      "events",
      "What the monitor told",
      {"run", "step", "time (s)", "event", "text"},
      {},
      {"name of the run", "steps taken before it", "time of the state", "kind of event", "the monitor's own sentence"}};
};

std::string certificateName(const std::string& run, std::int64_t step) {
  std::array<char, 32> number{};
  std::snprintf(number.data(), number.size(), "%08lld", static_cast<long long>(step));
  return joinText("certificates/", run, "/step_", number.data(), ".certificate");
}

void runOne(const RunInfo& info, const Size& size, Tables& tables, StudyFigure& figure, StudyReport& report) {
  const History history = historyOf(info, size);
  const Body& body = history.body;
  StudyFigure::Curve curve{joinText(info.element, ", ", info.law), {}, {}};
  std::int64_t steps = 0, points = 0, exactAt = -1, violatedAt = -1, energyAt = -1;
  std::int64_t outside = 0, falseAlarms = 0;
  double leastSafe = infinity, mostOptimistic = 0, first = 0;
  detail::followHistory(history, [&](const HistoryState& now) {
    steps = now.step;
    const MonitorReport& seen = now.seen;
    for (const MonitorEvent& event : seen.newEvents)
      tables.events.rows.push_back(
          {history.name, event.step, event.time, std::string(eventName(event.kind)), eventText(event, body.mesh())});
    const bool alarm = seen.verdict == Verdict::violated && violatedAt < 0;
    if (alarm) violatedAt = now.step;
    if (now.energyOff) energyAt = now.step;
    if (!(now.step % size.every == 0 || alarm) || !seen.bracket) return;
    const GlobalFrequency top = globalFrequency(body, now.state.x, 1e-9);
    if (!top.converged) return;
    const Certificate certificate = makeCertificate(body, now.state.x);
    const double exact = stepFor(top.lambda, verletLimit), certified = stepFor(certificate.upper.value, verletLimit);
    const double above = exact * (1 + ofTheReference), below = exact * (1 - ofTheReference);
    outside += !(seen.bracket->safe <= above && seen.bracket->optimistic >= below && certified <= above) ? 1 : 0;
    falseAlarms += alarm && exact >= history.h * (1 + ofTheReference) ? 1 : 0;
    if (exactAt < 0 && exact < history.h) exactAt = now.step;
    leastSafe = std::min(leastSafe, seen.bracket->safe / exact);
    mostOptimistic = std::max(mostOptimistic, seen.bracket->optimistic / exact);
    report.files.push_back({certificateName(history.name, now.step), certificate.bytes});
    tables.points.rows.push_back({history.name, now.step, now.state.time, history.h, exact, seen.bracket->safe,
                                  seen.bracket->optimistic, std::string(verdictName(seen.verdict)), certified,
                                  report.files.back().name, now.energies.kinetic, now.energies.strain,
                                  now.energies.externalWork});
    if (points++ == 0) first = exact;
    curve.x.push_back(static_cast<double>(now.step));
    curve.y.push_back(exact / first);
  });
  std::array<char, 17> hash{};
  std::snprintf(hash.data(), hash.size(), "%016llx", static_cast<unsigned long long>(certifiedBodyHash(body)));
  tables.runs.rows.push_back({history.name, std::string(info.load->name), std::string(info.element),
                              std::string(info.law), static_cast<std::int64_t>(body.mesh().elementCount()),
                              std::int64_t{body.nodeCount()}, history.h, steps, points, exactAt, violatedAt, energyAt,
                              leastSafe, mostOptimistic, std::string(hash.data())});
  figure.curves.push_back(std::move(curve));
  checkNear(report, history.name + ": points whose bracket or certificate is wrong",
            points > 0 ? static_cast<double>(outside) : std::numeric_limits<double>::quiet_NaN(), 0, 0);
  checkNear(report, history.name + ": alarms while the exact step allows h", static_cast<double>(falseAlarms), 0, 0);
}

}  // namespace

StudyReport verifyHistories(StudyEffort effort) {
  const bool full = effort == StudyEffort::full;
  StudyReport report{"histories", {}, {}, {}};
  Tables tables;
  for (const RunInfo& info : allRuns) {
    if (!full && !info.quick) continue;
    const std::string name = joinText("histories-", info.load->name);
    if (report.figures.empty() || report.figures.back().name != name)
      report.figures.push_back({name,
                                joinText(info.load->title, ": exact critical step along the run"),
                                "step",
                                "exact step over that of the start",
                                false,
                                false,
                                {}});
    runOne(info, full ? fullSize : quickSize, tables, report.figures.back(), report);
  }
  for (StudyTable* table : {&tables.runs, &tables.points, &tables.events}) report.tables.push_back(std::move(*table));
  return report;
}

}  // namespace ringwatch

// What the first observation of a monitor takes, and the bracket from scratch, of a bar at rest: processor time over
// that of one force of the same body in the same run, safe side over the best optimistic one, and memory.
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <bench/runs.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/median.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/monitor/critical_step.h>
#include <ringwatch/monitor/stability_monitor.h>

namespace ringwatch::bench {
namespace {

double bytesSoFar() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

/// Five times as long as wide, of cubes of 1 cm.
Mesh makeBar(const std::string& element, int perCell, double jitter, double count) {
  BarOptions options;
  options.element = element;
  options.split = perCell;
  options.jitter = jitter;
  const int n = static_cast<int>(std::lround(std::cbrt(count / (5.0 * std::max(1, perCell)))));
  options.cells = {5 * n, n, n};
  options.size = {0.05 * n, 0.01 * n, 0.01 * n};
  return generateBar(options);
}

/// The median of 21.
double secondsOfForce(const Body& body) {
  Body::Workspace workspace;
  StepEvaluation evaluation;
  std::vector<double> seconds(21);
  for (double& one : seconds) {
    const double begin = cpuSeconds();
    body.evaluate(body.mesh().X, evaluation, workspace);
    one = cpuSeconds() - begin;
  }
  return median(std::move(seconds));
}

void measure(const std::string& element, int perCell, double jitter, double count) {
  const Body body(makeBar(element, perCell, jitter, count), makeMaterial("stvk", 30e3, 0.3, 1000),
                  {{}, Lumping::rowSum, 1});
  const auto elements = static_cast<double>(body.mesh().elementCount());
  const double force = secondsOfForce(body);
  std::printf("%s, %d a cell, jitter %g: %.0f elements, a force %.3g ns an element, %.0f bytes an element before\n",
              element.c_str(), perCell, jitter, elements, 1e9 * force / elements, bytesSoFar() / elements);
  struct Row {
    std::string name;
    double forces, safe, bytes;
  };
  std::vector<Row> rows;
  const NodeVectors &X = body.mesh().X, still = NodeVectors::Zero(3, body.nodeCount());
  // Memory grows only: the smaller ones come first. A step of half the critical one has to be known first.
  double critical = 0;
  {
    MonitorOptions options;
    options.firstObservationElements = 0;
    critical = StabilityMonitor(body, options).observe(0, 0, X, still, std::nullopt).bracket->safe;
  }
  const auto observe = [&](const std::string& name, MonitorMode mode, std::optional<double> h) {
    MonitorOptions options;
    options.mode = mode;
    options.steps = 1000;
    const double begin = cpuSeconds();
    StabilityMonitor monitor(body, options);
    const MonitorReport report = monitor.observe(0, 0, X, still, h);
    rows.push_back({name, (cpuSeconds() - begin) / force, report.certified, bytesSoFar() / elements});
  };
  observe("threshold, half the step", MonitorMode::threshold, 0.5 * critical);
  observe("bracket, half the step", MonitorMode::bracket, 0.5 * critical);
  observe("bracket, no step chosen", MonitorMode::bracket, std::nullopt);
  const double begin = cpuSeconds();
  const CriticalStep best =
      criticalStep(body, X, 2, {.listener = [&](double safe, double optimistic) {
                     rows.push_back({std::isfinite(optimistic) ? "inspect, so far" : "inspect, safe side alone",
                                     (cpuSeconds() - begin) / force, safe, bytesSoFar() / elements});
                   }});
  rows.push_back({"inspect", (cpuSeconds() - begin) / force, best.safe, bytesSoFar() / elements});
  for (const Row& row : rows)
    std::printf("  %-26s %8.0f forces   safe %.4f of the optimistic side   %6.0f bytes an element\n", row.name.c_str(),
                row.forces, row.safe / best.optimistic, row.bytes);
}

}  // namespace
}  // namespace ringwatch::bench

int main(int argc, char** argv) {
  if (argc != 5) {
    std::cerr << "usage: ringwatch_first_look ELEMENT ELEMENTS_A_CELL JITTER ELEMENTS\n";
    return 2;
  }
  try {
    ringwatch::bench::measure(argv[1], std::stoi(argv[2]), std::stod(argv[3]), std::stod(argv[4]));
  } catch (const std::exception& fault) {
    std::cerr << "ringwatch_first_look: " << fault.what() << '\n';
    return 2;
  }
}

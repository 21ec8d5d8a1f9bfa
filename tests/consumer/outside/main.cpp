// An outside project: embeds the monitor in a time loop and checks that it sees a step that is too large, with an
// integrator, a metric, a handler and an element of its own that it registers when it starts.
#include <cmath>
#include <cstdio>

#include <ringwatch/body/register_element.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/monitor/stability_monitor.h>

#include "own_kinds.h"

int main() {
  using namespace ringwatch;
  registerIntegrator(integratorEntry<outside::Euler>());
  registerMetric(outside::shortestEdge);
  registerHandler(handlerEntry<outside::Substeps>());
  registerElement<outside::Voxel8>();
  BarOptions bar;
  bar.size = {0.2, 0.04, 0.04};
  bar.cells = {5, 1, 1};
  const Body body(generateBar(bar), makeMaterial("stvk", 30e3, 0.3, 1000.0));

  BodySystem system(body);
  State state = system.initialState();
  const auto integrator = makeIntegrator("own-euler");
  MonitorOptions options;
  options.limit = integrator->info().imaginaryLimit;
  options.metric = "shortest-edge";
  StabilityMonitor monitor(body, options);

  const MonitorReport first = monitor.observe(0, state.time, state.x, state.v, 1e-6);
  if (first.verdict != Verdict::certified || !first.bracket || !(first.metricStep > 0)) return 1;
  const double safe = first.bracket->safe, optimistic = first.bracket->optimistic;
  std::printf("critical step between %.6e s and %.6e s\n", safe, optimistic);
  // The safe side of the bound that is kept along a run may sink before it is rebuilt.
  const double h = 0.8 * safe;
  for (int step = 1; step <= 10; ++step) {
    if (!integrator->step(system, state, h).done) return 1;
    if (monitor.observe(step, state.time, state.x, state.v, h).verdict != Verdict::certified) return 1;
  }
  Body handled(generateBar(bar), makeMaterial("stvk", 30e3, 0.3, 1000.0));
  const auto handler = makeHandler("substeps", handled, makeIntegrator("verlet"), {.own = {{"substeps", 8}}});
  handler->prepare(handled.mesh().X, 4 * optimistic);
  BodySystem handledSystem(handled);
  State handledState = handledSystem.initialState();
  if (handler->elements().empty() || !handler->step(handledSystem, handledState, 4 * optimistic).done) return 1;
  // Its own element is the library's hexahedron with the nodes in another order.
  bar.element = "voxel8";
  const Body own(generateBar(bar), makeMaterial("neo-hookean", 30e3, 0.3, 1000.0));
  bar.element = "hex8";
  const Body same(generateBar(bar), makeMaterial("neo-hookean", 30e3, 0.3, 1000.0));
  const CriticalStep ownStep = criticalStep(own, own.mesh().X, 2), sameStep = criticalStep(same, same.mesh().X, 2);
  std::printf("critical step with an element of its own between %.6e s and %.6e s\n", ownStep.safe, ownStep.optimistic);
  if (std::abs(ownStep.safe / sameStep.safe - 1) > 1e-6 ||
      std::abs(ownStep.optimistic / sameStep.optimistic - 1) > 1e-6)
    return 1;
  return monitor.observe(11, state.time, state.x, state.v, 1.1 * optimistic).verdict == Verdict::violated ? 0 : 1;
}

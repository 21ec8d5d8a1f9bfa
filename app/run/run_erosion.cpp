#include <ringwatch/app/run/run_erosion.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include <fmt/format.h>

#include <ringwatch/app/output/report.h>
#include <ringwatch/app/scene/scene_discrete.h>
#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/body/element_energy.h>
#include <ringwatch/body/element_stress.h>
#include <ringwatch/meshes/adjacency.h>
#include <ringwatch/monitor/metrics/metrics.h>

namespace ringwatch {

RunErosion::RunErosion(Simulation& simulation) : run_(simulation) {
  for (std::size_t i = 0; i < run_.scene.contacts.size(); ++i)
    if (run_.scene.contacts[i].withSurface) surfaces_.push_back(i);
}

std::vector<std::vector<RunErosion::Fault>> RunErosion::faults() const {
  const Scene::Erosion& wanted = *run_.scene.erosion;
  const Body& body = run_.body;
  std::vector<std::vector<Fault>> found;
  for (const auto& block : body.blocks()) found.emplace_back(static_cast<std::size_t>(block->elementCount()));
  if (wanted.inverted)
    for (std::size_t b = 0; b < found.size(); ++b) {
      const ElementBlock& block = *body.blocks()[b];
      double determinants[lanes];
      for (std::int32_t batch = 0; batch < block.layout().batchCount(); ++batch) {
        block.minimumDeterminantBatch(batch, run_.state.x.data(), determinants);
        for (int lane = 0; lane < lanes; ++lane)
          if (const std::int32_t e = block.layout().elements[batch * lanes + lane]; e >= 0 && !(determinants[lane] > 0))
            found[b][e] = {"inverted", determinants[lane]};
      }
    }
  struct Limit {
    const char* measure;
    const std::optional<double>& value;
  };
  const std::vector<std::size_t> first = blockOffsets(body.mesh());
  for (const Limit& limit : {Limit{"max_stretch", wanted.stretch}, Limit{"von_mises", wanted.vonMises},
                             Limit{"max_principal_stress", wanted.principalStress}}) {
    if (!limit.value) continue;
    const StressMeasure* const measure = findStressMeasure(limit.measure);
    const std::vector<double> values = stressOfElements(body, run_.state.x, std::span(&measure, 1)).front();
    for (std::size_t b = 0; b < found.size(); ++b)
      for (std::size_t e = 0; e < found[b].size(); ++e)
        if (!found[b][e].cause && values[first[b] + e] > *limit.value)
          found[b][e] = {limit.measure, values[first[b] + e]};
  }
  if (wanted.step) {
    const MetricResult own = evaluateMetric("single-element", body, run_.state.x);
    for (std::size_t b = 0; b < found.size(); ++b)
      for (std::size_t e = 0; e < found[b].size(); ++e)
        if (const double step = run_.rule(own.elementLambda[b][e]); !found[b][e].cause && step < *wanted.step)
          found[b][e] = {"step", step};
  }
  return found;
}

bool RunErosion::makeDue(std::int64_t k) {
  if (!run_.scene.erosion || k % run_.scene.erosion->every != 0 || !isFinite(run_.state, run_.body.threads()))
    return true;
  const std::vector<std::vector<Fault>> found = faults();
  std::size_t count = 0;
  for (const auto& block : found)
    count += static_cast<std::size_t>(std::ranges::count_if(block, [](const Fault& f) { return f.cause != nullptr; }));
  if (count == 0) return true;
  if (count == run_.body.mesh().elementCount()) {
    run_.end(ExitReason::stepFailed, fmt::format("every element that is left meets a criterion of [erosion] before "
                                                 "step {}",
                                                 k));
    return false;
  }
  takeOut(found, k);
  return true;
}

void RunErosion::takeOut(const std::vector<std::vector<Fault>>& found, std::int64_t k) {
  run_.output->open();
  run_.completeState();
  const std::vector<std::vector<double>> strain = strainEnergyOfElements(run_.body, run_.state.x);
  std::vector<std::vector<bool>> stays;
  double lost = 0;
  const std::size_t before = run_.result.eroded.size();
  MonitorEvent event{.kind = EventKind::eroded, .step = k, .time = run_.state.time, .end = k + 1};
  for (std::size_t b = 0; b < found.size(); ++b) {
    stays.emplace_back(found[b].size(), true);
    for (std::size_t e = 0; e < found[b].size(); ++e) {
      if (!found[b][e].cause) continue;
      stays[b][e] = false;
      if (std::isfinite(strain[b][e])) lost += strain[b][e];
      if (!event.element) event.element = ElementRef{b, e};
      run_.result.eroded.push_back({k, run_.state.time, elementJson(run_.body.mesh(), ElementRef{b, e}),
                                    found[b][e].cause, found[b][e].value, strain[b][e]});
    }
  }
  event.value = static_cast<double>(run_.result.eroded.size() - before);
  const ErodedElement& first = run_.result.eroded[before];
  run_.result.events.push_back(
      {event, elementJson(run_.body.mesh(), event.element),
       fmt::format("{}: {} {:.6g}", eventText(event, run_.body.mesh()), first.cause, first.value)});
  run_.watch.end();
  run_.scheme.reset();
  const auto ofContact = [this] {
    const DiscreteForces* discrete = run_.body.discreteForces();
    return discrete ? discrete->energy(run_.state.x) : 0;
  };
  lost += ofContact();
  std::optional<DiscreteForces> discrete;
  if (DiscreteForces* all = run_.body.discreteForces()) {
    discrete.emplace(std::move(*all));
    run_.body.setDiscreteForces(DiscreteForces(run_.body.nodeCount()));
  }
  Body left(run_.body, stays);
  if (discrete) left.setDiscreteForces(std::move(*discrete));
  run_.body = std::move(left);
  renewSurfaceContact(run_.scene, run_.state.time, surfaces_, run_.body);
  lost -= ofContact();
  run_.state.a.resize(3, 0);
  run_.recorder.follow(run_.body.mesh());
  run_.probes.follow();
  run_.energies.beginBody();
  run_.energies.dissipate(lost);
  run_.scheme = std::make_unique<RunScheme>(run_.scene, run_.body, run_.result, run_.steps.step());
  run_.beginWatch();
  run_.watch.goOnWithEvents(k);
  run_.loads.begin(run_.state.x);
  // The energy balance of what is left starts here, however long it is to the next row.
  run_.recordEnergies();
}

}  // namespace ringwatch

#include <ringwatch/app/run/run_recorder.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include <ringwatch/app/output/report.h>
#include <ringwatch/app/output/step_reasons.h>
#include <ringwatch/app/run/checkpoint.h>
#include <ringwatch/app/scene/integrator_catalog.h>
#include <ringwatch/app/scene/scene_discrete.h>
#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/monitor/critical_step.h>
#include <ringwatch/monitor/incremental/work_account.h>

namespace ringwatch {

using Json = nlohmann::ordered_json;

double widthOfReasons(const Body& body, std::int64_t steps) {
  // Of the work of the steps, and work (WorkAccount) of some 35 ms, which nobody notices.
  constexpr double share = 0.1, unnoticed = 1e7;
  // One sweep of the nodal bound is that narrow, but for slivers, and the controlling element is the same.
  constexpr double coarse = 1;
  const double most = WorkAccount::ofShares(body, ExchangePolicy::iterations),
               ofSteps = static_cast<double>(steps) * WorkAccount::ofForce(body);
  return most <= std::max(unnoticed, share * ofSteps) ? ExchangePolicy::width : coarse;
}

void RunRecorder::follow(const Mesh& mesh) {
  materialOfBlock_ = materialOfBlocks(mesh);
  if (materialOfBlock_.empty() || result_.governing) return;
  RunResult::Governing governing;
  governing.observations.resize(scene_.materials.size());
  result_.governing = std::move(governing);
}

void RunRecorder::record(const MonitorReport& report, const Mesh& mesh) {
  recordEvents(report, mesh);
  recordGoverning(report);
}

void RunRecorder::recordEvents(const MonitorReport& report, const Mesh& mesh) {
  for (const MonitorEvent& event : report.newEvents) {
    result_.events.push_back({event, elementJson(mesh, event.element), eventText(event, mesh)});
    if (event.kind == EventKind::violated && !result_.firstViolated) result_.firstViolated = {event.step, event.time};
  }
}

void RunRecorder::recordGoverning(const MonitorReport& report) {
  if (!result_.governing || !report.fresh || !report.bracket) return;
  RunResult::Governing& governing = *result_.governing;
  const int material = materialOfBlock_[report.bracket->controlling.block];
  ++governing.observations[material];
  if (governing.leastSafe && !(report.bracket->safe < *governing.leastSafe)) return;
  governing.leastSafe = report.bracket->safe;
  governing.atLeastSafe = material;
}

void RunRecorder::recordDiscrete(const MonitorReport& report, const Body& body, NodeVectorsView x) {
  if (!result_.discrete) return;
  RunResult::Discrete& discrete = *result_.discrete;
  if (body.discreteForces()->hasContact()) {
    const DiscreteForces::ContactState state = body.discreteForces()->contactState(x);
    discrete.mostTouching = std::max(discrete.mostTouching, state.touching);
    if (state.deepest > discrete.deepest) {
      discrete.deepest = state.deepest;
      discrete.deepestTime = report.time;
      discrete.deepestNode = state.deepestNode;
      discrete.deepestObstacle = state.deepestObstacle;
    }
  }
  if (!report.fresh || !report.bracket || !(report.bracket->discreteShare > 0.5)) return;
  ++discrete.governed;
  if (!discrete.leastSafe || report.bracket->safe < *discrete.leastSafe) discrete.leastSafe = report.bracket->safe;
}

void RunRecorder::recordReasons(const MonitorReport& report, const Body& body, const State& state,
                                const StepRule& rule) {
  if (!report.fresh || !report.bracket || result_.violatedStepTaken || !scene_.handler.empty()) return;
  if (!result_.why.is_null() && report.bracket->safe >= result_.why["safe"].get<double>()) return;
  result_.why = stepReasons(body, state.x, rule, *integratorCatalog().find(scene_.method), *report.bracket);
  if (result_.why.is_null()) return;
  result_.why["step"] = report.step;
  result_.why["time"] = report.time;
  leastX_ = state.x;
  if (body.elementDamping()) leastV_ = state.v;
  leastElements_ = body.elementCount();
}

void RunRecorder::completeReasons(Body& body) {
  Json& why = result_.why;
  if (leastX_.cols() != body.nodeCount() || leastElements_ != body.elementCount()) return addParagraph(why);
  if (body.elementDamping()) body.followDampingRates(leastX_, leastV_);
  const IntegratorInfo& integrator = *integratorCatalog().find(scene_.method);
  // The monitor proves no more than the run's step needs; from scratch it is what inspect tells, where that takes no
  // more than a small part of the run. It is of another state where obstacles have moved on since, which shows where
  // the two brackets do not meet.
  const DampingRates rates = leastV_.isZero(0) ? DampingRates::atRest : DampingRates::followed;
  const StepRule rule = ruleAtOwnStep(scene_, body, rates, ownStepTolerance, stepOfTopMode(body, leastX_)).rule;
  const double width = widthOfReasons(body, result_.steps);
  CriticalStep step = criticalStep(body, leastX_, rule, {.width = width});
  // By the rule of the run, which is this one where nothing damps.
  const bool damped = body.elementDamping() || (body.discreteForces() && body.discreteForces()->damped());
  if (const double known = why["safe"]; width > ExchangePolicy::width && !damped && known <= step.optimistic)
    step.safe = std::max(step.safe, known);
  Json ofStep = stepReasons(body, leastX_, rule, integrator, step);
  if (const Json& most = why["optimistic"]; !ofStep.is_null() && (most.is_null() || step.safe <= most.get<double>())) {
    for (const char* key : {"step", "time"}) ofStep[key] = why[key];
    ofStep["watched_safe"] = why["safe"];
    why = std::move(ofStep);
  }
  addRemedies(why, body, leastX_, rule, integrator, StepWithout::guessed);
}

Json RunRecorder::save() const {
  return {{"x", binaryOf(leastX_)}, {"v", binaryOf(leastV_)}, {"elements", leastElements_}};
}

void RunRecorder::resume(const Json& saved) {
  leastX_ = vectorsOf(saved.at("x"));
  leastV_ = vectorsOf(saved.at("v"));
  leastElements_ = saved.at("elements").get<std::int64_t>();
}

void RunRecorder::countSteps(std::int64_t taken, double h) {
  result_.smallestStep = result_.steps == 0 ? h : std::min(result_.smallestStep, h);
  result_.largestStep = std::max(result_.largestStep, h);
  result_.steps += taken;
}

void RunRecorder::countVerdict(const MonitorReport& report, std::int64_t taken, bool first) {
  result_.worst = std::max(result_.worst.value_or(Verdict::certified), report.verdict);
  result_.violatedStepTaken = result_.violatedStepTaken || report.verdict == Verdict::violated;
  if (!scene_.proves()) return;
  result_.watchedSteps += taken;
  if (report.verdict == Verdict::certified) {
    result_.certifiedSteps += taken;
    if (first) result_.firstObservationSteps += taken;
  }
  if (!report.fresh || !report.bracket || !(report.bracket->safe > 0)) return;
  const double safe = report.bracket->safe;
  if (!result_.safeSeen) result_.safeSeen = {safe, safe};
  result_.safeSeen->least = std::min(result_.safeSeen->least, safe);
  result_.safeSeen->largest = std::max(result_.safeSeen->largest, safe);
}

void RunRecorder::noteWhatIsNotCertified(const Mesh& mesh) {
  if (result_.energyOff())
    result_.notes.emplace_back("the energy balance was off (see the events), so the run is not called stable");
  if (result_.certifiedSteps == result_.watchedSteps) return;
  std::string note = fmt::format("certified steps: {} of {}", result_.certifiedSteps, result_.watchedSteps);
  if (result_.safeSeen && scene_.step) {
    const auto [least, largest] = *result_.safeSeen;
    note += fmt::format("; the safe step was {:.4g} to {:.4g} s along the run", least, largest);
    // A run that has gone unstable ends in states that no useful step would have led to.
    constexpr double useful = 0.1;  // of the largest
    if (least > useful * largest) {
      // Rounded down, so that the number as it is printed is certified.
      const double unit = std::pow(10, std::floor(std::log10(least)) - 3);
      note += fmt::format(": a step of {:.4g} s would have been certified in these states",
                          std::floor(least / unit) * unit);
    }
  }
  if (static_cast<std::int64_t>(mesh.elementCount()) > MonitorOptions{}.firstObservationElements)
    note += fmt::format("; on more than {} elements inspect may prove a larger step than the run's first observation",
                        MonitorOptions{}.firstObservationElements);
  result_.notes.push_back(note);
}

}  // namespace ringwatch

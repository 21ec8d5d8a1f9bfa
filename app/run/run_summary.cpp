#include <ringwatch/app/run/run_summary.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <ringwatch/app/output/report.h>
#include <ringwatch/app/output/step_reasons.h>
#include <ringwatch/app/scene/body_notes.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/monitor/element_strain.h>

namespace ringwatch {
namespace {

/// Room above the largest step, as a factor, that is worth a word.
constexpr double worthTelling = 1.05;

using Json = nlohmann::ordered_json;

Json cutsJson(const RunResult& result) {
  Json json = Json::array();
  const auto bracket = [](const std::optional<CriticalStep>& step) {
    return step ? Json{{"safe", step->safe}, {"optimistic", step->optimistic}} : Json(nullptr);
  };
  for (const CutRecord& cut : result.cuts)
    json.push_back({{"step", cut.step},
                    {"time", cut.time},
                    {"elements", {{"before", cut.elementsBefore}, {"after", cut.elementsAfter}}},
                    {"elements_cut", cut.elementsCut},
                    {"nodes_added", cut.nodesAdded},
                    {"faces_opened", cut.facesOpened},
                    {"area", cut.area},
                    {"critical_step_at_most", cut.atMost},
                    {"critical_step", {{"before", bracket(cut.before)}, {"after", bracket(cut.after)}}},
                    {"kinetic", {{"before", cut.kineticBefore}, {"after", cut.kineticAfter}}},
                    {"handled_elements", {{"before", cut.handledBefore}, {"after", cut.handledAfter}}},
                    {"elements_examined", cut.selectionCost.elements},
                    {"element_evaluations", cut.selectionCost.evaluations},
                    {"cut_time", cut.cutTime},
                    {"selection_time", cut.selectionTime}});
  return json;
}

Json erosionJson(const Scene& scene, const RunResult& result) {
  if (!scene.erosion) return nullptr;
  Json elements = Json::array();
  double strain = 0;
  for (const ErodedElement& one : result.eroded) {
    elements.push_back({{"step", one.step},
                        {"time", one.time},
                        {"element", one.element},
                        {"cause", one.cause},
                        {"value", numberOrNull(one.value)},
                        {"strain", numberOrNull(one.strain)}});
    if (std::isfinite(one.strain)) strain += one.strain;
  }
  return {{"strain", strain}, {"elements", std::move(elements)}};
}

std::string erosionText(const Scene& scene, const Body& body, const RunResult& result) {
  if (!scene.erosion) return "";
  if (result.eroded.empty()) return "erosion: no element met a criterion\n";
  double strain = 0;
  for (const ErodedElement& one : result.eroded)
    if (std::isfinite(one.strain)) strain += one.strain;
  return fmt::format("erosion: {} of {} elements left, the first, {} {}, at t = {:.6g} s; they took {:.4g} J along\n",
                     result.eroded.size(), result.eroded.size() + body.mesh().elementCount(),
                     result.eroded.front().element["type"].get<std::string>(),
                     result.eroded.front().element["id"].get<std::int64_t>(), result.eroded.front().time, strain);
}

Json probesJson(const RunResult& result) {
  Json json = Json::array();
  for (const ProbeColumn& column : result.probes)
    json.push_back({{"column", column.name}, {"unit", column.unit}, {"help", column.help}});
  return json;
}

Json handlerJson(const Scene& scene, const RunResult& result) {
  if (!result.handler) return nullptr;
  Json json{{"method", scene.handler},
            {"selection", std::string(selectionNames.nameOf(scene.handlerOptions.selection))},
            {"handled_elements", result.handler->elements},
            {"explicit_part_certified", result.handler->certified},
            {"selections", result.handler->selections},
            {"element_evaluations", result.handler->evaluations}};
  for (const HandlerFigure& figure : result.handler->figures) json[figure.name] = figure.value;
  return json;
}

/// The materials with what they are of, and which of them governs the bracket.
Json materialsJson(const Scene& scene, const Body& body, const RunResult& result) {
  const std::vector<int> ofBlocks = materialOfBlocks(body.mesh());
  Json json = Json::array();
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    std::size_t elements = 0;
    double mass = 0, nodal[maxElementNodes];
    for (std::size_t b = 0; b < body.blocks().size(); ++b) {
      if (!ofBlocks.empty() && ofBlocks[b] != static_cast<int>(m)) continue;
      elements += body.mesh().blocks[b].elementCount();
      for (std::int32_t e = 0; e < body.blocks()[b]->elementCount(); ++e) {
        body.elementLumpedMass({b, e}, nodal);
        for (int a = 0; a < body.blocks()[b]->nodesPerElement(); ++a) mass += nodal[a];
      }
    }
    json.push_back(
        {{"number", m},
         {"selection", scene.materials[m].selection()},
         {"model", scene.materials[m].model},
         {"elements", elements},
         {"mass", mass},
         {"governed_observations", result.governing ? Json(result.governing->observations[m]) : Json(nullptr)}});
  }
  return json;
}

Json rigidBodiesJson(const Body& body) {
  Json json = Json::array();
  for (const std::vector<RigidBody>* bodies :
       {&body.constraints().rigidBodies(), &body.constraints().prescribedBodies()})
    for (const RigidBody& rigid : *bodies)
      json.push_back({{"name", rigid.name()}, {"nodes", rigid.nodes().size()}, {"mass", rigid.mass()}});
  return json;
}

std::string materialText(const Scene& scene, int number) {
  return fmt::format("material {} ({}, {})", number, scene.materials[number].selection(),
                     scene.materials[number].model);
}

/// Which material governs the bracket; "" where nothing is known of it.
std::string governingText(const Scene& scene, const RunResult& result) {
  if (!result.governing || !result.governing->leastSafe) return "";
  const RunResult::Governing& governing = *result.governing;
  std::string text = fmt::format("{} governs: the least safe step, {:.4g} s, is that of one of its elements",
                                 materialText(scene, governing.atLeastSafe), *governing.leastSafe);
  for (std::size_t m = 0; m < governing.observations.size(); ++m)
    if (static_cast<int>(m) != governing.atLeastSafe && governing.observations[m] > 0)
      text += fmt::format("; {} did at {} observations", materialText(scene, static_cast<int>(m)),
                          governing.observations[m]);
  return text + "\n";
}

/// What a node came deepest into.
std::string touchedName(const Scene& scene, std::size_t obstacle) {
  return obstacle == DiscreteForces::ofSurface ? "surface" : scene.obstacles[obstacle].name;
}

/// Springs and contact: what they came to, and how far penalties could grow.
Json discreteJson(const Scene& scene, const Body& body, const RunResult& result) {
  if (!result.discrete) return nullptr;
  const RunResult::Discrete& discrete = *result.discrete;
  std::size_t nodes = 0;
  double least = infinity, largest = 0;
  const auto count = [&](double penalty) {
    least = std::min(least, penalty);
    largest = std::max(largest, penalty);
  };
  for (const PenaltyContact& contact : body.discreteForces()->contacts()) {
    nodes += contact.nodes.size();
    for (const double penalty : contact.penalty) count(penalty);
  }
  for (const SurfaceSearch& surface : body.discreteForces()->surfaces()) {
    nodes += surface.contact().nodes.size();
    for (const double penalty : surface.contact().penalty) count(penalty);
    for (const SurfaceContact::Edge& edge : surface.contact().edges) count(edge.penalty);
  }
  Json json{{"springs", body.discreteForces()->springs().size()},
            {"contact_nodes", nodes},
            {"penalty", nodes > 0 ? Json{{"least", least}, {"largest", largest}} : Json(nullptr)},
            {"most_touching", discrete.mostTouching},
            {"deepest", nullptr},
            {"governed_observations", discrete.governed},
            {"least_safe", discrete.leastSafe ? Json(*discrete.leastSafe) : Json(nullptr)},
            {"room", nullptr}};
  if (discrete.deepestNode >= 0)
    json["deepest"] = {{"depth", discrete.deepest},
                       {"time", discrete.deepestTime},
                       {"node_id", body.mesh().nodeId(discrete.deepestNode)},
                       {"obstacle", touchedName(scene, discrete.deepestObstacle)}};
  if (discrete.room)
    json["room"] = {
        {"elements_alone", discrete.room->elementsAlone},
        {"share", discrete.room->share},
        {"penalty", discrete.room->penalty},
        {"penalty_at_step", discrete.room->penaltyAtStep ? Json(*discrete.room->penaltyAtStep) : Json(nullptr)}};
  return json;
}

std::string discreteText(const Scene& scene, const Body& body, const RunResult& result) {
  if (!result.discrete) return "";
  const RunResult::Discrete& discrete = *result.discrete;
  std::string text;
  if (!scene.contacts.empty())
    text += discrete.deepestNode < 0
                ? scene.obstacles.empty() ? "contact: no node touched a surface\n"
                                          : "contact: no node touched an obstacle\n"
                : fmt::format("contact: at most {} nodes touched, node {} came {:.4g} m deep into {} at t = {:.4g} s\n",
                              discrete.mostTouching, body.mesh().nodeId(discrete.deepestNode), discrete.deepest,
                              touchedName(scene, discrete.deepestObstacle), discrete.deepestTime);
  if (discrete.governed == 0) return text;
  text += fmt::format("springs or contact govern at {} observations, where the least safe step is {:.4g} s",
                      discrete.governed, *discrete.leastSafe);
  if (discrete.room)
    text +=
        fmt::format("; a penalty of {:.4g} N/m leaves {:.4g} % of the {:.4g} s that the elements at rest prove alone",
                    discrete.room->penalty, 100 * discrete.room->share, discrete.room->elementsAlone);
  return text + "\n";
}

Json trafficJson(const RunResult& result) {
  if (!result.traffic) return nullptr;
  const RunResult::Traffic& traffic = *result.traffic;
  return {{"ranks", traffic.ranks},
          {"exchanges", traffic.exchanges},
          {"messages", traffic.messages},
          {"bytes", traffic.bytes},
          {"bytes_by_model", traffic.bytesByModel},
          {"hidden", traffic.hidden ? Json(*traffic.hidden) : Json()},
          {"waited", traffic.waited}};
}

/// ": 0.12 times the force"; "" where one of both took no time.
std::string monitorOverForce(const RunResult& result) {
  if (!(result.forceTime > 0) || !(result.monitorTime > 0)) return {};
  return fmt::format(": {:.2g} times the force", result.monitorTime / result.forceTime);
}

/// What the run proved, what limited its step, and whether a handler pays.
std::string conclusionOf(const Scene& scene, const RunResult& result) {
  // Of an indefinite tangent only what a step does to the highest frequency is proven.
  const std::string_view proven = result.happened(EventKind::indefinite)
                                      ? "safe for the highest frequency, which is all that is proven where the "
                                        "tangent is indefinite"
                                      : "proven stable";
  std::string text = result.watchedSteps == 0 ? std::string("no step was proven stable")
                     : result.certifiedSteps == result.watchedSteps
                         ? fmt::format("every step was {}", proven)
                         : fmt::format("{} of {} steps were {}", result.certifiedSteps, result.watchedSteps, proven);
  if (scene.every > 1 && result.certifiedSteps > 0)
    text += fmt::format(" at the states that are observed, one in {}", scene.every);
  if (result.firstViolated) text += fmt::format(", step {} is proven unstable", result.firstViolated->step);
  if (result.verdict() == "unstable")
    text += fmt::format(", {} {}", result.firstViolated ? "and" : "but",
                        result.runaway       ? "the energy ran away"
                        : result.energyOff() ? "the energy balance is off"
                                             : result.reasonText);
  if (result.reason == ExitReason::stepCollapsed) text += ", but " + result.reasonText;
  if (result.handler) return text + fmt::format("; {} took {} elements", scene.handler, result.handler->elements);
  if (const std::string limit = limitText(result.why); !limit.empty()) text += "; " + limit;
  const double room = result.certified() && result.safeSeen ? result.safeSeen->least / result.largestStep : 0;
  if (std::isfinite(room) && room > worthTelling && result.reason == ExitReason::end)
    text += fmt::format("; the run could have been {:.3g} times shorter", room);
  return text;
}

Json momentJson(const std::optional<RunResult::Moment>& moment) {
  if (!moment) return nullptr;
  return Json{{"step", moment->step}, {"time", moment->time}};
}

Json diagnosisJson(const ElementCause& cause) {
  const ElementShape& shape = cause.shape;
  return Json{{"strain", std::string(elementStrainNames.nameOf(strainOf(cause)))},
              {"determinant", numberOrNull(cause.leastDeterminant)},
              {"largest_stretch", numberOrNull(cause.largestStretch)},
              {"least_stretch", numberOrNull(cause.leastStretch)},
              {"shape", std::string(shapeName(shape.shape))},
              {"badly_shaped", cause.badlyShaped()},
              {"least_dihedral", numberOrNull(shape.minDihedral)},
              {"largest_dihedral", numberOrNull(shape.maxDihedral)},
              {"aspect", numberOrNull(shape.aspect)}};
}

}  // namespace

Json summaryJson(const Scene& scene, const Body& body, const RunResult& result) {
  Json events = Json::array();
  for (const RunEvent& found : result.events) {
    const MonitorEvent& event = found.event;
    events.push_back(Json{{"kind", std::string(eventName(event.kind))},
                          {"step", event.step},
                          {"time", event.time},
                          {"end_step", event.end ? Json(*event.end) : Json(nullptr)},
                          {"element", found.element},
                          {"handled", event.handled},
                          {"cause", event.cause ? Json(causeText(*event.cause)) : Json(nullptr)},
                          {"diagnosis", event.cause ? diagnosisJson(*event.cause) : Json(nullptr)},
                          {"value", event.value},
                          {"discrete_share", event.discreteShare},
                          {"text", found.text}});
  }
  return Json{
      {"program", "ringwatch"},
      {"version", std::string(programVersion())},
      {"scene_file", scene.file.string()},
      {"scene", scene.echo},
      {"mesh", meshJson(body.mesh(), body.volume())},
      {"mass", body.totalMass()},
      {"body", bodyFigures(body).json()},
      {"materials", materialsJson(scene, body, result)},
      {"rigid_bodies", rigidBodiesJson(body)},
      {"governing_material",
       result.governing && result.governing->leastSafe ? Json(result.governing->atLeastSafe) : Json(nullptr)},
      {"verdict", std::string(result.verdict())},
      {"stable", result.stable()},
      {"exit_status", static_cast<int>(result.exitStatus())},
      {"conclusion", conclusionOf(scene, result)},
      {"certified", result.watchedSteps > 0 ? Json(result.certified()) : Json(nullptr)},
      {"certified_steps", result.certifiedSteps},
      {"watched_steps", result.watchedSteps},
      {"safe_seen", result.safeSeen ? Json{{"least", result.safeSeen->least}, {"largest", result.safeSeen->largest}}
                                    : Json(nullptr)},
      {"why", result.why},
      {"exit_reason", std::string(exitReasonName(result.reason))},
      {"exit_text", result.reasonText},
      {"steps", result.steps},
      {"end_time", result.time},
      {"handler", handlerJson(scene, result)},
      {"cuts", cutsJson(result)},
      {"erosion", erosionJson(scene, result)},
      {"repeats", result.repeats
                      ? Json{{"count", result.repeats->count}, {"dropped_steps", result.repeats->droppedSteps}}
                      : Json(nullptr)},
      {"probes", probesJson(result)},
      {"discrete_forces", discreteJson(scene, body, result)},
      {"smallest_step", result.smallestStep},
      {"largest_step", result.largestStep},
      {"first_violated", momentJson(result.firstViolated)},
      {"energy_runaway", momentJson(result.runaway)},
      {"events", std::move(events)},
      {"wall_time",
       {{"total", result.wallTime},
        {"force", result.forceTime},
        {"monitor", result.monitorTime},
        {"output", result.outputTime}}},
      {"traffic", trafficJson(result)},
      {"frames", result.frames},
      {"files", result.files},
      {"notes", result.notes}};
}

std::string summaryText(const Scene& scene, const Body& body, const RunResult& result,
                        const std::filesystem::path& folder, const std::string& page) {
  std::string text = fmt::format("{}: {} nodes, {}, {:.6g} kg, {}\n", scene.file.string(), body.mesh().nodeCount(),
                                 elementCounts(body.mesh()), body.totalMass(), scene.method);
  text += fmt::format("{}\n", bodyFigures(body).text());
  text += fmt::format(
      "{} steps to t = {:.6g} s, {}; {:.2f} seconds of wall time (force {:.2f}, monitor {:.2f}{}, output {:.2f})\n",
      result.steps, result.time, result.reasonText, result.wallTime, result.forceTime, result.monitorTime,
      monitorOverForce(result), result.outputTime);
  if (result.steps > 0)
    text += result.smallestStep == result.largestStep
                ? fmt::format("step {:.6g} s, ", result.smallestStep)
                : fmt::format("steps {:.6g} to {:.6g} s, ", result.smallestStep, result.largestStep);
  text += fmt::format("verdict {}", result.verdict());
  if (result.watchedSteps > 0)
    text += fmt::format(", certified at {} of {} steps{}{}", result.certifiedSteps, result.watchedSteps,
                        result.happened(EventKind::indefinite) ? " for the highest frequency alone" : "",
                        scene.every > 1 ? fmt::format(", of which one in {} is observed", scene.every) : "");
  if (result.repeats && result.repeats->count > 0)
    text += fmt::format(", after going back {} time{}, by {} steps", result.repeats->count,
                        result.repeats->count == 1 ? "" : "s", result.repeats->droppedSteps);
  text += "\n" + governingText(scene, result) + discreteText(scene, body, result) + erosionText(scene, body, result) +
          reasonsText(result.why, "", "\n");
  if (result.handler) {
    text += fmt::format("handler {}: {} of {} elements", scene.handler, result.handler->elements,
                        body.mesh().elementCount());
    for (const HandlerFigure& figure : result.handler->figures)
      text += fmt::format(", {} {:.4g}", figure.name, figure.value);
    text += "\n";
  }
  for (const CutRecord& cut : result.cuts) {
    text += fmt::format("cut at t = {:.6g} s: {} of {} elements cut, {} now", cut.time, cut.elementsCut,
                        cut.elementsBefore, cut.elementsAfter);
    // An implicit scheme has no critical step.
    if (std::isfinite(cut.atMost)) {
      text += fmt::format("; they leave a critical step of at most {:.4g} s", cut.atMost);
      if (cut.before && cut.after)
        text += fmt::format(", that of all is {:.4g} s, before {:.4g} s", cut.after->safe, cut.before->safe);
    }
    if (result.handler)
      text += fmt::format("; {} handled, {} before, {} examined in {:.3g} ms", cut.handledAfter, cut.handledBefore,
                          cut.selectionCost.elements, 1e3 * cut.selectionTime);
    text += "\n";
  }
  // The first few events; all of them are in summary.json.
  constexpr std::size_t most = 6;
  for (std::size_t i = 0; i < result.events.size() && i < most; ++i)
    text += fmt::format("  {}\n", result.events[i].text);
  if (result.events.size() > most) text += fmt::format("  and {} more events\n", result.events.size() - most);
  if (result.runaway)
    text += fmt::format("  step {}, t = {:.6g} s: the energy ran away\n", result.runaway->step, result.runaway->time);
  for (const std::string& note : result.notes) text += fmt::format("note: {}\n", note);
  if (result.neverCertified() && result.exitStatus() != ExitStatus::done)
    text += fmt::format("not certified: exit status {}\n", static_cast<int>(result.exitStatus()));
  std::string files;
  for (const std::string& file : result.files) files += (files.empty() ? "" : ", ") + file;
  return text + fmt::format("wrote to {}: {}\n", folder.string(), files) + page +
         conclusionLine(conclusionOf(scene, result));
}

}  // namespace ringwatch

#include <ringwatch/app/run/saved_result.h>

#include <algorithm>

#include <fmt/format.h>

#include <ringwatch/app/run/checkpoint.h>
#include <ringwatch/base/archive.h>
#include <ringwatch/base/error.h>
#include <ringwatch/body/discrete_forces.h>

namespace ringwatch {
namespace {

using Json = nlohmann::ordered_json;

// Written and read by the same version of the program.
Json causeJson(std::optional<ElementCause> cause) {
  if (!cause) return nullptr;
  SavingArchive archive;
  archive(*cause);
  const std::string bytes = archive.take();
  return Json::binary({bytes.begin(), bytes.end()});
}

std::optional<ElementCause> causeOf(const Json& json) {
  if (json.is_null()) return std::nullopt;
  const auto& bytes = json.get_binary();
  LoadingArchive archive({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  ElementCause cause;
  archive(cause);
  archive.end();
  return cause;
}

Json eventJson(const RunEvent& told) {
  const MonitorEvent& event = told.event;
  return {{"kind", std::string(eventName(event.kind))},
          {"step", event.step},
          {"time", event.time},
          {"value", event.value},
          {"h", event.h},
          {"tangent", event.tangent},
          {"discrete_share", event.discreteShare},
          {"element_ref", event.element ? Json{event.element->block, event.element->element} : Json(nullptr)},
          {"cause", causeJson(event.cause)},
          {"end", optionalJson(event.end)},
          {"element", told.element},
          {"text", told.text}};
}

RunEvent eventOf(const Json& json) {
  RunEvent told;
  MonitorEvent& event = told.event;
  event.kind = eventNames.valueOf("checkpoint", json.at("kind").get<std::string>());
  event.step = json.at("step").get<std::int64_t>();
  event.time = json.at("time").get<double>();
  event.value = json.at("value").get<double>();
  event.h = json.at("h").get<double>();
  event.tangent = json.at("tangent").get<bool>();
  event.discreteShare = json.at("discrete_share").get<double>();
  if (const Json& ref = json.at("element_ref"); !ref.is_null())
    event.element = ElementRef{ref.at(0).get<std::int32_t>(), ref.at(1).get<std::int32_t>()};
  event.cause = causeOf(json.at("cause"));
  event.end = optionalOf<std::int64_t>(json.at("end"));
  told.element = json.at("element");
  told.text = json.at("text").get<std::string>();
  return told;
}

/// Numbers that others are found by: of a file that was changed they could point anywhere.
std::int64_t below(std::size_t count, const Json& json, std::int64_t least = 0) {
  const auto number = json.get<std::int64_t>();
  if (number < least || number >= static_cast<std::int64_t>(count))
    throw InputError(
        fmt::format("{} where {} to {} can be meant", number, least, static_cast<std::int64_t>(count) - 1));
  return number;
}

Json savedMoment(const std::optional<RunResult::Moment>& moment) {
  return moment ? Json{moment->step, moment->time} : Json(nullptr);
}

Json discreteJson(const std::optional<RunResult::Discrete>& discrete) {
  if (!discrete) return nullptr;
  return {{"governed", discrete->governed},
          {"least_safe", optionalJson(discrete->leastSafe)},
          {"most_touching", discrete->mostTouching},
          {"deepest", discrete->deepest},
          {"deepest_time", discrete->deepestTime},
          {"deepest_node", discrete->deepestNode},
          {"deepest_obstacle", discrete->deepestObstacle}};
}

std::optional<RunResult::Discrete> discreteOf(const Json& json, const Scene& scene, std::size_t nodes) {
  if (json.is_null()) return std::nullopt;
  RunResult::Discrete discrete;
  discrete.governed = json.at("governed").get<std::int64_t>();
  discrete.leastSafe = optionalOf<double>(json.at("least_safe"));
  discrete.mostTouching = json.at("most_touching").get<std::int64_t>();
  discrete.deepest = json.at("deepest").get<double>();
  discrete.deepestTime = json.at("deepest_time").get<double>();
  discrete.deepestNode = static_cast<std::int32_t>(below(nodes, json.at("deepest_node"), -1));
  const Json& obstacle = json.at("deepest_obstacle");
  discrete.deepestObstacle =
      obstacle == DiscreteForces::ofSurface
          ? DiscreteForces::ofSurface
          : static_cast<std::size_t>(below(std::max<std::size_t>(scene.obstacles.size(), 1), obstacle));
  return discrete;
}

}  // namespace

Json savedResult(const RunResult& result) {
  Json events = Json::array();
  for (const RunEvent& event : result.events) events.push_back(eventJson(event));
  Json governing = nullptr;
  if (result.governing)
    governing = Json{{"observations", result.governing->observations},
                     {"least_safe", optionalJson(result.governing->leastSafe)},
                     {"at_least_safe", result.governing->atLeastSafe}};
  return {{"steps", result.steps},
          {"smallest_step", result.smallestStep},
          {"largest_step", result.largestStep},
          {"worst", result.worst ? Json(std::string(verdictName(*result.worst))) : Json(nullptr)},
          {"violated_step_taken", result.violatedStepTaken},
          {"watched_steps", result.watchedSteps},
          {"certified_steps", result.certifiedSteps},
          {"first_observation_steps", result.firstObservationSteps},
          {"safe_seen", result.safeSeen ? Json{result.safeSeen->least, result.safeSeen->largest} : Json(nullptr)},
          {"first_violated", savedMoment(result.firstViolated)},
          {"why", result.why},
          {"repeats", result.repeats ? Json{result.repeats->count, result.repeats->droppedSteps} : Json(nullptr)},
          {"events", std::move(events)},
          {"governing", std::move(governing)},
          {"discrete", discreteJson(result.discrete)},
          {"times", {result.forceTime, result.monitorTime, result.outputTime, result.wallTime}},
          {"notes", result.notes}};
}

Verdict savedVerdict(const Json& json) { return verdictNames.valueOf("checkpoint", json.get<std::string>()); }

void resumeResult(const Json& saved, const Scene& scene, std::size_t nodes, RunResult& result) {
  const auto count = [&](const char* key) { return saved.at(key).get<std::int64_t>(); };
  result.steps = count("steps");
  result.smallestStep = saved.at("smallest_step").get<double>();
  result.largestStep = saved.at("largest_step").get<double>();
  if (const Json& worst = saved.at("worst"); !worst.is_null()) result.worst = savedVerdict(worst);
  result.violatedStepTaken = saved.at("violated_step_taken").get<bool>();
  result.watchedSteps = count("watched_steps");
  result.certifiedSteps = count("certified_steps");
  result.firstObservationSteps = count("first_observation_steps");
  if (const Json& seen = saved.at("safe_seen"); !seen.is_null())
    result.safeSeen = {seen.at(0).get<double>(), seen.at(1).get<double>()};
  if (const Json& moment = saved.at("first_violated"); !moment.is_null())
    result.firstViolated = {moment.at(0).get<std::int64_t>(), moment.at(1).get<double>()};
  result.why = saved.at("why");
  if (const Json& repeats = saved.at("repeats"); !repeats.is_null())
    result.repeats = {repeats.at(0).get<std::int64_t>(), repeats.at(1).get<std::int64_t>()};
  result.events.clear();
  for (const Json& event : saved.at("events")) result.events.push_back(eventOf(event));
  if (const Json& governing = saved.at("governing"); !governing.is_null()) {
    result.governing = {governing.at("observations").get<std::vector<std::int64_t>>(),
                        optionalOf<double>(governing.at("least_safe")),
                        static_cast<int>(below(scene.materials.size(), governing.at("at_least_safe")))};
    result.governing->observations.resize(scene.materials.size());
  }
  result.discrete = discreteOf(saved.at("discrete"), scene, nodes);
  const Json& times = saved.at("times");
  result.forceTime += times.at(0).get<double>();
  result.monitorTime += times.at(1).get<double>();
  result.outputTime += times.at(2).get<double>();
  result.wallTime += times.at(3).get<double>();
  result.notes = saved.at("notes").get<std::vector<std::string>>();
}

}  // namespace ringwatch

#include <ringwatch/app/output/step_reasons.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include <fmt/format.h>

#include <ringwatch/app/output/elements_in_the_way.h>
#include <ringwatch/app/output/report.h>
#include <ringwatch/app/scene/capabilities.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/monitor/element_cause.h>
#include <ringwatch/monitor/metrics/wave_metrics.h>

namespace ringwatch {
namespace {

using Json = nlohmann::ordered_json;

/// What counts as making a step small, as a factor of the step or of the wave speed.
constexpr double worthNaming = 1.25;
/// The share of the top mode's energy whose loss is worth naming.
constexpr double worthShare = 1 - 1 / (worthNaming * worthNaming);
/// Sides of a bracket that only contact which can begin puts so far apart.
constexpr double openBracket = 1.5;
/// Of the median element's own step: elements below are few in a mesh that is even.
constexpr double smallShare = 0.5;
/// Where none is below, one of so many that are the worst.
constexpr std::size_t worstOf = 100;
/// Elements of the largest body whose rings are evaluated for this alone, at some 20 µs each, and of the largest that
/// gets a bracket of its own without those in the way, at up to 0.4 ms each.
constexpr std::size_t mostRings = 20000, mostBracketed = 5000;
constexpr std::string_view ringMetric = "reduced-1-ring";
/// Gain of the step from which a remedy is worth a word.
constexpr double worthDoing = 1.05;
/// Poisson's ratio of most solids.
constexpr double usualPoisson = 0.3;

/// (λ + 2μ) / E.
double wavesOverYoung(double poisson) { return (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson)); }

double slowestWave(const Body& body) {
  double slowest = infinity;
  for (const auto& block : body.blocks())
    if (block->elementCount() > 0) slowest = std::min(slowest, block->material().waveSpeed());
  return slowest;
}

/// An element and the step of its ring.
struct OwnStep {
  double step;  // s
  ElementRef element;
};

/// Of the elements that have one, least first. Those without stiffness, of rigid parts and held ones, have none.
std::vector<OwnStep> ownSteps(const MetricResult& metric, const StepRule& rule) {
  std::vector<OwnStep> steps;
  for (std::size_t b = 0; b < metric.elementLambda.size(); ++b)
    for (std::size_t e = 0; e < metric.elementLambda[b].size(); ++e)
      if (const double lambda = metric.elementLambda[b][e], step = rule(lambda);
          lambda > 0 && step > 0 && std::isfinite(step))
        steps.push_back({step, {static_cast<std::int32_t>(b), static_cast<std::int32_t>(e)}});
  std::ranges::sort(steps, {}, [](const OwnStep& own) { return std::pair(own.step, own.element); });
  return steps;
}

/// Mass that about gives elements of smaller own steps the step h (s): their nodes get as much more as the ring's
/// eigenvalue is too large.
Json massFor(const Body& body, const StepRule& rule, const MetricResult& ring, const std::vector<ElementRef>& small,
             double h) {
  const double allowed = rule.lambdaFor(h);
  const std::vector<int> materials = materialOfBlocks(body.mesh());
  std::map<std::int32_t, double> factors;
  std::set<int> numbers;
  for (const ElementRef e : small) {
    if (!materials.empty()) numbers.insert(materials[e.block]);
    for (const std::int32_t node : body.blocks()[e.block]->nodesOf(e.element)) {
      double& factor = factors.try_emplace(node, 1).first->second;
      factor = std::max(factor, ring.elementLambda[e.block][e.element] / allowed);
    }
  }
  double added = 0;
  for (const auto& [node, factor] : factors) added += (factor - 1) * body.lumpedMass()[node];
  return Json{{"added", added},
              {"share", added / body.totalMass()},
              {"by_command", takesBody(SceneUse::scaleMass, body)},
              {"materials", numbers}};
}

/// The mass of the nodes of an element over that of their elements, at the node where least was added.
double massFactor(const Body& body, ElementRef element) {
  std::map<std::int32_t, double> own;
  for (const std::int32_t node : body.blocks()[element.block]->nodesOf(element.element)) own[node] = 0;
  std::vector<double> mass;
  for (std::size_t b = 0; b < body.blocks().size(); ++b)
    for (std::int32_t e = 0; e < body.blocks()[b]->elementCount(); ++e) {
      const ElementRef one(b, e);
      const auto nodes = body.blocks()[b]->nodesOf(one.element);
      if (std::ranges::none_of(nodes, [&](std::int32_t node) { return own.contains(node); })) continue;
      mass.resize(nodes.size());
      body.elementLumpedMass(one, mass.data());
      for (std::size_t a = 0; a < nodes.size(); ++a)
        if (const auto known = own.find(nodes[a]); known != own.end()) known->second += mass[a];
    }
  double least = infinity;
  for (const auto& [node, of] : own) least = std::min(least, body.lumpedMass()[node] / of);
  return least;
}

/// A sentence on each fault.
std::string faultText(StepFault fault, const Json& why) {
  const auto number = [&](const char* key) { return why[key].get<double>(); };
  switch (fault) {
    case StepFault::penalty:
      if (!(number("discrete_share") > worthShare))
        return "Contact that can begin counts as if it touched already: a softer penalty gives a larger step.";
      return fmt::format(
          "Springs or contact hold {:.0f} % of the energy of the top mode: a softer penalty, or softer springs, give a "
          "larger step.",
          100 * number("discrete_share"));
    case StepFault::damping:
      return fmt::format("Damping takes {:.0f} % of the step{}.", 100 * number("damping_share"),
                         why["undamped_step"].is_null()
                             ? ""
                             : fmt::format(": less of it gives up to about {:.3g} s", number("undamped_step")));
    case StepFault::poisson:
      return fmt::format("Poisson's ratio {:.4g} makes these waves {:.2g} times as fast as {} would.",
                         number("poisson"), number("poisson_factor"), usualPoisson);
    case StepFault::material:
      return fmt::format("Its material has fast waves, those of another run at {:.4g} m/s.", number("slowest_wave"));
    case StepFault::strain:
    case StepFault::shape:
    case StepFault::size:
      break;  // said with the element
  }
  return {};
}

bool has(const Json& why, StepFault fault) {
  const Json& faults = why["faults"];
  return std::find(faults.begin(), faults.end(), stepFaultNames.nameOf(fault)) != faults.end();
}
/// Whether springs, contact or dashpots set the step, which no other elements cure.
bool isDiscrete(const Json& why) {
  return has(why, StepFault::penalty) || why["discrete_share"].get<double>() > worthShare;
}

/// What the element is like, beside the others.
std::string elementSentence(const Json& why) {
  std::string text = fmt::format("Its state: {}", why["cause"].get<std::string>());
  if (!why["median_step"].is_null() && !why["own_step"].is_null())
    text +=
        fmt::format("; with its neighbours it allows {:.4g} s (the median element {:.2g} times as much)",
                    why["own_step"].get<double>(), why["median_step"].get<double>() / why["own_step"].get<double>());
  return text + ".";
}

std::vector<std::string> remedySentences(const Json& why) {
  const Json& remesh = why["remesh"];
  if (remesh.is_null()) {
    if (why["median_step"].is_null() || isDiscrete(why)) return {};
    return {
        "No few elements are in the way: a larger step takes larger elements, slower waves or an implicit integrator."};
  }
  const auto few = remesh["elements"].get<std::size_t>(), all = why["elements"].get<std::size_t>();
  const double share = static_cast<double>(few) / static_cast<double>(all), step = remesh["step"];
  const std::string shapes = remesh["shapes"];
  std::vector<std::string> sentences{
      fmt::format("Remesh {} of {} elements ({}{}): without them {:.4g} s is {}, {:.3g} times as much.", few, all,
                  shapes.empty() ? "" : shapes + "; ", remesh["numbers"].get<std::string>(), step,
                  remesh["proven"] ? "proven" : "about what is left", step / why["safe"].get<double>())};
  const Json &mass = why["mass"], &materials = mass["materials"];
  std::string more = fmt::format("Or add some {:.2g} kg to them, {:.2g} % of the mass{} ({})",
                                 mass["added"].get<double>(), 100 * mass["share"].get<double>(),
                                 materials.size() == 1 ? fmt::format(", in material {}", materials[0].get<int>()) : "",
                                 mass["by_command"].get<bool>() ? "ringwatch scale-mass" : "[[mass]] of a scene");
  if (!why["handler"].is_null())
    more += fmt::format(", or take handler.method = \"{}\"{}", why["handler"].get<std::string>(),
                        share <= fewInTheWay ? "; ringwatch advise measures what pays" : std::string(shareText(share)));
  sentences.push_back(more + ".");
  return sentences;
}

void tell(Json& why) {
  std::string where;
  if (why.contains("step")) {
    where = fmt::format(", at step {}, t = {:.6g} s", why["step"].get<std::int64_t>(), why["time"].get<double>());
    if (const double safe = why["safe"], watched = why.value("watched_safe", safe); watched != safe)
      where += fmt::format(" (from scratch; the history has {:.4g} s there)", watched);
  }
  const double height = why["height"], speed = why["wave_speed"];
  Json text = Json::array();
  text.push_back(fmt::format(
      "Why {:.4g} s{}: pressure waves run at {:.4g} m/s and cross element {} ({}), {:.4g} m high, in {:.3g} s, a step "
      "of {:.3g} s by rule of thumb.",
      why["safe"].get<double>(), where, speed, why["element"]["id"].get<std::int64_t>(),
      why["element"]["type"].get<std::string>(), height, height / speed, why["wave_step"].get<double>()));
  text.push_back(elementSentence(why));
  for (const auto& fault : stepFaultNames)
    if (has(why, fault.value))
      if (std::string sentence = faultText(fault.value, why); !sentence.empty()) text.push_back(std::move(sentence));
  why["text"] = std::move(text);
  why["remedies"] = remedySentences(why);
}

void clearRemedies(Json& why) {
  for (const char* key : {"own_step", "median_step", "without_element", "remesh", "mass", "handler"})
    why[key] = nullptr;
}

}  // namespace

Json stepReasons(const Body& body, NodeVectorsView x, const StepRule& rule, const IntegratorInfo& integrator,
                 const CriticalStep& step) {
  if (!(step.safe > 0) || !std::isfinite(step.safe)) return nullptr;
  const ElementRef element = step.controlling;
  const ElementBlock& block = *body.blocks()[element.block];
  const Material& material = block.material();
  const double speed = material.waveSpeed(), slowest = slowestWave(body),
               height = characteristicLength(block.element(), x, block.nodesOf(element.element),
                                             CharacteristicLength::usual),
               lambda = rule.lambdaFor(step.safe), ofDamping = step.dampingShare * lambda,
               undamped = stepFor(lambda - ofDamping, integrator.imaginaryLimit),
               damped = rule.optimistic({lambda, ofDamping, ofDamping});
  const Lame rest = material.restModuli();
  const double poisson = 0.5 * rest.lambda / (rest.lambda + rest.mu),
               faster = std::sqrt(wavesOverYoung(poisson) / wavesOverYoung(usualPoisson)),
               damping = 1 - damped / undamped, ofSprings = step.discreteShare - step.dampingShare;
  const ElementCause cause = elementCause(body, x, element);
  Json faults = Json::array();
  const auto blame = [&](StepFault fault, bool guilty) {
    if (guilty) faults.push_back(std::string(stepFaultNames.nameOf(fault)));
  };
  blame(StepFault::penalty, ofSprings > worthShare || (body.discreteForces() && body.discreteForces()->hasContact() &&
                                                       step.optimistic > openBracket * step.safe));
  blame(StepFault::damping, worthNaming * damped < undamped);
  blame(StepFault::strain, !cause.finite || cause.leastDeterminant <= 0 ||
                               std::max(cause.largestStretch, 1 / cause.leastStretch) >= worthNaming);
  blame(StepFault::shape, cause.badlyShaped() && cause.shape.shape != ShapeClass::small);
  blame(StepFault::poisson, faster > worthNaming);
  blame(StepFault::material, speed > worthNaming * slowest);
  return Json{{"safe", step.safe},
              {"optimistic", numberOrNull(step.optimistic)},
              {"element", elementJson(body.mesh(), element)},
              {"elements", body.mesh().elementCount()},
              {"cause", causeText(cause)},
              {"height", height},
              {"wave_speed", speed},
              {"slowest_wave", slowest},
              {"wave_step", stepFor(std::pow(2 * speed / height, 2), integrator.imaginaryLimit)},
              {"poisson", poisson},
              {"poisson_factor", faster},
              {"damping_share", damping},
              {"undamped_step", numberOrNull(undamped)},
              {"discrete_share", step.discreteShare},
              {"faults", std::move(faults)}};
}

void addRemedies(Json& why, const Body& body, NodeVectorsView x, const StepRule& rule, const IntegratorInfo& integrator,
                 StepWithout without, const MetricResult* ring) {
  if (why.is_null()) return;
  const std::size_t elements = body.mesh().elementCount();
  const auto b = why["element"]["block"].get<std::size_t>(), e = why["element"]["index"].get<std::size_t>();
  if (const double factor = massFactor(body, {b, e}), slower = std::sqrt(factor);
      slower > worthDoing && std::isfinite(factor)) {
    why["wave_speed"] = why["wave_speed"].get<double>() / slower;
    why["wave_step"] = why["wave_step"].get<double>() * slower;
    why["cause"] = fmt::format("{}; its nodes have at least {:.3g} times the mass of their elements, which slows waves",
                               why["cause"].get<std::string>(), factor);
  }
  std::optional<MetricResult> own;
  if (ring == nullptr && elements <= mostRings) ring = &own.emplace(evaluateMetric(ringMetric, body, x));
  clearRemedies(why);
  const std::vector<OwnStep> steps = ring ? ownSteps(*ring, rule) : std::vector<OwnStep>();
  if (!steps.empty()) {
    const double median = steps[steps.size() / 2].step, least = smallShare * median;
    const bool there = b < ring->elementLambda.size() && e < ring->elementLambda[b].size();
    why["median_step"] = median;
    if (there && ring->elementLambda[b][e] > 0) why["own_step"] = numberOrNull(rule(ring->elementLambda[b][e]));
    if (!why["own_step"].is_null() && why["own_step"].get<double>() < least)
      why["faults"].push_back(std::string(stepFaultNames.nameOf(StepFault::size)));
    std::size_t few = 0;
    while (few < steps.size() && steps[few].step < least) ++few;
    if (few == 0) few = steps.size() / worstOf;
    const double gain = few > 0 ? steps[few].step / steps.front().step : 1;
    const bool taken = !isDiscrete(why) && whyNoHandlers(body, integrator).empty(),
               proven = taken && without == StepWithout::proven && elements <= mostBracketed;
    if (proven && elements > 1)
      why["without_element"] =
          numberOrNull(safeWithout(body, x, rule, {{static_cast<std::int32_t>(b), static_cast<std::int32_t>(e)}}));
    if (gain > worthDoing && !isDiscrete(why)) {
      ElementsInTheWay small;
      for (std::size_t i = 0; i < few; ++i) small.all.push_back(steps[i].element);
      const double step = proven ? safeWithout(body, x, rule, small.all) : gain * why["safe"].get<double>();
      if (step > worthDoing * why["safe"].get<double>() && std::isfinite(step)) {
        small.addShapes(body.mesh());
        why["remesh"] = Json{{"elements", few},
                             {"shapes", small.shapesText()},
                             {"numbers", numbersText(small.all, body.mesh())},
                             {"step", step},
                             {"proven", proven}};
        why["mass"] = massFor(body, rule, *ring, small.all, proven ? step : gain * steps.front().step);
        if (taken) why["handler"] = "imex";
      }
    }
  }
  tell(why);
}

void addParagraph(Json& why) {
  if (why.is_null()) return;
  clearRemedies(why);
  tell(why);
}

std::string limitText(const Json& why) {
  if (why.is_null()) return {};
  if (isDiscrete(why)) return "springs or contact limit the step";
  std::string text = fmt::format("element {} limits the step", why["element"]["id"].get<std::int64_t>());
  if (!why.contains("median_step")) return text;  // of a run that goes on
  if (const Json& without = why["without_element"]; !without.is_null()) {
    constexpr double negligible = 0.1;  // %: as by rounding, in a mesh whose elements have twins
    const double gain = 100 * (without.get<double>() / why["safe"].get<double>() - 1);
    text += gain < negligible ? ", and so do others"
                              : fmt::format(", without it {:.4g} s, {:+.2g} %", without.get<double>(), gain);
  }
  if (why["median_step"].is_null()) return text;
  return text + (why["handler"].is_null() ? "; no handler pays"
                                          : fmt::format("; a handler may pay, for {} elements (ringwatch advise)",
                                                        why["remesh"]["elements"].get<std::size_t>()));
}

std::string reasonsText(const Json& why, std::string_view before, std::string_view after, Reasons which) {
  std::string text;
  for (const char* key : {"text", "remedies"})
    if (why.is_object() && why.contains(key) && (which == Reasons::withRemedies || key == std::string_view("text")))
      for (const Json& line : why[key]) text += fmt::format("{}{}{}", before, line.get<std::string>(), after);
  return text;
}

std::vector<std::string> remediesOf(const Json& why) {
  std::vector<std::string> remedies;
  if (why.is_object() && why.contains("remedies"))
    for (const Json& line : why["remedies"])
      if (line.is_string()) remedies.push_back(line);
  return remedies;
}

}  // namespace ringwatch

#include <ringwatch/app/inspect.h>
#include <ringwatch/app/integrator_catalog.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <ringwatch/app/distribution.h>
#include <ringwatch/app/progress.h>
#include <ringwatch/app/report.h>
#include <ringwatch/app/scene.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/nearest_name.h>
#include <ringwatch/base/user_text.h>
#include <ringwatch/integrators/integrator.h>
#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/meshes/quality.h>
#include <ringwatch/meshes/vtu_writer.h>
#include <ringwatch/monitor/global_frequency.h>
#include <ringwatch/monitor/metrics.h>
#include <ringwatch/monitor/stability_monitor.h>

namespace ringwatch {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> metricsWanted(const std::vector<std::string>& asked) {
  if (asked.empty()) return {"single-element", "pressure-wave", "reduced-1-ring"};
  std::vector<std::string> known;
  for (const MetricInfo& info : allMetrics()) known.emplace_back(info.name);
  std::vector<std::string> wanted;
  for (const std::string& name : asked) {
    if (name == "all") return known;
    if (!findMetric(name))
      throw InputError(fmt::format("--metric: unknown {}; {}known are all, {}", inQuotes(name), didYouMean(name, known),
                                   knownMetrics(name)));
    if (std::find(wanted.begin(), wanted.end(), name) == wanted.end()) wanted.push_back(name);
  }
  return wanted;
}

double limitOf(const std::string& integrator) {
  const IntegratorInfo* info = integratorCatalog().find(integrator);
  if (!info) {
    std::vector<std::string> known;
    for (const IntegratorInfo& other : integratorInfos()) known.emplace_back(other.name);
    throw InputError(fmt::format("--integrator: unknown {}; {}known are {}", inQuotes(integrator),
                                 didYouMean(integrator, known), fmt::join(known, ", ")));
  }
  if (!(info->imaginaryLimit > 0))
    throw InputError(
        fmt::format("--integrator: \"{}\" is unstable at every step without damping and has no critical step; choose "
                    "another, e.g. symplectic-euler",
                    integrator));
  if (std::isinf(info->imaginaryLimit))
    throw InputError(fmt::format(
        "--integrator: \"{}\" is stable at every step and has no critical step; choose another, e.g. symplectic-euler",
        integrator));
  if (info->partitioned)
    throw InputError(fmt::format(
        "--integrator: \"{}\" chooses its stiff elements by the step; choose another, e.g. symplectic-euler",
        integrator));
  return info->imaginaryLimit;
}

Body makeBody(const InspectOptions& options, std::vector<std::string>& notes) {
  const Material material = makeMaterial(options.model, options.young, options.poisson, options.density);
  Mesh mesh = loadMesh(options.mesh, &notes);
  for (std::string& note : meshNotes(mesh, options.mesh.string())) notes.push_back(std::move(note));
  BodyOptions bodyOptions;
  bodyOptions.lumping = options.lumping;
  bodyOptions.threads = threadsThatPay(options.threads, mesh);
  try {
    return Body(std::move(mesh), material, bodyOptions);
  } catch (const NumericalError& fault) {
    throw InputError(fmt::format("{}: {}", options.mesh.string(), fault.what()));
  }
}

/// Which side of the critical step a metric's step lies on: the opposite of its frequency.
std::string_view stepSide(Direction direction) {
  switch (direction) {
    case Direction::upperBound:
      return "safe";
    case Direction::lowerBound:
      return "optimistic";
    case Direction::estimate:
      return "estimate";
  }
  return "";
}

std::string qualityText(const std::vector<QualitySummary>& summaries) {
  std::string text = fmt::format("  {:<22} {:>12} {:>12} {:>12}\n", "quality", "least", "mean", "largest");
  for (const QualitySummary& s : summaries)
    text += fmt::format("  {:<22} {:>12.5g} {:>12.5g} {:>12.5g}\n",
                        s.unit.empty() ? s.name : fmt::format("{} ({})", s.name, s.unit), s.min, s.mean, s.max);
  return text;
}

Json qualityJson(const std::vector<QualitySummary>& summaries) {
  Json json = Json::object();
  for (const QualitySummary& s : summaries)
    json[s.name] = Json{{"unit", s.unit},
                        {"min", s.min},
                        {"max", s.max},
                        {"mean", s.mean},
                        {"min_element", {{"block", s.minElement.block}, {"index", s.minElement.element}}},
                        {"max_element", {{"block", s.maxElement.block}, {"index", s.maxElement.element}}}};
  return json;
}

/// The metric among those at hand, or evaluated.
MetricResult metricNamed(std::string_view name, const std::vector<MetricResult>& known, const Body& body) {
  for (const MetricResult& metric : known)
    if (metric.info->name == name) return metric;
  return evaluateMetric(name, body, body.mesh().X);
}

/// Elements whose reduced 1-ring forbids a step, and how many forbid it by each metric.
Json illShaped(const Body& body, const std::vector<MetricResult>& metrics, double limit, double h) {
  const MetricResult ring = metricNamed("reduced-1-ring", metrics, body),
                     single = metricNamed("single-element", metrics, body);
  Json elements = Json::array();
  std::size_t singleCount = 0;
  for (std::size_t b = 0; b < ring.elementLambda.size(); ++b)
    for (std::size_t e = 0; e < ring.elementLambda[b].size(); ++e) {
      if (stepFor(ring.elementLambda[b][e], limit) < h)
        elements.push_back(Json{{"block", b}, {"index", e}, {"id", body.mesh().blocks[b].id(e)}});
      singleCount += stepFor(single.elementLambda[b][e], limit) < h ? 1 : 0;
    }
  return Json{{"count", elements.size()},
              {"by_metric", {{"reduced-1-ring", elements.size()}, {"single-element", singleCount}}},
              {"elements", std::move(elements)}};
}

void writeMetricsVtu(const std::filesystem::path& path, const Body& body, const std::vector<MetricResult>& metrics,
                     double limit, const std::vector<std::vector<ElementQuality>>& quality) {
  std::vector<std::vector<double>> arrays;
  std::vector<VtuField> fields;
  arrays.reserve(metrics.size() + 1);  // the fields point into it
  const auto add = [&](std::string name, std::vector<double> values) {
    arrays.push_back(std::move(values));
    fields.push_back({std::move(name), 1, std::span<const double>(arrays.back())});
  };
  for (const MetricResult& metric : metrics) {
    std::vector<double> steps;
    for (const auto& block : metric.elementLambda)
      for (double lambda : block) steps.push_back(stepFor(lambda, limit));
    add(fmt::format("step by {} (s)", metric.info->name), std::move(steps));
  }
  std::vector<double> heights;
  for (const auto& block : quality)
    for (const ElementQuality& q : block) heights.push_back(q.minHeight);
  add("minimum height (m)", std::move(heights));
  writeVtu(path, body.mesh(), body.mesh().X, {}, fields);
}

/// The table of metrics. A difference is (step - global) / global: negative is pessimistic.
void reportMetrics(const std::vector<MetricResult>& metrics, double limit, std::optional<double> globalStep, Json& json,
                   std::string& text) {
  for (const char* key : {"metrics", "directions", "controlling"}) json[key] = Json::object();
  if (globalStep) json["differences_percent"] = Json::object();
  text += fmt::format("  {:<32} {:<10} {:>16} {}element\n", "metric", "side", "step (s)",
                      globalStep ? "  difference (%)  " : "  ");
  for (const MetricResult& m : metrics) {
    const double h = stepFor(m.lambda, limit);
    const std::string name(m.info->name);
    json["metrics"][name] = h;
    json["directions"][name] = std::string(stepSide(m.direction));
    json["controlling"][name] = Json{{"block", m.controlling.block}, {"index", m.controlling.element}};
    text += fmt::format("  {:<32} {:<10} {:>16.10g}  ", name, stepSide(m.direction), h);
    if (globalStep) {
      const double difference = 100 * (h / *globalStep - 1);
      json["differences_percent"][name] = difference;
      text += fmt::format("{:>14.3f}  ", difference);
    }
    text += fmt::format("{}:{}\n", m.controlling.block, m.controlling.element);
  }
  text += "  safe: proven, the critical step is at least this; optimistic: proven, at most this\n";
}

}  // namespace

InspectResult inspectMesh(const InspectOptions& options) {
  const std::vector<std::string> wanted = metricsWanted(options.metrics);
  const double limit = limitOf(options.integrator);
  if (options.step && !(*options.step > 0 && std::isfinite(*options.step)))
    throw InputError(fmt::format("--step: {} is out of range; must be > 0 s", *options.step));
  if (options.lanczos && !(*options.lanczos > 0 && *options.lanczos <= 0.5))
    throw InputError(
        fmt::format("--lanczos: {} is out of range; must be > 0 and <= 0.5, a probability", *options.lanczos));
  if (options.picture) checkPictureName(*options.picture);
  std::vector<NodeSelection> held;
  for (const std::string& text : options.fix) held.push_back(NodeSelection::parse(text, "--fix"));

  std::vector<std::string> notes;
  Body body = makeBody(options, notes);
  const Mesh& mesh = body.mesh();
  for (const NodeSelection& selection : held)
    for (std::int32_t node : selection.nodesOf(mesh)) body.constraints().fix(node);

  InspectResult result;
  Json& json = result.json;
  const auto quality = meshQuality(mesh);
  const std::vector<QualitySummary> summaries = summarizeQuality(quality);
  json["mesh"] = meshJson(mesh, body.volume());
  json["mass"] = body.totalMass();
  std::string& text = result.text;
  text = fmt::format("{}: {} nodes, {}\n  volume {:.10g} m3, mass {:.10g} kg\n", options.mesh.string(),
                     mesh.nodeCount(), elementCounts(mesh), body.volume(), body.totalMass());
  for (const std::string& note : notes) text += fmt::format("  note: {}\n", note);
  json["quality"] = qualityJson(summaries);
  text += qualityText(summaries);

  std::optional<LanczosOptions> lanczos;
  if (options.lanczos) lanczos.emplace().eta = *options.lanczos;
  const CriticalStep step = criticalStep(body, mesh.X, limit, lanczos);
  json["critical_step"] = Json{{"safe", step.safe}, {"optimistic", step.optimistic}};
  text +=
      fmt::format("critical step at rest: {}, {}, limit h omega = {:.6g}\n", options.model, options.integrator, limit);
  text += fmt::format("  safe        {:.10g} s   proven stable up to here, by {}\n", step.safe, step.safeBy);
  if (step.probable) {
    json["critical_step"]["probable"] = Json{{"safe", step.probable->safe}, {"eta", step.probable->eta}};
    text +=
        fmt::format("  probable    {:.10g} s   stable up to here with probability 1 - {:.3g}, {} tangent products\n",
                    step.probable->safe, step.probable->eta, step.probable->products);
  }
  text += fmt::format("  optimistic  {:.10g} s   proven unstable above, by {}\n", step.optimistic, step.optimisticBy);
  if (step.lowestRing < 0)
    text +=
        fmt::format("  the tangent is indefinite, eigenvalue {:.6g} rad2/s2: no step cures that\n", step.lowestRing);
  std::optional<double> globalStep;
  if (options.global) {
    const GlobalFrequency global = globalFrequency(body, mesh.X);
    if (global.converged) {
      globalStep = stepFor(global.lambda, limit);
      json["critical_step"]["global"] = *globalStep;
      text +=
          fmt::format("  global      {:.10g} s   the exact value, {} tangent products\n", *globalStep, global.products);
    } else {
      result.failure = fmt::format(
          "{}: the global eigenvalue did not converge after {} tangent products; the bracket holds without it",
          options.mesh.string(), global.products);
    }
  }

  std::vector<MetricResult> metrics;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    ProgressLine progress(true);
    metrics.push_back(evaluateMetric(wanted[i], body, mesh.X, [&](double done) {
      if (progress.due()) progress.show(fmt::format("{}: {:.0f} %", wanted[i], 100 * done), done);
    }));
  }
  reportMetrics(metrics, limit, globalStep, json["critical_step"], text);

  json["controlling_element"] = elementJson(mesh, step.controlling);
  const ElementQuality& q =
      quality[static_cast<std::size_t>(step.controlling.block)][static_cast<std::size_t>(step.controlling.element)];
  text += fmt::format("controlling element: {}\n  volume {:.5g} m3, least height {:.5g} m, edges {:.5g} to {:.5g} m",
                      elementText(mesh, step.controlling), q.volume, q.minHeight, q.minEdge, q.maxEdge);
  if (!std::isnan(q.minDihedral))
    text += fmt::format(", dihedral angles {:.4g} to {:.4g} degrees", q.minDihedral, q.maxDihedral);
  text += "\n";

  if (options.step) {
    json["ill_shaped"] = illShaped(body, metrics, limit, *options.step);
    const Json& counts = json["ill_shaped"]["by_metric"];
    text += fmt::format(
        "at h = {:.6g} s: {}; {} of {} elements forbid it by their reduced 1-ring, {} as single elements\n",
        *options.step,
        *options.step <= step.safe         ? "proven stable"
        : *options.step <= step.optimistic ? "neither proven stable nor unstable"
                                           : "proven unstable",
        counts["reduced-1-ring"].get<std::size_t>(), mesh.elementCount(), counts["single-element"].get<std::size_t>());
  }
  if (options.distribution || options.picture) {
    std::vector<Distribution> distributions;
    for (const MetricResult& metric : metrics) distributions.push_back(distributionOf(metric, limit));
    json["distribution"] = distributionJson(distributions);
    text += distributionText(distributions, options.step);
    // Of the metrics at hand the one that tells elements apart best.
    const auto worst = worstElements(body, metricNamed("reduced-1-ring", metrics, body), limit, 10);
    json["worst_elements"] = worstJson(mesh, worst);
    text += worstText(worst);
    if (options.picture) text += drawDistribution(*options.picture, distributions, options.mesh.string());
  }
  if (options.vtu) writeMetricsVtu(*options.vtu, body, metrics, limit, quality);
  return result;
}

}  // namespace ringwatch

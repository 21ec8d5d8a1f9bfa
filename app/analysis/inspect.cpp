#include <ringwatch/app/analysis/inspect.h>
#include <ringwatch/app/scene/integrator_catalog.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include <ringwatch/app/analysis/distribution.h>
#include <ringwatch/app/analysis/step_answer.h>
#include <ringwatch/app/output/elements_in_the_way.h>
#include <ringwatch/app/output/frames.h>
#include <ringwatch/app/output/progress.h>
#include <ringwatch/app/output/report.h>
#include <ringwatch/app/output/step_reasons.h>
#include <ringwatch/app/scene/body_notes.h>
#include <ringwatch/app/scene/capabilities.h>
#include <ringwatch/app/scene/mjcf_model.h>
#include <ringwatch/app/scene/scene.h>
#include <ringwatch/app/scene/scene_discrete.h>
#include <ringwatch/base/atomic_file.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/machine_memory.h>
#include <ringwatch/base/nearest_name.h>
#include <ringwatch/base/user_text.h>
#include <ringwatch/handlers/handler.h>
#include <ringwatch/handlers/selection/certified_selection.h>
#include <ringwatch/integrators/integrator.h>
#include <ringwatch/meshes/formats/vtu_writer.h>
#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/meshes/quality.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <ringwatch/monitor/certificate_file.h>
#include <ringwatch/monitor/exact_step.h>
#include <ringwatch/monitor/metrics/metrics.h>
#include <ringwatch/monitor/stability_monitor.h>

namespace ringwatch {
namespace {

using Json = nlohmann::ordered_json;

/// Of the step at which the rule of a body that damps is exact where an eigenvalue gives it.
constexpr double exactTolerance = 1e-9;

std::vector<std::string> metricsWanted(const std::vector<std::string>& asked, bool usual) {
  if (asked.empty() && !usual) return {};
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

const IntegratorInfo& integratorNamed(const std::string& integrator) {
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
  return *info;
}

/// What is inspected: a body in a state.
struct Subject {
  Scene scene;
  Body body;
  NodeVectors x;
  ReferencedRule own;  // exact at the step that the state has, as far as that is known
  const IntegratorInfo* integrator;
  std::string state;  // "at rest"
  Json stateJson;
  std::vector<std::string> notes;

  const StepRule& rule() const { return own.rule; }
  std::string model() const { return modelsText(scene.materials); }
  bool damped() const { return scene.damps(); }
  /// Lets the rule be exact at the step that is found by `step`.
  void referTo(double tolerance, const StepByRule& step) {
    own = ruleAtOwnStep(scene, body, DampingRates::atRest, tolerance, step);
  }
};

/// With the rule that is exact at the safe step of the state.
Subject subjectIn(Scene scene, Body body, NodeVectors x, std::string state, Json stateJson,
                  std::vector<std::string> notes) {
  const IntegratorInfo& integrator = *integratorCatalog().find(scene.method);
  Subject subject{std::move(scene), std::move(body),  std::move(x),         {integrator.imaginaryLimit},
                  &integrator,      std::move(state), std::move(stateJson), std::move(notes)};
  subject.referTo(ownStepTolerance, stepOfTopMode(subject.body, subject.x));
  return subject;
}

Body makeBody(const Scene& scene, Mesh mesh, const InspectOptions& options, MaterialsBy by) {
  try {
    return sceneBody(scene, std::move(mesh), options.threads, by);
  } catch (const NumericalError& fault) {
    throw InputError(fmt::format("{}: {}", options.mesh.string(), fault.what()));
  }
}

/// What the command line says beyond the scene of a run, or instead of one.
void override(Scene& scene, const InspectOptions& options) {
  const auto given = [&]() -> std::string {
    if (options.model) return "--model";
    if (options.density) return "--density";
    return options.parameters.begin() == options.parameters.end() ? "" : "--" + options.parameters.begin()->first;
  }();
  if (scene.materials.size() > 1 && !given.empty())
    throw InputError(fmt::format("{}: there are {} materials; leave it out, all are those of the scene", given,
                                 scene.materials.size()));
  SceneMaterial& material = scene.materials.front();
  if (options.model && *options.model != material.model) {
    material.model = *options.model;
    const LawInfo& law = lawNamed(material.model);
    Options kept;  // what the scene's law has in common with it
    for (const auto& [name, value] : material.parameters)
      if (findOption(law.parameters, name)) kept.set(name, value);
    material.parameters = std::move(kept);
  }
  for (const auto& [name, value] : options.parameters) material.parameters.set(name, value);
  material.density = options.density.value_or(material.density);
  scene.lumping = options.lumping.value_or(scene.lumping);
  scene.method = options.integrator.value_or(scene.method);
  useUnits(options.units.value_or(scene.units));
  overrideRules(scene, options.rules, "--rule");
  for (const std::string& text : options.fix) scene.fixes.push_back(parseFix(text, "--fix"));
}

Subject subjectOfRun(const InspectOptions& options) {
  Scene scene = sceneOfRun(options.mesh);
  scene.meshOrigin = options.mesh.string();
  const std::vector<PvdEntry> frames = framesOfRun(options.mesh);
  if (*options.frame < 1 || *options.frame > static_cast<std::int64_t>(frames.size()))
    throw InputError(fmt::format("--frame: {} is out of range; {} has {} frames, counted from 1", *options.frame,
                                 options.mesh.string(), frames.size()));
  const PvdEntry& frame = frames[*options.frame - 1];
  override(scene, options);
  integratorNamed(scene.method);
  std::vector<std::string> notes;
  BodyState state = [&] {
    try {
      return bodyOfFrame(scene, options.mesh, frame, options.threads, &notes);
    } catch (const NumericalError& fault) {
      throw InputError(fmt::format("{}: {}", options.mesh.string(), fault.what()));
    }
  }();
  if (!scene.handler.empty())
    notes.push_back(findHandler(scene.handler)->addsMass
                        ? "the run scaled masses; this is the body without added mass"
                        : fmt::format("the run handled elements apart ({}); here all elements count", scene.handler));
  return subjectIn(std::move(scene), std::move(state.body), std::move(state.x),
                   fmt::format("in frame {} of {}, t = {:.6g} s", *options.frame, frames.size(), frame.time),
                   Json{{"frame", *options.frame}, {"frames", frames.size()}, {"time", frame.time}}, std::move(notes));
}

/// With the materials, sections and supports of a deck, or the flexes of a MuJoCo model.
Subject subjectOfModel(const InspectOptions& options) {
  std::vector<std::string> overrides;
  if (options.density) overrides.push_back(fmt::format("material.density={}", *options.density));
  if (options.repair) overrides.emplace_back("mesh.repair=true");
  Scene scene = sceneOfModel(options.mesh, DeckUse::model, overrides);
  scene.meshOrigin = options.mesh.string();
  override(scene, options);
  integratorNamed(scene.method);
  std::vector<std::string> notes;
  Mesh mesh = sceneMesh(scene, notes);
  for (std::string& note : meshNotes(mesh, options.mesh.string())) notes.push_back(std::move(note));
  NodeVectors x = mesh.X;
  Body body = makeBody(scene, std::move(mesh), options, MaterialsBy::scene);
  return subjectIn(std::move(scene), std::move(body), std::move(x), "at rest", "rest", std::move(notes));
}

/// Of a mesh file without a scene. Throws before a large mesh is read.
Scene sceneOfMeshFile(const InspectOptions& options) {
  Scene scene;
  const std::string missing = missingConstants(options.model.value_or(std::string(InspectOptions::usualModel)),
                                               options.parameters, options.density);
  if (!missing.empty()) {
    loadMesh(options.mesh, nullptr);  // of a file that is no mesh, that is the fault
    throw InputError(missing + " with a mesh file; see ringwatch inspect --help");
  }
  scene.materials.emplace_back().model = InspectOptions::usualModel;
  scene.method = InspectOptions::usualIntegrator;
  scene.lumping = InspectOptions::usualLumping;
  scene.meshOrigin = options.mesh.string();
  override(scene, options);
  integratorNamed(scene.method);
  const SceneMaterial& material = scene.materials.front();
  makeMaterial(material.model, material.parameters, material.density);
  return scene;
}

Subject subjectOf(const InspectOptions& options) {
  std::error_code error;
  if (options.mesh.extension() == ".toml")
    throw InputError(
        fmt::format("{}: is a scene; give its mesh, a deck, or with --frame n the folder of its run; ringwatch suggest "
                    "{} --frame 1/60 and ringwatch run tell its steps",
                    options.mesh.string(), options.mesh.string()));
  const bool folder = std::filesystem::is_directory(options.mesh, error);
  if (options.frame && options.displacement)
    throw InputError("--frame: goes with the folder of a run, --displacement with a .vtu file; give one of them");
  if (folder && !options.frame)
    throw InputError(
        fmt::format("{}: is a folder; give a mesh file, or with the folder of a run --frame n", options.mesh.string()));
  if (!folder && options.frame)
    throw InputError(
        fmt::format("--frame: {} is not a folder; frames are those of a run's folder, a single .vtu file "
                    "takes --displacement FIELD",
                    options.mesh.string()));
  if (folder) return subjectOfRun(options);
  const bool ownLaw = options.parameters.begin() != options.parameters.end();
  if (!options.displacement && (isMjcfFile(options.mesh) || (!ownLaw && isDeckFile(options.mesh))))
    return subjectOfModel(options);
  Scene scene = sceneOfMeshFile(options);
  std::vector<std::string> notes;
  MeshState state;
  if (options.displacement) {
    state = loadVtuState(options.mesh, *options.displacement, &notes);
  } else {
    state.mesh = loadMesh(options.mesh, &notes, options.repair);
    state.x = state.mesh.X;
  }
  for (std::string& note : meshNotes(state.mesh, options.mesh.string())) notes.push_back(std::move(note));
  Body body = makeBody(scene, std::move(state.mesh), options, MaterialsBy::scene);
  return subjectIn(std::move(scene), std::move(body), std::move(state.x),
                   options.displacement ? fmt::format("with displacement \"{}\"", *options.displacement) : "at rest",
                   options.displacement ? Json{{"displacement", *options.displacement}} : Json("rest"),
                   std::move(notes));
}

Json setsJson(const MeshFigures& figures) {
  Json nodes = Json::object(), elements = Json::object();
  for (const auto& [name, count] : figures.nodeSets) nodes[name] = count;
  for (const auto& [name, count] : figures.elementSets) elements[name] = count;
  return Json{{"node_sets", std::move(nodes)}, {"element_sets", std::move(elements)}};
}

std::string setsText(const MeshFigures& figures) {
  std::string text;
  for (const auto& [sets, what] : {std::pair{&figures.nodeSets, "node sets"}, {&figures.elementSets, "element sets"}}) {
    std::string list;
    for (const auto& [name, count] : *sets) list += fmt::format("{}{} ({})", list.empty() ? "" : ", ", name, count);
    text += fmt::format("  {:<13} {}\n", what, list.empty() ? "none" : list);
  }
  return text;
}

MeshFigures figuresOf(const Subject& subject, const std::vector<std::vector<ElementQuality>>& quality) {
  const Mesh& mesh = subject.body.mesh();
  MeshFigures figures{.nodes = static_cast<std::int64_t>(mesh.nodeCount()),
                      .elements = countElements(mesh),
                      .nodeSets = {},
                      .elementSets = {},
                      .volume = subject.body.volume(),
                      .mass = subject.body.totalMass(),
                      .body = bodyFigures(subject.body),
                      .quality = summarizeQuality(quality),
                      .notes = subject.notes};
  for (const auto& [name, set] : mesh.nodeSets) figures.nodeSets[name] = static_cast<std::int64_t>(set.size());
  for (const auto& [name, set] : mesh.elementSets) figures.elementSets[name] = static_cast<std::int64_t>(set.size());
  return figures;
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
MetricResult metricNamed(std::string_view name, const std::vector<MetricResult>& known, const Subject& subject) {
  for (const MetricResult& metric : known)
    if (metric.info->name == name) return metric;
  return evaluateMetric(name, subject.body, subject.x);
}

/// Elements whose reduced 1-ring forbids a step, and how many forbid it by each metric.
Json illShaped(const Subject& subject, const std::vector<MetricResult>& metrics, double h) {
  const MetricResult ring = metricNamed("reduced-1-ring", metrics, subject),
                     single = metricNamed("single-element", metrics, subject);
  Json elements = Json::array();
  std::size_t singleCount = 0;
  for (std::size_t b = 0; b < ring.elementLambda.size(); ++b)
    for (std::size_t e = 0; e < ring.elementLambda[b].size(); ++e) {
      if (stepBy(ring.direction, ring.elementLambda[b][e], subject.rule()) < h)
        elements.push_back(Json{{"block", b}, {"index", e}, {"id", subject.body.mesh().blocks[b].id(e)}});
      singleCount += stepBy(single.direction, single.elementLambda[b][e], subject.rule()) < h ? 1 : 0;
    }
  return Json{{"count", elements.size()},
              {"by_metric", {{"reduced-1-ring", elements.size()}, {"single-element", singleCount}}},
              {"elements", std::move(elements)}};
}

/// What a handler would take at a step h, as it chooses when a run begins. Null where no handler goes with the
/// integrator.
Json handlerChoice(const Subject& subject, double h) {
  if (!whyNoHandlers(subject.body, *subject.integrator).empty()) return nullptr;
  const HandlerOptions options;
  const std::vector<ElementRef> chosen =
      elementsInTheWay(subject.body, subject.x, *subject.integrator, subject.scene.damping, h).all;
  Json elements = Json::array();
  for (const ElementRef e : chosen)
    elements.push_back(
        Json{{"block", e.block}, {"index", e.element}, {"id", subject.body.mesh().blocks[e.block].id(e.element)}});
  return Json{{"count", chosen.size()},
              {"selection", std::string(selectionNames.nameOf(options.selection))},
              {"margin", defaultMargin},
              {"elements", std::move(elements)}};
}

void writeMetricsVtu(const std::filesystem::path& path, const Subject& subject,
                     const std::vector<MetricResult>& metrics, const CriticalStep& step, std::optional<double> h,
                     const std::vector<std::vector<ElementQuality>>& quality) {
  std::vector<std::vector<double>> arrays;
  std::vector<VtuField> fields;
  arrays.reserve(metrics.size() + 1);  // the fields point into it
  const auto add = [&](std::string name, std::vector<double> values) {
    arrays.push_back(std::move(values));
    fields.push_back({std::move(name), 1, std::span<const double>(arrays.back())});
  };
  for (const MetricResult& metric : metrics) {
    FrameField steps = stepField(metric, subject.rule());
    add(std::move(steps.name), std::move(steps.values));
  }
  std::vector<double> heights;
  for (const auto& block : quality)
    for (const ElementQuality& q : block) heights.push_back(q.minHeight);
  add(labelled("minimum height (m)"), std::move(heights));
  const NodeVectors displacement = subject.x - subject.body.mesh().X;
  std::vector<VtuField> points;
  if (!displacement.isZero(0))
    points.push_back({"displacement", 3,
                      std::span<const double>(displacement.data(), static_cast<std::size_t>(displacement.size()))});
  const std::int32_t deformed = 1;
  std::vector<VtuField> frame{{labelled("safe step (s)"), 1, std::span(&step.safe, 1)},
                              {labelled("optimistic step (s)"), 1, std::span(&step.optimistic, 1)}};
  if (h) frame.push_back({labelled("step (s)"), 1, std::span<const double>(&*h, 1)});
  if (!points.empty()) frame.push_back({deformedPointsMark, 1, std::span(&deformed, 1)});
  writeVtu(path, subject.body.mesh(), subject.x, points, fields, std::nullopt, frame);
}

/// Says on a terminal what a factorisation takes, and keeps it for the report. Throws InputError, naming `option`,
/// where the machine has not the memory.
BeforeFactorisation sayCost(std::string_view option, ProgressLine& progress, FactorisationCost& kept) {
  return [option, &progress, &kept](const FactorisationCost& cost) {
    kept = cost;
    // Of one core: 2.6e9 were measured with a factor of 6 million numbers, 1.4e9 with one of 39 million.
    constexpr double operationsASecond = 1.5e9;
    const double memory = static_cast<double>(machineMemory());
    if (cost.bytes > memory)
      throw InputError(
          fmt::format("{}: the factorisation takes {:.3g} GB and this machine has {:.3g} GB; leave it out, "
                      "the bracket needs no factorisation",
                      option, 1e-9 * cost.bytes, 1e-9 * memory));
    progress.announce(fmt::format("factorisation: {:.3g} million numbers, {:.3g} GB, about {:.2g} seconds",
                                  1e-6 * cost.numbers, 1e-9 * cost.bytes, cost.operations / operationsASecond));
  };
}
Json costJson(const FactorisationCost& cost) {
  return Json{{"factor_numbers", cost.numbers}, {"factor_bytes", cost.bytes}, {"factor_operations", cost.operations}};
}

/// Both sides of the critical step by a factorisation; what it proved.
ProvenSides reportExactStep(const Subject& subject, const CriticalStep& bracket, const InspectOptions& options,
                            InspectResult& result) {
  ProgressLine progress(true);
  FactorisationCost cost{};
  // With damping up to twice as much of the tolerance becomes that of the step.
  const double tolerance = subject.damped() ? 0.5e-6 : 1e-6;
  const std::optional<ExactStep> exact =
      exactCriticalStep(subject.body, subject.x, subject.rule(), tolerance, sayCost("--exact", progress, cost));
  if (!exact) {
    result.failure = fmt::format(
        "{}: --exact: the top mode did not converge, or rounding leaves nothing to prove within 1 %; the bracket holds "
        "without it",
        options.mesh.string());
    return {};
  }
  Json& json = result.json["critical_step"]["exact"];
  json = Json{{"safe", exact->safe}, {"optimistic", exact->optimistic}, {"factorisations", exact->factorisations}};
  json.update(costJson(cost));
  result.text += fmt::format(
      "  exact       {:.10g} to {:.10g} s   proven {} up to the first and unstable above the second, by a "
      "factorisation of {:.3g} million numbers\n",
      exact->safe, exact->optimistic, stableUpTo(bracket), 1e-6 * cost.numbers);
  return exact->sides;
}

/// Whether the step that a deck or model asks for is stable, by the bracket and by what --exact has proven.
void answerOwnStep(const Subject& subject, CriticalStep bracket, InspectResult& result) {
  const Json& proven = result.json["critical_step"];
  if (const auto exact = proven.find("exact"); exact != proven.end()) {
    bracket.safe = std::max(bracket.safe, exact->at("safe").get<double>());
    bracket.optimistic = std::min(bracket.optimistic, exact->at("optimistic").get<double>());
  }
  StepAnswer answer = answerStep(subject.scene, subject.body, bracket);
  result.json["timestep"] = std::move(answer.json);
  result.text += answer.text;
}

/// A step for all states whose stretches lie in a range.
void reportRange(const Subject& subject, StretchRange stretch, InspectResult& result) {
  const RangeStep range = rangeStep(subject.body, stretch, subject.rule());
  Json& json = result.json["stretch"];
  json = Json{{"low", stretch.low}, {"high", stretch.high}, {"safe", range.safe}, {"modulus", Json::array()}};
  for (const ModulusRange& modulus : range.modulus) json["modulus"].push_back(modulus.bound);
  result.text += fmt::format(
      "stretches {:.4g} to {:.4g}: {:.10g} s   proven stable in every state whose stretches stay between "
      "these and whose tangent is not indefinite\n",
      stretch.low, stretch.high, range.safe);
}

/// Whether one step is stable, by a factorisation; what it proved.
ProvenSides reportProof(Subject& subject, double h, const CriticalStep& bracket, InspectResult& result) {
  ProgressLine progress(true);
  FactorisationCost cost{};
  ProvenSides sides;
  const StepRule rule = stepRuleAt(subject.scene, subject.body, h, DampingRates::atRest);
  Verdict verdict = proveStep(subject.body, subject.x, rule, h, sayCost("--prove", progress, cost), &sides);
  if (verdict == Verdict::certified && bracket.indefinite()) verdict = Verdict::notCertified;
  stepRuleAt(subject.scene, subject.body, subject.own.reference, DampingRates::atRest);
  result.json["prove"] = Json{{"step", h}, {"verdict", std::string(verdictName(verdict))}};
  result.json["prove"].update(costJson(cost));
  result.text += fmt::format("h = {:.10g} s: {}, by a factorisation of {:.3g} million numbers\n", h,
                             verdictText(verdict, bracket), 1e-6 * cost.numbers);
  if (verdict == Verdict::violated) result.status = ExitStatus::unstable;
  if (verdict == Verdict::notCertified) result.status = ExitStatus::notCertified;
  return sides;
}

/// The table of metrics. A difference is (step - global) / global: negative is pessimistic.
void reportMetrics(const std::vector<MetricResult>& metrics, const Subject& subject, std::optional<double> globalStep,
                   Json& json, std::string& text) {
  for (const char* key : {"metrics", "directions", "controlling"}) json[key] = Json::object();
  if (globalStep) json["differences_percent"] = Json::object();
  text += fmt::format("  {:<32} {:<10} {:>16} {}element\n", "metric", "side", "step (s)",
                      globalStep ? "  difference (%)  " : "  ");
  for (const MetricResult& m : metrics) {
    const double h = stepBy(m.direction, m.lambda, subject.rule());
    const std::string name(m.info->name);
    json["metrics"][name] = h;
    json["directions"][name] = std::string(stepSide(m.direction));
    json["controlling"][name] = Json{{"block", m.controlling.block}, {"index", m.controlling.element}};
    text += fmt::format("  {:<32} {:<10} {:>16.10g}  ", name, stepSide(m.direction), h);
    if (globalStep) {
      const double difference = h == *globalStep ? 0 : 100 * (h / *globalStep - 1);  // both may be infinite
      json["differences_percent"][name] = difference;
      text += fmt::format("{:>14.3f}  ", difference);
    }
    text += fmt::format("{}:{}\n", m.controlling.block, m.controlling.element);
  }
  text += "  safe: proven, the critical step is at least this; optimistic: proven, at most this\n";
  std::vector<std::string_view> missing;
  if (!subject.scene.pointMasses.empty()) missing.push_back("point masses, those for a fixed step among them,");
  if (subject.scene.hasElementDamping()) missing.push_back("damping of elements");
  if (!missing.empty())
    text += fmt::format(
        "  estimates by waves have the density of the material, a factor for mass scaling included; {} {} not in "
        "them\n",
        listed(missing), missing.size() > 1 || !subject.scene.pointMasses.empty() ? "are" : "is");
}

void checkOptions(const InspectOptions& options) {
  if (options.width && !(*options.width >= 0 && std::isfinite(*options.width)))
    throw InputError(fmt::format("--width: {} is out of range; must be >= 0, e.g. 0.05 for 5 %", *options.width));
  if (options.lanczos && !(*options.lanczos > 0 && *options.lanczos <= 0.5))
    throw InputError(
        fmt::format("--lanczos: {} is out of range; must be > 0 and <= 0.5, a probability", *options.lanczos));
  if (options.certificate && options.exact && options.prove)
    throw InputError("--certificate: with --exact and --prove it could be of either; give one of them");
  if (options.repair && (options.frame || options.displacement))
    throw InputError("--repair: is of a mesh at rest; leave out --frame and --displacement");
  if (options.picture) checkPictureName(*options.picture);
}

void reportMesh(const MeshFigures& figures, const Json& state, const InspectOptions& options, InspectResult& result) {
  Json& json = result.json;
  json["mesh"] = meshJson(figures.nodes, figures.elements, figures.volume);
  json["mesh"].update(setsJson(figures));
  json["mass"] = figures.mass;
  json["body"] = figures.body.json();
  json["state"] = state;
  result.text = fmt::format("{}: {} nodes, {}\n  volume {:.10g} m3, mass {:.10g} kg\n", options.mesh.string(),
                            figures.nodes, elementCounts(figures.elements), figures.volume, figures.mass);
  result.text += fmt::format("  {}\n", figures.body.text());
  result.text += setsText(figures);
  for (const std::string& note : figures.notes) result.text += fmt::format("  note: {}\n", note);
  json["quality"] = qualityJson(figures.quality);
  result.text += qualityText(figures.quality);
}

/// The first line about a critical step: of which state of what.
std::string headOfBracket(const std::string& state, const std::string& model, const IntegratorInfo& integrator,
                          bool damped) {
  return fmt::format("critical step {}: {}, {}, limit h omega = {:.6g}{}\n", state, model, integrator.name,
                     integrator.imaginaryLimit, damped ? ", damped" : "");
}

/// Both sides, the safe one first; between: what is told between them.
void reportSides(const CriticalStep& step, const std::string& between, InspectResult& result) {
  result.json["critical_step"] =
      Json{{"safe", step.safe}, {"optimistic", step.optimistic}, {"indefinite", step.indefinite()}};
  result.text +=
      fmt::format("  safe        {:.10g} s   proven {} up to here, by {}\n", step.safe, stableUpTo(step), step.safeBy);
  result.text += between;
  result.text +=
      fmt::format("  optimistic  {:.10g} s   proven unstable above, by {}\n", step.optimistic, step.optimisticBy);
}

/// What is proven of every step, in a clause.
std::string provenText(const CriticalStep& step) {
  if (step.indefinite()) return indefiniteText(step);
  return std::isinf(step.safe) ? "every step is proven stable"
         : step.safe > 0       ? fmt::format("every step up to {:.6g} s is proven stable", step.safe)
                               : "no step is proven stable";
}

CriticalStep reportBracket(const Subject& subject, const InspectOptions& options, InspectResult& result) {
  ProgressLine progress(true);
  CriticalStepOptions search;
  if (options.width) search.width = *options.width;
  if (options.lanczos) search.lanczos.emplace().eta = *options.lanczos;
  search.listener = [&](double safe, double optimistic) {
    progress.announce(fmt::format("critical step: proven so far {:.6g} to {:.6g} s", safe, optimistic));
  };
  const CriticalStep step = options.bracket ? options.bracket(subject.body, subject.x, subject.rule())
                                            : criticalStep(subject.body, subject.x, subject.rule(), search);
  progress.clear();
  std::string& text = result.text;
  text += headOfBracket(subject.state, subject.model(), *subject.integrator, subject.damped());
  std::string probable;
  if (step.probable)
    probable = fmt::format("  probable    {:.10g} s   {} up to here with probability 1 - {:.3g}, {} tangent products\n",
                           step.probable->safe, stableUpTo(step), step.probable->eta, step.probable->products);
  reportSides(step, probable, result);
  if (step.probable)
    result.json["critical_step"]["probable"] = Json{{"safe", step.probable->safe}, {"eta", step.probable->eta}};
  if (step.indefinite()) text += fmt::format("  {}\n", indefiniteText(step));
  if (step.poorlyConditioned > 0)
    text += fmt::format(
        "  note: rounding leaves little to say of {} element{}, the worst is {}; the safe step is lower for it\n",
        step.poorlyConditioned, step.poorlyConditioned == 1 ? "" : "s",
        elementText(subject.body.mesh(), step.worstConditioned));
  return step;
}

/// The exact step; empty where its eigenvalue did not converge.
std::optional<double> reportGlobalStep(const Subject& subject, const InspectOptions& options, InspectResult& result) {
  const GlobalFrequency global = options.globalFrequency ? options.globalFrequency(subject.body, subject.x)
                                                         : globalFrequency(subject.body, subject.x);
  if (!global.converged) {
    result.failure = fmt::format(
        "{}: the global eigenvalue did not converge after {} tangent products; the bracket holds without it",
        options.mesh.string(), global.products);
    return std::nullopt;
  }
  const double step = subject.rule()(global.lambda);
  result.json["critical_step"]["global"] = step;
  result.text += fmt::format("  global      {:.10g} s   the exact value, {} tangent products\n", step, global.products);
  return step;
}

void reportControllingElement(const ElementFigures& element, InspectResult& result) {
  const ElementQuality& q = element.quality;
  result.json["controlling_element"] = element.json;
  result.text +=
      fmt::format("controlling element: {}\n  volume {:.5g} m3, least height {:.5g} m, edges {:.5g} to {:.5g} m",
                  element.text, q.volume, q.minHeight, q.minEdge, q.maxEdge);
  if (!std::isnan(q.minDihedral))
    result.text += fmt::format(", dihedral angles {:.4g} to {:.4g} degrees", q.minDihedral, q.maxDihedral);
  result.text += "\n";
}

/// Which elements are too small for a step, and what the bracket says of it.
void reportStep(const Subject& subject, const std::vector<MetricResult>& metrics, const CriticalStep& step, double h,
                InspectResult& result) {
  result.json["ill_shaped"] = illShaped(subject, metrics, h);
  const Json& counts = result.json["ill_shaped"]["by_metric"];
  result.text +=
      fmt::format("at h = {:.6g} s: {}; {} of {} elements forbid it by their reduced 1-ring, {} as single elements\n",
                  h, verdictText(verdictOfState(h, step), step), counts["reduced-1-ring"].get<std::size_t>(),
                  subject.body.mesh().elementCount(), counts["single-element"].get<std::size_t>());
}

void reportDistribution(const Subject& subject, const std::vector<MetricResult>& metrics, const CriticalStep& step,
                        const InspectOptions& options, InspectResult& result) {
  const std::vector<Distribution> distributions = distributionsOf(metrics, subject.rule());
  result.json["distribution"] = distributionJson(distributions);
  result.text += distributionText(distributions, options.step);
  // Of the metrics at hand the one that tells elements apart best.
  const auto worst = worstElements(subject.body, metricNamed("reduced-1-ring", metrics, subject), subject.rule(), 10);
  result.json["worst_elements"] = worstJson(subject.body.mesh(), worst);
  result.text += worstText(worst);
  if (options.picture)
    result.text += drawDistribution(*options.picture, distributions, {step.safe, step.optimistic, options.step},
                                    options.mesh.string());
}

/// Of what a factorisation has proven, where one was asked for, else of the bracket.
void writeCertificate(const Subject& subject, const CriticalStep& bracket, const InspectOptions& options,
                      const ProvenSides& sides, InspectResult& result) {
  const bool factored = options.exact || options.prove;
  if (factored && sides.upper.value == 0 && sides.lower.value == 0) {
    result.text += "certificate: not written, since nothing is proven\n";
    return;
  }
  const Certificate certificate = factored ? makeFactoredCertificate(subject.body, subject.x, sides)
                                           : makeCertificate(subject.body, subject.x, UpperSideBy::tighterOfBoth);
  const std::string file = options.certificate->string();
  writeFileAtomically(*options.certificate, std::string_view(certificate.bytes));
  Json& json = result.json["certificate"];
  const std::string body = fmt::format("{:016x}", certifiedBodyHash(subject.body));
  json = Json{{"file", file}, {"bytes", certificate.bytes.size()}, {"body", body}};
  std::string proven;
  if (certificate.upper.value > 0) {
    json["safe"] = safeStep(certificate.upper, subject.rule());
    proven += fmt::format(", {} up to {:.10g} s", stableUpTo(bracket), json["safe"].get<double>());
  }
  if (certificate.lower.value > 0) {
    json["optimistic"] = optimisticStep(certificate.lower, subject.rule());
    proven += fmt::format(", unstable above {:.10g} s", json["optimistic"].get<double>());
  }
  result.text += fmt::format("certificate: {}, {:.3g} MB; what it proves of the body {}, by {}{}\n", file,
                             1e-6 * static_cast<double>(certificate.bytes.size()), body, certificate.proof, proven);
}

void reportHandlerChoice(const Subject& subject, double h, const CriticalStep& step, InspectResult& result) {
  const Json choice = handlerChoice(subject, h);
  result.json["handler"] = choice;
  if (choice.is_null()) return;
  result.text += fmt::format(
      "a handler would take {} of {} elements at h = {:.6g} s (selection {}, margin {}: room for h = {:.6g} s){}\n",
      choice["count"].get<std::size_t>(), subject.body.mesh().elementCount(), h, choice["selection"].get<std::string>(),
      choice["margin"].get<double>(), h / (1 - choice["margin"].get<double>()),
      verdictOfState(h, step) == Verdict::certified
          ? "; the step is proven without one"
          : shareText(choice["count"].get<double>() / static_cast<double>(subject.body.mesh().elementCount())));
}

/// Answers to the questions that were asked, and without one what is proven of every step. found: of all that was
/// asked, but for the conclusion.
std::string conclusionOf(const Subject& subject, const InspectOptions& options, const CriticalStep& step,
                         const Json& found) {
  std::vector<std::string> answers;
  if (options.step)
    answers.push_back(
        fmt::format("a step of {:.6g} s is {}", *options.step, verdictText(verdictOfState(*options.step, step), step)));
  if (options.prove)
    answers.push_back(
        fmt::format("a step of {:.6g} s is {} by a factorisation", *options.prove,
                    verdictText(verdictNames.valueOf("verdict", found["prove"]["verdict"].get<std::string>()), step)));
  if (const auto exact = found["critical_step"].find("exact"); exact != found["critical_step"].end())
    answers.push_back(step.indefinite()
                          ? indefiniteText(step)
                          : fmt::format("the critical step lies between {:.10g} and {:.10g} s",
                                        exact->at("safe").get<double>(), exact->at("optimistic").get<double>()));
  if (options.stretch)
    answers.push_back(
        fmt::format("in every state of stretches {:.4g} to {:.4g} that is not indefinite every step up to "
                    "{:.6g} s is proven stable",
                    options.stretch->low, options.stretch->high, found["stretch"]["safe"].get<double>()));
  if (const auto own = found.find("timestep"); own != found.end() && answers.empty())
    answers.push_back(fmt::format("the file's step of {:.6g} s is {}", own->at("asked").get<double>(),
                                  verdictText(verdictNames.valueOf("verdict", own->at("verdict").get<std::string>()),
                                              step, subject.scene.mayBeStable)));
  return answers.empty() ? provenText(step) : fmt::format("{}", fmt::join(answers, "; "));
}

}  // namespace

InspectResult inspectMesh(const InspectOptions& options) {
  const std::vector<std::string> wanted = metricsWanted(options.metrics, !options.bracket);
  checkOptions(options);
  Subject subject = subjectOf(options);
  if (options.stretch) requireTaken(subject.scene, SceneUse::stretch);
  for (std::string& note : bodyNotes(subject.body)) subject.notes.push_back(std::move(note));
  const auto quality = meshQuality(subject.body.mesh());

  InspectResult result;
  reportMesh(figuresOf(subject, quality), subject.stateJson, options, result);
  const CriticalStep step = reportBracket(subject, options, result);
  if (options.global || options.exact)
    subject.referTo(exactTolerance, [&](const StepRule& rule) {
      const std::optional<TopQuotient> top = topQuotient(subject.body, subject.x);
      return top ? optimisticStep(top->lower, rule) : std::numeric_limits<double>::quiet_NaN();
    });
  std::optional<double> globalStep;
  if (options.global) globalStep = reportGlobalStep(subject, options, result);
  ProvenSides sides;
  if (options.exact) sides = reportExactStep(subject, step, options, result);
  if (subject.scene.ofModel && (subject.scene.step || subject.scene.ownStep)) answerOwnStep(subject, step, result);
  if (options.stretch) reportRange(subject, *options.stretch, result);

  std::vector<MetricResult> metrics;
  for (const std::string& name : wanted) {
    ProgressLine progress(true);
    metrics.push_back(evaluateMetric(name, subject.body, subject.x, [&](double done) {
      if (progress.due()) progress.show(fmt::format("{}: {:.0f} %", name, 100 * done), done);
    }));
  }
  if (!metrics.empty()) reportMetrics(metrics, subject, globalStep, result.json["critical_step"], result.text);
  reportControllingElement(
      {elementJson(subject.body.mesh(), step.controlling), elementText(subject.body.mesh(), step.controlling),
       quality[step.controlling.block][step.controlling.element]},
      result);
  Json& why = result.json["why"] = stepReasons(subject.body, subject.x, subject.rule(), *subject.integrator, step);
  const auto ring =
      std::ranges::find(metrics, "reduced-1-ring", [](const MetricResult& one) { return one.info->name; });
  addRemedies(why, subject.body, subject.x, subject.rule(), *subject.integrator, StepWithout::proven,
              ring == metrics.end() ? nullptr : &*ring);
  result.text += reasonsText(why, "  ", "\n");
  const std::string limit = why.is_null() ? "" : "; " + limitText(why);
  if (options.step) reportStep(subject, metrics, step, *options.step, result);
  if (options.prove) sides = reportProof(subject, *options.prove, step, result);
  result.json["conclusion"] = conclusionOf(subject, options, step, result.json) + limit;
  if (options.distribution || options.picture) reportDistribution(subject, metrics, step, options, result);
  if (options.certificate) writeCertificate(subject, step, options, sides, result);
  if (options.vtu) writeMetricsVtu(*options.vtu, subject, metrics, step, options.step, quality);
  if (options.step) reportHandlerChoice(subject, *options.step, step, result);
  if (options.page)
    options.page({options.mesh.filename().string(), subject.state, subject.body, subject.x, *subject.integrator,
                  subject.rule(), subject.scene.damping, step, metrics, options.step, result.json, subject.notes});
  return result;
}

InspectResult inspectParts(const InspectOptions& options, InspectedParts& parts) {
  checkOptions(options);
  const Scene scene = sceneOfMeshFile(options);
  const IntegratorInfo& integrator = integratorNamed(scene.method);
  InspectResult result;
  reportMesh(parts.read(scene), "rest", options, result);
  const CriticalStep step = parts.bracket(StepRule(integrator.imaginaryLimit));
  result.text += headOfBracket("at rest", modelsText(scene.materials), integrator, false);
  reportSides(step, "", result);
  reportControllingElement(parts.element(step.controlling), result);
  result.json["why"] = nullptr;  // no process has all elements
  result.json["conclusion"] = provenText(step);
  return result;
}

}  // namespace ringwatch

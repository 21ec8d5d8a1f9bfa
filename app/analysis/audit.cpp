#include <ringwatch/app/analysis/audit.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include <fmt/format.h>

#include <ringwatch/app/analysis/step_answer.h>
#include <ringwatch/app/output/junit.h>
#include <ringwatch/app/output/progress.h>
#include <ringwatch/app/output/report.h>
#include <ringwatch/app/scene/capabilities.h>
#include <ringwatch/app/scene/integrator_catalog.h>
#include <ringwatch/app/scene/scene.h>
#include <ringwatch/app/scene/scene_discrete.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/user_text.h>
#include <ringwatch/meshes/check.h>
#include <ringwatch/meshes/number_index.h>
#include <ringwatch/meshes/results.h>
#include <ringwatch/monitor/critical_step.h>
#include <ringwatch/monitor/event.h>
#include <ringwatch/monitor/stability_monitor.h>

namespace ringwatch {
namespace {

using Json = nlohmann::ordered_json;

/// What is said of the results with every audit.
constexpr std::string_view honestLimit =
    "Each bracket is proven for the tangent of this law, with lumped masses, at that state alone. Contact, plasticity, "
    "mass scaling and whatever else the other program has that the scene has not are not in it: such a model hands its "
    "element "
    "tangents over (docs/embedding.md). Between two states nothing is proven.";

/// What is said of a state where something is wrong, in the conclusion and of its test case.
constexpr std::string_view stepIsUnstable = "the step is proven unstable", stateIsLost = "the state is lost",
                           elementIsInverted = "an element is inverted",
                           tangentIsIndefinite = "the tangent is indefinite",
                           stepIsOpen = "the step is neither proven stable nor unstable",
                           stepIsUnknown = "the results do not tell which step was taken; --step h holds one against";

Scene sceneOfAudit(const AuditOptions& options) {
  if (!options.scene.empty()) {
    std::vector<std::string> overrides;
    if (options.density) overrides.push_back(fmt::format("material.density={}", *options.density));
    return isModelFile(options.scene) ? sceneOfModel(options.scene, DeckUse::model, overrides)
                                      : readScene(options.scene, overrides);
  }
  Scene scene;
  SceneMaterial& material = scene.materials.emplace_back();
  material.model = options.model.empty() ? "stvk" : options.model;
  const std::string missing = missingConstants(material.model, options.parameters, options.density);
  if (!missing.empty()) throw InputError(missing + ", or --scene with the materials; see ringwatch audit --help");
  material.density = *options.density;
  scene.method = "symplectic-euler";
  scene.meshOrigin = options.results.front().string();
  return scene;
}

void applyLaw(Scene& scene, const AuditOptions& options) {
  const bool own = options.parameters.begin() != options.parameters.end();
  if (scene.materials.size() > 1 && (own || !options.model.empty()))
    throw InputError(fmt::format("--{}: {} has {} materials; leave it out, all are those of the scene",
                                 options.model.empty() ? options.parameters.begin()->first : "model",
                                 options.scene.string(), scene.materials.size()));
  SceneMaterial& material = scene.materials.front();
  if (!options.model.empty() && options.model != material.model) {
    const LawInfo& law = lawNamed(options.model);
    Options kept;
    for (const auto& [name, value] : material.parameters)
      if (findOption(law.parameters, name)) kept.set(name, value);
    material.model = options.model;
    material.parameters = std::move(kept);
  }
  for (const auto& [name, value] : options.parameters) material.parameters.set(name, value);
  for (const std::string& text : options.fix) scene.fixes.push_back(parseFix(text, "--fix"));
  overrideRules(scene, options.rules, "--rule");
  scene.lumping = options.lumping.value_or(scene.lumping);
  useUnits(options.units.value_or(scene.units));
}

/// A rule of the steps that is exact at the safe step of a body's state.
using RuleAt = std::function<StepRule(Body&, const NodeVectors&)>;

/// The rule of the run's steps, its limit h omega, and the integrator, where that is known, which becomes the scene's.
/// scene: by reference.
RuleAt ruleOf(Scene& scene, const AuditOptions& options, double& limit, const IntegratorInfo*& integrator) {
  integrator = nullptr;
  if (options.limit) {
    if (!(*options.limit > 0 && std::isfinite(*options.limit)))
      throw InputError(fmt::format("--limit: {} is out of range; must be > 0", *options.limit));
    if (!options.integrator.empty()) throw InputError("--limit: goes without --integrator, whose limit is known");
    if (scene.hasElementDamping())
      throw InputError("--limit: elements damp, whose share of the limit is known by --integrator alone");
    limit = *options.limit;
    return [limit](const Body&, const NodeVectors&) { return StepRule(limit); };
  }
  scene.method = options.integrator.empty() ? "symplectic-euler" : options.integrator;
  const IntegratorInfo* info = integratorCatalog().find(scene.method);
  if (info == nullptr || !hasCriticalStep(*info))
    throw InputError(
        fmt::format("--integrator: {} is no integrator with a critical step; ringwatch help integrators "
                    "has those, and --limit takes a number",
                    inQuotes(scene.method)));
  integrator = info;
  limit = info->imaginaryLimit;
  return [&scene](Body& body, const NodeVectors& x) {
    return ruleAtOwnStep(scene, body, DampingRates::atRest, ownStepTolerance, stepOfTopMode(body, x)).rule;
  };
}

/// Which node of the results each node of the body is, by their numbers or, where these are not the same, by the order
/// of the numbers or that of the meshes; -1 for one that the results lack, which is at rest.
std::vector<std::int32_t> sameNodes(const Mesh& body, const Mesh& results, const std::string& where) {
  using Nodes = std::vector<std::int32_t>;
  const double size = (body.X.rowwise().maxCoeff() - body.X.rowwise().minCoeff()).norm();
  const auto apart = [&](const Nodes& same, std::size_t i) {
    return same[i] < 0 ? 0 : (body.X.col(static_cast<Eigen::Index>(i)) - results.X.col(same[i])).norm();
  };
  const auto firstAstray = [&](const Nodes& same) {
    std::size_t i = 0;
    while (i < same.size() && apart(same, i) <= 1e-4 * size) ++i;
    return i;
  };
  Nodes byNumber(body.nodeCount(), -1);
  NumberIndex index(results);
  for (std::size_t i = 0; i < byNumber.size(); ++i)
    if (const auto node = index.node(body.nodeId(static_cast<std::int32_t>(i)))) byNumber[i] = *node;
  const bool none = std::ranges::all_of(byNumber, [](std::int32_t node) { return node < 0; });
  if (!none && firstAstray(byNumber) == byNumber.size()) return byNumber;
  if (body.nodeCount() == results.nodeCount()) {
    const auto listed = [](const Mesh& mesh) {
      Nodes nodes(mesh.nodeCount());
      std::iota(nodes.begin(), nodes.end(), 0);
      return nodes;
    };
    const auto sorted = [&](const Mesh& mesh) {
      Nodes nodes = listed(mesh);
      std::ranges::stable_sort(nodes, {}, [&](std::int32_t node) { return mesh.nodeId(node); });
      return nodes;
    };
    Nodes byOrder(body.nodeCount());
    const Nodes own = sorted(body), theirs = sorted(results);
    for (std::size_t k = 0; k < own.size(); ++k) byOrder[static_cast<std::size_t>(own[k])] = theirs[k];
    for (const Nodes& same : {byOrder, listed(results)})
      if (firstAstray(same) == same.size()) return same;
  }
  if (none)
    throw InputError(fmt::format("{}: {} nodes, none of which is one of the {} of the scene's mesh", where,
                                 results.nodeCount(), body.nodeCount()));
  const std::size_t i = firstAstray(byNumber);
  throw InputError(
      fmt::format("{}: node {} lies {:.3g} m from where the scene's mesh has it at rest; they must be of the same mesh",
                  where, body.nodeId(static_cast<std::int32_t>(i)), apart(byNumber, i)));
}

/// The step that is told at a; else the mean by the times and increments of neighbouring states.
std::optional<double> stepFrom(const ResultEntry& a, const ResultEntry& b) {
  if (a.step) return a.step;
  if (!a.time || !b.time || !a.increment || !b.increment) return std::nullopt;
  const double time = *b.time - *a.time;
  const auto steps = static_cast<double>(*b.increment - *a.increment);
  if (!(time > 0) || !(steps > 0)) return std::nullopt;
  return time / steps;
}

std::vector<std::optional<double>> stepsTaken(const std::vector<ResultEntry>& entries, const AuditOptions& options,
                                              const Scene& scene) {
  std::vector<std::optional<double>> steps(entries.size());
  if (options.step) {
    std::fill(steps.begin(), steps.end(), options.step);
    return steps;
  }
  for (std::size_t i = 0; i + 1 < entries.size(); ++i) steps[i] = stepFrom(entries[i], entries[i + 1]);
  const ResultEntry& last = entries.back();
  if (last.step)
    steps.back() = last.step;
  else if (entries.size() > 1)
    steps.back() = steps[entries.size() - 2];
  else
    steps.back() = stepFrom({0.0, 0, {}, ""}, last);  // the first increments begin at rest
  for (std::optional<double>& step : steps)
    if (!step && scene.step && !options.scene.empty()) step = scene.step;
  return steps;
}

/// body: nullptr where every element is deleted.
AuditedState audited(Body* body, const NodeVectors& x, const RuleAt& ruleAt, AuditedState state) {
  for (Eigen::Index i = 0; i < x.cols(); ++i) state.notFinite += x.col(i).allFinite() ? 0 : 1;
  if (state.notFinite > 0) {
    state.why = fmt::format("{} of {} nodes are not finite", state.notFinite, x.cols());
    return state;
  }
  if (body == nullptr) {
    state.why = "every element is deleted";
    return state;
  }
  state.least = body->leastDeterminant(x, Body::Among::whereInversionIsAnError);
  Body::Workspace workspace;
  state.strainEnergy = body->energy(x, workspace);
  try {
    state.bracket = criticalStep(*body, x, ruleAt(*body, x));
  } catch (const NumericalError& fault) {
    state.why = fault.what();
  }
  return state;
}

/// The audited body without the elements that the other program has deleted; their masses stay at their nodes.
class StandingBody {
 public:
  /// same: as by sameNodes(); empty where the body is that of the results. By reference.
  StandingBody(Body& whole, const std::vector<std::int32_t>& same) : whole_(whole), same_(same) {}

  /// deleted: elements of the results, which the body has with the same nodes. nullptr where no element is left.
  Body* without(const std::vector<std::vector<bool>>& deleted, const Mesh& results, const std::string& where) {
    if (deleted != deleted_) {
      deleted_ = deleted;
      left_.reset();
      stays_.clear();
      count_ = 0;
      for (const MeshBlock& block : whole_.mesh().blocks) stays_.emplace_back(block.elementCount(), true);
      for (std::size_t b = 0; b < deleted.size(); ++b)
        for (std::size_t e = 0; e < deleted[b].size(); ++e) {
          if (!deleted[b][e]) continue;
          const ElementRef own = same_.empty() ? ElementRef{b, e} : inBody(results.blocks[b], e, where);
          stays_[static_cast<std::size_t>(own.block)][static_cast<std::size_t>(own.element)] = false;
          ++count_;
        }
      if (count_ > 0 && count_ < whole_.mesh().elementCount()) left_.emplace(whole_, stays_);
    }
    return left_ ? &*left_ : count_ == 0 ? &whole_ : nullptr;
  }
  std::size_t deletedElements() const { return count_; }
  /// The place in the whole body of an element that is left.
  ElementRef inWhole(ElementRef left) const {
    if (!left_) return left;
    const std::vector<bool>& stays = stays_[static_cast<std::size_t>(left.block)];
    std::size_t e = 0;
    for (std::int32_t before = 0; e < stays.size() && (!stays[e] || before < left.element); ++e)
      before += stays[e] ? 1 : 0;
    return {left.block, e};
  }

 private:
  using Nodes = std::vector<std::int32_t>;  // of an element, in the results, sorted
  static Nodes nodesOf(const MeshBlock& block, std::size_t e) {
    Nodes nodes(block.element(e), block.element(e) + block.nodesPerElement());
    std::ranges::sort(nodes);
    return nodes;
  }
  ElementRef inBody(const MeshBlock& block, std::size_t e, const std::string& where) {
    if (elements_.empty())
      for (std::size_t b = 0; b < whole_.mesh().blocks.size(); ++b) {
        MeshBlock own = whole_.mesh().blocks[b];
        for (std::int32_t& node : own.connectivity) node = same_[static_cast<std::size_t>(node)];
        for (std::size_t k = 0; k < own.elementCount(); ++k) elements_.try_emplace(nodesOf(own, k), ElementRef{b, k});
      }
    const auto found = elements_.find(nodesOf(block, e));
    if (found != elements_.end()) return found->second;
    throw InputError(
        fmt::format("{}: element {} is deleted, which the scene's mesh does not have", where, block.id(e)));
  }

  Body& whole_;
  const std::vector<std::int32_t>& same_;
  std::map<Nodes, ElementRef> elements_;
  std::vector<std::vector<bool>> deleted_, stays_;
  std::optional<Body> left_;
  std::size_t count_ = 0;
};

std::string numberText(std::optional<double> value) {
  return value && std::isfinite(*value) ? fmt::format("{:.6g}", *value) : "-";
}

std::string verdictText(const AuditedState& state) {
  if (state.lost()) return "lost";
  const auto verdict = state.verdict();
  return verdict ? std::string(verdictName(*verdict)) : "-";
}

Json stateJson(const Mesh& mesh, const AuditedState& state) {
  const auto orNull = [](const auto& value) { return value ? Json(*value) : Json(); };
  Json json{
      {"state", state.index + 1},
      {"where", state.where},
      {"time", orNull(state.time)},
      {"increment", orNull(state.increment)},
      {"step", orNull(state.step)},
      {"safe", state.bracket ? Json(state.bracket->safe) : Json()},
      {"optimistic", state.bracket ? Json(state.bracket->optimistic) : Json()},
      {"verdict", verdictText(state)},
      {"controlling_element", state.bracket ? elementJson(mesh, state.bracket->controlling) : Json()},
      {"strain_energy", std::isfinite(state.strainEnergy) && state.notFinite == 0 ? Json(state.strainEnergy) : Json()},
      {"least_determinant", state.least && std::isfinite(state.least->value) ? Json(state.least->value) : Json()},
      {"inverted", state.inverted()},
      {"indefinite", state.indefinite()},
      {"not_finite_nodes", state.notFinite},
      {"deleted_elements", state.deleted}};
  if (!state.why.empty()) json["why"] = state.why;
  return json;
}

/// "state 4 at t = 0.1 s"
std::string nameOf(const AuditedState& state) {
  return fmt::format("state {}{}", state.index + 1, state.time ? fmt::format(" at t = {:.6g} s", *state.time) : "");
}

class AuditReport {
 public:
  /// every: so many states of the results lie from one of these to the next.
  AuditReport(const Body& body, const std::vector<AuditedState>& states, int every)
      : body_(body), states_(states), every_(every) {}

  void write(AuditResult& result, std::vector<AuditEvent>& events, bool all) const {
    table(result.text, all);
    Json& first = result.json["first"] = Json::object();
    const auto event = [&](const char* key, const char* what, const auto& holds, const auto& detail) {
      const auto found = std::find_if(states_.begin(), states_.end(), holds);
      first[key] = found == states_.end()
                       ? Json()
                       : Json{{"state", found->index + 1}, {"time", found->time ? Json(*found->time) : Json()}};
      if (found == states_.end()) return false;
      const std::string text = fmt::format("{}: {}{}", what, nameOf(*found), detail(*found));
      result.text += text + "\n";
      events.push_back({key, what, text, static_cast<std::size_t>(found - states_.begin())});
      return true;
    };
    const auto element = [&](ElementRef e) { return elementText(body_.mesh(), e); };
    event(
        "not_certified", "first step that is not proven stable",
        [](const AuditedState& s) { return s.verdict() && s.verdict() != Verdict::certified; },
        [](const AuditedState& s) {
          return fmt::format(": h = {:.6g} s, safe {:.6g} s{}", *s.step, s.bracket->safe,
                             s.indefinite() ? "; " + indefiniteText(*s.bracket) : "");
        });
    const bool violated = event(
        "violated", "first step that is proven unstable", [](const AuditedState& s) { return s.violated(); },
        [&](const AuditedState& s) {
          return fmt::format(": h = {:.6g} s, above {:.6g} s; controlling {}", *s.step, s.bracket->optimistic,
                             element(s.bracket->controlling));
        });
    event(
        "indefinite", "first indefinite tangent, which no step cures",
        [](const AuditedState& s) { return s.indefinite(); },
        [&](const AuditedState& s) { return fmt::format(": {}", element(s.bracket->lowestRingElement)); });
    const bool inverted = event(
        "inverted", "first inverted element", [](const AuditedState& s) { return s.inverted(); },
        [&](const AuditedState& s) {
          return fmt::format(": det F = {:.4g} in {}", s.least->value, element(s.least->element));
        });
    const bool lost = event(
        "lost", "first state that is lost", [](const AuditedState& s) { return s.lost(); },
        [](const AuditedState& s) { return ": " + s.why; });
    const bool known = std::ranges::any_of(states_, [](const AuditedState& s) { return s.step.has_value(); });
    const bool open =
        std::ranges::any_of(states_, [](const AuditedState& s) { return s.verdict() == Verdict::notCertified; });
    if (violated || inverted || lost)
      result.status = ExitStatus::unstable;
    else if (open || std::ranges::any_of(states_, &AuditedState::indefinite))
      result.status = ExitStatus::notCertified;
    conclude(result, known);
    result.text += fmt::format("note: {}\n", honestLimit);
    result.json["note"] = honestLimit;
  }

 private:
  /// In how many states something is wrong, each with a semicolon behind it; "" where nothing is.
  std::string whatIsWrong() const {
    std::string text;
    const auto tell = [&](std::string_view what, const auto& holds, const std::string& more) {
      if (const auto count = std::ranges::count_if(states_, holds); count > 0)
        text += fmt::format("{} in {} of {} states{}; ", what, count, states_.size(), more);
    };
    const auto excess = [](const AuditedState& state) {
      return state.violated() ? *state.step / state.bracket->optimistic : 0;
    };
    const AuditedState& worst = *std::ranges::max_element(states_, {}, excess);
    tell(stepIsUnstable, &AuditedState::violated,
         fmt::format(", at worst {:.3g} times the largest that may be stable, in {}", excess(worst), nameOf(worst)));
    tell(stateIsLost, &AuditedState::lost, "");
    tell(elementIsInverted, &AuditedState::inverted, "");
    tell(tangentIsIndefinite, &AuditedState::indefinite, "");
    tell(
        stepIsOpen, [](const AuditedState& s) { return s.verdict() == Verdict::notCertified && !s.indefinite(); }, "");
    return text;
  }

  /// What a user asks first: what is wrong, and how large the steps were beside what is proven of the same states.
  void conclude(AuditResult& result, bool known) const {
    Json& steps = result.json["steps"] = nullptr;
    const std::string wrong = whatIsWrong();
    result.json["conclusion"] =
        wrong + (known ? "no step is proven stable" : fmt::format("{} the brackets", stepIsUnknown));
    const AuditedState* closest = nullptr;
    double largest = 0, least = infinity;
    for (const AuditedState& state : states_) {
      if (!state.verdict() || state.indefinite()) continue;
      const auto share = [](const AuditedState& of) { return *of.step / of.bracket->safe; };
      if (!closest || share(state) > share(*closest)) closest = &state;
      largest = std::max(largest, *state.step);
      least = std::min(least, state.bracket->safe);
    }
    if (!closest || !std::isfinite(least)) return;
    const double share = *closest->step / closest->bracket->safe;
    steps =
        Json{{"largest", largest}, {"largest_share", share}, {"state", closest->index + 1}, {"proven_in_all", least}};
    const auto compared =
        std::ranges::count_if(states_, [](const AuditedState& s) { return s.verdict() && !s.indefinite(); });
    const bool all = compared == std::ssize(states_);
    result.json["conclusion"] =
        fmt::format("{}the step came to {:.3g} times the proven one, in {}; {:.6g} s is proven in {}{}", wrong, share,
                    nameOf(*closest), least,
                    all ? (every_ > 1 ? fmt::format("the {} states that were examined", compared) : "every state")
                        : fmt::format("the {} of {} states that have a proven step", compared, states_.size()),
                    wrong.empty() && all && every_ == 1 && least > largest
                        ? fmt::format(": the run could have been {:.3g} times shorter", least / largest)
                        : "");
  }

  void table(std::string& text, bool all) const {
    text += fmt::format("  {:>6} {:>12} {:>12} {:>12} {:>12}  {:<13} {:>12}  {}\n", "state", "time (s)", "step (s)",
                        "safe (s)", "optim. (s)", "verdict", "strain (J)", "controlling element");
    constexpr std::size_t usual = 30;
    const std::size_t stride = all ? 1 : std::max<std::size_t>(1, (states_.size() + usual - 1) / usual);
    std::string before;
    for (std::size_t i = 0; i < states_.size(); ++i) {
      const AuditedState& s = states_[i];
      const std::string verdict = verdictText(s);
      // Where the verdict changes there is always a line.
      if (i % stride == 0 || i + 1 == states_.size() || verdict != before) {
        text += fmt::format("  {:>6} {:>12} {:>12} {:>12} {:>12}  {:<13} {:>12}  {}\n", s.index + 1, numberText(s.time),
                            numberText(s.step), s.bracket ? numberText(s.bracket->safe) : "-",
                            s.bracket ? numberText(s.bracket->optimistic) : "-",
                            s.inverted() && !s.lost() ? verdict + ", inv." : verdict,
                            s.notFinite > 0 ? "-" : numberText(s.strainEnergy),
                            s.bracket ? shortElement(s.bracket->controlling) : shortened(s.why));
      }
      before = verdict;
    }
  }
  std::string shortElement(ElementRef e) const {
    const MeshBlock& block = body_.mesh().blocks[e.block];
    return fmt::format("{} {}", elementInfo(block.type).name, block.id(e.element));
  }

  const Body& body_;
  const std::vector<AuditedState>& states_;
  int every_;
};

}  // namespace

std::string junitOfStates(const Json& audit) {
  std::vector<JunitCase> cases;
  for (const Json& state : audit["history"]) {
    const auto verdict = state["verdict"].get<std::string>();
    std::vector<std::string> faults;
    if (verdict == "lost") {
      faults.emplace_back(stateIsLost);
      if (state.contains("why")) faults.push_back(state["why"].get<std::string>());
    }
    if (verdict == "violated") faults.emplace_back(stepIsUnstable);
    if (state["inverted"]) faults.emplace_back(elementIsInverted);
    if (state["indefinite"]) faults.emplace_back(tangentIsIndefinite);
    if (verdict == "not-certified" && !state["indefinite"]) faults.emplace_back(stepIsOpen);
    JunitCase& one = cases.emplace_back(
        JunitCase{fmt::format("state {}, {}", state["state"].get<int>(), state["where"].get<std::string>())});
    if (faults.empty() && verdict == "-") {
      one.skipped = fmt::format("{} the safe one, {} s", stepIsUnknown, state["safe"].dump());
      continue;
    }
    std::string step = state["step"].is_null() ? "" : fmt::format("step {} s", state["step"].dump());
    if (!step.empty() && !state["indefinite"] && state["safe"].is_number() && state["safe"] > 0)
      step += fmt::format(", {:.3g} times the proven one, {} s, optimistic {} s",
                          state["step"].get<double>() / state["safe"].get<double>(), state["safe"].dump(),
                          state["optimistic"].dump());
    if (faults.empty())
      one.output = step;
    else
      one.failure = fmt::format("{}{}{}", fmt::join(faults, ", "), step.empty() ? "" : ": ", step);
  }
  return junitText(audit["results"].get<std::string>(), "ringwatch.audit", cases,
                   audit["conclusion"].get<std::string>());
}

AuditResult auditResults(const AuditOptions& options) {
  Scene scene = sceneOfAudit(options);
  applyLaw(scene, options);
  double limit = 0;
  const IntegratorInfo* integrator = nullptr;
  const RuleAt ruleAt = ruleOf(scene, options, limit, integrator);
  requireTaken(scene, SceneUse::audit);
  std::vector<std::string> notes;
  if (scene.quadraticBulkViscosity > 0)
    notes.push_back(
        "the results tell no velocities: quadratic bulk viscosity, which shortens the step of elements while they are "
        "pressed together, is not counted; all other damping is");
  const ResultSeries series(options.results, options.displacement, &notes);
  const std::string name = options.results.front().string();

  Mesh mesh = options.scene.empty() ? series.mesh() : sceneMesh(scene, notes);
  if (options.scene.empty()) requireSound(mesh, name, &notes);
  // Loads and motions do not change the tangent; nodes that move as prescribed are no unknowns.
  for (const Scene::Move& move : scene.moves) scene.fixes.push_back({move.nodes, move.components});
  scene.moves.clear();
  scene.forces.clear();
  scene.initials.clear();
  scene.pressures.clear();
  Body body = sceneBody(scene, std::move(mesh), options.threads);
  const std::vector<std::int32_t> same =
      options.scene.empty() ? std::vector<std::int32_t>() : sameNodes(body.mesh(), series.mesh(), name);

  const std::vector<ResultEntry>& entries = series.entries();
  const std::vector<std::optional<double>> steps = stepsTaken(entries, options, scene);
  const auto positions = [&](std::size_t i) {
    NodeVectors theirs = series.positions(i);
    if (same.empty()) return theirs;
    NodeVectors x = body.mesh().X;
    for (Eigen::Index k = 0; k < x.cols(); ++k)
      if (const std::int32_t node = same[static_cast<std::size_t>(k)]; node >= 0)
        x.col(k) += theirs.col(node) - series.mesh().X.col(node);
    return x;
  };
  std::vector<AuditedState> states;
  ProgressLine progress(true);
  StandingBody standing(body, same);
  for (std::size_t i = 0; i < entries.size(); i += static_cast<std::size_t>(options.every)) {
    Body* left = standing.without(series.deleted(i), series.mesh(), entries[i].where);
    states.push_back(
        audited(left, positions(i), ruleAt, {i, entries[i].time, steps[i], entries[i].increment, entries[i].where}));
    AuditedState& state = states.back();
    state.deleted = standing.deletedElements();
    if (state.least) state.least->element = standing.inWhole(state.least->element);
    if (state.bracket)
      for (ElementRef* element :
           {&state.bracket->controlling, &state.bracket->lowestRingElement, &state.bracket->worstConditioned})
        *element = standing.inWhole(*element);
    const double done = static_cast<double>(i + 1) / static_cast<double>(entries.size());
    if (progress.due()) progress.show(fmt::format("state {} of {}", i + 1, entries.size()), done);
  }
  progress.clear();
  if (const auto most = std::ranges::max_element(states, {}, &AuditedState::deleted); most->deleted > 0)
    notes.push_back(
        fmt::format("elements that the other program has deleted are left out of their states, {} of {} in "
                    "state {}; their masses stay at their nodes",
                    most->deleted, body.mesh().elementCount(), most->index + 1));
  // Last of all, so that the body counts its damping by the rule that the page is given.
  const StepRule rule = ruleAt(body, body.mesh().X);
  const CriticalStep rest = criticalStep(body, body.mesh().X, rule);

  AuditResult result;
  result.json = Json{{"results", name},
                     {"states", entries.size()},
                     {"law", modelsText(scene.materials)},
                     {"limit", limit},
                     {"displacement", series.displacement()},
                     {"mesh", meshJson(body.mesh(), body.volume())},
                     {"mass", body.totalMass()},
                     {"at_rest", {{"safe", rest.safe}, {"optimistic", rest.optimistic}}}};
  Json list = Json::array();
  for (const AuditedState& state : states) list.push_back(stateJson(body.mesh(), state));
  result.text = fmt::format("{}: {} states, {} nodes, {}; {}, limit h omega = {:.6g}\n", name, entries.size(),
                            body.mesh().nodeCount(), elementCounts(body.mesh()), modelsText(scene.materials), limit);
  for (const std::string& note : notes) result.text += fmt::format("  note: {}\n", note);
  result.text += fmt::format("  at rest: safe {:.6g} s, optimistic {:.6g} s\n", rest.safe, rest.optimistic);
  std::vector<AuditEvent> events;
  AuditReport(body, states, options.every).write(result, events, options.all);
  result.json["history"] = std::move(list);
  if (options.page)
    options.page({name, body, integrator, rule, scene.damping, states, events,
                  [&](const AuditedState& state) { return positions(state.index); }, result.json, notes});
  return result;
}

}  // namespace ringwatch

#include <ringwatch/app/analysis/advise.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include <ringwatch/app/analysis/advised_runs.h>
#include <ringwatch/app/analysis/scene_start.h>
#include <ringwatch/app/output/elements_in_the_way.h>
#include <ringwatch/app/output/progress.h>
#include <ringwatch/app/output/report.h>
#include <ringwatch/app/scene/integrator_catalog.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/user_text.h>
#include <ringwatch/handlers/handler.h>
#include <ringwatch/handlers/selection/selection.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/monitor/critical_step.h>
#include <ringwatch/verify/work_precision/work_precision.h>

namespace ringwatch {
namespace {

using Json = nlohmann::ordered_json;

enum class Kind { explicitly, handler, implicitly };
constexpr std::string_view kindNames[] = {"explicit", "handler", "implicit"};

/// Gain of the step from which remeshing is worth a word.
constexpr double worthRemeshing = 1.05;

/// Gain of computing time up to which two ways are called equally fast: one call measures that much more than another.
constexpr double noDifference = 1.25;

/// A way to take the step, and how its trial went.
struct Way {
  std::string name;
  Kind kind;
  std::string why;          // it cannot be taken, or was lost; then only the name counts
  std::string notRun = {};  // why its trial was all, where others were run
  double step = 0, error = 0, seconds = 0;
  std::size_t elements = 0;              // handled
  std::optional<double> addedMass = {};  // kg
  std::optional<AdvisedRuns::Run> run = {};
};

class Trials {
 public:
  /// safe: the step that is proven at the start, s.
  Trials(const AdviseOptions& options, const SceneStart& start, double h, double time, double safe)
      : start_(start),
        system_(start.body, start.scene.damping),
        h_(h),
        safe_(safe),
        end_(time),
        progress_(options.progress) {
    const double lambda = start.rule.lambdaFor(safe);
    progress_.announce("converging a motion to compare with");
    // A hundredth of what is allowed: the comparison is not its error.
    const ConvergedMotion motion = convergedMotion(system_, start.state, end_, lambda, 0.01 * options.error);
    if (!motion.moves)
      throw InputError(
          fmt::format("{}: nothing moves in {:.6g} s; give a force, a velocity at the start or a prescribed motion",
                      start.scene.file.string(), end_));
    case_.emplace(WorkPrecisionCase{
        start.scene.file.stem().string(), "", system_, start.state, end_, lambda, motion.x, motion.change, {}, {}});
  }

  std::vector<Way> all() {
    std::vector<Way> ways;
    ways.push_back(plain(start_.scene.method, Kind::explicitly, start_.scene.safety * safe_));
    for (const HandlerEntry& entry : allHandlers()) ways.push_back(handled(*entry.info));
    for (const IntegratorEntry& entry : integratorCatalog().entries())
      if (std::isinf(entry.info->imaginaryLimit) && !entry.info->partitioned)
        ways.push_back(plain(std::string(entry.info->name), Kind::implicitly, h_));
    progress_.clear();
    return ways;
  }

 private:
  Way plain(const std::string& name, Kind kind, double h) {
    progress_.announce("trying " + name);
    return from(runPrepared(*case_, name, h,
                            [&](double) {
                              return PreparedRun{integratorCatalog().make(name), systemOf(start_.body)};
                            }),
                kind);
  }

  /// With a body of its own, which the handler may change.
  Way handled(const HandlerInfo& info) {
    progress_.announce(fmt::format("trying {}", info.name));
    Way way{std::string(info.name), Kind::handler, dampingRefusedBy(info, start_.scene.damping).second};
    if (!way.why.empty()) return way;
    const double mass = start_.body.totalMass();
    std::size_t elements = 0;
    double heavier = mass;
    try {
      way = from(runPrepared(*case_, info.name, h_,
                             [&](double step) {
                               auto body = std::make_shared<Body>(copyOf(start_.body));
                               auto handler =
                                   makeHandler(std::string(info.name), *body, makeIntegrator(start_.scene.method),
                                               optionsFor(info, start_.scene.handlerOptions));
                               handler->prepare(start_.state.x, step);
                               elements = handler->elements().size();
                               heavier = body->totalMass();
                               return PreparedRun{std::move(handler), systemOf(*body), body};
                             }),
                 Kind::handler);
    } catch (const std::runtime_error& fault) {
      way = {std::string(info.name), Kind::handler, fault.what()};
    }
    way.elements = elements;
    if (info.addsMass) way.addedMass = heavier - mass;
    return way;
  }

  std::unique_ptr<SecondOrderSystem> systemOf(const Body& body) const {
    return std::make_unique<BodySystem>(body, start_.scene.damping);
  }

  static Way from(const WorkPrecisionRun& run, Kind kind) {
    Way way{run.integrator, kind, run.reason};
    way.step = run.h;
    way.error = run.error;
    way.seconds = run.seconds;
    return way;
  }

  const SceneStart& start_;
  BodySystem system_;
  double h_, safe_, end_;
  ProgressLine progress_;
  std::optional<WorkPrecisionCase> case_;
};

/// The time up to which the body of a scene stays whole, s.
double wholeUntil(const Scene& scene) {
  return scene.cuts.empty() ? scene.end : std::min(scene.end, scene.cuts.front().time);
}

/// Steps of h (s) that runs of the scene take: as many as are asked for, while the body is whole, and not more than are
/// computed in about a minute.
std::int64_t stepsToRun(const AdviseOptions& options, const SceneStart& start, double h, double own) {
  constexpr double mostWork = 4e8;  // elements times steps of the explicit run
  const double elements = static_cast<double>(start.body.mesh().elementCount());
  return static_cast<std::int64_t>(
      std::min({static_cast<double>(options.runSteps), std::floor(wholeUntil(start.scene) / h + 1e-9),
                mostWork / (elements * h / own)}));
}

/// Runs those that a trial of `time` seconds leaves: the explicit one, which comes first, and what neither errs more
/// than is allowed, or than the explicit one does in the trial, nor is much slower than its run.
void runThose(std::vector<Way>& ways, const AdvisedRuns& runs, double time, double allowed, ProgressLine& progress) {
  constexpr double hopeful = 1.5;  // times as long as explicit
  ways.front().run = runs.explicitRun();
  const double errs = ways.front().why.empty() ? std::max(allowed, ways.front().error) : allowed;
  for (Way& way : ways) {
    if (way.run || !way.why.empty()) continue;
    const double slower = way.seconds * runs.time() / time / ways.front().run->seconds;
    if (!(way.error <= errs))
      way.notRun = fmt::format("an error of {:.2g} in the trial, where {:.2g} is allowed", way.error, errs);
    else if (slower > hopeful)
      way.notRun = fmt::format("by its trial, even without the monitor, it takes {:.3g} times as long", slower);
    if (!way.notRun.empty()) continue;
    progress.announce("running with " + way.name);
    try {
      way.run = way.kind == Kind::handler ? runs.handled(way.name) : runs.implicit(way.name);
    } catch (const std::runtime_error& fault) {
      way.run = AdvisedRuns::Run{.lost = fault.what()};
    }
  }
  progress.clear();
}

/// The trials. Without runs they decide, and have the columns of time; runs decide with the monitor's time, which
/// trials lack.
std::string tellTrials(const std::vector<Way>& ways, double time, std::int64_t steps, double mass, bool decide,
                       Json& json) {
  std::string text = fmt::format(
      "trials over {:.6g} s, {} steps{}; error of the displacement against a converged motion:\n"
      "  {:<18} {:>11} {:>9} {:>13}{} {:>9}\n",
      time, steps, decide ? ", not watched" : "", "", "step (s)", "handled", "added mass, %",
      decide ? fmt::format(" {:>13} {:>9}", "computing, s", "gain") : "", "error");
  for (const Way& one : ways) {
    Json row{{"name", one.name}, {"kind", std::string(kindNames[static_cast<std::size_t>(one.kind)])}};
    if (!one.why.empty()) {
      row["why_not"] = one.why;
      text += fmt::format("  {:<18} not: {}\n", one.name, one.why);
    } else {
      const double gain = ways.front().seconds / one.seconds;
      row.update(Json{{"step", one.step}, {"elements", one.elements}, {"seconds", one.seconds}, {"error", one.error}});
      if (decide) row["gain"] = numberOrNull(gain);
      if (one.addedMass) row["added_mass"] = *one.addedMass;
      text += fmt::format("  {:<18} {:>11.5g} {:>9} {:>13}{} {:>9.2g}\n", one.name, one.step,
                          one.kind == Kind::handler ? fmt::format("{}", one.elements) : "-",
                          one.addedMass ? fmt::format("{:.3g}", 100 * *one.addedMass / mass) : "-",
                          decide ? fmt::format(" {:>13.3g} {:>9.3g}", one.seconds, gain) : "", one.error);
    }
    json["ways"].push_back(std::move(row));
  }
  return text;
}

std::string tellRuns(const std::vector<Way>& ways, const AdvisedRuns& runs, Json& json) {
  json["runs"] = Json{{"steps", runs.steps()}, {"time", runs.time()}, {"mode", std::string(runs.mode())}};
  std::string text = fmt::format(
      "runs over {} steps, {:.6g} s, watched in mode {}, handlers with on_violation = \"handle\":\n"
      "  {:<18} {:>11} {:>13} {:>9} {:>9}\n",
      runs.steps(), runs.time(), runs.mode(), "", "steps", "computing, s", "gain", "error");
  if (!runs.noReference().empty()) {
    json["runs"]["no_reference"] = runs.noReference();
    text += fmt::format("  errors are not known: {}\n", runs.noReference());
  }
  const double explicitly = ways.front().run->seconds;
  for (std::size_t w = 0; w < ways.size(); ++w) {
    if (!ways[w].notRun.empty()) {
      json["ways"][w]["not_run"] = ways[w].notRun;
      text += fmt::format("  {:<18} not run: {}\n", ways[w].name, ways[w].notRun);
    }
    if (!ways[w].run) continue;
    const AdvisedRuns::Run& run = *ways[w].run;
    Json& row = json["ways"][w]["run"];
    if (!run.lost.empty()) {
      row = Json{{"why_not", run.lost}};
      text += fmt::format("  {:<18} lost: {}\n", ways[w].name, run.lost);
      continue;
    }
    row = Json{{"steps", run.steps},
               {"seconds", run.seconds},
               {"gain", numberOrNull(explicitly / run.seconds)},
               {"error", numberOrNull(run.error)}};
    text += fmt::format("  {:<18} {:>11} {:>13.3g} {:>9.3g} {:>9.2g}\n", ways[w].name, run.steps, run.seconds,
                        explicitly / run.seconds, run.error);
  }
  return text;
}

/// What the runs say, or without runs the trials: of nothing else is anything claimed. Among those that are as fast as
/// the fastest, the explicit one is the best, else the one that errs least.
class Advice {
 public:
  /// steps: of what decides.
  Advice(const std::vector<Way>& ways, double allowed, const AdvisedRuns* runs, std::int64_t steps)
      : runs_(runs), allowed_(allowed), explicit_(ways.front()) {
    where_ = fmt::format("{} {} steps{}", runs ? "over" : "in trials of", steps, runs ? "" : ", not watched");
    for (const Way& way : ways) {
      if (runs ? !way.run || !way.run->lost.empty() : !way.why.empty()) continue;
      ++seen_;
      if (errorKnown() ? error(way) <= allowed : runs != nullptr) good_.push_back(&way);
    }
    const auto least = [&](const auto& of) { return *std::ranges::min_element(good_, {}, of); };
    if (good_.empty()) return;
    const double fastest = seconds(*least([&](const Way* way) { return seconds(*way); }));
    std::erase_if(good_, [&](const Way* way) { return way != &explicit_ && seconds(*way) > noDifference * fastest; });
    const bool explicitly = good_.front() == &explicit_ && seconds(explicit_) <= noDifference * fastest;
    best_ = explicitly ? &explicit_ : least([&](const Way* way) {
      return way == &explicit_ ? infinity : errorKnown() ? error(*way) : seconds(*way);
    });
  }

  std::string tell(Json& json) const {
    json["best"] = best_ ? Json(best_->name) : Json(nullptr);
    json["as_fast"] = Json::array();
    const std::string allowed = fmt::format("{:.3g} %", 100 * allowed_);
    if (!best_)
      return fmt::format("none of those that were {} keeps the error {} within {}: take smaller steps",
                         runs_ ? "run" : "tried", where_, allowed);
    std::vector<std::string> asFast;
    for (const Way* way : good_)
      if (way != best_ && way != &explicit_) asFast.push_back(way->name);
    json["as_fast"] = asFast;
    const std::string within =
        errorKnown() ? fmt::format("within an error of {}", allowed) : "whose errors are not known";
    if (best_ == &explicit_)
      return fmt::format(
          "stay with {} at {:.6g} s: {}, {}, {}", best_->name, best_->step, where_, within,
          seen_ == 1 ? fmt::format("nothing else was {}", runs_ ? "run" : "tried to its end")
          : asFast.empty()
              ? fmt::format("none of the {} others that were {} is faster", seen_ - 1, runs_ ? "run" : "tried")
              : fmt::format("none is faster by more than {:.3g} times ({})", noDifference, fmt::join(asFast, ", ")));
    return fmt::format("take {}{}: {}, {}, it is {:.3g} times as fast as {}{}{}",
                       best_->kind == Kind::handler ? "the handler " : "", best_->name, where_, within,
                       seconds(explicit_) / seconds(*best_), explicit_.name,
                       asFast.empty() ? "" : fmt::format("; no slower: {}", fmt::join(asFast, ", ")),
                       runs_ && best_->kind == Kind::handler ? "; set monitor.on_violation = \"handle\"" : "");
  }

 private:
  bool errorKnown() const { return !runs_ || runs_->noReference().empty(); }
  double seconds(const Way& way) const { return runs_ ? way.run->seconds : way.seconds; }
  double error(const Way& way) const { return runs_ ? way.run->error : way.error; }

  const AdvisedRuns* runs_;
  double allowed_;
  const Way& explicit_;
  std::string where_;
  int seen_ = 0;                  // that came to their end
  std::vector<const Way*> good_;  // as fast as the fastest, and the explicit one
  const Way* best_ = nullptr;
};

}  // namespace

AdviseResult adviseScene(const AdviseOptions& options) {
  const SceneStart start = startOf(options.scene, options.overrides, options.threads, SceneUse::advise);
  const Scene& scene = start.scene;
  const std::string file = scene.file.string();
  if (!options.step && !scene.step)
    throw InputError(
        fmt::format("{}: integrator.step = \"auto\" keeps below the critical step by itself; give the step "
                    "that you want with --step",
                    file));
  const double h = options.step ? *options.step : *scene.step;
  const double time = options.time.value_or(std::min(wholeUntil(scene), adviseSteps * h));
  if (time < h)
    throw InputError(fmt::format("{}: {} s is less than one step of {} s",
                                 options.time ? std::string("--time") : file + ": integrator.end", time, h));

  const Body& body = start.body;
  const CriticalStep bracket = criticalStep(body, start.state.x, start.rule);
  AdviseResult result;
  Json& json = result.json;
  json = Json{{"scene", file},        {"integrator", scene.method},       {"step", h},
              {"safe", bracket.safe}, {"optimistic", bracket.optimistic}, {"needed", h > bracket.safe},
              {"notes", start.notes}};
  result.text = fmt::format(
      "{}: {}, {}, {}\n  critical step between {:.6g} and {:.6g} s; {:.6g} s is {:.3g} times the "
      "safe one\n",
      file, elementCounts(body.mesh()), modelsText(scene.materials), scene.method, bracket.safe, bracket.optimistic, h,
      h / bracket.safe);
  for (const std::string& note : start.notes) result.text += fmt::format("  note: {}\n", note);
  if (h <= bracket.safe) {
    json["conclusion"] =
        fmt::format("a step of {:.6g} s is proven stable as the scene starts: {} alone will do", h, scene.method);
    return result;
  }

  const ElementsInTheWay way = elementsInTheWay(body, start.state.x, *start.integrator, scene.damping, h);
  const std::size_t count = way.all.size(), bad = way.badlyShaped.size();
  json["in_the_way"] = Json{{"elements", count}, {"badly_shaped", bad}, {"shapes", Json::object()}};
  for (const auto& [shape, number] : way.badShapes) json["in_the_way"]["shapes"][shape] = number;
  result.text += fmt::format(
      "  {} of {} elements are in the way; {}{}\n", count, body.mesh().elementCount(),
      bad == 0 ? std::string("none of them is badly shaped")
               : fmt::format("{} of them {} badly shaped ({}): {} in the mesh", bad, bad == 1 ? "is" : "are",
                             way.shapesText(), numbersText(way.badlyShaped, body.mesh())),
      count > fewInTheWay * static_cast<double>(body.mesh().elementCount()) ? "; handlers are for few" : "");

  std::vector<Way> ways = Trials(options, start, h, time, bracket.safe).all();
  json["time"] = time;
  json["allowed_error"] = options.error;
  const auto trialSteps = static_cast<std::int64_t>(std::ceil(time / h - 1e-9));
  const double own = scene.safety * bracket.safe;
  const std::int64_t runSteps = stepsToRun(options, start, h, own);
  result.text += tellTrials(ways, time, trialSteps, body.totalMass(), runSteps == 0, json);
  std::optional<AdvisedRuns> runs;
  if (runSteps > 0) {
    ProgressLine progress(options.progress);
    progress.announce("running the scene in small steps");
    runs.emplace(start, h, own, runSteps, options.progress);
    runThose(ways, *runs, time, options.error, progress);
    result.text += tellRuns(ways, *runs, json);
  }
  json["conclusion"] =
      Advice(ways, options.error, runs ? &*runs : nullptr, runs ? runs->steps() : trialSteps).tell(json);
  if (bad > 0) {
    const double without = safeWithout(start.body, start.state.x, start.rule, way.badlyShaped);
    json["remeshed"] = without;
    const double times = without / bracket.safe;
    result.text += fmt::format("remeshing: without the {} badly shaped element{} {:.6g} s would be proven, {}\n", bad,
                               bad == 1 ? "" : "s", without,
                               times < worthRemeshing ? "hardly more than now: others are in the way too"
                                                      : fmt::format("{:.3g} times the safe step now", times));
  }
  return result;
}

}  // namespace ringwatch

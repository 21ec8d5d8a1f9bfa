#include <ringwatch/app/analysis/compare.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <ringwatch/app/output/progress.h>
#include <ringwatch/app/output/report.h>
#include <ringwatch/app/scene/capabilities.h>
#include <ringwatch/app/scene/integrator_catalog.h>
#include <ringwatch/app/scene/scene.h>
#include <ringwatch/app/scene/scene_state.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/nearest_name.h>
#include <ringwatch/base/user_text.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/monitor/bounds/global_frequency.h>

namespace ringwatch {
namespace {

using Json = nlohmann::ordered_json;

std::vector<IntegratorEntry> chosenIntegrators(const std::vector<std::string>& names) {
  const auto entries = integratorCatalog().entries();
  std::vector<IntegratorEntry> chosen;
  for (const std::string& name : names) {
    if (name == "all") return {entries.begin(), entries.end()};
    std::vector<std::string> known{"all"};
    const IntegratorEntry* found = nullptr;
    for (const IntegratorEntry& entry : entries) {
      known.emplace_back(entry.info->name);
      if (entry.info->name == name) found = &entry;
    }
    if (!found)
      throw InputError(fmt::format("--integrators: unknown {}; {}known are {}", inQuotes(name), didYouMean(name, known),
                                   fmt::join(known, ", ")));
    chosen.push_back(*found);
  }
  return chosen;
}

std::vector<std::string> chosenHandlers(const std::vector<std::string>& names) {
  std::vector<std::string> all, chosen;
  for (const HandlerEntry& entry : allHandlers()) all.emplace_back(entry.info->name);
  for (const std::string& name : names) {
    if (name == "all") return all;
    const HandlerInfo* info = findHandler(name);
    if (!info)
      throw InputError(fmt::format("--handlers: unknown {}; {}known are all, {}", inQuotes(name), didYouMean(name, all),
                                   fmt::join(all, ", ")));
    chosen.emplace_back(info->name);
  }
  return chosen;
}

/// A handler on verlet, with a body of its own: mass scaling changes it.
WorkPrecisionRun runHandler(const WorkPrecisionCase& c, const Scene& scene, const Mesh& mesh, int threads,
                            const std::string& name, double h) {
  const HandlerOptions options = optionsFor(*findHandler(name), scene.handlerOptions);
  WorkPrecisionRun run = runPrepared(c, name, h, [&](double step) {
    auto body = std::make_shared<Body>(sceneBody(scene, mesh, threads));
    auto handler = makeHandler(name, *body, makeIntegrator("verlet"), options);
    handler->prepare(body->mesh().X, step);
    return PreparedRun{std::move(handler), std::make_unique<BodySystem>(*body, scene.damping), body};
  });
  run.forces = c.end / run.h;
  return run;
}

std::string cheapestText(const std::vector<WorkPrecisionRun>& runs) {
  std::string text;
  for (const CheapestRuns& best : cheapestRuns(runs))
    text += best.byTime
                ? fmt::format(
                      "  cheapest for {:<6} {}, {:.3g} seconds (h = {:.4g} s); by forces and tangent products {}, "
                      "{:.0f}\n",
                      best.label, best.byTime->integrator, best.byTime->seconds, best.byTime->h,
                      best.byForces->integrator, best.byForces->forces + best.byForces->products)
                : fmt::format("  cheapest for {:<6} none reaches it; smaller steps may\n", best.label);
  return text;
}

std::string cheapestConclusion(const std::vector<WorkPrecisionRun>& runs) {
  std::vector<std::string> names;
  for (const CheapestRuns& best : cheapestRuns(runs))
    names.push_back(fmt::format("{} for {}", best.byTime ? best.byTime->integrator : "none", best.label));
  return fmt::format("cheapest: {}", fmt::join(names, ", "));
}

std::vector<std::string> cheapestSentences(const std::vector<WorkPrecisionRun>& runs) {
  std::vector<std::string> sentences;
  for (const CheapestRuns& best : cheapestRuns(runs))
    sentences.push_back(best.byTime
                            ? fmt::format("For an error of {} {} is cheapest: {:.3g} seconds at h = {:.4g} s.",
                                          best.label, best.byTime->integrator, best.byTime->seconds, best.byTime->h)
                            : fmt::format("None reaches an error of {}; smaller steps may.", best.label));
  return sentences;
}

}  // namespace

Json workPrecisionJson(const WorkPrecisionCase& c, const std::vector<WorkPrecisionRun>& runs) {
  Json rows = Json::array(), cheapest = Json::object();
  for (const WorkPrecisionRun& run : runs)
    rows.push_back({{"integrator", run.integrator},
                    {"h", run.h},
                    {"error", numberOrNull(run.error)},
                    {"seconds", run.seconds},
                    {"forces", run.forces},
                    {"products", run.products},
                    {"matrices", run.matrices},
                    {"lost", run.reason}});
  for (const CheapestRuns& best : cheapestRuns(runs)) {
    Json& entry = cheapest[best.label];
    if (!best.byTime) continue;
    entry = {{"by_time", best.byTime->integrator},
             {"seconds", best.byTime->seconds},
             {"h", best.byTime->h},
             {"by_forces", best.byForces->integrator},
             {"forces", best.byForces->forces + best.byForces->products}};
  }
  return {{"title", c.title},
          {"end", c.end},
          {"reference_error", c.referenceError},
          {"runs", std::move(rows)},
          {"cheapest", std::move(cheapest)}};
}

CompareResult compareScene(const CompareOptions& options) {
  const std::vector<IntegratorEntry> integrators = chosenIntegrators(options.integrators);
  for (const double h : options.steps)
    if (!(h > 0) || !std::isfinite(h)) throw InputError(fmt::format("--step: {} s must be > 0 and finite", h));
  const std::vector<std::string> handlers = chosenHandlers(options.handlers);
  const Scene scene = readScene(options.scene, options.overrides);
  requireTaken(scene, SceneUse::compare);
  for (const std::string& name : handlers)
    if (const auto [key, why] = dampingRefusedBy(*findHandler(name), scene.damping); !why.empty())
      throw InputError(fmt::format("{}: damping.{}: {}", scene.file.string(), key, why));
  for (const double h : options.steps)
    if (h > scene.end) throw InputError(fmt::format("--step: {} s is beyond the end of the scene, {} s", h, scene.end));
  for (const double h : options.steps)
    if (const std::string fault = tooMany("steps", h, scene.end); !fault.empty()) throw InputError("--step: " + fault);
  std::vector<std::string> notes;
  const Body body = sceneBody(scene, sceneMesh(scene, notes), options.threads);
  const GlobalFrequency top = globalFrequency(body, body.mesh().X);
  if (!top.converged) throw NumericalError("compare: the highest frequency of the body did not converge");
  if (const std::string fault = tooMany("steps", 2 / std::sqrt(top.lambda), scene.end); !fault.empty())
    throw InputError(fmt::format("{}: integrator.end: the critical step of {}", scene.file.string(), fault));
  BodySystem system(body, scene.damping);
  const State start = sceneInitialState(scene, system);
  ProgressLine progress(options.progress);
  const ConvergedMotion reference = convergedMotion(system, start, scene.end, top.lambda);
  if (!reference.moves)
    throw InputError(fmt::format("{}: nothing moves; give a force, a velocity at the start or a prescribed motion",
                                 scene.file.string()));
  const WorkPrecisionCase c{
      options.scene.stem().string(),
      fmt::format("{}: {}, {}", options.scene.stem().string(), elementCounts(body.mesh()), modelsText(scene.materials)),
      system,
      start,
      scene.end,
      top.lambda,
      reference.x,
      reference.change,
      [&](const IntegratorInfo& info, double h) { return partitionForStep(body, scene.damping, info, h); }};
  WorkPrecisionOptions wanted;
  wanted.steps = options.steps;
  wanted.progress = [&](const std::string& what, double share) {
    if (progress.due()) progress.show(what, share);
  };
  std::vector<WorkPrecisionRun> runs = runWorkPrecision(c, integrators, wanted);
  // Unless steps are given: from where plain explicit ends upwards, since that is what handlers are for.
  std::vector<double> handlerSteps = options.steps;
  if (handlerSteps.empty())
    for (const double times : {1.8, 3.6, 7.2, 14.4})
      handlerSteps.push_back(std::min(scene.end, times / std::sqrt(top.lambda)));
  for (const std::string& name : handlers)
    for (const double h : handlerSteps) runs.push_back(runHandler(c, scene, body.mesh(), options.threads, name, h));
  progress.clear();

  CompareResult result;
  result.report.study = "compare";
  addWorkPrecision(c, runs, result.report);
  result.json = {{"program", "ringwatch"},
                 {"version", std::string(programVersion())},
                 {"scene_file", scene.file.string()},
                 {"scene", scene.echo},
                 {"mesh", meshJson(body.mesh(), body.volume())}};
  result.json.update(workPrecisionJson(c, runs));
  for (const std::string& note : notes) result.text += fmt::format("note: {}\n", note);
  result.text += fmt::format("{}, to t = {:.6g} s; reference converged to {:.2g} of the displacement\n", c.title, c.end,
                             c.referenceError);
  for (const WorkPrecisionRun& run : runs)
    if (!run.reason.empty())
      result.text += fmt::format("  lost: {} at h = {:.4g} s: {}\n", run.integrator, run.h, run.reason);
  result.text += cheapestText(runs);
  result.found = cheapestSentences(runs);
  result.json["conclusion"] = cheapestConclusion(runs);
  return result;
}

}  // namespace ringwatch

#include <ringwatch/app/analysis/scale_mass.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include <ringwatch/app/analysis/scene_start.h>
#include <ringwatch/app/output/report.h>
#include <ringwatch/app/scene/capabilities.h>
#include <ringwatch/base/error.h>
#include <ringwatch/handlers/handler.h>
#include <ringwatch/handlers/mass_scaling/lowest_frequencies.h>
#include <ringwatch/handlers/mass_scaling/mass_plan.h>
#include <ringwatch/handlers/selection/selection.h>
#include <ringwatch/monitor/critical_step.h>

namespace ringwatch {
namespace {

using Json = nlohmann::ordered_json;
constexpr int frequencies = 3;
constexpr std::string_view handlerName = "mass-scaling";

/// Hz; empty where they are not known.
std::vector<double> lowestFrequencies(const Body& body, const NodeVectors& x, const Eigen::VectorXd& mass) {
  std::vector<double> hertz;
  for (const double lambda : lowestEigenvalues(body, x, mass, frequencies))
    hertz.push_back(std::sqrt(lambda) / (2 * std::numbers::pi));
  return hertz;
}

/// Added mass of each material's elements, as they share their nodes' own mass.
std::vector<double> byMaterial(const Body& body, const std::vector<int>& materials, const Eigen::VectorXd& added) {
  std::vector<double> result(materials.empty() ? 1
                                               : static_cast<std::size_t>(*std::ranges::max_element(materials)) + 1);
  Eigen::VectorXd own = Eigen::VectorXd::Zero(body.nodeCount());
  const auto eachNode = [&](const auto& visit) {
    std::vector<double> mass;
    for (std::size_t b = 0; b < body.blocks().size(); ++b)
      for (std::int32_t e = 0; e < body.blocks()[b]->elementCount(); ++e) {
        const auto nodes = body.blocks()[b]->nodesOf(e);
        mass.resize(nodes.size());
        body.elementLumpedMass({b, e}, mass.data());
        for (std::size_t a = 0; a < nodes.size(); ++a) visit(b, nodes[a], mass[a]);
      }
  };
  eachNode([&](std::size_t, std::int32_t node, double mass) { own[node] += mass; });
  eachNode([&](std::size_t b, std::int32_t node, double mass) {
    result[materials.empty() ? 0 : static_cast<std::size_t>(materials[b])] += added[node] * mass / own[node];
  });
  return result;
}

/// Nodes with added mass, the most of it first.
std::vector<std::int32_t> heaviestFirst(const Eigen::VectorXd& added) {
  std::vector<std::int32_t> nodes;
  for (std::int32_t i = 0; i < added.size(); ++i)
    if (added[i] > 0) nodes.push_back(i);
  std::ranges::stable_sort(nodes, std::greater<>(), [&](std::int32_t i) { return added[i]; });
  return nodes;
}

struct Told {
  Json json;
  std::string text;
  std::string list;  // of the nodes that get most
};

/// The plan proves `wanted`; the bracket is computed apart from it.
Told tell(const SceneStart& start, double wanted, const std::string& what, const MassPlan& plan,
          const std::vector<double>& before) {
  const Body& body = start.body;
  const double mass = body.totalMass();
  Told told;
  const Body heavier = withAddedMass(body, plan.added);
  const std::vector<std::int32_t> nodes = heaviestFirst(plan.added);
  Json masses = Json::array();
  for (const std::int32_t i : nodes)
    masses.push_back({{"node", i}, {"id", body.mesh().nodeId(i)}, {"mass", plan.added[i]}});
  const CriticalStep step = criticalStep(heavier, start.state.x, start.rule);
  const std::vector<double> after = lowestFrequencies(body, start.state.x, heavier.lumpedMass());
  told.json = Json{{"added_mass", plan.total()},
                   {"added_share", plan.total() / mass},
                   {"nodes", nodes.size()},
                   {"masses", std::move(masses)},
                   {"safe", std::max(wanted, step.safe)},
                   {"optimistic", step.optimistic},
                   {"frequencies", after},
                   {"parts", byMaterial(body, materialOfBlocks(body.mesh()), plan.added)}};
  told.text = fmt::format("  {:<22} {:>11.5g} kg  {:>9.4g} %  {:>7} nodes", what, plan.total(),
                          100 * plan.total() / mass, nodes.size());
  for (std::size_t k = 0; k < std::min(before.size(), after.size()); ++k)
    told.text += fmt::format("  {:>9.5g} Hz ({:+.3g} %)", after[k], 100 * (after[k] / before[k] - 1));
  told.text += "\n";
  constexpr std::size_t shown = 8;
  for (std::size_t k = 0; k < std::min(shown, nodes.size()); ++k)
    told.list += fmt::format("{}{} {:.4g}", k == 0 ? "" : ", ", body.mesh().nodeId(nodes[k]), plan.added[nodes[k]]);
  if (nodes.size() > shown) told.list += fmt::format(" and {} more (--json lists all)", nodes.size() - shown);
  return told;
}

/// What the handler adds as a run begins; empty where the scene cannot take it.
std::optional<MassPlan> planOfHandler(const SceneStart& start, const HandlerInfo& info, double h) {
  if (!whyNoHandlers(start.scene).empty() || !whyNoHandlers(start.body, *start.integrator).empty() ||
      !dampingRefusedBy(info, start.scene.damping).second.empty())
    return std::nullopt;
  return addedMassByHandler(start.body, start.state.x, makeIntegrator(start.scene.method),
                            optionsFor(info, start.scene.handlerOptions), h);
}

}  // namespace

ScaleMassResult planMass(const ScaleMassOptions& options) {
  const SceneStart start = startOf(options.scene, options.overrides, options.threads, SceneUse::scaleMass);
  if (!start.rule.proven())
    throw InputError(
        fmt::format("{}: with damping the limit of {} is searched for, not proven, so no mass is proven either",
                    options.scene.string(), start.integrator->name));
  const double lambda = start.rule.lambdaFor(options.step);
  const CriticalStep bracket = criticalStep(start.body, start.state.x, start.rule);
  const std::vector<double> before = lowestFrequencies(start.body, start.state.x, start.body.lumpedMass());
  ScaleMassResult result;
  Json& json = result.json;
  json = Json{{"scene", options.scene.string()},
              {"step", options.step},
              {"mass", start.body.totalMass()},
              {"safe", bracket.safe},
              {"optimistic", bracket.optimistic},
              {"frequencies", before},
              {"notes", start.notes}};
  result.text = fmt::format("{}: {}, {:.6g} kg, {}\n  critical step between {:.6g} and {:.6g} s without added mass\n",
                            options.scene.string(), elementCounts(start.body.mesh()), start.body.totalMass(),
                            start.integrator->name, bracket.safe, bracket.optimistic);
  for (const std::string& note : start.notes) result.text += fmt::format("  note: {}\n", note);
  if (options.step <= bracket.safe) {
    json["needed"] = false;
    json["conclusion"] = fmt::format("a step of {:.6g} s is proven stable without added mass", options.step);
    return result;
  }
  json["needed"] = true;
  result.text +=
      fmt::format("added mass with which {:.6g} s is proven stable, and the lowest frequencies then", options.step);
  if (!before.empty()) {
    result.text += " (without:";
    for (const double f : before) result.text += fmt::format(" {:.5g}", f);
    result.text += " Hz)";
  }
  result.text += ":\n";
  const Told least = tell(start, options.step, "little, at nodes", planAddedMass(start.body, start.state.x, lambda),
                          before),
             usual = tell(start, options.step, "by element frequency",
                          addedMassByElement(start.body, start.state.x, lambda), before);
  json["plans"] = Json{{"by_node", least.json}, {"by_element", usual.json}};
  result.text += least.text + usual.text;
  const HandlerInfo& info = *findHandler(handlerName);
  if (const std::optional<MassPlan> plan = planOfHandler(start, info, options.step)) {
    const double room = start.scene.handlerOptions.margin.value_or(marginFor(info, start.body));
    const Told handled = tell(start, options.step, fmt::format("handler, {:.3g} % room", 100 * room), *plan, before);
    json["plans"]["by_handler"] = handled.json;
    result.text += handled.text;
    result.text += fmt::format(
        "  the first two are for the state at the start; the handler {} leaves room for elements that stiffen on the "
        "way\n",
        handlerName);
  }
  result.text += fmt::format("  little, at nodes, by their numbers (kg): {}\n", least.list);
  if (start.scene.materials.size() > 1) {
    result.text += "  by material (kg):";
    for (std::size_t m = 0; m < start.scene.materials.size(); ++m)
      result.text += fmt::format("  {} {:.4g} ({:.4g})", start.scene.materials[m].selection(),
                                 least.json["parts"][m].get<double>(), usual.json["parts"][m].get<double>());
    result.text += "\n";
  }
  const Json& plan = least.json;
  std::string lowest;
  if (!before.empty() && !plan["frequencies"].empty())
    lowest = fmt::format("; the lowest frequency changes by {:+.2g} %",
                         100 * (plan["frequencies"][0].get<double>() / before[0] - 1));
  json["conclusion"] =
      fmt::format("{:.3g} kg at {} nodes, {:.2g} % of the mass, prove a step of {:.6g} s at the start{}",
                  plan["added_mass"].get<double>(), plan["nodes"].get<std::size_t>(),
                  100 * plan["added_share"].get<double>(), options.step, lowest);
  return result;
}

}  // namespace ringwatch

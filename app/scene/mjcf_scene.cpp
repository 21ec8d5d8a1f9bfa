#include <ringwatch/app/scene/mjcf_scene.h>

#include <algorithm>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <ringwatch/app/scene/mjcf_model.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/user_text.h>

namespace ringwatch {
namespace {

using Json = nlohmann::ordered_json;

/// A model says nothing of how long it runs.
constexpr double usualEnd = 1;  // s
/// Of the density that gives some vertex all of its mass: room for the rounding of volumes.
constexpr double shareOfMass = 1 - 1e-9;

/// The density, kg/m³, with which elements give every vertex at most its mass; point masses are the rest. MuJoCo shares
/// the mass among vertices, whatever volume they have around them.
double densityOf(const Flex& flex) {
  std::vector<double> volume(flex.points.size(), 0);
  for (const auto& t : flex.tetrahedra) {
    const Eigen::Vector3d &a = flex.points[t[0]], &b = flex.points[t[1]], &c = flex.points[t[2]],
                          &d = flex.points[t[3]];
    const double own = (b - a).cross(c - a).dot(d - a) / 6;
    for (const std::int32_t vertex : t) volume[vertex] += own / 4;
  }
  double density = flex.masses.front() / volume.front();
  for (std::size_t i = 0; i < volume.size(); ++i) density = std::min(density, flex.masses[i] / volume[i]);
  return shareOfMass * density;
}

/// MuJoCo's force on a flex is that of the energy density μ E:E + λ tr(E)²: St. Venant and Kirchhoff's with the first
/// of Lamé's constants twice. This is the material whose constants are μ and 2 λ.
struct Elastic {
  double young, poisson;
};
Elastic elasticOf(const Flex& flex) {
  const double poisson = 2 * flex.poisson / (1 + 2 * flex.poisson);
  return {flex.young * (1 + poisson) / (1 + flex.poisson), poisson};
}

void addFlex(const FlexModel& model, const Flex& flex, DeckScene& scene) {
  const auto add = [&](const char* section, Json values) {
    Json& list = scene.sections[section];
    scene.origins[fmt::format("{}.{}", section, list.size())] = flex.origin;
    list.push_back(std::move(values));
  };
  const Elastic elastic = elasticOf(flex);
  Json material{{"model", "stvk"},
                {"young", elastic.young},
                {"poisson", elastic.poisson},
                {"density", densityOf(flex)},
                {"stiffness_damping", flex.damping}};
  if (model.flexes.size() > 1) material["set"] = flex.name;
  add("material", std::move(material));
  if (flex.poisson > 0)
    scene.notes.push_back(
        fmt::format("{} {}: MuJoCo counts Lamé's first constant twice, as if young = {:.6g} and poisson = {:.6g}; so "
                    "does the bracket",
                    flex.origin, inQuotes(flex.name), elastic.young, elastic.poisson));
  const std::vector<double> masses = flex.differentMasses();
  for (std::size_t group = 0; group < masses.size(); ++group)
    add("mass", Json{{"set", flex.massSet(group)}, {"nodal_mass", masses[group]}});
  if (!flex.pinned.empty()) add("fix", Json{{"set", flex.pinnedSet()}});
  if (flex.edgeDamping > 0 && !model.implicitDamping())
    add("spring", Json{{"set", flex.name}, {"edges", true}, {"stiffness", 0.0}, {"damping", flex.edgeDamping}});
}

void addIntegrator(const FlexModel& model, DeckScene& scene) {
  const bool rungeKutta = model.integrator == "RK4";
  scene.sections["integrator"] = Json{{"method", rungeKutta ? "rk4" : "symplectic-euler"},
                                      {"step", model.timestep},
                                      {"end", std::max(usualEnd, model.timestep)}};
  scene.origins["integrator"] = model.optionOrigin;
  bool dropped = model.leavesOutWhatEnlargesTheStep;
  for (const Flex& flex : model.flexes) {
    if (rungeKutta && (flex.damping > 0 || flex.edgeDamping > 0))
      throw InputError(
          fmt::format("{}: integrator=\"RK4\": the limit of a damped flex ({}) is proven for Euler and the implicit "
                      "integrators only; choose one of them, or take its damping out",
                      model.optionOrigin, flex.origin));
    if (!model.implicitDamping() || flex.edgeDamping == 0) continue;
    dropped = true;
    scene.notes.push_back(fmt::format(
        "{} {}: <edge> damping is implicit with integrator=\"{}\": left out, it can only let larger steps be stable",
        flex.origin, inQuotes(flex.name), model.integrator));
  }
  if (dropped) scene.mayBeStable = "what is left out of the flex may let a larger step be stable";
}

}  // namespace

DeckScene readMjcfScene(const std::filesystem::path& file) {
  const FlexModel model = readFlexModel(file);
  DeckScene scene;
  scene.notes = model.notes;
  scene.sections["mesh"] = Json{{"file", file.filename().string()}};
  scene.origins["mesh"] = file.string();
  addIntegrator(model, scene);
  for (const Flex& flex : model.flexes) addFlex(model, flex, scene);
  if (!model.gravity.isZero(0))
    scene.sections["force"].push_back(
        Json{{"where", "all"}, {"acceleration", Json::array({model.gravity[0], model.gravity[1], model.gravity[2]})}});
  return scene;
}

}  // namespace ringwatch

#include <algorithm>

#include <ringwatch/app/scene/key_binding.h>
#include <ringwatch/app/scene/scene_mesh.h>
#include <ringwatch/base/user_text.h>
#include <ringwatch/materials/registry.h>

namespace ringwatch {
namespace {

using F = Feature;

/// Takes a mesh file, or a generator with parameters that it takes.
void checkMeshKeys(const SceneTable& table, Scene& scene) {
  const bool generated = table.given("generate");
  scene.meshOrigin = table.where(generated ? "generate" : "file");
  if (!generated && scene.meshFile.is_relative()) scene.meshFile = scene.file.parent_path() / scene.meshFile;
  scene.generatorArguments = generated ? generatorDefaults(scene.generator) : nlohmann::ordered_json::object();
  for (const auto& [key, entry] : table.entries) {
    if (key == "file" || key == "generate" || key == "repair") continue;
    const std::string fault = generated ? generatorFault(scene.generator, key, entry.value)
                                        : "is a parameter of generators; a mesh file takes none";
    if (!fault.empty()) fail(entry.origin, "mesh." + key, fault);
    scene.generatorArguments[key] = entry.value;
  }
  if (generated && scene.repair) fail(table.at("repair").origin, "mesh.repair", "goes with a file");
  if (generated) scene.echo["mesh"].update(scene.generatorArguments);
}

/// The keys of a [material] that its law declares.
Options lawParameters(const LawInfo& law, const SceneTable& material) {
  Options parameters;
  for (const LawInfo& other : allLaws())
    for (const OptionInfo& option : other.parameters) {
      const std::string key(option.name);
      if (material.given(key) && !findOption(law.parameters, key)) {
        std::vector<std::string_view> known;
        for (const OptionInfo& own : law.parameters) known.push_back(own.name);
        fail(material.at(key).origin, "material." + key,
             fmt::format("is no parameter of the law \"{}\"; it takes {}", law.name, fmt::join(known, ", ")));
      }
    }
  for (const OptionInfo& option : law.parameters) {
    const std::string key(option.name);
    if (!material.given(key)) {
      if (option.fallback.empty())
        fail(material.origin, "material." + key, missingText(SceneType::number, option.unit, option.range));
      continue;
    }
    parameters.set(key, material.get<double>(key));
    if (const std::string fault = optionFault(law.parameters, parameters, key); !fault.empty())
      fail(material.at(key).origin, "material." + key,
           fmt::format("{}; {}{}", material.at(key).value.dump(), fault,
                       option.unit.empty() ? "" : fmt::format(" {}", option.unit)));
  }
  return parameters;
}

/// Viscosities that make stiffness-proportional damping.
void addStiffnessDamping(const SceneTable& table, SceneMaterial& material) {
  const auto beta = table.get<double>("stiffness_damping");
  if (beta == 0) return;
  if (!material.parameters.find("young") || !material.parameters.find("poisson"))
    fail(table.at("stiffness_damping").origin, "material.stiffness_damping",
         fmt::format("is a time by which Young's modulus and Poisson's ratio are multiplied, which the law {} does not "
                     "have; give shear_viscosity and volume_viscosity",
                     inQuotes(material.model)));
  const double young = material.parameters.number("young"), poisson = material.parameters.number("poisson");
  material.damping.shearViscosity += beta * young / (2 * (1 + poisson));
  material.damping.volumeViscosity += beta * young / (3 * (1 - 2 * poisson));
}

void checkMaterial(const SceneTable& table, Scene& scene, SceneMaterial& material) {
  if (scene.materials.size() == 1) material.origin = table.origin + ": [material]";
  material.parameters = lawParameters(lawNamed(material.model), table);
  addStiffnessDamping(table, material);
  if (table.given("where") || table.given("set")) {
    const NodeSelection selection = selectionOf(table);
    material.where = selection.where;
    material.set = selection.set;
    material.selectionOrigin = selection.origin;
  }
}

/// Takes what [material] says of the whole body: any of several may say it, all the same. Rules of one that gives none
/// are those of the first that does.
void takeBodyWide(std::span<const SceneTable> tables, Scene& scene) {
  const auto givesRules = [](const SceneTable& table) { return table.given("rules"); };
  const auto usual = std::ranges::find_if(tables, givesRules);
  for (std::size_t i = 0; usual != tables.end() && i < tables.size(); ++i) {
    const SceneTable& own = givesRules(tables[i]) ? tables[i] : *usual;
    scene.materials[i].rules = parseRules(own.get<std::vector<std::string>>("rules"), own.where("rules"));
  }
  const auto take = [&](const char* name, const auto& store) {
    const SceneTable* first = nullptr;
    for (const SceneTable& table : tables) {
      if (!table.given(name)) continue;
      if (first && first->at(name).value != table.at(name).value)
        fail(table.at(name).origin, joinText("material.", name),
             fmt::format("another value than at {}; it is one of the whole body: give it once, or the same",
                         first->at(name).origin));
      if (!first) store(*(first = &table));
    }
  };
  take("lumping", [&](const SceneTable& table) { scene.lumping = table.named("lumping", lumpingNames); });
  take("hourglass_stiffness",
       [&](const SceneTable& table) { scene.hourglassControl.stiffness = table.get<double>("hourglass_stiffness"); });
  for (std::size_t i = 0; i < tables.size(); ++i)
    for (const auto& [name, goes] : {std::pair("hourglass_stiffness", scene.hasUniformStrain()),
                                     {"hourglass_viscosity", scene.materials[i].hasUniformStrain()}})
      if (tables[i].given(name) && !goes)
        fail(tables[i].at(name).origin, joinText("material.", name),
             "goes with a rule of uniform strain; set rules = [\"hex8=uniform-strain\"] too");
}

}  // namespace

SceneSection unitsSection() {
  return plainSection({.name = "units", .help = "what labels call the numbers; none is converted"},
                      {{choice("system", &Scene::units, unitSystems, "consistent units of the scene")}});
}

SceneSection meshSection() {
  return plainSection(
      {.name = "mesh",
       .help = "a file or a generator with its parameters",
       .required = true,
       .alternatives = {{"file", "generate"}}},
      {{{{.key = "file", .type = SceneType::text, .help = "mesh file, relative to the scene; or give generate"},
         [](const SceneTable& table, Scene& scene) { scene.meshFile = table.get<std::string>("file"); }},
        key("repair", &Scene::repair, "mend the file's mesh first, as `ringwatch mesh repair` does"),
        key("generate", &Scene::generator, "kind of generated mesh, instead of file", {.choices = generatorNames()})},
       unbound<Scene>(generatorSceneKeys())},
      checkMeshKeys);
}

SceneSection materialSection() {
  using M = SceneMaterial;
  const auto damping = [](const char* name, double DampingConstants::*member, const char* unit, const char* help) {
    return key(name, at(&M::damping, member), help,
               {.unit = unit, .range = KeyRange::notNegative, .features = {F::elementDamping}});
  };
  return listSection<M>(
      {.name = "material",
       .help = "one material for the whole body, or several [[material]], each for the elements that it selects",
       .required = true,
       .alsoList = true,
       .alternatives = {{"where", "set", SceneAlternative::Need::oneOfMany}}},
      &Scene::materials,
      {{key("model", &M::model, "constitutive law; help laws lists its parameters",
            {.required = true, .choices = namesOf(allLaws()), .features = {F::otherLaws}})},
       unbound<M>(keysOfOptions(allLaws(), &LawInfo::parameters)),
       unbound<M>(
           {{.key = "where",
             .type = SceneType::text,
             .help = "elements that have it, by a condition on the centre of their nodes at rest, e.g. \"x < "
                     "0.1\"; each element has one material"},
            {.key = "set",
             .type = SceneType::text,
             .help = "named element set of the mesh, or \"#\" and numbers of elements, \"#3,7\", instead of where"}}),
       {key("density", &M::density, "density at rest",
            {.unit = "kg/m3", .required = true, .range = KeyRange::positive}),
        damping("mass_damping", &DampingConstants::massProportional, "1/s",
                "force per mass and velocity, as ALPHA of *DAMPING in Abaqus"),
        {{.key = "stiffness_damping",
          .unit = "s",
          .fallback = "0.0",
          .range = KeyRange::notNegative,
          .features = {F::elementDamping},
          .help = "viscous stress, this time times the stiffness at rest times the rate of Green's strain, as BETA of "
                  "*DAMPING in Abaqus; laws with young and poisson"}},
        damping("shear_viscosity", &DampingConstants::shearViscosity, "Pa s",
                "Kelvin-Voigt: stress 2 x this x the rate of Green's strain without its volumetric part"),
        damping("volume_viscosity", &DampingConstants::volumeViscosity, "Pa s",
                "Kelvin-Voigt: stress this x the trace of the rate of Green's strain"),
        damping("hourglass_viscosity", &DampingConstants::hourglassViscosity, "",
                "of hex8=uniform-strain: viscous hourglass control, usually 0.05 to 0.15")},
       unbound<M>({{.key = "hourglass_stiffness",
                    .fallback = "0.05",
                    .range = KeyRange::notNegative,
                    .help = "of hex8=uniform-strain, of the whole body: stiffness of hourglass modes over that of "
                            "pressure waves"},
                   {.key = "lumping",
                    .type = SceneType::text,
                    .fallback = "\"row-sum\"",
                    .choices = lumpingNames.names(),
                    .help = "how an element's mass goes to its nodes, of the whole body; " + lumpingNames.listing()},
                   {.key = "rules",
                    .type = SceneType::texts,
                    .features = {F::uniformStrain},
                    .help = "quadrature rules of elements, e.g. [\"hex8=gauss-2x2x2\"]; of several materials one "
                            "without has those "
                            "of the first that gives some; `ringwatch verify elements` compares them"}})},
      checkMaterial, takeBodyWide);
}

}  // namespace ringwatch

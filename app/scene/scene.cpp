#include <ringwatch/app/scene/scene.h>

#include <algorithm>
#include <span>

#include <fmt/format.h>

#include <ringwatch/app/scene/capabilities.h>
#include <ringwatch/app/scene/mjcf_model.h>
#include <ringwatch/app/scene/mjcf_scene.h>
#include <ringwatch/app/scene/saved_json.h>
#include <ringwatch/app/scene/scene_keys.h>
#include <ringwatch/app/scene/scene_sections.h>
#include <ringwatch/app/scene/toml_text.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/input_file.h>
#include <ringwatch/base/nearest_name.h>
#include <ringwatch/base/user_text.h>

namespace ringwatch {
namespace {

using Json = nlohmann::ordered_json;

/// Scene::places: keys that are false, 0 or "none" switch nothing on, but some switch off what is on without them.
std::map<std::string, std::string> placesOf(const std::vector<SceneTable>& sections) {
  const Json off[] = {false, 0, "none"};
  std::map<std::string, std::string> places;
  for (const SceneTable& section : sections) {
    places.emplace(section.name, section.origin);
    for (const auto& [key, entry] : section.entries)
      if (entry.given && (std::ranges::find(off, entry.value) == std::end(off) ||
                          std::ranges::any_of(sceneKeys(), [&, key = std::string_view(key)](const SceneKey& known) {
                            return known.section == section.name && known.key == key && known.fallback == "true";
                          })))
        places.emplace(section.name + "." + key, entry.origin);
  }
  return places;
}

/// Options of a handler that are not given have other defaults on a GPU.
void takeDefaultsOfGpu(Scene& scene) {
  const HandlerInfo* handler = findHandler(scene.handler);
  if (handler && scene.device != RunDevice::cpu && !refusalOf(scene, SceneUse::gpu))
    handler->forGpu(scene.handlerOptions.own);
}

/// The tables of a section, which follow each other.
std::span<const SceneTable> tablesOf(const std::vector<SceneTable>& all, std::string_view name) {
  const auto first = std::ranges::find(all, name, &SceneTable::name);
  const auto last = std::find_if(first, all.end(), [&](const SceneTable& table) { return table.name != name; });
  return std::span(all).subspan(first - all.begin(), last - first);
}

Json echoOf(std::span<const SceneTable> tables, const SceneSection& section) {
  Json all = Json::array();
  for (const SceneTable& table : tables) {
    Json& values = all.emplace_back(Json::object());
    for (const SceneKey& key : section.keys)
      if (table.entries.contains(key.key)) values[key.key] = table.at(key.key).value;
  }
  return section.list || all.size() > 1 ? all : all.front();
}

/// Refuses keys that stand for each other where too many or none of them are given.
void requireAlternatives(const SceneTable& table, const SceneSection& section, bool several) {
  using Need = SceneAlternative::Need;
  for (const SceneAlternative& alternative : section.alternatives) {
    std::vector<std::string> given, known;
    for (const std::string& name : alternative.keys()) {
      if (table.given(name)) given.push_back(name);
      const SceneKey& key = *std::ranges::find(section.keys, name, &SceneKey::key);
      known.push_back(key.unit.empty() ? name : fmt::format("{} ({})", name, key.unit));
    }
    const std::string name = table.name + "." + alternative.first;
    if (given.size() > 1 && alternative.need != Need::any)
      fail(table.at(given.front()).origin, name,
           fmt::format("both {} and {} are given; give one of them", given[0], given[1]));
    const bool needed = alternative.need == Need::oneOfMany ? several : alternative.need != Need::atMostOne;
    if (!given.empty() || !needed) continue;
    const std::string last = known.back();
    known.pop_back();
    fail(table.origin, name,
         fmt::format("missing; give {} or {}{}", fmt::join(known, ", "), last,
                     alternative.first == "where" ? ", e.g. where = \"x < 1e-6\"" : ""));
  }
}

}  // namespace

Eigen::Vector3d vectorOf(const Json& value) {
  return {value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
}

NodeSelection selectionOf(const SceneTable& section, const std::string& prefix) {
  const std::string where = prefix + "where", set = prefix + "set";
  if (section.given(set)) return {std::nullopt, section.get<std::string>(set), section.where(set)};
  return NodeSelection::parse(section.get<std::string>(where), section.where(where));
}

NodeSelection NodeSelection::parse(const std::string& text, const std::string& origin) {
  if (text.rfind("set:", 0) == 0) return {std::nullopt, text.substr(4), origin};
  try {
    return {WhereExpression(text), {}, origin};
  } catch (const InputError& fault) {
    const bool isName = !text.empty() && std::ranges::all_of(text, [](unsigned char c) {
      return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.';
    });
    throw InputError(fmt::format("{}: {}: {}{}", origin, inQuotes(text), fault.what(),
                                 isName ? fmt::format("; a named set is written \"set:{}\"", text) : ""));
  }
}

std::string tooMany(std::string_view what, double interval, double end) {
  const double count = end / interval;
  if (count <= mostSteps) return {};
  return fmt::format("{} s makes {:.3g} {} to the end at {} s; at most {} are possible", interval, count, what, end,
                     mostSteps);
}

namespace {
Scene makeScene(const std::filesystem::path& file, const std::vector<SceneTable>& tables) {
  Scene scene;
  scene.file = file;
  scene.places = placesOf(tables);
  for (const SceneSection& section : sceneSections()) {
    const std::span<const SceneTable> own = tablesOf(tables, section.name);
    if (own.empty()) continue;
    scene.echo[std::string(section.name)] = echoOf(own, section);
    for (const SceneTable& table : own) {
      requireAlternatives(table, section, own.size() > 1);
      section.read(table, scene);
    }
  }
  useUnits(scene.units);
  for (const SceneSection& section : sceneSections())
    if (const std::span<const SceneTable> own = tablesOf(tables, section.name); section.check && !own.empty())
      section.check(own, scene);
  std::ranges::stable_sort(scene.cuts, {}, &Scene::Cut::time);
  requireTogether(scene);
  takeDefaultsOfGpu(scene);
  return scene;
}
}  // namespace

Scene readScene(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  if (isModelFile(file)) return sceneOfModel(file, DeckUse::run, overrides);
  return makeScene(file, readSceneTables(file, overrides));
}

bool isModelFile(const std::filesystem::path& file) { return isDeckFile(file) || isMjcfFile(file); }

Scene sceneOfModel(const std::filesystem::path& file, DeckUse use, const std::vector<std::string>& overrides) {
  if (firstNotUtf8(file.string()) < file.string().size())
    throw InputError(fmt::format("{}: the name of a model is to be UTF-8; rename the file", file.string()));
  DeckScene model = isMjcfFile(file) ? readMjcfScene(file) : readDeckScene(file, use);
  Scene scene = makeScene(file, sceneTablesOfDeck(file, model, overrides));
  scene.ofModel = true;
  scene.notes = std::move(model.notes);
  scene.mayBeStable = std::move(model.mayBeStable);
  scene.ownStep = model.ownStep;
  return scene;
}

Scene sceneOfRun(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "summary.json";
  const Json summary = savedJson(readBytes(file, "; it is there when a run has ended in this folder"));
  const auto echo = summary.is_object() ? summary.find("scene") : summary.end();
  if (!summary.is_object() || echo == summary.end() || !echo->is_object())
    throw InputError(fmt::format("{}: not the summary of a run; it has no \"scene\"", file.string()));
  return sceneOfEcho(file, *echo);
}

Scene sceneOfEcho(const std::filesystem::path& file, const Json& echo) {
  return makeScene(file, sceneTablesOfEcho(file, tomlOfSections(echo)));
}

std::string Scene::where(const std::string& sectionOrKey) const {
  const auto place = places.find(sectionOrKey);
  const SceneSection* section = findSceneSection(sectionOrKey);
  return fmt::format("{}: {}", place == places.end() ? file.string() : place->second,
                     !section        ? sectionOrKey
                     : section->list ? section->head()
                                     : fmt::format("[{}]", sectionOrKey));
}

std::optional<std::array<bool, 3>> parseComponents(std::string_view text) {
  std::array<bool, 3> result{};
  for (char c : text) {
    if (c < 'x' || c > 'z' || result[c - 'x']) return std::nullopt;
    result[c - 'x'] = true;
  }
  if (text.empty()) return std::nullopt;
  return result;
}

Scene::Fix parseFix(const std::string& text, const std::string& origin) {
  const std::size_t begin = text.rfind("set:", 0) == 0 ? 4 : 0, colon = text.rfind(':');
  if (colon == std::string::npos || colon < begin) return {NodeSelection::parse(text, origin), {true, true, true}};
  const std::string components = text.substr(colon + 1);
  const auto held = parseComponents(components);
  if (!held)
    throw InputError(fmt::format("{}: {}: {} names no components; must be some of x, y, z, each once", origin,
                                 inQuotes(text), inQuotes(components)));
  return {NodeSelection::parse(text.substr(0, colon), origin), *held};
}

ElementRules parseRules(const std::vector<std::string>& texts, const std::string& origin) {
  ElementRules rules;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    const std::string name = text.substr(0, equals);
    const ElementInfo* element = nullptr;
    std::vector<std::string> elements;
    for (const ElementInfo& info : allElements()) {
      elements.emplace_back(info.name);
      if (info.name == name) element = &info;
    }
    if (equals == std::string::npos || !element)
      throw InputError(fmt::format("{}: {} must be ELEMENT=RULE; elements are {}", origin, inQuotes(text),
                                   fmt::join(elements, ", ")));
    const std::string rule = text.substr(equals + 1);
    if (!findRule(*element, rule) || rule.empty()) {
      std::vector<std::string> known;
      for (const QuadratureRule& r : element->rules) known.emplace_back(r.name);
      throw InputError(fmt::format("{}: unknown rule {} for {}; {}known are {}", origin, inQuotes(rule), name,
                                   didYouMean(rule, known), fmt::join(known, ", ")));
    }
    rules[name] = rule;
  }
  return rules;
}

void overrideRules(Scene& scene, const std::vector<std::string>& texts, const std::string& origin) {
  for (const auto& [element, rule] : parseRules(texts, origin))
    for (SceneMaterial& material : scene.materials) material.rules[element] = rule;
}

}  // namespace ringwatch

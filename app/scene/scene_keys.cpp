#include <ringwatch/app/scene/scene_keys.h>

#include <algorithm>

#include <fmt/format.h>

#include <ringwatch/app/scene/scene_mesh.h>
#include <ringwatch/app/scene/scene_sections.h>
#include <ringwatch/handlers/handler.h>
#include <ringwatch/materials/registry.h>

namespace ringwatch {
namespace {

SceneType sceneTypeOf(const OptionInfo& option) {
  if (option.type == OptionType::text) return SceneType::text;
  if (option.automatic) return SceneType::numberOrAuto;
  return option.type == OptionType::integer ? SceneType::integer : SceneType::number;
}

/// A declared option as a key of the scene, without help.
SceneKey keyOf(const OptionInfo& option) {
  const bool text = option.type == OptionType::text || option.automatic;
  SceneKey key{.key = std::string(option.name),
               .type = sceneTypeOf(option),
               .unit = std::string(option.unit),
               .fallback = option.fallback.empty() || !text ? std::string(option.fallback)
                                                            : fmt::format("\"{}\"", option.fallback),
               .range = option.range};
  if (option.automatic && option.type == OptionType::text) key.choices.emplace_back("auto");
  return key;
}

/// One key for options of the same name: it takes what any of them takes, and the entry that is chosen checks the
/// others.
void join(SceneKey& key, const OptionInfo& option) {
  for (const std::string_view choice : option.choices)
    if (std::find(key.choices.begin(), key.choices.end(), choice) == key.choices.end())
      key.choices.emplace_back(choice);
  if (option.range.low < key.range.low)
    key.range.low = option.range.low, key.range.lowIncluded = option.range.lowIncluded;
  if (option.range.high > key.range.high)
    key.range.high = option.range.high, key.range.highIncluded = option.range.highIncluded;
}

}  // namespace

std::vector<SceneKey> keysOfOptions(const std::vector<OptionOwner>& owners) {
  std::vector<SceneKey> keys;
  for (const OptionOwner& owner : owners)
    for (const OptionInfo& option : owner.options) {
      if (std::ranges::find(keys, option.name, &SceneKey::key) != keys.end()) continue;
      SceneKey& key = keys.emplace_back(keyOf(option));
      std::vector<std::pair<std::string, std::string>> helps;  // whose, what
      for (const OptionOwner& other : owners)
        if (const OptionInfo* same = findOption(other.options, option.name)) {
          join(key, *same);
          const auto known = std::ranges::find(helps, same->help, &std::pair<std::string, std::string>::second);
          if (known == helps.end())
            helps.emplace_back(other.name, same->help);
          else
            known->first += ", " + other.name;
        }
      for (const auto& [names, help] : helps)
        key.help += fmt::format("{}{}: {}", key.help.empty() ? "" : "; ", names, help);
    }
  return keys;
}

std::string_view sceneTypeName(SceneType type) {
  static constexpr auto names = nameTable<SceneType>({
      {SceneType::number, "number"},
      {SceneType::integer, "integer"},
      {SceneType::boolean, "true or false"},
      {SceneType::text, "text"},
      {SceneType::texts, "list of texts"},
      {SceneType::numbers, "list of numbers"},
      {SceneType::vector, "list of three numbers"},
      {SceneType::vectors, "list of points, each a list of three numbers"},
      {SceneType::numberOrAuto, "number or \"auto\""},
      {SceneType::parameter, "parameter"},
  });
  return names.nameOf(type);
}

std::vector<std::string> SceneAlternative::keys() const {
  return third.empty() ? std::vector{first, second} : std::vector{first, second, third};
}

std::string SceneSection::head() const {
  return list       ? fmt::format("[[{}]]", name)
         : alsoList ? fmt::format("[{0}] or [[{0}]]", name)
                    : fmt::format("[{}]", name);
}

std::span<const SceneSection> sceneSections() {
  static const std::vector<SceneSection> sections{
      unitsSection(),   meshSection(),     materialSection(), integratorSection(),  dampingSection(),
      monitorSection(), handlerSection(),  fixSection(),      initialSection(),     moveSection(),
      forceSection(),   pressureSection(), massSection(),     massDampingSection(), rigidSection(),
      springSection(),  obstacleSection(), contactSection(),  cutSection(),         erosionSection(),
      probeSection(),   outputSection()};
  return sections;
}

const SceneSection* findSceneSection(std::string_view name) {
  const auto found = std::ranges::find(sceneSections(), name, &SceneSection::name);
  return found == sceneSections().end() ? nullptr : &*found;
}

std::span<const SceneKey> sceneKeys() {
  static const std::vector<SceneKey> all = [] {
    std::vector<SceneKey> keys;
    for (const SceneSection& section : sceneSections())
      keys.insert(keys.end(), section.keys.begin(), section.keys.end());
    return keys;
  }();
  return all;
}

std::vector<HandlerInfo> handlerInfos() {
  std::vector<HandlerInfo> infos;
  for (const HandlerEntry& entry : allHandlers()) infos.push_back(*entry.info);
  return infos;
}

bool isKeyOfEveryHandler(std::string_view key) {
  return std::ranges::none_of(
      allHandlers(), [&](const HandlerEntry& handler) { return findOption(handler.info->options, key) != nullptr; });
}

bool isLawParameter(std::string_view key) {
  return std::ranges::any_of(allLaws(), [&](const LawInfo& law) { return findOption(law.parameters, key) != nullptr; });
}

namespace {

std::string helpOf(const SceneSection& section) {
  std::string text = fmt::format("\n{}  {}{}\n", section.head(), section.help, section.required ? " (required)" : "");
  for (const SceneKey& key : section.keys) {
    std::string line = fmt::format("  {:<17} {}", key.key, sceneTypeName(key.type));
    if (!key.unit.empty()) line += ", " + key.unit;
    if (!key.range.text().empty()) line += ", " + key.range.text();
    if (key.required) line += ", required";
    if (!key.fallback.empty()) line += ", default " + key.fallback;
    text += line + "\n" + fmt::format("  {:<17}   {}\n", "", key.help);
    if (!key.choices.empty()) text += fmt::format("  {:<17}   one of: {}\n", "", fmt::join(key.choices, ", "));
    for (const auto& [alias, meant] : key.aliases)
      text += fmt::format("  {:<17}   {} is another name of {}\n", "", alias, meant);
  }
  return text;
}

constexpr std::string_view sceneIntroduction = "A scene is a TOML file.\n";
constexpr std::string_view keysIntroduction = "\nKeys with their type, unit, range and default:\n";

}  // namespace

std::string sceneHelp() {
  std::string text = std::string(sceneIntroduction) + std::string(unitsText) + std::string(keysIntroduction);
  for (const SceneSection& section : sceneSections()) text += helpOf(section);
  return text + "\nMesh generators and their parameters in [mesh]:\n" + generatorHelp();
}

std::string sceneHelp(const SceneSection& section) {
  return std::string(unitsText) + std::string(keysIntroduction) + helpOf(section);
}

std::string sceneHelp(std::string_view name) {
  const SceneSection* section = findSceneSection(name);
  return section ? sceneHelp(*section) : "";
}

std::string sceneOverview() {
  std::string text = std::string(sceneIntroduction) + std::string(unitsText) + "\nIts sections:\n\n";
  for (const SceneSection& section : sceneSections())
    text += fmt::format("  {:<26} {}{}\n", section.head(), section.help, section.required ? " (required)" : "");
  return text +
         "\nringwatch help scene SECTION lists the keys of one, such as ringwatch help scene contact; ringwatch run "
         "--help-scene lists all. ringwatch help together says what does not go together.\n";
}

}  // namespace ringwatch

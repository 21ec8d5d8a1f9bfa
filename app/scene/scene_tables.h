#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <ringwatch/app/scene/deck_scene.h>
#include <ringwatch/app/scene/scene_keys.h>

namespace ringwatch {

/// A checked value and where it came from: "scene.toml:12", "--set integrator.step=1" or "default".
struct SceneEntry {
  nlohmann::ordered_json value;
  std::string origin;
  bool given = false;
};
/// One table of the scene: [name], or one of several [[name]].
struct SceneTable {
  std::string name, origin;
  std::map<std::string, SceneEntry> entries;

  bool given(const std::string& key) const { return entries.count(key) != 0 && entries.at(key).given; }
  const SceneEntry& at(const std::string& key) const { return entries.at(key); }
  template <class T>
  T get(const std::string& key) const {
    return entries.at(key).value.get<T>();
  }
  std::string where(const std::string& key) const {
    return fmt::format("{}: {}.{}", entries.at(key).origin, name, key);
  }
  /// The value that a text names.
  template <class Table>
  auto named(const std::string& key, const Table& table) const {
    return table.valueOf(where(key), get<std::string>(key));
  }
};

/// Throws InputError "ORIGIN: KEY: WHAT".
[[noreturn]] void fail(const std::string& origin, const std::string& key, const std::string& what);
/// What is said of a key that must be given.
std::string missingText(SceneType type, std::string_view unit, const SceneRange& range);

/// All sections of a scene file (TOML) with their values checked against the table of keys and defaults filled in, in
/// the order of that table; lists in the order of the file. overrides: see readScene.
std::vector<SceneTable> readSceneTables(const std::filesystem::path& file, const std::vector<std::string>& overrides);
/// Likewise of a deck. file: for messages that are about no place in it.
std::vector<SceneTable> sceneTablesOfDeck(const std::filesystem::path& file, const DeckScene& deck,
                                          const std::vector<std::string>& overrides);
/// Sections as TOML. JSON's texts, numbers and lists are TOML's.
std::string tomlOfSections(const nlohmann::ordered_json& sections);
/// The sections of an echo, TOML in which all defaults are filled in. file: for messages.
std::vector<SceneTable> sceneTablesOfEcho(const std::filesystem::path& file, const std::string& toml);

}  // namespace ringwatch

#pragma once
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <ringwatch/app/scene/feature.h>
#include <ringwatch/base/options.h>

namespace ringwatch {

struct Scene;
struct SceneTable;

/// What a key of a scene file holds.
enum class SceneType {
  number,  ///< integer or float, finite
  integer,
  boolean,
  text,
  texts,         ///< list of strings
  numbers,       ///< list of numbers
  vector,        ///< three numbers
  vectors,       ///< list of them
  numberOrAuto,  ///< a number or "auto"
  parameter      ///< of a mesh generator: a number, a text or a list of numbers, checked against the generator's table
};
std::string_view sceneTypeName(SceneType type);

/// Numbers a key accepts; every component's, for lists.
using SceneRange = NumberRange;

/// One key of the scene format. Validation, defaults, messages, help, schema and reference follow from it.
struct SceneKey {
  std::string section = {};  // see SceneSection
  std::string key = {};
  SceneType type = SceneType::number;
  std::string unit = {};  // "" for none
  bool required = false;
  std::string fallback = {};  // as TOML text; "" for none
  SceneRange range = {};
  std::vector<std::string> choices = {};                          // what a text may be; empty for anything
  std::vector<std::pair<std::string, std::string>> aliases = {};  // of choices: other names that are accepted
  Features features = {};                                         // that it may switch on
  std::string help = {};
};

/// Keys of a section that stand for each other: two, or three.
struct SceneAlternative {
  enum class Need {
    one,        ///< exactly one must be given
    any,        ///< one or both
    atMostOne,  ///< neither or one
    oneOfMany,  ///< at most one, and exactly one where the section is a list of two and more
  };
  std::string first, second;
  Need need = Need::one;
  std::string third = {};  // "" for none; goes with `one` and `any`

  /// Those that there are.
  std::vector<std::string> keys() const;
};

/// A section of the scene format: the one declaration of its keys, of what they mean to a Scene, and of what they must
/// be together. See key_binding.h.
struct SceneSection {
  std::string_view name;
  std::string_view help;
  bool list = false;  // [[name]], any number of times
  bool required = false;
  bool alsoList = false;   // [[name]] may stand in place of [name]
  Features features = {};  // that it switches on
  std::vector<SceneAlternative> alternatives = {};
  std::vector<SceneKey> keys = {};
  /// Puts the values of a table into the scene, whose other sections may be missing.
  std::function<void(const SceneTable& table, Scene& scene)> read = {};
  /// Takes what keys say together, and refuses what does not fit, once all sections have been read. Throws InputError.
  std::function<void(std::span<const SceneTable> tables, Scene& scene)> check = {};

  /// "[name]" or "[[name]]".
  std::string head() const;
};

/// The options that the entries of a registry declare, as keys; the help of each says whose it is.
struct OptionOwner {
  std::string name;
  std::span<const OptionInfo> options;
};
std::vector<SceneKey> keysOfOptions(const std::vector<OptionOwner>& owners);
template <class Infos, class Member>
std::vector<SceneKey> keysOfOptions(const Infos& infos, Member options) {
  std::vector<OptionOwner> owners;
  for (const auto& info : infos) owners.push_back({std::string(info.name), info.*options});
  return keysOfOptions(owners);
}

/// Every section, in the order of the listing.
std::span<const SceneSection> sceneSections();
/// nullptr where there is none of that name.
const SceneSection* findSceneSection(std::string_view name);
/// Every key, in the order of the listing.
std::span<const SceneKey> sceneKeys();
/// Whether a key of [handler] is one of those that all handlers share; the others are declared by handlers.
bool isKeyOfEveryHandler(std::string_view key);
/// Whether a key of [material] is a parameter of some law.
bool isLawParameter(std::string_view key);
/// What every help text says of units.
inline constexpr std::string_view unitsText =
    "Quantities are in any consistent units. Help texts name those of SI, results those of units.system or --units.\n";

/// The human-readable listing: every section and key with type, unit, default, range and help.
std::string sceneHelp();
/// That of one section.
std::string sceneHelp(const SceneSection& section);
/// That of the section of a name; "" where there is none.
std::string sceneHelp(std::string_view name);
/// The sections, one line each.
std::string sceneOverview();

}  // namespace ringwatch

#pragma once
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ringwatch {

/// What a key of a scene file holds.
enum class SceneType {
  number,  ///< integer or float, finite
  integer,
  boolean,
  text,
  texts,         ///< list of strings
  vector,        ///< three numbers
  vectors,       ///< list of them
  numberOrAuto,  ///< a number or "auto"
  parameter      ///< of a mesh generator: a number, a text or a list of numbers, checked against the generator's table
};
std::string_view sceneTypeName(SceneType type);

/// Numbers a key accepts; every component's, for lists.
struct SceneRange {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool lowIncluded = true, highIncluded = true;

  bool holds(double value) const;
  /// "> 0 and < 0.5"; "" when everything is accepted.
  std::string text() const;
};

/// One key of the scene format. The table of these drives validation, defaults, messages and the listing for people.
struct SceneKey {
  std::string section;  // "fix", "move", "force" and "cut" are lists of tables
  std::string key;
  SceneType type;
  std::string unit;  // "" for none
  bool required = false;
  std::string fallback;  // as TOML text; "" for none
  SceneRange range;
  std::vector<std::string> choices;  // what a text may be; empty for anything
  std::string help;
};

struct SceneSection {
  std::string_view name;
  bool list;  // [[name]], any number of times
  bool required;
  std::string_view help;
};

std::span<const SceneSection> sceneSections();
/// Every key, in the order of the listing. The generator's parameters come from their registry.
std::span<const SceneKey> sceneKeys();
/// The listing for people: every section and key with type, unit, default, range and help.
std::string sceneHelp();

}  // namespace ringwatch

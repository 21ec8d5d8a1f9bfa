#pragma once
#include <array>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <ringwatch/base/options.h>

namespace ringwatch {

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

/// The keys of a [material] by which its elements damp.
inline constexpr std::array materialDampingKeys{"mass_damping", "stiffness_damping", "shear_viscosity",
                                                "volume_viscosity", "hourglass_viscosity"};

/// Numbers a key accepts; every component's, for lists.
using SceneRange = NumberRange;

/// One key of the scene format. The table of these drives validation, defaults, messages and the human-readable
/// listing.
struct SceneKey {
  std::string section = {};  // see SceneSection
  std::string key;
  SceneType type;
  std::string unit = {};  // "" for none
  bool required = false;
  std::string fallback = {};  // as TOML text; "" for none
  SceneRange range = {};
  std::vector<std::string> choices = {};                          // what a text may be; empty for anything
  std::vector<std::pair<std::string, std::string>> aliases = {};  // of choices: other names that are accepted
  std::string help = {};
};

struct SceneSection {
  std::string_view name;
  bool list;  // [[name]], any number of times
  bool required;
  std::string_view help;
  bool alsoList = false;  // [[name]] may stand in place of [name]
};

/// Keys of a section that stand for each other: two, or three.
struct SceneAlternative {
  enum class Need {
    one,        ///< exactly one must be given
    any,        ///< one or both
    atMostOne,  ///< neither or one
    oneOfMany,  ///< at most one, and exactly one where the section is a list of two and more
  };
  std::string_view section, first, second;
  Need need = Need::one;
  std::string_view third = {};  // "" for none; goes with `one` and `any`
};

std::span<const SceneSection> sceneSections();
/// What schemas and the reference say beyond single keys; the reader of each section has its own message.
std::span<const SceneAlternative> sceneAlternatives();
/// Every key, in the order of the listing. The generator's parameters come from their registry.
std::span<const SceneKey> sceneKeys();
/// Whether a key of [handler] is one of those that all handlers share; the others are declared by handlers.
bool isKeyOfEveryHandler(std::string_view key);
/// Whether a key of [material] is a parameter of some law.
bool isLawParameter(std::string_view key);
/// The human-readable listing: every section and key with type, unit, default, range and help.
std::string sceneHelp();
/// That of one section; "" where there is none of that name.
std::string sceneHelp(std::string_view section);
/// The sections, one line each.
std::string sceneOverview();

}  // namespace ringwatch

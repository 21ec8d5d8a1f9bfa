#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include <ringwatch/app/scene/scene_keys.h>

namespace ringwatch {

/// A JSON Schema (draft 07) that `ringwatch schema NAME` prints.
struct SchemaInfo {
  std::string_view name;
  std::string_view help;  // of what, one line
};

/// The scene and every file of jsonOutputs().
std::vector<SchemaInfo> allSchemas();
/// The schema of that name, made from the registries. A scene is valid as TOML that is read as JSON. It holds types,
/// ranges, choices and keys, also those that depend on the law, the handler or the generator; not what takes the mesh,
/// or a comparison of two values. Throws InputError that lists the names when there is none of that name.
nlohmann::ordered_json schemaOf(std::string_view name);
/// That of one table of a section.
nlohmann::ordered_json schemaOf(const SceneSection& section);

}  // namespace ringwatch

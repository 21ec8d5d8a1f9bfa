#pragma once
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <ringwatch/app/scene/scene_keys.h>
#include <ringwatch/meshes/generators/generator_registry.h>

namespace ringwatch {

/// Names of all mesh generators.
std::vector<std::string> generatorNames();
/// The parameters of all mesh generators as keys of [mesh]; one that several generators share comes once.
std::vector<SceneKey> generatorSceneKeys();
/// What is wrong with a parameter's value and what would be right; "" when nothing is.
std::string generatorFault(const std::string& generator, const std::string& parameter,
                           const nlohmann::ordered_json& value);
/// All parameters of a generator with their defaults.
nlohmann::ordered_json generatorDefaults(const std::string& generator);
/// The values of generatorDefaults() as `generateMesh` takes them.
GeneratorArguments generatorArguments(const nlohmann::ordered_json& values);
/// The human-readable listing: every generator with its parameters, units, defaults and ranges.
std::string generatorHelp();

}  // namespace ringwatch

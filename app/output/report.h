#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// labelled() of every text in JSON but the scene's and the provenance's; keys stay.
nlohmann::ordered_json labelledJson(nlohmann::ordered_json json);
/// JSON has no number that is not finite: null instead.
nlohmann::ordered_json numberOrNull(double value);
/// How many elements a mesh has of each type, in the order of its blocks.
using ElementCounts = std::vector<std::pair<std::string, std::int64_t>>;
ElementCounts countElements(const Mesh& mesh);
/// Numbers of nodes, of elements by type, and volume (m³).
nlohmann::ordered_json meshJson(std::int64_t nodes, const ElementCounts& elements, double volume);
nlohmann::ordered_json meshJson(const Mesh& mesh, double volume);
/// An element by block, index, id and nodes: positions counted from 0, and the numbers of the mesh's file.
nlohmann::ordered_json elementJson(const Mesh& mesh, ElementRef element);
/// The element as above, or null where there is none.
nlohmann::ordered_json elementJson(const Mesh& mesh, const std::optional<ElementRef>& element);
/// "1600 tet4, 64 hex8"
std::string elementCounts(const ElementCounts& elements);
std::string elementCounts(const Mesh& mesh);

/// What the text of a command ends with.
std::string conclusionLine(const std::string& conclusion);

/// Version of the program.
std::string_view programVersion();

}  // namespace ringwatch

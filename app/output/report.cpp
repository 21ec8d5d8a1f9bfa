#include <ringwatch/app/output/report.h>

#include <cmath>

#include <fmt/format.h>

#include <ringwatch/app/scene/scene_materials.h>
#include <ringwatch/base/units.h>

namespace ringwatch {

using Json = nlohmann::ordered_json;

Json labelledJson(Json json) {
  if (json.is_string()) return labelled(json.get<std::string>());
  if (json.is_structured())
    for (const auto& [key, value] : json.items())
      if (key != "scene" && key != "provenance") value = labelledJson(std::move(value));
  return json;
}

std::string conclusionLine(const std::string& conclusion) { return fmt::format("conclusion: {}\n", conclusion); }

std::string_view programVersion() { return RINGWATCH_VERSION; }

Json numberOrNull(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

ElementCounts countElements(const Mesh& mesh) {
  ElementCounts counts;
  for (const MeshBlock& block : mesh.blocks) {
    const std::string name(elementInfo(block.type).name);
    const auto known =
        std::find_if(counts.begin(), counts.end(), [&](const auto& other) { return other.first == name; });
    auto& entry = known != counts.end() ? *known : counts.emplace_back(name, 0);
    entry.second += static_cast<std::int64_t>(block.elementCount());
  }
  return counts;
}

Json meshJson(std::int64_t nodes, const ElementCounts& elements, double volume) {
  Json byType = Json::object();
  for (const auto& [name, count] : elements) byType[name] = count;
  return Json{{"nodes", nodes}, {"elements", std::move(byType)}, {"volume", volume}};
}

Json meshJson(const Mesh& mesh, double volume) {
  return meshJson(static_cast<std::int64_t>(mesh.nodeCount()), countElements(mesh), volume);
}

Json elementJson(const Mesh& mesh, ElementRef ref) {
  const MeshBlock& block = mesh.blocks[ref.block];
  const std::int32_t* nodes = block.element(ref.element);
  Json result{{"block", ref.block},
              {"index", ref.element},
              {"type", std::string(elementInfo(block.type).name)},
              {"nodes", std::vector<std::int32_t>(nodes, nodes + block.nodesPerElement())},
              {"id", block.id(ref.element)},
              {"node_ids", Json::array()}};
  for (int a = 0; a < block.nodesPerElement(); ++a) result["node_ids"].push_back(mesh.nodeId(nodes[a]));
  if (const std::vector<int> materials = materialOfBlocks(mesh); !materials.empty())
    result["material"] = materials[ref.block];
  return result;
}

Json elementJson(const Mesh& mesh, const std::optional<ElementRef>& ref) {
  return ref ? elementJson(mesh, *ref) : Json(nullptr);
}

std::string elementCounts(const ElementCounts& elements) {
  std::string text;
  for (const auto& [name, count] : elements) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, name);
  return text;
}

std::string elementCounts(const Mesh& mesh) { return elementCounts(countElements(mesh)); }

}  // namespace ringwatch

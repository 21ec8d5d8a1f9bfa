#include <ringwatch/app/scene/scene_mesh.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <ringwatch/base/nearest_name.h>

namespace ringwatch {
namespace {

using Json = nlohmann::ordered_json;

const GeneratorParameter* findParameter(const GeneratorInfo& generator, std::string_view name) {
  for (const GeneratorParameter& parameter : generator.parameters)
    if (parameter.name == name) return &parameter;
  return nullptr;
}

Json defaultOf(const GeneratorParameter& p) {
  if (p.kind == ParameterKind::text) return std::string(p.textDefault);
  const auto number = [&](double value) {
    return p.kind == ParameterKind::integer ? Json(static_cast<std::int64_t>(value)) : Json(value);
  };
  if (p.count == 1) return number(p.defaults[0]);
  Json list = Json::array();
  for (int i = 0; i < p.count; ++i) list.push_back(number(p.defaults[i]));
  return list;
}

bool inRange(const GeneratorParameter& p, double value) {
  return (p.minAllowed ? value >= p.min : value > p.min) && (p.maxAllowed ? value <= p.max : value < p.max);
}

}  // namespace

std::vector<std::string> generatorNames() {
  std::vector<std::string> names;
  for (const GeneratorInfo& generator : allGenerators()) names.emplace_back(generator.name);
  return names;
}

std::vector<SceneKey> generatorSceneKeys() {
  std::vector<SceneKey> keys;
  for (const GeneratorInfo& generator : allGenerators())
    for (const GeneratorParameter& p : generator.parameters) {
      const auto same = std::find_if(keys.begin(), keys.end(), [&](const SceneKey& key) { return key.key == p.name; });
      if (same != keys.end()) {
        same->help += fmt::format(", {}", generator.name);
        continue;
      }
      keys.push_back({.key = std::string(p.name),
                      .type = SceneType::parameter,
                      .unit = std::string(p.unit),
                      .help = fmt::format("of the generators {}", generator.name)});
    }
  return keys;
}

std::string generatorFault(const std::string& generator, const std::string& parameter, const Json& value) {
  const GeneratorInfo& info = *findGenerator(generator);
  const GeneratorParameter* p = findParameter(info, parameter);
  if (!p) {
    std::vector<std::string_view> known;
    for (const GeneratorParameter& other : info.parameters) known.push_back(other.name);
    return fmt::format("the generator \"{}\" has no such parameter; it takes {}", generator, fmt::join(known, ", "));
  }
  const std::string kind = p->kind == ParameterKind::text      ? "text"
                           : p->kind == ParameterKind::integer ? "integer"
                                                               : "number";
  const std::string right = p->count == 1
                                ? fmt::format("must be one {}, {}", kind, parameterRange(*p))
                                : fmt::format("must be a list of {} {}s, each {}", p->count, kind, parameterRange(*p));
  const std::string fault = fmt::format("{} does not fit; {}", value.dump(), right);
  if (p->kind == ParameterKind::text) return value.is_string() ? "" : fault;  // the choices are generateMesh's to check
  const Json numbers = value.is_array() ? value : Json::array({value});
  if (numbers.size() != static_cast<std::size_t>(p->count)) return fault;
  for (const Json& number : numbers) {
    if (!number.is_number()) return fault;
    const double x = number.get<double>();
    if (!inRange(*p, x) || (p->kind == ParameterKind::integer && x != std::floor(x))) return fault;
  }
  return "";
}

Json generatorDefaults(const std::string& generator) {
  Json values = Json::object();
  for (const GeneratorParameter& p : findGenerator(generator)->parameters) values[std::string(p.name)] = defaultOf(p);
  return values;
}

GeneratorArguments generatorArguments(const Json& values) {
  GeneratorArguments arguments;
  for (const auto& [name, value] : values.items()) {
    if (value.is_array())
      arguments[name] = value.get<std::vector<double>>();
    else if (value.is_string())
      arguments[name] = value.get<std::string>();
    else
      arguments[name] = value.get<double>();
  }
  return arguments;
}

std::string generatorHelp() {
  std::string text;
  for (const GeneratorInfo& generator : allGenerators()) {
    text += fmt::format("  {}  {}\n", generator.name, generator.help);
    for (const GeneratorParameter& p : generator.parameters)
      text += fmt::format("    {:<9} {}{}; {}; default {}\n", p.name, p.help,
                          p.unit.empty() ? "" : fmt::format(", {}", p.unit), parameterRange(p), defaultOf(p).dump());
  }
  return text;
}

}  // namespace ringwatch

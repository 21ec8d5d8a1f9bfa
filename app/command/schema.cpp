#include <ringwatch/app/command/schema.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include <fmt/format.h>

#include <ringwatch/app/output/output_fields.h>
#include <ringwatch/app/scene/capabilities.h>
#include <ringwatch/app/scene/probe_quantity.h>
#include <ringwatch/app/scene/scene_keys.h>
#include <ringwatch/app/scene/scene_mesh.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/nearest_name.h>
#include <ringwatch/base/user_text.h>
#include <ringwatch/body/obstacle.h>
#include <ringwatch/handlers/handler.h>
#include <ringwatch/materials/registry.h>

namespace ringwatch {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* draft = "http://json-schema.org/draft-07/schema#";
constexpr std::string_view sceneName = "scene";

void addRange(Json& schema, const NumberRange& range) {
  if (std::isfinite(range.low)) schema[range.lowIncluded ? "minimum" : "exclusiveMinimum"] = range.low;
  if (std::isfinite(range.high)) schema[range.highIncluded ? "maximum" : "exclusiveMaximum"] = range.high;
}

Json numberSchema(const char* type, const NumberRange& range) {
  Json schema{{"type", type}};
  addRange(schema, range);
  return schema;
}

/// count: of the items, 0 for any.
Json listOf(Json items, int count) {
  Json schema{{"type", "array"}, {"items", std::move(items)}};
  if (count > 0) schema["minItems"] = schema["maxItems"] = count;
  return schema;
}

Json textSchema(const std::vector<std::string>& choices) {
  return choices.empty() ? Json{{"type", "string"}} : Json{{"enum", choices}};
}

Json valueSchema(const SceneKey& key) {
  std::vector<std::string> choices = key.choices;
  for (const auto& [alias, meant] : key.aliases) choices.push_back(alias);
  const Json number = numberSchema("number", key.range);
  switch (key.type) {
    case SceneType::number:
      return number;
    case SceneType::integer:
      return numberSchema("integer", key.range);
    case SceneType::boolean:
      return {{"type", "boolean"}};
    case SceneType::text:
      return textSchema(choices);
    case SceneType::texts:
      return listOf(textSchema(choices), 0);
    case SceneType::numbers:
      return listOf(number, 0);
    case SceneType::vector:
      return listOf(number, 3);
    case SceneType::vectors:
      return listOf(listOf(number, 3), 0);
    case SceneType::numberOrAuto:
      return {{"anyOf", Json::array({Json{{"const", "auto"}}, number})}};
    case SceneType::parameter:
      return {{"type", Json::array({"number", "string", "array"})}};
  }
  return {};
}

Json keySchema(const SceneKey& key) {
  Json schema = valueSchema(key);
  schema["description"] = key.unit.empty() ? key.help : fmt::format("{}; in {}", key.help, key.unit);
  if (Json value = Json::parse(key.fallback, nullptr, false); !key.fallback.empty() && !value.is_discarded())
    schema["default"] = std::move(value);
  return schema;
}

Json parameterSchema(const GeneratorParameter& parameter) {
  if (parameter.kind == ParameterKind::text) return textSchema(parameterChoices(parameter));
  const Json number = numberSchema(parameter.kind == ParameterKind::integer ? "integer" : "number",
                                   {parameter.min, parameter.max, parameter.minAllowed, parameter.maxAllowed});
  const Json list = listOf(number, parameter.count);
  return parameter.count == 1 ? Json{{"anyOf", Json::array({number, list})}} : list;
}

Json optionSchema(const OptionInfo& option) {
  if (option.type == OptionType::text) {
    std::vector<std::string> choices(option.choices.begin(), option.choices.end());
    if (option.automatic && !choices.empty()) choices.emplace_back("auto");
    return textSchema(choices);
  }
  Json number = numberSchema(option.type == OptionType::integer ? "integer" : "number", option.range);
  return option.automatic ? Json{{"anyOf", Json::array({Json{{"const", "auto"}}, number})}} : number;
}

/// {"if": the key has one of these values, "then": …}
Json whereKeyIs(std::string_view key, const Json& values, Json then) {
  return {{"if", {{"properties", {{std::string(key), {{"enum", values}}}}}, {"required", {std::string(key)}}}},
          {"then", std::move(then)}};
}

/// What depends on the generator: its parameters, and that it has no others.
Json meshRules() {
  const std::vector<SceneKey> all = generatorSceneKeys();
  Json rules = Json::array(), none = Json::object();
  for (const SceneKey& key : all) none[key.key] = false;
  rules.push_back({{"if", {{"required", {"file"}}}}, {"then", {{"properties", none}}}});
  for (const GeneratorInfo& generator : allGenerators()) {
    Json properties = none;
    for (const GeneratorParameter& p : generator.parameters) properties[std::string(p.name)] = parameterSchema(p);
    rules.push_back(whereKeyIs("generate", {generator.name}, {{"properties", std::move(properties)}}));
  }
  return rules;
}

/// The conditions of options that make sense only with a value of another one.
void addConditions(std::span<const OptionInfo> table, Json& rules) {
  for (const OptionInfo& option : table) {
    const auto& [other, values] = option.onlyWith;
    if (other.empty()) continue;
    Json allowed = Json::array();
    for (const std::string_view value : values) allowed.push_back(value);
    const OptionInfo& info = *findOption(table, other);
    const std::string_view fallback =
        info.fallback == "auto" && !info.choices.empty() ? info.choices.front() : info.fallback;
    const bool byDefault = std::ranges::find(values, fallback) != values.end();
    if (byDefault && info.automatic) allowed.push_back("auto");
    Json then{{"properties", {{std::string(other), {{"enum", std::move(allowed)}}}}}};
    if (!byDefault) then["required"] = {std::string(other)};
    rules.push_back({{"if", {{"required", {std::string(option.name)}}}}, {"then", std::move(then)}});
  }
}

/// What depends on the law: its parameters, and that it has no others.
Json materialRules() {
  Json rules = Json::array();
  for (const LawInfo& law : allLaws()) {
    Json properties = Json::object(), required = Json::array();
    for (const SceneKey& key : sceneKeys())
      if (key.section == "material" && isLawParameter(key.key)) properties[key.key] = false;
    for (const OptionInfo& option : law.parameters) {
      properties[std::string(option.name)] = optionSchema(option);
      if (option.fallback.empty()) required.push_back(option.name);
    }
    Json then{{"properties", std::move(properties)}, {"required", std::move(required)}};
    Json conditions = Json::array();
    addConditions(law.parameters, conditions);
    if (!conditions.empty()) then["allOf"] = std::move(conditions);
    rules.push_back(whereKeyIs("model", {law.name}, std::move(then)));
  }
  return rules;
}

/// What depends on the handler: its options and selections, that it has no others, and that without one nothing is said
/// of it.
Json handlerRules() {
  Json rules = Json::array(), handlers = Json::array();
  for (const HandlerEntry& entry : allHandlers()) {
    const HandlerInfo& info = *entry.info;
    Json names{info.name}, selections = Json::array(), properties = Json::object();
    if (!info.alias.empty()) names.push_back(info.alias);
    handlers.insert(handlers.end(), names.begin(), names.end());
    for (const auto& known : selectionNames) {
      if (!info.takes(known.value)) continue;
      selections.push_back(known.name);
      if (!known.alias.empty()) selections.push_back(known.alias);
    }
    for (const SceneKey& key : sceneKeys())
      if (key.section == "handler" && !isKeyOfEveryHandler(key.key)) properties[key.key] = false;
    for (const OptionInfo& option : info.options) properties[std::string(option.name)] = optionSchema(option);
    properties["selection"] = {{"enum", std::move(selections)}};
    Json then{{"properties", std::move(properties)}};
    Json conditions = Json::array();
    addConditions(info.options, conditions);
    if (!conditions.empty()) then["allOf"] = std::move(conditions);
    rules.push_back(whereKeyIs("method", names, std::move(then)));
  }
  Json none = whereKeyIs("method", handlers, true);
  none["else"] = {{"propertyNames", {{"const", "method"}}}};
  rules.push_back(std::move(none));
  return rules;
}

/// What depends on the kind of an obstacle: its parameters, and that it has no others.
Json obstacleRules() {
  Json rules = Json::array(), none = Json::object();
  for (const ObstacleKind& kind : allObstacleKinds())
    for (const auto* names : {&kind.needs, &kind.takes})
      for (const std::string_view name : *names) none[std::string(name)] = false;
  for (const ObstacleKind& kind : allObstacleKinds()) {
    Json properties = none;
    for (const auto* names : {&kind.needs, &kind.takes})
      for (const std::string_view name : *names) properties.erase(std::string(name));
    rules.push_back(whereKeyIs("kind", {kind.name}, {{"properties", std::move(properties)}, {"required", kind.needs}}));
  }
  return rules;
}

/// What depends on the quantity of a probe.
Json probeRules() {
  Json rules = Json::array();
  for (const ProbeQuantity& quantity : allProbeQuantities()) {
    Json as = Json::array();
    for (const ProbeReduction one : quantity.as) as.push_back(probeReductionNames.nameOf(one));
    Json properties{{"as", {{"enum", std::move(as)}}}};
    if (quantity.ofNodes()) properties["material"] = false;
    if (quantity.kind != ProbeQuantity::Kind::step) properties["metric"] = false;
    rules.push_back(whereKeyIs("what", {quantity.name}, {{"properties", std::move(properties)}}));
  }
  return rules;
}

/// count: how many of the section there are at least.
Json alternativeRule(const SceneAlternative& alternative, int count) {
  using Need = SceneAlternative::Need;
  if (alternative.need == Need::atMostOne || (alternative.need == Need::oneOfMany && count == 1))
    return {{"not", {{"required", alternative.keys()}}}};
  Json choices = Json::array();
  for (const std::string& key : alternative.keys()) choices.push_back({{"required", Json::array({key})}});
  return {{alternative.need == Need::any ? "anyOf" : "oneOf", std::move(choices)}};
}

}  // namespace

Json schemaOf(const SceneSection& section) {
  Json properties = Json::object(), required = Json::array(), rules = Json::array();
  for (const SceneKey& key : section.keys) {
    properties[key.key] = keySchema(key);
    if (key.required) required.push_back(key.key);
  }
  for (const SceneAlternative& alternative : section.alternatives) rules.push_back(alternativeRule(alternative, 1));
  static const std::map<std::string_view, Json (*)()> ofRegistries{{"mesh", meshRules},
                                                                   {"material", materialRules},
                                                                   {"handler", handlerRules},
                                                                   {"obstacle", obstacleRules},
                                                                   {"probe", probeRules}};
  if (const auto found = ofRegistries.find(section.name); found != ofRegistries.end())
    for (Json& rule : found->second()) rules.push_back(std::move(rule));
  Json schema{{"type", "object"}, {"description", section.help}, {"properties", std::move(properties)}};
  if (!required.empty()) schema["required"] = std::move(required);
  schema["additionalProperties"] = false;
  if (!rules.empty()) schema["allOf"] = std::move(rules);
  return schema;
}

namespace {

Json sceneSchema() {
  Json properties = Json::object(), required = Json::array();
  for (const SceneSection& section : sceneSections()) {
    Json one = schemaOf(section);
    Json list = listOf(one, 0);
    list["description"] = section.help;
    if (section.required) list["minItems"] = 1;
    for (const SceneAlternative& alternative : section.alternatives)
      if (alternative.need == SceneAlternative::Need::oneOfMany)
        list["allOf"].push_back({{"if", {{"minItems", 2}}}, {"then", {{"items", alternativeRule(alternative, 2)}}}});
    const std::string name(section.name);
    if (section.list)
      properties[name] = std::move(list);
    else
      properties[name] = section.alsoList ? Json{{"anyOf", {std::move(one), std::move(list)}}} : std::move(one);
    if (section.required) required.push_back(section.name);
  }
  return {{"$schema", draft},
          {"title", "ringwatch scene"},
          {"description", "A scene file of ringwatch, TOML read as JSON"},
          {"type", "object"},
          {"properties", std::move(properties)},
          {"required", std::move(required)},
          {"additionalProperties", false},
          {"x-capabilities", capabilitiesJson()}};
}

/// The keys of an output as the tree that their names describe.
struct FieldTree {
  const OutputField* field = nullptr;
  std::vector<std::pair<std::string, std::unique_ptr<FieldTree>>> inner;  // "[]" and "*" as they are written

  FieldTree& at(const std::string& part) {
    for (auto& [name, tree] : inner)
      if (name == part) return *tree;
    return *inner.emplace_back(part, std::make_unique<FieldTree>()).second;
  }
};

FieldTree treeOf(std::span<const OutputField> fields) {
  FieldTree root;
  for (const OutputField& field : fields) {
    FieldTree* tree = &root;
    for (std::size_t begin = 0; begin <= field.name.size();) {
      const std::size_t end = std::min(field.name.find('.', begin), field.name.size());
      std::string part(field.name.substr(begin, end - begin));
      const bool list = part.ends_with("[]");
      if (list) part.resize(part.size() - 2);
      tree = &tree->at(part);
      if (list) tree = &tree->at("[]");
      begin = end + 1;
    }
    tree->field = &field;
  }
  return root;
}

bool mayBeMissing(const FieldTree& tree) {
  return tree.field != nullptr &&
         (tree.field->presence == Presence::sometimes || tree.field->presence == Presence::sometimesOrNull);
}

Json treeSchema(const FieldTree& tree) {
  static constexpr std::pair<FieldType, const char*> names[] = {{FieldType::number, "number"},
                                                                {FieldType::integer, "integer"},
                                                                {FieldType::text, "string"},
                                                                {FieldType::boolean, "boolean"}};
  Json schema = Json::object();
  const char* type = nullptr;
  if (tree.inner.empty()) {
    for (const auto& [known, name] : names)
      if (tree.field->type == known) type = name;
  } else if (tree.inner.front().first == "[]") {
    type = "array";
    schema["items"] = treeSchema(*tree.inner.front().second);
  } else {
    type = "object";
    Json properties = Json::object(), required = Json::array(), others = false;
    for (const auto& [name, part] : tree.inner) {
      if (name == "*") {
        others = treeSchema(*part);
        continue;
      }
      properties[name] = treeSchema(*part);
      if (!mayBeMissing(*part)) required.push_back(name);
    }
    schema["properties"] = std::move(properties);
    if (!required.empty()) schema["required"] = std::move(required);
    schema["additionalProperties"] = std::move(others);
  }
  if (tree.field != nullptr) {
    const OutputField& field = *tree.field;
    schema["description"] =
        field.unit.empty() ? std::string(field.help) : fmt::format("{}; in {}", field.help, field.unit);
    if (type != nullptr && (field.presence == Presence::orNull || field.presence == Presence::sometimesOrNull)) {
      schema["type"] = {type, "null"};
      return schema;
    }
  }
  if (type != nullptr) schema["type"] = type;
  return schema;
}

Json outputSchema(const JsonOutput& output) {
  Json schema{{"$schema", draft}, {"title", fmt::format("ringwatch {}", output.name)}, {"description", output.help}};
  schema.update(treeSchema(treeOf(output.fields)));
  return schema;
}

}  // namespace

std::vector<SchemaInfo> allSchemas() {
  std::vector<SchemaInfo> schemas{{sceneName, "a scene file, TOML read as JSON"}};
  for (const JsonOutput& output : jsonOutputs()) schemas.push_back({output.name, output.help});
  return schemas;
}

Json schemaOf(std::string_view name) {
  if (name == sceneName) return sceneSchema();
  for (const JsonOutput& output : jsonOutputs())
    if (output.name == name) return outputSchema(output);
  std::vector<std::string> known;
  for (const SchemaInfo& schema : allSchemas()) known.emplace_back(schema.name);
  throw InputError(fmt::format("schema: there is none of {}; {}known are {}", inQuotes(name), didYouMean(name, known),
                               fmt::join(known, ", ")));
}

}  // namespace ringwatch

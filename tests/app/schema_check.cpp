#include "schema_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <toml++/toml.h>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

namespace ringwatch::test {
namespace {

using Json = nlohmann::json;
using Adapter = valijson::adapters::NlohmannJsonAdapter;

Json jsonOf(const toml::node& node) {
  if (const auto* text = node.as_string()) return **text;
  if (const auto* integer = node.as_integer()) return **integer;
  if (const auto* number = node.as_floating_point()) return std::isfinite(**number) ? Json(**number) : Json();
  if (const auto* boolean = node.as_boolean()) return **boolean;
  if (const auto* list = node.as_array()) {
    Json result = Json::array();
    for (const toml::node& one : *list) result.push_back(jsonOf(one));
    return result;
  }
  Json result = Json::object();
  if (const auto* table = node.as_table())
    for (const auto& [key, value] : *table) result[std::string(key.str())] = jsonOf(value);
  return result;
}

}  // namespace

struct SchemaCheck::Parsed {
  valijson::Schema schema;
};

SchemaCheck::SchemaCheck(const Json& schema) : parsed_(std::make_unique<Parsed>()) {
  valijson::SchemaParser(valijson::SchemaParser::kDraft7).populateSchema(Adapter(schema), parsed_->schema);
}
SchemaCheck::~SchemaCheck() = default;
SchemaCheck::SchemaCheck(SchemaCheck&&) noexcept = default;

std::string SchemaCheck::faultOf(const Json& document) const {
  valijson::ValidationResults results;
  // Types are not converted: "1" is no number.
  if (valijson::Validator(valijson::Validator::kStrongTypes).validate(parsed_->schema, Adapter(document), &results))
    return {};
  std::ostringstream text;
  for (valijson::ValidationResults::Error error; results.popError(error);) {
    for (const std::string& part : error.context) text << part;
    text << ": " << error.description << "\n";
  }
  return text.str();
}

Json jsonOfToml(const std::string& text) {
  try {
    return jsonOf(toml::parse(text));
  } catch (const toml::parse_error&) {
    return {};
  }
}

Json withOverrides(Json scene, const std::vector<std::string>& overrides) {
  for (const std::string& text : overrides) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) return {};
    std::vector<std::string> parts;
    std::istringstream path(text.substr(0, equals));
    for (std::string part; std::getline(path, part, '.');) parts.push_back(part);
    if (parts.size() != 2 && parts.size() != 3) return {};
    const std::string value = text.substr(equals + 1);
    Json assignment = jsonOfToml("value = " + value);
    if (assignment.is_null()) assignment = jsonOfToml("value = \"" + value + "\"");
    if (!assignment.is_object() || assignment.size() != 1) return {};
    Json* section = &scene[parts[0]];
    if (parts.size() == 3) {
      if (!section->is_array() || parts[1].size() != 1 || parts[1] < "0" || parts[1] > "9") return {};
      const std::size_t index = parts[1][0] - '0';
      if (index >= section->size()) return {};
      section = &(*section)[index];
    }
    if (!section->is_object() && !section->is_null()) return {};
    (*section)[parts.back()] = assignment["value"];
  }
  return scene;
}

bool isAboutTypeRangeOrKey(const std::string& message) {
  static constexpr std::array parts{"is out of range",
                                    "is not a finite number",
                                    " is needed",
                                    " are needed",
                                    ": unknown \"",  // choice, behind its key
                                    "unknown key",
                                    "unknown section",
                                    "outside of a section",
                                    "section is missing",
                                    "missing; give",
                                    "does not fit",
                                    "has no such parameter",
                                    "is no parameter of the law",
                                    " are given; give one",
                                    "there is no handler; set",
                                    "does not take it"};
  return std::ranges::any_of(parts, [&](const char* part) { return message.find(part) != std::string::npos; });
}

}  // namespace ringwatch::test

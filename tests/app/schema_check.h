#pragma once
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace ringwatch::test {

/// A JSON Schema and what a validator that knows nothing of ringwatch says of documents.
class SchemaCheck {
 public:
  explicit SchemaCheck(const nlohmann::json& schema);
  ~SchemaCheck();
  SchemaCheck(SchemaCheck&&) noexcept;
  /// "" for a valid document, else what is wrong with it.
  std::string faultOf(const nlohmann::json& document) const;

 private:
  struct Parsed;
  std::unique_ptr<Parsed> parsed_;
};

/// TOML as the JSON that a schema is about: numbers that are not finite are null. Null for what is not TOML.
nlohmann::json jsonOfToml(const std::string& text);

/// A scene with `section.key=value` or `section.index.key=value` for each override, as `--set` has it; null where one
/// is no such assignment, or names what is not there.
nlohmann::json withOverrides(nlohmann::json scene, const std::vector<std::string>& overrides);

/// Whether a message about a scene is about a type, a range, a choice, a key or a section, which a schema tells too.
bool isAboutTypeRangeOrKey(const std::string& message);

}  // namespace ringwatch::test

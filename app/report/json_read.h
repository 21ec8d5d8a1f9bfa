#pragma once
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

/// Values of a summary that may be missing or of another type, as when a file was edited by hand.
namespace ringwatch::json_read {

inline std::optional<double> numberOf(const nlohmann::ordered_json& object, const char* key) {
  const auto found = object.find(key);
  return found == object.end() || !found->is_number() ? std::nullopt : std::optional(found->get<double>());
}

/// "" where there is no text.
inline std::string textOf(const nlohmann::ordered_json& object, const char* key) {
  const auto found = object.find(key);
  return found == object.end() || !found->is_string() ? std::string() : found->get<std::string>();
}

}  // namespace ringwatch::json_read

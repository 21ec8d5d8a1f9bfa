#pragma once
#include <span>
#include <string_view>

namespace ringwatch {

enum class FieldType { number, integer, text, boolean, object, any };
/// Whether a key of a JSON file is always there, and whether it can be null.
enum class Presence { always, orNull, sometimes, sometimesOrNull };

/// A number or text that a command leaves in one of its files.
struct OutputField {
  std::string_view name;
  std::string_view unit;  // "" where it has none
  std::string_view help;  // one line
  FieldType type = FieldType::number;
  Presence presence = Presence::always;
};

/// The columns of history.csv in their order. A cell is empty where nothing was computed.
std::span<const OutputField> historyColumns();
/// The keys of summary.json, those of objects by dots and those of an array's entries by []; `*` is any key. An object
/// is listed by itself where it can be null or missing.
std::span<const OutputField> summaryKeys();
/// The fields of a frame: at nodes, at elements and of the whole frame.
std::span<const OutputField> frameFields();

/// A JSON file that a command writes.
struct JsonOutput {
  std::string_view name;  // of its schema
  std::string_view help;  // one line
  std::span<const OutputField> fields;
};
/// Every JSON file, one entry each in output_fields.cpp. `ringwatch schema` and the reference are made from them.
std::span<const JsonOutput> jsonOutputs();

}  // namespace ringwatch

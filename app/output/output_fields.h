#pragma once
#include <span>
#include <string_view>

namespace ringwatch {

/// A number or text that a run leaves in one of its files.
struct OutputField {
  std::string_view name;
  std::string_view unit;  // "" where it has none
  std::string_view help;  // one line
};

/// The columns of history.csv in their order. A cell is empty where nothing was computed.
std::span<const OutputField> historyColumns();
/// The keys of summary.json, those of objects by dots and those of an array's entries by []; `*` is any key. A key is
/// null where the run has none of it.
std::span<const OutputField> summaryKeys();
/// The fields of a frame: at nodes, at elements and of the whole frame.
std::span<const OutputField> frameFields();

}  // namespace ringwatch

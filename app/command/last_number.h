#pragma once
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <ringwatch/base/number_format.h>

namespace ringwatch {

/// The finite number that stands alone in the last line of a text that is not blank, empty where none does, and that
/// line.
inline std::pair<std::optional<double>, std::string> lastNumber(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  text = text.substr(0, text.find_last_not_of(blanks) + 1);
  const std::string_view line = text.substr(text.find_last_of('\n') + 1);
  const std::optional<double> value = readNumber(line.substr(std::min(line.find_first_not_of(blanks), line.size())));
  return {value && std::isfinite(*value) ? value : std::nullopt, std::string(line)};
}

}  // namespace ringwatch

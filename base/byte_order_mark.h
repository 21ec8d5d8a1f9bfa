#pragma once
#include <cstddef>
#include <string_view>

namespace ringwatch {

/// The bytes of the mark that some editors write before a text in UTF-8: 0 for a text without.
constexpr std::size_t byteOrderMarkOf(std::string_view text) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  return text.starts_with(mark) ? mark.size() : 0;
}

}  // namespace ringwatch

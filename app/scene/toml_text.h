#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace ringwatch {

/// What is wrong with a text before it is examined as TOML.
struct TomlTextFault {
  std::size_t line;  // counted from 1
  std::string what;
};

/// TOML is UTF-8 without NUL, and ASCII outside of texts and comments. The parser relies on it: toml++ 3.3 runs into
/// undefined behaviour at the letters U+00A1 to U+0499 and others where it searches for white space. Nothing when all
/// is well.
std::optional<TomlTextFault> tomlTextFault(std::string_view text);

/// Where the first byte lies that is not UTF-8; the size of the text for nowhere.
std::size_t firstNotUtf8(std::string_view text);

}  // namespace ringwatch

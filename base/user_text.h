#pragma once
#include <algorithm>
#include <cstddef>
#include <ranges>
#include <string>
#include <string_view>

namespace ringwatch {

/// Error messages show at most so many bytes of a text that a user has written.
inline constexpr std::size_t longestUserText = 80;
/// Error messages show at most so many names of a list that a user's file determines.
inline constexpr std::size_t longestUserList = 20;

/// A user's text on one line: control characters as '?', and no more than `most` bytes, cut between UTF-8 characters,
/// with "…" where something is left out.
inline std::string shortened(std::string_view text, std::size_t most = longestUserText) {
  std::size_t end = std::min(text.size(), most);
  if (end < text.size())
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
  std::string result;
  for (const char c : text.substr(0, end)) {
    const auto byte = static_cast<unsigned char>(c);
    result += byte < 0x20 || byte == 0x7f ? '?' : c;
  }
  return end < text.size() ? result + "…" : result;
}

/// A user's text, shortened, in double quotes.
inline std::string inQuotes(std::string_view text) { return "\"" + shortened(text) + "\""; }

/// Names of a user's file, separated by commas: the first ones, and how many more there are.
template <std::ranges::sized_range Names>
std::string shortList(const Names& names) {
  std::string text;
  std::size_t shown = 0;
  for (const auto& name : names) {
    if (shown == longestUserList) return text + " and " + std::to_string(std::ranges::size(names) - shown) + " more";
    text += (shown++ == 0 ? "" : ", ") + shortened(name);
  }
  return text;
}

/// "a, b and c".
template <std::ranges::forward_range Names>
std::string listed(const Names& names) {
  std::string text;
  for (auto name = std::ranges::begin(names); name != std::ranges::end(names);) {
    const std::string_view shown = *name++;
    text += (text.empty() ? "" : name == std::ranges::end(names) ? " and " : ", ") + std::string(shown);
  }
  return text;
}

}  // namespace ringwatch

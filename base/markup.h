#pragma once
#include <string>
#include <string_view>

namespace ringwatch {

/// A text as part of XML or HTML, between tags or in an attribute's double quotes.
inline std::string markupText(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

}  // namespace ringwatch

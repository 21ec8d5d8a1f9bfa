#pragma once
#include <string>

namespace ringwatch {

/// A text inside a gnuplot string in single quotes; control characters are left out.
inline std::string gnuplotQuoted(const std::string& text) {
  std::string result = "'";
  for (char c : text) {
    if (static_cast<unsigned char>(c) < 0x20) continue;
    result += c;
    if (c == '\'') result += c;
  }
  result += "'";
  return result;
}

}  // namespace ringwatch

#include <ringwatch/app/scene/toml_text.h>

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>

#include <ringwatch/base/byte_order_mark.h>

namespace ringwatch {
namespace {

struct Character {
  std::uint32_t code = 0;
  std::size_t bytes = 0;  // 0: not UTF-8
};

/// The character at the beginning of a text that is not empty (The Unicode Standard, table 3-7).
Character decode(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i])); };
  const std::uint32_t first = byte(0);
  if (first < 0x80) return {first, 1};
  const std::size_t bytes = first >= 0xC2 && first <= 0xDF   ? 2
                            : first >= 0xE0 && first <= 0xEF ? 3
                            : first >= 0xF0 && first <= 0xF4 ? 4
                                                             : 0;
  if (bytes == 0 || text.size() < bytes) return {};
  std::uint32_t code = first & (0xFFu >> (bytes + 1));
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return {};
    code = code << 6 | (byte(i) & 0x3F);
  }
  const bool overlong = code < (bytes == 3 ? 0x800u : bytes == 4 ? 0x10000u : 0x80u);
  if (overlong || code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF)) return {};
  return {code, bytes};
}

/// Walks through texts and comments as TOML has them.
class Walk {
 public:
  explicit Walk(std::string_view text) : text_(text) {}

  /// Where the first character lies that is not ASCII and stands outside of them; the size of the text for nowhere.
  std::size_t firstStray() {
    at_ = byteOrderMarkOf(text_);
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (static_cast<unsigned char>(c) >= 0x80) return at_;
      if (c == '#') {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else if (c == '"' || c == '\'') {
        const bool many = text_.substr(at_, 3) == std::string(3, c);
        at_ += many ? 3 : 1;
        if (!(many ? skipLines(c) : skipLine(c))) return at_;
      } else {
        ++at_;
      }
    }
    return text_.size();
  }

 private:
  /// To the end of a text on one line. One that does not end is the parser's to refuse.
  bool skipLine(char quote) {
    for (; at_ < text_.size() && text_[at_] != '\n'; ++at_) {
      if (text_[at_] == quote) {
        ++at_;
        return true;
      }
      if (text_[at_] == '\\' && quote == '"') ++at_;
    }
    return true;
  }
  /// The same of one on several lines. False at a letter that the parser would look at for white space: after a
  /// backslash, at once or after white space.
  bool skipLines(char quote) {
    while (at_ < text_.size()) {
      if (text_.substr(at_, 3) == std::string(3, quote)) {
        at_ += 3;
        for (int more = 0; more < 2 && at_ < text_.size() && text_[at_] == quote; ++more) ++at_;  // part of the text
        return true;
      }
      if (text_[at_++] != '\\' || quote != '"') continue;
      const std::size_t after = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size());
      if (after < text_.size() && static_cast<unsigned char>(text_[after]) >= 0x80) {
        at_ = after;
        return false;
      }
      at_ = std::max(after, at_ + 1);
    }
    return true;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

std::optional<TomlTextFault> tomlTextFault(std::string_view text) {
  const auto fault = [&](std::size_t at, std::string what) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(at);
    return TomlTextFault{1 + static_cast<std::size_t>(std::count(text.begin(), end, '\n')), std::move(what)};
  };
  if (const std::size_t at = firstNotUtf8(text); at < text.size())
    return fault(at, fmt::format("the byte 0x{:02X} is not UTF-8; save the text as UTF-8",
                                 static_cast<unsigned>(static_cast<unsigned char>(text[at]))));
  if (const std::size_t at = text.find('\0'); at != text.npos)
    return fault(at, "a NUL byte, which no text has; is this a scene file (TOML)?");
  if (const std::size_t at = Walk(text).firstStray(); at < text.size())
    return fault(at, fmt::format("the character U+{:04X} is not ASCII; it may stand in a \"text\" or a comment only",
                                 decode(text.substr(at)).code));
  return std::nullopt;
}

std::size_t firstNotUtf8(std::string_view text) {
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t bytes = decode(text.substr(at)).bytes;
    if (bytes == 0) break;
    at += bytes;
  }
  return at;
}

}  // namespace ringwatch

#pragma once
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

namespace ringwatch {

/// FNV-1a, 64 bits (Fowler, Noll, Vo): finds damage and changes, resists no forgery.
class Fnv {
 public:
  void add(std::string_view bytes) {
    for (const char byte : bytes) value_ = (value_ ^ static_cast<unsigned char>(byte)) * prime;
  }
  template <class... Numbers>
  void addNumbers(Numbers... numbers) {
    (add({reinterpret_cast<const char*>(&numbers), sizeof numbers}), ...);
  }
  /// Eight bytes at a time, for files of a hundred megabytes.
  void addByWords(std::string_view text) {
    for (; text.size() >= sizeof value_; text.remove_prefix(sizeof value_)) {
      std::uint64_t word = 0;
      std::memcpy(&word, text.data(), sizeof word);
      value_ = (value_ ^ word) * prime;
      value_ ^= value_ >> 32;
    }
    add(text);
  }
  std::uint64_t value() const { return value_; }

 private:
  static constexpr std::uint64_t prime = 0x100000001b3;
  std::uint64_t value_ = 0xcbf29ce484222325;
};

inline std::uint64_t checksumOf(std::string_view text) {
  Fnv sum;
  sum.addByWords(text);
  return sum.value();
}
/// A text with its checksum behind it.
inline std::string sealed(std::string text) {
  const std::uint64_t sum = checksumOf(text);
  text.append(reinterpret_cast<const char*>(&sum), sizeof sum);
  return text;
}
/// The text that sealed() was given; nothing where the bytes are others.
inline std::optional<std::string_view> unsealed(std::string_view bytes) {
  std::uint64_t sum = 0;
  if (bytes.size() < sizeof sum) return std::nullopt;
  const std::string_view text = bytes.substr(0, bytes.size() - sizeof sum);
  std::memcpy(&sum, bytes.data() + text.size(), sizeof sum);
  return sum == checksumOf(text) ? std::optional(text) : std::nullopt;
}

}  // namespace ringwatch

#pragma once
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace ringwatch::test {

/// A certificate whose last eight bytes, its checksum, are made right again.
inline std::string sealed(std::string bytes) {
  std::uint64_t sum = 0xcbf29ce484222325ULL;
  for (std::size_t i = 0; i + 8 < bytes.size(); ++i)
    sum = (sum ^ static_cast<unsigned char>(bytes[i])) * 0x100000001b3ULL;
  std::memcpy(bytes.data() + bytes.size() - 8, &sum, 8);
  return bytes;
}

/// Where the number in a line of a certificate's header begins.
inline std::size_t headerPlace(const std::string& bytes, const std::string& key) {
  return bytes.find("\n" + key + " ") + key.size() + 2;
}
inline double headerNumber(const std::string& bytes, const std::string& key) {
  return std::strtod(bytes.c_str() + headerPlace(bytes, key), nullptr);
}
/// A certificate with another number in a line of its header.
inline std::string withHeader(std::string bytes, const std::string& key, double value) {
  const std::size_t from = headerPlace(bytes, key), end = bytes.find('\n', from);
  char text[40];
  std::snprintf(text, sizeof text, "%a", value);
  return bytes.replace(from, end - from, text);
}

}  // namespace ringwatch::test

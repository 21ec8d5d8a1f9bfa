#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace ringwatch {

/// &, <, > and quotes as HTML has them; control characters are left out.
std::string htmlText(std::string_view text);
/// A JSON value as the content of a <script>: no "<" in it, bytes that are not UTF-8 replaced.
std::string scriptJson(const nlohmann::ordered_json& value);
std::string base64(std::string_view bytes);
/// Packed by zlib. Throws std::bad_alloc.
std::string deflated(std::string_view bytes);

/// Arrays of numbers for the page, each a script element of its own: the bytes of all values, first all lowest bytes,
/// then all second ones and so on, packed by zlib (RFC 1950), in base64. The browser unpacks an array when it needs it.
class PageData {
 public:
  /// Adds an array; returns its number, by which the page asks for it.
  std::size_t add(std::span<const double> values) { return addBytes("f64", values); }
  std::size_t add(std::span<const std::int32_t> values) { return addBytes("i32", values); }
  std::size_t add(std::span<const std::uint16_t> values) { return addBytes("u16", values); }
  std::size_t add(std::span<const std::uint8_t> values) { return addBytes("u8", values); }

  /// The script elements, <script type="text/plain" id="array-0" data-type="f64" data-count="158">…
  const std::string& html() const { return html_; }
  std::size_t count() const { return count_; }

 private:
  template <class T>
  std::size_t addBytes(const char* type, std::span<const T> values) {
    return addBytes(type, reinterpret_cast<const char*>(values.data()), values.size(), sizeof(T));
  }
  std::size_t addBytes(const char* type, const char* bytes, std::size_t count, std::size_t size);

  std::string html_;
  std::size_t count_ = 0;
};

}  // namespace ringwatch

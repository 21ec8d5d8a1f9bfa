#include <ringwatch/app/report/page_data.h>

#include <zlib.h>

#include <bit>
#include <new>

#include <fmt/format.h>

#include <ringwatch/base/markup.h>

namespace ringwatch {

static_assert(std::endian::native == std::endian::little, "browsers read typed arrays in the order of their machine");

std::string htmlText(std::string_view text) {
  std::string shown(text);
  std::erase_if(shown, [](char c) { return static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t'; });
  return markupText(shown);
}

std::string scriptJson(const nlohmann::ordered_json& value) {
  const std::string text = value.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  std::string result;
  result.reserve(text.size());
  for (const char c : text) {
    if (c == '<')
      result += "\\u003c";
    else
      result += c;
  }
  return result;
}

std::string base64(std::string_view bytes) {
  constexpr char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  result.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) -> std::uint32_t {
      return i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U;
    };
    const std::uint32_t group = byte(0) << 16 | byte(1) << 8 | byte(2);
    result += letters[group >> 18];
    result += letters[group >> 12 & 63];
    result += i + 1 < bytes.size() ? letters[group >> 6 & 63] : '=';
    result += i + 2 < bytes.size() ? letters[group & 63] : '=';
  }
  return result;
}

std::string deflated(std::string_view bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string packed(size, '\0');
  // Level 6 packs the planes of coordinates 2 % better and takes three times as long.
  constexpr int level = 2;
  if (compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                static_cast<uLong>(bytes.size()), level) != Z_OK)
    throw std::bad_alloc();
  packed.resize(size);
  return packed;
}

std::size_t PageData::addBytes(const char* type, const char* bytes, std::size_t count, std::size_t size) {
  std::string planes(count * size, '\0');
  for (std::size_t b = 0; b < size; ++b)
    for (std::size_t i = 0; i < count; ++i) planes[b * count + i] = bytes[i * size + b];
  html_ += fmt::format("<script type=\"text/plain\" id=\"array-{}\" data-type=\"{}\" data-count=\"{}\">{}</script>\n",
                       count_, type, count, base64(deflated(planes)));
  return count_++;
}

}  // namespace ringwatch

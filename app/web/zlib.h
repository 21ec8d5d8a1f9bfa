#pragma once
// Stands in for zlib, which Debian has for the machine alone: what the report calls of it, by stb's headers.
#include <algorithm>
#include <cstdint>
#include <cstdlib>

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

using Bytef = std::uint8_t;
using uInt = std::uint32_t;
using uLong = std::uint32_t;
using uLongf = std::uint32_t;
constexpr int Z_OK = 0, Z_MEM_ERROR = -4;

/// stb's codes are fixed: a byte takes at most nine bits.
constexpr uLong compressBound(uLong size) { return size + size / 8 + 64; }

inline int compress2(Bytef* packed, uLongf* packedSize, const Bytef* bytes, uLong size, int level) {
  int count = 0;
  Bytef* const made = stbi_zlib_compress(const_cast<Bytef*>(bytes), static_cast<int>(size), &count, level);
  if (made == nullptr) return Z_MEM_ERROR;
  std::copy_n(made, count, packed);
  std::free(made);
  *packedSize = static_cast<uLongf>(count);
  return Z_OK;
}

/// Of all bytes at once.
inline uLong crc32(uLong /*before*/, const Bytef* bytes, uInt size) {
  return stbiw__crc32(const_cast<Bytef*>(bytes), static_cast<int>(size));
}

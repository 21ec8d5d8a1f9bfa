#pragma once
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>

#include <ringwatch/base/error.h>

namespace ringwatch {

/// The bytes of a file, a pipe or a device, at most so many. Throws InputError "PATH: cannot read: REASON" and the hint
/// behind it where it cannot be opened or read to there: a stream of the standard library ends in silence at an error.
inline std::string readBytes(const std::filesystem::path& path, std::string_view hint = {},
                             std::size_t most = std::numeric_limits<std::size_t>::max()) {
  std::size_t part = std::size_t{1} << 20;
  const auto repeated = [](const auto& call) {
    for (;;)
      if (const auto result = call(); result >= 0 || errno != EINTR) return result;
  };
  const int file = static_cast<int>(repeated([&] { return ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY); }));
  struct Closed {
    int file;
    ~Closed() {
      if (file >= 0) ::close(file);
    }
  } const closed{file};
  std::string bytes;
  ssize_t count = file;
  if (const off_t size = file < 0 ? 0 : ::lseek(file, 0, SEEK_END); size > 0 && ::lseek(file, 0, SEEK_SET) == 0) {
    part = std::min(part, static_cast<std::size_t>(size) + 1);  // the end is seen behind it
    bytes.reserve(std::min(most, static_cast<std::size_t>(size) + part));
  }
  if (file >= 0) do {
      const std::size_t before = bytes.size();
      bytes.resize(before + std::min(part, most - before));
      count = repeated([&] { return ::read(file, bytes.data() + before, bytes.size() - before); });
      const int reason = errno;
      bytes.resize(before + static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
      errno = reason;
    } while (count > 0 && bytes.size() < most);
  if (count < 0) throw InputError(joinText(path.string(), ": cannot read: ", std::strerror(errno), hint));
  return bytes;
}

}  // namespace ringwatch

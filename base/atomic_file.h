#pragma once
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <string_view>
#include <system_error>

#include <ringwatch/base/error.h>

namespace ringwatch {

/// Lets `write` fill a temporary file in the folder of `path` and renames it to `path`: a reader sees the old file or
/// the whole new one, never half of one. On failure the temporary is removed and `path` is left as it was.
/// Throws InputError "cannot write PATH: reason"; an InputError of `write` itself passes unchanged.
inline void writeFileAtomically(const std::filesystem::path& path,
                                const std::function<void(const std::filesystem::path& temporary)>& write) {
  static std::atomic<unsigned> counter{0};  // two threads may write the same path
  std::filesystem::path temporary = path;
  temporary += joinText(".part-", ::getpid(), "-", counter++);
  std::error_code error;
  const auto discard = [&] {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
  };
  const std::string failure = "cannot write " + path.string() + ": ";
  std::filesystem::path folder = path.parent_path();
  if (folder.empty()) folder = ".";
  if (path.filename().empty()) throw InputError(failure + "this is a folder, a file name is needed");
  if (!std::filesystem::exists(folder, error)) throw InputError(failure + "there is no folder " + folder.string());
  if (!std::filesystem::is_directory(folder, error)) throw InputError(failure + folder.string() + " is not a folder");
  if (std::filesystem::is_directory(path, error)) throw InputError(failure + "a folder of that name is in the way");
  try {
    write(temporary);
  } catch (const InputError&) {
    discard();
    throw;
  } catch (const std::exception& reason) {
    discard();
    throw InputError(failure + reason.what());
  } catch (...) {
    discard();
    throw;
  }
  std::filesystem::rename(temporary, path, error);
  if (error) {
    discard();
    throw InputError(failure + error.message());
  }
}

/// The same for a text or bytes at hand.
inline void writeFileAtomically(const std::filesystem::path& path, std::string_view content) {
  writeFileAtomically(path, [&](const std::filesystem::path& temporary) {
    errno = 0;
    std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
    file.write(content.data(), static_cast<std::streamsize>(content.size()));
    file.close();
    if (!file)
      throw InputError("cannot write " + path.string() + ": " +
                       (errno != 0 ? std::strerror(errno) : "input/output error"));
  });
}

}  // namespace ringwatch

#pragma once
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include <ringwatch/base/error.h>

namespace ringwatch {

/// A file that is written from front to back. Every failure is an InputError "cannot write NAME: reason", with the
/// system's reason.
class OutputFile {
 public:
  /// The mode of opening: an empty file, made when missing; what is there already, such as a device or a pipe; or the
  /// end of a file that is there.
  enum class Mode { empty, existing, append };

  /// name: of the file in messages.
  OutputFile(const std::filesystem::path& path, Mode mode, std::string name) : name_(std::move(name)) {
    const int flags = O_WRONLY | O_CLOEXEC | O_NOCTTY |
                      (mode == Mode::empty    ? O_CREAT | O_TRUNC
                       : mode == Mode::append ? O_APPEND
                                              : 0);
    do {
      descriptor_ = ::open(path.c_str(), flags, 0666);
    } while (descriptor_ < 0 && errno == EINTR);
    if (descriptor_ < 0) fail(errno);
    if (mode == Mode::append)
      written_ = static_cast<std::size_t>(std::max<off_t>(0, ::lseek(descriptor_, 0, SEEK_END)));
  }
  explicit OutputFile(const std::filesystem::path& path) : OutputFile(path, Mode::empty, path.string()) {}
  /// Closes in silence; close() says what went wrong.
  ~OutputFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Writes all bytes. When it cannot, none of them stay in the file, so that a file of whole lines remains one.
  void write(std::string_view bytes) {
    const int reason = writeAll(descriptor_, bytes, written_);
    if (reason == 0) return;
    if (::ftruncate(descriptor_, static_cast<off_t>(written_)) != 0) {  // not a regular file: nothing to take back
    }
    fail(reason);
  }
  /// Returns when what was written is on the disk, where a machine that fails leaves it.
  void sync() {
    if (const int reason = synced(descriptor_); reason != 0) fail(reason);
  }
  /// The same of an open descriptor; the error number, 0 for none. What cannot be synced, as a pipe, needs no sync.
  static int synced(int descriptor) {
    while (::fsync(descriptor) != 0)
      if (errno != EINTR) return errno == EINVAL || errno == EROFS || errno == ENOTSUP ? 0 : errno;
    return 0;
  }
  /// Bytes in the file.
  std::size_t size() const { return written_; }
  void close() {
    if (descriptor_ < 0) return;
    const int descriptor = std::exchange(descriptor_, -1);
    if (::close(descriptor) != 0 && errno != EINTR) fail(errno);
  }

  /// Writes to an open descriptor; `written` grows by the size of the bytes when all of them went. The error number, 0
  /// for none.
  static int writeAll(int descriptor, std::string_view bytes, std::size_t& written) {
    std::size_t done = 0;
    while (done < bytes.size()) {
      const ssize_t count =
          ::write(descriptor, bytes.data() + done, std::min<std::size_t>(bytes.size() - done, 1 << 30));
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return count < 0 ? errno : ENOSPC;
      done += static_cast<std::size_t>(count);
    }
    written += done;
    return 0;
  }

 private:
  [[noreturn]] void fail(int reason) const { throw InputError("cannot write " + name_ + ": " + std::strerror(reason)); }

  std::string name_;
  int descriptor_ = -1;
  std::size_t written_ = 0;
};

}  // namespace ringwatch

#pragma once
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <ringwatch/base/error.h>
#include <ringwatch/base/leftovers.h>
#include <ringwatch/base/output_file.h>
#include <ringwatch/base/scratch_folder.h>

namespace ringwatch {
namespace detail {

/// Where symbolic links lead, the last of which may lead to a file that is not there yet.
inline std::filesystem::path throughLinks(const std::filesystem::path& path) {
  std::filesystem::path end = path;
  std::error_code error;
  for (int links = 0; std::filesystem::is_symlink(end, error); ++links) {
    const std::filesystem::path target = std::filesystem::read_symlink(end, error);
    if (error || links == 40)
      throw InputError("cannot write " + path.string() + ": " + std::strerror(error ? error.value() : ELOOP));
    end = target.is_absolute() ? target : end.parent_path() / target;
  }
  return end;
}

/// STDOUT_FILENO or STDERR_FILENO where the path is another name of it (/dev/stdout), nothing else.
inline std::optional<int> standardStreamAt(const std::filesystem::path& path) {
  struct stat file {};
  if (::stat(path.c_str(), &file) != 0) return {};
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
    struct stat own {};
    if (::fstat(stream, &own) == 0 && own.st_dev == file.st_dev && own.st_ino == file.st_ino) return stream;
  }
  return {};
}

/// A device, a pipe or this program's own output: it cannot be replaced, only written to.
inline bool isWrittenThrough(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status) || std::filesystem::is_directory(status)) return false;
  return !std::filesystem::is_regular_file(status) || standardStreamAt(path);
}

/// Appends bytes to what isWrittenThrough.
class ThroughFile {
 public:
  explicit ThroughFile(const std::filesystem::path& path) : path_(path), stream_(standardStreamAt(path)) {
    std::fflush(nullptr);  // what was printed before comes first
    if (!stream_) file_.emplace(path, OutputFile::Mode::existing, path.string());
  }
  void write(std::string_view bytes) {
    if (file_) return file_->write(bytes);
    std::size_t written = 0;
    if (const int reason = OutputFile::writeAll(*stream_, bytes, written); reason != 0)
      throw InputError("cannot write " + path_.string() + ": " + std::strerror(reason));
  }
  void close() {
    if (file_) file_->close();
  }

 private:
  std::filesystem::path path_;
  std::optional<int> stream_;
  std::optional<OutputFile> file_;
};

}  // namespace detail

/// What a written file outlives: the end of this program, or that of the machine too, which takes the time that a disk
/// needs.
enum class Outlives { program, machine };

/// Lets `write` fill a temporary file in the folder of `path` and renames it to `path`: a reader sees the old file or
/// the whole new one, never half of one. On failure, and where removeLeftoversOnSignals() was called on a signal that
/// ends the program, the temporary is removed and `path` is left as it was. Symbolic
/// links stay, and the file they lead to is replaced. What is no regular file, such as a device or a pipe, and this
/// program's own output stay as well: they get the bytes.
/// Throws InputError "cannot write PATH: reason"; an InputError of `write` itself passes unchanged.
inline void writeFileAtomically(const std::filesystem::path& path,
                                const std::function<void(const std::filesystem::path& temporary)>& write,
                                Outlives outlives = Outlives::program) {
  const std::string failure = "cannot write " + path.string() + ": ";
  const auto fill = [&](const std::filesystem::path& temporary) {
    try {
      write(temporary);
    } catch (const InputError&) {
      throw;
    } catch (const std::exception& reason) {
      throw InputError(failure + reason.what());
    }
  };
  if (detail::isWrittenThrough(path)) {
    const ScratchFolder scratch;
    const std::filesystem::path copy = scratch.path() / "file";
    fill(copy);
    std::ifstream content(copy, std::ios::binary);
    detail::ThroughFile file(path);
    std::vector<char> part(1 << 20);
    while (content.read(part.data(), static_cast<std::streamsize>(part.size())) || content.gcount() > 0)
      file.write({part.data(), static_cast<std::size_t>(content.gcount())});
    return file.close();
  }

  const std::filesystem::path target = detail::throughLinks(path);
  static std::atomic<unsigned> counter{0};  // two threads may write the same path
  std::filesystem::path temporary = target;
  temporary += joinText(".part-", ::getpid(), "-", counter++);
  std::error_code error;
  std::filesystem::path folder = target.parent_path();
  if (folder.empty()) folder = ".";
  if (target.filename().empty()) throw InputError(failure + "this is a folder, a file name is needed");
  if (!std::filesystem::exists(folder, error)) throw InputError(failure + "there is no folder " + folder.string());
  if (!std::filesystem::is_directory(folder, error)) throw InputError(failure + folder.string() + " is not a folder");
  if (std::filesystem::is_directory(target, error)) throw InputError(failure + "a folder of that name is in the way");
  const Leftover unfinished(temporary);
  try {
    fill(temporary);
    const auto sync = [&](const std::filesystem::path& what) {
      if (outlives == Outlives::program) return;
      const int descriptor = ::open(what.c_str(), O_RDONLY | O_CLOEXEC);
      const int reason = descriptor < 0 ? errno : OutputFile::synced(descriptor);
      if (descriptor >= 0) ::close(descriptor);
      if (reason != 0) throw InputError(failure + std::strerror(reason));
    };
    sync(temporary);
    std::filesystem::rename(temporary, target, error);
    if (error) throw InputError(failure + error.message());
    sync(folder);
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    throw;
  }
}

/// Replaces a file, as above, by a text or bytes at hand.
inline void writeFileAtomically(const std::filesystem::path& path, std::string_view content,
                                Outlives outlives = Outlives::program) {
  if (detail::isWrittenThrough(path)) {
    detail::ThroughFile file(path);
    file.write(content);
    return file.close();
  }
  const auto write = [&](const std::filesystem::path& temporary) {
    OutputFile file(temporary, OutputFile::Mode::empty, path.string());
    file.write(content);
    file.close();
  };
  writeFileAtomically(path, write, outlives);
}

}  // namespace ringwatch

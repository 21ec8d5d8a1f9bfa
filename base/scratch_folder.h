#pragma once
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>

#include <ringwatch/base/error.h>
#include <ringwatch/base/leftovers.h>

namespace ringwatch {

/// A folder of its own among the temporary ones, which goes away with everything in it, also where
/// removeLeftoversOnSignals() was called on a signal that ends the program. Throws InputError where none can be made.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::error_code error;
    std::string folder = (std::filesystem::temp_directory_path(error) / "ringwatch-XXXXXX").string();
    if (error || ::mkdtemp(folder.data()) == nullptr)
      throw InputError("cannot write a temporary file into " + folder + ": " + std::strerror(errno));
    path_ = folder;
    leftover_.emplace(path_);
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  std::optional<Leftover> leftover_;
};

}  // namespace ringwatch

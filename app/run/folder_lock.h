#pragma once
#include <filesystem>

namespace ringwatch {

/// Holds a folder for one run: another one that wants the same folder is refused. The lock (flock on the file run.lock,
/// which holds the number of the process) ends with the process, however that ends.
class FolderLock {
 public:
  /// Makes the folder when it is missing. Throws InputError when it cannot be written, or is held by another process.
  explicit FolderLock(const std::filesystem::path& folder);
  /// Removes the lock file, and the folder where it was made here and stayed empty.
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  bool lock(const std::filesystem::path& folder);  // false: the file lost its name in the meantime, try again
  void giveUp();

  std::filesystem::path file_;
  bool madeFolder_ = false;
  int descriptor_ = -1;
};

}  // namespace ringwatch

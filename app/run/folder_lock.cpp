#include <ringwatch/app/run/folder_lock.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>

#include <fmt/format.h>

#include <ringwatch/base/error.h>
#include <ringwatch/base/output_file.h>

namespace ringwatch {
namespace {

[[noreturn]] void cannotWrite(const std::filesystem::path& folder, const std::string& reason) {
  throw InputError(fmt::format("{}: cannot write: {}; choose another folder with --out", folder.string(), reason));
}

/// Whether the name still belongs to the open file: who ends removes it.
bool isCurrent(int descriptor, const std::filesystem::path& file) {
  struct stat open {
  }, named{};
  return ::fstat(descriptor, &open) == 0 && ::stat(file.c_str(), &named) == 0 && open.st_dev == named.st_dev &&
         open.st_ino == named.st_ino;
}

std::string holderOf(int descriptor) {
  char text[32] = "";
  const ssize_t count = ::pread(descriptor, text, sizeof text - 1, 0);
  const long process = count > 0 ? std::strtol(text, nullptr, 10) : 0;
  return process > 0 ? fmt::format("process {}", process) : "another process";
}

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder) : file_(folder / "run.lock") {
  std::error_code error;
  madeFolder_ = std::filesystem::create_directories(folder, error);
  if (!error && !std::filesystem::is_directory(folder)) error = std::make_error_code(std::errc::not_a_directory);
  if (error) cannotWrite(folder, error.message());
  while (!lock(folder)) {
  }
}

bool FolderLock::lock(const std::filesystem::path& folder) {
  const int descriptor = ::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
  if (descriptor < 0) cannotWrite(folder, std::strerror(errno));
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {  // other errors: no locks are to be had
    const std::string holder = holderOf(descriptor);
    ::close(descriptor);
    throw InputError(fmt::format(
        "{}: a run of {} is writing into this folder; wait for its end, or choose another folder with --out",
        folder.string(), holder));
  }
  if (!isCurrent(descriptor, file_)) {
    ::close(descriptor);
    return false;
  }
  descriptor_ = descriptor;
  std::size_t written = 0;
  int reason = ::ftruncate(descriptor, 0) != 0 ? errno : 0;
  if (reason == 0) reason = OutputFile::writeAll(descriptor, fmt::format("{}\n", ::getpid()), written);
  if (reason != 0) {
    giveUp();
    cannotWrite(folder, std::strerror(reason));
  }
  return true;
}

FolderLock::~FolderLock() { giveUp(); }

void FolderLock::giveUp() {
  ::unlink(file_.c_str());  // before it is closed, so that who opens it next sees that it is no longer current
  ::close(descriptor_);
  std::error_code notEmpty;
  if (madeFolder_) std::filesystem::remove(file_.parent_path(), notEmpty);
}

}  // namespace ringwatch

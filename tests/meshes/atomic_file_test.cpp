#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <functional>

#include <ringwatch/base/atomic_file.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/leftovers.h>
#include <ringwatch/base/nearest_name.h>
#include <ringwatch/base/scratch_folder.h>
#include <ringwatch/base/subprocess.h>

#include "tests/meshes/mesh_test_tools.h"

namespace {
/// What was synced, and whether the file `watched` was there then.
std::vector<std::pair<std::filesystem::path, bool>> synced;
std::filesystem::path watched;
int failWith = 0;
}  // namespace
/// In place of the system's.
extern "C" int fsync(int descriptor) {
  synced.emplace_back(std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(descriptor)),
                      std::filesystem::exists(watched));
  errno = failWith;
  return failWith != 0 ? -1 : static_cast<int>(::syscall(SYS_fsync, descriptor));
}

namespace ringwatch {
namespace {

using namespace test;

TEST(AtomicFile, WritesAndReplacesWholeFiles) {
  const TemporaryFolder folder;
  writeFileAtomically(folder / "a.txt", "one");
  writeFileAtomically(folder / "a.txt", "two");
  EXPECT_EQ(readBytes(folder / "a.txt"), "two");
  EXPECT_EQ(folder.fileCount(), 1u);
}

TEST(AtomicFile, AFailureLeavesTheOldFileAndNothingElse) {
  const TemporaryFolder folder;
  writeFileAtomically(folder / "a.txt", "old");
  const std::string text = errorOf([&] {
    writeFileAtomically(folder / "a.txt", [](const std::filesystem::path& temporary) {
      writeBytes(temporary, "half");
      throw std::runtime_error("the disk is full");
    });
  });
  EXPECT_EQ(text, "cannot write " + (folder / "a.txt").string() + ": the disk is full");
  EXPECT_EQ(readBytes(folder / "a.txt"), "old");
  EXPECT_EQ(folder.fileCount(), 1u);
}

TEST(AtomicFile, IsOnTheDiskBeforeItHasItsNameAndItsNameIsThereAtTheEnd) {
  const TemporaryFolder folder;
  synced.clear();
  watched = folder / "a.txt";
  writeFileAtomically(watched, "one", Outlives::machine);
  ASSERT_EQ(synced.size(), 2u);
  EXPECT_TRUE(synced[0].first.string().starts_with(watched.string() + ".part-")) << synced[0].first;
  EXPECT_FALSE(synced[0].second);
  EXPECT_EQ(synced[1], std::pair(watched.parent_path(), true));
  failWith = ENOSPC;
  EXPECT_EQ(errorOf([&] { writeFileAtomically(watched, "two", Outlives::machine); }),
            "cannot write " + watched.string() + ": No space left on device");
  failWith = 0;
  EXPECT_EQ(readBytes(watched), "one");
  EXPECT_EQ(folder.fileCount(), 1u);
  synced.clear();
  writeFileAtomically(watched, "three");
  EXPECT_TRUE(synced.empty());
}

/// Expects that this signal ends the program that does this work.
void expectEndedBy(int number, const std::function<void()>& work) {
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(number, SIG_DFL);
    removeLeftoversOnSignals();
    work();
    ::_exit(0);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(WTERMSIG(status), number);
}

// What a signal ends while it writes leaves no half of a file behind.
TEST(AtomicFile, LeavesNothingWhereASignalEndsTheProgram) {
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    const TemporaryFolder folder;
    writeBytes(folder / "a.txt", "old");
    expectEndedBy(number, [&] {
      writeFileAtomically(folder / "a.txt", [&](const std::filesystem::path& temporary) {
        writeBytes(temporary, "half");
        std::raise(number);
      });
    });
    EXPECT_EQ(folder.fileCount(), 1u);
    EXPECT_EQ(readBytes(folder / "a.txt"), "old");
  }
}

/// The same of temporary folders, with all in them, and of programs that write into them.
TEST(AtomicFile, LeavesNoTemporaryFolderWhereASignalEndsTheProgram) {
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    const TemporaryFolder folder;
    expectEndedBy(number, [&] {
      ::setenv("TMPDIR", folder.path().c_str(), 1);
      const ScratchFolder scratch;
      std::filesystem::create_directories(scratch.path() / "sub/sub");
      for (int i = 0; i < 300; ++i) writeBytes(scratch.path() / "sub" / std::to_string(i), "a part");
      writeBytes(scratch.path() / "sub/sub/file", "a part");
      std::filesystem::create_directory_symlink(folder.path(), scratch.path() / "sub/link");
      const std::string writes = joinText("i=0; while :; do echo a > sub/w$i; i=$((i+1)); [ $i = 50 ] && kill -",
                                          std::to_string(number), " $PPID; done");
      runProgram({"/bin/sh", "-c", writes}, scratch.path());
    });
    EXPECT_EQ(folder.fileCount(), 0u);
  }
}

TEST(AtomicFile, NamesWhatIsInTheWay) {
  const TemporaryFolder folder;
  writeBytes(folder / "file", "");
  std::filesystem::create_directory(folder / "sub");
  EXPECT_NE(errorOf([&] { writeFileAtomically(folder / "none" / "a", ""); }).find("there is no folder"),
            std::string::npos);
  EXPECT_NE(errorOf([&] { writeFileAtomically(folder / "file" / "a", ""); }).find("is not a folder"),
            std::string::npos);
  EXPECT_NE(errorOf([&] { writeFileAtomically(folder / "sub", ""); }).find("in the way"), std::string::npos);
}

TEST(AtomicFile, FollowsLinks) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "sub");
  std::filesystem::create_symlink("sub/file", folder / "link");
  for (const char* text : {"one", "two"}) {
    writeFileAtomically(folder / "link", text);
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
    EXPECT_EQ(readBytes(folder / "sub/file"), text);
  }
  writeFileAtomically(folder / "link", [](const std::filesystem::path& temporary) { writeBytes(temporary, "three"); });
  EXPECT_EQ(readBytes(folder / "sub/file"), "three");
  std::filesystem::create_symlink("none/file", folder / "lost");
  EXPECT_NE(errorOf([&] { writeFileAtomically(folder / "lost", ""); }).find("there is no folder"), std::string::npos);
}

TEST(NearestName, CountsEdits) {
  EXPECT_EQ(editDistance("", "abc"), 3u);
  EXPECT_EQ(editDistance("kitten", "sitting"), 3u);
  EXPECT_EQ(editDistance("poisson", "posison"), 1u);  // a swap of neighbours
  const std::vector<std::string_view> names{"size", "cells", "seed"};
  EXPECT_EQ(nearestName("cell", names), "cells");
  EXPECT_EQ(nearestName("sede", names), "seed");
  EXPECT_EQ(nearestName("x", std::vector<std::string>{}), "");
  EXPECT_EQ(nearestName("clamp", std::vector<std::string>{"x-max", "x-min"}), "");
}

}  // namespace
}  // namespace ringwatch

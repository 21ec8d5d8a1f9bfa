#pragma once
#include <chrono>
#include <filesystem>
#include <string>

#include <ringwatch/base/output_file.h>

namespace ringwatch {

/// A table that grows as a run goes: whole rows only, four times a second or at every row when those are slower, so
/// that however the run ends, its rows are there. A run that is killed (SIGKILL) while it writes may cut the last row.
class RowFile {
 public:
  /// Begins the file again with a first row. Throws InputError when it cannot be written.
  RowFile(const std::filesystem::path& path, const std::string& heading);
  /// Goes on behind the first `bytes` of the file; what is behind them is dropped. Throws InputError when there are
  /// fewer.
  RowFile(const std::filesystem::path& path, std::size_t bytes);
  /// Writes what is left, in silence.
  /// Throws InputError where a file has not so many bytes.
  static void requireBytes(const std::filesystem::path& file, std::size_t bytes);
  ~RowFile();
  RowFile(const RowFile&) = delete;
  RowFile& operator=(const RowFile&) = delete;

  /// A row without its line end. Throws InputError when the disk is full.
  void write(const std::string& row);
  /// Writes what is left; the bytes of the file then.
  std::size_t bytes();
  /// The same onto the disk, where a machine that fails leaves it.
  void sync();
  void finish();

 private:
  void flush();

  OutputFile file_;
  std::string rows_;  // not yet in the file
  std::chrono::steady_clock::time_point flushed_;
};

}  // namespace ringwatch

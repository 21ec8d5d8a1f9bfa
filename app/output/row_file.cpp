#include <ringwatch/app/output/row_file.h>

#include <utility>

#include <fmt/format.h>

#include <ringwatch/base/error.h>

namespace ringwatch {
namespace {

/// The file as it was after its first `bytes`.
std::filesystem::path cutBack(const std::filesystem::path& file, std::size_t bytes) {
  RowFile::requireBytes(file, bytes);
  std::error_code error;
  std::filesystem::resize_file(file, bytes, error);
  if (error) throw InputError(fmt::format("cannot write {}: {}", file.string(), error.message()));
  return file;
}

}  // namespace

RowFile::RowFile(const std::filesystem::path& path, const std::string& heading)
    : file_(path), flushed_(std::chrono::steady_clock::now()) {
  file_.write(heading + '\n');
}

RowFile::RowFile(const std::filesystem::path& path, std::size_t bytes)
    : file_(cutBack(path, bytes), OutputFile::Mode::append, path.string()),
      flushed_(std::chrono::steady_clock::now()) {}

void RowFile::requireBytes(const std::filesystem::path& file, std::size_t bytes) {
  std::error_code error;
  const auto size = std::filesystem::file_size(file, error);
  if (error || size < bytes)
    throw InputError(fmt::format("{}: {}; the checkpoint needs its first {} bytes, begin the run again", file.string(),
                                 error ? error.message() : fmt::format("has {} bytes", size), bytes));
}

RowFile::~RowFile() {
  try {
    flush();
  } catch (const InputError&) {  // a run that ends by an error has another one to tell
  }
}

void RowFile::flush() {
  if (rows_.empty()) return;
  const std::string rows = std::exchange(rows_, {});
  file_.write(rows);
}

void RowFile::write(const std::string& row) {
  rows_ += row + '\n';
  const auto now = std::chrono::steady_clock::now();
  if (now - flushed_ < std::chrono::milliseconds(250)) return;
  flush();
  flushed_ = now;
}

std::size_t RowFile::bytes() {
  flush();
  return file_.size();
}

void RowFile::sync() {
  flush();
  file_.sync();
}

void RowFile::finish() {
  flush();
  file_.close();
}

}  // namespace ringwatch

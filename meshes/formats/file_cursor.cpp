#include <ringwatch/meshes/formats/file_cursor.h>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <limits>
#include <system_error>

#include <ringwatch/base/byte_order_mark.h>
#include <ringwatch/base/input_file.h>
#include <ringwatch/base/machine_memory.h>

namespace ringwatch::detail {
namespace {

constexpr std::size_t mostPipedBytes = std::size_t{4} << 30;

/// Throws InputError for what is no file.
std::filesystem::file_status statusOfFile(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw InputError(path.string() + ": cannot read: there is no such file");
  if (std::filesystem::is_directory(status))
    throw InputError(path.string() + ": cannot read: this is a folder, a mesh file is needed");
  return status;
}

/// Takes the byte order mark away, and line ends that are CR alone for those that they stand for.
void takeBegin(std::string& text) {
  text.erase(0, byteOrderMarkOf(text));
  if (text.find_first_of(std::string_view("\n\0", 2)) == std::string::npos) std::ranges::replace(text, '\r', '\n');
}

}  // namespace

MappedFile::MappedFile(const std::filesystem::path& path) {
  const std::string name = path.string();
  if (!std::filesystem::is_regular_file(statusOfFile(path)))
    throw InputError(name + ": cannot read: this is no regular file, a mesh file is needed");
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const off_t size = file < 0 ? -1 : ::lseek(file, 0, SEEK_END);
  void* data = size > 0 ? ::mmap(nullptr, static_cast<std::size_t>(size), PROT_READ, MAP_PRIVATE, file, 0) : nullptr;
  const int fault = size < 0 || data == MAP_FAILED ? errno : 0;
  if (file >= 0) ::close(file);  // the mapping stays
  if (fault != 0) throw InputError(name + ": cannot read: " + std::strerror(fault));
  if (size == 0) throw InputError(name + ": the file is empty");
  data_ = static_cast<const char*>(data);
  size_ = static_cast<std::size_t>(size);
}

MappedFile::~MappedFile() { ::munmap(const_cast<char*>(data_), size_); }

void requireContent(const std::filesystem::path& path, const std::string& text) {
  const std::string name = path.string();
  if (text.find_first_not_of(" \t\n") == std::string::npos) throw InputError(name + ": the file is empty");
  if (text.starts_with("version https://git-lfs.github.com/"))
    throw InputError(name + ": this is a pointer of Git LFS, not the file itself; git lfs pull brings it");
  for (const std::string_view mark : {"\xFF\xFE", "\xFE\xFF"})
    if (text.starts_with(mark)) throw InputError(name + ": this is a text in UTF-16; save it as UTF-8");
  for (const std::string_view packed : {"\x1f\x8b", "PK\x03\x04", "BZh9", "\3757zXZ", "7z\xbc\xaf", "\x28\xb5\x2f\xfd"})
    if (text.starts_with(packed)) throw InputError(name + ": this is a packed file; unpack it");
}

std::string readWholeFile(const std::filesystem::path& path) {
  std::error_code error;
  const std::string name = path.string();
  const std::filesystem::file_status status = statusOfFile(path);
  const bool pipe = std::filesystem::is_fifo(status);
  if (!pipe && !std::filesystem::is_regular_file(status))
    throw InputError(name + ": cannot read: this is a device or a socket, a mesh file is needed");
  if (!pipe) {
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (error) throw InputError(name + ": cannot read: " + error.message());
    if (size > machineMemory())
      throw InputError(joinText(name, ": cannot read: the file has ", size, " bytes, more than the memory of this ",
                                "machine, ", machineMemory()));
  }
  std::string text = pipe ? readBytes(path, {}, mostPipedBytes + 1) : readBytes(path);
  if (pipe && text.size() > mostPipedBytes)
    throw InputError(joinText(name, ": cannot read: more than ", mostPipedBytes >> 30,
                              " GiB come through the pipe; put the mesh into a file"));
  takeBegin(text);
  requireContent(path, text);
  return text;
}

std::string beginOfFile(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return {};
  std::string begin = readBytes(path, {}, std::size_t{64} << 10);
  takeBegin(begin);
  return begin;
}

std::string_view behindProlog(std::string_view text) {
  for (;;) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    const std::string_view end = text.starts_with("<!--")                                    ? "-->"
                                 : text.starts_with("<?")                                    ? "?>"
                                 : text.starts_with("<!") && text.find('[') < text.find('>') ? "]>"
                                 : text.starts_with("<!")                                    ? ">"
                                                                                             : "";
    const std::size_t close = end.empty() ? std::string_view::npos : text.find(end);
    if (close == std::string_view::npos) return text;
    text.remove_prefix(close + end.size());
  }
}

std::string inUpperCase(std::string_view word) {
  std::string text(word);
  for (char& c : text) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return text;
}

std::string quoted(std::string_view word) {
  std::string text = "\"";
  for (const char c : word.substr(0, 40)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + (word.size() > 40 ? "…\"" : "\"");
}

std::string FileCursor::where(std::size_t position) const {
  if (binary) return joinText(source_, ": byte ", position);
  const std::size_t end = std::min(position, text_.size());
  if (end < countedTo_) countedTo_ = lineEnds_ = 0;
  const std::string_view on = text_.substr(countedTo_, end - countedTo_);
  lineEnds_ += static_cast<std::size_t>(std::count(on.begin(), on.end(), '\n'));
  countedTo_ = end;
  return joinText(source_, ":", 1 + lineEnds_);
}

std::string_view FileCursor::line(std::string_view what) {
  if (!skipSpace()) fail(joinText("the file ends where ", what, " is expected; is it cut short?"));
  const std::size_t begin = position_;
  skipComment();  // to the end of the line
  std::string_view found = text_.substr(begin, position_ - begin);
  if (position_ < text_.size()) ++position_;
  while (!found.empty() && isSpace(found.back())) found.remove_suffix(1);
  return found;
}

void FileCursor::expectLine(std::string_view expected) {
  if (!skipSpace()) fail(joinText("the file ends where ", expected, " is expected; is it cut short?"));
  const std::size_t begin = position_;
  const std::string_view found = line(expected);
  if (found != expected) failAt(begin, joinText("found ", quoted(found), " where ", expected, " is expected"));
}

std::size_t FileCursor::checkedCount(std::int64_t value, std::size_t bytesEach, std::string_view what,
                                     std::size_t at) const {
  if (value < 0) failAt(at, joinText("the number of ", what, " is ", value, "; it must be 0 or more"));
  if (static_cast<std::uint64_t>(value) > remaining() / bytesEach)
    failAt(at, joinText("the number of ", what, " is ", value, ", more than the ", remaining(),
                        " bytes that follow can hold; is the file cut short?"));
  return static_cast<std::size_t>(value);
}

void FileCursor::failMissing(std::string_view what) const {
  fail(joinText(position_ == text_.size() ? "the file ends where " : "the line ends where ", what, " is expected"));
}

void FileCursor::failNumber(std::string_view what, std::string_view kind) {
  const std::size_t begin = position_;
  const std::string found = quoted(word(what));
  failAt(begin, joinText(what, " is ", found, "; it must be ", kind));
}

}  // namespace ringwatch::detail

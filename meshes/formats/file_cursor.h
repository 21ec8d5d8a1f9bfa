#pragma once
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>

#include <ringwatch/base/error.h>
#include <ringwatch/base/number_format.h>

namespace ringwatch::detail {

/// Throws InputError for a file that is empty, in UTF-16, or stands for another one: a pointer of Git LFS, a packed
/// file.
void requireContent(const std::filesystem::path& path, const std::string& text);
/// The bytes of a file or of a pipe. Throws InputError when it is missing, something else such as a folder or a device,
/// larger than the machine's memory (through a pipe: than 4 GiB), or cannot be read, and as requireContent does. A byte
/// order mark is left out, and line ends that are CR alone are LF.
std::string readWholeFile(const std::filesystem::path& path);
/// The first bytes of a regular file, enough for the comments before what tells its format, without byte order mark; ""
/// for none that can be read.
std::string beginOfFile(const std::filesystem::path& path);

/// What follows the declaration, comments and type of a document of XML: its first tag. Another text without the blanks
/// at its begin.
std::string_view behindProlog(std::string_view text);

/// Throws InputError for the text of a mesh in a format that is known but not read, and names it.
void refuseForeign(const std::filesystem::path& path, std::string_view text);
/// The same where states are wanted, by the extension too: none of these formats has states that are read.
void refuseForeignStates(const std::filesystem::path& path, std::string_view text);

/// The bytes of a regular file where they are: what is not looked at is not read. Throws InputError as readWholeFile
/// does; a file that another program cuts short meanwhile ends this one.
class MappedFile {
 public:
  explicit MappedFile(const std::filesystem::path& path);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;
  std::string_view bytes() const { return {data_, size_}; }

 private:
  const char* data_ = nullptr;
  std::size_t size_ = 0;
};

/// The word in quotes for an error message: unprintable bytes as '?', cut after 40 characters, so that it stays one
/// line.
std::string quoted(std::string_view word);

/// With A to Z in place of a to z; other bytes stay.
std::string inUpperCase(std::string_view word);

/// The raw number at a position of bytes, which hold it; swapBytes: it comes from a machine of the other byte order.
template <class T>
T rawAt(std::string_view bytes, std::size_t position, bool swapBytes) {
  char raw[sizeof(T)];
  std::memcpy(raw, bytes.data() + position, sizeof(T));
  if (swapBytes) std::reverse(raw, raw + sizeof(T));
  T value;
  std::memcpy(&value, raw, sizeof(T));
  return value;
}

/// Reads the bytes of a mesh file: words and numbers of lines, or raw values. Every failure is an InputError that
/// begins with the file and the line (the byte in a binary file).
class FileCursor {
 public:
  FileCursor(std::string_view text, std::string source) : text_(text), source_(std::move(source)) {}

  bool binary = false;     // raw values between the section lines
  bool swapBytes = false;  // the file comes from a machine of the other byte order
  char comment = '\0';     // the rest of a line after it is skipped

  std::size_t position() const { return position_; }
  std::size_t remaining() const { return text_.size() - position_; }
  bool endsWithNewline() const { return !text_.empty() && text_.back() == '\n'; }

  /// "file:line" or "file: byte n" of a position. Lines are counted on from the position asked for before, so that
  /// ascending positions cost one pass over the file.
  std::string where(std::size_t position) const;
  [[noreturn]] void fail(const std::string& what) const { failAt(position_, what); }
  [[noreturn]] void failAt(std::size_t position, const std::string& what) const {
    throw InputError(where(position) + ": " + what);
  }

  /// Skips blanks and line ends (and comments). False at the end of the file.
  bool skipSpace() {
    for (; position_ < text_.size(); ++position_) {
      const char c = text_[position_];
      if (c == comment && comment != '\0') {
        skipComment();
        if (position_ == text_.size()) return false;
      } else if (c != ' ' && c != '\t' && c != '\n' && c != '\r') {
        return true;
      }
    }
    return false;
  }
  void skipOne() { ++position_; }
  /// Goes behind the next line end.
  void skipLine() {
    skipComment();
    if (position_ < text_.size()) ++position_;
  }
  bool startsWith(std::string_view expected) {
    if (!binary) skipSpace();
    return text_.substr(position_, expected.size()) == expected;
  }
  void seek(std::size_t position) { position_ = position; }
  /// Passes over so many things of raw values of 8 bytes.
  void skip(std::size_t count, std::size_t bytesEach, std::string_view what) {
    if (remaining() / bytesEach < count) {
      position_ += remaining() / sizeof(double) * sizeof(double);  // the value that is not whole
      fail(joinText("the file ends where ", what, " is expected"));
    }
    position_ += count * bytesEach;
  }
  /// Moves to the next place that holds the text; false, and to the end, when there is none.
  bool skipTo(std::string_view text) {
    position_ = std::min(text_.find(text, position_), text_.size());
    return position_ < text_.size();
  }
  /// The next line that is not empty, without its line end.
  std::string_view line(std::string_view what);
  /// The next line must be exactly this.
  void expectLine(std::string_view expected);
  /// The next word of the current line.
  std::string_view word(std::string_view what) {
    skipBlanks();
    const std::size_t begin = position_;
    while (position_ < text_.size() && !isSpace(text_[position_]) && (comment == '\0' || text_[position_] != comment))
      ++position_;
    if (begin == position_) failMissing(what);
    return text_.substr(begin, position_ - begin);
  }
  bool atLineEnd() {
    skipBlanks();
    return position_ == text_.size() || text_[position_] == '\n' || (comment != '\0' && text_[position_] == comment);
  }

  std::int64_t integerText(std::string_view what) {
    skipBlanks();
    const char* begin = text_.data() + position_;
    const char* end = text_.data() + text_.size();
    std::int64_t value = 0;
    const auto [stop, error] = std::from_chars(begin, end, value);
    if (error != std::errc() || !endsWord(stop)) failNumber(what, "an integer");
    position_ = static_cast<std::size_t>(stop - text_.data());
    return value;
  }
  double numberText(std::string_view what) {
    skipBlanks();
    const char* begin = text_.data() + position_;
    const char* end = text_.data() + text_.size();
    if (begin != end && *begin == '+') ++begin;
    double value = 0;
    const auto [stop, error] = std::from_chars(begin, end, value);
    if (error == std::errc::result_out_of_range && endsWord(stop)) {
      // from_chars does not tell a number too small, which is zero enough, from one too large.
      value = *readNumber(std::string_view(begin, static_cast<std::size_t>(stop - begin)));
      if (std::abs(value) > 1) failNumber(what, "a number that a double can hold");
    } else if (error != std::errc() || !endsWord(stop)) {
      failNumber(what, "a number");
    }
    position_ = static_cast<std::size_t>(stop - text_.data());
    return value;
  }
  template <class T>
  T raw(std::string_view what) {
    if (remaining() < sizeof(T)) fail(joinText("the file ends where ", what, " is expected"));
    const T value = rawAt<T>(text_, position_, swapBytes);
    position_ += sizeof(T);
    return value;
  }

  // A record is a line in a text file and nothing in a binary one; its fields are words or raw values.
  void beginRecord(std::string_view what) {
    if (!binary && !skipSpace()) fail(joinText("the file ends where ", what, " is expected; is it cut short?"));
  }
  void endRecord() {
    if (binary) return;
    if (!atLineEnd()) {
      const std::size_t begin = position_;
      const std::string extra = quoted(word("more"));
      failAt(begin, joinText("unexpected ", extra, " at the end of the line"));
    }
  }
  std::int64_t int32(std::string_view what) { return binary ? raw<std::int32_t>(what) : integerText(what); }
  std::int64_t int64(std::string_view what) { return binary ? raw<std::int64_t>(what) : integerText(what); }
  double real(std::string_view what) { return binary ? raw<double>(what) : numberText(what); }

  /// A count of things that take at least so many bytes each, so that no absurd count is ever allocated.
  std::size_t checkedCount(std::int64_t value, std::size_t bytesEach, std::string_view what, std::size_t at) const;

 private:
  static bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
  bool endsWord(const char* stop) const {
    return stop == text_.data() + text_.size() || isSpace(*stop) || (comment != '\0' && *stop == comment);
  }
  void skipBlanks() {
    while (position_ < text_.size() && isSpace(text_[position_]) && text_[position_] != '\n') ++position_;
  }
  void skipComment() {
    while (position_ < text_.size() && text_[position_] != '\n') ++position_;
  }
  [[noreturn]] void failMissing(std::string_view what) const;
  [[noreturn]] void failNumber(std::string_view what, std::string_view kind);

  std::string_view text_;
  std::string source_;
  std::size_t position_ = 0;
  mutable std::size_t countedTo_ = 0, lineEnds_ = 0;  // line ends before countedTo_
};

}  // namespace ringwatch::detail

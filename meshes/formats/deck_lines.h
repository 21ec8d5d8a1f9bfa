#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <ringwatch/meshes/formats/file_cursor.h>

namespace ringwatch::detail {

/// Whose decks: of Abaqus and CalculiX, or of LS-DYNA.
enum class DeckDialect { abaqus, dyna };

/// What stands between the name of a set and the type of its elements that a set of theirs is of, "ALL, TYPE=C3D8R".
inline constexpr std::string_view setOfType = ", TYPE=";

/// A line of a deck.
struct DeckLine {
  std::string_view text;  // trimmed, not empty; of LS-DYNA trimmed at the end alone, and a line of blanks is one
  std::size_t position;
  bool ended;  // by a line end; false for the last line of a file that has none

  bool isKeyword() const { return text.starts_with('*'); }
};

/// A keyword line with its parameters, "*ELEMENT, TYPE=C3D8, ELSET=bar".
struct DeckKeyword {
  std::string name;                               // upper case, without the star, one blank between two words
  std::map<std::string, std::string> parameters;  // upper case without blanks -> as written, without quotes
  std::size_t position = 0;

  bool has(const std::string& key) const { return parameters.count(key) != 0; }
  /// "" for one that is not there.
  std::string value(const std::string& key) const {
    const auto found = parameters.find(key);
    return found == parameters.end() ? std::string() : found->second;
  }
};

/// A number as Fortran reads it, "1.5+3" for 1.5e3 and "1.d5"; empty for none.
std::optional<double> fortranNumber(std::string_view word);

/// Whether a text is a deck of Abaqus or CalculiX: behind comments and empty lines it begins with a keyword.
bool startsWithDeck(std::string_view text);
/// Whether a text is a deck of LS-DYNA: it begins with *KEYWORD, or with another keyword behind its comments, "$ …".
bool startsWithDyna(std::string_view text);

/// The lines of a deck and of the files that it includes, in the order in which the program that the deck is for reads
/// them. A position stands for a place in one of the files.
class DeckLines {
 public:
  /// text: of the file; it must outlive this.
  DeckLines(const std::filesystem::path& path, const std::string& text, DeckDialect dialect = DeckDialect::abaqus);

  /// The next line that is neither empty nor a comment. *INCLUDE is followed: its file is looked for beside the deck,
  /// then beside the file that includes it. LS-DYNA's *END ends the file that it stands in. Throws InputError
  /// "FILE:LINE: …" for a file that cannot be read, that includes itself, or that is included too deep or too often.
  std::optional<DeckLine> next();
  /// The keyword of a line, which goes on in the next one where it ends with a comma.
  DeckKeyword keyword(const DeckLine& first);
  /// Reads another file next, whose name a keyword's parameter INPUT gives; then the lines go on where they are.
  void include(const DeckKeyword& keyword);

  /// The words between commas, trimmed and without quotes; a comma at the end of the line adds none.
  static std::vector<std::string_view> fields(std::string_view line);
  /// Throw InputError where the word is no whole number of 1 and more, or no number. what: its name in the message.
  std::int64_t number(std::string_view word, std::string_view what, std::size_t position) const;
  double real(std::string_view word, std::string_view what, std::size_t position) const;

  /// "file:line" of a position.
  std::string where(std::size_t position) const;
  [[noreturn]] void failAt(std::size_t position, const std::string& what) const {
    throw InputError(where(position) + ": " + what);
  }
  /// Bytes of all files so far, each as often as it was included.
  std::size_t bytes() const { return bytes_; }

 private:
  /// A file, or one more time the same.
  struct Source {
    std::filesystem::path path, canonical;
    const std::string* text;
    std::size_t base;  // position of its first byte
    std::unique_ptr<FileCursor> cursor;
  };
  struct Open {
    std::size_t source;
    std::size_t at;  // the byte to go on with
    // LS-DYNA: files so far of an *INCLUDE whose lines these are, and the name of one that goes on in the next line.
    std::optional<std::size_t> included = {};
    std::string name = {};
  };
  bool isNoLine(std::string_view line) const;
  std::string_view takeLine(std::string_view text, std::size_t& at) const;
  void include(std::string name, std::string_view keyword, std::size_t position);
  std::optional<DeckLine> nextOfDyna();
  void open(const std::filesystem::path& path, const std::string* text);
  std::optional<DeckLine> nextOfFiles();

  DeckDialect dialect_;
  std::filesystem::path folder_;                                         // of the deck
  std::map<std::filesystem::path, std::unique_ptr<std::string>> texts_;  // of included files
  std::vector<Source> sources_;                                          // by base
  std::vector<Open> open_;                                               // the innermost last
  std::size_t bytes_ = 0;
};

}  // namespace ringwatch::detail

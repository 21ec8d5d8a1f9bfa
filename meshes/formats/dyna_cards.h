#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <ringwatch/meshes/formats/deck_lines.h>

namespace ringwatch::detail {

/// How wide the fields of LS-DYNA's cards are (LS-DYNA Keyword User's Manual, "General Card Format", "Long Format
/// Input"): as each card has them, with numbers of nodes and elements of 10, or all of 20.
enum class DynaFormat { standard, wideNumbers, wide };

/// A keyword line of an LS-DYNA deck, "*MAT_ELASTIC_TITLE +".
struct DynaKeyword {
  std::string name;     // upper case, without the star and without _TITLE or _ID at its end
  bool titled = false;  // _TITLE or _ID: a line with a title, or a number and a title, stands before each card
  DynaFormat format = DynaFormat::standard;
  std::size_t position = 0;
};

/// Which fields a card has: all of 10, or some of their own.
enum class DynaLayout {
  usual,     // 8 fields of 10
  node,      // 8, 3 x 16, 2 x 8
  elements,  // 10 of 8
  mass,      // 2 x 8, 16, 8
  points     // 2 of 20
};

/// A card: a line whose fields stand in columns, or, in the free format, between commas.
class DynaCard {
 public:
  /// lines, keyword: must outlive it.
  DynaCard(const DeckLines& lines, const DynaKeyword& keyword, const DeckLine& line,
           DynaLayout layout = DynaLayout::usual);

  std::size_t position() const { return position_; }
  /// The number of fields that the line reaches.
  std::size_t size() const { return fields_.size(); }
  /// Counted from 0; "" for one of blanks.
  std::string_view field(std::size_t i) const { return i < fields_.size() ? fields_[i] : std::string_view(); }
  bool isBlank(std::size_t i) const { return field(i).empty(); }
  /// Numbers; `fallback` for a field of blanks. Throw InputError "FILE:LINE: field N of *KEYWORD, NAME, is …".
  double real(std::size_t i, std::string_view name, double fallback = 0) const;
  std::int64_t whole(std::size_t i, std::string_view name, std::int64_t fallback = 0) const;
  /// A whole number of 1 and more.
  std::int64_t id(std::size_t i, std::string_view name) const;
  [[noreturn]] void fail(std::size_t i, std::string_view name, std::string_view right) const;

 private:
  const DeckLines& lines_;
  const DynaKeyword& keyword_;
  std::size_t position_;
  std::vector<std::string_view> fields_;
};

/// Reads the keyword lines of a deck in order: *KEYWORD says the format of those behind it.
class DynaKeywords {
 public:
  explicit DynaKeywords(const DeckLines& lines) : lines_(lines) {}
  DynaKeyword read(const DeckLine& line);

 private:
  const DeckLines& lines_;
  DynaFormat usual_ = DynaFormat::standard;
};

/// The names that sets have in the mesh of an LS-DYNA deck: of its parts as element sets and as node sets.
std::string dynaPart(std::int64_t id);      // "part-3"
std::string dynaNodeSet(std::int64_t id);   // "nodeset-3"
std::string dynaSolidSet(std::int64_t id);  // "solidset-3"
std::string dynaPartSet(std::int64_t id);   // "partset-3"

}  // namespace ringwatch::detail

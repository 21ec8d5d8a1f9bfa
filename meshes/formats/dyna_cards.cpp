#include <ringwatch/meshes/formats/dyna_cards.h>

#include <algorithm>
#include <cmath>

namespace ringwatch::detail {
namespace {

constexpr int usualWidth = 10, wideWidth = 20;
constexpr int widthsOfNode[] = {8, 16, 16, 16, 8, 8};
constexpr int widthsOfElements[] = {8, 8, 8, 8, 8, 8, 8, 8, 8, 8};
constexpr int widthsOfMass[] = {8, 8, 16, 8};
constexpr int widthsOfPoints[] = {20, 20};

std::span<const int> widthsOf(DynaLayout layout) {
  switch (layout) {
    case DynaLayout::node:
      return widthsOfNode;
    case DynaLayout::elements:
      return widthsOfElements;
    case DynaLayout::mass:
      return widthsOfMass;
    case DynaLayout::points:
      return widthsOfPoints;
    case DynaLayout::usual:
      break;
  }
  return {};
}

std::string_view withoutBlanks(std::string_view text) {
  const auto begin = text.find_first_not_of(' ');
  return begin == std::string_view::npos ? std::string_view()
                                         : text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

}  // namespace

DynaCard::DynaCard(const DeckLines& lines, const DynaKeyword& keyword, const DeckLine& line, DynaLayout layout)
    : lines_(lines), keyword_(keyword), position_(line.position) {
  if (line.text.find(',') != std::string_view::npos) {
    for (const std::string_view word : DeckLines::fields(line.text)) fields_.push_back(withoutBlanks(word));
    return;
  }
  if (line.text.find('\t') != std::string_view::npos)
    lines.failAt(position_, joinText("*", keyword.name,
                                     ": the line has a tab; fields stand in columns, or between "
                                     "commas"));
  const std::span<const int> widths = widthsOf(layout);
  for (std::size_t at = 0; at < line.text.size() && (widths.empty() || fields_.size() < widths.size());) {
    const int own = widths.empty() ? usualWidth : widths[fields_.size()];
    const int width = keyword.format == DynaFormat::wide                                        ? wideWidth
                      : keyword.format == DynaFormat::wideNumbers && own == widthsOfElements[0] ? usualWidth
                                                                                                : own;
    fields_.push_back(withoutBlanks(line.text.substr(at, static_cast<std::size_t>(width))));
    at += static_cast<std::size_t>(width);
  }
}

void DynaCard::fail(std::size_t i, std::string_view name, std::string_view right) const {
  lines_.failAt(position_, isBlank(i) ? joinText("field ", i + 1, " of *", keyword_.name, ", ", name,
                                                 ", is blank; it must be ", right)
                                      : joinText("field ", i + 1, " of *", keyword_.name, ", ", name, ", is ",
                                                 quoted(field(i)), "; it must be ", right));
}

double DynaCard::real(std::size_t i, std::string_view name, double fallback) const {
  if (isBlank(i)) return fallback;
  const std::optional<double> value = fortranNumber(field(i));
  if (!value) fail(i, name, "a number");
  return *value;
}

std::int64_t DynaCard::whole(std::size_t i, std::string_view name, std::int64_t fallback) const {
  if (isBlank(i)) return fallback;
  // Preprocessors write "2.0", too.
  constexpr double exact = 9007199254740992;  // 2⁵³
  const std::optional<double> value = fortranNumber(field(i));
  if (!value || *value != std::floor(*value) || std::abs(*value) > exact) fail(i, name, "a whole number");
  return static_cast<std::int64_t>(*value);
}

std::int64_t DynaCard::id(std::size_t i, std::string_view name) const {
  const std::int64_t value = whole(i, name);
  if (value < 1) fail(i, name, "a whole number of 1 or more");
  return value;
}

DynaKeyword DynaKeywords::read(const DeckLine& line) {
  const std::string text = inUpperCase(line.text);
  const std::size_t end = std::min(text.find_first_of(" \t,"), text.size());
  DynaKeyword keyword{.name = text.substr(1, end - 1), .format = usual_, .position = line.position};
  const std::string rest = text.substr(end);
  const char mark = keyword.name.empty() ? ' ' : keyword.name.back();
  const bool attached = mark == '+' || mark == '-' || mark == '%';
  if (attached) keyword.name.pop_back();
  const std::string_view behind = withoutBlanks(rest);
  const char sign = attached ? mark : behind.size() == 1 ? behind.front() : ' ';
  if (sign == '+') keyword.format = DynaFormat::wide;
  if (sign == '-') keyword.format = DynaFormat::standard;
  if (sign == '%') keyword.format = DynaFormat::wideNumbers;
  for (const std::string_view suffix : {"_TITLE", "_ID"})
    if (keyword.name.size() > suffix.size() && keyword.name.ends_with(suffix)) {
      keyword.name.resize(keyword.name.size() - suffix.size());
      keyword.titled = true;
      break;
    }
  if (keyword.name == "KEYWORD") {
    for (const auto& [option, format] :
         {std::pair{"LONG=S", DynaFormat::standard}, {"LONG=Y", DynaFormat::wide}, {"I10=Y", DynaFormat::wideNumbers}})
      if (rest.find(option) != std::string::npos) usual_ = format;
    if (rest.find("LONG=K") != std::string::npos)
      lines_.failAt(line.position, "*KEYWORD, LONG=K is not known; LONG=Y has fields of 20 columns, LONG=S of 10");
  }
  return keyword;
}

std::string dynaPart(std::int64_t id) { return joinText("part-", id); }
std::string dynaNodeSet(std::int64_t id) { return joinText("nodeset-", id); }
std::string dynaSolidSet(std::int64_t id) { return joinText("solidset-", id); }
std::string dynaPartSet(std::int64_t id) { return joinText("partset-", id); }

}  // namespace ringwatch::detail

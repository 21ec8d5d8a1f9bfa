#include <ringwatch/base/units.h>

#include <algorithm>
#include <iterator>
#include <regex>
#include <string_view>

namespace ringwatch {
namespace {

struct UnitSymbols {
  UnitSizes sizes;
  std::string_view length, mass, time, force, pressure, energy;

  std::string_view of(std::string_view si) const {
    return si == "m"    ? length
           : si == "kg" ? mass
           : si == "s"  ? time
           : si == "N"  ? force
           : si == "Pa" ? pressure
                        : energy;
  }
};

/// In the order of Units.
constexpr UnitSymbols symbols[] = {
    {{1, 1, 1}, "m", "kg", "s", "N", "Pa", "J"},
    {{1e-3, 1e3, 1}, "mm", "t", "s", "N", "MPa", "mJ"},
    {{1e-3, 1, 1e-3}, "mm", "kg", "ms", "kN", "GPa", "J"},
    {{1e-2, 1e-3, 1e-6}, "cm", "g", "us", "Mbar cm2", "Mbar", "Mbar cm3"},
    {{1, 1, 1}, "", "", "", "", "", ""},
};
static_assert(std::size(symbols) == unitSystems.size());

const UnitSymbols& symbolsOf(Units system) { return symbols[static_cast<std::size_t>(system)]; }

Units used = Units::si;

/// An SI unit behind what stays and what opens it, and before what closes it.
std::regex unitIn(const std::string& before, const std::string& behind) {
  const std::string one = "(?:kg|rad|Pa|[msNJ])(?:[23]|²|³)?";
  return std::regex(before + "((?:1/)?" + one + "(?:[ /]" + one + ")*)" + behind);
}

std::string renamed(const std::string& text, const std::regex& unit, Units system) {
  if (system == Units::si) return text;
  static const std::regex symbol("kg|Pa|[msNJ]");
  std::string result;
  auto rest = text.begin();
  for (std::sregex_iterator found(text.begin(), text.end(), unit), end; found != end; ++found) {
    const std::smatch& match = *found;
    result.append(rest, match[1].second);
    rest = match[0].second;
    if (system == Units::none) continue;
    result += match.str(2);
    auto next = match[3].first;
    for (std::sregex_iterator part(match[3].first, match[3].second, symbol); part != end; ++part) {
      result.append(next, (*part)[0].first) += symbolsOf(system).of(part->str());
      next = (*part)[0].second;
    }
    result.append(next, match[3].second) += match.str(4);
  }
  return result.append(rest, text.end());
}

}  // namespace

UnitSizes sizesOf(Units system) { return symbolsOf(system).sizes; }

void useUnits(Units system) { used = system; }

Units usedUnits() { return used; }

std::string labelled(const std::string& text, Units system) {
  static const std::regex behindNumber = unitIn("([0-9.]|inf|nan)( )", "()(?![A-Za-z0-9_])"),
                          inParentheses = unitIn("()( \\()", "(\\))");
  return renamed(renamed(text, behindNumber, system), inParentheses, system);
}

std::string labelledColumns(const std::string& head, Units system) {
  static const std::regex atEnd = unitIn("()(_)", "()(?=[, ]|$)");
  return renamed(head, atEnd, system);
}

std::string unitNamed(const std::string& si) {
  const std::string named = labelled("0 " + si);
  return named.substr(std::min<std::size_t>(2, named.size()));
}

}  // namespace ringwatch

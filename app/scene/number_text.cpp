#include <ringwatch/app/scene/number_text.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include <ringwatch/base/error.h>
#include <ringwatch/base/user_text.h>

namespace ringwatch {
namespace {

/// A finite number that is all of the text.
std::optional<double> numberOf(std::string_view text) {
  double value = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || fault != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

}  // namespace

std::optional<double> numberOrFraction(std::string_view text) {
  const std::size_t slash = text.find('/');
  const std::optional<double> value = numberOf(text.substr(0, slash));
  if (!value || slash == std::string_view::npos) return value;
  const std::optional<double> under = numberOf(text.substr(slash + 1));
  if (!under || !(*under > 0) || !std::isfinite(*value / *under)) return std::nullopt;
  return *value / *under;
}

double parsePositiveNumber(const std::string& text, const std::string& option) {
  const std::optional<double> value = numberOrFraction(text);
  if (!value || !(*value > 0))
    throw InputError(fmt::format("{}: {} is no time; must be a number > 0 or a fraction, such as 0.02 or 1/60, in s",
                                 option, inQuotes(text)));
  return *value;
}

StretchRange parseStretchRange(const std::string& text, const std::string& option) {
  const std::size_t colon = text.find(':');
  const std::string_view all = text;
  const std::optional<double> low = numberOf(all.substr(0, colon)),
                              high = colon == std::string::npos ? std::nullopt : numberOf(all.substr(colon + 1));
  if (!low || !high || !(*low > 0) || !(*low <= *high))
    throw InputError(fmt::format("{}: {} is no range of stretches; must be a:b with 0 < a <= b, such as 0.7:1.5",
                                 option, inQuotes(text)));
  return {*low, *high};
}

std::vector<std::int64_t> numbersOfSelection(const std::string& selection, std::string_view what,
                                             const std::string& origin) {
  std::vector<std::int64_t> numbers;
  for (std::size_t begin = 1; begin <= selection.size();) {
    const std::size_t end = std::min(selection.find(',', begin), selection.size());
    std::int64_t& number = numbers.emplace_back(0);
    const auto [stop, error] = std::from_chars(selection.data() + begin, selection.data() + end, number);
    if (error != std::errc() || stop != selection.data() + end)
      throw InputError(fmt::format("{}: {} names no {}; write # and their numbers, e.g. \"#3,7\"", origin,
                                   inQuotes(selection), what));
    begin = end + 1;
  }
  return numbers;
}

}  // namespace ringwatch

#include <ringwatch/base/options.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <vector>

#include <ringwatch/base/error.h>
#include <ringwatch/base/nearest_name.h>
#include <ringwatch/base/user_text.h>

namespace ringwatch {
namespace {

constexpr std::string_view automaticText = "auto";

template <class Names>
std::string listed(const Names& names, std::string_view last) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += joinText(i == 0 ? "" : i + 1 < names.size() ? ", " : last, names[i]);
  return text;
}

std::vector<std::string_view> namesOf(std::span<const OptionInfo> table) {
  std::vector<std::string_view> names;
  for (const OptionInfo& option : table) names.push_back(option.name);
  return names;
}

std::string shown(const OptionValue& value) {
  return value.number() ? joinText(*value.number()) : inQuotes(*value.text());
}

OptionValue fallbackOf(const OptionInfo& option) {
  double number = 0;
  const char *const begin = option.fallback.data(), *const end = begin + option.fallback.size();
  const bool numeric = option.type != OptionType::text && std::from_chars(begin, end, number).ptr == end;
  return numeric ? OptionValue(number) : OptionValue(option.fallback);
}

/// "auto" of a text with choices is its first one.
OptionValue resolved(const OptionInfo& option, OptionValue value) {
  if (option.type == OptionType::text && value.text() && *value.text() == automaticText && !option.choices.empty())
    return option.choices.front();
  return value;
}

std::string valueFault(const OptionInfo& option, const OptionValue& value) {
  const std::string range = option.range.text();
  if (const std::string* text = value.text()) {
    if (option.automatic && *text == automaticText) return {};
    if (option.type != OptionType::text)
      return joinText("is a text where ", option.type == OptionType::integer ? "an integer" : "a number", " is needed");
    if (option.choices.empty() || std::ranges::find(option.choices, *text) != option.choices.end()) return {};
    return joinText("must be one of ", listed(option.choices, ", "));
  }
  const double number = *value.number();
  if (option.type == OptionType::text) return "is a number where a text is needed";
  if (!std::isfinite(number)) return "must be a finite number" + (range.empty() ? range : " " + range);
  if (option.type == OptionType::integer && number != std::floor(number)) return "must be an integer";
  constexpr std::numeric_limits<int> integers;
  if (option.type == OptionType::integer && option.range.holds(number) &&
      (number < integers.min() || number > integers.max()))
    return joinText("must be an integer from ", integers.min(), " to ", integers.max());
  return option.range.holds(number) ? std::string() : "must be " + range;
}

}  // namespace

std::string NumberRange::text() const {
  std::string result;
  if (std::isfinite(low)) result = joinText(lowIncluded ? ">= " : "> ", low);
  if (std::isfinite(high)) result += joinText(result.empty() ? "" : " and ", highIncluded ? "<= " : "< ", high);
  return result;
}

double Options::number(std::string_view name) const {
  const OptionValue* value = find(name);
  if (!value || !value->number()) throw InputError(joinText("option \"", name, "\": a number is needed"));
  return *value->number();
}

const std::string& Options::text(std::string_view name) const {
  const OptionValue* value = find(name);
  if (!value || !value->text()) throw InputError(joinText("option \"", name, "\": a text is needed"));
  return *value->text();
}

bool Options::automatic(std::string_view name) const {
  const OptionValue* value = find(name);
  return value && value->text() && *value->text() == automaticText;
}

const OptionInfo* findOption(std::span<const OptionInfo> table, std::string_view name) {
  const auto found = std::ranges::find(table, name, &OptionInfo::name);
  return found == table.end() ? nullptr : &*found;
}

std::string optionFault(std::span<const OptionInfo> table, const Options& given, std::string_view name) {
  const OptionInfo* option = findOption(table, name);
  if (!option) {
    const std::vector<std::string_view> known = namesOf(table);
    return known.empty() ? "there are no options"
                         : joinText("unknown; ", didYouMean(name, known), "known are ", listed(known, ", "));
  }
  if (const OptionValue* value = given.find(name))
    if (std::string fault = valueFault(*option, *value); !fault.empty()) return fault;
  if (const auto& condition = option->onlyWith; !condition.option.empty()) {
    const OptionInfo& other = *findOption(table, condition.option);
    const OptionValue* chosen = given.find(condition.option);
    const OptionValue value = resolved(other, chosen ? *chosen : fallbackOf(other));
    if (value.text() && std::ranges::find(condition.values, *value.text()) == condition.values.end())
      return joinText("goes with ", condition.option, " ", listed(condition.values, " or "), ", not with ",
                      shown(value));
  }
  return {};
}

Options completed(std::string_view owner, std::span<const OptionInfo> table, const Options& given) {
  for (const auto& [name, value] : given)
    if (const std::string fault = optionFault(table, given, name); !fault.empty())
      throw InputError(joinText(owner, ": ", shortened(name), " ", shown(value), ": ", fault));
  Options result;
  for (const OptionInfo& option : table) {
    const OptionValue* value = given.find(option.name);
    if (!value && option.fallback.empty())
      throw InputError(joinText(owner, ": ", option.name, ": missing; ",
                                option.range.text().empty() ? "" : "must be " + option.range.text(),
                                option.unit.empty() ? "" : " ", option.unit));
    result.set(option.name, resolved(option, value ? *value : fallbackOf(option)));
  }
  return result;
}

}  // namespace ringwatch

#pragma once
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace ringwatch {

/// The numbers that an option accepts.
struct NumberRange {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool lowIncluded = true, highIncluded = true;

  constexpr bool holds(double value) const {
    return (lowIncluded ? value >= low : value > low) && (highIncluded ? value <= high : value < high);
  }
  /// "> 0 and < 0.5"; "" when everything is accepted.
  std::string text() const;
  static constexpr NumberRange positive() { return {0, std::numeric_limits<double>::infinity(), false, true}; }
};

enum class OptionType { number, integer, text };

/// An option that an entry of a registry declares: scenes, command line, help texts and messages take it from here.
struct OptionInfo {
  std::string_view name;
  OptionType type = OptionType::number;
  std::string_view unit = {};
  NumberRange range = {};
  /// What a text may be; empty for anything.
  std::span<const std::string_view> choices = {};
  /// Whether "auto" is accepted too. For a text with choices it stands for the first one.
  bool automatic = false;
  /// The value where none is given, as text; "" when one must be given.
  std::string_view fallback = {};
  std::string_view help = {};
  /// The option makes sense only while another one has one of these values.
  struct Condition {
    std::string_view option = {};
    std::span<const std::string_view> values = {};
  } onlyWith = {};
};

/// A number or a text.
class OptionValue {
 public:
  OptionValue(double number) : value_(number) {}
  OptionValue(int number) : value_(static_cast<double>(number)) {}
  OptionValue(std::int64_t number) : value_(static_cast<double>(number)) {}
  OptionValue(std::string text) : value_(std::move(text)) {}
  OptionValue(std::string_view text) : value_(std::string(text)) {}
  OptionValue(const char* text) : value_(std::string(text)) {}

  /// nullptr for a text.
  const double* number() const { return std::get_if<double>(&value_); }
  /// nullptr for a number.
  const std::string* text() const { return std::get_if<std::string>(&value_); }
  friend bool operator==(const OptionValue&, const OptionValue&) = default;

 private:
  std::variant<double, std::string> value_;
};

/// Values of options by name. What they may be says a table of OptionInfo.
class Options {
 public:
  Options() = default;
  Options(std::initializer_list<std::pair<const std::string, OptionValue>> values) : values_(values) {}

  Options& set(std::string_view name, OptionValue value) {
    values_.insert_or_assign(std::string(name), std::move(value));
    return *this;
  }
  /// nullptr when it is not given.
  const OptionValue* find(std::string_view name) const {
    const auto found = values_.find(name);
    return found == values_.end() ? nullptr : &found->second;
  }
  /// Throw InputError when it is not given or of the other kind.
  double number(std::string_view name) const;
  int integer(std::string_view name) const { return static_cast<int>(number(name)); }
  const std::string& text(std::string_view name) const;
  /// Whether it is "auto".
  bool automatic(std::string_view name) const;

  auto begin() const { return values_.begin(); }
  auto end() const { return values_.end(); }
  bool empty() const { return values_.empty(); }

 private:
  std::map<std::string, OptionValue, std::less<>> values_;
};

/// nullptr when there is none of that name.
const OptionInfo* findOption(std::span<const OptionInfo> table, std::string_view name);
/// What is wrong with the value of an option among those given, with what would be right; "" when nothing is.
std::string optionFault(std::span<const OptionInfo> table, const Options& given, std::string_view name);
/// The given options with those that are not given at their defaults; "auto" of a text is replaced by what it stands
/// for. owner: whose they are. Throws InputError "OWNER: NAME VALUE: what would be right", also for unknown names and
/// for those that must be given.
Options completed(std::string_view owner, std::span<const OptionInfo> table, const Options& given);

}  // namespace ringwatch

#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ringwatch {

/// A value of an enumeration with the name that users write and read.
template <class Enum>
struct NamedValue {
  Enum value;
  std::string_view name;
  std::string_view help = {};   ///< one line
  std::string_view alias = {};  ///< another name that is accepted; "" for none
};

namespace detail {
/// Throws InputError: `what` "name": did you mean …? must be one of …
[[noreturn]] void throwUnknownName(std::string_view what, std::string_view name, std::span<const std::string> known);
}  // namespace detail

/// The names of an enumeration, one line a value. Scenes, command line, help texts and results take them from here.
template <class Enum, std::size_t count>
class NameTable {
 public:
  constexpr explicit NameTable(std::array<NamedValue<Enum>, count> values) : values_(values) {}

  static constexpr std::size_t size() { return count; }
  /// "" for a value that the table lacks.
  constexpr std::string_view nameOf(Enum value) const {
    for (const NamedValue<Enum>& known : values_)
      if (known.value == value) return known.name;
    return {};
  }
  /// The entry of a name or alias; nullptr when there is none.
  constexpr const NamedValue<Enum>* find(std::string_view name) const {
    for (const NamedValue<Enum>& known : values_)
      if (known.name == name || (!known.alias.empty() && known.alias == name)) return &known;
    return nullptr;
  }
  /// The value of a name or alias. what: for the message. Throws InputError that lists the names.
  Enum valueOf(std::string_view what, std::string_view name) const {
    if (const NamedValue<Enum>* known = find(name)) return known->value;
    detail::throwUnknownName(what, name, names());
  }
  std::vector<std::string> names() const {
    std::vector<std::string> result;
    for (const NamedValue<Enum>& known : values_) result.emplace_back(known.name);
    return result;
  }
  /// The names, for tables of constants such as OptionInfo::choices.
  constexpr std::array<std::string_view, count> views() const {
    std::array<std::string_view, count> result{};
    for (std::size_t i = 0; i < count; ++i) result[i] = values_[i].name;
    return result;
  }
  /// "NAME: help; NAME: help"; names alone where there is no help.
  std::string listing() const {
    std::string text;
    for (const NamedValue<Enum>& known : values_) {
      text += (text.empty() ? "" : "; ") + std::string(known.name);
      if (!known.help.empty()) text += ": " + std::string(known.help);
    }
    return text;
  }
  constexpr auto begin() const { return values_.begin(); }
  constexpr auto end() const { return values_.end(); }

 private:
  std::array<NamedValue<Enum>, count> values_;
};

/// nameTable<Colour>({{Colour::red, "red", "as blood"}, …})
template <class Enum, std::size_t count>
constexpr NameTable<Enum, count> nameTable(const NamedValue<Enum> (&values)[count]) {
  return NameTable<Enum, count>(std::to_array(values));
}

}  // namespace ringwatch

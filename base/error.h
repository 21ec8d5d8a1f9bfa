#pragma once
#include <concepts>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>

namespace ringwatch {

/// What a user can mend: a file, a key, a value. The text names all of them and what would be right, in one line.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What the mathematics refuses: a bound that cannot be had, an iteration that does not converge. The text names the
/// element and the value.
class NumericalError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

namespace detail {

/// A text, a character or a number, as `joinText` takes it. Lives no longer than the call.
class TextPart {
 public:
  TextPart(std::string_view text) : kind_(Kind::text), text_(text) {}
  TextPart(const std::string& text) : TextPart(std::string_view(text)) {}
  TextPart(const char* text) : TextPart(std::string_view(text)) {}
  TextPart(char character) : kind_(Kind::character), integer_(character) {}
  TextPart(std::floating_point auto number) : kind_(Kind::real), real_(static_cast<double>(number)) {}
  TextPart(std::signed_integral auto number) : kind_(Kind::integer), integer_(number) {}
  TextPart(std::unsigned_integral auto number) : kind_(Kind::natural), natural_(number) {}

  void appendTo(std::string& text) const;

 private:
  enum class Kind : unsigned char { text, character, real, integer, natural };
  Kind kind_;
  union {
    std::string_view text_;
    double real_;
    long long integer_;
    unsigned long long natural_;
  };
};

std::string join(std::initializer_list<TextPart> parts);

}  // namespace detail

/// Joins texts, characters and numbers into one text; numbers keep nine significant digits.
template <class... Parts>
std::string joinText(const Parts&... parts) {
  return detail::join({detail::TextPart(parts)...});
}

}  // namespace ringwatch

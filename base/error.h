#pragma once
#include <sstream>
#include <stdexcept>
#include <string>

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

/// Joins its arguments into one text; numbers keep nine significant digits.
template <class... Parts>
std::string joinText(const Parts&... parts) {
  std::ostringstream text;
  text.precision(9);
  (text << ... << parts);
  return text.str();
}

}  // namespace ringwatch

#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace ringwatch {

// Numbers are read and written with a decimal point whatever locale the program that embeds ringwatch has chosen.

/// Reads a whole text as a number; empty where it is none. Too large ones are infinite, too small ones zero.
std::optional<double> readNumber(std::string_view text);

/// Writes a number with so many significant digits, as printf's %g does.
std::string digitsOf(double number, int digits);

/// Writes a number exactly, in hexadecimal digits, as printf's %a does.
std::string hexadecimalOf(double number);

}  // namespace ringwatch

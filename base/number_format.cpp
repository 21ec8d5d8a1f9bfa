#include <ringwatch/base/number_format.h>

#include <locale.h>

#include <cstdio>
#include <cstdlib>

namespace ringwatch {
namespace {

/// While it lives the C library's functions use the C locale in the calling thread.
class PlainLocale {
 public:
  PlainLocale() {
    static const locale_t plain = newlocale(LC_ALL_MASK, "C", nullptr);
    before_ = uselocale(plain);
  }
  ~PlainLocale() { uselocale(before_); }
  PlainLocale(const PlainLocale&) = delete;
  PlainLocale& operator=(const PlainLocale&) = delete;

 private:
  locale_t before_;
};

}  // namespace

std::optional<double> readNumber(std::string_view text) {
  const PlainLocale plain;
  const std::string copy(text);
  char* end = nullptr;
  const double number = std::strtod(copy.c_str(), &end);
  const bool blank = copy.find_first_of(" \t\r\n") != std::string::npos;  // strtod skips those at the beginning
  if (copy.empty() || blank || end != copy.c_str() + copy.size()) return {};
  return number;
}

std::string digitsOf(double number, int digits) {
  const PlainLocale plain;
  char text[400];
  return {text, static_cast<std::size_t>(std::snprintf(text, sizeof text, "%.*g", digits, number))};
}

std::string hexadecimalOf(double number) {
  const PlainLocale plain;
  char text[40];
  return {text, static_cast<std::size_t>(std::snprintf(text, sizeof text, "%a", number))};
}

}  // namespace ringwatch

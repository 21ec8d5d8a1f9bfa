#pragma once
#include <clocale>
#include <cstdlib>
#include <locale>
#include <stdexcept>
#include <string>

#include <tests/support/temporary_folder.h>

namespace ringwatch::test {

/// While it lives, the C library and the streams of this program write 1,5 and 1.000, as those of many countries do.
class CommaLocale {
 public:
  CommaLocale() {
    folder_.write("source",
                  "LC_NUMERIC\ndecimal_point \"<U002C>\"\nthousands_sep \"<U002E>\"\ngrouping 3;3\nEND LC_NUMERIC\n");
    // Its status is 1 for the categories that the source leaves out.
    const std::string make =
        "cd " + folder_.path().string() + " && localedef -c -i source -f ANSI_X3.4-1968 ./comma >/dev/null 2>&1";
    static_cast<void>(std::system(make.c_str()));
    setenv("LOCPATH", folder_.path().c_str(), 1);
    if (std::setlocale(LC_NUMERIC, "comma") == nullptr || *std::localeconv()->decimal_point != ',')
      throw std::runtime_error("there is no locale with a decimal comma: localedef failed");
  }
  ~CommaLocale() {
    std::locale::global(before_);
    std::setlocale(LC_NUMERIC, "C");
    unsetenv("LOCPATH");
  }
  CommaLocale(const CommaLocale&) = delete;
  CommaLocale& operator=(const CommaLocale&) = delete;

 private:
  struct Punctuation : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  TemporaryFolder folder_;
  std::locale before_ = std::locale::global(std::locale(std::locale::classic(), new Punctuation));
};

}  // namespace ringwatch::test

#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <sstream>
#include <string>

#include "proof.h"

namespace {

using check::Ball;

/// A value in so many digits that holds(decimals), and is none on one side of it: rounded to the nearest, then step by
/// step towards the side that is safe.
template <class Holds>
std::string decimals(double value, int digits, double towards, const Holds& holds) {
  char text[40];
  double at = value, step = std::pow(10, -digits);
  do {
    std::snprintf(text, sizeof text, "%.*g", digits, at);
    at *= 1 + towards * step;
    step *= 2;
  } while (!holds(Ball::ofDecimals(text)));
  return text;
}
/// 2/sqrt(lambda), s, of a bound from above (stable up to) or from below (unstable above).
std::string stepText(double lambda, bool fromAbove) {
  return decimals(2 / std::sqrt(lambda), 10, fromAbove ? -1 : 1, [&](const Ball& step) {
    const Ball square = step * step * Ball(lambda);
    return (fromAbove ? Ball(4) - square : square - Ball(4)).nonnegative();
  });
}
std::string boundText(double lambda, bool fromAbove) {
  return decimals(lambda, 17, fromAbove ? 1 : -1, [&](const Ball& bound) {
    return (fromAbove ? bound - Ball(lambda) : Ball(lambda) - bound).nonnegative();
  });
}

void print(const check::Verdict& verdict) {
  std::printf("  body        %lld nodes, %lld elements, mass %.10g kg, volume %.10g m3\n",
              static_cast<long long>(verdict.nodes), static_cast<long long>(verdict.elements), verdict.mass,
              verdict.volume);
  for (std::size_t k = 0; k < verdict.kinds.size(); ++k) {
    const check::Kind& kind = verdict.kinds[k];
    std::printf(
        "  elements    %zu %s of %s: lambda %.10g Pa, mu %.10g Pa; shares %g %g at %zu points, %g %g at the mean\n",
        verdict.elementsOf[k], kind.element.c_str(), kind.law.c_str(), kind.lambda, kind.mu, kind.pointLambda,
        kind.pointMu, kind.points.size(), kind.meanLambda, kind.meanMu);
  }
  std::printf("  held        in x %lld nodes, in y %lld, in z %lld\n", static_cast<long long>(verdict.held[0]),
              static_cast<long long>(verdict.held[1]), static_cast<long long>(verdict.held[2]));
  std::printf("  extent      x %.10g to %.10g m, y %.10g to %.10g m, z %.10g to %.10g m; displaced by %.3g m at most\n",
              verdict.least[0], verdict.largest[0], verdict.least[1], verdict.largest[1], verdict.least[2],
              verdict.largest[2], verdict.displaced);
  std::printf("  hash        %016llx\n", static_cast<unsigned long long>(verdict.hash));
  if (verdict.sigma != 0)
    std::printf(
        "  lambda      <= %s rad2/s2; where no eigenvalue is negative, stable up to the step 2/sqrt(lambda) = %s s\n",
        boundText(verdict.sigma, true).c_str(), stepText(verdict.sigma, true).c_str());
  if (verdict.lower != 0)
    std::printf("  lambda      >= %s rad2/s2; unstable above 2/sqrt(lambda) = %s s\n",
                boundText(verdict.lower, false).c_str(), stepText(verdict.lower, false).c_str());
}

/// Sixteen hexadecimal digits.
bool isHash(const std::string& text) {
  if (text.size() != 16) return false;
  for (const char c : text)
    if (!std::isxdigit(static_cast<unsigned char>(c))) return false;
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  std::string file, expected;
  bool understood = argc > 1;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--expect" && i + 1 < argc && isHash(argv[i + 1]) && expected.empty())
      expected = argv[++i];
    else if (word[0] != '-' && !word.empty() && file.empty())
      file = word;
    else
      understood = false;
  }
  if (!understood || file.empty()) {
    std::fprintf(
        stderr,
        "usage: ringwatch-check [--expect HASH] FILE\n"
        "  FILE    a certificate of ringwatch inspect --certificate\n"
        "  HASH    of the body that it must be about, as ringwatch inspect --certificate prints it: 16 digits\n");
    return 2;
  }
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream bytes;
  if (!stream || !(bytes << stream.rdbuf())) {  // a folder can be opened, not read
    std::fprintf(stderr, "ringwatch-check: %s: cannot be read, or is empty\n", file.c_str());
    return 2;
  }
  const std::clock_t begin = std::clock();
  const check::Verdict verdict = check::verify(bytes.str());
  const double time = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  if (verdict.status != check::Verdict::Status::proven) {
    const bool read = verdict.status == check::Verdict::Status::notProven;
    std::fprintf(read ? stdout : stderr, "%s: %s: %s\n", file.c_str(), read ? "NOT PROVEN" : "not a certificate",
                 verdict.reason.c_str());
    return static_cast<int>(verdict.status);
  }
  const bool another = !expected.empty() && std::stoull(expected, nullptr, 16) != verdict.hash;
  std::printf("%s: %s\n", file.c_str(), another ? "PROVEN OF ANOTHER BODY" : "proven");
  print(verdict);
  std::printf("  time        %.3g s of one core, %.0f elements a second\n", time,
              static_cast<double>(verdict.elements) / time);
  return another ? 1 : 0;
}

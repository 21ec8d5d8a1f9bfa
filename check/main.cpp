#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <iterator>

#include "proof.h"

int main(int argc, char** argv) {
  if (argc != 2 || argv[1][0] == '-') {
    std::fprintf(stderr, "usage: ringwatch-check FILE   (a certificate of ringwatch inspect --certificate)\n");
    return 2;
  }
  std::ifstream stream(argv[1], std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream) {
    std::fprintf(stderr, "ringwatch-check: %s: cannot read\n", argv[1]);
    return 2;
  }
  const std::clock_t begin = std::clock();
  const check::Verdict verdict = check::verify(bytes);
  const double time = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  if (verdict.status != check::Verdict::Status::proven) {
    const bool read = verdict.status == check::Verdict::Status::notProven;
    std::fprintf(read ? stdout : stderr, "%s: %s: %s\n", argv[1], read ? "NOT PROVEN" : "not a certificate",
                 verdict.reason.c_str());
    return static_cast<int>(verdict.status);
  }
  std::printf("%s: proven\n  body        %lld nodes, %lld elements, mass %.10g kg, volume %.10g m3\n", argv[1],
              static_cast<long long>(verdict.nodes), static_cast<long long>(verdict.elements), verdict.mass,
              verdict.volume);
  if (verdict.sigma != 0)
    std::printf("  lambda      <= %.17g rad2/s2; stable up to the step 2/sqrt(lambda) = %.10g s\n", verdict.sigma,
                2 / std::sqrt(verdict.sigma));
  if (verdict.lower > 0)
    std::printf("  lambda      >= %.17g rad2/s2; unstable above 2/sqrt(lambda) = %.10g s\n", verdict.lower,
                2 / std::sqrt(verdict.lower));
  std::printf("  time        %.3g s of one core, %.0f elements a second\n", time,
              static_cast<double>(verdict.elements) / time);
  return 0;
}

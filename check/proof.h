#pragma once
#include <cstdint>
#include <string>

namespace check {

/// What came of a certificate.
struct Verdict {
  enum class Status { proven = 0, notProven = 1, unreadable = 2 } status;
  std::string reason;  ///< the first thing that fails, "" for none
  std::int64_t nodes = 0, elements = 0;
  double sigma = 0, lower = 0;  ///< proven: lower <= lambda_max(M⁻¹K) <= sigma, rad²/s²; 0: nothing of that side
  double mass = 0, volume = 0;  ///< of the body that it is about, to rounding: kg, m³
};

/// Checks the bytes of a certificate file (docs/certificate_file.md).
Verdict verify(const std::string& bytes);

}  // namespace check

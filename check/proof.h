#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "tangent.h"

namespace check {

/// What came of a certificate.
struct Verdict {
  enum class Status { proven = 0, notProven = 1, unreadable = 2 } status;
  std::string reason;  ///< the first thing that fails, "" for none
  std::int64_t nodes = 0, elements = 0;
  double sigma = 0, lower = 0;  ///< proven: lower <= lambda_max(M⁻¹K) <= sigma, rad²/s²; 0: nothing of that side
  // The body that it is about.
  double mass = 0, volume = 0;  ///< to rounding: kg, m³
  std::vector<Kind> kinds{};
  std::vector<std::size_t> elementsOf{};     ///< of each kind
  std::array<std::int64_t, 3> held{};        ///< nodes whose component is held
  std::array<double, 3> least{}, largest{};  ///< reference positions, m
  double displaced = 0;                      ///< the largest displacement of a component, m
  std::uint64_t hash = 0;  ///< of mesh, material, masses and held components (docs/certificate_file.md)
};

/// Checks the bytes of a certificate file (docs/certificate_file.md).
Verdict verify(const std::string& bytes);

}  // namespace check

#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include <ringwatch/monitor/energy_balance.h>

namespace ringwatch {

/// Holds the energy balance of a run against the largest energy that it has had.
class EnergyCheck {
 public:
  /// largest: an energy, J, below which none is a measure.
  explicit EnergyCheck(double largest) : largest_(largest) {}

  /// The balance error at a step over the largest energy so far; nothing where it is within the tolerance, or too early
  /// to tell.
  std::optional<double> observe(const Energies& energies, std::int64_t step, double tolerance) {
    largest_ = std::max({largest_, energies.kinetic + std::abs(energies.strain), std::abs(energies.externalWork)});
    double share = largest_ > 0 ? std::abs(energies.balanceError) / largest_ : 0;
    if (!std::isfinite(share)) share = std::numeric_limits<double>::infinity();  // a law without energy at this state
    if (!first_) first_ = step;
    return step - *first_ >= settling && share > tolerance ? std::optional(share) : std::nullopt;
  }

  template <class Archive>
  void archive(Archive& a) {
    a(largest_, first_);
  }

 private:
  // Steps before it is checked. Schemes whose velocities are half a step behind, symplectic Euler for one, are off by
  // 1/n of the energy at step n of a run that starts under load.
  static constexpr int settling = 20;
  double largest_;  // J
  std::optional<std::int64_t> first_;
};

}  // namespace ringwatch

#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include <ringwatch/monitor/energy_balance.h>

namespace ringwatch {

/// What the error of an energy balance is measured by: the largest energy so far that both of its sides had. What is
/// there, kinetic, strain and dissipated, counts as far as it was there at the start or put in since: an energy that
/// comes from nowhere is all error, and no measure of others.
class EnergyScale {
 public:
  /// least: an energy, J, below which none is a measure.
  explicit EnergyScale(double least) : largest_(least) {}

  /// Energies, J, below that are no measure from here on.
  void raise(double energy) { largest_ = std::max(largest_, energy); }
  /// The measure at a state, J. One whose energies are no numbers has none of its own.
  double of(const Energies& energies) const {
    const double is = energies.kinetic + energies.strain + energies.dissipated,
                 both = std::min(std::abs(is), std::abs(is - energies.balanceError));
    return std::isfinite(both) ? std::max(largest_, both) : largest_;
  }
  /// The state is one of those so far. Returns its measure.
  double add(const Energies& energies) { return largest_ = of(energies); }

  template <class Archive>
  void archive(Archive& a) {
    a(largest_);
  }
  double largest() const { return largest_; }

 private:
  double largest_;  // J
};

/// Holds the energy balance of a run against what it is measured by.
class EnergyCheck {
 public:
  /// Steps before it is checked. Schemes whose velocities are half a step behind, symplectic Euler for one, are off by
  /// 1/n of the energy at step n of a run that starts under load.
  static constexpr int settling = 20;

  /// least: an energy, J, below which none is a measure.
  explicit EnergyCheck(double least) : scale_(least) {}

  /// The balance error at a step over its measure; nothing where it is within the tolerance, or too early to tell.
  std::optional<double> observe(const Energies& energies, std::int64_t step, double tolerance) {
    const double measure = scale_.add(energies);
    double share = measure > 0 ? std::abs(energies.balanceError) / measure : 0;
    if (!std::isfinite(share)) share = std::numeric_limits<double>::infinity();  // a law without energy at this state
    if (!first_) first_ = step;
    return step - *first_ >= settling && share > tolerance ? std::optional(share) : std::nullopt;
  }

  template <class Archive>
  void archive(Archive& a) {
    a(scale_, first_);
  }

 private:
  EnergyScale scale_;
  std::optional<std::int64_t> first_;
};

}  // namespace ringwatch

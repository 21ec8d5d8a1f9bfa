#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include <nlohmann/json.hpp>

#include <ringwatch/app/run/run_result.h>
#include <ringwatch/monitor/energy_balance.h>

namespace ringwatch {

/// Whether and when the energy of a run ran away.
class EnergyRunaway {
 public:
  /// largest: an energy, J, below which none is a measure (roundingEnergy).
  explicit EnergyRunaway(double largest) : largest_(largest) {}

  /// Energies, J, below that are no measure of the balance.
  void setScale(double energy) {
    scale_ = energy;
    largest_ = std::max(largest_, energy);
  }
  /// Energies for a monitor's check: an error within the tolerance, a share of the largest energy so far, is none.
  Energies forgiven(Energies energies, double tolerance) const {
    // The largest energy of the run, which outlives a monitor.
    if (std::abs(energies.balanceError) <= tolerance * largest_) energies.balanceError = 0;
    return energies;
  }
  /// Checks the energies before step number `step`. The energy ran away where the balance error passes its bound and
  /// stays above it to the end of the run. From there on the largest energy stays what it was: the runaway must not
  /// become its own measure.
  void check(const Energies& energies, std::int64_t step, double time);
  /// The moment, as far as is known; empty where it did not.
  const std::optional<RunResult::Moment>& moment() const { return moment_; }

  /// What resume() needs.
  nlohmann::ordered_json save() const;
  void resume(const nlohmann::ordered_json& saved);
  template <class Archive>
  void archive(Archive& a) {
    a(largest_, scale_, moment_);
  }

 private:
  double largest_;    // J, so far
  double scale_ = 0;  // J
  std::optional<RunResult::Moment> moment_;
};

/// Energies for a checkpoint, and back.
nlohmann::ordered_json energiesJson(const Energies& energies);
Energies energiesOfJson(const nlohmann::ordered_json& saved);

}  // namespace ringwatch

#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include <nlohmann/json.hpp>

#include <ringwatch/app/run/run_result.h>
#include <ringwatch/monitor/energy_check.h>

namespace ringwatch {

/// Whether and when the energy of a run ran away.
class EnergyRunaway {
 public:
  /// least: an energy, J, below which none is a measure (roundingEnergy).
  explicit EnergyRunaway(double least) : scale_(least) {}

  /// Energies, J, below that are no measure of the balance.
  void setScale(double energy) { scale_.raise(energy); }
  /// Energies for a monitor's check: an error within the tolerance, a share of the run's measure, is none.
  Energies forgiven(Energies energies, double tolerance) const {
    // The measure of the run outlives a monitor.
    if (std::abs(energies.balanceError) <= tolerance * scale_.of(energies)) energies.balanceError = 0;
    return energies;
  }
  /// Checks the energies before step number `step`. The energy ran away where there is more than was put in, by a share
  /// of the run's measure, and stays so to the end of the run.
  void check(const Energies& energies, std::int64_t step, double time);
  /// The moment, as far as is known; empty where it did not.
  const std::optional<RunResult::Moment>& moment() const { return moment_; }

  /// What resume() needs.
  nlohmann::ordered_json save() const;
  void resume(const nlohmann::ordered_json& saved);
  template <class Archive>
  void archive(Archive& a) {
    a(scale_, moment_);
  }

 private:
  EnergyScale scale_;
  std::optional<RunResult::Moment> moment_;
};

/// Energies for a checkpoint, and back.
nlohmann::ordered_json energiesJson(const Energies& energies);
Energies energiesOfJson(const nlohmann::ordered_json& saved);

}  // namespace ringwatch

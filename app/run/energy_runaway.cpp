#include <ringwatch/app/run/energy_runaway.h>

namespace ringwatch {

void EnergyRunaway::check(const Energies& energies, std::int64_t step, double time) {
  const double measure = scale_.add(energies);
  // Schemes whose velocities are half a step behind are off by 1/(n + 1) of the energy at step n of a run that starts
  // under load.
  const double share = std::max(runawayShare, 1.5 / static_cast<double>(step + 1));
  const bool off = !(std::abs(energies.balanceError) <= share * measure);
  if (!off)
    moment_.reset();
  else if (!moment_)
    moment_ = {step, time};
}

nlohmann::ordered_json EnergyRunaway::save() const {
  return {{"scale", scale_.largest()},
          {"step", moment_ ? nlohmann::ordered_json(moment_->step) : nlohmann::ordered_json(nullptr)},
          {"time", moment_ ? moment_->time : 0}};
}

void EnergyRunaway::resume(const nlohmann::ordered_json& saved) {
  scale_.raise(saved.at("scale").get<double>());
  if (!saved.at("step").is_null()) moment_ = {saved.at("step").get<std::int64_t>(), saved.at("time").get<double>()};
}

nlohmann::ordered_json energiesJson(const Energies& energies) {
  return {{"kinetic", energies.kinetic},
          {"strain", energies.strain},
          {"external_work", energies.externalWork},
          {"balance_error", energies.balanceError},
          {"dissipated", energies.dissipated}};
}

Energies energiesOfJson(const nlohmann::ordered_json& saved) {
  const auto number = [&](const char* key) { return saved.at(key).get<double>(); };
  return {number("kinetic"), number("strain"), number("external_work"), number("balance_error"), number("dissipated")};
}

}  // namespace ringwatch

#include <ringwatch/app/run/energy_runaway.h>

namespace ringwatch {

void EnergyRunaway::check(const Energies& energies, std::int64_t step, double time) {
  const double measure = scale_.add(energies);
  // More than was there and was put in: what damping takes is no part of it, so that neither an error of that sum nor
  // energy that is lost counts. Energies that are no numbers count at once.
  const double gain = energies.balanceError - energies.dissipated;
  const bool off = step < EnergyCheck::settling ? std::isnan(gain) : !(gain <= runawayShare * measure);
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

#include <ringwatch/app/run/run_energies.h>

#include <algorithm>
#include <cmath>

namespace ringwatch {

RunEnergies::RunEnergies(const Scene& scene, const Body& body)
    : scene_(scene), body_(body), largest_(roundingEnergy(body)) {
  balance_.emplace(body);
}

void RunEnergies::record(const State& state, const StepEvaluation& evaluation, BodySystem& system, bool rowDue,
                         std::optional<double> dampingPower) {
  last_.reset();
  if (!needs(rowDue)) return;
  balance_->record(state.x, evaluation.internalForce);
  if (damped()) {
    system.dampingForceBesideElements(state.x, state.v, dampingForce_);
    balance_->recordDamping(state.time, state.v, dampingForce_,
                            dampingPower ? *dampingPower : system.elementDampingPower(state.x, state.v));
  }
  if (scene_.movesObstacles())
    balance_->recordObstacles(state.time, body_.discreteForces()->obstaclePower(state.x, state.v));
  if (!rowDue) return;
  last_ = balance_->energies(state.x, state.v, evaluation.strainEnergy);
  last_->externalWork += before_.externalWork + ownWork_;
  last_->dissipated += before_.dissipated + byHandler_;
  last_->balanceError += before_.balanceError - ownWork_ + byHandler_;
}

void RunEnergies::beginBody() {
  if (last_) before_ = *last_;
  last_.reset();
  ownWork_ = byHandler_ = 0;
  balance_.emplace(body_);
}

nlohmann::ordered_json RunEnergies::save() const {
  return {{"kinetic", before_.kinetic},
          {"strain", before_.strain},
          {"external_work", before_.externalWork},
          {"balance_error", before_.balanceError},
          {"dissipated", before_.dissipated},
          {"largest", largest_},
          {"scale", scale_},
          {"runaway_step", runaway_ ? nlohmann::ordered_json(runaway_->step) : nlohmann::ordered_json(nullptr)},
          {"runaway_time", runaway_ ? runaway_->time : 0}};
}

void RunEnergies::resume(const nlohmann::ordered_json& saved) {
  const auto number = [&](const char* key) { return saved.at(key).get<double>(); };
  before_ = {number("kinetic"), number("strain"), number("external_work"), number("balance_error"),
             number("dissipated")};
  largest_ = number("largest");
  scale_ = number("scale");
  if (!saved.at("runaway_step").is_null())
    runaway_ = {saved.at("runaway_step").get<std::int64_t>(), number("runaway_time")};
}

void RunEnergies::check(std::int64_t step, double time) {
  if (!last_) return;
  if (!runaway_)
    largest_ = std::max({largest_, last_->kinetic + std::abs(last_->strain), std::abs(last_->externalWork)});
  // Schemes whose velocities are half a step behind are off by 1/(n + 1) of the energy at step n of a run that starts
  // under load.
  const double share = std::max(runawayShare, 1.5 / static_cast<double>(step + 1));
  const bool off = !(std::abs(last_->balanceError) <= share * largest_);
  if (!off)
    runaway_.reset();
  else if (!runaway_)
    runaway_ = {step, time};
}

}  // namespace ringwatch

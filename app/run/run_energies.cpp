#include <ringwatch/app/run/run_energies.h>

#include <cmath>

namespace ringwatch {

RunEnergies::RunEnergies(const Scene& scene, const Body& body, double least)
    : scene_(scene), body_(body), runaway_(least) {
  balance_.emplace(body);
}

void RunEnergies::record(const State& state, const StepEvaluation& evaluation, BodySystem& system, bool rowDue,
                         std::optional<double> dampingPower) {
  last_.reset();
  if (!needs(rowDue)) return;
  balance_->record(state.x, evaluation.internalForce);
  if (damped()) {
    system.dampingForceBesideElements(state.x, state.v, dampingForce_);
    balance_->recordDamping(state.time, state.x, state.v, dampingForce_,
                            dampingPower ? *dampingPower : system.elementDampingPower(state.x, state.v));
  }
  if (scene_.movesObstacles())
    balance_->recordObstacles(state.time, body_.discreteForces()->obstaclePower(state.x, state.v));
  if (!rowDue) return;
  last_ = balance_->energies(state.x, state.v, evaluation.strainEnergy);
  last_->externalWork += before_.externalWork;
  last_->dissipated += before_.dissipated + byHandler_;
  last_->balanceError += before_.balanceError + byHandler_;
  if (std::isfinite(last_->balanceError)) lastError_ = last_->balanceError;
}

void RunEnergies::beginBody() {
  if (last_) before_ = *last_;
  before_.balanceError = lastError_;
  last_.reset();
  byHandler_ = 0;
  balance_.emplace(body_);
}

nlohmann::ordered_json RunEnergies::save() const {
  return {{"before", energiesJson(before_)}, {"runaway", runaway_.save()}};
}

void RunEnergies::resume(const nlohmann::ordered_json& saved) {
  before_ = energiesOfJson(saved.at("before"));
  lastError_ = before_.balanceError;
  runaway_.resume(saved.at("runaway"));
}

}  // namespace ringwatch

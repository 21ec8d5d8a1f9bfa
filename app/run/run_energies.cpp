#include <ringwatch/app/run/run_energies.h>

#include <cmath>

#include <ringwatch/app/scene/integrator_catalog.h>
#include <ringwatch/base/exact_sum.h>
#include <ringwatch/body/domain.h>
#include <ringwatch/handlers/handler.h>

namespace ringwatch {

RunEnergies::RunEnergies(const Scene& scene, const Body& body, double least)
    : scene_(scene), body_(body), runaway_(least) {
  balance_.emplace(body);
}

void RunEnergies::recordDamping(const State& state, BodySystem& system) {
  if (damped()) {
    system.dampingForceBesideElements(state.x, state.v, besideElements_);
    dampingForce_ = besideElements_;
    system.addElementDampingForce(state.x, state.v, dampingForce_);
    balance_->recordDamping(state.x, dampingForce_);
  }
  if (scene_.movesObstacles())
    balance_->recordObstacles(state.time, body_.discreteForces()->obstaclePower(state.x, state.v));
}

void RunEnergies::record(const State& state, const StepEvaluation& evaluation, bool rowDue) {
  last_.reset();
  if (!needs(rowDue)) return;
  if (damped() && body_.constraints().moving())  // that of elements is in the internal force
    balance_->record(state.x, resistingForce_ = evaluation.internalForce + besideElements_);
  else
    balance_->record(state.x, evaluation.internalForce);
  if (!rowDue) return;
  last_ = balance_->energies(state.x, state.v, evaluation.strainEnergy);
  last_->externalWork += before_.externalWork;
  last_->dissipated += before_.dissipated + byHandler_;
  last_->balanceError += before_.balanceError + byHandler_;
  if (std::isfinite(last_->balanceError)) lastError_ = last_->balanceError;
}

void RunEnergies::judge(const State& state, double h, bool certified) {
  judged_ = last_;
  if (!last_ || state.a.cols() != state.v.cols()) return;
  const IntegratorInfo& info = *integratorCatalog().find(scene_.method);
  if (!takesHandler(info)) return;
  const bool lags = info.order == 1;  // v is v₋, else in the middle
  ExactSum sum;
  for (Eigen::Index i = 0; i < body_.domain().owned(body_.nodeCount()); ++i)
    sum.add(body_.lumpedMass()[i] *
            (lags ? 0.5 * state.v.col(i).dot(state.a.col(i)) : -0.125 * state.a.col(i).squaredNorm()));
  body_.domain().sum({&sum, 1});
  if (!firstHalfStep_) firstHalfStep_ = sum.value();
  const double kept = last_->balanceError + (lags ? h : h * h) * (sum.value() - *firstHalfStep_);
  if (certified && std::abs(kept) < std::abs(last_->balanceError)) judged_->balanceError = kept;
}

void RunEnergies::beginBody() {
  if (last_) before_ = *last_;
  before_.balanceError = lastError_;
  last_.reset();
  byHandler_ = 0;
  balance_.emplace(body_);
}

nlohmann::ordered_json RunEnergies::save() const {
  return {{"before", energiesJson(before_)},
          {"runaway", runaway_.save()},
          {"first_half_step", firstHalfStep_ ? nlohmann::ordered_json(*firstHalfStep_) : nullptr}};
}

void RunEnergies::resume(const nlohmann::ordered_json& saved) {
  before_ = energiesOfJson(saved.at("before"));
  lastError_ = before_.balanceError;
  runaway_.resume(saved.at("runaway"));
  if (const auto& first = saved.at("first_half_step"); !first.is_null()) firstHalfStep_ = first.get<double>();
}

}  // namespace ringwatch

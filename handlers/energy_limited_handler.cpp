#include <ringwatch/handlers/energy_limited_handler.h>

#include <algorithm>
#include <cmath>

#include <ringwatch/base/error.h>
#include <ringwatch/handlers/imex/imex.h>
#include <ringwatch/monitor/energy_balance.h>

namespace ringwatch {
namespace {

/// Steps between two looks at the energy, which cost an energy of the handled elements each: at most so many, and
/// fewer at the start, while the largest energy is small.
constexpr std::int64_t mostStepsBetweenLooks = 10;
constexpr std::int64_t stepsToLooks = 10;  // their distance is one more after each so many steps

}  // namespace

EnergyLimitedHandler::EnergyLimitedHandler(const HandlerInfo& info, Body& body, std::unique_ptr<Integrator> base,
                                           HandlerOptions options)
    : Handler(info, body, std::move(base), std::move(options)), largestEnergy_(roundingEnergy(body)) {}

void EnergyLimitedHandler::inherit(const Handler& before) {
  const auto* other = dynamic_cast<const EnergyLimitedHandler*>(&before);
  if (!other) return;
  largestEnergy_ = std::max(largestEnergy_, other->largestEnergy_);
  imexSteps_ = other->imexSteps_;
  if (other->imex_) giveUp();
}

void EnergyLimitedHandler::take(const NodeVectors& x, double h, const ElementFlags& chosen) {
  allHaveEnergy_ = std::ranges::all_of(
      elements(), [&](ElementRef e) { return body_.blocks()[e.block]->material().info().definedInverted; });
  if (!imex_) return takeOwn(x, h, chosen);
  imex_->prepareAs(*this, x);
  detach(chosen);
}

StepStatus EnergyLimitedHandler::handledStep(SecondOrderSystem& system, State& state, double h) {
  if (imex_) return imexStep(system, state, h);
  const StepStatus status = ownStep(system, state, h);
  if (limit_ == 0) return status;
  news_ = whyNotKept(status, state);
  if (news_.empty()) return status;
  news_ += ": imex takes them from here on, by nonlinear equations";
  if (status.done) takeBack(state);
  giveUp();
  imex_->prepareAs(*this, state.x);
  return imexStep(system, state, h);
}

std::string EnergyLimitedHandler::whyNotKept(const StepStatus& status, const State& state) {
  if (!status.done) return status.reason;
  if (endsWithoutEnergy(state.x)) return "a handled element would have come to where its law has no energy";
  if (++steps_ < nextLook_) return {};
  nextLook_ = steps_ + std::min(1 + steps_ / stepsToLooks, mostStepsBetweenLooks);
  if (!addsTooMuch(state)) return {};
  return joinText("the handled elements would have added more than ", limit_, " of the largest energy");
}

bool EnergyLimitedHandler::endsWithoutEnergy(const NodeVectors& x) const {
  if (allHaveEnergy_) return false;
  const auto least = leastHandledDeterminant(x);
  return least && !(least->value > 0);
}

bool EnergyLimitedHandler::addsTooMuch(const State& state) {
  const double dissipated = Handler::dissipated();
  mostDissipated_ = std::max(mostDissipated_, dissipated);
  const auto tooMuch = [&] { return !(mostDissipated_ - dissipated <= limit_ * largestEnergy_); };
  if (!tooMuch()) return false;
  const double kinetic = 0.5 * state.v.colwise().squaredNorm().dot(body_.lumpedMass()),
               energy = kinetic + std::abs(body_.energy(state.x, workspace_));
  if (std::isfinite(energy)) largestEnergy_ = std::max(largestEnergy_, energy);
  return tooMuch();
}

void EnergyLimitedHandler::giveUp() {
  closeWork();
  // With what the scheme shares with it.
  Options own;
  for (const std::string_view name : {"dissipation", "momentum"})
    if (const OptionValue* value = options_.own.find(name)) own.set(name, *value);
  imex_ = std::make_unique<Imex>(body_, makeIntegrator(base_->info().name),
                                 HandlerOptions{options_.selection, options_.margin, std::move(own), {}});
}

StepStatus EnergyLimitedHandler::imexStep(SecondOrderSystem& system, State& state, double h) {
  const StepStatus status = imex_->step(system, state, h);
  imexSteps_ += status.done ? 1 : 0;
  return status;
}

}  // namespace ringwatch

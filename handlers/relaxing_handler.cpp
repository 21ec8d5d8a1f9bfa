#include <ringwatch/handlers/relaxing_handler.h>

#include <algorithm>
#include <cmath>

#include <ringwatch/base/error.h>
#include <ringwatch/monitor/energy_balance.h>

namespace ringwatch {
namespace {

/// Steps between two looks at the energy, which cost an energy of the handled elements each: at most so many, and
/// fewer at the start, while the largest energy is small.
constexpr std::int64_t mostStepsBetweenLooks = 10;
constexpr std::int64_t stepsToLooks = 10;  // their distance is one more after each so many steps

}  // namespace

class RelaxingHandler::Relaxed final : public SecondOrderSystem {
 public:
  Relaxed(RelaxingHandler& owner, double h) : owner_(owner), h_(h) {}
  void acceleration(double, const NodeVectors& x, const NodeVectors& v, NodeVectors& a) override {
    RelaxingHandler& o = owner_;
    o.explicitAcceleration(x, a);
    o.work().begin(x, a);
    std::string reason = o.relax(x, v, h_, a);
    if (fault.empty()) fault = std::move(reason);
    o.work().end(v, a);
  }
  int threads() const override { return owner_.body_.threads(); }
  bool velocityDependent() const override { return true; }

  std::string fault;

 private:
  RelaxingHandler& owner_;
  double h_;
};

RelaxingHandler::RelaxingHandler(const HandlerInfo& info, Body& body, std::unique_ptr<Integrator> base,
                                 HandlerOptions options, std::string_view limited)
    : Handler(info, body, std::move(base), std::move(options)),
      limit_(options_.own.text("variant") == limited ? options_.own.number("energy_limit") : 0),
      largestEnergy_(roundingEnergy(body)) {}

void RelaxingHandler::inherit(const Handler& before) {
  const auto* other = dynamic_cast<const RelaxingHandler*>(&before);
  if (!other) return;
  largestEnergy_ = std::max(largestEnergy_, other->largestEnergy_);
  implicitSteps_ = other->implicitSteps_;
  if (other->implicit_) makeImplicit();
}

void RelaxingHandler::take(const NodeVectors& x, double h, const ElementFlags& chosen) {
  allHaveEnergy_ = std::ranges::all_of(
      elements(), [&](ElementRef e) { return body_.blocks()[e.block]->material().info().definedInverted; });
  if (implicit_) {
    implicit_->prepareAs(*this, x);
  } else {
    takeRelaxed(h, chosen);
    countWork(h);
  }
  detach(chosen);
}

StepStatus RelaxingHandler::handledStep(SecondOrderSystem& system, State& state, double h) {
  if (implicit_) return implicitStep(system, state, h);
  Relaxed relaxed(*this, h);
  const StepStatus status = baseStep(relaxed, state, h, relaxed.fault);
  if (limit_ == 0) return status;
  news_ = whyNotKept(status, state);
  if (news_.empty()) return status;
  news_ += ": they are implicit from here on";
  if (status.done) takeBack(state);
  makeImplicit();
  implicit_->prepareAs(*this, state.x);
  return implicitStep(system, state, h);
}

std::string RelaxingHandler::whyNotKept(const StepStatus& status, const State& state) {
  if (!status.done) return status.reason;
  if (endsWithoutEnergy(state.x)) return "a handled element would have come to where its law has no energy";
  if (++steps_ < nextLook_) return {};
  nextLook_ = steps_ + std::min(1 + steps_ / stepsToLooks, mostStepsBetweenLooks);
  if (!addsTooMuch(state)) return {};
  return joinText("the handled elements would have added more than ", limit_, " of the largest energy");
}

bool RelaxingHandler::endsWithoutEnergy(const NodeVectors& x) const {
  if (allHaveEnergy_) return false;
  const auto least = leastHandledDeterminant(x);
  return least && !(least->value > 0);
}

bool RelaxingHandler::addsTooMuch(const State& state) {
  const double dissipated = Handler::dissipated();
  mostDissipated_ = std::max(mostDissipated_, dissipated);
  const auto tooMuch = [&] { return !(mostDissipated_ - dissipated <= limit_ * largestEnergy_); };
  if (!tooMuch()) return false;
  const double kinetic = 0.5 * state.v.colwise().squaredNorm().dot(body_.lumpedMass()),
               energy = kinetic + std::abs(body_.energy(state.x, workspace_));
  if (std::isfinite(energy)) largestEnergy_ = std::max(largestEnergy_, energy);
  return tooMuch();
}

void RelaxingHandler::makeImplicit() {
  closeWork();
  implicit_ = std::make_unique<Imex>(body_, makeIntegrator(base_->info().name),
                                     HandlerOptions{options_.selection, options_.margin, {}, {}});
}

StepStatus RelaxingHandler::implicitStep(SecondOrderSystem& system, State& state, double h) {
  const StepStatus status = implicit_->step(system, state, h);
  implicitSteps_ += status.done ? 1 : 0;
  return status;
}

std::vector<HandlerFigure> RelaxingHandler::figures() const {
  std::vector<HandlerFigure> result = figuresOfPasses();
  result.push_back({"implicit_steps", static_cast<double>(implicitSteps_)});
  return result;
}

}  // namespace ringwatch

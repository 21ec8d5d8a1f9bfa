#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include <ringwatch/handlers/handler.h>

namespace ringwatch {

/// How much energy handled elements may add before imex takes them.
constexpr OptionInfo energyLimitOption(const OptionInfo::Condition& onlyWith = {}) {
  return {.name = "energy_limit",
          .range = {0, 1, true, true},
          .fallback = "0.005",
          .help =
              "imex takes the handled elements, by its nonlinear equations, where they have added this share of the "
              "largest energy, would end where their law has none, or a step fails; 0: never",
          .onlyWith = onlyWith};
}

/// A scheme for the handled elements that may add energy, with a limit on it. What such elements do to the energy is
/// counted exactly (HandledWork). Where they would have added more than the limit times the largest energy of the body,
/// where a step would end at det F <= 0 in an element of a law that has no energy there, and where a step fails, that
/// step is not kept, and from there on they are those of Imex, by its nonlinear equations: Theorem 85,
/// docs/theory/handlers.md. Bodies that come of cuts go on with it.
class EnergyLimitedHandler : public Handler {
 public:
  double dissipated() const override { return Handler::dissipated() + (imex_ ? imex_->dissipated() : 0); }
  bool provesHandledPart() const override { return imex_ ? imex_->provesHandledPart() : provesOwnPart(); }
  std::string news() override { return std::exchange(news_, {}); }

 protected:
  EnergyLimitedHandler(const HandlerInfo& info, Body& body, std::unique_ptr<Integrator> base, HandlerOptions options);
  /// A share of the largest energy of the body; 0, as it begins: none, and steps are the scheme's own for good.
  void limitEnergy(double share) { limit_ = share; }

  /// Called after a choice that is not empty, for steps of h (s) of the scheme's own from positions x (3×N, m) on: it
  /// leaves the chosen elements out of explicitBody() and counts their work.
  virtual void takeOwn(const NodeVectors& x, double h, const ElementFlags& chosen) = 0;
  /// A step by baseStep().
  virtual StepStatus ownStep(SecondOrderSystem& system, State& state, double h) = 0;
  virtual bool provesOwnPart() const { return false; }

  /// Once the limit was met; nullptr before.
  const Handler* imex() const { return imex_.get(); }
  /// Steps that it has taken.
  std::int64_t imexSteps() const { return imexSteps_; }
  /// The handled elements are those of Imex from here on.
  virtual void giveUp();

  void take(const NodeVectors& x, double h, const ElementFlags& chosen) final;
  void inherit(const Handler& before) override;
  /// system: that of the body. Where there is a limit the handler evaluates explicit and handled elements itself, and a
  /// system that counts or splits forces sees none.
  StepStatus handledStep(SecondOrderSystem& system, State& state, double h) final;

 private:
  /// "" for a step that is kept.
  std::string whyNotKept(const StepStatus& status, const State& state);
  bool endsWithoutEnergy(const NodeVectors& x) const;
  bool addsTooMuch(const State& state);
  StepStatus imexStep(SecondOrderSystem& system, State& state, double h);

  double limit_ = 0;           // of energy added, as a share of the largest
  bool allHaveEnergy_ = true;  // inverted elements too
  std::int64_t steps_ = 0, nextLook_ = 0;
  double mostDissipated_ = 0;  // J, so far
  double largestEnergy_;       // J, of the body, so far
  std::unique_ptr<Handler> imex_;
  std::int64_t imexSteps_ = 0;
  std::string news_;
  Body::Workspace workspace_;
};

}  // namespace ringwatch

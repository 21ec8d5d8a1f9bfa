#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <ringwatch/handlers/handler.h>
#include <ringwatch/handlers/imex/imex.h>

namespace ringwatch {

/// How much energy relaxed elements may add before they become implicit; for variants that are proven for small
/// strains.
constexpr OptionInfo energyLimitOption(std::span<const std::string_view> variants) {
  return {.name = "energy_limit",
          .range = {0, 1, true, true},
          .fallback = "0.005",
          .help =
              "handled elements become implicit, as with imex, where they have added this share of the largest "
              "energy, or would end where their law has none; 0: never",
          .onlyWith = {"variant", variants}};
}

/// Handled elements that leave the explicit part and, after its forces, move the predicted positions of their nodes in
/// passes. What such elements do to the energy is counted exactly (HandledWork). Where they would have added more than
/// `energy_limit` of the largest energy of the body, which crowded elements do that are softer than their law, where a
/// step would end at det F <= 0 in an element of a law that has no energy there, and where a pass is not finite, they
/// are those of Imex from there on, by its nonlinear equations and default options: Theorem 85,
/// docs/theory/handlers.md. Bodies that come of cuts go on with it.
class RelaxingHandler : public Handler {
 public:
  double dissipated() const override { return Handler::dissipated() + (implicit_ ? implicit_->dissipated() : 0); }
  bool provesHandledPart() const override { return implicit_ && implicit_->provesHandledPart(); }
  std::string news() override { return std::exchange(news_, {}); }
  /// With the steps in which the handled elements were implicit.
  std::vector<HandlerFigure> figures() const final;

 protected:
  /// limited: the variant that `energy_limit` holds for.
  RelaxingHandler(const HandlerInfo& info, Body& body, std::unique_ptr<Integrator> base, HandlerOptions options,
                  std::string_view limited);

  /// The passes are for these elements from here on, in steps of h (s).
  virtual void takeRelaxed(double h, const ElementFlags& chosen) = 0;
  /// Adds to a (3×N, m/s²), by the forces of the others, what the passes of a step from x (m) with v (m/s) do. "" or
  /// what went wrong.
  virtual std::string relax(const NodeVectors& x, const NodeVectors& v, double h, NodeVectors& a) = 0;
  virtual std::vector<HandlerFigure> figuresOfPasses() const = 0;

  void take(const NodeVectors& x, double h, const ElementFlags& chosen) final;
  void inherit(const Handler& before) final;
  bool handledBeginsWithAcceleration() const final { return implicit_ && implicit_->beginsWithAcceleration(); }
  /// system: that of the body. Relaxed elements have no force of their own there, so the handler evaluates the others
  /// itself, and a system that counts or splits forces sees none.
  StepStatus handledStep(SecondOrderSystem& system, State& state, double h) final;

 private:
  /// The base scheme's view: the acceleration that leads to the relaxed positions.
  class Relaxed;

  /// "" for a step that is kept.
  std::string whyNotKept(const StepStatus& status, const State& state);
  bool endsWithoutEnergy(const NodeVectors& x) const;
  bool addsTooMuch(const State& state);
  void makeImplicit();
  StepStatus implicitStep(SecondOrderSystem& system, State& state, double h);

  double limit_;               // of energy added, as a share of the largest; 0: none
  bool allHaveEnergy_ = true;  // inverted elements too
  std::int64_t steps_ = 0, nextLook_ = 0;
  double mostDissipated_ = 0;       // J, so far
  double largestEnergy_;            // J, of the body, so far
  std::unique_ptr<Imex> implicit_;  // once the passes were given up
  std::int64_t implicitSteps_ = 0;
  std::string news_;
  Body::Workspace workspace_;
};

}  // namespace ringwatch

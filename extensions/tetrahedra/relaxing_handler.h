#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <ringwatch/handlers/energy_limited_handler.h>

namespace ringwatch {

/// Handled elements that leave the explicit part and, after its forces, move the predicted positions of their nodes in
/// passes. Crowded elements are softer by that than their law, and add energy up to a limit (EnergyLimitedHandler).
class RelaxingHandler : public EnergyLimitedHandler {
 public:
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

  void takeOwn(const NodeVectors& x, double h, const ElementFlags& chosen) final;
  StepStatus ownStep(SecondOrderSystem& system, State& state, double h) final;

 private:
  /// The base scheme's view: the acceleration that leads to the relaxed positions.
  class Relaxed;
};

}  // namespace ringwatch

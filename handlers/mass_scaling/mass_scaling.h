#pragma once
#include <ringwatch/handlers/handler.h>

namespace ringwatch {

/// Mass scaling, the baseline of commercial codes: point masses at the nodes of the critical elements until the
/// certified bound of the whole body meets the step. With the explicit part below Σ_rest and D_e = (K_aa)^½ for each
/// critical element (which minimises the trace of l_e D_e for a single stiff mode),
///   m_i + added_i >= lambda_max(Σ_rest,i + Σ l_e D_e,i) / lambda,   lambda = ((1 - margin) limit/h)².
/// Theorem 40, docs/theory/handlers.md. Loads stay what they are. The mass goes to the Body, for good. Always uses the
/// certified selection: options with another throw InputError.
class MassScaling final : public Handler {
 public:
  // Mass is added until the step is proven.
  static constexpr std::array selections{Selection::certified};
  static constexpr HandlerInfo description{.name = "mass-scaling",
                                           .help = "adds mass to the nodes of critical elements; changes the physics",
                                           .selections = selections,
                                           .addsMass = true,
                                           .takesMassDamping = true,
                                           .takesStiffnessDamping = true};
  MassScaling(Body& body, std::unique_ptr<Integrator> base, HandlerOptions options);

  /// Added mass, kg and % of the body's own, and the lowest elastic frequencies with and without it, Hz, at the
  /// positions of the first mass that was added.
  std::vector<HandlerFigure> figures() const override;

 protected:
  void take(const NodeVectors& x, double h, const ElementFlags& chosen) override;
  StepStatus handledStep(SecondOrderSystem& system, State& state, double h) override {
    return base_->step(system, state, h);
  }
  bool stepsAsBase() const override { return true; }

 private:
  Eigen::VectorXd ownMass_, added_;  // kg, by node
  NodeVectors x_;                    // where mass was added first, m
};

}  // namespace ringwatch

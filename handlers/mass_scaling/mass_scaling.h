#pragma once
#include <cstdint>
#include <vector>

#include <ringwatch/handlers/handler.h>
#include <ringwatch/handlers/mass_scaling/step_division.h>

namespace ringwatch {

/// HandlerInfo::marginOfLaw of `mass-scaling`, for every law: the whole body takes the step there, and near the limit
/// elements that stiffen and soften feed energy. Measured: docs/handlers.md.
double marginOfMassScaling(std::string_view law);

/// Mass scaling, the baseline of commercial codes: point masses at the nodes of the critical elements until the
/// certified bound of the whole body meets the step. With the explicit part below Σ_rest and D_e = (K_aa)^½ for each
/// critical element (which minimises the trace of l_e D_e for a single stiff mode),
///   m_i + added_i >= lambda_max(Σ_rest,i + Σ l_e D_e,i) / lambda,   lambda = ((1 - margin) limit/h)².
/// Theorem 40, docs/theory/handlers.md. Loads stay what they are. The mass goes to the Body, for good. Always uses the
/// certified selection: options with another throw InputError.
///
/// Mass is added by the first choice of a body alone: mass that comes to nodes that move brings energy, and along a
/// motion that strains its elements ever more of it would. Where a later choice does not prove h, steps are n of
/// h/n of the base scheme, h/n half of what the nodal bound proves, and explicitBody() has masses that are larger by
/// the limit at h/n over that at h (n² without damping), so that its proof at h is that of the body at h/n:
/// Theorem 86. A step that would end at det F <= 0 in a critical element of a law that has no energy there is taken in
/// twice as many parts, and so on.
class MassScaling final : public Handler {
 public:
  // Mass is added until the step is proven.
  static constexpr std::array selections{Selection::certified};
  static constexpr HandlerInfo description{.name = "mass-scaling",
                                           .help = "adds mass to the nodes of critical elements; changes the physics",
                                           .selections = selections,
                                           .addsMass = true,
                                           .takesMassDamping = true,
                                           .takesStiffnessDamping = true,
                                           .marginOfLaw = marginOfMassScaling};
  MassScaling(Body& body, std::unique_ptr<Integrator> base, HandlerOptions options);

  /// Added mass, kg and % of the body's own, steps that were divided and the largest n, and the lowest elastic
  /// frequencies with and without it, Hz, at the positions where the mass was added.
  std::vector<HandlerFigure> figures() const override;
  bool certified() const override { return Handler::certified() && division_.proven(); }
  /// A while after a choice, where steps are divided.
  bool asksForChoice() const override { return division_.asksForChoice(); }
  /// n, of the steps of h/n that the last choice asked for.
  int parts() const { return division_.parts(); }
  int partsOfStep() const override { return isPart() ? parts() : 1; }

 protected:
  /// On a part of a body mass was added to the whole, before it was taken apart.
  void inherit(const Handler& before) override;
  ElementFlags choose(const NodeVectors& x, double h, const ElementFlags& keep) override;
  void take(const NodeVectors& x, double h, const ElementFlags& chosen) override;
  StepStatus handledStep(SecondOrderSystem& system, State& state, double h) override;
  bool stepsAsBase() const override { return division_.neverDivided() && allHaveEnergy_; }
  bool handledBeginsWithAcceleration() const override { return base_->beginsWithAcceleration(); }

 private:
  bool isPart() const;
  StepDivision::Limit limit() const;
  void divideSteps(const NodeVectors& x, double h);
  bool endsWithoutEnergy(const NodeVectors& x) const;
  std::vector<HandlerFigure> figuresWith(const StepDivision& division) const;

  Eigen::VectorXd ownMass_, added_;  // kg, by node
  NodeVectors x_;                    // where mass was added, m
  bool begun_ = false;               // the first choice was made
  bool allHaveEnergy_ = true;        // handled elements, inverted ones too
  StepDivision division_;
  const MassScaling* whole_ = nullptr;  // on the first process, of whose body this has a part
};

}  // namespace ringwatch

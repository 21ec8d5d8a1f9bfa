#pragma once
#include <memory>

#include <ringwatch/extensions/fe_pbd/relaxed_tetrahedra.h>
#include <ringwatch/extensions/tetrahedra/relaxing_handler.h>

namespace ringwatch {

/// Finite elements with position-based ones (Fierz 2013, section 4.2): the handled tetrahedra leave the explicit part,
/// and after its forces they move their predicted nodes towards their goal shapes, blended by shares of mass or one
/// after the other; see RelaxedTetrahedra. With P of the last pass, near rest and in the two-step form,
///   x_(n+1) = P (2 x_n - x_(n-1) + h² M⁻¹ (f_ext - K_E x_n)).
/// At an eigenvector u of the recursion, c = u·P⁻¹u/u·u >= 1 and a = h² u·M⁻¹K_E u/u·u, c z² - (2 - a) z + 1 = 0: the
/// roots have |z| <= 1 for 0 <= a <= 3 + c, and |z|² = 1/c where they are complex. So it is stable wherever the
/// explicit part alone is, by any number of passes, and damps what strains the handled elements as implicit Euler does
/// (Theorem 38, docs/theory/handlers.md). With rigid goals nothing is proven.
///
/// Handled elements follow linear elasticity in the frame that turns with them, at small strains any law here. Other
/// elements than tet4, and laws that do not turn with the element, are refused.
class FePbd final : public RelaxingHandler {
 public:
  static constexpr std::array<std::string_view, 2> variants{"linear", "rigid"};
  static constexpr std::array table{
      variantOption(variants, "linear goals, or rigid as in Fierz 2013"),
      OptionInfo{.name = "passes",
                 .type = OptionType::integer,
                 .range = {0, 32, true, true},
                 .fallback = "0",
                 .help = "over the handled elements in a step; more make crowded ones less soft; 0: 1",
                 .onlyWith = {"variant", std::span(variants).first<1>()}},
      energyLimitOption({"variant", std::span(variants).first<1>()})};
  static constexpr HandlerInfo description{.name = "fe-pbd",
                                           .help = "moves the nodes of critical tetrahedra towards goal shapes",
                                           .options = table,
                                           .relaxes = true};
  FePbd(Body& body, std::unique_ptr<Integrator> base, HandlerOptions options);

 protected:
  void takeRelaxed(double h, const ElementFlags& chosen) override;
  std::string relax(const NodeVectors& x, const NodeVectors& v, double h, NodeVectors& a) override;
  std::vector<HandlerFigure> figuresOfPasses() const override;

 private:
  GoalShape goal_;
  int passes_;
  std::unique_ptr<RelaxedTetrahedra> relaxed_;
};

}  // namespace ringwatch

#pragma once
#include <memory>
#include <optional>

#include <ringwatch/base/infinity.h>
#include <ringwatch/extensions/modal_filter/filtered_tetrahedra.h>
#include <ringwatch/extensions/modal_filter/shape_constraints.h>
#include <ringwatch/extensions/tetrahedra/relaxing_handler.h>

namespace ringwatch {

/// Modal filter by element (Fierz 2013, section 4.1): handled tetrahedra act in the explicit part with the stiffness
/// K' that the step allows them (modal_filter.h), turned with them, f_a = R K' (Rᵀx - X), and the modes that are
/// filtered out hold by constraints on the predicted positions x* = x + h (v + h a):
///
/// projection, Fierz 2013's: rigid constraints by the shape of the element, met by fast projection
/// (shape_constraints.h). Fails where they contradict each other.
///
/// compliant (FilteredTetrahedra): the filtered-out modes themselves, C_k = b_k·(Rᵀx - X), each with the compliance of
/// its stiffness (XPBD, Macklin et al. 2016), so that they are implicit Euler for K - K' with R held. Always solvable.
/// Block Gauss–Seidel forward and back over the elements: near rest, any number of passes moves the nodes by (I + h²
/// M⁻¹ Σ(K - K'))⁻¹ ≼ P ≼ I, and the step is stable as in FePbd (Theorems 37 and 38, docs/theory/handlers.md).
///
/// Allowances of stiffness: the element's own lumped mass times ω²_max with the Selection::elementFrequency, Fierz
/// 2013's; with `certified` an even share of what the bound of the other elements leaves at each node. Either way K_E +
/// K' ≼ ω²_max M at the state of the choice, the explicit part is proven stable (Theorem 39).
///
/// Handled elements follow linear elasticity in the frame that turns with them, at small strains any law here; the
/// linear law and other elements than tet4 are refused. Forces and constraints of the compliant variant are free of
/// torque about x; those of the projection about the positions it ends at.
class ModalFilter final : public RelaxingHandler {
 public:
  static constexpr std::array<std::string_view, 2> variants{"compliant", "projection"};
  static constexpr auto compliantAlone = std::span(variants).first<1>(),
                        projectionAlone = std::span(variants).last<1>();
  static constexpr std::array table{
      variantOption(variants, "compliant constraints, or by projection as in Fierz 2013"),
      OptionInfo{.name = "passes",
                 .type = OptionType::integer,
                 .range = {0, infinity, true, true},
                 .fallback = "0",
                 .help = "over the handled elements in a step; more make crowded ones less soft; 0: 1",
                 .onlyWith = {"variant", compliantAlone}},
      energyLimitOption({"variant", compliantAlone}),
      OptionInfo{.name = "tolerance",
                 .range = {0, 1, false, true},
                 .automatic = true,
                 .fallback = "auto",
                 .help = "of the projected constraints; auto 1e-8",
                 .onlyWith = {"variant", projectionAlone}},
      OptionInfo{.name = "iterations",
                 .type = OptionType::integer,
                 .range = {1, infinity, true, true},
                 .fallback = "200",
                 .help = "of the projection, at most",
                 .onlyWith = {"variant", projectionAlone}}};
  // Handled elements stay in the explicit part, which needs a proof.
  static constexpr std::array selections{Selection::certified, Selection::elementFrequency};
  static constexpr HandlerInfo description{.name = "modal-filter",
                                           .help = "critical tetrahedra softened, and held by constraints",
                                           .alias = "filtered",
                                           .options = table,
                                           .selections = selections,
                                           .relaxes = true};
  ModalFilter(Body& body, std::unique_ptr<Integrator> base, HandlerOptions options);

 protected:
  void takeRelaxed(double h, const ElementFlags& chosen) override;
  /// Handled elements pull with K' instead of their own force.
  std::string relax(const NodeVectors& x, const NodeVectors& v, double h, NodeVectors& a) override;
  std::vector<HandlerFigure> figuresOfPasses() const override;

 private:
  bool projects_;
  int passes_;
  std::unique_ptr<FilteredTetrahedra> tetrahedra_;
  std::optional<ConstraintProjection> projection_;
  NodeVectors predicted_, projected_;
};

}  // namespace ringwatch

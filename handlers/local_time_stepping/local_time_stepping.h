#pragma once
#include <optional>

#include <ringwatch/handlers/energy_limited_handler.h>
#include <ringwatch/handlers/local_time_stepping/level_filter.h>
#include <ringwatch/handlers/local_time_stepping/level_watch.h>

namespace ringwatch {

/// HandlerInfo::marginOfLaw of `local-time-stepping`: a law that stiffens within a step takes the fine elements out of
/// the range of their filters, and the step is lost with them. Measured over meshes and loads: docs/handlers.md.
double marginOfLocalTimeStepping(std::string_view law);

/// Local time stepping by elements (Fierz 2013, section 4.4): level 0 takes the step h, level k a whole fraction
/// of it, and only nodes of fine elements are examined within a step. Leapfrog local time stepping in the form of
/// Diaz & Grote (2009, 2015), split by elements: with the other forces frozen, the fine elements' forces along a motion
/// that starts from rest at x_n are averaged over the step,
///   a_n = E_0 (M⁻¹ (f_ext - f_0(x_n)) - M⁻¹ Σ_(k>=1) f_k(x_n + α h ṽ_n)),   v ← v + h a_n,   x ← x + h v,
/// E_0 as in LevelFilter, α the dissipation, ṽ the velocity without the rigid motion of its cluster of fine elements.
/// Any base scheme with these steps (handler.h); order two for α = 0.
///
/// Plain local time stepping ("plain") is unstable where a fine mode makes an odd number of half swings in
/// a step of its neighbours. The filters Q_k of the stabilised one leave room for those. With G_1 = 4, r_1 = 1 + 2α,
/// r_k = 1 for the others, K_k the tangent of level k, τ_k its step and p_k = τ_(k-1)/τ_k, it is stable for a frozen
/// tangent when
///   K_(k-1) ≼ M_k/τ_(k-1)²,   K_n ≼ G_(n+1) M/τ_n²,   Q_k(b) (c_k + r_k b) <= G_k for 0 <= b <= p_k² G_(k+1),
/// M_k the lumped mass times c_k at nodes of levels k and deeper, and times G_k at all others. By induction from the
/// deepest level, K_k + r_(k+1) Σ_(i>k) K_i ≼ (G_(k+1)/τ_k²) M E_k⁻¹: the spectrum of B_k is then in the range of Q_k,
/// and E_(k-1)⁻¹ = E_k^-½ Q_k(B_k)⁻¹ E_k^-½ is 1 at the other nodes and at least
/// (c_k E_k⁻¹ + r_k τ_(k-1)² M⁻¹ Σ_(i>=k) K_i)/G_k at those of levels k and deeper, where E_k⁻¹ >= 1. At the top that
/// is K_0 + (1 + 2α) Σ K_k ≼ (4/h²) M E_0⁻¹: with the quotients b of h² E_0 M⁻¹ K and d of its fine part, z² - (2 - b -
/// α d) z + 1 - α d = 0, whose roots have |z| <= 1 for 0 <= d <= b and b + 2 α d <= 4. Theorem 36,
/// docs/theory/handlers.md, has all of it. The certified selection proves
/// each level's tangent; levels, p_k among them, are chosen for the least number of evaluations by the reduced 1-rings.
/// With Selection::fierzRing nothing is proven.
///
/// Elements that need a step below h/2^levels are implicit: E_n⁻¹ = 1 + M⁻¹ w K̂ with w = 1.1 r τ_n²/G_(n+1), K̂ of
/// ImplicitCluster and r that of the last level, carries every K_I ≼ 1.1 K̂ by the same induction, at one solve of their
/// clusters for each evaluation of the last level.
///
/// explicitBody() has the elements of level 0 on M_1/4: its critical step is h where the proof for level 0 ends. Finer
/// levels are proven where they are chosen, with the margin, and watched by uncertifiedPart(); a step whose averaged
/// force outgrows the force fails. What the elements add to the energy while their tangents change within steps has a
/// limit (EnergyLimitedHandler).
class LocalTimeStepping final : public EnergyLimitedHandler {
 public:
  static constexpr std::array<std::string_view, 2> variants{"stabilised", "plain"};
  static constexpr std::array table{
      variantOption(variants, "stabilised (damped local time stepping) or plain, which has resonances"),
      OptionInfo{.name = "levels",
                 .type = OptionType::integer,
                 .range = {1, 12, true, true},
                 .fallback = "6",
                 .help = "finest step is step/2^levels; elements that need a smaller one are implicit"},
      OptionInfo{.name = "dissipation",
                 .range = {0, 1, true, true},
                 .fallback = "0.1",
                 .help = "of the handled elements: 0 none and second order"},
      solverOption,
      solverToleranceOption,
      solverIterationsOption,
      momentumOption,
      energyLimitOption(),
      onFailureOption};
  // Levels split the mass of a node, and the bound by single elements needs each to have its own.
  static constexpr std::array selections{Selection::certified, Selection::fierzRing};
  static constexpr HandlerInfo description{.name = "local-time-stepping",
                                           .help = "smaller steps where they are needed, by levels h/2^k",
                                           .alias = "adaptive",
                                           .options = table,
                                           .selections = selections,
                                           .takesMassDamping = true,
                                           .marginOfLaw = marginOfLocalTimeStepping};
  LocalTimeStepping(Body& body, std::unique_ptr<Integrator> base, HandlerOptions options);
  std::vector<HandlerFigure> figures() const override;
  /// A finer level whose tangent is above what its filter takes. Of implicit elements nothing is said.
  std::string uncertifiedPart(const NodeVectors& x) override;

  /// One level of the choice.
  struct Level {
    int substeps = 1;        // its step is h/substeps
    double lambda = 0;       // its tangent is at most this times M, rad²/s², M shared where finer elements are
    double massShare = 1;    // of the lumped mass, at nodes of finer elements
    ElementFlags elements;   // [block][element]
    ChebyshevFilter filter;  // over the step of the level above; not of level 0
  };
  /// Level 0 first; empty where nothing is handled.
  const std::vector<Level>& levels() const { return levels_; }
  /// Elements that are implicit.
  const ElementFlags& implicitElements() const { return implicit_; }
  /// Evaluations of an element in a step, summed over all elements.
  std::int64_t evaluations() const;

 protected:
  ElementFlags choose(const NodeVectors& x, double h, const ElementFlags& keep) override;
  void takeOwn(const NodeVectors& x, double h, const ElementFlags& chosen) override;
  /// system: that of the body. Its forces are evaluated level by level, thus by the handler: a system that counts or
  /// splits forces sees none.
  StepStatus ownStep(SecondOrderSystem& system, State& state, double h) override;
  /// All levels are proven and watched; implicit elements are not.
  bool provesOwnPart() const override {
    return stabilised_ && options_.selection == Selection::certified && chosenElements(implicit_).empty();
  }
  void giveUp() override;

 private:
  class Averaged;
  /// The levels that cost least by an estimate of each element's highest eigenvalue, without their elements.
  std::vector<Level> plan(const std::vector<std::vector<double>>& lambdas, double h) const;
  double deepest(double h) const;
  /// What the fine elements' tangents weigh beside those of level 0, more with mass damping: Theorem 64.
  double topWeight(double h) const;
  /// The lumped mass, at nodes of some elements a share of it.
  Eigen::VectorXd massBeside(const ElementFlags& finer, double share) const;
  /// The elements among `left` that a level cannot have, and those of `finer`. Adds to the evaluations what it took.
  ElementFlags finerThan(const Level& level, const ElementFlags& left, const NodeVectors& x, ElementFlags finer,
                         std::int64_t& evaluations) const;
  void averagedAcceleration(const NodeVectors& x, const NodeVectors& v, double h, NodeVectors& a);
  void addStrainVelocity(const NodeVectors& x, const NodeVectors& v, double share);

  bool stabilised_;
  int levelLimit_;
  double dissipation_;
  bool keepsMomentum_;
  ClusterOptions cluster_;
  std::vector<Level> levels_;
  ElementFlags implicit_;
  std::optional<LevelFilter> filter_;
  std::vector<LevelWatch> watches_;  // of the finer levels that have elements; made at the first observation
  /// Fine elements that share nodes.
  struct FineCluster {
    std::vector<std::int32_t> places;  // in filter_->nodes()
    std::vector<std::int32_t> nodes;   // of the body
    bool freeOfTorque;                 // angular momentum is kept
  };
  std::vector<FineCluster> fineClusters_;
  double idealShare_ = 0;  // Σ max(1, h/h_e) over Σ h/h_min
  double smallest_ = 0;    // h/h_min
  NodeVectors fineX_, fineA_;
  std::string fault_;
};

}  // namespace ringwatch

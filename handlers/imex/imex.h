#pragma once
#include <ringwatch/handlers/energy_limited_handler.h>
#include <ringwatch/handlers/imex/implicit_cluster.h>
#include <ringwatch/handlers/imex/newton_cluster.h>

namespace ringwatch {

/// HandlerInfo::forGpu of `imex`: conjugate gradients alone, to a tolerance of 1e-8. They start from nothing there, and
/// what they leave out of the momentum is not put back; nor is angular momentum kept.
std::string imexForGpu(Options& own);

/// Implicit-explicit integration by elements (Fierz 2013, section 4.3; Hughes & Liu 1978): the base scheme for all
/// elements but the handled ones, Newmark's method for those, with gamma = 1/2 + α and beta = (1 + α)²/4, α the
/// dissipation. α = 0 is the trapezoidal rule, of second order; α = 1 is implicit Euler, Fierz 2013's. With the solver
/// `newton` the handled elements' force is that at x_n + alpha h v_(n-½) + beta h² a_n (NewtonCluster). The others are
/// linearly implicit, the first step of Newton's method with K̂ for their tangent: in the two-step form, with the
/// internal force f(x) of all elements and K̂ of the handled ones,
///   (M + beta h² K̂) a_n = f_ext - f(x_n) - α h K̂ v_(n-½),   v_(n+½) = v_(n-½) + h a_n,   x_(n+1) = x_n + h v_(n+½).
/// One force of each element a step, with `newton` more of the handled ones, and a solve on their nodes alone, cluster
/// by cluster.
///
/// Stable, for a frozen tangent K(x) = K_E + K_I, when K_E + K_I ≼ (4/h²) M + (1 + α²) K̂: with the quotients a of
/// h² K(x) and b of h² K̂ over M at an eigenvector of the recursion,
///   (1 + beta b) z² - (2 - a + (2 beta - α) b) z + 1 + (beta - α) b = 0,
/// whose roots have |z| <= 1 for 0 <= a <= 4 + (1 + α²) b. With K_E ≼ (4/h²) M, which the certified selection proves,
/// it holds whenever K_I ≼ (1 + α²) K̂, which is assumed, up to a limit on the energy that the elements add
/// (EnergyLimitedHandler), and with `newton`, where K̂ is K_I, is so. Theorems 34 and 61,
/// docs/theory/handlers.md. With Rayleigh damping the damping force is that of all elements at v_(n-½), and h/2 beta_K
/// is added to beta h² on the left: Theorem 64. Not with `newton`.
class Imex final : public EnergyLimitedHandler {
 public:
  static constexpr std::string_view newton = "newton", linear = "linear";
  static constexpr std::array<std::string_view, 5> solvers{"auto", newton, linear, "cholesky", "cg"};
  static constexpr std::array<std::string_view, 4> solversWithTolerance{"auto", newton, linear, "cg"};
  static constexpr std::array<std::string_view, 3> linearSolvers{linear, "cholesky", "cg"};
  static constexpr std::array table{
      OptionInfo{.name = "dissipation",
                 .range = {0, 1, true, true},
                 .fallback = "0.1",
                 .help = "of the handled elements: 0 none and second order, 1 implicit Euler"},
      OptionInfo{
          .name = "solver",
          .type = OptionType::text,
          .choices = solvers,
          .fallback = "auto",
          .help = "of the implicit equations: nonlinear ones by Newton's method, or linear ones, factored and turned "
                  "with the elements (cholesky) or by conjugate gradients (cg), by the size of each cluster (linear); "
                  "auto is newton, but for linear laws, with damping and on a GPU"},
      withSolvers(solverToleranceOption, solversWithTolerance),
      withSolvers(solverIterationsOption, solversWithTolerance),
      momentumOption,
      energyLimitOption({"solver", linearSolvers}),
      onFailureOption};
  static constexpr HandlerInfo description{.name = "imex",
                                           .help = "implicit where the step is too large, explicit elsewhere",
                                           .options = table,
                                           .takesMassDamping = true,
                                           .takesStiffnessDamping = true,
                                           .forGpu = imexForGpu};
  Imex(Body& body, std::unique_ptr<Integrator> base, HandlerOptions options);
  std::vector<HandlerFigure> figures() const override;
  const std::vector<ImplicitCluster>& clusters() const { return clusters_; }
  std::string whyNotInParts() const override;

 protected:
  void takeOwn(const NodeVectors& x, double h, const ElementFlags& chosen) override;
  /// system: that of the body. Without damping its forces are evaluated by the handler, those of the explicit and those
  /// of the handled elements: a system that counts or splits forces sees none.
  StepStatus ownStep(SecondOrderSystem& system, State& state, double h) override;
  /// Nonlinear equations prove what linear ones assume: Theorem 61.
  bool provesOwnPart() const override { return nonlinear_; }
  bool handledBeginsWithAcceleration() const override {
    return options_.damping.any() && base_->beginsWithAcceleration() && baseAcceleration_.cols() == 0;
  }

 private:
  /// The base scheme's view: the acceleration that the implicit elements allow.
  class Corrected;

  std::vector<HandlerFigure> figuresOfClusters() const;
  ImplicitScheme schemeOf(double h) const { return {h, dissipation_, options_.damping.beta}; }

  double dissipation_;
  bool nonlinear_, keepsMomentum_;
  ClusterOptions cluster_;
  std::vector<ImplicitCluster> clusters_;  // one of the two is empty
  std::vector<NewtonCluster> newtonClusters_;
  std::vector<bool> freeOfTorque_;         // by cluster: angular momentum is kept
  NewtonCounts countsBefore_;              // of the choices before: stalls and steps of implicit Euler
  std::vector<std::string_view> reasons_;  // scratch
};

}  // namespace ringwatch

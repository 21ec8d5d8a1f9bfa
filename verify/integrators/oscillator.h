#pragma once
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include <ringwatch/integrators/additive_system.h>
#include <ringwatch/integrators/integrator.h>
#include <ringwatch/verify/report.h>

namespace ringwatch {

/// Studies of any integrator, the library's or your own, on ẍ = -omega² x - 2 ξ omega ẋ, whose answer is known. They
/// see the integrator from outside only: states in, states out.

/// Makes a fresh integrator for a study.
using IntegratorFactory = std::function<std::unique_ptr<Integrator>()>;

/// Oscillators, one for each component of one node: frequency omega (rad/s), damping ratio ξ, unit mass.
class Oscillator final : public DifferentiableSystem {
 public:
  explicit Oscillator(double omega = 1, double dampingRatio = 0) : Oscillator(omega, dampingRatio, 0) {}
  /// alpha: mass-proportional damping, 1/s, added to that of the ratio.
  Oscillator(double omega, double dampingRatio, double alpha)
      : omega_(omega), alpha_(2 * dampingRatio * omega + alpha) {}
  void acceleration(double, const NodeVectors& x, const NodeVectors& v, NodeVectors& a) override {
    a = -(omega_ * omega_) * x;
    if (alpha_ != 0) a -= alpha_ * v;
    ++evaluations_;
  }
  bool velocityDependent() const override { return alpha_ != 0; }
  const Eigen::VectorXd& mass() const override { return mass_; }
  RayleighDamping damping() const override { return {alpha_, 0}; }
  void stiffnessProduct(const NodeVectors&, const NodeVectors& u, NodeVectors& Ku) override {
    Ku = (omega_ * omega_) * u;
  }
  Eigen::SparseMatrix<double> stiffness(const NodeVectors&) override {
    Eigen::SparseMatrix<double> K(3, 3);
    K.setIdentity();
    return omega_ * omega_ * K;
  }
  /// Evaluations of the acceleration so far.
  std::int64_t evaluations() const { return evaluations_; }
  /// Exact position and velocity after t seconds from (x0, v0).
  Eigen::Vector2d exact(double t, double x0, double v0) const;

 private:
  double omega_, alpha_;
  Eigen::VectorXd mass_ = Eigen::VectorXd::Ones(1);
  std::int64_t evaluations_ = 0;
};

/// The same oscillator with its stiffness in two parts: the share `stiffShare` of omega², and the damping, in the stiff
/// one.
class AdditiveOscillator final : public AdditiveSystem {
 public:
  AdditiveOscillator(double omega, double dampingRatio, double stiffShare)
      : nonstiff_(omega * std::sqrt(1 - stiffShare), 0),
        stiff_(omega * std::sqrt(stiffShare), 0, 2 * dampingRatio * omega) {}
  Oscillator& nonstiff() override { return nonstiff_; }
  Oscillator& stiff() override { return stiff_; }
  bool velocityDependent() const override { return stiff_.velocityDependent(); }

 private:
  Oscillator nonstiff_, stiff_;
};

/// One step as a linear map, found by stepping unit vectors.
struct TransitionMatrix {
  /// (omega x, v) of the last `memory` states -> the next, as a companion matrix: 2×2 for a one-step method.
  Eigen::MatrixXd matrix;
  int memory = 1;      // states that the next one depends on
  bool found = false;  // false: a step failed, or the method is no linear recursion of up to two steps
  double spectralRadius() const;
};
/// z = h·omega. An integrator that remembers (the last acceleration, say) is observed after its start; a two-step
/// method gives a companion matrix of twice the size. stiffShare: of omega² that is in the stiff part, for partitioned
/// integrators.
TransitionMatrix transitionMatrix(const IntegratorFactory& make, double z, double dampingRatio, double stiffShare = 0);

/// Largest z = h·omega up to which the integrator is stable at every smaller step, by scan and bisection of the
/// spectral radius to 1e-10 relative; 0 when it is unstable from the start, however weakly, infinity when stable
/// up to `end`. Throws NumericalError when the integrator has no transition matrix. stiffShare as above: the frequency
/// is that of the whole.
double measureStabilityLimit(const IntegratorFactory& make, double dampingRatio = 0, double end = 100,
                             double stiffShare = 0);

/// Spectral radius over a grid: radius(i, j) at z[i], ξ[j]; NaN where there is none.
Eigen::MatrixXd stabilityMap(const IntegratorFactory& make, const std::vector<double>& z,
                             const std::vector<double>& dampingRatios);

/// Error of (omega x, v) at t = 1/omega·T, T = 1, from (1, 0.5), with n steps: Euclidean norm. Partitioned integrators
/// get half of omega² in the stiff part.
double oscillatorError(const IntegratorFactory& make, int steps, double dampingRatio);
/// Order of an error by the number of steps: from the two finest of a ladder of halved steps whose error lies above
/// `least`, which is rounding.
double orderOf(const std::function<double(int steps)>& error, double least = 1e-11);
/// That of oscillatorError().
double measureOrder(const IntegratorFactory& make, double dampingRatio);

/// How a principal pair of eigenvalues ρ exp(±iφ) of an undamped step differs from the exact exp(±iz), per period.
struct PeriodErrors {
  double phase;      // (φ - z)/z: positive when the numerical solution is ahead
  double amplitude;  // ρ^(2π/z) - 1: positive when it grows
};
PeriodErrors periodErrors(const IntegratorFactory& make, double z);

/// Behaviour of the undamped oscillator's energy. drift: relative change of the scheme's own quadratic invariant (the
/// modified energy yᵀ S y, S the symmetric part of J T, which a step multiplies by det T): without the bounded
/// oscillation that the energy proper has from step to step, so that a drift of one part in 1e9 shows. oscillation:
/// largest deviation of the energy proper.
struct EnergyDrift {
  double drift;
  double oscillation;
};
/// After `periods` periods, by powers of the transition matrix; the oscillation is that of one period. NaN when the
/// method is not a one-step map.
EnergyDrift energyDriftByPowers(const IntegratorFactory& make, double z, double periods);
/// The drift by stepping, all periods examined.
EnergyDrift energyDriftBySteps(const IntegratorFactory& make, double z, double periods);

/// |state after n steps forward and n steps back - start| over |start|, undamped, n = 100.
double reversalError(const IntegratorFactory& make, double z);
/// |det T - 1| of the undamped one-step map: zero for a symplectic one (in one degree of freedom area is all).
double symplecticityDefect(const IntegratorFactory& make, double z);

/// Critical step of a real run, s, by bisection between two steps: the largest h for which `steps` steps from `start`
/// keep the state finite and the largest velocity below `growth` times what the first tenth of the run at `low`
/// reached. `low` must pass and `high` must fail, else NaN. The system must not change from run to run.
struct ObservedStepOptions {
  int steps = 2000;
  double growth = 1e3;
  double tolerance = 1e-5;  // relative, on h
};
double observedCriticalStep(const IntegratorFactory& make, SecondOrderSystem& system, const State& start, double low,
                            double high, const ObservedStepOptions& options = {});

}  // namespace ringwatch

#include <ringwatch/verify/integrators/oscillator.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include <Eigen/QR>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/integrators/stability_limit.h>
#include <ringwatch/verify/matrix_eigenvalues.h>
#include <ringwatch/verify/study_bodies.h>

namespace ringwatch {
namespace {

using detail::nan;

/// Two oscillators side by side in components 0 and 1, started at the unit vectors.
State unitVectors() {
  State state;
  state.x = NodeVectors::Zero(3, 1);
  state.v = NodeVectors::Zero(3, 1);
  state.x(0, 0) = 1;
  state.v(1, 0) = 1;
  return state;
}
/// Columns: where the unit vectors are; omega = 1.
Eigen::Matrix2d columns(const State& state) {
  return (Eigen::Matrix2d() << state.x(0, 0), state.x(1, 0), state.v(0, 0), state.v(1, 0)).finished();
}

/// The oscillator of omega = 1 in the form that the integrator takes.
std::unique_ptr<SecondOrderSystem> oscillatorFor(const Integrator& integrator, double dampingRatio, double stiffShare) {
  if (integrator.info().partitioned) return std::make_unique<AdditiveOscillator>(1, dampingRatio, stiffShare);
  return std::make_unique<Oscillator>(1, dampingRatio);
}

/// A with A [y_k … ] = [y_(k+1) …] in the sense of least squares of least norm, from states Y[first …].
Eigen::MatrixXd fitRecursion(const std::vector<Eigen::Matrix2d>& Y, std::size_t first, int memory) {
  const std::size_t m = memory;
  Eigen::MatrixXd past(2 * memory, 2 * memory), next(2, 2 * memory);
  for (std::size_t c = 0; c < m; ++c) {
    for (std::size_t r = 0; r < m; ++r)
      past.block<2, 2>(static_cast<Eigen::Index>(2 * r), static_cast<Eigen::Index>(2 * c)) = Y[first + c + m - 1 - r];
    next.block<2, 2>(0, static_cast<Eigen::Index>(2 * c)) = Y[first + c + m];
  }
  return past.transpose().completeOrthogonalDecomposition().solve(next.transpose()).transpose();
}

bool predicts(const Eigen::MatrixXd& A, const std::vector<Eigen::Matrix2d>& Y, std::size_t first, int memory) {
  const std::size_t m = memory;
  for (std::size_t k = first + m; k < Y.size(); ++k) {
    Eigen::Matrix2d y = Eigen::Matrix2d::Zero();
    double size = Y[k].norm();
    for (std::size_t r = 0; r < m; ++r) {
      y += A.block<2, 2>(0, static_cast<Eigen::Index>(2 * r)) * Y[k - 1 - r];
      size = std::max(size, Y[k - 1 - r].norm());
    }
    if (!((y - Y[k]).norm() <= 1e-9 * size)) return false;
  }
  return true;
}

/// The Jury conditions stay sharp where two eigenvalues meet, which the spectral radius does not.
bool isStable(const TransitionMatrix& T) {
  return T.memory == 1 ? isStableAmplification(T.matrix) : T.spectralRadius() <= 1 + 1e-11;
}

}  // namespace

double TransitionMatrix::spectralRadius() const {
  if (!found) return nan;
  if (memory == 1) {
    // In closed form, so that a pair on the unit circle keeps radius √det to the last bits.
    const double half = 0.5 * matrix.trace(), det = matrix(0, 0) * matrix(1, 1) - matrix(0, 1) * matrix(1, 0);
    const double inside =
        0.25 * (matrix(0, 0) - matrix(1, 1)) * (matrix(0, 0) - matrix(1, 1)) + matrix(0, 1) * matrix(1, 0);
    return inside > 0 ? std::abs(half) + std::sqrt(inside) : std::sqrt(std::max(det, 0.0));
  }
  return eigenvaluesOf(matrix).cwiseAbs().maxCoeff();
}

TransitionMatrix transitionMatrix(const IntegratorFactory& make, double z, double dampingRatio, double stiffShare) {
  const std::unique_ptr<Integrator> integrator = make();
  const auto oscillator = oscillatorFor(*integrator, dampingRatio, stiffShare);
  State state = unitVectors();
  std::vector<Eigen::Matrix2d> Y{columns(state)};
  TransitionMatrix result;
  for (int k = 0; k < 7; ++k) {
    if (!integrator->step(*oscillator, state, z).done || !state.x.allFinite() || !state.v.allFinite()) return result;
    Y.push_back(columns(state));
  }
  struct Attempt {
    std::size_t first;
    int memory;
  };
  for (const Attempt attempt : {Attempt{0, 1}, Attempt{1, 1}, Attempt{1, 2}}) {
    const Eigen::MatrixXd A = fitRecursion(Y, attempt.first, attempt.memory);
    if (!predicts(A, Y, attempt.first, attempt.memory)) continue;
    result.found = true;
    result.memory = attempt.memory;
    result.matrix = Eigen::MatrixXd::Zero(2 * attempt.memory, 2 * attempt.memory);
    result.matrix.topRows<2>() = A;
    if (attempt.memory == 2) result.matrix.block<2, 2>(2, 0).setIdentity();
    break;
  }
  return result;
}

double measureStabilityLimit(const IntegratorFactory& make, double dampingRatio, double end, double stiffShare) {
  const auto stable = [&](double z) {
    const TransitionMatrix T = transitionMatrix(make, z, dampingRatio, stiffShare);
    if (!T.found)
      throw NumericalError(joinText("integrator ", make()->info().name, ": no linear step at h·omega = ", z));
    return isStable(T);
  };
  // Heavily damped modes have their fast eigenvalue near 2 ξ omega: the scan goes in units of it. Beyond the limits of
  // explicit schemes it gets coarser.
  const double unit = 1 / (1 + 2 * dampingRatio);
  double low = 0, high = 0.02 * unit;
  if (!stable(high)) return 0;
  do {
    low = high;
    high += (high < 8 * unit ? 0.005 * unit : 0.02 * high);
    if (high > end) return infinity;
  } while (stable(high));
  while (high - low > 1e-11 * high) {
    const double middle = 0.5 * (low + high);
    (stable(middle) ? low : high) = middle;
  }
  // A genuine limit is crossed with a slope. Where the radius has only just crept over the slack for rounding, it has
  // been above one all along.
  return transitionMatrix(make, 1.001 * low, dampingRatio, stiffShare).spectralRadius() < 1 + 1e-9 ? 0 : low;
}

Eigen::MatrixXd stabilityMap(const IntegratorFactory& make, const std::vector<double>& z,
                             const std::vector<double>& dampingRatios) {
  Eigen::MatrixXd map(z.size(), dampingRatios.size());
  for (std::size_t i = 0; i < z.size(); ++i)
    for (std::size_t j = 0; j < dampingRatios.size(); ++j)
      map(i, j) = transitionMatrix(make, z[i], dampingRatios[j]).spectralRadius();
  return map;
}

double oscillatorError(const IntegratorFactory& make, int steps, double dampingRatio) {
  const std::unique_ptr<Integrator> integrator = make();
  const auto oscillator = oscillatorFor(*integrator, dampingRatio, 0.5);
  State state = unitVectors();
  state.v(0, 0) = 0.5;
  for (int k = 0; k < steps; ++k)
    if (!integrator->step(*oscillator, state, 1.0 / steps).done) return nan;
  return (Eigen::Vector2d(state.x(0, 0), state.v(0, 0)) - Oscillator(1, dampingRatio).exact(1, 1, 0.5)).norm();
}

double orderOf(const std::function<double(int steps)>& error, double least) {
  double coarse = error(8), order = nan;
  for (int steps = 16; steps <= 512; steps *= 2) {
    const double fine = error(steps);
    if (!(fine > least)) break;
    order = std::log2(coarse / fine);
    coarse = fine;
  }
  return order;
}

double measureOrder(const IntegratorFactory& make, double dampingRatio) {
  return orderOf([&](int steps) { return oscillatorError(make, steps, dampingRatio); });
}

PeriodErrors periodErrors(const IntegratorFactory& make, double z) {
  const TransitionMatrix T = transitionMatrix(make, z, 0);
  if (!T.found) return {nan, nan};
  const Eigen::VectorXcd values = eigenvaluesOf(T.matrix);
  // The principal pair is the one nearest to exp(±iz).
  const std::complex<double> exact = std::polar(1.0, z);
  std::complex<double> principal = values[0];
  for (const auto& value : values)
    if (std::abs(value - exact) < std::abs(principal - exact)) principal = value;
  return {(std::abs(std::arg(principal)) - z) / z, std::pow(std::abs(principal), 2 * std::numbers::pi / z) - 1};
}

namespace {

/// yᵀ S y with S the symmetric part of J T, J the quarter turn: a step multiplies it by det T, exactly, since Tᵀ J T =
/// det T · J. For small steps it is proportional to the energy.
double modifiedEnergy(const Eigen::Matrix2d& T, const Eigen::Vector2d& y) {
  const Eigen::Vector2d Ty = T * y;
  return y[0] * Ty[1] - y[1] * Ty[0];
}

}  // namespace

EnergyDrift energyDriftByPowers(const IntegratorFactory& make, double z, double periods) {
  const TransitionMatrix T = transitionMatrix(make, z, 0);
  if (!T.found || T.memory != 1) return {nan, nan};
  const Eigen::Vector2d start(1, 0);
  double oscillation = 0;
  Eigen::Vector2d y = start;
  for (auto k = static_cast<std::int64_t>(std::ceil(2 * std::numbers::pi / z)); k > 0; --k) {
    y = T.matrix * y;
    oscillation = std::max(oscillation, std::abs(y.squaredNorm() - 1));
  }
  // T^n by squaring.
  Eigen::Matrix2d power = Eigen::Matrix2d::Identity(), square = T.matrix;
  for (auto n = static_cast<std::int64_t>(std::llround(periods * 2 * std::numbers::pi / z)); n > 0; n >>= 1) {
    if (n & 1) power = square * power;
    square = square * square;
  }
  if (!power.allFinite()) return {infinity, oscillation};
  return {modifiedEnergy(T.matrix, power * start) / modifiedEnergy(T.matrix, start) - 1, oscillation};
}

EnergyDrift energyDriftBySteps(const IntegratorFactory& make, double z, double periods) {
  const TransitionMatrix T = transitionMatrix(make, z, 0);
  if (!T.found || T.memory != 1) return {nan, nan};
  const std::unique_ptr<Integrator> integrator = make();
  const auto oscillator = oscillatorFor(*integrator, 0, 0);
  State state = unitVectors();
  double oscillation = 0;
  const auto steps = static_cast<std::int64_t>(std::llround(periods * 2 * std::numbers::pi / z));
  for (std::int64_t k = 0; k < steps; ++k) {
    if (!integrator->step(*oscillator, state, z).done) return {nan, nan};
    oscillation = std::max(oscillation, std::abs(state.x(0, 0) * state.x(0, 0) + state.v(0, 0) * state.v(0, 0) - 1));
  }
  const Eigen::Vector2d start(1, 0), end(state.x(0, 0), state.v(0, 0));
  if (!std::isfinite(end.squaredNorm())) return {infinity, infinity};
  return {modifiedEnergy(T.matrix, end) / modifiedEnergy(T.matrix, start) - 1, oscillation};
}

double reversalError(const IntegratorFactory& make, double z) {
  const std::unique_ptr<Integrator> integrator = make();
  const auto oscillator = oscillatorFor(*integrator, 0, 0);
  const State start = unitVectors();
  State state = start;
  for (const double h : {z, -z})
    for (int k = 0; k < 100; ++k)
      if (!integrator->step(*oscillator, state, h).done) return nan;
  return (columns(state) - columns(start)).norm() / columns(start).norm();
}

double symplecticityDefect(const IntegratorFactory& make, double z) {
  const TransitionMatrix T = transitionMatrix(make, z, 0);
  return T.found && T.memory == 1 ? std::abs(T.matrix.determinant() - 1) : nan;
}

double observedCriticalStep(const IntegratorFactory& make, SecondOrderSystem& system, const State& start, double low,
                            double high, const ObservedStepOptions& options) {
  // What a bounded motion reaches is learnt from the run at `low`, which must not grow by itself.
  double reached = 0;
  const auto bounded = [&](double h, bool learn) {
    const std::unique_ptr<Integrator> integrator = make();
    State state = start;
    for (int k = 0; k < options.steps; ++k) {
      if (!integrator->step(system, state, h).done) return false;
      const double speed = state.v.cwiseAbs().maxCoeff();
      if (!std::isfinite(speed) || !state.x.allFinite()) return false;
      if (learn && 10 * k < options.steps)
        reached = std::max(reached, speed);
      else if (speed > options.growth * reached)
        return false;
    }
    return true;
  };
  if (!bounded(low, true) || bounded(high, false)) return nan;
  while (high - low > options.tolerance * high) {
    const double middle = 0.5 * (low + high);
    (bounded(middle, false) ? low : high) = middle;
  }
  return low;
}

}  // namespace ringwatch

#include <ringwatch/handlers/mass_scaling/mass_scaling.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/rounding.h>
#include <ringwatch/handlers/mass_scaling/lowest_frequencies.h>
#include <ringwatch/monitor/bounds/nodal_bound.h>
#include <ringwatch/monitor/bounds/scaled_tangent.h>

namespace ringwatch {
namespace {

constexpr int reportedFrequencies = 3;

/// Parts that a step is divided into at most. What needs more is not proven.
constexpr int mostParts = 1000;
/// A part of a divided step is that share of what is proven at most: elements that stiffen at speed have room before
/// the next choice.
constexpr double shareOfProven = 0.5;
/// Sweeps of the weights of the bound that says how many.
constexpr int sweeps = 12;
/// Parts after which fewer are tried, twice as many after each try in vain. A choice costs as much as some forty
/// forces.
constexpr std::int64_t leastPatience = 512;

/// Square root of a positive semidefinite matrix with a floor under its eigenvalues, so that it can be inverted.
Eigen::Matrix3d flooredRoot(const Eigen::Matrix3d& A) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(A);
  const double floor = 1e-6 * eigen.eigenvalues().cwiseAbs().maxCoeff() + 1e-200;
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(floor).cwiseSqrt().asDiagonal() *
         eigen.eigenvectors().transpose();
}

}  // namespace

MassScaling::MassScaling(Body& body, std::unique_ptr<Integrator> base, HandlerOptions options)
    : Handler(description, body, std::move(base), std::move(options)),
      ownMass_(body.lumpedMass()),
      added_(Eigen::VectorXd::Zero(body.nodeCount())) {}

ElementFlags MassScaling::choose(const NodeVectors& x, double h, const ElementFlags& keep) {
  if (begun_) {
    divideSteps(x, h);
    return keep;
  }
  begun_ = true;
  dividedFor_ = h;
  return Handler::choose(x, h, keep);
}

void MassScaling::divideSteps(const NodeVectors& x, double h) {
  NodalBound bound(body_);
  const double lambda = bound.evaluate(x, sweeps).value;
  noteSelectionCost({static_cast<std::int64_t>(body_.mesh().elementCount()), bound.evaluations()});
  // A choice that was not asked for has a reason, even where the step is proven at this state. Once it had one the
  // whole step, which takes all of what is proven, is not tried again: while elements stiffen and soften it feeds
  // energy.
  const bool otherStep = h != dividedFor_, asked = asksForChoice() || otherStep;
  int parts = 1;
  if (!otherStep || !(lambda <= allowedLambda(h)))
    while (parts < mostParts && !(lambda <= shareOfProven * shareOfProven * allowedLambda(h / parts))) ++parts;
  proven_ = lambda <= allowedLambda(h / parts);
  if (lastPart_ == 0) lastPart_ = dividedFor_;
  dividedFor_ = h;
  if (!asked || parts >= parts_) patience_ = std::max(2 * patience_, leastPatience);
  partsSinceChoice_ = 0;
  parts_ = parts;
  largestParts_ = std::max(largestParts_, parts);
  if (parts == 1)
    attachAll();
  else
    detach(noElements(body_.mesh()), body_.lumpedMass() * (allowedLambda(h / parts) / allowedLambda(h)));
}

StepStatus MassScaling::handledStep(SecondOrderSystem& system, State& state, double h) {
  before_ = state;
  for (int parts = parts_;; parts *= 2) {
    if (StepStatus status = dividedStep(system, state, h, parts); !status.done) {
      state = before_;
      return status;
    }
    if (2 * parts > mostParts || !endsWithoutEnergy(state.x)) {
      lastPart_ = h / parts;
      partsSinceChoice_ += parts;
      dividedSteps_ += parts > 1 ? 1 : 0;
      largestParts_ = std::max(largestParts_, parts);
      return {};
    }
    state = before_;
    base_->reset();
  }
}

StepStatus MassScaling::dividedStep(SecondOrderSystem& system, State& state, double h, int parts) {
  const double part = h / parts;
  // Where velocities are half a step behind they are by half a step of another size.
  if (part != lastPart_ && lastPart_ > 0 && !base_->info().reversible)
    state.v += 0.5 * (lastPart_ - part) * accelerationOf(system, state);
  for (int k = 0; k < parts; ++k)
    if (StepStatus status = base_->step(system, state, part); !status.done) return status;
  state.time = before_.time + h;
  return {};
}

bool MassScaling::endsWithoutEnergy(const NodeVectors& x) const {
  if (allHaveEnergy_) return false;
  const auto least = leastDeterminantOfChosen(x);
  return least && !(least->value > 0);
}

void MassScaling::take(const NodeVectors& x, double h, const ElementFlags& chosen) {
  if (x_.size() > 0) return;
  allHaveEnergy_ = std::ranges::all_of(
      elements(), [&](ElementRef e) { return body_.blocks()[e.block]->material().info().definedInverted; });
  std::vector<Eigen::Matrix3d> sums = certificate()->nodalSums;
  for (const ElementRef e : chosenElements(chosen)) {
    Eigen::MatrixXd K = body_.elementTangent(e, x);
    const auto nodes = body_.blocks()[e.block]->nodesOf(e.element);
    std::vector<Eigen::Matrix3d> D;
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      const Eigen::Index at = 3 * a;
      for (int c = 0; c < 3; ++c)
        if (body_.constraints().isConstrained(nodes[a], c)) {
          K.row(at + c).setZero();
          K.col(at + c).setZero();
        }
      D.push_back(flooredRoot(K.block<3, 3>(at, at)));
    }
    // l_e = lambda_max(D^-½ K D^-½), from the Cholesky factors of D.
    Eigen::MatrixXd scaled = K;
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      const Eigen::Index at = 3 * a;
      const Eigen::Matrix3d inverse = Eigen::LLT<Eigen::Matrix3d>(D[a]).matrixL().solve(Eigen::Matrix3d::Identity());
      scaled.middleRows<3>(at) = (inverse * scaled.middleRows<3>(at)).eval();
      scaled.middleCols<3>(at) = (scaled.middleCols<3>(at) * inverse.transpose()).eval();
    }
    const double l = std::max(
        0.0, Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled, Eigen::EigenvaluesOnly).eigenvalues().tail<1>()[0]);
    for (std::size_t a = 0; a < nodes.size(); ++a) sums[nodes[a]] += l * (1 + scaledValueRounding) * D[a];
  }
  const double lambda = allowedLambda(h);
  for (std::int32_t i = 0; i < body_.nodeCount(); ++i) {
    const Eigen::Matrix3d sum = freePart(body_, i, sums[i]);
    const double needed =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(sum, Eigen::EigenvaluesOnly).eigenvalues()[2] / lambda;
    const double more = needed * (1 + addedMassRounding) - body_.lumpedMass()[i];
    if (!(more > 0)) continue;
    body_.addNodalMass(i, more);
    added_[i] += more;
  }
  x_ = x;
}

std::vector<HandlerFigure> MassScaling::figures() const {
  std::vector<HandlerFigure> result{{"added_mass_kg", added_.sum()},
                                    {"added_mass_percent", 100 * added_.sum() / ownMass_.sum()},
                                    {"divided_steps", static_cast<double>(dividedSteps_)},
                                    {"most_parts", static_cast<double>(largestParts_)}};
  if (x_.size() == 0) return result;
  const auto toHertz = [](double lambda) { return std::sqrt(lambda) / (2 * std::numbers::pi); };
  const std::vector<double> before = lowestEigenvalues(body_, x_, ownMass_, reportedFrequencies),
                            after = lowestEigenvalues(body_, x_, body_.lumpedMass(), reportedFrequencies);
  for (std::size_t k = 0; k < std::min(before.size(), after.size()); ++k) {
    result.push_back({joinText("frequency_", k + 1, "_Hz"), toHertz(before[k])});
    result.push_back({joinText("frequency_", k + 1, "_with_added_mass_Hz"), toHertz(after[k])});
    result.push_back({joinText("frequency_", k + 1, "_shift_percent"), 100 * (std::sqrt(after[k] / before[k]) - 1)});
  }
  return result;
}

}  // namespace ringwatch

#include <ringwatch/handlers/mass_scaling/mass_scaling.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/rounding.h>
#include <ringwatch/body/domain.h>
#include <ringwatch/handlers/mass_scaling/lowest_frequencies.h>
#include <ringwatch/monitor/bounds/nodal_bound.h>
#include <ringwatch/monitor/bounds/scaled_tangent.h>

namespace ringwatch {
namespace {

constexpr int reportedFrequencies = 3;

/// Square root of a positive semidefinite matrix with a floor under its eigenvalues, so that it can be inverted.
Eigen::Matrix3d flooredRoot(const Eigen::Matrix3d& A) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(A);
  const double floor = 1e-6 * eigen.eigenvalues().cwiseAbs().maxCoeff() + 1e-200;
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(floor).cwiseSqrt().asDiagonal() *
         eigen.eigenvectors().transpose();
}

}  // namespace

double marginOfMassScaling(std::string_view) { return 0.15; }

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
  division_.begin(h);
  return Handler::choose(x, h, keep);
}

bool MassScaling::isPart() const { return !body_.domain().whole(); }

void MassScaling::inherit(const Handler& before) {
  const auto* whole = dynamic_cast<const MassScaling*>(&before);
  if (!whole || !isPart()) return;
  begun_ = true;
  allHaveEnergy_ = whole->allHaveEnergy_;
  division_ = whole->division_;
  if (body_.domain().first()) whole_ = whole;
}

void MassScaling::divideSteps(const NodeVectors& x, double h) {
  NodalBound bound(body_);
  bound.setDomain(body_.domain());
  const UpperBound lambda = bound.evaluate(x, StepDivision::sweeps);
  ExactSum evaluations;  // small whole numbers
  evaluations.add(static_cast<double>(bound.evaluations()));
  body_.domain().sum({&evaluations, 1});
  noteSelectionCost({body_.elementCount(), static_cast<std::int64_t>(evaluations.value())});
  division_.choose(lambda, h, limit());
  if (isPart()) return;  // partsOfStep() says it
  if (parts() == 1)
    attachAll();
  else
    detach(noElements(body_.mesh()), body_.lumpedMass() * (allowedLambda(h / parts()) / allowedLambda(h)));
}

StepDivision::Limit MassScaling::limit() const {
  return [margin = margin(), limit = base_->info().imaginaryLimit, damping = options_.damping](double h) {
    return largestEigenvalueFor(h, margin, limit, damping);
  };
}

StepStatus MassScaling::handledStep(SecondOrderSystem& system, State& state, double h) {
  return division_.take(*base_, system, state, h, [this](const NodeVectors& x) { return endsWithoutEnergy(x); });
}

bool MassScaling::endsWithoutEnergy(const NodeVectors& x) const {
  if (allHaveEnergy_) return false;
  const auto least = leastDeterminantOfChosen(body_.domain().withGhosts(x));
  return least && !(least->value > 0);
}

void MassScaling::take(const NodeVectors& x, double h, const ElementFlags& chosen) {
  if (x_.size() > 0 || isPart()) return;
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
  if (!isPart()) return figuresWith(division_);
  return whole_ ? whole_->figuresWith(division_) : std::vector<HandlerFigure>();
}

std::vector<HandlerFigure> MassScaling::figuresWith(const StepDivision& division) const {
  std::vector<HandlerFigure> result{{"added_mass_kg", added_.sum()},
                                    {"added_mass_percent", 100 * added_.sum() / ownMass_.sum()},
                                    {"divided_steps", static_cast<double>(division.dividedSteps())},
                                    {"most_parts", static_cast<double>(division.largestParts())}};
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

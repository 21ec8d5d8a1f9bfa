#include <ringwatch/monitor/incremental/incremental_exchange_bound.h>

#include <algorithm>

#include <ringwatch/base/infinity.h>

namespace ringwatch {
namespace {

/// Of an element's matrix, of the cost of one along a run, until its share is definite, whole and proven.
constexpr double factorisations = 0.8;

bool hasTetrahedraAlone(const Body& body) {
  return std::all_of(body.blocks().begin(), body.blocks().end(),
                     [](const auto& block) { return block->nodesPerElement() == 4; });
}

}  // namespace

IncrementalExchangeBound::IncrementalExchangeBound(const Body& body, const NodalBound& weights, WorkAccount& account,
                                                   const ExchangeRunPolicy& policy)
    : body_(body),
      account_(account),
      policy_(policy),
      certificate_(body, weights, account.limited() ? policy.roomUnderBudget : ExchangeRoomPolicy{}) {}

void IncrementalExchangeBound::charge(WorkOn what, double work) {
  Work own;
  own[what] = work;
  account_.spend(own);
  spent_ += own;
}

UpperBound IncrementalExchangeBound::update(NodeVectorsView x, UpperBound nodal, StepEvaluation* evaluation) {
  serves_ = false;
  evaluated_ = 0;
  if (!account_.limited()) earned_ = std::min(earned_ + policy_.mostShare * account_.force(), 2 * expected_);
  const bool useless = certificate_.ofElements() > policy_.useless * nodal.value;
  if (!certificate_.holds() || useless) {
    if (evaluation) body_.evaluate(x, *evaluation, workspace_);
    return {infinity};
  }
  // The proof goes on whatever the account has, and takes less where that is little.
  const bool nothing = !account_.affords(0), plenty = !account_.limited() || account_.affords(expected_);
  certificate_.follow(x, policy_.mostRaise,
                      nothing  ? policy_.partUnderBudget
                      : plenty ? policy_.leastPart
                               : policy_.part,
                      evaluation);
  evaluated_ = certificate_.factored();
  charge(WorkOn::tests, certificate_.workOfTests());
  charge(WorkOn::repairs, WorkAccount::ofExchange(body_, 0, static_cast<double>(certificate_.factored())));
  serves_ = certificate_.certifiedEigenvalue() < nodal.value;
  return {certificate_.certifiedEigenvalue()};
}

bool IncrementalExchangeBound::certify(NodeVectorsView x, double sigma, StepEvaluation* evaluation) {
  certificate_.follow(x, policy_.mostRaise, policy_.leastPart, evaluation);
  evaluated_ = certificate_.factored();
  charge(WorkOn::tests, certificate_.workOfTests());
  charge(WorkOn::repairs, WorkAccount::ofExchange(body_, 0, static_cast<double>(evaluated_)));
  serves_ = proves(sigma);
  return serves_;
}

double IncrementalExchangeBound::workOfProof() const {
  if (ExchangeCertificate::bytes(body_) > policy_.mostBytes) return infinity;
  return WorkAccount::ofShares(body_, policy_.expected);
}

bool IncrementalExchangeBound::proveFor(NodeVectorsView x, double sigma, NodeVectorsView mode, LowerBound lower,
                                        bool free) {
  if (!(lower.value > 0) || !(lower.value < sigma)) return false;
  const ExchangeWork work = certificate_.share(x, mode, lower, policy_.iterations, sigma);
  first_ = false;
  if (!free)
    charge(WorkOn::sweeps, WorkAccount::ofShares(body_, static_cast<double>(work.decompositions) /
                                                            static_cast<double>(body_.mesh().elementCount())));
  evaluated_ += certificate_.factored();
  serves_ = proves(sigma);
  return serves_;
}

UpperBound IncrementalExchangeBound::narrow(NodeVectorsView x, UpperBound nodal, double tight, NodeVectorsView mode,
                                            LowerBound lower, double width) {
  const UpperBound own{serves_ ? certificate_.certifiedEigenvalue() : infinity};
  if (!(lower.value > 0)) return own;
  if (tight > 0) {
    const double loose = hasTetrahedraAlone(body_) || account_.limited() ? policy_.looser : policy_.loose;
    worth_ = tight > loose * lower.value && ExchangeCertificate::bytes(body_) <= policy_.mostBytes;
  }
  if (!worth_) return own;
  const double present = std::min(own.value, nodal.value);
  const double inStep = 1 + policy_.shareOfWidth * width;
  const double wanted = std::max(inStep * inStep, policy_.leastGain * achieved_);
  if (!(present > wanted * lower.value)) return own;
  const auto count = static_cast<double>(body_.mesh().elementCount());
  if (expected_ == 0) expected_ = WorkAccount::ofExchange(body_, policy_.expected * count, factorisations * count);
  const bool free = first_ && static_cast<std::int64_t>(body_.mesh().elementCount()) <= policy_.atOnce &&
                    account_.affordsAtStart(expected_);
  if (!free && !(account_.limited() ? account_.affords(expected_) : earned_ >= expected_)) return own;
  const bool again = certificate_.hasShares();
  const int mostIterations = free ? policy_.firstIterations : policy_.iterations;
  const ExchangeWork work = certificate_.share(x, mode, lower, mostIterations);
  const double spent = WorkAccount::ofExchange(body_, static_cast<double>(work.decompositions), factorisations * count);
  if (!free) charge(WorkOn::sweeps, spent);
  if (!free) earned_ -= spent;
  if (again) expected_ = spent;
  first_ = false;
  evaluated_ += certificate_.factored();
  // Iterations that ended for lack of budget go on the next time.
  const bool ended = certificate_.holds() && work.iterations < mostIterations;
  achieved_ = ended ? certificate_.certifiedEigenvalue() / lower.value : 0;
  serves_ = certificate_.certifiedEigenvalue() < nodal.value;
  // What the shares before have proven at x stays proven, also where new ones cannot be made.
  return {std::min(own.value, certificate_.certifiedEigenvalue())};
}

void IncrementalExchangeBound::forget() {
  certificate_.forget();
  serves_ = false;
}

}  // namespace ringwatch

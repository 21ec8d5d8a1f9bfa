#pragma once
#include <ringwatch/monitor/bounds.h>
#include <ringwatch/monitor/incremental/exchange_certificate.h>
#include <ringwatch/monitor/incremental/work_account.h>

namespace ringwatch {

/// When the exchange bound is worth its cost along a run. No constant here bears on what is proven.
struct ExchangeRunPolicy {
  /// Eigenvalue of the best weights over the lower one from which weights of single elements count as loose: 3 % of the
  /// step. In bodies of linear tetrahedra alone, and where there is a limit to the work, 5 %: weights are followed at a
  /// fraction of the cost, and with five a cell and jitter, 3.5 % off, they stay within 5 % without help.
  double loose = 1.06, looser = 1.1;
  /// Memory that making shares may take, bytes.
  std::int64_t mostBytes = 1LL << 30;
  /// Elements up to which the first shares are made at the first evaluation, as the best proof from scratch is.
  std::int64_t atOnce = 10000;
  /// Iterations that make the first shares, and others.
  int firstIterations = 40, iterations = 12;
  /// What shares that are made anew are taken to cost before it is known, decompositions an element.
  double expected = 3;
  /// Part of the room that balls are to have: where the budget affords new shares, where it does not, and where nothing
  /// is left. More room costs a raise, and less is proven anew more often.
  double leastPart = 0.25, part = 0.7, partUnderBudget = 1.5;
  /// The room that shares have where there is a limit to the work: elements leave larger balls less often.
  ExchangeRoomPolicy roomUnderBudget{.room = 0.04, .mostCost = 0.06};
  /// Largest raise of the certified eigenvalue at once; what needs more has lost its proof.
  double mostRaise = 1.15;
  /// The certified eigenvalue above the one of the weights from which it is not followed.
  double useless = 1.1;
  /// New shares are wanted where the bracket is wider than this share of the width that is wanted, and the certified
  /// eigenvalue over the lower one has risen by this over what the last ones gave.
  double shareOfWidth = 0.8, leastGain = 1.02;
  /// Where there is no limit: what making shares may take, on average, in steps.
  double mostShare = 1;
};

/// The exchange bound along a run beside the incremental nodal bound: where weights are loose it makes shares, follows
/// them (ExchangeCertificate; Theorem 76, docs/theory/incremental_exchange.md), and makes them anew where the bracket
/// has become too wide and the budget affords it.
class IncrementalExchangeBound {
 public:
  /// weights: those of the nodal bound. All by reference.
  IncrementalExchangeBound(const Body& body, const NodalBound& weights, WorkAccount& account,
                           const ExchangeRunPolicy& policy = {});

  /// Proven at x; infinite where nothing is. nodal: what the weights prove there. Unless nullptr, `evaluation` is
  /// filled in at x in any case.
  UpperBound update(NodeVectorsView x, UpperBound nodal, StepEvaluation* evaluation = nullptr);
  /// Whether the last update gave the better proof.
  bool serves() const { return serves_; }
  /// Makes shares at x where that is wanted and can be afforded. lower, mode: at x, of the tracked mode; tight: the
  /// weights' best bound if known, else 0; width: of the bracket, in the step. Returns as update() does.
  UpperBound narrow(NodeVectorsView x, UpperBound nodal, double tight, NodeVectorsView mode, LowerBound lower,
                    double width);
  /// Threshold mode: whether shares prove `sigma` (rad²/s²) at x; they do not where they did not at the positions
  /// before. Unless nullptr, `evaluation` is filled in at x in any case.
  bool certify(NodeVectorsView x, double sigma, StepEvaluation* evaluation);
  /// Whether shares proved `sigma` at the positions of the last call.
  bool proves(double sigma) const { return certificate_.certifiedEigenvalue() <= sigma; }
  /// Makes shares at x that prove `sigma`, with as much room for motion as that leaves, and returns whether they do.
  /// mode, lower: at x, of the tracked mode. free: it is of the first proof, and is not paid for.
  bool proveFor(NodeVectorsView x, double sigma, NodeVectorsView mode, LowerBound lower, bool free);
  /// What proveFor() takes; infinite where memory does not allow it.
  double workOfProof() const;
  /// The state has no tangent: what is kept is of none that can come back.
  void forget();

  const ExchangeCertificate& certificate() const { return certificate_; }
  /// Elements that the last update() and narrow() factored.
  std::int64_t evaluated() const { return evaluated_; }
  /// All work since the first proof.
  const Work& spent() const { return spent_; }

  template <class Archive>
  void archive(Archive& a) {
    a(certificate_, worth_, serves_, first_, achieved_, expected_, earned_, evaluated_, spent_);
  }

 private:
  void charge(WorkOn what, double work);

  const Body& body_;
  WorkAccount& account_;
  ExchangeRunPolicy policy_;
  ExchangeCertificate certificate_;
  Body::Workspace workspace_;
  bool worth_ = false, serves_ = false, first_ = true;
  double achieved_ = 0;               // by the last shares: certified over lower eigenvalue
  double expected_ = 0, earned_ = 0;  // work of making shares; of it, without a limit
  std::int64_t evaluated_ = 0;
  Work spent_;
};

}  // namespace ringwatch

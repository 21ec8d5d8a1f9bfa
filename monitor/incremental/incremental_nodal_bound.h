#pragma once
#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include <ringwatch/base/archive.h>
#include <ringwatch/base/backoff.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/monitor/bounds.h>
#include <ringwatch/monitor/incremental/exchange_certificate.h>
#include <ringwatch/monitor/incremental/rebuild_policy.h>
#include <ringwatch/monitor/incremental/run_certificate.h>
#include <ringwatch/monitor/incremental/work_account.h>

namespace ringwatch {

/// The eigenvalue whose step is by `width` below that of a lower bound, rad²/s².
inline double above(LowerBound lower, double width) { return (1 + width) * (1 + width) * lower.value; }

/// The block nodal bound kept along a run at little cost. Its certificate (CertificateState, Theorem 14) stays as it is
/// while every element is inside its validity ball (Theorem 17). An element that leaves is evaluated exactly; when it
/// exceeds its allowance, the certificate is mended around it (localUpdate, Theorem 20), and rebuilt from scratch where
/// that fails or pays (RebuildPolicy). All are in docs/theory/incremental_certificate.md.
/// The proof is for the masses and the free components at that time: when the body's version has changed, the next
/// update or certify starts from scratch.
class IncrementalNodalBound {
 public:
  /// account: what may be spent; it must outlive this. nullptr: no limit. Without a budget left the bound stays proven
  /// and becomes wider.
  explicit IncrementalNodalBound(const Body& body, const RebuildPolicy& policy = {}, WorkAccount* account = nullptr);

  /// The certified eigenvalue, proven at positions x (3×N, m). NaN when x or the tangent is not finite. Unless nullptr,
  /// `evaluation` is filled in at x: elements are tested in the one pass that computes what it asks for. Its visitor is
  /// not used.
  /// Under a budget the certified eigenvalue rises instead of elements being evaluated, but not above `ceiling`:
  /// up to there the proof goes before the account.
  UpperBound update(NodeVectorsView x, StepEvaluation* evaluation = nullptr,
                    double ceiling = std::numeric_limits<double>::infinity());
  /// Tells the bound what a lower bound is at x, so that it can follow downwards: the certified eigenvalue is lowered,
  /// or the certificate rebuilt, when it lies more than `width` (relative, in the step) above. Proves nothing: when it
  /// returns true, the certified eigenvalue has changed and holds only after the next update.
  bool tightenBound(NodeVectorsView x, LowerBound lower, double width);
  /// Follows a lower bound upwards: raises the certified eigenvalue and all allowances when it lies so little above the
  /// one at x that elements would soon exceed their allowances everywhere, but not above `ceiling`. Needs no evaluation
  /// (Theorem 21).
  void relaxBound(LowerBound lower, double width, double ceiling = std::numeric_limits<double>::infinity());
  /// The certified eigenvalue from which tightenBound() lowers it.
  double highest(LowerBound lower, double width);
  /// RebuildPolicy::slack from here on.
  void setSlack(double slack) { policy_.slack = slack; }

  /// Threshold mode: proves that the highest eigenvalue at x is at most `sigma`, rad²/s², or returns false. Where
  /// `sigma` lies far above it, balls are large and hardly any element is ever evaluated again. A proof that is kept
  /// for a smaller value serves too.
  bool certify(NodeVectorsView x, double sigma, StepEvaluation* evaluation = nullptr);

  /// At an observation that something else proves alone: nothing is evaluated. seen: the elements that it looked at.
  /// What is kept is of the positions of the last update or certify, from which the next one goes on.
  void skip(std::span<const ExchangeCertificate::Seen> seen);
  /// While something else proves more: elements are evaluated only where nothing else helps, as without a budget left.
  void setSecondary(bool secondary) { secondary_ = secondary; }
  /// The bound of the best weights, where they have been made anew since the last call and their sweeps were not ended
  /// early; else 0.
  double takeTight() { return std::exchange(tight_, 0); }

  /// Weights for the reference configuration, swept as those of a rebuild are.
  NodalBound weightsAtRest() const;
  /// Whether the sweeps of the last rebuild were ended early: it proves no more than was wanted.
  bool endedEarly() const { return endedEarly_; }

  double certifiedEigenvalue() const { return state_.certifiedEigenvalue(); }
  const NodalBound& weights() const { return state_.weights(); }
  /// l_e when the element was evaluated last, N/m, rounded up.
  double value(ElementRef e) const { return state_.value(e); }
  /// What the last update() or certify() took.
  const UpdateStatistics& statistics() const { return state_.statistics(); }
  /// RunCertificate::mostCompressed and compressedByTurns. Only elements under compression can make the tangent
  /// indefinite.
  std::vector<ElementRef> mostCompressed(double least, std::size_t count) const {
    return state_.mostCompressed(least, count);
  }
  std::vector<ElementRef> compressedByTurns(double least, std::size_t count, std::size_t& next) const {
    return state_.compressedByTurns(least, count, next);
  }
  /// The largest -lambda_min(∂P/∂F) over λ+2μ of an element since the certificate was built.
  double mostCompression() const { return state_.mostCompression(); }
  /// An element's exact value over its allowance, which is about the bound at its highest node over the certified
  /// eigenvalue.
  struct NearLimit {
    double fraction;
    ElementRef element;
  };
  /// The elements evaluated at the last update that were above RebuildPolicy::nearLimit, largest first, before any
  /// local update: where the highest eigenvalue may have come to. Under a budget the certified eigenvalue may
  /// be far too high: then also those that are above noteFrom().
  const std::vector<NearLimit>& nearLimit() const { return nearLimit_; }
  /// A search has found the highest eigenvalue here to be at least `found`, where the bound that is followed along the
  /// run said `followed`. That one will have been as poor when the weights were made: these are less loose than they
  /// seemed beside it. Without a limit no room is made for looseness.
  void correctLowerBound(LowerBound followed, LowerBound found) {
    if (limited() && tightOverLower_ > 0 && followed.value > 0)
      tightOverLower_ = std::max(1.0, tightOverLower_ * followed.value / found.value);
  }
  /// The highest eigenvalue, rad²/s², that is known from below.
  void noteFrom(LowerBound lower) { notedFrom_ = lower.value; }
  /// The elements that hold most of the bound at the `count` nodes where it is highest, by their values when last
  /// evaluated: where the top mode may live. Empty while nothing is proven.
  std::vector<ElementRef> highestElements(std::size_t count);
  /// All work since the first proof.
  Work spent() const {
    Work all = spent_;
    return all += state_.statistics().work;
  }
  /// CertificateState::verify, for tests.
  double verify(NodeVectorsView x) const { return state_.verify(x); }

  /// The account is the owner's.
  template <class Archive>
  void archive(Archive& a) {
    a(policy_.slack, spent_, sinceRebuild_, ofProof_, state_, started_, endedEarly_, secondary_, tight_, notedFrom_,
      nearLimit_, rebuilds_, refreshes_, lowerings_, tightOverLower_);
    archiveVersion(a, bodyVersion_, body_.version());
  }

 private:
  /// Whether the account, less what the statistics count, has so much.
  bool affords(double work) const {
    return !secondary_ && (!account_ || account_->affords(state_.statistics().work.besideTests() - ofProof_ + work));
  }
  bool limited() const { return account_ && (secondary_ || account_->limited()); }
  /// An eigenvalue that leaves a share of the width above the lower bound; under a budget, of the slack above
  /// the tight bound too: less would be lost to elements that leave their balls.
  double withRoom(LowerBound lower, double width, double share) const;
  /// Takes from the account what the statistics count, and begins to count again.
  void beginCounting();
  /// Builds the certificate again at x with the weights that there are, turned with the body: for the wanted eigenvalue
  /// if they prove it, else not above that of now.
  void refresh(NodeVectorsView x, double wanted);
  /// Ends the proof when masses or free components have changed.
  void followBody();
  /// The mean work of evaluating an element among all.
  double workOfOne() const;
  /// What first weights are swept to where an eigenvalue `most` is to be proven, and a smaller one is ample.
  SweepTarget firstTarget(double most, double ample) const;
  /// Weights from scratch, swept until their bound is enough, or as good as can be.
  void rebuild(NodeVectorsView x, const SweepTarget& enough = {});
  /// Builds the certificate for an eigenvalue, with the weights that were evaluated at x. newWeights: since allowances
  /// were distributed last.
  void start(NodeVectorsView x, double certifiedEigenvalue, bool newWeights = true);
  enum class Outcome { held, tooManyViolations, refused, notFinite };
  /// Brings a certificate from the positions of the last call to x. Unless mayRaise, the certified eigenvalue stays,
  /// and `refused` tells that it had to rise nevertheless.
  Outcome follow(NodeVectorsView x, bool mayRaise, double ceiling, StepEvaluation* evaluation);
  /// Of elements that have left their balls, those that are evaluated: as far as the budget goes, and by overdraft
  /// where the certified eigenvalue would have to rise far or above the ceiling. For the others it is raised.
  std::vector<ElementRef> raiseForMost(NodeVectorsView x, const std::vector<ElementRef>& outside, double ceiling);
  /// Evaluates elements, and notes those near their limits. False where a value is not finite.
  bool evaluate(NodeVectorsView x, const std::vector<ElementRef>& elements);
  /// Serves the elements above their allowances and the nodes whose sums are too large, and adds elements with new
  /// balls to `changed`.
  Outcome mend(NodeVectorsView x, bool mayRaise, const std::vector<std::int32_t>& exceeding,
               std::vector<ElementRef>& changed);

  const Body& body_;
  RebuildPolicy policy_;
  WorkAccount* account_;
  Work spent_;
  double sinceRebuild_ = 0;  // work but that of tests
  double ofProof_ = 0;       // of what the statistics count, for the step that is taken alone
  RunCertificate state_;
  Body::Workspace workspace_;
  bool started_ = false, endedEarly_ = false;  // endedEarly_: the last rebuild, since its weights were good enough
  bool secondary_ = false;
  double tight_ = 0, notedFrom_ = infinity;
  std::int64_t bodyVersion_ = 0;  // that the proof is for
  std::vector<NearLimit> nearLimit_;
  Backoff rebuilds_, refreshes_, lowerings_;  // in updates
  double tightOverLower_ = 0;  // the tight bound at the last rebuild over the lower bound then; 0: not known yet
};

}  // namespace ringwatch

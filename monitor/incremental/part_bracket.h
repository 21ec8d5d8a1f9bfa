#pragma once
#include <cstdint>
#include <functional>
#include <optional>

#include <ringwatch/base/backoff.h>
#include <ringwatch/monitor/bounds/lowest_mode.h>
#include <ringwatch/monitor/incremental/part_mode.h>
#include <ringwatch/monitor/incremental/run_certificate.h>
#include <ringwatch/monitor/step_limit.h>

namespace ringwatch {

/// Keeps both sides of the bracket along a run of a part of a body (body/domain.h). All processes have the same
/// bracket, with the same bits for any number of them and any partition (Theorem 80, docs/theory/distribution.md).
///
/// The safe side is an incremental certificate (Theorem 14): allowances of the elements are kept, and elements outside
/// their validity balls are evaluated again, by every process that has them. One that exceeds its allowance raises it,
/// and with it the certified eigenvalue (Theorem 21), until evaluating all elements, or new weights, pays. The
/// optimistic side is the quotient of PartMode's vector. Under compression a direction of negative stiffness is
/// searched (Theorem 11, docs/theory/rings_and_rayleigh.md). Collective.
class PartBracket {
 public:
  /// The body must outlive this. threshold: the optimistic side is wanted only while the step is not certified.
  PartBracket(const Body& body, double width, bool threshold);

  /// The one pass over the elements at x (3×N, m): fills `evaluation` in and, where a bracket is due, tests elements.
  /// Ghosts of x are as their owners have them, or get there by an exchange under way. finite: whether the state is, at
  /// own nodes; returns whether it is at all. meanwhile: as Domain::largest has it, once `evaluation` is there.
  bool test(NodeVectorsView x, bool finite, bool due, StepEvaluation& evaluation,
            const std::function<void()>& meanwhile);
  /// The bracket at the x of the last test, where one was due, for steps of h (s), if any are taken.
  void update(NodeVectorsView x, const StepRule& limit, std::optional<double> h);
  /// Whether the tangent was finite at the last update.
  bool finite() const { return started_; }
  /// Of the last update: the bracket, if both sides were wanted, and the largest step that is proven, s.
  const std::optional<CriticalStep>& last() const { return step_; }
  double certified() const { return certified_; }
  /// Elements evaluated since the last test, of those that this process counts.
  std::int64_t evaluated() const { return evaluated_; }
  /// The least determinant of the elements that were outside their balls at the last test, where it is not positive.
  Body::LeastDeterminant leastDeterminant() const;
  /// A direction of negative stiffness: uᵀKu / uᵀMu of it at the x of the last update, rad²/s², proven; not negative
  /// where none is known. The element has the least uᵀK_e u.
  const LowestMode& lowest() const { return lowest_; }
  /// What is certified, for tests.
  const RunCertificate& certificate() const { return certificate_; }

 private:
  /// Evaluates the elements that have left their balls, and raises what is too low for them here. False where a tangent
  /// is not finite.
  bool checkElements(NodeVectorsView x, StepEvaluation& evaluation);
  /// New values of all elements, with the weights that there are or new ones, and a certificate for `wanted`, or as low
  /// as it pays. Not started where the tangent is not finite.
  void renew(NodeVectorsView x, bool newWeights, double wanted);
  /// Searches where compression has grown, where the direction that was known has become stiff, and else more and more
  /// seldom.
  void searchUnderCompression(NodeVectorsView x);
  double sigma() const { return certificate_.certifiedEigenvalue(); }

  const Body& body_;
  double width_;
  bool threshold_;
  RebuildPolicy policy_;
  RunCertificate certificate_;
  PartMode mode_, soft_;
  LowestMode lowest_;
  Body::Workspace workspace_;
  std::optional<CriticalStep> step_;
  double certified_ = 0;
  bool started_ = false;
  double provenAtRebuild_ = 0;  // certified eigenvalue then
  LowerBound lower_{0};
  ElementRef controlling_;
  double least_ = 0, compression_ = 0;  // of all processes at the last test: determinant, mostCompression()
  double searchedAt_ = 0;               // compression
  Backoff refreshes_, rebuilds_, searches_;
  std::int64_t evaluated_ = 0;
};

/// criticalStep() on a part of a body: the nodal bound and the quotient of PartMode's vector, by more sweeps and
/// products than an observation takes. evaluations: those of this process are added. Throws NumericalError on all
/// processes where the tangent is not finite. Collective.
CriticalStep criticalStepOfParts(const Body& body, NodeVectorsView x, const StepRule& limit, std::int64_t& evaluations);

}  // namespace ringwatch

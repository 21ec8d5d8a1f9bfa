#pragma once
#include <functional>
#include <optional>
#include <string>

#include <ringwatch/base/backoff.h>
#include <ringwatch/distributed/halo.h>
#include <ringwatch/distributed/rank_mode.h>
#include <ringwatch/monitor/energy_check.h>
#include <ringwatch/monitor/incremental/run_certificate.h>
#include <ringwatch/monitor/stability_monitor.h>

namespace ringwatch {

/// What a RankMonitor takes of a MonitorOptions.
struct RankMonitorOptions {
  StepRule limit = 2.0;  ///< as MonitorOptions::limit; must be proven
  MonitorMode mode = MonitorMode::bracket;
  int every = 1;
  double width = 0.05;
  int clearObservations = 20;
  double energyTolerance = 0.1;
};

/// StabilityMonitor's work on a body that is distributed over ranks: all get the same report, which names elements of
/// the whole body, and which has the same bits for any number of ranks and threads and any partition (Theorem 80,
/// docs/theory/distribution.md).
///
/// The safe side is an incremental certificate (Theorem 14): allowances of the elements are kept, and elements outside
/// their validity balls are evaluated again, by every rank that has them. One that exceeds its allowance raises it, and
/// with it the certified eigenvalue (Theorem 21), until evaluating all elements, or new weights, pays. The optimistic
/// side is the quotient of RankMode's vector. Collective. Events are
/// `violated`, `inverted`, `non-finite` and `energy-balance`.
class RankMonitor final : private RestOfBody {
 public:
  /// All references must outlive the monitor. Throws InputError for the mode `metric` and a rule that is not proven.
  RankMonitor(Ranks& ranks, Halo& halo, const RankBody& part, const RankMonitorOptions& options);

  /// As StabilityMonitor::observe; x has ghosts as their owners have them, or gets them from an exchange under way on
  /// the halo, which ends behind the elements that need no ghost. `meanwhile`, unless empty, is called once
  /// `evaluation` is filled in, while the ranks tell each other whether all elements are inside their allowances: it
  /// may do what needs no other rank. asked: what is asked of this rank from outside, 0 for nothing; becomes the
  /// largest of all ranks, so that all know it at the same state. report.elementsRefreshed is of this rank, which
  /// counts those of RankBody::counts.
  const MonitorReport& observe(std::int64_t step, double time, NodeVectorsView x, NodeVectorsView v,
                               std::optional<double> h, StepEvaluation& evaluation, int& asked,
                               const std::function<void()>& meanwhile);
  /// The same of the energies of the state observed last, which all ranks have alike: an event where their balance is
  /// off, as StabilityMonitor::observeEnergies.
  const MonitorReport& observeEnergies(const Energies& energies);
  /// The bracket at the state observed last, x, from scratch, in the report, which is fresh then; for steps of h, s.
  const MonitorReport& prove(NodeVectorsView x, double h);
  /// Both sides at x, by new weights, more sweeps and more tangent products than an observation takes. The next
  /// observation begins anew. A bracket that is none where the tangent is not finite.
  CriticalStep bracketFromScratch(NodeVectorsView x);
  /// Steps of h are taken as n of h/n from now on: brackets and what is certified are of such steps, n times those of a
  /// part. The next observation is a fresh one, whatever options.every.
  void setParts(int n);
  const std::vector<MonitorEvent>& events() const { return tracker_.events(); }
  /// Whether positions and velocities of all ranks were finite at the last observation.
  bool stateIsFinite() const { return finite_; }
  /// What it took so far.
  struct Cost {
    std::int64_t evaluated = 0;  // elements, on this rank
    std::int64_t raises = 0, refreshes = 0, rebuilds = 0;
  };
  const Cost& cost() const { return cost_; }
  /// The largest excess over the certificate's two statements at x on all ranks, by CertificateState::verify's
  /// definition at owned nodes; for tests.
  double verify(NodeVectorsView x);

 private:
  void completeSums(Eigen::Matrix<double, 6, Eigen::Dynamic>& sums) override { halo_.exchange(sums); }
  double largest(double own) override;
  bool counts(ElementRef element) const override { return part_.counts(element); }

  struct Found {
    double need = 0;  // the certified eigenvalue that raised allowances need
    bool finite = true;
  };
  Found checkElements(NodeVectorsView x, StepEvaluation& evaluation);
  /// New values of all elements, with the weights that there are or new ones, and a certificate for `wanted`, or as low
  /// as it pays. False where the tangent is not finite.
  bool renew(NodeVectorsView x, bool newWeights, double wanted);
  void nameControlling(double bound);
  /// s, of the certified eigenvalue.
  double certifiedStep() const {
    return parts_ * safeStep(UpperBound{certificate_.certifiedEigenvalue()}, options_.limit);
  }
  /// rad²/s², that steps of h are stable for.
  double lambdaFor(double h) const { return options_.limit.lambdaFor(h / parts_); }
  /// Both sides, in the report.
  void setBracket();
  /// The bracket with that safe side, s.
  CriticalStep bracketOf(double safe) const;
  /// Reports an event when it begins; step, time and cause, which a rank that has the element finds, are filled in.
  void present(MonitorEvent event, NodeVectorsView x);

  Ranks& ranks_;
  Halo& halo_;
  const RankBody& part_;
  RankMonitorOptions options_;
  RebuildPolicy policy_;
  RunCertificate certificate_;
  RankMode mode_;
  EventTracker tracker_;
  EnergyCheck energies_;
  MonitorReport report_;
  Body::Workspace workspace_;
  bool started_ = false;
  double provenAtRebuild_ = 0;  // certified eigenvalue then
  LowerBound lower_{0};
  ElementRef controlling_;
  Backoff refreshes_, rebuilds_;
  Cost cost_;
  std::int64_t observations_ = 0;
  int parts_ = 1;  // of a step
  bool unknown_ = false, finite_ = true;
};

}  // namespace ringwatch

#pragma once
#include <cstdint>
#include <optional>
#include <string_view>

#include <ringwatch/base/backoff.h>
#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/monitor/bounds.h>
#include <ringwatch/monitor/bounds/local_mode.h>
#include <ringwatch/monitor/bounds/lowest_mode.h>
#include <ringwatch/monitor/bounds/node_submatrix.h>
#include <ringwatch/monitor/bounds/stiff_nodes.h>
#include <ringwatch/monitor/incremental/incremental_exchange_bound.h>
#include <ringwatch/monitor/incremental/incremental_nodal_bound.h>
#include <ringwatch/monitor/incremental/moved_bound.h>
#include <ringwatch/monitor/incremental/rest_bound.h>
#include <ringwatch/monitor/step_limit.h>

namespace ringwatch {

/// How both sides of the bracket are followed along a run. No constant here bears on what is proven (Theorems 8, 14 and
/// 21): each trades evaluations against the width.
struct BracketPolicy {
  /// Slack of the certified eigenvalue (RebuildPolicy::slack, in the eigenvalue) over the width that is wanted of the
  /// bracket (in the step): 2 would use all of the width; the rest is for the lower side.
  double slackOfWidth = 1.6;

  /// Under a budget the slack grows at every observation by up to this share, and shrinks by less where there
  /// are some; the most.
  double widening = 0.03, narrowing = 0.01, mostSlack = 1.5;

  // The top mode, by Lanczos.
  /// Tangent products: at the first evaluation, where the other side's was ended early too (a rebuild follows, and a
  /// restart with it), at a restart from the highest ring, and when the mode is followed.
  int firstProducts = 20, productsOfEarlyEnd = 8, restartProducts = 8, productsOfFollowing = 3;
  /// Nodes of the region in which the mode is followed at every observation. When the region is chosen its bound is
  /// compared with the whole mode's: it is doubled while it holds less by more than lostInRegion, and halved for the
  /// next time when it holds all but a quarter of that. Local modes need few nodes, those of regular grids many. Each
  /// observation takes a tangent product of the region; every localGap-th improves the mode by localProducts of them.
  std::size_t leastLocalNodes = 24, mostLocalNodes = 512;
  double lostInRegion = 0.02;
  int localProducts = 3, localGap = 4;
  /// Under a budget no region is chosen whose bound takes more than this share of it, but one of so few nodes.
  double shareOfRegion = 0.7;
  std::size_t fewestLocalNodes = 8;
  /// The whole mode is refreshed that seldom while it does not help: while the region's bound gains less than leastGain
  /// of the eigenvalue.
  Backoff::Gaps wholeMode{.first = 64, .last = 512, .factor = 2};
  double leastGain = 0.005;
  /// Restarts from all reduced rings, each of which evaluates every element, while the bracket is too wide; one has
  /// helped when the region's bound has risen by this share.
  Backoff::Gaps restarts{.first = 40, .last = 10240, .factor = 4};
  double helpfulRestart = 0.02;
  /// Rings that are examined: at the first evaluation, around the nodes where the bound is highest; later, those of
  /// elements that have just exceeded their allowance.
  std::size_t highestRings = 64, risenRings = 3;

  // Directions of negative stiffness. Compression is -lambda_min(∂P/∂F) over λ+2μ.
  /// Compression above which an element's ring is examined, so many of the most compressed each time, and above which a
  /// direction is searched in the whole body.
  double compressed = 0.05, slightlyCompressed = 1e-3;
  std::size_t compressedRings = 16;
  /// Tangent products of the first search, of the others, and of these under a budget.
  int firstSearch = 48, laterSearch = 12, searchUnderBudget = 6;
  /// Growth of compression since the last search that asks for one, after searchGap evaluations, and the same under
  /// a budget; else searches become more and more seldom.
  double growthOfCompression = 1.5, growthUnderBudget = 2;
  int searchGap = 40;
  Backoff::Gaps searches{.first = 160, .last = 2560, .factor = 2};

  /// Observations of a step that is not certified between two refreshes of the whole mode, which find a mode that has
  /// moved on: with a gap of 3 and little to spend the hanging ball of `verify monitor` learns 21 steps too late that
  /// it is unstable. A step within `close` of the optimistic side has one at every observation: the verdict hangs on
  /// it.
  int sharpenGap = 2;
  double close = 0.02;

  /// Evaluations between two examinations of compressed rings, and of a step that is certified before it is tested in
  /// the cheapest way again; refreshes for a step that is not certified between two restarts from all reduced rings.
  int firstGap = 10;

  /// Certified eigenvalue over the least one from which the bound at rest runs: 5 % of the step.
  double risen = 1.1;

  /// The bound of the first weights over the eigenvalue that a given step allows from which they leave too little room,
  /// so that shares are made at once: 5 % of the step.
  double hardlyProven = 0.9;

  /// Under a budget, while the step is not certified, the mode is searched among so many of the stiffest nodes, in
  /// regions of so many nodes, by turns with being followed; at the first evaluation that is ended early, among more.
  std::size_t stiffNodes = 2, firstStiffNodes = 8, nodesAround = 24;
};

/// Keeps both sides of the bracket along a run: the incremental nodal bound from above, Rayleigh quotients of the
/// tracked top mode, of all of it seldom and of a region at every observation, from below.
class RunBracket {
 public:
  /// budget: what may be taken, as a share of the work of the steps; steps: of the run, as far as known; inAdvance:
  /// work before which there is no limit, in units; every: steps from one evaluation to the next (WorkAccount). The
  /// proof comes first, then the width.
  RunBracket(const Body& body, double width, double budget, std::int64_t steps = 0, double inAdvance = 0,
             std::int64_t every = 1, const BracketPolicy& policy = {});

  /// Unless nullptr, `evaluation` is filled in at x. Empty where the tangent is not finite, or where rounding
  /// makes the sides cross.
  /// h: the step that is taken, if one is; while it is certified it stays so as long as that can be proven, whatever
  /// the budget.
  const std::optional<CriticalStep>& evaluate(NodeVectorsView x, const StepRule& limit, std::optional<double> h,
                                              StepEvaluation* evaluation);
  /// Whether h is certified at x, in the cheapest way. While it is not, the bracket is kept, and some observations
  /// longer: then last() is fresh and `bracketed` true.
  bool certify(NodeVectorsView x, const StepRule& limit, double h, StepEvaluation* evaluation);
  bool bracketed() const { return bracketed_; }
  /// Whether the tangent was finite when last evaluated.
  bool finite() const { return finite_; }
  /// Makes the best proof from scratch at x, which is kept for as long as the body stays there.
  void proveFromScratch(NodeVectorsView x, const StepRule& limit);
  /// Replaces either side of the last bracket by that of the proof from scratch, where it is of this x and better.
  void takeBest(NodeVectorsView x);
  /// Sharpens the optimistic side, now and then, for a step h (s) that is not certified: oftener when h is close to it.
  void sharpen(NodeVectorsView x, const StepRule& limit, double h);
  /// Names in last(), which is of x, what governs there as far as it is known now: for an event.
  void nameGoverning(NodeVectorsView x);
  /// All work after the first proof, and a step's own.
  Work spent() const {
    Work all = nodal_.spent();
    all += exchange_.spent();
    return all += spent_;
  }
  double workOfStep() const { return account_.force(); }
  /// What the last evaluate() or certify() took, and what was evaluated after it.
  const UpdateStatistics& statistics() const { return statistics_; }
  /// The bracket of the last evaluate().
  const std::optional<CriticalStep>& last() const { return step_; }
  /// Least eigenvalue of the reduced 1-rings and of the direction that were evaluated last, rad²/s².
  struct LowestRing {
    double value;
    ElementRef element;
  };
  const LowestRing& lowestRing() const { return lowest_; }

  template <class Archive>
  void archive(Archive& a) {
    a(slack_, account_, spent_, atShares_, uncertified_, nodal_, exchange_, local_, localNodes_, regionBound_,
      discreteAlone_, softest_, mode_, method_, statistics_, bracketed_, finite_, cheapest_, sharpening_,
      sharpeningRestart_, searchesNext_, wholeMode_, restart_, search_, examination_, lowest_, nextCompressed_, least_,
      searchedAt_, step_, best_, bestAt_, gain_, ofMoved_, observations_);
    a(restRuns_, restEndedEarly_, restFailed_, leastCertified_);
    archiveOptional(a, rest_, body_);
    archiveOptional(a, moved_, body_);
    archiveVersion(a, bestVersion_, body_.version());
  }

 private:
  const std::optional<CriticalStep>& follow(NodeVectorsView x, const StepRule& limit, std::optional<double> h,
                                            StepEvaluation* evaluation);
  /// Where the step follows the bracket: whether the moved bound serves as the upper side, which is what it then
  /// proves. It is started once a wide bracket has cost as much as that takes, in steps that were shorter than they
  /// could be, and given up when it takes more than it saves. `evaluation` is filled in, and becomes nullptr.
  bool follows(NodeVectorsView x, StepEvaluation*& evaluation, UpperBound& upper);
  /// Makes the bound at rest; lets it run once the certified eigenvalue has risen, since in slow motion validity balls
  /// take less; and makes it again, with better weights, where these were ended early and the budget affords it.
  void prepareRest(NodeVectorsView x);
  /// By the weights of the first observation, which is free; later by new ones, which are paid for.
  void makeRest(NodeVectorsView x);
  void spendOnSweeps(double work);
  /// The upper side by the bound at rest, as narrow as the budget allows. `evaluation` is filled in, and becomes
  /// nullptr.
  bool followsFromRest(NodeVectorsView x, StepEvaluation*& evaluation, UpperBound& upper);
  bool observed() const { return observations_ > 0; }
  /// What a step takes beside the moved bound, on average.
  double workOfStepBesideMoved() const;
  /// Threshold mode: proves sigma by shares, where the weights do not, or hardly, at the first observation, and later
  /// once all has taken as much work since shares were made last as making some does: so at most about twice the least
  /// is spent.
  bool proveByShares(NodeVectorsView x, double sigma);
  /// All work but that of tests and of searches for negative stiffness, which no proof saves.
  double workOfProofs() const;
  /// Sets the slack to what can be paid for: elements leave larger balls less often.
  void adaptSlack();
  /// The state has no tangent: nothing that is known of the modes can be carried over it.
  void forget();
  /// Only elements under compression can make the tangent indefinite. When there are some, their rings are evaluated
  /// now and then, and a direction of negative stiffness is searched in the whole body: at the first evaluation, when
  /// compression has grown since the last search, and else more and more seldom.
  void searchUnderCompression(NodeVectorsView x);
  /// The top mode jumps to where an element has become stiffer than it had been: rings there are examined at once.
  LowerBound boundWhereItRose(NodeVectorsView x, double sigma, LowerBound lower);
  /// And to where contact has begun, or a spring has become stiffer.
  LowerBound boundWhereItTouches(NodeVectorsView x, LowerBound lower);
  /// Searches the mode around the stiffest nodes of the body, and follows it where it is highest.
  LowerBound boundWhereItIsStiff(NodeVectorsView x, LowerBound lower);
  /// Searches around so many of them; whether the bound is above `lower`, which it then becomes. The tracked mode then
  /// has its top.
  bool searchStiffNodes(NodeVectorsView x, std::size_t nodes, LowerBound& lower);
  /// Examines the reduced ring of an element: whether its bound is above what is known, `lower`, which it then becomes.
  /// The tracked mode then has its top.
  bool examineRing(NodeVectorsView x, ElementRef e, LowerBound& lower);
  /// The same for an element at a node, where there is work for it. False at a node that has no element left.
  bool examineRingAt(NodeVectorsView x, std::int32_t node, LowerBound& lower);
  /// The reduced ring of one element into solver_; false when it fails.
  bool decomposeRing(NodeVectorsView x, ElementRef e, WorkOn what = WorkOn::mode);
  /// The step of a bound and of the region's, of which it is known what dashpots give: the smaller one.
  double optimisticOf(LowerBound lower, const StepRule& limit) const;
  /// Starts the mode again from the highest of all rings.
  LowerBound restartMode(NodeVectorsView x);
  /// Starts the mode at the first evaluation, when the nodal bound is of these positions: from the highest of the rings
  /// where that bound is highest, or, where its weights were ended early and say little of that, of the stiffest nodes.
  LowerBound startMode(NodeVectorsView x);
  /// The highest eigenvalue, rounded down, of the ring that was decomposed last, and that one's vector.
  double topOfRing() const;
  void addTopOfRing(NodeVectors& mode) const;
  LowerBound refreshMode(NodeVectorsView x, int products);
  /// The region's bound. The mode there is improved while that can be afforded.
  LowerBound boundOfRegion(NodeVectorsView x);
  /// Whether the region's bound at every observation takes most of what the mode may take.
  bool regionIsDear() const;
  double workOfRestart() const;
  void charge(WorkOn what, double work);
  bool affords(double work) const;
  bool affordsSearch(double work) const;
  LowerBound followMode(NodeVectorsView x, LowerBound whole);

  const Body& body_;
  BracketPolicy policy_;
  double width_, slack_;  // slack_: of the certified eigenvalue, as large as the budget makes it
  WorkAccount account_;
  Work spent_;                // on the lower side and on searches
  double atShares_ = 0;       // workOfProofs() when shares were made last in threshold mode
  bool uncertified_ = false;  // the step, by the upper side
  bool forVerdict_ = false;   // what is done now is for the verdict
  IncrementalNodalBound nodal_;
  IncrementalExchangeBound exchange_;
  std::optional<RestBound> rest_;
  bool restRuns_ = false, restEndedEarly_ = false, restFailed_ = false;  // a state was beyond what is known of a law
  double leastCertified_ = infinity;                                     // by the weights, since it was made
  std::optional<MovedBound> moved_;                                      // while it serves
  /// In WorkAccount's units. gain_: what shorter steps than they could be have cost while it does not serve; what it
  /// has saved, while it does. A step saves its force, and the rest of what the monitor does for one.
  double gain_ = 0, ofMoved_ = 0;
  std::int64_t observations_ = 0;  // after the first, what comes is paid for
  LocalMode local_, scout_;
  StiffNodes stiff_;
  std::size_t localNodes_;
  LowerBound regionBound_{0};  // when the region was chosen last
  /// What discrete forces give a node alone, rad²/s².
  struct DiscreteAlone {
    double value;
    std::int32_t node;
  };
  std::vector<DiscreteAlone> discreteAlone_;  // where they are at the last evaluation, by node
  NodeSubmatrix ringNodes_;
  LowestModeSearch softest_;
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver_;
  NodeVectors mode_;
  std::string_view method_;
  UpdateStatistics statistics_;
  bool bracketed_ = true, finite_ = true;
  // Of certify(): the cheapest way, in observations in a row that certified the step asked about.
  Backoff cheapest_;
  // Of sharpen(): refreshes, in observations; restarts from all rings, in refreshes.
  Backoff sharpening_, sharpeningRestart_;
  bool searchesNext_ = true;  // under a budget: the mode is searched, else followed
  // In evaluations: of the whole mode, restarts from all rings, searches for a negative direction, compressed rings.
  Backoff wholeMode_, restart_, search_, examination_;
  LowestRing lowest_{0, {}}, lowestHere_{0, {}};  // lowestHere_: of what was evaluated at the very state
  std::size_t nextCompressed_ = 0;
  LowestMode least_;                         // what the last search for a negative direction proved
  double searchedAt_ = 0;                    // the compression then
  std::optional<CriticalStep> step_, best_;  // best_: from scratch, of positions bestAt_ and that version of the body
  NodeVectors bestAt_;
  std::int64_t bestVersion_ = 0;
};

}  // namespace ringwatch

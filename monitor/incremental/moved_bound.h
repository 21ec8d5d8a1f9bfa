#pragma once
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <ringwatch/base/archive.h>
#include <ringwatch/base/backoff.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/short_floats.h>
#include <ringwatch/monitor/bounds.h>
#include <ringwatch/monitor/bounds/nodal_bound.h>
#include <ringwatch/monitor/incremental/exchange_certificate.h>
#include <ringwatch/monitor/incremental/moved_majorant.h>
#include <ringwatch/monitor/incremental/outside_balls.h>
#include <ringwatch/monitor/incremental/tangent_growth.h>

namespace ringwatch {

/// What a MovedBound trades work against width by. No constant here bears on what is proven (Theorem 97). Shares are of
/// the eigenvalue, rad²/s²; half of them of the step.
struct MovedBoundPolicy {
  /// Room of the level, to which elements may come inside their balls, above the highest node's own bound.
  double slack = 0.06;
  /// Part of the room that η takes, the rest being the balls'.
  double partOfGrowth = 0.5;
  double leastGrowth = 0.02, mostGrowth = 0.3;
  /// Share of the slack by which a node may exceed the level before the balls of its elements shrink.
  double tolerance = 0.25;
  /// A node is anchored anew once its bound has risen by this since it was last.
  double risen = 0.01;
  /// Sweeps of a rebuild, at most; it ends when two of them gain less than leastGain: 0.25 % of the step.
  int sweeps = 12;
  double leastGain = 0.005;
  /// Rebuilds that may not help, in observations. One costs as much as 150 to 400 steps.
  Backoff::Gaps rebuilds{.first = 40, .last = 10240, .factor = 4};
  /// Or at this share of the eigenvalue that is to be proven: 0.7 of the step.
  double enoughOfWanted = 0.5;
};

/// The block nodal bound moved along with a body (Theorem 97, docs/theory/moved_majorants.md). Each element has an
/// anchor: the gradients A_q, weights D_a and a value l with K(A) ≼ l D, from an exact evaluation. An element that
/// leaves its ball is visited: its majorant is moved there in closed form,
///   K(F) ≼ (1+η) l T D Tᵀ + τ L   while |F - F_visit| stays in the new ball,
/// with T the element's rotation, or with St. Venant-Kirchhoff F A⁻¹, and L ≼ diag(c_a) the scalar Laplacian. The bound
/// is the highest eigenvalue of the nodes' sums over their masses.
/// The proof is for the masses and the free components at that time: when the body's version has changed, the next
/// update starts from scratch.
class MovedBound {
 public:
  explicit MovedBound(const Body& body, const MovedBoundPolicy& policy = {});

  /// The bound at positions x (3×N, m). NaN when x or the tangent is not finite. Unless nullptr, `evaluation` is filled
  /// in at x by the pass that tests the elements; its visitor is not used. wanted: an eigenvalue that is to be proven,
  /// rad²/s²: elements may come up to it.
  UpperBound update(NodeVectorsView x, StepEvaluation* evaluation = nullptr, double wanted = 0);
  /// Lowers the bound at x, the positions of the last update, towards `aim`, rad²/s²: anchors the highest node
  /// anew, and others by evaluations of at most `most` elements in all.
  UpperBound improve(NodeVectorsView x, double aim, std::int64_t most);
  /// Threshold mode: whether the highest eigenvalue at x is proven to be at most sigma, rad²/s².
  bool certify(NodeVectorsView x, double sigma, StepEvaluation* evaluation = nullptr);

  double bound() const { return bound_; }
  /// What the last update() and what followed it took, in elements: evaluations, majorants that were moved, balls that
  /// got other radii alone.
  struct Statistics {
    std::int64_t evaluated = 0, visited = 0, fitted = 0;
  };
  const Statistics& statistics() const { return statistics_; }
  /// Elements that the last update() and what followed it evaluated or moved, with det F and -lambda_min(∂P/∂F) at
  /// most: an element that inverts is among them.
  const std::vector<ExchangeCertificate::Seen>& seen() const { return seen_; }
  /// The node where the bound is highest.
  std::int32_t highestNode() const;

  /// The largest relative excess of the proof's statements at x, from nothing but anchors, motions, weights and exact
  /// tangents: <= 0 when all hold, but for rounding. For tests.
  double verify(NodeVectorsView x) const;

  template <class Archive>
  void archive(Archive& a) {
    a(eta_, started_, bound_, level_, room_, weights_, nodes_, own_, whole_, rebuilds_, needed_, neededAt_);
    for (Elements& own : elements_)
      a(own.balls, own.anchor, own.motion, own.value, own.geometric, own.eta, own.uneven, own.negative, own.kappa,
        own.linear, own.quadratic, own.radius, own.inversionDistance, own.laplacian, own.counted);
    marked_.resize(nodes_.size());
    archiveVersion(a, bodyVersion_, body_.version());
  }

 private:
  using P = NativePack;
  enum class Motion {
    none,      ///< T = 1: what damps, or is not objective
    rotation,  ///< of an objective law
    stretch    ///< any T: St. Venant-Kirchhoff with one gradient a point
  };
  /// What is kept of a block, by place. Of the law: at the anchor, or with Motion::stretch at the last visit.
  struct Elements {
    ValidityBalls balls;
    Motion motionOfBlock;
    std::vector<std::uint8_t> rests = {};     // whether T = 1 whatever moves: with components that are held too
    AlignedVector<std::int16_t> anchor = {};  // A_q, [batch][q][9][lane], in ValidityBalls' units
    AlignedVector<float> motion = {};         // T, [batch][9][lane]
    std::vector<RoundedUp<float>> value = {}, geometric = {};
    std::vector<RoundedUp<Bfloat16>> eta = {}, uneven = {}, negative = {}, kappa = {}, linear = {}, quadratic = {};
    std::vector<RoundedDown<Bfloat16>> radius = {}, inversionDistance = {};
    std::vector<RoundedUp<Bfloat16>> laplacian = {};  // c_a, [batch][a][lane], m
    const DampedBlock* rates = nullptr;
    std::vector<double> counted = {};
    bool rateHasRisen(std::size_t place) const { return rates && rates->coefficient(place) > counted[place]; }
  };
  struct BatchRef {
    std::int32_t block, batch;
    auto operator<=>(const BatchRef&) const = default;
  };
  /// By node: the sum of the elements' majorants without their balls, N/m, and what its rounding comes to; what they
  /// may add inside their balls, Pa; γ = Σ c_a, m; the bound when the node was anchored last.
  struct Node {
    Symmetric3<double> sum;
    double rounding;
    float ball, gamma, anchored;
    template <class Archive>
    void archive(Archive& a) {
      a(sum, rounding, ball, gamma, anchored);
    }
  };
  /// The elements of a batch, one a lane, and what is known of them.
  struct Pack;
  void prepare();
  Pack load(BatchRef at) const;
  void store(const Pack& pack);
  void majorantsOf(const Pack& pack, Symmetric3<P>* majorants) const;
  void move(NodeVectorsView x, Pack& pack, bool anchoring);
  void anchor(Pack& pack);
  /// What a visit has found of a batch: whether its elements are numbers and within what is known of their laws.
  struct Found;
  void visit(NodeVectorsView x, BatchRef at, bool anchoring, Found& found, Symmetric3<P>* change);
  /// Brings batches to their gradients at x; with `anchoring` by exact evaluations. False where something is not
  /// finite.
  bool visit(NodeVectorsView x, std::span<const BatchRef> batches, bool anchoring);
  /// The radii of the balls of a batch for what its nodes allow.
  void fit(BatchRef at);
  std::vector<BatchRef> batchesAt(std::span<const std::int32_t> nodes) const;
  double allowedAt(std::int32_t node) const;
  void findLaplacian();
  void build(NodeVectorsView x, double wanted);
  /// The bounds of nodes whose sums have changed.
  void settle(std::span<const std::int32_t> nodes);
  void followDiscreteForces(NodeVectorsView x);
  /// Sets the level for the nodes as they are, and shrinks the balls of elements at nodes that are above it.
  void followLevel(double wanted);
  void findBound();
  void setBall(std::int32_t node, double most);
  std::size_t placeOf(ElementRef e) const {
    return static_cast<std::size_t>(body_.blocks()[e.block]->layout().batchOfElement[e.element]);
  }

  const Body& body_;
  MovedBoundPolicy policy_;
  NodalBound weights_;
  std::vector<Elements> elements_;
  std::vector<Node> nodes_;
  /// The bounds of nodes without the balls of their elements, and with them, rad²/s².
  std::vector<float> own_, whole_;
  double eta_ = 0, bound_ = infinity, level_ = infinity, room_ = infinity;
  bool started_ = false;
  std::int64_t bodyVersion_ = 0;  // that the proof is for
  Statistics statistics_;
  std::vector<ExchangeCertificate::Seen> seen_;
  Backoff rebuilds_;
  OutsideBalls outside_;
  AlignedVector<Symmetric3<P>> changes_;  // of the sums at nodes, of batches that are visited together
  std::vector<Eigen::Matrix3d> needed_;   // majorants of discrete forces
  std::vector<std::int32_t> neededAt_;
  std::vector<std::uint8_t> marked_;  // by node
};

}  // namespace ringwatch

#pragma once
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <ringwatch/base/archive.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/short_floats.h>
#include <ringwatch/body/body.h>
#include <ringwatch/monitor/bounds.h>
#include <ringwatch/monitor/bounds/nodal_bound.h>
#include <ringwatch/monitor/incremental/exchange_certificate.h>

namespace ringwatch {

/// What a RestBound trades work against width by. No constant here bears on what is proven (Theorem 98).
struct RestBoundPolicy {
  /// Deformation gradients of a group that shares one motion, which take a few times the work that the group itself
  /// does, and groups of a region whose nodes are bounded together.
  int gradientsOfGroup = 512, groupsOfRegion = 1;
  /// States from one measure of a group's compression to the next. Its elements are seen again once that has grown by
  /// this factor and this share of λ+2μ.
  int turns = 16;
  /// A group is measured as if it stood still while its mean motion differs from that by less.
  double still = 0.003;
  double compressionGrowth = 2, slightCompression = 1e-3;
  /// Two regions whose bounds differ by less, relative to the eigenvalue, are the same.
  double same = 0.005;
  /// Of the groups around a region those start again whose elements differ by more than this share of the most, once
  /// its bound has risen by so much of the eigenvalue since that gained something last.
  double uneven = 0.5, risen = 0.01;
};

/// The block nodal bound at rest moved along with the body (Theorem 98, docs/theory/moved_majorants.md): no tangent is
/// evaluated after it was made. With K(1) ≼ l D, the scalar Laplacian L of an element and T the mean of its gradients F
///   K(F) ≼ α R (l D) Rᵀ + τ L,   α, τ and R in closed form of T and |F - T|.
/// Groups of neighbouring elements have their majorants summed up at a reference state and one motion G each from
/// there: a pass over the body measures at every state by how much their gradients differ from G times those of the
/// reference. What turns costs nothing, and an even stretch what the law makes of it. The groups that make the bound
/// highest are given new references, in closed form again. Discrete forces add what they may come to at a node. For
/// bodies without rigid bodies and elements that damp, of isotropic laws.
class RestBound {
 public:
  /// Whether bodies like this one have the bound.
  static bool serves(const Body& body);
  explicit RestBound(const Body& body, const RestBoundPolicy& policy = {});
  bool started() const { return started_ && bodyVersion_ == body_.version(); }
  /// Makes the bound at rest with these weights, whose last evaluation was at rest. valueAtRest: l of the elements
  /// there, N/m, where the weights have given theirs back. Infinite where that is not finite.
  void start(NodalBound weights, const std::function<double(ElementRef)>& valueAtRest = {});

  /// The bound at positions x (3×N, m); infinite where a motion is beyond what is known of a law, NaN where an F is not
  /// finite. Unless nullptr, `evaluation` is filled in at x by the pass that measures the groups; its visitor is not
  /// used. enough: a bound that needs not be lowered, rad²/s²; most: elements that may have x as a new reference.
  UpperBound update(NodeVectorsView x, StepEvaluation* evaluation, double enough, std::int64_t most);
  /// What the last update() took: elements that have a new reference, and nodes that were bounded.
  struct Statistics {
    std::int64_t elements = 0, nodes = 0;
  };
  const Statistics& statistics() const { return statistics_; }
  /// The node where the last bound is highest.
  std::int32_t highestNode() const { return node_; }

  /// The majorant of a node at the positions of the last update() over its mass, rad²/s², in its free components: the
  /// tangent of the body over the roots of the masses is at most the matrix that has these blocks. Slow, for tests.
  Eigen::Matrix3d majorantAt(std::int32_t node) const;

  /// Elements that the last update() came across, with det F and -lambda_min(∂P/∂F) at most: those under compression,
  /// or no longer, and any element that inverts.
  const std::vector<ExchangeCertificate::Seen>& seen() const { return seen_; }

  template <class Archive>
  void archive(Archive& a) {
    archiveOptional(a, weights_, body_);
    a(started_, states_, restHighest_, laplacianHighest_, values_, laplacian_, reference_, compressed_, groups_, next_,
      last_, flags_, packBegin_, parts_, regions_);
    archiveVersion(a, bodyVersion_, body_.version());
  }

 private:
  using P = NativePack;
  /// Batches of a block that share a motion. Stresses and moduli in Pa.
  struct Group {
    std::int32_t block, patch, begin, end;  // batches
    std::uint8_t follows;                   // 1: G is diagonal, as components of some nodes are held
    std::uint8_t rests;                     // whether the reference gradients are the identity
    // At the reference, of all elements: what F errs by, |F - T| and |F| at most, the least principal stretch at least,
    // the highest principal stress, and how fast the tangents grow; the mean of F and of the distances from it at most.
    double rounding, uneven, size, leastStretch, stress, mean[9], apart;
    TangentDriftCoefficients<double> drift;
    double spread;             // spreadOf(drift.kappa)
    double seenNegative;       // -lambda_min(∂P/∂F) at most, when its elements were seen last
    double count, inverse[9];  // of the elements, and of Σ F at the first points, row by row
    double delta, summedAt;    // of this state, and when Σ F was known last: |F - G F'| at most
    std::int64_t referenceAt;  // the state
    template <class Archive>
    void archive(Archive& a) {
      a(block, patch, begin, end, follows, rests, rounding, uneven, size, leastStretch, stress, mean, apart,
        drift.kappa, drift.linear, drift.quadratic, drift.negative, drift.radius, spread, seenNegative, count, inverse,
        summedAt, referenceAt);
    }
  };
  /// How a group moves its part of a node's sum: 1+η, τ beside what the reference has, and √(1+η) G; still: G = 1.
  struct Motion {
    double growth, added;
    bool still;
    double matrix[9];
    template <class Archive>
    void archive(Archive& a) {
      a(growth, added, still, matrix);
    }
  };
  /// The part that a group has in the sums of a pack of nodes, over their masses: Σ R l D Rᵀ + .., which moves, what
  /// does not, and Σ c; of no weight where a node has fewer parts.
  struct PackOfParts {
    std::int32_t group[lanes], node[lanes];  // node < 0: none
    float weight[6][lanes], geometric[lanes], laplacian[lanes];
    template <class Archive>
    void archive(Archive& a) {
      a(group, node, weight, geometric, laplacian);
    }
  };
  /// Where the part of a group at a node is; local: the node in its patch.
  struct Place {
    std::int32_t node, part;
    std::uint16_t local, lane;
  };
  /// Groups that lie side by side, the nodes that are theirs first, and the groups at these. Of the state at which the
  /// nodes were bounded last: the highest λ_max and trace of what moves, and the groups' motions then.
  struct Region {
    std::int32_t packBegin, packEnd;  // of nodes
    std::int32_t node;                // one of them
    std::vector<std::int32_t> around;
    std::vector<Motion> base;  // of these groups; the inverse of the matrix
    bool still;                // whether all of these are
    double weight, trace, laplacian;
    double lowest;  // bound that new references gave last, or less
    std::int64_t boundedAt, referredAt;
    template <class Archive>
    void archive(Archive& a) {
      a(packBegin, packEnd, node, around, base, still, weight, trace, laplacian, lowest, boundedAt, referredAt);
    }
  };
  /// λ and 2μ of a block at rest, Pa, and whether its tangents stretch as T does (St. Venant-Kirchhoff).
  struct Rest {
    double lambda, twoMu;
    bool stretches, hourglass;
    int gradients;  // of an element
  };
  /// What a law makes of the motion of a batch from rest: K(F) ≼ R K(1) Rᵀ + added L + geometric L, of which the last
  /// does not turn.
  struct Moved {
    Matrix3<P> R;
    P added, geometric, stress;
  };

  void makeGroups();
  void makeRegions();
  void index();
  bool isHeld(std::int32_t node) const {
    return body_.constraints().any() && body_.constraints().freeComponents(node) == 0;
  }
  /// √(κ γ/w), so that (1+η) w + (1+1/η) κ δ² γ is least at the highest nodes for η = δ times it.
  double spreadOf(double kappa) const { return std::sqrt(kappa * laplacianHighest_ / restHighest_); }
  /// Gives a group x as its reference.
  void refer(NodeVectorsView x, std::int32_t g);
  Moved stretched(const Group& group, const Matrix3<P>* F, const Matrix3<P>& T, const P& delta) const;
  /// there: the coefficients of the law at T.
  Moved turned(const Group& group, const Matrix3<P>& T, const P& delta, TangentDriftCoefficients<P>& there) const;
  /// Takes a motion for G at the next state, as far as the group may have it; what is slight is none. summed: whether
  /// the sum of the gradients is wanted there in any case.
  void setNext(std::int32_t g, Matrix3<double> motion, bool summed);
  Matrix3<double> nextOf(std::int32_t g) const;
  void measure(NodeVectorsView x, StepEvaluation* evaluation);
  /// By how much the highest principal stress of St. Venant-Kirchhoff can have risen in a group since its reference,
  /// Pa, where all F differ from G times those of the reference by delta at most.
  double stressRisen(const Group& group, const Matrix3<double>& G, double delta) const;
  /// The motion of a group as measured, and G for the next state. False where an F is not finite.
  bool follow(std::int32_t g);
  /// The bound of a region's nodes: by the motions since they were bounded last, and from all their parts.
  double movedBound(const Region& region) const;
  double turnedBound(const Region& region) const;
  double boundNodes(Region& region);
  /// What discrete forces may come to at x, and at most at a node of each region.
  void followDiscreteForces(NodeVectorsView x);
  double lowestBound(NodeVectorsView x, double enough, std::int64_t most);
  /// Whether elements of a group may have inverted, or are more compressed than when they were seen last.
  bool isToBeSeen(std::int32_t g) const;
  /// Elements of a group: all, or those of batches that are compressed or were.
  void see(NodeVectorsView x, const Group& group, bool all);

  const Body& body_;
  RestBoundPolicy policy_;
  std::optional<NodalBound> weights_;
  bool started_ = false;
  std::int64_t bodyVersion_ = 0, states_ = 0;
  double restHighest_ = 0, laplacianHighest_ = 0;            // of all nodes
  std::vector<std::vector<RoundedUp<float>>> values_;        // l, N/m: [block][batch][lane]
  std::vector<std::vector<RoundedUp<Bfloat16>>> laplacian_;  // c, m: [block][batch][a][lane]
  std::vector<AlignedVector<std::int16_t>> reference_;       // F: [block][batch][q][9][lane], ValidityBalls' units
  std::vector<std::vector<std::uint8_t>> compressed_;        // [block][batch]: 1 now, 2 when seen last
  std::vector<Group> groups_;
  AlignedVector<float> next_;            // G for the next state over BatchMotion's unit: [group][9]
  AlignedVector<double> last_;           // that of the last: [group][9]
  std::vector<std::uint8_t> flags_;      // BatchMotion::Flags
  std::vector<std::int32_t> packBegin_;  // of the packs of nodes, into parts_
  AlignedVector<PackOfParts> parts_;
  std::vector<Region> regions_;
  // What follows from these and the body.
  std::vector<Rest> rest_;
  std::vector<std::vector<std::int32_t>> groupOfBatch_;  // [block][batch]
  std::vector<std::vector<Place>> places_;               // [group]
  std::vector<std::vector<std::int32_t>> regionsOf_;     // [group]
  std::vector<std::int32_t> regionOfNode_;               // -1: none
  // Of this state.
  AlignedVector<float> measured_;  // BatchMotion::measured
  std::vector<Motion> motions_;
  std::vector<Eigen::Matrix3d> needed_;    // majorants of discrete forces, N/m
  std::vector<std::int32_t> neededAt_;     // where they are not zero
  std::vector<double> bounds_, discrete_;  // [region]; of discrete forces alone
  std::int32_t node_ = 0;                  // where it is highest
  Statistics statistics_;
  std::vector<ExchangeCertificate::Seen> seen_;
  Body::Workspace workspace_;
};

}  // namespace ringwatch

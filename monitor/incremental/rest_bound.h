#pragma once
#include <cstdint>
#include <vector>

#include <ringwatch/base/archive.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/monitor/bounds.h>
#include <ringwatch/monitor/bounds/nodal_bound.h>
#include <ringwatch/monitor/incremental/exchange_certificate.h>

namespace ringwatch {

/// What a RestBound trades work against width by. No constant here bears on what is proven (Theorem 98).
struct RestBoundPolicy {
  /// Elements of a group that shares one motion, and groups of a region whose nodes are bounded together.
  int elementsOfGroup = 32, groupsOfRegion = 4;
  /// States from one centre of a group to the next.
  int turns = 16;
  /// Elements are seen again once the compression of their group has grown by this factor and this share of λ+2μ.
  double compressionGrowth = 1.5, slightCompression = 1e-3;
  /// Two regions whose bounds differ by less, relative to the eigenvalue, are the same.
  double same = 0.005;
};

/// The block nodal bound at rest moved along with the body (Theorem 98, docs/theory/moved_majorants.md): nothing is
/// evaluated after it was made. Groups of neighbouring elements have one motion T each, of which the elements'
/// gradients F = T + Δ, |Δ| <= δ, tell how uneven it is; a pass over the body measures δ at every state. With K(1) ≼ l
/// D and the scalar Laplacian L of an element
///   K(F) ≼ α R (l D) Rᵀ + τ L,
/// α, τ and R in closed form of T and δ. What turns costs nothing, and an even stretch what the law makes of it.
/// For bodies without discrete forces, rigid bodies and elements that damp, of isotropic laws.
class RestBound {
 public:
  /// Whether bodies like this one have the bound.
  static bool serves(const Body& body);
  explicit RestBound(const Body& body, const RestBoundPolicy& policy = {});
  bool started() const { return started_ && bodyVersion_ == body_.version(); }
  /// Makes the bound at rest with these weights, which are evaluated there once. Infinite where that is not finite.
  void start(NodalBound weights);

  /// The bound at positions x (3×N, m); infinite where δ is beyond what is known of a law, NaN where an F is not
  /// finite. Unless nullptr, `evaluation` is filled in at x by the pass that measures the groups; its visitor is not
  /// used. enough: a bound that needs not be lowered, rad²/s²; `most`: elements whose gradients may be gone through
  /// again to lower it.
  UpperBound update(NodeVectorsView x, StepEvaluation* evaluation, double enough, std::int64_t most);

  /// The elements whose gradients were gone through, with det F and -lambda_min(∂P/∂F) at most: an element that inverts
  /// is among them.
  const std::vector<ExchangeCertificate::Seen>& seen() const { return seen_; }

  template <class Archive>
  void archive(Archive& a) {
    a(started_, states_, groups_, centres_, restHighest_, laplacianHighest_, packBegin_, parts_, regions_);
    archiveVersion(a, bodyVersion_, body_.version());
  }

 private:
  /// Batches of a block that share a motion.
  struct Group {
    std::int32_t block, begin, end;  // batches
    std::uint8_t follows;            // 1: T is diagonal, as components of some nodes are held
    // Of the centre: what F errs by there, the least principal stretch, and what the law makes of it:
    // K(T) ≼ ofRest R K(1) Rᵀ + beside L, and how fast the tangent grows from there. Of a group that stretches: the
    // greatest stretch squared, the highest principal stress, and T as the turn.
    double rounding, leastStretch, ofRest, beside;
    TangentDriftCoefficients<double> drift;
    double turn[9];
    double negative,
        seenNegative;  // -lambda_min(∂P/∂F) at most at the centre, and when its elements were seen last, Pa
    // Of this state: δ, and where the group is settled the highest principal stress of its elements.
    double delta, stress;
    bool settled;
    template <class Archive>
    void archive(Archive& a) {
      a(block, begin, end, follows, rounding, leastStretch, ofRest, beside, drift.kappa, drift.linear, drift.quadratic,
        drift.negative, drift.radius, turn, negative, seenNegative);
    }
  };
  /// How a group moves its part of a node's sum: √α R and τ.
  struct Motion {
    double matrix[9], added;
  };
  /// What a group has at a node: Σ l D and Σ c over the node's mass.
  struct Part {
    std::int32_t group;
    float weight[6], laplacian;
  };
  /// A part of each of a pack of nodes, one a lane; of no weight where a node has fewer.
  struct PackOfParts {
    std::int32_t group[lanes];
    float weight[6][lanes], laplacian[lanes];
    template <class Archive>
    void archive(Archive& a) {
      a(group, weight, laplacian);
    }
  };
  /// Groups that lie side by side, the nodes that are theirs first, the groups at these, and the highest of what the
  /// nodes have: λ_max(Σ W), Σ λ_max(W), Σ c.
  struct Region {
    std::int32_t begin, end;
    std::int32_t packBegin, packEnd;  // of nodes
    std::vector<std::int32_t> around;
    double weight, weights, laplacian;
    double bound;            // of this state
    std::int32_t settledAt;  // how many regions had been settled when its nodes were bounded; -1: they were not
    template <class Archive>
    void archive(Archive& a) {
      a(begin, end, packBegin, packEnd, around, weight, weights, laplacian);
    }
  };

  void makeGroups();
  /// The parts of each node, by group.
  std::vector<std::vector<Part>> sumWeights(const NodalBound& weights) const;
  void makeRegions(const std::vector<std::vector<Part>>& partsOfNode);
  void index();
  /// Whether no lane of a batch has an element.
  bool isEmpty(const Group& group, std::int32_t batch) const {
    return body_.blocks()[group.block]->layout().elements[static_cast<std::size_t>(batch) * lanes] < 0;
  }
  Matrix3<double> meanOf(std::size_t g) const;
  /// δ of a group; not finite where an F is not.
  double unevennessOf(std::size_t g) const;
  double lowestBound(NodeVectorsView x, double enough, std::int64_t most);
  void measure(NodeVectorsView x, StepEvaluation* evaluation);
  /// Gives a group its mean gradient at x as a centre, and finds δ and the stresses of its elements there.
  void settle(NodeVectorsView x, std::size_t g);
  /// Takes a gradient for the centre of a group, and finds what the law makes of it.
  void centre(std::size_t g, Matrix3<double> gradient);
  /// The motion of a group as it is.
  void move(std::size_t g);
  /// A bound of all nodes of a region from the motions of its groups alone.
  double boundOfAll(const Region& region) const;
  /// The highest of the nodes' own bounds.
  double boundOfNodes(const Region& region) const;

  const Body& body_;
  RestBoundPolicy policy_;
  bool started_ = false;
  std::int64_t bodyVersion_ = 0;
  std::vector<Group> groups_;
  std::vector<std::vector<std::int32_t>> groupOfBatch_;  // [block][batch]
  AlignedVector<double> centres_;
  std::vector<AlignedVector<double>> farthest2_, sums_;
  std::vector<std::vector<std::uint8_t>> wantsSum_;
  std::vector<Motion> motions_;
  std::int64_t states_ = 0;
  /// λ and 2μ of each block at rest, Pa, and whether its tangents stretch as T does (St. Venant-Kirchhoff).
  struct Rest {
    double lambda, twoMu;
    bool stretches, hourglass;
    int gradients;  // a rule of uniform strain has one
  };
  std::vector<Rest> rest_;
  double restHighest_ = 0, laplacianHighest_ = 0;  // of all nodes
  std::vector<std::int32_t> packBegin_;            // of the packs of nodes, into parts_
  AlignedVector<PackOfParts> parts_;
  std::vector<Region> regions_;
  std::vector<ExchangeCertificate::Seen> seen_;
  Body::Workspace workspace_;
  AlignedVector<Matrix3<NativePack>> gradients_;
};

}  // namespace ringwatch

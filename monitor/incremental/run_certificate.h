#pragma once
#include <limits>
#include <vector>

#include <Eigen/Geometry>

#include <ringwatch/base/short_floats.h>
#include <ringwatch/monitor/incremental/certificate_state.h>
#include <ringwatch/monitor/incremental/outside_balls.h>
#include <ringwatch/monitor/incremental/rebuild_policy.h>
#include <ringwatch/monitor/incremental/work_account.h>

namespace ringwatch {

/// What an update of an incremental certificate took, and what it saw.
struct UpdateStatistics {
  std::int64_t evaluated = 0;  ///< elements
  int localUpdates = 0, raises = 0, refreshes = 0, rebuilds = 0;
  Work work;  ///< WorkAccount's units
  double leastDeterminant =
      std::numeric_limits<double>::infinity();  ///< det F of the elements outside their balls whose law does not allow
                                                ///< inversion; no other of them can be <= 0
  ElementRef leastDeterminantElement;
};

/// The state of a certificate along a run (Theorems 14 to 19 and 21, docs/theory/incremental_certificate.md):
/// allowances stay as they are while every element is inside its validity ball, the ball around the reference gradient
/// at which it was last evaluated within which TangentGrowth keeps l_e <= β_e. All stored numbers are rounded to the
/// safe side by their types.
class RunCertificate : public CertificateState<RoundedDown<float>> {
 public:
  explicit RunCertificate(const Body& body);

  /// l_e at the reference gradient, N/m, or what it is below.
  double value(ElementRef e) const { return static_cast<double>(of(e).value[placeOf(e)]); }
  double strainNorm(ElementRef e) const { return static_cast<double>(of(e).strainNorm[placeOf(e)]); }
  void setStrainNorm(ElementRef e, double norm) { of(e).strainNorm[placeOf(e)] = norm; }

  /// An evaluation, and how far the stored reference gradient lies from the exact one.
  struct Reference {
    double value;
    TangentDrift drift;
    double fromStored;
  };
  /// An element that has left its ball, and the allowance over its own that a larger ball around its reference gradient
  /// needs by Theorem 16: infinity where only an evaluation helps.
  struct ElementOutside {
    ElementRef element;
    double need;
    /// Whether another one is needier, so that a heap has the neediest in front.
    bool operator<(const ElementOutside& other) const {
      return need != other.need ? need < other.need : other.element < element;
    }
  };
  /// Gives elements that have left their balls the balls that their allowances have room for, about their gradients at
  /// x where inversion ended them, and returns those for which that is not enough. Evaluates no element. Inverted ones
  /// stay outside. x: the positions of the last elementsOutsideBall.
  std::vector<ElementOutside> growBalls(NodeVectorsView x, const std::vector<ElementRef>& elements);
  /// The same for elements outside their balls once a raise serves their needs.
  void growBalls(std::span<const ElementOutside> violating);
  /// Raises the allowances of elements that were evaluated at the positions of the last elementsOutsideBall to their
  /// values and a share of them, and the certified eigenvalue to what their nodes, of a part of a body its own ones,
  /// then need.
  void raiseToValues(const std::vector<ElementRef>& elements, double share);
  /// Evaluates elements at x: values, reference gradients, balls for their allowances, and with weights that have
  /// changed strain norms.
  void evaluate(NodeVectorsView x, const std::vector<ElementRef>& elements, bool withStrainNorm,
                std::vector<Reference>& results);
  /// The ball of an element that has just been evaluated, for the allowance that it has.
  void setBall(ElementRef e, const Reference& reference);
  /// The ball around the reference gradients that there are, for an allowance that has changed.
  void fitBall(ElementRef e);
  /// Whether the sum at a node is above what the certified eigenvalue allows there, or may be by rounding.
  bool exceeds(std::int32_t node) const;
  /// Takes the majorants of discrete forces at x, with room. Allowances have to be distributed after it.
  void renewMajorants(NodeVectorsView x);
  /// Raises the majorants of discrete forces where those at x are larger, and returns the nodes whose sums exceed the
  /// certified eigenvalue then.
  std::vector<std::int32_t> followDiscreteForces(NodeVectorsView x);
  /// Lowers the majorants of discrete forces that have become smaller.
  void releaseDiscreteForces(NodeVectorsView x);
  /// The certified eigenvalue below that majorants alone are too large.
  double leastForDiscreteForces() const;
  /// Raises the certified eigenvalue to what nodes need, and a share more.
  void raiseForNodes(const std::vector<std::int32_t>& nodes, double share);
  /// The elements that are outside their balls at x (OutsideBalls::find); its work is counted.
  std::vector<ElementRef> elementsOutsideBall(NodeVectorsView x, StepEvaluation* evaluation);

  /// Gives every element the largest allowance that its nodes have room for below the certified eigenvalue, in
  /// proportion to its value, and a ball around x. weights() must have been evaluated at x.
  /// newWeights: strain norms are out of date.
  void distributeAllowances(NodeVectorsView x, bool newWeights = true);
  /// Turns the weights of all nodes with the body (rotateWeights); what needs them has to be evaluated again. False
  /// when none has turned enough.
  bool rotateWithBody(NodeVectorsView x, const RebuildPolicy& policy);
  /// Moves the certified eigenvalue, and all allowances and balls with it.
  void moveTo(double certifiedEigenvalue);
  /// D ← Q D Qᵀ for all elements at a node, Q the rotation of its surroundings since its weights were made: with one Q
  /// for all of them the eigenvalues of their sum stay, but for rounding, for which the allowances there are reduced.
  /// Nodes with constrained components are left alone, as are those that have turned by less than leastRotation.
  /// Reference gradients must be those of the positions at hand. Returns the nodes that were turned; balls and strain
  /// norms of their elements are out of date.
  std::vector<std::int32_t> rotateWeights(const std::vector<std::int32_t>& nodes, const RebuildPolicy& policy);
  /// The rotation of a node's surroundings since the reference configuration, by reference gradients of its elements.
  Eigen::Quaternionf frameOf(std::int32_t node) const;
  /// The rotation of its surroundings when the node's weights were made or turned last.
  const Eigen::Quaternionf& frame(std::int32_t node) const { return frames_[node]; }
  void setFrame(std::int32_t node, const Eigen::Quaternionf& frame) { frames_[node] = frame; }

  /// What has been found of an element elsewhere, at the positions at hand: det F, and -lambda_min(∂P/∂F) at most.
  void note(ElementRef e, double determinant, double negative);
  /// The `count` elements whose -lambda_min(∂P/∂F) over λ+2μ was highest when last evaluated, of those above `least`:
  /// most first.
  std::vector<ElementRef> mostCompressed(double least, std::size_t count) const;
  /// As many of these as come next in memory, from place `next` of all blocks on, which goes on behind them.
  std::vector<ElementRef> compressedByTurns(double least, std::size_t count, std::size_t& next) const;
  /// The largest of these since allowances were distributed.
  double mostCompression() const { return mostCompression_; }
  /// The elements that hold most of the bound by the last values at the `count` nodes where it is highest.
  std::vector<ElementRef> highestElements(std::size_t count);

  UpdateStatistics& statistics() { return statistics_; }
  const UpdateStatistics& statistics() const { return statistics_; }

  template <class Archive>
  void archive(Archive& a) {
    CertificateState::archive(a);
    for (BlockData& b : blocks_)
      a(b.balls, b.value, b.strainNorm, b.compression, b.linear, b.quadratic, b.growthRadius, b.inversionDistance,
        b.counted);
    a(frames_, mostCompression_, statistics_, majorantsAt_);
  }

 private:
  /// What is known of the elements of a block, by place. compression: -lambda_min(∂P/∂F) / (λ+2μ) at the reference
  /// gradient, at most. linear, quadratic, growthRadius: TangentGrowth's; < 0: there is no reference gradient.
  /// inversionDistance: TangentDrift's, infinity where the law is made for inversion.
  /// rates: the block where its damping depends on velocities, else nullptr; counted: its coefficients of the elements
  /// when they were last evaluated.
  struct BlockData {
    ValidityBalls balls;
    std::vector<RoundedUp<float>> value;
    std::vector<RoundedUp<Bfloat16>> strainNorm, compression, linear, quadratic;
    std::vector<RoundedDown<Bfloat16>> growthRadius, inversionDistance;
    const DampedBlock* rates = nullptr;
    std::vector<double> counted = {};
    bool rateHasRisen(std::size_t place) const { return rates && rates->coefficient(place) > counted[place]; }
    TangentGrowth growth(std::size_t place) const {
      return {value[place], linear[place], quadratic[place], growthRadius[place]};
    }
    TangentGrowthOf<NativePack> growthOfPack(std::size_t first) const {
      return {RoundedUp<float>::load(value.data() + first), RoundedUp<Bfloat16>::load(linear.data() + first),
              RoundedUp<Bfloat16>::load(quadratic.data() + first),
              RoundedDown<Bfloat16>::load(growthRadius.data() + first)};
    }
  };
  /// How far the values of the elements at nodes of discrete forces can grow together below the certified eigenvalue:
  /// by place, -1 where they have no majorant now.
  std::vector<double> scalingsBesideDiscreteForces() const;
  /// Reduces the allowances of elements at nodes of discrete forces whose sums exceed the certified eigenvalue.
  void reduceBesideDiscreteForces();
  /// The highest eigenvalue of the sum of allowances over the mass of each node, rad²/s².
  std::vector<double> sumsAt(const std::vector<std::int32_t>& nodes) const;
  BlockData& of(ElementRef e) { return blocks_[e.block]; }
  const BlockData& of(ElementRef e) const { return blocks_[e.block]; }
  /// Moves the ball of an element to its gradients F[(q * 9 + i) * lanes + lane], with a bound of its l_e there. False,
  /// and nothing is changed, where little would be left of it.
  bool moveBall(ElementRef e, const double* F, int lane, const TangentDrift& drift, double value);
  Reference store(const EvaluatedPack& pack, int lane, bool withStrainNorm);
  void note(ElementRef e, const TangentDrift& drift) { note(e, drift.determinant, drift.law.negative); }

  /// What an element outside its ball needs to stay inside, and what its law says at its gradients.
  struct Need {
    double allowance;
    TangentDrift drift;
  };

  int elementsOfFrame_ = RebuildPolicy{}.elementsOfFrame;
  std::vector<BlockData> blocks_;
  std::vector<Eigen::Quaternionf> frames_;
  double mostCompression_ = 0;
  UpdateStatistics statistics_;
  OutsideBalls outsideBalls_;
  // Majorants of discrete forces: by place, and where they are not zero. Those that count are the weights'.
  std::vector<Eigen::Matrix3d> needed_, withRoom_;
  std::vector<std::int32_t> neededAt_, withRoomAt_, majorantsAt_;
  std::vector<Need> needs_;  // of growBalls, kept for its memory
};

}  // namespace ringwatch

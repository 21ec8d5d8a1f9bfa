#pragma once
#include <limits>
#include <vector>

#include <Eigen/Geometry>

#include <ringwatch/base/backoff.h>
#include <ringwatch/body/body.h>
#include <ringwatch/monitor/nodal_bound.h>
#include <ringwatch/monitor/validity_balls.h>

namespace ringwatch {

/// The block nodal bound kept along a run at little cost. Shapes D_e, a budget for each element and the bound sigma
/// stay frozen while every element is inside a ball around the deformation gradient at which it was last evaluated:
///   l_e <= budget_e for all e  and  Σ_(e∋i) budget_e D_(e,a(i)) ≼ sigma m_i I for all i   prove   lambda_max(M⁻¹K) <=
///   sigma.
/// The radius of a ball follows from the law's drift bound. An element that leaves is evaluated exactly; when it
/// exceeds its budget, shapes there are turned with their nodes, which changes no sum, budgets around it are dealt
/// again, then shapes, then sigma is raised, which is free for all others. The proof is for the masses and the free
/// components at that time: when the body's version has changed, the next update or certify starts from scratch.
class LazyBound {
 public:
  /// slack: relative room of sigma above the tight bound at a retarget, which budgets share.
  explicit LazyBound(const Body& body, double slack = 0.06);

  /// sigma, proven at positions x (3×N, m). NaN when x or the tangent is not finite. Unless nullptr, `evaluation` is
  /// filled in at x: elements are tested in the one pass that computes what it asks for. Its visitor is not used.
  UpperBound update(const NodeVectors& x, StepEvaluation* evaluation = nullptr);
  /// Tells the bound what a lower bound is at x, so that it can follow downwards: sigma is lowered, or shapes start
  /// afresh, when it lies more than `width` (relative, in the step) above. Proves nothing: when it returns true, sigma
  /// has changed and holds only after the next update.
  bool steer(const NodeVectors& x, LowerBound lower, double width);
  /// The same upwards: raises sigma and all budgets when it lies so little above a lower bound at x that elements would
  /// soon exceed their budgets everywhere. Nothing need be looked at again.
  void ease(LowerBound lower, double width);

  /// Threshold mode: proves lambda_max <= sigma for a sigma of the caller's at x, or returns false. Where there is much
  /// room below sigma, balls are large and hardly any element is ever looked at again. A proof that is kept for a
  /// smaller sigma serves too.
  bool certify(const NodeVectors& x, double sigma, StepEvaluation* evaluation = nullptr);

  double sigma() const { return sigma_; }
  const NodalBound& shapes() const { return shapes_; }
  /// What the last update or certify spent and saw.
  struct Spent {
    std::int64_t evaluated = 0;  // elements
    int repairs = 0, raises = 0, retargets = 0;
    double leastDeterminant =
        std::numeric_limits<double>::infinity();  // det F of the elements evaluated; no other can be <= 0
    ElementRef leastDeterminantElement;
  };
  const Spent& spent() const { return spent_; }
  /// Elements whose -lambda_min(∂P/∂F) over λ+2μ was above `least` when last evaluated, most first. Only elements under
  /// compression can make the tangent indefinite.
  std::vector<ElementRef> compressedElements(double least) const;
  /// The most compressed element's, since shapes and budgets were made.
  double mostCompression() const { return mostCompression_; }
  /// An element's exact value over its budget, which is about the bound at its hottest node over sigma.
  struct Risen {
    double share;
    ElementRef element;
  };
  /// Of the elements evaluated at the last update those with a share above 0.9, largest first, before any repair: where
  /// the highest eigenvalue may have come to.
  const std::vector<Risen>& risen() const { return risen_; }
  /// The elements that hold most of the bound at the `count` nodes where it is highest, by their values when last
  /// evaluated: where the top mode may live. Empty while nothing is proven.
  std::vector<ElementRef> hottestElements(std::size_t count);
  /// Checks the two statements of the proof at x from nothing but the shapes and budgets; for tests. Returns the
  /// largest excess, relative: <= 0 when both hold.
  double verify(const NodeVectors& x) const;

 private:
  struct BlockData {
    ValidityBalls balls;
    // By place = batch * lanes + lane, rounded to the safe side: budget_e, l_e at the anchor, b_e, and
    // -lambda_min(∂P/∂F) / (λ+2μ) at the anchor, at most.
    std::vector<float> budget, value;
    std::vector<Bfloat16> reach, compression;
  };
  void retarget(const NodeVectors& x, int sweeps);
  /// Ends the proof when masses or free components have changed.
  void followBody();
  struct Evaluated {
    double value;
    TangentDrift drift;
    double fromAnchor;  // of F0
  };
  void note(ElementRef element, const TangentDrift& drift);
  enum class Outcome { fine, flooded, failed, notFinite };
  Outcome follow(const NodeVectors& x, bool mayRaise, StepEvaluation* evaluation);
  std::vector<ElementRef> elementsOutsideBall(const NodeVectors& x, StepEvaluation* evaluation);
  void dealBudgets(const NodeVectors& x);
  /// Values, unless known, and anchors of a pack of elements of a block, one a lane (-1: none).
  void evaluatePack(const NodeVectors& x, std::int32_t block, const std::int32_t* elements, const double* known,
                    bool withReach, Evaluated* results);
  void setBall(std::int32_t block, std::int32_t element, const Evaluated& evaluated);
  void evaluate(const NodeVectors& x, const std::vector<ElementRef>& elements, bool withReach,
                std::vector<Evaluated>& results);
  bool repair(const NodeVectors& x, ElementRef element, bool mayRaise);
  /// Σ budget_e D_e at a node, N/m.
  Eigen::Matrix3d sumOfBudgets(std::int32_t node) const;
  /// The rotation of a node's surroundings since the reference configuration, by the anchors of its elements.
  Eigen::Quaternionf frameOf(std::int32_t node) const;
  std::vector<std::int32_t> turnShapes(const std::vector<std::int32_t>& nodes);
  std::size_t placeOf(ElementRef e) const {
    return static_cast<std::size_t>(body_.blocks()[static_cast<std::size_t>(e.block)]
                                        ->layout()
                                        .batchOfElement[static_cast<std::size_t>(e.element)]);
  }
  double budgetOf(ElementRef e) const {
    return static_cast<double>(blocks_[static_cast<std::size_t>(e.block)].budget[placeOf(e)]);
  }

  const Body& body_;
  double slack_;
  NodalBound shapes_;
  Body::Workspace workspace_;
  std::vector<std::vector<std::vector<std::int32_t>>> outside_;  // elements, [block][patch]
  std::vector<BlockData> blocks_;
  std::vector<Eigen::Quaternionf> frames_;  // by node: its frame when its shapes were made or turned last
  double sigma_ = 0, mostCompression_ = 0;  // that of any element since budgets were dealt
  bool started_ = false;
  std::int64_t bodyVersion_ = 0;  // that the proof is for
  Spent spent_;
  std::vector<Risen> risen_;
  std::vector<ElementRef> anchored_;  // given new balls by this update
  // In updates.
  Backoff retarget_{{.first = 40, .last = 10240, .factor = 4}}, lowering_{{.first = 40, .last = 640, .factor = 2}};
  double tightOverLower_ = 0;  // the tight bound at the last retarget over the lower bound then; 0: not known yet
};

}  // namespace ringwatch

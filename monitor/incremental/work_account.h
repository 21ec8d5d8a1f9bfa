#pragma once
#include <algorithm>
#include <cmath>
#include <span>

#include <ringwatch/body/body.h>

namespace ringwatch {

/// What a monitor may spend along a run: a share of the work of the steps themselves, earned step by step. Work is
/// counted, not timed, so that runs repeat bit by bit, in units of a table that holds within a third for every element:
/// an element of n nodes and q quadrature points takes n q units for its force and (3n)³/8 for an evaluation, which is
/// the highest eigenvalue of a 3n×3n matrix: a tet4 54 forces, a hex8 27, a hex20 50.
class WorkAccount {
 public:
  /// share: of a step's work; infinity for no limit.
  WorkAccount(const Body& body, double share)
      : income_(share * ofForce(body)), evaluation_(ofEvaluation(body)), balance_(evaluation_) {}

  static double ofEvaluation(const ElementBlock& block) {
    const double size = 3.0 * block.nodesPerElement();
    return size * size * size / 8;
  }
  static double ofEvaluation(const Body& body, std::span<const ElementRef> elements) {
    double work = 0;
    for (const ElementRef e : elements) work += ofEvaluation(*body.blocks()[e.block]);
    return work;
  }
  /// The work of evaluating all elements, as the others below.
  static double ofEvaluation(const Body& body) {
    double work = 0;
    for (const auto& block : body.blocks()) work += static_cast<double>(block->elementCount()) * ofEvaluation(*block);
    return work;
  }
  static double ofForce(const Body& body) {
    double work = 0;
    for (const auto& block : body.blocks())
      work += static_cast<double>(block->elementCount()) * block->nodesPerElement() *
              static_cast<double>(block->rule().points.size());
    return work;
  }
  static double ofRaise(const Body& body) { return forcesOfRaise * ofForce(body); }
  static double ofRebuild(const Body& body) { return evaluationsOfRebuild * ofEvaluation(body); }

  /// A step's income. No more is kept than a rebuild and an evaluation cost.
  void earn() { balance_ = std::min(balance_ + income_, (evaluationsOfRebuild + 1) * evaluation_); }
  /// What is owed beyond one evaluation of all elements is forgiven: it would stop all that makes a bound narrower for
  /// the rest of a run.
  void spend(double work) { balance_ = std::max(balance_ - work, -evaluation_); }
  bool affords(double work) const { return balance_ >= work || std::isinf(income_); }

 private:
  // As measured: evaluations in a rebuild (6 to 14), and a raise with the visit of every element that follows, over a
  // force (3 for a tet4, 0.5 for a hex8).
  static constexpr double evaluationsOfRebuild = 12, forcesOfRaise = 3;
  double income_, evaluation_, balance_;
};

}  // namespace ringwatch

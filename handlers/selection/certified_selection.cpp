#include <ringwatch/handlers/selection/certified_selection.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/rounding.h>
#include <ringwatch/monitor/bounds/nodal_bound.h>
#include <ringwatch/monitor/bounds/scaled_tangent.h>

namespace ringwatch {
namespace {

class Greedy {
 public:
  Greedy(const Body& body, const NodeVectors& x, double lambda, const ElementFlags& keep,
         const std::vector<Eigen::Matrix3d>& outside)
      : body_(body),
        x_(x),
        lambda_(lambda),
        keep_(keep.empty() ? noElements(body.mesh()) : keep),
        chosen_(keep_),
        outside_(outside),
        weights_(body) {}

  CertifiedSelection run() {
    // The worst elements bend the weights of their whole neighbourhood, so they leave first, and the weights are swept
    // without them before the next ones are evaluated.
    changed_ = true;
    for (const double high : {16.0, 4.0, 1.0, 1.0}) {
      if (changed_) sweep();
      takeOut(high * lambda_);
      if (high > 1 || kept_) continue;
      keepWeights();
      bringBack();
    }
    CertifiedSelection result;
    result.chosen = std::move(chosen_);
    double highest = 0;
    for (std::int32_t i = 0; i < body_.nodeCount(); ++i) highest = std::max(highest, nodal(i).first);
    result.explicitPart = {highest};
    result.nodalSums = std::move(sums_);
    result.evaluations = evaluations_;
    result.weights.resize(body_.blocks().size());
    for (std::size_t b = 0; b < result.weights.size(); ++b) {
      const ElementBlock& block = *body_.blocks()[b];
      for (std::int32_t e = 0; e < block.elementCount(); ++e)
        for (int a = 0; a < block.element().nodes; ++a)
          result.weights[b].push_back(weights_.factor(weights_.incidenceOf({b, e}, a)));
    }
    return result;
  }

 private:
  /// lambda_max of a node's sum over its mass and the direction that has it.
  std::pair<double, Eigen::Vector3d> nodal(std::int32_t i) const {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(sums_[i] / body_.lumpedMass()[i]);
    return {eigen.eigenvalues()[2], eigen.eigenvectors().col(2)};
  }
  /// The elements that are left, with weights of their own.
  void sweep() {
    const ElementFlags left = complement(chosen_);
    bound_.reset();
    explicitPart_.emplace(body_, left);
    bound_.emplace(*explicitPart_);
    if (!outside_.empty()) bound_->setOutside(outside_);
    numbers_ = elementNumbers(left);
    changed_ = kept_ = false;
    // Where nothing need leave, any weights do.
    double value = bound_->evaluate(x_, 0).value;
    evaluations_ += bound_->evaluations();
    if (!(value <= lambda_ * (1 - selectionRounding)) || !chosenElements(chosen_).empty()) {
      if (!std::isnan(value)) value = bound_->evaluate(x_, sweeps).value;
      evaluations_ += bound_->evaluations();
    }
    if (std::isnan(value))
      throw NumericalError("no elements can be selected: the tangent at these positions is not finite");
    sums_.resize(body_.nodeCount());
    for (std::int32_t i = 0; i < body_.nodeCount(); ++i) sums_[i] = sumAt(i);
  }
  Eigen::Matrix3d sumAt(std::int32_t node) const {
    Eigen::Matrix3d sum = outside_.empty() ? Eigen::Matrix3d::Zero() : outside_[node];
    for (const auto place : bound_->incidences(node)) {
      const ElementRef e = bound_->elementAt(place);
      if (!chosen_[e.block][number(e)]) sum += bound_->value(e) * bound_->weight(place);
    }
    return freePart(body_, node, sum);
  }
  /// Hands over elements until no node of the explicit part is above `allowed`.
  void takeOut(double allowed) {
    std::priority_queue<std::pair<double, std::int32_t>> queue;
    for (std::int32_t i = 0; i < body_.nodeCount(); ++i) queue.push({nodal(i).first, i});
    while (!queue.empty()) {
      const auto [value, i] = queue.top();
      queue.pop();
      const auto [now, direction] = nodal(i);
      if (now < value * (1 - selectionRounding)) {  // a neighbour has left since
        queue.push({now, i});
        continue;
      }
      if (now <= allowed * (1 - selectionRounding)) return;
      double most = -1;
      ElementRef worst;
      for (const auto place : bound_->incidences(i)) {
        const ElementRef e = bound_->elementAt(place);
        if (chosen_[e.block][number(e)]) continue;
        const double share = bound_->value(e) * direction.dot(freePart(body_, i, bound_->weight(place)) * direction);
        if (share > most) {
          most = share;
          worst = e;
        }
      }
      if (most < 0) continue;  // nothing is left here but rounding
      chosen_[worst.block][number(worst)] = true;
      changed_ = true;
      // Summed again: differences would keep the rounding of what has left.
      for (const std::int32_t node : explicitPart_->blocks()[worst.block]->nodesOf(worst.element))
        sums_[node] = sumAt(node);
      queue.push({nodal(i).first, i});
    }
  }
  std::size_t number(ElementRef e) const { return numbers_[e.block][e.element]; }
  void keepWeights() {
    for (std::size_t b = 0; b < numbers_.size(); ++b)
      for (std::size_t i = 0; i < numbers_[b].size(); ++i) {
        const ElementRef part{b, i}, whole{part.block, numbers_[b][i]};
        for (int a = 0; a < body_.blocks()[b]->element().nodes; ++a)
          weights_.setFactor(weights_.incidenceOf(whole, a), bound_->factor(bound_->incidenceOf(part, a)));
      }
    kept_ = true;
  }

  /// Takes back, softest first, every element that the slack of its nodes holds.
  void bringBack() {
    std::vector<std::pair<double, ElementRef>> candidates;
    for (const ElementRef e : chosenElements(chosen_))
      if (!keep_[e.block][e.element]) candidates.push_back({useOfSlack(e).share, e});
    std::sort(candidates.begin(), candidates.end());
    for (const auto& [before, e] : candidates) {
      if (!(before <= 1)) break;  // slack only shrinks
      const Use use = useOfSlack(e);
      if (!(use.share <= 1)) continue;
      const auto nodes = body_.blocks()[e.block]->nodesOf(e.element);
      std::vector<Eigen::Matrix3d> sums;
      for (std::size_t a = 0; a < nodes.size(); ++a) {
        const auto place = weights_.incidenceOf(e, static_cast<int>(a));
        sums.push_back(sums_[nodes[a]] + use.value * freePart(body_, nodes[a], weights_.weight(place)));
        const double largest =
            Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(sums[a], Eigen::EigenvaluesOnly).eigenvalues()[2];
        if (!(largest <= lambda_ * (1 - selectionRounding) * body_.lumpedMass()[nodes[a]])) break;
        if (a + 1 < nodes.size()) continue;
        for (std::size_t k = 0; k <= a; ++k) sums_[nodes[k]] = sums[k];
        chosen_[e.block][e.element] = false;
        changed_ = true;
      }
    }
  }
  struct Use {
    double share;  // of the slack that it would use up; NaN or > 1 where it does not fit
    double value;  // l_e
  };
  /// Gives a chosen element the slack of its nodes as weights.
  Use useOfSlack(ElementRef e) {
    const auto nodes = body_.blocks()[e.block]->nodesOf(e.element);
    double trace = 0;
    std::vector<Eigen::Matrix3d> slack;
    for (const std::int32_t node : nodes) {
      slack.push_back(freePart(
          body_, node,
          lambda_ * (1 - selectionRounding) * body_.lumpedMass()[node] * Eigen::Matrix3d::Identity() - sums_[node]));
      trace += slack.back().trace();
    }
    weights_.setWeights(e, slack);
    std::int32_t elements[lanes];
    std::fill(std::begin(elements), std::end(elements), -1);
    elements[0] = e.element;
    double values[lanes];
    weights_.elementValues(e.block, elements, x_, values);
    ++evaluations_;
    // A node without slack in some direction gives a weight that is not positive definite, thus NaN, or a large value.
    return {std::isnan(values[0]) ? infinity : values[0] / trace, values[0]};
  }

  static constexpr int sweeps = 8;
  const Body& body_;
  const NodeVectors& x_;
  double lambda_;
  ElementFlags keep_, chosen_;
  const std::vector<Eigen::Matrix3d>& outside_;
  std::optional<Body> explicitPart_;
  std::optional<NodalBound> bound_;  // of explicitPart_
  std::vector<std::vector<std::int32_t>> numbers_;
  bool changed_ = false;  // the choice, since the last sweep
  bool kept_ = false;     // the weights of the last sweep, in weights_
  NodalBound weights_;    // of all elements
  std::vector<Eigen::Matrix3d> sums_;
  std::int64_t evaluations_ = 0;
};

}  // namespace

CertifiedSelection selectCertified(const Body& body, const NodeVectors& x, double lambda, const ElementFlags& keep,
                                   const std::vector<Eigen::Matrix3d>& outside) {
  if (!(lambda > 0)) throw InputError(joinText("selection: lambda = ", lambda, " rad2/s2 must be > 0"));
  return Greedy(body, x, lambda, keep, outside).run();
}

}  // namespace ringwatch

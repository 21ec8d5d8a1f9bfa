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
#include <ringwatch/monitor/incremental/certificate_state.h>

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
    for (const auto& [high, sweeps] : rounds) {
      if (changed_) sweep(sweeps);
      takeOut(high * lambda_);
      if (high > 1) continue;
      keepWeights();
      bringBack();
    }
    CertifiedSelection result;
    result.chosen = std::move(chosen_);
    double highest = 0;
    for (std::int32_t i = 0; i < body_.nodeCount(); ++i) highest = std::max(highest, nodal(i));
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
  /// lambda_max of a node's sum over its mass.
  double nodal(std::int32_t i) const { return largestEigenvalue(sums_[i]) / body_.lumpedMass()[i]; }
  /// The direction that has it, for the search.
  Eigen::Vector3d directionAt(std::int32_t i) const {
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
    eigen.computeDirect(sums_[i]);
    return eigen.eigenvectors().col(2);
  }
  /// The elements that are left, with weights of their own.
  void sweep(int sweeps) {
    const ElementFlags left = complement(chosen_);
    bound_.reset();
    explicitPart_.emplace(body_, left);
    bound_.emplace(*explicitPart_);
    if (!outside_.empty()) bound_->setOutside(outside_);
    numbers_ = elementNumbers(left);
    changed_ = kept_ = false;
    // Where nothing need leave, any weights do.
    const SweepTarget enough{chosenElements(chosen_).empty() ? lambda_ * (1 - selectionRounding) : 0};
    const double value = bound_->evaluate(x_, sweeps, NodalBound::Start::rows, 0, enough).value;
    evaluations_ += bound_->evaluations();
    if (std::isnan(value))
      throw NumericalError("no elements can be selected: the tangent at these positions is not finite");
    shareBegin_.assign(1, 0);
    shares_.clear();
    sums_.resize(body_.nodeCount());
    for (std::int32_t i = 0; i < body_.nodeCount(); ++i) {
      for (const auto place : bound_->incidences(i)) {
        const ElementRef e = bound_->elementAt(place);
        shares_.push_back({bound_->value(e) * freePart(body_, i, bound_->weight(place)), {e.block, number(e)}});
      }
      shareBegin_.push_back(shares_.size());
      sums_[i] = sumAt(i);
    }
  }
  Eigen::Matrix3d sumAt(std::int32_t node) const {
    Eigen::Matrix3d sum =
        outside_.empty() ? Eigen::Matrix3d(Eigen::Matrix3d::Zero()) : freePart(body_, node, outside_[node]);
    for (std::size_t k = shareBegin_[node]; k < shareBegin_[node + 1]; ++k)
      if (!isChosen(shares_[k].element)) sum += shares_[k].ofSum;
    return sum;
  }
  /// Hands over elements until no node of the explicit part is above `allowed`.
  void takeOut(double allowed) {
    allowed *= 1 - selectionRounding;
    std::priority_queue<std::pair<double, std::int32_t>> queue;
    const auto enqueue = [&](std::int32_t i) {
      if (const double value = nodal(i); !(value <= allowed)) queue.push({value, i});
    };
    for (std::int32_t i = 0; i < body_.nodeCount(); ++i) enqueue(i);
    std::vector<bool> stale(body_.nodeCount(), false);  // a neighbour has left since its sum was made
    while (!queue.empty()) {
      const std::int32_t i = queue.top().second;
      queue.pop();
      if (stale[i]) {
        // Summed again: differences would keep the rounding of what has left.
        sums_[i] = sumAt(i);
        stale[i] = false;
        enqueue(i);
        continue;
      }
      const Eigen::Vector3d direction = directionAt(i);
      double most = -1;
      ElementRef worst;
      for (std::size_t k = shareBegin_[i]; k < shareBegin_[i + 1]; ++k) {
        if (isChosen(shares_[k].element)) continue;
        const double share = direction.dot(shares_[k].ofSum * direction);
        if (share > most) {
          most = share;
          worst = shares_[k].element;
        }
      }
      if (most < 0) continue;  // nothing is left here but rounding
      chosen_[worst.block][worst.element] = true;
      changed_ = true;
      for (const std::int32_t node : body_.blocks()[worst.block]->nodesOf(worst.element)) stale[node] = true;
      sums_[i] = sumAt(i);
      stale[i] = false;
      enqueue(i);
    }
    for (std::int32_t i = 0; i < body_.nodeCount(); ++i)
      if (stale[i]) sums_[i] = sumAt(i);
  }
  bool isChosen(ElementRef e) const { return chosen_[e.block][e.element]; }
  /// In the body, of an element of explicitPart_.
  std::int32_t number(ElementRef e) const { return numbers_[e.block][e.element]; }
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
    std::vector<ElementRef> candidates;
    for (const ElementRef e : chosenElements(chosen_))
      if (!keep_[e.block][e.element]) candidates.push_back(e);
    const std::vector<Use> uses = useOfSlack(candidates);
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t k = 0; k < candidates.size(); ++k)
      if (uses[k].share <= 1) order.push_back({uses[k].share, k});  // slack only shrinks
    std::sort(order.begin(), order.end());
    std::vector<bool> usedUp(body_.nodeCount(), false);  // some of a node's slack, since
    for (const auto& [before, k] : order) {
      const ElementRef e = candidates[k];
      const auto nodes = body_.blocks()[e.block]->nodesOf(e.element);
      const bool again = std::any_of(nodes.begin(), nodes.end(), [&](std::int32_t node) { return usedUp[node]; });
      const Use use = again ? useOfSlack(std::vector{e}).front() : uses[k];
      if (!(use.share <= 1)) continue;
      std::vector<Eigen::Matrix3d> sums;
      for (std::size_t a = 0; a < nodes.size(); ++a) {
        const auto place = weights_.incidenceOf(e, static_cast<int>(a));
        sums.push_back(sums_[nodes[a]] + use.value * freePart(body_, nodes[a], weights_.weight(place)));
        if (!(largestEigenvalue(sums[a]) <= lambda_ * (1 - selectionRounding) * body_.lumpedMass()[nodes[a]])) break;
        if (a + 1 < nodes.size()) continue;
        for (std::size_t c = 0; c <= a; ++c) {
          sums_[nodes[c]] = sums[c];
          usedUp[nodes[c]] = true;
        }
        chosen_[e.block][e.element] = false;
        changed_ = true;
      }
    }
  }
  struct Use {
    double share;  // of the slack that it would use up; NaN or > 1 where it does not fit
    double value;  // l_e
  };
  /// Gives chosen elements, ascending, the slack of their nodes as weights.
  std::vector<Use> useOfSlack(const std::vector<ElementRef>& elements) {
    std::vector<Use> uses;
    std::vector<double> traces;
    for (const ElementRef e : elements) {
      std::vector<Eigen::Matrix3d> slack;
      double trace = 0;
      for (const std::int32_t node : body_.blocks()[e.block]->nodesOf(e.element)) {
        slack.push_back(freePart(
            body_, node,
            lambda_ * (1 - selectionRounding) * body_.lumpedMass()[node] * Eigen::Matrix3d::Identity() - sums_[node]));
        trace += slack.back().trace();
      }
      weights_.setWeights(e, slack);
      traces.push_back(trace);
    }
    for (std::size_t first = 0; first < elements.size();) {
      std::int32_t pack[lanes];
      std::fill(std::begin(pack), std::end(pack), -1);
      const std::int32_t block = elements[first].block;
      std::size_t count = 0;
      for (; count < lanes && first + count < elements.size() && elements[first + count].block == block; ++count)
        pack[count] = elements[first + count].element;
      double values[lanes];
      weights_.elementValues(block, pack, x_, values);
      // A node without slack in some direction gives a weight that is not positive definite, thus NaN, or a large
      // value.
      for (std::size_t k = 0; k < count; ++k)
        uses.push_back({std::isnan(values[k]) ? infinity : values[k] / traces[first + k], values[k]});
      first += count;
    }
    evaluations_ += static_cast<std::int64_t>(elements.size());
    return uses;
  }

  /// Elements leave until no node is above so many times lambda, with weights that were swept so often.
  struct Round {
    double high;
    int sweeps;
  };
  /// Of rounds of up to eight sweeps these leave the fewest elements handled: the weights bend towards the elements
  /// that are to leave, the more the more they are swept.
  static constexpr Round rounds[]{{8, 0}, {2, 1}, {1, 2}};

  const Body& body_;
  const NodeVectors& x_;
  double lambda_;
  ElementFlags keep_, chosen_;
  const std::vector<Eigen::Matrix3d>& outside_;
  std::optional<Body> explicitPart_;
  std::optional<NodalBound> bound_;  // of explicitPart_
  std::vector<std::vector<std::int32_t>> numbers_;
  /// An element's part of the sum at a node.
  struct Share {
    Eigen::Matrix3d ofSum;  // without constrained components
    ElementRef element;     // of the body
  };
  std::vector<Share> shares_;            // by node
  std::vector<std::size_t> shareBegin_;  // and the end
  bool changed_ = false;                 // the choice, since the last sweep
  bool kept_ = false;                    // the weights of the last sweep, in weights_
  NodalBound weights_;                   // of all elements
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

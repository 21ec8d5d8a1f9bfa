#include <ringwatch/monitor/incremental/local_update.h>

#include <algorithm>
#include <cmath>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/body/nodes_of.h>
#include <ringwatch/monitor/bounds/scaled_tangent.h>

namespace ringwatch {
namespace {

/// (S/σ)^-¼ of a node, for D ← R D R: half the step of a sweep from scratch, since allowances outside the neighbourhood
/// stay. Eigenvalues below the floor count as the floor: nothing is gained from weights that vanish. With this one no
/// direction grows by more than 1e-3^-¼ = 5.6 an update.
Eigen::Matrix3d localSweepFactor(const Eigen::Matrix3d& S) {
  constexpr double floor = 1e-3, power = -0.25;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(S);
  const Eigen::Vector3d powers = solver.eigenvalues().cwiseMax(floor).array().pow(power);
  return solver.eigenvectors() * powers.asDiagonal() * solver.eigenvectors().transpose();
}

class Neighbourhood {
 public:
  Neighbourhood(RunCertificate& state, NodeVectorsView x, const RebuildPolicy& policy)
      : state_(state), body_(state.body()), x_(x), policy_(policy) {}

  const std::vector<ElementRef>& elements() const { return ring_; }

  /// The elements at the free nodes of the seed.
  void choose(const std::vector<ElementRef>& seed) {
    inner_ = freeNodesOf(seed);
    ring_ = state_.weights().elementsAt(inner_);
    nodes_ = freeNodesOf(ring_);
    save();
    meetings_.clear();
    outside_.resize(nodes_.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      outside_[i] = state_.weights().majorantAt(nodes_[i]);
      for (const NodalBound::Incidence at : state_.weights().incidences(nodes_[i])) {
        const ElementRef e = state_.weights().elementAt(at);
        const auto own = std::lower_bound(ring_.begin(), ring_.end(), e);
        if (own != ring_.end() && *own == e)
          meetings_.push_back({i, static_cast<std::size_t>(own - ring_.begin()), at});
        else
          outside_[i] += state_.allowance(e) * state_.weights().weight(at);
      }
      outside_[i] = freePart(body_, nodes_[i], outside_[i] / body_.lumpedMass()[nodes_[i]]);
    }
  }

  void evaluate(bool withStrainNorm) { state_.evaluate(x_, ring_, withStrainNorm, references_); }

  /// Rotates the weights of the inner nodes with the body. Whether that was enough.
  bool rotateWeights() {
    if (state_.rotateWeights(inner_, policy_).empty()) return false;
    evaluate(true);
    return std::all_of(ring_.begin(), ring_.end(),
                       [&](ElementRef e) { return state_.value(e) <= state_.allowance(e); }) &&
           std::none_of(nodes_.begin(), nodes_.end(), [&](std::int32_t node) { return state_.exceeds(node); });
  }

  /// How far the values of all elements could grow together below the certified eigenvalue: the least of the nodes.
  double leastScaling() {
    inside_.assign(nodes_.size(), Eigen::Matrix3d::Zero());
    for (const Meeting& m : meetings_)
      inside_[m.node] += state_.value(ring_[m.element]) * state_.weights().weight(m.at);
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      inside_[i] = freePart(body_, nodes_[i], inside_[i] / body_.lumpedMass()[nodes_[i]]);
    findScalings();
    return scalings_.empty() ? infinity : *std::min_element(scalings_.begin(), scalings_.end());
  }

  /// Raises the certified eigenvalue to what the neighbourhood needs.
  void raise() {
    double need = 0;
    for (std::size_t i = 0; i < nodes_.size(); ++i) need = std::max(need, largestEigenvalue(outside_[i] + inside_[i]));
    state_.setCertifiedEigenvalue(
        std::max(state_.certifiedEigenvalue(), need * (1 + policy_.raisedSlack * policy_.slack)));
    ++state_.statistics().raises;
    findScalings();
  }

  /// Gives every element the least scaling of its nodes.
  void distribute() {
    for (std::size_t k = 0; k < ring_.size(); ++k) {
      double own = infinity;
      for (const std::int32_t node : nodesOf(ring_[k])) {
        const auto at = std::lower_bound(nodes_.begin(), nodes_.end(), node);
        if (at != nodes_.end() && *at == node) own = std::min(own, scalings_[at - nodes_.begin()]);
      }
      // Infinite: l_e = 0, or no component is free. An older allowance was for weights that may have been swept
      // since.
      state_.setAllowance(ring_[k], std::isfinite(own) ? state_.value(ring_[k]) * own * (1 - allowanceRounding) : 0);
      state_.setBall(ring_[k], references_[k]);
    }
  }

  /// New weights at the inner nodes: what they gain there costs nothing outside the neighbourhood.
  void sweep() {
    std::vector<Eigen::Matrix3d> factors;
    for (const std::int32_t node : inner_) {
      const std::size_t at = std::lower_bound(nodes_.begin(), nodes_.end(), node) - nodes_.begin();
      Eigen::Matrix3d S = (outside_[at] + inside_[at]) / state_.certifiedEigenvalue();
      for (int c = 0; c < 3; ++c)
        if (freeFactor(body_, node, c) == 0) S(c, c) = 1;
      factors.push_back(localSweepFactor(S));
      state_.setFrame(node, state_.frameOf(node));
    }
    NodalBound& weights = state_.weights();
    for (const ElementRef e : ring_) {
      std::vector<Eigen::Matrix3d> own;
      for (const std::int32_t node : nodesOf(e)) {
        own.push_back(weights.weight(weights.incidenceOf(e, static_cast<int>(own.size()))));
        const auto at = std::lower_bound(inner_.begin(), inner_.end(), node);
        if (at == inner_.end() || *at != node) continue;
        const Eigen::Matrix3d& R = factors[at - inner_.begin()];
        own.back() = R * own.back() * R;
      }
      weights.setWeights(e, own);
    }
    evaluate(true);
  }

  /// Takes back all that was done to weights and allowances.
  void restore() {
    auto factor = savedWeights_.begin();
    for (std::size_t i = 0; i < saved_.size(); ++i) {
      state_.setAllowance(saved_[i], savedAllowances_[i]);
      for (int a = 0; a < static_cast<int>(nodesOf(saved_[i]).size()); ++a)
        state_.weights().setFactor(state_.weights().incidenceOf(saved_[i], a), *factor++);
    }
    for (std::size_t i = 0; i < savedNodes_.size(); ++i) state_.setFrame(savedNodes_[i], savedFrames_[i]);
    ring_ = saved_;
    evaluate(true);
  }

 private:
  /// An element of the neighbourhood at one of its nodes.
  struct Meeting {
    std::size_t node, element;
    NodalBound::Incidence at;
  };
  std::span<const std::int32_t> nodesOf(ElementRef e) const { return body_.blocks()[e.block]->nodesOf(e.element); }
  std::vector<std::int32_t> freeNodesOf(const std::vector<ElementRef>& elements) const {
    std::vector<std::int32_t> nodes = nodesOfElements(body_, elements);
    if (body_.constraints().any())
      std::erase_if(nodes, [&](std::int32_t node) { return body_.constraints().freeComponents(node) == 0; });
    return nodes;
  }
  /// Every neighbourhood holds the smaller one before it, of which all is saved.
  void save() {
    for (const ElementRef e : ring_) {
      if (std::binary_search(lastRing_.begin(), lastRing_.end(), e)) continue;
      saved_.push_back(e);
      savedAllowances_.push_back(state_.allowance(e));
      for (int a = 0; a < static_cast<int>(nodesOf(e).size()); ++a)
        savedWeights_.push_back(state_.weights().factor(state_.weights().incidenceOf(e, a)));
    }
    for (const std::int32_t node : inner_) {
      if (std::binary_search(lastInner_.begin(), lastInner_.end(), node)) continue;
      savedNodes_.push_back(node);
      savedFrames_.push_back(state_.frame(node));
    }
    lastRing_ = ring_;
    lastInner_ = inner_;
  }
  void findScalings() {
    scalings_.resize(nodes_.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      scalings_[i] = largestScaling(outside_[i], inside_[i], state_.certifiedEigenvalue());
  }

  RunCertificate& state_;
  const Body& body_;
  NodeVectorsView x_;
  const RebuildPolicy& policy_;
  std::vector<ElementRef> ring_;             // all elements at the inner nodes
  std::vector<std::int32_t> inner_, nodes_;  // free nodes of the seed, of the ring
  std::vector<Meeting> meetings_;
  // By node: (majorant + Σ β_e D_e of all others) / m, Σ l_e D_e / m of the ring.
  std::vector<Eigen::Matrix3d> outside_, inside_;
  std::vector<double> scalings_;  // by node
  std::vector<RunCertificate::Reference> references_;
  std::vector<ElementRef> lastRing_;
  std::vector<std::int32_t> lastInner_;
  // As they were before: elements of the ring with their allowances and weights, inner nodes with their frames.
  std::vector<ElementRef> saved_;
  std::vector<double> savedAllowances_;
  std::vector<NodalBound::Factor> savedWeights_;
  std::vector<std::int32_t> savedNodes_;
  std::vector<Eigen::Quaternionf> savedFrames_;
};

}  // namespace

std::vector<ElementRef> localUpdate(RunCertificate& state, NodeVectorsView x, ElementRef element,
                                    const RebuildPolicy& policy, bool mayRaise) {
  ++state.statistics().localUpdates;
  Neighbourhood near(state, x, policy);
  std::vector<ElementRef> seed{element};
  for (int growth = 0; growth <= policy.growths; ++growth) {
    near.choose(seed);
    near.evaluate(false);
    if (growth == 0 && near.rotateWeights()) return near.elements();
    for (int sweep = 0; sweep <= policy.localSweeps; ++sweep) {
      if (sweep > 0) near.sweep();
      const bool lastSweep = sweep == policy.localSweeps, last = lastSweep && growth == policy.growths;
      bool enough = near.leastScaling() > 1 + (lastSweep ? policy.leastRegain : policy.wantedRegain) * policy.slack;
      if (!enough && last && mayRaise) {
        near.raise();
        enough = true;
      }
      if (!enough) continue;
      near.distribute();
      return near.elements();
    }
    seed = near.elements();
  }
  near.restore();
  return {};
}

}  // namespace ringwatch

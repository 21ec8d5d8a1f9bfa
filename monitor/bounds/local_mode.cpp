#include <ringwatch/monitor/bounds/local_mode.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

#include <ringwatch/base/error.h>
#include <ringwatch/base/sort_unique.h>
#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/body/nodes_of.h>
#include <ringwatch/body/sub_body.h>
#include <ringwatch/monitor/bounds/rayleigh.h>

namespace ringwatch {

std::vector<std::int32_t> LocalMode::grow(const NodeVectors& mode) const {
  const auto amplitude = [&](std::int32_t node) { return mode.col(node).norm(); };
  std::vector<std::int32_t> region;
  std::int32_t top = -1;
  for (std::int32_t i = 0; i < mode.cols(); ++i)
    if (!body_.constraints().isTied(i) && amplitude(i) > (top < 0 ? 0 : amplitude(top))) top = i;
  if (top < 0) return region;
  // Larger ones first, weighed by the elements that they share with the region, which keeps it compact where all are
  // alike; of equal ones the node with the lower number. A node is queued again when its weight has grown.
  const double least = leastAmplitude * amplitude(top);
  using Candidate = std::pair<double, std::int32_t>;
  const auto later = [](const Candidate& a, const Candidate& b) {
    return a.first != b.first ? a.first < b.first : a.second > b.second;
  };
  std::priority_queue<Candidate, std::vector<Candidate>, decltype(later)> frontier(later);
  std::vector<std::uint16_t> shared(body_.nodeCount());
  std::vector<bool> taken(body_.nodeCount());
  frontier.push({amplitude(top), top});
  while (!frontier.empty() && region.size() < size_) {
    const std::int32_t node = frontier.top().second;
    frontier.pop();
    if (taken[node]) continue;
    taken[node] = true;
    region.push_back(node);
    for (const NodalBound::Incidence at : incidences_.incidences(node)) {
      const ElementRef e = incidences_.elementAt(at);
      for (const std::int32_t other : body_.blocks()[e.block]->nodesOf(e.element)) {
        if (taken[other] || body_.constraints().freeComponents(other) == 0 || body_.constraints().isTied(other))
          continue;
        frontier.push({++shared[other] * std::max(amplitude(other), least), other});
      }
    }
  }
  std::sort(region.begin(), region.end());
  return region;
}

void LocalMode::requireRegion() const {
  const bool ascends = std::ranges::adjacent_find(region_, std::greater_equal<>()) == region_.end();
  if (!ascends || (!region_.empty() && (region_.front() < 0 || region_.back() >= body_.nodeCount())))
    throw InputError("saved state: a region has nodes that the body has not");
}
void LocalMode::requireVector() const {
  const Eigen::Index nodes = part_ ? part_->nodeCount() : 0;
  if (vector_.cols() != 0 && vector_.cols() != nodes)
    throw InputError("saved state: a mode is of another part of the body");
  if (highest_.block < 0 || highest_.block >= std::ssize(body_.blocks()) || highest_.element < 0 ||
      highest_.element >= body_.blocks()[highest_.block]->elementCount())
    throw InputError("saved state: an element is none of the body");
}

void LocalMode::makePart(const std::vector<std::int32_t>& region) {
  const std::vector<ElementRef> elements = incidences_.elementsAt(region);
  nodes_ = nodesOfElements(body_, elements);
  if (const DiscreteForces* discrete = body_.discreteForces()) {
    const std::vector<std::int32_t> partners = discrete->partners(region);
    nodes_.insert(nodes_.end(), partners.begin(), partners.end());
    sortUnique(nodes_);
  }
  part_ = std::make_unique<Body>(subBody(body_, elements, nodes_, body_.lumpedMass()(nodes_), body_.threads()));
  for (std::int32_t i = 0; i < part_->nodeCount(); ++i)
    if (!std::binary_search(region.begin(), region.end(), nodes_[i])) part_->constraints().fix(i);
  bodyVersion_ = body_.version();
}

void LocalMode::choose(const NodeVectors& mode, std::size_t nodes) {
  size_ = nodes;
  last_ = {0};
  part_.reset();
  nodes_.clear();
  vector_.resize(3, 0);
  region_ = grow(mode);
  // A node without elements, which springs and contact alone hold, has none to be named and no ring.
  if (incidences_.elementsAt(region_).empty()) region_.clear();
  if (region_.empty()) return;
  makePart(region_);
  vector_ = NodeVectors(mode(Eigen::all, nodes_));
  largest_ = 0;
  sinceSearch_ = searchGap;
  isNew_ = true;
}

NodeVectors LocalMode::mode() const {
  NodeVectors whole = NodeVectors::Zero(3, body_.nodeCount());
  if (part_) whole(Eigen::all, nodes_) = vector_;
  return whole;
}

LowerBound LocalMode::evaluate(NodeVectorsView x, bool mayImprove) {
  spentProducts_ = 0;
  if (!part_) return {0};
  if (bodyVersion_ != body_.version()) {
    choose(mode(), size_);
    if (!part_) return {0};
  }
  if (const DiscreteForces* discrete = body_.discreteForces()) discrete->locate(x);
  x_ = NodeVectors(x(Eigen::all, nodes_));  // where memory ends in an assignment, no object is left
  const bool improve = isNew_ || (++sinceImproved_ >= gap_ && mayImprove);
  const int products = isNew_ ? 3 * products_ : improve ? products_ : 1;
  const LowerBound bound = rayleighLowerBound(*part_, x_, vector_, products, &largest_);
  spentProducts_ = products + 1;
  if (improve) sinceImproved_ = 0;
  isNew_ = false;
  measureShare(bound);
  if (++sinceSearch_ >= searchGap) searchHighest(x);
  last_ = bound;
  last_.value = std::max(bound.value, 0.0);
  return last_;
}

// At each evaluation, as contact can come and govern within one: it takes the forces of the region alone.
void LocalMode::measureShare(LowerBound bound) {
  discreteShare_ = 0;
  if (const DiscreteForces* discrete = part_->discreteForces(); discrete && bound.value > 0) {
    const NodeVectors v = vector_ * part_->lumpedMass().cwiseSqrt().cwiseInverse().asDiagonal();
    discreteShare_ = discrete->form(x_, v) / (bound.value * vector_.squaredNorm());
  }
}

void LocalMode::searchHighest(NodeVectorsView x) {
  if (!part_) return;
  sinceSearch_ = 0;
  Eigen::Index top = 0;
  vector_.colwise().squaredNorm().maxCoeff(&top);
  double most = -1;
  for (const NodalBound::Incidence at : incidences_.incidences(nodes_[top])) {
    const ElementRef e = incidences_.elementAt(at);
    const auto nodes = body_.blocks()[e.block]->nodesOf(e.element);
    Eigen::VectorXd v(3 * nodes.size());
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      const auto place = std::lower_bound(nodes_.begin(), nodes_.end(), nodes[a]) - nodes_.begin();
      v.segment<3>(static_cast<Eigen::Index>(3 * a)) = vector_.col(place) / std::sqrt(body_.lumpedMass()[nodes[a]]);
    }
    const double form = v.dot(body_.elementTangent(e, x) * v);
    if (form > most) {
      most = form;
      highest_ = e;
    }
  }
}

}  // namespace ringwatch

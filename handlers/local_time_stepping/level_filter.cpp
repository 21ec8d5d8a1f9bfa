#include <ringwatch/handlers/local_time_stepping/level_filter.h>

#include <algorithm>
#include <numeric>

#include <ringwatch/base/error.h>

namespace ringwatch {

LevelFilter::LevelFilter(const Body& body, std::vector<FineLevel> levels, const ElementFlags& implicit, double w,
                         const NodeVectors& x, const ClusterOptions& options) {
  for (FineLevel& fine : levels) {
    levels_.emplace_back();
    levels_.back().fine = std::move(fine);
  }
  number(body, implicit);
  const Eigen::Index n = nodes_.size();
  mass_.resize(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::int32_t node = nodes_[i];
    mass_[i] = body.lumpedMass()[node];
    for (int c = 0; c < 3; ++c)
      if (body.constraints().isConstrained(node, c)) held_.push_back(3 * i + c);
  }
  inverseMass_ = mass_.cwiseInverse();
  // The last level evaluates the implicit elements too.
  ElementFlags& last = levels_.back().fine.elements;
  std::vector<ElementRef> deep;
  for (const ElementRef e : chosenElements(implicit)) {
    last[e.block][e.element] = true;
    deep.push_back(e);
  }
  for (Level& level : levels_) level.body.emplace(partOf(body, level.fine.elements, level.count));
  if (deep.empty()) return;
  const Body& own = *levels_.back().body;
  const auto numbers = elementNumbers(last);
  for (ElementRef& e : deep) {
    const auto& of = numbers[e.block];
    e.element = static_cast<std::int32_t>(std::lower_bound(of.begin(), of.end(), e.element) - of.begin());
  }
  NodeVectors start(3, own.nodeCount());
  for (std::int32_t i = 0; i < own.nodeCount(); ++i) start.col(i) = x.col(nodes_[i]);
  for (auto& elements : clustersOf(own, deep)) clusters_.emplace_back(own, std::move(elements), w, start, options);
}

void LevelFilter::number(const Body& body, const ElementFlags& implicit) {
  std::vector<std::size_t> depth(body.nodeCount(), 0);
  const auto deepen = [&](const ElementFlags& flags, std::size_t level) {
    for (const ElementRef e : chosenElements(flags))
      for (const std::int32_t node : body.blocks()[e.block]->nodesOf(e.element))
        depth[node] = std::max(depth[node], level);
  };
  for (std::size_t k = 0; k < levels_.size(); ++k) deepen(levels_[k].fine.elements, k + 1);
  deepen(implicit, levels_.size());
  for (std::int32_t i = 0; i < body.nodeCount(); ++i)
    if (depth[i] > 0) nodes_.push_back(i);
  std::stable_sort(nodes_.begin(), nodes_.end(), [&](std::int32_t a, std::int32_t b) { return depth[a] > depth[b]; });
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const std::size_t node = nodes_[i];
    for (std::size_t k = 0; k < depth[node]; ++k) ++levels_[k].count;
  }
}

Body LevelFilter::partOf(const Body& body, const ElementFlags& elements, Eigen::Index count) const {
  Body part = bodyOf(body, elements, std::span(nodes_).first(static_cast<std::size_t>(count)), mass_.head(count));
  for (const Eigen::Index d : held_)
    if (d < 3 * count) part.constraints().fix(d / 3, static_cast<int>(d % 3));
  return part;
}

void LevelFilter::evaluate(std::size_t level, const NodeVectors& x, bool first) {
  for (std::size_t k = levels_.size(); k-- > level;) {
    Level& own = levels_[k];
    NodeVectors& sum = k == level && !first ? own.now : own.base;
    own.body->internalForce(x, own.force, own.workspace);
    sum.noalias() = -(own.force * inverseMass_.head(own.count).asDiagonal());
    for (const Eigen::Index d : held_) {
      if (d >= 3 * own.count) break;
      sum.data()[d] = 0;
    }
    if (k + 1 < levels_.size()) sum.leftCols(levels_[k + 1].count) += levels_[k + 1].base;
  }
}

bool LevelFilter::average(std::size_t level, const NodeVectors& x, const NodeVectors& a, NodeVectors& result) {
  if (level == levels_.size()) {
    for (ImplicitCluster& cluster : clusters_)
      if (!cluster.solve(result, a, 0)) return false;
    return true;
  }
  Level& own = levels_[level];
  const ChebyshevFilter& filter = own.fine.filter;
  const Eigen::Index n = own.count;
  const double w0 = filter.atShift[1] - filter.w1 * filter.coarse, w1 = filter.w1 * filter.weight,
               square = own.fine.step * own.fine.step;
  const bool deeper = level + 1 < levels_.size() || !clusters_.empty();
  own.u = filter.w1 * a.leftCols(n);
  if (deeper) {
    own.answer = a.leftCols(n);
    if (!average(level + 1, x, a, own.answer)) return false;
    own.u = filter.w1 * own.answer;
  }
  own.before.setZero(3, n);
  for (int m = 1; m < filter.steps; ++m) {
    const double share = filter.w1 * filter.atShift[m] / w1;
    own.x = x.leftCols(n) + square * own.u;
    evaluate(level, own.x, false);
    own.residual = share * a.leftCols(n) + (own.now - own.base);
    if (deeper) {
      own.answer = own.residual;
      if (!average(level + 1, own.x, own.residual, own.answer)) return false;
    }
    own.before = (2 * w0) * own.u - own.before + (2 * w1) * (deeper ? own.answer : own.residual);
    own.before.swap(own.u);
  }
  result.leftCols(n) = filter.kappa * own.u;
  return true;
}

std::string LevelFilter::apply(const NodeVectors& x, NodeVectors& a) {
  for (ImplicitCluster& cluster : clusters_)
    if (!cluster.follow(x)) return "the implicit matrix is not positive definite or not finite";
  evaluate(0, x, true);
  sum_ = a + levels_.front().base;
  if (!average(0, x, sum_, a)) return "conjugate gradients did not converge";
  // E_0 is at most 1 in the norm of M, of which rounding of the forces is a small part.
  constexpr double most = 3, rounding = 1e-8;
  double averaged = 0, whole = 0;
  for (Eigen::Index i = 0; i < a.cols(); ++i) {
    averaged += mass_[i] * a.col(i).squaredNorm();
    whole += mass_[i] * (sum_.col(i).squaredNorm() + rounding * rounding * levels_.front().base.col(i).squaredNorm());
  }
  if (!(averaged <= most * most * whole))
    return joinText("the averaged force is ", std::sqrt(averaged / whole),
                    " times the force: fine elements are stiffer than their level allows, or positions not finite");
  return "";
}

}  // namespace ringwatch

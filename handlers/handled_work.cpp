#include <ringwatch/handlers/handled_work.h>

#include <cmath>

#include <ringwatch/base/parallel.h>
#include <ringwatch/body/nodes_of.h>
#include <ringwatch/body/sub_body.h>
#include <ringwatch/integrators/integrator.h>

namespace ringwatch {
namespace {

Eigen::VectorXd massOf(const Body& body, const std::vector<std::int32_t>& nodes) {
  Eigen::VectorXd mass(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) mass[i] = body.lumpedMass()[nodes[i]];
  return mass;
}

}  // namespace

HandledWork::HandledWork(const Body& body, std::span<const ElementRef> elements, double h, int threads)
    : nodes_(nodesOfElements(body, elements)),
      part_(subBody(body, elements, nodes_, massOf(body, nodes_), threads)),
      h_(h) {
  const auto n = static_cast<Eigen::Index>(nodes_.size());
  for (NodeVectors* vectors : {&x_, &others_, &force_}) vectors->setZero(3, n);
}

template <class Visit>
void HandledWork::forEachNode(const Visit& visit) const {
  parallelFor(
      0, nodes_.size(), part_.threads(), [&](Eigen::Index i) { visit(i, nodes_[static_cast<std::size_t>(i)]); },
      nodesOfAThread);
}

void HandledWork::take(NodeVectorsView x, const NodeVectors& a) {
  forEachNode([&](Eigen::Index i, std::int32_t node) {
    x_.col(i) = x.col(node);
    others_.col(i) = a.col(node);
  });
}

void HandledWork::begin(NodeVectorsView x, const NodeVectors& a) {
  take(x, a);
  if (!part_.constraints().moving()) return;
  part_.internalForce(x_, force_, workspace_);
  countSupports();
}

void HandledWork::beginAndAdd(NodeVectorsView x, NodeVectors& a) {
  take(x, a);
  part_.internalForce(x_, force_, workspace_);
  if (part_.constraints().moving()) countSupports();
  part_.constraints().clearConstrained(force_);
  forEachNode([&](Eigen::Index i, std::int32_t node) { a.col(node) -= force_.col(i) / part_.lumpedMass()[i]; });
}

void HandledWork::beginWithAll(NodeVectorsView x, const NodeVectors& a) {
  take(x, a);
  part_.internalForce(x_, force_, workspace_);
  forEachNode([&](Eigen::Index i, std::int32_t) { others_.col(i) += force_.col(i) / part_.lumpedMass()[i]; });
  if (part_.constraints().moving()) countSupports();
}

void HandledWork::countSupports() {
  if (lastX_.cols() > 0)
    for (const std::int64_t i : part_.constraints().components())
      work_ += 0.5 * (lastForce_.data()[i] + force_.data()[i]) * (x_.data()[i] - lastX_.data()[i]);
  lastX_ = x_;
  lastForce_ = force_;
}

void HandledWork::end(const NodeVectors& v, const NodeVectors& a) {
  const auto n = static_cast<Eigen::Index>(nodes_.size());
  const bool first = halfway_.cols() == 0;
  if (marked_) {
    halfwayBefore_.swap(halfway_);
    workBefore_ = work_;
    marked_ = false;
  }
  halfway_.resize(3, n);
  if (first) {
    for (Eigen::Index i = 0; i < n; ++i) halfway_.col(i) = x_.col(i) - 0.5 * h_ * v.col(nodes_[i]);
    firstEnergy_ = energyAt(halfway_);
  }
  part_.constraints().clearConstrained(others_);
  work_ += parallelSum(n, part_.threads(), [&](Eigen::Index begin, Eigen::Index end) {
    double sum = 0;
    for (Eigen::Index i = begin; i < end; ++i) {
      const std::int32_t node = nodes_[i];
      const Eigen::Vector3d old = v.col(node), taken = a.col(node), now = old + h_ * taken;
      sum += part_.lumpedMass()[i] * (others_.col(i) - taken).dot(0.5 * h_ * (old + now));
      halfway_.col(i) = x_.col(i) + 0.5 * h_ * now;
    }
    return sum;
  });
}

void HandledWork::revert() {
  if (marked_) return;
  halfway_.swap(halfwayBefore_);
  work_ = workBefore_;
}

double HandledWork::energyAt(const NodeVectors& x) const {
  Body::Workspace workspace;
  const double energy = part_.energy(x, workspace);
  // Between two states that a law has an energy for can be one that it has none for.
  return std::isfinite(energy) ? energy : part_.energy(x_, workspace);
}

double HandledWork::dissipated() const { return halfway_.cols() == 0 ? 0 : work_ - energyAt(halfway_) + firstEnergy_; }

}  // namespace ringwatch

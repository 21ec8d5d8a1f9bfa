#include <ringwatch/monitor/bounds/lowest_mode.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/random.h>
#include <ringwatch/base/rounding.h>
#include <ringwatch/monitor/bounds/scaled_tangent.h>
#include <ringwatch/monitor/small/lanczos.h>

namespace ringwatch {
namespace {

constexpr double clearlyBelow = 1e-4;  // zero, relative to the norm of S K S: the search can end

}  // namespace

NodeVectors scaleForSigns(const TangentSource& source, NodeVectorsView x, TangentSource::Workspace& workspace) {
  NodeVectors scale;
  source.sumOverPatches(scale, workspace, [&](std::size_t b, std::int32_t p, double* slots) {
    const ElementTangents& block = *source.tangents()[b];
    const PatchLayout& layout = block.layout();
    const int n = block.nodesPerElement(), size = 3 * n;
    AlignedVector<NativePack> K(size * size);
    const Patch& patch = layout.patches[p];
    for (std::int32_t batch = patch.batchBegin; batch < patch.batchEnd; ++batch) {
      block.tangentBatch(batch, x.data(), reinterpret_cast<double*>(K.data()));
      for (int i = 0; i < size; ++i)
        for (int lane = 0; lane < lanes; ++lane) {
          const std::size_t place = static_cast<std::size_t>(batch) * lanes + static_cast<std::size_t>(lane);
          if (layout.elements[place] < 0) continue;
          const auto local = layout.localNodes[(batch * n + i / 3) * lanes + lane];
          slots[4 * static_cast<std::ptrdiff_t>(local)] += std::abs(K[i * size + i][lane]);
        }
    }
  });
  for (std::int32_t i = 0; i < source.nodeCount(); ++i) {
    const double root = scale(0, i) > 0 ? 1 / std::sqrt(scale(0, i)) : 0;
    for (int c = 0; c < 3; ++c) scale(c, i) = root * cutFactor(source, i, c);
  }
  return scale;
}

SoftElement softestElement(const TangentSource& source, NodeVectorsView x, const NodeVectors& u) {
  std::vector<std::vector<double>> forms;
  for (const ElementTangents* block : source.tangents())
    forms.emplace_back(static_cast<std::size_t>(block->elementCount()));
  source.forEachTangentBatch(x, [&](std::size_t b, std::int32_t batch, const NativePack* K) {
    const ElementTangents& block = *source.tangents()[b];
    const int size = 3 * block.nodesPerElement();
    for (int lane = 0; lane < lanes; ++lane) {
      const std::int32_t e = block.layout().elements[batch * lanes + lane];
      if (e < 0) continue;
      const auto nodes = block.nodesOf(e);
      double own[3 * maxElementNodes], form = 0;
      for (int i = 0; i < size; ++i) own[i] = u(i % 3, nodes[i / 3]);
      for (int i = 0; i < size; ++i)
        for (int j = 0; j < size; ++j) form += own[i] * K[i * size + j][lane] * own[j];
      forms[b][e] = form;
    }
  });
  SoftElement softest{infinity, {}};
  for (std::size_t b = 0; b < forms.size(); ++b)
    for (std::size_t e = 0; e < forms[b].size(); ++e)
      if (forms[b][e] < softest.form) softest = {forms[b][e], {b, e}};
  return softest;
}

void LowestModeSearch::takeScale(NodeVectorsView x) {
  if (scale_.cols() > 0 && sourceVersion_ == source_.version() && ++sinceScale_ < scaleGap) return;
  scale_ = scaleForSigns(source_, x, workspace_);
  sinceScale_ = 0;
  sourceVersion_ = source_.version();
}

LowestMode LowestModeSearch::find(NodeVectorsView x, int maxProducts) {
  LowestMode result;
  takeScale(x);
  NodeVectors& start = direction_;
  if (start.cols() != source_.nodeCount() || !start.allFinite()) {
    start.resize(3, source_.nodeCount());
    for (Eigen::Index i = 0; i < start.size(); ++i) start.data()[i] = randomEntry(1, static_cast<std::uint64_t>(i));
  }
  // A component that nothing stiff holds has no part in the search.
  start = start.cwiseProduct(scale_.cwiseSign());
  const double norm = start.norm();
  if (!(norm > 0)) return result;  // nothing is free
  NodeVectors w, u;
  Lanczos<NodeVectors> lanczos;
  const LanczosMatrix& T = lanczos.matrix();  // of S K S
  lanczos.begin(start / norm);
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  while (true) {
    u = lanczos.current().cwiseProduct(scale_);
    source_.tangentProduct(x, u, w, workspace_);
    w = w.cwiseProduct(scale_);
    ++result.products;
    lanczos.advance(w);
    if (!std::isfinite(T.alpha.back() + T.beta.back())) {
      result.value = std::numeric_limits<double>::quiet_NaN();
      forget();
      return result;
    }
    const bool last = result.products == maxProducts || !(T.beta.back() > 1e-12 * T.radius);
    if (last || T.size() % 4 == 0) {
      solver =
          Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(T.dense());  // compute() leaves no object where memory ends
      if (solver.info() != Eigen::Success) return result;
      if (last || solver.eigenvalues()[0] < -clearlyBelow * T.radius) break;
    }
    lanczos.extend(w);
  }
  start = lanczos.combine(solver.eigenvectors().col(0));
  start /= start.norm();
  // The quotient itself: whatever went before, its sign is proven to rounding.
  u = start.cwiseProduct(scale_);
  source_.tangentProduct(x, u, w, workspace_);
  ++result.products;
  const double form =
      w.cwiseProduct(u).sum() + negativeQuotientRounding * T.radius + source_.formRounding(x, u, workspace_);
  result.value = form / (u.cwiseAbs2() * source_.lumpedMass()).sum();
  if (result.value < 0) result.element = softestElement(source_, x, u).element;
  return result;
}

}  // namespace ringwatch

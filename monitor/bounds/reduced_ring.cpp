#include <ringwatch/monitor/bounds/reduced_ring.h>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/error.h>
#include <ringwatch/monitor/bounds/first_element.h>
#include <ringwatch/monitor/bounds/scaled_tangent.h>
#include <ringwatch/monitor/small/extreme_eigenvalues.h>

namespace ringwatch {
const ReducedRing::Result& ReducedRing::evaluate(NodeVectorsView x, bool wantLowest) {
  source_.assembleBlocks(x, matrix_);
  Eigen::VectorXd rounding = source_.tangentRounding(x, workspace_).cwiseQuotient(source_.lumpedMass());
  for (std::int32_t i = 0; i < source_.nodeCount(); ++i)
    if (source_.constraints().freeComponents(i) == 0 || source_.constraints().isTied(i)) rounding[i] = 0;
  result_.largest.resize(source_.tangents().size());
  result_.highest = result_.lowest = 0;
  result_.highestElement = result_.lowestElement = firstElement(source_);
  scale_ = NodeVectors(3, source_.nodeCount());
  for (std::int32_t i = 0; i < source_.nodeCount(); ++i)
    for (int c = 0; c < 3; ++c) scale_(c, i) = cutFactor(source_, i, c) / std::sqrt(source_.lumpedMass()[i]);
  for (std::size_t b = 0; b < source_.tangents().size(); ++b) {
    const ElementTangents& block = *source_.tangents()[b];
    const int n = block.nodesPerElement(), size = 3 * n;
    auto& largest = result_.largest[b];
    largest.resize(block.elementCount());
    std::vector<double> least(wantLowest ? largest.size() : 0), scale(largest.size());
    constexpr std::int32_t chunk = 64;
    const std::int32_t batches = block.layout().batchCount();
    parallelFor(0, (batches + chunk - 1) / chunk, source_.threads(), [&](std::int64_t c) {
      AlignedVector<NativePack> A(size * size), work(4 * size), factor(size);
      const std::int32_t end = std::min(batches, static_cast<std::int32_t>(c + 1) * chunk);
      for (auto batch = static_cast<std::int32_t>(c) * chunk; batch < end; ++batch) {
        const std::int32_t* blocksOf[lanes];
        forEachLane(block, batch, [&](int lane, std::int32_t e) {
          blocksOf[lane] = matrix_.elementBlocks[b].data() + static_cast<std::ptrdiff_t>(e) * n * n;
          const auto nodes = block.nodesOf(e);
          for (int i = 0; i < size; ++i) factor[i].set(lane, scale_(i % 3, nodes[i / 3]));
        });
        for (int i = 0; i < n; ++i)
          for (int j = 0; j <= i; ++j) {
            std::int32_t place[lanes];
            for (int lane = 0; lane < lanes; ++lane) place[lane] = blocksOf[lane][i * n + j];
            NativePack* entry = A.data() + static_cast<std::ptrdiff_t>(3 * i) * size + 3 * j;
            loadBlocks(matrix_.block.data()->data(), place, entry, size);
            // Entry (i,j) becomes K_ij / √(m_i m_j), zero where constrained.
            for (int r = 0; r < 3; ++r)
              for (int k = 0; k < 3; ++k) entry[r * size + k] *= factor[3 * i + r] * factor[3 * j + k];
          }
        // The blocks of the next batch arrive while this one's eigenvalues are computed.
        if (batch + 1 < end)
          forEachLane(block, batch + 1, [&](int, std::int32_t e) {
            const std::int32_t* next = matrix_.elementBlocks[b].data() + static_cast<std::ptrdiff_t>(e) * n * n;
            for (int i = 0; i < n; ++i)
              for (int j = 0; j <= i; ++j) __builtin_prefetch(matrix_.block.data() + next[i * n + j]);
          });
        const auto extremes = extremeEigenvalues(A.data(), size, work.data(), wantLowest);
        forEachLane(block, batch, [&](int lane, std::int32_t e) {
          const std::size_t place = e;
          largest[place] = extremes.largest[lane];
          scale[place] = extremes.scale[lane];
          if (wantLowest) least[place] = extremes.least[lane];
        });
      }
    });
    for (std::size_t e = 0; e < largest.size(); ++e) {
      const ElementRef here{b, e};
      double margin = eigenvalueRounding * scale[e];
      for (const std::int32_t node : block.nodesOf(e)) margin += rounding[node];
      const double proven = largest[e] - margin;
      if (proven > result_.highest || std::isnan(proven)) {
        result_.highest = proven;
        result_.highestElement = here;
      }
      // Only a clearly negative value proves that the tangent is indefinite.
      if (wantLowest && least[e] + margin < result_.lowest) {
        result_.lowest = least[e];
        result_.lowestElement = here;
      }
    }
  }
  return result_;
}

NodeVectors ReducedRing::topVector(ElementRef ref) const {
  NodeVectors v = NodeVectors::Zero(3, source_.nodeCount());
  if (source_.elementCount() == 0) return v;
  const ElementTangents& block = *source_.tangents()[ref.block];
  const int n = block.nodesPerElement();
  const std::int32_t* position =
      matrix_.elementBlocks[ref.block].data() + static_cast<std::ptrdiff_t>(ref.element) * n * n;
  Eigen::MatrixXd A(3 * n, 3 * n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) A.block<3, 3>(3 * i, 3 * j) = matrix_.block[position[i * n + j]];
  const auto nodes = block.nodesOf(ref.element);
  Eigen::VectorXd factor(3 * n);
  for (int i = 0; i < n; ++i) factor.segment<3>(3 * i) = scale_.col(nodes[i]);
  A = factor.asDiagonal() * A * factor.asDiagonal();
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(A);
  if (solver.info() != Eigen::Success) return v;
  for (int i = 0; i < n; ++i) v.col(nodes[i]) = solver.eigenvectors().col(3 * n - 1).segment<3>(3 * i);
  return v;
}

}  // namespace ringwatch

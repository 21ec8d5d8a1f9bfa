#include <ringwatch/monitor/bounds/node_submatrix.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/monitor/bounds/scaled_tangent.h>

namespace ringwatch {

void NodeSubmatrix::choose(std::vector<std::int32_t> nodes) {
  nodes_ = std::move(nodes);
  sourceVersion_ = source_.version();
  std::sort(nodes_.begin(), nodes_.end());
  blocks_.assign(source_.tangents().size(), {});
  for (const ElementRef e : incidences_.elementsAt(nodes_)) blocks_[e.block].elements.push_back(e.element);
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    auto& [elements, parts] = blocks_[b];
    for (const std::int32_t e : elements) {
      Part& part = parts.emplace_back();
      const auto own = source_.tangents()[b]->nodesOf(e);
      for (std::size_t a = 0; a < own.size(); ++a) {
        const auto found = std::lower_bound(nodes_.begin(), nodes_.end(), own[a]);
        if (found == nodes_.end() || *found != own[a]) continue;
        for (int c = 0; c < 3; ++c) {
          if (cutFactor(source_, own[a], c) == 0) continue;
          part.own[part.count] = static_cast<int>(3 * a) + c;
          part.row[part.count] = static_cast<int>(3 * (found - nodes_.begin())) + c;
          part.inverseMass[a] = 1 / source_.lumpedMass()[own[a]];
          part.scale[part.count++] = std::sqrt(part.inverseMass[a]);
        }
      }
    }
  }
}

const Eigen::MatrixXd& NodeSubmatrix::evaluate(NodeVectorsView x) {
  if (sourceVersion_ != source_.version()) choose(std::move(nodes_));
  const Eigen::Index dofs = 3 * nodes_.size();
  matrix_.setZero(dofs, dofs);
  rounding_ = 0;
  NativePack K[9 * maxElementNodes * maxElementNodes], T[maxElementNodes];
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const ElementTangents& block = *source_.tangents()[b];
    const auto& [listed, parts] = blocks_[b];
    const int n = block.nodesPerElement(), size = 3 * n;
    for (std::size_t first = 0; first < listed.size(); first += lanes) {
      std::int32_t elements[lanes];
      for (std::size_t lane = 0; lane < lanes; ++lane)
        elements[lane] = first + lane < listed.size() ? listed[first + lane] : -1;
      block.tangentOf(elements, x.data(), reinterpret_cast<double*>(K), reinterpret_cast<double*>(T));
      for (int lane = 0; lane < lanes && elements[lane] >= 0; ++lane) {
        const Part& part = parts[first + static_cast<std::size_t>(lane)];
        for (int a = 0; a < n; ++a)
          if (part.inverseMass[a] > 0) rounding_ += T[a][lane] * part.inverseMass[a];
        for (int i = 0; i < part.count; ++i) {
          const NativePack* k = K + part.own[i] * size;
          double* column = matrix_.data() + part.row[i] * dofs;  // K is symmetric: its rows are columns
          for (int j = 0; j < part.count; ++j)
            column[part.row[j]] += k[part.own[j]][lane] * (part.scale[i] * part.scale[j]);
        }
      }
    }
  }
  if (const DiscreteForces* discrete = source_.discreteForces()) addDiscrete(*discrete, x);
  return matrix_;
}

void NodeSubmatrix::addDiscrete(const DiscreteForces& discrete, NodeVectorsView x) {
  const auto placeOf = [&](std::int32_t node) -> Eigen::Index {
    const auto found = std::lower_bound(nodes_.begin(), nodes_.end(), node);
    return found != nodes_.end() && *found == node ? found - nodes_.begin() : -1;
  };
  discrete.forEachBlock(
      x,
      [&](std::int32_t i, std::int32_t j, const Eigen::Matrix3d& block) {
        const Eigen::Index row = placeOf(i), column = placeOf(j);
        if (row < 0 || column < 0) return;
        const double scale = 1 / std::sqrt(source_.lumpedMass()[i] * source_.lumpedMass()[j]);
        for (int r = 0; r < 3; ++r)
          for (int c = 0; c < 3; ++c)
            matrix_(3 * row + r, 3 * column + c) +=
                cutFactor(source_, i, r) * cutFactor(source_, j, c) * scale * block(r, c);
      },
      [&](std::int32_t node) { return placeOf(node) >= 0; });
}

}  // namespace ringwatch

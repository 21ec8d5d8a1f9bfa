#include <ringwatch/monitor/node_submatrix.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <ringwatch/monitor/scaled_tangent.h>

namespace ringwatch {

void NodeSubmatrix::choose(std::vector<std::int32_t> nodes) {
  nodes_ = std::move(nodes);
  std::sort(nodes_.begin(), nodes_.end());
  elements_.assign(body_.blocks().size(), {});
  for (const std::int32_t node : nodes_)
    for (const NodalBound::Incidence& at : incidences_.incidences(node))
      elements_[static_cast<std::size_t>(at.block)].push_back(incidences_.elementAt(at).element);
  for (auto& list : elements_) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
}

const Eigen::MatrixXd& NodeSubmatrix::evaluate(const NodeVectors& x) {
  constexpr int lanes = PatchLayout::lanes;
  const auto dofs = static_cast<Eigen::Index>(3 * nodes_.size());
  matrix_.setZero(dofs, dofs);
  parts_.clear();
  entries_.clear();
  AlignedVector<NativePack> K;
  for (std::size_t b = 0; b < elements_.size(); ++b) {
    const ElementBlock& block = *body_.blocks()[b];
    const int n = block.element().nodes, size = 3 * n;
    K.resize(static_cast<std::size_t>(size * size));
    for (std::size_t first = 0; first < elements_[b].size(); first += lanes) {
      std::int32_t elements[lanes];
      for (std::size_t lane = 0; lane < lanes; ++lane)
        elements[lane] = first + lane < elements_[b].size() ? elements_[b][first + lane] : -1;
      block.tangentOf(elements, x.data(), reinterpret_cast<double*>(K.data()));
      for (int lane = 0; lane < lanes && elements[lane] >= 0; ++lane) {
        const auto nodes = block.nodesOf(elements[lane]);
        Part part{{static_cast<std::int32_t>(b), elements[lane]}, 0, {}, entries_.size()};
        int local[maxElementNodes];
        for (int a = 0; a < n; ++a) {
          const auto found = std::lower_bound(nodes_.begin(), nodes_.end(), nodes[static_cast<std::size_t>(a)]);
          if (found == nodes_.end() || *found != nodes[static_cast<std::size_t>(a)]) continue;
          local[part.count] = a;
          part.at[part.count++] = found - nodes_.begin();
        }
        const auto scale = [&](int a, int c) {
          const std::int32_t node = nodes[static_cast<std::size_t>(local[a])];
          return freeFactor(body_, node, c) / std::sqrt(body_.lumpedMass()[node]);
        };
        for (int a = 0; a < part.count; ++a)
          for (int i = 0; i < 3; ++i)
            for (int c = 0; c < part.count; ++c)
              for (int j = 0; j < 3; ++j) {
                const double k = K[static_cast<std::size_t>((3 * local[a] + i) * size + 3 * local[c] + j)][lane] *
                                 scale(a, i) * scale(c, j);
                entries_.push_back(k);
                matrix_(3 * part.at[a] + i, 3 * part.at[c] + j) += k;
              }
        parts_.push_back(part);
      }
    }
  }
  return matrix_;
}

ElementRef NodeSubmatrix::mostOf(const Eigen::VectorXd& v) const {
  ElementRef most;
  double largest = -1;
  for (const Part& part : parts_) {
    const double* k = entries_.data() + part.first;
    double form = 0;
    for (int a = 0; a < part.count; ++a)
      for (int i = 0; i < 3; ++i)
        for (int c = 0; c < part.count; ++c)
          for (int j = 0; j < 3; ++j) form += v[3 * part.at[a] + i] * *k++ * v[3 * part.at[c] + j];
    if (form > largest) {
      largest = form;
      most = part.element;
    }
  }
  return most;
}

}  // namespace ringwatch

#include <ringwatch/extensions/tetrahedra/coloured_tetrahedra.h>

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include <ringwatch/base/eigen_instances.h>

namespace ringwatch {
namespace {

constexpr std::int64_t nodeGrain = 2048;  // fewer are not worth a thread

}  // namespace

ColouredTetrahedra::ColouredTetrahedra(const Body& body, const std::vector<ElementRef>& elements, double h)
    : body_(body), h_(h), square_(h * h) {
  colour(elements);
}

/// Each element gets the first colour that none at its nodes has.
void ColouredTetrahedra::colour(const std::vector<ElementRef>& elements) {
  const auto nodesOf = [&](ElementRef e) { return body_.blocks()[e.block]->nodesOf(e.element); };
  std::vector<std::int32_t> rowOfNode(body_.mesh().nodeCount(), 0);  // at first the count of its elements
  for (const ElementRef e : elements)
    for (const std::int32_t node : nodesOf(e)) largestOverlap_ = std::max(largestOverlap_, ++rowOfNode[node]);
  for (std::size_t i = 0; i < rowOfNode.size(); ++i)
    if (rowOfNode[i] > 0) {
      rowOfNode[i] = static_cast<std::int32_t>(nodes_.size());
      nodes_.push_back(i);
    }
  std::vector<std::vector<bool>> taken(nodes_.size());  // [row][colour]
  std::vector<std::vector<std::size_t>> ofColour;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const auto nodes = nodesOf(elements[i]);
    const auto rowAt = [&](std::size_t a) { return static_cast<std::size_t>(rowOfNode[nodes[a]]); };
    std::size_t c = 0;
    const auto isTaken = [&](std::size_t a) { return c < taken[rowAt(a)].size() && taken[rowAt(a)][c]; };
    while (isTaken(0) || isTaken(1) || isTaken(2) || isTaken(3)) ++c;
    for (std::size_t a = 0; a < 4; ++a) {
      taken[rowAt(a)].resize(std::max(taken[rowAt(a)].size(), c + 1), false);
      taken[rowAt(a)][c] = true;
    }
    ofColour.resize(std::max(ofColour.size(), c + 1));
    ofColour[c].push_back(i);
  }
  place_.resize(elements.size());
  colourBegin_.assign(1, 0);
  std::int32_t batch = 0;
  const std::int32_t missing = nodes_.size();
  for (const std::vector<std::size_t>& own : ofColour) {
    for (std::size_t i = 0; i < own.size(); ++i) place_[own[i]] = batch * lanes + static_cast<std::int32_t>(i);
    batch += static_cast<std::int32_t>((own.size() + lanes - 1) / lanes);
    colourBegin_.push_back(batch);
  }
  row_.resize(static_cast<std::size_t>(batch) * 4 * lanes);
  for (std::size_t i = 0; i < row_.size(); ++i) row_[i] = missing + static_cast<std::int32_t>(i / lanes % 4);
  freeOf_.assign(batch, -1);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const auto nodes = nodesOf(elements[i]);
    const std::size_t at = place_[i] / lanes;
    const int lane = place_[i] % lanes;
    for (std::size_t a = 0; a < 4; ++a) {
      row_[(4 * at + a) * lanes + static_cast<std::size_t>(lane)] = rowOfNode[nodes[a]];
      const int free = body_.constraints().freeComponents(nodes[a]);
      if (free == 0 || free == 3) continue;
      if (freeOf_[at] < 0) {
        freeOf_[at] = static_cast<std::int32_t>(free_.size());
        free_.emplace_back();
        free_.back().fill(P(1.0));
      }
      for (int c = 0; c < 3; ++c)
        if (body_.constraints().isConstrained(nodes[a], c))
          free_[freeOf_[at]][3 * a + static_cast<std::size_t>(c)].set(lane, 0);
    }
  }
  rows_.assign(static_cast<std::size_t>(rowSize) * (nodes_.size() + 4), 0);
  for (std::size_t a = 1; a < 4; ++a) rows_[rowSize * (nodes_.size() + a) + a - 1] = 1;
  for (std::size_t n = 0; n < nodes_.size(); ++n)
    rows_[rowSize * n + 3] = body_.constraints().freeComponents(nodes_[n]) == 0 ? 0 : 1 / body_.lumpedMass()[nodes_[n]];
}

void ColouredTetrahedra::start(const NodeVectors& x, const NodeVectors& v, const NodeVectors& a) {
  const double perStep = 1 / h_;
  parallelFor(
      0, nodes_.size(), body_.threads(),
      [&](std::int64_t n) {
        const std::ptrdiff_t from = 3 * static_cast<std::ptrdiff_t>(nodes_[n]);
        double* row = rows_.data() + rowSize * n;
        for (int c = 0; c < 3; ++c) {
          row[c] = x.data()[from + c];
          row[4 + c] = v.data()[from + c] * perStep + a.data()[from + c];
        }
      },
      nodeGrain);
  apart_.clear();
}

bool ColouredTetrahedra::finish(const NodeVectors& v, NodeVectors& a) const {
  const double perStep = 1 / h_;
  const double* rows = (apart_.empty() ? rows_ : apart_).data();
  const auto count = static_cast<std::int64_t>(nodes_.size()), chunks = (count + nodeGrain - 1) / nodeGrain;
  std::vector<std::uint8_t> finite(chunks, 1);
  parallelFor(0, chunks, body_.threads(), [&](std::int64_t chunk) {
    double all = 0;
    for (std::int64_t n = chunk * nodeGrain; n < std::min(count, (chunk + 1) * nodeGrain); ++n) {
      const std::ptrdiff_t to = 3 * static_cast<std::ptrdiff_t>(nodes_[n]);
      for (int c = 0; c < 3; ++c) {
        double& own = a.data()[to + c];
        own += rows[rowSize * n + 4 + c] - (v.data()[to + c] * perStep + own);
        all += own;
      }
    }
    finite[chunk] = std::isfinite(all);
  });
  return std::all_of(finite.begin(), finite.end(), [](std::uint8_t f) { return f != 0; });
}

PrincipalTetrahedron principalTetrahedron(const NodeVectors& X, std::span<const std::int32_t> nodes,
                                          const Eigen::Vector4d& inverseMass) {
  Eigen::Matrix3d edges;
  for (int a = 0; a < 3; ++a) edges.col(a) = X.col(nodes[static_cast<std::size_t>(a) + 1]) - X.col(nodes[0]);
  Eigen::Matrix<double, 3, 4> gradient;
  gradient.rightCols<3>() = edges.inverse().transpose();
  gradient.col(0) = -gradient.rightCols<3>().rowwise().sum();
  PrincipalTetrahedron shape;
  shape.volume = edges.determinant() / 6;
  const Eigen::Matrix3d inertia = gradient * inverseMass.asDiagonal() * gradient.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(inertia);
  shape.eta = axes.eigenvalues().cwiseMax(0.0);
  shape.axes = axes.eigenvectors();
  if (shape.axes.determinant() < 0) shape.axes.col(0) *= -1;  // or F would count as inverted in these axes
  shape.gradient = shape.axes.transpose() * gradient;
  return shape;
}

}  // namespace ringwatch

#include <ringwatch/monitor/rayleigh.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Eigenvalues>

#include <ringwatch/monitor/mass_scaled_operator.h>
#include <ringwatch/monitor/scaled_tangent.h>

namespace ringwatch {

LowerBound rayleighLowerBound(const Body& body, const NodeVectors& x, NodeVectors& start, int products) {
  body.constraints().clearConstrained(start);
  const double norm = start.norm();
  if (!(norm > 0)) return {0};
  MassScaledOperator op(body, x);
  start /= norm;
  const int steps = std::max(1, products - 1);
  std::vector<NodeVectors> basis{start};
  Eigen::VectorXd diagonal(steps), subdiagonal(steps);
  NodeVectors w(3, start.cols());
  int size = 0;
  for (; size < steps; ++size) {
    const auto k = static_cast<std::size_t>(size);
    op.perform_op(basis[k].data(), w.data());
    diagonal[size] = w.cwiseProduct(basis[k]).sum();
    // Full orthogonalisation: a handful of vectors, and the Ritz vector stays what it claims to be.
    for (const NodeVectors& q : basis) w -= w.cwiseProduct(q).sum() * q;
    subdiagonal[size] = w.norm();
    if (!(subdiagonal[size] > 1e-12 * std::abs(diagonal[0])) || size + 1 == steps) {
      ++size;
      break;
    }
    basis.push_back(w / subdiagonal[size]);
  }
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  Eigen::MatrixXd T = Eigen::MatrixXd::Zero(size, size);
  for (int i = 0; i < size; ++i) {
    T(i, i) = diagonal[i];
    if (i + 1 < size) T(i, i + 1) = T(i + 1, i) = subdiagonal[i];
  }
  solver.compute(T);
  if (solver.info() == Eigen::Success) {
    start.setZero();
    for (int i = 0; i < size; ++i) start += solver.eigenvectors()(i, size - 1) * basis[static_cast<std::size_t>(i)];
  }
  // The quotient itself, from one more product: whatever went before, this is a proven lower bound to rounding.
  start /= start.norm();
  op.perform_op(start.data(), w.data());
  const double quotient = w.cwiseProduct(start).sum();
  return {quotient - 1e-12 * w.norm()};
}

void HotSpot::choose(const NodeVectors& mode) {
  constexpr std::ptrdiff_t most = 24;
  const Eigen::VectorXd size = mode.colwise().squaredNorm().transpose();
  std::vector<std::int32_t> order;
  for (std::int32_t i = 0; i < body_.nodeCount(); ++i)
    if (size[i] > 0) order.push_back(i);
  const auto count = std::min<std::ptrdiff_t>(most, static_cast<std::ptrdiff_t>(order.size()));
  std::partial_sort(order.begin(), order.begin() + count, order.end(),
                    [&](std::int32_t a, std::int32_t b) { return size[a] != size[b] ? size[a] > size[b] : a < b; });
  nodes_.assign(order.begin(), order.begin() + count);
  std::sort(nodes_.begin(), nodes_.end());
  vector_.resize(3 * count);
  elements_.assign(body_.blocks().size(), {});
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const std::int32_t node = nodes_[static_cast<std::size_t>(i)];
    vector_.segment<3>(3 * i) = mode.col(node);
    for (const NodalBound::Incidence& at : incidences_.incidences(node))
      elements_[static_cast<std::size_t>(at.block)].push_back(incidences_.elementAt(at).element);
  }
  for (auto& list : elements_) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
}

LowerBound HotSpot::evaluate(const NodeVectors& x) {
  constexpr int lanes = PatchLayout::lanes;
  if (nodes_.empty()) return {0};
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(vector_.size(), vector_.size());
  AlignedVector<NativePack> K;
  double most = -1;
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
        std::ptrdiff_t at[maxElementNodes];
        double scale[3 * maxElementNodes];
        for (int a = 0; a < n; ++a) {
          const std::int32_t node = nodes[static_cast<std::size_t>(a)];
          const auto found = std::lower_bound(nodes_.begin(), nodes_.end(), node);
          at[a] = found != nodes_.end() && *found == node ? found - nodes_.begin() : -1;
          for (int c = 0; c < 3; ++c)
            scale[3 * a + c] = freeFactor(body_, node, c) / std::sqrt(body_.lumpedMass()[node]);
        }
        double energy = 0;
        for (int a = 0; a < n; ++a)
          for (int c = 0; c < n; ++c) {
            if (at[a] < 0 || at[c] < 0) continue;
            for (int i = 0; i < 3; ++i)
              for (int j = 0; j < 3; ++j) {
                const double k = K[static_cast<std::size_t>((3 * a + i) * size + 3 * c + j)][lane] * scale[3 * a + i] *
                                 scale[3 * c + j];
                A(3 * at[a] + i, 3 * at[c] + j) += k;
                energy += vector_[3 * at[a] + i] * k * vector_[3 * at[c] + j];
              }
          }
        if (energy > most) {
          most = energy;
          hottest_ = {static_cast<std::int32_t>(b), elements[lane]};
        }
      }
    }
  }
  // Power iteration on A shifted by half its norm, so that a large negative eigenvalue cannot win; the quotient is A's
  // own.
  const double shift = 0.5 * A.cwiseAbs().rowwise().sum().maxCoeff();
  double best = 0;
  for (int iteration = 0; iteration < 4; ++iteration) {
    const double norm = vector_.norm();
    if (!(norm > 0)) return {0};
    vector_ /= norm;
    const Eigen::VectorXd product = A * vector_;
    best = std::max(best, product.dot(vector_) - 1e-12 * product.norm());
    vector_ = product + shift * vector_;
  }
  return {best};
}

}  // namespace ringwatch

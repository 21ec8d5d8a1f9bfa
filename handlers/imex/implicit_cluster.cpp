#include <ringwatch/handlers/imex/implicit_cluster.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <variant>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/error.h>
#include <ringwatch/body/nodes_of.h>
#include <ringwatch/handlers/imex/cluster_matrix.h>
#include <ringwatch/handlers/imex/cluster_pcg.h>
#include <ringwatch/handlers/selection/rotation_of.h>

namespace ringwatch {
namespace {

constexpr Eigen::Index denseSize = 72;  // up to here a full inverse is faster than a sparse factor

Eigen::Index component(std::int32_t local, int c) { return 3 * static_cast<Eigen::Index>(local) + c; }

}  // namespace

std::vector<std::vector<ElementRef>> clustersOf(const Body& body, const std::vector<ElementRef>& elements) {
  std::vector<std::size_t> parent(elements.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto find = [&](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  constexpr std::size_t none = -1;
  std::vector<std::size_t> first(static_cast<std::size_t>(body.nodeCount()), none);
  for (std::size_t i = 0; i < elements.size(); ++i)
    for (const std::int32_t node : body.blocks()[elements[i].block]->nodesOf(elements[i].element)) {
      std::size_t& other = first[node];
      if (other == none) {
        other = i;
        continue;
      }
      const std::size_t a = find(i), b = find(other);
      parent[std::max(a, b)] = std::min(a, b);
    }
  std::vector<std::vector<ElementRef>> clusters;
  std::vector<std::size_t> number(elements.size(), none);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    std::size_t& own = number[find(i)];
    if (own == none) {
      own = clusters.size();
      clusters.emplace_back();
    }
    clusters[own].push_back(elements[i]);
  }
  return clusters;
}

/// Conjugate gradients and the solutions of the last two steps.
struct ImplicitCluster::Iterative {
  std::variant<ClusterPcg<float>, ClusterPcg<double>> gradients;
  std::array<Eigen::VectorXd, 2> before;
};

ClusterOptions clusterOptionsOf(const Options& own) {
  ClusterOptions options;
  options.solver = clusterSolverNames.valueOf("solver", own.text("solver"));
  if (!own.automatic("tolerance")) options.tolerance = own.number("tolerance");
  options.iterations = own.integer("iterations");
  return options;
}

ImplicitCluster::ImplicitCluster(ImplicitCluster&&) noexcept = default;
ImplicitCluster::~ImplicitCluster() = default;

ImplicitCluster::ImplicitCluster(const Body& body, std::vector<ElementRef> elements, double w, const NodeVectors& x,
                                 const ClusterOptions& options)
    : w_(w), options_(options), elements_(std::move(elements)) {
  const NodeVectors& X = body.mesh().X;
  nodes_ = nodesOfElements(body, elements_);

  // By ringwatch_bench_handlers, conjugate gradients are faster from some 25 nodes on at a condition of 10, from 60 at
  // 400; a factor costs 0.4 ms at 125 nodes and 40 ms at 1000, but serves any condition.
  constexpr std::size_t mostForCholesky = 100;
  if (options_.solver == ClusterSolver::automatic)
    options_.solver = nodes_.size() <= mostForCholesky ? ClusterSolver::cholesky : ClusterSolver::conjugateGradients;
  const Eigen::Index size = 3 * nodes_.size();
  mass_.resize(size);
  constrained_.resize(size);
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double total = 0;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const double m = body.lumpedMass()[nodes_[i]];
    centre += m * X.col(nodes_[i]);
    total += m;
    for (int c = 0; c < 3; ++c) {
      mass_[component(i, c)] = m;
      const bool held = body.constraints().isConstrained(nodes_[i], c);
      constrained_[3 * i + static_cast<std::size_t>(c)] = held;
      anyConstrained_[c] |= held;
    }
  }
  frameShape_.resize(nodes_.size(), 3);
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    frameShape_.row(i) = (body.lumpedMass()[nodes_[i]] * (X.col(nodes_[i]) - centre / total)).transpose();

  matrix_ = std::make_unique<ClusterMatrix>(body, elements_, nodes_, w_);
  // What is held is held along the world's axes, and a law that is not objective knows no other.
  rotates_ = matrix_->objective() && std::none_of(anyConstrained_.begin(), anyConstrained_.end(), std::identity{});
  if (options_.solver == ClusterSolver::conjugateGradients) {
    const double mean = total / static_cast<double>(nodes_.size());
    constexpr double enoughForSingle = 1e-5;
    if (options_.tolerance >= enoughForSingle)
      iterative_.reset(new Iterative{ClusterPcg<float>(matrix_->blocks(), constrained_, mean), {}});
    else
      iterative_.reset(new Iterative{ClusterPcg<double>(matrix_->blocks(), constrained_, mean), {}});
  }
  frame_ = frameOf(x);
  if (!frame_.allFinite() || !matrix_->make(x, frame_) || !factor())
    throw NumericalError("the matrix of the implicit elements is not finite at these positions");
}

Eigen::Matrix3d ImplicitCluster::frameOf(const NodeVectors& x) const {
  if (!rotates_) return Eigen::Matrix3d::Identity();
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < nodes_.size(); ++i) A += x.col(nodes_[i]) * frameShape_.row(i);
  return rotationOf(A);
}

bool ImplicitCluster::follow(const NodeVectors& x) {
  double sum = 0;  // elements are not all examined in every step
  for (const std::int32_t node : nodes_) sum += x.col(node).sum();
  if (!std::isfinite(sum)) return false;
  const Eigen::Matrix3d before = frame_;
  frame_ = frameOf(x);
  const bool whole = options_.solver == ClusterSolver::cholesky;
  const ClusterMatrix::Change change =
      frame_.allFinite() ? matrix_->follow(x, frame_, whole) : ClusterMatrix::Change::notFinite;
  if (change == ClusterMatrix::Change::none) return true;
  if (change == ClusterMatrix::Change::some && factor()) return true;
  frame_ = before;
  return false;
}

bool ImplicitCluster::factor() {
  ++factorisations_;
  const UpperBlocks& blocks = matrix_->blocks();
  if (options_.solver == ClusterSolver::conjugateGradients) {
    std::visit([&](auto& gradients) { gradients.refresh(blocks, matrix_->changed()); }, iterative_->gradients);
    return true;
  }
  const Eigen::Index size = mass_.size();
  const auto held = [&](Eigen::Index d) { return constrained_[d] != 0; };
  const auto forEachLowerEntry = [&](const auto& visit) {
    for (std::int32_t i = 0; i < blocks.rows(); ++i)
      for (std::int32_t k = blocks.rowBegin[i]; k < blocks.rowBegin[static_cast<std::size_t>(i) + 1]; ++k) {
        const std::int32_t j = blocks.column[k];
        const Eigen::Matrix3d block = blocks.block(k);
        for (int c = 0; c < 3; ++c)
          for (int r = i == j ? c : 0; r < 3; ++r) {
            const Eigen::Index row = component(j, r), column = component(i, c);
            if (held(row) || held(column))
              visit(row, column, row == column ? 1.0 : 0.0);
            else
              visit(row, column, block(c, r));
          }
      }
  };
  if (size <= denseSize) {
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(size, size);
    forEachLowerEntry([&](Eigen::Index row, Eigen::Index column, double value) { A(row, column) = value; });
    const Eigen::LLT<Eigen::MatrixXd> llt(A);
    if (llt.info() != Eigen::Success) return false;
    denseInverse_ = llt.solve(Eigen::MatrixXd::Identity(size, size));
    return denseInverse_.allFinite();
  }
  if (!sparseFactor_) {
    std::vector<Eigen::Triplet<double>> entries;
    forEachLowerEntry([&](Eigen::Index row, Eigen::Index column, double value) {
      entries.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
    });
    sparse_.resize(size, size);
    sparse_.setFromTriplets(entries.begin(), entries.end());
    for (const auto& entry : entries)
      place_.push_back(&sparse_.coeffRef(entry.row(), entry.col()) - sparse_.valuePtr());
    sparseFactor_ = std::make_unique<Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower>>();
    sparseFactor_->analyzePattern(sparse_);
  } else {
    auto place = place_.begin();
    forEachLowerEntry([&](Eigen::Index, Eigen::Index, double value) { sparse_.valuePtr()[*place++] = value; });
  }
  sparseFactor_->factorize(sparse_);
  return sparseFactor_->info() == Eigen::Success;
}

bool ImplicitCluster::solve(NodeVectors& a, const NodeVectors& v, double c) {
  const auto size = mass_.size();
  right_.resize(size);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const Eigen::Index at = component(i, 0), node = nodes_[i];
    for (int k = 0; k < 3; ++k) right_[at + k] = a(k, node) + c * v(k, node);
  }
  const auto rotate = [&](Eigen::VectorXd& u, const Eigen::Matrix3d& by) {
    if (rotates_) u.reshaped(3, size / 3) = (by * u.reshaped(3, size / 3)).eval();
  };
  rotate(right_, frame_.transpose());
  const bool anyConstrained = anyConstrained_[0] || anyConstrained_[1] || anyConstrained_[2];
  bool prescribed = false;
  if (anyConstrained) {
    prescribed_.setZero(size);
    for (std::size_t d = 0; d < constrained_.size(); ++d)
      if (constrained_[d]) {
        const Eigen::Index at = d;
        prescribed_[at] = right_[at];
        prescribed = prescribed || right_[at] != 0;
      }
  }
  right_ = right_.cwiseProduct(mass_);
  if (prescribed) subtractProduct(prescribed_);
  if (anyConstrained)
    for (std::size_t d = 0; d < constrained_.size(); ++d)
      if (constrained_[d]) right_[d] = 0;

  if (options_.solver == ClusterSolver::conjugateGradients) {
    if (!solveByConjugateGradients()) return false;
  } else if (size <= denseSize) {
    u_.noalias() = denseInverse_ * right_;
  } else {
    u_ = sparseFactor_->solve(right_);
  }
  rotate(u_, frame_);
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    for (int k = 0; k < 3; ++k)
      if (const auto d = component(i, k); !constrained_[d]) a(k, nodes_[i]) = u_[d] - c * v(k, nodes_[i]);
  return true;
}

void ImplicitCluster::subtractProduct(const Eigen::VectorXd& p) {
  const UpperBlocks& blocks = matrix_->blocks();
  std::vector<std::uint8_t> counts(nodes_.size());
  for (std::size_t i = 0; i < counts.size(); ++i) counts[i] = !p.segment<3>(3 * static_cast<Eigen::Index>(i)).isZero(0);
  for (std::int32_t i = 0; i < blocks.rows(); ++i)
    for (std::int32_t k = blocks.rowBegin[i]; k < blocks.rowBegin[static_cast<std::size_t>(i) + 1]; ++k) {
      const std::int32_t j = blocks.column[k];
      if (!counts[i] && !counts[j]) continue;
      const auto pi = p.segment<3>(component(i, 0)), pj = p.segment<3>(component(j, 0));
      const Eigen::Matrix3d block = blocks.block(k);
      right_.segment<3>(component(i, 0)) -= block * pj;
      if (i != j) right_.segment<3>(component(j, 0)) -= block.transpose() * pi;
    }
}

bool ImplicitCluster::solveByConjugateGradients() {
  // Without the translation, which K̂ takes no part in: fast bodies and those that fall would else be solved to a
  // tolerance of that.
  const Eigen::Vector3d translation = takeTranslation();
  auto& [gradients, before] = *iterative_;
  if (before[1].size() > 0)
    u_ = 2 * before[0] - before[1];
  else if (before[0].size() > 0)
    u_ = before[0];
  else
    u_.setZero(mass_.size());
  const auto run = [&](auto& solver) {
    const auto result = solver.solve(right_, u_, options_.tolerance, options_.iterations);
    iterations_ += result.iterations;
    return result.converged;
  };
  if (!std::visit(run, gradients)) {
    before = {};  // another start next time
    return false;
  }
  before[1].swap(before[0]);
  before[0] = u_;
  // The sum of M u over the nodes is that of the right-hand side.
  right_ -= u_.cwiseProduct(mass_);
  const Eigen::Vector3d missing = takeTranslation();
  for (Eigen::Index d = 0; d < u_.size(); ++d) u_[d] += translation[d % 3] + missing[d % 3];
  return true;
}

Eigen::Vector3d ImplicitCluster::takeTranslation() {
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
  for (int c = 0; c < 3; ++c) {
    if (anyConstrained_[c]) continue;
    double sum = 0, mass = 0;
    for (Eigen::Index d = c; d < mass_.size(); d += 3) {
      sum += right_[d];
      mass += mass_[d];
    }
    translation[c] = sum / mass;
    for (Eigen::Index d = c; d < mass_.size(); d += 3) right_[d] -= mass_[d] * translation[c];
  }
  return translation;
}

Eigen::MatrixXd ImplicitCluster::matrix() const {
  const UpperBlocks& blocks = matrix_->blocks();
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(mass_.size(), mass_.size());
  for (std::int32_t i = 0; i < blocks.rows(); ++i)
    for (std::int32_t k = blocks.rowBegin[i]; k < blocks.rowBegin[static_cast<std::size_t>(i) + 1]; ++k) {
      const std::int32_t j = blocks.column[k];
      const Eigen::Matrix3d block = frame_ * blocks.block(k) * frame_.transpose();
      A.block<3, 3>(component(j, 0), component(i, 0)) = block.transpose();
      A.block<3, 3>(component(i, 0), component(j, 0)) = block;
    }
  return A;
}

}  // namespace ringwatch

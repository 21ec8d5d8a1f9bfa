#include <ringwatch/handlers/implicit_cluster.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/LU>

#include <ringwatch/base/error.h>
#include <ringwatch/handlers/rotation_of.h>
#include <ringwatch/monitor/power_iteration.h>

namespace ringwatch {
namespace {

// An element's rotation may be off by this much (Frobenius), and its stretch by this factor, before K̂ is made anew: in
// directions that K̂ takes for soft the true stiffness then shows with the square of the first.
constexpr double rotationChange = 0.05, stretchChange = 1.1;
constexpr Eigen::Index denseSize = 72;  // up to here a full inverse is faster than a sparse factor

/// To some per cent: it only scales K̂. NaN for a matrix that is not finite.
double highest(const Eigen::MatrixXd& K) {
  Eigen::VectorXd v(K.rows()), Kv(K.rows());
  return highestByPowerIteration<0>(K.data(), static_cast<int>(K.rows()), v.data(), Kv.data());
}

Eigen::Index component(std::int32_t local, int c) { return 3 * static_cast<Eigen::Index>(local) + c; }

}  // namespace

std::vector<std::vector<ElementRef>> clustersOf(const Body& body, const std::vector<ElementRef>& elements) {
  std::vector<std::size_t> parent(elements.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto find = [&](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  constexpr auto none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> first(static_cast<std::size_t>(body.nodeCount()), none);
  for (std::size_t i = 0; i < elements.size(); ++i)
    for (const std::int32_t node :
         body.blocks()[static_cast<std::size_t>(elements[i].block)]->nodesOf(elements[i].element)) {
      std::size_t& other = first[static_cast<std::size_t>(node)];
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

ImplicitCluster::ImplicitCluster(const Body& body, std::vector<ElementRef> elements, double w, const NodeVectors& x,
                                 const ClusterOptions& options)
    : body_(body), w_(w), options_(options), elements_(std::move(elements)) {
  const NodeVectors& X = body.mesh().X;
  for (const ElementRef e : elements_)
    for (const std::int32_t node : body.blocks()[static_cast<std::size_t>(e.block)]->nodesOf(e.element))
      nodes_.push_back(node);
  std::sort(nodes_.begin(), nodes_.end());
  nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());

  constexpr std::size_t mostForCholesky = 400;
  if (options_.solver == ClusterSolver::automatic)
    options_.solver = nodes_.size() <= mostForCholesky ? ClusterSolver::cholesky : ClusterSolver::conjugateGradients;
  const auto size = static_cast<Eigen::Index>(3 * nodes_.size());
  mass_.resize(size);
  constrained_.resize(static_cast<std::size_t>(size));
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double total = 0;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const double m = body.lumpedMass()[nodes_[i]];
    centre += m * X.col(nodes_[i]);
    total += m;
    for (int c = 0; c < 3; ++c) {
      mass_[component(static_cast<std::int32_t>(i), c)] = m;
      const bool held = body.constraints().isConstrained(nodes_[i], c);
      constrained_[3 * i + static_cast<std::size_t>(c)] = held;
      anyConstrained_ = anyConstrained_ || held;
    }
  }
  frameShape_.resize(static_cast<Eigen::Index>(nodes_.size()), 3);
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    frameShape_.row(static_cast<Eigen::Index>(i)) =
        (body.lumpedMass()[nodes_[i]] * (X.col(nodes_[i]) - centre / total)).transpose();

  for (const ElementRef ref : elements_) {
    const ElementBlock& block = *body.blocks()[static_cast<std::size_t>(ref.block)];
    Element item;
    item.ref = ref;
    const auto nodes = block.nodesOf(ref.element);
    const auto n = static_cast<Eigen::Index>(nodes.size());
    Eigen::MatrixXd shape(n, 3);
    for (Eigen::Index a = 0; a < n; ++a) {
      const std::int32_t node = nodes[static_cast<std::size_t>(a)];
      item.local.push_back(
          static_cast<std::int32_t>(std::lower_bound(nodes_.begin(), nodes_.end(), node) - nodes_.begin()));
      shape.row(a) = X.col(node).transpose();
    }
    shape.rowwise() -= shape.colwise().mean().eval();
    item.restShape = shape * (shape.transpose() * shape).inverse();
    item.rest = body.elementTangent(ref, X);
    item.restHighest = highest(item.rest);
    item.objective = block.material().lawName() != "linear";
    items_.push_back(std::move(item));
  }
  // What is held is held along the world's axes, and a law that is not objective knows no other.
  turns_ = !anyConstrained_ && std::all_of(items_.begin(), items_.end(), [](const Element& e) { return e.objective; });
  makePattern();
  if (!remake(x)) throw NumericalError("the matrix of the implicit elements is not finite at these positions");
}

Eigen::Matrix3d ImplicitCluster::gradientOf(const Element& e, const NodeVectors& x) const {
  Eigen::Matrix3d F = Eigen::Matrix3d::Zero();
  for (std::size_t a = 0; a < e.local.size(); ++a)
    F += x.col(nodes_[static_cast<std::size_t>(e.local[a])]) * e.restShape.row(static_cast<Eigen::Index>(a));
  return F;
}

Eigen::Matrix3d ImplicitCluster::frameOf(const NodeVectors& x) const {
  if (!turns_) return Eigen::Matrix3d::Identity();
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < nodes_.size(); ++i) A += x.col(nodes_[i]) * frameShape_.row(static_cast<Eigen::Index>(i));
  return rotationOf(A);
}

void ImplicitCluster::makePattern() {
  std::vector<std::vector<std::int32_t>> rows(nodes_.size());
  for (const Element& e : items_)
    for (const std::int32_t i : e.local) {
      auto& row = rows[static_cast<std::size_t>(i)];
      row.insert(row.end(), e.local.begin(), e.local.end());
    }
  rowBegin_.assign(1, 0);
  for (auto& row : rows) {
    std::sort(row.begin(), row.end());
    row.erase(std::unique(row.begin(), row.end()), row.end());
    column_.insert(column_.end(), row.begin(), row.end());
    rowBegin_.push_back(static_cast<std::int32_t>(column_.size()));
  }
  block_.resize(column_.size());
  for (const Element& e : items_) {
    auto& positions = position_.emplace_back();
    for (const std::int32_t i : e.local)
      for (const std::int32_t j : e.local)
        positions.push_back(static_cast<std::int32_t>(
            std::lower_bound(column_.begin() + rowBegin_[static_cast<std::size_t>(i)],
                             column_.begin() + rowBegin_[static_cast<std::size_t>(i) + 1], j) -
            column_.begin()));
  }
}

bool ImplicitCluster::follow(const NodeVectors& x) {
  const Eigen::Matrix3d before = frame_;
  frame_ = frameOf(x);
  bool stale = !frame_.allFinite();
  for (Element& e : items_) {
    if (!e.objective) continue;
    const Eigen::Matrix3d F = frame_.transpose() * gradientOf(e, x);
    const double norm = F.squaredNorm();
    if (!(norm <= stretchChange * e.stretch)) {
      stale = true;
      break;
    }
    // A rotation cannot have moved more than F did, relative to what holds it.
    if ((F - e.F).squaredNorm() <= 0.25 * rotationChange * rotationChange * norm) continue;
    if ((rotationOf(F) - e.R).norm() > rotationChange) {
      stale = true;
      break;
    }
    e.F = F;
  }
  if (!stale || remake(x)) return true;
  frame_ = before;
  return false;
}

bool ImplicitCluster::remake(const NodeVectors& x) {
  frame_ = frameOf(x);
  if (!frame_.allFinite()) return false;
  for (Element& e : items_) {
    e.F = frame_.transpose() * gradientOf(e, x);
    e.stretch = e.F.squaredNorm();
    if (!std::isfinite(e.stretch)) return false;
    e.R = e.objective ? rotationOf(e.F) : Eigen::Matrix3d::Identity();
    if (e.objective) {
      const double now = highest(body_.elementTangent(e.ref, x));
      if (!std::isfinite(now)) return false;
      e.stiffening = std::max(1.0, now / e.restHighest);
    }
  }
  std::fill(block_.begin(), block_.end(), Eigen::Matrix3d::Zero());
  for (std::size_t k = 0; k < items_.size(); ++k) {
    const Element& e = items_[k];
    const auto n = static_cast<Eigen::Index>(e.local.size());
    for (Eigen::Index a = 0; a < n; ++a)
      for (Eigen::Index b = 0; b < n; ++b)
        block_[static_cast<std::size_t>(position_[k][static_cast<std::size_t>(a * n + b)])] +=
            w_ * e.stiffening * e.R * e.rest.block<3, 3>(3 * a, 3 * b) * e.R.transpose();
  }
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    for (std::int32_t k = rowBegin_[i]; k < rowBegin_[i + 1]; ++k)
      if (column_[static_cast<std::size_t>(k)] == static_cast<std::int32_t>(i))
        block_[static_cast<std::size_t>(k)] +=
            mass_[component(static_cast<std::int32_t>(i), 0)] * Eigen::Matrix3d::Identity();
  return factor();
}

bool ImplicitCluster::factor() {
  ++factorisations_;
  const auto size = static_cast<Eigen::Index>(mass_.size());
  if (options_.solver == ClusterSolver::conjugateGradients) {
    preconditioner_.resize(nodes_.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      for (std::int32_t k = rowBegin_[i]; k < rowBegin_[i + 1]; ++k) {
        if (column_[static_cast<std::size_t>(k)] != static_cast<std::int32_t>(i)) continue;
        Eigen::Matrix3d D = block_[static_cast<std::size_t>(k)];
        for (std::size_t c = 0; c < 3; ++c)
          if (constrained_[3 * i + c]) {
            D.row(static_cast<Eigen::Index>(c)).setZero();
            D.col(static_cast<Eigen::Index>(c)).setZero();
            D(static_cast<Eigen::Index>(c), static_cast<Eigen::Index>(c)) = 1;
          }
        preconditioner_[i] = D.inverse();
      }
    return true;
  }
  const auto held = [&](Eigen::Index d) { return constrained_[static_cast<std::size_t>(d)] != 0; };
  const auto forEachEntry = [&](const auto& visit) {
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      for (std::int32_t k = rowBegin_[i]; k < rowBegin_[i + 1]; ++k)
        for (int r = 0; r < 3; ++r)
          for (int c = 0; c < 3; ++c) {
            const Eigen::Index row = component(static_cast<std::int32_t>(i), r),
                               column = component(column_[static_cast<std::size_t>(k)], c);
            if (held(row) || held(column))
              visit(row, column, row == column ? 1.0 : 0.0);
            else
              visit(row, column, block_[static_cast<std::size_t>(k)](r, c));
          }
  };
  if (size <= denseSize) {
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(size, size);
    forEachEntry([&](Eigen::Index row, Eigen::Index column, double value) { A(row, column) = value; });
    const Eigen::LLT<Eigen::MatrixXd> llt(A);
    if (llt.info() != Eigen::Success) return false;
    denseInverse_ = llt.solve(Eigen::MatrixXd::Identity(size, size));
    return denseInverse_.allFinite();
  }
  if (!sparseFactor_) {
    std::vector<Eigen::Triplet<double>> entries;
    forEachEntry([&](Eigen::Index row, Eigen::Index column, double value) {
      if (row >= column) entries.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
    });
    sparse_.resize(size, size);
    sparse_.setFromTriplets(entries.begin(), entries.end());
    sparseFactor_ = std::make_unique<Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower>>();
    sparseFactor_->analyzePattern(sparse_);
  } else {
    forEachEntry([&](Eigen::Index row, Eigen::Index column, double value) {
      if (row >= column) sparse_.coeffRef(row, column) = value;
    });
  }
  sparseFactor_->factorize(sparse_);
  return sparseFactor_->info() == Eigen::Success;
}

void ImplicitCluster::multiply(const Eigen::VectorXd& p, Eigen::VectorXd& Ap) const {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::int32_t k = rowBegin_[i]; k < rowBegin_[i + 1]; ++k)
      sum += block_[static_cast<std::size_t>(k)] * p.segment<3>(component(column_[static_cast<std::size_t>(k)], 0));
    Ap.segment<3>(component(static_cast<std::int32_t>(i), 0)) = sum;
  }
}

void ImplicitCluster::clearConstrained(Eigen::VectorXd& u) const {
  for (std::size_t d = 0; d < constrained_.size(); ++d)
    if (constrained_[d]) u[static_cast<Eigen::Index>(d)] = 0;
}

bool ImplicitCluster::solve(NodeVectors& a, const NodeVectors& v, double c) {
  const auto size = mass_.size();
  right_.resize(size);
  bool prescribed = false;
  const Eigen::Matrix3d toFrame = frame_.transpose();
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const Eigen::Index at = component(static_cast<std::int32_t>(i), 0);
    right_.segment<3>(at) = toFrame * (a.col(nodes_[i]) + c * v.col(nodes_[i]));
  }
  if (anyConstrained_) {
    p_.setZero(size);
    for (std::size_t d = 0; d < constrained_.size(); ++d)
      if (constrained_[d]) {
        const auto at = static_cast<Eigen::Index>(d);
        p_[at] = right_[at];
        prescribed = prescribed || p_[at] != 0;
      }
  }
  right_ = right_.cwiseProduct(mass_);
  if (prescribed) {
    q_.resize(size);
    multiply(p_, q_);
    right_ -= q_;
  }
  if (anyConstrained_) clearConstrained(right_);

  if (options_.solver == ClusterSolver::conjugateGradients) {
    if (!solveByConjugateGradients()) return false;
  } else if (size <= denseSize) {
    u_.noalias() = denseInverse_ * right_;
  } else {
    u_ = sparseFactor_->solve(right_);
  }
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const Eigen::Vector3d u = frame_ * u_.segment<3>(component(static_cast<std::int32_t>(i), 0));
    for (int k = 0; k < 3; ++k)
      if (!constrained_[3 * i + static_cast<std::size_t>(k)]) a(k, nodes_[i]) = u[k] - c * v(k, nodes_[i]);
  }
  return true;
}

bool ImplicitCluster::solveByConjugateGradients() {
  // Preconditioned conjugate gradients with both inner products of an iteration in one place (Chronopoulos & Gear
  // 1989), the source's form: one synchronisation an iteration.
  const auto size = mass_.size();
  const auto precondition = [&](const Eigen::VectorXd& from, Eigen::VectorXd& to) {
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const Eigen::Index at = component(static_cast<std::int32_t>(i), 0);
      to.segment<3>(at) = preconditioner_[i] * from.segment<3>(at);
    }
  };
  z_.resize(size);
  q_.resize(size);
  precondition(right_, z_);
  const double goal = options_.tolerance * options_.tolerance * right_.dot(z_);
  u_.setZero(size);
  r_ = right_;
  p_.setZero(size);
  s_.setZero(size);
  double gammaBefore = 0, alpha = 0;
  for (int iteration = 0;; ++iteration) {
    precondition(r_, z_);
    multiply(z_, q_);
    if (anyConstrained_) clearConstrained(q_);
    const double gamma = r_.dot(z_), delta = q_.dot(z_);
    if (!(gamma > goal)) return gamma <= goal;  // false for NaN
    if (iteration == options_.iterations) return false;
    const double beta = iteration == 0 ? 0 : gamma / gammaBefore;
    alpha = gamma / (iteration == 0 ? delta : delta - beta * gamma / alpha);
    p_ = z_ + beta * p_;
    s_ = q_ + beta * s_;
    u_ += alpha * p_;
    r_ -= alpha * s_;
    gammaBefore = gamma;
    ++iterations_;
  }
}

Eigen::MatrixXd ImplicitCluster::matrix() const {
  const auto size = mass_.size();
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(size, size);
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    for (std::int32_t k = rowBegin_[i]; k < rowBegin_[i + 1]; ++k)
      A.block<3, 3>(component(static_cast<std::int32_t>(i), 0), component(column_[static_cast<std::size_t>(k)], 0)) =
          frame_ * block_[static_cast<std::size_t>(k)] * frame_.transpose();
  return A;
}

}  // namespace ringwatch

#include <ringwatch/monitor/incremental/part_mode.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/random.h>
#include <ringwatch/base/rounding.h>
#include <ringwatch/body/domain.h>
#include <ringwatch/monitor/bounds/lowest_mode.h>

namespace ringwatch {
namespace {

/// Sizes below this share of the largest are left out of a vector, where its quotient stays above keptQuotient of what
/// it was.
constexpr double cutShare = 0.02, keptQuotient = 0.995;

/// result ← Σ factors[i] vectors[i], entry by entry in one order of operations.
void combine(const std::array<double, 3>& factors, const std::array<const NodeVectors*, 3>& vectors,
             NodeVectors& result) {
  result.resize(3, vectors[0]->cols());
  for (Eigen::Index i = 0; i < result.size(); ++i)
    result.data()[i] = std::fma(factors[0], vectors[0]->data()[i],
                                std::fma(factors[1], vectors[1]->data()[i], factors[2] * vectors[2]->data()[i]));
}

}  // namespace

PartMode::PartMode(const Body& body, End end)
    : body_(body),
      domain_(body.domain()),
      owned_(domain_.owned(body.nodeCount())),
      sign_(end == End::highest ? 1 : -1) {
  if (end == End::lowest) return;  // of the tangent, when a search begins
  scale_.resize(3, body.nodeCount());
  for (std::int32_t i = 0; i < body.nodeCount(); ++i)
    for (int c = 0; c < 3; ++c)
      scale_(c, i) = body.constraints().isConstrained(i, c) ? 0 : 1 / std::sqrt(body.lumpedMass()[i]);
}

void PartMode::apply(NodeVectorsView x, const NodeVectors& y, NodeVectors& result) {
  u_ = y.cwiseProduct(scale_);
  domain_.exchange(u_);
  body_.tangentProduct(x, u_, product_, workspace_);
  result = sign_ * product_.cwiseProduct(scale_);
  result.rightCols(result.cols() - owned_).setZero();
}

void PartMode::find(NodeVectorsView x, int products) {
  const Eigen::Index nodes = body_.nodeCount();
  if (sign_ < 0) scale_ = scaleForSigns(body_, x, workspace_);
  if (mode_.cols() != nodes || norm2_ == 0) {
    mode_.resize(3, nodes);
    for (Eigen::Index i = 0; i < nodes; ++i)
      for (int c = 0; c < 3; ++c) {
        const auto dof =
            static_cast<std::uint64_t>(3 * std::int64_t{domain_.nodeInWhole(static_cast<std::int32_t>(i))} + c);
        mode_(c, i) = scale_(c, i) > 0 ? randomEntry(1, dof) : 0;
      }
    mode_.rightCols(nodes - owned_).setZero();
  }
  // The basis y, r, p and its images under A; p is empty in the first turn.
  NodeVectors y = mode_, r, p = NodeVectors::Zero(3, nodes), Ay, Ar, Ap = p, next;
  apply(x, y, Ay);
  bool hasP = false;
  for (int product = 1; product < products; ++product) {
    std::array<ExactSum, 2> first;
    for (Eigen::Index i = 0; i < owned_; ++i) {
      first[0].add(dotAt(y, y, i));
      first[1].add(dotAt(y, Ay, i));
    }
    domain_.sum(first);
    const double norm2 = first[0].value(), quotient = first[1].value() / norm2;
    if (!(norm2 > 0) || !std::isfinite(quotient)) break;
    combine({1, -quotient, 0}, {&Ay, &y, &y}, r);
    apply(x, r, Ar);
    const std::array<const NodeVectors*, 3> basis{&y, &r, &p}, images{&Ay, &Ar, &Ap};
    std::array<ExactSum, 12> sums;
    for (Eigen::Index i = 0; i < owned_; ++i)
      for (std::size_t a = 0, k = 0; a < 3; ++a)
        for (std::size_t b = 0; b <= a; ++b, ++k) {
          sums[k].add(dotAt(*basis[a], *basis[b], i));
          sums[6 + k].add(dotAt(*basis[a], *images[b], i));
        }
    domain_.sum(sums);
    Eigen::Matrix3d G, A;
    for (int a = 0, k = 0; a < 3; ++a)
      for (int b = 0; b <= a; ++b, ++k) {
        G(a, b) = G(b, a) = sums[k].value();
        A(a, b) = A(b, a) = sums[6 + k].value();
      }
    const int size = hasP && G(2, 2) > 0 ? 3 : 2;
    if (!(G(1, 1) > 0) || !G.allFinite() || !A.allFinite()) break;
    // Vectors of norm 1, so that the least eigenvalue of G tells how far they are from dependent.
    const Eigen::Vector3d scale = G.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    const auto solve = [&](int n, Eigen::Vector3d& factors) {
      const Eigen::MatrixXd D = scale.head(n).asDiagonal(), g = D * G.topLeftCorner(n, n) * D,
                            a = D * A.topLeftCorner(n, n) * D;
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> gram(g);
      constexpr double dependent = 1e-8;
      if (gram.info() != Eigen::Success || !(gram.eigenvalues()[0] > dependent)) return false;
      const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> pencil(a, g);
      if (pencil.info() != Eigen::Success) return false;
      factors.setZero();
      factors.head(n) = D * pencil.eigenvectors().col(n - 1);
      return true;
    };
    Eigen::Vector3d factors;
    if (!(size == 3 && solve(3, factors)) && !solve(2, factors)) break;
    combine({0, factors[1], factors[2]}, basis, next);
    p = next;
    combine({factors[0], 1, 0}, {&y, &p, &y}, next);
    y = next;
    combine({0, factors[1], factors[2]}, images, next);
    Ap = next;
    combine({factors[0], 1, 0}, {&Ay, &Ap, &Ay}, next);
    Ay = next;
    hasP = true;
  }
  mode_ = y;
  take(mode_, 0);
  const double whole = bound(x).value;
  take(mode_, cutShare * highestSize(mode_));
  if (!(bound(x).value >= keptQuotient * whole)) take(mode_, 0);
}

double PartMode::highestSize(const NodeVectors& y) {
  double most = 0;
  for (Eigen::Index i = 0; i < owned_; ++i) most = std::max(most, dotAt(y, y, i));
  domain_.largest({&most, 1});
  return std::sqrt(most);
}

void PartMode::take(const NodeVectors& y, double cut) {
  u_ = y.cwiseProduct(scale_);
  ExactSum norm2;
  for (Eigen::Index i = 0; i < owned_; ++i) {
    if (dotAt(y, y, i) < cut * cut) u_.col(i).setZero();
    norm2.add(body_.lumpedMass()[i] * dotAt(u_, u_, i));
  }
  domain_.exchange(u_);
  domain_.sum({&norm2, 1});
  norm2_ = norm2.value();
  if (!std::isfinite(norm2_)) norm2_ = 0;
  findActive();
}

void PartMode::findActive() {
  active_.clear();
  for (const auto& block : body_.blocks()) {
    const PatchLayout& layout = block->layout();
    std::vector<bool>& own = active_.emplace_back();
    for (const Patch& patch : layout.patches)
      own.push_back(std::any_of(layout.nodes.begin() + patch.nodeBegin, layout.nodes.begin() + patch.nodeEnd,
                                [&](std::int32_t node) { return !u_.col(node).isZero(0); }));
  }
}

ElementRef PartMode::softestElement(NodeVectorsView x) {
  const SoftElement own = ringwatch::softestElement(body_, x, u_);
  double most = -std::fmin(own.form, 1e300);  // the reductions take no infinity
  domain_.largest({&most, 1});
  std::string none;
  return domain_.firstFound(own.form == -most ? std::optional(own.element) : std::nullopt, none).value_or(ElementRef());
}

LowerBound PartMode::bound(NodeVectorsView x) {
  if (!(norm2_ > 0)) return {0};
  const auto activePatch = [&](std::size_t b, std::int32_t p) -> const Patch* {
    return active_[b][static_cast<std::size_t>(p)] ? &body_.blocks()[b]->layout().patches[p] : nullptr;
  };
  body_.sumOverPatches(product_, workspace_, [&](std::size_t b, std::int32_t p, double* slots) {
    if (const Patch* patch = activePatch(b, p))
      body_.blocks()[b]->addTangentProduct(*patch, x.data(), u_.data(), slots);
  });
  body_.sumOverPatches(rounding_, workspace_, [&](std::size_t b, std::int32_t p, double* slots) {
    if (const Patch* patch = activePatch(b, p)) body_.blocks()[b]->addTangentRounding(*patch, x.data(), slots);
  });
  std::array<ExactSum, 3> sums;  // uᵀKu, the sizes of its terms, and what K's rounding comes to
  for (Eigen::Index i = 0; i < owned_; ++i) {
    if (u_.col(i).isZero(0)) continue;
    sums[0].add(dotAt(u_, product_, i));
    sums[1].add(std::abs(u_(0, i) * product_(0, i)) + std::abs(u_(1, i) * product_(1, i)) +
                std::abs(u_(2, i) * product_(2, i)));
    sums[2].add(rounding_(0, i) * dotAt(u_, u_, i));
  }
  domain_.sum(sums);
  const double form = sign_ * sums[0].value() - quotientRounding * sums[1].value() -
                      static_cast<double>(body_.mostNodesOfAnElement()) * sums[2].value();
  return {std::max(0.0, form / (norm2_ * (1 + quotientRounding)))};
}

}  // namespace ringwatch

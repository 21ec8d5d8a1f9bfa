#include <ringwatch/handlers/imex/newton_cluster.h>

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include <ringwatch/base/infinity.h>
#include <ringwatch/body/nodes_of.h>
#include <ringwatch/body/sub_body.h>

namespace ringwatch {
namespace {

/// Steps of Newton's method end a search that rounding keeps from its tolerance.
constexpr int mostIterations = 200;
/// Share of the gradient's norm that a linear system is solved to: as much as a step of Newton's method can use while
/// the potential is not quadratic (Dembo, Eisenstat & Steihaug 1982).
constexpr double mostReduction = 0.1;
/// Armijo's condition, and halvings of a step before it counts as none.
constexpr double sufficientDecrease = 1e-4;
constexpr int mostHalvings = 30;
/// Steps of less than that share of their directions creep along a kink. So many of them in a row, or of steps whose
/// gain is within rounding, end the search.
constexpr double leastShare = 1.0 / 64;
constexpr int mostPoorSteps = 3;
/// What rounding makes of a potential, relative to its parts, and of a strain energy, relative to modulus × volume:
/// laws take energies as differences of terms of that size.
constexpr double rounding = 1e-14;
/// The preconditioner is made again when a system takes that many times the products of the first one solved with it.
constexpr double staleness = 1.5;

Eigen::VectorXd massOf(const Body& body, const std::vector<std::int32_t>& nodes) {
  Eigen::VectorXd mass(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) mass[i] = body.lumpedMass()[nodes[i]];
  return mass;
}

double inner(const NodeVectors& a, const NodeVectors& b) { return a.cwiseProduct(b).sum(); }

}  // namespace

NewtonCluster::NewtonCluster(const Body& body, std::vector<ElementRef> elements, ImplicitScheme scheme,
                             double tolerance, int mostProducts)
    : scheme_(scheme),
      tolerance_(tolerance),
      mostProducts_(mostProducts),
      elements_(std::move(elements)),
      nodes_(nodesOfElements(body, elements_)),
      part_(subBody(body, elements_, nodes_, massOf(body, nodes_), 1)) {
  for (std::int32_t i = 0; i < part_.nodeCount(); ++i)
    for (int c = 0; c < 3; ++c) anyConstrained_[c] = anyConstrained_[c] || part_.constraints().isConstrained(i, c);
  const auto n = static_cast<Eigen::Index>(nodes_.size());
  inverses_.resize(nodes_.size());
  for (NodeVectors* vectors :
       {&x_, &others_, &wanted_, &moved_, &target_, &u_, &gradient_, &direction_, &residual_, &z_, &p_, &product_})
    vectors->setZero(3, n);
  evaluation_.wantsEnergy = true;
  for (const auto& block : part_.blocks()) {
    if (block->layout().batchCount() > 0) endsAnywhere_ = endsAnywhere_ && block->material().info().definedInverted;
    double volumes[lanes];
    for (std::int32_t batch = 0; batch < block->layout().batchCount(); ++batch) {
      block->volumeBatch(batch, volumes);
      for (int lane = 0; lane < lanes; ++lane)
        if (block->layout().elements[static_cast<std::size_t>(batch) * lanes + lane] >= 0)
          stiffness_ += block->material().restModulus() * volumes[lane];
    }
  }
}

double NewtonCluster::kinetic(const NodeVectors& u) const {
  double sum = 0;
  for (Eigen::Index i = 0; i < u.cols(); ++i) sum += part_.lumpedMass()[i] * (u.col(i) - target_.col(i)).squaredNorm();
  return 0.5 * sum;
}

bool NewtonCluster::evaluate() {
  moved_ = x_ + w_ * u_;
  part_.evaluate(moved_, evaluation_, workspace_);
  potential_ = kinetic(u_) + evaluation_.strainEnergy / w_;
  gradient_ = evaluation_.internalForce;
  for (Eigen::Index i = 0; i < u_.cols(); ++i) gradient_.col(i) += part_.lumpedMass()[i] * (u_.col(i) - target_.col(i));
  clearConstrained(gradient_);
  return std::isfinite(potential_) && gradient_.allFinite();
}

template <class Visit>
void NewtonCluster::forEachConstrained(const Visit& visit) const {
  if (!anyConstrained_[0] && !anyConstrained_[1] && !anyConstrained_[2]) return;
  for (std::int32_t i = 0; i < part_.nodeCount(); ++i)
    for (int c = 0; c < 3; ++c)
      if (part_.constraints().isConstrained(i, c)) visit(i, c);
}

void NewtonCluster::clearConstrained(NodeVectors& vectors) const {
  forEachConstrained([&](std::int32_t i, int c) { vectors(c, i) = 0; });
}

void NewtonCluster::setMomentum(NodeVectors& vectors, const Eigen::Vector3d& momentum) const {
  const double mass = part_.lumpedMass().sum();
  for (int c = 0; c < 3; ++c)
    if (!anyConstrained_[c]) vectors.row(c).array() += (momentum[c] - vectors.row(c).dot(part_.lumpedMass())) / mass;
}

void NewtonCluster::refreshPreconditioner() {
  part_.assembleBlocks(moved_, blocks_);
  for (std::int32_t i = 0; i < part_.nodeCount(); ++i) {
    const auto begin = blocks_.column.begin() + blocks_.rowBegin[i],
               end = blocks_.column.begin() + blocks_.rowBegin[i + 1];
    const auto own = std::lower_bound(begin, end, i) - blocks_.column.begin();
    const Eigen::Matrix3d inertia = part_.lumpedMass()[i] * Eigen::Matrix3d::Identity();
    Eigen::Matrix3d block = inertia + w_ * blocks_.block[own];
    for (int c = 0; c < 3; ++c)
      if (part_.constraints().isConstrained(i, c)) {
        block.row(c).setZero();
        block.col(c).setZero();
        block(c, c) = 1;
      }
    // An indefinite block preconditions nothing.
    const bool definite = block(0, 0) > 0 && block.topLeftCorner<2, 2>().determinant() > 0 && block.determinant() > 0;
    inverses_[i] = definite ? Eigen::Matrix3d(block.inverse()) : Eigen::Matrix3d(inertia.inverse());
  }
  stale_ = false;
  productsOfFirst_ = 0;
}

void NewtonCluster::precondition(const NodeVectors& r, NodeVectors& z) const {
  for (Eigen::Index i = 0; i < r.cols(); ++i) z.col(i).noalias() = inverses_[i] * r.col(i);
}

void NewtonCluster::findDirection(double reduction) {
  direction_.setZero();
  residual_ = -gradient_;
  precondition(residual_, z_);
  p_ = z_;
  double rho = inner(residual_, z_);
  const double goal = reduction * reduction * rho;
  int products = 0;
  while (rho > goal && products < mostProducts_) {
    part_.tangentProduct(moved_, p_, product_, workspace_);
    product_ *= w_;
    for (Eigen::Index i = 0; i < p_.cols(); ++i) product_.col(i) += part_.lumpedMass()[i] * p_.col(i);
    clearConstrained(product_);
    ++products;
    const double curvature = inner(p_, product_);
    if (!(curvature > 0)) {
      if (direction_.isZero(0)) direction_ = p_;
      break;
    }
    const double alpha = rho / curvature;
    direction_ += alpha * p_;
    residual_ -= alpha * product_;
    precondition(residual_, z_);
    const double next = inner(residual_, z_);
    p_ = z_ + next / rho * p_;
    rho = next;
  }
  // The elements' forces add up to nothing, so that no step of Newton's method moves the centre of mass.
  setMomentum(direction_, Eigen::Vector3d::Zero());
  products_ += products;
  if (productsOfFirst_ == 0) productsOfFirst_ = std::max(products, 1);
  stale_ = stale_ || products > staleness * productsOfFirst_ + 1;
}

NewtonCluster::Progress NewtonCluster::searchAlong() {
  const double slope = inner(gradient_, direction_), before = potential_;
  if (!(slope < 0)) return Progress::none;
  before_ = u_;
  const double noise = rounding * (std::abs(before) + stiffness_ / w_);
  double share = 1;
  for (int k = 0; k < mostHalvings; ++k, share *= 0.5) {
    u_ = before_ + share * direction_;
    if (!evaluate()) continue;
    if (potential_ <= before + sufficientDecrease * share * slope)
      return share < leastShare || before - potential_ <= noise ? Progress::poor : Progress::good;
    // Within rounding of the potential the gradient decides.
    if (potential_ <= before + noise && std::abs(inner(gradient_, direction_)) <= 0.5 * std::abs(slope))
      return Progress::poor;
  }
  u_ = before_;
  evaluate();
  return Progress::none;
}

bool NewtonCluster::begin(const NodeVectors& guess) {
  u_ = guess;
  forEachConstrained([&](std::int32_t i, int k) { u_(k, i) = wanted_(k, i); });
  // Where the centre of mass goes is known.
  setMomentum(u_, wanted_ * part_.lumpedMass());
  return evaluate();
}

NewtonCluster::Outcome NewtonCluster::search(const ImplicitScheme& scheme, const NodeVectors& a, const NodeVectors& v) {
  if (w_ != scheme.w()) {  // solutions and preconditioner are of another equation
    last_ = {};
    stale_ = true;
  }
  w_ = scheme.w();
  c_ = scheme.c();
  const auto n = static_cast<Eigen::Index>(nodes_.size());
  for (Eigen::Index i = 0; i < n; ++i) {
    wanted_.col(i) = a.col(nodes_[i]) + c_ * v.col(nodes_[i]);
    target_.col(i) = others_.col(i) + c_ * v.col(nodes_[i]);
  }
  // What the tolerance is a share of: the gradient at u = 0, where nodes that are moved have moved already.
  const NodeVectors rest = NodeVectors::Zero(3, n);
  bool moves = false;
  forEachConstrained([&](std::int32_t i, int k) { moves = moves || wanted_(k, i) != 0; });
  NodeVectors right(3, n);
  if (moves) {
    if (!begin(rest)) return Outcome::noEnergy;
    right = gradient_;
  } else {
    for (Eigen::Index i = 0; i < n; ++i) right.col(i) = part_.lumpedMass()[i] * wanted_.col(i);
  }
  // A guess must not begin above where the elements rest: Theorem 61 hangs on it.
  const double atRest = moves ? infinity : kinetic(rest) + energyAtStep_ / w_;
  const bool extrapolated = last_[1].cols() > 0 && begin(2 * last_[0] - last_[1]) && potential_ <= atRest;
  // Where nodes are moved and there is no guess, the search stands at rest already.
  if (!extrapolated && (!moves || last_[1].cols() > 0) && !begin(rest)) return Outcome::noEnergy;

  if (stale_) refreshPreconditioner();
  precondition(right, z_);
  const double goal = tolerance_ * tolerance_ * inner(right, z_);
  for (int k = 0, poorSteps = 0;; ++k) {
    precondition(gradient_, z_);
    const double norm = inner(gradient_, z_);
    if (!(norm > goal)) break;
    if (k == mostIterations) {
      last_ = {};
      stale_ = true;
      return Outcome::notConverged;
    }
    ++iterations_;
    if (k > 0 && stale_) refreshPreconditioner();
    findDirection(std::min(mostReduction, 0.5 * std::sqrt(goal / norm)));
    const Progress progress = searchAlong();
    poorSteps = progress == Progress::good ? 0 : poorSteps + 1;
    if (progress == Progress::none || poorSteps == mostPoorSteps) {
      // Rounding, or a kink: the corotational law has them where an element inverts, and minima there.
      ++stalls_;
      stale_ = true;
      break;
    }
  }
  last_[1].swap(last_[0]);
  last_[0] = u_;
  return Outcome::solved;
}

bool NewtonCluster::endsWithoutEnergy(const NodeVectors& v) {
  if (endsAnywhere_) return false;
  const double h = scheme_.h;
  for (Eigen::Index i = 0; i < u_.cols(); ++i)
    moved_.col(i) = x_.col(i) + h * ((1 - c_ * h) * v.col(nodes_[i]) + h * u_.col(i));
  forEachConstrained([&](std::int32_t i, int k) { moved_(k, i) = x_(k, i) + h * v(k, nodes_[i]); });
  return !(part_.leastDeterminant(moved_).value > 0);
}

NewtonCluster::Outcome NewtonCluster::solve(NodeVectorsView x, NodeVectors& a, const NodeVectors& v,
                                            NodeVectors& others) {
  const auto n = static_cast<Eigen::Index>(nodes_.size());
  for (Eigen::Index i = 0; i < n; ++i) x_.col(i) = x.col(nodes_[i]);
  // The force at x; it is part of a already.
  part_.evaluate(x_, evaluation_, workspace_);
  energyAtStep_ = evaluation_.strainEnergy;
  for (Eigen::Index i = 0; i < n; ++i) {
    others_.col(i) = a.col(nodes_[i]) + evaluation_.internalForce.col(i) / part_.lumpedMass()[i];
    others.col(nodes_[i]) = others_.col(i);
  }
  if (!others_.allFinite()) return Outcome::noEnergy;
  Outcome outcome = search(scheme_, a, v);
  constexpr double implicitEuler = 1;
  if (scheme_.dissipation != implicitEuler && (outcome != Outcome::solved || endsWithoutEnergy(v))) {
    ++eulerSteps_;
    outcome = search({scheme_.h, implicitEuler}, a, v);
  }
  if (outcome != Outcome::solved) return outcome;
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::int32_t node = nodes_[i];
    for (int k = 0; k < 3; ++k)
      if (!part_.constraints().isConstrained(static_cast<std::int32_t>(i), k)) a(k, node) = u_(k, i) - c_ * v(k, node);
  }
  return Outcome::solved;
}

}  // namespace ringwatch

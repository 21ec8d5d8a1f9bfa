#include <ringwatch/handlers/imex/newton_cluster.h>

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include <ringwatch/base/infinity.h>
#include <ringwatch/base/parallel.h>
#include <ringwatch/body/domain.h>
#include <ringwatch/body/nodes_of.h>
#include <ringwatch/body/sub_body.h>
#include <ringwatch/handlers/angular_momentum.h>
#include <ringwatch/handlers/selection/rotation_of.h>
#include <ringwatch/meshes/all_finite.h>

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
/// A step by the kept tangent is to leave no more of the gradient's norm, or it is not kept any longer.
constexpr double mostLeft = 0.5;
/// So many steps beyond the first of each search, in all, are worth a new tangent.
constexpr int mostFurtherSteps = 8;
/// Single precision solves to no less, as a share of the right-hand side.
constexpr double leastReduction = 1e-4;
/// A search ends without another look at its gradient where what the kept tangent has left over of gradients says that
/// it is there: the largest share of late, of which this much counts at the next look. One search looks after so many
/// that did not.
constexpr double remembered = 0.3;
constexpr int mostUnseen = 9;

/// Nodes of a cluster that all threads solve together, at least.
constexpr std::size_t nodesOfALargeCluster = 2048;
/// Nodes that are worth another thread in a loop that does little with each.
constexpr std::int64_t nodesOfAPart = 4096;

constexpr double implicitEuler = 1;  // the dissipation that makes it that

Eigen::VectorXd massOf(const Body& body, const std::vector<std::int32_t>& nodes) {
  Eigen::VectorXd mass(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) mass[i] = body.lumpedMass()[nodes[i]];
  return mass;
}

int threadsFor(const Body& body, const std::vector<std::int32_t>& nodes) {
  return nodes.size() < nodesOfALargeCluster ? 1 : body.threads();
}

}  // namespace

NewtonCluster::NewtonCluster(const Body& body, std::vector<ElementRef> elements, ImplicitScheme scheme,
                             double tolerance, int mostProducts)
    : scheme_(scheme),
      tolerance_(tolerance),
      mostProducts_(mostProducts),
      elements_(std::move(elements)),
      nodes_(nodesOfElements(body, elements_)),
      part_(subBody(body, elements_, nodes_, massOf(body, nodes_), threadsFor(body, nodes_))) {
  for (std::int32_t i = 0; i < part_.nodeCount(); ++i)
    for (int c = 0; c < 3; ++c) anyConstrained_[c] = anyConstrained_[c] || part_.constraints().isConstrained(i, c);
  const auto n = static_cast<Eigen::Index>(nodes_.size());
  inverses_.resize(nodes_.size());
  turns_ = isFreeOfTorque(body, elements_, nodes_);
  for (NodeVectors* vectors :
       {&x_, &others_, &shape_, &moved_, &target_, &u_, &gradient_, &direction_, &residual_, &z_, &p_, &product_})
    vectors->setZero(3, n);
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

template <class Visit>
void NewtonCluster::forEachNode(const Visit& visit) const {
  parallelFor(0, x_.cols(), threads(), visit, nodesOfAPart);
}

double NewtonCluster::inner(const NodeVectors& a, const NodeVectors& b) const {
  return parallelSum(a.cols(), threads(), [&](Eigen::Index begin, Eigen::Index end) {
    return a.middleCols(begin, end - begin).cwiseProduct(b.middleCols(begin, end - begin)).sum();
  });
}

double NewtonCluster::kinetic(const NodeVectors& u) const {
  return 0.5 * parallelSum(u.cols(), threads(), [&](Eigen::Index begin, Eigen::Index end) {
           double sum = 0;
           for (Eigen::Index i = begin; i < end; ++i)
             sum += part_.lumpedMass()[i] * (u.col(i) - target_.col(i)).squaredNorm();
           return sum;
         });
}

bool NewtonCluster::evaluate(bool wantsPotential) {
  // Where a law has no energy its force may be finite.
  hasPotential_ = evaluation_.wantsEnergy = wantsPotential || !endsAnywhere_;
  forEachNode([&](Eigen::Index i) { moved_.col(i) = x_.col(i) + w_ * u_.col(i); });
  part_.evaluate(moved_, evaluation_, workspace_);
  if (hasPotential_) potential_ = kinetic(u_) + evaluation_.strainEnergy / w_;
  forEachNode([&](Eigen::Index i) {
    gradient_.col(i) = evaluation_.internalForce.col(i) + part_.lumpedMass()[i] * (u_.col(i) - target_.col(i));
  });
  clearConstrained(gradient_);
  return (!hasPotential_ || std::isfinite(potential_)) && allFinite(gradient_, threads());
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

Eigen::Vector3d NewtonCluster::weightedByMass(const NodeVectors& v) const {
  return parallelSum(v.cols(), threads(), Eigen::Vector3d(0, 0, 0), [&](Eigen::Index begin, Eigen::Index end) {
    return Eigen::Vector3d(v.middleCols(begin, end - begin) * part_.lumpedMass().segment(begin, end - begin));
  });
}

void NewtonCluster::setMomentum(NodeVectors& vectors, const Eigen::Vector3d& momentum) const {
  if (anyConstrained_[0] && anyConstrained_[1] && anyConstrained_[2]) return;
  const Eigen::Vector3d lacking = momentum - weightedByMass(vectors);
  Eigen::Vector3d all = lacking / part_.lumpedMass().sum();
  for (int c = 0; c < 3; ++c)
    if (anyConstrained_[c]) all[c] = 0;
  forEachNode([&](Eigen::Index i) { vectors.col(i) += all; });
}

void NewtonCluster::refreshTangent() {
  part_.assembleBlocks(moved_, blocks_);
  if (!kept_) layOutKept();
  forEachNode([&](Eigen::Index node) {
    const auto i = static_cast<std::int32_t>(node);
    std::size_t k = matrix_.rowBegin[static_cast<std::size_t>(i)];
    const Eigen::Matrix3d inertia = part_.lumpedMass()[i] * Eigen::Matrix3d::Identity();
    // The diagonal is the first of the row.
    Eigen::Matrix3d block = inertia + w_ * blocks_.block[placeOfKept_[k]];
    for (const std::size_t end = matrix_.rowBegin[static_cast<std::size_t>(i) + 1]; k < end; ++k)
      matrix_.set(k, matrix_.column[k] == i ? block : Eigen::Matrix3d(w_ * blocks_.block[placeOfKept_[k]]));
    for (int c = 0; c < 3; ++c)
      if (part_.constraints().isConstrained(i, c)) {
        block.row(c).setZero();
        block.col(c).setZero();
        block(c, c) = 1;
      }
    // An indefinite block preconditions nothing.
    const bool definite = block(0, 0) > 0 && block.topLeftCorner<2, 2>().determinant() > 0 && block.determinant() > 0;
    inverses_[i] = definite ? Eigen::Matrix3d(block.inverse()) : Eigen::Matrix3d(inertia.inverse());
  });
  std::vector<std::uint8_t> all(nodes_.size(), 1);
  kept_->refresh(matrix_, all);
  shape_ = moved_;
  frame_.setIdentity();
  stale_ = false;
  productsOfFirst_ = furtherSteps_ = 0;
  leftOver_ = 1;
}

void NewtonCluster::layOutKept() {
  matrix_.rowBegin.assign(1, 0);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    for (std::int64_t k = blocks_.rowBegin[i]; k < blocks_.rowBegin[i + 1]; ++k)
      if (blocks_.column[k] >= static_cast<std::int32_t>(i)) {
        matrix_.column.push_back(blocks_.column[k]);
        placeOfKept_.push_back(k);
      }
    matrix_.rowBegin.push_back(static_cast<std::int32_t>(matrix_.column.size()));
  }
  matrix_.eight.resize(8 * matrix_.column.size());
  matrix_.ninth.resize(matrix_.column.size());
  std::vector<std::uint8_t> constrained(3 * nodes_.size(), 0);
  forEachConstrained([&](std::int32_t i, int c) { constrained[3 * i + c] = 1; });
  kept_.emplace(matrix_, std::move(constrained), part_.lumpedMass().mean(), threads());
}

void NewtonCluster::turnTangent() {
  if (!turns_ || !kept_) return;
  const Eigen::VectorXd& mass = part_.lumpedMass();
  const Eigen::Vector3d centre = weightedByMass(shape_) / mass.sum();
  const Eigen::Matrix3d none = Eigen::Matrix3d::Zero();
  frame_ = rotationOf(parallelSum(x_.cols(), threads(), none, [&](Eigen::Index begin, Eigen::Index end) {
    Eigen::Matrix3d sum = none;
    for (Eigen::Index i = begin; i < end; ++i) sum += mass[i] * x_.col(i) * (shape_.col(i) - centre).transpose();
    return sum;
  }));
}

void NewtonCluster::precondition(const NodeVectors& r, NodeVectors& z) const {
  forEachNode([&](Eigen::Index i) {
    if (!turns_) {
      z.col(i).noalias() = inverses_[i] * r.col(i);
      return;
    }
    const Eigen::Vector3d back = inverses_[i] * (frame_.transpose() * r.col(i));
    z.col(i).noalias() = frame_ * back;
  });
}

double NewtonCluster::squaredNorm(const NodeVectors& r) {
  precondition(r, z_);
  return inner(r, z_);
}

void NewtonCluster::turnBack(const NodeVectors& vectors, double factor, Eigen::VectorXd& turned) const {
  turned.resize(vectors.size());
  forEachNode([&](Eigen::Index i) { turned.segment<3>(3 * i) = factor * (frame_.transpose() * vectors.col(i)); });
}

bool NewtonCluster::findKeptDirection(double reduction) {
  turnBack(gradient_, -1, right_);
  solution_.setZero(right_.size());
  const auto [converged, products] = kept_->solve(right_, solution_, reduction, mostProducts_);
  products_ += products;
  if (!converged) return false;
  forEachNode([&](Eigen::Index i) { direction_.col(i).noalias() = frame_ * solution_.segment<3>(3 * i); });
  setMomentum(direction_, Eigen::Vector3d::Zero());
  return allFinite(direction_, threads());
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
    forEachNode([&](Eigen::Index i) { product_.col(i) = w_ * product_.col(i) + part_.lumpedMass()[i] * p_.col(i); });
    clearConstrained(product_);
    ++products;
    const double curvature = inner(p_, product_);
    if (!(curvature > 0)) {
      if (direction_.isZero(0)) direction_ = p_;
      break;
    }
    const double alpha = rho / curvature;
    forEachNode([&](Eigen::Index i) {
      direction_.col(i) += alpha * p_.col(i);
      residual_.col(i) -= alpha * product_.col(i);
    });
    precondition(residual_, z_);
    const double next = inner(residual_, z_);
    forEachNode([&](Eigen::Index i) { p_.col(i) = z_.col(i) + next / rho * p_.col(i); });
    rho = next;
  }
  // The elements' forces add up to nothing, so that no step of Newton's method moves the centre of mass.
  setMomentum(direction_, Eigen::Vector3d::Zero());
  products_ += products;
  if (productsOfFirst_ == 0) productsOfFirst_ = std::max(products, 1);
  stale_ = stale_ || products > staleness * productsOfFirst_ + 1;
}

NewtonCluster::Progress NewtonCluster::searchAlong() {
  const double slope = inner(gradient_, direction_);
  if (!(slope < 0)) return Progress::none;
  if (!hasPotential_) evaluate(true);
  const double before = potential_;
  before_ = u_;
  const double noise = rounding * (std::abs(before) + stiffness_ / w_);
  double share = 1;
  for (int k = 0; k < mostHalvings; ++k, share *= 0.5) {
    u_ = before_ + share * direction_;
    if (!evaluate(true)) continue;
    if (potential_ <= before + sufficientDecrease * share * slope)
      return share < leastShare || before - potential_ <= noise ? Progress::poor : Progress::good;
    // Within rounding of the potential the gradient decides.
    if (potential_ <= before + noise && std::abs(inner(gradient_, direction_)) <= 0.5 * std::abs(slope))
      return Progress::poor;
  }
  u_ = before_;
  evaluate(true);
  return Progress::none;
}

bool NewtonCluster::beginAsBefore(bool wantsPotential) {
  forEachNode([&](Eigen::Index i) { u_.col(i) = 2 * last_[0].col(i) - last_[1].col(i); });
  return begin(wantsPotential);
}

bool NewtonCluster::begin(bool wantsPotential) {
  forEachConstrained([&](std::int32_t i, int k) { u_(k, i) = target_(k, i); });
  // Where the centre of mass goes is known: the elements' forces add up to nothing.
  setMomentum(u_, weightedByMass(target_));
  return evaluate(wantsPotential);
}

bool NewtonCluster::beginSearch(bool endsThere) {
  if (last_[1].cols() > 0 && beginAsBefore(endsThere)) {
    if (unseen_ == 0) {
      // The gradient at u = 0 is minus what the matrix makes of the solution, and all but that of the guess.
      p_ = u_;
      clearConstrained(p_);
      turnBack(p_, 1, solution_);
      kept_->multiply(solution_, right_);
      forEachNode([&](Eigen::Index i) { p_.col(i).noalias() = frame_ * right_.segment<3>(3 * i); });
      scale_ = squaredNorm(p_);
    }
    if (endsThere ? potential_ <= potentialAtRest() : squaredNorm(gradient_) <= scale_) return true;
  }
  unseen_ = 0;
  u_.setZero();
  if (!begin(true)) return false;
  if (stale_) refreshTangent();
  scale_ = squaredNorm(gradient_);
  return true;
}

double NewtonCluster::potentialAtRest() {
  bool moves = false;
  forEachConstrained([&](std::int32_t i, int k) { moves = moves || target_(k, i) != 0; });
  // Where nodes are moved nothing rests.
  return moves ? infinity : kinetic(NodeVectors::Zero(3, u_.cols())) + part_.energy(x_, workspace_) / w_;
}

NewtonCluster::KeptStep NewtonCluster::stepByKept(double norm, double wanted, bool endsThere) {
  const double reduction = std::clamp(0.25 * wanted, leastReduction, mostReduction);
  before_ = u_;
  if (!findKeptDirection(reduction)) return KeptStep::failed;
  u_ += direction_;
  if (!endsThere && unseen_ < mostUnseen && reduction + leftOver_ <= wanted) {
    ++unseen_;
    return KeptStep::atTolerance;
  }
  unseen_ = 0;
  const double potential = potential_;
  if (evaluate(endsThere) && (!endsThere || potential_ <= potential)) {
    const double left = std::sqrt(squaredNorm(gradient_) / norm);
    leftOver_ = std::max(left, remembered * leftOver_);
    if (left <= mostLeft) return KeptStep::descended;
  }
  u_ = before_;
  evaluate(true);
  return KeptStep::failed;
}

NewtonCluster::Outcome NewtonCluster::search(const ImplicitScheme& scheme, const NodeVectors& v) {
  if (w_ != scheme.w()) {  // solutions and tangent are of another equation
    last_ = {};
    stale_ = true;
  }
  w_ = scheme.w();
  c_ = scheme.c();
  forEachNode([&](Eigen::Index i) { target_.col(i) = others_.col(i) + c_ * v.col(nodes_[i]); });
  turnTangent();
  const bool endsThere = scheme.dissipation == implicitEuler;
  if (!beginSearch(endsThere)) return Outcome::noEnergy;
  if (stale_) refreshTangent();
  const double goal = tolerance_ * tolerance_ * scale_;
  bool keptServes = true, fresh = false;
  for (int k = 0, poorSteps = 0;; ++k) {
    const double norm = squaredNorm(gradient_);
    if (!(norm > goal)) break;
    if (k == mostIterations) {
      last_ = {};
      stale_ = true;
      return Outcome::notConverged;
    }
    ++iterations_;
    const double wanted = std::sqrt(goal / norm);
    if (keptServes) {
      if (k > 0) ++furtherSteps_;
      const KeptStep step = stepByKept(norm, wanted, endsThere);
      if (step == KeptStep::atTolerance) break;
      if (step == KeptStep::descended) continue;
      // One that is made here is tried once.
      keptServes = !fresh;
      fresh = true;
      refreshTangent();
      if (keptServes) continue;
    }
    findDirection(std::min(mostReduction, 0.5 * wanted));
    const Progress progress = searchAlong();
    poorSteps = progress == Progress::good ? 0 : poorSteps + 1;
    if (progress == Progress::none || poorSteps == mostPoorSteps) {
      // Rounding, or a kink: the corotational law has them where an element inverts, and minima there.
      ++stalls_;
      stale_ = true;
      break;
    }
    if (stale_) refreshTangent();
  }
  stale_ = stale_ || furtherSteps_ > mostFurtherSteps;
  last_[1].swap(last_[0]);
  last_[0] = u_;
  return Outcome::solved;
}

bool NewtonCluster::endsWithoutEnergy(const NodeVectors& v) {
  if (endsAnywhere_) return false;
  const double h = scheme_.h;
  forEachNode(
      [&](Eigen::Index i) { moved_.col(i) = x_.col(i) + h * ((1 - c_ * h) * v.col(nodes_[i]) + h * u_.col(i)); });
  forEachConstrained([&](std::int32_t i, int k) { moved_(k, i) = x_(k, i) + h * v(k, nodes_[i]); });
  return !(part_.leastDeterminant(moved_).value > 0);
}

NewtonCluster::Outcome NewtonCluster::solve(NodeVectorsView x, NodeVectors& a, const NodeVectors& v) {
  forEachNode([&](Eigen::Index i) {
    x_.col(i) = x.col(nodes_[i]);
    others_.col(i) = a.col(nodes_[i]);
  });
  if (!allFinite(x_, threads()) || !allFinite(others_, threads())) return Outcome::noEnergy;
  Outcome outcome = search(scheme_, v);
  if (scheme_.dissipation != implicitEuler && (outcome != Outcome::solved || endsWithoutEnergy(v))) {
    ++eulerSteps_;
    outcome = search({scheme_.h, implicitEuler}, v);
  }
  if (outcome != Outcome::solved) return outcome;
  forEachNode([&](Eigen::Index i) {
    const std::int32_t node = nodes_[i];
    for (int k = 0; k < 3; ++k)
      if (!part_.constraints().isConstrained(static_cast<std::int32_t>(i), k)) a(k, node) = u_(k, i) - c_ * v(k, node);
  });
  return Outcome::solved;
}

std::string_view NewtonCluster::solveOrTell(NodeVectorsView x, NodeVectors& a, const NodeVectors& v) {
  switch (solve(x, a, v)) {
    case Outcome::solved:
      return {};
    case Outcome::noEnergy:
      return "the implicit elements have no finite energy";
    case Outcome::notConverged:
      break;
  }
  return "Newton's method did not converge";
}

void NewtonCounts::add(const NewtonCluster& cluster) {
  ++clusters;
  largestNodes = std::max(largestNodes, static_cast<std::int64_t>(cluster.nodes().size()));
  iterations += cluster.iterations();
  products += cluster.products();
  stalls += cluster.stalls();
  eulerSteps += cluster.eulerSteps();
}

void NewtonCounts::addOthers(Domain& domain) {
  const std::array<std::int64_t*, 5> numbers{&clusters, &iterations, &products, &stalls, &eulerSteps};
  std::array<ExactSum, numbers.size()> sums;  // whole numbers
  for (std::size_t i = 0; i < numbers.size(); ++i) sums[i].add(static_cast<double>(*numbers[i]));
  domain.sum(sums);
  for (std::size_t i = 0; i < numbers.size(); ++i) *numbers[i] = static_cast<std::int64_t>(sums[i].value());
  auto largest = static_cast<double>(largestNodes);
  domain.largest({&largest, 1});
  largestNodes = static_cast<std::int64_t>(largest);
}

std::vector<HandlerFigure> NewtonCounts::figures() const {
  return {{"clusters", static_cast<double>(clusters)},
          {"largest_cluster_nodes", static_cast<double>(largestNodes)},
          {"newton_iterations", static_cast<double>(iterations), true},
          {"iterations", static_cast<double>(products), true},
          {"stalled_searches", static_cast<double>(stalls)},
          {"implicit_euler_steps", static_cast<double>(eulerSteps)}};
}

}  // namespace ringwatch

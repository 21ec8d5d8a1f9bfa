#include <ringwatch/monitor/incremental/rest_bound.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>

#include <Eigen/Eigenvalues>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/parallel.h>
#include <ringwatch/base/sort_unique.h>
#include <ringwatch/body/element_damping.h>
#include <ringwatch/materials/rotation.h>
#include <ringwatch/monitor/incremental/laplacian_majorants.h>
#include <ringwatch/monitor/incremental/moved_majorant.h>

namespace ringwatch {
namespace {

/// Of weights in single precision, and of all that is summed up in double precision after them, relative.
constexpr double weightRounding = 1e-6, boundRounding = 1e-9;
/// What a group adds of which nothing is known, Pa: beyond any modulus, and a number, which times no weight is nothing.
constexpr double unknown = 1e200;
/// A bound from which it is of something unknown, rad²/s².
constexpr double boundOfUnknown = 1e150;
/// What a thread takes at a time.
constexpr int groupsOfThread = 64, regionsOfThread = 16;
/// What rounding makes of |F - C|², over |C|² + 3, and of the principal stretches of C, over |C|.
constexpr double squareRounding = 64 * std::numeric_limits<double>::epsilon(), stretchRounding = 1e-10;

Matrix3<double> matrixOf(const double* entries) {
  Matrix3<double> matrix;
  std::copy_n(entries, 9, matrix.m);
  return matrix;
}
/// Single precision at or above a number that is not negative.
float singleAbove(double value) { return static_cast<float>(value * (1 + weightRounding)); }
NativePack packOf(const float (&numbers)[lanes]) {
  detail::NativeFloats floats;
  std::memcpy(&floats, numbers, sizeof floats);
  return detail::packOf(floats);
}
Symmetric3<double> productWithTranspose(const Matrix3<double>& T) {
  Symmetric3<double> product;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) product(i, j) = T(i, 0) * T(j, 0) + T(i, 1) * T(j, 1) + T(i, 2) * T(j, 2);
  return product;
}
const NativePack (&atRest())[3] {
  static const NativePack ones[3] = {NativePack(1.0), NativePack(1.0), NativePack(1.0)};
  return ones;
}

/// The least c with A ≼ c (λ 1 1ᵀ + 2μ I).
double shareOf(const Eigen::Matrix3d& A, double lambda, double twoMu) {
  // The root of the inverse is a I + b 1 1ᵀ.
  const double a = 1 / std::sqrt(twoMu), b = (1 / std::sqrt(3 * lambda + twoMu) - a) / 3;
  const Eigen::Matrix3d root = a * Eigen::Matrix3d::Identity() + b * Eigen::Matrix3d::Ones();
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(root * A * root, Eigen::EigenvaluesOnly).eigenvalues()[2];
}

}  // namespace

bool RestBound::serves(const Body& body) {
  if (body.discreteForces() || body.elementDamping() || !body.constraints().rigidBodies().empty()) return false;
  return std::all_of(body.blocks().begin(), body.blocks().end(), [](const auto& block) {
    PrincipalTangent<NativePack> tangent;
    if (!block->principalTangentAt(atRest(), tangent)) return false;
    const double twoMu = tangent.flip[0], lambda = tangent.normal[0][1][0];
    return twoMu > 0 && 3 * lambda + twoMu > 0;
  });
}

RestBound::RestBound(const Body& body, const RestBoundPolicy& policy) : body_(body), policy_(policy) {}

void RestBound::start(NodalBound weights) {
  bodyVersion_ = body_.version();
  const NodeVectors& X = body_.mesh().X;
  started_ = std::isfinite(weights.evaluate(X, 0).value);
  if (!started_) return;
  makeGroups();
  makeRegions(sumWeights(weights));
  index();
  for (std::size_t g = 0; g < groups_.size(); ++g) settle(X, g);
}

void RestBound::makeGroups() {
  groups_.clear();
  const int batches = std::max(policy_.elementsOfGroup / lanes, 1);
  for (std::size_t b = 0; b < body_.blocks().size(); ++b) {
    const ElementBlock& block = *body_.blocks()[b];
    const PatchLayout& layout = block.layout();
    for (const Patch& patch : layout.patches)
      for (std::int32_t begin = patch.batchBegin; begin < patch.batchEnd; begin += batches) {
        Group group{};
        group.block = static_cast<std::int32_t>(b);
        group.begin = begin;
        group.end = std::min(begin + batches, patch.batchEnd);
        group.follows = block.material().info().objective ? 0 : 1;
        for (std::int32_t place = group.begin * lanes; place < group.end * lanes; ++place)
          if (const std::int32_t e = layout.elements[place]; e >= 0)
            for (const std::int32_t node : block.nodesOf(e)) group.follows |= isPartlyHeld(body_, node) ? 1 : 0;
        groups_.push_back(group);
      }
  }
}

void RestBound::index() {
  centres_.resize(BatchMotion::centreSize * groups_.size());
  groupOfBatch_.clear();
  farthest2_.clear();
  sums_.clear();
  wantsSum_.clear();
  rest_.clear();
  motions_.resize(groups_.size());
  for (const auto& block : body_.blocks()) {
    groupOfBatch_.emplace_back(block->layout().batchCount());
    farthest2_.emplace_back(lanes * static_cast<std::size_t>(block->layout().batchCount()));
    sums_.emplace_back(9 * lanes * static_cast<std::size_t>(block->layout().batchCount()));
    wantsSum_.emplace_back(block->layout().batchCount());
    PrincipalTangent<NativePack> tangent;
    block->principalTangentAt(atRest(), tangent);
    rest_.push_back({tangent.normal[0][1][0], tangent.flip[0], stretchesFreely(*block), block->rule().uniformStrain,
                     block->rule().uniformStrain ? 1 : static_cast<int>(block->rule().points.size())});
  }
  for (std::size_t g = 0; g < groups_.size(); ++g)
    std::fill(groupOfBatch_[groups_[g].block].begin() + groups_[g].begin,
              groupOfBatch_[groups_[g].block].begin() + groups_[g].end, static_cast<std::int32_t>(g));
}

std::vector<std::vector<RestBound::Part>> RestBound::sumWeights(const NodalBound& weights) const {
  struct Sum {
    std::int32_t group;
    Symmetric3<double> weight;
    double laplacian;
  };
  const std::vector<std::vector<double>> laplacian = laplacianMajorants(body_);
  std::vector<std::vector<Sum>> sums(body_.nodeCount());
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const Group& group = groups_[g];
    const ElementBlock& block = *body_.blocks()[group.block];
    const int n = block.nodesPerElement();
    for (std::int32_t place = group.begin * lanes; place < group.end * lanes; ++place) {
      const std::int32_t e = block.layout().elements[place];
      if (e < 0) continue;
      const ElementRef element{group.block, e};
      const auto nodes = block.nodesOf(e);
      for (int a = 0; a < n; ++a) {
        std::vector<Sum>& own = sums[nodes[a]];
        if (own.empty() || own.back().group != static_cast<std::int32_t>(g))
          own.push_back({static_cast<std::int32_t>(g), Symmetric3<double>::diagonal(0), 0});
        const Eigen::Matrix3d D = weights.value(element) * weights.weight(weights.incidenceOf(element, a));
        for (int i = 0; i < 3; ++i)
          for (int j = i; j < 3; ++j) own.back().weight(i, j) += D(i, j);
        own.back().laplacian += laplacian[group.block][(place / lanes * n + a) * lanes + place % lanes];
      }
    }
  }
  std::vector<std::vector<Part>> parts(sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i)
    for (const Sum& sum : sums[i]) {
      const double mass = body_.lumpedMass()[static_cast<Eigen::Index>(i)];
      Part part{sum.group, {}, singleAbove(sum.laplacian / mass)};
      // Rounded to nearest; what that loses is added to the diagonal.
      for (int c = 0; c < 6; ++c)
        part.weight[c] =
            static_cast<float>((sum.weight.m[c] + (c < 3 ? weightRounding * sum.weight.trace() : 0)) / mass);
      parts[i].push_back(part);
    }
  return parts;
}

void RestBound::makeRegions(const std::vector<std::vector<Part>>& partsOfNode) {
  regions_.clear();
  parts_.clear();
  packBegin_ = {0};
  restHighest_ = laplacianHighest_ = 0;
  std::vector<std::int32_t> regionOf(groups_.size());
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    if (regions_.empty() || regions_.back().end - regions_.back().begin == policy_.groupsOfRegion ||
        groups_[g].block != groups_[g - 1].block)
      regions_.push_back({static_cast<std::int32_t>(g), static_cast<std::int32_t>(g), 0, 0, {}, 0, 0, 0, 0, -1});
    ++regions_.back().end;
    regionOf[g] = static_cast<std::int32_t>(regions_.size()) - 1;
  }
  std::vector<std::vector<std::int32_t>> nodesOf(regions_.size());
  for (std::int32_t i = 0; i < body_.nodeCount(); ++i) {
    if (partsOfNode[i].empty() || (body_.constraints().any() && body_.constraints().freeComponents(i) == 0)) continue;
    nodesOf[regionOf[partsOfNode[i].front().group]].push_back(i);
  }
  for (std::size_t r = 0; r < regions_.size(); ++r) {
    Region& region = regions_[r];
    std::vector<std::int32_t>& nodes = nodesOf[r];
    std::stable_sort(nodes.begin(), nodes.end(),
                     [&](std::int32_t a, std::int32_t b) { return partsOfNode[a].size() < partsOfNode[b].size(); });
    for (const std::int32_t i : nodes) {
      Symmetric3<double> sum = Symmetric3<double>::diagonal(0);
      double weights = 0, laplacian = 0;
      for (const Part& part : partsOfNode[i]) {
        Symmetric3<double> own;
        std::copy_n(part.weight, 6, own.m);
        sum = sum + own;
        weights += eigenvalueBounds(own).high();
        laplacian += part.laplacian;
        region.around.push_back(part.group);
      }
      region.weight = std::max(region.weight, eigenvalueBounds(sum).high());
      region.weights = std::max(region.weights, weights);
      region.laplacian = std::max(region.laplacian, laplacian);
    }
    sortUnique(region.around);
    restHighest_ = std::max(restHighest_, region.weight);
    laplacianHighest_ = std::max(laplacianHighest_, region.laplacian);
    region.packBegin = static_cast<std::int32_t>(packBegin_.size()) - 1;
    for (std::size_t first = 0; first < nodes.size(); first += lanes) {
      const std::size_t last = std::min(first + lanes, nodes.size());
      for (std::size_t k = 0; k < partsOfNode[nodes[last - 1]].size(); ++k) {
        PackOfParts pack{};
        for (std::size_t lane = 0; lane < lanes; ++lane) {
          const std::vector<Part>& parts = partsOfNode[nodes[std::min(first + lane, last - 1)]];
          pack.group[lane] = parts[std::min(k, parts.size() - 1)].group;
          if (k >= parts.size()) continue;
          for (int c = 0; c < 6; ++c) pack.weight[c][lane] = parts[k].weight[c];
          pack.laplacian[lane] = parts[k].laplacian;
        }
        parts_.push_back(pack);
      }
      packBegin_.push_back(static_cast<std::int32_t>(parts_.size()));
    }
    region.packEnd = static_cast<std::int32_t>(packBegin_.size()) - 1;
  }
}

void RestBound::measure(NodeVectorsView x, StepEvaluation* evaluation) {
  class Measure final : public PatchVisitor {
   public:
    explicit Measure(RestBound& bound) : bound_(bound) {}
    void visitPatch(std::size_t block, const PatchPass& pass) override {
      const BatchMotion motion{bound_.centres_.data(), bound_.groupOfBatch_[block].data(),
                               bound_.farthest2_[block].data(), bound_.wantsSum_[block].data(),
                               bound_.sums_[block].data()};
      pass.run(nullptr, &motion);
    }

   private:
    RestBound& bound_;
  };
  Measure visitor(*this);
  StepEvaluation measureOnly;
  measureOnly.wantsForce = false;
  StepEvaluation& asked = evaluation ? *evaluation : measureOnly;
  asked.visitor = &visitor;
  body_.evaluate(x, asked, workspace_);
  asked.visitor = nullptr;
}

void RestBound::settle(NodeVectorsView x, std::size_t g) {
  using P = NativePack;
  Group& group = groups_[g];
  const ElementBlock& block = *body_.blocks()[group.block];
  const Rest& rest = rest_[group.block];
  const Lame constants = block.material().restModuli();
  const int gradients = rest.gradients;
  AlignedVector<Matrix3<P>>& F = gradients_;
  F.clear();
  Matrix3<P> sum = Matrix3<P>::zero();
  double rounding = 0;
  AlignedVector<double> own(static_cast<std::size_t>(9 * gradients * lanes));
  P stress(-infinity);
  for (std::int32_t batch = group.begin; batch < group.end; ++batch) {
    if (isEmpty(group, batch)) continue;
    const std::int32_t* elements = block.layout().elements.data() + static_cast<std::ptrdiff_t>(batch) * lanes;
    TangentDrift drift[lanes];
    block.deformationOf(elements, x.data(), own.data(), drift);
    for (int lane = 0; lane < lanes && elements[lane] >= 0; ++lane) {
      seen_.push_back({{group.block, elements[lane]}, drift[lane].determinant, drift[lane].law.negative});
      rounding = std::max(rounding, drift[lane].gradientRounding);
    }
    for (int q = 0; q < gradients; ++q) {
      Matrix3<P> gradient;
      for (int i = 0; i < 9; ++i) gradient.m[i] = P::load(own.data() + (9 * q + i) * lanes);
      sum = sum + gradient;
      F.push_back(gradient);
      if (rest.stretches) stress = math::max(stress, eigenvalueBounds(secondStressOf(constants, gradient)).high());
    }
  }
  const auto gather = [](const P& pack, const auto& take) {
    for (int lane = 0; lane < lanes; ++lane) take(pack[lane]);
  };
  Matrix3<double> mean = Matrix3<double>::zero();
  for (int i = 0; i < 9; ++i) {
    gather(sum.m[i], [&](double value) { mean.m[i] += value; });
    mean.m[i] /= static_cast<double>(F.size()) * lanes;
  }
  group.rounding = rounding;
  centre(g, mean);
  group.seenNegative = group.negative;
  Matrix3<P> middle;
  const double* at = centres_.data() + BatchMotion::centreSize * g;
  for (int i = 0; i < 9; ++i) middle.m[i] = P(at[i]);
  P farthest2(0.0);
  for (const Matrix3<P>& gradient : F) {
    const Matrix3<P> difference = gradient - middle;
    farthest2 = math::max(farthest2, innerProduct(difference, difference));
  }
  group.delta = 0;
  group.stress = -infinity;
  gather(farthest2, [&](double value) { group.delta = std::max(group.delta, std::sqrt(value)); });
  gather(stress, [&](double value) { group.stress = std::max(group.stress, value); });
  group.settled = true;
}

void RestBound::centre(std::size_t g, Matrix3<double> gradient) {
  Group& group = groups_[g];
  const Rest& rest = rest_[group.block];
  if (group.follows)
    for (int i = 0; i < 9; ++i)
      if (i % 4 != 0) gradient.m[i] = 0;
  double* at = centres_.data() + BatchMotion::centreSize * g;
  std::copy_n(gradient.m, 9, at);
  const double square = at[BatchMotion::placeOfSquare] = innerProduct(gradient, gradient);
  group.settled = false;
  // s₃ = det T / (s₁ s₂) >= 2 det T / |T|².
  group.leastStretch = std::max(0.0, (1 - stretchRounding) * 2 * determinant(gradient) / square);
  group.drift = {};
  if (rest.stretches) {
    std::copy_n(gradient.m, 9, group.turn);
    group.ofRest = eigenvalueBounds(productWithTranspose(gradient)).high();
    const EigenvalueBounds<double> stress =
        eigenvalueBounds(secondStressOf(body_.blocks()[group.block]->material().restModuli(), gradient));
    group.beside = stress.high();
    group.negative = std::max(0.0, stress.half - stress.mean);
    return;
  }
  const Matrix3<double> turn = group.follows ? Matrix3<double>::identity() : closestRotation(gradient);
  std::copy_n(turn.m, 9, group.turn);
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> C(gradient.m);
  NativePack stretches[3];
  if (group.follows) {
    for (int i = 0; i < 3; ++i) stretches[i] = NativePack(gradient(i, i));
  } else {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> squares(C.transpose() * C, Eigen::EigenvaluesOnly);
    for (int i = 0; i < 3; ++i) stretches[i] = NativePack(std::sqrt(std::max(squares.eigenvalues()[i], 0.0)));
  }
  PrincipalTangent<NativePack> tangent;
  body_.blocks()[group.block]->principalTangentAt(stretches, tangent);
  Eigen::Matrix3d normal;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) normal(i, j) = 0.5 * (tangent.normal[i][j][0] + tangent.normal[j][i][0]);
  group.beside = std::max(tangent.twist[0], 0.0) + boundRounding * (rest.lambda + rest.twoMu);
  normal.diagonal().array() -= group.beside;
  group.ofRest = std::max({shareOf(normal, rest.lambda, rest.twoMu), (tangent.flip[0] - group.beside) / rest.twoMu,
                           rest.hourglass ? 1.0 : 0.0});
  group.drift = {tangent.drift.kappa[0], tangent.drift.linear[0], tangent.drift.quadratic[0], tangent.drift.negative[0],
                 tangent.drift.radius[0]};
  group.negative = std::max(0.0, tangent.drift.negative[0]);
  // A mirrored mean is no stretch, nor is one whose diagonal is not positive.
  if (!(group.leastStretch > 0) || !(std::min({stretches[0][0], stretches[1][0], stretches[2][0]}) > 0))
    group.drift.radius = -1;
}

void RestBound::move(std::size_t g) {
  const Group& group = groups_[g];
  Motion& motion = motions_[g];
  const Rest& rest = rest_[group.block];
  const TangentDriftCoefficients<double>& drift = group.drift;
  const double centre2 = centres_[BatchMotion::centreSize * g + BatchMotion::placeOfSquare];
  const double delta = group.delta + group.rounding + stretchRounding * std::sqrt(centre2);
  const double kappa = rest.stretches ? rest.lambda + rest.twoMu : drift.kappa;
  // (1 + η) α R D Rᵀ + (1 + 1/η) κ δ² L is least, at the highest nodes, for η = δ s.
  const double s =
      kappa > 0 && group.ofRest > 0 ? std::sqrt(kappa * laplacianHighest_ / (group.ofRest * restHighest_)) : 0;
  const double eta = delta * s, spread = s > 0 ? kappa * delta * (delta + 1 / s) : kappa * delta * delta;
  double scale = 1 + eta;
  if (rest.stretches) {
    const double modulus = std::sqrt(kappa * kappa + 2 * rest.lambda * rest.lambda);
    const double stress = group.settled ? group.stress + boundRounding * kappa * group.ofRest
                                        : group.beside + modulus * delta * (std::sqrt(group.ofRest) + 0.5 * delta);
    motion.added = spread + std::max(0.0, stress);
  } else {
    scale *= group.ofRest;
    motion.added = delta <= drift.radius ? (1 + eta) * group.beside + eta * drift.negative + spread +
                                               delta * (drift.linear + delta * drift.quadratic)
                                         : unknown;
  }
  double root = std::sqrt(scale);
  // Where the law says nothing of the centre.
  if (!(root < unknown && motion.added >= 0)) {
    motion.added = unknown;
    root = 0;
  }
  for (int i = 0; i < 9; ++i) motion.matrix[i] = root * group.turn[i];
}

double RestBound::boundOfAll(const Region& region) const {
  if (region.packBegin == region.packEnd) return 0;
  const Motion& first = motions_[region.begin];
  const double stretch2 = eigenvalueBounds(productWithTranspose(matrixOf(first.matrix))).high();
  double apart2 = 0, added = 0;
  for (const std::int32_t g : region.around) {
    const Motion& motion = motions_[g];
    double square = 0;
    for (int i = 0; i < 9; ++i) square += (motion.matrix[i] - first.matrix[i]) * (motion.matrix[i] - first.matrix[i]);
    apart2 = std::max(apart2, square);
    added = std::max(added, motion.added);
  }
  return stretch2 * region.weight + (2 * std::sqrt(stretch2 * apart2) + apart2) * region.weights +
         added * region.laplacian;
}

double RestBound::boundOfNodes(const Region& region) const {
  using P = NativePack;
  P highest(0.0);
  for (std::int32_t pack = region.packBegin; pack < region.packEnd; ++pack) {
    Symmetric3<P> sum = Symmetric3<P>::diagonal(P(0.0));
    for (std::int32_t k = packBegin_[pack]; k < packBegin_[pack + 1]; ++k) {
      const PackOfParts& parts = parts_[k];
      alignas(64) double gathered[10][lanes];
      for (int lane = 0; lane < lanes; ++lane) {
        const Motion& motion = motions_[parts.group[lane]];
        for (int i = 0; i < 9; ++i) gathered[i][lane] = motion.matrix[i];
        gathered[9][lane] = motion.added;
      }
      Matrix3<P> matrix;
      for (int i = 0; i < 9; ++i) matrix.m[i] = P::load(gathered[i]);
      Symmetric3<P> weight;
      for (int c = 0; c < 6; ++c) weight.m[c] = packOf(parts.weight[c]);
      sum = sum + movedWeight(matrix, weight) + Symmetric3<P>::diagonal(P::load(gathered[9]) * packOf(parts.laplacian));
    }
    highest = math::max(highest, eigenvalueBounds(sum).high());
  }
  double most = 0;
  for (int lane = 0; lane < lanes; ++lane) most = std::max(most, highest[lane]);
  return most;
}

UpperBound RestBound::update(NodeVectorsView x, StepEvaluation* evaluation, double enough, std::int64_t most) {
  seen_.clear();
  if (!started()) {
    if (evaluation) body_.evaluate(x, *evaluation, workspace_);
    return {infinity};
  }
  if (groupOfBatch_.empty()) index();
  const auto isDue = [&](std::size_t g) { return (static_cast<std::int64_t>(g) + states_) % policy_.turns == 0; };
  for (std::size_t g = 0; g < groups_.size(); ++g)
    std::fill(wantsSum_[groups_[g].block].begin() + groups_[g].begin,
              wantsSum_[groups_[g].block].begin() + groups_[g].end, isDue(g) ? 1 : 0);
  measure(x, evaluation);
  bool finite = true;
  parallelFor(
      0, static_cast<std::int64_t>(groups_.size()), body_.threads(),
      [&](std::int64_t g) {
        groups_[g].settled = false;
        groups_[g].delta = unevennessOf(g);
        move(g);
      },
      groupsOfThread);
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const Group& group = groups_[g];
    finite = finite && std::isfinite(group.delta);
    const Rest& rest = rest_[group.block];
    // An element that inverts is seen, and those whose compression has grown.
    const bool mayInvert = !(group.delta + group.rounding < group.leastStretch);
    const bool compressed = group.negative > policy_.compressionGrowth * group.seenNegative +
                                                 policy_.slightCompression * (rest.lambda + rest.twoMu);
    if (!mayInvert && !compressed) continue;
    settle(x, g);
    move(g);
  }
  if (!finite) return {std::numeric_limits<double>::quiet_NaN()};
  const double bound = lowestBound(x, enough, most);
  parallelFor(
      0, static_cast<std::int64_t>(groups_.size()), body_.threads(),
      [&](std::int64_t g) {
        if (isDue(g) && !groups_[g].settled) centre(g, meanOf(g));
      },
      groupsOfThread);
  ++states_;
  return {bound < boundOfUnknown ? (1 + boundRounding) * bound : infinity};
}

double RestBound::unevennessOf(std::size_t g) const {
  const Group& group = groups_[g];
  NativePack farthest(0.0), all(0.0);
  for (std::int32_t batch = group.begin; batch < group.end; ++batch) {
    if (isEmpty(group, batch)) continue;
    const NativePack own =
        NativePack::load(farthest2_[group.block].data() + static_cast<std::ptrdiff_t>(batch) * lanes);
    farthest = math::max(farthest, own);
    all += own;
  }
  double farthest2 = 0, sum = 0;
  for (int lane = 0; lane < lanes; ++lane) {
    farthest2 = std::max(farthest2, farthest[lane]);
    sum += all[lane];
  }
  if (!std::isfinite(sum)) return sum;
  const double square = centres_[BatchMotion::centreSize * g + BatchMotion::placeOfSquare];
  return std::sqrt(farthest2 + squareRounding * (square + BatchMotion::dimensions));
}

Matrix3<double> RestBound::meanOf(std::size_t g) const {
  const Group& group = groups_[g];
  Matrix3<NativePack> sum = Matrix3<NativePack>::zero();
  double count = 0;
  for (std::int32_t batch = group.begin; batch < group.end; ++batch) {
    if (isEmpty(group, batch)) continue;
    count += lanes * rest_[group.block].gradients;
    for (int i = 0; i < 9; ++i)
      sum.m[i] += NativePack::load(sums_[group.block].data() + (9 * static_cast<std::ptrdiff_t>(batch) + i) * lanes);
  }
  Matrix3<double> mean = Matrix3<double>::zero();
  for (int i = 0; i < 9; ++i)
    for (int lane = 0; lane < lanes; ++lane) mean.m[i] += sum.m[i][lane] / count;
  return mean;
}

double RestBound::lowestBound(NodeVectorsView x, double enough, std::int64_t most) {
  parallelFor(
      0, static_cast<std::int64_t>(regions_.size()), body_.threads(),
      [&](std::int64_t r) {
        regions_[r].bound = boundOfAll(regions_[r]);
        regions_[r].settledAt = -1;
      },
      regionsOfThread);
  std::int32_t settled = 0;
  for (double known = 0;;) {
    Region& top = *std::max_element(regions_.begin(), regions_.end(),
                                    [](const Region& a, const Region& b) { return a.bound < b.bound; });
    const bool spent = static_cast<std::int64_t>(seen_.size()) >= most;
    if (top.bound <= enough || (spent && top.settledAt < 0 && top.bound <= (1 + policy_.same) * known))
      return top.bound;
    if (top.settledAt == settled) {
      // Its nodes are as low as the motions make them: its own groups are gone through, then those around it.
      std::vector<std::int32_t> open;
      const auto isOpen = [&](std::int32_t g) { return !groups_[g].settled; };
      for (std::int32_t g = top.begin; g < top.end; ++g)
        if (isOpen(g)) open.push_back(g);
      if (open.empty()) std::copy_if(top.around.begin(), top.around.end(), std::back_inserter(open), isOpen);
      if (open.empty() || spent) return top.bound;
      ++settled;
      for (const std::int32_t g : open) {
        settle(x, g);
        move(g);
      }
    }
    const double bound = boundOfNodes(top);
    top.bound = std::min(top.bound, bound);
    top.settledAt = settled;
    if (top.bound < boundOfUnknown) known = std::max(known, top.bound);
  }
}

}  // namespace ringwatch

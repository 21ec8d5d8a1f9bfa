#include <ringwatch/monitor/incremental/rest_bound.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include <ringwatch/base/parallel.h>
#include <ringwatch/base/sort_unique.h>
#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/body/element_damping.h>
#include <ringwatch/materials/rotation.h>
#include <ringwatch/monitor/bounds/scaled_tangent.h>
#include <ringwatch/monitor/incremental/laplacian_majorants.h>
#include <ringwatch/monitor/incremental/moved_majorant.h>
#include <ringwatch/monitor/incremental/validity_balls.h>

namespace ringwatch {
namespace {

/// Of sums of many products in double precision, relative.
constexpr double boundRounding = 1e-9;
/// What a group adds of which nothing is known, Pa: beyond any modulus, and a number, which times no weight is nothing.
constexpr double unknown = 1e200;
/// A bound from which it is of something unknown, rad²/s².
constexpr double boundOfUnknown = 1e36;
/// What a thread takes at a time.
constexpr int groupsOfThread = 64, regionsOfThread = 16;
/// Of principal stretches and sums of few products, relative; and how far a G is from a rotation in single precision.
constexpr double relativeRounding = 1e-10, turnRounding = 1e-5;
/// Of weights in single precision, relative.
constexpr double weightRounding = 1e-6;

template <class Number>
Matrix3<double> matrixOf(const Number* entries) {
  Matrix3<double> matrix;
  std::copy_n(entries, 9, matrix.m);
  return matrix;
}
double distance(const Matrix3<double>& A, const Matrix3<double>& B) {
  const Matrix3<double> off = A - B;
  return std::sqrt(innerProduct(off, off));
}
Matrix3<NativePack> broadcast(const Matrix3<double>& A) {
  Matrix3<NativePack> all;
  for (int i = 0; i < 9; ++i) all.m[i] = NativePack(A.m[i]);
  return all;
}
template <class S>
Symmetric3<S> productWithTranspose(const Matrix3<S>& T) {
  Symmetric3<S> product;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) product(i, j) = T(i, 0) * T(j, 0) + T(i, 1) * T(j, 1) + T(i, 2) * T(j, 2);
  return product;
}
/// A bound of the largest singular value.
double largestStretch(const Matrix3<double>& A) { return std::sqrt(eigenvalueBounds(productWithTranspose(A)).high()); }
/// All eigenvalues, ascending, to relativeRounding of the largest.
struct Eigenvalues {
  NativePack least, middle, largest;
};
Eigenvalues eigenvaluesOf(const Symmetric3<NativePack>& A) {
  NativePack full[9], work[12];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) full[3 * i + j] = A(i, j);
  const auto extremes = extremeEigenvalues(full, 3, work, true);
  return {extremes.least, A.trace() - extremes.least - extremes.largest, extremes.largest};
}
/// The unit over which a group's next G stands.
double unitOf(std::uint8_t flags) { return (flags & BatchMotion::rest) != 0 ? 1 : ValidityBalls::entryUnit; }
NativePack packOf(const float (&numbers)[lanes]) {
  detail::NativeFloats floats;
  std::memcpy(&floats, numbers, sizeof floats);
  return detail::packOf(floats);
}
/// Deformation gradients that an element of the block has.
int gradientsOf(const ElementBlock& block) {
  return block.rule().uniformStrain ? 1 : static_cast<int>(block.rule().points.size());
}
const NativePack (&atRest())[3] {
  static const NativePack ones[3] = {NativePack(1.0), NativePack(1.0), NativePack(1.0)};
  return ones;
}

/// A rotation to relativeRounding, by Newton's iteration for the polar factor (Higham 2008, section 8.3), of what is
/// near one; the identity of what is not.
Matrix3<double> nearRotation(Matrix3<double> T) {
  constexpr int most = 8;
  for (int k = 0; k < most; ++k) {
    const Matrix3<double> next = 0.5 * (T + transpose(inverse(T))), step = next - T;
    T = next;
    if (innerProduct(step, step) < relativeRounding) break;
  }
  T = polishedRotation(T);
  return determinant(T) > 0.5 && determinant(T) < 2 ? T : Matrix3<double>::identity();
}
/// The least c with A ≼ c (λ 1 1ᵀ + 2μ I), rounded up.
NativePack shareOf(const Symmetric3<NativePack>& A, double lambda, double twoMu) {
  // The root of the inverse is a I + b 1 1ᵀ.
  const double a = 1 / std::sqrt(twoMu), b = (1 / std::sqrt(3 * lambda + twoMu) - a) / 3;
  Symmetric3<NativePack> root = Symmetric3<NativePack>::diagonal(NativePack(a + b));
  for (int c = 3; c < 6; ++c) root.m[c] = NativePack(b);
  const Symmetric3<NativePack> ratio = congruence(root, A);
  NativePack size(0.0);
  for (int c = 0; c < 6; ++c) size += math::abs(ratio.m[c]);
  return eigenvaluesOf(ratio).largest + NativePack(relativeRounding) * size;
}

}  // namespace

bool RestBound::serves(const Body& body) {
  if (body.elementDamping() || !body.constraints().rigidBodies().empty()) return false;
  return std::all_of(body.blocks().begin(), body.blocks().end(), [](const auto& block) {
    PrincipalTangent<NativePack> tangent;
    if (!block->principalTangentAt(atRest(), tangent)) return false;
    const double twoMu = tangent.flip[0], lambda = tangent.normal[0][1][0];
    return twoMu > 0 && 3 * lambda + twoMu > 0;
  });
}

RestBound::RestBound(const Body& body, const RestBoundPolicy& policy) : body_(body), policy_(policy) {}

void RestBound::start(NodalBound weights, const std::function<double(ElementRef)>& valueAtRest) {
  bodyVersion_ = body_.version();
  weights_.emplace(std::move(weights));
  const NodeVectors& X = body_.mesh().X;
  restHighest_ = weights_->last();
  started_ = std::isfinite(restHighest_) && restHighest_ > 0;
  if (!started_) return;
  values_.clear();
  laplacian_.clear();
  reference_.clear();
  compressed_.clear();
  const std::vector<std::vector<double>> laplacian = laplacianMajorants(body_);
  for (std::size_t b = 0; b < body_.blocks().size(); ++b) {
    const std::vector<std::int32_t>& elements = body_.blocks()[b]->layout().elements;
    values_.emplace_back(elements.size());
    for (std::size_t place = 0; place < elements.size(); ++place)
      if (const ElementRef e{static_cast<std::int32_t>(b), elements[place]}; e.element >= 0)
        values_[b][place] = valueAtRest ? valueAtRest(e) : weights_->value(e);
    laplacian_.emplace_back(laplacian[b].begin(), laplacian[b].end());
    reference_.emplace_back(9 * elements.size() * static_cast<std::size_t>(gradientsOf(*body_.blocks()[b])));
    compressed_.emplace_back(body_.blocks()[b]->layout().batchCount());
  }
  weights_->releaseSums();
  makeGroups();
  makeRegions();
  index();
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const Matrix3<double> one = Matrix3<double>::identity();
    std::copy_n(one.m, 9, last_.data() + 9 * g);
    setNext(static_cast<std::int32_t>(g), one, true);
  }
  parallelFor(
      0, static_cast<std::int64_t>(groups_.size()), body_.threads(),
      [&](std::int64_t g) { refer(X, static_cast<std::int32_t>(g)); }, groupsOfThread);
  followDiscreteForces(X);
  for (Region& region : regions_) region.lowest = boundNodes(region);
}

void RestBound::makeGroups() {
  groups_.clear();
  for (std::size_t b = 0; b < body_.blocks().size(); ++b) {
    const ElementBlock& block = *body_.blocks()[b];
    const int batches = std::max(policy_.gradientsOfGroup / (lanes * gradientsOf(block)), 1);
    const PatchLayout& layout = block.layout();
    for (std::size_t p = 0; p < layout.patches.size(); ++p) {
      const Patch& patch = layout.patches[p];
      for (std::int32_t begin = patch.batchBegin; begin < patch.batchEnd; begin += batches) {
        Group group{};
        group.block = static_cast<std::int32_t>(b);
        group.patch = static_cast<std::int32_t>(p);
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
}

void RestBound::makeRegions() {
  std::vector<std::vector<std::int32_t>> groupsOfNode(body_.nodeCount());
  Eigen::VectorXd laplacian = Eigen::VectorXd::Zero(body_.nodeCount());
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const Group& group = groups_[g];
    const ElementBlock& block = *body_.blocks()[group.block];
    const int n = block.nodesPerElement();
    for (std::int32_t place = group.begin * lanes; place < group.end * lanes; ++place) {
      const std::int32_t e = block.layout().elements[place];
      if (e < 0) continue;
      const auto nodes = block.nodesOf(e);
      for (int a = 0; a < n; ++a) {
        std::vector<std::int32_t>& own = groupsOfNode[nodes[a]];
        if (own.empty() || own.back() != static_cast<std::int32_t>(g)) own.push_back(static_cast<std::int32_t>(g));
        laplacian[nodes[a]] += laplacian_[group.block][(place / lanes * n + a) * lanes + place % lanes];
      }
    }
  }
  regions_.clear();
  parts_.clear();
  packBegin_.assign(1, 0);
  laplacianHighest_ = 0;
  std::vector<std::vector<std::int32_t>> nodesOf(groups_.size() / static_cast<std::size_t>(policy_.groupsOfRegion) + 1);
  for (std::int32_t i = 0; i < body_.nodeCount(); ++i)
    if (!groupsOfNode[i].empty() && !isHeld(i)) nodesOf[groupsOfNode[i].front() / policy_.groupsOfRegion].push_back(i);
  for (std::vector<std::int32_t>& nodes : nodesOf) {
    if (nodes.empty()) continue;
    // Those of a pack have parts of much the same number.
    std::stable_sort(nodes.begin(), nodes.end(),
                     [&](std::int32_t i, std::int32_t j) { return groupsOfNode[i].size() > groupsOfNode[j].size(); });
    Region region{};
    region.node = nodes.front();
    region.boundedAt = -1;
    region.referredAt = -1;
    for (const std::int32_t i : nodes) {
      region.around.insert(region.around.end(), groupsOfNode[i].begin(), groupsOfNode[i].end());
      region.laplacian = std::max(region.laplacian, laplacian[i] / body_.lumpedMass()[i]);
    }
    sortUnique(region.around);
    laplacianHighest_ = std::max(laplacianHighest_, region.laplacian);
    region.packBegin = static_cast<std::int32_t>(packBegin_.size()) - 1;
    for (std::size_t first = 0; first < nodes.size(); first += lanes) {
      for (std::size_t k = 0; k < groupsOfNode[nodes[first]].size(); ++k) {
        PackOfParts pack{};
        for (std::size_t lane = 0; lane < lanes; ++lane) {
          pack.group[lane] = groupsOfNode[nodes[first]].front();
          if (first + lane >= nodes.size()) continue;
          const std::vector<std::int32_t>& own = groupsOfNode[nodes[first + lane]];
          pack.group[lane] = own[std::min(k, own.size() - 1)];
          pack.node[lane] = k < own.size() ? nodes[first + lane] : -1;
        }
        for (std::size_t lane = nodes.size() - first; lane < lanes; ++lane) pack.node[lane] = -1;
        parts_.push_back(pack);
      }
      packBegin_.push_back(static_cast<std::int32_t>(parts_.size()));
    }
    region.packEnd = static_cast<std::int32_t>(packBegin_.size()) - 1;
    regions_.push_back(std::move(region));
  }
}

void RestBound::index() {
  groupOfBatch_.clear();
  rest_.clear();
  for (const auto& block : body_.blocks()) {
    // What is no group's goes to one more.
    groupOfBatch_.emplace_back(block->layout().batchCount(), static_cast<std::int32_t>(groups_.size()));
    PrincipalTangent<NativePack> tangent;
    block->principalTangentAt(atRest(), tangent);
    rest_.push_back({tangent.normal[0][1][0], tangent.flip[0], stretchesFreely(*block), block->rule().uniformStrain,
                     gradientsOf(*block)});
  }
  places_.assign(groups_.size(), {});
  regionsOf_.assign(groups_.size(), {});
  for (std::size_t k = 0; k < parts_.size(); ++k)
    for (int lane = 0; lane < lanes; ++lane)
      if (parts_[k].node[lane] >= 0)
        places_[parts_[k].group[lane]].push_back(
            {parts_[k].node[lane], static_cast<std::int32_t>(k), 0, static_cast<std::uint16_t>(lane)});
  for (std::size_t r = 0; r < regions_.size(); ++r)
    for (const std::int32_t g : regions_[r].around) regionsOf_[g].push_back(static_cast<std::int32_t>(r));
  std::vector<std::uint16_t> localOf(body_.nodeCount());
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const Group& group = groups_[g];
    std::fill(groupOfBatch_[group.block].begin() + group.begin, groupOfBatch_[group.block].begin() + group.end,
              static_cast<std::int32_t>(g));
    const PatchLayout& layout = body_.blocks()[group.block]->layout();
    const Patch& patch = layout.patches[static_cast<std::size_t>(group.patch)];
    if (g == 0 || groups_[g - 1].patch != group.patch || groups_[g - 1].block != group.block)
      for (std::int32_t k = patch.nodeBegin; k < patch.nodeEnd; ++k)
        localOf[layout.nodes[k]] = static_cast<std::uint16_t>(k - patch.nodeBegin);
    for (Place& place : places_[g]) place.local = localOf[place.node];
  }
  measured_.resize(BatchMotion::sizeOfGroup * (groups_.size() + 1));
  next_.resize(9 * (groups_.size() + 1));
  last_.resize(9 * groups_.size());
  flags_.resize(groups_.size() + 1);
  motions_.resize(groups_.size());
  bounds_.resize(regions_.size());
  discrete_.assign(regions_.size(), 0);
  if (!body_.discreteForces()) return;
  regionOfNode_.assign(body_.nodeCount(), -1);
  for (std::size_t r = 0; r < regions_.size(); ++r)
    for (std::int32_t k = packBegin_[regions_[r].packBegin]; k < packBegin_[regions_[r].packEnd]; ++k)
      for (const std::int32_t node : parts_[k].node)
        if (node >= 0) regionOfNode_[node] = static_cast<std::int32_t>(r);
}

RestBound::Moved RestBound::stretched(const Group& group, const Matrix3<P>* F, const Matrix3<P>& T,
                                      const P& delta) const {
  const Rest& rest = rest_[group.block];
  const double kappa = rest.lambda + rest.twoMu, spread = spreadOf(kappa);
  Moved moved{};
  moved.stress = P(-infinity);
  for (int q = 0; q < rest.gradients; ++q) {
    const Symmetric3<P> stress = secondStressOf(body_.blocks()[group.block]->material().restModuli(), F[q]);
    moved.stress = math::max(moved.stress, eigenvalueBounds(stress).high());
  }
  moved.added = spread > 0 ? P(kappa) * delta * (delta + P(1 / spread)) : P(kappa) * delta * delta;
  moved.geometric = math::max(P(0.0), moved.stress + P(boundRounding * kappa));
  moved.R = math::sqrt(P(1.0) + P(spread) * delta) * T;
  return moved;
}

RestBound::Moved RestBound::turned(const Group& group, const Matrix3<P>& T, const P& delta,
                                   TangentDriftCoefficients<P>& there) const {
  const Rest& rest = rest_[group.block];
  const P size = math::sqrt(innerProduct(T, T));
  const Matrix3<P> R = group.follows ? Matrix3<P>::identity() : closestRotation(T);
  P stretches[3];
  P radius(infinity);
  if (group.follows) {
    for (int i = 0; i < 3; ++i) stretches[i] = T(i, i);
  } else {
    const Matrix3<P> U = transposeTimes(R, T);
    Symmetric3<P> mean;
    P skew(0.0);
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j) {
        mean(i, j) = P(0.5) * (U(i, j) + U(j, i));
        skew += math::abs(U(i, j) - U(j, i));
      }
    const Eigenvalues own = eigenvaluesOf(mean);
    stretches[0] = own.least;
    stretches[1] = own.middle;
    stretches[2] = own.largest;
    // Where there is no closest rotation.
    radius = select(skew <= P(relativeRounding) * size, radius, P(-1.0));
  }
  // A mirrored gradient is no stretch, nor is one whose diagonal is not positive.
  for (const P& stretch : stretches) radius = select(stretch > P(relativeRounding) * size, radius, P(-1.0));
  PrincipalTangent<P> tangent;
  body_.blocks()[group.block]->principalTangentAt(stretches, tangent);
  Symmetric3<P> normal;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) normal(i, j) = P(0.5) * (tangent.normal[i][j] + tangent.normal[j][i]);
  const P beside = math::max(tangent.twist, P(0.0)) + P(boundRounding * (rest.lambda + rest.twoMu));
  for (int i = 0; i < 3; ++i) normal(i, i) -= beside;
  P share = math::max(shareOf(normal, rest.lambda, rest.twoMu), (tangent.flip - beside) / P(rest.twoMu));
  share = math::max(share, P(rest.hourglass ? 1.0 : 0.0));
  there = tangent.drift;
  there.radius = math::min(there.radius, radius);
  const P kappa = there.kappa;
  P spread(0.0);
  for (int lane = 0; lane < lanes; ++lane) spread.set(lane, spreadOf(kappa[lane]));
  const P eta = spread * delta;
  Moved moved{};
  moved.R = math::sqrt((P(1.0) + eta) * math::max(share, P(0.0))) * R;
  moved.added = (P(1.0) + eta) * beside + eta * there.negative + kappa * delta * delta +
                select(spread > P(0.0), kappa * delta / select(spread > P(0.0), spread, P(1.0)), P(0.0)) +
                delta * (there.linear + delta * there.quadratic);
  moved.stress = P(-infinity);
  const auto known = delta <= there.radius;
  moved.added = select(known, moved.added, P(0.0));
  moved.geometric = select(known, P(0.0), P(unknown));
  for (int i = 0; i < 9; ++i) moved.R.m[i] = select(known, moved.R.m[i], P(0.0));
  return moved;
}

void RestBound::refer(NodeVectorsView x, std::int32_t g) {
  Group& group = groups_[g];
  const ElementBlock& block = *body_.blocks()[group.block];
  const Rest& rest = rest_[group.block];
  const int n = block.nodesPerElement();
  const PatchLayout& layout = block.layout();
  // By node of the patch: the sum of what moves, in Symmetric3's order, of what does not, and of c.
  constexpr int numbers = 8;
  thread_local AlignedVector<double> sums, gradients;
  sums.resize(static_cast<std::size_t>(numbers * PatchLayout::maxPatchNodes));
  for (const Place& place : places_[g]) std::fill_n(sums.data() + numbers * place.local, numbers, 0.0);
  thread_local AlignedVector<Matrix3<P>> all;
  gradients.resize(static_cast<std::size_t>(9 * rest.gradients * lanes));
  all.resize(static_cast<std::size_t>((group.end - group.begin) * rest.gradients));
  Matrix3<P>* F = all.data();
  Symmetric3<P> D[maxElementNodes];
  Matrix3<double> ofFirst = Matrix3<double>::zero();
  group.rounding = group.uneven = group.size = group.count = 0;
  group.rests = 1;
  group.stress = -infinity;
  group.leastStretch = infinity;
  group.drift = {0, 0, 0, 0, infinity};
  double negative = 0;
  for (std::int32_t batch = group.begin; batch < group.end; ++batch) {
    const std::int32_t* elements = layout.elements.data() + static_cast<std::ptrdiff_t>(batch) * lanes;
    if (elements[0] < 0) continue;
    TangentDrift drift[lanes];
    block.deformationOf(elements, x.data(), gradients.data(), drift);
    Matrix3<P> T = Matrix3<P>::zero();
    P size2(0.0);
    for (int q = 0; q < rest.gradients; ++q) {
      for (int i = 0; i < 9; ++i) F[q].m[i] = P::load(gradients.data() + (9 * q + i) * lanes);
      T = T + F[q];
      size2 = math::max(size2, innerProduct(F[q], F[q]));
    }
    for (int i = 0; i < 9; ++i) T.m[i] = group.follows && i % 4 != 0 ? P(0.0) : P(1.0 / rest.gradients) * T.m[i];
    P delta(0.0), weight(0.0);
    for (int q = 0; q < rest.gradients; ++q) {
      const Matrix3<P> off = F[q] - T;
      delta = math::max(delta, innerProduct(off, off));
    }
    delta = math::sqrt(delta) + P(relativeRounding) * math::sqrt(size2);
    std::int16_t* const reference =
        reference_[group.block].data() + 9 * lanes * (static_cast<std::ptrdiff_t>(batch) * rest.gradients);
    const P stored = ValidityBalls::storeGradients(gradients.data(), rest.gradients, reference);
    for (int i = 0; i < 9 * rest.gradients * lanes && group.rests != 0; ++i)
      group.rests = reference[i] * ValidityBalls::entryUnit == (i / lanes % 9 % 4 == 0 ? 1.0 : 0.0) ? 1 : 0;
    bool compressed = false;
    const double slight = policy_.slightCompression * (rest.lambda + rest.twoMu);
    TangentDriftCoefficients<P> law{P(rest.lambda + rest.twoMu), P(0.0), P(0.0), P(0.0), P(infinity)};
    for (int lane = 0; lane < lanes; ++lane) {
      if (elements[lane] < 0) continue;
      const TangentDrift& own = drift[lane];
      delta.set(lane, delta[lane] + own.gradientRounding);
      weight.set(lane, values_[group.block][static_cast<std::size_t>(batch) * lanes + lane]);
      group.rounding = std::max(group.rounding, own.gradientRounding + stored[lane]);
      group.leastStretch = std::min(group.leastStretch, own.inversionDistance);
      negative = std::max(negative, own.law.negative);
      compressed |= own.law.negative > slight || !(own.determinant > 0);
    }
    // As the pass has them: empty lanes repeat the batch's first element.
    for (int i = 0; i < 9; ++i)
      for (int lane = 0; lane < lanes; ++lane) ofFirst.m[i] += F[0].m[i][lane];
    group.count += lanes;
    std::uint8_t& flag = compressed_[group.block][batch];
    flag = static_cast<std::uint8_t>((compressed ? 1 : 0) | (flag & 1 ? 2 : 0));
    const Moved moved = rest.stretches ? stretched(group, F, T, delta) : turned(group, T, delta, law);
    F += rest.gradients;
    for (int lane = 0; lane < lanes && elements[lane] >= 0; ++lane) {
      group.uneven = std::max(group.uneven, delta[lane]);
      group.size = std::max(group.size, std::sqrt(size2[lane]));
      group.stress = std::max(group.stress, moved.stress[lane]);
      group.drift.kappa = std::max(group.drift.kappa, law.kappa[lane]);
      group.drift.linear = std::max(group.drift.linear, law.linear[lane]);
      group.drift.quadratic = std::max(group.drift.quadratic, law.quadratic[lane]);
      group.drift.negative = std::max(group.drift.negative, law.negative[lane]);
      group.drift.radius = std::min(group.drift.radius, law.radius[lane]);
    }
    weights_->weightsOf(group.block, batch, D);
    const auto used = weight > P(0.0);
    const std::uint16_t* const local = layout.localNodes.data() + static_cast<std::ptrdiff_t>(batch) * n * lanes;
    for (int a = 0; a < n; ++a) {
      const P c = RoundedUp<Bfloat16>::load(laplacian_[group.block].data() +
                                            (static_cast<std::ptrdiff_t>(batch) * n + a) * lanes);
      Symmetric3<P> own = weight * movedWeight(moved.R, D[a]);
      for (int i = 0; i < 3; ++i) own.m[i] += moved.added * c;
      alignas(64) double entries[numbers][lanes];
      for (int i = 0; i < 6; ++i) select(used, own.m[i], P(0.0)).store(entries[i]);
      select(used, moved.geometric * c, P(0.0)).store(entries[6]);
      c.store(entries[7]);
      for (int lane = 0; lane < lanes && elements[lane] >= 0; ++lane) {
        double* const sum = sums.data() + numbers * local[a * lanes + lane];
        for (int i = 0; i < numbers; ++i) sum[i] += entries[i][lane];
      }
    }
  }
  const bool heldAnywhere = body_.constraints().any();
  for (const Place& place : places_[g]) {
    PackOfParts& parts = parts_[place.part];
    const double* const own = sums.data() + numbers * place.local;
    const double inverseMass = 1 / body_.lumpedMass()[place.node], trace = own[0] + own[1] + own[2];
    // Rounded to nearest; what that loses is added to the diagonal.
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j) {
        const int at = Symmetric3<double>::index(i, j);
        const double entry = own[at] + (i == j ? weightRounding * trace : 0);
        parts.weight[at][place.lane] = static_cast<float>(
            inverseMass *
            (heldAnywhere ? freeFactor(body_, place.node, i) * freeFactor(body_, place.node, j) * entry : entry));
      }
    parts.geometric[place.lane] =
        static_cast<float>(std::min(inverseMass * own[6] * (1 + weightRounding), 2 * boundOfUnknown));
    parts.laplacian[place.lane] = static_cast<float>(inverseMass * own[7] * (1 + weightRounding));
  }
  group.seenNegative = negative;
  const Matrix3<double> mean = (1 / group.count) * ofFirst;
  const Matrix3<P> meanOfAll = broadcast(mean);
  P apart2(0.0);
  for (const Matrix3<P>* own = all.data(); own != F; ++own) {
    const Matrix3<P> off = *own - meanOfAll;
    apart2 = math::max(apart2, innerProduct(off, off));
  }
  std::copy_n(mean.m, 9, group.mean);
  group.apart = 0;
  for (int lane = 0; lane < lanes; ++lane) group.apart = std::max(group.apart, std::sqrt(apart2[lane]));
  const Matrix3<double> back = inverse(ofFirst);
  std::copy_n(back.m, 9, group.inverse);
  // The motion goes on as it went up to here.
  const Matrix3<double> last = matrixOf(last_.data() + 9 * g), one = Matrix3<double>::identity();
  setNext(g, (flags_[g] & BatchMotion::still) != 0 ? one : nextOf(g) * inverse(last), true);
  std::copy_n(one.m, 9, last_.data() + 9 * g);
  motions_[g] = {1, 0, true, {}};
  std::copy_n(one.m, 9, motions_[g].matrix);
  group.spread = spreadOf(group.drift.kappa);
  group.delta = group.summedAt = 0;
  group.referenceAt = states_;
}

Matrix3<double> RestBound::nextOf(std::int32_t g) const {
  return (1 / unitOf(flags_[g])) * matrixOf(next_.data() + 9 * g);
}

void RestBound::setNext(std::int32_t g, Matrix3<double> motion, bool summed) {
  const Group& group = groups_[g];
  const Matrix3<double> one = Matrix3<double>::identity();
  const bool stretches = rest_[group.block].stretches;
  if (group.follows)
    for (int i = 0; i < 9; ++i)
      if (i % 4 != 0) motion.m[i] = 0;
  if (!stretches) motion = group.follows ? one : nearRotation(motion);
  const bool still = !(distance(motion, one) > policy_.still && distance(motion, one) < 1);
  if (still) motion = one;
  flags_[g] = static_cast<std::uint8_t>((still ? BatchMotion::still : BatchMotion::summed) |
                                        (summed ? BatchMotion::summed : 0) | (group.rests ? BatchMotion::rest : 0));
  for (int i = 0; i < 9; ++i) next_[9 * g + i] = static_cast<float>(unitOf(flags_[g]) * motion.m[i]);
}

void RestBound::see(NodeVectorsView x, const Group& group, bool all) {
  const ElementBlock& block = *body_.blocks()[group.block];
  AlignedVector<double> F(static_cast<std::size_t>(9 * rest_[group.block].gradients * lanes));
  for (std::int32_t batch = group.begin; batch < group.end; ++batch) {
    const std::int32_t* elements = block.layout().elements.data() + static_cast<std::ptrdiff_t>(batch) * lanes;
    if (elements[0] < 0 || !(all || compressed_[group.block][batch] != 0)) continue;
    compressed_[group.block][batch] |= 1;
    TangentDrift drift[lanes];
    block.deformationOf(elements, x.data(), F.data(), drift);
    for (int lane = 0; lane < lanes && elements[lane] >= 0; ++lane)
      seen_.push_back({{group.block, elements[lane]}, drift[lane].determinant, drift[lane].law.negative});
  }
}

void RestBound::measure(NodeVectorsView x, StepEvaluation* evaluation) {
  class Measure final : public PatchVisitor {
   public:
    explicit Measure(RestBound& bound) : bound_(bound) {}
    void visitPatch(std::size_t block, const PatchPass& pass) override {
      const BatchMotion motion{bound_.next_.data(),
                               bound_.flags_.data(),
                               bound_.groupOfBatch_[block].data(),
                               bound_.reference_[block].data(),
                               ValidityBalls::entryUnit,
                               bound_.rest_[block].gradients,
                               bound_.measured_.data()};
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
  std::fill(measured_.begin(), measured_.end(), 0.0F);
  body_.evaluate(x, asked, workspace_);
  asked.visitor = nullptr;
}

double RestBound::stressRisen(const Group& group, const Matrix3<double>& G, double delta) const {
  const Rest& rest = rest_[group.block];
  const Matrix3<double> mean = matrixOf(group.mean), one = Matrix3<double>::identity();
  const Matrix3<double> square = transposeTimes(G, G) - one, of = 0.5 * transposeTimes(mean, square * mean);
  Symmetric3<double> strain;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) strain(i, j) = of(i, j);
  const double ofMean = largestStretch(mean), off = std::sqrt(innerProduct(square, square)),
               ofRest = 0.5 * off * group.apart * (2 * ofMean + group.apart) +
                        delta * (largestStretch(G) * (ofMean + group.apart) + 0.5 * delta);
  const double modulus = stressModulus(rest.lambda, rest.twoMu);
  return rest.lambda * strain.trace() + rest.twoMu * eigenvalueBounds(strain).high() + modulus * ofRest +
         boundRounding * (rest.lambda + rest.twoMu);
}

bool RestBound::follow(std::int32_t g) {
  Group& group = groups_[g];
  Motion& motion = motions_[g];
  const Rest& rest = rest_[group.block];
  const float* const measured = measured_.data() + BatchMotion::sizeOfGroup * g;
  float farthest2 = 0, all = 0;
  for (int lane = 0; lane < lanes; ++lane) {
    farthest2 = std::max(farthest2, measured[lane]);
    all += measured[lane];
  }
  if (!std::isfinite(all)) return false;
  const bool still = (flags_[g] & BatchMotion::still) != 0;
  Matrix3<double> G = nextOf(g);
  // How far G is from a rotation.
  const double off = still ? 0 : distance(transposeTimes(G, G), Matrix3<double>::identity()),
               stretch = std::sqrt(1 + off);
  double delta = std::sqrt(static_cast<double>(farthest2)) +
                 (1 + stretch) * (group.rounding + BatchMotion::motionRounding * group.size);
  const TangentDriftCoefficients<double>& drift = group.drift;
  const double spread = group.spread, eta = spread * delta;
  const auto quadratic = [&](double t) {
    return drift.kappa * t * (t + (spread > 0 ? 1 / spread : 0)) +
           t * (spread * drift.negative + drift.linear + t * drift.quadratic);
  };
  if (rest.stretches) {
    motion.added = quadratic(delta) + std::max(0.0, stressRisen(group, G, delta) + std::min(0.0, group.stress));
  } else {
    delta += off * group.size;
    if (!still) G = polishedRotation(G);
    motion.added = off <= turnRounding && group.uneven + delta <= drift.radius
                       ? quadratic(group.uneven + delta) - quadratic(group.uneven)
                       : unknown;
  }
  // Beyond twice their size gradients err by more.
  if (!(motion.added < unknown && stretch <= 2)) motion.added = unknown;
  motion.growth = motion.added < unknown ? 1 + eta : 0;
  motion.still = still;
  const double root = std::sqrt(motion.growth);
  for (int i = 0; i < 9; ++i) motion.matrix[i] = root * G.m[i];
  group.delta = delta;
  if ((flags_[g] & BatchMotion::summed) == 0) {
    // It may have begun to move.
    if (delta > group.summedAt + policy_.still || (g + states_ + 1) % policy_.turns == 0)
      flags_[g] |= BatchMotion::summed;
    return true;
  }
  Matrix3<double> sum = Matrix3<double>::zero();
  for (int i = 0; i < 9; ++i)
    for (int lane = 0; lane < lanes; ++lane) sum.m[i] += measured[(i + 1) * lanes + lane];
  // The motion goes on as it went from the last state to this one.
  const Matrix3<double> now = sum * matrixOf(group.inverse), last = matrixOf(last_.data() + 9 * g);
  std::copy_n(now.m, 9, last_.data() + 9 * g);
  setNext(g, still ? now : 2.0 * now - last, (g + states_ + 1) % policy_.turns == 0);
  group.summedAt = delta;
  return true;
}

double RestBound::movedBound(const Region& region) const {
  if (region.boundedAt < 0) return infinity;
  if (!region.still) return turnedBound(region);
  double growth = 1, added = 0;
  for (std::size_t k = 0; k < region.around.size(); ++k) {
    const Motion &now = motions_[region.around[k]], &then = region.base[k];
    if (!now.still) return turnedBound(region);
    growth = std::max(growth, now.growth * then.growth);
    added = std::max(added, now.added - then.added);
  }
  return growth * region.weight + added * region.laplacian;
}

double RestBound::turnedBound(const Region& region) const {
  thread_local std::vector<Matrix3<double>> motions;
  Matrix3<double> mean = Matrix3<double>::zero();
  const std::size_t count = region.around.size();
  motions.resize(count);
  double apart2 = 0, added = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const Motion& now = motions_[region.around[k]];
    motions[k] = matrixOf(now.matrix) * matrixOf(region.base[k].matrix);
    mean = mean + motions[k];
    added = std::max(added, now.added - region.base[k].added);
  }
  mean = (1.0 / static_cast<double>(count)) * mean;
  for (std::size_t k = 0; k < count; ++k) {
    const Matrix3<double> off = motions[k] - mean;
    apart2 = std::max(apart2, innerProduct(off, off));
  }
  const double stretch2 = eigenvalueBounds(productWithTranspose(mean)).high();
  const double bound = std::max(1.0, stretch2) * region.weight +
                       2 * std::sqrt(apart2 * stretch2 * region.weight * region.trace) + apart2 * region.trace +
                       added * region.laplacian;
  return bound >= 0 ? bound : infinity;  // of a motion of which nothing was known
}

void RestBound::followDiscreteForces(NodeVectorsView x) {
  const DiscreteForces* discrete = body_.discreteForces();
  if (!discrete) return;
  std::fill(discrete_.begin(), discrete_.end(), 0.0);
  discrete->majorants(x, false, needed_, neededAt_);
  for (const std::int32_t place : neededAt_) {
    const std::int32_t node = discrete->nodes()[place], r = regionOfNode_[node];
    if (r < 0) continue;
    needed_[place] = freePart(body_, node, needed_[place]);
    // The trace is at least the highest eigenvalue.
    discrete_[r] = std::max(discrete_[r], needed_[place].trace() / body_.lumpedMass()[node]);
  }
}

double RestBound::boundNodes(Region& region) {
  const DiscreteForces* discrete = body_.discreteForces();
  P highest(0.0), most(0.0), together(0.0);
  for (std::int32_t pack = region.packBegin; pack < region.packEnd; ++pack) {
    Symmetric3<P> sum = Symmetric3<P>::diagonal(P(0.0));
    P rest(0.0);
    for (std::int32_t k = packBegin_[pack]; k < packBegin_[pack + 1]; ++k) {
      const PackOfParts& parts = parts_[k];
      Symmetric3<P> weight;
      for (int c = 0; c < 6; ++c) weight.m[c] = packOf(parts.weight[c]);
      P growth, added;
      bool still = true;
      for (int lane = 0; lane < lanes; ++lane) {
        const Motion& motion = motions_[parts.group[lane]];
        growth.set(lane, motion.growth);
        added.set(lane, motion.added);
        still &= motion.still;
      }
      if (still) {
        sum = sum + growth * weight;
      } else {
        alignas(64) double gathered[9][lanes];
        for (int lane = 0; lane < lanes; ++lane)
          for (int i = 0; i < 9; ++i) gathered[i][lane] = motions_[parts.group[lane]].matrix[i];
        Matrix3<P> matrix;
        for (int i = 0; i < 9; ++i) matrix.m[i] = P::load(gathered[i]);
        sum = sum + movedWeight(matrix, weight);
      }
      rest += packOf(parts.geometric) + added * packOf(parts.laplacian);
    }
    const P trace = sum.trace();
    most = math::max(most, trace);
    highest = math::max(highest, eigenvaluesOf(sum).largest + P(relativeRounding) * trace + rest);
    statistics_.nodes += lanes;
    bool touched = false;
    for (int lane = 0; discrete && lane < lanes; ++lane) {
      const std::int32_t node = parts_[packBegin_[pack]].node[lane];
      const std::int32_t place = node < 0 ? -1 : discrete->placeOf(node);
      if (place < 0 || needed_[place].isZero(0)) continue;
      touched = true;
      for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j)
          sum(i, j).set(lane, sum(i, j)[lane] + needed_[place](i, j) / body_.lumpedMass()[node]);
    }
    if (touched) together = math::max(together, eigenvaluesOf(sum).largest + P(relativeRounding) * sum.trace() + rest);
  }
  region.weight = region.trace = 0;
  double bound = 0;
  for (int lane = 0; lane < lanes; ++lane) {
    region.weight = std::max(region.weight, highest[lane]);
    region.trace = std::max(region.trace, most[lane]);
    bound = std::max({bound, highest[lane], together[lane]});
  }
  region.boundedAt = states_;
  region.base.resize(region.around.size());
  region.still = true;
  for (std::size_t k = 0; k < region.around.size(); ++k) {
    const Motion& now = motions_[region.around[k]];
    const Matrix3<double> back = inverse(matrixOf(now.matrix));
    region.base[k] = {1 / now.growth, now.added, now.still, {}};
    std::copy_n(back.m, 9, region.base[k].matrix);
    region.still &= now.still;
  }
  return bound;
}

double RestBound::lowestBound(NodeVectorsView x, double enough, std::int64_t most) {
  parallelFor(
      0, static_cast<std::int64_t>(regions_.size()), body_.threads(),
      [&](std::int64_t r) { bounds_[r] = movedBound(regions_[r]) + discrete_[r]; }, regionsOfThread);
  std::vector<std::pair<double, std::int32_t>> heap;  // the highest first
  for (std::size_t r = 0; r < regions_.size(); ++r) heap.emplace_back(bounds_[r], static_cast<std::int32_t>(r));
  std::make_heap(heap.begin(), heap.end());
  const auto push = [&](std::int32_t r, double bound) {
    bounds_[r] = bound;
    heap.emplace_back(bound, r);
    std::push_heap(heap.begin(), heap.end());
  };
  for (double known = 0; !heap.empty();) {
    const auto [bound, r] = heap.front();
    if (bound != bounds_[r]) {
      std::pop_heap(heap.begin(), heap.end());
      heap.pop_back();
      continue;
    }
    Region& top = regions_[r];
    const bool bounded = top.boundedAt == states_;
    node_ = top.node;
    // What nothing is known of has a new reference whatever that takes.
    const bool spent = statistics_.elements >= most && bound < boundOfUnknown;
    if (bound <= enough || (spent && !bounded && bound <= (1 + policy_.same) * known)) return bound;
    if (!bounded) {
      std::pop_heap(heap.begin(), heap.end());
      heap.pop_back();
      push(r, boundNodes(top));
      known = std::max(known, bounds_[r]);
      continue;
    }
    const bool again = top.referredAt == states_;
    top.lowest = again ? bound : std::min(top.lowest, bound);
    if (spent || !(again || bound > (1 + policy_.risen) * top.lowest)) return bound;
    double uneven = 0;
    for (const std::int32_t g : top.around) uneven = std::max(uneven, groups_[g].delta);
    bool referred = false;
    for (const std::int32_t g : top.around) {
      const Group& group = groups_[g];
      if (group.referenceAt == states_ || !(group.delta >= policy_.uneven * uneven)) continue;
      refer(x, g);
      referred = true;
      statistics_.elements += lanes * (group.end - group.begin);
      see(x, group, false);
      for (const std::int32_t other : regionsOf_[g]) {
        regions_[other].boundedAt = -1;
        if (bounds_[other] < infinity) push(other, infinity);
      }
    }
    if (!referred) return bound;
    top.referredAt = states_;
    known = 0;
  }
  return 0;
}

bool RestBound::isToBeSeen(std::int32_t g) const {
  const Group& group = groups_[g];
  if (!(group.delta < 0.5 * group.leastStretch)) return true;
  if ((g + states_) % policy_.turns != 0 || (flags_[g] & BatchMotion::summed) == 0) return false;
  const Rest& rest = rest_[group.block];
  double negative = 0;
  const Matrix3<double> mean = (1 / group.count) * (matrixOf(last_.data() + 9 * g) * inverse(matrixOf(group.inverse)));
  if (rest.stretches) {
    const EigenvalueBounds<double> stress =
        eigenvalueBounds(secondStressOf(body_.blocks()[group.block]->material().restModuli(), mean));
    negative = stress.half - stress.mean;
  } else {
    NativePack stretches[3];
    Symmetric3<NativePack> square;
    const Matrix3<double> C = transposeTimes(mean, mean);
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j) square(i, j) = NativePack(C(i, j));
    const Eigenvalues own = eigenvaluesOf(square);
    stretches[0] = math::sqrt(math::max(own.least, NativePack(0.0)));
    stretches[1] = math::sqrt(math::max(own.middle, NativePack(0.0)));
    stretches[2] = math::sqrt(own.largest);
    PrincipalTangent<NativePack> tangent;
    body_.blocks()[group.block]->principalTangentAt(stretches, tangent);
    negative = tangent.drift.negative[0];
  }
  return negative >
         policy_.compressionGrowth * group.seenNegative + policy_.slightCompression * (rest.lambda + rest.twoMu);
}

UpperBound RestBound::update(NodeVectorsView x, StepEvaluation* evaluation, double enough, std::int64_t most) {
  seen_.clear();
  statistics_ = {};
  if (!started()) {
    if (evaluation) body_.evaluate(x, *evaluation, workspace_);
    return {infinity};
  }
  if (groupOfBatch_.empty()) index();
  ++states_;
  measure(x, evaluation);
  std::vector<std::uint8_t> finite(groups_.size()), toBeSeen(groups_.size());
  parallelFor(
      0, static_cast<std::int64_t>(groups_.size()), body_.threads(),
      [&](std::int64_t g) {
        finite[g] = follow(static_cast<std::int32_t>(g)) ? 1 : 0;
        toBeSeen[g] = finite[g] != 0 && isToBeSeen(static_cast<std::int32_t>(g)) ? 1 : 0;
      },
      groupsOfThread);
  if (std::find(finite.begin(), finite.end(), 0) != finite.end()) return {std::numeric_limits<double>::quiet_NaN()};
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    if (toBeSeen[g] == 0) continue;
    const std::size_t first = seen_.size();
    see(x, groups_[g], true);
    for (std::size_t k = first; k < seen_.size(); ++k)
      groups_[g].seenNegative = std::max(groups_[g].seenNegative, seen_[k].negative);
  }
  followDiscreteForces(x);
  const double bound = (1 + boundRounding) * lowestBound(x, enough, most);
  return {bound < boundOfUnknown ? bound : infinity};
}

Eigen::Matrix3d RestBound::majorantAt(std::int32_t node) const {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const PackOfParts& parts : parts_)
    for (int lane = 0; lane < lanes; ++lane) {
      if (parts.node[lane] != node) continue;
      const Motion& motion = motions_[parts.group[lane]];
      const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> matrix(motion.matrix);
      Eigen::Matrix3d weight;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) weight(i, j) = parts.weight[Symmetric3<double>::index(i, j)][lane];
      sum += matrix * weight * matrix.transpose();
      sum.diagonal().array() += parts.geometric[lane] + motion.added * parts.laplacian[lane];
    }
  if (const DiscreteForces* discrete = body_.discreteForces())
    if (const std::int32_t place = discrete->placeOf(node); place >= 0)
      sum += needed_[place] / body_.lumpedMass()[node];
  return sum;
}

}  // namespace ringwatch

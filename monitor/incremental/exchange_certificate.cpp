#include <ringwatch/monitor/incremental/exchange_certificate.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/rounding.h>
#include <ringwatch/base/sort_unique.h>
#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/body/nodes_of.h>
#include <ringwatch/materials/rotation.h>
#include <ringwatch/monitor/bounds/scaled_tangent.h>
#include <ringwatch/monitor/small/packed_cholesky.h>

namespace ringwatch {
namespace {

/// |R Rᵀ - 1| of frames, at most: far less than what sums are stated above their eigenvalues by (statedRounding).
constexpr double orthogonality = 1e-12;

/// What a tangent can have become when the deformation gradients have moved by at most `distance` (Theorem 75):
///   K <= (1 + share) K0 + along Σ w BᵀB.
struct Drift {
  double share, along;  // 1, Pa
};
Drift driftOver(const TangentDriftCoefficients<double>& law, double distance) {
  const double share = law.kappa > 0 ? distance : 0, d2 = distance * distance;
  return {share, share * law.negative + law.kappa * (distance + d2) + law.linear * distance + law.quadratic * d2};
}
/// The distance up to which the law's coefficients and the element's inversion allow it: 0 where nothing is known.
double within(const TangentDrift& drift, double distance) {
  return std::max(0.0, std::min({distance, drift.law.radius, drift.inversionDistance}));
}

/// Tangents of elements, one a lane, what they can become over distances, and their rounding, N/m.
struct TangentsWithRoom {
  TangentsWithRoom(const ElementBlock& block)
      : n(block.nodesPerElement()),
        K(static_cast<std::size_t>(9 * n * n)),
        L(static_cast<std::size_t>(n * n)),
        F(9 * block.rule().points.size() * lanes) {}
  void compute(const ElementBlock& block, const std::int32_t* elements, const double* x) {
    block.laplacianOf(elements, reinterpret_cast<double*>(L.data()), reinterpret_cast<double*>(ofL));
    block.deformationOf(elements, x, F.data(), drift);
  }
  void add(NativePack* tangent, NativePack* rounding, const NativePack& share, const NativePack& along) const {
    const int size = 3 * n;
    for (int i = 0; i < size * size; ++i) tangent[i] += share * tangent[i];
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b)
        for (int c = 0; c < 3; ++c) tangent[(3 * a + c) * size + 3 * b + c] += along * L[a * n + b];
    for (int a = 0; a < n; ++a) rounding[a] += share * rounding[a] + along * ofL[a];
  }

  int n;
  AlignedVector<NativePack> K, L;
  NativePack ofK[maxElementNodes], ofL[maxElementNodes];
  std::vector<double> F;
  TangentDrift drift[lanes];
};

/// f of K + f C of the elements.
double dampingFactorOf(const Body& body) { return body.elementDamping() ? body.elementDamping()->factor() : 0; }

std::size_t triangle(int nodes) { return static_cast<std::size_t>(3 * nodes * (3 * nodes + 1) / 2); }

}  // namespace

ExchangeCertificate::ExchangeCertificate(const Body& body, const NodalBound& weights, const ExchangeRoomPolicy& policy)
    : body_(body), weights_(weights), policy_(policy) {}

void ExchangeCertificate::makeBlocks() {
  if (!blocks_.empty()) return;
  for (const auto& block : body_.blocks()) {
    const std::size_t places = block->layout().elements.size();
    blocks_.push_back({ValidityBalls(*block), std::vector<std::int16_t>(places * triangle(block->nodesPerElement()))});
    const DampedBlock* damped = body_.elementDamping() ? body_.elementDamping()->blocks()[blocks_.size() - 1] : nullptr;
    if (!damped || !damped->dependsOnRates()) continue;
    blocks_.back().rates = damped;
    blocks_.back().counted.assign(places, 0);
  }
}

std::int64_t ExchangeCertificate::bytes(const Body& body) {
  std::int64_t bytes = exchangeBoundBytes(body);
  for (const auto& block : body.blocks())
    bytes +=
        static_cast<std::int64_t>(block->layout().elements.size()) *
        static_cast<std::int64_t>(triangle(block->nodesPerElement()) * (sizeof(std::int16_t) + sizeof(std::int32_t)) +
                                  18 * block->rule().points.size());
  if (const DiscreteForces* discrete = body.discreteForces())
    bytes += static_cast<std::int64_t>(4 * discrete->nodes().size() * sizeof(Eigen::Matrix3d));
  return bytes;
}

std::size_t ExchangeCertificate::placeOf(ElementRef e) const {
  return static_cast<std::size_t>(body_.blocks()[e.block]->layout().batchOfElement[e.element]);
}

ExchangeShares ExchangeCertificate::allShares() const {
  ExchangeShares shares{ExchangeShares::narrow, {certifiedEigenvalue()}, unit_ * scale_, {}};
  const double unit = std::ldexp(unit_, -ExchangeShares::narrow);
  for (std::int32_t b = 0; b < static_cast<std::int32_t>(blocks_.size()); ++b) {
    const int size = 3 * body_.blocks()[b]->nodesPerElement();
    std::vector<double> G(static_cast<std::size_t>(size * size));
    for (std::int32_t e = 0; e < body_.blocks()[b]->elementCount(); ++e) {
      loadShare({b, e}, G.data());
      for (int i = 0; i < size; ++i)
        for (int j = 0; j <= i; ++j)
          shares.entries.push_back(static_cast<std::int32_t>(std::lrint(G[i * size + j] / unit)));
    }
  }
  return shares;
}

void ExchangeCertificate::store(const ExchangeShares& shares) {
  const std::int32_t* entry = shares.entries.data();
  const DiscreteForces* discrete = body_.discreteForces();
  sums_.assign(discrete ? discrete->nodes().size() : 0, Eigen::Matrix3d::Zero());
  for (std::int32_t b = 0; b < static_cast<std::int32_t>(blocks_.size()); ++b) {
    const ElementBlock& block = *body_.blocks()[b];
    const std::size_t size = triangle(block.nodesPerElement());
    for (std::int32_t e = 0; e < block.elementCount(); ++e) {
      const std::size_t place = placeOf({b, e});
      std::int16_t* to = blocks_[b].entries.data() + place / lanes * size * lanes + place % lanes;
      if (discrete) {
        const auto nodes = block.nodesOf(e);
        for (std::size_t a = 0; a < nodes.size(); ++a) {
          const std::int32_t at = discrete->placeOf(nodes[a]);
          if (at < 0) continue;
          for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j <= i; ++j) {
              const std::size_t row = 3 * a + i, index = row * (row + 1) / 2 + 3 * a + j;
              const double value = shares.unitOfEntries() * entry[index];
              sums_[at](i, j) += value;
              if (j < i) sums_[at](j, i) += value;
            }
        }
      }
      for (std::size_t k = 0; k < size; ++k) to[k * lanes] = static_cast<std::int16_t>(*entry++);
    }
  }
  sigma_ = shares.upper.value;
  unit_ = shares.unit;
  scale_ = 1;
}

ExchangeWork ExchangeCertificate::share(NodeVectorsView x, NodeVectorsView mode, LowerBound lower, int mostIterations,
                                        double wanted) {
  const bool goesOn = hasShares() && version_ == body_.version();
  room_ = policy_.room;
  const ExchangeRoom room = [&](std::size_t b, const std::int32_t* elements, NativePack* K, NativePack* T) {
    const ElementBlock& block = *body_.blocks()[b];
    TangentsWithRoom with(block);
    with.compute(block, elements, x.data());
    NativePack share(0.0), along(0.0);
    for (int lane = 0; lane < lanes; ++lane) {
      if (elements[lane] < 0) continue;
      const Drift drift = driftOver(with.drift[lane].law, within(with.drift[lane], room_));
      share.set(lane, drift.share);
      along.set(lane, drift.along);
    }
    with.add(K, T, share, along);
  };
  // The room's share of the eigenvalue, by the form of a guess of the top mode.
  double without = 0, with = 0;
  for (std::size_t b = 0; b < body_.blocks().size(); ++b) {
    const ElementBlock& block = *body_.blocks()[b];
    const int n = block.nodesPerElement(), size = 3 * n;
    const std::int32_t batches = block.layout().batchCount();
    std::vector<double> own(2 * static_cast<std::size_t>(batches));
    parallelFor(
        0, batches, body_.threads(),
        [&](std::int64_t batch) {
          const std::int32_t* elements = block.layout().elements.data() + batch * lanes;
          AlignedVector<NativePack> K(static_cast<std::size_t>(size * size));
          NativePack T[maxElementNodes];
          block.tangentOf(elements, x.data(), reinterpret_cast<double*>(K.data()), reinterpret_cast<double*>(T));
          const auto form = [&] {
            double sum = 0;
            for (int lane = 0; lane < lanes; ++lane) {
              if (elements[lane] < 0) continue;
              const auto nodes = block.nodesOf(elements[lane]);
              for (int i = 0; i < size; ++i)
                for (int j = 0; j < size; ++j)
                  sum += K[i * size + j][lane] * mode(i % 3, nodes[i / 3]) * mode(j % 3, nodes[j / 3]);
            }
            return sum;
          };
          own[2 * batch] = form();
          room(b, elements, K.data(), T);
          own[2 * batch + 1] = form();
        },
        16);
    for (std::int32_t batch = 0; batch < batches; ++batch) {
      without += own[2 * batch];
      with += own[2 * batch + 1];
    }
  }
  if (const DiscreteForces* discrete = body_.discreteForces()) {
    const double own = discrete->form(x, mode);
    without += own;
    with += own;
  }
  // It is linear in the room, but for a little.
  const double cost = without > 0 && std::isfinite(with / without) ? std::max(0.0, with / without - 1) : 0;
  room_ = policy_.room * std::min(1.0, policy_.mostCost / std::max(cost, 1e-6));
  double narrow = policy_.narrow, aim = policy_.aim;
  if (const double left = wanted * (1 - policy_.margin) / (policy_.narrowForProof * lower.value) - 1;
      left * policy_.room > room_ * cost) {
    room_ = std::min(policy_.room * left / std::max(cost, 1e-6), policy_.mostRoom);
    narrow = wanted * (1 - policy_.margin) / (lower.value * (1 + cost * room_ / policy_.room));
    aim = std::sqrt(narrow);
  }
  const double withRoom = lower.value * (1 + cost * room_ / policy_.room);
  ExchangeShares present;
  std::optional<NodalBound> weights;
  if (goesOn)
    present = allShares();
  else
    weights.emplace(weights_).evaluate(x, 0);  // along a run values are not kept
  ExchangeWork work{};
  const std::vector<Eigen::Matrix3d> majorants = majorantsToCome(x, withRoom);
  const ExchangeShares shares = roomyExchangeShares(
      body_, x, weights ? *weights : weights_, goesOn ? &present : nullptr, room,
      body_.discreteForces() ? &majorants : nullptr, aim * withRoom, narrow * withRoom, mostIterations, work);
  beside_ = 0;
  holds_ = std::isfinite(shares.upper.value);
  version_ = body_.version();
  dampingFactor_ = dampingFactorOf(body_);
  if (!holds_) {
    unit_ = 0;
    return work;
  }
  makeBlocks();
  store(shares);
  turned_ = false;
  frames_.assign(body_.nodeCount(), Eigen::Matrix3d::Identity());
  std::vector<std::int32_t> nodes(body_.nodeCount());
  std::iota(nodes.begin(), nodes.end(), 0);
  surroundings_ = surroundingsOf(x, nodes);
  std::vector<ElementRef> all;
  for (std::int32_t b = 0; b < static_cast<std::int32_t>(blocks_.size()); ++b)
    for (std::int32_t e = 0; e < body_.blocks()[b]->elementCount(); ++e) all.push_back({b, e});
  factored_ = 0;
  seenElements_.clear();
  // A share that is not definite could not be raised.
  const double raise = sharesAreDefinite() ? renew(x, all, ExchangeRoomPolicy::parts[0]) : infinity;
  holds_ = std::isfinite(raise);
  scale_ = holds_ ? raise : 1;
  seenElements_ = {};  // of all
  addDiscreteForces(x);
  return work;
}

void ExchangeCertificate::follow(NodeVectorsView x, double mostRaise, double leastPart, StepEvaluation* evaluation) {
  factored_ = 0;
  workOfTests_ = 0;
  beside_ = 0;
  seenElements_.clear();
  if (holds_ && (version_ != body_.version() || dampingFactor_ != dampingFactorOf(body_))) {
    holds_ = false;
    unit_ = 0;
  }
  if (!holds_) {
    if (evaluation) body_.evaluate(x, *evaluation, outsideBalls_.workspace());
    return;
  }
  std::vector<ElementRef> outside = outsideBalls_.find(body_, blocks_, x, evaluation);
  for (const BlockData& data : blocks_) workOfTests_ += data.balls.workOfCheck();
  if (!outside.empty()) proveAnew(x, outside, mostRaise, leastPart);
  addDiscreteForces(x);
}

void ExchangeCertificate::proveAnew(NodeVectorsView x, std::vector<ElementRef>& outside, double mostRaise,
                                    double leastPart) {
  double raise = renew(x, outside, leastPart);
  if (raise > 1) {
    // What has turned is proven in its own frames, and all others at the nodes with it.
    const std::vector<ElementRef> around = turnFrames(x, outside);
    if (!around.empty()) {
      outside.insert(outside.end(), around.begin(), around.end());
      sortUnique(outside);
      raise = renew(x, outside, leastPart);
    }
  }
  holds_ = raise <= mostRaise;
  if (holds_) scale_ *= raise;
}

void ExchangeCertificate::addDiscreteForces(NodeVectorsView x) {
  const DiscreteForces* discrete = body_.discreteForces();
  if (!holds_ || !discrete) return;
  discrete->majorants(x, false, majorants_, majorantsAt_);
  seen_.resize(majorants_.size(), Eigen::Matrix3d::Zero());
  for (const std::int32_t place : majorantsAt_) {
    const std::int32_t node = discrete->nodes()[place];
    if (majorants_[place].trace() > seen_[place].trace()) seen_[place] = majorants_[place];
    const Eigen::Matrix3d& R = frames_[node];
    const Eigen::Matrix3d own = scale_ * (turned_ ? Eigen::Matrix3d(R * sums_[place] * R.transpose()) : sums_[place]),
                          sum = own + freePart(body_, node, majorants_[place] / body_.lumpedMass()[node]);
    // Most are below what is certified anyway: pivots tell that at less cost.
    const double allowed = certifiedEigenvalue() * (1 - statedRounding);
    if (const Eigen::LLT<Eigen::Matrix3d> below(allowed * Eigen::Matrix3d::Identity() - sum);
        below.info() == Eigen::Success && std::isfinite(sum.sum()))
      continue;
    const double highest = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(sum, Eigen::EigenvaluesOnly).eigenvalues()[2];
    beside_ = std::max(beside_, highest * (1 + statedRounding));
    // A NaN must not be lost.
    if (!std::isfinite(highest)) holds_ = false;
  }
}

std::vector<Eigen::Matrix3d> ExchangeCertificate::majorantsToCome(NodeVectorsView x, double eigenvalue) {
  std::vector<Eigen::Matrix3d> majorants;
  const DiscreteForces* discrete = body_.discreteForces();
  if (!discrete) return majorants;
  discrete->majorants(x, true, majorants);
  // What is near may come before other shares are made. A node's mass tells how far its neighbours are.
  std::vector<double> further;
  const double density = body_.totalMass() / body_.volume();
  for (const std::int32_t node : discrete->nodes())
    further.push_back(policy_.near * std::cbrt(body_.lumpedMass()[node] / density));
  std::vector<Eigen::Matrix3d> toCome;
  discrete->majorantsToCome(x, further, toCome);
  if (seen_.size() != majorants.size()) seen_ = majorants;
  for (std::size_t k = 0; k < majorants.size(); ++k) {
    const Eigen::Matrix3d larger = seen_[k].trace() > toCome[k].trace() ? seen_[k] : toCome[k];
    seen_[k] = majorants[k];
    const double most = policy_.mostReserved * eigenvalue * body_.lumpedMass()[discrete->nodes()[k]];
    const double trace = larger.trace(), reserved = std::min(trace, most);
    if (reserved > majorants[k].trace()) majorants[k] = reserved / trace * larger;
  }
  return majorants;
}

bool ExchangeCertificate::sharesAreDefinite() const {
  for (std::int32_t b = 0; b < static_cast<std::int32_t>(blocks_.size()); ++b) {
    const ElementBlock& block = *body_.blocks()[b];
    const int size = 3 * block.nodesPerElement();
    const std::int32_t batches = block.layout().batchCount();
    std::vector<std::uint8_t> definite(static_cast<std::size_t>(batches));
    parallelFor(
        0, batches, body_.threads(),
        [&](std::int64_t batch) {
          const std::int32_t* elements = block.layout().elements.data() + batch * lanes;
          AlignedVector<NativePack> G(static_cast<std::size_t>(size * size));
          std::vector<double> own(G.size());
          for (int lane = 0; lane < lanes; ++lane) {
            const std::int32_t e = elements[lane] < 0 ? elements[0] : elements[lane];
            loadShare({b, e}, own.data());
            double trace = 0;
            for (int i = 0; i < size; ++i) {
              if (freeFactor(body_, block.nodesOf(e)[i / 3], i % 3) == 0) own[i * size + i] = sigma_;
              trace += own[i * size + i];
            }
            for (int i = 0; i < size; ++i) own[i * size + i] -= exchangeRounding * trace;
            for (std::size_t i = 0; i < own.size(); ++i) G[i].set(lane, own[i]);
          }
          definite[batch] = allOf(pivotsArePositive(G.data(), size) > NativePack(0.0));
        },
        8);
    if (std::find(definite.begin(), definite.end(), 0) != definite.end()) return false;
  }
  return true;
}

double ExchangeCertificate::renew(NodeVectorsView x, const std::vector<ElementRef>& elements, double leastPart) {
  std::vector<Proof> proofs;
  prove(x, elements, leastPart, proofs);
  factored_ += static_cast<std::int64_t>(elements.size());
  double raise = 1;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    raise = std::max(raise, proofs[i].raise);
    BlockData& data = blocks_[elements[i].block];
    const std::size_t place = placeOf(elements[i]);
    data.balls.setRadius(place, proofs[i].radius, proofs[i].fromStored);
    if (data.rates) data.counted[place] = data.rates->coefficient(place);
    seenElements_.push_back({elements[i], proofs[i].determinant, proofs[i].negative});
  }
  return raise;
}

void ExchangeCertificate::prove(NodeVectorsView x, const std::vector<ElementRef>& elements, double leastPart,
                                std::vector<Proof>& proofs) {
  proofs.assign(elements.size(), {});
  struct Group {
    std::int32_t block, element[lanes];
    std::size_t at[lanes];
    int count;
  };
  std::vector<Group> groups;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (groups.empty() || groups.back().count == lanes || groups.back().block != elements[i].block) {
      groups.push_back({elements[i].block, {}, {}, 0});
      std::fill(std::begin(groups.back().element), std::end(groups.back().element), -1);
    }
    Group& group = groups.back();
    group.element[group.count] = elements[i].element;
    group.at[group.count++] = i;
  }
  parallelFor(
      0, groups.size(), body_.threads(),
      [&](std::int64_t g) {
        Proof own[lanes];
        provePack(x, groups[g].block, groups[g].element, leastPart, own);
        for (int lane = 0; lane < groups[g].count; ++lane) proofs[groups[g].at[lane]] = own[lane];
      },
      8);
}

void ExchangeCertificate::loadShare(ElementRef e, double* G) const {
  const ElementBlock& block = *body_.blocks()[e.block];
  const int n = block.nodesPerElement(), size = 3 * n;
  const std::size_t place = placeOf(e), entries = triangle(n);
  const std::int16_t* from = blocks_[e.block].entries.data() + place / lanes * entries * lanes + place % lanes;
  const double unit = std::ldexp(unit_, -ExchangeShares::narrow);
  for (int i = 0; i < size; ++i)
    for (int j = 0; j <= i; ++j, from += lanes) G[i * size + j] = G[j * size + i] = unit * *from;
  if (!turned_) return;
  const auto nodes = block.nodesOf(e.element);
  Eigen::Matrix3d R[maxElementNodes];
  for (int a = 0; a < n; ++a) R[a] = frames_[nodes[a]];
  Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> all(G, size, size);
  for (int a = 0; a < n; ++a)
    for (int b = 0; b <= a; ++b) {
      const Eigen::Matrix3d own = all.block<3, 3>(3 * a, 3 * b), block3 = R[a] * own * R[b].transpose();
      all.block<3, 3>(3 * a, 3 * b) = block3;
      all.block<3, 3>(3 * b, 3 * a) = block3.transpose();
    }
}

void ExchangeCertificate::provePack(NodeVectorsView x, std::int32_t b, const std::int32_t* elements, double leastPart,
                                    Proof* proofs) {
  const ElementBlock& block = *body_.blocks()[b];
  const int n = block.nodesPerElement(), size = 3 * n;
  TangentsWithRoom with(block);
  with.compute(block, elements, x.data());
  block.tangentOf(elements, x.data(), reinterpret_cast<double*>(with.K.data()), reinterpret_cast<double*>(with.ofK));
  AlignedVector<NativePack> G(static_cast<std::size_t>(size * size)), A(G.size());
  NativePack scale[3 * maxElementNodes], held[3 * maxElementNodes], inverseMass[maxElementNodes];
  std::vector<double> own(G.size());
  for (int lane = 0; lane < lanes; ++lane) {
    const std::int32_t e = elements[lane] < 0 ? elements[0] : elements[lane];
    loadShare({b, e}, own.data());
    for (std::size_t i = 0; i < own.size(); ++i) G[i].set(lane, own[i] * scale_);
    const auto nodes = block.nodesOf(e);
    for (int a = 0; a < n; ++a) inverseMass[a].set(lane, 1 / body_.lumpedMass()[nodes[a]]);
    for (int i = 0; i < size; ++i) {
      const double free = freeFactor(body_, nodes[i / 3], i % 3);
      scale[i].set(lane, free / std::sqrt(body_.lumpedMass()[nodes[i / 3]]));
      // A constrained component leaves the problem: its row becomes that of a definite matrix.
      held[i].set(lane, free == 0 ? sigma_ : 0);
    }
  }
  // Whether raise G_e - (1 + share) A_e - along Q_e is definite, rounding included (Theorem 41).
  const auto definite = [&](const NativePack& raise, const NativePack& distance) {
    NativePack share(0.0), along(0.0);
    for (int lane = 0; lane < lanes; ++lane) {
      const Drift drift = driftOver(with.drift[lane].law, distance[lane]);
      share.set(lane, drift.share);
      along.set(lane, drift.along);
    }
    NativePack rounding(0.0), trace(0.0);
    for (int a = 0; a < n; ++a)
      rounding += ((NativePack(1.0) + share) * with.ofK[a] + along * with.ofL[a]) * inverseMass[a];
    for (int i = 0; i < size; ++i)
      for (int j = 0; j <= i; ++j) {
        NativePack tangent = (NativePack(1.0) + share) * with.K[i * size + j];
        if (i % 3 == j % 3) tangent += along * with.L[i / 3 * n + j / 3];
        const NativePack scaled = scale[i] * scale[j] * tangent;
        A[i * size + j] = raise * G[i * size + j] - scaled;
        if (i == j) trace += math::abs(raise * G[i * size + i]) + math::abs(scaled);
      }
    for (int i = 0; i < size; ++i)
      A[i * size + i] += held[i] - (rounding + NativePack(exchangeRounding) * (trace + held[i]));
    return pivotsArePositive(A.data(), size) > NativePack(0.0);
  };
  NativePack raise(infinity), distance(0.0);
  NativePack::Mask open = raise > NativePack(0.0);
  const auto attempt = [&](double by, double part) {
    if (!anyOf(open)) return;
    NativePack here(0.0);
    for (int lane = 0; lane < lanes; ++lane) here.set(lane, within(with.drift[lane], part * room_));
    const NativePack::Mask found = open & definite(NativePack(by), here);
    raise = select(found, NativePack(by), raise);
    distance = select(found, here, distance);
    open = open & ~found;
  };
  for (const double part : ExchangeRoomPolicy::parts)
    if (part > leastPart) attempt(1, part);
  attempt(1, leastPart);
  for (const double by : ExchangeRoomPolicy::raises) attempt(by, leastPart);
  const int points = static_cast<int>(block.rule().points.size());
  for (int lane = 0; lane < lanes; ++lane) {
    if (elements[lane] < 0) continue;
    const TangentDrift& drift = with.drift[lane];
    Proof& proof = proofs[lane];
    proof.raise = raise[lane];
    proof.determinant = drift.determinant;
    proof.negative = drift.law.negative;
    proof.fromStored =
        blocks_[b].balls.setReferenceGradient(placeOf({b, elements[lane]}), with.F.data(), points, lane) +
        drift.gradientRounding;
    const bool has = std::isfinite(proof.raise) && std::isfinite(proof.fromStored) && distance[lane] > 0;
    proof.radius = has ? distance[lane] * (1 - radiusRounding) : -1;
  }
}

std::vector<Eigen::Quaternionf> ExchangeCertificate::surroundingsOf(NodeVectorsView x,
                                                                    const std::vector<std::int32_t>& nodes) const {
  std::vector<Matrix3<double>> sums(nodes.size(), Matrix3<double>::zero());
  std::vector<std::int32_t> indexOf(body_.nodeCount(), -1);
  for (std::size_t k = 0; k < nodes.size(); ++k) indexOf[nodes[k]] = static_cast<std::int32_t>(k);
  const std::vector<ElementRef> elements = weights_.elementsAt(nodes);
  for (std::size_t first = 0; first < elements.size();) {
    const std::int32_t b = elements[first].block;
    const ElementBlock& block = *body_.blocks()[b];
    std::int32_t pack[lanes];
    int count = 0;
    for (; count < lanes && first < elements.size() && elements[first].block == b; ++first)
      pack[count++] = elements[first].element;
    for (int lane = count; lane < lanes; ++lane) pack[lane] = -1;
    std::vector<double> F(9 * block.rule().points.size() * lanes);
    TangentDrift drift[lanes];
    block.deformationOf(pack, x.data(), F.data(), drift);
    for (int lane = 0; lane < count; ++lane)
      for (const std::int32_t node : block.nodesOf(pack[lane])) {
        if (indexOf[node] < 0) continue;
        for (std::size_t q = 0; q < block.rule().points.size(); ++q)
          for (int i = 0; i < 9; ++i)
            sums[indexOf[node]].m[i] +=
                F[(q * 9 + static_cast<std::size_t>(i)) * lanes + static_cast<std::size_t>(lane)] /
                static_cast<double>(block.rule().points.size());
      }
  }
  std::vector<Eigen::Quaternionf> result(nodes.size());
  parallelFor(
      0, nodes.size(), body_.threads(),
      [&](std::int64_t k) {
        const Matrix3<double> R = closestRotation(sums[k]);
        Eigen::Matrix3d matrix;
        for (int i = 0; i < 9; ++i) matrix(i / 3, i % 3) = R.m[i];
        result[k] = Eigen::Quaterniond(matrix).cast<float>();
      },
      64);
  return result;
}

std::vector<ElementRef> ExchangeCertificate::turnFrames(NodeVectorsView x, const std::vector<ElementRef>& elements) {
  std::vector<std::int32_t> nodes = nodesOfElements(body_, elements);
  std::erase_if(nodes, [&](std::int32_t node) { return body_.constraints().freeComponents(node) < 3; });
  const std::vector<Eigen::Quaternionf> now = surroundingsOf(x, nodes);
  std::vector<std::int32_t> turned;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const Eigen::Quaterniond from = surroundings_[nodes[k]].cast<double>(), to = now[k].cast<double>();
    const Eigen::Matrix3d frame = (to * from.conjugate()).normalized().toRotationMatrix();
    const bool orthogonal = (frame * frame.transpose() - Eigen::Matrix3d::Identity()).norm() <= orthogonality;
    // |R - R'| is √2 times the angle between them where that is small.
    if (!orthogonal || !((frame - frames_[nodes[k]]).squaredNorm() > 2 * policy_.leastRotation * policy_.leastRotation))
      continue;
    frames_[nodes[k]] = frame;
    turned.push_back(nodes[k]);
  }
  if (turned.empty()) return {};
  turned_ = true;
  return weights_.elementsAt(turned);
}

double ExchangeCertificate::verify(NodeVectorsView x) const {
  double worst = -infinity;
  // Sums at nodes, and of pairs.
  std::vector<Eigen::Triplet<double>> entries;
  for (std::int32_t b = 0; b < static_cast<std::int32_t>(blocks_.size()); ++b) {
    const ElementBlock& block = *body_.blocks()[b];
    const int n = block.nodesPerElement(), size = 3 * n;
    std::vector<double> own(static_cast<std::size_t>(size * size));
    for (std::int32_t e = 0; e < block.elementCount(); ++e) {
      loadShare({b, e}, own.data());
      const auto nodes = block.nodesOf(e);
      Eigen::MatrixXd A = block.elementCount() > 0 ? body_.elementTangent({b, e}, x) : Eigen::MatrixXd();
      for (int i = 0; i < size; ++i)
        for (int j = 0; j < size; ++j) {
          const double free = freeFactor(body_, nodes[i / 3], i % 3) * freeFactor(body_, nodes[j / 3], j % 3);
          A(i, j) *= free / std::sqrt(body_.lumpedMass()[nodes[i / 3]] * body_.lumpedMass()[nodes[j / 3]]);
          const double G = scale_ * own[i * size + j];
          A(i, j) -= G;
          entries.emplace_back(3 * nodes[i / 3] + i % 3, 3 * nodes[j / 3] + j % 3, G);
        }
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(A, Eigen::EigenvaluesOnly);
      worst = std::max(worst, solver.eigenvalues()[size - 1] / certifiedEigenvalue());
    }
  }
  if (const DiscreteForces* discrete = body_.discreteForces()) {
    std::vector<Eigen::Matrix3d> majorants;
    discrete->majorants(x, false, majorants);
    for (std::size_t k = 0; k < majorants.size(); ++k) {
      const std::int32_t node = discrete->nodes()[k];
      const Eigen::Matrix3d own = freePart(body_, node, majorants[k] / body_.lumpedMass()[node]);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) entries.emplace_back(3 * node + i, 3 * node + j, own(i, j));
    }
  }
  Eigen::SparseMatrix<double> sum(3 * body_.nodeCount(), 3 * body_.nodeCount());
  sum.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(Eigen::MatrixXd(sum), Eigen::EigenvaluesOnly);
  return std::max(worst, solver.eigenvalues()[solver.eigenvalues().size() - 1] / certifiedEigenvalue() - 1);
}

}  // namespace ringwatch

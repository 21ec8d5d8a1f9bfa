#include <ringwatch/monitor/incremental/run_certificate.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <ringwatch/base/infinity.h>
#include <ringwatch/base/rounding.h>
#include <ringwatch/base/sort_unique.h>
#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/body/domain.h>
#include <ringwatch/body/nodes_of.h>
#include <ringwatch/materials/rotation.h>
#include <ringwatch/monitor/bounds/scaled_tangent.h>
#include <ringwatch/monitor/incremental/work_account.h>

namespace ringwatch {
namespace {

/// A strain norm at or below it belongs to an element without any free component.
constexpr double nothingFree = 1e-200;

/// A ball that grows becomes larger by this part than the element needs, which would leave it again at once.
constexpr double roomOfGrownBall = 1.0 / 3;

/// A ball that inversion ends is moved where what the element can have grown to leaves it at least this part of the way
/// to inversion; else an evaluation leaves it more.
constexpr double leastOfMovedBall = 0.5;

/// Whether A - B has no row whose diagonal and sizes beside it sum to more than nothing, by which A ≼ B: cheaper than
/// an eigenvalue.
bool diagonallyBelow(const Eigen::Matrix3d& A, const Eigen::Matrix3d& B) {
  const double a = std::abs(A(0, 1) - B(0, 1)), b = std::abs(A(0, 2) - B(0, 2)), c = std::abs(A(1, 2) - B(1, 2));
  return A(0, 0) - B(0, 0) + a + b <= 0 && A(1, 1) - B(1, 1) + a + c <= 0 && A(2, 2) - B(2, 2) + b + c <= 0;
}

}  // namespace

RunCertificate::RunCertificate(const Body& body) : CertificateState(body) {
  for (const auto& block : body.blocks()) {
    const std::size_t places = block->layout().elements.size();
    const std::vector<RoundedUp<Bfloat16>> none(places);
    const std::vector<RoundedDown<Bfloat16>> nothingKnown(places, -1);
    blocks_.push_back({ValidityBalls(*block), std::vector<RoundedUp<float>>(places), none, none, none, none,
                       nothingKnown, nothingKnown});
    if (!body.elementDamping()) continue;
    const DampedBlock* damped = body.elementDamping()->blocks()[blocks_.size() - 1];
    if (!damped || !damped->dependsOnRates()) continue;
    blocks_.back().rates = damped;
    blocks_.back().counted.assign(places, 0);
  }
}

RunCertificate::Reference RunCertificate::store(const EvaluatedPack& pack, int lane, bool withStrainNorm) {
  const ElementRef e{pack.block, pack.elements[lane]};
  const ElementValue& evaluated = pack.values[lane];
  if (withStrainNorm) setStrainNorm(e, evaluated.strainNorm);
  if (BlockData& data = of(e); data.rates) data.counted[placeOf(e)] = data.rates->coefficient(placeOf(e));
  return {evaluated.value, evaluated.drift,
          of(e).balls.setReferenceGradient(placeOf(e), pack.gradients, pack.points, lane) +
              evaluated.drift.gradientRounding};
}

void RunCertificate::setBall(ElementRef e, const Reference& reference) {
  BlockData& data = of(e);
  const std::size_t place = placeOf(e);
  const TangentGrowth growth = growthOf(reference.drift.law, reference.value, strainNorm(e));
  data.value[place] = growth.value;
  data.linear[place] = growth.linear;
  data.quadratic[place] = growth.quadratic;
  data.growthRadius[place] = std::isfinite(reference.fromStored) ? growth.radius : -1;
  const bool invertible = body().blocks()[e.block]->material().info().allowsInversion;
  data.inversionDistance[place] = invertible ? infinity : reference.drift.inversionDistance;
  data.balls.setRadius(place, validityRadius(growth, data.inversionDistance[place], allowance(e)),
                       reference.fromStored);
}

void RunCertificate::fitBall(ElementRef e) {
  BlockData& data = of(e);
  const std::size_t place = placeOf(e);
  data.balls.setRadius(place, validityRadius(data.growth(place), data.inversionDistance[place], allowance(e)),
                       ValidityBalls::storageError);
}

bool RunCertificate::moveBall(ElementRef e, const double* F, int lane, const TangentDrift& drift, double value) {
  const double radius = validityRadius(growthOf(drift.law, value, strainNorm(e)), infinity, allowance(e));
  if (!(radius >= leastOfMovedBall * drift.inversionDistance)) return false;
  const auto points = static_cast<int>(body().blocks()[e.block]->rule().points.size());
  const double fromStored = of(e).balls.setReferenceGradient(placeOf(e), F, points, lane);
  setBall(e, {value, drift, fromStored + drift.gradientRounding});
  return true;
}

void RunCertificate::evaluate(NodeVectorsView x, const std::vector<ElementRef>& elements, bool withStrainNorm,
                              std::vector<Reference>& results) {
  results.resize(elements.size());
  evaluateEach(x, elements, withStrainNorm, [&](const EvaluatedPack& pack, const std::size_t* index) {
    for (int lane = 0; lane < lanes && pack.elements[lane] >= 0; ++lane) {
      results[index[lane]] = store(pack, lane, withStrainNorm);
      setBall({pack.block, pack.elements[lane]}, results[index[lane]]);
    }
  });
  for (std::size_t i = 0; i < elements.size(); ++i) note(elements[i], results[i].drift);
  statistics_.evaluated += static_cast<std::int64_t>(elements.size());
  statistics_.work[WorkOn::evaluations] += WorkAccount::ofEvaluation(body(), elements);
}

std::vector<double> RunCertificate::sumsAt(const std::vector<std::int32_t>& nodes) const {
  std::vector<double> sums(nodes.size());
  parallelFor(
      0, nodes.size(), body().threads(),
      [&](std::int64_t k) {
        sums[k] =
            largestEigenvalue(sumOfAllowances(nodes[k])) * (1 + allowanceRounding) / body().lumpedMass()[nodes[k]];
      },
      64);
  return sums;
}

bool RunCertificate::exceeds(std::int32_t node) const { return !(sumsAt({node}).front() <= certifiedEigenvalue()); }

void RunCertificate::renewMajorants(NodeVectorsView x) {
  const DiscreteForces* discrete = body().discreteForces();
  if (!discrete) return;
  std::vector<Eigen::Matrix3d> majorants;
  majorantsAt_.clear();
  discrete->majorants(x, true, majorants, majorantsAt_);
  std::sort(majorantsAt_.begin(), majorantsAt_.end());
  weights().setMajorants(std::move(majorants));
}

std::vector<std::int32_t> RunCertificate::followDiscreteForces(NodeVectorsView x) {
  const DiscreteForces* discrete = body().discreteForces();
  if (!discrete) return {};
  discrete->majorants(x, false, needed_, neededAt_);
  const std::vector<Eigen::Matrix3d>& before = weights().majorants();
  std::vector<std::int32_t> places;
  for (const std::int32_t k : neededAt_) {
    if (needed_[k] == before[k] || diagonallyBelow(needed_[k], before[k])) continue;
    // Majorants are larger than what they stand for by far more than this rounding.
    if (largestEigenvalue(needed_[k] - before[k]) <= majorantRounding * needed_[k].trace()) continue;
    places.push_back(k);
  }
  if (places.empty()) return {};
  discrete->majorants(x, true, withRoom_, withRoomAt_);
  std::vector<std::int32_t> grown;
  for (const std::int32_t k : places) {
    if (before[k].trace() == 0) majorantsAt_.push_back(k);
    weights().setMajorant(k, withRoom_[k]);
    grown.push_back(discrete->nodes()[k]);
  }
  std::sort(grown.begin(), grown.end());
  std::erase_if(grown, [&](std::int32_t node) { return !exceeds(node); });
  return grown;
}

void RunCertificate::releaseDiscreteForces(NodeVectorsView x) {
  const DiscreteForces* discrete = body().discreteForces();
  if (!discrete) return;
  discrete->majorants(x, true, withRoom_, withRoomAt_);
  std::erase_if(majorantsAt_, [&](std::int32_t k) {
    const Eigen::Matrix3d before = weights().majorants()[k];
    if (!(withRoom_[k].trace() < before.trace())) return false;
    weights().setMajorant(k, withRoom_[k]);
    // One of less trace may be larger in some direction.
    if (exceeds(discrete->nodes()[k])) weights().setMajorant(k, before);
    return weights().majorants()[k].trace() == 0;
  });
}

double RunCertificate::leastForDiscreteForces() const {
  double least = 0;
  if (const DiscreteForces* discrete = body().discreteForces())
    for (const std::int32_t k : majorantsAt_) {
      const std::int32_t node = discrete->nodes()[k];
      const Eigen::Matrix3d majorant = freePart(body(), node, weights().majorants()[k]);
      least = std::max(least, largestEigenvalue(majorant) / body().lumpedMass()[node]);
    }
  return least;
}

void RunCertificate::raiseForNodes(const std::vector<std::int32_t>& nodes, double share) {
  for (const double sum : sumsAt(nodes)) setCertifiedEigenvalue(std::max(certifiedEigenvalue(), sum * (1 + share)));
  statistics_.raises += nodes.empty() ? 0 : 1;
}

std::vector<double> RunCertificate::scalingsBesideDiscreteForces() const {
  std::vector<double> scalings;
  const DiscreteForces* discrete = body().discreteForces();
  if (!discrete) return scalings;
  scalings.assign(discrete->nodes().size(), -1);
  for (const std::int32_t k : majorantsAt_) {
    const std::int32_t node = discrete->nodes()[k];
    Eigen::Matrix3d elements = Eigen::Matrix3d::Zero();
    for (const NodalBound::Incidence at : weights().incidences(node))
      elements += weights().value(weights().elementAt(at)) * weights().weight(at);
    const double mass = body().lumpedMass()[node];
    scalings[k] = largestScaling(freePart(body(), node, weights().majorants()[k]) / mass,
                                 freePart(body(), node, elements) / mass, certifiedEigenvalue());
  }
  return scalings;
}

void RunCertificate::reduceBesideDiscreteForces() {
  const DiscreteForces* discrete = body().discreteForces();
  if (!discrete) return;
  for (const std::int32_t k : majorantsAt_) {
    const std::int32_t node = discrete->nodes()[k];
    if (!exceeds(node)) continue;
    const double mass = body().lumpedMass()[node];
    const double share = largestScaling(freePart(body(), node, weights().majorants()[k]) / mass,
                                        freePart(body(), node, sumOfElements(node)) / mass, certifiedEigenvalue()) *
                         (1 - 4 * allowanceRounding);
    if (!(share < 1)) continue;
    for (const NodalBound::Incidence at : weights().incidences(node)) {
      const ElementRef e = weights().elementAt(at);
      setAllowance(e, allowance(e) * share);
      const double radius = of(e).balls.radius(placeOf(e));
      if (radius >= 0 && std::isfinite(radius)) fitBall(e);
    }
  }
}

std::vector<RunCertificate::ElementOutside> RunCertificate::growBalls(NodeVectorsView x,
                                                                      const std::vector<ElementRef>& elements) {
  needs_.resize(elements.size());
  forEachPack(elements, [&](std::int32_t b, const std::int32_t* pack, const std::size_t* index) {
    const ElementBlock& block = *body().blocks()[b];
    std::vector<double> F(9 * block.rule().points.size() * lanes);
    TangentDrift drift[lanes];
    block.deformationOf(pack, x.data(), F.data(), drift);
    for (int lane = 0; lane < lanes && pack[lane] >= 0; ++lane) {
      const std::size_t place = placeOf({b, pack[lane]});
      const double distance = blocks_[b].balls.distance(place, F.data(), lane);
      // It has to be inside a radius that is stored with 8 bits, and not at its edge.
      const double radius = (1 + 1.0 / 64) * (1 + roomOfGrownBall) * distance + ValidityBalls::storageError;
      // The growth is that of the damping that counted when it was last evaluated.
      const TangentGrowth growth = blocks_[b].growth(place);
      double need = (1 + radiusRounding) * (blocks_[b].rateHasRisen(place) ? infinity : growth.at(radius));
      const bool inversionEndsBall = radius > blocks_[b].inversionDistance[place] && drift[lane].determinant > 0;
      if (inversionEndsBall && need <= allowance({b, pack[lane]})) {
        const double here = (1 + radiusRounding) * growth.at(distance + drift[lane].gradientRounding);
        if (!moveBall({b, pack[lane]}, F.data(), lane, drift[lane], here)) need = infinity;
      }
      needs_[index[lane]] = {need, drift[lane]};
    }
  });
  std::vector<ElementOutside> grown, others;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    note(elements[i], needs_[i].drift);
    const double own = allowance(elements[i]), need = needs_[i].allowance;
    const ElementOutside outsider{elements[i], need <= own ? 1 : own > 0 && need < infinity ? need / own : infinity};
    (outsider.need <= 1 ? grown : others).push_back(outsider);
  }
  statistics_.work[WorkOn::evaluations] += WorkAccount::ofGrowth(body(), elements);
  growBalls(grown);
  return others;
}

void RunCertificate::growBalls(std::span<const ElementOutside> violating) {
  for (const ElementOutside& outsider : violating) fitBall(outsider.element);
}

void RunCertificate::raiseToValues(const std::vector<ElementRef>& elements, double share) {
  for (const ElementRef e : elements) setAllowance(e, std::max(allowance(e), value(e) * (1 + share)));
  std::vector<std::int32_t> nodes = nodesOfElements(body(), elements);
  std::erase_if(nodes, [owned = body().domain().owned(body().nodeCount())](std::int32_t i) { return i >= owned; });
  for (const double sum : sumsAt(nodes)) setCertifiedEigenvalue(std::max(certifiedEigenvalue(), sum));
  for (const ElementRef e : elements) fitBall(e);
  statistics_.raises += elements.empty() ? 0 : 1;
}

void RunCertificate::note(ElementRef e, double determinant, double negative) {
  const Material& material = body().blocks()[e.block]->material();
  if (determinant < statistics_.leastDeterminant && !material.info().allowsInversion) {
    statistics_.leastDeterminant = determinant;
    statistics_.leastDeterminantElement = e;
  }
  const double modulus = material.restModulus();
  RoundedUp<Bfloat16>& compression = of(e).compression[placeOf(e)];
  compression = negative / modulus;
  mostCompression_ = std::max(mostCompression_, static_cast<double>(compression));
}

std::vector<ElementRef> RunCertificate::elementsOutsideBall(NodeVectorsView x, StepEvaluation* evaluation) {
  const std::vector<ElementRef> outside = outsideBalls_.find(body(), blocks_, x, evaluation);
  statistics_.work[WorkOn::tests] += WorkAccount::ofNodes(body()) + WorkAccount::ofContact(body());
  for (const BlockData& data : blocks_) statistics_.work[WorkOn::tests] += data.balls.workOfCheck();
  return outside;
}

void RunCertificate::distributeAllowances(NodeVectorsView x, bool newWeights) {
  mostCompression_ = 0;
  const std::vector<double>& nodal = weights().nodal();
  const DiscreteForces* discrete = body().discreteForces();
  const std::vector<double> besideDiscrete = scalingsBesideDiscreteForces();
  // How far the values at a node can grow together below the certified eigenvalue.
  const auto scalingAt = [&](std::int32_t node) {
    const std::int32_t place = discrete ? discrete->placeOf(node) : -1;
    if (place >= 0 && besideDiscrete[place] >= 0) return besideDiscrete[place];
    return nodal[node] > 0 ? certifiedEigenvalue() / nodal[node] : infinity;
  };
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const ElementBlock& block = *body().blocks()[b];
    BlockData& data = blocks_[b];
    constexpr std::int32_t chunk = 8;
    const std::int32_t batches = block.layout().batchCount();
    std::vector<TangentDrift> drifts(static_cast<std::size_t>(batches) * lanes);
    parallelFor(0, (batches + chunk - 1) / chunk, body().threads(), [&](std::int64_t c) {
      const std::int32_t end = std::min(batches, static_cast<std::int32_t>(c + 1) * chunk);
      for (auto batch = static_cast<std::int32_t>(c) * chunk; batch < end; ++batch) {
        const std::int32_t* elements = block.layout().elements.data() + static_cast<std::ptrdiff_t>(batch) * lanes;
        double swept[lanes] = {};
        for (int lane = 0; lane < lanes; ++lane)
          if (elements[lane] >= 0) swept[lane] = weights().value({b, elements[lane]});
        evaluatePack(x, b, elements, swept, newWeights, [&](const EvaluatedPack& pack) {
          for (int lane = 0; lane < lanes; ++lane) {
            if (elements[lane] < 0) continue;
            const ElementRef e{pack.block, elements[lane]};
            const std::size_t place = batch * lanes + lane;
            const Reference reference = store(pack, lane, newWeights);
            drifts[place] = reference.drift;
            double scaling = infinity;
            for (const std::int32_t node : block.nodesOf(elements[lane])) scaling = std::min(scaling, scalingAt(node));
            setAllowance(e, swept[lane] > 0 ? swept[lane] * scaling * (1 - allowanceRounding) : 0);
            setBall(e, reference);
            // Nothing of a wholly constrained or rigid element is left in the problem.
            if ((body().constraints().any() || body().constraints().rigidBodies().size() > 0) && reference.value == 0 &&
                strainNorm(e) <= nothingFree)
              data.balls.setNeverOutside(place);
          }
        });
      }
    });
    for (std::size_t i = 0; i < drifts.size(); ++i)
      if (block.layout().elements[i] >= 0) note({b, block.layout().elements[i]}, drifts[i]);
    statistics_.evaluated += newWeights ? block.elementCount() : 0;
  }
  weights().releaseSums();
  statistics_.work[WorkOn::sweeps] += WorkAccount::ofDistribution(body(), newWeights);
  frames_.resize(body().nodeCount());
  parallelFor(
      0, body().nodeCount(), body().threads(), [&](std::int64_t node) { frames_[node] = frameOf(node); }, 64);
}

void RunCertificate::moveTo(double sigma) {
  statistics_.work[WorkOn::sweeps] += WorkAccount::ofMove(body());
  const double factor = sigma / certifiedEigenvalue() * (1 - allowanceRounding);
  setCertifiedEigenvalue(sigma);
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    BlockData& data = blocks_[b];
    parallelFor(
        0, body().blocks()[b]->layout().batchCount(), body().threads(),
        [&](std::int64_t batch) {
          const auto first = static_cast<std::size_t>(batch) * lanes;
          RoundedDown<float>* const own = allowances(b).data() + first;
          RoundedDown<float>::store(RoundedDown<float>::load(own) * NativePack(factor), own);
          data.balls.setRadii(static_cast<std::int32_t>(batch),
                              validityRadius(data.growthOfPack(first),
                                             RoundedDown<Bfloat16>::load(data.inversionDistance.data() + first),
                                             RoundedDown<float>::load(own)));
        },
        256);
  }
  // What discrete forces take does not shrink with the rest.
  if (factor < 1) reduceBesideDiscreteForces();
}

Eigen::Quaternionf RunCertificate::frameOf(std::int32_t node) const {
  Matrix3<double> F = Matrix3<double>::zero();
  int count = 0;
  for (const NodalBound::Incidence at : weights().incidences(node)) {
    if (++count > elementsOfFrame_) break;
    const ElementRef e = weights().elementAt(at);
    of(e).balls.addReferenceGradient(placeOf(e), F.m);
  }
  const Matrix3<double> R = closestRotation(F);
  Eigen::Matrix3d matrix;
  for (int i = 0; i < 9; ++i) matrix(i / 3, i % 3) = R.m[i];
  return Eigen::Quaterniond(matrix).cast<float>();
}

bool RunCertificate::rotateWithBody(NodeVectorsView x, const RebuildPolicy& policy) {
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const ElementBlock& block = *body().blocks()[b];
    parallelFor(
        0, block.layout().batchCount(), body().threads(),
        [&](std::int64_t batch) {
          const std::int32_t* elements = block.layout().elements.data() + batch * lanes;
          std::vector<double> F(9 * block.rule().points.size() * lanes);
          TangentDrift drift[lanes];
          block.deformationOf(elements, x.data(), F.data(), drift);
          for (int lane = 0; lane < lanes; ++lane)
            blocks_[b].balls.setReferenceGradient(batch * lanes + lane, F.data(),
                                                  static_cast<int>(block.rule().points.size()), lane);
        },
        8);
  }
  std::vector<std::int32_t> all(body().nodeCount());
  std::iota(all.begin(), all.end(), 0);
  return !rotateWeights(all, policy).empty();
}

std::vector<std::int32_t> RunCertificate::rotateWeights(const std::vector<std::int32_t>& nodes,
                                                        const RebuildPolicy& policy) {
  std::vector<std::int32_t> rotated;
  for (const std::int32_t node : nodes) {
    // Where components are constrained the sum is cut along fixed axes.
    if (body().constraints().any() && body().constraints().freeComponents(node) < 3) continue;
    // Obstacles and springs do not turn with the body.
    if (weights().majorantAt(node).trace() > 0) continue;
    const Eigen::Quaternionf now = frameOf(node);
    if (now.angularDistance(frame(node)) < policy.leastRotation) continue;
    const Eigen::Matrix3d Q = (now * frame(node).conjugate()).normalized().toRotationMatrix().cast<double>();
    for (const NodalBound::Incidence at : weights().incidences(node))
      weights().setWeight(at, Q * weights().weight(at) * Q.transpose());
    setFrame(node, now);
    rotated.push_back(node);
  }
  for (const std::int32_t node : rotated) {
    const double share = certifiedEigenvalue() * body().lumpedMass()[node] / largestEigenvalue(sumOfAllowances(node));
    if (share > 1) continue;
    for (const NodalBound::Incidence at : weights().incidences(node)) {
      const ElementRef e = weights().elementAt(at);
      setAllowance(e, allowance(e) * share * (1 - allowanceRounding));
    }
  }
  return rotated;
}

namespace {
struct Ranked {
  double key;
  ElementRef element;
};
}  // namespace

std::vector<ElementRef> RunCertificate::mostCompressed(double least, std::size_t count) const {
  if (!(mostCompression_ > least) || count == 0) return {};
  const auto before = [](const Ranked& a, const Ranked& other) {
    return a.key != other.key ? a.key > other.key : a.element < other.element;
  };
  std::vector<Ranked> found;  // a heap, the last of them in front
  for (std::size_t b = 0; b < blocks_.size(); ++b)
    for (std::size_t place = 0; place < blocks_[b].compression.size(); ++place) {
      // Most batches have none.
      const double enough = found.size() == count ? found.front().key : least;
      if (place % lanes == 0 &&
          !anyOf(RoundedUp<Bfloat16>::load(blocks_[b].compression.data() + place) >= NativePack(enough))) {
        place += lanes - 1;
        continue;
      }
      const Ranked entry{blocks_[b].compression[place], {b, body().blocks()[b]->layout().elements[place]}};
      if (!(entry.key > least) || (found.size() == count && !before(entry, found.front()))) continue;
      if (found.size() == count) {
        std::pop_heap(found.begin(), found.end(), before);
        found.pop_back();
      }
      found.push_back(entry);
      std::push_heap(found.begin(), found.end(), before);
    }
  std::sort_heap(found.begin(), found.end(), before);
  std::vector<ElementRef> result;
  for (const Ranked& entry : found) result.push_back(entry.element);
  return result;
}

std::vector<ElementRef> RunCertificate::compressedByTurns(double least, std::size_t count, std::size_t& next) const {
  std::vector<ElementRef> result;
  if (!(mostCompression_ > least)) return result;
  std::size_t places = 0;
  for (const BlockData& data : blocks_) places += data.compression.size();
  for (std::size_t seen = 0; seen < places && result.size() < count; ++seen) {
    std::size_t place = next++ % places, b = 0;
    while (place >= blocks_[b].compression.size()) place -= blocks_[b++].compression.size();
    if (blocks_[b].compression[place] > least) result.push_back({b, body().blocks()[b]->layout().elements[place]});
  }
  next %= places;
  return result;
}

std::vector<ElementRef> RunCertificate::highestElements(std::size_t count) {
  std::vector<std::span<const RoundedUp<float>>> values;
  for (const BlockData& data : blocks_) values.emplace_back(data.value);
  const std::vector<double>& nodal = weights().sumsOf(values);
  std::vector<std::int32_t> nodes(body().nodeCount());
  std::iota(nodes.begin(), nodes.end(), 0);
  const auto end = nodes.begin() + static_cast<std::ptrdiff_t>(std::min(count, nodes.size()));
  std::partial_sort(nodes.begin(), end, nodes.end(), [&](std::int32_t a, std::int32_t b) {
    const double at = nodal[a], other = nodal[b];
    return at != other ? at > other : a < b;
  });
  std::vector<ElementRef> result;
  for (auto node = nodes.begin(); node != end; ++node) {
    double most = 0;
    ElementRef highest;
    for (const NodalBound::Incidence at : weights().incidences(*node)) {
      const ElementRef e = weights().elementAt(at);
      const double part = value(e) * weights().weight(at).trace();
      if (part > most) {
        most = part;
        highest = e;
      }
    }
    if (most > 0) result.push_back(highest);
  }
  weights().releaseSums();
  sortUnique(result);
  return result;
}

}  // namespace ringwatch

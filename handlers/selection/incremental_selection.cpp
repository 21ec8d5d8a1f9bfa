#include <ringwatch/handlers/selection/incremental_selection.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include <ringwatch/base/error.h>
#include <ringwatch/base/rounding.h>
#include <ringwatch/body/nodes_of.h>
#include <ringwatch/handlers/selection/rotation_of.h>
#include <ringwatch/monitor/bounds/nodal_bound.h>

namespace ringwatch {
namespace {

/// F_q of a lane.
Eigen::Matrix3d gradientAt(const double* F, std::size_t q, int lane) {
  Eigen::Matrix3d own;
  for (int i = 0; i < 9; ++i)
    own(i / 3, i % 3) = F[(9 * q + static_cast<std::size_t>(i)) * lanes + static_cast<std::size_t>(lane)];
  return own;
}

std::vector<ElementRef> allElements(const Body& body) {
  std::vector<ElementRef> elements;
  for (std::size_t b = 0; b < body.blocks().size(); ++b)
    for (std::int32_t e = 0; e < body.blocks()[b]->elementCount(); ++e) elements.push_back({b, e});
  return elements;
}

std::vector<std::int32_t> allNodes(const Body& body) {
  std::vector<std::int32_t> nodes(body.nodeCount());
  std::iota(nodes.begin(), nodes.end(), 0);
  return nodes;
}

void setAll(ElementFlags& flags, const std::vector<ElementRef>& elements, bool value) {
  for (const ElementRef e : elements) flags[e.block][e.element] = value;
}

}  // namespace

/// The certificate at the positions of one choice.
class IncrementalSelection::Choice {
 public:
  Choice(IncrementalSelection& own, const Body& body, const NodeVectors& x, double lambda)
      : own_(own), body_(body), x_(x), lambda_(lambda), state_(body) {
    state_.setCertifiedEigenvalue(lambda);
    state_.setExcluded(own.last_.chosen);
    state_.allowRotations();
    for (std::size_t b = 0; b < body.blocks().size(); ++b) {
      const int n = body.blocks()[b]->nodesPerElement();
      const NodalBound::Factor* stored = own.last_.weights[b].data();
      for (std::int32_t e = 0; e < body.blocks()[b]->elementCount(); ++e) {
        // The weights of an element lie one pack of lanes apart.
        NodalBound::Incidence at = state_.weights().incidenceOf({b, e}, 0);
        for (int a = 0; a < n; ++a, at.place += lanes) state_.weights().setFactor(at, *stored++);
      }
    }
  }

  const CertificateState<double>& state() const { return state_; }

  /// Allowances and rotations at x, without evaluating any tangent.
  void follow() {
    for (std::size_t b = 0; b < body_.blocks().size(); ++b) {
      const ElementBlock& block = *body_.blocks()[b];
      parallelFor(
          0, block.layout().batchCount(), body_.threads(),
          [&](std::int64_t batch) {
            const std::int32_t* elements = block.layout().elements.data() + batch * lanes;
            std::vector<double> F(9 * block.rule().points.size() * lanes);
            TangentDrift drift[lanes];
            block.deformationOf(elements, x_.data(), F.data(), drift);
            for (int lane = 0; lane < lanes; ++lane)
              if (elements[lane] >= 0) follow({b, elements[lane]}, F.data(), lane);
          },
          16);
    }
  }

  /// Evaluates elements with the weights that they have at x, and remembers what it found.
  void evaluate(const std::vector<ElementRef>& elements) {
    for (const ElementRef e : elements) {
      for (int a = 0; a < nodesPerElement(e); ++a) {
        const auto at = state_.weights().incidenceOf(e, a);
        const Eigen::Matrix3d& R = state_.rotation(e);
        if (!R.isIdentity(0)) state_.weights().setWeight(at, R * state_.weights().weight(at) * R.transpose());
      }
      state_.setRotation(e, Eigen::Matrix3d::Identity());
    }
    state_.evaluateEach(x_, elements, true, [&](const EvaluatedPack& pack, const std::size_t*) {
      for (int lane = 0; lane < lanes && pack.elements[lane] >= 0; ++lane) remember(pack, lane);
    });
    own_.last_.evaluations += static_cast<std::int64_t>(elements.size());
    setAll(own_.evaluated_, elements, true);
  }

  /// Makes the choice again among the elements of a region, with all others as they are.
  void chooseAmong(const std::vector<ElementRef>& region);

  void exclude(const std::vector<ElementRef>& elements, bool excluded) {
    for (const ElementRef e : elements) state_.setExcluded(e, excluded);
    setAll(own_.last_.chosen, elements, excluded);
  }

  void sumAt(const std::vector<std::int32_t>& nodes) {
    parallelFor(
        0, nodes.size(), body_.threads(),
        [&](std::int64_t k) {
          const std::int32_t node = nodes[k];
          own_.last_.nodalSums[node] = state_.sumOfAllowances(node);
        },
        256);
  }

  /// Of some nodes those whose sums are above lambda m_i.
  std::vector<std::int32_t> violated(const std::vector<std::int32_t>& among) const {
    std::vector<std::uint8_t> above(among.size(), 0);
    parallelFor(
        0, among.size(), body_.threads(),
        [&](std::int64_t k) {
          const std::int32_t node = among[k];
          const Eigen::Matrix3d& sum = own_.last_.nodalSums[node];
          above[k] = !sum.allFinite() ||
                     !(largestEigenvalue(sum) <= lambda_ * (1 - checkedSelectionRounding) * body_.lumpedMass()[node]);
        },
        256);
    std::vector<std::int32_t> result;
    for (std::size_t k = 0; k < among.size(); ++k)
      if (above[k]) result.push_back(among[k]);
    return result;
  }

  /// Elements at some nodes, ascending, but excluded ones.
  std::vector<ElementRef> explicitElementsAt(const std::vector<std::int32_t>& nodes) const {
    std::vector<ElementRef> elements = state_.weights().elementsAt(nodes);
    std::erase_if(elements, [&](ElementRef e) { return state_.excluded(e); });
    return elements;
  }

 private:
  int nodesPerElement(ElementRef e) const { return body_.blocks()[e.block]->nodesPerElement(); }
  NodalBound::Factor& storedWeight(ElementRef e, int a) const {
    return own_.last_.weights[e.block][e.element * nodesPerElement(e) + a];
  }
  Eigen::Matrix3d reference(ElementRef e, std::size_t q) const {
    const std::size_t points = body_.blocks()[e.block]->rule().points.size();
    const float* stored = own_.known_[e.block].reference.data() + (e.element * points + q) * 9;
    return Eigen::Map<const Eigen::Matrix<float, 3, 3, Eigen::RowMajor>>(stored).cast<double>();
  }

  void follow(ElementRef e, const double* gradients, int lane) {
    const ElementBlock& block = *body_.blocks()[e.block];
    const TangentGrowth growth = own_.known_[e.block].growth[e.element].unpacked();
    double distance = 0;
    if (growth.radius >= 0) {
      const std::size_t points = block.rule().points.size();
      bool turns = block.material().info().objective;
      for (const std::int32_t node : block.nodesOf(e.element))
        turns = turns && body_.constraints().freeComponents(node) % 3 == 0;
      Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
      if (turns) {
        Eigen::Matrix3d product = Eigen::Matrix3d::Zero();
        for (std::size_t q = 0; q < points; ++q)
          product += gradientAt(gradients, q, lane) * reference(e, q).transpose();
        R = rotationOf(product);
        state_.setRotation(e, R);
      }
      for (std::size_t q = 0; q < points; ++q) {
        const Eigen::Matrix3d before = reference(e, q);
        const double here =
            (gradientAt(gradients, q, lane) - R * before).norm() + storedGradientRounding * before.norm();
        distance = here <= distance ? distance : here;  // NaN is kept
      }
    }
    state_.setAllowance(e, growth.at(distance));
  }

  void remember(const EvaluatedPack& pack, int lane) {
    const ElementRef e{pack.block, pack.elements[lane]};
    const ElementValue& value = pack.values[lane];
    const TangentGrowth growth = growthOf(value.drift.law, value.value, value.strainNorm);
    Known& known = own_.known_[e.block];
    known.growth[e.element] = {growth.value, growth.linear, growth.quadratic, growth.radius * (1 - radiusRounding)};
    const std::size_t count = 9 * pack.points;
    for (std::size_t i = 0; i < count; ++i)
      known.reference[e.element * count + i] =
          static_cast<float>(pack.gradients[i * lanes + static_cast<std::size_t>(lane)]);
    for (int a = 0; a < nodesPerElement(e); ++a)
      storedWeight(e, a) = state_.weights().factor(state_.weights().incidenceOf(e, a));
    state_.setAllowance(e, growth.value);
  }

  IncrementalSelection& own_;
  const Body& body_;
  const NodeVectors& x_;
  double lambda_;
  CertificateState<double> state_;
};

void IncrementalSelection::Choice::chooseAmong(const std::vector<ElementRef>& region) {
  // All others, and what they use of lambda.
  exclude(region, true);
  ElementFlags flags = noElements(body_.mesh());
  setAll(flags, region, true);
  const std::vector<std::int32_t> nodes = nodesOfElements(body_, region);
  sumAt(nodes);
  std::vector<Eigen::Matrix3d> outside;
  NodeVectors x(3, nodes.size());
  Eigen::VectorXd mass(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    outside.push_back(own_.last_.nodalSums[nodes[i]]);
    x.col(i) = x_.col(nodes[i]);
    mass[i] = body_.lumpedMass()[nodes[i]];
  }
  const CertifiedSelection made = selectCertified(bodyOf(body_, flags, nodes, mass), x, lambda_, {}, outside);
  own_.last_.evaluations += made.evaluations;
  // Elements of the region are numbered in ascending order.
  std::vector<std::size_t> next(body_.blocks().size(), 0);
  for (const ElementRef e : region) {
    const std::size_t number = next[e.block]++;
    const int n = nodesPerElement(e);
    for (int a = 0; a < n; ++a)
      state_.weights().setFactor(
          state_.weights().incidenceOf(e, a),
          made.weights[e.block][number * static_cast<std::size_t>(n) + static_cast<std::size_t>(a)]);
    state_.setRotation(e, Eigen::Matrix3d::Identity());
    if (!made.chosen[e.block][number]) exclude({e}, false);
  }
  evaluate(region);
  sumAt(nodes);
}

bool IncrementalSelection::knows(const Body& body) const {
  if (known_.size() != body.blocks().size()) return false;
  for (std::size_t b = 0; b < known_.size(); ++b)
    if (known_[b].growth.size() != static_cast<std::size_t>(body.blocks()[b]->elementCount())) return false;
  return true;
}

const CertifiedSelection& IncrementalSelection::chooseFromScratch(const Body& body, const NodeVectors& x, double lambda,
                                                                  const ElementFlags& keep) {
  last_ = selectCertified(body, x, lambda, keep);
  evaluated_ = noElements(body.mesh());
  known_.clear();
  for (const auto& block : body.blocks()) {
    Known& known = known_.emplace_back();
    known.growth.resize(block->elementCount());
    known.reference.resize(block->elementCount() * block->rule().points.size() * 9);
  }
  Choice(*this, body, x, lambda).evaluate(allElements(body));
  return last_;
}

const CertifiedSelection& IncrementalSelection::choose(const Body& body, const NodeVectors& x, double lambda,
                                                       const ElementFlags& keep) {
  if (!(lambda > 0)) throw InputError(joinText("selection: lambda = ", lambda, " rad2/s2 must be > 0"));
  lambda_ = lambda;
  if (!knows(body)) return chooseFromScratch(body, x, lambda, keep);
  last_.evaluations = 0;
  evaluated_ = noElements(body.mesh());
  // New elements are chosen from with their neighbours in any case, and count for nothing until then.
  std::vector<ElementRef> again;
  for (const ElementRef e : allElements(body)) {
    const bool kept = keep[e.block][e.element];
    auto chosen = last_.chosen[e.block][e.element];
    if (!kept && !chosen && static_cast<double>(known_[e.block].growth[e.element].radius) < 0)
      again.push_back(e);
    else if (!kept)
      continue;
    chosen = true;
  }
  const auto all = allNodes(body);
  last_.nodalSums.resize(all.size());
  Choice choice(*this, body, x, lambda);
  choice.follow();
  choice.sumAt(all);
  if (const auto above = choice.violated(all); !above.empty()) {
    const std::vector<ElementRef> doubtful = choice.explicitElementsAt(above);
    choice.evaluate(doubtful);
    const std::vector<std::int32_t> nodes = nodesOfElements(body, doubtful);
    choice.sumAt(nodes);
    for (const ElementRef e : choice.explicitElementsAt(choice.violated(nodes))) again.push_back(e);
  }
  if (!again.empty()) {
    std::vector<ElementRef> region = choice.state().weights().elementsAt(nodesOfElements(body, again));
    std::erase_if(region, [&](ElementRef e) { return keep[e.block][e.element]; });
    if (static_cast<double>(region.size()) > policy_.tooLargeRegion * static_cast<double>(body.mesh().elementCount())) {
      const std::int64_t before = last_.evaluations;
      chooseFromScratch(body, x, lambda, keep);
      last_.evaluations += before;
      return last_;
    }
    choice.chooseAmong(region);
  }
  last_.explicitPart = {0};
  for (std::int32_t i = 0; i < body.nodeCount(); ++i)
    last_.explicitPart.value =
        std::max(last_.explicitPart.value, largestEigenvalue(last_.nodalSums[i]) / body.lumpedMass()[i]);
  return last_;
}

double IncrementalSelection::verify(const Body& body, const NodeVectors& x) const {
  IncrementalSelection copy = *this;
  Choice choice(copy, body, x, lambda_);
  choice.follow();
  return choice.state().verify(x);
}

void IncrementalSelection::carryOver(const CutMesh& cut) {
  if (known_.empty()) return;
  last_.chosen = carriedOver(cut, last_.chosen);
  for (std::size_t b = 0; b < known_.size(); ++b) {
    const std::size_t before = known_[b].growth.size(), count = cut.parent[b].size();
    const std::size_t nodes = before == 0 ? 0 : last_.weights[b].size() / before,
                      numbers = before == 0 ? 0 : known_[b].reference.size() / before;
    Known known;
    known.growth.resize(count);
    known.reference.resize(count * numbers);
    std::vector<NodalBound::Factor> weights(count * nodes);
    for (std::size_t e = 0; e < count; ++e) {
      if (cut.changed[b][e]) continue;
      const auto from = cut.parent[b][e];
      known.growth[e] = known_[b].growth[from];
      std::copy_n(known_[b].reference.begin() + static_cast<std::ptrdiff_t>(from * numbers), numbers,
                  known.reference.begin() + static_cast<std::ptrdiff_t>(e * numbers));
      std::copy_n(last_.weights[b].begin() + static_cast<std::ptrdiff_t>(from * nodes), nodes,
                  weights.begin() + static_cast<std::ptrdiff_t>(e * nodes));
    }
    known_[b] = std::move(known);
    last_.weights[b] = std::move(weights);
  }
}

}  // namespace ringwatch

#include <ringwatch/handlers/kept_selection.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/short_floats.h>
#include <ringwatch/handlers/rotation_of.h>
#include <ringwatch/monitor/nodal_bound.h>
#include <ringwatch/monitor/scaled_tangent.h>
#include <ringwatch/monitor/tangent_growth.h>

namespace ringwatch {
namespace {

constexpr int lanes = PatchLayout::lanes;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

double largest(const Eigen::Matrix3d& S) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(S, Eigen::EigenvaluesOnly).eigenvalues()[2];
}

std::vector<std::int32_t> allNodes(const Body& body) {
  std::vector<std::int32_t> nodes(at(body.nodeCount()));
  std::iota(nodes.begin(), nodes.end(), 0);
  return nodes;
}

/// Calls visit(block, elements[lanes], F[q][9][lane], drift[lanes]) for all elements of a body.
template <class Visit>
void forEachDeformation(const Body& body, const NodeVectors& x, const Visit& visit) {
  for (std::size_t b = 0; b < body.blocks().size(); ++b) {
    const ElementBlock& block = *body.blocks()[b];
    parallelFor(
        0, block.layout().batchCount(), body.threads(),
        [&](std::int64_t batch) {
          const std::int32_t* elements = block.layout().elements.data() + batch * lanes;
          std::vector<double> F(9 * block.rule().points.size() * lanes);
          TangentDrift drift[lanes];
          block.deformationOf(elements, x.data(), F.data(), drift);
          visit(b, elements, F.data(), drift);
        },
        16);
  }
}

/// F_q of a lane.
Eigen::Matrix3d gradientAt(const double* F, std::size_t q, int lane) {
  Eigen::Matrix3d own;
  for (int i = 0; i < 9; ++i)
    own(i / 3, i % 3) = F[(9 * q + static_cast<std::size_t>(i)) * lanes + static_cast<std::size_t>(lane)];
  return own;
}

}  // namespace

bool KeptSelection::knows(const Body& body) const {
  if (known_.size() != body.blocks().size()) return false;
  for (std::size_t b = 0; b < known_.size(); ++b)
    if (known_[b].growth.size() != at(body.blocks()[b]->elementCount())) return false;
  return true;
}

void KeptSelection::start(const Body& body, const NodeVectors& x, double lambda, const ElementFlags& keep) {
  last_ = selectCertified(body, x, lambda, keep);
  judged_ = complement(noElements(body.mesh()));
  known_.clear();
  Numbers numbers;
  for (const auto& block : body.blocks()) {
    known_.emplace_back();
    known_.back().growth.resize(at(block->elementCount()));
    known_.back().anchor.resize(at(block->elementCount()) * block->rule().points.size() * 9);
    numbers.emplace_back(at(block->elementCount()));
    std::iota(numbers.back().begin(), numbers.back().end(), 0);
  }
  learn(body, x, numbers, last_.shapes);
}

void KeptSelection::learn(const Body& part, const NodeVectors& x, const Numbers& numbers, const NodalShapes& shapes) {
  NodalBound bound(part);
  for (std::size_t b = 0; b < numbers.size(); ++b) {
    const ElementBlock& block = *part.blocks()[b];
    const int n = block.element().nodes;
    for (std::int32_t e = 0; e < block.elementCount(); ++e)
      for (int a = 0; a < n; ++a) {
        const NodalBound::Factor& shape = shapes[b][at(e * n + a)];
        bound.setFactor(bound.incidenceOf({static_cast<std::int32_t>(b), e}, a), shape);
        last_.shapes[b][at(numbers[b][at(e)] * n + a)] = shape;
      }
  }
  forEachDeformation(
      part, x, [&](std::size_t b, const std::int32_t* elements, const double* F, const TangentDrift* drifts) {
        const std::size_t points = part.blocks()[b]->rule().points.size();
        double value[lanes], reach[lanes];
        bound.elementValues(static_cast<std::int32_t>(b), elements, x, value);
        strainNormBounds(part, bound, static_cast<std::int32_t>(b), elements, reach);
        for (int lane = 0; lane < lanes; ++lane) {
          if (elements[lane] < 0) continue;
          const std::size_t whole = at(numbers[b][at(elements[lane])]);
          const TangentDriftCoefficients<double>& drift = drifts[lane].law;
          Growth& growth = known_[b].growth[whole];
          growth.value = value[lane];
          growth.linear =
              roundedUp(2 * std::sqrt((value[lane] + reach[lane] * drift.negative) * drift.kappa * reach[lane]) +
                        reach[lane] * drift.linear);
          growth.quadratic = roundedUp(reach[lane] * (drift.kappa + drift.quadratic));
          growth.radius = static_cast<float>(std::min(drift.radius * (1 - 1e-6), 1e30));
          for (std::size_t q = 0; q < points; ++q)
            for (std::size_t i = 0; i < 9; ++i)
              known_[b].anchor[(whole * points + q) * 9 + i] =
                  static_cast<float>(F[(9 * q + i) * lanes + static_cast<std::size_t>(lane)]);
        }
      });
  last_.evaluations += static_cast<std::int64_t>(part.mesh().elementCount());
}

void KeptSelection::lookAtAll(const Body& body, const NodeVectors& x) {
  now_.resize(known_.size());
  for (std::size_t b = 0; b < known_.size(); ++b) now_[b].assign(known_[b].growth.size(), {});
  forEachDeformation(
      body, x, [&](std::size_t b, const std::int32_t* elements, const double* gradients, const TangentDrift*) {
        const ElementBlock& block = *body.blocks()[b];
        const std::size_t points = block.rule().points.size();
        for (int lane = 0; lane < lanes; ++lane) {
          if (elements[lane] < 0) continue;
          const Growth& growth = known_[b].growth[at(elements[lane])];
          Now& now = now_[b][at(elements[lane])];
          now.value = std::numeric_limits<double>::infinity();
          if (growth.radius < 0) continue;
          const float* anchor = known_[b].anchor.data() + at(elements[lane]) * points * 9;
          const auto before = [&](std::size_t q) {
            return Eigen::Map<const Eigen::Matrix<float, 3, 3, Eigen::RowMajor>>(anchor + 9 * q).cast<double>().eval();
          };
          bool turns = block.material().info().objective;
          for (const std::int32_t node : block.nodesOf(elements[lane]))
            turns = turns && body.constraints().freeComponents(node) % 3 == 0;
          if (turns) {
            Eigen::Matrix3d product = Eigen::Matrix3d::Zero();
            for (std::size_t q = 0; q < points; ++q) product += gradientAt(gradients, q, lane) * before(q).transpose();
            now.R = rotationOf(product);
          }
          double distance = 0;
          for (std::size_t q = 0; q < points; ++q) {
            const Eigen::Matrix3d F = gradientAt(gradients, q, lane);
            // The one before is rounded to single precision.
            const double here = (F - now.R * before(q)).norm() + 1e-7 * before(q).norm();
            distance = here <= distance ? distance : here;  // NaN is kept
          }
          if (distance <= static_cast<double>(growth.radius))
            now.value = growth.value + distance * (static_cast<double>(growth.linear) +
                                                   distance * static_cast<double>(growth.quadratic));
        }
      });
}

void KeptSelection::sumAt(const Body& body, const std::vector<std::int32_t>& nodes) {
  parallelFor(
      0, static_cast<std::int64_t>(nodes.size()), body.threads(),
      [&](std::int64_t k) {
        const std::int32_t node = nodes[static_cast<std::size_t>(k)];
        Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
        for (const ElementRef e : elementsAt(node)) {
          if (last_.chosen[at(e.block)][at(e.element)]) continue;
          const auto own = body.blocks()[at(e.block)]->nodesOf(e.element);
          const auto a = static_cast<std::size_t>(std::find(own.begin(), own.end(), node) - own.begin());
          const Now& now = now_[at(e.block)][at(e.element)];
          sum += now.value * (now.R * NodalBound::shapeOf(last_.shapes[at(e.block)][at(e.element) * own.size() + a]) *
                              now.R.transpose());
        }
        last_.nodalSums[at(node)] = freePart(body, node, sum);
      },
      256);
}

std::vector<std::int32_t> KeptSelection::hotNodes(const Body& body, const std::vector<std::int32_t>& among,
                                                  double lambda) const {
  std::vector<std::uint8_t> hot(among.size(), 0);
  parallelFor(
      0, static_cast<std::int64_t>(among.size()), body.threads(),
      [&](std::int64_t k) {
        const std::int32_t node = among[static_cast<std::size_t>(k)];
        const Eigen::Matrix3d& sum = last_.nodalSums[at(node)];
        hot[static_cast<std::size_t>(k)] =
            !sum.allFinite() || !(largest(sum) <= lambda * (1 - 0.5 * selectionSlack) * body.lumpedMass()[node]);
      },
      256);
  std::vector<std::int32_t> result;
  for (std::size_t k = 0; k < among.size(); ++k)
    if (hot[k]) result.push_back(among[k]);
  return result;
}

void KeptSelection::evaluateAtX(const Body& body, const NodeVectors& x, const ElementFlags& elements) {
  const Body part(body, elements);
  const Numbers numbers = elementNumbers(elements);
  NodalShapes shapes(numbers.size());
  for (std::size_t b = 0; b < numbers.size(); ++b) {
    const auto n = at(body.blocks()[b]->element().nodes);
    for (const std::int32_t e : numbers[b]) {
      Now& now = now_[b][at(e)];
      for (std::size_t a = 0; a < n; ++a) {
        const Eigen::Matrix3d D = now.R * NodalBound::shapeOf(last_.shapes[b][at(e) * n + a]) * now.R.transpose();
        shapes[b].push_back(NodalBound::factorOf(D));
      }
    }
  }
  learn(part, x, numbers, shapes);
  for (const ElementRef e : chosenElements(elements)) judged_[at(e.block)][at(e.element)] = true;
  for (std::size_t b = 0; b < numbers.size(); ++b)
    for (const std::int32_t e : numbers[b])
      now_[b][at(e)] = {known_[b].growth[at(e)].value, Eigen::Matrix3d::Identity()};
}

bool KeptSelection::chooseAround(const Body& body, const NodeVectors& x, double lambda, const ElementFlags& keep,
                                 const ElementFlags& core) {
  ElementFlags region = noElements(body.mesh());
  std::size_t count = 0;
  for (const std::int32_t node : nodesOf(body, core))
    for (const ElementRef e : elementsAt(node))
      if (!keep[at(e.block)][at(e.element)] && !region[at(e.block)][at(e.element)]) {
        region[at(e.block)][at(e.element)] = true;
        ++count;
      }
  if (5 * count > 4 * body.mesh().elementCount()) return false;
  for (const ElementRef e : chosenElements(region)) judged_[at(e.block)][at(e.element)] = true;
  // All others, and what they use of lambda.
  for (const ElementRef e : chosenElements(region)) last_.chosen[at(e.block)][at(e.element)] = true;
  const std::vector<std::int32_t> nodes = nodesOf(body, region);
  sumAt(body, nodes);
  std::vector<Eigen::Matrix3d> outside;
  NodeVectors own(3, static_cast<Eigen::Index>(nodes.size()));
  Eigen::VectorXd mass(static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    outside.push_back(last_.nodalSums[at(nodes[i])]);
    own.col(static_cast<Eigen::Index>(i)) = x.col(nodes[i]);
    mass[static_cast<Eigen::Index>(i)] = body.lumpedMass()[nodes[i]];
  }
  const Body part = bodyOf(body, region, nodes, mass);
  const CertifiedSelection made = selectCertified(part, own, lambda, {}, outside);
  last_.evaluations += made.evaluations;
  const Numbers numbers = elementNumbers(region);
  learn(part, own, numbers, made.shapes);
  for (std::size_t b = 0; b < numbers.size(); ++b)
    for (std::size_t i = 0; i < numbers[b].size(); ++i) {
      const auto e = at(numbers[b][i]);
      last_.chosen[b][e] = made.chosen[b][i];
      now_[b][e] = {known_[b].growth[e].value, Eigen::Matrix3d::Identity()};
    }
  sumAt(body, nodes);
  return true;
}

void KeptSelection::indexNodes(const Body& body) {
  firstAt_.assign(at(body.nodeCount()) + 1, 0);
  const auto forEachIncidence = [&](const auto& visit) {
    for (std::size_t b = 0; b < known_.size(); ++b)
      for (std::int32_t e = 0; e < body.blocks()[b]->elementCount(); ++e)
        for (const std::int32_t node : body.blocks()[b]->nodesOf(e)) visit(node, ElementRef{static_cast<int>(b), e});
  };
  forEachIncidence([&](std::int32_t node, ElementRef) { ++firstAt_[at(node) + 1]; });
  for (std::size_t i = 1; i < firstAt_.size(); ++i) firstAt_[i] += firstAt_[i - 1];
  elementsAt_.resize(firstAt_.back());
  std::vector<std::size_t> next = firstAt_;
  forEachIncidence([&](std::int32_t node, ElementRef e) { elementsAt_[next[at(node)]++] = e; });
}

const CertifiedSelection& KeptSelection::choose(const Body& body, const NodeVectors& x, double lambda,
                                                const ElementFlags& keep) {
  if (!(lambda > 0)) throw InputError(joinText("selection: lambda = ", lambda, " rad2/s2 must be > 0"));
  if (!knows(body)) {
    start(body, x, lambda, keep);
    return last_;
  }
  last_.evaluations = 0;
  judged_ = noElements(body.mesh());
  indexNodes(body);
  // New elements are judged with their neighbours in any case, and count for nothing until then.
  ElementFlags core = judged_;
  for (std::size_t b = 0; b < core.size(); ++b)
    for (std::size_t e = 0; e < core[b].size(); ++e) {
      core[b][e] = !keep[b][e] && !last_.chosen[b][e] && known_[b].growth[e].radius < 0;
      if (keep[b][e] || core[b][e]) last_.chosen[b][e] = true;
    }
  const auto all = allNodes(body);
  last_.nodalSums.resize(all.size());
  lookAtAll(body, x);
  sumAt(body, all);
  const auto explicitElementsAt = [&](const std::vector<std::int32_t>& nodes) {
    ElementFlags flags = noElements(body.mesh());
    for (const std::int32_t node : nodes)
      for (const ElementRef e : elementsAt(node))
        flags[at(e.block)][at(e.element)] = !last_.chosen[at(e.block)][at(e.element)];
    return flags;
  };
  if (const auto hot = hotNodes(body, all, lambda); !hot.empty()) {
    const ElementFlags doubtful = explicitElementsAt(hot);
    evaluateAtX(body, x, doubtful);
    const auto nodes = nodesOf(body, doubtful);
    sumAt(body, nodes);
    for (const ElementRef e : chosenElements(explicitElementsAt(hotNodes(body, nodes, lambda))))
      core[at(e.block)][at(e.element)] = true;
  }
  if (!chosenElements(core).empty() && !chooseAround(body, x, lambda, keep, core)) {
    const std::int64_t before = last_.evaluations;
    start(body, x, lambda, keep);
    last_.evaluations += before;
    return last_;
  }
  last_.rest = {0};
  for (std::int32_t i = 0; i < body.nodeCount(); ++i)
    last_.rest.value = std::max(last_.rest.value, largest(last_.nodalSums[at(i)]) / body.lumpedMass()[i]);
  now_.clear();
  firstAt_ = std::vector<std::size_t>();
  elementsAt_ = std::vector<ElementRef>();
  return last_;
}

void KeptSelection::carryOver(const CutMesh& cut) {
  if (known_.empty()) return;
  last_.chosen = carriedOver(cut, last_.chosen);
  for (std::size_t b = 0; b < known_.size(); ++b) {
    const std::size_t before = known_[b].growth.size(), count = cut.parent[b].size();
    const std::size_t nodes = before == 0 ? 0 : last_.shapes[b].size() / before,
                      numbers = before == 0 ? 0 : known_[b].anchor.size() / before;
    Known known;
    known.growth.resize(count);
    known.anchor.resize(count * numbers);
    std::vector<NodalBound::Factor> shapes(count * nodes);
    for (std::size_t e = 0; e < count; ++e) {
      if (cut.changed[b][e]) continue;
      const auto from = at(cut.parent[b][e]);
      known.growth[e] = known_[b].growth[from];
      std::copy_n(known_[b].anchor.begin() + static_cast<std::ptrdiff_t>(from * numbers), numbers,
                  known.anchor.begin() + static_cast<std::ptrdiff_t>(e * numbers));
      std::copy_n(last_.shapes[b].begin() + static_cast<std::ptrdiff_t>(from * nodes), nodes,
                  shapes.begin() + static_cast<std::ptrdiff_t>(e * nodes));
    }
    known_[b] = std::move(known);
    last_.shapes[b] = std::move(shapes);
  }
}

}  // namespace ringwatch

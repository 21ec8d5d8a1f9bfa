#include <ringwatch/handlers/selection/selection.h>

#include <algorithm>
#include <cmath>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/rounding.h>
#include <ringwatch/body/sub_body.h>
#include <ringwatch/handlers/selection/certified_selection.h>
#include <ringwatch/monitor/bounds/reduced_ring.h>
#include <ringwatch/monitor/metrics/element_metrics.h>

namespace ringwatch {

ElementFlags noElements(const Mesh& mesh) {
  ElementFlags flags;
  for (const MeshBlock& block : mesh.blocks) flags.emplace_back(block.elementCount(), false);
  return flags;
}

std::vector<ElementRef> chosenElements(const ElementFlags& flags) {
  std::vector<ElementRef> elements;
  for (std::size_t b = 0; b < flags.size(); ++b)
    for (std::size_t e = 0; e < flags[b].size(); ++e)
      if (flags[b][e]) elements.push_back({b, e});
  return elements;
}

ElementFlags complement(ElementFlags flags) {
  for (std::vector<bool>& block : flags) block.flip();
  return flags;
}

Body copyOf(const Body& body) { return {body, complement(noElements(body.mesh()))}; }

std::vector<std::vector<std::int32_t>> elementNumbers(const ElementFlags& flags) {
  std::vector<std::vector<std::int32_t>> numbers(flags.size());
  for (const ElementRef e : chosenElements(flags)) numbers[e.block].push_back(e.element);
  return numbers;
}

std::vector<bool> touchedNodes(const Body& body, const ElementFlags& elements) {
  std::vector<bool> touched(body.nodeCount(), false);
  for (const ElementRef e : chosenElements(elements))
    for (const std::int32_t node : body.blocks()[e.block]->nodesOf(e.element)) touched[node] = true;
  return touched;
}

std::vector<std::int32_t> nodesOf(const Body& body, const ElementFlags& elements) {
  const std::vector<bool> touched = touchedNodes(body, elements);
  std::vector<std::int32_t> nodes;
  for (std::int32_t i = 0; i < body.nodeCount(); ++i)
    if (touched[i]) nodes.push_back(i);
  return nodes;
}

Body bodyOf(const Body& body, const ElementFlags& flags, std::span<const std::int32_t> nodes,
            const Eigen::VectorXd& mass) {
  return subBody(body, chosenElements(flags), nodes, mass, body.threads());
}

namespace {

/// Calls visit(block, element, value) with the highest eigenvalues of the reduced 1-rings of some elements; all when
/// candidates is empty.
template <class Visit>
void forEachReducedRing(const Body& body, const NodeVectors& x, const ElementFlags& candidates, const Visit& visit) {
  if (candidates.empty()) {
    ReducedRing rings(body);
    const auto& largest = rings.evaluate(x).largest;
    for (std::size_t b = 0; b < largest.size(); ++b)
      for (std::size_t e = 0; e < largest[b].size(); ++e) visit(b, e, largest[b][e]);
    return;
  }
  // A ring is made of all elements at the nodes of its own: with these, a part of the body has the same rings.
  const std::vector<bool> near = touchedNodes(body, candidates);
  ElementFlags around = noElements(body.mesh());
  for (std::size_t b = 0; b < around.size(); ++b)
    for (std::size_t e = 0; e < around[b].size(); ++e) {
      const auto nodes = body.blocks()[b]->nodesOf(e);
      around[b][e] = std::any_of(nodes.begin(), nodes.end(), [&](std::int32_t n) { return near[n]; });
    }
  if (chosenElements(around).empty()) return;
  const auto numbers = elementNumbers(around);
  const Body part(body, around);
  ReducedRing rings(part);
  const auto& largest = rings.evaluate(x).largest;
  for (std::size_t b = 0; b < largest.size(); ++b)
    for (std::size_t e = 0; e < largest[b].size(); ++e) {
      const std::size_t whole = numbers[b][e];
      if (candidates[b][whole]) visit(b, whole, largest[b][e]);
    }
}

}  // namespace

ElementFlags selectByReducedRing(const Body& body, const NodeVectors& x, double lambda,
                                 const ElementFlags& candidates) {
  if (!(lambda > 0)) throw InputError(joinText("selection: lambda = ", lambda, " rad2/s2 must be > 0"));
  ElementFlags flags = noElements(body.mesh());
  forEachReducedRing(body, x, candidates,
                     [&](std::size_t b, std::size_t e, double value) { flags[b][e] = !(value <= lambda); });
  return flags;
}

LowerBound highestReducedRing(const Body& body, const NodeVectors& x, const ElementFlags& candidates) {
  LowerBound highest{0};
  forEachReducedRing(body, x, candidates, [&](std::size_t, std::size_t, double value) {
    if (!std::isnan(highest.value) && !(value <= highest.value)) highest.value = value;  // NaN stays
  });
  return highest;
}

ElementFlags carriedOver(const CutMesh& cut, const ElementFlags& before) {
  ElementFlags after = cut.changed;
  for (std::size_t b = 0; b < after.size(); ++b)
    for (std::size_t e = 0; e < after[b].size(); ++e) after[b][e] = !cut.changed[b][e] && before[b][cut.parent[b][e]];
  return after;
}

ElementFlags selectBySingleElement(const Body& body, const NodeVectors& x, double lambda) {
  if (!(lambda > 0)) throw InputError(joinText("lambda ", lambda, ": must be > 0"));
  const std::vector<std::vector<double>> highest = singleElement(body, x);
  ElementFlags flags = noElements(body.mesh());
  for (std::size_t b = 0; b < flags.size(); ++b)
    for (std::size_t e = 0; e < flags[b].size(); ++e)
      flags[b][e] = !(highest[b][e] <= lambda * (1 - selectionRounding));
  return flags;
}

}  // namespace ringwatch

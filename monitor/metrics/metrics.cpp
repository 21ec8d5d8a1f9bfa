#include <ringwatch/monitor/metrics/metrics.h>

#include <algorithm>
#include <cmath>

#include <ringwatch/base/registry.h>
#include <ringwatch/monitor/bounds/nodal_bound.h>
#include <ringwatch/monitor/bounds/reduced_ring.h>
#include <ringwatch/monitor/metrics/element_metrics.h>
#include <ringwatch/monitor/metrics/wave_metrics.h>

namespace ringwatch {
namespace {

using Values = MetricValues;

Values reducedRing(const Body& body, NodeVectorsView x, const MetricProgress&) {
  ReducedRing ring(body);
  return ring.evaluate(x).largest;
}

/// The nodal bound at each element's highest node.
Values nodalBound(const Body& body, NodeVectorsView x, const MetricProgress&) {
  NodalBound bound(body);
  constexpr int sweeps = 20;
  const double best = bound.evaluate(x, sweeps).value;
  Values values;
  for (const auto& block : body.blocks()) values.emplace_back(static_cast<std::size_t>(block->elementCount()));
  // Nodal values of the last sweep lie about the best bound; none is shown above it.
  for (std::size_t b = 0; b < values.size(); ++b)
    for (std::size_t e = 0; e < values[b].size(); ++e)
      for (std::int32_t node : body.blocks()[b]->nodesOf(e))
        values[b][e] = std::max(values[b][e], std::min(best, bound.nodal()[node]));
  double top = 0;
  for (const auto& block : values)
    for (double value : block) top = std::max(top, value);
  for (auto& block : values)
    for (double& value : block)
      if (value == top) value = best;
  return values;
}

// A metric that needs no word on its progress, and one with an option, as the table takes them.
template <Values (*metric)(const Body&, NodeVectorsView)>
Values plain(const Body& body, NodeVectorsView x, const MetricProgress&) {
  return metric(body, x);
}
template <CharacteristicLength length>
Values wave(const Body& body, NodeVectorsView x, const MetricProgress&) {
  return pressureWave(body, x, length);
}
template <RingKind kind>
Values ring(const Body& body, NodeVectorsView x, const MetricProgress& progress) {
  return ringEigenvalues(body, x, kind, progress);
}

/// Keeps the pattern of the matrix: half of the cost.
class ReducedRingsAlong final : public MetricEvaluator {
 public:
  explicit ReducedRingsAlong(const Body& body) : ring_(body) {}
  const Values& evaluate(NodeVectorsView x) override { return ring_.evaluate(x).largest; }

 private:
  ReducedRing ring_;
};

/// Keeps nothing.
class FromScratch final : public MetricEvaluator {
 public:
  FromScratch(std::string_view name, const Body& body) : name_(name), body_(body) {}
  const Values& evaluate(NodeVectorsView x) override { return values_ = evaluateMetric(name_, body_, x).elementLambda; }

 private:
  std::string name_;
  const Body& body_;
  Values values_;
};

using enum Direction;
/// Every metric of the library, one entry each.
const MetricEntry entriesOfLibrary[] = {
    {{"single-element", "every element on its own, with its own mass", upperBound}, plain<singleElement>},
    {{"pressure-wave", "a pressure wave crossing the element's least height", estimate},
     wave<CharacteristicLength::usual>},
    {{"pressure-wave:min-height", "crossing the least extent over a face", estimate},
     wave<CharacteristicLength::minHeight>},
    {{"pressure-wave:volume-over-area", "crossing volume over largest face (Miller)", estimate},
     wave<CharacteristicLength::volumeOverArea>},
    {{"pressure-wave:in-radius", "crossing the inscribed sphere's radius", estimate},
     wave<CharacteristicLength::inRadius>},
    {{"pressure-wave:shortest-edge", "crossing the shortest edge (Debunne)", estimate},
     wave<CharacteristicLength::shortestEdge>},
    {{"pressure-wave:cell-diameter", "crossing the largest distance of two corners (FEniCS)", estimate},
     wave<CharacteristicLength::cellDiameter>},
    {{"pressure-wave:calculix", "crossing 0.7669 k V / max A, CalculiX's step for *DYNAMIC, EXPLICIT", estimate},
     wave<CharacteristicLength::calculix>},
    {{"pressure-wave:nodal", "mass-weighted mean of pressure-wave at a node, Radioss' nodal step", estimate},
     plain<pressureWaveAtNodes>},
    {{"dilatational-mode", "an element's mean divergence alone (Flanagan & Belytschko)", estimate},
     plain<dilatationalMode>},
    {{"fried", "largest element stiffness over least nodal mass, times the largest valence", upperBound}, plain<fried>},
    {{"fried-lower", "largest element stiffness over largest nodal mass", lowerBound}, plain<friedLower>},
    {{"shewchuk", "element with the mesh's nodal masses, times the largest valence", upperBound}, plain<shewchuk>},
    {{"shewchuk-lower", "element with the mesh's nodal masses", lowerBound}, plain<shewchukLower>},
    {{"vertex-1-ring", "the elements at a node as a body of their own; an upper bound if all have as many nodes",
      estimate},
     ring<RingKind::vertex1>,
     vertexRingsAreUpperBound},
    {{"vertex-2-ring", "the elements at the nodes of the vertex 1-ring", estimate}, ring<RingKind::vertex2>},
    {{"element-1-ring", "the elements at an element's nodes as a body of their own", estimate},
     ring<RingKind::element1>},
    {{"element-2-ring", "the elements at the nodes of the element 1-ring", estimate}, ring<RingKind::element2>},
    {{"reduced-1-ring", "assembled stiffness cut to the element's own nodes", lowerBound},
     reducedRing,
     nullptr,
     [](const Body& body) -> std::unique_ptr<MetricEvaluator> { return std::make_unique<ReducedRingsAlong>(body); }},
    {{"reduced-2-ring", "assembled stiffness cut to the nodes of the element 1-ring", lowerBound},
     ring<RingKind::reduced2>},
    {{"nodal-bound", "proven bound by 3x3 weights summed at nodes", upperBound}, nodalBound},
};

Registry<MetricEntry>& registry() {
  static Registry<MetricEntry> metrics("metric", entriesOfLibrary);
  return metrics;
}

/// Throws InputError for an unknown name.
const MetricEntry& entryOf(std::string_view name) {
  if (const MetricEntry* entry = registry().find(name)) return *entry;
  throw InputError(joinText("metric \"", name, "\": must be one of ", knownMetrics(name)));
}

}  // namespace

std::span<const MetricInfo> allMetrics() { return registry().infos(); }
void registerMetric(const MetricEntry& entry) { registry().add(entry); }

std::unique_ptr<MetricEvaluator> makeMetricEvaluator(std::string_view name, const Body& body) {
  const MetricEntry& entry = entryOf(name);
  return entry.along ? entry.along(body) : std::make_unique<FromScratch>(name, body);
}

double MetricEvaluator::highest(NodeVectorsView x) {
  double highest = 0;
  for (const auto& block : evaluate(x))
    for (const double value : block) {
      if (std::isnan(value)) return value;
      highest = std::max(highest, value);
    }
  return highest;
}

Direction metricDirection(std::string_view name, const Body& body) {
  const MetricEntry& entry = entryOf(name);
  if (entry.isUpperBoundOn && entry.isUpperBoundOn(body)) return Direction::upperBound;
  // A lower bound of all motions is none of those that leave bodies rigid, but for rings without their nodes.
  const bool ties = !body.constraints().rigidBodies().empty();
  return ties && entry.info.direction == Direction::lowerBound && name != "reduced-1-ring" ? Direction::estimate
                                                                                           : entry.info.direction;
}

const MetricInfo* findMetric(std::string_view name) { return registry().findInfo(name); }

MetricResult evaluateMetric(std::string_view name, const Body& body, NodeVectorsView x,
                            const MetricProgress& progress) {
  const MetricEntry& entry = entryOf(name);
  MetricResult result{findMetric(name), metricDirection(name, body), 0, {}, entry.evaluate(body, x, progress)};
  bool first = true;
  for (std::size_t b = 0; b < result.elementLambda.size(); ++b)
    for (std::size_t e = 0; e < result.elementLambda[b].size(); ++e)
      // NaN, an element without a tangent, stays once it was met.
      if (first || result.elementLambda[b][e] > result.lambda || std::isnan(result.elementLambda[b][e])) {
        result.lambda = result.elementLambda[b][e];
        result.controlling = {b, e};
        first = false;
      }
  return result;
}

std::string knownMetrics(std::string_view name) {
  const std::string_view family = name.substr(0, name.find(':') + 1);  // "" without an option
  std::string all, options;
  for (const MetricInfo& info : allMetrics()) {
    all += joinText(all.empty() ? "" : ", ", info.name);
    if (!family.empty() && info.name.starts_with(family)) options += joinText(options.empty() ? "" : ", ", info.name);
  }
  return options.empty() ? all : options;
}

}  // namespace ringwatch

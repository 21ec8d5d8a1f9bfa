#pragma once
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <ringwatch/body/body.h>
#include <ringwatch/monitor/bounds.h>
#include <ringwatch/monitor/metrics/rings.h>

namespace ringwatch {

/// A way to put a number on the highest frequency, element by element.
struct MetricInfo {
  std::string_view name;
  std::string_view help;
  Direction direction;  // of the largest element value, against the highest eigenvalue of any whole body
};

using MetricValues = std::vector<std::vector<double>>;  // [block][element], rad²/s²

/// A metric along a run, which may keep from one evaluation to the next what does not depend on the positions.
class MetricEvaluator {
 public:
  virtual ~MetricEvaluator() = default;
  /// The values of all elements at positions x (3×N, m); valid until the next call.
  virtual const MetricValues& evaluate(NodeVectorsView x) = 0;
  /// The largest of them, at least 0; NaN where an element has no tangent.
  double highest(NodeVectorsView x);
};

/// A metric that can be evaluated by name.
struct MetricEntry {
  MetricInfo info;
  /// Computes the values of all elements at positions x (3×N, m).
  MetricValues (*evaluate)(const Body& body, NodeVectorsView x, const MetricProgress& progress);
  /// Whether an estimate that is an upper bound on some bodies is one on this. nullptr: on none.
  bool (*isUpperBoundOn)(const Body& body) = nullptr;
  /// Along a run; the body outlives it. nullptr: `evaluate` each time.
  std::unique_ptr<MetricEvaluator> (*along)(const Body& body) = nullptr;
};

struct MetricResult {
  const MetricInfo* info;
  Direction direction;     // on this body: info's, or a proven side where its elements allow it
  double lambda;           // largest element value, rad²/s²
  ElementRef controlling;  // where
  MetricValues elementLambda;
};

/// All metrics, one line each in metrics.cpp, and those that were registered.
std::span<const MetricInfo> allMetrics();
/// Adds one; call it when the program starts, before any is asked for. Throws InputError when the name is taken.
void registerMetric(const MetricEntry& entry);
const MetricInfo* findMetric(std::string_view name);
/// Evaluates a metric at positions x (3×N, m), and tells those that take long how far they are. Constrained degrees of
/// freedom are left out. Throws InputError for an unknown name.
MetricResult evaluateMetric(std::string_view name, const Body& body, NodeVectorsView x,
                            const MetricProgress& progress = {});
/// The direction in which a metric errs on this body: MetricInfo's, or a proven side where its elements allow it, as of
/// vertex 1-rings (Theorem 4, docs/theory/eigenvalue_bounds.md). Throws InputError for an unknown name.
Direction metricDirection(std::string_view name, const Body& body);
/// A metric along a run; the body outlives it. Throws InputError for an unknown name.
std::unique_ptr<MetricEvaluator> makeMetricEvaluator(std::string_view name, const Body& body);
/// The names to choose from instead of one that `findMetric` does not know, separated by commas: those of its family
/// for a name such as "pressure-wave:height", else all.
std::string knownMetrics(std::string_view name);

}  // namespace ringwatch

#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <ringwatch/body/body.h>
#include <ringwatch/monitor/bounds.h>
#include <ringwatch/monitor/rings.h>

namespace ringwatch {

/// A way to put a number on the highest frequency, element by element.
struct MetricInfo {
  std::string_view name;
  std::string_view help;
  Direction direction;  // of the largest element value, against the highest eigenvalue of any whole body
};

struct MetricResult {
  const MetricInfo* info;
  Direction direction;                             // on this body: info's, or a proven side where its elements allow it
  double lambda;                                   // largest element value, rad²/s²
  ElementRef controlling;                          // where
  std::vector<std::vector<double>> elementLambda;  // [block][element], rad²/s²
};

/// All metrics, one line each in metrics.cpp.
std::span<const MetricInfo> allMetrics();
const MetricInfo* findMetric(std::string_view name);
/// Evaluates a metric at positions x (3×N, m), and tells those that take long how far they are. Constrained degrees of
/// freedom are left out. Throws InputError for an unknown name.
MetricResult evaluateMetric(std::string_view name, const Body& body, const NodeVectors& x,
                            const MetricProgress& progress = {});
/// The names to choose from instead of one that `findMetric` does not know, separated by commas: those of its family
/// for a name such as "pressure-wave:height", else all.
std::string knownMetrics(std::string_view name);

}  // namespace ringwatch

#pragma once
#include <span>
#include <string_view>
#include <vector>

#include <ringwatch/body/body.h>
#include <ringwatch/monitor/bounds.h>

namespace ringwatch {

/// A way to put a number on the highest frequency, element by element.
struct MetricInfo {
  std::string_view name;
  std::string_view help;
  Direction direction;  // of the largest element value, against the highest eigenvalue of the whole body
};

struct MetricResult {
  const MetricInfo* info;
  double lambda;                                   // largest element value, rad²/s²
  ElementRef controlling;                          // where
  std::vector<std::vector<double>> elementLambda;  // [block][element], rad²/s²
};

/// All metrics, one line each in metrics.cpp.
std::span<const MetricInfo> allMetrics();
const MetricInfo* findMetric(std::string_view name);
/// Evaluates a metric at positions x (3×N, m). Constrained degrees of freedom are left out. Throws InputError for an
/// unknown name.
MetricResult evaluateMetric(std::string_view name, const Body& body, const NodeVectors& x);

}  // namespace ringwatch

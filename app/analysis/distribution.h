#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <ringwatch/meshes/quality.h>
#include <ringwatch/monitor/metrics/metrics.h>
#include <ringwatch/monitor/step_limit.h>

namespace ringwatch {

/// How a metric's steps spread over the elements of a mesh (figs. 3.6 and 3.7 of Fierz 2013).
struct Distribution {
  std::string metric;
  std::vector<double> edges;        // s, of the histogram's bins, equal on a logarithmic scale; one more than counts;
                                    // the same for all metrics of a report
  std::vector<std::size_t> counts;  // elements with edges[i] <= step < edges[i + 1], in the last bin <=
  std::size_t atEnd = 0;            // elements in the last bin whose step is its upper edge
  std::size_t without = 0;          // elements without a finite positive step, in no bin
  std::vector<double> steps;        // s, finite ones

  /// Share of all elements that forbid a step h (s) by this metric, 0 to 1: their own step is below h.
  double critical(double h) const;
  /// The same at edges[i], from the counts.
  double criticalAtEdge(std::size_t i) const;
};
/// The steps of all elements by a metric, s, in any order.
struct ElementSteps {
  std::string metric;
  std::vector<double> steps;
};
/// The distributions of several metrics on common bins.
std::vector<Distribution> distributionsOf(std::vector<ElementSteps> metrics);
/// rule: makes a step of an eigenvalue.
std::vector<Distribution> distributionsOf(const std::vector<MetricResult>& metrics, const StepRule& rule);
nlohmann::ordered_json distributionJson(const std::vector<Distribution>& distributions);
/// A table of the share of critical elements at a few steps, and at h when one is given; bars for the histograms.
std::string distributionText(const std::vector<Distribution>& distributions, std::optional<double> h);

/// An element that limits the step, with its shape.
struct WorstElement {
  ElementRef element;
  double step;  // s
  ElementShape shape;
};
/// The `count` elements of the least steps, least first.
std::vector<WorstElement> worstElements(const Body& body, const MetricResult& metric, const StepRule& rule,
                                        std::size_t count);
nlohmann::ordered_json worstJson(const Mesh& mesh, const std::vector<WorstElement>& worst);
std::string worstText(const std::vector<WorstElement>& worst);

/// Steps that a picture marks, s.
struct StepMarks {
  double safe = 0, optimistic = 0;
  std::optional<double> step;  // the one asked about
};

/// Throws InputError unless the name ends in .svg or .png.
void checkPictureName(const std::filesystem::path& file);
/// Draws histograms and cumulative shares by gnuplot; its script and data stay beside the picture, as FILE.gp and
/// FILE.dat. Returns a line on what was written, or why there is no picture. Throws InputError when nothing can be
/// written.
std::string drawDistribution(const std::filesystem::path& file, const std::vector<Distribution>& distributions,
                             const StepMarks& marks, const std::string& title);

}  // namespace ringwatch

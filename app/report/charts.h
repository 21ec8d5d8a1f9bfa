#pragma once
#include <string>
#include <vector>

#include <ringwatch/app/analysis/distribution.h>
#include <ringwatch/app/report/mesh_pack.h>
#include <ringwatch/app/report/run_history.h>
#include <ringwatch/verify/report.h>

namespace ringwatch {

/// Moments that the history's picture marks.
struct ChartMark {
  double time = 0;  // s
  std::string label;
};

/// Safe, optimistic and actual step against time as SVG; "" for a history without such rows.
std::string historySvg(const RunHistory& history, const std::vector<ChartMark>& marks);

/// Histograms of the elements' steps, a row a metric on one logarithmic axis, with the steps of the marks as lines; ""
/// where there is nothing finite. h: 0 for none.
std::string distributionSvg(const std::vector<Distribution>& distributions, const StepMarks& marks);

/// The curves of a study; "" where none has a point that can be drawn.
std::string figureSvg(const StudyFigure& figure);

/// An element seen from the side on which it looks largest.
std::string elementSvg(const WorstCard& card);

}  // namespace ringwatch

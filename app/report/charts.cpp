#include <ringwatch/app/report/charts.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <Eigen/Dense>

#include <ringwatch/app/report/page_data.h>
#include <ringwatch/app/report/verdict_text.h>
#include <ringwatch/base/infinity.h>

namespace ringwatch {
namespace {

/// A linear or logarithmic axis from values to pixels.
struct Axis {
  double least, largest, begin, end;
  bool logarithmic = false;

  double operator()(double value) const {
    const auto map = [this](double v) { return logarithmic ? std::log(v) : v; };
    const double range = map(largest) - map(least);
    return begin + (range > 0 ? (map(value) - map(least)) / range : 0.5) * (end - begin);
  }
  /// Values for labels, at most about `count`.
  std::vector<double> ticks(int count) const {
    std::vector<double> result;
    if (!(largest > least)) return {least};
    if (logarithmic && largest / least > 10) {
      const int low = static_cast<int>(std::ceil(std::log10(least) - 1e-9)),
                high = static_cast<int>(std::floor(std::log10(largest) + 1e-9));
      const int stride = std::max(1, (high - low + count) / count);
      for (int power = low; power <= high; power += stride) result.push_back(std::pow(10, power));
      if (result.size() > 1) return result;
      result.clear();
    }
    const double rough = (largest - least) / count, unit = std::pow(10, std::floor(std::log10(rough)));
    double step = 10 * unit;
    for (const double factor : {1, 2, 5})
      if (factor * unit >= rough) {
        step = factor * unit;
        break;
      }
    for (double k = std::ceil(least / step); k * step <= largest * (1 + 1e-12); ++k) result.push_back(k * step);
    return result;
  }
};

/// Largest value over the largest step taken from which on the axis is logarithmic.
constexpr double logarithmicFrom = 30;

std::string line(const std::vector<double>& time, const std::vector<double>& values, const Axis& x, const Axis& y,
                 const char* name) {
  std::string path;
  bool drawing = false;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i]) || values[i] < y.least || values[i] > y.largest) {
      drawing = false;
      continue;
    }
    path += fmt::format("{}{:.1f} {:.1f}", drawing ? 'L' : 'M', x(time[i]), y(values[i]));
    drawing = true;
  }
  if (path.empty()) return {};
  // A row alone is a point.
  if (values.size() == 1) path += "h0";
  return fmt::format("<path class=\"curve {}\" d=\"{}\"/>", name, path);
}

}  // namespace

std::string historySvg(const RunHistory& all, const std::vector<ChartMark>& marks) {
  // As many rows as the picture has columns of pixels.
  constexpr std::size_t most = 3000;
  const RunHistory history = selected(all, rowsForPicture(all, most));
  const std::vector<double>*time = history.column("time_s"), *h = history.column("h_s"),
        *safe = history.column("safe_s"), *optimistic = history.column("optimistic_s");
  if (!time || !h || history.rowCount() == 0) return {};
  double least = infinity, largest = 0;
  for (const std::vector<double>* column : {h, safe, optimistic})
    if (column)
      for (const double value : *column)
        if (std::isfinite(value) && value > 0) {
          least = std::min(least, value);
          largest = std::max(largest, value);
        }
  if (!(largest > 0)) return {};
  constexpr double width = 900, height = 320, left = 84, bottom = 40, top = 34, right = 12;
  double taken = 0;
  for (const double value : *h)
    if (std::isfinite(value)) taken = std::max(taken, value);
  const bool logarithmic = largest > logarithmicFrom * taken;
  const double border = logarithmic ? std::pow(largest / least, 0.04) : 1;
  const Axis x{time->front(), time->back(), left, width - right};
  const Axis y{logarithmic ? least / border : 0, logarithmic ? largest * border : 1.08 * largest, height - bottom, top,
               logarithmic};
  std::string svg = fmt::format(
      "<svg class=\"chart\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"Safe, optimistic and actual step against "
      "time{}\">",
      width, height, logarithmic ? ", logarithmic" : "");
  for (const double tick : y.ticks(6))
    svg += fmt::format(
        "<path class=\"grid\" d=\"M{} {:.1f}H{}\"/><text class=\"tick\" x=\"{}\" y=\"{:.1f}\" "
        "text-anchor=\"end\">{:.3g}</text>",
        left, y(tick), width - right, left - 6, y(tick) + 4, tick);
  for (const double tick : x.ticks(8))
    svg += fmt::format("<text class=\"tick\" x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{:.4g}</text>", x(tick),
                       height - bottom + 18, tick);
  svg += fmt::format("<text class=\"tick\" x=\"{}\" y=\"{}\" text-anchor=\"end\">time (s)</text>", width - right,
                     height - 4);
  svg += fmt::format("<text class=\"tick\" x=\"4\" y=\"14\">step (s)</text>");
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const ChartMark& mark = marks[i];
    if (mark.time < time->front() || mark.time > time->back()) continue;
    // Marks that lie close have their numbers one below the other.
    svg += fmt::format(
        "<path class=\"mark\" d=\"M{0:.1f} {1}V{2}\"><title>{3}</title></path><text class=\"number\" x=\"{4:.1f}\" "
        "y=\"{5}\" text-anchor=\"end\">{6}</text>",
        x(mark.time), top, height - bottom, htmlText(mark.label), x(mark.time) - 3, top + 12 + 13 * (i % 3), i + 1);
  }
  if (optimistic) svg += line(*time, *optimistic, x, y, "optimistic");
  if (safe) svg += line(*time, *safe, x, y, "safe");
  svg += line(*time, *h, x, y, "taken");
  double at = 330;
  for (const auto& [name, text] : {std::pair{"safe", "safe (proven stable below)"},
                                   {"optimistic", "optimistic (proven unstable above)"},
                                   {"taken", "step taken"}}) {
    svg += fmt::format("<path class=\"curve {}\" d=\"M{} 12h22\"/><text class=\"tick\" x=\"{}\" y=\"16\">{}</text>",
                       name, at, at + 28, text);
    at += 46 + 6.4 * static_cast<double>(std::string_view(text).size());
  }
  return svg + "</svg>";
}

std::string distributionSvg(const std::vector<Distribution>& distributions, const StepMarks& marks) {
  double least = infinity, largest = 0;
  for (const Distribution& d : distributions)
    if (!d.edges.empty()) {
      least = std::min(least, d.edges.front());
      largest = std::max(largest, d.edges.back());
    }
  for (const double step : {marks.safe, marks.optimistic, marks.step.value_or(0)})
    if (std::isfinite(step) && step > 0 && std::isfinite(least)) {
      least = std::min(least, 0.97 * step);
      largest = std::max(largest, 1.03 * step);
    }
  if (!(least <= largest)) return {};
  constexpr double width = 900, left = 12, right = 12, row = 74, bars = 44, top = 30;
  const double height = top + row * static_cast<double>(distributions.size()) + 54;
  const Axis x{least, largest, left, width - right, true};
  std::string svg = fmt::format(
      "<svg class=\"chart spread\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"Histograms of the steps of elements "
      "by {} "
      "metrics; the table below has the numbers\">",
      width, height, distributions.size());
  double y = top;
  for (const Distribution& d : distributions) {
    std::size_t most = 1;
    for (const std::size_t count : d.counts) most = std::max(most, count);
    svg += fmt::format("<text class=\"tick name\" x=\"{}\" y=\"{}\">{}</text>", left, y + 16, htmlText(d.metric));
    for (std::size_t i = 0; i < d.counts.size(); ++i) {
      if (d.counts[i] == 0) continue;
      // Logarithmic counts: a single element is to be seen beside a million.
      const double share = std::log1p(static_cast<double>(d.counts[i])) / std::log1p(static_cast<double>(most));
      svg += fmt::format(
          "<rect class=\"bar\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"><title>{}: {} elements "
          "from "
          "{:.4g} to {:.4g} s</title></rect>",
          x(d.edges[i]), y + row - 6 - bars * share, std::max(1.0, x(d.edges[i + 1]) - x(d.edges[i]) - 0.5),
          bars * share, htmlText(d.metric), d.counts[i], d.edges[i], d.edges[i + 1]);
    }
    svg += fmt::format("<path class=\"grid\" d=\"M{} {:.1f}H{}\"/>", left, y + row - 6, width - right);
    y += row;
  }
  double label = left;
  for (const auto& [name, text, step, shown] :
       {std::tuple{"safe", "safe", marks.safe, stepRoundedDown(marks.safe)},
        std::tuple{"optimistic", "optimistic", marks.optimistic, stepRoundedUp(marks.optimistic)},
        std::tuple{"taken", "step taken", marks.step.value_or(0), fmt::format("{:.4g}", marks.step.value_or(0))}}) {
    if (!(step > 0) || !std::isfinite(step)) continue;
    svg += fmt::format("<path class=\"curve {}\" d=\"M{:.1f} {}V{:.1f}\"><title>{} {} s</title></path>", name, x(step),
                       top - 4, y - 6, text, shown);
    svg += fmt::format("<path class=\"curve {}\" d=\"M{} 12h22\"/><text class=\"tick\" x=\"{}\" y=\"18\">{}</text>",
                       name, label, label + 28, text);
    label += 220;
  }
  for (const double tick : x.ticks(6))
    svg += fmt::format("<text class=\"tick\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{:.3g}</text>",
                       std::clamp(x(tick), 50.0, width - 50), y + 18, tick);
  svg += fmt::format(
      "<text class=\"tick\" x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">step of the element (s), heights "
      "logarithmic</text>",
      width - right, height - 9);
  return svg + "</svg>";
}

std::string figureSvg(const StudyFigure& figure) {
  const auto drawn = [&figure](double x, double y) {
    return std::isfinite(x) && std::isfinite(y) && (!figure.logX || x > 0) && (!figure.logY || y > 0);
  };
  double left = infinity, right = -infinity, low = infinity, high = -infinity;
  for (const StudyFigure::Curve& curve : figure.curves)
    for (std::size_t i = 0; i < std::min(curve.x.size(), curve.y.size()); ++i)
      if (drawn(curve.x[i], curve.y[i])) {
        left = std::min(left, curve.x[i]);
        right = std::max(right, curve.x[i]);
        low = std::min(low, curve.y[i]);
        high = std::max(high, curve.y[i]);
      }
  if (!(left <= right)) return {};
  if (low == high) {
    const double room = figure.logY ? 0 : std::max(std::abs(low), 1e-300);
    low = figure.logY ? low / 2 : low - room;
    high = figure.logY ? high * 2 : high + room;
  }
  // Below the picture a line of the legend for each two curves.
  constexpr double width = 900, border = 84, top = 26, plot = 300, legendRow = 20;
  const double bottom = top + plot, height = bottom + 46 + legendRow * std::ceil(0.5 * figure.curves.size());
  const Axis x{left, right, border, width - 14, figure.logX}, y{low, high, bottom - 8, top + 8, figure.logY};
  std::string svg = fmt::format(
      "<svg class=\"chart\" viewBox=\"0 0 {} {:.0f}\" role=\"img\" aria-label=\"{}: {} against {}, {} curves\">", width,
      height, htmlText(figure.title), htmlText(figure.yLabel), htmlText(figure.xLabel), figure.curves.size());
  for (const double tick : y.ticks(6))
    svg += fmt::format(
        "<path class=\"grid\" d=\"M{} {:.1f}H{}\"/><text class=\"tick\" x=\"{}\" y=\"{:.1f}\" "
        "text-anchor=\"end\">{:.3g}</text>",
        border, y(tick), width - 14, border - 6, y(tick) + 4, tick);
  for (const double tick : x.ticks(8))
    svg += fmt::format(
        "<path class=\"grid\" d=\"M{0:.1f} {1}V{2}\"/><text class=\"tick\" x=\"{0:.1f}\" y=\"{3}\" "
        "text-anchor=\"middle\">{4:.4g}</text>",
        x(tick), top, bottom, bottom + 16, tick);
  svg += fmt::format("<text class=\"tick\" x=\"4\" y=\"14\">{}</text>", htmlText(figure.yLabel));
  svg += fmt::format("<text class=\"tick\" x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>", width - 14, bottom + 34,
                     htmlText(figure.xLabel));
  constexpr std::size_t styles = 12;  // of page.css
  for (std::size_t c = 0; c < figure.curves.size(); ++c) {
    const StudyFigure::Curve& curve = figure.curves[c];
    std::string path, points;
    bool drawing = false;
    for (std::size_t i = 0; i < std::min(curve.x.size(), curve.y.size()); ++i) {
      if (!drawn(curve.x[i], curve.y[i])) {
        drawing = false;
        continue;
      }
      if (figure.lines) path += fmt::format("{}{:.1f} {:.1f}", drawing ? 'L' : 'M', x(curve.x[i]), y(curve.y[i]));
      drawing = true;
      // Of long curves the line alone.
      if (!figure.lines || curve.x.size() <= 60)
        points += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\"><title>{}: {:.4g}, {:.4g}</title></circle>",
                              x(curve.x[i]), y(curve.y[i]), htmlText(curve.label), curve.x[i], curve.y[i]);
    }
    svg += fmt::format("<g class=\"series s{}\">", c % styles);
    if (!path.empty()) svg += fmt::format("<path d=\"{}\"/>", path);
    const double at = border + (c % 2) * 0.5 * (width - border), line = bottom + 52 + legendRow * std::floor(0.5 * c);
    svg += points +
           fmt::format("<path d=\"M{} {}h24\"/><circle cx=\"{}\" cy=\"{}\" r=\"3\"/></g>", at, line, at + 12, line);
    svg += fmt::format("<text class=\"tick\" x=\"{}\" y=\"{}\">{}</text>", at + 32, line + 4, htmlText(curve.label));
  }
  return svg + "</svg>";
}

std::string elementSvg(const WorstCard& card) {
  if (card.corners.empty()) return {};
  Eigen::Matrix3Xd points(3, card.corners.size());
  for (std::size_t i = 0; i < card.corners.size(); ++i)
    points.col(i) = Eigen::Map<const Eigen::Vector3d>(card.corners[i].data());
  points.colwise() -= points.rowwise().mean().eval();
  // The directions of largest extent, turned a little so that a flat element shows that it is flat.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(points * points.transpose());
  const Eigen::Vector3d right = axes.eigenvectors().col(2), thin = axes.eigenvectors().col(0),
                        middle = axes.eigenvectors().col(1);
  const double tilt = 35 * EIGEN_PI / 180;
  const Eigen::Vector3d up = std::cos(tilt) * middle + std::sin(tilt) * thin;
  const Eigen::RowVectorXd px = right.transpose() * points, py = up.transpose() * points;
  const double extent = std::max({px.maxCoeff() - px.minCoeff(), py.maxCoeff() - py.minCoeff(), 1e-300});
  constexpr double size = 96;
  const double scale = (size - 12) / extent, cx = 0.5 * (px.maxCoeff() + px.minCoeff()),
               cy = 0.5 * (py.maxCoeff() + py.minCoeff());
  const auto at = [&](std::int32_t node) {
    return fmt::format("{:.1f} {:.1f}", size / 2 + (px[node] - cx) * scale, size / 2 - (py[node] - cy) * scale);
  };
  std::string svg = fmt::format("<svg class=\"element\" viewBox=\"0 0 {0} {0}\" aria-hidden=\"true\">", size);
  for (const auto& face : card.faces) {
    std::string path;
    for (const std::int32_t node : face) path += (path.empty() ? "M" : "L") + at(node);
    svg += fmt::format("<path class=\"face\" d=\"{}Z\"/>", path);
  }
  for (const auto& [a, b] : card.edges) svg += fmt::format("<path class=\"edge\" d=\"M{}L{}\"/>", at(a), at(b));
  return svg + "</svg>";
}

}  // namespace ringwatch

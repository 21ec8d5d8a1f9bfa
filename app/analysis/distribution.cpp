#include <ringwatch/app/analysis/distribution.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include <ringwatch/app/output/frames.h>
#include <ringwatch/app/output/gnuplot.h>
#include <ringwatch/base/atomic_file.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/subprocess.h>

namespace ringwatch {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t bins = 24;

/// gnuplot's list of labels for a logarithmic axis: 1, 2 and 5 of each decade, or decades alone where there are many.
std::string ticsFor(double least, double most) {
  const int first = static_cast<int>(std::floor(std::log10(least))),
            last = static_cast<int>(std::ceil(std::log10(most)));
  std::string tics;
  for (int decade = first; decade <= last; ++decade)
    for (const int digit : {1, 2, 5}) {
      if (last - first > 4 && digit != 1) continue;
      const double value = digit * std::pow(10.0, decade);
      if (value >= least && value <= most)
        tics += fmt::format("{}'{}e{}' {}", tics.empty() ? "" : ", ", digit, decade, value);
    }
  return tics;
}

}  // namespace

double Distribution::critical(double h) const {
  const auto below = std::ranges::count_if(steps, [h](double step) { return step < h; });
  return static_cast<double>(below) / static_cast<double>(steps.size() + without);
}

double Distribution::criticalAtEdge(std::size_t i) const {
  std::size_t below = std::accumulate(counts.begin(), counts.begin() + static_cast<std::ptrdiff_t>(i), std::size_t{0});
  if (i == counts.size()) below -= atEnd;
  return static_cast<double>(below) / static_cast<double>(steps.size() + without);
}

std::vector<Distribution> distributionsOf(std::vector<ElementSteps> metrics) {
  std::vector<Distribution> distributions;
  double least = infinity, most = 0;
  for (ElementSteps& metric : metrics) {
    Distribution d;
    d.metric = std::move(metric.metric);
    d.without = std::erase_if(metric.steps, [](double step) { return !(std::isfinite(step) && step > 0); });
    d.steps = std::move(metric.steps);
    for (const double step : d.steps) {
      least = std::min(least, step);
      most = std::max(most, step);
    }
    distributions.push_back(std::move(d));
  }
  if (!(most > 0)) return distributions;
  // Equal elements share one bin: rounding must not spread them.
  const std::size_t count = most > least * (1 + 1e-9) ? bins : 1;
  std::vector<double> edges;
  for (std::size_t i = 0; i <= count; ++i)
    edges.push_back(i == 0       ? least
                    : i == count ? most
                                 : least * std::pow(most / least, static_cast<double>(i) / static_cast<double>(count)));
  for (Distribution& d : distributions) {
    d.edges = edges;
    d.counts.assign(count, 0);
    for (const double step : d.steps) {
      const auto above = std::upper_bound(edges.begin() + 1, edges.end() - 1, step);
      ++d.counts[static_cast<std::size_t>(above - edges.begin()) - 1];
      if (step == edges.back()) ++d.atEnd;
    }
  }
  return distributions;
}

std::vector<Distribution> distributionsOf(const std::vector<MetricResult>& metrics, const StepRule& rule) {
  std::vector<ElementSteps> steps;
  for (const MetricResult& metric : metrics) {
    ElementSteps own{std::string(metric.info->name), {}};
    for (const auto& block : metric.elementLambda)
      for (const double lambda : block)
        own.steps.push_back(lambda == 0 ? infinity : stepBy(metric.direction, lambda, rule));
    steps.push_back(std::move(own));
  }
  return distributionsOf(std::move(steps));
}

Json distributionJson(const std::vector<Distribution>& distributions) {
  Json json = Json::object();
  for (const Distribution& d : distributions) {
    Json cumulative = Json::array();
    for (std::size_t i = 0; i < d.edges.size(); ++i) cumulative.push_back(d.criticalAtEdge(i));
    json[d.metric] = Json{{"edges", d.edges},
                          {"counts", d.counts},
                          {"critical_share", std::move(cumulative)},
                          {"without_step", d.without}};
  }
  return json;
}

std::string distributionText(const std::vector<Distribution>& distributions, std::optional<double> h) {
  std::string text;
  for (const Distribution& d : distributions) {
    text += fmt::format("steps of the elements by {}:\n", d.metric);
    if (d.without > 0) text += fmt::format("  {} elements without a step\n", d.without);
    if (d.steps.empty()) continue;
    text += fmt::format("  {:>11}   {:>11} {:>9} {:>22}\n", "from (s)", "to (s)", "elements", "critical at upper (%)");
    const std::size_t most = *std::max_element(d.counts.begin(), d.counts.end());
    // Common bins: those before the first and behind the last element of this metric say nothing.
    std::size_t first = 0, end = d.counts.size();
    while (d.counts[first] == 0) ++first;
    while (d.counts[end - 1] == 0) --end;
    for (std::size_t i = first; i < end; ++i)
      text += fmt::format("  {:>11.4g}   {:>11.4g} {:>9} {:>22.2f}  {}\n", d.edges[i], d.edges[i + 1], d.counts[i],
                          100 * d.criticalAtEdge(i + 1), std::string((30 * d.counts[i] + most - 1) / most, '#'));
    if (h) text += fmt::format("  {:.2f} % critical at h = {:.6g} s\n", 100 * d.critical(*h), *h);
  }
  return text;
}

std::vector<WorstElement> worstElements(const Body& body, const MetricResult& metric, const StepRule& rule,
                                        std::size_t count) {
  std::vector<std::pair<double, ElementRef>> all;
  for (std::size_t b = 0; b < metric.elementLambda.size(); ++b)
    for (std::size_t e = 0; e < metric.elementLambda[b].size(); ++e) {
      const double step = stepBy(metric.direction, metric.elementLambda[b][e], rule);
      // An element without a tangent is the worst of all.
      all.push_back({std::isnan(step) ? 0 : step, {b, e}});
    }
  const auto end = all.begin() + static_cast<std::ptrdiff_t>(std::min(count, all.size()));
  std::partial_sort(all.begin(), end, all.end());
  const Mesh& mesh = body.mesh();
  const double meanVolume = body.volume() / static_cast<double>(mesh.elementCount());
  std::vector<WorstElement> worst;
  for (auto entry = all.begin(); entry != end; ++entry) {
    const ElementRef ref = entry->second;
    worst.push_back({ref, entry->first, elementShape(mesh.blocks[ref.block], ref.element, mesh.X, meanVolume)});
  }
  return worst;
}

Json worstJson(const Mesh& mesh, const std::vector<WorstElement>& worst) {
  Json json = Json::array();
  for (const WorstElement& w : worst)
    json.push_back(Json{{"block", w.element.block},
                        {"index", w.element.element},
                        {"id", mesh.blocks[w.element.block].id(w.element.element)},
                        {"step", w.step},
                        {"shape", std::string(shapeName(w.shape.shape))},
                        {"min_dihedral", w.shape.minDihedral},
                        {"max_dihedral", w.shape.maxDihedral},
                        {"aspect", w.shape.aspect}});
  return json;
}

std::string worstText(const std::vector<WorstElement>& worst) {
  std::string text = fmt::format("worst elements by reduced-1-ring:\n  {:<10} {:>12}  shape\n", "element", "step (s)");
  for (const WorstElement& w : worst)
    text += fmt::format("  {:<10} {:>12.6g}  {}\n", fmt::format("{}:{}", w.element.block, w.element.element), w.step,
                        w.shape.text());
  return text;
}

void checkPictureName(const std::filesystem::path& file) {
  if (file.extension() != ".svg" && file.extension() != ".png")
    throw InputError(fmt::format("--picture: \"{}\" must end in .svg or .png", file.string()));
}

std::string drawDistribution(const std::filesystem::path& file, const std::vector<Distribution>& distributions,
                             const StepMarks& marks, const std::string& title) {
  checkPictureName(file);
  const std::string name = file.filename().string();
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  // Two indices of the data a metric: the outline of its histogram, then the cumulative share.
  std::string data =
      "# outline of the histogram: step_s elements; then step_s critical_percent; a pair of indices a metric\n";
  std::string histograms, shares;
  std::size_t index = 0, mostCount = 1;
  double least = infinity, most = 0;
  const auto see = [&](double step) {
    if (!(std::isfinite(step) && step > 0)) return;
    least = std::min(least, step);
    most = std::max(most, step);
  };
  constexpr double nothing = 0.5;  // elements, on a logarithmic scale
  for (const Distribution& d : distributions) {
    if (d.steps.empty()) continue;
    see(d.edges.front());
    see(d.edges.back());
    // Lines of metrics beside each other, not on each other.
    const double aside = d.counts.size() > 1 ? std::pow(d.edges[1] / d.edges[0],
                                                        0.04 * static_cast<double>(static_cast<int>(index / 2 % 9) - 4))
                                             : 1;
    data += fmt::format("{} {}\n", d.edges.front() * aside, nothing);
    for (std::size_t i = 0; i < d.counts.size(); ++i) {
      const double height = d.counts[i] > 0 ? static_cast<double>(d.counts[i]) : nothing;
      data += fmt::format("{} {}\n{} {}\n", d.edges[i] * aside, height, d.edges[i + 1] * aside, height);
      mostCount = std::max(mostCount, d.counts[i]);
    }
    data += fmt::format("{} {}\n\n\n", d.edges.back() * aside, nothing);
    // At most a few hundred points of the share: a picture has no more columns.
    std::vector<double> steps = d.steps;
    std::sort(steps.begin(), steps.end());
    const auto share = [&](std::size_t below) {
      return 100 * static_cast<double>(below) / static_cast<double>(steps.size() + d.without);
    };
    const std::size_t stride = 1 + steps.size() / 500;
    for (std::size_t i = 0; i < steps.size(); i += stride)
      data += fmt::format("{} {}\n", steps[i],
                          share(std::lower_bound(steps.begin(), steps.end(), steps[i]) - steps.begin()));
    data += fmt::format("{} {}\n\n\n", std::nextafter(steps.back(), infinity), share(steps.size()));
    const std::string label = gnuplotQuoted(d.metric);
    // Eight colours, then the same with dashes.
    const std::size_t metric = index / 2;
    const std::string style = fmt::format("lines lw 2 lc {} dt {}", metric % 8 + 1, metric / 8 + 1);
    histograms +=
        fmt::format("{}data index {} using 1:2 with {} title {}", histograms.empty() ? "" : ", ", index, style, label);
    shares += fmt::format("{}data index {} using 1:2 with {} notitle", shares.empty() ? "" : ", ", index + 1, style);
    index += 2;
  }
  if (index == 0) return "no picture: no element has a step\n";
  see(marks.safe);
  see(marks.optimistic);
  if (marks.step) see(*marks.step);
  // A mark is an arrow over the height of a panel and, in the legend, a line that has no points.
  std::string arrows;
  int arrow = 0;
  const auto mark = [&](int style, double step, const char* what) {
    if (!(std::isfinite(step) && step > 0)) return;
    arrows += fmt::format("set arrow {} from first {}, graph 0 to first {}, graph 1 nohead ls {} front\n", ++arrow,
                          step, step, style);
    histograms += fmt::format(", NaN ls {} title '{}: {:.4g} s'", style, what, step);
  };
  mark(101, marks.safe, "mesh, safe");
  mark(102, marks.optimistic, "mesh, optimistic");
  if (marks.step) mark(103, *marks.step, "step");
  const bool svg = file.extension() == ".svg";
  const std::string script = fmt::format(
      "# Draws {0} from {0}.dat: run gnuplot on this file in its folder.\n"
      "if (!exists('picture')) picture = {1}\n"
      "set terminal {2}\n"
      "set output picture\n"
      "data = {3}\n"
      "set linetype 1 lc rgb '#0072B2'\nset linetype 2 lc rgb '#E69F00'\nset linetype 3 lc rgb '#CC79A7'\n"
      "set linetype 4 lc rgb '#56B4E9'\nset linetype 5 lc rgb '#999999'\nset linetype 6 lc rgb '#8B4513'\n"
      "set linetype 7 lc rgb '#F0E442'\nset linetype 8 lc rgb '#4B0082'\n"
      "set style line 101 lc rgb '#009E73' lw 2.5 dt 2\n"
      "set style line 102 lc rgb '#D55E00' lw 2.5 dt 2\n"
      "set style line 103 lc rgb '#000000' lw 2.5 dt 3\n"
      "set grid lt 1 lw 0.7 lc rgb '#CCCCCC'\n"
      "set logscale x\n"
      "set xtics ({12})\n"
      "set xrange [{4}:{5}]\n"
      "set lmargin 10\n"
      "set rmargin 36\n"
      "set key at graph 1.02, graph 1 left top Left reverse samplen 2 noenhanced\n"
      "set multiplot layout 2,1 title {6} noenhanced\n"
      "{9}"
      "set ylabel 'elements in a bin'\n"
      "set logscale y\n"
      "set yrange [{10}:{11}]\n"
      "plot {7}\n"
      "unset logscale y\n"
      "set ylabel 'elements with a smaller step (%)'\n"
      "set xlabel 'step (s)'\n"
      "set yrange [0:100]\n"
      "plot {8}\n"
      "unset multiplot\n",
      name, gnuplotQuoted(name),
      svg ? "svg size 1200,900 font 'DejaVu Sans,14' background rgb 'white'"
          : "pngcairo size 1200,900 font 'DejaVu Sans,12'",
      gnuplotQuoted(name + ".dat"), least * 0.9, most * 1.1, gnuplotQuoted(title), histograms, shares, arrows, nothing,
      2 * static_cast<double>(mostCount), ticsFor(least * 0.9, most * 1.1));
  writeFileAtomically(folder / (name + ".dat"), data);
  writeFileAtomically(folder / (name + ".gp"), labelled(script));
  const std::string part = name + ".part";
  const ProgramResult result =
      runProgram({"gnuplot", "-e", fmt::format("picture={}", gnuplotQuoted(part)), name + ".gp"}, folder);
  std::error_code error;
  if (result.found && result.status == 0) {
    std::filesystem::rename(folder / part, file, error);
    if (!error) return fmt::format("drew {}\n", file.string());
  }
  std::filesystem::remove(folder / part, error);
  if (!result.found || result.status == 127)
    return fmt::format("no picture: gnuplot is missing; install it (Debian: gnuplot-nox) and run it on {}.gp\n", name);
  std::string reason = result.output.substr(0, 300);
  std::replace(reason.begin(), reason.end(), '\n', ' ');
  return fmt::format("no picture: gnuplot ended with status {}: {}\n", result.status, reason);
}

}  // namespace ringwatch

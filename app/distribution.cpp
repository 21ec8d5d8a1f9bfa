#include <ringwatch/app/distribution.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <ringwatch/app/gnuplot.h>
#include <ringwatch/app/subprocess.h>
#include <ringwatch/base/atomic_file.h>
#include <ringwatch/base/error.h>

namespace ringwatch {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t bins = 20;

}  // namespace

double Distribution::critical(double h) const {
  const auto below = std::lower_bound(steps.begin(), steps.end(), h) - steps.begin();
  return static_cast<double>(below) / static_cast<double>(steps.size() + without);
}

Distribution distributionOf(const MetricResult& metric, double limit) {
  Distribution d;
  d.metric = std::string(metric.info->name);
  for (const auto& block : metric.elementLambda)
    for (const double lambda : block) {
      const double step = stepFor(lambda, limit);
      if (std::isfinite(step) && step > 0)
        d.steps.push_back(step);
      else
        ++d.without;
    }
  std::sort(d.steps.begin(), d.steps.end());
  if (d.steps.empty()) return d;
  const double least = d.steps.front(), most = d.steps.back();
  // Equal elements share one bin: rounding must not spread them over twenty.
  const std::size_t count = most > least * (1 + 1e-9) ? bins : 1;
  for (std::size_t i = 0; i <= count; ++i)
    d.edges.push_back(i == 0 ? least
                      : i == count
                          ? most
                          : least * std::pow(most / least, static_cast<double>(i) / static_cast<double>(count)));
  d.counts.assign(count, 0);
  std::size_t bin = 0;
  for (const double step : d.steps) {
    while (bin + 1 < count && step >= d.edges[bin + 1]) ++bin;
    ++d.counts[bin];
  }
  return d;
}

Json distributionJson(const std::vector<Distribution>& distributions) {
  Json json = Json::object();
  for (const Distribution& d : distributions) {
    Json cumulative = Json::array();
    for (const double edge : d.edges) cumulative.push_back(d.critical(edge));
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
    for (std::size_t i = 0; i < d.counts.size(); ++i)
      text += fmt::format("  {:>11.4g}   {:>11.4g} {:>9} {:>22.2f}  {}\n", d.edges[i], d.edges[i + 1], d.counts[i],
                          100 * d.critical(d.edges[i + 1]), std::string((30 * d.counts[i] + most - 1) / most, '#'));
    if (h) text += fmt::format("  {:.2f} % critical at h = {:.6g} s\n", 100 * d.critical(*h), *h);
  }
  return text;
}

std::vector<WorstElement> worstElements(const Body& body, const MetricResult& metric, double limit, std::size_t count) {
  std::vector<std::pair<double, ElementRef>> all;
  for (std::size_t b = 0; b < metric.elementLambda.size(); ++b)
    for (std::size_t e = 0; e < metric.elementLambda[b].size(); ++e) {
      const double step = stepFor(metric.elementLambda[b][e], limit);
      // An element without a tangent is the worst of all.
      all.push_back({std::isnan(step) ? 0 : step, {static_cast<std::int32_t>(b), static_cast<std::int32_t>(e)}});
    }
  const auto end = all.begin() + static_cast<std::ptrdiff_t>(std::min(count, all.size()));
  std::partial_sort(all.begin(), end, all.end());
  const Mesh& mesh = body.mesh();
  const double meanVolume = body.volume() / static_cast<double>(mesh.elementCount());
  std::vector<WorstElement> worst;
  for (auto entry = all.begin(); entry != end; ++entry) {
    const ElementRef ref = entry->second;
    worst.push_back({ref, entry->first,
                     elementShape(mesh.blocks[static_cast<std::size_t>(ref.block)],
                                  static_cast<std::size_t>(ref.element), mesh.X, meanVolume)});
  }
  return worst;
}

Json worstJson(const Mesh& mesh, const std::vector<WorstElement>& worst) {
  Json json = Json::array();
  for (const WorstElement& w : worst)
    json.push_back(Json{
        {"block", w.element.block},
        {"index", w.element.element},
        {"id", mesh.blocks[static_cast<std::size_t>(w.element.block)].id(static_cast<std::size_t>(w.element.element))},
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
                             const std::string& title) {
  checkPictureName(file);
  const std::string name = file.filename().string();
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  // An index of the data a metric: from, to, elements, then the cumulative share as an index of its own.
  std::string data = "# from_s to_s elements; then step_s critical_percent; a pair of indices a metric\n";
  std::string histograms, shares;
  std::size_t index = 0;
  double least = INFINITY, most = 0;
  for (const Distribution& d : distributions) {
    if (d.steps.empty()) continue;
    least = std::min(least, d.steps.front());
    most = std::max(most, d.steps.back());
    for (std::size_t i = 0; i < d.counts.size(); ++i)
      data += fmt::format("{} {} {}\n", d.edges[i], d.edges[i + 1], d.counts[i]);
    data += "\n\n";
    // At most a few hundred points of the share: a picture has no more columns.
    const std::size_t stride = 1 + d.steps.size() / 500;
    for (std::size_t i = 0; i < d.steps.size(); i += stride)
      data += fmt::format("{} {}\n", d.steps[i], 100 * d.critical(d.steps[i]));
    const double end = std::nextafter(d.steps.back(), INFINITY);
    data += fmt::format("{} {}\n\n\n", end, 100 * d.critical(end));
    const std::string label = gnuplotQuoted(d.metric);
    histograms += fmt::format(
        "{}data index {} using (sqrt($1*$2)):3:1:2:(0):3 with boxxyerror fill transparent solid 0.3 lc {} title {}",
        histograms.empty() ? "" : ", ", index, index / 2 + 1, label);
    shares += fmt::format("{}data index {} using 1:2 with lines lw 2 lc {} title {}", shares.empty() ? "" : ", ",
                          index + 1, index / 2 + 1, label);
    index += 2;
  }
  if (index == 0) return "no picture: no element has a step\n";
  const bool svg = file.extension() == ".svg";
  const std::string script = fmt::format(
      "# Draws {0} from {0}.dat: run gnuplot on this file in its folder.\n"
      "if (!exists('picture')) picture = {1}\n"
      "set terminal {2}\n"
      "set output picture\n"
      "data = {3}\n"
      "set grid lt 1 lw 0.7 lc rgb '#CCCCCC'\n"
      "set logscale x\n"
      "set format x '%.1e'\n"
      "set xrange [{4}:{5}]\n"
      "set key top left noenhanced\n"
      "set multiplot layout 2,1 title {6} noenhanced\n"
      "set ylabel 'elements'\n"
      "set yrange [0:*]\n"
      "plot {7}\n"
      "set ylabel 'critical elements (%)'\n"
      "set xlabel 'step (s)'\n"
      "set yrange [0:100]\n"
      "plot {8}\n"
      "unset multiplot\n",
      name, gnuplotQuoted(name),
      svg ? "svg size 1000,900 font 'DejaVu Sans,14' background rgb 'white'"
          : "pngcairo size 1000,900 font 'DejaVu Sans,12'",
      gnuplotQuoted(name + ".dat"), least * 0.8, most * 1.25, gnuplotQuoted(title), histograms, shares);
  writeFileAtomically(folder / (name + ".dat"), data);
  writeFileAtomically(folder / (name + ".gp"), script);
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

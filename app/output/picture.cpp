#include <ringwatch/app/output/picture.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <ringwatch/app/output/gnuplot.h>
#include <ringwatch/base/atomic_file.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/subprocess.h>
#include <ringwatch/base/units.h>

namespace ringwatch {
namespace {

constexpr std::size_t mostRows = 4000;
constexpr double logRatio = 20;  // a range of steps wider than this is drawn on a logarithmic scale

std::string cell(std::optional<double> value) {
  return value && std::isfinite(*value) ? fmt::format(" {}", *value) : " NaN";
}

}  // namespace

void Picture::add(const HistoryRow& row) {
  if (seen_++ % stride_ != 0) return;
  rows_.push_back(row);
  if (rows_.size() <= mostRows) return;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < rows_.size(); i += 2) rows_[kept++] = rows_[i];
  rows_.resize(kept);
  stride_ *= 2;
}

std::string Picture::data() const {
  std::string text =
      labelledColumns(
          "# time_s h_s safe_s optimistic_s metric_step_s kinetic_J strain_J external_work_J balance_error_J "
          "handled_elements h_certified_s h_not_certified_s h_violated_s dissipated_J") +
      "\n";
  for (const HistoryRow& row : rows_) {
    const std::optional<double> h = drawsStep(row) ? std::optional(row.h) : std::nullopt;
    text += fmt::format("{}{}", row.time, cell(h));
    text += row.bracket ? cell(row.bracket->safe) + cell(row.bracket->optimistic) : " NaN NaN";
    text += cell(row.metricStep);
    if (row.energies)
      text += cell(row.energies->kinetic) + cell(row.energies->strain) + cell(row.energies->externalWork) +
              cell(row.energies->balanceError);
    else
      text += " NaN NaN NaN NaN";
    text += fmt::format(" {}", row.handledElements);
    for (const Verdict verdict : {Verdict::certified, Verdict::notCertified, Verdict::violated})
      text += cell(row.verdict == verdict ? h : std::nullopt);
    text += cell(row.energies ? std::optional(row.energies->dissipated) : std::nullopt) + "\n";
  }
  return text;
}

std::string Picture::script(const std::string& title) const {
  bool hasBracket = false, hasMetric = false, hasEnergy = false, dissipates = false, handles = false, verdicts[3] = {};
  double leastStep = infinity, mostStep = 0, leastEnergy = 0, mostEnergy = 0;
  for (const HistoryRow& row : rows_) {
    hasBracket = hasBracket || row.bracket;
    hasMetric = hasMetric || row.metricStep;
    hasEnergy = hasEnergy || row.energies;
    handles = handles || row.handledElements > 0;
    if (row.verdict) verdicts[static_cast<int>(*row.verdict)] = true;
    // A runaway grows without end, and the critical step falls with it: the panels are scaled to what came before.
    if (runaway_ && row.time >= *runaway_ && &row != &rows_.front()) continue;
    const auto seeStep = [&](double step) {
      if (!std::isfinite(step) || step <= 0) return;
      mostStep = std::max(mostStep, step);
      if (!violation_ || row.time <= *violation_) leastStep = std::min(leastStep, step);
    };
    if (drawsStep(row)) seeStep(row.h);
    if (row.bracket) {
      seeStep(row.bracket->safe);
      seeStep(row.bracket->optimistic);
    }
    if (row.metricStep) seeStep(*row.metricStep);
    if (!row.energies) continue;
    dissipates = dissipates || row.energies->dissipated != 0;
    for (double value : {row.energies->kinetic, row.energies->strain, row.energies->externalWork,
                         row.energies->balanceError, row.energies->dissipated}) {
      if (!std::isfinite(value)) continue;
      leastEnergy = std::min(leastEnergy, value);
      mostEnergy = std::max(mostEnergy, value);
    }
  }
  const bool logarithmic = mostStep > logRatio * leastStep;
  // The last row is of the state before the last step; rows may have been left out.
  const double endTime =
      rows_.empty() || rows_.back().time <= 0 ? 1 : rows_.back().time + (runaway_ ? 0 : rows_.back().h);
  const int panels = 1 + (handles ? 1 : 0) + (hasEnergy ? 1 : 0);

  std::string text = fmt::format(
      "# Draws critical_step.png from critical_step.dat: run gnuplot on this file in its folder.\n"
      "if (!exists('picture')) picture = 'critical_step.png'\n"
      "set terminal pngcairo size 1400,{} font 'DejaVu Sans,13' linewidth 1.5\n"
      "set output picture\n"
      "set datafile missing 'NaN'\n"
      "data = 'critical_step.dat'\n"
      "set style line 1 lc rgb '#009E73' lw 2\n"  // colours that colour-blind people tell apart (Okabe and Ito)
      "set style line 2 lc rgb '#0072B2' lw 2\n"
      "set style line 3 lc rgb '#000000' lw 2\n"
      "set style line 4 lc rgb '#E69F00' lw 2\n"
      "set style line 5 lc rgb '#D55E00' lw 2 dt 2\n"
      "set style line 6 lc rgb '#CC79A7' lw 2 dt 4\n"
      "set style line 7 lc rgb '#000000' lw 2 dt 3\n"
      "set style line 8 lc rgb '#56B4E9' lw 2 dt 2\n"
      "set style line 9 lc rgb '#56B4E9' lw 2\n"
      "set style line 11 lc rgb '#009E73' pt 7 ps 0.4\n"
      "set style line 12 lc rgb '#999999' pt 7 ps 0.6\n"
      "set style line 13 lc rgb '#D55E00' pt 7 ps 0.6\n"
      "set grid lt 1 lw 0.7 lc rgb '#CCCCCC'\n"
      "set border lc rgb '#444444'\n"
      "set lmargin 12\n"
      "set rmargin 38\n"  // the legends' place, the same for all panels
      "set key at graph 1.02, graph 1 left top Left reverse samplen 2\n"
      "set format y '%.3g'\n",
      panels == 1   ? 600
      : panels == 2 ? 900
                    : 1100);
  text += fmt::format("set xrange [0:{}]\n", endTime);
  text += fmt::format("set multiplot layout {},1 title {} noenhanced font ',16'\n", panels, gnuplotQuoted(title));
  // A mark is an arrow over the height of the panel and, in the legend, a line that has no points.
  std::string marks, legend;
  int arrow = 0;
  const auto mark = [&](int style, double time) {
    marks += fmt::format("set arrow {} from first {}, graph 0 to first {}, graph 1 nohead ls {} front\n", ++arrow, time,
                         time, style);
  };
  const auto markOnce = [&](int style, const std::optional<double>& time, const char* name) {
    if (!time) return;
    mark(style, *time);
    legend += fmt::format(", NaN ls {} title '{}, t = {:.4g} s'", style, name, *time);
  };
  markOnce(5, violation_, "monitor: violated");
  markOnce(6, runaway_, "energy ran away");
  for (const double time : cuts_) mark(8, time);
  if (!cuts_.empty()) legend += fmt::format(", NaN ls 8 title '{}'", cuts_.size() == 1 ? "cut" : "cuts");
  text += marks;

  text += "set title 'Step sizes' offset 0,-0.5\nset ylabel 'step (s)'\n";
  if (panels == 1) text += "set xlabel 'time (s)'\n";
  if (logarithmic) text += "set logscale y\n";
  const double margin = std::max(0.08 * (mostStep - leastStep), 0.05 * mostStep);
  if (mostStep > 0 && leastStep <= mostStep)
    text += logarithmic ? fmt::format("set yrange [{}:{}]\n", 0.5 * leastStep, 1.5 * mostStep)
                        : fmt::format("set yrange [{}:{}]\n", leastStep - margin, mostStep + margin);
  std::string curves;
  if (hasBracket)
    curves +=
        "data using 1:4 with lines ls 2 title 'optimistic: proven unstable above', "
        "data using 1:3 with lines ls 1 title 'safe: proven stable below', ";
  if (hasMetric) curves += "data using 1:5 with lines ls 4 title 'metric with margin', ";
  curves += "data using 1:2 with steps ls 3 title 'step taken'";
  const char* const names[] = {"certified", "not certified", "violated"};
  for (int v = 0; v < 3; ++v)  // with a bracket, the curves say where it is certified
    if (verdicts[v] && (v > 0 || !hasBracket))
      curves += fmt::format(", data using 1:{} with points ls {} title '{}'", 11 + v, 11 + v, names[v]);
  text += "plot " + curves + legend + "\n";

  if (handles) {
    text += "unset logscale y\nset title 'Handled elements' offset 0,-0.5\nset ylabel 'elements'\nset yrange [0:*]\n";
    if (!hasEnergy) text += "set xlabel 'time (s)'\n";
    text += "plot data using 1:10 with steps ls 4 title 'handled elements'\n";
  }
  if (hasEnergy) {
    text += "unset logscale y\nset title 'Energies' offset 0,-0.5\nset ylabel 'energy (J)'\nset xlabel 'time (s)'\n";
    const double span = mostEnergy - leastEnergy;
    if (span > 0)
      text += fmt::format("set yrange [{}:{}]\n", leastEnergy - 0.1 * span, mostEnergy + (runaway_ ? 0.6 : 0.1) * span);
    else
      text += "set autoscale y\n";
    text +=
        "plot data using 1:6 with lines ls 2 title 'kinetic', data using 1:7 with lines ls 1 title 'strain', "
        "data using 1:8 with lines ls 4 title 'external work', data using 1:9 with lines ls 7 title 'balance error'";
    if (dissipates) text += ", data using 1:14 with lines ls 9 title 'dissipated'";
    text += "\n";
  }
  return text + "unset multiplot\n";
}

std::string Picture::draw(const std::filesystem::path& folder, const std::string& title) const {
  writeFileAtomically(folder / "critical_step.dat", data());
  writeFileAtomically(folder / "critical_step.gp", labelled(script(title)));
  const std::string part = "critical_step.png.part";
  const ProgramResult result = runProgram({"gnuplot", "-e", "picture='" + part + "'", "critical_step.gp"}, folder);
  std::error_code error;
  if (result.found && result.status == 0) {
    std::filesystem::rename(folder / part, folder / "critical_step.png", error);
    if (!error) return {};
  }
  std::filesystem::remove(folder / part, error);
  if (!result.found || result.status == 127)
    return "no picture: gnuplot is missing; install it (Debian: gnuplot-nox) and run it on critical_step.gp";
  std::string reason = result.output.substr(0, 300);
  std::replace(reason.begin(), reason.end(), '\n', ' ');
  return fmt::format("no picture: gnuplot ended with status {}: {}", result.status, reason);
}

}  // namespace ringwatch

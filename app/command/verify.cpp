#include <ringwatch/app/command/verify.h>

#include <omp.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include <ringwatch/app/output/gnuplot.h>
#include <ringwatch/app/output/junit.h>
#include <ringwatch/app/scene/integrator_catalog.h>
#include <ringwatch/base/atomic_file.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/leftovers.h>
#include <ringwatch/base/subprocess.h>
#include <ringwatch/base/user_text.h>

namespace ringwatch {
namespace {

std::string cellText(const StudyTable::Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  if (const auto* whole = std::get_if<std::int64_t>(&cell)) return fmt::format("{}", *whole);
  return fmt::format("{:.8g}", std::get<double>(cell));
}

/// Columns of a terminal that a text takes: bytes that continue a UTF-8 character take none.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

std::string tableText(const StudyTable& table) {
  constexpr std::size_t longest = 100;  // rows that a terminal shows
  if (table.rows.size() > longest)
    return fmt::format("{}: {} rows, in --json and --report\n", table.title, table.rows.size());
  std::vector<std::vector<std::string>> lines{table.columns};
  for (const auto& row : table.rows) {
    lines.emplace_back();
    for (const auto& cell : row) lines.back().push_back(cellText(cell));
  }
  std::vector<std::size_t> widths;
  for (const auto& line : lines) {
    widths.resize(std::max(widths.size(), line.size()), 0);
    for (std::size_t c = 0; c < line.size(); ++c) widths[c] = std::max(widths[c], width(line[c]));
  }
  std::string text = table.title + "\n";
  for (const auto& line : lines) {
    text += " ";
    for (std::size_t c = 0; c < line.size(); ++c) {
      const std::string space(widths[c] - width(line[c]), ' ');
      text += fmt::format(" {}{}", c == 0 ? line[c] : space, c == 0 ? space : line[c]);
    }
    text += "\n";
  }
  return text;
}

nlohmann::ordered_json number(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(fmt::format("{}", value));
}

std::string curveData(const StudyFigure& figure) {
  std::string data;
  for (const StudyFigure::Curve& curve : figure.curves) {
    data += fmt::format("# {}\n", curve.label);
    for (std::size_t i = 0; i < curve.x.size() && i < curve.y.size(); ++i)
      data += fmt::format("{} {}\n", curve.x[i], curve.y[i]);
    data += "\n\n";
  }
  return data;
}

std::string curveScript(const StudyFigure& figure) {
  std::string script = fmt::format(
      "set terminal pngcairo size 1200,900 font 'DejaVu Sans,14'\nset output '{0}.png'\nset title {1} noenhanced\n"
      "set xlabel {2} noenhanced\nset ylabel {3} noenhanced\nset grid\nset key outside right noenhanced\n"
      "set linetype 1 lc rgb '#0072b2'\nset linetype 2 lc rgb '#e69f00'\nset linetype 3 lc rgb '#009e73'\n"
      "set linetype 4 lc rgb '#cc79a7'\nset linetype 5 lc rgb '#d55e00'\nset linetype 6 lc rgb '#56b4e9'\n"
      "set linetype 7 lc rgb '#000000'\nset linetype 8 lc rgb '#999999'\n",
      figure.name, gnuplotQuoted(figure.title), gnuplotQuoted(figure.xLabel), gnuplotQuoted(figure.yLabel));
  // gnuplot's own format has two digits for small numbers.
  script += figure.logX ? "set logscale x\nset format x '10^{%L}'\n" : "set format x '%.4g'\n";
  script += figure.logY ? "set logscale y\nset format y '10^{%L}'\n" : "set format y '%.4g'\n";
  std::string plot;
  constexpr std::size_t colours = 8;  // then they come again, with dashes
  for (std::size_t c = 0; c < figure.curves.size(); ++c) {
    const char* const points = figure.curves[c].x.size() > 100 ? "points pt 7 ps 0.4" : "points lw 2 ps 1.5";
    plot += fmt::format("{}'{}.dat' index {} with {} title {}", plot.empty() ? "plot " : ", \\\n     ", figure.name, c,
                        figure.lines ? fmt::format("linespoints lw 2 dt {}", c < colours ? 1 : 2) : std::string(points),
                        gnuplotQuoted(figure.curves[c].label));
  }
  return script + plot + "\n";
}

std::string surfaceData(const StudySurfaces& surfaces) {
  std::string data;
  for (const StudySurfaces::Panel& panel : surfaces.panels) {
    // A triangle is a sheet of two lines, the second of one point twice.
    for (std::size_t i = 0; i + 2 < panel.points.size() && i + 2 < panel.values.size(); i += 3)
      for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t at = i + std::min<std::size_t>(k, 2);
        const auto& p = panel.points[at];
        data += fmt::format("{:.5g} {:.5g} {:.5g} {:.4g}\n{}", p[0], p[1], p[2], panel.values[at],
                            k == 1 ? "\n" : (k == 3 ? "\n\n" : ""));
      }
  }
  return data;
}

std::string surfaceScript(const StudySurfaces& surfaces) {
  std::array<double, 3> least, most;
  least.fill(HUGE_VAL);
  most.fill(-HUGE_VAL);
  double smallest = HUGE_VAL, largest = 0;
  for (const StudySurfaces::Panel& panel : surfaces.panels) {
    for (const auto& p : panel.points)
      for (std::size_t c = 0; c < 3; ++c) {
        least[c] = std::min(least[c], p[c]);
        most[c] = std::max(most[c], p[c]);
      }
    for (const double value : panel.values) {
      smallest = std::min(smallest, value);
      largest = std::max(largest, value);
    }
  }
  constexpr std::size_t perRow = 5;
  const std::size_t rows = (surfaces.panels.size() + perRow - 1) / perRow;
  constexpr double decades = 1e-4;  // of the largest value are shown at most
  const bool map = !(most[2] > least[2]);
  constexpr double farthest = 10;  // from 1, on a map
  const double apart = std::min(std::max(largest, 1 / smallest), farthest);
  std::string script = fmt::format(
      "set terminal pngcairo size 1900,{} font 'DejaVu Sans,13'\nset output '{}.png'\n"
      "set multiplot layout {},{} title {} noenhanced\n{}\nunset border\n"
      "unset xtics\nunset ytics\nunset ztics\nunset key\n"
      "set logscale cb\nset cbrange [{:g}:{:g}]\nset cblabel {} noenhanced\n"
      "set xrange [{:g}:{:g}]\nset yrange [{:g}:{:g}]\nset zrange [{:g}:{:g}]\n",
      80 + 380 * rows, surfaces.name, rows, std::min(perRow, surfaces.panels.size()), gnuplotQuoted(surfaces.title),
      // Colours of a map part at 1.
      map ? "set view map\nset size ratio -1\nset pm3d border retrace\nset palette defined (0 '#2166ac', 1 '#f7f7f7', "
            "2 '#b2182b')"
          : "set view 65,330\nset view equal xyz\nset pm3d depthorder\nset pm3d border lc rgb '#505050' lw 0.2\n"
            "set palette defined (0 '#440154', 1 '#3b528b', 2 '#21918c', 3 '#5ec962', 4 '#fde725')\n"
            "set format cb '10^{%L}'",
      map ? 1 / apart : std::max(smallest, decades * largest), map ? apart : largest,
      gnuplotQuoted(surfaces.valueLabel), least[0], most[0], least[1], most[1], least[2], map ? least[2] + 1 : most[2]);
  std::size_t first = 0;
  for (const StudySurfaces::Panel& panel : surfaces.panels) {
    const std::size_t triangles = panel.points.size() / 3;
    if (triangles == 0) continue;
    script += fmt::format("set title {} noenhanced\nsplot '{}.dat' index {}:{} using 1:2:3:4 with pm3d\n",
                          gnuplotQuoted(panel.label), surfaces.name, first, first + triangles - 1);
    first += triangles;
  }
  return script + "unset multiplot\n";
}

}  // namespace

std::vector<StudyReport> runStudies(const std::vector<std::string>& names, StudyEffort effort,
                                    const StudyProgress& progress) {
  const std::span<const StudyInfo> studies = allStudies();
  std::vector<const StudyInfo*> chosen;
  for (const std::string& name : names) {
    if (name == "all") {
      chosen.clear();
      break;
    }
    const auto found = std::find_if(studies.begin(), studies.end(), [&](const StudyInfo& s) {
      return s.name == name || (!name.empty() && s.formerName == name);
    });
    if (found == studies.end()) {
      std::string known = "all";
      for (const StudyInfo& s : studies) known += fmt::format(", {}", s.name);
      throw InputError(fmt::format("verify: {}: there is no such study; known are {}", inQuotes(name), known));
    }
    chosen.push_back(&*found);
  }
  if (chosen.empty())
    for (const StudyInfo& s : studies) chosen.push_back(&s);
  // Quick forms run small bodies, on which threads wait for each other longer than they compute: on a busy machine the
  // monitor's took 92 s of processor time with two threads and takes 10 s with one.
  const int threads = omp_get_max_threads();
  if (effort == StudyEffort::quick) omp_set_num_threads(1);
  std::vector<StudyReport> reports;
  for (const StudyInfo* s : chosen) {
    if (progress.begins) progress.begins(*s, reports.size() + 1, chosen.size());
    reports.push_back(s->run(effort));
    if (progress.ended) progress.ended(reports.back());
  }
  omp_set_num_threads(threads);
  return reports;
}

std::string studyText(const StudyReport& report) {
  std::string text = fmt::format("== {}\n", report.study);
  for (const StudyTable& table : report.tables) text += fmt::format("\n{}", tableText(table));
  std::size_t failed = 0;
  for (const StudyCheck& check : report.checks) failed += !check.passed();
  if (!report.checks.empty()) text += fmt::format("\n{} checks, {} failed\n", report.checks.size(), failed);
  for (const StudyCheck& check : report.checks)
    if (!check.passed())
      text += fmt::format("  FAILED {}: measured {:.9g}, expected {:.9g}, tolerance {:.3g}\n", check.name,
                          check.measured, check.expected, check.tolerance);
  return text;
}

nlohmann::ordered_json studiesJson(const std::vector<StudyReport>& reports) {
  nlohmann::ordered_json json;
  std::size_t checks = 0, failed = 0;
  for (const StudyReport& report : reports) {
    checks += report.checks.size();
    failed +=
        static_cast<std::size_t>(std::ranges::count_if(report.checks, [](const StudyCheck& c) { return !c.passed(); }));
  }
  json["passed"] = std::all_of(reports.begin(), reports.end(), [](const StudyReport& r) { return r.passed(); });
  json["conclusion"] = fmt::format("{} of {} checks failed", failed, checks);
  for (const StudyReport& report : reports) {
    nlohmann::ordered_json& study = json["studies"][report.study];
    study["passed"] = report.passed();
    study["tables"] = nlohmann::ordered_json::object();
    for (const StudyTable& table : report.tables) {
      nlohmann::ordered_json& rows = study["tables"][table.name] = nlohmann::ordered_json::array();
      for (const auto& row : table.rows) {
        nlohmann::ordered_json object;
        for (std::size_t c = 0; c < row.size() && c < table.columns.size(); ++c)
          std::visit(
              [&](const auto& value) {
                if constexpr (std::is_same_v<std::decay_t<decltype(value)>, double>)
                  object[table.columns[c]] = number(value);
                else
                  object[table.columns[c]] = value;
              },
              row[c]);
        rows.push_back(object);
      }
    }
    study["checks"] = nlohmann::ordered_json::array();
    for (const StudyCheck& check : report.checks)
      study["checks"].push_back({{"name", check.name},
                                 {"measured", number(check.measured)},
                                 {"expected", number(check.expected)},
                                 {"tolerance", number(check.tolerance)},
                                 {"passed", check.passed()}});
  }
  return json;
}

std::string junitOfChecks(const StudyReport& report) {
  std::vector<JunitCase> cases;
  for (const StudyCheck& check : report.checks)
    cases.push_back({check.name, check.passed() ? ""
                                                : fmt::format("measured {}, expected {}, tolerance {}", check.measured,
                                                              check.expected, check.tolerance)});
  return junitText("ringwatch " + report.study, "ringwatch." + report.study, cases);
}

std::vector<std::string> drawFigures(const StudyReport& report, const std::filesystem::path& folder) {
  std::vector<std::string> notes;
  const auto draw = [&](const std::string& name, const std::string& data, const std::string& script) {
    writeFileAtomically(folder / (name + ".dat"), data);
    writeFileAtomically(folder / (name + ".gp"), script);
    ProgramResult result;
    {
      const Leftover unfinished(folder / (name + ".png"));
      result = runProgram({"gnuplot", name + ".gp"}, folder);
    }
    if (!result.found)
      notes.push_back(
          fmt::format("no picture {}.png: gnuplot is not installed (Debian: gnuplot-nox); its script is in {}", name,
                      folder.string()));
    else if (result.status != 0)
      notes.push_back(fmt::format("no picture {}.png: gnuplot said {}", name, result.output));
  };
  for (const StudyFigure& figure : report.figures)
    if (!figure.curves.empty()) draw(figure.name, curveData(figure), curveScript(figure));
  for (const StudySurfaces& surfaces : report.surfaces)
    if (!surfaces.panels.empty()) draw(surfaces.name, surfaceData(surfaces), surfaceScript(surfaces));
  return notes;
}

}  // namespace ringwatch

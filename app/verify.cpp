#include <ringwatch/app/verify.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include <ringwatch/app/gnuplot.h>
#include <ringwatch/app/integrator_catalog.h>
#include <ringwatch/app/subprocess.h>
#include <ringwatch/base/atomic_file.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/nearest_name.h>
#include <ringwatch/verify/elements.h>
#include <ringwatch/verify/handlers.h>
#include <ringwatch/verify/integrators.h>
#include <ringwatch/verify/monitor.h>
#include <ringwatch/verify/stress.h>

namespace ringwatch {
namespace {

const std::array<StudyInfo, 5> studies{{
    {"elements", "every element and quadrature rule: rank, patch test, derivatives, convergence, frequencies, locking",
     verifyElements},
    {"handlers",
     "every handler beyond the critical step: what it takes, error, cost, energy and momentum over many steps",
     verifyHandlers},
    {"integrators", "every integrator: stability limit, order, energy drift, reversibility, damping",
     [](StudyEffort effort) { return verifyIntegrators(effort, integratorCatalog().entries()); }},
    {"monitor", "bracket, metrics, drift bounds and alarms of the monitor against exact values; nonlinear histories",
     verifyMonitor},
    {"stress", "explicit integrators run long and on hard bodies: who survives, and with what error",
     [](StudyEffort effort) { return verifyStress(effort); }},
}};

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

}  // namespace

std::span<const StudyInfo> allStudies() { return studies; }

std::vector<StudyReport> runStudies(const std::vector<std::string>& names, StudyEffort effort) {
  std::vector<const StudyInfo*> chosen;
  for (const std::string& name : names) {
    if (name == "all") {
      chosen.clear();
      break;
    }
    const auto found = std::find_if(studies.begin(), studies.end(), [&](const StudyInfo& s) { return s.name == name; });
    if (found == studies.end()) {
      std::string known = "all";
      for (const StudyInfo& s : studies) known += fmt::format(", {}", s.name);
      throw InputError(fmt::format("verify: \"{}\": there is no such study; known are {}", name, known));
    }
    chosen.push_back(found);
  }
  if (chosen.empty())
    for (const StudyInfo& s : studies) chosen.push_back(&s);
  std::vector<StudyReport> reports;
  for (const StudyInfo* s : chosen) reports.push_back(s->run(effort));
  return reports;
}

std::string studyText(const StudyReport& report) {
  std::string text = fmt::format("== {}\n", report.study);
  for (const StudyTable& table : report.tables) text += fmt::format("\n{}", tableText(table));
  std::size_t failed = 0;
  for (const StudyCheck& check : report.checks) failed += !check.passed;
  if (!report.checks.empty()) text += fmt::format("\n{} checks, {} failed\n", report.checks.size(), failed);
  for (const StudyCheck& check : report.checks)
    if (!check.passed)
      text += fmt::format("  FAILED {}: measured {:.9g}, expected {:.9g}, tolerance {:.3g}\n", check.name,
                          check.measured, check.expected, check.tolerance);
  return text;
}

nlohmann::ordered_json studiesJson(const std::vector<StudyReport>& reports) {
  nlohmann::ordered_json json;
  json["passed"] = std::all_of(reports.begin(), reports.end(), [](const StudyReport& r) { return r.passed(); });
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
                                 {"passed", check.passed}});
  }
  return json;
}

std::vector<std::string> drawFigures(const StudyReport& report, const std::filesystem::path& folder) {
  std::vector<std::string> notes;
  for (const StudyFigure& figure : report.figures) {
    std::string data;
    for (const StudyFigure::Curve& curve : figure.curves) {
      data += fmt::format("# {}\n", curve.label);
      for (std::size_t i = 0; i < curve.x.size() && i < curve.y.size(); ++i)
        data += fmt::format("{} {}\n", curve.x[i], curve.y[i]);
      data += "\n\n";
    }
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
    for (std::size_t c = 0; c < figure.curves.size(); ++c)
      plot += fmt::format("{}'{}.dat' index {} with linespoints lw 2 dt {} title {}",
                          plot.empty() ? "plot " : ", \\\n     ", figure.name, c, c < colours ? 1 : 2,
                          gnuplotQuoted(figure.curves[c].label));
    if (plot.empty()) continue;
    writeFileAtomically(folder / (figure.name + ".dat"), data);
    writeFileAtomically(folder / (figure.name + ".gp"), script + plot + "\n");
    const ProgramResult result = runProgram({"gnuplot", figure.name + ".gp"}, folder);
    if (!result.found)
      notes.push_back(
          fmt::format("no picture {}.png: gnuplot is not installed (Debian: gnuplot-nox); its script is in {}",
                      figure.name, folder.string()));
    else if (result.status != 0)
      notes.push_back(fmt::format("no picture {}.png: gnuplot said {}", figure.name, result.output));
  }
  return notes;
}

}  // namespace ringwatch

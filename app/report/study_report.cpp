#include <ringwatch/app/report/study_report.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <Eigen/Core>

#include <ringwatch/app/output/report.h>
#include <ringwatch/app/report/charts.h>
#include <ringwatch/app/report/json_read.h>
#include <ringwatch/app/report/report_page.h>
#include <ringwatch/app/report/surface_picture.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/verify/report.h>

namespace ringwatch {
namespace {

std::string cellText(const StudyTable::Cell& cell) {
  return std::visit(
      [](const auto& value) {
        if constexpr (std::is_same_v<std::decay_t<decltype(value)>, double>)
          return fmt::format("{:.6g}", value);
        else
          return fmt::format("{}", value);
      },
      cell);
}

/// A table; a long one folded up.
std::string studyTable(const std::string& study, const StudyTable& table) {
  std::string rows;
  for (const auto& row : table.rows) {
    rows += "<tr>";
    for (std::size_t c = 0; c < row.size(); ++c)
      rows += (c == 0 ? "<th scope=\"row\">" : "<td>") + htmlText(cellText(row[c])) + (c == 0 ? "</th>" : "</td>");
    rows += "</tr>\n";
  }
  const std::string html = tableHtml(table.title, table.columns, rows, study + ", table " + table.name);
  constexpr std::size_t longFrom = 25;
  return table.rows.size() < longFrom ? html
                                      : fmt::format("<details><summary>{}: {} rows</summary>{}</details>\n",
                                                    htmlText(table.title), table.rows.size(), html);
}

std::string senseText(const StudyCheck& check) {
  return check.sense == StudyCheck::Sense::near     ? fmt::format("{:.6g} ± {:.3g}", check.expected, check.tolerance)
         : check.sense == StudyCheck::Sense::atMost ? fmt::format("at most {:.6g}", check.expected + check.tolerance)
                                                    : fmt::format("at least {:.6g}", check.expected - check.tolerance);
}

std::string checksTable(const StudyReport& report) {
  if (report.checks.empty()) return {};
  std::string rows;
  for (const bool passed : {false, true})
    for (const StudyCheck& check : report.checks)
      if (check.passed() == passed)
        rows += fmt::format("<tr><th scope=\"row\">{}</th><td>{:.6g}</td><td>{}</td><td>{}</td></tr>\n",
                            htmlText(check.name), check.measured, senseText(check), passed ? "yes" : "no");
  const std::string table =
      tableHtml("Checks", {"What", "Measured", "Expected", "Passed"}, rows, "Checks of " + report.study);
  return fmt::format("<details{}><summary>{} checks</summary>{}</details>\n", report.passed() ? "" : " open",
                     report.checks.size(), table);
}

std::string surfacesHtml(const StudySurfaces& surfaces) {
  double least = infinity, largest = 0;
  for (const StudySurfaces::Panel& panel : surfaces.panels)
    for (const double value : panel.values)
      if (std::isfinite(value) && value > 0) {
        least = std::min(least, value);
        largest = std::max(largest, value);
      }
  std::string html = fmt::format("<h3>{}</h3>\n", htmlText(surfaces.title));
  for (const StudySurfaces::Panel& panel : surfaces.panels) {
    Eigen::Matrix3Xf positions(3, static_cast<Eigen::Index>(panel.points.size()));
    for (std::size_t i = 0; i < panel.points.size(); ++i)
      for (int k = 0; k < 3; ++k) positions(k, static_cast<Eigen::Index>(i)) = static_cast<float>(panel.points[i][k]);
    std::vector<ColouredTriangle> triangles;
    for (std::size_t t = 0; t + 2 < panel.points.size(); t += 3) {
      const double value = std::cbrt(panel.values[t] * panel.values[t + 1] * panel.values[t + 2]);
      const double share = value > 0 && least < largest ? std::log(value / least) / std::log(largest / least)
                                                        : std::numeric_limits<double>::quiet_NaN();
      const auto node = static_cast<std::int32_t>(t);
      triangles.push_back({{node, node + 1, node + 2}, scaleColour(share)});
    }
    constexpr int width = 480, height = 280;
    const std::string picture = surfacePng(positions, triangles, width, height);
    if (picture.empty()) continue;
    html += fmt::format(
        "<svg class=\"panel\" viewBox=\"0 0 {0} {1}\" role=\"img\" aria-label=\"{2}\"><text class=\"tick\" x=\"4\" "
        "y=\"14\">{2}</text><image width=\"{0}\" height=\"{1}\" href=\"data:image/png;base64,{3}\"/></svg>\n",
        width, height, htmlText(panel.label), base64(picture));
  }
  if (least <= largest)
    html += fmt::format(
        "<p class=\"legend\"><span>{}</span><span>{:.3g}</span><span class=\"scale\" "
        "aria-hidden=\"true\"></span><span>{:.3g}"
        "</span></p>\n",
        htmlText(surfaces.valueLabel), least, largest);
  return html;
}

PageSection studySection(const StudyReport& report, std::size_t number) {
  const std::string id = fmt::format("study-{}", number);
  std::string html = fmt::format("<section id=\"{0}\" aria-labelledby=\"{0}-title\">\n<h2 id=\"{0}-title\">{1}</h2>\n",
                                 id, htmlText(report.study));
  for (const StudyFigure& figure : report.figures) {
    const std::string svg = figureSvg(figure);
    html += fmt::format("<h3>{}</h3>\n{}\n", htmlText(figure.title),
                        svg.empty() ? "<p>No curve has a point that can be drawn.</p>"
                                    : wideHtml(report.study + ", picture " + figure.name, svg));
  }
  for (const StudySurfaces& surfaces : report.surfaces) html += surfacesHtml(surfaces);
  html += checksTable(report);
  for (const StudyTable& table : report.tables) html += studyTable(report.study, table);
  return {id, report.study, html + "</section>\n"};
}

PageVerdict verdictOf(const StudyPage& page, std::string& failures) {
  PageVerdict verdict;
  std::size_t checks = 0;
  std::vector<std::string> failed;
  for (const StudyReport& report : page.reports)
    for (const StudyCheck& check : report.checks) {
      ++checks;
      if (!check.passed())
        failed.push_back(fmt::format("{}, {}: {:.6g} was measured, {} expected.", report.study, check.name,
                                     check.measured, senseText(check)));
    }
  verdict.tone = failed.empty() ? PageVerdict::Tone::good : PageVerdict::Tone::bad;
  if (checks > 0) {
    verdict.title = failed.empty() ? "All checks passed" : fmt::format("{} checks failed", failed.size());
    verdict.sentence = fmt::format("{} of {} checks of {} {} passed.", checks - failed.size(), checks,
                                   page.reports.size(), page.reports.size() == 1 ? "study" : "studies");
  } else {
    verdict.title = "Compared";
  }
  for (const std::string& sentence : page.found) verdict.sentence += (verdict.sentence.empty() ? "" : " ") + sentence;
  constexpr std::size_t most = 20;
  if (!failed.empty()) failures = "<h3>What failed</h3>\n<ul>\n";
  for (std::size_t i = 0; i < std::min(most, failed.size()); ++i)
    failures += fmt::format("<li>{}</li>\n", htmlText(failed[i]));
  if (failed.size() > most) failures += fmt::format("<li>and {} more</li>\n", failed.size() - most);
  if (!failed.empty()) failures += "</ul>\n";
  return verdict;
}

}  // namespace

ReportResult writeStudyReport(const StudyPage& content, const std::filesystem::path& file) {
  using json_read::textOf;
  std::string failures;
  const PageVerdict verdict = verdictOf(content, failures);
  Page page;
  page.title = fmt::format("{}: {}", content.name, verdict.title);
  page.heading = content.name;
  page.sections.push_back(verdictSection(verdict, {}, failures));
  for (std::size_t i = 0; i < content.reports.size(); ++i)
    page.sections.push_back(studySection(content.reports[i], i + 1));
  std::string rows = provenanceRow("results of", "ringwatch " + std::string(programVersion()));
  for (const auto& [key, value] : content.provenance.items())
    if (value.is_string() && key != "scene_text") rows += provenanceRow(key, value.get<std::string>());
  page.sections.push_back(
      provenanceSection(saveButton("save-json", "All data (JSON)"), "the file of --json", rows, ""));
  page.embedded = {{"name", content.name},    {"verdict", {{"title", verdict.title}, {"sentence", verdict.sentence}}},
                   {"history", nullptr},      {"mesh", nullptr},
                   {"results", content.json}, {"provenance", content.provenance}};
  return writtenPage(pageHtml(page), verdict, {}, file);
}

}  // namespace ringwatch

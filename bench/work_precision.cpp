// Work against precision: every integrator over a range of steps on (a) an oscillator, (b) a swinging StVK bar, (c) the
// same bar with slivers, against a converged reference; and, as in Fierz 2013, fig. 1.2, the cost of a millisecond of a
// bar as it is refined, explicit against implicit. For scenes of your own: ringwatch compare.
//
//   ringwatch_work_precision [FOLDER] [--quick]
//   ringwatch_work_precision [FOLDER] --whole [--quick]
//
// With --whole instead the error of mesh, element and integration together against run time (error_against_time.h):
// FOLDER/error_against_time.json with every run, a picture for each motion, and the table of the cheapest as Markdown.
//
// One thread throughout. Writes FOLDER/work_precision.json, a gnuplot script with its data for each picture, and the
// pictures when gnuplot is there. Prints which integrator is cheapest for 1 %, 0.1 % and 1e-6.
#include <exception>
#include <filesystem>
#include <iostream>
#include <span>
#include <string>

#include <fmt/format.h>

#include <ringwatch/app/analysis/compare.h>
#include <ringwatch/app/command/verify.h>
#include <ringwatch/app/scene/integrator_catalog.h>
#include <ringwatch/base/atomic_file.h>
#include <ringwatch/extensions/extensions.h>
#include <ringwatch/verify/work_precision/error_against_time.h>
#ifdef RINGWATCH_HAS_SUNDIALS
#include <ringwatch/integrators/sundials/implicit.h>
#endif

namespace {

using namespace ringwatch;

std::string cellText(const StudyTable::Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  if (const auto* count = std::get_if<std::int64_t>(&cell)) return std::to_string(*count);
  return fmt::format("{:.3g}", std::get<double>(cell));
}
std::string markdown(const StudyTable& table) {
  std::string text = fmt::format("| {} |\n", fmt::join(table.columns, " | "));
  text += "|";
  for (std::size_t i = 0; i < table.columns.size(); ++i) text += "---|";
  text += "\n";
  for (const auto& row : table.rows) {
    text += "|";
    for (const StudyTable::Cell& cell : row) text += " " + cellText(cell) + " |";
    text += "\n";
  }
  return text;
}

void writeWholePicture(const std::filesystem::path& folder, StudyEffort effort, StudyReport& report) {
  report.study = "error against time";
  const std::vector<ErrorCost> runs = addErrorAgainstTime(integratorCatalog().entries(), effort, report,
                                                          [](const std::string& what) { std::cerr << what << "\n"; });
  auto rows = nlohmann::ordered_json::array();
  for (const ErrorCost& run : runs)
    rows.push_back({{"motion", run.motion},
                    {"element", run.element},
                    {"mesh", run.mesh},
                    {"elements", run.elements},
                    {"method", run.method},
                    {"precision", "double"},
                    {"h", run.h},
                    {"error", run.error},
                    {"seconds", run.seconds}});
  writeFileAtomically(folder / "error_against_time.json", rows.dump(1) + "\n");
  for (const StudyCheck& check : report.checks)
    std::cout << fmt::format("{} {:.2g}, at most {:.2g}: {}\n", check.name, check.measured, check.tolerance,
                             check.passed() ? "holds" : "does not hold");
  std::cout << "\n" << markdown(report.tables.back());
  for (const std::string& note : drawFigures(report, folder)) std::cerr << "note: " << note << "\n";
}

}  // namespace

int main(int argc, char** argv) try {
  using namespace ringwatch;
  registerExtensions();
  std::filesystem::path folder = "work_precision";
  bool quick = false, whole = false;
  for (const std::string argument : std::span(argv, static_cast<std::size_t>(argc)).subspan(1)) {
    if (argument == "--quick")
      quick = true;
    else if (argument == "--whole")
      whole = true;
    else
      folder = argument;
  }
  std::filesystem::create_directories(folder);
  StudyReport report;
  if (whole) {
    writeWholePicture(folder, quick ? StudyEffort::quick : StudyEffort::full, report);
    return report.passed() ? 0 : 1;
  }
  report.study = "work and precision";
  nlohmann::ordered_json results;
  addStandardCases(integratorCatalog().entries(), quick ? 4 : 7, quick ? 0.1 : 0.5, report,
                   [&](const WorkPrecisionCase& c, const std::vector<WorkPrecisionRun>& runs) {
                     results[c.name] = workPrecisionJson(c, runs);
                   });
#ifdef RINGWATCH_HAS_SUNDIALS
  addRefinedBar(
      [] {
        ImplicitOptions options;
        options.linearSolve = LinearSolve::conjugateGradients;
        options.relativeTolerance = options.linearTolerance = 1e-4;
        return std::make_unique<ImplicitEuler>(options);
      },
      quick ? 3 : 6, report);
  results["refinement"] = studiesJson({report})["studies"][report.study]["tables"]["refinement"];
#endif
  std::cout << studyText(report);
  for (const std::string& note : drawFigures(report, folder)) std::cerr << "note: " << note << "\n";
  writeFileAtomically(folder / "work_precision.json", results.dump(1) + "\n");
  return 0;
} catch (const std::exception& fault) {
  std::cerr << fault.what() << "\n";
  return 1;
}

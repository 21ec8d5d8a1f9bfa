#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace ringwatch {

struct ReportOptions {
  std::filesystem::path folder;  // of a run
  std::filesystem::path output;  // empty: report.html in the folder
  std::size_t frames = 0;        // most that the page may hold; 0: as many as keep it small
};

struct ReportResult {
  std::filesystem::path file;
  std::size_t bytes = 0;
  std::size_t frames = 0, framesOfRun = 0;
  std::string title, sentence;     // the verdict
  std::vector<std::string> notes;  // what could not be read
};

/// Writes one page of HTML about a run, from what the run left in its folder. What is missing or damaged is said in the
/// page. Throws InputError when the folder has neither history.csv nor summary.json nor run.pvd, and when the page
/// cannot be written.
ReportResult writeRunReport(const ReportOptions& options);

using ReportWriter = ReportResult (*)(const ReportOptions& options);
/// writeRunReport; nullptr in a program without it. `ringwatch` leaves it to `ringwatch-report`, which takes the same
/// arguments.
ReportWriter reportWriter();

}  // namespace ringwatch

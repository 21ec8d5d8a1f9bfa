#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace ringwatch {

struct Audit;
struct Inspection;
struct StudyReport;

/// A run that goes on while its page is written.
struct LiveRun {
  nlohmann::ordered_json summary;  // as summary.json so far, with `live`: { time, end, seconds_left, monitor_share,
                                   // written }, the shares from 0 to 1, seconds_left null for unknown
  double reloadAfter = 0;          // s, until the page loads itself again
};

struct ReportOptions {
  std::filesystem::path folder;   // of a run
  std::filesystem::path output;   // empty: report.html in the folder
  std::size_t frames = 0;         // most that the page may hold; 0: as many as keep it small
  const LiveRun* live = nullptr;  // while the run goes on
};

struct ReportResult {
  std::filesystem::path file;
  std::size_t bytes = 0;
  std::size_t frames = 0, framesOfRun = 0;
  std::string title, sentence;     // the verdict, without what followed
  std::vector<std::string> notes;  // what could not be read
};

/// Writes one page of HTML about a run, from what the run left in its folder. What is missing or damaged is said in the
/// page. Throws InputError when the folder has neither history.csv nor summary.json nor run.pvd, and when the page
/// cannot be written.
ReportResult writeRunReport(const ReportOptions& options);

/// What the page of studies, or of a comparison of integrators, is about.
struct StudyPage {
  std::string name;                // its heading: "Verification", "Comparison of integrators on bar.toml"
  std::vector<std::string> found;  // what came of it, one sentence each; empty: the checks say it
  std::vector<StudyReport> reports;
  nlohmann::ordered_json json;        // the results, to be saved from the page
  nlohmann::ordered_json provenance;  // of provenanceOf
};

/// What writes the pages.
struct ReportWriters {
  ReportResult (*ofRun)(const ReportOptions& options);
  ReportResult (*ofInspection)(const Inspection& inspection, const std::filesystem::path& file);
  ReportResult (*ofAudit)(const Audit& audit, const std::filesystem::path& file);
  ReportResult (*ofStudies)(const StudyPage& page, const std::filesystem::path& file);
};
/// nullptr in a program without them. `ringwatch` leaves them to `ringwatch-report` and `ringwatch-verify`, which take
/// the same arguments.
const ReportWriters* reportWriters();

}  // namespace ringwatch

#pragma once
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <ringwatch/app/report/charts.h>
#include <ringwatch/app/report/mesh_pack.h>
#include <ringwatch/app/report/page_data.h>
#include <ringwatch/app/report/run_analysis.h>
#include <ringwatch/app/report/run_history.h>
#include <ringwatch/app/report/run_report.h>
#include <ringwatch/app/report/verdict_text.h>

namespace ringwatch {

/// A part of a page under a heading.
struct PageSection {
  std::string id, link, html;  // link: its name in the list of sections; html: <section id="…">…</section>
};

/// Any page: HTML with style, script and data in it, which asks for nothing elsewhere.
struct Page {
  std::string title, heading, subtitle;  // subtitle: "" for none
  std::vector<PageSection> sections;
  nlohmann::ordered_json embedded;  // what the script reads
  PageData data;
  double reloadAfter = 0;  // s, of a page that is written anew; 0 for a page that stays
};
std::string pageHtml(const Page& page);
/// The first section of a page. more: HTML below its remedies.
PageSection verdictSection(const PageVerdict& verdict, const std::vector<std::string>& notes, const std::string& more);
/// A table in a box that can be pushed aside where it is too wide. head: names of its columns; rows: HTML; label: what
/// tells it from the other tables of the page, empty for its caption.
std::string tableHtml(const std::string& caption, const std::vector<std::string>& head, const std::string& rows,
                      const std::string& label = "");
/// A picture in a box that can be pushed aside where it is too wide. name: unique on the page.
std::string wideHtml(const std::string& name, const std::string& svg);

/// A button that the page's script makes save something.
std::string saveButton(const char* id, const char* text);
/// A row of the table of provenance; "" for an empty value.
std::string provenanceRow(const std::string& name, const std::string& value);
/// The last section. buttons: of saveButton; elsewhere: where else the numbers are; rows: of provenanceRow; more: HTML
/// below the table.
PageSection provenanceSection(const std::string& buttons, const std::string& elsewhere, const std::string& rows,
                              const std::string& more);

/// What pages of a run, of a mesh and of results say differently.
struct PageWords {
  std::string_view writtenBy = "run by";
  std::string_view elsewhere = "history.csv, summary.json and frames/";  // the numbers are there too
  std::string_view noFrames =
      "The folder has no frames that can be read. A run writes them when its scene has output.every.";
  std::string_view otherFrames = "lie beside it for ParaView";
  std::string_view noBracket =
      "This run kept no bracket (monitor.mode is threshold or metric): its history has the step and, where the monitor "
      "proved it, the verdict.";
  // What they are called where the whole data is.
  std::string_view historyFile = "history.csv beside this page";
  std::string_view frameFiles = "run.pvd and frames/ beside this page, for ParaView";
  std::string_view summaryFile = "summary.json beside this page";
};

/// All that the page of a run, of an inspection or of an audit is made of. What is empty is said to be missing.
struct PageContent {
  std::string name;   // of the page: "Run of stretch_bar.toml"
  bool ofRun = true;  // else of a mesh in one state, without history and frames
  PageWords words;
  double reloadAfter = 0;             // s, while a run goes on
  nlohmann::ordered_json summary;     // null without one
  std::optional<RunHistory> history;  // all rows
  PageVerdict verdict;
  std::vector<ChartMark> marks;
  std::vector<std::string> notes;             // of the page: what could not be read
  PageData data;                              // arrays of the mesh
  nlohmann::ordered_json mesh;                // of MeshPack::finish; null without frames
  std::vector<WorstCard> worst, controlling;  // with the least steps; in the way of the whole body
  std::string picture;                        // PNG
  ColourRange pictureScale;                   // s
  std::string stepField;
  std::int64_t keyFrame = 0;      // number of the frame of picture and cards
  std::string where;              // that state: "in frame 3, t = 0.1 s", "at rest"
  std::optional<double> keyStep;  // s, the step that the run took from there
  std::size_t frames = 0, framesShown = 0;
  std::size_t elements = 0;  // of the mesh at the end
  std::optional<RunAnalysis> analysis;
  std::string whyNoAnalysis;

  /// What a pack has made, when all frames are in it.
  void takeMesh(MeshPack& pack);
};

/// Rows of the longest history that the page holds whole. A longer one is thinned by rowsForPicture, to hardly more
/// rows than these and numbers, which keep the page below 2 MB.
inline constexpr std::size_t rowsOfPage = 20000, numbersOfPage = 150000;

/// The page of a run or an inspection; takes mesh, summary and arrays out of its content.
std::string reportPage(PageContent& content);

/// Writes a page. Throws InputError when it cannot be written.
ReportResult writtenPage(const std::string& html, const PageVerdict& verdict, const std::vector<std::string>& notes,
                         const std::filesystem::path& file);

}  // namespace ringwatch

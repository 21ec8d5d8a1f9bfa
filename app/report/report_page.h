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
#include <ringwatch/app/report/verdict_text.h>

namespace ringwatch {

/// All that a page is made of. What is empty is said to be missing.
struct PageContent {
  std::string name;                   // of the run
  nlohmann::ordered_json summary;     // null without one
  std::optional<RunHistory> history;  // all rows
  PageVerdict verdict;
  std::vector<ChartMark> marks;
  std::vector<std::string> notes;  // of the page: what could not be read
  PageData data;                   // arrays of the mesh
  nlohmann::ordered_json mesh;     // of MeshPack::finish; null without frames
  std::vector<WorstCard> worst;
  std::string picture;  // PNG
  MeshPack::Scale pictureScale;
  std::string stepField;
  std::int64_t keyFrame = 0;      // number of the frame of picture and cards
  double keyTime = 0;             // s
  std::optional<double> keyStep;  // s, the step that the run took from there
  std::size_t frames = 0, framesShown = 0;
  std::size_t elements = 0;  // of the mesh at the end
  std::optional<RunAnalysis> analysis;
  std::string whyNoAnalysis;
};

/// Rows of a history that the page holds at most, or hardly more; a longer one is thinned by rowsForPicture.
inline constexpr std::size_t rowsOfPage = 20000;

/// The page: HTML with style, script and data in it, which asks for nothing elsewhere.
std::string reportPage(PageContent content);

}  // namespace ringwatch

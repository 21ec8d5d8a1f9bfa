// The page of a run: what it says, that its numbers are those of the run, and what it makes of folders that lack
// something. How it looks and what its controls do is tested in a browser, by report_page_test.py.
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <random>
#include <regex>

#include <ringwatch/app/command/live_watch.h>
#include <ringwatch/app/report/mesh_pack.h>
#include <ringwatch/app/report/page_data.h>
#include <ringwatch/app/report/run_history.h>
#include <ringwatch/app/report/verdict_text.h>
#include <ringwatch/base/infinity.h>

#include "program.h"

namespace ringwatch {
namespace {

using test::Json;
using test::Outcome;
using test::tiny;
using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

std::string unpackedBase64(const std::string& text) {
  std::string bytes;
  std::uint32_t bits = 0;
  int held = 0;
  for (const char c : text) {
    const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const char* found = std::strchr(letters, c);
    if (c == '=' || found == nullptr) break;
    bits = bits << 6 | static_cast<std::uint32_t>(found - letters);
    held += 6;
    if (held >= 8) bytes += static_cast<char>(bits >> (held -= 8) & 0xFF);
  }
  return bytes;
}

/// An array of a page, as a browser unpacks it.
template <class T>
std::vector<T> arrayIn(const std::string& page, std::size_t number) {
  const std::string head = "id=\"array-" + std::to_string(number) + "\"";
  const std::size_t at = page.find(head);
  if (at == std::string::npos) throw std::runtime_error("no " + head);
  const std::size_t count = std::stoull(page.substr(page.find("data-count=\"", at) + 12));
  const std::size_t begin = page.find('>', at) + 1, end = page.find('<', begin);
  const std::string packed = unpackedBase64(page.substr(begin, end - begin));
  std::string planes(count * sizeof(T), '\0');
  uLongf size = planes.size();
  if (uncompress(reinterpret_cast<Bytef*>(planes.data()), &size, reinterpret_cast<const Bytef*>(packed.data()),
                 packed.size()) != Z_OK ||
      size != planes.size())
    throw std::runtime_error("cannot unpack " + head);
  std::vector<T> values(count);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t b = 0; b < sizeof(T); ++b) reinterpret_cast<char*>(&values[i])[b] = planes[b * count + i];
  return values;
}

Json reportIn(const std::string& page) {
  const std::string head = "<script type=\"application/json\" id=\"report\">";
  const std::size_t begin = page.find(head) + head.size();
  return Json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

class Report : public test::Program {
 protected:
  void makeRun(const std::string& options = "", int status = 0) {
    folder_.write("tiny.toml", tiny);
    ASSERT_EQ(call("run tiny.toml --set integrator.step=5e-4 --out r " + options).status, status);
  }
  std::string page() const { return folder_.read("r/report.html"); }
};

TEST_F(Report, HoldsVerdictSectionsAndNothingFromElsewhere) {
  makeRun("--report");
  const std::string html = page();
  const Json summary = json("r/summary.json"), report = reportIn(html);
  EXPECT_EQ(report["summary"], summary);
  EXPECT_EQ(report["verdict"]["title"], "Stable");
  EXPECT_THAT(html, HasSubstr(report["verdict"]["sentence"].get<std::string>()));
  for (const char* section : {"verdict", "history", "mesh", "distribution", "what-if", "provenance"})
    EXPECT_THAT(html, HasSubstr("<section id=\"" + std::string(section) + "\""));
  EXPECT_THAT(html, HasSubstr("default-src 'none'"));
  // What a browser would fetch: sources and links of elements, before the scripts.
  const std::string markup = html.substr(0, html.find("<script"));
  EXPECT_FALSE(std::regex_search(markup, std::regex("(src|href)=\"(https?:)?//|url\\(\\s*[\"']?http|@import")));
  EXPECT_EQ(summary["provenance"]["command"], "ringwatch run tiny.toml --set 'integrator.step=5e-4'");
  // As a shell takes it again.
  std::filesystem::copy_file(folder_.path() / "tiny.toml", folder_.path() / "it's tiny.toml");
  ASSERT_EQ(call("run \"it's tiny.toml\" --out quoted --set integrator.end=2e-3").status, 0);
  EXPECT_EQ(json("quoted/summary.json")["provenance"]["command"],
            "ringwatch run 'it'\\''s tiny.toml' --set 'integrator.end=2e-3'");
  EXPECT_EQ(summary["provenance"]["scene_text"], tiny);
}

TEST_F(Report, ItsHistoryIsThatOfTheRunToTheLastBit) {
  makeRun();
  ASSERT_EQ(call("report r").status, 0);
  const std::string html = page();
  const Json history = reportIn(html)["history"];
  const Table csv = table("r/history.csv");
  ASSERT_EQ(history["rows"], csv.rows.size());
  int columns = 0;
  for (const Json& column : history["columns"]) {
    const auto values = arrayIn<double>(html, column["array"]);
    ASSERT_EQ(values.size(), csv.rows.size());
    ++columns;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::string cell = csv.at(i, column["name"]);
      if (cell.empty())
        EXPECT_TRUE(std::isnan(values[i]));
      else
        EXPECT_EQ(values[i], std::stod(cell)) << column["name"] << " in row " << i;
    }
  }
  EXPECT_EQ(columns, 15);
  const auto controlling = arrayIn<std::int32_t>(html, history["controlling"]);
  for (std::size_t i = 0; i < controlling.size(); ++i)
    EXPECT_EQ(history["elements"][controlling[i]], csv.at(i, "controlling_element"));
}

TEST_F(Report, ItsFramesHoldPositionsAndStepsOfTheElements) {
  makeRun();
  ASSERT_EQ(call("report r").status, 0);
  const std::string html = page();
  const Json mesh = reportIn(html)["mesh"];
  ASSERT_EQ(mesh["groups"].size(), 1u);
  const Json group = mesh["groups"][0];
  // Cards are of the key frame: that of the smallest safe step in a run without a violation.
  const auto key = reportIn(html)["keyFrame"].get<std::size_t>();
  ASSERT_GE(key, 1u);
  ASSERT_LE(key, group["frames"].size());
  const Json shown = group["frames"][key - 1];
  // inspect reads the same frame by another way and evaluates the metric itself.
  ASSERT_EQ(
      call("inspect r --frame " + std::to_string(key) + " --metric reduced-1-ring --distribution --json i.json").status,
      0);
  const Json worst = json("i.json")["worst_elements"];
  ASSERT_EQ(reportIn(html)["worst"].size(), 10u);
  for (std::size_t i = 0; i < 10; ++i)
    EXPECT_NEAR(reportIn(html)["worst"][i]["step"].get<double>() / worst[i]["step"].get<double>(), 1, 1e-9) << i;
  const auto codes = arrayIn<std::uint16_t>(html, shown["fields"][0]["array"]);
  EXPECT_EQ(codes.size(), group["elements"].get<std::size_t>());
  EXPECT_NEAR(shown["fields"][0]["min"].get<double>() / worst[0]["step"].get<double>(), 1, 1e-6);  // kept as float
  // The bar is pulled to x = 0.1 + 0.05 t.
  EXPECT_NEAR(shown["max"][0].get<double>(), 0.1 + 0.05 * shown["time"].get<double>(), 1e-7);
  EXPECT_NEAR(group["frames"][0]["max"][0].get<double>(), 0.1, 1e-7);
  const auto positions = arrayIn<std::uint16_t>(html, shown["positions"]);
  EXPECT_EQ(positions.size(), 3 * group["nodes"].get<std::size_t>());
  EXPECT_EQ(*std::max_element(positions.begin(), positions.end()), 65535);
  const auto triangles = arrayIn<std::int32_t>(html, group["triangles"]);
  EXPECT_EQ(triangles.size(), 3u * 2 * (4 * 5 + 2));  // a bar of 5 by 1 by 1 cells, whose faces are cut in two
}

TEST_F(Report, ShowsTheMostStrainedOfStatesWithHardlyAnotherStep) {
  folder_.write("tiny.toml", tiny);
  ASSERT_EQ(call("run tiny.toml --set integrator.step=5e-4 --out r --report").status, 0);
  const Table csv = table("r/history.csv");
  double least = infinity, most = -1, time = 0;
  std::map<std::string, int> rows;
  for (std::size_t i = 0; i < csv.rows.size(); ++i) least = std::min(least, std::stod(csv.at(i, "safe_s")));
  for (std::size_t i = 0; i < csv.rows.size(); ++i) {
    ++rows[csv.at(i, "controlling_element")];
    if (std::stod(csv.at(i, "safe_s")) <= 1.05 * least && std::stod(csv.at(i, "strain_J")) > most)
      most = std::stod(csv.at(i, "strain_J")), time = std::stod(csv.at(i, "time_s"));
  }
  ASSERT_GT(time, 0);
  const Json report = reportIn(page()), frames = report["mesh"]["groups"][0]["frames"];
  const auto key = report["keyFrame"].get<std::size_t>();
  EXPECT_GE(frames[key - 1]["time"].get<double>(), time * (1 - 1e-12));
  if (key > 1) {
    EXPECT_LT(frames[key - 2]["time"].get<double>(), time);
  }
  // First of the elements in the way is that of most rows.
  const auto longest = std::max_element(rows.begin(), rows.end(), [](auto& a, auto& b) { return a.second < b.second; });
  const Json first = report["controlling"][0];
  EXPECT_EQ(rows[first["block"].dump() + ":" + first["index"].dump()], longest->second);
}

TEST(ReportColours, DoNotSpreadWhatDiffersByRounding) {
  for (const double high : {1.0, 1 + 1e-15, 1.04}) {
    const ColourRange range = ColourRange::about(1, high);
    EXPECT_NEAR(range.high / range.low, ColourRange::least, 1e-12);
    EXPECT_NEAR(range.low * range.high, high, 1e-12);
  }
  EXPECT_EQ(ColourRange::about(1, 2).low, 1);
  EXPECT_EQ(ColourRange::about(1, 2).high, 2);
}

TEST_F(Report, SaysWhichElementWhenAndWhatToDo) {
  folder_.write("tiny.toml", tiny);
  ASSERT_EQ(call("run tiny.toml --set integrator.step=4e-3 --set integrator.end=0.2 --out r --report").status, 1);
  const Json summary = json("r/summary.json"), verdict = reportIn(page())["verdict"];
  const Json* violated = nullptr;
  for (const Json& event : summary["events"])
    if (event["kind"] == "violated" && !violated) violated = &event;
  ASSERT_NE(violated, nullptr);
  EXPECT_EQ(verdict["title"], "Step too large");
  const std::string sentence = verdict["sentence"];
  EXPECT_THAT(sentence, HasSubstr("step " + (*violated)["step"].dump() + ", t = "));
  EXPECT_THAT(sentence, HasSubstr("element " + (*violated)["element"]["id"].dump() + " of the mesh"));
  EXPECT_THAT(sentence, HasSubstr((*violated)["cause"].get<std::string>()));
  // The same as data: by the element's strain and shape alone the sentence can be told.
  const Json& diagnosis = (*violated)["diagnosis"];
  EXPECT_EQ(diagnosis["strain"] == "unstrained",
            !(diagnosis["largest_stretch"] > 1.05 || diagnosis["least_stretch"] < 1 / 1.05));
  EXPECT_EQ(diagnosis["determinant"] <= 0, diagnosis["strain"] == "inverted");
  EXPECT_THAT(sentence, HasSubstr("stopped before"));
  // The command ends with what happened first, and leaves what followed to the page.
  EXPECT_THAT(call("report r").out, EndsWith("The run was stopped before it took that step.\n"));
  const Json report = reportIn(page());
  for (const char* key : {"block", "index", "id"})
    EXPECT_EQ(report["controlling"][0][key], (*violated)["element"][key]);
  EXPECT_THAT(verdict["remedies"].dump(), AllOf(HasSubstr("smaller step"), HasSubstr("handler")));
}

// Why a step is small and what would help are said apart, so that nothing is advised twice and otherwise.
TEST_F(Report, AdvisesInOnePlace) {
  folder_.write("tiny.toml", tiny);
  for (const char* settings : {"", "--set integrator.step=4e-3 --set integrator.end=0.2 --set output.every=1e-3"}) {
    EXPECT_LE(call(std::string("run tiny.toml --out r --report ") + settings).status, 1);
    const Json report = reportIn(page()), why = report["summary"]["why"], verdict = report["verdict"];
    ASSERT_FALSE(why.is_null()) << settings;
    const std::string sentence = verdict["sentence"], remedies = verdict["remedies"].dump();
    EXPECT_THAT(sentence, HasSubstr(why["text"][0].get<std::string>()));
    ASSERT_FALSE(why["remedies"].empty());
    for (const Json& line : why["remedies"]) EXPECT_THAT(sentence, Not(HasSubstr(line.get<std::string>())));
    EXPECT_FALSE(remedies.find("handler") != std::string::npos && remedies.find("No few") != std::string::npos);
  }
}

// Where the monitor takes nearly all of the time, a larger step gains as much as it is larger, with every handler.
TEST_F(Report, GainsCountTheMonitor) {
  folder_.write("tiny.toml", tiny);
  ASSERT_EQ(call("run tiny.toml --set integrator.step=4e-3 --set integrator.end=0.04 --set output.every=1e-3 --out r "
                 "--set monitor.on_violation=warn")
                .status,
            1);
  const auto reported = [&](double monitor) {
    Json summary = json("r/summary.json");
    summary["wall_time"]["monitor"] = monitor;
    folder_.write("r/summary.json", summary.dump());
    EXPECT_EQ(call("report r").status, 0);
    return reportIn(page());
  };
  constexpr double longest = 1e6;  // s, far above all steps together
  const Json slow = reported(longest)["analysis"], alone = reported(0)["analysis"];
  int compared = 0, other = 0;
  for (std::size_t row = 0; row < slow["what_if"].size(); ++row)
    for (std::size_t i = 0; i < slow["what_if"][row]["handlers"].size(); ++i) {
      const Json &gain = slow["what_if"][row]["handlers"][i]["gain"],
                 &unwatched = alone["what_if"][row]["handlers"][i]["gain"];
      if (gain.is_null()) continue;
      // The first row is that of the safe step.
      const double larger = slow["what_if"][row]["step"].get<double>() / slow["what_if"][0]["step"].get<double>();
      EXPECT_NEAR(gain.get<double>() / larger, 1, 1e-3);
      ++compared;
      other += std::abs(unwatched.get<double>() / larger - 1) > 0.05 ? 1 : 0;
    }
  EXPECT_GT(compared, 0);
  EXPECT_GT(other, 0);  // where nothing watches, steps with a handler cost more or less than those without
}

TEST(ReportHistory, ThinningKeepsEverySpikeAndVerdict) {
  RunHistory history;
  history.columns = {{"step", {}}, {"time_s", {}}, {"h_s", {}}, {"safe_s", {}}, {"kinetic_J", {}}};
  const std::size_t rows = 100000;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> noise(0.9, 1.1);
  for (std::size_t i = 0; i < rows; ++i) {
    const double values[] = {static_cast<double>(i), 1e-3 * static_cast<double>(i), 1e-3, noise(random), noise(random)};
    for (std::size_t c = 0; c < 5; ++c) history.columns[c].values.push_back(values[c]);
    history.verdicts.emplace_back(i == 70707 ? "violated" : "certified");
    history.controlling.push_back(-1);
  }
  history.columns[3].values[31416] = 0.01;
  history.columns[4].values[27182] = 50;
  history.columns[4].values[99000] = std::nan("");
  const auto kept = rowsForPicture(history, 2000);
  EXPECT_LE(kept.size(), 2100u);
  EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
  for (const std::size_t row :
       {std::size_t{0}, std::size_t{27182}, std::size_t{31416}, std::size_t{70707}, std::size_t{99000}, rows - 1})
    EXPECT_TRUE(std::binary_search(kept.begin(), kept.end(), row)) << row;
  // Any window of a bucket's length shows the extremes that all of its rows have: compared over the whole.
  const RunHistory thin = selected(history, kept);
  EXPECT_EQ(*std::min_element(thin.columns[3].values.begin(), thin.columns[3].values.end()), 0.01);
  EXPECT_EQ(thin.columns[3].values.size(), kept.size());
  EXPECT_EQ(rowsForPicture(history, rows).size(), rows);
}

TEST_F(Report, OfALongRunIsSmall) {
  std::string csv =
      "step,time_s,h_s,safe_s,optimistic_s,controlling_element,kinetic_J,strain_J,external_work_J,balance_error_J,"
      "elements_refreshed,handled_elements,metric_step_s,verdict,dissipated_J\n";
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(0, 1);
  for (int i = 0; i < 100000; ++i) {
    std::ostringstream row;
    row.precision(17);
    row << i << ',' << 1e-3 * i << ",0.001";
    for (const char* before : {",", ",", ",0:7,", ",", ",", ","}) row << before << any(random);
    row << ",12,0," << any(random) << ",certified," << any(random) << '\n';
    csv += row.str();
  }
  std::filesystem::create_directory(folder_.path() / "r");
  folder_.write("r/history.csv", csv);
  ASSERT_EQ(call("report r").status, 0);
  EXPECT_LE(page().size(), 1000000u + 2000000u);  // page and data
  EXPECT_THAT(page(), HasSubstr("history.csv has 100000 rows"));
}

TEST_F(Report, OfAFolderThatLacksSomethingSaysSo) {
  makeRun();
  const auto without = [&](const std::string& name) {
    std::filesystem::remove_all(folder_.path() / "p");
    std::filesystem::copy(folder_.path() / "r", folder_.path() / "p", std::filesystem::copy_options::recursive);
    std::filesystem::remove_all(folder_.path() / "p" / name);
    const Outcome outcome = call("report p");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return folder_.read("p/report.html");
  };
  // A killed run.
  EXPECT_THAT(without("summary.json"), AllOf(HasSubstr("No end on record"), HasSubstr("it needs the scene")));
  EXPECT_THAT(without("history.csv"), AllOf(HasSubstr("<h2 id=\"verdict-title\">Stable"), HasSubstr("no history.csv")));
  EXPECT_THAT(without("run.pvd"), HasSubstr("no frames that can be read"));
  EXPECT_THAT(without("frames"), HasSubstr("frames cannot be read"));
  without("report.html");
  // The last row is cut, as by a kill.
  const std::string csv = folder_.read("r/history.csv");
  folder_.write("p/history.csv", csv.substr(0, csv.size() - 9));
  ASSERT_EQ(call("report p").status, 0);
  const std::size_t rows = table("r/history.csv").rows.size();
  EXPECT_THAT(folder_.read("p/report.html"), HasSubstr("ends within a row"));
  EXPECT_EQ(reportIn(folder_.read("p/report.html"))["history"]["rows"], rows - 1);
  // One row, and none.
  folder_.write("p/history.csv", csv.substr(0, csv.find('\n', csv.find('\n') + 1) + 1));
  ASSERT_EQ(call("report p").status, 0);
  EXPECT_EQ(reportIn(folder_.read("p/report.html"))["history"]["rows"], 1);
  folder_.write("p/history.csv", csv.substr(0, csv.find('\n') + 1));
  ASSERT_EQ(call("report p").status, 0);
  EXPECT_THAT(folder_.read("p/report.html"), HasSubstr("no history.csv with a row"));
  // A row in the middle is damaged, a frame is, and the summary is.
  std::string damaged = csv;
  damaged.replace(damaged.find("\n1,") + 1, 20, "\n");
  folder_.write("p/history.csv", damaged);
  folder_.write("p/frames/frame_000002.vtu", folder_.read("r/frames/frame_000002.vtu").substr(0, 900));
  for (const std::string& summary :
       {std::string("{\"verdict\": "),
        "{\"scene\": {\"mesh\": " + std::string(200'000, '[') + std::string(200'000, ']') + "}}"}) {
    folder_.write("p/summary.json", summary);
    ASSERT_EQ(call("report p").status, 0);
    EXPECT_THAT(folder_.read("p/report.html"), AllOf(HasSubstr("damaged rows"), HasSubstr("1 frames cannot be read"),
                                                     HasSubstr("summary.json is damaged")));
  }
  // A summary in which everything has another type.
  folder_.write("p/summary.json", R"({"verdict": 3, "events": [1, {"kind": 2}], "mesh": [], "notes": {}, "cuts": 1,
      "scene": "x", "wall_time": null, "first_violated": true, "handler": 7, "provenance": [], "energy_runaway": {"time": "x"}})");
  EXPECT_EQ(call("report p").status, 0);
}

constexpr const char* dropped = R"(mesh = {generate = "bar", size = [0.06, 0.06, 0.06], cells = [3, 3, 3], jitter = 0.1}
material = {model = "neo-hookean", young = 1e6, poisson = 0.3, density = 1000}
integrator = {step = 5e-5, end = 6e-3}
monitor = {on_violation = "warn"}
[[initial]]
where = "all"
velocity = [0, 0, -1]
[[obstacle]]
name = "anvil"
kind = "plane"
point = [0, 0, -0.001]
normal = [0, 0, 1]
[[contact]]
damping = 0.05
[output]
every = 1e-3
fields = ["critical_step", "von_mises"]
picture = false
)";

TEST_F(Report, OfContactThatGovernsNamesItAndAPenaltyThatWouldNot) {
  folder_.write("dropped.toml", dropped);
  ASSERT_EQ(
      call("run dropped.toml --quiet --set contact.0.penalty=1e6 --set monitor.on_violation=stop --out r --report")
          .status,
      1);
  const Json summary = json("r/summary.json"), verdict = reportIn(page())["verdict"];
  const Json& discrete = summary["discrete_forces"];
  const Json* violated = nullptr;
  for (const Json& event : summary["events"])
    if (event["kind"] == "violated" && !violated) violated = &event;
  ASSERT_NE(violated, nullptr);
  ASSERT_GT((*violated)["discrete_share"].get<double>(), 0.5);
  EXPECT_LE((*violated)["discrete_share"].get<double>(), 1 + 1e-9);
  const std::string sentence = verdict["sentence"], remedies = verdict["remedies"].dump();
  EXPECT_THAT(sentence,
              AllOf(HasSubstr("contact governs the step, not the elements"), HasSubstr("into anvil"),
                    HasSubstr("step " + (*violated)["step"].dump() + ", t = "), Not(HasSubstr("in the way is"))));
  // The penalty that the sentence names is the run's room, rounded down; the next run takes it and is proven.
  const std::string limit = stepRoundedDown(discrete["room"]["penalty"]);
  EXPECT_THAT(remedies,
              AllOf(HasSubstr("does not govern with at most " + limit + " N/m"), HasSubstr("this run has 1e+06"),
                    HasSubstr("a penalty of at most " + stepRoundedDown(discrete["room"]["penalty_at_step"]) + " N/m"),
                    HasSubstr("smaller step"), Not(HasSubstr("handler"))));
  EXPECT_EQ(verdict["remedies"][0].get<std::string>().find("A softer contact"), 0u);
  EXPECT_THAT(page(), HasSubstr("handlers do not go with springs and contact"));
  ASSERT_EQ(call("run dropped.toml --quiet --set contact.0.penalty=" + limit + " --set integrator.step=" +
                 test::digits(0.5 * discrete["room"]["elements_alone"].get<double>()) + " --out s --report")
                .status,
            0);
  const Json softer = reportIn(folder_.read("s/report.html"))["verdict"];
  EXPECT_EQ(softer["title"], "Stable");
  EXPECT_THAT(softer["remedies"].dump(), AllOf(Not(HasSubstr("A softer contact")), Not(HasSubstr("handler"))));
}

TEST_F(Report, ThatCannotBeWrittenLeavesTheRunItsStatus) {
  folder_.write("tiny.toml", tiny);
  ASSERT_EQ(shell("mkdir -p r/report.html/in_the_way").status, 0);
  for (const char* option : {"--report", "--live"}) {
    const test::Outcome run = call("run tiny.toml --quiet --set integrator.step=5e-4 --out r " + std::string(option));
    EXPECT_EQ(run.status, 0);
    EXPECT_THAT(run.err,
                AllOf(StartsWith("ringwatch: " + std::string(option) + ": the results are there, but the page"),
                      HasSubstr("r/report.html")));
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1);
    EXPECT_EQ(json("r/summary.json")["exit_status"], 0);
  }
}

TEST_F(Report, OfSpringsThatGovernSaysSo) {
  folder_.write("spring.toml", std::string(tiny) + "[[spring]]\nwhere = \"x > 0.05\"\nstiffness = 1e5\n");
  ASSERT_EQ(call("run spring.toml --quiet --set integrator.step=5e-4 --out r --report").status, 1);
  const Json verdict = reportIn(page())["verdict"];
  EXPECT_THAT(verdict["sentence"].get<std::string>(), HasSubstr("springs govern the step, not the elements"));
  EXPECT_THAT(verdict["remedies"].dump(),
              AllOf(HasSubstr("Softer springs"), Not(HasSubstr("contact")), Not(HasSubstr("handler"))));
}

TEST_F(Report, OfADampedRunAdvisesTheHandlersThatTakeItsDamping) {
  folder_.write("tiny.toml", tiny);
  ASSERT_EQ(call("run tiny.toml --set damping.mass=5 --set integrator.step=4e-3 --set integrator.end=0.2 "
                 "--set output.every=4e-3 --out r --report")
                .status,
            1);
  EXPECT_THAT(reportIn(page())["verdict"]["remedies"].dump(), HasSubstr("handler"));
  EXPECT_THAT(page(), Not(HasSubstr("handlers do not go with")));
  // So does the run that they say.
  EXPECT_NE(call("run tiny.toml --set damping.mass=5 --set handler.method=imex --out s").status, 2);
}

TEST_F(Report, OfElementsThatDampAdvisesNoHandlerAndCountsElementsInTheWay) {
  folder_.write("tiny.toml", tiny);
  ASSERT_EQ(call("run tiny.toml --set damping.bulk_viscosity=true --set integrator.step=4e-3 --set integrator.end=0.2 "
                 "--set output.every=4e-3 --out r --report")
                .status,
            1);
  const Json report = reportIn(page());
  EXPECT_THAT(report["verdict"]["remedies"].dump(), Not(HasSubstr("handler")));
  EXPECT_THAT(page(), HasSubstr("handlers do not go with elements that damp"));
  const Json& rows = report["analysis"]["what_if"];
  ASSERT_GT(rows.size(), 3u);
  EXPECT_EQ(report["analysis"]["what_if_counted_by"], "optimistic step by reduced-1-ring (s)");
  // As many elements as inspect finds with a smaller step in that frame.
  ASSERT_EQ(call("inspect r --frame " + report["keyFrame"].dump() + " --step " + test::digits(rows.back()["step"]) +
                 " --json i.json")
                .status,
            0);
  EXPECT_EQ(rows.back()["elements"], json("i.json")["ill_shaped"]["count"]);
  EXPECT_GT(rows.back()["elements"].get<int>(), 0);
}

TEST_F(Report, ItsDistributionHasTheRulesOfThumb) {
  makeRun("--report");
  const Json report = reportIn(page());
  const auto key = report["keyFrame"].dump();
  ASSERT_EQ(call("inspect r --frame " + key + " --metric all --json i.json").status, 0);
  const Json metrics = json("i.json")["critical_step"]["metrics"];
  std::size_t compared = 0;
  for (const Json& rule : report["analysis"]["rules"]) {
    EXPECT_NEAR(rule["step"].get<double>() / metrics[rule["metric"].get<std::string>()].get<double>(), 1, 1e-9);
    ++compared;
  }
  EXPECT_EQ(compared, 7u);
  EXPECT_GT(metrics["pressure-wave:cell-diameter"].get<double>(), metrics["pressure-wave:shortest-edge"].get<double>());
}

/// A bar of 240 tetrahedra, some of them badly shaped.
class InspectionReport : public Report {
 protected:
  Json inspected(const std::string& options) {
    if (!exists("bar.msh")) {
      EXPECT_EQ(call("mesh generate bar --size 0.1 0.02 0.02 --cells 10 2 2 --jitter 0.3 -o bar.msh").status, 0);
    }
    const Outcome outcome = call("inspect bar.msh --json i.json --report p.html " + options + test::material);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("wrote p.html"));
    return reportIn(folder_.read("p.html"));
  }
};

TEST_F(InspectionReport, NamesTheElementAndItsCardsAreThoseOfInspect) {
  const Json report = inspected("--distribution");
  const Json numbers = json("i.json");
  EXPECT_EQ(report["summary"]["critical_step"], numbers["critical_step"]);
  const std::string sentence = report["verdict"]["sentence"];
  EXPECT_THAT(sentence, HasSubstr(numbers["controlling_element"]["id"].dump()));
  ASSERT_EQ(report["worst"].size(), 10u);
  for (std::size_t i = 0; i < 10; ++i)
    EXPECT_NEAR(report["worst"][i]["step"].get<double>() / numbers["worst_elements"][i]["step"].get<double>(), 1,
                1e-12);
  EXPECT_EQ(report["history"], nullptr);
  const std::string html = folder_.read("p.html");
  for (const char* section : {"verdict", "mesh", "distribution", "what-if", "provenance"})
    EXPECT_THAT(html, HasSubstr("<section id=\"" + std::string(section) + "\""));
  EXPECT_THAT(html, Not(HasSubstr("<section id=\"history\"")));
  EXPECT_THAT(report["summary"]["provenance"]["command"].get<std::string>(), HasSubstr("ringwatch inspect bar.msh"));
}

TEST_F(InspectionReport, OfAStepSaysWhatIsInItsWayAndWhatThatWouldTake) {
  const double safe = inspected("")["summary"]["critical_step"]["safe"], h = 1.7 * safe;
  const Json report = inspected("--step " + test::digits(h));
  const Json* row = nullptr;
  for (const Json& each : report["analysis"]["what_if"])
    if (each["step"] == h) row = &each;
  ASSERT_NE(row, nullptr);
  // inspect itself counts what a handler would take.
  EXPECT_EQ((*row)["elements"], json("i.json")["handler"]["count"]);
  EXPECT_GT((*row)["elements"].get<int>(), 0);
  const Json* scaling = nullptr;
  int gains = 0;
  for (const Json& trial : (*row)["handlers"]) {
    if (trial["handler"] == "mass-scaling") scaling = &trial;
    if (trial["gain"].is_number()) {
      ++gains;
      EXPECT_GT(trial["gain"].get<double>(), 0);
    }
  }
  EXPECT_GE(gains, 3);
  ASSERT_NE(scaling, nullptr);
  // A run at that step adds the same mass before its first step.
  folder_.write("s.toml", R"(mesh = {file = "bar.msh"}
material = {model = "stvk", young = 30e3, poisson = 0.3, density = 1000}
integrator = {end = 1e-2}
[handler]
method = "mass-scaling"
)");
  ASSERT_LE(call("run s.toml --quiet --set output.picture=false --set integrator.step=" + test::digits(h) + " --out s")
                .status,
            1);
  EXPECT_NEAR((*scaling)["added_mass"].get<double>() / json("s/summary.json")["handler"]["added_mass_kg"].get<double>(),
              1, 1e-9);
  const Json& verdict = report["verdict"];
  EXPECT_THAT(verdict["remedies"].dump(),
              AllOf(HasSubstr("smaller step"), HasSubstr("easured when this page was written"),
                    HasSubstr((*row)["elements"].dump() + " of 240 elements")));
}

TEST_F(Report, OfAnAuditNamesWhereTheRunLeftProvenGround) {
  folder_.write("scene.toml", test::tiny);
  ASSERT_EQ(call("run scene.toml --out r --set output.picture=false --set \"move.0.velocity=[0.5, 0, 0]\"").status, 0);
  const Json states = parse(call("audit r/run.pvd --scene scene.toml --json -").out)["history"];
  // Proven in the first state, too large in the last, which is stretched.
  const double safe = states.front()["safe"], optimistic = states.back()["optimistic"];
  ASSERT_LT(optimistic, safe);
  const std::string step = test::digits(0.5 * (safe + optimistic));
  const Outcome outcome = call("audit r/run.pvd --scene scene.toml --json a.json --report a.html --step " + step);
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("wrote a.html"));
  const Json report = reportIn(folder_.read("a.html")), audit = json("a.json");
  EXPECT_EQ(report["verdict"]["title"], "Step too large");
  EXPECT_EQ(report["summary"]["first"], audit["first"]);
  EXPECT_EQ(report["history"]["rows"], states.size());
  EXPECT_EQ(report["keyFrame"], audit["first"]["violated"]["state"]);
  EXPECT_EQ(report["worst"].size(), 10u);
  std::vector<double> marked;
  for (const Json& mark : report["marks"]) marked.push_back(mark["time"]);
  EXPECT_THAT(marked, ::testing::Contains(audit["first"]["violated"]["time"].get<double>()));
  EXPECT_THAT(report["verdict"]["sentence"].get<std::string>(),
              HasSubstr("state " + audit["first"]["violated"]["state"].dump()));
  EXPECT_THAT(report["verdict"]["remedies"].dump(), HasSubstr("smaller step"));
  EXPECT_THAT(report["summary"]["provenance"]["command"].get<std::string>(), HasSubstr("ringwatch audit"));
  const std::string html = folder_.read("a.html");
  for (const char* section : {"verdict", "history", "mesh", "distribution", "what-if", "provenance"})
    EXPECT_THAT(html, HasSubstr("<section id=\"" + std::string(section) + "\""));
}

TEST_F(Report, OfAComparisonAndOfStudiesHasTheirNumbers) {
  folder_.write("bar.toml", std::string(tiny).substr(0, std::string(tiny).find("[[move]]")) +
                                "[[initial]]\nwhere = \"x > -1\"\nvelocity = [0, 0.2, 0]\n");
  Outcome outcome = call(
      "compare bar.toml --integrators verlet,rk4 --step 4e-4,2e-4 --set integrator.end=4e-3 --json c.json --report "
      "c.html");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::string compared = folder_.read("c.html");
  Json results = json("c.json");
  EXPECT_EQ(reportIn(compared)["results"]["runs"], results["runs"]);
  EXPECT_THAT(compared, AllOf(HasSubstr("<svg class=\"chart\""), HasSubstr("<circle"), HasSubstr("verlet"),
                              HasSubstr("For an error of")));
  outcome = call("verify elements --quick --json v.json --report=v.html");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::string verified = folder_.read("v.html");
  results = json("v.json");
  EXPECT_EQ(reportIn(verified)["results"], results);
  std::size_t checks = 0;
  for (const auto& [name, study] : results["studies"].items()) checks += study["checks"].size();
  ASSERT_GT(checks, 0u);
  const std::string count = std::to_string(checks);
  EXPECT_THAT(verified,
              AllOf(HasSubstr("All checks passed"), HasSubstr(count + " of " + count + " checks of 1 study passed.")));
}

TEST_F(Report, OfARunThatGoesOnIsReplacedByThatOfItsEnd) {
  makeRun("--live");
  const Json report = reportIn(page());
  EXPECT_EQ(report["reloadAfter"], 0);
  EXPECT_EQ(report["verdict"]["title"], "Stable");
  EXPECT_THAT(page(), AllOf(Not(HasSubstr("http-equiv=\"refresh\"")), Not(HasSubstr("The run goes on"))));
}

TEST(LivePoints, KeepTheFirstAndTheLastOneAndSpreadTheOthers) {
  LivePoints points(10);
  for (int i = 0; i < 1000; ++i) {
    points.add({.time = static_cast<double>(i), .h = 1});
    ASSERT_LE(points.points().size(), 10u);
    ASSERT_EQ(points.points().front().time, 0);
    ASSERT_EQ(points.points().back().time, i);
    double largest = 0, least = 1e9;
    for (std::size_t k = 1; k + 1 < points.points().size(); ++k) {
      const double apart = points.points()[k].time - points.points()[k - 1].time;
      largest = std::max(largest, apart);
      least = std::min(least, apart);
    }
    if (points.points().size() > 2) {
      ASSERT_EQ(largest, least) << i;
    }
  }
  EXPECT_GE(points.points().size(), 5u);
}

TEST(LiveBracket, DrawsStepsWhereTheyAre) {
  // Half of the time has passed, in which the safe step falls from 2 to 1 and the step taken is 1; the optimistic one
  // is far above it.
  std::vector<LivePoint> points;
  for (int i = 0; i <= 50; ++i) points.push_back({0.01 * i, 1, 2 - 0.02 * i, 100});
  const int width = 72, height = 9;
  const std::vector<std::string> lines = bracketLines(points, 1, width, height);
  ASSERT_EQ(lines.size(), 9u);
  for (const std::string& line : lines) {
    EXPECT_EQ(line.size(), 71u);
    EXPECT_EQ(line.find('o'), std::string::npos);  // "optimistic 100" lies above the picture
    EXPECT_EQ(line.find_first_not_of(' ', 12 + 32), std::string::npos) << line;  // nothing beyond now
  }
  // The largest step that is drawn is 2 at the top, 0 at the bottom: 1 is in the middle.
  EXPECT_THAT(lines[0], HasSubstr("2 s |s"));
  EXPECT_EQ(lines[4].find('#'), 12u);
  EXPECT_NE(lines[4].find("##########"), std::string::npos);
  EXPECT_EQ(bracketLines({}, 1, width, height).size(), 0u);
}

TEST_F(Report, RefusesWhatIsNoRunInOneLine) {
  std::filesystem::create_directory(folder_.path() / "empty");
  expectRefused("report empty", "is not the folder of a run");
  expectRefused("report nowhere", "is no folder");
  folder_.write("file", "x");
  expectRefused("report file", "is no folder");
  folder_.write("empty/history.csv", "a,b\n1,2\n");
  expectRefused("report empty", "history.csv:1: begins with \"a,b\"");
  EXPECT_FALSE(exists("empty/report.html"));
  makeRun();
  expectRefused("report r --out nowhere/x.html", "cannot write");
  expectRefused("report r --frames 0", "--frames");
}

TEST_F(Report, NamesFromTheSceneDoNotBecomeMarkup) {
  std::filesystem::create_directory(folder_.path() / "r");
  const std::string evil = "</script><img src=x onerror=alert(1)>";
  Json summary{{"scene_file", evil}, {"verdict", "certified"}, {"notes", {evil}}, {"exit_text", evil}};
  folder_.write("r/summary.json", summary.dump());
  ASSERT_EQ(call("report r").status, 0);
  EXPECT_THAT(page(), AllOf(Not(HasSubstr(evil)), Not(HasSubstr("<img")), HasSubstr("&lt;/script&gt;")));
  EXPECT_EQ(reportIn(page())["summary"], summary);
}

TEST(ReportVerdict, RoundsStepsToTheSideWhereTheyHold) {
  for (const double step : {7.29999e-4, 1.0, 9.9999e-7, 123456.0}) {
    const double rounded = std::stod(stepRoundedDown(step));
    EXPECT_LE(rounded, step);
    EXPECT_GE(rounded, step * (1 - 1.001e-3));
    const double up = std::stod(stepRoundedUp(step));
    EXPECT_GE(up, step);
    EXPECT_LE(up, step * (1 + 1.001e-3));
  }
}

TEST(ReportVerdict, ClaimsNothingThatTheRunDidNot) {
  const auto said = [](const Json& summary) {
    const PageVerdict verdict = verdictOf(nlohmann::ordered_json(summary), std::nullopt);
    return verdict.title + ". " + verdict.sentence + " " + ::testing::PrintToString(verdict.remedies);
  };
  EXPECT_THAT(said({{"verdict", "unmonitored"}, {"steps", 5}}),
              AllOf(HasSubstr("Not watched"), Not(HasSubstr("was proven"))));
  EXPECT_THAT(said({{"verdict", "not-certified"}, {"certified_steps", 1}, {"watched_steps", 9}}),
              AllOf(HasSubstr("Not proven"), HasSubstr("1 of 9"), Not(HasSubstr("Stable"))));
  const PageVerdict interrupted =
      verdictOf({{"verdict", "certified"}, {"exit_reason", "interrupted"}, {"exit_text", "interrupted before step 7"}},
                std::nullopt);
  EXPECT_EQ(interrupted.tone, PageVerdict::Tone::unsure);
  EXPECT_THAT(interrupted.sentence, HasSubstr("interrupted before step 7"));
  EXPECT_THAT(said(nullptr), AllOf(HasSubstr("No end on record"), Not(HasSubstr("Stable"))));
}

}  // namespace
}  // namespace ringwatch

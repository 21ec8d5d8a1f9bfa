// Runs whose mesh is cut on the way.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ringwatch/meshes/mesh_io.h>

#include "program.h"

namespace ringwatch {
namespace {

using test::Json;
using test::Outcome;
using test::Program;
using test::tiny;
using ::testing::HasSubstr;

TEST_F(Program, CutsAndKeepsItsStep) {
  const std::string scene = "run '" RINGWATCH_EXAMPLES
                            "/four_cuts.toml' --set integrator.end=0.22 --set cut.0.critical_step=true "
                            "--set cut.3.critical_step=true";
  const Outcome outcome = call(scene + " --out cut");
  EXPECT_EQ(outcome.status, 0) << outcome.err << outcome.out;
  EXPECT_THAT(outcome.out, HasSubstr("cut at t = 0.0504 s: "));
  const Json summary = json("cut/summary.json");
  EXPECT_EQ(summary["verdict"], "certified");
  ASSERT_EQ(summary["cuts"].size(), 4u);
  int elements = 8 * 4 * 4 * 6;
  for (const Json& cut : summary["cuts"]) {
    EXPECT_EQ(cut["elements"]["before"], elements);
    elements = cut["elements"]["after"].get<int>();
    EXPECT_GT(elements, cut["elements"]["before"].get<int>());
    EXPECT_GT(cut["area"].get<double>(), 0);
    EXPECT_NEAR(cut["kinetic"]["after"].get<double>(), cut["kinetic"]["before"].get<double>(),
                0.02 * cut["kinetic"]["before"].get<double>());
  }
  const Json &first = summary["cuts"].front(), &last = summary["cuts"].back();
  EXPECT_GT(first["critical_step"]["before"]["safe"].get<double>(), 6e-4);
  EXPECT_LT(last["critical_step"]["after"]["safe"].get<double>(), 6e-4 / 5);
  EXPECT_TRUE(summary["cuts"][1]["critical_step"]["before"].is_null());  // not asked for
  for (const Json* cut : {&first, &last}) {
    EXPECT_GE((*cut)["critical_step_at_most"].get<double>(), (*cut)["critical_step"]["after"]["safe"].get<double>());
    EXPECT_LT((*cut)["critical_step_at_most"].get<double>(), 6e-4);
    EXPECT_LE((*cut)["elements_examined"].get<int>(), (*cut)["elements"]["after"].get<int>());
    EXPECT_GE((*cut)["element_evaluations"].get<int>(), (*cut)["elements_examined"].get<int>());
  }
  EXPECT_EQ(first["handled_elements"]["before"], 0);
  EXPECT_GT(last["handled_elements"]["after"].get<int>(), 0);
  const Table history = table("cut/history.csv");
  for (std::size_t i = 0; i < history.rows.size(); ++i) {
    EXPECT_EQ(history.number(i, "h_s"), 6e-4);
    // The energy balance goes on through the cuts.
    EXPECT_LE(std::abs(history.number(i, "balance_error_J")),
              0.03 * history.number(history.rows.size() - 1, "kinetic_J"));
  }
  EXPECT_NEAR(summary["mass"].get<double>(), 0.432, 1e-9);
  // The frames follow the mesh.
  EXPECT_EQ(readMesh(folder_.path() / "cut/frames/frame_000001.vtu").elementCount(), 768u);
  EXPECT_EQ(readMesh(folder_.path() / "cut/frames/frame_000023.vtu").elementCount(), elements);

  // Without a handler the first cut makes the step too large.
  const Outcome plain = call(scene + " --out plain --set handler.method=none --set monitor.on_violation=stop");
  EXPECT_EQ(plain.status, 1) << plain.out;
  EXPECT_LT(json("plain/summary.json")["end_time"].get<double>(), 0.06);
}

// What was observed before a cut is of another body: certificates behind it are of the cut one.
TEST_F(Program, CutsWithCertificates) {
  std::ifstream example(RINGWATCH_EXAMPLES "/four_cuts.toml");
  std::string first((std::istreambuf_iterator<char>(example)), {});
  const std::size_t second = first.find("[[cut]]", first.find("[[cut]]") + 1);
  folder_.write("first_cut.toml", first.erase(second, first.find("[output]") - second));
  const std::string scene =
      "run first_cut.toml --set integrator.end=0.06 --set handler.method=none --set output.every=1 "
      "--set monitor.certificates=40 --set monitor.on_violation=";
  for (const std::string choice : {"stop", "warn"}) {
    const Outcome outcome = call(scene + choice + " --out " + choice);
    EXPECT_EQ(outcome.status, 1) << outcome.err << outcome.out;
    const Json summary = json(choice + "/summary.json");
    EXPECT_EQ(summary["exit_reason"], choice == "stop" ? "violated" : "end");
    ASSERT_EQ(summary["cuts"].size(), 1u);
    const std::size_t before = 9 * 5 * 5;
    std::set<std::string> sizes;
    for (const auto& file : std::filesystem::directory_iterator(folder_.path() / choice / "certificates")) {
      const std::string bytes = folder_.read(file.path());
      const std::size_t at = bytes.find("\nnodes ");
      ASSERT_NE(at, std::string::npos);
      sizes.insert(bytes.substr(at + 7, bytes.find('\n', at + 1) - at - 7));
    }
    EXPECT_EQ(sizes,
              (std::set<std::string>{std::to_string(before), std::to_string(summary["mesh"]["nodes"].get<int>())}));
  }
}

TEST_F(Program, RarerRowsLeaveTheEnergiesOfACutRunAlone) {
  const std::string scene = "run '" RINGWATCH_EXAMPLES "/four_cuts.toml' --set integrator.end=0.22";
  ASSERT_EQ(call(scene + " --out all").status, 0);
  ASSERT_EQ(call(scene + " --out some --set output.history_every=7").status, 0);
  const Json all = json("all/summary.json"), some = json("some/summary.json");
  ASSERT_GE(all["cuts"].size(), 1u);
  ASSERT_EQ(some["cuts"].size(), all["cuts"].size());
  EXPECT_EQ(some["cuts"][0]["kinetic"], all["cuts"][0]["kinetic"]);
  const Table rows = table("all/history.csv"), rarer = table("some/history.csv");
  ASSERT_GT(rarer.rows.size(), 10u);
  for (std::size_t i = 0; i < rarer.rows.size(); ++i)
    for (const char* column : {"step", "kinetic_J", "strain_J", "external_work_J"})
      EXPECT_EQ(rarer.at(i, column), rows.at(7 * i, column)) << column << " of row " << i;
}

TEST_F(Program, EventsNameElementsOfTheMeshOfTheirTime) {
  const Outcome outcome =
      call("run '" RINGWATCH_EXAMPLES
           "/four_cuts.toml' --out events --set handler.method=none "
           "--set monitor.on_violation=warn --set cut.1.time=0.0515 "
           "--set cut.1.line='[[0.102,-0.01,-0.01],[0.102,0.07,-0.01]]' --set cut.1.sweep='[0,0,0.08]'");
  ASSERT_EQ(outcome.status, 1) << outcome.err;  // the step is too large from the first cut on
  const Json summary = json("events/summary.json");
  ASSERT_GT(summary["cuts"].size(), 1u);
  int before = 0;
  for (const Json& event : summary["events"]) {
    if (event["element"].is_null()) continue;
    before += event["step"] < summary["cuts"].back()["step"];
    // The line was made when it happened.
    std::string nodes = "nodes";
    for (const Json& id : event["element"]["node_ids"]) nodes += ' ' + id.dump();
    EXPECT_THAT(event["text"].get<std::string>(), HasSubstr(nodes));
  }
  EXPECT_GT(before, 0);
}

TEST_F(Program, ACutThatMissesIsNotedAndChangesNothing) {
  folder_.write("plain.toml", tiny);
  folder_.write("missed.toml", std::string(tiny) + "[[cut]]\ntime = 0.01\npoint = [1, 0, 0]\nnormal = [1, 0, 0]\n");
  ASSERT_EQ(call("run plain.toml --out plain").status, call("run missed.toml --out missed").status);
  const Json summary = json("missed/summary.json");
  EXPECT_EQ(summary["cuts"].size(), 0u);
  EXPECT_THAT(summary["notes"].dump(), HasSubstr("opens nothing"));
  EXPECT_EQ(folder_.read("plain/history.csv"), folder_.read("missed/history.csv"));
}

TEST_F(Program, RefusesBadCuts) {
  const std::string scene = "run '" RINGWATCH_EXAMPLES "/four_cuts.toml' --set ";
  expectRefused(scene + "cut.0.time=0.4", "is not before the end; must be < end = 0.3 s");
  expectRefused(scene + "cut.0.time=-1", "must be >= 0");
  expectRefused(scene + "cut.0.normal='[0,0,0]'", "must not be zero");
  expectRefused(scene + "cut.0.line='[[0,0,0],[1,0,0]]'", "cut.point: both point and line are given");
  expectRefused(scene + "cut.1.line='[[0,0,0]]'", "1 points; it needs two or more");
  expectRefused(scene + "cut.1.line='[[0,0],[1,0]]'", "list of points");
  expectRefused(scene + "cut.1.line='[0,0,0]'", "list of points");
  expectRefused(scene + "cut.1.snap=0.7", "must be >= 0 and <= 0.5");
  expectRefused(scene + "mesh.element=hex8", "only tetrahedra of four nodes can be cut; the mesh has hex8");
  folder_.write("empty.toml", std::string(tiny) + "[[cut]]\ntime = 0.01\n");
  expectRefused("run empty.toml", "missing; give point (m) or line (m)");
  EXPECT_FALSE(exists("out"));
}

}  // namespace
}  // namespace ringwatch

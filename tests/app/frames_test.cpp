// What frames and pictures show: names with units and sides, the bracket of a frame, sets, handled elements, cuts.
#include <cmath>
#include <regex>

#include <ringwatch/meshes/mesh_io.h>
#include <tests/handlers/handler_cases.h>

#include "program.h"

namespace ringwatch {
namespace {

using test::Json;
using test::material;
using test::Outcome;
using test::tiny;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class Shown : public test::Program {
 protected:
  /// Least and largest value of an array of a .vtu file, which VTK writes into its head.
  std::pair<double, double> range(const std::string& file, const std::string& array) const {
    const std::string text = folder_.read(file);
    const std::size_t at = text.find("Name=\"" + array + "\"");
    EXPECT_NE(at, std::string::npos) << file << " has no " << array;
    if (at == std::string::npos) return {NAN, NAN};
    const std::string tag = text.substr(at, text.find('>', at) - at);
    const auto number = [&](const std::string& name) {
      const std::size_t begin = tag.find(name + "=\"");
      return begin == std::string::npos ? NAN : std::stod(tag.substr(begin + name.size() + 2));
    };
    return {number("RangeMin"), number("RangeMax")};
  }
};

TEST_F(Shown, TheLastFrameHasTheVelocitiesOfItsOwnTime) {
  folder_.write("tiny.toml", tiny);
  for (const char* method : {"verlet", "symplectic-euler", "rkn4"}) {
    const std::string run = std::string("run tiny.toml --set integrator.step=5e-4 --set integrator.method=") + method;
    ASSERT_EQ(call(run + " --set integrator.end=0.02 --out short").status, 0) << method;
    ASSERT_EQ(call(run + " --set integrator.end=0.04 --out long").status, 0) << method;
    const std::string third = "/frames/frame_000003.vtu";
    EXPECT_EQ(range("short" + third, "velocity"), range("long" + third, "velocity")) << method;
  }
}

TEST_F(Shown, FramesNameSidesUnitsAndTheBracketOfTheBody) {
  folder_.write("tiny.toml", tiny);
  const std::string run = "run tiny.toml --set mesh.jitter=0.3 --set integrator.step=5e-4 --set output.fields=";
  ASSERT_EQ(call(run + "'[\"critical_step\",\"nodal-bound\",\"verdict\",\"handler\"]' --out r").status, 0);
  const Table history = table("r/history.csv");
  for (const int frame : {1, 3}) {
    const std::string file = "r/frames/frame_00000" + std::to_string(frame) + ".vtu";
    const std::size_t row = 20 * (frame - 1);
    const auto ring = range(file, "optimistic step by reduced-1-ring (s)"),
               nodal = range(file, "safe step by nodal-bound (s)");
    // The frame's own bracket, as the monitor had it.
    constexpr double sixDigits = 5e-6;  // as VTK writes ranges
    EXPECT_NEAR(range(file, "safe step (s)").first / history.number(row, "safe_s"), 1, sixDigits);
    EXPECT_NEAR(range(file, "optimistic step (s)").first / history.number(row, "optimistic_s"), 1, sixDigits);
    EXPECT_EQ(range(file, "step (s)").first, 5e-4);
    // A reduced ring is an optimistic estimate: the body's own bound is at least as sharp.
    EXPECT_GE(ring.first, history.number(row, "optimistic_s") * (1 - sixDigits));
    EXPECT_LE(nodal.first, history.number(row, "optimistic_s") * (1 + sixDigits));
  }
  EXPECT_THAT(folder_.read("r/frames/frame_000001.vtu"), Not(HasSubstr("\"critical_step\"")));
  // The sets of the mesh go along.
  const Mesh back = readMesh(folder_.path() / "r/frames/frame_000001.vtu");
  EXPECT_EQ(back.nodeSets.at("x-min").size(), 4u);
  // inspect --vtu has the same names.
  ASSERT_EQ(call("inspect r --frame 3 --vtu i.vtu --metric reduced-1-ring,nodal-bound").status, 0);
  EXPECT_NEAR(range("i.vtu", "optimistic step by reduced-1-ring (s)").first /
                  range("r/frames/frame_000003.vtu", "optimistic step by reduced-1-ring (s)").first,
              1, 1e-9);
  range("i.vtu", "safe step by nodal-bound (s)");
  range("i.vtu", "safe step (s)");
  range("i.vtu", "minimum height (m)");
  expectRefused(run + "'[\"critical-step\"]' --out n", "did you mean \"critical_step\"?");
}

TEST_F(Shown, PictureOfThresholdModeShowsHandledElementsAndCuts) {
  const Outcome outcome = call("run '" RINGWATCH_EXAMPLES
                               "/four_cuts.toml' --set integrator.end=0.22 --set monitor.mode=threshold --out r");
  ASSERT_TRUE(exists("r/critical_step.gp")) << outcome.out << outcome.err;
  const std::string script = folder_.read("r/critical_step.gp");
  EXPECT_THAT(script, AllOf(HasSubstr("set title 'Handled elements'"), HasSubstr("title 'cuts'"),
                            HasSubstr("set key at graph 1.02"), Not(HasSubstr("set key bottom left"))));
  EXPECT_THAT(script, HasSubstr("title 'certified'"));
  const Json summary = json("r/summary.json");
  ASSERT_GT(summary["cuts"].size(), 1u);
  std::vector<double> marks;
  const std::regex mark("from first ([-0-9.e]+), graph 0");
  for (std::sregex_iterator at(script.begin(), script.end(), mark), end; at != end; ++at)
    marks.push_back(std::stod((*at)[1]));
  ASSERT_EQ(marks.size(), summary["cuts"].size());
  for (std::size_t i = 0; i < marks.size(); ++i) EXPECT_EQ(marks[i], summary["cuts"][i]["time"]);
}

TEST_F(Shown, PictureLeavesOutTheStepThatEndsAnAutomaticRun) {
  folder_.write("tiny.toml", tiny);
  const std::string run = "run tiny.toml --set integrator.step=auto --out ";
  ASSERT_EQ(call(run + "first").status, 0);
  // An end just behind a step leaves a tiny one.
  const Table full = table("first/history.csv");
  ASSERT_GT(full.rows.size(), 10u);
  std::ostringstream end;
  end.precision(17);
  end << full.number(8, "time_s") + 0.02 * full.number(8, "h_s");
  ASSERT_EQ(call(run + "short --set integrator.end=" + end.str()).status, 0);
  const Table history = table("short/history.csv");
  const std::size_t last = history.rows.size() - 1;
  ASSERT_LT(history.number(last, "h_s"), 0.1 * history.number(last - 1, "h_s"));
  std::smatch found;
  const std::string script = folder_.read("short/critical_step.gp");
  ASSERT_TRUE(std::regex_search(script, found, std::regex("set yrange \\[([-0-9.e]+):")));
  EXPECT_GT(std::stod(found[1]), 0.5 * history.number(last - 1, "h_s"));
}

TEST_F(Shown, DistributionsShareBinsAndShowTheFewBadElements) {
  writeMesh(test::sliverBar(0.98), folder_.path() / "slivers.msh");
  const Outcome outcome = call(
      std::string("inspect slivers.msh --metric single-element,reduced-1-ring,pressure-wave --step 1e-3 --distribution "
                  "--picture spread.png --json r.json") +
      material);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json distribution = json("r.json")["distribution"];
  ASSERT_EQ(distribution.size(), 3u);
  for (const Json& d : distribution) EXPECT_EQ(d["edges"], distribution["single-element"]["edges"]);
  const std::string script = folder_.read("spread.png.gp");
  EXPECT_THAT(script,
              AllOf(HasSubstr("set logscale y"), HasSubstr("title 'mesh, safe"), HasSubstr("title 'mesh, optimistic"),
                    HasSubstr("title 'step: 0.001 s'"), HasSubstr("set key at graph 1.02")));
}

}  // namespace
}  // namespace ringwatch

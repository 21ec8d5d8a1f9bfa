// What a run may be called: inspect and run agree on a state, and "certified", "stable" and the exit status on a run.
#include <cmath>
#include <fstream>

#include <ringwatch/app/output/exit_status.h>
#include <ringwatch/meshes/mesh_io.h>

#include "program.h"

namespace ringwatch {
namespace {

using test::digits;
using test::Json;
using test::material;
using test::Outcome;
using test::tiny;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

/// A bar of 10 x 2 x 2 cells with jitter, from a file that inspect and run both read, bending under its weight.
class CertifiedRun : public test::Program {
 protected:
  void SetUp() override {
    folder_.write("bar.toml",
                  "[mesh]\nfile = \"bar.msh\"\n[material]\nmodel = \"stvk\"\nyoung = 30e3\npoisson = 0.3\n"
                  "density = 1000\n[integrator]\nstep = 1e-3\nend = 0.1\n[[force]]\nwhere = \"all\"\n"
                  "acceleration = [0, 0, -1]\n[[fix]]\nwhere = \"x < 1e-6\"\n");
  }
  Json inspected(const std::string& element) {
    EXPECT_EQ(
        call("mesh generate bar --size 0.2 0.04 0.04 --cells 10 2 2 --jitter 0.2 --element " + element + " -o bar.msh")
            .status,
        0);
    const Outcome outcome = call(std::string("inspect bar.msh --fix 'x < 1e-6' --global --json -") + material);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return parse(outcome.out)["critical_step"];
  }
};

TEST_F(CertifiedRun, BeginsWithTheBracketOfInspect) {
  int comparedInThresholdMode = 0;
  for (const char* element : {"tet4", "hex8"}) {
    const Json step = inspected(element);
    const double safe = step["safe"], optimistic = step["optimistic"], exact = step["global"];
    EXPECT_LE(safe, exact * (1 + 1e-9)) << element;
    for (const char* mode : {"bracket", "threshold"}) {
      // A step that inspect proves, and that the bound kept along a run does not.
      const Outcome outcome = call("run bar.toml --out r --set monitor.mode=" + std::string(mode) +
                                   " --set integrator.step=" + digits(0.99 * safe));
      EXPECT_NE(outcome.status, 2) << outcome.err;
      const Table history = table("r/history.csv");
      EXPECT_EQ(history.at(0, "verdict"), "certified") << element << " " << mode;
      if (std::string(mode) == "threshold") {
        // It may need no bracket.
        if (history.at(0, "safe_s").empty()) continue;
        ++comparedInThresholdMode;
      }
      // Nodes are in another order, so that sums round otherwise.
      EXPECT_NEAR(history.number(0, "safe_s") / safe, 1, 1e-9) << element << " " << mode;
      EXPECT_NEAR(history.number(0, "optimistic_s") / optimistic, 1, 1e-6) << element << " " << mode;
    }
  }
  EXPECT_GT(comparedInThresholdMode, 0);
}

TEST_F(CertifiedRun, ThatIsNeverCertifiedSaysSo) {
  const double safe = inspected("hex8")["safe"];
  const std::string run = "run bar.toml --set integrator.step=" + digits(0.99 * safe) + " --out ";
  const Outcome outcome = call(run + "r");
  EXPECT_EQ(outcome.status, static_cast<int>(ExitStatus::notCertified)) << outcome.out;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("verdict not-certified"), HasSubstr("would have been certified"),
                                 HasSubstr("not certified: exit status 3")));
  const Json summary = json("r/summary.json");
  EXPECT_EQ(summary["stable"], false);
  EXPECT_EQ(summary["certified"], false);
  EXPECT_EQ(summary["exit_status"], 3);
  EXPECT_EQ(summary["verdict"], "not-certified");
  EXPECT_EQ(summary["exit_reason"], "end");
  EXPECT_LT(summary["certified_steps"].get<int>(), summary["steps"].get<int>() / 2);
  EXPECT_EQ(summary["watched_steps"], summary["steps"]);
  // What it says could be certified is certified.
  const double least = summary["safe_seen"]["least"];
  EXPECT_LT(least, safe);
  const Table history = table("r/history.csv");
  double seen = safe;
  for (std::size_t i = 0; i < history.rows.size(); ++i) seen = std::min(seen, history.number(i, "safe_s"));
  EXPECT_EQ(least, seen);
  const Outcome smaller =
      call("run bar.toml --require-certified --out s --set integrator.step=" + digits(0.98 * least));
  EXPECT_EQ(smaller.status, 0) << smaller.out;
  EXPECT_THAT(smaller.out, Not(HasSubstr("not certified")));
  EXPECT_EQ(json("s/summary.json")["stable"], true);
  EXPECT_EQ(json("s/summary.json")["certified"], true);

  // On demand it fails.
  EXPECT_EQ(call(run + "required --require-certified").status, 1);
  EXPECT_EQ(json("required/summary.json")["exit_status"], 1);
  EXPECT_EQ(call(run + "required --set monitor.require_certified=true").status, 1);
  // Between observations nothing is proven.
  expectRefused(run + "seldom --require-certified --set monitor.every=10",
                "runs that must be certified do not go with steps that are not observed");
  ASSERT_EQ(
      call("run bar.toml --out seldom --set monitor.every=10 --set integrator.step=" + digits(0.9 * least)).status, 0);
  EXPECT_THAT(json("seldom/summary.json")["conclusion"].get<std::string>(),
              StartsWith("every step was proven stable at the states that are observed, one in 10"));
}

// Velocities half a step behind look like lost energy in the first steps under a load.
TEST_F(CertifiedRun, ThatStartsUnderLoadDoesNotRunAwayInItsFirstSteps) {
  inspected("tet4");
  const Outcome outcome = call("run bar.toml --out r --set integrator.step=1.6e-3");
  EXPECT_EQ(outcome.status, 0) << outcome.out;
  const Json summary = json("r/summary.json");
  EXPECT_TRUE(summary["energy_runaway"].is_null());
  EXPECT_EQ(summary["verdict"], "certified");
}

// Nothing moves: strain energy is rounding, and its changes are as large as itself.
TEST_F(CertifiedRun, ThatStandsStillIsStable) {
  inspected("tet4");
  std::string scene = folder_.read("bar.toml");
  scene.replace(scene.find("[0, 0, -1]"), 10, "[0, 0, 0]");
  folder_.write("still.toml", scene);
  const Outcome outcome = call("run still.toml --out r");
  EXPECT_EQ(outcome.status, 0) << outcome.out;
  EXPECT_TRUE(json("r/summary.json")["events"].empty());
}

TEST_F(CertifiedRun, NeedsSomethingThatProves) {
  folder_.write("tiny.toml", tiny);
  expectRefused("run tiny.toml --require-certified --set monitor.bracket=false --out r",
                "runs that must be certified do not go with runs without a bracket");
  expectRefused(
      "run tiny.toml --require-certified --set integrator.method=implicit-euler --set output.fields=[] --out r",
      "runs that must be certified do not go with runs without a bracket");
  EXPECT_FALSE(exists("r"));
  // Without a monitor there is nothing to say.
  EXPECT_EQ(call("run tiny.toml --set monitor.bracket=false --set output.fields=[] --out r").status, 0);
  EXPECT_TRUE(json("r/summary.json")["certified"].is_null());
}

TEST_F(CertifiedRun, IsNotCalledStableWhenItsEnergyWasOff) {
  folder_.write("tiny.toml", tiny);
  ASSERT_EQ(call("run tiny.toml --out good").status, 0);
  // The same motion, with a finer measure: the event is the scene's own.
  const Outcome outcome = call("run tiny.toml --out off --set monitor.energy_tolerance=1e-7 --set integrator.end=0.2");
  const Json summary = json("off/summary.json");
  int events = 0;
  for (const Json& event : summary["events"]) events += event["kind"] == "energy-balance";
  ASSERT_GT(events, 0) << outcome.out;
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(summary["stable"], false);
  EXPECT_EQ(summary["verdict"], "unstable");
  EXPECT_THAT(outcome.out, HasSubstr("the energy balance was off"));
}

// Its explicit elements are certified all along, while the energy of the handled ones, which may add any, is off by up
// to 11 %.
TEST_F(CertifiedRun, WithAHandlerThatLosesTheEnergyIsNotCalledStable) {
  folder_.write(
      "filtered.toml",
      "[mesh]\ngenerate = \"bar\"\nsize = [0.2, 0.04, 0.04]\ncells = [10, 2, 2]\njitter = 0.28\n[material]\n"
      "model = \"stvk\"\nyoung = 30e3\npoisson = 0.45\ndensity = 1000\n[integrator]\nmethod = \"verlet\"\n"
      "step = 1.6e-3\nend = 1.0\n[[fix]]\nwhere = \"x < 1e-6\"\n[[force]]\nwhere = \"all\"\n"
      "acceleration = [0, 0, -1]\n[handler]\nmethod = \"filtered\"\nenergy_limit = 0\n[output]\npicture = false\n");
  const Outcome outcome = call("run filtered.toml --out r");
  const Json summary = json("r/summary.json");
  ASSERT_EQ(summary["certified"], true);
  int events = 0;
  for (const Json& event : summary["events"]) events += event["kind"] == "energy-balance";
  ASSERT_GT(events, 0) << outcome.out;
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(summary["stable"], false);
}

TEST_F(CertifiedRun, HasOneTableOfExitStatuses) {
  const std::string help = call("--help").out;
  std::ifstream file(RINGWATCH_SOURCE_DIR "/docs/reference/exit_status.md");
  const std::string page{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  int number = 0;
  for (const ExitStatusInfo& info : exitStatuses) {
    EXPECT_EQ(static_cast<int>(info.status), number);
    EXPECT_THAT(help, HasSubstr("  " + std::to_string(number) + "  " + std::string(info.meaning) + "\n"));
    EXPECT_THAT(page, HasSubstr("| " + std::to_string(number) + " | " + std::string(info.meaning) + " |\n"));
    ++number;
  }
  EXPECT_EQ(std::count(page.begin(), page.end(), '\n'), 6 + number);
  for (const char* command : {"run", "inspect", "verify", "compare", "mesh"})
    EXPECT_THAT(call(std::string(command) + " --help").out, HasSubstr("xit status")) << command;
}

}  // namespace
}  // namespace ringwatch

// The program from outside: exit statuses, what it prints where, and what it leaves in its folders.
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <ringwatch/app/device_run.h>
#include <ringwatch/app/report.h>
#include <ringwatch/app/scene.h>
#include <ringwatch/handlers/handler.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/monitor/global_frequency.h>
#include <ringwatch/monitor/metrics.h>

#include <tests/handlers/handler_cases.h>
#include "program.h"

namespace ringwatch {
namespace {

using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using Json = nlohmann::json;
using test::material;
using test::Outcome;
using test::Program;
using test::tiny;

TEST_F(Program, RunsASceneAndWritesWhatItPromises) {
  folder_.write("tiny.toml", tiny);
  const Outcome outcome = call("run tiny.toml --out results");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("50 steps to t = 0.05 s, end time reached"), HasSubstr("verdict certified")));
  expectNothingHalfWritten("results");

  const Table history = table("results/history.csv");
  EXPECT_EQ(history.columns, (std::vector<std::string>{
                                 "step", "time_s", "h_s", "safe_s", "optimistic_s", "controlling_element", "kinetic_J",
                                 "strain_J", "external_work_J", "balance_error_J", "elements_refreshed",
                                 "handled_elements", "metric_step_s", "verdict", "dissipated_J"}));
  ASSERT_EQ(history.rows.size(), 50u);
  for (std::size_t i = 0; i < history.rows.size(); ++i) {
    EXPECT_EQ(history.rows[i].size(), history.columns.size());
    EXPECT_EQ(history.at(i, "step"), std::to_string(i));
    EXPECT_NEAR(history.number(i, "time_s"), 1e-3 * static_cast<double>(i), 1e-12);
    EXPECT_LE(history.number(i, "h_s"), history.number(i, "safe_s"));
    EXPECT_LE(history.number(i, "safe_s"), history.number(i, "optimistic_s"));
    EXPECT_EQ(history.at(i, "verdict"), "certified");
    EXPECT_EQ(history.at(i, "metric_step_s"), "");
    EXPECT_THAT(history.at(i, "controlling_element"), StartsWith("0:"));
  }

  const Json summary = json("results/summary.json");
  EXPECT_EQ(summary["verdict"], "certified");
  EXPECT_EQ(summary["stable"], true);
  EXPECT_EQ(summary["exit_reason"], "end");
  EXPECT_EQ(summary["steps"], 50);
  EXPECT_EQ(summary["mesh"]["elements"]["tet4"], 30);
  EXPECT_NEAR(summary["mass"].get<double>(), 0.04, 1e-12);
  EXPECT_EQ(summary["scene"]["integrator"]["method"], "symplectic-euler");
  EXPECT_EQ(summary["scene"]["monitor"]["on_violation"], "stop");
  EXPECT_TRUE(summary["first_violated"].is_null());
  EXPECT_EQ(summary["version"], std::string(programVersion()));

  // Frames at 0, 0.01, …, 0.05 s, which read back as the mesh.
  EXPECT_EQ(summary["frames"], 6);
  EXPECT_TRUE(exists("results/run.pvd"));
  EXPECT_FALSE(exists("results/frames/frame_000007.vtu"));
  const Mesh frame = readMesh(folder_.path() / "results/frames/frame_000006.vtu");
  EXPECT_EQ(frame.elementCount(), 30u);
  EXPECT_NEAR(frame.X.row(0).maxCoeff(), 0.1 + 0.05 * 0.05, 1e-12);

  EXPECT_TRUE(exists("results/critical_step.gp"));
  EXPECT_TRUE(exists("results/critical_step.dat"));
  EXPECT_THAT(folder_.read("results/critical_step.png"), StartsWith("\x89PNG"));
}

TEST_F(Program, WritesOnlyWhatIsAskedFor) {
  folder_.write("tiny.toml", tiny);
  const Outcome outcome = call(
      "run tiny.toml --out r --set monitor.bracket=false --set output.energy=false --set output.picture=false --set "
      "output.history_every=10 "
      "--set output.fields=[]");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("verdict unmonitored"));
  EXPECT_FALSE(exists("r/critical_step.png"));
  EXPECT_FALSE(exists("r/critical_step.gp"));
  const Table history = table("r/history.csv");
  ASSERT_EQ(history.rows.size(), 5u);
  EXPECT_EQ(history.at(1, "step"), "10");
  for (const char* column : {"safe_s", "optimistic_s", "kinetic_J", "balance_error_J", "metric_step_s", "verdict"})
    EXPECT_EQ(history.at(1, column), "");
  EXPECT_EQ(folder_.read("r/frames/frame_000001.vtu").find("critical_step"), std::string::npos);
}

TEST_F(Program, SaysNothingWhenQuiet) {
  folder_.write("tiny.toml", tiny);
  const Outcome good = call("run tiny.toml --out r --quiet");
  EXPECT_EQ(good.status, 0);
  EXPECT_EQ(good.out + good.err, "");
  const Outcome bad = call("run tiny.toml --out r --quiet --set integrator.step=0.02");
  EXPECT_EQ(bad.status, 1);
  EXPECT_EQ(bad.out + bad.err, "");
}

TEST_F(Program, StopsBeforeAStepThatIsProvenUnstable) {
  folder_.write("tiny.toml", tiny);
  const Outcome outcome = call("run tiny.toml --out r --set integrator.step=0.01");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr("verdict violated"));
  const Json summary = json("r/summary.json");
  EXPECT_EQ(summary["exit_reason"], "violated");
  EXPECT_EQ(summary["steps"], 0);
  EXPECT_EQ(summary["first_violated"]["step"], 0);
  EXPECT_EQ(summary["events"][0]["kind"], "violated");
  EXPECT_TRUE(summary["events"][0]["element"].contains("node_ids"));
  EXPECT_EQ(table("r/history.csv").at(0, "verdict"), "violated");
  expectNothingHalfWritten("r");
}

TEST_F(Program, WarnsAndEndsWithTheLastGoodFrameWhenItBlowsUp) {
  folder_.write("tiny.toml", tiny);
  const Outcome outcome = call(
      "run tiny.toml --out r --set integrator.step=0.01 --set integrator.end=5 --set monitor.on_violation=warn --set "
      "output.every=0.01");
  EXPECT_EQ(outcome.status, 1);
  const Json summary = json("r/summary.json");
  EXPECT_EQ(summary["exit_reason"], "non-finite");
  EXPECT_EQ(summary["verdict"], "unstable");
  EXPECT_EQ(summary["first_violated"]["step"], 0);
  EXPECT_FALSE(summary["energy_runaway"].is_null());
  const std::size_t frames = summary["frames"];
  for (std::size_t i = 1; i <= frames; ++i) {
    std::string name = std::to_string(i);
    name = "r/frames/frame_" + std::string(6 - name.size(), '0') + name + ".vtu";
    EXPECT_TRUE(readMesh(folder_.path() / name).X.allFinite()) << name;
  }
  expectNothingHalfWritten("r");
}

TEST_F(Program, ReducesTheStepInTime) {
  folder_.write("tiny.toml", tiny);
  const Outcome outcome =
      call("run tiny.toml --out r --set integrator.step=0.01 --set monitor.on_violation=reduce-step");
  EXPECT_EQ(outcome.status, 0) << outcome.out;
  const Json summary = json("r/summary.json");
  EXPECT_EQ(summary["verdict"], "certified");
  const Table history = table("r/history.csv");
  for (std::size_t i = 0; i < history.rows.size(); ++i) {
    EXPECT_LE(history.number(i, "h_s"), history.number(i, "safe_s"));
    EXPECT_LE(history.number(i, "h_s"), history.number(i > 0 ? i - 1 : 0, "h_s"));
  }
}

TEST_F(Program, FollowsTheSafeStepWhenAuto) {
  folder_.write("tiny.toml", tiny);
  const Outcome outcome = call("run tiny.toml --out r --set integrator.step=auto --set integrator.safety=0.9");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  const Json summary = json("r/summary.json");
  EXPECT_NEAR(summary["end_time"].get<double>(), 0.05, 1e-12);
  const Table history = table("r/history.csv");
  for (std::size_t i = 0; i + 1 < history.rows.size(); ++i)
    EXPECT_NEAR(history.number(i, "h_s"), 0.9 * history.number(i, "safe_s"), 1e-12);
  EXPECT_EQ(call("run tiny.toml --out r --set integrator.step=auto --set monitor.every=7").status, 0);
}

TEST_F(Program, TakesAGpuOnlyWhereThereIsOne) {
  folder_.write("tiny.toml", tiny);
  const std::string reason = whyNoDevice(), cuda = "run tiny.toml --set integrator.device=cuda --out ";
  if (!reason.empty()) expectRefused(cuda + "g", "integrator.device: \"cuda\": " + reason);
  expectRefused(cuda + "g --set integrator.method=verlet", "a GPU runs symplectic-euler without");
  expectRefused(cuda + "g --set damping.mass=1.0", "a GPU runs symplectic-euler without");
  expectRefused(cuda + "g --set handler.method=mass-scaling --set integrator.step=1e-3", "of the handlers imex alone");
  expectRefused(cuda + "g --set handler.method=imex --set integrator.step=1e-3 --set handler.solver=cholesky",
                "by conjugate gradients, not by");
  expectRefused("run tiny.toml --set integrator.device=gpu --out g", "must be one of cpu, cuda, auto");
  EXPECT_FALSE(exists("g"));
  EXPECT_EQ(call("run tiny.toml --out auto --set integrator.device=auto --set monitor.every=3").status, 0);
  const std::string notes = json("auto/summary.json")["notes"].dump();
  EXPECT_THAT(notes, HasSubstr(reason.empty() ? "the steps were taken on" : "the steps are taken on the CPU, since"));
  EXPECT_EQ(call("run tiny.toml --out verlet --set integrator.device=auto --set integrator.method=verlet").status, 0);
  EXPECT_THAT(json("verlet/summary.json")["notes"].dump(), HasSubstr("a GPU runs symplectic-euler without"));
  const std::string metric = " --set monitor.mode=metric --set monitor.metric=reduced-1-ring";
  EXPECT_EQ(call("run tiny.toml --out rings --set integrator.device=auto" + metric).status, 0);
  EXPECT_EQ(call("run tiny.toml --out rings_cpu" + metric).status, 0);
  const Table rings = table("rings/history.csv"), ringsHere = table("rings_cpu/history.csv");
  ASSERT_EQ(rings.rows.size(), ringsHere.rows.size());
  for (std::size_t i = 0; i < rings.rows.size(); ++i)
    EXPECT_NEAR(rings.number(i, "metric_step_s"), ringsHere.number(i, "metric_step_s"), 1e-9);
  EXPECT_EQ(call("run tiny.toml --out cpu --set monitor.every=3").status, 0);
  const Table here = table("auto/history.csv"), there = table("cpu/history.csv");
  ASSERT_EQ(here.rows.size(), there.rows.size());
  for (std::size_t i = 0; i < here.rows.size(); ++i) {
    EXPECT_EQ(here.at(i, "verdict"), there.at(i, "verdict"));
    for (const char* column : {"time_s", "safe_s", "kinetic_J", "strain_J"})
      EXPECT_NEAR(here.number(i, column), there.number(i, column), 1e-9 * std::abs(there.number(i, column)) + 1e-15);
  }
}

TEST_F(Program, GivesTheSameForOneAndTwoThreads) {
  folder_.write("tiny.toml", tiny);
  call("run tiny.toml --out one --threads 1 --set output.picture=false");
  call("run tiny.toml --out two --threads 2 --set output.picture=false");
  EXPECT_EQ(folder_.read("one/history.csv"), folder_.read("two/history.csv"));
}

TEST_F(Program, ReplacesTheResultsOfAnEarlierRun) {
  folder_.write("tiny.toml", tiny);
  call("run tiny.toml --out r");
  EXPECT_TRUE(exists("r/frames/frame_000006.vtu"));
  call("run tiny.toml --out r --set integrator.end=0.02 --set output.picture=false");
  EXPECT_FALSE(exists("r/frames/frame_000006.vtu"));
  EXPECT_FALSE(exists("r/critical_step.png"));
  EXPECT_EQ(table("r/history.csv").rows.size(), 20u);
}

TEST_F(Program, KeepsTheScriptWhenGnuplotIsMissing) {
  folder_.write("tiny.toml", tiny);
  const Outcome outcome = call("run tiny.toml --out r", "PATH=/nowhere");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("gnuplot is missing"));
  EXPECT_TRUE(exists("r/critical_step.gp"));
  EXPECT_FALSE(exists("r/critical_step.png"));
  expectNothingHalfWritten("r");
}

TEST_F(Program, FinishesTheStepWhenInterrupted) {
  folder_.write("tiny.toml", tiny);
  const std::string scene = (folder_.path() / "tiny.toml").string(), out = (folder_.path() / "r").string();
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    if (std::freopen("/dev/null", "w", stdout) == nullptr) ::_exit(99);
    ::execl(RINGWATCH_PROGRAM, RINGWATCH_PROGRAM, "run", scene.c_str(), "--out", out.c_str(), "--set",
            "integrator.end=1e6", "--set", "output.every=1e5", static_cast<char*>(nullptr));
    ::_exit(99);
  }
  while (!exists("r/run.pvd")) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  ::kill(child, SIGINT);
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 4);
  EXPECT_EQ(json("r/summary.json")["exit_reason"], "interrupted");
  EXPECT_EQ(table("r/history.csv").rows.size(), json("r/summary.json")["steps"].get<std::size_t>());
  expectNothingHalfWritten("r");
}

TEST_F(Program, RefusesBadScenesBeforeItWrites) {
  folder_.write("tiny.toml", tiny);
  expectRefused("run tiny.toml --out r --set material.poisson=0.5",
                "--set material.poisson=0.5: material.poisson: 0.5 is out of range; must be > -1 and < 0.5");
  expectRefused("run tiny.toml --out r --set integrator.stepp=1", "did you mean \"step\"?");
  expectRefused("run tiny.toml --out r --set 'fix.0.where=\"x > 5\"'",
                "selects no node; the mesh lies in 0 <= x <= 0.1");
  expectRefused("run none.toml --out r", "none.toml: cannot read: No such file or directory");
  expectRefused("run . --out r", "is a folder");
  expectRefused("run tiny.toml --out r --set mesh.jitter=0.49 --set mesh.seed=-1", "mesh.seed: -1 does not fit");
  EXPECT_FALSE(exists("r"));
  folder_.write("broken.toml", std::string(tiny).replace(std::string(tiny).find("poisson = 0.3"), 13, "poisson = 0.6"));
  expectRefused("run broken.toml --out r", "broken.toml:8: material.poisson: 0.6 is out of range");
  EXPECT_FALSE(exists("r"));
}

TEST_F(Program, RefusesAnOutputFolderThatCannotBeWritten) {
  folder_.write("tiny.toml", tiny);
  folder_.write("file", "");
  expectRefused("run tiny.toml --out file", "file: cannot write");
  expectRefused("run tiny.toml --out file/r", "file/r: cannot write");
  expectRefused("run tiny.toml --out /proc/ringwatch", "/proc/ringwatch: cannot write");
  if (::geteuid() != 0) {  // root may write anywhere
    std::filesystem::create_directory(folder_.path() / "locked");
    ::chmod((folder_.path() / "locked").c_str(), 0500);
    expectRefused("run tiny.toml --out locked", "cannot write");
  }
}

TEST_F(Program, RefusesBadUsageInOneLine) {
  expectRefused("", "");
  expectRefused("rnu x", "did you mean \"run\"?");
  expectRefused("run", "SCENE is missing");
  expectRefused("run a b", "unknown argument");
  expectRefused("run --threads many x.toml", "--threads");
  expectRefused("run --out", "--out");
  expectRefused("inspect", "MESH is required");
  expectRefused("inspect a.msh --young 1 --poisson 0.3", "--density is required");
  expectRefused("inspect a.msh --young 1 --poisson 0.3 --density 1 --gloabl", "did you mean \"--global\"?");
  expectRefused("mesh", "");
  expectRefused("mesh generate bra -o a.msh", "did you mean \"bar\"?");
  expectRefused("mesh generate bar", "--output");
  expectRefused("mesh generate bar --cells 2 0 2 -o a.msh", "--cells: [2,0,2] does not fit");
  expectRefused("mesh generate bar --cells two -o a.msh", "--cells: \"two\" does not fit");
  expectRefused("mesh generate bar -o a.xyz", "xyz");
  expectRefused("mesh generate bar -o nowhere/a.msh", "nowhere");
  expectRefused("mesh convert none.msh a.vtu", "none.msh");
  expectRefused("mesh check none.msh", "none.msh");
}

TEST_F(Program, TeachesInItsHelp) {
  const Outcome help = call("--help");
  EXPECT_EQ(help.status, 0);
  for (const char* word : {"run", "inspect", "mesh", "help", "Exit status", "any consistent units", "stvk",
                           "symplectic-euler", "mass-scaling", "hex20", ".inp", "ball"})
    EXPECT_THAT(help.out, HasSubstr(word));
  const Outcome scene = call("run --help-scene");
  EXPECT_EQ(scene.status, 0);
  for (const char* word : {"[material]", "[[fix]]", "young", "Pa", "> -1 and < 0.5", "on_violation"})
    EXPECT_THAT(scene.out, HasSubstr(word));
  const Outcome version = call("--version");
  EXPECT_EQ(version.status, 0);
  EXPECT_EQ(version.out, "ringwatch " + std::string(programVersion()) + "\n");
  for (const char* command : {"run --help", "inspect --help", "mesh --help", "mesh generate --help"})
    EXPECT_EQ(call(command).status, 0) << command;
}

TEST_F(Program, InspectsTetrahedraAndHexahedra) {
  for (const std::string element : {"tet4", "hex8"}) {
    ASSERT_EQ(call("mesh generate bar --size 0.2 0.04 0.04 --cells 10,2,2 --element " + element + " -o bar.msh").status,
              0);
    const Outcome outcome =
        call(std::string("inspect bar.msh --metric all --global --lanczos 1e-9 --step 2.5e-3 --json -") + material);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const Json report = Json::parse(outcome.out);
    EXPECT_EQ(report["mesh"]["nodes"], 99);
    EXPECT_EQ(report["mesh"]["elements"].size(), 1u);
    EXPECT_EQ(report["mesh"]["elements"][element], element == "tet4" ? 240 : 40);
    EXPECT_NEAR(report["mesh"]["volume"].get<double>(), 3.2e-4, 1e-14);
    EXPECT_NEAR(report["mass"].get<double>(), 0.32, 1e-11);
    const Json& step = report["critical_step"];
    const double global = step["global"];
    // Computed independently of this project: 2.085284449e-3 for these tetrahedra, 2.973862796e-3 for these hexahedra.
    EXPECT_NEAR(global, element == "tet4" ? 2.085284449e-3 : 2.973862796e-3, 2e-9);
    EXPECT_LE(step["safe"].get<double>(), global * (1 + 1e-9));
    EXPECT_GE(step["optimistic"].get<double>(), global * (1 - 1e-9));
    EXPECT_EQ(step["probable"]["eta"], 1e-9);
    EXPECT_LE(step["probable"]["safe"].get<double>(), global);
    EXPECT_GE(step["probable"]["safe"].get<double>(), 0.985 * global);
    EXPECT_LE(step["metrics"]["single-element"].get<double>(), global);
    EXPECT_LE(step["metrics"]["nodal-bound"].get<double>(), global);
    EXPECT_GE(step["metrics"]["reduced-1-ring"].get<double>(), global * (1 - 1e-9));
    for (const MetricInfo& info : allMetrics()) {
      const std::string name(info.name);
      const double h = step["metrics"][name];
      const std::string side = step["directions"][name];
      EXPECT_TRUE(side != "safe" || h <= global * (1 + 1e-9)) << name << " = " << h;
      EXPECT_TRUE(side != "optimistic" || h >= global * (1 - 1e-9)) << name << " = " << h;
      EXPECT_EQ(side == "estimate", info.direction == Direction::estimate && name != "vertex-1-ring") << name;
      EXPECT_NEAR(step["differences_percent"][name].get<double>(), 100 * (h - global) / global, 1e-9) << name;
      EXPECT_EQ(step["controlling"][name]["block"], 0) << name;
    }
    EXPECT_EQ(step["directions"]["reduced-2-ring"], "optimistic");
    EXPECT_EQ(step["directions"]["vertex-1-ring"], "safe");
    const Json& counts = report["ill_shaped"]["by_metric"];
    EXPECT_EQ(counts["reduced-1-ring"], report["ill_shaped"]["count"]);
    EXPECT_GE(counts["single-element"].get<int>(), counts["reduced-1-ring"].get<int>());
    const Json& element0 = report["controlling_element"];
    EXPECT_EQ(element0["block"], 0);
    EXPECT_EQ(element0["nodes"].size(), element == "tet4" ? 4u : 8u);
    EXPECT_EQ(element0["node_ids"][0].get<int>(), element0["nodes"][0].get<int>() + 1);  // .msh numbers from 1
    EXPECT_EQ(report["ill_shaped"]["count"], report["ill_shaped"]["elements"].size());
    EXPECT_EQ(report["ill_shaped"]["count"].get<int>() > 0, element == "tet4");  // 2.5 ms lies between the two
  }
}

TEST_F(Program, InspectReportsForPeopleAndFiles) {
  ASSERT_EQ(call("mesh generate cube --size 0.05 --cells 2 -o cube.vtu").status, 0);
  const Outcome outcome =
      call(std::string("inspect cube.vtu --fix 'x < 1e-6' --json report.json --vtu report.vtu") + material);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  for (const char* word : {"48 tet4", "volume", "safe", "optimistic", "proven stable", "single-element",
                           "pressure-wave", "reduced-1-ring", "controlling element"})
    EXPECT_THAT(outcome.out, HasSubstr(word));
  const Json report = json("report.json");
  EXPECT_FALSE(report["critical_step"].contains("global"));
  for (const char* unasked : {"ill_shaped", "distribution", "worst_elements"}) EXPECT_FALSE(report.contains(unasked));
  EXPECT_FALSE(report["critical_step"].contains("differences_percent"));
  EXPECT_EQ(report["critical_step"]["metrics"].size(), 3u);
  EXPECT_EQ(readMesh(folder_.path() / "report.vtu").elementCount(), 48u);
}

TEST_F(Program, InspectShowsDistributions) {
  ASSERT_EQ(call("mesh generate cube --size 0.05 --cells 3 --jitter 0.3 -o cube.msh").status, 0);
  for (const std::string picture : {"spread.svg", "spread.png"}) {
    const Outcome outcome = call(
        std::string("inspect cube.msh --metric reduced-1-ring,single-element --distribution --step 1e-3 --picture ") +
        picture + " --json report.json" + material);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    for (const char* word : {"steps of the elements by reduced-1-ring", "steps of the elements by single-element",
                             "worst elements", "critical at h = 0.001 s", "drew spread."})
      EXPECT_THAT(outcome.out, HasSubstr(word));
    EXPECT_TRUE(exists(picture));
    EXPECT_TRUE(exists(picture + ".gp"));
    EXPECT_FALSE(exists(picture + ".part"));
  }
  EXPECT_THAT(folder_.read("spread.svg"), HasSubstr("<svg"));
  EXPECT_EQ(folder_.read("spread.png").substr(1, 3), "PNG");
  const Json report = json("report.json");
  const std::size_t elements = readMesh(folder_.path() / "cube.msh").elementCount();
  ASSERT_EQ(report["distribution"].size(), 2u);
  for (const Json& d : report["distribution"]) {
    std::size_t sum = d["without_step"];
    for (const Json& count : d["counts"]) sum += count.get<std::size_t>();
    EXPECT_EQ(sum, elements);
    ASSERT_EQ(d["edges"].size(), d["counts"].size() + 1);
    // The share below an edge is what the bins before it hold.
    std::size_t before = 0;
    for (std::size_t i = 0; i < d["counts"].size(); ++i) {
      EXPECT_NEAR(d["critical_share"][i].get<double>(), static_cast<double>(before) / static_cast<double>(elements),
                  1e-12);
      before += d["counts"][i].get<std::size_t>();
    }
    EXPECT_EQ(d["critical_share"][0], 0);
  }
  const Json& worst = report["worst_elements"];
  ASSERT_EQ(worst.size(), 10u);
  EXPECT_EQ(worst[0]["step"], report["critical_step"]["metrics"]["reduced-1-ring"]);
  EXPECT_EQ(worst[0]["index"], report["critical_step"]["controlling"]["reduced-1-ring"]["index"]);
  for (std::size_t i = 1; i < worst.size(); ++i) EXPECT_LE(worst[i - 1]["step"].get<double>(), worst[i]["step"]);
}

TEST_F(Program, InspectRefusesBadInput) {
  ASSERT_EQ(call("mesh generate cube --size 0.05 --cells 1 -o cube.msh").status, 0);
  expectRefused(std::string("inspect none.msh") + material, "none.msh");
  expectRefused("inspect cube.msh --young 0 --poisson 0.3 --density 1", "young = 0");
  expectRefused("inspect cube.msh --young nan --poisson 0.3 --density 1", "young = nan");
  expectRefused("inspect cube.msh --young 1 --poisson 0.5 --density 1", "poisson = 0.5");
  expectRefused("inspect cube.msh --young 1 --poisson 0.3 --density -1", "density = -1");
  expectRefused(std::string("inspect cube.msh --model rubber") + material, "rubber");
  expectRefused(std::string("inspect cube.msh --metric reduced-2-rings") + material,
                "--metric: unknown \"reduced-2-rings\"");
  expectRefused(std::string("inspect cube.msh --metric pressure-wave:height") + material,
                "known are all, pressure-wave:min-height, pressure-wave:volume-over-area, pressure-wave:in-radius, "
                "pressure-wave:shortest-edge");
  expectRefused(std::string("inspect cube.msh --picture spread.pdf") + material, "must end in .svg or .png");
  expectRefused(std::string("inspect cube.msh --picture nowhere/a.svg") + material, "nowhere");
  expectRefused(std::string("inspect cube.msh --integrator explicit-euler") + material, "unstable at every step");
  expectRefused(std::string("inspect cube.msh --integrator verlett") + material, "did you mean \"verlet\"?");
  expectRefused(std::string("inspect cube.msh --step 0") + material, "--step: 0 is out of range");
  expectRefused(std::string("inspect cube.msh --step nan") + material, "--step");
  expectRefused(std::string("inspect cube.msh --lanczos 1") + material, "--lanczos: 1 is out of range");
  expectRefused(std::string("inspect cube.msh --lanczos 1e-300") + material, "eta = 1e-300");
  expectRefused(std::string("inspect cube.msh --fix 'x > 5'") + material, "selects no node");
  expectRefused(std::string("inspect cube.msh --fix all --json nowhere/a.json") + material, "nowhere");
}

TEST_F(Program, ConvertsAndChecksMeshes) {
  ASSERT_EQ(call("mesh generate ball --radius 0.05 --cells 4 -o ball.msh").status, 0);
  EXPECT_EQ(call("mesh convert ball.msh ball.vtu").status, 0);
  EXPECT_EQ(call("mesh convert ball.vtu back.msh").status, 0);
  const Mesh first = readMesh(folder_.path() / "ball.msh"), back = readMesh(folder_.path() / "back.msh");
  EXPECT_EQ(first.X, back.X);
  EXPECT_EQ(first.blocks[0].connectivity, back.blocks[0].connectivity);
  const Outcome good = call("mesh check ball.msh");
  EXPECT_EQ(good.status, 0);
  EXPECT_THAT(good.out, HasSubstr("nothing wrong"));

  folder_.write(
      "bad.msh",
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 0 0 -1\n$EndNodes\n"
      "$Elements\n2\n1 4 2 1 1 1 2 3 4\n2 4 2 1 1 1 2 3 5\n$EndElements\n");
  const Outcome bad = call("mesh check bad.msh");
  EXPECT_EQ(bad.status, 1);
  EXPECT_THAT(bad.out, AllOf(HasSubstr("inverted"), HasSubstr("1 problem\n")));
  expectRefused(std::string("inspect bad.msh") + material, "bad.msh");
}

TEST_F(Program, ExampleOfAutoStepIsCertified) {
  const Outcome outcome =
      call("run '" RINGWATCH_EXAMPLES "/hex_bar_auto_step.toml' --out r --set output.picture=false");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_EQ(json("r/summary.json")["verdict"], "certified");
}

// The source's nonlinear experiment: the monitor speaks before the energy does, and not before the exact value does.
TEST_F(Program, ExampleOfStretchedBarIsCaughtInTime) {
  const Outcome outcome = call("run '" RINGWATCH_EXAMPLES "/stretch_bar.toml' --out r");
  EXPECT_EQ(outcome.status, 1) << outcome.out << outcome.err;
  const Json summary = json("r/summary.json");
  EXPECT_EQ(summary["verdict"], "unstable");
  EXPECT_THAT(folder_.read("r/critical_step.png"), StartsWith("\x89PNG"));
  const std::int64_t violated = summary["first_violated"]["step"], runaway = summary["energy_runaway"]["step"];
  EXPECT_GT(runaway, violated + 10);

  const Table history = table("r/history.csv");
  EXPECT_EQ(history.at(0, "verdict"), "certified");
  double largest = 0;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(violated); ++i) {
    largest = std::max(largest, history.number(i, "kinetic_J") + history.number(i, "strain_J"));
    EXPECT_LT(std::abs(history.number(i, "balance_error_J")), 0.1 * largest) << i;
  }

  // The same run up to the steps around the first violation, looked at with the exact eigenvalue.
  const Scene scene = readScene(RINGWATCH_EXAMPLES "/stretch_bar.toml");
  std::vector<std::string> notes;
  const Body body = sceneBody(scene, sceneMesh(scene, notes), 1);
  BodySystem system(body);
  State state = system.initialState();
  const auto integrator = makeIntegrator(scene.method);
  for (std::int64_t k = 0; k < violated; ++k) {
    if (k == violated / 2) {
      const GlobalFrequency global = globalFrequency(body, state.x);
      ASSERT_TRUE(global.converged);
      EXPECT_LT(*scene.step, stepFor(global.lambda, 2.0));
    }
    integrator->step(system, state, *scene.step);
  }
  const GlobalFrequency global = globalFrequency(body, state.x);
  ASSERT_TRUE(global.converged);
  EXPECT_GT(*scene.step, stepFor(global.lambda, 2.0));
}

TEST_F(Program, DampingShortensTheStepAndIsInTheBooks) {
  folder_.write("tiny.toml", tiny);
  ASSERT_EQ(call("run tiny.toml --out plain --set integrator.step=auto").status, 0);
  const Outcome outcome =
      call("run tiny.toml --out damped --set integrator.step=auto --set damping.stiffness=2e-3 --set damping.mass=1");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const Table plain = table("plain/history.csv"), damped = table("damped/history.csv");
  const Json summary = json("damped/summary.json");
  EXPECT_EQ(summary["scene"]["damping"]["stiffness"], 2e-3);
  EXPECT_EQ(summary["verdict"], "certified");
  // By the closed form, from the same bound: h = 4/(c + sqrt(c^2 + 4 lambda)), c = alpha + beta lambda.
  const double lambda = std::pow(2 / plain.number(0, "safe_s"), 2), c = 1 + 2e-3 * lambda;
  EXPECT_NEAR(damped.number(0, "safe_s") * (c + std::sqrt(c * c + 4 * lambda)) / 4, 1, 1e-9);
  double before = 0, most = 0;
  for (std::size_t i = 0; i < damped.rows.size(); ++i) {
    EXPECT_GE(damped.number(i, "dissipated_J"), before);
    before = damped.number(i, "dissipated_J");
    most = std::max(most, damped.number(i, "external_work_J"));
    EXPECT_LE(std::abs(damped.number(i, "balance_error_J")), 0.06 * most + 1e-12);  // 0.051
  }
  EXPECT_GT(before, 0);
  for (std::size_t i = 0; i < plain.rows.size(); ++i) EXPECT_EQ(plain.number(i, "dissipated_J"), 0);
}

TEST_F(Program, RefusesABracketThatDampingLeavesUnproven) {
  folder_.write("tiny.toml", tiny);
  expectRefused("run tiny.toml --set integrator.method=rk4 --set damping.mass=1",
                "proven for symplectic-euler and verlet only");
  expectRefused("run tiny.toml --set damping.stiffness=-1", "damping.stiffness");
  EXPECT_EQ(call("run tiny.toml --set integrator.method=rk4 --set damping.mass=1 --set monitor.bracket=false --set "
                 "monitor.metric=single-element --set output.fields=[]")
                .status,
            0);
}

TEST_F(Program, PartitionedSchemesTakeTheStiffElementsApart) {
  folder_.write("tiny.toml", tiny);
  const std::string common = "run tiny.toml --set output.fields=[] --set mesh.jitter=0.3 --set integrator.method=";
  const Outcome reference = call(common + "rk4 --set integrator.step=1e-4 --out reference");
  ASSERT_EQ(reference.status, 0) << reference.err;
  const Table exact = table("reference/history.csv");
  for (const char* method : {"arkode-ark", "arkode-mri"}) {
    const Outcome outcome = call(common + method + " --set integrator.step=1e-3 --out parts");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("elements are in the stiff part"));
    const Table history = table("parts/history.csv");
    ASSERT_EQ(history.rows.size(), 50u);
    EXPECT_GT(history.number(0, "handled_elements"), 0) << method;
    EXPECT_LT(history.number(0, "handled_elements"), 30) << method;
    // The same moment, ten of the reference's steps to one.
    EXPECT_NEAR(history.number(49, "strain_J") / exact.number(490, "strain_J"), 1, 1e-3) << method;
    expectRefused(common + method + " --set integrator.step=auto", "chooses its stiff elements by the step");
  }
}

TEST_F(Program, ComparesIntegratorsOnAScene) {
  folder_.write("tiny.toml", tiny);
  const Outcome outcome =
      call("compare tiny.toml --integrators verlet,pefrl,implicit-euler,arkode-ark --json c.json --out pictures");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("cheapest for 1 %"), HasSubstr("cheapest for 1e-6"), HasSubstr("reference converged")));
  const Json result = json("c.json");
  EXPECT_LT(result["reference_error"], 1e-8);
  std::map<std::string, std::vector<double>> errors;
  for (const Json& run : result["runs"]) {
    EXPECT_GT(run["seconds"], 0);
    EXPECT_GT(run["forces"], 0);
    errors[run["integrator"]].push_back(run["error"].is_null() ? NAN : run["error"].get<double>());
  }
  EXPECT_EQ(errors.size(), 4u);
  // Implicit Euler, of order 1, has taken most of the motion out of this run at all but its smallest step.
  for (const auto& [name, values] : errors)
    EXPECT_LT(values.back(), (name == "implicit-euler" ? 0.7 : 0.1) * values.front()) << name;
  for (const char* label : {"1 %", "0.1 %", "1e-6"}) EXPECT_TRUE(result["cheapest"].contains(label)) << label;
  EXPECT_TRUE(exists("pictures/work_precision_tiny_time.gp"));
  EXPECT_TRUE(exists("pictures/work_precision_tiny_forces.dat"));

  const Outcome fixed = call("compare tiny.toml --integrators verlet --step 1e-3,5e-4 --json -");
  EXPECT_EQ(fixed.status, 0) << fixed.err;
  const Json printed = Json::parse(fixed.out);
  ASSERT_EQ(printed["runs"].size(), 2u);
  EXPECT_NEAR(printed["runs"][0]["h"].get<double>(), 1e-3, 1e-12);
  EXPECT_EQ(printed["runs"][1]["forces"], 101);  // a hundred steps and the start

  expectRefused("compare tiny.toml --integrators verlett", "did you mean \"verlet\"");
  expectRefused("compare tiny.toml --step 0", "--step: 0 s must be > 0");
  expectRefused("compare tiny.toml --step 1", "beyond the end");
  expectRefused("compare absent.toml", "absent.toml");
}

// A bar with slivers, swinging under its weight at three times its critical step.
class HandledProgram : public Program {
 protected:
  void SetUp() override {
    writeMesh(test::sliverBar(0.98), folder_.path() / "slivers.msh");
    const Body body = test::sliverBody("stvk", 0.98);
    critical_ = 2 / std::sqrt(test::denseHighest(body, body.mesh().X));
    step_ = 0.1 / std::ceil(0.1 / (3 * critical_));  // halves and quarters of the end are hit exactly
    for (int parts = 4; std::abs(std::remainder(0.1 / step_, parts)) > 1e-6;)
      step_ = 0.1 / (std::round(0.1 / step_) + 1);
    write("");
  }
  void write(const std::string& handler, const std::string& rest = "", const std::string& monitor = "") {
    folder_.write("slivers.toml",
                  "[mesh]\nfile = \"slivers.msh\"\n[material]\nmodel = \"stvk\"\nyoung = 30e3\npoisson = 0.3\n"
                  "density = 1000\n[integrator]\nmethod = \"verlet\"\nstep = " +
                      number(step_) + "\nend = 0.1\n[[fix]]\nwhere = \"x < 1e-6\"\n" +
                      (rest.empty() ? "[[force]]\nwhere = \"all\"\nacceleration = [0, 0, -1]\n" : rest) +
                      "[monitor]\n" + monitor + "\n" + handler);
  }
  static std::string number(double value) {
    std::ostringstream text;
    text.precision(17);
    text << value;
    return text.str();
  }
  double critical_ = 0, step_ = 0;  // s
};

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
    EXPECT_LE((*cut)["elements_looked_at"].get<int>(), (*cut)["elements"]["after"].get<int>());
    EXPECT_GE((*cut)["element_evaluations"].get<int>(), (*cut)["elements_looked_at"].get<int>());
  }
  EXPECT_EQ(first["handled_elements"]["before"], 0);
  EXPECT_GT(last["handled_elements"]["after"].get<int>(), 0);
  const Table history = table("cut/history.csv");
  for (std::size_t i = 0; i < history.rows.size(); ++i) {
    EXPECT_EQ(history.number(i, "h_s"), 6e-4);
    // The books go on through the cuts.
    EXPECT_LE(std::abs(history.number(i, "balance_error_J")),
              0.03 * history.number(history.rows.size() - 1, "kinetic_J"));
  }
  EXPECT_NEAR(summary["mass"].get<double>(), 0.432, 1e-9);
  // The frames follow the mesh.
  EXPECT_EQ(readMesh(folder_.path() / "cut/frames/frame_000001.vtu").elementCount(), 768u);
  EXPECT_EQ(readMesh(folder_.path() / "cut/frames/frame_000023.vtu").elementCount(),
            static_cast<std::size_t>(elements));

  // Without a handler the first cut makes the step too large.
  const Outcome plain = call(scene + " --out plain --set handler.method=none --set monitor.on_violation=stop");
  EXPECT_EQ(plain.status, 1) << plain.out;
  EXPECT_LT(json("plain/summary.json")["end_time"].get<double>(), 0.06);
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
  expectRefused(scene + "cut.0.line='[[0,0,0],[1,0,0]]'", "cut.sweep: missing; it goes with line");
  expectRefused(scene + "cut.1.line='[[0,0,0]]'", "1 points; it needs two or more");
  expectRefused(scene + "cut.1.line='[[0,0],[1,0]]'", "list of points");
  expectRefused(scene + "cut.1.line='[0,0,0]'", "list of points");
  expectRefused(scene + "cut.1.snap=0.7", "must be >= 0 and <= 0.5");
  expectRefused(scene + "mesh.element=hex8", "only tetrahedra of four nodes can be cut; the mesh has hex8");
  folder_.write("empty.toml", std::string(tiny) + "[[cut]]\ntime = 0.01\n");
  expectRefused("run empty.toml", "missing; give point and normal, or line and sweep");
  EXPECT_FALSE(exists("out"));
}

TEST_F(HandledProgram, RunsAtThreeTimesTheCriticalStep) {
  EXPECT_EQ(call("run slivers.toml --out plain").status, 1);  // without a handler

  write("[handler]\nmethod = \"imex\"\n[output]\nevery = 0.05\nfields = [\"handler\"]\n");
  const Outcome outcome = call("run slivers.toml --out imex");
  EXPECT_EQ(outcome.status, 0) << outcome.err << outcome.out;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("handler imex: "), HasSubstr("of 240 elements"), HasSubstr("certified")));
  const Json summary = json("imex/summary.json");
  EXPECT_EQ(summary["verdict"], "certified");
  const Json& handler = summary["handler"];
  EXPECT_EQ(handler["method"], "imex");
  EXPECT_EQ(handler["selection"], "certified");
  EXPECT_EQ(handler["explicit_part_certified"], true);
  EXPECT_EQ(handler["selections"], 1);
  EXPECT_GT(handler["clusters"].get<double>(), 0);
  const auto handled = handler["handled_elements"].get<int>();
  EXPECT_GT(handled, 0);
  EXPECT_LT(handled, 120);
  const Table history = table("imex/history.csv");
  for (std::size_t i = 0; i < history.rows.size(); ++i) {
    EXPECT_EQ(history.at(i, "handled_elements"), std::to_string(handled));
    EXPECT_EQ(history.at(i, "verdict"), "certified");
    EXPECT_LE(history.number(i, "h_s"), history.number(i, "safe_s"));  // of the explicit elements
  }

  // Against plain explicit at a small step.
  write("");
  ASSERT_EQ(call("run slivers.toml --out fine --set integrator.step=" + number(step_ / 12) + " --set output.every=0.05")
                .status,
            0);
  const NodeVectors X = readMesh(folder_.path() / "fine/frames/frame_000001.vtu").X,
                    fine = readMesh(folder_.path() / "fine/frames/frame_000003.vtu").X,
                    own = readMesh(folder_.path() / "imex/frames/frame_000003.vtu").X;
  EXPECT_LE((own - fine).norm(), 0.005 * (fine - X).norm());
}

// Two ways to take stiff elements implicitly that share no code but the force: ours, and ARKODE's additive Runge-Kutta.
TEST_F(HandledProgram, ImexAndAdditiveRungeKuttaFindTheSameMotion) {
  const Outcome outcome = call("compare slivers.toml --integrators arkode-ark --handlers imex --json c.json --step " +
                               number(step_) + "," + number(step_ / 2));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json runs = json("c.json")["runs"];
  ASSERT_EQ(runs.size(), 4u);
  for (const Json& run : runs) {
    ASSERT_TRUE(run["error"].is_number()) << run;
    EXPECT_LT(run["error"].get<double>(), 0.005) << run;
  }
}

TEST_F(HandledProgram, ScalesMass) {
  write("[handler]\nmethod = \"mass-scaling\"\n");
  const Outcome outcome = call("run slivers.toml --out scaled");
  EXPECT_EQ(outcome.status, 0) << outcome.err << outcome.out;
  const Json summary = json("scaled/summary.json");
  EXPECT_EQ(summary["verdict"], "certified");
  const Json& handler = summary["handler"];
  EXPECT_GT(handler["added_mass_percent"].get<double>(), 0);
  EXPECT_NEAR(summary["mass"].get<double>(), 0.32 + handler["added_mass_kg"].get<double>(), 1e-9);
  EXPECT_LT(handler["frequency_1_shift_percent"].get<double>(), 0);
  EXPECT_LT(handler["frequency_1_with_added_mass_Hz"].get<double>(), handler["frequency_1_Hz"].get<double>());
}

TEST_F(HandledProgram, IsPlainExplicitWhereNothingIsCritical) {
  const std::string step = " --set integrator.step=" + number(critical_ / 2);
  ASSERT_EQ(call("run slivers.toml --out plain" + step).status, 0);
  for (const char* method : {"imex", "fe-pbd", "filtered", "mass-scaling"}) {
    ASSERT_EQ(call("run slivers.toml --out handled --set handler.method=" + std::string(method) + step).status, 0);
    EXPECT_EQ(folder_.read("plain/history.csv"), folder_.read("handled/history.csv")) << method;
    EXPECT_EQ(json("handled/summary.json")["handler"]["handled_elements"], 0);
  }
}

TEST_F(HandledProgram, TakesSmallerStepsWhereTheyAreNeeded) {
  write("[handler]\nmethod = \"adaptive\"\n");
  const Outcome outcome = call("run slivers.toml --out fine");
  EXPECT_EQ(outcome.status, 0) << outcome.err << outcome.out;
  const Json fine = json("fine/summary.json")["handler"];
  EXPECT_GT(fine["handled_elements"].get<int>(), 0);
  EXPECT_EQ(fine["implicit_elements"], 0);
  EXPECT_EQ(fine["elements_at_step_over_1"].get<int>() + fine["handled_elements"].get<int>(), 240);
  EXPECT_GT(fine["speed_up_in_evaluations"].get<double>(), 1);
  ASSERT_EQ(call("run slivers.toml --out capped --set handler.levels=1").status, 0);
  EXPECT_GT(json("capped/summary.json")["handler"]["implicit_elements"].get<int>(), 0);
  EXPECT_THAT(call("run slivers.toml --set handler.variant=magic").err, HasSubstr("stabilised"));
  EXPECT_THAT(call("run slivers.toml --set handler.method=imex --set handler.levels=2").err,
              HasSubstr("is a key of local-time-stepping"));
  EXPECT_THAT(call("run slivers.toml --set handler.variant=rigid").err, HasSubstr("must be one of stabilised"));
  EXPECT_THAT(call("run slivers.toml --set handler.selection=single-element").err,
              HasSubstr("must be \"certified\" or \"fierz-ring\""));
}

TEST_F(HandledProgram, TakesMoreElementsWhenTheRestStiffens) {
  // With less dissipation choices anew disturb the energy: docs/handlers.md.
  const std::string pull = "[[move]]\nwhere = \"x > 0.2 - 1e-6\"\nvelocity = [1.2, 0, 0]\n",
                    imex = "[handler]\nmethod = \"imex\"\nmargin = 0.02\ndissipation = 0.3\n";
  write(imex, pull);
  EXPECT_EQ(call("run slivers.toml --out stopped").status, 1);
  write(imex, pull, "on_violation = \"handle\"");
  const Outcome outcome = call("run slivers.toml --out handled");
  EXPECT_EQ(outcome.status, 0) << outcome.err << outcome.out;
  const Json handler = json("handled/summary.json")["handler"];
  EXPECT_GT(handler["selections"].get<int>(), 1);
  // Later choices keep most of the proof.
  const Json first = json("stopped/summary.json")["handler"];
  EXPECT_EQ(first["selections"], 1);
  EXPECT_LT(handler["element_evaluations"].get<double>(),
            0.7 * handler["selections"].get<double>() * first["element_evaluations"].get<double>());
  const Table history = table("handled/history.csv");
  EXPECT_GT(history.number(history.rows.size() - 1, "handled_elements"), history.number(0, "handled_elements"));
}

TEST_F(Program, ReportsAHandledElementThatInverts) {
  // A node in the midst of a bar is led along it, faster than the rest can follow.
  folder_.write("led.toml",
                "[mesh]\ngenerate = \"bar\"\nsize = [0.2, 0.04, 0.04]\ncells = [10, 2, 2]\n[material]\n"
                "model = \"corotational\"\nyoung = 30e3\npoisson = 0.3\ndensity = 1000\n[integrator]\n"
                "method = \"verlet\"\nstep = 2.5e-3\nend = 0.03\n[[fix]]\nwhere = \"x < 1e-6\"\n[[move]]\n"
                "where = \"abs(x - 0.1) < 0.01 and abs(y - 0.02) < 0.01 and abs(z - 0.02) < 0.01\"\n"
                "velocity = [4, 0, 0]\n[monitor]\non_violation = \"warn\"\n[handler]\nmethod = \"imex\"\n"
                "[output]\nevery = 2.5e-3\n");
  const Outcome outcome = call("run led.toml --out led");
  EXPECT_THAT(outcome.out, HasSubstr("handled element inverted, det F = "));
  const Json summary = json("led/summary.json");
  int found = 0;
  for (const Json& event : summary["events"]) {
    if (event["text"].get<std::string>().find("handled element inverted") == std::string::npos) continue;
    ++found;
    EXPECT_EQ(event["kind"], "inverted");
    // By the positions in the frames of that step and of the one before.
    const auto nodes = event["element"]["nodes"].get<std::vector<int>>();
    const auto volumeIn = [&](std::int64_t step) {
      const std::string digits = std::to_string(1000001 + step).substr(1);
      const NodeVectors x = readMesh(folder_.path() / ("led/frames/frame_" + digits + ".vtu")).X;
      Eigen::Matrix3d edges;
      for (int k = 0; k < 3; ++k) edges.col(k) = x.col(nodes[static_cast<std::size_t>(k) + 1]) - x.col(nodes[0]);
      return edges.determinant();
    };
    const auto step = event["step"].get<std::int64_t>();
    EXPECT_GT(step, 1);
    EXPECT_NEAR(event["value"].get<double>(), volumeIn(step) / volumeIn(0), 1e-4);
    EXPECT_LT(event["value"].get<double>(), 0);
    EXPECT_GT(volumeIn(step - 1), 0);
  }
  EXPECT_EQ(found, 1);
}

TEST_F(HandledProgram, SaysWhenConjugateGradientsDoNotConverge) {
  write("[handler]\nmethod = \"imex\"\nsolver = \"cg\"\niterations = 2\n");
  const Outcome stopped = call("run slivers.toml --out stopped");
  EXPECT_EQ(stopped.status, 1);
  EXPECT_EQ(json("stopped/summary.json")["exit_reason"], "step-failed");
  EXPECT_THAT(stopped.out, HasSubstr("conjugate gradients did not converge"));
  const Outcome reduced = call("run slivers.toml --out reduced --set handler.on_failure=reduce-step");
  EXPECT_EQ(reduced.status, 0) << reduced.out;
  EXPECT_LT(json("reduced/summary.json")["smallest_step"].get<double>(), 3 * critical_);
  EXPECT_EQ(call("run slivers.toml --out enough --set handler.iterations=500").status, 0);
}

TEST_F(HandledProgram, RunsOnAGpuWhereThereIsOne) {
  write("[handler]\nmethod = \"imex\"\n[output]\nevery = 1\n");
  const std::string run = "run slivers.toml --set monitor.every=5 --set integrator.method=symplectic-euler --out ";
  const Outcome onHost = call(run + "cpu"), onGpu = call(run + "auto --set integrator.device=auto");
  ASSERT_EQ(onGpu.status, onHost.status) << onGpu.out << onHost.out;
  const Json here = json("auto/summary.json"), there = json("cpu/summary.json");
  EXPECT_THAT(here["notes"].dump(),
              HasSubstr(whyNoDevice().empty() ? "the steps were taken on" : "the steps are taken on the CPU, since"));
  EXPECT_EQ(here["exit_reason"], "end");
  EXPECT_EQ(there["exit_reason"], "end");
  EXPECT_EQ(here["handler"]["handled_elements"], there["handler"]["handled_elements"]);
  const Table gpu = table("auto/history.csv"), host = table("cpu/history.csv");
  ASSERT_EQ(gpu.rows.size(), host.rows.size());
  for (std::size_t i = 0; i < gpu.rows.size(); ++i) {
    EXPECT_EQ(gpu.at(i, "verdict"), host.at(i, "verdict"));
    for (const char* column : {"safe_s", "strain_J"})
      EXPECT_NEAR(gpu.number(i, column), host.number(i, column), 1e-2 * std::abs(host.number(i, column)) + 1e-12);
  }
}

TEST_F(HandledProgram, ComparesHandlersWithIntegrators) {
  const Outcome outcome = call("compare slivers.toml --integrators verlet --handlers all --json c.json --step " +
                               number(step_) + "," + number(critical_ / 2));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json runs = json("c.json")["runs"];
  ASSERT_EQ(runs.size(), 2 * (1 + allHandlers().size()));
  for (const Json& run : runs) {
    const bool large = run["h"].get<double>() > critical_;
    if (run["integrator"] == "verlet" && large)
      EXPECT_TRUE(run["error"].is_null() || run["error"].get<double>() > 1);
    else if (run["integrator"] == "imex" || run["integrator"] == "local-time-stepping" ||
             run["integrator"] == "modal-filter" || !large)
      EXPECT_LT(run["error"].get<double>(), large ? 0.02 : 1e-3) << run;
    else if (run["integrator"] == "fe-pbd")
      EXPECT_LT(run["error"].get<double>(), 0.1) << run;
    else
      EXPECT_TRUE(run["error"].is_number());  // mass scaling runs; with what error is its own affair
  }
  expectRefused("compare slivers.toml --handlers magic", "--handlers: unknown \"magic\"");
  expectRefused("compare slivers.toml --handlers imex --set damping.mass=1", "handlers do not work with [damping]");
}

TEST_F(HandledProgram, RefusesWhatDoesNotFitTogether) {
  const std::string run = "run slivers.toml --set handler.method=imex ";
  expectRefused("run slivers.toml --set handler.margin=0.2", "handler.margin: there is no handler");
  expectRefused("run slivers.toml --set monitor.on_violation=handle", "\"handle\" needs a handler");
  expectRefused(run + "--set integrator.method=rk4", "handlers work on symplectic-euler and verlet");
  expectRefused(run + "--set integrator.step=auto", "give a number");
  expectRefused(run + "--set handler.dissipation=2", "handler.dissipation: 2 is out of range; must be >= 0 and <= 1");
  expectRefused(run + "--set handler.solver=cholesky --set handler.tolerance=1e-3",
                "goes with solver auto or cg, not with \"cholesky\"");
  expectRefused(run + "--set monitor.on_violation=reduce-step", "works against the handler");
  expectRefused(run + "--set damping.mass=1", "handlers do not work with damping");
  expectRefused("run slivers.toml --set handler.method=mass-scaling --set handler.dissipation=0.1",
                "is a key of local-time-stepping, imex");
  expectRefused(run + "--set handler.variant=rigid", "is a key of local-time-stepping, fe-pbd, modal-filter");
  expectRefused("run slivers.toml --set handler.method=filtered --set handler.variant=rigid",
                "must be one of compliant");
  expectRefused("run slivers.toml --set handler.method=fe-pbd --set handler.variant=rigid --set handler.passes=3",
                "goes with variant linear, not with \"rigid\"");
  expectRefused("run slivers.toml --set handler.method=fe-pbd --set handler.passes=99", "must be >= 0 and <= 32");
  expectRefused("run slivers.toml --set handler.method=mass-scaling --set handler.selection=reduced-1-ring",
                "must be \"certified\"");
}

}  // namespace
}  // namespace ringwatch

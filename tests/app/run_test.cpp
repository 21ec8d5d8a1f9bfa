// `ringwatch run`: exit statuses, what it prints where, and what it leaves in its folder.
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ringwatch/app/output/report.h>
#include <ringwatch/app/run/device_stepper.h>
#include <ringwatch/app/scene/scene.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <ringwatch/monitor/step_limit.h>

#include "program.h"

namespace ringwatch {
namespace {

using test::Json;
using test::Outcome;
using test::Program;
using test::tiny;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST_F(Program, RunsASceneAndWritesWhatItPromises) {
  folder_.write("tiny.toml", tiny);
  const Outcome outcome = call("run tiny.toml --out results");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("50 steps to t = 0.05 s, end time reached"), HasSubstr("verdict certified")));
  expectNothingHalfWritten("results");

  const Table history = table("results/history.csv");
  EXPECT_EQ(history.columns,
            (std::vector<std::string>{"step", "time_s", "h_s", "safe_s", "optimistic_s", "controlling_element",
                                      "kinetic_J", "strain_J", "external_work_J", "balance_error_J",
                                      "elements_refreshed", "handled_elements", "metric_step_s", "verdict",
                                      "dissipated_J", "eroded_elements", "repeats"}));
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

// No step is stable there, and none is too large: that is not what "violated" says. A run that has ended so leaves no
// checkpoint behind.
TEST_F(Program, EndsAsNotFiniteWhereTheTangentIs) {
  std::string scene = tiny;
  scene.replace(scene.find("stvk"), 4, "neo-hookean");
  folder_.write("pressed.toml", scene);
  const Outcome outcome = call(
      "run pressed.toml --out r --set integrator.step=auto --set monitor.on_violation=stop "
      "--set move.0.velocity=[-12,0,0] --set output.every=1 --set output.checkpoint_every=1e-3");
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  const Json summary = json("r/summary.json");
  EXPECT_EQ(summary["exit_reason"], "non-finite") << outcome.out;
  EXPECT_TRUE(summary["first_violated"].is_null());
  bool told = false;
  for (const Json& event : summary["events"]) told = told || event["kind"] == "non-finite";
  EXPECT_TRUE(told);
  EXPECT_FALSE(exists("r/checkpoint.bin"));
}

// The fields that nobody wrote are those that the scheme has.
TEST_F(Program, WritesFramesOfSchemesWithoutACriticalStep) {
  std::string scene = tiny;
  scene.erase(scene.find("fields"));
  folder_.write("implicit.toml", scene);
  const Outcome outcome = call("run implicit.toml --out r --set integrator.method=implicit-euler");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(json("r/summary.json")["frames"], 6);
  EXPECT_THAT(folder_.read("r/frames/frame_000001.vtu"), ::testing::Not(HasSubstr("critical_step")));
  expectRefused(
      "run implicit.toml --out no --set integrator.method=implicit-euler --set 'output.fields=[\"critical_step\"]'",
      "has no critical step");
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

// A bar that stiffens under tension and is let go.
TEST_F(Program, TakesALongerStepAgainWhereItIsCertified) {
  std::string scene = tiny;
  const std::string steady = "velocity = [0.05, 0, 0]";
  ASSERT_NE(scene.find(steady), std::string::npos);
  scene.replace(scene.find(steady), steady.size(), "displacement = [0.06, 0, 0]\nfactor = \"sin(pi*t/0.2)\"");
  folder_.write("pulled.toml", scene);
  for (const std::string mode : {"reduce-step", "repeat"}) {
    const Outcome outcome = call(
        "run pulled.toml --out r --set integrator.step=2e-3 --set integrator.end=0.2 --set "
        "output.picture=false --set monitor.on_violation=" +
        mode);
    EXPECT_EQ(outcome.status, 0) << outcome.out;
    EXPECT_EQ(json("r/summary.json")["certified"], true) << mode;
    const Table history = table("r/history.csv");
    int shorter = 0, longer = 0;
    for (std::size_t i = 0; i < history.rows.size(); ++i) {
      const double h = history.number(i, "h_s"), before = history.number(i > 0 ? i - 1 : 0, "h_s");
      EXPECT_LE(h, history.number(i, "safe_s")) << mode << i;
      EXPECT_LE(h, 2e-3) << mode << i;
      shorter += h < before;
      longer += h > before;
    }
    EXPECT_GE(shorter, 1) << mode;
    EXPECT_GE(longer, 1) << mode;
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
  expectRefused(cuda + "g --set integrator.method=verlet", "a GPU takes no \"verlet\": its steps are not there");
  expectRefused(cuda + "g --set handler.method=mass-scaling --set integrator.step=1e-3",
                "its steps are not there; choose from imex");
  expectRefused(cuda + "g --set handler.method=imex --set integrator.step=1e-3 --set handler.solver=cholesky",
                "by conjugate gradients, not by");
  expectRefused("run tiny.toml --set integrator.device=gpu --out g", "must be one of cpu, cuda, auto");
  expectRefused(cuda + "g --set integrator.devices=[0,1.5]", "integrator.devices: 1.5 is not the number of a GPU");
  expectRefused(cuda + "g --set integrator.devices=[1,1]", "integrator.devices: GPU 1 is named twice");
  expectRefused(cuda + "g --set integrator.devices=[0,1] --set handler.method=imex --set integrator.step=1e-3",
                "a GPU takes no handlers on several GPUs");
  expectRefused("run tiny.toml --set integrator.devices=[0,1] --out g",
                "integrator.devices: the steps are taken on the CPU; set integrator.device");
  if (reason.empty()) expectRefused(cuda + "g --set integrator.devices=[999]", "GPU 999: this machine has");
  EXPECT_FALSE(exists("g"));
  EXPECT_EQ(call("run tiny.toml --out auto --set integrator.device=auto --set monitor.every=3").status, 0);
  const std::string notes = json("auto/summary.json")["notes"].dump();
  EXPECT_THAT(notes, HasSubstr(reason.empty() ? "the steps were taken on" : "the steps are taken on the CPU, since"));
  EXPECT_EQ(call("run tiny.toml --out verlet --set integrator.device=auto --set integrator.method=verlet").status, 0);
  EXPECT_THAT(json("verlet/summary.json")["notes"].dump(), HasSubstr("a GPU takes no"));
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

TEST_F(Program, ExampleOfAutoStepIsCertified) {
  const Outcome outcome =
      call("run '" RINGWATCH_EXAMPLES "/hex_bar_auto_step.toml' --out r --set output.picture=false");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_EQ(json("r/summary.json")["verdict"], "certified");
}

// Fierz 2013's nonlinear experiment: the monitor speaks before the energy does, and not before the exact value does.
TEST_F(Program, ExampleOfStretchedBarIsCaughtInTime) {
  const Outcome outcome = call("run '" RINGWATCH_EXAMPLES "/stretch_bar.toml' --out r");
  // The least safe step is that of a state after the run had gone unstable.
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("certified steps: "), Not(HasSubstr("would have been certified"))));
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

  // The same run up to the steps around the first violation, examined with the exact eigenvalue.
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

TEST_F(Program, DampingShortensTheStepAndIsInTheEnergyBalance) {
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
  const double lambda = std::pow(2 / plain.number(0, "optimistic_s"), 2), c = 1 + 2e-3 * lambda;
  EXPECT_NEAR(damped.number(0, "optimistic_s") * (c + std::sqrt(c * c + 4 * lambda)) / 4, 1, 1e-9);
  double before = 0, most = 0;
  for (std::size_t i = 0; i < damped.rows.size(); ++i) {
    EXPECT_GE(damped.number(i, "dissipated_J"), before);
    before = damped.number(i, "dissipated_J");
    most = std::max(most, damped.number(i, "external_work_J"));
    EXPECT_LE(std::abs(damped.number(i, "balance_error_J")), 0.075 * most + 1e-12);  // 0.069, in the second row
  }
  EXPECT_GT(before, 0);
  for (std::size_t i = 0; i < plain.rows.size(); ++i) EXPECT_EQ(plain.number(i, "dissipated_J"), 0);
}

TEST_F(Program, RefusesABracketThatDampingLeavesUnproven) {
  folder_.write("tiny.toml", tiny);
  expectRefused("run tiny.toml --set integrator.method=rk4 --set damping.mass=1",
                "choose from symplectic-euler and verlet");
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

}  // namespace
}  // namespace ringwatch

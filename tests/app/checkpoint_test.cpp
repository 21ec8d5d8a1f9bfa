// Runs that are stopped and resumed: history and frames have the bits of the run that was not stopped.
#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <ringwatch/app/run/checkpoint.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/fnv.h>

#include "program.h"

namespace ringwatch {
namespace {

using test::Json;
using test::Outcome;
using test::Program;
using ::testing::HasSubstr;

constexpr const char* scene = R"(mesh = {generate = "bar", size = [0.1, 0.02, 0.02], cells = [6, 1, 1], jitter = 0.2}
material = [{where = "x < 0.05", model = "stvk", young = 30e3, poisson = 0.3, density = 1000},
            {where = "x >= 0.05", model = "neo-hookean", young = 90e3, poisson = 0.3, density = 700}]
integrator = {method = "verlet", step = 2e-4, end = 0.5}
monitor = {on_violation = "warn", metric = "reduced-1-ring", certificates = 200}
[[fix]]
where = "x < 1e-6"
[[initial]]
where = "x > 0.05"
velocity = [0, 0.1, 0.2]
[[force]]
where = "x > 0.1 - 1e-6"
force = [0.02, 0, 0]
times = [0, 0.1]
factors = [0, 1]
ramp = "smooth"
[[probe]]
what = "energy"
material = 1
[[probe]]
what = "step"
where = "x > 0.08"
[output]
every = 0.03
checkpoint_every = 0.011
probe_every = 3
reactions = true
picture = false
fields = ["critical_step", "verdict", "metric"]
)";

/// Threads that wait for one another let others compute meanwhile: machines that test have more to do.
const std::string patient = "OMP_WAIT_POLICY=passive ";

class Checkpoints : public Program {
 protected:
  void SetUp() override { folder_.write("scene.toml", scene); }
  /// What differs between the results of two runs, "" for nothing.
  std::string difference(const std::string& a, const std::string& b) const {
    std::string found;
    if (folder_.read(a + "/history.csv") != folder_.read(b + "/history.csv")) found += "history ";
    if (folder_.read(a + "/probes.csv").empty() || folder_.read(a + "/probes.csv") != folder_.read(b + "/probes.csv"))
      found += "probes ";
    if (folder_.read(a + "/run.pvd") != folder_.read(b + "/run.pvd")) found += "run.pvd ";
    std::size_t frames = 0, others = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path() / a / "frames")) {
      const std::string name = entry.path().filename().string();
      if (folder_.read(a + "/frames/" + name) != folder_.read(b + "/frames/" + name)) found += name + " ";
      ++frames;
    }
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder_.path() / b / "frames"))
      ++others;
    if (frames < 2 || frames != others) found += joinText(frames, " and ", others, " frames ");
    Json one = json(a + "/summary.json"), other = json(b + "/summary.json");
    for (Json* summary : {&one, &other})
      for (const char* own : {"wall_time", "provenance"}) summary->erase(own);
    if (one != other) found += "summary " + Json::diff(one, other).dump();
    return found;
  }
  /// Begins or resumes the run of a scene in part/ and sends it signals, each so many seconds behind the one before,
  /// the last of which ends it; whether it had ended before.
  bool runFor(const std::string& begin, const std::vector<std::pair<double, std::string>>& signals) {
    std::string line = patient + "'" + executable() + "' " +
                       (exists("part/checkpoint.bin") ? "run --resume part" : begin) + " --threads 2 --quiet & p=$!; ";
    for (const auto& [seconds, signal] : signals)
      line += "sleep " + std::to_string(seconds) + "; kill -" + signal + " $p 2>/dev/null; ";
    shell(line + "wait $p");
    return exists("part/summary.json") && json("part/summary.json")["exit_reason"] == "end";
  }
};

constexpr const char* slidingBlock = R"(mesh = {generate = "cube", size = 0.04, cells = 2, jitter = 0.1}
material = {model = "neo-hookean", young = 1e5, poisson = 0.4, density = 1000}
integrator = {method = "symplectic-euler", step = 5e-5, end = 0.05}
monitor = {on_violation = "warn"}
[[initial]]
where = "all"
velocity = [0.4, 0, -0.5]
[[force]]
where = "all"
acceleration = [0, 0, -9.81]
[[obstacle]]
kind = "plane"
point = [0, 0, -1e-3]
normal = [0, 0, 1]
[[obstacle]]
kind = "sphere"
point = [0.02, 0.02, 0.062]
radius = 0.02
velocity = [0, 0, -0.3]
[[contact]]
damping = 0.1
friction = 0.3
[output]
every = 4e-3
picture = false
fields = ["critical_step", "verdict"]
probe_every = 3
[[probe]]
what = "momentum"
[[probe]]
what = "energy"
)";

constexpr const char* mountedBar =
    R"(mesh = {generate = "bar", size = [0.1, 0.02, 0.02], cells = [5, 1, 1], element = "hex8"}
material = [{where = "x < 0.05", model = "corotational", young = 30e3, poisson = 0.3, density = 1000},
            {where = "x >= 0.05", model = "mooney-rivlin", c10 = 6e3, c01 = 2e3, bulk = 1e5, density = 1100}]
integrator = {method = "verlet", step = 2e-4, end = 0.4}
damping = {mass = 2, stiffness = 1e-5}
monitor = {on_violation = "warn", every = 3, budget = 0.1}
[[spring]]
where = "x < 1e-6"
stiffness = 50
damping = 0.05
[[mass]]
where = "x > 0.1 - 1e-6"
mass = 0.01
[[move]]
where = "z < 1e-6 and x > 0.05 and x < 0.07"
velocity = [0, 0.05, 0]
times = [0, 0.05, 0.2, 0.25]
factors = [0, 1, 1, 0]
ramp = "smooth"
[output]
every = 0.02
history_every = 2
picture = false
probe_every = 2
reactions = true
[[probe]]
what = "reaction"
[[probe]]
what = "max_stretch"
)";

// RINGWATCH_KILLS: how many times runs are killed (kill -9), 18 without. As many thirds are stopped by other signals.
// RINGWATCH_SEED: other moments, so that processes side by side try different ones.
TEST_F(Checkpoints, ResumedRunsHaveTheBitsOfTheOneThatWasNotStopped) {
  const char* wanted = std::getenv("RINGWATCH_KILLS");
  const int kills = wanted ? std::atoi(wanted) : 18;
  folder_.write("block.toml", slidingBlock);
  folder_.write("mounted.toml", mountedBar);
  const char* seed = std::getenv("RINGWATCH_SEED");
  std::mt19937 random(seed ? static_cast<unsigned>(std::atoi(seed)) : 11U);
  int resumed = 0, killed = 0, stopped = 0, compared = 0;
  const struct {
    const char *name, *scene, *options;
  } cases[] = {
      {"several materials", "scene", ""},
      {"threshold", "scene", "--set monitor.mode=threshold --set integrator.step=6e-4"},
      {"auto, timed force, damping", "scene",
       "--set force.0.times=[0,0.2] --set integrator.step=auto --set integrator.method=symplectic-euler "
       "--set damping.stiffness=1e-5"},
      {"violated", "scene",
       "--set integrator.step=8.81e-4 --set monitor.every=3 --set material.0.model=linear --set "
       "material.1.model=linear"},
      {"reduced, seldom checkpoints", "scene",
       "--set integrator.step=9e-4 --set monitor.on_violation=reduce-step --set output.checkpoint_every=0.2"},
      {"contact and friction", "block", "--set output.checkpoint_every=1e-3"},
      {"contact, no checkpoints but of signals", "block", ""},
      {"quadratic bulk viscosity, no checkpoints but of signals", "block",
       "--set damping.bulk_viscosity=true --set monitor.mode=threshold"},
      {"springs, moves, damping, budget", "mounted", "--set output.checkpoint_every=0.01"},
      {"springs, no checkpoints but of signals", "mounted", ""},
      {"a checkpoint, a frame and a row at nearly every step", "scene",
       "--set output.checkpoint_every=3e-4 --set output.every=3e-4 --set integrator.end=0.1"},
  };
  int wantedSoFar = 0, number = 0;
  for (const auto& c : cases) {
    const std::string full = "full-" + std::to_string(number);
    const std::string arguments = joinText(c.scene, ".toml ", c.options, " --out ");
    const Outcome whole = call("run " + arguments + full + " --threads 1");
    ASSERT_LE(whole.status, 1) << whole.err;
    const auto wallTime = json(full + "/summary.json")["wall_time"]["total"].get<double>();
    double seconds = wallTime;
    wantedSoFar = (++number * kills + std::ssize(cases) - 1) / std::ssize(cases);
    // How many have left a checkpoint depends on how busy the machine is: runs of the last case make up for them.
    const bool last = number == std::ssize(cases);
    const auto wantsMore = [&] { return killed < wantedSoFar || (last && resumed < kills / 3); };
    for (int tries = 0; wantsMore() && tries < 20 * kills; ++tries) {
      std::filesystem::remove_all(folder_.path() / "part");
      const std::string begin = "run " + arguments + "part";
      const auto moment = [&] { return std::uniform_real_distribution(0.0, seconds)(random); };
      bool ended = false;
      int hits = 0;
      while (!ended && hits < 1 + tries % 3) {
        resumed += exists("part/checkpoint.bin") ? 1 : 0;
        // Most are killed, some of them behind a checkpoint that they were asked for; others are stopped.
        const int way = static_cast<int>(random() % 6);
        const bool stops = way == 3 || way == 4;
        ended = way < 3    ? runFor(begin, {{moment(), "KILL"}})
                : way == 3 ? runFor(begin, {{moment(), "TERM"}})
                : way == 4 ? runFor(begin, {{moment(), "INT"}})
                           : runFor(begin, {{moment() / 2, "USR1"}, {moment() / 2, "KILL"}});
        hits += ended ? 0 : 1;
        (stops ? stopped : killed) += ended ? 0 : 1;
      }
      // One that ended first was too quick for the time of the reference.
      if (ended) seconds = std::max(0.9 * seconds, 0.5 * wallTime);
      if (!ended && exists("part/checkpoint.bin")) ++resumed;
      if (!ended) {
        // In silence: what it writes is compared with what was checked against the schemas.
        const std::string rest = exists("part/checkpoint.bin") ? "run --resume part --threads 3" : begin;
        EXPECT_LE(shell(patient + "'" + executable() + "' " + rest + " --quiet").status, 1);
      }
      EXPECT_EQ(difference(full, "part"), "") << c.name << ", run " << tries;
      EXPECT_FALSE(exists("part/checkpoint.bin"));
      expectNothingHalfWritten("part");
      compared += hits > 0 ? 1 : 0;
    }
  }
  EXPECT_GE(killed, kills);
  EXPECT_GE(resumed, kills / 3);
  std::printf("%d kills, %d stops, %d resumptions, %d runs of them compared\n", killed, stopped, resumed, compared);
}

TEST_F(Checkpoints, OfSignalsHoldTheStepAtWhichTheyCame) {
  folder_.write("mounted.toml", mountedBar);
  const std::string begin = patient + "'" + executable() + "' run mounted.toml --out part --set integrator.end=1000 ",
                    tenRows =
                        "until [ $(wc -l < part/history.csv 2>/dev/null || echo 0) -gt 10 ]; do sleep 0.02; done; ",
                    checkpoint = "until [ -e part/checkpoint.bin ]; do sleep 0.02; done; ";
  const Outcome asked =
      shell(begin + "& p=$!; " + tenRows + "kill -USR1 $p; " + checkpoint + "cp part/checkpoint.bin asked.bin; " +
            "wc -l < part/history.csv > rows; kill -TERM $p; wait $p");
  EXPECT_EQ(asked.status, 4);
  EXPECT_THAT(asked.err, HasSubstr("checkpoint of 0.0"));
  EXPECT_THAT(asked.err, HasSubstr(" MB written to part/checkpoint.bin in "));
  EXPECT_THAT(asked.out, HasSubstr("ringwatch run --resume part goes on from here"));
  const std::string bytes = folder_.read("part/checkpoint.bin"), history = folder_.read("part/history.csv");
  EXPECT_NE(bytes, folder_.read("asked.bin"));
  const Checkpoint stopped = readCheckpoint(folder_.path() / "part");
  EXPECT_EQ(stopped.parts.at("result").at("steps").get<std::int64_t>(),
            json("part/summary.json")["steps"].get<std::int64_t>());
  EXPECT_EQ(stopped.parts.at("output").at("history"), history.size());

  // Whatever has become of it: one line, and the folder stays as it is.
  const auto refuse = [&](const std::string& what) {
    expectRefused("run --resume part", what);
    EXPECT_EQ(folder_.read("part/history.csv"), history);
    EXPECT_TRUE(exists("part/summary.json"));
  };
  std::mt19937 random(3);
  for (int i = 0; i < 12; ++i) {
    std::string damaged = bytes;
    if (i % 2 == 0)
      damaged[random() % damaged.size()] ^= static_cast<char>(1 << random() % 8);
    else
      damaged.resize(random() % damaged.size());
    folder_.write("part/checkpoint.bin", damaged);
    refuse("part/checkpoint.bin: ");
  }
  folder_.write("part/checkpoint.bin",
                "ringwatch checkpoint\n" + std::string(200, '\xbf'));  // as of an earlier version
  refuse("part/checkpoint.bin: was written by another version of ringwatch");
  Checkpoint other = stopped;
  other.memory.resize(other.memory.size() - 8);
  writeCheckpoint(folder_.path() / "part", other);
  refuse("part/checkpoint.bin: does not fit this scene");
  // Numbers of nodes, materials and verdicts that are not there.
  const Json discrete{{"governed", 0},     {"least_safe", nullptr},   {"most_touching", 1},   {"deepest", 0.1},
                      {"deepest_time", 0}, {"deepest_node", 1 << 30}, {"deepest_obstacle", 0}};
  const Json governing{{"observations", {1}}, {"least_safe", 1e-3}, {"at_least_safe", 7}};
  for (const auto& [key, value] : {std::pair<std::string, Json>("discrete", discrete),
                                   {"governing", governing},
                                   {"worst", "best"},
                                   {"steps", "many"}}) {
    other = stopped;
    other.parts["result"][key] = value;
    writeCheckpoint(folder_.path() / "part", other);
    refuse("part/checkpoint.bin: does not fit this scene");
  }
  folder_.write("part/checkpoint.bin", bytes);
  EXPECT_EQ(shell(patient + "'" + executable() + "' run --resume part --quiet & p=$!; sleep 0.5; kill -HUP $p; wait $p")
                .status,
            4);
  EXPECT_GT(folder_.read("part/history.csv").size(), history.size());
  EXPECT_TRUE(folder_.read("part/history.csv").starts_with(history));
}

TEST_F(Checkpoints, OfSignalsSayWhyThereIsNone) {
  const std::string tiny = test::tiny;
  folder_.write("tiny.toml", tiny);
  folder_.write("plain.toml", tiny.substr(0, tiny.find("[output]")));
  const auto stop = [&](const std::string& file, const std::string& options, const std::string& limit = "") {
    std::filesystem::remove_all(folder_.path() / "part");
    return shell(limit + patient + "'" + executable() + "' run " + file +
                 " --out part --set integrator.end=1000 --set output.picture=false " + options +
                 " & p=$!; until [ -e part/history.csv ]; do sleep 0.02; done; sleep 0.3; kill -USR1 $p; " +
                 "sleep 0.3; kill -TERM $p; wait $p");
  };
  const Outcome handled =
      stop("tiny.toml", "--set handler.method=imex --set move.0.velocity=[0,0,0] --set output.every=100");
  EXPECT_EQ(handled.status, 4) << handled.err;
  EXPECT_THAT(handled.err, HasSubstr("there is no checkpoint of step "));
  EXPECT_THAT(handled.err, HasSubstr("saved states do not go with handlers"));
  EXPECT_THAT(handled.out, HasSubstr("saved states do not go with handlers"));
  EXPECT_FALSE(exists("part/checkpoint.bin"));
  // Blocks of 512 or 1024 bytes; the checkpoint has some megabytes.
  const Outcome full = stop("plain.toml",
                            "--set mesh.cells=[40,10,10] --set integrator.step=1e-4 --set move.0.velocity=[0,0,0] "
                            "--set output.history_every=100000",
                            "ulimit -f 1000; ");
  EXPECT_EQ(full.status, 4) << full.err;
  EXPECT_THAT(full.err, HasSubstr("cannot write part/checkpoint.bin: File too large"));
  EXPECT_FALSE(exists("part/checkpoint.bin"));
  expectNothingHalfWritten("part");
}

TEST_F(Checkpoints, LeaveTheMotionAlone) {
  ASSERT_EQ(call("run scene.toml --out with --set output.history_every=7").status, 0);
  ASSERT_EQ(call("run scene.toml --out without --set output.history_every=7 --set output.checkpoint_every=9").status,
            0);
  const Table with = table("with/history.csv"), without = table("without/history.csv");
  ASSERT_EQ(with.rows.size(), without.rows.size());
  for (std::size_t i = 0; i < with.rows.size(); ++i) {
    EXPECT_EQ(with.at(i, "kinetic_J"), without.at(i, "kinetic_J")) << i;
    EXPECT_NEAR(with.number(i, "balance_error_J"), without.number(i, "balance_error_J"), 3.4e-16) << i;
  }
  EXPECT_FALSE(exists("with/checkpoint.bin"));  // it reached its end
}

TEST_F(Checkpoints, NeedTheirHistoryAndFrames) {
  ASSERT_EQ(stopRun("", hasCheckpoint, "KILL").status, 128 + SIGKILL);
  const std::string history = folder_.read("part/history.csv");
  folder_.write("part/history.csv", history.substr(0, 300));
  folder_.write("part/certificates/step_99999999.certificate", "of a longer run");
  expectRefused("run --resume part", "part/history.csv: has 300 bytes; the checkpoint needs its first ");
  EXPECT_EQ(folder_.read("part/history.csv"), history.substr(0, 300));
  folder_.write("part/history.csv", history);
  std::filesystem::rename(folder_.path() / "part/frames/frame_000001.vtu", folder_.path() / "kept.vtu");
  expectRefused("run --resume part", "part/frames/frame_000001.vtu: is missing; the checkpoint needs it");
  std::filesystem::rename(folder_.path() / "kept.vtu", folder_.path() / "part/frames/frame_000001.vtu");
  EXPECT_EQ(folder_.read("part/history.csv"), history);
  EXPECT_TRUE(exists("part/certificates/step_99999999.certificate"));  // the folder stays as it was
  EXPECT_EQ(call("run --resume part").status, 0);
  EXPECT_FALSE(exists("part/certificates/step_99999999.certificate"));
  // A new run into the folder leaves nothing of the old one.
  ASSERT_EQ(call("run scene.toml --out part --set integrator.end=0.002").status, 0);
  EXPECT_FALSE(exists("part/checkpoint.bin"));
}

// What is given must not depend on its value: the scene of a run is read again from what the run has kept of it.
TEST_F(Checkpoints, KeepWhatEqualsADefault) {
  const Scene atRest = readScene(folder_.path() / "scene.toml", {"initial.0.velocity=[0, 0, 0]"});
  Checkpoint checkpoint;
  checkpoint.sceneFile = "scene.toml";
  checkpoint.scene = atRest.echo;
  EXPECT_EQ(sceneOf(checkpoint).echo, atRest.echo);
  ASSERT_EQ(call("run scene.toml --out rest --set initial.0.velocity=[0,0,0] --set integrator.end=0.1").status, 0);
  EXPECT_EQ(call("inspect rest --frame 1").status, 0);
}

TEST_F(Checkpoints, AreRefusedWhereTheyDoNotFit) {
  ASSERT_EQ(call("run scene.toml --out part --set integrator.end=0.1").status, 0);
  EXPECT_FALSE(exists("part/checkpoint.bin"));
  expectRefused("run --resume part",
                "part/checkpoint.bin: cannot read: No such file or directory; a run that is stopped by a signal or has "
                "output.checkpoint_every writes it");
  expectRefused("run --resume nowhere", "nowhere: is no folder of a run");
  Checkpoint checkpoint;
  const Scene described = readScene(folder_.path() / "scene.toml");
  std::vector<std::string> notes;
  const Body body = sceneBody(described, sceneMesh(described, notes), 1);
  checkpoint.sceneFile = "scene.toml";
  checkpoint.scene = described.echo;
  checkpoint.mesh = hashOf(body.mesh());
  checkpoint.state.time = std::nextafter(0.1, 1);
  checkpoint.state.x = body.mesh().X;
  checkpoint.state.v = 1e-300 * body.mesh().X;
  checkpoint.parts = {{"number", 0.1}};
  writeCheckpoint(folder_.path() / "part", checkpoint);
  const Checkpoint back = readCheckpoint(folder_.path() / "part");
  EXPECT_EQ(back.state.time, checkpoint.state.time);
  EXPECT_EQ(back.state.x, checkpoint.state.x);
  EXPECT_EQ(back.state.v, checkpoint.state.v);
  EXPECT_EQ(back.parts, checkpoint.parts);
  EXPECT_EQ(sceneOf(back).echo, described.echo);

  folder_.write("other.toml", std::string(scene).replace(std::string(scene).find("2e-4"), 4, "3e-4"));
  expectRefused("run other.toml --resume part",
                "part/checkpoint.bin: is of another scene than other.toml: integrator.step differs");
  for (const char* option : {"--set integrator.end=1", "--out x", "--require-certified"})
    expectRefused(std::string("run --resume part ") + option, "does not go with --resume");
  checkpoint.scene["mesh"]["seed"] = 2;
  writeCheckpoint(folder_.path() / "part", checkpoint);
  expectRefused("run --resume part", "the mesh is another one than when the checkpoint was written");
  std::string bytes = folder_.read("part/checkpoint.bin");
  bytes[bytes.size() / 2] ^= 1;
  folder_.write("part/checkpoint.bin", bytes);
  expectRefused("run --resume part", "part/checkpoint.bin: is damaged");
  const std::string deep(100'000, '\x81');  // CBOR's lists, one within the other
  const std::uint64_t size = deep.size();
  folder_.write("part/checkpoint.bin", sealed(bytes.substr(0, bytes.find('\n') + 1) +
                                              std::string(reinterpret_cast<const char*>(&size), sizeof size) + deep));
  expectRefused("run --resume part", "part/checkpoint.bin: is damaged");
  folder_.write("part/checkpoint.bin", "short");
  expectRefused("run --resume part", "part/checkpoint.bin: is no checkpoint");

  const auto refuse = [&](const std::string& options, const std::string& what) {
    expectRefused("run scene.toml --out refused " + options, "output.checkpoint_every: " + what);
  };
  folder_.write("scene.toml", [&] {
    std::string text = scene;  // without what is refused first
    for (const char* line : {"ramp = \"smooth\"\n", "factors = [0, 1]\n", "times = [0, 0.1]\n", ", certificates = 200"})
      if (const auto at = text.find(line); at != std::string::npos) text.erase(at, std::string(line).size());
    return text;
  }());
  refuse("--set output.checkpoint_every=1e-15", "1e-15 s makes 5e+14 checkpoints");
  refuse("--set output.checkpoint_every=0", "0 is out of range; must be > 0 s");
}

}  // namespace
}  // namespace ringwatch

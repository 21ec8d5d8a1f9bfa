// Runs that are stopped and resumed: history and frames have the bits of the run that was not stopped.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>

#include <ringwatch/app/run/checkpoint.h>
#include <ringwatch/base/error.h>

#include "program.h"

namespace ringwatch {
namespace {

using test::Json;
using test::Outcome;
using test::Program;
using ::testing::HasSubstr;

constexpr const char* scene = R"([mesh]
generate = "bar"
size = [0.1, 0.02, 0.02]
cells = [6, 1, 1]
jitter = 0.2
[[material]]
where = "x < 0.05"
model = "stvk"
young = 30e3
poisson = 0.3
density = 1000
[[material]]
where = "x >= 0.05"
model = "neo-hookean"
young = 90e3
poisson = 0.3
density = 700
[integrator]
method = "verlet"
step = 2e-4
end = 0.5
[monitor]
on_violation = "warn"
metric = "reduced-1-ring"
certificates = 200
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
  /// Begins or resumes a run and kills it after so many seconds, unless it ends before; whether it ended.
  bool runFor(double seconds, const std::string& options, const char* signal) {
    const std::string what =
        exists("part/checkpoint.bin") ? "run --resume part" : "run scene.toml --out part " + options;
    shell("'" + executable() + "' " + what + " --quiet & p=$!; sleep " + std::to_string(seconds) + "; kill -" + signal +
          " $p 2>/dev/null; wait $p");
    return exists("part/summary.json") && json("part/summary.json")["exit_reason"] == "end";
  }
};

// RINGWATCH_KILLS: how many times runs are killed, 6 without.
TEST_F(Checkpoints, ResumedRunsHaveTheBitsOfTheOneThatWasNotStopped) {
  const char* wanted = std::getenv("RINGWATCH_KILLS");
  const int kills = wanted ? std::atoi(wanted) : 6;
  std::mt19937 random(11);
  int resumed = 0, killed = 0, compared = 0;
  const struct {
    const char *name, *options;
  } cases[] = {{"verlet", ""},
               {"moved",
                "--set force.0.times=[0,0.2] --set integrator.step=auto --set integrator.method=symplectic-euler "
                "--set damping.stiffness=1e-5"},
               {"violated",
                "--set integrator.step=8.81e-4 --set monitor.every=3 --set material.0.model=linear --set "
                "material.1.model=linear"}};
  int wantedSoFar = 0;
  for (const auto& c : cases) {
    const std::string full = std::string("full-") + c.name;
    const Outcome whole = call("run scene.toml --out " + full + " " + c.options);
    ASSERT_LE(whole.status, 1) << whole.err;
    const auto wallTime = json(full + "/summary.json")["wall_time"]["total"].get<double>();
    double seconds = wallTime;
    wantedSoFar += (kills + 2) / 3;
    // Kills before the first checkpoint leave nothing to resume.
    for (int tries = 0; (killed < wantedSoFar || resumed < wantedSoFar / 3) && tries < 20 * kills; ++tries) {
      std::filesystem::remove_all(folder_.path() / "part");
      bool ended = false;
      int hits = 0;
      while (!ended && hits < 1 + tries % 3) {
        resumed += exists("part/checkpoint.bin") ? 1 : 0;
        ended = runFor(std::uniform_real_distribution(0.0, seconds)(random), c.options, hits == 1 ? "TERM" : "KILL");
        hits += ended ? 0 : 1;
      }
      // One that ended first was too quick for the time of the reference.
      if (ended) seconds = std::max(0.9 * seconds, 0.5 * wallTime);
      killed += hits;
      if (!ended && exists("part/checkpoint.bin")) ++resumed;
      const std::string rest = exists("part/checkpoint.bin") ? "run --resume part --threads 2"
                                                             : "run scene.toml --out part " + std::string(c.options);
      if (!ended) {
        EXPECT_LE(call(rest).status, 1);
      }
      EXPECT_EQ(difference(full, "part"), "") << c.name << ", run " << tries;
      EXPECT_EQ(exists("part/checkpoint.bin"), json("part/summary.json")["exit_reason"] != "end");
      expectNothingHalfWritten("part");
      compared += hits > 0 ? 1 : 0;
    }
  }
  EXPECT_GE(killed, kills);
  EXPECT_GE(resumed, kills / 3);
  std::printf("%d kills, %d resumptions, %d runs that were killed compared\n", killed, resumed, compared);
}

TEST_F(Checkpoints, LeaveTheMotionAlone) {
  ASSERT_EQ(call("run scene.toml --out with --set output.history_every=7").status, 0);
  ASSERT_EQ(call("run scene.toml --out without --set output.history_every=7 --set output.checkpoint_every=9").status,
            0);
  const Table with = table("with/history.csv"), without = table("without/history.csv");
  ASSERT_EQ(with.rows.size(), without.rows.size());
  for (std::size_t i = 0; i < with.rows.size(); ++i) {
    EXPECT_EQ(with.at(i, "kinetic_J"), without.at(i, "kinetic_J")) << i;
    EXPECT_NEAR(with.number(i, "balance_error_J"), without.number(i, "balance_error_J"), 1.1e-16) << i;
  }
  EXPECT_FALSE(exists("with/checkpoint.bin"));  // it reached its end
}

TEST_F(Checkpoints, NeedTheirHistoryAndFrames) {
  // Killed behind its first checkpoint.
  ASSERT_NE(shell("'" + executable() +
                  "' run scene.toml --out part --quiet & p=$!; while [ ! -e part/checkpoint.bin ] && "
                  "kill -0 $p; do sleep 0.01; done; kill -9 $p; wait $p")
                .status,
            0);
  ASSERT_TRUE(exists("part/checkpoint.bin"));
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
                "part/checkpoint.bin: cannot read: No such file or directory; a run with "
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
  folder_.write("part/checkpoint.bin", "short");
  expectRefused("run --resume part", "part/checkpoint.bin: is no checkpoint");

  const auto refuse = [&](const std::string& options, const std::string& what) {
    expectRefused("run scene.toml --out refused " + options, "output.checkpoint_every: " + what);
  };
  folder_.write("scene.toml", [&] {
    std::string text = scene;  // without what is refused first
    for (const char* line : {"ramp = \"smooth\"\n", "factors = [0, 1]\n", "times = [0, 0.1]\n", "certificates = 200\n"})
      if (const auto at = text.find(line); at != std::string::npos) text.erase(at, std::string(line).size());
    return text;
  }());
  refuse("--set handler.method=imex --set integrator.step=1e-4", "the handler \"imex\" has no checkpoints");
  refuse("--set integrator.method=cvode-bdf", "\"cvode-bdf\" has no checkpoints; ");
  refuse("--set integrator.device=cuda --set integrator.method=symplectic-euler", "a run on a GPU has no checkpoints");
  refuse("--set output.checkpoint_every=1e-15", "1e-15 s makes 5e+14 checkpoints");
  refuse("--set output.checkpoint_every=0", "0 is out of range; must be > 0 s");
}

}  // namespace
}  // namespace ringwatch

// Handlers with step = "auto" and with damping, and frames between the steps of a run.
#include <cmath>
#include <string>

#include <ringwatch/app/output/frames.h>
#include <ringwatch/meshes/mesh_io.h>

#include "handled_program.h"

namespace ringwatch {
namespace {

using test::HandledProgram;
using test::Json;
using test::Outcome;
using ::testing::HasSubstr;

constexpr const char* pulled =
    R"(mesh = {generate = "bar", size = [0.2, 0.04, 0.04], cells = [10, 2, 2], jitter = 0.3, seed = 3}
material = {model = "stvk", young = 30e3, poisson = 0.3, density = 1000}
integrator = {method = "verlet", step = "auto", end = 0.1}
[[fix]]
where = "x < 1e-6"
[[move]]
where = "x > 0.2 - 1e-6"
velocity = [1.0, 0, 0]
[handler]
method = "imex"
factor = 1.3
[output]
picture = false
)";

class HandledAuto : public HandledProgram {
 protected:
  /// The largest error of the energy balance over the largest energy.
  double balanceOf(const std::string& folder) const {
    const Table history = table(folder + "/history.csv");
    double error = 0, energy = 0;
    for (std::size_t i = 0; i < history.rows.size(); ++i) {
      energy = std::max(energy, history.number(i, "kinetic_J") + std::abs(history.number(i, "strain_J")));
      error = std::max(error, std::abs(history.number(i, "balance_error_J")));
    }
    return error / energy;
  }
};

TEST_F(HandledAuto, FollowsTheExplicitPartBelowTheWantedStep) {
  folder_.write("scene.toml", pulled);
  struct Case {
    const char* handler;
    double balance;  // about thrice what is measured
  };
  for (const auto& [handler, balance] : {Case{"imex", 0.036}, {"local-time-stepping", 0.043}, {"mass-scaling", 0.02}}) {
    const std::string folder(handler);
    // More room, as local-time-stepping has with this law, would leave nothing to follow.
    const Outcome outcome =
        call("run scene.toml --out " + folder + " --set handler.margin=0.1 --set 'handler.method=\"" + handler + "\"'");
    EXPECT_EQ(outcome.status, 0) << handler << outcome.err << outcome.out;
    const Json summary = json(folder + "/summary.json");
    EXPECT_NE(summary["verdict"], "violated");
    EXPECT_DOUBLE_EQ(summary["end_time"].get<double>(), 0.1);
    const Table history = table(folder + "/history.csv");
    // The first step is 1.3 of the safe step of the whole body; none is longer, and each is certified where it is
    // taken.
    const double first = history.number(0, "h_s");
    bool shorter = false;
    for (std::size_t i = 0; i < history.rows.size(); ++i) {
      EXPECT_LE(history.number(i, "h_s"), first) << handler;
      EXPECT_LE(history.number(i, "h_s"), history.number(i, "safe_s")) << handler << " " << i;
      shorter = shorter || (i + 1 < history.rows.size() && history.number(i, "h_s") < 0.99 * first);
    }
    EXPECT_TRUE(shorter) << handler << ": the bar stiffens";
    EXPECT_GE(summary["handler"]["selections"].get<int>(), 2);
    EXPECT_LE(balanceOf(folder), balance) << handler;
  }
  // The step that is asked for, as the handler has it.
  ASSERT_EQ(call("run scene.toml --out own --set handler.factor=1.3 --set handler.method='\"imex\"'").status, 0);
  const double step = table("own/history.csv").number(0, "h_s");
  std::string text(pulled);
  text.replace(text.find("factor = 1.3"), 12, "step = " + test::digits(0.9 * step));
  folder_.write("step.toml", text);
  ASSERT_EQ(call("run step.toml --out step").status, 0);
  EXPECT_EQ(table("step/history.csv").number(0, "h_s"), 0.9 * step);
  // With "handle" the handler takes more elements, and the step stays.
  ASSERT_EQ(call("run scene.toml --out handle --set monitor.on_violation=handle --set handler.dissipation=0.3").status,
            0);
  const Table handle = table("handle/history.csv");
  for (std::size_t i = 0; i + 1 < handle.rows.size(); ++i) EXPECT_EQ(handle.number(i, "h_s"), handle.number(0, "h_s"));
  EXPECT_GT(handle.number(handle.rows.size() - 1, "handled_elements"), handle.number(0, "handled_elements"));
}

// Slivers at three times their step, with damping: against Verlet in steps that the whole body takes.
TEST_F(HandledAuto, DampsAndKeepsTheBalance) {
  struct Case {
    const char *handler, *damping;
  };
  for (const auto& [handler, damping] : {Case{"imex", "mass = 20.0"},
                                         {"imex", "mass = 5.0\nstiffness = 1e-4"},
                                         {"local-time-stepping", "mass = 20.0"}}) {
    const std::string own = std::string("[damping]\n") + damping + "\n[output]\nevery = 0.1\npicture = false\n";
    write(std::string("[handler]\nmethod = \"") + handler + "\"\ndissipation = 0.0\n" + own);
    const Outcome outcome = call("run slivers.toml --out handled");
    ASSERT_EQ(outcome.status, 0) << handler << outcome.err << outcome.out;
    EXPECT_EQ(json("handled/summary.json")["verdict"], "certified");
    write(own);
    ASSERT_EQ(call("run slivers.toml --out fine --set integrator.step=" + number(step_ / 40)).status, 0);
    const Table fine = table("fine/history.csv"), history = table("handled/history.csv");
    const double dissipated = history.number(history.rows.size() - 1, "dissipated_J"),
                 exact = fine.number(fine.rows.size() - 1, "dissipated_J");
    EXPECT_GT(dissipated, 0);
    EXPECT_NEAR(dissipated, exact, 0.05 * exact) << handler << " " << damping;
    EXPECT_LE(balanceOf("handled"), 0.03) << handler << " " << damping;
    const NodeVectors X = readMesh(folder_.path() / "fine/frames/frame_000001.vtu").X,
                      x = readMesh(folder_.path() / "fine/frames/frame_000002.vtu").X,
                      y = readMesh(folder_.path() / "handled/frames/frame_000002.vtu").X;
    EXPECT_LE((y - x).norm(), 0.02 * (x - X).norm()) << handler << " " << damping;
  }
}

TEST_F(HandledAuto, RefusesWhatMakesNoSense) {
  const auto refused = [&](const std::string& what, const std::string& with, const std::string& message) {
    std::string text(pulled);
    text.replace(text.find("factor = 1.3\n"), 13, what);
    folder_.write("bad.toml", text + with);
    expectRefused("run bad.toml --out bad", message);
    EXPECT_FALSE(exists("bad/history.csv"));
  };
  refused("step = 0.5\n", "", "handler.step: 0.5 s is beyond the end");
  refused("step = 1e-3\nfactor = 2.0\n", "", "handler.step: both step and factor are given");
  refused("factor = 0.0\n", "", "handler.factor: 0 is out of range; must be > 0");
  refused("solver = \"newton\"\n", "[damping]\nmass = 1.0\n", "\"newton\" works without [damping]");
  refused("", "[damping]\nmass = 1e5\n", "needs a step below");
  std::string text(pulled);
  text.replace(text.find("\"imex\""), 6, "\"fe-pbd\"");
  folder_.write("bad.toml", text + "[damping]\nmass = 1.0\n");
  expectRefused("run bad.toml --out bad",
                "damping.mass: the handler \"fe-pbd\" works without mass-proportional damping");
  folder_.write("bad.toml", text + "[damping]\nstiffness = 1e-5\n");
  expectRefused("run bad.toml --out bad", "the handler \"fe-pbd\" works without stiffness-proportional damping");
  write("[handler]\nmethod = \"imex\"\nfactor = 2.0\n");
  expectRefused("run slivers.toml --out bad", "handler.factor: is for integrator.step = \"auto\"");
}

// Frames at times between large steps: of third order in the step, so that they fit those of small steps.
TEST_F(HandledAuto, FramesAreAtTheVeryTimes) {
  const std::string output = "[output]\nevery = 0.0073\nexact_times = true\npicture = false\nfields = [\"handler\"]\n";
  write("[handler]\nmethod = \"local-time-stepping\"\ndissipation = 0.0\n" + output);
  ASSERT_EQ(call("run slivers.toml --out coarse --set integrator.step=" + number(0.1 / 12) + " --set handler.levels=8")
                .status,
            0);
  write(output);
  ASSERT_EQ(call("run slivers.toml --out fine --set integrator.step=" + number(step_ / 40)).status, 0);
  const std::vector<PvdEntry> coarse = framesOfRun(folder_.path() / "coarse"),
                              fine = framesOfRun(folder_.path() / "fine");
  ASSERT_EQ(coarse.size(), 15u);  // and that of the end
  ASSERT_EQ(fine.size(), 15u);
  const NodeVectors X = readMesh(folder_.path() / "fine" / fine.front().file).X;
  for (std::size_t i = 2; i < 14; ++i) {
    EXPECT_DOUBLE_EQ(coarse[i].time, static_cast<double>(i) * 0.0073);
    EXPECT_DOUBLE_EQ(fine[i].time, static_cast<double>(i) * 0.0073);
    const NodeVectors a = readMesh(folder_.path() / "coarse" / coarse[i].file).X,
                      b = readMesh(folder_.path() / "fine" / fine[i].file).X;
    EXPECT_LE((a - b).norm(), 0.03 * (b - X).norm()) << i;
  }
  write("[output]\nexact_times = true\n");
  expectRefused("run slivers.toml --out bad", "output.exact_times: there are no frames; give output.every");
}

}  // namespace
}  // namespace ringwatch

// Runs with a handler, beyond the critical step.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ringwatch/app/run/device_stepper.h>
#include <ringwatch/meshes/mesh_io.h>

#include <tests/handlers/handler_cases.h>

#include "handled_program.h"

namespace ringwatch {
namespace {

using test::HandledProgram;
using test::Json;
using test::Outcome;
using test::Program;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

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

TEST_F(HandledProgram, NamesTheSameElementsWithAndWithoutEnergies) {
  write("[handler]\nmethod = \"imex\"\n");
  ASSERT_EQ(call("run slivers.toml --out with").status, 0);
  ASSERT_EQ(call("run slivers.toml --out without --set output.energy=false").status, 0);
  const Table with = table("with/history.csv"), without = table("without/history.csv");
  ASSERT_EQ(with.rows.size(), without.rows.size());
  ASSERT_FALSE(with.rows.empty());
  for (std::size_t i = 0; i < with.rows.size(); ++i)
    EXPECT_EQ(with.at(i, "controlling_element"), without.at(i, "controlling_element")) << i;
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
  for (const char* method : {"imex", "fe-pbd", "modal-filter", "local-time-stepping", "mass-scaling"}) {
    ASSERT_EQ(call("run slivers.toml --out handled --set handler.method=" + std::string(method) + step).status, 0);
    EXPECT_EQ(folder_.read("plain/history.csv"), folder_.read("handled/history.csv")) << method;
    EXPECT_EQ(json("handled/summary.json")["handler"]["handled_elements"], 0);
  }
}

TEST_F(HandledProgram, TakesSmallerStepsWhereTheyAreNeeded) {
  write("[handler]\nmethod = \"adaptive\"\nmargin = 0.1\n");  // an older name of local-time-stepping
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

TEST_F(HandledProgram, TakesMoreElementsWhenTheExplicitPartStiffens) {
  // With less dissipation new choices disturb the energy: docs/handlers.md.
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
  // A node in the midst of a bar is moved along it, faster than the others can follow.
  folder_.write("moved.toml",
                "[mesh]\ngenerate = \"bar\"\nsize = [0.2, 0.04, 0.04]\ncells = [10, 2, 2]\n[material]\n"
                "model = \"corotational\"\nyoung = 30e3\npoisson = 0.3\ndensity = 1000\n[integrator]\n"
                "method = \"verlet\"\nstep = 2.5e-3\nend = 0.03\n[[fix]]\nwhere = \"x < 1e-6\"\n[[move]]\n"
                "where = \"abs(x - 0.1) < 0.01 and abs(y - 0.02) < 0.01 and abs(z - 0.02) < 0.01\"\n"
                "velocity = [4, 0, 0]\n[monitor]\non_violation = \"warn\"\n[handler]\nmethod = \"imex\"\n"
                "[output]\nevery = 2.5e-3\n");
  const Outcome outcome = call("run moved.toml --out moved");
  EXPECT_THAT(outcome.out, ::testing::ContainsRegex("handled tet4 element 0:.* inverted, det F = "));
  const Json summary = json("moved/summary.json");
  int found = 0;
  for (const Json& event : summary["events"]) {
    if (!event["handled"].get<bool>()) continue;
    ++found;
    EXPECT_EQ(event["kind"], "inverted");
    // By the positions in the frames of that step and of the one before.
    const auto nodes = event["element"]["nodes"].get<std::vector<int>>();
    const auto volumeIn = [&](std::int64_t step) {
      const std::string digits = std::to_string(1000001 + step).substr(1);
      const NodeVectors x = readMesh(folder_.path() / ("moved/frames/frame_" + digits + ".vtu")).X;
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

TEST_F(HandledProgram, SaysWhatIsProvenWhereEveryElementIsHandled) {
  write("");
  const std::string run = "run slivers.toml --set integrator.step=" + number(40 * critical_) +
                          " --set monitor.on_violation=handle --set handler.method=";
  const struct {
    const char *options, *verdict, *note;
    int status;
  } cases[]{{"imex --out all", "certified", "Steps are certified by what the handler proves", 0},
            {"imex --set handler.solver=linear --out all", "unmonitored", "is assumed, not proven", 3},
            {"local-time-stepping --set handler.levels=10 --out all", "certified",
             "Steps are certified by what the handler proves", 0},
            {"local-time-stepping --set handler.levels=1 --out all", "unmonitored", "is assumed, not proven", 3}};
  for (const auto& one : cases) {
    const Outcome outcome = call(run + one.options);
    EXPECT_EQ(outcome.status, one.status) << one.options << outcome.out << outcome.err;
    const Json summary = json("all/summary.json");
    EXPECT_EQ(summary["handler"]["handled_elements"], 240) << one.options;
    EXPECT_EQ(summary["verdict"], one.verdict) << one.options;
    EXPECT_EQ(summary["certified_steps"], one.status == 0 ? summary["steps"] : Json(0)) << one.options;
    EXPECT_THAT(summary["notes"].dump(), AllOf(HasSubstr("every element is handled"), HasSubstr(one.note)));
  }
}

// One pass leaves crowded elements too soft: by their law they have more energy than the support gave them.
TEST_F(HandledProgram, JudgesTheEnergyWhereEveryElementIsHandled) {
  write("[handler]\nmethod = \"fe-pbd\"\n", "[[move]]\nwhere = \"x > 0.2 - 1e-6\"\nvelocity = [0.2, 0, 0]\n");
  const Outcome outcome = call(
      "run slivers.toml --out all --set handler.energy_limit=0 --set handler.margin=0.7 --set integrator.end=0.3 "
      "--set integrator.step=" +
      number(10 * critical_));
  EXPECT_EQ(outcome.status, 1) << outcome.out;
  const Json summary = json("all/summary.json");
  EXPECT_EQ(summary["handler"]["handled_elements"], 240);
  EXPECT_EQ(summary["verdict"], "unstable");
  EXPECT_THAT(summary["events"].dump(), HasSubstr("energy-balance"));
}

// A sliver that is turned inside out in a step has no tangent by this law, so that no choice can be made.
TEST_F(HandledProgram, KeepsTheResultWhereAChoiceCannotBeMade) {
  writeMesh(test::sliverBar(0.995), folder_.path() / "flat.msh");
  folder_.write("flat.toml",
                "[mesh]\nfile = \"flat.msh\"\n[material]\nmodel = \"neo-hookean\"\nyoung = 30e3\npoisson = 0.3\n"
                "density = 1000\n[integrator]\nmethod = \"symplectic-euler\"\nstep = 4.9e-4\nend = 0.1\n[[initial]]\n"
                "where = \"x < 0.11995\"\nvelocity = [0.5, 0, 0]\n[monitor]\non_violation = \"handle\"\n"
                "[handler]\nmethod = \"local-time-stepping\"\nenergy_limit = 0\n");
  const Outcome outcome = call("run flat.toml --out flat");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr("the handler cannot choose again"));
  const Json summary = json("flat/summary.json");
  EXPECT_EQ(summary["exit_reason"], "step-failed");
  EXPECT_EQ(summary["verdict"], "unstable");
  EXPECT_GT(table("flat/history.csv").rows.size(), 0u);
}

TEST_F(HandledProgram, SaysFromWhenOnRelaxedElementsAreImplicit) {
  write("[handler]\nmethod = \"fe-pbd\"\n", "[[move]]\nwhere = \"x > 0.2 - 1e-6\"\nvelocity = [0.2, 0, 0]\n");
  const Outcome outcome =
      call("run slivers.toml --out all --set handler.margin=0.7 --set integrator.end=0.3 --set integrator.step=" +
           number(10 * critical_));
  const Json summary = json("all/summary.json");
  EXPECT_THAT(summary["notes"].dump(), HasSubstr("imex takes them from here on"));
  EXPECT_GT(summary["handler"]["implicit_steps"].get<double>(), 0.5 * summary["steps"].get<double>());
  EXPECT_THAT(summary["events"].dump(), Not(HasSubstr("energy-balance"))) << outcome.out;
}

// A body that vibrates for 1500 steps at twice its critical step; 100 000 steps are those of scripts/nightly.
TEST_F(HandledProgram, KeepsItsEnergyInLongRuns) {
  write("");
  const std::string run =
      "run slivers.toml --out long --set monitor.mode=threshold --set monitor.on_violation=handle "
      "--set output.history_every=20 --set integrator.method=symplectic-euler --set integrator.step=" +
      number(2 * critical_) + " --set integrator.end=" + number(3000 * critical_);
  for (const char* handler : {"imex", "local-time-stepping", "fe-pbd", "modal-filter", "mass-scaling"})
    for (const char* law : {"stvk", "corotational", "neo-hookean", "stable-neo-hookean"}) {
      const Outcome outcome = call(run + " --set handler.method=" + handler + " --set material.model=" + law);
      ASSERT_EQ(outcome.status, 0) << handler << " " << law << outcome.out << outcome.err;
      const Table history = table("long/history.csv");
      double largest = 0, rise = 0, fall = 0;
      for (std::size_t i = 0; i < history.rows.size(); ++i) {
        largest = std::max(largest, history.number(i, "kinetic_J") + history.number(i, "strain_J"));
        rise = std::max(rise, history.number(i, "balance_error_J"));
        fall = std::max(fall, -history.number(i, "balance_error_J"));
      }
      EXPECT_GT(history.rows.size(), 70u);
      EXPECT_LE(rise, 0.003 * largest) << handler << " " << law;
      EXPECT_LE(fall, 0.003 * largest) << handler << " " << law;
    }
}

TEST_F(HandledProgram, SaysWhenConjugateGradientsDoNotConverge) {
  write("[handler]\nmethod = \"imex\"\nsolver = \"cg\"\niterations = 2\nenergy_limit = 0\n");
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

TEST_F(HandledProgram, HandlesAllElementsOfOneMaterial) {
  folder_.write("halves.toml",
                R"(mesh = {generate = "bar", size = [0.2, 0.1, 0.1], cells = [4, 2, 2], element = "pyramid5"}
material = [{where = "x < 0.1", model = "corotational", young = 1e6, poisson = 0, density = 1000},
            {where = "x >= 0.1", model = "corotational", young = 1e4, poisson = 0, density = 1000}]
integrator = {method = "verlet", step = 2e-3, end = 0.02}
[[initial]]
where = "all"
velocity = [0, 0, -1]
[handler]
method = "imex"
[output]
picture = false
)");
  EXPECT_EQ(call("run halves.toml --out halves").status, 0);
  const Json summary = json("halves/summary.json");
  EXPECT_EQ(summary["handler"]["handled_elements"], 48);  // the stiff half: eight cells of six
  EXPECT_EQ(summary["certified_steps"], 10);
}

TEST_F(HandledProgram, RefusesWhatDoesNotFitTogether) {
  const std::string run = "run slivers.toml --set handler.method=imex ";
  expectRefused("run slivers.toml --set handler.margin=0.2", "handler.margin: there is no handler");
  expectRefused("run slivers.toml --set monitor.on_violation=handle", "\"handle\" needs a handler");
  expectRefused(run + "--set integrator.method=rk4", "choose from symplectic-euler and verlet");
  expectRefused(run + "--set handler.dissipation=2", "handler.dissipation: 2 is out of range; must be >= 0 and <= 1");
  expectRefused(run + "--set handler.solver=cholesky --set handler.tolerance=1e-3",
                "goes with solver auto, newton, linear or cg, not with \"cholesky\"");
  expectRefused("run slivers.toml --set handler.method=fe-pbd --set damping.mass=1",
                "works without mass-proportional damping");
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

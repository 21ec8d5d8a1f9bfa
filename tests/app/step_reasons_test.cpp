// Why a step is small: the paragraph of inspect, suggest and run, and its numbers.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ringwatch/app/run/run_recorder.h>
#include <ringwatch/materials/registry.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/monitor/bounds/exchange_bound.h>

#include "program.h"

namespace ringwatch {
namespace {

using test::Json;
using test::material;
using test::Outcome;
using test::Program;
using test::tiny;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A row of bricks along x, 0.01 m high and wide, of these lengths (m), as a deck.
/// left out: an element that is not there, though its nodes are; 0 for none.
std::string row(const std::vector<double>& lengths, int leftOut = 0) {
  std::string text = "*NODE\n", elements = "*ELEMENT, TYPE=C3D8, ELSET=all\n";
  double x = 0;
  int node = 0;
  const auto face = [&] {
    for (const char* yz : {"0, 0", "0.01, 0", "0.01, 0.01", "0, 0.01"})
      text += std::to_string(++node) + ", " + test::digits(x) + ", " + yz + "\n";
  };
  face();
  for (std::size_t e = 0; e < lengths.size(); ++e) {
    x += lengths[e];
    face();
    if (static_cast<int>(e) + 1 == leftOut) continue;
    elements += std::to_string(e + 1);
    for (int a = 0; a < 8; ++a) elements += ", " + std::to_string(node - 7 + a);
    elements += "\n";
  }
  return text + elements;
}

constexpr double young = 30e3, density = 1000;
double waveSpeed(double poisson) {
  return std::sqrt(young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson) * density));
}

TEST_F(Program, InspectSaysWhatMakesAThinElementsStepSmall) {
  const std::vector<double> lengths{0.01, 0.01, 0.001, 0.01, 0.01, 0.01};
  folder_.write("thin.inp", row(lengths));
  folder_.write("without.inp", row(lengths, 3));
  const Outcome outcome = call("inspect thin.inp --json thin.json" + std::string(material));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json report = json("thin.json");
  const Json& why = report["why"];
  EXPECT_EQ(why["element"]["id"], 3);
  EXPECT_NEAR(why["height"].get<double>(), 0.001, 1e-12);
  EXPECT_NEAR(why["wave_speed"].get<double>(), waveSpeed(0.3), 1e-9);
  EXPECT_NEAR(why["wave_step"].get<double>(), 0.001 / waveSpeed(0.3), 1e-12);
  EXPECT_EQ(why["own_step"], report["critical_step"]["metrics"]["reduced-1-ring"]);
  EXPECT_THAT(why["faults"], Contains("size"));
  EXPECT_THAT(why["faults"], Contains("shape"));  // an aspect of 10
  // Without it the step is proven that the mesh which is left has with the thin element's mass, a tenth of a cube's, at
  // its nodes; and with the mass that is advised there it is about that step.
  EXPECT_EQ(why["remesh"]["elements"], 1);
  EXPECT_EQ(why["remesh"]["numbers"], "number 3");
  EXPECT_TRUE(why["remesh"]["proven"]);
  EXPECT_EQ(why["without_element"], why["remesh"]["step"]);
  EXPECT_GT(why["remesh"]["step"].get<double>(), 2 * why["safe"].get<double>());
  const auto suggested = [&](const std::string& mesh, double mass) {
    folder_.write("row.toml", "[mesh]\nfile = \"" + mesh +
                                  "\"\n[material]\nmodel = \"stvk\"\nyoung = 30e3\npoisson = 0.3\ndensity = 1000\n"
                                  "[integrator]\nstep = \"auto\"\nend = 1\n[[mass]]\nset = "
                                  "\"#9,10,11,12,13,14,15,16\"\nmass = " +
                                  test::digits(mass) + "\n");
    return parse(call("suggest row.toml --frame 1 --json -").out)["start"]["safe"].get<double>();
  };
  EXPECT_NEAR(suggested("without.inp", 1e-4) / why["remesh"]["step"].get<double>(), 1, 1e-6);
  const double added = why["mass"]["added"];
  EXPECT_NEAR(why["mass"]["share"].get<double>(), added / 5.1e-3, 1e-9);
  EXPECT_NEAR(suggested("thin.inp", added) / why["remesh"]["step"].get<double>(), 1, 0.25);
  EXPECT_EQ(why["handler"], "imex");
  ASSERT_EQ(why["text"].size(), 2u);
  ASSERT_EQ(why["remedies"].size(), 2u);
  for (const char* key : {"text", "remedies"})
    for (const Json& line : why[key]) EXPECT_THAT(outcome.out, HasSubstr("\n  " + line.get<std::string>() + "\n"));
  EXPECT_THAT(outcome.out, HasSubstr("cross element 3 (hex8), 0.001 m high"));
  EXPECT_THAT(outcome.out, HasSubstr("Remesh 1 of 6 elements (number 3)"));
}

TEST_F(Program, AnEvenMeshHasNoFewElementsInTheWay) {
  folder_.write("row.inp", row({0.01, 0.01, 0.01}));
  const Outcome outcome = call("inspect row.inp --json even.json" + std::string(material));
  const Json why = json("even.json")["why"];
  EXPECT_THAT(why["faults"], ElementsAre());
  EXPECT_TRUE(why["remesh"].is_null());
  EXPECT_THAT(outcome.out, HasSubstr("No few elements are in the way"));
}

TEST_F(Program, PoissonsRatioAndMaterialsAreNamedWhereTheyMakeWavesFast) {
  folder_.write("row.inp", row({0.01, 0.01, 0.01}));
  ASSERT_EQ(call("inspect row.inp --young 30e3 --poisson 0.495 --density 1000 --json stiff.json").status, 0);
  const Json why = json("stiff.json")["why"];
  EXPECT_NEAR(why["poisson"].get<double>(), 0.495, 1e-12);
  EXPECT_NEAR(why["poisson_factor"].get<double>(), waveSpeed(0.495) / waveSpeed(0.3), 1e-9);
  EXPECT_THAT(why["faults"], ElementsAre("poisson"));

  std::string scene = tiny;
  scene.replace(scene.find("[material]"), 11, "[[material]]\nwhere = \"x < 0.05\"\n");
  scene.replace(
      scene.find("[integrator]"), 0,
      "[[material]]\nwhere = \"x >= 0.05\"\nmodel = \"stvk\"\nyoung = 120e3\npoisson = 0.3\ndensity = 1000\n");
  folder_.write("two.toml", scene);
  const Outcome outcome = call("suggest two.toml --frame 0.02 --json two.json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json two = json("two.json")["why"];
  EXPECT_EQ(two["element"]["material"], 1);
  EXPECT_NEAR(two["wave_speed"].get<double>() / two["slowest_wave"].get<double>(), 2, 1e-12);
  EXPECT_THAT(two["faults"], Contains("material"));
  EXPECT_THAT(outcome.out, HasSubstr("Its material has fast waves"));
}

TEST_F(Program, DampingAndContactAreNamedWhereTheySetTheStep) {
  folder_.write("tiny.toml", tiny);
  const auto safe = [](const Json& report) { return report["start"]["safe"].get<double>(); };
  const Json plain = parse(call("suggest tiny.toml --frame 0.02 --json -").out),
             damped = parse(call("suggest tiny.toml --frame 0.02 --set damping.stiffness=2e-3 --json -").out);
  EXPECT_NEAR(plain["why"]["damping_share"].get<double>(), 0, 1e-9);
  EXPECT_NEAR(damped["why"]["damping_share"].get<double>(), 1 - safe(damped) / safe(plain), 1e-3);
  EXPECT_THAT(damped["why"]["faults"], Contains("damping"));

  const std::string contact =
      "[[obstacle]]\nkind = \"plane\"\npoint = [0, 0, -0.001]\nnormal = [0, 0, 1]\n[[contact]]\npenalty = 1e6\n";
  folder_.write("contact.toml", tiny + contact);
  const Outcome outcome = call("suggest contact.toml --frame 0.02 --json contact.json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json why = json("contact.json")["why"];
  EXPECT_THAT(why["faults"], Contains("penalty"));
  EXPECT_TRUE(why["remesh"].is_null());
  EXPECT_THAT(outcome.out, HasSubstr("Contact that can begin counts as if it touched already"));
  // A spring that is always there holds the top mode.
  folder_.write("spring.toml", tiny + std::string("[[spring]]\nwhere = \"x > 0.04 and x < 0.06\"\nstiffness = 1e6\n"));
  const Outcome sprung = call("suggest spring.toml --frame 0.02 --json spring.json");
  EXPECT_GT(json("spring.json")["why"]["discrete_share"].get<double>(), 0.9);
  EXPECT_THAT(sprung.out, HasSubstr("% of the energy of the top mode: a softer penalty"));
}

// What damping takes is that of the mode: the same whichever step the scene gives, above the critical one or below.
TEST_F(Program, DampingOfElementsAndNodesIsNamedAtAnyStep) {
  folder_.write("tiny.toml", tiny);
  folder_.write("dashpot.toml", tiny + std::string("[[spring]]\nwhere = \"x > 0.04 and x < 0.06\"\nstiffness = 0\n"
                                                   "damping = 20\n"));
  const auto report = [&](const std::string& scene, const std::string& settings) {
    const Outcome outcome = call("suggest " + scene + " --frame 0.02 --json -" + settings);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return parse(outcome.out);
  };
  const double plain = report("tiny.toml", "")["start"]["safe"];
  for (const std::string damping :
       {"tiny.toml --set material.stiffness_damping=2e-3", "tiny.toml --set material.mass_damping=2000",
        "tiny.toml --set damping.bulk_viscosity=true --set damping.linear_bulk_viscosity=1", "dashpot.toml"}) {
    double share = 0;
    for (const char* step : {"1e-5", "1e-3", "1e-2"}) {
      const Json found = report(damping, std::string(" --set integrator.step=") + step), &why = found["why"];
      EXPECT_THAT(why["faults"], Contains("damping")) << damping;
      EXPECT_THAT(why["faults"], testing::Not(Contains("penalty"))) << damping;
      if (share == 0) share = why["damping_share"];
      EXPECT_NEAR(why["damping_share"].get<double>(), share, 1e-3) << damping << " " << step;
      // Without damping no step is larger than the one that is promised.
      EXPECT_GT(why["undamped_step"].get<double>(), 0.98 * plain) << damping;
      EXPECT_NEAR(why["wave_step"].get<double>(), why["height"].get<double>() / why["wave_speed"].get<double>(), 1e-12);
    }
  }
}

// Remedies are those that the table of what goes together takes.
TEST_F(Program, MassIsAdvisedByTheCommandThatTakesTheBody) {
  folder_.write("row.inp", row({0.01, 0.01, 0.001, 0.01, 0.01, 0.01}));
  const std::string scene =
      "[mesh]\nfile = \"row.inp\"\n[material]\nmodel = \"stvk\"\nyoung = 30e3\npoisson = 0.3\ndensity = "
      "1000\n[integrator]\nstep = \"auto\"\nend = 1\n";
  for (const auto& [more, taken] : {std::pair<const char*, bool>{"", true},
                                    {"[[spring]]\nwhere = \"x > 0.04\"\nstiffness = 1\n", false},
                                    {"[damping]\nbulk_viscosity = true\n", false}}) {
    folder_.write("row.toml", scene + more);
    const Outcome outcome = call("suggest row.toml --frame 1 --json row.json");
    EXPECT_EQ(json("row.json")["why"]["mass"]["by_command"], taken) << more;
    EXPECT_THAT(outcome.out, HasSubstr(taken ? "(ringwatch scale-mass)" : "([[mass]] of a scene)"));
    EXPECT_EQ(call("scale-mass row.toml --step 1e-4").status == 2, !taken) << more;
  }
}

TEST_F(Program, RunSaysWhyOfItsLeastSafeStep) {
  folder_.write("tiny.toml", tiny);
  const Outcome outcome = call("run tiny.toml --out r");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json summary = json("r/summary.json");
  const Json& why = summary["why"];
  const Table rows = table("r/history.csv");
  std::size_t least = 0;
  for (std::size_t i = 1; i < rows.rows.size(); ++i)
    if (rows.number(i, "safe_s") < rows.number(least, "safe_s")) least = i;
  EXPECT_EQ(why["step"].get<int>(), rows.number(least, "step"));
  EXPECT_GE(why["safe"].get<double>(), summary["safe_seen"]["least"].get<double>() * (1 - 1e-9));  // it is sharper
  EXPECT_LE(why["safe"].get<double>(), rows.number(least, "optimistic_s"));
  // Where its step is another than that of the history, it says both.
  EXPECT_EQ(why["watched_safe"].get<double>(), rows.number(least, "safe_s"));
  EXPECT_EQ(why["text"][0].get<std::string>().find("the history has ") != std::string::npos,
            why["watched_safe"] != why["safe"]);
  EXPECT_THAT(outcome.out, HasSubstr("\n" + why["text"][0].get<std::string>() + "\n"));
  // A page has the same words.
  ASSERT_EQ(call("report r").status, 0);
  EXPECT_THAT(folder_.read("r/report.html"), HasSubstr(why["text"][0].get<std::string>()));
  EXPECT_TRUE([&] {
    call("run tiny.toml --out h --quiet --set handler.method=imex");
    return json("h/summary.json")["why"].is_null();
  }());
}

// The monitor stops at a sharp upper side; the reasons are those of the bracket from scratch, as inspect has it.
TEST_F(Program, ARunThatStopsAtOnceSaysWhyAsInspectDoes) {
  folder_.write("row.inp", row({0.01, 0.01, 0.004, 0.01}) +
                               "*SOLID SECTION, ELSET=all, MATERIAL=m\n*MATERIAL, NAME=m\n*ELASTIC\n30e3, "
                               "0.3\n*DENSITY\n1000\n*STEP, NLGEOM\n*DYNAMIC, EXPLICIT, DIRECT\n0.01, 1\n*END STEP\n");
  for (const char* more : {"", " --set damping.stiffness=1e-4", " --set material.stiffness_damping=1e-3",
                           " --set damping.bulk_viscosity=true"}) {
    const Outcome outcome = call(std::string("run row.inp --out r --set output.picture=false") + more);
    ASSERT_EQ(outcome.status, 1) << more << outcome.err;
    const Json why = json("r/summary.json")["why"];
    const Json inspected = parse(call(std::string("suggest row.inp --json -") + more).out)["why"];
    for (const char* key : {"safe", "optimistic", "median_step"})
      EXPECT_NEAR(why[key].get<double>() / inspected[key].get<double>(), 1, 1e-9) << key << more;
    EXPECT_EQ(why["element"], inspected["element"]) << more;
  }
}

// What is told at the end of a run is a small part of its work: bodies of many elements and runs of few steps get the
// sharp bracket only where the run has had one.
TEST_F(Program, ReasonsOfARunAreAsNarrowAsItCanPay) {
  const auto body = [](int cells) {
    return Body(generateBar({.size = {1, 0.2, 0.2}, .cells = {cells, 6, 6}}), makeMaterial("stvk", 1e6, 0.3, 1000));
  };
  const Body small = body(2), large = body(50);
  EXPECT_EQ(widthOfReasons(small, 0), ExchangePolicy::width);
  EXPECT_GT(widthOfReasons(large, 400), 0.5);
  EXPECT_EQ(widthOfReasons(large, 1'000'000), ExchangePolicy::width);
  folder_.write(
      "large.toml",
      "mesh = {generate = \"bar\", size = [1, 0.2, 0.2], cells = [50, 6, 6], jitter = 0.2}\n[material]\nmodel = "
      "\"stvk\"\nyoung = 1e6\npoisson = 0.3\ndensity = 1000\n[integrator]\nstep = 1e-4\nend = 2e-3\n[output]\npicture "
      "= false\n[[initial]]\nwhere = \"x > 0.5\"\nvelocity = [-5, 0, 0]\n");
  ASSERT_EQ(call("run large.toml --out r").status, 0);
  const Json why = json("r/summary.json")["why"];
  const Table rows = table("r/history.csv");
  std::size_t least = 0;
  for (std::size_t i = 1; i < rows.rows.size(); ++i)
    if (rows.number(i, "safe_s") < rows.number(least, "safe_s")) least = i;
  EXPECT_GE(why["safe"].get<double>(), rows.number(least, "safe_s") * (1 - 1e-9));
  EXPECT_LE(why["optimistic"].get<double>(), rows.number(least, "optimistic_s") * (1 + 1e-9));
}

// The elements are told of in the state whose bracket is shown, as inspect tells of it.
TEST_F(Program, RunSpeaksOfTheStateOfItsLeastSafeStep) {
  folder_.write("tiny.toml", tiny);
  const Outcome outcome = call("run tiny.toml --out r --set output.every=1e-3 --set move.0.velocity=\"[1, 0, 0]\"");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json why = json("r/summary.json")["why"];
  ASSERT_GT(why["step"].get<int>(), 10);
  const auto inspected = [&](int step) {
    return parse(call("inspect r --json - --frame " + std::to_string(step + 1)).out)["why"];
  };
  const Json same = inspected(why["step"].get<int>()), rest = inspected(0);
  EXPECT_NEAR(why["median_step"].get<double>() / same["median_step"].get<double>(), 1, 1e-6);
  EXPECT_GT(rest["median_step"].get<double>() / same["median_step"].get<double>(), 1.1);
}

// A rigid part has a step of its own by mass damping alone, which says nothing of the elements.
TEST_F(Program, ElementsWithoutStiffnessDoNotCount) {
  folder_.write("row.inp", row({0.01, 0.01, 0.001, 0.01, 0.01, 0.01, 0.01, 0.01, 0.01, 0.01, 0.01, 0.01, 0.01, 0.01}));
  const auto told = [&](double damping) {
    folder_.write("row.toml",
                  "[mesh]\nfile = \"row.inp\"\n[material]\nmodel = \"stvk\"\nyoung = 30e3\npoisson = 0.3\ndensity = "
                  "1000\n[integrator]\nstep = \"auto\"\nend = 1\n[[rigid]]\nname = \"head\"\nwhere = \"x > "
                  "0.06\"\n[damping]\nmass = " +
                      test::digits(damping) + "\n");
    return parse(call("suggest row.toml --frame 1 --json -").out)["why"];
  };
  const Json plain = told(0), damped = told(1e-6);
  EXPECT_EQ(plain["remesh"]["elements"], 1);
  EXPECT_EQ(damped["remesh"]["numbers"], plain["remesh"]["numbers"]);
  EXPECT_NEAR(damped["median_step"].get<double>() / plain["median_step"].get<double>(), 1, 1e-5);
  EXPECT_NEAR(damped["mass"]["added"].get<double>() / plain["mass"]["added"].get<double>(), 1, 1e-5);
}

TEST_F(Program, AWhollyHeldBodyHasNoLargestStep) {
  folder_.write("row.inp", row({0.01, 0.01}));
  // The call expects that the JSON is valid against its schema.
  const Outcome outcome = call("inspect row.inp --fix all --json -" + std::string(material));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json report = parse(outcome.out);
  EXPECT_TRUE(report["critical_step"]["safe"].is_null());
  EXPECT_TRUE(report["critical_step"]["optimistic"].is_null());
  EXPECT_TRUE(report["why"].is_null());
}

}  // namespace
}  // namespace ringwatch

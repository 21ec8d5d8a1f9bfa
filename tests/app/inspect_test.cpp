// `ringwatch inspect`: its human-readable report and its files, and what it refuses.
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/monitor/metrics/metrics.h>

#include "program.h"

namespace ringwatch {
namespace {

using test::Json;
using test::material;
using test::Outcome;
using test::Program;
using ::testing::HasSubstr;

TEST_F(Program, InspectsTetrahedraAndHexahedra) {
  for (const std::string element : {"tet4", "hex8"}) {
    ASSERT_EQ(call("mesh generate bar --size 0.2 0.04 0.04 --cells 10,2,2 --element " + element + " -o bar.msh").status,
              0);
    const Outcome outcome =
        call(std::string("inspect bar.msh --metric all --global --lanczos 1e-9 --step 2.5e-3 --json -") + material);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const Json report = parse(outcome.out);
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

TEST_F(Program, ProvesStepsByFactorisation) {
  // The values of the test above, to the ten digits that they are known to.
  for (const auto& [element, exact] : {std::pair{"tet4", 2.085284449e-3}, std::pair{"hex8", 2.973862796e-3}}) {
    ASSERT_EQ(
        call(std::string("mesh generate bar --size 0.2 0.04 0.04 --cells 10,2,2 --element ") + element + " -o bar.msh")
            .status,
        0);
    const auto inspect = [&, name = element](const std::string& options) {
      const Outcome outcome = call("inspect bar.msh --metric single-element --json - " + options + material);
      EXPECT_EQ(outcome.err, "") << name;
      return std::pair{outcome.status, parse(outcome.out)};
    };
    const auto [status, report] = inspect("--exact");
    EXPECT_EQ(status, 0);
    const Json& step = report["critical_step"]["exact"];
    const double safe = step["safe"], optimistic = step["optimistic"];
    EXPECT_LE(safe, exact * (1 + 3e-10));
    EXPECT_GE(optimistic, exact * (1 - 3e-10));
    EXPECT_LE(optimistic / safe - 1, 1e-6);
    EXPECT_GT(step["factor_numbers"].get<double>(), 1000);
    for (const auto& [share, wanted, verdict] : {std::tuple{0.999999, 0, "certified"},
                                                 {1.000001, 1, "violated"},
                                                 {0.5, 0, "certified"},
                                                 {2.0, 1, "violated"}}) {
      const auto [proof, proven] = inspect("--prove " + test::digits(share * exact));
      EXPECT_EQ(proof, wanted) << element << " " << share;
      EXPECT_EQ(proven["prove"]["verdict"], verdict) << element << " " << share;
      EXPECT_THAT(proven["conclusion"].get<std::string>(),
                  HasSubstr(wanted == 0 ? " s is proven stable by a factorisation; "
                                        : " s is proven unstable by a factorisation; "));
    }
  }
  const Outcome outcome = call(std::string("inspect bar.msh --exact --prove 1e-3") + material);
  EXPECT_THAT(outcome.out,
              HasSubstr("proven stable up to the first and unstable above the second, by a factorisation"));
  EXPECT_THAT(outcome.out, HasSubstr("h = 0.001 s: proven stable, by a factorisation of "));
  for (const char* bad : {"0", "-1", "inf", "nan"})
    expectRefused(std::string("inspect bar.msh --prove ") + bad + material, "--prove: ");
}

// The last line answers what was asked: the figures are those of the JSON.
TEST_F(Program, ConcludesWithTheAnswerToTheQuestion) {
  ASSERT_EQ(call("mesh generate bar --size 0.2 0.04 0.04 --cells 10,2,2 -o bar.msh").status, 0);
  const auto concluded = [&](const std::string& options) {
    const Json report = parse(call("inspect bar.msh --json - " + options + material).out);
    return std::pair{report, report["conclusion"].get<std::string>()};
  };
  const auto number = [](const Json& value, const char* form) {
    char text[32];
    std::snprintf(text, sizeof text, form, value.get<double>());
    return std::string(text);
  };
  const auto [plain, nothing] = concluded("");
  EXPECT_THAT(nothing, HasSubstr("every step up to " + number(plain["critical_step"]["safe"], "%.6g") +
                                 " s is proven stable; "));
  EXPECT_THAT(nothing, HasSubstr(" limits the step, without it "));
  EXPECT_THAT(concluded("--step 2.5e-3").second, HasSubstr("a step of 0.0025 s is proven unstable; "));
  EXPECT_THAT(concluded("--step 1e-3").second, HasSubstr("a step of 0.001 s is proven stable; "));
  const auto [range, stretched] = concluded("--stretch 0.7:1.5");
  EXPECT_THAT(stretched, HasSubstr("in every state of stretches 0.7 to 1.5 that is not indefinite every step up to " +
                                   number(range["stretch"]["safe"], "%.6g") + " s is proven stable; "));
  const auto [sharp, exact] = concluded("--exact");
  EXPECT_THAT(exact, HasSubstr("the critical step lies between " +
                               number(sharp["critical_step"]["exact"]["safe"], "%.10g") + " and "));
  EXPECT_THAT(
      concluded("--step 1e-3 --prove 1.5e-3").second,
      HasSubstr("a step of 0.001 s is proven stable; a step of 0.0015 s is proven stable by a factorisation; "));
  ASSERT_EQ(call("mesh generate bar --size 0.2 0.04 0.04 --cells 10,2,2 --jitter 0.2 -o bar.msh").status, 0);
  EXPECT_THAT(concluded("").second, HasSubstr(" limits the step, and so do others; "));
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

// An element of n nodes and q points has 3n - 6 deforming modes, of which q points resist at most 6q.
TEST_F(Program, InspectAndRunTellOfModesWithoutStiffness) {
  const std::string law = " --young 1e6 --poisson 0.3 --density 1000 --fix \"x < 1e-6\"";
  const auto notes = [&](const std::string& element, const std::string& rule) {
    EXPECT_EQ(call("mesh generate bar --size 0.2 0.1 0.1 --cells 2 1 1 --element " + element + " -o bar.vtu").status,
              0);
    const Outcome outcome = call("inspect bar.vtu --rule " + element + "=" + rule + law);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.out;
  };
  EXPECT_THAT(notes("hex20", "gauss-2x2x2"),
              HasSubstr("hex20 with the rule gauss-2x2x2: an element alone has 6 modes without stiffness"));
  EXPECT_EQ(notes("hex20", "gauss-3x3x3").find("without stiffness"), std::string::npos);
  EXPECT_EQ(notes("hex8", "gauss-2x2x2").find("without stiffness"), std::string::npos);
  EXPECT_EQ(notes("hex8", "uniform-strain").find("without stiffness"), std::string::npos);

  const std::string scene =
      "[mesh]\ngenerate = \"bar\"\nsize = [0.2, 0.1, 0.1]\ncells = [2, 1, 1]\nelement = \"hex8\"\n"
      "[material]\nmodel = \"linear\"\nyoung = 1e6\npoisson = 0.3\ndensity = 1000\n"
      "rules = [\"hex8=uniform-strain\"]\nhourglass_stiffness = 0.0\n"
      "[integrator]\nstep = \"auto\"\nend = 1e-3\n[[fix]]\nwhere = \"x < 1e-6\"\n";
  folder_.write("scene.toml", scene);
  ASSERT_EQ(call("run scene.toml --out r --set output.picture=false").status, 0);
  EXPECT_THAT(json("r/summary.json")["notes"].dump(),
              HasSubstr("hex8 with the rule uniform-strain: an element alone has 12 modes without stiffness"));
  ASSERT_EQ(call("run scene.toml --out r --set output.picture=false --set material.hourglass_stiffness=0.05").status,
            0);
  EXPECT_EQ(json("r/summary.json")["notes"].dump().find("without stiffness"), std::string::npos);
  // Viscous control resists them.
  for (const std::string command :
       {"run scene.toml --out r --set output.picture=false", "suggest scene.toml --frame 1"})
    EXPECT_THAT(call(command + " --set material.hourglass_viscosity=0.1").out,
                ::testing::Not(HasSubstr("without stiffness")));
}

// The speed of pressure waves is √(E (1 - ν) / ((1 + ν) (1 - 2ν) ρ)): 6001 m/s in steel.
TEST_F(Program, InspectTellsOfUnitsAndOfABodyThatNothingHolds) {
  const auto inspect = [&](const std::string& size, const std::string& law) {
    EXPECT_EQ(call("mesh generate bar --size " + size + " --cells 2 1 1 -o bar.msh").status, 0);
    return call("inspect bar.msh --poisson 0.3 " + law + " --json body.json").out;
  };
  const std::string steel = inspect("0.2 0.1 0.05", "--young 2.1e11 --density 7850 --fix \"x < 1e-6\"");
  EXPECT_EQ(steel.find("wave speed"), std::string::npos) << steel;
  EXPECT_EQ(steel.find("nothing is held"), std::string::npos) << steel;
  const double speed = std::sqrt(2.1e11 * 0.7 / (1.3 * 0.4 * 7850));
  const Json body = json("body.json")["body"];
  EXPECT_NEAR(body["wave_speed"]["slowest"].get<double>(), speed, 1e-9 * speed);
  EXPECT_NEAR(body["wave_speed"]["fastest"].get<double>(), speed, 1e-9 * speed);
  EXPECT_NEAR(body["crossing_time"].get<double>(), 0.2 / speed, 1e-9);
  for (const int i : {0, 1, 2}) EXPECT_NEAR(body["size"][i].get<double>(), i == 0 ? 0.2 : i == 1 ? 0.1 : 0.05, 1e-15);

  EXPECT_THAT(inspect("200 100 50", "--young 2.1e5 --density 7.85e-9 --fix \"x < 1e-6\""),
              HasSubstr("a wave speed of 6.001e+06 m/s is none of a solid; in mm, t and s it is one of 6001 m/s"));
  EXPECT_THAT(inspect("0.2 0.1 0.05", "--young 2.1e5 --density 7850 --fix \"x < 1e-6\""),
              HasSubstr("a wave speed of 6.001 m/s is none of a solid; with a modulus in MPa"));
  EXPECT_THAT(inspect("0.2 0.1 0.05", "--young 210 --density 7850 --fix \"x < 1e-6\""),
              HasSubstr("with a modulus in GPa beside m, kg and s it would be one of 6001 m/s"));
  EXPECT_THAT(inspect("0.2 0.1 0.05", "--young 2.1e11 --density 7.85 --fix \"x < 1e-6\""),
              HasSubstr("with a density in g/cm3 it would be one of 6001 m/s"));
  EXPECT_THAT(inspect("0.2 0.1 0.05", "--young 2.1e11 --density 7.85e-9 --fix \"x < 1e-6\""),
              HasSubstr("with a density in t/mm3 beside Pa it would be one of 6001 m/s"));
  EXPECT_THAT(inspect("200 100 50", "--young 2.1e11 --density 7850 --fix \"x < 1e-6\""),
              HasSubstr("the body is 200 m long; of a mesh in mm the critical step is a thousandth"));
  const std::string gel = inspect("0.2 0.1 0.05", "--young 30e3 --density 1000");
  EXPECT_EQ(gel.find("none of a solid"), std::string::npos) << gel;
  EXPECT_THAT(gel, HasSubstr("note: nothing is held: the body can fly and turn as a whole"));
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
                "pressure-wave:shortest-edge, pressure-wave:cell-diameter");
  expectRefused(std::string("inspect cube.msh --picture spread.pdf") + material, "must end in .svg or .png");
  expectRefused(std::string("inspect cube.msh --picture nowhere/a.svg") + material, "nowhere");
  expectRefused(std::string("inspect cube.msh --integrator explicit-euler") + material, "unstable at every step");
  expectRefused(std::string("inspect cube.msh --integrator verlett") + material, "did you mean \"verlet\"?");
  expectRefused(std::string("inspect cube.msh --step 0") + material,
                "--step: \"0\" is no time; must be a number > 0 or a fraction");
  expectRefused(std::string("inspect cube.msh --step nan") + material, "--step");
  expectRefused(std::string("inspect cube.msh --width -0.1") + material, "--width: -0.1 is out of range");
  expectRefused(std::string("inspect cube.msh --lanczos 1") + material, "--lanczos: 1 is out of range");
  expectRefused(std::string("inspect cube.msh --lanczos 1e-300") + material, "eta = 1e-300");
  expectRefused(std::string("inspect cube.msh --fix 'x > 5'") + material, "selects no node");
  expectRefused(std::string("inspect cube.msh --fix all --json nowhere/a.json") + material, "nowhere");
}

}  // namespace
}  // namespace ringwatch

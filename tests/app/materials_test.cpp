// Several materials in one body: which element has which, and what that does to statics, waves and the bracket.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <ringwatch/app/scene/scene.h>
#include <ringwatch/base/error.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/integrators/symplectic_euler.h>
#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/verify/static_solver.h>

#include <tests/monitor/bounds_fault.h>
#include "program.h"

namespace ringwatch {
namespace {

using test::Json;
using test::Outcome;
using test::Program;
using ::testing::AllOf;
using ::testing::HasSubstr;

/// A material of a test scene.
struct Part {
  std::string elements;  // where = "…" or set = "…"
  std::string model;
  double young, poisson, density;
};

std::string sceneText(const std::string& mesh, const std::vector<Part>& parts, const std::string& rest = "") {
  std::string text = "[mesh]\n" + mesh;
  for (const Part& part : parts)
    text += joinText("[[material]]\n", part.elements, "\nmodel = \"", part.model, "\"\nyoung = ", part.young,
                     "\npoisson = ", part.poisson, "\ndensity = ", part.density, "\n");
  return text + "[integrator]\nstep = 1e-4\nend = 0.01\n" + rest;
}

Body bodyOf(const std::string& text) {
  const test::TemporaryFolder folder;
  const Scene scene = readScene(folder.write("scene.toml", text));
  std::vector<std::string> notes;
  return sceneBody(scene, sceneMesh(scene, notes), 1);
}

Mesh barWithSets() {
  Mesh mesh = generateBar({{0.4, 0.1, 0.1}, {4, 1, 1}});
  auto& left = mesh.elementSets["left"];
  auto& right = mesh.elementSets["right"];
  for (std::int32_t e = 0; e < 24; ++e) (e % 2 == 0 ? left : right).push_back({0, e});
  mesh.blocks[0].ids.clear();
  return mesh;
}

SceneMaterial materialOfSet(const std::string& set, double density) {
  SceneMaterial material;
  material.model = "stvk";
  material.parameters = {{"young", 30e3}, {"poisson", 0.3}};
  material.density = density;
  material.set = set;
  material.selectionOrigin = "test: material.set";
  material.origin = "test: [[material]] of " + set;
  return material;
}

TEST(Materials, SplitBlocksAndKeepNumbersAndSets) {
  Mesh mesh = barWithSets();
  const Mesh before = mesh;
  const std::vector<Material> materials =
      assignMaterials({materialOfSet("right", 2), materialOfSet("left", 3)}, mesh, MaterialsBy::scene);
  ASSERT_EQ(mesh.blocks.size(), 2u);
  EXPECT_EQ(materialOfBlocks(mesh), (std::vector<int>{0, 1}));
  EXPECT_EQ(materials[0].density, 2);
  EXPECT_EQ(materials[1].density, 3);
  requireValid(mesh);
  // Each element is where its set says, with its number and its nodes.
  for (const auto& [name, number] : {std::pair<std::string, int>{"left", 1}, {"right", 0}}) {
    const auto& set = mesh.elementSets.at(name);
    ASSERT_EQ(set.size(), 12u);
    EXPECT_EQ(set, mesh.elementSets.at(joinText("material.", number)));
    for (const ElementRef e : set) {
      EXPECT_EQ(e.block, number);
      const std::size_t old = mesh.blocks[number].id(e.element);
      EXPECT_EQ(old % 2, name == "left" ? 0u : 1u);
      for (int a = 0; a < 4; ++a)
        EXPECT_EQ(mesh.blocks[number].element(e.element)[a], before.blocks[0].element(old)[a]);
    }
  }
  EXPECT_EQ(mesh.elementSets.at("all").size(), 24u);
  // What was made is found again, whatever the selections would say now.
  Mesh again = mesh;
  EXPECT_EQ(assignMaterials({materialOfSet("left", 2), materialOfSet("right", 3)}, again, MaterialsBy::mesh)[0].density,
            2);
  EXPECT_EQ(again.blocks[0].ids, mesh.blocks[0].ids);
}

TEST(Materials, NamesElementsWithoutOneOrWithTwo) {
  const auto fault = [](const std::vector<SceneMaterial>& materials) -> std::string {
    Mesh mesh = barWithSets();
    mesh.elementSets["empty"];
    try {
      assignMaterials(materials, mesh, MaterialsBy::scene);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no fault";
  };
  EXPECT_EQ(fault({materialOfSet("left", 1), materialOfSet("right", 1)}), "no fault");
  EXPECT_THAT(fault({materialOfSet("left", 1), materialOfSet("all", 1)}),
              AllOf(HasSubstr("of all: 12 elements have a material already, the first is tet4 0 at"),
                    HasSubstr("by test: [[material]] of left")));
  EXPECT_THAT(fault({materialOfSet("left", 1)}), HasSubstr("12 of 24 elements have no material, the first is tet4 1"));
  EXPECT_THAT(fault({materialOfSet("left", 1), materialOfSet("rigth", 1)}),
              HasSubstr("unknown element set \"rigth\"; did you mean \"right\"?"));
  EXPECT_THAT(fault({materialOfSet("left", 1), materialOfSet("empty", 1)}), HasSubstr("\"empty\" is empty"));
}

TEST_F(Program, RefusesMaterialsThatDoNotFit) {
  const std::string mesh = "generate = \"bar\"\nsize = [0.2, 0.04, 0.04]\ncells = [5, 1, 1]\n";
  const Part left{"where = \"x < 0.1\"", "stvk", 1e3, 0.3, 1000}, right{"where = \"x > 0.1\"", "linear", 1e6, 0.2, 500};
  const auto refuse = [&](const std::string& text, const std::string& what) {
    folder_.write("scene.toml", text);
    expectRefused("run scene.toml --out r", what);
    EXPECT_FALSE(exists("r/summary.json"));
  };
  refuse(sceneText(mesh, {left, left}), "scene.toml:11: [[material]]: 14 elements have a material already");
  refuse(sceneText(mesh, {left, {"where = \"x > 0.17\"", "stvk", 1e3, 0.3, 1e3}}), "have no material, the first is");
  refuse(sceneText(mesh, {left, {"where = \"x > 5\"", "stvk", 1e3, 0.3, 1e3}}),
         "scene.toml:12: material.where: \"x > 5\" selects no element; their centres lie in 0.01 <= x <= 0.19");
  refuse(sceneText(mesh, {left, {"", "stvk", 1e3, 0.3, 1e3}}), "scene.toml:11: material.where: missing");
  refuse(sceneText(mesh, {left, {"where = \"x > 0.1\"\nset = \"a\"", "stvk", 1e3, 0.3, 1e3}}),
         "both where and set are given");
  refuse(sceneText(mesh, {left,
                          {"where = \"x > 0.1\"\nlumping = \"equal\"", "stvk", 1, 0.3, 1e3},
                          {"where = \"x > 9\"\nlumping = \"row-sum\"", "stvk", 1, 0.3, 1e3}}),
         "scene.toml:20: material.lumping: another value than at scene.toml:13; it is one of the whole body");
  refuse(sceneText(mesh, {left, {"set = \"al\"", "stvk", 1, 0.3, 1e3}}),
         "unknown element set \"al\"; did you mean \"all\"?");
  refuse("material = []\n" + sceneText(mesh, {}), "material");
  folder_.write("scene.toml", sceneText(mesh, {left, right}));
  expectRefused("run scene.toml --set material.young=3", "[[material]] is a list; write material.0.young=");
  expectRefused("run scene.toml --set material.2.young=3", "there is no [[material]] number 2; the scene has 2");
}

// Of a bar whose right half has another rule, and whose end alone is moved, the energy is that of a bar of the end's
// rule.
TEST(Materials, HaveRulesOfTheirOwn) {
  const auto energies = [](const std::string& left, const std::string& right) {
    const std::string mesh = "generate = \"bar\"\nsize = [0.4, 0.1, 0.1]\ncells = [4, 1, 1]\nelement = \"hex8\"\n";
    const Body body = bodyOf(sceneText(mesh, {{"where = \"x < 0.2\"\n" + left, "linear", 1e5, 0.3, 1e3},
                                              {"where = \"x > 0.2\"\n" + right, "linear", 1e5, 0.3, 1e3}}));
    std::array<double, 2> found{};
    for (const std::size_t side : {0U, 1U}) {
      NodeVectors x = body.mesh().X;
      for (Eigen::Index i = 0; i < x.cols(); ++i)
        if (std::abs(x(0, i) - (side == 0 ? 0 : 0.4)) < 1e-9) x(0, i) += (x(1, i) - 0.05) * (x(2, i) - 0.05);
      Body::Workspace workspace;
      found[side] = body.energy(x, workspace);
    }
    return found;
  };
  const std::string onePoint = "rules = [\"hex8=uniform-strain\"]", full = "rules = [\"hex8=gauss-2x2x2\"]";
  const auto ofOnePoint = energies(onePoint, ""), ofFull = energies("", full), mixed = energies(onePoint, full);
  EXPECT_GT(ofFull[0], 1.5 * ofOnePoint[0]);
  EXPECT_NEAR(mixed[0] / ofOnePoint[0], 1, 1e-14);
  EXPECT_NEAR(mixed[1] / ofFull[1], 1, 1e-14);
}

// A bar of two halves under an end load F: elongation F/A (L1/E1 + L2/E2), exact in elements of the first order without
// lateral contraction.
TEST(Materials, StretchATwoMaterialBarAsTheoryHasIt) {
  for (const double contrast : {1.0, 7.0, 1e-3, 1e9}) {
    const double E1 = 1e5, E2 = contrast * E1, F = 1e-3 * std::min(E1, E2);
    Body body = bodyOf(
        sceneText("generate = \"bar\"\nsize = [0.3, 0.1, 0.1]\ncells = [6, 2, 2]\nelement = \"hex8\"\n",
                  {{"where = \"x < 0.1\"", "linear", E1, 0, 1000}, {"where = \"x > 0.1\"", "linear", E2, 0, 1000}},
                  "[[fix]]\nwhere = \"x < 1e-6\"\n"));
    const double A = 0.01;
    // The same traction everywhere on the end: a node's share of the force is its share of the area.
    for (std::int32_t i = 0; i < body.nodeCount(); ++i) {
      const Eigen::Vector3d X = body.mesh().X.col(i);
      if (X[0] < 0.3 - 1e-9) continue;
      const auto edge = [](double at) { return at < 1e-9 || at > 0.1 - 1e-9 ? 0.25 : 0.5; };
      body.externalForce()(0, i) = F * edge(X[1]) * edge(X[2]);
    }
    const StaticSolution solution = solveStatic(body, body.mesh().X);
    ASSERT_TRUE(solution.converged) << contrast;
    const double expected = F / A * (0.1 / E1 + 0.2 / E2);
    for (const std::int32_t i : body.mesh().nodeSets.at("x-max"))
      EXPECT_NEAR((solution.x(0, i) - 0.3) / expected, 1, 1.3e-14) << contrast;
  }
}

// Of a wave in a bar whose impedance Z = rho c A changes, (Z1 - Z2)/(Z1 + Z2) of the displacement is reflected and
// 2 Z1/(Z1 + Z2) goes on (Graff 1975, section 2.4). With the step dx/c the central difference scheme moves a wave
// along equal elements without error, and so it does across the interface where c is the same on both sides.
TEST(Materials, ReflectAWaveAsTheoryHasIt) {
  constexpr int cells = 60;
  constexpr double dx = 0.01, E = 4e4, density = 1000;
  for (const double ratio : {1.0, 3.0, 0.2, 1e9, 1e-9}) {
    // Sections that are wide compared with a cell: motions across them are slower than the wave.
    Body body = bodyOf(sceneText(joinText("generate = \"bar\"\nsize = [", cells * dx, ", 0.2, 0.2]\ncells = [", cells,
                                          ", 1, 1]\nelement = \"hex8\"\n"),
                                 {{"where = \"x < 0.3\"", "linear", E, 0, density},
                                  {"where = \"x > 0.3\"", "linear", ratio * E, 0, ratio * density}},
                                 "[[fix]]\nwhere = \"all\"\ncomponents = \"yz\"\n"));
    const double c = std::sqrt(E / density), h = dx / c;
    const auto pulse = [](double x) {
      const double s = (x - 0.15) / 0.06;
      return std::abs(s) < 1 ? 1e-4 * std::pow(1 - s * s, 3) : 0.0;
    };
    BodySystem system(body);
    State state = system.initialState();
    const NodeVectors& X = body.mesh().X;
    for (std::int32_t i = 0; i < body.nodeCount(); ++i) {
      state.x(0, i) += pulse(X(0, i));
      state.v(0, i) = (pulse(X(0, i)) - pulse(X(0, i) + dx)) / h;  // it moves to the right: of the half step before
    }
    SymplecticEuler scheme;
    constexpr int steps = 28;
    for (int n = 0; n < steps; ++n) ASSERT_TRUE(scheme.step(system, state, h).done);
    const double Z = ratio, reflected = (1 - Z) / (1 + Z), passed = 2 / (1 + Z);
    double largest = 0;
    for (std::int32_t i = 0; i < body.nodeCount(); ++i) {
      const double at = X(0, i), goes = at - steps * dx, comes = 0.6 - at - steps * dx;
      const double expected = at <= 0.3 + 1e-9 ? pulse(goes) + reflected * pulse(comes) : passed * pulse(goes);
      largest = std::max(largest, std::abs(state.x(0, i) - at - expected));
    }
    EXPECT_LT(largest, 6e-16) << ratio;  // of a pulse of 1e-4 m, in positions of up to 0.6 m
  }
}

TEST(Materials, OfAnyContrastHaveAProvenBracket) {
  int tried = 0;
  for (const double contrast : {1e3, 1e9, 1e-9})
    for (const char* element : {"tet4", "hex8"})
      for (const auto& [first, second] :
           {std::pair{"stvk", "neo-hookean"}, {"corotational", "linear"}, {"neo-hookean", "stvk"}})
        for (const double density : {1000.0, 1000 * contrast}) {
          const Body body = bodyOf(sceneText(
              joinText("generate = \"bar\"\nsize = [0.3, 0.1, 0.1]\ncells = [3, 1, 1]\njitter = 0.2\nelement = \"",
                       element, "\"\n"),
              {{"where = \"x < 0.14\"", first, 30e3, 0.3, 1000},
               {"where = \"x >= 0.14\"", second, 30e3 * contrast, 0.4, density}},
              "[[fix]]\nwhere = \"x < 1e-6\"\n"));
          ASSERT_EQ(body.mesh().blocks.size(), 2u);
          NodeVectors x = body.mesh().X;
          EXPECT_EQ(test::boundsFault(body, x), "") << element << first << contrast;
          test::Random random(7);
          x = (Eigen::Matrix3d::Identity() + random.matrix(0.1)) * x + random.nodeVectors(x.cols(), 0.004);
          EXPECT_EQ(test::boundsFault(body, x), "") << element << first << contrast << " deformed";
          ++tried;
        }
  EXPECT_EQ(tried, 36);
}

TEST(Materials, AreWatchedAlongARun) {
  const Body body = bodyOf(sceneText(
      "generate = \"bar\"\nsize = [0.3, 0.1, 0.1]\ncells = [3, 2, 2]\njitter = 0.2\n",
      {{"where = \"x < 0.15\"", "stvk", 30e3, 0.3, 1000}, {"where = \"x >= 0.15\"", "neo-hookean", 90e3, 0.3, 1e3}}));
  MonitorOptions options;
  StabilityMonitor monitor(body, options);
  test::Random random(3);
  const NodeVectors step = 0.1 * (random.matrix(1) * body.mesh().X + random.nodeVectors(body.nodeCount(), 0.03));
  const NodeVectors v = NodeVectors::Zero(3, body.nodeCount());
  for (int n = 0; n < 30; ++n) {
    const NodeVectors x = body.mesh().X + std::sin(0.2 * n) * step;
    const MonitorReport& report = monitor.observe(n, n, x, v, 1e-4);
    const double exact = stepFor(test::DenseTangent(body, x).largest(), test::limit);
    ASSERT_TRUE(report.bracket);
    EXPECT_LE(report.bracket->safe, exact * (1 + 1e-9)) << n;
    EXPECT_GE(report.bracket->optimistic, exact * (1 - 1e-9)) << n;
  }
}

TEST_F(Program, TellsWhichMaterialGovernsAndKeepsMaterialsThroughACut) {
  folder_.write("two.toml",
                sceneText("generate = \"bar\"\nsize = [0.2, 0.04, 0.04]\ncells = [10, 2, 2]\n",
                          {{"where = \"x < 0.103\"", "stvk", 30e3, 0.3, 1000},
                           {"where = \"x >= 0.103\"", "neo-hookean", 120e3, 0.3, 700}},
                          "[[fix]]\nwhere = \"x < 1e-6\"\n[[force]]\nwhere = \"x > 0.19\"\nforce = [0.2, 0, 0]\n"
                          "[[cut]]\ntime = 0.005\npoint = [0.1, 0.02, 0.02]\nnormal = [1, 0.6, 0.3]\nsnap = 0\n"
                          "[output]\nevery = 5e-3\npicture = false\n[monitor]\non_violation = \"reduce-step\"\n"));
  const Outcome outcome = call("run two.toml --out r");
  ASSERT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  const Json summary = json("r/summary.json");
  ASSERT_EQ(summary["cuts"].size(), 1u);
  ASSERT_EQ(summary["materials"].size(), 2u);
  // Whatever the centres of the parts, no mass changes its material.
  folder_.write("uncut.toml", folder_.read("two.toml"));
  ASSERT_EQ(call("run uncut.toml --out u --set cut.0.time=0.0099 --set integrator.end=0.01").status, 0);
  for (int m : {0, 1})
    EXPECT_NEAR(
        summary["materials"][m]["mass"].get<double>() / json("u/summary.json")["materials"][m]["mass"].get<double>(), 1,
        1e-12);
  EXPECT_EQ(
      summary["materials"][0]["elements"].get<std::size_t>() + summary["materials"][1]["elements"].get<std::size_t>(),
      summary["mesh"]["elements"]["tet4"].get<std::size_t>());
  EXPECT_EQ(summary["materials"][1]["model"], "neo-hookean");
  EXPECT_EQ(summary["materials"][1]["selection"], "x >= 0.103");
  const int governs = summary["governing_material"].get<int>();
  EXPECT_THAT(outcome.out, HasSubstr("material " + std::to_string(governs) + " ("));
  // Before the cut the bracket is that of the stiffer half; the controlling elements in the history are of its block.
  const Table history = table("r/history.csv");
  EXPECT_EQ(history.at(0, "controlling_element").substr(0, 2), "1:");
  double least = 1;
  std::string there;
  std::vector<int> counts(2);
  for (std::size_t i = 0; i < history.rows.size(); ++i) {
    const std::string block = history.at(i, "controlling_element").substr(0, 1);
    ++counts[std::stoul(block)];
    if (history.number(i, "safe_s") >= least) continue;
    least = history.number(i, "safe_s");
    there = block;
  }
  EXPECT_EQ(there, std::to_string(governs));
  for (int m : {0, 1}) EXPECT_EQ(summary["materials"][m]["governed_observations"], counts[m]);

  // A frame after the cut is inspected with the materials of the run.
  const Outcome frame = call("inspect r --frame 3 --json -");
  ASSERT_EQ(frame.status, 0) << frame.err;
  const Json inspected = parse(frame.out);
  for (int m : {0, 1})
    EXPECT_EQ(inspected["mesh"]["element_sets"]["material." + std::to_string(m)], summary["materials"][m]["elements"]);
  EXPECT_NEAR(inspected["mass"].get<double>(), summary["mass"].get<double>(), 1e-12);
  EXPECT_TRUE(inspected["controlling_element"].contains("material"));
  const Mesh cut = readMesh(folder_.path() / "r/frames/frame_000003.vtu");
  EXPECT_THAT(folder_.read("r/frames/frame_000003.vtu"), HasSubstr("Name=\"material\""));
  EXPECT_EQ(cut.elementCount(), summary["mesh"]["elements"]["tet4"].get<std::size_t>());
  expectRefused("inspect r --frame 1 --young 3e3", "--young: there are 2 materials");
}

TEST_F(Program, NamesATwoMaterialBarThatBlowsUpBeforeItsEnergy) {
  const std::string run = "run '" RINGWATCH_EXAMPLES "/two_material_bar.toml' --quiet --out ";
  ASSERT_EQ(call(run + "good").status, 0);
  EXPECT_EQ(json("good/summary.json")["verdict"], "certified");
  ASSERT_EQ(call(run + "bad --set integrator.step=4e-4 --set monitor.on_violation=warn").status, 1);
  const Json bad = json("bad/summary.json");
  ASSERT_FALSE(bad["first_violated"].is_null());
  ASSERT_FALSE(bad["energy_runaway"].is_null());
  EXPECT_LT(bad["first_violated"]["step"], bad["energy_runaway"]["step"]);
  EXPECT_EQ(bad["events"][0]["kind"], "violated");
  EXPECT_EQ(bad["events"][0]["element"]["block"], 1);  // of the stiff half, which a step for the soft one forgets
  int off = 0;
  for (const Json& event : bad["events"]) {
    if (event["kind"] != "energy-balance") continue;
    ++off;
    EXPECT_LT(bad["first_violated"]["step"], event["step"]);
  }
  EXPECT_GT(off, 0);
}

TEST_F(Program, HandlesTheStiffPartOfATwoMaterialBody) {
  folder_.write("two.toml",
                sceneText("generate = \"bar\"\nsize = [0.2, 0.04, 0.04]\ncells = [10, 2, 2]\n",
                          {{"where = \"x < 0.1\"", "stvk", 30e3, 0.3, 1000},
                           {"where = \"x > 0.1\"", "neo-hookean", 30e6, 0.3, 1000}},
                          "[[force]]\nwhere = \"x > 0.19\"\nforce = [0.2, 0, 0]\n[output]\npicture = false\n"
                          "[handler]\nmethod = \"imex\"\n"));
  ASSERT_EQ(call("run two.toml --out r --set integrator.step=5e-4 --set integrator.method=verlet").status, 0);
  const Json summary = json("r/summary.json");
  EXPECT_EQ(summary["verdict"], "certified");
  EXPECT_GE(summary["handler"]["handled_elements"].get<int>(), summary["materials"][1]["elements"].get<int>());
  EXPECT_LT(summary["handler"]["handled_elements"].get<int>(), summary["mesh"]["elements"]["tet4"].get<int>());
  EXPECT_EQ(table("r/history.csv").at(0, "controlling_element").substr(0, 2), "0:");
}

}  // namespace
}  // namespace ringwatch

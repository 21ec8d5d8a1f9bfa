// inspect beyond a free mesh at rest: sets, deformed states, frames of runs, rollers, quadrature rules, handlers.
#include <cmath>
#include <fstream>
#include <span>

#include <fmt/format.h>

#include <ringwatch/meshes/formats/vtu_writer.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/meshes/mesh_io.h>

#include <tests/handlers/handler_cases.h>
#include "program.h"

namespace ringwatch {
namespace {

using test::Json;
using test::material;
using test::Outcome;
using test::tiny;
using ::testing::AllOf;
using ::testing::HasSubstr;

class Inspect : public test::Program {
 protected:
  Json report(const std::string& arguments) {
    const Outcome outcome = call("inspect " + arguments + " --json -");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return parse(outcome.out);
  }
  /// The critical step by a dense solver.
  static double exact(const Body& body, const NodeVectors& x) { return 2 / std::sqrt(test::denseHighest(body, x)); }
  static Body bodyOf(const Mesh& mesh, ElementRules rules = {}) {
    return Body(mesh, makeMaterial("stvk", 30e3, 0.3, 1000), {std::move(rules), Lumping::rowSum, 1});
  }
  void makeBar(const std::string& element = "tet4") {
    ASSERT_EQ(
        call("mesh generate bar --size 0.1 0.02 0.02 --cells 5 1 1 --jitter 0.1 --element " + element + " -o bar.msh")
            .status,
        0);
  }
};

TEST_F(Inspect, ListsTheSetsOfAMesh) {
  Mesh mesh = generateBar({});
  mesh.elementSets["left half"] = {{0, 0}, {0, 1}, {0, 2}};
  writeMesh(mesh, folder_.path() / "bar.vtu");
  const Json json = report(std::string("bar.vtu") + material);
  EXPECT_EQ(json["mesh"]["element_sets"]["left half"], 3);
  EXPECT_EQ(json["mesh"]["node_sets"]["x-min"], mesh.nodeSets.at("x-min").size());
  EXPECT_EQ(json["mesh"]["node_sets"].size(), mesh.nodeSets.size());
  const Outcome text = call(std::string("inspect bar.vtu") + material);
  EXPECT_THAT(text.out, AllOf(HasSubstr("left half (3)"),
                              HasSubstr("x-min (" + std::to_string(mesh.nodeSets.at("x-min").size()) + ")")));
}

TEST_F(Inspect, CountsWhatAHandlerWouldTake) {
  writeMesh(test::sliverBar(0.98), folder_.path() / "slivers.msh");
  const Body body = test::sliverBody("stvk", 0.98);
  std::ostringstream step;
  step.precision(17);
  step << 3 * test::criticalStepOf(body);
  const Json json = report("slivers.msh --fix 'x < 1e-6' --integrator verlet --step " + step.str() + material);
  const auto count = json["handler"]["count"].get<int>();
  EXPECT_GT(count, 0);
  EXPECT_LT(count, 120);
  EXPECT_EQ(json["handler"]["elements"].size(), json["handler"]["count"]);
  // A run takes as many.
  folder_.write("slivers.toml",
                "[mesh]\nfile = \"slivers.msh\"\n[material]\nmodel = \"stvk\"\nyoung = 30e3\npoisson = 0.3\n"
                "density = 1000\n[integrator]\nmethod = \"verlet\"\nstep = " +
                    step.str() +
                    "\nend = 0.01\n[[fix]]\nwhere = \"x < 1e-6\"\n[handler]\nmethod = \"imex\"\n"
                    "[output]\npicture = false\n");
  const Outcome run = call("run slivers.toml --out r");
  ASSERT_EQ(run.status, 0) << run.out << run.err;
  EXPECT_EQ(json["handler"]["count"], parse(folder_.read("r/summary.json"))["handler"]["handled_elements"]);
  const Outcome text = call("inspect slivers.msh --fix 'x < 1e-6' --integrator verlet --step " + step.str() + material);
  EXPECT_THAT(text.out, HasSubstr("a handler would take " + std::to_string(count) + " of 240 elements"));
  // Handlers do not go with every integrator.
  EXPECT_TRUE(report("slivers.msh --integrator rk4 --step 1e-4" + std::string(material))["handler"].is_null());
}

TEST_F(Inspect, SaysThatAHandlerOfMostOfTheBodyDoesNotPay) {
  makeBar();
  const double safe = report(std::string("bar.msh") + material)["critical_step"]["safe"];
  const auto text = [&](double times) {
    return call(std::string("inspect bar.msh --step ") + test::digits(times * safe) + material).out;
  };
  EXPECT_THAT(text(50), HasSubstr("where a handler does not pay"));
  EXPECT_THAT(text(0.9), testing::Not(HasSubstr("does not pay")));
}

TEST_F(Inspect, TakesADeformedState) {
  makeBar();
  const Mesh mesh = readMesh(folder_.path() / "bar.msh");
  const Body body = bodyOf(mesh);
  NodeVectors x = mesh.X;
  x.row(0) *= 1.4;
  x.row(2) += 3 * mesh.X.row(0).array().square().matrix();
  const NodeVectors u = x - mesh.X;
  const auto values = [](const NodeVectors& v) {
    return std::span<const double>(v.data(), static_cast<std::size_t>(v.size()));
  };
  std::vector<double> scalar(mesh.nodeCount(), 1);
  const VtuField fields[] = {{"U", 3, values(u)}, {"V", 3, values(x)}, {"heat", 1, std::span<const double>(scalar)}};
  writeVtu(folder_.path() / "state.vtu", mesh, mesh.X, fields);
  const Json at = report(std::string("state.vtu --displacement U --global") + material)["critical_step"];
  EXPECT_NEAR(at["global"].get<double>() / exact(body, x), 1, 1e-8);
  EXPECT_LE(at["safe"].get<double>(), exact(body, x) * (1 + 1e-12));
  EXPECT_GE(at["optimistic"].get<double>(), exact(body, x) * (1 - 1e-12));
  EXPECT_GT(std::abs(exact(body, x) / exact(body, mesh.X) - 1), 0.1);  // the state matters
  EXPECT_THAT(call(std::string("inspect state.vtu --displacement U") + material).out,
              HasSubstr("critical step with displacement \"U\""));

  expectRefused(std::string("inspect state.vtu --displacement D") + material,
                "no field \"D\"; fields of three components at the points: \"U\", \"V\"");
  expectRefused(std::string("inspect state.vtu --displacement heat") + material, "\"heat\" has 1 components, not 3");
  expectRefused(std::string("inspect bar.msh --displacement U") + material, "read from .vtu and .vtk files");
  // The same state in VTK's legacy format, with a first node that is of no element.
  std::string legacy = fmt::format(
      "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS {} double\n", mesh.nodeCount() + 1);
  const auto rows = [&](const NodeVectors& v) {
    legacy += "9 9 9\n";
    for (Eigen::Index i = 0; i < v.cols(); ++i)
      legacy += fmt::format("{} {} {}\n", test::digits(v(0, i)), test::digits(v(1, i)), test::digits(v(2, i)));
  };
  rows(mesh.X);
  const MeshBlock& block = mesh.blocks.front();
  legacy += fmt::format("CELLS {} {}\n", block.elementCount(), 5 * block.elementCount());
  for (std::size_t e = 0; e < block.elementCount(); ++e)
    legacy += fmt::format("4 {} {} {} {}\n", block.element(e)[0] + 1, block.element(e)[1] + 1, block.element(e)[2] + 1,
                          block.element(e)[3] + 1);
  legacy += fmt::format("CELL_TYPES {}\n", block.elementCount());
  for (std::size_t e = 0; e < block.elementCount(); ++e) legacy += "10\n";
  legacy += fmt::format("POINT_DATA {}\nVECTORS U double\n", mesh.nodeCount() + 1);
  rows(u);
  folder_.write("state.vtk", legacy);
  ASSERT_EQ(block.nodesPerElement(), 4);
  EXPECT_NEAR(report(std::string("state.vtk --displacement U") + material)["critical_step"]["safe"].get<double>() /
                  at["safe"].get<double>(),
              1, 1e-12);
  expectRefused(std::string("inspect state.vtk --displacement D") + material,
                "state.vtk: no field \"D\"; fields of three components at the points: \"U\"");
  expectRefused(std::string("inspect state.vtu --displacement U --frame 1") + material, "give one of them");
}

TEST_F(Inspect, ProvesNoStepOfAnIndefiniteTangent) {
  makeBar();
  const Mesh mesh = readMesh(folder_.path() / "bar.msh");
  const NodeVectors u = Eigen::Vector3d(-0.5, 0, 0).asDiagonal() * mesh.X;
  const VtuField field{"U", 3, std::span<const double>(u.data(), static_cast<std::size_t>(u.size()))};
  writeVtu(folder_.path() / "state.vtu", mesh, mesh.X, std::span(&field, 1));
  const std::string squashed = std::string("inspect state.vtu --displacement U --prove 1e-6 --step 1e-6") + material;
  const Outcome outcome = call(squashed), asJson = call(squashed + " --json -");
  EXPECT_EQ(outcome.status, 3);
  EXPECT_EQ(parse(asJson.out)["prove"]["verdict"], "not-certified");
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("h = 1e-06 s: not proven stable (the tangent is indefinite, eigenvalue -"),
                                 HasSubstr("at h = 1e-06 s: not proven stable (the tangent is indefinite, "),
                                 HasSubstr("\n  the tangent is indefinite, eigenvalue -")));
  // Whatever else proves a bound of the highest frequency calls no step stable.
  const std::string proofs =
      std::string("inspect state.vtu --displacement U --lanczos 1e-3 --stretch 0.4:1.1") + material;
  for (const std::string& more : {std::string(" --exact --certificate a.rwc"), std::string(" --certificate a.rwc")}) {
    const std::string text = call(proofs + more).out;
    const std::string& claims = text;
    for (const char* right : {"and whose tangent is not indefinite", "safe for the highest frequency alone"})
      EXPECT_THAT(claims, HasSubstr(right));
    std::istringstream lines(claims);
    for (std::string line; std::getline(lines, line);)
      EXPECT_TRUE(line.find(" stable ") == std::string::npos || line.find("indefinite") != std::string::npos) << line;
  }
  EXPECT_EQ(parse(asJson.out)["critical_step"]["indefinite"], true);
}

TEST_F(Inspect, TakesAFrameOfARun) {
  // A part of the support is a roller, and sets and conditions name nodes.
  std::string scene(tiny);
  scene.replace(scene.find("where = \"x < 1e-6\""), 18, "set = \"x-min\"\ncomponents = \"xz\"");
  folder_.write("tiny.toml", scene);
  ASSERT_EQ(call("run tiny.toml --out r --set integrator.end=0.045").status, 0);
  const Table history = table("r/history.csv");
  const Json summary = json("r/summary.json");
  const int frames = summary["frames"];
  for (const int frame : {1, 3, 5}) {
    const std::size_t row = 10 * (frame - 1);
    const Json json = report("r --frame " + std::to_string(frame) + " --global");
    EXPECT_EQ(json["state"]["frame"], frame);
    EXPECT_NEAR(json["state"]["time"].get<double>(), history.number(row, "time_s"), 1e-12);
    EXPECT_EQ(json["mesh"]["node_sets"]["x-min"], 4);
    EXPECT_NEAR(json["mass"].get<double>(), 0.04, 1e-12);  // of the mesh at rest
    const Json& step = json["critical_step"];
    // Both brackets are those of one state: each holds the exact step.
    EXPECT_LE(history.number(row, "safe_s"), step["global"].get<double>() * (1 + 1e-9));
    EXPECT_GE(history.number(row, "optimistic_s"), step["global"].get<double>() * (1 - 1e-9));
  }
  EXPECT_GT(std::abs(report("r --frame 5 --global")["critical_step"]["global"].get<double>() /
                         report("r --frame 1 --global")["critical_step"]["global"].get<double>() -
                     1),
            1e-3);  // the state matters
  // What is given counts instead of the scene's: four times the density, half of the frequency.
  EXPECT_NEAR(report("r --frame 3 --density 4000 --global")["critical_step"]["global"].get<double>() /
                  report("r --frame 3 --global")["critical_step"]["global"].get<double>(),
              2, 1e-7);
  // The frame as a file of its own says that its points are deformed.
  const Json file = report(
      "r/frames/frame_000003.vtu --displacement displacement --fix set:x-min:xz --fix 'x > 0.1 - 1e-6' --global" +
      std::string(material));
  EXPECT_NEAR(file["critical_step"]["global"].get<double>() /
                  report("r --frame 3 --global")["critical_step"]["global"].get<double>(),
              1, 1e-9);

  const std::string outOfRange = "is out of range; r has " + std::to_string(frames) + " frames, counted from 1";
  expectRefused("inspect r --frame 99", "--frame: 99 " + outOfRange);
  expectRefused("inspect r --frame 0", "--frame: 0 " + outOfRange);
  expectRefused("inspect r", "r: is a folder; give a mesh file, or with the folder of a run --frame n");
  expectRefused("inspect tiny.toml --frame 1", "tiny.toml: is a scene; give its mesh, a deck, or");
  std::filesystem::create_directory(folder_.path() / "empty");
  expectRefused("inspect empty --frame 1", "empty/summary.json: cannot read");
  ASSERT_EQ(call("run tiny.toml --out stills --set integrator.end=0.002").status, 0);
  std::filesystem::remove(folder_.path() / "stills/run.pvd");
  expectRefused("inspect stills --frame 1", "output.every");
  folder_.write("stills/summary.json", "{}");
  expectRefused("inspect stills --frame 1", "not the summary of a run");
}

TEST_F(Inspect, TakesAFrameOfADampedRun) {
  folder_.write("tiny.toml", tiny);
  ASSERT_EQ(call("run tiny.toml --out r --set integrator.step=auto --set damping.stiffness=1e-3").status, 0);
  // The frame's bracket is the narrower one: a run begins with the proof that is enough for it.
  const Json step = report("r --frame 1")["critical_step"];
  const Table history = table("r/history.csv");
  EXPECT_NEAR(history.number(0, "optimistic_s") / step["optimistic"].get<double>(), 1, 2e-5);
  EXPECT_LE(history.number(0, "safe_s"), step["safe"].get<double>());
}

TEST_F(Inspect, HoldsSingleComponents) {
  makeBar();
  const Mesh mesh = readMesh(folder_.path() / "bar.msh");
  Body body = bodyOf(mesh);
  for (const std::int32_t node : mesh.nodeSets.at("x-min")) body.constraints().fix(node, 0);
  for (const std::int32_t node : mesh.nodeSets.at("x-max")) {
    body.constraints().fix(node, 1);
    body.constraints().fix(node, 2);
  }
  const Json json = report(std::string("bar.msh --fix 'x < 1e-6:x' --fix set:x-max:yz --global") + material);
  EXPECT_NEAR(json["critical_step"]["global"].get<double>() / exact(body, mesh.X), 1, 1e-8);
  expectRefused(std::string("inspect bar.msh --fix 'x < 1e-6:w'") + material, "\"w\" names no components");
  expectRefused(std::string("inspect bar.msh --fix 'x < 1e-6:'") + material, "names no components");
  expectRefused(std::string("inspect bar.msh --fix 'set:x-mn'") + material, "did you mean \"x-min\"?");
}

TEST_F(Inspect, TakesQuadratureRules) {
  makeBar("hex8");
  const Mesh mesh = readMesh(folder_.path() / "bar.msh");
  const double selective =
      report(std::string("bar.msh --rule hex8=selective --global") + material)["critical_step"]["global"];
  EXPECT_NEAR(selective / exact(bodyOf(mesh, {{"hex8", "selective"}}), mesh.X), 1, 1e-8);
  EXPECT_GT(std::abs(selective / exact(bodyOf(mesh), mesh.X) - 1), 1e-4);
  // The scene has the same.
  std::string scene(tiny);
  scene.replace(scene.find("density = 1000"), 14, "density = 1000\nrules = [\"hex8=selective\"]");
  folder_.write("rules.toml", scene);
  const std::string hexahedra = " --set mesh.element=hex8 --set integrator.step=auto";
  ASSERT_EQ(call("run rules.toml --out r" + hexahedra).status, 0);
  ASSERT_EQ(call("run rules.toml --out plain --set material.rules=[]" + hexahedra).status, 0);
  EXPECT_GT(std::abs(table("r/history.csv").number(0, "safe_s") / table("plain/history.csv").number(0, "safe_s") - 1),
            1e-4);
  EXPECT_NEAR(report("r --frame 1")["critical_step"]["optimistic"].get<double>() /
                  table("r/history.csv").number(0, "optimistic_s"),
              1, 1e-9);
  expectRefused(std::string("inspect bar.msh --rule hex8=selectiv") + material, "did you mean \"selective\"?");
  expectRefused(std::string("inspect bar.msh --rule hex=selective") + material, "elements are tet4, hex8");
  expectRefused(std::string("inspect bar.msh --rule selective") + material, "must be ELEMENT=RULE");
  expectRefused("run rules.toml --out n --set 'material.rules=[\"hex8=x\"]'", "material.rules: unknown rule \"x\"");
}

}  // namespace
}  // namespace ringwatch

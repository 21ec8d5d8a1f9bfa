// `ringwatch run` on several processes: its files are those of one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <ringwatch/app/command/launch.h>
#include <ringwatch/meshes/formats/file_cursor.h>
#include <ringwatch/meshes/formats/mesh_readers.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/meshes/mesh_io.h>
#include <tests/app/program.h>

namespace ringwatch {
namespace {

using test::Json;
using test::Outcome;
using ::testing::HasSubstr;

/// Two materials, motion by a table, forces of all kinds, velocities at the start and damping.
constexpr const char* rich = R"toml(
[mesh]
generate = "bar"
size = [0.1, 0.02, 0.02]
cells = [10, 2, 2]
element = "ELEMENT"
jitter = 0.1
[[material]]
where = "x < 0.05"
model = "stvk"
young = 30e3
poisson = 0.3
density = 1000
[[material]]
where = "x >= 0.05"
model = "neo-hookean"
young = 60e3
poisson = 0.4
density = 1200
[integrator]
method = "METHOD"
step = 1e-4
end = 0.02
[damping]
mass = 2
[[fix]]
where = "x < 1e-6"
[[move]]
where = "x > 0.1 - 1e-6"
components = "x"
velocity = [0.2, 0, 0]
times = [0, 0.01, 0.02]
factors = [0, 1, 0.5]
[[force]]
where = "all"
acceleration = [0, 0, -9.81]
[[force]]
where = "x > 0.04 and x < 0.06"
force = [0, 1e-3, 0]
factor = "sin(100*t)"
[[initial]]
where = "x > 0.02 and x < 0.08"
velocity = [0, 0.05, 0]
[output]
every = 0.01
fields = ["von_mises"]
picture = false
)toml";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

std::string richScene(const std::string& element = "tet4", const std::string& method = "symplectic-euler") {
  return replaced(replaced(rich, "ELEMENT", element), "METHOD", method);
}

/// What handlers take: loads and motions without tables of time.
std::string withoutTables(const std::string& scene) {
  return replaced(replaced(scene, "factor = \"sin(100*t)\"\n", ""), "times = [0, 0.01, 0.02]\nfactors = [0, 1, 0.5]\n",
                  "");
}

class RanksProgram : public test::Program {
 protected:
  static std::string mpirun(int ranks) {
    // Launchers that start and end side by side remove each other's folders of sockets where these are shared.
    return "env TMPDIR=\"$PWD\" OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 " RINGWATCH_MPIRUN " " +
           std::to_string(ranks) + " ";
  }
  /// A rank without mpirun, which takes seconds to start some.
  static constexpr int withoutLauncher = 0;
  /// As users call it; one rank is asked for, as one process is no run on ranks.
  Outcome onRanks(int ranks, const std::string& arguments, const std::string& command = "run") {
    return shell((ranks == withoutLauncher ? "" : mpirun(ranks)) + "'" RINGWATCH_PROGRAM "' " + command + " " +
                 arguments + (ranks <= 1 ? " --ranks yes" : ""));
  }
  /// What the program has said, without what mpirun says of exit statuses.
  static std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
      if (line.starts_with("ringwatch: ")) lines.push_back(line);
    return lines;
  }
  void expectRefusedByOne(int ranks, const std::string& arguments, const std::string& what) {
    SCOPED_TRACE(arguments);
    const Outcome outcome = onRanks(ranks, arguments + " --out refused");
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    const std::vector<std::string> lines = linesOf(outcome.err);
    ASSERT_EQ(lines.size(), 1u) << outcome.err;
    EXPECT_THAT(lines[0], HasSubstr(what));
    EXPECT_FALSE(exists("refused"));
  }
  /// All of summary.json but times, what ranks have sent, where it comes from and what names the program's threads.
  Json summaryOf(const std::string& folder) const {
    Json summary = json(folder + "/summary.json");
    for (const char* key : {"wall_time", "provenance", "traffic"}) summary.erase(key);
    return summary;
  }
  /// Positions at the nodes of a frame, and these less a point field, by the numbers of the nodes; of one file or of
  /// all pieces, which agree.
  std::map<std::int64_t, std::vector<double>> pointField(const std::string& frame, const std::string& name) const {
    std::vector<std::filesystem::path> files{folder_.path() / frame};
    if (std::filesystem::is_directory(files[0])) {
      const std::filesystem::path folder = files[0];
      files.clear();
      for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
    }
    std::map<std::int64_t, std::vector<double>> found;
    for (const std::filesystem::path& file : files) {
      const MeshState read = detail::readVtuState(file, detail::readWholeFile(file), name, nullptr);
      for (std::size_t i = 0; i < read.mesh.nodeCount(); ++i) {
        const auto column = static_cast<Eigen::Index>(i);
        std::vector<double> values;
        for (int c = 0; c < 3; ++c) values.insert(values.end(), {read.x(c, column), read.mesh.X(c, column)});
        const auto [at, fresh] = found.emplace(read.mesh.nodeId(i), values);
        EXPECT_TRUE(fresh || at->second == values) << "node " << read.mesh.nodeId(i);
      }
    }
    return found;
  }
};

/// Every file is the same for any number of ranks; positions and velocities are those of one process, to the last bit.
TEST_F(RanksProgram, WritesWhatOneProcessWrites) {
  for (const auto& [element, method] :
       {std::pair{"tet4", "symplectic-euler"}, {"hex8", "verlet"}, {"tet10", "symplectic-euler"}}) {
    SCOPED_TRACE(std::string(element) + ", " + method);
    folder_.write("scene.toml", richScene(element, method));
    ASSERT_EQ(call("run scene.toml --out alone").status, 0);
    const Table alone = table("alone/history.csv");
    std::string first;
    for (const int ranks : {1, 2, 3, 4}) {
      SCOPED_TRACE(std::to_string(ranks) + " ranks");
      const std::string out = "on" + std::to_string(ranks);
      const Outcome outcome = onRanks(ranks, "scene.toml --out " + out + " --threads " + std::to_string(1 + ranks % 2));
      ASSERT_EQ(outcome.status, 0) << outcome.err;
      const std::string history = folder_.read(out + "/history.csv");
      if (ranks == 1) first = history;
      EXPECT_EQ(history, first);
      EXPECT_EQ(summaryOf(out), summaryOf("on1"));
    }
    const Table on = table("on3/history.csv");
    ASSERT_EQ(on.rows.size(), alone.rows.size());
    double largest = 0;
    for (std::size_t row = 0; row < on.rows.size(); ++row) largest = std::max(largest, on.number(row, "strain_J"));
    for (std::size_t row = 0; row < on.rows.size(); ++row) {
      for (const char* column : {"step", "time_s", "h_s", "verdict"})
        EXPECT_EQ(on.at(row, column), alone.at(row, column)) << row;
      for (const char* column : {"kinetic_J", "strain_J", "external_work_J", "dissipated_J", "balance_error_J"})
        EXPECT_NEAR(on.number(row, column), alone.number(row, column), 5e-14 * largest) << column << ", row " << row;
      // Both brackets hold the critical step.
      EXPECT_LE(on.number(row, "safe_s"), alone.number(row, "optimistic_s"));
      EXPECT_LE(alone.number(row, "safe_s"), on.number(row, "optimistic_s"));
    }
    EXPECT_EQ(json("on3/summary.json")["frames"], json("alone/summary.json")["frames"]);
    for (const std::string frame : {"frame_000001", "frame_000002", "frame_000003"})
      for (const char* field : {"displacement", "velocity"}) {
        const auto alike = pointField("alone/frames/" + frame + ".vtu", field);
        EXPECT_EQ(alike.size(), json("alone/summary.json")["mesh"]["nodes"]);
        EXPECT_TRUE(pointField("on3/frames/" + frame, field) == alike) << frame << ", " << field;
        EXPECT_TRUE(pointField("on1/frames/" + frame, field) == alike) << frame << ", " << field;
      }
    EXPECT_TRUE(exists("on3/frames/frame_000003.pvtu"));
    EXPECT_FALSE(exists("on3/frames/frame_000004.pvtu"));
    EXPECT_THAT(folder_.read("on3/run.pvd"), HasSubstr("frames/frame_000003.pvtu"));
    expectNothingHalfWritten("on3");
  }
}

/// What takes more than one acceleration a step, and what takes velocities or states of ghosts.
TEST_F(RanksProgram, SharesStagesAndGhosts) {
  folder_.write("timed.toml", richScene());
  folder_.write("free.toml", replaced(withoutTables(richScene()), "[damping]\nmass = 2\n", ""));
  for (const auto& [arguments, frames] :
       {std::pair<std::string, int>{"free.toml --set integrator.method=rk4 --out ", 3},
        {"free.toml --set integrator.method=yoshida4 --out ", 3},
        {"timed.toml --set damping.stiffness=1e-5 --set output.exact_times=true --set output.every=0.00733 --out ", 4},
        {"timed.toml --set monitor.bracket=false --out ", 3}}) {
    SCOPED_TRACE(arguments);
    for (const char* folder : {"alone", "on3"}) std::filesystem::remove_all(folder_.path() / folder);
    ASSERT_EQ(call("run " + arguments + "alone").status, 0);
    const Outcome outcome = onRanks(3, arguments + "on3");
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(json("on3/summary.json")["frames"], frames);
    EXPECT_EQ(folder_.read("on3/run.pvd"), replaced(folder_.read("alone/run.pvd"), ".vtu", ".pvtu"));
    for (int frame = 1; frame <= frames; ++frame)
      for (const char* field : {"displacement", "velocity"}) {
        const std::string name = "/frames/frame_00000" + std::to_string(frame);
        EXPECT_TRUE(pointField("on3" + name, field) == pointField("alone" + name + ".vtu", field)) << name << field;
      }
    const Table alone = table("alone/history.csv"), on = table("on3/history.csv");
    ASSERT_EQ(on.rows.size(), alone.rows.size());
    const std::size_t last = on.rows.size() - 1;
    for (const char* column : {"kinetic_J", "strain_J", "external_work_J", "dissipated_J"})
      EXPECT_NEAR(on.number(last, column), alone.number(last, column), 1e-12 * on.number(last, "strain_J")) << column;
    EXPECT_EQ(on.number(last, "time_s"), alone.number(last, "time_s"));
  }
}

TEST_F(RanksProgram, ChoosesItsSteps) {
  folder_.write("scene.toml", richScene());
  for (const std::string& settings :
       {std::string("--set integrator.step=auto --set monitor.every=3"),
        std::string("--set integrator.step=2e-3 --set monitor.on_violation=reduce-step --set monitor.every=4"),
        std::string("--set monitor.mode=threshold")}) {
    SCOPED_TRACE(settings);
    ASSERT_EQ(onRanks(1, "scene.toml --out one " + settings).status, 0);
    ASSERT_EQ(onRanks(3, "scene.toml --out three " + settings).status, 0);
    EXPECT_EQ(folder_.read("one/history.csv"), folder_.read("three/history.csv"));
    EXPECT_EQ(summaryOf("one"), summaryOf("three"));
    EXPECT_EQ(json("three/summary.json")["verdict"], "certified");
  }
}

/// Mass scaling adds what it adds on one process, and its steps are the same until one is divided. Where the elements
/// stiffen, all ranks divide steps alike.
TEST_F(RanksProgram, ScalesMass) {
  for (const auto& [element, method] : {std::pair{"tet4", "symplectic-euler"}, {"hex8", "verlet"}}) {
    SCOPED_TRACE(element);
    const std::string scene = withoutTables(richScene(element, method));
    folder_.write("mild.toml", scene);
    folder_.write("hard.toml", replaced(scene, "velocity = [0.2, 0, 0]", "velocity = [2, 0, 0]"));
    const std::string settings =
        " --set handler.method=mass-scaling --set handler.margin=0.02 --set monitor.on_violation=handle "
        "--set integrator.step=1.2e-3 --set output.every=0.005";
    ASSERT_EQ(call("run mild.toml --out alone" + settings).status, 0);
    for (const bool mild : {true, false}) {
      SCOPED_TRACE(mild ? "mild" : "hard");
      Json first;
      for (const int ranks : {1, 2, 4}) {
        const std::string out = "on" + std::to_string(ranks);
        const Outcome outcome = onRanks(ranks, std::string(mild ? "mild" : "hard") + ".toml --out " + out + settings);
        ASSERT_EQ(outcome.status, 0) << outcome.err << outcome.out;
        if (ranks == 1) first = summaryOf("on1");
        EXPECT_EQ(summaryOf(out), first) << ranks;
        EXPECT_EQ(folder_.read(out + "/history.csv"), folder_.read("on1/history.csv")) << ranks;
      }
      EXPECT_GT(first["handler"]["added_mass_kg"], 0);
      EXPECT_EQ(first["verdict"], "certified");
      if (!mild) {
        EXPECT_GT(first["handler"]["divided_steps"], 0);
        continue;
      }
      EXPECT_EQ(first["handler"]["divided_steps"], 0);
      EXPECT_EQ(first["handler"], json("alone/summary.json")["handler"]);
      EXPECT_EQ(first["mass"], json("alone/summary.json")["mass"]);
      for (const char* field : {"displacement", "velocity"})
        EXPECT_TRUE(pointField("on4/frames/frame_000004", field) == pointField("alone/frames/frame_000004.vtu", field))
            << field;
    }
  }
}

/// imex takes the elements that it takes on one process, and each of its clusters is solved by one rank: positions are
/// those of one process, also where angular momentum is kept, and all ranks end where one cluster cannot be solved.
TEST_F(RanksProgram, SolvesHandledElements) {
  const std::string scene = replaced(
      replaced(replaced(withoutTables(rich), "[damping]\nmass = 2\n", ""), "cells = [10, 2, 2]", "cells = [10, 3, 3]"),
      "jitter = 0.1", "jitter = 0.3");
  const auto with = [&](const std::string& element, const std::string& method) {
    return replaced(replaced(scene, "ELEMENT", element), "METHOD", method);
  };
  folder_.write("tets.toml", with("tet4", "symplectic-euler"));
  folder_.write("hexes.toml", with("hex8", "verlet"));
  std::string spinning = with("tet4", "symplectic-euler");
  spinning.erase(spinning.find("[[fix]]"), spinning.find("[output]") - spinning.find("[[fix]]"));
  folder_.write("spinning.toml", spinning + "[[initial]]\nwhere = \"all\"\nangular_velocity = [0, 0, 20]\n");
  const std::string imex = " --set handler.method=imex --set monitor.on_violation=warn --set output.every=0.005 ";
  for (const auto& [name, step, clusters, verdict] : {std::tuple{"tets", "4e-4", 2, "certified"},
                                                      {"hexes", "5e-4", 5, "certified"},
                                                      {"spinning", "4e-4", 2, "not-certified"}}) {
    SCOPED_TRACE(name);
    const std::string arguments = std::string(name) + ".toml" + imex + "--set integrator.step=" + step;
    ASSERT_EQ(call("run " + arguments + " --out alone").status, 0);
    const Json alone = json("alone/summary.json");
    EXPECT_GE(alone["handler"]["clusters"], clusters);
    Json first;
    for (const int ranks : {1, 2, 4}) {
      SCOPED_TRACE(ranks);
      const std::string out = "on" + std::to_string(ranks);
      const Outcome outcome =
          onRanks(ranks, arguments + " --out " + out + " --threads " + std::to_string(1 + ranks % 2));
      ASSERT_EQ(outcome.status, 0) << outcome.err << outcome.out;
      if (ranks == 1) first = summaryOf("on1");
      EXPECT_EQ(summaryOf(out), first);
      EXPECT_EQ(folder_.read(out + "/history.csv"), folder_.read("on1/history.csv"));
    }
    EXPECT_EQ(first["handler"], alone["handler"]);
    EXPECT_EQ(first["verdict"], verdict);
    for (const char* field : {"displacement", "velocity"})
      EXPECT_TRUE(pointField("on4/frames/frame_000004", field) == pointField("alone/frames/frame_000004.vtu", field))
          << field;
    const Table one = table("alone/history.csv"), four = table("on4/history.csv");
    ASSERT_EQ(one.rows.size(), four.rows.size());
    double largest = 0;
    for (std::size_t row = 0; row < one.rows.size(); ++row) largest = std::max(largest, one.number(row, "kinetic_J"));
    for (std::size_t row = 0; row < one.rows.size(); ++row)
      for (const char* column : {"kinetic_J", "strain_J", "external_work_J", "dissipated_J", "balance_error_J"})
        EXPECT_NEAR(one.number(row, column), four.number(row, column), 5e-14 * largest) << column << ", row " << row;
  }
  // Crushed, until elements have no energy.
  folder_.write("crushed.toml", replaced(with("tet4", "symplectic-euler"), "[0.2, 0, 0]", "[-8, 0, 0]"));
  const std::string arguments = "crushed.toml" + imex + "--set integrator.step=4e-4";
  for (const char* folder : {"alone", "on1", "on3"}) std::filesystem::remove_all(folder_.path() / folder);
  ASSERT_EQ(call("run " + arguments + " --out alone").status, 1);
  for (const int ranks : {1, 3}) EXPECT_EQ(onRanks(ranks, arguments + " --out on" + std::to_string(ranks)).status, 1);
  const Json alone = json("alone/summary.json"), three = summaryOf("on3");
  EXPECT_EQ(three, summaryOf("on1"));
  EXPECT_EQ(three["exit_reason"], "step-failed");
  for (const char* key : {"exit_reason", "exit_text", "steps"}) EXPECT_EQ(three[key], alone[key]);
}

/// The bracket of a mesh and the element that holds it down are those of one rank, and hold the critical step.
TEST_F(RanksProgram, Inspects) {
  BarOptions options;
  options.cells = {8, 3, 3};
  options.element = "tet4";
  options.jitter = 0.2;
  writeMesh(generateBar(options), folder_.path() / "bar.msh");
  const std::string arguments = "bar.msh --young 1e6 --poisson 0.3 --density 1000 --fix 'x < 1e-6'";
  ASSERT_EQ(call("inspect " + arguments + " --global --json alone.json").status, 0);
  const double exact = json("alone.json")["critical_step"]["global"];
  for (const int ranks : {1, 2, 3, 4}) {
    SCOPED_TRACE(ranks);
    const std::string file = "on" + std::to_string(ranks) + ".json";
    const Outcome outcome = onRanks(ranks, arguments + " --json " + file, "inspect");
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(folder_.read(file), folder_.read("on1.json"));
    EXPECT_THAT(outcome.out, HasSubstr("controlling element"));
    const Json found = json(file);
    EXPECT_LE(found["critical_step"]["safe"], exact);
    EXPECT_GE(found["critical_step"]["optimistic"], exact);
    EXPECT_GE(found["critical_step"]["safe"], 0.8 * exact);
    EXPECT_LE(found["critical_step"]["optimistic"], 1.01 * exact);
    EXPECT_EQ(found["mesh"], json("alone.json")["mesh"]);
    EXPECT_EQ(found["quality"], json("alone.json")["quality"]);
    const Outcome asked = onRanks(ranks, arguments + " --global --json global.json", "inspect");
    ASSERT_EQ(asked.status, 0) << asked.err;
    EXPECT_EQ(json("global.json")["critical_step"]["global"].get<double>(), exact);  // the same bits
    EXPECT_THAT(asked.out, HasSubstr("the exact value"));
  }
  for (const auto& [more, what] :
       {std::pair{"--metric all", "--metric: is not distributed over ranks"}, {"--fix 'y <'", "--fix"}}) {
    const Outcome refused = onRanks(2, arguments + " " + more, "inspect");
    EXPECT_EQ(refused.status, 2);
    ASSERT_EQ(linesOf(refused.err).size(), 1u) << refused.err;
    EXPECT_THAT(refused.err, HasSubstr(what));
  }
  EXPECT_EQ(onRanks(2, "missing.msh --young 1e6 --poisson 0.3 --density 1000", "inspect").status, 2);
}

/// Replaces the last place in a file's bytes that has a raw value, or the first behind the counts of nodes.
template <class T>
std::string patched(std::string bytes, T from, T to, bool last) {
  const std::string old(reinterpret_cast<const char*>(&from), sizeof from);
  const std::size_t at = last ? bytes.rfind(old) : bytes.find(old, bytes.find("$Nodes") + sizeof "$Nodes" + 32);
  EXPECT_NE(at, std::string::npos);
  return at == std::string::npos ? bytes : bytes.replace(at, sizeof to, reinterpret_cast<const char*>(&to), sizeof to);
}

/// A bar of all linear elements in a few entities of the file, with node numbers in no order and far apart.
Mesh shuffledMesh() {
  BarOptions options;
  options.size = {0.1, 0.04, 0.03};
  options.cells = {8, 3, 3};
  options.jitter = 0.1;
  Mesh mesh = generateMixedBar(options);
  constexpr std::int64_t prime = 7919;  // more than there are nodes
  mesh.nodeIds.clear();
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(mesh.nodeCount()); ++i)
    mesh.nodeIds.push_back(100 + 1000 * ((i * 3571) % prime));
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
    for (std::size_t e = 0; e < mesh.blocks[b].elementCount(); ++e)
      if (e % 7 < 3) mesh.elementSets["striped"].push_back({b, e});
  return mesh;
}

/// A mesh in MSH 4.1 binary is read in parts: what is said is the same for any number of ranks, and has the bracket and
/// the controlling element of ranks that each hold the whole body, to the last bit.
TEST_F(RanksProgram, InspectsInParts) {
  const std::string law = " --young 1e6 --poisson 0.3 --density 1000 ";
  BarOptions bar;
  bar.cells = {6, 5, 4};
  bar.jitter = 0.2;
  const Mesh tetrahedra = generateBar(bar);
  bar.element = "hex20";
  bar.jitter = 0;
  const Mesh curved = generateBar(bar);
  bar.cells = {1, 1, 1};
  bar.element = "hex8";
  const Mesh single = generateBar(bar);
  Mesh mended = tetrahedra;  // all turned round, and with nodes that no element has
  for (std::size_t i = 0; i < mended.blocks[0].connectivity.size(); i += 4)
    std::swap(mended.blocks[0].connectivity[i], mended.blocks[0].connectivity[i + 1]);
  mended.X.conservativeResize(3, mended.X.cols() + 2);
  mended.X.rightCols(2).setConstant(0.5);
  mended.nodeIds.clear();
  const auto add = [](Mesh& mesh, const NodeVectors& X, std::int64_t shift) {
    const Mesh other = shuffledMesh();
    const auto nodes = static_cast<std::int32_t>(mesh.X.cols());
    mesh.X.conservativeResize(3, nodes + X.cols());
    mesh.X.rightCols(X.cols()) = X;
    for (const std::int64_t id : other.nodeIds) mesh.nodeIds.push_back(id + shift);
    for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
      for (const std::int32_t node : other.blocks[b].connectivity) mesh.blocks[b].connectivity.push_back(node + nodes);
      mesh.blocks[b].ids.clear();
    }
  };
  Mesh apart = shuffledMesh();  // two bars side by side, whose nodes meet without being joined
  add(apart, apart.X.colwise() + Eigen::Vector3d(0, 0.04, 0), 7);
  // The same by less than a thousandth of their edges, and a bar of far shorter ones.
  Mesh sizes = shuffledMesh();
  add(sizes, sizes.X.colwise() + Eigen::Vector3d(0, 0.04 + 1e-6, 0), 7);
  add(sizes, (1e-5 * shuffledMesh().X).colwise() + Eigen::Vector3d(0, 0.2, 0), 11);
  struct Case {
    const char* name;
    const Mesh& mesh;
    std::string options;
    const char* note;
  };
  const Mesh shuffled = shuffledMesh();
  for (const Case& one :
       {Case{"shuffled", shuffled, "--fix 'x < 1e-6' --fix set:x-max:yz", ""},
        Case{"tetrahedra", tetrahedra, "--model neo-hookean --fix 'set:#3,40' --fix set:z-max:x", ""},
        Case{"curved", curved, "--lumping diagonal-scaling --rule hex20=gauss-3x3x3", ""}, Case{"one", single, "", ""},
        Case{"mended", mended, "", "2 nodes that no element uses are dropped"},
        Case{"apart", apart, "", "the mesh falls into 2 parts"},
        Case{"sizes", sizes, "", "nodes lie closer than a thousandth of an edge to another"}}) {
    SCOPED_TRACE(one.name);
    const std::string text = std::string(one.name) + ".msh", binary = std::string(one.name) + "_binary.msh";
    writeMesh(one.mesh, folder_.path() / text, MeshFormat::msh41);
    writeMesh(one.mesh, folder_.path() / binary, MeshFormat::msh41Binary);
    ASSERT_EQ(onRanks(3, text + law + one.options + " --json whole.json", "inspect").status, 0);
    const Outcome alone = call("inspect " + binary + law + one.options + " --exact --json alone.json");
    ASSERT_EQ(alone.status, 0) << alone.err;
    EXPECT_THAT(alone.out, HasSubstr(one.note));
    const Json whole = json("whole.json"), exact = json("alone.json")["critical_step"]["exact"];
    std::string said;
    for (const int ranks : {1, 2, 3, 4}) {
      SCOPED_TRACE(ranks);
      const std::string file = "on" + std::to_string(ranks) + ".json";
      const Outcome outcome = onRanks(ranks, binary + law + one.options + " --json " + file, "inspect");
      ASSERT_EQ(outcome.status, 0) << outcome.err;
      EXPECT_THAT(outcome.out, HasSubstr(one.note));
      if (ranks == 1) said = outcome.out;
      EXPECT_EQ(folder_.read(file), folder_.read("on1.json"));
      EXPECT_EQ(replaced(outcome.out, file, "on1.json"), said);
    }
    Json found = json("on4.json");
    EXPECT_EQ(found["critical_step"], whole["critical_step"]);
    EXPECT_EQ(found["controlling_element"], whole["controlling_element"]);
    EXPECT_EQ(found["state"], whole["state"]);
    EXPECT_LE(found["critical_step"]["safe"].get<double>(), exact["optimistic"].get<double>());
    EXPECT_GE(found["critical_step"]["optimistic"].get<double>(), exact["safe"].get<double>());
    // Sums in another order.
    Json other = json("alone.json");
    for (Json* numbers : {&found, &other}) {
      (*numbers)["mass"] = std::round((*numbers)["mass"].get<double>() * 1e9) * 1e-9;
      (*numbers)["mesh"]["volume"] = std::round((*numbers)["mesh"]["volume"].get<double>() * 1e12) * 1e-12;
      for (auto& [name, measure] : (*numbers)["quality"].items()) {
        EXPECT_NEAR(measure["mean"].get<double>(), json("alone.json")["quality"][name]["mean"].get<double>(),
                    1e-13 * std::abs(measure["mean"].get<double>()));
        measure.erase("mean");
      }
    }
    EXPECT_EQ(found["mass"], other["mass"]);
    EXPECT_EQ(found["mesh"], other["mesh"]);
    EXPECT_EQ(found["quality"], other["quality"]);
    // The notes and the lines of sets and quality are those of one process.
    const auto head = [](const std::string& all) { return all.substr(0, all.find("critical step")); };
    EXPECT_EQ(head(said), head(alone.out));
  }
  // The command writes such files.
  ASSERT_EQ(call("mesh convert tetrahedra.msh converted.msh --binary").status, 0);
  EXPECT_EQ(folder_.read("converted.msh"), folder_.read("tetrahedra_binary.msh"));
  test::Program::expectRefused("mesh convert tetrahedra.msh converted.vtu --binary", "--binary");
  // The exact value takes the whole body.
  ASSERT_EQ(call("inspect tetrahedra_binary.msh" + law + "--global --json alone.json").status, 0);
  const Outcome global = onRanks(2, "tetrahedra_binary.msh" + law + "--global --json global.json", "inspect");
  ASSERT_EQ(global.status, 0) << global.err;
  EXPECT_EQ(json("global.json")["critical_step"]["global"], json("alone.json")["critical_step"]["global"]);
}

/// What is wrong with a mesh that is read in parts is one line, that of one process.
TEST_F(RanksProgram, RefusesABadMeshInParts) {
  const std::string law = " --young 1e6 --poisson 0.3 --density 1000 ";
  Mesh mesh = shuffledMesh();
  constexpr std::int64_t rare = 123456789;
  mesh.nodeIds.back() = rare;
  mesh.nodeSets.clear();
  const double last = mesh.X(2, mesh.X.cols() - 1);
  const auto write = [&](const Mesh& written, const char* name) {
    writeMesh(written, folder_.path() / name, MeshFormat::msh41Binary);
    return folder_.read(name);
  };
  const std::string good = write(mesh, "good.msh");
  folder_.write("unknown.msh", patched<std::int64_t>(good, rare, 5, true));
  folder_.write("repeated.msh", patched<std::int64_t>(good, rare, mesh.nodeIds[4], false));
  folder_.write("negative.msh", patched<std::int64_t>(good, rare, -3, false));
  folder_.write("infinite.msh", patched<double>(good, last, std::numeric_limits<double>::infinity(), false));
  folder_.write("cut_nodes.msh", good.substr(0, good.find("$Nodes") + 300));
  folder_.write("cut_elements.msh", good.substr(0, good.size() - 60));
  folder_.write("no_elements.msh", good.substr(0, good.find("$Elements")));
  folder_.write("no_end.msh", good.substr(0, good.find("$EndElements")));
  Mesh bad = mesh;
  bad.blocks[0].connectivity[1] = bad.blocks[0].connectivity[0];
  write(bad, "collapsed.msh");
  bad = mesh;
  bad.X.col(bad.X.cols() / 2).array() += 10;  // elements around it lie on each other
  write(bad, "folded.msh");
  bad = mesh;
  for (int a = 0; a < bad.blocks[0].nodesPerElement(); ++a)
    bad.blocks[0].connectivity.push_back(bad.blocks[0].connectivity[static_cast<std::size_t>(a)]);
  if (!bad.blocks[0].ids.empty()) bad.blocks[0].ids.push_back(99999);
  write(bad, "double.msh");
  const auto expectRefused = [&](const std::string& arguments, bool sameWords) {
    const Outcome alone = call("inspect " + arguments);
    ASSERT_EQ(alone.status, 2) << arguments;
    SCOPED_TRACE(arguments);
    const Outcome outcome = onRanks(3, arguments, "inspect");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.out, "");
    const std::vector<std::string> lines = linesOf(outcome.err);
    ASSERT_EQ(lines.size(), 1u) << outcome.err;
    if (sameWords) {
      EXPECT_EQ(lines, linesOf(alone.err));
    }
  };
  for (const char* name :
       {"unknown", "repeated", "negative", "infinite", "no_elements", "no_end", "collapsed", "folded", "double"})
    expectRefused(std::string(name) + ".msh" + law, true);
  // The places differ: what of a list is missing, and that it is cut short.
  for (const char* name : {"cut_nodes", "cut_elements"}) expectRefused(std::string(name) + ".msh" + law, false);
  for (const char* fix : {"'y > 7'", "set:none", "'set:#5'", "'set:#x'", "'y <'", "'sqrt(-1 - x) < 2'"})
    expectRefused("good.msh" + law + "--fix " + fix, true);
  expectRefused("good.msh --young 1e6 --poisson 0.3", true);
  expectRefused("good.msh --young 1e6 --poisson 0.7 --density 1000", true);
  const Outcome refused = onRanks(2, "good.msh" + law + "--metric all", "inspect");
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.err, HasSubstr("--metric: is not distributed over ranks"));
}

/// The exchange is counted: what the model says of the steps, and more for the monitor and the frames.
TEST_F(RanksProgram, CountsItsTraffic) {
  folder_.write("scene.toml", richScene());
  ASSERT_EQ(onRanks(3, "scene.toml --out three").status, 0);
  const Json traffic = json("three/summary.json")["traffic"];
  EXPECT_EQ(traffic["ranks"], 3);
  EXPECT_GT(traffic["bytes_by_model"], 0);
  EXPECT_GE(traffic["bytes"], traffic["bytes_by_model"]);
  EXPECT_GE(traffic["exchanges"], json("three/summary.json")["steps"]);
  EXPECT_GE(traffic["hidden"], 0);
  EXPECT_LE(traffic["hidden"], 1);
  ASSERT_EQ(call("run scene.toml --out alone").status, 0);
  EXPECT_TRUE(json("alone/summary.json")["traffic"].is_null());
}

/// All ranks end with one status, and events name the elements of the mesh.
TEST_F(RanksProgram, TellsOfAnUnstableStep) {
  folder_.write("scene.toml", richScene());
  const std::string settings = "--set integrator.step=2.5e-3 ";
  EXPECT_EQ(call("run scene.toml --out alone " + settings).status, 1);
  const Outcome outcome = onRanks(3, "scene.toml --out three " + settings);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr("verdict violated"));
  const Json alone = json("alone/summary.json"), three = json("three/summary.json");
  ASSERT_FALSE(three["events"].empty());
  EXPECT_EQ(three["events"][0]["kind"], "violated");
  EXPECT_EQ(three["events"][0]["step"], alone["events"][0]["step"]);
  EXPECT_EQ(three["first_violated"], alone["first_violated"]);
  EXPECT_TRUE(three["events"][0]["element"]["id"].is_number());
  EXPECT_TRUE(three["events"][0]["cause"].is_string());
  if (three["events"][0]["element"] == alone["events"][0]["element"]) {
    EXPECT_EQ(three["events"][0]["cause"], alone["events"][0]["cause"]);
  }
  EXPECT_EQ(onRanks(1, "scene.toml --out one " + settings).status, 1);
  EXPECT_EQ(summaryOf("one"), summaryOf("three"));
  // Gone on with, it ends where positions are no longer numbers, or its energy ran away.
  const std::string on = settings + "--set monitor.on_violation=warn --set integrator.end=0.5";
  EXPECT_EQ(onRanks(1, "scene.toml --out one " + on).status, 1);
  EXPECT_EQ(onRanks(4, "scene.toml --out four " + on).status, 1);
  EXPECT_EQ(summaryOf("one"), summaryOf("four"));
  EXPECT_EQ(folder_.read("one/history.csv"), folder_.read("four/history.csv"));
}

/// A bar that is pressed together has directions of negative stiffness, which ranks find as one process does.
TEST_F(RanksProgram, TellsOfIndefiniteTangents) {
  folder_.write("scene.toml", replaced(withoutTables(richScene()), "velocity = [0.2, 0, 0]", "velocity = [-3, 0, 0]"));
  const std::string settings = " --set monitor.on_violation=warn";
  ASSERT_EQ(call("run scene.toml --out alone" + settings).status,
            onRanks(3, "scene.toml --out three" + settings).status);
  const auto tells = [&](const std::string& folder) {
    return std::ranges::any_of(json(folder + "/summary.json")["events"], [](const Json& event) {
      return event["kind"] == "indefinite" && event["value"] < 0 && event["cause"].is_string();
    });
  };
  EXPECT_TRUE(tells("alone"));
  EXPECT_TRUE(tells("three"));
  onRanks(1, "scene.toml --out one" + settings);
  EXPECT_EQ(summaryOf("one"), summaryOf("three"));
}

TEST_F(RanksProgram, RefusesByOneLine) {
  const std::string plain = withoutTables(richScene());
  folder_.write("scene.toml", replaced(plain, "[damping]\nmass = 2\n", ""));
  expectRefusedByOne(2, "scene.toml --set integrator.method=implicit-euler",
                     "a run on ranks takes no \"implicit-euler\"");
  for (const auto& [setting, what] :
       {std::pair{"handler.method=fe-pbd", "a run on ranks takes no \"fe-pbd\""},
        {"handler.method=imex --set integrator.step=0.02", "takes every element"},
        {"handler.method=imex --set material.0.model=linear --set material.1.model=linear",
         "handler.solver = \"newton\""},
        {"output.reactions=true", "takes no reactions"},
        {"integrator.step=-1", "integrator.step"}})
    expectRefusedByOne(withoutLauncher, "scene.toml --set '" + replaced(setting, " --set ", "' --set '") + "'", what);
  expectRefusedByOne(3, "missing.toml", "missing.toml");
  expectRefusedByOne(2, "scene.toml --live", "--live");
  expectRefusedByOne(2, "scene.toml --treads 3", "--treads");
  // The first step of "auto" is only known when the run has begun.
  folder_.write("long.toml", replaced(plain, "every = 0.01\n", ""));
  expectRefusedByOne(2, "long.toml --set integrator.step=auto --set integrator.end=1e12", "\"auto\" begins with");
  // No folder for frames, and then a disk that is full while the run goes on.
  folder_.write("scene.toml", plain);
  ASSERT_EQ(shell("mkdir full && touch full/frames").status, 0);
  Outcome outcome = onRanks(3, "scene.toml --out full");
  EXPECT_EQ(outcome.status, 2);
  ASSERT_EQ(linesOf(outcome.err).size(), 1u) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("full/frames: cannot write"));
  ASSERT_EQ(shell("mkdir -p late/frames/frame_000002.pvtu/occupied").status, 0);
  outcome = onRanks(3, "scene.toml --out late --set output.every=0.005");
  EXPECT_NE(outcome.status, 0);
  ASSERT_EQ(linesOf(outcome.err).size(), 1u) << outcome.err;
  EXPECT_THAT(linesOf(outcome.err)[0], HasSubstr("rank 0 of 3"));
  // What another run holds.
  ASSERT_EQ(shell("mkdir held && exec 9> held/run.lock && flock 9 && " + mpirun(2) +
                  "'" RINGWATCH_PROGRAM "' run scene.toml --out held")
                .status,
            2);
  EXPECT_EQ(linesOf(folder_.read("err.txt")).size(), 1u);
}

/// A run that is stopped and gone on with, on another number of ranks, is the one that was not.
TEST_F(RanksProgram, GoesOnWithAnyNumberOfRanks) {
  folder_.write("scene.toml", richScene("tet4", "verlet"));
  const std::string settings = " --set integrator.end=0.1 --set output.checkpoint_every=0.011 ";
  ASSERT_EQ(onRanks(2, "scene.toml --out whole" + settings).status, 0);
  EXPECT_FALSE(exists("whole/checkpoint.bin"));
  // One rank is killed once there is a checkpoint: all end, and mpirun says which.
  const Outcome killed = shell(mpirun(3) + "'" RINGWATCH_PROGRAM "' run scene.toml --out part" + settings +
                               " & launcher=$!; until test -e part/run.lock; do sleep 0.002; done; "
                               "for process in /proc/[0-9]*; do "
                               "if grep -qs \"^PPid:.$launcher$\" $process/status; then last=${process#/proc/}; fi; "
                               "done; until test -e part/checkpoint.bin; do sleep 0.002; done; kill -KILL $last; date "
                               "+%s > killed; wait $launcher; status=$?; date +%s > ended; "
                               "exit $status");
  EXPECT_NE(killed.status, 0);
  EXPECT_THAT(killed.err, HasSubstr("noticed that process rank"));
  EXPECT_LE(std::stoll(folder_.read("ended")) - std::stoll(folder_.read("killed")), 10);
  ASSERT_TRUE(exists("part/checkpoint.bin"));
  EXPECT_FALSE(exists("part/summary.json"));
  test::Program::expectRefused("run --resume part", "on several ranks");
  const Outcome resumed = onRanks(2, "--resume part --threads 2");
  ASSERT_EQ(resumed.status, 0) << resumed.err;
  EXPECT_EQ(folder_.read("part/history.csv"), folder_.read("whole/history.csv"));
  EXPECT_EQ(summaryOf("part"), summaryOf("whole"));
  for (const char* field : {"displacement", "velocity"})
    EXPECT_TRUE(pointField("part/frames/frame_000008", field) == pointField("whole/frames/frame_000008", field));
  EXPECT_FALSE(exists("part/checkpoint.bin"));
}

/// A signal to one rank ends all of them behind the same step; positions go on with the same bits.
TEST_F(RanksProgram, EndsBySignal) {
  folder_.write("scene.toml", richScene());
  const std::string settings = " --set integrator.end=0.4 --set output.history_every=10 ";
  ASSERT_EQ(onRanks(1, "scene.toml --out whole" + settings).status, 0);
  const auto stop = [&] {
    return shell(
        "rm -rf part; " + mpirun(3) + "'" RINGWATCH_PROGRAM "' run scene.toml --out part" + settings +
        " & launcher=$!; while kill -0 $launcher 2>/dev/null && ! test -s part/history.csv; do sleep 0.01; done; "
        "last=$launcher; for process in /proc/[0-9]*; do "
        "if grep -qs \"^PPid:.$launcher$\" $process/status; then last=${process#/proc/}; fi; "
        "done; kill -TERM $last; wait $launcher");
  };
  // A run that ended before its signal came is tried again.
  Outcome stopped = stop();
  for (int tries = 1; tries < 10 && !exists("part/checkpoint.bin"); ++tries) stopped = stop();
  ASSERT_EQ(stopped.status, 4) << stopped.err;
  EXPECT_THAT(stopped.out, HasSubstr("goes on from here"));
  EXPECT_EQ(json("part/summary.json")["exit_reason"], "interrupted");
  ASSERT_EQ(onRanks(2, "--resume part").status, 0);
  const Table whole = table("whole/history.csv"), part = table("part/history.csv");
  ASSERT_EQ(whole.rows.size(), part.rows.size());
  for (std::size_t row = 0; row < whole.rows.size(); ++row)
    for (const char* column : {"step", "time_s", "h_s", "verdict", "kinetic_J", "strain_J"})
      EXPECT_EQ(whole.at(row, column), part.at(row, column)) << row;
  const int last = json("whole/summary.json")["frames"];
  char frame[40];
  std::snprintf(frame, sizeof frame, "/frames/frame_%06d", last);
  EXPECT_TRUE(pointField("part" + std::string(frame), "displacement") ==
              pointField("whole" + std::string(frame), "displacement"));
}

TEST_F(RanksProgram, KnowsWhatALauncherSays) {
  const auto of = [](const std::map<std::string, std::string>& variables) {
    return launchOf([&](const char* name) -> const char* {
      const auto found = variables.find(name);
      return found == variables.end() ? nullptr : found->second.c_str();
    });
  };
  EXPECT_FALSE(of({}));
  EXPECT_EQ(of({{"OMPI_COMM_WORLD_RANK", "2"}, {"OMPI_COMM_WORLD_SIZE", "5"}})->rank, 2);
  EXPECT_EQ(of({{"PMI_RANK", "0"}, {"PMI_SIZE", "3"}})->size, 3);
  EXPECT_EQ(of({{"PMIX_RANK", "1"}, {"SLURM_STEP_NUM_TASKS", "4"}})->size, 4);
  EXPECT_FALSE(of({{"SLURM_NTASKS", "4"}, {"SLURM_PROCID", "0"}, {"SLURM_STEP_NUM_TASKS", "1"}}));
  EXPECT_FALSE(of({{"PMI_RANK", "3"}, {"PMI_SIZE", "3"}}));
  EXPECT_FALSE(of({{"PMI_RANK", "x"}, {"PMI_SIZE", "3"}}));
}

TEST_F(RanksProgram, RunsAloneWhereItIsTold) {
  folder_.write("scene.toml", richScene());
  ASSERT_EQ(call("run scene.toml --out alone").status, 0);
  const std::string launched = "OMPI_COMM_WORLD_SIZE=3 OMPI_COMM_WORLD_RANK=";
  ASSERT_EQ(call("run scene.toml --ranks no --out told", launched + "1").status, 0);
  EXPECT_EQ(folder_.read("told/history.csv"), folder_.read("alone/history.csv"));
  // One process is no run on ranks.
  ASSERT_EQ(shell(mpirun(1) + "'" RINGWATCH_PROGRAM "' run scene.toml --out one").status, 0);
  EXPECT_EQ(folder_.read("one/history.csv"), folder_.read("alone/history.csv"));
  // A build without MPI has no program for ranks.
  std::filesystem::copy_file(RINGWATCH_PROGRAM, folder_.path() / "ringwatch");
  const Outcome first = shell(launched + "0 ./ringwatch run scene.toml --out none");
  expectRefused(first, "-DRINGWATCH_WITH_MPI=ON");
  const Outcome second = shell(launched + "1 ./ringwatch run scene.toml --out none");
  EXPECT_EQ(second.status, 2);
  EXPECT_EQ(second.err, "");
  EXPECT_FALSE(exists("none"));
  EXPECT_EQ(shell(launched + "0 ./ringwatch run scene.toml --ranks no --out some").status, 0);
}

}  // namespace
}  // namespace ringwatch

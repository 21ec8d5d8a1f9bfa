// Abaqus and CalculiX decks as scenes: what is taken, left out and refused, and motions against analytic answers.
#include <algorithm>
#include <cmath>
#include <set>
#include <span>
#include <sstream>
#include <string>

#include <ringwatch/app/scene/deck_keywords.h>
#include <ringwatch/app/scene/deck_scene.h>
#include <ringwatch/app/scene/dyna_keywords.h>
#include <ringwatch/app/scene/time_table.h>
#include <ringwatch/base/error.h>
#include <ringwatch/meshes/mesh_io.h>

#include "program.h"

namespace ringwatch {
namespace {

using test::Json;
using test::Outcome;
using test::Program;
using ::testing::HasSubstr;

/// Two cubes of 0.1 m side by side along x.
constexpr const char* cubes = R"(*HEADING
two cubes
*NODE, NSET=Nall
1, 0, 0, 0
2, 0.1, 0, 0
3, 0.1, 0.1, 0
4, 0, 0.1, 0
5, 0, 0, 0.1
6, 0.1, 0, 0.1
7, 0.1, 0.1, 0.1
8, 0, 0.1, 0.1
9, 0.2, 0, 0
10, 0.2, 0.1, 0
11, 0.2, 0, 0.1
12, 0.2, 0.1, 0.1
*ELEMENT, TYPE=C3D8, ELSET=Eall
1, 1, 2, 3, 4, 5, 6, 7, 8
2, 2, 9, 10, 3, 6, 11, 12, 7
*NSET, NSET=Left
1, 4, 5, 8
*NSET, NSET=right
9, 10, 11, 12
)";
constexpr const char* soft = R"(*MATERIAL, NAME=Soft
*ELASTIC
30e3, 0.3
*DENSITY
1000.
*SOLID SECTION, ELSET=EALL, MATERIAL=soft
)";

class Decks : public Program {
 protected:
  void write(const std::string& more) { folder_.write("deck.inp", cubes + more); }
  static std::string step(const std::string& inside, const std::string& first =
                                                         "*STEP, NLGEOM\n*DYNAMIC, EXPLICIT, "
                                                         "DIRECT\n1e-3, 0.05\n") {
    return first + inside + "*END STEP\n";
  }
  /// Displacements at the end, 3×N, m, in the order of the file's numbers.
  NodeVectors run(const std::string& deck) {
    write(deck);
    const Outcome outcome = call("run deck.inp --out r --set output.every=0.05 --set output.picture=false");
    EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
    out_ = outcome.out;
    const auto frames = json("r/summary.json")["frames"].get<int>();
    const auto state =
        loadVtuState(folder_.path() / joinText("r/frames/frame_00000", frames, ".vtu"), "displacement", nullptr);
    NodeVectors u(3, state.mesh.X.cols());
    for (std::int32_t i = 0; i < u.cols(); ++i) u.col(state.mesh.nodeId(i) - 1) = state.x.col(i) - state.mesh.X.col(i);
    return u;
  }
  void refuse(const std::string& deck, const std::string& what, const std::string& command = "run deck.inp --out x") {
    write(deck);
    expectRefused(command, what);
  }
  std::string out_;
};

// u_n = v t + a (t² + h t)/2 with symplectic Euler, exact for a body that flies freely.
TEST_F(Decks, LetABodyFly) {
  const NodeVectors u = run(std::string(soft) + "*INITIAL CONDITIONS, TYPE=VELOCITY\nNall, 1, 1.5\nNALL, 2, -0.5\n" +
                            step("*DLOAD\nEall, GRAV, 9.81, 0., 0., -1.\n"));
  const double t = 0.05, h = 1e-3;
  const Eigen::Vector3d expected(1.5 * t, -0.5 * t, -9.81 * 0.5 * (t * t + h * t));
  EXPECT_LT((u.colwise() - expected).cwiseAbs().maxCoeff(), 3e-16);
}

TEST_F(Decks, SayThatAbaqusHasLargeDisplacementsUnasked) {
  for (const auto& [parameter, told] : {std::pair{"", true}, {", NLGEOM=NO", false}, {", NLGEOM", false}}) {
    run(std::string(soft) + step("", joinText("*STEP", parameter, "\n*DYNAMIC, EXPLICIT, DIRECT\n1e-3, 0.05\n")));
    EXPECT_EQ(out_.find("Abaqus/Explicit has large displacements unasked") != std::string::npos, told) << parameter;
  }
  // Bulk viscosity, which changes the step of inspect, too.
  for (const auto& [line, told] : {std::pair{"", true}, {"*BULK VISCOSITY\n", false}})
    for (const std::string command : {"inspect deck.inp", "run deck.inp --out r --set output.picture=false"}) {
      write(std::string(soft) + step(line));
      EXPECT_EQ(call(command).out.find("Abaqus/Explicit has 0.06 and 1.2 unasked") != std::string::npos, told)
          << command;
    }
}

// Set by set, twice on each element: as once on all with the sum. A cube apart falls by its own load alone.
TEST_F(Decks, TakeGravityOfSets) {
  constexpr const char* sets = "*ELSET, ELSET=one\n1\n*ELSET, ELSET=other\n2\n";
  const double t = 0.05, h = 1e-3, fall = -9.81 * 0.5 * (t * t + h * t);
  const NodeVectors whole = run(sets + std::string(soft) +
                                step("*DLOAD\none, GRAV, 5., 0., 0., -1.\none, GRAV, 4.81, 0., 0., -1.\nother, GRAV, "
                                     "4.81, 0., 0., -1.\n2, GRAV, 5., 0., 0., -1.\n"));
  EXPECT_LT((whole.colwise() - Eigen::Vector3d(0, 0, fall)).cwiseAbs().maxCoeff(), 3e-16);
  const NodeVectors apart =
      run("*NODE\n13, 1, 0, 0\n14, 1.1, 0, 0\n15, 1, 0.1, 0\n16, 1, 0, 0.1\n*ELEMENT, TYPE=C3D4, ELSET=Eall\n3, 13, "
          "14, 15, 16\n" +
          std::string(soft) + step("*DLOAD\n3, GRAV, 9.81, 0., 0., -1.\n"));
  ASSERT_EQ(apart.cols(), 16);
  EXPECT_LT(apart.leftCols(12).cwiseAbs().maxCoeff(), 3e-16);
  EXPECT_LT((apart.rightCols(4).colwise() - Eigen::Vector3d(0, 0, fall)).cwiseAbs().maxCoeff(), 3e-16);
}

// As in CalculiX: a direction has length one, of a node's initial velocities the last counts, loads add up.
TEST_F(Decks, TakeTheLastVelocityAndTheSumOfLoads) {
  const double t = 0.05, h = 1e-3;
  const NodeVectors u =
      run(std::string(soft) +
          "*INITIAL CONDITIONS, TYPE=VELOCITY\nNall, 1, 1.5\nNall, 2, 7\nNall, 1, 2.5\nNall, 2, -0.5\n" +
          step("*DLOAD\nEall, GRAV, 5., 0., 0., -2.\nEall, GRAV, 4.81, 0., 0., -0.5\n"));
  const Eigen::Vector3d expected(2.5 * t, -0.5 * t, -9.81 * 0.5 * (t * t + h * t));
  EXPECT_LT((u.colwise() - expected).cwiseAbs().maxCoeff(), 3e-16);
  refuse(std::string(soft) + "*INITIAL CONDITIONS, TYPE=VELOCITY\nright, 1, 1.5\nNall, 1, 2\n" + step(""),
         "its nodes have different velocities already");

  // Pressures in one card, in one line for all and one for a single element, in the same face as one of the sum.
  const std::string held = std::string(soft) + "*BOUNDARY\nleft, 1, 3\n";
  const NodeVectors both = run(held + step("*DLOAD\n1, P1, 100.\n2, P1, 100.\n1, P1, 200.\n1, P1, 100.\n"));
  const NodeVectors sum = run(held + step("*DLOAD\n1, P1, 400.\n2, P1, 100.\n"));
  EXPECT_GT(sum.norm(), 0);
  EXPECT_LT((both - sum).norm(), 1e-12 * sum.norm());
}

TEST_F(Decks, TakeLinesFromFilesAndNamesInQuotes) {
  folder_.write("elastic.txt", "30e3, 0.3\n");
  folder_.write("end.txt", "1, 4,\n5, 8\n");
  folder_.write("held.txt", "\"left end\", 1, 3\n");
  folder_.write("ramp.txt", "0., 0.,\n0.05, 1.\n");
  const auto deck = [](const std::string& elastic, const std::string& end, const std::string& held,
                       const std::string& ramp) {
    return "*MATERIAL, NAME=m\n*ELASTIC" + elastic + "*DENSITY\n1000.\n*SOLID SECTION, ELSET=Eall, MATERIAL=m\n" +
           "*NSET, NSET=\"left end\"" + end + "*BOUNDARY" + held + "*AMPLITUDE, NAME=a" + ramp +
           step("*CLOAD, AMPLITUDE=a\nright, 3, 1.\n");
  };
  const NodeVectors u = run(deck("\n30e3, 0.3\n", "\n1, 4, 5, 8\n", "\nLeft, 1, 3\n", "\n0., 0., 0.05, 1.\n"));
  EXPECT_GT(u.norm(), 0);
  EXPECT_EQ(
      (u - run(deck(", INPUT=elastic.txt\n", ", INPUT=end.txt\n", ", INPUT=held.txt\n", ", INPUT=ramp.txt\n"))).norm(),
      0);
  refuse("*MATERIAL, NAME=m, INPUT=elastic.txt\n",
         "deck.inp:23: *MATERIAL, INPUT: it has no lines to take from a file");
  refuse(deck(", INPUT=none.txt\n", "\n", "\n", "\n"), "*ELASTIC takes in ");
}

// A force on each node, whatever its mass: 12 nodes of 2 kg in all.
TEST_F(Decks, LoadEachNode) {
  const double t = 0.05, h = 1e-3;
  write("");
  // Nodes in the middle have twice the mass of the others, which their forces have too, so that nothing deforms.
  const std::string loads = "*CLOAD\nNall, 1, 0.5\n2, 1, 0.5\n3, 1, 0.5\n6, 1, 0.5\n7, 1, 0.5\n";
  const NodeVectors u = run(std::string(soft) + step(loads));
  const double acceleration = 16 * 0.5 / 2.0;
  EXPECT_LT((u.row(0).array() - acceleration * 0.5 * (t * t + h * t)).abs().maxCoeff(), 3e-16);
  EXPECT_LT(u.bottomRows(2).cwiseAbs().maxCoeff(), 3e-16);
}

// A displacement of straight lines in time, whose velocity jumps.
TEST_F(Decks, MoveNodesByATable) {
  const NodeVectors u = run(std::string(soft) +
                            "*AMPLITUDE, NAME=Zig\n0., 0., 0.02, 1., 0.03, -0.5\n0.04, 0.25\n"
                            "*BOUNDARY\nleft, 1, 3\n" +
                            step("*BOUNDARY, AMPLITUDE=ZIG\nright, 1, 1, 2e-3\nright, 2\nright, 3\n"));
  for (const int node : {9, 10, 11, 12}) {
    EXPECT_NEAR(u(0, node - 1), 0.25 * 2e-3, 1e-15) << node;
    EXPECT_EQ(u(1, node - 1), 0) << node;
  }
  for (const int node : {1, 4, 5, 8}) EXPECT_EQ(u.col(node - 1).norm(), 0) << node;
}

// The same scene written as TOML, on the deck's mesh, takes the same bits.
TEST_F(Decks, RunAsTheSceneThatTheyStandFor) {
  run(std::string(soft) + "*AMPLITUDE, NAME=A\n0., 0., 1., 1.\n*BOUNDARY\nleft, ENCASTRE\n" +
      step("*BOUNDARY, AMPLITUDE=A\nright, 1, 1, 0.05\n*CLOAD\n2, 3, -0.1\n6, 3, -0.1\n"));
  EXPECT_THAT(out_, HasSubstr("deck.inp:33: *STEP with NLGEOM: linear elasticity is stvk"));
  folder_.write("scene.toml", R"(mesh = {file = "deck.inp"}
material = {model = "stvk", young = 30e3, poisson = 0.3, density = 1000}
integrator = {step = 1e-3, end = 0.05}
[[fix]]
set = "Left"
[[move]]
set = "right"
components = "x"
displacement = [0.05, 0, 0]
times = [0, 1]
factors = [0, 1]
[[force]]
set = "#2,6"
each = [0, 0, -0.1]
)");
  ASSERT_EQ(call("run scene.toml --out s --set output.every=0.05 --set output.picture=false").status, 0);
  EXPECT_EQ(folder_.read("r/history.csv"), folder_.read("s/history.csv"));
}

TEST_F(Decks, TellWhatIsLeftOut) {
  run(std::string(soft) +
      step("*NODE FILE, FREQUENCY=10\nU\n*EL PRINT, ELSET=Eall\nS\n", "*STEP\n*DYNAMIC\n1e-3, 0.05\n"));
  EXPECT_THAT(
      out_, HasSubstr("left out, they change no motion: *HEADING (line 1), *NODE FILE (line 32), *EL PRINT (line 34)"));
  EXPECT_THAT(out_, HasSubstr("*DYNAMIC is implicit there, and is run explicitly here"));
  EXPECT_THAT(out_, HasSubstr("*STEP without NLGEOM: linear elasticity is linear"));
  EXPECT_EQ(out_.find("skipped, only nodes"), std::string::npos) << out_;
}

// Lines and faces of the geometry, without a section, as preprocessors write them.
TEST_F(Decks, LeaveOutElementsWithoutASection) {
  run("*ELEMENT, TYPE=T3D2, ELSET=line\n101, 1, 2\n102, 2, 3\n*ELEMENT, TYPE=CPS4, ELSET=face\n201, 1, 5, 8, 4\n" +
      std::string(soft) + step("*BOUNDARY\nface, 1, 3\n"));
  EXPECT_THAT(out_, HasSubstr("elements that are no solids and that no section makes part of the body: 2 of type T3D2 "
                              "(line 23), 1 of type CPS4 (line 26); the sets of their nodes stay"));
}

TEST_F(Decks, RefuseWhatWouldChangeTheMotion) {
  const std::string whole = std::string(soft) + step("");
  refuse(whole + "*CONTACT EXCLUSIONS\n*TIE, NAME=t\n",
         "deck.inp:33: *CONTACT EXCLUSIONS: of contact *CONTACT PAIR and *CONTACT INCLUSIONS, ALL EXTERIOR are taken, "
         "hard and with one coefficient of friction; and 1 more: "
         "deck.inp:34: *TIE: ties degrees of freedom to each other");
  refuse(whole + "*NEW THING\n", "deck.inp:33: *NEW THING is not known");
  refuse(std::string(soft) + step("*CLOAD\nright, 1, 1.\n*CLOAD, OP=NEW\nright, 2, 1.\n"),
         "deck.inp:34: *CLOAD, OP=NEW: takes away what is loaded above; leave that out instead");
  refuse("*MATERIAL, NAME=m\n*ELASTIC, TYPE=ORTHO\n1,1,1\n", "deck.inp:24: *ELASTIC, TYPE=ORTHO: there is no such law");
  refuse("*MATERIAL, NAME=m\n*ELASTIC\n1e3, 0.3, 20.\n2e3, 0.3, 100.\n",
         "deck.inp:26: *ELASTIC: values that depend on temperature");
  const std::string shells = "*ELEMENT, TYPE=S4, ELSET=thin\n7, 1, 2, 3, 4\n8, 5, 6,\n7, 8\n";
  refuse(shells + "*SHELL SECTION, ELSET=thin, MATERIAL=m\n0.1\n" + whole,
         "deck.inp:27: *SHELL SECTION: there are solid elements only; and 1 more: deck.inp:23: *ELEMENT, TYPE=S4: 2 "
         "elements: there are solid elements only");
  const std::string trusses = "*ELEMENT, TYPE=T3D2\n7, 1, 2\n", bars = "*ELSET, ELSET=bars\n7\n";
  for (const std::string elset : {"bars", "BARS"})
    refuse(trusses + bars + whole + "*SOLID SECTION, ELSET=" + elset + ", MATERIAL=soft\n",
           "deck.inp:23: *ELEMENT, TYPE=T3D2: 1 element: there are solid elements only");
  refuse(std::string(soft) + step("", "*STEP\n*STATIC\n"), "deck.inp:30: *STATIC: is no *DYNAMIC step");
  refuse(soft, "deck.inp: has no *DYNAMIC step");
  refuse(std::string(soft) + step("") + step(""), "deck.inp:33: *STEP: a second step; a run has one");
  refuse(std::string(soft) + step("*DLOAD\nEall, BX, 1e3\n"),
         "deck.inp:33: *DLOAD, \"BX\": of distributed loads GRAV and P1 to P6 are taken");
  refuse(std::string(soft) + step("*DLOAD\nEall, CENTRIF, 1e3, 0, 0, 0, 1, 0, 0\n"),
         "deck.inp:33: *DLOAD, CENTRIF: its force grows with the distance");
  refuse(std::string(soft) + step("*DLOAD\nEall, NEWTON\n"), "deck.inp:33: *DLOAD, NEWTON: its force depends on where");
  refuse(std::string(soft) + step("*DLOAD\n1, P4, 1e3\n"), "deck.inp:33: *DLOAD: face 4 of hex8 element 1 lies inside");
  refuse(std::string(soft) + step("*DLOAD\n7, P1, 1e3\n"), "deck.inp:33: *DLOAD: the mesh has no element 7");
  refuse(std::string(soft) + step("*DLOAD\nnone, P1, 1e3\n"), "deck.inp:33: *DLOAD: there is no element set \"none\"");
  refuse(std::string(soft) + step("*DSLOAD\nskin, P, 1e3\n"),
         "deck.inp:33: *DSLOAD: there is no *SURFACE \"skin\" of element faces");
  refuse(std::string(soft) + "*SURFACE, NAME=skin\nEall, S1\n" + step("*DSLOAD\nskin, TRVEC, 1e3, 1, 0, 0\n"),
         "deck.inp:35: *DSLOAD: a line must be a surface, P, and a pressure");
  refuse("*ELSET, ELSET=one\n1\n" + std::string(soft) + step("*DLOAD\none, GRAV, 9.81, 0, 0, -1\n"),
         "*DLOAD, GRAV on \"one\": its node 2 is also one of elements without this load");
  refuse("*ELSET, ELSET=one\n1\n" + std::string(soft) +
             step("*DLOAD\none, GRAV, 9.81, 0, 0, -1\n2, GRAV, 9.8, 0, 0, -1\n"),
         "*DLOAD, GRAV on \"one\": its node 2 is also one of elements without this load");
  refuse(std::string(soft) + step("*BOUNDARY\nright, 1, 1, 1e-3\n"),
         "deck.inp:33: *BOUNDARY: the nodes would jump to their place at once");
  refuse(std::string(soft) + step("*BOUNDARY, AMPLITUDE=none\nright, 1, 1, 1e-3\n"), "there is no *AMPLITUDE \"NONE\"");
  refuse(std::string(soft) + step("*BOUNDARY\nright, 9\n"), "degrees of freedom 9 to 9; a solid has 1 to 3");
  refuse(std::string(soft) + step("*CLOAD\n99, 1, 1.\n"), "deck.inp:33: force.set: the mesh has no node 99");
  refuse(std::string(soft) + step("*CLOAD\nnowhere, 1, 1.\n"), "deck.inp:33: force.set: unknown node set \"nowhere\"");
  refuse(std::string(soft) + step("*CLOAD\nNall, 4, 1.\n"), "*CLOAD: a moment");
  refuse("*MATERIAL, NAME=m\n*ELASTIC\n1e3, 0.3\n*SOLID SECTION, ELSET=Eall, MATERIAL=m\n" + step(""),
         "deck.inp:23: material.density: missing");
  refuse("*MATERIAL, NAME=m\n*ELASTIC\n1e3, 0.6\n*DENSITY\n1.\n*SOLID SECTION, ELSET=Eall, MATERIAL=m\n" + step(""),
         "deck.inp:23: material.poisson: 0.6");
  refuse(std::string(soft) + "*SOLID SECTION, ELSET=Eall, MATERIAL=hard\n" + step(""),
         "there is no *MATERIAL \"HARD\"");

  folder_.write("material.inp", "*MATERIAL, NAME=soft\n*ELASTIC\n30e3\n");
  refuse("*INCLUDE, INPUT=material.inp\n" + step(""), "material.inp:3: *ELASTIC has one number");
}

// What stresses a body, or changes its mass or supports, is refused by every command that tells a step of it.
TEST_F(Decks, RefuseWhatWouldChangeTheTangent) {
  const std::string whole = std::string(soft) + "*BOUNDARY\nleft, 1, 3\n" + step("");
  const auto refuseAll = [&](const std::string& more, const std::string& what) {
    const std::string deck = std::string(soft) + "*BOUNDARY\nleft, 1, 3\n" + more + step("");
    refuse(deck, what);
    refuse(deck, what, "inspect deck.inp");
    refuse(deck, what, "suggest deck.inp --frame 1/60");
    refuse(deck, what, "audit a.vtk --scene deck.inp");
  };
  folder_.write("a.vtk", "");
  refuseAll("*INITIAL CONDITIONS, TYPE=STRESS\n1, 1, 5e5, 5e5, 5e5, 0., 0., 0.\n",
            "deck.inp:31: *INITIAL CONDITIONS, TYPE=STRESS: changes the tangent and with it the critical step");
  refuseAll("*INITIAL CONDITIONS, TYPE=PLASTIC STRAIN\n", "TYPE=PLASTIC STRAIN: changes the tangent");
  refuseAll("*INITIAL CONDITIONS, TYPE=FIELD, VARIABLE=1\n", "TYPE=FIELD: changes the tangent");
  refuseAll("*INITIAL CONDITIONS, TYPE=SOLUTION\n", "TYPE=SOLUTION: only velocities are taken");
  refuseAll("*INITIAL CONDITIONS\n", "*INITIAL CONDITIONS needs a type");
  refuseAll("*FIELD\nNall, 1.\n", "deck.inp:31: *FIELD: changes the tangent");
  refuseAll("*RESTART, READ, STEP=2\n", "deck.inp:31: *RESTART, READ: goes on with the state of another run");
  refuseAll("*NONSTRUCTURAL MASS, UNITS=TOTAL MASS\n", "deck.inp:31: *NONSTRUCTURAL MASS: adds mass");
  refuseAll("*MODEL CHANGE, REMOVE\nEall\n", "deck.inp:31: *MODEL CHANGE: takes elements out");
  refuseAll("*BOUNDARY, OP=NEW\nright, 1\n", "deck.inp:31: *BOUNDARY, OP=NEW: lets go of what is held above");
  refuseAll("*BOUNDARY, OP=OLD\nright, 1\n", "deck.inp:31: *BOUNDARY, OP=OLD is not taken; AMPLITUDE, TYPE=DISPLA");
  refuseAll("*BOUNDARY\nright, 1, 1, 0., 7\n", "deck.inp:32: *BOUNDARY: a line has 5 entries; it must have at most 4");
  refuseAll("*BULK VISCOSITY\n0.06, 1.2, 7.\n", "deck.inp:32: *BULK VISCOSITY: a line has 3 entries");
  refuseAll("*SURFACE\nEall, S1\n", "deck.inp:31: *SURFACE needs a name, NAME=");
  refuseAll("*SURFACE INTERACTION\n", "deck.inp:31: *SURFACE INTERACTION needs a name, NAME=");
  refuseAll("*SURFACE INTERACTION, NAME=i\n*FRICTION\n0.2\n*FRICTION\n0.3\n",
            "deck.inp:34: *FRICTION gives a second time what line 32 gives");
  refuseAll("*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n*CONTACT PROPERTY ASSIGNMENT\n, , i\n, , j\n",
            "deck.inp:35: *CONTACT PROPERTY ASSIGNMENT: a second line of all surfaces; they have one interaction");
  refuseAll("*BOUNDARY, LOAD CASE=2\nright, 1\n", "deck.inp:31: *BOUNDARY, LOADCASE=2: is of complex values");
  refuseAll("*BOUNDARY, ODD\nright, 1\n", "deck.inp:31: *BOUNDARY, ODD is not taken; AMPLITUDE, TYPE=DISPLACEMENT");
  refuseAll("*MATERIAL, NAME=other\n*DAMPING, STRUCTURAL=0.1\n", "*DAMPING, STRUCTURAL=0.1: is of a vibration");
  refuse(std::string(soft) + step("*CLOAD, TIME DELAY=0.1\nright, 1, 1.\n"), "*CLOAD, TIMEDELAY=0.1: moves the times");

  // Heat strains a body that expands; without temperatures or expansion it is left out.
  const std::string heat = "*INITIAL CONDITIONS, TYPE=TEMPERATURE\nNall, 300.\n";
  const std::string expanding = "*MATERIAL, NAME=other\n*EXPANSION\n1e-5\n";
  refuseAll(expanding + heat, "deck.inp:32: *EXPANSION with the temperatures of *INITIAL CONDITIONS (line 34)");
  refuseAll(expanding + "*BOUNDARY\nleft, 11, 11, 20.\n",
            "deck.inp:32: *EXPANSION with the temperatures of *BOUNDARY (line 34)");
  for (const std::string& more : {heat, expanding})
    for (const std::string command : {"run deck.inp --out h", "inspect deck.inp"}) {
      write(std::string(soft) + "*BOUNDARY\nleft, 1, 3\n" + more + step(""));
      const Outcome outcome = call(command);
      EXPECT_EQ(outcome.status, 0) << outcome.err;
      EXPECT_THAT(outcome.out, HasSubstr(more == heat ? "*INITIAL CONDITIONS (line 31)" : "*EXPANSION (line 32)"));
    }

  write(whole + "*STEP\n*DYNAMIC, EXPLICIT\n, 1.\n*END STEP\n");
  const std::string text = call("inspect deck.inp").out;
  EXPECT_THAT(text, HasSubstr("deck.inp:35: *STEP: this step and what follows it are left out"));
  write(std::string(soft) + step("*CLOAD\nright, 1, 1.\n"));
  EXPECT_THAT(call("inspect deck.inp").out, HasSubstr("do not matter to the step of the body at rest: *HEADING (line "
                                                      "1), *CLOAD (line 32)"));
}

// A step that a deck fixes is held: what inspect proves of it becomes of the run.
TEST_F(Decks, HoldAFixedStep) {
  const std::string body =
      std::string(soft) + "*BOUNDARY\nleft, 1, 3\n*INITIAL CONDITIONS, TYPE=VELOCITY\nright, 1, 1e-3\n";
  write(body);
  const Json bracket = parse(call("inspect deck.inp --exact --json -").out)["critical_step"]["exact"];
  const double safe = bracket["safe"], optimistic = bracket["optimistic"];
  for (const std::string fixing : {"EXPLICIT, DIRECT USER CONTROL", "EXPLICIT, DIRECT", "EXPLICIT, DIRECT=YES",
                                   "DIRECT", "Explicit, directusercontrol"})
    for (const double h : {0.9 * safe, 1.1 * optimistic}) {
      SCOPED_TRACE(fixing);
      write(body + "*STEP\n*DYNAMIC, " + fixing + "\n" + test::digits(h) + ", " + test::digits(20 * h) +
            "\n*END STEP\n");
      const Outcome outcome = call("run deck.inp --out f --set output.picture=false");
      EXPECT_EQ(outcome.status, h < safe ? 0 : 1) << outcome.out << outcome.err;
      const Json summary = json("f/summary.json");
      EXPECT_EQ(summary["scene"]["integrator"]["step"].get<double>(), h);
      EXPECT_EQ(summary["verdict"], h < safe ? "certified" : "violated");
    }

  // A step that is held must be told; the line of the keyword says where.
  for (const std::string numbers : {", 1.", "0., 1.", "1e-5, 0."}) {
    write(body + "*STEP\n*DYNAMIC, EXPLICIT, DIRECT USER CONTROL\n" + numbers + "\n*END STEP\n");
    for (const char* command : {"inspect deck.inp", "run deck.inp --out f"})
      expectRefused(command, "*DYNAMIC: its " + std::string(numbers.ends_with(" 0.") ? "length" : "step") + " is ");
  }

  // SCALE FACTOR is the share of the safe step that is taken.
  double steps[2];
  for (const int i : {0, 1}) {
    write(body + "*STEP\n*DYNAMIC, EXPLICIT, SCALE FACTOR=" + (i == 0 ? "1.0" : "0.5") + "\n, 0.05\n*END STEP\n");
    ASSERT_EQ(call("run deck.inp --out f --set output.picture=false").status, 0);
    steps[i] = json("f/summary.json")["largest_step"];
  }
  EXPECT_DOUBLE_EQ(steps[1] / steps[0], 0.5);
  EXPECT_LE(steps[0], optimistic);
}

// What a *DYNAMIC step says that is not done is told, and what would change the motion is refused.
TEST_F(Decks, TellWhatAStepSaysBesides) {
  const auto told = [&](const std::string& keyword, const std::string& numbers) {
    return run(std::string(soft) + "*STEP\n*DYNAMIC" + keyword + "\n" + numbers + "\n*END STEP\n"), out_;
  };
  EXPECT_THAT(
      told(", EXPLICIT", "1e-6, 0.05, 5e-5"),
      HasSubstr("deck.inp:30: *DYNAMIC, least increment 5e-05 s: CalculiX adds mass where an element needs a "
                "smaller step; none is added here; handler.method = \"mass-scaling\" with handler.step = 5e-05"));
  EXPECT_THAT(told(", EXPLICIT", "1e-6, 0.05"), HasSubstr("first increment 1e-06 s: it does not bound the step"));
  EXPECT_EQ(told(", EXPLICIT", ", 0.05").find("increment"), std::string::npos);
  EXPECT_EQ(told("", "1e-6, 0.05, 5e-5").find("least increment"), std::string::npos);
  EXPECT_THAT(told(", EXPLICIT", ", 0.05, , 2e-5"), HasSubstr("largest increment 2e-05 s: it does not bound the step"));
  EXPECT_THAT(told(", EXPLICIT, FIXED TIME INCREMENTATION", ", 0.05"),
              HasSubstr("the step that is safe at the start is held"));
  EXPECT_THAT(told(", EXPLICIT, IMPROVED DT METHOD=NO", ", 0.05"), HasSubstr("IMPROVEDDTMETHOD=NO: the program's own"));
  EXPECT_THAT(told(", ALPHA=-0.05", "1e-3, 0.05"), HasSubstr("ALPHA=-0.05: damps in an implicit scheme"));
  for (const std::string parameter : {"TIME RESET", "TOTAL TIME AT START=1", "SUBSPACE", "ODD"})
    refuse(std::string(soft) + "*STEP\n*DYNAMIC, " + parameter + "\n1e-3, 0.05\n*END STEP\n",
           "deck.inp:30: *DYNAMIC, ");
}

// Both cubes are pressed from below and above and the first one from the left, by elements and by a surface. The nodes
// of the faces below and above are all nodes: what lies between is not pressed.
TEST_F(Decks, PressFaces) {
  const std::string before = std::string(soft) + "*AMPLITUDE, NAME=A\n0., 0.5, 1., 1.\n";
  const NodeVectors u =
      run(before + step("*DLOAD, AMPLITUDE=A\nEall, P1, 400.\nEall, P2, 400.\n*DLOAD\n1, P6, 100.\n"));
  const std::string history = folder_.read("r/history.csv");
  run(before + "*SURFACE, NAME=Skin\nEall, S1\n1, S2\n2, S2\n*SURFACE, NAME=unused\n1, S3\n" +
      step("*DSLOAD, AMPLITUDE=A\nskin, P, 400.\n*DLOAD\n1, P6, 100.\n"));
  EXPECT_EQ(folder_.read("r/history.csv"), history);
  EXPECT_THAT(out_, HasSubstr("*SURFACE (line 35)"));
  folder_.write("scene.toml", R"(mesh = {file = "deck.inp"}
material = {model = "stvk", young = 30e3, poisson = 0.3, density = 1000}
integrator = {step = 1e-3, end = 0.05}
[[pressure]]
where = "z < 1e-9"
pressure = 400
times = [0, 1]
factors = [0.5, 1]
[[pressure]]
where = "z > 0.0999"
pressure = 400
times = [0, 1]
factors = [0.5, 1]
[[pressure]]
set = "Left"
pressure = 100
)");
  ASSERT_EQ(call("run scene.toml --out s --set output.every=0.05 --set output.picture=false").status, 0);
  EXPECT_EQ(folder_.read("s/history.csv"), history);
  // 100 Pa on 0.01 m² push 2 kg to the right; the force follows its face, which grows by less than 2 %.
  const double mean = (u.row(0).sum() + u(0, 1) + u(0, 2) + u(0, 5) + u(0, 6)) / 16, t = 0.05, h = 1e-3;
  EXPECT_NEAR(mean, 0.5 * 0.5 * (t * t + h * t), 0.02 * mean);
}

TEST_F(Decks, TellTheStepOfTheirBody) {
  write(std::string(soft) + "*BOUNDARY\nleft, 1, 3\n" +
        step("*CONTROLS\n", "*STEP\n*STATIC\n1., 1.\n*CLOAD\nNall, 1, 1.\n"));
  const Outcome outcome = call("inspect deck.inp --json - --global");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json deck = parse(outcome.out);
  // The mesh alone, its numbers on the command line; the deck's *STATIC is of no matter.
  const Json mesh =
      parse(call("inspect deck.inp --model linear --young 30e3 --poisson 0.3 --density 1000 --fix set:Left "
                 "--rule hex8=gauss-2x2x2 --json - --global")
                .out);
  for (const char* side : {"safe", "optimistic", "global"})
    EXPECT_NEAR(deck["critical_step"][side].get<double>() / mesh["critical_step"][side].get<double>(), 1, 1e-9) << side;
  EXPECT_NEAR(deck["mass"].get<double>(), 2, 1e-14);

  // Of a hyperelastic law its moduli at rest: μ = 2 (C10 + C01), K = 2/D1.
  const double mu = 30e3 / 2.6, bulk = 30e3 / (3 * 0.4);
  write("*MATERIAL, NAME=m\n*HYPERELASTIC, MOONEY-RIVLIN\n" + test::digits(0.4 * mu) + ", " + test::digits(0.1 * mu) +
        ", " + test::digits(2 / bulk) +
        "\n*DENSITY\n1000.\n*SOLID SECTION, ELSET=Eall, MATERIAL=m\n*BOUNDARY\nleft, 1, 3\n");
  const Json rubber = parse(call("inspect deck.inp --json -").out);
  EXPECT_NEAR(rubber["critical_step"]["safe"].get<double>() / mesh["critical_step"]["safe"].get<double>(), 1, 1e-9);

  write("*MATERIAL, NAME=m\n*ELASTIC\n30e3, 0.3\n*SOLID SECTION, ELSET=Eall, MATERIAL=m\n");
  expectRefused("inspect deck.inp", "deck.inp:23: material.density: missing");
  EXPECT_EQ(call("inspect deck.inp --density 1000").status, 0);
}

TEST_F(Decks, GiveEachInstanceItsMaterial) {
  const auto part = [](const std::string& name) {
    return "*PART, NAME=" + name + "\n" + std::string(cubes).substr(std::string(cubes).find("*NODE")) +
           "*SOLID SECTION, ELSET=Eall, MATERIAL=" + name + "\n*END PART\n";
  };
  folder_.write("deck.inp", part("soft") + part("hard") +
                                "*ASSEMBLY, NAME=a\n*INSTANCE, NAME=s, PART=soft\n*END INSTANCE\n*INSTANCE, NAME=h, "
                                "PART=hard\n1., 0., 0.\n*END INSTANCE\n*END ASSEMBLY\n"
                                "*MATERIAL, NAME=soft\n*ELASTIC\n30e3, 0.3\n*DENSITY\n1000.\n"
                                "*MATERIAL, NAME=hard\n*ELASTIC\n120e3, 0.3\n*DENSITY\n2000.\n");
  const Outcome outcome = call("inspect deck.inp --json -");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NEAR(parse(outcome.out)["mass"].get<double>(), 2 + 4, 1e-13);
}

TEST_F(Decks, RefuseWhatTheyWouldTakeInSilence) {
  const auto inStep = [](const std::string& more) { return std::string(soft) + step(more); };
  const auto before = [](const std::string& more) { return std::string(soft) + more + step(""); };
  // Nodes that are not there, numbers that are none, and what is not text.
  const std::string pair = "*SURFACE, NAME=a\n1, S6\n*CONTACT PAIR\nb, a\n*SURFACE, NAME=b, TYPE=NODE\n9\n";
  refuse(before(pair + "77\n"), "deck.inp:35: *SURFACE: \"77\" is no node set and no node of the mesh");
  refuse(before(pair + "nowhere\n"), "deck.inp:35: *SURFACE: \"nowhere\" is no node set");
  refuse(before(pair + "12abc\n"), "deck.inp:35: the number of a node is \"12abc\"");
  refuse(inStep("*CLOAD\n99999999999999999999, 1, 1.\n"), "deck.inp:33: the number of a node is");
  refuse(inStep("*CLOAD\n9, 1, nan\n"), "deck.inp:33: the force is \"nan\"");
  refuse(inStep("*CLOAD\nB\xff, 1, 1.\n"), "deck.inp:33: the line is not UTF-8");
  refuse(inStep("*CLOAD\n, 1, 1.\n"), "deck.inp:33: a node or set is missing");
  refuse(before("*BOUNDARY\n, 1, 3\n"), "deck.inp:30: a node or set is missing");
  refuse(before("*INITIAL CONDITIONS, TYPE=VELOCITY\n, 1, 2.\n"), "deck.inp:30: a node or set is missing");
  refuse(std::string(soft) + step("", "*STEP\n*DYNAMIC, EXPLICIT\n-1e-3, 1.\n"),
         "deck.inp:31: *DYNAMIC: a time is below 0");
  // What is given twice: both lines.
  refuse(before(soft), "deck.inp:29: *MATERIAL \"Soft\" gives a second time what line 23 gives");
  const auto ofMaterial = [](const std::string& more) {
    return "*MATERIAL, NAME=m\n*ELASTIC\n30e3, 0.3\n*DENSITY\n1000.\n" + more +
           "*SOLID SECTION, ELSET=Eall, MATERIAL=m\n" + step("");
  };
  refuse(ofMaterial("*DENSITY\n2000.\n"), "deck.inp:28: *DENSITY gives a second time what line 26 gives");
  refuse(ofMaterial("*HYPERELASTIC, NEO HOOKE\n1., 1.\n"), "deck.inp:28: *HYPERELASTIC gives a second time");
  refuse("*MATERIAL, NAME=m\n*HYPERELASTIC, NEO HOOKE, YEOH\n", "*HYPERELASTIC names two energies");
  refuse(before("*AMPLITUDE, NAME=a\n0., 1.\n*AMPLITUDE, NAME=A\n0., 2.\n"),
         "deck.inp:31: *AMPLITUDE \"A\" gives a second time what line 29 gives");
  refuse(before("*SURFACE, NAME=a\n1, S6\n*SURFACE, NAME=A\n2, S4\n"), "*SURFACE \"A\" gives a second time");
  refuse(inStep("*BULK VISCOSITY\n0.06, 1.2\n0.1, 1.2\n"), "*BULK VISCOSITY has a second line");
  refuse(inStep("*BULK VISCOSITY\n*BULK VISCOSITY\n"), "*BULK VISCOSITY gives a second time what line 32 gives");
  refuse(before("*AMPLITUDE, NAME=a\n0., 0., 1.,\n"), "a time without its value");
  refuse(before("*SURFACE INTERACTION, NAME=s\n*FRICTION\n0.2\n*SURFACE INTERACTION, NAME=S\n"),
         "*SURFACE INTERACTION \"S\" is given a second time");
  // What stands where it is not read.
  refuse(before("*CLOAD\n9, 1, 1.\n"), "deck.inp:29: *CLOAD stands outside a step");
  refuse(std::string(soft) + "*DYNAMIC, EXPLICIT\n, 1.\n", "deck.inp:29: *DYNAMIC stands outside a step");
  refuse(before("*BOUNDARY\nright, 1, 1, 1e-3\n"), "deck.inp:30: *BOUNDARY before the step");
  refuse(std::string(soft) + step("", "*STEP, NLGEOM=OFF\n*DYNAMIC, EXPLICIT\n, 1.\n"), "NLGEOM=OFF: YES and NO");
  // Masses that are not in a set of elements.
  const std::string mass = "*ELEMENT, TYPE=MASS, ELSET=tip\n100, 9\n*MASS, ELSET=tip\n1.\n";
  refuse(std::string(soft) + mass + step("*DLOAD\nEall, GRAV, 9.81, 0., 0., -1.\n"),
         "deck.inp:37: GRAV on \"Eall\": the masses of *MASS (line 31) are not in it");
  // A damping that CalculiX gives to all.
  write(
      "*ELSET, ELSET=one\n1\n*ELSET, ELSET=two\n2\n*MATERIAL, NAME=m\n*ELASTIC\n3e4, 0.3\n*DENSITY\n1000.\n"
      "*MATERIAL, NAME=n\n*ELASTIC\n3e4, 0.3\n*DENSITY\n1000.\n*DAMPING, ALPHA=10.\n*SOLID SECTION, ELSET=one, "
      "MATERIAL=m\n*SOLID SECTION, ELSET=two, MATERIAL=n\n" +
      step(""));
  expectRefused("run deck.inp --out x", "*DAMPING of one of several materials: CalculiX damps the whole body by it");
}

// m a = -α m v of the body alone: a point mass without springs to others is not damped, nor is a face pressed twice.
TEST_F(Decks, DampTheMaterialAndPressAFaceOnce) {
  const std::string held = std::string(soft) + "*BOUNDARY\nleft, 1, 3\n";
  const NodeVectors once = run(held + "*SURFACE, NAME=end\n2, S4\n" + step("*DSLOAD\nend, P, 100.\n"));
  const NodeVectors again = run(held + "*SURFACE, NAME=end\n2, S4\n2, S4\n" + step("*DSLOAD\nend, P, 100.\n"));
  EXPECT_GT(once.norm(), 0);
  EXPECT_EQ((once - again).norm(), 0);

  // All nodes have the same mass m of the body and M = k m of point masses: u = v (1 - exp(-α t / (1 + k))) (1 + k) /
  // α.
  const double alpha = 10, k = 3, t = 0.05;
  const std::string damped =
      "*MATERIAL, NAME=m\n*ELASTIC\n30e3, 0.3\n*DENSITY\n1000.\n*DAMPING, ALPHA=10.\n"
      "*SOLID SECTION, ELSET=Eall, MATERIAL=m\n";
  std::string masses = "*ELEMENT, TYPE=MASS, ELSET=ends\n", middle = "*ELEMENT, TYPE=MASS, ELSET=mids\n";
  for (const int node : {1, 4, 5, 8, 9, 10, 11, 12}) masses += joinText(100 + node, ", ", node, "\n");
  for (const int node : {2, 3, 6, 7}) middle += joinText(100 + node, ", ", node, "\n");
  masses += "*MASS, ELSET=ends\n0.375\n" + middle + "*MASS, ELSET=mids\n0.75\n";
  const NodeVectors u = run(damped + masses + "*INITIAL CONDITIONS, TYPE=VELOCITY\nNall, 1, 1.\n" + step(""));
  const double expected = (1 - std::exp(-alpha * t / (1 + k))) * (1 + k) / alpha;
  EXPECT_LT((u.row(0).array() - expected).abs().maxCoeff(), 2e-3 * expected);
}

TEST_F(Decks, KeepInstancesAndPartsApart) {
  const std::string mesh = std::string(cubes).substr(std::string(cubes).find("*NODE"));
  const std::string material = "*MATERIAL, NAME=soft\n*ELASTIC\n30e3, 0.3\n*DENSITY\n1000.\n";
  const std::string section = "*SOLID SECTION, ELSET=Eall, MATERIAL=soft\n";
  const std::string one = "*INSTANCE, NAME=A, PART=p\n*END INSTANCE\n", two = one +
                                                                              "*INSTANCE, NAME=B, PART=p\n1., "
                                                                              "0., 0.\n*END INSTANCE\n";
  const auto deck = [&](const std::string& parts, const std::string& assembly, const std::string& more) {
    return "*HEADING\n*PART, NAME=p\n" + mesh + parts + "*ASSEMBLY, NAME=a\n" + assembly + "*END ASSEMBLY\n" +
           material + more;
  };
  const auto refused = [&](const std::string& text, const std::string& what) {
    folder_.write("deck.inp", text);
    expectRefused("run deck.inp --out x", what);
  };
  const auto massOf = [&](const std::string& text) {
    folder_.write("deck.inp", text);
    const Outcome outcome = call("inspect deck.inp --json -");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return parse(outcome.out)["mass"].get<double>();
  };
  // Numbers of several instances.
  const std::string why = ": a number in a deck of several instances; give a set";
  refused(deck(section + "*END PART\n", two, "*BOUNDARY\n5, 1, 3\n" + step("")), "\"5\"" + why);
  refused(deck(section + "*END PART\n", two + "*SURFACE, NAME=n, TYPE=NODE\n5\n*SURFACE, NAME=f\nB.Eall,\n",
               step("*CONTACT PAIR\nn, f\n")),
          "\"5\"" + why);
  const std::string mass = "*ELEMENT, TYPE=MASS, ELSET=points\n100, 5\n*MASS, ELSET=points\n3.\n";
  refused(deck(section + "*END PART\n", two + mass, step("")), "\"5\"" + why);
  refused(deck(section + mass + "*END PART\n", two, step("")), "with sets INSTANCE.SET of one node");
  const std::string tip = "*NSET, NSET=tip\n9\n", bySet =
                                                      "*ELEMENT, TYPE=MASS, ELSET=points\n100, B.tip\n"
                                                      "*MASS, ELSET=points\n3.\n";
  EXPECT_NEAR(massOf(deck(tip + section + "*END PART\n", two + bySet, "")), 4 + 3, 1e-13);
  refused(deck("*NSET, NSET=tip\n9, 10\n" + section + "*END PART\n", two + bySet, step("")),
          "\"B.tip\" is 2 nodes of the mesh; it must be one");
  // A part without an instance, and a section of one instance.
  EXPECT_NEAR(massOf(deck(section + "*END PART\n*PART, NAME=q\n" + mesh + section + mass + "*END PART\n", one, "")), 2,
              1e-13);
  const std::string inOne = "*INSTANCE, NAME=A, PART=p\n" + section + "*END INSTANCE\n";
  refused(deck("*END PART\n", inOne + two.substr(one.size()), step("")), "2 of 4 elements have no material");
  refused(deck(section + "*BOUNDARY\nleft, 1\n*END PART\n", one, step("")), "*BOUNDARY stands in a *PART");
  // The set of the instance, where the assembly has one of its name: node 9 moves, and 1 does not.
  folder_.write("deck.inp", deck(tip + section + "*END PART\n", one + "*NSET, NSET=tip, INSTANCE=A\n1\n",
                                 step("*BOUNDARY\nA.tip, 1, 3\n")));
  ASSERT_EQ(call("run deck.inp --out named --set output.picture=false").status, 0);
  EXPECT_EQ(json("named/summary.json")["scene"]["fix"][0]["set"], "A.tip");
}

TEST_F(Decks, ListEveryKeywordOnce) {
  const std::string help = call("help decks").out;
  std::istringstream lines(help.substr(0, help.find("parameters of keywords")));
  std::set<std::string> known;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("  *")) continue;
    std::istringstream words(line);
    for (std::string word; words >> word;) EXPECT_TRUE(known.insert(word).second) << word;
  }
  EXPECT_GT(known.size(), 350u);
}

// Each keyword of both tables, in a deck that runs: what is not taken is told or refused, with its line and reason.
TEST_F(Decks, DoWithEachKeywordWhatTheTablesSay) {
  const std::string dyna =
      "*KEYWORD\n*CONTROL_TERMINATION\n1e-4\n*PART\na "
      "part\n1,1,1\n*SECTION_SOLID\n1,1\n*MAT_ELASTIC\n1,7850.,2.1e11,0.3\n"
      "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,1.,1.,0.\n4,0.,1.,0.\n5,0.,0.,1.\n6,1.,0.,1.\n7,1.,1.,1.\n8,0.,1.,1.\n"
      "*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8\n";
  struct Dialect {
    std::span<const DeckKeywordRule> rules;
    std::string before, data, after;
  };
  int tried = 0;
  for (const Dialect& one : {Dialect{abaqusKeywords(), std::string(cubes) + soft, "", step("")},
                             Dialect{dynaKeywords(), dyna, "9\n", "*END\n"}})
    for (const DeckKeywordRule& row : one.rules) {
      const DeckRule rule = row.rule;
      if (rule == DeckRule::mesh || rule == DeckRule::taken || rule == DeckRule::takenInRun) continue;
      std::istringstream names{std::string(row.names)};
      for (std::string name; names >> name; ++tried) {
        if (name.ends_with('*')) name.back() = 'Q';
        folder_.write("deck.inp", one.before + "*" + name + "\n" + one.data + one.after);
        const std::string line = joinText(":", 1 + std::ranges::count(one.before, '\n'), ": *", name);
        for (const DeckUse use : {DeckUse::run, DeckUse::model}) {
          const bool refused = rule == DeckRule::refused ||
                               (use == DeckUse::run && (rule == DeckRule::load || rule == DeckRule::procedure));
          std::string said;
          try {
            for (const std::string& note : readDeckScene(folder_.path() / "deck.inp", use).notes) said += note + "\n";
            EXPECT_FALSE(refused) << name;
          } catch (const InputError& fault) {
            said = fault.what();
            EXPECT_TRUE(refused) << said;
            EXPECT_THAT(said, HasSubstr(line + ": " + std::string(row.why)));
          }
          EXPECT_THAT(said, HasSubstr("*" + name));
        }
      }
    }
  EXPECT_GT(tried, 400);
}

// ∫ of a table whose factor stays until the next time.
TEST(TimeTable, HoldsItsFactor) {
  const TimeTable table({1, 2, 4}, {3, -1, 0}, Ramp::hold);
  EXPECT_EQ(table.at(0.5), 3);
  EXPECT_EQ(table.at(1.5), 3);
  EXPECT_EQ(table.at(2), -1);
  EXPECT_EQ(table.at(3.9), -1);
  EXPECT_EQ(table.at(5), 0);
  EXPECT_DOUBLE_EQ(table.mean(1, 1), 3);
  EXPECT_DOUBLE_EQ(table.mean(1.5, 1), 0.5 * 3 - 0.5 * 1);
  EXPECT_DOUBLE_EQ(table.mean(0, 5), (3 + 3 - 2 + 0) / 5.0);
}

}  // namespace
}  // namespace ringwatch

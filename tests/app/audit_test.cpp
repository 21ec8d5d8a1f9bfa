// Results of other programs: the bracket of their states, and where their run left it.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <Eigen/Core>

#include "program.h"

namespace ringwatch {
namespace {

using test::Json;
using test::Outcome;
using test::Program;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class Audits : public Program {
 protected:
  Json audit(const std::string& arguments, int status) {
    const Outcome outcome = call("audit " + arguments + " --json -");
    EXPECT_EQ(outcome.status, status) << outcome.out << outcome.err;
    return parse(outcome.out);
  }
  using Motion = std::function<Eigen::Vector3d(const Eigen::Vector3d&)>;
  static constexpr double corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

  /// A tetrahedron in a legacy file: points at rest with the field U, or moved points without it.
  void writeVtk(const std::string& name, double time, int cycle, const Motion& motion, bool field = true) {
    std::string points, u;
    for (const auto& corner : corners) {
      const Eigen::Vector3d X(corner[0], corner[1], corner[2]), x = motion(X);
      const Eigen::Vector3d written = field ? X : x, moved = x - X;
      points += fmt::format("{} {} {}\n", written[0], written[1], written[2]);
      u += fmt::format("{} {} {}\n", moved[0], moved[1], moved[2]);
    }
    folder_.write(
        name, fmt::format("# vtk DataFile Version 3.0\nvtk output\nASCII\nDATASET UNSTRUCTURED_GRID\nFIELD FieldData "
                          "2\nTIME 1 1 double\n{}\nCYCLE 1 1 int\n{}\nPOINTS 4 double\n{}CELLS 1 5\n4 0 1 2 "
                          "3\nCELL_TYPES 1\n10\nPOINT_DATA 4\nSCALARS id int\nLOOKUP_TABLE "
                          "default\n1\n2\n3\n4\n{}",
                          time, cycle, points, field ? "VECTORS U double\n" + u : ""));
  }
  static Eigen::Vector3d turned(const Eigen::Vector3d& X) { return {-X[1] + 3, X[0], X[2]}; }

  /// A CalculiX results file of the tetrahedron: its states (time, increment, motion).
  void writeFrd(const std::vector<std::tuple<double, int, Motion>>& states) {
    std::string text = "    1C\n    2C" + std::string(28, ' ') + "4" + std::string(37, ' ') + "1\n";
    for (int i = 0; i < 4; ++i)
      text += fmt::format(" -1{:>10}{:>12.5E}{:>12.5E}{:>12.5E}\n", 10 * (i + 1), corners[i][0], corners[i][1],
                          corners[i][2]);
    text += " -3\n    3C" + std::string(28, ' ') + "1" + std::string(37, ' ') +
            "1\n -1         7    3    0    1\n -2        10        20        30        40\n -3\n";
    for (const auto& [time, increment, motion] : states) {
      text += fmt::format("    1PSTEP{:>26}{:>12}{:>12}\n", 1, increment, 1);
      text += fmt::format("  100CL  101{:>12.5E}{:>12}{:>21}{:>5}{:>12}\n", time, 4, 1, 1, 1);
      text += " -4  DISP        4    1\n -5  D1          1    2    1    0\n";
      for (int i = 0; i < 4; ++i) {
        const Eigen::Vector3d X(corners[i][0], corners[i][1], corners[i][2]), u = motion(X) - X;
        text += fmt::format(" -1{:>10}", 10 * (i + 1));
        for (int c = 0; c < 3; ++c) text += std::isnan(u[c]) ? "        -NAN" : fmt::format("{:>12.5E}", u[c]);
        text += "\n";
      }
      text += " -3\n";
    }
    folder_.write("bar.frd", text + " 9999\n");
  }
};

// Squashed to half, the tetrahedron has directions of negative stiffness, which no step cures.
TEST_F(Audits, CertifyNoStepOfAnIndefiniteTangent) {
  writeVtk("a0.vtk", 0, 0, [](const Eigen::Vector3d& X) { return X; });
  writeVtk("a1.vtk", 0.1, 100, [](const Eigen::Vector3d& X) { return Eigen::Vector3d(0.5 * X[0], X[1], X[2]); });
  const std::string arguments = "a0.vtk a1.vtk --step 1e-6 --junit junit.xml" + std::string(test::material);
  const Json json = audit(arguments, 3);
  EXPECT_EQ(json["history"][0]["verdict"], "certified");
  EXPECT_EQ(json["history"][1]["verdict"], "not-certified");
  EXPECT_TRUE(json["history"][1]["indefinite"].get<bool>());
  EXPECT_EQ(json["first"]["not_certified"]["state"], 2);
  const std::string out = call("audit " + arguments).out;
  EXPECT_THAT(out, HasSubstr("first step that is not proven stable: state 2 at t = 0.1 s: h = 1e-06 s, safe "));
  EXPECT_THAT(out, HasSubstr("; the tangent is indefinite, eigenvalue -"));
  EXPECT_THAT(out, HasSubstr("conclusion: the tangent is indefinite in 1 of 2 states; the step came to "));
  EXPECT_THAT(out, HasSubstr(" s is proven in the 1 of 2 states that have a proven step\n"));
  EXPECT_THAT(folder_.read("junit.xml"), HasSubstr("<failure message=\"the tangent is indefinite: step 1e-06 s\"/>"));
  // Nor where the results do not tell the step; and of states that are left out nothing is said.
  audit("a1.vtk --junit junit.xml" + std::string(test::material), 3);
  EXPECT_THAT(folder_.read("junit.xml"), HasSubstr("<failure message=\"the tangent is indefinite"));
  const std::string some = call("audit " + arguments + " --every 2").out;
  EXPECT_THAT(some, HasSubstr(" s is proven in the 1 states that were examined\n"));
}

// A StVK tetrahedron that is stretched to λ in all directions has the tangent of rest times about (3 λ² - 1)/2 and
// more: its critical step falls. Turned, it has that of rest.
TEST_F(Audits, ReadLegacyFiles) {
  writeVtk("a0.vtk", 0, 0, [](const Eigen::Vector3d& X) { return X; });
  writeVtk("a1.vtk", 0.1, 100, turned);
  writeVtk("a2.vtk", 0.2, 200, [](const Eigen::Vector3d& X) { return Eigen::Vector3d(2 * X); });
  const Json json = audit("a0.vtk a1.vtk a2.vtk" + std::string(test::material), 0);
  const Json& history = json["history"];
  ASSERT_EQ(history.size(), 3u);
  const double rest = json["at_rest"]["safe"].get<double>();
  EXPECT_DOUBLE_EQ(history[0]["safe"].get<double>(), rest);
  EXPECT_NEAR(history[1]["safe"].get<double>() / rest, 1, 1e-12);
  EXPECT_EQ(history[2]["time"], 0.2);
  EXPECT_NEAR(history[0]["step"].get<double>(), 1e-3, 1e-15);  // 0.1 s in 100 cycles
  // W = λ/2 (tr E)² + μ E:E with E = 3/2 I, on a sixth of a cubic metre.
  const double mu = 30e3 / 2.6, lambda = 30e3 * 0.3 / (1.3 * 0.4);
  EXPECT_NEAR(history[2]["strain_energy"].get<double>() / ((0.5 * lambda * 4.5 * 4.5 + mu * 3 * 2.25) / 6), 1, 1e-14);
  EXPECT_LT(history[2]["optimistic"].get<double>(), 0.5 * rest);

  // inspect agrees about the mesh at rest.
  const Json inspected = parse(call("inspect a0.vtk --json -" + std::string(test::material)).out);
  EXPECT_DOUBLE_EQ(inspected["critical_step"]["safe"].get<double>(), rest);

  // Between the two steps: proven at rest, proven unstable when stretched.
  const Json left = audit(fmt::format("a0.vtk a1.vtk a2.vtk --step {} {}", 0.9 * rest, test::material), 1);
  EXPECT_EQ(left["first"]["violated"]["state"], 3);
  EXPECT_EQ(left["first"]["inverted"], nullptr);
  EXPECT_EQ(left["history"][1]["verdict"], "certified");
  const Outcome text = call(fmt::format("audit a0.vtk a1.vtk a2.vtk --step {} {}", 0.9 * rest, test::material));
  EXPECT_THAT(text.out, HasSubstr("first step that is proven unstable: state 3 at t = 0.2 s: h = "));
  EXPECT_THAT(text.out, HasSubstr("proven for the tangent of this law"));

  // As test cases: how near the proven step the others came, and none that passes where no step is told.
  audit(fmt::format("a0.vtk a2.vtk --step {} --junit j.xml{}", test::digits(0.5 * rest), test::material), 1);
  EXPECT_THAT(folder_.read("j.xml"), HasSubstr("tests=\"2\" failures=\"1\" errors=\"0\" skipped=\"0\""));
  EXPECT_THAT(folder_.read("j.xml"), HasSubstr(" s, 0.5 times the proven one, "));
  writeVtk("untold.vtk", 0, 0, [](const Eigen::Vector3d& X) { return X; });
  audit("untold.vtk --junit j.xml" + std::string(test::material), 0);
  EXPECT_THAT(folder_.read("j.xml"), HasSubstr("tests=\"1\" failures=\"0\" errors=\"0\" skipped=\"1\""));
  EXPECT_THAT(folder_.read("j.xml"), HasSubstr("<skipped message=\"the results do not tell which step was taken; "));
}

TEST_F(Audits, TakeMovedPointsForPositions) {
  writeVtk(
      "a0.vtk", 0, 0, [](const Eigen::Vector3d& X) { return X; }, false);
  writeVtk("a1.vtk", 0.1, 100, turned, false);
  const Outcome outcome = call("audit a0.vtk a1.vtk" + std::string(test::material));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("the points are taken for positions"));
  const Json json = audit("a0.vtk a1.vtk" + std::string(test::material), 0);
  EXPECT_NEAR(json["history"][1]["safe"].get<double>() / json["at_rest"]["safe"].get<double>(), 1, 1e-12);
  expectRefused("audit a0.vtk a0.vtk" + std::string(test::material), "the points of all states are the same");
}

// Two tetrahedra on a common face; the second one is folded over and deleted. Its mass stays at its nodes.
TEST_F(Audits, LeaveOutElementsThatAreDeletedAndNameAllByTheNumbersOfTheFile) {
  const auto write = [&](const std::string& name, double time, double z, int erosion, const std::string& status = "") {
    folder_.write(name,
                  fmt::format("# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nFIELD FieldData "
                              "2\nTIME 1 1 double\n{}\nCYCLE 1 1 int\n0\nPOINTS 5 double\n0 0 0\n1 0 0\n0 1 "
                              "0\n0 0 {}\n0 0 -1\nCELLS 3 13\n2 0 1\n4 0 1 2 3\n4 0 2 1 4\nCELL_TYPES "
                              "3\n3\n10\n10\nPOINT_DATA 5\nSCALARS NODE_ID int 1\nLOOKUP_TABLE "
                              "default\n1001 1002 1003 1004 1005\nCELL_DATA 3\nSCALARS ELEMENT_ID int "
                              "1\nLOOKUP_TABLE default\n9 501 502\nSCALARS {} int 1\nLOOKUP_TABLE default\n0 {} "
                              "{}\n",
                              time, z, status.empty() ? "EROSION_STATUS" : status, erosion, status.empty() ? 0 : 1));
  };
  write("s0.vtk", 0, 1, 0);
  write("s1.vtk", 1e-4, -1.5, 1);
  write("s2.vtk", 1e-4, -1.5, 0);
  write("t0.vtk", 0, 1, 1, "STATUS");
  write("t1.vtk", 1e-4, -1.5, 0, "STATUS");
  const std::string law = " --step 1e-5" + std::string(test::material);
  const Json deleted = audit("s0.vtk s1.vtk" + law, 0), kept = audit("s0.vtk s2.vtk" + law, 1);
  EXPECT_EQ(deleted["first"]["inverted"], nullptr);
  EXPECT_EQ(deleted["history"][1]["deleted_elements"], 1);
  EXPECT_EQ(deleted["history"][1]["least_determinant"], 1.0);
  EXPECT_EQ(deleted["history"][1]["controlling_element"]["id"], 502);
  EXPECT_EQ(deleted["history"][1]["controlling_element"]["node_ids"], Json({1001, 1003, 1002, 1005}));
  // The state alone, as a mesh: without the mass of the element.
  const Outcome alone = call("inspect s1.vtk --json s1.json" + std::string(test::material));
  ASSERT_EQ(alone.status, 0) << alone.err;
  EXPECT_THAT(alone.out,
              HasSubstr("s1.vtk: 1 of 2 elements is deleted, by the status that the file tells, and left out with"));
  EXPECT_EQ(json("s1.json")["controlling_element"]["id"], 502);
  EXPECT_NEAR(json("s1.json")["mesh"]["volume"].get<double>(), 1. / 6, 1e-15);
  EXPECT_EQ(call("mesh check s2.vtk").status, 1);
  const Json other = audit("t0.vtk t1.vtk" + law, 0);
  EXPECT_EQ(other["history"][1]["deleted_elements"], 1);
  EXPECT_EQ(other["history"][1]["safe"], deleted["history"][1]["safe"]);
  EXPECT_EQ(kept["first"]["inverted"]["state"], 2);
  EXPECT_THAT(call("audit s0.vtk s2.vtk" + law).out, HasSubstr("det F = -1.5 in tet4 element 0:0 (number 501)"));
  // The element that is left, alone, with half the mass at the common nodes: a light one has the shorter step.
  EXPECT_GT(deleted["history"][1]["safe"].get<double>(), deleted["at_rest"]["safe"].get<double>());
}

// By the brackets of the table: a run at a twentieth of its step, and one that is too large in the second state alone.
TEST_F(Audits, ConcludeHowLargeTheStepsWere) {
  const auto stretched = [](double by) { return [by](const Eigen::Vector3d& X) { return Eigen::Vector3d(by * X); }; };
  writeVtk("a0.vtk", 0, 0, stretched(1));
  writeVtk("a1.vtk", 1e-3, 10, stretched(1.2));
  const Json rest = audit("a0.vtk a1.vtk --step 1e-6" + std::string(test::material), 0);
  const double first = rest["history"][0]["safe"], second = rest["history"][1]["safe"];
  ASSERT_NE(first, second);
  for (const double h : {0.05 * std::min(first, second), 0.99 * std::max(first, second)}) {
    const bool proven = h < std::min(first, second);
    const Json& worst = rest["history"][first < second ? 0 : 1];
    const Outcome outcome =
        call("audit a0.vtk a1.vtk --json j.json --junit j.xml --step " + test::digits(h) + test::material);
    const Json steps = json("j.json")["steps"];
    EXPECT_NEAR(steps["largest_share"].get<double>(), h / std::min(first, second), 1e-12);
    EXPECT_EQ(steps["state"], first < second ? 1 : 2);
    EXPECT_EQ(steps["proven_in_all"], std::min(first, second));
    EXPECT_EQ(outcome.out.find(": the run could have been 20 times shorter\n") != std::string::npos, proven);
    const std::string cases = folder_.read("j.xml");
    EXPECT_THAT(cases, HasSubstr(proven ? "tests=\"2\" failures=\"0\"" : "tests=\"2\" failures=\"1\""));
    EXPECT_EQ(cases.find("<failure") == std::string::npos, proven);
    // What is wrong stands first, the same on the command line, in the JSON and in JUnit's file.
    const std::string conclusion = json("j.json")["conclusion"],
                      wrong = fmt::format(
                          "the step is proven unstable in 1 of 2 states, at worst {:.3g} times the "
                          "largest that may be stable, in state {}",
                          h / worst["optimistic"].get<double>(), first < second ? 1 : 2);
    EXPECT_EQ(conclusion.starts_with(wrong), !proven) << conclusion;
    EXPECT_THAT(outcome.out, HasSubstr("conclusion: " + conclusion + "\n"));
    EXPECT_THAT(cases, HasSubstr("<system-out>" + conclusion + "</system-out>"));
    if (!proven) {
      EXPECT_THAT(cases, HasSubstr(fmt::format("s, {:.3g} times the proven one, ", h / std::min(first, second))));
    }
  }
}

TEST_F(Audits, NameWhatIsInvertedAndLost) {
  const auto flat = [](const Eigen::Vector3d& X) { return Eigen::Vector3d(X[0], X[1], -0.5 * X[2]); };
  const auto lost = [](const Eigen::Vector3d& X) { return Eigen::Vector3d(X[0] > 0 ? std::nan("") : 0, X[1], X[2]); };
  writeFrd({{0.01, 10, [](const Eigen::Vector3d& X) { return Eigen::Vector3d(1.01 * X); }},
            {0.03, 20, flat},
            {0.05, 40, lost}});
  const Json json = audit("bar.frd --junit j.xml" + std::string(test::material), 1);
  EXPECT_THAT(json["conclusion"].get<std::string>(),
              AllOf(HasSubstr("the state is lost in 1 of 3 states; an element is inverted in 1 of 3 states; "),
                    Not(HasSubstr("could have been"))));
  EXPECT_THAT(folder_.read("j.xml"),
              AllOf(HasSubstr("<failure message=\"the state is lost, 1 of 4 nodes are not finite: step "),
                    Not(HasSubstr("null"))));
  EXPECT_EQ(json["displacement"], "DISP");
  EXPECT_NEAR(json["history"][0]["step"].get<double>(), 2e-3, 1e-15);
  EXPECT_NEAR(json["history"][1]["step"].get<double>(), 1e-3, 1e-15);
  EXPECT_EQ(json["first"]["inverted"]["state"], 2);
  EXPECT_NEAR(json["history"][1]["least_determinant"].get<double>(), -0.5, 1e-12);
  EXPECT_EQ(json["first"]["lost"]["state"], 3);
  EXPECT_EQ(json["history"][2]["safe"], nullptr);
  EXPECT_EQ(json["history"][2]["not_finite_nodes"], 1);
  EXPECT_EQ(json["history"][0]["controlling_element"]["id"], 7);

  // With the deck that the results are of: its law, its supports; matched by the numbers of the nodes.
  folder_.write(
      "bar.inp",
      "*NODE, NSET=all\n40, 0, 0, 1\n10, 0, 0, 0\n20, 1, 0, 0\n30, 0, 1, 0\n*ELEMENT, TYPE=C3D4, ELSET=E\n7, 10, "
      "20, 30, 40\n*MATERIAL, NAME=m\n*ELASTIC\n30e3, 0.3\n*DENSITY\n1000.\n*SOLID SECTION, ELSET=E, "
      "MATERIAL=m\n*STEP, NLGEOM\n*DYNAMIC, EXPLICIT\n1e-3, 1.\n*END STEP\n");
  const Json deck = audit("bar.frd --scene bar.inp", 1);
  EXPECT_NEAR(deck["history"][0]["safe"].get<double>() / json["history"][0]["safe"].get<double>(), 1, 1e-12);
  EXPECT_EQ(deck["law"], "stvk");
}

// In the order of the files' times, whatever that on the command line or in the .pvd is; the first one is at rest.
TEST_F(Audits, TakeStatesInTheOrderOfTheirTimes) {
  const auto stretched = [](double by) { return [by](const Eigen::Vector3d& X) { return Eigen::Vector3d(by * X); }; };
  for (int i = 0; i < 3; ++i) writeVtk(fmt::format("a{}.vtk", i), 0.1 * i, 100 * i, stretched(1 + 0.2 * i), false);
  const std::string law = test::material, note = "the states were not given in the order of their times";
  const Json inOrder = audit("a0.vtk a1.vtk a2.vtk" + law, 0);
  EXPECT_NEAR(inOrder["history"][1]["step"].get<double>(), 1e-3, 1e-15);
  std::string entries;
  for (const int i : {2, 0, 1}) entries += fmt::format("<DataSet timestep=\"{}\" file=\"a{}.vtk\"/>\n", 0.1 * i, i);
  folder_.write("all.pvd", "<VTKFile><Collection>\n" + entries + "</Collection></VTKFile>\n");
  for (const std::string files : {"a0.vtk a2.vtk a1.vtk", "a2.vtk a0.vtk a1.vtk", "all.pvd"}) {
    EXPECT_EQ(audit(files + law, 0)["history"], inOrder["history"]) << files;
    EXPECT_THAT(call("audit " + files + law).out, HasSubstr(note)) << files;
  }
  EXPECT_EQ(call("audit a0.vtk a1.vtk a2.vtk" + law).out.find(note), std::string::npos);
}

// Two tetrahedra on a common face, the second one deleted; a state's nodes and elements may come in any order.
TEST_F(Audits, MatchNodesAndElementsByTheirNumbers) {
  struct State {
    std::vector<int> nodes, elements;  // in the order of the file
    int nodeShift = 0, elementShift = 0;
    bool tellsElements = true;
  };
  static constexpr double places[5][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}};
  static constexpr int connectivity[2][4] = {{0, 1, 2, 3}, {0, 2, 1, 4}};
  const auto write = [&](const std::string& name, double scale, const State& state) {
    std::string points, u, nodes, cells, ids, erosion;
    for (const int n : state.nodes) {
      const auto& p = places[n];
      points += fmt::format("{} {} {}\n", p[0], p[1], p[2]);
      u += fmt::format("{} {} {}\n", scale * p[0], 2 * scale * p[1], 0);
      nodes += fmt::format("{}\n", 1001 + n + state.nodeShift);
    }
    for (const int e : state.elements) {
      cells += "4";
      for (const int n : connectivity[e])
        cells += fmt::format(" {}", std::ranges::find(state.nodes, n) - state.nodes.begin());
      cells += "\n";
      ids += fmt::format("{}\n", 501 + e + state.elementShift);
      erosion += fmt::format("{}\n", scale > 0 ? e : 0);
    }
    folder_.write(name,
                  fmt::format("# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 5 "
                              "double\n{}CELLS 2 10\n{}CELL_TYPES 2\n10\n10\nPOINT_DATA 5\nVECTORS U double\n{}"
                              "SCALARS NODE_ID int 1\nLOOKUP_TABLE default\n{}CELL_DATA 2\nSCALARS {} int "
                              "1\nLOOKUP_TABLE default\n{}SCALARS EROSION_STATUS int 1\nLOOKUP_TABLE default\n{}",
                              points, cells, u, nodes, state.tellsElements ? "ELEMENT_ID" : "PART", ids, erosion));
  };
  const std::string law = " --step 1e-5" + std::string(test::material);
  write("s0.vtk", 0, {{0, 1, 2, 3, 4}, {0, 1}});
  const auto lastOf = [&](const State& state) {
    write("s1.vtk", 0.1, state);
    return audit("s0.vtk s1.vtk" + law, 0)["history"][1];
  };
  const Json same = lastOf({{0, 1, 2, 3, 4}, {0, 1}});
  EXPECT_EQ(same["deleted_elements"], 1);
  for (const State& state :
       {State{{4, 3, 2, 1, 0}, {1, 0}}, State{{1, 2, 0, 4, 3}, {0, 1}}, State{{0, 1, 2, 3, 4}, {1, 0}}})
    EXPECT_EQ(lastOf(state), same);
  // Elements without numbers are told by their nodes, whose numbers are known.
  write("s0.vtk", 0, {{0, 1, 2, 3, 4}, {0, 1}, 0, 0, false});
  const Json byNodes = lastOf({{0, 1, 2, 3, 4}, {0, 1}, 0, 0, false});
  EXPECT_EQ(byNodes["deleted_elements"], 1);
  for (const State& state : {State{{4, 3, 2, 1, 0}, {1, 0}, 0, 0, false}, State{{0, 1, 2, 3, 4}, {1, 0}, 0, 0, false},
                             State{{1, 2, 0, 4, 3}, {1, 0}}})
    EXPECT_EQ(lastOf(state), byNodes);
  write("s0.vtk", 0, {{0, 1, 2, 3, 4}, {0, 1}});
  // Against a deck with other numbers, which lists its nodes the other way round: by the order of the numbers.
  std::string deck = "*NODE\n";
  for (int n = 4; n >= 0; --n) deck += fmt::format("{}, {}, {}, {}\n", n + 1, places[n][0], places[n][1], places[n][2]);
  deck += "*ELEMENT, TYPE=C3D4, ELSET=E\n";
  for (int e = 1; e >= 0; --e) {
    deck += fmt::format("{}", e + 1);
    for (const int n : connectivity[e]) deck += fmt::format(", {}", n + 1);
    deck += "\n";
  }
  folder_.write("deck.inp", deck +
                                "*MATERIAL, NAME=m\n*ELASTIC\n30e3, 0.3\n*DENSITY\n1000.\n*SOLID SECTION, ELSET=E, "
                                "MATERIAL=m\n*STEP, NLGEOM\n*DYNAMIC, EXPLICIT\n1e-5, 1.\n*END STEP\n");
  write("s1.vtk", 0.1, {{0, 1, 2, 3, 4}, {0, 1}});
  for (const char* name : {"s0.vtk", "s1.vtk"}) {
    std::string text = folder_.read(name);
    for (const char* field :
         {"SCALARS NODE_ID int 1\nLOOKUP_TABLE default\n", "SCALARS ELEMENT_ID int 1\nLOOKUP_TABLE default\n"}) {
      const std::size_t begin = text.find(field);
      ASSERT_NE(begin, std::string::npos);
      std::size_t end = begin + std::string(field).size();
      while (end < text.size() && std::isdigit(static_cast<unsigned char>(text[end]))) end = text.find('\n', end) + 1;
      text.erase(begin, end - begin);
    }
    folder_.write(name, text);
  }
  // Numbers in one of the states alone, or twice the same one: the place in the file tells, and a note says so.
  const std::string without = folder_.read("s1.vtk");
  write("s2.vtk", 0.1, {{0, 1, 2, 3, 4}, {0, 1}});
  folder_.write("twice.vtk", folder_.read("s2.vtk").replace(folder_.read("s2.vtk").find("1004\n"), 4, "1003"));
  for (const auto& [files, notes] : std::vector<std::pair<std::string, std::vector<std::string>>>{
           {"s0.vtk s2.vtk",
            {"note: s2.vtk: tells numbers of its nodes, which the first state does not: in 1 of 2 states nodes are "
             "matched by their place in the file\n",
             "note: s2.vtk: tells numbers of its elements, which the first state does not: in 1 of 2 states"}},
           {"s2.vtk s1.vtk", {"note: s1.vtk: tells no numbers of its nodes, which the first state does: in 1 of 2"}},
           {"twice.vtk s1.vtk",
            {"note: twice.vtk: the numbers of NODE_ID are not taken, 1003 stands 2 times; those of the file's order "
             "are"}}}) {
    const Outcome outcome = call("audit " + files + law);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    for (const std::string& note : notes) EXPECT_THAT(outcome.out, HasSubstr(note)) << files;
  }
  const Json matched = audit("s0.vtk s1.vtk --scene deck.inp --step 1e-5", 0)["history"][1];
  EXPECT_EQ(matched["deleted_elements"], 1);
  EXPECT_EQ(matched["controlling_element"]["id"], same["controlling_element"]["id"].get<int>() - 500);
  EXPECT_NEAR(matched["safe"].get<double>() / same["safe"].get<double>(), 1, 1e-12);
  write("s0.vtk", 0, {{0, 1, 2, 3, 4}, {0, 1}});
  for (const auto& [state, what] :
       {std::pair{State{{0, 1, 2, 3, 4}, {0, 1}, 1, 0}, "s1.vtk: has no node 1001, which"},
        std::pair{State{{0, 1, 2, 3, 4}, {0, 1}, 0, 7}, "s1.vtk: has no element 501, which"}}) {
    write("s1.vtk", 0.1, state);
    expectRefused("audit s0.vtk s1.vtk" + law, what);
  }
}

// A file may announce data and have none; as many as there are points and cells.
TEST_F(Audits, ReadLegacyFilesWithoutArrays) {
  writeVtk(
      "a0.vtk", 0, 0, [](const Eigen::Vector3d& X) { return X; }, false);
  writeVtk("a1.vtk", 0.1, 100, turned, false);
  const std::string law = test::material,
                    before = folder_.read("a1.vtk").substr(0, folder_.read("a1.vtk").find("POINT_DATA"));
  const Json whole = audit("a0.vtk a1.vtk" + law, 0)["history"];
  for (const std::string data : {"", "POINT_DATA 4\n", "CELL_DATA 1\n", "POINT_DATA 4\nCELL_DATA 1\n"}) {
    folder_.write("a1.vtk", before + data);
    EXPECT_EQ(audit("a0.vtk a1.vtk" + law, 0)["history"], whole) << data;
  }
  folder_.write("a1.vtk", before + "POINT_DATA 4\nCELL_DATA 2\n");
  expectRefused("audit a0.vtk a1.vtk" + law, "the number of CELL_DATA is 2; there are 1");
}

// With C = a M the step h of a mode whose undamped one is h0 has 1 - a h/2 - (h/h0)² = 0.
TEST_F(Audits, CountElementsThatDamp) {
  writeVtk("a0.vtk", 0, 0, [](const Eigen::Vector3d& X) { return X; });
  writeVtk("a1.vtk", 0.1, 100, [](const Eigen::Vector3d& X) { return Eigen::Vector3d(1.5 * X); });
  const auto stepsWith = [&](const std::string& damping) {
    folder_.write("scene.toml",
                  "mesh = {file = \"a0.vtk\"}\nintegrator = {step = 1e-5, end = 1}\nmaterial = {model = \"stvk\", "
                  "young = 30e3, poisson = 0.3, density = "
                  "1000" +
                      damping);
    return audit("a0.vtk a1.vtk --step 1e-5 --scene scene.toml", 0)["history"];
  };
  const Json undamped = stepsWith("}\n"), damped = stepsWith(", mass_damping = 20}\n"),
             bulk = stepsWith("}\ndamping = {bulk_viscosity = true, quadratic_bulk_viscosity = 0}\n");
  const auto withMassDamping = [](double h0) {
    const double q = 20 * h0 / 4;
    return h0 * (std::sqrt(1 + q * q) - q);
  };
  for (std::size_t i = 0; i < 2; ++i) {
    const double safe = undamped[i]["safe"], optimistic = undamped[i]["optimistic"];
    EXPECT_LE(damped[i]["safe"].get<double>(), withMassDamping(optimistic)) << i;
    EXPECT_GE(damped[i]["optimistic"].get<double>(), withMassDamping(safe)) << i;
    EXPECT_GT(damped[i]["safe"].get<double>(), 0.99 * withMassDamping(safe)) << i;
    EXPECT_LT(bulk[i]["optimistic"].get<double>(), safe) << i;
  }
  stepsWith("}\ndamping = {bulk_viscosity = true}\n");
  const std::string arguments = "audit a0.vtk a1.vtk --scene scene.toml";
  EXPECT_THAT(call(arguments).out, HasSubstr("the results tell no velocities: quadratic bulk viscosity"));
  expectRefused(arguments + " --limit 2", "--limit: elements damp");
  EXPECT_EQ(call(arguments + " --report page.html").status, 0);
}

// The page calls an element as the table of the command does: by its number in the file.
TEST_F(Audits, PageNamesElementsByTheirNumbers) {
  writeFrd({{0.01, 1, turned}, {0.1, 100, turned}});
  call("audit bar.frd --report page.html" + std::string(test::material));
  EXPECT_THAT(folder_.read("page.html"),
              HasSubstr("Who controls the critical step (numbers of the mesh file)</caption>"));
  EXPECT_THAT(folder_.read("page.html"),
              HasSubstr("<th scope=\"row\" class=\"number\">7</th><td class=\"number\">100.0 %</td>"));
}

// Of a run of our own: the brackets of its frames are those that inspect tells.
TEST_F(Audits, AgreeWithInspectAboutFrames) {
  folder_.write("scene.toml", test::tiny);
  ASSERT_EQ(call("run scene.toml --out r --set output.picture=false").status, 0);
  const Json json = audit("r/run.pvd --scene scene.toml", 0);
  ASSERT_GE(json["history"].size(), 3u);
  for (const int frame : {1, 3}) {
    const Json inspected = parse(call(fmt::format("inspect r --frame {} --json -", frame)).out);
    for (const char* side : {"safe", "optimistic"})
      EXPECT_NEAR(json["history"][frame - 1][side].get<double>() / inspected["critical_step"][side].get<double>(), 1,
                  1e-9)
          << frame << side;
  }
}

TEST_F(Audits, TakeEachStepOfARunThatFollowsItsBracket) {
  folder_.write("scene.toml", test::tiny);
  ASSERT_EQ(call("run scene.toml --out r --set output.picture=false --set integrator.step=auto").status, 0);
  const Json json = audit("r/run.pvd --scene scene.toml", 0);
  const Table history = table("r/history.csv");
  std::set<double> steps;
  for (const Json& state : json["history"]) {
    std::size_t row = 0;
    while (row + 1 < history.rows.size() && history.number(row, "time_s") != state["time"])
      ++row;  // the end has no row
    EXPECT_EQ(state["step"], history.number(row, "h_s"));
    steps.insert(state["step"].get<double>());
  }
  EXPECT_GE(steps.size(), 3u);
}

TEST_F(Audits, TakeRulesAndLumpingAsInspectDoes) {
  folder_.write("scene.toml", test::tiny);
  ASSERT_EQ(
      call("run scene.toml --out r --set output.picture=false --set mesh.element=hex8 --set mesh.jitter=0.2").status,
      0);
  std::vector<double> steps;
  for (const std::string options :
       {"", " --rule hex8=uniform-strain", " --lumping equal", " --rule hex8=selective --lumping diagonal-scaling"}) {
    const Json state = audit("r/run.pvd" + options + test::material, 0)["history"][2];
    const Json inspected = parse(
        call("inspect r/frames/frame_000003.vtu --displacement displacement --json -" + options + test::material).out);
    for (const char* side : {"safe", "optimistic"})
      EXPECT_NEAR(state[side].get<double>() / inspected["critical_step"][side].get<double>(), 1, 1e-9) << options;
    for (const double other : steps) EXPECT_GT(std::abs(state["safe"].get<double>() / other - 1), 1e-6) << options;
    steps.push_back(state["safe"]);
  }
  expectRefused("audit r/run.pvd --rule hex8=selectiv" + std::string(test::material), "did you mean \"selective\"?");
  expectRefused("audit r/run.pvd --lumping even" + std::string(test::material), "--lumping");
}

TEST_F(Audits, RefuseElementsOfNodesThatAreNotThere) {
  writeVtk("a.vtk", 0, 0, [](const Eigen::Vector3d& X) { return X; });
  const std::string legacy = folder_.read("a.vtk");
  const std::string options = std::string(test::material) + " --step 1e-4";
  for (const std::string node : {"17", "-1", "-5"}) {
    std::string text = legacy;
    text.replace(text.find("4 0 1 2 3"), 9, "4 0 1 2 " + node);
    folder_.write("bad.vtk", text);
    folder_.write("bad.vtu", R"(<VTKFile type="UnstructuredGrid"><UnstructuredGrid>
<Piece NumberOfPoints="4" NumberOfCells="1"><Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">
0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points><Cells><DataArray type="Int64" Name="connectivity" format="ascii">0 1 2 )" +
                                 node + R"(</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">4</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">10</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>)");
    for (const std::string file : {"bad.vtk", "bad.vtu"}) {
      expectRefused("audit " + file + options, "refers to node " + node + ", which the file does not have");
      expectRefused("audit a.vtk " + file + options, "refers to node " + node + ", which the file does not have");
    }
  }
}

TEST_F(Audits, RefuseBadInput) {
  writeVtk("a0.vtk", 0, 0, [](const Eigen::Vector3d& X) { return X; });
  const std::string material = test::material;
  expectRefused("audit a0.vtk", "--young, --poisson and --density are required, or --scene with the materials");
  expectRefused("audit nowhere.frd" + material, "nowhere.frd: cannot read: there is no such file");
  expectRefused("audit a0.vtk --displacement V" + material,
                "no field \"V\"; fields of three components at the points: \"U\"");
  expectRefused("audit a0.vtk --step -1" + material, "--step: \"-1\" is no time; must be a number > 0 or a fraction");
  expectRefused("audit a0.vtk --limit 0" + material, "--limit: 0 is out of range");
  expectRefused("audit a0.vtk --integrator implicit-euler" + material, "is no integrator with a critical step");
  folder_.write("other.vtk", folder_.read("a0.vtk").replace(folder_.read("a0.vtk").find("4 0 1 2 3"), 9, "4 0 2 1 3"));
  expectRefused("audit a0.vtk other.vtk" + material, "every state must have the same");
  folder_.write("x.pvd",
                "<VTKFile type=\"Collection\"><Collection>\n<DataSet timestep=\"0\" file=\"a0.vtk\"/>\n<DataSet "
                "timestep = 'x' file = 'a0.vtk'/></Collection></VTKFile>\n");
  expectRefused("audit x.pvd" + material, "x.pvd: the timestep of state 2 is \"x\"; it must be a number, s");
  // Results in formats whose states are not read: what they are, and what to do.
  for (const auto& [file, text, what] :
       {std::array{"d3plot", "x",
                   "this is a file of results of LS-DYNA (d3plot), which is not read; ParaView opens it"},
        std::array{"d3plot07", "x", "results of LS-DYNA (d3plot)"},
        std::array{"job.odb", "x", "this is a file of results of Abaqus (.odb), which is not read; Abaqus' own Python"},
        std::array{"u.xdmf", "<?xml version=\"1.0\"?>\n<Xdmf/>\n",
                   "this is an XDMF file, of which the mesh alone is "
                   "read; give its states as .vtu or .vtk files"},
        std::array{"u.e", "CDF\x01", "this is a netCDF file, as of Exodus, of which the mesh alone is read"}}) {
    folder_.write(file, text);
    expectRefused(std::string("audit ") + file + material, what);
    expectRefused(std::string("inspect ") + file + " --displacement U" + material, what);
  }
  writeFrd({});
  expectRefused("audit bar.frd" + material, "bar.frd: has no DISP");
  std::string cut = folder_.read("bar.frd");
  folder_.write("bar.frd", cut.substr(0, cut.find(" -3")));
  expectRefused("audit bar.frd" + material, "is it cut short?");
  writeFrd({{0.1, 1, turned}});
  folder_.write("bar.frd", folder_.read("bar.frd").replace(folder_.read("bar.frd").find("E+00"), 4, "E+0x"));
  expectRefused("audit bar.frd" + material, "bar.frd:3: coordinate x is");
}

}  // namespace
}  // namespace ringwatch

// Decks as Abaqus/Explicit's preprocessors write them: each is the same body and the same step as a scene of its mesh.
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include <ringwatch/app/scene/time_table.h>

#include "deck_program.h"

namespace ringwatch {
namespace {

using test::Json;
using test::Outcome;
using ::testing::HasSubstr;
using ::testing::Not;

/// A part of two cubes of 0.1 m side by side along x, of elements of a type, with a section, and its instance.
std::string part(const std::string& type,
                 const std::string& section = "*Solid Section, elset=All, material=Steel\n,\n") {
  return R"(*Heading
** Job name: bar Model name: Model-1
*Preprint, echo=NO, model=NO, history=NO, contact=NO
*Part, name=Bar
*Node
1, 0., 0., 0.
2, 0.1, 0., 0.
3, 0.1, 0.1, 0.
4, 0., 0.1, 0.
5, 0., 0., 0.1
6, 0.1, 0., 0.1
7, 0.1, 0.1, 0.1
8, 0., 0.1, 0.1
9, 0.2, 0., 0.
10, 0.2, 0.1, 0.
11, 0.2, 0., 0.1
12, 0.2, 0.1, 0.1
*Element, type=)" +
         type + R"(
1, 1, 2, 3, 4, 5, 6, 7, 8
2, 2, 9, 10, 3, 6, 11, 12, 7
*Nset, nset=Root
1, 4, 5, 8
*Nset, nset=Tip
9, 10, 11, 12
*Elset, elset=All, generate
1, 2, 1
*Elset, elset=First
1,
*Elset, elset=Second
2,
)" + section +
         R"(*End Part
*Assembly, name=Assembly
*Instance, name=Bar-1, part=Bar
*End Instance
*Nset, nset=Fix, instance=Bar-1
1, 4, 5, 8
*End Assembly
)";
}
std::string steel(const std::string& more = "") {
  return "*Material, name=Steel\n*Density\n7850.,\n*Elastic\n2.1e11, 0.3\n" + more;
}
std::string step(const std::string& inside, const std::string& dynamic = "*Dynamic, Explicit\n, 1e-4\n",
                 const std::string& before = "*Boundary\nFix, ENCASTRE\n") {
  return before + "*Step, name=Step-1, nlgeom=YES\n" + dynamic + inside +
         "*Restart, write, number interval=1, time marks=NO\n*Output, field, variable=PRESELECT\n*Output, history, "
         "variable=PRESELECT\n*End Step\n";
}
constexpr const char *stvk = "[material]\nmodel = \"stvk\"\nyoung = 2.1e11\npoisson = 0.3\ndensity = 7850\n",
                     *fixed = "[[fix]]\nset = \"Root\"\n";

class ExplicitDecks : public test::DeckProgram {
 public:
  static void TearDownTestSuite() { expectAllUsed(abaqusKeywords()); }

 protected:
  void expectSame(const std::string& deck, const std::string& scene,
                  const std::string& integrator = "step = \"auto\"\nend = 1e-4\n", const std::string& mesh = "") {
    test::DeckProgram::expectSame("deck.inp", deck, scene, integrator, mesh);
  }
  void refuse(const std::string& deck, const std::string& what, const std::string& command = "run deck.inp --out x") {
    folder_.write("deck.inp", deck);
    expectRefused(command, what);
  }
};

TEST_F(ExplicitDecks, TakeOnePointHexahedraAndBulkViscosity) {
  const std::string rules = std::string(stvk) + "rules = [\"hex8=uniform-strain\"]\n" + fixed;
  expectSame(part("C3D8R") + steel() + step("*Bulk Viscosity\n0.06, 1.2\n"),
             rules + "[damping]\nbulk_viscosity = true\n");
  EXPECT_NEAR(mass_, 15.7, 1e-13);
  EXPECT_THAT(out_,
              HasSubstr("deck.inp:18: *ELEMENT, TYPE=C3D8R is hex8 with uniform-strain: one point, with hourglass "
                        "control"));
  EXPECT_THAT(out_,
              HasSubstr("left out, they change no motion: *HEADING (line 1), *PREPRINT (line 3), *RESTART (line "));
  expectSame(part("C3D8RH") + steel() + step("*Bulk Viscosity\n, 0.\n"),
             rules + "[damping]\nbulk_viscosity = true\nquadratic_bulk_viscosity = 0\n");
  // b1 alone shortens the step of a cube, by about its own size.
  const Json without = parse(call("inspect deck.inp --json - --global").out);
  folder_.write("deck.inp", part("C3D8RH") + steel() + step("*Bulk Viscosity\n0., 0.\n"));
  const Json plain = parse(call("inspect deck.inp --json - --global").out);
  EXPECT_LT(without["critical_step"]["safe"].get<double>(), 0.97 * plain["critical_step"]["safe"].get<double>());
}

// Types of one shape in one section, and in a section each.
TEST_F(ExplicitDecks, TakeHexahedraOfTwoQuadratures) {
  const std::string both = "*Solid Section, elset=All, material=Steel\n,\n",
                    each =
                        "*Solid Section, elset=Second, material=Steel\n,\n*Solid Section, elset=First, "
                        "material=Steel\n,\n";
  const auto scene = [](const std::string& first, const std::string& second) {
    const std::string law = std::string(stvk).substr(std::string(stvk).find('\n'));
    return "[[material]]\nset = \"First\"\nrules = [\"hex8=" + first + "\"]" + law +
           "[[material]]\nset = \"Second\"\nrules = [\"hex8=" + second + "\"]" + law + fixed +
           "[[force]]\nset = \"#9\"\neach = [0, 1e4, 0]\n";
  };
  for (const auto& [types, first, second] :
       {std::array{"C3D8R", "uniform-strain", "gauss-2x2x2"}, std::array{"c3d8", "gauss-2x2x2", "uniform-strain"}})
    for (const std::string& sections : {both, each}) {
      std::string deck = part(types, sections);
      const std::string other = std::string(types) == "c3d8" ? "C3D8RH" : "C3D8";
      deck.insert(deck.find("2, 2, 9"), "*Element, type=" + other + "\n");
      expectSame(deck + steel() + step("*Cload\nBar-1.9, 2, 1e4\n"), scene(first, second));
    }
}

TEST_F(ExplicitDecks, SayWhatStandsForHybridAndModifiedElements) {
  expectSame(part("C3D8H") + steel() + step(""), std::string(stvk) + "rules = [\"hex8=selective\"]\n" + fixed);
  EXPECT_THAT(out_, HasSubstr("*ELEMENT, TYPE=C3D8H is hex8 with selective: its one pressure"));
  // Middles of edges are numbered as VTK has them.
  const std::string tetrahedron =
      "*NODE\n1,0,0,0\n2,2,0,0\n3,0,2,0\n4,0,0,2\n5,1,0,0\n6,1,1,0\n7,0,1,0\n8,0,0,1\n9,1,0,1\n10,0,1,1\n*ELEMENT, "
      "TYPE=TYPE_HERE, ELSET=All\n1,1,2,3,4,5,6,7,8,9,10\n*NSET, NSET=Root\n1,2,5\n*SOLID SECTION, ELSET=All, "
      "MATERIAL=STEEL\n" +
      steel();
  const auto of = [&](const std::string& type) {
    std::string text = tetrahedron;
    text.replace(text.find("TYPE_HERE"), 9, type);
    return text + "*BOUNDARY\nRoot, PINNED\n*STEP, NLGEOM\n*DYNAMIC, EXPLICIT\n, 1e-4\n*END STEP";
  };
  for (const auto& [type, told] : {std::pair("C3D10M", "the modified tetrahedron of Abaqus"),
                                   {"C3D10MH", "the modified hybrid tetrahedron"},
                                   {"C3D10H", "its pressure has no unknowns of its own here"}}) {
    expectSame(of(type), std::string(stvk) + fixed);
    EXPECT_NEAR(mass_, 7850 * 8.0 / 6, 1e-9);
    EXPECT_THAT(out_,
                HasSubstr(std::string("deck.inp:12: *ELEMENT, TYPE=") + type + " is tet10 with keast-4: " + told));
    EXPECT_THAT(call("inspect deck.inp").out, HasSubstr(told));
  }
  refuse(part("C3D8I") + steel() + step(""), "TYPE=C3D8I: its incompatible modes are not ours");
}

TEST_F(ExplicitDecks, TellWhatOfSectionControlsIsOtherwise) {
  const auto deck = [](const std::string& controls) {
    return part("C3D8R", "*Solid Section, elset=All, controls=EC-1, material=Steel\n,\n") +
           "*Section Controls, name=EC-1" + controls + "\n" + steel() + step("");
  };
  expectSame(deck(", hourglass=ENHANCED, second order accuracy=YES\n1., 1., 1., 1., 1."),
             std::string(stvk) + "rules = [\"hex8=uniform-strain\"]\n" + fixed);
  EXPECT_THAT(out_, HasSubstr("*SECTION CONTROLS, HOURGLASS=ENHANCED: the hourglass control here is of stiffness"));
  EXPECT_THAT(call("inspect deck.inp").out, HasSubstr("HOURGLASS=ENHANCED: the hourglass control here"));
  for (const std::string command : {"run deck.inp --out x", "inspect deck.inp"}) {
    refuse(deck("\n, , , 2., 1."), "factor 2. of bulk viscosity, which is of the whole body here", command);
    refuse(deck(", distortion control=YES"), "DISTORTIONCONTROL=YES: adds forces against inversion", command);
    refuse(deck(", kinematic split=ORTHOGONAL"), "KINEMATICSPLIT=ORTHOGONAL is not taken", command);
  }
}

TEST_F(ExplicitDecks, DampEachMaterialByItself) {
  const std::string sections =
      "*Solid Section, elset=First, material=Steel\n,\n*Solid Section, elset=Second, material=Light\n,\n";
  const std::string light = "*Material, name=Light\n*Density\n2700.,\n*Elastic\n7e10, 0.3\n";
  const auto scene = [](const std::string& first, const std::string& second) {
    return "[[material]]\nset = \"First\"\nmodel = \"stvk\"\nyoung = 2.1e11\npoisson = 0.3\ndensity = 7850\n" + first +
           "[[material]]\nset = \"Second\"\nmodel = \"stvk\"\nyoung = 7e10\npoisson = 0.3\ndensity = 2700\n" + second +
           fixed;
  };
  const std::string loads = "*Cload\nBar-1.Tip, 1, -1e4\n", force = "[[force]]\nset = \"Tip\"\neach = [-1e4, 0, 0]\n";
  expectSame(part("C3D8", sections) + steel("*Damping, alpha=100., beta=1e-6\n") + light + step(loads),
             scene("mass_damping = 100\nstiffness_damping = 1e-6\n", "") + force);
  EXPECT_NEAR(mass_, 7.85 + 2.7, 1e-13);
  expectSame(part("C3D8", sections) + steel("*Damping, alpha=100.\n") + light + "*Damping, beta=2e-7\n" + step(loads),
             scene("mass_damping = 100\n", "mass_damping = 0\nstiffness_damping = 2e-7\n") + force);
  // What all have is that of the body.
  expectSame(part("C3D8", sections) + steel("*Damping, alpha=100., beta=1e-6\n") + light +
                 "*Damping, alpha=100., beta=1e-6\n" + step(loads + "*Bulk Viscosity\n"),
             scene("", "") + force + "[damping]\nmass = 100\nstiffness = 1e-6\nbulk_viscosity = true\n");
}

// Sets and numbers with the name of the only instance and without are the same.
TEST_F(ExplicitDecks, TakeNamesWithAnInstanceAndWithout) {
  const std::string loads = "*Dload\n, GRAV, 9.81, 0., 0., -1.\n*Cload\n";
  const std::string scene =
      std::string(stvk) + fixed +
      "[[force]]\nwhere = \"all\"\nacceleration = [0, 0, -9.81]\n[[force]]\nset = \"#12\"\neach = "
      "[0, 500, 0]\n";
  for (const std::string node : {"Bar-1.12", "BAR-1.12", "12"}) {
    const std::string deck = part("C3D8") + steel() + step(loads + node + ", 2, 500.\n");
    expectSame(deck, scene);
    for (const std::string root : {"Bar-1.Root", "Root", "bar-1.root"}) {
      std::string other = deck;
      other.replace(other.find("Fix, ENCASTRE"), 3, root);
      expectSame(other, scene);
    }
  }
  const std::string surface = "*Surface, type=ELEMENT, name=Top\nBar-1.All, S2\n";
  expectSame(part("C3D8") + surface + steel() + step("*Dsload\nTop, P, 1000.\n"),
             std::string(stvk) + fixed + "[[pressure]]\nwhere = \"z > 0.0999\"\npressure = 1000\n");

  std::string two = part("C3D8");
  two.replace(two.find("*Nset, nset=Fix"), 0, "*Instance, name=Bar-2, part=Bar\n1., 0., 0.\n*End Instance\n");
  expectSame(two + steel() + step("*Cload\nbar-2.12, 1, 1.\nBar-1.12, 2, 2.\n*Dload\nBAR-2.2, P4, 1000.\n"),
             std::string(stvk) +
                 "[[fix]]\nset = \"Fix\"\n[[force]]\nwhere = \"x > 1.19 and y > 0.09 and z > 0.09\"\neach "
                 "= [1, 0, 0]\n[[force]]\nwhere = \"x > 0.19 and x < 0.21 and y > 0.09 and z > 0.09\"\neach = [0, 2, "
                 "0]\n[[pressure]]\nwhere = \"x > 1.19\"\npressure = 1000\n");
  refuse(two + steel() + step("*Cload\n12, 1, 1.\n"),
         "\"12\": a number in a deck of several instances; give a set, or Bar-1.12");
  refuse(two + steel() + step("*Cload\nBar-2.13, 1, 1.\n"), "the mesh has no node 113");
}

// A free body has the velocity h a Σ f(n/100), n = 0 … 99, which is 49.5 h a, since f(s) + f(1 - s) = 1.
TEST_F(ExplicitDecks, RampLoadsAndMotionsByASmoothStep) {
  const std::string amplitude = "*Amplitude, name=Amp-1, definition=SMOOTH STEP\n0., 0., 1e-4, 1.\n";
  const std::string ramp = "times = [0, 1e-4]\nfactors = [0, 1]\nramp = \"quintic\"\n";
  const std::string fixing = "step = 1e-6\nend = 1.01e-4\n",
                    dynamic = "*Dynamic, Explicit, direct user control\n1e-6, 1.01e-4\n";
  expectSame(
      part("C3D8") + amplitude + steel() + step("*Boundary, amplitude=Amp-1\nTip, 1, 1, 1e-4\n", dynamic),
      std::string(stvk) + fixed + "[[move]]\nset = \"Tip\"\ncomponents = \"x\"\ndisplacement = [1e-4, 0, 0]\n" + ramp,
      fixing);
  EXPECT_THAT(out_, Not(HasSubstr("leaves the step to the program")));
  const std::string flying =
      part("C3D8") + amplitude + steel() + step("*Dload, amplitude=Amp-1\n, GRAV, 1e3, 1., 0., 0.\n", dynamic, "");
  expectSame(flying, std::string(stvk) + "[[force]]\nwhere = \"all\"\nacceleration = [1e3, 0, 0]\n" + ramp, fixing);
  const Table rows = table("d/history.csv");
  const double speed = 49.5 * 1e-6 * 1e3;
  EXPECT_NEAR(rows.number(rows.rows.size() - 1, "kinetic_J"), 0.5 * 15.7 * speed * speed, 1e-12);

  const TimeTable table({1, 3}, {0, 2}, Ramp::quintic);
  EXPECT_EQ(table.at(0.5), 0);
  EXPECT_DOUBLE_EQ(table.at(1.5), 2 * 0.103515625);  // s³(10 - 15s + 6s²) at 1/4
  EXPECT_DOUBLE_EQ(table.at(2), 1);
  EXPECT_DOUBLE_EQ(table.slope(2), 30.0 / 16);
  EXPECT_DOUBLE_EQ(table.mean(1, 1), 2 * 0.15625);  // ∫ over [0, 1/2], twice
  EXPECT_DOUBLE_EQ(table.mean(1, 2), 1);
  EXPECT_DOUBLE_EQ(table.mean(0, 4), (2 + 2) / 4.0);
  refuse(part("C3D8") + "*Amplitude, name=A, definition=PERIODIC\n" + steel() + step(""),
         "*AMPLITUDE, DEFINITION=PERIODIC is not taken");
}

// The energy of a gradient diag(2, 1, 1) in one of the cubes: W = C10 (Ī1 - 3) + C01 (Ī2 - 3) + (J - 1)²/D1.
TEST_F(ExplicitDecks, RunRubber) {
  const auto deck = [](const std::string& rubber) {
    return part("C3D8") +
           "*Amplitude, name=Amp-1\n0., 0., 0.01, 1.\n*Material, name=Steel\n*Density\n1000.,\n*Hyperelastic, " +
           rubber +
           step("*Boundary, amplitude=Amp-1\nTip, 1, 1, 0.1\nTip, 2, 3\n",
                "*Dynamic, Explicit, direct user control\n1e-4, 1.01e-2\n",
                "*Boundary\nBar-1.2, PINNED\n3, PINNED\n6, PINNED\n7, PINNED\n");
  };
  const double J = 2, I1 = (4 + 2) / std::cbrt(J * J), I2 = (8 + 1) / std::cbrt(J * J * J * J), d1 = 1e-6;
  const auto energy = [&](double c10, double c01, double c20, double c30) {
    const double i = I1 - 3;
    return 1e-3 * (c10 * i + c01 * (I2 - 3) + c20 * i * i + c30 * i * i * i + (J - 1) * (J - 1) / d1);
  };
  const auto expectEnergy = [&](const std::string& rubber, const std::string& law, double expected) {
    expectSame(deck(rubber),
               "[material]\ndensity = 1000\n" + law +
                   "bulk = 2e6\n"
                   "[[fix]]\nset = \"#2,3,6,7\"\n[[fix]]\nset = \"Tip\"\ncomponents = \"yz\"\n[[move]]\nset = "
                   "\"Tip\"\ncomponents = \"x\"\ndisplacement = [0.1, 0, 0]\ntimes = [0, 0.01]\nfactors = [0, "
                   "1]\n",
               "step = 1e-4\nend = 1.01e-2\n");
    const Table rows = table("d/history.csv");
    EXPECT_NEAR(rows.number(rows.rows.size() - 1, "strain_J"), expected, 1e-9 * expected);
  };
  expectEnergy("neo hooke\n1e5, 1e-6\n", "model = \"mooney-rivlin\"\nc10 = 1e5\n", energy(1e5, 0, 0, 0));
  expectEnergy("mooney-rivlin\n8e4, 2e4, 1e-6\n", "model = \"mooney-rivlin\"\nc10 = 8e4\nc01 = 2e4\n",
               energy(8e4, 2e4, 0, 0));
  expectEnergy("yeoh\n1e5, -1e3, 100., 1e-6, 0., 0.\n", "model = \"yeoh\"\nc10 = 1e5\nc20 = -1e3\nc30 = 100\n",
               energy(1e5, 0, -1e3, 100));
  for (const std::string command : {"run deck.inp --out x", "inspect deck.inp"}) {
    refuse(deck("ogden\n1., 2., 3.\n"), "*HYPERELASTIC, OGDEN is not taken; NEOHOOKE, MOONEY-RIVLIN, YEOH", command);
    refuse(deck("neo hooke\n1e5\n"), "*HYPERELASTIC has 1 numbers; it must have 2, the last of which is D1", command);
    refuse(deck("neo hooke\n1e5, 0.\n"), "*HYPERELASTIC: D1 must be > 0", command);
    refuse(deck("yeoh\n1e5, 0., 0., 1e-6, 1e-6\n"), "*HYPERELASTIC: D2 = 1e-6: the law yeoh has D1 alone", command);
  }
}

// By a factor masses are those of another density; for a step they are what elements need, or what the handler adds.
TEST_F(ExplicitDecks, ScaleMasses) {
  const std::string sections =
      "*Solid Section, elset=First, material=Steel\n,\n*Solid Section, elset=Second, material=Steel\n,\n";
  const auto deck = [&](const std::string& scaling, const std::string& more = "") {
    return part("C3D8", sections) + steel() + step(scaling + "*Cload\nTip, 1, -1e4\n" + more);
  };
  const auto scene = [](const std::string& first, const std::string& second, const std::string& handler = "") {
    return "[[material]]\nset = \"First\"\nmodel = \"stvk\"\nyoung = 2.1e11\npoisson = 0.3\ndensity = " + first +
           "\n[[material]]\nset = \"Second\"\nmodel = \"stvk\"\nyoung = 2.1e11\npoisson = 0.3\ndensity = " + second +
           "\n" + handler + fixed + "[[force]]\nset = \"Tip\"\neach = [-1e4, 0, 0]\n";
  };
  expectSame(deck("*Fixed Mass Scaling, factor=4.\n*Fixed Mass Scaling, elset=Bar-1.Second, factor=2.\n"),
             scene("31400", "15700"));
  EXPECT_NEAR(mass_, 4 * 7.85 + 2 * 7.85, 1e-12);
  expectSame(deck("*Fixed Mass Scaling, factor=4.\n*Fixed Mass Scaling, elset=Second\n"), scene("31400", "7850"));
  const std::string forStep = "dt=5e-5, type=BELOW MIN", gravity = "*Dload\n, GRAV, 9.81, 0., 0., -1.\n";
  expectSame(deck("*Variable Mass Scaling, frequency=10, " + forStep + "\n"),
             scene("7850", "7850", "[handler]\nmethod = \"mass-scaling\"\nstep = 5e-5\n"));
  EXPECT_THAT(out_, HasSubstr("DT: mass is added where the proof of the whole body needs it"));
  EXPECT_GT(json("d/summary.json")["smallest_step"].get<double>(), 4e-5);
  EXPECT_THAT(call("inspect deck.inp").out, HasSubstr("DT: this is the body without the mass that a run adds"));
  // A wave of speed c crosses a cube of side l in l/c: its density grows by (dt c/l)^2.
  const double wave = 2.1e11 * 0.7 / (1.3 * 0.4), share = 7.85 * (25e-10 * wave / (7850 * 0.01) - 1) / 8;
  const auto masses = [&](const std::string& once, int nodes, const std::string& twice = "") {
    const auto entry = [](const std::string& set, double mass) {
      return "[[mass]]\nset = \"#" + set + "\"\nmass = " + test::digits(mass) + "\n";
    };
    return entry(once, nodes * share) + (twice.empty() ? "" : entry(twice, 4 * 2 * share));
  };
  const std::string all = masses("1,4,5,8,9,10,11,12", 8, "2,3,6,7"), viscous = "[damping]\nbulk_viscosity = true\n";
  expectSame(deck("*Fixed Mass Scaling, " + forStep + "\n"), scene("7850", "7850") + all);
  EXPECT_NEAR(mass_, 2 * 25e-10 * wave * 0.1, 1e-11);
  EXPECT_THAT(call("inspect deck.inp").out, HasSubstr("its nodes have at least 9 times the mass of their elements"));
  expectSame(deck("*Fixed Mass Scaling, " + forStep + "\n", "*Bulk Viscosity\n*Dload\n1, P1, 1.\n"),
             scene("7850", "7850") + all + viscous + "[[pressure]]\nset = \"#1,2,3,4\"\npressure = 1\n");
  expectSame(deck("*Fixed Mass Scaling, elset=Second, " + forStep + "\n"),
             scene("7850", "7850") + masses("2,3,6,7,9,10,11,12", 8));
  // First by the factor, and then as much more as a step still asks for, which is then the mass that it alone asks for.
  const double more = 15.7 * (25e-10 * wave / (15700 * 0.01) - 1) / 8;
  expectSame(deck("*Fixed Mass Scaling, factor=2., " + forStep + "\n"),
             scene("15700", "15700") + "[[mass]]\nset = \"#1,4,5,8,9,10,11,12\"\nmass = " + test::digits(8 * more) +
                 "\n[[mass]]\nset = \"#2,3,6,7\"\nmass = " + test::digits(8 * more) + "\n");
  EXPECT_NEAR(mass_, 2 * 25e-10 * wave * 0.1, 1e-11);
  expectSame(deck("*Fixed Mass Scaling, factor=16., " + forStep + "\n"), scene("125600", "125600"));
  // What a set has of its own takes the place of what all have.
  expectSame(deck("*Fixed Mass Scaling, elset=Second, " + forStep + "\n*Fixed Mass Scaling, factor=4.\n"),
             scene("31400", "7850") + masses("2,3,6,7,9,10,11,12", 8));
  // A set that is a part of a section's.
  const std::string ofAll =
      part("C3D8") + steel() + step("*Fixed Mass Scaling, elset=Second, factor=2.\n*Cload\nTip, 1, -1e4\n");
  expectSame(ofAll, scene("7850", "15700"));
  EXPECT_NEAR(mass_, 3 * 7.85, 1e-12);
  refuse(deck("*Fixed Mass Scaling, factor=4., elset=Tip\n"), "*FIXED MASS SCALING: there is no element set \"Tip\"");
  refuse(deck("*Fixed Mass Scaling, factor=-4.\n"), "*FIXED MASS SCALING, FACTOR must be > 0");
  refuse(deck("*Fixed Mass Scaling, factor=4.\n", gravity),
         "GRAV with *FIXED MASS SCALING, FACTOR (line 52): weight is of the mass that is not scaled");
  refuse(deck("*Fixed Mass Scaling, dt=5e-5\n", gravity), "*VARIABLE MASS SCALING goes with it");
  refuse(part("C3D8") + steel() +
             step("*Variable Mass Scaling, dt=5e-5\n", "*Dynamic, Explicit, direct user control\n1e-6, 1e-4\n"),
         "handler.step: is for integrator.step = \"auto\", and 1e-06 s is given");
  refuse(deck("*Variable Mass Scaling, dt=5e-5\n", "*Bulk Viscosity\n"),
         "handlers do not go with elements that damp (deck.inp:");
  refuse(deck("*Variable Mass Scaling, dt=5e-5\n", "*Dload\n1, P1, 1.\n"),
         "handlers do not go with loads and motions that change in time (deck.inp:");
  for (const std::string command : {"run deck.inp --out x", "inspect deck.inp"}) {
    refuse(deck("*Fixed Mass Scaling, dt=5e-5, type=UNIFORM\n"),
           "TYPE=UNIFORM: gives mass to elements that do not need", command);
    refuse(deck("*Variable Mass Scaling, dt=5e-5, elset=First\n"), "mass is added for the step of the whole", command);
    for (const std::string set : {"", ", elset=Second"})
      refuse(deck("*Fixed Mass Scaling, factor=4." + set + "\n*Fixed Mass Scaling, factor=9." + set + "\n"),
             "*FIXED MASS SCALING gives a second time what line 52 gives", command);
    refuse(deck("*Variable Mass Scaling, dt=5e-5, element layers=2\n"), "ELEMENTLAYERS=2 is not taken", command);
    refuse(deck("*Variable Mass Scaling, frequency=2\n"), "*VARIABLE MASS SCALING needs DT=", command);
    refuse(deck("*Fixed Mass Scaling, dt=5e-5\n*Fixed Mass Scaling, dt=6e-5\n"),
           "*FIXED MASS SCALING gives a second time what line 52 gives", command);
  }
}

// Point masses, springs and dashpots, in the assembly and in the part.
TEST_F(ExplicitDecks, TakeMassesSpringsAndDashpots) {
  const std::string links =
      "*Element, type=MASS, elset=Points\n1001, Bar-1.9\n1002, Bar-1.10\n*Mass, elset=Points\n0.25,\n"
      "*Element, type=SpringA, elset=Across\n1003, Bar-1.9, Bar-1.12\n*Spring, elset=Across\n\n1e8\n"
      "*Element, type=Spring1, elset=Ground\n1004, Bar-1.11\n1005, Bar-1.12\n*Spring, elset=Ground\n3\n2e7\n"
      "*Element, type=DashpotA, elset=Damper\n1006, Bar-1.10, Bar-1.11\n*Dashpot, elset=Damper\n\n500.\n"
      "*Element, type=Dashpot1, elset=Slide\n1007, Bar-1.9\n*Dashpot, elset=Slide\n2\n300.\n";
  const std::string scene = std::string(stvk) + fixed +
                            "[[force]]\nset = \"Tip\"\neach = [-1e4, 0, 0]\n[[mass]]\nset = \"#9\"\nmass = "
                            "0.25\n[[mass]]\nset = \"#10\"\nmass = 0.25\n[[spring]]\nset = \"#9\"\nto_set = "
                            "\"#12\"\nstiffness = 1e8\n[[spring]]\nset = \"#11,12\"\nstiffness = 2e7\ndirection = [0, "
                            "0, 1]\n[[spring]]\nset = \"#10\"\nto_set = \"#11\"\nstiffness = 0\ndamping = "
                            "500\n[[spring]]\nset = \"#9\"\nstiffness = 0\ndamping = 300\ndirection = [0, 1, 0]\n";
  const auto deck = [&](const std::string& more) {
    return part("C3D8") + steel() + more + step("*Cload\nTip, 1, -1e4\n");
  };
  expectSame(deck(links), scene);
  EXPECT_NEAR(mass_, 15.7 + 0.5, 1e-12);
  std::string inPart = deck("");
  std::string ofPart = links;
  for (std::size_t at; (at = ofPart.find("Bar-1.")) != std::string::npos;) ofPart.erase(at, 6);
  inPart.insert(inPart.find("*End Part"), ofPart);
  expectSame(inPart, scene);
  // One spring of twice the stiffness, and two at the same node.
  const std::string one = "*Element, type=Spring1, elset=G\n1, 9\n2, 9\n*Spring, elset=G\n1\n1e8\n";
  expectSame(deck(one), std::string(stvk) + fixed +
                            "[[force]]\nset = \"Tip\"\neach = [-1e4, 0, 0]\n[[spring]]\nset = \"#9\"\nstiffness = "
                            "2e8\ndirection = [1, 0, 0]\n");
  const auto refuseAll = [&](const std::string& more, const std::string& what) {
    for (const std::string command : {"run deck.inp --out x", "inspect deck.inp"}) refuse(deck(more), what, command);
  };
  refuseAll("*Element, type=Spring2, elset=S\n1, 9, 10\n*Spring, elset=S\n1, 1\n1e8\n",
            "*SPRING: \"S\" is the ELSET of no such elements above; SPRING1 and SPRINGA are taken");
  refuseAll("*Element, type=SpringA, elset=S\n1, 9, 10\n", "*ELEMENT, TYPE=SPRINGA: no *SPRING names its ELSET");
  refuseAll("*Element, type=SpringA, elset=S\n1, 9, 10\n*Spring, elset=S, nonlinear\n-1., -1.\n1., 1.\n",
            "*SPRING, NONLINEAR: springs here are linear");
  refuseAll("*Element, type=SpringA, elset=S\n1, 9, 10\n*Spring, elset=S\n1e8, 20.\n",
            "has 2 numbers; it must have one");
  refuseAll("*Element, type=Spring1, elset=S\n1, 9\n*Spring, elset=S\n4\n1e8\n",
            "degree of freedom 4 is none of a solid's");
  refuseAll("*Element, type=MASS, elset=S\n1, 9\n*Mass, elset=S, alpha=2.\n1.\n",
            "*MASS, ALPHA=2. is not taken; ELSET are");
  refuseAll("*Element, type=MASS, elset=S\n1, 9, 10\n*Mass, elset=S\n1.\n",
            "MASS has 3 entries; it must have a number and 1 node");
}

// A cube falls on another: in general contact, and by a pair of surfaces of elements or of one of nodes.
TEST_F(ExplicitDecks, LetSurfacesTouch) {
  const std::string cubes =
      "*NODE, NSET=Nall\n1, 0, 0, 0\n2, 0.1, 0, 0\n3, 0.1, 0.1, 0\n4, 0, 0.1, 0\n5, 0, 0, 0.1\n6, 0.1, 0, 0.1\n"
      "7, 0.1, 0.1, 0.1\n8, 0, 0.1, 0.1\n11, 0.02, 0.02, 0.101\n12, 0.08, 0.02, 0.101\n13, 0.08, 0.08, 0.101\n"
      "14, 0.02, 0.08, 0.101\n15, 0.02, 0.02, 0.161\n16, 0.08, 0.02, 0.161\n17, 0.08, 0.08, 0.161\n18, 0.02, 0.08, "
      "0.161\n*ELEMENT, TYPE=C3D8, ELSET=Lower\n1, 1, 2, 3, 4, 5, 6, 7, 8\n*ELEMENT, TYPE=C3D8, ELSET=Upper\n2, 11, "
      "12, "
      "13, 14, 15, 16, 17, 18\n*ELSET, ELSET=All\nLower, Upper\n*NSET, NSET=Root\n1, 2, 3, 4\n*NSET, NSET=Top\n11, 12, "
      "13, 14, 15, 16, 17, 18\n*SOLID SECTION, ELSET=All, MATERIAL=soft\n*MATERIAL, NAME=soft\n*ELASTIC\n30e3, "
      "0.3\n*DENSITY\n1000.\n*INITIAL CONDITIONS, TYPE=VELOCITY\nTop, 3, -0.5\nTop, 1, 0.1\n*BOUNDARY\nRoot, PINNED\n";
  const std::string property =
      "*SURFACE INTERACTION, NAME=Int\n*FRICTION\n0.2,\n*SURFACE BEHAVIOR, "
      "PRESSURE-OVERCLOSURE=HARD\n";
  const std::string end = "*STEP, NLGEOM\n*DYNAMIC, EXPLICIT, DIRECT USER CONTROL\n2e-4, 0.01\n";
  const std::string scene =
      "[material]\nmodel = \"stvk\"\nyoung = 30e3\npoisson = 0.3\ndensity = 1000\n[[fix]]\nset = "
      "\"Root\"\n[[initial]]\n"
      "set = \"Top\"\nvelocity = [0.1, 0, -0.5]\n[[contact]]\nwith = \"surface\"\n";
  const std::string fixing = "step = 2e-4\nend = 0.01\n";
  expectSame(cubes + property + end +
                 "*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n*CONTACT PROPERTY ASSIGNMENT\n, , Int\n*END STEP\n",
             scene + "friction = 0.2\n", fixing);
  EXPECT_THAT(out_, HasSubstr("contact is by penalty here, of a stiffness at the nodes"));
  const Table rows = table("d/history.csv");
  EXPECT_LT(rows.number(rows.rows.size() - 1, "kinetic_J"), 0.9 * rows.number(0, "kinetic_J"));  // it has touched

  const std::string lower = "set = \"#5,6,7,8\"\n", upper = "set = \"#11,12,13,14\"\n";
  const std::string surfaces = "*SURFACE, NAME=Under\nLower, S2\n*SURFACE, NAME=Over\nUpper, S1\n";
  expectSame(cubes + property + surfaces +
                 "*CONTACT PAIR, INTERACTION=Int, MECHANICAL CONSTRAINT=KINEMATIC\nOver, "
                 "Under\n" +
                 end + "*END STEP\n",
             scene + "friction = 0.2\n" + upper + "to_" + lower + "[[contact]]\nwith = \"surface\"\nfriction = 0.2\n" +
                 lower + "to_" + upper,
             fixing);
  EXPECT_THAT(out_, HasSubstr("MECHANICALCONSTRAINT=KINEMATIC: contact here is by penalty"));
  expectSame(cubes +
                 "*SURFACE, NAME=Over, TYPE=NODE\n11\n12\n13,\n14, 1.\n*SURFACE, NAME=Under\nLower, S2\n*SURFACE "
                 "INTERACTION, NAME=Int\n*CONTACT PAIR, INTERACTION=Int, TYPE=NODE TO SURFACE\nOver, Under\n" +
                 end + "*END STEP\n",
             scene + upper + "to_" + lower, fixing);

  for (const std::string command : {"run deck.inp --out x", "inspect deck.inp"}) {
    const auto refused = [&](const std::string& more, const std::string& what) {
      refuse(cubes + property + surfaces + more + end + "*END STEP\n", what, command);
    };
    refused("*CONTACT PAIR, INTERACTION=None\nOver, Under\n", "contact: there is no *SURFACE INTERACTION \"NONE\"");
    refused("*CONTACT PAIR, INTERACTION=Int\nOver, Nowhere\n", "*CONTACT PAIR: there is no *SURFACE \"NOWHERE\"");
    refused("*CONTACT PAIR, INTERACTION=Int, ADJUST=0.1\nOver, Under\n", "ADJUST=0.1: moves nodes before the start");
    refused("*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n1e9\n", "PRESSURE-OVERCLOSURE=LINEAR: its pressure goes");
    refused("*SURFACE INTERACTION, NAME=j\n*FRICTION\n0.1, 2.\n", "*FRICTION has more than one number");
    refused("*CONTACT INCLUSIONS, ALL EXTERIOR\n*CONTACT PAIR, INTERACTION=Int\nOver, Under\n",
            "contact beside that of all surfaces, which has it already");
    refused("*CONTACT\n*CONTACT INCLUSIONS\nOver, Under\n", "*CONTACT INCLUSIONS: ALL EXTERIOR is taken");
    refused("*CONTACT PROPERTY ASSIGNMENT\nOver, Under, Int\n", "its interaction is of all surfaces here");
    refused("*CONTACT EXCLUSIONS\nOver, Under\n", "*CONTACT EXCLUSIONS: of contact *CONTACT PAIR");
    refused("*SURFACE, NAME=Edge\nLower, E1\n", "*SURFACE: \"E1\" is no face of a solid");
  }
}

TEST_F(ExplicitDecks, HoldBySymmetryAndAntisymmetry) {
  for (const auto& [label, held] :
       {std::pair("XSYMM", "x"), {"YSYMM", "y"}, {"ZSYMM", "z"}, {"XASYMM", "yz"}, {"YASYMM", "xz"}, {"ZASYMM", "xy"}})
    expectSame(
        part("C3D8") + steel() +
            step("*Cload\nTip, 1, 1e4\nTip, 2, 2e4\nTip, 3, 3e4\n", "*Dynamic, Explicit\n, 1e-4\n",
                 joinText("*Boundary\nFix, ", label, "\n")),
        joinText(stvk, fixed, "components = \"", held, "\"\n[[force]]\nset = \"Tip\"\neach = [1e4, 2e4, 3e4]\n"));
}

TEST_F(ExplicitDecks, TakeNodesAndElementsThatAreMade) {
  use("nodes.inp",
      "*NODE\n1, 0, 0, 0\n3, 0.2, 0, 0\n*SYSTEM\n0, 0.1, 0\n*NODE\n11, 0\n13, 0.2\n*NGEN\n1, 3\n11, 13, 1\n"
      "*SYSTEM\n0, 0, 0.1\n*NODE, NSET=Front\n101, 0\n111, 0, 0.1\n*NODE, NSET=Back\n103, 0.2\n113, 0.2, 0.1\n"
      "*SYSTEM\n*NFILL\nFront, Back, 2\n");
  expectSame(
      "*INCLUDE, INPUT=nodes.inp\n*ELEMENT, TYPE=C3D8\n1, 1, 2, 12, 11, 101, 102, 112, 111\n*ELGEN, ELSET=All\n1, "
      "2\n*NSET, NSET=Root\n1, 11, 101, 111\n*SOLID SECTION, ELSET=All, MATERIAL=Steel\n" +
          steel() + step("*Cload\n103, 1, 1e4\n", "*Dynamic, Explicit\n, 1e-4\n", "*Boundary\nRoot, PINNED\n"),
      std::string(stvk) +
          "[[fix]]\nwhere = \"x < 1e-6\"\n[[force]]\nwhere = \"x > 0.199 && y < 1e-6 && z > "
          "0.099\"\neach = [1e4, 0, 0]\n",
      "step = \"auto\"\nend = 1e-4\n",
      "generate = \"bar\"\nsize = [0.2, 0.1, 0.1]\ncells = [2, 1, 1]\nelement = \"hex8\"\n");
}

// A surface of elements without faces is all that lies outside.
TEST_F(ExplicitDecks, PressAllThatLiesOutside) {
  expectSame(part("C3D8") + "*Surface, name=Skin\nBar-1.All,\n" + steel() + step("*Dsload\nSkin, P, 1e6\n"),
             std::string(stvk) + fixed + "[[pressure]]\nwhere = \"all\"\npressure = 1e6\n");
}

// The step that a deck fixes is held, and is found unstable where it is.
TEST_F(ExplicitDecks, JudgeAFixedStep) {
  const std::string loads = "*Cload\nTip, 1, 1.\n";
  const std::string scene = std::string(stvk) + fixed + "[[force]]\nset = \"Tip\"\neach = [1, 0, 0]\n";
  expectSame(part("C3D8") + steel() + step(loads, "*Dynamic, Explicit, direct user control\n1e-5, 1e-4\n"), scene,
             "step = 1e-5\nend = 1e-4\n");
  EXPECT_EQ(json("d/summary.json")["verdict"], "certified");
  expectSame(part("C3D8") + steel() + step(loads, "*Dynamic, Explicit, direct user control\n2e-5, 1e-4\n"), scene,
             "step = 2e-5\nend = 1e-4\n");
  EXPECT_EQ(json("d/summary.json")["verdict"], "violated");
  expectSame(part("C3D8") + steel() + step(loads, "*Dynamic, Explicit, element by element, scale factor=0.5\n, 1e-4\n"),
             scene, "step = \"auto\"\nend = 1e-4\nsafety = 0.5\n");
  EXPECT_THAT(out_, HasSubstr("ELEMENTBYELEMENT: the program's own estimate"));
  expectSame(part("C3D8") + steel() + step(loads, "*Dynamic, Explicit\n1e-6, 1e-4\n"), scene);
  EXPECT_THAT(out_, HasSubstr("*DYNAMIC, first increment 1e-06 s: it does not bound the step"));
  refuse(part("C3D8", "*Solid Section, elset=All, material=Steel\n,\n0.5\n") + steel() + step(loads),
         "*SOLID SECTION has a second line; it has one");
  refuse(part("C3D8", "*Solid Section, elset=All, material=Steel\nthick\n") + steel() + step(loads),
         "a number of *SOLID SECTION");
  // Of the safe step of the first state, kept to the end.
  expectSame(part("C3D8") + steel() + step(loads, "*Dynamic, Explicit, fixed time incrementation\n, 1e-4\n"), scene,
             "step = \"auto\"\nhold = true\nend = 1e-4\n");
  const Json held = json("d/summary.json");
  EXPECT_EQ(held["smallest_step"], held["largest_step"]);
  const double safe = table("d/history.csv").number(0, "safe_s");
  EXPECT_NEAR(held["largest_step"].get<double>(), 0.95 * safe, 1e-12 * safe);
}

// What central differences keep is not the energy at whole steps: one node that is thrown has most of its energy in the
// highest modes. No certified run is called unstable for it, and one above the critical step is.
TEST_F(ExplicitDecks, KeepTheEnergyOfCentralDifferences) {
  for (const std::string set : {"Bar-1.7", "Bar-1.Tip"}) {
    folder_.write("thrown.inp", part("C3D8") + steel() + "*Initial Conditions, type=VELOCITY\n" + set + ", 1, 0.01\n" +
                                    step("", "*Dynamic, Explicit\n, 4e-3\n"));
    for (const char* more : {"", " --set integrator.safety=0.99", " --set integrator.method=verlet"}) {
      const Outcome outcome =
          call("run thrown.inp --out d --set output.picture=false --set output.history_every=1" + std::string(more));
      EXPECT_EQ(outcome.status, 0) << set << more << outcome.out;
      EXPECT_EQ(json("d/summary.json")["verdict"], "certified") << set << more;
    }
    const double critical = json("d/summary.json")["why"]["optimistic"];
    const Outcome lost =
        call(fmt::format("run thrown.inp --out d --set output.picture=false --set integrator.step={:.6g} --set "
                         "monitor.on_violation=warn --set monitor.bracket=false",
                         1.02 * critical));
    EXPECT_EQ(lost.status, 1) << lost.out << lost.err;
    EXPECT_EQ(json("d/summary.json")["verdict"], "unstable");
  }
}

// A rigid body goes by its reference node, which is of no element and has a number that a node of the part has, too.
TEST_F(ExplicitDecks, TakeRigidBodies) {
  const std::string steelPart = [] {
    std::string text = part("C3D8");
    const std::string end = "*End Assembly\n";
    return text.replace(
        text.find(end), end.size(),
        "*Node\n1, 0.3, 0., 0.\n*Nset, nset=RP\n1,\n*Rigid Body, ref node=RP, elset=Bar-1.Second\n" + end);
  }() + steel();
  const std::string rigid = std::string(stvk) + "[[rigid]]\nname = \"head\"\nset = \"#2,3,6,7,9,10,11,12\"\n";
  const std::string held = std::string(fixed);
  // Held altogether, at its node or by its number.
  const std::string amplitude = "*Amplitude, name=Ramp, definition=SMOOTH STEP\n0., 0., 1e-4, 1.\n";
  const std::string ramp = "times = [0, 1e-4]\nfactors = [0, 1]\nramp = \"quintic\"\n";
  expectSame(steelPart + amplitude +
                 step("*Cload\nTip, 2, 1.\n*Cload, amplitude=Ramp\nRoot, 1, 1e3\n", "*Dynamic, Explicit\n, 1e-4\n",
                      "*Boundary\nRP, ENCASTRE\n"),
             rigid +
                 "[[fix]]\nrigid = \"head\"\n[[force]]\nset = \"Tip\"\neach = [0, 1, 0]\n[[force]]\nset = "
                 "\"Root\"\neach = [1e3, 0, 0]\n" +
                 ramp);
  // Free: it moves by the forces at its nodes.
  expectSame(steelPart + step("*Cload\nTip, 2, 1e3\n"),
             rigid + held + "[[force]]\nset = \"Tip\"\neach = [0, 1e3, 0]\n");
  // Moved along x, without turning.
  expectSame(steelPart + amplitude +
                 step("*Boundary, amplitude=Ramp\nRP, 1, 1, 1e-4\n", "*Dynamic, Explicit\n, 1e-4\n",
                      "*Boundary\nFix, ENCASTRE\nRP, 2, 6\n"),
             rigid + held + "[[move]]\nrigid = \"head\"\ndisplacement = [1e-4, 0, 0]\n" + ramp);
  // Guided: free along x.
  expectSame(
      steelPart + step("*Cload\nTip, 1, 1e3\n", "*Dynamic, Explicit\n, 1e-4\n",
                       "*Boundary\nFix, ENCASTRE\n1, 2, 3\nRP, 4, 6\n"),
      rigid + held + "[[fix]]\nrigid = \"head\"\ncomponents = \"yz\"\n[[force]]\nset = \"Tip\"\neach = [1e3, 0, 0]\n");
  // CalculiX has a node of its own for the rotations, its degrees of freedom 1 to 3.
  std::string turned = steelPart;
  turned.replace(turned.find("ref node=RP,"), 12, "ref node=RP, rot node=98,");
  expectSame(
      turned + step("*Cload\nTip, 1, 1e3\n", "*Dynamic, Explicit\n, 1e-4\n",
                    "*Boundary\nFix, ENCASTRE\nRP, 2, 3\n98, 1, 3\n"),
      rigid + held + "[[fix]]\nrigid = \"head\"\ncomponents = \"yz\"\n[[force]]\nset = \"Tip\"\neach = [1e3, 0, 0]\n");
  refuse(turned + step("", "*Dynamic, Explicit\n, 1e-4\n", "*Boundary\n98, 1, 3\n"),
         "must have all of its rotations held");
  refuse(steelPart + step("", "*Dynamic, Explicit\n, 1e-4\n", "*Boundary\nRP, PINNED\n"),
         "*RIGID BODY: its reference node must have all of its rotations held, or be free altogether");
  refuse(steelPart + step("", "*Dynamic, Explicit\n, 1e-4\n", "*Boundary\nRP, 2, 4\n"),
         "must have all of its rotations held");
  // What else is of it is for nodes of the mesh, and not for the node of the part with its number.
  const std::string velocity = "*Initial Conditions, type=VELOCITY\n";
  std::string plain = steelPart;
  plain.erase(plain.find("*Rigid Body"), plain.find("*End Assembly") - plain.find("*Rigid Body"));
  for (const auto& [deck, why] : {std::pair(steelPart, "is the reference node of a *RIGID BODY and of no solid"),
                                  {plain, "is of no solid element of the mesh"}})
    for (const std::string node : {"RP", "1"}) {
      const std::string named = (node == "1" ? "node of the assembly 1 " : "\"RP\" ") + std::string(why);
      refuse(deck + step("*Cload\n" + node + ", 1, 1e3\n"), "*CLOAD: " + named);
      refuse(deck + velocity + node + ", 1, 2.\n" + step(""), "*INITIAL CONDITIONS: " + named);
      std::string heavy = deck;
      heavy.insert(heavy.find("*End Assembly"), "*Element, type=MASS, elset=m\n1, " + node + "\n*Mass, elset=m\n3.\n");
      refuse(heavy + step(""), "*ELEMENT, TYPE=MASS: " + named);
    }
  refuse(plain + step("", "*Dynamic, Explicit\n, 1e-4\n", "*Boundary\n1, 1, 3\n"),
         "*BOUNDARY: node of the assembly 1 is of no solid element");
  refuse(part("C3D8") + steel() + "*Rigid Body, ref node=Tip, elset=Second\n" + step(""),
         "*RIGID BODY: REF NODE must be a node, or a set of one node");
  refuse(part("C3D8") + steel() + "*Rigid Body, ref node=1\n" + step(""), "*RIGID BODY has no nodes");
  refuse(part("C3D8") + steel() + "*Rigid Body, ref node=1, analytical surface=Skin\n" + step(""),
         "has no elements; [[obstacle]] of a scene is one");
}

}  // namespace
}  // namespace ringwatch

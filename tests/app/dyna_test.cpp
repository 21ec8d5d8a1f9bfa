// LS-DYNA decks as scenes: each deck is the same body and run as a scene of its mesh, and what is left out and refused.
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <ringwatch/app/scene/dyna_keywords.h>
#include <ringwatch/meshes/mesh_io.h>

#include "deck_program.h"

namespace ringwatch::dyna_decks {
namespace {

using test::Json;
using ::testing::AllOf;
using ::testing::HasSubstr;

/// A card: fields of ten columns.
template <class... Fields>
std::string card(const Fields&... fields) {
  std::string text;
  ((text += fmt::format("{:>10}", fields)), ...);
  return text + "\n";
}
/// A keyword with its cards.
template <class... Cards>
std::string keyword(const std::string& name, const Cards&... cards) {
  return "*" + name + "\n" + (std::string() + ... + cards);
}
std::string points(const std::vector<std::array<double, 2>>& all) {
  std::string text;
  for (const auto& [time, value] : all) text += fmt::format("{:>20}{:>20}\n", time, value);
  return text;
}

struct Node {
  int id;
  double x, y, z;
  int held = 0;
};
std::string nodes(const std::vector<Node>& all) {
  std::string text = "*NODE\n$#   nid               x               y               z      tc      rc\n";
  for (const Node& n : all)
    text += fmt::format("{:8}{:16}{:16}{:16}{}\n", n.id, n.x, n.y, n.z, n.held == 0 ? "" : fmt::format("{:8}", n.held));
  return text;
}
/// One line an element, or two, as "(ten nodes format)" has it.
std::string solids(int part, const std::vector<std::vector<int>>& all, bool twoLines = false) {
  std::string text = twoLines ? "*ELEMENT_SOLID (ten nodes format)\n" : "*ELEMENT_SOLID\n";
  static int next = 0;
  for (const std::vector<int>& own : all) {
    text += fmt::format("{:8}{:8}{}", 100 * part + ++next % 100, part, twoLines ? "\n" : "");
    for (const int node : own) text += fmt::format("{:8}", node);
    text += "\n";
  }
  return text;
}
const std::vector<int> first{1, 2, 3, 4, 5, 6, 7, 8}, second{2, 9, 10, 3, 6, 11, 12, 7};
/// Two cubes of 0.1 m side by side along x, of the parts 1 and `other`, with sets of both ends.
std::string cubes(int other = 1) {
  return nodes({{1, 0, 0, 0},
                {2, 0.1, 0, 0},
                {3, 0.1, 0.1, 0},
                {4, 0, 0.1, 0},
                {5, 0, 0, 0.1},
                {6, 0.1, 0, 0.1},
                {7, 0.1, 0.1, 0.1},
                {8, 0, 0.1, 0.1},
                {9, 0.2, 0, 0},
                {10, 0.2, 0.1, 0},
                {11, 0.2, 0, 0.1},
                {12, 0.2, 0.1, 0.1}}) +
         solids(1, {first}) + solids(other, {second}) +
         keyword("SET_NODE_LIST_TITLE", "root\n", card(1), card(1, 4, 5, 8)) +
         keyword("SET_NODE", card(2), card(9, 10, 11, 12));
}
std::string part(int id, int section, int material, int hourglass = 0) {
  return keyword("PART", "a part\n", card(id, section, material, 0, hourglass));
}
std::string section(int id, int form) { return keyword("SECTION_SOLID", card(id, form)); }
std::string steel(int id = 1) { return keyword("MAT_ELASTIC", card(id, 7850.0, "2.1e11", 0.3)); }
const std::string begin = "$# a deck\n*KEYWORD\n*TITLE\ncubes\n", ending = "*END\n",
                  held = keyword("BOUNDARY_SPC_SET", card(1, 0, 1, 1, 1, 1, 1, 1));
std::string until(double end) { return keyword("CONTROL_TERMINATION", card(end)); }

// What the scenes have, by hand.
const std::string viscosity = "[damping]\nbulk_viscosity = true\nquadratic_bulk_viscosity = 1.5\n",
                  onePoint = "rules = [\"hex8=uniform-strain\"]\nhourglass_stiffness = 0\nhourglass_viscosity = 0.1\n",
                  selectiveRule = "rules = [\"hex8=selective\"]\n",
                  elastic = "[material]\nmodel = \"corotational\"\nyoung = 2.1e11\npoisson = 0.3\ndensity = 7850\n",
                  root = "[[fix]]\nset = \"nodeset-1\"\n";
std::string integrator(double end, double safety = 0.9) {
  return fmt::format("step = \"auto\"\nend = {}\nsafety = {}\n", end, safety);
}
/// Of a shear modulus and Poisson's ratio: Pa.
double bulkOf(double shear, double poisson) { return shear / (1 - 2 * poisson) * 2 * (1 + poisson) / 3; }

struct Case {
  std::string name, deck, scene, integrator;
  std::string told = {};  // by run
  std::vector<std::pair<std::string, std::string>> files = {};
};

std::vector<Case> cases() {
  std::vector<Case> all;
  // Moved by a displacement, weighed and pressed.
  all.push_back(
      {"moved",
       begin + until(1e-4) + keyword("CONTROL_TIMESTEP", card(0, 0.8)) + keyword("CONTROL_SOLUTION", card(0)) +
           keyword("CONTROL_DYNAMIC_RELAXATION", card(250, 0.001)) + keyword("CONTROL_IMPLICIT_GENERAL", card(0)) +
           part(1, 1, 1) + section(1, 1) + steel() + cubes() + held +
           keyword("DEFINE_CURVE", card(1, 0, 1, 2), points({{0, 0}, {1e-3, 0.5}})) +
           keyword("BOUNDARY_PRESCRIBED_MOTION_SET", card(2, 1, 2, 1, 0.01)) + keyword("LOAD_BODY_Z", card(1, 9.81)) +
           keyword("LOAD_BODY_X", card(1, -2)) + keyword("LOAD_BODY_Y", card(1, 3)) +
           keyword("LOAD_SEGMENT", card(1, 1e5, 0, 5, 6, 7, 8)) + keyword("DATABASE_GLSTAT", card(1e-3)) + ending,
       elastic + onePoint + root + viscosity +
           "[[move]]\nset = \"nodeset-2\"\ncomponents = \"x\"\ndisplacement = [0.01, 0, 0]\ntimes = [0, "
           "1e-3]\nfactors = [0, 1]\n[[force]]\nwhere = \"all\"\nacceleration = [0, 0, -9.81]\ntimes = [0, "
           "1e-3]\nfactors = [0, 1]\n[[force]]\nwhere = \"all\"\nacceleration = [2, 0, 0]\ntimes = [0, 1e-3]\nfactors "
           "= [0, 1]\n[[force]]\nwhere = \"all\"\nacceleration = [0, -3, 0]\ntimes = [0, 1e-3]\nfactors = [0, "
           "1]\n[[pressure]]\nset = \"#5,6,7,8\"\npressure = 1e5\ntimes = [0, 1e-3]\nfactors = [0, 1]\n",
       integrator(1e-4, 0.8), "*MAT_ELASTIC is corotational: a law of rates there"});
  // Blatz and Ko's rubber, thrown, with the bulk viscosity of the deck.
  all.push_back(
      {"blatz-ko",
       begin + until(1e-2) + part(1, 1, 7) + section(1, 2) + keyword("MAT_BLATZ-KO_RUBBER", card(7, 1000.0, 1e5)) +
           cubes() + keyword("CONTROL_BULK_VISCOSITY", card(1.2, 0.1, 1)) +
           keyword("BOUNDARY_SPC_NODE_ID", "         1 roller\n", card(1, 0, 1, 0, 1), "         2\n",
                   card(4, 0, 0, 0, 1)) +
           keyword("INITIAL_VELOCITY", card(2), card(1.5, 0, -0.5)) + ending,
       fmt::format("[material]\nmodel = \"neo-hookean\"\nyoung = {}\npoisson = 0.463\ndensity = 1000\n", 2e5 * 1.463) +
           selectiveRule +
           "[[fix]]\nset = \"#1\"\ncomponents = \"xz\"\n[[fix]]\nset = \"#4\"\ncomponents = "
           "\"z\"\n[[initial]]\nset = \"nodeset-2\"\nvelocity = [1.5, 0, "
           "-0.5]\n[damping]\nbulk_viscosity = true\nlinear_bulk_viscosity = 0.1\nquadratic_bulk_viscosity "
           "= 1.2\n",
       integrator(1e-2), "*MAT_BLATZ-KO_RUBBER is neo-hookean"});
  // Numbers between commas, and a force on each node of a set.
  all.push_back({"mooney-rivlin",
                 begin + until(1e-2) + part(1, 1, 27) +
                     "*SECTION_SOLID\n1,-1\n*MAT_MOONEY-RIVLIN_RUBBER\n27, 1000., "
                     ".49, 8.+4, 2e4\n\n" +
                     cubes() + held + "*DEFINE_CURVE\n3\n0.,1.\n1.,1.\n*LOAD_NODE_SET\n2,3,3,-20.\n" +
                     keyword("DAMPING_GLOBAL", card(0, 12.0)) + ending,
                 fmt::format("[material]\nmodel = \"mooney-rivlin\"\nc10 = 8e4\nc01 = 2e4\nbulk = {}\ndensity = 1000\n",
                             bulkOf(2e5, 0.49)) +
                     selectiveRule + root + viscosity +
                     "mass = 12\n[[force]]\nset = \"nodeset-2\"\neach = [0, 0, -20]\n",
                 integrator(1e-2), "ELFORM = -1: hex8 with selective: LS-DYNA changes the strain"});
  // Yeoh's rubber with hourglass control of stiffness, and single nodes that begin to move.
  all.push_back({"yeoh",
                 begin + until(1e-2) + part(1, 1, 77, 4) + section(1, 1) + keyword("HOURGLASS", card(4, 5, 0.05)) +
                     keyword("MAT_HYPERELASTIC_RUBBER", card(77, 1000.0, 0.48, 0), card(1e5, 0, 0, -1e3, 0, 100)) +
                     cubes() + held + keyword("INITIAL_VELOCITY_NODE", card(9, 0, 0.2, 0), card(10, 0, 0.2, 0.1)) +
                     ending,
                 fmt::format("[material]\nmodel = \"yeoh\"\nc10 = 1e5\nc20 = -1e3\nc30 = 100\nbulk = {}\ndensity = "
                             "1000\nrules = [\"hex8=uniform-strain\"]\n",
                             bulkOf(2e5, 0.48)) +
                     root + viscosity +
                     "[[initial]]\nset = \"#9\"\nvelocity = [0, 0.2, 0]\n[[initial]]\nset = \"#10\"\nvelocity = [0, "
                     "0.2, 0.1]\n",
                 integrator(1e-2), "IHQ = 5: the hourglass control here is of stiffness"});
  // Two rubbers that turn.
  all.push_back(
      {"two-rubbers",
       begin + until(1e-2) + part(1, 1, 1) + part(2, 1, 2) + section(1, 2) +
           keyword("MAT_077_H", card(1, 1000.0, 0.48), card(8e4, 2e4)) +
           keyword("MAT_OGDEN_RUBBER_TITLE", "softer\n", card(2, 900.0, 0.45), card(1e5, -4e4), card(2, -2)) +
           cubes(2) + keyword("SET_PART_LIST_GENERATE", card(5), card(1, 2)) +
           keyword("SET_PART_LIST", card(6), card(1)) +
           keyword("INITIAL_VELOCITY_GENERATION", card(5, 1, 3.0, 0.1, 0, 0), card(0.1, 0.05, 0.05, 0, 2, 0)) + ending,
       fmt::format("[[material]]\nset = \"part-1\"\nmodel = \"mooney-rivlin\"\nc10 = 8e4\nc01 = 2e4\nbulk = "
                   "{}\ndensity = 1000\n{}[[material]]\nset = \"part-2\"\nmodel = \"mooney-rivlin\"\nc10 = "
                   "5e4\nc01 = 2e4\nbulk = {}\ndensity = 900\n",
                   bulkOf(2e5, 0.48), selectiveRule, bulkOf(1.4e5, 0.45)) +
           viscosity +
           "[[initial]]\nwhere = \"all\"\nvelocity = [0.1, 0, 0]\nangular_velocity = [0, 3, 0]\npoint = "
           "[0.1, 0.05, 0.05]\n",
       integrator(1e-2)});
  // A rigid part that is pulled and turns about an axis.
  all.push_back({"rigid",
                 begin + until(1e-4) + part(1, 1, 1) + part(2, 1, 2) + section(1, 1) + steel() +
                     keyword("MAT_RIGID", card(2, 7850.0, "2.1e11", 0.3), card(1, 2, 4), card(0)) + cubes(2) +
                     keyword("DEFINE_CURVE_TITLE", "pull\n", card(1), points({{0, 0}, {1e-4, 2}, {1, 2}})) +
                     keyword("BOUNDARY_PRESCRIBED_MOTION_RIGID", card(2, 1, 0, 1, 0.5)) + ending,
                 "[[material]]\nset = \"part-1\"\n" + elastic.substr(elastic.find('\n') + 1) + onePoint +
                     "[[material]]\nset = \"part-2\"\n" + elastic.substr(elastic.find('\n') + 1) +
                     "[[rigid]]\nname = \"block\"\nset = \"part-2\"\n" + viscosity +
                     "[[move]]\nrigid = \"block\"\ncomponents = \"xy\"\nturns = true\naxis = [0, 0, 1]\nvelocity = "
                     "[0.5, 0, 0]\ntimes = [0, 1e-4, 1]\nfactors = [0, 2, 2]\n",
                 integrator(1e-4)});
  // Hexahedra that hold a node several times: a tetrahedron and a pyramid on a cube, and a wedge.
  all.push_back({"collapsed",
                 begin + until(1e-4) + part(1, 1, 1) + section(1, 1) + steel() +
                     nodes({{1, 0, 0, 0},
                            {2, 0.1, 0, 0},
                            {3, 0.1, 0.1, 0},
                            {4, 0, 0.1, 0},
                            {5, 0, 0, 0.1},
                            {6, 0.1, 0, 0.1},
                            {7, 0.1, 0.1, 0.1},
                            {8, 0, 0.1, 0.1},
                            {20, 0.05, 0.05, 0.18},
                            {21, 0.2, 0, 0},
                            {22, 0.2, 0.1, 0},
                            {23, 0.1, 0.05, 0.2}}) +
                     solids(1, {first, {5, 6, 7, 8, 20, 20, 20, 20}}) +
                     solids(1, {{2, 21, 22, 3, 6, 6, 7, 7}, {6, 7, 20, 23, 23, 23, 23, 23, 0, 0}}, true) +
                     keyword("SET_NODE_LIST_GENERATE", card(1), card(1, 1, 2, 5, 9, 19)) + held +
                     keyword("INITIAL_VELOCITY_GENERATION", card(1, 2, 0, 0, 0, -1.0), card(0)) + ending,
                 elastic +
                     "rules = [\"hex8=uniform-strain\", \"wedge6=fierz2013\", \"tet4=gauss-1\", "
                     "\"pyramid5=collapsed-2x2x2\"]\nhourglass_stiffness = 0\nhourglass_viscosity = 0.1\n" +
                     root + viscosity + "[[initial]]\nwhere = \"all\"\nvelocity = [0, 0, -1]\n",
                 integrator(1e-4),
                 "ELFORM = 1: wedge6 with fierz2013: LS-DYNA integrates it as a hexahedron that holds a"});
  // Tetrahedra of ten nodes in the long format.
  const auto wide = [](const std::vector<std::string>& fields) {
    std::string text;
    for (const std::string& field : fields) text += fmt::format("{:>20}", field);
    return text + "\n";
  };
  const std::array<std::array<const char*, 3>, 10> corners{{{"0", "0", "0"},
                                                            {"2", "0", "0"},
                                                            {"0", "2", "0"},
                                                            {"0", "0", "2"},
                                                            {"1", "0", "0"},
                                                            {"1", "1", "0"},
                                                            {"0", "1", "0"},
                                                            {"0", "0", "1"},
                                                            {"1", "0", "1"},
                                                            {"0", "1", "1"}}};
  std::string tetrahedron = "*NODE\n";
  for (std::size_t i = 0; i < corners.size(); ++i)
    tetrahedron += wide({std::to_string(i + 1), corners[i][0], corners[i][1], corners[i][2]});
  tetrahedron += "*ELEMENT_SOLID\n" + wide({"1", "1"}) + wide({"1", "2", "3", "4", "5", "6", "7", "8", "9", "10"});
  all.push_back({"long",
                 "*KEYWORD LONG=Y\n*CONTROL_TERMINATION -\n" + card(1e-3) + "*PART\nx\n" + wide({"1", "1", "1"}) +
                     "*SECTION_SOLID\n" + wide({"1", "17"}) + "*MAT_001-\n" + card(1, 7850.0, "2.1e11", 0.3) +
                     tetrahedron + "*INITIAL_VELOCITY\n" + wide({"0"}) + wide({"0.1", "0", "0"}) +
                     "*BOUNDARY_SPC_NODE\n" + wide({"1", "0", "1", "1", "1"}) + ending,
                 elastic + viscosity + "[[fix]]\nset = \"#1\"\n[[initial]]\nwhere = \"all\"\nvelocity = [0.1, 0, 0]\n",
                 integrator(1e-3), "ELFORM = 17: tet10 with keast-4: LS-DYNA has a tetrahedron of pieces"});
  // Files that a deck includes, point masses, shells that are left out, a set of segments from inside and outside.
  all.push_back(
      {"included",
       begin + until(1e-4) + "*INCLUDE\nmesh +\n.k\nmore.k\n" + part(1, 1, 1) + section(1, 2) + steel() + held +
           keyword("DEFINE_CURVE", card(2), points({{0, 1}, {1, 1}})) +
           keyword("LOAD_NODE_POINT", card(9, 2, 2, 50.0)) +
           keyword("SET_SEGMENT", card(8), card(9, 10, 12, 11), card(5, 8, 7, 6)) +
           keyword("LOAD_SEGMENT_SET", card(8, 2, 1e4)) + ending + "what stands here is not read\n",
       elastic + selectiveRule + root + viscosity +
           "[[mass]]\nset = \"#9\"\nmass = 0.5\n[[mass]]\nset = \"#10\"\nmass = 0.5\n[[force]]\nset = \"#9\"\neach = "
           "[0, "
           "50, 0]\n[[pressure]]\nset = \"#9,10,11,12\"\npressure = 1e4\n[[pressure]]\nset = \"#5,6,7,8\"\npressure = "
           "-1e4\n",
       integrator(1e-4),
       "more.k:4: *ELEMENT_SHELL, 3 of them: elements that are no solids are left out, and the body is without",
       {{"mesh.k", cubes() + ending},
        {"more.k",
         "*ELEMENT_MASS\n     301       9             0.5       1\n     302      10             0.5\n"
         "*ELEMENT_SHELL\n     401       9       1       2       3       4\n     402       9       1       4  "
         "     8       5\n*ELEMENT_BEAM\n     403       9       1       4\n*SECTION_SHELL\n         9\n*NODE\n      31 "
         "            0.5\n*ELEMENT_SHELL\n     404       9      "
         " 2       3      31      31\n" +
             part(9, 9, 1) + keyword("BOUNDARY_SPC_NODE", card(31, 0, 1, 1, 1)) +
             keyword("INITIAL_VELOCITY_NODE", card(31, 1.0)) +
             keyword("INITIAL_VELOCITY_GENERATION", card(9, 2, 0, 1.0), card(0))}}});
  // Damping of stiffness of a part, numbers of ten columns, nodes that *NODE holds, and one that moves.
  all.push_back({"damped",
                 "*KEYWORD I10=Y\n" + until(1e-4) + keyword("CONTROL_HOURGLASS", card(2, 0.08)) + part(1, 1, 1) +
                     section(1, 1) + steel() + keyword("DAMPING_PART_STIFFNESS", card(1, -1e-7)) + "*NODE\n" +
                     [] {
                       std::string text;
                       const std::array<std::array<double, 3>, 8> corners8{
                           {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
                       for (std::size_t i = 0; i < 8; ++i)
                         text += fmt::format("{:10}{:16}{:16}{:16}{:10}{:10}\n", i + 1, 0.1 * corners8[i][0],
                                             0.1 * corners8[i][1], 0.1 * corners8[i][2], i < 4 ? i == 0 ? 7 : 3 : 0, 0);
                       return text;
                     }() +
                     "*ELEMENT_SOLID\n" + card(1, 1) + card(1, 2, 3, 4, 5, 6, 7, 8) +
                     keyword("SET_SOLID", card(6), card(1)) + keyword("SET_SOLID_GENERATE", card(7), card(1, 1)) +
                     keyword("DEFINE_CURVE", card(1), points({{0, 1}, {1, 1}})) +
                     keyword("BOUNDARY_PRESCRIBED_MOTION_NODE", card(5, 3, 0, 1, -0.1), card(6, 3, 0, 1, -0.1)) +
                     ending,
                 elastic +
                     "rules = [\"hex8=uniform-strain\"]\nhourglass_stiffness = 0\nhourglass_viscosity = "
                     "0.08\nstiffness_damping = 1e-7\n" +
                     viscosity +
                     "[[fix]]\nset = \"#1\"\n[[fix]]\nset = \"#2,3,4\"\ncomponents = \"z\"\n[[move]]\nset = "
                     "\"#5,6\"\ncomponents = \"z\"\nvelocity = [0, 0, -0.1]\n",
                 integrator(1e-4)});
  // Elements of other formulations.
  const std::vector<Node> corners10{{1, 0, 0, 0}, {2, 2, 0, 0}, {3, 0, 2, 0}, {4, 0, 0, 2}, {5, 1, 0, 0},
                                    {6, 1, 1, 0}, {7, 0, 1, 0}, {8, 0, 0, 1}, {9, 1, 0, 1}, {10, 0, 1, 1}};
  for (const auto& [form, rule, own] : {std::tuple{10, "tet4=gauss-1", std::vector{1, 2, 3, 4, 4, 4, 4, 4}},
                                        {13, "tet4=gauss-1", {1, 2, 3, 4}},
                                        {15, "wedge6=fierz2013", {1, 2, 6, 7, 4, 4, 10, 10}},
                                        {16, "tet10=keast-4", {1, 2, 3, 4, 5, 6, 7, 8, 9, 10}}})
    all.push_back({fmt::format("formulation-{}", form),
                   begin + until(1e-3) + part(1, 1, 1) + section(1, form) + steel() + nodes(corners10) +
                       solids(1, {own}, true) + keyword("BOUNDARY_SPC_NODE", card(1, 0, 1, 1, 1)) +
                       keyword("INITIAL_VELOCITY", card(0), card(0.1)) + ending,
                   elastic + fmt::format("rules = [\"{}\"]\n", rule) + viscosity +
                       "[[fix]]\nset = \"#1\"\n[[initial]]\nwhere = \"all\"\nvelocity = [0.1, 0, 0]\n",
                   integrator(1e-3)});
  // Parts of one point and of eight.
  all.push_back({"two-rules",
                 begin + until(1e-4) + part(1, 1, 1) + part(2, 2, 1) + section(1, 1) + section(2, 2) + steel() +
                     cubes(2) + held + keyword("LOAD_NODE_POINT", card(9, 2, 1, 1e4)) +
                     keyword("DEFINE_CURVE", card(1), points({{0, 1}, {1, 1}})) + ending,
                 "[[material]]\nset = \"part-1\"\n" + elastic.substr(elastic.find('\n') + 1) + onePoint +
                     "[[material]]\nset = \"part-2\"\n" + elastic.substr(elastic.find('\n') + 1) + selectiveRule +
                     root + viscosity + "[[force]]\nset = \"#9\"\neach = [0, 1e4, 0]\n",
                 integrator(1e-4)});
  return all;
}

class DynaDecks : public test::DeckProgram {
 public:
  static void TearDownTestSuite() { expectAllUsed(dynaKeywords()); }

 protected:
  /// A steel block of two cubes, with more keywords.
  static std::string block(const std::string& more, int form = 1) {
    return begin + until(1e-4) + part(1, 1, 1) + section(1, form) + steel() + cubes() + held + more + ending;
  }
  void refuse(const std::string& deck, const std::string& what, const std::string& command = "run deck.k --out x") {
    folder_.write("deck.k", deck);
    expectRefused(command, what);
  }
  /// By both commands.
  void refuseAlways(const std::string& deck, const std::string& what) {
    refuse(deck, what);
    refuse(deck, what, "inspect deck.k");
  }
};

TEST_F(DynaDecks, AreTheScenesThatTheyStandFor) {
  for (const Case& one : cases()) {
    SCOPED_TRACE(one.name);
    for (const auto& [file, text] : one.files) use(file, text);
    expectSame(one.name + ".k", one.deck, one.scene, one.integrator);
    EXPECT_THAT(out_, HasSubstr(one.told));
  }
}

// Shells and beams are left out with what is of their nodes.
TEST_F(DynaDecks, TellWhatGoesWithShells) {
  const std::vector<Case> all = cases();
  const Case& one = *std::ranges::find(all, "included", &Case::name);
  for (const auto& [file, text] : one.files) folder_.write(file, text);
  folder_.write("deck.k", one.deck);
  const std::string out = call("run deck.k --out d --set output.picture=false").out;
  EXPECT_THAT(out, HasSubstr("more.k:7: *ELEMENT_BEAM, 1 of them: elements that are no solids"));
  EXPECT_THAT(out,
              HasSubstr("deck.k: 3 supports, loads, masses or velocities left out, which are of nodes of no solid"));
}

// What acts on nothing is told, and a number out of range has the line of its keyword.
TEST_F(DynaDecks, TellWhatDampsNothing) {
  const std::string damping = keyword("DAMPING_PART_STIFFNESS", card(1, -1e-6), card(2, -1e-6));
  for (const auto& [law, why] :
       {std::pair<std::string, std::string>{keyword("MAT_RIGID", card(2, 7850.0, "2.1e11", 0.3), card(0), card(0)),
                                            "which is rigid: left out"},
        {steel(2), ""}}) {
    folder_.write("deck.k", begin + until(1e-4) + part(1, 1, 1) + part(2, 1, 2) + section(1, 1) + steel() + law +
                                cubes(2) + held + damping + ending);
    const std::string out = call("inspect deck.k").out;
    EXPECT_EQ(out.find("*DAMPING_PART_STIFFNESS of part 2, which is rigid: left out") != std::string::npos,
              !why.empty())
        << out;
  }
  folder_.write("deck.k", block(part(9, 1, 1) + keyword("DAMPING_PART_STIFFNESS", card(9, -1e-6))));
  EXPECT_THAT(call("inspect deck.k").out, HasSubstr("of part 9, which has no solid elements: left out"));
  refuse(block(keyword("CONTROL_TIMESTEP", card(0, 1.5))), "deck.k:42: integrator.safety");
}

// A block falls on another: of all surfaces, of two parts, of a set of segments, and of nodes alone.
TEST_F(DynaDecks, LetSurfacesTouch) {
  const std::string deck = begin + until(0.05) + part(1, 1, 1) + part(2, 1, 1) + section(1, 2) +
                           keyword("MAT_ELASTIC", card(1, 1000.0, 3e4, 0.3)) +
                           nodes({{1, 0, 0, 0, 7},
                                  {2, 0.1, 0, 0, 7},
                                  {3, 0.1, 0.1, 0, 7},
                                  {4, 0, 0.1, 0, 7},
                                  {5, 0, 0, 0.1},
                                  {6, 0.1, 0, 0.1},
                                  {7, 0.1, 0.1, 0.1},
                                  {8, 0, 0.1, 0.1},
                                  {11, 0.02, 0.02, 0.101},
                                  {12, 0.08, 0.02, 0.101},
                                  {13, 0.08, 0.08, 0.101},
                                  {14, 0.02, 0.08, 0.101},
                                  {15, 0.02, 0.02, 0.161},
                                  {16, 0.08, 0.02, 0.161},
                                  {17, 0.08, 0.08, 0.161},
                                  {18, 0.02, 0.08, 0.161}}) +
                           solids(1, {first}) + solids(2, {{11, 12, 13, 14, 15, 16, 17, 18}}) +
                           keyword("SET_NODE", card(3), card(11, 12, 13, 14)) + keyword("SET_PART", card(4), card(2)) +
                           keyword("SET_SEGMENT", card(5), card(5, 6, 7, 8)) +
                           keyword("INITIAL_VELOCITY_GENERATION", card(2, 2, 0, 0.1, 0, -0.5), card(0));
  const std::string law = "model = \"corotational\"\nyoung = 3e4\npoisson = 0.3\ndensity = 1000\n";
  const std::string scene =
      "[[material]]\nset = \"part-1\"\n" + law + selectiveRule + "[[material]]\nset = \"part-2\"\n" + law +
      "[[fix]]\nset = \"#1,2,3,4\"\n[[initial]]\nset = \"part-2\"\nvelocity = [0.1, 0, -0.5]\n" + viscosity;
  const std::string contact = "[[contact]]\nwith = \"surface\"\n", friction = "friction = 0.2\n";
  const std::string lower = "set = \"#1,2,3,4,5,6,7,8\"\n", upper = "set = \"#11,12,13,14,15,16,17,18\"\n",
                    top = "set = \"#5,6,7,8\"\n", under = "set = \"#11,12,13,14\"\n";
  const auto expect = [&](const std::string& name, const std::string& cards, const std::string& sections) {
    SCOPED_TRACE(name + cards);
    expectSame("deck.k", deck + keyword(name, cards) + ending, scene + sections, integrator(0.05));
    const Table rows = table("d/history.csv");
    EXPECT_LT(rows.number(rows.rows.size() - 1, "kinetic_J"), 0.98 * rows.number(0, "kinetic_J"));  // it has touched
    EXPECT_THAT(out_, HasSubstr("by penalty here"));
  };
  expect("CONTACT_AUTOMATIC_SINGLE_SURFACE_ID", "         1 all\n" + card(0) + card(0.2, 0.2, 0, 0, 10) + card(0),
         contact + friction + "damping = 0.1\n");
  for (const std::string name : {"CONTACT_AUTOMATIC_SURFACE_TO_SURFACE", "CONTACT_SURFACE_TO_SURFACE"})
    expect(name, card(4, 1, 2, 3) + card(0.2),
           contact + friction + upper + "to_" + lower + contact + friction + lower + "to_" + upper);
  expect("CONTACT_NODES_TO_SURFACE", card(3, 5, 4, 0) + card(0) + card(0) + card(1, 0.1),
         contact + under + "to_" + top);
  EXPECT_THAT(out_, HasSubstr("the lines behind its third are of LS-DYNA's own search and penalty, and left out"));
  expect("CONTACT_AUTOMATIC_NODES_TO_SURFACE", card(2, 5, 3, 0) + card(0), contact + upper + "to_" + top);
  // On walls, of all nodes and of a set.
  const std::string wall =
      "[[obstacle]]\nname = \"floor\"\nkind = \"plane\"\npoint = [0, 0, 0.1]\nnormal = [0, 0, "
      "2]\n[[contact]]\nobstacle = \"floor\"\n";
  expect("RIGIDWALL_PLANAR_ID", "         1\n" + card(3) + card(0, 0, 0.1, 0, 0, 2.1, 0.3),
         wall + "set = \"nodeset-3\"\nfriction = 0.3\n");
  const auto refused = [&](const std::string& name, const std::string& cards, const std::string& what) {
    refuseAlways(deck + keyword(name, cards) + ending, what);
  };
  refused("CONTACT_SURFACE_TO_SURFACE", card(1, 2, 3, 3) + card(0.3, 0.1, 5.0), "FD and DC: there is one coefficient");
  refused("CONTACT_SURFACE_TO_SURFACE", card(1, 9, 3, 3) + card(0), "part-9 has no solid elements");
  refused("CONTACT_SURFACE_TO_SURFACE", card(1, 9, 3, 0) + card(0), "there is no *SET_SEGMENT 9");
  refused("CONTACT_SURFACE_TO_SURFACE", card(1, 3, 3, 4) + card(0), "MSID is a set of nodes, which has no faces");
  refused("CONTACT_SURFACE_TO_SURFACE", card(1, 0, 3, 5) + card(0), "a side is the whole body");
  refused("CONTACT_SURFACE_TO_SURFACE", card(1, 2, 3, 3) + card(0, 0, 0, 0, 0, 0, 0.5), "BT = 0.5: begins within the");
  // All nodes, by a card of blanks.
  expectSame("deck.k", deck + keyword("RIGIDWALL_PLANAR", "\n" + card(0, 0, -0.1, 0, 0, 1)) + ending,
             scene +
                 "[[obstacle]]\nname = \"floor\"\nkind = \"plane\"\npoint = [0, 0, -0.1]\nnormal = [0, 0, "
                 "1.1]\n[[contact]]\nobstacle = \"floor\"\n",
             integrator(0.05));
  refused("RIGIDWALL_PLANAR", "\n", "field 4 of *RIGIDWALL_PLANAR, XH, is blank");
  refused("RIGIDWALL_PLANAR", card(0) + card(0, 0, 0, 0, 0, 1, 1.0), "field 7 of *RIGIDWALL_PLANAR, FRIC, is \"1\"");
  refused("CONTACT_TIED_NODES_TO_SURFACE", card(1), "of contact AUTOMATIC_SINGLE_SURFACE, SURFACE_TO_SURFACE");
}

TEST_F(DynaDecks, AreReadAsMeshes) {
  const std::string collapsed = cases()[6].deck;
  folder_.write("deck.k", collapsed);
  std::vector<std::string> notes;
  const Mesh mesh = loadMesh(folder_.path() / "deck.k", &notes);
  std::set<std::string> types;
  for (const MeshBlock& block : mesh.blocks) {
    types.insert(std::string(elementInfo(block.type).name));
    EXPECT_EQ(block.elementCount(), 1u);
  }
  EXPECT_EQ(types, (std::set<std::string>{"hex8", "wedge6", "pyramid5", "tet4"}));
  EXPECT_EQ(mesh.elementSets.at("part-1").size(), 4u);
  EXPECT_EQ(mesh.nodeSets.at("part-1").size(), 12u);
  EXPECT_EQ(mesh.nodeSets.at("nodeset-1").size(), 5u);  // 1, and 2 to 5; of 9 to 19 there are none
}

// L / c with L = V / A_max of a cube, and (DT2MS / step)² of the mass where the step is smaller.
TEST_F(DynaDecks, TellTheStepAndTheMassOfLsDyna) {
  const double speed = std::sqrt(2.1e11 * 0.7 / (1.3 * 0.4 * 7850)), step = 0.1 / speed;
  folder_.write("deck.k", block(keyword("CONTROL_TIMESTEP", card(0, 0.67))));
  const Json plain = parse(call("inspect deck.k --json -").out);
  EXPECT_THAT(call("inspect deck.k").out,
              HasSubstr(fmt::format("LS-DYNA's own step at rest is 0.67 x {:.6g} = {:.6g} s", step, 0.67 * step)));
  EXPECT_NEAR(plain["mass"].get<double>(), 15.7, 1e-12);
  // A verdict on it, by the bracket without bulk viscosity, which that step has under compression alone.
  folder_.write("deck.k", block(keyword("CONTROL_TIMESTEP", card(0, 1.0))));
  ASSERT_EQ(call("suggest deck.k --set damping.bulk_viscosity=false --json bare.json").status, 0);
  const Json bare = json("bare.json")["timestep"];
  int proven = 0;
  for (const double factor : {0.67, 1.0, 3.0})
    for (const std::string command : {"inspect", "suggest"}) {
      if (factor > 1 && command == "suggest") continue;  // no scene steps farther than it may
      folder_.write("deck.k", block(keyword("CONTROL_TIMESTEP", card(0, factor))));
      const test::Outcome outcome = call(command + " deck.k --json own.json");
      ASSERT_EQ(outcome.status, 0) << outcome.err;
      const Json own = json("own.json")["timestep"];
      EXPECT_NEAR(own["asked"].get<double>() / (factor * step), 1, 1e-6);
      if (factor == 1) {
        EXPECT_EQ(own["verdict"], bare["verdict"]);
        EXPECT_EQ(own["steps"], bare["steps"]);
      }
      proven += own["verdict"] == "certified";
      EXPECT_THAT(outcome.out,
                  AllOf(HasSubstr(fmt::format("its own program's step at rest {:.6g} s is proven {}", factor * step,
                                              own["verdict"] == "certified" ? "stable; " : "unstable, as is every ")),
                        HasSubstr("; all without bulk viscosity, which that step has under compression alone\n")));
    }
  EXPECT_GE(proven, 2);
  EXPECT_LE(proven, 4);
  // None where it depends on more than crossings.
  for (const auto& [more, what] : {std::pair(card(1e-7, 0.9), "DTINIT"), {card(0, 0.9, 0, 0, 0, 7), "LCTM"}}) {
    folder_.write("deck.k", block(keyword("CONTROL_TIMESTEP", more)));
    ASSERT_EQ(call("inspect deck.k --json own.json").status, 0);
    EXPECT_FALSE(json("own.json").contains("timestep"));
    EXPECT_THAT(call("inspect deck.k").out,
                HasSubstr(joinText("own step may depend on ", what, " besides, and gets no verdict")));
  }
  folder_.write("deck.k", block(keyword("CONTROL_TIMESTEP", card(0, 0.67, 0, 0, -3e-5))));
  const double factor = std::pow(3e-5 / step, 2);
  std::string out;
  for (const std::string command : {"inspect deck.k", "run deck.k --out d --set output.picture=false"})
    EXPECT_THAT(out = call(command).out,
                HasSubstr(fmt::format("LS-DYNA adds {:.6g} kg to 2 of 2 elements at rest, {:.3g} % of 15.7 kg, and "
                                      "steps at 2.01e-05 s",
                                      15.7 * (factor - 1), 100 * (factor - 1))));
  // One step is told of LS-DYNA, and what it would be without the mass.
  EXPECT_THAT(
      out, HasSubstr(fmt::format("; without that mass its step would be 0.67 x {:.6g} = {:.6g} s", step, 0.67 * step)));
  EXPECT_THAT(out, ::testing::Not(HasSubstr("LS-DYNA's own step at rest")));
  const Json scaled = parse(call("inspect deck.k --json - --global").out);
  EXPECT_NEAR(scaled["mass"].get<double>(), 15.7 * factor, 1e-12 * 15.7 * factor);
  EXPECT_NEAR(json("d/summary.json")["mass"].get<double>(), 15.7 * factor, 1e-12 * 15.7 * factor);
  EXPECT_GT(scaled["critical_step"]["safe"].get<double>(), 1.2 * plain["critical_step"]["safe"].get<double>());
  folder_.write("deck.k", block(keyword("CONTROL_TIMESTEP", card(0, 0.9, 0, 0, -1e-6))));
  EXPECT_THAT(call("inspect deck.k").out,
              HasSubstr("DT2MS: adds no mass at rest, since no element's step is below 1e-06"));
  refuseAlways(block(keyword("CONTROL_TIMESTEP", card(0, 0.9, 0, 0, 1e-5))),
               "*CONTROL_TIMESTEP, DT2MS = 1e-05: gives every element the same step");
}

// Every one with its line; `inspect` passes over what does not matter at rest.
TEST_F(DynaDecks, RefuseWhatWouldChangeTheMotion) {
  refuseAlways(
      block("*CONTACT_ERODING_SINGLE_SURFACE\n*CONSTRAINED_RIGID_BODIES\n"),
      "deck.k:41: *CONTACT_ERODING_SINGLE_SURFACE: of contact AUTOMATIC_SINGLE_SURFACE, SURFACE_TO_SURFACE and "
      "NODES_TO_SURFACE, the latter AUTOMATIC too, are taken; and 1 more: deck.k:42: *CONSTRAINED_RIGID_BODIES: ties "
      "degrees of freedom");
  refuseAlways(block("*NEW_THING\n"), "deck.k:41: *NEW_THING is not known");
  refuseAlways(block("*PARAMETER\nR  x  1\n"), "*PARAMETER: is not followed");
  for (const char* more : {"*CONTROL_TIMESTP\n", "*DEFINE_ELEMENT_DEATH_SOLID\n", "*DEFINE_DEATH_TIMES_NODES\n",
                           "*DEFINE_STAGED_CONSTRUCTION_PART\n"})
    refuseAlways(block(more), "may change what the body is");
  refuseAlways(block(keyword("CONTROL_TIMESTEP", card(0), card(2.0))), "DT2MSF = 2");
  refuseAlways(block(keyword("CONTROL_TIMESTEP", card(0), card(0, 7))), "DT2MSLC = 7");
  refuseAlways(block(keyword("CONTROL_BULK_VISCOSITY", card(0, 0, 2))), "*CONTROL_BULK_VISCOSITY, TYPE = 2");
  refuse(block(keyword("DEFINE_CURVE", card(9, 2), points({{0, 0}, {1, 1}}))), "*DEFINE_CURVE, SIDR = 2");
  // A card more than a keyword has.
  const std::string behind = "what is behind it takes a keyword of its own";
  refuse(block(keyword("INITIAL_VELOCITY", card(0), card(1.0), card(0), card(5.0))),
         "*INITIAL_VELOCITY: has 2 lines; " + behind);
  for (const char* name : {"LOAD_BODY_X", "LOAD_BODY_Y", "LOAD_BODY_Z", "DAMPING_GLOBAL"})
    refuse(block(keyword(name, card(0), card(7, 9.81))), joinText("*", name, ": has one line; ", behind));
  for (const auto& [name, lines] : {std::pair("MAT_ELASTIC", "one line"),
                                    {"MAT_BLATZ-KO_RUBBER", "one line"},
                                    {"MAT_MOONEY-RIVLIN_RUBBER", "2 lines"},
                                    {"MAT_RIGID", "3 lines"}})
    refuse(block(keyword(name, card(9, 1000.0, 1e6, 0.3, 1e4), card(0), card(0), card(8, 1000.0))),
           joinText("*", name, ": has ", lines, "; ", behind));
  refuseAlways(block("*INITIAL_STRESS_SOLID\n"), "*INITIAL_STRESS_SOLID: changes the tangent");
  refuseAlways(block("*SET_NODE_GENERAL\n"), "*SET_NODE_GENERAL: makes or changes nodes");
  refuseAlways(block(keyword("DAMPING_PART_STIFFNESS", card(1, 0.1))), "COEF = 0.1: a share of LS-DYNA's own measure");
  refuseAlways(block(keyword("DAMPING_PART_STIFFNESS", card(1, -1e-6), card(7, -1e-6))),
               "deck.k:43: there is no *PART 7");
  refuseAlways(block(keyword("SET_PART_LIST", card(5), card(1, 7))), "deck.k:43: there is no *PART 7");
  refuseAlways(block(keyword("DAMPING_PART_STIFFNESS", card(1, -1e-6), card(1, -1e-6))),
               "deck.k:43: *DAMPING_PART_STIFFNESS 1 gives a second time what line 42 gives");
  for (const std::string name :
       {"CONTROL_TERMINATION", "CONTROL_TIMESTEP", "CONTROL_BULK_VISCOSITY", "CONTROL_HOURGLASS", "DAMPING_GLOBAL"})
    refuseAlways(block(keyword(name, card(0)) + keyword(name, card(0))),
                 fmt::format("*{} gives a second time what line {} gives; leave one out", name,
                             name == "CONTROL_TERMINATION" ? 6 : 42));
  refuse(block("*ELEMENT_SHELL\n     900       2       9      10      11      12\n" +
               keyword("INITIAL_VELOCITY_GENERATION", card(7, 2, 0, 1.0), card(0))),
         "there is no *PART 7");
  refuseAlways(block(keyword("BOUNDARY_SPC_SET", card(1, 0, 2))),
               "field 3 of *BOUNDARY_SPC_SET, DOFX, is \"2\"; it must be 0 or 1");
  refuseAlways(block(keyword("CONTROL_HOURGLASS", card(99))), "IHQ, is \"99\"; it must be 0 to 10");
  refuseAlways(block(keyword("CONTROL_TIMESTEP", card(0, -3))), "field 2 of *CONTROL_TIMESTEP, TSSFAC, is \"-3\"");
  refuse(block(keyword("LOAD_BODY_Z", card(1)) + keyword("LOAD_BODY_Z", card(1))),
         "*LOAD_BODY_Z gives a second time what line 42 gives");
  refuseAlways(block(keyword("BOUNDARY_SPC_SET", card(1, 3, 1))), "*BOUNDARY_SPC_SET, CID = 3: turns the axes");
  refuseAlways(block("", 18), "*SECTION_SOLID 1, ELFORM = 18: there is no such element");
  refuseAlways(block("", 3), "*SECTION_SOLID 1, ELFORM = 3: its nodes turn, and ours do not");
  refuseAlways(block("", 10), "ELFORM = 10: it is no formulation of the hex8 of this part");
  for (const std::string more :
       {"*RIGIDWALL_PLANAR_MOVING\n", "*LOAD_THERMAL_CONSTANT\n", "*CONTROL_IMPLICIT_EIGENVALUE\n"}) {
    refuse(block(more), more.substr(0, more.size() - 1));
    EXPECT_EQ(call("inspect deck.k").status, 0);
  }
  refuse(block(keyword("CONTROL_IMPLICIT_GENERAL", card(1))), "*CONTROL_IMPLICIT_GENERAL, IMFLAG = 1: is implicit");
  EXPECT_EQ(call("inspect deck.k").status, 0);
  refuse(block(keyword("LOAD_NODE_SET", card(2, 4, 1, 1.0))), "*LOAD_NODE_SET, DOF = 4: forces along 1, 2 and 3");
  refuse(block(keyword("LOAD_NODE_SET", card(2, 1, 9, 1.0))), "there is no *DEFINE_CURVE 9");
  refuse(block(keyword("DEFINE_CURVE", card(9), points({{0, 0}, {1e-5, 1}})) +
               keyword("LOAD_NODE_SET", card(2, 1, 9, 1.0))),
         "*DEFINE_CURVE 9 has times from 0 to 1e-05 s; it must have those of the whole run, 0 to 0.0001 s");
  refuse(block(keyword("DEFINE_CURVE", card(9), points({{0, 1}, {1, 1}})) +
               keyword("BOUNDARY_PRESCRIBED_MOTION_SET", card(2, 1, 2, 9, 1.0))),
         "*DEFINE_CURVE 9 of a displacement must begin with 0");
  refuse(block(keyword("BOUNDARY_PRESCRIBED_MOTION_SET", card(2, 1, 1, 9))), "VAD = 1: 0 for a velocity and 2");
  refuse(block(keyword("INITIAL_VELOCITY", card(0), card(1)) + keyword("INITIAL_VELOCITY_NODE", card(9, 1))),
         "*INITIAL_VELOCITY: node 9 has a velocity already, by line 42");
  refuse(block(keyword("DEFINE_CURVE", card(9), points({{0, 1}, {1, 1}})) +
               keyword("LOAD_SEGMENT", card(9, 1.0, 0, 2, 3, 7, 6))),
         "the segment 2 3 7 6: no face of the body's surface has these corners");
  refuse(begin + part(1, 1, 1) + section(1, 1) + steel() + cubes() + held + ending,
         "has no *CONTROL_TERMINATION, and so no motion to run");
}

TEST_F(DynaDecks, RefuseLawsOfSolidPartsAlone) {
  const auto deck = [](const std::string& law, int ofPart) {
    return begin + until(1e-4) + part(1, 1, ofPart) + section(1, 1) + steel() + law + cubes() + held + ending;
  };
  const std::string plastic = keyword("MAT_PIECEWISE_LINEAR_PLASTICITY", card(3, 7850.0, "2.1e11", 0.3, 2e8));
  folder_.write("deck.k", deck(plastic, 1));
  EXPECT_THAT(call("inspect deck.k").out, HasSubstr("*MAT_PIECEWISE_LINEAR_PLASTICITY (line 14)"));
  refuseAlways(deck(plastic, 3), "deck.k:14: *MAT_PIECEWISE_LINEAR_PLASTICITY of part 1: there is no such law");
  refuseAlways(deck("", 3), "*PART: there is no *MAT_ 3");
  const std::string ogden = keyword("MAT_077_O", card(3, 1000.0, 0.49), card(1e5, 2e4), card(2.0, 3.5));
  refuseAlways(deck(ogden, 3), "*MAT_077_O: ALPHA2 = 3.5: terms with 2 and -2 are taken");
  refuseAlways(deck(keyword("MAT_077_H", card(3, 1000.0, 0.49, 2), card(0)), 3), "N = 2: constants are not fitted");
  refuseAlways(deck(keyword("MAT_077_H", card(3, 1000.0, 0.49), card(1e5, 2e4, 3e3)), 3), "C11 is not 0");
  refuseAlways(deck(keyword("MAT_077_H", card(3, 1000.0, 0.49), card(1e5), card(5e4, 10.0)), 3), "GI = 50000");
  refuseAlways(deck(keyword("MAT_027", card(3, 1000.0, 0.5, 1e5)), 3),
               "field 3 of *MAT_027, PR, is \"0.5\"; it must be > 0 and < 0.5");
}

// The file, the line and the field.
TEST_F(DynaDecks, SayWhichFieldIsWrong) {
  refuseAlways(block(keyword("SECTION_SOLID", card(2, "one"))),
               "deck.k:42: field 2 of *SECTION_SOLID, ELFORM, is \"one\"; it must be a whole number");
  refuseAlways(block(keyword("MAT_ELASTIC", card(2, 7850.0, "2.1f11"))),
               "deck.k:42: field 3 of *MAT_ELASTIC, E, is \"2.1f11\"; it must be a number");
  refuseAlways(block(keyword("BOUNDARY_SPC_NODE", card("", 0, 1))),
               "deck.k:42: field 1 of *BOUNDARY_SPC_NODE, NID, is blank; it must be a whole number of 1 or more");
  refuseAlways(block("*BOUNDARY_SPC_NODE\n9\t0\t1\n"), "deck.k:42: *BOUNDARY_SPC_NODE: the line has a tab");
  refuseAlways(block("*NODE\n      13             0.x             0.0             0.0\n"),
               "deck.k:42: field 2 of *NODE, X, is \"0.x\"; it must be a number");
  refuseAlways(block("*ELEMENT_SOLID\n     900       1       1       2       3\n"),
               "deck.k:42: field 6 of *ELEMENT_SOLID, N4, is blank; it must be the number of a node");
  refuseAlways(block("*INCLUDE\nnowhere.k\n"), "deck.k:42: *INCLUDE takes in ");
  folder_.write("inner.k", "*SECTION_SOLID\n         2  1.5\n");
  refuseAlways(block("*INCLUDE\ninner.k\n"), "inner.k:2: field 2 of *SECTION_SOLID, ELFORM, is \"1.5\"");
}

TEST_F(DynaDecks, NameRadiossDecksAndDecksWithoutSolids) {
  folder_.write("x_0000.rad", "#RADIOSS STARTER\n/BEGIN\n");
  for (const std::string command : {"inspect x_0000.rad --young 1 --poisson 0.3 --density 1", "mesh check x_0000.rad",
                                    "run x_0000.rad", "inspect x_0000.rad"})
    expectRefused(command, "this is a Radioss deck, which is not read; OpenRadioss reads LS-DYNA decks, too");
  folder_.write("deck.k", "*KEYWORD\n*NODE\n       1              0.              0.              0.\n*END\n");
  for (const std::string command : {"inspect deck.k", "mesh check deck.k", "run deck.k"})
    expectRefused(command,
                  "deck.k: there are no volume elements; a mesh of "
                  "tetrahedra or hexahedra is needed; this is an LS-DYNA deck, in which *ELEMENT_SOLID has them");
}

}  // namespace
}  // namespace ringwatch::dyna_decks

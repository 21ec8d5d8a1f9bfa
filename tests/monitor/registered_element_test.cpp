// An element that a program registers, with laws of the library and one that is registered after it: its kernels
// against plain numbers, bounds and bracket against dense eigenvalues, files in both node orders, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <cstdio>

#include <cmath>
#include <cstdio>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/body/register_element.h>
#include <ringwatch/body/register_law.h>
#include <ringwatch/meshes/check.h>
#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/meshes/quality.h>
#include <tests/added/log_mooney_rivlin.h>
#include <tests/added/wedge15.h>
#include <tests/meshes/mesh_test_tools.h>
#include <tests/monitor/bounds_fault.h>
#include <tests/monitor/monitor_cases.h>
#include <tests/monitor/register_added.h>
#include <tests/support/meshes.h>
#include <tests/support/scalar_reference.h>

namespace ringwatch {
namespace {

using test::Wedge15;
using ::testing::HasSubstr;

/// Nodal forces of order one strain, N: what rounding is measured against.
constexpr double forceScale = test::young * test::cellSize * test::cellSize;

class RegisteredElement : public ::testing::Test {
 public:
  static void SetUpTestSuite() {
    test::registerWedge15();
    test::registerLogMooneyRivlin();
  }
  static const ElementInfo& info() { return *findElementByName(Wedge15::name); }
  static Material material(std::string_view law) {
    return makeMaterial(law, test::young, test::poisson, test::density);
  }
  static test::Subdivision subdivision() { return {std::string(Wedge15::name), std::string(Wedge15::name), 0, "", 0}; }
  static Mesh distortedBox(std::array<int, 3> cells) { return test::box(subdivision(), cells); }
  /// Nodes lie half a cell apart: a disturbance of 2 % of the cell keeps det F well above zero.
  static NodeVectors strained(const NodeVectors& X) {
    test::Random random(5);
    const Eigen::Matrix3d F = Eigen::Matrix3d::Identity() + random.matrix(0.15);
    return F * X + random.nodeVectors(X.cols(), 0.02 * test::cellSize);
  }
};

TEST_F(RegisteredElement, IsFoundLikeThoseOfTheLibrary) {
  EXPECT_EQ(allElements().size(), Elements::size + 1);
  EXPECT_EQ(&elementInfo(info().type), &info());
  EXPECT_EQ(findElementByVtkType(26), &info());
  EXPECT_EQ(findElementByGmshType(18), &info());
  EXPECT_FALSE(isOfLibrary(info().type));
  int visits = 0;
  visitElement(info().type, [&](auto) { ++visits; });
  EXPECT_EQ(visits, 0);
}

TEST_F(RegisteredElement, IsRefusedWhenItDoesNotFit) {
  struct Case {
    std::string words;
    void (*change)(ElementInfo& info);
  };
  const Case cases[] = {
      {"element \"wedge27\": it has 27 nodes; at most 20 are possible", [](ElementInfo& i) { i.nodes = 27; }},
      {"it has the order 3; it must be 1 or 2", [](ElementInfo& i) { i.order = 3; }},
      {"it has 14 nodes; an element of order 2 with 6 corners and 9 edges must have 15",
       [](ElementInfo& i) { i.nodes = 14; }},
      {"it has 15 reference nodes and 14 nodes in gmsh's order; there must be 15",
       [](ElementInfo& i) { i.gmshOrder = i.gmshOrder.first(14); }},
      {"it has no quadrature rule", [](ElementInfo& i) { i.rules = {}; }},
      {"it has no way to fill a cell (cellSplits)", [](ElementInfo& i) { i.cellSplits = {}; }},
      {"it has the VTK cell type 25 of hex20", [](ElementInfo& i) { i.vtkCellType = 25; }},
      {"it has the gmsh type 11 of tet10", [](ElementInfo& i) { i.gmshType = 11; }},
      {"element \"tet4\": there is one of that name already", [](ElementInfo& i) { i.name = "tet4"; }}};
  for (const Case& wrong : cases) {
    ElementInfo other = elementInfoOf<Wedge15>(ElementType{});
    other.name = "wedge27";
    other.vtkCellType = other.gmshType = 0;
    wrong.change(other);
    EXPECT_THAT(test::errorOf([&] { detail::registerElement(other); }), HasSubstr(wrong.words));
  }
  EXPECT_THAT(test::errorOf([] { test::registerWedge15(); }), HasSubstr("it has the VTK cell type 26 of wedge15"));
  EXPECT_EQ(allElements().size(), Elements::size + 1);
}

TEST_F(RegisteredElement, AgreesWithPlainNumbersInEveryLaw) {
  const Mesh mesh = distortedBox({3, 2, 2});
  const NodeVectors x = strained(mesh.X);
  test::Random random(10);
  const NodeVectors v = random.nodeVectors(x.cols(), 1);
  int compared = 0;
  for (const QuadratureRule& rule : Wedge15::rules) {
    const auto compare = [&]<class L>(TypeTag<L>) {
      const Body body(mesh, material(L::name), {{{std::string(Wedge15::name), std::string(rule.name)}}});
      const test::ScalarReference<Wedge15, L> reference(mesh, L::of(L::parametersFor(test::young, test::poisson)),
                                                        rule);
      Body::Workspace workspace;
      NodeVectors f, Kv, expected;
      body.internalForce(x, f, workspace);
      reference.force(x, expected);
      EXPECT_LE((f - expected).cwiseAbs().maxCoeff(), 1e-13 * forceScale) << L::name;
      body.tangentProduct(x, v, Kv, workspace);
      reference.tangentProduct(x, v, expected);
      EXPECT_LE((Kv - expected).norm(), 1e-13 * Kv.norm()) << L::name;
      EXPECT_LE((body.assembleTangent(x) * v.reshaped() - expected.reshaped()).norm(), 1e-13 * Kv.norm()) << L::name;
      EXPECT_NEAR(body.energy(x, workspace), reference.energy(x), 1e-13 * reference.energy(x)) << L::name;
      ++compared;
    };
    forEachType(Laws{}, compare);
    compare(TypeTag<test::LogMooneyRivlin>{});
  }
  EXPECT_EQ(compared, 2 * static_cast<int>(Laws::size + 1));
}

TEST_F(RegisteredElement, HasSixZeroModesAndKeepsItsMass) {
  const Mesh mesh = test::gridMesh(Wedge15::name, {1, 1, 1}, {0.01, 0.01, 0.01});
  for (const LawInfo& law : allLaws())
    for (const QuadratureRule& rule : Wedge15::rules) {
      const Body body(mesh, material(law.name), {{{std::string(Wedge15::name), std::string(rule.name)}}});
      const Eigen::MatrixXd K = body.elementTangent({0, 0}, mesh.X);
      const Eigen::VectorXd lambda =
          Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K, Eigen::EigenvaluesOnly).eigenvalues();
      EXPECT_EQ((lambda.array().abs() < 1e-10 * lambda.maxCoeff()).count(), 6) << law.name << " " << rule.name;
      EXPECT_GT(body.lumpedMass().minCoeff(), 0);
      EXPECT_NEAR(body.totalMass(), test::density * 1e-6, 1e-14 * test::density * 1e-6);
    }
}

TEST_F(RegisteredElement, PassesThePatchTestInEveryLaw) {
  const Mesh mesh = distortedBox({3, 3, 3});
  std::vector<bool> boundary(mesh.nodeCount());
  for (const auto& [name, nodes] : mesh.nodeSets)
    for (const std::int32_t node : nodes) boundary[node] = true;
  Eigen::Matrix3d F;
  F << 1.1, 0.06, -0.04, 0.03, 0.92, 0.05, -0.02, 0.04, 1.06;
  for (const LawInfo& law : allLaws()) {
    const Body body(mesh, material(law.name));
    Body::Workspace workspace;
    NodeVectors f;
    body.internalForce(F * mesh.X, f, workspace);
    int inner = 0;
    for (Eigen::Index node = 0; node < f.cols(); ++node) {
      if (boundary[node]) continue;
      EXPECT_LE(f.col(node).cwiseAbs().maxCoeff(), 1e-13 * forceScale) << law.name;
      ++inner;
    }
    EXPECT_GE(inner, 50);
  }
}

TEST_F(RegisteredElement, GivesSharesOfALawToRulesThatAskForThem) {
  const NeoHookean law{lameConstants(test::young, test::poisson)};
  const LawOfPacks::Functions functions = LawOfPacks::functionsOf<NeoHookean>();
  const auto half = functions.share(&law, 0.5, 0);
  ASSERT_TRUE(half);
  Matrix3<NativePack> F = Matrix3<NativePack>::identity();
  F.m[0] = NativePack(1.2);
  Matrix3<double> same = Matrix3<double>::identity();
  same.m[0] = 1.2;
  const double expected = NeoHookean{{0.5 * law.constants.lambda, 0}}.energy(same);
  EXPECT_NEAR(functions.energy(half.get(), F)[0], expected, 1e-15 * test::young);
  const auto rubber = test::LogMooneyRivlin::of(test::LogMooneyRivlin::parametersFor(test::young, test::poisson));
  EXPECT_FALSE(LawOfPacks::functionsOf<test::LogMooneyRivlin>().share(&rubber, 0.5, 0));
}

TEST_F(RegisteredElement, ALawThatHasNoSharesIsRefusedByRulesThatAskForThem) {
  const Mesh mesh = test::gridMesh("hex8", {1, 1, 1}, {0.01, 0.01, 0.01});
  const auto refusal = [&](std::string_view law, const std::string& rule) -> std::string {
    try {
      const Body body(mesh, material(law), {{{"hex8", rule}}});
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(refusal("log-mooney-rivlin", "selective"),
              HasSubstr("a law linear in Lamé's constants; log-mooney-rivlin is none"));
  EXPECT_EQ(refusal("log-mooney-rivlin", "gauss-2x2x2"), "");
  EXPECT_EQ(refusal("stvk", "selective"), "");
}

TEST_F(RegisteredElement, IsBoundedInEveryLaw) {
  int tried = 0;
  for (const LawInfo& law : allLaws())
    for (const test::Hold hold : {test::Hold::nothing, test::Hold::face}) {
      Body body = test::boxBody(subdivision(), law.name, {2, 1, 1}, 0.2, 3);
      test::holdBody(body, hold, 3);
      for (const test::NamedState& state :
           {test::NamedState{"rest", body.mesh().X}, test::NamedState{"strained", strained(body.mesh().X)}}) {
        EXPECT_EQ(test::boundsFault(body, state.x), "") << law.name << ", " << state.name;
        ++tried;
      }
    }
  EXPECT_EQ(tried, 4 * static_cast<int>(Laws::size + 1));
}

TEST_F(RegisteredElement, IsMonitoredAlongAPull) {
  for (const std::string_view law : {"stvk", "log-mooney-rivlin"}) {
    Body body = test::boxBody(subdivision(), law, {2, 1, 1});
    test::holdBody(body, test::Hold::face);
    MonitorOptions options;
    options.limit = test::limit;
    StabilityMonitor monitor(body, options);
    const NodeVectors& X = body.mesh().X;
    double widest = 0;
    for (int step = 0; step < 30; ++step) {
      NodeVectors x = X;
      x.row(0) *= 1 + 0.01 * step;
      const double exact = stepFor(test::DenseTangent(body, x).largest(), test::limit);
      const MonitorReport& report = monitor.observe(step, 1e-3 * step, x, NodeVectors::Zero(3, x.cols()), 0.5 * exact);
      ASSERT_TRUE(report.bracket) << law << " " << step;
      EXPECT_LE(report.bracket->safe, exact * (1 + 1e-9)) << law << " " << step;
      EXPECT_GE(report.bracket->optimistic, exact * (1 - 1e-9)) << law << " " << step;
      EXPECT_EQ(report.verdict, Verdict::certified) << law << " " << step;
      widest = std::max(widest, 1 - report.bracket->safe / report.bracket->optimistic);
    }
    EXPECT_LE(widest, 0.2) << law;  // 0.115 of the rubber
  }
}

/// One element, bent so that no two middles of edges could change places unnoticed.
Mesh bentWedge() {
  Mesh mesh;
  mesh.X.resize(3, 15);
  MeshBlock block{findElementByName(Wedge15::name)->type, {}, {}};
  for (int a = 0; a < 15; ++a) {
    const auto& xi = Wedge15::referenceNodes[a];
    mesh.X.col(a) = Eigen::Vector3d(xi[0] + 0.003 * a, xi[1] - 0.002 * a, xi[2] + 0.001 * a * a / 15);
    block.connectivity.push_back(a);
  }
  mesh.blocks.push_back(std::move(block));
  return mesh;
}

TEST_F(RegisteredElement, IsWrittenAndRead) {
  const test::TemporaryFolder folder;
  for (const Mesh& mesh : {bentWedge(), distortedBox({2, 2, 1})})
    for (const auto& [name, format] : {std::pair{"a.vtu", MeshFormat::vtu},
                                       {"b.msh", MeshFormat::msh41},
                                       {"c.msh", MeshFormat::msh22},
                                       {"d.msh", MeshFormat::msh41Binary}}) {
      writeMesh(mesh, folder / name, format);
      const Mesh back = loadMesh(folder / name, nullptr);
      ASSERT_EQ(back.blocks.size(), 1u) << name;
      EXPECT_EQ(back.blocks[0].type, info().type) << name;
      EXPECT_EQ(back.blocks[0].connectivity, mesh.blocks[0].connectivity) << name;
      EXPECT_LE((back.X - mesh.X).cwiseAbs().maxCoeff(), 1e-15) << name;
    }
}

TEST_F(RegisteredElement, IsReadInTheNodeOrderOfEachFormat) {
  const test::TemporaryFolder folder;
  // gmsh's drawing of the Prism15: middles of the edges 01 02 03 12 14 25 34 35 45.
  const std::string corners = "1 0 0 -1\n2 1 0 -1\n3 0 1 -1\n4 0 0 1\n5 1 0 1\n6 0 1 1\n";
  test::writeBytes(folder / "prism.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n15\n" + corners +
                                             "7 .5 0 -1\n8 0 .5 -1\n9 0 0 0\n10 .5 .5 -1\n11 1 0 0\n12 0 1 0\n"
                                             "13 .5 0 1\n14 0 .5 1\n15 .5 .5 1\n$EndNodes\n$Elements\n1\n"
                                             "1 18 2 1 1 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15\n$EndElements\n");
  // A C3D15 of the decks, in VTK's order: middles of 01 12 20 34 45 53 03 14 25.
  std::string deck =
      "*NODE\n" + corners +
      "7 .5 0 -1\n8 .5 .5 -1\n9 0 .5 -1\n10 .5 0 1\n11 .5 .5 1\n12 0 .5 1\n13 0 0 0\n14 1 0 0\n15 0 1 0\n";
  std::replace(deck.begin(), deck.end(), ' ', ',');
  test::writeBytes(folder / "prism.inp", deck + "*ELEMENT, TYPE=C3D15\n1,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15\n");
  // CalculiX 2.20 writes that element into its results with the middles along its height before those of its top.
  std::string results = "    1C\n    2C" + std::string(27, ' ') + "15" + std::string(37, ' ') + "1\n";
  char line[80];
  for (int a = 0; a < 15; ++a) {
    const auto& X = Wedge15::referenceNodes[a];
    std::snprintf(line, sizeof line, " -1%10d%12.5E%12.5E%12.5E\n", a + 1, X[0], X[1], X[2]);
    results += line;
  }
  test::writeBytes(
      folder / "prism.frd",
      results + " -3\n    3C" + std::string(28, ' ') + "1" + std::string(37, ' ') +
          "1\n -1         1    5    0    1\n -2         1         2         3         4         5         6"
          "         7         8         9        13\n -2        14        15        10        11        "
          "12\n -3\n 9999\n");
  for (const std::string name : {"prism.msh", "prism.inp", "prism.frd"}) {
    const Mesh mesh = loadMesh(folder / name, nullptr);
    ASSERT_EQ(mesh.blocks.size(), 1u) << name;
    EXPECT_EQ(mesh.blocks[0].type, info().type) << name;
    for (int a = 0; a < 15; ++a)
      for (int c = 0; c < 3; ++c)
        EXPECT_EQ(mesh.X(c, mesh.blocks[0].element(0)[a]), Wedge15::referenceNodes[a][c]) << name << " node " << a;
    EXPECT_NEAR(meshVolume(mesh), 1, 1e-15) << name;
  }
}

TEST_F(RegisteredElement, WithoutItsKernelsHasNoBody) {
  ElementInfo other = elementInfoOf<Hex8>(ElementType{});
  other.name = "voxel8";
  other.vtkCellType = other.gmshType = 0;
  Mesh mesh = test::gridMesh("hex8", {1, 1, 1}, {1, 1, 1});
  mesh.blocks[0].type = detail::registerElement(other);
  EXPECT_THAT(test::errorOf([&] { const Body body(mesh, material("stvk")); }),
              HasSubstr("element \"voxel8\": is not registered by registerElement"));
}

TEST_F(RegisteredElement, OfTheOtherHandednessIsTurnedRound) {
  Mesh mesh = bentWedge();
  mesh.X.row(2) *= -1;
  // Beside another block that is not: only an element whose files come in both conventions is turned by itself.
  const Mesh box = test::gridMesh("hex8", {1, 1, 1}, {1, 1, 1});
  MeshBlock hexahedron = box.blocks[0];
  for (std::int32_t& node : hexahedron.connectivity) node += 15;
  NodeVectors X(3, 15 + box.X.cols());
  X << mesh.X, box.X.colwise() + Eigen::Vector3d(5, 0, 0);
  mesh.X = X;
  mesh.blocks.push_back(hexahedron);
  std::vector<std::string> notes;
  requireSound(mesh, "a mesh", &notes);
  EXPECT_THAT(notes, ::testing::Contains(HasSubstr("all 1 wedge15 are of the other handedness and were turned round")));
  EXPECT_NEAR(meshVolume(mesh), meshVolume(bentWedge()) + 1, 1e-14);
}

}  // namespace
}  // namespace ringwatch

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <Eigen/Dense>

#include <ringwatch/meshes/adjacency.h>
#include <ringwatch/meshes/check.h>
#include <ringwatch/meshes/generators/generator_registry.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/meshes/index_limits.h>
#include <ringwatch/meshes/quality.h>

#include "tests/meshes/mesh_test_tools.h"

namespace ringwatch {
namespace {

using namespace test;
using ::testing::HasSubstr;

TEST(Generators, EverySplitFillsTheBoxExactlyAndConformingly) {
  for (const CellSubdivision& split : allCellSubdivisions())
    for (const std::array<int, 3> cells : {std::array{1, 1, 1}, std::array{2, 3, 4}, std::array{5, 2, 3}})
      for (const double jitter : {0.0, 0.15}) {
        SCOPED_TRACE(joinText(split.element, " ", split.elementsPerCell, " ", cells[0], " ", jitter));
        BarOptions o;
        o.size = {0.2, 0.04, 0.03};
        o.cells = cells;
        o.element = split.element;
        o.split = split.elementsPerCell;
        o.jitter = jitter;
        const Mesh mesh = generateBar(o);
        const std::size_t cellCount = static_cast<std::size_t>(cells[0] * cells[1] * cells[2]);
        const std::size_t corners = static_cast<std::size_t>((cells[0] + 1) * (cells[1] + 1) * (cells[2] + 1));
        const bool linear = findElementByName(split.element)->order == 1;
        if (linear) {
          EXPECT_EQ(mesh.nodeCount(), corners + (split.centre ? cellCount : 0));
        }
        EXPECT_EQ(mesh.elementCount(), cellCount * static_cast<std::size_t>(split.elementsPerCell));
        EXPECT_TRUE(checkMesh(mesh).empty());
        EXPECT_TRUE(faceNeighbours(mesh).overfull.empty());
        EXPECT_NEAR(meshVolume(mesh), 0.2 * 0.04 * 0.03, 1e-18);
        if (jitter == 0) {
          EXPECT_NEAR(boundaryArea(mesh), 2 * (0.2 * 0.04 + 0.2 * 0.03 + 0.04 * 0.03), 1e-15);
        }
        EXPECT_EQ(connectedParts(mesh).count, 1);
        if (linear) {
          EXPECT_EQ(mesh.nodeSets.at("x-max").size(), (cells[1] + 1) * (cells[2] + 1));
        }
        EXPECT_EQ(mesh.nodeSets.at("x-max").size(), (mesh.X.row(0).array() == 0.2).count());
        for (const std::int32_t n : mesh.nodeSets.at("x-max")) EXPECT_EQ(mesh.X(0, n), 0.2);
        for (const std::int32_t n : mesh.nodeSets.at("z-min")) EXPECT_EQ(mesh.X(2, n), 0.0);
        EXPECT_EQ(mesh.elementSets.at("all").size(), mesh.elementCount());
      }
}

TEST(Generators, FiveTetrahedraACellGiveTheKnownCube) {
  const Mesh mesh = generateCube(1.0, 5, {.split = 5});
  EXPECT_EQ(mesh.nodeCount(), 216u);
  EXPECT_EQ(mesh.elementCount(), 625u);
}

TEST(Generators, JitterDependsOnTheSeedAlone) {
  const BarOptions o{.cells = {4, 3, 2}, .jitter = 0.2, .seed = 42};
  BarOptions other = o;
  other.seed = 43;
  EXPECT_TRUE(generateBar(o).X == generateBar(o).X);
  EXPECT_FALSE(generateBar(o).X == generateBar(other).X);
  // The engine's sequence is fixed by the standard: the first draws of seed 42 belong to node 0, a corner, which stays.
  const Mesh mesh = generateBar({.cells = {2, 2, 2}, .jitter = 0.2, .seed = 1});
  std::mt19937_64 engine(1);
  engine.discard(3 * 13);  // node 13 is the middle one
  for (int k = 0; k < 3; ++k) {
    const double draw = 2.0 * (static_cast<double>(engine() >> 11) * 0x1p-53) - 1.0;
    EXPECT_NEAR(mesh.X(k, 13), 0.5 + 0.2 * 0.5 * draw, 1e-15);
  }
}

TEST(Generators, GradingIsTheRatioOfLastToFirstCell) {
  const Mesh mesh = generateBar({.size = {3, 1, 1}, .cells = {6, 1, 1}, .element = "hex8", .grading = 8});
  EXPECT_NEAR((mesh.X(0, 6) - mesh.X(0, 5)) / (mesh.X(0, 1) - mesh.X(0, 0)), 8, 1e-12);
  EXPECT_EQ(mesh.X(0, 6), 3.0);
  EXPECT_NEAR((mesh.X(0, 3) - mesh.X(0, 2)) / (mesh.X(0, 2) - mesh.X(0, 1)),
              (mesh.X(0, 2) - mesh.X(0, 1)) / (mesh.X(0, 1) - mesh.X(0, 0)), 1e-12);
  EXPECT_NEAR(meshVolume(mesh), 3, 1e-14);
}

TEST(Generators, BallsArePositiveAndConvergeToTheBall) {
  for (const CellSubdivision& split : allCellSubdivisions()) {
    double previous = 0;
    for (const int cells : {1, 2, 3, 4, 8, 16}) {
      const Mesh mesh = generateBall(
          {.radius = 0.5, .cells = cells, .element = std::string(split.element), .split = split.elementsPerCell});
      EXPECT_TRUE(checkMesh(mesh).empty()) << split.element << " " << cells;
      const bool linear = findElementByName(split.element)->order == 1;
      for (const std::int32_t n : mesh.nodeSets.at("surface")) {
        if (linear) {
          EXPECT_NEAR(mesh.X.col(n).norm(), 0.5, 1e-15);
        }
      }
      const double missing = 1 - meshVolume(mesh) / (4.0 / 3.0 * std::numbers::pi * 0.125);
      if (cells == 16) {
        EXPECT_NEAR(previous / missing, 4, 0.4) << "second order";
      }
      previous = missing;
    }
  }
}

TEST(Generators, RingsAndGearsAreClosedAndHaveTheirVolume) {
  for (const CellSubdivision& split : allCellSubdivisions()) {
    RingOptions options{.radius = 0.1, .inner = 0.06, .width = 0.03, .cells = {24, 2, 2}};
    options.element = split.element;
    options.split = split.elementsPerCell;
    const Mesh round = generateRing(options);
    EXPECT_TRUE(checkMesh(round).empty()) << split.element;
    // Two regular polygons of 24 corners.
    const double polygon = 12 * std::sin(2 * std::numbers::pi / 24);
    EXPECT_NEAR(meshVolume(round), polygon * (0.01 - 0.0036) * 0.03, 1e-17) << split.element;
    options.teeth = 3;
    options.toothDepth = 0.01;
    const Mesh gear = generateRing(options);
    EXPECT_TRUE(checkMesh(gear).empty()) << split.element;
    // Triangles of neighbouring radii; half of the 24 lie on flanks of two cells.
    const double low = 0.09, middle = 0.095, high = 0.1;
    const double products = 3 * (2 * high * high + 2 * high * middle + 2 * middle * low + 2 * low * low);
    EXPECT_NEAR(meshVolume(gear), 0.5 * std::sin(2 * std::numbers::pi / 24) * (products - 24 * 0.0036) * 0.03, 1e-17)
        << split.element;
    EXPECT_EQ(gear.nodeSets.at("inside").size(), gear.nodeSets.at("outside").size());
  }
  EXPECT_THAT(errorOf([] {
                generateRing({.cells = {20, 2, 2}, .teeth = 3, .toothDepth = 0.1});
              }),
              HasSubstr("teeth = 3: it must be 0, or 4 cells"));
  EXPECT_THAT(errorOf([] { generateRing({.inner = 2}); }), HasSubstr("radius = 1: it must be above the inner one, 2"));
  EXPECT_THAT(errorOf([] { generateRing({.cells = {5, 1, 1}, .split = 5}); }), HasSubstr("even around"));
  EXPECT_THAT(errorOf([] { generateRing({.cells = {2, 1, 1}}); }), HasSubstr("at least 3"));
  EXPECT_THAT(errorOf([] { generateRing({.teeth = 4, .toothDepth = 0.5}); }), HasSubstr("tooth_depth = 0.5"));
}

TEST(Generators, StacksAreTwoBoxesThatShareNoNode) {
  for (const CellSubdivision& split : allCellSubdivisions()) {
    StackOptions options;
    options.lower = {.size = {2, 1, 1}, .cells = {2, 2, 2}, .origin = {1, 0, 0}, .jitter = 0.2};
    options.lower.element = split.element;
    options.lower.split = split.elementsPerCell;
    options.upperSize = {1, 0.5, 0.5};
    options.upperCells = {2, 1, 1};
    options.gap = 0.25;
    options.offset = {0.5, 0};
    const Mesh mesh = generateStack(options);
    EXPECT_TRUE(checkMesh(mesh).empty()) << split.element;
    EXPECT_NEAR(meshVolume(mesh), 2.25, 1e-13) << split.element;
    const auto& lower = mesh.nodeSets.at("lower");
    const auto& upper = mesh.nodeSets.at("upper");
    EXPECT_EQ(lower.size() + upper.size(), mesh.nodeCount());
    for (const MeshBlock& block : mesh.blocks)
      for (std::size_t e = 0; e < block.elementCount(); ++e) {
        std::size_t below = 0;
        for (int a = 0; a < block.nodesPerElement(); ++a)
          below += std::binary_search(lower.begin(), lower.end(), block.element(e)[a]);
        EXPECT_TRUE(below == 0 || below == static_cast<std::size_t>(block.nodesPerElement()));
      }
    for (const std::int32_t node : mesh.nodeSets.at("upper z-min")) EXPECT_DOUBLE_EQ(mesh.X(2, node), 1.25);
    for (const std::int32_t node : mesh.nodeSets.at("upper x-max")) EXPECT_DOUBLE_EQ(mesh.X(0, node), 3);
    for (const std::int32_t node : mesh.nodeSets.at("lower z-max")) EXPECT_DOUBLE_EQ(mesh.X(2, node), 1);
    EXPECT_EQ(mesh.elementSets.at("lower").size() + mesh.elementSets.at("upper").size(),
              mesh.elementSets.at("all").size());
  }
  EXPECT_THAT(errorOf([] { generateStack({.lower = {}, .gap = -1}); }), HasSubstr("gap = -1: it must be 0 or more"));
}

TEST(Generators, BadOptionsAreNamed) {
  const auto bar = [](BarOptions o) { return errorOf([&] { generateBar(o); }); };
  EXPECT_THAT(bar({.size = {0, 1, 1}}), HasSubstr("size = 0"));
  EXPECT_THAT(bar({.size = {NAN, 1, 1}}), HasSubstr("size = nan"));
  EXPECT_THAT(bar({.cells = {1, -2, 1}}), HasSubstr("cells = -2"));
  EXPECT_THAT(bar({.cells = {30000, 30000, 30000}}), HasSubstr("at most"));
  EXPECT_THAT(bar({.jitter = 0.5}), HasSubstr("below 0.5"));
  EXPECT_THAT(bar({.cells = {8, 8, 8}, .jitter = 0.49}), HasSubstr("inside out"));
  EXPECT_THAT(bar({.grading = 0.5}), HasSubstr("grading = 0.5"));
  EXPECT_THAT(bar({.cells = {100, 1, 1}, .origin = {1, 0, 0}, .grading = 1e300}), HasSubstr("grading"));
  EXPECT_THAT(bar({.element = "tet5"}), HasSubstr("did you mean \"tet4\"? known are tet4, "));
  EXPECT_THAT(bar({.split = 7}), HasSubstr("6 or 5"));
  EXPECT_THAT(errorOf([] { generateBall({.radius = -1}); }), HasSubstr("radius = -1"));
}

TEST(GeneratorTable, EveryKindRunsWithItsDefaultsAndIsDescribed) {
  for (const GeneratorInfo& info : allGenerators()) {
    SCOPED_TRACE(info.name);
    EXPECT_GT(generateMesh(info.name, {}).elementCount(), 0u);
    EXPECT_EQ(findGenerator(info.name), &info);
    for (const GeneratorParameter& p : info.parameters) {
      EXPECT_FALSE(p.help.empty());
      EXPECT_FALSE(parameterRange(p).empty());
      EXPECT_THAT(errorOf([&] {
                    generateMesh(info.name, {{std::string(p.name), p.kind == ParameterKind::text
                                                                       ? GeneratorValue(1.0)
                                                                       : GeneratorValue(std::string("x"))}});
                  }),
                  HasSubstr(std::string(p.name) + " = "));
      if (p.kind == ParameterKind::text) continue;
      EXPECT_THAT(errorOf([&] {
                    generateMesh(info.name,
                                 {{std::string(p.name), std::vector<double>(static_cast<std::size_t>(p.count), NAN)}});
                  }),
                  HasSubstr("nan"));
    }
  }
}

TEST(GeneratorTable, ArgumentsArriveAndMistakesAreNamed) {
  const GeneratorArguments good{{"size", std::vector<double>{0.3, 0.1, 0.1}},
                                {"cells", std::vector<double>{3, 1, 1}},
                                {"element", std::string("hex8")}};
  EXPECT_NEAR(meshVolume(generateMesh("bar", good)), 0.003, 1e-16);
  EXPECT_EQ(generateMesh("cube", {{"cells", 5.0}, {"split", 5.0}}).elementCount(), 625u);
  const auto wrong = [](std::string_view kind, const GeneratorArguments& a) {
    return errorOf([&] { generateMesh(kind, a); });
  };
  EXPECT_THAT(wrong("barr", {}), HasSubstr("did you mean \"bar\"? known are bar, "));
  EXPECT_THAT(wrong("bar", {{"cell", 3.0}}), HasSubstr("did you mean \"cells\"? known are size, cells"));
  EXPECT_THAT(wrong("bar", {{"cells", 3.0}}), HasSubstr("list of 3 integers"));
  EXPECT_THAT(wrong("cube", {{"cells", 2.5}}), HasSubstr("an integer"));
  EXPECT_THAT(wrong("bar", {{"jitter", 0.5}}), HasSubstr("jitter = 0.5: it must be 0 or more and below 0.5"));
  EXPECT_THAT(wrong("bar", {{"element", std::string("hex9")}}), HasSubstr("hex8"));
  EXPECT_THAT(wrong("bar", {{"element", std::string("hex8")}, {"split", 5.0}}), HasSubstr("bar: split = 5"));
}

// Numbers of nodes and elements fit 32 bits, and so do those of degrees of freedom and of a matrix's entries.
TEST(Limits, AreOfThirtyTwoBits) {
  EXPECT_LE(3 * nodeCountLimit + 2, std::numeric_limits<std::int32_t>::max());
  EXPECT_GT(3 * (nodeCountLimit + 1) + 2, std::numeric_limits<std::int32_t>::max());
  // 8e8 nodes have numbers of 32 bits, their degrees of freedom have not.
  for (const std::array<int, 3> cells : {std::array{1000, 1000, 800}, {2000, 2000, 1000}, {46341, 46341, 46341}})
    EXPECT_THROW(generateBar({.cells = cells, .element = "hex8"}), InputError) << cells[0];
  constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max() / 9;
  EXPECT_NO_THROW(requireSparse(1, most));
  EXPECT_THROW(requireSparse(1, most + 1), InputError);
  EXPECT_THROW(requireSparse(1, std::int64_t{1} << 60), InputError);
}

}  // namespace
}  // namespace ringwatch

// What a body refuses, and the words that it finds for it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include <ringwatch/base/error.h>
#include <tests/support/body_cases.h>

namespace ringwatch {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const Material material = makeMaterial("stvk", 30e3, 0.3, 1000);

template <class Error>
std::string refusal(const Mesh& mesh, const std::vector<Material>& materials = {material},
                    const BodyOptions& options = {}) {
  try {
    const Body body(mesh, materials, options);
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(BodyErrors, RefusesAMeshWithoutVolumeElements) {
  EXPECT_THAT(refusal<InputError>(Mesh{}), HasSubstr("no volume elements"));
}

TEST(BodyErrors, RefusesAMeshWhosePartsDoNotFitTogether) {
  const Mesh good = test::distortedBox("tet4", {2, 2, 2});
  EXPECT_EQ(refusal<InputError>(good), "accepted");
  const auto changed = [&](const auto& change) {
    Mesh mesh = good;
    change(mesh);
    return refusal<InputError>(mesh);
  };
  EXPECT_EQ(changed([](Mesh& m) { m.blocks[0].connectivity[13] = 27; }),
            "block 0, tet4 element 3: has node 27; nodes are 0 to 26");
  EXPECT_THAT(changed([](Mesh& m) { m.blocks[0].connectivity[13] = -1; }), HasSubstr("has node -1"));
  EXPECT_THAT(changed([](Mesh& m) { m.blocks[0].connectivity.pop_back(); }),
              HasSubstr("not a multiple of the 4 nodes of a tet4"));
  EXPECT_THAT(changed([](Mesh& m) { m.blocks[0].ids = {1, 2}; }), HasSubstr("block 0: 2 ids for"));
  EXPECT_THAT(changed([](Mesh& m) { m.nodeIds = {1}; }), HasSubstr("1 nodeIds for 27 nodes"));
  EXPECT_THAT(changed([](Mesh& m) { m.nodeSets["a"] = {27}; }), HasSubstr("node set \"a\": has node 27"));
  EXPECT_THAT(changed([](Mesh& m) {
                m.elementSets["a"] = {{1, 0}};
              }),
              HasSubstr("element set \"a\": has element 0 of block 1, which is not there"));
}

TEST(BodyErrors, RefusesABlockWithoutElementsOrSurvivesIt) {
  // A block may be empty beside another that is not.
  Mesh mesh = test::distortedBox("hex8", {2, 2, 2});
  mesh.blocks.push_back({findElementByName("tet4")->type, {}, {}});
  const Body body(mesh, material);
  EXPECT_NEAR(body.volume(), 8e-6, 1e-18);
  NodeVectors f;
  Body::Workspace workspace;
  body.internalForce(mesh.X, f, workspace);
  EXPECT_LE(f.norm(), 1e-12);
}

TEST(BodyErrors, TakesSmallElementsFarFromTheOrigin) {
  // Elements of 1 cm, with coordinates as they are rounded there.
  for (const ElementInfo& element : allElements())
    for (const double away : {1e3, 1e5, 1e7}) {
      Mesh mesh = test::distortedBox(element.name, {2, 2, 2}, 0);
      mesh.X.colwise() += Eigen::Vector3d::Constant(away);
      EXPECT_EQ(refusal<NumericalError>(mesh), "accepted") << element.name << " at " << away << " m";
    }
}

TEST(BodyErrors, NamesAnArrayThatIsNotOneColumnANode) {
  const Body body(test::distortedBox("tet4", {2, 2, 2}), material);
  EXPECT_NO_THROW(body.checkNodal("x", body.mesh().X));
  try {
    body.checkNodal("x", NodeVectors::Zero(3, 5));
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()), "x is 3 x 5: must be 3 x 27, a column for each node");
  }
}

TEST(BodyErrors, NamesAnInvertedElementByItsNumberInTheFile) {
  for (const ElementInfo& element : allElements()) {
    Mesh mesh = test::distortedBox(element.name, {2, 2, 2});
    for (auto& id : mesh.blocks[0].ids) id += 1000;
    const std::size_t bad = mesh.elementCount() / 2;
    std::int32_t* nodes = mesh.blocks[0].connectivity.data() + bad * static_cast<std::size_t>(element.nodes);
    if (element.order == 1) {
      std::swap(nodes[0], nodes[1]);
    } else {  // one corner alone would leave quadrature points upright: the whole mesh is mirrored, cut down to one
              // element
      mesh = test::firstElements(mesh, 1);
      mesh.X.row(0) *= -1;
      mesh.blocks[0].ids[0] = static_cast<std::int64_t>(1000 + bad);
    }
    EXPECT_THAT(refusal<NumericalError>(mesh),
                AllOf(HasSubstr(std::string(element.name)), HasSubstr("element " + std::to_string(1000 + bad) + ":"),
                      HasSubstr("must be > 0")));
  }
}

TEST(BodyErrors, NamesADegenerateElement) {
  for (const ElementInfo& element : allElements()) {
    Mesh mesh = test::firstElements(test::distortedBox(element.name, {2, 2, 2}), 1);
    mesh.X.row(2).setZero();
    EXPECT_THAT(refusal<NumericalError>(mesh),
                AllOf(HasSubstr(std::string(element.name) + " element 0:"), HasSubstr("must be > 0")));
  }
}

TEST(BodyErrors, RefusesPositionsThatAreNotNumbers) {
  for (const ElementInfo& element : allElements()) {
    Mesh mesh = test::distortedBox(element.name, {2, 2, 2});
    mesh.X(1, 3) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(refusal<NumericalError>(mesh), HasSubstr("nan")) << element.name;
  }
}

TEST(BodyErrors, NamesANodeWithoutMass) {
  Mesh mesh = test::distortedBox("hex8", {2, 2, 2});
  mesh.X.conservativeResize(3, mesh.X.cols() + 1);
  mesh.X.col(mesh.X.cols() - 1).setOnes();
  mesh.nodeIds.push_back(28);
  EXPECT_THAT(refusal<NumericalError>(mesh), AllOf(HasSubstr("node 27"), HasSubstr("mass"), HasSubstr("must be > 0")));
}

TEST(BodyErrors, ListsTheRulesWhenOneIsUnknown) {
  for (const ElementInfo& element : allElements()) {
    const std::string text = refusal<InputError>(test::distortedBox(element.name, {2, 2, 2}), {material},
                                                 {{{std::string(element.name), "simpson"}}});
    EXPECT_THAT(text, AllOf(HasSubstr("simpson"), HasSubstr(std::string(element.name))));
    for (const QuadratureRule& rule : element.rules) EXPECT_THAT(text, HasSubstr(std::string(rule.name)));
  }
}

TEST(BodyErrors, CountsMaterialsAgainstBlocks) {
  const Mesh mesh = test::distortedBox("hex8", {2, 2, 2});
  EXPECT_THAT(refusal<InputError>(mesh, {material, material}), AllOf(HasSubstr("2 materials"), HasSubstr("1 blocks")));
  EXPECT_THAT(refusal<InputError>(mesh, {}), HasSubstr("0 materials"));
}

TEST(BodyErrors, RefusesElementsThatAreNotThere) {
  const Body body(test::distortedBox("hex8", {2, 2, 2}), material);
  EXPECT_THROW(body.elementTangent({1, 0}, body.mesh().X), std::out_of_range);
  EXPECT_THROW(body.elementTangent({0, 8}, body.mesh().X), std::out_of_range);
}

}  // namespace
}  // namespace ringwatch

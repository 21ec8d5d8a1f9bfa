// Energies, volumes and masses of elements by themselves add up to those of the body.
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include <ringwatch/body/element_energy.h>
#include <tests/support/body_cases.h>

namespace ringwatch {
namespace {

using test::BodyCase;

class ElementEnergyTest : public ::testing::TestWithParam<BodyCase> {};
INSTANTIATE_TEST_SUITE_P(All, ElementEnergyTest, ::testing::ValuesIn(test::allBodyCases()),
                         [](const auto& test) { return test::bodyCaseName(test.param); });

TEST_P(ElementEnergyTest, AddsUpToTheBody) {
  const Mesh mesh = test::distortedBox(GetParam().element->name, {4, 3, 3});
  const NodeVectors x = test::strained(mesh.X);
  std::vector<std::vector<double>> first;
  for (const int threads : {1, 3}) {
    const Body body(mesh, test::materialOf(GetParam()), test::optionsOf(GetParam(), threads));
    Body::Workspace workspace;
    const auto energies = strainEnergyOfElements(body, x);
    ASSERT_EQ(energies.size(), 1u);
    const double total = body.energy(x, workspace);
    EXPECT_GT(total, 0);
    EXPECT_NEAR(std::accumulate(energies[0].begin(), energies[0].end(), 0.0), total, 3e-14 * total);
    if (first.empty()) first = energies;
    EXPECT_EQ(energies, first) << threads;

    const std::vector<double> volumes = volumeOfElements(body);
    EXPECT_NEAR(std::accumulate(volumes.begin(), volumes.end(), 0.0), body.volume(), 1e-10 * body.volume());
    std::vector<ElementRef> all, even;
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
      all.push_back({0, e});
      if (e % 2 == 0) even.push_back({0, e});
    }
    EXPECT_EQ(lumpedMassOfElements(body, all), body.lumpedMass());
    const double half = lumpedMassOfElements(body, even).sum();
    EXPECT_GT(half, 0);
    EXPECT_LT(half, body.totalMass());
  }
}

TEST_P(ElementEnergyTest, IsThatOfTheElementAlone) {
  const Mesh whole = test::distortedBox(GetParam().element->name, {3, 2, 2});
  const Mesh mesh = test::firstElements(whole, 1);
  const NodeVectors x = test::strained(mesh.X, 5);
  const Body body(mesh, test::materialOf(GetParam()), test::optionsOf(GetParam(), 1));
  Body::Workspace workspace;
  const double alone = body.energy(x, workspace);
  EXPECT_NEAR(strainEnergyOfElements(body, x)[0][0], alone, 1e-15 * alone);
}

TEST(ChosenElements, KeepTheSetsOfTheMesh) {
  Mesh mesh = test::distortedBox("hex8", {3, 2, 1});
  mesh.nodeSets["nodes"] = {0, 5};
  mesh.elementSets["some"] = {{0, 0}, {0, 2}, {0, 5}};
  mesh.elementSets["first"] = {{0, 0}};
  const Body body(mesh, makeMaterial("stvk", 1e4, 0.3, 1000));
  const Body part(body, {{false, true, true, false, true, true}});
  const std::vector<ElementRef> some{{0, 1}, {0, 3}};
  EXPECT_EQ(part.mesh().elementSets.at("some"), some);
  EXPECT_TRUE(part.mesh().elementSets.at("first").empty());
  EXPECT_EQ(part.mesh().nodeSets.at("nodes"), mesh.nodeSets.at("nodes"));
  EXPECT_EQ(part.lumpedMass(), body.lumpedMass());
}

}  // namespace
}  // namespace ringwatch

// Elements by number, by name, and by the numbers that file formats give them.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include <ringwatch/elements/registry.h>

namespace ringwatch {
namespace {

TEST(ElementRegistry, ListsEveryElementAtItsPlace) {
  ASSERT_EQ(allElements().size(), Elements::size);
  std::set<std::string_view> names;
  std::set<int> vtk, gmsh;
  for (std::size_t i = 0; i < allElements().size(); ++i) {
    const ElementInfo& info = allElements()[i];
    EXPECT_EQ(static_cast<std::size_t>(info.type), i);
    EXPECT_EQ(&elementInfo(info.type), &info);
    EXPECT_EQ(findElementByName(info.name), &info);
    EXPECT_EQ(findElementByVtkType(info.vtkCellType), &info);
    EXPECT_EQ(findElementByGmshType(info.gmshType), &info);
    EXPECT_TRUE(names.insert(info.name).second);
    EXPECT_TRUE(vtk.insert(info.vtkCellType).second);
    EXPECT_TRUE(gmsh.insert(info.gmshType).second);
  }
}

TEST(ElementRegistry, HasTheNumbersOfTheFileFormats) {
  EXPECT_EQ(findElementByName("tet4")->vtkCellType, 10);
  EXPECT_EQ(findElementByName("tet4")->gmshType, 4);
  EXPECT_EQ(findElementByName("hex8")->vtkCellType, 12);
  EXPECT_EQ(findElementByName("hex8")->gmshType, 5);
  EXPECT_EQ(findElementByName("wedge6")->vtkCellType, 13);
  EXPECT_EQ(findElementByName("wedge6")->gmshType, 6);
  EXPECT_EQ(findElementByName("pyramid5")->vtkCellType, 14);
  EXPECT_EQ(findElementByName("pyramid5")->gmshType, 7);
  EXPECT_EQ(findElementByName("tet10")->vtkCellType, 24);
  EXPECT_EQ(findElementByName("tet10")->gmshType, 11);
  EXPECT_EQ(findElementByName("hex20")->vtkCellType, 25);
  EXPECT_EQ(findElementByName("hex20")->gmshType, 17);
}

TEST(ElementRegistry, FindsNothingUnderUnknownNames) {
  EXPECT_EQ(findElementByName("tri3"), nullptr);
  EXPECT_EQ(findElementByName(""), nullptr);
  EXPECT_EQ(findElementByVtkType(5), nullptr);
  EXPECT_EQ(findElementByGmshType(2), nullptr);
}

TEST(ElementRegistry, FindsRulesByNameAndTheFirstByDefault) {
  for (const ElementInfo& info : allElements()) {
    EXPECT_EQ(findRule(info, ""), &info.rules[0]);
    for (const QuadratureRule& rule : info.rules) {
      EXPECT_EQ(findRule(info, rule.name), &rule);
      if (!rule.alias.empty()) {
        EXPECT_EQ(findRule(info, rule.alias), &rule);
      }
    }
    for (const QuadratureRule& rule : info.rules) EXPECT_EQ(findRule(info, rule.name), &rule);
    EXPECT_EQ(findRule(info, "simpson"), nullptr);
  }
}

TEST(ElementRegistry, ViewsAgreeWithTheTypes) {
  forEachType(Elements{}, [](auto tag) {
    using E = typename decltype(tag)::type;
    const ElementInfo& info = elementInfo(elementTypeOf<E>);
    EXPECT_EQ(info.name, E::name);
    EXPECT_EQ(info.nodes, E::nodes);
    EXPECT_EQ(static_cast<int>(info.referenceNodes.size()), E::nodes);
    EXPECT_EQ(info.constantGradient, E::constantGradient);
    EXPECT_EQ(info.faces.size(), E::faces.size());
    EXPECT_EQ(info.edges.size(), E::edges.size());
    const double xi[3] = {0.2, 0.1, 0.15};
    double viaInfo[E::nodes], direct[E::nodes], dViaInfo[E::nodes][3], dDirect[E::nodes][3];
    info.shape(xi, viaInfo);
    E::shape(xi, direct);
    info.shapeGradient(xi, dViaInfo);
    E::shapeGradient(xi, dDirect);
    for (int a = 0; a < E::nodes; ++a) {
      EXPECT_EQ(viaInfo[a], direct[a]);
      for (int j = 0; j < 3; ++j) EXPECT_EQ(dViaInfo[a][j], dDirect[a][j]);
    }
    int visits = 0;
    visitElement(info.type, [&](auto visited) { visits += std::is_same_v<typename decltype(visited)::type, E>; });
    EXPECT_EQ(visits, 1);
  });
}

}  // namespace
}  // namespace ringwatch

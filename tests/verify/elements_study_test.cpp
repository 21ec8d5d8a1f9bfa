// The element study: its criteria, and what is deficient is shown as deficient.
#include <gtest/gtest.h>

#include <string>

#include <ringwatch/elements/registry.h>
#include <ringwatch/verify/elements/elements.h>

#include "criteria.h"
#include "report_tools.h"

namespace ringwatch {
namespace {

const StudyReport& elementsReport() {
  static const StudyReport made = verifyElements(StudyEffort::quick);
  return made;
}

TEST(ElementStudy, HoldsElementsToTheirCriteria) {
  using test::Basis;
  constexpr double rounding = 1e-14;  // of sums of some tens of terms
  test::expectCriteria(
      elementsReport(),
      {{"*: shape functions sum to one", rounding, Basis::rounding},
       {"*: linear fields have their gradient", rounding, Basis::rounding},
       {"*: volume of a distorted cube", rounding, Basis::rounding},
       {"*: mass of a distorted cube", rounding, Basis::rounding},
       {"*: least share of a node in the lumped mass", rounding, Basis::theory},  // at least that of a corner of tet10
       {"*: zero modes*", 0, Basis::theory},
       {"*: patch test, force", rounding, Basis::rounding},
       {"*: patch test, position", rounding, Basis::rounding},
       {"*: linear strain", 2.5e-13, Basis::rounding},  // of positions, times stiffness over load: 9e-14
       // The difference quotients' own errors.
       {"*: force is the slope of the energy", 1e-11, Basis::rounding},
       {"*: tangent is the slope of the force", 4e-10, Basis::rounding},
       {"*: tangent is symmetric", rounding, Basis::rounding},
       {"*: force turns with the body", rounding, Basis::rounding},
       // Coarse meshes, where the next order is still seen: 0.049 and 0.020.
       {"*: rate in L2", 0.1, Basis::measured},
       {"*: rate in H1", 0.05, Basis::measured},
       // Errors of the mesh.
       {"*0: rod, *, relative error", 0.01, Basis::measured},  // tet10 and hex20
       {"*: rod, *, relative error", 0.003, Basis::measured},
       {"*: ball, breathing, *, relative error", 0.03, Basis::measured},
       {"*: ball, torsional, *, relative error", 0.05, Basis::measured},
       {"*0: cantilever, *, relative error", 0.01, Basis::measured},
       {"*: cantilever, *, relative error", 0.06, Basis::measured},
       {"*: *, rate of the frequency", 0.25, Basis::measured},  // the slowest comes with 1.91
       {"*: deflection at nu = 0.499 over that at 0.3", 0.2, Basis::measured},
       {"hex20 gauss-3x3x3: cantilever over Timoshenko's beam, nu = 0", 9e-5, Basis::measured},
       {"hex20 gauss-3x3x3: cantilever over Timoshenko's beam, nu = 0.3", 0.02, Basis::measured}});
}

TEST(ElementStudy, CoversEveryElementAndRule) {
  std::set<std::string> elements, rules;
  for (const ElementInfo& element : allElements()) {
    elements.insert(std::string(element.name));
    for (const QuadratureRule& rule : element.rules)
      rules.insert(std::string(element.name) + " " + std::string(rule.name));
  }
  std::set<std::string> ranked;
  for (const auto& row : test::tableOf(elementsReport(), "rank").rows)
    ranked.insert(std::get<std::string>(row[0]) + " " + std::get<std::string>(row[1]));
  EXPECT_EQ(ranked, rules);
  EXPECT_EQ(test::textsOf(test::tableOf(elementsReport(), "shapes"), 0), elements);
  EXPECT_EQ(test::textsOf(test::tableOf(elementsReport(), "derivatives"), 0), elements);
  EXPECT_EQ(test::textsOf(test::tableOf(elementsReport(), "convergence"), 0), elements);
  EXPECT_EQ(test::textsOf(test::tableOf(elementsReport(), "frequencies"), 1), elements);
}

TEST(ElementStudy, ShowsTheDeficientRules) {
  std::set<std::string> deficient;
  for (const auto& row : test::tableOf(elementsReport(), "rank").rows) {
    const std::string rule = std::get<std::string>(row[0]) + " " + std::get<std::string>(row[1]);
    const std::int64_t expected = rule == "wedge6 fierz2013" ? 1 : rule == "hex20 gauss-2x2x2" ? 6 : 0;
    EXPECT_EQ(std::get<std::int64_t>(row[4]), expected) << rule;
    if (std::get<std::string>(row[7]) == "deficient") deficient.insert(rule);
  }
  EXPECT_EQ(deficient, (std::set<std::string>{"wedge6 fierz2013", "hex20 gauss-2x2x2"}));
}

TEST(ElementStudy, DrawsWhatItMeasured) {
  test::expectWellFormed(elementsReport());
  EXPECT_EQ(test::figureNames(elementsReport()),
            (std::set<std::string>{"elements-error-size", "elements-tip-error-size", "elements-tip-error-time"}));
  for (const StudyFigure& figure : elementsReport().figures)
    for (const StudyFigure::Curve& curve : figure.curves) EXPECT_GE(curve.x.size(), 2u) << figure.name;
}

}  // namespace
}  // namespace ringwatch

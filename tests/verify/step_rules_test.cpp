// Step rules of other solvers against the exact step.
#include <gtest/gtest.h>

#include <cmath>

#include <ringwatch/verify/step_rules/step_rules.h>

#include "report_tools.h"

namespace ringwatch {
namespace {

TEST(VerifyStepRules, BracketsAreProvenAndRulesMeetClosedForms) {
  const StudyReport report = verifyStepRules(StudyEffort::quick);
  test::expectHolds(report);
  const StudyTable& table = test::tableOf(report, "step-rules");
  const auto at = [&](const std::string& mesh, const std::string& column) {
    for (const auto& row : table.rows)
      if (std::get<std::string>(row[0]) == mesh)
        for (std::size_t c = 1; c < row.size(); ++c)
          if (table.columns[c] == column) return std::get<double>(row[c]);
    ADD_FAILURE() << mesh << ", " << column;
    return std::nan("");
  };
  // Cubes of 2 cm, c = 36.69 m/s: edges and heights are 545.1 us, the diameter √3 of it, CalculiX's rule 0.767 of it.
  const double speed = std::sqrt(1e6 * 0.7 / (1.3 * 0.4) / 1000), edge = 1e6 * 0.02 / speed;
  const double exact = at("hex8", "exact (us)");
  EXPECT_NEAR(at("hex8", "shortest edge"), edge / exact, 6e-4);
  EXPECT_NEAR(at("hex8", "diameter"), std::sqrt(3) * edge / exact, 6e-4);
  EXPECT_NEAR(at("hex8", "CalculiX"), 0.76689 * edge / exact, 6e-4);
  EXPECT_NEAR(at("hex8", "dilatational"), edge / std::sqrt(3) / exact, 6e-4);
  EXPECT_NEAR(at("hex8", "V / max A"), edge / exact, 6e-4);
  EXPECT_NEAR(at("hex8", "nodal"), edge / exact, 6e-4);
  EXPECT_NEAR(at("wedge6", "CalculiX") / at("wedge6", "V / max A"), 0.76689 / 2, 2e-3);
}

}  // namespace
}  // namespace ringwatch

// The study of published values as a whole: everything holds, each value has a source, and deviations shrink with the
// mesh.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include <ringwatch/verify/literature/literature.h>

#include "report_tools.h"

namespace ringwatch {
namespace {

const StudyReport& literatureReport() {
  static const StudyReport report = verifyLiterature(StudyEffort::quick);
  return report;
}

TEST(Literature, EveryValueAgrees) { test::expectHolds(literatureReport(), 140); }

TEST(Literature, NamesASourceForEveryValue) {
  std::set<std::string> sources;
  for (const StudyTable& table : literatureReport().tables)
    for (const auto& row : table.rows) {
      EXPECT_FALSE(test::textAt(row, 1).empty()) << table.name;
      EXPECT_FALSE(test::textAt(row, 2).empty()) << table.name;
      sources.insert(test::textAt(row, 1));
    }
  EXPECT_GE(sources.size(), 8U);
}

TEST(Literature, BarsConvergeByTheSecondOrder) {
  // A fourth of the size: a sixteenth of the deviation.
  std::map<std::string, double> deviations;
  for (const auto& row : test::tableOf(literatureReport(), "frequencies").rows)
    deviations[std::get<std::string>(row[0])] = test::numberAt(row, 5);
  for (const char* const ends : {"free-free", "fixed-free", "fixed-fixed"}) {
    const std::string bar = std::string("bar, ") + ends + ", ";
    EXPECT_NEAR(deviations.at(bar + "4 elements, mode 1") / deviations.at(bar + "16 elements, mode 1"), 16, 0.5)
        << ends;
  }
}

TEST(Literature, AThickPlateLiesBelowAThinOne) {
  // Kirchhoff's plate, whose frequencies are closed: pi² (m² + n²) h/a² sqrt(E/(12 (1 - nu²) rho)) / 2 pi. Shear and
  // rotary inertia lower them, by some per cent at a tenth of the length.
  const double kirchhoff = M_PI * M_PI * 2 / 100 * std::sqrt(200e9 / (12 * (1 - 0.09) * 8000)) / (2 * M_PI);
  int found = 0;
  for (const auto& row : test::tableOf(literatureReport(), "frequencies").rows) {
    const auto& name = std::get<std::string>(row[0]);
    if (name.find("elastic plate, mode 1, 1") != 0 && name.find("FV52, mode 4") != 0) continue;
    ++found;
    EXPECT_LT(test::numberAt(row, 4), kirchhoff) << name;
    EXPECT_GT(test::numberAt(row, 4), 0.9 * kirchhoff) << name;
  }
  EXPECT_EQ(found, 2);
}

}  // namespace
}  // namespace ringwatch

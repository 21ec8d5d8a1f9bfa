#pragma once
#include <regex>
#include <set>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <ringwatch/verify/report.h>

namespace ringwatch::test {

inline const StudyTable& tableOf(const StudyReport& report, const std::string& name) {
  for (const StudyTable& table : report.tables)
    if (table.name == name) return table;
  throw std::runtime_error("no table " + name);
}
inline std::set<std::string> tableNames(const StudyReport& report) {
  std::set<std::string> names;
  for (const StudyTable& table : report.tables) names.insert(table.name);
  return names;
}
inline std::set<std::string> figureNames(const StudyReport& report) {
  std::set<std::string> names;
  for (const StudyFigure& figure : report.figures) names.insert(figure.name);
  return names;
}
using Row = std::vector<StudyTable::Cell>;
inline const std::string& textAt(const Row& row, std::size_t column) { return std::get<std::string>(row.at(column)); }
inline double numberAt(const Row& row, std::size_t column) { return std::get<double>(row.at(column)); }
/// The texts of a column, each once.
inline std::set<std::string> textsOf(const StudyTable& table, std::size_t column) {
  std::set<std::string> texts;
  for (const auto& row : table.rows) texts.insert(std::get<std::string>(row.at(column)));
  return texts;
}

/// At least so many checks are there; each holds and has a name of its own; tables have rows, as wide as their columns,
/// which name their units themselves; figures have curves, and those as many x as y.
inline void expectHolds(const StudyReport& report, std::size_t checks = 1) {
  std::set<std::string> names;
  for (const StudyCheck& check : report.checks) {
    EXPECT_TRUE(names.insert(check.name).second) << "two checks are called " << check.name;
    EXPECT_TRUE(check.passed()) << check.name << ": measured " << check.measured << ", expected " << check.expected
                                << " to " << check.tolerance;
  }
  EXPECT_GE(names.size(), checks) << report.study;
  EXPECT_EQ(tableNames(report).size(), report.tables.size()) << "two tables of one name";
  EXPECT_EQ(figureNames(report).size(), report.figures.size()) << "two figures of one name";
  for (const StudyTable& table : report.tables) {
    EXPECT_FALSE(table.rows.empty()) << table.name;
    EXPECT_FALSE(std::regex_search(table.title, std::regex(R"(\((s|ms|us|Hz|rad/s|J|%)\))"))) << table.title;
    for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size()) << table.name;
  }
  for (const StudyFigure& figure : report.figures) {
    EXPECT_FALSE(figure.curves.empty()) << figure.name;
    for (const StudyFigure::Curve& curve : figure.curves)
      EXPECT_EQ(curve.x.size(), curve.y.size()) << figure.name << ", " << curve.label;
  }
}

}  // namespace ringwatch::test

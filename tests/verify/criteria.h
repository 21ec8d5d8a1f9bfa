#pragma once
#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include <ringwatch/verify/report.h>

/// The limits of the studies, stated a second time: a limit loosened in a study must be loosened here too.
namespace ringwatch::test {

/// What a limit rests on.
enum class Basis {
  measured,  // the physics of the case: at most three times what is measured, else it is to be tightened
  rounding,  // a unit of rounding or of an iteration, however far below it this machine stays
  theory     // a statement that holds or does not: a proof, a count, a direction
};

/// A limit on how far checks of a study may be from what is expected.
struct Criterion {
  std::string checks;  // their names; * stands for any text
  double limit;
  Basis basis;
};

inline bool matches(std::string_view pattern, std::string_view name) {
  if (pattern.empty()) return name.empty();
  if (pattern.front() != '*')
    return !name.empty() && pattern.front() == name.front() && matches(pattern.substr(1), name.substr(1));
  for (std::size_t skipped = 0; skipped <= name.size(); ++skipped)
    if (matches(pattern.substr(1), name.substr(skipped))) return true;
  return false;
}

/// Holds every check of a report to the first criterion that it matches, and every criterion to be of use: each check
/// has a criterion and the study states the same limit, each criterion has a check, and none that was measured is more
/// than three times too wide.
inline void expectCriteria(const StudyReport& report, const std::vector<Criterion>& criteria) {
  std::vector<double> largest(criteria.size(), -1);
  std::vector<int> count(criteria.size(), 0);
  std::set<std::string> names;
  for (const StudyCheck& check : report.checks) {
    EXPECT_TRUE(names.insert(check.name).second) << "two checks are called " << check.name;
    std::size_t i = 0;
    while (i < criteria.size() && !matches(criteria[i].checks, check.name)) ++i;
    if (i == criteria.size()) {
      ADD_FAILURE() << "no criterion for \"" << check.name << "\", measured " << check.measured;
      continue;
    }
    ++count[i];
    largest[i] = std::max(largest[i], check.deviation());
    EXPECT_LE(check.deviation(), criteria[i].limit)
        << check.name << ": measured " << check.measured << ", expected " << check.expected;
    EXPECT_DOUBLE_EQ(check.tolerance, criteria[i].limit) << check.name << ": the study has another limit";
    EXPECT_EQ(check.passed(), check.deviation() <= criteria[i].limit) << check.name;
  }
  for (std::size_t i = 0; i < criteria.size(); ++i) {
    EXPECT_GT(count[i], 0) << "no check is called \"" << criteria[i].checks << "\"";
    if (criteria[i].basis == Basis::measured) {
      EXPECT_LE(criteria[i].limit, 3 * largest[i])
          << "tighten \"" << criteria[i].checks << "\": measured " << largest[i];
    }
  }
}

}  // namespace ringwatch::test

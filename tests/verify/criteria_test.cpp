// The criteria themselves: what is missing, different or too wide fails.
#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include "criteria.h"

namespace ringwatch {
namespace {

using test::Basis;

StudyReport one(double measured, double limit) {
  StudyReport report;
  checkBelow(report, "bar: error", measured, limit);
  return report;
}

TEST(Criteria, MatchNamesWithStars) {
  EXPECT_TRUE(test::matches("bar: error", "bar: error"));
  EXPECT_TRUE(test::matches("*: error", "bar: error"));
  EXPECT_TRUE(test::matches("bar*", "bar"));
  EXPECT_TRUE(test::matches("*a*r*", "bar: error"));
  EXPECT_FALSE(test::matches("*: error", "bar: error of energy"));
  EXPECT_FALSE(test::matches("", "bar"));
}

TEST(Criteria, AcceptWhatIsWithinAThird) {
  test::expectCriteria(one(0.1, 0.25), {{"bar: error", 0.25, Basis::measured}});
  test::expectCriteria(one(1e-16, 1e-14), {{"*", 1e-14, Basis::rounding}});
}

TEST(Criteria, FailForACheckWithoutACriterion) {
  EXPECT_NONFATAL_FAILURE(test::expectCriteria(one(0.1, 0.25), {}), "no criterion for \"bar: error\"");
}

TEST(Criteria, FailForACriterionWithoutACheck) {
  EXPECT_NONFATAL_FAILURE(
      test::expectCriteria(one(0.1, 0.25), {{"bar*", 0.25, Basis::measured}, {"cube*", 1, Basis::theory}}),
      "no check is called \"cube*\"");
}

TEST(Criteria, FailForALimitThatTheStudyHasLoosened) {
  EXPECT_NONFATAL_FAILURE(test::expectCriteria(one(0.1, 0.5), {{"bar*", 0.25, Basis::measured}}),
                          "the study has another limit");
}

TEST(Criteria, FailForALimitThatIsMoreThanThreeTimesTheMeasured) {
  EXPECT_NONFATAL_FAILURE(test::expectCriteria(one(0.1, 0.5), {{"bar*", 0.5, Basis::measured}}), "tighten \"bar*\"");
}

TEST(Criteria, FailForAValueBeyondTheLimit) {
  EXPECT_NONFATAL_FAILURE(test::expectCriteria(one(0.5, 0.25), {{"bar*", 0.25, Basis::measured}}), "measured 0.5");
}

}  // namespace
}  // namespace ringwatch

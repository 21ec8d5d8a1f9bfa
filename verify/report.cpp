#include <ringwatch/verify/report.h>

#include <cmath>
#include <utility>

namespace ringwatch {

double StudyCheck::deviation() const {
  if (measured == expected) return 0;
  switch (sense) {
    case Sense::near:
      return std::abs(measured - expected);
    case Sense::atMost:
      return measured - expected;
    case Sense::atLeast:
      return expected - measured;
  }
  return std::nan("");
}
bool StudyCheck::passed() const { return std::isfinite(tolerance) && deviation() <= tolerance; }

void checkNear(StudyReport& report, std::string name, double measured, double expected, double tolerance) {
  report.checks.push_back({std::move(name), measured, expected, tolerance, StudyCheck::Sense::near});
}
void checkBelow(StudyReport& report, std::string name, double measured, double bound) {
  checkAtMost(report, std::move(name), measured, 0, bound);
}
void checkAtMost(StudyReport& report, std::string name, double measured, double expected, double tolerance) {
  report.checks.push_back({std::move(name), measured, expected, tolerance, StudyCheck::Sense::atMost});
}
void checkAtLeast(StudyReport& report, std::string name, double measured, double expected, double tolerance) {
  report.checks.push_back({std::move(name), measured, expected, tolerance, StudyCheck::Sense::atLeast});
}

}  // namespace ringwatch

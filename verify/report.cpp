#include <ringwatch/verify/report.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ringwatch {

void checkNear(StudyReport& report, std::string name, double measured, double expected, double tolerance) {
  report.checks.push_back({std::move(name), measured, expected, tolerance, std::abs(measured - expected) <= tolerance});
}
void checkBelow(StudyReport& report, std::string name, double measured, double bound) {
  report.checks.push_back({std::move(name), measured, 0, bound, measured <= bound});
}

double median(std::vector<double> values) {
  if (values.empty()) return std::nan("");
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace ringwatch

#include <ringwatch/app/scene/time_table.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include <ringwatch/base/error.h>
#include <ringwatch/base/user_text.h>

namespace ringwatch {
namespace {

/// How far a ramp has come at the share s of its time, and the integral of that over the share.
double shape(Ramp ramp, double s) {
  switch (ramp) {
    case Ramp::linear:
      return s;
    case Ramp::smooth:
      return s * s * (3 - 2 * s);
    case Ramp::quintic:
      return s * s * s * (10 + s * (6 * s - 15));
    case Ramp::hold:
      return 0;
  }
  return 0;
}
double shapeIntegral(Ramp ramp, double s) {
  switch (ramp) {
    case Ramp::linear:
      return 0.5 * s * s;
    case Ramp::smooth:
      return s * s * s * (1 - 0.5 * s);
    case Ramp::quintic:
      return s * s * s * s * (2.5 + s * (s - 3));
    case Ramp::hold:
      return 0;
  }
  return 0;
}
/// Its derivative.
double shapeSlope(Ramp ramp, double s) {
  switch (ramp) {
    case Ramp::linear:
      return 1;
    case Ramp::smooth:
      return 6 * s * (1 - s);
    case Ramp::quintic:
      return 30 * s * s * (1 - s) * (1 - s);
    case Ramp::hold:
      return 0;
  }
  return 0;
}

/// Gauss-Legendre abscissas and weights on [-1, 1]: the roots of the Legendre polynomial by Newton's method.
constexpr int gaussPoints = 10;
struct GaussRule {
  std::array<double, gaussPoints> x, weight;
};
GaussRule makeRule() {
  GaussRule rule;
  for (int i = 0; i < gaussPoints; ++i) {
    double x = std::cos(std::numbers::pi * (i + 0.75) / (gaussPoints + 0.5)), slope = 1;
    for (int iteration = 0; iteration < 20; ++iteration) {
      double before = 1, value = x;
      for (int n = 2; n <= gaussPoints; ++n)
        before = std::exchange(value, ((2 * n - 1) * x * value - (n - 1) * before) / n);
      slope = gaussPoints * (x * value - before) / (x * x - 1);
      x -= value / slope;
    }
    rule.x[i] = x;
    rule.weight[i] = 2 / ((1 - x * x) * slope * slope);
  }
  return rule;
}
const GaussRule& gaussRule() {
  static const GaussRule rule = makeRule();
  return rule;
}

}  // namespace

TimeTable::TimeTable(TimeExpression expression, double end)
    : times_{0}, integrals_{0}, expression_(std::move(expression)) {
  constexpr int first = 64, samples = 1024;  // panels to begin with; where its size is asked
  double size = 0;
  for (int i = 0; i <= samples; ++i) size = std::max(size, std::abs(checked(end * i / samples)));
  for (int i = 0; i < first; ++i) {
    const double a = end * i / first, b = end * (i + 1) / first;
    divide(a, b, gauss(a, b), 1e-15 * size * end);
  }
}

double TimeTable::checked(double t) const {
  const double value = expression_->at(t).value;
  if (!std::isfinite(value))
    throw InputError(fmt::format("{} has no value at t = {:.6g} s", inQuotes(expression_->text()), t));
  return value;
}

double TimeTable::gauss(double a, double b) const {
  const GaussRule& rule = gaussRule();
  double sum = 0;
  for (int i = 0; i < gaussPoints; ++i)
    sum += rule.weight[i] * expression_->at(0.5 * (a + b) + 0.5 * (b - a) * rule.x[i]).value;
  return 0.5 * (b - a) * sum;
}

void TimeTable::divide(double a, double b, double whole, double tolerance) {
  // Fewer of a long text, which takes as long in all.
  constexpr std::size_t mostPanels = 131072, longText = 250;  // characters
  const std::size_t most = mostPanels * longText / std::max(longText, expression_->text().size());
  const double middle = 0.5 * (a + b);
  checked(middle);
  const double left = gauss(a, middle), right = gauss(middle, b);
  // A kink ends in a panel that has no inner times.
  if (std::abs(left + right - whole) <= tolerance || !(a < middle && middle < b)) {
    if (times_.size() + 2 > most)
      throw InputError(
          fmt::format("{} changes too often before the end to be integrated", inQuotes(expression_->text())));
    for (const auto& [end, part] : {std::pair(middle, left), std::pair(b, right)}) {
      times_.push_back(end);
      integrals_.push_back(integrals_.back() + part);
    }
    return;
  }
  divide(a, middle, left, tolerance);
  divide(middle, b, right, tolerance);
}

TimeTable::TimeTable(std::vector<double> times, std::vector<double> factors, Ramp ramp)
    : times_(std::move(times)), factors_(std::move(factors)), integrals_{0}, ramp_(ramp) {
  if (times_.size() != factors_.size())
    throw InputError(fmt::format("{} times and {} factors; give as many of both", times_.size(), factors_.size()));
  if (times_.size() < 2) throw InputError(fmt::format("{} points; a table needs two and more", times_.size()));
  for (std::size_t i = 1; i < times_.size(); ++i) {
    const double length = times_[i] - times_[i - 1];
    if (!(length > 0))
      throw InputError(fmt::format("the times must increase, but {} s follows {} s", times_[i], times_[i - 1]));
    const double mean = ramp == Ramp::hold ? factors_[i - 1] : 0.5 * (factors_[i - 1] + factors_[i]);
    integrals_.push_back(integrals_.back() + length * mean);
  }
}

double TimeTable::slope(double t) const {
  if (expression_) return expression_->at(t).slope;
  if (t < times_.front() || t >= times_.back()) return 0;
  const auto i = static_cast<std::size_t>(std::upper_bound(times_.begin(), times_.end(), t) - times_.begin());
  const double length = times_[i] - times_[i - 1];
  return shapeSlope(ramp_, (t - times_[i - 1]) / length) * (factors_[i] - factors_[i - 1]) / length;
}

double TimeTable::at(double t) const {
  if (expression_) return expression_->at(t).value;
  if (t <= times_.front()) return factors_.front();
  if (t >= times_.back()) return factors_.back();
  const auto i = static_cast<std::size_t>(std::upper_bound(times_.begin(), times_.end(), t) - times_.begin());
  const double s = (t - times_[i - 1]) / (times_[i] - times_[i - 1]);
  return factors_[i - 1] + shape(ramp_, s) * (factors_[i] - factors_[i - 1]);
}

double TimeTable::largest() const {
  double most = 0;
  for (const double factor : factors_) most = std::max(most, std::abs(factor));
  if (expression_)
    for (const double t : times_) most = std::max(most, std::abs(at(t)));
  return most;
}

double TimeTable::steepest() const {
  double most = 0;
  for (std::size_t i = 0; i < times_.size(); ++i) {
    most = std::max(most, std::abs(slope(times_[i])));
    // In the middle of its piece a smooth ramp is steepest.
    if (i > 0) most = std::max(most, std::abs(slope(0.5 * (times_[i - 1] + times_[i]))));
  }
  return most;
}

double TimeTable::integralTo(double t) const {
  if (expression_) {
    const auto behind = std::upper_bound(times_.begin(), times_.end(), t);
    const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, behind - times_.begin())) - 1;
    return integrals_[i] + gauss(times_[i], t);
  }
  if (t <= times_.front()) return factors_.front() * (t - times_.front());
  if (t >= times_.back()) return integrals_.back() + factors_.back() * (t - times_.back());
  const auto i = static_cast<std::size_t>(std::upper_bound(times_.begin(), times_.end(), t) - times_.begin());
  const double length = times_[i] - times_[i - 1], s = (t - times_[i - 1]) / length;
  return integrals_[i - 1] + length * (s * factors_[i - 1] + shapeIntegral(ramp_, s) * (factors_[i] - factors_[i - 1]));
}

}  // namespace ringwatch

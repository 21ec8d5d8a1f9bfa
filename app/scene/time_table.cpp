#include <ringwatch/app/scene/time_table.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include <ringwatch/base/error.h>

namespace ringwatch {
namespace {

/// How far a ramp has come at the share s of its time, and the integral of that over the share.
double shape(Ramp ramp, double s) { return ramp == Ramp::linear ? s : ramp == Ramp::smooth ? s * s * (3 - 2 * s) : 0; }
double shapeIntegral(Ramp ramp, double s) {
  return ramp == Ramp::linear ? 0.5 * s * s : ramp == Ramp::smooth ? s * s * s * (1 - 0.5 * s) : 0;
}

}  // namespace

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

double TimeTable::at(double t) const {
  if (t <= times_.front()) return factors_.front();
  if (t >= times_.back()) return factors_.back();
  const auto i = static_cast<std::size_t>(std::upper_bound(times_.begin(), times_.end(), t) - times_.begin());
  const double s = (t - times_[i - 1]) / (times_[i] - times_[i - 1]);
  return factors_[i - 1] + shape(ramp_, s) * (factors_[i] - factors_[i - 1]);
}

double TimeTable::largest() const {
  double most = 0;
  for (const double factor : factors_) most = std::max(most, std::abs(factor));
  return most;
}

double TimeTable::integralTo(double t) const {
  if (t <= times_.front()) return factors_.front() * (t - times_.front());
  if (t >= times_.back()) return integrals_.back() + factors_.back() * (t - times_.back());
  const auto i = static_cast<std::size_t>(std::upper_bound(times_.begin(), times_.end(), t) - times_.begin());
  const double length = times_[i] - times_[i - 1], s = (t - times_[i - 1]) / length;
  return integrals_[i - 1] + length * (s * factors_[i - 1] + shapeIntegral(ramp_, s) * (factors_[i] - factors_[i - 1]));
}

}  // namespace ringwatch

#pragma once
#include <string>
#include <vector>

#include <ringwatch/base/name_table.h>

namespace ringwatch {

/// How a table goes from one of its points to the next.
enum class Ramp { linear, smooth, hold };
inline constexpr auto rampNames = nameTable<Ramp>({
    {Ramp::linear, "linear", "straight lines"},
    {Ramp::smooth, "smooth", "s²(3 - 2s), whose slope is zero at the points"},
    {Ramp::hold, "hold", "the factor stays until the next time"},
});

/// A factor of a load or a motion as a function of time: a table of points, constant before the first and after the
/// last.
class TimeTable {
 public:
  /// times: s, increasing. Throws InputError that says what is wrong, for lists of different length, fewer than two
  /// points and times that do not increase.
  TimeTable(std::vector<double> times, std::vector<double> factors, Ramp ramp);

  /// The factor at time t, s.
  double at(double t) const;
  /// Its mean over [t, t + h], h > 0, s; exact.
  double mean(double t, double h) const { return (integralTo(t + h) - integralTo(t)) / h; }

  /// The largest absolute value of the factor.
  double largest() const;

  friend bool operator==(const TimeTable&, const TimeTable&) = default;

 private:
  double integralTo(double t) const;  // from the first point

  std::vector<double> times_, factors_;
  std::vector<double> integrals_;  // to each point
  Ramp ramp_;
};

}  // namespace ringwatch

#pragma once
#include <optional>
#include <string>
#include <vector>

#include <ringwatch/app/scene/time_expression.h>
#include <ringwatch/base/name_table.h>

namespace ringwatch {

/// How a table goes from one of its points to the next.
enum class Ramp { linear, smooth, quintic, hold };
inline constexpr auto rampNames = nameTable<Ramp>({
    {Ramp::linear, "linear", "straight lines"},
    {Ramp::smooth, "smooth", "s²(3 - 2s), whose slope is zero at the points"},
    {Ramp::quintic, "quintic", "s³(10 - 15s + 6s²), whose slope and curvature are zero at the points"},
    {Ramp::hold, "hold", "the factor stays until the next time"},
});

/// A factor of a load or a motion as a function of time: a table of points, constant before the first and after the
/// last, or an expression.
class TimeTable {
 public:
  /// times: s, increasing. Throws InputError that says what is wrong, for lists of different length, fewer than two
  /// points and times that do not increase.
  TimeTable(std::vector<double> times, std::vector<double> factors, Ramp ramp);
  /// An expression for times from 0 to about `end`, s. Its integral is taken by Gauss' rule of ten points on panels
  /// that are halved until two halves differ from the whole by no more than 1e-15 of the largest factor times the end.
  /// Throws InputError where it has no finite value, and where that takes more than 131072 panels; fewer of an
  /// expression of more than 250 characters.
  TimeTable(TimeExpression expression, double end);

  /// The factor at time t, s.
  double at(double t) const;
  /// Its derivative, 1/s, at points of a table that of the piece behind; a jump counts for nothing.
  double slope(double t) const;
  /// Its mean over [t, t + h], h > 0, s; exact for a table.
  double mean(double t, double h) const { return (integralTo(t + h) - integralTo(t)) / h; }

  /// The largest absolute value of the factor; of an expression of those where it was integrated.
  double largest() const;
  /// Likewise of its derivative, 1/s.
  double steepest() const;
  /// Whether the factor jumps.
  bool jumps() const { return !expression_ && ramp_ == Ramp::hold; }

  friend bool operator==(const TimeTable&, const TimeTable&) = default;

 private:
  double integralTo(double t) const;  // from the first point
  double gauss(double a, double b) const;
  void divide(double a, double b, double whole, double tolerance);
  double checked(double t) const;

  std::vector<double> times_, factors_;  // of an expression the ends of its panels, and no factors
  std::vector<double> integrals_;        // to each of the times
  Ramp ramp_ = Ramp::linear;
  std::optional<TimeExpression> expression_;
};

}  // namespace ringwatch

#pragma once
#include <string>
#include <string_view>
#include <vector>

#include <ringwatch/app/scene/formula.h>

namespace ringwatch {

/// A number that depends on the time t (s), as scenes write it: `sin(2*pi*50*t)`, `min(1, t/0.01)`.
///
/// Names: t, pi; numbers, + - * / ^, unary minus, sqrt, abs, min, max, sin, cos, tan, exp, log (natural), tanh.
class TimeExpression {
 public:
  /// Throws InputError that names the column and what was expected there.
  explicit TimeExpression(std::string_view text);

  const std::string& text() const { return text_; }
  /// The value at t, and its derivative, 1/s, by forward differentiation; at a kink that of one of its sides. Not
  /// numbers where the arithmetic has none.
  struct Value {
    double value, slope;
  };
  Value at(double t) const { return valueOf(root_, t); }

  friend bool operator==(const TimeExpression& a, const TimeExpression& b) { return a.text_ == b.text_; }

 private:
  Value valueOf(int term, double t) const;

  std::string text_;
  std::vector<FormulaTerm> terms_;
  int root_ = -1;
};

}  // namespace ringwatch

#pragma once
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include <ringwatch/app/scene/formula.h>

namespace ringwatch {

/// A condition on a reference position, as scenes write it: `x < 1e-6 and (y > 0.01 or r <= 0.02)`.
///
/// Names: x, y, z, the reference coordinates in m, and r = sqrt(x² + y² + z²). Numbers, + - * / ^, unary minus,
/// sqrt(a), abs(a), min(a, …), max(a, …); < <= > >= == !=, which chain as in 0 < x < 1; and, or, not, also written &&,
/// ||, !; parentheses; `all` and `none`. Numbers and conditions are different types: `x` alone or `(x < 1) + 1` is
/// refused.
class WhereExpression {
 public:
  /// Throws InputError that names the column and what was expected there.
  explicit WhereExpression(std::string_view text);

  const std::string& text() const { return text_; }
  /// True where the condition holds. Throws InputError with the position when the arithmetic has no value there
  /// (sqrt of a negative number, 0/0): a comparison with NaN would silently say no, and `not` of it yes.
  bool holdsAt(const Eigen::Vector3d& X) const;

 private:
  double valueOf(int term, const Eigen::Vector3d& X) const;
  bool conditionOf(int term, const Eigen::Vector3d& X) const;

  std::string text_;
  std::vector<FormulaTerm> terms_;
  int root_ = -1;
};

}  // namespace ringwatch

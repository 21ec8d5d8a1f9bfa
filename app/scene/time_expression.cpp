#include <ringwatch/app/scene/time_expression.h>

#include <cmath>

namespace ringwatch {

TimeExpression::TimeExpression(std::string_view text) : text_(text) {
  root_ = parseFormula(text_, FormulaOf::time, terms_);
}

TimeExpression::Value TimeExpression::valueOf(int index, double t) const {
  using Kind = FormulaTerm::Kind;
  const FormulaTerm& term = terms_[index];
  const Value a = term.a < 0 ? Value{0, 0} : valueOf(term.a, t), b = term.b < 0 ? Value{0, 0} : valueOf(term.b, t);
  switch (term.kind) {
    case Kind::number:
      return {term.value, 0};
    case Kind::t:
      return {t, 1};
    case Kind::add:
      return {a.value + b.value, a.slope + b.slope};
    case Kind::subtract:
      return {a.value - b.value, a.slope - b.slope};
    case Kind::multiply:
      return {a.value * b.value, a.slope * b.value + a.value * b.slope};
    case Kind::divide:
      return {a.value / b.value, (a.slope - a.value / b.value * b.slope) / b.value};
    case Kind::power: {
      const double power = std::pow(a.value, b.value);
      // Each part is left out where it is zero: of t^2 at t = 0 there is no logarithm.
      double slope = a.slope == 0 || b.value == 0 ? 0 : b.value * std::pow(a.value, b.value - 1) * a.slope;
      if (b.slope != 0) slope += power * std::log(a.value) * b.slope;
      return {power, slope};
    }
    case Kind::negate:
      return {-a.value, -a.slope};
    case Kind::squareRoot: {
      const double root = std::sqrt(a.value);
      return {root, a.slope == 0 ? 0 : 0.5 * a.slope / root};
    }
    case Kind::absolute:
      return {std::abs(a.value), a.value < 0 ? -a.slope : a.slope};
    case Kind::minimum:
    case Kind::maximum:
      if (std::isnan(a.value) || std::isnan(b.value)) return {a.value + b.value, 0};
      return (term.kind == Kind::minimum) == (b.value < a.value) ? b : a;
    case Kind::sine:
      return {std::sin(a.value), std::cos(a.value) * a.slope};
    case Kind::cosine:
      return {std::cos(a.value), -std::sin(a.value) * a.slope};
    case Kind::tangent: {
      const double tangent = std::tan(a.value);
      return {tangent, (1 + tangent * tangent) * a.slope};
    }
    case Kind::exponential:
      return {std::exp(a.value), std::exp(a.value) * a.slope};
    case Kind::logarithm:
      return {std::log(a.value), a.slope / a.value};
    case Kind::hyperbolicTangent: {
      const double tangent = std::tanh(a.value);
      return {tangent, (1 - tangent * tangent) * a.slope};
    }
    default:
      return {0, 0};  // positions and conditions, which the parser keeps out
  }
}

}  // namespace ringwatch

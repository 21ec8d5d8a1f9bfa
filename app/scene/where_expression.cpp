#include <ringwatch/app/scene/where_expression.h>

#include <algorithm>
#include <cmath>

#include <ringwatch/base/error.h>
#include <ringwatch/base/user_text.h>

namespace ringwatch {
namespace {

using Kind = FormulaTerm::Kind;

}  // namespace

WhereExpression::WhereExpression(std::string_view text) : text_(text) {
  root_ = parseFormula(text_, FormulaOf::position, terms_);
}

double WhereExpression::valueOf(int index, const Eigen::Vector3d& X) const {
  const FormulaTerm& t = terms_[index];
  const auto a = [&] { return valueOf(t.a, X); };
  const auto b = [&] { return valueOf(t.b, X); };
  switch (t.kind) {
    case Kind::number:
      return t.value;
    case Kind::x:
      return X[0];
    case Kind::y:
      return X[1];
    case Kind::z:
      return X[2];
    case Kind::r:
      return X.norm();
    case Kind::add:
      return a() + b();
    case Kind::subtract:
      return a() - b();
    case Kind::multiply:
      return a() * b();
    case Kind::divide:
      return a() / b();
    case Kind::power:
      return std::pow(a(), b());
    case Kind::negate:
      return -a();
    case Kind::squareRoot:
      return std::sqrt(a());
    case Kind::absolute:
      return std::abs(a());
    case Kind::minimum:
    case Kind::maximum: {
      const double left = a(), right = b();
      if (std::isnan(left) || std::isnan(right)) return left + right;  // std::min would drop one of the two
      return t.kind == Kind::minimum ? std::min(left, right) : std::max(left, right);
    }
    default:
      return 0;  // conditions, which the parser keeps apart
  }
}

bool WhereExpression::conditionOf(int index, const Eigen::Vector3d& X) const {
  const FormulaTerm& t = terms_[index];
  switch (t.kind) {
    case Kind::everywhere:
      return true;
    case Kind::nowhere:
      return false;
    case Kind::negation:
      return !conditionOf(t.a, X);
    case Kind::conjunction:
      return conditionOf(t.a, X) && conditionOf(t.b, X);
    case Kind::disjunction:
      return conditionOf(t.a, X) || conditionOf(t.b, X);
    default:
      break;
  }
  const double a = valueOf(t.a, X), b = valueOf(t.b, X);
  if (std::isnan(a) || std::isnan(b))
    throw InputError(joinText("\"", text_, "\" has no value at (", X[0], ", ", X[1], ", ", X[2],
                              "): a square root of a negative number, or 0/0"));
  switch (t.kind) {
    case Kind::less:
      return a < b;
    case Kind::lessEqual:
      return a <= b;
    case Kind::greater:
      return a > b;
    case Kind::greaterEqual:
      return a >= b;
    case Kind::equal:
      return a == b;
    default:
      return a != b;
  }
}

bool WhereExpression::holdsAt(const Eigen::Vector3d& X) const { return conditionOf(root_, X); }

}  // namespace ringwatch

#pragma once
#include <string_view>
#include <vector>

namespace ringwatch {

/// A node of a parsed formula.
struct FormulaTerm {
  enum class Kind {
    number,
    x,
    y,
    z,
    r,
    t,  // values
    add,
    subtract,
    multiply,
    divide,
    power,
    negate,
    squareRoot,
    absolute,
    minimum,
    maximum,
    sine,
    cosine,
    tangent,
    exponential,
    logarithm,
    hyperbolicTangent,  // arithmetic
    less,
    lessEqual,
    greater,
    greaterEqual,
    equal,
    notEqual,  // conditions from here on
    conjunction,
    disjunction,
    negation,
    everywhere,
    nowhere
  };
  Kind kind;
  int a = -1, b = -1;  // operands, positions in the list of terms
  double value = 0;
};

/// What a formula is about: a condition on x, y, z and r, or a number that depends on t.
enum class FormulaOf { position, time };
/// Adds the nodes of a formula to a list; the position of its root. Throws InputError that names the column and what
/// was expected there.
int parseFormula(std::string_view text, FormulaOf of, std::vector<FormulaTerm>& terms);

}  // namespace ringwatch

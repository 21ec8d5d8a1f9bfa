#include <ringwatch/app/scene/where_expression.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <ringwatch/base/error.h>
#include <ringwatch/base/nearest_name.h>
#include <ringwatch/base/user_text.h>

// A packaged parser (muParser, muParserX) was weighed and left: muParser has no conditions, only numbers, so that
// `0 < x < 0.1`, `x` and `x = 0` all mean something silently.

namespace ringwatch {
namespace {

using Term = WhereExpression::Term;
using Kind = Term::Kind;

bool isCondition(Kind kind) { return kind >= Kind::less; }

// Bounds on what is accepted, so that no text can exhaust the stack of the recursive descent or of the evaluation.
constexpr std::size_t longestText = 2000;
constexpr int deepestNesting = 100;

class Parser {
 public:
  Parser(std::string_view text, std::vector<Term>& terms) : text_(text), terms_(terms) {}

  int parse() {
    if (text_.size() > longestText) throw InputError(joinText("longer than ", longestText, " characters"));
    const int root = parseOr();
    skipSpace();
    if (at_ < text_.size()) fail("an operator or the end");
    if (!isCondition(kind(root))) throw InputError("is a number, not a condition; compare it, as in \"x < 0.1\"");
    return root;
  }

 private:
  struct Operator {
    std::string_view text;
    Kind kind;
  };

  [[noreturn]] void fail(const std::string& expected) {
    skipSpace();
    std::string found;
    for (char c : text_.substr(std::min(at_, text_.size()), 12)) found += c >= ' ' && c < 127 ? c : '?';
    throw InputError(found.empty() ? joinText("column ", at_ + 1, ": found the end, expected ", expected)
                                   : joinText("column ", at_ + 1, ": found \"", found, "\", expected ", expected));
  }

  Kind kind(int term) const { return terms_[term].kind; }
  int add(Kind kind, int a = -1, int b = -1, double value = 0) {
    terms_.push_back({kind, a, b, value});
    return static_cast<int>(terms_.size()) - 1;
  }
  int number(int term, std::size_t column) { return typed(term, column, false); }
  int condition(int term, std::size_t column) { return typed(term, column, true); }
  int typed(int term, std::size_t column, bool wantCondition) {
    if (isCondition(kind(term)) == wantCondition) return term;
    throw InputError(joinText("column ", column + 1, ": ",
                              wantCondition ? "a number where a condition is needed, as in \"x < 0.1\""
                                            : "a condition where a number is needed"));
  }

  static bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
  static bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
  static bool isDigit(char c) { return c >= '0' && c <= '9'; }

  void skipSpace() {
    while (at_ < text_.size() && isSpace(text_[at_])) ++at_;
  }
  std::size_t column() {
    skipSpace();
    return at_;
  }
  bool take(std::string_view symbol) {
    skipSpace();
    if (text_.substr(at_, symbol.size()) != symbol) return false;
    at_ += symbol.size();
    return true;
  }
  std::string_view peekWord() {
    skipSpace();
    std::size_t end = at_;
    while (end < text_.size() && (isLetter(text_[end]) || (end > at_ && isDigit(text_[end])))) ++end;
    return text_.substr(at_, end - at_);
  }
  bool takeWord(std::string_view word) {
    if (peekWord() != word) return false;
    at_ += word.size();
    return true;
  }

  /// Counts the nesting for as long as it lives.
  struct Level {
    explicit Level(Parser& p) : parser(p) {
      if (++parser.depth_ > deepestNesting) throw InputError(joinText("nested more than ", deepestNesting, " deep"));
    }
    ~Level() { --parser.depth_; }
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;
    Parser& parser;
  };

  int parseOr() {
    const Level level(*this);
    std::size_t start = column();
    int left = parseAnd();
    while (takeWord("or") || take("||")) {
      const int a = condition(left, start);
      start = column();
      left = add(Kind::disjunction, a, condition(parseAnd(), start));
    }
    return left;
  }

  int parseAnd() {
    std::size_t start = column();
    int left = parseNot();
    while (takeWord("and") || take("&&")) {
      const int a = condition(left, start);
      start = column();
      left = add(Kind::conjunction, a, condition(parseNot(), start));
    }
    return left;
  }

  int parseNot() {
    const Level level(*this);
    skipSpace();
    const bool notEqual = text_.substr(at_, 2) == "!=";
    if (takeWord("not") || (!notEqual && take("!"))) {
      const std::size_t start = column();
      return add(Kind::negation, condition(parseNot(), start));
    }
    return parseComparison();
  }

  bool takeComparison(Kind& found) {
    // The longer of two that begin alike comes first.
    static constexpr std::array<Operator, 6> comparisons{{{"<=", Kind::lessEqual},
                                                          {">=", Kind::greaterEqual},
                                                          {"==", Kind::equal},
                                                          {"!=", Kind::notEqual},
                                                          {"<", Kind::less},
                                                          {">", Kind::greater}}};
    for (const Operator& c : comparisons)
      if (take(c.text)) {
        found = c.kind;
        return true;
      }
    skipSpace();
    if (at_ < text_.size() && text_[at_] == '=') fail("== for \"equal\", or <, <=, >, >=");
    return false;
  }

  int parseComparison() {
    std::size_t start = column();
    int left = parseSum();
    int chain = -1;
    Kind comparison{};
    while (takeComparison(comparison)) {
      number(left, start);
      start = column();
      const int right = number(parseSum(), start);
      const int link = add(comparison, left, right);
      chain = chain < 0 ? link : add(Kind::conjunction, chain, link);
      left = right;
    }
    return chain < 0 ? left : chain;
  }

  int parseSum() { return parseLeftToRight({{{"+", Kind::add}, {"-", Kind::subtract}}}, &Parser::parseProduct); }
  int parseProduct() { return parseLeftToRight({{{"*", Kind::multiply}, {"/", Kind::divide}}}, &Parser::parseUnary); }
  int parseLeftToRight(const std::array<Operator, 2>& operators, int (Parser::*operand)()) {
    std::size_t start = column();
    int left = (this->*operand)();
    for (;;) {
      const Operator* found = nullptr;
      for (const Operator& o : operators)
        if (!found && take(o.text)) found = &o;
      if (!found) return left;
      number(left, start);
      start = column();
      left = add(found->kind, left, number((this->*operand)(), start));
    }
  }

  int parseUnary() {
    const Level level(*this);
    if (take("-")) {
      const std::size_t start = column();
      return add(Kind::negate, number(parseUnary(), start));
    }
    if (take("+")) {
      const std::size_t start = column();
      return number(parseUnary(), start);
    }
    const std::size_t start = column();
    const int base = parsePrimary();
    if (!take("^")) return base;
    number(base, start);
    const std::size_t exponentStart = column();
    return add(Kind::power, base, number(parseUnary(), exponentStart));
  }

  int parsePrimary() {
    skipSpace();
    if (take("(")) {
      const int inner = parseOr();
      if (!take(")")) fail("\")\"");
      return inner;
    }
    if (at_ < text_.size() && (isDigit(text_[at_]) || text_[at_] == '.')) return parseNumber();
    return parseName();
  }

  int parseNumber() {
    double value = 0;
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (error == std::errc::result_out_of_range) fail("a number that a double can hold");
    if (error != std::errc{}) fail("a number");
    at_ = static_cast<std::size_t>(end - text_.data());
    return add(Kind::number, -1, -1, value);
  }

  int parseName() {
    struct Name {
      std::string_view text;
      Kind kind;
    };
    static constexpr std::array<Name, 6> names{{{"x", Kind::x},
                                                {"y", Kind::y},
                                                {"z", Kind::z},
                                                {"r", Kind::r},
                                                {"all", Kind::everywhere},
                                                {"none", Kind::nowhere}}};
    static constexpr std::array<Name, 4> functions{
        {{"sqrt", Kind::squareRoot}, {"abs", Kind::absolute}, {"min", Kind::minimum}, {"max", Kind::maximum}}};
    const std::string_view word = peekWord();
    if (word.empty()) fail("a number, x, y, z, r, a function or \"(\"");
    for (const Name& name : names)
      if (name.text == word) {
        at_ += word.size();
        return add(name.kind);
      }
    for (const Name& function : functions)
      if (function.text == word) {
        at_ += word.size();
        return parseArguments(function.kind, std::string(word));
      }
    std::vector<std::string> known;
    for (const Name& name : names) known.emplace_back(name.text);
    for (const Name& function : functions) known.emplace_back(function.text);
    for (const char* joint : {"and", "or", "not"}) known.emplace_back(joint);
    throw InputError(joinText("column ", at_ + 1, ": unknown name ", inQuotes(word), "; ", didYouMean(word, known),
                              "known are x, y, z, r, sqrt, abs, min, max, and, or, not, all, none"));
  }

  int parseArguments(Kind function, const std::string& name) {
    if (!take("(")) fail(joinText("\"(\" after ", name));
    std::size_t start = column();
    int first = number(parseOr(), start);
    if (function == Kind::squareRoot || function == Kind::absolute) {
      if (!take(")")) fail("\")\"");
      return add(function, first);
    }
    int count = 1;
    while (take(",")) {
      start = column();
      first = add(function, first, number(parseOr(), start));
      ++count;
    }
    if (count < 2) fail(joinText("\",\": ", name, " takes two numbers or more"));
    if (!take(")")) fail("\",\" or \")\"");
    return first;
  }

  std::string_view text_;
  std::vector<Term>& terms_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

WhereExpression::WhereExpression(std::string_view text) : text_(text) { root_ = Parser(text_, terms_).parse(); }

double WhereExpression::valueOf(int index, const Eigen::Vector3d& X) const {
  const Term& t = terms_[index];
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
  const Term& t = terms_[index];
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

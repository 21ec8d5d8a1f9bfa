#include <ringwatch/app/scene/formula.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <numbers>
#include <span>

#include <ringwatch/base/error.h>
#include <ringwatch/base/nearest_name.h>
#include <ringwatch/base/user_text.h>

// A packaged parser (muParser, muParserX) was weighed and left: muParser has no conditions, only numbers, so that
// `0 < x < 0.1`, `x` and `x = 0` all mean something silently.

namespace ringwatch {
namespace {

using Term = FormulaTerm;
using Kind = Term::Kind;

struct Name {
  std::string_view text;
  Kind kind;
  double value = 0;
};
struct Function {
  std::string_view text;
  Kind kind;
  bool ofMany = false;  // arguments, two and more; else one
};
/// What a formula may name.
struct Language {
  std::span<const Name> names;
  std::span<const Function> functions;
  std::string_view operand;  // what can stand for a number, for messages
  std::string_view known;    // all names, likewise
};

constexpr Name namesOfPositions[] = {
    {"x", Kind::x}, {"y", Kind::y}, {"z", Kind::z}, {"r", Kind::r}, {"all", Kind::everywhere}, {"none", Kind::nowhere}};
constexpr Function functionsOfPositions[] = {
    {"sqrt", Kind::squareRoot}, {"abs", Kind::absolute}, {"min", Kind::minimum, true}, {"max", Kind::maximum, true}};
constexpr Name namesOfTime[] = {{"t", Kind::t}, {"pi", Kind::number, std::numbers::pi}};
constexpr Function functionsOfTime[] = {{"sqrt", Kind::squareRoot},   {"abs", Kind::absolute},
                                        {"min", Kind::minimum, true}, {"max", Kind::maximum, true},
                                        {"sin", Kind::sine},          {"cos", Kind::cosine},
                                        {"tan", Kind::tangent},       {"exp", Kind::exponential},
                                        {"log", Kind::logarithm},     {"tanh", Kind::hyperbolicTangent}};

const Language& languageOf(FormulaOf of) {
  static constexpr Language positions{namesOfPositions, functionsOfPositions,
                                      "a number, x, y, z, r, a function or \"(\"",
                                      "x, y, z, r, sqrt, abs, min, max, and, or, not, all, none"};
  static constexpr Language time{namesOfTime, functionsOfTime, "a number, t, pi, a function or \"(\"",
                                 "t, pi, sqrt, abs, min, max, sin, cos, tan, exp, log, tanh"};
  return of == FormulaOf::position ? positions : time;
}

bool isCondition(Kind kind) { return kind >= Kind::less; }

// Bounds on what is accepted, so that no text can exhaust the stack of the recursive descent or of the evaluation.
constexpr std::size_t longestText = 2000;
constexpr int deepestNesting = 100;

class Parser {
 public:
  Parser(std::string_view text, FormulaOf of, std::vector<Term>& terms)
      : text_(text), of_(of), language_(languageOf(of)), terms_(terms) {}

  int parse() {
    if (text_.size() > longestText) throw InputError(joinText("longer than ", longestText, " characters"));
    const int root = parseOr();
    skipSpace();
    if (at_ < text_.size()) fail("an operator or the end");
    if (of_ == FormulaOf::time && isCondition(kind(root)))
      throw InputError("is a condition, not a number; for a jump give times, factors and ramp = \"hold\"");
    if (of_ == FormulaOf::position && !isCondition(kind(root)))
      throw InputError("is a number, not a condition; compare it, as in \"x < 0.1\"");
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
    const std::string_view word = peekWord();
    if (word.empty()) fail(std::string(language_.operand));
    for (const Name& name : language_.names)
      if (name.text == word) {
        at_ += word.size();
        return add(name.kind, -1, -1, name.value);
      }
    for (const Function& function : language_.functions)
      if (function.text == word) {
        at_ += word.size();
        return parseArguments(function);
      }
    std::vector<std::string> known;
    for (const Name& name : language_.names) known.emplace_back(name.text);
    for (const Function& function : language_.functions) known.emplace_back(function.text);
    if (of_ == FormulaOf::position)
      for (const char* joint : {"and", "or", "not"}) known.emplace_back(joint);
    throw InputError(joinText("column ", at_ + 1, ": unknown name ", inQuotes(word), "; ", didYouMean(word, known),
                              "known are ", language_.known));
  }

  int parseArguments(const Function& function) {
    if (!take("(")) fail(joinText("\"(\" after ", function.text));
    std::size_t start = column();
    int first = number(parseOr(), start);
    if (!function.ofMany) {
      if (!take(")")) fail("\")\"");
      return add(function.kind, first);
    }
    int count = 1;
    while (take(",")) {
      start = column();
      first = add(function.kind, first, number(parseOr(), start));
      ++count;
    }
    if (count < 2) fail(joinText("\",\": ", function.text, " takes two numbers or more"));
    if (!take(")")) fail("\",\" or \")\"");
    return first;
  }

  std::string_view text_;
  FormulaOf of_;
  const Language& language_;
  std::vector<Term>& terms_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

int parseFormula(std::string_view text, FormulaOf of, std::vector<FormulaTerm>& terms) {
  return Parser(text, of, terms).parse();
}

}  // namespace ringwatch

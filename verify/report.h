#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace ringwatch {

/// What a study found, in a form that tests, the command line's tables, its JSON and its pictures all read.

/// A table of results.
struct StudyTable {
  using Cell = std::variant<std::string, double, std::int64_t>;
  std::string name;                  // short, unique within the report: a JSON key
  std::string title;                 // one line, human-readable
  std::vector<std::string> columns;  // with units, e.g. "h (s)"
  std::vector<std::vector<Cell>> rows;
  std::vector<std::string> descriptions = {};  // of the columns, one each or none: then the names say enough
};

/// A measured number and the limit that it is held to. No study says itself whether it passed: that follows from the
/// numbers.
struct StudyCheck {
  enum class Sense { near, atMost, atLeast };
  std::string name;  // what was measured, with its unit where it has one; unique within the report
  double measured;
  double expected;   // what theory or another program says
  double tolerance;  // how far measured may be from it: on both sides, above, or below; finite
  Sense sense = Sense::near;

  /// How far measured is from expected, on both sides, above or below: negative when on the good side, NaN when either
  /// is. Equal infinities are 0 apart.
  double deviation() const;
  bool passed() const;
};

/// Curves for a picture.
struct StudyFigure {
  struct Curve {
    std::string label;
    std::vector<double> x, y;
  };
  std::string name;  // file name without extension
  std::string title, xLabel, yLabel;
  bool logX = false, logY = false;
  std::vector<Curve> curves;
  bool lines = true;  // between the points of a curve
};

/// Surfaces in space, coloured by a value on one logarithmic scale.
struct StudySurfaces {
  struct Panel {
    std::string label;
    std::vector<std::array<double, 3>> points;  // of triangles, three each
    std::vector<double> values;                 // at the points
  };
  std::string name;  // file name without extension
  std::string title, valueLabel;
  std::vector<Panel> panels;
};

/// A file that belongs to the tables.
struct StudyFile {
  std::string name;  // a path below the folder of the results
  std::string bytes;
};

struct StudyReport {
  std::string study;
  std::vector<StudyTable> tables;
  std::vector<StudyCheck> checks;
  std::vector<StudyFigure> figures;
  std::vector<StudySurfaces> surfaces = {};
  std::vector<StudyFile> files = {};

  bool passed() const {
    for (const StudyCheck& check : checks)
      if (!check.passed()) return false;
    return true;
  }
};

/// Adds a check that |measured - expected| <= tolerance.
void checkNear(StudyReport& report, std::string name, double measured, double expected, double tolerance);
/// Adds a check that measured <= bound (expected: 0, tolerance: bound).
void checkBelow(StudyReport& report, std::string name, double measured, double bound);
/// Adds a check that measured <= expected + tolerance.
void checkAtMost(StudyReport& report, std::string name, double measured, double expected, double tolerance);
/// Adds a check that measured >= expected - tolerance.
void checkAtLeast(StudyReport& report, std::string name, double measured, double expected, double tolerance);

/// How much work a study may do: quick for every test run (seconds), full for the command line.
enum class StudyEffort { quick, full };

}  // namespace ringwatch

#pragma once
// The parts of verifyMonitor, each adds its tables, checks and figures.
#include <initializer_list>

#include <ringwatch/verify/report.h>

namespace ringwatch::detail {

inline constexpr double limit = 2;  // symplectic Euler's
/// Both sides of the bracket are proven but for the error of what they are compared with.
inline constexpr double ofTheReference = 1e-9;
/// How far a step lies above the exact one, %; negative: below.
inline double percentBelow(double step, double exact) { return 100 * (step / exact - 1); }

/// A figure with named curves that have no points yet.
StudyFigure figureOf(std::string name, std::string title, std::string xLabel, std::string yLabel, bool logarithmic,
                     std::initializer_list<const char*> curves);

void studyBracket(StudyReport& report, StudyEffort effort);
void studyDrift(StudyReport& report, StudyEffort effort);
void studyTetrahedron(StudyReport& report);
void studyMetrics(StudyReport& report, StudyEffort effort);
void studyObserved(StudyReport& report, StudyEffort effort);
void studyHistories(StudyReport& report, StudyEffort effort);
void studyCost(StudyReport& report);

}  // namespace ringwatch::detail

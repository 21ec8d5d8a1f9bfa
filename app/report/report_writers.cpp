#include <ringwatch/app/report/inspection_report.h>
#include <ringwatch/app/report/run_report.h>
#include <ringwatch/app/report/study_report.h>

namespace ringwatch {

const ReportWriters* reportWriters() {
  static constexpr ReportWriters writers{writeRunReport, writeInspectionReport, writeStudyReport};
  return &writers;
}

}  // namespace ringwatch

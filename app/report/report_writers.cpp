#include <ringwatch/app/report/audit_report.h>
#include <ringwatch/app/report/inspection_report.h>
#include <ringwatch/app/report/run_report.h>
#include <ringwatch/app/report/study_report.h>

namespace ringwatch {

const ReportWriters* reportWriters() {
  static constexpr ReportWriters writers{writeRunReport, writeInspectionReport, writeAuditReport, writeStudyReport};
  return &writers;
}

}  // namespace ringwatch

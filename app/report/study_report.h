#pragma once
#include <filesystem>

#include <ringwatch/app/report/run_report.h>

namespace ringwatch {

/// Writes one page of HTML about studies or a comparison: what came of them, their pictures, checks and tables. Throws
/// InputError when the page cannot be written.
ReportResult writeStudyReport(const StudyPage& page, const std::filesystem::path& file);

}  // namespace ringwatch

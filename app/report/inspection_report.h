#pragma once
#include <filesystem>

#include <ringwatch/app/analysis/inspect.h>
#include <ringwatch/app/report/run_report.h>

namespace ringwatch {

/// Writes one page of HTML about a mesh in one state: its bracket, the elements in the way, their shapes, the
/// distribution of the elements' steps and what larger steps would take. Throws InputError when the page cannot be
/// written.
ReportResult writeInspectionReport(const Inspection& inspection, const std::filesystem::path& file);

}  // namespace ringwatch

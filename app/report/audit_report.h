#pragma once
#include <filesystem>

#include <ringwatch/app/report/run_report.h>

namespace ringwatch {

/// Writes one page of HTML about an audit: where the run left proven ground, its brackets against time, and the mesh in
/// the states that are finite. Throws InputError when it cannot be written.
ReportResult writeAuditReport(const Audit& audit, const std::filesystem::path& file);

}  // namespace ringwatch

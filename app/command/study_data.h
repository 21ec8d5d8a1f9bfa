#pragma once
#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

#include <ringwatch/verify/report.h>

namespace ringwatch {

/// What studies found as a data package that other programs read: a CSV file for each table, STUDY.TABLE.csv, one for
/// the checks, STUDY.checks.csv, the studies' own files, and datapackage.json, which names every field with its type,
/// unit and description (Frictionless Data Package and Table Schema 1.0, specs.frictionlessdata.io).
class StudyData {
 public:
  /// folder: must exist. command: what was typed.
  StudyData(std::filesystem::path folder, const std::string& command);
  /// Writes the files of a study, and datapackage.json of all studies so far. Throws InputError when a file cannot be
  /// written.
  void add(const StudyReport& report);

 private:
  void addTable(const std::string& study, const StudyTable& table);
  std::filesystem::path folder_;
  nlohmann::ordered_json package_;
};

}  // namespace ringwatch

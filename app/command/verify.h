#pragma once
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include <ringwatch/verify/report.h>
#include <ringwatch/verify/step_rules/judge.h>

namespace ringwatch {

/// A study that `ringwatch verify` can run.
struct StudyInfo {
  std::string_view name;
  std::string_view help;
  StudyReport (*run)(StudyEffort);
  std::string_view formerName = {};  // accepted too
};

/// All studies, one line each in studies.cpp. Empty in the program `ringwatch`, which leaves them to
/// `ringwatch-verify`.
std::span<const StudyInfo> allStudies();
/// Adds one, in a program that has studies; call it when it starts, before any is asked for. Throws InputError when the
/// name is taken.
void registerStudy(const StudyInfo& study);

/// judgeRule; nullptr in programs without studies.
using JudgeFunction = Judgement (*)(const StepRuleOfOthers& rule, const JudgeOptions& options);
JudgeFunction judgeOfStudies();

/// Told of the studies as they run, one after the other.
struct StudyProgress {
  std::function<void(const StudyInfo& study, std::size_t number, std::size_t count)> begins = {};  // number: from 1
  std::function<void(const StudyReport& report)> ended = {};
};
/// Runs the studies of those names; "all" or nothing for every one. Throws InputError for an unknown name, before any
/// runs.
std::vector<StudyReport> runStudies(const std::vector<std::string>& names, StudyEffort effort,
                                    const StudyProgress& progress = {});

/// The tables and the checks, human-readable.
std::string studyText(const StudyReport& report);
/// { "passed": …, "studies": { NAME: { "passed", "tables": { NAME: [rows as objects] }, "checks": [ … ] } } }
nlohmann::ordered_json studiesJson(const std::vector<StudyReport>& reports);
/// The checks of a report as test cases in JUnit's XML.
std::string junitOfChecks(const StudyReport& report);
/// Draws every figure of a report with gnuplot into `folder` (NAME.png beside its script and data). Returns a note for
/// each picture that could not be drawn.
std::vector<std::string> drawFigures(const StudyReport& report, const std::filesystem::path& folder);

}  // namespace ringwatch

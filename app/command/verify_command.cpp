#include <optional>

#include <ringwatch/app/command/command.h>
#include <ringwatch/app/command/help.h>
#include <ringwatch/app/command/study_data.h>
#include <ringwatch/app/command/verify.h>
#include <ringwatch/app/output/progress.h>
#include <ringwatch/app/output/provenance.h>

namespace ringwatch {
namespace {

struct VerifyCommand final : Command {
  using Command::Command;
  std::vector<std::string> studies;
  JsonOption json;
  std::string folder, page;
  bool quick = false;

  CLI::App* declare(CLI::App& app) override {
    CLI::App* command = app.add_subcommand("verify", "hold elements and integrators to analytic answers");
    command->add_option("STUDY", studies, "studies to run, or all (default: all)")->type_name("STUDY");
    json.declare(*command, "results");
    command->add_option("--out", folder, "folder for pictures and tables (CSV, datapackage.json), made when missing")
        ->type_name("DIR");
    command->add_option("--report", page, pageHelp)->type_name("FILE");
    command->add_flag("--quick", quick,
                      "coarser and shorter, on one thread: about a minute of processor time for all studies");
    command->footer("Exit status 1 when a check fails; ringwatch help exit-status has the table.\n\n" +
                    findHelpTopic("studies")->text());
    return command;
  }

  ExitStatus execute() override {
    bool passed = true;
    ProgressLine line(true);
    std::optional<StudyData> data;
    StudyProgress progress;
    progress.begins = [&](const StudyInfo& study, std::size_t number, std::size_t count) {
      if (number == 1) makeFolderOfPictures(folder);
      line.announce(fmt::format("study {} of {}: {}", number, count, study.name));
    };
    // A study's results are there when it ends: all together take long.
    progress.ended = [&](const StudyReport& report) {
      line.clear();
      passed = passed && report.passed();
      if (!json.takesStandardOutput()) printOut(studyText(report) + "\n");
      if (folder.empty()) return;
      drawInto(folder, report);
      if (!data) data.emplace(folder, call.typed);
      data->add(report);
    };
    const std::vector<StudyReport> reports =
        runStudies(studies, quick ? StudyEffort::quick : StudyEffort::full, progress);
    const nlohmann::ordered_json found = studiesJson(reports);
    json.save(found);
    std::string written;
    if (!page.empty())
      written = reportText(
          neededReportWriters().ofStudies({"Verification", {}, reports, found, provenanceOf(call.typed, "")}, page));
    json.print(found, written);
    return passed ? ExitStatus::done : ExitStatus::unstable;
  }
};

}  // namespace

std::unique_ptr<Command> verifyCommand(const Call& call) { return std::make_unique<VerifyCommand>(call); }

}  // namespace ringwatch

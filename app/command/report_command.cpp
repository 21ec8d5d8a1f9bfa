#include <ringwatch/app/command/command.h>
#include <ringwatch/app/output/report.h>
#include <ringwatch/app/report/run_report.h>

namespace ringwatch {
namespace {

struct ReportCommand final : Command {
  using Command::Command;
  ReportOptions options;
  std::string folder, output;

  CLI::App* declare(CLI::App& app) override {
    CLI::App* command =
        app.add_subcommand("report", "write one page that says which element of a run is in the way, when and why");
    command->add_option("DIR", folder, "folder of a run")->required()->type_name("DIR");
    command->add_option("--out", output, "file to write (default: report.html in DIR)")->type_name("FILE");
    command->add_option("--frames", options.frames, "most frames in the page (default: as many as keep it small)")
        ->check(CLI::Range(1, 100000));
    command->footer(
        std::string(
            "The page is one HTML file, and asks for nothing from anywhere: it opens from disk in any browser.\n") +
        exitStatusHint);
    return command;
  }

  ExitStatus execute() override {
    options.folder = folder;
    options.output = output;
    const ReportResult report = neededReportWriters().ofRun(options);
    printOut(reportText(report) + labelled(conclusionLine(report.title + ": " + report.sentence)));
    return ExitStatus::done;
  }
};

}  // namespace

std::unique_ptr<Command> reportCommand(const Call& call) { return std::make_unique<ReportCommand>(call); }

}  // namespace ringwatch

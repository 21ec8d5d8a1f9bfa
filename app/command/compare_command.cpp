#include <ringwatch/app/analysis/compare.h>
#include <ringwatch/app/command/command.h>
#include <ringwatch/app/command/verify.h>
#include <ringwatch/app/output/progress.h>
#include <ringwatch/app/output/provenance.h>
#include <ringwatch/base/error.h>

namespace ringwatch {
namespace {

struct CompareCommand final : Command {
  using Command::Command;
  CompareOptions options;
  JsonOption json;
  std::string folder, page;

  CLI::App* declare(CLI::App& app) override {
    CLI::App* command = app.add_subcommand("compare", "run a scene with several integrators: error against cost");
    command->add_option("SCENE", options.scene, "scene file (TOML); its motion is what is computed, to its end")
        ->required()
        ->type_name("SCENE");
    command->add_option("--integrators", options.integrators, "names, separated by commas, or all (default: all)")
        ->type_name("INTEGRATORS")
        ->delimiter(',')
        ->allow_extra_args(false);
    command
        ->add_option("--handlers", options.handlers,
                     "handlers on verlet, separated by commas, or all (default: none); options from the scene")
        ->type_name("HANDLERS")
        ->delimiter(',')
        ->allow_extra_args(false);
    command
        ->add_option_function<std::vector<std::string>>(
            "--step",
            [this](const std::vector<std::string>& steps) {
              for (const std::string& step : steps) options.steps.push_back(parsePositiveNumber(step, "--step"));
            },
            "steps, s, separated by commas (default: a range for each integrator, from its largest)")
        ->delimiter(',')
        ->allow_extra_args(false);
    command->add_option("--set", options.overrides, "section.key=value, replaces the value of the scene")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    command->add_option("--threads", options.threads, "threads (default: 1, so that times compare)")
        ->check(CLI::Range(0, 4096));
    json.declare(*command, "results");
    command->add_option("--out", folder, "folder for pictures, made when missing")->type_name("DIR");
    command->add_option("--report", page, pageHelp)->type_name("FILE");
    command->footer(
        "Against a reference that is refined until it no longer changes. Errors are those of the positions at the end, "
        "relative\nto the displacement.\n" +
        seeTopics("integrators | handlers | scene") + exitStatusHint);
    return command;
  }

  ExitStatus execute() override {
    CompareResult result = compareScene(options);
    json.save(result.json);
    makeFolderOfPictures(folder);
    if (!folder.empty()) drawInto(folder, result.report);
    if (!page.empty()) {
      const ReportResult written =
          neededReportWriters().ofStudies({"Comparison on " + options.scene.filename().string(),
                                           result.found,
                                           {result.report},
                                           result.json,
                                           provenanceOf(call.typed, options.scene)},
                                          page);
      result.text += reportText(written);
    }
    json.print(result.json, studyText(result.report) + result.text);
    return ExitStatus::done;
  }
};

}  // namespace

std::unique_ptr<Command> compareCommand(const Call& call) { return std::make_unique<CompareCommand>(call); }

}  // namespace ringwatch

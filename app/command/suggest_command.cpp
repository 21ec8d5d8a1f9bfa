#include <ringwatch/app/analysis/suggest.h>
#include <ringwatch/app/command/command.h>
#include <ringwatch/app/scene/number_text.h>
#include <ringwatch/app/scene/scene_keys.h>

namespace ringwatch {
namespace {

struct SuggestCommand final : QuestionCommand<SuggestOptions, suggestSteps> {
  using QuestionCommand::QuestionCommand;
  std::string stretch;

  CLI::App* declare(CLI::App& app) override {
    CLI::App* command =
        app.add_subcommand("suggest", "say how many steps a scene needs in a time, such as that of a picture");
    declareQuestion(*command, options, json);
    addTime(*command, "--frame", options.frame,
            "the time, s: a number or a fraction, such as 1/60 (default: the scene's step, which is answered for)");
    command->add_option("--stretch", stretch,
                        "a:b, also for every state whose stretches stay between these two, e.g. 0.7:1.5");
    command->footer(std::string(unitsText) + "\n" + seeTopics("scene | integrators") + exitStatusHint);
    return command;
  }

  ExitStatus execute() override {
    if (!stretch.empty()) options.stretch = parseStretchRange(stretch, "--stretch");
    return QuestionCommand::execute();
  }
};

}  // namespace

std::unique_ptr<Command> suggestCommand(const Call& call) { return std::make_unique<SuggestCommand>(call); }

}  // namespace ringwatch

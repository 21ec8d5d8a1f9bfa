#include <ringwatch/app/analysis/scale_mass.h>
#include <ringwatch/app/command/command.h>
#include <ringwatch/app/scene/scene_keys.h>

namespace ringwatch {
namespace {

struct ScaleMassCommand final : QuestionCommand<ScaleMassOptions, planMass> {
  using QuestionCommand::QuestionCommand;

  CLI::App* declare(CLI::App& app) override {
    CLI::App* command = app.add_subcommand("scale-mass", "say how little added mass a scene needs for a step");
    declareQuestion(*command, options, json);
    addTime(*command, "--step", options.step, "the step to be proven, s: a number or a fraction")->required();
    command->footer("A run adds mass with handler.method = \"mass-scaling\", at the nodes that the handler chooses.\n" +
                    std::string(unitsText) + "\n" + seeTopics("scene | handlers") + exitStatusHint);
    return command;
  }
};

}  // namespace

std::unique_ptr<Command> scaleMassCommand(const Call& call) { return std::make_unique<ScaleMassCommand>(call); }

}  // namespace ringwatch

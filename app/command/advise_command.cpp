#include <ringwatch/app/analysis/advise.h>
#include <ringwatch/app/command/command.h>
#include <ringwatch/app/scene/scene_keys.h>

namespace ringwatch {
namespace {

struct AdviseCommand final : QuestionCommand<AdviseOptions, adviseScene> {
  using QuestionCommand::QuestionCommand;

  CLI::App* declare(CLI::App& app) override {
    CLI::App* command =
        app.add_subcommand("advise", "say how a scene can take a step that is too large for it, by trials and runs");
    declareQuestion(*command, options, json);
    addTime(*command, "--step", options.step, "the step to be taken, s: a number or a fraction (default: the scene's)");
    addTime(*command, "--time", options.time,
            fmt::format("time of each trial, s (default: {} steps, or the scene's end)", adviseSteps));
    command
        ->add_option("--run-steps", options.runSteps,
                     fmt::format("steps of the runs of what a trial leaves, at most (default: {}, or as many as the "
                                 "scene has; 0: no runs)",
                                 options.runSteps))
        ->check(CLI::Range(std::int64_t{0}, std::int64_t{100'000'000}));
    command
        ->add_option("--error", options.error,
                     "error that is allowed in a trial and in a run, of the displacement (default: 0.01)")
        ->check(CLI::Range(1e-6, 1.0));
    command->footer(
        "It tries the scene's integrator at its safe step, every handler and every implicit integrator at the step, "
        "and\n"
        "runs the scene with those that err little enough and are not much slower.\n" +
        std::string(unitsText) + "\n" + seeTopics("scene | handlers | integrators") + exitStatusHint);
    return command;
  }
};

}  // namespace

std::unique_ptr<Command> adviseCommand(const Call& call) { return std::make_unique<AdviseCommand>(call); }

}  // namespace ringwatch

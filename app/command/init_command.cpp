#include <unistd.h>

#include <iostream>

#include <ringwatch/app/command/command.h>
#include <ringwatch/app/command/help.h>
#include <ringwatch/app/command/init.h>
#include <ringwatch/app/scene/scene_keys.h>

namespace ringwatch {
namespace {

struct InitCommand final : Command {
  using Command::Command;
  InitOptions options;

  CLI::App* declare(CLI::App& app) override {
    CLI::App* command = app.add_subcommand("init", "write a commented scene that runs; asks on a terminal");
    command->add_option("SCENE", options.scene, "file to write (default: scene.toml)")->type_name("SCENE");
    command->add_option("--mesh", options.mesh, "mesh file (default: a bar of rubber)")->type_name("MESH");
    command->add_option("--young", options.young,
                        "Young's modulus, Pa; with a mesh it, --poisson and --density are required");
    command->add_option("--poisson", options.poisson, "Poisson's ratio");
    command->add_option("--density", options.density, "density, kg/m3");
    command->add_option("--fix", options.fix, "nodes that are held (default: those of least x)")
        ->type_name("CONDITION");
    declareUnits(*command, options.units);
    addTime(*command, "--end", options.end,
            "time that the run takes, s (default: ten times that of a pressure wave through the body)");
    command->footer(std::string(unitsText) + "\n" + seeTopics("scene | laws | generators") + exitStatusHint);
    return command;
  }

  ExitStatus execute() override {
    const bool terminal = ::isatty(STDIN_FILENO) != 0 && ::isatty(STDOUT_FILENO) != 0;
    printOut(initScene(options, terminal ? askOnTerminal : Ask()));
    return ExitStatus::done;
  }

 private:
  static std::string askOnTerminal(const std::string& question) {
    printOut(question + ": ");
    std::string answer;
    if (!std::getline(std::cin, answer))
      throw InputError("init: no answer; give the options, see ringwatch init --help");
    return answer;
  }
};

}  // namespace

std::unique_ptr<Command> initCommand(const Call& call) { return std::make_unique<InitCommand>(call); }

}  // namespace ringwatch

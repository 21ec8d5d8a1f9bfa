#include <ringwatch/app/command/command.h>
#include <ringwatch/app/command/examples.h>

namespace ringwatch {
namespace {

struct ExamplesCommand final : Command {
  using Command::Command;
  std::string name, folder = ".";

  CLI::App* declare(CLI::App& app) override {
    CLI::App* command = app.add_subcommand("examples", "list the example scenes, or copy one to try it");
    command->add_option("NAME", name, "one of those below, or all; without it they are listed")->type_name("NAME");
    command->add_option("--out", folder, "folder to write it to, made when missing (default: the current one)")
        ->type_name("DIR");
    command->footer("Examples:\n" + exampleListing());
    return command;
  }

  ExitStatus execute() override {
    printOut(name.empty() ? exampleListing() : copyExamples(name, folder));
    return ExitStatus::done;
  }
};

}  // namespace

std::unique_ptr<Command> examplesCommand(const Call& call) { return std::make_unique<ExamplesCommand>(call); }

}  // namespace ringwatch

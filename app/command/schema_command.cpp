#include <ringwatch/app/command/command.h>
#include <ringwatch/app/command/schema.h>

namespace ringwatch {
namespace {

struct SchemaCommand final : Command {
  using Command::Command;
  std::string name;

  CLI::App* declare(CLI::App& app) override {
    CLI::App* command = app.add_subcommand("schema", "print the JSON Schema of a scene or of a JSON file");
    command->add_option("SCHEMA", name, "one of those below; without it they are listed")->type_name("SCHEMA");
    command->footer("Schemas:\n" + listing());
    return command;
  }

  ExitStatus execute() override {
    printOut(name.empty() ? listing() : schemaOf(name).dump(2) + "\n");
    return ExitStatus::done;
  }

 private:
  static std::string listing() {
    std::string text;
    for (const SchemaInfo& schema : allSchemas()) text += fmt::format("  {:<12} {}\n", schema.name, schema.help);
    return text;
  }
};

}  // namespace

std::unique_ptr<Command> schemaCommand(const Call& call) { return std::make_unique<SchemaCommand>(call); }

}  // namespace ringwatch

#include <ringwatch/app/command/command.h>
#include <ringwatch/app/command/reference.h>
#include <ringwatch/base/atomic_file.h>
#include <ringwatch/base/error.h>

namespace ringwatch {
namespace {

struct ReferenceCommand final : Command {
  using Command::Command;
  std::string folder;

  CLI::App* declare(CLI::App& app) override {
    CLI::App* command =
        app.add_subcommand("reference", "write reference pages, schemas, manual page and shell completion");
    command->add_option("DIR", folder, "folder to write them to, made when missing; laid out as share/ of a system")
        ->required()
        ->type_name("DIR");
    command->footer(std::string("All are made from what this program has.\n") + exitStatusHint);
    return command;
  }

  ExitStatus execute() override {
    for (const ReferenceFile& file : referenceFiles(call.app)) {
      const std::filesystem::path path = folder / file.path;
      std::error_code error;
      std::filesystem::create_directories(path.parent_path(), error);
      if (error) throw InputError(fmt::format("DIR: cannot write {}: {}", path.string(), error.message()));
      writeFileAtomically(path, file.text);
    }
    return ExitStatus::done;
  }
};

}  // namespace

std::unique_ptr<Command> referenceCommand(const Call& call) { return std::make_unique<ReferenceCommand>(call); }

}  // namespace ringwatch

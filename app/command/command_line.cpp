#include <ringwatch/app/command/command_line.h>

#include <algorithm>
#include <memory>
#include <new>
#include <utility>
#include <vector>

#include <ringwatch/app/command/command.h>
#include <ringwatch/app/command/help.h>
#include <ringwatch/app/command/process.h>
#include <ringwatch/app/output/report.h>
#include <ringwatch/app/ranks/rank_program.h>
#include <ringwatch/app/run/run_result.h>
#include <ringwatch/app/scene/scene_keys.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/leftovers.h>
#include <ringwatch/base/nearest_name.h>
#include <ringwatch/base/user_text.h>

namespace ringwatch {
namespace {

/// Every command, in the order of the help.
constexpr std::unique_ptr<Command> (*commandsOfProgram[])(const Call& call) = {
    helpCommand,   runCommand,      inspectCommand, auditCommand,    suggestCommand, scaleMassCommand,
    adviseCommand, meshCommand,     verifyCommand,  judgeCommand,    compareCommand, reportCommand,
    schemaCommand, examplesCommand, initCommand,    referenceCommand};

std::string mainFooter() {
  return std::string(unitsText) + "\n" + findHelpTopic("exit-status")->text() +
         "\n"
         "Examples:\n"
         "  ringwatch mesh generate bar --size 0.2 0.04 0.04 --cells 20 4 4 -o bar.msh\n"
         "  ringwatch inspect bar.msh --young 30e3 --poisson 0.3 --density 1000 --metric all --global\n"
         "  ringwatch run examples/stretch_bar.toml --out out/stretch_bar\n"
         "  ringwatch report out/stretch_bar\n"
         "  ringwatch compare examples/swinging_bar.toml --integrators all --out out/compare\n"
         "  ringwatch run scene.toml --set integrator.step=1e-4 --set output.every=0.01\n\n"
         "Topics of ringwatch help TOPIC:\n" +
         helpTopicListing();
}

/// What was typed, for the provenance of a page.
std::string commandTyped(int argc, char** argv) {
  std::string text = "ringwatch";
  for (int i = 1; i < argc; ++i) text += " " + shellWord(argv[i]);
  return text;
}

/// CLI11's message for a wrong usage, on one line, with the nearest known option or command.
std::string usageText(const CLI::App& app, const CLI::ParseError& fault) {
  std::string text = oneLine(fault.what());
  const CLI::App* innermost = &app;
  std::string command = "ringwatch";
  while (!innermost->get_subcommands().empty()) {
    innermost = innermost->get_subcommands().front();
    command += " " + innermost->get_name();
  }
  // An unknown command is reported by CLI11 as a missing one.
  const bool unknown = dynamic_cast<const CLI::ExtrasError*>(&fault) != nullptr ||
                       dynamic_cast<const CLI::RequiredError*>(&fault) != nullptr;
  if (unknown && !app.remaining(true).empty()) {
    std::vector<std::string> known;
    for (const CLI::Option* option : innermost->get_options()) known.push_back(option->get_name());
    for (const CLI::App* inner : innermost->get_subcommands([](const CLI::App*) { return true; }))
      known.push_back(inner->get_name());
    const std::string extra = app.remaining(true).front();
    const std::string hint = didYouMean(extra, known);
    text = fmt::format("unknown argument {}{}", inQuotes(extra),
                       hint.empty() ? "" : "; " + hint.substr(0, hint.size() - 1));
  }
  return fmt::format("{}; see {} --help", text, command);
}

ExitStatus dispatch(int argc, char** argv, const RankProgram* ranks) {
  CLI::App app("ringwatch: how large a step can this explicit finite element run take, and what stands in the way",
               "ringwatch");
  app.set_version_flag("--version", "ringwatch " + std::string(programVersion()));
  app.require_subcommand(1);
  app.footer(mainFooter());
  const Call call{app, commandTyped(argc, argv), ranks};
  std::vector<std::pair<const CLI::App*, std::unique_ptr<Command>>> commands;
  for (const auto make : commandsOfProgram) {
    std::unique_ptr<Command> command = make(call);
    const CLI::App* declared = command->declare(app);
    commands.emplace_back(declared, std::move(command));
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {  // --help and --version
    app.exit(asked);
    return ExitStatus::done;
  } catch (const CLI::ParseError& fault) {
    return complain(usageText(app, fault), ExitStatus::badInput);
  }
  return std::ranges::find_if(commands, [](const auto& one) { return one.first->parsed(); })->second->execute();
}

}  // namespace

int runCommandLine(int argc, char** argv, const RankProgram* ranks) {
  setSpeaks(!ranks || ranks->speaks());
  keepMemoryInReserve();
  holdStandardStreams();
  reportFileSizeLimit();
  removeLeftoversOnSignals();
  const auto status = [&] {
    try {
      ExitStatus result = ExitStatus::done;
      onLargeStack([&] { result = dispatch(argc, argv, ranks); });
      return result;
    } catch (const InputError& fault) {
      return complain(fault.what(), ExitStatus::badInput);
    } catch (const NumericalError& fault) {
      return complain(fault.what(), ExitStatus::unstable);
    } catch (const RunFailed& fault) {
      return complain(fault.what(), ExitStatus::unstable);
    } catch (const std::bad_alloc&) {
      return complain("out of memory; use a smaller mesh or more memory", ExitStatus::badInput);
    } catch (const std::exception& fault) {
      return complain(fault.what(), ExitStatus::badInput);
    }
  }();
  return static_cast<int>(status);
}

}  // namespace ringwatch

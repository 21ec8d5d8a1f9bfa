#include <ringwatch/app/command/command.h>
#include <ringwatch/app/command/help.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/nearest_name.h>
#include <ringwatch/base/user_text.h>

namespace ringwatch {
namespace {

struct HelpCommand final : Command {
  using Command::Command;
  std::vector<std::string> words;

  CLI::App* declare(CLI::App& app) override {
    CLI::App* command = app.add_subcommand("help", "explain a topic or a command");
    command->add_option("TOPIC", words, "one of the topics below, or a command such as run or mesh generate")
        ->type_name("TOPIC");
    command->footer("Topics:\n" + helpTopicListing());
    return command;
  }

  ExitStatus execute() override {
    if (const HelpTopic* topic = words.empty() ? nullptr : findHelpTopic(words[0])) {
      printOut(textOf(*topic));
      return ExitStatus::done;
    }
    const auto isCommand = [](const CLI::App*) { return true; };
    const CLI::App* command = &call.app;
    std::string name = call.app.get_name();
    for (const std::string& word : words) {
      std::vector<std::string> known;
      const CLI::App* found = nullptr;
      for (const CLI::App* next : command->get_subcommands(isCommand)) {
        known.push_back(next->get_name());
        if (next->get_name() == word) found = next;
      }
      if (command == &call.app)
        for (const HelpTopic& topic : helpTopics()) known.emplace_back(topic.name);
      if (!found)
        throw InputError(known.empty() ? fmt::format("help: {} has no command {}", name, inQuotes(word))
                                       : fmt::format("help: unknown topic {}; {}known are {}", inQuotes(word),
                                                     didYouMean(word, known), fmt::join(known, ", ")));
      command = found;
      name += " " + word;
    }
    printOut(call.app.get_formatter()->make_help(command, name, CLI::AppFormatMode::Normal));
    return ExitStatus::done;
  }

 private:
  std::string textOf(const HelpTopic& topic) const {
    if (words.size() == 1) return topic.text();
    if (topic.part == nullptr || words.size() > 2)
      throw InputError(fmt::format("help: unknown argument {}; write ringwatch help {}{}", inQuotes(words.back()),
                                   topic.name, topic.part == nullptr ? "" : " " + words[1]));
    const std::string text = topic.part(words[1]);
    if (text.empty())
      throw InputError(fmt::format("help: {} has no {}; {}known are {}", topic.name, inQuotes(words[1]),
                                   didYouMean(words[1], topic.parts()), fmt::join(topic.parts(), ", ")));
    return text;
  }
};

}  // namespace

std::unique_ptr<Command> helpCommand(const Call& call) { return std::make_unique<HelpCommand>(call); }

}  // namespace ringwatch

#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ringwatch {

/// What `ringwatch help TOPIC` explains. Texts are made from the registries.
struct HelpTopic {
  std::string_view name;
  std::string_view help;
  std::string (*text)();
  std::string (*names)();  // what the topic lists, in one line for the overview; nullptr: too much for a line
  std::string (*part)(std::string_view name) = nullptr;  // help TOPIC NAME, "" for an unknown one; nullptr: it has none
  std::vector<std::string> (*parts)() = nullptr;         // their names
};

/// All topics, one line each in help.cpp.
std::span<const HelpTopic> helpTopics();
/// nullptr when there is none of that name.
const HelpTopic* findHelpTopic(std::string_view name);
/// The overview of the topics.
std::string helpTopicListing();

}  // namespace ringwatch

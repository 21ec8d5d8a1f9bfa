#include <ringwatch/app/output/junit.h>

#include <algorithm>

#include <fmt/format.h>

#include <ringwatch/base/markup.h>

namespace ringwatch {

std::string junitText(const std::string& suite, const std::string& className, const std::vector<JunitCase>& cases,
                      const std::string& output) {
  const auto outputText = [](const std::string& indent, const std::string& text) {
    return text.empty() ? "" : fmt::format("{}<system-out>{}</system-out>\n", indent, markupText(text));
  };
  const auto messageText = [](const char* element, const std::string& text) {
    return text.empty() ? "" : fmt::format("    <{} message=\"{}\"/>\n", element, markupText(text));
  };
  const auto count = [&](std::string JunitCase::*message) {
    return std::ranges::count_if(cases, [&](const JunitCase& one) { return !(one.*message).empty(); });
  };
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\" "
      "skipped=\"{}\">\n",
      markupText(suite), cases.size(), count(&JunitCase::failure), count(&JunitCase::skipped));
  for (const JunitCase& one : cases) {
    const std::string inner =
        messageText("skipped", one.skipped) + messageText("failure", one.failure) + outputText("    ", one.output);
    text += fmt::format("  <testcase classname=\"{}\" name=\"{}\"", markupText(className), markupText(one.name));
    text += inner.empty() ? "/>\n" : fmt::format(">\n{}  </testcase>\n", inner);
  }
  return text + outputText("  ", output) + "</testsuite>\n";
}

}  // namespace ringwatch

// The documents hold what the code says: docs/integrators.md the table of declarations, docs/verify_your_own.md the
// example that own_integrator_test.cpp compiles.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include <ringwatch/verify/integrators/integrators.h>

namespace ringwatch {
namespace {

std::string read(const std::string& path) {
  std::ifstream file(std::string(RINGWATCH_SOURCE_DIR) + "/" + path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(Documentation, HoldsTheTableOfDeclarations) {
  const std::string text = read("docs/integrators.md");
  std::istringstream table(integratorTable(coreIntegrators()));
  for (std::string row; std::getline(table, row);) EXPECT_THAT(text, ::testing::HasSubstr(row + "\n"));
}

TEST(Documentation, HoldsTheExampleThatIsCompiled) {
  const std::string source = read("tests/verify/own_integrator_test.cpp"), mark = "// [example]\n";
  const auto begin = source.find(mark) + mark.size();
  EXPECT_THAT(read("docs/verify_your_own.md"), ::testing::HasSubstr(source.substr(begin, source.rfind(mark) - begin)));
}

}  // namespace
}  // namespace ringwatch

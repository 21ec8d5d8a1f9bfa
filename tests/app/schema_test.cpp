// The schemas by themselves, with a validator that knows nothing of ringwatch. That every output of the other tests is
// valid Program::call sees to, and that scenes are refused where the reader refuses them, scene_test.cpp.
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ringwatch/app/command/schema.h>
#include <ringwatch/app/output/output_fields.h>
#include <ringwatch/base/error.h>

#include "program.h"
#include "schema_check.h"

namespace ringwatch {
namespace {

using test::Json;
using test::jsonOfToml;
using test::Outcome;
using test::Program;
using test::SchemaCheck;
using ::testing::HasSubstr;

Json schemaNamed(std::string_view name) { return Json::parse(schemaOf(name).dump()); }

class Schemas : public Program {};

TEST_F(Schemas, AreListedAndPrinted) {
  const std::string listing = call("schema").out;
  for (const SchemaInfo& schema : allSchemas()) {
    EXPECT_THAT(listing, HasSubstr("  " + std::string(schema.name) + " "));
    const Outcome outcome = call("schema " + std::string(schema.name));
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(parse(outcome.out), schemaNamed(schema.name));
  }
  EXPECT_EQ(allSchemas().size(), jsonOutputs().size() + 1);
  expectRefused("schema scne", "did you mean \"scene\"?");
}

TEST_F(Schemas, AcceptEveryExample) {
  const SchemaCheck scene(schemaNamed("scene"));
  int examples = 0;
  for (const auto& entry : std::filesystem::directory_iterator(RINGWATCH_EXAMPLES)) {
    if (entry.path().extension() != ".toml") continue;
    ++examples;
    EXPECT_EQ(scene.faultOf(jsonOfToml(folder_.read(entry.path()))), "") << entry.path();
  }
  EXPECT_GE(examples, 5);
}

/// A scene with lines for sections that it has not.
Json tinyWith(const std::string& lines) { return jsonOfToml(test::tiny + lines); }

TEST_F(Schemas, HoldScenesToTheLawTheHandlerAndTheGenerator) {
  const SchemaCheck scene(schemaNamed("scene"));
  for (const char* lines :
       {"", "[[force]]\nwhere = \"x > 0\"\neach = [0, 0, 1]\n", "[handler]\nmethod = \"imex\"\nmargin = 0.2\n",
        "[handler]\nmethod = \"filtered\"\n", "[handler]\nmethod = \"imex\"\nsolver = \"cg\"\niterations = 5\n",
        "[handler]\n", "[monitor]\nmode = \"certify\"\n", "[[force]]\nset = \"x-max\"\nforce = [1, 2, 3]\n"})
    EXPECT_EQ(scene.faultOf(tinyWith(lines)), "") << lines;
  for (const char* lines :
       {"[handler]\nmargin = 0.2\n", "[handler]\nmethod = \"none\"\nmargin = 0.2\n",
        "[handler]\nmethod = \"mass-scaling\"\nsolver = \"cg\"\n", "[handler]\nmethod = \"imex\"\niterations = 0\n",
        "[handler]\nmethod = \"imex\"\nsolver = \"cholesky\"\niterations = 5\n", "[handler]\nmethod = \"imx\"\n",
        "[handler]\nmethod = \"imex\"\nmargin = 1\n", "[monitor]\nevery = 1.5\n", "[monitor]\nbracket = 1\n",
        "[[force]]\nset = \"x-max\"\nforce = [1, 2]\n", "[[force]]\nset = \"x-max\"\n",
        "[[force]]\nforce = [1, 2, 3]\n", "[weather]\n", "[monitor]\nweather = 1\n"})
    EXPECT_NE(scene.faultOf(tinyWith(lines)), "") << lines;
  const auto changed = [&](const char* section, const char* key, const Json& value) {
    Json document = tinyWith("");
    document[section][key] = value;
    return scene.faultOf(document);
  };
  EXPECT_EQ(changed("mesh", "jitter", 0.2), "");
  EXPECT_NE(changed("mesh", "jitter", 0.7), "");
  EXPECT_NE(changed("mesh", "radius", 1), "");
  EXPECT_NE(changed("mesh", "element", "tet5"), "");
  EXPECT_NE(changed("mesh", "file", "a.msh"), "");
  EXPECT_NE(changed("material", "poisson", 0.5), "");
  EXPECT_NE(changed("material", "weather", 0.5), "");
  Json document = tinyWith("");
  document["material"].erase("young");
  EXPECT_NE(scene.faultOf(document), "");
  document = tinyWith("");
  document["mesh"] = {{"file", "bar.msh"}};
  EXPECT_EQ(scene.faultOf(document), "");
  document["mesh"]["cells"] = {1, 1, 1};
  EXPECT_NE(scene.faultOf(document), "");
}

TEST_F(Schemas, KnowEveryKeyOfAnOutput) {
  ASSERT_EQ(call("mesh generate bar --cells 4 1 1 -o bar.msh").status, 0);
  const Outcome outcome = call(std::string("inspect bar.msh --json -") + test::material);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const SchemaCheck inspect(schemaNamed("inspect"));
  const Json good = parse(outcome.out);
  EXPECT_EQ(inspect.faultOf(good), "");
  Json bad = good;
  bad["weather"] = 1;
  EXPECT_NE(inspect.faultOf(bad), "");
  bad = good;
  bad["critical_step"].erase("safe");
  EXPECT_NE(inspect.faultOf(bad), "");
  bad = good;
  bad["critical_step"]["safe"] = "1";
  EXPECT_NE(inspect.faultOf(bad), "");
  bad = good;
  bad["controlling_element"]["nodes"][0] = 0.5;
  EXPECT_NE(inspect.faultOf(bad), "");
  bad = good;
  bad["mass"] = nullptr;
  EXPECT_NE(inspect.faultOf(bad), "");
}

}  // namespace
}  // namespace ringwatch

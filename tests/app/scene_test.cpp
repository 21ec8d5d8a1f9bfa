#include <ringwatch/app/scene/scene.h>

#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ringwatch/app/command/schema.h>
#include <ringwatch/app/scene/key_binding.h>
#include <ringwatch/app/scene/scene_keys.h>
#include <ringwatch/base/error.h>

#include <tests/support/temporary_folder.h>
#include "schema_check.h"

namespace ringwatch {
namespace {

using test::TemporaryFolder;
using ::testing::AllOf;
using ::testing::HasSubstr;

const char* const good = R"([mesh]
generate = "bar"
size = [0.2, 0.04, 0.04]
cells = [5, 1, 1]
[material]
model = "stvk"
young = 30e3
poisson = 0.3
density = 1000
[integrator]
step = 1e-4
end = 0.01
[monitor]
margin = 0.2
[[fix]]
where = "x < 1e-6"
[[move]]
where = "x > 0.2 - 1e-6"
velocity = [0.1, 0, 0]
[[force]]
where = "all"
acceleration = [0, 0, -9.81]
[output]
every = 1e-3
)";

/// The good scene with one text replaced by another.
std::string with(const std::string& what, const std::string& by) {
  std::string text = good;
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

/// What is valid against the schema must have no fault of type, range, choice or key, and the other way round.
void expectSchemaAgrees(const std::string& text, const std::vector<std::string>& overrides,
                        const std::string& message) {
  static const test::SchemaCheck schema(nlohmann::json::parse(schemaOf("scene").dump()));
  const nlohmann::json scene = test::withOverrides(test::jsonOfToml(text), overrides);
  if (!overrides.empty() && scene.is_null()) return;  // no assignment
  if (message == "no fault") {
    EXPECT_EQ(schema.faultOf(scene), "") << text;
  } else if (test::isAboutTypeRangeOrKey(message)) {
    EXPECT_NE(schema.faultOf(scene), "") << message << "\n" << text;
  }
}

/// Reads a scene and builds its body; returns the message of the InputError, its file name cut to "scene.toml".
std::string faultOf(const std::string& text, const std::vector<std::string>& overrides = {}) {
  const TemporaryFolder folder;
  const auto file = folder.write("scene.toml", text);
  try {
    const Scene scene = readScene(file, overrides);
    std::vector<std::string> notes;
    sceneBody(scene, sceneMesh(scene, notes), 1);
  } catch (const InputError& fault) {
    std::string message = fault.what();
    const std::string prefix = folder.path().string() + "/";
    while (message.find(prefix) != std::string::npos) message.erase(message.find(prefix), prefix.size());
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    expectSchemaAgrees(text, overrides, message);
    return message;
  }
  expectSchemaAgrees(text, overrides, "no fault");
  return "no fault";
}

TEST(Scene, ReadsAGoodOneAndFillsDefaults) {
  const TemporaryFolder folder;
  const Scene scene = readScene(folder.write("scene.toml", good));
  EXPECT_EQ(scene.generator, "bar");
  EXPECT_EQ(scene.materials.front().parameters.number("young"), 30e3);
  EXPECT_EQ(scene.step, 1e-4);
  EXPECT_EQ(scene.method, "symplectic-euler");
  EXPECT_EQ(scene.safety, 0.95);
  EXPECT_EQ(scene.margin, 0.2);
  EXPECT_EQ(scene.mode, MonitorMode::bracket);
  EXPECT_EQ(scene.metric, "");
  EXPECT_EQ(scene.onViolation, OnViolation::stop);
  EXPECT_EQ(scene.frameInterval, 1e-3);
  EXPECT_EQ(scene.fields, std::vector<std::string>{"critical_step"});
  EXPECT_EQ(scene.echo["mesh"]["element"], "tet4");
  EXPECT_EQ(scene.echo["monitor"]["every"], 1);
  EXPECT_EQ(scene.echo["fix"][0]["components"], "xyz");
  EXPECT_EQ(faultOf(good), "no fault");
}

TEST(Scene, PutsConstraintsAndForcesOnTheBody) {
  const TemporaryFolder folder;
  const Scene scene =
      readScene(folder.write("scene.toml", with("where = \"x < 1e-6\"", "where = \"x < 1e-6\"\ncomponents = \"xz\"")));
  std::vector<std::string> notes;
  const Body body = sceneBody(scene, sceneMesh(scene, notes), 1);
  int held = 0, moved = 0;
  for (std::int32_t i = 0; i < body.nodeCount(); ++i) {
    const double x = body.mesh().X(0, i);
    if (x < 1e-6) {
      EXPECT_TRUE(body.constraints().isConstrained(i, 0));
      EXPECT_FALSE(body.constraints().isConstrained(i, 1));
      EXPECT_TRUE(body.constraints().isConstrained(i, 2));
      ++held;
    } else if (x > 0.2 - 1e-6) {
      EXPECT_EQ(body.constraints().velocity()(0, i), 0.1);
      ++moved;
    }
  }
  EXPECT_EQ(held, 4);
  EXPECT_EQ(moved, 4);
  EXPECT_NEAR(body.externalForce().row(2).sum(), -9.81 * 0.32, 1e-9);
}

TEST(Scene, SpreadsATotalForceByMass) {
  const TemporaryFolder folder;
  const Scene scene = readScene(folder.write("scene.toml", with("acceleration = [0, 0, -9.81]", "force = [3, 0, 0]")));
  std::vector<std::string> notes;
  const Body body = sceneBody(scene, sceneMesh(scene, notes), 1);
  EXPECT_NEAR(body.externalForce().row(0).sum(), 3, 1e-12);
  EXPECT_NEAR(body.externalForce()(0, 0) / body.lumpedMass()[0], body.externalForce()(0, 1) / body.lumpedMass()[1],
              1e-9);
}

TEST(Scene, NamesFileLineKeyAndWhatWouldBeRight) {
  struct Case {
    std::string text, message;
  };
  const std::vector<Case> cases{
      {with("poisson = 0.3", "poisson = 0.5"),
       "scene.toml:8: material.poisson: 0.5 is out of range; must be > -1 and < 0.5"},
      {with("poisson = 0.3", "poisson = nan"),
       "scene.toml:8: material.poisson: nan is not a finite number; must be > -1 and < 0.5"},
      {with("density = 1000", "density = 0"), "scene.toml:9: material.density: 0 is out of range; must be > 0 kg/m3"},
      {with("young = 30e3", "young = -1"), "scene.toml:7: material.young: -1 is out of range; must be > 0 Pa"},
      {with("young = 30e3", "young = inf"), "scene.toml:7: material.young: inf is not a finite number; must be > 0 Pa"},
      {with("young = 30e3", "young = \"soft\""),
       "scene.toml:7: material.young: the text \"soft\" where a number is needed; must be > 0 Pa"},
      {with("step = 1e-4", "step = 0"), "scene.toml:11: integrator.step: 0 is out of range; must be > 0 s"},
      {with("step = 1e-4", "step = -1e-3"), "scene.toml:11: integrator.step: -0.001 is out of range; must be > 0 s"},
      {with("step = 1e-4", "step = nan"), "scene.toml:11: integrator.step: nan is not a finite number"},
      {with("step = 1e-4", "step = \"fast\""),
       "scene.toml:11: integrator.step: the text \"fast\" where a number or \"auto\" is needed"},
      {with("step = 1e-4", "step = 1"),
       "scene.toml:11: integrator.step: 1 s is beyond the end; must be <= end = 0.01 s"},
      {with("step = 1e-4", "stepp = 1e-4"),
       "scene.toml:11: integrator.stepp: unknown key \"stepp\" in [integrator]; did you mean \"step\"?"},
      {with("step = 1e-4\n", ""), "scene.toml:10: integrator.step: missing; give a number or \"auto\" in s, > 0"},
      {with("[monitor]", "[montior]"),
       "scene.toml:13: [montior]: unknown section \"montior\"; did you mean \"monitor\"?"},
      {with("[mesh]", "answer = 42\n[mesh]"), "scene.toml:1: answer: a key outside of a section"},
      {with("margin = 0.2", "margin = 1"), "scene.toml:14: monitor.margin: 1 is out of range; must be >= 0 and < 1"},
      {with("margin = 0.2", "every = 0"), "scene.toml:14: monitor.every: 0 is out of range; must be >= 1 steps"},
      {with("margin = 0.2", "every = 1.5"), "scene.toml:14: monitor.every: the number 1.5 where an integer is needed"},
      {with("margin = 0.2", "bracket = 1"),
       "scene.toml:14: monitor.bracket: the number 1 where true or false is needed"},
      {with("margin = 0.2", "mode = \"treshold\""), "scene.toml:14: monitor.mode: unknown \"treshold\"; did you mean"},
      {with("margin = 0.2", "mode = \"threshold\"\nbracket = false"),
       "scene.toml:15: monitor.bracket: false leaves nothing to prove, but mode = \"threshold\" does"},
      {with("margin = 0.2", "mode = \"metric\"\nmetric = \"none\""),
       "scene.toml:14: monitor.mode: \"metric\" needs a metric"},
      {with("margin = 0.2", "metric = \"reduced-1-rings\""), "did you mean \"reduced-1-ring\"?"},
      {with("margin = 0.2", "on_violation = \"handle\""),
       "scene.toml:14: monitor.on_violation: \"handle\" needs a handler; set handler.method"},
      {with("margin = 0.2", "[handler]\nmethod = \"imx\""),
       "scene.toml:15: handler.method: unknown \"imx\"; did you mean \"imex\"? must be one of none, "
       "local-time-stepping, imex, "},
      {with("model = \"stvk\"", "model = \"stvkk\""),
       "scene.toml:6: material.model: unknown \"stvkk\"; did you mean \"stvk\"?"},
      {with("[integrator]", "[integrator]\nmethod = \"explicit-euler\""),
       "scene.toml:11: integrator.method: \"explicit-euler\" is unstable at every step"},
      {with("generate = \"bar\"", "generate = \"bra\""),
       "scene.toml:2: mesh.generate: unknown \"bra\"; did you mean \"bar\"?"},
      {with("generate = \"bar\"\n", ""), "scene.toml:1: mesh.file: missing; give file or generate"},
      {with("generate = \"bar\"", "generate = \"bar\"\nfile = \"a.msh\""),
       "scene.toml:3: mesh.file: both file and generate are given"},
      {with("cells = [5, 1, 1]", "cells = [5, 1]"),
       "scene.toml:4: mesh.cells: [5,1] does not fit; must be a list of 3 integers"},
      {with("cells = [5, 1, 1]", "cells = [5, 0, 1]"), "scene.toml:4: mesh.cells: [5,0,1] does not fit"},
      {with("cells = [5, 1, 1]", "cells = [5, 1.5, 1]"), "scene.toml:4: mesh.cells: [5,1.5,1] does not fit"},
      {with("cells = [5, 1, 1]", "jitter = 0.7"),
       "scene.toml:4: mesh.jitter: 0.7 does not fit; must be one number, 0 or more and below 0.5"},
      {with("cells = [5, 1, 1]", "radius = 1"),
       "scene.toml:4: mesh.radius: the generator \"bar\" has no such parameter"},
      {with("cells = [5, 1, 1]", "element = \"tet5\""), "tet5"},
      {with("where = \"x < 1e-6\"", "where = \"x < -1\""),
       "scene.toml:16: fix.where: \"x < -1\" selects no node; the mesh lies in 0 <= x <= 0.2, 0 <= y <= 0.04, 0 <= z "
       "<= 0.04"},
      {with("where = \"x < 1e-6\"", "where = \"x << 1\""), "scene.toml:16: fix.where: \"x << 1\": column 4"},
      {with("where = \"x < 1e-6\"", "where = \"sqrt(x - 1) > 0\""),
       "scene.toml:16: fix.where: \"sqrt(x - 1) > 0\" has no value at"},
      {with("where = \"x < 1e-6\"", "where = \"set:left\""), "scene.toml:16: fix.where: unknown node set \"left\""},
      {with("where = \"x < 1e-6\"", "set = \"x-mni\""), "did you mean \"x-min\"?"},
      {with("where = \"x < 1e-6\"", "components = \"x\""), "scene.toml:15: fix.where: missing"},
      {with("where = \"x < 1e-6\"", "where = \"all\"\ncomponents = \"xw\""),
       "scene.toml:17: fix.components: \"xw\" names no components"},
      {with("velocity = [0.1, 0, 0]", "velocity = [0.1, 0]"),
       "scene.toml:19: move.velocity: a list of 2 where a list of three numbers is needed"},
      {with("velocity = [0.1, 0, 0]", "velocity = [0.1, 0, nan]"),
       "scene.toml:19: move.velocity: nan is not a finite number"},
      {with("acceleration = [0, 0, -9.81]", ""), "scene.toml:20: force.acceleration: missing"},
      {with("acceleration = [0, 0, -9.81]", "acceleration = [0, 0, 1]\nforce = [0, 0, 1]"),
       "both acceleration and force are given"},
      {with("every = 1e-3", "fields = [\"metric\"]"), "scene.toml:24: output.fields: \"metric\" needs a metric"},
      {with("every = 1e-3", "fields = \"critical_step\""),
       "scene.toml:24: output.fields: the text \"critical_step\" where a list of texts is needed"},
      {with("every = 1e-3", "every = 0"), "scene.toml:24: output.every: 0 is out of range; must be > 0 s"},
      {with("[[fix]]", "[fix]"), "scene.toml:15: fix: a table where tables are needed; write [[fix]] above each"},
      {with("[integrator]", "[[integrator]]"),
       "scene.toml:10: integrator: a list of 1 where a section is needed; write [integrator]"},
      {with("[material]", "[[material]]"), "no fault"},
      {with("young = 30e3", "young = 30e3\nyoung = 1"), "scene.toml:8: not TOML"},
      {with("[material]", "[material"), "scene.toml:"},
      {std::string("\xff\xfe\x00", 3), "scene.toml: this is a text in UTF-16"},
      {"", "scene.toml: the file is empty"},
      {"# a scene\n", "scene.toml: [mesh]: the section is missing"},
  };
  for (const Case& c : cases) EXPECT_THAT(faultOf(c.text), HasSubstr(c.message)) << c.text;
}

TEST(Scene, RefusesTwoVelocitiesOfANode) {
  // The bar's face x-min has four nodes, two of them at y = 0.
  const std::string fix = "where = \"x < 1e-6\"", move = "where = \"x > 0.2 - 1e-6\"";
  EXPECT_THAT(faultOf(with(move, "where = \"x < 0.05\"")),
              AllOf(HasSubstr("scene.toml:18: move.where: it prescribes another velocity than "),
                    HasSubstr("scene.toml:16: fix.where at 4 nodes of both (0.1 and 0 m/s along x)")));
  EXPECT_THAT(faultOf(with("[[force]]", "[[move]]\nset = \"x-max\"\nvelocity = [0.1, 0.2, 0]\n[[force]]")),
              AllOf(HasSubstr("scene.toml:21: move.set: "),
                    HasSubstr("scene.toml:18: move.where at 4 nodes of both (0.2 and 0 m/s along y)")));
  // The same twice, or components that one of them leaves alone, are allowed.
  for (const char* second :
       {"[[fix]]\nwhere = \"y < 1e-6 and x < 0.1\"\n", "[[move]]\nset = \"x-max\"\nvelocity = [0.1, 0, 0]\n",
        "[[fix]]\nwhere = \"all\"\ncomponents = \"yz\"\n", "[[move]]\nset = \"x-min\"\nvelocity = [0, 0, 0]\n"})
    EXPECT_EQ(faultOf(with("[[force]]", std::string(second) + "[[force]]")), "no fault") << second;
}

TEST(Scene, ShortensWhatAUserWrote) {
  const std::string name(100000, 'k');
  for (const std::string& text :
       {with("step = 1e-4", name + " = 1"), with("[monitor]", "[" + name + "]"),
        with("model = \"stvk\"", "model = \"" + name + "\""),
        with("where = \"x < 1e-6\"", "where = \"" + name + " < 1\""),
        with("where = \"x < 1e-6\"", "set = \"" + name + "\""),
        with("generate = \"bar\"", "generate = \"" + name + "\""), with("young = 30e3", "young = \"" + name + "\""),
        with("cells = [5, 1, 1]", "element = \"" + name + "\"")}) {
    const std::string fault = faultOf(text);
    EXPECT_NE(fault, "no fault");
    EXPECT_LE(fault.size(), 1000u) << fault.substr(0, 300);
  }
}

TEST(Scene, OverridesWinAndAreNamedInErrors) {
  const TemporaryFolder folder;
  const auto file = folder.write("scene.toml", good);
  const Scene scene =
      readScene(file, {"integrator.step=2e-4", "integrator.method=verlet", "handler.method=none",
                       "move.0.velocity=[0, 1, 0]", "monitor.bracket = false", "monitor.metric=\"single-element\""});
  EXPECT_EQ(scene.step, 2e-4);
  EXPECT_EQ(scene.method, "verlet");
  EXPECT_EQ(scene.moves[0].velocity, Eigen::Vector3d(0, 1, 0));
  EXPECT_EQ(scene.mode, MonitorMode::metric);
  EXPECT_EQ(scene.metric, "single-element");
  EXPECT_EQ(readScene(file, {"integrator.step=auto"}).step, std::nullopt);
  EXPECT_EQ(readScene(file, {"monitor.mode=threshold"}).mode, MonitorMode::threshold);
  EXPECT_TRUE(readScene(file, {"monitor.mode=threshold"}).proves());
  EXPECT_EQ(readScene(file, {"monitor.mode=certify"}).mode, MonitorMode::threshold);
  EXPECT_THAT(sceneHelp(), HasSubstr("certify is another name of threshold"));
  EXPECT_EQ(readScene(file, {"monitor.mode=metric", "monitor.metric=single-element"}).mode, MonitorMode::metric);

  const std::map<std::string, std::string> faults{
      {"integrator.step=-1", "--set integrator.step=-1: integrator.step: -1 is out of range; must be > 0 s"},
      {"integrator.stepp=1", "--set integrator.stepp=1: integrator.stepp: unknown key"},
      {"montior.every=1", "--set montior.every=1: [montior]: unknown section"},
      {"step=1", "the section is missing; write integrator.step=1 or "},
      {"stepp=1", "not an assignment; write section.key=value"},
      {"integrator.step", "not an assignment"},
      {"=", "not an assignment"},
      {"integrator.step=", "the value is not TOML"},
      {"integrator.step=1\n[x]", "--set integrator.step=1 [x]: the value is not TOML"},
      {"move.velocity=[1,0,0]", "[[move]] is a list; write move.0.velocity"},
      {"move.7.velocity=[1,0,0]", "there is no [[move]] number 7; the scene has 1, counted from 0"},
      {"move.99999999999999999999.velocity=[1,0,0]", "there is no [[move]] number"},
      {"integrator.0.step=1", "there is no [[integrator]] number 0"},
  };
  for (const auto& [text, message] : faults) EXPECT_THAT(faultOf(good, {text}), HasSubstr(message)) << text;
}

TEST(Scene, NamesMissingAndUnreadableFiles) {
  const TemporaryFolder folder;
  EXPECT_THROW(readScene(folder.path() / "none.toml"), InputError);
  EXPECT_THROW(readScene(folder.path()), InputError);
  const std::string mesh =
      with("generate = \"bar\"\nsize = [0.2, 0.04, 0.04]\ncells = [5, 1, 1]", "file = \"none.msh\"");
  EXPECT_THAT(faultOf(mesh), AllOf(HasSubstr("scene.toml:2: mesh.file: "), HasSubstr("none.msh")));
}

TEST(Scene, TableOfKeysIsConsistent) {
  for (const SceneKey& key : sceneKeys()) {
    EXPECT_FALSE(key.help.empty()) << key.section << "." << key.key;
    EXPECT_FALSE(key.required && !key.fallback.empty()) << key.section << "." << key.key;
    EXPECT_THAT(sceneHelp(), HasSubstr("  " + key.key));
  }
}

// What a key's one declaration says is what is read, listed, refused and part of the schema.
TEST(Scene, AKeyIsOneDeclaration) {
  const SceneSection section = plainSection(
      {.name = "trial", .help = "of a test", .alternatives = {{"hold", "until", SceneAlternative::Need::atMostOne}}},
      {{key("hold", &Scene::holdsStep, "whether it holds"),
        key("until", &Scene::end, "how long", {.unit = "s", .required = true, .range = KeyRange::positive}),
        numberOrAuto("step", &Scene::step, "how far", {.unit = "s"}),
        choice("device", &Scene::device, runDeviceNames, "where")}});
  EXPECT_EQ(section.keys[0].fallback, "false");
  EXPECT_EQ(section.keys[3].choices, runDeviceNames.names());
  const std::string help = sceneHelp(section);
  EXPECT_THAT(help, AllOf(HasSubstr("until             number, s, > 0, required"), HasSubstr("how far"),
                          HasSubstr("step              number or \"auto\", s, default \"auto\"")));

  const nlohmann::ordered_json schema = schemaOf(section);
  EXPECT_EQ(schema["properties"]["until"]["exclusiveMinimum"], 0);
  EXPECT_EQ(schema["required"], nlohmann::ordered_json({"until"}));
  EXPECT_EQ(schema["allOf"].size(), 1u);

  const SceneTable table{"trial",
                         "t.toml:1",
                         {{"until", {2.5, "t.toml:2", true}},
                          {"step", {"auto", "default", false}},
                          {"device", {"cuda", "t.toml:3", true}}}};
  Scene scene;
  scene.step = 1;
  section.read(table, scene);
  EXPECT_EQ(scene.end, 2.5);
  EXPECT_EQ(scene.step, std::nullopt);
  EXPECT_EQ(scene.device, RunDevice::cuda);
}

// Each key of the format has its place in the schema of its section, and its default there.
TEST(Scene, EveryKeyIsInTheSchemaOfItsSection) {
  for (const SceneSection& section : sceneSections()) {
    const nlohmann::ordered_json properties = schemaOf(section)["properties"];
    EXPECT_EQ(properties.size(), section.keys.size()) << section.name;
    for (const SceneKey& one : section.keys) {
      EXPECT_EQ(one.section, section.name);
      ASSERT_TRUE(properties.contains(one.key)) << one.key;
      EXPECT_EQ(!one.fallback.empty(), properties[one.key].contains("default")) << one.key;
    }
  }
}

// Any prefix of a good scene, and any scene with a byte changed, is read or refused in one line.
TEST(Scene, DamagedScenesNeverCrash) {
  const std::string text = good;
  for (std::size_t i = 0; i < text.size(); i += 3) faultOf(text.substr(0, i));
  for (std::size_t i = 0; i < text.size(); i += 5) {
    std::string damaged = text;
    damaged[i] = static_cast<char>("\"[=x\xc3\n"[i % 6]);
    faultOf(damaged);
  }
}

}  // namespace
}  // namespace ringwatch

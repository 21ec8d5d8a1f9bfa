// The words of the program: its help, topics made from the registries, and messages about names and meshes.
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ringwatch/app/command/help.h>
#include <ringwatch/app/command/verify.h>
#include <ringwatch/app/output/exit_status.h>
#include <ringwatch/app/output/output_fields.h>
#include <ringwatch/app/scene/integrator_catalog.h>
#include <ringwatch/app/scene/scene_keys.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/nearest_name.h>
#include <ringwatch/elements/registry.h>
#include <ringwatch/handlers/handler.h>
#include <ringwatch/materials/registry.h>
#include <ringwatch/meshes/generators/generator_registry.h>
#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/monitor/metrics/metrics.h>

#include "program.h"

namespace ringwatch {
namespace {

using test::Outcome;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class Words : public test::Program {
 protected:
  /// The message of bad input, one line.
  std::string refusal(const std::string& arguments) {
    const Outcome outcome = call(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments << "\n" << outcome.err;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << arguments << "\n" << outcome.err;
    return outcome.err;
  }
  /// What `ringwatch help TOPIC` says, called once: a topic has hundreds of entries.
  const std::string& help(const std::string& topic) {
    const auto [told, isNew] = told_.try_emplace(topic);
    if (!isNew) return told->second;
    const Outcome outcome = call("help " + topic);
    EXPECT_EQ(outcome.status, 0) << topic << "\n" << outcome.err;
    EXPECT_EQ(outcome.err, "") << topic;
    return told->second = outcome.out;
  }

 private:
  std::map<std::string, std::string> told_;
};

std::size_t lineCount(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

/// A line of a listing that begins with this name.
auto lists(std::string_view name) { return HasSubstr("\n  " + std::string(name) + " "); }

TEST_F(Words, EveryTopicListsItsRegistry) {
  for (const ElementInfo& info : allElements()) {
    EXPECT_THAT(help("elements"), lists(info.name));
    for (const QuadratureRule& rule : info.rules) EXPECT_THAT(help("elements"), lists("  " + std::string(rule.name)));
  }
  for (const LawInfo& info : allLaws()) EXPECT_THAT(help("laws"), lists(info.name));
  for (const IntegratorInfo& info : integratorInfos()) EXPECT_THAT(help("integrators"), lists(info.name));
  for (const MetricInfo& info : allMetrics()) EXPECT_THAT(help("metrics"), lists(info.name));
  for (const HandlerEntry& entry : allHandlers()) EXPECT_THAT(help("handlers"), lists(entry.info->name));
  for (const MeshFormatInfo& info : allMeshFormats()) EXPECT_THAT(help("formats"), lists(info.extensions));
  for (const GeneratorInfo& info : allGenerators()) {
    EXPECT_THAT(help("generators"), lists(info.name));
    for (const GeneratorParameter& p : info.parameters) EXPECT_THAT(help("generators"), HasSubstr(p.name));
  }
  for (const StudyInfo& info : allStudies()) EXPECT_THAT(help("studies"), lists(info.name));
  for (const std::span<const OutputField> fields : {historyColumns(), summaryKeys(), frameFields()})
    for (const OutputField& field : fields) EXPECT_THAT(help("outputs"), lists(field.name));
  for (const ExitStatusInfo& info : exitStatuses) EXPECT_THAT(help("exit-status"), HasSubstr(info.meaning));
  const std::string whole = call("run --help-scene").out;
  EXPECT_THAT(whole, Not(HasSubstr("e+09")));
  for (const SceneSection& section : sceneSections()) EXPECT_THAT(help("scene"), HasSubstr(section.name));
  EXPECT_LE(lineCount(help("scene")), sceneSections().size() + 10);
  for (const SceneKey& key : sceneKeys()) {
    EXPECT_THAT(help("scene " + key.section), lists(key.key));
    EXPECT_THAT(whole, lists(key.key));
  }
  EXPECT_THAT(help("scene contact"), Not(lists("snap")));  // of [[cut]]
}

TEST_F(Words, NoLineOfTheListOfTopicsIsBlank) {
  std::istringstream lines(call("help --help").out);
  for (std::string line; std::getline(lines, line);)
    EXPECT_TRUE(line.empty() || line.find_first_not_of(' ') != std::string::npos);
}

TEST_F(Words, HelpOfACommandIsAboutIt) {
  EXPECT_EQ(help(""), call("--help").out);
  for (const HelpTopic& topic : helpTopics()) EXPECT_THAT(help(""), lists(topic.name));
  for (const std::string command : {"run", "inspect", "compare", "verify", "schema", "reference", "mesh",
                                    "mesh generate", "mesh convert", "mesh check"}) {
    const std::string text = call(command + " --help").out;
    EXPECT_EQ(help(command), text) << command;
    EXPECT_LE(lineCount(text), 56u) << command << "\n" << text;
    EXPECT_THAT(text, Not(HasSubstr("symplectic, one force a step"))) << command;
  }
  for (const std::string command : {"inspect", "mesh convert", "mesh check"})
    EXPECT_THAT(help(command), HasSubstr(readableExtensions()));
  for (const std::string& text : {help(""), help("scene"), help("inspect")}) {
    EXPECT_THAT(text, Not(HasSubstr("SI units")));
    EXPECT_THAT(text, HasSubstr("any consistent units"));
  }
}

TEST_F(Words, UnknownTopicsAreAnsweredWithAllOfThem) {
  EXPECT_THAT(refusal("help scne"),
              AllOf(HasSubstr("did you mean \"scene\"?"), HasSubstr("exit-status"), HasSubstr("run")));
  EXPECT_THAT(refusal("help weather"), AllOf(HasSubstr("unknown topic \"weather\"; known are"), HasSubstr("metrics")));
  EXPECT_THAT(refusal("help scene contakt"), HasSubstr("scene has no \"contakt\"; did you mean \"contact\"?"));
  EXPECT_THAT(refusal("help laws stvk"), HasSubstr("unknown argument \"stvk\"; write ringwatch help laws"));
  EXPECT_THAT(refusal("help scene contact slip"), HasSubstr("write ringwatch help scene contact"));
  EXPECT_THAT(refusal("help mesh melt"), HasSubstr("known are generate, convert, check"));
  EXPECT_THAT(refusal("help run fast"), HasSubstr("ringwatch run has no command \"fast\""));
}

TEST_F(Words, OnlyNearNamesAreProposed) {
  ASSERT_EQ(call("mesh generate cube --size 0.05 --cells 1 -o cube.msh").status, 0);
  const std::string material = " --young 30e3 --poisson 0.3 --density 1000 ";
  EXPECT_THAT(refusal("inspect cube.msh --integrator houbolt" + material),
              AllOf(HasSubstr("unknown \"houbolt\"; known are explicit-euler"), Not(HasSubstr("did you mean"))));
  EXPECT_THAT(refusal("inspect cube.msh --integrator verlett" + material), HasSubstr("did you mean \"verlet\"?"));
  EXPECT_THAT(refusal("inspect cube.msh --fix set:clamp" + material),
              AllOf(HasSubstr("unknown node set \"clamp\"; the mesh has "), Not(HasSubstr("did you mean"))));
  EXPECT_THAT(refusal("frobnicate"), Not(HasSubstr("did you mean")));
  EXPECT_THAT(refusal("mesh generate torus -o a.msh"),
              AllOf(HasSubstr("known are bar"), Not(HasSubstr("did you mean"))));
}

// Names of the field lead to ours, in options, keys and values alike.
TEST_F(Words, NamesOfTheFieldAreUnderstood) {
  std::vector<std::string> ours;
  for (const SceneKey& key : sceneKeys()) {
    ours.push_back(key.key);
    ours.insert(ours.end(), key.choices.begin(), key.choices.end());
  }
  for (const FieldTerm& term : fieldTerms) EXPECT_THAT(ours, ::testing::Contains(term.here)) << term.word;

  ASSERT_EQ(call("mesh generate cube --size 0.05 --cells 1 -o cube.msh").status, 0);
  const std::string material = " --young 30e3 --poisson 0.3 --density 1000 ";
  for (const std::string scheme :
       {"leapfrog", "central-difference", "Central_Difference", "velocity-verlet", "newmark"})
    EXPECT_THAT(refusal("inspect cube.msh --integrator " + scheme + material), HasSubstr("did you mean \"verlet\"?"));
  EXPECT_THAT(refusal("inspect cube.msh --E 30e3 --poisson 0.3 --density 1000"),
              HasSubstr("did you mean \"--young\"?"));
  folder_.write("scene.toml", test::tiny);
  EXPECT_THAT(refusal("run scene.toml --set \"output.fields=['mises']\""), HasSubstr("did you mean \"von_mises\"?"));
  EXPECT_THAT(refusal("run scene.toml --set integrator.method=leapfrog"), HasSubstr("did you mean \"verlet\"?"));
  EXPECT_THAT(refusal("run scene.toml --set integrator.dt=1"), HasSubstr("did you mean \"step\"?"));
}

// What was meant is named where a word stands for something else.
TEST_F(Words, SlipsNameWhatWasMeant) {
  ASSERT_EQ(call("mesh generate cube --size 0.05 --cells 1 -o cube.msh").status, 0);
  const std::string material = " --young 30e3 --poisson 0.3 --density 1000 ";
  EXPECT_THAT(refusal("inspect cube.msh --fix clamp" + material), HasSubstr("a named set is written \"set:clamp\""));
  EXPECT_THAT(refusal("run cube.msh"),
              AllOf(HasSubstr("cube.msh: is a mesh; give a scene (TOML)"), HasSubstr("ringwatch inspect cube.msh")));
  const std::string scene = test::tiny;
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = scene;
    folder_.write("scene.toml", text.replace(text.find(from), from.size(), to));
  };
  with("model = \"stvk\"", "model = stvk  # soft");
  EXPECT_THAT(refusal("run scene.toml"), HasSubstr("scene.toml:6: not TOML: "));
  EXPECT_THAT(refusal("run scene.toml"), HasSubstr("a text stands in quotes, model = \"stvk\""));
  with("step = 1e-3", "step = 1/1000");
  EXPECT_THAT(refusal("run scene.toml"),
              AllOf(HasSubstr("scene.toml:11: not TOML: "), HasSubstr("write step = 0.001")));
  folder_.write("scene.toml", scene);
  EXPECT_THAT(
      refusal("run scene.toml --set step=1e-4"),
      HasSubstr("--set step=1e-4: the section is missing; write integrator.step=1e-4 or handler.step=1e-4 or "));
  EXPECT_EQ(
      call("run scene.toml --quiet --out r --set integrator.step=$(echo 1/2000) --set output.picture=false").status, 0);
  EXPECT_EQ(json("r/summary.json")["largest_step"].get<double>(), 1.0 / 2000);

  // Every option that is a step takes what suggest takes.
  const auto step = [&](const std::string& h) {
    return call("inspect cube.msh --step " + h + " --prove " + h + " --json -" + material).out;
  };
  EXPECT_EQ(step("1/1000"), step("0.001"));

  folder_.write("sets.inp",
                "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 0, 1, 0\n4, 0, 0, 1\n*ELEMENT, TYPE=C3D4, ELSET=all\n"
                "1, 1, 2, 3, 4\n*NSET, NSET=foot\n1, 2\n");
  EXPECT_THAT(refusal("inspect sets.inp --fix set:all" + material),
              HasSubstr("\"all\" is a set of elements, and nodes are selected here; the mesh has the node sets foot"));
  with("generate = \"bar\"\nsize = [0.1, 0.02, 0.02]\ncells = [5, 1, 1]", "file = \"sets.inp\"");
  EXPECT_THAT(
      refusal("run scene.toml --set material.set=foot"),
      HasSubstr("\"foot\" is a set of nodes, and elements are selected here; the mesh has the element sets all"));
}

TEST_F(Words, LongArgumentsDoNotFillTheScreen) {
  const std::string name(100000, 'k');
  for (const std::string& arguments :
       {name, "inspect " + name, "inspect a.msh --young " + name + " --poisson 0.3 --density 1",
        "mesh generate " + name + " -o a.msh", "mesh generate bar -o " + name, "run " + name + ".toml",
        "run a.toml --set " + name + "=1", "verify " + name, "help " + name, "run --threads " + name + " a.toml"})
    EXPECT_LE(refusal(arguments).size(), 1200u) << arguments.substr(0, 60);
}

/// A file of `count` tetrahedra that refer to a node which it does not have.
std::string brokenMsh(int count) {
  std::ostringstream text;
  text << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n$Elements\n"
       << count << "\n";
  for (int e = 1; e <= count; ++e) text << e << " 4 0 1 2 3 " << 10 + e << "\n";
  text << "$EndElements\n";
  return text.str();
}

TEST_F(Words, MeshCheckShowsTenProblemsAndTheirNumber) {
  folder_.write("broken.msh", brokenMsh(60000));
  const Outcome first = call("mesh check broken.msh");
  EXPECT_EQ(first.status, 1);
  EXPECT_EQ(lineCount(first.out), 12u);
  EXPECT_THAT(first.out,
              AllOf(HasSubstr("broken.msh:13: element 1 (tet4) refers to node 11"),
                    HasSubstr("broken.msh:22: element 10"), HasSubstr("… and 59991 more; --all lists them\n"),
                    HasSubstr("broken.msh: 60001 problems: 60000 missing-node, 1 unused-node\n")));
  const Outcome all = call("mesh check --all broken.msh");
  EXPECT_EQ(lineCount(all.out), 60002u);
  EXPECT_THAT(all.out, HasSubstr("broken.msh:60012: element 60000 "));
}

TEST_F(Words, CheckAndInspectNoteWhatIsOddAboutAMesh) {
  std::ostringstream text;  // two tetrahedra that meet at a face without sharing its nodes
  text << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n8\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 0 0 0\n6 1 0 0\n7 0 "
          "1 0\n"
          "8 0 0 -1\n$EndNodes\n$Elements\n2\n1 4 0 1 2 3 4\n2 4 0 5 7 6 8\n$EndElements\n";
  folder_.write("apart.msh", text.str());
  for (const std::string command : {"mesh check apart.msh", "inspect apart.msh --young 1 --poisson 0.3 --density 1"}) {
    const Outcome outcome = call(command);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(outcome.out,
                AllOf(HasSubstr("note: apart.msh: the mesh falls into 2 parts"),
                      HasSubstr("note: apart.msh: 3 nodes lie where another node lies, e.g. nodes 1 and 5")));
  }
  EXPECT_THAT(
      call("mesh check apart.msh").out,
      HasSubstr("conclusion: apart.msh: every element is sound; the mesh falls into 2 parts that share no node, "
                "of 1, 1 elements; 3 nodes lie where another node lies, e.g. nodes 1 and 5\n"));
}

TEST_F(Words, StudiesTellHowFarTheyAre) {
  std::vector<std::string> told;
  StudyProgress progress;
  progress.begins = [&](const StudyInfo& study, std::size_t number, std::size_t count) {
    told.push_back(std::string(study.name) + " " + std::to_string(number) + "/" + std::to_string(count));
  };
  progress.ended = [&](const StudyReport& report) { told.push_back(report.study + " ended"); };
  runStudies({"stress"}, StudyEffort::quick, progress);
  EXPECT_THAT(told, ElementsAre("robustness 1/1", "robustness ended"));
  told.clear();
  EXPECT_THROW(runStudies({"elements", "stres"}, StudyEffort::quick, progress), InputError);
  EXPECT_THAT(told, IsEmpty());
}

TEST_F(Words, FormerNamesOfStudiesStillStartThem) {
  int renamed = 0;
  for (const StudyInfo& info : allStudies()) {
    if (info.formerName.empty()) continue;
    ++renamed;
    EXPECT_THAT(help("studies"), Not(lists(info.formerName)));
  }
  EXPECT_GT(renamed, 0);
  const std::vector<StudyReport> reports = runStudies({"stress"}, StudyEffort::quick);
  ASSERT_EQ(reports.size(), 1u);
  EXPECT_EQ(reports[0].study, "robustness");
  EXPECT_THAT(refusal("verify stres"), HasSubstr("there is no such study"));
}

}  // namespace
}  // namespace ringwatch

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <utility>

#include <fmt/format.h>

#include <ringwatch/app/command/command.h>
#include <ringwatch/app/command/last_number.h>
#include <ringwatch/app/command/verify.h>
#include <ringwatch/app/output/provenance.h>
#include <ringwatch/app/output/report.h>
#include <ringwatch/app/scene/deck_keywords.h>
#include <ringwatch/base/atomic_file.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/input_file.h>
#include <ringwatch/base/scratch_folder.h>
#include <ringwatch/base/subprocess.h>
#include <ringwatch/base/user_text.h>
#include <ringwatch/meshes/formats/vtu_writer.h>
#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/monitor/metrics/metrics.h>
#include <ringwatch/monitor/step_limit.h>

namespace ringwatch {
namespace {

/// An element that decks have none for; empty where they have all of the mesh.
std::string_view elementWithoutDeck(const Mesh& mesh) {
  for (const MeshBlock& block : mesh.blocks)
    if (const ElementInfo& element = elementInfo(block.type); !findDeckSolidOf(element.name, "")) return element.name;
  return {};
}

/// A deck of Abaqus' and CalculiX' form with a free body and, where one is given, a fixed step, s.
std::string deckText(const Mesh& mesh, double young, double poisson, double density, std::optional<double> step) {
  std::string text = "*NODE, NSET=NALL\n";
  for (Eigen::Index i = 0; i < mesh.X.cols(); ++i)
    text += fmt::format("{}, {}, {}, {}\n", i + 1, mesh.X(0, i), mesh.X(1, i), mesh.X(2, i));
  std::size_t number = 0;
  for (const MeshBlock& block : mesh.blocks) {
    const ElementInfo& element = elementInfo(block.type);
    const DeckSolid* solid = findDeckSolidOf(element.name, element.rules.front().name);
    text += fmt::format("*ELEMENT, TYPE={}, ELSET=EALL\n", solid->type);
    for (std::size_t e = 0; e < block.elementCount(); ++e) {
      text += fmt::format("{}", ++number);
      for (int a = 0; a < block.nodesPerElement(); ++a)
        text += fmt::format(",{}{}", a == 15 ? "\n" : " ", block.element(e)[a] + 1);  // 16 numbers a line
      text += "\n";
    }
  }
  text += fmt::format("*MATERIAL, NAME=M\n*ELASTIC\n{}, {}\n*DENSITY\n{}\n*SOLID SECTION, ELSET=EALL, MATERIAL=M\n",
                      young, poisson, density);
  if (step)
    text += fmt::format("*STEP\n*DYNAMIC, EXPLICIT, DIRECT USER CONTROL\n{}, {}\n*END STEP\n", *step, 1000 * *step);
  return text;
}

/// A rule that a shell's command tells: the last line of its standard output is the step. seconds: that it may take.
StepRuleOfOthers ruleOfCommand(const std::string& command, double seconds) {
  return [command, seconds, folder = std::make_shared<ScratchFolder>()](const Mesh& mesh, double young, double poisson,
                                                                        double density) {
    std::string line = command;
    const auto replace = [&](const std::string& what, const std::string& value) {
      for (std::size_t at = 0; (at = line.find(what, at)) != std::string::npos; at += value.size())
        line.replace(at, what.size(), value);
    };
    for (const std::string extension : {"msh", "vtu", "inp"}) {
      const std::filesystem::path file = folder->path() / ("mesh." + extension);
      const std::string place = extension == "msh" ? "{mesh}" : "{mesh." + extension + "}";
      if (line.find(place) == std::string::npos) continue;
      if (extension == "inp") {
        if (const std::string_view element = elementWithoutDeck(mesh); !element.empty())
          throw InputError(fmt::format("--command: {{mesh.inp}}: a deck has no element for {}; use {{mesh}}", element));
        writeFileAtomically(file, deckText(mesh, young, poisson, density, std::nullopt));
      } else
        writeMesh(mesh, file);
      replace(place, shellWord(file.string()));
    }
    replace("{young}", fmt::format("{}", young));
    replace("{poisson}", fmt::format("{}", poisson));
    replace("{density}", fmt::format("{}", density));
    constexpr int outOfTime = 124;  // what `timeout` of the GNU core utilities ends with
    const std::filesystem::path printed = folder->path() / "printed";
    const ProgramResult result =
        runProgram({"timeout", "--kill-after=1", fmt::format("{}", seconds), "/bin/sh", "-c", line},
                   std::filesystem::current_path(), printed);
    if (!result.found) throw InputError("--command: needs the program timeout of the GNU core utilities");
    const auto [step, last] = lastNumber(readBytes(printed));
    const std::string fault =
        result.status == outOfTime ? fmt::format("took longer than {} s, which --timeout says", seconds)
        : result.status != 0       ? fmt::format("ended with status {} and said {}", result.status,
                                                 inQuotes(result.output.empty() ? last : result.output))
        : step                     ? ""
               : fmt::format("the last line of its standard output, {}, is no number; must be the step alone, s",
                             inQuotes(last));
    if (!fault.empty()) throw InputError(fmt::format("--command: {}: {}", line, fault));
    return *step;
  };
}

/// A rule in a shared library: ringwatch_step_rule(nodes, points[3 nodes], elements, nodes of each, their numbers,
/// young, poisson, density), the step, s; of a mesh of several kinds of elements, the least of theirs.
StepRuleOfOthers ruleOfLibrary(const std::string& file) {
  void* const library = dlopen(std::filesystem::absolute(file).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library) throw InputError(fmt::format("--library {}: {}", file, dlerror()));
  constexpr const char* name = "ringwatch_step_rule";
  using Rule = double (*)(int, const double*, int, int, const int*, double, double, double);
  const auto rule = reinterpret_cast<Rule>(dlsym(library, name));
  if (!rule) throw InputError(fmt::format("--library {}: has no function {}", file, name));
  return [rule](const Mesh& mesh, double young, double poisson, double density) {
    double least = infinity;
    for (const MeshBlock& block : mesh.blocks)
      least = std::min(least,
                       rule(static_cast<int>(mesh.nodeCount()), mesh.X.data(), static_cast<int>(block.elementCount()),
                            block.nodesPerElement(), block.connectivity.data(), young, poisson, density));
    return least;
  };
}

StepRuleOfOthers ruleOfMetric(const std::string& name) {
  if (!findMetric(name))
    throw InputError(fmt::format("--metric {}: must be one of {}", inQuotes(name), knownMetrics(name)));
  return [name](const Mesh& mesh, double young, double poisson, double density) {
    const Body body(mesh, makeMaterial("linear", young, poisson, density));
    constexpr double limit = 2;  // of central differences
    return stepFor(evaluateMetric(name, body, mesh.X).lambda, limit);
  };
}

struct JudgeCommand final : Command {
  using Command::Command;
  JudgeOptions options;
  JsonOption json;
  std::optional<int> shapes;
  std::vector<std::string> meshes;
  std::string command, library, metric, worst, junit, page;
  double timeout = 600;  // s

  CLI::App* declare(CLI::App& app) override {
    CLI::App* judging = app.add_subcommand("judge", "hold a step rule of yours to the exact step");
    judging->add_option("MESH", meshes, "meshes to judge it on: " + readableExtensions())->type_name("MESH");
    judging
        ->add_option("--command", command,
                     "the rule: command of a shell whose last line is the step, s; {mesh} (.msh), {mesh.vtu}, "
                     "{mesh.inp}, {young}, {poisson} and {density} are put in")
        ->type_name("COMMAND");
    judging->add_option("--timeout", timeout, "seconds that a call of the command may take (default: 600)")
        ->check(CLI::PositiveNumber);
    judging
        ->add_option("--library", library,
                     "the rule: shared library with ringwatch_step_rule(), see docs/studies/atlas.md")
        ->type_name("FILE");
    judging->add_option("--metric", metric, "the rule: a metric of ringwatch, by the limit of central differences")
        ->type_name("NAME");
    judging
        ->add_option("--shapes", shapes,
                     "shapes of each family (default: 20; 0 where meshes and no elements are given)")
        ->check(CLI::Range(0, 1000000));
    judging->add_option("--elements", options.elements, "elements whose shapes count (default: all linear ones)")
        ->delimiter(',');
    judging->add_flag("--histories", options.histories,
                      "also states of bars and a ball that are pulled, twisted and compressed; their material counts");
    judging->add_option("--young", options.young, "Young's modulus, Pa (default: 1e6)")->check(CLI::PositiveNumber);
    judging->add_option("--poisson", options.poisson, "Poisson's ratio (default: 0.3)")
        ->check(CLI::Range(-0.99, 0.4999));
    judging->add_option("--density", options.density, "density, kg/m3 (default: 1000)")->check(CLI::PositiveNumber);
    judging
        ->add_option("--worst", worst,
                     "folder for the worst unsafe case: worst.msh, worst.inp where decks have its elements, and "
                     "worst.vtu where it "
                     "has moved")
        ->type_name("DIR");
    json.declare(*judging, "numbers");
    judging->add_option("--report", page, pageHelp)->type_name("FILE");
    judging->add_option("--junit", junit, "a test case for each row in JUnit's XML, which CI systems show")
        ->type_name("FILE");
    judging->footer(
        "Exit status 1 where the rule is above the exact step somewhere.\n\n"
        "Examples:\n  ringwatch judge --metric pressure-wave:shortest-edge --elements tet4\n"
        "  ringwatch judge --command 'python3 rule.py {mesh} {young} {poisson} {density}' part.msh\n" +
        std::string(exitStatusHint));
    return judging;
  }

  /// Writes the files of a case. Returns which, and the call of inspect that finds its exact step.
  std::pair<std::string, std::string> writeWorst(const WorstCase& unsafest) const {
    makeFolderOfPictures(worst);
    const std::filesystem::path folder = worst;
    writeMesh(unsafest.mesh, folder / "worst.msh");
    std::string files = (folder / "worst.msh").string(), subject = shellWord(files);
    if (elementWithoutDeck(unsafest.mesh).empty()) {
      writeFileAtomically(folder / "worst.inp",
                          deckText(unsafest.mesh, unsafest.young, unsafest.poisson, unsafest.density, unsafest.given));
      files += ", worst.inp";
    }
    const NodeVectors displacement = unsafest.mesh.X - unsafest.rest;
    if (!displacement.isZero(0)) {
      Mesh mesh = unsafest.mesh;
      mesh.X = unsafest.rest;
      mesh.nodeSets = {{"held", unsafest.held}};
      const VtuField field{"displacement", 3,
                           std::span<const double>(displacement.data(), static_cast<std::size_t>(displacement.size()))};
      writeVtu(folder / "worst.vtu", mesh, mesh.X, std::span(&field, 1));
      files += ", worst.vtu";
      subject = shellWord((folder / "worst.vtu").string()) + " --displacement displacement";
      if (!unsafest.held.empty()) subject += " --fix set:held";
    }
    return {files, fmt::format("ringwatch inspect {} --model {} --young {} --poisson {} --density {} --global", subject,
                               unsafest.law, unsafest.young, unsafest.poisson, unsafest.density)};
  }

  ExitStatus execute() override {
    const JudgeFunction judge = judgeOfStudies();
    if (!judge) throw InputError("this program judges no rules; call ringwatch");
    if (std::ranges::count_if(std::array{&command, &library, &metric},
                              [](const auto* text) { return !text->empty(); }) != 1)
      throw InputError("the rule: must be one of --command, --library and --metric");
    const StepRuleOfOthers rule = !command.empty()   ? ruleOfCommand(command, timeout)
                                  : !library.empty() ? ruleOfLibrary(library)
                                                     : ruleOfMetric(metric);
    for (const std::string& file : meshes) options.meshes.emplace_back(file, loadMesh(file));
    options.shapesOfFamily =
        shapes.value_or(meshes.empty() || !options.elements.empty() ? JudgeOptions{}.shapesOfFamily : 0);
    const Judgement found = judge(rule, options);
    nlohmann::ordered_json numbers = studiesJson({found.report});
    std::string text = studyText(found.report) + "\n";
    numbers["conclusion"] = "the rule is nowhere above the exact step";
    if (found.worst) {
      const WorstCase& unsafest = *found.worst;
      numbers["conclusion"] = fmt::format("the rule is unsafe: {:.3g} times the exact step on {}",
                                          unsafest.given / unsafest.exact, unsafest.name);
      numbers["worst"] = {{"case", unsafest.name}, {"given", unsafest.given}, {"exact", unsafest.exact}};
      if (!worst.empty()) {
        const auto& [files, inspected] = writeWorst(unsafest);
        numbers["worst"]["inspect"] = inspected;
        text += fmt::format("wrote {}: {}\nits exact step: {}\n", files, unsafest.name, inspected);
      }
    }
    if (!junit.empty()) writeFileAtomically(junit, labelled(junitOfChecks(found.report)));
    if (!page.empty())
      text += reportText(neededReportWriters().ofStudies(
          {"Step rule", {}, {found.report}, numbers, provenanceOf(call.typed, "")}, page));
    json.write(numbers, text);
    return found.worst ? ExitStatus::unstable : ExitStatus::done;
  }
};

}  // namespace

std::unique_ptr<Command> judgeCommand(const Call& call) { return std::make_unique<JudgeCommand>(call); }

}  // namespace ringwatch

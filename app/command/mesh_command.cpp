#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include <ringwatch/app/command/command.h>
#include <ringwatch/app/output/report.h>
#include <ringwatch/app/scene/number_text.h>
#include <ringwatch/app/scene/scene_keys.h>
#include <ringwatch/app/scene/scene_mesh.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/nearest_name.h>
#include <ringwatch/base/user_text.h>
#include <ringwatch/meshes/check_texts.h>
#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/meshes/modify/repair.h>
#include <ringwatch/meshes/quality.h>

namespace ringwatch {
namespace {

struct MeshCommand final : Command {
  using Command::Command;
  std::string kind, output, input, target, checked;
  std::map<std::string, std::vector<std::string>> parameters;  // of generators, as given
  std::string join;                                            // a number, as given
  std::optional<Units> units;
  bool allProblems = false, binary = false;
  CLI::App *generate = nullptr, *convert = nullptr, *check = nullptr, *repair = nullptr;

  CLI::App* declare(CLI::App& app) override {
    CLI::App* command = app.add_subcommand("mesh", "generate, convert, check or repair a mesh");
    command->require_subcommand(1);
    command->footer(exitStatusHint);
    generate = command->add_subcommand("generate", "make a mesh");
    generate->add_option("KIND", kind, "kind of mesh")->required()->type_name("KIND");
    generate->add_option("-o,--output", output, "mesh file to write: " + writableExtensions())
        ->required()
        ->type_name("FILE");
    for (const SceneKey& key : generatorSceneKeys())
      generate->add_option("--" + key.key, parameters[key.key], key.help)->expected(1, 3)->delimiter(',');
    const auto declareBinary = [this](CLI::App& writing) {
      writing.add_flag("--binary", binary, "write .msh in binary (4.1), which ranks read in parts; without it as text");
    };
    declareBinary(*generate);
    generate->footer(
        fmt::format("Kinds: {}. Lists are written as --size 0.2 0.04 0.04 or --size 0.2,0.04,0.04.\n",
                    fmt::join(generatorNames(), ", ")) +
        "Example: ringwatch mesh generate bar --size 0.2 0.04 0.04 --cells 20 4 4 --element hex8 -o bar.msh\n" +
        "\nUnits, ranges and defaults of the parameters: ringwatch help generators");
    convert = command->add_subcommand("convert", "read a mesh and write it in another format");
    convert->add_option("IN", input, "mesh file: " + readableExtensions())->required()->type_name("MESH");
    convert->add_option("OUT", target, "mesh file to write: " + writableExtensions())->required()->type_name("FILE");
    declareBinary(*convert);
    check = command->add_subcommand("check", "list what is wrong with a mesh; exit status 1 when there is something");
    check->add_option("MESH", checked, "mesh file: " + readableExtensions())->required()->type_name("MESH");
    check->add_flag("--all", allProblems, "list every problem, not the first ten");
    repair = command->add_subcommand("repair", "mend the numbers of a mesh; exit status 1 when something is left");
    repair->add_option("IN", input, "mesh file: " + readableExtensions())->required()->type_name("MESH");
    repair->add_option("OUT", target, "mesh file to write: " + writableExtensions())->required()->type_name("FILE");
    repair
        ->add_option("--join", join,
                     "join nodes that lie closer to each other, m; 0: at one place; without it none are joined")
        ->type_name("DISTANCE");
    declareBinary(*repair);
    declareUnits(*repair, units);
    repair->footer(
        "Turns elements of the other handedness round, makes of an element that holds a node several times the\n"
        "wedge, pyramid or tetrahedron that it is, leaves out elements that stand a second time and nodes without\n"
        "elements, and puts nodes on edges into ringwatch's order. Sets are kept.");
    return command;
  }

  ExitStatus execute() override {
    if (generate->parsed()) return executeGenerate();
    if (repair->parsed()) return executeRepair();
    return convert->parsed() ? executeConvert() : executeCheck();
  }

 private:
  ExitStatus executeGenerate() const {
    if (!findGenerator(kind)) {
      const std::vector<std::string> known = generatorNames();
      throw InputError(fmt::format("KIND: unknown {}; {}known are {}", inQuotes(kind), didYouMean(kind, known),
                                   fmt::join(known, ", ")));
    }
    nlohmann::ordered_json values = nlohmann::ordered_json::object();
    for (const auto& [name, texts] : parameters) {
      if (texts.empty()) continue;
      nlohmann::ordered_json list = nlohmann::ordered_json::array();
      for (const std::string& text : texts) list.push_back(numberOrText(text));
      values[name] = texts.size() == 1 ? list[0] : list;
      const std::string fault = generatorFault(kind, name, values[name]);
      if (!fault.empty()) throw InputError(fmt::format("--{}: {}", name, fault));
    }
    const Mesh mesh = generateMesh(kind, generatorArguments(values));
    write(mesh, output);
    printOut(conclusionLine(fmt::format("{}: {} nodes, {}", output, mesh.nodeCount(), elementCounts(mesh))));
    return ExitStatus::done;
  }

  void write(const Mesh& mesh, const std::string& file) const {
    if (binary && !file.ends_with(".msh"))
      throw InputError(fmt::format("--binary: {} is not an .msh file; leave it out, or name one", file));
    writeMesh(mesh, file, binary ? MeshFormat::msh41Binary : MeshFormat::byExtension);
  }

  static nlohmann::ordered_json numberOrText(const std::string& text) {
    std::int64_t integer = 0;
    double value = 0;
    if (CLI::detail::lexical_cast(text, integer)) return integer;
    if (CLI::detail::lexical_cast(text, value) && std::isfinite(value)) return value;
    return text;
  }

  ExitStatus executeConvert() const {
    std::vector<std::string> notes;
    Mesh mesh = readMesh(input, &notes);
    // What is only numbered the other way is written right; a folded element stays what it is.
    Mesh turned = mesh;
    std::vector<std::string> turnedNotes;
    const std::vector<MeshProblem> problems = detail::turnAndCheck(turned, input, &turnedNotes);
    if (std::ranges::none_of(problems, [](const MeshProblem& p) { return p.kind == MeshProblem::Kind::inverted; })) {
      mesh = std::move(turned);
      notes.insert(notes.end(), turnedNotes.begin(), turnedNotes.end());
    }
    write(mesh, target);
    for (const std::string& note : notes) printOut("note: " + note + "\n");
    printOut(conclusionLine(fmt::format("{}: {} nodes, {}", target, mesh.nodeCount(), elementCounts(mesh))));
    return ExitStatus::done;
  }

  /// The first problems, or all of them, one a line.
  static std::string problemLines(const std::vector<MeshProblem>& problems, bool all) {
    constexpr std::size_t shownAtFirst = 10;
    const std::size_t shown = all ? problems.size() : std::min(shownAtFirst, problems.size());
    std::string text;
    for (std::size_t i = 0; i < shown; ++i)
      text += fmt::format("{}: {}\n", problemName(problems[i].kind), problems[i].text);
    if (shown < problems.size()) text += fmt::format("… and {} more; --all lists them\n", problems.size() - shown);
    return text;
  }

  static std::string kindsOf(const std::vector<MeshProblem>& problems) {
    std::map<std::string_view, std::size_t> counts;
    for (const MeshProblem& problem : problems) ++counts[problemName(problem.kind)];
    std::string kinds;
    for (const auto& [name, count] : counts) kinds += fmt::format("{}{} {}", kinds.empty() ? "" : ", ", count, name);
    return kinds;
  }

  /// What meshNotes() tells of a mesh, each note up to its first stop, behind the name.
  static std::string inShort(const std::vector<std::string>& ofMesh, const std::string& source) {
    std::string text;
    for (const std::string& note : ofMesh) {
      const std::size_t begin = source.size() + 2;
      text += (text.empty() ? "" : "; ") + note.substr(begin, note.find_first_of(";:", begin) - begin);
    }
    return text;
  }

  ExitStatus executeRepair() const {
    std::optional<double> distance;
    if (!join.empty()) {
      double value = 0;
      if (!CLI::detail::lexical_cast(join, value) || !(value >= 0) || !std::isfinite(value))
        throw InputError(fmt::format("--join: {}; a distance in m is needed, 0 or more", inQuotes(join)));
      distance = value;
    }
    std::vector<std::string> notes;
    const Mesh mesh = readMesh(input, &notes);
    const RepairedMesh repaired = repairMesh(mesh, input, distance);
    write(repaired.mesh, target);
    std::string text, left = kindsOf(repaired.problems);
    std::vector<std::string> ofMesh = meshNotes(repaired.mesh, target);
    if (const std::string told = inShort(ofMesh, target); !told.empty()) left += (left.empty() ? "" : "; ") + told;
    std::ranges::move(ofMesh, std::back_inserter(notes));
    for (const std::string& note : notes) text += "note: " + note + "\n";
    for (const std::string& line : repaired.done) text += line + "\n";
    if (repaired.done.empty()) text += fmt::format("{}: nothing more to repair\n", input);
    text += problemLines(repaired.problems, true);
    if (distance)
      text += fmt::format("{}: the volume was {:.10g} m³ and is {:.10g} m³\n", target, meshVolume(mesh),
                          meshVolume(repaired.mesh));
    text += conclusionLine(fmt::format("{}: {} nodes, {}{}", target, repaired.mesh.nodeCount(),
                                       elementCounts(repaired.mesh), left.empty() ? "" : "; left: " + left));
    if (units) useUnits(*units);
    printOut(labelled(text));
    return repaired.problems.empty() ? ExitStatus::done : ExitStatus::unstable;
  }

  ExitStatus executeCheck() const {
    std::vector<std::string> notes, ofMesh;
    const std::vector<MeshProblem> problems = checkMeshFile(checked, &notes, &ofMesh);
    std::string text;
    for (const auto* list : {&notes, &ofMesh})
      for (const std::string& note : *list) text += "note: " + note + "\n";
    text += problemLines(problems, allProblems);
    const std::string told = inShort(ofMesh, checked);
    const std::string found = problems.empty() ? (told.empty() ? "nothing wrong" : "every element is sound")
                              : problems.size() == 1
                                  ? "1 problem"
                                  : fmt::format("{} problems: {}", problems.size(), kindsOf(problems));
    text += conclusionLine(fmt::format("{}: {}{}{}", checked, found, told.empty() ? "" : "; ", told));
    printOut(text);
    return problems.empty() ? ExitStatus::done : ExitStatus::unstable;
  }
};

}  // namespace

std::unique_ptr<Command> meshCommand(const Call& call) { return std::make_unique<MeshCommand>(call); }

}  // namespace ringwatch

// One harness for all that reads what others have written: the environment variable FUZZ_TARGET names a row of the
// table. An input is read, or is refused by an error of ringwatch; whatever else happens is a finding.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <check/proof.h>
#include <ringwatch/app/command/command_line.h>
#include <ringwatch/app/command/last_number.h>
#include <ringwatch/app/command/verify.h>
#include <ringwatch/app/output/frames.h>
#include <ringwatch/app/output/history.h>
#include <ringwatch/app/report/run_history.h>
#include <ringwatch/app/report/run_report.h>
#include <ringwatch/app/run/checkpoint.h>
#include <ringwatch/app/run/saved_result.h>
#include <ringwatch/app/scene/deck_scene.h>
#include <ringwatch/app/scene/scene.h>
#include <ringwatch/app/scene/time_table.h>
#include <ringwatch/app/scene/where_expression.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/fnv.h>
#include <ringwatch/base/scratch_folder.h>
#include <ringwatch/materials/registry.h>
#include <ringwatch/meshes/formats/msh_outline.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/meshes/results.h>
#include <ringwatch/monitor/stability_monitor.h>
#include <tests/check/seal.h>

namespace ringwatch {

std::span<const StudyInfo> allStudies() { return {}; }
JudgeFunction judgeOfStudies() { return nullptr; }

namespace {

using Path = std::filesystem::path;

void write(const Path& file, std::string_view bytes) { std::ofstream(file, std::ios::binary) << bytes; }
/// What ringwatch may say of any input.
template <class Read>
void orRefused(const Read& read) {
  try {
    read();
  } catch (const InputError&) {
  } catch (const NumericalError&) {
  }
}

void readMesh(const Path& file, const std::string& bytes) {
  write(file, bytes);
  loadMesh(file);
}
void readResults(const Path& file, const std::string& bytes) {
  write(file, bytes);
  const ResultSeries series({file}, "", nullptr);
  for (std::size_t i = 0; i < series.entries().size(); ++i) series.positions(i);
}
void readModel(const Path& file, const std::string& bytes) {
  write(file, bytes);
  for (const DeckUse use : {DeckUse::run, DeckUse::model})
    orRefused([&] {
      std::vector<std::string> notes;
      const Scene scene = sceneOfModel(file, use);
      sceneBody(scene, sceneMesh(scene, notes), 1);
    });
}

/// Changes of a text: a place, a number of bytes and these; none cuts the text there.
std::string changed(std::string text, std::string_view changes) {
  constexpr std::size_t head = 3, longest = 8;
  while (changes.size() >= head && !text.empty()) {
    const auto byte = [&](std::size_t i) { return std::size_t{static_cast<unsigned char>(changes[i])}; };
    const std::size_t place = (byte(0) + 256 * byte(1)) % text.size(),
                      count = std::min({byte(2) % (longest + 1), changes.size() - head, text.size() - place});
    if (count == 0) text.resize(place);
    text.replace(place, count, changes.substr(head, count));
    changes.remove_prefix(head + count);
  }
  return text;
}
/// A monitor goes on from the bytes of another one with changes; the first byte chooses its options. What is cut has a
/// checksum of its own; what is changed has that of the whole, as damage leaves it: nothing is promised of forgeries.
void loadMonitor(const Path&, const std::string& bytes) {
  struct Saved {
    MonitorOptions options;
    std::string bytes;
  };
  static constexpr double h = 1e-4;  // s
  static const Body body(generateBar({}), makeMaterial("stvk", 30e3, 0.3, 1000));
  static const NodeVectors X = body.mesh().X, v = NodeVectors::Zero(3, body.nodeCount());
  static const std::vector<Saved> all = [] {
    std::vector<Saved> made;
    for (const MonitorOptions& options : {MonitorOptions{}, MonitorOptions{.mode = MonitorMode::threshold},
                                          MonitorOptions{.mode = MonitorMode::metric, .metric = "reduced-1-ring"}}) {
      StabilityMonitor monitor(body, options);
      monitor.observe(0, 0, X, v, h);
      made.push_back({options, monitor.save()});
    }
    return made;
  }();
  if (bytes.empty()) return;
  const Saved& saved = all[static_cast<unsigned char>(bytes[0]) % all.size()];
  StabilityMonitor monitor(body, saved.options);
  const std::string whole(*unsealed(saved.bytes)), made = changed(whole, std::string_view(bytes).substr(1));
  monitor.load(whole.starts_with(made) ? sealed(made) : made + saved.bytes.substr(whole.size()));
  monitor.observe(1, h, X, v, h);
}

bool isDigit(char c) { return c >= '0' && c <= '9'; }
/// A word each line. Nothing is touched outside the folder, and no mesh is large: numbers have one digit.
void runCommand(const Path& folder, const std::string& bytes) {
  if (bytes.find('/') != bytes.npos || bytes.find("..") != bytes.npos) return;
  const Path before = std::filesystem::current_path();
  std::filesystem::create_directory(folder);
  std::filesystem::current_path(folder);
  write("bar.msh",
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n"
        "$Elements\n1\n1 4 0 1 2 3 4\n$EndElements\n");
  std::vector<std::string> words{"ringwatch"};
  std::string shortened;
  for (const char c : bytes)
    if (!isDigit(c) || shortened.empty() || !isDigit(shortened.back())) shortened += c;
  std::istringstream lines(shortened);
  for (std::string word; std::getline(lines, word);) words.push_back(word.c_str());
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  runCommandLine(static_cast<int>(words.size()), arguments.data());
  std::filesystem::current_path(before);
  std::filesystem::remove_all(folder);
}

constexpr std::string_view smallScene = R"([mesh]
generate = "bar"
[material]
model = "stvk"
young = 30e3
poisson = 0.3
density = 1000
[integrator]
end = 1
)";

struct Target {
  std::string_view name;
  const char* file;  // what the input is called; its ending says the format
  void (*read)(const Path& file, const std::string& bytes);
};
constexpr Target targets[] = {
    {"msh", "input.msh", readMesh},
    {"vtu", "input.vtu", readMesh},
    {"vtk", "input.vtk", readMesh},
    {"frd", "input.frd", readMesh},
    {"inp", "input.inp", readMesh},
    {"k", "input.k", readMesh},
    {"unv", "input.unv", readMesh},
    {"repair", "input.msh",
     [](const Path& file, const std::string& bytes) {
       write(file, bytes);
       orRefused([&] {
         std::vector<std::string> notes, ofMesh;
         checkMeshFile(file, &notes, &ofMesh);
       });
       loadMesh(file, nullptr, true);
     }},
    {"msh-outline", "input.msh", [](const Path& file, const std::string& bytes) { detail::outlineMsh(file, bytes); }},
    {"tetgen", "input.node",  // two files, the elements behind the first '#', which begins a comment
     [](const Path& file, const std::string& bytes) {
       const std::size_t nodes = std::min(bytes.find('#'), bytes.size());
       write(Path(file).replace_extension(".ele"), std::string_view(bytes).substr(nodes));
       readMesh(file, bytes.substr(0, nodes));
     }},
    {"vtu-results", "input.vtu", readResults},
    {"vtk-results", "input.vtk", readResults},
    {"frd-results", "input.frd", readResults},
    {"pvd", "input.pvd", readResults},
    {"vtu-state", "input.vtu",
     [](const Path& file, const std::string& bytes) {
       write(file, bytes);
       loadVtuState(file, "displacement");
     }},
    {"frames", "run.pvd",
     [](const Path& file, const std::string& bytes) {
       write(file, bytes);
       framesOfRun(file.parent_path());
     }},
    {"abaqus", "input.inp", readModel},
    {"ls-dyna", "input.k", readModel},
    {"mjcf", "input.xml", readModel},
    {"scene", "input.toml",
     [](const Path& file, const std::string& bytes) {
       write(file, bytes);
       readScene(file);
     }},
    {"set", "input.toml",  // an assignment of --set each line
     [](const Path& file, const std::string& bytes) {
       static const bool written = (write(file, smallScene), true);
       static_cast<void>(written);
       std::vector<std::string> assignments;
       std::istringstream lines(bytes);
       for (std::string line; std::getline(lines, line);) assignments.push_back(line);
       readScene(file, assignments);
     }},
    {"where", "",
     [](const Path&, const std::string& text) {
       WhereExpression(text).holdsAt({0.1, 0.2, 0.3});
     }},
    {"time", "", [](const Path&, const std::string& text) { TimeTable(TimeExpression(text), 1).mean(0.2, 0.1); }},
    {"checkpoint", checkpointFile,
     [](const Path& file, const std::string& bytes) {
       write(file, sealed(bytes));
       const Checkpoint checkpoint = readCheckpoint(file.parent_path());
       const Scene scene = sceneOf(checkpoint);
       RunResult result;
       try {
         resumeResult(checkpoint.parts.at("result"), scene, static_cast<std::size_t>(checkpoint.state.x.cols()),
                      result);
       } catch (const nlohmann::json::exception&) {  // RunCheckpoints::resume takes it
       }
     }},
    {"monitor", "", loadMonitor},
    {"certificate", "",
     [](const Path&, const std::string& bytes) {
       constexpr std::size_t checksum = 8;
       if (bytes.size() >= checksum) check::verify(test::sealed(bytes));
     }},
    {"rows", "history.csv",  // as a run that goes on reads them
     [](const Path& file, const std::string& bytes) {
       write(file, bytes);
       readHistory(file.parent_path());
     }},
    {"last-number", "", [](const Path&, const std::string& text) { lastNumber(text); }},
    {"history", "history.csv",
     [](const Path& file, const std::string& bytes) {
       write(file, bytes);
       readRunHistory(file.parent_path());
     }},
    {"summary", "summary.json",
     [](const Path& file, const std::string& bytes) {
       write(file, bytes);
       orRefused([&] { sceneOfRun(file.parent_path()); });
       writeRunReport({.folder = file.parent_path(), .output = {}});
     }},
    {"command", "command", runCommand},
};

const Target& chosenTarget() {
  const char* const name = std::getenv("FUZZ_TARGET");
  for (const Target& target : targets)
    if (name && target.name == name) return target;
  for (const Target& target : targets) std::printf("%s\n", target.name.data());
  std::fflush(stdout);
  std::_Exit(2);
}

}  // namespace
}  // namespace ringwatch

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const ringwatch::Target& target = ringwatch::chosenTarget();
  static const ringwatch::ScratchFolder folder;
  ringwatch::orRefused(
      [&] { target.read(folder.path() / target.file, std::string(reinterpret_cast<const char*>(data), size)); });
  return 0;
}

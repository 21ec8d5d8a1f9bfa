#include <ringwatch/app/command/init.h>

#include <sstream>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <ringwatch/app/command/examples.h>
#include <ringwatch/app/scene/number_text.h>
#include <ringwatch/app/scene/scene.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/number_format.h>
#include <ringwatch/base/user_text.h>
#include <ringwatch/materials/registry.h>
#include <ringwatch/meshes/mesh_io.h>

namespace ringwatch {
namespace {

/// The body of a scene without a mesh of its own: a bar of rubber.
constexpr double barLength = 0.2;  // m
constexpr const char* barMesh =
    "generate = \"bar\"          # ringwatch help generators; for a mesh of yours: file = \"NAME.msh\"\n"
    "size = [0.2, 0.04, 0.04]  # m\n"
    "cells = [10, 2, 2]\n";
constexpr double rubber[] = {1e6, 0.45, 1100};  // Pa, -, kg/m3
/// How often pressure waves cross the body in a run that no end is given for, and how many frames it leaves.
constexpr double crossings = 10, frames = 40;
/// The share of the body's length whose nodes are held.
constexpr double heldShare = 1e-3;
constexpr double gravity = 9.81;  // m/s2

/// The numbers of an answer; empty of an empty one.
std::vector<double> numbersOf(const std::string& answer, std::size_t count, const std::string& question) {
  std::vector<double> numbers;
  std::istringstream words(answer);
  for (std::string word; words >> word;) numbers.push_back(parsePositiveNumber(word, question));
  if (!numbers.empty() && numbers.size() != count)
    throw InputError(fmt::format("{}: {}; {} numbers are needed", question, inQuotes(answer), count));
  return numbers;
}

}  // namespace

std::string initScene(InitOptions options, const Ask& ask) {
  requireNewScene(options.scene);
  const std::filesystem::path folder = options.scene.parent_path();
  if (!options.mesh) options.mesh = ask ? ask("Mesh file (Enter: a bar)") : "";
  const bool own = !options.mesh->empty();
  if (!options.young && !options.poisson && !options.density && ask) {
    const std::string question = "Young's modulus, Poisson's ratio, density";
    const auto numbers = numbersOf(ask(question + (own ? "" : " (Enter: those of rubber)")), 3, question);
    if (!numbers.empty()) options.young = numbers[0], options.poisson = numbers[1], options.density = numbers[2];
  }
  for (const auto& [value, name] :
       {std::pair{&options.young, "young"}, {&options.poisson, "poisson"}, {&options.density, "density"}})
    if (own && !*value) throw InputError(fmt::format("--{} is required with a mesh", name));
  const double young = options.young.value_or(rubber[0]), poisson = options.poisson.value_or(rubber[1]),
               density = options.density.value_or(rubber[2]);

  if (options.units && !own) throw InputError("--units: goes with --mesh; the bar is in SI");
  useUnits(options.units.value_or(Units::si));
  const UnitSizes unit = sizesOf(usedUnits());
  double least = 0, length = barLength;
  std::string mesh = barMesh;
  if (own) {
    const NodeVectors X = loadMesh(*options.mesh).X;
    least = X.row(0).minCoeff();
    length = (X.rowwise().maxCoeff() - X.rowwise().minCoeff()).maxCoeff();
    mesh = fmt::format("file = \"{}\"  # seen from this scene\n",
                       std::filesystem::proximate(*options.mesh, folder.empty() ? "." : folder).generic_string());
  }
  const double crossing = length / makeMaterial("neo-hookean", young, poisson, density).waveSpeed();
  if (!options.fix) options.fix = ask ? ask("Nodes that are held, a condition (Enter: those of least x)") : "";
  if (options.fix->empty()) options.fix = fmt::format("x < {:.6g}", least + heldShare * length);
  if (!options.end && ask) {
    const std::string question = labelled("Time that the run takes (s)");
    const auto numbers = numbersOf(ask(fmt::format("{} (Enter: {:.2g})", question, crossings * crossing)), 1, question);
    if (!numbers.empty()) options.end = numbers[0];
  }
  const double end = options.end.value_or(*readNumber(fmt::format("{:.2g}", crossings * crossing)));

  writeScene(options.scene,
             fmt::format(R"(# Run it: ringwatch run {0} --report
# ringwatch help scene SECTION explains the keys of a section.

{8}[mesh]
{1}
[material]
model = "neo-hookean"      # ringwatch help laws
young = {2}
poisson = {3}
density = {4}

[integrator]
method = "symplectic-euler"
step = "auto"              # follows the largest step that is proven stable
end = {5}

[[fix]]
where = "{6}"

[[force]]                  # its weight
where = "all"
acceleration = [0, 0, {9:.6g}]

[output]
every = {7:.3g}            # a frame for ParaView and the report
fields = ["critical_step", "von_mises"]
)",
                         options.scene.string(), mesh, young, poisson, density, end, *options.fix, end / frames,
                         own ? fmt::format("[units]\nsystem = \"{}\"\n\n", unitSystems.nameOf(usedUnits())) : "",
                         -gravity * unit.time * unit.time / unit.length));
  try {
    std::vector<std::string> notes;
    const Scene scene = readScene(options.scene);
    sceneBody(scene, sceneMesh(scene, notes), 1);
  } catch (...) {
    std::filesystem::remove(options.scene);
    throw;
  }
  writeSceneSchema(folder);
  return fmt::format("wrote {0}; next: ringwatch run {0} --report\n", options.scene.string());
}

}  // namespace ringwatch

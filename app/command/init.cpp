#include <ringwatch/app/command/init.h>

#include <algorithm>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <ringwatch/app/command/examples.h>
#include <ringwatch/app/scene/number_text.h>
#include <ringwatch/app/scene/scene.h>
#include <ringwatch/app/scene/scene_materials.h>
#include <ringwatch/app/scene/where_expression.h>
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

constexpr const char* model = "neo-hookean";

/// The three numbers of an answer, between blanks or commas.
std::vector<double> materialNumbers(std::string answer) {
  const std::string wanted = "three numbers are needed, such as 1e6 0.45 1100";
  std::ranges::replace(answer, ',', ' ');
  std::istringstream words(answer);
  std::vector<double> numbers;
  for (std::string word; words >> word;) {
    const std::optional<double> number = readNumber(word);
    if (!number) throw InputError(fmt::format("{} is no number; {}", inQuotes(word), wanted));
    numbers.push_back(*number);
  }
  if (numbers.size() != std::size(rubber)) throw InputError(fmt::format("{}: {}", inQuotes(answer), wanted));
  return numbers;
}

/// Asks until `take` accepts the answer. Throws what `ask` throws.
template <class Take>
void askFor(const Ask& ask, const std::string& question, const Take& take) {
  for (std::string fault;;) {
    const std::string answer = ask(fault + question);
    try {
      return take(answer);
    } catch (const InputError& refused) {
      fault = std::string(refused.what()) + "\n";
    }
  }
}

}  // namespace

std::string initScene(InitOptions options, const Ask& ask) {
  if (options.scene.extension() != ".toml")
    throw InputError(fmt::format("{}: the name of a scene ends with .toml; with a mesh: ringwatch init --mesh {} ...",
                                 options.scene.string(), options.scene.string()));
  requireNewScene(options.scene);
  const std::filesystem::path folder = options.scene.parent_path();
  NodeVectors X;  // of the mesh; none of the bar
  const auto takeMesh = [&](const std::string& file) {
    if (!file.empty()) X = loadMesh(file).X;
    options.mesh = file;
  };
  if (options.mesh || !ask)
    takeMesh(options.mesh.value_or(""));
  else
    askFor(ask, "Mesh file (Enter: a bar of rubber)", takeMesh);
  const bool own = !options.mesh->empty();

  if (options.units && !own) throw InputError("--units: goes with --mesh; the bar is in SI");
  if (own && !options.units && ask)
    askFor(
        ask,
        fmt::format("Units of the mesh and of all that follows, {} (Enter: SI)", fmt::join(unitSystems.names(), ", ")),
        [&](const std::string& name) {
          options.units = name.empty() ? Units::si : unitSystems.valueOf("units", name);
        });
  useUnits(options.units.value_or(Units::si));
  const UnitSizes unit = sizesOf(usedUnits());

  double young = 0, poisson = 0, density = 0, waveSpeed = 0;
  const auto takeMaterial = [&](double modulus, double ratio, double rho) {
    waveSpeed = makeMaterial(model, modulus, ratio, rho).waveSpeed();
    young = modulus, poisson = ratio, density = rho;
  };
  if (options.young || options.poisson || options.density || !ask) {
    Options constants;
    if (options.young) constants.set("young", *options.young);
    if (options.poisson) constants.set("poisson", *options.poisson);
    const std::string missing = own ? missingConstants(model, constants, options.density) : "";
    if (!missing.empty()) throw InputError(missing + " with a mesh");
    takeMaterial(options.young.value_or(rubber[0]), options.poisson.value_or(rubber[1]),
                 options.density.value_or(rubber[2]));
  } else {
    askFor(ask,
           fmt::format("{}, Poisson's ratio, {}{}", labelled("Young's modulus (Pa)"), labelled("density (kg/m3)"),
                       own ? "" : " (Enter: those of rubber)"),
           [&](const std::string& answer) {
             if (answer.empty() && !own) return takeMaterial(rubber[0], rubber[1], rubber[2]);
             const auto numbers = materialNumbers(answer);
             takeMaterial(numbers[0], numbers[1], numbers[2]);
           });
  }

  double least = 0, length = barLength;
  std::string mesh = barMesh;
  if (own) {
    least = X.row(0).minCoeff();
    length = (X.rowwise().maxCoeff() - X.rowwise().minCoeff()).maxCoeff();
    mesh = fmt::format("file = \"{}\"  # seen from this scene\n",
                       std::filesystem::proximate(*options.mesh, folder.empty() ? "." : folder).generic_string());
  }
  if (!options.fix && ask)
    askFor(ask, labelled("Nodes that are held, a condition such as x < 0.1 (Enter: those of least x)"),
           [&](const std::string& answer) {
             if (!answer.empty()) options.fix = WhereExpression(answer).text();
           });
  if (!options.fix || options.fix->empty()) options.fix = fmt::format("x < {:.6g}", least + heldShare * length);

  const std::string usualEnd = fmt::format("{:.2g}", crossings * length / waveSpeed);
  if (!options.end && ask)
    askFor(ask, fmt::format("{} (Enter: {})", labelled("Time that the run takes (s)"), usualEnd),
           [&](const std::string& answer) {
             if (!answer.empty()) options.end = parsePositiveNumber(answer, "time");
           });
  const double end = options.end.value_or(*readNumber(usualEnd));

  writeScene(options.scene,
             fmt::format(R"(# Run it: ringwatch run {0} --report
# ringwatch help scene SECTION explains the keys of a section.

{8}[mesh]
{1}
[material]
model = "{10}"      # ringwatch help laws
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
                         -gravity * unit.time * unit.time / unit.length, model));
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

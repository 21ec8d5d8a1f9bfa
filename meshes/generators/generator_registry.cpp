#include <ringwatch/meshes/generators/generator_registry.h>

#include <array>
#include <cmath>
#include <vector>

#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/nearest_name.h>
#include <ringwatch/base/user_text.h>
#include <ringwatch/meshes/generators/generators.h>

namespace ringwatch {
namespace {

constexpr double mostCells = 1e6;
using K = ParameterKind;

constexpr GeneratorParameter size3{
    "size", "m", "lengths along x, y, z", K::number, 3, {0.2, 0.04, 0.04}, "", 0, infinity, false, false};
constexpr GeneratorParameter cells3{"cells", "",  "cells along x, y, z", K::integer, 3, {20, 4, 4}, "", 1, mostCells,
                                    true,    true};
constexpr GeneratorParameter mixedCells3{
    "cells", "", "cells along x (5 or more), y, z", K::integer, 3, {20, 4, 4}, "", 1, mostCells, true, true};
constexpr GeneratorParameter size1{"size", "m",  "length of an edge", K::number, 1, {0.05}, "", 0, infinity,
                                   false,  false};
constexpr GeneratorParameter cells1{"cells", "",  "cells along each edge", K::integer, 1, {5}, "", 1, mostCells,
                                    true,    true};
constexpr GeneratorParameter origin{
    "origin", "m",  "corner with the smallest coordinates", K::number, 3, {0, 0, 0}, "", -infinity, infinity,
    false,    false};
constexpr GeneratorParameter element{
    "element", "", "element that the cells are cut into", K::text, 1, {}, "tet4", 0, 0, false, false};
constexpr GeneratorParameter split{
    "split", "", "elements a cell (tet4: 6 or 5); 0 is the usual one", K::integer, 1, {0}, "", 0, 6, true, true};
constexpr GeneratorParameter jitter{
    "jitter", "cell sizes", "largest displacement of a node along each axis", K::number, 1, {0}, "", 0, 0.5,
    true,     false};
constexpr GeneratorParameter seed{"seed", "", "of the jitter",    K::integer, 1,   {1},
                                  "",     0,  9007199254740991.0, true,       true};
constexpr GeneratorParameter grading{
    "grading", "",   "last cell over first cell along x; above 1 the small ones are at x-min",
    K::number, 1,    {1},
    "",        1,    infinity,
    true,      false};
constexpr GeneratorParameter steepGrading{
    "grading", "",   "last cell over first cell along x; above 1 the small ones are at x-min",
    K::number, 1,    {4},
    "",        1,    infinity,
    true,      false};
constexpr GeneratorParameter radius{"radius", "m", "of the ball", K::number, 1, {0.05}, "", 0, infinity, false, false};
constexpr GeneratorParameter cellsAcross{
    "cells", "", "cells across the diameter", K::integer, 1, {8}, "", 1, mostCells, true, true};

constexpr GeneratorParameter barParameters[] = {size3, cells3, origin, element, split, jitter, seed, grading};
constexpr GeneratorParameter cubeParameters[] = {size1, cells1, origin, element, split, jitter, seed, grading};
constexpr GeneratorParameter gradedParameters[] = {size3, cells3, origin, element, split, jitter, seed, steepGrading};
constexpr GeneratorParameter mixedParameters[] = {size3, mixedCells3, origin, jitter, seed, grading};
constexpr GeneratorParameter ringRadius{"radius", "m", "outer radius", K::number, 1,    {0.1},
                                        "",       0,   infinity,       false,     false};
constexpr GeneratorParameter inner{"inner", "m",  "inner radius, below radius", K::number, 1, {0.06}, "", 0, infinity,
                                   false,   false};
constexpr GeneratorParameter width{"width", "m",  "along the axis, y", K::number, 1, {0.04}, "", 0, infinity,
                                   false,   false};
constexpr GeneratorParameter ringCells{
    "cells", "",  "cells around, between the radii, along the axis", K::integer, 3, {32, 3, 3}, "", 1, mostCells,
    true,    true};
constexpr GeneratorParameter teeth{
    "teeth", "",  "of a gear, four cells around or a multiple each; 0 is round", K::integer, 1, {0}, "", 0, mostCells,
    true,    true};
constexpr GeneratorParameter toothDepth{
    "tooth_depth", "m", "of the teeth, from the radius inwards", K::number, 1, {0}, "", 0, infinity, true, false};
constexpr GeneratorParameter ringParameters[] = {ringRadius, inner, width, ringCells,
                                                 element,    split, teeth, toothDepth};
constexpr GeneratorParameter ballParameters[] = {radius, cellsAcross, element, split};

constexpr GeneratorParameter upperSize{
    "upper_size", "m",  "of the upper box along x, y, z", K::number, 3, {0.04, 0.04, 0.04}, "", 0, infinity,
    false,        false};
constexpr GeneratorParameter upperCells{
    "upper_cells", "", "of the upper box along x, y, z", K::integer, 3, {4, 4, 4}, "", 1, mostCells, true, true};
constexpr GeneratorParameter gap{"gap", "m",  "between the boxes, along z", K::number, 1, {0}, "", 0, infinity,
                                 true,  false};
constexpr GeneratorParameter offset{
    "offset",  "m",       "of the upper box's middle from the lower one's along x and y",
    K::number, 2,         {0, 0},
    "",        -infinity, infinity,
    false,     false};
constexpr GeneratorParameter stackParameters[] = {size3,  cells3,  upperSize, upperCells, gap, offset,
                                                  origin, element, split,     jitter,     seed};

constexpr GeneratorParameter finest{"finest", "m",  "longest edge at the plane", K::number, 1, {0.005}, "", 0, infinity,
                                    false,    false};
constexpr GeneratorParameter plane{
    "plane", "m", "x of the plane, from the corner", K::number, 1, {0}, "", -infinity, infinity, false, false};
constexpr GeneratorParameter growth{
    "growth", "m/m", "of the longest edge with distance from the plane", K::number, 1, {0.3}, "", 0, infinity,
    true,     false};
constexpr GeneratorParameter refinedParameters[] = {size3, cells3, origin, jitter, seed, finest, plane, growth};

std::string valueText(const GeneratorValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return inQuotes(*text);
  if (const auto* number = std::get_if<double>(&value)) return joinText(*number);
  std::string list = "[";
  for (const double number : std::get<std::vector<double>>(value))
    list += joinText(list.size() > 1 ? ", " : "", number);
  return list + "]";
}

std::vector<std::string> elementChoices() {
  std::vector<std::string> names;
  for (const ElementInfo& info : allElements()) names.emplace_back(info.name);
  return names;
}

/// The checked values of a generator's parameters.
class Values {
 public:
  Values(const GeneratorInfo& info, const GeneratorArguments& arguments) : info_(info), arguments_(arguments) {
    for (const auto& [name, value] : arguments) {
      const GeneratorParameter* parameter = find(name);
      if (parameter == nullptr) {
        std::vector<std::string_view> known;
        for (const GeneratorParameter& p : info.parameters) known.push_back(p.name);
        throw InputError(joinText(info.name, ": there is no parameter ", inQuotes(name), "; ", didYouMean(name, known),
                                  "known are ", shortList(known)));
      }
      check(*parameter, value);
    }
  }
  bool has(std::string_view name) const { return find(name) != nullptr; }
  double number(std::string_view name, std::size_t k = 0) const {
    const auto given = arguments_.find(name);
    if (given == arguments_.end()) return find(name)->defaults[k];
    if (const auto* single = std::get_if<double>(&given->second)) return *single;
    return std::get<std::vector<double>>(given->second)[k];
  }
  std::string text(std::string_view name) const {
    const auto given = arguments_.find(name);
    return given == arguments_.end() ? std::string(find(name)->textDefault) : std::get<std::string>(given->second);
  }

 private:
  const GeneratorParameter* find(std::string_view name) const {
    for (const GeneratorParameter& p : info_.parameters)
      if (p.name == name) return &p;
    return nullptr;
  }
  void check(const GeneratorParameter& p, const GeneratorValue& value) const {
    const auto refuse = [&](const std::string& right) {
      throw InputError(joinText(info_.name, ": ", p.name, " = ", valueText(value), ": it must be ", right));
    };
    if (p.kind == ParameterKind::text) {
      const auto* given = std::get_if<std::string>(&value);
      const std::vector<std::string> choices = elementChoices();
      if (given == nullptr)
        refuse("a text, " + parameterRange(p));
      else if (std::find(choices.begin(), choices.end(), *given) == choices.end())
        refuse(parameterRange(p) + (nearestName(*given, choices).empty()
                                        ? ""
                                        : "; the nearest is \"" + nearestName(*given, choices) + "\""));
      return;
    }
    std::vector<double> numbers;
    if (const auto* single = std::get_if<double>(&value)) numbers = {*single};
    if (const auto* list = std::get_if<std::vector<double>>(&value)) numbers = *list;
    const std::string kind = p.kind == ParameterKind::integer ? "integer" : "number";
    if (numbers.size() != static_cast<std::size_t>(p.count))
      refuse(p.count == 1 ? "one " + kind + " " + parameterRange(p)
                          : joinText("a list of ", p.count, " ", kind, "s, each ", parameterRange(p)));
    for (const double x : numbers) {
      const bool inside = (p.minAllowed ? x >= p.min : x > p.min) && (p.maxAllowed ? x <= p.max : x < p.max);
      if (!inside) refuse(parameterRange(p));
      if (p.kind == ParameterKind::integer && x != std::floor(x)) refuse("an integer " + parameterRange(p));
    }
  }
  const GeneratorInfo& info_;
  const GeneratorArguments& arguments_;
};

BarOptions boxOptions(const Values& values) {
  BarOptions o;
  for (std::size_t k = 0; k < 3; ++k) o.origin[k] = values.number("origin", k);
  if (values.has("element")) {
    o.element = values.text("element");
    o.split = static_cast<int>(values.number("split"));
  }
  o.jitter = values.number("jitter");
  o.seed = static_cast<std::uint64_t>(values.number("seed"));
  if (values.has("grading")) o.grading = values.number("grading");
  return o;
}

/// With size and cells along each axis.
BarOptions barOptions(const Values& values) {
  BarOptions options = boxOptions(values);
  for (std::size_t k = 0; k < 3; ++k) {
    options.size[k] = values.number("size", k);
    options.cells[k] = static_cast<int>(values.number("cells", k));
  }
  return options;
}

Mesh bar(const Values& values) { return generateBar(barOptions(values)); }
Mesh cube(const Values& values) {
  return generateCube(values.number("size"), static_cast<int>(values.number("cells")), boxOptions(values));
}
Mesh refined(const Values& values) {
  return generateRefinedBar(
      {barOptions(values), values.number("finest"), values.number("plane"), values.number("growth")});
}
Mesh mixed(const Values& values) { return generateMixedBar(barOptions(values)); }
Mesh ball(const Values& values) {
  return generateBall({values.number("radius"), static_cast<int>(values.number("cells")), values.text("element"),
                       static_cast<int>(values.number("split"))});
}

Mesh stack(const Values& values) {
  StackOptions options;
  options.lower = barOptions(values);
  for (std::size_t k = 0; k < 3; ++k) {
    options.upperSize[k] = values.number("upper_size", k);
    options.upperCells[k] = static_cast<int>(values.number("upper_cells", k));
  }
  options.gap = values.number("gap");
  for (std::size_t k = 0; k < 2; ++k) options.offset[k] = values.number("offset", k);
  return generateStack(options);
}

Mesh ring(const Values& values) {
  RingOptions options{values.number("radius"),
                      values.number("inner"),
                      values.number("width"),
                      {},
                      values.text("element"),
                      static_cast<int>(values.number("split")),
                      static_cast<int>(values.number("teeth")),
                      values.number("tooth_depth")};
  for (std::size_t k = 0; k < 3; ++k) options.cells[k] = static_cast<int>(values.number("cells", k));
  return generateRing(options);
}

struct Generator {
  GeneratorInfo info;
  Mesh (*generate)(const Values& values);
};
/// Every generator, one line each.
constexpr Generator generators[] = {
    {{"bar", "a box of cells", barParameters}, bar},
    {{"cube", "a box with equal edges", cubeParameters}, cube},
    {{"graded", "a box with small elements toward its face x-min", gradedParameters}, bar},
    {{"refined", "a box of tetrahedra bisected until they are small at a plane across x", refinedParameters}, refined},
    {{"mixed", "a bar of wedges, hexahedra, pyramids and tetrahedra that share faces", mixedParameters}, mixed},
    {{"ball", "a ball, a cube of cells mapped onto it", ballParameters}, ball},
    {{"stack", "two boxes, one above the other, that share no node", stackParameters}, stack},
    {{"ring", "a hollow cylinder around y, or a gear", ringParameters}, ring},
};

}  // namespace

std::span<const GeneratorInfo> allGenerators() {
  static const auto infos = [] {
    std::vector<GeneratorInfo> all;
    for (const Generator& generator : generators) all.push_back(generator.info);
    return all;
  }();
  return infos;
}

const GeneratorInfo* findGenerator(std::string_view name) {
  for (const GeneratorInfo& info : allGenerators())
    if (info.name == name) return &info;
  return nullptr;
}

std::vector<std::string> parameterChoices(const GeneratorParameter& p) {
  return p.kind == ParameterKind::text ? elementChoices() : std::vector<std::string>{};
}

std::string parameterRange(const GeneratorParameter& p) {
  if (p.kind == ParameterKind::text) {
    std::string list = "one of ";
    for (const std::string& name : elementChoices()) list += (list.size() > 7 ? ", " : "") + name;
    return list;
  }
  std::string text;
  if (p.min > -infinity) text = p.minAllowed ? joinText(p.min, " or more") : joinText("above ", p.min);
  if (p.max < infinity) text += joinText(text.empty() ? "" : " and ", p.maxAllowed ? "at most " : "below ", p.max);
  return text.empty() ? "finite" : text;
}

Mesh generateMesh(std::string_view kind, const GeneratorArguments& arguments) {
  const GeneratorInfo* info = findGenerator(kind);
  if (info == nullptr) {
    std::vector<std::string_view> known;
    for (const GeneratorInfo& g : allGenerators()) known.push_back(g.name);
    throw InputError(joinText("generate = ", inQuotes(kind), ": there is no such mesh; ", didYouMean(kind, known),
                              "known are ", shortList(known)));
  }
  const Values values(*info, arguments);
  try {
    return generators[info - allGenerators().data()].generate(values);
  } catch (const InputError& error) {
    throw InputError(joinText(info->name, ": ", error.what()));
  }
}

}  // namespace ringwatch

#pragma once
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

enum class ParameterKind { number, integer, text };

/// A parameter of a generator: what scene files, the command line, help and error messages know of it.
struct GeneratorParameter {
  std::string_view name;
  std::string_view unit;  // "" for a plain number
  std::string_view help;
  ParameterKind kind;
  int count;                     // values: 1, or 3 for x, y, z
  double defaults[3];            // of numbers
  std::string_view textDefault;  // of text
  double min, max;               // range of each number
  bool minAllowed, maxAllowed;   // whether the ends belong to the range
};

struct GeneratorInfo {
  std::string_view name;
  std::string_view help;
  std::span<const GeneratorParameter> parameters;
};

/// Every kind of generated mesh, as `ringwatch help scene` lists them.
std::span<const GeneratorInfo> allGenerators();
/// nullptr when there is none of that name.
const GeneratorInfo* findGenerator(std::string_view name);

using GeneratorValue = std::variant<double, std::vector<double>, std::string>;
/// Parameter name to value, as scene files and command lines give them.
using GeneratorArguments = std::map<std::string, GeneratorValue, std::less<>>;

/// Range of a parameter in words: "above 0", "0 or more and below 0.5", "one of tet4, hex8".
std::string parameterRange(const GeneratorParameter& parameter);
/// What a parameter that is a text may be; empty for numbers.
std::vector<std::string> parameterChoices(const GeneratorParameter& parameter);

/// Checks the arguments against the table and generates the mesh; what is not given takes its default. Throws
/// InputError naming the parameter, its value and its range; an unknown kind or name is answered with the nearest known
/// one.
Mesh generateMesh(std::string_view kind, const GeneratorArguments& arguments);

}  // namespace ringwatch

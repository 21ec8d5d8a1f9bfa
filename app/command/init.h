#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include <ringwatch/base/units.h>

namespace ringwatch {

/// What a new scene is made of. What is empty is asked for, or gets the value that the question names.
struct InitOptions {
  std::filesystem::path scene = "scene.toml";
  std::optional<std::string> mesh, fix;
  std::optional<double> young, poisson, density, end;
  std::optional<Units> units;  // goes with a mesh
};

/// Asks a question and returns the line that is typed; empty where no one can be asked.
using Ask = std::function<std::string(const std::string& question)>;

/// Writes a commented scene that runs; returns what was written and what to do next. Throws InputError where an answer
/// is none, a mesh comes without its material, or the scene is there already.
std::string initScene(InitOptions options, const Ask& ask);

}  // namespace ringwatch

#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace ringwatch {

/// A scene of examples/, as CMake puts it into the program.
struct ExampleFile {
  std::string_view name;  // "stretch_bar.toml"
  std::string_view text;
};
/// In the order of their names.
std::span<const ExampleFile> exampleFiles();

/// Every example with the first sentence about it, a line each.
std::string exampleListing();
/// Writes an example, by its name without .toml, or all of them into a folder; returns what was written. Throws
/// InputError for an unknown name and for a file that is there already.
std::string copyExamples(const std::string& name, const std::filesystem::path& folder);

/// Writes a new scene behind a line that names its schema for editors, and the schema beside it. Throws InputError
/// where the scene is there already.
void writeNewScene(const std::filesystem::path& file, std::string_view text);

}  // namespace ringwatch

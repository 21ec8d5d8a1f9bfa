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
/// Writes an example, by its name without .toml, or all of them into a folder, with the schema of scenes; returns what
/// was written. Throws InputError for an unknown name and, before anything is written, for a file that is there
/// already.
std::string copyExamples(const std::string& name, const std::filesystem::path& folder);

/// Throws InputError where there is such a file.
void requireNewScene(const std::filesystem::path& file);
/// Writes a scene behind a line that names its schema for editors, as writeSceneSchema() puts it beside it.
void writeScene(const std::filesystem::path& file, std::string_view text);
/// Writes the schema of scenes into a folder.
void writeSceneSchema(const std::filesystem::path& folder);

}  // namespace ringwatch

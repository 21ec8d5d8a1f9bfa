#include <ringwatch/app/command/examples.h>

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include <ringwatch/app/command/schema.h>
#include <ringwatch/base/atomic_file.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/nearest_name.h>
#include <ringwatch/base/user_text.h>

namespace ringwatch {
namespace {

constexpr std::string_view schemaMark = "#:schema ", schemaFile = "scene.schema.json";

std::string_view stemOf(const ExampleFile& example) { return example.name.substr(0, example.name.rfind('.')); }

/// Without the line that names the schema by its place in a clone.
std::string_view withoutSchema(std::string_view text) {
  return text.starts_with(schemaMark) ? text.substr(text.find('\n') + 1) : text;
}

}  // namespace

std::string exampleListing() {
  std::string text;
  for (const ExampleFile& example : exampleFiles()) {
    std::string_view first = withoutSchema(example.text).substr(2);  // behind "# "
    first = first.substr(0, first.find('\n'));
    const std::size_t end = std::min(first.find(". "), first.find_last_not_of('.') + 1);
    text += fmt::format("  {:<18} {}\n", stemOf(example), first.substr(0, end));
  }
  return text;
}

void requireNewScene(const std::filesystem::path& file) {
  if (std::filesystem::exists(file))
    throw InputError(fmt::format("{} is there already; choose another name or folder", file.string()));
}

void writeScene(const std::filesystem::path& file, std::string_view text) {
  writeFileAtomically(file, fmt::format("{}./{}\n{}", schemaMark, schemaFile, text));
}

void writeSceneSchema(const std::filesystem::path& folder) {
  writeFileAtomically(folder / schemaFile, schemaOf("scene").dump(2) + "\n");
}

std::string copyExamples(const std::string& name, const std::filesystem::path& folder) {
  std::vector<std::string> known{"all"};
  std::vector<const ExampleFile*> wanted;
  for (const ExampleFile& example : exampleFiles()) {
    known.emplace_back(stemOf(example));
    if (name == "all" || name == stemOf(example)) wanted.push_back(&example);
  }
  if (wanted.empty())
    throw InputError(fmt::format("examples: unknown {}; {}known are {}", inQuotes(name), didYouMean(name, known),
                                 fmt::join(known, ", ")));
  for (const ExampleFile* example : wanted) requireNewScene(folder / example->name);
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw InputError(fmt::format("--out: cannot write {}: {}", folder.string(), error.message()));
  std::string text;
  for (const ExampleFile* example : wanted) {
    writeScene(folder / example->name, withoutSchema(example->text));
    text += fmt::format("wrote {}\n", (folder / example->name).string());
  }
  writeSceneSchema(folder);
  return text;
}

}  // namespace ringwatch

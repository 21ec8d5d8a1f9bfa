#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the name of CLI11
class App;
}

namespace ringwatch {

/// What an argument of the command line stands for, by the name that help texts show it with: its values, for
/// completion. Arguments of other names are numbers or texts.
struct ArgumentKind {
  std::string_view name;                 // "FILE", "INTEGRATOR", …
  std::vector<std::string> (*values)();  // nullptr for files
};
std::span<const ArgumentKind> argumentKinds();

/// A generated file, its path relative to the folder that stands for share/ of an installation.
struct ReferenceFile {
  std::filesystem::path path;
  std::string text;
};

/// Everything about the program that is made from its own tables and the declared command line: pages of the reference
/// (Markdown, doc/ringwatch/reference/), schemas beside them, a manual page and completion for bash and zsh.
std::vector<ReferenceFile> referenceFiles(const CLI::App& app);

}  // namespace ringwatch

#include <ringwatch/meshes/mesh_io.h>

#include <algorithm>
#include <vector>

#include <ringwatch/base/registry.h>
#include <ringwatch/meshes/check_texts.h>
#include <ringwatch/meshes/formats/deck_lines.h>
#include <ringwatch/meshes/formats/file_cursor.h>
#include <ringwatch/meshes/formats/mesh_readers.h>
#include <ringwatch/meshes/modify/repair.h>
#include <ringwatch/meshes/part_of_mesh.h>

namespace ringwatch {
namespace {

namespace fs = std::filesystem;

bool startsWithXml(std::string_view text) {
  const std::size_t at = text.find_first_not_of(" \t\r\n");
  return at != std::string_view::npos && text[at] == '<';
}

bool startsWithVtkXml(std::string_view text) { return detail::behindProlog(text).starts_with("<VTKFile"); }
bool startsWithMsh(std::string_view text) { return text.starts_with("$MeshFormat") || text.starts_with("$Comments"); }
bool startsWithLegacyVtk(std::string_view text) { return text.starts_with("# vtk DataFile"); }

fs::path withSuffix(fs::path stem, const char* suffix) {
  stem += suffix;
  return stem;
}

/// Whether a path names TetGen's files: either one, or the stem of both.
bool isTetgen(const fs::path& path) {
  const std::string extension = path.extension().string();
  std::error_code ignored;
  return extension == ".node" || extension == ".ele" ||
         (!fs::exists(path, ignored) && fs::exists(withSuffix(path, ".node"), ignored));
}

Mesh readTetgenPath(const fs::path& path, detail::Notes* notes, detail::Problems* problems) {
  const std::string extension = path.extension().string();
  fs::path stem = path;
  if (extension == ".node" || extension == ".ele") stem.replace_extension();
  return detail::readTetgen(withSuffix(stem, ".node"), withSuffix(stem, ".ele"), notes, problems);
}

/// Every mesh format, one entry each.
constexpr MeshFormatEntry formatsOfLibrary[] = {
    {{".msh", "gmsh MSH", "versions 2 and 4, text and binary; written as 4.1 text", true},
     detail::readMsh,
     startsWithMsh,
     "",
     [](const Mesh& mesh, const fs::path& path) { detail::writeMsh(mesh, path, true, false); }},
    {.info = {".node/.ele", "TetGen", "both files, named by either one or by their common stem", false},
     .ownsPath = isTetgen,
     .readPath = readTetgenPath},
    {{".vtu", "VTK XML unstructured grid", "text, binary and compressed", true},
     detail::readVtu,
     startsWithVtkXml,
     "<VTKFile",
     detail::writeVtuWithSets},
    {{".vtk", "legacy VTK unstructured grid", "text and binary", false},
     detail::readLegacyVtk,
     startsWithLegacyVtk,
     "# vtk DataFile"},
    {{".frd", "CalculiX results", "text; ringwatch audit reads its states as well", false},
     detail::readFrd,
     [](std::string_view text) { return text.starts_with("    1C") || text.starts_with("    2C"); }},
    {{".k/.key/.dyn", "LS-DYNA deck", "nodes, solid elements, parts and sets; a note names what is skipped", false},
     detail::readDyna,
     detail::startsWithDyna},
    {{".inp", "Abaqus or CalculiX deck", "nodes, elements and their sets; a note names what is skipped", false},
     detail::readInp,
     detail::startsWithDeck},
    {{".unv", "universal file (UNV)", "of I-DEAS, Salome and gmsh: nodes, solid elements and groups", false},
     detail::readUniversal,
     detail::startsWithUniversal,
     "-1, the mark of its first dataset"},
    {.info = {".exo/.med/.xdmf/.mesh/.bdf", "what meshio reads",
              "Exodus, MED, XDMF, Medit, Nastran, Netgen and SU2 by python3-meshio, with their groups",
              false}},  // `read` below finds the one of them
};

Registry<MeshFormatEntry>& registry() {
  static Registry<MeshFormatEntry> formats("mesh format", formatsOfLibrary);
  return formats;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 < names.size() ? ", " : " or ") + names[i];
  return text;
}

Mesh read(const fs::path& path, detail::Notes* notes, detail::Problems* problems) {
  const std::string extension = path.extension().string();
  const auto entries = registry().all();
  for (const MeshFormatEntry& format : entries)
    if (format.ownsPath != nullptr && format.ownsPath(path)) return format.readPath(path, notes, problems);
  const std::string text = detail::readWholeFile(path);
  const MeshFormatEntry* named = registry().find(extension);
  const auto isRegistered = [&](const MeshFormatEntry& format) {
    return &format == named || (format.isBegin != nullptr && format.isBegin(text));
  };
  if (std::ranges::none_of(entries.subspan(std::size(formatsOfLibrary)), isRegistered))
    if (const detail::ForeignFormat* foreign = detail::foreignByContent(text); foreign != nullptr)
      return detail::readForeign(*foreign, path, notes, problems);
  // The content decides; the extension only helps where the content says nothing.
  for (const MeshFormatEntry& format : entries)
    if (format.isBegin != nullptr && format.isBegin(text)) return format.read(path, text, notes, problems);
  if (named != nullptr && named->mustBegin.empty()) return named->read(path, text, notes, problems);
  if (const detail::ForeignFormat* foreign = named == nullptr ? detail::foreignByExtension(path) : nullptr)
    return detail::readForeign(*foreign, path, notes, problems);
  const std::string begin = detail::quoted(std::string_view(text).substr(0, text.find_first_of("\r\n")));
  if (named != nullptr)
    throw InputError(
        joinText(path.string(), ":1: begins with ", begin, "; a ", extension, " file begins with ", named->mustBegin));
  std::vector<std::string> known;
  for (const MeshFormatEntry& format : entries)
    known.push_back(joinText(format.info.name, " (", format.info.extensions, ")"));
  throw InputError(
      joinText(path.string(), ":1: not a known mesh format, it begins with ", begin, "; known are ", joined(known)));
}

}  // namespace

std::span<const MeshFormatInfo> allMeshFormats() { return registry().infos(); }
void registerMeshFormat(const MeshFormatEntry& entry) { registry().add(entry); }

std::string readableExtensions() {
  std::vector<std::string> names;
  for (const MeshFormatInfo& format : allMeshFormats()) names.emplace_back(format.extensions);
  return joined(names);
}

std::string writableExtensions() {
  std::vector<std::string> names;
  for (const MeshFormatInfo& format : allMeshFormats())
    if (format.writes) names.emplace_back(format.extensions);
  return joined(names);
}

Mesh readMesh(const fs::path& path, std::vector<std::string>* notes) { return read(path, notes, nullptr); }

Mesh loadMesh(const fs::path& path, std::vector<std::string>* notes, bool repair) {
  Mesh mesh = readMesh(path, notes);
  if (repair) {
    RepairedMesh repaired = repairMesh(std::move(mesh), path.string());
    if (notes != nullptr) notes->insert(notes->end(), repaired.done.begin(), repaired.done.end());
    mesh = std::move(repaired.mesh);
  }
  requireSound(mesh, path.string(), notes);
  return mesh;
}

MeshState readVtuState(const fs::path& path, const std::string& displacement, std::vector<std::string>* notes) {
  const std::string text = detail::readWholeFile(path);
  detail::refuseForeignStates(path, text);
  if (text.starts_with("# vtk DataFile")) {
    detail::ResultFrame frame = detail::readLegacyVtkResult(path, text, {displacement}, notes);
    if (!frame.u) throw InputError(path.string() + ": " + detail::noField(displacement, frame.vectors));
    if (!frame.u->allFinite() || !frame.mesh.X.allFinite())
      throw InputError(joinText(path.string(), ": the points or ", detail::quoted(displacement), " are not finite"));
    NodeVectors x = frame.mesh.X + *frame.u;
    return {detail::standingMesh(std::move(frame), path.string(), notes), std::move(x)};
  }
  if (!startsWithXml(text))
    throw InputError(path.string() + ": displacements are read from .vtu and .vtk files; this is another format");
  return detail::readVtuState(path, text, displacement, notes);
}

MeshState loadVtuState(const fs::path& path, const std::string& displacement, std::vector<std::string>* notes) {
  MeshState state = readVtuState(path, displacement, notes);
  const std::vector<bool> used = usedNodes(state.mesh);
  requireSound(state.mesh, path.string(), notes);
  std::vector<Eigen::Index> kept;  // nodes of no element are dropped
  for (std::size_t n = 0; n < used.size(); ++n)
    if (used[n]) kept.push_back(static_cast<Eigen::Index>(n));
  state.x = NodeVectors(state.x(Eigen::all, kept));
  return state;
}

std::vector<MeshProblem> checkMeshFile(const fs::path& path, std::vector<std::string>* notes,
                                       std::vector<std::string>* ofMesh) {
  std::vector<MeshProblem> problems;
  Mesh mesh = read(path, notes, &problems);
  for (MeshProblem& problem : detail::turnAndCheck(mesh, path.string(), notes)) {
    // The reader has listed these already, with their line.
    if (problem.kind == MeshProblem::Kind::missingNode || problem.kind == MeshProblem::Kind::nonFinite) continue;
    problem.text = path.string() + ": " + problem.text;
    problems.push_back(std::move(problem));
  }
  const bool complete = std::none_of(problems.begin(), problems.end(), [](const MeshProblem& problem) {
    return problem.kind == MeshProblem::Kind::missingNode || problem.kind == MeshProblem::Kind::nonFinite;
  });
  if (ofMesh != nullptr && complete) *ofMesh = meshNotes(mesh, path.string());
  return problems;
}

void writeMesh(const Mesh& mesh, const fs::path& path, MeshFormat format) {
  if (format == MeshFormat::byExtension) {
    const std::string extension = path.extension().string();
    const MeshFormatEntry* named = registry().find(extension);
    if (named == nullptr || !named->info.writes)
      throw InputError(joinText("cannot write ", path.string(), ": the extension ", detail::quoted(extension),
                                " names no format that can be written; use ", writableExtensions()));
    return named->write(mesh, path);
  }
  switch (format) {
    case MeshFormat::msh41:
      return detail::writeMsh(mesh, path, true, false);
    case MeshFormat::msh41Binary:
      return detail::writeMsh(mesh, path, true, true);
    case MeshFormat::msh22:
      return detail::writeMsh(mesh, path, false, false);
    case MeshFormat::msh22Binary:
      return detail::writeMsh(mesh, path, false, true);
    case MeshFormat::vtu:
      return detail::writeVtuWithSets(mesh, path);
    case MeshFormat::byExtension:
      break;
  }
}

}  // namespace ringwatch

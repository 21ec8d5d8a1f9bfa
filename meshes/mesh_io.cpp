#include <ringwatch/meshes/mesh_io.h>

#include <ringwatch/base/error.h>
#include <ringwatch/meshes/file_cursor.h>
#include <ringwatch/meshes/mesh_readers.h>

namespace ringwatch {
namespace {

namespace fs = std::filesystem;

bool startsWithXml(std::string_view text) {
  const std::size_t at = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  return at != std::string_view::npos && text[at] == '<';
}

fs::path withSuffix(fs::path stem, const char* suffix) {
  stem += suffix;
  return stem;
}

Mesh read(const fs::path& path, detail::Notes* notes, detail::Problems* problems) {
  const std::string extension = path.extension().string();
  if (extension == ".node" || extension == ".ele") {
    fs::path stem = path;
    stem.replace_extension();
    return detail::readTetgen(withSuffix(stem, ".node"), withSuffix(stem, ".ele"), notes, problems);
  }
  std::error_code ignored;
  if (!fs::exists(path, ignored) && fs::exists(withSuffix(path, ".node"), ignored))
    return detail::readTetgen(withSuffix(path, ".node"), withSuffix(path, ".ele"), notes, problems);

  const std::string text = detail::readWholeFile(path);
  // The content decides; the extension only helps where the content says nothing.
  if (text.rfind("$MeshFormat", 0) == 0) return detail::readMsh(path, text, notes, problems);
  if (text.rfind("# vtk DataFile", 0) == 0) return detail::readLegacyVtk(path, text, notes, problems);
  if (startsWithXml(text)) return detail::readVtu(path, text, notes, problems);
  if (extension == ".inp") return detail::readInp(path, text, notes, problems);
  if (extension == ".msh") return detail::readMsh(path, text, notes, problems);
  const std::string begin = detail::quoted(std::string_view(text).substr(0, text.find_first_of("\r\n")));
  if (extension == ".vtk")
    throw InputError(path.string() + ":1: begins with " + begin + "; a legacy VTK file begins with # vtk DataFile");
  if (extension == ".vtu")
    throw InputError(path.string() + ":1: begins with " + begin + "; a .vtu file begins with <VTKFile");
  throw InputError(
      path.string() + ":1: not a known mesh format, it begins with " + begin +
      "; known are MSH 2 and 4 (.msh), TetGen (.node and .ele), .vtu, legacy .vtk and Abaqus or CalculiX decks (.inp)");
}

}  // namespace

Mesh readMesh(const fs::path& path, std::vector<std::string>* notes) { return read(path, notes, nullptr); }

Mesh loadMesh(const fs::path& path, std::vector<std::string>* notes) {
  Mesh mesh = readMesh(path, notes);
  requireSound(mesh, path.string(), notes);
  return mesh;
}

MeshState loadVtuState(const fs::path& path, const std::string& displacement, std::vector<std::string>* notes) {
  const std::string text = detail::readWholeFile(path);
  if (!startsWithXml(text))
    throw InputError(path.string() + ": displacements are read from .vtu files only; this is another format");
  MeshState state = detail::readVtuState(path, text, displacement, notes);
  requireSound(state.mesh, path.string(), notes);
  return state;
}

std::vector<MeshProblem> checkMeshFile(const fs::path& path, std::vector<std::string>* notes) {
  std::vector<MeshProblem> problems;
  const Mesh mesh = read(path, notes, &problems);
  for (MeshProblem& problem : checkMesh(mesh)) {
    // The reader has listed these already, with their line.
    if (problem.kind == MeshProblem::Kind::missingNode || problem.kind == MeshProblem::Kind::nonFinite) continue;
    problem.text = path.string() + ": " + problem.text;
    problems.push_back(std::move(problem));
  }
  return problems;
}

void writeMesh(const Mesh& mesh, const fs::path& path, MeshFormat format) {
  if (format == MeshFormat::byExtension) {
    const std::string extension = path.extension().string();
    if (extension == ".msh")
      format = MeshFormat::msh41;
    else if (extension == ".vtu")
      format = MeshFormat::vtu;
    else
      throw InputError("cannot write " + path.string() + ": the extension " + detail::quoted(extension) +
                       " names no format that can be written; use .msh or .vtu");
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

#include <ringwatch/verify/remeshing/mesh_programs.h>

#include <iomanip>
#include <sstream>

#include <ringwatch/base/atomic_file.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/scratch_folder.h>
#include <ringwatch/base/subprocess.h>
#include <ringwatch/meshes/mesh_io.h>

namespace ringwatch::detail {
namespace {

/// Text with numbers that are read as they were.
std::ostringstream exactText() {
  std::ostringstream text;
  text.precision(17);
  return text;
}

/// TetGen's format of surfaces.
std::string smeshText(const TriangleSurface& surface) {
  std::ostringstream text = exactText();
  text << surface.X.cols() << " 3 0 0\n";
  for (Eigen::Index n = 0; n < surface.X.cols(); ++n)
    text << n << ' ' << surface.X(0, n) << ' ' << surface.X(1, n) << ' ' << surface.X(2, n) << '\n';
  text << surface.triangles.size() << " 0\n";
  for (const auto& [a, b, c] : surface.triangles) text << "3 " << a << ' ' << b << ' ' << c << '\n';
  text << "0\n0\n";
  return text.str();
}

/// Gmsh's format 2.2, as surface 1.
std::string mshText(const TriangleSurface& surface) {
  std::ostringstream text = exactText();
  text << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" << surface.X.cols() << '\n';
  for (Eigen::Index n = 0; n < surface.X.cols(); ++n)
    text << n + 1 << ' ' << surface.X(0, n) << ' ' << surface.X(1, n) << ' ' << surface.X(2, n) << '\n';
  text << "$EndNodes\n$Elements\n" << surface.triangles.size() << '\n';
  std::size_t number = 0;
  for (const auto& [a, b, c] : surface.triangles)
    text << ++number << " 2 2 1 1 " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
  text << "$EndElements\n";
  return text.str();
}

std::string firstLineWith(const std::string& text, std::string_view word) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.find(word) != std::string::npos) return line;
  return {};
}

/// Runs a program in a folder, and reads the mesh that it leaves there.
ProgramMesh meshedBy(const std::vector<std::string>& command, const std::filesystem::path& folder,
                     const std::string& result) {
  const ProgramResult run = runProgram(command, folder);
  ProgramMesh made;
  made.seconds = run.seconds;
  if (!run.found) {
    made.note = command.front() + " is not installed";
    return made;
  }
  if (run.status != 0) {
    std::string said = firstLineWith(run.output, "Error");
    if (said.empty()) said = run.output.substr(0, run.output.find('\n'));
    made.note = joinText(command.front(), " ended with status ", run.status, said.empty() ? "" : ": ", said);
    return made;
  }
  try {
    made.mesh = loadMesh(folder / result);
  } catch (const InputError& fault) {
    std::string said = fault.what();
    const std::string place = folder.string() + "/";
    for (std::size_t at = said.find(place); at != std::string::npos; at = said.find(place))
      said.erase(at, place.size());
    made.note = command.front() + " left no sound mesh: " + said;
  }
  return made;
}

}  // namespace

ProgramMesh meshByTetgen(const TriangleSurface& surface, const std::string& switches,
                         std::optional<double> largestVolume) {
  const ScratchFolder folder;
  writeFileAtomically(folder.path() / "body.smesh", smeshText(surface));
  std::ostringstream all;
  all << switches;
  if (largestVolume) all << 'a' << std::fixed << std::setprecision(15) << *largestVolume;
  return meshedBy({"tetgen", all.str(), "body.smesh"}, folder.path(), "body.1.node");
}

ProgramMesh meshByGmsh(const TriangleSurface& surface, GmshOptimizer optimizer) {
  const ScratchFolder folder;
  writeFileAtomically(folder.path() / "body.msh", mshText(surface));
  // gmsh optimises by default.
  writeFileAtomically(folder.path() / "body.geo",
                      joinText("Mesh.Optimize = ", optimizer == GmshOptimizer::own ? 1 : 0,
                               ";\nMerge \"body.msh\";\nSurface Loop(1) = {1};\nVolume(1) = {1};\n"
                               "Physical Volume(1) = {1};\n"));
  std::vector<std::string> command{"gmsh", "body.geo", "-3",    "-nopopup", "-nt",
                                   "1",    "-format",  "msh41", "-o",       "made.msh"};
  if (optimizer == GmshOptimizer::own) command.emplace_back("-optimize");
  if (optimizer == GmshOptimizer::netgen) command.emplace_back("-optimize_netgen");
  return meshedBy(command, folder.path(), "made.msh");
}

}  // namespace ringwatch::detail

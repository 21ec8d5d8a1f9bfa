#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <ringwatch/meshes/check.h>
#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// A mesh format: what the readers, error messages, help texts and documents know of it.
struct MeshFormatInfo {
  std::string_view extensions;  ///< ".msh"; ".node/.ele" for two files that belong together
  std::string_view name;
  std::string_view help;
  bool writes;  ///< `writeMesh` knows it; `readMesh` knows them all
};
/// A format with its reader and writer. One that comes in a single file has `read`, any other one `ownsPath` and
/// `readPath`.
struct MeshFormatEntry {
  using Notes = std::vector<std::string>;
  using Problems = std::vector<MeshProblem>;
  MeshFormatInfo info;
  /// Reads the whole text of a file. notes: as readMesh; problems: where not nullptr, receives what would else be
  /// thrown but leaves a mesh.
  Mesh (*read)(const std::filesystem::path& path, const std::string& text, Notes* notes, Problems* problems) = nullptr;
  bool (*isBegin)(std::string_view text) = nullptr;  ///< tells it by the content; nullptr: the extension must
  std::string_view mustBegin = {};  ///< what a file with the extension begins with; "": the reader says what is wrong
  void (*write)(const Mesh& mesh, const std::filesystem::path& path) = nullptr;  ///< where info.writes
  bool (*ownsPath)(const std::filesystem::path& path) = nullptr;
  Mesh (*readPath)(const std::filesystem::path& path, Notes* notes, Problems* problems) = nullptr;

  std::string_view key() const { return info.extensions; }
};
/// Every format, one entry each in mesh_io.cpp, and those that were registered.
std::span<const MeshFormatInfo> allMeshFormats();
/// Adds one; call it when the program starts, before any is asked for. Throws InputError when the name is taken.
void registerMeshFormat(const MeshFormatEntry& entry);
/// ".msh, .node/.ele, … or .inp"
std::string readableExtensions();
/// ".msh or .vtu"
std::string writableExtensions();

/// Reads every format of `allMeshFormats`. MSH 4.0 is read as text only; of TetGen's two files either one or their
/// common stem is named; .vtu needs a build with VTK; of Abaqus and CalculiX decks nodes, elements and their sets are
/// read, all else is skipped with a note. Volume elements become blocks, in order of first appearance; physical groups
/// of volumes become element sets; groups of surfaces, lines and points become node sets. Numbers of the file are kept
/// in `nodeIds` and `ids`; coordinates are taken as m. Parses only: see `loadMesh`. notes: receives what a user may
/// want to know, one line each. Throws InputError, one line with file, line (byte in a binary file), value, and what
/// would be right.
Mesh readMesh(const std::filesystem::path& path, std::vector<std::string>* notes = nullptr);

/// `readMesh` followed by `requireSound`: a mesh to compute with. repair: `repairMesh` mends it before.
Mesh loadMesh(const std::filesystem::path& path, std::vector<std::string>* notes = nullptr, bool repair = false);

/// A mesh at rest and a deformed state of it.
struct MeshState {
  Mesh mesh;
  NodeVectors x;  // 3×N, m
};
/// Reads a mesh and a state from a .vtu or legacy .vtk file by a displacement (m) at its points: positions are points +
/// displacement. Frames of a run hold deformed points, and say so: there the points are the positions, and the mesh at
/// rest is points - displacement. The mesh is checked as by `loadMesh`. Throws InputError: as readMesh, for a file of
/// another format, and for a field that is missing (lists the fields of three components), has other than three
/// components, or is not finite.
MeshState loadVtuState(const std::filesystem::path& path, const std::string& displacement,
                       std::vector<std::string>* notes = nullptr);
/// The same without the check, as readMesh: nodes that no element uses stay.
MeshState readVtuState(const std::filesystem::path& path, const std::string& displacement,
                       std::vector<std::string>* notes = nullptr);

/// Every problem of a mesh file. Throws InputError where the file cannot be parsed at all; missing nodes and non-finite
/// coordinates are listed with their line. ofMesh: becomes meshNotes(); notes are those of reading it.
std::vector<MeshProblem> checkMeshFile(const std::filesystem::path& path, std::vector<std::string>* notes = nullptr,
                                       std::vector<std::string>* ofMesh = nullptr);

/// The formats that `writeMesh` knows.
enum class MeshFormat { byExtension, msh41, msh41Binary, msh22, msh22Binary, vtu };

/// Writes a mesh; the file appears whole or not at all. byExtension: .msh (4.1, text) or .vtu. MSH 4.1 and .vtu keep
/// all sets; MSH 2.2 allows an element one set only, so the smallest one that holds it is kept. Node sets are written
/// to MSH as point elements. Numbers below 1, which MSH does not allow, or repeated ones, are replaced by index + 1.
/// Throws InputError for another extension or where the file cannot be written.
void writeMesh(const Mesh& mesh, const std::filesystem::path& path, MeshFormat format = MeshFormat::byExtension);

}  // namespace ringwatch

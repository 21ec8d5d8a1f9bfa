#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <ringwatch/meshes/mesh_io.h>

/// The readers and writers behind mesh_io.h, one a format.
namespace ringwatch::detail {

using Notes = std::vector<std::string>;
using Problems = std::vector<MeshProblem>;

Mesh readMsh(const std::filesystem::path& path, const std::string& text, Notes* notes, Problems* problems);
Mesh readInp(const std::filesystem::path& path, const std::string& text, Notes* notes, Problems* problems);
/// What is added to the numbers of each instance of an .inp deck, by its name in upper case.
std::map<std::string, std::int64_t> instanceOffsets(const std::filesystem::path& path, const std::string& text);
Mesh readDyna(const std::filesystem::path& path, const std::string& text, Notes* notes, Problems* problems);
/// A universal file of I-DEAS, as Salome and gmsh write them, too.
Mesh readUniversal(const std::filesystem::path& path, const std::string& text, Notes* notes, Problems* problems);
/// Whether a text is one: its first line is the mark of a dataset, -1, and the next one its number.
bool startsWithUniversal(std::string_view text);
/// How the note of a deck begins, behind its name, that lists the keywords that are not of the mesh.
inline constexpr std::string_view deckSkippedNote = ": skipped, only nodes, elements and their sets are read: ";
Mesh readTetgen(const std::filesystem::path& nodeFile, const std::filesystem::path& elementFile, Notes* notes,
                Problems* problems);
Mesh readLegacyVtk(const std::filesystem::path& path, const std::string& text, Notes* notes, Problems* problems);
Mesh readVtu(const std::filesystem::path& path, const std::string& text, Notes* notes, Problems* problems);
/// The mesh at rest, not yet checked, with the positions.
MeshState readVtuState(const std::filesystem::path& path, const std::string& text, const std::string& displacement,
                       Notes* notes);
/// A state of a results file as it stands there; numbers may be not finite.
struct ResultFrame {
  Mesh mesh;                                                   // X: the points of the file
  bool nodesHaveNumbers = false, elementsHaveNumbers = false;  // of the file, not those of its order
  std::string displacement;                                    // the name of the field that `u` is; "" for none
  std::optional<NodeVectors> u;                                // 3×N, m
  std::string vectors;          // names of the fields of three components at the points, for a message
  bool deformedPoints = false;  // the file says that its points are deformed positions
  std::optional<double> time;   // s
  std::optional<std::int64_t> increment;
  std::optional<double> step;              // s, taken from here
  std::vector<std::vector<bool>> deleted;  // [block][element]; empty where the file says of no element that it is
};
/// What a message says of the fields of three components at the points, their names in quotes; "" for none.
std::string fieldChoice(const std::string& vectors);
/// The same behind that the field of that name is missing.
std::string noField(const std::string& name, const std::string& vectors);
/// The field of OpenRadioss' files with the numbers of the nodes.
inline constexpr const char* nodeNumberField = "NODE_ID";
/// The fields that takeCellField takes: numbers of the elements and 1 for a deleted one, of OpenRadioss, and Abaqus' 0
/// for a deleted one among 1.
inline constexpr std::string_view resultFields[] = {"ELEMENT_ID", "EROSION_STATUS", "STATUS"};
/// Takes what another program says of the elements, in the order of blocks and elements; passes over other fields.
/// source, notes: for numbers that are not taken.
void takeCellField(ResultFrame& frame, const std::string& name, const std::vector<double>& values,
                   const std::string& source, Notes* notes);
/// Takes the numbers of the nodes, where they are whole and differ.
void takeNodeNumbers(ResultFrame& frame, const std::vector<double>& values, const std::string& source, Notes* notes);
/// Whether the text of a file may have one of these fields.
bool mayTellOfElements(std::string_view text);
/// The mesh of what is not deleted, with a note. Throws InputError where all is.
Mesh standingMesh(ResultFrame frame, const std::string& source, Notes* notes);
/// Throws InputError for the first problem of a state that is none of its numbers: those may be not finite.
void requireElements(const Problems& problems);
/// names: of the displacement; the first that there is. notes: of the mesh, or nullptr.
ResultFrame readVtuResult(const std::filesystem::path& path, const std::string& text,
                          const std::vector<std::string>& names, Notes* notes);
ResultFrame readLegacyVtkResult(const std::filesystem::path& path, const std::string& text,
                                const std::vector<std::string>& names, Notes* notes);
/// A CalculiX results file: its mesh, and where in the text its states are.
Mesh readFrd(const std::filesystem::path& path, const std::string& text, Notes* notes, Problems* problems);
struct FrdState {
  double time;             // s
  std::int64_t increment;  // of its step
  std::int64_t step;
  std::size_t position;  // of the first value of the field
  int idWidth;           // characters of a node's number
};
std::vector<FrdState> frdStates(const std::filesystem::path& path, const std::string& text, const std::string& field);
/// The vectors of a state by the numbers of their nodes.
std::vector<std::pair<std::int64_t, Eigen::Vector3d>> frdVectors(const std::filesystem::path& path,
                                                                 const std::string& text, const FrdState& state);
/// Unpacks a block of a .vtu file with VTK's compressor of that class name into exactly `outSize` bytes; false when it
/// does not come out so. Throws InputError for an unknown compressor, and for any in a build without VTK.
bool unpack(const std::string& source, const std::string& compressor, const char* in, std::size_t inSize, char* out,
            std::size_t outSize);
/// A format that ringwatch does not read itself: by what the text begins with, or by the extension; nullptr where that
/// tells none.
struct ForeignFormat;
const ForeignFormat* foreignByContent(std::string_view text);
const ForeignFormat* foreignByExtension(const std::filesystem::path& path);
/// Has meshio read a mesh, as a program that is called, and reads what it has written. Throws InputError as well where
/// meshio is missing, and for a format that it does not read either, which is named.
Mesh readForeign(const ForeignFormat& format, const std::filesystem::path& path, Notes* notes, Problems* problems);
/// read_by_meshio.py
std::string_view readByMeshioScript();
void writeMsh(const Mesh& mesh, const std::filesystem::path& path, bool version4, bool binary);
void writeVtuWithSets(const Mesh& mesh, const std::filesystem::path& path);

}  // namespace ringwatch::detail

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>

#include <ringwatch/base/scratch_folder.h>
#include <ringwatch/base/subprocess.h>
#include <ringwatch/meshes/formats/file_cursor.h>
#include <ringwatch/meshes/formats/mesh_readers.h>

namespace ringwatch::detail {

/// A format that ringwatch does not read itself.
struct ForeignFormat {
  std::string_view begin;       // of the text, in capitals or not; "": its files begin in several ways
  std::string_view extensions;  // that tell it where the text does not, each with a space on both sides
  std::string_view name;
  std::string_view kind;    // for read_by_meshio.py; "": it cannot read it
  std::string_view advice;  // of those that are not read
};

namespace {

constexpr std::string_view writeAnother = "gmsh, meshio and most meshers write .msh, .vtu or .inp";
constexpr std::string_view fillIt = "a surface has no volume elements; gmsh and tetgen fill one with tetrahedra";
constexpr std::string_view meshIt = "gmsh makes a mesh of it: gmsh -3 FILE -o part.msh";
constexpr std::string_view cellsByFaces = "it gives cells by their faces; write the mesh as .msh of gmsh or as .inp";
constexpr std::string_view meshOfFlex =
    "it tells how to make a mesh; gmsh makes one, and .msh is what its flexcomp reads";

constexpr std::string_view rigidAlone =
    "its bodies are rigid, and a step that is stable is set by soft ones; MuJoCo reads it and saves MJCF, to which a "
    "flex "
    "can be added";
constexpr std::string_view asDyna =
    "OpenRadioss reads LS-DYNA decks, too, and so does ringwatch: give the .k file that it was made of, or write one "
    "in "
    "the preprocessor";

constexpr std::string_view byParaView = "ParaView opens it and saves its states as .vtu files, or as a .pvd";
constexpr std::string_view byAbaqus =
    "Abaqus' own Python alone opens it; let it write a .vtu or .vtk file for each state";

constexpr ForeignFormat formats[] = {
    {"MeshVersionFormatted", " .mesh .meshb ", "a Medit mesh", "medit", {}},
    {"BEGIN BULK", " .bdf .nas .fem ", "a Nastran deck", "nastran", {}},
    {"SOL ", {}, "a Nastran deck", "nastran", {}},
    {"CEND", {}, "a Nastran deck", "nastran", {}},
    {"GRID", {}, "a Nastran deck", "nastran", {}},
    {"CDF\x01", {}, "a netCDF file, as of Exodus", "exodus", {}},
    {"CDF\x02", {}, "a netCDF file, as of Exodus", "exodus", {}},
    {"CDF\x05", {}, "a netCDF file, as of Exodus", "exodus", {}},
    {"\x89HDF", {}, "an HDF5 file, as of MED, Exodus and XDMF", "hdf5", {}},
    {"<Xdmf", {}, "an XDMF file", "xdmf", {}},
    {"<dolfin", {}, "a mesh of dolfin", {}, writeAnother},
    {"mesh3d", " .vol ", "a Netgen mesh", "netgen", {}},
    {"* FLAC3D", " .f3grid ", "a FLAC3D grid", {}, writeAnother},
    {"NDIME", " .su2 ", "an SU2 mesh", "su2", {}},
    {"Begin ", " .mdpa ", "a model part of Kratos", {}, writeAnother},
    {{}, " .avs .ucd ", "a mesh of AVS-UCD", {}, writeAnother},
    {{}, " .ugrid ", "a UGRID mesh", {}, writeAnother},
    {"VARIABLES", " .tec .plt ", "a Tecplot file", {}, writeAnother},
    {"#!TDV", {}, "a Tecplot file", {}, writeAnother},
    {{}, " .dato .post ", "a PERMAS file", {}, writeAnother},
    {{}, " .cgns ", "a CGNS file", {}, writeAnother},
    {{}, " .d3plot ", "a file of results of LS-DYNA (d3plot)", {}, byParaView},
    {{}, " .odb ", "a file of results of Abaqus (.odb)", {}, byAbaqus},
    {{}, " .h5m ", "a mesh of MOAB", {}, writeAnother},
    {"#RADIOSS", " .rad ", "a Radioss deck", {}, asDyna},
    {"/BEGIN", {}, "a Radioss deck", {}, asDyna},
    {"/PREP7", " .cdb ", "an Ansys deck", {}, writeAnother},
    {"/COM", {}, "an Ansys deck", {}, writeAnother},
    {"/BATCH", {}, "an Ansys deck", {}, writeAnother},
    {"MESH ", {}, "a GiD mesh", {}, writeAnother},
    {"(0 ", {}, "a Fluent mesh", {}, cellsByFaces},
    {"(1 ", {}, "a Fluent mesh", {}, cellsByFaces},
    {"(2 ", {}, "a Fluent mesh", {}, cellsByFaces},
    {"$NOD", {}, "a mesh of gmsh's version 1", {}, writeAnother},
    {"solid", " .stl ", "a surface in STL", {}, fillIt},
    {"ply", {}, "a surface in PLY", {}, fillIt},
    {"OFF", {}, "a surface in OFF", {}, fillIt},
    {{}, " .obj ", "a surface in OBJ", {}, fillIt},
    {"ISO-10303-21", " .step .stp ", "a geometry in STEP", {}, meshIt},
    {"SetFactory", " .geo .geo_unrolled ", "a geometry of gmsh", {}, meshIt},
    {"<mujoco", {}, "a model of MuJoCo (MJCF)", {}, meshOfFlex},
    {"<robot", " .urdf ", "a robot in URDF", {}, rigidAlone},
    {"<sdf", " .sdf ", "a world of Gazebo (SDF)", {}, rigidAlone},
    {"<COLLADA", " .dae ", "a surface in COLLADA", {}, fillIt},
};

[[noreturn]] void refuse(const std::filesystem::path& path, const ForeignFormat& format) {
  throw InputError(joinText(path.string(), ":1: this is ", format.name, ", which is not read; ", format.advice));
}

std::vector<std::string> linesOf(const std::filesystem::path& path) {
  std::vector<std::string> lines;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

}  // namespace

const ForeignFormat* foreignByContent(std::string_view text) {
  std::string_view begin = behindProlog(text);
  // Behind its title a Tecplot file names its variables.
  if (inUpperCase(begin.substr(0, 5)) == "TITLE") begin.remove_prefix(std::min(begin.find('\n') + 1, begin.size()));
  for (const ForeignFormat& format : formats)
    if (!format.begin.empty() && inUpperCase(begin.substr(0, format.begin.size())) == inUpperCase(format.begin))
      return &format;
  return nullptr;
}

const ForeignFormat* foreignByExtension(const std::filesystem::path& path) {
  // LS-DYNA numbers its files: d3plot, d3plot01.
  const std::string extension = path.filename().string().starts_with("d3plot")
                                    ? " .D3PLOT "
                                    : joinText(" ", inUpperCase(path.extension().string()), " ");
  for (const ForeignFormat& format : formats)
    if (extension.size() > 2 && inUpperCase(format.extensions).find(extension) != std::string::npos) return &format;
  return nullptr;
}

Mesh readForeign(const ForeignFormat& format, const std::filesystem::path& path, Notes* notes, Problems* problems) {
  if (format.kind.empty()) refuse(path, format);
  // CGNS and MOAB write HDF5, too.
  if (const ForeignFormat* named = foreignByExtension(path); format.kind == "hdf5" && named && named->kind.empty())
    refuse(path, *named);
  const std::string source = path.string(), is = joinText(source, ": this is ", format.name);
  if (!std::filesystem::is_regular_file(path)) throw InputError(is + ", which is read from a file, not from a pipe");
  const ScratchFolder folder;
  ProgramResult result;
  std::vector<std::string> said;
  // Debian's packages are modules of Debian's Python, which another one may stand before on the search path.
  for (const char* python : {"python3", "/usr/bin/python3"}) {
    result = runProgram({python, "-c", std::string(readByMeshioScript()), std::filesystem::absolute(path).string(),
                         std::string(format.kind), folder.path().string()},
                        folder.path());
    said = linesOf(folder.path() / "said");
    constexpr int killed = 128;
    if (result.found && (result.status == 0 || (result.status == 1 && !said.empty()) || result.status >= killed)) break;
    if (said.empty()) said.emplace_back("python3");
  }
  if (result.found && result.status == 0) {
    const std::filesystem::path converted = folder.path() / "mesh.vtu";
    if (notes != nullptr)
      for (const std::string& line : said) notes->push_back(joinText(source, ": ", line));
    return readVtu(path, readWholeFile(converted), notes, problems);
  }
  if (result.found && result.status == 1 && !said.empty()) throw InputError(joinText(is, "; ", said.front()));
  if (result.found && result.status == 128 + SIGALRM)
    throw InputError(is + "; reading it by meshio took 10 minutes without an end; is it cut off?");
  if (result.found && result.status != 3)
    throw InputError(joinText(is, "; reading it by meshio ended with status ", result.status));
  throw InputError(joinText(is, ", which meshio reads: install python3-meshio, python3-h5py and python3-netcdf4, as ",
                            "scripts/setup does; missing is ", said.front()));
}

void refuseForeign(const std::filesystem::path& path, std::string_view text) {
  const ForeignFormat* const format = foreignByContent(text);
  if (format == nullptr) return;
  if (format->kind.empty()) refuse(path, *format);
  throw InputError(joinText(path.string(), ":1: this is ", format->name, ", which is read as a mesh, not here"));
}

void refuseForeignStates(const std::filesystem::path& path, std::string_view text) {
  const ForeignFormat* format = foreignByContent(text);
  if (format == nullptr) format = foreignByExtension(path);
  if (format == nullptr) return;
  if (format->kind.empty()) refuse(path, *format);
  throw InputError(joinText(path.string(), ":1: this is ", format->name, ", of which the mesh alone is read; ",
                            "give its states as .vtu or .vtk files or as a .pvd, as ParaView saves them"));
}

}  // namespace ringwatch::detail

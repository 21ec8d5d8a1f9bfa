#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// A named array for a .vtu file: `components` values a node or an element, component fastest. The values are not
/// copied.
struct VtuField {
  std::string name;
  int components = 1;
  std::variant<std::span<const double>, std::span<const std::int32_t>, std::span<const std::int64_t>> values;
};

/// Writes a frame: the mesh at positions x (3×N, m) with point fields in node order and cell fields in block order (the
/// elements of block 0, then those of block 1, …), compressed. The arrays originalNodeId and originalElementId hold the
/// numbers of the mesh's file, arrays set:NAME the mesh's sets; time (s) goes to the field TimeValue. frameFields: VTK
/// field data, of any length. The file appears whole or not at all.
/// Throws InputError where the file cannot be written, a field has the wrong length, or this build is without VTK.
void writeVtu(const std::filesystem::path& path, const Mesh& mesh, const NodeVectors& x,
              std::span<const VtuField> pointFields = {}, std::span<const VtuField> cellFields = {},
              std::optional<double> time = {}, std::span<const VtuField> frameFields = {});

/// Writes the .pvtu of a frame in pieces: .vtu files (as ParaView finds them from its folder) that writeVtu has written
/// of parts of the mesh, with these fields, whose values are not read, and the sets of `mesh`. Time and frame fields
/// are in the pieces. The file appears whole or not at all; it needs no VTK. Throws InputError where it cannot be
/// written.
void writePvtu(const std::filesystem::path& path, const Mesh& mesh, std::span<const VtuField> pointFields,
               std::span<const VtuField> cellFields, std::span<const std::filesystem::path> pieces);

/// Name of the field data (one number, 1) that marks a file whose points are deformed positions: subtract the field
/// "displacement" for those at rest. loadVtuState honours it.
inline constexpr const char* deformedPointsMark = "points are deformed positions";

/// A frame of a .pvd collection.
struct PvdEntry {
  double time;                 // s
  std::filesystem::path file;  // as ParaView finds it from the folder of the .pvd
};

/// Writes the list of frames that ParaView opens as one animation. The file appears whole or not at all; it needs no
/// VTK. Throws InputError where it cannot be written.
void writePvd(const std::filesystem::path& path, std::span<const PvdEntry> entries);

}  // namespace ringwatch

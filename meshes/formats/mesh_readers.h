#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include <ringwatch/meshes/mesh_io.h>

/// The readers and writers behind mesh_io.h, one a format.
namespace ringwatch::detail {

using Notes = std::vector<std::string>;
using Problems = std::vector<MeshProblem>;

Mesh readMsh(const std::filesystem::path& path, const std::string& text, Notes* notes, Problems* problems);
Mesh readInp(const std::filesystem::path& path, const std::string& text, Notes* notes, Problems* problems);
Mesh readTetgen(const std::filesystem::path& nodeFile, const std::filesystem::path& elementFile, Notes* notes,
                Problems* problems);
Mesh readLegacyVtk(const std::filesystem::path& path, const std::string& text, Notes* notes, Problems* problems);
Mesh readVtu(const std::filesystem::path& path, const std::string& text, Notes* notes, Problems* problems);
/// The mesh at rest, not yet checked, with the positions.
MeshState readVtuState(const std::filesystem::path& path, const std::string& text, const std::string& displacement,
                       Notes* notes);
/// Unpacks a block of a .vtu file with VTK's compressor of that class name into exactly `outSize` bytes; false when it
/// does not come out so. Throws InputError for an unknown compressor, and for any in a build without VTK.
bool unpack(const std::string& source, const std::string& compressor, const char* in, std::size_t inSize, char* out,
            std::size_t outSize);
void writeMsh(const Mesh& mesh, const std::filesystem::path& path, bool version4, bool binary);
void writeVtuWithSets(const Mesh& mesh, const std::filesystem::path& path);

}  // namespace ringwatch::detail

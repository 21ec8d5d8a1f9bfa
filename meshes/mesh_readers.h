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
Mesh readTetgen(const std::filesystem::path& nodeFile, const std::filesystem::path& elementFile, Notes* notes, Problems* problems);
Mesh readLegacyVtk(const std::filesystem::path& path, const std::string& text, Notes* notes, Problems* problems);
Mesh readVtu(const std::filesystem::path& path, const std::string& text, Notes* notes, Problems* problems);
void writeMsh(const Mesh& mesh, const std::filesystem::path& path, bool version4, bool binary);
void writeVtuWithSets(const Mesh& mesh, const std::filesystem::path& path);

}  // namespace ringwatch::detail

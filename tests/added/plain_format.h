#pragma once
#include <fstream>
#include <sstream>

#include <ringwatch/base/error.h>
#include <ringwatch/meshes/mesh_io.h>

namespace ringwatch::test {

/// A mesh format added from outside: "plain", N and N positions, M and M tetrahedra.
inline Mesh readPlain(const std::filesystem::path& path, const std::string& text, std::vector<std::string>*,
                      std::vector<MeshProblem>*) {
  std::istringstream stream(text);
  std::string head;
  Eigen::Index nodes = 0;
  std::size_t elements = 0;
  stream >> head >> nodes;
  Mesh mesh;
  mesh.X.resize(3, nodes);
  for (double& x : mesh.X.reshaped()) stream >> x;
  MeshBlock block{elementTypeOf<Tet4>, {}, {}};
  stream >> elements;
  block.connectivity.resize(4 * elements);
  for (std::int32_t& node : block.connectivity) stream >> node;
  if (!stream) throw InputError(path.string() + ": ends too early");
  mesh.blocks.push_back(std::move(block));
  return mesh;
}
inline void writePlain(const Mesh& mesh, const std::filesystem::path& path) {
  std::ofstream stream(path);
  stream.precision(17);
  stream << "plain " << mesh.nodeCount();
  for (const double x : mesh.X.reshaped()) stream << ' ' << x;
  stream << '\n' << mesh.blocks[0].elementCount();
  for (const std::int32_t node : mesh.blocks[0].connectivity) stream << ' ' << node;
}
inline constexpr MeshFormatEntry plainFormat{
    .info = {".plain", "plain text", "positions and tetrahedra", true},
    .read = readPlain,
    .isBegin = [](std::string_view text) { return text.starts_with("plain "); },
    .write = writePlain};

}  // namespace ringwatch::test

// Files in a program whose locale writes 1,5: what is read and written is what the C locale reads and writes.
#include <algorithm>
#include <sstream>

#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/meshes/results.h>

#include <tests/support/comma_locale.h>

#include "tests/meshes/mesh_test_tools.h"

namespace ringwatch {
namespace {

using namespace test;

/// The mesh of a file, of one tetrahedron with corners at 0, 0.5, 0.25 and 1.5, and one coordinate that rounds to 0.
struct Case {
  std::string name, text;
};
std::vector<Case> cases() {
  const std::string points = "0 1.5e-400 0\n0.5 0 0\n0 2.5e-1 0\n0 0 1.5\n";
  std::string numbered;
  std::istringstream lines(points);
  int number = 0;
  for (std::string line; std::getline(lines, line);) numbered += std::to_string(++number) + " " + line + "\n";
  std::string commas = numbered;
  std::ranges::replace(commas, ' ', ',');
  return {{"a.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n" + numbered +
                        "$EndNodes\n$Elements\n1\n1 4 0 1 2 3 4\n$EndElements\n"},
          {"a.vtk", "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n" + points +
                        "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n"},
          {"a.inp", "*NODE\n" + commas + "*ELEMENT, TYPE=C3D4\n1, 1, 2, 3, 4\n"},
          {"a.mesh",
           "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 1.5e-400 0 0\n0.5 0 0 0\n0 2.5e-1 0 0\n0 0 1.5 0\n"
           "Tetrahedra\n1\n1 2 3 4 0\nEnd\n"}};
}

TEST(CommaLocale, ChangesNothingThatIsRead) {
  const TemporaryFolder folder;
  for (const auto& [name, text] : cases()) {
    folder.write(name, text);
    const Mesh expected = readMesh(folder / name);
    EXPECT_EQ(expected.X(1, 0), 0) << name;
    EXPECT_EQ(expected.X(0, 1), 0.5) << name;
    EXPECT_EQ(expected.X(2, 3), 1.5) << name;
    const CommaLocale comma;
    const Mesh found = readMesh(folder / name);
    EXPECT_EQ(found.X, expected.X) << name;
    EXPECT_EQ(found.blocks[0].connectivity, expected.blocks[0].connectivity) << name;
  }
}

TEST(CommaLocale, ChangesNothingThatIsWritten) {
  const TemporaryFolder folder;
  Mesh mesh = generateBar({.size = {1.5, 0.5, 0.25}, .cells = {2, 1, 1}, .jitter = 0.2});
  mesh.nodeIds.resize(mesh.nodeCount());
  for (std::size_t i = 0; i < mesh.nodeCount(); ++i) mesh.nodeIds[i] = 1000 * static_cast<std::int64_t>(i + 1);
  for (const std::string name : {"a.msh", "a.vtu"}) {
    writeMesh(mesh, folder / name);
    const CommaLocale comma;
    writeMesh(mesh, folder / ("comma-" + name));
    EXPECT_EQ(readBytes(folder / ("comma-" + name)), readBytes(folder / name));
  }
}

TEST(CommaLocale, ChangesNoFieldAndNoTime) {
  const TemporaryFolder folder;
  for (const std::string name : {"a.vtk", "b.vtk"})
    folder.write(name, cases()[1].text + "POINT_DATA 4\nVECTORS u double\n0.25 0 0\n0 0.5 0\n0 0 -0.125\n1.5 0 0\n");
  folder.write("run.pvd",
               "<VTKFile type=\"Collection\"><Collection><DataSet timestep=\"0.25\" file=\"a.vtk\"/><DataSet "
               "timestep=\"0.75\" file=\"b.vtk\"/></Collection></VTKFile>");
  const NodeVectors expected = readVtuState(folder / "a.vtk", "u").x;
  EXPECT_EQ(expected(2, 2), -0.125);
  const CommaLocale comma;
  EXPECT_EQ(readVtuState(folder / "a.vtk", "u").x, expected);
  const std::vector<PvdEntry> entries = readPvd(folder / "run.pvd");
  EXPECT_EQ(entries.at(0).time, 0.25);
  EXPECT_EQ(entries.at(1).time, 0.75);
}

}  // namespace
}  // namespace ringwatch

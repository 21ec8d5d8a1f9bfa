#include <bit>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <map>

#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/meshes/quality.h>

#include "tests/meshes/mesh_test_tools.h"

namespace ringwatch {
namespace {

using namespace test;

std::vector<MeshFormat> losslessFormats() {
  std::vector<MeshFormat> formats{MeshFormat::msh41, MeshFormat::msh41Binary};
#ifdef RINGWATCH_WITH_VTK
  formats.push_back(MeshFormat::vtu);
#endif
  return formats;
}

TEST(MeshIo, LosslessFormatsKeepNumbersPositionsBlocksAndSets) {
  const TemporaryFolder folder;
  const Mesh mesh = mixedMesh();
  for (const MeshFormat format : losslessFormats()) {
    const auto path = folder / (format == MeshFormat::vtu ? "m.vtu" : "m.msh");
    writeMesh(mesh, path, format);
    expectSame(mesh, readMesh(path));
  }
  EXPECT_EQ(folder.fileCount(), losslessFormats().size() > 2 ? 2u : 1u) << "temporary files are left";
}

TEST(MeshIo, Msh22KeepsTheSmallestSetOfEachElement) {
  const TemporaryFolder folder;
  const Mesh mesh = mixedMesh();
  Mesh expected = mesh;
  expected.elementSets.clear();
  expected.elementSets["box"] = {{0, 0}, {0, 1}};
  expected.elementSets["tip"] = {{1, 1}};
  expected.elementSets["all"] = {{1, 0}};
  for (const MeshFormat format : {MeshFormat::msh22, MeshFormat::msh22Binary}) {
    writeMesh(mesh, folder / "m.msh", format);
    expectSame(expected, readMesh(folder / "m.msh"));
  }
}

TEST(MeshIo, GeneratedNumbersStartAtOneInTheFile) {
  const TemporaryFolder folder;
  const Mesh mesh = generateBar({.cells = {2, 1, 1}, .element = "hex8"});
  writeMesh(mesh, folder / "m.msh");
  const Mesh back = readMesh(folder / "m.msh");
  expectSame(mesh, back, false);
  EXPECT_EQ(back.nodeIds.front(), 1);
  EXPECT_EQ(back.blocks[0].ids.back(), 2);
}

// Made by hand from the format's description, so that reader and writer cannot agree on the same mistake.
template <class T>
void put(std::string& bytes, T value, bool swap) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (swap) std::reverse(raw, raw + sizeof(T));
  bytes.append(raw, sizeof(T));
}

const double corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}};

std::string binary22(bool swap) {
  std::string b = "$MeshFormat\n2.2 1 8\n";
  put<std::int32_t>(b, 1, swap);
  b += "\n$EndMeshFormat\n$PhysicalNames\n2\n2 4 \"base\"\n3 9 \"the solid\"\n$EndPhysicalNames\n$Nodes\n4\n";
  for (int i = 0; i < 4; ++i) {
    put<std::int32_t>(b, 10 + i, swap);
    for (const double x : corners[i]) put(b, x, swap);
  }
  b += "\n$EndNodes\n$Elements\n2\n";
  for (const int x : {2, 1, 2, 70, 4, 1, 10, 12, 11}) put<std::int32_t>(b, x, swap);
  for (const int x : {4, 1, 2, 71, 9, 1, 10, 11, 12, 13}) put<std::int32_t>(b, x, swap);
  return b + "\n$EndElements\n";
}

std::string binary41(bool swap) {
  std::string b = "$MeshFormat\n4.1 1 8\n";
  put<std::int32_t>(b, 1, swap);
  b += "\n$EndMeshFormat\n$PhysicalNames\n2\n2 4 \"base\"\n3 9 \"the solid\"\n$EndPhysicalNames\n$Entities\n";
  const auto size = [&](std::uint64_t v) { put(b, v, swap); };
  const auto integer = [&](std::int32_t v) { put(b, v, swap); };
  const auto real = [&](double v) { put(b, v, swap); };
  for (const int n : {1, 0, 1, 1}) size(static_cast<std::uint64_t>(n));
  integer(5), real(0), real(0), real(0), size(0);  // a point of no group
  integer(1);                                      // a surface
  for (int k = 0; k < 6; ++k) real(k);
  size(1), integer(4), size(2), integer(3), integer(-4);
  integer(1);  // a volume
  for (int k = 0; k < 6; ++k) real(k);
  size(1), integer(9), size(1), integer(1);
  b += "\n$EndEntities\n$Nodes\n";
  size(2), size(4), size(10), size(13);
  integer(2), integer(1), integer(1), size(3);  // parametric: two more numbers a node
  for (int i = 0; i < 3; ++i) size(10 + static_cast<std::uint64_t>(i));
  for (int i = 0; i < 3; ++i) {
    for (const double x : corners[i]) real(x);
    real(0.5), real(0.5);
  }
  integer(3), integer(1), integer(0), size(1), size(13);
  for (const double x : corners[3]) real(x);
  b += "\n$EndNodes\n$Elements\n";
  size(2), size(2), size(70), size(71);
  integer(2), integer(1), integer(2), size(1), size(70), size(10), size(12), size(11);
  integer(3), integer(1), integer(4), size(1), size(71), size(10), size(11), size(12), size(13);
  return b + "\n$EndElements\n";
}

void expectTetWithBase(const Mesh& mesh) {
  ASSERT_EQ(mesh.nodeCount(), 4u);
  EXPECT_EQ(mesh.nodeIds, (std::vector<std::int64_t>{10, 11, 12, 13}));
  ASSERT_EQ(mesh.blocks.size(), 1u);
  EXPECT_EQ(mesh.blocks[0].ids, std::vector<std::int64_t>{71});
  EXPECT_EQ(mesh.blocks[0].connectivity, (std::vector<std::int32_t>{0, 1, 2, 3}));
  EXPECT_DOUBLE_EQ(meshVolume(mesh), 1.0);
  EXPECT_EQ(mesh.nodeSets.at("base"), (std::vector<std::int32_t>{0, 1, 2}));
  EXPECT_EQ(mesh.elementSets.at("the solid"), std::vector<ElementRef>{ElementRef{}});
}

TEST(MeshIo, BinaryMshMadeByHandInBothByteOrders) {
  const TemporaryFolder folder;
  for (const bool swap : {false, true})
    for (const std::string& bytes : {binary22(swap), binary41(swap)}) {
      writeBytes(folder / "m.msh", bytes);
      expectTetWithBase(loadMesh(folder / "m.msh"));
    }
}

TEST(MeshIo, TextMshOfEveryVersion) {
  const TemporaryFolder folder;
  const std::string names = "$PhysicalNames\n2\n2 4 \"base\"\n3 9 \"the solid\"\n$EndPhysicalNames\n";
  writeBytes(folder / "2.msh", "$MeshFormat\r\n2.2 0 8\r\n$EndMeshFormat\r\n" + names +
                                   "$Nodes\n4\n10 0 0 0\n11 1e0 0 0\n12 0 +2 0\n13 0 0 3.0\n$EndNodes\n"
                                   "$Elements\n2\n70 2 2 4 1 10 12 11\n71 4 2 9 1 10 11 12 13\n$EndElements\n"
                                   "$NodeData\n1\n\"anything\"\n$EndNodeData\n");
  expectTetWithBase(loadMesh(folder / "2.msh"));
  writeBytes(folder / "40.msh",
             "$MeshFormat\n4 0 8\n$EndMeshFormat\n" + names +
                 "$Entities\n1 0 1 1\n5 0 0 0 0 0 0 0\n1 0 0 0 1 1 1 1 4 0\n1 0 0 0 1 1 1 1 9 1 1\n$EndEntities\n"
                 "$Nodes\n2 4\n1 2 0 3\n10 0 0 0\n11 1 0 0\n12 0 2 0\n1 3 0 1\n13 0 0 3\n$EndNodes\n"
                 "$Elements\n2 2\n1 2 2 1\n70 10 12 11\n1 3 4 1\n71 10 11 12 13\n$EndElements\n");
  expectTetWithBase(loadMesh(folder / "40.msh"));
  writeBytes(folder / "41.msh",
             "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n" + names +
                 "$Entities\n1 0 1 1\n5 0 0 0 0 \n1 0 0 0 1 1 1 1 4 0 \n1 0 0 0 1 1 1 1 9 1 1 \n$EndEntities\n"
                 "$Nodes\n2 4 10 13\n2 1 0 3\n10\n11\n12\n0 0 0\n1 0 0\n0 2 0\n3 1 0 1\n13\n0 0 3\n$EndNodes\n"
                 "$Elements\n2 2 70 71\n2 1 2 1\n70 10 12 11 \n3 1 4 1\n71 10 11 12 13 \n$EndElements\n");
  expectTetWithBase(loadMesh(folder / "41.msh"));
}

TEST(MeshIo, TetgenFromEitherFileOrTheStemWithAnyFirstNumber) {
  const TemporaryFolder folder;
  for (const int first : {0, 1}) {
    const auto n = [&](int i) { return std::to_string(first + i); };
    writeBytes(folder / "a.1.node", "# nodes\n\n 4 3 1 1 # four\n" + n(0) + " 0 0 0 9.5 0\n" + n(1) +
                                        " 1 0 0 9.5 2\n# in between\n" + n(2) + " 0 2 0 9.5 2\n" + n(3) +
                                        " 0 0 3 9.5 0 # last\n# made by hand\n");
    writeBytes(folder / "a.1.ele", "1 4 1\n" + n(0) + " " + n(0) + " " + n(1) + " " + n(2) + " " + n(3) + " 7\n");
    for (const char* name : {"a.1.node", "a.1.ele", "a.1"}) {
      const Mesh mesh = loadMesh(folder / name);
      EXPECT_EQ(mesh.nodeIds.front(), first);
      EXPECT_DOUBLE_EQ(meshVolume(mesh), 1.0);
      EXPECT_EQ(mesh.nodeSets.at("marker-2"), (std::vector<std::int32_t>{1, 2}));
      EXPECT_EQ(mesh.elementSets.at("region-7").size(), 1u);
    }
  }
}

TEST(MeshIo, UnusedNodesAreDroppedAndMirroredMeshesTurnedRoundWithANote) {
  const TemporaryFolder folder;
  writeBytes(folder / "m.msh",
             "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 9 9 9\n2 0 0 0\n3 1 0 0\n4 0 1 0\n5 0 0 1\n$EndNodes\n"
             "$Elements\n2\n1 15 2 8 1 1\n2 4 0 2 4 3 5\n$EndElements\n");
  std::vector<std::string> notes;
  const Mesh mesh = loadMesh(folder / "m.msh", &notes);
  EXPECT_EQ(mesh.nodeIds, (std::vector<std::int64_t>{2, 3, 4, 5}));
  EXPECT_NEAR(meshVolume(mesh), 1.0 / 6.0, 1e-15);
  EXPECT_TRUE(mesh.nodeSets.at("point-8").empty());
  ASSERT_EQ(notes.size(), 3u);
  EXPECT_NE(notes[1].find("node 1"), std::string::npos);
  EXPECT_NE(notes[2].find("turned round"), std::string::npos);
  EXPECT_EQ(readMesh(folder / "m.msh").nodeCount(), 5u);
}

TEST(MeshIo, MirroredHexahedraAreTurnedRound) {
  Mesh mesh = generateBar({.cells = {2, 2, 1}, .element = "hex8", .jitter = 0.2});
  mesh.X.row(0) *= -1;
  std::vector<std::string> notes;
  requireSound(mesh, "m", &notes);
  EXPECT_EQ(notes.size(), 1u);
  EXPECT_NEAR(meshVolume(mesh), 1.0, 1e-14);
}

/// Numbers as %12.5E writes them, with so many digits in the exponent at least: C on Windows has three.
std::string frdNumber(double value, int digits, bool letter = true) {
  char text[40];
  std::snprintf(text, sizeof text, "%.5E", value);
  std::string number = text;
  const std::size_t sign = number.find('E') + 1;
  while (number.size() - sign - 1 < static_cast<std::size_t>(digits)) number.insert(sign + 1, "0");
  if (!letter) number.erase(sign - 1, 1);
  return std::string(number.size() < 12 ? 12 - number.size() : 0, ' ') + number;
}

TEST(MeshIo, FrdNumbersOfAnyExponentAndWidthAreReadOrRefused) {
  const TemporaryFolder folder;
  const auto write = [&](const std::vector<std::string>& numbers) {
    std::string text = "    1C\n    2C" + std::string(28, ' ') + "4" + std::string(37, ' ') + "1\n";
    for (std::size_t i = 0; i < 4; ++i)
      text += " -1         " + std::to_string(i + 1) + numbers[3 * i] + numbers[3 * i + 1] + numbers[3 * i + 2] + "\n";
    text += " -3\n    3C" + std::string(28, ' ') + "1" + std::string(37, ' ') +
            "1\n -1         1    3    0    1\n -2         1         2         3         4\n -3\n 9999\n";
    writeBytes(folder / "m.frd", text);
  };
  const std::vector<double> values{-0.25,  -1.25e-2, 3e-100, 12.5,   -2.5e-3, 0,
                                   1e-300, 7.5e10,   -4e-11, -1e-12, -0.001,  -1.5e100};
  for (const int digits : {2, 3}) {
    for (const bool letter : {true, false}) {
      std::vector<std::string> numbers;
      for (const double value : values) numbers.push_back(frdNumber(value, digits, letter || std::abs(value) > 1e-99));
      write(numbers);
      const Mesh mesh = readMesh(folder / "m.frd");
      for (Eigen::Index i = 0; i < 12; ++i)
        EXPECT_DOUBLE_EQ(mesh.X.data()[i], values[static_cast<std::size_t>(i)]) << digits << " digits, number " << i;
    }
  }
  std::vector<std::string> numbers;
  for (const double value : values) numbers.push_back(frdNumber(value, 2));
  // Overflow of a Fortran field; another program's numbers without blanks; a number cut short; one too many.
  for (const char* bad : {"************", "12.5E+0013.5E+00", " 1.00000E+0", " 1.00000E+00 1.00000E+00"}) {
    std::vector<std::string> with = numbers;
    with[4] = bad;
    write(with);
    EXPECT_NE(errorOf([&] { readMesh(folder / "m.frd"); }).find("m.frd:4: "), std::string::npos) << bad;
  }
}

/// Wedges on both halves of a unit cube, in the order of vtkWedge, whose first triangle faces outward, or of gmsh.
std::string vtkWedges(bool first, bool second) {
  return std::string(
             "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 float\n"
             "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\nCELLS 2 14\n") +
         (first ? "6 0 2 1 4 6 5\n" : "6 0 1 2 4 5 6\n") + (second ? "6 0 3 2 4 7 6\n" : "6 0 2 3 4 6 7\n") +
         "CELL_TYPES 2\n13\n13\n";
}

TEST(MeshIo, WedgesInVtksOrderNeedNoNoteAndThoseInGmshsAreTurnedRound) {
  const TemporaryFolder folder;
  for (const bool first : {true, false})
    for (const bool second : {true, false}) {
      writeBytes(folder / "m.vtk", vtkWedges(first, second));
      std::vector<std::string> notes, checked;
      EXPECT_DOUBLE_EQ(meshVolume(loadMesh(folder / "m.vtk", &notes)), 1.0);
      EXPECT_EQ(notes.size(), first && second ? 0u : 1u);
      EXPECT_TRUE(checkMeshFile(folder / "m.vtk", &checked).empty());
      EXPECT_EQ(checked, notes);
    }
}

TEST(MeshIo, CollapsedHexahedraAreReadAsWhatIsLeft) {
  const TemporaryFolder folder;
  const ElementInfo& hex = *findElementByName("hex8");
  const auto read = [&](const std::vector<int>& nodes, std::vector<std::string>& notes) {
    std::string text =
        "*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n5,0,0,1\n6,1,0,1\n7,1,1,1\n8,0,1,1\n*ELEMENT, TYPE=C3D8, "
        "ELSET=all\n7";
    for (const int node : nodes) text += ", " + std::to_string(node + 1);
    writeBytes(folder / "m.inp", text + "\n");
    return loadMesh(folder / "m.inp", &notes);
  };
  const auto expect = [&](const std::vector<int>& nodes, const char* element, double volume) {
    std::vector<std::string> notes;
    const Mesh mesh = read(nodes, notes);
    ASSERT_EQ(mesh.blocks.size(), 1u);
    EXPECT_EQ(elementInfo(mesh.blocks[0].type).name, element);
    EXPECT_NEAR(meshVolume(mesh), volume, 1e-15);
    EXPECT_EQ(mesh.blocks[0].ids, std::vector<std::int64_t>{7});
    EXPECT_EQ(mesh.elementSets.at("all").size(), 1u);
    std::string all;
    for (const std::string& note : notes) all += note + "\n";
    EXPECT_NE(all.find(std::string("1 hex8 that hold a node several times are read as the ") + element),
              std::string::npos)
        << all;
    EXPECT_EQ(all.find("turned round"), std::string::npos) << all;
  };
  for (const auto& face : hex.faces) {
    for (int way = 0; way < 2; ++way) {  // two opposite edges of a face shrink to nodes
      std::vector<int> nodes{0, 1, 2, 3, 4, 5, 6, 7};
      nodes[face[1 + way]] = face[way];
      nodes[face[(2 + way) % 4]] = face[(3 + way) % 4];
      expect(nodes, "wedge6", 0.5);
    }
    std::vector<int> nodes{0, 1, 2, 3, 4, 5, 6, 7};
    for (const int corner : face) nodes[corner] = face[0];
    expect(nodes, "pyramid5", 1.0 / 3);
    for (std::size_t k = 0; k < 8; ++k) {  // and an edge of the opposite face that the node is not above
      std::vector<int> tet = nodes;
      for (const auto& edge : hex.edges)
        if (edge[0] == static_cast<int>(k) && nodes[edge[0]] == edge[0] && nodes[edge[1]] == edge[1] &&
            edge[0] != face[0] && edge[1] != face[0]) {
          tet[edge[1]] = edge[0];
          expect(tet, "tet4", 1.0 / 6);
          break;
        }
    }
  }
  std::vector<std::string> notes;
  EXPECT_NE(errorOf([&] { read({0, 1, 2, 3, 0, 1, 2, 3}, notes); }).find("more than once"), std::string::npos);
  EXPECT_NE(errorOf([&] { read({0, 1, 2, 3, 4, 5, 6, 4}, notes); }).find("more than once"), std::string::npos);
  // As LS-DYNA has a tetrahedron, of which this shape fills one half.
  EXPECT_NE(errorOf([&] { read({0, 1, 2, 4, 4, 4, 4, 4}, notes); }).find("more than once"), std::string::npos);
}

/// The volume of a hexahedron by its own shape functions: two Gauss points each way are exact.
double volumeOfHexahedron(const std::array<Eigen::Vector3d, 8>& X) {
  const ElementInfo& hex = *findElementByName("hex8");
  double volume = 0;
  for (int point = 0; point < 8; ++point) {
    Eigen::Vector3d at;
    for (int k = 0; k < 3; ++k) at[k] = ((point >> k & 1) != 0 ? 1 : -1) / std::sqrt(3.0);
    Eigen::Matrix3d J = Eigen::Matrix3d::Zero();
    for (std::size_t a = 0; a < 8; ++a) {
      const Eigen::Vector3d corner(hex.referenceNodes[a].data());
      const Eigen::Vector3d one = (1 + (corner.array() * at.array())) / 2;
      J +=
          X[a] *
          (corner.array() / 2 * Eigen::Array3d(one[1] * one[2], one[0] * one[2], one[0] * one[1])).matrix().transpose();
    }
    volume += J.determinant();
  }
  return volume;
}

TEST(MeshIo, WhatIsLeftOfAHexahedronFillsItsSpaceWhicheverCornersAreOne) {
  const TemporaryFolder folder;
  std::array<Eigen::Vector3d, 8> X;
  std::string text = "*NODE\n";
  for (int a = 0; a < 8; ++a) {  // no face is flat
    const auto& corner = findElementByName("hex8")->referenceNodes[static_cast<std::size_t>(a)];
    for (int k = 0; k < 3; ++k) X[a][k] = corner[static_cast<std::size_t>(k)] + ((7 * a + 3 * k) % 5) / 16.0;
    text += std::to_string(a + 1);
    for (int k = 0; k < 3; ++k) text += ", " + std::to_string(X[a][k]);  // sixteenths need four digits
    text += "\n";
  }
  text += "*ELEMENT, TYPE=C3D8\n";
  std::vector<double> volumes;
  std::array<int, 8> nodes{};  // of each corner the first one that is the same
  const auto identify = [&](const auto& self, int corner) -> void {
    if (corner == 8) {
      std::array<Eigen::Vector3d, 8> own;
      text += std::to_string(volumes.size() + 1);
      for (int a = 0; a < 8; ++a) {
        own[a] = X[nodes[a]];
        text += ", " + std::to_string(nodes[a] + 1);
      }
      text += "\n";
      volumes.push_back(volumeOfHexahedron(own));
      return;
    }
    for (int same = 0; same <= corner; ++same) {
      if (same < corner && nodes[same] != same) continue;
      nodes[corner] = same;
      self(self, corner + 1);
    }
  };
  identify(identify, 0);
  ASSERT_EQ(volumes.size(), 4140u);  // ways to part eight corners
  writeBytes(folder / "m.inp", text);
  const Mesh mesh = readMesh(folder / "m.inp");
  std::map<std::string_view, int> counts;
  for (const MeshBlock& block : mesh.blocks)
    for (std::size_t e = 0; e < block.elementCount(); ++e) {
      const std::string_view name = elementInfo(block.type).name;
      ++counts[name];
      if (name == "hex8") continue;
      Mesh one;
      one.X = mesh.X;
      const auto width = block.nodesPerElement();
      one.blocks.push_back({block.type, {block.element(e), block.element(e) + width}, {}});
      EXPECT_NEAR(meshVolume(one), volumes[static_cast<std::size_t>(block.ids[e] - 1)], 1e-12) << name << block.ids[e];
    }
  // Two edges of a face for a wedge, a face for a pyramid, and a face with an edge across it for a tetrahedron.
  EXPECT_EQ(counts["wedge6"], 12);
  EXPECT_GE(counts["pyramid5"], 6);
  EXPECT_GE(counts["tet4"], 24);
}

TEST(MeshIo, VoxelsAreHexahedra) {
  const TemporaryFolder folder;
  writeBytes(
      folder / "m.vtk",
      "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 float\n0 0 0\n2 0 0\n0 3 0\n2 3 "
      "0\n0 0 4\n2 0 4\n0 3 4\n2 3 4\nCELLS 1 9\n8 0 1 2 3 4 5 6 7\nCELL_TYPES 1\n11\n");
  std::vector<std::string> notes;
  EXPECT_DOUBLE_EQ(meshVolume(loadMesh(folder / "m.vtk", &notes)), 24.0);
  EXPECT_TRUE(notes.empty());
}

TEST(MeshIo, SectionsThatGmshWritesWithItsOptionsAreRead) {
  const TemporaryFolder folder;
  const std::string elements = "$Elements\n1\n9 4 2 1 1 1 2 3 4\n$EndElements\n";
  // Mesh.SaveParametric; a comment first.
  writeBytes(folder / "p.msh",
             "$Comments\nby hand\n$EndComments\n$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$ParametricNodes\n4\n1 0 0 0 0 "
             "1\n2 1 0 0 1 1 0.5\n3 0 1 0 2 1 0.25 0.75\n4 0 0 1 3 1\n$EndParametricNodes\n" +
                 elements);
  EXPECT_NEAR(meshVolume(loadMesh(folder / "p.msh")), 1.0 / 6, 1e-15);
  // An element of two physical groups stands twice in version 2.
  writeBytes(
      folder / "g.msh",
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n3 1 \"a\"\n3 2 \"b\"\n$EndPhysicalNames\n$Nodes\n5\n1 "
      "0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 1\n$EndNodes\n$Elements\n3\n1 4 2 1 1 1 2 3 4\n2 4 2 2 1 1 2 3 "
      "4\n3 4 2 2 1 2 3 4 5\n$EndElements\n");
  std::vector<std::string> notes;
  const Mesh both = loadMesh(folder / "g.msh", &notes);
  EXPECT_EQ(both.blocks[0].ids, (std::vector<std::int64_t>{1, 3}));
  EXPECT_EQ(both.elementSets.at("a"), (std::vector<ElementRef>{{0, 0}}));
  EXPECT_EQ(both.elementSets.at("b"), (std::vector<ElementRef>{{0, 0}, {0, 1}}));
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("1 elements that stand once more for another group"), std::string::npos);
  // Parts of a partitioned volume have the groups, and faces between them have none; several numbers of nodes stand in
  // a line.
  writeBytes(
      folder / "q.msh",
      "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 1 \"left\"\n3 1 \"body\"\n$EndPhysicalNames\n"
      "$Entities\n0 0 0 1\n1 0 0 0 1 1 1 1 1 0\n$EndEntities\n$PartitionedEntities\n2\n1\n9 1\n0 0 1 1\n5 3 1 2 1 2 0 "
      "0 0 "
      "1 1 1 1 1 0\n2 3 1 2 1 2 0 0 0 1 1 1 1 1 0\n$EndPartitionedEntities\n$Nodes\n1 4 1 4\n3 2 0 4\n1 2\n3 4\n0 0 0\n"
      "1 0 0\n0 1 0\n0 0 1\n$EndNodes\n$Elements\n2 2 1 2\n2 5 2 1\n2 1 2 3\n3 2 4 1\n1 1 2 3 4\n$EndElements\n");
  const Mesh parts = loadMesh(folder / "q.msh");
  EXPECT_EQ(parts.elementSets.at("body").size(), 1u);
  EXPECT_TRUE(parts.nodeSets.empty());
}

TEST(MeshIo, FormatsThatAreNotReadAreNamed) {
  const TemporaryFolder folder;
  const std::pair<const char*, const char*> files[] = {
      {"#RADIOSS STARTER\n/BEGIN\n", "a Radioss deck"},
      {"(0 \"a mesh\")\n(2 3)\n", "a Fluent mesh"},
      {"MESH dimension 3 ElemType Tetrahedra Nnode 4\n", "a GiD mesh"},
      {"<?xml version=\"1.0\"?>\n<!DOCTYPE Xdmf SYSTEM \"Xdmf.dtd\" []>\n<Xdmf/>\n", "an XDMF file"},
      {"MeshVersionFormatted 2\n", "a Medit mesh"},
      {"    -1\n  2411\n", "a universal file (UNV)"},
      {"BEGIN BULK\nGRID,1,,0.,0.,0.\n", "a Nastran deck"},
      {"\x89HDF\r\n\x1a\n", "an HDF5 file"},
      {"version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 1\n", "a pointer of Git LFS"},
      {"PK\x03\x04", "a packed file"},
      {"TITLE = \"a mesh\"\nVARIABLES = \"X\"\n", "a Tecplot file"},
      {"#!TDV112", "a Tecplot file"},
      {"<?xml version=\"1.0\"?>\n<!-- <VTKFile> -->\n<robot name=\"r\"/>\n", "a robot in URDF"},
      {"<sdf version=\"1.6\"/>\n", "a world of Gazebo"},
  };
  for (const auto& [text, name] : files)
    for (const char* file : {"m.msh", "m.vtu", "m.inp", "m.vtk", "m.frd", "m.k"}) {
      writeBytes(folder / file, text);
      const std::string refused = errorOf([&] { readMesh(folder / file); });
      EXPECT_NE(refused.find(std::string("this is ") + name), std::string::npos) << refused;
    }
  // What HDF5 and a geometry of gmsh hold is told by the name.
  for (const auto& [name, text, said] : {std::tuple{"m.cgns", "\x89HDF\r\n\x1a\n", "a CGNS file"},
                                         {"m.h5m", "\x89HDF\r\n\x1a\n", "a mesh of MOAB"},
                                         {"m.geo", "a = 2;\nBox(1) = {0, 0, 0, a, 1, 1};\n",
                                          "a geometry of gmsh, which is not read; gmsh makes a mesh of it"}}) {
    writeBytes(folder / name, text);
    const std::string refused = errorOf([&, file = folder / name] { readMesh(file); });
    EXPECT_NE(refused.find(std::string("this is ") + said), std::string::npos) << refused;
  }
  writeBytes(folder / "flat.vtk",
             "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 float\n0 0 0\n1 0 0\n0 1 "
             "0\nCELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n5\n");
  EXPECT_NE(errorOf([&] { readMesh(folder / "flat.vtk"); }).find("only 1 of surfaces, lines or points"),
            std::string::npos);
}

TEST(MeshIo, LegacyVtkText) {
  const TemporaryFolder folder;
  writeBytes(folder / "m.vtk",
             "# vtk DataFile Version 2.0\ntitle\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n0 0 0\n1 0 0\n0 2 "
             "0\n0 0 3\n"
             "\nCELLS 2 9\n3 0 2 1\n4 0 1 2 3\n\nCELL_TYPES 2\n5\n10\n");
  std::vector<std::string> notes;
  const Mesh mesh = loadMesh(folder / "m.vtk", &notes);
  EXPECT_DOUBLE_EQ(meshVolume(mesh), 1.0);
  EXPECT_EQ(mesh.blocks[0].ids, std::vector<std::int64_t>{1});
  EXPECT_EQ(notes.size(), 1u);
}

TEST(MeshIo, LegacyVtkVersion5) {
  const TemporaryFolder folder;
  writeBytes(
      folder / "m.vtk",
      "# vtk DataFile Version 5.1\n\nASCII\nDATASET UNSTRUCTURED_GRID\nFIELD FieldData 1\nTimeValue 1 1 double\n0.5\n"
      "POINTS 4 float\n0 0 0 1 0 0 0 2 0\n0 0 3\nMETADATA\nINFORMATION 0\n\nCELLS 3 7\nOFFSETS vtktypeint64\n0 3 7\n"
      "CONNECTIVITY vtktypeint64\n0 2 1 0 1 2 3\nCELL_TYPES 2\n5 10\nCELL_DATA 2\nSCALARS a int\n1 2\n");
  EXPECT_DOUBLE_EQ(meshVolume(loadMesh(folder / "m.vtk")), 1.0);
}

}  // namespace
}  // namespace ringwatch
